"""Strength along the arc of a layered section as functions of the rotation, for the balance of a homogeneous mass.

After a rotation phi the stresses have turned with the mass. Strength stays with the *base* below the arc, or moves with
the *mass*. Let A, B and P be the parts of J_r, of its slope and of I_p on the stretches of each soil. Then

    friction(phi, omega) = sum mu [cos(phi) A - sin(phi) B + omega*^2 P] - integral of mu u.

The balance contains the difference from a mass with the mean friction coefficient on the whole arc.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from generated.program import OF_SOIL
from slipcircle.base.kinds import ArrayDict, ArrayPair, Floats, Names, Parameters, ValueDict
from slipcircle.core.scene.effects import Law
from slipcircle.layers.cohesion import SoilCohesion
from slipcircle.layers.soils import Soil, share_one_law
from slipcircle.layers.stretches import LIKE_WEIGHTS, StretchIntegrals


class OfRotation(NamedTuple):
    """Function of the rotation: the sum of coefficients (parts, lanes) times parts of the geometry alone.

    The keys of ``coefficients`` name the parts. Each part is a method of `ArcStrength`, which accepts down-slope
    rotations (M, circles) and returns (parts, M, circles).
    """

    strength: "ArcStrength"
    coefficients: Mapping[str, Floats]

    def __call__(self, rotation: Floats) -> Floats:
        """Return the values after rotations in rad, (M, circles), as an array (M, lanes)."""
        parts = self.strength.parts(rotation, self.coefficients)
        return self.combined(parts)

    def combined(self, parts: Mapping[str, Floats]) -> Floats:
        """Return the values, (..., lanes), from known parts (parts, ..., circles) by name."""
        total = np.zeros(())
        for name, values in self.coefficients.items():
            total = total + over_circles(parts[name], values)
        return total


def over_circles(parts: Floats, coefficients: Floats) -> Floats:
    """Return sums over the first axis of parts (parts, ..., circles) times coefficients (parts, lanes).

    The result is (..., lanes). There is one circle for all lanes (members of an ensemble) or one per lane.
    """
    if parts.shape[-1] == 1:
        return np.tensordot(parts[..., 0], coefficients, (0, 0))
    return np.einsum("p...l,pl->...l", parts, coefficients)


class Needs(NamedTuple):
    """Effects of a scene that determine its strength terms: whether the mass rotates, and whether it is shaken."""

    rotates: bool
    shaken: bool = False


class MeanFriction(ValueDict):
    """Friction law of an arc as a whole, composed of the soils along it."""


@dataclass(frozen=True, eq=False)
class ArcStrength(StretchIntegrals):
    """Strength along the arc of a `slipcircle.layers.layers.LayeredSection`."""

    _terms: dict[Needs, ValueDict] = field(default_factory=dict)

    @property
    def _unit_weights(self) -> Floats:
        """Unit weight of each column of the profile over the mean, (columns, lanes)."""
        _, steps = self.section._columns
        return steps / self.section._weights_per_area

    def _by_surface(self, quantity: Floats) -> Floats:
        """Return coefficients of integrals up to J joints of a quantity (soils, lanes), ((J + 1) surfaces, lanes)."""
        differences = self._by_direction(quantity)[:-1]
        product = differences[:, None] * self._unit_weights
        joints, surfaces, lanes = product.shape
        return product.reshape(joints * surfaces, lanes)

    def _by_direction(self, quantity: Floats) -> Floats:
        """Return coefficients of integrals of a quantity (soils, lanes) to joints, exit and entry, (J + 2, lanes)."""
        return over_circles(self.incidence, quantity)

    @cached_property
    def _still(self) -> ArrayDict:
        """Parts of `StretchIntegrals` at the start by name, (parts, circles)."""
        circles = len(self.section._facing)
        names = ["overburden", "space"]
        if any(self.section.depths):
            names.append("growth")
        if self.section.level is not None:
            names.append("heads")
        if self.section.in_standing_water:
            names += ["standing", "displaced"]
        parts = self.parts(np.zeros((1, circles)), names)
        return {name: part[:, 0] for name, part in parts.items()}

    @cached_property
    def _by_soil(self) -> ArrayDict:
        """Load on the stretches of each soil at the start, over the mean unit weight, (soils, lanes)."""
        weights = self._unit_weights
        at_joints = self.incidence[:, :-1]
        _, joints, circles = at_joints.shape
        by_soil = {}
        for name in ("normal", "tilt", "inertia", "overburden"):
            part = self._still[name]
            by_joint = part.reshape(joints, len(weights), circles)
            by_surface = np.einsum("ijc,jsc->sic", at_joints, by_joint)
            by_soil[name] = over_circles(by_surface, weights)
        return by_soil

    def _at_start(self, name: str, quantity: Floats) -> Floats:
        """Return the sum over the soils of a quantity (soils, lanes) times a load named in `_by_soil`, (lanes,)."""
        by_soil = self._by_soil[name] * quantity
        total = by_soil.sum(axis=0)
        return total

    def _mean(self, quantity: Floats) -> Floats:
        """Return the mean of a friction coefficient (soils, lanes) by the normal forces at the start, (lanes,)."""
        load = -self.section._weighted_moments["radial_y"]
        return self._at_start("normal", quantity) / load

    @cached_property
    def _peak(self) -> Floats:
        """Friction coefficient of each soil at the start, (soils, lanes)."""
        return self.section.of_soils("peak")

    @cached_property
    def _laws(self) -> list[Parameters]:
        """Friction laws of the soils whose friction is not constant."""
        frictions = [soil.friction for soil in self.section.soils]
        return [friction for friction in frictions if isinstance(friction, Mapping)]

    @cached_property
    def _residual(self) -> Floats:
        """Friction coefficient of each soil after much slip, (soils, lanes)."""
        return self.section.of_soils("residual")

    @cached_property
    def mean_peak(self) -> Floats:
        """Friction coefficient of the whole arc at the start, (lanes,)."""
        return self._mean(self._peak)

    @cached_property
    def mean_residual(self) -> Floats:
        """Friction coefficient of the whole arc after much slip, by the normal forces at the start, (lanes,)."""
        return self._mean(self._residual)

    @cached_property
    def _shares(self) -> ArrayPair:
        """Shares of the soils in the friction that slip removes, over its mean, and coefficients of the remainder.

        With p and r the peak and residual coefficients, the shares are s = (p - r)/(p - r)_mean, and the coefficients
        r - r_mean s. For mu = r + (p - r) f(slip) of each soil and of the means, sum mu N = mu_mean (sum s N) +
        sum (r - r_mean s) N. The second sum is 0 if all soils soften in the same proportion, and if slip removes no
        friction, where the shares are p/p_mean.
        """
        has_friction = self.mean_peak != 0.0
        mean = np.where(has_friction, self.mean_peak, 1.0)
        of_peaks = self._peak / mean
        share = np.where(has_friction, of_peaks, 1.0)
        if not self._laws:
            return share, np.zeros(1)
        lost = self._peak - self._residual
        mean_lost = self.mean_peak - self.mean_residual
        mean_softens = mean_lost != 0.0
        softens = np.any(lost, axis=0) & mean_softens
        divisor = np.where(softens, mean_lost, 1.0)
        share = np.where(softens, lost / divisor, share)
        beyond_share = self._residual - self.mean_residual * share
        remaining = np.where(softens, beyond_share, 0.0)
        rounding = 2e-15 * np.abs(self._residual * mean / divisor)  # peak less residual cancels
        is_rounding = np.abs(remaining) <= rounding
        return share, np.where(is_rounding, 0.0, remaining)

    @cached_property
    def friction(self) -> MeanFriction:
        """Friction of the arc as a whole for a `Scene`, the mean weighted by the normal forces at the start."""
        peak = self.section._shaped(self.mean_peak)
        rate = {} if self.section.rate is None else {"rate": self.section.rate}
        if self._own_laws:
            by_soil = {name: soil.friction for name, soil in self.section.soils_by_name.items()}
            return MeanFriction(law="of each soil", coefficient=peak, soils=by_soil, **rate)
        if not self._laws:
            return MeanFriction(law="constant", coefficient=peak, **rate)
        residual = self.section._shaped(self.mean_residual)
        return MeanFriction(self._laws[0], peak=peak, residual=residual, **rate)

    def terms(self, needs: Needs) -> ValueDict:
        """Return the terms of the balance beyond a homogeneous mass with the mean friction, over Theta*.

        The friction terms are the normal force beyond the mean, N + G + (G_r)/mu, with N from the weight, where G_r is
        nonzero if soils soften differently. Terms that do not change with the rotation are numbers. Terms that are 0
        are omitted.
        """
        if needs not in self._terms:
            cohesion, growth = self._soil_cohesion.lasting
            terms = {"strength": self._cohesion(needs, cohesion, growth)}
            if not self._own_laws:
                terms |= self._friction_terms(needs)
            self._terms[needs] = {name: term for name, term in terms.items() if _counts(term)}
        return self._terms[needs]

    def _friction_terms(self, needs: Needs) -> ValueDict:
        """Return the normal forces of friction under one law of slip beyond its mean, and of the remaining friction."""
        share, remaining = self._shares
        names = ("normal", "turning", "inertia")
        beyond_mean = share - 1.0
        terms = self._gripping(names, beyond_mean, needs)
        if np.any(self._peak):
            terms["lift"] = self._lift(share, needs)
        if np.any(remaining):
            names = ("remaining_normal", "remaining", "remaining_inertia")
            terms |= self._gripping(names, remaining, needs)
            terms["remaining_lift"] = self._lift(remaining, needs)
        return terms

    def mean_lift(self, needs: Needs) -> ValueDict:
        """Return the mean pore pressure over the arc as a term of the balance, without weighting by soils."""
        every_soil = np.ones_like(self._peak)
        return {"lift": self._lift(every_soil, needs)}

    # --- a friction law of its own for each soil -----------------------------------------------------------------

    @cached_property
    def _own_laws(self) -> bool:
        """Whether the soils have separate friction laws."""
        return not share_one_law(self.section.soils)

    @property
    def distinct_soils(self) -> list[Soil]:
        """Soils of the layers and of the foreland, without repetition."""
        return list(self.section.soils_by_name.values())

    def _is_soil(self, soil: Soil) -> Floats:
        """Return 1 for a soil and 0 for the other soils, (soils, 1)."""
        return np.array([[float(other.name == soil.name)] for other in self.section.soils])

    def of_soil(self, soil: Soil) -> ValueDict:
        """Return the terms of a soil in the balance at the start, over Theta*, and its angle along the arc, rad."""
        along = self._is_soil(soil)
        at_start = Needs(rotates=False)
        added = self._gripping(("", "normal", "inertia"), along, at_start)
        added["lift"] = self._lift(along, at_start)
        gradient = self.section.of_soils("cohesion_gradient")
        added["cohesion"] = self._cohesion(at_start, along * self._soil_cohesion.peak, along * gradient)
        added["angle"] = self._function({"space": self._by_direction(along)}, False)
        return added

    def soil_terms(self, needs: Needs) -> dict[str, ValueDict]:
        """Return the terms of standing water and of each soil with a separate friction law, over Theta*, by effect.

        Let n_i be the share of soil i in the normal force at the start. Then mu = sum n_i mu_i, and N_i - n_i N is the
        excess of the normal force on the soil over its share as the mass turns.
        """
        terms = {}
        if self.section.in_standing_water:
            moment = self._standing_moment(needs)
            terms["pore_pressure"] = {"standing": moment}
        if not self._own_laws:
            return terms
        for k, soil in enumerate(self.distinct_soils):
            along = self._is_soil(soil)
            share = self._mean(along)
            names = ("", "turning", "inertia")
            excess = self._gripping(names, along - share, needs)
            of_soil = {"share": self.section._shaped(share)}
            of_soil["slope"] = excess["turning_slope"]
            of_soil["inertia"] = excess["inertia"]
            lift = self._lift(along, needs)
            if _counts(lift):
                of_soil["lift"] = lift
            terms[f"soil_friction{OF_SOIL}{k}"] = of_soil
        return terms

    @property
    def _theta(self) -> Floats:
        """Moment of inertia Theta* of the mass, (lanes,)."""
        inertia = self.section._weighted_moments["inertia"]
        return inertia

    @property
    def _weight_scale(self) -> Floats:
        """Scale gamma Theta* of weights over Theta*, N/m^3, (lanes,)."""
        return self.section._weights_per_area * self._theta

    def _gripping(self, names: Names, quantity: Floats, needs: Needs) -> ValueDict:
        """Return the normal forces of weight and of inertia, summed over the soils with a factor for each.

        The factor `quantity`, (soils, lanes), is a share of the friction, and the forces are over Theta*. `names` are
        prefixes of the terms with strength of the base and of the mass, and the name of the inertia term. Terms are
        functions of the rotation if the mass rotates over its base, according to `needs`, and numbers otherwise.
        """
        base, mass, inertia = names

        def at_start(part: str) -> Any:
            total = self._at_start(part, quantity)
            return self.section._shaped(total / self._theta)

        tilt = at_start("tilt")
        if not needs.rotates or not self._base_stays:
            normal = at_start("normal")
            return {mass: normal, f"{mass}_slope": tilt, inertia: at_start("inertia")}
        coefficients = self._by_surface(quantity) / self._theta
        if needs.shaken:
            tilt = OfRotation(self, {"tilt": coefficients})
        return {
            base: OfRotation(self, {"normal": coefficients}),
            inertia: OfRotation(self, {"inertia": coefficients}),
            f"{base}_slope": tilt,  # for the yield coefficient too
        }

    # --- cohesion, which may change with slip ------------------------------------------------------------------------

    @cached_property
    def _soil_cohesion(self) -> SoilCohesion:
        return SoilCohesion(self.section)

    @property
    def cohesion_laws(self) -> tuple[Law, ...]:
        """Laws of cohesion by their names in the program, with their parameters."""
        return tuple((name + number, law) for number, ((name, law), _, _) in self._soil_cohesion.softening.items())

    def cohesion_terms(self, needs: Needs) -> dict[str, ValueDict]:
        """Return the moments that the laws of cohesion multiply, over Theta*, by the names of their effects."""
        return {
            f"softening_cohesion{number}": {"moment": self._cohesion(needs, cohesion, growth)}
            for number, (_, cohesion, growth) in self._soil_cohesion.softening.items()
        }

    def _cohesion(self, needs: Needs, cohesion: Floats, growth: Floats) -> Any:
        """Return the moment of cohesion in Pa and of its growth in Pa/m, (soils, lanes), over Theta*."""
        section = self.section
        coefficients = {}
        if np.any(cohesion):
            _, _, radius = section._circle
            dimensionless = cohesion / (self._weight_scale * radius)
            coefficients["space"] = self._by_direction(dimensionless)
        if np.any(growth):
            coefficients["growth"] = growth / self._weight_scale
        return self._function(coefficients, needs.rotates and self._base_stays)

    def _lift(self, share: Floats, needs: Needs) -> Any:
        """Return the reduction by water of the normal force on a share (soils, lanes) of friction, over Theta*."""
        section = self.section
        ratio = section.of_soils("pore_ratio")
        coefficients = {}
        if np.any(ratio):
            by_surface = self._by_surface(share * ratio)
            coefficients["overburden"] = by_surface / self._theta
        stays_in_space = self._base_stays or section.level is not None
        if section.level is not None:
            below_level = np.where(ratio > 0.0, 0.0, share)
            weight = below_level * section.water_unit_weight / self._weight_scale
            coefficients["heads"] = self._by_direction(weight)
        if section.in_standing_water:
            stays_in_space = True
            weight = share * section.water_unit_weight / self._weight_scale
            by_direction = self._by_direction(weight)
            coefficients["standing"] = by_direction / LIKE_WEIGHTS
        return self._function(coefficients, needs.rotates and stays_in_space)

    def _standing_moment(self, needs: Needs) -> Any:
        """Return the moment of displaced water over Theta*, a function of the rotation if the mass rotates."""
        section = self.section
        inertia = section._moments["inertia"]
        share = section.water_unit_weight * inertia / self._weight_scale
        coefficients = share / LIKE_WEIGHTS
        return self._function({"displaced": coefficients[None]}, needs.rotates)

    def _function(self, coefficients: Mapping[str, Floats], changes: bool) -> Any:
        """Return a function of the rotation if it changes, or its initial value; 0 without coefficients."""
        if not coefficients:
            return 0.0
        function = OfRotation(self, coefficients)
        if changes:
            return function
        at_start = function.combined(self._still)
        return self.section._shaped(at_start)


def _counts(term: Any) -> bool:
    """Return whether a term of the balance, a number or a function of the rotation, is nonzero for any lane."""
    if isinstance(term, OfRotation):
        return any(map(np.any, term.coefficients.values()))
    return bool(np.any(term))
