"""Points of the unit cube: Monte Carlo, scrambled Sobol sequences, Latin hypercubes.

Any stretch of a sequence is a pure function of its seed and its place, so that blocks may be drawn anywhere and in any
order, and that a longer run begins with the points of a shorter one (but for Latin hypercubes, which are made whole).
Monte Carlo needs NumPy alone; the others are SciPy's.
"""

import warnings
from functools import lru_cache

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.workbench.common.distributions import statistics

MOST_LATIN = 2**24
_LOWEST = 2.0**-54  # 0 and 1 have no quantile
_HIGHEST = 1.0 - 2.0**-53


def _seeded(seed: int, stream: tuple[int, ...]) -> np.random.SeedSequence:
    return np.random.SeedSequence(seed, spawn_key=stream)


def monte_carlo(seed: int, stream: tuple[int, ...], start: int, count: int, dimensions: int) -> Floats:
    """Random points ``start`` to ``start + count``, an array (dimensions, count); start a multiple of 4.

    The counter of Philox is set to the place: it gives four numbers a step.
    """
    philox = np.random.Philox(_seeded(seed, stream))
    generator = np.random.Generator(philox.advance(start * dimensions // 4))
    points = generator.random((count, dimensions))
    return np.maximum(points.T, _LOWEST)


@lru_cache(4)
def latin(seed: int, count: int, dimensions: int) -> Floats:
    """A Latin hypercube, (dimensions, count): each coordinate has one point in each of ``count`` equal strata."""
    hypercube = statistics().qmc.LatinHypercube(dimensions, rng=_seeded(seed, (3,)))
    points = np.ascontiguousarray(hypercube.random(count).T)
    return np.clip(points, _LOWEST, _HIGHEST)


def sobol(seed: int, stream: tuple[int, ...], start: int, count: int, dimensions: int) -> Floats:
    """Points ``start`` to ``start + count`` of a scrambled Sobol sequence (Owen 1998), (dimensions, count)."""
    sequence = statistics().qmc.Sobol(dimensions, rng=_seeded(seed, stream))
    with warnings.catch_warnings(action="ignore", category=UserWarning):  # that some counts are not balanced
        if start:
            sequence.fast_forward(start)
        points = np.ascontiguousarray(sequence.random(count).T)
    return np.clip(points, _LOWEST, _HIGHEST)
