"""Layered ground: soils, the mass that they make up, and the strength along the arc that they give it.

*Weights* add exactly, surface by surface (`slipcircle.core.scene.strips`). *Resistance* with several frictions needs a
closure, as the balance (2.1) knows the mean normal stress alone: each stretch of the arc carries the weights of (2.23)
of the material straight above it. Their sums over the arc are J_r, its slope and I_p exactly, so that with one
friction this is the paper's method. *After a rotation* phi the stresses have turned with the mass; strength stays with
the *base* below the arc, or goes with the *mass*:

    friction(phi, omega) = sum_i mu_i [cos(phi) A_i - sin(phi) B_i + omega*^2 P_i] - integral of mu u,

where A_i, B_i and P_i are the parts of J_r, of its slope and of I_p on the stretches of soil i. What this is more than
with the mean friction coefficient on the whole arc is handed to the balance of a homogeneous mass.

Directions b along the arc are from straight below the centre, positive down-slope. Stresses are over gamma R with
gamma the mean unit weight, lengths over R.
"""

from __future__ import annotations  # so that a signature says ArrayLike

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.base.checks import mistakes, raise_all
from slipcircle.core.scene.friction import law_mistakes
from slipcircle.core.scene.ground import FAR, line_mistakes
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.strips import Floats, Strips, cut_into_strips

# Rows of what `Strips.cumulative` gives.
AREA, POLAR, INERTIA, RADIAL_X, RADIAL_Y, MOMENT_X, MOMENT_Y, HEAD = range(8)
_MOMENTS = ("area", "polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")


@dataclass(frozen=True)
class Soil:
    """A soil of a layered ground.

    Parameters
    ----------
    unit_weight : float or array_like
        gamma, N/m^3.
    cohesion : float or array_like
        c, Pa; at and above the datum where there is a gradient.
    friction : float, array_like or mapping
        Friction coefficient tan(phi); or a law of slip, ``{"law": "exponential", "peak": 0.4, "residual": 0.2,
        "length": 0.5}``, of which all soils along an arc share the law and its length.
    saturated_unit_weight : float or array_like, optional
        Below the water level, N/m^3.
    cohesion_gradient : float or array_like
        What c grows by for each metre below the datum, Pa/m.
    datum : float, optional
        y below which c grows, m.
    pore_ratio : float or array_like
        r_u: pore pressure over the vertical stress of the layers above, at the start; in the place of a water level.
    name : str
    """

    unit_weight: ArrayLike
    cohesion: ArrayLike = 0.0
    friction: Any = 0.0
    saturated_unit_weight: ArrayLike | None = None
    cohesion_gradient: ArrayLike = 0.0
    datum: float | None = None
    pore_ratio: ArrayLike = 0.0
    name: str = ""

    def __post_init__(self) -> None:
        raise_all(f"Soil {self.name}".rstrip(), soil_mistakes(self))

    @property
    def peak(self) -> Any:
        """Friction coefficient at the start."""
        return self.friction["peak"] if isinstance(self.friction, Mapping) else self.friction

    @property
    def residual(self) -> Any:
        """Friction coefficient after much slip."""
        return self.friction["residual"] if isinstance(self.friction, Mapping) else self.friction


class MeanFriction(dict[str, Any]):
    """The law of friction of an arc as a whole that the soils along it make up."""


class OfRotation(NamedTuple):
    """A function of the rotation, the sum of coefficients (parts, lanes) times parts of the geometry alone.

    ``parts`` takes rotations (M, circles), down-slope, and returns (parts, M, circles).
    """

    parts: Callable[[Floats], Floats]
    coefficients: Floats

    def __call__(self, rotation: Floats) -> Floats:
        """Its values after rotations (M, circles), (M, lanes)."""
        return np.asarray((self.parts(rotation) * self.coefficients[:, None]).sum(axis=0))


def soil_mistakes(soil: Soil) -> list[str]:
    """A sentence for each number of a soil that no soil has."""
    positive, stress = (0.0, 1e6, "a positive unit weight in N/m^3"), (-5e-324, 1e12, "a stress of at least 0 in Pa")
    bounds = {
        "unit_weight": positive,
        "saturated_unit_weight": positive,
        "cohesion": stress,
        "cohesion_gradient": (-5e-324, 1e12, "a growth of at least 0 in Pa/m"),
        "pore_ratio": (-5e-324, 1.0, "at least 0 and below 1"),
    }
    numbers = {name: getattr(soil, name) for name in bounds if getattr(soil, name) is not None}
    found = mistakes(numbers, {name: bounds[name] for name in numbers}) + law_mistakes(soil.friction)
    if isinstance(soil.friction, Mapping) and not {"peak", "residual", "length"} <= {*soil.friction}:
        found.append("friction.law: must have a peak, a residual and a length, to be shared along an arc")
    if soil.datum is None and not found and np.any(np.asarray(soil.cohesion_gradient)):
        found.append("datum: is missing: y below which the cohesion grows, in m")
    return found


def layer_mistakes(
    layers: Sequence[tuple[Soil, Any]], surcharge: Sequence[Any], strength: str = "base", foreland: Soil | None = None
) -> list[str]:
    """A sentence for each mistake in the layers of a section, its foreland and its surcharges."""
    pairs = list(layers)
    if not pairs or not all(isinstance(p, tuple | list) and len(p) == 2 and isinstance(p[0], Soil) for p in pairs):
        return ["layers: must be pairs of a Soil and its top, from the ground down; the top of the first is None"]
    found = []
    if pairs[0][1] is not None:
        found.append(f"layers[0]: top = {pairs[0][1]!r}: must be None, as its top is the ground")
    for k, (_, top) in enumerate(pairs[1:], 1):
        if top is None:
            found.append(f"layers[{k}]: top is missing: a height in m, or points from left to right")
        elif np.ndim(top) > 1:
            found += line_mistakes(f"layers[{k}]: top", top, True)
        else:
            found += mistakes({"top": top}, {"top": (-FAR, FAR, "a height in m, or points from left to right")})
    if strength not in ("base", "mass"):
        found.append(f"strength = {strength!r}: must be 'base' or 'mass'")
    if foreland is not None and not isinstance(foreland, Soil):
        found.append(f"foreland = {foreland!r}: must be a Soil")
    elif foreland is not None and strength == "mass":
        found.append("foreland: cannot be combined with strength = 'mass', by which the sole of the mass keeps its own")
    soils = {id(s): s for s in (*(soil for soil, _ in pairs), foreland) if isinstance(s, Soil)}.values()
    names = [s.name for s in soils]
    found += [
        f"layers: {name!r} is the name of two soils; give each its own" for name in {*names} if names.count(name) > 1
    ]
    laws = {
        tuple(v for n, v in s.friction.items() if n not in ("peak", "residual"))
        for s in soils
        if isinstance(s.friction, Mapping) and all(np.ndim(v) == 0 for v in s.friction.values())
    }
    if len(laws) > 1:
        found.append("layers: the soils along an arc share one law of slip and one length")
    for k, load in enumerate(surcharge):
        if np.shape(load) != (4,) or not np.all(np.isfinite(load)) or not load[0] < load[1] or min(load[2:]) < 0.0:
            found.append(f"surcharge[{k}] = {load!r}: must be x1 < x2 in m and pressures there of at least 0 in Pa")
    return found


class Stretches(NamedTuple):
    """Where the soil at the base changes along the arc: (circles, J) directions, and the soils above and below.

    A quantity q of the soils, summed over the stretches with a cumulative integral C from the entry, is
    q_last C(exit) + sum_j (q_before - q_after)_j C(b_j): `differences` are its coefficients.
    """

    joint: Floats
    before: NDArray[np.intp]
    after: NDArray[np.intp]
    first: NDArray[np.intp]
    last: NDArray[np.intp]

    def differences(self, quantity: Floats) -> Floats:
        """(q_before - q_after) at the joints and q_last, of (soils, lanes); (J + 1, lanes)."""
        lane = np.arange(quantity.shape[1])
        circle = lane if len(self.joint) > 1 else np.zeros_like(lane)
        steps = quantity[self.before[circle].T, lane] - quantity[self.after[circle].T, lane]
        return np.concatenate([steps, quantity[self.last[circle], lane][None]])


@dataclass(frozen=True, eq=False)
class LayeredSection(Section):
    """A slip circle through layered ground, with the mass between ground and arc.

    Parameters
    ----------
    layers : sequence of pairs
        From the ground down, each a `Soil` and its top: None of the first, whose top is the ground; else a height in m
        or points from left to right, (V, 2), which go on horizontally. What rises above the boundary before it is cut
        off there.
    strength : str
        "base": the strength of the soils below the arc stays where it is as the mass moves over them, and that at the
        exit goes on beyond it; "mass": a sheared sole travels along.
    foreland : Soil, optional
        Below the arc beyond the exit, in the place of the soil at the exit; its cohesion follows its own rule with
        depth.
    surcharge : sequence of (x1, x2, q1, q2)
        Pressures on the ground that lie on the mass and move with it, Pa, linear from x1 to x2, m.

    Notes
    -----
    The other parameters are those of `Section`; ``unit_weight`` is that of the soils and not given here.
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

    # --- soils -------------------------------------------------------------------------------------------------------

    @cached_property
    def soils(self) -> tuple[Soil, ...]:
        """The soils of the layers, and that of the foreland."""
        return (*(soil for soil, _ in self.layers), *([self.foreland] if self.foreland else []))

    @cached_property
    def lanes_shape(self) -> tuple[int, ...]:
        """The broadcast shape of the geometry and of all numbers of soils."""
        numbers = [getattr(s, n) for s in self.soils for n in _NUMBERS]
        return np.broadcast_shapes(self.shape, *(np.shape(x) for x in numbers if x is not None))

    def of_soils(self, value: Callable[[Soil], Any]) -> Floats:
        """A number of each soil, (soils, lanes)."""
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
    def mean_unit_weight(self) -> Any:
        """The weight of the mass over its area, N/m^3."""
        return self._shaped(self._weighted[AREA] / self._moments["area"])

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
        """The weight of the mass over its area, N/m^3."""
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

    # --- strength along the arc --------------------------------------------------------------------------------------

    @cached_property
    def _stretches(self) -> Stretches:
        """Where the soil at the base changes, from the entry to the exit; a foreland's comes in at the exit."""
        strips, down = self._strips, self._facing[:, None] > 0.0
        base = np.where(down, strips.base, strips.base[:, ::-1])
        edges = np.where(down, strips.beta, -strips.beta[:, ::-1])
        before, after, joint = base[:, :-1], base[:, 1:], edges[:, 1:-1]
        last = base[:, -1]
        if self.foreland is not None:
            last = np.full_like(last, len(self.layers))
            before = np.concatenate([before, base[:, -1:]], axis=1)
            after = np.concatenate([after, last[:, None]], axis=1)
            joint = np.concatenate([joint, edges[:, -1:]], axis=1)
        changes = np.any(before != after, axis=0)
        return Stretches(joint[:, changes], before[:, changes], after[:, changes], base[:, 0], last)

    @cached_property
    def _span(self) -> tuple[Floats, Floats]:
        """Directions of the entry and of the exit, (circles,)."""
        left, right = self._angles
        down = self._facing > 0.0
        return np.where(down, left, -right), np.where(down, right, -left)

    def _from_entry(self, b: Floats) -> Floats:
        """Integrals of a unit weight below each surface from the entry to directions b, (circles, M).

        (8, surfaces, circles, M); of x down-slope.
        """
        facing = self._facing[:, None]
        at = self._strips.up_to(facing * b, self._cumulative)
        whole = self._cumulative[..., -1:]
        at = np.where(facing > 0.0, at, whole - at)
        at[[RADIAL_X, MOMENT_X]] *= facing
        return at

    # --- functions of the rotation -----------------------------------------------------------------------------------

    def _joints_met(self, rotation: Floats) -> Floats:
        """Where the mass meets the joints, and its exit, after rotations (M, circles), (J + 1, M, circles).

        In directions of the mass at the start. Joints of the base stay behind as the mass moves on.
        """
        first, last = self._span
        moved = rotation if self.strength == "base" else np.zeros_like(rotation)
        joints = [np.clip(j - moved, first, last) for j in self._stretches.joint.T]
        return np.stack([*joints, np.broadcast_to(last, rotation.shape)])

    def _parts(self, rotation: Floats) -> Floats:
        """Integrals of unit weights below the surfaces, up to where joints are met, (8, J + 1, surfaces, M, circles)."""
        met = self._joints_met(rotation)
        joints, times, circle = met.shape
        flat = self._from_entry(np.moveaxis(met, 2, 0).reshape(circle, -1))
        split = flat.reshape(*flat.shape[:3], joints, times)  # integrals, surfaces, circles, joints, times
        return split.transpose(0, 3, 1, 4, 2)

    def _normal(self, rotation: Floats) -> Floats:
        """Normal force of the weights up to the joints, ((J + 1) surfaces, M, circles)."""
        parts = self._parts(rotation)
        turned = -parts[RADIAL_Y] * np.cos(rotation) - parts[RADIAL_X] * np.sin(rotation)
        return turned.reshape(-1, *rotation.shape)

    def _inertia(self, rotation: Floats) -> Floats:
        """What omega*^2 adds to it, likewise."""
        return self._parts(rotation)[POLAR].reshape(-1, *rotation.shape)

    def _overburden(self, rotation: Floats) -> Floats:
        """Integral of the vertical stress at the start, likewise."""
        return self._parts(rotation)[HEAD].reshape(-1, *rotation.shape)

    def _space(self, rotation: Floats) -> Floats:
        """Directions in space of the joints, the exit and the entry after rotations, (J + 2, M, circles)."""
        first, last = self._span
        start, end = first + rotation, last + rotation
        joints = self._stretches.joint.T
        if self.strength == "base":
            there = [np.clip(j, start, end) for j in joints]
        else:
            there = [j + rotation for j in joints]
        return np.stack([*there, end, start])

    def _heads(self, rotation: Floats) -> Floats:
        """Integrals of the head of the water level from the entry to these directions, (J + 2, M, circles)."""
        there = self._facing * self._space(rotation)
        entry = np.broadcast_to(there[-1], there.shape)
        return self._water.integral(np.minimum(entry, there), np.maximum(entry, there))

    def _lengths(self, rotation: Floats) -> Floats:
        """Lengths of arc up to these directions, likewise."""
        return self._space(rotation)

    def _growth(self, b: Floats) -> Floats:
        """Integral over the arc, from its entry to directions b, of the depth below each soil's datum, over R.

        (soils, ..., circles); 0 above the datum and of soils without one.
        """
        _, centre, radius = self._circle
        first, _ = self._span
        rows = []
        for soil in self.soils:
            if soil.datum is None:
                rows.append(np.zeros(b.shape))
                continue
            level = (soil.datum - centre[:, 1]) / radius  # of the datum above the centre
            reach = np.arccos(np.clip(-level, -1.0, 1.0))  # the datum crosses the arc at -reach and reach
            start, end = np.clip(first, -reach, reach), np.clip(b, -reach, reach)
            rows.append(level * (end - start) + np.sin(end) - np.sin(start))
        return np.stack(rows)

    def _cohesion_growth(self, rotation: Floats) -> Floats:
        """Parts of the resistance that grow with depth, of each soil one, (soils, M, circles), over R.

        At the exit and the entry the value there goes on, not its growth; below a foreland its own rule does.
        """
        first, last = self._span
        found = np.zeros((len(self.soils), *rotation.shape))
        _, centre, radius = self._circle
        there = self._space(rotation)
        own = self.strength == "base"
        positions = there if own else there - rotation
        inside = np.clip(positions, first, np.inf if own and self.foreland is not None else last)
        growth = self._growth(inside)
        stretches = self._stretches
        circle = np.arange(rotation.shape[1])
        for k in range(stretches.joint.shape[1]):
            found[stretches.before[:, k], :, circle] += growth[stretches.before[:, k], k, :, circle]
            found[stretches.after[:, k], :, circle] -= growth[stretches.after[:, k], k, :, circle]
        end, start = len(there) - 2, len(there) - 1
        found[stretches.last, :, circle] += growth[stretches.last, end, :, circle]
        found[stretches.first, :, circle] -= growth[stretches.first, start, :, circle]
        if own:
            for soil, at, beyond in (
                (stretches.last, last, 0.0 if self.foreland else np.maximum(there[end] - last, 0.0)),
                (stretches.first, first, np.maximum(first - there[start], 0.0)),
            ):
                for k, s in enumerate(self.soils):
                    if s.datum is not None:
                        depth = np.maximum((s.datum - centre[:, 1]) / radius + np.cos(at), 0.0)
                        found[k] += np.where(soil == k, depth * beyond, 0.0)
        return found

    @cached_property
    def rotation_kinks(self) -> Floats:
        """Rotations at which one of these functions is not smooth, (kinks, circles), sorted."""
        first, last = self._span
        down = self._facing[:, None]
        edges = np.where(down > 0.0, self._strips.beta, -self._strips.beta[:, ::-1])
        base = [self._stretches.joint, first[:, None], last[:, None]]
        if self.level is not None:
            base += [self._water.low * down, self._water.high * down]
        _, centre, radius = self._circle
        for s in self.soils:
            if s.datum is not None:
                reach = np.arccos(np.clip((centre[:, 1] - s.datum) / radius, -1.0, 1.0))[:, None]
                base += [reach, -reach]
        there = np.concatenate(base, axis=1)
        every = there[:, :, None] - edges[:, None, :]
        return np.sort(every.reshape(len(every), -1), axis=1).T

    # --- what the balance takes --------------------------------------------------------------------------------------

    @cached_property
    def _weight_steps(self) -> Floats:
        """Steps of the unit weight over its mean, (surfaces, lanes)."""
        return self._surfaces[1] / (self._weighted[AREA] / self._moments["area"])

    def _by_surface(self, quantity: Floats) -> Floats:
        """Coefficients of integrals up to joints of a quantity of the soils, ((J + 1) surfaces, lanes)."""
        differences = self._stretches.differences(quantity)
        product = differences[:, None] * self._weight_steps
        return product.reshape(-1, product.shape[-1])

    def _by_direction(self, quantity: Floats) -> Floats:
        """The same up to directions in space, joints, exit and entry, (J + 2, lanes)."""
        differences = self._stretches.differences(quantity)
        lane = np.arange(quantity.shape[1])
        first = self._stretches.first[lane if len(self._stretches.first) > 1 else np.zeros_like(lane)]
        return np.concatenate([differences, -quantity[first, lane][None]])

    def _mean(self, quantity: Floats) -> Floats:
        """Mean of a friction coefficient over the arc, by the normal forces at the start, (lanes,)."""
        still = np.zeros((1, len(self._facing)))
        normal = (self._by_surface(quantity) * self._normal(still)[:, 0]).sum(axis=0)
        return np.asarray(normal / -self._per_mean_weight[RADIAL_Y])

    @cached_property
    def mean_peak(self) -> Floats:
        """Friction coefficient of the whole arc at the start, (lanes,)."""
        return self._mean(self.of_soils(lambda s: s.peak))

    @cached_property
    def mean_residual(self) -> Floats:
        """Friction coefficient of the whole arc after much slip, by the normal forces at the start, (lanes,)."""
        return self._mean(self.of_soils(lambda s: s.residual))

    @cached_property
    def _friction_excess(self) -> tuple[Floats, Floats]:
        """By soil, over their means and less 1: the part of friction that slip takes away, and what remains.

        The same where friction is constant.
        """
        peak, residual = self.of_soils(lambda s: s.peak), self.of_soils(lambda s: s.residual)
        lost, mean_lost = peak - residual, self.mean_peak - self.mean_residual
        with np.errstate(divide="ignore", invalid="ignore"):
            remaining = np.where(self.mean_residual > 0.0, residual / self.mean_residual - 1.0, 0.0)
            changing = np.where(mean_lost != 0.0, lost / mean_lost - 1.0, remaining)
        return changing, remaining

    @cached_property
    def friction(self) -> MeanFriction:
        """The friction of the arc as a whole, as a `Scene` takes it: its mean, by the normal forces at the start."""
        laws = [s.friction for s in self.soils if isinstance(s.friction, Mapping)]
        peak, residual = self._shaped(self.mean_peak), self._shaped(self.mean_residual)
        if not laws:
            return MeanFriction(law="constant", coefficient=peak)
        return MeanFriction(laws[0], peak=peak, residual=residual)

    def section_effects(self, effects: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Mapping[str, Any]]:
        """With the strengths of the soils; what omega^2 does to them only where the centripetal stress counts."""
        terms = {
            name: term
            for name, term in self.strength_terms.items()
            if not name.endswith("inertia") or "centripetal" in effects
        }
        return {**effects, "layered_strength": terms}

    # --- numbers that vary -------------------------------------------------------------------------------------------

    def other_numbers(self) -> dict[str, Any]:
        """``soils.NAME.cohesion``, ``soils.NAME.friction.peak``, ...; ``layers.2.top``, of a line that of its first point."""
        numbers: dict[str, Any] = {}
        for soil in self.soils:
            for field in _VARYING:
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
        """The layers and the foreland with other values of these."""

        def changed(soil: Soil) -> Soil:
            mine = {n.split(".", 2)[2]: v for n, v in values.items() if n.startswith(f"soils.{soil.name}.")}
            law = {n.partition(".")[2]: mine.pop(n) for n in [*mine] if n.startswith("friction.")}
            return replace(soil, **mine, **({"friction": {**soil.friction, **law}} if law else {}))

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

    @cached_property
    def strength_terms(self) -> dict[str, Any]:
        """What the balance takes beyond a homogeneous mass with the mean friction, over Theta*: numbers and functions.

        With mu = r + (p - r) f(s) of each soil, friction is mu_mean (N + G) + r_mean (G_r - G): N of the weight, G
        and G_r what the parts p - r and r of the soils take hold of beyond their means.
        """
        theta = self._per_mean_weight[INERTIA]
        changing, remaining = self._friction_excess
        takes_hold = self._by_surface(changing) / theta
        terms = self._gripping("normal", "turning", "inertia", takes_hold)
        if np.any(remaining != changing):
            left = self._by_surface(remaining - changing) * self.mean_residual / theta
            terms |= self._gripping("remaining_normal", "remaining", "remaining_inertia", left)
        unit_weight = self._weighted[AREA] / self._moments["area"]
        cohesion = self.of_soils(lambda s: s.cohesion) / (unit_weight * self._circle[2] * theta)
        strength = [OfRotation(self._space, self._by_direction(cohesion))]
        growth = self.of_soils(lambda s: s.cohesion_gradient) / (unit_weight * theta)
        strength += [OfRotation(self._cohesion_growth, growth)] if np.any(growth) else []
        peak = self.of_soils(lambda s: s.peak) / np.where(self.mean_peak > 0.0, self.mean_peak, 1.0)
        ratio = self.of_soils(lambda s: s.pore_ratio)
        lift = []
        if self.level is not None:
            weight = np.where(ratio > 0.0, 0.0, peak) * self.water_unit_weight / (unit_weight * theta)
            lift.append(OfRotation(self._heads, self._by_direction(weight)))
        if np.any(ratio):
            lift.append(OfRotation(self._overburden, self._by_surface(peak * ratio) / theta))
        terms |= {name: _sum(parts) for name, parts in (("strength", strength), ("lift", lift)) if parts}
        return {n: v for n, v in terms.items() if not isinstance(v, OfRotation) or np.any(v.coefficients)}

    def _gripping(self, base: str, mass: str, inertia: str, coefficients: Floats) -> dict[str, Any]:
        """What friction takes hold of, with coefficients of the parts by surface: of weight and of inertia."""
        terms: dict[str, Any] = {inertia: OfRotation(self._inertia, coefficients)}
        if self.strength == "base":
            return terms | {base: OfRotation(self._normal, coefficients)}
        parts = self._parts(np.zeros((1, len(self._facing))))[..., 0, :]
        normal, slope = (parts[k].reshape(len(coefficients), -1) for k in (RADIAL_Y, RADIAL_X))
        terms[mass] = self._shaped((coefficients * -normal).sum(axis=0))
        terms[f"{mass}_slope"] = self._shaped((coefficients * slope).sum(axis=0))
        return terms


def _sum(functions: Sequence[OfRotation]) -> OfRotation:
    """The sum of functions of the rotation."""

    def parts(rotation: Floats) -> Floats:
        return np.concatenate([f.parts(rotation) for f in functions])

    return OfRotation(parts, np.concatenate([f.coefficients for f in functions]))


_VARYING = ("unit_weight", "cohesion", "saturated_unit_weight", "cohesion_gradient", "pore_ratio")
_NUMBERS = ("unit_weight", "cohesion", "peak", "residual", "saturated_unit_weight", "cohesion_gradient", "pore_ratio")
