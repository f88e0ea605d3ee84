"""Division of intervals into sections."""

from collections.abc import Callable

import numpy as np

from slipcircle.base.kinds import Flags, Floats


def first_section(
    holds: Callable[[Floats], Flags], low: Floats, high: Floats, shares: Floats
) -> tuple[Floats, Floats, Flags]:
    """Return the ends of the first section of each interval in which a condition changes from false to true.

    Parameters
    ----------
    holds : callable
        Condition as a function of places of shape (shares, intervals).
    low, high : ndarray
        Ends of the intervals, (intervals,).
    shares : ndarray
        Positions of the section ends relative to the interval, increasing from 0 to 1, (shares,).

    Returns
    -------
    low, high, found : ndarray
        Ends of the sections, and whether such a section exists. If not, the ends are those of the first section.
    """
    edges = low + shares[:, None] * (high - low)
    here = holds(edges)
    begins = ~here[:-1] & here[1:]
    first = begins.argmax(axis=0)
    every = np.arange(low.size)
    return edges[first, every], edges[first + 1, every], np.any(begins, axis=0)


def distinct(edges: Floats, least: float) -> Floats:
    """Return section edges of shape (edges, n), increasing, without sections of a width up to ``least``.

    Each of the n columns is an interval divided into sections. The first and the last edge remain. Columns with fewer
    edges repeat the last one.
    """
    inner = edges[1:-1]
    last = edges[-1]
    width = np.minimum(inner - edges[:-2], last - inner)
    in_order = np.sort(np.where(width > least, inner, last), axis=0)
    used = np.any(in_order < last, axis=1)
    return np.vstack([edges[:1], in_order[used], last])
