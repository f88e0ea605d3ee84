"""Friction of a scene, a number, a law by name from `generated.effects` or a function: names and messages."""

from typing import Any

from generated.effects import LAWS, Parameter
from generated.program import OF_SOIL
from slipcircle.base.errors import abridged, mistakes, parameter_mistakes
from slipcircle.base.kinds import MAPPING, Names, Parameters
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.effects import Law, without_soil

NAMES = tuple(LAWS)
RATE_LAWS = tuple(name for name in LAWS if LAWS[name].depends_on == ("speed",))
COEFFICIENT = Parameter("friction", lower=-5e-324, allowed="a friction coefficient, tan(phi): a number of at least 0")


def law_mistakes(friction: Any) -> list[str]:
    """Return a message for each mistake in a scene's friction, a number, a law with parameters, or a function."""
    if callable(friction):
        return []
    if type(friction) is float or not isinstance(friction, MAPPING):
        return mistakes({"friction": friction}, {"friction": COEFFICIENT})
    faults = _named_faults(friction, "friction", NAMES)
    if faults or "rate" not in friction:
        return faults
    if not may_have_rate(friction["law"]):
        return [f"friction.rate: {friction['law']} is not a law of slip; remove one"]
    return rate_mistakes(friction["rate"], "friction.rate")


def rate_mistakes(rate: Any, path: str = "rate") -> list[str]:
    """Return a message for each mistake in a law of speed, which multiplies a law of slip or the friction of soils.

    ``rate`` is the law's name and parameters, and ``path`` names it in the messages.
    """
    if not isinstance(rate, MAPPING):
        return [f"{path} = {abridged(rate)}: must be a law of speed with its parameters"]
    return _named_faults(rate, path, RATE_LAWS)


def may_have_rate(law: str) -> bool:
    """Return whether a law, given by name, may be multiplied by a law of speed."""
    return {"speed", "time"}.isdisjoint(LAWS[law].depends_on)


def _named_faults(entered: Parameters, path: str, laws: Names) -> list[str]:
    """Return a message for each mistake in a law by name.

    ``path`` names it in the messages, and ``laws`` are the names of the laws allowed there.
    """
    name = entered.get("law")
    if name not in laws:
        names = ", ".join(laws)
        return [f"{path}.law = {name!r}: must be one of {names}"]
    parameters = dict(entered)
    del parameters["law"]
    if path == "friction":
        parameters.pop("rate", None)
    declared = LAWS[name].parameters
    faults = parameter_mistakes(path, parameters, declared)
    if faults or declared[0].kind != "list":
        return faults
    of_list: list[str] = lazy_import("tables").list_faults(path, name, parameters)
    return of_list


def law_parts(friction: Any) -> tuple[Law, ...]:
    """Return the laws whose product is a scene's friction, each by name with its parameters.

    The friction of several soils is a sum over their laws, whose names contain the number of the soil, ``linear#0``.
    """
    if callable(friction):
        return (("callable", {"function": friction}),)
    if type(friction) is float or not isinstance(friction, MAPPING):
        return (("constant", {"coefficient": friction}),)
    rate = law_parts(friction["rate"]) if "rate" in friction else ()
    if "soils" in friction:
        laws = [law_parts(law)[0] for law in friction["soils"].values()]
        of_soils = [(f"{name}{OF_SOIL}{k}", parameters) for k, (name, parameters) in enumerate(laws)]
        return (*of_soils, *rate)
    parameters = dict(friction)
    name = parameters.pop("law")
    parameters.pop("rate", None)
    return ((name, parameters), *rate)


def law_names(friction: Any) -> Names:
    """Return the names of a scene's law of slip and of the law of speed that multiplies it, if any."""
    return tuple(name for name, _ in law_parts(friction))


def depends_on(laws: Names) -> Names:
    """Return the variables on which a product of laws depends, such as "slip", "speed" and "time"."""
    variables: dict[str, None] = {}
    for name in laws:
        law = LAWS.get(without_soil(name))
        depends_on = law.depends_on if law else ("slip",)
        variables |= dict.fromkeys(depends_on)
    return tuple(variables)
