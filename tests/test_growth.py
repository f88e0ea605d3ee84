"""How the moments of an arc grow with its half angle: proved, and in many digits."""

import math
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from derive.algebra import integrate
from derive.algebra.rules import prove_arc_growth
from generated import growth

ULP = 2.0**-52


def test_every_slope_is_proved() -> None:
    closed = integrate.closed_forms()
    assert len(prove_arc_growth(closed)) == len(closed)


def central(function: Any, x: float) -> Any:
    """A derivative to some 50 digits."""
    step = mpf(10) ** -30 * (abs(mpf(x)) or 1)
    return (function(mpf(x) + step) - function(mpf(x) - step)) / (2 * step)


def test_arc_growth() -> None:
    """Against the closed forms, differentiated in many digits, from thin arcs to half discs."""

    def quotients(alpha: Any) -> list[Any]:
        sine, cosine = mpmath.sin(alpha), mpmath.cos(alpha)
        radial = sine - cosine**2 * mpmath.atanh(sine)
        turn = 2 * alpha - mpmath.sin(2 * alpha)
        inertia = turn / 4 + sine**3 * cosine / 3
        forms = [2 * sine**3 / 3, radial, turn / 3 + cosine * radial / 3, 2 * alpha * (1 - cosine)]
        return [*(mpmath.log(f / inertia) for f in forms), mpmath.log(inertia)]

    rng = np.random.default_rng(7)
    with mpmath.workdps(150):
        for _ in range(120):
            alpha = (
                10 ** rng.uniform(-8.0, 0.19) if rng.random() < 0.6 else math.pi / 2 - 10 ** rng.uniform(-12.0, -1.0)
            )
            found = growth.arc_growth(alpha)
            for k in range(5):
                exact = central(lambda v, k=k: quotients(v)[k], alpha) * (alpha if k == 4 else 1)
                # C_r/Theta* is greatest at 1.34, where its slope is zero.
                assert abs(found[k] - exact) <= 64 * ULP * max(abs(exact), 0.01 * min(alpha, 1.0)), (k, alpha)
    assert np.all(np.isfinite([growth.arc_growth(x) for x in (0.0, 1e-200, math.pi / 2, math.pi / 2 * (1 + ULP))]))
