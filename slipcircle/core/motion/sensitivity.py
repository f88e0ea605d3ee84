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
from slipcircle.core.flow.lanes import Lanes, integrate_all
from slipcircle.core.flow.polynomials import shifted, slopes, value
from slipcircle.core.flow.problem import Problem
from slipcircle.core.flow.program import Log, Program, Table
from slipcircle.core.flow.tables import Data
from slipcircle.core.flow.walk import Walker
from slipcircle.core.motion.derivatives import Sensitivity
from slipcircle.core.motion.seeds import Seeds
from slipcircle.core.scene.coordinates import arc_numbers
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.parameters import parameters
from slipcircle.core.scene.scene import Scene
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.transport import active_parameters, through_vertex

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
    if isinstance(scene.arc, LayeredSection):
        raise ValueError("sensitivity: has no derivatives of layered sections yet; compare motions with other values")
    known = parameters(scene)
    units = {n: known[n].unit for n in _parameters(scene)}
    values = np.zeros((len(OUTPUTS), len(units)))
    if any(outputs.values()):
        values[:] = _followed(lanes, list(units))
    at = dict(outputs) | {n: float(np.asarray(scene.numbers[n])) for n in units}
    said = [] if any(outputs.values()) else ["does not move, so that small changes change nothing"]
    if isinstance(scene.arc, Section) and through_vertex(scene.arc):
        said.append(
            "the circle passes through a vertex of the ground: derivatives by its coordinates and the circle's "
            "are those towards the side on which it lies outside the mass"
        )
    return Sensitivity(OUTPUTS, units, at, values, scene, tuple(said))


def _parameters(scene: Scene) -> list[str]:
    """The names of the free parameters."""
    arc = (
        active_parameters(scene.arc) if isinstance(scene.arc, Section) else ARC if scene.arc.given is None else ARC[2:]
    )
    start = ("initial_velocity", *(n for n in scene.numbers if n.startswith("shaking.")))
    without = {*arc_numbers(scene.arc)} - {*arc} | {
        n for n in start if not float(np.asarray(scene.numbers.get(n, 0.0)))
    }
    return [n for n in dict.fromkeys(("friction", *arc, *scene.numbers)) if n in scene.numbers and n not in without]


def _followed(lanes: Lanes, names: Sequence[str]) -> Floats:
    """Rows: peak velocity, run-out, duration; a column for each parameter."""
    seeds = Seeds(lanes, names)
    bound = lanes.problem.with_outputs(directions=1)
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


def _walked(bound: Problem, seeds: Seeds, stiff_step: float) -> tuple["_Walk", Log, float]:
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

    integrate_all(bound, log=log, walker=follow)
    return walks[0], log, handed[0]


class _Walk(Walker):
    """One motion on its way with its derivatives: lanes that are alike but for the direction of theirs."""

    def __init__(self, program: Program, tables: Sequence[Data], cells: Floats, seeds: Seeds) -> None:
        super().__init__(program, tables, cells, None, np.arange(cells.shape[1]))
        self.seeds, (self.tangent,) = seeds, program.tangents
        self.none = np.zeros(cells.shape[1])
        self.event_dot = self.none  # of the time at which the phase in hand begins
        self.peak_dot = self.rest_dot = self.reach_dot = self.none
        end = cells[ix.END_TIME, 0]
        self.end_dot = seeds.end_dot - end * seeds.time_growth if np.isfinite(end) else self.none
        self.r: Any = None
        self.total = self.none

    def dot(self, cell: int) -> Floats:
        """Derivatives of a cell."""
        return self.c[self.tangent.cells[cell]].copy() if cell in self.tangent.cells else self.none

    def put(self, cell: int, dots: Any) -> None:
        if cell in self.tangent.cells:
            self.c[self.tangent.cells[cell]] = dots

    def turned(self) -> Floats:
        """Derivatives of the rotation where it stands, or where it is at its end time."""
        c = self.c[:, 0]
        return self.dot(ix.ROTATION) + c[ix.DIRECTION] * (self.dot(ix.X) + c[ix.OMEGA] * self.end_dot)

    def of(self, register: int, at: float) -> Floats:
        """Derivatives of a register at a time since the step began."""
        k = self.tangent.registers.get(register)
        return self.none if k is None else np.asarray(value(self.r[k], at + self.none))

    def _length(self, r: Floats, last: Floats, registers: Sequence[int]) -> Floats:
        """The step that suits all directions: they go together."""
        return np.full_like(self.none, super()._length(r, last, registers).min())

    # --- tables ------------------------------------------------------------------------------------------------------

    def _piece(self, slot: Table, data: Data) -> None:
        super()._piece(slot, data)
        scale_growth, factor_growth, by_parameter = self.seeds.tables[slot.name]
        at, c = slot.cells, self.c
        scale, factor = c[at + ix.SCALE, 0], c[at + ix.SCALED_BY, 0]
        if slot.kind == "time":
            _, dots = self._time_terms(slot, data, 1)
            self.put(at + ix.VALUE, dots[0] + self._local(slot, data, 1)[1:, 0].sum() * self.event_dot)
            return
        piece = int(c[at + ix.PIECE, 0])
        slips, per = slot.kind == "slip", 1.0
        if slot.kind == "rotation":
            local, moved = float((c[ix.ROTATION] - data.begins(np.array([piece])))[0]), self.dot(ix.ROTATION)
            per = c[ix.DIRECTION, 0]
        elif slips:
            per = scale
            local = max(c[ix.SLIP, 0] * scale - data.breaks[piece], 0.0)
            moved = self.dot(ix.SLIP) * scale + c[ix.SLIP, 0] * scale * scale_growth
        elif piece:
            local = math.log(c[ix.OMEGA, 0] * scale / data.breaks[piece])
            moved = self.dot(ix.OMEGA) / c[ix.OMEGA, 0] + scale_growth
        else:
            local, moved = 0.0, self.none
        terms = shifted(data.polynomial(np.array([piece])), np.array([local]))[:, 0]
        terms = np.append(terms, 0.0)
        for j in range(slot.degree + 1):
            unit = per**j
            here = terms[j] if j < len(terms) else 0.0
            more = (j + 1) * terms[j + 1] if j + 1 < len(terms) else 0.0
            dots = factor * unit * (here * (factor_growth + (j * scale_growth if slips else 0.0)) + more * moved)
            if by_parameter is not None:
                own = [shifted(d.polynomial(np.array([piece])), np.array([local]))[:, 0] for d in by_parameter]
                dots = dots + factor * unit * np.array([o[j] if j < len(o) else 0.0 for o in own])
            self.put(at + ix.VALUE if j == 0 else at + ix.Q1 + j - 1, dots)

    def _time_terms(self, slot: Table, data: Data, order: int) -> tuple[Floats, Floats]:
        """Taylor coefficients about now of a function of time, and their derivatives at fixed time, (terms, ...)."""
        scale_growth, factor_growth, _ = self.seeds.tables[slot.name]
        terms = np.zeros(order + 2)
        local = self._local(slot, data, order + 1)[:, 0]
        terms[: len(local)] = local
        n = np.arange(order + 1)
        faster = self.c[ix.TIME, 0] * (n + 1) * terms[1:] + n * terms[:-1]
        return terms[:-1], terms[:-1, None] * factor_growth + faster[:, None] * scale_growth

    def _ramps(self, r: Floats) -> None:
        super()._ramps(r)
        for k in self.timed:
            slot = self.program.tables[k]
            _, dots = self._time_terms(slot, self.tables[k], r.shape[1] - 1)
            dots[0] -= self.dot(slot.cells + ix.VALUE)
            if slot.register in self.tangent.registers:
                r[self.tangent.registers[slot.register]] = dots

    # --- events ------------------------------------------------------------------------------------------------------

    def _events(self, r: Floats, h: Floats) -> tuple[Floats, NDArray[np.intp]]:
        self.r = r
        self.tau, event = super()._events(r, h)
        self.before = [float(value(r[rate][:, 0], self.tau[0])) for _, _, rate in self._own]
        return self.tau, event

    @property
    def _own(self) -> Any:
        """The states that are no derivatives."""
        return self.program.states[: len(self.program.states) // 2]

    def _depart(self, event_dot: Floats) -> None:
        """Total derivatives where the lane is now, for a phase that begins here."""
        c = self.c
        omega = c[ix.OMEGA, 0]
        gone = self.dot(ix.X) + omega * event_dot
        self.put(ix.ROTATION, self.dot(ix.ROTATION) + c[ix.DIRECTION, 0] * gone)
        self.put(ix.SLIP, self.dot(ix.SLIP) + gone)
        self.put(ix.X, -omega * event_dot)
        self.totals = {
            cell: self.dot(cell) + rate * event_dot
            for (cell, _, _), rate in zip(self._own[1:], self.before[1:], strict=True)
        }
        self.event_dot = event_dot
        self.total = self.totals[ix.OMEGA]

    def _arrive(self) -> None:
        """At fixed times again, now that the rates of what begins are known."""
        r = self._series(0)[0]
        for cell, _, rate in self._own[1:]:
            after = r[rate, 0, 0] if rate != self.program.roles["omega"] else self.c[ix.OMEGA, 0]
            self.put(cell, self.totals[cell] - after * self.event_dot)
        self.event_dot = self.none

    def stand(self) -> None:
        event_dot = -self.dot(ix.OMEGA) / self.before[1]
        self.c[ix.OMEGA] = 0.0
        self._depart(event_dot)
        self.rest_dot = event_dot
        super().stand()
        if self.c[ix.STATUS, 0] == ix.MOVING:
            self._arrive()
        else:
            self.put(ix.OMEGA, 0.0)
            self.event_dot = self.none

    def kink(self, event: NDArray[np.intp], rate: Floats) -> None:
        c, k = self.c, int(event[0])
        if k == ix.EVENT_LIFT_OFF:
            normal = self.program.roles["normal"]
            falls = float(value(slopes(self.r[normal]), self.tau)[0])
            event_dot = -self.of(normal, float(self.tau[0])) / falls
        else:
            number, lower = divmod(k - ix.EVENT_BREAKPOINT, 2)
            slot, data = self.program.tables[number], self.tables[number]
            scale_growth = self.seeds.tables[slot.name][0]
            piece = int(c[slot.cells + ix.PIECE, 0]) + (1 - lower)
            edge = data.breaks[piece] / c[slot.cells + ix.SCALE, 0]
            if slot.kind == "rotation":
                event_dot = self.none  # the pressure and its derivatives go on smoothly
            elif slot.kind == "slip":
                event_dot = (-edge * scale_growth - self.dot(ix.SLIP) - self.dot(ix.X)) / c[ix.OMEGA, 0]
            else:
                event_dot = (-edge * scale_growth - self.dot(ix.OMEGA)) / float(rate[0])
        self._depart(event_dot)
        super().kink(event, rate)
        self._arrive()

    def _pass_breaks(self, at_break: Any) -> Any:
        moving = self.c[ix.STATUS, 0] == ix.MOVING
        found = super()._pass_breaks(at_break)
        if moving and np.any(at_break) and np.any(found):
            event_dot = -self.c[ix.TIME, 0] * self.seeds.time_growth
            after = self._series(0)[0]
            for (cell, _, rate), before in zip(self._own[1:], self.before[1:], strict=True):
                self.put(cell, self.dot(cell) + (before - after[rate, 0, 0]) * event_dot)
        return found

    def rebase(self) -> None:
        self.before = [float(self._series(0)[0][rate, 0, 0]) for _, _, rate in self._own]
        self._depart(-self.c[ix.TIME, 0] * self.seeds.time_growth)
        super().rebase()
        self._arrive()

    def start_again(self, jump: Any) -> None:
        self.event_dot = self.none
        self.base()
        drive = self.program.roles["cell_drive"]
        rises = self._series(1, frozen=True)[0][self.program.roles["net"], 1, 0]
        leaps = bool(jump[0])
        event_dot = -self.c[ix.TIME, 0] * self.seeds.time_growth if leaps else -self.dot(drive) / rises
        self.before = [0.0 for _ in self._own]
        self._depart(event_dot)
        super().start_again(jump)
        if leaps:
            self._arrive()
        else:
            self.put(drive, 0.0)
            self.put(ix.OMEGA, 0.0)
            self.event_dot = self.none

    # --- the greatest speed and rotation -----------------------------------------------------------------------------

    def _reach(self) -> None:
        before = self.c[ix.REACH_ROTATION, 0]
        super()._reach()
        if self.c[ix.REACH_ROTATION, 0] != before:
            self.reach_dot = self.turned()

    def _set_peak(self, k: Any, time: Any, gone: Any, speed: Any, rate: Any) -> None:
        super()._set_peak(k, time, gone, speed, rate)
        if len(k):
            self.peak_dot = self.of(self.program.roles["omega"], float(time[0] - self.c[ix.TIME, 0]))

    def _fastest(self, speed: Floats, time: Floats, rotation: Floats, rate: Floats, mask: Any = True) -> None:
        before = float(self.c[ix.PEAK_OMEGA, 0])
        super()._fastest(speed, time, rotation, rate, mask)
        if float(self.c[ix.PEAK_OMEGA, 0]) != before:
            late = float(time[0]) >= float(self.c[ix.END_TIME, 0])
            breaks = float(time[0]) >= self._break()[0]  # of what changes with time, where the force may leap
            moved = self.end_dot if late else -time[0] * self.seeds.time_growth if breaks else self.none
            self.peak_dot = self.dot(ix.OMEGA) + float(rate[0]) * moved
            if not late and np.any(self.event_dot):
                self.peak_dot = self.total
