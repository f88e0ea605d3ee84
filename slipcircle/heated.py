"""One phase of motion under undrained-adiabatic thermal pressurisation, in the phase plane.

While friction depends on the slip at most, E and the excess pore pressure p obey a linear system in the rotation x:
E' = 2 (drive + mu lambda p - brake E) and p' = kappa mu (sigma' without p - p), solved by collocation as E alone is.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.chebyshev import NODES
from slipcircle.phaseplane import _MEAN, _Z, Course, energy_on_panels, of_row

Floats = NDArray[np.float64]


class Heated(Course):
    """A phase in which friction heats the slip surface; see `slipcircle.phaseplane.Course`.

    ``excess_at`` is the excess pore pressure over sigma_ref at a rotation.
    """

    def driving(self, x: Any) -> Any:
        """The drive at x, with the pressure there; while it is not known, with that of the start."""
        driving = super().driving(x)
        if not hasattr(self, "excess_at"):
            return driving
        risen = self.excess_at(x) - self.start.excess
        return driving + self.friction(x) * self.balance.values["level"] * risen

    def pressing(self, x: Any, energy: Any) -> Any:
        """The effective mean normal stress over sigma_ref."""
        excess = self.excess_at(x)
        return self.balance.get("effective_stress", press=self.press(x), omega_2=energy, excess=excess)

    def resistance(self, x: Any, energy: Any) -> Any:
        """The moment over Theta* of all that opposes the motion."""
        local = {"press": self.press(x), "omega_2": energy, "excess": self.excess_at(x), "mu": self.friction(x)}
        return self.balance.get("resistance", **local) + 0.0 * x

    @property
    def excess(self) -> float:
        """Excess pore pressure over sigma_ref where the phase ends."""
        return float(self.excess_at(self.end if self.change is None else self.change[1]))

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref at times since the start of the phase."""
        return np.asarray(self.excess_at(self.when(t)[0]))

    def _at_start(self) -> Floats:
        return np.array([self.start.energy, self.start.excess])

    def _panel(self, left: float, half: float, values: Floats) -> tuple[Floats, Floats, Floats]:
        """As for E alone, for E and p together."""
        x = left + half * _Z
        mu, level = self.friction(x) + 0.0 * x, self.balance.values["level"]
        kappa, polar = self.balance.values["kappa"], self._dynamic
        stress = self.balance.get("effective_stress", press=self.press(x), omega_2=0.0, excess=0.0)
        known = values - np.array([0.0, self.start.excess])
        # Of E' and p': what is known, and what E and p do to them.
        right = np.concatenate([2 * super().driving(x) - 2 * self.braking(x) * known[0] + 2 * mu * level * known[1],
                                kappa * mu * (stress + polar * values[0] - values[1])])  # fmt: skip
        gain = half * _Z[:, None] * _MEAN
        matrix = np.block([
            [2 * self.braking(x)[:, None] * gain, -2 * (mu * level)[:, None] * gain],
            [-(kappa * mu * polar)[:, None] * gain, (kappa * mu)[:, None] * gain],
        ])  # fmt: skip
        matrix[np.diag_indices(2 * NODES)] += 1.0
        rates = np.linalg.solve(matrix, right).reshape(2, NODES)
        terms = np.array([2 * np.abs(super().driving(x)).max(), (kappa * mu * np.abs(stress)).max()])
        sizes = np.maximum(np.maximum(np.abs(rates).max(axis=1), terms), 1e-300)
        return rates, sizes, self._slopes(left, values)

    def _slopes(self, left: float, values: Floats) -> Floats:
        """E' and p' where a panel begins."""
        x = np.array([left])
        mu, level = float((self.friction(x) + 0.0 * x)[0]), self.balance.values["level"]
        drive = float(super().driving(x)[0]) + mu * level * (values[1] - self.start.excess)
        stress = self.balance.get("effective_stress", press=self.press(x), omega_2=values[0], excess=values[1])
        heat = self.balance.values["kappa"] * mu * float(stress[0])
        return np.array([2 * (drive - float(self.braking(x)[0]) * values[0]), heat])

    @property
    def _dynamic(self) -> float:
        """What E adds to the effective stress."""
        still = {"press": 0.0, "excess": 0.0}
        get = self.balance.get
        return float(get("effective_stress", **still, omega_2=1.0) - get("effective_stress", **still, omega_2=0.0))

    def _keep(self, edges: Floats, known: list[tuple[Floats, Floats]]) -> None:
        super()._keep(edges, known)
        self.excess_at = energy_on_panels(edges, *of_row(known, 1))[0]
