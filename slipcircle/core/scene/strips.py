"""A mass cut into vertical strips: which soil lies at its base, and the integrals of what lies below each surface.

A *surface* is the lower envelope of some lines: the ground, the top of a layer cut off by those above it, the wet part
of a layer. The mass is cut at every vertex of a line, every crossing of two lines, and every crossing of a line and
the arc, so that in a strip each surface is one straight edge and the base lies in one layer. Weights add exactly: with
unit weights gamma_i, any moment is the sum over the surfaces of (gamma_i - gamma_(i-1)) times that of the mass below.

Lengths are over R from the centre of the circle, y up; beta is measured from straight below the centre, to the right.
Arrays have the axes (surfaces, circles, strips) or parts of them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import slopes

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

# Of a mass of unit weight below a surface: what `ring_integrals` gives, then the integral over beta of the height.
INTEGRALS = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y", "head")
AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y, HEAD = range(8)  # their rows
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(slopes.NODES)
_GAUSS = [((1.0 + node) / 2, weight / 2) for node, weight in zip(_NODES, _WEIGHTS, strict=True)]
_THIN = 1e-14  # narrower strips are rounding


@dataclass(frozen=True)
class Strips:
    """Strips of masses above arcs, from left to right; those of no width only fill the array.

    Attributes
    ----------
    x : ndarray
        Their edges, (circles, strips + 1).
    left, right : ndarray
        Heights of the surfaces above the arc at both edges of a strip.
    above : ndarray
        Whether a surface lies above the arc in a strip.
    base : ndarray
        The layer at the arc, counted from the ground, (circles, strips).
    loads : sequence
        Pressures on the ground, each x1, x2 and its values there, over R as lengths are, (circles, 1).
    """

    x: Floats
    left: Floats
    right: Floats
    above: NDArray[np.bool_]
    base: Integers
    loads: Sequence[Sequence[Floats]] = ()

    @property
    def beta(self) -> Floats:
        """Directions of their edges at the arc, rad."""
        return np.arcsin(np.clip(self.x, -1.0, 1.0))

    def cumulative(self) -> Floats:
        """`INTEGRALS` from the left end to each edge, (integrals, surfaces, circles, strips + 1).

        Below each surface of a unit weight; where there are loads they are the last surface, and their mass lies on
        the ground.
        """
        start, end = self.x[:, :-1], self.x[:, 1:]
        each = strip_integrals(start, end, self.left, self.right, self.above)
        if self.loads:
            each = np.concatenate(
                [each, self._load_integrals(start, end, start, end, self.left[0], self.right[0])], axis=1
            )
        total = np.cumsum(each, axis=-1)
        return np.concatenate([np.zeros_like(total[..., :1]), total], axis=-1)

    def up_to(self, beta: Floats, cumulative: Floats) -> Floats:
        """The same up to any directions (circles, M), (integrals, surfaces, circles, M)."""
        edges = self.beta
        inside = np.clip(beta, edges[:, :1], edges[:, -1:])
        before = np.count_nonzero(edges[:, None, :] <= inside[..., None], axis=-1)
        k = np.clip(before - 1, 0, self.x.shape[1] - 2)
        circle = np.arange(len(edges))[:, None]
        start = self.x[circle, k]
        end = self.x[circle, k + 1]
        x = np.sin(inside)
        left = self.left[:, circle, k]
        right = self.right[:, circle, k]
        part = strip_integrals(start, x, left, _height_between(start, end, x, left, right), self.above[:, circle, k])
        if self.loads:
            of_loads = self._load_integrals(start, end, start, x, left[0], right[0])
            part = np.concatenate([part, of_loads], axis=1)
        return cumulative[:, :, circle, k] + part

    def _load_integrals(
        self, start: Floats, end: Floats, x1: Floats, x2: Floats, left: Floats, right: Floats
    ) -> Floats:
        """The same of the loads between x1 and x2 in strips from start to end, with heights of the ground at both."""
        y1, y2 = (height - np.sqrt((1.0 - x) * (1.0 + x)) for x, height in ((start, left), (end, right)))
        slope = np.where(end - start > _THIN, (y2 - y1) / np.where(end - start > _THIN, end - start, 1.0), 0.0)
        middle = (start + end) / 2
        total = np.zeros((len(INTEGRALS), *x1.shape))
        for s, weight in _GAUSS:
            x = x1 + s * (x2 - x1)
            y = y1 + slope * (x - start)
            pressure = np.zeros_like(x)
            for first, last, q1, q2 in self.loads:
                share = (x - first) / (last - first)
                pressure += np.where((middle > first) & (middle < last), q1 + share * (q2 - q1), 0.0)
            rho = np.hypot(x, y)
            values: tuple[Any, ...] = (1.0, rho, rho * rho, x / rho, y / rho, x, y, 0.0)
            for row, value in zip(total, values, strict=True):
                row += weight * (x2 - x1) * pressure * value
        return total[:, None]


def _depth(x: Floats) -> Floats:
    """Of the arc below the centre."""
    return np.sqrt((1.0 - x) * (1.0 + x))


def _height_between(start: Floats, end: Floats, x: Floats, left: Floats, right: Floats) -> Floats:
    """Height above the arc at x of edges with given heights at both ends: they are straight, the arc is not."""
    width = end - start
    some = width > _THIN
    share = np.where(some, np.clip((x - start) / np.where(some, width, 1.0), 0.0, 1.0), 0.0)
    chord = (1.0 - share) * _depth(start) + share * _depth(end)
    return np.maximum((1.0 - share) * left + share * right + (_depth(x) - chord), 0.0)


def strip_integrals(x1: Floats, x2: Floats, left: Floats, right: Floats, above: NDArray[np.bool_]) -> Floats:
    """`INTEGRALS` of strips from x1 to x2 below straight edges of given heights above the arc at both ends.

    Of edges below the arc they are 0.

    A strip is the ring below its edge, between the rings of its two vertical sides.
    """
    y1, y2 = (-np.sqrt((1.0 - x) * (1.0 + x)) for x in (x1, x2))
    rings = ring_integrals(x1, y1, np.zeros_like(x1), left)
    rings += ring_integrals(x1, y1 + left, x2 - x1, (y2 + right) - (y1 + left))
    rings += ring_integrals(x2, y2 + right, np.zeros_like(x2), -right)
    run = x2 - x1
    some = np.abs(run) > _THIN
    rise = np.where(some, ((y2 + right) - (y1 + left)) / np.where(some, run, 1.0), 0.0)
    angle = np.arcsin(np.clip(x2, -1.0, 1.0)) - np.arcsin(np.clip(x1, -1.0, 1.0))
    head = slopes.head(angle, x1, -y1, left, rise)
    return np.where(above, np.concatenate([rings, np.broadcast_to(head, rings.shape[1:])[None]]), 0.0)


def ring_integrals(x: Any, y: Any, e_x: Any, e_y: Any) -> Floats:
    """The first seven `INTEGRALS` over the ring between edges from (x, y) to (x + e_x, y + e_y) and the arc below.

    Source: `generated.slopes`, the closed form for long edges and Gauss' rule for short ones.
    """
    x, y, e_x, e_y = np.broadcast_arrays(x, y, e_x, e_y)
    square = e_x * e_x + e_y * e_y
    reach = slopes.REACH * (np.hypot(x, y) + np.hypot(x + e_x, y + e_y))
    long = square > reach * reach
    found = np.asarray(_by_quadrature(x, y, e_x, e_y, ~long))
    if np.any(long):
        a, b, c, d = x[long], y[long], e_x[long], e_y[long]
        angle = np.arctan2(a * d - b * c, a * (a + c) + b * (b + d))
        found[:, long] = slopes.closed(a, b, c, d, angle)
    return found


def _by_quadrature(x: Floats, y: Floats, e_x: Floats, e_y: Floats, short: NDArray[np.bool_]) -> Floats:
    """The same of short edges, by Gauss' rule along them over 1 - rho^2, a sum of positive terms."""
    first = 1.0 - x * x - y * y
    second = 1.0 - (x + e_x) ** 2 - (y + e_y) ** 2
    square = e_x * e_x + e_y * e_y
    found = np.zeros((7, *x.shape))
    for s, weight in _GAUSS:
        gap = np.where(short, (1.0 - s) * first + s * second + s * (1.0 - s) * square, 0.0)
        area, polar, inertia, radial, moment = slopes.rings(gap)
        at_x = x + s * e_x
        at_y = y + s * e_y
        values = (area, polar, inertia, radial * at_x, radial * at_y, moment * at_x, moment * at_y)
        for total, value in zip(found, values, strict=True):
            total += weight * value
    return found * (x * e_y - y * e_x)


# --- cutting -----------------------------------------------------------------------------------------------------


def cut_into_strips(
    lines: Sequence[Floats],
    surfaces: Sequence[Sequence[int]],
    layers: int,
    ends: tuple[Floats, Floats],
    extra: Floats | None = None,
    loads: Sequence[Sequence[Floats]] = (),
) -> Strips:
    """Cut masses into strips.

    Parameters
    ----------
    lines : sequence of ndarray
        Of points from left to right from the centre, over R, (circles or 1, V, 2); they go on horizontally. First the
        ground, then the top of each further layer, then others.
    surfaces : sequence
        The numbers of the lines of which each surface is the lower envelope.
    layers : int
        How many of the lines, from the first on, are tops of layers.
    ends : pair of ndarray
        x of both ends of the arcs, (circles,).
    extra : ndarray, optional
        Further x at which to cut, (circles or 1, M).
    loads : sequence
        `Strips.loads`.
    """
    first, last = ends
    lines = [_to_both_sides(line) for line in lines]
    edges = _edges(lines, first, last, extra)
    middle = (edges[:, :-1] + edges[:, 1:]) / 2
    arc = -_depth(middle)
    lows, highs = np.stack([_heights(line, edges, middle) for line in lines], axis=1)
    at_middle = (lows + highs) / 2
    left, right, above = list[Floats](), list[Floats](), list[NDArray[np.bool_]]()
    for chosen in surfaces:
        rows = np.asarray(chosen)
        lowest = rows[np.argmin(at_middle[rows], axis=0)][None]
        inside = _of_line(at_middle, lowest) > arc
        above.append(inside)
        left.append(inside * _above(_of_line(lows, lowest), edges[:, :-1]))
        right.append(inside * _above(_of_line(highs, lowest), edges[:, 1:]))
    base = _base(at_middle[:layers], arc)
    return Strips(edges, np.stack(left), np.stack(right), np.stack(above), base, loads)


def _base(tops: Floats, arc: Floats) -> Integers:
    """The layer at the arc, of tops that are cut off by those above them."""
    boundaries = np.minimum.accumulate(tops, axis=0)
    return np.maximum(np.count_nonzero(boundaries > arc, axis=0) - 1, 0)


def _above(y: Floats, x: Floats) -> Floats:
    """Height of points above the arc, 0 below it."""
    return np.maximum(y + _depth(x), 0.0)


def _of_line(values: Floats, line: Integers) -> Floats:
    """Of values of all lines those of one in each strip."""
    return np.asarray(np.take_along_axis(values, line, 0)[0])


def _to_both_sides(line: Floats) -> Floats:
    """A line that goes on horizontally beyond both sides of the circle."""
    left, right = line[:, :1].copy(), line[:, -1:].copy()
    left[..., 0] = np.minimum(left[..., 0] - 1.0, -2.0)
    right[..., 0] = np.maximum(right[..., 0] + 1.0, 2.0)
    return np.concatenate([left, line, right], axis=1)


def _edges(lines: Sequence[Floats], first: Floats, last: Floats, extra: Floats | None) -> Floats:
    """Edges of the strips, (circles, strips + 1), sorted."""
    count = len(first)
    cuts = [first[:, None], last[:, None], *(line[..., 0] for line in lines), *map(_meets_circle, lines)]
    cuts += [_meets(one, other) for one, other in combinations(lines, 2)]
    cuts += [] if extra is None else [extra]
    every = np.concatenate([np.broadcast_to(x, (count, x.shape[-1])) for x in cuts], axis=1)
    edges = np.sort(np.clip(every, first[:, None], last[:, None]), axis=1)
    needed = np.any(np.diff(edges, axis=1) > _THIN, axis=0)
    return edges[:, np.concatenate([[True], needed])]


def _meets_circle(line: Floats) -> Floats:
    """x where the edges of lines cross the circle, (n, 2 E); that of the edge's first end where one does not."""
    start, edge = line[:, :-1], np.diff(line, axis=1)
    square, along = np.sum(edge * edge, axis=2), np.sum(start * edge, axis=2)
    discriminant = along * along - square * (np.sum(start * start, axis=2) - 1.0)
    root = np.sqrt(np.maximum(discriminant, 0.0))
    shares = [(-along + sign * root) / np.where(square > 0.0, square, 1.0) for sign in (-1.0, 1.0)]
    crossings = [
        np.where((discriminant > 0.0) & (s >= 0.0) & (s <= 1.0), start[..., 0] + s * edge[..., 0], start[..., 0])
        for s in shares
    ]
    return np.concatenate(crossings, axis=1)


def _meets(one: Floats, other: Floats) -> Floats:
    """x where the edges of two lines cross each other, likewise, (n, E1 E2)."""
    p, q = one[:, :-1, None], other[:, None, :-1]
    u, v = np.diff(one, axis=1)[:, :, None], np.diff(other, axis=1)[:, None]
    across = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    apart = q - p
    along = apart[..., 0] * v[..., 1] - apart[..., 1] * v[..., 0]
    beside = apart[..., 0] * u[..., 1] - apart[..., 1] * u[..., 0]
    safe = np.where(across != 0.0, across, 1.0)
    s, t = along / safe, beside / safe
    crosses = (across != 0.0) & (s > 0.0) & (s < 1.0) & (t > 0.0) & (t < 1.0)
    x = np.where(crosses, p[..., 0] + s * u[..., 0], p[..., 0])
    return x.reshape(len(x), -1)


def _heights(line: Floats, edges: Floats, middle: Floats) -> tuple[Floats, Floats]:
    """y of a line at both edges of each strip, by that edge of the line which lies over the strip's middle."""
    points = np.broadcast_to(line, (len(edges), *line.shape[1:]))
    after = np.count_nonzero(points[:, None, :, 0] <= middle[..., None], axis=-1)
    k = np.clip(after - 1, 0, points.shape[1] - 2)
    circle = np.arange(len(edges))[:, None]
    start, end = points[circle, k], points[circle, k + 1]
    run = end[..., 0] - start[..., 0]
    slope = np.where(run > 0.0, (end[..., 1] - start[..., 1]) / np.where(run > 0.0, run, 1.0), 0.0)
    at_left, at_right = (start[..., 1] + slope * (x - start[..., 0]) for x in (edges[:, :-1], edges[:, 1:]))
    return at_left, at_right
