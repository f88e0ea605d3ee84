"""The text of `generated/effects.py`: effects, laws and their parameters for the run time, as plain data."""

import re

import sympy as sp

from derive.code.emit import filled
from derive.declare.effects import (
    EFFECTS,
    LAWS,
    LIMITS,
    OTHER_UNITS,
    SECTION_EFFECTS,
    USUAL,
    USUAL_FRICTION,
    VALUE,
    Effect,
    Law,
    Parameter,
    formulas,
)


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
        more = f"{e.scale!r}, {e.kinks!r}"
    return f"{type(e).__name__}({e.name!r}, {e.equation!r}, ({parameters}), {e.depends_on!r}, {e.help!r}, {more})"


def _parameter(p: Parameter) -> str:
    """A parameter as data; its conversion to a dimensionless value is a lambda over the arc's scales."""
    symbol = p.symbol.name if p.symbol is not None else ""
    convert = sp.pycode(p.dimensionless, fully_qualified_modules=False)
    for name in sorted((x.name for x in p.dimensionless.free_symbols if x != VALUE), key=len):
        convert = re.sub(rf"\b{name}\b", f"scales[{name!r}]", convert)
    bounds = f"{p.lower!r}, {p.upper!r}".replace("inf", "INFINITY")
    words = f"{p.name!r}, {p.unit!r}, {bounds}, {p.help!r}, {p.key!r}, {p.per_unit!r}"
    return f"Parameter({words}, {symbol!r}, lambda value, scales: {convert}, {p.optional!r}, {p.kind!r})"
