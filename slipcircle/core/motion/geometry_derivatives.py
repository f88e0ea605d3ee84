"""Derivatives of the numbers of an arc: of its coefficients, half angle, moment of inertia and cover.

Those of an arc follow from its derived growth, those of a section from the transport of its integrals.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.growth import arc_growth
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.transport import section_derivatives

Floats = NDArray[np.float64]


class Directions:
    """The parameters by which derivatives are taken.

    Attributes
    ----------
    names : sequence of str
    none : ndarray
        Derivatives of what depends on none of them.
    of_friction : dict of ndarray
        Derivatives of the numbers of a friction law that is the mean of those of soils, by their names.
    """

    def __init__(self, names: Sequence[str]) -> None:
        self.names = names
        self.none = np.zeros(len(names))
        self.of_friction: dict[str, Floats] = {}

    def one(self, name: str) -> Floats:
        """Derivatives of a parameter itself: 1 by it, 0 by all others; of a friction that soils make up, by theirs."""
        if name in self.of_friction:
            return self.of_friction[name]
        return np.array([float(other == name) for other in self.names])

    def relative(self, name: str, at: Any) -> Floats:
        """Relative derivatives of a parameter that has a value; 0 where that is 0."""
        value = float(at)
        if not value:
            return self.none
        return self.one(name) / value


class Geometry(NamedTuple):
    """Derivatives of what the equation of motion takes from an arc.

    Attributes
    ----------
    coefficients : dict of ndarray
        Those of `moment_coefficients`, by their names.
    half_angle : ndarray
    inertia_growth, cover_growth : ndarray
        Relative derivatives of Theta* and of the mean cover.
    pressure : callable, optional
        Derivatives of the mean water pressure under a section's level, of the rotation.
    """

    coefficients: dict[str, Floats]
    half_angle: Floats
    inertia_growth: Floats
    cover_growth: Floats
    pressure: Callable[[Floats], Any] | None = None


def arc_geometry(arc: Arc, at: Mapping[str, float], directions: Directions) -> Geometry:
    """A change of the half angle scales the coefficients; one of the dip turns them into their slopes.

    ``at`` are the values of the coefficients.
    """
    theta_1 = directions.one("theta_1")
    theta_2 = directions.one("theta_2")
    alpha_dot = (theta_2 - theta_1) / 2
    middle_dot = (theta_1 + theta_2) / 2
    dip_dot = -arc.facing * middle_dot
    alpha = float(arc.half_angle)
    weight, radial, polar, resistance, inertia = map(float, arc_growth(alpha))
    coefficients = {
        "polar_moment": at["polar_moment"] * polar * alpha_dot,
        "resistance_factor": at["resistance_factor"] * resistance * alpha_dot,
    }
    growths = {"driving_moment": weight, "normal_load": radial}
    for name, growth in growths.items():
        name_of_slope = f"{name}_slope"
        value = at[name]
        slope = at[name_of_slope]
        scaled_by = growth * alpha_dot
        coefficients[name] = value * scaled_by + slope * dip_dot
        coefficients[name_of_slope] = slope * scaled_by - value * dip_dot
    inertia_growth = inertia / alpha * alpha_dot
    return Geometry(coefficients, alpha_dot, inertia_growth, directions.none)


def section_geometry(section: Section, at: Mapping[str, float], names: Sequence[str]) -> Geometry:
    """By the derivatives of the section's integrals, and of its ends; ``at`` are the values of the coefficients."""
    section_dot = section_derivatives(section, names)
    integrals = section.moments
    integrals_dot = section_dot.moments
    theta = integrals["moment_of_inertia"]
    inertia_growth = integrals_dot["inertia"] / theta
    facing = section.facing
    changes = {
        "driving_moment": -facing * integrals_dot["moment_x"],
        "driving_moment_slope": -integrals_dot["moment_y"],
        "normal_load": -integrals_dot["radial_y"],
        "normal_load_slope": facing * integrals_dot["radial_x"],
        "polar_moment": integrals_dot["polar"],
    }
    coefficients = dict[str, Floats]()
    for name, change in changes.items():
        coefficients[name] = change / theta - at[name] * inertia_growth
    first_end, last_end = section_dot.ends
    alpha_dot = (last_end - first_end) / 2
    alpha = float(section.half_angle)
    # (3.14): lambda = 2 alpha (1 - cos alpha), by which the mean normal stress and so the mean cover are divided
    lambda_growth = alpha_dot / alpha + alpha_dot / math.tan(alpha / 2)
    resistance_growth = lambda_growth - inertia_growth
    coefficients["resistance_factor"] = at["resistance_factor"] * resistance_growth
    mean_height = float(section.mean_cover / section.radius)
    heights = 2 * alpha * mean_height
    heights_growth = section_dot.heights / heights
    weight_growth = integrals_dot["radial_y"] / integrals["radial_weight"]
    cover_growth = heights_growth + weight_growth
    return Geometry(coefficients, alpha_dot, inertia_growth, cover_growth, section_dot.pressure)
