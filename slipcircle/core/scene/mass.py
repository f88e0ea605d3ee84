"""What the core asks of a mass: one protocol for arcs, sections and layered ground.

Whatever implements it can be solved: nothing in the core asks what kind of mass it has.
"""

import math
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from generated.program import OF_COHESION
from slipcircle.base.checks import EPS, Fault, plain
from slipcircle.base.kinds import Effects, Floats, Names, Parameters, Values, cached_property
from slipcircle.core.doors import room
from slipcircle.core.scene.effects import Law, cohesion_law
from slipcircle.core.scene.piecewise import Data, Tables


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


# Lays out functions of the rotation to their full range where a rotation of a lane exceeds them; whether one does.
Farther = Callable[[dict[str, Data], Floats, Any], bool]


class Mass:
    """A mass that slides along a circular arc: what each kind has to say, what it may add, and what follows.

    Attributes
    ----------
    radius, unit_weight, gravity, width : float or array
        m, N/m^3, m/s^2, m.
    half_angle, facing : float or array
        alpha, rad; 1 where gravity turns the mass counterclockwise, -1 where clockwise.
    dimensionless : Dimensionless
    moment_coefficients : MomentCoefficients
        Its weights and how they change as it turns, its resistance and its closure.
    quantities : mapping
        Its fields that scenes vary, each with the number of axes that one mass has of it.
    rounding : float
        Relative error that each of its coefficients may have.
    own_effects : tuple of str
        Effects that it has by its soils, and that no scene gives.
    friction : mapping or None
        That of its soils, in place of the scene's.
    given : mapping or None
        Coefficients in place of computed ones.
    in_standing_water : bool
        Whether standing water covers its lower end.
    rotation_range : tuple
        Rotations up-slope and down-slope between which the method applies, rad; by convention 30 degrees.
    centre, exit, centroid : array
        x and y of the circle's centre, of the lower end of the slip surface and of the mass, m.
    area : float or array
        Of the mass in its section, m^2.
    """

    radius: Any
    unit_weight: Any
    gravity: Any
    width: Any
    half_angle: Any
    facing: Any
    dimensionless: Any
    moment_coefficients: Any
    centre: Any
    exit: Any
    area: Any
    centroid: Any
    quantities: ClassVar[Mapping[str, int]]
    rounding: ClassVar[float] = 4 * EPS
    own_effects: ClassVar[Names] = ()
    friction: Any = None
    given: Any = None
    in_standing_water: Any = False
    rotation_range: Any = (-math.pi / 6, math.pi / 6)

    # --- what it may add; a plain arc adds nothing -------------------------------------------------------------------

    def geometry_errors(self) -> Iterator[Fault]:
        """Which of its lanes are no such mass, or cannot move, and a sentence about one."""
        return iter(())

    def mistakes(self, friction: Any, effects: Effects) -> list[str]:
        """What keeps it from moving under a friction and effects."""
        if "gradient" in effects.get("cohesion", {}):
            return ["{effects.cohesion.gradient}: needs a ground, below which the cohesion grows, in place of an arc"]
        return []

    def effects_with_own(self, effects: Effects) -> Effects:
        """Return effects with those of the mass: cohesion by a law, a section's water level, strengths of soils."""
        if not self.cohesion_laws(effects.get("cohesion", {})):
            return effects
        moment = self.moment_coefficients.resistance_factor / self.reference_stress  # of 1 Pa
        return {**effects, "cohesion": {}, f"softening_cohesion{OF_COHESION}": {"moment": moment}}

    def cohesion_laws(self, cohesion: Parameters) -> tuple[Law, ...]:
        """The laws by which cohesion changes with slip, that of the scene or those of its soils."""
        law = cohesion_law(cohesion)
        return () if law is None else ((law[0] + OF_COHESION, law[1]),)

    def effects_of_means(self, effects: Effects) -> Effects:
        """The same effects, but of its soils what gives means over the arc: the same where all of it is one soil."""
        return effects

    def tables(
        self, effects: Effects, friction: Any, upslope: bool, tolerance: float, shape: tuple[int, ...]
    ) -> tuple[Tables, Farther | None]:
        """Its functions of the rotation by their symbols, and what lays them out farther, where that may be needed.

        ``upslope`` is whether the mass may move beyond where it began, ``tolerance`` a relative error, ``shape`` that
        of the scene's lanes.
        """
        return {}, None

    def numbers_by_name(self) -> dict[str, Any]:
        """All its numbers: each one number, or an array of one a lane."""
        fields = {name: getattr(self, name) for name in self.quantities}
        return fields | self.other_numbers()

    @cached_property
    def has_plain_numbers(self) -> bool:
        """Whether each of its numbers is a float."""
        return {float}.issuperset(map(type, self.numbers_by_name().values()))

    def other_numbers(self) -> dict[str, Any]:
        """Numbers beside those of its fields, by name: of the soils of a layered section."""
        return {}

    def numbers_without_effect(self) -> Collection[str]:
        """Names of numbers on which no motion depends, and of those that another stands for."""
        return ()

    def fields_with(self, values: Values) -> dict[str, Any]:
        """The fields that differ once some of these have other values."""
        return {}

    def with_lanes(self, of_lanes: Callable[..., Any]) -> Any:
        """The same with some lanes of what its numbers do not tell; ``of_lanes(value, axes of one)`` selects them."""
        return self

    def drowned(self, *rotations: float) -> float:
        """How far below a water level the ground over it comes, where that is deepest, m."""
        return 0.0

    # --- where a rotation about the centre brings it ------------------------------------------------------------------

    def placed(self, points: Any, rotation: Any) -> Any:
        """Points (..., 2) of the mass after a rotation, m."""
        return room("journey").placed(self, points, rotation)

    def journey(self, rotation: Any) -> Any:
        """Where a rotation brings toe and centroid, a `slipcircle.history.Journey`."""
        return room("journey").journey(self, rotation)

    # --- what follows ------------------------------------------------------------------------------------------------

    @property
    def mean_unit_weight(self) -> Any:
        """Weight over area, N/m^3."""
        return self.unit_weight

    @property
    def mass_per_metre(self) -> Any:
        """Of width, kg/m."""
        return self.area * np.divide(self.mean_unit_weight, self.gravity)

    @cached_property
    def sagitta(self) -> Any:
        """f, the depth of the arc below its chord (2.12), by which stresses are scaled, m."""
        versine = 2 * np.sin(self.half_angle / 2) ** 2  # 1 - cos(alpha)
        return np.multiply(self.radius, versine)

    @cached_property
    def time_scale(self) -> Any:
        """t_c = sqrt(R/g) (3.9), s."""
        return plain(np.sqrt(np.divide(self.radius, self.gravity)))

    @cached_property
    def scales(self) -> Values:
        """What the parameters of effects are made dimensionless by, under the names that `generated.effects` uses."""
        return {
            "half_angle": self.half_angle,
            "gravity": self.gravity,
            "reference_stress": self.reference_stress,
            "Theta": self.dimensionless.moment_of_inertia,
            "radius": plain(self.radius),
            "density": plain(self.mean_unit_weight) / plain(self.gravity),
            "cover": self.moment_coefficients.cover,
        }

    @cached_property
    def reference_stress(self) -> Any:
        """sigma_ref (2.13), Pa."""
        return np.multiply(self.mean_unit_weight, self.sagitta)

    @cached_property
    def static_normal_stress(self) -> Any:
        """sigma_n0, mean normal stress on the arc at rest (2.27), Pa."""
        return self.reference_stress * self.dimensionless.static_normal_stress
