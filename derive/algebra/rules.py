"""From a closed form to one without cancellation, by an ordered list of named rules, each step proved.

The closed forms of an arc are polynomials in alpha, sin alpha, cos alpha and artanh(sin alpha). In a thin arc they are
small differences of these. Angle and artanh are written as a head, which is a rational function of
tau = tan(alpha/2), plus a remainder; the heads cancel by algebra, and what is left is a sum without cancellation.
"""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from derive.algebra.prove import prove_zero, refute
from derive.algebra.remainders import HalfTan, Horner, Remainder, X, taylor, unfold
from derive.check.proof import ProofError
from derive.declare.symbols import alpha

TAU, _Y, _H = sp.symbols("tau y_ artanh_", real=True)
_SINE, _COSINE = 2 * TAU / (1 + TAU**2), (1 - TAU**2) / (1 + TAU**2)
# What the rules leave of the angle and of artanh: alpha**3 and tau**3 times a remainder.
ANGLE_REST = -4 * alpha**3 * Remainder(sp.sin, 3, 2 * alpha)
ARTANH_REST = 2 * TAU**3 * Remainder(sp.atanh, 3, TAU)


@dataclass(frozen=True)
class Step:
    """A rule that was applied: operations of the expression before and after, and seconds, its proof included."""

    rule: str
    operations: tuple[int, int]
    seconds: float


@dataclass(frozen=True)
class StableForm:
    """A closed form as alpha**power ``reduced``, which does not cancel and is finite and not zero at 0."""

    power: int
    reduced: sp.Expr
    steps: tuple[Step, ...]

    @property
    def form(self) -> sp.Expr:
        return alpha**self.power * self.reduced


def _bare_angle(expression: sp.Expr) -> sp.Expr:
    """R1, on alpha where it stands alone: sin(alpha) cos(alpha) + 4 alpha^3 D(2 alpha), D(x) = (x - sin x)/x^3."""
    kept = {f: sp.Dummy() for f in sorted(expression.atoms(sp.Function), key=sp.default_sort_key)}
    free = expression.subs(kept).subs(alpha, sp.sin(alpha) * sp.cos(alpha) + ANGLE_REST)
    return sp.expand(free.subs({v: k for k, v in kept.items()}))


def _artanh(expression: sp.Expr) -> sp.Expr:
    """R2: artanh(sin(alpha)) = 2 tau + 2 tau^3 E(tau), E(x) = (artanh x - x)/x^3."""
    return sp.expand(expression.subs(sp.atanh(sp.sin(alpha)), 2 * TAU + ARTANH_REST))


def _half_angle(expression: sp.Expr) -> sp.Expr:
    """R3: sin(alpha) = 2 tau/(1 + tau^2), cos(alpha) = (1 - tau^2)/(1 + tau^2); what cancels, cancels here."""
    expression = expression.subs({sp.sin(alpha): _SINE, sp.cos(alpha): _COSINE})
    return sp.Add(*(sp.factor(sp.cancel(c)) * r for r, c in _by_remainder(expression).items()))


RULES: dict[str, Callable[[sp.Expr], sp.Expr]] = {"angle": _bare_angle, "artanh": _artanh, "half angle": _half_angle}


@cache
def stable(closed: sp.Expr) -> StableForm:
    """The form without cancellation of a polynomial in alpha, sin, cos and artanh(sin alpha), each step proved.

    The heads of angle and artanh are split off where they cancel, that is where the terms vanish more slowly at 0 than
    their sum.
    """
    expression = sp.expand(sp.expand_trig(closed))
    power = int(closed.leadterm(alpha)[1])
    steps = []
    heads_cancel = min(_orders(expression)) < power
    for name, rule in RULES.items():
        start, before = time.perf_counter(), expression
        expression = rule(before) if heads_cancel or name != "angle" else before
        if expression != before:
            prove_equal(expression, before, f"rule {name}")
            operations = int(sp.count_ops(before)), int(sp.count_ops(expression))
            steps.append(Step(name, operations, time.perf_counter() - start))
    if min(_orders(expression)) < power:
        raise ProofError(f"stable form of {closed}: heads", expression, "none, they cancel")
    reduced = _reduced(expression, power)
    prove_equal(alpha**power * reduced, closed, f"stable form of {closed}")
    return StableForm(power, reduced, tuple(steps))


def _in_tau(expression: sp.Expr) -> sp.Expr:
    """Over the angle, its artanh and tau: what is left of functions are remainders."""
    return expression.subs(sp.atanh(sp.sin(alpha)), _H).subs({sp.sin(alpha): _SINE, sp.cos(alpha): _COSINE})


def _by_remainder(expression: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """The factors of each product of angle, artanh and remainders; they are rational in tau."""
    found: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        factor, rest = term.as_independent(alpha, _H, Remainder)
        found[rest] = found.get(rest, sp.Integer(0)) + factor
    return found


def _orders(expression: sp.Expr) -> list[int]:
    """With which power of alpha each term vanishes at 0."""
    found = []
    for rest, factor in _by_remainder(_in_tau(expression)).items():
        top, bottom = sp.fraction(sp.cancel(factor))
        if top != 0:
            own = sum(int(p.as_base_exp()[1]) for p in sp.Mul.make_args(rest) if p.as_base_exp()[0] in (alpha, _H))
            found.append(own + _lowest(top) - _lowest(bottom))
    return found


def _lowest(polynomial: sp.Expr) -> int:
    """Its lowest power of tau."""
    return min(m[0] for m in sp.Poly(polynomial, TAU).monoms())


def _reduced(expression: sp.Expr, power: int) -> sp.Expr:
    """The expression over alpha**power, for computing.

    With c = cos(alpha): tau/alpha = (sin(alpha)/alpha)/(1 + c), 1/(1 + tau**2) = (1 + c)/2, and where 1 - tau**2 is a
    factor, as of what vanishes at pi/2, (1 - tau**2)/(1 + tau**2) = c. Other polynomials in tau**2 by Horner's scheme.
    """
    c = sp.cos(alpha)
    found = []
    for rest, factor in _by_remainder(expression).items():
        over, under = sp.fraction(sp.cancel(factor))
        shift = _lowest(over) - _lowest(under)
        product, ends = rest * alpha ** (shift - power) * Remainder(sp.sin, 1, alpha) ** shift, -shift
        for part, sign in ((over, 1), (under, -1)):
            constant, factors = sp.factor_list((part / TAU ** _lowest(part)).expand().subs(TAU, sp.sqrt(_Y)), _Y)
            product *= constant**sign
            for polynomial, n in factors:
                if polynomial == _Y - 1:
                    product, ends = product * (-2 * c) ** (sign * n), ends - sign * n
                elif polynomial == _Y + 1:
                    product, ends = product * sp.Integer(2) ** (sign * n), ends - sign * n
                else:
                    coefficients = sp.Poly(polynomial, _Y).all_coeffs()[::-1]
                    product *= Horner(TAU**2, *coefficients) ** (sign * n)
        found.append((product * (1 + c) ** ends).subs(TAU, HalfTan(alpha)))
    return sp.Add(*found)


def heads(expression: sp.Expr, orders: Mapping[sp.Expr, int]) -> sp.Expr:
    """R4: each function f(x) that is named is its Taylor terms below x**n plus x**n times a remainder; heads cancel."""
    parts = {f: sum(c * f.args[0] ** k for k, c in enumerate(taylor(type(f)(X))[:n])) for f, n in orders.items()}
    rests = {f: f.args[0] ** n * Remainder(type(f), n, f.args[0]) for f, n in orders.items()}
    result = sp.expand(expression.subs({f: parts[f] + rests[f] for f in orders}))
    prove_zero(sp.expand(unfold(result) - expression), f"rule heads: {expression}")
    return result


def prove_equal(one: sp.Expr, other: sp.Expr, claim: str) -> None:
    """Prove two forms equal on (0, pi/2).

    Half angles are written in tau = tan(alpha/2), a bijection of (0, pi/2) onto (0, 1); artanh(sin alpha) is
    2 artanh(tau), proved by their derivatives and their common value at 0.
    """
    prove_zero(sp.diff(sp.atanh(_SINE) - 2 * sp.atanh(TAU), TAU), "artanh(sin alpha) = 2 artanh(tan(alpha/2))")
    prove_zero(_in_tau(unfold(HalfTan(alpha).lower())) - TAU, "tan(alpha/2) as it is computed")

    def plain(e: sp.Expr) -> sp.Expr:
        e = sp.expand_trig(unfold(e)).subs(sp.tan(alpha / 2), TAU)
        return _in_tau(e.subs(sp.atanh(TAU), _H / 2))

    difference = plain(one) - plain(other)
    refute(difference, claim)
    prove_zero(sp.expand(sp.fraction(sp.together(difference))[0]), claim)


# --- how the moments of an arc grow with its half angle ---------------------------------------------------------------

GROWTHS = ("weight_moment_amplitude", "radial_weight_amplitude", "polar_moment", "resistance_factor")


def arc_growth(closed: Mapping[str, sp.Expr]) -> tuple[sp.Expr, ...]:
    """Relative derivatives by alpha of C_theta, C_r, I_p*, lambda, all over Theta*, then of Theta* times alpha.

    From the reduced functions F/alpha**3, whose slopes are O(alpha) each: nothing cancels in thin arcs.
    """
    inertia = stable(closed["moment_of_inertia"]).reduced
    log_slope = sp.diff(inertia, alpha) / inertia
    found = [sp.diff(x, alpha) / x - log_slope for x in (stable(closed[n]).reduced for n in GROWTHS)]
    return (*found, 3 + alpha * log_slope)


def prove_arc_growth(closed: Mapping[str, sp.Expr]) -> list[str]:
    """Prove the slopes of the reduced functions equal to those of the closed forms over alpha**3, by name."""
    claims = []
    for name, form in closed.items():
        claim = f"{name}: slope of the reduced function"
        prove_equal(alpha**3 * sp.diff(stable(form).reduced, alpha), sp.diff(form, alpha) - 3 * form / alpha, claim)
        claims.append(claim)
    return claims
