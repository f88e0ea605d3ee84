"""What it takes to prove two forms equal: one refutation by numbers, one normal form of sines and cosines."""

import sympy as sp

from derive.check.proof import ProofError


def refute(expression: sp.Expr, claim: str) -> None:
    """Raise `ProofError` where one point shows another number than zero: SymPy may simplify for minutes what is not."""
    symbols = sorted(expression.free_symbols, key=sp.default_sort_key)
    point = {x: sp.Rational(2 * i + 3, 2 * i + 7) for i, x in enumerate(symbols)}
    value = sp.N(expression, 30, subs=point)
    if value.is_Number and abs(value) > sp.Rational(1, 10**20):
        raise ProofError(claim, f"{sp.N(value, 8)} at {point}")


def prove_zero(expression: sp.Expr, claim: str) -> None:
    """Raise `ProofError` unless SymPy reduces the expression to zero."""
    refute(expression, claim)
    for reduce in (sp.expand, trig_normal, sp.simplify, lambda e: sp.simplify(e.rewrite(sp.exp).expand())):
        expression = reduce(expression)
        if expression == 0:
            return
    raise ProofError(claim, expression)


def trig_normal(expression: sp.Expr) -> sp.Expr:
    """Canonical form of a rational function in sines, cosines and artanh: sin**2 -> 1 - cos**2, then cancel."""
    expression = sp.expand_trig(expression)
    swaps = {f: sp.Dummy(str(f)) for f in sorted(expression.atoms(sp.sin, sp.cos, sp.atanh), key=sp.default_sort_key)}
    relations = [
        swaps[sp.sin(x)] ** 2 + swaps[sp.cos(x)] ** 2 - 1
        for x in (f.args[0] for f in swaps if isinstance(f, sp.sin))
        if sp.cos(x) in swaps
    ]
    sines = [swaps[f] for f in swaps if isinstance(f, sp.sin)]
    cosines = [swaps[f] for f in swaps if isinstance(f, sp.cos)]

    def reduced(polynomial: sp.Expr) -> sp.Expr:
        polynomial = sp.expand(polynomial)
        return sp.reduced(polynomial, relations, *sines, *cosines)[1] if relations else polynomial

    parts = sp.fraction(sp.together(expression.subs(swaps)))
    ratio = sp.cancel(reduced(parts[0]) / reduced(parts[1]))
    return sp.expand(ratio).subs({v: k for k, v in swaps.items()})
