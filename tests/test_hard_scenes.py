"""Hard scenes, in which a straightforward solver loses its digits, its way, or its patience.

The answers are Taylor series in ball arithmetic (`tests.support.taylor`). Where these would take a million steps, at a
steady speed or under a strong brake, the answers are closed forms of the balance in 60 digits.
"""

import itertools
import json
import math
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import ctx
from mpmath import mpf

from generated import kernels
from slipcircle import Arc, Motion, Scene, solve
from tests.support import accuracy, golden, oracle, taylor
from tests.support.lanes import BACKENDS, backend
from tests.support.motions import finite

TURNING: dict[str, Any] = {"rotation": {}}


def arc(dip_deg: float, half: float) -> dict[str, Any]:
    middle = 1.5 * math.pi - math.radians(dip_deg)
    return {"radius": 1500.0, "theta_1": middle - half, "theta_2": middle + half, "unit_weight": 20e3, "gravity": 9.81}


SLOPE = arc(25.0, 0.5)


# For each scene why it is hard, its data, a tolerance other than `TOLERANCE`, and the first word of its error, if it is
# to be refused. With "ulps", friction is so many units in the last place above the printed limit friction.
CASES: dict[str, Any] = json.loads(Path(__file__).with_name("support").joinpath("hard_scenes.json").read_text("utf-8"))
TOLERANCE = 1e-12


def data_of(case: Mapping[str, Any]) -> golden.Data:
    """Return the data of the scene of a case."""
    scene = dict(case["scene"])
    if "ulps" in case:
        limit = abs(float(Arc(**scene["arc"]).dimensionless.limit_friction))
        scene["friction"] = limit + case["ulps"] * float(np.spacing(limit))
    return scene


@cache
def answer(name: str) -> tuple[bool, tuple[mpf, ...]]:
    """Whether it comes to rest; run-out in m, duration in s and greatest speed in m/s."""
    case = CASES[name]
    if name == "floats":  # nothing presses anywhere
        return answer("no friction")
    if name in ("thirty years, frozen", "thirty years, hyperbolic, terminal"):  # at its terminal velocity
        m = oracle.numbers(Arc(**SLOPE))
        brake, time = mpf(0.2) * m["polar"], mpf(1e9) / m["scale"]
        rate = mpmath.sqrt(brake * (m["fall"] * mpmath.sin(m["dip"]) - mpf(0.2) * m["press"] * mpmath.cos(m["dip"])))
        turned, omega = mpmath.log(mpmath.cosh(rate * time)) / brake, rate / brake * mpmath.tanh(rate * time)
        return False, (turned * m["radius"], mpf(1e9), omega * m["radius"] / m["scale"])
    found = taylor.solve(data_of(case))
    return found["arrested"], tuple(mpf(found[n]) for n in ("run_out", "duration", "peak_velocity"))


@pytest.mark.parametrize(
    ("name", "integrator"),
    [(name, x) for k, name in enumerate(CASES) for x in BACKENDS if x == BACKENDS[0] or k % 8 == 5],
)
def test_hard_scene(name: str, integrator: str) -> None:
    with backend(integrator):
        answered(name)


def answered(name: str) -> None:
    """Return the right answer, within its tolerance; or the right refusal."""
    case = CASES[name]
    scene = golden.built(name, data_of(case))
    if "says" in case:
        with pytest.raises(ValueError, match=f"^{case['says']}( =|:)"):
            solve(scene)
        return
    motion = solve(scene)
    finite(motion)
    with mpmath.workdps(60):
        rests, right = answer(name)
        assert (motion.arrested, motion.moves) == (rests, right[1] > 0)
        for found, exact in zip((motion.run_out, motion.duration, abs(motion.peak.velocity)), right, strict=True):
            error = abs(mpf(float(found)) - (exact if found == motion.run_out else abs(exact)))
            assert error <= case.get("tolerance", TOLERANCE) * abs(exact), (found, exact)


def test_ensemble_close_to_the_limit() -> None:
    """Protect the run-out 2 R (psi - delta) at distances from 1e-3 to an ulp, over friction and geometry."""
    near = np.array([1e-3, 1e-6, 1e-9, 1e-12, 2e-16])
    ends = np.array([[SLOPE["theta_1"]], [SLOPE["theta_1"] - 0.1]])
    limits = np.abs(kernels.limit_friction(ends, SLOPE["theta_2"]))
    motion = solve(Scene(Arc(**SLOPE | {"theta_1": ends}), limits * (1.0 - near), TURNING, accuracy=1e-13))
    for place in np.ndindex(motion.shape):
        with ctx.workprec(400):
            m = oracle.moments(SLOPE | {"theta_1": float(ends[place[0], 0])})
            mu = oracle.exact(float(limits[place[0], 0] * (1.0 - near[place[1]])))
            exact = float(2 * SLOPE["radius"] * (m["dip"] - (mu * m["press"] / m["fall"]).atan()))
        assert abs(motion.run_out[place] / exact - 1) <= 1e-12
        assert motion.error_estimate[place] < 1e-11


# --- friction that rises, or settles after much higher values --------------------------------------------------------


def tan(degrees: float) -> float:
    return math.tan(math.radians(degrees))


def scene(first: float, second: float, friction: Any, velocity: float = 0.0, end: float | None = None,
          effects: Mapping[str, Any] = TURNING) -> golden.Data:  # fmt: skip
    """Return a large arc between two angles in degrees."""
    arc = {"radius": 1000.0, "theta_1": math.radians(first), "theta_2": math.radians(second)}
    return golden.scene(friction, effects, velocity, end, **arc, unit_weight=2e4)


def table(*rows: tuple[float, float]) -> dict[str, Any]:
    slip, coefficient = zip(*rows, strict=True)
    return {"law": "tabulated", "slip": list(slip), "coefficient": list(coefficient)}


def strengthening(number: int) -> golden.Data:
    """Return a pushed mass whose friction grows from just below its limit; it is fastest just after its start."""
    rng = np.random.default_rng([20261121, number])
    first = rng.uniform(200.0, 235.0)
    second = first + rng.uniform(40.0, 70.0)
    m = oracle.moments(scene(first, second, 0.0)["arc"])
    limit = float(m["fall"] / m["press"] * m["dip"].tan())
    friction = {"law": ("linear", "linear", "hyperbolic")[number % 3],
                "peak": limit * (1 - 10 ** rng.uniform(-2.5, -0.7)),
                "residual": tan(rng.uniform(40.0, 60.0)), "length": float(10 ** rng.uniform(-2.5, -0.5))}  # fmt: skip
    return scene(first, second, friction, float(10 ** rng.uniform(-1.0, 0.3)))


SCENES: dict[str, golden.Data] = {
    "fastest just after its start": scene(
        229.0, 289.0, {"law": "linear", "peak": tan(10.4), "residual": tan(45.0), "length": 0.1}, 0.1
    ),
    "friction settles after a thousand millions": scene(240.0, 300.0, table((0.0, 1e9), (1e-9, 0.3)), 10.0),
    "friction settles after a peak of as much": scene(240.0, 300.0, table((0.0, 0.3), (1e-9, 1e9), (2e-9, 0.3)), 10.0),
    "friction settles after a smooth fall": scene(
        240.0, 300.0, {"law": "linear", "peak": 1e8, "residual": 0.25, "length": 1e-9}, 8.0
    ),
    **{f"strengthening {k}": strengthening(k) for k in (0, 1, 2, 5, 36)},
}


@pytest.mark.parametrize("name", SCENES)
def test_estimate_is_at_least_the_true_error(name: str) -> None:
    motion = solve(golden.built(name, SCENES[name]))
    assert isinstance(motion, Motion)
    wanted = taylor.solve(SCENES[name], [0.1, 0.4, 0.8])
    assert (motion.moves, motion.arrested) == (wanted["moves"], wanted["arrested"])
    error = max(accuracy.true_error(motion, wanted))
    assert error <= motion.error_estimate, f"{error:.1e} beside {motion.error_estimate:.1e}"
    assert motion.error_estimate < 1e-9


# --- in the phase plane ----------------------------------------------------------------------------------------------


def braked(given: golden.Data) -> tuple[mpf, mpf, mpf]:
    """Return run-out, duration and peak velocity of a mass under drag; E = omega^2 is elementary in the rotation x.

    E' + q E = 2 (fall sin(dip - x) - mu press cos(dip - x)), in digits enough for E near its zeros.
    """
    with ctx.workprec(260):
        p = taylor.Problem(given)
        numbers = (p.fall, p.press, p.polar, p.drag, p.dip, p.omega, p.scale)
        fall, press, polar, drag, dip, omega, scale = (mpf(x.mid().str(70, radius=False)) for x in numbers)
    mu, radius = mpf(given["friction"]), mpf(given["arc"]["radius"])
    q = 2 * (mu * polar + drag)

    def forced(x: mpf) -> mpf:
        across, along = mpmath.sin(dip - x), mpmath.cos(dip - x)
        return 2 * (fall * (q * across + along) - mu * press * (q * along - across)) / (q * q + 1)

    def energy(x: mpf) -> mpf:
        return forced(x) + (omega**2 - forced(mpf(0))) * mpmath.exp(-q * x)

    def slope(x: mpf) -> mpf:
        return 2 * (fall * mpmath.sin(dip - x) - mu * press * mpmath.cos(dip - x)) - q * energy(x)

    def root(f: Callable[[mpf], mpf], low: mpf, high: mpf) -> mpf:
        return mpmath.findroot(f, (low, high), solver="bisect", maxsteps=220, verify=False)

    fastest = root(slope, mpf(0), 80 / q)
    end = root(energy, 2 * fastest + mpf(10) ** -40, mpf(2))
    crowded = [mpf(0), *itertools.takewhile(lambda share: share < 0.5, (4**k / (16 + 16 * q * end) for k in range(99)))]
    inner = [mpmath.asin(mpmath.sqrt(share)) for share in crowded]  # x = end sin^2; E changes over 1/q at both ends
    edges = [*inner, *(mpmath.pi / 2 - s for s in reversed(inner))]
    duration = mpmath.quad(lambda s: end * mpmath.sin(2 * s) / mpmath.sqrt(energy(end * mpmath.sin(s) ** 2)), edges,
                           method="gauss-legendre", maxdegree=4)  # fmt: skip
    return end * radius, duration * scale, mpmath.sqrt(energy(fastest)) * radius / scale


BRAKES = {  # of what drag; how near, where not just within the estimate
    "strong": (scene(230.0, 280.0, 0.2, effects=TURNING | {"drag": {"xi": 1e-2}}), 1.0),
    "as strong as no soil has": (scene(243.0, 244.0, tan(12.0), effects=TURNING | {"drag": {"xi": 1e-3}}), 1.0),
    # The speed is held from the first micrometres on, and forgets nothing else.
    "steep": (golden.scene(0.3, TURNING | {"drag": {"xi": 1e-4}}, **arc(80.0, 0.3)), 1e-12),
    # E is rounded drive over brake, its slope nothing but rounding.
    "beyond reason": (golden.scene(0.2, TURNING | {"drag": {"xi": 1e-10}}, **SLOPE), 1e-9),
    # The start's speed is gone within a micrometre.
    "moving": (golden.scene(0.2, TURNING | {"drag": {"xi": 1e-4}}, 1.0, **SLOPE), 1e-11),
}


@pytest.mark.parametrize("name", BRAKES)
def test_a_drag_that_takes_up_the_drive(name: str) -> None:
    """Speed is the balance of drive and drag all the way."""
    given, nearest = BRAKES[name]
    motion = solve(golden.built(name, given))
    estimate = motion.error_estimate
    finite(motion)
    with mpmath.workdps(60):
        wanted = braked(given)
        assert motion.arrested
        for found, exact in zip((motion.run_out, motion.duration, float(motion.peak.velocity)), wanted, strict=True):
            error = float(abs(mpf(found) / exact - 1))
            assert error <= (estimate if nearest == 1.0 else nearest), f"{error:.1e} beside {estimate:.1e}"
