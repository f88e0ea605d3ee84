"""Frozen slides of constant friction: ends, energy in joules, the times of a state, and the paper's slide."""

import math
from dataclasses import asdict
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Scene, load, solve
from tests.support.vaiont import ARC as VAIONT

BOTH = pytest.mark.parametrize("effects", [(), ("centripetal",)], ids=["without centripetal", "centripetal"])


def limit_friction(arc: Arc) -> float:
    return float(abs(arc.dimensionless.limit_friction))


@BOTH
def test_a_slide_that_never_rests_needs_an_end(effects: tuple[str, ...]) -> None:
    for mu, velocity in ((0.1, 0.0), (0.0, 0.0), (0.0, -3.0), (limit_friction(VAIONT), 5.0)):
        with pytest.raises(ValueError, match=r"^end_time: .*never rests.* give end_time in s$"):
            solve(Scene(VAIONT, mu, effects, velocity))


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
