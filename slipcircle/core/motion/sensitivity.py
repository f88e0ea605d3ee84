"""Exact derivatives of a motion by the numbers of its scene: the program differentiates itself, the walk its events.

A name with `_dot` holds derivatives, one for each parameter, those of states at a fixed time. At an event g = 0 the
time of the event has t_dot = -g_dot/(dg/dt); what begins there begins with total derivatives, value_dot + rate t_dot,
and goes on at fixed times, less the new rate times t_dot.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.core.flow.bind import Bound
from slipcircle.core.flow.lanes import Lanes, walked
from slipcircle.core.flow.polynomials import shifted, slopes, value
from slipcircle.core.flow.program import Log, Program, Table
from slipcircle.core.flow.tables import Data
from slipcircle.core.flow.walk import Walker
from slipcircle.core.motion.derivatives import Sensitivity
from slipcircle.core.motion.seeds import Seeds
from slipcircle.core.scene.scene import Scene
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.transport import telling, through_vertex
from slipcircle.workbench.files.numbers import by_name, numbers_in

Floats = NDArray[np.float64]

OUTPUTS: Mapping[str, str] = {"peak_velocity": "m/s", "run_out": "m", "duration": "s", "reach": "m"}
ARC = ("theta_1", "theta_2", "radius", "unit_weight", "gravity")


def sensitivity(scene: Scene, lanes: Lanes, outputs: Mapping[str, float]) -> Sensitivity:
    """Derivatives of a single motion's outputs by every number of its scene.

    Notes
    -----
    Angles are left out where the arc's coefficients are given instead of computed, and the initial velocity where the
    mass starts from rest. Of a mass that nothing brings to rest they are those of its first standstill. Of a section
    they are by every coordinate that the motion depends on: of its ground those of the edges over the mass.
    """
    keys = by_name(scene)
    parameters = {n: keys[n].si for n in _parameters(scene)}
    values = np.zeros((len(OUTPUTS), len(parameters)))
    if any(outputs.values()):
        values[:] = _followed(lanes, list(parameters))
    at = dict(outputs) | {n: float(np.asarray(scene.numbers[n])) for n in parameters}
    said = [] if any(outputs.values()) else ["does not move, so that small changes change nothing"]
    if isinstance(scene.arc, Section) and through_vertex(scene.arc):
        said.append(
            "the circle passes through a vertex of the ground: derivatives by its coordinates and the circle's "
            "are those towards the side on which it lies outside the mass"
        )
    return Sensitivity(OUTPUTS, parameters, at, values, {n: keys[n] for n in parameters}, tuple(said))


def _parameters(scene: Scene) -> list[str]:
    """The names of the free parameters."""
    arc = telling(scene.arc) if isinstance(scene.arc, Section) else ARC if scene.arc.given is None else ARC[2:]
    start = ("initial_velocity", *(n for n in scene.numbers if n.startswith("shaking.")))
    without = {*numbers_in(scene.arc)} - {*arc} | {n for n in start if not float(np.asarray(scene.numbers.get(n, 0.0)))}
    return [n for n in dict.fromkeys(("friction", *arc, *scene.numbers)) if n in scene.numbers and n not in without]


def _followed(lanes: Lanes, names: Sequence[str]) -> Floats:
    """Rows: peak velocity, run-out, duration; a column for each parameter."""
    seeds = Seeds(lanes, names)
    bound = lanes.bound.asking(directions=1)
    bound = bound._replace(cells=np.repeat(bound.cells, len(names), axis=1))
    places, (tangent,) = bound.program.places, bound.program.tangents
    for name, dot in seeds.inputs.items():
        if name in places and places[name] in tangent.cells:
            bound.cells[tangent.cells[places[name]]] = dot
    bound.cells[tangent.cells[ix.OMEGA]] = np.abs(seeds.omega) * np.sign(seeds.omega * bound.cells[ix.OMEGA])
    for stiff_step in (1000.0, 1.0):  # what a step held short by what decays at once counts for
        one, events, handed = _walked(bound, seeds, stiff_step)
        # Implicit steps know no jumps of derivatives: they may go on smoothly to the end that is asked for, not more.
        smooth = one.c[ix.STATUS, 0] == ix.ENDED and not events and one.c[ix.PEAK_TIME, 0] <= handed
        if smooth or np.isinf(handed):
            break
    else:
        raise ValueError("sensitivity: this motion is too stiff for its derivatives; compare motions of other values")
    scale, radius = float(bound.time_scale), float(np.asarray(lanes.arc.radius))
    c = one.c[:, 0]
    ended = c[ix.STATUS] == ix.ENDED
    peak = np.sign(c[ix.PEAK_OMEGA]) * one.peak_dot + c[ix.PEAK_OMEGA] * seeds.speed_growth
    run_out = one.turned() + c[ix.END_ROTATION] * seeds.radius_growth
    duration = seeds.one("end_time") if ended else scale * (one.rest_dot + c[ix.REST_SINCE] * seeds.time_growth)
    reach = one.reach_dot + c[ix.REACH_ROTATION] * seeds.radius_growth
    return np.array([radius / scale * peak, radius * run_out, duration, radius * reach])


def _walked(bound: Bound, seeds: Seeds, stiff_step: float) -> tuple["_Walk", Log, float]:
    """The walk at its end, events since implicit steps took over, and when they did.

    That time is infinite where they did not, and 0 where something that changes with time still broke after it.
    """
    walks, log, handed = list[_Walk](), list[Any](), [np.inf]

    def follow(program: Program, data: Sequence[Data], cells: Floats, samples: Any, log: Any) -> None:
        one = _Walk(program, data, cells, seeds)
        walks[:], one.stiff_step = [one], stiff_step
        with np.errstate(all="ignore"):
            while one.c[ix.STATUS, 0] <= ix.RESTING:
                one.round()
        if one.c[ix.STATUS, 0] == ix.TOO_LONG:
            handed[0] = float(one.c[ix.TIME, 0]) if np.isinf(one._break()[0]) else 0.0

    walked(bound, log=log, walker=follow)
    return walks[0], log, handed[0]
