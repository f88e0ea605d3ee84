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
_COUNT = 14  # of the coefficients of a piece
_MIDDLES = np.arange(_COUNT) + 0.5
_NODES = np.cos(np.pi * _MIDDLES / _COUNT)
_ACCURACY = 1e-15
_SHORTEST = 1e-4  # width of a piece, rad
_DIRECTIONS = 4096  # at once, about
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
        Chebyshev coefficients of the integral within each piece, (pieces, circles, columns, integrals, terms).
    """

    edges: Floats
    before: Floats
    series: Floats

    def up_to(self, beta: Floats) -> Floats:
        """The integrals up to directions (M, circles) within the arcs, (integrals, columns, M, circles)."""
        directions, circles = beta.shape
        by_circle = beta.T
        together = 1 + _DIRECTIONS // (directions + 1)
        parts = [self._up_to(by_circle[some], some) for some in _blocks(circles, together)]
        integrals = np.concatenate(parts)
        return integrals.T

    def _up_to(self, beta: Floats, some: slice) -> Floats:
        """The same of directions in some circles, (circles, M, columns, integrals)."""
        pieces, circles, columns, integrals, terms = self.series.shape
        edges = self.edges[:, some, None]
        inside = np.clip(beta, edges[0], edges[-1])
        piece = np.zeros(beta.shape, dtype=np.intp)
        for edge in edges[1:-1]:
            piece += inside >= edge
        circle = np.arange(circles)[some, None]
        number = piece * circles + circle
        first = self.edges.take(number)
        last = self.edges.take(number + circles)
        width = last - first
        divisor = np.where(width != 0.0, width, 1.0)
        share = (inside - first) / divisor
        place = 2.0 * share - 1.0
        polynomials = np.ascontiguousarray(chebyshev.chebvander(place, terms - 1))
        every_piece = self.series.reshape(pieces * circles, columns * integrals, terms)
        within = np.einsum("...it,...t->...i", every_piece.take(number, axis=0), polynomials)
        before = self.before[piece, circle]
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


_Piece = tuple[Floats, Floats, Floats]  # a part of the arcs: its ends, (circles,), and the series of its integrals


def columns_of(steps: Floats, circles: int) -> tuple[Floats, Floats]:
    """What columns of a profile sum, (columns, surfaces, circles), and what they weigh, (columns, lanes).

    With steps of the unit weight below surfaces, (surfaces, lanes). Of one circle each column is a surface; of many,
    the first is the ground, and the second, if they weigh anything, all others.
    """
    alone = np.eye(len(steps))[..., None]
    if circles == 1:
        return alone, steps
    ground, *_ = alone
    others = steps / steps[0] - ground
    count = 2 if np.any(others) else 1
    both = np.broadcast_arrays(ground, others)
    weights = np.stack(both[:count])
    by_lane = np.tile(steps[0], (count, 1))
    return weights, by_lane


def profile_of(strips: Strips, weights: Floats) -> Profile:
    """The integrals along the arcs of masses in strips, with weights below surfaces, (columns, surfaces, circles).

    Surcharges are two further surfaces each: a pressure that falls from 1 to 0, and one that rises from 0 to 1, over R.
    """
    converged = _converged(strips, weights)
    pieces = sorted(converged, key=_order)
    firsts, lasts, by_piece = zip(*pieces, strict=True)
    edges = np.stack([*firsts, lasts[-1]])
    series = np.stack(by_piece)
    each = series.sum(axis=-1)  # at the right end every Chebyshev polynomial is 1
    nothing = np.zeros_like(each[:1])
    up_to_ends = np.cumsum(each, axis=0)
    before = np.concatenate([nothing, up_to_ends])
    return Profile(edges, before, series)


def _order(piece: _Piece) -> float:
    """By what pieces are put from left to right: twice the directions of their middles, of all circles."""
    first, last, _ = piece
    ends = first + last
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
        series, size, tail = _of_pieces(strips, weights, strip, first, last)
        scale = float(size.max(initial=scale))
        is_truncated = tail > _ACCURACY * scale
        is_long = last - first > _SHORTEST
        is_rough = is_truncated & is_long
        rough = np.logical_or.reduce(is_rough, axis=1)
        pieces = zip(first, last, series, strict=True)
        done += compress(pieces, ~rough)
        left = first[rough]
        right = last[rough]
        middle = (left + right) / 2
        first = np.concatenate([left, middle])
        last = np.concatenate([middle, right])
        strip = np.tile(strip[rough], 2)
    return done


def _of_pieces(
    strips: Strips, weights: Floats, strip: Integers, first: Floats, last: Floats
) -> tuple[Floats, Floats, Floats]:
    """Series of pieces in all circles, and sizes of their coefficients, (pieces, circles, ...)."""
    count, circles = first.shape
    every_circle = np.tile(np.arange(circles), count)
    every_strip = np.repeat(strip, circles)
    lefts = first.ravel()
    rights = last.ravel()
    columns = len(weights)
    integrals = len(MEASURED) + 1
    terms = _COUNT + 1
    series = np.empty((first.size, columns, integrals, terms))
    size = np.empty(first.size)
    tail = np.empty(first.size)
    for some in _blocks(first.size, _TOGETHER):
        series[some], size[some], tail[some] = _developed(
            strips, weights, strip=every_strip[some], circle=every_circle[some], first=lefts[some], last=rights[some]
        )
    by_circle = series.reshape(count, circles, columns, integrals, terms)
    shape = first.shape
    sizes = size.reshape(shape)
    tails = tail.reshape(shape)
    return by_circle, sizes, tails


def _developed(
    strips: Strips, weights: Floats, strip: Integers, circle: Integers, first: Floats, last: Floats
) -> tuple[Floats, Floats, Floats]:
    """Series of pieces, each of a circle, (pieces, columns, integrals, terms), and sizes of coefficients, (pieces,).

    The greatest is one of the first two; a tail is the last two terms.
    """
    width = last - first
    half = width / 2
    from_first = 1.0 + _NODES[:, None]
    nodes = first + half * from_first
    integrands = _integrands(strips, weights, strip, circle, nodes)
    values = half * integrands
    flat = values.reshape(_COUNT, -1)
    developed = _DEVELOPING @ flat
    by_term = developed.reshape(-1, *values.shape[1:])  # terms, integrals, columns, pieces
    series, sizes = np.split(by_term, [_COUNT + 1])
    absolute = np.abs(sizes)
    of_terms = absolute.max(axis=(1, 2))
    head = of_terms[:2].max(axis=0)
    tail = of_terms[2:].max(axis=0)
    return series.T, head, tail


def _integrands(strips: Strips, weights: Floats, strip: Integers, circle: Integers, beta: Floats) -> Floats:
    """What is integrated, at directions (nodes, pieces), in strips of circles: (nodes, integrals, columns, pieces)."""
    x = np.sin(beta)
    c = np.cos(beta)
    left = strips.x[circle, strip]
    beyond = x - left
    at_left = strips.y[:, circle, strip]
    slope = strips.slope[:, circle, strip]
    y = at_left[:, None] + slope[:, None] * beyond
    above = strips.above[:, circle, strip]
    weight = weights[:, :, circle] * above
    columns, _, pieces = weight.shape
    total = np.zeros((_COUNT, len(MEASURED) + 1, columns, pieces))
    counts = weight.any(axis=(0, 2))
    for k in np.flatnonzero(counts).tolist():
        if k < len(y):
            height = np.maximum(y[k] + c, 0.0)
            of_surface = _over_height(x, c, height)
        else:
            load, rises = divmod(k - len(y), 2)
            first, last = (end[circle, 0] for end in strips.loads[load])
            share = (x - first) / (last - first)
            pressure = share if rises else 1.0 - share
            of_surface = _of_pressure(x, y[0], pressure)
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
    rows = [-inward, x * log, polar / 2, h / c, h, h * mean_square, x * h, h * (h - 2.0 * c) / 2]
    return np.stack(rows, axis=1)


def _of_pressure(x: Floats, y: Floats, pressure: Floats) -> Floats:
    """The same of a pressure on the ground at (x, y), over x: times 1, rho, ... there."""
    square = x * x + y * y
    rho = np.sqrt(square)
    nothing = np.zeros_like(x)
    everywhere = np.ones_like(x)
    rows = [y / rho, x / rho, rho, nothing, everywhere, square, x, y]
    return np.stack(rows, axis=1) * pressure[:, None]
