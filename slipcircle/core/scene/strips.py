"""A mass cut into vertical strips: which soil lies at its base, and which edges of lines are its surfaces there.

A *surface* is the lower envelope of some lines: the ground, the top of a layer cut off by those above it, the wet part
of a layer. The mass is cut at every vertex of a line, every crossing of two lines, and every crossing of a line and
the arc, so that in a strip each surface is one straight edge and the base lies in one layer. Weights add exactly: with
unit weights gamma_i, any moment is the sum over the surfaces of (gamma_i - gamma_(i-1)) times that of the mass below.

Lengths are over R from the centre of the circle, y up; beta is measured from straight below the centre, to the right.
Arrays have the axes (surfaces, circles, strips) or parts of them. Points may be complex, with a derivative in their
imaginary part (`slipcircle.core.scene.tangent_section`): NumPy orders complex numbers by their real parts first.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene.ground import continued

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
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
        Whether a surface lies above the arc in a strip.
    base : ndarray
        The layer at the arc, counted from the ground, (circles, strips).
    loads : sequence
        Surcharges on the ground, each by both its ends, x1 and x2, (circles, 1).
    """

    x: Floats
    y: Floats
    slope: Floats
    above: NDArray[np.bool_]
    base: Integers
    loads: Sequence[Sequence[Floats]] = ()

    @property
    def beta(self) -> Floats:
        """Directions of their edges at the arc, rad."""
        return np.arcsin(np.clip(self.x, -1.0, 1.0))


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
    lines = [continued(line, -2.0, 2.0) for line in lines]  # beyond both sides of the circle
    edges = _edges(lines, first, last, extra)
    left = edges[:, :-1]
    middle = (left + edges[:, 1:]) / 2
    arc = -np.sqrt((1.0 - middle) * (1.0 + middle))
    start, slope = np.stack([edge_below(line, left, middle) for line in lines], axis=1)
    half_width = middle - left
    at_middle = start + slope * half_width
    lowest = np.stack([_lowest(at_middle, chosen) for chosen in surfaces])
    height = np.take_along_axis(at_middle, lowest, 0)
    return Strips(
        x=edges,
        y=np.take_along_axis(start, lowest, 0),
        slope=np.take_along_axis(slope, lowest, 0),
        above=height > arc,
        base=_base(at_middle[:layers], arc),
        loads=loads,
    )


def _lowest(at_middle: Floats, chosen: Sequence[int]) -> Integers:
    """The number of that line of a surface which is lowest in each strip."""
    rows = np.asarray(chosen)
    heights = at_middle[rows]
    lowest = np.argmin(heights, axis=0)
    return np.asarray(rows[lowest])


def _base(tops: Floats, arc: Floats) -> Integers:
    """The layer at the arc, of tops that are cut off by those above them."""
    boundaries = np.minimum.accumulate(tops, axis=0)
    above = np.count_nonzero(boundaries > arc, axis=0)
    return np.maximum(above - 1, 0)


def _edges(lines: Sequence[Floats], first: Floats, last: Floats, extra: Floats | None) -> Floats:
    """Edges of the strips, (circles, strips + 1), sorted."""
    left = first[:, None]
    right = last[:, None]
    cuts = [left, right]
    cuts += [line[..., 0] for line in lines]
    cuts += [meets_circle(line) for line in lines]
    cuts += [line_crossings(one, other) for one, other in combinations(lines, 2)]
    if extra is not None:
        cuts.append(extra)
    circles = len(first)
    of_circles = [np.broadcast_to(x, (circles, x.shape[-1])) for x in cuts]
    every = np.concatenate(of_circles, axis=1)
    within_mass = np.clip(every, left, right)
    edges = np.sort(within_mass, axis=1)
    width = np.diff(edges, axis=1)
    has_width = np.any(width.real > _THIN, axis=0)
    is_needed = np.concatenate([[True], has_width])
    return edges[:, is_needed]


def meets_circle(line: Floats) -> Floats:
    """x where the edges of lines cross the unit circle, (n, 2 E); of an edge that does not, that of its first end.

    Lines are (n, V, 2), from the centre, over R.
    """
    start = line[:, :-1]
    edge = np.diff(line, axis=1)
    square = np.sum(edge * edge, axis=2)
    along = np.sum(start * edge, axis=2)
    distance_squared = np.sum(start * start, axis=2)
    outside = distance_squared - 1.0
    discriminant = along * along - square * outside
    crosses = discriminant.real > 0.0
    positive = np.where(crosses, discriminant, 1.0)
    root = np.sqrt(positive)
    has_length = square.real > 0.0
    divisor = np.where(has_length, square, 1.0)
    first_x = start[..., 0]
    run = edge[..., 0]
    crossings = []
    for sign in (-1.0, 1.0):
        along_edge = -along + sign * root
        share = along_edge / divisor
        after_start = share.real >= 0.0
        before_end = share.real <= 1.0
        on_edge = crosses & after_start & before_end
        at_crossing = first_x + share * run
        x = np.where(on_edge, at_crossing, first_x)
        crossings.append(x)
    return np.concatenate(crossings, axis=1)


def arc_crossings(line: Floats) -> Floats:
    """x where the edges of lines cross the lower half of the unit circle, (n, 2 E); NaN of an edge that does not.

    Lines are (n, V, 2), from the centre, over R.
    """
    x = meets_circle(line)
    height, _ = edge_below(line, x, x)
    depth_of_arc = np.sqrt(np.maximum(1.0 - x * x, 0.0))
    on_arc = np.abs(height + depth_of_arc) < _ON_ARC
    return np.where(on_arc, x, np.nan)


def line_crossings(one: Floats, other: Floats) -> Floats:
    """x where the edges of two lines (n or 1, V, 2) cross each other, (n, E1 E2); that of a vertex where they do not.

    The vertex is the second of the first line: the first one may be far outside, where a line is continued.
    """
    start = one[:, :-1, None]
    edge = np.diff(one, axis=1)[:, :, None]
    other_edge = np.diff(other, axis=1)[:, None]
    apart = other[:, None, :-1] - start
    across = _cross(edge, other_edge)
    parallel = across.real == 0.0
    safe = np.where(parallel, 1.0, across)
    share = _cross(apart, other_edge) / safe
    other_share = _cross(apart, edge) / safe
    inside = _within_edge(share) & _within_edge(other_share)
    crosses = inside & ~parallel
    start_x = start[..., 0]
    run = edge[..., 0]
    at_crossing = start_x + share * run
    at_vertex = one[:, 1, 0, None, None]
    x = np.where(crosses, at_crossing, at_vertex)
    return x.reshape(len(x), -1)


def _within_edge(share: Floats) -> NDArray[np.bool_]:
    """Whether a point lies between the ends of an edge, by its share of it."""
    after_start = share.real > 0.0
    before_end = share.real < 1.0
    return after_start & before_end


def _cross(a: Floats, b: Floats) -> Floats:
    """The cross product of vectors."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def edge_below(line: Floats, x: Floats, middle: Floats) -> tuple[Floats, Floats]:
    """y of lines (n or 1, V, 2) at x (n, M), and their slopes, of the edges below or above the points ``middle``."""
    points = np.broadcast_to(line, (len(x), *line.shape[1:]))
    vertices = points[:, None, :, 0].real
    behind = vertices <= middle[..., None].real
    passed = np.count_nonzero(behind, axis=-1)
    last_edge = points.shape[1] - 2
    edge = np.clip(passed - 1, 0, last_edge)
    circle = np.arange(len(x))[:, None]
    start_x, start_y = np.moveaxis(points[circle, edge], -1, 0)
    end_x, end_y = np.moveaxis(points[circle, edge + 1], -1, 0)
    run = end_x - start_x
    rise = end_y - start_y
    upright = run.real <= 0.0
    divisor = np.where(upright, 1.0, run)
    slope = np.where(upright, 0.0, rise / divisor)
    along = x - start_x
    return start_y + slope * along, slope
