"""Integrals of the height of a line, the ground or a water level, above the arcs of circles.

The height at a point of an arc is measured vertically to the line at the same x. Where the arc overhangs, the column
above it contains ground outside the mass, which contributes load and water as well. A line continues horizontally
beyond its ends. Where it lies below the arc the height is 0.

Lengths are divided by R, and the origin is the centre. Angles are measured from straight below the centre in rad, so
that a point of the arc is (sin, -cos). A line y = y_0 + s (x - x_0) is y_0 + s (sin - x_0) + cos above it, on the lower
half of the circle (cos > 0) and on the upper half.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from generated import slopes
from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.ground.circles import Cut, cut_by_circles
from slipcircle.ground.ground import continued
from slipcircle.ground.pieces import GroundPieces, edge_slopes, pieces_inside, span_of
from slipcircle.ground.plane import Vectors, each_lane

_TOGETHER = 1 << 14  # arcs times pieces per block, whose arrays fit into the cache


class HeightIntegrals(NamedTuple):
    """Pieces of circles with an edge of a line above each, over two turns from -3 pi/2 on."""

    pieces: GroundPieces

    @property
    def kinks(self) -> Floats:
        """Angles at which heights may have kinks, in rad from straight below the centre, (n, 2 pieces)."""
        ends = [self.pieces.low, self.pieces.high]
        return np.concatenate(ends, axis=1)

    def integral(self, first: Floats, last: Floats) -> Floats:
        """Return integrals of the height over the angle along arcs, (..., n), over R.

        ``first`` and ``last`` are angles in rad from straight below the centre, (..., n).
        """
        turn = 2 * np.pi
        ahead = first + 1.5 * np.pi
        turns = turn * np.floor(ahead / turn)
        new_first = first - turns  # within a turn from -3 pi/2
        new_last = last - turns
        shape = np.shape(new_first)
        *rotations, circles = shape
        several = (math.prod(rotations), circles, 1)
        start = new_first.reshape(several)
        end = new_last.reshape(several)
        total = np.zeros(start.shape[:2])
        if total.size == 0:
            return total.reshape(shape)
        rows = max(1, _TOGETHER // circles)
        together = max(1, _TOGETHER // total.size)
        lowest = self.pieces.low.min(axis=0)
        highest = self.pieces.high.max(axis=0)
        for row in range(0, len(total), rows):
            some = slice(row, row + rows)
            begins = start[some]
            ends = end[some]
            is_before = highest <= begins.min()
            is_after = lowest >= ends.max()
            reached = np.flatnonzero(~(is_before | is_after))
            for k in range(0, len(reached), together):
                chosen = reached[k : k + together]
                pieces = self.pieces.only(chosen)
                by_piece = _over_parts(pieces, begins, ends)
                total[some] += by_piece.sum(axis=-1)
        return total.reshape(shape)


def _over_parts(pieces: GroundPieces, first: Floats, last: Floats) -> Any:
    """Return integrals over the parts of pieces between two angles, each from its own start to avoid cancellation.

    Angles are in rad, (rows, n, 1), and the result is (rows, n, pieces), with one row if all rows are equal.
    """
    low, high, span, sine, cosine, height, slope = pieces
    if np.all(first <= low) and np.all(last >= high):  # whole in all rows
        first = first[:1]
        last = last[:1]
    start = np.clip(first, low, high)
    stop = np.clip(last, low, high)
    from_low = start <= low
    to_high = stop >= high
    is_whole = from_low & to_high
    part = stop - start
    angle = np.where(is_whole, span, part)
    ahead = start - low
    tangent = np.tan(ahead / 2)
    square = tangent**2
    along = 2 * tangent / (1.0 + square)  # sin(ahead)
    bent = along * tangent  # 1 - cos(ahead)
    more_sine = cosine * along - sine * bent
    fall = sine * along
    more_cosine = -fall - cosine * bent
    rise = slope * more_sine
    start_height = height + rise + more_cosine
    start_sine = sine + more_sine
    start_cosine = cosine + more_cosine
    return slopes.head(angle, start_sine, start_cosine, start_height, slope)


def edge_below(line: Floats, x: Floats, middle: Floats) -> ArrayPair:
    """Return y of lines (n or 1, V, 2) at x (n, M), and their slopes, for the edges at the points `middle`.

    `middle` are x of points, (n, M), each of which selects one of the V - 1 edges.
    """
    vertices = Vectors.of(line)
    inner = vertices.x.T[1:-1, :, None]
    edge = (inner <= middle).sum(axis=0)
    start = vertices.starts
    slopes_of_edges = edge_slopes(vertices.edges)
    by_edge = np.stack([start.x, start.y, slopes_of_edges])
    circle = np.arange(len(line))[:, None]
    start_x, start_y, slope = by_edge[:, circle, edge]
    along = x - start_x
    rise = slope * along
    return start_y + rise, slope


def height_integrals(points: Floats, centre: Floats, radius: Floats) -> HeightIntegrals:
    """Return height integrals of lines above circles. Lines are (n or 1, V, 2), centres (n, 2) and radii (n,), in m.

    Each edge has up to three parts: before the circle, inside, and after it. A part outside and above the circle lies
    over the lower half and over the upper half, which is traversed from right to left.
    """
    of_circles = each_lane(points, len(radius))
    x = centre[:, 0]
    beyond = 2 * radius
    left = x - beyond
    right = x + beyond
    points = continued(of_circles, left, right)
    from_centre = points - centre[:, None]
    line = from_centre / radius[:, None, None]
    edges = Vectors.of(points).edges
    slope = edge_slopes(edges)
    parts = cut_by_circles(points, centre, radius)
    vertices = Vectors.of(line)
    lower, upper = _halves(parts, vertices, slope)

    turn = 2 * np.pi
    before = [pieces.turned(-turn) for pieces in upper]
    after = [pieces.turned(turn) for pieces in lower]
    by_column = zip(*before, *lower, *upper, *after, strict=True)
    columns = [np.concatenate(column, axis=1) for column in by_column]
    return HeightIntegrals(GroundPieces(*columns))


def _halves(parts: Cut, line: Vectors, slope: Floats) -> tuple[list[GroundPieces], list[GroundPieces]]:
    """Return pieces over the lower halves of circles, for all three parts of edges, and over the upper halves.

    The three parts of an edge are inside, before and after the circle; ``line`` has the vertices from the centre, and
    ``slope`` is dy/dx of the edges.
    """
    start = line.starts
    last = line.ends.x
    has_part_inside = parts.part.is_nonzero
    entry = parts.start
    exit_ = entry + parts.part
    enters = np.where(has_part_inside, entry.x, last)
    leaves = np.where(has_part_inside, exit_.x, last)
    before, before_upper = _outside(start, slope, start.x, enters)
    after, after_upper = _outside(start, slope, leaves, last)
    inside = pieces_inside(parts, slope)
    return [inside.used, before.used, after.used], [before_upper.used, after_upper.used]


def _outside(start: Vectors, slope: Floats, first: Floats, last: Floats) -> tuple[GroundPieces, GroundPieces]:
    """Return pieces over the lower and the upper half for the parts of edges outside circles between two x.

    ``start`` is the first end of an edge, and ``slope`` its dy/dx. All lengths are over R, from the centre.
    """
    x = np.clip(first, -1.0, 1.0)
    end_x = np.clip(last, -1.0, 1.0)
    to_first = x - start.x
    to_last = end_x - start.x
    y = start.y + slope * to_first
    end_y = start.y + slope * to_last
    cosine = _half_width(x)
    end_cosine = _half_width(end_x)
    run = end_x - x
    is_upper = y + end_y > 0.0
    is_above = is_upper & (run > 0.0)
    full_span = span_of(run, cosine, end_cosine)
    span = np.where(is_above, full_span, 0.0)
    low = np.arctan2(x, cosine)
    end_angle = np.arctan2(end_x, end_cosine)
    high = np.where(is_above, end_angle, low)
    above_lower = y + cosine
    above_upper = end_y - end_cosine
    lower = GroundPieces(low, high, span, x, cosine, above_lower, slope)
    upper_low = np.pi - high
    upper_high = np.pi - low
    upper = GroundPieces(upper_low, upper_high, span, end_x, -end_cosine, above_upper, slope)
    return lower, upper


def _half_width(x: Floats) -> Floats:
    """Return half the width of the circle over R at x over R from the centre.

    It is the cosine of a direction whose sine is x.
    """
    square = (1.0 - x) * (1.0 + x)
    return np.sqrt(square)
