"""Intensity measures and spectral accelerations of a record, integrated exactly between its samples."""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from slipcircle.base.kinds import ArrayPair, ArrayTriple, Floats
from slipcircle.base.text import amount_text
from slipcircle.tables import Series

_DRIFT = 0.05  # of the peak velocity
_LONGEST = 2**24  # samples of a spectrum, for any time step
_BAND = 0.25, 20.0  # Hz, of the mean period
_RESOLUTION = 0.05  # Hz, at most, of its spectrum
_DAMPING = 0.05  # of an oscillator, over the critical one
_STEPS_OF_PERIOD = 100  # of an oscillator: a peak between them is too small by 5e-4 at most


class Intensities(NamedTuple):
    """Intensity measures of a record.

    Attributes
    ----------
    pga : float
        Peak acceleration over gravity.
    pgv : float
        Peak velocity, m/s: the greatest integral of the acceleration, without any correction of the base line.
    arias : float
        Arias intensity, pi/(2 g) times the integral of the square of the acceleration, m/s.
    duration : float
        Significant duration, s, in which the Arias intensity grows from 5 to 95 %.
    mean_period : float
        Mean period of Rathje, Abrahamson and Bray (1998), s: periods weighted with the squares of the Fourier
        amplitudes from 0.25 to 20 Hz.
    """

    pga: float
    pgv: float
    arias: float
    duration: float
    mean_period: float


def intensities(record: Series, gravity: float = 9.81) -> Intensities:
    """Return the intensity measures of a record over gravity; for a zero record they are 0 and the mean period NaN."""
    time, values = _with_zeros(record)
    steps = np.diff(time)
    before, after = values[:-1], values[1:]
    velocity = gravity * _velocity(time, values)
    mean_squares = (before**2 + before * after + after**2) / 3.0
    squares = np.concatenate([[0.0], np.cumsum(steps * mean_squares)])
    total = float(squares[-1])
    arias = math.pi / 2.0 * gravity * total
    duration = 0.0
    if total > 0.0:
        first, last = np.interp((0.05 * total, 0.95 * total), squares, time)
        duration = float(last - first)
    return Intensities(record.greatest, float(np.max(np.abs(velocity))), arias, duration, _mean_period(record))


def drift_warning(record: Series, gravity: float = 9.81) -> str:
    """Return a warning if the velocity of a record at its end exceeds 5 % of its peak; otherwise an empty text.

    The record is over gravity, which is in m/s^2.
    """
    velocity = gravity * np.abs(_velocity(*_with_zeros(record)))
    end, peak = float(velocity[-1]), float(np.max(velocity))
    if not end > _DRIFT * peak:
        return ""
    drift = f"drifts: its velocity at the end is {amount_text(end, 'm/s', 3)}, {100 * end / peak:.3g} % of its peak"
    return f"{drift}; correct its base line, or take the corrected record"


def _velocity(time: Floats, values: Floats) -> Floats:
    """Return the integral of the acceleration from the start to each time but the first, (times - 1,).

    Times are in s; accelerations are over gravity, so that velocities are as well.
    """
    return np.cumsum(np.diff(time) * ((values[:-1] + values[1:]) / 2.0))


def _with_zeros(record: Series) -> ArrayPair:
    """Return times in s and accelerations over gravity, with a sample added at each zero between samples.

    The velocity peaks there.
    """
    time, values = record.time, record.values
    before, after = values[:-1], values[1:]
    crosses = np.flatnonzero(before * after < 0.0)
    zeros = time[:-1] + (before / np.where(before == after, 1.0, before - after)) * np.diff(time)
    places = crosses + 1
    return np.insert(time, places, zeros[crosses]), np.insert(values, places, 0.0)


def _mean_period(record: Series) -> float:
    """Return the mean period in s from evenly spaced samples, padded with zeros to the spectrum's resolution."""
    count = record.time.size
    times, step = np.linspace(record.time[0], record.time[-1], count, retstep=True)
    length = max(count, min(math.ceil(1.0 / (_RESOLUTION * step)), _LONGEST))
    amplitudes = np.abs(np.fft.rfft(record(times), length))
    frequencies = np.fft.rfftfreq(length, step)
    lowest, highest = _BAND
    inside = (frequencies >= lowest) & (frequencies <= highest)
    weights = amplitudes[inside] ** 2
    if not np.any(weights):
        return math.nan
    return float(np.average(1.0 / frequencies[inside], weights=weights))


def spectral_acceleration(record: Series, period: float) -> float:
    """Return the pseudo-acceleration over gravity of a record at a period, for a damping ratio of 5 %.

    It is the greatest displacement of an oscillator times the square of its angular frequency. The acceleration is
    linear between samples, so that a first-order hold is exact (Nigam and Jennings 1969).

    Parameters
    ----------
    record : Series
        Acceleration over gravity, zero before and after; samples at uneven times are interpolated at even ones.
    period : float
        Natural period, s.
    """
    first = float(record.time[0])
    last = float(record.time[-1])
    intervals = record.time.size - 1
    refinement = math.ceil((last - first) / intervals * _STEPS_OF_PERIOD / period)
    times, step = np.linspace(first, last, intervals * refinement + 1, retstep=True)
    at_rest = np.zeros(math.ceil(1.5 * period / step))  # the oscillation may be greatest after the end
    acceleration = np.concatenate([record(times), at_rest])
    frequency = 2.0 * math.pi / period
    # The displacement u at even times of an oscillator from rest: u'' + 2 zeta omega u' + omega^2 u = -a.
    from scipy.signal import lfilter

    weights, recurrence, at_start = _recurrence(float(step), frequency)
    displacement, _ = lfilter(weights, recurrence, acceleration, zi=at_start * acceleration[0])
    return float(frequency**2 * np.max(np.abs(displacement)))


@lru_cache(maxsize=1024)
def _recurrence(step: float, frequency: float) -> ArrayTriple:
    """Return numerator, denominator and initial state of a filter from ground accelerations to displacements.

    The filter is an oscillator's: the time step is in s and the angular frequency in rad/s. Both polynomials begin with
    the latest sample, and the state is for a first acceleration of 1.
    """
    from scipy.signal import cont2discrete, ss2tf

    free = np.array([[0.0, 1.0], [-(frequency**2), -2.0 * _DAMPING * frequency]])
    by_ground = np.array([[0.0], [-1.0]])
    both, none = np.eye(2), np.zeros((2, 1))
    over_step, by_last, _, at_once, _ = cont2discrete((free, by_ground, both, none), step, "foh")
    weights, recurrence = ss2tf(over_step, by_last, both, at_once)
    first, second = -at_once[0, 0], -(over_step @ at_once)[0, 0]  # the ground may jump
    return weights[0], recurrence, np.array([first, second + recurrence[1] * first])
