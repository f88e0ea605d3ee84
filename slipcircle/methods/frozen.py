"""One phase of motion with frozen geometry and constant friction: the paper's closed form in time (3.20), (4.3)."""

import math
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated import motion as formulas
from slipcircle.balance import Balance
from slipcircle.friction import Friction
from slipcircle.methods.chebyshev import Piecewise, accumulate, resolve
from slipcircle.methods.liftoff import EndsAtLiftOff
from slipcircle.methods.roots import scalar

if TYPE_CHECKING:
    from slipcircle.motion import Start

Floats = NDArray[np.float64]


class Frozen(EndsAtLiftOff):
    """A phase with d(omega)/dt = a - b omega**2; the same faces as `slipcircle.methods.phaseplane.Course`."""

    def __init__(self, balance: Balance, law: Friction, start: "Start", longest: float) -> None:
        self.balance, self.start, self.longest = balance, start, longest
        self.at = balance.position(start.rotation, start.direction)
        self.mu = 0.0 if start.lifted else float(law.coefficient(start.slip))
        self.a = balance.drive(self.at, self.mu)
        self.omega_0 = math.sqrt(start.energy)
        braked = balance.has("brake")
        prefix = "frozen_centripetal" if braked else "frozen"
        self.b = float(balance.get("brake", mu=self.mu))
        self.coefficients: tuple[float, ...] = (self.a, self.b, self.omega_0) if braked else (self.a, self.omega_0)
        self._state: Any = functions.frozen_braked_state if braked else functions.frozen_state
        self.stops = self.a < 0.0
        self.duration = self.end = math.inf
        if self.stops:
            arrest_time, arrest_rotation = (getattr(formulas, f"_{prefix}_arrest_{n}") for n in ("time", "rotation"))
            self.duration = float(scalar(arrest_time)(*self.coefficients))
            self.end = float(scalar(arrest_rotation)(*self.coefficients))

    def fastest(self) -> tuple[float, float, float, float] | None:
        """Time, x, omega and d(omega)/dt at the greatest speed, at the start, as it is monotone; None if at the end."""
        falls = self.a <= self.b * self.start.energy
        return (0.0, *self.state(0.0)) if falls else None

    def state(self, t: float) -> tuple[float, float, float]:
        """x, omega and d(omega)/dt at one time."""
        x, omega, rate = scalar(self._state)(*self.coefficients, t)
        return float(x), float(omega), float(rate)

    def when(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """x, omega and d(omega)/dt at times since the start of the phase."""
        x, omega, rate = self._state(*self.coefficients, t)
        return x, omega, rate

    @property
    def last(self) -> float:
        """Time at the end of the phase, or the longest; the phase plane has another variable in time's place.

        Where there is neither, late enough for all speeds.
        """
        return min(self.duration, self.longest, 1e30)

    def passing(self, t: Floats) -> tuple[Floats, Floats]:
        """x and E = omega**2."""
        x, omega, _ = self.when(t)
        return x, omega**2

    def passed(self, t: Floats) -> Floats:
        """The time since the start of the phase."""
        return t

    def press(self, x: Any) -> Any:
        """J_r/Theta*, frozen."""
        return self.at["press"] + 0.0 * x

    def pressing(self, x: Any, energy: Any) -> Any:
        """The effective mean normal stress over sigma_ref."""
        return self.balance.get("effective_stress", press=self.press(x), omega_2=energy)

    def worked(self, t: Floats) -> Floats:
        """Work of gravity over Theta* at times since the start of the phase."""
        return np.asarray(self.work(self.when(t)[0]))

    def work(self, x: Any) -> Any:
        """Work of gravity over Theta*, from the start of the phase."""
        return self.at["fall"] * x

    def _loss(self, t: Floats) -> Floats:
        omega = np.asarray(self.when(t)[1])
        return np.asarray(self.balance.get("resistance", mu=self.mu, press=self.at["press"], omega_2=omega**2) * omega)

    @cached_property
    def _losses(self) -> Piecewise:
        last, b = self.last, self.b
        pace = math.sqrt(abs(self.a) * b) + b * self.omega_0  # of change, at first
        steps = [2.0**k / pace for k in range(80) if 2.0**k / pace < last] if pace > 0.0 else []
        return resolve(self._loss, np.array([0.0, *steps, last]), 4e-15).integral()

    def dissipated(self, t: Floats) -> Floats:
        """Energy over Theta* that the resistance has taken since the start, by quadrature of its own."""
        return accumulate(self._loss, self._losses, t)
