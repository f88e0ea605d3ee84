"""A motion as few points in time between which cubics are accurate: what the live page interpolates.

Displacement is the cubic Hermite polynomial of its values and of the velocities at both ends of an interval, velocity
that of its values and of the accelerations. Both are continuous; intervals are halved until they are accurate.
"""

from typing import NamedTuple

import numpy as np

from slipcircle.core import ANSWERED, Motion, in_time
from slipcircle.workbench.outputs.trace import Floats

TOLERANCE = 2e-6  # of the greatest value
_FIRST = 17  # even times at the start
_BESIDE = 1e-7  # of the duration, before and after a jump of the acceleration
_HALVINGS = 24
_FEW = 100  # times at which what is given in time may jump; more are the samples of a record, which does not
_TICKS = 100_000_000, 10_000_000, 10_000_000, 1_000_000  # of time, displacement, velocity and acceleration


class Interpolant(NamedTuple):
    """Points of a motion, SI units, and how far cubics between them are off, as a share of the greatest values."""

    times: Floats
    displacement: Floats
    velocity: Floats
    acceleration: Floats
    error: float

    def ticks(self) -> tuple[list[list[int]], list[float]]:
        """The four columns as whole numbers, and their units: how a page holds them in few bytes."""
        columns, units = [], []
        for values, most in zip(self[:4], _TICKS, strict=True):
            unit = float(np.max(np.abs(values))) / most or 1.0
            columns.append(np.rint(values / unit).astype(int).tolist())
            units.append(unit)
        return columns, units


def interpolant(motion: Motion, most: int) -> Interpolant:
    """At most so many points of a motion; at rest, and where there is no result, one."""
    if motion.status not in ANSWERED or not motion.moves:
        nothing = np.zeros(1)
        return Interpolant(nothing, nothing, nothing, nothing, 0.0)
    times = _first_times(motion, most)
    for _ in range(_HALVINGS):
        middles = (times[:-1] + times[1:]) / 2
        errors = _errors_at(motion, times, middles)
        room = max(most - times.size, 0)
        worst = np.argsort(-errors)[:room]
        halved = worst[errors[worst] > TOLERANCE]
        if not halved.size:
            break
        times = np.union1d(times, middles[halved])
    between = np.linspace(times[:-1], times[1:], 5)[1:-1]
    error = float(np.max(_errors_at(motion, times, np.ravel(between))))
    state = motion.at(times)
    return Interpolant(times, state.displacement, state.velocity, state.acceleration, error)


def hermite(times: Floats, values: Floats, slopes: Floats, at: Floats) -> Floats:
    """The piecewise cubic with values and slopes at increasing times, at other times between the first and the last."""
    last = np.clip(np.searchsorted(times, at), 1, times.size - 1)
    first = last - 1
    step = times[last] - times[first]
    share = (at - times[first]) / step
    rest = 1.0 - share
    from_first = rest**2 * (1.0 + 2.0 * share) * values[first]
    from_last = share**2 * (1.0 + 2.0 * rest) * values[last]
    from_slopes = share * rest * (rest * slopes[first] - share * slopes[last])
    return np.asarray(from_first + from_last + step * from_slopes)


def _errors_at(motion: Motion, times: Floats, others: Floats) -> Floats:
    """How far the cubics between times are off at other times, as shares of the greatest velocity and displacement."""
    known, asked = motion.at(times), motion.at(others)
    velocity = hermite(times, known.velocity, known.acceleration, others)
    displacement = hermite(times, known.displacement, known.velocity, others)
    greatest_velocity = abs(float(motion.peak.velocity)) or 1.0
    greatest_displacement = abs(float(motion.reach.displacement)) or 1.0
    of_velocity = np.abs(velocity - asked.velocity) / greatest_velocity
    of_displacement = np.abs(displacement - asked.displacement) / greatest_displacement
    return np.maximum(of_velocity, of_displacement)


def _first_times(motion: Motion, most: int) -> Floats:
    """Even times, both sides of each time at which the acceleration may jump, and kinks of records on the way."""
    duration = float(motion.duration)
    jumps, kinks = [0.0, duration], [np.linspace(0.0, duration, _FIRST)]
    for phase in motion.phases:
        jumps += np.ravel([phase.start, phase.end]).tolist()
    for function in in_time(motion.plan.scene.called).values():
        times = np.clip(function.kinks, 0.0, duration)
        times = times[motion.at(times).velocity != 0.0]
        if times.size < _FEW:
            jumps += times.tolist()
        elif times.size < most / 2:
            kinks.append(times)
    beside = _BESIDE * duration
    before = np.array(jumps) - beside
    every = np.concatenate([*kinks, before, before + 2 * beside])
    return np.unique(np.clip(every, 0.0, duration))
