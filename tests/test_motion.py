"""Frozen slides of constant friction: rest and arrest, extreme times, balances, scales, and the times of a state.

Coefficients are those of `oracle`, from quadrature of the raw definitions. The limit friction alone is the program's
own number, since the promise is that decision and printed number agree.
"""

import itertools
from collections.abc import Iterator
from dataclasses import asdict
from fractions import Fraction
from typing import Any

import golden
import mpmath
import numpy as np
import pytest
from mpmath import mpf
from oracle import coefficients

from slipcircle import Arc, Scene, load, solve

VAIONT = Arc(1492.6, np.deg2rad(215.2), np.deg2rad(276.9), 20e3)
BOTH = pytest.mark.parametrize("effects", [(), ("centripetal",)], ids=["without centripetal", "centripetal"])


def limit_friction(arc: Arc) -> float:
    return float(abs(arc.dimensionless.limit_friction))


# --- rest is an answer ---------------------------------------------------------------------------------------------


def test_rest_and_the_printed_limit_agree_to_the_last_bit() -> None:
    rng = np.random.default_rng(7)
    for middle, half in zip(rng.uniform(np.pi + 0.05, 2 * np.pi - 0.05, 80), rng.uniform(1e-4, 1.5, 80), strict=True):
        arc = Arc(300.0, middle - half, middle + half, 2e4)
        limit = limit_friction(arc)
        below = float(np.nextafter(limit, 0.0))
        for effects in ((), ("centripetal",)):
            assert solve(Scene(arc, limit, effects)).moves is False
            assert solve(Scene(arc, float(np.nextafter(limit, np.inf)), effects)).moves is False
            motion = solve(Scene(arc, below, effects, end_time=20.0))
            assert motion.moves
            assert not motion.arrested
            # (J_theta - mu J_r)/Theta* = J_r (mu_eq - mu)/Theta*, the difference in exact rational arithmetic.
            c, state = coefficients(arc), motion.at([0.0, 20.0])
            excess = Fraction(limit) - Fraction(below)
            with mpmath.workdps(40):
                expected = mpf(excess.numerator) / excess.denominator * c.radial / c.inertia * mpf("9.81")
                found = (state.acceleration[0], state.velocity[1] / 20, state.displacement[1] / 200)
                for value in found:
                    signed = mpf(float(value)) * int(np.sign(arc.dimensionless.limit_friction))
                    assert abs(signed / expected - 1) < 1e-12


@BOTH
def test_a_mass_at_rest_stays(effects: tuple[str, ...]) -> None:
    for end_time in (None, 50.0):
        motion = solve(Scene(VAIONT, 0.6, effects, end_time=end_time))
        assert (motion.moves, motion.arrested, motion.duration, motion.run_out) == (False, True, 0.0, 0.0)
        state = motion.at(np.array([[0.0, 1e-9], [7.0, 1e9]]))
        for name, values in asdict(state).items():
            match name:
                case "time":
                    np.testing.assert_array_equal(values, [[0.0, 1e-9], [7.0, 1e9]])
                case "normal_stress":
                    assert np.all(values == VAIONT.static_normal_stress)
                case _:
                    assert not np.any(values), name
                    assert values.shape == (2, 2), name
        assert motion.peak == motion.end == motion.at(0.0)
        energy = motion.energy
        assert asdict(energy) == {"kinetic_start": 0, "kinetic_end": 0, "work": 0, "dissipation": 0}


@BOTH
def test_after_an_arrest_nothing_moves(effects: tuple[str, ...]) -> None:
    motion = solve(Scene(VAIONT, 0.6, effects, initial_velocity=12.0))
    assert motion.arrested
    assert motion.moves
    rest = motion.at(motion.duration * np.array([1.0, 1 + 1e-15, 1.5, 1e6]))
    assert np.all(rest.displacement == motion.run_out)
    assert not np.any(rest.velocity)
    assert not np.any(rest.acceleration)
    assert np.all(rest.normal_stress == VAIONT.static_normal_stress)
    for share in (1e-15, 1e-12, 1e-9):  # friction brakes until the last moment
        before = motion.at(motion.duration * (1 - share))
        assert before.acceleration < -1.7
        assert abs(before.velocity + before.acceleration * (motion.duration - before.time)) < 1e-14


@BOTH
def test_an_end_before_the_arrest_is_the_end(effects: tuple[str, ...]) -> None:
    to_rest = solve(Scene(VAIONT, 0.6, effects, initial_velocity=12.0))
    cut = solve(Scene(VAIONT, 0.6, effects, initial_velocity=12.0, end_time=0.5 * to_rest.duration))
    assert not cut.arrested
    assert cut.duration == 0.5 * to_rest.duration
    assert cut.end == to_rest.at(cut.duration)
    late = solve(Scene(VAIONT, 0.6, effects, initial_velocity=12.0, end_time=2 * to_rest.duration))
    assert (late.arrested, late.duration, late.end) == (True, to_rest.duration, to_rest.end)


@BOTH
def test_a_slide_that_never_rests_needs_an_end(effects: tuple[str, ...]) -> None:
    for mu, velocity in ((0.1, 0.0), (0.0, 0.0), (0.0, -3.0), (limit_friction(VAIONT), 5.0)):
        with pytest.raises(ValueError, match=r"^end_time: .*never rests.* give end_time in s$"):
            solve(Scene(VAIONT, mu, effects, velocity))


# --- directions ----------------------------------------------------------------------------------------------------


@BOTH
def test_turning_back_is_continuous(effects: tuple[str, ...]) -> None:
    motion = solve(Scene(VAIONT, 0.2, effects, initial_velocity=-10.0, end_time=60.0))
    ((turn, before_it, after_it),) = golden.changes(motion)
    assert (before_it, after_it) == (-1, 1)
    for step in (1e-3, 1e-6, 1e-9):
        before, at, after = (motion.at(t) for t in (turn - step, turn, turn + step))
        bound = 9.81 * step
        assert -bound < before.velocity < 0.0 < after.velocity < bound
        for near in (before, after):
            assert abs(near.displacement - at.displacement) < 9.81 * step**2 + 1e-14 * abs(at.displacement)
    assert abs(motion.at(turn).velocity) < 1e-13
    assert motion.at(turn - 1e-6).acceleration > motion.at(turn + 1e-6).acceleration > 0.0


def test_density_does_not_matter_and_length_scales() -> None:
    """Displacement over R depends on t/sqrt(R/g) alone: with powers of two, to the last bit."""
    times = np.linspace(0.0, 30.0, 31)
    for mu, velocity, effects in itertools.product((0.1, 0.5), (0.0, 9.0, -9.0), ((), ("centripetal",))):
        one = solve(Scene(Arc(800.0, 3.9, 5.1, 2e4), mu, effects, velocity, end_time=30.0))
        dense = solve(Scene(Arc(800.0, 3.9, 5.1, 3e4, width=7.0), mu, effects, velocity, end_time=30.0))
        large = solve(Scene(Arc(3200.0, 3.9, 5.1, 2e4), mu, effects, 2 * velocity, end_time=60.0))
        slow = solve(Scene(Arc(800.0, 3.9, 5.1, 2e4, 9.81 / 4), mu, effects, velocity / 2, end_time=60.0))
        now = times if not one.arrested else times[times < one.duration]
        state = one.at(now)
        for other, stretch, length in ((dense, 1, 1), (large, 2, 4), (slow, 2, 1)):
            same = other.at(stretch * now)
            np.testing.assert_array_equal(same.rotation, state.rotation)
            np.testing.assert_array_equal(same.displacement, length * state.displacement)
            np.testing.assert_array_equal(same.velocity, length / stretch * state.velocity)
            assert other.duration == stretch * one.duration
            assert other.run_out == length * one.run_out


# --- extreme times and terminal velocity ---------------------------------------------------------------------------


def from_rest(arc: Arc, mu: float, time: float) -> tuple[mpf, mpf]:
    """Velocity and displacement with centripetal stress, from rest: (3.16) solved by separation, in mpmath."""
    c = coefficients(arc)
    with mpmath.workdps(60):
        a = (mpf(float(arc.dimensionless.limit_friction)) - mpf(mu)) * c.radial / c.inertia
        b = mpf(mu) * c.polar / c.inertia
        t = mpf(time) / c.time_scale
        terminal, rate = mpmath.sqrt(a / b), mpmath.sqrt(a * b)
        omega = terminal * mpmath.tanh(rate * t)
        # ln cosh x = x + ln(1 + e^(-2x)) - ln 2, which cancels for short times, but not to nothing of 60 digits.
        phi = (rate * t + mpmath.log1p(mpmath.exp(-2 * rate * t)) - mpmath.log(2)) / b
        return omega * c.radius / c.time_scale, phi * c.radius


@pytest.mark.parametrize("time", [1e-9, 1e-6, 1e-3, 1.0, 30.0, 1e3, 1e5, 1e9])
@pytest.mark.parametrize("mu", [1e-12, 0.1, 0.4192])
def test_from_a_nanosecond_to_thirty_years(mu: float, time: float) -> None:
    end = solve(Scene(VAIONT, mu, ("centripetal",), end_time=time)).end
    velocity, displacement = from_rest(VAIONT, mu, time)
    assert abs(mpf(float(end.velocity)) / velocity - 1) < 2e-15
    assert abs(mpf(float(end.displacement)) / displacement - 1) < 2e-15


def test_against_mpmath_odefun() -> None:
    """A Taylor integrator that knows no closed form: 14 digits, from rest, from a fast start, and thrown up."""
    c = coefficients(VAIONT)
    mu = 0.2
    with mpmath.workdps(25):
        limit = mpf(float(VAIONT.dimensionless.limit_friction))
        b = mu * c.polar / c.inertia
        for start, time in ((0.0, 20.0), (400.0, 20.0), (-30.0, 4.5)):
            direction = -1 if start < 0 else 1
            a = (limit - direction * mu) * c.radial / c.inertia
            solution = mpmath.odefun(
                lambda _, y, a=a, d=direction: [y[1], a - d * b * y[1] ** 2], 0, [0, start / c.radius * c.time_scale]
            )
            phi, omega = solution(mpf(time) / c.time_scale)
            end = solve(Scene(VAIONT, mu, ("centripetal",), start, end_time=time)).end
            assert abs(mpf(float(end.displacement)) / (phi * c.radius) - 1) < 1e-14
            assert abs(mpf(float(end.velocity)) / (omega * c.radius / c.time_scale) - 1) < 1e-14


def test_terminal_velocity_from_above_and_below() -> None:
    """Where the friction of the centripetal stress takes up the drive; from then on the displacement is linear."""
    c = coefficients(VAIONT)
    mu = 0.2
    with mpmath.workdps(40):
        excess = mpf(float(VAIONT.dimensionless.limit_friction)) - mpf(mu)
        terminal = float(mpmath.sqrt(excess * c.radial / (mu * c.polar)) * c.radius / c.time_scale)
    for start in (0.0, 0.5 * terminal, 3.0 * terminal, -0.5 * terminal):
        motion = solve(Scene(VAIONT, mu, ("centripetal",), start, end_time=1e9))
        assert motion.end.velocity == pytest.approx(terminal, rel=5e-15)
        assert abs(motion.end.acceleration) < 1e-300
        states = motion.at([4e8, 6e8, 8e8])
        np.testing.assert_allclose(np.diff(states.displacement), 2e8 * terminal, rtol=1e-14)
        assert abs(motion.peak.velocity) == pytest.approx(max(terminal, abs(start)), rel=5e-15)


# --- balances ------------------------------------------------------------------------------------------------------


def random_scenes(count: int) -> Iterator[Scene]:
    rng = np.random.default_rng(20250102)
    for _ in range(count):
        middle, half = rng.uniform(np.pi + 0.1, 2 * np.pi - 0.1), 10 ** rng.uniform(-3, 0.19)
        arc = Arc(
            10 ** rng.uniform(0.5, 4), middle - half, middle + half, rng.uniform(15e3, 25e3),
            gravity=rng.choice([9.81, 1.62]), width=rng.uniform(1, 500),
        )  # fmt: skip
        limit = limit_friction(arc)
        near = limit * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-12, -1))
        mu = rng.choice([0.0, limit * rng.uniform(0, 3), near, limit])
        unit = float(np.sqrt(np.multiply(arc.radius, arc.gravity)))
        start = rng.choice([0.0, unit * rng.uniform(-1, 1), unit * 10 ** rng.uniform(-4, 3)])
        end = float(arc.time_scale) * 10 ** rng.uniform(-1, 4)
        yield Scene(arc, mu, ("centripetal",) if rng.random() < 0.7 else (), start, end)


def test_energy_balance() -> None:
    """Friction's work, by quadrature, is what gravity did and the motion lost: 14 digits of all energy there was."""
    for scene in random_scenes(200):
        energy = solve(scene).energy
        total = energy.kinetic_start + abs(energy.work) + energy.dissipation
        assert energy.dissipation >= 0.0
        assert abs(energy.residual) <= 1e-14 * total, scene


def test_energy_in_joules() -> None:
    """Half the mass moment of inertia times omega squared, and the weight's moment times the rotation."""
    arc = Arc(400.0, 3.9, 5.2, 21e3, width=250.0)
    motion = solve(Scene(arc, 0.1, ("centripetal",), 4.0, 25.0))
    spin = motion.end.angular_velocity
    assert motion.energy.kinetic_start == pytest.approx(arc.moment_of_inertia * (4.0 / 400.0) ** 2 / 2, rel=1e-14)
    assert motion.energy.kinetic_end == pytest.approx(arc.moment_of_inertia * spin**2 / 2, rel=1e-14)
    assert motion.energy.work == pytest.approx(arc.weight_moment * motion.end.rotation, rel=1e-14)
    # The resisting moment of constant friction mu J_r alone, where the centripetal term is left out.
    plain = solve(Scene(arc, 0.1, (), 4.0, 25.0))
    c = coefficients(arc)
    moment = 0.1 * float(c.radial) * 250.0 * 21e3 * 400.0**3
    assert plain.energy.dissipation == pytest.approx(moment * plain.end.rotation, rel=1e-13)


# --- times ---------------------------------------------------------------------------------------------------------


def test_times_of_any_shape() -> None:
    motion = solve(load("vaiont-frozen"))
    times = np.linspace(0.0, 30.0, 12)
    flat = motion.at(times)
    for shape in ((3, 4), (2, 2, 3), (12, 1)):
        state = motion.at(times.reshape(shape))
        for name, values in asdict(state).items():
            assert values.shape == shape, name
            np.testing.assert_array_equal(values.ravel(), getattr(flat, name))
    for i, t in enumerate(times.tolist()):
        for single in (motion.at(t), motion.at(np.asarray(t))):
            for name, value in asdict(single).items():
                assert np.ndim(value) == 0, name
                assert value == pytest.approx(getattr(flat, name)[i], rel=4e-16), name
    assert motion.at([]).velocity.shape == (0,)
    assert motion.at(list(times)).velocity.tolist() == flat.velocity.tolist()
    assert motion.at(30).velocity == motion.end.velocity


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


# --- the paper's slide ---------------------------------------------------------------------------------------------


def test_vaiont_as_printed_is_the_papers_motion() -> None:
    """(4.4) and (4.5) with c1 = 165 m/s and c2 = 0.00317 1/s, each known to half a unit of its last place."""
    motion = solve(load("vaiont-as-printed"))
    for time in (5.0, 10.0, 20.0, 30.0):
        state = motion.at(time)
        low, high = ((165 + s * 0.5, 0.00317 + s * 0.000005) for s in (-1, 1))
        (v_low, s_low), (v_high, s_high) = (
            (c_1 * np.tanh(c_2 * time), c_1 / c_2 * np.log(np.cosh(c_2 * time))) for c_1, c_2 in (low, high)
        )
        assert v_low < state.velocity < v_high
        assert s_low < state.displacement < s_high
    # The table's coefficients in (3.16): Theta* = 0.4376, J_r = 0.0870, J_theta = 0.0387, lambda = 0.1523, A = 0.468.
    with mpmath.workdps(30):
        mu = mpf(float(np.tan(np.deg2rad(10.0))))
        a, b = (mpf("0.0387") - mu * mpf("0.0870")) / mpf("0.4376"), mu * mpf("0.1523") * mpf("0.468") / mpf("0.4376")
        rate = mpmath.sqrt(mpf("9.81") / mpf("1492.6"))
        velocity = mpf("1492.6") * rate * mpmath.sqrt(a / b) * mpmath.tanh(mpmath.sqrt(a * b) * rate * 30)
        assert abs(mpf(float(motion.end.velocity)) / velocity - 1) < 1e-14
