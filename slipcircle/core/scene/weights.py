"""What the balance of momentum takes from a failed section, whatever its shape."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Effects, Values


@dataclass(frozen=True)
class Dimensionless:
    """Dimensionless coefficients of the equation of motion (3.11) at the start, positive down-slope.

    Attributes
    ----------
    moment_of_inertia, radial_weight, weight_moment, resistance_factor, dynamic_coefficient
        Theta* (3.12), J_r (2.23), J_theta (3.13), lambda (3.14), A (2.24).
    static_normal_stress
        J_r/lambda (2.22).
    limit_friction
        J_theta/J_r, the friction coefficient at limit equilibrium (3.21).
    radial_weight_per_inertia, polar_moment_per_inertia
        J_r/Theta* and I_p*/Theta* = lambda A/Theta*.
    """

    moment_of_inertia: Any
    radial_weight: Any
    weight_moment: Any
    resistance_factor: Any
    dynamic_coefficient: Any
    static_normal_stress: Any
    limit_friction: Any
    radial_weight_per_inertia: Any
    polar_moment_per_inertia: Any


class MomentCoefficients(NamedTuple):
    """Of the balance of moments about the centre: J_theta, J_r, lambda and I_p* over Theta*, and two stresses' scales.

    After a rotation phi the driving moment is J_theta cos(phi) - J_theta' sin(phi), and so is the normal load: the
    slopes are the derivatives by the dip, which a rotation lowers.
    """

    driving_moment: Any
    driving_moment_slope: Any
    normal_load: Any
    normal_load_slope: Any
    resistance_factor: Any
    polar_moment: Any
    limit_friction: Any  # J_theta/J_r at the start
    cover: Any  # the stress of which r_u is a share, over the static normal stress


class SlidingBody:
    """What follows from the fields and coefficients of a failed section, whatever its shape."""

    radius: Any
    unit_weight: Any
    gravity: Any
    half_angle: Any
    dimensionless: Any

    def other_numbers(self) -> dict[str, Any]:
        """Numbers beside those of its fields, by name: of the soils of a layered section."""
        return {}

    def fields_with(self, values: Values) -> dict[str, Any]:
        """The fields that differ once some of these have other values."""
        return {}

    def section_effects(self, effects: Effects) -> Effects:
        """Effects with what the section itself adds to them: its water level, the strengths of its soils."""
        return effects

    @property
    def mean_unit_weight(self) -> Any:
        """Weight over area, N/m^3."""
        return self.unit_weight

    @cached_property
    def sagitta(self) -> Any:
        """f, the depth of the arc below its chord (2.12), by which stresses are scaled, m."""
        versine = 2 * np.sin(self.half_angle / 2) ** 2  # 1 - cos(alpha)
        return np.multiply(self.radius, versine)

    @cached_property
    def time_scale(self) -> Any:
        """t_c = sqrt(R/g) (3.9), s."""
        return np.sqrt(np.divide(self.radius, self.gravity))

    @cached_property
    def reference_stress(self) -> Any:
        """sigma_ref (2.13), Pa."""
        return np.multiply(self.mean_unit_weight, self.sagitta)

    @cached_property
    def static_normal_stress(self) -> Any:
        """sigma_n0, mean normal stress on the arc at rest (2.27), Pa."""
        return self.reference_stress * self.dimensionless.static_normal_stress
