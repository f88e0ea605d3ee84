"""Points in the unit cube from Monte Carlo sampling and scrambled Sobol sequences.

Any part of a sequence is a pure function of its seed and position, so that blocks may be drawn anywhere and in any
order, and a longer run begins with the points of a shorter run. Monte Carlo needs only NumPy; Sobol sequences need
SciPy.
"""

import warnings

import numpy as np

from slipcircle.base.kinds import Floats, Shape
from slipcircle.workbench.common.distributions import statistics

_LOWEST = 2.0**-54  # quantiles of 0 and 1 may be infinite
_HIGHEST = 1.0 - 2.0**-53


def _seeded(seed: int, stream: Shape) -> np.random.SeedSequence:
    """Return NumPy's seed sequence of a stream, a spawn key, below a seed."""
    return np.random.SeedSequence(seed, spawn_key=stream)


def monte_carlo(seed: int, stream: Shape, start: int, count: int, dimensions: int) -> Floats:
    """Draw random points ``start`` to ``start + count``, (dimensions, count); start is a multiple of 4.

    ``stream`` is the spawn key of independent random numbers.

    The counter of Philox is set to the position; each step gives four numbers.
    """
    generator = np.random.Generator(np.random.Philox(_seeded(seed, stream)).advance(start * dimensions // 4))
    return np.maximum(generator.random((count, dimensions)).T, _LOWEST)


def sobol(seed: int, stream: Shape, start: int, count: int, dimensions: int) -> Floats:
    """Draw points ``start`` to ``start + count`` of a scrambled Sobol sequence (Owen 1998), (dimensions, count).

    ``stream`` is the spawn key of an independent scrambling.
    """
    sequence = statistics().qmc.Sobol(dimensions, rng=_seeded(seed, stream))
    with warnings.catch_warnings(action="ignore", category=UserWarning):  # about unbalanced counts
        if start:
            sequence.fast_forward(start)
        points = np.ascontiguousarray(sequence.random(count).T)
    return np.clip(points, _LOWEST, _HIGHEST)
