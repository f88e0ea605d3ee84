"""Implicit steps of the same program, for lanes that explicit ones are too short for: creep through a viscous layer.

A step of length h is the polynomial through the states y where it begins whose slope is the program's rate f at c_i h,
c_i the Radau points up to c_s = 1 (Radau IIA; Hairer and Wanner, Solving Ordinary Differential Equations II, section
IV.5). The states Y_i there solve

    residual_i = Y_i - y - h sum_j a_ij f(Y_j) = 0,
    a_ij the integral from 0 to c_i of the polynomial that is 1 at c_j and 0 at the other points,

by Newton's iteration with the exact Jacobian I - h a_ij df/dy(Y_j), which the program carries as tangents. What decays
at once is gone after one step, however long, and the end is right to order 2 s - 1. The step is as long as its
polynomial, judged by its last Legendre coefficients, is the motion to rounding; events and samples are read off it.
Phases and events are those of `slipcircle.core.flow.integrate`.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.compiled import engine
from slipcircle.core.flow.integrate import Integrator
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.problem import Problem, common_cells
from slipcircle.core.flow.program import Log, Samples
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]
EventFunction = Callable[[Floats, Floats], Any]  # of states and registers, one number of each or one a time
POINTS = 12
TOLERANCE = 1e-13  # of the last coefficients of a step's polynomial, relative
CREEP = 1e-12  # of its greatest speed, with which a mass without an end is taken to creep for ever
ENDLESS = 1e12  # dimensionless time, thirty thousand years and more, after which a motion has no end
ITERATIONS = 12
# Of one lane, breaks of what changes with time not included. A step no longer than some explicit ones counts for ten:
# then the motion is not stiff, but trembles or swings for long.
MOST_STEPS = 2_000
EXPLICIT = 8.0
GROWS, SHRINKS, SAFETY = 4.0, 0.1, 0.9  # factors of the step from one to the next


def _radau(count: int) -> tuple[Floats, Floats, Floats]:
    """Points c_i in (0, 1], a_ij, and what gives Legendre coefficients of values at 0 and the points."""
    points = legendre.legroots([0.0] * (count - 1) + [-1.0, 1.0])  # P_s - P_(s-1), 1 among its roots
    points[-1] = 1.0
    integrals = np.array([legendre.legval(points, legendre.legint(unit, lbnd=-1)) for unit in np.eye(count)]).T
    weights = integrals @ np.linalg.inv(legendre.legvander(points, count - 1))
    to_legendre = np.linalg.inv(legendre.legvander(np.array([-1.0, *points]), count))
    return (points + 1) / 2, weights / 2, to_legendre


AT, WEIGHTS, TO_LEGENDRE = _radau(POINTS)


def integrate(
    problem: Problem, cells: Floats, samples: Samples | None, log: Log | None, which: NDArray[np.intp]
) -> None:
    """Integrate some lanes, one after the other, from where they are, as `slipcircle.core.flow.integrate` does."""
    with_tangents = problem._replace(cells=cells).with_outputs(problem.outputs, directions=1)
    program = with_tangents.program
    to, of = common_cells(problem.program, program)
    integrated = len(problem.program.states)
    for lane in which:
        tables = [table.lanes([lane]) for table in with_tangents.tables]
        one = _Implicit(program, tables, with_tangents.cells[:, [lane]], np.array([lane]), samples, log)
        one.status = ix.MOVING
        one.steps = 0.0
        one.integrated = integrated
        with np.errstate(all="ignore"):
            one.restart_phase()
            while one.status[0] <= ix.RESTING:
                one.round()
        cells[to, lane] = one.cells[of, 0]


class _Step(NamedTuple):
    """A step: Legendre coefficients of its states; times, states and registers at its points; its error, relative."""

    begin: float
    length: float
    legendre: Floats
    times: Floats
    points: Floats
    registers: Floats
    error: float

    def states(self, times: Any) -> Floats:
        """(states, times)."""
        place = np.atleast_1d(2 * (times - self.begin) / self.length - 1)
        return np.asarray(legendre.legval(place, self.legendre))


class _Now(NamedTuple):
    """A time, with the states and all registers there."""

    time: float
    states: Floats
    registers: Floats


class _Implicit(Integrator):
    """One lane, a step of which goes to the next event or break in as many implicit steps as that takes."""

    steps_left = MOST_STEPS
    integrated = 0  # states, their tangents among them where these are asked for

    def step(self) -> None:
        self._prepare()
        self.limit = float(min(self.next_break()[0], self.end_time[0]))
        self.explicit = self._explicit_step()
        self.functions = self._event_functions()
        self.begin = float(self.time[0])
        now, event = self._follow(self._now(self.begin, self.cells[self.state_cells, 0]))
        self.cells[:] = self._cells_at(np.array([now.time]), now.states[:, None])
        uneventful = event == ix.EVENT_NONE
        if uneventful and now.time < self.limit:
            self.status = ix.TOO_LONG
            return
        rate = now.registers[[self.program.roles["net"]]]
        self.settle(np.array([event]), rate, np.array([uneventful]))

    def _follow(self, now: _Now) -> tuple[_Now, int]:
        """Steps up to the next event, or until no more are made: where that is, and which event."""
        h = 4.0 * self.explicit
        event = ix.EVENT_NONE
        while event == ix.EVENT_NONE and now.time < self.limit and not self._creeps(now):
            to_limit = h >= self.limit - now.time
            h = min(h, self.limit - now.time)
            end = self.limit if to_limit else now.time + h
            if not to_limit:
                self.steps_left -= 1 if h > EXPLICIT * self.explicit else 10
            if self.steps_left <= 0 or end == now.time or self._is_endless(now):
                break
            step = self._newton(now, h)
            if step is None or not step.error <= TOLERANCE:
                self.steps_left -= to_limit
                h *= 0.25 if step is None else max(SHRINKS, _step_factor(step.error))
                continue
            end, event = self._first_event(step, now, end)
            self._keep_peak(step, now, end)
            self._write(now.time, end, step)
            now = self._now(end, step.states(end)[:, 0])
            h *= min(GROWS, _step_factor(max(step.error, 1e-300)))
        return now, event

    def _creeps(self, now: _Now) -> bool:
        """Whether a mass without an end is so slow, after it was faster, that it creeps for ever."""
        slow = abs(now.states[1]) < CREEP * abs(self.peak_omega[0])
        return bool(np.isinf(self.limit) and slow and now.time > self.begin)

    def _is_endless(self, now: _Now) -> bool:
        return bool(np.isinf(self.limit) and now.time - self.begin > ENDLESS)

    def _prepare(self) -> None:
        """What all implicit steps up to the next event share."""
        (self.tangent,) = self.program.tangents
        own = len(self.program.states) // 2
        self.own_cells = [cell for cell, _, _ in self.program.states[:own]]
        self.own_rates = [rate for _, _, rate in self.program.states[:own]]
        self.state_cells = [cell for cell, _, _ in self.program.states[: self.integrated]]
        self.rates = [rate for _, _, rate in self.program.states[: self.integrated]]
        self.first_values = [piece.taylor(1)[0, 0] for piece in self.timed]
        self.first_increments = [piece.increment[0] for piece in self.timed]

    def _explicit_step(self) -> float:
        """The step that explicit integration would take."""
        series, order = self.expand(np.full(1, np.inf))
        return float(np.minimum(self._step_size(series, order, np.full(1, np.inf)), 1e3)[0])

    # --- one step ----------------------------------------------------------------------------------------------------

    def _tables(self, count: int) -> list[Data]:
        return [table.lanes(np.zeros(count, dtype=np.intp)) for table in self.tables]

    def _cells_at(self, times: Floats, states: Floats) -> Floats:
        """Cells of this lane at some times in some states, (states, times)."""
        cells = np.repeat(self.cells, times.size, axis=1)
        cells[ix.TIME] = times
        cells[self.state_cells] = states
        there = LaneState(self.program, self._tables(times.size), cells)
        for piece, value, increment in zip(there.timed, self.first_values, self.first_increments, strict=True):
            piece.increment = increment + piece.taylor(1)[0] - value
        return cells

    def _registers_at(self, times: Floats, states: Floats) -> Floats:
        """What the program gives there, (registers, times)."""
        cells = self._cells_at(times, states)
        return np.asarray(engine().registers(self.program, self._tables(times.size), cells))

    def _now(self, time: float, states: Floats) -> _Now:
        return _Now(time, states, self._registers_at(np.array([time]), states[:, None])[:, 0])

    def _jacobian(self, times: Floats, points: Floats) -> Floats:
        """df_j/dy_i at points (points, states), as (i, points, j), by the program's tangents in the states' directions.

        Tangents that are integrated beside the states have the same; how it changes with the states is left out, as
        their own equations are linear.
        """
        own = len(self.own_cells)
        cells = self._cells_at(np.tile(times, own), np.tile(points, (own, 1)).T)
        cells[list(self.tangent.cells.values())] = 0.0
        cells[[self.tangent.cells[cell] for cell in self.own_cells]] = np.repeat(np.eye(own), len(times), axis=1)
        registers = engine().registers(self.program, self._tables(cells.shape[1]), cells)
        jacobian = np.zeros((own, len(times), own))
        for j, rate in enumerate(self.own_rates):
            if rate in self.tangent.registers:
                jacobian[:, :, j] = registers[self.tangent.registers[rate]].reshape(own, len(times))
        copies = np.eye(self.integrated // own)
        return np.einsum("ab,ikj->aikbj", copies, jacobian).reshape(self.integrated, len(times), self.integrated)

    def _newton(self, now: _Now, h: float) -> _Step | None:
        """A step; none where Newton's iteration does not converge."""
        first_rate = h * now.registers[self.rates]
        points = now.states + AT[:, None] * first_rate
        times = now.time + AT * h
        least = np.maximum(np.abs(first_rate), 1e-300)
        before = np.inf
        for _ in range(ITERATIONS):
            registers = self._registers_at(times, points.T)
            rates = registers[self.rates].T
            residual = points - now.states - h * WEIGHTS @ rates
            size = np.maximum(np.maximum(np.abs(points), np.abs(now.states)), least)
            move = _solved(self._jacobian(times, points), h, residual, size)
            if move is None:
                return None
            points = points - move * size
            largest = np.abs(move).max()
            if largest <= 4 * EPS or 1e-12 > largest > before / 4:
                return _finished(now, h, times, points, registers, rates)
            if not largest < before:
                return None
            before = largest
        return None

    # --- events ------------------------------------------------------------------------------------------------------

    def _event_functions(self) -> list[tuple[int, EventFunction]]:
        """Events, with what of states and registers is above zero before them."""
        roles = self.program.roles
        sign = -1.0 if self.lifted[0] > 0.0 else 1.0
        functions: list[tuple[int, EventFunction]] = [(ix.EVENT_STANDSTILL, lambda y, r: y[1])]
        if roles["normal"] >= 0:
            functions.append((ix.EVENT_LIFT_OFF, lambda y, r: sign * r[roles["normal"]]))
        if roles["upright"] >= 0:
            functions.append((ix.EVENT_CHORD_UPRIGHT, lambda y, r: r[roles["upright"]]))
        for number, piece in enumerate(self.pieces):
            if piece.kind == "time":
                continue
            event = ix.EVENT_BREAKPOINT + 2 * number
            argument = 1 if piece.kind == "speed" else 0
            upper = float(piece.upper[0])
            lower = float(piece.lower[0])
            if np.isfinite(upper):
                functions.append((event, partial(_distance, argument, upper, 1.0)))
            if piece.kind == "speed" and lower:
                functions.append((event + 1, partial(_distance, argument, lower, -1.0)))
        return functions

    def _first_event(self, step: _Step, now: _Now, end: float) -> tuple[float, int]:
        """When the first event of a step happens, and which."""
        first = ix.EVENT_NONE
        for event, function in self.functions:
            at = self._first_zero(function, step, now)
            if at <= end:
                end = at
                first = event
        return end, first

    def _first_zero(self, function: EventFunction, step: _Step, now: _Now) -> float:
        """When a function that is above zero first passes it: by false position and halves; infinity where not."""

        def at(time: float) -> float:
            states = step.states(time)
            return float(function(states[:, 0], self._registers_at(np.array([time]), states)[:, 0]))

        values = np.array([function(now.states, now.registers), *function(step.points, step.registers)])
        passes = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
        if not passes.size:
            return np.inf
        low, high = (now.time, *step.times)[passes[0] : passes[0] + 2]
        at_low, at_high = values[passes[0] : passes[0] + 2]
        least = 2 * EPS * abs(high)
        turn = 0
        while high - low > 2 * least:
            share = 0.5 if turn % 3 == 2 else at_low / (at_low - at_high)
            middle = min(max(low + share * (high - low), low + least), high - least)  # or only one end would move
            at_middle = at(middle)
            turn = turn + 1
            if at_middle > 0.0:
                low = middle
                at_low = at_middle
            else:
                high = middle
                at_high = at_middle
        return float(high)

    def _keep_peak(self, step: _Step, now: _Now, end: float) -> None:
        """The greatest speed, where the net moment passes zero within the step."""
        net = self.program.roles["net"]
        top = self._first_zero(lambda y, r: r[net], step, now)
        if top <= end:
            x, omega = step.states(top)[:2]
            self._keep_faster(omega, np.array([top]), x, np.zeros(1))

    def _write(self, begin: float, end: float, step: _Step) -> None:
        """Read the states off at sample times from one time up to another."""
        if self.samples is None:
            return
        column = int(self.lanes[0])
        direction = self.direction[0]
        times = self.samples.times[:, column]
        rows = slice(np.searchsorted(times, begin), np.searchsorted(times, end, side="right"))
        if not times[rows].size:
            return
        x, omega, *further = step.states(times[rows])
        net = self._registers_at(times[rows], np.array([x, omega, *further]))[self.program.roles["net"]]
        states = [self.rotation[0] + direction * x, direction * omega, direction * net, self.slip[0] + x, *further]
        self.samples.states[: len(states), rows, column] = states


def _solved(jacobian: Floats, h: float, residual: Floats, size: Floats) -> Floats | None:
    """(I - h a x df/dy)^-1 residual, all in units of ``size``; none where that is singular."""
    unknowns = residual.size
    coupling = np.einsum("ij,kjl->iljk", WEIGHTS, jacobian).reshape(unknowns, unknowns)
    system = (np.eye(unknowns) - h * coupling) * (size.ravel() / size.ravel()[:, None])
    try:
        move = np.linalg.solve(system, (residual / size).ravel())
    except np.linalg.LinAlgError:
        return None
    return np.asarray(move.reshape(residual.shape))


def _finished(now: _Now, h: float, times: Floats, points: Floats, registers: Floats, rates: Floats) -> _Step:
    """The step that Newton's iteration has found.

    Its error is that of its last coefficients, beside rounding, of which that of the time moves every state by as much
    as its rate.
    """
    values = np.concatenate([now.states[None], points])
    coefficients = TO_LEGENDRE @ values
    known = np.maximum(np.abs(values).max(axis=0), 1e-300)
    known += 8 * EPS / TOLERANCE * now.time * np.abs(rates).max(axis=0)
    tail = np.abs(coefficients[-2:]).max(axis=0) / known
    return _Step(now.time, h, coefficients, times, points.T, registers, float(tail.max()))


def _step_factor(error: float) -> float:
    """How much longer the next step may be for its error to be the tolerance."""
    return float(SAFETY * (TOLERANCE / error) ** (1 / POINTS))


def _distance(argument: int, bound: float, sign: float, states: Floats, registers: Floats) -> Any:
    """How far a state is below a bound, or above it."""
    return sign * (bound - states[argument])
