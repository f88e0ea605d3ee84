"""Proofs that two forms are equal, by numerical refutation and a normal form of sines and cosines."""

from itertools import chain
from typing import Any

from flint import Ordering, fmpq_mpoly_ctx
from sympy import (
    Dummy,
    Expr,
    Function,
    N,
    Pow,
    Rational,
    Symbol,
    atanh,
    cancel,
    cos,
    default_sort_key,
    exp,
    expand,
    expand_trig,
    fraction,
    ilcm,
    nan,
    rem,
    simplify,
    sin,
    together,
    zoo,
)

from derive.check.proof import ProofError


def refute(expression: Expr, claim: str) -> None:
    """Raise `ProofError` for a claim if an expression, which should vanish, is not zero at one point.

    This precedes SymPy's simplification, which may take minutes.
    """
    symbols = sorted(expression.free_symbols, key=default_sort_key)
    point = {x: Rational(2 * i + 3, 2 * i + 7) for i, x in enumerate(symbols)}
    value = N(expression, 30, subs=point)
    if value in (nan, zoo) or (value.is_number and abs(value) > Rational(1, 10**20)):
        raise ProofError(claim, f"{N(value, 8)} at {point}")


def prove_zero(expression: Expr, claim: str) -> None:
    """Raise `ProofError` unless SymPy reduces the expression to zero; ``claim`` is the text of the error."""
    refute(expression, claim)
    for reduce in (expand, trig_normal, simplify):
        expression = reduce(expression)
        if expression == 0:
            return
    raise ProofError(claim, expression)


def prove_rational(expression: Expr, claim: str) -> None:
    """Raise `ProofError` unless an expression is zero as a rational function of its symbols and functions.

    It is reduced to a quotient of two polynomials. Exponentials of sums are taken as products, and fractional powers as
    roots. ``claim`` is the text of the error.
    """
    expression = reduce_roots(expression.replace(exp, lambda exponent: expand(exp(exponent))))
    unknowns = sorted(expression.atoms(Symbol, Function), key=default_sort_key)
    context = fmpq_mpoly_ctx.get([f"x{i}" for i in range(len(unknowns))], Ordering.degrevlex)
    one = context.constant(1)
    known = dict(zip(unknowns, context.gens(), strict=True))

    def quotient(e: Expr) -> tuple[Any, Any]:
        if e in known:
            return known[e], one
        if e.is_Rational:
            return one * int(e.p), one * int(e.q)
        if e.is_Pow and e.exp.is_Integer:
            top, bottom = (part ** abs(int(e.exp)) for part in quotient(e.base))
            if e.exp > 0:
                return top, bottom
            if top == 0:
                raise ProofError(claim, e, "a denominator that is not zero")
            return bottom, top
        if not (e.is_Add or e.is_Mul):
            raise ProofError(claim, e, "a rational function")
        (top, bottom), *others = map(quotient, e.args)
        for over, under in others:
            top = top * over if e.is_Mul else top * under + over * bottom
            bottom = bottom * under
        return top, bottom

    numerator, _ = quotient(expression)
    if numerator != 0:
        prove_zero(expression, claim)


def reduce_roots(expression: Expr) -> Expr:
    """Return an expression, or its numerator as a polynomial of least degree in the roots of each fractional power.

    Roots of quotients, which must be positive, are taken as quotients of roots.
    """
    powers = [power for power in expression.atoms(Pow) if power.exp.is_Rational and not power.exp.is_Integer]
    if not powers:
        return expression
    degree = ilcm(1, *(power.exp.q for power in powers))
    parts = {power: fraction(cancel(power.base)) for power in powers}
    roots = {base: Dummy(f"root{i}") for i, base in enumerate(dict.fromkeys(chain(*parts.values()))) if base != 1}
    of_powers = {
        power: (roots[over] / roots.get(under, under)) ** (power.exp * degree) for power, (over, under) in parts.items()
    }
    numerator, _ = fraction(together(expression.xreplace(of_powers)))
    for base, root in roots.items():
        numerator = rem(numerator, root**degree - base, root)
    return numerator


def trig_normal(expression: Expr) -> Expr:
    """Return the canonical form of a rational function in sines, cosines and artanh.

    It satisfies sin**2 = 1 - cos**2 and has no sines in denominators.
    """
    expression = expand_trig(expression)
    functions = sorted(expression.atoms(sin, cos, atanh), key=default_sort_key)
    unknowns = {f: Dummy(str(f)) for f in functions}
    pairs = ((f, cos(*f.args)) for f in functions if isinstance(f, sin))
    cosine_of = {unknowns[sine]: unknowns[cosine] for sine, cosine in pairs if cosine in unknowns}

    def reduced(polynomial: Expr) -> Expr:
        for sine, cosine in cosine_of.items():
            polynomial = rem(polynomial, sine**2 + cosine**2 - 1, sine)
        return expand(polynomial)

    top, bottom = map(reduced, fraction(together(expression.subs(unknowns))))
    for sine in cosine_of:
        if bottom.has(sine):  # multiplication by the conjugate removes this sine
            conjugate = bottom.subs(sine, -sine)
            top = reduced(top * conjugate)
            bottom = reduced(bottom * conjugate)
    back = {unknown: f for f, unknown in unknowns.items()}
    return expand(cancel(top / bottom)).subs(back)
