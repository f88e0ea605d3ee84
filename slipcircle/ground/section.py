"""Failed section of a real slope: ground, circle, water level, and the mass between ground and arc."""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.arrays import freeze
from slipcircle.base.errors import Fault, complaint, raise_all
from slipcircle.base.kinds import Effects, Floats, Pair, Shape, Texts, ValueDict
from slipcircle.base.units import take_units
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.arc import GRAVITY, WIDTH, Arc
from slipcircle.core.scene.declarations import declared, number
from slipcircle.core.scene.dimensionless import Dimensionless
from slipcircle.core.scene.mass import Farther, Mass, MomentCoefficients
from slipcircle.core.scene.piecewise import Tables
from slipcircle.ground.errors import geometry_errors, motion_errors
from slipcircle.ground.geometry import SectionGeometry
from slipcircle.ground.ground import FAR, WEIGHT, leading_shape, line_errors, section_errors
from slipcircle.ground.plane import Vectors

# Fields of the geometry, and cached properties that depend on them alone.
_GEOMETRY = ("ground", "centre", "radius", "between", "level", "confined", "ponds")
_OF_GEOMETRY = [name for name, value in vars(SectionGeometry).items() if isinstance(value, cached_property)]
_OF_GEOMETRY += ["sagitta", "pressure_kinks", "_strips", "profile"]


@dataclass(frozen=True)
class Section(SectionGeometry, Mass):
    """Mass between a ground of straight edges and a circular slip surface.

    Parameters
    ----------
    ground : array_like
        Points from left to right, (..., V, 2), x and y in m; equal x is a vertical scarp.
    centre : array_like
        Centre of the circle, (..., 2), m.
    radius : float or array_like
        Radius of the circle, m.
    unit_weight : float or array_like
        Unit weight of the soil, N/m^3.
    gravity, width : float or array_like, optional
        Acceleration of gravity, m/s^2, and length perpendicular to the section, m.
    between : pair of float, optional
        Range of x that contains the intended mass or at least its middle, if the circle cuts off several masses.
    level : array_like, optional
        Points of the water level from left to right, (..., W, 2), m, over the whole mass; it continues horizontally
        beyond them. Where it lies above the ground it is free water and must be horizontal.
    water_unit_weight : float
        Unit weight of water, N/m^3.
    base : float, optional
        y of a firm layer, below which no circle may extend, m.
    confined : bool
        Whether the water is confined. A level above the ground then indicates artesian pressure without free water.
    ponds : sequence of (x1, x2, level)
        Free water between two shores with a separate pore pressure, m.

    Raises
    ------
    ValueError
        If the input is invalid: a circle that misses the ground, several masses without a choice, points out of order,
        a centre below the ground, free water that is not horizontal. The message lists all mistakes.

    Notes
    -----
    Ground, centre, radius and level may be arrays with leading axes; results have their broadcast shape. Angles are
    measured from straight below the centre. The mass faces the direction in which gravity turns it, ``entry`` is its
    upper end, and positive is down-slope throughout.

    For exact coordinates the relative error of the moments is about 1e-14 (for J_r and J_theta relative to the length
    of their vector), however thin the mass. The error of ``mean_cover`` and ``mean_pressure`` is about 4e-15 (1 +
    1/alpha) of the greatest height above the arc, where alpha is half its angle (at most 1e-13/alpha in 2,000 random
    arcs). A vertex within rounding of the circle (32 times 2e-16 of the coordinates) counts as on it. This changes a
    mass of depth f by up to about 1e-14 (R + x + y)/f, where x and y are its greatest coordinates, and by 1e-6 at alpha
    = 1e-5. The cover and the water head of a point of the arc are taken at its x. Where the arc overhangs, the column
    above it is ground outside the mass.
    """

    ground: ArrayLike = field(metadata=number("m", -FAR, FAR, key="ground.points_m", axes=2))
    centre: ArrayLike = field(
        metadata=number("m", -FAR, FAR, "two finite numbers [x, y] within 1e9 m", key="circle.centre_m", axes=1)
    )
    radius: ArrayLike = field(metadata=number("m", 0.0, FAR, "a positive length below 1e9 m", key="circle.radius_m"))
    unit_weight: ArrayLike = field(metadata=number("N/m^3", *WEIGHT, key="ground.unit_weight_kN_m3", per_unit=1e3))
    gravity: ArrayLike = field(
        default=GRAVITY, metadata={"number": replace(declared(Arc)["gravity"], key="ground.gravity_m_s2")}
    )
    width: ArrayLike = field(default=WIDTH, metadata={"number": replace(declared(Arc)["width"], key="ground.width_m")})
    between: Pair | None = field(
        default=None, metadata=number("m", -FAR, FAR, "two x in m, from left to right", kind="fixed", axes=1)
    )
    level: ArrayLike | None = field(default=None, metadata=number("m", -FAR, FAR, key="water.level_m", axes=2))
    water_unit_weight: float = field(default=9810.0, metadata=number("N/m^3", *WEIGHT, kind="fixed"))
    base: float | None = field(default=None, metadata=number("m", -FAR, FAR, "one finite number in m", kind="fixed"))
    confined: bool = False
    ponds: Sequence[tuple[float, float, float]] = ()
    rounding: ClassVar[float] = 1e-14

    def __post_init__(self) -> None:
        """Check lines, circle and numbers, convert their units and freeze them."""
        take_units(self, (*self.quantities, "ponds"))
        freeze(self, self.quantities)
        errors = section_errors(self)
        if not errors:
            impossible = geometry_errors(self)
            errors = complaint(impossible, self.shape)
        raise_all("Section", errors)

    def takes_geometry(self, other: Section) -> bool:
        """Return whether another section has the same arrays of lines and circle, so that results can be copied."""
        return all(getattr(self, name) is getattr(other, name) for name in _GEOMETRY)

    def take_geometry(self, other: Section) -> None:
        """Copy the computed properties of another section with the same geometry."""
        copy_computed(other, self, _OF_GEOMETRY)

    def __eq__(self, other: object) -> bool:
        """Return whether another section has equal fields."""
        if not isinstance(other, Section):
            return False
        names = [field.name for field in fields(self)]
        pairs = [(getattr(self, name), getattr(other, name)) for name in names]
        return all(np.array_equal(*pair) for pair in pairs)

    # --- mechanics ---------------------------------------------------------------------------------------------------

    def geometry_errors(self) -> Iterator[Fault]:
        """Yield the errors of invalid sections and of sections that cannot move.

        An error is a mask of lanes (cases of an ensemble) and a function from the index of a lane to its message.
        """
        yield from line_errors("ground", self._circle[0])
        if self.level is not None:
            yield from line_errors("level", self._level)
        yield from geometry_errors(self)
        yield from motion_errors(self)

    def mistakes(self, friction: Any, effects: Effects) -> Texts:
        """Return messages if the method does not apply, or if a water level is combined with another pore pressure.

        ``friction`` and ``effects`` are the scene's; effects are mappings of parameters by name.
        """
        faults = [f"arc: {sentence}" for sentence in complaint(motion_errors(self), self.shape)]
        if self.level is not None and "ratio" in effects.get("pore_pressure", {}):
            faults.append(
                "{effects.pore_pressure.ratio}: cannot be combined with the level of the section, which says the pore "
                "pressure already; leave one out"
            )
        cohesion = effects.get("cohesion", {})
        grows = np.any(cohesion.get("gradient"))
        peak = cohesion.get("peak", 1.0)
        if grows and not np.all(peak):
            faults.append(
                "{effects.cohesion.peak} = 0: must be positive, as the law multiplies the increase with depth"
            )
        return faults

    def effects_with_own(self, effects: Effects) -> Effects:
        """Return effects with the pressure of the section's water level, standing water, and depths of cohesion.

        These stay in place as the mass turns through them.
        """
        cohesion = effects.get("cohesion", {})
        effects = super().effects_with_own(effects)
        grows = np.any(cohesion.get("gradient"))
        if grows:
            effects = lazy_import("depths").growing(self, cohesion, effects)
        pore_pressure = dict(effects.get("pore_pressure", {}))
        if self.level is not None or self.in_standing_water:
            pore_pressure["level"] = self.mean_lift
        if self.in_standing_water:
            pore_pressure["standing"] = self.standing_moment
        if pore_pressure:
            return {**effects, "pore_pressure": pore_pressure}
        return effects

    # Rotations within the range of the method, rad: the toe must not rise far above the original ground.
    rotation_range = cached_property(lambda self: lazy_import("toe").rotation_range(self))

    @property
    def lanes_shape(self) -> Shape:
        """Shape of the lanes (cases of an ensemble) that functions of the rotation have, () for a single section."""
        if self.in_standing_water:
            return np.broadcast_shapes(self.shape, np.shape(self.unit_weight))
        return self.shape

    @cached_property
    def has_plain_numbers(self) -> bool:
        """Whether the section has one soil and no number with lanes, so that it belongs to a single scene."""
        if self.friction is not None:
            return False
        for name, quantity in self.quantities.items():
            value = getattr(self, name)
            if value is not None and leading_shape(value, quantity.axes):
                return False
        return True

    @property
    def _weighted_moments(self) -> Mapping[str, Floats]:
        """Integrals of `circles.MEASURES` over the mass, weighted by unit weight over mean unit weight."""
        return self._moments

    @cached_property
    def centroid(self) -> Any:
        """Centroid of the mass, x and y in m."""
        _, centre, radius = self._circle
        m = self._weighted_moments
        first_moment = Vectors(m["moment_x"], m["moment_y"])
        from_centre = first_moment * (radius / m["area"])
        return self._shaped(centre + from_centre.points)

    @cached_property
    def moments(self) -> ValueDict:
        """Dimensionless moments by name: Theta* (3.12), I_p* (2.17), J_r (2.23), J_theta (3.13), and two slopes.

        The slopes are the derivatives of J_r and J_theta with respect to the dip.
        """
        m = self._weighted_moments
        way = self._facing
        moments = {
            "moment_of_inertia": m["inertia"],
            "polar_moment": m["polar"],
            "radial_weight": -m["radial_y"],
            "weight_moment": -way * m["moment_x"],
            "radial_weight_slope": way * m["radial_x"],
            "weight_moment_slope": -m["moment_y"],
        }
        return {name: self._shaped(value) for name, value in moments.items()}

    @cached_property
    def dimensionless(self) -> Dimensionless:
        """Dimensionless coefficients of the equation of motion at the start, positive down-slope, by (3.14) for lambda.

        Here lambda = 2 alpha f/R, where f is the depth of the arc below its chord.
        """
        m = self.moments
        alpha = self.half_angle
        inertia = m["moment_of_inertia"]
        radial = m["radial_weight"]
        moment = m["weight_moment"]
        factor = 4 * alpha * np.sin(alpha / 2) ** 2
        return Dimensionless(
            moment_of_inertia=inertia,
            radial_weight=radial,
            weight_moment=moment,
            resistance_factor=factor,
            dynamic_coefficient=m["polar_moment"] / factor,
            static_normal_stress=radial / factor,
            limit_friction=moment / radial,
            radial_weight_per_inertia=radial / inertia,
            polar_moment_per_inertia=m["polar_moment"] / inertia,
        )

    @cached_property
    def moment_coefficients(self) -> MomentCoefficients:
        """Coefficients of the balance of moments. r_u is relative to the overburden gamma h averaged over the arc."""
        m = self.moments
        d = self.dimensionless
        inertia = d.moment_of_inertia
        return MomentCoefficients(
            driving_moment=d.weight_moment / inertia,
            driving_moment_slope=m["weight_moment_slope"] / inertia,
            normal_load=d.radial_weight_per_inertia,
            normal_load_slope=m["radial_weight_slope"] / inertia,
            resistance_factor=d.resistance_factor / inertia,
            polar_moment=d.polar_moment_per_inertia,
            limit_friction=d.limit_friction,
            cover=self.mean_cover / (self.sagitta * d.static_normal_stress),
        )

    # --- water -------------------------------------------------------------------------------------------------------

    def mean_pressure(self, rotation: Any = 0.0) -> Any:
        """Return the mean pore pressure on the arc below the mass after a rotation, Pa.

        The level stays in place as the mass turns through it. The function is smooth between the ``pressure_kinks``.

        Parameters
        ----------
        rotation : float or array_like
            Rotations in rad, positive down-slope, with the shape of the section as last axes.
        """
        return lazy_import("water").mean_pressure(self, rotation)

    def mean_lift(self, rotation: Any = 0.0) -> Any:
        """Return the mean pressure that reduces the normal stress of the weight, Pa, after rotations in rad.

        Below standing water it consists of the pressure in excess of hydrostatic pressure and the weight of displaced
        water.
        """
        return lazy_import("water").mean_lift(self, rotation)

    def standing_moment(self, rotation: Any = 0.0) -> Any:
        """Return the moment of the weight of displaced water over gamma R^3 Theta*, after rotations in rad.

        It is the weight of water that the mass displaces below standing water; gamma is the mean unit weight.
        """
        return lazy_import("standing").standing_moment(self, rotation)

    def tables(
        self, effects: Effects, friction: Any, upslope: bool, tolerance: float, shape: Shape
    ) -> tuple[Tables, Farther | None]:
        """Return the effects of water, and the depth with which cohesion grows, as tables of the rotation by symbol.

        ``upslope`` is true if the mass may move above its initial position, ``tolerance`` is the relative error of the
        tables, and ``shape`` is the scene's shape. Since they extend to the loss of contact, no function to extend them
        is returned.
        """
        tables: Tables = lazy_import("water").tables_of(self, effects, upslope, tolerance, shape)
        return tables, None

    @cached_property
    def pressure_kinks(self) -> Any:
        """Rotations at which the mean pressure is not smooth, rad, sorted, (..., kinks)."""
        return lazy_import("water").pressure_kinks(self)

    def drowned(self, *rotations: float) -> float:
        """Return the greatest depth below the water level of the ground over one section's mass after rotations, m.

        The rotations are in rad, positive down-slope; the greatest depth after any of them counts.

        Below standing water at the exit, which is included, how far below a higher level elsewhere.
        """
        if self.level is None or self.confined:
            return 0.0
        depth: float = lazy_import("standing").drowned_depth(self, rotations)
        return depth


def copy_computed(source: object, target: object, names: Collection[str]) -> None:
    """Copy cached properties from one object to another.

    Of the given names, only properties that have been computed are copied.
    """
    computed = vars(source)
    for name in names:
        if name in computed:
            vars(target)[name] = computed[name]
