"""Statistics of the displacements under a suite: at each scale their distribution, exceedance and sources of variance.

Displacements are arrays (record, polarity, scale, sample), m: 0 of what does not move, infinite of what moves without a
result, NaN of what is no scene. Records are the independent draws: polarities and samples of one are not.
"""

import math
from typing import NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.workbench.studies.statistics import Estimate, proportion

THRESHOLDS = np.array([0.01, 0.05, 0.15, 1.0])  # of displacements, m, that tables and pictures show


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
    values = _valid(displacement, scale)
    if not values.size:
        unknown = (math.nan,) * len(Distribution._fields)
        return Distribution(*unknown)
    p16, median, p84 = np.quantile(values, (0.16, 0.5, 0.84), method="inverted_cdf").tolist()
    moving = values > 0.0
    logs = np.log(values[moving & (values < np.inf)])
    geometric_mean = math.exp(logs.mean()) if logs.size else math.nan
    std_ln = float(logs.std(ddof=1)) if logs.size > 1 else math.nan
    mean, share = float(values.mean()), float(moving.mean())
    return Distribution(share, mean, median, p16, p84, geometric_mean, std_ln)


def _valid(displacement: Floats, scale: int) -> Floats:
    """The displacements of a scale in a row, without what is no scene."""
    values = displacement[:, :, scale].ravel()
    return values[~np.isnan(values)]


def exceedance_shares(displacement: Floats, threshold: float) -> Floats:
    """Share of a record's motions at a scale that exceed a threshold, m, (record, scale); NaN if none is known."""
    known = ~np.isnan(displacement)
    exceeds = (displacement > threshold) & known
    with np.errstate(invalid="ignore"):
        return exceeds.sum(axis=(1, 3)) / known.sum(axis=(1, 3))


def exceedance(displacement: Floats, thresholds: Floats, confidence: float = 0.95) -> list[list[Estimate]]:
    """Probabilities that displacements exceed thresholds, m, by scale and threshold.

    The intervals are those of a share of as many draws as there are records (Clopper and Pearson 1934): as if both
    polarities and all samples of a record exceeded a threshold together, which is never too short. Counting motions
    instead would be, as the two polarities of a record are not independent.
    """
    records, _, scales, _ = displacement.shape
    found = []
    for k in range(scales):
        values = _valid(displacement, k)
        exceeds = values[:, None] > thresholds
        shares = exceeds.mean(axis=0) if values.size else np.full(thresholds.size, np.nan)
        lows, highs = proportion(shares * records, records, confidence)
        rows = np.stack([shares, lows, highs], axis=1)
        found.append([Estimate(*row) for row in rows.tolist()])
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
    total = np.var(values)
    records = np.var(values.mean(axis=(1, 2)))
    polarities = np.var(values.mean(axis=(0, 2)))
    samples = np.var(values.mean(axis=(0, 1)))
    return Shares(float(records / total), float(polarities / total), float(samples / total))
