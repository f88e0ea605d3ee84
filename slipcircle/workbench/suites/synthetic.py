"""Synthetic records: filtered noise with a given Arias intensity and duration."""

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from slipcircle.base.arrays import INFINITY
from slipcircle.base.errors import mistakes, one_number, raise_all
from slipcircle.base.kinds import PathName
from slipcircle.tables import Series
from slipcircle.workbench.common import files
from slipcircle.workbench.common.distributions import special
from slipcircle.workbench.suites.intensities import intensities

_SHAPE = 3.0  # of the gamma distribution of the intensity over time (Saragoni and Hart 1974)
_STEP = 0.01  # s
_GROUND, _DAMPING = 2.5, 0.6  # Hz; of the soil that filters the noise (Kanai 1957, Tajimi 1960)
_SLOWEST = 0.15  # Hz, below which the amplitudes fall
_ALLOWED = {
    "count": one_number(0.0, 1e4, "a number of records"),
    "arias": one_number(0.0, INFINITY, "a positive number in m/s"),
    "duration": one_number(0.1, 1e3, "a time in s"),
    "gravity": one_number(0.0, INFINITY, "a positive number in m/s^2"),
    "seed": one_number(-1.0, INFINITY, "a whole number of at least 0"),
}


def synthetic_records(
    count: int, arias: float = 1.0, duration: float = 12.0, seed: int = 0, gravity: float = 9.81
) -> dict[str, Series]:
    """Return synthetic records by name: filtered noise under an envelope, not specific to a site or earthquake.

    White noise is filtered by a damped soil layer (Kanai 1957, Tajimi 1960; 2.5 Hz, damping 0.6), cut off below
    0.15 Hz, and scaled in time with the density of a gamma distribution (Saragoni and Hart 1974).

    Parameters
    ----------
    count : int
        Number of records.
    arias : float, optional
        Arias intensity of each record, m/s; it is met exactly.
    duration : float, optional
        Significant duration from 5 to 95 % of the Arias intensity, s; it is reached in the mean of many records.
    seed : int, optional
        Seed of the random numbers; a larger count begins with the same records.
    gravity : float, optional
        Acceleration of gravity, m/s^2.

    Returns
    -------
    dict of str to Series
        Driving accelerations over gravity by name, ``"synthetic 1"``, ..., every 0.01 s.

    Raises
    ------
    ValueError
        If an argument is out of bounds; the message names each.

    Examples
    --------
    >>> from slipcircle import ensemble, load, synthetic_records
    >>> study = ensemble(load("newmark-pulse"), records=synthetic_records(3, 1.5), polarities=True)
    >>> study.displacement.shape
    (3, 2, 1, 1)
    """
    arguments = {"count": count, "arias": arias, "duration": duration, "gravity": gravity, "seed": seed}
    raise_all("synthetic records", mistakes(arguments, _ALLOWED))
    noises = [_noise(np.random.default_rng(stream), duration) for stream in np.random.SeedSequence(seed).spawn(count)]
    scales = [math.sqrt(arias / intensities(noise, gravity).arias) for noise in noises]
    return {f"synthetic {k}": noises[k - 1].scaled(scales[k - 1]) for k in range(1, len(noises) + 1)}


def _noise(rng: np.random.Generator, duration: float) -> Series:
    """Return filtered white noise under the envelope, not yet scaled, for a significant duration in s."""
    first, last, longest = special().gammaincinv(_SHAPE, [0.05, 0.95, 0.9995]).tolist()
    scale = duration / (last - first)
    count = math.ceil(scale * longest / _STEP)
    time = np.asarray(_STEP * np.arange(count), float)
    scaled = time / scale
    density = np.exp(special().xlogy(_SHAPE - 1.0, scaled) - scaled - special().gammaln(_SHAPE))
    noise = np.fft.rfft(rng.normal(size=count))
    # The amplitudes of the soil filter at frequencies in Hz, with low frequencies suppressed.
    frequencies = np.fft.rfftfreq(count, _STEP).astype(float)
    ratio = frequencies / _GROUND
    damped = (2.0 * _DAMPING * ratio) ** 2
    amplitude = np.sqrt((1.0 + damped) / ((1.0 - ratio**2) ** 2 + damped))
    filtered = np.fft.irfft(noise * (amplitude * (frequencies**2 / (frequencies**2 + _SLOWEST**2))), count)
    return Series(time, np.sqrt(density) * filtered, held=False)


def write_records(records: Mapping[str, Series], folder: PathName) -> None:
    """Write driving accelerations into a folder, as tables of time and ground acceleration (opposite sign).

    The folder is created if necessary. `read_suite` reads the same records from it, in the same order, bit for bit.
    """
    place = Path(folder)
    place.mkdir(exist_ok=True)
    digits = max(4, len(str(len(records))))  # three would read as an azimuth
    for number, record in enumerate(records.values(), 1):
        rows = zip(record.time.tolist(), (0.0 - record.values).tolist(), strict=True)
        files.write_file(
            place / f"synthetic-{number:0{digits}d}.csv", files.csv_table(["time (s)", "acceleration (g)"], rows)
        )
