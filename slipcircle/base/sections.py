"""Intervals and their sections: which are distinct, and where something begins to hold."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats

Mask = NDArray[np.bool_]


def first_section(
    holds: Callable[[Floats], Mask], low: Floats, high: Floats, shares: Floats
) -> tuple[Floats, Floats, Mask]:
    """The ends of the first section of each interval at whose end something holds and at whose beginning it does not.

    Parameters
    ----------
    holds : callable
        Of places, (shares, intervals).
    low, high : ndarray
        The intervals.
    shares : ndarray
        Where they are divided, from 0 to 1.

    Returns
    -------
    low, high, found : ndarray
        Ends of the sections, those of the first where there is none, and whether there is one.
    """
    edges = low + shares[:, None] * (high - low)
    here = holds(edges)
    begins = ~here[:-1] & here[1:]
    first = begins.argmax(axis=0)
    every = np.arange(low.size)
    return edges[first, every], edges[first + 1, every], np.any(begins, axis=0)


def distinct(edges: Floats, least: float) -> Floats:
    """Edges of sections, (edges, n), increasing, without those that only rounding, a width up to ``least``, parts.

    The first and the last stay. Where others have more of them, the last is repeated.
    """
    inner = edges[1:-1]
    last = edges[-1]
    width = np.minimum(inner - edges[:-2], last - inner)
    in_order = np.sort(np.where(width > least, inner, last), axis=0)
    used = np.any(in_order < last, axis=1)
    return np.vstack([edges[:1], in_order[used], last])
