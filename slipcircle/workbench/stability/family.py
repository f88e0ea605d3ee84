"""All circles of a slope at once: a coarse family between points of its ground, and the refinement of its best.

A circle is four numbers: two lengths along the ground, of its ends from the left, its opening as a share of the
greatest one, at which it is upright at an end or touches the base; and the edge of a boundary between layers that it
touches from above in the place of that share, -1 of most circles, which touch none. Factors have kinks where a circle
begins to cut a layer, so that the least may stand there.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from slipcircle.base.checks import InputError
from slipcircle.base.series import Floats
from slipcircle.core import circle_through, circle_touching
from slipcircle.workbench.stability.descent import Descent
from slipcircle.workbench.stability.factors import YIELD, factors_by
from slipcircle.workbench.stability.slices import NODES
from slipcircle.workbench.stability.stability import Slope

_POSITIONS = 40  # of ends, evenly along the ground
_LEAST_ON_EDGE = 7  # on each edge of a ground of few edges: the slope between wide level parts may be short
_FEW_EDGES = 12
_MOST_VERTICES = 48  # of a ground; of more, those nearest to even places
_SHARES = np.array([0.04, 0.08, 0.13, 0.19, 0.26, 0.34, 0.43, 0.53, 0.64, 0.76, 0.88, 1.0])
COARSE_NODES, _FINE_NODES = 4, 6  # of Gauss' rule
_VALLEYS = 12  # that are refined
_VALLEYS_ON_EDGE = 2  # of those that touch an edge of a boundary
_APART = 2.5  # spacings of the coarse family between valleys
_STEPS = 150  # of a refinement, at most
_KEPT = 3  # of refined valleys
_TOGETHER = 1 << 13  # ground vertices times circles at a time: what fits into the caches
_NONE = -1.0  # no edge is touched


def _touching_half_angle(left: Floats, right: Floats, edge: Floats) -> Floats:
    """Half the opening of the arc from left to right that touches the line through an edge from above, or NaN.

    With the centre t above the middle of the chord, half of which is h, its distance from the line, a + b t, is the
    radius, sqrt(h^2 + t^2).
    """
    chord = right - left
    along = edge[1] - edge[0]
    half = np.hypot(*chord.T) / 2
    up = np.stack([-chord[:, 1], chord[:, 0]], axis=1) / (2 * half)[:, None]
    normal = np.array([-along[1], along[0]]) / np.hypot(*along)
    a = ((left + right) / 2 - edge[0]) @ normal
    b = up @ normal
    with np.errstate(divide="ignore", invalid="ignore"):
        square = 1.0 - b * b
        root = np.sqrt(a * a * b * b - square * (half * half - a * a))
        lower = (a * b - root) / square  # the other circle touches the line beyond its chord
        centre = np.where(lower > 0.0, lower, (a * b + root) / square)
        centre = np.where(square > 1e-12, centre, (half * half - a * a) / (2 * a * b))
        return np.where((a > 0.0) & (centre > 0.0), np.arctan2(half, centre), np.nan)


class Search:
    """A slope, the method to minimise, the limits, and every circle evaluated so far."""

    def __init__(self, slope: Slope, method: str, entry: Any, exit: Any, depth: float) -> None:
        self.slope = slope
        self.arrays = slope.arrays()
        self.method = method
        self.depth = depth
        self.limits = {"entry": entry, "exit": exit}
        self.ground = np.asarray(slope.ground)
        edges = np.diff(self.ground, axis=0)
        self.along = np.concatenate([[0.0], np.cumsum(np.hypot(edges[:, 0], edges[:, 1]))])
        self.rounding = 1e-9 * float(self.along[-1])
        boundaries = [np.stack([top[0, :-1], top[0, 1:]], axis=1) for top in self.arrays.tops]
        self.boundary_edges = np.concatenate([np.empty((0, 2, 2)), *boundaries])
        self.centres: list[Floats] = []
        self.values: list[Floats] = []

    def points(self, lengths: Floats) -> Floats:
        """Points of the ground at lengths along it."""
        return np.stack([np.interp(lengths, self.along, self.ground[:, k]) for k in (0, 1)], axis=-1)

    def circles(self, q: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """Centres, radii, left and right ends."""
        left = self.points(q[:, 0])
        right = self.points(q[:, 1])
        chord = right - left
        half_chord = np.hypot(*chord.T) / 2
        greatest = self._greatest_half_angle(left, right)
        half_angle = q[:, 2] * greatest
        for k, edge in enumerate(self.boundary_edges):
            touches = q[:, 3] == k
            half_angle[touches] = _touching_half_angle(left[touches], right[touches], edge)
        valid = (half_angle > 0.0) & (half_angle <= greatest * (1 + 1e-9))
        some_angle = np.where(valid, half_angle, 1.0)
        radius = half_chord / np.sin(some_angle)
        centre, radius = circle_through(left, right, radius=radius)
        radius = np.where(valid, radius, np.nan)
        return centre, radius, left, right

    def _greatest_half_angle(self, left: Floats, right: Floats) -> Floats:
        """Of circles through two points that are upright at an end, or touch the base between them."""
        chord = right - left
        upright = np.arctan2(chord[:, 0], np.abs(chord[:, 1])) * (1 - 1e-12)
        if self.slope.base is None:
            return upright
        base = self.slope.base
        lower = np.minimum(left[:, 1], right[:, 1])
        above_base = lower - base >= -self.rounding
        upright = np.where(above_base, upright, np.nan)
        centre, _ = circle_touching(left, right, np.minimum(base, lower))
        x = centre[:, 0]
        beyond_left = left[:, 0] <= x + self.rounding
        before_right = x - self.rounding <= right[:, 0]
        half_angles = []
        for end in (left, right):
            beside = np.abs(end[:, 0] - x)
            below = centre[:, 1] - end[:, 1]
            half_angles.append(np.arctan2(beside, below))
        touching = sum(half_angles) / 2 * (1 - 1e-12)
        deepest = np.minimum(upright, touching)
        return np.where(beyond_left & before_right, deepest, upright)

    def evaluate(self, q: Floats, nodes: int = NODES) -> Floats:
        """The factor of each circle, NaN where there is none, or none within the limits."""
        values = np.full(len(q), np.nan)
        possible = self._possible(q)
        blocks = -(-len(possible) * len(self.ground) // _TOGETHER) or 1
        for lanes in np.array_split(possible, blocks):
            values[lanes] = self._factors(q[lanes], nodes)
        return values

    def _possible(self, q: Floats) -> Any:
        """Circles whose ends lie beside each other, within the limits, and not both on the base."""
        left = self.points(q[:, 0])
        right = self.points(q[:, 1])
        apart = right[:, 0] - left[:, 0] > self.rounding
        entry, exit = (self._within(limit, left[:, 0], right[:, 0]) for limit in self.limits.values())
        apart &= (entry[0] & exit[1]) | (entry[1] & exit[0])
        if self.slope.base is not None:
            apart &= np.maximum(left[:, 1], right[:, 1]) - self.slope.base > self.rounding
        return np.flatnonzero(apart)

    def _within(self, limit: Any, *ends: Floats) -> list[Any]:
        """Which ends lie within a limit."""
        low, high = (-np.inf, np.inf) if limit is None else limit
        return [(x >= low - self.rounding) & (x <= high + self.rounding) for x in ends]

    def _factors(self, q: Floats, nodes: int) -> Floats:
        """The same of a block, which is kept for the map."""
        centre, radius, left, right = self.circles(q)
        thick = np.flatnonzero(self.thickness(q, centre, radius) >= self.depth)
        circles = (centre[thick], radius[thick], left[thick], right[thick])
        factors, facing = factors_by(self.arrays, *circles, self.method, nodes)
        within = np.isfinite(factors) if self.method == YIELD else factors > 0.0
        for limit, upper_left in zip(self.limits.values(), (1.0, -1.0), strict=True):
            if limit is not None:
                x = np.where(facing == upper_left, left[thick, 0], right[thick, 0])
                within &= (x >= limit[0] - self.rounding) & (x <= limit[1] + self.rounding)
        values = np.full(len(q), np.nan)
        values[thick] = np.where(within, factors, np.nan)
        self.centres.append(centre)
        self.values.append(values)
        return values

    def thickness(self, q: Floats, centre: Floats, radius: Floats) -> Floats:
        """Greatest distance from arc to ground along the radius; -1 where the ground leaves the circle in between."""
        lengths = np.clip(self.along, q[:, :1], q[:, 1:2])  # repeats the ends beyond them
        line = self.points(lengths) - centre[:, None]
        distance = np.hypot(line[..., 0], line[..., 1])
        most = (1 + 1e-12) * radius[:, None]
        inside = np.all(distance <= most, axis=1)
        if not self.depth:
            return np.where(inside, 0.0, -1.0)
        start = line[:, :-1]
        edge = np.diff(line, axis=1)
        square = np.sum(edge**2, axis=2)
        to_foot = -np.sum(start * edge, axis=2)  # of the perpendicular from the centre
        share = np.clip(to_foot / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
        nearest = start + share[..., None] * edge
        distance = np.hypot(nearest[..., 0], nearest[..., 1]).min(axis=1)
        return np.where(inside, radius - distance, -1.0)

    def _positions(self) -> Floats:
        """Lengths along the ground of the ends of the coarse family."""
        vertices = self.along
        total = vertices[-1]
        if len(vertices) > _MOST_VERTICES:
            even = np.linspace(0.0, total, _MOST_VERTICES)
            vertices = vertices[np.unique(np.searchsorted(vertices, even))]
        least = _LEAST_ON_EDGE if len(vertices) <= _FEW_EDGES else 1
        positions = [vertices]
        for low, high in pairwise(vertices.tolist()):
            count = max(least, round(_POSITIONS * (high - low) / total))
            positions.append(np.linspace(low, high, count + 1)[1:-1])
        for limit in filter(None, self.limits.values()):
            first, last = np.interp(limit, self.ground[:, 0], self.along)
            positions.append(np.linspace(first, last, _LEAST_ON_EDGE + 1))
        return np.unique(np.concatenate(positions))

    def coarse_family(self) -> tuple[Floats, Floats]:
        """Circles between all pairs of positions, with all openings, and touching each boundary; and their steps."""
        ends = self._positions()
        numbers = np.indices((len(ends), len(ends), len(_SHARES))).reshape(3, -1)
        i, j, k = numbers[:, numbers[0] < numbers[1]]
        count = len(i)
        q = np.column_stack([ends[i], ends[j], _SHARES[k], np.full(count, _NONE)])
        spacing = np.gradient(ends)
        share_spacing = np.gradient(_SHARES)
        steps = np.column_stack([spacing[i], spacing[j], share_spacing[k], np.zeros(count)])
        pairs = np.flatnonzero(k == 0)
        families = [q]
        for edge in range(len(self.boundary_edges)):
            families.append(np.column_stack([q[pairs, :3], np.full(len(pairs), edge)]))
        more = [steps[pairs]] * len(self.boundary_edges)
        return np.concatenate(families), np.concatenate([steps, *more])

    def coarse(self, tell: Callable[[str], None]) -> tuple[Floats, Floats]:
        """The best circles of the coarse family that are no neighbours of a better one, and their steps."""
        q, steps = self.coarse_family()
        values = self.evaluate(q, COARSE_NODES)
        if not np.any(np.isfinite(values)):
            left = "no circle within these limits can slide; widen entry, exit, depth or base"
            raise InputError("critical", [left])
        valleys = valleys_of(q, values, steps, _VALLEYS, _VALLEYS_ON_EDGE)
        tell(f"{len(values)} circles; following {len(valleys)}, from {np.nanmin(values):.4g}")
        return q[valleys], steps[valleys]

    def refined(self, q: Floats, step: Floats) -> tuple[Floats, Floats]:
        """The best circles, in order, after all were followed downhill, and their first steps."""
        descent = Descent(q, step, self.along[-1])
        for _ in range(_STEPS):
            if not descent.unfinished.size:
                break
            near = descent.proposals()
            values = self.evaluate(near.reshape(-1, 4), _FINE_NODES).reshape(near.shape[:2])
            descent.move(near, np.nan_to_num(values, nan=np.inf))
        order = np.argsort(descent.best, kind="stable")[:_KEPT]
        return descent.q[order], step[order]


def valleys_of(q: Floats, values: Floats, steps: Floats, most: int, most_on_edge: int) -> list[int]:
    """The best circles that are no neighbours of a better one, of those that touch no boundary and those of each."""
    valleys: list[int] = []
    order = np.argsort(values, kind="stable")[: np.count_nonzero(np.isfinite(values))]
    for edge in np.unique(q[:, 3]):
        left = order[q[order, 3] == edge]
        count = most if edge == _NONE else most_on_edge
        while count and left.size:
            best = left[0]
            valleys.append(int(best))
            left = left[np.any(np.abs(q[left] - q[best]) > _APART * steps[best], axis=1)]
            count -= 1
    return valleys
