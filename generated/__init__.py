# Written by `python -m derive` with SymPy 1.14.0; do not edit.
# sha256 of the text below: 0981a067421694530d3544c8d3856d8387364b08b2f91f030ee0c5373d16200e
"""Generated functions of the dynamic slip circle method: NumPy only, derived from the definitions."""

from generated.kernels import (
    dynamic_coefficient,
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
