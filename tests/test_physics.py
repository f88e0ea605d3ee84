"""The physics of rest, of pendulums and of short flights.

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


@pytest.mark.parametrize("seed", range(2))
def test_rest_and_the_printed_limit_agree_to_the_last_bit(seed: int) -> None:
    """Decision from rest and printed limit agree for every combination of position and velocity terms, on any arc."""
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
    assert motion.duration == pytest.approx(float(duration), rel=2e-14)
    assert motion.run_out == pytest.approx(float(4 * half * m["radius"]), rel=2e-14)
    assert abs(motion.peak.velocity) == pytest.approx(float(peak), rel=2e-14)


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
