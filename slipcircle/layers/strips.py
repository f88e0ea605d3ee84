"""Mass divided into vertical strips, with the soil at the base and the surfaces of each strip.

A *surface* is the lower envelope of several lines: the ground, the top of a layer cut off by the layers above it, or
the wet part of a layer. The mass is divided at every vertex of a line, every crossing of two lines, and every crossing
of a line and the arc, so that each surface is one straight edge in a strip, and the base of a strip lies in one layer.
Weights add exactly: with unit weights gamma_i, any moment is the sum over the surfaces of (gamma_i - gamma_(i-1)) times
the moment of the mass below.

Lengths are divided by R, the origin is the centre of the circle, and y points upwards. beta is measured from straight
below the centre, to the right. Arrays have the axes (surfaces, circles, strips) or some of them.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.base.sections import distinct
from slipcircle.ground.ground import continued
from slipcircle.ground.heights import edge_below
from slipcircle.ground.plane import Vectors

_THIN = 1e-14  # width below which strips are rounding
_ON_ARC = 1e-9


@dataclass(frozen=True)
class Strips:
    """Strips of masses above arcs, from left to right. Strips without width only fill the array.

    Attributes
    ----------
    x : ndarray
        Edges of the strips, (circles, strips + 1).
    y, slope : ndarray
        Height of each surface at the left edge of a strip, and its slope to the right.
    above : ndarray
        Whether a surface lies above the arc in a strip, followed, twice for each surcharge, by whether it covers the
        strip.
    base : ndarray
        Layer at the arc, counted from the ground, beyond the left end, in each strip, and beyond the right end,
        (circles, strips + 2).
    loads : sequence
        Surcharges on the ground, each with both ends x1 and x2, (circles, 1).
    """

    x: Floats
    y: Floats
    slope: Floats
    above: Flags
    base: Integers
    loads: Sequence[Sequence[Floats]]

    @property
    def beta(self) -> Floats:
        """Directions of the edges at the arc, rad."""
        sine = np.clip(self.x, -1.0, 1.0)
        return np.arcsin(sine)


def cut_into_strips(
    lines: Sequence[Floats],
    surfaces: Sequence[Sequence[int]],
    layers: int,
    ends: Sequence[Vectors],
    extra: Sequence[Floats],
    loads: Sequence[Sequence[Floats]],
) -> Strips:
    """Divide masses into strips, and return them.

    Parameters
    ----------
    lines : sequence of ndarray
        Points from left to right relative to the centre, over R, (circles or 1, V, 2), continued horizontally. The
        ground is first, followed by the top of each further layer, and by other lines.
    surfaces : sequence
        Numbers of the lines whose lower envelope is each surface.
    layers : int
        Number of lines, from the first on, that are tops of layers.
    ends : pair of Vectors
        Both ends of the arcs, (circles,).
    extra : sequence of ndarray
        Further x of edges, (circles, M), at crossings of lines among them.
    loads : sequence
        Value of `Strips.loads`.
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
    covered = []
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
    """Return the index of the lowest line of a surface in each strip.

    `at_middle` are heights of all lines at the middles of strips, (lines, circles, strips). `chosen` are the indices of
    the lines of the surface.
    """
    rows = np.asarray(chosen)
    heights = at_middle[rows]
    lowest = np.argmin(heights, axis=0)
    return rows[lowest]


def _base(tops: Floats, arc: Floats) -> Integers:
    """Return the index of the layer at the arc from tops, each cut off by the tops above it.

    Tops (layers, circles, strips) and the arc (circles, strips) are heights over R.
    """
    boundaries = np.minimum.accumulate(tops, axis=0)
    above = np.count_nonzero(boundaries > arc, axis=0)
    return np.maximum(above - 1, 0)


def _with_ends(base: Integers, has_width: Flags, tops: Sequence[Floats], ends: Sequence[Vectors]) -> Integers:
    """Return the layers at the arc in strips and beyond both ends, (circles, strips + 2).

    Strips without width, where `has_width` is false, have the layer beyond the right end. `base` are the layers in the
    strips, (circles, strips), and `ends` the left and the right end of the arcs.
    """
    first, last = ends
    beyond_left = _layer_at_end(tops, first, _ON_ARC)
    beyond_right = _layer_at_end(tops, last, -_ON_ARC)
    in_strips = np.where(has_width, base, beyond_right)
    return np.concatenate([beyond_left, in_strips, beyond_right], axis=1)


def _layer_at_end(tops: Sequence[Floats], end: Vectors, inward: float) -> Integers:
    """Return the layer at an end of the arcs, whose soil continues beyond it, (circles, 1).

    `inward` is a small step along x towards the middle of the arc. If boundaries coincide there, the lowest soil is
    used. The strip beside the end cannot decide this, since its layer would be rounding where it has no width.
    """
    x = end.x[:, None]
    inside = x + inward  # at a scarp the ground of the mass applies
    heights = [edge_below(top, x, inside)[0] for top in tops]
    just_below = end.y[:, None] - _ON_ARC
    return _base(np.stack(heights), just_below)


def _edges(lines: Sequence[Floats], first: Floats, last: Floats, extra: Sequence[Floats]) -> Floats:
    """Return the sorted edges of the strips, (circles, strips + 1).

    `first` and `last` are x of the left and of the right end of the arcs, (circles,), and `extra` are x of further
    edges.
    """
    left = first[:, None]
    right = last[:, None]
    cuts = [*extra]
    for line in lines:
        cuts += [line[..., 0], meets_circle(line)]
    circles = len(first)
    of_circles = [np.broadcast_to(x, (circles, x.shape[-1])) for x in cuts]
    every = np.concatenate(of_circles, axis=1)
    inside = (left < every) & (every < right)
    of_any_circle = np.any(inside, axis=0)
    within_mass = np.clip(every[:, of_any_circle], left, right)
    edges = np.concatenate([left, np.sort(within_mass), right], axis=1)
    return distinct(edges.T, _THIN).T


def crossings_of_lines(lines: Sequence[Floats], far: float) -> Iterator[Floats]:
    """Yield x at crossings of each two lines (n or 1, V, 2), continued horizontally up to -far and far, (n or 1, M)."""
    longer = [continued(line, -far, far) for line in lines]
    for one, other in combinations(longer, 2):
        yield line_crossings(one, other)


def meets_circle(line: Floats) -> Floats:
    """Return x where the edges of lines cross the unit circle, (n, 2 E).

    An edge without crossing has x of its first end.

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
    """Return x where the edges of lines cross the lower half of the unit circle, (n, 2 E), NaN without crossing.

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
    """Return x where the edges of two lines (n or 1, V, 2) cross, (n, E1 E2), or x of a vertex without crossing.

    E1 and E2 are the numbers of edges. The vertex is the second of the first line: the first one may be far outside,
    where a line is continued.
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
    """Return whether a point lies between the ends of an edge, from its position, 0 at the start and 1 at the end."""
    after_start = share > 0.0
    before_end = share < 1.0
    return after_start & before_end
