"""Piecewise polynomials for functions of the rotation that are smooth between their kinks.

Each piece interpolates at Chebyshev nodes. It is halved until the neglected coefficients are small enough.
"""

import math
from collections.abc import Callable, Iterator

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from slipcircle.base.kinds import ArrayPair, ArrayTriple, Floats, Function, Integers
from slipcircle.base.sections import distinct
from slipcircle.core.scene.piecewise import Data

TERMS = 8  # coefficients of a piece
ORDERS = np.arange(TERMS)
_ANGLES = np.pi * (ORDERS + 0.5) / TERMS
NODES = np.cos(_ANGLES)
_POLYNOMIALS = np.cos(np.outer(np.arccos(NODES), ORDERS))
TO_CHEBYSHEV = np.linalg.inv(_POLYNOMIALS)
_SHORTEST = 2e-3  # width of a piece of a function of the rotation, rad
_SAME = 1e-13  # rad, distance below which two kinks are identical


def _powers_of_chebyshev() -> Floats:
    """Return the coefficients of T_0 to T_7 in powers of 1 + x, of shape (powers, T).

    1 + x is the distance to the left end over half the width.
    """
    from_middle = Polynomial([-1.0, 1.0])
    powers = np.zeros((TERMS, TERMS))
    for k in range(TERMS):
        polynomial = Chebyshev.basis(k)(from_middle)
        powers[: k + 1, k] = polynomial.coef
    return powers


POWERS = _powers_of_chebyshev()


def converged_pieces(
    first: Floats,
    last: Floats,
    develop: Callable[[Integers, Floats, Floats], ArrayTriple],
    accuracy: float,
    shortest: float,
) -> Iterator[tuple[Integers, Floats, Floats, Floats]]:
    """Halve pieces until their series have converged; yield the converged pieces: numbers, ends and series.

    Parameters
    ----------
    first, last : ndarray
        Ends of the initial pieces, (pieces, n).
    develop : callable
        Takes the index of the initial piece that contains each piece, (pieces,), and the ends of the pieces. It returns
        their series, (pieces, ...), sizes of coefficients, and the sizes of the last coefficients, (pieces, n).
    accuracy : float
        Greatest size of the last coefficients, relative to the greatest size.
    shortest : float
        Greatest width of a piece that is not halved further.
    """
    number = np.arange(len(first))
    scale = 0.0
    while len(number):
        series, sizes, tails = develop(number, first, last)
        scale = float(sizes.max(initial=scale))
        is_wide = last - first > shortest
        is_rough = is_wide & (tails > accuracy * scale)
        rough = np.logical_or.reduce(is_rough, axis=1)
        yield number[~rough], first[~rough], last[~rough], series[~rough]
        left = first[rough]
        right = last[rough]
        middle = (left + right) / 2
        first = np.concatenate([left, middle])
        last = np.concatenate([middle, right])
        number = np.tile(number[rough], 2)


# --- functions of the rotation ---------------------------------------------------------------------------------------


def between_kinks(function: Function, kinks: Floats, least: Floats, most: Floats, tolerance: float) -> ArrayPair:
    """Return functions of the rotation as piecewise polynomials of degree 7.

    Parameters
    ----------
    function : callable
        Takes rotations (M, n), rad, and returns values (functions, M, n). It also takes the Chebyshev nodes of pieces,
        (pieces, nodes, n).
    kinks : ndarray
        Rotations at which a function may not be smooth, (kinks, n), increasing.
    least, most : ndarray
        Range of rotations, (n,), beyond which the polynomials are constant.
    tolerance : float
        Bound of the first neglected Chebyshev coefficient of a piece, relative to the greatest value.

    Returns
    -------
    breaks : ndarray
        Left ends of the pieces, (pieces, n).
    coefficients : ndarray
        Coefficients in powers of the distance to the break, (pieces, TERMS, functions, n).
    """
    inside = np.clip(kinks, least, most)
    edges = _divided(distinct(np.vstack([least, inside, most]), _SAME), tolerance)
    end = edges[-1]
    constant = _constant(function, end)

    starts = [edges[:0]]
    coefficients = [constant[:0]]

    def develop(_: Integers, first: Floats, last: Floats) -> ArrayTriple:
        chebyshev = _chebyshev(function, first, last)
        sizes = np.abs(chebyshev)
        return chebyshev, sizes, _next_coefficients(sizes)

    for _, start, stop, chebyshev in converged_pieces(edges[:-1], edges[1:], develop, tolerance, _SHORTEST):
        starts.append(start)
        coefficients.append(_in_powers(chebyshev, stop - start))
    start = np.concatenate(starts)
    order = np.argsort(start.sum(axis=1), kind="stable")
    powers = np.concatenate(coefficients)
    return np.vstack([start[order], end]), np.concatenate([powers[order], constant])


def _divided(edges: Floats, tolerance: float) -> Floats:
    """Return edges of pieces, (edges, n), with further ones where a piece is too wide for the tolerance.

    A piece is narrow enough if interpolation meets the tolerance for a function whose derivatives are at most 1.
    """
    inverse_error = 2.0 ** (TERMS - 1) * math.factorial(TERMS)  # at width 2
    widest = 2 * (tolerance * inverse_error) ** (1 / TERMS)
    while True:
        is_wide = (np.diff(edges, axis=0) > widest).any(axis=1)
        if not np.any(is_wide):
            return edges
        middle = (edges[:-1] + edges[1:]) / 2
        edges = np.sort(np.concatenate([edges, middle[is_wide]]), axis=0)


def _chebyshev(function: Function, first: Floats, last: Floats) -> Floats:
    """Return the Chebyshev coefficients, (pieces, TERMS, functions, n), of functions on pieces of shape (pieces, n).

    `first` and `last` are the ends of the pieces in rad.
    """
    half = (last - first) / 2
    from_first = 1.0 + NODES[:, None]
    distance = half[:, None] * from_first  # pieces, nodes, n
    rotation = first[:, None] + distance
    values = function(rotation)
    by_piece = values.reshape(len(values), *rotation.shape)
    return np.einsum("kj,fpjn->pkfn", TO_CHEBYSHEV, by_piece)  # not by BLAS, whose rounding depends on the place of n


def _next_coefficients(size: Floats) -> Floats:
    """Return an estimate of the size of the first neglected coefficient, (pieces, n), for the worst function.

    The sizes of the coefficients are (pieces, TERMS, functions, n). The ratio of the last two to the preceding two is
    extrapolated.
    """
    last = size[:, -2:].max(axis=1)
    before = size[:, -4:-2].max(axis=1)
    divisor = np.where(before > 0.0, before, 1.0)
    ratio = np.minimum(last / divisor, 1.0)
    following = last * ratio
    return following.max(axis=1)


def _in_powers(chebyshev: Floats, width: Floats) -> Floats:
    """Return coefficients in powers of the distance to the left end of each piece, (pieces, TERMS, functions, n).

    The argument contains Chebyshev coefficients in the same shape, and the widths are (pieces, n) in rad.
    """
    powers = np.einsum("tk,pkfn->ptfn", POWERS, chebyshev)
    is_empty = width <= _SAME  # only their value is accurate
    half = np.where(is_empty, np.inf, width / 2)
    exponents = ORDERS[:, None, None]
    units = half[:, None, None] ** exponents
    return powers / units


def _constant(function: Function, end: Floats) -> Floats:
    """Return the coefficients of constant functions with the values at the end, (1, TERMS, functions, n).

    The ends are rotations in rad, (n,).
    """
    value = function(end[None])[:, 0]
    coefficients = np.zeros((1, TERMS, *value.shape))
    coefficients[0, 0] = value
    return coefficients


def continuous(breaks: Floats, coefficients: Floats, sine: bool = False) -> Data:
    """Return a continuous piecewise polynomial.

    `breaks` are the left ends of the pieces, and the coefficients of each piece are in ascending powers of the distance
    to its break, or describe a sine if `sine`.
    """
    jumps = np.zeros(len(breaks))
    return Data(breaks, coefficients, jumps, sine)
