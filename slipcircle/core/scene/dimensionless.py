"""Dimensionless coefficients of the equation of motion, of an arc by its kernels."""

from dataclasses import dataclass
from typing import Any

from generated import kernels


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


def of_arc(arc: Any) -> Dimensionless:
    """Return the dimensionless coefficients of an arc. See `Arc.dimensionless`."""
    alpha = arc.half_angle
    limit_friction, static_normal_stress, polar_per_inertia = arc._quotients
    return Dimensionless(
        moment_of_inertia=kernels.moment_of_inertia(alpha),
        radial_weight=kernels.radial_weight(arc.theta_1, arc.theta_2),
        weight_moment=arc.facing * kernels.weight_moment(arc.theta_1, arc.theta_2),
        resistance_factor=kernels.resistance_factor(alpha),
        dynamic_coefficient=kernels.dynamic_coefficient(alpha),
        static_normal_stress=static_normal_stress,
        limit_friction=limit_friction,
        radial_weight_per_inertia=arc.normal_load,
        polar_moment_per_inertia=polar_per_inertia,
    )
