"""Intersections of many circles with polygonal grounds, and moments of the masses between them.

A *stretch* is the part of the ground between two neighbouring crossings that lies inside the circle. The mass lies
between it and the arc below. Lengths are divided by R, and the origin is the centre. Arrays have n circles by E edges.
"""

from typing import Any, NamedTuple

import numpy as np

from generated import slopes
from slipcircle.base.arrays import EPS
from slipcircle.base.kinds import ArrayDict, ArrayPair, Flags, Floats, Integers
from slipcircle.ground.doubledouble import DoubleDouble
from slipcircle.ground.plane import Vectors, each_lane

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(slopes.NODES)
_PLACES = (1.0 + _NODES[:, None]) / 2  # for integrals from 0 to 1
_SHARES = _WEIGHTS[:, None] / 2
MEASURES = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")
_BLOCK = 1 << 13  # edges per block, whose arrays fit into the cache


class Cut(NamedTuple):
    """Parts of a ground's edges that lie inside circles, each from left to right, (n, E)."""

    start: Vectors  # first end
    part: Vectors  # from the first end to the second; 0 where the edge is outside
    first: Floats  # 1 - rho^2 at both ends, 0 on the circle
    second: Floats
    stretch: Integers  # number of the stretch that the part belongs to, from 0; -1 before the first crossing
    enters: Flags  # whether the ground enters or leaves the circle here
    leaves: Flags

    def only(self, lanes: Any) -> "Cut":
        """Return the parts for the circles with these indices, or in a slice of them."""
        return Cut._make(part[lanes] for part in self)


class _Edges(NamedTuple):
    """Edges of lines, with ends from the centres of circles, (n, E)."""

    first: Vectors
    last: Vectors
    edge: Vectors  # from the first to the last end, as exact as the line
    first_clear: Floats  # R^2 - rho^2 of ends inside by more than rounding, 0 of others
    last_clear: Floats

    def only(self, chosen: Any) -> "_Edges":
        """Return the edges with these indices, or where a mask is true."""
        return _Edges._make(part[chosen] for part in self)

    def reversed(self) -> "_Edges":
        """Return the edges from their last to their first end."""
        edge = -self.edge
        return _Edges(self.last, self.first, edge, self.last_clear, self.first_clear)


def cut_by_circles(points: Floats, centre: Floats, radius: Floats) -> Cut:
    """Return the parts of grounds inside circles.

    Grounds are (n or 1, V, 2), centres (n, 2) and radii (n,), in m. The parts are over R with the origin at the centre.

    A vertex closer to a circle than the rounding of its coordinates lies on the circle and separates two stretches.
    """
    line = Vectors.of(each_lane(points, len(radius)))
    middle = Vectors.of(centre)
    from_centre = line - middle[:, None]
    clear = _clearances(line, from_centre, middle, radius)
    first_clear = clear[:, :-1]
    last_clear = clear[:, 1:]
    edges = _Edges(from_centre.starts, from_centre.ends, line.edges, first_clear, last_clear)
    start, share = _with_an_end_inside(edges)
    at = np.nonzero(_may_pass_through(edges))
    lane, _ = at
    if lane.size:
        first = line.starts[at]
        last = line.ends[at]
        of_circle = middle[lane], radius[lane]
        start[at], share[at] = _with_both_ends_outside(first, last, *of_circle)

    has_part_inside = share > 0.0
    enters = has_part_inside & (edges.first_clear == 0.0)
    leaves = has_part_inside & (edges.last_clear == 0.0)
    per_r = 1.0 / radius[:, None]
    per_square = per_r**2
    return Cut(
        start=(edges.first + edges.edge * start) * per_r,
        part=edges.edge * share * per_r,
        first=edges.first_clear * per_square,
        second=edges.last_clear * per_square,
        stretch=np.cumsum(enters, axis=1) - 1,
        enters=enters,
        leaves=leaves,
    )


def _clearances(line: Vectors, from_centre: Vectors, centre: Vectors, radius: Floats) -> Floats:
    """Return R^2 - rho^2 in m^2 of each vertex, (n, V), 0 unless it is inside by more than rounding of coordinates.

    Here rho is the distance from the centre. ``line`` and ``from_centre`` are the vertices in space and from the
    centres.
    """
    r = radius[:, None]
    x, y = from_centre
    square = r * r
    clear = square - x * x - y * y
    is_near = np.abs(clear) < 0.1 * square  # the difference of nearly equal numbers requires double-double
    near = np.nonzero(is_near)
    lane, _ = near
    doubled = _doubled(line[near]) - _doubled(centre[lane])
    accurate = _clearance(doubled, radius[lane])
    clear[near] = accurate.high
    size = line.largest + centre.largest[:, None]
    rounding = 32 * EPS * r * (r + size)
    return np.where(clear > rounding, clear, 0.0)


def _doubled(vectors: Vectors) -> Vectors:
    """Return vectors of floats as vectors in double-double arithmetic."""
    return Vectors(DoubleDouble(vectors.x), DoubleDouble(vectors.y))


def _clearance(from_centre: Vectors, radius: Floats) -> DoubleDouble:
    """Return R^2 - rho^2 of points at the distance rho from the centre, in double-double arithmetic.

    It is small near the circle. Radii have the shape of the points.
    """
    r = DoubleDouble(radius)
    return r * r - from_centre.square


def _with_an_end_inside(edges: _Edges) -> ArrayPair:
    """Return start and length of the part inside the circle relative to each edge, from 0 to 1, (n, E).

    Both are 0 where both ends are outside.
    """
    first_in = edges.first_clear > 0.0
    last_in = edges.last_clear > 0.0
    share = (first_in & last_in).astype(float)
    start = np.zeros(share.shape)
    leaves = first_in & ~last_in
    share[leaves] = _share_from_inside(edges.only(leaves))
    enters = last_in & ~first_in
    share[enters] = _share_from_inside(edges.only(enters).reversed())
    start[enters] = 1.0 - share[enters]
    return start, share


def _share_from_inside(edges: _Edges) -> Floats:
    """Return the part of edges that begin inside up to the circle, relative to the edge.

    It is the root s of D s^2 + 2 b s = g, in the form without cancellation. D is the square of the edge, b the product
    of its first end and the edge, and g the clearance of the first end.
    """
    b = edges.first.dot(edges.edge)
    d = edges.edge.square
    g = edges.first_clear
    root = np.sqrt(b * b + d * g)
    forward = g / (b + root)
    backward = (root - b) / d
    share = np.where(b > 0.0, forward, backward)
    return np.minimum(share, 1.0)


def _may_pass_through(edges: _Edges) -> Flags:
    """Return whether an edge may pass through its circle although both ends are outside, (n, E).

    This requires that the foot of the perpendicular from the centre is between the ends.
    """
    to_foot = -edges.first.dot(edges.edge)
    square = edges.edge.square
    is_between = (to_foot > 0.0) & (to_foot < square)
    is_outside = (edges.first_clear == 0.0) & (edges.last_clear == 0.0)
    return is_between & is_outside


def _with_both_ends_outside(first: Vectors, last: Vectors, centre: Vectors, radius: Floats) -> ArrayPair:
    """Return start and length of the part inside relative to edges that may pass through a circle, from 0 to 1.

    Edges are given by their ends, with the centre and the radius of the circle of each, in m.

    The discriminant may be small and requires double-double arithmetic.
    """
    begin = _doubled(first)
    edge = _doubled(last) - begin
    from_centre = begin - _doubled(centre)
    b = from_centre.dot(edge)
    d = edge.square
    clearance = _clearance(from_centre, radius)
    discriminant = b * b + d * clearance
    not_negative = np.maximum(discriminant.high, 0.0)
    root = np.sqrt(not_negative)
    square = d.high
    start = np.maximum((-b.high - root) / square, 0.0)
    return start, np.minimum(2 * root / square, 1.0 - start)


def complete_stretches(parts: Cut) -> tuple[Integers, Integers, Flags]:
    """Return circle and number of every complete stretch, and whether each circle contains an end of the ground.

    A stretch is the ground between two crossings of a circle; numbers count from 0 from the left. The first two are
    arrays over all stretches, the last is (n,).
    """
    leaves_first = parts.leaves & (parts.stretch < 0)
    from_start = leaves_first.any(axis=1)  # the ground begins inside the circle
    count = parts.leaves.sum(axis=1) - from_start
    to_end = parts.enters.sum(axis=1) > count
    first_clear = parts.first[:, 0]
    last_clear = parts.second[:, -1]
    ends_inside = (first_clear > 0.0) & (last_clear > 0.0)
    all_inside = ends_inside & ~parts.leaves.any(axis=1)
    lanes = np.repeat(np.arange(len(count)), count)
    before = np.cumsum(count) - count
    number = np.arange(len(lanes)) - np.repeat(before, count)
    has_end = from_start | to_end | all_inside
    return lanes, number, has_end


def ends(parts: Cut, number: Any) -> tuple[Vectors, Vectors]:
    """Return the left and the right crossing of one stretch for each circle, from its centre over R, (n,) each.

    ``number`` is the number of the stretch of each circle, from 0.
    """
    mine = parts.stretch == np.asarray(number)[:, None]
    lane = np.arange(len(mine))
    enters = parts.enters & mine
    leaves = parts.leaves & mine
    first = lane, enters.argmax(axis=1)
    last = lane, leaves.argmax(axis=1)
    end = parts.start + parts.part
    return parts.start[first], end[last]


def moments(parts: Cut, mine: Flags) -> ArrayDict:
    """Return integrals over the mass below selected parts for each circle, by the names in ``MEASURES``, (n,).

    ``mine`` is a mask of the parts above the mass, (n, E), and lengths are over R. Source: `generated.slopes`. The
    relative error is about 1e-15, for vectors relative to their length. Short edges are integrated by quadrature of
    rings, and long edges by sectors and triangles.
    """
    bounds_mass = mine & parts.part.is_nonzero
    at = np.nonzero(bounds_mass)
    lane, _ = at
    start = parts.start[at]
    edge = parts.part[at]
    end = start + edge
    from_centre = start.length + end.length
    reach = slopes.REACH * from_centre
    is_long = edge.square > reach**2
    first = parts.first[at]
    second = parts.second[at]
    by_edge = np.empty((len(MEASURES), len(lane)))
    short = np.flatnonzero(~is_long)
    for k in range(0, len(short), _BLOCK):
        some = short[k : k + _BLOCK]
        rings = _ring_moments(start[some], edge[some], first[some], second[some])
        by_edge[:, some] = rings
    if np.any(is_long):
        sectors = _sector_moments(start[is_long], edge[is_long])
        by_edge[:, is_long] = sectors
    circles = len(mine)
    by_circle = [np.bincount(lane, values, circles) for values in by_edge]
    totals = np.array(by_circle)
    return dict(zip(MEASURES, totals, strict=True))


def _sector_moments(start: Vectors, edge: Vectors) -> Any:
    """Return moments below edges by the closed forms of sectors and triangles, each (edges,); lengths are over R."""
    end = start + edge
    angle = np.arctan2(start.cross(edge), start.dot(end))
    return slopes.closed(start.x, start.y, edge.x, edge.y, angle)


def _ring_moments(start: Vectors, edge: Vectors, first: Floats, second: Floats) -> Floats:
    """Return moments of the rings between edges and arcs, (measures, edges).

    Lengths are over R. ``first`` and ``second`` are g_1 and g_2 at the ends: g = (1-s) g_1 + s g_2 + s (1-s) d^2.
    """
    rest = 1.0 - _PLACES
    of_first = rest * first
    of_second = _PLACES * second
    bend = _PLACES * rest * edge.square
    gap = of_first + of_second + bend
    rings = slopes.rings(gap)
    parts_of_rings = [_SHARES * values for values in rings]
    area, polar, inertia, radial, moment = (values.sum(axis=0) for values in parts_of_rings)
    along_edge = [_PLACES * values for values in parts_of_rings[3:]]
    radial_s, moment_s = (values.sum(axis=0) for values in along_edge)
    of_radial = start * radial + edge * radial_s
    of_moment = start * moment + edge * moment_s
    by_edge = np.array([area, polar, inertia, *of_radial, *of_moment])
    doubled_area = start.cross(edge)
    return by_edge * doubled_area


def thickness(parts: Cut, mine: Flags) -> Floats:
    """Return the greatest radial distance from the arc to the ground over R, for each circle, (n,).

    ``mine`` is a mask of the edges above the mass, (n, E).
    """
    square = parts.part.square
    along = parts.start.dot(parts.part)
    to_foot = -along  # of the perpendicular from the centre
    on_edge = (to_foot > 0.0) & (to_foot < square)
    share = np.divide(to_foot, square, out=np.zeros_like(square), where=on_edge)
    rest = 1.0 - share
    along_chord = rest * parts.first + share * parts.second
    at_foot = along_chord + share * rest * square
    at_ends = np.maximum(parts.first, parts.second)
    gap = np.maximum(at_ends, at_foot)  # 1 - rho^2
    gap_of_mine = np.where(mine, gap, 0.0)
    widest = gap_of_mine.max(axis=1)
    greatest = np.minimum(widest, 1.0)
    least_distance = np.sqrt(1.0 - greatest)
    return greatest / (1.0 + least_distance)


def below_ground(parts: Cut, mine: Flags) -> Flags:
    """Return whether the centre of each circle lies below the ground of the stretch, (n,).

    ``mine`` is a mask of the edges above the mass, (n, E).
    """
    left = parts.start
    right = left + parts.part
    from_left = left.x <= 0.0
    to_right = right.x >= 0.0
    is_upright = parts.part.x <= 0.0
    around_centre = from_left & to_right & ~is_upright
    above_centre = left.cross(parts.part) <= 0.0
    is_below = mine & around_centre & above_centre
    return np.any(is_below, axis=1)
