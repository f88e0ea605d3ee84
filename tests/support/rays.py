"""Motions and factors of safety of random slopes by plain integration: rays from the centre, DOP853 in time.

Moments are sums over rays from the centre of the circle, water is the mean of its head along the arc in its turned
position, and Bishop's factor and the yield coefficients are integrals over vertical slices. Nothing here knows a line
of the package. Rays and slices are Gauss points between the kinks of what is integrated.
"""

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from copy import copy
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

GAMMA_W, G = 9810.0, 9.81
NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
Line = list[list[float]]


@dataclass
class Slope:
    """A slope that falls to the right, with one soil and its circle."""

    ground: Line
    centre: tuple[float, float]
    radius: float
    gamma: float
    cohesion: float
    peak: float  # tan(phi)
    residual: float
    length: float
    level: Line | None = None
    ratio: float = 0.0
    shaken: bool = False
    pool: float | None = None  # level of standing water at the exit, with which `level` ends
    lost: float = 0.0  # share of the cohesion that slip takes away, exponentially
    lost_length: float = 1.0
    ends: tuple[float, float] = field(init=False)  # of the arc, from straight below the centre to the right

    def __post_init__(self) -> None:
        crossings = [a for a in self._crossings(self.ground) if abs(a) < math.pi / 2]
        self.ends = min(crossings), max(crossings)

    def _crossings(self, line: Line) -> list[float]:
        """Return the angles at which a line crosses the circle."""
        found = []
        for p, q in pairwise(line):
            (x, y), (u, v) = np.subtract(p, self.centre), np.subtract(q, p)
            roots = np.roots([u * u + v * v, 2 * (x * u + y * v), x * x + y * y - self.radius**2])
            for t in roots[np.isreal(roots)].real:
                if 0.0 <= t <= 1.0:
                    found.append(math.atan2(x + t * u, -(y + t * v)))
        return found

    def points(self, kinks: list[float]) -> tuple[Any, Any]:
        """Return angles between the ends and the weights of their integral, with kinks between the pieces."""
        first, last = self.ends
        inner = [a for a in kinks if first < a < last]
        edges = np.sort([*np.linspace(first, last, 4), *inner])
        half = np.diff(edges)[:, None] / 2
        middle = (edges[1:] + edges[:-1])[:, None] / 2
        return (middle + half * NODES).ravel(), (half * WEIGHTS).ravel()

    def turned(self, turn: float) -> "Slope":
        """Return the mass after a rotation, with the friction that is left, under a level that stays."""
        first, last = self.ends
        x, y = np.subtract(self.ground, self.centre).T
        a, r = np.arctan2(x, -y), np.hypot(x, y) / self.radius
        inside = (first < a) & (a < last)
        a, r = np.array([first, *a[inside], last]) + turn, self.radius * np.array([1.0, *r[inside], 1.0])
        slope = copy(self)
        slope.ground = (np.stack([r * np.sin(a), -r * np.cos(a)], axis=1) + self.centre).tolist()
        slope.ends = first + turn, last + turn
        slope.peak = self.residual + (self.peak - self.residual) * math.exp(-self.radius * turn / self.length)
        return slope

    # --- the motion ---

    def distance(self, a: Any) -> Any:
        """Return the distance of the ground over R from the centre along rays."""
        line = np.subtract(self.ground, self.centre) / self.radius
        rho = np.full(a.size, np.nan)
        for (x, y), (u, v) in zip(line, np.diff(line, axis=0), strict=False):
            s, c = np.sin(a), -np.cos(a)
            with np.errstate(divide="ignore", invalid="ignore"):
                t = (x * c - y * s) / (v * s - u * c)  # where the edge meets the ray
                hit = (t >= -1e-13) & (t <= 1 + 1e-13)
                rho = np.where(hit, np.hypot(x + t * u, y + t * v), rho)
        return rho

    def corners(self) -> list[float]:
        """Return the directions of the vertices of the ground."""
        return [math.atan2(x, -y) for x, y in np.subtract(self.ground, self.centre)]

    def moments(self) -> dict[str, float]:
        """Return the moments of the mass by rays from the centre, lengths over R."""
        a, w = self.points(self.corners())
        rho = self.distance(a)
        second, third, fourth = ((1 - rho**n) / n for n in (2, 3, 4))
        return {
            "theta": w @ fourth,
            "polar": w @ third,
            "radial_cos": w @ (second * np.cos(a)),
            "radial_sin": w @ (second * np.sin(a)),
            "moment_cos": w @ (third * np.cos(a)),
            "moment_sin": w @ (third * np.sin(a)),
        }

    def _at_pool(self) -> list[float]:
        """Return the directions in which the circle is at the level of the pool."""
        if self.pool is None or self.centre[1] - self.pool > self.radius:
            return []
        direction = math.acos((self.centre[1] - self.pool) / self.radius)
        return [-direction, direction]

    def drowned(self, turn: float) -> tuple[float, float]:
        """Return driving moment and radial weight of the water that the turned mass displaces, over those of soil."""
        if self.pool is None:
            return 0.0, 0.0
        deep = (self.centre[1] - self.pool) / self.radius  # of the level below the centre
        (c, s), line = (math.cos(turn), math.sin(turn)), np.subtract(self.ground, self.centre) / self.radius
        turned = line @ np.array([[c, s], [-s, c]])
        kinks = self.corners()
        for (x, y), (u, v) in zip(turned, np.diff(turned, axis=0), strict=False):
            if (y + deep) * (y + v + deep) < 0.0:
                kinks.append(math.atan2(x - u * (y + deep) / v, deep) - turn)
        kinks += [b - turn for b in self._at_pool()]
        a, w = self.points(kinks)
        low = np.minimum(np.maximum(self.distance(a), deep / np.cos(a + turn)), 1.0)
        share = GAMMA_W / self.gamma
        return (
            float(-share * w @ (np.sin(a + turn) * (1 - low**3) / 3)),
            float(share * w @ (np.cos(a + turn) * (1 - low**2) / 2)),
        )

    def head(self, turn: float) -> float:
        """Return the mean head of the level over R along the arc after a rotation."""
        if self.level is None:
            return 0.0
        x0, y0 = self.centre
        kinks = [math.asin(max(-1.0, min(1.0, (x - x0) / self.radius))) - turn for x, _ in self.level]
        kinks += [b - turn for b in self._crossings(self.level)]
        kinks += [b - turn for b in self._at_pool()]
        a, w = self.points(kinks)
        x, y = x0 + self.radius * np.sin(a + turn), y0 - self.radius * np.cos(a + turn)
        height = np.maximum(np.interp(x, *np.transpose(self.level)) - y, 0.0)
        if self.pool is not None:
            height = height - np.maximum(self.pool - y, 0.0)
        return float(w @ height / w.sum() / self.radius)

    def motion(self, factor: float) -> tuple[float, float, float]:
        """Return displacement and time of the first standstill and the greatest velocity, with strength times a factor.

        Zeros if the mass does not move.
        """
        m = self.moments()
        alpha = (self.ends[1] - self.ends[0]) / 2
        lever = 2 * alpha * (1 - math.cos(alpha))
        weight = self.gamma * self.radius
        height, w = self._slices()[2:4]
        cover = (w @ height) / (2 * alpha) / (1 - math.cos(alpha))

        def rate(_: float, state: Any) -> list[float]:
            turn, omega = state
            c, s = math.cos(turn), math.sin(turn)
            drive = -(m["moment_sin"] * c + m["moment_cos"] * s)
            radial = m["radial_cos"] * c - m["radial_sin"] * s
            lifting, lighter = self.drowned(turn)
            drive, radial = drive - lifting, radial - lighter
            water = GAMMA_W * self.head(turn) / self.gamma / (1 - math.cos(alpha))
            water += self.ratio * cover * radial / m["radial_cos"]
            mu = self.residual + (self.peak - self.residual) * math.exp(-self.radius * turn / self.length)
            normal = max(radial + m["polar"] * omega**2 - lever * water, 0.0)
            kept = 1.0 - self.lost * -math.expm1(-self.radius * turn / self.lost_length)
            cohesion = 2 * alpha * self.cohesion / weight * kept
            return [omega, (drive - factor * (cohesion + mu * normal)) / m["theta"]]

        if rate(0.0, (0.0, 0.0))[1] <= 0.0:
            return 0.0, 0.0, 0.0
        second = math.sqrt(self.radius / G)
        stops: Callable[..., float] = lambda t, state: state[1] if t > 0.0 else 1.0  # noqa: E731
        fastest: Callable[..., float] = lambda t, state: rate(t, state)[1]  # noqa: E731
        stops.terminal, stops.direction = True, -1.0  # type: ignore[attr-defined]
        run = solve_ivp(rate, (0, 1e3), (0.0, 0.0), "DOP853", rtol=3e-13, atol=1e-15, events=(stops, fastest))
        peak = max(state[1] for state in run.y_events[1])
        return self.radius * run.y_events[0][0][0], second * run.t_events[0][0], self.radius / second * peak

    # --- factors of safety ---

    def _slices(self) -> tuple[Any, ...]:
        """Return sine, cosine, height over R and weight of slices, and their pore pressure over gamma R."""
        x0, y0 = self.centre
        lines = [self.ground, *([self.level] if self.level else [])]
        kinks = [math.asin(max(-1.0, min(1.0, (x - x0) / self.radius))) for line in lines for x, _ in line]
        a, w = self.points(kinks + (self._crossings(self.level) if self.level else []) + self._at_pool())
        s, c = np.sin(a), np.cos(a)
        x, y = x0 + self.radius * s, y0 - self.radius * c
        height = (np.interp(x, *np.transpose(self.ground)) - y) / self.radius
        pressure = self.ratio * height
        if self.level:
            head = np.maximum(np.interp(x, *np.transpose(self.level)) - y, 0.0) / self.radius
            pressure = pressure + GAMMA_W / self.gamma * head
        return s, c, height, w, pressure

    def _standing(self) -> tuple[Any, Any, Any]:
        """Return standing water over gamma R at the slices: on the ground, displaced by the slice, and at its base."""
        s, c, height, *_ = self._slices()
        if self.pool is None:
            return (np.zeros_like(s),) * 3
        y = self.centre[1] - self.radius * c
        ground = y + self.radius * height
        heads = self.pool - ground, np.minimum(self.pool, ground) - y, self.pool - y
        scale = GAMMA_W / self.gamma / self.radius
        on_ground, displaced, at_base = (scale * np.maximum(head, 0.0) for head in heads)
        return on_ground, displaced, at_base

    def bishop(self, k_h: float = 0.0) -> float:
        """Return Bishop's factor of safety, less 1 if it is asked for the k_h at which that is 0."""
        s, c, height, w, pressure = self._slices()
        on_ground, displaced, _ = self._standing()
        drive = w @ (-(height - displaced) * s * c + k_h * height * c * (c - height / 2))
        strength = (self.cohesion / self.gamma / self.radius + self.peak * (height + on_ground - pressure)) * c

        def unbalanced(factor: float) -> float:
            return float(factor * drive - w @ (strength / (c - s * self.peak / factor)))

        return float(brentq(unbalanced, 0.3, 10.0, xtol=1e-15, rtol=1e-14))

    def paper(self, k_h: float = 0.0) -> float:
        """Return the factor of safety of the closure."""
        m, (_, _, _, w, pressure) = self.moments(), self._slices()
        alpha = (self.ends[1] - self.ends[0]) / 2
        lifting, lighter = self.drowned(0.0)
        drive = -m["moment_sin"] - lifting + k_h * m["moment_cos"]
        normal = m["radial_cos"] - lighter + k_h * m["radial_sin"] - w @ (pressure - self._standing()[2])
        cohesion = 2 * alpha * self.cohesion / self.gamma / self.radius
        return float((cohesion + self.peak * max(normal, 0.0)) / drive)

    @property
    def strength_factor(self) -> float:
        """Return the factor of strength with which the closure has Bishop's result."""
        if self.shaken:
            k_h = brentq(lambda k: self.bishop(k) - 1.0, -0.2, 0.6, xtol=1e-16, rtol=1e-14)
            return 1.0 / self.paper(k_h)
        return self.bishop() / self.paper()

    @property
    def file(self) -> str:
        """Return its scene file."""
        pairs = {"ground": self.ground, "level": self.level}
        text = {name: [list(map(float, point)) for point in line] for name, line in pairs.items() if line}
        water = f"[water]\nlevel_m = {text['level']}\n" if self.level else ""
        ratio = f"[pore_pressure]\nratio = {self.ratio}\n" if self.ratio else ""
        shaking = '[shaking]\npulse = "sine"\namplitude_g = 0.0\nduration_s = 1\n' if self.shaken else ""
        cohesion = f"cohesion_kPa = {self.cohesion / 1e3!r}\n"
        if self.lost:
            residual = (1.0 - self.lost) * self.cohesion / 1e3
            cohesion = f'law = "exponential"\npeak_kPa = {self.cohesion / 1e3!r}\nresidual_kPa = {residual!r}\n'
            cohesion += f"length_m = {self.lost_length!r}\n"
        return (
            f"[ground]\npoints_m = {text['ground']}\nunit_weight_kN_m3 = {self.gamma / 1e3!r}\n"
            f"[circle]\ncentre_m = {list(self.centre)}\nradius_m = {self.radius!r}\n"
            f'[friction]\nlaw = "exponential"\npeak = {self.peak!r}\nresidual = {self.residual!r}\n'
            f"length_m = {self.length!r}\n[cohesion]\n{cohesion}"
            f"[rotation]\n[centripetal]\n{water}{ratio}{shaking}"
        )


def random_slopes(seed: int, combined: bool = False) -> Iterator[Slope]:
    """Yield random slopes whose factor of safety by Bishop's method is about 1.

    Combined ones have cohesion that softens, and many of them standing water at the toe.
    """
    rng = np.random.default_rng(seed)
    while True:
        with suppress(ValueError):  # no friction in the range gives this factor, or the pool is elsewhere
            slope = _random_slope(rng, combined)
            slope.strength_factor  # noqa: B018
            yield slope


def _random_slope(rng: np.random.Generator, combined: bool) -> Slope:
    """Return a random slope."""
    height, run = rng.uniform(5.0, 30.0), rng.uniform(1.2, 3.0)
    edge = height * run
    bench = [[0.4 * edge, height * rng.uniform(0.5, 0.7)]] if rng.random() < 0.5 else []
    ground = [[-4 * edge, height], [0.0, height], *bench, [edge, 0.0], [5 * edge, 0.0]]
    centre = (float(edge * rng.uniform(0.5, 0.9)), float(height * rng.uniform(1.6, 3.0)))
    radius = float(centre[1] * rng.uniform(1.0, 1.15))
    level, ratio, pool = None, 0.0, None
    if rng.random() < 0.4:
        level = [[-4 * edge, 0.8 * height], [0.0, 0.6 * height], [edge, 0.0], [5 * edge, 0.0]]
    elif rng.random() < 0.5:
        ratio = float(rng.uniform(0.05, 0.3))
    gamma = float(rng.uniform(16e3, 22e3))
    cohesion = float(gamma * height * rng.uniform(0.0, 0.05))
    shaken = bool(rng.random() < 0.3)
    lost, lost_length = 0.0, 1.0
    if combined:
        shaken, cohesion = False, 2.0 * cohesion
        lost, lost_length = float(rng.uniform(0.1, 0.9)), float(height * rng.uniform(0.01, 0.2))
        if rng.random() < 0.7:
            ratio, pool = 0.0, float(height * rng.uniform(0.05, 0.45))
            shore = float(np.interp(-pool, *np.transpose([[-y, x] for x, y in ground[1:-1]])))
            upper = pool + float(rng.uniform(0.0, 0.6)) * (height - pool)
            level = [[-4 * edge, upper], [0.0, upper], [shore, pool], [5 * edge, pool]]
    slope = Slope(
        ground, centre, radius, gamma, cohesion, 0.3, 0.2, height / 20, level, ratio, shaken, pool, lost, lost_length
    )

    if pool is not None and centre[1] - radius * math.cos(slope.ends[1]) > pool:
        raise ValueError("the pool does not reach the mass")

    def with_friction(peak: float) -> float:
        slope.peak = peak
        return slope.bishop()

    wanted = rng.uniform(0.9, 1.02)
    slope.peak = float(brentq(lambda mu: with_friction(mu) - wanted, 1e-3, 1.2))
    slope.residual = float(slope.peak * rng.uniform(0.75, 1.0))
    return slope


def from_method(scene: Any, method: str) -> Any:
    """Return a scene on a ground that starts from the factor of safety of a method."""
    return replace(scene, start=method)
