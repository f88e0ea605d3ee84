"""The operations of programs: one table says how each is written in Python and in C, and what it means exactly.

In a template ``{0}`` is the first operand. ``binds`` says how tightly the text holds together (a comparison 0, a sum 1,
a product 2, a sign 3, a call 9) and ``needs`` how tightly each operand has to. What has no template in a language has
no place there.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from derive.code.arithmetic import exponent, fma, significand


@dataclass(frozen=True)
class Operation:
    """One kind of operation, or one function that is called."""

    python: str
    c: str
    meaning: Callable[..., Any]
    binds: int = 9
    needs: tuple[int, ...] = (0, 0, 0)


def _infix(sign: str, meaning: Callable[..., Any], binds: int, right: int) -> Operation:
    return Operation(f"{{0}} {sign} {{1}}", f"{{0}} {sign} {{1}}", meaning, binds, (binds, right))


def _library(name: str) -> Operation:
    return Operation(f"{{space}}.{name}({{0}})", "", getattr(np, name))


OPERATIONS = {
    "add": _infix("+", np.add, 1, 2),
    "sub": _infix("-", np.subtract, 1, 2),
    "mul": _infix("*", np.multiply, 2, 3),
    "div": _infix("/", np.divide, 2, 3),
    "neg": Operation("-{0}", "-{0}", np.negative, 3, (4,)),
    "less": Operation("{0} < {1}", "{0} < {1}", np.less, 0, (1, 1)),
    "select": Operation("{space}.where({0}, {1}, {2})", "SELECT({0}, {1}, {2})", np.where),
    "min": Operation("{space}.minimum({0}, {1})", "SMALLER({0}, {1})", np.minimum),
    "max": Operation("{space}.maximum({0}, {1})", "LARGER({0}, {1})", np.maximum),
    "fma": Operation("", "FMA({0}, {1}, {2})", fma),
    "sqrt": Operation("{space}.sqrt({0})", "sqrt({0})", np.sqrt),
    "abs": Operation("{space}.abs({0})", "fabs({0})", np.abs),
    "exponent": Operation("", "exponent_of({0})", exponent),
    "significand": Operation("", "significand_of({0})", significand),
} | {x: _library(x) for x in (
    "sin", "cos", "tan", "exp", "expm1", "log", "log1p", "arctan", "arctanh", "tanh", "cosh", "sinh", "sign")
}  # fmt: skip
