"""Records of a motion: greatest speed and rotation, events, and states at sample times."""

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.polynomials import bracketed_root, derivative, divided_by_time, first_root, value

Floats = NDArray[np.float64]


class Recorder(LaneState):
    """Lanes with records of extremes, events and samples."""

    # --- the greatest speed and rotation -----------------------------------------------------------------------------

    def update_peak(self, rate: Floats) -> None:
        """Record the present speed, at the start of a phase or the end of a step, if it is the greatest."""
        self._keep_faster(self.omega, self.time, self.x, rate)

    def _keep_faster(self, speed: Floats, time: Floats, x: Floats, rate: Floats, series: Floats | None = None) -> None:
        """Record a candidate for the greatest speed if it exceeds the record."""
        faster = np.flatnonzero(speed > np.abs(self.peak_omega))
        direction = self.direction[faster]
        travelled = direction * x[faster]
        self.peak_time[faster] = time[faster]
        self.peak_rotation[faster] = self.rotation[faster] + travelled
        self.peak_omega[faster] = direction * speed[faster]
        self.peak_rate[faster] = direction * rate[faster]
        if self.tangents and faster.size:
            peak_time = float(time[0])
            peak_rate = float(rate[0])
            self.tangents.keep_peak(self, peak_time, peak_rate, series)

    def update_peak_within(self, series: Floats, tau: Floats) -> None:
        """Record the greatest speed within a step, where the net moment falls through zero."""
        roles = self.program.roles
        net = series[roles["net"], :-1]
        at = self._peak_time(net, tau)
        peaks = np.isfinite(at)
        if not np.any(peaks):
            return
        inside = np.where(peaks, at, 0.0)
        distance = value(series[roles["x"]], inside)
        rate = value(net, inside)
        speed = value(series[roles["omega"]], inside)
        speed = np.where(peaks, speed, 0.0)
        self._keep_faster(speed, self.time + inside, distance, rate, series)

    def _peak_time(self, net: Floats, tau: Floats) -> Floats:
        """Time at which the net moment falls through zero, possibly after a maximum; infinite without one."""
        at = np.full(self.count, np.inf)
        rate = value(net, tau)
        slope = value(derivative(net), tau)
        at_zero = net[0] == 0.0
        drives = (net[0] > 0.0) | (at_zero & (net[1] > 0.0))
        dips = (net[1] < 0.0) & (slope > 0.0)
        falls = np.flatnonzero(drives & ((rate < 0.0) | dips))
        if falls.size:
            positive = divided_by_time(net, at_zero)[:, falls]
            at[falls] = first_root(positive, tau[falls])
        rises_first = (net[0] < 0.0) & (net[1] > 0.0)
        hump = np.flatnonzero(rises_first & (rate < 0.0) & (slope < 0.0))
        if hump.size:
            at[hump] = _root_beyond_hump(net[:, hump], tau[hump], rate[hump], slope[hump])
        return at

    def update_reach(self) -> None:
        """Record the present rotation if it is the greatest."""
        rotation = self.rotation + self.direction * self.x
        farther = np.flatnonzero(np.abs(rotation) > np.abs(self.reach_rotation))
        self.reach_time[farther] = self.time[farther]
        self.reach_rotation[farther] = rotation[farther]
        if self.tangents and farther.size:
            self.tangents.keep_reach(self)

    # --- events ------------------------------------------------------------------------------------------------------

    def note(self, kind: int) -> None:
        """Log an event of lane 0."""
        if self.log is not None and self.lanes[0] == 0:
            self.log.append((kind, float(self.time[0]), float(self.rotation[0]), float(self.direction[0])))

    def note_lift_off(self) -> None:
        """Contact with the slip surface is lost."""
        self.note(ix.NOTE_LIFTS)
        self.lift_time = np.where(np.isnan(self.lift_time), self.time, self.lift_time)

    # --- samples -----------------------------------------------------------------------------------------------------

    def read_samples(self, begin: Floats, end: Floats, series: Floats | None = None) -> None:
        """Evaluate states at the sample times in a half-open interval; without series the lanes rest."""
        if self.samples is None:
            return
        for lane, column in enumerate(self.lanes):
            times = self.samples.times[:, column]
            closed = np.isfinite(end[lane]) and end[lane] >= self.end_time[lane]
            side: Literal["left", "right"] = "right" if closed else "left"
            first = np.searchsorted(times, begin[lane])
            last = np.searchsorted(times, end[lane], side)
            if last <= first:
                continue
            since = times[first:last] - begin[lane]
            self.samples.states[:, first:last, column] = self._states_since(lane, series, since)

    def _states_since(self, lane: int, series: Floats | None, since: Floats) -> Any:
        """Rotation, angular velocity, its rate, slip and further states of a lane, at times since the step began."""
        assert self.samples is not None
        roles = self.program.roles
        further_rows = len(self.samples.states) - 4
        further_states = self.program.states[2 : 2 + further_rows]
        if series is None:
            x = omega = net = np.zeros(since.size)
            further = [np.full(since.size, self.cells[cell, lane]) for cell, _, _ in further_states]
        else:
            registers = [roles["x"], roles["omega"], roles["net"]]
            registers += [register for _, register, _ in further_states]
            x, omega, net, *further = (value(series[register, :, lane, None], since) for register in registers)
        direction = self.direction[lane]
        rotation = self.rotation[lane] + direction * x
        slip = self.slip[lane] + x
        return rotation, direction * omega, direction * net, slip, *further


def _root_beyond_hump(net: Floats, tau: Floats, rate: Floats, slope: Floats) -> Floats:
    """Falling zero of polynomials that are negative at both ends with a maximum between; infinity without one."""
    start = np.zeros(tau.size)
    slopes = derivative(net)
    top = bracketed_root(slopes, start, slopes[0], tau, slope)
    greatest = value(net, top)
    root = bracketed_root(net, top, greatest, tau, rate)
    return np.where(greatest > 0.0, root, np.inf)
