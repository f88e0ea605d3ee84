"""First circles of a search below many soils, and unit weights that make its first descents fast."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.workbench.stability.columns import SlopeArrays
from slipcircle.workbench.stability.descent import sorted_indices
from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.slices import Rule

MANY_SOILS = 20  # boundaries; with more, the coarse family is screened without kinks
_SAMPLED = Rule(nodes=2, pieces=6, at_kinks=False)
_SCREENED = 160  # number of best circles kept
_BELOW = 2  # number of boundaries that circles between two points touch
_GROUPS = 8  # of layers with a common unit weight
_THIN = 1e-9  # m, added to each layer, so that a layer above the ground has a thickness


def screened(search: Search) -> ArrayPair:
    """Return the best circles of the coarse family, and of circles from outcrops of boundaries, with their steps.

    Both are (circles, 4) as in `family`. Below a thin weak layer the lowest factors belong to circles that leave the
    slope where its top crops out and touch its bottom, of which the coarse family has few.
    """
    families = zip(search.coarse_family(touching=False), _from_outcrops(search), strict=True)
    q, steps = map(np.concatenate, families)
    values = search.evaluate(q, _SAMPLED)
    best = sorted_indices(values)[:_SCREENED]
    return q[best], steps[best]


def with_nearest_boundaries(search: Search, q: Floats) -> Floats:
    """Return circles (n, 4) as in `family`, and behind them circles with the same ends that touch the nearest edge."""
    angle = search.half_angles(q)
    touching = search.half_angles(search.touching_every_edge(q)).reshape(-1, len(q))
    apart = np.abs(touching - angle)
    nearest = q.copy()
    nearest[:, 3] = np.nan_to_num(apart, nan=np.inf).argmin(axis=0)
    return np.concatenate([q, nearest])


def _from_outcrops(search: Search) -> ArrayPair:
    """Return circles that end where a boundary crops out and touch one of the next boundaries below, and their steps.

    Both are (circles, 4) as in `family`.
    """
    ends = search.positions()
    pairs = np.meshgrid(_outcrops(search), ends)
    lengths = np.sort(np.reshape(pairs, (2, -1)), axis=0)
    q = np.pad(lengths.T, [(0, 0), (0, 2)], constant_values=1.0)
    q = q[search.possible(q)]
    touching = search.touching_every_edge(q)
    centre, radius, left, right = search.circles(touching)
    x = centre[:, 0]
    is_lowest_between = np.isfinite(radius) & (left[:, 0] < x) & (x < right[:, 0])
    by_edge = is_lowest_between.reshape(-1, len(q))
    next_below = by_edge & (np.cumsum(by_edge, axis=0) <= _BELOW)
    of_circles = touching.reshape(-1, len(q), 4).swapaxes(0, 1)
    chosen = of_circles[next_below.T]
    spacing = np.interp(chosen[:, :2], ends, np.gradient(ends))
    return chosen, np.pad(spacing, [(0, 0), (0, 2)])


def _outcrops(search: Search) -> Floats:
    """Return the lengths along the ground in m at which boundaries meet it."""
    arrays = search.arrays
    columns = arrays.columns
    tops = columns.height[: len(arrays.tops) + 1, 0]
    at_ground = np.count_nonzero(tops == tops[0], axis=0)
    changes = np.flatnonzero(np.diff(at_ground))
    return np.interp(columns.bounds[0, changes], search.ground[:, 0], search.along)


def with_few_unit_weights(arrays: SlopeArrays) -> SlopeArrays:
    """Return one slope with the mean unit weights of a few groups of layers, by which the weight hardly changes.

    The paper's method sums over all steps of the unit weight above each point of an arc.
    """
    layers = len(arrays.tops) + 1
    height = arrays.columns.height[:layers, 0].mean(axis=1)
    thickness = _THIN - np.diff(height, append=height[-1])
    group = np.arange(layers) * _GROUPS // layers
    total = np.bincount(group, thickness)

    def means(values: Floats) -> Floats:
        weighted = values[:, 0] * thickness
        mean = np.bincount(group, weighted) / total
        return np.round(mean[group, None], 3)  # so that rounding leaves no steps

    soils = arrays.soils
    few = soils._replace(unit_weight=means(soils.unit_weight), saturated_unit_weight=means(soils.saturated_unit_weight))
    return replace(arrays, soils=few)
