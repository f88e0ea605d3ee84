"""Masses that creep: status by the equation, run-out at the equilibrium, and the time to nearly all of it."""

import json
import math
import re
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.integrate import solve_ivp

from generated import integrator as in_numpy
from slipcircle import Arc, Pulse, Scene, load, solve
from slipcircle.__main__ import main
from slipcircle.core import Status, numpy_only

ARC = Arc(6.34, 1.5 * math.pi - 0.888 - 1.201, 1.5 * math.pi - 0.888 + 1.201, 2e4)
MU = 0.591
SPEED_UNIT = math.sqrt(6.34 * 9.81)
FALL, PRESS = (mpf(float(amplitude)) for amplitude in ARC.amplitudes_per_inertia)
EQUILIBRIUM = mpf(float(ARC.dip)) - mpmath.atan(MU * PRESS / FALL)
STIFFNESS = mpmath.hypot(FALL, MU * PRESS)  # of FALL sin(psi) - MU PRESS cos(psi), where it vanishes


def brake(damping: float) -> dict[str, float]:
    """Return the viscous layer with this damping d: d Theta* = 2 alpha eta/(rho h sqrt(g R))."""
    inertia = float(ARC.dimensionless.moment_of_inertia)
    viscosity = damping * inertia * (2e4 / 9.81) * 0.1 * SPEED_UNIT / (2 * 1.201)
    return {"viscosity": viscosity, "thickness": 0.1}


def turning(friction: Any, arc: Any = ARC, effects: Any = (), **further: Any) -> Scene:
    return Scene(arc, friction, {"rotation": {}, **dict(effects)}, **further)


def scene(damping: float, friction: object = MU, **further: object) -> Scene:
    return Scene(ARC, friction, {"rotation": {}, "viscosity": brake(damping)}, **further)  # type: ignore[arg-type]


CRITICAL = float(2 * mpmath.sqrt(STIFFNESS))


@pytest.mark.parametrize(
    ("damping", "accuracy"),
    [*product((0.99 * CRITICAL, 1.001 * CRITICAL, 20.0), (1e-3, 1e-9, 1e-12)), (1e4, 1e-3), (1e9, 1e-9)],
)
def test_a_mass_creeps_if_it_is_overdamped_at_its_equilibrium(damping: float, accuracy: float) -> None:
    """The status from rest under constant friction is the same for every accuracy, alone and in an ensemble."""
    motion = solve(scene(damping), accuracy)
    lanes = solve(scene(damping, np.array([MU, MU])), accuracy)
    assert {motion.status, *lanes.status} == {Status.CREEPS if damping > CRITICAL else Status.RESTS}
    if damping > CRITICAL:
        assert motion.duration == math.inf
        assert not motion.arrested
        assert motion.run_out == pytest.approx(6.34 * float(EQUILIBRIUM), rel=1e-14)
        assert lanes.run_out == pytest.approx(motion.run_out, rel=1e-14)
        assert accuracy < 1e-9 or damping > 1e4 or motion.error_estimate < 1e-9


def test_without_a_binary_many_explicit_steps_are_left_to_implicit_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    """A damping whose time constant asks for more than 10,000 explicit steps."""
    rounds: list[int] = []
    advance = in_numpy.advance

    def counted(lanes: Any, here: Any) -> None:
        rounds.append(1)
        advance(lanes, here)

    monkeypatch.setattr(in_numpy, "advance", counted)
    with numpy_only():
        motion = solve(scene(1e5))
    assert 0 < len(rounds) < 500
    assert motion.settling_time == pytest.approx(solve(scene(1e5)).settling_time, rel=1e-9)


@pytest.mark.parametrize("damping", [1.2 * CRITICAL, 4.0, 60.0])
def test_the_time_to_99_percent_is_that_of_another_integrator(damping: float) -> None:
    """The equation of motion by SciPy's DOP853, from rest to where a hundredth is left."""
    fall, press, equilibrium = map(float, (FALL, PRESS, EQUILIBRIUM))

    def rates(_: float, state: Any) -> list[float]:
        psi = float(ARC.dip) - state[0]
        return [state[1], fall * math.sin(psi) - MU * press * math.cos(psi) - damping * state[1]]

    motion, unit = solve(scene(damping)), math.sqrt(6.34 / 9.81)
    near = motion.settling_time / unit
    rotation, omega = solve_ivp(rates, (0.0, near), (0.0, 0.0), "DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    assert near + (0.99 * equilibrium - rotation) / omega == pytest.approx(near, rel=1e-11)


def test_softening_masses_creep_or_pass_their_equilibrium() -> None:
    """Masses creep beyond the end of a linear law, or arrive fast, pass their equilibrium and rest behind it."""
    law = {"law": "linear", "peak": 0.93, "residual": MU, "length": 0.0711}
    creeps = solve(scene(1.5 * CRITICAL, law))
    assert creeps.status is Status.CREEPS
    assert creeps.run_out == pytest.approx(6.34 * float(EQUILIBRIUM), rel=1e-14)
    passes = solve(scene(1.5 * CRITICAL, law, initial_velocity=20.0))
    assert passes.status is Status.RESTS
    assert passes.run_out > 1.1 * creeps.run_out
    back = solve(scene(1.5 * CRITICAL, law, initial_velocity=-2.0))
    assert back.status is Status.CREEPS
    assert back.turnings == 1


def test_a_creep_is_read_at_any_time() -> None:
    motion = solve(scene(8.0))
    states = motion.at([0.0, motion.settling_time, 1e6])
    assert states.displacement == pytest.approx([0.0, 0.99 * motion.run_out, motion.run_out], rel=1e-11)
    assert abs(motion.energy.residual) < 1e-12 * motion.energy.work
    assert motion.end.velocity == 0.0
    assert "creeps to a run-out of" in repr(motion)


def test_numpy_finds_the_same_creep() -> None:
    compiled = solve(scene(8.0))
    with numpy_only():
        alone = solve(scene(8.0))
    assert alone.status is Status.CREEPS
    assert alone.settling_time == pytest.approx(compiled.settling_time, rel=1e-11)


FILE = """
[arc]
radius_m = 6.34
theta_1_deg = {theta_1}
theta_2_deg = {theta_2}
unit_weight_kN_m3 = 20
[friction]
coefficient = 0.591
[rotation]
[viscosity]
viscosity_Pa_s = 2e3
thickness_m = 0.1
"""


def test_a_creep_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ends = {f"theta_{k}": np.rad2deg(angle) for k, angle in ((1, ARC.theta_1), (2, ARC.theta_2))}
    (tmp_path / "creep.toml").write_text(FILE.format(**ends), "utf-8")
    assert main(["run", str(tmp_path / "creep.toml"), "--plot", str(tmp_path / "creep.png")]) == 0
    text = capsys.readouterr().out
    assert "infinite, 99 % of the run-out in" in text
    assert main(["run", str(tmp_path / "creep.toml"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)[0]["duration"] is None


# --- the slow run-out ----------------------------------------------------------------------------------------------


def test_the_slow_run_out_is_where_ever_stronger_viscosity_lets_it_creep_to() -> None:
    """Softening beyond its length, water, and a slope that faces left; the strongest brakes creep to the limit."""
    law = {"law": "linear", "peak": 0.3, "residual": 0.2, "length": 0.5}
    water = {"pore_pressure": {"ratio": 0.2}, "cohesion": {"cohesion": 2e3}}
    mirrored = Arc(6.34, math.pi * 3 - ARC.theta_2, math.pi * 3 - ARC.theta_1, 2e4)
    for arc, friction in product((ARC, mirrored), (MU, law)):
        slow = solve(turning(friction, arc, water)).slow_run_out
        viscous = [turning(friction, arc, water | {"viscosity": brake(d)}) for d in (0.3, 4.0, 64.0)]
        crept = [solve(each).run_out for each in viscous]
        assert slow == pytest.approx(crept[-1], rel=1e-13)
        assert crept[0] > 1.05 * slow


@pytest.mark.parametrize("name", ["valley-side", "weak-toe"])
def test_a_mass_below_water_or_in_layers_rests_there_if_it_moves_slowly(name: str) -> None:
    """Slow masses rest where their forces balance, as motions through a viscous layer show."""
    free = load(name)
    layer = {"rotation": {}, "viscosity": {"viscosity": 1e8, "thickness": 0.5}}
    viscous = replace(free, effects=layer, end_time=2e7)
    assert solve(free).slow_run_out == pytest.approx(solve(viscous).run_out, rel=1e-6)


def test_the_slow_run_out_of_constant_friction_is_a_closed_form() -> None:
    """R (psi_0 - delta), with tan(delta) = mu C_r/C_theta; a free mass without centripetal stress goes twice as far."""
    closed = 6.34 * float(EQUILIBRIUM)
    motion = solve(turning(MU))
    assert motion.slow_run_out == pytest.approx(closed, rel=1e-14)
    assert motion.run_out == pytest.approx(2 * closed, rel=1e-12)
    assert solve(turning(np.array([MU, 3.0]))).slow_run_out == pytest.approx([closed, 0.0], rel=1e-14)
    assert solve(turning(3.0, initial_velocity=5.0)).slow_run_out == 0.0


def test_the_slow_run_out_ends_before_a_short_ridge_of_friction() -> None:
    """Friction that holds the mass for a hundredth of a radian alone: it rests where it first does."""

    def law(slip: Any) -> Any:
        return 0.4 + 1.6 * np.exp(-(((slip - 0.02) / 0.008) ** 2))

    slow = solve(turning(law)).slow_run_out
    limit = float(FALL / PRESS) * math.tan(float(ARC.dip) - slow / 6.34)
    assert slow < 0.02
    assert law(slow) == pytest.approx(limit, rel=1e-8)


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        ({"effects": {"rotation": {}, "shaking": {"horizontal": Pulse("sine", 0.1, 0.0, 5.0)}}}, "time"),
        ({"friction": {"law": "rate_weakening", "peak": 0.5, "residual": 0.4, "velocity": 0.1}}, "speed"),
        ({"effects": {}, "end_time": 1.0}, "nothing holds it"),
    ],
)
def test_no_slow_run_out_is_explained(fields: dict[str, Any], reason: str) -> None:
    motion = solve(replace(turning(MU), **fields))
    assert math.isnan(motion.slow_run_out)
    assert reason in motion.no_slow_run_out


def test_a_viscous_mass_that_slides_for_ever_needs_an_end() -> None:
    """The steps of its constant velocity grow without bound; the last piece of its softening has no upper edge."""
    weakening = {"law": "rate_weakening", "peak": 1.0, "residual": 0.7, "velocity": 12.1}
    softening = {"law": "linear", "peak": 0.324, "residual": 0.192, "length": 5.465, "rate": weakening}
    arc = Arc(1492.6, theta_1=3.756, theta_2=4.833, unit_weight=15e3)
    with pytest.raises(ValueError, match=r"^end_time: this slide never rests, as its geometry is frozen"):
        solve(Scene(arc, softening, {"viscosity": {"viscosity": 583.0, "thickness": 0.5}, "centripetal": {}}))


def test_the_slow_run_out_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "vaiont", "--verbose"]) == 0
    assert re.search(r"^run-out if moved slowly +348\.2 m$", capsys.readouterr().out, re.MULTILINE)
    assert main(["run", "vaiont-rate", "--verbose"]) == 0
    assert "not given: forces depend on a friction law of speed" in capsys.readouterr().out
    assert main(["run", "vaiont-rate", "vaiont", "--json"]) == 0
    assert [m["slow_run_out"] for m in json.loads(capsys.readouterr().out)] == [None, pytest.approx(348.2332, rel=1e-6)]
