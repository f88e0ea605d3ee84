"""What solving scenes costs: this package beside DOP853 and heyoka, each judged against an extrapolation to 20 digits.

One equation of motion, (3.11) with (2.20), written out once by hand over any arithmetic, serves every other way: over
floats SciPy's, over heyoka's expressions heyoka's, over balls the reference's. Nothing here asks the flow but its rows.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, partial
from importlib.util import find_spec
from itertools import pairwise
from types import SimpleNamespace
from typing import Any, NamedTuple, TextIO

import numpy as np

from slipcircle.base.series import Series
from slipcircle.cost.reference import Floats, moments
from slipcircle.files.scenefile import load
from slipcircle.flow import compiled, walk
from slipcircle.flow.solve import walked
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import lanes_of, solve
from slipcircle.scene.scene import Scene

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-15)
LEAST_RTOL = 1e-13  # that SciPy grants
ANGLES = (10.0, 14.0, 19.5)  # of friction, deg: the first and last of an ensemble, and between them that of one scene
RESIDUAL, LENGTH, SPEED = float(np.tan(np.radians(8.0))), 1.0, 5.0  # of the laws: "", m, m/s
LAYER = {"pressurisation": 4e3, "heat_capacity": 2.7e6, "thickness": 0.5}  # Pa/K, J/m^3 K, m: it stays pressed
SAMPLES, SAMPLED = 4000, 20.0  # of the record: how many, and until when, s
BATCH = 32  # lanes of heyoka at once: as many as still gain
_BITS, _ENOUGH, _LEVELS = 140, 1e-26, 14  # of the reference: working precision, what two orders may differ by, orders
_STEP, _LATEST = 0.25, 1e3  # its first step, and the latest standstill, dimensionless
Way = Callable[[Floats], Floats]  # friction coefficients to run-out, peak velocity and duration, (3, n)


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
    shakes: bool = False

    def scene(self, mu: Any) -> Scene:
        scene, friction, more = _shipped(self.shipped), mu, dict[str, Any]()
        if self.softens:
            friction = {"law": "exponential", "peak": mu, "residual": RESIDUAL, "length": LENGTH}
        if self.weakens:
            friction = {"law": "rate_weakening", "peak": mu, "residual": RESIDUAL, "velocity": SPEED}
        if self.heats:
            more["thermal_pressurisation"] = LAYER
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
    "record": Case(shakes=True),
}


# --- the equation of motion by hand ----------------------------------------------------------------------------------


class Equation:
    """The numbers of a scene's equation of motion, in an arithmetic: ``number`` makes its numbers of doubles."""

    def __init__(self, case: Case, number: Callable[[Any], Any], m: Any) -> None:
        from flint import arb, ctx

        scene = case.scene(0.1)
        self.case, self.m, self.number = case, m, number
        with ctx.workprec(_BITS + 40):
            given: Any = (getattr(scene.arc, n) for n in ("theta_1", "theta_2", "radius", "gravity"))
            low, high, radius, gravity = (arb(float(x)) for x in given)
            of, scale = moments((high - low) / 2), (radius / gravity).sqrt()
            names = ("weight_moment_amplitude", "radial_weight_amplitude", "polar_moment")
            self.weight, self.radial, self.polar = (number(of[n] / of["moment_of_inertia"]) for n in names)
            self.dip, self.radius, self.scale = number((3 * arb.pi() - low - high) / 2), number(radius), number(scale)
            self.decay, self.pace = number(radius / LENGTH), number(radius / scale / SPEED)
            self.kappa = number(radius * LAYER["pressurisation"] / arb(LAYER["heat_capacity"]) / LAYER["thickness"])
            end: Any = scene.end_time
            self.end = None if end is None else number(arb(end) / scale)

    def start(self, time: Any = 0.0) -> list[Any]:
        """Rotation, angular velocity, and under heat the effective normal force."""
        zero = self.number(time)
        return [zero, zero, *([self.radial * self.m.cos(self.dip)] if self.case.heats else [])]

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
            return [omega, drive - mu * (press + self.polar * omega * omega)]
        rate = drive - mu * y[2]
        return [omega, rate, (self.radial * sin + 2.0 * self.polar * rate - self.kappa * mu * y[2]) * omega]


def answer(of: Equation, phi: Any, omega: Any, time: Any) -> tuple[Any, Any, Any]:
    """Run-out, peak velocity and duration, m, m/s, s."""
    return of.radius * phi, of.radius * omega / of.scale, time * of.scale


# --- the reference ---------------------------------------------------------------------------------------------------


def extrapolated(f: Callable[[Any, list[Any]], list[Any]], t: Any, y: list[Any], h: Any) -> list[Any] | None:
    """One step by the modified midpoint rule, extrapolated in its even powers (Gragg 1965); None where it is too long.

    Of balls the middles only: that two orders agree to `_ENOUGH` says how good they are.
    """
    before: list[list[Any]] = []
    for level in range(1, _LEVELS + 1):
        n = 2 * level
        d = h / n
        a, b = y, [(u + d * v).mid() for u, v in zip(y, f(t, y), strict=True)]
        for i in range(1, n):
            a, b = b, [(u + 2 * d * v).mid() for u, v in zip(a, f(t + i * d, b), strict=True)]
        row = [b]
        for j, earlier in enumerate(before):
            past = 2 * (level - 1 - j)
            by = past * past / type(h)(n * n - past * past)
            row.append([(u + (u - v) * by).mid() for u, v in zip(row[-1], earlier, strict=True)])
        if before and all(abs(u - v) < _ENOUGH for u, v in zip(row[-1], row[-2], strict=True)):
            return row[-1]
        before = row
    return None


def exact(of: Equation, friction: float) -> tuple[Any, Any, Any]:
    """Run-out, peak velocity and duration to more than 20 digits, in balls.

    Raises
    ------
    ArithmeticError
        Where the mass never comes to rest.
    """
    arb, mu, t, y = of.number, of.number(friction), of.number(0.0), of.start()
    best, h, pieces = of.number(0.0), of.number(_STEP), _pieces(of)
    until, k_h = next(pieces)
    ending = False

    def f(s: Any, y: list[Any]) -> list[Any]:
        return of.rate(mu, y, k_h and k_h(s))

    def by_speed(_: Any, z: list[Any]) -> list[Any]:  # as long as it loses speed, that serves as time (Henon 1982)
        rates = f(z[0], z[1:])
        return [1 / rates[1], *(r / rates[1] for r in rates)]

    while t < _LATEST:
        rate = f(t, y)[1]
        ending = ending or (of.end is None and until is None and rate < 0 and y[1] + 2 * h * rate < 0)
        if ending:
            step = -min(y[1], -h * rate, key=float)
            after = extrapolated(by_speed, y[1], [t, *y], step)
            if after is not None and step + y[1] == 0:
                return answer(of, after[1], best, after[0])
            if after is not None:
                t, *y = after
            else:
                h = h / 2
            continue
        lands = until is not None and not t + h < until
        step = until - t if lands else h
        found = extrapolated(f, t, y, step)
        if found is None:
            h = step / 2
            continue
        if rate > 0 and f(t + step, found)[1] <= 0:
            best = max(best, _fastest(f, t, y, step), key=float)
        best = max(best, found[1], key=float)
        if min(y[2:], default=1) <= 0:
            raise ArithmeticError(f"with mu = {friction!r} nothing presses on the slip surface")
        t, y, h = (t + step).mid(), found, arb(min(1.5 * float(h), 2 * _STEP))
        if lands:
            t = until
            if of.end is not None:
                return answer(of, y[0], best, t)
            until, k_h = next(pieces)
    raise ArithmeticError(f"with mu = {friction!r} it never rests")


def _pieces(of: Equation) -> Iterator[tuple[Any, Any]]:
    """Until when the equation is smooth, and k_h there."""
    if of.case.shakes:
        knots = [(of.number(of.number(t) / of.scale), of.number(k)) for t, k in np.transpose(record()).tolist()]
        for (a, low), (b, high) in pairwise(knots):
            yield b, lambda s, a=a, low=low, slope=(high - low) / (b - a): low + slope * (s - a)
    yield of.end, None


def _fastest(f: Any, t: Any, y: list[Any], h: Any) -> Any:
    """The greatest speed within a step, by bisection: half the digits of its time are enough."""
    low, high, state = 0 * h, h, y
    for _ in range(48):
        middle = (low + high) / 2
        state = extrapolated(f, t, y, middle) or y
        low, high = (middle, high) if f(t + middle, state)[1] > 0 else (low, middle)
    return state[1]


def exactly(case: Case, mu: Floats) -> tuple[Floats, Floats]:
    """Answers to twice a double's digits: the nearest doubles and what is left of them, (3, n) each."""
    from flint import arb, ctx

    with ctx.workprec(_BITS):
        of = Equation(case, lambda x: arb(x).mid(), SimpleNamespace(sin=arb.sin, cos=arb.cos, exp=arb.exp))
        found = [exact(of, x) for x in mu.tolist()]
        near = [[float(v) for v in column] for column in found]
        rest = [[float(v - n) for v, n in zip(*pair, strict=True)] for pair in zip(found, near, strict=True)]
    return np.array(near).T, np.array(rest).T


# --- ways ------------------------------------------------------------------------------------------------------------


def ours(case: Case, accuracy: float, walker: Any, closed: bool | None, mu: Floats) -> Floats:
    """By this package: as `solve` does it, or with a walk of one's own choice."""
    scene = case.scene(mu) if mu.size > 1 else _one(case, float(mu[0]))
    if walker is None and closed is None:
        motion = solve(scene, accuracy)
    else:
        lanes = lanes_of(chosen := plan(scene, accuracy))
        cells = walked(lanes.bound, lanes.closed and closed is None, walker=walker)
        motion = Motion(chosen, lanes, dict(enumerate(cells)), [])
    return np.array([motion.outcomes[n] for n in ("run_out", "peak_velocity", "duration")]).reshape(3, -1)


def dop853(case: Case, tolerance: float) -> Way:
    """By SciPy's DOP853, scene after scene, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    of = Equation(case, float, math)
    end, (times, k_h) = of.end or _LATEST, record()

    def one(mu: float) -> tuple[Any, Any, Any]:
        def rate(t: float, y: Any) -> list[Any]:
            return of.rate(mu, y, float(np.interp(t * of.scale, times, k_h)) if case.shakes else None)

        def stands(_: float, y: Any) -> float:
            return float(y[1])

        def slows(t: float, y: Any) -> float:
            return float(rate(t, y)[1])

        vars(stands).update(terminal=of.end is None, direction=-1.0)
        vars(slows).update(direction=-1.0)
        found = solve_ivp(rate, (0.0, end), of.start(), "DOP853", rtol=tolerance, atol=1e-3 * tolerance,
                          events=[stands, slows])  # fmt: skip
        peaks = [y[1] for y in found.y_events[1]] if not case.shakes else found.y[1]
        return answer(of, found.y[0, -1], max([*peaks, found.y[1, -1]]), found.t[-1])

    return lambda mu: np.array([one(x) for x in mu.tolist()]).T


def heyoka(case: Case, tolerance: float, lanes: int) -> Way:
    """By heyoka's Taylor series, compiled once: so many neighbouring frictions at once, all but the peak.

    The peak would take a call of Python from each lane, so that it is spared it.
    """
    import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]

    of = Equation(case, float, hy)
    of.dip = hy.expression(of.dip)
    states = hy.make_vars("phi", "omega", "stress")[: 3 if case.heats else 2]
    begin = [[float(x)] * lanes for x in Equation(case, float, math).start()]
    falls = hy.event_direction.negative
    events = [hy.t_event_batch(states[1], direction=falls)] if of.end is None else []
    rates = of.rate(hy.par[0], list(states))
    system = hy.taylor_adaptive_batch([*zip(states, rates, strict=True)], begin, pars=[[0.0] * lanes], tol=tolerance,
                                      t_events=events)  # fmt: skip

    def solved(mu: Floats) -> Floats:
        found = np.full((3, mu.size), np.nan)
        for first in range(0, mu.size, lanes):
            part = mu[first : first + lanes]
            system.set_time(0.0)
            system.state[:], system.pars[0] = begin, np.resize(part, lanes)
            if events:
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

    return solved


def ways(name: str, many: bool, progress: TextIO | None = None) -> dict[str, Way]:
    """Ways to solve one scene, or many of one arc by their friction coefficients."""
    case = CASES[name]
    found: dict[str, Way] = {f"slipcircle, {a:.0e}": partial(ours, case, a, None, None) for a in ACCURACIES}
    frozen = case.shipped == "vaiont-frozen"
    if frozen or (compiled.module() is not None and not (case.shakes and many)):
        text, other = ("series", None) if frozen else ("NumPy", walk.walk)
        found |= {f"slipcircle, {text}, {a:.0e}": partial(ours, case, a, other, False)
                  for a in ((1e-9,) if case.shakes else ACCURACIES[::2])}  # fmt: skip
    for module in ("scipy", "heyoka"):
        if find_spec(module) is None:
            if progress:
                print(f"{module} is missing, and left out", file=progress)
        elif module == "scipy":
            found |= {f"DOP853, rtol {max(a, LEAST_RTOL):.0e}": dop853(case, max(a, LEAST_RTOL)) for a in ACCURACIES}
        elif not case.shakes:  # it has no tables
            found |= {f"heyoka, tol {a:.0e}": heyoka(case, a, BATCH if many else 1) for a in ACCURACIES}
    return found


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble, or that of one scene."""
    return np.tan(np.radians(np.linspace(ANGLES[0], ANGLES[-1], count) if count > 1 else np.array(ANGLES[1:2])))
