"""Strength along the arc of a layered section as functions of the rotation, for the balance of a homogeneous mass.

After a rotation phi the stresses have turned with the mass; strength stays with the *base* below the arc, or goes with
the *mass*. With A, B and P the parts of J_r, of its slope and of I_p on the stretches of each soil,

    friction(phi, omega) = sum mu [cos(phi) A - sin(phi) B + omega*^2 P] - integral of mu u.

What this is more than with the mean friction coefficient on the whole arc is handed to the balance.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core.scene.friction import OF_SOIL
from slipcircle.core.scene.profile import INERTIA, RADIAL_Y, Floats
from slipcircle.core.scene.soils import share_one_law
from slipcircle.core.scene.stretches import StretchIntegrals


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


@dataclass(frozen=True, eq=False)
class ArcStrength(StretchIntegrals):
    """The strength along the arc of a `slipcircle.core.scene.layers.LayeredSection`."""

    _terms: dict[tuple[bool, bool, bool], dict[str, Any]] = field(default_factory=dict)

    def _by_surface(self, quantity: Floats) -> Floats:
        """Coefficients of integrals up to joints of a quantity of the soils, ((J + 1) surfaces, lanes)."""
        differences = self._by_direction(quantity)[:-1]
        product = differences[:, None] * self._surfaces[1]
        return product.reshape(-1, product.shape[-1])

    def _by_direction(self, quantity: Floats) -> Floats:
        """The same up to directions in space, joints, exit and entry, (J + 2, lanes)."""
        return over_circles(self.incidence.transpose(1, 0, 2), quantity)

    @cached_property
    def _still(self) -> dict[str, Floats]:
        """The parts at the start, by name, (parts, circles)."""
        still = np.zeros((1, len(self.section._facing)))
        names = ["normal", "space"]
        names += ["growth"] if any(datum is not None for datum in self.section.datums) else []
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
            by_surface = np.einsum("jic,jsc->sic", self.incidence[:-1], by_joint)
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
        is_rounding = np.abs(remaining) <= 1e-15 * np.abs(self._residual)
        return share, remaining - np.where(is_rounding, remaining.real, 0.0)

    @cached_property
    def friction(self) -> MeanFriction:
        """The friction of the arc as a whole, as a `Scene` takes it: its mean, by the normal forces at the start."""
        rate = {} if self.section.rate is None else {"rate": self.section.rate}
        if self._own_laws:
            by_soil = {soil.name: soil.friction for soil in self._distinct_soils}
            mean = self.section._shaped(self.mean_peak)
            return MeanFriction(law="of each soil", coefficient=mean, soils=by_soil, **rate)
        laws = [s.friction for s in self.section.soils if isinstance(s.friction, Mapping)]
        peak, residual = self.section._shaped(self.mean_peak), self.section._shaped(self.mean_residual)
        if not laws:
            return MeanFriction(law="constant", coefficient=peak, **rate)
        return MeanFriction(laws[0], peak=peak, residual=residual, **rate)

    def terms(self, rotates: bool, shaken: bool, complete: bool = False) -> dict[str, Any]:
        """What the balance takes beyond a homogeneous mass with the mean friction, over Theta*: numbers and functions.

        Of friction what it takes hold of beyond its mean, N + G + (G_r)/mu, N of the weight; G_r remains of it where
        soils do not soften alike. Whatever does not change with the rotation is a number. What is 0 is left out, unless
        they are to be complete, for what derivatives may not be 0 of.
        """
        key = rotates, shaken, complete
        if key not in self._terms:
            terms = {"strength": self._cohesion(rotates, complete)}
            share, remaining = self._shares
            if not self._own_laws:
                terms |= self._gripping(("normal", "turning", "inertia"), share - 1.0, rotates, shaken)
                if np.any(self._peak):
                    terms["lift"] = self._lift(share, rotates)
            if not self._own_laws and (np.any(remaining) or (complete and self._softens)):
                left = ("remaining_normal", "remaining", "remaining_inertia")
                terms |= self._gripping(left, remaining, rotates, shaken)
                terms["remaining_lift"] = self._lift(remaining, rotates)
            self._terms[key] = {name: term for name, term in terms.items() if complete or _counts(term)}
        return self._terms[key]

    # --- a friction law of its own for each soil -----------------------------------------------------------------

    @cached_property
    def _own_laws(self) -> bool:
        return not share_one_law(self.section.soils)

    @property
    def _distinct_soils(self) -> list[Any]:
        return list({id(soil): soil for soil in self.section.soils}.values())

    def soil_terms(self, rotates: bool, shaken: bool, complete: bool) -> dict[str, dict[str, Any]]:
        """What each soil with a friction law of its own adds to the balance, over Theta*, by the name of its effect.

        With n_i the share of soil i of the normal force at the start, mu = sum n_i mu_i, and N_i - n_i N is what the
        normal force on the soil exceeds its share by as the mass turns.
        """
        if not self._own_laws:
            return {}
        total = -self.section._per_mean_weight[RADIAL_Y]
        terms = {}
        for k, soil in enumerate(self._distinct_soils):
            along = np.array([[float(other is soil)] for other in self.section.soils])
            share = self._at_start("normal", along) / total
            excess = self._gripping(("", "turning", "inertia"), along - share, rotates, shaken)
            terms[f"soil_friction{OF_SOIL}{k}"] = {
                "share": self.section._shaped(share),
                "slope": excess["turning_slope"],
                "inertia": excess["inertia"],
            }
            lift = self._lift(along, rotates)
            if complete or _counts(lift):
                terms[f"soil_friction{OF_SOIL}{k}"]["lift"] = lift
        return terms

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

    def _cohesion(self, rotates: bool, complete: bool) -> Any:
        """Strength without normal stress, over Theta*."""
        section = self.section
        cohesion = section.of_soils(lambda s: s.cohesion)
        growth = section.of_soils(lambda s: s.cohesion_gradient)
        coefficients = {}
        if complete or np.any(cohesion):
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


def _counts(term: Any) -> bool:
    """Whether a term is not zero."""
    if isinstance(term, OfRotation):
        return any(np.any(values) for values in term.coefficients.values())
    return bool(np.any(term))
