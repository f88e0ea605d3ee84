"""The failed section of a real slope: a ground, a circle, a water level, and the mass between ground and arc."""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from itertools import chain
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.checks import Fault, complaint, raise_all
from slipcircle.core.scene import circles
from slipcircle.core.scene.circles import Cut, Floats
from slipcircle.core.scene.errors import geometry_errors, motion_errors
from slipcircle.core.scene.ground import line_errors, section_errors
from slipcircle.core.scene.heights import HeightIntegrals, height_integrals, integral_inside
from slipcircle.core.scene.turning import TurningMass
from slipcircle.core.scene.weights import Dimensionless, MomentCoefficients, SlidingBody

# The fields that the geometry consists of, and what is computed of them alone.
_GEOMETRY = ("ground", "centre", "radius", "between", "level")
_OF_GEOMETRY = (
    *("shape", "_circle", "_cut", "_candidates", "_ends", "_mine", "_moments", "_facing", "facing", "_angles"),
    *("_chord", "half_angle", "dip", "entry", "exit", "area", "depth", "mean_cover", "sagitta", "_level", "_water"),
    *("pressure_kinks", "_lines_over_radius", "_strips", "profile"),
)


@dataclass(frozen=True)
class Section(SlidingBody, TurningMass):
    """A slip circle through a ground of straight edges, with the mass between ground and arc.

    Parameters
    ----------
    ground : array_like
        Points from left to right, (..., V, 2), x and y in m; equal x is a vertical scarp.
    centre : array_like
        Of the circle, (..., 2), m.
    radius : float or array_like
        m.
    unit_weight : float or array_like
        N/m^3.
    gravity, width : float or array_like, optional
        m/s^2; length across the section, m.
    between : pair of float, optional
        Range of x that contains the intended mass, or x of its middle, if the circle cuts off several masses.
    level : array_like, optional
        Points of the water level from left to right, (..., W, 2), m; it continues horizontally beyond them.
    water_unit_weight : float
        N/m^3.
    base : float, optional
        y of a firm layer below which no circle goes, m.

    Raises
    ------
    ValueError
        Lists every mistake, one sentence each: a circle that misses the ground, several masses without a choice, points
        out of order, a centre below the ground, a pond, ...

    Notes
    -----
    Ground, centre, radius and level may be arrays with leading axes; results have their broadcast shape. Angles are
    measured from straight below the centre. The mass faces the way in which gravity turns it, ``entry`` is its upper
    end, and positive is down-slope throughout.

    For exact coordinates the moments are accurate to about 1e-14 (J_r, J_theta: relative to the length of their vector)
    however thin the mass; ``mean_cover`` and ``mean_pressure`` to about 4e-15 (1 + 1/alpha) of the greatest height
    above the arc, alpha half its angle (1e-13/alpha at worst of 2,000 random arcs). A vertex within rounding of the
    circle (32 times 2e-16 of the coordinates) counts as on it, which changes a mass of depth f by up to about 1e-14 (R
    + x + y)/f, x and y its greatest coordinates: by 1e-6 at alpha = 1e-5. The cover and the water head of a point of
    the arc are those at its x, also where the arc overhangs: the column above it is then ground outside the mass.
    """

    ground: ArrayLike
    centre: ArrayLike
    radius: ArrayLike
    unit_weight: ArrayLike
    gravity: ArrayLike = 9.81
    width: ArrayLike = 1.0
    between: tuple[float, float] | None = None
    level: ArrayLike | None = None
    water_unit_weight: float = 9810.0
    base: float | None = None
    # What scenes vary, with the axes of one section.
    quantities: ClassVar[Mapping[str, int]] = {
        "ground": 2,
        "centre": 1,
        "radius": 0,
        "unit_weight": 0,
        "gravity": 0,
        "width": 0,
        "level": 2,
    }
    rounding: ClassVar[float] = 1e-14
    given: ClassVar[None] = None

    def __post_init__(self) -> None:
        raise_all(
            "Section", section_errors(vars(self), self.quantities) or complaint(geometry_errors(self), self.shape)
        )

    def takes_geometry(self, other: Section) -> bool:
        """Whether this is another section's circle through the same lines."""
        return all(getattr(self, name) is getattr(other, name) for name in _GEOMETRY)

    def take_geometry(self, other: Section) -> None:
        """What another section has computed of a geometry that is the same."""
        known = vars(other)
        vars(self).update((name, known[name]) for name in _OF_GEOMETRY if name in known)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Section) and all(
            np.array_equal(value, getattr(other, f.name)) for f in fields(self) for value in [getattr(self, f.name)]
        )

    # --- the stretch -------------------------------------------------------------------------------------------------

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Of the results."""
        leading = []
        for name in ("radius", "centre", "ground", "level"):
            shape = np.shape(getattr(self, name))
            axes = self.quantities[name]
            leading.append(shape[: len(shape) - axes])
        return np.broadcast_shapes(*leading)

    @cached_property
    def _circle(self) -> tuple[Floats, Floats, Floats]:
        """Ground, centre and radius with one axis of lanes."""
        centre = np.broadcast_to(np.add(self.centre, 0.0), (*self.shape, 2))
        radius = np.broadcast_to(np.add(self.radius, 0.0), self.shape)
        return self._lines(self.ground), centre.reshape(-1, 2), radius.reshape(-1)

    def _lines(self, points: Any) -> Floats:
        """Lines with one axis of lanes; of one for all that is 1."""
        points = np.add(points, 0.0)
        own = points.shape[-2:]
        if points.ndim > 2:
            points = np.broadcast_to(points, (*self.shape, *own))
        return points.reshape(-1, *own)

    @cached_property
    def _cut(self) -> Cut:
        return circles.cut(*self._circle)

    @cached_property
    def _candidates(self) -> tuple[Any, Any, Any, Any, Any]:
        """Lane, number and both x of the stretches that may be meant; and which circles hold an end of the ground."""
        _, centre, radius = self._circle
        lane, number, held = circles.stretches(self._cut)
        (left_x, _), (right_x, _) = circles.ends(self._cut.only(lane), number)
        r = radius[lane]
        left = centre[lane, 0] + r * left_x
        right = centre[lane, 0] + r * right_x
        if self.between is None:
            return lane, number, left, right, held
        low, high = self.between
        rounding = 1e-9 * r
        keep = (left >= low - rounding) & (right <= high + rounding)
        kept = np.bincount(lane, keep, len(radius))
        without = kept[lane] == 0
        middle = (left + right) / 2
        middle_between = (middle >= low) & (middle <= high)
        keep |= without & middle_between
        return lane[keep], number[keep], left[keep], right[keep], np.zeros_like(held)

    @cached_property
    def _ends(self) -> tuple[Floats, Floats]:
        """The left and the right end of the arc from the centre, over R."""
        return circles.ends(self._cut, self._candidates[1])

    @cached_property
    def _mine(self) -> Any:
        return self._cut.stretch == self._candidates[1][:, None]

    @property
    def _edges_over_mass(self) -> Any:
        """Which edges of the ground of one section lie over its mass."""
        return self._mine[0] & ((self._cut.e_x[0] != 0.0) | (self._cut.e_y[0] != 0.0))

    @cached_property
    def _moments(self) -> dict[str, Floats]:
        return circles.moments(self._cut, self._mine)

    def _shaped(self, values: Any) -> Any:
        """Values by lane in the shape of the results; a number where there are no arrays."""
        values = np.asarray(values)
        return values.reshape((*self.shape, *values.shape[1:]))[()]

    # --- geometry ----------------------------------------------------------------------------------------------------

    @cached_property
    def _facing(self) -> Floats:
        (_, left_y), (_, right_y) = self._ends
        by_weight = -np.sign(self._moments["moment_x"])
        by_height = np.where(left_y < right_y, -1.0, 1.0)
        return np.where(by_weight != 0.0, by_weight, by_height)

    @cached_property
    def facing(self) -> Any:
        """1 where gravity turns the mass to the right, -1 to the left."""
        return self._shaped(self._facing)

    @cached_property
    def _angles(self) -> tuple[Floats, Floats]:
        """Of both ends from straight below the centre, left to right."""
        (x1, y1), (x2, y2) = self._ends
        return np.arctan2(x1, -y1), np.arctan2(x2, -y2)

    @cached_property
    def _chord(self) -> Floats:
        """From the left to the right end, over R, (2, n)."""
        parts = self._cut.e_x, self._cut.e_y
        return np.stack([np.where(self._mine, part, 0.0).sum(axis=1) for part in parts])

    @cached_property
    def chord(self) -> Any:
        """Its length, m."""
        return self._shaped(np.hypot(*self._chord)) * self.radius

    @cached_property
    def half_angle(self) -> Any:
        """alpha, half the opening angle of the arc, rad."""
        left, right = self._angles
        by_ends = (right - left) / 2
        sine = np.minimum(np.hypot(*self._chord) / 2, 1.0)
        by_chord = np.where(by_ends <= np.pi / 2, np.arcsin(sine), np.pi - np.arcsin(sine))
        return self._shaped(np.where(sine > 0.7, by_ends, by_chord))  # each where it keeps its digits

    @cached_property
    def dip(self) -> Any:
        """psi, the dip of the chord, rad, positive down-slope."""
        run, rise = self._chord
        return self._shaped(np.arctan2(-self._facing * rise, run))

    def _end(self, way: float) -> Any:
        """The left end where the mass faces this way, else the right."""
        _, centre, radius = self._circle
        left, right = (centre + radius[:, None] * end.T for end in self._ends)
        return self._shaped(np.where((self._facing == way)[:, None], left, right))

    @cached_property
    def entry(self) -> Any:
        """Upper end of the slip surface, x and y in m."""
        return self._end(1.0)

    @cached_property
    def exit(self) -> Any:
        """Lower end of the slip surface, the toe at the start, x and y in m."""
        return self._end(-1.0)

    @cached_property
    def area(self) -> Any:
        """Of the section, m^2."""
        return self._shaped(self._moments["area"]) * np.square(self.radius)

    @cached_property
    def mass_per_metre(self) -> Any:
        """kg/m."""
        return self.area * np.divide(self.mean_unit_weight, self.gravity)

    @cached_property
    def centroid(self) -> Any:
        """Of the mass, x and y in m."""
        _, centre, radius = self._circle
        first_moments = np.stack([self._moments["moment_x"], self._moments["moment_y"]], axis=1)
        from_centre = first_moments * (radius / self._moments["area"])[:, None]
        return self._shaped(centre + from_centre)

    @cached_property
    def depth(self) -> Any:
        """Greatest thickness of the mass along a radius, m."""
        return self._shaped(circles.thickness(self._cut, self._mine)) * self.radius

    @cached_property
    def mean_cover(self) -> Any:
        """Mean height of the ground above the arc, m; times r_u and the unit weight it is a mean pressure.

        Where the arc overhangs, it is the ground outside the mass.
        """
        first, last = self._angles
        integral = np.where(self._mine, integral_inside(self._cut), 0.0).sum(axis=1)
        overhangs = (first < -np.pi / 2) | (last > np.pi / 2)
        if overhangs.any():
            integral = np.where(overhangs, height_integrals(*self._circle).integral(first, last), integral)
        return self._shaped(integral) / (2 * self.half_angle) * self.radius

    # --- mechanics ---------------------------------------------------------------------------------------------------

    def geometry_errors(self) -> Iterator[Fault]:
        """Invalid sections, and sections that cannot move."""
        levels = () if self.level is None else line_errors("level", self._level)
        return chain(line_errors("ground", self._circle[0]), levels, geometry_errors(self), motion_errors(self))

    def section_effects(self, effects: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Mapping[str, Any]]:
        """Adds the mean pressure below the water level, which stays in place as the mass turns through it."""
        if self.level is None:
            return effects
        return {**effects, "pore_pressure": {**effects.get("pore_pressure", {}), "level": self.mean_pressure}}

    @cached_property
    def no_motion(self) -> str | None:
        """Why the method gives no motion, if so."""
        return next(iter(complaint(motion_errors(self), self.shape)), None)

    @cached_property
    def moments(self) -> dict[str, Any]:
        """Theta*, I_p*, J_r, J_theta (3.12), (2.17), (2.23), (3.13), and the derivatives of the last two by the dip."""
        m = self._moments
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
        """Coefficients of the equation of motion, positive down-slope; lambda = 2 alpha f/R (3.14)."""
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
        """Coefficients of the balance of momentum; r_u is relative to the overburden gamma h, averaged over the arc."""
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

    @cached_property
    def _level(self) -> Floats:
        return self._lines(self.level)

    @cached_property
    def _water(self) -> HeightIntegrals:
        return height_integrals(self._level, *self._circle[1:])

    def mean_pressure(self, rotation: Any = 0.0) -> Any:
        """Mean pore pressure on the arc under the mass after a rotation, Pa.

        The level stays in place as the mass turns through it; smooth between the ``pressure_kinks``.

        Parameters
        ----------
        rotation : float or array_like
            rad, positive down-slope, (...,) in front of the shape of the section.
        """
        if self.level is None:
            return 0.0 * np.add(rotation, np.zeros(self.shape))
        turn = np.asarray(rotation, dtype=np.float64)
        shape = np.broadcast_shapes(turn.shape, self.shape)
        by_lane = np.broadcast_to(turn, shape).reshape(*shape[: len(shape) - len(self.shape)], -1)
        turned = by_lane * self._facing
        first, last = self._angles
        mean_height = self._water.integral(first + turned, last + turned) / (last - first)
        return (mean_height.reshape(shape) * np.multiply(self.radius, self.water_unit_weight))[()]

    @cached_property
    def pressure_kinks(self) -> Any:
        """Rotations at which the mean pressure is not smooth, rad, sorted, on a last axis."""
        if self.level is None:
            return self._shaped(np.empty((len(self._facing), 0)))
        until_kink = [self._water.kinks - end[:, None] for end in self._angles]
        turns = np.concatenate(until_kink, axis=1) * self._facing[:, None]
        return self._shaped(np.sort(turns, axis=1))
