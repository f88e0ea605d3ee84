"""Lift-off and landing within a phase in which nothing depends on time."""

from typing import TYPE_CHECKING

import numpy as np

from slipcircle.roots import highest, root

if TYPE_CHECKING:
    from slipcircle.frozen import Frozen
    from slipcircle.phaseplane import Course


def change(solved: "Course | Frozen") -> tuple[float, float, float] | None:
    """Time, x and E at which the mass lifts off or lands, if it does before the phase ends; only water can carry it."""
    balance = solved.balance
    if balance.get("normal", press=0.0) == 0.0 and not balance.has("pressurisation"):  # no water that could carry it
        return None
    last = min(solved.duration, solved.longest)

    def pressing(t: float) -> float:
        x, omega, _ = solved.when(np.array([t]))
        return float(solved.pressing(x, omega**2)[0])

    times = last * np.sin(np.linspace(0.0, np.pi / 2, 65)) ** 2
    x, omega, _ = solved.when(times)
    sign = 1.0 if solved.start.lifted else -1.0
    over = sign * solved.pressing(x, omega**2)
    for k in range(1, len(times)):
        low, high, at_high = float(times[k - 1]), float(times[k]), float(over[k])
        summit = k + 1 < len(times) and over[k - 1] < over[k] >= over[k + 1]
        if summit and 0.0 <= -over[k] < over[k] - min(over[k - 1], over[k + 1]):  # perhaps there and back in between
            high = highest(lambda t: sign * pressing(t), low, float(times[k + 1]))
            at_high = sign * pressing(high)
        if at_high <= 0.0:
            continue
        while (at_low := sign * pressing(low)) >= 0.0 and high > 1e-15 * last:  # zero, to rounding, at the start
            low = high / 2
            if sign * pressing(low) >= 0.0:  # also where nothing presses exactly there, or neither bound would move
                high, at_high = low, sign * pressing(low)
        t = root(lambda t: sign * pressing(t), low, high, at_low, at_high) if at_low < 0.0 else high
        x, omega, _ = solved.when(np.array([t]))
        return t, float(x[0]), float(omega[0]) ** 2
    return None
