"""The text of `generated/effects.py`: effects, laws and their parameters for the run time, as plain data."""

import re

import sympy as sp

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
    return _EFFECTS_HEAD + "\n".join(
        [
            f"LIMITS = {LIMITS!r}  # between which what has a unit lies",
            f"USUAL = {USUAL!r}  # ranges that soils have",
            f"OTHER_UNITS = {OTHER_UNITS!r}",
            f"USUAL_FRICTION = {USUAL_FRICTION!r}",
            "",
            "LAWS = {",
            *(f"    {law.name!r}: {_effect(law, 'Law')}," for law in LAWS),
            "}",
            "",
            "EFFECTS = {",
            *(f"    {e.name!r}: {_effect(e, 'Effect')}," for e in EFFECTS),
            "}",
            "",
            "ALL_EFFECTS = EFFECTS | {  # with what a section adds by itself",
            *(f"    {e.name!r}: {_effect(e, 'Effect')}," for e in SECTION_EFFECTS),
            "}",
            "",
        ]
    )


def _effect(e: Effect | Law, kind: str) -> str:
    parameters = "".join(f"\n        {_parameter(p)}," for p in e.parameters)
    parameters += "\n    " if parameters else ""
    if isinstance(e, Effect):
        more = f"{e.turns!r}, {e.any_of!r}, {formulas(e)!r}"
    else:
        more = f"{e.scale!r}, {e.kinks!r}"
    return f"{kind}({e.name!r}, {e.equation!r}, ({parameters}), {e.depends_on!r}, {e.help!r}, {more})"


def _parameter(p: Parameter) -> str:
    """A parameter as data; its conversion to a dimensionless value is a lambda over the arc's scales."""
    symbol = p.symbol.name if p.symbol is not None else ""
    convert = sp.pycode(p.dimensionless, fully_qualified_modules=False)
    for name in sorted((x.name for x in p.dimensionless.free_symbols if x != VALUE), key=len):
        convert = re.sub(rf"\b{name}\b", f"scales[{name!r}]", convert)
    bounds = f"{p.lower!r}, {p.upper!r}".replace("inf", "INFINITY")
    words = f"{p.name!r}, {p.unit!r}, {bounds}, {p.help!r}, {p.key!r}, {p.per_unit!r}"
    return f"Parameter({words}, {symbol!r}, lambda value, scales: {convert}, {p.optional!r}, {p.kind!r})"


_EFFECTS_HEAD = '''"""Effects and friction laws that a scene may ask for."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from numpy import sqrt

INFINITY = float("inf")


@dataclass(frozen=True, slots=True)
class Parameter:
    """What an effect or a law needs: SI unit, open bounds, and how a scene file and the balance write it."""

    name: str
    unit: str
    lower: float
    upper: float
    help: str
    key: str
    per_unit: float
    symbol: str
    dimensionless: Callable[[float, Mapping[str, float]], float]
    optional: bool
    kind: str


@dataclass(frozen=True, slots=True)
class Law:
    """A friction law: equation, parameters, what it depends on, help; its length scale, and the slips of its kinks."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    scale: str
    kinks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Effect:
    """A term of the equation of motion: equation, parameters, what it depends on, help, whether the mass turns.

    At least one parameter of ``any_of`` is needed. ``formulas`` say what it adds to the balance.
    """

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    turns: bool
    any_of: tuple[str, ...] = ()
    formulas: tuple[str, ...] = ()


'''
