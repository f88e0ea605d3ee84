"""Functions that are not computed as they are defined, and SymPy's own without its automatic rewriting.

``SineRest`` is a sine minus its argument, which cancels near 0. It knows its definition (`unfold` restores it), so that
a form with it is proved equal to a closed form, and how it is computed (`SineRest.lower`).
"""

from math import factorial

from sympy import Expr, Function, Rational, exp, log, pi, sin
from sympy.codegen.cfunctions import expm1 as expm1
from sympy.codegen.cfunctions import log1p as log1p


class Select(Function):
    """Function ``Select(x, y, p, q)``, which is p where x < y and otherwise q.

    Unlike Piecewise, SymPy never simplifies it.
    """

    nargs = 4


class Horner(Function):
    """Polynomial by its argument and its coefficients, lowest first. SymPy never expands it."""


class Exp(Function):
    """Exponential function that SymPy does not convert to a power."""


class SineRest(Function):
    """(sin(x) - x)/x**3, for |x| <= pi."""

    nargs = 1

    def lower(self) -> Expr:
        """Return the polynomial that computes it, without terms below 2**-56 of the first."""
        coefficients = [Rational((-1) ** k, factorial(2 * k + 1)) for k in range(1, 30)]
        least = Rational(1, 2**56) * abs(coefficients[0])
        (x,) = self.args
        return Horner(x**2, *(c for k, c in enumerate(coefficients) if abs(c) * pi ** (2 * k) >= least))


def unfold(expression: Expr) -> Expr:
    """Return an expression with `SineRest`, `log1p` and `expm1` replaced by their definitions."""
    expression = expression.replace(log1p, lambda x: log(1 + x))
    expression = expression.replace(expm1, lambda x: exp(x) - 1)
    return expression.replace(SineRest, lambda x: (sin(x) - x) / x**3)
