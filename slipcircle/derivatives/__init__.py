"""Derivatives of a motion by the numbers of its scene."""

from slipcircle.derivatives.derivatives import Sensitivity
from slipcircle.derivatives.parameters import (
    DIP,
    SOIL_BOUNDS,
    Parameter,
    parameter_value,
    parameters,
    with_parameter_arrays,
    with_parameters,
)

__all__ = [
    "DIP",
    "SOIL_BOUNDS",
    "Parameter",
    "Sensitivity",
    "parameter_value",
    "parameters",
    "with_parameter_arrays",
    "with_parameters",
]
