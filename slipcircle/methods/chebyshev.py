"""Piecewise Chebyshev series: a smooth function on panels, refined until resolved, then integrated and inverted."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev as series
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def gauss(count: int) -> tuple[Floats, Floats]:
    """Nodes and weights of Gauss's rule on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return (nodes + 1) / 2, weights / 2


NODES = 16
_X = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)  # first kind: the ends, where 0/0 may stand, are left out
# cos(j pi (2 k + 1)/(2 NODES)), the angle within one turn, so that the last terms of a series are no rounding errors.
_TO_SERIES = np.cos(np.pi / (2 * NODES) * (np.outer(np.arange(NODES), 2 * np.arange(NODES) + 1) % (4 * NODES)))
_TO_SERIES *= np.where(np.arange(NODES) > 0, 2.0, 1.0)[:, None] / NODES
_INTEGRATE = np.array([series.chebint(row, lbnd=-1.0) for row in np.eye(NODES)]).T  # series -> series of its integral
_GAUSS = gauss(NODES)
_LAST = (2 * np.arange(NODES - 2, NODES)[:, None] + 1) * _GAUSS[1]  # of the Legendre series, the last two terms
_LAST *= np.polynomial.legendre.legvander(2 * _GAUSS[0] - 1, NODES - 1).T[-2:]
_MAX_PANELS = 600
_MOST_QUARTERINGS = 12
_QUARTERS = np.array([[0.25], [0.5], [0.75]])


@dataclass(frozen=True)
class Piecewise:
    """Series on panels: ``coefficients[:, k]`` on [edges[k], edges[k + 1]]."""

    edges: Floats
    coefficients: Floats
    tail: float  # the largest contribution of unresolved terms to the integral, absolute

    def integral(self) -> "Piecewise":
        """Its integral from the first edge, continuous."""
        half = np.diff(self.edges) / 2
        found = (_INTEGRATE @ self.coefficients) * half
        found[0, 1:] += np.cumsum(found.sum(axis=0))[:-1]  # a series' value at 1 is the sum of its coefficients
        return Piecewise(self.edges, found, self.tail)

    @property
    def end(self) -> float:
        """Value at the last edge."""
        return float(self.coefficients[:, -1].sum())

    def __call__(self, x: Floats) -> Floats:
        """Values at points inside the panels."""
        panel = np.clip(np.searchsorted(self.edges, x, side="right") - 1, 0, len(self.edges) - 2)
        return self._at(panel, x)

    def _at(self, panel: NDArray[np.intp], x: Floats) -> Floats:
        left, right = self.edges[panel], self.edges[panel + 1]
        z = (2 * x - left - right) / (right - left)
        return np.asarray(series.chebval(z, self.coefficients[:, panel], tensor=False))

    def inverse(self, values: Floats, slope: "Piecewise") -> Floats:
        """Where this increasing function takes the values; ``slope`` is its derivative. Newton within its panel."""
        at_edges = np.concatenate([[0.0], self.coefficients.sum(axis=0)])  # an integral starts at zero
        panel = np.clip(np.searchsorted(at_edges, values, side="right") - 1, 0, len(self.edges) - 2)
        low, high = self.edges[panel].copy(), self.edges[panel + 1].copy()
        span = at_edges[panel + 1] - at_edges[panel]
        x = low + (high - low) * (values - at_edges[panel]) / np.where(span > 0.0, span, 1.0)
        for _ in range(60):
            miss = self._at(panel, x) - values
            low, high = np.where(miss <= 0.0, x, low), np.where(miss >= 0.0, x, high)
            gradient = slope._at(panel, x)
            step = miss / np.where(gradient > 0.0, gradient, np.inf)
            following = x - step
            following = np.where(
                (following >= low) & (following <= high) & (gradient > 0.0), following, (low + high) / 2
            )
            done = np.abs(following - x) <= 4e-16 * np.abs(x)
            x = following
            if np.all(done):
                break
        return np.where(values <= 0.0, self.edges[0], x)


def accumulate(rate: Callable[[Floats], Floats], total: Piecewise, x: Floats) -> Floats:
    """The integral of ``rate`` from the first edge to x, relatively accurate also next to the first edge.

    ``total`` is its integral as a series, which gives the part up to the edge left of x; the rest is integrated anew.
    """
    panel = np.clip(np.searchsorted(total.edges, x, side="right") - 1, 0, len(total.edges) - 2)
    before = np.concatenate([[0.0], total.coefficients.sum(axis=0)])[panel]
    left = total.edges[panel]
    return np.asarray(before + (x - left) * (_GAUSS[1] @ rate(left + (x - left) * _GAUSS[0][:, None])))


def quadrature(function: Callable[[Floats], Floats], edges: Floats, middle: float) -> tuple[float, float, float]:
    """The integrals of a positive function from the first edge to the last and to one between, and what is missing.

    Gauss's rule takes twice as many terms as the Legendre series on its nodes has, so their square is what it misses.
    The function must be smooth on the panels; those on which it is not resolved are quartered.
    """
    left, right, whole, part, missing = edges[:-1], edges[1:], 0.0, 0.0, 0.0
    for _ in range(_MOST_QUARTERINGS):
        width = right - left
        values = function(left + width * _GAUSS[0][:, None])
        sizes, tails = width * (_GAUSS[1] @ values), width * np.abs(_LAST @ values).sum(axis=0)
        bad, cut = tails > 1e-8 * sizes, left[:0]
        if bad.any():
            inner = left[bad] + width[bad] * _QUARTERS
            cut, right = np.append(left[bad], inner), np.append(inner, right[bad])
            sizes, tails, left = sizes[~bad], tails[~bad], left[~bad]
        whole, part = whole + float(sizes.sum()), part + float(sizes[left < middle].sum())
        missing += float((tails * tails / np.maximum(sizes, 1e-300)).sum())
        if not cut.size:
            return whole, part, missing
        left = cut
    return whole, part, np.inf


def resolve(function: Callable[[Floats], Floats], edges: Floats, tolerance: float) -> Piecewise:
    """Series of a function on panels, halved until what they leave out adds less than tolerance to the integral.

    Parameters
    ----------
    function : callable
        Takes points of shape (nodes, panels), all inside their panels.
    edges : ndarray
        First panels: the function must be smooth between them.
    tolerance : float
        Relative to the integral of the function's size, from the first edge to the panel.
    """
    places, sizes, kept = np.zeros(0), np.zeros(0), np.zeros((NODES, 0))  # good panels: left edges, integrals, series
    left, right = edges[:-1], edges[1:]
    while len(left):
        coefficients = _TO_SERIES @ function(left + (right - left) * (_X[:, None] + 1) / 2)
        size = np.abs(coefficients).sum(axis=0) * (right - left) / 2
        tail = np.abs(coefficients[-2:]).sum(axis=0) * (right - left) / 2
        before = np.concatenate([[0.0], np.cumsum(sizes)])[np.searchsorted(places, left)] + np.cumsum(size)
        narrow = (right - left) <= 1e-14 * np.maximum(np.abs(left), np.abs(right))
        good = (tail <= tolerance * np.maximum(before * 0.1, size)) | narrow
        if len(places) + len(left) > _MAX_PANELS:
            good[:] = True
        order = np.argsort(np.append(places, left[good]))
        places, sizes = np.append(places, left[good])[order], np.append(sizes, size[good])[order]
        kept = np.append(kept, coefficients[:, good], axis=1)[:, order]
        # Halves of a panel follow each other, so that panels stay in order.
        middle = (left + right)[~good] / 2
        left, right = np.ravel([left[~good], middle], "F"), np.ravel([middle, right[~good]], "F")
    ends = np.append(places, edges[-1])
    return Piecewise(ends, kept, float((np.abs(kept[-2:]).sum(axis=0) * np.diff(ends)).sum() / 2))
