"""Operations of programs: their text in Python and C, and their exact meaning, in one table.

In a template ``{0}`` is the first operand. C has templates for single numbers and for vectors of lanes. ``binds`` is
the precedence of the text (comparison 0, sum 1, product 2, sign 3, call 9), and ``needs`` the precedence that each
operand requires. An operation without a template is not available in that language. The meaning applies to arrays and
rounds as every machine does. NumPy's operations follow IEEE 754, and the fused multiply-add, which NumPy lacks, is
composed of them without error.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Abs, Max, Min, atanh, cos, exp, log, sin, tan

from derive.algebra.remainders import Select, expm1, log1p

Floats = NDArray[np.float64]

_SAFE = 2.0**-900  # a product of this size has an error term far above the subnormal numbers
_THREE_QUARTERS = 0x3FE8000000000000  # bits of 0.75: the significand lies in [0.75, 1.5)


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Return fl(a + b) and its rounding error, also for operations collected for a program."""
    total = a + b
    of_b = total - a
    return total, (a - (total - of_b)) + (b - of_b)


def _halves(x: Floats) -> tuple[Floats, Floats]:
    """Return the Veltkamp splitting of x into a high and a low part; products of such parts are exact."""
    scaled = 134217729.0 * x  # 2**27 + 1
    high = scaled - (scaled - x)
    return high, x - high


def fma(a: Floats, b: Floats, c: Floats) -> Floats:
    """Return a b + c, rounded once.

    It is the sum of the product's two halves and c, first rounded to odd (Boldo and Melquiond). If a part would
    underflow, fractions are used.
    """
    a, b, c = np.broadcast_arrays(a, b, c)
    product = a * b
    a_high, a_low = _halves(a)
    b_high, b_low = _halves(b)
    rest = product - a_high * b_high
    rest = (rest - a_low * b_high) - a_high * b_low
    low = a_low * b_low - rest
    inner, inner_low = two_sum(c, low)
    total, total_low = two_sum(product, inner)
    plain = (a == 0) | (b == 0)
    result = np.where(plain, product + c, total + _to_odd(inner_low, total_low))
    small_product = np.abs(product) < _SAFE
    small_c = (c != 0) & (np.abs(c) < _SAFE)
    inexact = ~plain & (small_product | small_c)
    exact = []
    for x, y, z in zip(*(x[inexact].tolist() for x in (a, b, c)), strict=True):
        exact.append(float(Fraction(x) * Fraction(y) + Fraction(z)))
    result[inexact] = exact
    return result


def _to_odd(a: Floats, b: Floats) -> Floats:
    """Return a + b rounded to odd: the exact sum, or its neighbour with an odd last bit."""
    rounded, lost = two_sum(a, b)
    bits = rounded.view(np.int64)
    towards_sum = np.where((lost > 0) == (rounded > 0), 1, -1)
    inexact_and_even = (lost != 0) & (bits & 1 == 0)
    to_odd = np.where(inexact_and_even, bits + towards_sum, bits)
    return np.asarray(to_odd.view(np.float64))


def exponent(x: Floats) -> Floats:
    """Return k of x = significand 2**k for a normal x > 0."""
    return ((x.view(np.int64) - _THREE_QUARTERS) >> 52).astype(np.float64)


def significand(x: Floats) -> Floats:
    """Return x 2**-k, in [0.75, 1.5)."""
    bits = x.view(np.int64)
    k = (bits - _THREE_QUARTERS) >> 52
    scaled = bits - (k << 52)
    return np.asarray(scaled.view(np.float64))


@dataclass(frozen=True)
class Operation:
    """Kind of operation, or function that is called; ``symbol`` is SymPy's class."""

    python: str
    c: str
    vector: str
    meaning: Callable[..., Any]
    symbol: Any = None
    binds: int = 9
    needs: tuple[int, ...] = (0, 0, 0)


def _infix(sign: str, meaning: Callable[..., Any], binds: int, right: int) -> Operation:
    """Return the operation of a sign between two operands.

    ``binds`` is the precedence of the text, and ``right`` the one that its right operand requires.
    """
    text = f"{{0}} {sign} {{1}}"
    return Operation(text, text, text, meaning, None, binds, (binds, right))


def _call(name: str, symbol: Any, c: str = "", vector: str = "") -> Operation:
    """Return the operation that calls NumPy's function ``name``; an empty text means that C has none."""
    return Operation(f"{{space}}.{name}({{0}})", c, vector, getattr(np, name), symbol)


OPERATIONS = {
    "add": _infix("+", np.add, 1, 2),
    "sub": _infix("-", np.subtract, 1, 2),
    "mul": _infix("*", np.multiply, 2, 3),
    "div": _infix("/", np.divide, 2, 3),
    "neg": Operation("-{0}", "-{0}", "-{0}", np.negative, None, 3, (4,)),
    **{str(x): _call(str(x), x, vector=f"IN(map)({x}, {{0}})") for x in (sin, cos, tan, exp, expm1, log, log1p)},
    "sqrt": _call("sqrt", None, "sqrt({0})", "IN(map)(sqrt, {0})"),
    "abs": _call("abs", Abs, "fabs({0})", "IN(choose)({0} < 0.0, -{0}, {0})"),
    "min": Operation(
        "{space}.minimum({0}, {1})", "SMALLER({0}, {1})", "IN(choose)({0} < {1}, {0}, {1})", np.minimum, Min
    ),
    "max": Operation(
        "{space}.maximum({0}, {1})", "LARGER({0}, {1})", "IN(choose)({0} < {1}, {1}, {0})", np.maximum, Max
    ),
    "less": Operation(
        "{0} < {1}", "{0} < {1}", "IN(choose)({0} < {1}, (V){{0}} + 1.0, (V){{0}})", np.less, None, 0, (1, 1)
    ),
    "select": Operation(
        "{space}.where({0}, {1}, {2})", "SELECT({0}, {1}, {2})", "IN(choose)({0} > 0.0, {1}, {2})", np.where, Select
    ),
    "lost": Operation("lost({0}, {1})", "lost({0}, {1})", "", lambda a, b: two_sum(a, b)[1]),
    "fma": Operation("", "FMA({0}, {1}, {2})", "", fma),
    "exponent": Operation("", "exponent_of({0})", "", exponent),
    "significand": Operation("", "significand_of({0})", "", significand),
    "arctanh": _call("arctanh", atanh),
}
