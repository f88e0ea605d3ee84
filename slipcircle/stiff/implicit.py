"""Implicit steps for stiff lanes, such as creep through a viscous layer, with the program of the explicit steps.

The states at the points of a step (`slipcircle.stiff.radau`) solve residual = 0 by Newton's iteration with the
Jacobian I - h a_ij df/dy(Y_j), approximated by differences. Fast transients decay within one step of any length, and
the end is accurate to order 2 s - 1. The last Legendre coefficients of the polynomial of a step determine its length,
so that the polynomial equals the motion to rounding. Events and samples are evaluated from it. `generated.integrator`
supplies phases and events.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from generated import integrator
from generated import layout as ix
from slipcircle.base.arrays import EPS, quiet
from slipcircle.base.kinds import Floats, Integers
from slipcircle.core.integrator.compiled import Log, OutputSamples, engine
from slipcircle.core.problem.problem import Problem
from slipcircle.core.scene.piecewise import Data
from slipcircle.stiff.radau import (
    AT,
    LEAST_SIZE,
    TOLERANCE,
    WEIGHTS,
    ImplicitStep,
    Present,
    falling_zero,
    newton_correction,
    step_factor,
    step_through,
)

CREEP = 1e-12  # speed over the greatest speed below which a mass without end time creeps without end
ENDLESS = 1e12  # dimensionless time (30,000 years and more) after which a motion has no end
ITERATIONS = 12
DIFFERENCE = 2.0**-26  # relative step of the differences in the Jacobian
CONVERGED = 1e-12  # relative correction below which only rounding prevents a further decrease
# Greatest number of steps of a lane, without steps that end at a break in time. A step shorter than EXPLICIT explicit
# steps counts as ten, since such a motion is not stiff but oscillates for long.
MOST_STEPS = 2_000
EXPLICIT = 8.0
SHORT_STEP = 10
FIRST = 4.0  # factors of explicit steps, and from one step to the next
GROWS = 4.0
SHRINKS = 0.1
DIVERGES = 0.25


def integrate_implicitly(
    problem: Problem, cells: Floats, samples: OutputSamples | None, log: Log | None, which: Integers
) -> None:
    """Integrate some lanes one after the other from their present states, as `generated.integrator.integrate` does.

    `which` are the indices of the lanes. Their columns of `cells` are replaced by the final values.
    """
    for number in which:
        lane_number = np.array([number])
        begun = cells[:, lane_number]
        lane = _Implicit(problem.program, problem.tables(), begun, lane_number, samples, log)
        state = lane.cells
        state[ix.STATUS] = ix.MOVING
        state[ix.STEPS] = 0.0
        with quiet():
            integrator.advance_origin(lane, _HERE)
            state[ix.PENDING] = ix.BEGIN_PHASE
            integrator.begin_phases(lane)
            while lane.status <= ix.RESTING:
                lane.advance()
        cells[:, number] = lane.stored[:, 0]


_HERE = np.ones(1, bool)


class Event(NamedTuple):
    """Register that reaches a bound from above, or from below with a negative sign."""

    kind: int
    register: int
    sign: float = 1.0
    bound: float = 0.0

    def margin(self, registers: Floats) -> Floats:
        """Return the distance of a lane from the event, positive before it.

        The registers are (registers, times), and the result is (times,).
        """
        above_bound = registers[self.register] - self.bound
        return self.sign * above_bound


class _Implicit(integrator.Lanes):
    """Single lane whose step extends to the next event or break and consists of any number of implicit steps."""

    steps_left = MOST_STEPS

    @property
    def status(self) -> float:
        """Status of the lane, a number of `generated.layout` such as `MOVING`."""
        return float(self.cells[ix.STATUS, 0])

    def advance(self) -> None:
        """Make one step, as `generated.integrator.advance` does."""
        if self.status == ix.MOVING:
            self.make_step()
        else:
            integrator.rest_on(self, _HERE)
        integrator.begin_phases(self)
        integrator.stop_endless(self, _HERE)

    def make_step(self) -> None:
        """Make implicit steps up to the next event or break."""
        self._prepare()
        self.begin = float(self.cells[ix.TIME, 0])
        start = self._at(self.begin, self.cells[self.state_cells])
        now, event = self._follow(start)
        time = np.array([now.time])
        rate = now.registers[self.roles.net]
        x, omega, *_ = now.states
        integrator.keep_faster(self, _HERE, omega, time, x, rate)
        self.stored[:] = self._cells_at(time, now.states)
        uneventful = event == ix.EVENT_NONE
        if uneventful and now.time < self.limit:
            self.cells[ix.STATUS] = ix.TOO_LONG
            return
        self.cells[ix.EVENT] = ix.EVENT_LIMIT if uneventful else event
        self.cells[ix.PASSED] = ix.NOTHING
        integrator.settle(self, _HERE, rate)

    def _prepare(self) -> None:
        """Prepare the quantities that all implicit steps up to the next event share."""
        program = self.program
        next_break = integrator.next_break(self)
        end_time = self.cells[ix.END_TIME]
        self.limit = float(np.minimum(next_break, end_time)[0])
        self.state_cells = [cell for cell, _, _ in program.states]
        self.rates = [rate for _, _, rate in program.states]
        # The step that explicit integration would take.
        endless = np.full(1, np.inf)
        integrator.choose_step(self, _HERE, integrator.expand(self, endless, _HERE, 0))
        step = float(self.cells[ix.STEP, 0])
        self.explicit = min(step, 1e3)
        self.events = self._events()

    def _events(self) -> list[Event]:
        """Return the events of a step in the order of the search."""
        roles = self.roles
        cells = self.cells[:, 0]
        events = [Event(ix.EVENT_STANDSTILL, roles.omega)]
        if roles.upright >= 0:
            events.append(Event(ix.EVENT_CHORD_UPRIGHT, roles.upright))
        for table in self.tables:
            kind = ix.EVENT_BREAKPOINT + 2 * table.number
            first = table.cells
            upper = min(cells[first + ix.UPPER], integrator.FAR)
            lower = cells[first + ix.LOWER]
            if table.kind == ix.OF_SPEED:
                events.append(Event(kind, roles.omega, -1.0, upper))
                if lower > 0.0:
                    events.append(Event(kind + 1, roles.omega, 1.0, lower))
            elif table.kind != ix.OF_TIME:
                events.append(Event(kind, roles.x, -1.0, upper))
        if roles.normal >= 0:
            is_lifted = cells[ix.LIFTED] > 0.0
            sign = -1.0 if is_lifted else 1.0
            events.append(Event(ix.EVENT_LIFT_OFF, roles.normal, sign))
        return events

    def _follow(self, now: Present) -> tuple[Present, int]:
        """Make steps up to the next event or the greatest number of steps, and return the state there and the event.

        The event is a number such as `generated.layout.EVENT_STANDSTILL`.
        """
        h = FIRST * self.explicit
        while now.time < self.limit and not self._is_endless(now):
            left = self.limit - now.time
            to_limit = h >= left
            h = min(h, left)
            end = self.limit if to_limit else now.time + h
            if not to_limit:
                is_long = h > EXPLICIT * self.explicit
                self.steps_left -= 1 if is_long else SHORT_STEP
            if self.steps_left <= 0 or end == now.time:
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
            now = self._within(step, now, end)
            if event != ix.EVENT_NONE:
                return now, event
            h *= min(GROWS, factor)
        return now, ix.EVENT_NONE

    def _is_endless(self, now: Present) -> bool:
        """Return whether a mass without end time is so slow, or has moved for so long, that it creeps without end."""
        duration = now.time - self.begin
        if np.isfinite(self.limit) or duration == 0.0:
            return False
        omega = abs(now.states[1, 0])
        return bool(omega < CREEP * abs(self.cells[ix.PEAK_OMEGA, 0]) or duration > ENDLESS)

    # --- one step ----------------------------------------------------------------------------------------------------

    def _tables(self, count: int) -> list[Data]:
        """Return the tables of this lane repeated for `count` evaluations."""
        columns = np.repeat(self.columns, count)
        return [table.data.lanes(columns) for table in self.tables]

    def _cells_at(self, times: Floats, states: Floats) -> Floats:
        """Return cells of this lane in the given states at the given times, (cells, times).

        The states are (states, times), and times are dimensionless.
        """
        cells = np.repeat(self.stored, times.size, axis=1)
        cells[ix.TIME] = times
        cells[self.state_cells] = states
        if not self.timed:
            return cells
        there = integrator.Lanes(self.program, self._tables(times.size), cells)
        for table in there.tables:
            if table.kind == ix.OF_TIME:
                value_before = cells[table.cells + ix.VALUE]  # at the beginning of the phase
                cells[table.cells + ix.INC] = integrator.value_now(there, table) - value_before
        return cells

    def _registers_at(self, times: Floats, states: Floats) -> Floats:
        """Return registers in the given states (states, times) at dimensionless times, (registers, times)."""
        return engine().registers(self.program, self._tables(times.size), self._cells_at(times, states))

    def _at(self, time: float, states: Floats) -> Present:
        """Return the present state with its registers, from a dimensionless time and the states, (states, 1)."""
        return Present(time, states, self._registers_at(np.array([time]), states))

    def _within(self, step: ImplicitStep, start: Present, time: float) -> Present:
        """Return states and registers at a time within a step, which begins at `start`. Times are dimensionless."""
        return self._at(time, step.states(np.array([time - start.time])))

    def _jacobian(self, times: Floats, points: Floats, rates: Floats, size: Floats) -> Floats:
        """Return df_j/dy_i at points of shape (points, states), as (i, points, j), from differences.

        `rates` are f at the points and `size` the sizes of the states, both (points, states). Times are (points,).
        """
        count, states = points.shape
        step = DIFFERENCE * size
        moved = np.tile(points, (states, 1, 1))
        for i in range(states):
            moved[i, :, i] += step[:, i]
        every_time = np.tile(times, states)
        every_point = moved.reshape(-1, states)
        registers = self._registers_at(every_time, every_point.T)
        return (registers[self.rates].T.reshape(states, count, states) - rates) / step.T[:, :, None]

    def _greatest_speed(self, start: Floats) -> Floats:
        """Return a vector with the greatest speed so far for omega and 0 for the other states.

        `start` are the states at the beginning of the step, (1, states). Near an equilibrium drive and resistance
        cancel, and the speed has the absolute rounding error of its maximum.
        """
        greatest = np.zeros(start.size)
        peak = abs(self.cells[ix.PEAK_OMEGA, 0])
        omega = abs(start[0, 1])
        greatest[1] = max(peak, omega)
        return greatest

    def _newton(self, now: Present, h: float) -> ImplicitStep | None:
        """Return a step of dimensionless length h, or None if Newton's iteration does not converge."""
        times = now.time + AT * h
        start = now.states.T
        first_change = h * now.registers[self.rates].T
        least_size = np.maximum(np.abs(first_change), LEAST_SIZE)
        speeds = self._greatest_speed(start)
        least_size = np.maximum(least_size, speeds)
        least_size = np.maximum(np.abs(start), least_size)
        points = start + AT[:, None] * first_change
        before = np.inf
        for _ in range(ITERATIONS):
            registers = self._registers_at(times, points.T)
            rates = registers[self.rates].T
            change = h * WEIGHTS @ rates
            residual = points - start - change
            size = np.maximum(np.abs(points), least_size)
            jacobian = self._jacobian(times, points, rates, size)
            correction = newton_correction(jacobian, h, residual, size)
            if correction is None:
                return None
            points = points - correction * size
            largest = np.abs(correction).max()
            falls_no_more = CONVERGED > largest > before / 4
            if largest <= 4 * EPS or falls_no_more:
                return step_through(now, h, points, registers, rates, 8 * EPS * speeds)
            if not largest < before:
                return None
            before = largest
        return None

    # --- events ------------------------------------------------------------------------------------------------------

    def _first_event(self, step: ImplicitStep, now: Present, end: float) -> tuple[float, int]:
        """Return time and kind of the first event of a step that begins at `now`, up to the time `end`.

        Without an event the time is `end` and the kind `EVENT_NONE`.
        """
        first = ix.EVENT_NONE
        for event in self.events:
            time = self._first_time(event, step, now)
            if time <= end:
                end = time
                first = event.kind
        return end, first

    def _first_time(self, event: Event, step: ImplicitStep, now: Present) -> float:
        """Return the time of the first event of a kind within a step from `now`, infinity without an event."""

        def margin(time: float) -> float:
            registers = self._within(step, now, time).registers
            return float(event.margin(registers)[0])

        times = [now.time, *step.times]
        registers = np.hstack([now.registers, step.registers])
        margins = event.margin(registers)
        for low, high in pairwise(zip(times, margins, strict=True)):
            if low[1] > 0.0 >= high[1]:
                return falling_zero(margin, low, high)
        return np.inf

    def _keep_peak(self, step: ImplicitStep, now: Present, end: float) -> None:
        """Store the greatest speed within the step up to the time `end`, where the net moment passes zero."""
        peak = Event(ix.EVENT_NONE, self.roles.net)
        time = self._first_time(peak, step, now)
        if time <= end:
            x, omega, *_ = self._within(step, now, time).states
            zero = np.zeros(1)
            integrator.keep_faster(self, _HERE, omega, zero + time, x, zero)

    def _write(self, step: ImplicitStep, begin: float, end: float) -> None:
        """Evaluate the states at sample times between two dimensionless times of a step, and store the samples."""
        if self.samples is None:
            return
        since, which = integrator.sampled(self, 0, begin, end)
        if since.size:
            states = step.states(since)
            x, omega, *further = states
            registers = self._registers_at(begin + since, states)
            net = registers[self.roles.net]
            rows = [x, omega, net, *further]
            integrator.fill(self, 0, which, rows)
