"""One phase of motion with frozen geometry and constant friction: the paper's closed form in time (3.20), (4.3)."""

import math
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import motion as formulas
from slipcircle.balance import Balance
from slipcircle.chebyshev import Piecewise, accumulate, resolve
from slipcircle.friction import Friction
from slipcircle.phaseplane import Start, scalar

Floats = NDArray[np.float64]


class Frozen:
    """A phase with d(omega)/dt = a - b omega**2; the same faces as `slipcircle.phaseplane.Course`."""

    def __init__(self, balance: Balance, law: Friction, start: Start, longest: float) -> None:
        self.balance, self.start, self.longest = balance, start, longest
        self.at = balance.position(start.rotation, start.direction)
        self.mu = 0.0 if start.lifted else float(law.coefficient(start.slip))
        self.a = balance.drive(self.at, self.mu)
        self.omega_0 = math.sqrt(start.energy)
        braked = balance.has("brake")
        self.prefix = "frozen_centripetal" if braked else "frozen"
        self.coefficients = (self.a, float(balance.get("brake", mu=self.mu))) if braked else (self.a,)
        self.stops = self.a < 0.0
        self.duration = float(self._formula("arrest_time")) if self.stops else math.inf
        self.end = float(self._formula("arrest_rotation")) if self.stops else math.inf

    def _formula(self, name: str, *t: Any) -> Any:
        """A formula of the motion; its bare text on plain floats, where the arguments are known to be good."""
        bare = not t or isinstance(t[0], float)
        function = getattr(formulas, f"{'_' if bare else ''}{self.prefix}_{name}")
        return (scalar(function) if bare else function)(*self.coefficients, self.omega_0, *t)

    def fastest(self) -> tuple[float, float, float, float]:
        """Time, x, omega and d(omega)/dt at the greatest speed, which is monotone: at the start or the longest time."""
        b = (*self.coefficients, 0.0)[1]
        t = 0.0 if self.a <= b * self.start.energy or math.isinf(self.longest) else self.longest
        return t, *self.state(t)

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        x, omega, rate = (self._formula(n, t) for n in ("rotation", "angular_velocity", "angular_acceleration"))
        return float(x), float(omega), float(rate)

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        return (
            self._formula("rotation", t),
            self._formula("angular_velocity", t),
            self._formula("angular_acceleration", t),
        )

    def press(self, x: Any) -> Any:
        """J_r/Theta*, frozen."""
        return self.at["press"] + 0.0 * x

    def pressing(self, x: Any, energy: Any) -> Any:
        """The effective mean normal stress over sigma_ref."""
        return self.balance.get("effective_stress", press=self.press(x), omega_2=energy)

    def work(self, x: Any) -> Any:
        """Work of gravity over Theta*, from the start of the phase."""
        return self.at["fall"] * x

    def _loss(self, t: Floats) -> Floats:
        omega = np.asarray(self._formula("angular_velocity", t))
        return np.asarray(self.balance.get("resistance", mu=self.mu, press=self.at["press"], omega_2=omega**2) * omega)

    @cached_property
    def _losses(self) -> Piecewise:
        last = min(self.duration, self.longest)
        b = (*self.coefficients, 0.0)[1]
        pace = math.sqrt(abs(self.a) * b) + b * self.omega_0  # of change, at first
        steps = [2.0**k / pace for k in range(80) if 2.0**k / pace < last] if pace > 0.0 else []
        return resolve(self._loss, np.array([0.0, *steps, last]), 4e-15).integral()

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return accumulate(self._loss, self._losses, t)
