"""Names that the text of the integrator uses, so that its modules are also plain Python.

Functions of numbers are executed for one lane by tests and, with symbols, by proofs: a vector is one number, a mask a
truth value. Operations on programs, tables and records exist in the generated integrators only.
"""

import math
from types import SimpleNamespace
from typing import Any

import mpmath
import sympy

from derive.flow import layout

V = Any  # a number of each lane
M = Any  # a truth value of each lane
S = Any  # a series: coefficients, each a number of each lane
T = Any  # a table
Lanes = Any
N = int  # a number that all lanes share

EPS = 2.0**-52
INFINITY = math.inf

# Nodes of the trapezoidal rule in `derive.flow.integrator.swing`, sin(u)^2 for u in [0, pi/4], and coefficients of the
# series of cosines from sums and differences over pairs of mirrored nodes, each divided by its number.
SINES = tuple(float(mpmath.sin(mpmath.pi * k / 32) ** 2) for k in range(9))
_MIRRORED = [2, 1, 1, 1, 1, 1, 1, 1, 2]  # times that each node is counted
COSINES = tuple(
    float(mpmath.cospi(mpmath.mpf(m * k) / 16) / times / max(m, 1))
    for m in range(17)
    for k, times in enumerate(_MIRRORED)
)
# Coefficients of the arcsine of z over z in powers of z^2.
LAST_OF_ARCSINE = 20
ARCSINE = tuple(math.comb(2 * k, k) / 4**k / (2 * k + 1) for k in range(LAST_OF_ARCSINE + 1))
_gauss = mpmath.calculus.quadrature.GaussLegendre(mpmath.mp).calc_nodes
# Gauss's rules in `derive.flow.integrator.softening`: nodes on [0, 1], weights on [-1, 1], and weights of the last two
# coefficients of Legendre's series. The rule of SHORTEST nodes is followed by rules of 2, 4 and 8 times as many.
SHORTEST = 6


def _rule(count: int, degree: int) -> list[list[Any]]:
    """Return a row of numbers for each of the ``count`` nodes of a rule of Gauss."""
    rows = []
    for x, weight in sorted(_gauss(degree, 120)):
        row = [0.5 + x / 2, weight]
        for n in (count - 1, count - 2):
            size = (2 * n + 1) * weight
            row.append(size * mpmath.legendre(n, x))
        rows.append([float(number) for number in row])
    return rows


_RULES = [row for k in range(4) for row in _rule(SHORTEST * 2**k, k + 2)]
NODES, SHARES, LAST_SHARES, NEXT_SHARES = map(tuple, zip(*_RULES, strict=True))


def _codes(name: str) -> Any:
    """Return the members of an enumeration of the layout."""
    row = layout.NUMBERED[name]
    return SimpleNamespace(**{x: k for k, x in enumerate(row.members, row.first)})


Kind, Status, Passed, Pending, Event, Note = map(_codes, ("Kind", "Status", "Passed", "Pending", "Event", "Note"))
Limit: Any = SimpleNamespace(**layout.LIMITS)
Share: Any = SimpleNamespace(**layout.SHARES)
RATIO, RATIO_TO_ROUNDING = layout.RATIOS.values()


def up(first: int, last: int) -> range:
    """Return the numbers from ``first`` up to ``last``."""
    return range(first, last + 1)


def down(first: int, last: int) -> range:
    """Return the numbers from ``first`` down to ``last``."""
    return range(first, last - 1, -1)


def where(chosen: M, a: V, b: V) -> V:
    """Return ``a`` where the mask is true, otherwise ``b``."""
    return a if chosen else b


def sqrt(x: V) -> V:
    """Return the square root, exactly if x has symbols."""
    return sympy.sqrt(sympy.nsimplify(x, rational=True).cancel()) if isinstance(x, sympy.Expr) else x**0.5


def expm1(x: V) -> V:
    """Return exp(x) - 1, with many digits if x has."""
    return math.expm1(x) if isinstance(x, float) else mpmath.expm1(x)


def new_series() -> list[Any]:
    """Return a series of zeros."""
    return [0.0] * layout.STRIDE


def generated(*_: Any) -> Any:
    """Raise an error, in place of an operation of the generated integrators."""
    raise NotImplementedError


any_lane: Any = bool
number: Any = float
minimum: Any = min
maximum: Any = max
log1p = math.log1p
tail = generated
greatest = least = generated
all_lanes = none_of = lanes_in = generated
log2_of = power_of_two = generated
sin = cos = log = generated
breaks_at = coefficients_at = jumps_at = last_quiet = generated
prologue = operate = operate_later = generated
note = read_samples = sample_time = keep_sample = generated
