"""One phase of motion under undrained-adiabatic thermal pressurisation, in the phase plane.

While friction depends on the slip at most, E and the excess pore pressure p obey a linear system in the rotation x:
E' = 2 (drive + mu lambda p - brake E) and p' = kappa mu (sigma' without p - p), solved by collocation as E alone is.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.methods.collocation import Panels, over_panels
from slipcircle.methods.phaseplane import Course

Floats = NDArray[np.float64]


class Heated(Course):
    """A phase in which friction heats the slip surface; see `slipcircle.methods.phaseplane.Course`.

    ``excess_at`` is the excess pore pressure over sigma_ref at a rotation.
    """

    def driving(self, x: Any) -> Any:
        """The drive at x, with the pressure there."""
        return self._pressed(x)[0]

    def slope(self, x: Any, energy: Any) -> Any:
        """E' = 2 (drive - brake E)."""
        driving, mu = self._pressed(x)
        return 2 * (driving - self._brake(mu) * energy)

    def _pressed(self, x: Any) -> tuple[Any, Any]:
        driving, mu = self.along(x)
        return driving + mu * self.balance.values["level"] * (self.excess_at(x) - self.start.excess), mu

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

    def _begin(self) -> Floats:
        return np.array([self.start.energy, self.start.excess])

    def _equation(self, x: Floats) -> tuple[Floats, Floats]:
        """Right side and matrix of (E', p') = right - matrix (E, p), for collocation."""
        level, kappa = self.balance.values["level"], self.balance.values["kappa"]
        driving, mu = self.along(x)
        dry = {"press": self.press(x), "excess": 0.0}
        still, moving = (self.balance.get("effective_stress", **dry, omega_2=e) for e in (0.0, 1.0))
        right = np.array([2 * (driving - mu * level * self.start.excess), kappa * mu * still])
        rows = [[2 * self._brake(mu), -2 * mu * level], [-kappa * mu * (moving - still), kappa * mu]]
        return right, np.array([[a + 0.0 * x for a in row] for row in rows])

    def _keep(self, found: Panels) -> None:
        super()._keep(found)
        self.excess_at = over_panels(found.edges, found.values[:-1, 1], found.means[:, 1].T)
