"""What is kept of a motion on its way: its greatest speed and rotation, its events, its states at sample times."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.polynomials import bracketed_root, derivative, divided_by_time, first_root, value

Floats = NDArray[np.float64]


class Recorder(LaneState):
    """Lanes of which extremes, events and samples are kept."""

    # --- the greatest speed and rotation -----------------------------------------------------------------------------

    def update_peak(self, rate: Floats) -> None:
        """Where the lane is now, at the start of a phase or the end of a step, may be where it is fastest."""
        self._keep_faster(self.omega, self.time, self.x, rate)

    def _keep_faster(self, speed: Floats, time: Floats, x: Floats, rate: Floats, series: Floats | None = None) -> None:
        """Keep a candidate for the greatest speed where it is faster than what is kept."""
        k = np.flatnonzero(speed > np.abs(self.peak_omega))
        direction = self.direction[k]
        self.peak_time[k] = time[k]
        self.peak_rotation[k] = self.rotation[k] + direction * x[k]
        self.peak_omega[k] = direction * speed[k]
        self.peak_rate[k] = direction * rate[k]
        if self.tangents and k.size:
            self.tangents.keep_peak(self, float(time[0]), float(rate[0]), series)

    def update_peak_within(self, series: Floats, tau: Floats) -> None:
        """The greatest speed within a step, where the net moment falls through zero."""
        roles = self.program.roles
        x = series[roles["x"]]
        omega = series[roles["omega"]]
        net = series[roles["net"], :-1]
        at = self._peak_time(net, tau)
        k = np.flatnonzero(np.isfinite(at))
        if k.size:
            speed, distance, rate = (np.zeros(self.count) for _ in range(3))
            for values, of in ((speed, omega), (distance, x), (rate, net)):
                values[k] = value(of[:, k], at[k])
            self._keep_faster(speed, self.time + at, distance, rate, series)

    def _peak_time(self, net: Floats, tau: Floats) -> Floats:
        """When the net moment falls through zero, at first or beyond a trough; infinite where it does not."""
        rate = value(net, tau)
        slope = value(derivative(net), tau)
        at_zero = net[0] == 0.0
        drives = (net[0] > 0.0) | (at_zero & (net[1] > 0.0))
        at = np.full(self.count, np.inf)
        falls = np.flatnonzero(drives & ((rate < 0.0) | ((net[1] < 0.0) & (slope > 0.0))))
        if falls.size:
            at[falls] = first_root(divided_by_time(net, at_zero)[:, falls], tau[falls])
        hump = np.flatnonzero((net[0] < 0.0) & (net[1] > 0.0) & (rate < 0.0) & (slope < 0.0))
        if hump.size:
            part = net[:, hump]
            slopes = derivative(net[:, hump])
            top = bracketed_root(slopes, np.zeros(hump.size), slopes[0], tau[hump], slope[hump])
            greatest = value(part, top)
            root = bracketed_root(part, top, greatest, tau[hump], rate[hump])
            at[hump] = np.where(greatest > 0.0, root, np.inf)
        return at

    def update_reach(self) -> None:
        """Where the lane is now may be farthest from its start."""
        rotation = self.rotation + self.direction * self.x
        k = np.flatnonzero(np.abs(rotation) > np.abs(self.reach_rotation))
        self.reach_time[k] = self.time[k]
        self.reach_rotation[k] = rotation[k]
        if self.tangents and k.size:
            self.tangents.keep_reach(self)

    # --- events ------------------------------------------------------------------------------------------------------

    def note(self, kind: int) -> None:
        """Write an event of lane 0 down."""
        if self.log is not None and self.lanes[0] == 0:
            self.log.append((kind, float(self.time[0]), float(self.rotation[0]), float(self.direction[0])))

    def note_lift_off(self) -> None:
        """Contact with the slip surface is lost."""
        self.note(ix.NOTE_LIFTS)
        self.lift_time = np.where(np.isnan(self.lift_time), self.time, self.lift_time)

    # --- samples -----------------------------------------------------------------------------------------------------

    def read_samples(self, begin: Floats, end: Floats, series: Floats | None = None) -> None:
        """States at the sample times from one time up to, and without, another; without series the lanes rest."""
        if self.samples is None:
            return
        for lane in range(self.count):
            times = self.samples.times[:, self.lanes[lane]]
            closed = np.isfinite(end[lane]) and end[lane] >= self.end_time[lane]
            first = np.searchsorted(times, begin[lane])
            last = np.searchsorted(times, end[lane], side="right" if closed else "left")
            if last > first:
                past = times[first:last] - begin[lane]
                states = self._states_at_rest(lane) if series is None else self._states_along(lane, series, past)
                self.samples.states[:, first:last, self.lanes[lane]] = states

    def _further_states(self) -> Any:
        """Those beside rotation and speed that samples have rows for."""
        assert self.samples is not None
        return self.program.states[2 : len(self.samples.states) - 2]

    def _states_at_rest(self, lane: int) -> Floats:
        further = [self.cells[cell, lane] for cell, _, _ in self._further_states()]
        return np.array([self.rotation[lane], 0.0, 0.0, self.slip[lane], *further])[:, None]

    def _states_along(self, lane: int, series: Floats, past: Floats) -> Any:
        roles = self.program.roles
        direction = self.direction[lane]
        registers = [roles["x"], roles["omega"], roles["net"], *(register for _, register, _ in self._further_states())]
        x, omega, net, *further = (value(series[register, :, lane, None], past) for register in registers)
        return self.rotation[lane] + direction * x, direction * omega, direction * net, self.slip[lane] + x, *further
