"""One output of a study, added up block by block: a histogram, moments and extremes of each replicate."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.workbench.studies.statistics import (
    BINS,
    Spread,
    bins,
    edges,
    histogram_quantile,
    moments,
    pooled,
    ranks,
    share_width,
    spread,
    standard_error,
)

COUNTED = ("bins", "counts", "moments", "ends")


def counted(values: Floats) -> dict[str, Any]:
    """What a block has of an output: bins that are not empty and their counts; of finite values moments, extremes."""
    finite = values[values < np.inf]
    filled, counts = np.unique(bins(values), return_counts=True)
    least = finite.min(initial=np.inf)
    greatest = finite.max(initial=-np.inf)
    ends = np.array([least, greatest])
    return {"bins": filled, "counts": counts, "moments": moments(finite), "ends": ends}


class Tally:
    """An output of the samples that are scenes; infinite values are those beyond every other."""

    def __init__(self, replicates: int) -> None:
        self.histograms = np.zeros((replicates, BINS), np.int64)
        self._moments = np.zeros((replicates, 5))
        self.ends = math.inf, -math.inf

    def add(self, replicate: int, block: Mapping[str, Any]) -> None:
        """Add what a block has `counted`."""
        self.histograms[replicate, block["bins"]] += block["counts"]
        both = np.stack([self._moments[replicate], block["moments"]])
        self._moments[replicate] = pooled(both)
        low, high = self.ends
        least, greatest = block["ends"].tolist()
        self.ends = min(low, least), max(high, greatest)

    def quantile(self, p: float) -> float:
        """Of all replicates together."""
        return float(histogram_quantile(self.histograms.sum(axis=0), p, self.ends))

    def share_interval(self, p: float, confidence: float) -> tuple[float, float]:
        """Return the shares of the samples between which the p-quantile lies; NaN where that is not known.

        By ranks of independent samples. Of several replicates, from their shares below the quantile (Woodruff 1952).
        """
        sizes = self.histograms.sum(axis=1)
        samples = int(sizes.sum())
        if len(sizes) == 1:
            lower, upper = ranks(p, samples, confidence)
            return (lower - 0.5) / samples, (upper - 0.5) / samples
        place = min(int(bins(np.array([self.quantile(p)]))[0]), BINS - 2)  # among finite values
        filled = sizes > 0
        shares = self.histograms[filled, : place + 1].sum(axis=1) / sizes[filled]
        half = float(share_width(shares, samples / len(shares), confidence))
        return p - half, p + half

    def spread(self) -> Spread:
        """Mean and standard deviation with their errors, from the replicates where there are several."""
        together = spread(pooled(self._moments))
        filled = self._moments[self._moments[:, 0] > 1]
        if len(filled) < 2:
            return together
        errors = standard_error(np.array([spread(moments) for moments in filled]))
        return together._replace(mean_error=float(errors[0]), std_error=float(errors[2]))

    def exceeding(self, points: int) -> tuple[Floats, Any]:
        """About so many edges of bins up to the greatest value, and how many values are not below, (replicates, ...).

        Without the first edge, where the probability is 1.
        """
        greatest = max(self.ends[1], 0.0)
        values = np.linspace(0.0, greatest, points)
        places = np.unique(np.searchsorted(edges()[:-1], values, side="right") - 1)
        places = places[places > 0]
        from_above = self.histograms[:, ::-1]
        not_below = np.cumsum(from_above, axis=1)[:, ::-1]
        return edges()[places], not_below[:, places]

    def table(self) -> Floats:
        """Bins that hold any: from, to and how many, in rows."""
        counts = self.histograms.sum(axis=0)
        filled = np.flatnonzero(counts)
        return np.stack([edges()[filled], edges()[filled + 1], counts[filled]], axis=1)
