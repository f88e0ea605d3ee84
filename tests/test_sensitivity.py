"""Exact sensitivities: proofs, and generated slopes in many digits; whole motions: `test_derivatives`."""

import math
import re
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from derive.algebra import integrate
from derive.algebra import sensitivity as derived
from derive.code import functions
from derive.declare.quantities import MOMENTS
from generated import sensitivity as slopes

ULP = 2.0**-52

# --- what is generated ---------------------------------------------------------------------------------------------


def test_every_slope_is_proved() -> None:
    assert len(derived.prove_energy_slopes()) == 10
    assert len(derived.prove_frozen_slopes()) == 13
    assert len(derived.prove_energy_growth()) == 3
    closed = functions.closed_amplitudes([integrate.derive(m) for m in MOMENTS])
    assert len(derived.prove_arc_growth(closed)) == len(closed)


def energy(*at: Any) -> Any:
    """E at x, textbook form."""
    x, start, drive, tilt, constant, brake = at
    q = 2 * brake
    fade = mpmath.exp(-q * x)
    with_cos = (q * mpmath.cos(x) + mpmath.sin(x) - q * fade) / (1 + q * q)
    with_sin = (q * mpmath.sin(x) - mpmath.cos(x) + fade) / (1 + q * q)
    return start * fade + 2 * (drive * with_cos - tilt * with_sin - constant * ((1 - fade) / q - with_cos))


def velocity(*at: Any) -> tuple[Any, Any]:
    """Rotation and angular velocity of the frozen slide, textbook form."""
    a, b, omega_0, t = at
    k = mpmath.sqrt(mpmath.mpc(a * b))
    y = mpmath.re(mpmath.cosh(k * t) + b * omega_0 * mpmath.sinh(k * t) / k)
    return mpmath.log(y) / b, mpmath.re(omega_0 * mpmath.cosh(k * t) + a * mpmath.sinh(k * t) / k) / y


def central(function: Any, x: float) -> Any:
    """A derivative to some 50 digits."""
    step = mpf(10) ** -30 * (abs(mpf(x)) or 1)
    return (function(mpf(x) + step) - function(mpf(x) - step)) / (2 * step)


def check_energy(module: ModuleType) -> None:
    """Each derivative of E relatively, from the shortest motions to half a turn, and for any brake."""
    rng = np.random.default_rng(5)
    with mpmath.workdps(130):
        for _ in range(250):
            x, brake = 10 ** rng.uniform(-9.0, 0.49), 10 ** rng.uniform(-8.0, 5.0)
            if rng.random() < 0.2:  # backwards from a standstill
                brake = -min(brake, 0.5 / x)
            for k in range(1, 4):
                only = [0.0] * 4
                only[k] = 1.0
                found = module.energy_slopes(x, *only, brake)
                exact = energy(mpf(x), *only, mpf(brake))
                assert abs(found[k] - exact) <= 128 * ULP * abs(exact), (k, x, brake)
                exact = central(lambda b, x=x, only=only: energy(mpf(x), *only, b), brake)
                assert abs(found[4] - exact) <= 512 * ULP * abs(exact), (k, x, brake)


def check_frozen(module: ModuleType) -> None:
    """Derivatives of rotation and angular velocity by a, b and omega_0, up to the standstill."""
    rng = np.random.default_rng(6)
    with mpmath.workdps(110):
        for _ in range(300):
            a, b, omega_0 = 10 ** rng.uniform(-6.0, 3.0), 10 ** rng.uniform(-6.0, 3.0), 10 ** rng.uniform(-4.0, 2.0)
            t = 10 ** rng.uniform(-5.0, 3.0)
            if rng.random() < 0.4:
                t = min(t, math.atan(omega_0 * math.sqrt(b / a)) / math.sqrt(a * b))
                a = -a
            at = tuple(map(mpf, (a, b, omega_0, t)))
            found = module.frozen_slopes(a, b, omega_0, t)
            for k in range(3):
                for way in range(2):
                    if not (k == 2 and way == 1 and math.sqrt(abs(a * b)) * t > 60.0):  # exp(-2kt)
                        exact = central(lambda v, k=k, at=at, way=way: velocity(*at[:k], v, *at[k + 1 :])[way], at[k])
                        assert abs(found[3 * way + k] - exact) <= 128 * ULP * abs(exact), (k, way, at)


def test_energy_slopes() -> None:
    check_energy(slopes)


def test_frozen_slopes() -> None:
    check_frozen(slopes)


def test_arc_growth() -> None:
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
            found = slopes.arc_growth(alpha)
            for k in range(5):
                exact = central(lambda v, k=k: quotients(v)[k], alpha) * (alpha if k == 4 else 1)
                # C_r/Theta* is greatest at 1.34, where its slope is zero.
                assert abs(found[k] - exact) <= 64 * ULP * max(abs(exact), 0.01 * min(alpha, 1.0)), (k, alpha)
    assert np.all(np.isfinite([slopes.arc_growth(x) for x in (0.0, 1e-200, math.pi / 2, math.pi / 2 * (1 + ULP))]))


@pytest.mark.parametrize(
    ("pattern", "replacement", "check"),
    [
        (r"0\.3333333333333333\)", "0.3333333333333)", check_frozen),  # (cosh k - sinh(k)/k)/k**2 at 0
        (r"-0\.75\)", "-0.7500000001)", check_frozen),  # the slope of log(1 + x)/x
        (r"-0\.016666666666666666\)", "-0.0166666667)", check_energy),  # a remainder of exp(-x)
        (r"(v\d+) < 1\.0$", r"\1 < 0.0", check_energy),  # a seam out of place
    ],
)
def test_a_planted_bug_turns_a_check_red(pattern: str, replacement: str, check: Any) -> None:
    source = Path(str(slopes.__file__)).read_text("utf-8")
    start = source.index(f"def {check.__name__.removeprefix('check_')}_slopes(")
    end = (source + "\n\n\ndef ").index("\n\n\ndef ", start)
    text, count = re.subn(pattern, replacement, source[start:end], flags=re.M)
    assert count
    bugged = ModuleType("bugged")
    exec(source[:start] + text + source[end:], bugged.__dict__)
    with pytest.raises(AssertionError):
        check(bugged)
