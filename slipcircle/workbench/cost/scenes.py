"""What solving scenes costs: this package beside DOP853 and heyoka, each judged by answers to 24 digits.

One equation of motion, (3.11) with (2.20), written out once by hand over any arithmetic, serves every other way: over
floats SciPy's, over heyoka's expressions heyoka's. The answers are the tests' Taylor series in ball arithmetic.
"""

import json
import math
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from generated import kernels
from slipcircle.base.series import Series
from slipcircle.core.flow import compiled, walk
from slipcircle.core.flow.lanes import walked
from slipcircle.core.motion.motion import Motion, final_entries
from slipcircle.core.motion.plan import plan
from slipcircle.core.motion.solver import lanes_of, solve
from slipcircle.core.scene.scene import Scene
from slipcircle.workbench.cost.reference import Floats, reference
from slipcircle.workbench.cost.ways import Subject, Way
from slipcircle.workbench.files.scenefile import load

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)
TOLERANCES = (*ACCURACIES[:-1], 1e-13)  # of SciPy, which grants no less
ANGLES = (10.0, 14.0, 19.5)  # of friction, deg: the first and last of an ensemble, and between them that of one scene
RESIDUAL = float(np.tan(np.radians(8.0)))
LAYER = {"pressurisation": 4e3, "heat_capacity": 2.7e6, "thickness": 0.5}  # Pa/K, J/m^3 K, m: it stays pressed
SHEARED = {"viscosity": 2e3, "thickness": 0.5}  # Pa s, m: it takes a sixth of the speed in the unit of time
SAMPLES, SAMPLED = 4000, 20.0  # of the record: how many, and until when, s
BATCH = 32  # lanes of heyoka at once: as many as still gain
# Run-out, peak velocity and duration by friction, of one scene and then of an ensemble's lanes, to 24 digits;
# ``python tests/exact_scenes.py`` writes them.
ANSWERS = Path(__file__).with_name("answers.json")
_LATEST = 1e3  # standstill, dimensionless
PATIENCE = 5.0  # of a pass over scenes, as of `Subject`


def _record() -> Series:
    """k_h over time: twelve sines under an envelope, sampled; straight lines between."""
    rng, time = np.random.default_rng(1963), np.linspace(0.0, SAMPLED, SAMPLES)
    waves = np.sin(time[:, None] * rng.uniform(3.0, 40.0, 12) + rng.uniform(0.0, 6.3, 12)).sum(axis=1)
    return Series(time, 0.01 * waves * np.sin(np.pi * time / SAMPLED) ** 2)


# A law of friction, to be given its peak, and effects, which Vaiont's scene gets beside its own.
CASES: Mapping[str, tuple[Mapping[str, Any], Mapping[str, Any]]] = {
    "closed form": ({}, {}),
    "constant friction": ({}, {}),
    "softening": ({"law": "exponential", "residual": RESIDUAL, "length": 1.0}, {}),
    "rate weakening": ({"law": "rate_weakening", "residual": RESIDUAL, "velocity": 5.0}, {}),
    "heat": ({}, {"thermal_pressurisation": LAYER}),
    "viscosity": ({}, {"viscosity": SHEARED}),
    "record": ({}, {"shaking": {"horizontal": _record()}}),
}
_shipped = cache(load)


def scene(name: str, mu: Any) -> Scene:
    """A scene of `CASES` with a friction coefficient, or with many."""
    (law, effects), whole = CASES[name], _shipped("vaiont-frozen" if name == "closed form" else "vaiont")
    return replace(whole, friction={**law, "peak": mu} if law else mu, effects={**whole.called, **effects})


_one = cache(scene)

# --- the equation of motion by hand ----------------------------------------------------------------------------------


class Equation:
    """The numbers of a scene's equation of motion, and its rates over the arithmetic of a module m."""

    def __init__(self, name: str, m: Any = math) -> None:
        arc: Any = scene(name, 0.1).arc
        end = scene(name, 0.1).end_time
        (self.law, self.effects), self.m = CASES[name], m
        self.turns, self.scale, self.radius = name != "closed form", float(arc.time_scale), float(arc.radius)
        self.end = None if end is None else float(end) / self.scale
        names = ("weight_moment_per_inertia", "radial_weight_per_inertia", "polar_moment_per_inertia")
        self.weight, self.radial, self.polar = (float(getattr(kernels, n)(arc.half_angle)) for n in names)
        self.dip: Any = float(arc.dip)
        self.decay = self.radius / self.law.get("length", 1.0)
        self.pace = self.radius / self.scale / self.law.get("velocity", 1.0)
        self.kappa = self.radius * LAYER["pressurisation"] / LAYER["heat_capacity"] / LAYER["thickness"]
        brake = 2.0 * arc.half_angle * SHEARED["viscosity"] / (arc.unit_weight * self.scale * SHEARED["thickness"])
        self.viscous = float(brake / kernels.moment_of_inertia(arc.half_angle)) if "viscosity" in self.effects else 0.0

    def start(self) -> list[float]:
        """Rotation, angular velocity, and under heat the effective normal force."""
        return [0.0, 0.0, *([self.radial * math.cos(self.dip)] if "thermal_pressurisation" in self.effects else [])]

    def rate(self, mu: Any, y: Any, k_h: Any = None) -> list[Any]:
        """The states' derivatives by dimensionless time."""
        m, (phi, omega, *heated) = self.m, y
        psi = self.dip - phi if self.turns else self.dip
        sin, cos = (m.sin(psi), m.cos(psi))
        if "length" in self.law:
            mu = RESIDUAL + (mu - RESIDUAL) * m.exp(-self.decay * phi)
        if "velocity" in self.law:
            mu = RESIDUAL + (mu - RESIDUAL) / (1.0 + self.pace * omega)
        drive, press = self.weight * sin, self.radial * cos
        if k_h is not None:
            drive, press = drive + self.weight * k_h * cos, press - self.radial * k_h * sin
        if not heated:
            return [omega, drive - mu * (press + self.polar * omega * omega) - self.viscous * omega]
        rate = drive - mu * heated[0]
        return [omega, rate, (self.radial * sin + 2.0 * self.polar * rate - self.kappa * mu * heated[0]) * omega]

    def answer(self, phi: Any, omega: Any, time: Any) -> list[Any]:
        """Run-out, peak velocity and duration, m, m/s, s."""
        return [self.radius * phi, self.radius / self.scale * omega, time * self.scale]


# --- ways ------------------------------------------------------------------------------------------------------------


def ours(name: str, accuracy: float, walker: Any, mu: Any) -> Floats:
    """By this package: as `solve` does it, or with a walk of one's own choice."""
    asked = scene(name, mu) if np.size(mu) > 1 else _one(name, float(np.squeeze(mu)))
    if walker is None:
        motion = solve(asked, accuracy)
    else:
        lanes = lanes_of(chosen := plan(asked, accuracy))
        motion = Motion(
            chosen, lanes, final_entries(walked(lanes.bound, lanes.closed, walker=walker), not asked.shape), []
        )
    return np.array([motion.outcomes[n] for n in ("run_out", "peak_velocity", "duration")]).reshape(3, -1)


_equation = cache(Equation)


def dop853(name: str, tolerance: float, mu: Any) -> Floats:
    """By SciPy's DOP853, scene after scene, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    of = _equation(name)
    shaking: Any = of.effects.get("shaking", {}).get("horizontal")

    def rate(t: float, y: Any, mu: float) -> list[Any]:
        return of.rate(mu, y, float(np.interp(t * of.scale, shaking.time, shaking.values)) if shaking else None)

    def stands(_: float, y: Any, mu: float) -> float:
        return float(y[1])

    def slows(t: float, y: Any, mu: float) -> float:
        return float(rate(t, y, mu)[1])

    vars(stands).update(terminal=of.end is None, direction=-1.0)
    vars(slows).update(direction=-1.0)

    def one(mu: float) -> list[Any]:
        found = solve_ivp(
            rate,
            (0.0, of.end or _LATEST),
            of.start(),
            "DOP853",
            rtol=tolerance,
            atol=1e-3 * tolerance,
            events=[stands, slows],
            args=(mu,),
        )
        peaks = found.y[1] if shaking else [*(y[1] for y in found.y_events[1]), found.y[1, -1]]
        return of.answer(found.y[0, -1], max(peaks), found.t[-1])

    return np.array([one(x) for x in np.atleast_1d(mu).tolist()]).T


def heyoka(name: str, tolerance: float, lanes: int, mu: Any) -> Floats:
    """By heyoka's Taylor series: so many neighbouring frictions at once, all but the peak.

    The peak would take a call of Python from each lane, so that it is spared it.
    """
    of, system = _compiled(name, tolerance, lanes)
    mu = np.atleast_1d(mu)
    found = []
    for first in range(0, mu.size, lanes):
        system.set_time(0.0)
        system.state[:] = np.array(of.start())[:, None]
        system.pars[0] = np.resize(mu[first : first + lanes], lanes)
        if of.end is None:
            system.reset_cooldowns()
        until = np.full(lanes, of.end or _LATEST)
        while True:  # it returns whenever a lane has come to rest; as a rule neighbours do so in one step
            system.propagate_until(until)
            moving = (system.state[1] > 1e-9) & (system.time < until)
            if not moving.any():
                break
            until = np.where(moving, until, system.time)
        found.append(of.answer(system.state[0].copy(), np.full(lanes, np.nan), np.array(system.time)))
    return np.concatenate(found, axis=1)[:, : mu.size]


@cache
def _compiled(name: str, tolerance: float, lanes: int) -> tuple[Equation, Any]:
    import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]

    of, symbolic = _equation(name), Equation(name, hy)
    states = hy.make_vars("phi", "omega", "stress")[: len(of.start())]
    symbolic.dip = hy.expression(symbolic.dip)
    rates = symbolic.rate(hy.par[0], list(states))
    events = [hy.t_event_batch(states[1], direction=hy.event_direction.negative)] if of.end is None else []
    begin = [[x] * lanes for x in of.start()]
    return of, hy.taylor_adaptive_batch(
        [*zip(states, rates, strict=True)], begin, pars=[[0.0] * lanes], tol=tolerance, t_events=events
    )


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble, or that of one scene."""
    return np.tan(np.radians(np.linspace(ANGLES[0], ANGLES[-1], count) if count > 1 else ANGLES[1:2]))


def subject(name: str, many: bool) -> Subject:
    """One scene, or many of one arc: ways from friction coefficients to run-out, peak velocity and duration."""
    shaken = "shaking" in CASES[name][1]
    ways = [Way(f"slipcircle, {a:.0e}", partial(ours, name, a, None), ours=True) for a in ACCURACIES]
    if name != "closed form" and compiled.module() is not None and not (shaken and many):
        ways += [
            Way(f"slipcircle, NumPy, {a:.0e}", partial(ours, name, a, walk.walk), ours=True)
            for a in ((1e-9,) if shaken else ACCURACIES[::2])
        ]
    ways += [Way(f"DOP853, rtol {a:.0e}", partial(dop853, name, a), needs="scipy") for a in TOLERANCES]
    if not shaken:  # it has no tables
        lanes = BATCH if many else 1
        ways += [Way(f"heyoka, tol {a:.0e}", partial(heyoka, name, a, lanes), needs="heyoka") for a in ACCURACIES]
    known = json.loads(ANSWERS.read_text("utf-8"))[name]
    which = [*known][1:] if many else [*known][:1]
    answers = [[Decimal(known[mu][k]) for mu in which] for k in range(3)]
    exact = reference(np.array([which], dtype=np.float64), answers)
    return Subject(
        f"{name}, 10000 scenes" if many else name,
        ways,
        lambda kind: exact,
        lambda count: frictions(count)[None],
        (1,) if many else (0,),
        PATIENCE,
    )
