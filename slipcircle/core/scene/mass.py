"""Protocol of a mass for arcs, sections and layered ground.

Every implementation can be solved, since the core does not distinguish kinds of masses.
"""

import math
from collections.abc import Callable, Collection, Iterator
from typing import Any, ClassVar, NamedTuple

import numpy as np

from generated.effects import Parameter
from generated.flow import INPUTS
from generated.program import OF_COHESION
from slipcircle.base.arrays import EPS, INFINITY, float_or_array
from slipcircle.base.errors import Fault
from slipcircle.base.kinds import Effects, Floats, Names, Parameters, Shape, Values, cached_property
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.declarations import Parts, declared
from slipcircle.core.scene.effects import Law, cohesion_law
from slipcircle.core.scene.piecewise import Data, Tables


class MomentCoefficients(NamedTuple):
    """Coefficients of the balance of moments: J_theta, J_r, lambda and I_p* over Theta*, and ratios of stresses.

    After a rotation phi the driving moment is J_theta cos(phi) - J_theta' sin(phi), and the normal load has the same
    form. The slopes are derivatives with respect to the dip, which a rotation decreases.
    """

    driving_moment: Any
    driving_moment_slope: Any
    normal_load: Any
    normal_load_slope: Any
    resistance_factor: Any
    polar_moment: Any
    limit_friction: Any  # J_theta/J_r at the start
    cover: Any  # stress to which r_u refers, over the static normal stress


# Extends functions of the rotation to their full range if a lane exceeds them, and returns whether one does.
Farther = Callable[[dict[str, Data], Floats, Any], bool]


class Mass:
    """Base class of masses that slide along a circular arc.

    To implement a new kind of mass:

    1. Declare it as a frozen dataclass derived from this class, or from `Arc` or `Section`. Each number that may vary
       is a field with its unit, bounds and meaning in the metadata, ``field(metadata=number("N/m", 0.0, 1e9))``. Such
       numbers may be arrays; derivatives, ensembles and back-analyses name them by their fields.
    2. Provide the attributes ``radius``, ``unit_weight``, ``gravity``, ``width``, ``half_angle`` and ``facing``.
    3. Provide ``dimensionless`` and ``moment_coefficients``, which determine the motion.
    4. Provide ``centre``, ``entry``, ``exit``, ``area`` and ``centroid`` for positions and masses.
    5. Override `geometry_errors` if some lanes may be impossible, `mistakes` if some effects cannot be combined with
       the mass, and `effects_with_own` and `tables` if it adds effects of its own.
    6. Override `parts` and `with_parts` only for numbers that are not fields.

    Attributes
    ----------
    radius, unit_weight, gravity, width : float or array
        Radius in m, unit weight in N/m^3, gravity in m/s^2, and width in m.
    half_angle, facing : float or array
        Half the opening angle, alpha, in rad; 1 if gravity turns the mass counterclockwise, -1 if clockwise.
    dimensionless : slipcircle.core.scene.dimensionless.Dimensionless
    moment_coefficients : MomentCoefficients
        Coefficients of the balance of moments, with their change as the mass turns.
    rounding : float
        Relative error of each coefficient.
    own_effects : tuple of str
        Effects that follow from its soils and are not given in a scene.
    friction : mapping or None
        Friction of its soils, which replaces the scene's.
    given : mapping or None
        Coefficients that replace computed ones.
    in_standing_water : bool
        Whether standing water covers its lower end.
    rotation_range : tuple
        Rotations up-slope and down-slope that limit the range of the method, rad, by convention 30 degrees.
    centre, entry, exit, centroid : array
        Centre of the circle, lower end of the slip surface, and centroid of the mass, x and y in m.
    area : float or array
        Area of the section of the mass, m^2.
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
    entry: Any
    exit: Any
    area: Any
    centroid: Any
    rounding: ClassVar[float] = 4 * EPS
    own_effects: ClassVar[Names] = ()
    friction: Any = None
    given: Any = None
    in_standing_water: Any = False
    rotation_range: Any = (-math.pi / 6, math.pi / 6)

    # --- optional methods, not needed by a plain arc -----------------------------------------------------------------

    def geometry_errors(self) -> Iterator[Fault]:
        """Yield the errors of lanes that are not valid masses or cannot move.

        A lane is one case of an ensemble. An error is a mask of lanes and a function from the index of a lane to its
        message.
        """
        return iter(())

    def mistakes(self, friction: Any, effects: Effects) -> list[str]:
        """Return messages about combinations of friction and effects for which the mass has no motion.

        ``friction`` is the scene's, and ``effects`` are parameters by the effect's name.
        """
        if "gradient" in effects.get("cohesion", {}):
            return ["{effects.cohesion.gradient}: needs a ground, below which the cohesion grows, in place of an arc"]
        return []

    def effects_with_own(self, effects: Effects) -> Effects:
        """Return effects with the mass's own effects: cohesion by a law, a section's water level, strengths of soils.

        Effects are mappings of parameters by the effect's name.
        """
        if not self.cohesion_laws(effects.get("cohesion", {})):
            return effects
        moment = self.moment_coefficients.resistance_factor / self.reference_stress  # moment of 1 Pa
        return {**effects, "cohesion": {}, f"softening_cohesion{OF_COHESION}": {"moment": moment}}

    def cohesion_laws(self, cohesion: Parameters) -> tuple[Law, ...]:
        """Return the laws by which cohesion changes with slip, from the scene or from its soils.

        ``cohesion`` contains the parameters of that effect; each law has a name and parameters.
        """
        law = cohesion_law(cohesion) if cohesion else None
        return ((law[0] + OF_COHESION, law[1]),) if law else ()

    def effects_of_means(self, effects: Effects) -> Effects:
        """Return the effects for unweighted means over the arc, unchanged for homogeneous ground.

        Effects are mappings of parameters by the effect's name.
        """
        return effects

    def tables(
        self, effects: Effects, friction: Any, upslope: bool, tolerance: float, shape: Shape
    ) -> tuple[Tables, Farther | None]:
        """Return functions of the rotation by symbol, and the function that extends them, if one may be needed.

        ``upslope`` is true if the mass may move above its initial position, ``tolerance`` is a relative error, and
        ``shape`` is the shape of the scene's lanes.
        """
        return {}, None

    @property
    def quantities(self) -> dict[str, Parameter]:
        """Declarations (unit, bounds, meaning) of the fields that are numbers, by the name of the field."""
        kind: Any = type(self)
        return declared(kind)

    @cached_property
    def has_plain_numbers(self) -> bool:
        """Whether all numbers of the mass are floats, so that it belongs to a single scene."""
        return {float}.issuperset(type(getattr(self, name)) for name in self.quantities)

    def parts(self) -> Parts:
        """Return the numbers, and the nodes with further numbers, by name, each with its declaration.

        A node is an object or a mapping, such as a soil, points, or the parameters of an effect.
        """
        by_name: Parts = lazy_import("tree").parts_of_fields(self)
        return by_name

    def with_parts(self, changed: Values) -> Any:
        """Return the mass with other values of some parts, by the names in `parts`. Nothing is checked."""
        return lazy_import("tree").replace_unchecked(self, changed)

    def together(self, values: Values) -> Values:
        """Return ``values`` of some numbers by name, with the values of further numbers that they determine."""
        return values

    def numbers_without_effect(self) -> Collection[str]:
        """Return the names of numbers that need not be varied.

        They have no influence on the motion or are determined by other numbers.
        """
        return ()

    def drowned(self, *rotations: float) -> float:
        """Return how far the ground over the mass comes below a water level after any of the rotations in rad, m.

        The base class has no water and returns 0.
        """
        return 0.0

    # --- position after a rotation about the centre -------------------------------------------------------------------

    def placed(self, points: Any, rotation: Any) -> Any:
        """Return the positions of points of the mass, (..., 2) in m, after a rotation in rad about the centre."""
        return lazy_import("journey").placed(self, points, rotation)

    def journey(self, rotation: Any) -> Any:
        """Return the displacement of toe and centroid by a rotation in rad, a `slipcircle.history.Journey`."""
        return lazy_import("journey").journey(self, rotation)

    # --- derived quantities -------------------------------------------------------------------------------------------

    @property
    def mean_unit_weight(self) -> Any:
        """Weight over area, N/m^3."""
        return self.unit_weight

    @property
    def mass_per_metre(self) -> Any:
        """Mass per metre of width, kg/m."""
        return self.area * np.divide(self.mean_unit_weight, self.gravity)

    @cached_property
    def sagitta(self) -> Any:
        """Depth of the arc below its chord (2.12), f, the scale of stresses, m."""
        versine = 2 * np.sin(self.half_angle / 2) ** 2  # 1 - cos(alpha)
        return np.multiply(self.radius, versine)

    @cached_property
    def time_scale(self) -> Any:
        """Time scale (3.9), t_c = sqrt(R/g), s."""
        return float_or_array(np.sqrt(np.divide(self.radius, self.gravity)))

    @cached_property
    def scales(self) -> Values:
        """Scales that make the parameters of effects dimensionless, by the names in `generated.effects`."""
        return {
            "half_angle": self.half_angle,
            "gravity": self.gravity,
            "reference_stress": self.reference_stress,
            "Theta": self.dimensionless.moment_of_inertia,
            "radius": float_or_array(self.radius),
            "density": float_or_array(self.mean_unit_weight) / float_or_array(self.gravity),
            "cover": self.moment_coefficients.cover,
        }

    @cached_property
    def units(self) -> Values:
        """Scales that make lengths, velocities and times dimensionless, by their units."""
        radius = float_or_array(self.radius)
        return {"m": radius, "m/s": radius / self.time_scale, "s": self.time_scale}

    @cached_property
    def initial_cells(self) -> Values:
        """Cells that do not depend on friction, effects and start, by name."""
        balance = self.moment_coefficients
        records = {"LIMIT": abs(balance.limit_friction), "CLOSE": INFINITY, "LIFT_TIME": math.nan}
        return dict(zip(INPUTS, balance, strict=False)) | records

    @cached_property
    def reference_stress(self) -> Any:
        """Stress scale (2.13), sigma_ref, Pa."""
        return np.multiply(self.mean_unit_weight, self.sagitta)

    @cached_property
    def static_normal_stress(self) -> Any:
        """Mean normal stress on the arc at rest (2.27), sigma_n0, Pa."""
        return self.reference_stress * self.dimensionless.static_normal_stress
