"""What a mass weighs on its arc, direction by direction: integrals along the arc of the material straight above it.

The strip above a direction beta of the arc presses with A(beta) cos(phi) - B(beta) sin(phi) + P(beta) omega^2 once it
has turned by phi (`derive.algebra.slopes` proves it). With y its top over R from the centre, x = sin(beta),
c = cos(beta), rho^2 = x^2 + y^2, and dx = c dbeta, the integrals over y from the arc at -c to the top are

    of 1, rho, rho^2, x/rho, y/rho, x, y:  h,  (y rho + c + x^2 L)/2,  x^2 h + (y^3 + c^3)/3,  x L,  rho - 1,  x h,
    (y^2 - c^2)/2,  where h = y + c and L = ln((1 + c)/(rho - y)).

Written with h and 1 - rho^2 = h (2 c - h) nothing cancels in thin masses. They are smooth between the edges of strips;
there they are integrated as Chebyshev series, in pieces that are halved until the series have converged.
"""

from itertools import compress
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from slipcircle.base.kinds import Floats, Integers
from slipcircle.layers.strips import Strips

RADIAL_Y, RADIAL_X, POLAR, HEAD, AREA, INERTIA, MOMENT_X, MOMENT_Y = range(8)  # in order; the head is over beta, not x
MEASURED = [AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y]  # in the order of `circles.MEASURES`
PRESSING = 4  # the first of them, which strength takes
_CUMULATIVE = 5  # that are also known up to any direction
_COUNT = 14  # of the coefficients of a piece
_MIDDLES = np.arange(_COUNT) + 0.5
_NODES = np.cos(np.pi * _MIDDLES / _COUNT)
_ACCURACY = 1e-15
_SHORTEST = 1e-4  # width of a piece, rad
_DIRECTIONS = 2048  # at once
_TOGETHER = 120  # pieces
_AT_NODES = chebyshev.chebvander(_NODES, _COUNT - 1)  # values of the polynomials
_TO_CHEBYSHEV = np.linalg.inv(_AT_NODES)
_INTEGRAL = chebyshev.chebint(np.eye(_COUNT), lbnd=-1.0) @ _TO_CHEBYSHEV  # from the left end of a piece
# From values at the nodes to the coefficients of the integral, then to their own first two and last two.
_DEVELOPING = np.concatenate([_INTEGRAL, _TO_CHEBYSHEV[:2], _TO_CHEBYSHEV[-2:]])


class Profile(NamedTuple):
    """Integrals along arcs from their left ends, in pieces.

    Attributes
    ----------
    edges : ndarray
        Directions at which pieces begin, and the right end, (pieces + 1, circles).
    before : ndarray
        The integrals up to there, (pieces + 1, circles, columns, integrals).
    series : ndarray
        Chebyshev coefficients of the first integrals within each piece, (pieces, circles, columns, integrals, terms).
    """

    edges: Floats
    before: Floats
    series: Floats

    def up_to(self, beta: Floats) -> Floats:
        """The first integrals up to directions (M, circles) within the arcs, (integrals, columns, M, circles)."""
        directions, circles = beta.shape
        by_circle = beta.T.ravel()
        circle = np.repeat(np.arange(circles), directions)
        parts = [self._up_to(by_circle[some], circle[some]) for some in _blocks(beta.size, _DIRECTIONS)]
        integrals = np.concatenate(parts)
        return integrals.reshape(circles, directions, *integrals.shape[1:]).T

    def _up_to(self, beta: Floats, circle: Integers) -> Floats:
        """The same of directions each in a circle, (M, columns, integrals)."""
        pieces, circles, columns, integrals, terms = self.series.shape
        edges = self.edges[:, circle]
        inside = np.clip(beta, edges[0], edges[-1])
        piece = np.sum(inside >= edges[1:-1], axis=0, dtype=np.int16)
        first = self.edges[piece, circle]
        width = self.edges[piece + 1, circle] - first
        divisor = np.where(width != 0.0, width, 1.0)
        share = (inside - first) / divisor
        polynomials = _chebyshev(2.0 * share - 1.0, terms)
        every_piece = self.series.reshape(pieces * circles, columns * integrals, terms)
        of_pieces = every_piece.take(piece * circles + circle, axis=0)
        within = np.einsum("nit,nt->ni", of_pieces, polynomials)
        before = self.before[piece, circle, :, :integrals]
        return before + within.reshape(before.shape)

    @property
    def whole(self) -> Floats:
        """The integrals over the whole arcs, (integrals, columns, circles)."""
        whole: Floats = self.before[-1].T
        return whole

    def combined(self, weights: Floats) -> "Profile":
        """What presses, of one column that stands for all: their sum with weights, (columns, circles)."""
        before = np.einsum("kcsi,sc->kci", self.before[..., :PRESSING], weights)
        series = np.einsum("kcsit,sc->kcit", self.series[..., :PRESSING, :], weights)
        return Profile(self.edges, before[:, :, None], series[:, :, None])


def _blocks(count: int, together: int) -> list[slice]:
    """One or more parts of so many, small enough that their numbers stay in the processor's cache."""
    return [slice(first, first + together) for first in range(0, max(count, 1), together)]


def _chebyshev(place: Floats, terms: int) -> Floats:
    """Values of the first Chebyshev polynomials at places in [-1, 1], (places, terms)."""
    values = np.empty((terms, place.size))
    values[0] = 1.0
    values[1] = place
    twice = 2.0 * place
    for k in range(2, terms):
        values[k] = twice * values[k - 1] - values[k - 2]
    return np.ascontiguousarray(values.T)


class _Piece(NamedTuple):
    """A part of the arcs: its ends, (circles,), the series of its integrals, and they themselves."""

    first: Floats
    last: Floats
    series: Floats
    whole: Floats


def profile_of(strips: Strips, weights: Floats) -> Profile:
    """The integrals along the arcs of masses in strips.

    Surcharges are two further surfaces each: a pressure that falls from 1 to 0, and one that rises from 0 to 1, over R.
    Of weights below surfaces, (columns, surfaces, circles), those of a column are summed.
    """
    pieces = sorted(_converged(strips, weights), key=_order)
    firsts = [piece.first for piece in pieces]
    edges = np.stack([*firsts, pieces[-1].last])
    series = np.stack([piece.series for piece in pieces])
    each = [piece.whole for piece in pieces]
    before = np.stack([np.zeros_like(each[0]), *each])
    return Profile(edges, np.cumsum(before, axis=0), series)


def _order(piece: _Piece) -> float:
    """By what pieces are put from left to right: twice the directions of their middles, of all circles."""
    ends = piece.first + piece.last
    return float(ends.sum())


def _converged(strips: Strips, weights: Floats) -> list[_Piece]:
    """Pieces in which the series have converged: strips, or parts of them."""
    beta = strips.beta.T
    first = beta[:-1]
    last = beta[1:]
    strip = np.arange(len(first))
    done = list[_Piece]()
    scale = 0.0
    while len(strip):
        at = np.broadcast_arrays(strip[:, None], np.arange(first.shape[1]), first, last)
        rows = [values.ravel() for values in at]
        parts = [_developed(strips, weights, *(row[some] for row in rows)) for some in _blocks(first.size, _TOGETHER)]
        developed = map(np.concatenate, zip(*parts, strict=True))
        series, whole, size, tail = (values.reshape(*first.shape, *values.shape[1:]) for values in developed)
        scale = float(size.max(initial=scale))
        is_truncated = tail > _ACCURACY * scale
        is_long = last - first > _SHORTEST
        is_rough = is_truncated & is_long
        rough = is_rough.any(axis=1)
        pieces = map(_Piece, first, last, series, whole)
        done += compress(pieces, ~rough)
        left = first[rough]
        right = last[rough]
        middle = (left + right) / 2
        first = np.concatenate([left, middle])
        last = np.concatenate([middle, right])
        strip = np.tile(strip[rough], 2)
    return done


def _developed(
    strips: Strips, weights: Floats, strip: Integers, circle: Integers, first: Floats, last: Floats
) -> tuple[Floats, Floats, Floats, Floats]:
    """Of pieces, each of a circle, the series and the integrals, (pieces, ...), and sizes of coefficients, (pieces,).

    The greatest is one of the first two; a tail is the last two terms.
    """
    half = (last - first) / 2
    from_first = 1.0 + _NODES[:, None]
    values = half * _integrands(strips, weights, strip, circle, first + half * from_first)
    flat = values.reshape(_COUNT, -1)
    developed = _DEVELOPING @ flat
    by_term = developed.reshape(-1, *values.shape[1:])  # terms, integrals, columns, pieces
    series, sizes = np.split(by_term, [_COUNT + 1])
    whole = series.sum(axis=0)  # at the right end every Chebyshev polynomial is 1
    of_terms = np.abs(sizes).max(axis=(1, 2))
    head, tail = of_terms.reshape(2, 2, -1).max(axis=1)
    in_order = np.ascontiguousarray(series[:, :_CUMULATIVE].T)
    return in_order, whole.T, head, tail


def _integrands(strips: Strips, weights: Floats, strip: Integers, circle: Integers, beta: Floats) -> Floats:
    """What is integrated, at directions (nodes, pieces), in strips of circles: (nodes, integrals, columns, pieces)."""
    x = np.sin(beta)
    c = np.cos(beta)
    beyond = x - strips.x[circle, strip]
    y = strips.y[:, circle, strip][:, None] + strips.slope[:, circle, strip][:, None] * beyond
    weight = weights[:, :, circle] * strips.above[:, circle, strip]
    total = np.zeros((len(x), len(MEASURED) + 1, *weight[:, 0].shape))
    for k in np.flatnonzero(weight.any(axis=(0, 2))):
        if k < len(y):
            of_surface = _over_height(x, c, np.maximum(y[k] + c, 0.0))
        else:
            load, end = divmod(k - len(y), 2)
            first, last = (edge[circle, 0] for edge in strips.loads[load])
            share = (x - first) / (last - first)
            of_surface = _of_pressure(x, y[0], share if end else 1.0 - share)
        total += of_surface[:, :, None] * weight[:, k]
    total *= c[:, None, None]
    return total


def _over_height(x: Floats, c: Floats, h: Floats) -> Floats:
    """The integrals over y from the arc to a height h above it, (nodes, integrals, ...); the head, by beta, over c."""
    gap = h * (2.0 * c - h)  # 1 - rho^2
    rho = np.sqrt(1.0 - gap)
    inward = gap / (1.0 + rho)  # 1 - rho
    to_top = rho + c - h
    ratio = (inward + h) / to_top
    log = np.log1p(ratio)
    square = x * x
    of_log = square * log
    polar = h * rho + c * inward + of_log
    of_heights = h * h - 3.0 * c * h
    on_arc = c * c
    mean_square = square + of_heights / 3 + on_arc
    moment_y = h * (h - 2.0 * c) / 2
    rows = [-inward, x * log, polar / 2, h / c, h, h * mean_square, x * h, moment_y]
    return np.stack(rows, axis=1)


def _of_pressure(x: Floats, y: Floats, pressure: Floats) -> Floats:
    """The same of a pressure on the ground at (x, y), over x: times 1, rho, ... there."""
    square = x * x + y * y
    rho = np.sqrt(square)
    rows = [y / rho, x / rho, rho, np.zeros_like(x), np.ones_like(x), square, x, y]
    return np.stack(rows, axis=1) * pressure[:, None]
