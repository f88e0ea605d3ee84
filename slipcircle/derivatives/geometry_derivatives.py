"""Derivatives of what a program takes from an arc: its coefficients, half angle, moment of inertia and cover.

They are in the imaginary parts of complex numbers, as in `slipcircle.derivatives.complex_step`; what is computed
from them has derivatives, too. Those of an arc follow from its derived growth, those of a section from the transport of
its integrals; a layered section is computed with complex numbers from the start.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np

from generated.flow import INPUTS
from generated.growth import arc_growth
from slipcircle.base.kinds import Floats
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.mass import Mass, MomentCoefficients
from slipcircle.derivatives.complex_step import derivative, with_derivatives, with_parts
from slipcircle.derivatives.transport import SectionDerivatives, section_derivatives
from slipcircle.ground.section import Section
from slipcircle.layers.layers import LayeredSection


def relative_derivative(values: Any) -> Floats:
    """Derivatives over the values; 0 where these are 0."""
    real = np.real(values)
    nonzero = np.where(real == 0.0, 1.0, real)
    return np.asarray(derivative(values) / nonzero)


class Directions:
    """The parameters by which derivatives are taken.

    Attributes
    ----------
    names : sequence of str
    none : ndarray
        Derivatives of what depends on none of them.
    """

    def __init__(self, names: Sequence[str]) -> None:
        self.names = names
        self.none = np.zeros(len(names))

    def one(self, name: str) -> Floats:
        """Derivatives of a parameter itself: 1 by it, 0 by all others."""
        return np.array([float(other == name) for other in self.names])

    def stepped(self, name: str, value: Any) -> Any:
        """The value of a parameter as a complex number."""
        return with_parts(value, self.one(name))


class ArcWithDerivatives(Mass):
    """What a program takes from an arc or a section, as complex numbers.

    Attributes
    ----------
    moment_coefficients : MomentCoefficients
    pressure : callable, optional
        Derivatives of the mean water pressure under a section's level, of the rotation.
    """

    def __init__(
        self, arc: Arc | Section, directions: Directions, half_angle: Any, inertia: Any, coefficients: Mapping[str, Any]
    ) -> None:
        self.radius = directions.stepped("radius", arc.radius)
        self.gravity = directions.stepped("gravity", arc.gravity)
        self.unit_weight = directions.stepped("unit_weight", arc.unit_weight)
        self.half_angle = half_angle
        self.dimensionless = SimpleNamespace(moment_of_inertia=inertia)
        self.moment_coefficients: MomentCoefficients = arc.moment_coefficients._replace(**coefficients)
        self.pressure: Callable[[Floats], Any] | None = None


def arc_with_derivatives(arc: Arc | Section, directions: Directions) -> Any:
    """An arc or a section as complex numbers, as far as a program needs them."""
    if isinstance(arc, LayeredSection):
        return with_derivatives(arc, directions.names)
    moments = arc.moment_coefficients._asdict()
    coefficients = {name: float(moments[name]) for name in INPUTS}
    if isinstance(arc, Section):
        return _section(arc, coefficients, directions)
    return _arc(arc, coefficients, directions)


def _arc(arc: Arc, at: Mapping[str, float], directions: Directions) -> ArcWithDerivatives:
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
    dots = {
        "polar_moment": at["polar_moment"] * polar * alpha_dot,
        "resistance_factor": at["resistance_factor"] * resistance * alpha_dot,
    }
    growths = {"driving_moment": weight, "normal_load": radial}
    for name, growth in growths.items():
        name_of_slope = f"{name}_slope"
        value = at[name]
        slope = at[name_of_slope]
        scaled_by = growth * alpha_dot
        dots[name] = value * scaled_by + slope * dip_dot
        dots[name_of_slope] = slope * scaled_by - value * dip_dot
    coefficients = {name: with_parts(at[name], dot) for name, dot in dots.items()}
    theta = float(arc.dimensionless.moment_of_inertia)
    theta_dot = theta * inertia / alpha * alpha_dot
    return ArcWithDerivatives(
        arc,
        directions,
        half_angle=with_parts(alpha, alpha_dot),
        inertia=with_parts(theta, theta_dot),
        coefficients=coefficients,
    )


def _section(section: Section, at: Mapping[str, float], directions: Directions) -> ArcWithDerivatives:
    """By the derivatives of the section's integrals, and of its ends; ``at`` are the values of the coefficients."""
    section_dot = section_derivatives(section, directions.names)
    integrals = section.moments
    integrals_dot = section_dot.moments
    theta = float(integrals["moment_of_inertia"])
    theta_dot = integrals_dot["inertia"]
    inertia_growth = theta_dot / theta
    facing = section.facing
    changes = {
        "driving_moment": -facing * integrals_dot["moment_x"],
        "driving_moment_slope": -integrals_dot["moment_y"],
        "normal_load": -integrals_dot["radial_y"],
        "normal_load_slope": facing * integrals_dot["radial_x"],
        "polar_moment": integrals_dot["polar"],
    }
    coefficients = dict[str, Any]()
    for name, change in changes.items():
        dot = change / theta - at[name] * inertia_growth
        coefficients[name] = with_parts(at[name], dot)
    first_end, last_end = section_dot.ends
    alpha_dot = (last_end - first_end) / 2
    alpha = float(section.half_angle)
    # (3.14): lambda = 2 alpha (1 - cos alpha), by which the mean normal stress and so the mean cover are divided
    lambda_growth = alpha_dot / alpha + alpha_dot / math.tan(alpha / 2)
    resistance = at["resistance_factor"]
    resistance_growth = lambda_growth - inertia_growth
    coefficients["resistance_factor"] = with_parts(resistance, resistance * resistance_growth)
    coefficients["cover"] = _cover(section, section_dot)
    result = ArcWithDerivatives(
        section,
        directions,
        half_angle=with_parts(alpha, alpha_dot),
        inertia=with_parts(theta, theta_dot),
        coefficients=coefficients,
    )
    result.pressure = section_dot.pressure
    return result


def _cover(section: Section, section_dot: SectionDerivatives) -> Any:
    """The mean cover of a section over its radius, relative to the static normal stress."""
    alpha = float(section.half_angle)
    mean_height = float(section.mean_cover / section.radius)
    heights = 2 * alpha * mean_height
    heights_growth = section_dot.heights / heights
    weight_growth = section_dot.moments["radial_y"] / section.moments["radial_weight"]
    cover = float(section.moment_coefficients.cover)
    growth = heights_growth + weight_growth
    return with_parts(cover, cover * growth)
