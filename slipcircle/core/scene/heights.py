"""Integrals of the height of a line, the ground or a water level, above the arcs of circles.

A point of an arc lies under the line's point at its own x, however the arc gets there: where it overhangs, the column
above it goes through ground outside the mass, which presses and is wet all the same; so does that above the point
below. A line goes on horizontally beyond its ends; where it lies below the arc its height counts as 0.

Lengths are over R and from the centre. Angles are from straight below the centre, rad: the arc's point is at
(sin, -cos), and a line y = y_0 + s (x - x_0) is y_0 + s (sin - x_0) + cos above it, on the lower half of the circle
(cos > 0) as on the upper one.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes
from slipcircle.core.scene.circles import Cut, Floats, cut


class HeightIntegrals(NamedTuple):
    """Pieces of the circles, in order of their angles, over which one edge of a line lies above the arc, (n, P)."""

    low: Floats  # angles of a piece's ends
    high: Floats
    span: Floats  # high - low, to full precision
    sine: Floats  # at the low end
    cosine: Floats
    height: Floats
    slope: Floats  # of the edge
    edge: NDArray[np.int64]  # its number, (P,)
    line: Floats  # vertices of the line with its continuations, (n, V, 2)

    def reduced(self, first: Floats, last: Floats) -> tuple[Floats, Floats]:
        """Both ends of arcs turned by whole turns to where the pieces are."""
        turns = 2 * np.pi * np.floor((first + 1.5 * np.pi) / (2 * np.pi))
        return first - turns, last - turns

    def integral(self, first: Floats, last: Floats) -> Floats:
        """Over arcs from one angle to another, (..., n): of whole pieces between, and of parts of the outer two."""
        first, last = self.reduced(first, last)
        lane, piece = np.arange(len(self.low)), np.arange(self.low.shape[1])
        begin, end = (np.maximum(np.count_nonzero(self.low <= x[..., None], axis=-1) - 1, 0) for x in (first, last))
        in_first, in_last = self._part(first, last, (lane, begin)), self._part(first, last, (lane, end))
        whole = slopes.head(self.span, self.sine, self.cosine, self.height, self.slope)
        between = (piece > begin[..., None]) & (piece < end[..., None])
        return in_first + np.where(begin == end, 0.0, np.where(between, whole, 0.0).sum(axis=-1) + in_last)

    def _part(self, first: Floats, last: Floats, of: Any) -> Any:
        """Over what some pieces have between two angles, from its own beginning, so that nothing cancels."""
        low, high, sine, cosine, slope = self.low[of], self.high[of], self.sine[of], self.cosine[of], self.slope[of]
        start, stop = np.clip(first, low, high), np.clip(last, low, high)
        angle = np.where((start <= low) & (stop >= high), self.span[of], stop - start)
        along, bent = np.sin(start - low), 2 * np.sin((start - low) / 2) ** 2
        more_sine, more_cosine = cosine * along - sine * bent, -sine * along - cosine * bent
        height = self.height[of] + slope * more_sine + more_cosine
        return slopes.head(angle, sine + more_sine, cosine + more_cosine, height, slope)

    def gradient(self, first: Floats, last: Floats) -> Floats:
        """Derivatives of the integral by the vertices of the line of a single circle, ends held, (..., V, 2).

        A vertex moves an edge's height by its hat function, (sin - x)/run for the second one, and, moving
        horizontally, by minus the edge's slope times that.
        """
        first, last = self.reduced(first, last)
        start = np.clip(first[..., None], self.low[0], self.high[0])
        stop = np.clip(last[..., None], self.low[0], self.high[0])
        vertex, run = self.line[0, self.edge, 0], np.diff(self.line[0, :, 0])[self.edge]
        second = (np.cos(start) - np.cos(stop) - vertex * (stop - start)) / run
        direction = np.stack([-self.slope[0], np.ones_like(run)], axis=1)
        by_vertex = np.zeros((*second.shape[:-1], *self.line.shape[1:]))
        for k, hat in ((0, stop - start - second), (1, second)):
            of_vertex: Any = (..., self.edge + k, slice(None))
            np.add.at(by_vertex, of_vertex, hat[..., None] * direction)
        return by_vertex

    def at(self, angle: Floats) -> Floats:
        """Height above the arcs of a single circle at angles, (...,)."""
        angle, _ = self.reduced(angle, angle)
        above = (self.low[0] <= angle[..., None]) & (angle[..., None] < self.high[0])
        x, y = self.line[0, self.edge].T
        height = y + self.slope[0] * (np.sin(angle)[..., None] - x) + np.cos(angle)[..., None]
        return np.where(above, height, 0.0).sum(axis=-1)


class _Pieces(NamedTuple):
    """As in `HeightIntegrals`, (n, pieces)."""

    low: Floats
    high: Floats
    span: Floats
    sine: Floats
    cosine: Floats
    height: Floats

    def turned(self, angle: float) -> "_Pieces":
        return self._replace(low=self.low + angle, high=self.high + angle)

    def backwards(self) -> "_Pieces":
        return _Pieces(*(columns[:, ::-1] for columns in self))


def integral_inside(parts: Cut) -> Floats:
    """Of the heights of the parts of edges inside circles, (n, E), above arcs that do not overhang."""
    pieces = _inside(parts)
    gradient = _gradient(parts.e_x, parts.e_y)
    return np.asarray(slopes.head(pieces.span, pieces.sine, pieces.cosine, pieces.height, gradient))


def height_integrals(points: Floats, centre: Floats, radius: Floats) -> HeightIntegrals:
    """Of lines (n or 1, V, 2) above circles (n, 2), (n,), m.

    Each edge has three parts: before it enters the circle, inside, and after. Above the circle it is over the upper
    half, which angles pass from right to left, as over the lower half.
    """
    points = _continued(points, centre, radius)
    line = (points - centre[:, None]) / radius[:, None, None]
    gradient = _gradient(*np.moveaxis(np.diff(points, axis=1), -1, 0))
    parts = cut(points, centre, radius)
    missed = (parts.e_x == 0.0) & (parts.e_y == 0.0)  # edges outside the circle: all of it before
    enters = np.where(missed, line[:, 1:, 0], parts.x)
    leaves = np.where(missed, line[:, 1:, 0], parts.x + parts.e_x)
    before, before_upper = _outside(line[:, :-1], gradient, line[:, :-1, 0], enters)
    after, after_upper = _outside(line[:, :-1], gradient, leaves, line[:, 1:, 0])
    inside = _inside(parts)
    none = inside._replace(low=before.high, high=before.high, span=np.zeros_like(before.span))
    inside = _Pieces(*(np.where(missed, *pair) for pair in zip(none, inside, strict=True)))

    edge, turn = np.arange(gradient.shape[1]), 2 * np.pi
    lower, of_lower = _interleaved(before, inside, after), np.repeat(edge, 3)
    upper, of_upper = _interleaved(before_upper, after_upper).backwards(), np.repeat(edge, 2)[::-1]
    twice = [upper.turned(-turn), lower, upper, lower.turned(turn)]
    pieces = _Pieces(*(np.concatenate(columns, axis=1) for columns in zip(*twice, strict=True)))
    of_piece = np.concatenate([of_upper, of_lower] * 2)
    kept = np.flatnonzero((pieces.span > 0.0).any(axis=0))
    kept = kept if kept.size else np.zeros(1, dtype=np.int64)
    of_piece = of_piece[kept]
    low, high, span, sine, cosine, height = (columns[:, kept] for columns in pieces)
    return HeightIntegrals(low, high, span, sine, cosine, height, gradient[:, of_piece], of_piece, line)


def _interleaved(*parts: _Pieces) -> _Pieces:
    """Pieces of each edge beside each other."""
    return _Pieces(*(np.stack(columns, axis=-1).reshape(len(columns[0]), -1) for columns in zip(*parts, strict=True)))


def _continued(points: Floats, centre: Floats, radius: Floats) -> Floats:
    """Lines with a level edge at either end that leads beyond the circles, (n, V + 2, 2)."""
    points = np.broadcast_to(points, (len(radius), *points.shape[1:]))
    ends = points[:, [0, -1]].copy()
    ends[:, 0, 0] = np.minimum(centre[:, 0] - 2 * radius, ends[:, 0, 0] - 1.0)
    ends[:, 1, 0] = np.maximum(centre[:, 0] + 2 * radius, ends[:, 1, 0] + 1.0)
    return np.concatenate([ends[:, :1], points, ends[:, 1:]], axis=1)


def _gradient(run: Floats, rise: Floats) -> Floats:
    return np.divide(rise, run, out=np.zeros(run.shape), where=run > 0.0)


def _inside(parts: Cut) -> _Pieces:
    """Of the parts of edges inside circles, over the lower half.

    With g = 1 - rho^2 of a point, which does not cancel near the circle, the arc below it has cos = sqrt(y^2 + g), and
    the point's height above it is cos + y = g/(cos - y).
    """
    x_2, y_2 = parts.x + parts.e_x, parts.y + parts.e_y
    cosine, cosine_2 = np.sqrt(parts.y**2 + parts.first), np.sqrt(y_2**2 + parts.second)
    height = np.divide(parts.first, cosine - parts.y, out=cosine + parts.y, where=parts.y < 0.0)
    low, high = np.arctan2(parts.x, cosine), np.arctan2(x_2, cosine_2)
    return _Pieces(low, high, _span(parts.e_x, cosine, cosine_2), parts.x, cosine, height)


def _outside(start: Floats, gradient: Floats, first: Floats, last: Floats) -> tuple[_Pieces, _Pieces]:
    """Of parts of edges outside circles from one x to another, over the lower and over the upper half."""
    x, x_2 = np.clip(first, -1.0, 1.0), np.clip(last, -1.0, 1.0)
    y, y_2 = (start[..., 1] + gradient * (at - start[..., 0]) for at in (x, x_2))
    cosine, cosine_2 = (np.sqrt((1.0 - at) * (1.0 + at)) for at in (x, x_2))
    above = (x_2 > x) & (y + y_2 > 0.0)
    span = np.where(above, _span(x_2 - x, cosine, cosine_2), 0.0)
    low = np.arctan2(x, cosine)
    high = np.where(above, np.arctan2(x_2, cosine_2), low)
    lower = _Pieces(low, high, span, x, cosine, y + cosine)
    return lower, _Pieces(np.pi - high, np.pi - low, span, x_2, -cosine_2, y_2 - cosine_2)


def _span(run: Floats, cosine: Floats, cosine_2: Floats) -> Floats:
    """Angle from one point of the lower half to another: tan(span/2) = (sin_2 - sin_1)/(cos_1 + cos_2)."""
    return np.asarray(2 * np.arctan2(run, cosine + cosine_2))
