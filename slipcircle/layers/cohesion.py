"""Cohesion of the soils along an arc: constant parts, and parts multiplied by laws of slip.

If all soils share a law f, c = r + (p - r) f(s) and sum c l = sum r l + f(s) sum (p - r) l. The law also multiplies the
growth with depth. Soils with separate laws have one term each.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from generated.program import OF_COHESION
from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.core.scene.effects import Law, cohesion_law
from slipcircle.layers.soils import share_one_law

Term = tuple[Law, Floats, Floats]  # law, and cohesion and growth with depth that it multiplies


@dataclass(frozen=True, eq=False)
class SoilCohesion:
    """Cohesion of the soils of a `slipcircle.layers.layers.LayeredSection`, (soils, lanes)."""

    section: Any

    @cached_property
    def peak(self) -> Floats:
        """Cohesion of each soil at the start, Pa, (soils, lanes)."""
        return self.section.of_soils("peak_cohesion")

    @cached_property
    def growth(self) -> Floats:
        """Increase of the cohesion of each soil with depth, Pa/m, (soils, lanes)."""
        return self.section.of_soils("cohesion_gradient")

    @cached_property
    def _laws(self) -> list[Law | None]:
        """Laws by which the cohesion of each soil changes with slip, None for a constant cohesion."""
        return [cohesion_law(soil.cohesion) for soil in self.section.soils]

    @cached_property
    def _share_one_law(self) -> bool:
        """Whether all soils whose cohesion changes share a law of slip and its length."""
        return share_one_law(self.section.soils, "cohesion")

    @cached_property
    def lasting(self) -> ArrayPair:
        """Cohesion that does not change with slip, Pa, and its growth with depth, Pa/m, each (soils, lanes)."""
        if not self._share_one_law:
            constant = [[float(law is None)] for law in self._laws]
            share = np.array(constant)
            return self.peak * share, self.growth * share
        residual = self.section.of_soils("residual_cohesion")
        is_none = self.peak == 0.0
        share = np.where(is_none, 1.0, residual / np.where(is_none, 1.0, self.peak))
        return residual, self.growth * share

    @cached_property
    def softening(self) -> dict[str, Term]:
        """Terms that change with slip, by the numbers of their laws in the program.

        A term has a law, and the cohesion and the growth with depth that it multiplies, (soils, lanes).
        """
        laws = [law for law in self._laws if law is not None]
        if not laws:
            return {}
        if not self._share_one_law:
            return self._by_soil()
        name, parameters = laws[0]
        cohesion, growth = self.lasting
        over_peak = name, {**parameters, "peak": 1.0, "residual": 0.0}
        return {OF_COHESION: (over_peak, self.peak - cohesion, self.growth - growth)}

    def _by_soil(self) -> dict[str, Term]:
        """Return a term for each soil whose cohesion changes, where the law gives the cohesion in Pa.

        The factors of a law are 1 for its soil and 0 for the others.
        """
        soils = self.section.soils
        divisor = np.where(self.peak == 0.0, 1.0, self.peak)
        terms = {}
        for k, soil in enumerate(self.section.soils_by_name.values()):
            law = cohesion_law(soil.cohesion)
            if law is None:
                continue
            along = np.array([[float(other.name == soil.name)] for other in soils])
            one = along * np.ones_like(self.growth)
            terms[f"{OF_COHESION}{k}"] = law, one, along * self.growth / divisor
        return terms
