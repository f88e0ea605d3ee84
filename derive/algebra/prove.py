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
    for reduce in (sp.expand, trig_normal, sp.simplify, _simplify_exponentials):
        expression = reduce(expression)
        if expression == 0:
            return
    raise ProofError(claim, expression)


def _simplify_exponentials(expression: sp.Expr) -> sp.Expr:
    return sp.simplify(expression.rewrite(sp.exp).expand())


def trig_normal(expression: sp.Expr) -> sp.Expr:
    """Canonical form of a rational function in sines, cosines and artanh: sin**2 -> 1 - cos**2, no sine below."""
    expression = sp.expand_trig(expression)
    functions = sorted(expression.atoms(sp.sin, sp.cos, sp.atanh), key=sp.default_sort_key)
    unknowns = {f: sp.Dummy(str(f)) for f in functions}
    cosine_of = {}  # the sines whose cosine occurs too
    for f in functions:
        cosine = sp.cos(f.args[0])
        if isinstance(f, sp.sin) and cosine in unknowns:
            cosine_of[unknowns[f]] = unknowns[cosine]

    def reduced(polynomial: sp.Expr) -> sp.Expr:
        for sine, cosine in cosine_of.items():
            polynomial = sp.rem(polynomial, sine**2 + cosine**2 - 1, sine)
        return sp.expand(polynomial)

    top, bottom = map(reduced, sp.fraction(sp.together(expression.subs(unknowns))))
    for sine in cosine_of:
        if bottom.has(sine):  # multiplied by its conjugate, it is free of this sine
            conjugate = bottom.subs(sine, -sine)
            top = reduced(top * conjugate)
            bottom = reduced(bottom * conjugate)
    back = {unknown: f for f, unknown in unknowns.items()}
    return sp.expand(sp.cancel(top / bottom)).subs(back)
