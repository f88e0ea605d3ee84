"""Implicit steps of the same program, for stiff lanes such as creep through a viscous layer.

The states at the points of a step (`slipcircle.core.flow.radau`) solve residual = 0 by Newton's iteration with the
exact Jacobian I - h a_ij df/dy(Y_j), which the program carries as tangents. Fast transients decay within one step of
any length, and the end is accurate to order 2 s - 1. The step is as long as its polynomial, judged by its last Legendre
coefficients, is the motion to rounding; events and samples are read off it. Phases and events are those of
`slipcircle.core.flow.integrate`.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.compiled import engine
from slipcircle.core.flow.integrate import Integrator
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.problem import Problem, common_cells
from slipcircle.core.flow.program import Log, Samples
from slipcircle.core.flow.radau import (
    AT,
    LEAST_SIZE,
    TOLERANCE,
    WEIGHTS,
    Present,
    Step,
    falling_zero,
    newton_correction,
    step_factor,
    step_through,
)
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]
CREEP = 1e-12  # of the greatest speed, below which a mass without an end time creeps without end
ENDLESS = 1e12  # dimensionless time, thirty thousand years and more, after which a motion has no end
ITERATIONS = 12
CONVERGED = 1e-12  # a correction, relative, from which on it is rounding that keeps it from falling
# Of one lane, breaks of what changes with time not included. A step no longer than some explicit ones counts for ten:
# then the motion is not stiff, but trembles or swings for long.
MOST_STEPS = 2_000
EXPLICIT = 8.0
SHORT_STEP = 10
FIRST, GROWS, SHRINKS, DIVERGES = 4.0, 4.0, 0.1, 0.25  # factors of explicit steps, and from one step to the next


def integrate(
    problem: Problem, cells: Floats, samples: Samples | None, log: Log | None, which: NDArray[np.intp]
) -> None:
    """Integrate some lanes one after the other from their present states, as `slipcircle.core.flow.integrate` does."""
    present = problem._replace(cells=cells)
    with_tangents = present.with_outputs(problem.outputs, directions=1)
    program = with_tangents.program
    result_cells, own_cells = common_cells(problem.program, program)
    for number in which:
        lane_number = np.array([number])
        tables = [table.lanes(lane_number) for table in with_tangents.tables]
        begun = with_tangents.cells[:, lane_number]
        lane = _Implicit(program, tables, begun, lane_number, samples, log)
        lane.integrated = len(problem.program.states)
        lane.status = ix.MOVING
        lane.steps = 0.0
        with np.errstate(all="ignore"):
            lane.restart_phase()
            while lane.status[0] <= ix.RESTING:
                lane.round()
        cells[result_cells, number] = lane.cells[own_cells, 0]


class _Event(NamedTuple):
    """An event: a register reaches a bound, from above, or with a negative sign from below."""

    kind: int
    register: int
    bound: float = 0.0
    sign: float = 1.0

    def margin(self, registers: Floats) -> Any:
        """Positive before the event; of one number of each register, or of one a time."""
        return self.sign * (registers[self.register] - self.bound)


class _Implicit(Integrator):
    """One lane; its step extends to the next event or break and consists of any number of implicit steps."""

    steps_left = MOST_STEPS
    integrated = 0  # states, their tangents among them where these are asked for

    def step(self) -> None:
        """Implicit steps up to the next event or break."""
        self._prepare()
        self.begin = float(self.time[0])
        start = self._at(self.begin, self.cells[self.state_cells, 0])
        now, event = self._follow(start)
        times = np.array([now.time])
        self.cells[:] = self._cells_at(times, now.states[:, None])
        uneventful = event == ix.EVENT_NONE
        if uneventful and now.time < self.limit:
            self.status = ix.TOO_LONG
            return
        net = self.roles["net"]
        rate = now.registers[[net]]
        self.settle(np.array([event]), rate, np.array([uneventful]))

    def _prepare(self) -> None:
        """Prepare the quantities that all implicit steps up to the next event share."""
        program = self.program
        (self.tangent,) = program.tangents
        limit = np.minimum(self.next_break(), self.end_time)
        self.limit = float(limit[0])
        integrated = program.states[: self.integrated]
        self.state_cells = [cell for cell, _, _ in integrated]
        self.rates = [rate for _, _, rate in integrated]
        self.without_tangents = len(program.states) // 2  # states, the first of them
        self.first_values = [piece.taylor(1)[0, 0] for piece in self.timed]
        self.first_increments = [piece.increment[0] for piece in self.timed]
        self.explicit = self._explicit_step()
        self.events = self._possible_events()

    def _explicit_step(self) -> float:
        """The step that explicit integration would take."""
        endless = np.full(1, np.inf)
        series, order = self.expand(endless)
        step = self._step_size(series, order, endless)
        return min(float(step[0]), 1e3)

    def _follow(self, now: Present) -> tuple[Present, int]:
        """Steps up to the next event or the greatest number of steps: the state there, and the event."""
        h = FIRST * self.explicit
        while now.time < self.limit and not self._creeps(now):
            left = self.limit - now.time
            to_limit = h >= left
            h = min(h, left)
            end = self.limit if to_limit else now.time + h
            if not to_limit:
                is_long = h > EXPLICIT * self.explicit
                self.steps_left -= 1 if is_long else SHORT_STEP
            if self.steps_left <= 0 or end == now.time or self._is_endless(now):
                break
            step = self._newton(now, h)
            if step is None:
                self.steps_left -= to_limit
                h *= DIVERGES
                continue
            factor = step_factor(step.error)
            if not step.error <= TOLERANCE:
                self.steps_left -= to_limit
                h *= max(SHRINKS, factor)
                continue
            end, event = self._first_event(step, now, end)
            self._keep_peak(step, now, end)
            self._write(step, now.time, end)
            now = self._at(end, _states_at(step, now, end))
            if event != ix.EVENT_NONE:
                return now, event
            h *= min(GROWS, factor)
        return now, ix.EVENT_NONE

    def _creeps(self, now: Present) -> bool:
        """Whether a mass without an end time has become so slow that it creeps without end."""
        omega = abs(now.states[1])
        is_slow = omega < CREEP * abs(self.peak_omega[0])
        has_begun = now.time > self.begin
        return bool(np.isinf(self.limit) and is_slow and has_begun)

    def _is_endless(self, now: Present) -> bool:
        duration = now.time - self.begin
        return bool(np.isinf(self.limit) and duration > ENDLESS)

    # --- one step ----------------------------------------------------------------------------------------------------

    def _tables(self, count: int) -> list[Data]:
        first = np.zeros(count, dtype=np.intp)
        return [table.lanes(first) for table in self.tables]

    def _cells_at(self, times: Floats, states: Floats) -> Floats:
        """Cells of this lane at some times in some states, (states, times)."""
        cells = np.repeat(self.cells, times.size, axis=1)
        cells[ix.TIME] = times
        cells[self.state_cells] = states
        tables = self._tables(times.size)
        there = LaneState(self.program, tables, cells)
        for piece, value, increment in zip(there.timed, self.first_values, self.first_increments, strict=True):
            piece.increment = increment + piece.taylor(1)[0] - value
        return cells

    def _registers_in(self, cells: Floats) -> Floats:
        """Registers of lanes with these cells, (registers, lanes)."""
        tables = self._tables(cells.shape[1])
        return np.asarray(engine().registers(self.program, tables, cells))

    def _registers_at(self, times: Floats, states: Floats) -> Floats:
        """Registers in these states, (registers, times)."""
        cells = self._cells_at(times, states)
        return self._registers_in(cells)

    def _at(self, time: float, states: Floats) -> Present:
        registers = self._registers_at(np.array([time]), states[:, None])
        return Present(time, states, registers[:, 0])

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
        tangent_cells = self.tangent.cells
        cells[list(tangent_cells.values())] = 0.0
        directions = [tangent_cells[cell] for cell in self.state_cells[:states]]
        cells[directions] = np.repeat(np.eye(states), count, axis=1)
        registers = self._registers_in(cells)
        jacobian = np.zeros((states, count, states))
        for j, rate in enumerate(self.rates[:states]):
            rate_dot = self.tangent.registers.get(rate)
            if rate_dot is not None:
                jacobian[:, :, j] = registers[rate_dot].reshape(states, count)
        copies = np.eye(self.integrated // states)
        blocks = np.einsum("ab,ikj->aikbj", copies, jacobian)
        return blocks.reshape(self.integrated, count, self.integrated)

    def _newton(self, now: Present, h: float) -> Step | None:
        """A step; none where Newton's iteration does not converge."""
        times = now.time + AT * h
        first_change = h * now.registers[self.rates]
        least_size = np.maximum(np.abs(first_change), LEAST_SIZE)
        least_size = np.maximum(np.abs(now.states), least_size)
        points = now.states + AT[:, None] * first_change
        before = np.inf
        for _ in range(ITERATIONS):
            registers = self._registers_at(times, points.T)
            rates = registers[self.rates].T
            change = h * WEIGHTS @ rates
            residual = points - now.states - change
            size = np.maximum(np.abs(points), least_size)
            jacobian = self._jacobian(times, points)
            correction = newton_correction(jacobian, h, residual, size)
            if correction is None:
                return None
            points = points - correction * size
            largest = np.abs(correction).max()
            falls_no_more = CONVERGED > largest > before / 4
            if largest <= 4 * EPS or falls_no_more:
                return step_through(now, h, points, registers, rates)
            if not largest < before:
                return None
            before = largest
        return None

    # --- events ------------------------------------------------------------------------------------------------------

    def _possible_events(self) -> list[_Event]:
        """The events that may end the phase."""
        roles = self.roles
        omega = roles["omega"]
        normal = roles["normal"]
        upright = roles["upright"]
        events = [_Event(ix.EVENT_STANDSTILL, omega)]
        if normal >= 0:
            sign = -1.0 if self.lifted[0] > 0.0 else 1.0
            events.append(_Event(ix.EVENT_LIFT_OFF, normal, sign=sign))
        if upright >= 0:
            events.append(_Event(ix.EVENT_CHORD_UPRIGHT, upright))
        for number, piece in enumerate(self.pieces):
            if piece.kind == "time":
                continue
            event = ix.EVENT_BREAKPOINT + 2 * number
            of_speed = piece.kind == "speed"
            register = omega if of_speed else roles["x"]
            lower = float(piece.lower[0])
            upper = float(piece.upper[0])
            if np.isfinite(upper):
                events.append(_Event(event, register, upper, -1.0))
            if of_speed and lower:
                events.append(_Event(event + 1, register, lower))
        return events

    def _first_event(self, step: Step, now: Present, end: float) -> tuple[float, int]:
        """Time and kind of the first event of a step."""
        first = ix.EVENT_NONE
        for event in self.events:
            time = self._first_time(event, step, now)
            if time <= end:
                end = time
                first = event.kind
        return end, first

    def _first_time(self, event: _Event, step: Step, now: Present) -> float:
        """Time of the first event of a kind within a step; infinity without one."""

        def margin(time: float) -> float:
            there = self._at(time, _states_at(step, now, time))
            return float(event.margin(there.registers))

        margins = np.array([event.margin(now.registers), *event.margin(step.registers)])
        reached = margins[1:] <= 0.0
        passes = np.flatnonzero(reached & (margins[:-1] > 0.0))
        if not passes.size:
            return np.inf
        times = (now.time, *step.times)
        low = passes[0]
        high = low + 1
        return falling_zero(margin, times[low], times[high], margins[low], margins[high])

    def _keep_peak(self, step: Step, now: Present, end: float) -> None:
        """Greatest speed within the step, where the net moment passes zero."""
        peak = _Event(ix.EVENT_NONE, self.roles["net"])
        time = self._first_time(peak, step, now)
        if time <= end:
            x, omega, *_ = _states_at(step, now, time)
            self.keep_faster(np.array([time]), np.array([x]), np.array([omega]), np.zeros(1))

    def _write(self, step: Step, begin: float, end: float) -> None:
        """Evaluate the states at the sample times between two times."""
        for sample in self.samples_between(np.array([begin]), np.array([end])):
            states = step.states(sample.since)
            registers = self._registers_at(begin + sample.since, states)
            x, omega, *further = states
            net = registers[self.roles["net"]]
            self.fill(sample, x, omega, net, *further)


def _states_at(step: Step, now: Present, time: float) -> Floats:
    """States at a time within a step."""
    since = np.array([time - now.time])
    return step.states(since)[:, 0]
