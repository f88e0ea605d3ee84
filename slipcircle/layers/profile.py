"""What a mass weighs on its arc, direction by direction: integrals along the arc of the material straight above it.

The strip above a direction beta of the arc presses with A(beta) cos(phi) - B(beta) sin(phi) + P(beta) omega^2 once it
has turned by phi (`derive.algebra.slopes` proves it). With y its top over R from the centre, x = sin(beta),
c = cos(beta), rho^2 = x^2 + y^2, and dx = c dbeta, the integrals over y from the arc at -c to the top are

    of 1, rho, rho^2, x/rho, y/rho, x, y:  h,  (y rho + c + x^2 L)/2,  x^2 h + (y^3 + c^3)/3,  x L,  rho - 1,  x h,
    (y^2 - c^2)/2,  where h = y + c and L = ln((1 + c)/(rho - y)).

Written with h and 1 - rho^2 = h (2 c - h) nothing cancels in thin masses. They are smooth between the edges of strips;
there they are integrated as Chebyshev series, in pieces that are halved until the series have converged.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from slipcircle.base.kinds import Floats, Integers
from slipcircle.layers.strips import Strips

AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y, HEAD = range(8)  # rows; the head is over beta, not x
_COUNT = 14  # of the coefficients of a piece
_MIDDLES = np.arange(_COUNT) + 0.5
_NODES = np.cos(np.pi * _MIDDLES / _COUNT)
_ACCURACY = 1e-15
_SHORTEST = 1e-4  # width of a piece, rad
_BLOCK = 2048  # directions


def _integrating() -> Floats:
    """From values at the nodes to the coefficients of the integral from the left end, (`_COUNT` + 1, `_COUNT`)."""
    integral = chebyshev.chebint(np.eye(_COUNT), lbnd=-1.0)
    from_values: Floats = integral @ _TO_CHEBYSHEV
    return from_values


_AT_NODES = chebyshev.chebvander(_NODES, _COUNT - 1)  # values of the polynomials
_TO_CHEBYSHEV = np.linalg.inv(_AT_NODES)
_TO_ENDS = _TO_CHEBYSHEV[[0, 1, -2, -1]]
_INTEGRAL = _integrating()


class Profile(NamedTuple):
    """Integrals along arcs from their left ends, in pieces.

    Attributes
    ----------
    edges : ndarray
        Directions at which pieces begin, and the right end, (pieces + 1, circles).
    before : ndarray
        The integrals up to there, (pieces + 1, circles, surfaces, integrals).
    series : ndarray
        Chebyshev coefficients of the integral within each piece, (pieces, circles, surfaces, integrals, terms).
    """

    edges: Floats
    before: Floats
    series: Floats

    def up_to(self, beta: Floats) -> Floats:
        """The integrals up to directions (M, circles) within the arcs, (integrals, surfaces, M, circles)."""
        first_edge, *inner_edges, last_edge = self.edges
        series = self.series
        inside = np.clip(beta, first_edge, last_edge)
        piece = np.zeros(inside.shape, dtype=np.intp)
        for edge in inner_edges:
            piece += inside >= edge
        circle = np.arange(inside.shape[1])
        first = self.edges[piece, circle]
        last = self.edges[piece + 1, circle]
        width = last - first
        divisor = np.where(width != 0.0, width, 1.0)
        share = (inside - first) / divisor
        place = 2.0 * share - 1.0

        # The coefficients of each direction are gathered, contiguous, in blocks that a processor's cache holds.
        pieces, circles, surfaces, integrals, terms = series.shape
        rows = series.reshape(pieces * circles, -1, terms)
        up_to_piece = self.before[:pieces].reshape(pieces * circles, -1)
        row = piece * circles + circle
        row = row.ravel()
        place = place.ravel()
        total = up_to_piece[row]
        for begin in range(0, row.size, _BLOCK):
            block = slice(begin, begin + _BLOCK)
            polynomials = _chebyshev(place[block], terms)
            of_pieces = rows.take(row[block], axis=0)
            total[block] += np.einsum("nit,nt->ni", of_pieces, polynomials)
        by_direction = total.reshape(*inside.shape, surfaces, integrals)
        return by_direction.transpose(3, 2, 0, 1)

    @property
    def whole(self) -> Floats:
        """The integrals over the whole arcs, (integrals, surfaces, circles)."""
        whole: Floats = self.before[-1].T
        return whole

    def of(self, rows: Sequence[int]) -> "Profile":
        """Some of the integrals."""
        before = self.before[..., rows]
        series = self.series[..., rows, :]
        return Profile(self.edges, before, series)

    def combined(self, steps: Floats) -> "Profile":
        """Of one surface that stands for all: their sum with steps of the unit weight, (surfaces, circles)."""
        before = np.einsum("kcsi,sc->kci", self.before, steps)
        series = np.einsum("kcsit,sc->kcit", self.series, steps)
        return Profile(self.edges, before[:, :, None], series[:, :, None])


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
    """A part of the arcs: its ends, (circles,), and the series of its integrals."""

    first: Floats
    last: Floats
    series: Floats


def profile_of(strips: Strips) -> Profile:
    """The integrals along the arcs of masses in strips, of a unit weight below each surface.

    Surcharges are two further surfaces each: a pressure that falls from 1 to 0, and one that rises from 0 to 1, over R.
    """
    pieces = _converged(strips)
    pieces.sort(key=_order)
    firsts = [piece.first for piece in pieces]
    right_end = pieces[-1].last
    edges = np.stack([*firsts, right_end])
    series = np.stack([piece.series for piece in pieces])
    each = series.sum(axis=-1)  # at the right end every Chebyshev polynomial is 1
    nothing = np.zeros_like(each[:1])
    up_to_ends = np.cumsum(each, axis=0)
    before = np.concatenate([nothing, up_to_ends])
    return Profile(edges, before, series)


def _order(piece: _Piece) -> float:
    """By what pieces are put from left to right: twice the directions of their middles, of all circles."""
    ends = piece.first + piece.last
    return float(ends.sum())


def _converged(strips: Strips) -> list[_Piece]:
    """Pieces in which the series have converged: strips, or parts of them."""
    beta = strips.beta.T
    first = beta[:-1]
    last = beta[1:]
    strip = np.arange(len(first))
    done = list[_Piece]()
    scale = 0.0
    while len(strip):
        width = last - first
        half = width / 2
        from_first = 1.0 + _NODES[:, None, None]
        nodes = first + half * from_first
        values = half * _integrands(strips, strip, nodes)
        coefficients, tail = _sizes(values)
        scale = max(scale, coefficients)
        is_truncated = tail > _ACCURACY * scale
        is_long = width > _SHORTEST
        is_rough = is_truncated & is_long
        rough = is_rough.any(axis=1)
        smooth = ~rough

        smooth_values = values[..., smooth, :]
        series = np.tensordot(_INTEGRAL, smooth_values, (1, 2))
        by_piece = series.transpose(3, 4, 2, 1, 0)
        done += map(_Piece, first[smooth], last[smooth], by_piece)
        left = first[rough]
        right = last[rough]
        middle = (left + right) / 2
        first = np.concatenate([left, middle])
        last = np.concatenate([middle, right])
        strip = np.tile(strip[rough], 2)
    return done


def _sizes(values: Floats) -> tuple[float, Floats]:
    """Sizes of the Chebyshev coefficients of values at nodes: the greatest one, and those of the tails.

    The greatest is one of the first two; a tail is the last two terms of a piece in a circle, (pieces, circles).
    """
    coefficients = np.tensordot(_TO_ENDS, values, (1, 2))  # terms, integrals, surfaces, pieces, circles
    size = np.abs(coefficients)
    greatest = size[:2].max(initial=0.0)
    last_terms = size[-2:]
    return float(greatest), last_terms.max(axis=(0, 1, 2))


def _integrands(strips: Strips, strip: Integers, beta: Floats) -> Floats:
    """What is integrated, at directions (nodes, pieces, circles) in strips: (integrals, surfaces, nodes, ...)."""
    x = np.sin(beta)
    c = np.cos(beta)
    edges = strips.x.T
    left = edges[strip]
    beyond = x - left
    at_left = _by_strip(strips.y, strip)
    slope = _by_strip(strips.slope, strip)
    y = at_left + slope * beyond
    height = y + c
    has_height = height > 0.0
    is_above = has_height & _by_strip(strips.above, strip)
    height = np.where(is_above, height, 0.0)
    columns = _over_height(x, c, height)
    if strips.loads:
        right = edges[strip + 1]
        middle = (left + right) / 2
        on_ground, *_ = y
        of_loads = _of_loads(strips, x, on_ground, middle)
        columns = np.concatenate([columns, of_loads], axis=1)
    by_angle: Floats = columns * c
    return by_angle


def _over_height(x: Floats, c: Floats, h: Floats) -> Floats:
    """The integrals over y from the arc up to a height h above it; the last one, by beta, over c."""
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
    rows = {
        AREA: h,
        POLAR: polar / 2,
        INERTIA: h * mean_square,
        RADIAL_X: x * log,
        RADIAL_Y: -inward,
        MOMENT_X: x * h,
        MOMENT_Y: h * (h - 2.0 * c) / 2,
        HEAD: h / c,
    }
    in_order = [rows[k] for k in sorted(rows)]
    return np.stack(in_order)


def _by_strip(values: Any, strip: Integers) -> Any:
    """Of (surfaces, circles, strips) those of some strips, (surfaces, 1, pieces, circles)."""
    chosen = values[:, :, strip].transpose(0, 2, 1)
    return chosen[:, None]


def _of_loads(strips: Strips, x: Floats, y: Floats, middle: Floats) -> Floats:
    """The same of unit pressures on the ground at (x, y), over x: pressures times 1, rho, ... there."""
    pressures = []
    for load in strips.loads:
        first, last = (end[:, 0] for end in load)
        width = last - first
        share = (x - first) / width
        rest = 1.0 - share
        under = (middle > first) & (middle < last)
        falling = np.where(under, rest, 0.0)
        rising = np.where(under, share, 0.0)
        pressures += [falling, rising]
    every_pressure = np.stack(pressures)
    square = x * x + y * y
    rho = np.sqrt(square)
    integrands = {
        AREA: 1.0,
        POLAR: rho,
        INERTIA: rho * rho,
        RADIAL_X: x / rho,
        RADIAL_Y: y / rho,
        MOMENT_X: x,
        MOMENT_Y: y,
        HEAD: 0.0,
    }
    by_row = [integrands[k] * every_pressure for k in sorted(integrands)]
    return np.stack(by_row)
