"""Rate weakening, whose steps are in a variable tau instead of the time, in which friction needs no quotient."""

import math
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from sympy import Expr

from derive.check.proof import ProofError
from derive.declare.effects import EFFECTS, LAWS
from derive.flow import fragments, linked, pace
from slipcircle import Arc, Scene, load, solve
from tests.support import oracle, taylor
from tests.support.lanes import BACKENDS, Recipe, backend, build_program

VAIONT: Scene[Any] = load("vaiont")
GIVEN = {"arc": oracle.plain(VAIONT.arc), "effects": dict(VAIONT.called), "initial_velocity": 0.0, "end_time": None}
TURNING = ("rotation", "centripetal")
SHARES = [0.01, 0.3, 0.55, 0.9]


def law(peak: Any, velocity: float) -> dict[str, Any]:
    return {"law": "rate_weakening", "peak": peak, "residual": 0.14, "velocity": velocity}


@pytest.mark.parametrize("velocity", [0.05, 1.0, 20.0])
def test_ensembles_have_the_digits_of_a_plain_integration(velocity: float) -> None:
    """Vaiont at three frictions, by Taylor series in time with twenty digits."""
    peaks = np.tan(np.radians([10.0, 19.5, 22.5]))
    found = solve(replace(VAIONT, friction=law(peaks, velocity)), 1e-9).outcomes
    for lane, peak in enumerate(peaks.tolist()):
        exact = taylor.solve(GIVEN | {"friction": law(peak, velocity)}, digits=20)
        for name in ("run_out", "duration", "peak_velocity"):
            assert found[name][lane] == pytest.approx(float(exact[name]), rel=1e-10), name


@pytest.mark.parametrize("name", BACKENDS)
def test_states_at_given_times_and_at_the_end_time(name: str) -> None:
    friction = law(math.tan(math.radians(14.0)), 1.0)
    exact = taylor.solve(GIVEN | {"friction": friction}, SHARES, digits=20)
    with backend(name):
        scene = replace(VAIONT, friction=friction)
        motion = solve(scene)
        state = motion.at(exact["times"])
        cut = [solve(replace(scene, end_time=time)).end for time in exact["times"]]
        after = [motion.at(np.array([time - 1e-4, time + 1e-4])).velocity for time in exact["times"]]
    for k, (place, speed) in enumerate(zip(exact["displacement"], exact["velocity"], strict=True)):
        assert state.displacement[k] == pytest.approx(float(place), rel=1e-12)
        assert state.velocity[k] == pytest.approx(float(speed), rel=1e-12)
        assert cut[k].displacement == pytest.approx(float(place), rel=1e-12)
        assert cut[k].velocity == pytest.approx(float(speed), rel=1e-12)
        slope = float(after[k][1] - after[k][0]) / 2e-4
        assert state.acceleration[k] == pytest.approx(slope, rel=1e-6, abs=1e-6)
        assert cut[k].acceleration == pytest.approx(slope, rel=1e-6, abs=1e-6)


def test_the_estimate_sees_the_error_of_steps_that_the_end_time_cuts_short() -> None:
    """The last step is the same in all runs, so that they need different orders."""
    arc = Arc(20.0, 4.74, 6.53, 20e3)
    friction = {"law": "rate_weakening", "peak": 0.56, "residual": 0.21, "velocity": 1.55}
    effects: dict[str, Any] = {"cohesion": {"cohesion": 1e4}}
    given = {"arc": oracle.plain(arc), "friction": friction, "effects": effects}
    exact = taylor.solve(given | {"initial_velocity": 3.0, "end_time": 2.55}, digits=20)
    alike: Any = Scene(arc, friction, effects, np.array([3.0, 3.0]), end_time=2.55)
    for scene, accuracy, least in ((replace(alike, initial_velocity=3.0), None, 0.0), (alike, 1e-4, 1e-10)):
        motion = solve(scene, accuracy)
        outcomes = (motion.outcomes[name] / float(exact[name]) for name in ("run_out", "peak_velocity"))
        error = np.max([np.abs(outcome - 1.0) for outcome in outcomes])
        assert least <= error < np.min(motion.error_estimate)


def frozen(arc: Any, friction: dict[str, float], velocity: float) -> tuple[Any, Any]:
    """Return path and time, in m and s, of a mass of unchanging geometry from a velocity on to another, by quadrature.

    Both are functions of the velocity at the end, which is the independent variable.
    """
    m = oracle.numbers(arc)
    fall, press = m["fall"] * mpmath.sin(m["dip"]), m["press"] * mpmath.cos(m["dip"])
    to_speed = m["radius"] / m["scale"]

    def rate(v: Any) -> Any:
        mu = friction["residual"] + (friction["peak"] - friction["residual"]) / (1 + v / mpf(friction["velocity"]))
        return to_speed / m["scale"] * (fall - mu * press)

    def path(end: Any) -> Any:
        return mpmath.quad(lambda v: v / rate(v), [velocity, end])

    def time(end: Any) -> Any:
        return mpmath.quad(lambda v: 1 / rate(v), [velocity, end])

    return path, time


STOPPING = {"peak": 0.392281293574377, "residual": 0.24984794709006947, "velocity": 0.013080774167604831}
STEEP = Arc(1134.5392637755444, 4.682235684558949, 5.225539002406535, 20e3)


@pytest.mark.parametrize("name", BACKENDS)
def test_an_end_time_just_before_the_rest(name: str) -> None:
    """The series of the time in tau rises up to the standstill and falls beyond it; the mass still moves at the end."""
    path, time = frozen(STEEP, STOPPING, 1.9456171250807524)
    scene: Scene[Any] = Scene(STEEP, {"law": "rate_weakening", **STOPPING}, {}, 1.9456171250807524)
    rest, ends = float(time(0)), np.array([0.4, 0.8, 0.98, 0.994, 0.9999, 1.01])
    with backend(name):
        motion = solve(replace(scene, end_time=rest * ends), 1e-9)
        alone = [solve(replace(scene, end_time=float(end))) for end in rest * ends]
    assert motion.arrested.tolist() == [False] * 5 + [True] == [bool(one.arrested) for one in alone]
    for k, end in enumerate(ends[:5]):
        speed = mpmath.findroot(
            lambda v, end=end: time(v) - rest * end, [1.94 * (1 - end), 2.0 * (1 - end) + 0.01], tol=1e-20
        )
        for found, accuracy in ((motion.run_out[k], 1e-9), (alone[k].run_out, 1e-12)):
            assert found == pytest.approx(float(path(speed)), rel=accuracy)
    assert motion.run_out[5] == pytest.approx(float(path(0)), rel=1e-9)
    assert motion.duration[5] == pytest.approx(rest, rel=1e-9)


@pytest.mark.parametrize("accuracy", [1e-3, 1e-6, 1e-9, 1e-12])
def test_the_requested_accuracy_is_reached_where_the_speed_is_an_entire_function(accuracy: float) -> None:
    """The speed of a frozen mass consists of exponentials of tau, and its path of their squares."""
    velocities = np.array([0.02, 0.3, 1.9456171250807524, 40.0])
    scene: Scene[Any] = Scene(STEEP, {"law": "rate_weakening", **STOPPING}, {}, velocities)
    motion = solve(scene, accuracy)
    for k, velocity in enumerate(velocities.tolist()):
        path, time = frozen(STEEP, STOPPING, velocity)
        assert motion.run_out[k] == pytest.approx(float(path(0)), rel=accuracy)
        assert motion.duration[k] == pytest.approx(float(time(0)), rel=accuracy)


def test_tau_replaces_the_time_where_a_quotient_of_the_speed_is_the_only_friction() -> None:
    """Functions of time, further states, viscosity and a law of slip beside it keep the time."""
    (weakening,) = [x.name for x in LAWS if x.coefficient is not None and pace.of_friction(x.coefficient)]
    alone = build_program(Recipe(TURNING, (weakening,)))
    others = [
        build_program(Recipe(TURNING, ("exponential", weakening))),
        build_program(Recipe((*TURNING, "shaking"), (weakening,), ("k_h",), ("k_v",))),
        build_program(Recipe((*TURNING, "thermal_pressurisation"), (weakening,))),
        build_program(Recipe((*TURNING, "viscosity"), (weakening,))),
    ]
    assert "rec" not in {kind for kind, *_ in alone.series}
    for program in others:
        assert "rec" in {kind for kind, *_ in program.series}
        assert "cell_pace" not in program.roles


@pytest.mark.parametrize("wrong", ["far", "per_speed"])
def test_another_friction_than_declared_is_no_theorem(wrong: str, monkeypatch: pytest.MonkeyPatch) -> None:
    (weakening,) = [x for x in LAWS if x.coefficient is not None and pace.of_friction(x.coefficient)]
    instant = [effect for effect in EFFECTS if not effect.states and effect.name != "viscosity"]
    effects = [effect for effect in instant if {p.kind for p in effect.parameters} <= {"number"}]
    assert linked.prove_case(effects, (weakening,))
    right = pace.of_friction

    def of_friction(coefficient: Expr) -> dict[str, Expr]:
        found = right(coefficient)
        return {x: 2 * e if x == wrong else e for x, e in found.items()}

    monkeypatch.setattr(pace, "of_friction", of_friction)
    fragments.law_fragment.cache_clear()
    with pytest.raises(ProofError, match=r"d.*/dt"):
        linked.prove_case(effects, (weakening,))
    fragments.law_fragment.cache_clear()
