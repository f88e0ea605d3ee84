"""Strength along the arc of a layered section as functions of the rotation, for the balance of a homogeneous mass.

After a rotation phi the stresses have turned with the mass; strength stays with the *base* below the arc, or goes with
the *mass*. With A, B and P the parts of J_r, of its slope and of I_p on the stretches of each soil,

    friction(phi, omega) = sum mu [cos(phi) A - sin(phi) B + omega*^2 P] - integral of mu u.

What this is more than with the mean friction coefficient on the whole arc is handed to the balance. A quantity q of the
soils summed over the stretches, with a cumulative integral C from the entry, is

    q_last C(exit) + sum over the joints of stretches of (q_before - q_after) C(joint),

so that only C at the joints depends on the rotation, and only the differences on the numbers of the soils.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene.profile import HEAD, INERTIA, POLAR, RADIAL_X, RADIAL_Y, Floats, Profile

# What sections that differ in numbers of soils alone have in common.
OF_GEOMETRY = ("stretches", "span", "rotation_kinks")
_PRESSING = (RADIAL_Y, RADIAL_X, POLAR, HEAD)  # the integrals that strength takes


class OfRotation(NamedTuple):
    """A function of the rotation, the sum of coefficients (parts, lanes) times parts of the geometry alone.

    ``coefficients`` are by the name of those parts: a method of `ArcStrength`, which takes rotations (M, circles),
    down-slope, and returns (parts, M, circles).
    """

    strength: "ArcStrength"
    coefficients: Mapping[str, Floats]

    def __call__(self, rotation: Floats) -> Floats:
        """Its values after rotations (M, circles), (M, lanes)."""
        return self.combined(self.strength.parts(rotation, self.coefficients))

    def combined(self, parts: Mapping[str, Floats]) -> Floats:
        """Its values from parts that are known."""
        return sum((over_circles(parts[name], values) for name, values in self.coefficients.items()), np.zeros(()))


def over_circles(parts: Floats, coefficients: Floats) -> Floats:
    """Sums over the first axis of parts (parts, ..., circles) times coefficients (parts, lanes), (..., lanes)."""
    if parts.shape[-1] == 1:
        return np.tensordot(parts[..., 0], coefficients, (0, 0))
    return np.einsum("p...l,pl->...l", parts, coefficients)


class MeanFriction(dict[str, Any]):
    """The law of friction of an arc as a whole that the soils along it make up."""


class Stretches(NamedTuple):
    """Where the soil at the base changes along the arc: (circles, J) directions, and the soils above and below."""

    joint: Floats
    before: NDArray[np.intp]
    after: NDArray[np.intp]
    first: NDArray[np.intp]
    last: NDArray[np.intp]

    def incidence(self, soils: int) -> Floats:
        """(q_before - q_after) at joints, q_last and -q_first of a quantity q of the soils, (J + 2, soils, circles).

        Summed over the stretches with a cumulative integral C from the entry, q is q_last C(exit) + sum_j (q_before -
        q_after)_j C(b_j); of an integral from elsewhere the last row takes what is at the entry.
        """
        rows = np.concatenate([self.before.T, self.last[None], self.first[None]])
        one = np.eye(soils)[rows].transpose(0, 2, 1)
        one[:-2] -= np.eye(soils)[self.after.T].transpose(0, 2, 1)
        one[-1] *= -1.0
        return np.asarray(one)


@dataclass(frozen=True, eq=False)
class ArcStrength:
    """The strength along the arc of a `slipcircle.core.scene.layers.LayeredSection`."""

    section: Any
    _terms: dict[tuple[bool, bool], dict[str, Any]] = field(default_factory=dict)

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

    def _joints_met(self, rotation: Floats) -> Floats:
        """Where the mass meets the joints, and its exit, after rotations (M, circles), (J + 1, M, circles).

        In directions of the mass at the start. Joints of the base stay behind as the mass moves on.
        """
        first, last = self.span
        moved = rotation if self.section.strength == "base" else np.zeros_like(rotation)
        joints = [np.clip(j - moved, first, last) for j in self.stretches.joint.T]
        return np.stack([*joints, np.broadcast_to(last, rotation.shape)])

    @cached_property
    def _surfaces(self) -> tuple[Profile, Floats]:
        """The profile of what presses, and the unit weight below each of its surfaces over the mean, (surfaces, lanes).

        One surface stands for all where lanes differ in strength alone.
        """
        profile = self.section.profile.of(_PRESSING)
        steps = self.section.weight_steps
        if profile.edges.shape[1] == 1 and np.all(steps == steps[:, :1]):
            profile, steps = profile.combined(steps[:, 0]), np.ones((1, 1))
        return profile, steps / self.section._weights_per_area

    def _pressing(self, rotation: Floats) -> Floats:
        """Integrals of unit weights below surfaces up to where joints are met, (4, J + 1, surfaces, M, circles).

        From the entry; of x down-slope.
        """
        profile, _ = self._surfaces
        facing = self.section._facing
        met = self._joints_met(rotation)
        at = profile.up_to(facing * met.reshape(-1, met.shape[-1]))
        at = np.where(facing > 0.0, at, profile.whole[:, :, None] - at)
        at[1] *= facing
        by_joint = at.reshape(*at.shape[:2], *met.shape)
        return np.moveaxis(by_joint, 1, 2)

    def parts(self, rotation: Floats, names: Any) -> dict[str, Floats]:
        """Parts by their names, of what presses all at once."""
        of_weight = {"normal", "tilt", "inertia", "overburden"}
        every: dict[str, Floats] = {name: getattr(self, name)(rotation) for name in {*names} - of_weight}
        if of_weight & {*names}:
            radial_y, radial_x, polar, overburden = self._pressing(rotation).reshape(4, -1, *rotation.shape)
            cosine, sine = np.cos(rotation), np.sin(rotation)
            # J(psi - phi) = J cos(phi) - J' sin(phi), and its derivative by psi
            every["normal"] = -radial_y * cosine - radial_x * sine
            every["tilt"] = radial_x * cosine - radial_y * sine
            every["inertia"] = polar
            every["overburden"] = overburden
        return every

    def space(self, rotation: Floats) -> Floats:
        """Directions in space of the joints, the exit and the entry after rotations, (J + 2, M, circles)."""
        first, last = self.span
        start, end = first + rotation, last + rotation
        joints = self.stretches.joint.T
        there = [np.clip(j, start, end) if self.section.strength == "base" else j + rotation for j in joints]
        return np.stack([*there, end, start])

    def heads(self, rotation: Floats) -> Floats:
        """Integrals of the head of the water level from the entry to these directions, (J + 2, M, circles)."""
        there = self.section._facing * self.space(rotation)
        entry = np.broadcast_to(there[-1], there.shape)
        return self.section.heads_between(np.minimum(entry, there), np.maximum(entry, there))

    def _growth(self, b: Floats) -> Floats:
        """Integral over the arc, from its entry to directions b, of the depth below each soil's datum, over R.

        (soils, ..., circles); 0 above the datum and of soils without one.
        """
        _, centre, radius = self.section._circle
        first, _ = self.span
        rows = []
        for soil in self.section.soils:
            if soil.datum is None:
                rows.append(np.zeros_like(b))
                continue
            level = (soil.datum - centre[:, 1]) / radius  # of the datum above the centre
            reach = np.arccos(np.clip(-level, -1.0, 1.0))  # the datum crosses the arc at -reach and reach
            start, end = np.clip(first, -reach, reach), np.clip(b, -reach, reach)
            rows.append(level * (end - start) + np.sin(end) - np.sin(start))
        return np.stack(rows)

    def growth(self, rotation: Floats) -> Floats:
        """Parts of the resistance that grow with depth, of each soil one, (soils, M, circles), over R."""
        first, last = self.span
        there = self.space(rotation)
        if self.section.strength == "mass":
            there = there - rotation
        limit = last if self.section.foreland is None else np.inf  # a foreland's own rule goes on beyond the exit
        growth = self._growth(np.clip(there, first, limit))
        *joints, exit_, entry = range(len(there))
        stretches = self.stretches
        parts = np.zeros((len(self.section.soils), *rotation.shape), dtype=growth.dtype)
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
        parts = np.zeros((len(self.section.soils), *length.shape), dtype=length.dtype)
        for k, s in enumerate(self.section.soils):
            if s.datum is not None:
                depth = np.maximum((s.datum - centre[:, 1]) / radius + np.cos(direction), 0.0)
                parts[k] = np.where(soil == k, depth * length, 0.0)
        return parts

    @cached_property
    def rotation_kinks(self) -> Floats:
        """Rotations at which one of these functions is not smooth, (kinks, circles), sorted."""
        section = self.section
        ends = np.stack(self.span, axis=1).real
        joints = self.stretches.joint.real
        down = section._facing[:, None]
        kinks = [ends[:, 1:] - ends[:, :1]]
        if section.level is not None:
            turning = ends if section.strength == "base" else np.concatenate([ends, joints], axis=1)
            kinks.append(_differences(section._water.kinks * down, turning))
        if section.strength == "base":
            kinks.append(_differences(joints, section._strips.beta.real * down))
            _, centre, radius = section._circle
            for s in section.soils:
                if s.datum is not None:
                    reach = np.arccos(np.clip((centre[:, 1].real - s.datum) / radius.real, -1.0, 1.0))
                    kinks.append(_differences(np.stack([reach, -reach], axis=1), ends))
        return np.sort(np.concatenate(kinks, axis=1), axis=1).T

    @cached_property
    def _incidence(self) -> Floats:
        return self.stretches.incidence(len(self.section.soils))

    def _by_surface(self, quantity: Floats) -> Floats:
        """Coefficients of integrals up to joints of a quantity of the soils, ((J + 1) surfaces, lanes)."""
        differences = self._by_direction(quantity)[:-1]
        product = differences[:, None] * self._surfaces[1]
        return product.reshape(-1, product.shape[-1])

    def _by_direction(self, quantity: Floats) -> Floats:
        """The same up to directions in space, joints, exit and entry, (J + 2, lanes)."""
        return over_circles(self._incidence.transpose(1, 0, 2), quantity)

    @cached_property
    def _still(self) -> dict[str, Floats]:
        """The parts at the start, by name, (parts, circles)."""
        still = np.zeros((1, len(self.section._facing)))
        names = ["normal", "space"]
        names += ["growth"] if any(s.datum is not None for s in self.section.soils) else []
        names += ["heads"] if self.section.level is not None else []
        return {name: part[:, 0] for name, part in self.parts(still, names).items()}

    @cached_property
    def _by_soil(self) -> dict[str, Floats]:
        """What presses on the stretches of each soil at the start, over the mean unit weight, (soils, lanes)."""
        weights = self._surfaces[1]
        found = {}
        for name in ("normal", "tilt", "inertia", "overburden"):
            part = self._still[name]
            by_joint = part.reshape(-1, len(weights), part.shape[-1])
            by_surface = np.einsum("jic,jsc->sic", self._incidence[:-1], by_joint)
            found[name] = over_circles(by_surface, weights)
        return found

    def _at_start(self, name: str, quantity: Floats) -> Floats:
        """A quantity of the soils times what presses on their stretches, (lanes,)."""
        return np.asarray((self._by_soil[name] * quantity).sum(axis=0))

    def _mean(self, quantity: Floats) -> Floats:
        """Mean of a friction coefficient over the arc, by the normal forces at the start, (lanes,)."""
        return self._at_start("normal", quantity) / -self.section._per_mean_weight[RADIAL_Y]

    @cached_property
    def _peak(self) -> Floats:
        return self.section.of_soils(lambda s: s.peak)

    @cached_property
    def _softens(self) -> bool:
        return any(isinstance(soil.friction, Mapping) for soil in self.section.soils)

    @cached_property
    def _residual(self) -> Floats:
        return self.section.of_soils(lambda s: s.residual) if self._softens else self._peak

    @cached_property
    def mean_peak(self) -> Floats:
        """Friction coefficient of the whole arc at the start, (lanes,)."""
        return self._mean(self._peak)

    @cached_property
    def mean_residual(self) -> Floats:
        """Friction coefficient of the whole arc after much slip, by the normal forces at the start, (lanes,)."""
        return self._mean(self._residual) if self._softens else self.mean_peak

    @cached_property
    def _shares(self) -> tuple[Floats, Floats]:
        """By soil, over their means: the part of friction that slip takes away, and what remains beyond this share.

        With mu = r + (p - r) f(s) of each soil and of the means, sum mu N = mu_mean (sum (p - r)/(p - r)_mean N) +
        sum (r - r_mean (p - r)/(p - r)_mean) N: the second sum is 0 where the soils soften alike.
        """
        mean = np.where(self.mean_peak != 0.0, self.mean_peak, 1.0)
        share = np.where(self.mean_peak != 0.0, self._peak / mean, 1.0)
        if not self._softens:
            return share, np.zeros(1)
        lost = self._peak - self._residual
        mean_lost = self.mean_peak - self.mean_residual
        softens = np.any(lost, axis=0) & (mean_lost != 0.0)
        share = np.where(softens, lost / np.where(softens, mean_lost, 1.0), share)
        remaining = np.where(softens, self._residual - self.mean_residual * share, 0.0)
        rounding = 1e-15 * np.abs(self._residual)
        return share, np.where(np.abs(remaining) > rounding, remaining, 0.0)

    @cached_property
    def friction(self) -> MeanFriction:
        """The friction of the arc as a whole, as a `Scene` takes it: its mean, by the normal forces at the start."""
        laws = [s.friction for s in self.section.soils if isinstance(s.friction, Mapping)]
        peak, residual = self.section._shaped(self.mean_peak), self.section._shaped(self.mean_residual)
        rate = {} if self.section.rate is None else {"rate": self.section.rate}
        if not laws:
            return MeanFriction(law="constant", coefficient=peak, **rate)
        return MeanFriction(laws[0], peak=peak, residual=residual, **rate)

    def terms(self, rotates: bool, shaken: bool) -> dict[str, Any]:
        """What the balance takes beyond a homogeneous mass with the mean friction, over Theta*: numbers and functions.

        Of friction what it takes hold of beyond its mean, N + G + (G_r)/mu, N of the weight; G_r remains of it where
        soils do not soften alike. Whatever does not change with the rotation is a number.
        """
        key = rotates, shaken
        if key not in self._terms:
            share, remaining = self._shares
            terms = self._gripping(("normal", "turning", "inertia"), share - 1.0, *key)
            if np.any(self._peak):
                terms["lift"] = self._lift(share, rotates)
            terms["strength"] = self._cohesion(rotates)
            if np.any(remaining):
                left = ("remaining_normal", "remaining", "remaining_inertia")
                terms |= self._gripping(left, remaining, *key)
                terms["remaining_lift"] = self._lift(remaining, rotates)
            self._terms[key] = {name: term for name, term in terms.items() if _counts(term)}
        return self._terms[key]

    @property
    def _theta(self) -> Floats:
        return np.asarray(self.section._per_mean_weight[INERTIA])

    @property
    def _weight_scale(self) -> Floats:
        """gamma Theta* in N/m^3, by which weights come over Theta*, (lanes,)."""
        return self.section._weights_per_area * self._theta

    def _gripping(self, names: tuple[str, str, str], quantity: Floats, rotates: bool, shaken: bool) -> dict[str, Any]:
        """What a share of friction takes hold of, of weight and of inertia."""
        base, mass, inertia = names

        def at_start(part: str) -> Any:
            return self.section._shaped(self._at_start(part, quantity) / self._theta)

        if not rotates or self.section.strength == "mass":
            return {mass: at_start("normal"), f"{mass}_slope": at_start("tilt"), inertia: at_start("inertia")}
        coefficients = self._by_surface(quantity) / self._theta
        slope = OfRotation(self, {"tilt": coefficients}) if shaken else at_start("tilt")
        terms = {
            name: OfRotation(self, {part: coefficients}) for name, part in ((base, "normal"), (inertia, "inertia"))
        }
        return {**terms, f"{base}_slope": slope}  # which the yield coefficient takes too

    def _cohesion(self, rotates: bool) -> Any:
        """Strength without normal stress, over Theta*."""
        section = self.section
        cohesion = section.of_soils(lambda s: s.cohesion)
        growth = section.of_soils(lambda s: s.cohesion_gradient)
        coefficients = {}
        if np.any(cohesion):
            coefficients["space"] = self._by_direction(cohesion / (self._weight_scale * section._circle[2]))
        if np.any(growth):
            coefficients["growth"] = growth / self._weight_scale
        return self._function(coefficients, rotates and section.strength == "base")

    def _lift(self, share: Floats, rotates: bool) -> Any:
        """What water takes from the normal force of a share of friction, over Theta*: of the level, and of ratios."""
        section = self.section
        ratio = section.of_soils(lambda s: s.pore_ratio)
        coefficients = {"overburden": self._by_surface(share * ratio) / self._theta} if np.any(ratio) else {}
        if section.level is not None:
            weight = np.where(ratio > 0.0, 0.0, share) * section.water_unit_weight / self._weight_scale
            coefficients["heads"] = self._by_direction(weight)
        return self._function(coefficients, rotates and (section.strength == "base" or section.level is not None))

    def _function(self, coefficients: Mapping[str, Floats], changes: bool) -> Any:
        """A function of the rotation, or the number that it is at the start; 0 of nothing."""
        if not coefficients:
            return 0.0
        function = OfRotation(self, coefficients)
        return function if changes else self.section._shaped(function.combined(self._still))


def _differences(there: Floats, mass: Floats) -> Floats:
    """Rotations that bring directions of the mass to directions in space, (circles, N M)."""
    return (there[:, :, None] - mass[:, None, :]).reshape(len(there), -1)


def _counts(term: Any) -> bool:
    """Whether a term is not zero."""
    if isinstance(term, OfRotation):
        return any(np.any(values) for values in term.coefficients.values())
    return bool(np.any(term))
