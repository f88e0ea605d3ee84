"""Derivatives of a motion with respect to the numbers of its scene."""

from slipcircle.derivatives.derivatives import Sensitivity
from slipcircle.derivatives.neighbours import neighbour_derivatives
from slipcircle.derivatives.parameters import (
    Free,
    free_parameters,
    parameter_value,
    parameters,
    possible_parameters,
    with_parameter_arrays,
    with_parameters,
)

__all__ = [
    "Free",
    "Sensitivity",
    "free_parameters",
    "neighbour_derivatives",
    "parameter_value",
    "parameters",
    "possible_parameters",
    "with_parameter_arrays",
    "with_parameters",
]
