"""Many circles through grounds of straight edges: where they cross, what lies between, and its moments. Arrays only.

A *stretch* is the part of the ground between two neighbouring crossings that lies inside the circle; the mass hangs
between it and the arc below. Everything is over R and from the centre; n circles stand before E edges.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes
from slipcircle.base.checks import EPS
from slipcircle.core.scene.doubledouble import DoubleDouble

Floats = NDArray[np.float64]
_GAUSS = [((1.0 + x) / 2, w / 2) for x, w in zip(*np.polynomial.legendre.leggauss(slopes.NODES), strict=True)]
MEASURES = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")
_BLOCK = 1 << 14  # edges at a time: their arrays stay in the cache


class Cut(NamedTuple):
    """The parts of a ground's edges that lie inside circles, each from left to right, (n, E)."""

    x: Floats  # first end
    y: Floats
    e_x: Floats  # from the first end to the second; 0 where the edge is outside
    e_y: Floats
    first: Floats  # 1 - rho^2 at both ends, 0 on the circle
    second: Floats
    stretch: NDArray[np.int64]  # number of the stretch that the part belongs to, from 0; -1 before the first crossing
    enters: NDArray[np.bool_]  # whether the ground enters or leaves the circle here
    leaves: NDArray[np.bool_]

    def only(self, lanes: Any) -> "Cut":
        """The same of some circles."""
        return Cut(*(part[lanes] for part in self))


def cut(points: Floats, centre: Floats, radius: Floats) -> Cut:
    """Cut grounds (n or 1, V, 2) by circles (n, 2), (n,).

    A vertex as near to a circle as rounding of its coordinates goes lies on it, and parts two stretches.
    """
    edges = np.diff(points, axis=1)
    x, y = (points[..., k] - centre[:, k, None] for k in (0, 1))
    u, v = (np.broadcast_to(edges[..., k], (len(radius), edges.shape[1])) for k in (0, 1))
    clear, inside = _clearances(points, centre, radius)
    start, share = _shares_inside(points, centre, radius, clear, inside)

    first_in = inside[:, :-1]
    last_in = inside[:, 1:]
    through = ~first_in & ~last_in & (share > 0.0)
    enters = (~first_in & last_in) | through
    leaves = (first_in & ~last_in) | through
    per_r = 1.0 / radius[:, None]
    gap = np.where(inside, clear, 0.0) * per_r**2
    return Cut(
        x=(x[:, :-1] + start * u) * per_r,
        y=(y[:, :-1] + start * v) * per_r,
        e_x=share * u * per_r,
        e_y=share * v * per_r,
        first=gap[:, :-1],
        second=gap[:, 1:],
        stretch=np.cumsum(enters, axis=1) - 1,
        enters=enters,
        leaves=leaves,
    )


def _shares_inside(
    points: Floats, centre: Floats, radius: Floats, clear: Floats, inside: NDArray[np.bool_]
) -> tuple[Floats, Floats]:
    """Where on each edge the part inside begins, and its length, as shares of the edge, (n, E)."""
    first_in = inside[:, :-1]
    last_in = inside[:, 1:]
    from_centre = points - centre[:, None]
    edges = np.diff(points, axis=1)
    start = np.zeros(first_in.shape)
    share = (first_in & last_in).astype(np.float64)

    at = np.nonzero(first_in != last_in)
    start[at], share[at] = _with_one_end_inside(at, last_in[at], clear, from_centre, edges)

    before_foot = (from_centre[:, :-1] * edges).sum(axis=2)  # negative where the foot of the perpendicular is ahead
    foot_on_edge = (before_foot < 0.0) & (before_foot + (edges**2).sum(axis=2) > 0.0)
    at = np.nonzero(~first_in & ~last_in & foot_on_edge)
    if at[0].size:
        start[at], share[at] = _with_both_ends_outside(at, points, centre, radius)
    return start, share


def _clearances(points: Floats, centre: Floats, radius: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """R^2 - rho^2 of each vertex, and whether it is inside by more than rounding of coordinates."""
    r = radius[:, None]
    x, y = (points[..., k] - centre[:, k, None] for k in (0, 1))
    clear = r * r - x * x - y * y
    is_near = np.abs(clear) < 0.1 * r * r
    lane, vertex = np.nonzero(is_near)  # a difference of near equals takes two doubles
    near = np.broadcast_to(points, (*clear.shape, 2))[lane, vertex]
    from_centre = _difference(near, centre[lane])
    clear[lane, vertex] = _clearance(from_centre, radius[lane]).high
    greatest_coordinate = np.abs(points).max(axis=2)
    size = greatest_coordinate + np.abs(centre).max(axis=1)[:, None]
    rounding = 32 * EPS * r * (r + size)
    return clear, clear > rounding


def _with_one_end_inside(
    at: Any, last_in: Any, clear: Floats, from_centre: Floats, edges: Floats
) -> tuple[Floats, Floats]:
    """From the end inside: s of D s^2 + 2 b s = g, by the form of the positive root that does not cancel."""
    lane, edge = at
    end_inside = lane, edge + last_in
    along = np.broadcast_to(edges, (len(clear), *edges.shape[1:]))[at]
    outward = np.where(last_in, -1.0, 1.0)
    b = outward * (from_centre[end_inside] * along).sum(axis=1)
    d = (along**2).sum(axis=1)
    g = clear[end_inside]
    root = np.sqrt(b * b + d * g)
    positive_root = np.where(b > 0.0, g / (b + root), (root - b) / d)
    share = np.minimum(positive_root, 1.0)
    start = np.where(last_in, 1.0 - share, 0.0)
    return start, share


def _with_both_ends_outside(at: Any, points: Floats, centre: Floats, radius: Floats) -> tuple[Floats, Floats]:
    """Of edges that may pass through the circle: the discriminant may be small, and takes two doubles."""
    lane, edge = at
    line = np.broadcast_to(points, (len(radius), *points.shape[1:]))
    first_end = line[lane, edge]
    second_end = line[lane, edge + 1]
    u, v = _difference(second_end, first_end)
    from_centre = _difference(first_end, centre[lane])
    x, y = from_centre
    b = x * u + y * v
    d = u * u + v * v
    clearance = _clearance(from_centre, radius[lane])
    discriminant = b * b + d * clearance
    root = np.sqrt(np.maximum(discriminant.high, 0.0))
    enters_at = (-b.high - root) / d.high
    start = np.maximum(enters_at, 0.0)
    share = np.minimum(2 * root / d.high, 1.0 - start)
    return start, share


def _difference(points: Floats, others: Floats) -> tuple[DoubleDouble, DoubleDouble]:
    """Of points (k, 2), its x and y without error."""
    return DoubleDouble.difference(points[:, 0], others[:, 0]), DoubleDouble.difference(points[:, 1], others[:, 1])


def _clearance(point: tuple[DoubleDouble, DoubleDouble], radius: Floats) -> DoubleDouble:
    """R^2 - rho^2 of points from the centre, which is small near the circle."""
    x, y = point
    r = DoubleDouble(radius)
    return r * r - (x * x + y * y)


def stretches(parts: Cut) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Circle and number of every whole stretch; and which circles hold an end of the ground."""
    leaves_first = parts.leaves & (parts.stretch < 0)
    from_start = leaves_first.any(axis=1)  # the ground begins inside the circle
    count = parts.leaves.sum(axis=1) - from_start
    to_end = parts.enters.sum(axis=1) > count
    begins_inside = parts.first[:, 0] > 0.0
    ends_inside = parts.second[:, -1] > 0.0
    all_inside = begins_inside & ends_inside & ~parts.leaves.any(axis=1)
    lanes = np.repeat(np.arange(len(count)), count)
    before = np.cumsum(count) - count
    number = np.arange(len(lanes)) - np.repeat(before, count)
    return lanes, number, from_start | to_end | all_inside


def ends(parts: Cut, number: Any) -> tuple[Floats, Floats]:
    """The left and the right crossing of one stretch for each circle, (2, n) each."""
    mine = parts.stretch == np.asarray(number)[:, None]
    lane = np.arange(len(parts.x))
    first = lane, np.argmax(parts.enters & mine, axis=1)
    last = lane, np.argmax(parts.leaves & mine, axis=1)
    right_x = parts.x[last] + parts.e_x[last]
    right_y = parts.y[last] + parts.e_y[last]
    left = np.stack([parts.x[first], parts.y[first]])
    return left, np.stack([right_x, right_y])


def moments(parts: Cut, mine: NDArray[np.bool_]) -> dict[str, Floats]:
    """Integrals of ``MEASURES`` over the mass under the parts that are meant, (n, E), for each circle.

    Source: `generated.slopes`; about 1e-15 of each, of radial and moment: of the vector's length.
    """
    n, count = mine.shape
    out = np.zeros((len(MEASURES), n))
    rows = max(1, _BLOCK // max(count, 1))
    for k in range(0, n, rows):
        some = slice(k, k + rows)
        out[:, some] = _moments(parts.only(some), mine[some])
    return dict(zip(MEASURES, out, strict=True))


def _moments(parts: Cut, mine: NDArray[np.bool_]) -> Floats:
    """The same of one block: short edges by quadrature of their rings, long ones by sectors and triangles."""
    u = np.where(mine, parts.e_x, 0.0)
    v = np.where(mine, parts.e_y, 0.0)
    first_distance = np.hypot(parts.x, parts.y)
    second_distance = np.hypot(parts.x + u, parts.y + v)
    distances = first_distance + second_distance
    is_long = u * u + v * v > (slopes.REACH * distances) ** 2
    short_u = np.where(is_long, 0.0, u)
    short_v = np.where(is_long, 0.0, v)
    total = _ring_moments(parts, short_u, short_v)
    at = np.nonzero(is_long)
    lane, _ = at
    if lane.size:
        x, y, u, v = (values[at] for values in (parts.x, parts.y, u, v))
        cross = x * v - y * u
        dot = x * (x + u) + y * (y + v)
        angle = np.arctan2(cross, dot)
        by_edge = slopes.closed(x, y, u, v, angle)
        total += np.array([np.bincount(lane, values, len(parts.x)) for values in by_edge])
    return total


def _ring_moments(parts: Cut, u: Floats, v: Floats) -> Floats:
    """Of the rings between edges (u, v) and arcs, with g = (1-s) g_1 + s g_2 + s (1-s) d^2 along an edge."""
    used = (u != 0.0) | (v != 0.0)
    first = np.where(used, parts.first, 0.0)
    second = np.where(used, parts.second, 0.0)
    square = u * u + v * v
    totals = np.zeros((len(MEASURES), *u.shape))
    for s, weight in _GAUSS:
        along_chord = (1.0 - s) * first + s * second
        gap = along_chord + (s * (1.0 - s)) * square
        rings = np.array(slopes.rings(gap))
        totals[:5] += weight * rings
        totals[5:] += (weight * s) * rings[3:]
    area, polar, inertia, radial, moment, radial_s, moment_s = totals
    x = parts.x
    y = parts.y
    radial_x = radial * x + radial_s * u
    radial_y = radial * y + radial_s * v
    moment_x = moment * x + moment_s * u
    moment_y = moment * y + moment_s * v
    by_edge = np.array([area, polar, inertia, radial_x, radial_y, moment_x, moment_y])
    cross = x * v - y * u
    return np.asarray((by_edge * cross).sum(axis=2))


def thickness(parts: Cut, mine: NDArray[np.bool_]) -> Floats:
    """The greatest distance from the arc to the ground towards the centre, for each circle."""
    square = parts.e_x**2 + parts.e_y**2
    to_foot = -(parts.x * parts.e_x + parts.y * parts.e_y)  # of the perpendicular from the centre
    on_edge = (to_foot > 0.0) & (to_foot < square)
    share = np.divide(to_foot, square, out=np.zeros(square.shape), where=on_edge)
    rest = 1.0 - share
    at_foot = rest * parts.first + share * parts.second + share * rest * square
    at_ends = np.maximum(parts.first, parts.second)
    gap = np.maximum(at_ends, at_foot)  # 1 - rho^2
    greatest = np.where(mine, gap, 0.0).max(axis=1)
    greatest = np.minimum(greatest, 1.0)
    return greatest / (1.0 + np.sqrt(1.0 - greatest))


def below_ground(parts: Cut, mine: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which circles have their centre below the ground of the stretch."""
    x_2 = parts.x + parts.e_x
    around_centre = (parts.x <= 0.0) & (x_2 >= 0.0) & (parts.e_x > 0.0)
    above_centre = parts.x * parts.e_y <= parts.y * parts.e_x
    is_below = mine & around_centre & above_centre
    return np.any(is_below, axis=1)
