"""Scenes that depend on time, speed or heat: textbook answers, limits, starts and stops, hard cases."""

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from slipcircle import Scene, Status, load, solve
from slipcircle.tables import Pulse, Series

ARC: Any = load("vaiont").arc
TURNING: dict[str, Any] = {"rotation": {}, "centripetal": {}}
HEAT = {"pressurisation": 1e3, "heat_capacity": 2.7e6, "thickness": 0.1}
RATE = {"law": "rate_weakening", "peak": 0.41, "residual": 0.2, "velocity": 0.5}
_UNIT = float(ARC.radius) / float(ARC.time_scale) ** 2 / float(ARC.dimensionless.moment_of_inertia)
FALL, PRESS = _UNIT * float(ARC.dimensionless.weight_moment), _UNIT * float(ARC.dimensionless.radial_weight)  # m/s^2


@pytest.mark.parametrize("friction", [0.3, {"law": "linear", "peak": 0.3, "residual": 0.3, "length": 1.0}])
@pytest.mark.parametrize("heat", [1e3, 1e5])
def test_undrained_adiabatic_decay(friction: Any, heat: float) -> None:
    """Rice (2006): at constant normal stress sigma' falls as exp(-mu Lambda s/(rho c h))."""
    called = {"thermal_pressurisation": HEAT | {"pressurisation": heat}}
    motion = solve(Scene(ARC, friction, called, end_time=20.0))
    times = np.linspace(0.0, 20.0, 41)
    state = motion.at(times)
    decay = np.exp(-0.3 * heat * state.displacement / (2.7e6 * 0.1))
    expected = float(ARC.static_normal_stress) * decay
    effective = state.normal_stress - motion.pore_pressure_at(times)
    np.testing.assert_allclose(effective, expected, rtol=0, atol=1e-12 * effective[0])


# --- starts, stops and restarts --------------------------------------------------------------------------------------


def test_shaking_that_ends_while_it_slides_and_a_rest_before_the_end_time() -> None:
    push = TURNING | {"shaking": {"pulse": "rectangular", "amplitude": 0.5, "duration": 2.0, "start": 1.0}}
    motion, waits, over = (solve(Scene(ARC, 0.5, push, end_time=end)) for end in (None, 0.5, 500.0))
    assert motion.peak.time == pytest.approx(3.0, rel=1e-12)
    assert (waits.moves, waits.arrested, waits.run_out, waits.duration) == (False, True, 0.0, 0.0)  # as without it
    assert (over.arrested, over.duration) == (True, motion.duration)
    assert over.at(400.0).displacement == motion.run_out


def test_what_happens_after_the_end_time_decides_nothing_before_it() -> None:
    """The mass rests from 1.8 s on, and would start again at 10.7 s."""
    record = Series(np.array([0.0, 1, 1.5, 9.5, 12, 13]), np.array([0, 0.4, -0.3, -0.3, 0.5, 0]), False)
    friction = 1.2 * float(solve(Scene(ARC, 0.3, TURNING)).limit_friction)
    effects = TURNING | {"shaking": {"horizontal": record}}
    whole, cut = (solve(Scene(ARC, friction, effects, end_time=end)) for end in (None, 9.0))
    assert [whole.status.name, cut.status.name] == ["RESTS", "RESTS"]
    assert [len(whole.phases), len(cut.phases)] == [2, 1]
    assert (cut.duration, cut.at(9.0).velocity) == (whole.phases[0].end, 0.0)
    with pytest.raises(ValueError, match=r"at most the scene.s end_time, 9\.0 s"):
        cut.at(9.5)


# --- hard cases ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("amplitude", [1e3, 1e9])
def test_huge_shaking_is_refused_where_the_mass_turns_over(amplitude: float) -> None:
    with pytest.raises(ValueError, match="the chord is vertical"):
        solve(Scene(ARC, 0.5, TURNING | {"shaking": {"pulse": "half-sine", "amplitude": amplitude, "duration": 5.0}}))


@pytest.mark.parametrize("heat", [3e3, 1e9])
def test_pressurisation_that_removes_all_strength(heat: float) -> None:
    """Then nothing brings it to rest: the first standstill from which it would swing for ever is given."""
    motion = solve(Scene(ARC, 0.3, TURNING | {"thermal_pressurisation": HEAT | {"pressurisation": heat}}))
    assert not motion.arrested
    assert motion.lift_off
    assert abs(motion.energy.residual) < 1e-6 * motion.energy.work
    if heat == 1e9:
        assert motion.run_out == pytest.approx(solve(Scene(ARC, 0.0, TURNING)).run_out, rel=1e-6)


@pytest.mark.parametrize("friction", [0.0, 1e-12, 1e-9])
def test_swings_that_do_not_die_away_end_at_their_first_turning_point(friction: float) -> None:
    """A mass without friction is a pendulum that turns at twice its dip; the integrator stops after 2,000 swings."""
    lanes = solve(Scene(ARC, np.array([friction, 0.0]), TURNING))
    alone = solve(Scene(ARC, friction, TURNING))
    for motion in (alone, lanes[0]):
        assert (motion.status, motion.turnings, motion.end.velocity) == (Status.MOVING, 0, 0.0)
        assert motion.run_out == motion.end.displacement == pytest.approx(2 * ARC.radius * ARC.dip, rel=1e-8)
    assert alone.error_estimate < 1e-12
    with pytest.raises(ValueError, match=r"turns back \d{4} times or more without coming to rest; give an earlier end"):
        solve(Scene(ARC, 1e-9, TURNING, end_time=1e6))


def test_vanishing_friction_is_followed_to_its_end_time() -> None:
    vanishing = RATE | {"residual": 0.0, "velocity": 1e-9}
    motion = solve(Scene(ARC, vanishing, TURNING, end_time=300.0))  # asked for so much only, it is followed
    sense = np.sign(motion.at(np.linspace(0.1, 300.0, 3001)).velocity)
    assert 7 <= np.count_nonzero(np.diff(sense)) < 9


@pytest.mark.parametrize("turns", [False, True])
@pytest.mark.parametrize(("start", "amplitude"), [(2.0, 0.0), (2.0, 0.3), (200.0, 0.3)])
def test_a_mass_at_rest_that_k_v_lifts_is_reported(start: float, amplitude: float, turns: bool) -> None:
    """A half-sine of 1.5 passes 1 after asin(2/3)/pi of its duration, whether the mass moves then or rests."""
    horizontal = Pulse("rectangular", amplitude, 0.0, 1.0)
    motion, below = (
        solve(Scene(ARC, 0.5, {"shaking": {"horizontal": horizontal, "vertical": Pulse("half-sine", top, start, 2.0)}}
                    | ({"rotation": {}} if turns else {})))
        for top in (1.5, 1.0)
    )  # fmt: skip
    lifted = start + 2.0 * math.asin(2 / 3) / math.pi
    assert motion.lift_off == pytest.approx((lifted,), rel=1e-14)
    assert motion.warnings[0] == f"contact lost from {lifted:.6g} s (lift-off)"
    assert motion.moves == (amplitude > 0.0)
    assert not below.lift_off


def test_many_lift_offs_are_said_once() -> None:
    waves = Series(np.arange(11.0), np.array([0.0, 3.0] * 5 + [0.0]), held=False)
    shaking = {"horizontal": Series(np.array([0.0, 11.0]), np.array([0.3, 0.3])), "vertical": waves}
    motion = solve(Scene(ARC, 0.3, {"rotation": {}, "shaking": shaking}, end_time=10.0))
    (said,) = (w for w in motion.warnings if "lift-off" in w)
    assert f"{motion.lift_off[0]:.6g} s, and 4 times more until {motion.lift_off[4]:.6g} s" in said


@pytest.mark.parametrize("share", [1e-2, 1e-6, 1e-13, 0.0, -1e-13, -1e-6, -1e-2])
def test_a_stop_that_just_happens(share: float) -> None:
    """Friction falls steadily in time, so that the velocity is a parabola, and that touches zero, or almost."""
    with mpmath.workdps(30):
        slows, less = mpf(0.6) * PRESS - FALL, (mpf(0.6) - mpf(0.2)) * PRESS / 20
        turn = slows / less
        start = mpf(float(slows**2 / (2 * less) * (1 + mpf(share))))
        below = slows**2 / (2 * less) - start  # how far below zero it would go
        stop = turn - mpmath.sqrt(2 * max(below, 0) / less)
        left = 20 - (turn if below > 0 else stop)  # since it started again
        moved = start * stop - slows * stop**2 / 2 + less * stop**3 / 6 + max(-below, 0) * left + less * left**3 / 6
        velocity = max(-below, 0) + less * left**2 / 2
    law = {"law": "prescribed", "time": [0.0, 20.0], "coefficient": [0.6, 0.2]}
    motion = solve(Scene(ARC, law, {}, float(start), 20.0))
    assert motion.error_estimate <= 1e-9
    assert motion.run_out == pytest.approx(float(moved), rel=motion.error_estimate)
    assert motion.end.velocity == pytest.approx(float(velocity), rel=motion.error_estimate)
    if abs(share) >= 1e-6:
        rests = [time for one, other in pairwise(motion.phases) for time in (one.end, other.start)]
        assert rests == pytest.approx([float(stop), float(turn)] * (share < 0), rel=1e-7)


@pytest.mark.parametrize("share", [1e-2, 1e-14, 0.0, -1e-14, -1e-12, -1e-6, -1e-2])
def test_a_stop_that_hangs_on_a_hair_warns(share: float) -> None:
    """If friction falls with velocity, one velocity separates motions that stop from motions that run away."""
    law = {"law": "rate_weakening", "peak": 0.6, "residual": 0.2, "velocity": 0.5}
    with mpmath.workdps(30):
        drive = mpf(FALL) - mpf(0.2) * PRESS  # less the residual friction
        edge = ((mpf(0.6) - mpf(0.2)) * PRESS / drive - 1) / 2
        start = mpf(float(edge * (1 + mpf(share))))
        motion = solve(Scene(ARC, law, {}, float(start), 60.0))
        error = motion.error_estimate
        assert any("ill-conditioned" in w for w in motion.warnings) == (error > 1e-9)
        assert abs(share) == 1e-6 or (error > 1e-9) == (abs(share) < 1e-2)
        assert (error >= 1.0 and abs(share) <= 1e-13) or motion.arrested == (share < 0)
        if motion.arrested:  # integrated by hand: dt = (velocity + v) dv / (drive (v - edge))
            gone = mpmath.log(edge / (edge - start))
            time = ((mpf(0.5) + edge) * gone - start) / drive
            moved = ((mpf(0.5) + edge) * (edge * gone - start) - start**2 / 2) / drive
            assert abs(motion.duration / time - 1) <= error
            assert abs(motion.run_out / moved - 1) <= error


@pytest.mark.parametrize("more", [1e-2, 1e-6, 1e-9, -1e-9])
def test_a_lift_off_that_just_happens(more: float) -> None:
    """Vertical shaking whose top just carries the mass, or just not."""
    shaking = {"pulse": "half-sine", "amplitude": 0.0, "vertical_amplitude": 1.0 + more, "duration": 6.0}
    motion = solve(Scene(ARC, 0.3, {"rotation": {}, "shaking": shaking}, 3.0, 8.0))
    assert motion.error_estimate <= 1e-9
    lifted = [6 / math.pi * math.asin(1 / (1 + more))] if more > 0 else []
    assert motion.lift_off == pytest.approx(lifted, abs=1e-9)
    if lifted:  # and lands where k_v falls to 1 again
        after = motion.at([6.0 - lifted[0] - 1e-6, 6.0 - lifted[0] + 1e-6]).normal_stress
        assert after[0] < 0.0 < after[1]


@pytest.mark.parametrize("seed", range(4))
def test_lift_offs_late_in_a_record_are_those_of_the_same_one_early(seed: int) -> None:
    """Water and k_v carry the mass again and again, at times that are rounded more the later they are."""
    rng = np.random.default_rng(seed)
    time, values = np.cumsum(rng.uniform(0.2, 1, 30)) * 0.03, rng.standard_normal((2, 30))
    found = []
    for late in (0.5, 500.0):
        horizontal, vertical = (Series(late + time, s * v, held=False) for s, v in zip((1.5, 0.8), values, strict=True))
        effects = {"rotation": {}, "shaking": {"horizontal": horizontal, "vertical": vertical}}
        found.append(solve(Scene(replace(ARC, radius=60.0), 0.6, effects, end_time=late + 20)))
    early, later = found
    assert len(later.lift_off) == len(early.lift_off) > 0
    assert later.run_out == pytest.approx(early.run_out, rel=1e-8)
