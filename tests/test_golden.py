"""Every public number of scenes of every law and effect, against those that are kept, and against one another."""

import json
import math
from typing import Any

import numpy as np
import pytest
from flint import ctx

from slipcircle import Arc, Motion
from tests.support import golden, oracle

KEPT: dict[str, Any] = {r["name"]: r["numbers"] for r in json.loads(golden.FILE.read_text("utf-8"))}
ROWS = golden.rows()
SAMPLE = list(ROWS)[::6]
SOME = pytest.mark.parametrize("name", SAMPLE)
MOVING = pytest.mark.parametrize("name", [name for name in SAMPLE if KEPT[name]["moves"]])
DENSE = np.linspace(0.0, 1.0, 61)[:-1]


def dense(motion: Motion) -> Any:
    """Times before the end, the peak's among them."""
    return np.unique([*(DENSE * motion.duration), float(motion.peak.time)])


def weight(name: str) -> tuple[float, float]:
    """Gravity, and the mean normal stress of the mass at rest."""
    arc = golden.solved(name).plan.scene.arc
    return float(arc.gravity), float(arc.static_normal_stress)  # type: ignore[arg-type]


# --- against what is kept --------------------------------------------------------------------------------------------


def test_the_file_is_of_these_scenes() -> None:
    assert list(KEPT) == list(ROWS)
    kinds = {(n["moves"], n["arrested"], bool(n["lift_off"]), n["run_out"] < 0.0) for n in KEPT.values()}
    assert len(kinds) >= 8
    assert all(n["estimate"] < 1e-9 for n in KEPT.values()), "no number is kept that is not known"


@pytest.mark.parametrize("name", ROWS)
def test_numbers_are_those_kept(name: str) -> None:
    assert not golden.differences(name, golden.solved(name), KEPT[name])


@pytest.mark.parametrize("name", list(ROWS)[::29])
def test_those_kept_are_those_of_ball_arithmetic(name: str) -> None:
    given = ROWS[name]
    if given is not None:
        found = golden.misses(golden.solved(name), given, KEPT[name]["times"])
        assert all(share <= 1.0 for share in found.values()), found


# --- fields of a state -----------------------------------------------------------------------------------------------


@SOME
def test_peak_and_end_are_states_of_their_times(name: str) -> None:
    motion = golden.solved(name)
    gravity, stress = weight(name)
    speed, error = abs(float(motion.peak.velocity)), motion.error_estimate + 1e-14
    for state in (motion.peak, motion.end):
        other = motion.at(float(state.time))
        assert abs(other.velocity - state.velocity) <= error * speed
        assert abs(other.displacement - state.displacement) <= 20 * error * abs(motion.run_out)
        jumps = state is motion.peak and "shaking" in motion.plan.effects  # a peak may stand where a pulse ends
        assert jumps or abs(other.acceleration - state.acceleration) <= 1e4 * error * gravity
        assert jumps or abs(other.normal_stress - state.normal_stress) <= 1e4 * error * stress
        for length, angle in (("displacement", "rotation"), ("velocity", "angular_velocity")):
            radius = motion.plan.scene.arc.radius
            assert getattr(state, length) == pytest.approx(radius * getattr(state, angle), rel=4e-16)
    assert motion.end.time == motion.duration
    assert motion.run_out == motion.end.displacement
    assert motion.end == motion.at(motion.duration)


@MOVING
def test_the_peak_is_the_greatest_speed(name: str) -> None:
    motion = golden.solved(name)
    speed, times = abs(float(motion.peak.velocity)), np.linspace(0.0, motion.duration, 2003)
    assert np.all(np.abs(motion.at(times).velocity) <= speed * (1.0 + motion.error_estimate + 1e-14))
    assert np.sign(motion.peak.velocity) == np.sign(motion.at(float(motion.peak.time)).velocity)
    inside = 1e-9 < motion.peak.time / motion.duration < 1.0 - 1e-9
    timeless = {"shaking"}.isdisjoint(motion.plan.effects) and motion.plan.law != "prescribed"
    if inside and timeless and "tabulated" not in name and not motion.lift_off:
        assert abs(motion.peak.acceleration) <= 1e-5 * weight(name)[0]


@MOVING
def test_speed_is_the_change_of_place_and_acceleration_that_of_speed(name: str) -> None:
    """By the difference of what is 1e-5 s apart; a jump or a kink may lie in between in a few places."""
    motion, h = golden.solved(name), 1e-5
    times = dense(motion)
    times = times[(times > 2 * h) & (times < motion.duration - 2 * h)]
    here, before, after = (motion.at(t) for t in (times, times - h, times + h))
    gravity, speed = weight(name)[0], abs(float(motion.peak.velocity))
    of_place = np.abs((after.displacement - before.displacement) / (2 * h) - here.velocity)
    of_speed = np.abs((after.velocity - before.velocity) / (2 * h) - here.acceleration)
    grain = (motion.error_estimate + 1e-14) / h
    assert np.mean(of_place > 1e-5 * gravity + grain * abs(motion.run_out)) <= 0.05
    assert np.mean(of_speed > 1e-3 * gravity + grain * speed) <= 0.05


@MOVING
def test_nothing_changes_in_a_rest(name: str) -> None:
    """Between sliding and sliding, and after the end, speed and acceleration are zero and the place is the same."""
    motion = golden.solved(name)
    times = np.linspace(0.0, motion.duration, 4001)
    state = motion.at(times)
    rests = (state.velocity[1:] == 0.0) & (state.velocity[:-1] == 0.0)
    assert np.all(state.displacement[1:][rests] == state.displacement[:-1][rests])
    inner = rests[1:] & rests[:-1]
    assert np.all(state.acceleration[1:-1][inner] == 0.0)
    if "rests in between" in name or "stands before" in name:
        assert np.count_nonzero(inner) > 50
    if motion.arrested:
        later = motion.at(np.array([1.0, 1.1, 30.0]) * motion.duration)
        assert np.all(later.velocity == 0.0)
        assert np.all(later.acceleration == 0.0)
        assert np.all(later.displacement == motion.run_out)
        assert later.time[-1] == 30.0 * motion.duration
    else:
        with pytest.raises(ValueError, match=r"^Motion\.at: times = .* must be at most"):
            motion.at(1.001 * motion.duration)


@SOME
def test_energy_balances_and_adds_up(name: str) -> None:
    motion = golden.solved(name)
    times = dense(motion)
    energy, arc = motion.energy_at(times), motion.plan.scene.arc
    assert isinstance(arc, Arc)
    total = np.max(np.abs([energy.kinetic_end, energy.work, energy.dissipation])) + energy.kinetic_start
    share = motion.energy_error_estimate + 1e-13
    assert np.all(np.abs(energy.residual) <= share * total)
    assert np.all(np.diff(energy.dissipation) >= -1e-12 * total)
    inertia = float(arc.moment_of_inertia)
    np.testing.assert_allclose(energy.kinetic_end, inertia * motion.at(times).angular_velocity ** 2 / 2,
                               rtol=1e-12, atol=1e-13 * float(total))  # fmt: skip
    assert motion.energy.work == pytest.approx(float(motion.energy_at(motion.duration).work), rel=1e-12, abs=0.0)
    if motion.arrested:
        assert motion.energy.kinetic_end == 0.0
    if "shaking" not in motion.plan.effects and "rotation" not in motion.plan.effects:
        moment = float(arc.weight_moment)
        assert motion.energy.work == pytest.approx(moment * motion.end.rotation, rel=1e-11, abs=1e-12 * float(total))


def moments(given: golden.Data) -> dict[str, float]:
    """Moments of the definitions by quadrature, over the moment of inertia, and the dip."""
    with ctx.workprec(160):
        return {k: float(v) for k, v in oracle.moments(given["arc"]).items()}


@pytest.mark.parametrize("name", [name for name, given in ROWS.items() if given is not None][::3])
def test_state_of_limit_and_stress_from_the_definitions(name: str) -> None:
    """Limit friction, factor of safety and k_y of the position at rest; normal stress of any state."""
    given, motion = ROWS[name], golden.solved(name)
    assert given is not None
    given = golden.to_the_right(given)
    m, effects = moments(given), given["effects"]
    fall, press = m["fall"] * math.sin(m["dip"]), m["press"] * math.cos(m["dip"])
    water, start = effects.get("pore_pressure", {}), motion.pore_pressure_at(0.0) / m["reference_stress"]
    if "time" not in water:
        assert start * m["reference_stress"] == pytest.approx(
            water.get("pressure", 0.0) + water.get("ratio", 0.0) * press / m["level"] * m["reference_stress"], rel=1e-12
        )
    held = m["level"] * effects.get("cohesion", {}).get("cohesion", 0.0) / m["reference_stress"]
    normal = press - m["level"] * start
    law = given["friction"]
    mu = law if not isinstance(law, dict) else law["peak"] if "peak" in law else law["coefficient"][0]
    if isinstance(law, dict) and "rate" in law:
        mu *= law["rate"]["peak"]
    if "shaking" not in effects:  # whose values at once tilt gravity
        limit = (fall - held) / normal if normal > 0.0 else math.copysign(math.inf, fall - held)
        assert motion.limit_friction == pytest.approx(limit, rel=1e-12)
        assert motion.factor_of_safety == pytest.approx((held + mu * max(normal, 0.0)) / fall, rel=1e-12)
    if "time" not in water:
        along, across = m["fall"] * math.cos(m["dip"]), -m["press"] * abs(math.sin(m["dip"]))
        yields = (held + mu * normal - fall) / (along - mu * across)
        carried = normal + yields * across < 0.0
        assert carried or motion.yield_coefficient == pytest.approx(yields, rel=1e-12, abs=1e-13)
    if "shaking" in effects:
        return
    times = dense(motion)[::9]
    state = motion.at(times)
    turned = m["dip"] - state.rotation if "rotation" in effects else m["dip"]
    polar = m["polar"] if "centripetal" in effects else 0.0
    omega = state.angular_velocity * math.sqrt(given["arc"]["radius"] / given["arc"]["gravity"])
    stress = (m["press"] * np.cos(turned) + polar * omega**2) / m["level"] * m["reference_stress"]
    np.testing.assert_allclose(state.normal_stress, stress, rtol=1e-9)
    assert motion.run_out >= 0.0 or given["initial_velocity"] < 0.0
