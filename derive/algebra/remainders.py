"""Functions that are not computed as they are defined, above all a function minus its leading Taylor terms.

Where a formula cancels, a function f is near its Taylor head and the heads drop out by algebra. What is left is
``Remainder(f, n, x)`` = (f(x) - its terms below x**n)/x**n, which has a series of its own and does not cancel.
Each such function knows its definition (`unfold` puts it back), so that a stable form is proved equal to a closed
form, and how it is computed (`lower`), so that a `Program` can be made of it.
"""

from functools import cache

from sympy import (
    Abs,
    Add,
    Expr,
    Function,
    FunctionClass,
    Lambda,
    Max,
    Min,
    Rational,
    Symbol,
    atanh,
    cos,
    exp,
    log,
    pi,
    sin,
    tan,
)
from sympy.codegen.cfunctions import expm1 as expm1
from sympy.codegen.cfunctions import log1p as log1p
from sympy.polys.ring_series import rs_series

EPS = Rational(1, 2**53)
X = Symbol("x_", real=True)


class Select(Function):
    """``Select(x, y, p, q)`` is p where x < y, else q. Unlike a Piecewise, SymPy never folds it or its guards away."""

    nargs = 4


class Horner(Function):
    """A polynomial: its argument, then its coefficients, lowest first. SymPy never expands it."""


class Exp(Function):
    """exp, which SymPy does not turn into a power."""


class Primitive(Function):
    """A function with a definition and a separate way to compute it."""

    def definition(self) -> Expr:
        """Its definition."""
        raise NotImplementedError

    def lower(self) -> Expr:
        """How it is computed."""
        raise NotImplementedError


def unfold(expression: Expr) -> Expr:
    """Replace every primitive by its definition, and Horner's schemes by polynomials."""

    def polynomial(x: Expr, *coefficients: Expr) -> Expr:
        return Add(*(c * x**n for n, c in enumerate(coefficients)))

    expression = expression.replace(Horner, polynomial)
    expression = expression.replace(log1p, lambda x: log(1 + x))
    expression = expression.replace(expm1, lambda x: exp(x) - 1)
    return expression.replace(lambda e: isinstance(e, Primitive), lambda e: unfold(e.definition()))


class HalfTan(Primitive):
    """tan(x/2) for 0 <= x <= pi/2, as sin x/(1 + cos x)."""

    nargs = 1

    def definition(self) -> Expr:
        return tan(self.args[0] / 2)

    def lower(self) -> Expr:
        x = self.args[0]
        return x * Remainder(sin, 1, x) / (1 + cos(x))


# The Taylor series of a remainder is summed for the sine as far as anybody asks, to pi, and for artanh up to a seam;
# its definition is computed beyond, with the end at 1 moved into the numbers.
SEAM = Rational(2, 5)
LAST = 1 - EPS


class Remainder(Primitive):
    """(f(x) - its Taylor terms below x**n)/x**n, of an odd function f and an odd n."""

    nargs = 3

    def __new__(cls, f: FunctionClass | Lambda, n: int, x: Expr) -> "Remainder":
        return super().__new__(cls, f if isinstance(f, Lambda) else Lambda(X, f(X)), n, x)

    @property
    def parts(self) -> tuple[Expr, int, Expr]:
        """f as an expression in `X`, n and x."""
        f, n, x = self.args
        return f.expr, int(n), x

    def definition(self) -> Expr:
        f, n, x = self.parts
        head = sum(c * X**k for k, c in enumerate(taylor(f)[:n]))
        return ((f - head) / X**n).subs(X, x)

    def series(self) -> list[Rational]:
        """Its Taylor coefficients in x**2.

        Enough terms that the first neglected one is below an eighth of 2**-53 of the leading one.
        """
        f, n, _ = self.parts
        terms = list(taylor(f)[n::2])
        farthest = (pi if f == sin(X) else SEAM) ** 2
        for count in range(1, len(terms)):
            neglected = abs(terms[count]) * farthest**count
            if neglected < abs(terms[0]) * EPS / 8:
                return terms[:count]
        raise ValueError(f"the series of {self} converges too slowly")

    def lower(self) -> Expr:
        f, n, x = self.parts
        if f == sin(X):
            return Horner(x**2, *self.series())
        size = Abs(x)
        near = Max(Min(x, SEAM), -SEAM)
        far = Min(Select(size, SEAM, SEAM, x), LAST)
        beyond = self.func(self.args[0], n, far).definition()
        return Select(size, SEAM, Horner(near**2, *self.series()), beyond)


@cache
def taylor(f: Expr) -> tuple[Rational, ...]:
    """Taylor coefficients at 0 from SymPy's ring of power series, which lacks artanh."""
    f = f.replace(atanh, lambda x: (log(1 + x) - log(1 - x)) / 2)
    terms = rs_series(f, X, 60).as_expr().as_poly(X)
    return tuple(terms.coeff_monomial(X**k) for k in range(60))
