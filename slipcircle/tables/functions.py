"""Friction laws given as Python functions of slip, sampled as piecewise polynomials as far as lanes slip."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from generated import layout as ix
from slipcircle.base.kinds import Floats, Function
from slipcircle.core.problem.problem import Problem
from slipcircle.core.scene.piecewise import Data
from slipcircle.tables.interpolation import NODES, ORDERS, POWERS, TERMS, TO_CHEBYSHEV, continuous

FIRST_SLIP = 1 / 256  # slip over the radius up to which a function is sampled initially
_CHECKED = np.cos(np.linspace(0.0, np.pi, 2 * TERMS + 1))
_AT_CHECKED = chebvander(_CHECKED, TERMS - 1)
_PLACES = 1.0 + np.concatenate([NODES, _CHECKED])  # distance from the left end over half a width
CLOSE = 1e-13  # error of a piece relative to its greatest value
NARROWEST = 2.0**-40  # least width of a piece relative to the slip up to which the function is sampled


def first_table(function: Function, radius: Any) -> Data:
    """Return a function of slip in m, sampled up to `FIRST_SLIP` times the greatest radius."""
    return sampled(function, FIRST_SLIP * float(np.max(radius)))


def extend(problem: Problem, cells: Floats) -> None:
    """Extend the tables of a problem's functions to the slip of lanes.

    `cells` are the variables of the lanes, one column per lane.
    """
    for name, function in problem.functions.items():
        slip = cells[ix.SLIP] * cells[problem.program.places[f"{name}.SCALE"]]
        farthest = float(np.max(slip))
        farthest *= 1.0 + 1e-12
        table = problem.data[name]
        end = float(table.breaks[-1])
        while end <= farthest:
            table = sampled(function, 2 * end, table)
            end = float(table.breaks[-1])
        problem.data[name] = table


def extend_to_end(problem: Problem, cells: Floats, integrate: Callable[..., object]) -> None:
    """Extend the tables until the first waiting lane reaches its end.

    `cells` are the variables of all lanes, and `integrate` is called for this lane alone.
    """
    which = np.flatnonzero(cells[ix.STATUS] == ix.NEED)[:1]
    one = cells[:, which]
    while one[ix.STATUS, 0] == ix.NEED:
        extend(problem, one)
        one[ix.OMEGA] *= one[ix.DIRECTION]
        one[ix.STATUS] = ix.START
        integrate(problem.program, problem.tables(which), one)


def sampled(function: Function, end: float, table: Data | None = None) -> Data:
    """Return a Python function of slip up to ``end`` as a piecewise polynomial.

    The error is 1e-13 of its greatest value. A known table is extended.

    Raises
    ------
    ValueError
        If the function returns anything but non-negative numbers in the shape of its argument, or is not smooth.
    """
    breaks = []
    pieces = []
    left = 0.0
    if table:
        *breaks, left = table.breaks.tolist()
        pieces = list(table.coefficients[:-1])
    width = end - left
    while left < end:
        width = min(width, end - left)
        piece = _piece(function, left, width)
        if piece is not None:
            breaks.append(left)
            pieces.append(piece)
            left += width
            width *= 2
            if end - left < NARROWEST * end:  # rounding of the sum of widths
                left = end
            continue
        width /= 2
        if width < NARROWEST * end:
            raise ValueError(
                f"friction: the function changes too sharply near {left:.17g} to be followed; give a law by "
                "name or a table whose kinks are known"
            )
    breaks.append(end)
    pieces.append(pieces[-1])
    return continuous(np.array(breaks), np.array(pieces))._replace(open=True)


def _piece(function: Function, left: float, width: float) -> Floats | None:
    """Return coefficients in powers of the distance to the left end, or None if they are not accurate enough.

    The piece extends from `left` over `width`, both slips in m. The constant term is the first of the `TERMS`
    coefficients.
    """
    half = width / 2
    values = _values(function, left + half * _PLACES)
    chebyshev = TO_CHEBYSHEV @ values[:TERMS]
    error = np.abs(_AT_CHECKED @ chebyshev - values[TERMS:])
    greatest = np.abs(values).max()
    if error.max() > CLOSE * greatest:
        return None
    return POWERS @ chebyshev / half**ORDERS


def _values(function: Function, slip: Floats) -> Floats:
    """Return the values of a user's function at slips in m, as floats of the same shape, after checking them."""
    try:
        values = np.asarray(function(slip))
        if values.dtype.kind == "c":
            raise ValueError("complex numbers")
        values = values.astype(float)
    except Exception as error:  # any exception means an invalid function
        reason = f"must take an array of numbers and return one; it says {type(error).__name__}: {error}"
        raise ValueError(f"friction: {reason}") from error
    if values.ndim == 0:
        values = np.full(slip.shape, float(values))
    shape = slip.shape
    if values.shape != shape:
        reason = f"returns shape {values.shape} for an argument of shape {slip.shape}: must be alike"
        raise ValueError(f"friction: {reason}")
    bad = ~np.isfinite(values) | (values < 0.0)
    if np.any(bad):
        first = np.argmax(bad)
        at = float(slip[first])
        value = float(values[first])
        raise ValueError(f"friction({at:.6g}) = {value!r}: must be a number of at least 0")
    return values
