"""Lanes of scenes that share their effects and laws: integrated to their end, and evaluated on the way."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import choose, plain
from slipcircle.core.flow.compiled import engine
from slipcircle.core.flow.equilibrium import Forces, equilibrium
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.problem import Problem, build_problem
from slipcircle.core.flow.program import Log, Samples
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.coordinates import by_lanes
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.scene import Scene
from slipcircle.core.scene.section import Section

Floats = NDArray[np.float64]
# Lanes in a block, so that their numbers stay in the cache; rows a power of two apart would share its lines.
BLOCK = 16000
OUTPUTS = ("pressing", "normal", "mu")  # registers that are evaluated beside the states


def integrate_all(
    problem: Problem, samples: Samples | None = None, log: Log | None = None, integrator: Any = None, cells: Any = None
) -> Floats:
    """Integrate all lanes to their end: their final cells.

    Parameters
    ----------
    problem : Problem
    samples : Samples, optional
        Times at which states are wanted; filled in place.
    log : list, optional
        Takes the events of the first lane.
    integrator : callable, optional
        The integrator, by default the fastest here.
    cells : ndarray, optional
        To start with and to overwrite; by default a copy of the problem's.
    """
    integrator = integrator or engine().integrate
    while True:
        state = problem.initial_cells() if cells is None else cells
        integrator(problem.program, problem.tables, state, samples, log)
        if cells is None and problem.extend_rotations(state[ix.REACH_ROTATION]):
            if log is not None:
                log.clear()
            continue
        if state[ix.STATUS].max(initial=0.0) < ix.TOO_LONG:
            return state
        _integrate_stiff(problem, state, samples, log)
        waiting = np.flatnonzero(state[ix.STATUS] == ix.NEED)
        if not waiting.size:
            return state
        # One lane goes on to find how far a Python function is needed; then all start again with the whole table.
        _extend_to_end(problem, state, waiting[:1])
        cells = None
        if log is not None:
            log.clear()


def _integrate_stiff(problem: Problem, cells: Floats, samples: Samples | None, log: Log | None) -> None:
    """Integrate lanes that took too many explicit steps and still move by implicit ones."""
    stopped = (cells[ix.STATUS] == ix.TOO_LONG) & (cells[ix.STEPS] > ix.MOST_STEPS)
    which = np.flatnonzero(stopped & (cells[ix.OMEGA] > 0.0))
    while which.size:
        from slipcircle.core.flow import implicit  # most scenes never load it

        implicit.integrate(problem, cells, samples, log, which)
        which = which[cells[ix.STATUS, which] == ix.NEED]
        if which.size:
            problem.extend_tables(cells[:, which])


def _extend_to_end(problem: Problem, cells: Floats, which: Any) -> None:
    """Extend the tables of Python functions as far as one lane needs them up to its end."""
    one = cells[:, which]
    while one[ix.STATUS, 0] == ix.NEED:
        problem.extend_tables(one)
        one[ix.OMEGA] *= one[ix.DIRECTION]
        one[ix.STATUS] = ix.START
        tables = [table.lanes(which) for table in problem.tables]
        engine().integrate(problem.program, tables, one)


class _States(NamedTuple):
    """States of lanes, dimensionless: time, rotation, omega, slip, further states, and the lane of each."""

    time: Any
    rotation: Any
    omega: Any
    further: Any = None
    lane: Any = slice(None)


@dataclass(frozen=True)
class Lanes:
    """Fields of scenes as numbers or as arrays with one value for each lane, and what all lanes share.

    Attributes
    ----------
    arc : Arc or Section
        May be unchecked: what is no arc is invalid.
    called : mapping
        Effects by name, each with its parameters.
    friction : float, ndarray, mapping or callable
    velocity, end_time : float or ndarray
        m/s, and s or infinity.
    accuracy : float
    count : int
        How many there are.
    invalid : ndarray of bool
        Which are no scenes.
    """

    arc: Arc | Section
    called: Mapping[str, Mapping[str, Any]]
    friction: Any
    velocity: Any
    end_time: Any
    accuracy: float
    count: int
    invalid: Any = False

    def taken(self, which: Any) -> "Lanes":
        """Some of the lanes, by an index."""

        def select(value: Any, axes: int = 0) -> Any:
            if isinstance(value, Mapping):
                return {name: select(part) for name, part in value.items()}
            by_lane = isinstance(value, np.ndarray) and value.ndim == axes + 1 and len(value) == self.count
            return value[which] if by_lane else value

        selected = {f.name: select(getattr(self, f.name)) for f in fields(Lanes)}
        selected["arc"] = by_lanes(self.arc, select)
        selected["called"] = selected["arc"].section_effects(selected["called"])
        selected["count"] = np.arange(self.count)[which].size
        return Lanes(**selected)

    def parts(self) -> Iterator[tuple[slice, "Lanes"]]:
        """The lanes in blocks."""
        for first in range(0, self.count, BLOCK):
            which = slice(first, first + BLOCK)
            yield which, self.taken(which)

    @cached_property
    def problem(self) -> Problem:
        """The problem that is solved and evaluated."""
        return self._build()

    def _build(self) -> Problem:
        numbers = (self.arc, self.called, self.friction, self.velocity, self.end_time)
        problem = build_problem(*numbers, self.accuracy, self.count)
        if self.invalid is not False:
            invalid = np.broadcast_to(self.invalid, self.count)
            problem.cells[ix.STATUS, invalid] = ix.FAILED
        return problem

    # --- units ---------------------------------------------------------------------------------------------------

    @cached_property
    def time_scale(self) -> Any:
        """s for one of the dimensionless time."""
        return plain(self.arc.time_scale)

    @cached_property
    def radius(self) -> Any:
        """m."""
        return plain(self.arc.radius)

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        return plain(self.arc.reference_stress / self.arc.moment_coefficients.resistance_factor)

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.arc
        weight = np.multiply(arc.width, arc.mean_unit_weight) * np.power(arc.radius, 3.0)
        return weight * arc.dimensionless.moment_of_inertia

    # --- the motion ----------------------------------------------------------------------------------------------

    def solve(self, log: Log | None = None) -> Floats:
        """The final cells of all lanes."""
        if self.count == 1:
            return integrate_all(self.problem, log=log)
        problem = self._build()  # copies of many lanes would cost as much as the integration
        final = integrate_all(problem, log=log, cells=None if problem.functions else problem.cells)
        if not problem.extend_rotations(final[ix.REACH_ROTATION]):
            return final
        farther = self._build()._replace(tables=problem.tables)
        return integrate_all(farther, log=log)

    def read(self, times: Floats) -> Floats:
        """Rotation, omega, its rate, slip and further states at times in s, (rows, times, lanes)."""
        return self._sampled(self.problem, times)

    def _sampled(self, problem: Problem, times: Floats) -> Floats:
        """As `read`, by any problem of these lanes."""
        increasing = np.argsort(times, kind="stable")
        units = np.broadcast_to(problem.time_scale, (1, self.count))
        dimensionless = times[increasing][:, None] / units
        rows = np.zeros((2 + len(problem.program.states), times.size, self.count))
        samples = Samples(np.ascontiguousarray(dimensionless), rows)
        integrate_all(problem, samples)
        states = np.empty_like(rows)
        states[:, increasing] = rows
        return states

    def energies(self, times: Floats) -> tuple[dict[str, Floats], Floats]:
        """Kinetic energy, work and dissipation at times in s, (times, lanes), and the first kinetic energy."""
        problem = self.problem.with_outputs(("energy",))
        states, rows = np.split(self._sampled(problem, times), [4])
        further = [problem.program.cells[cell] for cell, _, _ in problem.program.states[2:]]
        energies = {
            "kinetic": states[1] ** 2 / 2,
            "work": rows[further.index("work")],
            "dissipation": np.maximum(rows[further.index("dissipation")], 0.0),
        }
        first_kinetic = problem.cells[ix.OMEGA] ** 2 / 2
        return energies, first_kinetic

    # --- forces in given states ----------------------------------------------------------------------------------

    def stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """The mean normal stress, Pa, of each lane in one state; dimensionless numbers."""
        if self.count > BLOCK:
            parts = [part.stress(time[which], rotation[which], omega[which]) for which, part in self.parts()]
            return np.concatenate(parts)
        outputs = self._outputs_in(_States(time, rotation, omega))
        return outputs["pressing"] * self.stress_unit

    def outputs(self, times: Floats, rows: Floats) -> dict[str, Floats]:
        """Total and effective normal force and friction at times in s, of states as `read` returns them."""
        outputs = self._outputs_in(self._states(times, rows))
        return {name: values.reshape(rows.shape[1:]).T for name, values in outputs.items()}

    def holding_friction(self, times: Floats, rows: Floats) -> Floats:
        """Friction coefficient required for equilibrium of the mass in its position at times in s, (lanes, times).

        The greater one of both ways, where both are open to it; NaN where nothing presses.
        """
        at_rest = self._states(times, rows)._replace(omega=0.0)
        down_slope = self._holding(at_rest, 1.0)
        up_slope = self._holding(at_rest, -1.0)
        greatest = np.fmax(down_slope, up_slope)
        return greatest.reshape(rows.shape[1:]).T

    def _holding(self, at_rest: _States, side: float) -> Floats:
        """Friction required in one direction; NaN without contact, or where a mass cannot start."""
        problem = self._with_outputs
        cells, _ = self._begin(at_rest, side)
        forces = Forces.of(problem.program, cells)
        free = LaneState(problem.program, problem.tables, cells).may_start()
        with np.errstate(all="ignore"):
            friction = (forces.driving - forces.resisting) / forces.normal
        known = (forces.normal > 0.0) & free
        return np.where(known, np.maximum(friction, 0.0), np.nan)

    @cached_property
    def _with_outputs(self) -> Problem:
        return self.problem.with_outputs(OUTPUTS)

    def _states(self, times: Floats, rows: Floats) -> _States:
        """States at times in s, as `read` gives them, as lanes of their own."""
        lane = np.tile(np.arange(self.count), times.size)
        units = np.broadcast_to(self.time_scale, self.count)
        time = times[:, None] / units
        rotation, omega, _, *further = rows.reshape(len(rows), -1)
        return _States(time.ravel(), rotation, omega, further, lane)

    def _outputs_in(self, states: _States) -> dict[str, Floats]:
        """Registers of `OUTPUTS` in some states."""
        direction = choose(states.omega < 0.0, -1.0, 1.0)
        _, registers = self._begin(states, direction)
        roles = self._with_outputs.program.roles
        return {name: registers[roles[name]] for name in OUTPUTS}

    def _begin(self, states: _States, side: Any) -> tuple[Floats, Floats]:
        """Cells and registers of phases that begin in some states, in a direction of travel."""
        problem = self._with_outputs
        cells = problem.cells[:, states.lane].copy()
        cells[ix.TIME] = states.time
        cells[ix.ROTATION] = states.rotation
        cells[ix.OMEGA] = abs(states.omega)
        cells[ix.DIRECTION] = side
        cells[ix.LIFTED] = 0.0
        if states.further is not None:
            slip, *others = states.further
            cells[ix.SLIP] = slip
            problem.extend_rotations(cells[ix.ROTATION])
            problem.extend_tables(cells)
            for (cell, _, _), value in zip(problem.program.states[2:], others, strict=True):
                cells[cell] = value
        tables = [table.lanes(states.lane) for table in problem.tables]
        return cells, engine().begin_phase(problem.program, tables, cells)

    # --- at the start --------------------------------------------------------------------------------------------

    @property
    def brake(self) -> Floats:
        """q = 2 (lambda A mu + d)/Theta* at the start: twice the decrease of the rate per unit of omega^2."""
        problem = self.problem
        roles = problem.program.roles
        cells = problem.cells.copy()
        cells[ix.DIRECTION] = 1.0
        engine().begin_phase(problem.program, problem.tables, cells)
        cells[roles["cell_drive"]] = 0.0
        cells[ix.OMEGA] = 1.0
        registers = engine().registers(problem.program, problem.tables, cells)
        return np.asarray(-2.0 * registers[roles["net"]])

    @cached_property
    def statics(self) -> dict[str, Floats]:
        """Limit friction, factor of safety, yield coefficient and friction at the start, without shaking.

        All are read off the program. The excess of drive over resistance is linear in k_h: k_y is where it is zero.
        """
        problem = self.problem.with_steady_shaking()
        program = problem.program
        k_h = program.places["k_h"]
        cells = problem.cells
        pull = cells[program.places["driving_moment"]]
        downhill = np.where(pull < 0.0, -1.0, 1.0)
        cells[ix.OMEGA] = 0.0
        cells[ix.DIRECTION] = downhill
        cells[k_h] = 0.0
        shaken = cells.copy()
        shaken[k_h] = downhill  # a unit of k_h, the way in which gravity drives
        for each in (cells, shaken):
            engine().begin_phase(program, problem.tables, each)
        mu = cells[program.roles["cell_mu"]]
        limit = cells[program.roles["cell_limit"]]
        with np.errstate(all="ignore"):
            return equilibrium(Forces.of(program, cells), Forces.of(program, shaken), mu, limit)


# --- lanes of a scene ------------------------------------------------------------------------------------------------


def lanes_of(scene: Scene, accuracy: float, invalid: Any = False) -> Lanes:
    """The lanes of a scene, all its arrays with one axis."""
    arc = scene.arc
    called = scene.called
    friction: Any = scene.friction
    velocity = scene.initial_velocity
    end_time = np.inf if scene.end_time is None else scene.end_time
    shape = scene.shape
    if not shape:
        return Lanes(arc, called, friction, velocity, end_time, accuracy, 1, invalid)
    arc = by_lanes(arc, lambda value, axes: _flat(value, shape, axes))
    assert isinstance(scene.effects, dict)
    flat_effects = {effect: _flat_numbers(scene, effect, given) for effect, given in scene.effects.items()}
    called = arc.section_effects(flat_effects)
    friction = arc.friction if isinstance(arc, LayeredSection) else _flat_friction(scene)
    count = math.prod(shape)
    return Lanes(arc, called, friction, _flat(velocity, shape), _flat(end_time, shape), accuracy, count, invalid)


def _flat_friction(scene: Scene) -> Any:
    """Friction with one axis of lanes: a number, or a law's parameters."""
    friction: Any = scene.friction
    if callable(friction):
        return friction
    if not isinstance(friction, Mapping):
        return _flat(friction, scene.shape)
    flat = _flat_numbers(scene, "friction", friction)
    rate = flat.get("rate")
    if isinstance(rate, Mapping):
        flat["rate"] = _flat_numbers(scene, "friction.rate", rate)
    return flat


def _flat(value: Any, shape: tuple[int, ...], axes: int = 0) -> Any:
    """An array with one axis of lanes before its other axes; a value that all lanes share is unchanged."""
    if np.ndim(value) <= axes:
        return value
    array = np.asarray(value, np.float64)
    tail = array.shape[array.ndim - axes :]
    if array.shape == (math.prod(shape), *tail):
        return array
    return np.broadcast_to(array, (*shape, *tail)).reshape(-1, *tail)


def _flat_numbers(scene: Scene, path: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of an effect or a law; those among the scene's numbers may be arrays."""
    flat = dict(given)
    for name, value in given.items():
        if f"{path}.{name}" in scene.numbers:
            flat[name] = _flat(value, scene.shape)
    return flat
