"""Forces, factors of safety and motions of a mass from their definitions, by Gauss' rule along the arc between kinks.

Directions b are from straight below the centre, down-slope positive. Of the package it takes the numbers of the slope
and of the circle; nothing that it computes. SciPy's DOP853 integrates motions.
"""

import math
from collections.abc import Callable, Sequence
from copy import copy
from functools import lru_cache
from itertools import combinations, pairwise
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from slipcircle import Section
from slipcircle.layers import LayeredSection, Soil

NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def random_section(rng: np.random.Generator, strongest: float = 1.0, **given: Any) -> LayeredSection:
    """Five layers with wavy and crossing boundaries and a thin seam, one soil twice; water, loads, either facing."""
    while True:
        facing = rng.choice([-1, 1])
        x = [-120.0, *np.sort(rng.uniform(-60, 80, 4)), 160.0]
        y = [25.0, *np.sort(rng.uniform(0, 25, 4))[::-1], 0.0]
        ground = np.column_stack([x, y])[::facing] * [facing, 1]
        wavy = np.column_stack([np.sort(rng.uniform(-100, 100, 5)), rng.uniform(-2, 24, 5)])
        seam = rng.uniform(-5, 14)
        numbers = rng.uniform([15e3, 0.0, 0.0], [22e3, 2e4, 0.8], (5, 3)) * [1.0, strongest, strongest]
        soils = [
            Soil(weight, cohesion, friction, rng.choice([0.0, 23e3]) or None, rng.choice([0.0, 800.0]),
                 rng.uniform(0, 30), rng.choice([0.0, 0.2]), name=f"soil {k}")
            for k, (weight, cohesion, friction) in enumerate(numbers.tolist())
        ]  # fmt: skip
        soils[3] = soils[0]
        loads = [(x, x + rng.uniform(2, 20), *rng.uniform(0, 5e4, 2)) for x in rng.uniform(-30, 30, 2)]
        try:
            section = LayeredSection(
                ground, (rng.uniform(-10, 40) * facing, rng.uniform(28, 70)), rng.uniform(30, 80), surcharge=loads,
                layers=list(zip(soils, [None, wavy, seam, seam - 0.02, seam - 4.0], strict=True)),
                level=ground - [0.0, rng.uniform(0, 4)], **given,
            )  # fmt: skip
        except ValueError:
            continue
        if not section.mistakes(None, {}) and max(np.abs(AlongTheArc(section, section).ends)) < 1.5:
            return section


def antiderivatives(x: Any, y: Any) -> Any:
    """Return antiderivatives over y of -y/rho, x/rho, rho, x, y, rho^2 and 1; rho is the distance from the centre."""
    rho, log = np.sqrt(x**2 + y**2), np.arcsinh(y / np.abs(x))
    return np.array([-rho, x * log, (y * rho + x**2 * log) / 2, x * y, y**2 / 2, x**2 * y + y**3 / 3, y])


def kinks_of(lines: Any, x: Any) -> Any:
    """Directions of vertices of lines, and of where they cross each other and the unit circle."""
    y = np.array([np.interp(x, *line.T) for line in lines])
    dip = np.diff(y) / np.diff(x)
    above = y[:, :-1] - dip * x[:-1]  # of a line at the centre
    with np.errstate(invalid="ignore", divide="ignore"):
        reach = np.sqrt(1.0 + dip**2 - above**2)
        crossings = [(sign * reach - dip * above) / (1.0 + dip**2) for sign in (-1.0, 1.0)]
        crossings += [[x[:-1] - (f - g)[:-1] * np.diff(x) / np.diff(f - g)] for f, g in combinations(y, 2)]
    every = np.concatenate(crossings)
    every = np.concatenate([x, every[(every >= x[:-1]) & (every <= x[1:])]])
    return np.arcsin(every[np.abs(every) <= 1.0])


class Slide(NamedTuple):
    """Displacement or rotation at the end of a slide, its time, and the greatest velocity or angular velocity."""

    distance: float
    time: float
    fastest: float


def first_slide(rate: Callable[[float, Any], Sequence[float]], start: Sequence[float], end: float = math.inf) -> Slide:
    """Integrate rotation, angular velocity and further states from a start to the first standstill or a rotation."""
    stops: Callable[..., float] = lambda t, state: min(state[1], end - state[0]) if t > 0.0 else 1.0  # noqa: E731
    fastest: Callable[..., float] = lambda t, state: rate(t, state)[1]  # noqa: E731
    stops.terminal, stops.direction = True, -1.0  # type: ignore[attr-defined]
    run = solve_ivp(rate, (0.0, 1e4), start, "DOP853", rtol=1e-12, atol=1e-14, events=(stops, fastest))
    greatest = max([start[1], *(state[1] for state in run.y_events[1])])
    return Slide(run.y_events[0][0][0], run.t_events[0][0], greatest)


def under_chord(arc: Any) -> Section:
    """Return the section whose ground is the chord of an arc."""
    ends = [(arc.radius * math.cos(theta), arc.radius * math.sin(theta)) for theta in (arc.theta_1, arc.theta_2)]
    left, right = np.array(sorted(ends))
    return Section([2 * left - right, 2 * right - left], (0.0, 0.0), arc.radius, arc.unit_weight)


class Columns(NamedTuple):
    """Vertical strips above nodes of the arc, and what acts at their bases."""

    b: Any
    length: Any  # of the arc, over R
    soil: Any  # weight over breadth times the integrands of `antiderivatives`, Pa
    load: Any  # likewise of the surcharges
    displaced: Any  # likewise of water below the level at the exit, in the place of the mass
    friction: Any
    cohesion: Any
    pressure: Any
    excess: Any  # of the pore pressure over that of this water


def at_slip(law: Any, slip: float) -> float:
    """Return a friction coefficient or a cohesion after a slip."""
    if callable(law):
        return float(law(slip))
    if not isinstance(law, dict):
        return float(law)
    ratio = slip / law.get("length", 1.0)
    share = {"exponential": math.exp(-ratio), "linear": 1.0 - min(ratio, 1.0), "hyperbolic": 1.0 / (1.0 + ratio)}
    return float(law["residual"] + (law["peak"] - law["residual"]) * share[law["law"]])


def of_scene(scene: Any) -> "AlongTheArc":
    """Return the slope of a scene, of one soil or of layers, without a pond."""
    section = scene.arc
    if isinstance(section, LayeredSection):
        return AlongTheArc(section, section)
    cohesion = dict(scene.effects.get("cohesion", {"cohesion": 0.0}))
    gradient, datum = cohesion.pop("gradient", 0.0), cohesion.pop("datum", None)
    soil = SimpleNamespace(
        unit_weight=section.unit_weight, saturated_unit_weight=None, friction=scene.friction, datum=datum,
        cohesion=cohesion if "law" in cohesion else cohesion["cohesion"], cohesion_gradient=gradient,
        pore_ratio=scene.effects.get("pore_pressure", {}).get("ratio", 0.0),
    )  # fmt: skip
    names = ("ground", "level", "water_unit_weight", "gravity")
    fields = {name: getattr(section, name) for name in names}
    slope = SimpleNamespace(**fields, layers=[(soil, None)], surcharge=(), pressure=0.0, strength="base")
    return AlongTheArc(slope, section)


class AlongTheArc:
    """A slope above a circle: x from its centre down-slope, y up, both over its radius."""

    def __init__(self, slope: Any, circle: Any) -> None:
        self.slope, self.radius, self.facing = slope, float(circle.radius), int(circle.facing)
        self.centre = np.array(circle.centre, dtype=np.float64)
        foreland = getattr(slope, "foreland", None)
        self.soils = [*(soil for soil, _ in slope.layers), *([foreland] if foreland else [])]
        self.farthest = np.inf if foreland else -np.inf
        tops = [slope.ground, *(top for _, top in slope.layers[1:]), -1e9 if slope.level is None else slope.level]
        own = [slope.ground, *(top for _, top in slope.layers[1:]), 0.0]
        datums = [top if soil.datum is None else soil.datum for soil, top in zip(self.soils, own, strict=False)]
        every = [self.line(top) for top in (*tops, *datums)]
        self.lines, self.level = every[: len(slope.layers)], every[len(slope.layers)]
        self.datums = every[len(tops) :]
        self.loads = [(*self.line([(x, 0.0) for x in load[:2]])[:: self.facing, 0], *load[2:])
                      for load in slope.surcharge]  # fmt: skip
        vertices = [line[:, 0] for line in every] + [load[:2] for load in self.loads]
        self.kinks = kinks_of(every, np.unique(np.concatenate(vertices)))
        self.ends = np.arcsin(np.sort(self.line([circle.entry, circle.exit])[:, 0]))
        pool = float(np.interp(np.sin(self.ends[1]), *self.level.T))
        is_wet = slope.level is not None and pool > -np.cos(self.ends[1]) + 1e-12
        self.pool = pool if is_wet and not getattr(slope, "confined", False) else None  # level of standing water
        self.of_water = slope.water_unit_weight * self.radius
        self.slip: float | None = None  # in place of that of a rotation

    def turned(self, rotation: float) -> "AlongTheArc":
        """Return a mass of one soil after a rotation, with the strength that is left, under a level that stays."""
        mass = copy(self)
        first, last = self.ends
        inside = [p for p in self.lines[0] if math.sin(first) < p[0] < math.sin(last)]
        points = np.array([[math.sin(first), -math.cos(first)], *inside, [math.sin(last), -math.cos(last)]])
        c, s = math.cos(rotation), math.sin(rotation)
        mass.lines = [points @ np.array([[c, s], [-s, c]])]
        mass.ends, mass.slip = self.ends + rotation, rotation * self.radius
        every = [*mass.lines, self.level, *self.datums]
        mass.kinks = kinks_of(every, np.unique(np.concatenate([line[:, 0] for line in every])))
        return mass

    def line(self, top: Any) -> Any:
        """Return a line of the slope, or a height, with x that grows."""
        points = np.asarray(top) if np.ndim(top) else np.array([[self.centre[0], top]])
        return (points - self.centre)[:: self.facing] * [self.facing / self.radius, 1.0 / self.radius]

    def weights(self, b: Any) -> tuple[Any, Any]:
        """Return the weights of the soils and of the surcharges above points of the arc."""
        x, y = np.sin(b), -np.cos(b)
        ground, *_ = tops = np.minimum.accumulate([np.interp(x, *line.T) for line in self.lines])
        bounds = [*np.maximum(tops, y), y]
        soil, load = np.zeros((2, 7, *x.shape))
        for high, low, (of, _) in zip(bounds, bounds[1:], self.slope.layers, strict=False):
            wet = np.clip(np.interp(x, *self.level.T), low, high)
            up, middle, down = (antiderivatives(x, height) for height in (high, wet, low))
            soil += of.unit_weight * (up - middle) + (of.saturated_unit_weight or of.unit_weight) * (middle - down)
        for left, right, q_left, q_right in self.loads:
            q = np.where((x >= left) == (x <= right), q_left + (q_right - q_left) * (x - left) / (right - left), 0.0)
            load += q * antiderivatives(x, ground + 1e-30j).imag / 1e-30
        return soil * self.radius, load

    def at_pool(self, rotation: float) -> Any:
        """Return directions in the mass where its turned ground or the arc is at the level of standing water."""
        if self.pool is None:
            return np.zeros(0)
        c, s = math.cos(rotation), math.sin(rotation)
        reach = math.acos(-self.pool)
        directions = [-reach - rotation, reach - rotation]
        for p, q in pairwise(self.lines[0]):
            low, high = (x * s + y * c - self.pool for x, y in (p, q))
            if low * high < 0.0:
                directions.append(math.asin(np.clip((p + (q - p) * low / (low - high))[0], -1.0, 1.0)))
        return np.array(directions)

    def displaced(self, b: Any, rotation: float) -> Any:
        """Return the weight of displaced water above points of the arc, and minus its pressure on the ground."""
        x, y = np.sin(b), -np.cos(b)
        if self.pool is None:
            return np.zeros((7, *b.shape))
        level = (self.pool - x * math.sin(rotation)) / math.cos(rotation)
        top = np.maximum(np.minimum(np.interp(x, *self.lines[0].T), level), y)
        return self.of_water * (antiderivatives(x, top) - antiderivatives(x, y))

    @lru_cache(1)  # noqa: B019 (one question follows another of the same state)
    def columns(self, rotation: float = 0.0, strength: str = "base") -> Columns:
        """Return the strips after a rotation; strength belongs to the base or turns with the mass."""
        first, last = self.ends
        edges = np.concatenate([self.kinks, self.kinks - rotation, self.ends - rotation, np.linspace(first, last, 9)])
        edges = np.concatenate([edges, self.at_pool(rotation)])
        edges = np.unique(np.clip(edges, first, last))
        half = np.diff(edges) / 2
        b = edges[:-1] + half * (1.0 + NODES[:, None])
        soil, load = self.weights(b)
        base = np.clip(b + rotation * (strength == "base"), first, max(last, self.farthest))
        # At the ends the ground has no thickness: the soil just inside counts.
        inside = np.clip(base, first + 1e-6, last - 1e-6)
        tops = np.minimum.accumulate([np.interp(np.sin(inside), *line.T) for line in self.lines])
        which = np.maximum(np.count_nonzero(tops > -np.cos(inside), axis=0) - 1, 0)
        which[base > last] = len(self.lines)
        slip = rotation * self.radius if self.slip is None else self.slip
        friction, cohesion, gradient, ratio = self.strengths(slip).T[:, which]
        datums = np.array([np.interp(np.sin(base), *line.T) for line in self.datums])
        datum = np.take_along_axis(datums, which[None], 0)[0]
        cohesion = cohesion + gradient * self.radius * np.maximum(datum + np.cos(base), 0.0)
        depth = np.cos(b + rotation)
        head = np.maximum(np.interp(np.sin(b + rotation), *self.level.T) + depth, 0.0)
        length = half * WEIGHTS[:, None]
        if not isinstance(self.slope, LayeredSection):  # of one soil r_u is a share of the stress as it turns
            radial, tangential = ((soil[k] * np.cos(b) * length).sum() for k in (0, 1))
            ratio = ratio * (math.cos(rotation) - math.sin(rotation) * tangential / radial)
        pressure = np.where(ratio > 0.0, ratio * soil[6], self.of_water * head)
        relieved = 0.0 if self.pool is None else self.of_water * np.maximum(self.pool + depth, 0.0)
        displaced = self.displaced(b, rotation)
        return Columns(b, length, soil, load, displaced, friction, cohesion, pressure, pressure - relieved)

    def strengths(self, slip: float) -> Any:
        """Return friction, cohesion, its growth and pore pressure ratio of each soil after a slip."""
        rows = []
        for soil in self.soils:
            cohesion, peak = (at_slip(soil.cohesion, s) for s in (slip, 0.0))
            changes = isinstance(soil.cohesion, dict) or callable(soil.cohesion)
            gradient = soil.cohesion_gradient * (cohesion / peak if changes else 1.0)
            rows.append([at_slip(soil.friction, slip), cohesion, gradient, soil.pore_ratio])
        return np.array(rows)

    def normal(self, state: Any, columns: Columns) -> Any:
        """Total normal stress on the arc, Pa."""
        turn, speed = float(state.rotation), state.angular_velocity**2 * self.radius / self.slope.gravity
        whole = (columns.soil + columns.load) * np.cos(columns.b)
        radial, tangential, *_ = whole - columns.displaced * np.cos(columns.b)
        return radial * np.cos(turn) - tangential * np.sin(turn) + speed * whole[2]

    def means(self, state: Any) -> tuple[float, float]:
        """Return the means of total normal stress and of pore pressure along the arc, Pa."""
        columns = self.columns(float(state.rotation), self.slope.strength)
        sums = [(value * columns.length).sum() for value in (self.normal(state, columns), columns.pressure)]
        return sums[0] / np.ptp(self.ends), sums[1] / np.ptp(self.ends)

    def acceleration(self, state: Any, strength_factor: float = 1.0) -> float:
        """Return the acceleration of a turning mass, m/s^2, with strength times a factor."""
        section, turn = self.slope, float(state.rotation)
        columns = self.columns(turn, section.strength)
        whole = (columns.soil + columns.load) * np.cos(columns.b)
        _, _, _, x, y, *_ = whole - columns.displaced * np.cos(columns.b)
        inertia = whole[5]
        friction = columns.friction * (self.normal(state, columns) - columns.excess)
        integrands = (friction, columns.cohesion, y * np.sin(turn) - x * np.cos(turn), inertia)
        gripping, cohesion, driving, mass = (float((value * columns.length).sum()) for value in integrands)
        moment = driving - np.sign(state.velocity) * strength_factor * (max(gripping, 0.0) + cohesion)
        return section.gravity * moment / mass

    def motion(self, strength_factor: float = 1.0, velocity: float = 0.0, end: float = math.inf) -> Slide:
        """Return displacement and time of the first standstill or of a rotation, and the greatest velocity before.

        Zeros if the mass does not move down-slope.
        """

        def rate(_: float, state: Any) -> tuple[float, float]:
            rotation, omega = state
            moment = SimpleNamespace(rotation=rotation, angular_velocity=omega, velocity=1.0)
            return omega, self.acceleration(moment, strength_factor) / self.radius

        if velocity == 0.0 and rate(0.0, (0.0, 0.0))[1] <= 0.0:
            return Slide(0.0, 0.0, 0.0)
        rotation, time, omega = first_slide(rate, (0.0, velocity / self.radius), end)
        return Slide(self.radius * rotation, time, self.radius * omega)

    def factors(self, k_h: float, bishop: float) -> dict[str, float]:
        """Return three factors of safety, given Bishop's, and the share of the arc under negative normal stress."""
        columns = self.columns()
        cosine, sine, length = np.cos(columns.b), -np.sin(columns.b), columns.length  # a positive sine drives
        whole = (columns.soil + columns.load) * cosine
        weight = whole - columns.displaced * cosine
        pushed = k_h * (columns.soil + columns.load * getattr(self.slope, "k_h_on_surcharge", True)) * cosine
        drive = -((weight[3] + pushed[4]) * length).sum()
        uniform = getattr(self.slope, "pressure", 0.0)
        pressure, excess = columns.pressure + uniform, columns.excess + uniform
        lever = cosine + sine * columns.friction / bishop
        x = np.sin(columns.b)
        pool = 0.0 if self.pool is None else self.of_water * np.maximum(self.pool - np.interp(x, *self.lines[0].T), 0.0)
        vertical = whole[6] + (pool - pressure) * cosine
        across = {
            "paper": weight[0] + pushed[1] - excess,
            "ordinary": weight[6] * cosine - pushed[6] * sine - excess,
            "bishop": (vertical - columns.cohesion * sine / bishop) / lever,
        }
        strength = {name: columns.cohesion + columns.friction * normal for name, normal in across.items()}
        factors = {name: float((value * length).sum() / drive) for name, value in strength.items()}
        negative = max((length * (across[name] < 0.0)).sum() for name in ("ordinary", "bishop"))
        return factors | {"negative": float(negative / length.sum())}

    def factor(self, method: str, k_h: float = 0.0) -> float:
        """Return the factor of safety by a method."""
        if method != "bishop":
            return self.factors(k_h, 1.0)[method]
        near = self.factor("paper", k_h)
        ends = 0.7 * near, 3.0 * near
        return float(brentq(lambda f: self.factors(k_h, f)["bishop"] - f, *ends, xtol=1e-15, rtol=1e-14))

    def strength_factor(self, method: str, shaken: bool = False) -> float:
        """Return the factor of strength with which the closure has the result of a method."""
        if not shaken:
            return self.factor(method) / self.factor("paper")
        k_h = brentq(lambda k: self.factor(method, k) - 1.0, -0.2, 0.2, xtol=1e-16, rtol=1e-14)
        return 1.0 / self.factor("paper", k_h)
