"""Statistics of the displacements under a suite: at each scale their distribution, exceedance and sources of variance.

Displacements are arrays (record, polarity, scale, sample), m: 0 of what does not move, infinite of what moves without a
result, NaN of what is no scene. Records are the independent draws: polarities and samples of one are not.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.workbench.studies.statistics import Estimate, proportion

Floats = NDArray[np.float64]


class Distribution(NamedTuple):
    """The distribution of displacements at one scale.

    Attributes
    ----------
    moving : float
        Share of motions with a displacement.
    mean, median, p16, p84 : float
        Of all motions, m; those that do not move count as 0.
    geometric_mean, std_ln : float
        exp of the mean of ln D, m, and the standard deviation of ln D, of those that move; NaN if too few do.
    """

    moving: float
    mean: float
    median: float
    p16: float
    p84: float
    geometric_mean: float
    std_ln: float


def distribution(displacement: Floats, scale: int) -> Distribution:
    """The distribution of displacements at a scale, by its place."""
    values = displacement[:, :, scale].ravel()
    values = values[~np.isnan(values)]
    if not values.size:
        return Distribution(*(math.nan,) * 7)
    p16, median, p84 = np.quantile(values, (0.16, 0.5, 0.84), method="inverted_cdf")
    logs = np.log(values[(values > 0.0) & (values < np.inf)])
    geometric_mean = float(np.exp(logs.mean())) if logs.size else math.nan
    std_ln = float(logs.std(ddof=1)) if logs.size > 1 else math.nan
    moving = float(np.mean(values > 0.0))
    return Distribution(moving, float(values.mean()), float(median), float(p16), float(p84), geometric_mean, std_ln)


def fragility(displacement: Floats, thresholds: Floats, confidence: float = 0.95) -> list[list[Estimate]]:
    """Probabilities that displacements exceed thresholds, m, by scale and threshold.

    The intervals are those of a share of as many draws as there are records (Clopper and Pearson 1934).
    """
    records = displacement.shape[0]
    found = []
    for k in range(displacement.shape[2]):
        values = displacement[:, :, k].ravel()
        values = values[~np.isnan(values)]
        shares = np.array([np.mean(values > threshold) if values.size else np.nan for threshold in thresholds])
        lows, highs = proportion(shares * records, records, confidence)
        found.append([Estimate(*map(float, row)) for row in zip(shares, lows, highs, strict=True)])
    return found


class Shares(NamedTuple):
    """Shares of the variance of the displacement: of records, of polarities and of samples alone; the rest is joint."""

    records: float
    polarities: float
    samples: float


def variance_shares(displacement: Floats, scale: int) -> Shares:
    """First-order shares of the variance at a scale: variances of means over all else; NaN where they are not known."""
    values = displacement[:, :, scale]
    if not np.all(np.isfinite(values)) or not np.var(values) > 0.0:
        return Shares(math.nan, math.nan, math.nan)
    axes = {0, 1, 2}
    shares = [float(np.var(values.mean(axis=tuple(axes - {axis}))) / np.var(values)) for axis in axes]
    return Shares(*shares)
