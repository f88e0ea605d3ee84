"""What it takes to prove two forms equal: one refutation by numbers, one normal form of sines and cosines."""

import sympy as sp

from derive.check.proof import ProofError


def refute(expression: sp.Expr, claim: str) -> None:
    """Raise `ProofError` where one point shows another number than zero: SymPy may simplify for minutes what is not."""
    symbols = sorted(expression.free_symbols, key=sp.default_sort_key)
    point = {x: sp.Rational(2 * i + 3, 2 * i + 7) for i, x in enumerate(symbols)}
    value = sp.N(expression, 30, subs=point)
    if value in (sp.nan, sp.zoo) or (value.is_Number and abs(value) > sp.Rational(1, 10**20)):
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
    """Canonical form of a rational function in sines, cosines and artanh: sin**2 -> 1 - cos**2, no sine below."""
    expression = sp.expand_trig(expression)
    swaps = {f: sp.Dummy(str(f)) for f in sorted(expression.atoms(sp.sin, sp.cos, sp.atanh), key=sp.default_sort_key)}
    sines = {swaps[f]: swaps[sp.cos(f.args[0])] for f in swaps if isinstance(f, sp.sin) and sp.cos(f.args[0]) in swaps}

    def reduced(polynomial: sp.Expr) -> sp.Expr:
        for sine, cosine in sines.items():
            polynomial = sp.rem(polynomial, sine**2 + cosine**2 - 1, sine)
        return sp.expand(polynomial)

    top, bottom = map(reduced, sp.fraction(sp.together(expression.subs(swaps))))
    for sine in sines:
        if bottom.has(sine):
            mirrored = bottom.subs(sine, -sine)
            top, bottom = reduced(top * mirrored), reduced(bottom * mirrored)
    return sp.expand(sp.cancel(top / bottom)).subs({v: k for k, v in swaps.items()})
