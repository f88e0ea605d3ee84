"""Velocity classes of Cruden and Varnes (1996), and the time that a mass spends in each class."""

from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Flags, Floats
from slipcircle.base.sections import first_section

# Lower limits of all classes but the slowest, m/s: 16 mm/year, 1.6 m/year, 13 m/month, 1.8 m/hour, 3 m/min, 5 m/s.
LIMITS = (5e-10, 5e-8, 5e-6, 5e-4, 5e-2, 5.0)
SAMPLES = 401  # times in a phase, denser at its ends
SECTIONS = np.linspace(0.0, 1.0, 17)  # relative positions at which the interval of a crossing is divided
ROUNDS = 12


class VelocityTimes(NamedTuple):
    """Time that a mass spends in each velocity class, s."""

    extremely_slow: float
    very_slow: float
    slow: float
    moderate: float
    rapid: float
    very_rapid: float
    extremely_rapid: float


CLASSES = tuple(name.replace("_", " ") for name in VelocityTimes._fields)


def velocity_class(motion: Any) -> str:
    """Return the class of a single motion's peak velocity, such as "very rapid", or "" if the mass does not move."""
    if not motion.moves:
        return ""
    return CLASSES[int(np.searchsorted(LIMITS, motion.peak.velocity, side="right"))]


def velocity_times(motion: Any) -> VelocityTimes:
    """Return the time in s that a single motion spends in each class, by the name of the class, without standstills.

    A creeping mass counts until its settling time.
    """
    above = np.zeros(len(CLASSES) + 1)  # times above the least velocity of each class, the slowest first
    phases = motion.phases if motion.moves else ()
    share = (1.0 - np.cos(np.linspace(0.0, np.pi, SAMPLES))) / 2
    for phase in phases:
        length = phase.end - phase.start
        times = phase.start + length * share
        times = np.unique([*times, np.clip(motion.peak.time, phase.start, phase.end)])
        above[0] += length
        for place, limit in enumerate(LIMITS, 1):
            above[place] += _time_above(motion, times, limit)
    return VelocityTimes(*(above[:-1] - above[1:]).tolist())


def _time_above(motion: Any, times: Floats, limit: float) -> float:
    """Return the time in s during which a motion is faster than a limit in m/s.

    ``times`` are increasing sample times in s; only the time between the first and the last is included.
    """
    faster = _speed(motion, times) > limit
    before = faster[:-1]
    after = faster[1:]
    crosses = before != after
    whole = np.sum(np.diff(times)[before & after])
    begins_faster = before[crosses]
    start = times[:-1][crosses]
    end = times[1:][crosses]
    low = start
    high = end

    def has_passed(inside: Floats) -> Flags:
        return (_speed(motion, inside) > limit) != begins_faster

    for _ in range(ROUNDS if start.size else 0):
        low, high, _found = first_section(has_passed, low, high, SECTIONS)
    return float(whole + np.sum(np.where(begins_faster, high - start, end - high)))


def _speed(motion: Any, times: Floats) -> Floats:
    """Return the absolute velocity of a motion along the arc at times in s, m/s."""
    return np.abs(motion.at(times).velocity)
