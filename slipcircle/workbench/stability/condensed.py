"""Search for the best circles on simplified lines, for slopes with many vertices or soils.

The cost of a search is proportional to the number of vertices, up to a thousand in surveyed profiles. A condensed line
has few vertices, whose heights are fitted by least squares, so that areas and moments are preserved. The results refer
to the complete lines.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.workbench.stability.descent import FINEST, sorted_indices
from slipcircle.workbench.stability.family import COARSE, NONE, Search
from slipcircle.workbench.stability.manysoils import (
    MANY_SOILS,
    screened,
    with_few_unit_weights,
    with_nearest_boundaries,
)
from slipcircle.workbench.stability.slices import Rule

MANY_VERTICES = 48  # lines with more vertices are condensed
_ROUGH, _DEVIATION = 20, 1e-3  # vertices of a line, and relative distance of the others from it
_ROUGHLY = 1e-3  # final step in a valley of the rough lines, relative to its first step
_FINE, _BESIDE = 48, 16  # vertices of a line near the best circles, and on either side of their ends
_STEPS = 2.0, 0.7, 0.2  # of the refinements, relative to the coarse family
_FOLLOWED = 12  # greatest number of valleys on rough lines
_MANY_KINKS = Rule(nodes=2, pieces=6)
_LAST, _FINEST_LAST = 0.05, 4e-4  # first step with all unit weights, relative to the coarse family, and the final one
_NEGLIGIBLE = 1e-9  # distance of vertices without effect, as a share of the size of their line


def least(search: Search, tell: Callable[[str], None]) -> Floats:
    """Return the best circles, (circles, 4) as in `family`, the best first, after a coarse family and descents.

    ``tell`` is called with a line of progress.
    """
    on_rough_lines, kept = _condensed(search, _ROUGH, _DEVIATION, np.empty(0))
    if len(search.arrays.tops) >= MANY_SOILS:
        rough = on_rough_lines.on_lines(with_few_unit_weights(on_rough_lines.arrays))
        family, rule = screened(rough), _MANY_KINKS
    else:
        rough = on_rough_lines
        family, rule = rough.coarse_family(), COARSE
    best, step = rough.valleys(*family, tell, rule)
    if rough is search:
        for share in (1.0, 0.2):  # restarted, in case a bent valley has stopped the descent
            best, step = search.refined(best, share * step)
        return best
    best, step = rough.refined(best[:_FOLLOWED], step[:_FOLLOWED], _ROUGHLY, rule)
    if on_rough_lines is search:
        best = with_nearest_boundaries(rough, best)
        best, step = rough.refined(best, np.concatenate([step, step]), _ROUGHLY, rule)
        best, _ = search.refined(best, _LAST * step, _FINEST_LAST, rule)
        return best
    best = _on_whole_lines(search, rough, kept, best)
    return _on_fine_lines(search, best, step)


def _on_fine_lines(search: Search, best: Floats, step: Floats) -> Floats:
    """Return the best circles, the best first, after descents on lines with all vertices near their ends.

    ``best`` and ``step`` are circles on the complete lines and the steps of their grids, (circles, 4) as in `family`.
    """
    fine, kept = _condensed(search, _FINE, _NEGLIGIBLE, best[:, :2])
    along = search.along[kept]
    ends = best[:, :2]
    best[:, :2] = np.interp(ends, along, fine.along)
    for share in _STEPS:
        best, step = fine.refined(best, share * step, FINEST, _MANY_KINKS)
    best = _on_whole_lines(search, fine, kept, best)

    values = search.evaluate(best)
    finite = np.isfinite(values)
    if np.any(finite):
        order = sorted_indices(values)
        return best[order]
    best, _ = search.refined(best, step)
    return best


def _condensed(search: Search, most: int, deviation: float, ends: Floats) -> tuple[Search, Integers]:
    """Return a search on condensed lines, and the indices of the vertices kept on the ground.

    A line keeps at most ``most`` vertices, until the others are within ``deviation``, as in `salient`.

    Vertices near the lengths ``ends`` along the ground, and vertices of upright parts, keep their heights. A search
    without long lines is returned itself.
    """
    ground = search.ground
    arrays = search.arrays
    kept = np.arange(len(ground))
    lines = [*arrays.lines, *arrays.datums.values()]
    if max(line.shape[1] for line in lines) <= MANY_VERTICES + 2:  # with both ends of continued lines
        return search, kept
    x = ground[:, 0]
    after = x[1:]
    upright = after[after == x[:-1]]
    exact = np.isin(x, upright)
    exact[[0, -1]] = True
    numbers = np.searchsorted(search.along, ends.ravel())
    for number in numbers:
        before = number - _BESIDE
        first = max(before, 0)
        last = number + _BESIDE
        exact[first:last] = True
    if len(ground) > MANY_VERTICES:
        chosen = salient(ground, most, deviation)
        fixed = np.flatnonzero(exact)
        kept = np.union1d(chosen, fixed)
        ground = condensed(ground, kept, exact)
    level = None if arrays.level is None else _few(arrays.level, most)
    tops = tuple(_few(top, most) for top in arrays.tops)
    datums = {layer: _few(line, most) for layer, line in arrays.datums.items()}
    condensed_arrays = replace(arrays, ground=ground[None], level=level, tops=tops, datums=datums)
    return search.on_lines(condensed_arrays), kept


def _few(line: Floats, most: int) -> Floats:
    """Return a line (1, V, 2) with at most ``most`` of its vertices if it has many."""
    if line.shape[1] <= MANY_VERTICES:
        return line
    (points,) = line
    kept = salient(points, most, _NEGLIGIBLE)
    return line[:, kept]


def _on_whole_lines(search: Search, condensed: Search, kept: Integers, q: Floats) -> Floats:
    """Return circles of a search on condensed lines as circles on the complete lines, (circles, 4) as in `family`.

    ``q`` are the circles, and ``kept`` the indices of the ground vertices that the condensed ground retains.
    """
    circles = q.copy()
    if len(condensed.boundary_edges) != len(search.boundary_edges):  # then boundaries have other numbers
        circles[:, 2] = condensed.half_angles(q) / condensed.greatest_half_angle(q)
        circles[:, 3] = NONE
    ends = q[:, :2]
    along = search.along[kept]
    circles[:, :2] = np.interp(ends, condensed.along, along)
    return circles


def salient(line: Floats, most: int, deviation: float) -> Integers:
    """Return the sorted indices of at most ``most`` vertices that represent a line (V, 2).

    Vertices farthest from the line through those chosen before are chosen first (Ramer 1972, Douglas and Peucker 1973),
    until none is farther than ``deviation`` times the size of the line.
    """
    size = np.ptp(line, axis=0)
    near = deviation * size.max()
    every = np.arange(len(line))
    kept = every[[0, -1]]
    while len(kept) < most:
        edge = _edges(kept, len(line))
        knots = line[kept]
        start = knots[edge]
        along = knots[edge + 1] - start
        from_start = line - start
        run, rise = along.T
        x, y = from_start.T
        across = run * y - rise * x
        distance = np.abs(across) / np.hypot(run, rise)
        farthest = int(distance.argmax())
        if distance[farthest] <= near:
            break
        more = np.append(kept, farthest)
        kept = np.sort(more)
    return kept


def _edges(kept: Integers, count: int) -> Any:
    """Return the index of the edge, between sorted vertices ``kept``, that contains each of ``count`` vertices."""
    every = np.arange(count)
    edge = np.searchsorted(kept, every, side="right") - 1
    return np.minimum(edge, len(kept) - 2)


def condensed(line: Floats, kept: Integers, exact: Flags) -> Floats:
    """Return the line through the vertices with indices ``kept``, with heights fitted to the complete line.

    Heights of vertices in the mask ``exact``, (V,), are unchanged.

    The least-squares fit preserves areas and moments, so that forces on a mass below are nearly the same.
    """
    x, y = line.T
    edge = _edges(kept, len(line))
    knots = x[kept]
    start = knots[edge]
    run = knots[edge + 1] - start
    divisor = np.where(run > 0.0, run, 1.0)
    share = (x - start) / divisor
    share[kept[-1]] = 1.0
    weights = np.zeros((len(line), len(kept)))
    every = np.arange(len(line))
    weights[every, edge] = 1.0 - share
    weights[every, edge + 1] = share
    height = y[kept].copy()
    fitted = ~exact[kept]
    unchanged = np.where(fitted, 0.0, height)
    missing = y - weights @ unchanged
    breadth = np.gradient(x)
    root = np.sqrt(breadth)
    matrix = weights[:, fitted] * root[:, None]
    right = missing * root
    height[fitted], *_ = np.linalg.lstsq(matrix, right)
    return np.stack([knots, height], axis=1)
