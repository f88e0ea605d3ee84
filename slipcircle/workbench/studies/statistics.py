"""Statistics of samples with confidence intervals: quantiles, moments, probabilities and sensitivity indices."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ArrayTriple, Floats
from slipcircle.base.text import number_text
from slipcircle.workbench.common.distributions import special

# Least values for an interval from replicates: samples of each, samples in the tail, standard deviation of the counts.
_LEAST_SIZE = 16
_LEAST_IN_TAIL = 2.0
_LEAST_SPREAD = 0.7


class Estimate(NamedTuple):
    """A value and its confidence interval; NaN if unknown, infinite if it lies beyond all values."""

    value: float
    low: float
    high: float


class Exceedance(NamedTuple):
    """Exceedance curve: values, the probabilities of exceeding them, and confidence intervals."""

    at: Floats
    probability: Floats
    low: Floats
    high: Floats


class Convergence(NamedTuple):
    """Estimates from the first n valid samples: probability of moving, median and 95 % quantile of the run-out."""

    n: int
    moving: Estimate
    median: Estimate
    upper: Estimate


NOT_GIVEN = Estimate(math.nan, math.nan, math.nan)
BEYOND = "beyond"  # replaces an infinite value, due to samples that slide without a known end


def value_text(value: float) -> str:
    """Return a value of an estimate as text, `BEYOND` if it is infinite."""
    return BEYOND if value == math.inf else number_text(value)


def proportion(hits: Any, n: int, confidence: float) -> tuple[Any, Any]:
    """Return the ends of the interval of a probability from ``hits`` in n independent samples.

    ``hits`` is a number or an array; the confidence is between 0 and 1.

    The interval is never too short (Clopper and Pearson 1934).
    """
    hits = np.asarray(hits, float)
    tail = (1.0 - confidence) / 2
    misses = n - hits
    low = special().betaincinv(hits, misses + 1, tail)
    high = special().betaincinv(hits + 1, misses, 1.0 - tail)
    return np.where(hits > 0, low, 0.0), np.where(misses > 0, high, 1.0)


def standard_error(values: Floats) -> Any:
    """Return the standard error of the mean of independent estimates along the first axis, without that axis."""
    return np.std(values, axis=0, ddof=1) / math.sqrt(len(values))


def student(values: Floats, confidence: float) -> Any:
    """Return half the width of the interval of a mean of independent values along the first axis; NaN for one value.

    The confidence is between 0 and 1.
    """
    if len(values) < 2:
        return np.full(np.shape(values)[1:], np.nan)
    return interval_width(confidence, len(values)) * standard_error(values)


def share_width(shares: Floats, size: float, confidence: float) -> Any:
    """Return half the width of the interval of a mean of shares (replicates, ...); each is a share of ``size`` samples.

    It is NaN where the interval would not reach its confidence (`python -m tests.campaigns.coverage`): for few samples,
    in the tails, and where the replicates differ by less than a sample, as for sequences in one dimension.
    """
    share = np.mean(shares, axis=0)
    is_in_tail = size * np.minimum(share, 1.0 - share) < _LEAST_IN_TAIL
    varies = size * np.std(shares, axis=0, ddof=1) >= _LEAST_SPREAD
    return np.where((size >= _LEAST_SIZE) & ~is_in_tail & varies, student(shares, confidence), np.nan)


def probability(hits: Any, valid: Any, confidence: float) -> ArrayTriple:
    """Return probabilities and both ends of their intervals, from the numbers of ``hits``, (replicates, ...).

    ``valid`` are the numbers of valid samples, (replicates,).
    """
    samples = int(valid.sum())
    total = hits.sum(axis=0)
    if not samples:
        return tuple(np.full((3, *total.shape), np.nan))
    value = total / samples
    low, high = proportion(total, samples, confidence)
    if len(valid) > 1:
        filled = valid > 0
        shares = hits[filled] / valid[filled, None]
        half = share_width(shares, samples / len(shares), confidence)
        is_unanimous = (total == 0) | (total == samples)  # identical replicates do not show their spread
        low = np.where(is_unanimous, low, np.maximum(value - half, 0))
        high = np.where(is_unanimous, high, np.minimum(value + half, 1))
    return value, low, high


def interval_width(confidence: float, replicates: int = 1) -> float:
    """Return half the width of an interval in standard errors, for many samples or for a few replicates."""
    tail = (1.0 + confidence) / 2
    return float(special().stdtrit(replicates - 1, tail) if replicates > 1 else special().ndtri(tail))


def ranks(p: float, n: int, confidence: float) -> tuple[int, int]:
    """Return the ranks, from 1, of the ordered samples that enclose the p-quantile; 0 or n + 1 for an unknown end.

    ``n`` is the number of samples.

    The number of samples below the quantile is binomial for every distribution.
    """
    tails = np.array([1.0 - confidence, 1.0 + confidence]) / 2
    count = np.nan_to_num(np.ceil(special().bdtrik(tails, n, p)), nan=n * p)  # NaN of p = 0 and 1
    before = np.maximum(count - 1.0, 0.0)
    low, high = np.where(special().bdtr(before, n, p) >= tails, before, count).astype(int).tolist()
    return low, min(high, n) + 1


# --- moments and quantiles --------------------------------------------------------------------------------------------


class Spread(NamedTuple):
    """Mean and standard deviation of samples, each with its standard error."""

    mean: float
    mean_error: float
    std: float
    std_error: float


def spread(values: Floats) -> Spread:
    """Return the mean and standard deviation of independent samples, with standard errors.

    The variance of the sample variance is the variance of the squared deviations over n; a root halves relative errors.
    """
    n = values.size
    mean = float(np.mean(values)) if n else math.nan
    if n < 2:
        return Spread(mean, math.nan, math.nan, math.nan)
    squares = (values - mean) ** 2
    std = math.sqrt(float(np.sum(squares)) / (n - 1))
    std_error = math.sqrt(float(np.var(squares)) / n) / (2 * std) if std else 0.0
    return Spread(mean, std / math.sqrt(n), std, std_error)


class Ordered:
    """Sorted values of an output, of all replicates and of each replicate; infinite values come last.

    The argument has one array of values for each replicate.
    """

    def __init__(self, replicates: Sequence[Floats]) -> None:
        self.replicates = [np.sort(values) for values in replicates if values.size]
        self.values = np.sort(np.concatenate([*self.replicates, np.empty(0)]))
        self.finite = self.values[: np.searchsorted(self.values, np.inf)]

    def at_share(self, share: float) -> float:
        """Return the least value that at least this share of the samples does not exceed; NaN beyond 0 to 1."""
        if not 0.0 <= share <= 1.0:
            return math.nan
        return float(self.values[max(math.ceil(share * self.values.size), 1) - 1])

    def quantile(self, p: float, confidence: float) -> Estimate:
        """Return the p-quantile, a value of a sample, with its interval; NaN for an unknown end.

        For one replicate, the interval is from ranks of independent samples. For several replicates, it is from the
        share of each that does not exceed the quantile (Woodruff 1952).
        """
        n = self.values.size
        if not n:
            return NOT_GIVEN
        value = self.at_share(p)
        if len(self.replicates) == 1:
            low, high = ((rank - 0.5) / n for rank in ranks(p, n, confidence))
        else:
            finite = min(value, float(np.finfo(np.float64).max))
            shares = np.array([np.searchsorted(x, finite, side="right") / x.size for x in self.replicates])
            half = float(share_width(shares, n / len(shares), confidence))
            low = p - half
            high = p + half
        return Estimate(value, self.at_share(low), self.at_share(high))

    def spread(self) -> Spread:
        """Return mean and standard deviation of finite values, with errors from the replicates if there are several."""
        together = spread(self.finite)
        filled = [values for values in self.replicates if values.size > 1]
        if len(filled) < 2:
            return together
        errors = standard_error(np.array([spread(values[values < np.inf]) for values in filled]))
        return together._replace(mean_error=float(errors[0]), std_error=float(errors[2]))


# --- sensitivity indices ---------------------------------------------------------------------------------------------


class Indices(NamedTuple):
    """Sensitivity indices of one output: first-order and total index of each input."""

    first: list[Estimate]
    total: list[Estimate]


def sensitivity_indices(sums: Floats, confidence: float) -> Indices:
    """Return the sensitivity indices of one output from the `sums` of independent batches, (batches, 3 + 3 inputs).

    First-order indices follow Saltelli et al. (2010), centred, total indices Jansen (1999); intervals are computed by
    leaving out each batch in turn. Indices are NaN if the output does not vary or has infinite values.
    """
    batches = len(sums)
    together = np.sum(sums, axis=0)
    with quiet():
        whole = _indices(together)
        # The jackknife estimate behaves like a mean of pseudo-values, one for each batch (Tukey 1958).
        half = student(batches * whole - (batches - 1) * _indices(together - sums), confidence)
    intervals = np.stack([whole, whole - half, whole + half], axis=-1)
    return Indices(*([Estimate(*interval) for interval in of_inputs] for of_inputs in intervals.tolist()))


def _indices(sums: Floats) -> Floats:
    """Return first-order and total indices, (..., 2, inputs), from `sums` of any shape (..., 3 + 3 inputs)."""
    n, both, squares = (sums[..., k, None] for k in range(3))
    jansen, saltelli, shift = (sums[..., k::3] for k in range(3, 6))  # of each input
    samples = 2 * n
    mean = both / samples
    variance = squares / samples - mean**2
    variance = np.where(variance > 1e-13 * mean**2, variance, np.nan)
    return np.stack([(saltelli - mean * shift) / (n * variance), jansen / (samples * variance)], axis=-2)


def sums(y: Floats) -> Floats:
    """Return the sums that `sensitivity_indices` needs, (3 + 3 inputs,), from rows of outputs: yA, yB and yAB by input.

    They are the number of points, the sums of yA + yB and of yA**2 + yB**2, and for each input the sums of
    (yAB - yA)**2, yB (yAB - yA) and yAB - yA.
    """
    a, b, *each_mixed = y
    with quiet():
        totals = [len(a), np.sum(a + b), np.sum(a * a + b * b)]
        for mixed in each_mixed:
            step = mixed - a
            totals += [np.sum(step * step), np.sum(b * step), np.sum(step)]
    return np.array(totals, float)


# --- displacements under records -------------------------------------------------------------------------------------

# Displacements are arrays (record, polarity, scale, sample), m: 0 for a mass that does not move, infinite if it moves
# without a result, NaN for an invalid scene. Records are independent draws; polarities and samples of a record are not.
THRESHOLDS = np.array([0.01, 0.05, 0.15, 1.0])  # of displacements in tables and pictures, m


class Displacements(NamedTuple):
    """Distribution of displacements at one scale.

    Attributes
    ----------
    moving : float
        Share of motions with a displacement.
    mean, median, p16, p84 : float
        Mean and quantiles of all motions, m; motions of a mass at rest are 0.
    geometric_mean, std_ln : float
        Geometric mean of D, m, and standard deviation of ln D, over motions with D > 0; NaN if they are too few.
    """

    moving: float
    mean: float
    median: float
    p16: float
    p84: float
    geometric_mean: float
    std_ln: float


def distribution(displacement: Floats, scale: int) -> Displacements:
    """Return the distribution of displacements, (record, polarity, scale, sample), at the scale with this index."""
    values = _valid(displacement, scale)
    if not values.size:
        return Displacements(*[math.nan] * len(Displacements._fields))
    p16, median, p84 = np.quantile(values, (0.16, 0.5, 0.84), method="inverted_cdf").tolist()
    moving = values > 0.0
    logs = np.log(values[moving & (values < np.inf)])
    geometric_mean = math.exp(logs.mean()) if logs.size else math.nan
    std_ln = float(logs.std(ddof=1)) if logs.size > 1 else math.nan
    return Displacements(float(moving.mean()), float(values.mean()), median, p16, p84, geometric_mean, std_ln)


def _valid(displacement: Floats, scale: int) -> Floats:
    """Return the displacements of valid scenes at the scale with an index as a one-dimensional array, m."""
    values = displacement[:, :, scale].ravel()
    return values[~np.isnan(values)]


def exceedance_shares(displacement: Floats, threshold: float) -> Floats:
    """Return the share of motions that exceed a threshold, m, (record, scale); NaN without valid motions."""
    exceeds = displacement > threshold
    with quiet():
        return exceeds.sum(axis=(1, 3)) / (~np.isnan(displacement)).sum(axis=(1, 3))


def exceedance_probabilities(displacement: Floats, thresholds: Floats) -> list[list[Estimate]]:
    """Return the probabilities that displacements exceed thresholds, m, as lists by scale of lists by threshold.

    The intervals of 95 % are conservative: they treat each record as one draw (Clopper and Pearson 1934), as if both
    polarities and all samples of a record exceeded a threshold together. Intervals for motions as independent draws
    would be too short, because the two polarities of a record are not independent.
    """
    records, _, scales, _ = displacement.shape
    by_scale = []
    for k in range(scales):
        values = _valid(displacement, k)
        shares = (values[:, None] > thresholds).mean(axis=0) if values.size else np.full(thresholds.size, np.nan)
        rows = np.stack([shares, *proportion(shares * records, records, 0.95)], axis=1)
        by_scale.append([Estimate(*row) for row in rows.tolist()])
    return by_scale


class Shares(NamedTuple):
    """Shares of the variance of the displacement due to records, polarities or samples alone; the rest is joint."""

    records: float
    polarities: float
    samples: float


def variance_shares(displacement: Floats, scale: int) -> Shares:
    """Return first-order shares of the variance of displacements at the scale with an index, from variances of means.

    The displacements are (record, polarity, scale, sample); shares are NaN if unknown.
    """
    values = displacement[:, :, scale]
    if not np.all(np.isfinite(values)) or not np.var(values) > 0.0:
        return Shares(math.nan, math.nan, math.nan)
    means = (values.mean(axis=others) for others in ((1, 2), (0, 2), (0, 1)))
    return Shares(*(float(np.var(mean) / np.var(values)) for mean in means))
