"""Public numbers of scenes with every law and effect, against stored numbers and against one another."""

import json
import math
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_series, ctx

from slipcircle import Arc, Motion, Scene, solve
from tests.support import accuracy, golden, oracle, taylor
from tests.support.motions import residual
from tests.support.pieces import constant

KEPT: dict[str, Any] = {r["name"]: r["numbers"] for r in json.loads(golden.FILE.read_text("utf-8"))}
ROWS = golden.rows()
SAMPLE = list(ROWS)[::6]
SOME = pytest.mark.parametrize("name", SAMPLE)
MOVING = pytest.mark.parametrize("name", [name for name in SAMPLE if KEPT[name]["moves"]])
DENSE = np.linspace(0.0, 1.0, 61)[:-1]


def dense(motion: Motion) -> Any:
    """Return times before the end, with the time of the peak."""
    return np.unique([*(DENSE * motion.duration), float(motion.peak.time)])


# --- against what is kept --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ROWS)
def test_numbers_are_those_kept(name: str) -> None:
    assert not golden.differences(name, golden.solved(name), KEPT[name])


@pytest.mark.parametrize("name", list(ROWS)[::29])
def test_those_kept_are_those_of_ball_arithmetic(name: str) -> None:
    given = ROWS[name]
    if given is not None:
        found = accuracy.misses(golden.solved(name), given)
        assert all(share <= 1.0 for share in found.values()), found


# --- fields of a state -----------------------------------------------------------------------------------------------


@MOVING
def test_nothing_changes_in_a_rest(name: str) -> None:
    """Velocity and acceleration are zero between slides and after the end, and the displacement is constant."""
    motion = golden.solved(name)
    state = motion.at(np.append(np.linspace(0.0, motion.duration, 4001), [1.1 * motion.duration] * 3 * motion.arrested))
    rests = (state.velocity[1:] == 0.0) & (state.velocity[:-1] == 0.0)
    assert not np.any(np.diff(state.displacement)[rests])
    assert not np.any(state.acceleration[1:-1][rests[1:] & rests[:-1]])
    assert np.count_nonzero(rests) > 50 or not ("rests in between" in name or "stands before" in name)


@SOME
def test_energy_balances_and_adds_up(name: str) -> None:
    motion = golden.solved(name)
    times = dense(motion)
    energy, arc = motion.energy_at(times), motion.plan.scene.arc
    assert isinstance(arc, Arc)
    assert residual(motion) <= motion.energy_error_estimate + 1e-13
    total = np.max(np.abs([energy.kinetic_end, energy.work, energy.dissipation])) + energy.kinetic_start
    assert np.all(np.diff(energy.dissipation) >= -1e-12 * total)
    kinetic = float(arc.moment_of_inertia) * motion.at(times).angular_velocity ** 2 / 2
    np.testing.assert_allclose(energy.kinetic_end, kinetic, rtol=1e-12, atol=1e-13 * float(total))
    if {"shaking", "rotation"}.isdisjoint(motion.plan.effects):
        work = float(arc.weight_moment) * motion.end.rotation
        assert motion.energy.work == pytest.approx(work, rel=1e-11, abs=1e-12 * float(total))


@pytest.mark.parametrize("name", [name for name, given in ROWS.items() if given is not None][::3])
def test_state_of_limit_and_stress_from_the_definitions(name: str) -> None:
    """Limit friction, factor of safety and k_y of the position at rest; normal stress of any state."""
    motion, given = golden.solved(name), golden.to_the_right(ROWS[name] or {})
    with ctx.workprec(160):
        p, zero = taylor.Problem(given), arb_series([0])
        stress = float(oracle.moments(given["arc"])["reference_stress"] / p.level)  # of a load of 1
        fall, normal = (float(x[0]) for x in p.pressed(zero, arb(0), 1))
        along, across = float(p.fall * p.dip.cos()), -float(p.press * p.dip.sin())
        held, mu = float(p.cohesion), float(p.mu(zero, zero, arb(0), 0, 0)[0])
        p.water = p.ratio = constant()
        press = float(p.pressed(zero, arb(0), 1)[1][0])
        state = motion.at(dense(motion)[::9])
        places = zip(np.ravel(state.time).tolist(), np.ravel(state.rotation).tolist(), strict=True)
        loads = [float(p.pressed(arb_series([x]), arb(t) / p.scale, 1)[1][0]) for t, x in places]
    polar = float(p.polar) * state.angular_velocity**2 * given["arc"]["radius"] / given["arc"]["gravity"]
    np.testing.assert_allclose(state.normal_stress, (loads + polar) * stress, rtol=1e-9)
    assert motion.pore_pressure_at(0.0) == pytest.approx((press - normal) * stress, rel=1e-12, abs=1e-12 * stress)
    if p.shaken:  # values at once tilt gravity
        return
    yields = (held + mu * normal - fall) / (along - mu * across)
    carried = normal + yields * across < 0.0
    yields = (held - fall) / along if carried else yields
    assert motion.yield_coefficient == pytest.approx(yields, rel=1e-12, abs=1e-13)
    limit = (fall - held) / normal if normal > 0.0 else math.copysign(math.inf, fall - held)
    assert motion.limit_friction == pytest.approx(limit, rel=1e-12)
    assert motion.factor_of_safety == pytest.approx((held + mu * max(normal, 0.0)) / fall, rel=1e-12)


@pytest.mark.parametrize(("cohesion", "alike"), [(2e3, False), (2e6, True)])
def test_a_mass_that_lifts_before_it_yields_needs_no_friction(cohesion: float, alike: bool) -> None:
    """If shaking lifts the mass before it yields, k_y depends on cohesion and weight alone."""
    effects = {"rotation": {}, "cohesion": {"cohesion": cohesion}}
    arc = Arc(**dict[str, Any](golden.SLOPE))
    one, other = (solve(Scene(arc, mu, effects)).yield_coefficient for mu in (0.1, 0.4))
    assert (one == pytest.approx(other, rel=1e-12)) == alike
    turned = np.array([arc.theta_1, arc.theta_2]).mean() - 1.5 * np.pi  # of the chord's middle from straight below
    held = cohesion * 2 * float(arc.half_angle) * float(arc.radius) ** 2
    pull = float(arc.weight_moment)
    assert not alike or one == pytest.approx((held - pull) / (pull / np.tan(abs(turned))), rel=1e-9)
