"""Weight of a mass on its arc as a function of direction: integrals along the arc of the material vertically above it.

After a rotation phi the strip above a direction beta of the arc has the normal force A(beta) cos(phi) - B(beta)
sin(phi) + P(beta) omega^2 (proved in `derive.algebra.slopes`). Let y be its top over R relative to the centre, x =
sin(beta), c = cos(beta), rho^2 = x^2 + y^2, and dx = c dbeta. The integrals over y from the arc at -c to the top are

    of 1, rho, rho^2, x/rho, y/rho, x, y:  h,  (y rho + c + x^2 L)/2,  x^2 h + (y^3 + c^3)/3,  x L,  rho - 1,  x h,
    (y^2 - c^2)/2,  where h = y + c and L = ln((1 + c)/(rho - y)).

In terms of h and 1 - rho^2 = h (2 c - h) nothing cancels in thin masses. The integrands are smooth between the edges of
strips, where they are integrated as Chebyshev series, in pieces that are halved until the series have converged.
"""

from collections.abc import Iterable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev, legendre

from slipcircle.base.kinds import ArrayTriple, Floats, Integers
from slipcircle.ground.plane import sine_and_cosine
from slipcircle.layers.strips import Strips
from slipcircle.tables.interpolation import NODES, TERMS, TO_CHEBYSHEV, converged_pieces

RADIAL_Y, RADIAL_X, POLAR, HEAD, AREA, INERTIA, MOMENT_X, MOMENT_Y = range(8)  # in order; the head is over beta, not x
MEASURED = [AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y]  # in the order of `circles.MEASURES`
_INTEGRALS = len(MEASURED) + 1
PRESSING = 4  # number of the first integrals, which strength uses
_COUNT = 10  # nodes of Gauss' rule on a piece
_ACCURACY = 1e-8  # of the last coefficients in Legendre polynomials; the error of Gauss' rule is about its square
_SHORTEST = 1e-4  # width of a piece, rad
_TOGETHER = 1 << 14  # nodes of a block, whose arrays fit into the cache


class Rule(NamedTuple):
    """Weights of the values at nodes in integrals over pieces, (integrals, nodes), for a half width of 1.

    Nodes are distances from the start over half the width of a piece, (nodes, 1, 1).
    """

    nodes: Floats
    weights: Floats


def _gauss(count: int) -> Rule:
    nodes, weights = legendre.leggauss(count)
    return Rule(1.0 + nodes[:, None, None], weights[None])


GAUSS = _gauss(_COUNT)
ROUGH = _gauss(2)  # for estimates
_DEGREES = np.array([0, 1, _COUNT - 2, _COUNT - 1])  # of the Legendre polynomials whose coefficients are needed
_PLACES = GAUSS.nodes.ravel() - 1.0
_POLYNOMIALS = legendre.legvander(_PLACES, _COUNT)[:, _DEGREES]
_NORMED = _POLYNOMIALS * (_DEGREES + 0.5)
_DEVELOPING = _NORMED.T * GAUSS.weights
_INTEGRATED = chebyshev.chebint(np.eye(TERMS)) @ TO_CHEBYSHEV
_AT_NODES = chebyshev.chebvander(NODES, TERMS) @ _INTEGRATED
_UP_TO_NODES = np.hstack([GAUSS.weights.repeat(TERMS, 0), _AT_NODES - _AT_NODES[0]])  # up to the first one by Gauss


class _Surfaces(NamedTuple):
    """Surfaces with a weight above arcs, straight in each strip, (surfaces, strips, circles).

    Attributes
    ----------
    x : ndarray
        Left edges of the strips, (strips, circles).
    y, slope : ndarray
        Height at the left edge, and slope to the right; the first surface is the ground.
    weight : ndarray
        Weight of each surface in the columns, 0 where it is below the arc, (columns, surfaces, strips, circles). Two
        rows follow for each surcharge.
    loads : ndarray
        Both ends x1 and x2 of each surcharge, (loads, 2, circles).
    """

    x: Floats
    y: Floats
    slope: Floats
    weight: Floats
    loads: Floats


class Profile(NamedTuple):
    """Integrals along arcs from their left ends, in pieces.

    Attributes
    ----------
    surfaces : _Surfaces
        Surfaces above the arcs.
    strip : ndarray
        Index of the strip of each piece, (pieces,).
    edges : ndarray
        Directions of the left ends of pieces, and of the right end, (pieces + 1, circles).
    before : ndarray
        Integrals up to the edges, (integrals, columns, pieces + 1, circles).
    """

    surfaces: _Surfaces
    strip: Integers
    edges: Floats
    before: Floats

    @property
    def whole(self) -> Floats:
        """Integrals from end to end, (integrals, columns, circles)."""
        return self.before[:, :, -1]

    def _piece(self, beta: Floats) -> Integers:
        """Return the index of the piece of each direction, (M, circles), or (M, 1) if all circles share them."""
        inner = self.edges[1:-1, None]
        piece = (inner <= beta).sum(axis=0)
        of_first_circle = piece[:, :1]
        return of_first_circle if (piece == of_first_circle).all() else piece

    def up_to(self, beta: Floats, count: int, rule: Rule = GAUSS) -> Floats:
        """Return the first integrals up to directions (M, circles) within the arcs, (count, columns, M, circles).

        Directions are in rad from straight below the centre, positive to the right.
        """
        inside = beta.clip(self.edges[0], self.edges[-1])
        piece = self._piece(inside)
        first = _of_piece(self.edges, piece)
        half = (inside - first) / 2
        nodes = first + half * rule.nodes
        within = _integrals(self.surfaces, self.strip[piece], nodes, half[None], rule.weights, count)
        return within[0] + _of_piece(self.before[:count], piece)

    def up_to_nodes(self, beta: Floats, count: int) -> Floats:
        """Return the first integrals up to Chebyshev nodes, (count, columns, M, nodes, circles).

        The nodes, (M, nodes, circles), are those of pieces on which the integrands are interpolated, each within one
        strip.
        """
        place = beta[:, 0]
        piece = self._piece(place)
        first = _of_piece(self.edges, piece)
        to_first_node = (place - first) / 2
        of_nodes = (beta[:, -1] - place) / (NODES[-1] - NODES[0])
        halves = np.stack([to_first_node, of_nodes])
        of_gauss = first + to_first_node * GAUSS.nodes
        nodes = np.concatenate([of_gauss, beta.swapaxes(0, 1)])
        half = halves.repeat([_COUNT, TERMS], 0)
        within = _integrals(self.surfaces, self.strip[piece], nodes, half, _UP_TO_NODES, count)
        within += _of_piece(self.before[:count], piece)
        return within.transpose(1, 2, 3, 0, 4)


def _of_piece(values: Floats, piece: Integers, some: slice = slice(None)) -> Floats:
    """Return the values (..., pieces, circles) of one piece for each of M directions and some circles.

    `piece` are indices of pieces, (M, circles), or (M, 1) if all circles share them, as similar masses often do.
    """
    values = values[..., some]
    if piece.shape[1] == 1:
        return values.take(piece[:, 0], axis=-2)
    *axes, pieces, circles = values.shape
    number = piece[:, some] * circles + np.arange(circles)
    in_a_row = values.reshape(*axes, pieces * circles)
    return in_a_row.take(number, axis=-1)


def profile_of(strips: Strips, weights: Floats) -> Profile:
    """Return the integrals along the arcs of masses in strips.

    The weights below surfaces have the shape (columns, surfaces, circles).

    Each surcharge adds two surfaces: a pressure that falls from 1 to 0, and a pressure that rises from 0 to 1, over R.
    """
    edges = strips.beta.T
    count = len(strips.y)
    has_weight = weights[:, :count].any(axis=(0, 2))
    used = np.flatnonzero(has_weight)
    rows = np.concatenate([used, np.arange(count, len(strips.above))])
    weight = weights[:, rows, None] * strips.above[rows].swapaxes(1, 2)
    loads = np.reshape(strips.loads, (len(strips.loads), 2, len(strips.x)))
    left = strips.x[:, :-1]
    x, y, slope = (values.swapaxes(-2, -1) for values in (left, strips.y[used], strips.slope[used]))
    surfaces = _Surfaces(x, y, slope, weight, loads)
    develop = partial(_developed, surfaces)
    rounds = [*converged_pieces(edges[:-1], edges[1:], develop, _ACCURACY, _SHORTEST)]
    columns = zip(*rounds, strict=True)
    number, first, last, each = map(np.concatenate, columns)
    in_order = np.argsort((first + last).sum(axis=1), kind="stable")  # from left to right
    by_piece = each[in_order].transpose(1, 2, 0, 3)
    from_start = np.insert(by_piece, 0, 0.0, axis=2)
    before = np.cumsum(from_start, axis=2)
    every_edge = np.concatenate([first[in_order], edges[-1:]])
    return Profile(surfaces, number[in_order], every_edge, before)


def _developed(surfaces: _Surfaces, strip: Integers, first: Floats, last: Floats) -> ArrayTriple:
    """Return integrals over pieces, (pieces, integrals, columns, circles), and sizes of their coefficients.

    The sizes are the greater one of the first two coefficients, and the greater one of the last two, each (pieces,
    circles). The pieces extend from `first` to `last` in rad, (pieces, circles), and lie in the strips with the indices
    `strip`.
    """
    half = (last - first) / 2
    nodes = first + half * GAUSS.nodes
    coefficients = _integrals(surfaces, strip[:, None], nodes, half[None], _DEVELOPING, _INTEGRALS)
    sizes = np.abs(coefficients).max(axis=(1, 2))
    whole = 2.0 * coefficients[0]
    first_sizes, last_sizes = sizes.reshape(2, 2, *first.shape).max(axis=1)
    by_piece = whole.transpose(2, 0, 1, 3)
    return by_piece, first_sizes, last_sizes


def _integrals(surfaces: _Surfaces, strip: Integers, nodes: Floats, half: Floats, rule: Floats, count: int) -> Floats:
    """Return the first integrals by a rule on pieces, (integrals of the rule, count, columns, pieces, circles).

    The rule contains weights of the values at nodes, (integrals, nodes), in pieces with the half widths `half`. The
    nodes are directions in rad, (nodes, pieces, circles), `half` is (nodes or 1, pieces, circles). Pieces lie in the
    strips with the indices `strip`, (pieces, circles or 1).
    """
    _, pieces, circles = nodes.shape
    columns = len(surfaces.weight)
    integrals = np.empty((len(rule), count, columns, pieces, circles))
    together = max(1, _TOGETHER * circles // max(1, nodes.size))
    for start in range(0, circles, together):
        some = slice(start, start + together)
        x, y, slope, weight = (_of_piece(values, strip, some) for values in surfaces[:-1])
        above = _Surfaces(x, y, slope, weight, surfaces.loads[..., some])
        beta = nodes[..., some]
        values = _integrands(above, beta, half[..., some], count)
        # Products of matrices by BLAS would be rounded differently in different circles.
        integrals[..., some] = np.einsum("rk,scknl->rscnl", rule, values)
    return integrals


def _integrands(surfaces: _Surfaces, beta: Floats, half: Floats, count: int) -> Floats:
    """Return the first integrands at directions in rad, times `half`, (count, columns, nodes, pieces, circles).

    The directions are (nodes, pieces, circles), and the `surfaces` those above the strip of each piece.
    """
    x, c = sine_and_cosine(beta)
    per_node = half * c
    beyond = x - surfaces.x
    by_surface = surfaces.weight.swapaxes(0, 1)
    weights = by_surface[:, :, None]
    total = np.zeros((count, weights.shape[1], *beta.shape))
    for weight, y, slope in zip(weights, surfaces.y, surfaces.slope, strict=False):
        used = np.flatnonzero(weight.any(axis=(0, 1, 3)))
        if used.size:
            some = slice(used[0], used[-1] + 1)  # pieces
            cosine = c[:, some]
            rise = slope[some] * beyond[:, some]
            height = np.maximum(y[some] + rise + cosine, 0.0)
            rows = over_height(x[:, some], cosine, height)
            _add(total[..., some, :], rows, weight[..., some, :] * per_node[:, some])
    if len(surfaces.loads):
        ground = surfaces.y[0] + surfaces.slope[0] * beyond
        _add_loads(total, surfaces.loads, x, ground, weights[len(surfaces.y) :] * per_node)
    return total


def _add(total: Floats, rows: Iterable[tuple[int, Floats]], weight: Floats) -> None:
    """Add weighted integrals to `total`, which has the first ones.

    `rows` are pairs of the index of an integral and its values, in increasing order, all with the same weight.
    """
    for integral, row in rows:
        if integral >= len(total):
            break
        weighted = row * weight
        total[integral] += weighted


def _add_loads(total: Floats, loads: Floats, x: Floats, y: Floats, weights: Floats) -> None:
    """Add the weights of surcharges on the ground at (x, y), each with its left and its right end.

    `total` has the integrals as first axis and is changed. The `loads` are x of these ends, (loads, 2, circles), and
    lengths are over R.
    """
    remaining = iter(weights)
    for first, last in loads:
        share = (x - first) / (last - first)
        for pressure in (1.0 - share, share):
            weight = next(remaining) * pressure
            if weight.any():
                _add(total, _of_pressure(x, y), weight)


def over_height(x: Floats, c: Floats, h: Floats) -> Iterator[tuple[int, Floats]]:
    """Yield the integrals over y from the arc to a height h above it, in order, by index.

    `x` and `c` are sine and cosine of the direction, and lengths are over R.
    """
    chord = 2.0 * c - h
    gap = h * chord  # 1 - rho^2
    rho = np.sqrt(1.0 - gap)
    inward = gap / (1.0 + rho)  # 1 - rho
    yield RADIAL_Y, -inward
    ratio = (inward + h) / (rho + c - h)
    radial_x = x * np.log1p(ratio)
    yield RADIAL_X, radial_x
    yield POLAR, (h * rho + x * radial_x + c * inward) / 2
    yield HEAD, h / c
    yield AREA, h
    yield INERTIA, h * h * (h / 3 - c) + h
    yield MOMENT_X, x * h
    yield MOMENT_Y, gap / -2


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
