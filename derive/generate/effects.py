"""Text of `generated/effects.py`: effects, laws and their parameters for the runtime as plain data."""

import re

from sympy import Expr, Symbol, pycode

from derive.code.emit import filled
from derive.declare.cohesion import COHESION_LAWS
from derive.declare.effects import (
    ALPHA,
    DENSITY,
    EFFECTS,
    GRAVITY,
    LAWS,
    RADIUS,
    REFERENCE,
    SECTION_EFFECTS,
    VALUE,
    Effect,
    Law,
    Parameter,
)
from derive.declare.limits import LEAST, LIMITS, OTHER_UNITS, QUESTIONED_FRICTION, USUAL, USUAL_FRICTION
from derive.declare.symbols import in_words
from derive.flow.equation import term
from derive.kinds import Names


def effects_module() -> str:
    """Return the text of the module with effects and laws as plain data."""
    marks: dict[str, object] = {"LIMITS": LIMITS, "LEAST": LEAST, "USUAL": USUAL, "OTHER_UNITS": OTHER_UNITS}
    marks |= {"USUAL_FRICTION": USUAL_FRICTION, "QUESTIONED_FRICTION": QUESTIONED_FRICTION}
    rows: dict[str, tuple[Effect | Law, ...]] = {"LAWS": LAWS, "EFFECTS": EFFECTS, "SECTION_EFFECTS": SECTION_EFFECTS}
    rows["COHESION_LAWS"] = COHESION_LAWS
    texts = {}
    for mark, entries in rows.items():
        texts[mark] = "".join(f"    {e.name!r}: {_effect(e)},\n" for e in entries)
    return filled("_effects.py.in", {mark: repr(value) for mark, value in marks.items()} | texts)


def _effect(e: Effect | Law) -> str:
    """Return the source of an effect or a law."""
    parameters = "".join(f"\n        {_parameter(p)}," for p in e.parameters)
    parameters += "\n    " if parameters else ""
    more = f", {e.turns!r}, {e.any_of!r}, {formulas(e)!r}" if isinstance(e, Effect) else ""
    source = e.equation or e.source
    return f"{type(e).__name__}({e.name!r}, {source!r}, ({parameters}), {e.depends_on!r}, {e.help!r}{more})"


def _parameter(p: Parameter) -> str:
    """Return the source of a parameter. Its conversion to a dimensionless value is a lambda of the arc's scales."""
    symbol = p.symbol.name if p.symbol is not None else ""
    convert = pycode(p.dimensionless, fully_qualified_modules=False)
    for name in sorted((x.name for x in p.dimensionless.free_symbols if x != VALUE), key=len):
        convert = re.sub(rf"\b{name}\b", f"scales[{name!r}]", convert)
    bounds = "{!r}, {!r}".format(*p.bounds).replace("inf", "INFINITY")
    words = f"{p.name!r}, {p.unit!r}, {bounds}, {p.help!r}, {p.key!r}, {p.per_unit!r}"
    return f"Parameter({words}, {symbol!r}, lambda value, scales: {convert}, {p.optional!r}, {p.kind!r})"


# Notation of the guide for the scales of an arc.
_NOTATION = {ALPHA: "alpha", GRAVITY: "g", RADIUS: "R", DENSITY: "rho", REFERENCE: "sigma_ref"}


def formulas(effect: Effect) -> Names:
    """Return the terms of an effect in the balance, and definitions of dimensionless parameters, marked by a star."""
    starred = {symbol: p for symbol, p in effect.symbols.items() if p.dimensionless != VALUE}
    stars = {symbol: Symbol(f"{symbol}_star") for symbol in starred}

    def shown(e: Expr) -> str:
        return term("", e.subs(stars)).formula.replace("J_theta'", "dJ_theta/dpsi").replace("J_r'", "dJ_r/dpsi")

    lines = ["psi = psi_0 - phi"] if effect.turns else []
    lines += [f"adds {shown(added)} to {quantity}" for quantity, added in effect.terms.items() if added != 0]
    lines += [f"d{x}/dphi = {shown(effect.growth)}" for x in effect.states]
    for symbol, p in starred.items():
        scales = p.dimensionless.subs(_NOTATION | {VALUE: Symbol(p.name)})
        lines.append(f"{symbol}* = {in_words(scales)}")
    return tuple(lines)
