"""Where something begins to hold: the first of the sections of intervals."""

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
