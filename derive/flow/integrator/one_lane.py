"""Names that the text of the integrator uses, so that its modules are also plain Python.

Functions of numbers are executed for one lane by tests and, with symbols, by proofs: a vector is one number, a mask a
truth value. Operations on programs, tables and records exist in the generated integrators only.
"""

import math
from collections.abc import Iterator
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


def _halvings(finest: int) -> Iterator[float]:
    """Yield sin(u)^2 at the inner nodes of the trapezoidal rule on [0, pi/4], halving by halving."""
    intervals = 1
    while intervals <= finest:
        for k in range(1, intervals + 1, 2):
            yield float(mpmath.sin(mpmath.pi * k / (4 * intervals)) ** 2)
        intervals *= 2


def _gauss(count: int) -> Iterator[tuple[float, float]]:
    """Yield the squares of the positive nodes of Gauss's rule with twice as many nodes on [-1, 1], and the weights."""
    with mpmath.workdps(40):
        n = 2 * count
        for k in range(count, 0, -1):
            x = mpmath.findroot(lambda x: mpmath.legendre(n, x), mpmath.cos(mpmath.pi * (k - 0.25) / (n + 0.5)))
            slope = n * mpmath.legendre(n - 1, x) / (1 - x * x)
            yield float(x * x), float(2 / ((1 - x * x) * slope * slope))


# Nodes of rules in the closed form of a phase, `derive.flow.integrator.swing`.
SINES = tuple(_halvings(16))
PLACES, WEIGHTS = zip(*_gauss(10), strict=True)


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


def new_series() -> list[Any]:
    """Return a series of zeros."""
    return [0.0] * layout.STRIDE


def generated(*_: Any) -> Any:
    """Raise an error, in place of an operation of the generated integrators."""
    raise NotImplementedError


any_lane: Any = bool
number: Any = float
minimum: Any = min
sqrt = math.sqrt
numbers = maximum = all_lanes = none_of = greatest = least = integer = lanes_in = tail = log2_of = power_of_two = (
    generated
)
sin = cos = log = hypot = isnan = break_of = jump_of = constant_of = coefficients_of = generated
prologue = operate = operate_later = note = read_samples = generated
