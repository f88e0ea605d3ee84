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
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(slopes.NODES)
_GAUSS = list(zip((1.0 + _NODES) / 2, _WEIGHTS / 2, strict=True))  # of integrals from 0 to 1
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
    x, y = _from_centre(points, centre)
    edges = np.diff(points, axis=1)
    u = edges[..., 0]
    v = edges[..., 1]
    clear, inside = _clearances(points, centre, radius)
    start, share = _shares_inside(points, centre, radius, clear, inside)

    first_in = inside[:, :-1]
    last_in = inside[:, 1:]
    first_out = ~first_in
    last_out = ~last_in
    has_part_inside = share > 0.0
    through = first_out & last_out & has_part_inside
    enters = (first_out & last_in) | through
    leaves = (first_in & last_out) | through
    per_r = 1.0 / radius[:, None]
    inside_by = np.where(inside, clear, 0.0)
    gap = inside_by * per_r**2
    first_x = x[:, :-1] + start * u
    first_y = y[:, :-1] + start * v
    return Cut(
        x=first_x * per_r,
        y=first_y * per_r,
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

    first_ends = from_centre[:, :-1]
    before_foot = (first_ends * edges).sum(axis=2)  # negative where the foot of the perpendicular is ahead
    square = (edges**2).sum(axis=2)
    behind_foot = before_foot + square
    foot_on_edge = (before_foot < 0.0) & (behind_foot > 0.0)
    both_outside = ~first_in & ~last_in
    at = np.nonzero(both_outside & foot_on_edge)
    lane, edge = at
    if lane.size:
        start[at], share[at] = _with_both_ends_outside(lane, edge, points, centre, radius)
    return start, share


def _clearances(points: Floats, centre: Floats, radius: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """R^2 - rho^2 of each vertex, and whether it is inside by more than rounding of coordinates."""
    r = radius[:, None]
    x, y = _from_centre(points, centre)
    clear = r * r - x * x - y * y
    is_near = np.abs(clear) < 0.1 * r * r
    lane, vertex = np.nonzero(is_near)  # a difference of near equals takes two doubles
    of_circles = np.broadcast_to(points, (*clear.shape, 2))
    near = of_circles[lane, vertex]
    from_centre = _difference(near, centre[lane])
    accurate = _clearance(from_centre, radius[lane])
    clear[lane, vertex] = accurate.high
    of_points = np.abs(points).max(axis=2)
    of_centre = np.abs(centre).max(axis=1)
    size = of_points + of_centre[:, None]
    rounding = 32 * EPS * r * (r + size)
    return clear, clear > rounding


def _from_centre(points: Floats, centre: Floats) -> tuple[Floats, Floats]:
    """Coordinates of points (n or 1, V, 2) from the centres of circles (n, 2)."""
    x = points[..., 0] - centre[:, 0, None]
    y = points[..., 1] - centre[:, 1, None]
    return x, y


def _with_one_end_inside(
    at: Any, last_in: Any, clear: Floats, from_centre: Floats, edges: Floats
) -> tuple[Floats, Floats]:
    """From the end inside: s of D s^2 + 2 b s = g, by the form of the positive root that does not cancel."""
    lane, edge = at
    end_inside = lane, edge + last_in
    of_circles = np.broadcast_to(edges, (len(clear), *edges.shape[1:]))
    along = of_circles[at]
    outward = np.where(last_in, -1.0, 1.0)
    scalar_product = (from_centre[end_inside] * along).sum(axis=1)
    b = outward * scalar_product
    d = (along**2).sum(axis=1)
    g = clear[end_inside]
    discriminant = b * b + d * g
    root = np.sqrt(discriminant)
    from_sum = g / (b + root)
    from_difference = (root - b) / d
    positive_root = np.where(b > 0.0, from_sum, from_difference)
    share = np.minimum(positive_root, 1.0)
    start = np.where(last_in, 1.0 - share, 0.0)
    return start, share


def _with_both_ends_outside(
    lane: Any, edge: Any, points: Floats, centre: Floats, radius: Floats
) -> tuple[Floats, Floats]:
    """Of edges that may pass through the circle: the discriminant may be small, and takes two doubles."""
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
    square = d.high
    enters_at = (-b.high - root) / square
    start = np.maximum(enters_at, 0.0)
    length = 2 * root / square
    share = np.minimum(length, 1.0 - start)
    return start, share


def _difference(points: Floats, others: Floats) -> tuple[DoubleDouble, DoubleDouble]:
    """Of points (k, 2), its x and y without error."""
    x = DoubleDouble.difference(points[:, 0], others[:, 0])
    y = DoubleDouble.difference(points[:, 1], others[:, 1])
    return x, y


def _clearance(point: tuple[DoubleDouble, DoubleDouble], radius: Floats) -> DoubleDouble:
    """R^2 - rho^2 of points from the centre, which is small near the circle."""
    x, y = point
    r = DoubleDouble(radius)
    square_of_distance = x * x + y * y
    return r * r - square_of_distance


def stretches(parts: Cut) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
    """Circle and number of every whole stretch; and which circles hold an end of the ground."""
    leaves_first = parts.leaves & (parts.stretch < 0)
    from_start = leaves_first.any(axis=1)  # the ground begins inside the circle
    count = parts.leaves.sum(axis=1) - from_start
    to_end = parts.enters.sum(axis=1) > count
    begins_inside = parts.first[:, 0] > 0.0
    ends_inside = parts.second[:, -1] > 0.0
    never_leaves = ~parts.leaves.any(axis=1)
    all_inside = begins_inside & ends_inside & never_leaves
    circles = np.arange(len(count))
    lanes = np.repeat(circles, count)
    before = np.cumsum(count) - count
    first_of_circle = np.repeat(before, count)
    number = np.arange(len(lanes)) - first_of_circle
    holds_an_end = from_start | to_end | all_inside
    return lanes, number, holds_an_end


def ends(parts: Cut, number: Any) -> tuple[Floats, Floats]:
    """The left and the right crossing of one stretch for each circle, (2, n) each."""
    of_circles = np.asarray(number)
    mine = parts.stretch == of_circles[:, None]
    enters_here = parts.enters & mine
    leaves_here = parts.leaves & mine
    lane = np.arange(len(parts.x))
    first = lane, np.argmax(enters_here, axis=1)
    last = lane, np.argmax(leaves_here, axis=1)
    left = np.stack([parts.x[first], parts.y[first]])
    right_x = parts.x[last] + parts.e_x[last]
    right_y = parts.y[last] + parts.e_y[last]
    right = np.stack([right_x, right_y])
    return left, right


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
    x = parts.x
    y = parts.y
    u = np.where(mine, parts.e_x, 0.0)
    v = np.where(mine, parts.e_y, 0.0)
    first_distance = np.hypot(x, y)
    second_distance = np.hypot(x + u, y + v)
    distances = first_distance + second_distance
    reach = slopes.REACH * distances
    square = u * u + v * v
    is_long = square > reach**2
    short_u = np.where(is_long, 0.0, u)
    short_v = np.where(is_long, 0.0, v)
    total = _ring_moments(parts, short_u, short_v)
    at = np.nonzero(is_long)
    lane, _ = at
    if lane.size:
        total += _sector_moments(x[at], y[at], u[at], v[at], lane, len(x))
    return total


def _sector_moments(x: Floats, y: Floats, u: Floats, v: Floats, lane: Any, count: int) -> Floats:
    """Of edges (u, v) from (x, y), each of a circle, by the closed forms of sectors and triangles; sums by circle."""
    cross = x * v - y * u
    second_x = x + u
    second_y = y + v
    dot = x * second_x + y * second_y
    angle = np.arctan2(cross, dot)
    by_edge = slopes.closed(x, y, u, v, angle)
    return np.array([np.bincount(lane, values, count) for values in by_edge])


def _ring_moments(parts: Cut, u: Floats, v: Floats) -> Floats:
    """Of the rings between edges (u, v) and arcs, with g = (1-s) g_1 + s g_2 + s (1-s) d^2 along an edge."""
    across = u != 0.0
    upwards = v != 0.0
    used = across | upwards
    first = np.where(used, parts.first, 0.0)
    second = np.where(used, parts.second, 0.0)
    square = u * u + v * v
    totals = np.zeros((len(MEASURES), *u.shape))
    for s, weight in _GAUSS:
        rest = 1.0 - s
        bulge = s * rest
        along_chord = rest * first + s * second
        gap = along_chord + bulge * square
        rings = np.array(slopes.rings(gap))
        vectors = rings[3:]
        weight_of_s = weight * s
        totals[:5] += weight * rings
        totals[5:] += weight_of_s * vectors
    area, polar, inertia, radial, moment, radial_s, moment_s = totals
    x = parts.x
    y = parts.y
    radial_x = radial * x + radial_s * u
    radial_y = radial * y + radial_s * v
    moment_x = moment * x + moment_s * u
    moment_y = moment * y + moment_s * v
    by_edge = np.array([area, polar, inertia, radial_x, radial_y, moment_x, moment_y])
    cross = x * v - y * u
    over_edges = by_edge * cross
    return np.asarray(over_edges.sum(axis=2))


def thickness(parts: Cut, mine: NDArray[np.bool_]) -> Floats:
    """The greatest distance from the arc to the ground towards the centre, for each circle."""
    u = parts.e_x
    v = parts.e_y
    square = u**2 + v**2
    to_foot = -(parts.x * u + parts.y * v)  # of the perpendicular from the centre
    on_edge = (to_foot > 0.0) & (to_foot < square)
    share = np.divide(to_foot, square, out=np.zeros(square.shape), where=on_edge)
    rest = 1.0 - share
    along_chord = rest * parts.first + share * parts.second
    at_foot = along_chord + share * rest * square
    at_ends = np.maximum(parts.first, parts.second)
    gap = np.maximum(at_ends, at_foot)  # 1 - rho^2
    greatest = np.where(mine, gap, 0.0).max(axis=1)
    greatest = np.minimum(greatest, 1.0)
    least_distance = np.sqrt(1.0 - greatest)
    return greatest / (1.0 + least_distance)


def below_ground(parts: Cut, mine: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which circles have their centre below the ground of the stretch."""
    first_x = parts.x
    second_x = parts.x + parts.e_x
    around_centre = (first_x <= 0.0) & (second_x >= 0.0) & (parts.e_x > 0.0)
    above_centre = parts.x * parts.e_y <= parts.y * parts.e_x
    is_below = mine & around_centre & above_centre
    return np.any(is_below, axis=1)
