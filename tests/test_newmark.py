"""Shaken frozen slides against Newmark's sliding block, exact double integrals, and integrations by other methods.

A frozen slip circle without brakes is Newmark's block times Gamma = (C_theta cos psi_0 + mu C_r sin psi_0)/Theta*, with
the yield N = k_y: so what is published for the block tests the rotational solver.
"""

import math
from typing import Any

import numpy as np
import pytest

from slipcircle import Arc, Motion, Scene, load, solve
from slipcircle.tables import Pulse
from tests.support.blocks import ARC, GRAVITY, MU, factor, of_block, quake, series


def shaken(horizontal: Any, vertical: Any = None, mu: float = MU, arc: Arc = ARC, **more: Any) -> Motion:
    """Return a scene that is shaken and has no other effect."""
    given = {"horizontal": horizontal} | ({} if vertical is None else {"vertical": vertical})
    two_way = {"two_way": more.pop("two_way")} if "two_way" in more else {}
    return solve(Scene(arc, mu, {"shaking": given | two_way}, **more))


# --- Newmark's block, published ------------------------------------------------------------------------------------


@pytest.mark.parametrize("amplitude", [0.113, 0.2, 0.3, 1.5])
def test_rectangular_pulse(amplitude: float) -> None:
    """Newmark (1965): u = V^2/(2 g N) (1 - N/A), V = A g D; it slides until t = D A/N."""
    gamma, n = factor()
    motion = shaken(Pulse("rectangular", amplitude, 0.5, 0.4))
    v = amplitude * GRAVITY * 0.4
    assert motion.run_out == pytest.approx(gamma * v**2 / (2 * GRAVITY * n) * (1 - n / amplitude), rel=1e-13)
    assert motion.peak.velocity == pytest.approx(gamma * (amplitude - n) * GRAVITY * 0.4, rel=1e-13)
    assert motion.peak.time == pytest.approx(0.9, rel=1e-14)
    assert motion.duration == pytest.approx(0.5 + 0.4 * amplitude / n, rel=1e-13)
    assert motion.error_estimate < 1e-13 * amplitude / (amplitude - n)  # near the yield it is ill-conditioned


class Level(Arc):
    """An arc whose weight pulls neither way, to the last bit."""

    @property
    def moment_coefficients(self) -> Any:
        return super().moment_coefficients._replace(driving_moment=0.0)


def test_a_level_mass_is_held_against_shaking_in_the_directions_in_which_it_may_start() -> None:
    """The limit friction is k_h C_theta/C_r; one-way shaking starts the mass in the positive direction only."""
    record = series([0.0, 2.0, 4.0, 8.0], [0.0, 0.2, -0.2, 0.1])
    level = Level(60.0, 1.5 * math.pi - 0.5, 1.5 * math.pi + 0.5, 19e3)
    coefficients = level.moment_coefficients
    k_h = np.array([0.1, 0.2, 0.0, -0.2])
    for two_way, pull in (False, np.maximum(k_h, 0.0)), (True, np.abs(k_h)):
        held = shaken(record, mu=0.3, arc=level, two_way=two_way).holding_friction_at([1.0, 2.0, 3.0, 4.0])
        limit = pull * coefficients.driving_moment_slope / coefficients.normal_load
        assert held == pytest.approx(limit, rel=1e-12, abs=1e-15)


def test_earthquake_against_an_exact_double_integral() -> None:
    record = quake(7, 700)
    record = series(record.time, 4.0 * record.values)
    motion = shaken(record)
    places, speeds, stop = of_block(record)
    state = motion.at(np.minimum(record.time, motion.duration))
    assert motion.run_out == pytest.approx(places[-1], rel=1e-13)
    assert np.abs(state.displacement - places[:-1]).max() < 1e-13 * places[-1]
    assert np.abs(state.velocity - speeds).max() < 1e-13 * speeds.max()
    assert motion.duration == pytest.approx(stop, rel=1e-13)


def test_newmark_pulse_is_what_its_comment_says() -> None:
    motion = solve(load("newmark-pulse"))
    gamma, n = factor()
    numbers = motion.run_out, motion.peak.velocity, motion.duration, gamma, n
    assert " ".join(f"{x:.6f}" for x in numbers) == "0.432819 0.810312 1.568278 1.100346 0.112330"
    assert motion.yield_coefficient == pytest.approx(n, rel=1e-14)


# --- an earthquake-like record -------------------------------------------------------------------------------------


@pytest.mark.parametrize("ramp", [1e-9, 1e-6])
@pytest.mark.parametrize("begin", [0.0, 100.0])
def test_jumps_given_as_short_ramps(ramp: float, begin: float) -> None:
    """Slips begin on a ramp, where rounding of the time alone is up to 1e-5 of the jump."""
    levels = np.random.default_rng(11).uniform(-0.3, 0.3, 30)
    times = begin + 0.2 * np.arange(1.0, 31.0)
    time = np.column_stack([times, times + ramp]).ravel()
    values = np.column_stack([[0.0, *levels[:-1]], levels]).ravel()
    record = series([0.0, *time, begin + 7.0], [0.0, *values, levels[-1]])
    for mu in MU * (1.0 + 1e-7 * np.arange(5)):
        motion = shaken(record, mu=mu)
        places, _, stop = of_block(record, mu)
        assert motion.run_out == pytest.approx(places[-1], rel=1e-13)
        assert motion.duration == pytest.approx(stop, rel=1e-13)
        assert len(motion.phases) > 5


# --- hard cases ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["rectangular", "half-sine", "triangular", "sine"])
@pytest.mark.parametrize("ulps", [-512, -2, -1, 0, 1, 2, 512])
def test_next_to_the_yield_coefficient(name: str, ulps: int) -> None:
    """The estimate is large where rounding decides, and the displacement is negligible."""
    n = shaken(Pulse(name, 0.1, 0.5, 1.0)).yield_coefficient
    motion = shaken(Pulse(name, n * (1 + ulps * 2.0**-53), 0.5, 1.0))
    assert abs(motion.run_out) < 1e-12
    assert motion.duration < 1.5 + 1e-6
    assert motion.moves == (ulps > 0) or abs(ulps) < 100
    assert motion.error_estimate > 0.3 or ulps < -100


def test_huge_amplitudes_and_an_error_where_they_overflow() -> None:
    strong = shaken(Pulse("rectangular", 1e6, 0.0, 1e-3))
    weight, dip = float(ARC.amplitudes_per_inertia[0]), float(ARC.dip)  # it is thrown: no friction in the pulse
    thrown = weight * (1e6 * math.cos(dip) + math.sin(dip)) * GRAVITY * 1e-3
    assert strong.peak.velocity == pytest.approx(thrown, rel=1e-13)
    # Braked, omega' = Gamma (k_h - k_y) - b omega^2: it reaches its terminal speed at once; what is lost is told.
    braked = solve(Scene(ARC, MU, {"centripetal": {}, "shaking": {"horizontal": Pulse("rectangular", 1e12, 0.0, 1.0)}}))
    (gamma, n), scale = factor(), float(ARC.time_scale)
    brake = MU * float(ARC.dimensionless.polar_moment_per_inertia)
    terminal, slows = math.sqrt(gamma * (1e12 - n) / brake), gamma * n
    rest = 1.0 + scale * math.atan(terminal * math.sqrt(brake / slows)) / math.sqrt(brake * slows)
    assert braked.peak.velocity == pytest.approx(60.0 / scale * terminal, rel=1e-13)
    assert abs(braked.duration / rest - 1) < braked.error_estimate < 1e-2
    with pytest.raises(ValueError, match="overflows"):
        shaken(Pulse("rectangular", 1e300, 0.0, 1e10))
