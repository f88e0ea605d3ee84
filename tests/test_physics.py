"""The physics of every effect and friction law: against independent integrations, closed forms and conservation.

References take their coefficients from quadrature of the raw definitions (`oracle`), write the balance of momentum
anew with its sign of omega and its clamp, and make the rest test at every standstill.
"""

import itertools
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import numpy as np
import oracle
import pytest
from flint import arb
from mpmath import mpf
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator
from scipy.optimize import brentq

from generated.effects import COMBINATIONS, LAWS
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
FRICTIONS = (*LAWS, "callable")


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
            3 * mpmath.pi / 2 - mpf(middle.numerator) / middle.denominator,
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
        return solve_ivp(self.rates, (first, t), y, method="DOP853", rtol=1e-13, atol=1e-20).y[:, -1] if t > first else y


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
        self.inertia, self.pressing, self.turning, self.factor = map(float, (c.inertia, c.pressing, c.turning, c.factor))
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
        end = math.inf if self.scene.end_time is None else self.scene.end_time / self.time_scale
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

    def _piece(self, time: float, end: float, phi: float, omega: float, slip: float, direction: int) -> tuple[float, ...]:
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
                terminal(lambda _, y, k=kink: slid(float(y[0])) - k, 1)
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
    travelled = max((abs(p.rotation) for p in reference.pieces), default=0.0) * reference.radius
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
        called["pore_pressure"] = {"ratio": ratio, "pressure": (carried - ratio) * static * reference} if carried > ratio else {"ratio": ratio}
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


@pytest.mark.parametrize("friction_name", FRICTIONS)
def test_every_combination_of_effects_against_numerical_integration(friction_name: str) -> None:
    for effects in COMBINATIONS:
        scene = combined_scene(effects, friction_name)
        reference = Integration(scene)
        if reference.upright is not None:
            with pytest.raises(ValueError, match="hang over"):
                solve(scene)
            scene = replace(scene, end_time=0.9 * reference.upright * reference.time_scale)
            reference = Integration(scene)
        motion = solve(scene)
        compare(motion, reference, 1e-10)
