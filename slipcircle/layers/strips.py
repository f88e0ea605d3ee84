"""A mass cut into vertical strips: which soil lies at its base, and which edges of lines are its surfaces there.

A *surface* is the lower envelope of some lines: the ground, the top of a layer cut off by those above it, the wet part
of a layer. The mass is cut at every vertex of a line, every crossing of two lines, and every crossing of a line and
the arc, so that in a strip each surface is one straight edge and the base lies in one layer. Weights add exactly: with
unit weights gamma_i, any moment is the sum over the surfaces of (gamma_i - gamma_(i-1)) times that of the mass below.

Lengths are over R from the centre of the circle, y up; beta is measured from straight below the centre, to the right.
Arrays have the axes (surfaces, circles, strips) or parts of them.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.base.sections import distinct
from slipcircle.ground.ground import continued
from slipcircle.ground.plane import Vectors, each_lane

_THIN = 1e-14  # narrower strips are rounding
_ON_ARC = 1e-9


@dataclass(frozen=True)
class Strips:
    """Strips of masses above arcs, from left to right; those of no width only fill the array.

    Attributes
    ----------
    x : ndarray
        Their edges, (circles, strips + 1).
    y, slope : ndarray
        Of the surfaces, the height at the left edge of a strip and the rise over a run to the right.
    above : ndarray
        Whether a surface lies above the arc in a strip; then, twice for each surcharge, whether it covers the strip.
    base : ndarray
        The layer at the arc, counted from the ground, beyond the left end, in each strip, and beyond the right end,
        (circles, strips + 2).
    loads : sequence
        Surcharges on the ground, each by both its ends, x1 and x2, (circles, 1).
    """

    x: Floats
    y: Floats
    slope: Floats
    above: Flags
    base: Integers
    loads: Sequence[Sequence[Floats]] = ()

    @property
    def beta(self) -> Floats:
        """Directions of their edges at the arc, rad."""
        sine = np.clip(self.x, -1.0, 1.0)
        return np.arcsin(sine)


def cut_into_strips(
    lines: Sequence[Floats],
    surfaces: Sequence[Sequence[int]],
    layers: int,
    ends: Sequence[Vectors],
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
    ends : pair of Vectors
        Both ends of the arcs, (circles,).
    extra : ndarray, optional
        Further x at which to cut, (circles or 1, M).
    loads : sequence
        `Strips.loads`.
    """
    first, last = ends
    lines = [continued(line, -2.0, 2.0) for line in lines]  # beyond both sides of the circle
    edges = _edges(lines, first.x, last.x, extra)
    left = edges[:, :-1]
    right = edges[:, 1:]
    middle = (left + right) / 2
    depth_squared = (1.0 - middle) * (1.0 + middle)
    arc = -np.sqrt(depth_squared)
    edges_below = [edge_below(line, left, middle) for line in lines]
    start, slope = np.stack(edges_below, axis=1)
    half_width = middle - left
    at_middle = start + slope * half_width
    by_surface = [_lowest(at_middle, chosen) for chosen in surfaces]
    lowest = np.stack(by_surface)
    height = np.take_along_axis(at_middle, lowest, 0)
    covered = list[Flags]()
    for x1, x2 in loads:
        is_under = (middle > x1) & (middle < x2)
        covered += [is_under, is_under]
    in_strips = _base(at_middle[:layers], arc)
    return Strips(
        x=edges,
        y=np.take_along_axis(start, lowest, 0),
        slope=np.take_along_axis(slope, lowest, 0),
        above=np.stack([*(height > arc), *covered]),
        base=_with_ends(in_strips, right > left, lines[:layers], ends),
        loads=loads,
    )


def _lowest(at_middle: Floats, chosen: Sequence[int]) -> Integers:
    """The number of that line of a surface which is lowest in each strip."""
    rows = np.asarray(chosen)
    heights = at_middle[rows]
    lowest = np.argmin(heights, axis=0)
    return rows[lowest]


def _base(tops: Floats, arc: Floats) -> Integers:
    """The layer at the arc, of tops that are cut off by those above them."""
    boundaries = np.minimum.accumulate(tops, axis=0)
    above = np.count_nonzero(boundaries > arc, axis=0)
    return np.maximum(above - 1, 0)


def _with_ends(base: Integers, has_width: Flags, tops: Sequence[Floats], ends: Sequence[Vectors]) -> Integers:
    """The layers at the arc in strips, of those without width that beyond the right end, and beyond both ends."""
    first, last = ends
    beyond_left = _layer_at_end(tops, first, _ON_ARC)
    beyond_right = _layer_at_end(tops, last, -_ON_ARC)
    in_strips = np.where(has_width, base, beyond_right)
    return np.concatenate([beyond_left, in_strips, beyond_right], axis=1)


def _layer_at_end(tops: Sequence[Floats], end: Vectors, inward: float) -> Integers:
    """The layer at an end of the arcs, whose soil goes on beyond it, (circles, 1).

    Of boundaries that coincide there the lowest soil counts. The strip beside the end does not decide this: of no width
    in some circles, its layer would be rounding.
    """
    x = end.x[:, None]
    inside = x + inward  # at a scarp the ground of the mass counts
    heights = [edge_below(top, x, inside)[0] for top in tops]
    just_below = end.y[:, None] - _ON_ARC
    return _base(np.stack(heights), just_below)


def _edges(lines: Sequence[Floats], first: Floats, last: Floats, extra: Floats | None) -> Floats:
    """Edges of the strips, (circles, strips + 1), sorted."""
    left = first[:, None]
    right = last[:, None]
    cuts = [left, right]
    for line in lines:
        cuts += [line[..., 0], meets_circle(line)]
    for one, other in combinations(lines, 2):
        cuts.append(line_crossings(one, other))
    if extra is not None:
        cuts.append(extra)
    circles = len(first)
    of_circles = [np.broadcast_to(x, (circles, x.shape[-1])) for x in cuts]
    every = np.concatenate(of_circles, axis=1)
    within_mass = np.clip(every, left, right)
    edges = np.sort(within_mass.T, axis=0)
    return distinct(edges, _THIN).T


def meets_circle(line: Floats) -> Floats:
    """x where the edges of lines cross the unit circle, (n, 2 E); of an edge that does not, that of its first end.

    Lines are (n, V, 2), from the centre, over R.
    """
    points = Vectors.of(line)
    start = points.starts
    edge = points.edges
    square = edge.square
    along = start.dot(edge)
    outside = start.square - 1.0
    discriminant = along * along - square * outside
    crosses = discriminant > 0.0
    positive = np.where(crosses, discriminant, 1.0)
    root = np.sqrt(positive)
    has_length = square > 0.0
    divisor = np.where(has_length, square, 1.0)
    crossings = []
    for signed_root in (-root, root):
        share = (signed_root - along) / divisor
        after_start = share >= 0.0
        before_end = share <= 1.0
        on_edge = crosses & after_start & before_end
        at_crossing = start.x + share * edge.x
        x = np.where(on_edge, at_crossing, start.x)
        crossings.append(x)
    return np.concatenate(crossings, axis=1)


def arc_crossings(line: Floats) -> Floats:
    """x where the edges of lines cross the lower half of the unit circle, (n, 2 E); NaN of an edge that does not.

    Lines are (n, V, 2), from the centre, over R.
    """
    x = meets_circle(line)
    height, _ = edge_below(line, x, x)
    depth_squared = np.maximum(1.0 - x * x, 0.0)
    depth_of_arc = np.sqrt(depth_squared)
    above_arc = height + depth_of_arc
    on_arc = np.abs(above_arc) < _ON_ARC
    return np.where(on_arc, x, np.nan)


def line_crossings(one: Floats, other: Floats) -> Floats:
    """x where the edges of two lines (n or 1, V, 2) cross each other, (n, E1 E2); that of a vertex where they do not.

    The vertex is the second of the first line: the first one may be far outside, where a line is continued.
    """
    points = Vectors.of(one)
    others = Vectors.of(other)
    start = points.starts[:, :, None]
    edge = points.edges[:, :, None]
    other_edge = others.edges[:, None]
    other_start = others.starts[:, None]
    apart = other_start - start
    across = edge.cross(other_edge)
    parallel = across == 0.0
    divisor = np.where(parallel, 1.0, across)
    share = apart.cross(other_edge) / divisor
    other_share = apart.cross(edge) / divisor
    inside = _within_edge(share) & _within_edge(other_share)
    crosses = inside & ~parallel
    at_crossing = start.x + share * edge.x
    at_vertex = points.x[:, 1, None, None]
    x = np.where(crosses, at_crossing, at_vertex)
    _, *pairs = x.shape
    return x.reshape(len(x), math.prod(pairs))


def _within_edge(share: Floats) -> Flags:
    """Whether a point lies between the ends of an edge, by its share of it."""
    after_start = share > 0.0
    before_end = share < 1.0
    return after_start & before_end


def edge_below(line: Floats, x: Floats, middle: Floats) -> tuple[Floats, Floats]:
    """y of lines (n or 1, V, 2) at x (n, M), and their slopes, of the edges below or above the points ``middle``."""
    of_points = each_lane(line, len(x))
    vertices = Vectors.of(of_points)
    place = middle[..., None]
    behind = vertices.x[:, None] <= place
    passed = np.count_nonzero(behind, axis=-1)
    last_edge = line.shape[1] - 2
    first = np.clip(passed - 1, 0, last_edge)
    circle = np.arange(len(x))[:, None]
    start = vertices[circle, first]
    end = vertices[circle, first + 1]
    edge = end - start
    upright = edge.x <= 0.0
    divisor = np.where(upright, 1.0, edge.x)
    steepness = edge.y / divisor
    slope = np.where(upright, 0.0, steepness)
    along = x - start.x
    return start.y + slope * along, slope
