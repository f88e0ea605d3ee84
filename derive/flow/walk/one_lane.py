"""One lane of the integrator as plain Python, with floats or any other numbers that mpmath's functions take.

The text of the integrator runs here as it stands: what it says about vectors means one number, a mask a truth value,
and a piece of an `if` on a mask the lane itself. Tests compare it with what is written from it in C and in NumPy.
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
    """The members of an enumeration of the layout."""
    row = layout.NUMBERED[name]
    return SimpleNamespace(**{x: k for k, x in enumerate(row.members, row.first)})


Kind, Status, Passed, Pending, Event, Note = map(_codes, ("Kind", "Status", "Passed", "Pending", "Event", "Note"))
Limit: Any = SimpleNamespace(**layout.LIMITS)
Share: Any = SimpleNamespace(**layout.SHARES)


def up(first: int, last: int) -> range:
    """From the first number to the last."""
    return range(first, last + 1)


def down(first: int, last: int) -> range:
    """From the first number down to the last."""
    return range(first, last - 1, -1)


def where(chosen: M, a: V, b: V) -> V:
    return a if chosen else b


def minimum(a: V, b: V) -> V:
    return a if a < b else b


def maximum(a: V, b: V) -> V:
    return b if a < b else a


def any_lane(which: M) -> bool:
    return bool(which)


all_lanes = any_lane


def none_of(s: Lanes) -> bool:
    """The mask of no lane."""
    return False


def greatest(x: V) -> int:
    """The greatest of integers, of all lanes; here the one."""
    return int(x)


least = greatest
integer = greatest
lanes_in = greatest


def number(k: Any) -> Any:
    return float(k)


def new_series() -> list[Any]:
    return [0.0] * layout.STRIDE


numbers = new_series


def tail(p: S) -> S:
    """A series without its constant term."""
    return p[1:]


def log2_of(x: V) -> float:
    """log2 |x| with 40 bits behind the point, straight between powers of two, as `radius_of_convergence` takes it."""
    significand, exponent = math.frexp(float(abs(x)))
    return float(math.floor((exponent + 2.0 * significand - 2.0) * 2.0**40)) if x else -1023.0 * 2.0**40


def power_of_two(y: float) -> float:
    """The inverse of `log2_of`."""
    exponent, share = divmod(min(max(float(y), -1000.0 * 2.0**40), 1000.0 * 2.0**40) * 2.0**-40, 1.0)
    return math.ldexp(1.0 + share, int(exponent))


def _of(name: str) -> Callable[..., Any]:
    """A function of floats, or of mpmath's numbers."""

    def function(*x: Any) -> Any:
        space = math if all(isinstance(a, float) for a in x) else mpmath
        return getattr(space, name)(*x)

    return function


sin, cos, log, hypot, isnan = map(_of, ("sin", "cos", "log", "hypot", "isnan"))
# What the text asks of a lane: of its tables, of its program, and to keep records.


def break_of(lane: Lane, t: T, piece: int) -> Any:
    """Where a piece begins, in the table's own argument."""
    return t.breaks[piece]


def jump_of(lane: Lane, t: T, piece: int) -> Any:
    """By how much a function of time jumps where a piece begins."""
    return t.jumps[piece]


def constant_of(lane: Lane, t: T, piece: int) -> Any:
    """The first of the coefficients of a piece."""
    return t.polynomials[piece][0]


def coefficients_of(lane: Lane, t: T, piece: int, terms: A) -> None:
    """The coefficients of a piece, in powers of what is beyond its break."""
    terms[: t.terms] = t.polynomials[piece]


def prologue(s: Lanes, which: M) -> None:
    """The numbers of the phase that begins."""
    s.prologue()


def operate(s: Lanes, n: int) -> None:
    """Coefficient n of every register that the rates need."""
    s.operate(n)


def operate_later(s: Lanes, n: int) -> None:
    """Coefficients below n of the others."""


def note(lane: Lane, event: int) -> None:
    """An event of the motion."""
    lane.notes.append((event, lane.time, lane.rotation, lane.direction))


def read_samples(lane: Lane, begin: V, end: V, moving: int, top: int) -> None:
    """The states at sample times, which this lane does not keep."""
