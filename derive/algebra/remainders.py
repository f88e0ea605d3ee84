"""Functions with separate definitions and computations, above all a function minus its leading Taylor terms.

Where a formula cancels, a function f is close to its leading Taylor terms, which cancel by algebra. The rest is
``Remainder(f, n, x)`` = (f(x) - its terms below x**n)/x**n, which has its own series and does not cancel. Each such
function has a definition, which `unfold` inserts to prove a stable form equal to a closed form, and a method `lower`,
which expresses its computation for a `Program`.
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
    """Function ``Select(x, y, p, q)``, which is p where x < y and otherwise q.

    Unlike Piecewise, SymPy never simplifies it.
    """

    nargs = 4


class Horner(Function):
    """Polynomial by its argument and its coefficients, lowest first. SymPy never expands it."""


class Exp(Function):
    """Exponential function that SymPy does not convert to a power."""


class Primitive(Function):
    """Function with a definition and a separate computation."""

    def definition(self) -> Expr:
        """Return the definition."""
        raise NotImplementedError

    def lower(self) -> Expr:
        """Return the expression by which the function is computed."""
        raise NotImplementedError


def unfold(expression: Expr) -> Expr:
    """Return an expression with every primitive replaced by its definition and Horner's schemes by polynomials."""

    def polynomial(x: Expr, *coefficients: Expr) -> Expr:
        return Add(*(c * x**n for n, c in enumerate(coefficients)))

    expression = expression.replace(Horner, polynomial)
    expression = expression.replace(log1p, lambda x: log(1 + x))
    expression = expression.replace(expm1, lambda x: exp(x) - 1)
    return expression.replace(lambda e: isinstance(e, Primitive), lambda e: unfold(e.definition()))


class HalfTan(Primitive):
    """Function tan(x/2) for 0 <= x <= pi/2, computed as sin x/(1 + cos x)."""

    nargs = 1

    def definition(self) -> Expr:
        return tan(self.args[0] / 2)

    def lower(self) -> Expr:
        x = self.args[0]
        return x * Remainder(sin, 1, x) / (1 + cos(x))


# The Taylor series of a remainder is summed up to pi for the sine, and up to a seam for artanh. Beyond the seam the
# definition is computed, with its argument limited to the largest double below 1.
SEAM = Rational(2, 5)
LAST = 1 - EPS


class Remainder(Primitive):
    """Function (f(x) - its Taylor terms below x**n)/x**n of an odd function f and an odd n."""

    nargs = 3

    def __new__(cls, f: FunctionClass | Lambda, n: int, x: Expr) -> "Remainder":
        return super().__new__(cls, f if isinstance(f, Lambda) else Lambda(X, f(X)), n, x)

    @property
    def parts(self) -> tuple[Expr, int, Expr]:
        """Function f as an expression in `X`, and n and x."""
        f, n, x = self.args
        return f.expr, int(n), x

    def definition(self) -> Expr:
        f, n, x = self.parts
        head = sum(c * X**k for k, c in enumerate(taylor(f)[:n]))
        return ((f - head) / X**n).subs(X, x)

    def series(self) -> list[Rational]:
        """Return its Taylor coefficients in x**2.

        The first neglected term is below an eighth of 2**-53 of the leading term.
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
    """Return Taylor coefficients at 0 from SymPy's ring of power series, which lacks artanh."""
    f = f.replace(atanh, lambda x: (log(1 + x) - log(1 - x)) / 2)
    terms = rs_series(f, X, 60).as_expr().as_poly(X)
    return tuple(terms.coeff_monomial(X**k) for k in range(60))
