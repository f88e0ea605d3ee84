"""Synthetic records: noise that swells and fades, of an Arias intensity or a response spectrum, and of a duration."""

import math
import os
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from slipcircle.base.checks import INFINITY, Bounds, mistakes, raise_all
from slipcircle.base.kinds import Floats
from slipcircle.tables import Series
from slipcircle.workbench.common import files
from slipcircle.workbench.common.distributions import statistics
from slipcircle.workbench.suites.intensities import intensities
from slipcircle.workbench.suites.spectra import Spectrum, log_ratios, resampled

_SHAPE = 3.0  # of the gamma distribution by which the intensity grows with time (Saragoni and Hart 1974)
_STEP = 0.01  # s
_GROUND, _DAMPING = 2.5, 0.6  # Hz; of the soil that filters the noise (Kanai 1957, Tajimi 1960)
_SLOWEST = 0.15  # Hz, below which there is little
_ROUNDS = 15  # of scaling Fourier amplitudes to a spectrum
_BOUNDS: dict[str, Bounds] = {
    "count": (0.0, 1e4, "a number of records"),
    "arias": (0.0, INFINITY, "a positive number in m/s"),
    "duration": (0.1, 1e3, "a time in s"),
    "gravity": (0.0, INFINITY, "a positive number in m/s^2"),
    "seed": (-1.0, INFINITY, "a whole number of at least 0"),
}


def synthetic_records(
    count: int,
    arias: float | None = None,
    duration: float = 12.0,
    seed: int = 0,
    gravity: float = 9.81,
    spectrum: Spectrum | None = None,
) -> dict[str, Series]:
    """Synthetic records: filtered noise under an envelope, which stands for no site and no earthquake.

    White noise passes the filter of a damped soil layer (Kanai 1957, Tajimi 1960; 2.5 Hz, damping 0.6), loses what is
    slower than 0.15 Hz, and grows and decays with time as a gamma distribution does (Saragoni and Hart 1974). For a
    target spectrum the Fourier amplitudes of the noise are scaled by the ratio of the target to the record's spectrum,
    15 times (Gasparini and Vanmarcke 1976); `slipcircle.workbench.suites.spectra.misfit` gives what remains, 2 to 8 %.

    Parameters
    ----------
    count : int
        Number of records.
    arias : float, optional
        Arias intensity of each record, m/s; it is met exactly. By default 1; a target spectrum excludes it.
    duration : float, optional
        Significant duration from 5 to 95 % of the Arias intensity, s; it is met in the mean of many records.
    seed : int, optional
        The same seed gives the same records, and a larger count begins with the same ones.
    gravity : float, optional
        m/s^2.
    spectrum : tuple of array_like, optional
        Target of each record: periods, s, and pseudo-spectral accelerations over gravity at a damping of 5 %.

    Returns
    -------
    dict of str to Series
        Driving accelerations over gravity by name, ``"synthetic 1"``, ..., every 0.01 s.

    Raises
    ------
    ValueError
        Names each argument out of bounds.

    Examples
    --------
    >>> from slipcircle import ensemble, load, synthetic_records
    >>> study = ensemble(load("newmark-pulse"), records=synthetic_records(3, 1.5), polarities=True)
    >>> study.displacement.shape
    (3, 2, 1, 1)
    """
    if arias is not None and spectrum is not None:
        raise ValueError("synthetic records: arias and spectrum exclude each other; leave one out")
    arias = 1.0 if arias is None else arias
    given = {"count": count, "arias": arias, "duration": duration, "gravity": gravity, "seed": seed}
    raise_all("synthetic records", mistakes(given, _BOUNDS, one=given))
    target = None if spectrum is None else resampled(spectrum)
    streams = np.random.SeedSequence(seed).spawn(count)
    noises = [_Noise(np.random.default_rng(stream), duration) for stream in streams]
    made = [noise.of_intensity(arias, gravity) if target is None else noise.matched(*target) for noise in noises]
    return {f"synthetic {k}": record for k, record in enumerate(made, 1)}


class _Noise:
    """White noise under an envelope, whose Fourier amplitudes are free."""

    def __init__(self, rng: np.random.Generator, duration: float) -> None:
        growth = statistics().gamma(_SHAPE)
        first, last = growth.ppf([0.05, 0.95])
        scale = duration / float(last - first)
        count = math.ceil(scale * float(growth.ppf(0.9995)) / _STEP)
        self.time = np.asarray(_STEP * np.arange(count), dtype=np.float64)
        self.envelope = np.sqrt(growth.pdf(self.time / scale))
        self.frequencies = np.fft.rfftfreq(count, _STEP)
        self.noise = np.fft.rfft(rng.normal(size=count))

    def record(self, amplitude: Floats) -> Series:
        """The record of which the noise has these Fourier amplitudes."""
        return Series(self.time, self.envelope * np.fft.irfft(self.noise * amplitude, self.time.size), held=False)

    @property
    def soil(self) -> Floats:
        """Fourier amplitudes behind the soil, without what is slow."""
        ratio = self.frequencies / _GROUND
        damped = (2.0 * _DAMPING * ratio) ** 2
        amplitude = np.sqrt((1.0 + damped) / ((1.0 - ratio**2) ** 2 + damped))
        slow = self.frequencies**2 / (self.frequencies**2 + _SLOWEST**2)
        return np.asarray(amplitude * slow)

    def of_intensity(self, arias: float, gravity: float) -> Series:
        """The record behind the soil, scaled to an Arias intensity."""
        record = self.record(self.soil)
        return record.scaled(math.sqrt(arias / intensities(record, gravity).arias))

    def matched(self, periods: Floats, accelerations: Floats) -> Series:
        """The record next to a spectrum among those of the iteration."""
        amplitude, least = self.soil, math.inf
        log_frequencies = np.log(np.maximum(self.frequencies, self.frequencies[1]))
        for _ in range(_ROUNDS):
            record = self.record(amplitude)
            excess = log_ratios(record, periods, accelerations)
            squares = float(np.sum(excess**2))
            if squares < least:
                best, least = record, squares
            amplitude = amplitude * np.exp(-np.interp(-log_frequencies, np.log(periods), excess))
        return best


def write_records(records: Mapping[str, Series], folder: str | os.PathLike[str]) -> None:
    """Write driving accelerations into a folder as tables of time and acceleration of the ground, their opposite.

    The folder may be new. `read_suite` reads the same records from it, in the same order and with the same bits.
    """
    place = Path(folder)
    place.mkdir(exist_ok=True)
    digits = max(4, len(str(len(records))))  # three would read as an azimuth
    for number, record in enumerate(records.values(), 1):
        rows = zip(record.time.tolist(), (0.0 - record.values).tolist(), strict=True)
        files.write(place / f"synthetic-{number:0{digits}d}.csv", files.table(["time (s)", "acceleration (g)"], rows))
