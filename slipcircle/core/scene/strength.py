"""Strength along the arc of a layered section as functions of the rotation, for the balance of a homogeneous mass.

After a rotation phi the stresses have turned with the mass; strength stays with the *base* below the arc, or goes with
the *mass*. With A, B and P the parts of J_r, of its slope and of I_p on the stretches of each soil,

    friction(phi, omega) = sum mu [cos(phi) A - sin(phi) B + omega*^2 P] - integral of mu u.

What this is more than with the mean friction coefficient on the whole arc is handed to the balance. A quantity q of the
soils summed over the stretches, with a cumulative integral C from the entry, is

    q_last C(exit) + sum over the joints of stretches of (q_before - q_after) C(joint),

so that only C at the joints depends on the rotation, and only the differences on the numbers of the soils.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene.strips import AREA, HEAD, INERTIA, MOMENT_X, POLAR, RADIAL_X, RADIAL_Y, Floats


class OfRotation(NamedTuple):
    """A function of the rotation, the sum of coefficients (parts, lanes) times parts of the geometry alone.

    ``parts`` takes rotations (M, circles), down-slope, and returns (parts, M, circles).
    """

    parts: Callable[[Floats], Floats]
    coefficients: Floats

    def __call__(self, rotation: Floats) -> Floats:
        """Its values after rotations (M, circles), (M, lanes)."""
        return np.asarray((self.parts(rotation) * self.coefficients[:, None]).sum(axis=0))


class MeanFriction(dict[str, Any]):
    """The law of friction of an arc as a whole that the soils along it make up."""


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
class ArcStrength:
    """The strength along the arc of a `slipcircle.core.scene.layers.LayeredSection`."""

    section: Any

    @cached_property
    def stretches(self) -> Stretches:
        """Where the soil at the base changes, from the entry to the exit; a foreland's comes in at the exit."""
        strips, down = self.section._strips, self.section._facing[:, None] > 0.0
        base = np.where(down, strips.base, strips.base[:, ::-1])
        edges = np.where(down, strips.beta, -strips.beta[:, ::-1])
        before, after, joint = base[:, :-1], base[:, 1:], edges[:, 1:-1]
        last = base[:, -1]
        if self.section.foreland is not None:
            last = np.full_like(last, len(self.section.layers))
            before = np.concatenate([before, base[:, -1:]], axis=1)
            after = np.concatenate([after, last[:, None]], axis=1)
            joint = np.concatenate([joint, edges[:, -1:]], axis=1)
        changes = np.any(before != after, axis=0)
        return Stretches(joint[:, changes], before[:, changes], after[:, changes], base[:, 0], last)

    @cached_property
    def span(self) -> tuple[Floats, Floats]:
        """Directions of the entry and of the exit, (circles,)."""
        left, right = self.section._angles
        down = self.section._facing > 0.0
        return np.where(down, left, -right), np.where(down, right, -left)

    def _from_entry(self, b: Floats) -> Floats:
        """Integrals of a unit weight below each surface from the entry to directions b, (circles, M).

        (8, surfaces, circles, M); of x down-slope.
        """
        facing = self.section._facing[:, None]
        at = self.section._strips.up_to(facing * b, self.section._cumulative)
        whole = self.section._cumulative[..., -1:]
        at = np.where(facing > 0.0, at, whole - at)
        at[[RADIAL_X, MOMENT_X]] *= facing
        return at

    def _joints_met(self, rotation: Floats) -> Floats:
        """Where the mass meets the joints, and its exit, after rotations (M, circles), (J + 1, M, circles).

        In directions of the mass at the start. Joints of the base stay behind as the mass moves on.
        """
        first, last = self.span
        moved = rotation if self.section.strength == "base" else np.zeros_like(rotation)
        joints = [np.clip(j - moved, first, last) for j in self.stretches.joint.T]
        return np.stack([*joints, np.broadcast_to(last, rotation.shape)])

    def parts(self, rotation: Floats) -> Floats:
        """Integrals of unit weights below surfaces up to where joints are met, (8, J + 1, surfaces, M, circles)."""
        met = self._joints_met(rotation)
        joints, times, circle = met.shape
        flat = self._from_entry(np.moveaxis(met, 2, 0).reshape(circle, -1))
        split = flat.reshape(*flat.shape[:3], joints, times)  # integrals, surfaces, circles, joints, times
        return split.transpose(0, 3, 1, 4, 2)

    def _normal(self, rotation: Floats) -> Floats:
        """Normal force of the weights up to the joints, ((J + 1) surfaces, M, circles)."""
        parts = self.parts(rotation)
        turned = -parts[RADIAL_Y] * np.cos(rotation) - parts[RADIAL_X] * np.sin(rotation)
        return turned.reshape(-1, *rotation.shape)

    def _inertia(self, rotation: Floats) -> Floats:
        """What omega*^2 adds to it, likewise."""
        return self.parts(rotation)[POLAR].reshape(-1, *rotation.shape)

    def _overburden(self, rotation: Floats) -> Floats:
        """Integral of the vertical stress at the start, likewise."""
        return self.parts(rotation)[HEAD].reshape(-1, *rotation.shape)

    def _space(self, rotation: Floats) -> Floats:
        """Directions in space of the joints, the exit and the entry after rotations, (J + 2, M, circles)."""
        first, last = self.span
        start, end = first + rotation, last + rotation
        joints = self.stretches.joint.T
        if self.section.strength == "base":
            there = [np.clip(j, start, end) for j in joints]
        else:
            there = [j + rotation for j in joints]
        return np.stack([*there, end, start])

    def _heads(self, rotation: Floats) -> Floats:
        """Integrals of the head of the water level from the entry to these directions, (J + 2, M, circles)."""
        there = self.section._facing * self._space(rotation)
        entry = np.broadcast_to(there[-1], there.shape)
        return self.section._water.integral(np.minimum(entry, there), np.maximum(entry, there))

    def _growth(self, b: Floats) -> Floats:
        """Integral over the arc, from its entry to directions b, of the depth below each soil's datum, over R.

        (soils, ..., circles); 0 above the datum and of soils without one.
        """
        _, centre, radius = self.section._circle
        first, _ = self.span
        rows = []
        for soil in self.section.soils:
            if soil.datum is None:
                rows.append(np.zeros(b.shape))
                continue
            level = (soil.datum - centre[:, 1]) / radius  # of the datum above the centre
            reach = np.arccos(np.clip(-level, -1.0, 1.0))  # the datum crosses the arc at -reach and reach
            start, end = np.clip(first, -reach, reach), np.clip(b, -reach, reach)
            rows.append(level * (end - start) + np.sin(end) - np.sin(start))
        return np.stack(rows)

    def _cohesion_growth(self, rotation: Floats) -> Floats:
        """Parts of the resistance that grow with depth, of each soil one, (soils, M, circles), over R."""
        first, last = self.span
        there = self._space(rotation)
        if self.section.strength == "mass":
            there = there - rotation
        limit = last if self.section.foreland is None else np.inf  # a foreland's own rule goes on beyond the exit
        growth = self._growth(np.clip(there, first, limit))
        *joints, exit_, entry = range(len(there))
        stretches = self.stretches
        parts = np.zeros((len(self.section.soils), *rotation.shape))
        circle = np.arange(rotation.shape[1])
        for k in joints:
            parts[stretches.before[:, k], :, circle] += growth[stretches.before[:, k], k, :, circle]
            parts[stretches.after[:, k], :, circle] -= growth[stretches.after[:, k], k, :, circle]
        parts[stretches.last, :, circle] += growth[stretches.last, exit_, :, circle]
        parts[stretches.first, :, circle] -= growth[stretches.first, entry, :, circle]
        if self.section.foreland is None:
            parts += self._held_value(stretches.last, last, np.maximum(there[exit_] - last, 0.0))
        return parts + self._held_value(stretches.first, first, np.maximum(first - there[entry], 0.0))

    def _held_value(self, soil: NDArray[np.intp], direction: Floats, length: Floats) -> Floats:
        """What the value at an end of the arc, which goes on beyond it over a length, adds to these parts."""
        _, centre, radius = self.section._circle
        parts = np.zeros((len(self.section.soils), *length.shape))
        for k, s in enumerate(self.section.soils):
            if s.datum is not None:
                depth = np.maximum((s.datum - centre[:, 1]) / radius + np.cos(direction), 0.0)
                parts[k] = np.where(soil == k, depth * length, 0.0)
        return parts

    @cached_property
    def rotation_kinks(self) -> Floats:
        """Rotations at which one of these functions is not smooth, (kinks, circles), sorted."""
        first, last = self.span
        down = self.section._facing[:, None]
        edges = np.where(down > 0.0, self.section._strips.beta, -self.section._strips.beta[:, ::-1])
        base = [self.stretches.joint, first[:, None], last[:, None]]
        if self.section.level is not None:
            base.append(self.section._water.kinks * down)
        _, centre, radius = self.section._circle
        for s in self.section.soils:
            if s.datum is not None:
                reach = np.arccos(np.clip((centre[:, 1] - s.datum) / radius, -1.0, 1.0))[:, None]
                base += [reach, -reach]
        there = np.concatenate(base, axis=1)
        every = there[:, :, None] - edges[:, None, :]
        return np.sort(every.reshape(len(every), -1), axis=1).T

    @cached_property
    def _weight_steps(self) -> Floats:
        """Steps of the unit weight over its mean, (surfaces, lanes)."""
        return self.section._surfaces[1] / (self.section._weighted[AREA] / self.section._moments["area"])

    def _by_surface(self, quantity: Floats) -> Floats:
        """Coefficients of integrals up to joints of a quantity of the soils, ((J + 1) surfaces, lanes)."""
        differences = self.stretches.differences(quantity)
        product = differences[:, None] * self._weight_steps
        return product.reshape(-1, product.shape[-1])

    def _by_direction(self, quantity: Floats) -> Floats:
        """The same up to directions in space, joints, exit and entry, (J + 2, lanes)."""
        differences = self.stretches.differences(quantity)
        lane = np.arange(quantity.shape[1])
        first = self.stretches.first[lane if len(self.stretches.first) > 1 else np.zeros_like(lane)]
        return np.concatenate([differences, -quantity[first, lane][None]])

    def _mean(self, quantity: Floats) -> Floats:
        """Mean of a friction coefficient over the arc, by the normal forces at the start, (lanes,)."""
        still = np.zeros((1, len(self.section._facing)))
        normal = (self._by_surface(quantity) * self._normal(still)[:, 0]).sum(axis=0)
        return np.asarray(normal / -self.section._per_mean_weight[RADIAL_Y])

    @cached_property
    def mean_peak(self) -> Floats:
        """Friction coefficient of the whole arc at the start, (lanes,)."""
        return self._mean(self.section.of_soils(lambda s: s.peak))

    @cached_property
    def mean_residual(self) -> Floats:
        """Friction coefficient of the whole arc after much slip, by the normal forces at the start, (lanes,)."""
        return self._mean(self.section.of_soils(lambda s: s.residual))

    @cached_property
    def _friction_excess(self) -> tuple[Floats, Floats]:
        """By soil, over their means and less 1: the part of friction that slip takes away, and what remains.

        The same where friction is constant.
        """
        peak, residual = self.section.of_soils(lambda s: s.peak), self.section.of_soils(lambda s: s.residual)
        lost, mean_lost = peak - residual, self.mean_peak - self.mean_residual
        with np.errstate(divide="ignore", invalid="ignore"):
            remaining = np.where(self.mean_residual > 0.0, residual / self.mean_residual - 1.0, 0.0)
            changing = np.where(mean_lost != 0.0, lost / mean_lost - 1.0, remaining)
        return changing, remaining

    @cached_property
    def friction(self) -> MeanFriction:
        """The friction of the arc as a whole, as a `Scene` takes it: its mean, by the normal forces at the start."""
        laws = [s.friction for s in self.section.soils if isinstance(s.friction, Mapping)]
        peak, residual = self.section._shaped(self.mean_peak), self.section._shaped(self.mean_residual)
        if not laws:
            return MeanFriction(law="constant", coefficient=peak)
        return MeanFriction(laws[0], peak=peak, residual=residual)

    @cached_property
    def terms(self) -> dict[str, Any]:
        """What the balance takes beyond a homogeneous mass with the mean friction, over Theta*: numbers and functions.

        With mu = r + (p - r) f(s) of each soil, friction is mu_mean (N + G) + r_mean (G_r - G): N of the weight, G
        and G_r what the parts p - r and r of the soils take hold of beyond their means.
        """
        theta = self.section._per_mean_weight[INERTIA]
        changing, remaining = self._friction_excess
        takes_hold = self._by_surface(changing) / theta
        terms = self._gripping("normal", "turning", "inertia", takes_hold)
        if np.any(remaining != changing):
            left = self._by_surface(remaining - changing) * self.mean_residual / theta
            terms |= self._gripping("remaining_normal", "remaining", "remaining_inertia", left)
        terms["strength"] = self._cohesion()
        terms["lift"] = self._lift()
        empty = [n for n, term in terms.items() if isinstance(term, OfRotation) and not np.any(term.coefficients)]
        return {name: term for name, term in terms.items() if name not in empty}

    @property
    def _weight_scale(self) -> Floats:
        """gamma Theta* in N/m^3, by which weights come over Theta*, (lanes,)."""
        unit_weight = self.section._weighted[AREA] / self.section._moments["area"]
        return np.asarray(unit_weight * self.section._per_mean_weight[INERTIA])

    def _cohesion(self) -> OfRotation:
        """Strength without normal stress, over Theta*."""
        cohesion = self.section.of_soils(lambda s: s.cohesion) / (self._weight_scale * self.section._circle[2])
        constant = OfRotation(self._space, self._by_direction(cohesion))
        growth = self.section.of_soils(lambda s: s.cohesion_gradient) / self._weight_scale
        return _sum([constant, OfRotation(self._cohesion_growth, growth)]) if np.any(growth) else constant

    def _lift(self) -> OfRotation:
        """What water takes from the normal force, over the mean friction and Theta*: of the level, and of ratios."""
        share = self.section.of_soils(lambda s: s.peak) / np.where(self.mean_peak > 0.0, self.mean_peak, 1.0)
        ratio = self.section.of_soils(lambda s: s.pore_ratio)
        theta = self.section._per_mean_weight[INERTIA]
        of_ratios = OfRotation(self._overburden, self._by_surface(share * ratio) / theta)
        if self.section.level is None:
            return of_ratios
        weight = np.where(ratio > 0.0, 0.0, share) * self.section.water_unit_weight / self._weight_scale
        of_level = OfRotation(self._heads, self._by_direction(weight))
        return _sum([of_level, of_ratios]) if np.any(ratio) else of_level

    def _gripping(self, base: str, mass: str, inertia: str, coefficients: Floats) -> dict[str, Any]:
        """What friction takes hold of, with coefficients of the parts by surface: of weight and of inertia."""
        terms: dict[str, Any] = {inertia: OfRotation(self._inertia, coefficients)}
        if self.section.strength == "base":
            return terms | {base: OfRotation(self._normal, coefficients)}
        parts = self.parts(np.zeros((1, len(self.section._facing))))[..., 0, :]
        normal, slope = (parts[k].reshape(len(coefficients), -1) for k in (RADIAL_Y, RADIAL_X))
        terms[mass] = self.section._shaped((coefficients * -normal).sum(axis=0))
        terms[f"{mass}_slope"] = self.section._shaped((coefficients * slope).sum(axis=0))
        return terms


def _sum(functions: Sequence[OfRotation]) -> OfRotation:
    """The sum of functions of the rotation."""

    def parts(rotation: Floats) -> Floats:
        return np.concatenate([f.parts(rotation) for f in functions])

    return OfRotation(parts, np.concatenate([f.coefficients for f in functions]))
