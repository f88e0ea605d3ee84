"""Forces and factors of safety along the arc of a layered mass from their definitions, by Gauss' rule between kinks.

Directions b are from straight below the centre, down-slope positive. Of the package it takes the numbers of the slope
and of the circle; nothing that it computes.
"""

from functools import lru_cache
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

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
    """Over y of -y/rho, x/rho, rho, x, y, rho^2 and 1, rho the distance from the centre."""
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


class Columns(NamedTuple):
    """Vertical strips above nodes of the arc, and what acts at their bases."""

    b: Any
    length: Any  # of the arc, over R
    soil: Any  # weight over breadth times the integrands of `antiderivatives`, Pa
    load: Any  # likewise of the surcharges
    friction: Any
    cohesion: Any
    pressure: Any


class AlongTheArc:
    """A slope above a circle: x from its centre down-slope, y up, both over its radius."""

    def __init__(self, slope: Any, circle: Any) -> None:
        self.slope, self.radius, self.facing = slope, float(circle.radius), int(circle.facing)
        self.centre = np.array(circle.centre, dtype=np.float64)
        foreland = getattr(slope, "foreland", None)
        self.soils = [*(soil for soil, _ in slope.layers), *([foreland] if foreland else [])]
        self.farthest = np.inf if foreland else -np.inf
        tops = [slope.ground, *(top for _, top in slope.layers[1:]), -1e9 if slope.level is None else slope.level]
        every = [self.line(top) for top in (*tops, *(soil.datum or 0.0 for soil in self.soils))]
        self.lines, self.level = every[: len(slope.layers)], every[len(slope.layers)]
        self.datum = np.array([y for (_, y), *_ in every[len(tops) :]])
        self.loads = [(*self.line([(x, 0.0) for x in load[:2]])[:: self.facing, 0], *load[2:])
                      for load in slope.surcharge]  # fmt: skip
        vertices = [line[:, 0] for line in every] + [load[:2] for load in self.loads]
        self.kinks = kinks_of(every, np.unique(np.concatenate(vertices)))
        self.ends = np.arcsin(np.sort(self.line([circle.entry, circle.exit])[:, 0]))

    def line(self, top: Any) -> Any:
        """A line of the slope, or a height, with x that grows."""
        points = np.asarray(top) if np.ndim(top) else np.array([[self.centre[0], top]])
        return (points - self.centre)[:: self.facing] * [self.facing / self.radius, 1.0 / self.radius]

    def weights(self, b: Any) -> tuple[Any, Any]:
        """Of the soils, and of the surcharges, above points of the arc."""
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

    @lru_cache(1)  # noqa: B019 (one question follows another of the same state)
    def columns(self, rotation: float = 0.0, strength: str = "base") -> Columns:
        """After the mass has turned; strength is that of the base or turns with the mass."""
        first, last = self.ends
        edges = np.concatenate([self.kinks, self.kinks - rotation, self.ends - rotation, np.linspace(first, last, 9)])
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
        names = ("friction", "cohesion", "cohesion_gradient", "pore_ratio")
        numbers = np.array([[getattr(soil, name) for name in names] for soil in self.soils])
        friction, cohesion, gradient, ratio = numbers.T[:, which]
        cohesion = cohesion + gradient * self.radius * np.maximum(self.datum[which] + np.cos(base), 0.0)
        head = np.maximum(np.interp(np.sin(b + rotation), *self.level.T) + np.cos(b + rotation), 0.0)
        pressure = np.where(ratio > 0.0, ratio * soil[6], self.slope.water_unit_weight * self.radius * head)
        return Columns(b, half * WEIGHTS[:, None], soil, load, friction, cohesion, pressure)

    def normal(self, state: Any, columns: Columns) -> Any:
        """Total normal stress on the arc, Pa."""
        turn, speed = float(state.rotation), state.angular_velocity**2 * self.radius / self.slope.gravity
        radial, tangential, polar, *_ = (columns.soil + columns.load) * np.cos(columns.b)
        return radial * np.cos(turn) - tangential * np.sin(turn) + speed * polar

    def means(self, state: Any) -> tuple[float, float]:
        """Of total normal stress and of pore pressure along the arc, Pa."""
        columns = self.columns(float(state.rotation), self.slope.strength)
        sums = [(value * columns.length).sum() for value in (self.normal(state, columns), columns.pressure)]
        return sums[0] / np.ptp(self.ends), sums[1] / np.ptp(self.ends)

    def acceleration(self, state: Any) -> float:
        """Of a turning layered mass, m/s^2."""
        section, turn = self.slope, float(state.rotation)
        columns = self.columns(turn, section.strength)
        _, _, _, x, y, inertia, _ = (columns.soil + columns.load) * np.cos(columns.b)
        friction = columns.friction * (self.normal(state, columns) - columns.pressure)
        integrands = (friction, columns.cohesion, y * np.sin(turn) - x * np.cos(turn), inertia)
        gripping, cohesion, driving, mass = (float((value * columns.length).sum()) for value in integrands)
        moment = driving - np.sign(state.velocity) * (max(gripping, 0.0) + cohesion)
        return section.gravity * moment / mass

    def factors(self, k_h: float, bishop: float) -> dict[str, float]:
        """By three methods, Bishop's from his own, and the share of the arc under negative normal stress."""
        columns = self.columns()
        cosine, sine, length = np.cos(columns.b), -np.sin(columns.b), columns.length  # a positive sine drives
        weight = (columns.soil + columns.load) * cosine
        pushed = k_h * (columns.soil + columns.load * self.slope.k_h_on_surcharge) * cosine
        drive = -((weight[3] + pushed[4]) * length).sum()
        pressure = columns.pressure + self.slope.pressure
        lever = cosine + sine * columns.friction / bishop
        vertical = weight[6] - pressure * cosine
        across = {
            "paper": weight[0] + pushed[1] - pressure,
            "ordinary": weight[6] * cosine - pushed[6] * sine - pressure,
            "bishop": (vertical - columns.cohesion * sine / bishop) / lever,
        }
        strength = {name: columns.cohesion + columns.friction * normal for name, normal in across.items()}
        factors = {name: float((value * length).sum() / drive) for name, value in strength.items()}
        negative = max((length * (across[name] < 0.0)).sum() for name in ("ordinary", "bishop"))
        return factors | {"negative": float(negative / length.sum())}
