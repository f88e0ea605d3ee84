"""Integration of a definition to its closed form: inner integral, centred angle, outer integral.

No closed form is typed in. Each antiderivative is differentiated symbolically before it is used, and the result is
compared with quadrature of the original double integrand in r and theta over the uncentred chord (2.6).
"""

from dataclasses import dataclass
from functools import cache

import mpmath
import sympy as sp
from mpmath import linspace, mpf, nstr, quad, workdps
from sympy import (
    Add,
    Expr,
    Integer,
    PolynomialError,
    Rational,
    Symbol,
    atanh,
    count_ops,
    default_sort_key,
    diff,
    expand,
    expand_trig,
    factor_terms,
    integrate,
    lambdify,
    pi,
    simplify,
)

from derive.algebra.prove import prove_zero, trig_normal
from derive.check.proof import ProofError
from derive.declare.quantities import CHORD, MOMENTS, RESISTANCE, Moment
from derive.declare.symbols import Forms, alpha, r, theta, theta_1, theta_m, u

PSI = Symbol("psi", real=True)


def logs_to_artanh(expression: Expr) -> Expr:
    """Return an expression with log(s - 1) replaced by log(s + 1) - 2 artanh(s), so that log(s + 1) cancels.

    The replacement omits an imaginary constant.
    """
    for log in sorted(expression.atoms(sp.log), key=default_sort_key):
        s = log.args[0] + 1
        log_above = sp.log(s + 1)
        if s.has(Symbol) and expression.has(log_above):
            expression = expand(expression.subs(log, log_above - 2 * atanh(s)))
    return expression


def antiderivative(integrand: Expr, x: Symbol, half_width: str = "1") -> Expr:
    """Return SymPy's antiderivative in x, real and zero at x = 0, after proving it.

    Its derivative is proved to be the integrand, and it is shown to be continuous for |x| up to a half-width (decimal):
    SymPy may return antiderivatives that jump inside the interval of integration.
    """
    result = Integer(0)
    for term in Add.make_args(expand(integrand)):
        factor, rest = term.as_independent(x)
        try:
            primitive = logs_to_artanh(integrate(rest, x))
        except (TypeError, PolynomialError, NotImplementedError) as error:
            failure = f"{type(error).__name__}: {error}"
            raise ProofError(f"antiderivative of {rest}", failure, "a closed form") from error
        if primitive.has(sp.Integral):
            raise ProofError(f"antiderivative of {rest}", "an unevaluated integral", "a closed form")
        result += factor * (primitive - primitive.subs(x, 0))
    prove_zero(diff(result, x) - integrand, f"derivative of the antiderivative of {integrand}")
    _check_continuity(result, integrand, x, half_width)
    return result


def _check_continuity(primitive: Expr, integrand: Expr, x: Symbol, half_width: str) -> None:
    """Compare an antiderivative in x, zero at 0, with the quadrature of its integrand from 0 to each half-width."""
    others = sorted((primitive.free_symbols | integrand.free_symbols) - {x}, key=default_sort_key)
    values = {y: Rational(12 + k, 10) for k, y in enumerate(others)}  # angles, away from special values
    above, below = (lambdify(x, form.subs(values), "mpmath") for form in (primitive, integrand))
    with workdps(30):  # of which steep integrands of r**5 lose ten
        for end in (-mpf(half_width), mpf(half_width)):
            increment = above(end)
            area = quad(below, linspace(0, end, 17), method="gauss-legendre")
            if not abs(increment - area) < mpf(10) ** -12 * (1 + abs(increment)):
                found = f"a jump of {nstr(increment - area, 3)} between 0 and {nstr(end, 4)}"
                raise ProofError(f"antiderivative of {integrand}", found, "a continuous function")


@dataclass(frozen=True)
class Derivation:
    """Derivation of a moment from its definition to its closed form."""

    moment: Moment
    amplitude: Expr  # closed form in alpha, positive
    direction: Expr  # 1, or cos(psi) or sin(psi) with a sign

    @property
    def closed(self) -> Expr:
        """Complete integral in alpha and psi."""
        return self.amplitude * self.direction


@cache
def derive(moment: Moment) -> Derivation:
    """Return the derivation of a moment, with each step proved."""
    name = moment.name
    inner = antiderivative(moment.weight, r)
    inner = inner.subs(r, 1) - inner.subs(r, CHORD)
    # Centre the angle: theta = theta_1 + alpha + u, theta_1 + alpha = theta_m, so the limits become -alpha and alpha.
    in_u = inner.subs(theta, theta_1 + alpha + u).subs(theta_1, theta_m - alpha)
    outer = antiderivative(expand_trig(in_u), u, "1.55")
    total = outer.subs(u, alpha) - outer.subs(u, -alpha)
    closed = expand(expand_trig(total.subs(theta_m, 3 * pi / 2 - PSI)))
    direction = moment.weight.subs({r: 1, theta: 3 * pi / 2 - PSI})  # of the weight at the bisector
    amplitude = shortest(expand(closed / direction))
    if amplitude.has(PSI):
        raise ProofError(f"{name}: amplitude", amplitude, "a function of alpha alone")
    prove_zero(amplitude * direction - closed, f"{name}: simplification")
    return Derivation(moment, amplitude, direction)


def shortest(expression: Expr) -> Expr:
    """Return the form equivalent to an expression with the fewest operations among the results of SymPy's rules."""
    normal = trig_normal(expression)
    return min([normal, simplify(normal), factor_terms(normal)], key=lambda e: (count_ops(e), default_sort_key(e)))


def closed_forms() -> Forms:
    """Return closed forms of the base quantities in alpha by the names of their functions."""
    forms = {moment.kernel[0]: derive(moment).amplitude for moment in MOMENTS}
    forms[RESISTANCE.name] = RESISTANCE.form
    return forms


def quadrature(weight: Expr, theta_1_value: object, alpha_value: object, digits: int) -> mpf:
    """Return the original double integral by nested Gauss-Legendre quadrature over the uncentred chord.

    The weight is a function of r and theta. The arc begins at theta_1 and has half the opening angle alpha, in rad.
    """
    function = lambdify((r, theta), weight, "mpmath")
    with workdps(digits + 15):
        first = mpf(theta_1_value)
        half = mpf(alpha_value)

        def ring(angle: mpf) -> mpf:
            chord = mpmath.cos(half) / mpmath.cos(angle - first - half)
            # Degree 2 has six nodes, exact for r**11.
            return quad(lambda x: function(x, angle), [chord, 1], method="gauss-legendre", maxdegree=2)

        total = quad(ring, [first, first + 2 * half], method="gauss-legendre")
    with workdps(digits):
        return +total


def compare(derivation: Derivation, digits: int) -> str:
    """Return the greatest relative difference between a closed form and quadrature of its definition, as text.

    ``digits`` is the precision of the quadrature, and a difference beyond it raises `ProofError`.
    """
    moment = derivation.moment
    closed = derivation.closed.subs(PSI, 3 * pi / 2 - theta_1 - alpha)
    function = lambdify((theta_1, alpha), closed, "mpmath")
    worst = mpf(0)
    with workdps(digits + 15):
        for first, half in (("3.75", "0.55"), ("4.5", "1.3")):
            value = function(mpf(first), mpf(half))
            raw = quadrature(moment.weight, first, half, digits)
            worst = max(worst, abs(raw - value) / abs(value))
            if worst > mpf(10) ** -(digits - 1):
                raise ProofError(f"{moment.name}: closed form against quadrature", value, raw)
        return f"{nstr(worst, 2)} at {digits} digits"
