"""Intensity measures of an acceleration record, from the integrals of its straight lines."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.series import Series

Floats = NDArray[np.float64]
_BAND = 0.25, 20.0  # Hz, of the mean period
_RESOLUTION = 0.05  # Hz, at most, of its spectrum


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
    """Intensity measures of a record over gravity; of one that is zero they are 0, its mean period NaN."""
    time, values = _with_zeros(record)
    steps, before, after = np.diff(time), values[:-1], values[1:]
    velocity = gravity * np.cumsum(steps * (before + after) / 2.0)
    squares = np.cumsum(steps * (before**2 + before * after + after**2) / 3.0)
    total = float(squares[-1])
    duration = 0.0
    if total > 0.0:
        first, last = np.interp((0.05 * total, 0.95 * total), np.concatenate([[0.0], squares]), time)
        duration = float(last - first)
    pgv = float(np.max(np.abs(velocity)))
    return Intensities(record.greatest, pgv, math.pi / 2.0 * gravity * total, duration, _mean_period(record))


def _with_zeros(record: Series) -> tuple[Floats, Floats]:
    """Times and values with the places between samples where the acceleration passes zero: there the velocity peaks."""
    time, values = record.time, record.values
    crosses = np.flatnonzero(values[:-1] * values[1:] < 0.0)
    share = values[crosses] / (values[crosses] - values[crosses + 1])
    zeros = time[crosses] + share * (time[crosses + 1] - time[crosses])
    return np.insert(time, crosses + 1, zeros), np.insert(values, crosses + 1, 0.0)


def _mean_period(record: Series) -> float:
    """The mean period of evenly spaced samples, padded with zeros to the resolution of the spectrum."""
    count = record.time.size
    step = float(record.time[-1] - record.time[0]) / (count - 1)
    even = record(record.time[0] + step * np.arange(count))
    length = max(count, math.ceil(1.0 / (_RESOLUTION * step)))
    power = np.abs(np.fft.rfft(even, length)) ** 2
    frequencies = np.fft.rfftfreq(length, step)
    inside = (frequencies >= _BAND[0]) & (frequencies <= _BAND[1])
    weight = float(np.sum(power[inside]))
    return float(np.sum(power[inside] / frequencies[inside])) / weight if weight else math.nan
