"""Lines of many vertices, such as surveyed profiles, by few: for searches, not for results."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers

_NEGLIGIBLE = 1e-9  # of the size of a line: vertices as near to the others' line have no effect


def salient(line: Floats, most: int, deviation: float = _NEGLIGIBLE) -> Integers:
    """Return the numbers of vertices that represent a line (V, 2), at most so many.

    Vertices farthest from the line through those chosen before are chosen first (Ramer 1972, Douglas and Peucker 1973),
    until none is farther than ``deviation`` times the size of the line.
    """
    near = deviation * np.ptp(line, axis=0).max()
    every = np.arange(len(line))
    kept = every[[0, -1]]
    while len(kept) < most:
        edge = _edges(kept, len(line))
        start = line[kept[edge]]
        along = line[kept[edge + 1]] - start
        from_start = line - start
        across = along[:, 0] * from_start[:, 1] - along[:, 1] * from_start[:, 0]
        distance = np.abs(across) / np.hypot(*along.T)
        farthest = int(distance.argmax())
        if distance[farthest] <= near:
            break
        kept = np.sort(np.append(kept, farthest))
    return kept


def _edges(kept: Integers, count: int) -> Any:
    """Return the number of the edge between kept vertices at each of so many vertices."""
    edge = np.searchsorted(kept, np.arange(count), side="right") - 1
    return np.minimum(edge, len(kept) - 2)


def condensed(line: Floats, kept: Integers, exact: Flags) -> Floats:
    """Return the line through some vertices, whose heights are fitted to all by least squares unless they are exact.

    The fit preserves areas and moments, so that forces on a mass below it are nearly the same.
    """
    x, y = line.T
    edge = _edges(kept, len(line))
    start = x[kept[edge]]
    run = x[kept[edge + 1]] - start
    share = (x - start) / np.where(run > 0.0, run, 1.0)
    share[kept[-1]] = 1.0
    weights = np.zeros((len(line), len(kept)))
    every = np.arange(len(line))
    weights[every, edge] = 1.0 - share
    weights[every, edge + 1] = share
    height = y[kept].copy()
    fitted = ~exact[kept]
    missing = y - weights @ np.where(fitted, 0.0, height)
    breadth = np.sqrt(np.maximum(np.gradient(x), 0.0))[:, None]
    height[fitted] = np.linalg.lstsq(breadth * weights[:, fitted], breadth[:, 0] * missing)[0]
    return np.stack([x[kept], height], axis=1)
