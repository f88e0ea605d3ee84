"""Target spectra: at how many periods they are compared, and how far the spectra of records are from them."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.tables import Series
from slipcircle.workbench.suites.intensities import spectral_acceleration

Spectrum = tuple[Any, Any]  # periods, s, and accelerations over gravity at a damping of 5 %
_RESOLUTION = 20  # steps of a period, from which peaks are too small by 1 % at most


def log_ratios(record: Series, periods: Floats, accelerations: Floats) -> Floats:
    """Logarithms of the pseudo-accelerations of a record over others, at periods."""
    spectrum = []
    for period in periods.tolist():
        spectrum.append(spectral_acceleration(record, period, resolution=_RESOLUTION))
    ratios = np.array(spectrum) / accelerations
    return np.log(ratios)


def resampled(spectrum: Spectrum) -> tuple[Floats, Floats]:
    """A spectrum at 30 periods, equally far apart on a logarithmic axis, between which it is a power."""
    periods, accelerations = np.log(np.asarray(spectrum, dtype=np.float64))
    even = np.linspace(periods[0], periods[-1], 30)
    between = np.interp(even, periods, accelerations)
    return np.exp(even), np.exp(between)


def misfit(record: Series, target: Spectrum) -> float:
    """Root mean square of the logarithm of a record's spectrum over a target, at periods spread over the target's."""
    ratios = log_ratios(record, *resampled(target))
    return float(np.sqrt(np.mean(ratios**2)))
