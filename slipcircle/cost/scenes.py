"""What solving scenes costs: this package beside DOP853 and heyoka, each judged by answers to 24 digits.

One equation of motion, (3.11) with (2.20), written out once by hand over any arithmetic, serves every other way: over
floats SciPy's, over heyoka's expressions heyoka's. The answers are the tests' Taylor series in ball arithmetic.
"""

import json
import math
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from generated import kernels
from slipcircle.base.series import Series
from slipcircle.cost.reference import Answers, Floats
from slipcircle.cost.ways import Subject, Way
from slipcircle.files.scenefile import load
from slipcircle.flow import compiled, walk
from slipcircle.flow.lanes import walked
from slipcircle.motion.motion import Motion, kept
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import lanes_of, solve
from slipcircle.scene.arc import Arc
from slipcircle.scene.scene import Scene

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)
TOLERANCES = (*ACCURACIES[:-1], 1e-13)  # of SciPy, which grants no less
ANGLES = (10.0, 14.0, 19.5)  # of friction, deg: the first and last of an ensemble, and between them that of one scene
RESIDUAL, LENGTH, SPEED = float(np.tan(np.radians(8.0))), 1.0, 5.0  # of the laws: "", m, m/s
LAYER = {"pressurisation": 4e3, "heat_capacity": 2.7e6, "thickness": 0.5}  # Pa/K, J/m^3 K, m: it stays pressed
SHEARED = {"viscosity": 2e3, "thickness": 0.5}  # Pa s, m: it takes a sixth of the speed in the unit of time
SAMPLES, SAMPLED = 4000, 20.0  # of the record: how many, and until when, s
BATCH = 32  # lanes of heyoka at once: as many as still gain
# Run-out, peak velocity and duration by friction, of one scene and then of an ensemble's lanes, to 24 digits;
# ``python tests/exact_scenes.py`` writes them.
ANSWERS = Path(__file__).with_name("answers.json")
_LATEST = 1e3  # standstill, dimensionless
PATIENCE = 5.0  # of a pass over scenes, as of `Subject`


@cache
def record() -> tuple[Floats, Floats]:
    """Times and k_h of a record: twelve sines under an envelope, sampled; straight lines between."""
    rng, time = np.random.default_rng(1963), np.linspace(0.0, SAMPLED, SAMPLES)
    waves = np.sin(time[:, None] * rng.uniform(3.0, 40.0, 12) + rng.uniform(0.0, 6.3, 12)).sum(axis=1)
    return time, 0.01 * waves * np.sin(np.pi * time / SAMPLED) ** 2


class Case(NamedTuple):
    """A scene of the price list, and what its equation of motion has."""

    shipped: str = "vaiont"
    softens: bool = False
    weakens: bool = False
    heats: bool = False
    shears: bool = False
    shakes: bool = False

    def scene(self, mu: Any) -> Scene:
        scene, friction, more = _shipped(self.shipped), mu, dict[str, Any]()
        if self.softens:
            friction = {"law": "exponential", "peak": mu, "residual": RESIDUAL, "length": LENGTH}
        if self.weakens:
            friction = {"law": "rate_weakening", "peak": mu, "residual": RESIDUAL, "velocity": SPEED}
        if self.heats:
            more["thermal_pressurisation"] = LAYER
        if self.shears:
            more["viscosity"] = SHEARED
        if self.shakes:
            time, k_h = record()
            more["shaking"] = {"horizontal": Series(time, k_h)}
        return replace(scene, friction=friction, effects={**scene.called, **more})


_shipped = cache(load)


@cache
def _one(case: Case, mu: float) -> Scene:
    return case.scene(mu)


CASES = {
    "closed form": Case("vaiont-frozen"),
    "constant friction": Case(),
    "softening": Case(softens=True),
    "rate weakening": Case(weakens=True),
    "heat": Case(heats=True),
    "viscosity": Case(shears=True),
    "record": Case(shakes=True),
}


# --- the equation of motion by hand ----------------------------------------------------------------------------------


class Equation:
    """The numbers of a scene's equation of motion, and its rates over the arithmetic of a module m."""

    def __init__(self, case: Case, m: Any = math) -> None:
        scene = case.scene(0.1)
        arc, end = scene.arc, scene.end_time
        assert isinstance(arc, Arc)
        self.case, self.m, self.end = case, m, None if end is None else float(end / arc.time_scale)
        names = ("weight_moment_per_inertia", "radial_weight_per_inertia", "polar_moment_per_inertia")
        self.weight, self.radial, self.polar = (float(getattr(kernels, n)(arc.half_angle)) for n in names)
        self.dip, self.radius, self.scale = float(arc.dip), float(np.asarray(arc.radius)), float(arc.time_scale)
        self.decay, self.pace = self.radius / LENGTH, self.radius / self.scale / SPEED
        self.kappa = self.radius * LAYER["pressurisation"] / LAYER["heat_capacity"] / LAYER["thickness"]
        sheared = 2.0 * float(arc.half_angle) / float(kernels.moment_of_inertia(arc.half_angle)) if case.shears else 0.0
        weight, pace = float(np.asarray(arc.unit_weight)), self.scale * SHEARED["thickness"]
        self.viscous = sheared * SHEARED["viscosity"] / (weight * pace)

    def start(self) -> list[Any]:
        """Rotation, angular velocity, and under heat the effective normal force."""
        return [0.0, 0.0, *([self.radial * math.cos(self.dip)] if self.case.heats else [])]

    def rate(self, mu: Any, y: Any, k_h: Any = None) -> list[Any]:
        """The states' derivatives by dimensionless time."""
        m, omega = self.m, y[1]
        psi = self.dip if self.case.shipped == "vaiont-frozen" else self.dip - y[0]
        sin, cos = (m.sin(psi), m.cos(psi))
        if self.case.softens:
            mu = RESIDUAL + (mu - RESIDUAL) * m.exp(-self.decay * y[0])
        if self.case.weakens:
            mu = RESIDUAL + (mu - RESIDUAL) / (1.0 + self.pace * omega)
        drive, press = self.weight * sin, self.radial * cos
        if k_h is not None:
            drive, press = drive + self.weight * k_h * cos, press - self.radial * k_h * sin
        if not self.case.heats:
            return [omega, drive - mu * (press + self.polar * omega * omega) - self.viscous * omega]
        rate = drive - mu * y[2]
        return [omega, rate, (self.radial * sin + 2.0 * self.polar * rate - self.kappa * mu * y[2]) * omega]


def answer(of: Equation, phi: Any, omega: Any, time: Any) -> tuple[Any, Any, Any]:
    """Run-out, peak velocity and duration, m, m/s, s."""
    return of.radius * phi, of.radius * omega / of.scale, time * of.scale


# --- ways ------------------------------------------------------------------------------------------------------------


def ours(case: Case, accuracy: float, walker: Any, mu: Any) -> Floats:
    """By this package: as `solve` does it, or with a walk of one's own choice."""
    scene = case.scene(mu) if np.size(mu) > 1 else _one(case, float(np.squeeze(mu)))
    if walker is None:
        motion = solve(scene, accuracy)
    else:
        lanes = lanes_of(chosen := plan(scene, accuracy))
        motion = Motion(chosen, lanes, kept(walked(lanes.bound, lanes.closed, walker=walker), not scene.shape), [])
    return np.array([motion.outcomes[n] for n in ("run_out", "peak_velocity", "duration")]).reshape(3, -1)


def dop853(case: Case, tolerance: float, mu: Any) -> Floats:
    """By SciPy's DOP853, scene after scene, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    of, (times, k_h) = _equation(case), record()

    def one(friction: float) -> tuple[Any, Any, Any]:
        def rate(t: float, y: Any) -> list[Any]:
            return of.rate(friction, y, float(np.interp(t * of.scale, times, k_h)) if case.shakes else None)

        def stands(_: float, y: Any) -> float:
            return float(y[1])

        def slows(t: float, y: Any) -> float:
            return float(rate(t, y)[1])

        vars(stands).update(terminal=of.end is None, direction=-1.0)
        vars(slows).update(direction=-1.0)
        found = solve_ivp(rate, (0.0, of.end or _LATEST), of.start(), "DOP853", rtol=tolerance, atol=1e-3 * tolerance,
                          events=[stands, slows])  # fmt: skip
        peaks = found.y[1] if case.shakes else [*(y[1] for y in found.y_events[1]), found.y[1, -1]]
        return answer(of, found.y[0, -1], max(peaks), found.t[-1])

    return np.array([one(x) for x in np.atleast_1d(mu).tolist()]).T


@cache
def _equation(case: Case) -> Equation:
    return Equation(case)


def heyoka(case: Case, tolerance: float, lanes: int, mu: Any) -> Floats:
    """By heyoka's Taylor series: so many neighbouring frictions at once, all but the peak.

    The peak would take a call of Python from each lane, so that it is spared it.
    """
    of, system = _compiled(case, tolerance, lanes)
    mu = np.atleast_1d(mu)
    found = np.full((3, mu.size), np.nan)
    for first in range(0, mu.size, lanes):
        part = mu[first : first + lanes]
        system.set_time(0.0)
        system.state[:], system.pars[0] = np.array(of.start())[:, None], np.resize(part, lanes)
        if of.end is None:
            system.reset_cooldowns()
        until = np.full(lanes, of.end or _LATEST)
        while True:  # it returns whenever a lane has come to rest; as a rule neighbours do so in one step
            system.propagate_until(until)
            moving = (system.state[1] > 1e-9) & (system.time < until)
            if not moving.any():
                break
            until = np.where(moving, until, system.time)
        found[0, first : first + lanes] = of.radius * system.state[0, : part.size]
        found[2, first : first + lanes] = of.scale * system.time[: part.size]
    return found


@cache
def _compiled(case: Case, tolerance: float, lanes: int) -> tuple[Equation, Any]:
    import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]

    of, symbolic = _equation(case), Equation(case, hy)
    states = hy.make_vars("phi", "omega", "stress")[: 3 if case.heats else 2]
    symbolic.dip = hy.expression(symbolic.dip)
    rates = symbolic.rate(hy.par[0], list(states))
    events = [hy.t_event_batch(states[1], direction=hy.event_direction.negative)] if of.end is None else []
    begin = [[float(x)] * lanes for x in of.start()]
    return of, hy.taylor_adaptive_batch([*zip(states, rates, strict=True)], begin, pars=[[0.0] * lanes], tol=tolerance,
                                        t_events=events)  # fmt: skip


def ways(name: str, many: bool) -> list[Way]:
    """Ways to solve one scene, or many of one arc: friction coefficients to run-out, peak velocity and duration."""
    case = CASES[name]
    found = [Way(f"slipcircle, {a:.0e}", partial(ours, case, a, None), ours=True) for a in ACCURACIES]
    if name != "closed form" and compiled.module() is not None and not (case.shakes and many):
        found += [Way(f"slipcircle, NumPy, {a:.0e}", partial(ours, case, a, walk.walk), ours=True)
                  for a in ((1e-9,) if case.shakes else ACCURACIES[::2])]  # fmt: skip
    found += [Way(f"DOP853, rtol {a:.0e}", partial(dop853, case, a), needs="scipy") for a in TOLERANCES]
    if not case.shakes:  # it has no tables
        lanes = BATCH if many else 1
        found += [Way(f"heyoka, tol {a:.0e}", partial(heyoka, case, a, lanes), needs="heyoka") for a in ACCURACIES]
    return found


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble, or that of one scene."""
    return np.tan(np.radians(np.linspace(ANGLES[0], ANGLES[-1], count) if count > 1 else np.array(ANGLES[1:2])))


def subject(name: str, many: bool) -> Subject:
    """One scene, or many of them, as a table of the price list has it."""
    known = json.loads(ANSWERS.read_text("utf-8"))[name]
    which = [*known][1:] if many else [*known][:1]
    exact = Answers(np.array([which], dtype=np.float64), [*zip(*(known[mu] for mu in which), strict=True)])
    return Subject(f"{name}, 10000 scenes" if many else name, ways(name, many), lambda kind: exact,
                   lambda count: frictions(count)[None], (1,) if many else (0,), PATIENCE)  # fmt: skip
