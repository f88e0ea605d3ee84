"""Response spectra of records, and how far they are from a target spectrum."""

import math
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.base.series import Series

Floats = NDArray[np.float64]
Spectrum = tuple[ArrayLike, ArrayLike]  # periods, s, and accelerations over gravity at a damping of 5 %
DAMPING = 0.05  # of the critical one
_SAMPLES = 40  # of a period, at least: the greatest one of them is within 0.4 % of the peak


def response_spectrum(record: Series, periods: ArrayLike, damping: float = DAMPING) -> Floats:
    """Pseudo-spectral accelerations of damped oscillators over gravity, omega^2 times the peak relative displacement.

    Exact at the samples of evenly spaced records, whose accelerations are straight between them (Nigam and Jennings
    1969); the record is followed by two periods of free oscillation.

    Parameters
    ----------
    record : Series
        Acceleration over gravity, evenly spaced.
    periods : array_like
        Of the undamped oscillators, s.
    damping : float, optional
        Over the critical one.

    Returns
    -------
    ndarray
        Of the shape of `periods`.
    """
    from scipy import signal

    step = float(record.time[-1] - record.time[0]) / (record.time.size - 1)
    flat = np.ravel(np.asarray(periods, dtype=np.float64))
    peaks = np.empty(flat.size)
    for k, period in enumerate(flat.tolist()):
        finer = math.ceil(_SAMPLES * step / period)
        fine_step = step / finer
        count = finer * (record.time.size - 1) + math.ceil(2.0 * period / fine_step)
        acceleration = record(record.time[0] + fine_step * np.arange(count))
        response = signal.lfilter(*_recursion(period, fine_step, damping), acceleration)
        peaks[k] = np.max(np.abs(response))
    return peaks.reshape(np.shape(periods))


@lru_cache(maxsize=1024)
def _recursion(period: float, step: float, damping: float) -> tuple[Floats, Floats]:
    """Coefficients of the recursion that is exact for an oscillator under straight lines between even samples."""
    from scipy import signal

    omega = 2.0 * math.pi / period
    oscillator = [omega**2], [1.0, 2.0 * damping * omega, omega**2]
    numerator, denominator, _ = signal.cont2discrete(oscillator, step, "foh")
    return numerator.ravel(), denominator


def resampled(spectrum: Spectrum, count: int = 30) -> tuple[Floats, Floats]:
    """A spectrum at so many periods, equally far apart on a logarithmic axis, between which it is a power."""
    periods, accelerations = np.asarray(spectrum, dtype=np.float64)
    log_periods = np.log(periods)
    even = np.linspace(log_periods[0], log_periods[-1], count)
    return np.exp(even), np.exp(np.interp(even, log_periods, np.log(accelerations)))


def misfit(record: Series, target: Spectrum) -> float:
    """Root mean square of the logarithm of a record's spectrum over a target, at periods spread over the target's."""
    periods, accelerations = resampled(target)
    ratios = response_spectrum(record, periods) / accelerations
    return float(np.sqrt(np.mean(np.log(ratios) ** 2)))
