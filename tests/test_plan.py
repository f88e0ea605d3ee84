"""The planner and the ladder: what they choose, what they print, and that they keep to what the scene calls for."""

import re
from dataclasses import replace
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest

from generated.effects import EFFECTS
from slipcircle import Scene, load, plan, solve
from slipcircle.base.series import Series
from slipcircle.core.motion.plan import FLOW
from slipcircle.workbench.files.variation import other_way
from slipcircle.workbench.studies.ladder import ladder

ARC = load("vaiont").arc
SOFTENING = {"law": "exponential", "peak": 0.4, "residual": 0.2, "length": 2.0}
PARAMETERS = {
    "pore_pressure": {"ratio": 0.2}, "cohesion": {"cohesion": 5e4}, "drag": {"xi": 500.0},
    "viscosity": {"viscosity": 1e4, "thickness": 0.5},
    "shaking": {"pulse": "half-sine", "amplitude": 0.2, "duration": 1.0},
    "thermal_pressurisation": {"pressurisation": 1e4, "heat_capacity": 2.7e6, "thickness": 0.1},
}  # fmt: skip
STILL = ("rotation", "centripetal", "pore_pressure", "cohesion", "drag")
RATE = {"law": "rate_weakening", "peak": 0.4, "residual": 0.1, "velocity": 0.5}


def scene(effects: tuple[str, ...], friction: object = 0.2, **more: object) -> Scene:
    called = {e: PARAMETERS.get(e, {}) for e in effects}
    return Scene(ARC, friction, called, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("effects", "friction"), [((), 0.2), (("rotation",), 0.2), (tuple(EFFECTS), SOFTENING | {"rate": RATE})]
)
def test_every_scene_is_solved_by_its_program(effects: tuple[str, ...], friction: object) -> None:
    assert plan(scene(effects, friction)).method == FLOW


def test_a_plan_says_what_asks_for_a_method() -> None:
    assert plan(scene(STILL[1:])).why == ""
    assert plan(scene((), SOFTENING | {"rate": RATE})).law == "exponential times rate_weakening"
    assert plan(scene(STILL)).why == "rotation turns the mass"
    assert plan(scene(("rotation", "viscosity", "shaking"), SOFTENING | {"rate": RATE})).why == (
        "rotation turns the mass; viscosity depends on the speed; shaking depends on time; "
        "friction depends on slip; friction depends on the speed"
    )
    wet = Scene(ARC, 0.2, {"pore_pressure": {"pressure": Series(np.array([0.0, 1.0]), np.array([0.0, 1e5]))}})
    assert (plan(wet).method, plan(wet).why) == (FLOW, "pore_pressure depends on time")


def test_a_plan_depends_on_what_is_called_for_never_on_values() -> None:
    for count in range(len(EFFECTS) + 1):
        for effects in combinations(EFFECTS, count):
            one, other = plan(scene(effects, 0.2)), plan(scene(effects, 0.4, initial_velocity=3.0))
            assert (one.method, one.fragments, one.operations, one.cost) == (
                other.method, other.fragments, other.operations, other.cost,
            )  # fmt: skip
            assert one.effects == effects
            assert set(one.left_out) == set(EFFECTS) - set(effects)


@pytest.mark.parametrize("name", ["vaiont", "wet-slope", "vaiont-softening", "valley-side"])
def test_the_ladder_climbs_to_the_fullest_scene(name: str) -> None:
    full = solve(load(name))
    rungs = ladder(full.plan.scene)
    assert [len(r.effects) for r in rungs] == list(range(len(full.plan.effects) + 1))
    assert set(rungs[-1].effects) == set(full.plan.effects)
    for before, after in pairwise(rungs):
        assert set(after.effects) - set(before.effects) == {after.added}
        assert after.cost >= before.cost or name == "vaiont-softening"  # its methods change on the way
        assert after.seconds > 0.0
    last = rungs[-1]
    assert (last.run_out, last.peak_velocity, last.duration) == (full.run_out, full.peak.velocity, full.duration)
    assert last.difference == 0.0


def test_a_water_level_goes_with_its_section_whatever_else_changes() -> None:
    """The level is the section's, the pressure an effect: turning a record around or leaving effects out keeps both."""
    pulse = {"pulse": "sine", "amplitude": 0.2, "duration": 1.0}
    shaken = replace(load("valley-side"), effects={"rotation": {}, "shaking": pulse})
    assert "pore_pressure" in shaken.called
    both = solve(shaken), solve(other_way(shaken))
    assert both[0].plan.effects == both[1].plan.effects
    assert both[0].run_out != both[1].run_out
    assert solve(other_way(other_way(shaken))).run_out == both[0].run_out


LADDERS = {  # the effects as they are added, and whether each rung rests
    "vaiont": ("rotation centripetal", "moving yes yes"),
    "newmark-pulse": ("shaking", "move yes"),
    "vaiont-rate": ("rotation centripetal", "moving yes yes"),
    "vaiont-heated": ("rotation thermal_pressurisation centripetal", "moving yes moving moving"),
}


@pytest.mark.parametrize("name", LADDERS)
def test_ladders_on_the_command_line(name: str, said: Any) -> None:
    """What decides comes first, what adds a few percent last; no line is broken, whatever its effects are called."""
    lines = said("plan --ladder", name).splitlines()
    assert max(map(len, lines)) <= 100
    head, *shown = [x.split() for x in lines if "+ " in x or "none" in x or "rests" in x]
    assert head[-2:] == ["rests", "differs"]
    assert (" ".join(x[1] for x in shown[1:]), " ".join(x[-3] for x in shown)) == LADDERS[name]
    assert all(re.fullmatch(r"[\d.]+ (us|ms)", " ".join(x[2:4] if x[0] == "+" else x[1:3])) for x in shown)
    differs = [float(x[-2]) for x in shown]
    assert differs[-1] == 0.0
    assert differs[0] > 5.0
    assert differs[-2] < 5.0 or len(differs) == 2


def test_on_the_command_line(said: Any, records: Any, asked: Any) -> None:
    text = said("plan vaiont")
    assert all(word in text for word in (*plan(load("vaiont")).fragments, FLOW, "not included"))
    (found,) = records("plan --ladder vaiont")
    assert [r["added"] for r in found["ladder"]] == ["", "rotation", "centripetal"]
    assert found["ladder"][-1]["run_out"] == pytest.approx(677.3, abs=0.1)
    assert len(records("plan --all")) == 2 ** len(EFFECTS)
    assert max(map(len, said("plan --all").splitlines())) <= 100
    assert asked("plan")[0] == 2


def test_the_error_to_expect_grows_next_to_the_limit() -> None:
    limit = solve(scene(("rotation",), 0.5)).limit_friction
    far, near = (solve(scene(("rotation",), limit * (1 - gap))).error_estimate for gap in (0.5, 1e-9))
    assert far < 1e-12
    assert near > 1e-7
    assert solve(scene(("rotation",), limit)).error_estimate == 1.0
