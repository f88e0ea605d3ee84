"""Parts of a ground inside circles, as pieces of the arcs below them, and the integrals of its height over them.

Lengths are divided by R, and the origin is the centre. Angles are measured from straight below the centre in rad, so
that a point of the arc is (sin, -cos).
"""

from typing import Any, NamedTuple

import numpy as np

from generated import slopes
from slipcircle.base.kinds import Floats
from slipcircle.ground.circles import Cut
from slipcircle.ground.plane import Vectors


class GroundPieces(NamedTuple):
    """Pieces of circles over which one edge of a line lies above the arc, one column per edge, (n, pieces)."""

    low: Floats  # angles of a piece's ends
    high: Floats
    span: Floats  # high - low to full precision; 0 where there is no such piece
    sine: Floats  # at the low end
    cosine: Floats
    height: Floats
    slope: Floats  # dy/dx of the edge

    @property
    def used(self) -> "GroundPieces":
        """Return the pieces of edges that have a piece over some circle."""
        has_width = self.span > 0.0
        return self.only(has_width.any(axis=0))

    def only(self, pieces: Any) -> "GroundPieces":
        """Return the pieces with these indices, or where a mask is true."""
        return GroundPieces._make(column[:, pieces] for column in self)

    def turned(self, angle: float) -> "GroundPieces":
        """Return the pieces turned by an angle in rad, a number of whole turns. Sines and cosines are not changed."""
        low = self.low + angle
        high = self.high + angle
        return self._replace(low=low, high=high)


def integral_inside(parts: Cut) -> Floats:
    """Return integrals of the height above the arc over its angle, (n, E), for arcs that do not overhang.

    Each of the n by E ``parts`` is the part of an edge inside a circle; lengths are over R.
    """
    slope = edge_slopes(parts.part)
    _, _, *of_pieces = pieces_inside(parts, slope)
    return slopes.head(*of_pieces)


def edge_slopes(edge: Vectors) -> Floats:
    """Return the slopes dy/dx of edges, 0 for vertical scarps."""
    of_scarps = np.zeros_like(edge.x)
    has_run = edge.x > 0.0
    return np.divide(edge.y, edge.x, out=of_scarps, where=has_run)


def pieces_inside(parts: Cut, slope: Floats) -> GroundPieces:
    """Return pieces over the lower half of the circle for the parts of edges inside circles, (n, E).

    ``slope`` is dy/dx of the edges.

    With g = 1 - rho^2, known without cancellation near the circle, the arc below a point has cos = sqrt(y^2 + g), and
    the height of the point above it is cos + y = g/(cos - y).
    """
    x, y = parts.start
    end = parts.start + parts.part
    cosine_squared = y**2 + parts.first
    cosine = np.sqrt(cosine_squared)
    end_cosine_squared = end.y**2 + parts.second
    end_cosine = np.sqrt(end_cosine_squared)
    difference = cosine - y
    total = cosine + y
    is_lower = y < 0.0
    height = np.divide(parts.first, difference, out=total, where=is_lower)
    low = np.arctan2(x, cosine)
    high = np.arctan2(end.x, end_cosine)
    span = span_of(parts.part.x, cosine, end_cosine)
    return GroundPieces(low, high, span, x, cosine, height, slope)


def span_of(run: Floats, cosine: Floats, end_cosine: Floats) -> Floats:
    """Return the angle between two points of the lower half in rad: tan(span/2) = (sin_2 - sin_1)/(cos_1 + cos_2).

    ``run`` is the difference of the sines, and ``cosine`` and ``end_cosine`` are the cosines at the two points.
    """
    half_span = np.arctan2(run, cosine + end_cosine)
    return 2 * half_span
