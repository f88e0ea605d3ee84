"""Transformation of a closed form to a form without cancellation, by named rules in order, each step proved.

The closed forms of an arc are polynomials in alpha, sin alpha, cos alpha and artanh(sin alpha). In a thin arc they are
small differences of these functions. Angle and artanh are written as a rational function of tau = tan(alpha/2) plus a
remainder. The rational functions cancel by algebra, and the rest is a sum without cancellation.
"""

import time
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy import (
    Add,
    Dummy,
    Expr,
    Function,
    Integer,
    Mul,
    Poly,
    atanh,
    cancel,
    cos,
    count_ops,
    default_sort_key,
    diff,
    expand,
    expand_trig,
    factor_list,
    fraction,
    sin,
    sqrt,
    symbols,
    tan,
    together,
)

from derive.algebra.prove import prove_zero, refute
from derive.algebra.remainders import HalfTan, Horner, Remainder, unfold
from derive.check.proof import ProofError
from derive.declare.symbols import alpha

TAU, _Y, _H = symbols("tau y_ artanh_", real=True)
_SINE = 2 * TAU / (1 + TAU**2)
_COSINE = (1 - TAU**2) / (1 + TAU**2)
# Remainders of the angle and of artanh after the rules, multiplied by alpha**3 and tau**3.
ANGLE_REST = -4 * alpha**3 * Remainder(sin, 3, 2 * alpha)
ARTANH_REST = 2 * TAU**3 * Remainder(atanh, 3, TAU)


@dataclass(frozen=True)
class Step:
    """Application of a rule: operations of the expression before and after, and seconds including the proof."""

    rule: str
    operations: tuple[int, int]
    seconds: float


@dataclass(frozen=True)
class StableForm:
    """Closed form as alpha**power times ``reduced``, which does not cancel and is finite and nonzero at 0."""

    power: int
    reduced: Expr
    steps: tuple[Step, ...]

    @property
    def form(self) -> Expr:
        """Complete expression."""
        return alpha**self.power * self.reduced


def _bare_angle(expression: Expr) -> Expr:
    """Return R1 applied to bare alpha: sin(alpha) cos(alpha) + 4 alpha^3 D(2 alpha), D(x) = (x - sin x)/x^3."""
    functions = sorted(expression.atoms(Function), key=default_sort_key)
    unknowns = {f: Dummy() for f in functions}
    back = {unknown: f for f, unknown in unknowns.items()}
    split = expression.subs(unknowns).subs(alpha, sin(alpha) * cos(alpha) + ANGLE_REST)
    return expand(split.subs(back))


def _artanh(expression: Expr) -> Expr:
    """Return R2 applied: artanh(sin(alpha)) = 2 tau + 2 tau^3 E(tau), E(x) = (artanh x - x)/x^3."""
    return expand(expression.subs(atanh(sin(alpha)), 2 * TAU + ARTANH_REST))


def _half_angle(expression: Expr) -> Expr:
    """Return R3 applied, with cancellation: sin(alpha) = 2 tau/(1 + tau^2), cos(alpha) = (1 - tau^2)/(1 + tau^2)."""
    expression = expression.subs({sin(alpha): _SINE, cos(alpha): _COSINE})
    factors = _by_remainder(expression)
    return Add(*(sp.factor(cancel(factor)) * rest for rest, factor in factors.items()))


RULES: dict[str, Callable[[Expr], Expr]] = {"angle": _bare_angle, "artanh": _artanh, "half angle": _half_angle}


@cache
def stable(closed: Expr) -> StableForm:
    """Return the form without cancellation of a polynomial in alpha, sin, cos and artanh(sin alpha), each step proved.

    Angle and artanh are split only if their leading parts cancel, that is if the terms vanish more slowly at 0 than
    their sum.
    """
    expression = expand(expand_trig(closed))
    power = int(closed.leadterm(alpha)[1])
    steps = []
    heads_cancel = min(_orders(expression)) < power
    for name, rule in RULES.items():
        if name == "angle" and not heads_cancel:
            continue
        start = time.perf_counter()
        before = expression
        expression = rule(before)
        if expression != before:
            prove_equal(expression, before, f"rule {name}")
            operations = int(count_ops(before)), int(count_ops(expression))
            steps.append(Step(name, operations, time.perf_counter() - start))
    if min(_orders(expression)) < power:
        raise ProofError(f"stable form of {closed}: heads", expression, "none, they cancel")
    reduced = _reduced(expression, power)
    prove_equal(alpha**power * reduced, closed, f"stable form of {closed}")
    return StableForm(power, reduced, tuple(steps))


def _in_tau(expression: Expr) -> Expr:
    """Return an expression in the angle, its artanh and tau, in which only remainders are left as functions."""
    expression = expression.subs(atanh(sin(alpha)), _H)
    return expression.subs({sin(alpha): _SINE, cos(alpha): _COSINE})


def _by_remainder(expression: Expr) -> dict[Expr, Expr]:
    """Return the factor, rational in tau, of each product of angle, artanh and remainders."""
    factors: dict[Expr, Expr] = defaultdict(lambda: Integer(0))
    for term in Add.make_args(expand(expression)):
        factor, rest = term.as_independent(alpha, _H, Remainder)
        factors[rest] += factor
    return factors


def _orders(expression: Expr) -> list[int]:
    """Return the power of alpha with which each term vanishes at 0."""
    orders = []
    for rest, factor in _by_remainder(_in_tau(expression)).items():
        top, bottom = fraction(cancel(factor))
        if top == 0:
            continue
        order = _lowest(top) - _lowest(bottom)
        for part in Mul.make_args(rest):
            base, exponent = part.as_base_exp()
            if base in (alpha, _H):
                order += int(exponent)
        orders.append(order)
    return orders


def _lowest(polynomial: Expr) -> int:
    """Return the lowest power of tau in a polynomial."""
    return min(powers[0] for powers in Poly(polynomial, TAU).monoms())


def _reduced(expression: Expr, power: int) -> Expr:
    """Return the expression over alpha**power for computation, where tau**shift is (tau/alpha)**shift alpha**shift.

    With c = cos(alpha): tau/alpha = (sin(alpha)/alpha)/(1 + c).
    """
    terms = []
    for rest, factor in _by_remainder(expression).items():
        top, bottom = fraction(cancel(factor))
        shift = _lowest(top) - _lowest(bottom)
        product = rest * alpha ** (shift - power) * Remainder(sin, 1, alpha) ** shift
        one_plus_c = -shift  # exponent of 1 + c
        for polynomial, sign in ((top, 1), (bottom, -1)):
            factors, exponent = _of_tau_squared(polynomial, sign)
            product *= factors
            one_plus_c += exponent
        terms.append((product * (1 + cos(alpha)) ** one_plus_c).subs(TAU, HalfTan(alpha)))
    return Add(*terms)


def _of_tau_squared(polynomial: Expr, sign: int) -> tuple[Expr, int]:
    """Return a polynomial over its lowest power of tau, to the power ``sign``, and an exponent of 1 + cos(alpha).

    1/(1 + tau**2) = (1 + c)/2, and a factor 1 - tau**2, which vanishes at pi/2, gives (1 - tau**2)/(1 + tau**2) = c.
    Other polynomials in tau**2 use Horner's scheme.
    """
    over_lowest = (polynomial / TAU ** _lowest(polynomial)).expand()
    product, factors = factor_list(over_lowest.subs(TAU, sqrt(_Y)), _Y)
    product = product**sign
    exponent = 0
    for factor, n in factors:
        n *= sign
        if factor == _Y - 1:
            product *= (-2 * cos(alpha)) ** n
            exponent -= n
        elif factor == _Y + 1:
            product *= Integer(2) ** n
            exponent -= n
        else:
            coefficients = Poly(factor, _Y).all_coeffs()[::-1]
            product *= Horner(TAU**2, *coefficients) ** n
    return product, exponent


def prove_equal(one: Expr, other: Expr, claim: str) -> None:
    """Prove that two forms are equal on (0, pi/2).

    Half angles are written in tau = tan(alpha/2), a bijection of (0, pi/2) onto (0, 1). artanh(sin alpha) is
    2 artanh(tau), as their derivatives and their values at 0 agree.
    """
    prove_zero(diff(atanh(_SINE) - 2 * atanh(TAU), TAU), "artanh(sin alpha) = 2 artanh(tan(alpha/2))")
    prove_zero(_in_tau(unfold(HalfTan(alpha).lower())) - TAU, "tan(alpha/2) as it is computed")

    def in_tau(form: Expr) -> Expr:
        form = expand_trig(unfold(form)).subs(tan(alpha / 2), TAU)
        return _in_tau(form.subs(atanh(TAU), _H / 2))

    difference = in_tau(one) - in_tau(other)
    refute(difference, claim)
    numerator, _ = fraction(together(difference))
    prove_zero(expand(numerator), claim)
