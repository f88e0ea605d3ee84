"""Functions of the rotation known by their values, as piecewise polynomials between their kinks.

Each piece interpolates at the nodes of Chebyshev; it is halved until the coefficients that follow are negligible.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from slipcircle.base.kinds import Floats
from slipcircle.base.sections import distinct
from slipcircle.core.scene.piecewise import Data

Function = Callable[[Any], Any]
TERMS = 8  # of a piece
ORDERS = np.arange(TERMS)
_ANGLES = np.pi * (ORDERS + 0.5) / TERMS
NODES = np.cos(_ANGLES)
_POLYNOMIALS = np.cos(np.outer(np.arccos(NODES), ORDERS))
TO_CHEBYSHEV = np.linalg.inv(_POLYNOMIALS)
_SHORTEST = 2e-3  # width of a piece of a function of the rotation, rad
_SAME = 1e-13  # rad, between kinks that are one


def _powers_of_chebyshev() -> Floats:
    """T_0 to T_7 in powers of 1 + x, the distance to the left end of a piece over half its width; (powers, T)."""
    from_middle = Polynomial([-1.0, 1.0])
    powers = np.zeros((TERMS, TERMS))
    for k in range(TERMS):
        polynomial = Chebyshev.basis(k)(from_middle)
        powers[: k + 1, k] = polynomial.coef
    return powers


POWERS = _powers_of_chebyshev()

# --- functions of the rotation ---------------------------------------------------------------------------------------


def between_kinks(
    function: Function, kinks: Floats, least: Floats, most: Floats, tolerance: float
) -> tuple[Floats, Floats]:
    """Functions of the rotation as piecewise polynomials of degree 7.

    Parameters
    ----------
    function : callable
        Takes rotations (M, n), rad, and returns values (functions, M, n).
    kinks : ndarray
        Rotations at which a function may not be smooth, (kinks, n), increasing.
    least, most : ndarray
        Range of rotations, (n,), beyond which the polynomials extend as constants.
    tolerance : float
        First neglected Chebyshev coefficient of a piece, over the greatest value.

    Returns
    -------
    breaks : ndarray
        Where pieces begin, (pieces, n).
    coefficients : ndarray
        In powers of the distance to the break, (pieces, TERMS, functions, n).
    """
    inside = np.clip(kinks, least, most)
    edges = distinct(np.vstack([least, inside, most]), _SAME)
    first, last = _first_pieces(edges, _widest(tolerance))
    end = edges[-1]
    constant = _constant(function, end)
    starts = [edges[:0]]
    coefficients = [constant[:0]]
    scale = 0.0
    while len(first):
        chebyshev = _chebyshev(function, first, last)
        greatest = np.abs(chebyshev).max(initial=0.0)
        scale = max(scale, float(greatest))
        width = last - first
        is_wide = width > _SHORTEST
        neglected = _next_coefficients(chebyshev)
        is_rough = is_wide & (neglected > tolerance * scale)
        rough = is_rough.any(axis=1)
        smooth = ~rough
        powers = _in_powers(chebyshev[smooth], width[smooth])
        starts.append(first[smooth])
        coefficients.append(powers)
        first, last = _halves(first[rough], last[rough])
    start = np.concatenate(starts)
    order = np.argsort(start.sum(axis=1), kind="stable")
    powers = np.concatenate(coefficients)
    breaks = np.vstack([start[order], end])
    return breaks, np.concatenate([powers[order], constant])


def _widest(tolerance: float) -> float:
    """Width of a piece that interpolation meets the tolerance on, if no derivative exceeds 1."""
    inverse_error = 2.0 ** (TERMS - 1) * math.factorial(TERMS)  # at width 2
    half = (tolerance * inverse_error) ** (1 / TERMS)
    return float(2 * half)


def _first_pieces(edges: Floats, widest: float) -> tuple[Floats, Floats]:
    """Both ends of the pieces to begin with, (pieces, n): between edges, none wider than some."""
    widths = np.diff(edges, axis=0)
    greatest_width = widths.max(axis=1, initial=0.0)
    pieces = np.ceil(greatest_width / widest - 1e-9)
    count = pieces.astype(np.intp)
    numbers = map(np.arange, count)
    number = np.concatenate([*numbers])  # of a piece between its edges
    of = np.repeat(count, count)
    start = np.repeat(edges[:-1], count, axis=0)
    end = np.repeat(edges[1:], count, axis=0)
    width = end - start
    share_before = number / of
    share_after = (number + 1) / of
    first = start + width * share_before[:, None]
    last = start + width * share_after[:, None]
    at_end = share_after == 1.0
    last[at_end] = end[at_end]
    first[:1] = edges[0]  # also where the kinks next to it are one with it
    return first, last


def _halves(first: Floats, last: Floats) -> tuple[Floats, Floats]:
    """Both ends of the two halves of each piece."""
    middle = (first + last) / 2
    firsts = np.concatenate([first, middle])
    lasts = np.concatenate([middle, last])
    return firsts, lasts


def _chebyshev(function: Function, first: Floats, last: Floats) -> Floats:
    """Chebyshev coefficients of functions on pieces (pieces, n): (pieces, TERMS, functions, n)."""
    half = (last - first) / 2
    from_first = 1.0 + NODES[:, None]
    distance = half[:, None] * from_first  # pieces, nodes, n
    rotation = first[:, None] + distance
    lanes = rotation.shape[-1]
    every_rotation = rotation.reshape(-1, lanes)
    values = function(every_rotation)
    by_piece = values.reshape(-1, *rotation.shape)
    return np.einsum("kj,fpjn->pkfn", TO_CHEBYSHEV, by_piece)


def _next_coefficients(chebyshev: Floats) -> Floats:
    """The coefficients that follow, if they fall like the last two pairs of them, of the functions: (pieces, n)."""
    size = np.abs(chebyshev)
    last = size[:, -2:].max(axis=1)
    before = size[:, -4:-2].max(axis=1)
    divisor = np.where(before > 0.0, before, 1.0)
    ratio = np.minimum(last / divisor, 1.0)
    following = last * ratio
    return following.max(axis=1)


def _in_powers(chebyshev: Floats, width: Floats) -> Floats:
    """The same polynomials in powers of the distance to the beginning of each piece."""
    powers = np.einsum("tk,pkfn->ptfn", POWERS, chebyshev)
    is_empty = width <= _SAME  # of which only the value has digits
    half = np.where(is_empty, np.inf, width / 2)
    exponents = ORDERS[:, None, None]
    units = half[:, None, None] ** exponents
    return powers / units


def _constant(function: Function, end: Floats) -> Floats:
    """Coefficients of the values at the end, (1, TERMS, functions, n)."""
    value = function(end[None])[:, 0]
    coefficients = np.zeros((1, TERMS, *value.shape))
    coefficients[0, 0] = value
    return coefficients


def continuous(breaks: Floats, coefficients: Floats, sine: bool = False) -> Data:
    """A piecewise polynomial without discontinuities."""
    jumps = np.zeros(len(breaks))
    return Data(breaks, coefficients, jumps, sine)
