"""Layered ground: section of a real slope whose mass and slip surface consist of several soils.

*Weights* add exactly, surface by surface (`slipcircle.layers.strips`). *Resistance* with several friction coefficients
needs a closure, since the balance (2.1) determines the mean normal stress alone: each stretch of the arc carries the
weights of (2.23) of the material vertically above it. Their sums over the arc equal J_r, its slope and I_p, so that the
method is the paper's for a single friction coefficient. `slipcircle.layers.strength` implements the closure.
"""

from __future__ import annotations  # so that a signature says ArrayLike

import math
import operator
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import LAWS
from slipcircle.base.arrays import array_of, freeze
from slipcircle.base.errors import Fault, complaint, mistakes, raise_all
from slipcircle.base.kinds import ArrayPair, Effects, Floats, Names, Shape, Texts, Values
from slipcircle.base.units import take_units
from slipcircle.core.scene.declarations import number
from slipcircle.core.scene.effects import symbols_of
from slipcircle.core.scene.laws import rate_mistakes
from slipcircle.core.scene.mass import Farther
from slipcircle.core.scene.piecewise import Tables
from slipcircle.ground.circles import MEASURES
from slipcircle.ground.ground import FAR
from slipcircle.ground.section import Section, copy_computed
from slipcircle.layers.depths import Depths, depths_below
from slipcircle.layers.layered import RotationTables
from slipcircle.layers.layered_numbers import LayeredNumbers
from slipcircle.layers.profile import MEASURED, Profile, profile_of
from slipcircle.layers.soils import Layers, Soil, datum_mistakes, layer_mistakes, soil_mistakes, top_of
from slipcircle.layers.strength import ArcStrength, MeanFriction, Needs, OfRotation, over_circles
from slipcircle.layers.stretches import OF_GEOMETRY
from slipcircle.layers.strips import Strips, crossings_of_lines, cut_into_strips
from slipcircle.tree import numbers


@dataclass(frozen=True, eq=False)
class LayeredSection(LayeredNumbers):
    """Mass between layered ground and a circular slip surface.

    Parameters
    ----------
    layers : sequence of pairs
        Layers from the ground down, each a `Soil` and its top. The top is None for the first layer, which begins at the
        ground, and otherwise a height in m or points from left to right, (V, 2), continued horizontally. A boundary is
        cut off where it rises above the preceding boundary.
    strength : str
        "base": the strength belongs to the soils below the arc, over which the mass moves, and the soil at the exit
        continues beyond it. "mass": the strength moves with the mass.
    foreland : Soil, optional
        Soil along the arc beyond the exit, instead of the soil at the exit, with a separate growth of cohesion.
    surcharge : sequence of (x1, x2, q1, q2)
        Pressures on the ground that move with the mass and are shaken with it, Pa, linear from x1 to x2 in m. The
        pressures q1 and q2 may be arrays.
    rate : mapping, optional
        Law of speed that multiplies the friction of all soils, such as ``{"law": "rate_weakening", "peak": 1.0,
        "residual": 0.6, "velocity": 0.1}``.
    crack : float or array_like
        Depth of a dry tension crack, m. The slip surface begins at its bottom, where the mass is as thick.

    Notes
    -----
    The other parameters are described in `Section`. Each soil has its own unit weight.
    """

    unit_weight: ArrayLike = field(default=1.0, init=False, repr=False)  # see soils
    layers: Layers = ()
    strength: str = "base"
    foreland: Soil | None = None
    surcharge: Sequence[tuple[float, float, Any, Any]] = ()
    rate: Values | None = field(default=None, metadata={"laws": LAWS})
    crack: Any = field(default=0.0, metadata=number("m", 0.0, FAR, help="its depth", key="tension_crack.depth_m"))
    own_effects: ClassVar[Names] = ("cohesion", "pore_pressure")

    def __post_init__(self) -> None:
        """Check layers, surcharges and crack, convert their units and freeze them."""
        checked = ("layers", "surcharge", "rate", "crack")
        take_units(self, checked)
        freeze(self, checked)
        errors = layer_mistakes(self.layers, self.surcharge, self.strength, self.foreland)
        if not errors:
            for soil, _ in self.layers:  # their numbers may have been replaced
                errors += [f"soils.{soil.name}.{mistake}" for mistake in soil_mistakes(soil)]
        if self.rate is not None:
            errors += rate_mistakes(self.rate)
        raise_all("LayeredSection", errors)
        least = 0.0 if array_of(self.crack).ndim else -5e-324  # all lanes of an array have a crack
        depth = replace(
            self.quantities["crack"], lower=least, allowed="a depth of at least 0 in m, in an array above 0"
        )
        raise_all("LayeredSection", mistakes({"crack": self.crack}, {"crack": depth}))
        super().__post_init__()
        raise_all("LayeredSection", complaint([self._overhang], self.shape))

    @property
    def _overhang(self) -> Fault:
        """Fault of arcs that extend above the centre of their circle: a mask of lanes, and the message."""
        first, last = self._angles
        steepest = np.maximum(-first, last)
        above = "radius, centre: the arc reaches above the centre's height, where no soil lies straight above it"
        return steepest > np.pi / 2, lambda k: above

    def geometry_errors(self) -> Iterator[Fault]:
        """Yield the errors of invalid sections and of sections that cannot move."""
        yield from super().geometry_errors()
        yield self._overhang

    def __eq__(self, other: object) -> bool:
        """Return whether another section has equal soils, layers and fields."""
        if not isinstance(other, LayeredSection) or len(self.layers) != len(other.layers):
            return False
        if self.soils != other.soils:
            return False
        if not all(map(np.array_equal, self.tops, other.tops)):
            return False
        names = {field.name for field in fields(self)} - {"layers", "foreland"}
        return all(np.array_equal(getattr(self, name), getattr(other, name)) for name in names)

    # --- soils -------------------------------------------------------------------------------------------------------

    @cached_property
    def shape(self) -> Shape:
        """Shape of results that depend on the geometry alone, for one circle of all lanes or one per lane."""
        shapes = [super().shape, np.shape(self.crack)]
        for top in self.tops:
            shape = np.shape(top)
            is_line = len(shape) > 1
            shapes.append(shape[:-2] if is_line else shape)
        of_geometry = np.broadcast_shapes(*shapes)
        if np.prod(of_geometry) == 1:
            return of_geometry
        return np.broadcast_shapes(of_geometry, self._shape_of_numbers)

    @cached_property
    def lanes_shape(self) -> Shape:
        """Broadcast shape of the geometry and of all numbers of soils."""
        return np.broadcast_shapes(self.shape, self._shape_of_numbers)

    @property
    def _shape_of_numbers(self) -> Shape:
        """Broadcast shape of all numbers of soils and surcharges."""
        of_soils = numbers(self.soils_by_name).items()
        shapes = [np.shape(value) for name, value in of_soils if not name.endswith(".length")]
        shapes += [np.shape(pressure) for _, _, *ends in self.surcharge for pressure in ends]
        return np.broadcast_shapes(*shapes)

    @property
    def datums(self) -> list[Any]:
        """Heights in m or lines below which the cohesion of each of the `soils` grows, None for the ground."""
        tops = [None, *self.tops]
        if self.foreland is not None:
            tops.append(top_of(self.foreland, self.layers))
        return [top if soil.datum is None else soil.datum for soil, top in zip(self.soils, tops, strict=True)]

    @cached_property
    def depths(self) -> list[Depths | None]:
        """Depths of the arc below the datums of the soils, None where the cohesion does not grow."""
        raise_all("LayeredSection", datum_mistakes(self.foreland, self.layers))  # whose numbers may have been replaced
        depths = []
        for soil, datum in zip(self.soils, self.datums, strict=True):
            grows = np.any(soil.cohesion_gradient)
            depths.append(depths_below(self, datum) if grows else None)
        return depths

    def of_soils(self, name: str) -> Floats:
        """Return an attribute of each `Soil` by its name, such as "unit_weight", (soils, lanes)."""
        numbers = [getattr(soil, name) for soil in self.soils]
        return self._by_lane(numbers)

    def _by_lane(self, numbers: Sequence[Any]) -> Floats:
        """Return numbers or arrays as rows, (numbers, lanes)."""
        of_lanes = [np.broadcast_to(number, self.lanes_shape) for number in numbers]
        rows = np.add(of_lanes, 0.0)
        return rows.reshape(len(numbers), -1)

    def _shaped(self, values: Any) -> Any:
        """Return values by lane in the shape of the geometry or of all results."""
        values = np.asarray(values)
        of_geometry = len(values) == int(np.prod(self.shape))
        shape = self.shape if of_geometry else self.lanes_shape
        _, *components = values.shape
        return values.reshape((*shape, *components))[()]

    # --- geometry ----------------------------------------------------------------------------------------------------

    @cached_property
    def _saturated(self) -> bool:
        """Whether a soil is heavier below the water level."""
        if self.level is None:
            return False
        return any(soil.saturated_unit_weight is not None for soil, _ in self.layers)

    @cached_property
    def _strips(self) -> Strips:
        """Mass divided into strips, whose surfaces are the tops of layers and the wet parts of layers."""
        count = len(self.layers)
        surfaces = [tuple(range(k + 1)) for k in range(count)]
        if self._saturated:
            surfaces += [(*lines, count) for lines in surfaces]
        ground, centre, radius = self._circle
        lines = [ground, *map(self._top_line, self.tops)]
        if self.level is not None:
            lines.append(self._level)
        size = radius[:, None]
        over_radius = [(line - centre[:, None]) / size[..., None] for line in lines]
        from_first = centre - centre[:1]
        apart = from_first[:, :1]  # from the first circle, in whose place lines are crossed
        far = np.max(np.abs(apart) + 2 * size, initial=0.0)
        crossings = crossings_of_lines([line - centre[:1, None] for line in lines], far)
        cuts = [(x - apart) / size for x in crossings]
        loads = []
        for x1, x2, _, _ in self.surcharge:
            from_centre = (x1 - centre[:, :1], x2 - centre[:, :1])
            load = [x / size for x in from_centre]
            loads.append(load)
            cuts += load
        return cut_into_strips(over_radius, surfaces, count, self._ends, cuts, loads)

    @cached_property
    def profile(self) -> Profile:
        """Integrals along the arc of unit weights below the surfaces, by columns."""
        weights, _ = self._columns
        return profile_of(self._strips, weights)

    def heads_between(self, low: Floats, high: Floats) -> Floats:
        """Return integrals of the head of the water level over arcs in space, (..., circles).

        `low` and `high` are directions of the ends in rad, positive to the right.
        """
        return self._water.integral(low, high)

    # --- weights -----------------------------------------------------------------------------------------------------

    @cached_property
    def weight_steps(self) -> Floats:
        """Steps of the unit weight below each surface, and surcharges over R, N/m^3, (surfaces, lanes)."""
        count = len(self.layers)
        weight = self.of_soils("unit_weight")[:count]
        steps = [np.diff(weight, axis=0, prepend=0.0)]
        if self._saturated:
            increase = self.of_soils("weight_below_water")[:count] - weight
            steps.append(np.diff(increase, axis=0, prepend=0.0))
        if self.surcharge:
            pressures = []
            for _, _, left, right in self.surcharge:
                pressures += [left, right]
            _, _, radius = self._circle
            steps.append(self._by_lane(pressures) / radius)
        return np.concatenate(steps)

    @cached_property
    def _columns(self) -> ArrayPair:
        """Weights of the surfaces in columns, (columns, surfaces, circles), and of the columns, (columns, lanes).

        If lanes of one circle differ in the steps of the unit weight, each column is a surface; otherwise the only
        column contains all surfaces.
        """
        steps = self.weight_steps
        circles = math.prod(self.shape)
        of_circles = steps[:, :circles]
        has_lanes = of_circles.shape[1] == circles
        if not has_lanes or np.any(steps != of_circles):
            return np.eye(len(steps))[..., None], steps
        return of_circles[None], np.ones((1, steps.shape[1]))

    @cached_property
    def _moments_of_weight(self) -> Floats:
        """Integrals of `circles.MEASURES` times the unit weight over the mass, N/m^3, (7, lanes).

        The ground alone uses the integrals of a homogeneous mass, so that one soil in many layers equals a single
        layer.
        """
        whole = self.profile.whole[MEASURED]
        weights, by_lane = self._columns
        ground, *others = weights[0]
        if not np.any(others):
            whole[:, 0] = ground * list(self._moments.values())
        return over_circles(whole.transpose(1, 0, 2), by_lane)

    @cached_property
    def _weights_per_area(self) -> Floats:
        """Mean unit weight, N/m^3, (lanes,)."""
        of_area, *_ = self._moments_of_weight
        return of_area / self._moments["area"]

    @cached_property
    def _weighted_moments(self) -> Mapping[str, Floats]:
        """Integrals of `circles.MEASURES` over the mass, weighted by the relative unit weight."""
        return dict(zip(MEASURES, self._moments_of_weight / self._weights_per_area, strict=True))

    @cached_property
    def mean_unit_weight(self) -> Any:
        """Weight of the mass over its area, N/m^3."""
        return self._shaped(self._weights_per_area)

    # --- strength ----------------------------------------------------------------------------------------------------

    @cached_property
    def arc_strength(self) -> ArcStrength:
        """Strength along the arc."""
        return ArcStrength(self)

    @property
    def friction(self) -> MeanFriction:
        """Friction of the arc as a whole, for a `Scene`: a law with coefficients weighted over the soils."""
        return self.arc_strength.friction

    def mistakes(self, friction: Any, effects: Effects) -> Texts:
        """Return messages about friction and effects, also about inputs given both by the scene and by its soils."""
        of_soils = "is given by the soils of a layered section; leave it out"
        messages = super().mistakes(friction, effects)
        messages += [f"effects.{name}: {of_soils}" for name in self.own_effects if name in effects]
        if friction is not None and not isinstance(friction, MeanFriction):
            messages.append(f"friction = {friction!r}: {of_soils}")
        return messages

    def effects_with_own(self, effects: Effects) -> Effects:
        """Return effects by name with the strengths of the soils. Inertia terms require the centripetal effect."""
        strength = self.arc_strength
        needs = Needs("rotation" in effects, "shaking" in effects)
        terms = {"layered_strength": strength.terms(needs)}
        terms |= strength.soil_terms(needs)
        terms |= strength.cohesion_terms(needs)
        if "centripetal" not in effects:
            for effect, added in terms.items():
                without = [name for name in added if not name.endswith("inertia")]
                terms[effect] = {name: added[name] for name in without}
        return {**effects, **terms}

    def effects_of_means(self, effects: Effects) -> Effects:
        """Return the effects with only the mean of the pore pressures of the soils, by the names of the effects."""
        needs = Needs("rotation" in effects)
        shared = {name: effects[name] for name in effects if not name.startswith(("soil_", "softening_"))}
        return {**shared, "layered_strength": self.arc_strength.mean_lift(needs)}

    def tables(
        self, effects: Effects, friction: Any, upslope: bool, tolerance: float, shape: Shape
    ) -> tuple[Tables, Farther | None]:
        """Return the functions of the rotation of the soils, as far as the mass is likely to move.

        They are tables by name, and a function that extends them. `effects` and `friction` belong to the scene, whose
        lanes have the given shape. `upslope` states whether the mass may move above its initial position, and
        `tolerance` is a relative error.
        """
        functions = {}
        for effect, terms in effects.items():
            for name, term in terms.items():
                if isinstance(term, OfRotation):
                    functions[symbols_of(effect)[name]] = term
        if not functions:
            return {}, None
        tables = RotationTables(self, effects["layered_strength"], functions, tolerance, upslope, shape)
        return tables.laid_out(tables.likely_reach(friction)), tables.reach_farther

    def takes_geometry(self, other: Section) -> bool:
        """Return whether another section differs in numbers of soils only, so that geometry can be copied."""
        if not isinstance(other, LayeredSection):
            return False
        return super().takes_geometry(other) and _same_cut(self, other)

    def take_geometry(self, other: Section) -> None:
        """Copy the computed properties of another section with the same geometry."""
        super().take_geometry(other)
        if isinstance(other, LayeredSection) and "arc_strength" in vars(other):
            copy_computed(other.arc_strength, self.arc_strength, OF_GEOMETRY)


def _same_cut(one: LayeredSection, other: LayeredSection) -> bool:
    """Return whether two sections have the same boundaries, crack, surcharges, and datums of growing cohesion.

    Tops and cracks must be identical objects.
    """
    if _cut_of(one) != _cut_of(other) or one.crack is not other.crack:
        return False
    if not np.array_equal(one._columns[0], other._columns[0]):
        return False  # profiles depend on the weights of surfaces
    return all(map(operator.is_, one.tops, other.tops))


def _cut_of(section: LayeredSection) -> tuple[Any, ...]:
    """Return the properties of a section's cut that can be compared by value.

    They are the number of layers, switches, places of surcharges, and for each soil its own datum and whether its
    cohesion grows.
    """
    places = [load[:2] for load in section.surcharge]
    growing = [(soil.datum, bool(np.any(soil.cohesion_gradient))) for soil in section.soils]
    return len(section.layers), section.strength, section._saturated, places, growing
