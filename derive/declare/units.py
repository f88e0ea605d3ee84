"""Dimensions of declared formulas: each symbol has one, and sums, powers and functions must agree with them."""

from collections.abc import Mapping

import sympy as sp

from derive.check.proof import ProofError

M, S, KG, K = sp.symbols("m s kg K", positive=True)
_PASCAL = KG / (M * S**2)
_UNITS = {"m": M, "s": S, "kg": KG, "K": K, "N": _PASCAL * M**2, "Pa": _PASCAL, "J": _PASCAL * M**3}
ONE = sp.Integer(1)


def of_unit(unit: str) -> sp.Expr:
    """The dimension of a unit as it is declared: what follows the stroke is below it, J/m^3 K."""
    above, _, below = unit.partition("/")
    dimension = ONE
    for part, exponent in (*((x, 1) for x in above.split()), *((x, -1) for x in below.split())):
        base, _, power = part.partition("^")
        dimension *= _UNITS[base] ** (exponent * int(power or 1))
    return dimension


def shown(dimension: sp.Expr) -> str:
    """A dimension in words."""
    return "numbers" if dimension == 1 else str(dimension).replace("**", "^")


def dimension(e: sp.Expr, of: Mapping[sp.Symbol, sp.Expr], claim: str) -> sp.Expr:
    """Dimension of an expression by those of its symbols, a product of powers of m, s, kg and K.

    Raises
    ------
    ProofError
        If unlike quantities are added, or if an exponent or the argument of a function has a dimension.
    """
    if e in of:
        return of[e]
    if e.is_number:
        return ONE
    parts = [dimension(x, of, claim) for x in e.args]
    if e.is_Mul:
        return sp.Mul(*parts)
    if e.is_Add or isinstance(e, sp.Min | sp.Max):
        if len({*parts}) > 1:
            raise ProofError(claim, f"{e}, of terms in {' and '.join(map(shown, parts))}", "terms of one dimension")
        return parts[0]
    base, *others = parts
    if e.is_Pow and others == [ONE] and e.exp.is_number:
        return base**e.exp
    for x, part in zip(e.args, parts, strict=True):
        if part != 1:
            raise ProofError(claim, f"{e}, where {x} is in {shown(part)}", f"{x} over a parameter in {shown(part)}")
    return ONE
