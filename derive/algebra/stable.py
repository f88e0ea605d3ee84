"""Forms without cancellation: stable primitives, and each kernel's stable form, linked by proof to its closed form.

A primitive is a SymPy function that knows its definition (`unfold` puts it back), so a stable form is proved equal
to a closed form symbolically, and that knows how it is computed (`lower`), so that a `Program` can be made of it.
"""

from collections.abc import Iterable
from fractions import Fraction
from functools import cache

import mpmath
import sympy as sp
from sympy.polys.ring_series import rs_atanh, rs_sin

from derive.algebra.prove import prove_zero, refute
from derive.declare.quantities import MOMENTS, QUOTIENTS, RESISTANCE
from derive.declare.symbols import alpha

EPS = Fraction(1, 2**53)


class Select(sp.Function):
    """``Select(x, y, p, q)`` is p where x < y, else q. Unlike a Piecewise, SymPy never folds it or its guards away."""

    nargs = 4


class Stable(sp.Function):
    """A function that is computed otherwise than it is defined."""

    nargs = 1

    def definition(self) -> sp.Expr:
        """What it means."""
        raise NotImplementedError

    def lower(self) -> sp.Expr:
        """How it is computed."""
        raise NotImplementedError

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        x = sp.Dummy("x", real=True)
        return sp.diff(self.func(x).definition(), x).subs(x, self.args[0])

    def _eval_evalf(self, prec: int) -> sp.Expr | None:
        x = self.args[0].evalf(prec)
        if not x.is_Number:
            return None
        if x == 0:
            return sp.limit(self.func(sp.Dummy("x")).definition(), self.func(sp.Dummy("x")).args[0], 0)
        lost = 4 * max(0, -int(mpmath.mag(x._mpf_ if hasattr(x, "_mpf_") else mpmath.mpf(x))))
        return self.definition().subs(self.args[0], x).evalf(int((prec + lost) / 3.3) + 5)


def unfold(expression: sp.Expr) -> sp.Expr:
    """Replace every stable primitive by its definition, and rounding errors by zero."""
    expression = expression.replace(lambda e: isinstance(e, RoundingError), lambda e: sp.Integer(0))
    return expression.replace(lambda e: isinstance(e, Stable), lambda e: unfold(e.definition()))


@cache
def even_series(function: str, first: int, largest: Fraction) -> tuple[sp.Rational, ...]:
    """Taylor coefficients in x**2 of (function(x) without its terms below x**first)/x**first.

    As many as it takes for the first neglected term to stay below an eighth of 2**-53 of the leading one for all
    x**2 <= largest. (The series alternate, or, for artanh, x**2 is well below 1.)
    """
    _, x = sp.ring("x", sp.QQ)
    series = {"sin": rs_sin, "artanh": rs_atanh}[function](x, x, 100)
    found: list[sp.Rational] = []
    for k in range(first, 100, 2):
        c = sp.Rational(str(series.coeff(x**k)))
        found.append(c)
        following = abs(Fraction(str(series.coeff(x ** (k + 2))))) * largest ** ((k + 2 - first) // 2)
        if following < abs(Fraction(str(found[0]))) * EPS / 8:
            return tuple(found)
    raise ValueError(f"the series of {function} is too slow for x**2 <= {largest}")


def slope_series(series: Iterable[sp.Rational]) -> list[sp.Rational]:
    """Coefficients in x**2 of the derivative by x of an even series in x, over x."""
    return [2 * k * c for k, c in enumerate(series)][1:]


class Horner(sp.Function):
    """A polynomial: its argument, then its coefficients, lowest first. SymPy never expands it."""

    @classmethod
    def of(cls, coefficients: Iterable[sp.Expr], x: sp.Expr) -> "Horner":
        """From its coefficients and its argument."""
        return cls(x, *coefficients)


class RoundingError(sp.Function):
    """What the rounded sum x + y lost (TwoSum): exactly x + y - fl(x + y), and zero in exact arithmetic."""

    nargs = 2


class Sinc(Stable):
    """sin(x)/x for |x| <= pi/2."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return sp.sin(x) / x

    def lower(self) -> sp.Expr:
        return Horner.of(even_series("sin", 1, Fraction(5, 2)), self.args[0] ** 2)

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return -self.args[0] * SincSlope(self.args[0])


class SincSlope(Stable):
    """(sin x - x cos x)/x**3 for |x| <= pi/2: sin(x)/x falls by x times this."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (sp.sin(x) - x * sp.cos(x)) / x**3

    def lower(self) -> sp.Expr:
        return Horner.of(slope_series([-c for c in even_series("sin", 1, Fraction(5, 2))]), self.args[0] ** 2)


class SineDefect(Stable):
    """(x - sin x)/x**3 for |x| <= pi."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (x - sp.sin(x)) / x**3

    def lower(self) -> sp.Expr:
        return Horner.of((-c for c in even_series("sin", 3, Fraction(10))), self.args[0] ** 2)

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return -self.args[0] * SineDefectSlope(self.args[0])


class SineDefectSlope(Stable):
    """(x (2 + cos x) - 3 sin x)/x**5 for |x| <= pi: (x - sin x)/x**3 falls by x times this."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (x * (2 + sp.cos(x)) - 3 * sp.sin(x)) / x**5

    def lower(self) -> sp.Expr:
        return Horner.of(slope_series(even_series("sin", 3, Fraction(10))), self.args[0] ** 2)


class ArtanhExcess(Stable):
    """(artanh x - x)/x**3 for 0 <= x <= 1, finite at 1: callers multiply it by (1 - x**2)**2."""

    SEAM = sp.Rational(2, 5)

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (sp.atanh(x) - x) / x**3

    def lower(self) -> sp.Expr:
        x = self.args[0]
        near = sp.Min(x, self.SEAM)
        far = sp.Min(sp.Max(x, self.SEAM), 1 - sp.Rational(1, 2**53))
        series = Horner.of(even_series("artanh", 3, Fraction(4, 25)), near**2)
        return Select(x, self.SEAM, series, (Log1p(2 * far / (1 - far)) / 2 - far) / far**3)

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return self.args[0] * ArtanhExcessSlope(self.args[0])


class ArtanhExcessSlope(Stable):
    """(x/(1 - x**2) + 2 x - 3 artanh x)/x**5 for 0 <= x <= 1, finite at 1: callers multiply it by (1 - x**2)**2."""

    def definition(self) -> sp.Expr:
        x = self.args[0]
        return (x / (1 - x**2) + 2 * x - 3 * sp.atanh(x)) / x**5

    def lower(self) -> sp.Expr:
        x, seam = self.args[0], ArtanhExcess.SEAM
        near = sp.Min(x, seam)
        far = sp.Min(sp.Max(x, seam), 1 - sp.Rational(1, 2**53))
        series = Horner.of(slope_series(even_series("artanh", 3, Fraction(4, 25))), near**2)
        return Select(x, seam, series, (1 / (1 - far**2) - 3 * ArtanhExcess(far)) / far**2)


class Log1p(sp.Function):
    """log(1 + x); NumPy and C have it under this name."""

    nargs = 1
    call = "log1p"

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return 1 / (1 + self.args[0])

    def _eval_rewrite(self, rule: object, args: tuple[sp.Expr], **hints: object) -> sp.Expr:
        return sp.log(1 + args[0])


class Expm1(sp.Function):
    """exp(x) - 1; NumPy and C have it under this name."""

    nargs = 1
    call = "expm1"

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return sp.exp(self.args[0])

    def _eval_rewrite(self, rule: object, args: tuple[sp.Expr], **hints: object) -> sp.Expr:
        return sp.exp(args[0]) - 1


def exp_series(first: int) -> list[sp.Rational]:
    """Taylor coefficients of (exp(-x) without its terms below x**first)/x**first, to 2**-56 of the first at x = 1."""
    terms = [(-1) ** k / sp.factorial(k) for k in range(first, 40)]
    return [c for c in terms if abs(c) > abs(terms[0]) * sp.Rational(1, 2**57)]


class HalfTan(Stable):
    """tan(x/2) for 0 <= x <= pi/2, as sin x/(1 + cos x)."""

    def definition(self) -> sp.Expr:
        return sp.tan(self.args[0] / 2)

    def lower(self) -> sp.Expr:
        x = self.args[0]
        return x * Sinc(x) / (1 + sp.cos(x))

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return (1 + self**2) / 2


def _reduced_forms() -> dict[str, sp.Expr]:
    """F(alpha)/alpha**3 of each base quantity: sums of positive terms, finite at 0.

    With s = sin(alpha), c = cos(alpha), t = tan(alpha/2):
    C_r = s**3 (1 + t**2) (3 - t**2 - (1 - t**2)**2 (artanh t - t)/t**3)/4, from artanh s = 2 artanh t;
    I_p* = (2 alpha - sin 2 alpha)/3 + c C_r/3;  Theta* = (2 alpha - sin 2 alpha)/4 + s**3 c/3.
    """
    t, sinc, defect = HalfTan(alpha), Sinc(alpha), SineDefect(2 * alpha)
    radial = sinc**3 * (1 + t**2) * (3 - t**2 - (1 - t**2) ** 2 * ArtanhExcess(t)) / 4
    return {
        "polar_moment": (8 * defect + sp.cos(alpha) * radial) / 3,
        "moment_of_inertia": 2 * defect + sinc**3 * sp.cos(alpha) / 3,
        "radial_weight_amplitude": radial,
        "weight_moment_amplitude": sp.Rational(2, 3) * sinc**3,
        "resistance_factor": Sinc(alpha / 2) ** 2,
    }


REDUCED = _reduced_forms()
# Slopes of the amplitudes, for the correction of alpha's own rounding error. artanh(sin alpha) = 2 artanh(t).
_T = HalfTan(alpha)
SLOPES = {
    "radial_weight_amplitude": 4 * alpha * Sinc(alpha) * sp.cos(alpha) * _T * (1 + _T**2 * ArtanhExcess(_T)),
    "weight_moment_amplitude": 2 * (alpha * Sinc(alpha)) ** 2 * sp.cos(alpha),
}
QUOTIENT_FORMS = {q.name: REDUCED[q.numerator] / REDUCED[q.denominator] for q in QUOTIENTS}


def prove_equal(stable: sp.Expr, closed: sp.Expr, claim: str) -> None:
    """Prove a stable form equal to a closed form on (0, pi/2).

    Half angles are written in tau = tan(alpha/2), a bijection of (0, pi/2) onto (0, 1); artanh(sin alpha) is
    2 artanh(tau), proved by their derivatives and their common value at 0.
    """
    tau, artanh = sp.Symbol("tau", positive=True), sp.Symbol("artanh", real=True)
    sine, cosine = 2 * tau / (1 + tau**2), (1 - tau**2) / (1 + tau**2)
    prove_zero(sp.diff(sp.atanh(sine) - 2 * sp.atanh(tau), tau), "artanh(sin alpha) = 2 artanh(tan(alpha/2))")

    def in_tau(e: sp.Expr) -> sp.Expr:
        e = sp.expand_trig(e).subs({sp.tan(alpha / 2): tau, sp.sin(alpha): sine, sp.cos(alpha): cosine})
        e = e.subs({sp.atanh(sine): 2 * artanh, sp.atanh(tau): artanh})
        # sin(alpha/2)**2 = (1 - cos(alpha))/2 is left where a half angle was squared
        return e.replace(
            lambda x: isinstance(x, sp.Pow) and x.base == sp.sin(alpha / 2) and x.exp.is_even,
            lambda x: ((1 - cosine) / 2) ** (x.exp / 2),
        )

    difference = in_tau(unfold(stable)) - in_tau(closed)
    refute(difference, claim)
    prove_zero(sp.cancel(sp.together(sp.expand(difference))), claim)


def prove_kernel(name: str, closed: sp.Expr) -> None:
    """Prove the stable form of a base quantity, and its slope where it has one, equal to the closed form's."""
    prove_equal(alpha**3 * REDUCED[name], closed, f"{name}: stable form equals closed form")
    if name in SLOPES:
        prove_equal(SLOPES[name], sp.diff(closed, alpha), f"{name}: stable slope equals the closed form's")


BASE_NAMES = tuple(m.amplitude[0] if m.amplitude else m.name for m in MOMENTS) + (RESISTANCE.name,)
