"""Panels of many paths: their nodes, what is integrated there, and the variable in which they are laid."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from slipcircle.methods.chebyshev import gauss

Floats = NDArray[np.float64]

NODES = 16
TURN = 1.0  # that a panel may make, rad

Z, WEIGHTS = gauss(NODES)
_SERIES = np.linalg.inv(legendre.legvander(2 * Z - 1, NODES - 1))
LAST = _SERIES[-2:].copy()
LAST_FROM_REST, LAST_TO_REST = LAST / Z, LAST / (1.0 - Z)  # see `_integrals`
SLOPE = np.array([2 * legendre.legval(1.0, legendre.legder(row)) for row in _SERIES.T])  # at the end
_BARYCENTRIC = (1.0 / np.array([np.prod(np.delete(z - Z, k)) for k, z in enumerate(Z)]))[:, None]


def _integrals(weight: Callable[[Floats], Floats]) -> Floats:
    """Values at the nodes -> integrals from 0 to each node and to 1; what is left without a weight is interpolated."""
    ends = np.append(Z, 1.0)
    places = ends[:, None] * Z
    inside = weight(places)[:, :, None] * (legendre.legvander(2 * places - 1, NODES - 1) @ _SERIES) / weight(Z)
    return np.asarray(np.einsum("e,egn,g->en", ends, inside, WEIGHTS))


INTEGRALS = _integrals(np.ones_like)
FROM_REST = _integrals(lambda z: z)  # of what falls to zero where the mass starts from rest
TO_REST = FROM_REST[:NODES][::-1, ::-1].copy()  # from each node to 1, where it comes to rest

# How far along a panel the nodes and the end lie, and the rate of that; the second column where the mass stands still
# at the end: there the time is smooth in the root of the distance.
_PLACES = np.append(Z, 1.0)[:, None]
SHARES = np.hstack([_PLACES, _PLACES * (2.0 - _PLACES)])
RATES = np.hstack([np.ones_like(_PLACES), 2.0 * (1.0 - _PLACES)])


def way_of(span: Any, sinh: Any, cosh: Any) -> Any:
    """How far x moves over a span of its variable, a hyperbolic angle: as from rest under a drive that grows with x.

    x = pace (cosh - 1) from rest, x = pace (exp - 1) in motion: both are smooth where E, or what friction lost, first
    grows in proportion to x and then with a power of it.
    """
    grown = np.expm1(span)
    return sinh * grown + (cosh - sinh) * (0.5 * grown * grown / (1.0 + grown))


def span_of(way: Any, sinh: Any, cosh: Any) -> Any:
    """The inverse of `way_of`."""
    root = np.sqrt(sinh * sinh + way * way + 2 * way * cosh)
    return np.log1p(np.where(way > sinh, (way - sinh + root) / (cosh + sinh), 2 * way / (sinh - way + root)))


def turned(angle: Floats) -> tuple[Floats, Floats]:
    """sin and 1 - cos of angles up to `TURN`, by the series of the half angle's sine."""
    square = 0.25 * angle * angle
    s = square * (-1.0 / math.factorial(15))
    for k in range(13, 0, -2):
        s += (1.0 if k % 4 == 1 else -1.0) / math.factorial(k)
        s *= square if k > 1 else 0.5 * angle
    lift = 2.0 * s * s
    s *= 2.0
    return s * np.sqrt(1.0 - 0.5 * lift), lift


def rises(values: Floats) -> Floats:
    """How far along each panel a function first rises above zero, from its values at the nodes and the end."""
    first, edges = np.argmax(values > 0.0, axis=0), np.concatenate([[0.0], Z, [1.0]])
    low, high, inside = edges[first], edges[first + 1], values[:NODES]
    z = 0.5 * (low + high)
    for _ in range(6):  # Newton's method, on the interpolation
        share = _BARYCENTRIC / (z - Z[:, None])
        whole = share.sum(axis=0)
        value = (share * inside).sum(axis=0) / whole
        slope = (share * (value - inside) / (z - Z[:, None])).sum(axis=0) / whole
        low, high = np.where(value > 0.0, low, z), np.where(value > 0.0, z, high)
        z = z - value / slope
        z = np.where((z >= low) & (z <= high), z, 0.5 * (low + high))
    return z
