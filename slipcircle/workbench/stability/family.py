"""Many circles of a slope at once: a coarse family between points of its ground, and refinement of the best.

A circle is four numbers: two lengths along the ground, of its ends from the left, its opening as a share of the
greatest one, at which it is upright at an end or touches the base; and the edge of a boundary between layers that it
touches from above in the place of that share, -1 of most circles, which touch none. Factors have kinks where a circle
begins to cut a layer, so that the least may stand there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from copy import copy
from itertools import pairwise
from typing import Any

import numpy as np

from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.base.progress import counted
from slipcircle.ground import circle_through, circle_touching
from slipcircle.workbench.stability.bases import Circles, angle_from_below
from slipcircle.workbench.stability.columns import SlopeArrays
from slipcircle.workbench.stability.descent import FINEST, Descent, sorted_indices
from slipcircle.workbench.stability.factors import YIELD, factors_by
from slipcircle.workbench.stability.slices import EXACT, Rule
from slipcircle.workbench.stability.stability import Slope

_POSITIONS = 40  # of ends, evenly along the ground
_LEAST_ON_EDGE = 7  # on each edge of a ground of few edges: the slope between wide level parts may be short
_FEW_EDGES = 12
_MOST_VERTICES = 48  # of a ground; of more, those nearest to even places
_SHARES = np.array([0.04, 0.08, 0.13, 0.19, 0.26, 0.34, 0.43, 0.53, 0.64, 0.76, 0.88, 1.0])
COARSE, FINE = Rule(4), Rule(6)
_VALLEYS = 12  # that are refined
_VALLEYS_ON_EDGE = 2  # of those that touch an edge of a boundary
_APART = 2.5  # spacings of the coarse family between valleys
_STEPS = 150  # of a refinement, at most
_KEPT = 3  # of refined valleys
_TOGETHER = 1 << 16  # kinks times circles in a block, which fits into the caches
NONE = -1.0  # no edge is touched
_JUST_BELOW = 1 - 1e-12


def _length(vectors: Floats) -> Floats:
    """Return the lengths of vectors (..., 2)."""
    return np.hypot(vectors[..., 0], vectors[..., 1])


def _upwards(vectors: Floats) -> Floats:
    """Return unit vectors perpendicular to vectors (n, 2): upwards for vectors to the right."""
    x, y = vectors.T
    return np.stack([-y, x], axis=1) / _length(vectors)[:, None]


def _touching_half_angle(left: Floats, right: Floats, edge: Floats) -> Floats:
    """Return half the opening in rad of arcs between points (n, 2) that touch lines through edges (n, 2, 2), or NaN.

    With the centre t above the middle of the chord, half of which is h, its distance from the line, a + b t, is the
    radius: (a + b t)^2 = h^2 + t^2.
    """
    chord = right - left
    half = _length(chord) / 2
    start, end = edge.swapaxes(0, 1)
    normal = _upwards(end - start)
    middle = (left + right) / 2
    from_edge = middle - start
    a = np.sum(from_edge * normal, axis=1)
    b = np.sum(_upwards(chord) * normal, axis=1)
    square = 1.0 - b * b
    constant = half * half - a * a
    with np.errstate(divide="ignore", invalid="ignore"):
        discriminant = a * a * b * b - square * constant
        root = np.sqrt(discriminant)
        lower = (a * b - root) / square
        upper = (a * b + root) / square
        centre = np.where(lower > 0.0, lower, upper)  # the upper one's circle touches the line beyond its chord
        parallel = constant / (2 * a * b)
        centre = np.where(square > 1e-12, centre, parallel)
        is_above = (a > 0.0) & (centre > 0.0)
        return np.where(is_above, np.arctan2(half, centre), np.nan)


def _lengths_along(line: Floats) -> Floats:
    """Return the lengths along a line (V, 2) from its first vertex to each vertex, (V,), in m."""
    return np.append(0.0, np.cumsum(_length(np.diff(line, axis=0))))


class Search:
    """Slope, method to minimise, limits, and all circles evaluated so far.

    ``entry`` and ``exit`` are the least and greatest x of the ends of arcs in m, or None; ``depth`` is the least
    thickness in m. Circles ``q`` are (n, 4): the numbers that the module describes.
    """

    def __init__(self, slope: Slope, method: str, entry: Any, exit: Any, depth: float) -> None:
        self.slope = slope
        self.arrays = slope.arrays()
        self.method = method
        self.depth = depth
        self.limits = {"entry": entry, "exit": exit}
        self.rounding = 1e-9 * float(_lengths_along(np.asarray(slope.ground))[-1])
        self.centres: list[Floats] = []
        self.values: list[Floats] = []
        self._set_lines(self.arrays)

    def on_lines(self, arrays: SlopeArrays) -> Search:
        """Return a search of the same slope on other lines, which adds its circles to the same map."""
        other = copy(self)
        other._set_lines(arrays)
        return other

    def _set_lines(self, arrays: SlopeArrays) -> None:
        """Search on the lines of these arrays, of one slope."""
        self.arrays = arrays
        (self.ground,) = arrays.ground
        self.along = _lengths_along(self.ground)
        edges = [np.empty((0, 2, 2))]
        for (top,) in arrays.tops:
            starts = top[:-1]
            edges.append(np.stack([starts, top[1:]], axis=1))
        self.boundary_edges = np.concatenate(edges)

    def points(self, lengths: Floats) -> Floats:
        """Return points of the ground, (..., 2) in m, at lengths (...) in m along it from its left end."""
        vertex_x, vertex_y = self.ground.T
        x = np.interp(lengths, self.along, vertex_x)
        return np.stack([x, np.interp(lengths, self.along, vertex_y)], axis=-1)

    def ends(self, q: Floats) -> Floats:
        """Return the left and the right ends of circles ``q``, (2, n, 2) in m."""
        return self.points(q[:, :2].T)

    def circles(self, q: Floats) -> Circles:
        """Return centres (n, 2), radii (n,), and left and right ends (n, 2) of circles ``q``, in m.

        The radius of an invalid circle is NaN.
        """
        left, right = self.ends(q)
        half_chord = _length(right - left) / 2
        half_angle = self.half_angles(q)
        valid = np.isfinite(half_angle)
        some_angle = np.where(valid, half_angle, 1.0)
        radius = half_chord / np.sin(some_angle)
        centre, radius = circle_through(left, right, radius=radius)
        radius = np.where(valid, radius, np.nan)
        return centre, radius, left, right

    def half_angles(self, q: Floats) -> Floats:
        """Return half the openings of the arcs of circles ``q`` in rad, (n,).

        They are NaN where an edge is not touched or the arc is steeper than upright.
        """
        greatest = self.greatest_half_angle(q)
        share = q[:, 2]
        touched = q[:, 3]
        half_angle = share * greatest
        touching = np.flatnonzero(touched != NONE)
        if touching.size:
            edge = self.boundary_edges[touched[touching].astype(np.int64)]
            left, right = self.ends(q[touching])
            half_angle[touching] = _touching_half_angle(left, right, edge)
        most = greatest * (1 + 1e-9)
        valid = (half_angle > 0.0) & (half_angle <= most)
        return np.where(valid, half_angle, np.nan)

    def greatest_half_angle(self, q: Floats) -> Floats:
        """Return half the greatest opening in rad of arcs between the ends of circles ``q``, (n,).

        There the circle is vertical at an end, or touches the base between the ends; NaN where an end is below the
        base.
        """
        left, right = self.ends(q)
        run, rise = (right - left).T
        upright = np.arctan2(run, np.abs(rise)) * _JUST_BELOW
        base = self.slope.base
        if base is None:
            return upright
        lower = np.minimum(left[:, 1], right[:, 1])
        above_base = lower - base >= -self.rounding
        upright = np.where(above_base, upright, np.nan)
        level = np.minimum(base, lower)
        centre, _ = circle_touching(left, right, level)
        touches_at = centre[:, 0]
        beyond_left = left[:, 0] <= touches_at + self.rounding
        before_right = touches_at - self.rounding <= right[:, 0]
        to_left = np.abs(angle_from_below(centre, left))
        to_right = np.abs(angle_from_below(centre, right))
        touching = (to_left + to_right) / 2 * _JUST_BELOW
        return np.where(beyond_left & before_right, np.minimum(upright, touching), upright)

    def evaluate(self, q: Floats, rule: Rule = EXACT) -> Floats:
        """Return the factor (or yield coefficient) of each circle, (n,), NaN without a factor or outside the limits.

        ``rule`` sets the points of the integrals.
        """
        values = np.full(len(q), np.nan)
        possible = self.possible(q)
        size = len(possible) * self.arrays.columns.bounds.shape[1]
        blocks = max(math.ceil(size / _TOGETHER), 1)
        with counted(len(possible), "circles evaluated") as progress:
            for block in np.array_split(possible, blocks):
                values[block] = self._factors(q[block], rule)
                progress(len(block))
        return values

    def possible(self, q: Floats) -> Any:
        """Return the indices of circles with ordered ends within the limits, not both on the base."""
        left, right = self.ends(q)
        left_x = left[:, 0]
        right_x = right[:, 0]
        possible = right_x - left_x > self.rounding
        rightwards = self._within(left_x, right_x)
        leftwards = self._within(right_x, left_x)
        possible &= rightwards | leftwards
        if self.slope.base is not None:
            higher_end = np.maximum(left[:, 1], right[:, 1])
            possible &= higher_end - self.slope.base > self.rounding
        return np.flatnonzero(possible)

    def _within(self, entry: Floats, exit: Floats) -> Any:
        """Return whether x of upper ends (``entry``) and lower ends (``exit``) are within the limits, (n,)."""
        within = np.ones(len(entry), dtype=bool)
        for x, limit in zip((entry, exit), self.limits.values(), strict=True):
            if limit is not None:
                low, high = limit
                within &= x >= low - self.rounding
                within &= x <= high + self.rounding
        return within

    def _factors(self, q: Floats, rule: Rule) -> Floats:
        """Return the factors of a block of circles, (n,), NaN as in `evaluate`, and store them for the map.

        ``rule`` sets the points of the integrals.
        """
        centre, radius, left, right = self.circles(q)
        thickness = self.thickness(q, centre, radius)
        thick = np.flatnonzero(thickness >= self.depth)
        left = left[thick]
        right = right[thick]
        circles = centre[thick], radius[thick], left, right
        factors, facing = factors_by(self.arrays, circles, self.method, rule)
        counts = np.isfinite(factors)
        if self.method != YIELD:
            counts &= factors > 0.0
        left_x = left[:, 0]
        right_x = right[:, 0]
        to_right = facing > 0.0
        entry = np.where(to_right, left_x, right_x)
        exit = np.where(to_right, right_x, left_x)
        counts &= self._within(entry, exit)
        factors = np.where(counts, factors, np.nan)
        values = np.full(len(q), np.nan)
        values[thick] = factors
        self.centres.append(centre)
        self.values.append(values)
        return values

    def thickness(self, q: Floats, centre: Floats, radius: Floats) -> Floats:
        """Return the greatest radial distance from arc to ground in m, (n,), 0 if the search has no least thickness.

        It is -1 where the ground leaves the circle between the ends. Centres and radii belong to the circles ``q``.
        """
        first = q[:, :1]
        last = q[:, 1:2]
        lengths = np.clip(self.along, first, last)  # repeats the ends beyond them
        ground = self.points(lengths) - centre[:, None]
        distance = _length(ground)
        most = (1 + 1e-12) * radius[:, None]
        inside = np.all(distance <= most, axis=1)
        if not self.depth:
            return np.where(inside, 0.0, -1.0)
        thickness = radius - _distance_from_origin(ground)
        return np.where(inside, thickness, -1.0)

    def positions(self) -> Floats:
        """Return lengths along the ground of the ends of the coarse family."""
        vertices = self.along
        total = vertices[-1]
        if len(vertices) > _MOST_VERTICES:
            even = np.linspace(0.0, total, _MOST_VERTICES)
            vertices = vertices[np.unique(np.searchsorted(vertices, even))]
        least = _LEAST_ON_EDGE if len(vertices) <= _FEW_EDGES else 1
        positions = [vertices]
        for low, high in pairwise(vertices.tolist()):
            share = (high - low) / total
            count = max(least, round(_POSITIONS * share))
            with_ends = np.linspace(low, high, count + 1)
            positions.append(with_ends[1:-1])
        vertex_x = self.ground[:, 0]
        for limit in self.limits.values():
            if limit is not None:
                first, last = np.interp(limit, vertex_x, self.along)
                positions.append(np.linspace(first, last, _LEAST_ON_EDGE + 1))
        return np.unique(np.concatenate(positions))

    def coarse_family(self, touching: bool = True) -> ArrayPair:
        """Return circles between all pairs of positions, with all openings, and the steps of their grids, each (n, 4).

        With ``touching``, circles that touch each edge of a boundary follow.
        """
        ends = self.positions()
        shape = len(ends), len(ends), len(_SHARES)
        numbers = np.indices(shape).reshape(3, -1)
        in_order = numbers[0] < numbers[1]
        left, right, share = numbers[:, in_order]
        no_edge = np.full(len(share), NONE)
        q = np.column_stack([ends[left], ends[right], _SHARES[share], no_edge])
        spacing = np.gradient(ends)
        share_spacing = np.gradient(_SHARES)[share]
        steps = np.column_stack([spacing[left], spacing[right], share_spacing, np.zeros_like(no_edge)])
        if not touching:
            return q, steps
        pairs = share == 0
        touching_edges = self.touching_every_edge(q[pairs])
        touching_steps = np.resize(steps[pairs], touching_edges.shape)
        return np.concatenate([q, touching_edges]), np.concatenate([steps, touching_steps])

    def touching_every_edge(self, q: Floats) -> Floats:
        """Return circles with the ends of circles ``q``, (n, 4), that touch each edge in turn, (edges n, 4)."""
        edges = np.arange(len(self.boundary_edges))
        circles = np.tile(q, (len(edges), 1))
        circles[:, 3] = np.repeat(edges, len(q))
        return circles

    def valleys(self, q: Floats, steps: Floats, tell: Callable[[str], None], rule: Rule = COARSE) -> ArrayPair:
        """Return the best circles without better neighbours, and their steps, (valleys, 4) each, the best first.

        ``q`` is a family of circles; ``tell`` is called with a line of progress.
        """
        values = self.evaluate(q, rule)
        if not np.any(np.isfinite(values)):
            left = "no circle within these limits can slide; widen entry, exit, depth or base"
            raise InputError("critical", [left])
        lowest = valleys_of(q, values, steps, _VALLEYS, _VALLEYS_ON_EDGE)
        valleys = np.array(lowest)[sorted_indices(values[lowest])]
        least = np.nanmin(values)
        tell(f"{len(values)} trial circles; refining the best {len(valleys)} of them, F = {least:.4g} so far")
        return q[valleys], steps[valleys]

    def refined(self, q: Floats, step: Floats, finest: float = FINEST, rule: Rule = FINE) -> ArrayPair:
        """Return the best circles after descent from circles ``q``, at most three, the best first, and first steps.

        ``step`` are the first steps, (n, 4), and ``finest`` is the final step over the first.
        """
        descent = Descent(q, step, self.along[-1], finest)
        with counted(len(q), "valleys followed to their least factor") as progress:
            for _ in range(_STEPS):
                progress(len(q) - descent.unfinished.size - progress.done)
                if progress.done == len(q):
                    break
                near = descent.proposals()
                values = self.evaluate(near.reshape(-1, 4), rule)
                values = np.nan_to_num(values, nan=np.inf)
                descent.move(near, values.reshape(near.shape[:2]))
        order = sorted_indices(descent.best)[:_KEPT]
        return descent.q[order], step[order]


def _distance_from_origin(line: Floats) -> Floats:
    """Return the least distance of lines (n, V, 2) from the origin, (n,), at perpendiculars or vertices."""
    start = line[:, :-1]
    edge = np.diff(line, axis=1)
    square = np.sum(edge * edge, axis=2)
    to_foot = -np.sum(start * edge, axis=2)
    divisor = np.where(square > 0.0, square, 1.0)
    share = np.clip(to_foot / divisor, 0.0, 1.0)
    return _length(start + share[..., None] * edge).min(axis=1)


def valleys_of(q: Floats, values: Floats, steps: Floats, most: int, most_on_edge: int) -> list[int]:
    """Return the indices of the best circles without better neighbours.

    At most ``most`` touch no boundary, and at most ``most_on_edge`` touch each edge of a boundary. Circles within 2.5
    ``steps``, (n, 4), are neighbours; ``values``, (n,), are minimised.
    """
    valleys: list[int] = []
    touched = q[:, 3]
    order = sorted_indices(values)
    order = order[np.isfinite(values[order])]
    for edge in np.unique(touched):
        rest = order[touched[order] == edge]
        count = most if edge == NONE else most_on_edge
        while count and rest.size:
            best = rest[0]
            valleys.append(int(best))
            distance = np.abs(q[rest] - q[best])
            is_apart = np.any(distance > _APART * steps[best], axis=1)
            rest = rest[is_apart]
            count -= 1
    return valleys
