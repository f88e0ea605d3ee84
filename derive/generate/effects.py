"""The text of `generated/effects.py`: effects, laws and their parameters for the run time, as plain data."""

import re

import sympy as sp

from derive.code.emit import filled
from derive.declare.effects import (
    ALPHA,
    DENSITY,
    DRIVING_MOMENT_SLOPE,
    EFFECTIVE,
    EFFECTS,
    GRAVITY,
    LAWS,
    LIMITS,
    NORMAL_LOAD_SLOPE,
    OMEGA,
    OMEGA_2,
    OTHER_UNITS,
    RADIUS,
    REFERENCE,
    SECTION_EFFECTS,
    THETA,
    USUAL,
    USUAL_FRICTION,
    VALUE,
    Effect,
    Law,
    Parameter,
)
from derive.declare.symbols import in_words


def module() -> str:
    """The runtime half of the effects: plain data."""
    marks = {"LIMITS": LIMITS, "USUAL": USUAL, "OTHER_UNITS": OTHER_UNITS, "USUAL_FRICTION": USUAL_FRICTION}
    rows: dict[str, tuple[Effect | Law, ...]] = {"LAWS": LAWS, "EFFECTS": EFFECTS, "SECTION_EFFECTS": SECTION_EFFECTS}
    texts = {mark: "".join(f"    {e.name!r}: {_effect(e)},\n" for e in entries) for mark, entries in rows.items()}
    return filled("_effects.py.in", {mark: repr(value) for mark, value in marks.items()} | texts)


def _effect(e: Effect | Law) -> str:
    parameters = "".join(f"\n        {_parameter(p)}," for p in e.parameters)
    parameters += "\n    " if parameters else ""
    if isinstance(e, Effect):
        more = f"{e.turns!r}, {e.any_of!r}, {formulas(e)!r}"
    else:
        more = ""
    source = e.equation or e.source
    return f"{type(e).__name__}({e.name!r}, {source!r}, ({parameters}), {e.depends_on!r}, {e.help!r}, {more})"


def _parameter(p: Parameter) -> str:
    """A parameter as data; its conversion to a dimensionless value is a lambda over the arc's scales."""
    symbol = p.symbol.name if p.symbol is not None else ""
    convert = sp.pycode(p.dimensionless, fully_qualified_modules=False)
    for name in sorted((x.name for x in p.dimensionless.free_symbols if x != VALUE), key=len):
        convert = re.sub(rf"\b{name}\b", f"scales[{name!r}]", convert)
    bounds = "{!r}, {!r}".format(*p.bounds).replace("inf", "INFINITY")
    words = f"{p.name!r}, {p.unit!r}, {bounds}, {p.help!r}, {p.key!r}, {p.per_unit!r}"
    return f"Parameter({words}, {symbol!r}, lambda value, scales: {convert}, {p.optional!r}, {p.kind!r})"


def formulas(effect: Effect) -> tuple[str, ...]:
    """What an effect adds to the balance, and what makes its parameters dimensionless (these get a star)."""
    starred = {p.symbol: p for p in effect.parameters if p.symbol is not None and p.dimensionless != VALUE}
    notation: dict[sp.Expr, str] = {
        THETA * DRIVING_MOMENT_SLOPE: "dJ_theta/dpsi",
        THETA * NORMAL_LOAD_SLOPE: "dJ_r/dpsi",
        ALPHA: "alpha",
        GRAVITY: "g",
        RADIUS: "R",
        DENSITY: "rho",
        REFERENCE: "sigma_ref",
        EFFECTIVE: "sigma'",
    }
    notation |= {symbol: f"{symbol}_star" for symbol in starred}
    symbols = {e: sp.Symbol(name) for e, name in notation.items()}

    def shown(e: sp.Expr) -> str:
        return in_words(e.subs({OMEGA_2: OMEGA**2} | symbols))

    lines = ["psi = psi_0 - phi"] if effect.turns else []
    for quantity, term in effect.terms.items():
        if term != 0:
            lines.append(f"adds {shown(term)} to {quantity}")
    for x in effect.states:
        lines.append(f"d{x}/dphi = {shown(effect.growth)}")
    for symbol, p in starred.items():
        lines.append(f"{symbol}* = {shown(p.dimensionless.subs(VALUE, sp.Symbol(p.name)))}")
    return tuple(lines)
