"""Exact derivatives of a motion's outputs by every number of its scene.

The program differentiates itself, one direction in each lane; `slipcircle.derivatives.tangents` says how they jump
at events, `slipcircle.derivatives.input_derivatives` where they begin. Here they are put together.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.problem.lanes import Lanes, integrate_all
from slipcircle.core.problem.problem import Problem
from slipcircle.core.program.program import Log, Program, Samples
from slipcircle.core.scene.coordinates import arc_numbers
from slipcircle.core.scene.piecewise import Data
from slipcircle.core.scene.scene import Scene
from slipcircle.core.walk.integrate import Integrator
from slipcircle.derivatives.derivatives import Sensitivity
from slipcircle.derivatives.input_derivatives import InputDerivatives
from slipcircle.derivatives.parameters import parameters
from slipcircle.derivatives.tangents import Tangents
from slipcircle.derivatives.transport import active_parameters, through_vertex
from slipcircle.ground.section import Section
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.soils import share_one_law

OUTPUTS: Mapping[str, str] = {"peak_velocity": "m/s", "run_out": "m", "duration": "s", "reach": "m"}
STIFF_STEPS = (1000.0, 1.0)  # steps that a step held short by what decays at once counts for: few first, then all
ARC = ("theta_1", "theta_2", "radius", "unit_weight", "gravity")


def sensitivity(scene: Scene, lanes: Lanes, outputs: Mapping[str, float]) -> Sensitivity:
    """Derivatives of a single motion's outputs by every number of its scene.

    Notes
    -----
    Angles are left out where the arc's coefficients are given instead of computed, and the initial velocity where the
    mass starts from rest. Of a mass that nothing brings to rest they are those of its first standstill. Of a section
    they are by every coordinate that the motion depends on: of its ground those of the edges over the mass.
    """
    arc = scene.arc
    if isinstance(arc, LayeredSection):  # with what is 0 and would not be, had its numbers other values
        complete = arc.effects_with_own(lanes.called, complete=True)
        lanes = replace(lanes, called=complete)
        integrate_all(lanes.problem)  # as far as its tables are needed
    known = parameters(scene)
    units = dict[str, str]()
    at = dict(outputs)
    for name in _parameters(scene):
        units[name] = known[name].unit
        at[name] = float(np.asarray(scene.numbers[name]))
    warnings = list[str]()
    if any(outputs.values()):
        values = _derivatives(lanes, list(units))
    else:
        values = np.zeros((len(OUTPUTS), len(units)))
        warnings.append("does not move, so that small changes have no effect")
    if isinstance(arc, Section) and through_vertex(arc):
        warnings.append(
            "the circle passes through a vertex of the ground: derivatives by its coordinates and the circle's "
            "are those towards the side on which it lies outside the mass"
        )
    return Sensitivity(OUTPUTS, units, at, values, scene, tuple(warnings))


def _parameters(scene: Scene) -> list[str]:
    """The names of the free parameters."""
    arc = scene.arc
    if isinstance(arc, LayeredSection):
        of_soils = _numbers_of_soils(arc)
        of_arc: Sequence[str] = (*active_parameters(arc), *of_soils)
    elif isinstance(arc, Section):
        of_arc = active_parameters(arc)
    elif arc.given is None:
        of_arc = ARC
    else:
        of_arc = ARC[2:]
    numbers = scene.numbers
    fixed = set(arc_numbers(arc)).difference(of_arc)
    for name, value in numbers.items():
        matters_if_present = name == "initial_velocity" or name.startswith("shaking.")
        if matters_if_present and not float(np.asarray(value)):
            fixed.add(name)
    names = dict.fromkeys(("friction", *of_arc, *numbers))
    return [name for name in names if name in numbers and name not in fixed]


def _numbers_of_soils(section: LayeredSection) -> list[str]:
    """Those by which there are derivatives: of a length that all soils share once, and of what is given at all."""
    with_law = [soil.name for soil in section.soils if isinstance(soil.friction, Mapping)]
    share_length = share_one_law(section.soils)
    depends_on_depth = set[str]()
    for soil, datum in zip(section.soils, section.datums, strict=True):
        if datum is not None:
            depends_on_depth.add(soil.name)
    names = list[str]()
    for path, value in section.other_numbers().items():
        start, _, number = path.rpartition(".")
        name = start.removeprefix("soils.").removesuffix(".friction")
        match number:
            case "length":
                free = not share_length or name == with_law[0]
            case "cohesion_gradient":
                free = name in depends_on_depth
            case "pore_ratio":
                free = bool(value)
            case _:
                free = True
        if free:
            names.append(path)
    return names


def _derivatives(lanes: Lanes, names: Sequence[str]) -> Floats:
    """Derivatives of peak velocity, run-out, duration and reach (rows) by each parameter, SI units."""
    inputs = InputDerivatives(lanes, names)
    problem = _with_directions(lanes.problem, inputs)
    for stiff_step in STIFF_STEPS:
        run = _Run(problem, inputs, stiff_step)
        if run.is_smooth:
            return _in_si(lanes, inputs, run)
    raise ValueError("sensitivity: this motion is too stiff for derivatives; compare motions with other values")


def _with_directions(problem: Problem, inputs: InputDerivatives) -> Problem:
    """The problem of one lane as one of many, each of which carries the derivatives by one parameter."""
    problem = problem.with_outputs(directions=1)
    directions = len(inputs.names)
    cells = np.repeat(problem.cells, directions, axis=1)
    places = problem.program.places
    (tangent,) = problem.program.tangents
    for name, dot in inputs.inputs.items():
        tangent_cell = tangent.cells.get(places.get(name, -1))
        if tangent_cell is not None:
            cells[tangent_cell] = dot
    sign = np.sign(cells[ix.OMEGA])
    cells[tangent.cells[ix.OMEGA]] = inputs.omega * sign  # of |omega|
    return problem._replace(cells=cells)


class _Run:
    """A motion with its derivatives, integrated to its end.

    ``implicit_from`` is the time at which implicit steps took over: infinite where they did not, and 0 where something
    that changes with time still broke afterwards.
    """

    def __init__(self, problem: Problem, inputs: InputDerivatives, stiff_step: float) -> None:
        self.inputs = inputs
        self.stiff_step = stiff_step
        self.implicit_from = np.inf
        self.later_events = list[Any]()
        integrate_all(problem, log=self.later_events, integrator=self._integrate)

    def _integrate(
        self, program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None, log: Log | None
    ) -> None:
        """Explicitly, as far as that goes."""
        state = Integrator(program, tables, cells)
        self.tangents = Tangents(state, self.inputs.growth)
        state.tangents = self.tangents
        self.state = state
        state.stiff_step = self.stiff_step
        with np.errstate(all="ignore"):
            while state.status[0] <= ix.RESTING:
                state.round()
        if state.status[0] == ix.TOO_LONG:
            breaks_later = np.isfinite(state.next_break()[0])
            self.implicit_from = 0.0 if breaks_later else float(state.time[0])

    @property
    def is_smooth(self) -> bool:
        """Whether derivatives hold: implicit steps know no jumps of them, and may go on to the end time, not more."""
        if np.isinf(self.implicit_from):
            return True
        ended = self.state.status[0] == ix.ENDED
        peak_is_explicit = self.state.peak_time[0] <= self.implicit_from
        return bool(ended and peak_is_explicit and not self.later_events)


def _in_si(lanes: Lanes, inputs: InputDerivatives, run: _Run) -> Floats:
    """Derivatives of outputs: of dimensionless ones, and of the units that they are multiplied by."""
    state = run.state
    tangents = run.tangents
    growth = inputs.growth
    unit_of_time = float(lanes.time_scale)
    radius = float(np.asarray(lanes.arc.radius))
    peak = state.peak_omega[0]
    end = state.end_rotation[0]
    reach = state.reach_rotation[0]
    signed_peak_dot = np.sign(peak) * tangents.peak_dot
    peak_dot = signed_peak_dot + peak * inputs.speed_growth
    rotation_dot = tangents.present_rotation_dot()
    run_out_dot = rotation_dot + end * inputs.radius_growth
    if reach == end:  # also where implicit steps, which keep no derivative of the reach, went on to the end
        reach_dot = run_out_dot
    else:
        reach_dot = tangents.reach_dot + reach * inputs.radius_growth
    if state.status[0] == ix.ENDED:
        duration_dot = inputs.one("end_time")
    else:
        rest = state.rest_since[0]
        rest_dot = tangents.rest_dot + rest * growth.time
        duration_dot = unit_of_time * rest_dot
    unit_of_velocity = radius / unit_of_time
    rows = [unit_of_velocity * peak_dot, radius * run_out_dot, duration_dot, radius * reach_dot]
    return np.array(rows)
