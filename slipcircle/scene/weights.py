"""What the balance of momentum takes from a failed section, whatever its shape."""

from dataclasses import dataclass
from typing import Any, NamedTuple


@dataclass(frozen=True)
class Dimensionless:
    """The coefficients of the equation of motion (3.11), dimensionless, at the start, positive down-slope.

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


class Weights(NamedTuple):
    """J_theta, J_r, lambda and I_p* over Theta*, the limit friction J_theta/J_r, and what r_u is a share of.

    After a rotation phi the first pair becomes fall cos(phi) - fall_slope sin(phi), and so does the second: the slopes
    are the derivatives by the dip, which a rotation lowers.
    """

    fall: Any
    fall_slope: Any
    press: Any
    press_slope: Any
    level: Any
    polar: Any
    static_limit: Any
    cover: Any  # the stress of which r_u is a share, over the static normal stress
