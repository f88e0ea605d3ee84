"""Friction as a scene gives it, a number, a law by name from `generated.effects` or a function: names and mistakes."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from generated.effects import LAWS
from slipcircle.base.checks import mistakes, parameter_mistakes, shown

OF_SOIL = "#"  # before the number of a soil, in the name of its law
RATE_LAWS = tuple(name for name, law in LAWS.items() if law.depends_on == ("speed",))


def law_mistakes(given: Any) -> list[str]:
    """A sentence for each mistake in a scene's friction."""
    if callable(given):
        return []
    if not isinstance(given, Mapping):
        return mistakes(
            {"friction": given},
            {"friction": (-5e-324, np.inf, "a friction coefficient, tan(phi): a number of at least 0")},
        )
    faults = _named_faults(given, "friction", tuple(LAWS))
    if not faults and "rate" in given:
        if not may_have_rate(given["law"]):
            faults.append(f"friction.rate: {given['law']} is not a law of slip; remove one")
        elif not isinstance(given["rate"], Mapping):
            faults.append(f"friction.rate = {shown(given['rate'])}: must be a law of speed with its parameters")
        else:
            faults += _named_faults(given["rate"], "friction.rate", RATE_LAWS)
    return faults


def rate_mistakes(given: Any) -> list[str]:
    """A sentence for each mistake in a law of speed that multiplies the friction of all soils."""
    if given is None:
        return []
    if not isinstance(given, Mapping):
        return [f"rate = {shown(given)}: must be a law of speed with its parameters"]
    return _named_faults(given, "rate", RATE_LAWS)


def may_have_rate(law: str) -> bool:
    """Whether a law may be multiplied by one of speed."""
    return not {"speed", "time"} & set(LAWS[law].depends_on)


def _named_faults(given: Mapping[str, Any], path: str, known: tuple[str, ...]) -> list[str]:
    """A sentence for each mistake in a law by name."""
    name = given.get("law")
    if name not in known:
        return [f"{path}.law = {name!r}: must be one of {', '.join(known)}"]
    parameters = {k: v for k, v in given.items() if k != "law" and (k, path) != ("rate", "friction")}
    declared = LAWS[name].parameters
    faults = parameter_mistakes(path, parameters, declared)
    if declared[0].kind == "list" and not faults:
        faults += _table_faults(path, name, parameters)
    return faults


def _table_faults(path: str, name: str, parameters: Mapping[str, Any]) -> list[str]:
    """What is wrong with a law that is a table: its slips, speeds or times, and the coefficients there."""
    places, values = (np.asarray(parameters[p.name], dtype=float) for p in LAWS[name].parameters)
    argument = f"{path}.{LAWS[name].parameters[0].name}"
    if places.ndim != 1 or places.shape != values.shape or places.size < 2:
        return [f"{{{argument}}} and {{{path}.coefficient}}: must be two lists of equal length, at least two values"]
    if name == "tabulated" and (places[0] != 0.0 or np.any(np.diff(places) <= 0.0)):
        return [f"{{{argument}}}: must start at 0 and increase"]
    return [f"{{{argument}}}: must increase"] if np.any(np.diff(places) <= 0.0) else []


def law_parts(friction: Any) -> tuple[tuple[str, Mapping[str, Any]], ...]:
    """The laws that a scene's friction is a product of: each by name, with its parameters.

    The laws of soils, of which it is a sum, are by names with the number of the soil, ``linear#0``.
    """
    if callable(friction):
        return (("callable", {"function": friction}),)
    if not isinstance(friction, Mapping):
        return (("constant", {"coefficient": friction}),)
    rate = law_parts(friction["rate"]) if "rate" in friction else ()
    if "soils" in friction:
        of_soils = [law_parts(law)[0] for law in friction["soils"].values()]
        return (*((f"{name}{OF_SOIL}{k}", given) for k, (name, given) in enumerate(of_soils)), *rate)
    parameters = {n: v for n, v in friction.items() if n not in ("law", "rate")}
    return ((friction["law"], parameters), *rate)


def law_paths(friction: Any) -> tuple[str, ...]:
    """Where the numbers of each of `law_parts` are among the numbers of a scene."""
    first: tuple[str, ...] = ("friction",)
    if isinstance(friction, Mapping) and "soils" in friction:
        first = tuple(f"soils.{soil}.friction" for soil in friction["soils"])
    return (*first, "friction.rate")[: len(law_parts(friction))]


def without_soil(name: str) -> str:
    """The name of a law or an effect without the number of a soil."""
    return name.partition(OF_SOIL)[0]


def soil_number(name: str) -> str:
    """The number of the soil whose law or effect this is, after its mark; empty for that of a whole arc."""
    return "".join(name.partition(OF_SOIL)[1:])


def law_names(given: Any) -> tuple[str, ...]:
    """Of the law that a scene's friction stands for, and of the law of speed that multiplies it."""
    return tuple(name for name, _ in law_parts(given))


def law_depends(given: Any) -> tuple[str, ...]:
    """What a scene's friction depends on: some of slip, speed, time."""
    names = map(without_soil, law_names(given))
    return tuple(dict.fromkeys(x for n in names for x in (LAWS[n].depends_on if n in LAWS else ("slip",))))


def friction_at_rest(friction: Any) -> Any:
    """The coefficient before any slip, at no speed and at the start."""
    coefficients = []
    if isinstance(friction, Mapping) and "soils" in friction:  # with the mean of the whole arc
        friction = {**friction, "law": "constant"}
        del friction["soils"]
    for name, given in law_parts(friction):
        if name == "callable":
            coefficients.append(float(np.ravel(given["function"](0.0))[0]))
            continue
        value = given["peak" if "peak" in given else "coefficient"]
        is_table = LAWS[name].parameters[0].kind == "list"
        coefficients.append(value[0] if is_table else value)
    return math.prod(coefficients)


def least_friction(friction: Any) -> float:
    """The least coefficient of a law without a law of speed beside it, of any lane."""
    _, given = law_parts(friction)[0]
    return min(float(np.min(given[n])) for n in ("coefficient", "peak", "residual") if n in given)
