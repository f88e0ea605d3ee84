"""Linear equations y' = right - matrix y along the rotation, E = omega**2 the first of them: collocation on panels."""

from bisect import bisect_right
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.checks import EPS
from slipcircle.methods.chebyshev import NODES

Floats = NDArray[np.float64]

# On [0, 1]: nodes, node values -> series, and node values of f -> the mean of f on [0, z] at the nodes z.
# Means, not integrals, so that E grows from zero without losing digits. The end is a node (Radau), so that a strong
# brake forgets errors from panel to panel.
Z = (np.cos(2 * np.pi * np.arange(NODES) / (2 * NODES - 1)) + 1) / 2
_HALF = np.where(np.arange(NODES) > 0, 1.0, 0.5)
_TURN = np.outer(np.arange(NODES), np.arange(NODES)) % (2 * NODES - 1)
BACK = 4 / (2 * NODES - 1) * np.cos(2 * np.pi / (2 * NODES - 1) * _TURN) * _HALF * _HALF[:, None]


def _mean() -> Floats:
    nodes, weights = np.polynomial.legendre.leggauss(12)
    inside = np.polynomial.chebyshev.chebvander(Z[:, None] * (nodes + 1) - 1, NODES - 1) @ BACK
    return np.einsum("zgn,g->zn", inside, weights / 2)


MEAN = _mean()
_GAIN = Z[:, None] * MEAN
_HAIRS = Z[-1] * np.array([0.0, 1e-6, 1e-4, 1e-2, 0.3])  # places before the first node, and a series' values there
_PLACES = np.concatenate([Z, _HAIRS])[:, None]
_AT_HAIRS = np.polynomial.chebyshev.chebvander(2 * _HAIRS - 1, NODES - 1).T
RESOLVED = 4e-15


class Panels(NamedTuple):
    """Solutions on n panels that follow each other, for m equations.

    Attributes
    ----------
    edges, values : ndarray
        Of shape (n + 1,), and (n + 1, m): y at the edges.
    nodes, states : ndarray
        Shapes (n, NODES), and (n, m, NODES): y at the nodes, the last one first.
    means, rates : ndarray
        Shape (n, m, NODES): series of the mean of y' from the left edge on, and of y'.
    missing : ndarray
        Shape (n,): what the series leave out, relative.
    """

    edges: Floats
    values: Floats
    nodes: Floats
    states: Floats
    means: Floats
    rates: Floats
    missing: Floats

    def first(self, count: int) -> "Panels":
        """Some of them."""
        return Panels(self.edges[: count + 1], self.values[: count + 1], *(a[:count] for a in self[2:]))


def joined(parts: list[Panels]) -> Panels:
    """Panels that follow each other as one."""
    if len(parts) == 1:
        return parts[0]
    ends = (np.concatenate([parts[0][i][:1], *(p[i][1:] for p in parts)]) for i in (0, 1))
    return Panels(*ends, *(np.concatenate([p[i] for p in parts]) for i in range(2, 7)))


def propose(
    equation: Callable[[Floats], tuple[Floats, Floats]], edges: Floats, terms: float, blur: float, rounds: int = 6
) -> tuple[Floats, Floats, Floats]:
    """Panels on which the equation is smooth, to be solved: as given, or halves where it is not.

    Parameters
    ----------
    equation : callable
        Takes places of shape (p, n), gives right and matrix of shapes (m, p, n) and (m, m, p, n).
    edges : ndarray
        Shape (n + 1,).
    terms : float
        Size of the terms whose difference the right side is, at least: it is rounded as they are.
    blur : float
        By how much a rotation's rounding, relative to it, is larger in the equation, for each of the rotation.
    rounds : int, optional
        How often a panel is halved at most.

    Returns
    -------
    edges, right, matrix : ndarray
        With the panel in front; the first panel, and those after it up to the first on which they are not smooth.
    """
    while True:
        width = edges[1:] - edges[:-1]
        right, matrix = equation(edges[:-1] + width * _PLACES)
        p, n = right.shape[1:]
        given = np.concatenate([right.reshape(-1, p, n), matrix.reshape(-1, p, n)])
        series = BACK @ given[:, :NODES]
        left_out = np.abs(series[:, -2:]).sum(axis=1) + np.abs(_AT_HAIRS.T @ series - given[:, NODES:]).max(axis=1)
        largest = RESOLVED * np.abs(series).sum(axis=1).max(axis=1, keepdims=True)
        rough = (left_out > np.maximum(largest, 4 * EPS * terms) * (1.0 + blur * edges[1:])).any(axis=0)
        if not rounds or not rough.any():
            break
        rounds -= 1
        edges = np.sort(np.concatenate([edges, (edges[:-1] + width / 2)[rough]]))
    count = max(int(np.argmax(rough)), 1) if rough.any() else n
    return edges[: count + 1], right.transpose(2, 0, 1)[:count], matrix.transpose(3, 0, 1, 2)[:count]


def solved(edges: Floats, right: Floats, matrix: Floats, start: Floats) -> Panels:
    """The solution on panels, one after the other, up to one at whose end E is not above zero.

    Parameters
    ----------
    edges, right, matrix : ndarray
        As from `propose`.
    start : ndarray
        y at the first edge, shape (m,).
    """
    half = edges[1:] - edges[:-1]
    nodes = edges[:-1, None] + half[:, None] * Z
    n, m = right.shape[:2]
    # y = value + (x - left) mean(y') and y' = right - matrix y, at the nodes: a linear system for y'.
    at_nodes = matrix[..., :NODES].swapaxes(2, 3)  # n, m, NODES, m
    system = (at_nodes[..., None] * (half[:, None, None] * _GAIN)[:, None, :, None]).reshape(n, m * NODES, m * NODES)
    system[:, range(m * NODES), range(m * NODES)] += 1.0
    values, slopes = np.empty((n + 1, m)), np.empty((n, m, NODES))
    values[0] = start
    for k in range(n):
        slopes[k] = np.linalg.solve(system[k], (right[k, :, :NODES] - at_nodes[k] @ values[k]).ravel()).reshape(m, -1)
        values[k + 1] = values[k] + half[k] * (slopes[k] @ MEAN[0])
        if values[k + 1, 0] <= 0.0:
            n = k + 1
            break
    edges, values, half, nodes, slopes = edges[: n + 1], values[: n + 1], half[:n], nodes[:n], slopes[:n]
    right, matrix, at_nodes = right[:n], matrix[:n], at_nodes[:n]
    begin, width = values[:-1, :, None], half[:, None, None]
    averages = slopes @ MEAN.T
    states = begin + width * Z * averages
    means, rates, series = averages @ BACK.T, slopes @ BACK.T, states @ BACK.T
    # Also before the first node: what falls within a hair of the start would pass unseen.
    near = begin + width * _HAIRS * (means @ _AT_HAIRS)
    before = right[..., NODES:] - (matrix[..., NODES:] * near[:, None]).sum(axis=2)
    sizes = np.abs(rates)
    missed = np.maximum(np.abs(rates @ _AT_HAIRS - before).max(axis=2) - 64 * EPS * sizes.sum(axis=2), 0.0)
    # Where a strong brake holds the drive, E' is what rounding leaves of their difference; and rounding of the slip
    # leaves little of a narrow table: there E is what counts, also where its series begins.
    brake = np.maximum(at_nodes.diagonal(axis1=1, axis2=3).max(axis=1), 1e-300)
    hair = missed * np.minimum(width[..., 0] * Z[-1], 1.0 / brake) + np.abs(values[:-1] - series @ _AT_HAIRS[:, 0])
    missing = np.minimum(
        (missed + sizes[..., -2:].sum(axis=2)) / np.maximum(np.abs(slopes).max(axis=2), 1e-300),
        (hair + np.abs(series[..., -2:]).sum(axis=2)) / np.maximum(values[:-1], 1e-300),
    )
    return Panels(edges, values, nodes, states, means, rates, missing.max(axis=1))


def over_panels(edges: Floats, values: Floats, means: Floats) -> Callable[[Any], Any]:
    """A function of arrays, from its values at the panels' left edges and the series of its mean slope from there."""

    def function(x: Any) -> Any:
        at = np.asarray(x, dtype=np.float64)
        k = np.clip(np.searchsorted(edges, at, side="right") - 1, 0, len(edges) - 2)
        past = at - edges[k]
        z = 2 * past / (edges[k + 1] - edges[k]) - 1
        return values[k] + past * np.polynomial.chebyshev.chebval(z, means[:, k], tensor=False)

    return function


def series_at(edges: Floats, series: Floats) -> Callable[[float], tuple[int, float, float]]:
    """Of a float: its panel, how far it is in it, and the value of that panel's series, a row each, there."""
    bounds, rows = edges.tolist(), series[:, ::-1].tolist()

    def at(x: float) -> tuple[int, float, float]:
        k = min(max(bisect_right(bounds, x) - 1, 0), len(rows) - 1)
        past = x - bounds[k]
        z, one, two = 2 * (2 * past / (bounds[k + 1] - bounds[k]) - 1), 0.0, 0.0
        for c in rows[k][:-1]:  # Clenshaw's recurrence
            one, two = c + z * one - two, one
        return k, past, rows[k][-1] + z / 2 * one - two

    return at
