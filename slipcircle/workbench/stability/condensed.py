"""The search for the best circles, on lines of few vertices and with few soils where the slope has many.

Surveyed profiles have a thousand vertices, which take time in proportion. A condensed line has few of them, whose
heights are fitted by least squares, so that areas and moments are preserved. Results are those of the whole lines.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.workbench.stability.columns import SoilArrays
from slipcircle.workbench.stability.descent import FINEST, in_order
from slipcircle.workbench.stability.family import COARSE_NODES, FINE_NODES, NONE, Search

MANY_VERTICES = 48  # of a line; one with more is condensed
MANY_SOILS = 20  # with more, the coarse family is screened with merged soils
_ROUGH, _DEVIATION = 14, 1e-3  # vertices of a line in the coarse family, and others' distance over its size
_ROUGHLY = 0.02  # step at which a valley of the rough lines is done, over its first
_FINE, _BESIDE = 48, 16  # vertices of a line near the best circles, besides those on either side of their ends
_STEPS = (0.5, 3), (0.1, 2)  # of these refinements, over those of the coarse family, and how many circles
_FOLLOWED = 24  # valleys of rough lines, at most
_ROUGH_NODES = 2  # of Gauss' rule, between the kinks of many layers
_MERGED = 16  # soils in their place
_SCREENED, _TOUCHING = 500, 20  # best circles of the coarse family, and those of which all boundaries are tried
_NEGLIGIBLE = 1e-9  # distance of vertices without effect, as a share of the size of their line


def least(search: Search, tell: Callable[[str], None]) -> Floats:
    """Return the best circles, the best first, after descents from the valleys of a coarse family."""
    arrays = search.arrays
    many_soils = len(arrays.tops) >= MANY_SOILS
    vertices = [line.shape[1] for line in (*arrays.lines, *arrays.datums.values())]
    if max(vertices) <= MANY_VERTICES + 2 and not many_soils:  # with both ends of the continued line
        best, step = search.valleys(*search.coarse_family(), tell)
        for share in (1.0, 0.2):  # begun again from where they stopped, where a bent valley has held them up
            best, step = search.refined(best, share * step)
        return best
    rough, kept = _condensed(search, _ROUGH, _DEVIATION, np.empty(0))
    family = _screened(rough) if many_soils else rough.coarse_family()
    best, step = rough.valleys(*family, tell)
    best, step = rough.refined(best[:_FOLLOWED], step[:_FOLLOWED], _ROUGHLY, COARSE_NODES)
    best = _on_whole_lines(search, rough, kept, best)
    fine, kept = _condensed(search, _FINE, _NEGLIGIBLE, best[:, :2])
    best[:, :2] = np.interp(best[:, :2], search.along[kept], fine.along)
    nodes = COARSE_NODES if many_soils else FINE_NODES
    for share, count in _STEPS:
        best, step = fine.refined(best[:count], share * step[:count], FINEST, nodes)
    best = _on_whole_lines(search, fine, kept, best)
    values = search.evaluate(best)
    if np.any(np.isfinite(values)):
        return best[in_order(values)]
    best, _ = search.refined(best, step)
    return best


def _screened(search: Search) -> tuple[Floats, Floats]:
    """Return the best of the coarse family with merged soils, some touching each boundary, and the steps."""
    arrays = search.arrays
    soils, firsts = merged(arrays.soils, _MERGED)
    tops = tuple(arrays.tops[k - 1] for k in firsts[1:])
    groups = np.searchsorted(firsts, [*arrays.datums], side="right") - 1
    datums = dict(zip(groups.tolist(), arrays.datums.values(), strict=True))
    few = search.on_lines(replace(arrays, soils=soils, tops=tops, datums=datums))
    q, steps = few.coarse_family(touching=False)
    values = few.evaluate(q, _ROUGH_NODES)
    best = in_order(values)[:_SCREENED]
    edges = np.arange(len(search.boundary_edges))
    repeated = np.repeat(best[:_TOUCHING], len(edges))
    touching = q[repeated]
    touching[:, 3] = np.resize(edges, len(repeated))
    chosen = np.append(best, repeated)
    return np.concatenate([q[best], touching]), steps[chosen]


def _condensed(search: Search, most: int, deviation: float, ends: Floats) -> tuple[Search, Integers]:
    """Return a search on condensed lines, and the numbers of the vertices of the ground.

    Vertices near some lengths along the ground, and those of upright parts, stay where they are.
    """
    ground = search.ground
    arrays = search.arrays
    x = ground[:, 0]
    upright = x[1:][np.diff(x) == 0.0]
    exact = np.isin(x, upright)
    exact[[0, -1]] = True
    for number in np.searchsorted(search.along, ends.ravel()):
        exact[max(number - _BESIDE, 0) : number + _BESIDE] = True
    kept = np.arange(len(ground))
    if len(ground) > MANY_VERTICES:
        kept = np.union1d(salient(ground, most, deviation), np.flatnonzero(exact))
        ground = condensed(ground, kept, exact)
    level = None if arrays.level is None else _few(arrays.level, most)
    tops = tuple(_few(top, most) for top in arrays.tops)
    datums = {layer: _few(line, most) for layer, line in arrays.datums.items()}
    condensed_arrays = replace(arrays, ground=ground[None], level=level, tops=tops, datums=datums)
    return search.on_lines(condensed_arrays), kept


def _few(line: Floats, most: int) -> Floats:
    """Return a line (1, V, 2) by few of its vertices."""
    if line.shape[1] <= MANY_VERTICES:
        return line
    return line[:, salient(line[0], most, _NEGLIGIBLE)]


def _on_whole_lines(search: Search, condensed: Search, kept: Integers, q: Floats) -> Floats:
    """Return circles of a search on condensed lines as circles on the whole lines."""
    found = q.copy()
    if len(condensed.boundary_edges) != len(search.boundary_edges):  # which have other numbers
        left = condensed.points(q[:, 0])
        right = condensed.points(q[:, 1])
        found[:, 2] = condensed.half_angles(q) / condensed.greatest_half_angle(left, right)
        found[:, 3] = NONE
    found[:, :2] = np.interp(q[:, :2], condensed.along, search.along[kept])
    return found


def salient(line: Floats, most: int, deviation: float) -> Integers:
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
    known = np.where(fitted, 0.0, height)
    missing = y - weights @ known
    breadth = np.gradient(x)
    root = np.sqrt(np.maximum(breadth, 0.0))
    matrix = weights[:, fitted] * root[:, None]
    height[fitted], *_ = np.linalg.lstsq(matrix, missing * root)
    return np.stack([x[kept], height], axis=1)


def merged(soils: SoilArrays, most: int) -> tuple[SoilArrays, Any]:
    """Return so many soils, means of neighbours that differ least, and the number of the first layer of each."""
    rows = np.stack([soils.unit_weight, soils.cohesion, soils.friction, soils.pore_ratio, soils.cohesion_gradient])
    size = np.abs(rows).max(axis=1, keepdims=True)
    relative = rows / np.where(size > 0.0, size, 1.0)
    steps = np.abs(np.diff(relative, axis=1))
    contrast = steps.sum(axis=0).max(axis=-1)
    greatest = np.argsort(-contrast, kind="stable")
    kept = np.sort(greatest[: most - 1])
    firsts = np.append(0, kept + 1)
    ends = np.append(firsts, rows.shape[1])
    layers = np.diff(ends)[:, None]

    def mean(values: Floats) -> Floats:
        return np.add.reduceat(values, firsts) / layers

    return SoilArrays(*map(mean, soils)), firsts
