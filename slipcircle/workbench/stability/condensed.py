"""Lines of many vertices, such as surveyed profiles, and many soils by few: for searches, not for results."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.workbench.stability.columns import SoilArrays

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


def merged(soils: SoilArrays, most: int) -> tuple[SoilArrays, Any]:
    """Return so many soils, means of neighbours that differ least, and the number of the first layer of each."""
    rows = np.stack([soils.unit_weight, soils.cohesion, soils.friction, soils.pore_ratio, soils.cohesion_gradient])
    size = np.maximum(np.abs(rows).max(axis=1, keepdims=True), 1e-300)
    contrast = np.abs(np.diff(rows / size, axis=1)).sum(axis=0).max(axis=-1)
    firsts = np.append(0, np.sort(np.argsort(-contrast, kind="stable")[: most - 1]) + 1)
    layers = np.diff(np.append(firsts, rows.shape[1]))

    def mean(values: Floats) -> Floats:
        return np.add.reduceat(values, firsts) / layers[:, None]

    means = SoilArrays(*map(mean, soils))
    growth = np.where(means.cohesion_gradient > 0.0, means.cohesion_gradient, 1.0)
    datum = mean(soils.cohesion_gradient * soils.datum) / growth
    return means._replace(datum=datum), firsts
