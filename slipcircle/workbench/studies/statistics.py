"""Statistics of samples, in one pass and constant memory: histograms, moments, estimates with their intervals."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.workbench.common.distributions import statistics

Floats = NDArray[np.float64]

# Bins of a histogram: of equal relative width 2**-10 from 2**-30 to 2**30, one below (zero too) and one above.
_PARTS = 10
_LOWEST = (1023 - 30) << _PARTS
BINS = (60 << _PARTS) + 2
BIN_ERROR = 2.0**-_PARTS


def bins(values: Floats) -> NDArray[np.int64]:
    """The bin of each magnitude: the exponent and the first bits of the significand of a float64 are its number."""
    return np.clip((values.view(np.int64) >> (52 - _PARTS)) - _LOWEST + 1, 0, BINS - 1)


def edges() -> Floats:
    """Lower edges of the bins, and infinity."""
    inner = (np.arange(BINS - 1, dtype=np.int64) + _LOWEST) << (52 - _PARTS)
    return np.concatenate([[0.0], inner.view(np.float64), [np.inf]])


def moments(values: Floats) -> Floats:
    """Number and mean of values, and sums of the second to fourth powers of what they differ from it."""
    if not values.size:
        return np.zeros(5)
    mean = float(np.mean(values))
    off = values - mean
    squares = off * off
    return np.array([values.size, mean, np.sum(squares), np.sum(squares * off), np.sum(squares * squares)])


class Estimate(NamedTuple):
    """A value and its confidence interval; NaN where the samples are too few to say."""

    value: float
    low: float
    high: float


def proportion(hits: Any, n: int, confidence: float) -> tuple[Any, Any]:
    """Interval of a probability from independent samples, never too short (Clopper and Pearson 1934)."""
    beta, hits, tail = statistics().beta, np.asarray(hits, dtype=np.float64), (1.0 - confidence) / 2
    low, high = beta.ppf(tail, hits, n - hits + 1), beta.ppf(1.0 - tail, hits + 1, n - hits)
    return np.where(hits > 0, low, 0.0), np.where(hits < n, high, 1.0)


def standard_error(values: Floats) -> Any:
    """Of the mean of a few independent estimates, along the first axis."""
    return np.std(values, axis=0, ddof=1) / math.sqrt(len(values))


def student(values: Floats, confidence: float) -> Any:
    """Half the width of the interval of that mean; NaN of a single estimate."""
    if len(values) < 2:
        return np.full(np.shape(values)[1:], np.nan)
    return width(confidence, len(values)) * standard_error(values)


def pooled(each: Floats) -> Floats:
    """`moments` of several sets of values together, a row each: powers of (x - mean) + off, expanded."""
    n, mean, second, third, fourth = each.T
    if not n.any():
        return each[0]
    middle = (n @ mean) / n.sum()
    off = mean - middle
    second, third, fourth = (
        second + n * off**2,
        third + 3 * off * second + n * off**3,
        fourth + 4 * off * third + 6 * off**2 * second + n * off**4,
    )
    return np.array([n.sum(), middle, second.sum(), third.sum(), fourth.sum()])


class Spread(NamedTuple):
    """Mean and standard deviation of samples, each with its standard error."""

    mean: float
    mean_error: float
    std: float
    std_error: float


def spread(moments: Floats) -> Spread:
    """Of independent samples, from their `moments`.

    The variance of a sample's variance is that of the squares over n; a root halves relative errors.
    """
    n, mean, second, _, fourth = moments.tolist()
    if n < 2:
        return Spread(mean if n else math.nan, math.nan, math.nan, math.nan)
    std = math.sqrt(second / (n - 1))
    rest = max(fourth / n - (second / n) ** 2, 0.0) / n
    return Spread(mean, std / math.sqrt(n), std, math.sqrt(rest) / (2 * std) if std else 0.0)


def width(confidence: float, replicates: int = 1) -> float:
    """Standard errors of half an interval: of many samples, or of a few replicates."""
    tail = (1.0 + confidence) / 2
    stats = statistics()
    return float(stats.t.ppf(tail, replicates - 1) if replicates > 1 else stats.norm.ppf(tail))


def ranks(p: float, n: int, confidence: float) -> tuple[int, int]:
    """Ranks, from 1, of the samples that hold the p-quantile between them; 0 or n + 1 where there is none.

    The number of samples below the quantile is binomial, whatever the distribution.
    """
    binom, tail = statistics().binom, (1.0 - confidence) / 2
    return int(binom.ppf(tail, n, p)), min(int(binom.ppf(1.0 - tail, n, p)), n) + 1


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
    """Indices of one output from the `sums` of independent batches, (batches, 3 + 3 inputs).

    First-order as Saltelli et al. (2010), centred, and total as Jansen (1999); intervals from leaving out each batch
    in turn. NaN where the output does not vary.
    """
    batches = len(sums)
    with np.errstate(all="ignore"):
        whole, others = _indices(np.sum(sums, axis=0)), _indices(np.sum(sums, axis=0) - sums)
        # What leaving each out makes of it behaves like a mean of as many pseudo-values (Tukey 1958).
        half = student(batches * whole - (batches - 1) * others, confidence)
    rows = zip(whole, half, strict=True)
    return Indices(*([Estimate(float(v), float(v - h), float(v + h)) for v, h in zip(*r, strict=True)] for r in rows))


def _indices(sums: Floats) -> Floats:
    """First-order and total indices, (..., 2, inputs)."""
    n, both, squares = (sums[..., k, None] for k in range(3))
    parts = sums[..., 3:].reshape(*sums.shape[:-1], -1, 3)
    mean = both / (2 * n)
    variance = squares / (2 * n) - mean**2
    variance = np.where(variance > 1e-13 * mean**2, variance, np.nan)
    first = (parts[..., 1] - mean * parts[..., 2]) / (n * variance)
    return np.stack([first, parts[..., 0] / (2 * n * variance)], axis=-2)


def sums(y: Floats) -> Floats:
    """What `indices` needs of one output, from yA, yB and then yAB of each input, by rows.

    The number of points, sums of yA + yB and yA**2 + yB**2; for each input of (yAB - yA)**2, yB (yAB - yA), yAB - yA.
    """
    a, b = y[0], y[1]
    found = [np.array([len(a), np.sum(a + b), np.sum(a * a + b * b)])]
    for mixed in y[2:]:
        step = mixed - a
        found.append(np.array([np.sum(step * step), np.sum(b * step), np.sum(step)]))
    return np.concatenate(found)
