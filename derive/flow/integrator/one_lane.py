"""Definitions that execute the integrator for one lane as plain Python, with floats or numbers of mpmath.

The text of the integrator is executed unchanged. A vector is one number, a mask a truth value, and the part of an `if`
on a mask the lane itself. Tests compare the results with the integrators in C and in NumPy.
"""

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import mpmath

from derive.flow import layout

V = Any  # a number of each lane
M = Any  # a truth value of each lane
S = Any  # a series: coefficients, each a number of each lane
A = Any  # numbers of one lane
T = Any  # a table
Lanes = Any
Lane = Any
N = int  # a number that all lanes share

EPS = 2.0**-52
INFINITY = math.inf


def _codes(name: str) -> Any:
    """Return the members of an enumeration of the layout."""
    row = layout.NUMBERED[name]
    return SimpleNamespace(**{x: k for k, x in enumerate(row.members, row.first)})


Kind, Status, Passed, Pending, Event, Note = map(_codes, ("Kind", "Status", "Passed", "Pending", "Event", "Note"))
Limit: Any = SimpleNamespace(**layout.LIMITS)
Share: Any = SimpleNamespace(**layout.SHARES)


def up(first: int, last: int) -> range:
    """Return the numbers from ``first`` up to ``last``."""
    return range(first, last + 1)


def down(first: int, last: int) -> range:
    """Return the numbers from ``first`` down to ``last``."""
    return range(first, last - 1, -1)


def where(chosen: M, a: V, b: V) -> V:
    """Return ``a`` where the mask is true, otherwise ``b``."""
    return a if chosen else b


def minimum(a: V, b: V) -> V:
    """Return the smaller value."""
    return a if a < b else b


def maximum(a: V, b: V) -> V:
    """Return the greater value."""
    return b if a < b else a


def any_lane(which: M) -> bool:
    """Return whether the mask is true for a lane."""
    return bool(which)


all_lanes = any_lane


def none_of(s: Lanes) -> bool:
    """Return the mask without lanes."""
    return False


def greatest(x: V) -> int:
    """Return the greatest integer over all lanes, here of one lane."""
    return int(x)


least = greatest
integer = greatest
lanes_in = greatest


def number(k: Any) -> Any:
    """Return an integer as a number."""
    return float(k)


def new_series() -> list[Any]:
    """Return a series of zeros."""
    return [0.0] * layout.STRIDE


numbers = new_series


def tail(p: S) -> S:
    """Return a series without its constant term."""
    return p[1:]


def log2_of(x: V) -> float:
    """Return log2 |x| with 40 fractional bits, linear between powers of two, for `radius_of_convergence`."""
    significand, exponent = math.frexp(float(abs(x)))
    return float(math.floor((exponent + 2.0 * significand - 2.0) * 2.0**40)) if x else -1023.0 * 2.0**40


def power_of_two(y: float) -> float:
    """Return the inverse of `log2_of`."""
    exponent, share = divmod(min(max(float(y), -1000.0 * 2.0**40), 1000.0 * 2.0**40) * 2.0**-40, 1.0)
    return math.ldexp(1.0 + share, int(exponent))


def _of(name: str) -> Callable[..., Any]:
    """Return a function of floats, or of mpmath numbers."""

    def function(*x: Any) -> Any:
        space = math if all(isinstance(a, float) for a in x) else mpmath
        return getattr(space, name)(*x)

    return function


sin, cos, log, sqrt, hypot, isnan = map(_of, ("sin", "cos", "log", "sqrt", "hypot", "isnan"))
# Operations of a lane on its tables, its program and its records.


def break_of(lane: Lane, t: T, piece: int) -> Any:
    """Return the left end of a piece in the table's argument."""
    return t.breaks[piece]


def jump_of(lane: Lane, t: T, piece: int) -> Any:
    """Return the jump of a function of time at the left end of a piece."""
    return t.jumps[piece]


def constant_of(lane: Lane, t: T, piece: int) -> Any:
    """Return the first coefficient of a piece."""
    return t.polynomials[piece][0]


def coefficients_of(lane: Lane, t: T, piece: int, terms: A) -> None:
    """Copy the coefficients of a piece, in powers of the distance from its left end."""
    terms[: t.terms] = t.polynomials[piece]


def prologue(s: Lanes, which: M) -> None:
    """Compute the numbers of the phase that begins."""
    s.prologue()


def operate(s: Lanes, n: int) -> None:
    """Compute coefficient n of every register that the rates need."""
    s.operate(n)


def operate_later(s: Lanes, n: int) -> None:
    """Compute the coefficients below n of the other registers."""


def note(lane: Lane, event: int) -> None:
    """Log an event of the motion."""
    lane.notes.append((event, lane.time, lane.rotation, lane.direction))


def read_samples(lane: Lane, begin: V, end: V, moving: int, top: int) -> None:
    """Evaluate the states at sample times, which this lane does not store."""
