"""A motion as few points in time between which cubics are accurate: what the live page interpolates.

Velocity is the cubic Hermite polynomial of the velocities and accelerations at both ends of an interval, displacement
that of the displacements, which are integrals of the cubics of the velocity, and of the velocities. Intervals are
divided until they are accurate, or there is no room for more points.
"""

import base64
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats
from slipcircle.core import ANSWERED, Motion
from slipcircle.tables import in_time

TOLERANCE = 8e-7  # of the greatest velocity
_FIRST = 17  # equidistant times at the start
_BESIDE = 1e-7  # of the duration, before and after a jump of the acceleration
_DIVISIONS = 24
_FEW = 100  # times at which what varies in time may jump; more are samples of a record, which only bends there
_INTEGERS = "<i4", "<i4", "<i2"  # that hold times, velocities and accelerations in a page
BYTES = 14  # of a point in a page, in base64


class Interpolant(NamedTuple):
    """Points of a motion, SI units, and the error of cubics between them as a share of the greatest values."""

    times: Floats
    velocity: Floats
    acceleration: Floats
    error: float

    @property
    def displacement(self) -> Floats:
        """The integral of the cubics of the velocity."""
        step = np.diff(self.times)
        mean_velocity = (self.velocity[1:] + self.velocity[:-1]) / 2
        correction = step**2 / 12 * np.diff(self.acceleration)
        return np.concatenate([[0.0], np.cumsum(step * mean_velocity - correction)])

    def encoded(self) -> tuple[list[str], list[float]]:
        """Times, velocities and accelerations as integers in base64, and their units."""
        columns, units = [], []
        for values, kind in zip(self[:3], _INTEGERS, strict=True):
            ticks, unit = _ticks(values, kind)
            columns.append(base64.b64encode(ticks.tobytes()).decode())
            units.append(unit)
        return columns, units


def interpolant(motion: Motion, most: int) -> Interpolant:
    """At most so many points of a motion; a single one at rest, and where there is no result."""
    if motion.status not in ANSWERED or not motion.moves:
        nothing = np.zeros(1)
        return Interpolant(nothing, nothing, nothing, 0.0)
    times, bends = _first_times(motion)
    for _ in range(_DIVISIONS):
        points = _at(motion, times)
        errors = _velocity_errors(motion, points)
        room = max(most - times.size, 0)
        worst = np.argsort(-errors)[:room]
        divided = worst[errors[worst] > TOLERANCE]
        if not divided.size:
            break
        times = np.union1d(times, _dividing_times(times, divided, bends))
    times, velocity, acceleration = map(_rounded, _at(motion, times)[:3], _INTEGERS)
    points = Interpolant(times, velocity, acceleration, 0.0)
    greatest_displacement = abs(float(motion.reach.displacement)) or 1.0
    displacement_errors = np.abs(points.displacement - motion.at(times).displacement)
    of_displacement = np.max(displacement_errors) / greatest_displacement
    of_velocity = np.max(_velocity_errors(motion, points))
    return points._replace(error=float(max(of_velocity, of_displacement)))


def _ticks(values: Floats, kind: str) -> tuple[Any, float]:
    """Values as integers of a kind, and their unit."""
    unit = float(np.max(np.abs(values))) / np.iinfo(kind).max or 1.0
    return np.rint(values / unit).astype(kind), unit


def _rounded(values: Floats, kind: str) -> Floats:
    """Values as the integers of a page hold them."""
    ticks, unit = _ticks(values, kind)
    return np.asarray(ticks * unit)


def hermite(times: Floats, values: Floats, slopes: Floats, at: Floats) -> Floats:
    """The piecewise cubic with values and slopes at increasing times, at other times between the first and the last."""
    last = np.clip(np.searchsorted(times, at), 1, times.size - 1)
    first = last - 1
    start = times[first]
    step = times[last] - start
    share = (at - start) / step
    rest = 1.0 - share
    weight_first = rest**2 * (1.0 + 2.0 * share)
    weight_last = share**2 * (1.0 + 2.0 * rest)
    slope_first = rest * slopes[first]
    slope_last = share * slopes[last]
    from_values = weight_first * values[first] + weight_last * values[last]
    from_slopes = share * rest * (slope_first - slope_last)
    return np.asarray(from_values + step * from_slopes)


def _at(motion: Motion, times: Floats) -> Interpolant:
    """Points of a motion at these times."""
    state = motion.at(times)
    return Interpolant(times, state.velocity, state.acceleration, 0.0)


def _velocity_errors(motion: Motion, points: Interpolant) -> Floats:
    """Greatest error of each cubic at three times within its interval, as a share of the greatest velocity."""
    quarters = np.linspace(points.times[:-1], points.times[1:], 5)
    between = quarters[1:-1]
    times = np.ravel(between)
    cubic = hermite(points.times, points.velocity, points.acceleration, times)
    errors = np.abs(cubic - motion.at(times).velocity)
    largest = np.max(errors.reshape(between.shape), axis=0)
    greatest_velocity = abs(float(motion.peak.velocity)) or 1.0
    return np.asarray(largest / greatest_velocity)


def _dividing_times(times: Floats, divided: NDArray[np.intp], bends: Floats) -> Floats:
    """The bend next to the middle of each divided interval, or its middle where the interval has none."""
    start = times[divided]
    end = times[divided + 1]
    middle = (start + end) / 2
    position = np.searchsorted(bends, middle)
    next_bend = np.clip(position, 1, bends.size - 1)
    before = bends[next_bend - 1]
    after = bends[next_bend]
    nearest = np.where(middle - before < after - middle, before, after)
    is_inside = (start < nearest) & (nearest < end)
    return np.where(is_inside, nearest, middle)


def _first_times(motion: Motion) -> tuple[Floats, Floats]:
    """Equidistant times with both sides of each possible jump of the acceleration, and times at which it may bend."""
    duration = float(motion.settling_time)
    jumps, bends = [0.0, duration], [np.array([0.0, duration])]
    for phase in motion.phases:
        jumps += [phase.start, phase.end]
    for function in in_time(motion.plan.scene.called).values():
        times = np.clip(function.kinks, 0.0, duration)
        if times.size < _FEW:
            jumps += times.tolist()
        else:
            bends.append(times)
    beside = _BESIDE * duration
    before = np.array(jumps) - beside
    every = np.concatenate([np.linspace(0.0, duration, _FIRST), before, before + 2 * beside])
    return np.unique(np.clip(every, 0.0, duration)), np.unique(np.concatenate(bends))
