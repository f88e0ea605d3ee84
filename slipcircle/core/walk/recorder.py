"""Records of a motion: greatest speed and rotation, events, and states at sample times."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.walk.lane_state import LaneState
from slipcircle.core.walk.polynomials import (
    bracketed_root,
    derivative,
    divided_by_time,
    first_root,
    value,
    value_and_slope,
)


class _Sampled(NamedTuple):
    """Sample times of a lane, since some time, and its states there, (states, times), to be filled."""

    lane: int
    since: Floats
    states: Floats


class Recorder(LaneState):
    """Lanes with records of extremes, events and samples."""

    @property
    def roles(self) -> Mapping[str, int]:
        """Cells and registers by the role that they play."""
        return self.program.roles

    def net_moment(self, series: Floats) -> Floats:
        """Series of the rate of the speed."""
        return series[self.roles["net"]]

    # --- the greatest speed and rotation -----------------------------------------------------------------------------

    def update_peak(self, rate: Floats) -> None:
        """Record the present speed, at the start of a phase or the end of a step, if it is the greatest."""
        exceeded = self.keep_faster(self.time, self.x, self.omega, rate)
        if exceeded and self.tangents:
            self.tangents.keep_peak(float(rate[0]))

    def update_peak_within(self, series: Floats, tau: Floats) -> None:
        """Record the greatest speed within a step, where the net moment falls through zero."""
        roles = self.roles
        net = self.net_moment(series)
        time = self._peak_time(net, tau)
        peaks = np.isfinite(time)
        if not np.any(peaks):
            return
        since = np.where(peaks, time, 0.0)
        x = value(series[roles["x"]], since)
        omega = value(series[roles["omega"]], since)
        speed = np.where(peaks, omega, 0.0)
        rate = value(net, since)
        at_peak = self.time + since
        exceeded = self.keep_faster(at_peak, x, speed, rate)
        if exceeded and self.tangents:
            self.tangents.keep_peak_within(series, float(since[0]))

    def keep_faster(self, time: Floats, x: Floats, speed: Floats, rate: Floats) -> bool:
        """Record a candidate for the greatest speed where it exceeds the record; whether it does in any lane."""
        faster = speed > np.abs(self.peak_omega)
        if not np.any(faster):
            return False
        candidate = {
            ix.PEAK_TIME: time,
            ix.PEAK_ROTATION: self.rotation_after(x),
            ix.PEAK_OMEGA: self.direction * speed,
            ix.PEAK_RATE: self.direction * rate,
        }
        self._set(faster, candidate)
        return True

    def rotation_after(self, x: Floats) -> Floats:
        """Rotation after some way since the phase began, signed."""
        return self.rotation + self.direction * x

    def _set(self, lanes: Any, entries: Mapping[int, Floats]) -> None:
        """Set entries of some of the lanes."""
        for row, values in entries.items():
            self.cells[row, lanes] = values[lanes]

    def _peak_time(self, net: Floats, tau: Floats) -> Floats:
        """Time at which the net moment falls through zero, possibly after a maximum; infinite without one."""
        first = net[0]
        first_slope = net[1]
        last, last_slope = value_and_slope(net, tau)
        ends_below = last < 0.0
        rises = first_slope > 0.0
        from_zero = first == 0.0
        drives = (first > 0.0) | (from_zero & rises)
        dips = (first_slope < 0.0) & (last_slope > 0.0)
        falls = drives & (ends_below | dips)
        time = np.full(self.count, np.inf)
        if np.any(falls):
            ahead = divided_by_time(net, from_zero)
            falling = ahead[:, falls]
            time[falls] = first_root(falling, tau[falls])
        has_hump = rises & (last_slope < 0.0)
        from_below = has_hump & (first < 0.0) & ends_below
        if np.any(from_below):
            polynomials = net[:, from_below]
            time[from_below] = _root_beyond_hump(polynomials, tau[from_below])
        return time

    def update_reach(self) -> None:
        """Record the present rotation if it is the greatest."""
        rotation = self.rotation_after(self.x)
        farther = np.abs(rotation) > np.abs(self.reach_rotation)
        if not np.any(farther):
            return
        self._set(farther, {ix.REACH_TIME: self.time, ix.REACH_ROTATION: rotation})
        if self.tangents:
            self.tangents.keep_reach()

    # --- events ------------------------------------------------------------------------------------------------------

    def note(self, kind: int) -> None:
        """Log an event of lane 0."""
        if self.log is not None and self.lanes[0] == 0:
            rows = [ix.TIME, ix.ROTATION, ix.DIRECTION]
            time, rotation, direction = self.cells[rows, 0].tolist()
            self.log.append((kind, time, rotation, direction))

    def note_lift_off(self) -> None:
        """Contact with the slip surface is lost."""
        self.note(ix.NOTE_LIFTS)
        is_first = np.isnan(self.lift_time)
        self.lift_time = np.where(is_first, self.time, self.lift_time)

    # --- samples -----------------------------------------------------------------------------------------------------

    def samples_between(self, begin: Floats, end: Floats) -> Iterator[_Sampled]:
        """The samples of each lane in a half-open interval of time; the end time belongs to the last one."""
        if self.samples is None:
            return
        for lane, column in enumerate(self.lanes):
            until = end[lane]
            times = self.samples.times[:, column]
            first = np.searchsorted(times, begin[lane])
            last = np.searchsorted(times, until)
            if self.end_time[lane] <= until < np.inf:
                last = np.searchsorted(times, until, side="right")
            if first < last:
                since = times[first:last] - begin[lane]
                states = self.samples.states[:, first:last, column]
                yield _Sampled(lane, since, states)

    def read_samples(self, begin: Floats, end: Floats, series: Floats | None = None) -> None:
        """Evaluate states at the sample times in an interval; without series the lanes rest."""
        if self.samples is None:
            return
        if series is None:
            series = self._started(0)
        roles = self.roles
        further_states = self.program.states[2:]
        registers = [roles["x"], roles["omega"], roles["net"]]
        registers += [register for _, register, _ in further_states]
        for sample in self.samples_between(begin, end):
            polynomials = series[registers, :, sample.lane].T
            values = value(polynomials[:, :, None], sample.since)
            self.fill(sample, *values)

    def fill(self, sample: _Sampled, x: Floats, omega: Floats, net: Floats, *further: Floats) -> None:
        """Sample rotation, angular velocity, its rate, slip and as many further states as there are rows for."""
        direction = self.direction[sample.lane]
        rotation = self.rotation[sample.lane] + direction * x
        slip = self.slip[sample.lane] + x
        signed_omega = direction * omega
        signed_rate = direction * net
        rows = [rotation, signed_omega, signed_rate, slip, *further]
        sampled = len(sample.states)
        sample.states[:] = rows[:sampled]


def _root_beyond_hump(net: Floats, tau: Floats) -> Floats:
    """Falling zero of polynomials that are negative at both ends with a maximum between; infinity without one."""
    start = np.zeros_like(tau)
    top = bracketed_root(derivative(net), start, tau)
    greatest = value(net, top)
    root = bracketed_root(net, top, tau)
    return np.where(greatest > 0.0, root, np.inf)
