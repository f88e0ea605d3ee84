"""Weight of a mass on its arc as a function of direction: integrals along the arc of the material vertically above it.

After a rotation phi the strip above a direction beta of the arc has the normal force A(beta) cos(phi) - B(beta)
sin(phi) + P(beta) omega^2 (proved in `derive.algebra.slopes`). Let y be its top over R relative to the centre, x =
sin(beta), c = cos(beta), rho^2 = x^2 + y^2, and dx = c dbeta. The integrals over y from the arc at -c to the top are

    of 1, rho, rho^2, x/rho, y/rho, x, y:  h,  (y rho + c + x^2 L)/2,  x^2 h + (y^3 + c^3)/3,  x L,  rho - 1,  x h,
    (y^2 - c^2)/2,  where h = y + c and L = ln((1 + c)/(rho - y)).

In terms of h and 1 - rho^2 = h (2 c - h) nothing cancels in thin masses. The integrands are smooth between the edges of
strips, where they are integrated as Chebyshev series, in pieces that are halved until the series have converged.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import compress
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from slipcircle.base.kinds import ArrayPair, ArrayTriple, Floats, Integers
from slipcircle.layers.strips import Strips
from slipcircle.tables.interpolation import converged_pieces

RADIAL_Y, RADIAL_X, POLAR, HEAD, AREA, INERTIA, MOMENT_X, MOMENT_Y = range(8)  # in order; the head is over beta, not x
MEASURED = [AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y]  # in the order of `circles.MEASURES`
_INTEGRALS = len(MEASURED) + 1
PRESSING = 4  # number of the first integrals, which strength uses
_COUNT = 14  # coefficients of a piece
_MIDDLES = np.arange(_COUNT) + 0.5
_NODES = np.cos(np.pi * _MIDDLES / _COUNT)
_FROM_FIRST = 1.0 + _NODES[:, None, None]  # distance from the left end over half the width of a piece
_ACCURACY = 1e-15
_SHORTEST = 1e-4  # width of a piece, rad
_CIRCLES = 200  # circles of a part
_AT_NODES = chebyshev.chebvander(_NODES, _COUNT - 1)  # values of the polynomials
_TO_CHEBYSHEV = np.linalg.inv(_AT_NODES)
_INTEGRAL = chebyshev.chebint(np.eye(_COUNT), lbnd=-1.0) @ _TO_CHEBYSHEV  # from the left end of a piece
_WHOLE = _INTEGRAL.sum(axis=0, keepdims=True)  # up to the right end, where every Chebyshev polynomial is 1
# From values at the nodes to the coefficients of the integral and the whole integral, followed by their own first two
# and last two coefficients.
_DEVELOPING = np.concatenate([_INTEGRAL, _WHOLE, _TO_CHEBYSHEV[:2], _TO_CHEBYSHEV[-2:]])


class ProfilePart(NamedTuple):
    """Integrals along the arcs of some circles from their left ends, in pieces.

    Attributes
    ----------
    edges : ndarray
        Directions of the left ends of pieces, and of the right end, (pieces + 1, circles).
    before : ndarray
        Integrals up to the edges, (integrals, columns, pieces + 1, circles).
    series : ndarray
        Chebyshev coefficients of the integral within each piece, (integrals, columns, terms, pieces, circles).
    """

    edges: Floats
    before: Floats
    series: Floats

    def up_to(self, beta: Floats, count: int) -> Floats:
        """Return the first integrals up to directions (M, circles) within the arcs, (count, columns, M, circles).

        Directions are in rad from straight below the centre, positive to the right.
        """
        edges = self.edges
        inside = np.clip(beta, edges[0], edges[-1])
        piece = np.zeros(beta.shape, np.intp)
        for edge in edges[1:-1]:
            piece += inside >= edge
        of_first_circle = piece[:, :1]
        if np.all(piece == of_first_circle):
            piece = of_first_circle
        first = _of_piece(edges, piece)
        width = _of_piece(edges[1:], piece) - first
        place = 2.0 * ((inside - first) / np.where(width != 0.0, width, 1.0)) - 1.0
        polynomials = np.moveaxis(chebyshev.chebvander(place, _COUNT), -1, 0)
        up_to = np.einsum("sctmn,tmn->scmn", _of_piece(self.series[:count], piece), polynomials)
        up_to += _of_piece(self.before[:count], piece)
        return up_to

    def combined(self, weights: Floats) -> "ProfilePart":
        """Return the load in a single column, the sum of all columns with weights, (columns, circles).

        Only the first `PRESSING` integrals are retained.
        """
        before = np.einsum("scpn,cn->spn", self.before[:PRESSING], weights)
        series = np.einsum("sctpn,cn->stpn", self.series[:PRESSING], weights)
        return ProfilePart(self.edges, before[:, None], series[:, None])


def _of_piece(values: Floats, piece: Integers) -> Floats:
    """Return the values (..., pieces, circles) of one piece for each of M directions, (..., M, circles).

    `piece` are indices of pieces, (M, circles), or (M, 1) if all circles share them, as similar masses often do.
    """
    if piece.shape[1] == 1:
        return values.take(piece[:, 0], axis=-2)
    *axes, pieces, circles = values.shape
    number = piece * circles + np.arange(circles)
    return values.reshape(*axes, pieces * circles).take(number, axis=-1)


class Profile(NamedTuple):
    """Integrals along arcs.

    Attributes
    ----------
    whole : ndarray
        Integrals from end to end, (integrals, columns, circles).
    parts : sequence
        Integrals from the left end to any direction, each for as many circles as fit into the cache.
    """

    whole: Floats
    parts: Sequence[ProfilePart]

    def up_to(self, beta: Floats, count: int) -> Floats:
        """Return the first integrals up to directions (M, circles) within the arcs, (count, columns, M, circles).

        Directions are in rad from straight below the centre, positive to the right.
        """
        _, columns, *_ = self.parts[0].series.shape
        every = np.empty((count, columns, *beta.shape))
        first = 0
        for part in self.parts:
            last = first + part.edges.shape[1]
            every[..., first:last] = part.up_to(beta[:, first:last], count)
            first = last
        return every

    @property
    def to_ends(self) -> Floats:
        """Integrals of the parts over whole arcs, (integrals, columns, circles)."""
        return np.concatenate([part.before[:, :, -1] for part in self.parts], axis=-1)


def columns_of(steps: Floats, circles: int) -> ArrayPair:
    """Return the surfaces summed in each column, (columns, surfaces, circles), and its weights, (columns, lanes).

    ``steps`` are the steps of the unit weight below surfaces, (surfaces, lanes). For one circle each column is a
    surface. For many circles the first column is the ground, and the second all other surfaces, if they have any
    weight.
    """
    alone = np.eye(len(steps))[..., None]
    if circles == 1:
        return alone, steps
    ground, *_ = alone
    others = steps / steps[0] - ground
    count = 2 if np.any(others) else 1
    return np.stack(np.broadcast_arrays(ground, others)[:count]), np.tile(steps[0], (count, 1))


def profile_of(strips: Strips, weights: Floats, steps: Floats) -> Profile:
    """Return the integrals along the arcs of masses in strips.

    The weights below surfaces have the shape (columns, surfaces, circles).

    Each surcharge adds two surfaces: a pressure that falls from 1 to 0, and a pressure that rises from 0 to 1, over R.
    For many circles the columns are combined with the steps of the unit weight.
    """
    edges = strips.beta.T
    circles = np.arange(edges.shape[1])
    has_many = circles.size > 1
    retained = PRESSING if has_many else _INTEGRALS
    parts = []
    whole = []
    for first in range(0, max(1, circles.size), _CIRCLES):
        some = slice(first, first + _CIRCLES)
        # The integrals of all columns along the arcs of some circles with the given edges of strips.
        develop = partial(_developed, strips, weights, circles[some])
        rounds = converged_pieces(edges[:-1, some], edges[1:, some], develop, _ACCURACY, _SHORTEST)
        pieces = [piece for *arrays, smooth in rounds for piece in compress(zip(*arrays, strict=True), smooth)]
        pieces.sort(key=lambda piece: float((piece[0] + piece[1]).sum()))  # from left to right
        firsts, lasts, by_piece = zip(*pieces, strict=True)
        each = np.stack([of_piece[:, :, -1] for of_piece in by_piece], axis=2)
        series = np.stack([of_piece[:retained, :, :-1] for of_piece in by_piece], axis=3)
        before = np.cumsum(np.insert(each, 0, 0.0, axis=2), axis=2)
        part = ProfilePart(np.stack([*firsts, lasts[-1]]), before, series)
        whole.append(before[:, :, -1])
        if has_many:
            part = part.combined(steps[:, some])
        parts.append(part)
    return Profile(np.concatenate(whole, axis=-1), parts)


def _developed(
    strips: Strips, weights: Floats, circle: Integers, strip: Integers, first: Floats, last: Floats
) -> ArrayTriple:
    """Return series of pieces, (pieces, integrals, columns, terms + 1, circles), and sizes of their coefficients.

    The last term is the integral over the piece. The head is the greater of the first two coefficients, the tail the
    greater of the last two, each (pieces, circles). The arguments are those of `_integrands`.
    """
    values = _integrands(strips, weights, strip[:, None], circle, first, last)
    *axes, pieces, circles = values.shape
    developed = _DEVELOPING @ values.reshape(*axes, pieces * circles)
    by_piece = developed.reshape(*axes[:2], len(_DEVELOPING), pieces, circles)
    series, sizes = np.split(by_piece, [_COUNT + 2], axis=2)
    of_terms = np.abs(sizes).max(axis=(0, 1))
    return np.moveaxis(series, 3, 0), of_terms[:2].max(axis=0), of_terms[2:].max(axis=0)


def _integrands(
    strips: Strips, weights: Floats, strip: Integers, circle: Integers, first: Floats, last: Floats
) -> Floats:
    """Return the integrands at nodes times half the widths of pieces, (integrals, columns, nodes, pieces, circles).

    The pieces extend from `first` to `last` in rad, (pieces, circles), and lie in the strips with the indices `strip`.
    The weights below surfaces are (columns, surfaces, circles).
    """
    half = (last - first) / 2
    beta = first + half * _FROM_FIRST
    x = np.sin(beta)
    c = np.cos(beta)
    per_node = half * c
    beyond = x - strips.x[circle, strip]
    at_left = strips.y[:, circle, strip]
    slope = strips.slope[:, circle, strip]
    weight = weights[:, :, None, circle] * strips.above[:, circle, strip]
    columns = np.moveaxis(weight, 1, 0)[:, :, None]  # weights of each surface
    total = np.zeros((_INTEGRALS, len(weight), *beta.shape))
    counts = weight[:, : len(slope)].any(axis=(0, 2, 3))
    for k in np.flatnonzero(counts).tolist():
        height = np.maximum(at_left[k] + slope[k] * beyond + c, 0.0)
        _add(total, over_height(c, height), columns[k] * per_node)
    _complete(total, x, c)
    ground = at_left[0] + slope[0] * beyond
    _add_loads(total, strips.loads, circle, x, ground, columns[len(slope) :] * per_node)
    return total


def _add(total: Floats, rows: Iterable[tuple[int, Floats]], weight: Floats) -> None:
    """Add weighted integrals to `total`.

    `rows` are pairs of the index of an integral and its values, all with the same weight.
    """
    for integral, row in rows:
        weighted = row * weight
        total[integral] += weighted


def _add_loads(
    total: Floats, loads: Sequence[Sequence[Floats]], circle: Integers, x: Floats, y: Floats, weights: Floats
) -> None:
    """Add the weights of surcharges on the ground at (x, y), each with its left and its right end.

    `total` has the integrals as first axis and is changed. `circle` are the indices of the circles, and lengths are
    over R.
    """
    remaining = iter(weights)
    for ends in loads:
        first, last = (end[circle, 0] for end in ends)
        share = (x - first) / (last - first)
        for pressure in (1.0 - share, share):
            weight = next(remaining) * pressure
            if weight.any():
                _add(total, _of_pressure(x, y), weight)


def over_height(c: Floats, h: Floats) -> Iterator[tuple[int, Floats]]:
    """Yield the integrals over y from the arc to a height h above it, by index, which `_complete` completes.

    `c` is the cosine of the direction, and lengths are over R.
    """
    chord = 2.0 * c - h
    gap = h * chord  # 1 - rho^2
    rho = np.sqrt(1.0 - gap)
    inward = gap / (1.0 + rho)  # 1 - rho
    ratio = (inward + h) / (rho + c - h)
    centre = h / 3 - c
    yield RADIAL_Y, -inward
    yield RADIAL_X, np.log1p(ratio)
    yield POLAR, h * rho
    yield AREA, h
    yield INERTIA, h * h * centre
    yield MOMENT_Y, gap / -2


def _complete(total: Floats, x: Floats, c: Floats) -> None:
    """Add the parts of the integrals over y beyond the sums of `over_height`, for all surfaces at once.

    `total` has the integrals as first axis and is changed. `x` and `c` are sine and cosine of the directions.
    """
    radial_y, radial_x, polar, head, area, inertia, moment_x, _ = total
    radial_x *= x
    polar += x * radial_x
    polar -= c * radial_y
    polar /= 2
    inertia += area
    np.divide(area, c, out=head)
    np.multiply(area, x, out=moment_x)


def _of_pressure(x: Floats, y: Floats) -> Iterator[tuple[int, Floats]]:
    """Return the integrals over x for a pressure on the ground at (x, y): times 1, rho, ... at this point."""
    square = x * x + y * y
    rho = np.sqrt(square)
    yield RADIAL_Y, y / rho
    yield RADIAL_X, x / rho
    yield POLAR, rho
    yield AREA, np.ones_like(x)
    yield INERTIA, square
    yield MOMENT_X, x
    yield MOMENT_Y, y
