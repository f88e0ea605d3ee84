# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 123b0ca3fa1c271752ee115c8d09ecc1ef8833e8f362fa9f6f2da4bb0c66d9c1
"""Generated functions of the dynamic slip circle method: NumPy only, derived from the definitions."""

from generated.kernels import (
    dynamic_coefficient,
    limit_friction,
    moment_of_inertia,
    polar_moment,
    polar_moment_per_inertia,
    radial_weight,
    radial_weight_amplitude,
    radial_weight_per_inertia,
    resistance_factor,
    weight_moment,
    weight_moment_amplitude,
    weight_moment_per_inertia,
    weight_moment_per_radial_weight,
)

# Tells this package from any other of the same name.
__project__ = "slipcircle"

__all__ = [
    "dynamic_coefficient",
    "limit_friction",
    "moment_of_inertia",
    "polar_moment",
    "polar_moment_per_inertia",
    "radial_weight",
    "radial_weight_amplitude",
    "radial_weight_per_inertia",
    "resistance_factor",
    "weight_moment",
    "weight_moment_amplitude",
    "weight_moment_per_inertia",
    "weight_moment_per_radial_weight",
]
