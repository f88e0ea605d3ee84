"""Motions of constant friction: ends, energy, times of states, the paper's slide, rest, pendulums, short flights."""

import math
from dataclasses import asdict, replace
from typing import Any

import mpmath
import numpy as np
import pytest

from slipcircle import Arc, Scene, Status, load, solve
from tests.support import combinations, golden, oracle, taylor
from tests.support.vaiont import ARC as VAIONT

BOTH = pytest.mark.parametrize("effects", [(), ("centripetal",)], ids=["without centripetal", "centripetal"])


def limit_friction(arc: Arc) -> float:
    return float(abs(arc.dimensionless.limit_friction))


@BOTH
def test_a_slide_that_never_rests_needs_an_end(effects: tuple[str, ...]) -> None:
    for mu, velocity in ((0.1, 0.0), (0.0, 0.0), (0.0, -3.0), (limit_friction(VAIONT), 5.0)):
        with pytest.raises(ValueError, match=r"^end_time: .*never rests.* give end_time in s$"):
            solve(Scene(VAIONT, mu, effects, velocity))
        for accuracy in (1e-6, 1e-9):
            together = solve(Scene(VAIONT, mu, effects, np.array([velocity, velocity])), accuracy)
            assert together.status.tolist() == [Status.ENDLESS] * 2


@pytest.mark.parametrize("shape", [(), (0,), (12, 1), (2, 2, 3)])
def test_times_of_any_shape(shape: tuple[int, ...]) -> None:
    motion = solve(load("vaiont-frozen"))
    times = np.linspace(0.0, 30.0, 12)[: math.prod(shape)]
    for name, values in asdict(motion.at(times.reshape(shape))).items():
        assert np.shape(values) == shape, name
        singles = [getattr(motion.at(t), name) for t in times.tolist()]
        np.testing.assert_allclose(np.ravel(values), singles, rtol=4e-16)
    assert motion.at([15.0, 30]).velocity.tolist() == [motion.at(15.0).velocity, motion.end.velocity]


@pytest.mark.parametrize(
    ("times", "said"),
    [
        (-1e-300, "times = -1e-300:"),
        ([1.0, -2.0], "times = -2:"),
        (np.nan, "times = nan:"),
        (np.inf, "times = inf:"),
        ("noon", "times = 'noon':"),
        (None, "times = None:"),
        (np.nextafter(30.0, 31.0), "times = 30.000000000000004: must be at most the scene's end_time, 30.0 s"),
        ([0.0, 31.0], "times = 31.0: must be at most the scene's end_time"),
    ],
)
def test_times_that_are_refused(times: Any, said: str) -> None:
    motion = solve(load("vaiont-frozen"))
    with pytest.raises(ValueError, match=r"^Motion.at: ") as caught:
        motion.at(times)
    assert said in str(caught.value)


def test_the_end_itself_may_be_asked_for() -> None:
    for end in (30.0, 0.1 + 0.2, 1e-300, 1 / 3, 12345.678):
        motion = solve(Scene(VAIONT, 0.1, ("centripetal",), end_time=end))
        assert motion.duration == end
        assert motion.at(end) == motion.end


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        (Scene(VAIONT, 0.5, (), 1e200), r"^initial_velocity = 1e\+200, end_time = None: the motion overflows"),
        (Scene(VAIONT, 0.1, (), 0.0, 1e300), r"^initial_velocity = 0.0, end_time = 1e\+300: the motion overflows"),
    ],
)
def test_scenes_that_cannot_be_solved(scene: Scene, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        solve(scene)


@pytest.mark.parametrize("time", [5.0, 10.0, 20.0, 30.0])
def test_vaiont_as_printed_is_the_papers_motion(time: float) -> None:
    """(4.4) and (4.5) with c1 = 165 m/s and c2 = 0.00317 1/s, each known to half a unit of its last place."""
    state = solve(load("vaiont-as-printed")).at(time)
    c_1, c_2 = np.array([164.5, 165.5]), np.array([0.003165, 0.003175])
    low, high = c_1 * np.tanh(c_2 * time)
    assert low < state.velocity < high
    low, high = c_1 / c_2 * np.log(np.cosh(c_2 * time))
    assert low < state.displacement < high


# --- rest, pendulums and short flights; coefficients by quadrature of the raw definitions -----------------------------


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
        lifts = taylor.solve(wet)["lift_off"]
        motion = solve(golden.built("", wet))
        assert len(motion.lift_off) == len(lifts) >= 1
        np.testing.assert_allclose(motion.lift_off, lifts, rtol=1e-9)
