"""The physics of every effect and friction law: against independent integrations, closed forms and conservation.

References take their coefficients from quadrature of the raw definitions (`oracle`), write the balance of momentum
anew with its sign of omega and its clamp, and make the rest test at every standstill.
"""

import itertools
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache, partial
from typing import Any

import golden
import mpmath
import numpy as np
import oracle
import pytest
from mpmath import mpf
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator
from scipy.optimize import brentq

from generated.effects import EFFECTS, LAWS
from slipcircle import Arc, Motion, Scene, solve

Floats = NDArray[np.float64]

VAIONT = Arc(1492.6, np.deg2rad(215.2), np.deg2rad(276.9), 20e3)
ARCS = {
    "vaiont": VAIONT,
    "leans back": Arc(1492.6, 3 * np.pi - np.deg2rad(276.9), 3 * np.pi - np.deg2rad(215.2), 20e3),
    "steep, wide": Arc(80.0, np.pi + 0.25, np.pi + 2.2, 18e3, gravity=3.7, width=7.0),
    "thin": Arc(5000.0, 4.2, 4.2001, 23e3),
    "half disc": Arc(12.0, np.deg2rad(190.0), np.deg2rad(370.0), 19e3),
    "nearly level": Arc(40.0, np.deg2rad(229.0), np.deg2rad(309.0), 21e3),
}
# What depends on position, and on speed by its square: the rest is in test_time_scenes.py.
LATER = {e for e, effect in EFFECTS.items() if {"time", "speed", "history"} & set(effect.depends_on)}
STEADY = [e for e in EFFECTS if e not in LATER]
COMBINATIONS = [c for n in range(len(STEADY) + 1) for c in itertools.combinations(STEADY, n)]
SLIP_LAWS = [n for n, law in LAWS.items() if not {"time", "speed"} & set(law.depends_on)]
FRICTIONS = (*SLIP_LAWS, "callable")


# --- the reference -------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Coefficients:
    """Of the equation of motion, from the definitions: to 50 digits, here as mpmath numbers."""

    inertia: mpf
    pressing: mpf  # C_r
    turning: mpf  # C_theta
    factor: mpf
    polar: mpf
    dip: mpf
    half: mpf
    time_scale: mpf
    radius: mpf
    gravity: mpf
    reference_stress: mpf

    @property
    def limit(self) -> mpf:
        """Dry limit friction, without cohesion."""
        return self.turning / self.pressing * mpmath.tan(self.dip)


@cache
def coefficients(arc: Arc) -> Coefficients:
    theta_1, theta_2 = Fraction(float(np.asarray(arc.theta_1))), Fraction(float(np.asarray(arc.theta_2)))
    half, middle = (theta_2 - theta_1) / 2, (theta_1 + theta_2) / 2
    with mpmath.workdps(50):

        def kernel(name: str) -> mpf:
            return mpf(oracle.kernel(name, half).str(50, radius=False))

        radius, gravity, unit_weight = (mpf(float(np.asarray(x))) for x in (arc.radius, arc.gravity, arc.unit_weight))
        alpha = min(mpf(half.numerator) / half.denominator, mpmath.pi / 2)
        return Coefficients(
            kernel("moment_of_inertia"),
            kernel("radial_weight_amplitude"),
            kernel("weight_moment_amplitude"),
            kernel("resistance_factor"),
            kernel("polar_moment"),
            abs(3 * mpmath.pi / 2 - mpf(middle.numerator) / middle.denominator),  # positive is down-slope
            alpha,
            mpmath.sqrt(radius / gravity),
            radius,
            gravity,
            unit_weight * radius * (1 - mpmath.cos(alpha)),
        )


@dataclass(frozen=True)
class Law:
    """Friction against slip in m, written anew, and the slips where it has kinks."""

    coefficient: Callable[[float], float]
    kinks: tuple[float, ...] = ()


def law(given: Any) -> Law:
    if callable(given):
        return Law(lambda s: float(given(np.asarray(s))))
    if not isinstance(given, Mapping):
        constant = float(given)
        return Law(lambda s: constant)
    if given["law"] == "constant":
        constant = float(given["coefficient"])
        return Law(lambda s: constant)
    if given["law"] == "tabulated":
        slip, values = np.asarray(given["slip"], dtype=float), np.asarray(given["coefficient"], dtype=float)
        slopes = PchipInterpolator(slip, values).derivative()(slip)
        slopes[-1] = 0.0  # constant from there on
        table, last = CubicHermiteSpline(slip, values, slopes), float(slip[-1])
        return Law(lambda s: float(table(min(s, last))), tuple(slip[1:].tolist()))
    peak, residual, length = given["peak"], given["residual"], given["length"]
    match given["law"]:
        case "exponential":
            return Law(lambda s: residual + (peak - residual) * math.exp(-s / length))
        case "linear":
            return Law(lambda s: peak - (peak - residual) * min(s / length, 1.0), (length,))
        case "hyperbolic":
            return Law(lambda s: residual + (peak - residual) * length / (length + s))
    raise AssertionError(given)


@dataclass
class Piece:
    """A stretch of the integration in one direction, and whether the clamp acts."""

    start: float
    stop: float
    direction: int
    slip: float
    rotation: float
    lifted: bool
    rates: Callable[[float, Floats], list[float]]
    steps: Any  # what solve_ivp returned

    def at(self, t: float) -> Floats:
        """phi and omega, integrated from the step before: interpolation is a thousand times worse than a step."""
        k = int(np.clip(np.searchsorted(self.steps.t, t, side="right") - 1, 0, len(self.steps.t) - 2))
        first, y = float(self.steps.t[k]), self.steps.y[:, k]
        return (
            solve_ivp(self.rates, (first, t), y, method="DOP853", rtol=1e-13, atol=1e-20).y[:, -1] if t > first else y
        )


@dataclass
class Integration:
    """DOP853 through the equation of motion; SI at the door, dimensionless inside.

    Theta* domega/dt = J_theta - sgn(omega) (lambda (c + mu max(0, sigma - u)) + d omega**2),
    sigma = J_r/lambda + A omega**2, J_theta = C_theta sin psi, J_r = C_r cos psi, psi = psi_0 - phi if it turns.
    """

    scene: Scene
    pieces: list[Piece] = field(default_factory=list)
    arrest: float | None = None
    upright: float | None = None
    peak: float = 0.0

    def __post_init__(self) -> None:
        c, effects = coefficients(self.scene.arc), self.scene.called
        self.inertia, self.pressing, self.turning, self.factor = map(
            float, (c.inertia, c.pressing, c.turning, c.factor)
        )
        self.dip, self.radius, self.time_scale = float(c.dip), float(c.radius), float(c.time_scale)
        self.reference_stress = float(c.reference_stress)
        self.turns = "rotation" in effects
        self.dynamic = float(c.polar / c.factor) if "centripetal" in effects else 0.0
        water = effects.get("pore_pressure", {})
        self.ratio, self.water = water.get("ratio", 0.0), water.get("pressure", 0.0) / self.reference_stress
        self.cohesion = effects.get("cohesion", {}).get("cohesion", 0.0) / self.reference_stress
        xi = effects.get("drag", {}).get("xi", math.inf)
        self.drag = float(2 * c.half * c.gravity / xi) if math.isfinite(xi) else 0.0
        self.law = law(self.scene.friction)
        self._integrate()

    def angle(self, phi: Any) -> Any:
        return self.dip - phi if self.turns else self.dip + 0.0 * phi

    def pressed(self, phi: Any, omega: Any) -> Any:
        """sigma* - u*, negative where water would carry the mass."""
        static = self.pressing / self.factor * np.cos(self.angle(phi))
        return static * (1 - self.ratio) - self.water + self.dynamic * omega * omega

    def resistance(self, phi: float, omega: float, slip: float) -> float:
        friction = self.law.coefficient(slip) * max(0.0, float(self.pressed(phi, omega)))
        return self.factor * (self.cohesion + friction) + self.drag * omega * omega

    def fall(self, phi: float) -> float:
        return self.turning * math.sin(self.angle(phi))

    def acceleration(self, phi: float, omega: float, slip: float, direction: int) -> float:
        return (self.fall(phi) - direction * self.resistance(phi, omega, slip)) / self.inertia

    def _integrate(self) -> None:
        ends = self.scene.end_time
        end = math.inf if ends is None else float(np.asarray(ends)) / self.time_scale
        omega = float(np.asarray(self.scene.initial_velocity)) / self.radius * self.time_scale
        phi = slip = time = 0.0
        while time < end:
            if omega == 0.0:
                if abs(self.fall(phi)) <= self.resistance(phi, 0.0, slip):
                    self.arrest = time
                    break
                direction = 1 if self.fall(phi) > 0.0 else -1
            else:
                direction = 1 if omega > 0.0 else -1
            time, phi, omega, slip = self._piece(time, min(end, time + 60.0), phi, omega, slip, direction)
            if self.upright is not None:
                break
            assert len(self.pieces) < 400, self.scene
        self.duration, self.final = time, phi

    def _piece(
        self, time: float, end: float, phi: float, omega: float, slip: float, direction: int
    ) -> tuple[float, ...]:
        begin = phi
        # Next to a change of sign, by where it goes, not by what rounding leaves of it.
        later = phi + 1e-7 * omega, omega + 1e-7 * self.acceleration(phi, omega, slip, direction)
        lifted = bool(self.pressed(*later) < 0.0)

        def slid(x: float) -> float:
            return slip + self.radius * abs(x - begin)

        def rates(_: float, y: Floats) -> list[float]:
            return [y[1], self.acceleration(float(y[0]), float(y[1]), slid(float(y[0])), direction)]

        events: list[Any] = []

        def terminal(function: Callable[[float, Floats], float], towards: int = 0) -> None:
            function.terminal, function.direction = True, towards  # type: ignore[attr-defined]
            events.append(function)

        terminal(lambda _, y: float(y[1]), -direction)
        terminal(lambda _, y: float(self.pressed(y[0], y[1])), 1 if lifted else -1)
        if self.turns:
            terminal(lambda _, y: math.pi / 2 - abs(self.angle(float(y[0]))), -1)
        for kink in self.law.kinks:
            if kink > slip * (1 + 1e-9):
                terminal(partial(lambda k, _, y: slid(float(y[0])) - k, kink), 1)
        done = solve_ivp(rates, (time, end), [phi, omega], method="DOP853", events=events, rtol=1e-13, atol=1e-20)
        assert done.success, done.message
        stop, (phi, omega) = float(done.t[-1]), done.y[:, -1].tolist()
        piece = Piece(time, stop, direction, slip, begin, lifted, rates, done)
        self.peak = max(self.peak, self._fastest(piece))
        if done.status == 1:
            phi, omega = map(float, piece.at(stop))
            if len(done.t_events[0]):
                for _ in range(4):  # Newton's steps from the event, which the interpolation places to its own order
                    rate = self.acceleration(phi, omega, slid(phi), direction)
                    step = -omega / rate
                    stop, phi, omega = stop + step, phi + omega * step / 2, omega + step * rate
                omega = 0.0
            elif self.turns and len(done.t_events[2]):
                self.upright = stop
        piece.stop = stop
        self.pieces.append(piece)
        return stop, phi, omega, slid(phi)

    def _fastest(self, piece: Piece) -> float:
        """The greatest |omega|: where the acceleration changes its sign."""
        times, states, direction = piece.steps.t, piece.steps.y, piece.direction

        def slope(t: float) -> float:
            return direction * piece.rates(t, piece.at(t))[1]

        k = int(np.argmax(direction * states[1]))
        greatest = float(direction * states[1, k])
        for first, last in itertools.pairwise(times[max(k - 1, 0) : k + 2].tolist()):
            if slope(first) > 0.0 > slope(last):
                greatest = max(greatest, direction * float(piece.at(brentq(slope, first, last))[1]))
        return greatest

    def at(self, times: Floats) -> dict[str, Floats]:
        t = times / self.time_scale
        phi, omega, rate = np.full(t.shape, self.final), np.zeros_like(t), np.zeros_like(t)
        for p in self.pieces:
            inside = (t >= p.start) & ((t < p.stop) | ((self.arrest is None) & (p is self.pieces[-1])))
            for i in np.flatnonzero(inside):
                phi[i], omega[i] = p.at(float(t[i]))
                slip = p.slip + self.radius * abs(phi[i] - p.rotation)
                rate[i] = self.acceleration(float(phi[i]), float(omega[i]), slip, p.direction)
        stress = self.pressing / self.factor * np.cos(self.angle(phi)) + self.dynamic * omega**2
        return {
            "rotation": phi,
            "angular_velocity": omega / self.time_scale,
            "velocity": self.radius * omega / self.time_scale,
            "displacement": self.radius * phi,
            "acceleration": self.radius * rate / self.time_scale**2,
            "normal_stress": self.reference_stress * stress,
        }

    @property
    def lift_off(self) -> list[float]:
        """When the clamp begins to act, s."""
        before = [False, *(p.lifted for p in self.pieces)]
        return [p.start * self.time_scale for p, was in zip(self.pieces, before, strict=False) if p.lifted and not was]


def size(found: Any) -> float:
    return float(np.max(np.abs(found), initial=0.0))


def compare(motion: Motion, reference: Integration, tolerance: float) -> float:
    """The worst error of any quantity, relative to the largest value of the quantity."""
    scene = motion.plan.scene
    assert motion.arrested == (reference.arrest is not None), scene
    scale, worst = reference.time_scale, 0.0
    pairs = {
        "duration": (motion.duration, reference.duration * scale),
        "run-out": (motion.run_out, reference.final * reference.radius),
        "peak": (abs(float(motion.peak.velocity)), reference.peak * reference.radius / scale),
    }
    travelled = max(abs(reference.final), *(abs(p.rotation) for p in reference.pieces), 0.0) * reference.radius
    for name, (found, expected) in pairs.items():
        error = abs(found - expected) / ((travelled if name == "run-out" else abs(expected)) or 1.0)
        assert error <= tolerance, f"{scene}: {name} {found!r} instead of {expected!r}, {error:.2g}"
        worst = max(worst, error)
    times = np.linspace(0.0, motion.duration, 23)[1:-1]
    ends = np.array([p.stop * scale for p in reference.pieces])
    times = times[[np.min(np.abs(ends - t), initial=math.inf) > 1e-6 * motion.duration for t in times]]
    state = motion.at(times)
    for name, values in reference.at(times).items():
        error = size(np.asarray(getattr(state, name)) - values) / (size(values) or 1.0)
        assert error <= tolerance, f"{scene}: {name} is wrong by {error:.2g}"
        worst = max(worst, error)
    return worst


# --- every combination of effects, with every friction law ---------------------------------------------------------


def friction_law(name: str, low: float, high: float, length: float) -> Any:
    """A law of that name which falls from high to low over some length in m."""
    if name == "constant":
        return low
    if name == "tabulated":
        return {
            "law": name,
            "slip": [0.0, 0.3 * length, length, 2.5 * length],
            "coefficient": [high, low + 0.8 * (high - low), low + 0.3 * (high - low), low],
        }
    if name == "callable":
        return lambda slip: low + (high - low) * np.exp(-((slip / length) ** 2))
    return {"law": name, "peak": high, "residual": low, "length": length}


def combined_scene(effects: tuple[str, ...], friction_name: str, seed: int = 31) -> Scene:
    """A scene of an arc, a start and parameters drawn so that every effect matters."""
    rng = np.random.default_rng([seed, FRICTIONS.index(friction_name), list(COMBINATIONS).index(effects)])
    arc = ARCS[rng.choice(list(ARCS))]
    c = coefficients(arc)
    limit = abs(float(c.limit))
    static = float(c.pressing * mpmath.cos(c.dip) / c.factor)  # over the reference stress
    reference = float(c.reference_stress)
    called: dict[str, dict[str, float]] = {e: {} for e in effects}
    carried = float(rng.choice([0.2, 0.6, 1.1]))  # of the static stress; above 1 water carries the mass
    if "pore_pressure" in called:
        ratio = float(rng.choice([0.0, 0.3]))
        called["pore_pressure"] = (
            {"ratio": ratio, "pressure": (carried - ratio) * static * reference}
            if carried > ratio
            else {"ratio": ratio}
        )
    if "cohesion" in called:
        called["cohesion"] = {"cohesion": float(rng.uniform(0.05, 0.3)) * limit * static * reference}
    if "drag" in called:
        called["drag"] = {"xi": float(2 * c.half * c.gravity / c.inertia / rng.uniform(0.1, 3.0))}
    low, high = limit * rng.uniform(0.15, 0.5), limit * rng.uniform(0.6, 0.9)
    length = float(c.radius) * 10 ** rng.uniform(-2.5, -0.5)
    unit = float(mpmath.sqrt(c.radius * c.gravity))
    start = float(rng.choice([0.0, 0.4, -0.4])) * unit
    rests = "rotation" in called and ("cohesion" in called or "pore_pressure" not in called or carried < 1.0)
    end_time = None if rests else float(rng.uniform(2.0, 6.0) * c.time_scale)
    return Scene(arc, friction_law(friction_name, low, high, length), called, start, end_time)


def residual(motion: Motion, count: int = 21) -> float:
    """The worst energy residual at any time, relative to all energy there was until then.

    Until then, not just then: a pendulum at its far standstill has neither speed nor work.
    """
    energy = motion.energy_at(np.linspace(0.0, motion.duration, count))
    total = np.maximum.accumulate(energy.kinetic_start + np.abs(energy.work) + energy.dissipation)
    assert np.all(energy.dissipation >= 0.0)
    return size(np.asarray(energy.residual)[total > 0.0] / total[total > 0.0])


@pytest.mark.parametrize("friction_name", FRICTIONS)
def test_every_combination_of_effects_against_numerical_integration(friction_name: str) -> None:
    """Run-out, peak, duration, states at any time, lift-off, and the energy balance at every time."""
    for effects in COMBINATIONS:
        scene = combined_scene(effects, friction_name)
        reference = Integration(scene)
        if reference.upright is not None:
            with pytest.raises(ValueError, match="hang over"):
                solve(scene)
            scene = replace(scene, end_time=0.9 * reference.upright * reference.time_scale)
            reference = Integration(scene)
        motion = solve(scene)
        compare(motion, reference, 2e-11)
        assert residual(motion) <= 1e-12, scene
        assert np.isfinite(motion.error_estimate)
        assert len(motion.lift_off) == len(reference.lift_off), scene
        np.testing.assert_allclose(motion.lift_off, reference.lift_off, rtol=1e-9)
        assert all(any(f"{t:.6g} s (lift-off)" in w for w in motion.warnings) for t in motion.lift_off)


# --- rest is an answer ---------------------------------------------------------------------------------------------


def rested_scenes() -> Iterator[Scene]:
    """From rest, every combination of effects, on any arc; the constant friction is to be replaced."""
    for seed, effects in itertools.product(range(4), COMBINATIONS):
        yield replace(combined_scene(effects, "constant", 100 + seed), initial_velocity=0.0, end_time=None)


def test_rest_and_the_printed_limit_agree_to_the_last_bit() -> None:
    for scene in rested_scenes():
        given = replace(scene, end_time=1.0)
        limit = solve(given).limit_friction
        if not 0.0 < limit < np.inf:  # cohesion holds it without friction, or water carries it
            assert solve(given).moves == (limit > 0.0)
            continue
        frozen = "rotation" not in scene.effects
        below = replace(
            scene, friction=float(np.nextafter(limit, 0.0)), end_time=scene.end_time or (1.0 if frozen else None)
        )
        for mu, moves in ((limit, False), (np.nextafter(limit, np.inf), False), (np.nextafter(limit, 0.0), True)):
            motion = solve(replace(below, friction=float(mu)))
            assert motion.moves == moves, scene
            assert motion.limit_friction == limit
            assert motion.factor_of_safety == pytest.approx(1.0, abs=1e-14)
            assert abs(motion.yield_coefficient) < 1e-14
            assert (motion.yield_coefficient < 0.0) == moves
            if not moves:
                assert (motion.arrested, motion.duration, motion.run_out) == (True, 0.0, 0.0)


def test_limit_safety_and_yield_from_the_definitions() -> None:
    """F = lambda (c + mu (sigma - u))/|J_theta|; k_y where the tilted balance just holds, by its definition."""
    for scene in rested_scenes():
        c, motion = coefficients(scene.arc), solve(replace(scene, end_time=1.0))
        reference = Integration(replace(scene, end_time=1e-3))
        mu, side = float(np.asarray(scene.friction)), 1.0 if reference.dip >= 0.0 else -1.0
        fall = side * reference.fall(0.0)
        assert motion.factor_of_safety == pytest.approx(reference.resistance(0.0, 0.0, 0.0) / fall, rel=1e-12)
        carried = reference.ratio * reference.pressing * math.cos(reference.dip) + reference.factor * reference.water

        def excess(
            k: float, c: Coefficients = c, r: Integration = reference, carried: float = carried, mu: float = mu
        ) -> float:
            dip = abs(r.dip)
            pressing = r.pressing * (math.cos(dip) - k * math.sin(dip)) - carried
            return r.turning * (math.sin(dip) + k * math.cos(dip)) - r.factor * r.cohesion - mu * max(0.0, pressing)

        expected = float(brentq(excess, -100.0, 100.0, xtol=1e-15))
        assert motion.yield_coefficient == pytest.approx(expected, rel=1e-10, abs=1e-13), scene
        if not np.isfinite(motion.limit_friction):
            continue
        limit = (c.turning * mpmath.sin(abs(c.dip)) - c.factor * reference.cohesion) / (
            c.pressing * mpmath.cos(c.dip) - carried
        )
        assert motion.limit_friction == pytest.approx(float(limit), rel=1e-9, abs=1e-12), scene


@pytest.mark.parametrize("ulps", [1, 2, 1000])
@pytest.mark.parametrize("name", ARCS)
def test_just_below_the_limit_the_swing_is_small_and_takes_half_a_period(name: str, ulps: int) -> None:
    """tan(x/2) = drive/tilt with the drive from the exact difference of the two doubles; duration pi sqrt(Theta*/K)."""
    arc = ARCS[name]
    limit = abs(float(arc.dimensionless.limit_friction))
    mu = limit
    for _ in range(ulps):
        mu = float(np.nextafter(mu, 0.0))
    for effects in (("rotation",), ("rotation", "centripetal")):
        motion, c = solve(Scene(arc, mu, effects)), coefficients(arc)
        excess = Fraction(limit) - Fraction(mu)
        with mpmath.workdps(40):
            pressing, turning, dip = c.pressing * mpmath.cos(c.dip), c.turning * mpmath.cos(c.dip), abs(c.dip)
            drive = mpf(excess.numerator) / excess.denominator * pressing
            tilt = turning + mpf(mu) * c.pressing * mpmath.sin(dip)
            swing = 2 * mpmath.atan(drive / tilt) * c.radius
            duration = mpmath.pi * mpmath.sqrt(c.inertia / tilt) * c.time_scale
        assert motion.moves
        assert motion.arrested
        assert abs(motion.run_out) == pytest.approx(float(swing), rel=1e-11)
        assert motion.duration == pytest.approx(float(duration), rel=1e-11)


# --- checks that no one here made up -------------------------------------------------------------------------------


def dipping(dip: float, half: float, radius: float = 300.0) -> Arc:
    middle = 1.5 * np.pi - dip
    return Arc(radius, middle - half, middle + half, 21e3)


DIPS = (1e-6, 1e-3, 0.1, 0.5, 1.0, 1.3, 1.57)


@pytest.mark.parametrize("half", [1e-6, 0.01, 0.54, 1.5])
@pytest.mark.parametrize("dip", [*DIPS, -0.7])
def test_without_friction_it_is_a_pendulum(dip: float, half: float) -> None:
    """Half a period of the pendulum of length Theta*/C_theta, by the elliptic integral; to the mirrored dip."""
    arc = dipping(dip, half)
    motion, c = solve(Scene(arc, 0.0, ("rotation",))), coefficients(arc)
    with mpmath.workdps(40):
        duration = 2 * mpmath.sqrt(c.inertia / c.turning) * mpmath.ellipk(mpmath.sin(c.dip / 2) ** 2) * c.time_scale
        peak = mpmath.sqrt(4 * c.turning / c.inertia) * mpmath.sin(abs(c.dip) / 2) * c.radius / c.time_scale
    assert not motion.arrested
    assert motion.duration == pytest.approx(float(duration), rel=2e-14)
    assert motion.run_out == pytest.approx(float(2 * c.dip * c.radius), rel=2e-14)
    assert abs(motion.peak.velocity) == pytest.approx(float(peak), rel=2e-14)
    assert motion.peak.displacement == pytest.approx(motion.run_out / 2, rel=1e-7)
    assert residual(motion) < 1e-13


@pytest.mark.parametrize("half", [1e-6, 0.01, 0.54, 1.5])
@pytest.mark.parametrize("dip", [d for d in DIPS if d < 1.5])
def test_constant_friction_tilts_the_pendulum(dip: float, half: float) -> None:
    """Gravity tilted by delta = arctan(mu C_r/C_theta): stop angle 2 (psi_0 - delta), and back: mu from the run-out."""
    arc = dipping(dip, half)
    c = coefficients(arc)
    limit = float(c.limit)
    for share in (1e-9, 1e-3, 0.3, 0.9, 1 - 1e-3, 1 - 1e-6):
        mu = limit * share
        motion = solve(Scene(arc, mu, ("rotation",), end_time=30 * float(c.time_scale)))  # at least the first swing
        with mpmath.workdps(40):
            delta = mpmath.atan(mpf(mu) * c.pressing / c.turning)
            strength = mpmath.hypot(c.turning, mpf(mu) * c.pressing)
            modulus = mpmath.sin((c.dip - delta) / 2) ** 2
            duration = 2 * mpmath.sqrt(c.inertia / strength) * mpmath.ellipk(modulus) * c.time_scale
            stop = float(2 * (c.dip - delta) * c.radius)
            swings = golden.changes(motion, 120, 1)
            first = swings[0][0] if swings else motion.duration
            condition = 1 / (1 - share)
            found = float(motion.at(first).displacement)
            assert found == pytest.approx(stop, rel=4e-15 * condition + 2e-14), share
            assert first == pytest.approx(float(duration), rel=4e-14), share
            back = mpmath.tan(c.dip - mpf(found) / (2 * c.radius)) * c.turning / c.pressing
        if share > 1e-6:
            assert float(back) == pytest.approx(mu, rel=1e-13 / share + 1e-13)


@pytest.mark.parametrize("half", [1e-3, 1e-5, 1e-7])
def test_a_thin_arc_is_a_block_on_an_incline(half: float) -> None:
    """From the definitions, as alpha -> 0: all of the mass at r = 1, its mean thickness alpha**2 R/3, its slope psi.

    dv/dt = g sin psi - mu (g cos psi - p/(rho h)) - c/(rho h) - g v**2/(xi h), to O(alpha**2).
    """
    dip, unit_weight, gravity = 0.5, 2e4, 9.81
    radius = 1e4 / half**2
    arc = Arc(radius, 1.5 * np.pi - dip - half, 1.5 * np.pi - dip + half, unit_weight, gravity)
    alpha = float(np.subtract(arc.theta_2, arc.theta_1)) / 2  # as rounded
    dip = float(arc.dip)
    thickness = alpha**2 * radius / 3
    density = unit_weight / gravity
    weight, mu = density * thickness * gravity, 0.2
    pressure, cohesion, xi = 0.3 * weight, 0.02 * weight, 800.0
    effects = {"pore_pressure": {"pressure": pressure}, "cohesion": {"cohesion": cohesion}, "drag": {"xi": xi}}
    static = mu * (gravity * math.cos(dip) - pressure / (density * thickness)) + cohesion / (density * thickness)
    a, b, time = gravity * math.sin(dip) - static, gravity / (xi * thickness), 12.0
    motion = solve(Scene(arc, mu, effects, end_time=time))
    tolerance = 2 * half**2 + 1e-9
    speed, rate = math.sqrt(a / b), math.sqrt(a * b)
    assert motion.end.velocity == pytest.approx(speed * math.tanh(rate * time), rel=tolerance)
    assert motion.run_out == pytest.approx(math.log(math.cosh(rate * time)) / b, rel=tolerance)
    braked = solve(Scene(arc, 1.5, (), initial_velocity=20.0))
    deceleration = gravity * (1.5 * math.cos(dip) - math.sin(dip))
    assert braked.run_out == pytest.approx(20.0**2 / (2 * deceleration), rel=tolerance)
    assert braked.duration == pytest.approx(20.0 / deceleration, rel=tolerance)
    # Curvature adds v**2/R, and turns the slope by s/R: little, on such a radius.
    full = solve(Scene(arc, 1.5, ("rotation", "centripetal"), initial_velocity=20.0))
    assert full.run_out == pytest.approx(braked.run_out, rel=1e-2 * half**2 + tolerance)


# --- symmetries ----------------------------------------------------------------------------------------------------


def scaled(scene: Scene, density: float, gravity: float, length: float) -> Scene:
    """The same scene of another density, gravity and size: stresses and speeds follow."""
    arc = scene.arc
    weight = density * gravity
    called = {}
    for name, parameters in scene.called.items():
        called[name] = dict(parameters)
        for key, factor in (("pressure", weight * length), ("cohesion", weight * length), ("xi", gravity)):
            if key in parameters:
                called[name][key] = parameters[key] * factor
    friction = scene.friction
    if isinstance(friction, Mapping):
        friction = {k: np.multiply(v, length) if k in ("length", "slip") else v for k, v in friction.items()}
    speed = math.sqrt(gravity * length)
    end = None if scene.end_time is None else np.multiply(scene.end_time, math.sqrt(length / gravity))
    larger = replace(
        arc,
        radius=np.multiply(arc.radius, length),
        unit_weight=np.multiply(arc.unit_weight, weight),
        gravity=np.multiply(arc.gravity, gravity),
    )
    return replace(scene, arc=larger, friction=friction, effects=called, end_time=end,
                   initial_velocity=np.multiply(scene.initial_velocity, speed))  # fmt: skip


def test_density_gravity_and_size_only_scale() -> None:
    for effects, friction_name in zip(COMBINATIONS, itertools.cycle(SLIP_LAWS), strict=False):
        scene = replace(combined_scene(effects, friction_name, 7), end_time=20.0)
        try:
            one = solve(scene)
        except ValueError:
            continue  # turns over
        times = np.linspace(0.05, 0.95, 7) * one.duration
        for density, gravity, length in ((1.5, 1.0, 1.0), (1.0, 0.25, 1.0), (1.0, 1.0, 16.0), (0.7, 0.3, 3.0)):
            other = solve(scaled(scene, density, gravity, length))
            stretch = math.sqrt(length / gravity)
            assert other.arrested == one.arrested
            assert other.duration == pytest.approx(stretch * one.duration, rel=1e-12)
            assert other.run_out == pytest.approx(length * one.run_out, rel=1e-10)
            # Where a phase changes, the acceleration jumps: positions and speeds are compared.
            state, same = one.at(times), other.at(stretch * times)
            np.testing.assert_allclose(
                same.displacement, length * state.displacement, rtol=0, atol=1e-10 * length * size(state.displacement)
            )
            np.testing.assert_allclose(
                same.velocity, length / stretch * state.velocity, rtol=0, atol=1e-10 * size(same.velocity)
            )


@pytest.mark.parametrize("effects", [("rotation",), ("rotation", "centripetal")])
@pytest.mark.parametrize("velocity", [0.0, 5.0, -8.0])
def test_without_friction_the_motion_runs_back(effects: tuple[str, ...], velocity: float) -> None:
    """Reversed at any moment, it returns to where it came from with the speed that it had, reversed."""
    arc = dipping(0.6, 0.4)
    there = solve(Scene(arc, 0.0, effects, velocity, end_time=9.0))
    for time in (0.5, 3.0, 9.0):
        state = there.at(time)
        first, last = (np.add(theta, state.rotation) for theta in (arc.theta_1, arc.theta_2))
        turned = replace(arc, theta_1=first, theta_2=last)
        way = turned.facing  # beyond the lowest point down-slope is back
        back = solve(Scene(turned, 0.0, effects, -way * float(state.velocity), end_time=time))
        assert way * back.run_out == pytest.approx(-float(state.displacement), rel=1e-12)
        assert way * back.end.velocity == pytest.approx(-velocity, abs=1e-11)


def test_a_mirrored_slide_does_the_same() -> None:
    for effects, friction_name in zip(COMBINATIONS, itertools.cycle(FRICTIONS), strict=False):
        scene = replace(combined_scene(effects, friction_name, 8), end_time=15.0)
        arc = scene.arc
        assert isinstance(arc, Arc)
        mirrored = replace(
            arc, theta_1=3 * np.pi - np.asarray(arc.theta_2), theta_2=3 * np.pi - np.asarray(arc.theta_1)
        )
        opposite = replace(scene, arc=mirrored)
        try:
            one = solve(scene)
        except ValueError:
            with pytest.raises(ValueError, match="hang over"):
                solve(opposite)
            continue
        other = solve(opposite)
        assert other.arrested == one.arrested
        assert other.duration == pytest.approx(one.duration, rel=1e-9)
        assert other.run_out == pytest.approx(one.run_out, rel=1e-8)
        assert other.peak.velocity == pytest.approx(one.peak.velocity, rel=1e-9)


# --- peak, arrest, friction, lift-off ------------------------------------------------------------------------------


def test_peak_and_arrest_are_located() -> None:
    """No sample is faster than the peak; there the drive is used up; the arrest is a standstill, and the last."""
    for effects, friction_name in itertools.product(COMBINATIONS, ("constant", "hyperbolic")):
        scene = combined_scene(effects, friction_name, 9)
        scene = scene if scene.end_time else replace(scene, end_time=300.0)
        try:
            motion = solve(scene)
        except ValueError:
            continue  # turns over
        if not motion.moves:
            continue
        dense = motion.at(np.linspace(0.0, motion.duration, 2001))
        peak = abs(float(motion.peak.velocity))
        assert np.max(np.abs(dense.velocity)) <= peak * (1 + 4e-15)
        if 0.0 < motion.peak.time < motion.duration:
            assert abs(motion.peak.acceleration) <= 1e-9 * np.max(np.abs(dense.acceleration)), scene
        if motion.arrested:
            assert motion.end.velocity == 0.0
            assert motion.at(motion.duration * (1 - 1e-9)).velocity != 0.0
            late = motion.at([motion.duration, 2 * motion.duration, 1e9])
            assert np.all(late.displacement == motion.run_out)
            assert not np.any(late.velocity)
            assert not np.any(late.acceleration)


def test_friction_never_drives() -> None:
    """What is not gravity opposes the motion, at every time; what rests stays only where the resistance holds it."""
    for effects, friction_name in itertools.product(COMBINATIONS, ("constant", "tabulated")):
        scene = combined_scene(effects, friction_name, 10)
        scene = scene if scene.end_time else replace(scene, end_time=200.0)
        try:
            motion = solve(scene)
        except ValueError:
            continue  # turns over
        reference = Integration(replace(scene, end_time=1e-9))  # for its functions
        state = motion.at(np.linspace(0.0, motion.duration, 301)[:-1])
        gravity = np.array([reference.fall(float(x)) for x in state.rotation]) / reference.inertia
        resisting = state.acceleration * reference.time_scale**2 / reference.radius - gravity
        assert np.all(resisting * np.sign(state.velocity) <= 1e-13), scene
        if motion.arrested:
            places = [*(p.rotation for p in motion.phases), float(motion.end.rotation)]
            slip = reference.radius * sum(abs(b - a) for a, b in itertools.pairwise(places))
            holds = reference.resistance(float(motion.end.rotation), 0.0, slip)
            assert abs(reference.fall(float(motion.end.rotation))) <= holds * (1 + 1e-12)


def test_where_water_carries_the_mass_friction_does_nothing() -> None:
    """Its weight alone moves it; the time is reported, and friction of any size makes no difference."""
    c = coefficients(VAIONT)
    static = VAIONT.static_normal_stress
    for mu in (0.0, 0.3, 50.0):
        scene = Scene(VAIONT, mu, {"pore_pressure": {"pressure": 1.01 * static}}, end_time=10.0)
        motion = solve(scene)
        acceleration = float(c.turning * mpmath.sin(c.dip) / c.inertia * c.gravity)
        assert motion.lift_off == (0.0,)
        assert motion.run_out == pytest.approx(acceleration * 50.0, rel=1e-14)
        assert motion.energy.dissipation == 0.0
        assert motion.limit_friction == np.inf
        assert motion.factor_of_safety == 0.0
        assert any("lift-off" in w for w in motion.warnings)
    dry = solve(replace(scene, friction=0.1, effects={"pore_pressure": {"pressure": 0.99 * static}}))
    assert dry.lift_off == ()
    assert dry.energy.dissipation > 0.0


def test_a_short_flight_between_samples_is_found() -> None:
    """Water lifts the mass only where it turns up-slope, for a moment that is as short as one likes."""
    arc = dipping(0.3, 0.5)
    static = float(arc.static_normal_stress)
    base = Scene(arc, 0.0, ("rotation",), initial_velocity=30.0, end_time=6.0)
    lowest = float(np.cos(np.max(np.abs(0.3 - solve(base).at(np.linspace(0, 6, 4001)).rotation))) / np.cos(0.3))
    for above in (1e-2, 1e-4, 1e-6):
        wet = replace(base, effects={"rotation": {}, "pore_pressure": {"pressure": static * lowest * (1 + above)}})
        motion, reference = solve(wet), Integration(wet)
        assert len(motion.lift_off) == len(reference.lift_off) >= 1
        np.testing.assert_allclose(motion.lift_off, reference.lift_off, rtol=1e-9)
