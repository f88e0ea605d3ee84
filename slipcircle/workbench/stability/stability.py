"""Factors of safety of a slope on given circles by three methods: fields of slopes, and scenes of arrays."""

from __future__ import annotations  # so that a signature says ArrayLike

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import COHESION_LAWS
from slipcircle.base.arrays import freeze
from slipcircle.base.errors import complaint, raise_all
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import ArrayDict, ArrayPair, Floats, Function, Parameters, Shape, Texts, ValueDict, Values
from slipcircle.base.units import take_units
from slipcircle.ground import Ponds, Section, free_water, present, slope_errors, water_faults
from slipcircle.layers import (
    LayeredSection,
    Soil,
    cohesion_at_rest,
    friction_at_rest,
    growth_at_rest,
    is_law,
    law_mistakes,
    layer_mistakes,
)
from slipcircle.workbench.stability.bases import Circles
from slipcircle.workbench.stability.columns import SLOPE_NUMBERS, SlopeArrays, SoilArrays, level_line
from slipcircle.workbench.stability.factors import YIELD, circle_factors

# By name: whose it is, and the strength that it gives the base of a slice: weight W, breadth b, length l, dip a.
METHODS: Mapping[str, tuple[str, str]] = {
    "paper": (
        "the paper's method",
        "c + mu max(0, s), s the mean of the effective normal stress "
        "over the arc: every point of the mass contributes its weight times the cosine of its direction "
        "from the centre (2.23)",
    ),
    "ordinary": (
        "the ordinary method",
        "by Fellenius, c + mu (W cos a - k_h W sin a - u l)/l: a is the dip of the "
        "base below the point, so that the cosine is the larger one",
    ),
    "bishop": (
        "Bishop's method",
        "simplified, [c + mu (W/b - u)] cos a/m_alpha, m_alpha = cos a + sin a mu/F: horizontal "
        "forces between slices increase the normal stress on steep bases",
    ),
}


def least_of(method: str) -> str:
    """Return the quantity that a search by a method minimises, in words."""
    return "least yield coefficient" if method == YIELD else f"least factor by {method}"


_BLOCK = 1 << 11  # sections at a time: their slices stay in the caches
_Layers = Sequence[tuple[Soil, Any]]  # each with its top


@dataclass(frozen=True)
class Slope:
    """Slope in plane strain, of one soil or of layers.

    Parameters
    ----------
    ground : array_like
        Points of the surface from left to right, (V, 2), x and y in m; equal x is a vertical scarp.
    cohesion : float, mapping or callable
        c', Pa, or a law of slip as for a `Soil`, whose value at the start is used in factors of safety.
    friction : float, mapping or callable
        Friction coefficient, tan(phi'), or a law as for a `Scene`, whose value at the start is used, too.
    unit_weight : float
        gamma, N/m^3.
    level : array_like, optional
        Points of the water level from left to right, (W, 2), m, over the whole mass; it continues horizontally beyond
        them. Where it lies above the ground there is free water, and it must be horizontal.
    water_unit_weight : float
        N/m^3.
    pore_ratio : float
        r_u, pore pressure over gamma h, h the height of the ground above the arc; not with a level.
    pressure : float
        Uniform pore pressure along the arc, Pa, in addition to the pressure from level or ratio.
    k_h : float
        Horizontal acceleration over g, positive down-slope.
    base : float, optional
        y of a firm layer, m: no circle goes below.
    layers : sequence of pairs, optional
        Soils from the ground down, each with its top, as for a `LayeredSection`, in place of the numbers of one soil.
    surcharge : sequence of (x1, x2, q1, q2)
        Pressures on the ground, Pa, linear from x1 to x2.
    confined : bool
        Whether the water is confined, so that a level above the ground means artesian pressure without free water.
    ponds : sequence of (x1, x2, level)
        Free water between two shores whose pore pressure is given otherwise, m.
    crack, crack_water : float
        Depth of a tension crack at the upper end of an arc, and height of the water in it, m.
    k_h_on_surcharge : bool
        Whether k_h acts on the surcharges, at the ground.
    cohesion_gradient : float
        Growth of the cohesion per metre of depth, Pa/m.
    datum : float, optional
        y below which the cohesion grows, m, by default the ground.

    Raises
    ------
    ValueError
        Lists every mistake, one sentence each.
    """

    ground: ArrayLike
    cohesion: float | Parameters | Function = 0.0
    friction: float | Parameters | Function = 0.0
    unit_weight: float | None = None
    level: ArrayLike | None = None
    water_unit_weight: float = 9810.0
    pore_ratio: float = 0.0
    pressure: float = 0.0
    k_h: float = 0.0
    base: float | None = None
    layers: Sequence[tuple[Soil, Any]] = ()
    surcharge: Sequence[tuple[float, float, float, float]] = ()
    confined: bool = False
    ponds: Sequence[tuple[float, float, float]] = ()
    crack: float = 0.0
    crack_water: float = 0.0
    k_h_on_surcharge: bool = False
    cohesion_gradient: float = 0.0
    datum: float | None = None

    def __post_init__(self) -> None:
        """Check the fields, convert their units and freeze them."""
        take_units(self, vars(self))
        mistakes = self._field_mistakes()
        if not mistakes:
            freeze(self, ("cohesion", "friction"))
            object.__setattr__(self, "ground", np.array(self.ground, float))
            if self.level is not None:
                object.__setattr__(self, "level", np.array(self.level, float))
            mistakes = self._joint_mistakes()
        raise_all("Slope", mistakes)

    def _field_mistakes(self) -> Texts:
        """Return a message for each field that is missing, out of range, or excluded by another field."""
        fields = {name: value for name, value in vars(self).items() if name not in _LAYERED}
        mistakes = []
        if self.layers:
            fields = {name: value for name, value in fields.items() if name not in _OF_ONE_SOIL}
            excluded = [name for name in _OF_ONE_SOIL if getattr(self, name) not in (0.0, None)]
            mistakes += [f"{name}: is given by the soils of the layers; leave it out" for name in excluded]
            mistakes += layer_mistakes(self.layers, self.surcharge)
        else:
            mistakes += ["unit_weight is missing"] if self.unit_weight is None else []
            of_laws = law_mistakes(self.friction) if is_law(self.friction) else []
            of_laws += law_mistakes(self.cohesion, "cohesion", COHESION_LAWS) if is_law(self.cohesion) else []
            mistakes += of_laws
            fields |= {"cohesion": 0.0, "friction": 0.0} if of_laws else self._strength
        numbers = {name: p for name, p in present(self, SLOPE_NUMBERS).items() if name in fields}
        mistakes += slope_errors(fields, numbers)
        if self.level is not None and self.pore_ratio != 0.0:
            mistakes.append(
                f"{{pore_ratio}} = {self.pore_ratio!r}: {{level}} gives the pore pressure, too; remove one of them"
            )
        return mistakes

    @property
    def _strength(self) -> ValueDict:
        """Return the cohesion in Pa and the friction coefficient of a slope of one soil at the start, by name."""
        return {"cohesion": cohesion_at_rest(self.cohesion), "friction": friction_at_rest(self.friction)}

    def _joint_mistakes(self) -> Texts:
        """Return a message for each mistake of fields that are individually valid."""
        mistakes = complaint(water_faults(*self._water), ())
        if not self.layers and not any((*self._strength.values(), self.cohesion_gradient)):
            mistakes.append("cohesion and friction are both 0: the slope has no strength")
        if self.crack_water > self.crack:
            mistakes.append(f"{{crack_water}} = {self.crack_water!r}: must be at most the depth of the crack")
        if self.base is not None and self.base >= float(np.asarray(self.ground)[:, 1].max()):
            mistakes.append(f"{{base}} = {self.base:.10g}: must lie below the highest point of the ground")
        return mistakes

    @property
    def size(self) -> float:
        """Greater of the width and the height of the ground, m."""
        return float(np.ptp(np.asarray(self.ground), axis=0).max())

    @property
    def _water(self) -> tuple[Floats, Floats | None, bool, Sequence[Any]]:
        """Ground, level, confinement and ponds, with lines of one lane."""
        level = None if self.level is None else np.asarray(self.level)[None]
        return np.asarray(self.ground)[None], level, self.confined, self.ponds

    @property
    def free_water(self) -> Ponds:
        """Free water above the ground."""
        return free_water(*self._water)

    def arrays(self) -> SlopeArrays:
        """Slope in the form that `circle_factors` requires."""
        numbers = {name: getattr(self, name) for name in ("water_unit_weight", "pressure", "k_h", *_LAYERED[2:])}
        return _slope_arrays(_of_scenes((), 0), self, self.soils, self.surcharge, numbers)

    @property
    def soils(self) -> Sequence[tuple[Soil, Any]]:
        """Soils from the ground down, each with its top. A single soil has its strength at the start."""
        return self.layers or one_layer(vars(self) | self._strength)

    @property
    def has_friction(self) -> bool:
        """Whether a soil has friction at the start."""
        return any(np.any(soil.peak) for soil, _ in self.soils)


_LAYERED = ("layers", "surcharge", "crack", "crack_water", "k_h_on_surcharge")
_OF_ONE_SOIL = ("cohesion", "friction", "unit_weight", "pore_ratio", "cohesion_gradient", "datum")


def require_drive(section: Section) -> None:
    """Raise a ValueError if gravity does not turn the mass of a single section, as on level ground."""
    moment = float(section.moments["weight_moment"])
    area = float(section.area / np.square(section.radius))
    if abs(moment) <= 1e-9 * area:
        left, right = sorted((float(section.entry[0]), float(section.exit[0])))
        where = f"{{centre}}: nothing drives the mass from x = {left:.6g} to {right:.6g}"
        why = "it is in equilibrium about the centre, as below level ground; choose a circle that cuts the slope"
        raise InputError("Section", [f"{where}: {why}"])


def factors_of_safety(scene: Any) -> ArrayDict:
    """Return factors of safety of a section at the start of its motion, for a scene or each scene of an ensemble.

    Parameters
    ----------
    scene : Scene
        Of a `Section` with a `soil`; of its effects cohesion and pore pressure count, of its friction law the value at
        rest.

    Returns
    -------
    dict of ndarray
        In the shape of the scene, by ``METHODS``: NaN where a method refuses the circle; infinite where nothing drives
        the mass. ``facing`` and ``negative`` as in `circle_factors`.
    """
    if 0 in scene.shape:
        return {name: np.empty(scene.shape) for name in (*METHODS, "facing", "negative")}
    blocks = [circle_factors(slope, circles_of_lanes(circles, lanes)) for slope, circles, lanes in circles_of(scene)]
    values = {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
    undriven = (values["facing"] == 0.0) & np.isfinite(values["negative"])
    values |= {method: np.where(undriven, np.inf, values[method]) for method in METHODS}
    return {name: array.reshape(scene.shape) for name, array in values.items()}


def circles_of(scene: Any, slipped: bool = False, most: int = _BLOCK) -> Iterator[tuple[SlopeArrays, Circles, int]]:
    """Yield slopes, arcs and number of lanes of a scene in blocks of at most ``most`` lanes; shared values occur once.

    Strength is that before any slip, or after much.
    """
    section = scene.arc
    strength = soil(scene.friction, scene.effects, slipped)
    scenes = np.arange(math.prod(scene.shape))
    for block in np.array_split(scenes, -(-len(scenes) // most)):
        by_lane = _of_scenes(scene.shape, block)
        left, right = _ends(section, by_lane)
        slope = _slope_of_section(section, strength, by_lane, slipped)
        yield slope, (by_lane(section.centre, 1), by_lane(section.radius), left, right), len(block)


def circles_of_lanes(circles: Circles, lanes: int) -> Circles:
    """Return centres, radii and ends of arcs for each of ``lanes`` lanes, which may share one arc."""
    centre, radius, left, right = (np.broadcast_to(x, (lanes, *x.shape[1:])) for x in circles)
    return centre, radius, left, right


_ByLane = Callable[..., Floats]  # of a value, whose last axes (0 by default) are its own: with one axis of lanes


def _of_scenes(shape: Shape, numbers: Any) -> _ByLane:
    """Return a function that selects values of the scenes with flat indices ``numbers`` of an ensemble with a shape."""
    lanes = shape or (1,)
    some = np.unravel_index(numbers, lanes)

    def by_lane(value: Any, axes: int = 0) -> Floats:
        array = np.asarray(value, float)
        if array.ndim == axes:
            return array[None]
        return np.broadcast_to(array, (*lanes, *array.shape[array.ndim - axes :]))[some]

    return by_lane


def _slope_of_section(section: Section, strength: Values, by_lane: _ByLane, slipped: bool) -> SlopeArrays:
    """Return the slopes of sections, with strengths from `soil`, for the scenes that ``by_lane`` selects."""
    numbers: ValueDict = {"water_unit_weight": section.water_unit_weight}
    if isinstance(section, LayeredSection):
        return _slope_arrays(by_lane, section, section.layers, section.surcharge, numbers, slipped)
    layers = one_layer({"unit_weight": section.unit_weight, **strength})
    numbers |= {"pressure": by_lane(strength["pressure"])}
    return _slope_arrays(by_lane, section, layers, (), numbers)


def _slope_arrays(
    by_lane: _ByLane,
    slope: Slope | Section,
    layers: _Layers,
    surcharge: Sequence[Any],
    numbers: Values,
    slipped: bool = False,
) -> SlopeArrays:
    """Return slopes as arrays: lines and soils of ``layers`` by ``by_lane``, surcharges, and ``numbers`` by field."""
    lines = by_lane(slope.ground, 2)
    level = None if slope.level is None else by_lane(slope.level, 2)
    water = free_water(lines, level, slope.confined, slope.ponds)
    tops = [lines, *(_top_line(top, lines, by_lane) for _, top in layers[1:])]
    return SlopeArrays(
        ground=lines,
        soils=_soil_arrays(layers, by_lane, slipped),
        tops=tuple(tops[1:]),
        datums={
            k: top if soil.datum is None else _top_line(soil.datum, lines, by_lane)
            for k, (top, (soil, _)) in enumerate(zip(tops, layers, strict=True))
            if np.any(soil.cohesion_gradient)
        },
        level=level,
        ponds=water if len(water.first) else None,
        surcharge=tuple((x1, x2, by_lane(q1), by_lane(q2)) for x1, x2, q1, q2 in surcharge),
        **numbers,
    )


def _ends(section: Section, by_lane: _ByLane) -> ArrayPair:
    """Return left and right ends of arcs, x and y in m, (1 or lanes, 2) each; ``by_lane`` selects the scenes."""
    rightward = by_lane(section.facing)[:, None] > 0.0
    entry = by_lane(section.entry, 1)
    exit_ = by_lane(section.exit, 1)
    return np.where(rightward, entry, exit_), np.where(rightward, exit_, entry)


def one_layer(numbers: Values) -> _Layers:
    """Return homogeneous ground as its only layer, from its properties by name in SI units."""
    return [(Soil(**{name: numbers[name] for name in _OF_ONE_SOIL if name in numbers}, name="soil"), None)]


def _soil_arrays(layers: _Layers, by_lane: _ByLane, slipped: bool) -> SoilArrays:
    """Return the soils of layers as arrays, at the start or, if ``slipped``, after a large slip of the motion."""
    rows = []
    for soil, _ in layers:
        of_layer = SoilArrays(
            cohesion=by_lane(cohesion_at_rest(soil.cohesion, slipped)),
            friction=by_lane(friction_at_rest(soil.friction, slipped)),
            unit_weight=by_lane(soil.unit_weight),
            pore_ratio=by_lane(soil.pore_ratio),
            saturated_unit_weight=by_lane(soil.weight_below_water),
            cohesion_gradient=by_lane(growth_at_rest(soil.cohesion, soil.cohesion_gradient, slipped)),
        )
        rows.append(of_layer)
    return SoilArrays(*(np.stack(np.broadcast_arrays(*of_layers)) for of_layers in zip(*rows, strict=True)))


def _top_line(top: Any, ground: Floats, by_lane: _ByLane) -> Floats:
    """Return the top of a layer as a line, (1 or n, V, 2), for a height from one end of the ground to the other."""
    if np.ndim(top) > 1:
        return by_lane(top, 2)
    return level_line(by_lane(top), ground)


def soil(friction: Any, effects: Any, slipped: bool = False) -> ValueDict:
    """Return strength and pore pressure of a slope by name, from a scene's friction and effects at the start.

    Strength is that before any slip, or after much. Values are numbers, or arrays where the scene has arrays. The
    result is empty where nothing is known of a pressure that a record holds, or where there is no strength.
    """

    def at_start(value: Any) -> Any:
        if callable(value):
            return value(0.0)
        return value[0] if "time" in water and np.ndim(value) == 1 else value

    cohesion = effects.get("cohesion", {})
    water = effects.get("pore_pressure", {})
    of_friction = friction_at_rest(friction, slipped)
    strength = {"friction": of_friction, "cohesion": cohesion_at_rest(cohesion, slipped)}
    if "gradient" in cohesion:
        strength["cohesion_gradient"] = growth_at_rest(cohesion, cohesion["gradient"], slipped)
    if "record" in water or not any(np.any(value) for value in strength.values()):
        return {}
    pore_ratio = at_start(water.get("ratio", 0.0))
    pressure = at_start(water.get("pressure", 0.0))
    return strength | {"datum": cohesion.get("datum"), "pore_ratio": pore_ratio, "pressure": pressure}
