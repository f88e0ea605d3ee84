"""Equilibrium at the start: limit friction, factor of safety and yield coefficient from the forces on the mass."""

from typing import Any, NamedTuple, Self

import numpy as np

from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats
from slipcircle.core.program.program import Program


class Forces(NamedTuple):
    """What drives, what resists beside friction, and the normal force, over Theta*."""

    driving: Any
    resisting: Any
    normal: Any

    @classmethod
    def of(cls, program: Program, cells: Floats) -> Self:
        """The forces where phases begin."""
        names = ("cell_driving", "cell_resisting", "cell_normal0")
        return cls(*(cells[program.roles[name]] for name in names))


def equilibrium(at_rest: Forces, shaken: Forces, mu: Floats, limit: Floats) -> dict[str, Floats]:
    """`Lanes.statics` from the forces at rest and under a unit of k_h, the friction and the limit friction."""
    driving, resisting, normal = at_rest
    pressed = normal > 0.0
    frictionless = driving - resisting
    excess = frictionless - mu * normal
    near_limit = normal * (limit - mu)  # without cancellation
    exact_excess = np.where(pressed, near_limit, excess)
    frictionless_shaken = shaken.driving - shaken.resisting
    excess_shaken = frictionless_shaken - mu * shaken.normal
    yielding = -exact_excess / (excess_shaken - excess)
    normal_then = normal + yielding * (shaken.normal - normal)
    yielding_lifted = -frictionless / (frictionless_shaken - frictionless)
    yield_coefficient = np.where(normal_then < 0.0, yielding_lifted, yielding)
    friction_moment = np.where(pressed, mu * normal, 0.0)
    strength = resisting + friction_moment
    rounding = 8 * EPS * abs(normal)
    driven = driving > rounding
    without_contact = np.where(frictionless > 0.0, np.inf, -np.inf)
    return {
        "limit_friction": np.where(pressed, limit, without_contact),
        "friction": mu,
        "factor_of_safety": np.where(driven, strength / driving, np.inf),
        "yield_coefficient": yield_coefficient + 0.0,
    }
