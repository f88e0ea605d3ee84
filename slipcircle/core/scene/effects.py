"""Effects of a scene by name, with their parameters. Names of effects of one soil contain its number."""

from collections.abc import Iterable
from functools import lru_cache
from typing import Any

from generated.effects import ALL_EFFECTS, COHESION_LAWS, EFFECTS
from generated.program import OF_SOIL
from slipcircle.base.arrays import EMPTY, Frozen, frozen
from slipcircle.base.kinds import MAPPING, Names, Parameters, TextDict, Texts
from slipcircle.core.lazy import lazy_import

Law = tuple[str, Parameters]  # name and parameters
OF_GROWTH = EFFECTS["cohesion"].parameters[1:]  # of the growth of cohesion with depth, by any law
WITHOUT_PARAMETERS = frozenset(name for name, effect in EFFECTS.items() if not effect.parameters)


def without_soil(name: str) -> str:
    """Return the name of a law or an effect without the number of a soil, "linear" for "linear#0"."""
    return name.partition(OF_SOIL)[0]


def soil_number(name: str) -> str:
    """Return the mark and number of the soil in the name of a law or an effect, such as "#0"; empty without a soil."""
    return "".join(name.partition(OF_SOIL)[1:])


@lru_cache(maxsize=256)
def symbols_of(effect: str) -> TextDict:
    """Return the symbols of an effect's parameters in the equation of motion, by the names of the parameters.

    Symbols of an effect of one soil end with its number.
    """
    number = soil_number(effect)
    declared = ALL_EFFECTS[without_soil(effect)].parameters
    return {p.name: p.symbol + number for p in declared if p.symbol}


def rotates(effects: Iterable[str]) -> bool:
    """Return whether any of the effects, given by name, lets the mass rotate."""
    return any(ALL_EFFECTS[without_soil(effect)].turns for effect in effects)


@lru_cache(maxsize=256)
def in_order(effects: Names) -> tuple[Names, tuple[Names, ...]]:
    """Return the names of effects, each once, in the order of their declarations, and their parameters.

    Each parameter consists of the name of its effect, its own name, and its symbol.
    """
    declared = list(ALL_EFFECTS)
    names = tuple(sorted({*effects}, key=lambda effect: (declared.index(without_soil(effect)), effects.index(effect))))
    parameters = [(effect, name, symbol) for effect in names for name, symbol in symbols_of(effect).items()]
    return names, tuple(parameters)


# --- effects of a scene ---------------------------------------------------------------------------------------------


def named(effects: Any) -> tuple[dict[str, Frozen], list[str]]:
    """Return effects by name, each with its parameters, and messages about invalid effects.

    ``effects`` is the scene's field, names or a mapping from names to parameters.
    """
    if isinstance(effects, str) or not hasattr(effects, "__iter__"):
        return {}, [f"effects = {effects!r}: must be a list of names, or a mapping from names to parameters"]
    by_name = effects if isinstance(effects, MAPPING) else {name: {} for name in effects}
    named = {}
    faults = []
    for name, parameters in by_name.items():
        if isinstance(parameters, MAPPING):
            named[str(name)] = frozen(parameters) if parameters else EMPTY
        else:
            what = f"effects.{name} = {parameters!r}"
            faults.append(f"{what}: must be a mapping of parameters, {{}} where there are none")
    return named, faults


def cohesion_law(cohesion: Any) -> Law | None:
    """Return the name and the parameters of the law of a cohesion that changes with slip; None for a number.

    ``cohesion`` is a number, a function, a law with its parameters, or the parameters of the effect "cohesion".
    """
    if isinstance(cohesion, MAPPING) and "law" not in cohesion:  # of an effect
        cohesion = cohesion.get("cohesion", 0.0)
    if callable(cohesion):
        return "callable", {"function": cohesion}
    if not isinstance(cohesion, MAPPING) or cohesion["law"] == "constant":
        return None
    law = COHESION_LAWS[cohesion["law"]]
    return law.name, {"coefficient" if p.name == "cohesion" else p.name: cohesion[p.name] for p in law.parameters}


def resolved(name: str, parameters: Frozen) -> tuple[Frozen, Texts]:
    """Return an effect's parameters, with functions of time built from their parts, and messages about mistakes.

    ``name`` is the name of the effect, and ``parameters`` are its parameters as entered.
    """
    if name in WITHOUT_PARAMETERS and not parameters:
        return parameters, []
    of_effect: tuple[Frozen, Texts] = lazy_import("laws").checked_effect(name, parameters)
    return of_effect
