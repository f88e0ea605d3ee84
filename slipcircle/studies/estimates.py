"""Estimates with intervals: probabilities, quantiles of samples and of histograms, sensitivity indices."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.distributions import special
from slipcircle.studies.study import BINS, edges

Floats = NDArray[np.float64]


class Estimate(NamedTuple):
    """A value and its confidence interval; NaN where the samples are too few to say."""

    value: float
    low: float
    high: float


def proportion(hits: Any, n: int, confidence: float) -> tuple[Any, Any]:
    """Interval of a probability from independent samples, never too short (Clopper and Pearson 1934)."""
    betaincinv, hits, tail = special().betaincinv, np.asarray(hits, dtype=np.float64), (1.0 - confidence) / 2
    # Where there is no hit, or nothing else, the end is exact, and the function's argument may be anything allowed.
    low = np.where(hits > 0, betaincinv(np.maximum(hits, 1), n - np.maximum(hits, 1) + 1, tail), 0.0)
    high = np.where(hits < n, betaincinv(np.minimum(hits, n - 1) + 1, n - np.minimum(hits, n - 1), 1.0 - tail), 1.0)
    return low, high


def student(values: Floats, confidence: float) -> Any:
    """Half the width of the interval of a mean of a few independent estimates, along the first axis."""
    count = len(values)
    if count < 2:
        return np.full(np.shape(values)[1:], np.nan)
    return width(confidence, count) * np.std(values, axis=0, ddof=1) / math.sqrt(count)


def pooled(a: Floats, b: Floats) -> Floats:
    """`slipcircle.studies.study.moments` of two sets of values together (Pebay 2008, equations 3.1)."""
    n, m = a[0] + b[0], a[0] * b[0]
    if not m:
        return b if b[0] else a
    step, p, q = b[1] - a[1], a[0] / n, b[0] / n
    second = a[2] + b[2] + m / n * step**2
    third = a[3] + b[3] + m / n * step**3 * (p - q) + 3 * step * (p * b[2] - q * a[2])
    fourth = a[4] + b[4] + m / n * step**4 * (p * p - p * q + q * q)
    fourth += 6 * step**2 * (p * p * b[2] + q * q * a[2]) + 4 * step * (p * b[3] - q * a[3])
    return np.array([n, a[1] + q * step, second, third, fourth])


def spread(moments: Floats) -> tuple[float, float, float, float]:
    """Mean and its standard error, standard deviation and its own, from the moments of independent samples.

    The variance of a sample's variance is that of the squares over n; a root halves relative errors.
    """
    n, mean, second, _, fourth = moments.tolist()
    if n < 2:
        return mean if n else math.nan, math.nan, math.nan, math.nan
    std = math.sqrt(second / (n - 1))
    rest = max(fourth / n - (second / n) ** 2, 0.0) / n
    return mean, std / math.sqrt(n), std, math.sqrt(rest) / (2 * std) if std else 0.0


def width(confidence: float, replicates: int = 1) -> float:
    """Standard errors of half an interval: of many samples, or of a few replicates."""
    tail = (1.0 + confidence) / 2
    return float(special().stdtrit(replicates - 1, tail) if replicates > 1 else special().ndtri(tail))


def ranks(p: float, n: int, confidence: float) -> tuple[int, int]:
    """Ranks, from 1, of the samples that hold the p-quantile between them; 0 or n + 1 where there is none.

    The number of samples below the quantile is binomial, whatever the distribution.
    """
    bdtr, bdtrik, tail = special().bdtr, special().bdtrik, (1.0 - confidence) / 2

    def least(probability: float) -> int:
        """The smallest k whose distribution function reaches the probability."""
        k = bdtrik(probability, n, p) if bdtr(0, n, p) < probability else 0.0
        k = max(0, math.floor(k) - 2)
        while bdtr(k, n, p) < probability:
            k += 1
        return k

    return least(tail), min(least(1.0 - tail), n) + 1


def histogram_quantile(counts: NDArray[np.int64], p: Any, ends: tuple[float, float]) -> Any:
    """Quantiles from counts in `bins`, interpolated within a bin: off by less than the bin's width."""
    total = np.cumsum(counts)
    rank = np.clip(np.ceil(np.asarray(p) * total[-1]), 1, total[-1])
    k = np.searchsorted(total, rank)
    lower, upper = edges()[k], edges()[k + 1]
    share = (rank - (total[k] - counts[k])) / counts[k]
    inside = np.where(k == 0, 0.0, lower + (np.where(k == BINS - 1, lower, upper) - lower) * share)
    return np.clip(inside, np.where(k == 0, 0.0, ends[0]), ends[1])


class Indices(NamedTuple):
    """Sensitivity indices of one output: of each input the first-order and the total one."""

    first: list[Estimate]
    total: list[Estimate]


def indices(sums: Floats, confidence: float) -> Indices:
    """Indices of one output from the `slipcircle.studies.study.sums` of independent batches, (batches, 3 + 3 inputs).

    First-order as Saltelli et al. (2010), centred, and total as Jansen (1999); intervals from leaving out each batch
    in turn. NaN where the output does not vary.
    """
    batches = len(sums)
    with np.errstate(all="ignore"):
        whole, others = _indices(np.sum(sums, axis=0)), _indices(np.sum(sums, axis=0) - sums)
        # What leaving each out makes of it behaves like a mean of as many pseudo-values (Tukey 1958).
        half = student(batches * whole - (batches - 1) * others, confidence)
    first, total = ([Estimate(float(v), float(v - h), float(v + h)) for v, h in zip(*rows, strict=True)]
                    for rows in zip(whole, half, strict=True))  # fmt: skip
    return Indices(first, total)


def _indices(sums: Floats) -> Floats:
    """First-order and total indices, (..., 2, inputs)."""
    n, both, squares = (sums[..., k, None] for k in range(3))
    parts = sums[..., 3:].reshape(*sums.shape[:-1], -1, 3)
    mean = both / (2 * n)
    variance = squares / (2 * n) - mean**2
    variance = np.where(variance > 1e-13 * mean**2, variance, np.nan)
    first = (parts[..., 1] - mean * parts[..., 2]) / (n * variance)
    return np.stack([first, parts[..., 0] / (2 * n * variance)], axis=-2)
