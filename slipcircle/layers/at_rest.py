"""Strength without velocity at time 0, before any slip or after much slip."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from generated.effects import LAWS
from slipcircle.base.kinds import Parameters
from slipcircle.core.scene.effects import cohesion_law
from slipcircle.core.scene.friction import law_parts


def friction_at_rest(friction: Any, slipped: bool = False) -> Any:
    """Return the friction coefficient without velocity, before any slip or after much; NaN if it is unknown.

    `friction` is a coefficient, a mapping that names a law, or a function. `slipped` selects the value after much slip.
    """
    if isinstance(friction, Mapping) and "soils" in friction:  # with the mean of the whole arc
        friction = {**friction, "law": "constant"}
        del friction["soils"]
    return math.prod(_at_rest(*law, slipped) for law in law_parts(friction))


def _at_rest(name: str, parameters: Parameters, slipped: bool) -> Any:
    """Return the coefficient of one law.

    The first value of a table applies before any slip, the last after much. `name` is the name of the law, and
    `slipped` selects the value after much slip.
    """
    if name == "callable" and slipped:
        return math.nan
    if name == "callable":
        coefficient = parameters["function"](0.0)
        return float(np.ravel(coefficient)[0])
    of_slip = LAWS[name].depends_on == ("slip",)
    last = slipped and of_slip
    if "peak" in parameters:
        strength = "residual" if last else "peak"
        return parameters[strength]
    coefficient = parameters["coefficient"]
    is_table = LAWS[name].parameters[0].kind == "list"
    if is_table:
        return coefficient[-last]
    return coefficient


def cohesion_at_rest(cohesion: Any, slipped: bool = False) -> Any:
    """Return a cohesion in Pa before any slip, or after much if `slipped`; NaN if it is unknown.

    `cohesion` is a number, a mapping that names a law, or a function.
    """
    law = cohesion_law(cohesion)
    if law is not None:
        return _at_rest(*law, slipped)
    if isinstance(cohesion, Mapping):
        return cohesion.get("cohesion", 0.0)
    return cohesion


def growth_at_rest(cohesion: Any, growth: Any, slipped: bool = False) -> Any:
    """Return the growth of a cohesion with depth, multiplied by its law, before any slip or after much.

    `growth` is the growth at the start in Pa/m, which decreases in proportion to the cohesion if `slipped`.
    """
    if not slipped or not np.any(growth):
        return growth
    peak = cohesion_at_rest(cohesion)
    is_none = np.equal(peak, 0.0)
    residual = cohesion_at_rest(cohesion, slipped)
    return growth * np.where(is_none, 1.0, residual / np.where(is_none, 1.0, peak))


def least_friction(friction: Any) -> float:
    """Return the least coefficient of a friction law, without its law of speed, over all lanes and any slip.

    The law has a number, an array or a list as coefficient, or peak and residual strength.
    """
    _, parameters = law_parts(friction)[0]
    names = {"coefficient", "peak", "residual"} & parameters.keys()
    least = [np.min(parameters[name]) for name in names]
    return float(min(least))
