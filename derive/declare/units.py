"""Dimensions of declared formulas: each symbol has a dimension, and sums, powers and functions must be consistent."""

from collections.abc import Mapping
from functools import cache

from sympy import Expr, Integer, Max, Min, Mul, Symbol, symbols, sympify

from derive.check.proof import ProofError

M, S, KG, K = symbols("m s kg K", positive=True)
_PASCAL = KG / (M * S**2)
_DERIVED = {"N": _PASCAL * M**2, "Pa": _PASCAL, "J": _PASCAL * M**3}
_UNITS = {x.name: x for x in (M, S, KG, K)} | _DERIVED
Units = Mapping[Symbol, Expr]


@cache
def of_unit(unit: str) -> Expr:
    """Return the dimension of a declared unit, such as J/m^3 K; factors after the stroke are denominators."""
    above, _, below = unit.replace("^", "**").replace(" ", "*").partition("/")
    return sympify(f"({above or 1})/({below or 1})", locals=_UNITS)


def shown(dimension: Expr) -> str:
    """Return a dimension as text; a number has the text "numbers"."""
    return "numbers" if dimension == 1 else str(dimension).replace("**", "^")


def dimension(e: Expr, of: Units, claim: str) -> Expr:
    """Return the dimension of an expression from those of its symbols, a product of powers of m, s, kg and K.

    Raises
    ------
    ProofError
        If a symbol has none, if unlike quantities are added, or if an exponent or the argument of a function has one.
    """
    if e in of:
        return of[e]
    if e.is_Symbol:
        known = sorted(map(str, of))
        allowed = f"sp.Symbol('{e}', real=True)" if str(e) in known else ", ".join(known)
        raise ProofError(claim, f"the symbol {e}, which is not declared", allowed)
    parts = [dimension(x, of, claim) for x in e.args]
    if e.is_Mul:
        return Mul(*parts)
    if e.is_Add or isinstance(e, Min | Max):
        if len({*parts}) > 1:
            listed = " and ".join(map(shown, parts))
            raise ProofError(claim, f"{e}, of terms in {listed}", "terms of one dimension")
        return parts[0]
    if e.is_Pow and e.exp.is_number:
        return parts[0] ** e.exp
    for x, part in zip(e.args, parts, strict=True):
        if part != 1:
            unit = shown(part)
            raise ProofError(claim, f"{e}, where {x} is in {unit}", f"{x} over a parameter in {unit}")
    return Integer(1)
