"""Implicit steps of the same program, for stiff lanes such as creep through a viscous layer.

A step of length h is the polynomial through the states y where it begins whose slope is the program's rate f at c_i h,
c_i the Radau points up to c_s = 1 (Radau IIA; Hairer and Wanner, Solving Ordinary Differential Equations II, section
IV.5). The states Y_i there solve

    residual_i = Y_i - y - h sum_j a_ij f(Y_j) = 0,
    a_ij the integral from 0 to c_i of the polynomial that is 1 at c_j and 0 at the other points,

by Newton's iteration with the exact Jacobian I - h a_ij df/dy(Y_j), which the program carries as tangents. Fast
transients decay within one step of any length, and the end is accurate to order 2 s - 1. The step is as long as its
polynomial, judged by its last Legendre coefficients, is the motion to rounding; events and samples are read off it.
Phases and events are those of `slipcircle.core.flow.integrate`.
"""

from collections.abc import Callable, Iterator
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
from slipcircle.core.flow.pieces import Piece
from slipcircle.core.flow.problem import Problem, common_cells
from slipcircle.core.flow.program import Log, Samples
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]
EventFunction = Callable[[Floats, Floats], Any]  # of states and registers, one number of each or one a time
POINTS = 12
LEAST_SIZE = 1e-300  # by which what is 0 is divided
TOLERANCE = 1e-13  # of the last coefficients of a step's polynomial, relative
CREEP = 1e-12  # of the greatest speed, below which a mass without an end time creeps without end
ENDLESS = 1e12  # dimensionless time, thirty thousand years and more, after which a motion has no end
ITERATIONS = 12
# Of one lane, breaks of what changes with time not included. A step no longer than some explicit ones counts for ten:
# then the motion is not stiff, but trembles or swings for long.
MOST_STEPS = 2_000
EXPLICIT = 8.0
GROWS, SHRINKS, SAFETY = 4.0, 0.1, 0.9  # factors of the step from one to the next


def _radau(count: int) -> tuple[Floats, Floats, Floats]:
    """Points c_i in (0, 1], a_ij, and the matrix from values at 0 and at the points to Legendre coefficients."""
    difference = [0.0] * (count - 1) + [-1.0, 1.0]  # P_s - P_(s-1), 1 among its roots
    points = legendre.legroots(difference)
    points[-1] = 1.0
    integrals = legendre.legint(np.eye(count), lbnd=-1, axis=1)  # of P_0 to P_(s-1)
    at_points = legendre.legval(points, integrals.T).T
    from_values = np.linalg.inv(legendre.legvander(points, count - 1))
    weights = at_points @ from_values
    with_start = np.array([-1.0, *points])
    to_legendre = np.linalg.inv(legendre.legvander(with_start, count))
    return (points + 1) / 2, weights / 2, to_legendre


AT, WEIGHTS, TO_LEGENDRE = _radau(POINTS)


def integrate(
    problem: Problem, cells: Floats, samples: Samples | None, log: Log | None, which: NDArray[np.intp]
) -> None:
    """Integrate some lanes one after the other from their present states, as `slipcircle.core.flow.integrate` does."""
    with_tangents = problem._replace(cells=cells).with_outputs(problem.outputs, directions=1)
    program = with_tangents.program
    result_cells, own_cells = common_cells(problem.program, program)
    for number in which:
        tables = [table.lanes([number]) for table in with_tangents.tables]
        begun = with_tangents.cells[:, [number]]
        lane = _Implicit(program, tables, begun, np.array([number]), samples, log)
        lane.integrated = len(problem.program.states)
        lane.status = ix.MOVING
        lane.steps = 0.0
        with np.errstate(all="ignore"):
            lane.restart_phase()
            while lane.status[0] <= ix.RESTING:
                lane.round()
        cells[result_cells, number] = lane.cells[own_cells, 0]


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
    """One lane; its step extends to the next event or break and consists of any number of implicit steps."""

    steps_left = MOST_STEPS
    integrated = 0  # states, their tangents among them where these are asked for

    def step(self) -> None:
        self._prepare()
        self.begin = float(self.time[0])
        now, event = self._follow(self._now(self.begin, self.cells[self.state_cells, 0]))
        self.cells[:] = self._cells_at(np.array([now.time]), now.states[:, None])
        uneventful = event == ix.EVENT_NONE
        if uneventful and now.time < self.limit:
            self.status = ix.TOO_LONG
            return
        net = self.program.roles["net"]
        rate = now.registers[[net]]
        self.settle(np.array([event]), rate, np.array([uneventful]))

    def _follow(self, now: _Now) -> tuple[_Now, int]:
        """Steps up to the next event or the greatest number of steps: the state there, and the event."""
        h = 4.0 * self.explicit
        event = ix.EVENT_NONE
        while event == ix.EVENT_NONE and now.time < self.limit and not self._creeps(now):
            left = self.limit - now.time
            to_limit = h >= left
            h = min(h, left)
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
            longer = _step_factor(max(step.error, LEAST_SIZE))
            h *= min(GROWS, longer)
        return now, event

    def _creeps(self, now: _Now) -> bool:
        """Whether a mass without an end time has become so slow that it creeps without end."""
        slow = abs(now.states[1]) < CREEP * abs(self.peak_omega[0])
        return bool(np.isinf(self.limit) and slow and now.time > self.begin)

    def _is_endless(self, now: _Now) -> bool:
        return bool(np.isinf(self.limit) and now.time - self.begin > ENDLESS)

    def _prepare(self) -> None:
        """Prepare the quantities that all implicit steps up to the next event share."""
        (self.tangent,) = self.program.tangents
        self.limit = float(min(self.next_break()[0], self.end_time[0]))
        integrated = self.program.states[: self.integrated]
        self.state_cells = [cell for cell, _, _ in integrated]
        self.rates = [rate for _, _, rate in integrated]
        self.without_tangents = len(self.program.states) // 2  # states, the first of them
        self.first_values = [piece.taylor(1)[0, 0] for piece in self.timed]
        self.first_increments = [piece.increment[0] for piece in self.timed]
        self.explicit = self._explicit_step()
        self.functions = self._event_functions()

    def _explicit_step(self) -> float:
        """The step that explicit integration would take."""
        endless = np.full(1, np.inf)
        series, order = self.expand(endless)
        step = self._step_size(series, order, endless)
        return float(np.minimum(step, 1e3)[0])

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
        """Registers in these states, (registers, times)."""
        cells = self._cells_at(times, states)
        return np.asarray(engine().registers(self.program, self._tables(times.size), cells))

    def _now(self, time: float, states: Floats) -> _Now:
        return _Now(time, states, self._registers_at(np.array([time]), states[:, None])[:, 0])

    def _jacobian(self, times: Floats, points: Floats) -> Floats:
        """df_j/dy_i at points (points, states), as (i, points, j), by the program's tangents in the states' directions.

        Tangents that are integrated beside the states have the same; how it changes with the states is neglected, as
        their own equations are linear.
        """
        states = self.without_tangents
        count = len(times)
        every_time = np.tile(times, states)
        every_point = np.tile(points, (states, 1))
        cells = self._cells_at(every_time, every_point.T)
        cells[list(self.tangent.cells.values())] = 0.0
        tangent_cells = [self.tangent.cells[cell] for cell in self.state_cells[:states]]
        cells[tangent_cells] = np.repeat(np.eye(states), count, axis=1)
        registers = engine().registers(self.program, self._tables(cells.shape[1]), cells)
        jacobian = np.zeros((states, count, states))
        for j, rate in enumerate(self.rates[:states]):
            if rate in self.tangent.registers:
                by_states = registers[self.tangent.registers[rate]]
                jacobian[:, :, j] = by_states.reshape(states, count)
        copies = np.eye(self.integrated // states)
        blocks = np.einsum("ab,ikj->aikbj", copies, jacobian)
        return blocks.reshape(self.integrated, count, self.integrated)

    def _newton(self, now: _Now, h: float) -> _Step | None:
        """A step; none where Newton's iteration does not converge."""
        times = now.time + AT * h
        first_rate = h * now.registers[self.rates]
        points = now.states + AT[:, None] * first_rate
        least = np.maximum(np.abs(first_rate), LEAST_SIZE)
        before = np.inf
        for _ in range(ITERATIONS):
            registers = self._registers_at(times, points.T)
            rates = registers[self.rates].T
            residual = points - now.states - h * WEIGHTS @ rates
            states_size = np.maximum(np.abs(points), np.abs(now.states))
            size = np.maximum(states_size, least)
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
        """Events, each with the function of states and registers that is positive before it."""
        roles = self.program.roles
        normal = roles["normal"]
        upright = roles["upright"]
        sign = -1.0 if self.lifted[0] > 0.0 else 1.0
        functions: list[tuple[int, EventFunction]] = [(ix.EVENT_STANDSTILL, lambda y, r: y[1])]
        if normal >= 0:
            functions.append((ix.EVENT_LIFT_OFF, lambda y, r: sign * r[normal]))
        if upright >= 0:
            functions.append((ix.EVENT_CHORD_UPRIGHT, lambda y, r: r[upright]))
        for number, piece in enumerate(self.pieces):
            if piece.kind != "time":
                event = ix.EVENT_BREAKPOINT + 2 * number
                functions += _edges(event, piece)
        return functions

    def _first_event(self, step: _Step, now: _Now, end: float) -> tuple[float, int]:
        """Time and kind of the first event of a step."""
        first = ix.EVENT_NONE
        for event, function in self.functions:
            at = self._first_zero(function, step, now)
            if at <= end:
                end = at
                first = event
        return end, first

    def _first_zero(self, function: EventFunction, step: _Step, now: _Now) -> float:
        """First zero of a function that is positive at first, by false position and bisection; infinity without one."""

        def at(time: float) -> float:
            states = step.states(time)
            return float(function(states[:, 0], self._registers_at(np.array([time]), states)[:, 0]))

        first = function(now.states, now.registers)
        values = np.array([first, *function(step.points, step.registers)])
        passes = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
        if not passes.size:
            return np.inf
        before = passes[0]
        times = (now.time, *step.times)
        low = times[before]
        high = times[before + 1]
        at_low = values[before]
        at_high = values[before + 1]
        least = 2 * EPS * abs(high)
        turn = 0
        while high - low > 2 * least:
            share = 0.5 if turn % 3 == 2 else at_low / (at_low - at_high)
            middle = low + share * (high - low)
            middle = min(max(middle, low + least), high - least)  # or only one end would move
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
        """Greatest speed within the step, where the net moment passes zero."""
        net = self.program.roles["net"]
        top = self._first_zero(lambda y, r: r[net], step, now)
        if top <= end:
            x, omega = step.states(top)[:2]
            self.keep_faster(np.array([top]), x, omega, np.zeros(1))

    def _write(self, begin: float, end: float, step: _Step) -> None:
        """Evaluate the states at the sample times between two times."""
        if self.samples is None:
            return
        column = int(self.lanes[0])
        times = self.samples.times[:, column]
        first = np.searchsorted(times, begin)
        last = np.searchsorted(times, end, side="right")
        if first == last:
            return
        now = times[first:last]
        states = step.states(now)
        x, omega, *further = states
        net = self._registers_at(now, states)[self.program.roles["net"]]
        direction = self.direction[0]
        rotation = self.rotation[0] + direction * x
        slip = self.slip[0] + x
        rows = [rotation, direction * omega, direction * net, slip, *further]
        self.samples.states[: len(rows), first:last, column] = rows


def _solved(jacobian: Floats, h: float, residual: Floats, size: Floats) -> Floats | None:
    """(I - h a x df/dy)^-1 residual, all in units of ``size``; none where that is singular."""
    unknowns = residual.size
    coupling = np.einsum("ij,kjl->iljk", WEIGHTS, jacobian).reshape(unknowns, unknowns)
    sizes = size.ravel()
    system = (np.eye(unknowns) - h * coupling) * (sizes / sizes[:, None])
    relative = residual / size
    try:
        move = np.linalg.solve(system, relative.ravel())
    except np.linalg.LinAlgError:
        return None
    return np.asarray(move.reshape(residual.shape))


def _finished(now: _Now, h: float, times: Floats, points: Floats, registers: Floats, rates: Floats) -> _Step:
    """The step that Newton's iteration has converged to.

    Its error is that of its last coefficients, beside rounding, of which that of the time moves every state by as much
    as its rate.
    """
    values = np.concatenate([now.states[None], points])
    coefficients = TO_LEGENDRE @ values
    largest_state = np.abs(values).max(axis=0)
    largest_rate = np.abs(rates).max(axis=0)
    size = np.maximum(largest_state, LEAST_SIZE)
    size += 8 * EPS / TOLERANCE * now.time * largest_rate
    tail = np.abs(coefficients[-2:]).max(axis=0)
    error = float((tail / size).max())
    return _Step(now.time, h, coefficients, times, points.T, registers, error)


def _edges(event: int, piece: Piece) -> Iterator[tuple[int, EventFunction]]:
    """The events of passing the upper edge of a table's piece, and the lower one of a function of speed."""
    of_speed = piece.kind == "speed"
    argument = 1 if of_speed else 0
    upper = float(piece.upper[0])
    lower = float(piece.lower[0])
    if np.isfinite(upper):
        yield event, partial(_distance, argument, upper, 1.0)
    if of_speed and lower:
        yield event + 1, partial(_distance, argument, lower, -1.0)


def _step_factor(error: float) -> float:
    """Ratio of the next step to this one for which its error is the tolerance."""
    return float(SAFETY * (TOLERANCE / error) ** (1 / POINTS))


def _distance(argument: int, bound: float, sign: float, states: Floats, registers: Floats) -> Any:
    """How far a state is below a bound, or above it."""
    return sign * (bound - states[argument])
