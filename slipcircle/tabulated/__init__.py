"""Arcs with tabulated coefficients, for example printed values."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import EFFECTS, Parameter
from slipcircle.base.arrays import INFINITY, choose
from slipcircle.base.errors import mistakes
from slipcircle.base.kinds import Effects, Names, NumberMap, Numbers, Texts
from slipcircle.core import Arc
from slipcircle.core.scene.dimensionless import Dimensionless

__all__ = ["GIVEN", "GivenArc"]
# Coefficients of `Arc(given=...)`. The remaining coefficients are their quotients.
GIVEN: Mapping[str, Parameter] = {
    name: Parameter(
        name, "", lower, help=f"{name.replace('_', ' ')}, dimensionless", key=name, kind="fixed", allowed=allowed
    )
    for name, lower, allowed in (
        ("moment_of_inertia", 0.0, "a positive number"),
        ("radial_weight", 0.0, "a positive number"),
        ("weight_moment", -INFINITY, "a finite number"),
        ("resistance_factor", 0.0, "a positive number"),
        ("dynamic_coefficient", 0.0, "a positive number"),
    )
}


@dataclass(frozen=True)
class GivenArc(Arc[Numbers]):
    """Arc with tabulated instead of computed coefficients, which are valid only in its initial position."""

    def _mistakes(self) -> Texts:
        """Return messages about the fields and about the tabulated coefficients."""
        return super()._mistakes() + _given_mistakes(self.given)

    def __post_init__(self) -> None:
        """Check the numbers, and copy the tabulated coefficients."""
        super().__post_init__()
        object.__setattr__(self, "given", dict(self.coefficients))

    @property
    def coefficients(self) -> NumberMap:
        """Tabulated coefficients by the names of `GIVEN`, all dimensionless."""
        assert self.given is not None
        return self.given

    def mistakes(self, friction: Any, effects: Effects) -> Texts:
        """Return a message if an effect turns the mass, since the coefficients belong to its initial position."""
        if any(EFFECTS[name].turns for name in effects if name in EFFECTS):
            return ["arc.given: belongs to the initial position and cannot be combined with rotation; leave one out"]
        return []

    def numbers_without_effect(self) -> Names:
        """Return the names of inputs without influence, because the coefficients do not follow from the ends."""
        return "theta_1", "theta_2"

    @cached_property
    def facing(self) -> Any:
        """1 for a mass that slides towards positive x, -1 otherwise."""
        return choose(self.coefficients["weight_moment"] < 0.0, -1.0, 1.0)

    @cached_property
    def dimensionless(self) -> Dimensionless:
        """Dimensionless coefficients at the start, the tabulated ones and their quotients, positive down-slope."""
        g = {**self.coefficients, "weight_moment": self.facing * self.coefficients["weight_moment"]}
        return Dimensionless(
            **g,
            static_normal_stress=g["radial_weight"] / g["resistance_factor"],
            limit_friction=g["weight_moment"] / g["radial_weight"],
            radial_weight_per_inertia=g["radial_weight"] / g["moment_of_inertia"],
            polar_moment_per_inertia=g["resistance_factor"] * g["dynamic_coefficient"] / g["moment_of_inertia"],
        )

    @cached_property
    def _quotients(self) -> tuple[Any, Any, Any]:
        """Limit friction, static normal stress and polar moment over inertia, from the tabulated coefficients."""
        d = self.dimensionless
        return d.limit_friction, d.static_normal_stress, d.polar_moment_per_inertia

    @cached_property
    def amplitudes_per_inertia(self) -> tuple[Any, Any]:
        """Amplitudes of the driving moment and the normal load over Theta*. They vary as sine and cosine of the dip."""
        driving_moment = self.dimensionless.limit_friction * self.normal_load
        of_level, radial_of_level = super().amplitudes_per_inertia
        is_level = np.equal(self.dip, 0.0)
        sine = np.sin(choose(is_level, 1.0, self.dip))
        weight = choose(is_level, of_level, driving_moment / sine)  # J_theta = C_theta sin, J_r = C_r cos
        return weight, choose(is_level, radial_of_level, self.normal_load / np.cos(self.dip))

    @cached_property
    def normal_load(self) -> Any:
        """Radial weight over the moment of inertia at the start, J_r/Theta*, both dimensionless."""
        return self.dimensionless.radial_weight_per_inertia


def _given_mistakes(coefficients: Any) -> Texts:
    """Return messages about the tabulated coefficients, ``coefficients`` by the names of `GIVEN`."""
    if not isinstance(coefficients, Mapping):
        return [f"given = {coefficients!r}: must be a mapping of coefficients, or None"]
    messages = [f"given: {name!r} is missing" for name in GIVEN if name not in coefficients]
    names = ", ".join(GIVEN)
    messages += [f"given: {name!r} is unknown; known are {names}" for name in coefficients if name not in GIVEN]
    bounds = {name: GIVEN[name] for name in GIVEN if name in coefficients}
    messages += [f"given: {mistake}" for mistake in mistakes(coefficients, bounds)]
    return messages
