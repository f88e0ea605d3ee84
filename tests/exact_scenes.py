"""Answers to the scenes and sections of the price list, to 24 digits, in ball arithmetic.

Of scenes by extrapolation of its equation by hand, of sections by strips.

``python tests/exact_scenes.py`` writes them; `test_cost` makes them again, and lays Taylor series beside them.
"""

import json
from collections.abc import Callable, Iterator
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
from flint import arb, ctx
from strips import integrals

from slipcircle.cost import sections
from slipcircle.cost.reference import moments
from slipcircle.cost.scenes import ANSWERS, CASES, LAYER, LENGTH, SHEARED, SPEED, Case, Equation, answer, record

_BITS, _ENOUGH, _LEVELS = 140, 1e-26, 14  # working precision, what two orders may differ by, orders
_STEP, _LATEST = 0.25, 1e3  # the first step, and the latest standstill, dimensionless


def number(x: Any) -> Any:
    """The middle of a ball."""
    return arb(x).mid()


class Exactly(Equation):
    """The equation of motion of the price list over balls, its coefficients by the closed forms of the definitions."""

    def __init__(self, case: Case) -> None:
        scene = case.scene(0.1)
        self.case, self.m = case, SimpleNamespace(sin=arb.sin, cos=arb.cos, exp=arb.exp)
        with ctx.workprec(_BITS + 40):
            given: Any = (getattr(scene.arc, n) for n in ("theta_1", "theta_2", "radius", "gravity"))
            low, high, radius, gravity = (arb(float(x)) for x in given)
            of, scale = moments((high - low) / 2), (radius / gravity).sqrt()
            names = ("weight_moment_amplitude", "radial_weight_amplitude", "polar_moment")
            self.weight, self.radial, self.polar = (number(of[n] / of["moment_of_inertia"]) for n in names)
            self.dip, self.radius, self.scale = number((3 * arb.pi() - low - high) / 2), number(radius), number(scale)
            self.decay, self.pace = number(radius / LENGTH), number(radius / scale / SPEED)
            sheared = (high - low) / of["moment_of_inertia"] if case.shears else arb(0)
            pace = arb(float(np.asarray(scene.arc.unit_weight))) * scale * SHEARED["thickness"]
            self.viscous = number(sheared * SHEARED["viscosity"] / pace)
            self.kappa = number(radius * LAYER["pressurisation"] / arb(LAYER["heat_capacity"]) / LAYER["thickness"])
            end: Any = scene.end_time
            self.end = None if end is None else number(arb(end) / scale)

    def start(self) -> list[Any]:
        zero = number(0.0)
        return [zero, zero, *([self.radial * self.m.cos(self.dip)] if self.case.heats else [])]


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


def exact(of: Exactly, friction: float) -> tuple[Any, Any, Any]:
    """Run-out, peak velocity and duration to more than 20 digits, in balls.

    Raises
    ------
    ArithmeticError
        Where the mass never comes to rest.
    """
    mu, t, y = number(friction), number(0.0), of.start()
    best, h, pieces = number(0.0), number(_STEP), _pieces(of)
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
        t, y, h = (t + step).mid(), found, number(min(1.5 * float(h), 2 * _STEP))
        if lands:
            t = until
            if of.end is not None:
                return answer(of, y[0], best, t)
            until, k_h = next(pieces)
    raise ArithmeticError(f"with mu = {friction!r} it never rests")


def _pieces(of: Exactly) -> Iterator[tuple[Any, Any]]:
    """Until when the equation is smooth, and k_h there."""
    if of.case.shakes:
        knots = [(number(number(t) / of.scale), number(k)) for t, k in np.transpose(record()).tolist()]
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


def texts(case: Case, friction: float) -> tuple[str, str, str]:
    """Run-out, peak velocity and duration as decimals."""
    with ctx.workprec(_BITS):
        one, two, three = (v.str(24, radius=False) for v in exact(Exactly(case), friction))
    return one, two, three


def written() -> str:
    """The file of the answers, as it is to be."""
    known = json.loads(ANSWERS.read_text("utf-8"))
    frictions = {name: known.get(name, known["constant friction"]) for name in CASES}  # a new case takes those
    made = {name: {mu: texts(CASES[name], float(mu)) for mu in of} for name, of in frictions.items()}
    return json.dumps(made, indent=1) + "\n"


def measures() -> str:
    """The file of the measures of sections, as it is to be, by strips in ball arithmetic."""
    found = (integrals(sections.GROUND.tolist(), (x, y), r) for x, y, r in sections.drawn(sections.COUNT).T.tolist())
    texts = zip(*([v.mid().str(24, radius=False) for v in one.values()] for one in found), strict=True)
    return json.dumps([*texts], indent=1) + "\n"


if __name__ == "__main__":
    ANSWERS.write_text(written(), "utf-8")
    sections.ANSWERS.write_text(measures(), "utf-8")
