"""Friction of a scene, a number, a law by name from `generated.effects` or a function, as a product of laws."""

from typing import Any

from generated.effects import LAWS
from generated.program import OF_SOIL
from slipcircle.base.kinds import MAPPING, Names
from slipcircle.core.scene.effects import Law, without_soil

RATE_LAWS = tuple(name for name in LAWS if LAWS[name].depends_on == ("speed",))


def may_have_rate(law: str) -> bool:
    """Return whether a law, given by name, may be multiplied by a law of speed."""
    return {"speed", "time"}.isdisjoint(LAWS[law].depends_on)


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


def depends_on(laws: Names) -> Names:
    """Return the variables on which a product of laws depends, such as "slip", "speed" and "time"."""
    variables: dict[str, None] = {}
    for name in laws:
        law = LAWS.get(without_soil(name))
        depends_on = law.depends_on if law else ("slip",)
        variables |= dict.fromkeys(depends_on)
    return tuple(variables)
