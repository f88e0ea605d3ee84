"""The motion, against independent integrations of its equation; arrest and rest; balances, symmetries and refusals.

References take their coefficients from quadrature of the raw definitions. They integrate the equation of motion with
its sign of omega, one direction after the other, find each standstill by an event, and make the rest test there. The
limit friction alone is the program's own number, since the promise is that decision and printed number agree.
"""

import itertools
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import golden
import mpmath
import numpy as np
import oracle
import pytest
from flint import arb
from mpmath import mpf
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from slipcircle import Arc, Motion, Scene, load, solve

Floats = NDArray[np.float64]

VAIONT = Arc(1492.6, np.deg2rad(215.2), np.deg2rad(276.9), 20e3)
BACKWARDS = Arc(1492.6, 3 * np.pi - np.deg2rad(276.9), 3 * np.pi - np.deg2rad(215.2), 20e3)  # Vaiont in a mirror
ARCS = {
    "vaiont": VAIONT,
    "backwards": BACKWARDS,
    "steep, wide": Arc(80.0, np.pi + 0.05, np.pi + 2.0, 18e3, gravity=3.7, width=7.0),
    "thin": Arc(5000.0, 4.2, 4.2001, 23e3),
    "half disc": Arc(12.0, np.deg2rad(190.0), np.deg2rad(370.0), 19e3),
}
BOTH = pytest.mark.parametrize("effects", [(), ("centripetal",)], ids=["without centripetal", "centripetal"])


def limit_friction(arc: Arc) -> float:
    return float(abs(arc.dimensionless.limit_friction))


def frictions(arc: Arc) -> dict[str, float]:
    limit = limit_friction(arc)
    below, above = float(np.nextafter(limit, 0.0)), float(np.nextafter(limit, np.inf))
    return {
        "none": 0.0, "low": 0.4 * limit, "an ulp below": below, "limit": limit, "an ulp above": above,
        "high": 1.5 * limit, "five times": 5 * limit,
    }  # fmt: skip


# --- the reference -------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Coefficients:
    """Of the equation of motion, from the definitions: to 50 digits, here as mpmath numbers."""

    inertia: mpf
    pressing: mpf
    turning: mpf
    factor: mpf
    polar: mpf
    time_scale: mpf
    radius: mpf
    reference_stress: mpf


@cache
def coefficients(arc: Arc) -> Coefficients:
    theta_1, theta_2 = float(np.asarray(arc.theta_1)), float(np.asarray(arc.theta_2))
    half = (Fraction(theta_2) - Fraction(theta_1)) / 2
    with mpmath.workdps(50):

        def number(ball: arb) -> mpf:
            return mpf(ball.str(50, radius=False))

        radius, gravity, unit_weight = (mpf(float(np.asarray(x))) for x in (arc.radius, arc.gravity, arc.unit_weight))
        alpha = mpf(half.numerator) / half.denominator
        return Coefficients(
            number(oracle.kernel("moment_of_inertia", half)),
            number(oracle.whole("radial_weight", theta_1, theta_2)[0]),
            abs(number(oracle.whole("weight_moment", theta_1, theta_2)[0])),  # positive is down-slope
            number(oracle.kernel("resistance_factor", half)),
            number(oracle.kernel("polar_moment", half)),
            mpmath.sqrt(radius / gravity),
            radius,
            unit_weight * radius * (1 - mpmath.cos(alpha)),
        )


class Integration:
    """DOP853 through the equation of motion; SI at the door, dimensionless inside."""

    def __init__(self, scene: Scene, end_time: float) -> None:
        c = coefficients(scene.arc)
        self.mu = float(np.asarray(scene.friction))
        self.inertia, self.pressing, self.factor = map(float, (c.inertia, c.pressing, c.factor))
        self.share = float(c.polar / c.factor) if "centripetal" in scene.effects else 0.0  # A (2.24)
        # The one number by which it is decided; the drive at the limit must not be a rounding error of J_theta.
        self.limit = abs(float(scene.arc.dimensionless.limit_friction))
        assert abs(mpf(self.limit) * c.pressing / c.turning - 1) < 1e-14
        self.radius, self.time_scale = float(c.radius), float(c.time_scale)
        self.reference_stress = float(c.reference_stress)
        self.pieces: list[tuple[float, float, int, Any]] = []
        self.arrest: float | None = None
        self._integrate(float(np.asarray(scene.initial_velocity)), end_time / self.time_scale)

    def acceleration(self, omega: float | Floats, direction: int) -> Any:
        """Theta* d(omega)/dt* = J_theta - sgn(omega) lambda mu (J_r/lambda + A omega**2), towards the direction."""
        drive = (self.limit - direction * self.mu) * self.pressing
        return (drive - direction * self.factor * self.mu * self.share * omega * omega) / self.inertia

    def _integrate(self, velocity: float, end: float) -> None:
        omega, phi, time = velocity / self.radius * self.time_scale, 0.0, 0.0
        while time < end:
            if omega == 0.0 and abs(self.limit) <= self.mu:
                self.arrest = time
                break
            direction = int(np.sign(omega or self.limit))

            def rates(_: float, y: Floats, direction: int = direction) -> list[float]:
                return [y[1], self.acceleration(y[1], direction)]

            def standstill(_: float, y: Floats) -> float:
                return float(y[1])

            standstill.terminal, standstill.direction = True, -direction  # type: ignore[attr-defined]
            brakes = direction * self.acceleration(0.0, direction) < 0
            done = solve_ivp(
                rates, (time, end), [phi, omega], method="DOP853", rtol=1e-13, atol=1e-18, dense_output=True,
                events=standstill if brakes else None,
            )  # fmt: skip
            assert done.success
            stop, (phi, omega) = done.t[-1], done.y[:, -1]
            if done.status == 1:
                for _ in range(4):  # Newton's steps from the event, which the interpolation places to its own order
                    rate = self.acceleration(omega, direction)
                    step = -omega / rate
                    stop, phi, omega = stop + step, phi + omega * step / 2, omega + step * rate
                omega = 0.0
            self.pieces.append((time, stop, direction, done.sol))
            time = stop
        self.final = phi

    def at(self, times: Floats) -> dict[str, Floats]:
        t = times / self.time_scale
        phi, omega, rate = np.full(t.shape, self.final), np.zeros_like(t), np.zeros_like(t)
        for start, stop, direction, solution in self.pieces:
            goes_on = self.arrest is None and solution is self.pieces[-1][3]
            inside = (t >= start) & ((t < stop) | goes_on)
            if np.any(inside):
                phi[inside], omega[inside] = solution(t[inside])
                rate[inside] = self.acceleration(omega[inside], direction)
        scale = self.time_scale
        return {
            "rotation": phi,
            "angular_velocity": omega / scale,
            "velocity": self.radius * omega / scale,
            "displacement": self.radius * phi,
            "acceleration": self.radius * rate / scale**2,
            "normal_stress": self.reference_stress * (self.pressing / self.factor + self.share * omega**2),
        }


def size(found: Floats) -> float:
    return float(np.max(np.abs(found), initial=0.0))


def compare(motion: Motion, reference: Integration, times: Floats, tolerance: float) -> float:
    """The worst error of any quantity at any time, relative to the largest value of the quantity."""
    state, worst = motion.at(times), 0.0
    for name, expected in reference.at(times).items():
        value = np.asarray(getattr(state, name))
        error = size(value - expected) / (size(expected) or 1.0)
        assert error <= tolerance, f"{motion.plan.scene}: {name} is wrong by {error:.2g}"
        worst = max(worst, error)
    return worst


@BOTH
@pytest.mark.parametrize("name", ARCS)
def test_motion_against_numerical_integration(name: str, effects: tuple[str, ...]) -> None:
    """Friction below, at and above the limit, starts in either direction, arrest and turning back."""
    arc = ARCS[name]
    unit = float(np.sqrt(np.multiply(arc.radius, arc.gravity)))
    end = 4.0 * float(arc.time_scale)
    for mu, start in itertools.product(frictions(arc).values(), (0.0, 0.3, -0.3, -1e-7, 5.0)):
        scene = Scene(arc, mu, effects, initial_velocity=start * unit, end_time=end)
        motion, reference = solve(scene), Integration(scene, end)
        assert motion.arrested == (reference.arrest is not None), scene
        times = np.linspace(0.0, motion.duration, 41)
        if reference.arrest is not None:
            assert motion.duration == pytest.approx(reference.arrest * reference.time_scale, rel=2e-12), scene
            assert motion.run_out == pytest.approx(reference.radius * reference.final, rel=2e-12), scene
            # The very moment of arrest belongs to the rest here; next to it, to neither.
            times = np.concatenate([times[:-1], motion.duration * np.array([1.0 + 1e-9, 2.0])])
        compare(motion, reference, times, 2e-12)
        assert motion.moves == (start != 0 or mu < limit_friction(arc))


# --- rest is an answer ---------------------------------------------------------------------------------------------


def test_rest_and_the_printed_limit_agree_to_the_last_bit() -> None:
    rng = np.random.default_rng(7)
    for middle, half in zip(rng.uniform(np.pi + 0.05, 2 * np.pi - 0.05, 200), rng.uniform(1e-4, 1.5, 200), strict=True):
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
                expected = mpf(excess.numerator) / excess.denominator * c.pressing / c.inertia * mpf("9.81")
                found = (state.acceleration[0], state.velocity[1] / 20, state.displacement[1] / 200)
                for value in found:
                    assert abs(mpf(float(value)) / expected - 1) < 1e-12


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
@pytest.mark.parametrize("mu", [0.0, 0.1, 0.3, 0.419, 0.5, 2.0])
def test_friction_opposes_the_motion_and_never_drives_it(mu: float, effects: tuple[str, ...]) -> None:
    """Thrown up the slope, the mass is braked harder than by its weight alone, and turns back only below the limit."""
    scene = Scene(VAIONT, mu, effects, initial_velocity=-25.0, end_time=200.0)
    motion = solve(scene)
    c = coefficients(VAIONT)
    weight = float(c.turning / c.inertia) * 9.81
    state = motion.at(np.linspace(0.0, motion.duration, 4001)[:-1])
    up = state.velocity < 0
    assert np.all(state.acceleration[up] >= weight * (1 - 1e-14))
    assert np.all(state.acceleration[~up] <= weight * (1 + 1e-14))
    assert np.all(np.diff(np.sign(state.velocity)) >= 0)
    assert motion.arrested == (mu >= limit_friction(VAIONT))
    assert np.any(state.velocity > 0) == (mu < limit_friction(VAIONT))


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


@BOTH
def test_mirrored_arcs_move_alike(effects: tuple[str, ...]) -> None:
    """Mirrored in a vertical line: theta becomes 3 pi - theta. Only its rounding may be seen."""
    for mu, velocity in itertools.product((0.0, 0.2, 0.41, 0.5), (0.0, 8.0, -8.0)):
        right = solve(Scene(VAIONT, mu, effects, velocity, end_time=40.0))
        left = solve(Scene(BACKWARDS, mu, effects, velocity, end_time=40.0))
        assert (left.moves, left.arrested) == (right.moves, right.arrested)
        assert left.duration == pytest.approx(right.duration, rel=1e-12)
        times = np.linspace(0.0, 40.0 if not right.arrested else 0.999 * right.duration, 50)
        one, two = right.at(times), left.at(times)
        for name in ("rotation", "velocity", "displacement", "acceleration"):
            first, second = getattr(one, name), getattr(two, name)
            np.testing.assert_allclose(second, first, rtol=0, atol=2e-12 * size(first))
        np.testing.assert_allclose(two.normal_stress, one.normal_stress, rtol=1e-12)
        assert left.run_out == pytest.approx(right.run_out, rel=1e-11)


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
        a = (mpf(float(arc.dimensionless.limit_friction)) - mpf(mu)) * c.pressing / c.inertia
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
            a = (limit - direction * mu) * c.pressing / c.inertia
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
        terminal = float(mpmath.sqrt(excess * c.pressing / (mu * c.polar)) * c.radius / c.time_scale)
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
    moment = 0.1 * float(c.pressing) * 250.0 * 21e3 * 400.0**3
    assert plain.energy.dissipation == pytest.approx(moment * plain.end.rotation, rel=1e-13)


def test_peak_is_the_greatest_speed() -> None:
    for scene in random_scenes(60):
        motion = solve(scene)
        dense = motion.at(np.linspace(0.0, motion.duration, 2001))
        peak = abs(motion.peak.velocity)
        assert peak >= np.max(np.abs(dense.velocity)) * (1 - 1e-15)
        assert motion.peak == motion.at(motion.peak.time)
        assert motion.end == motion.at(motion.duration)
        assert motion.run_out == motion.end.displacement


def test_nothing_is_nan() -> None:
    for scene in random_scenes(60):
        motion = solve(scene)
        states = motion.at(np.linspace(0.0, motion.duration, 101))
        assert all(np.all(np.isfinite(x)) for x in asdict(states).values())


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


def test_vaiont_frozen_runs_a_kilometre_in_half_a_minute() -> None:
    scene = load("vaiont-frozen")
    motion = solve(scene)
    compare(motion, Integration(scene, 30.0), np.linspace(0.0, 30.0, 61), 2e-12)
    assert 900.0 < motion.run_out < 1100.0
    assert motion.duration == 30.0
    assert not motion.arrested
