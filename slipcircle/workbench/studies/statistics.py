"""Statistics of samples, in one pass and constant memory: histograms, moments, estimates with their intervals."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats
from slipcircle.base.text import shown
from slipcircle.workbench.common.distributions import special

# Bins of a histogram: of equal relative width 2**-10 from 2**-30 to 2**30, one below (zero too), one above, and the
# last one for infinity.
_BITS = 10
_LOWEST = (1023 - 30) << _BITS
_INNER = 60 << _BITS
BINS = _INNER + 3
BIN_ERROR = 2.0**-_BITS
# Of replicates with an interval: samples of each, of these in the tail, and the standard deviation of their counts.
_LEAST_SIZE = 16
_LEAST_IN_TAIL = 2.0
_LEAST_SPREAD = 0.7


def bins(values: Floats) -> NDArray[np.int64]:
    """The bin of each magnitude: the exponent and the first bits of the significand of a float64 are its number."""
    leading_bits = values.view(np.int64) >> (52 - _BITS)
    place = leading_bits - _LOWEST + 1
    finite = np.clip(place, 0, BINS - 2)
    return np.where(np.isinf(values), BINS - 1, finite)


def edges() -> Floats:
    """Lower edges of the bins, and infinity."""
    leading_bits = np.arange(_LOWEST, _LOWEST + _INNER + 1, dtype=np.int64)
    inner = leading_bits << (52 - _BITS)
    return np.concatenate([[0.0], inner.view(np.float64), [np.inf, np.inf]])


def histogram_quantile(counts: NDArray[np.int64], p: Any, ends: tuple[float, float]) -> Any:
    """Quantiles from counts in `bins`, interpolated within a bin: off by less than the bin's width.

    ``ends`` are the least and the greatest finite value; infinite where that many values are.
    """
    cumulated = np.cumsum(counts)
    total = cumulated[-1]
    rank = np.ceil(np.asarray(p) * total)
    rank = np.clip(rank, 1, total)
    k = np.searchsorted(cumulated, rank)
    edge = edges()
    lower = edge[k]
    upper = edge[k + 1]
    above = rank - cumulated[k]
    share = above / counts[k] + 1.0  # of the bin, that is below
    with np.errstate(invalid="ignore"):
        width = np.where(upper < np.inf, upper - lower, 0.0)
        inside = lower + width * share
    inside = np.clip(inside, *ends)
    value = np.where(k == 0, 0.0, inside)
    return np.where(k == BINS - 1, np.inf, value)


class Estimate(NamedTuple):
    """A value and its confidence interval; NaN where it cannot be said, infinite where it lies beyond every value."""

    value: float
    low: float
    high: float


NOT_GIVEN = Estimate(math.nan, math.nan, math.nan)
BEYOND = "beyond"  # in place of an infinite value: exceeded by samples that slide to no known end


def value_text(value: float) -> str:
    """A value of an estimate as people read it."""
    return BEYOND if value == math.inf else shown(value)


def proportion(hits: Any, n: int, confidence: float) -> tuple[Any, Any]:
    """Interval of a probability from independent samples, never too short (Clopper and Pearson 1934)."""
    hits = np.asarray(hits, dtype=np.float64)
    tail = (1.0 - confidence) / 2
    misses = n - hits
    low = special().betaincinv(hits, misses + 1, tail)
    high = special().betaincinv(hits + 1, misses, 1.0 - tail)
    low = np.where(hits > 0, low, 0.0)
    high = np.where(misses > 0, high, 1.0)
    return low, high


def standard_error(values: Floats) -> Any:
    """Standard error of the mean of a few independent estimates, along the first axis."""
    deviation = np.std(values, axis=0, ddof=1)
    return deviation / math.sqrt(len(values))


def student(values: Floats, confidence: float) -> Any:
    """Half the width of the interval of that mean; NaN of a single estimate."""
    if len(values) < 2:
        return np.full(np.shape(values)[1:], np.nan)
    return width(confidence, len(values)) * standard_error(values)


def share_width(shares: Floats, size: float, confidence: float) -> Any:
    """Half the width of the interval of a mean of shares (replicates, ...) of so many samples each.

    NaN where the interval would not have its confidence (`python -m tests.campaigns.coverage`): for few samples, in
    the tails, and where the replicates differ by less than a sample, as sequences in one dimension do.
    """
    spread = size * np.std(shares, axis=0, ddof=1)
    share = np.mean(shares, axis=0)
    in_tail = size * np.minimum(share, 1.0 - share)
    is_resolved = (size >= _LEAST_SIZE) & (in_tail >= _LEAST_IN_TAIL) & (spread >= _LEAST_SPREAD)
    return np.where(is_resolved, student(shares, confidence), np.nan)


def probability(hits: Any, valid: Any, confidence: float) -> tuple[Floats, Floats, Floats]:
    """Probabilities and their intervals from counts (replicates, ...) among valid samples (replicates,)."""
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
        is_unanimous = (total == 0) | (total == samples)  # the replicates agree, and cannot tell how surely
        low = np.where(is_unanimous, low, np.maximum(value - half, 0))
        high = np.where(is_unanimous, high, np.minimum(value + half, 1))
    return value, low, high


def width(confidence: float, replicates: int = 1) -> float:
    """Standard errors of half an interval: of many samples, or of a few replicates."""
    tail = (1.0 + confidence) / 2
    if replicates > 1:
        return float(special().stdtrit(replicates - 1, tail))
    return float(special().ndtri(tail))


def ranks(p: float, n: int, confidence: float) -> tuple[int, int]:
    """Ranks, from 1, of the samples that hold the p-quantile between them; 0 or n + 1 where there is none.

    The number of samples below the quantile is binomial, whatever the distribution.
    """
    tail = (1.0 - confidence) / 2
    tails = np.array([tail, 1.0 - tail])
    count = np.ceil(special().bdtrik(tails, n, p))
    before = np.maximum(count - 1.0, 0.0)
    low, high = np.where(special().bdtr(before, n, p) >= tails, before, count).astype(int).tolist()
    return low, min(high, n) + 1


# --- moments ---------------------------------------------------------------------------------------------------------


def moments(values: Floats) -> Floats:
    """Number and mean of values, and sums of the second to fourth powers of what they differ from it."""
    if not values.size:
        return np.zeros(5)
    mean = float(np.mean(values))
    off = values - mean
    squares = off * off
    powers = (squares, squares * off, squares * squares)
    return np.array([values.size, mean, *map(np.sum, powers)])


def pooled(each: Floats) -> Floats:
    """`moments` of several sets of values together, a row each: powers of (x - mean) + off, expanded."""
    n, mean, second, third, fourth = each.T
    total = n.sum()
    if not total:
        return each[0]
    common_mean = (n @ mean) / total
    off = mean - common_mean
    square = off * off
    mixed = 4 * off * third
    fourths = fourth + mixed + 6 * square * second + n * square**2
    thirds = third + 3 * off * second + n * off * square
    seconds = second + n * square
    sums_of_powers = [powers.sum() for powers in (seconds, thirds, fourths)]
    return np.array([total, common_mean, *sums_of_powers])


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
    variance_of_squares = fourth / n - (second / n) ** 2
    variance_of_variance = max(variance_of_squares, 0.0) / n
    std_error = math.sqrt(variance_of_variance) / (2 * std) if std else 0.0
    return Spread(mean, std / math.sqrt(n), std, std_error)


# --- sensitivity indices ---------------------------------------------------------------------------------------------


class Indices(NamedTuple):
    """Sensitivity indices of one output: of each input the first-order and the total one."""

    first: list[Estimate]
    total: list[Estimate]


def indices(sums: Floats, confidence: float) -> Indices:
    """Indices of one output from the `sums` of independent batches, (batches, 3 + 3 inputs).

    First-order as Saltelli et al. (2010), centred, and total as Jansen (1999); intervals from leaving out each batch
    in turn. NaN where the output does not vary, or is infinite somewhere.
    """
    batches = len(sums)
    together = np.sum(sums, axis=0)
    with np.errstate(all="ignore"):
        whole = _indices(together)
        without_one = _indices(together - sums)
        # What leaving each out makes of it behaves like a mean of as many pseudo-values (Tukey 1958).
        pseudo_values = batches * whole - (batches - 1) * without_one
        half = student(pseudo_values, confidence)
    intervals = np.stack([whole, whole - half, whole + half], axis=-1)
    first, total = intervals.tolist()
    return Indices([Estimate(*interval) for interval in first], [Estimate(*interval) for interval in total])


def _indices(sums: Floats) -> Floats:
    """First-order and total indices, (..., 2, inputs)."""
    n, both, squares = (sums[..., k, None] for k in range(3))
    of_inputs = sums[..., 3:]
    by_input = of_inputs.reshape(*sums.shape[:-1], -1, 3)
    jansen, saltelli, shift = np.moveaxis(by_input, -1, 0)
    samples = 2 * n
    mean = both / samples
    variance = squares / samples - mean**2
    varies = variance > 1e-13 * mean**2
    variance = np.where(varies, variance, np.nan)
    first = (saltelli - mean * shift) / (n * variance)
    total = jansen / (samples * variance)
    return np.stack([first, total], axis=-2)


def sums(y: Floats) -> Floats:
    """What `indices` needs of one output, from yA, yB and then yAB of each input, by rows.

    The number of points, sums of yA + yB and yA**2 + yB**2; for each input of (yAB - yA)**2, yB (yAB - yA), yAB - yA.
    """
    a, b, *each_mixed = y
    with np.errstate(invalid="ignore"):
        both = np.sum(a + b)
        squares = np.sum(a * a + b * b)
        totals = [len(a), both, squares]
        for mixed in each_mixed:
            step = mixed - a
            jansen = np.sum(step * step)
            saltelli = np.sum(b * step)
            totals += [jansen, saltelli, np.sum(step)]
    return np.array(totals, dtype=np.float64)
