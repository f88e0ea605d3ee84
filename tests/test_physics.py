"""The physics of rest, pendulums and blocks: closed forms, limits and symmetries.

Coefficients are those of `oracle`, from quadrature of the raw definitions. Every combination of effects beside exact
solutions is `test_combinations`'.
"""

import math
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from flint import ctx

from slipcircle import Arc, Scene, solve
from tests.support import combinations, golden, oracle, taylor
from tests.support.motions import residual


@pytest.mark.parametrize("seed", range(2))
def test_rest_and_the_printed_limit_agree_to_the_last_bit(seed: int) -> None:
    """From rest, every combination of what depends on position and speed, on any arc."""
    for effects in combinations.STEADY:
        given = combinations.drawn(effects, "constant", 100 + seed)
        if "time" in given["effects"].get("pore_pressure", {}):
            continue  # it may move later
        scene = golden.built("", given | {"initial_velocity": 0.0, "end_time": 1.0})
        limit = solve(scene).limit_friction
        if not 0.0 < limit < np.inf:  # cohesion holds it without friction, or water carries it
            assert solve(scene).moves == (limit > 0.0)
            continue
        for mu, moves in ((limit, False), (np.nextafter(limit, np.inf), False), (np.nextafter(limit, 0.0), True)):
            motion = solve(replace(scene, friction=float(mu)))
            assert motion.moves == moves, scene
            assert motion.limit_friction == limit
            assert motion.factor_of_safety == pytest.approx(1.0, abs=1e-14)
            assert abs(motion.yield_coefficient) < 1e-14
            assert (motion.yield_coefficient < 0.0) == moves
            if not moves:
                assert (motion.arrested, motion.duration, motion.run_out) == (True, 0.0, 0.0)


def dipping(dip: float, half: float, radius: float = 300.0) -> Arc:
    middle = 1.5 * np.pi - dip
    return Arc(radius, middle - half, middle + half, 21e3)


DIPS = (1e-6, 1e-3, 0.1, 0.5, 1.0, 1.3, 1.57)


@pytest.mark.parametrize("half", [1e-6, 0.01, 0.54, 1.5])
@pytest.mark.parametrize("dip", [*DIPS, -0.7])
def test_without_friction_it_is_a_pendulum(dip: float, half: float) -> None:
    """Half a period of the pendulum of length Theta*/C_theta, by the elliptic integral; to the mirrored dip."""
    arc = dipping(dip, half)
    motion, m = solve(Scene(arc, 0.0, ("rotation",))), oracle.numbers(arc)
    with mpmath.workdps(40):
        half, rate = m["dip"] / 2, mpmath.sqrt(m["fall"]) / m["scale"]
        duration = 2 * mpmath.ellipk(mpmath.sin(half) ** 2) / rate
        peak = 2 * rate * mpmath.sin(half) * m["radius"]
    assert not motion.arrested
    assert motion.duration == pytest.approx(float(duration), rel=2e-14)
    assert motion.run_out == pytest.approx(float(4 * half * m["radius"]), rel=2e-14)
    assert abs(motion.peak.velocity) == pytest.approx(float(peak), rel=2e-14)
    assert motion.peak.displacement == pytest.approx(motion.run_out / 2, rel=1e-7)
    assert residual(motion) < 1e-13


@pytest.mark.parametrize("half", [1e-3, 1e-5, 1e-7])
def test_a_thin_arc_is_a_block_on_an_incline(half: float) -> None:
    """From the definitions, as alpha -> 0: all of the mass at r = 1, its mean thickness alpha**2 R/3, its slope psi.

    dv/dt = g sin psi - mu (g cos psi - p/(rho h)) - c/(rho h) - g v**2/(xi h), to O(alpha**2).
    """
    gravity, mu, time = 9.81, 0.2, 12.0
    arc = dipping(0.5, half, 1e4 / half**2)
    alpha, dip = float(np.subtract(arc.theta_2, arc.theta_1)) / 2, float(arc.dip)  # as rounded
    thickness = alpha**2 * float(arc.radius) / 3
    weight = float(arc.unit_weight) * thickness
    effects = {
        "pore_pressure": {"pressure": 0.3 * weight},
        "cohesion": {"cohesion": 0.02 * weight},
        "drag": {"xi": 800.0},
    }
    a = gravity * (math.sin(dip) - mu * (math.cos(dip) - 0.3) - 0.02)
    b = gravity / (800.0 * thickness)
    motion = solve(Scene(arc, mu, effects, end_time=time))
    tolerance = 2 * half**2 + 1e-9
    rate = math.sqrt(a * b)
    assert motion.end.velocity == pytest.approx(math.sqrt(a / b) * math.tanh(rate * time), rel=tolerance)
    assert motion.run_out == pytest.approx(math.log(math.cosh(rate * time)) / b, rel=tolerance)
    deceleration = gravity * (1.5 * math.cos(dip) - math.sin(dip))
    # Curvature adds v**2/R, and turns the slope by s/R: little, on such a radius.
    for brakes, more in (((), 0.0), (("rotation", "centripetal"), 1e-2 * half**2)):
        braked = solve(Scene(arc, 1.5, brakes, initial_velocity=20.0))
        assert braked.run_out == pytest.approx(20.0**2 / (2 * deceleration), rel=tolerance + more)
        assert braked.duration == pytest.approx(20.0 / deceleration, rel=tolerance + more)


def test_a_short_flight_between_samples_is_found() -> None:
    """Water lifts the mass only where it turns up-slope, for a moment that is as short as one likes."""
    ends = {f"theta_{k}": 1.5 * math.pi - 0.3 + side * 0.5 for k, side in ((1, -1), (2, 1))}
    given = golden.scene(0.0, {"rotation": {}}, 30.0, 6.0, radius=300.0, unit_weight=21e3, **ends)
    base = golden.built("", given)
    static = float(base.arc.static_normal_stress)
    lowest = float(np.cos(np.max(np.abs(0.3 - solve(base).at(np.linspace(0, 6, 4001)).rotation))) / np.cos(0.3))
    for above in (1e-2, 1e-4, 1e-6):
        wet = given | {"effects": {"rotation": {}, "pore_pressure": {"pressure": static * lowest * (1 + above)}}}
        ctx.prec = 160
        exact = taylor.Solution(taylor.Problem(wet), 26, 22)
        motion = solve(golden.built("", wet))
        assert len(motion.lift_off) == len(exact.lifts) >= 1
        np.testing.assert_allclose(motion.lift_off, [float(t * exact.p.scale) for t in exact.lifts], rtol=1e-9)
