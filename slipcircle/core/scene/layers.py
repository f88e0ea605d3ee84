"""Layered ground: the section of a real slope whose mass and whose arc several soils make up.

*Weights* add exactly, surface by surface (`slipcircle.core.scene.strips`). *Resistance* with several frictions needs a
closure, as the balance (2.1) knows the mean normal stress alone: each stretch of the arc carries the weights of (2.23)
of the material straight above it. Their sums over the arc are J_r, its slope and I_p exactly, so that with one
friction this is the paper's method; `slipcircle.core.scene.strength` has it.
"""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.checks import raise_all
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.soils import LANE_NUMBERS, SOIL_NUMBERS, Soil, layer_mistakes
from slipcircle.core.scene.strength import ArcStrength, MeanFriction
from slipcircle.core.scene.strips import (
    AREA,
    HEAD,
    INERTIA,
    MOMENT_X,
    MOMENT_Y,
    POLAR,
    RADIAL_X,
    RADIAL_Y,
    Floats,
    Strips,
    cut_into_strips,
)

_MOMENTS = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")


@dataclass(frozen=True, eq=False)
class LayeredSection(Section):
    """A slip circle through layered ground, with the mass between ground and arc.

    Parameters
    ----------
    layers : sequence of pairs
        From the ground down, each a `Soil` and its top: None for the first, whose top is the ground; otherwise a height
        in m or points from left to right, (V, 2), continued horizontally. A boundary is cut off where it rises above
        the one before.
    strength : str
        "base": the strength belongs to the soils below the arc, over which the mass moves, and that at the exit
        continues beyond it; "mass": the sheared sole moves with the mass.
    foreland : Soil, optional
        Soil along the arc beyond the exit, in place of the soil at the exit; its cohesion varies with depth by its own
        rule.
    surcharge : sequence of (x1, x2, q1, q2)
        Pressures on the ground that move with the mass, Pa, linear from x1 to x2, m.

    Notes
    -----
    The other parameters are those of `Section`, without ``unit_weight``, which the soils have.
    """

    unit_weight: ArrayLike = 1.0  # of the geometry alone
    layers: Sequence[tuple[Soil, Any]] = ()
    strength: str = "base"
    foreland: Soil | None = None
    surcharge: Sequence[tuple[float, float, float, float]] = ()
    quantities: ClassVar[Mapping[str, int]] = {n: k for n, k in Section.quantities.items() if n != "unit_weight"}

    def __post_init__(self) -> None:
        raise_all("LayeredSection", layer_mistakes(self.layers, self.surcharge, self.strength, self.foreland))
        super().__post_init__()
        first, last = self._angles
        overhangs = max(-float(np.min(first)), float(np.max(last))) > np.pi / 2
        steep = "radius, centre: the arc reaches above the centre's height, where no soil lies straight above it"
        raise_all("LayeredSection", [steep] if overhangs else [])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, LayeredSection) or len(self.layers) != len(other.layers):
            return False
        same_tops = all(np.array_equal(a, b) for (_, a), (_, b) in zip(self.layers, other.layers, strict=True))
        names = {f.name for f in fields(self)} - {"layers", "foreland"}
        same_fields = all(np.array_equal(getattr(self, name), getattr(other, name)) for name in names)
        return self.soils == other.soils and same_tops and same_fields

    # --- soils -------------------------------------------------------------------------------------------------------

    @cached_property
    def soils(self) -> tuple[Soil, ...]:
        """The soils of the layers, and that of the foreland."""
        return (*(soil for soil, _ in self.layers), *([self.foreland] if self.foreland else []))

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Of the geometry, with the tops of the layers."""
        tops = [np.shape(top)[:-2] if np.ndim(top) > 1 else np.shape(top) for _, top in self.layers[1:]]
        return np.broadcast_shapes(super().shape, *tops)

    @cached_property
    def lanes_shape(self) -> tuple[int, ...]:
        """The broadcast shape of the geometry and of all numbers of soils."""
        numbers = [getattr(s, n) for s in self.soils for n in LANE_NUMBERS]
        return np.broadcast_shapes(self.shape, *(np.shape(x) for x in numbers if x is not None))

    def of_soils(self, value: Callable[[Soil], Any]) -> Floats:
        """One number of each soil, (soils, lanes)."""
        rows = [np.broadcast_to(np.asarray(value(s), dtype=np.float64), self.lanes_shape) for s in self.soils]
        return np.stack(rows).reshape(len(rows), -1)

    def _shaped(self, values: Any) -> Any:
        """Values by lane in the shape of the results, of geometry or of all."""
        values = np.asarray(values)
        count = int(np.prod(self.shape))
        shape = self.shape if len(values) == count else self.lanes_shape
        return values.reshape((*shape, *values.shape[1:]))[()]

    # --- weights -----------------------------------------------------------------------------------------------------

    @cached_property
    def _lines_over_radius(self) -> list[Floats]:
        """Ground, tops of the layers and water level from the centre, over R, (circles or 1, V, 2)."""
        ground, centre, radius = self._circle
        ends = ground[:, [0, -1], 0]
        given = [ground]
        for _, top in self.layers[1:]:
            points = np.asarray(top, dtype=np.float64)
            if points.ndim < 2:  # a height, or one of each circle
                height = np.broadcast_to(points, self.shape if points.ndim else ())[..., None]
                points = np.stack(np.broadcast_arrays(ends[0] if not points.ndim else ends, height), axis=-1)
            given.append(self._lines(points))
        if self.level is not None:
            given.append(self._level)
        return [(line - centre[:, None]) / radius[:, None, None] for line in given]

    @cached_property
    def _surfaces(self) -> tuple[list[tuple[int, ...]], Floats]:
        """Surfaces as the numbers of their lines, and the step of the unit weight below each, (surfaces, lanes)."""
        count = len(self.layers)
        tops = [tuple(range(k + 1)) for k in range(count)]
        weight = self.of_soils(lambda s: s.unit_weight)[:count]
        steps = [np.diff(weight, axis=0, prepend=0.0)]
        if self.level is not None and any(s.saturated_unit_weight is not None for s in self.soils[:count]):
            wet = self.of_soils(lambda s: s.unit_weight if s.saturated_unit_weight is None else s.saturated_unit_weight)
            tops += [(*top, count) for top in tops]
            steps.append(np.diff(wet[:count] - weight, axis=0, prepend=0.0))
        steps += [np.ones_like(weight[:1])] * bool(self.surcharge)
        return tops, np.concatenate(steps)

    @cached_property
    def _strips(self) -> Strips:
        """The mass in strips."""
        (left, _), (right, _) = self._ends
        lines = self._lines_over_radius
        _, centre, radius = self._circle
        x, size = centre[:, :1], radius[:, None]
        loads = [((x1 - x) / size, (x2 - x) / size, q1 / size, q2 / size) for x1, x2, q1, q2 in self.surcharge]
        extra = np.concatenate([np.empty((len(x), 0)), *(end for load in loads for end in load[:2])], axis=1)
        datums = [s.datum for s in self.soils if s.datum is not None]
        if datums:
            depth = np.clip((centre[:, 1:] - np.array(datums)) / radius[:, None], -1.0, 1.0)
            across = np.sqrt((1.0 - depth) * (1.0 + depth))
            extra = np.concatenate([extra, across, -across], axis=1)
        return cut_into_strips(lines, self._surfaces[0], len(self.layers), (left, right), extra, loads)

    @cached_property
    def _cumulative(self) -> Floats:
        """Integrals of a unit weight below each surface from the left end, (8, surfaces, circles, edges).

        The surcharges, if there are any, come last, as they are."""
        return self._strips.cumulative()

    @cached_property
    def _weighted(self) -> Floats:
        """Moments of the whole mass, each the sum over its surfaces, N/m^3, (7, lanes).

        The ground's own are those of a homogeneous mass, so that one soil in many layers gives the numbers of one.
        """
        whole = self._cumulative[:HEAD, :, :, -1].copy()
        whole[:, 0] = np.stack([self._moments[name] for name in _MOMENTS])
        return np.asarray((whole * self._surfaces[1]).sum(axis=1))

    @cached_property
    def _per_mean_weight(self) -> Floats:
        """The same over the mean unit weight: numbers as a homogeneous mass has them."""
        return self._weighted / (self._weighted[AREA] / self._moments["area"])

    @cached_property
    def mean_unit_weight(self) -> Any:
        """Weight of the mass divided by its area, N/m^3."""
        return self._shaped(self._weighted[AREA] / self._moments["area"])

    @cached_property
    def centroid(self) -> Any:
        """Of the mass, x and y in m."""
        _, centre, radius = self._circle
        m = self._per_mean_weight
        return self._shaped(centre + m[[MOMENT_X, MOMENT_Y]].T * (radius / m[AREA])[:, None])

    @cached_property
    def moments(self) -> dict[str, Any]:
        """Theta*, I_p*, J_r, J_theta (3.12), (2.17), (2.23), (3.13), and the derivatives of the last two by the dip."""
        m, facing = self._per_mean_weight, self._facing
        found = {
            "moment_of_inertia": m[INERTIA],
            "polar_moment": m[POLAR],
            "radial_weight": -m[RADIAL_Y],
            "weight_moment": -facing * m[MOMENT_X],
            "radial_weight_slope": facing * m[RADIAL_X],
            "weight_moment_slope": -m[MOMENT_Y],
        }
        return {name: self._shaped(value) for name, value in found.items()}

    # --- strength ----------------------------------------------------------------------------------------------------

    @cached_property
    def arc_strength(self) -> ArcStrength:
        """Strength along the arc."""
        return ArcStrength(self)

    @property
    def friction(self) -> MeanFriction:
        """Friction of the arc as a whole, as a `Scene` takes it."""
        return self.arc_strength.friction

    def section_effects(self, effects: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Mapping[str, Any]]:
        """Adds the strengths of the soils; their dependence on omega^2 only where the centripetal stress is
        included."""
        terms = {
            name: term
            for name, term in self.arc_strength.terms.items()
            if not name.endswith("inertia") or "centripetal" in effects
        }
        return {**effects, "layered_strength": terms}

    # --- numbers that vary -------------------------------------------------------------------------------------------

    def other_numbers(self) -> dict[str, Any]:
        """``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ...; ``layers.2.top``, for a line that of its first
        point."""
        numbers: dict[str, Any] = {}
        for soil in self.soils:
            for field in SOIL_NUMBERS:
                if (value := getattr(soil, field)) is not None:
                    numbers[f"soils.{soil.name}.{field}"] = value
            if isinstance(soil.friction, Mapping):
                numbers |= {f"soils.{soil.name}.friction.{n}": v for n, v in soil.friction.items() if n != "law"}
            else:
                numbers[f"soils.{soil.name}.friction"] = soil.friction
        for k, (_, top) in enumerate(self.layers):
            if top is not None:
                numbers[f"layers.{k + 1}.top"] = np.asarray(top)[..., 0, 1][()] if np.ndim(top) > 1 else top
        return numbers

    def fields_with(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The layers and the foreland with these numbers replaced."""

        def changed(soil: Soil) -> Soil:
            mine: dict[str, Any] = {
                n.split(".", 2)[2]: v for n, v in values.items() if n.startswith(f"soils.{soil.name}.")
            }
            law = {n.partition(".")[2]: mine.pop(n) for n in [*mine] if n.startswith("friction.")}
            if law:
                mine["friction"] = {**soil.friction, **law}
            return replace(soil, **mine)

        soils = {id(soil): changed(soil) for soil in self.soils}
        layers = []
        for k, (soil, top) in enumerate(self.layers):
            value = values.get(f"layers.{k + 1}.top")
            if value is not None and np.ndim(top) > 1:  # the line moves as a whole
                line = np.asarray(top, dtype=np.float64)
                shift = np.asarray(value) - line[..., 0, 1]
                top = line + np.stack(np.broadcast_arrays(0.0, shift[..., None]), axis=-1)
            elif value is not None:
                top = value
            layers.append((soils[id(soil)], top))
        return {"layers": tuple(layers), "foreland": self.foreland and soils[id(self.foreland)]}
