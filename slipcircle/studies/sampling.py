"""Points in the open unit cube: Monte Carlo, scrambled Sobol sequences, Latin hypercubes.

Any stretch of a sequence is a pure function of its seed and its place, so that blocks may be drawn anywhere and in any
order, and that a longer run begins with the points of a shorter one (but for Latin hypercubes, which are made whole).
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
MOST_LATIN = 2**24
_BITS = 30  # of a coordinate of a Sobol point, and so the logarithm of how many there are
_LOWEST = 2.0**-54


def _source(seed: int, *stream: int) -> np.random.SeedSequence:
    return np.random.SeedSequence(seed, spawn_key=stream)


def monte_carlo(seed: int, stream: tuple[int, ...], start: int, count: int, dimensions: int) -> Floats:
    """Random points ``start`` to ``start + count``, an array (dimensions, count); start a multiple of 4.

    The counter of Philox is set to the place: it gives four numbers a step.
    """
    generator = np.random.Philox(_source(seed, *stream)).advance(start * dimensions // 4)
    points = np.random.Generator(generator).random((count, dimensions)).T
    return np.maximum(points, _LOWEST)  # 0 has no quantile


@lru_cache(4)
def latin(seed: int, count: int, dimensions: int) -> Floats:
    """A Latin hypercube, (dimensions, count): each coordinate has one point in each of ``count`` equal strata."""
    points = np.empty((dimensions, count))
    for k in range(dimensions):
        rng = np.random.default_rng(_source(seed, 3, k))
        points[k] = (rng.permutation(count) + rng.random(count)) / count
    return np.clip(points, _LOWEST, 1.0 - 2.0**-53)


def directions(seed: int, stream: tuple[int, ...], count: int, dimensions: int) -> NDArray[np.uint32]:
    """A scrambled Sobol sequence as integers, from which any stretch of its first ``count`` points follows.

    SciPy's, read off where one bit of the Gray code changes: column 0 is the first point, column b + 1 what the point
    2**b differs by from the one before it.
    """
    import warnings

    from scipy.stats import qmc

    sequence = qmc.Sobol(dimensions, bits=_BITS, rng=np.random.default_rng(_source(seed, *stream)))
    found = np.empty((dimensions, max(count - 1, 0).bit_length() + 1), np.uint32)

    def following() -> NDArray[np.uint32]:
        return (sequence.random(1)[0] * 2.0**_BITS).astype(np.uint32)

    last = found[:, 0] = following()
    with warnings.catch_warnings(action="ignore"):  # that single points are not balanced
        for b in range(found.shape[1] - 1):
            if sequence.num_generated < 2**b:
                sequence.fast_forward(2**b - sequence.num_generated - 1)
                last = following()
            last, before = following(), last
            found[:, b + 1] = last ^ before
    return found


def sobol(table: NDArray[np.uint32], start: int, count: int) -> Floats:
    """Points ``start`` to ``start + count`` of the sequence of `directions`, (dimensions, count).

    In Gray code the second half of 2**(b + 1) points is the first one backwards, with one direction added; and a
    stretch from a multiple of its length is the first stretch with the directions of that multiple added.
    """
    length = max(count - 1, 0).bit_length()
    if start % 2**length:
        raise ValueError(f"a stretch of {count} points cannot begin at {start}")
    points = np.zeros((len(table), 2**length), np.uint32)
    for b in range(length):
        half = 2**b
        points[:, half : 2 * half] = points[:, :half][:, ::-1]
        points[:, half : 2 * half] ^= table[:, b + 1, None]
    offset = table[:, 0].copy()
    gray = start ^ (start >> 1)
    for b in range(table.shape[1] - 1):
        if gray >> b & 1:
            offset ^= table[:, b + 1]
    integers = points[:, :count] ^ offset[:, None]
    return (integers.astype(np.float64) + 0.5) * 2.0**-_BITS
