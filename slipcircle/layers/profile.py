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

from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.layers.strips import Strips

AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y, HEAD = range(8)  # rows; the head is over beta, not x
PRESSING = [RADIAL_Y, RADIAL_X, POLAR, HEAD]  # those that strength takes
_COUNT = 14  # of the coefficients of a piece
_MIDDLES = np.arange(_COUNT) + 0.5
_NODES = np.cos(np.pi * _MIDDLES / _COUNT)
_ACCURACY = 1e-15
_SHORTEST = 1e-4  # width of a piece, rad
_BLOCK = 2048  # directions at once, so that their numbers stay in the cache
_ROWS = 256  # of surfaces


_AT_NODES = chebyshev.chebvander(_NODES, _COUNT - 1)  # values of the polynomials
_TO_CHEBYSHEV = np.linalg.inv(_AT_NODES)
_INTEGRAL = chebyshev.chebint(np.eye(_COUNT), lbnd=-1.0) @ _TO_CHEBYSHEV  # from the left end
# From values at the nodes to the coefficients of the integral, then to the first two of their own, and the last two.
_DEVELOPING = np.concatenate([_INTEGRAL, _TO_CHEBYSHEV[:2], _TO_CHEBYSHEV[-2:]]).T


class Profile(NamedTuple):
    """Integrals along arcs from their left ends, in pieces.

    Attributes
    ----------
    edges : ndarray
        Directions at which pieces begin, and the right end, (pieces + 1, circles).
    before : ndarray
        Some integrals up to there, (pieces + 1, circles, surfaces or 1, integrals).
    series : ndarray
        Chebyshev coefficients of these integrals within each piece, (pieces, circles, surfaces or 1, integrals, terms).
    moments : ndarray
        All integrals over the whole arcs, (integrals, surfaces, circles).
    """

    edges: Floats
    before: Floats
    series: Floats
    moments: Floats

    def up_to(self, beta: Floats) -> Floats:
        """The integrals up to directions (M, circles) within the arcs, (integrals, surfaces or 1, M, circles)."""
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
        """The same integrals over the whole arcs, (integrals, surfaces or 1, circles)."""
        whole: Floats = self.before[-1].T
        return whole

    def combined(self, steps: Floats) -> "Profile":
        """Of one surface that stands for all: their sum with steps of the unit weight, (surfaces, circles)."""
        before = np.einsum("kcsi,sc->kci", self.before, steps)
        series = np.einsum("kcsit,sc->kcit", self.series, steps)
        return self._replace(before=before[:, :, None], series=series[:, :, None])


def _chebyshev(place: Floats, terms: int) -> Floats:
    """Values of the first Chebyshev polynomials at places in [-1, 1], (places, terms)."""
    values = np.empty((terms, place.size))
    values[0] = 1.0
    values[1] = place
    twice = 2.0 * place
    for k in range(2, terms):
        values[k] = twice * values[k - 1] - values[k - 2]
    return np.ascontiguousarray(values.T)


class _Pieces(NamedTuple):
    """Parts of the arcs: their strips, (pieces,), and their ends, (pieces, circles)."""

    strip: Integers
    first: Floats
    last: Floats

    def of(self, which: Any) -> "_Pieces":
        """Some of them."""
        return _Pieces(self.strip[which], self.first[which], self.last[which])

    @property
    def halves(self) -> "_Pieces":
        """Both halves of each."""
        middle = (self.first + self.last) / 2
        first = np.concatenate([self.first, middle])
        last = np.concatenate([middle, self.last])
        return _Pieces(np.tile(self.strip, 2), first, last)


def profile_of(strips: Strips, steps: Floats | None, rows: Sequence[int] = PRESSING) -> Profile:
    """The integrals along the arcs of masses in strips, of a unit weight below each surface.

    Surcharges are two further surfaces each: a pressure that falls from 1 to 0, and one that rises from 0 to 1, over R.
    With steps of the unit weight, (surfaces, circles), one surface stands for all: their sum.
    ``rows`` are the integrals that are known up to any direction.
    """
    first, last, series, moments = _converged(strips, steps, rows)
    order = np.argsort((first + last).sum(axis=1), kind="stable")
    edges = np.concatenate([first[order], last[order[-1:]]])
    series = series[order]
    before = np.zeros((len(edges), *series.shape[1:-1]))
    np.cumsum(series.sum(axis=-1), axis=0, out=before[1:])  # at the right end every Chebyshev polynomial is 1
    return Profile(edges, before, series, moments)


def _converged(strips: Strips, steps: Floats | None, rows: Sequence[int]) -> tuple[Floats, Floats, Floats, Floats]:
    """Pieces in which the series have converged, strips or parts of them: their ends, the series, and all moments."""
    beta = strips.beta.T
    pieces = _Pieces(np.arange(len(beta) - 1), beta[:-1], beta[1:])
    done = []
    scale = 0.0
    while len(pieces.strip):
        developed = _developed(strips, steps, rows, pieces)
        scale = max(scale, developed.greatest)
        is_truncated = developed.tails > _ACCURACY * scale
        is_long = pieces.last - pieces.first > _SHORTEST
        rough = is_truncated.any(axis=1) & is_long.any(axis=1)
        smooth = pieces.of(~rough)
        moments = developed.moments[~rough].sum(axis=0).T
        done.append((smooth.first, smooth.last, developed.series[~rough], moments[None]))
        pieces = pieces.of(rough).halves
    first, last, series, every = (np.concatenate(parts) for parts in zip(*done, strict=True))
    return first, last, series, every.sum(axis=0)


class _Developed(NamedTuple):
    """Pieces as series of some integrals, all integrals, (pieces, circles, surfaces, integrals), and two sizes.

    The greatest Chebyshev coefficient is one of the first two; tails, (pieces, circles), are the last two.
    """

    series: Floats
    moments: Floats
    greatest: float
    tails: Floats


def _developed(strips: Strips, steps: Floats | None, rows: Sequence[int], pieces: _Pieces) -> _Developed:
    """Pieces as series; what lies nowhere above the arc in a piece is left out."""
    above = strips.above[:, :, pieces.strip].transpose(0, 2, 1)
    under = _under_loads(strips)[:, pieces.strip]
    surfaces, *shape = above.shape
    count = surfaces + len(under)
    series = np.zeros((*shape, count if steps is None else 1, len(rows), _COUNT + 1))
    moments = np.zeros((*shape, count, HEAD + 1))
    tails = np.zeros(shape)
    greatest = 0.0
    for surface, present in enumerate((*above, *under)):
        integrands = _over_height if surface < surfaces else _of_load
        places = np.nonzero(present)
        for begin in range(0, places[0].size, _ROWS):
            piece, circle = (each[begin : begin + _ROWS] for each in places)
            left = pieces.first[piece, circle]
            half = (pieces.last[piece, circle] - left)[:, None] / 2
            beta = left[:, None] + half * (1.0 + _NODES)
            cosine = np.cos(beta)
            row = np.full_like(piece, surface if surface < surfaces else surface - surfaces)
            values = integrands(strips, (row, circle, pieces.strip[piece]), np.sin(beta), cosine)
            values *= (half * cosine)[:, None]
            coefficients = (values.reshape(-1, _COUNT) @ _DEVELOPING).reshape(len(piece), HEAD + 1, -1)
            of_integral = coefficients[..., : _COUNT + 1]
            moments[piece, circle, surface] = of_integral.sum(axis=-1)
            if steps is None:
                series[piece, circle, surface] = of_integral[:, rows]
            else:
                series[piece, circle, 0] += steps[surface, circle][:, None, None] * of_integral[:, rows]
            size = np.abs(coefficients[..., _COUNT + 1 :])
            greatest = max(greatest, float(size[..., :2].max()))
            tail = size[..., 2:].max(axis=(1, 2))
            tails[piece, circle] = np.maximum(tail, tails[piece, circle])
    return _Developed(series, moments, greatest, tails)


Row = tuple[Integers, Integers, Integers]  # surfaces or ends of surcharges, circles, strips


def _heights(strips: Strips, at: Row, x: Floats) -> Floats:
    """y of surfaces at x, (rows, nodes)."""
    _, circle, strip = at
    beyond = x - strips.x[circle, strip][:, None]
    heights: Floats = strips.y[at][:, None] + strips.slope[at][:, None] * beyond
    return heights


def _over_height(strips: Strips, at: Row, x: Floats, c: Floats) -> Floats:
    """Integrals over y from the arc up to a surface, over x, (rows, integrals, nodes); the last one by beta, over c."""
    h = np.maximum(_heights(strips, at, x) + c, 0.0)
    gap = h * (2.0 * c - h)  # 1 - rho^2
    rho = np.sqrt(1.0 - gap)
    inward = gap / (1.0 + rho)  # 1 - rho
    log = np.log1p((inward + h) / (rho + c - h))
    square = x * x
    rows = np.empty((len(x), HEAD + 1, x.shape[1]))
    rows[:, AREA] = h
    rows[:, POLAR] = (h * rho + c * inward + square * log) / 2
    rows[:, INERTIA] = h * (square + (h * h - 3.0 * c * h) / 3 + c * c)
    rows[:, RADIAL_X] = x * log
    rows[:, RADIAL_Y] = -inward
    rows[:, MOMENT_X] = x * h
    rows[:, MOMENT_Y] = h * (h - 2.0 * c) / 2
    rows[:, HEAD] = h / c
    return rows


def _under_loads(strips: Strips) -> Flags:
    """Whether strips lie under surcharges, twice each, (ends of surcharges, strips, circles)."""
    x = strips.x.T
    middle = (x[:-1] + x[1:]) / 2
    under = [(middle > first[:, 0]) & (middle < last[:, 0]) for first, last in strips.loads for _ in range(2)]
    return np.array(under, dtype=bool).reshape(-1, *middle.shape)


def _of_load(strips: Strips, at: Row, x: Floats, c: Floats) -> Floats:
    """The same of pressures on the ground, times 1, rho, ... there: they fall from 1 to 0, or rise."""
    end, circle, strip = at
    y = _heights(strips, (np.zeros_like(end), circle, strip), x)
    ends = np.array(strips.loads)[end // 2, :, circle]
    first, last = ends[:, 0], ends[:, 1]
    share = (x - first) / (last - first)
    pressure = np.where(end[:, None] % 2 == 0, 1.0 - share, share)
    square = x * x + y * y
    rho = np.sqrt(square)
    integrands = {
        AREA: np.ones_like(x),
        POLAR: rho,
        INERTIA: square,
        RADIAL_X: x / rho,
        RADIAL_Y: y / rho,
        MOMENT_X: x,
        MOMENT_Y: y,
        HEAD: np.zeros_like(x),
    }
    rows: Floats = np.stack([integrands[k] for k in sorted(integrands)], axis=1) * pressure[:, None]
    return rows
