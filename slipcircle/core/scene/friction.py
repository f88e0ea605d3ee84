"""Friction of a scene, a number, a law by name from `generated.effects` or a function, as a product of laws."""

from typing import Any

from generated.program import OF_SOIL
from slipcircle.base.kinds import MAPPING
from slipcircle.core.scene.effects import Law


def law_parts(friction: Any) -> tuple[Law, ...]:
    """Return the laws whose product is a scene's friction, each by name with its parameters.

    The friction of several soils is a sum over their laws, whose names contain the number of the soil, ``linear#0``.
    """
    if type(friction) is float or not isinstance(friction, MAPPING):
        law = ("callable", {"function": friction}) if callable(friction) else ("constant", {"coefficient": friction})
        return (law,)
    rate = law_parts(friction["rate"]) if "rate" in friction else ()
    if "soils" in friction:
        laws = [law_parts(law)[0] for law in friction["soils"].values()]
        of_soils = [(f"{name}{OF_SOIL}{k}", parameters) for k, (name, parameters) in enumerate(laws)]
        return (*of_soils, *rate)
    return ((friction["law"], friction), *rate)
