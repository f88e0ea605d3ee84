"""Operations of programs: their text in Python and C, and their exact meaning, in one table.

In a template ``{0}`` is the first operand. Polynomials also have ``{degree}`` and ``{coefficients}``. C has templates
for single numbers and for vectors of lanes. ``binds`` is the precedence of the text (comparison 0, sum 1, product 2,
sign 3, call 9), and ``needs`` the precedence that each operand requires. An operation without a template is not
available in that language. The meaning applies to arrays and rounds as every machine does. NumPy's operations follow
IEEE 754; the fused multiply-add, which NumPy lacks, is exact before it is rounded.
"""

import runpy
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray
from sympy import Abs, Max, Min, atanh, cos, exp, log, sin, sqrt, tan

from derive.algebra.remainders import Select, expm1, log1p
from derive.kinds import Coefficients

Floats = NDArray[np.float64]

TEMPLATES = Path(__file__).resolve().parent / "templates"
HORNER = runpy.run_path(str(TEMPLATES / "_evaluate.py"))["horner"]  # of the generated modules
EXACT = 4400  # bits that contain the sum of any product and number


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Return fl(a + b) and its rounding error, also for operations collected for a program."""
    total = a + b
    of_b = total - a
    return total, (a - (total - of_b)) + (b - of_b)


@np.vectorize(otypes=[np.float64])
def _multiply_add(a: float, b: float, c: float) -> float:
    """Return a b + c, rounded once if the precision suffices; balls have no sign of a zero."""
    return float(arb(a) * arb(b) + arb(c)) if a and b else a * b + c


def fma(a: Floats, b: Floats, c: Floats) -> Floats:
    """Return a b + c, rounded once."""
    with ctx.workprec(EXACT):
        return np.asarray(_multiply_add(a, b, c))


def fused_horner(x: Floats, coefficients: Coefficients) -> Floats:
    """Return the polynomial with these coefficients, lowest first, by multiply-adds that are rounded once."""
    *others, last = coefficients
    result = np.asarray(last)
    for c in reversed(others):
        result = fma(result, x, np.asarray(c))
    return result


def exponent(x: Floats) -> Floats:
    """Return k of x = significand 2**k for a normal x > 0."""
    half_to_one, power = np.frexp(x)
    return np.asarray(power - (half_to_one < 0.75), np.float64)


def significand(x: Floats) -> Floats:
    """Return x 2**-k, in [0.75, 1.5)."""
    return np.asarray(x * 2.0 ** -exponent(x))


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
    "sqrt": _call("sqrt", sqrt, "sqrt({0})", "IN(map)(sqrt, {0})"),
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
    "integer": _call("rint", None, "NEAREST({0})"),
    "horner": Operation("horner({0}, ({coefficients}))", "POLY{degree}({0}, {coefficients})", "", HORNER),
    "fused_horner": Operation("", "POLY{degree}({0}, {coefficients})", "", fused_horner),
    "fma": Operation("", "FMA({0}, {1}, {2})", "", fma),
    "exponent": Operation("", "exponent_of({0})", "", exponent),
    "significand": Operation("", "significand_of({0})", "", significand),
    "arctanh": _call("arctanh", atanh),
}
