"""Lift-off and landing within a phase in which nothing depends on time."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.checks import EPS
from slipcircle.methods.roots import highest, root

if TYPE_CHECKING:
    from slipcircle.methods.frozen import Frozen
    from slipcircle.methods.phaseplane import Course
    from slipcircle.motion import Start

Floats = NDArray[np.float64]


def change(solved: "Course | Frozen") -> tuple[float, float, float] | None:
    """Time, x and E at which the mass lifts off or lands, if it does before the phase ends; only water can carry it."""
    balance, heats = solved.balance, solved.balance.has("pressurisation")
    if not balance.lightened:
        return None
    if balance.get("normal", press=0.0) == 0.0 and not heats:  # no water that could carry the mass
        return None
    water = abs(balance.get("effective_stress", press=0.0, omega_2=0.0))
    water += abs(balance.get("normal_stress", press=solved.at["press"], omega_2=0.0)) if heats else 0.0
    last, sign = solved.last, 1.0 if solved.start.lifted else -1.0

    def over(s: Any) -> Any:
        x, energy = solved.passing(s)
        # Strong friction may hold the mass where what presses is rounding: that is neither lift-off nor landing.
        return sign * solved.pressing(x, energy) - 4 * EPS * (np.abs(solved.pressing(x, 0.0)) + water)

    def at(s: float) -> float:
        return float(over(np.array([s]))[0])

    places = last * np.sin(np.linspace(0.0, np.pi / 2, 65)) ** 2
    found = over(places).tolist()
    for k in range(1, len(places)):
        low, high, at_high = float(places[k - 1]), float(places[k]), found[k]
        summit = k + 1 < len(places) and found[k - 1] < found[k] >= found[k + 1]
        if summit and 0.0 <= -found[k] < found[k] - min(found[k - 1], found[k + 1]):  # perhaps there and back between
            high = highest(at, low, float(places[k + 1]))
            at_high = at(high)
        if at_high <= 0.0:
            continue
        while (at_low := at(low)) >= 0.0 and high > 1e-15 * last:  # zero, to rounding, at the start
            low = high / 2
            if at(low) >= 0.0:  # also where nothing presses exactly there, or neither bound would move
                high, at_high = low, at(low)
        s = np.array([root(at, low, high, at_low, at_high) if at_low < 0.0 else high])
        x, energy = solved.passing(s)
        return float(solved.passed(s)[0]), float(x[0]), float(energy[0])
    return None


class EndsAtLiftOff:
    """What phases share in which nothing depends on time, and whose pore pressure stays as it was at their start."""

    start: "Start"

    @cached_property
    def change(self: "Course | Frozen") -> tuple[float, float, float] | None:  # type: ignore[misc]
        """Time, x and E at which the mass lifts off or lands before the phase ends."""
        return change(self)

    @property
    def excess(self) -> float:
        """Excess pore pressure over sigma_ref at its end."""
        return self.start.excess

    @property
    def lifts(self) -> tuple[float, ...]:
        """Times within the phase at which the mass lifts off; where it does, the phase ends."""
        return ()

    def excess_when(self, t: Floats) -> Floats:
        """Excess pore pressure over sigma_ref at times since the start of the phase."""
        return np.full_like(t, self.start.excess)
