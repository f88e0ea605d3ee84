"""Motions in standing water and plain integrations: ``python -m tests.campaigns.standing_water 200 --seed 1``.

Homogeneous masses along rays from the centre of the circle; layered ones point by point, along the verticals that the
mass has at its start. Both by Gauss' rule between all kinks, and in time by DOP853. Nothing of the package but the
scenes is used.
"""

import argparse
import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from slipcircle import LayeredSection, Scene, Section, Soil, solve
from slipcircle.base.kinds import Floats

GRAVITY, WATER = 9.81, 9810.0
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


class Pool(NamedTuple):
    """A slope that falls to the right into a pool, its mass, and what lies along its arc from the entry."""

    ground: Floats  # (V, 2)
    centre: tuple[float, float]
    radius: float
    level: Floats  # of the water, horizontal from the shore on
    unit_weight: float
    joint: float | None  # height of the boundary below which the second soil lies
    soils: tuple[tuple[float, float], ...]  # friction and cohesion, from the ground down
    strength: str = "base"
    velocity: float = 0.0

    def section(self, facing: float = 1.0, shift: float = 0.0) -> Section:
        """The section, also seen from behind and from elsewhere."""
        ground, level = (self.seen(line, facing, shift) for line in (self.ground, self.level))
        x, y = self.centre
        place: Any = (facing * x + shift, y)
        if self.joint is None:
            return Section(ground, place, self.radius, self.unit_weight, level=level)
        soils = [Soil(self.unit_weight, c, mu, name=f"{mu}") for mu, c in self.soils]
        layers = [(soils[0], None), (soils[1], self.joint)]
        return LayeredSection(ground, place, self.radius, level=level, layers=layers, strength=self.strength)

    @staticmethod
    def seen(line: Floats, facing: float, shift: float) -> Floats:
        return (line * [facing, 1.0])[:: int(facing)] + [shift, 0.0]

    def scene(self, **where: float) -> Scene:
        effects: dict[str, Any] = {"rotation": {}, "centripetal": {}}
        section = self.section(**where)
        if self.joint is not None:
            return Scene(section, effects=effects, initial_velocity=self.velocity)
        (mu, cohesion), *_ = self.soils
        return Scene(section, mu, effects | {"cohesion": {"cohesion": cohesion}}, initial_velocity=self.velocity)


def drawn(rng: np.random.Generator) -> Pool:
    """A random pool whose slope slides."""
    while True:
        height, run = rng.uniform(8, 20), rng.uniform(15, 40)
        middle = rng.uniform(0.3, 0.7)
        bend = (middle * run, height * (1 - middle) * rng.uniform(0.8, 1.1))
        ground = np.array([(-60.0, height), (0.0, height), bend, (run, 0.0), (run + 60, 0.0)])
        pool = height * rng.uniform(0.05, 0.8)
        shore = float(np.interp(-pool, -ground[:, 1], ground[:, 0]))
        level = np.array([(-60.0, pool + rng.uniform(0.0, 0.9) * (height - pool)), (shore, pool), (run + 60, pool)])
        if np.any(np.interp(ground[:2, 0], *level.T) > height - 0.2):
            continue
        x = run * rng.uniform(0.3, 0.8)
        y = height * rng.uniform(1.3, 2.5)
        radius = y + rng.uniform(-0.1, 0.3) * height
        unit_weight = rng.uniform(18e3, 22e3)
        layered = rng.random() < 0.5
        soils = tuple((rng.uniform(0.1, 0.45), rng.uniform(0.0, 8e3)) for _ in range(2))
        joint = float(rng.uniform(0.1, 0.6) * height) if layered else None
        strength = "mass" if rng.random() < 0.3 else "base"
        velocity = float(rng.uniform(0.0, 3.0)) if rng.random() < 0.3 else 0.0
        made = Pool(ground, (x, y), radius, level, unit_weight, joint, soils, strength, velocity)
        try:
            motion = solve(made.scene())
        except ValueError:
            continue
        section: Any = made.section()
        stays = abs(motion.end.displacement) == abs(motion.run_out)
        if motion.arrested and stays and motion.run_out > 0.05 and section.facing > 0 and motion.end.rotation < 1.2:
            return made


class Truth:
    """Moments of a pool about the centre as functions of the rotation."""

    def __init__(self, pool: Pool) -> None:
        self.pool = pool
        section: Any = pool.section()
        x, y = pool.centre
        is_wet = section.exit[1] < pool.level[-1, 1]  # a pool beside the mass is no reference
        self.level = float(pool.level[-1, 1]) - y if is_wet else -10.0 * pool.radius
        self.first, self.last = (math.atan2(p[0] - x, y - p[1]) for p in (section.entry, section.exit))
        inside = (pool.ground[:, 0] > section.entry[0]) & (pool.ground[:, 0] < section.exit[0])
        self.surface = np.concatenate([[section.entry], pool.ground[inside], [section.exit]]) - pool.centre
        self.joints = [self.first, self.last]
        if pool.joint is not None:
            half = math.acos(min(1.0, max(-1.0, (y - pool.joint) / pool.radius)))
            self.joints = sorted([self.first, self.last, *np.clip([-half, half], self.first, self.last)])

    def along(self, cuts: Any, function: Callable[[Floats], Floats]) -> float:
        """The integral of a function over the arc in the mass, between cuts."""
        places = np.unique(np.clip([self.first, self.last, *cuts], self.first, self.last))
        total = 0.0
        for a, b in pairwise(places.tolist()):
            total += float(np.sum(WEIGHTS * function((a + b) / 2 + (b - a) / 2 * NODES))) * (b - a) / 2
        return total

    def on_level(self, rotation: float) -> list[Floats]:
        """Points of the turned surface on the level, as they are in the mass."""
        c, s = math.cos(rotation), math.sin(rotation)
        points = []
        for p, q in pairwise(self.surface):
            low, high = (r[0] * s + r[1] * c - self.level for r in (p, q))
            if low * high < 0.0:
                points.append(p + (q - p) * low / (low - high))
        return points

    def at_arc(self, rotation: float) -> list[float]:
        """Directions in the mass where the arc passes the level."""
        reach = math.acos(min(1.0, max(-1.0, -self.level / self.pool.radius)))
        return [reach - rotation, -reach - rotation]

    def pressure(self, b: Floats) -> Floats:
        """Pore pressure in excess of the pool's on the arc in space."""
        x, y = self.pool.centre
        r = self.pool.radius
        head = np.interp(x + r * np.sin(b), *self.pool.level.T) - (y - r * np.cos(b))
        return WATER * (np.maximum(head, 0.0) - np.maximum(self.level + r * np.cos(b), 0.0))

    def water_cuts(self, rotation: float) -> list[float]:
        """Directions in the mass at which the pore pressure has kinks: below vertices, and at the arc."""
        (x, y), r = self.pool.centre, self.pool.radius
        sines = (self.pool.level[:, 0] - x) / r
        cuts = [math.asin(v) for v in sines if abs(v) < 1.0]
        for p, q in pairwise(self.pool.level - (x, y)):
            a, b, c = float((q - p) @ (q - p)), float(p @ (q - p)), float(p @ p) - r * r
            root = b * b - a * c
            if root > 0.0:
                cuts += [
                    math.atan2(*(v * [1, -1])) for v in (p + (q - p) * (-b + k * math.sqrt(root)) / a for k in (-1, 1))
                ]
        return [b - rotation for b in cuts]

    # --- by rays -----------------------------------------------------------------------------------------------------

    def ray(self, b: Floats) -> Floats:
        """Distance of the surface from the centre in directions of the mass."""
        directions = np.arctan2(self.surface[:, 0], -self.surface[:, 1])
        edge = np.clip(np.searchsorted(directions, b) - 1, 0, len(directions) - 2)
        p, q = self.surface[edge], self.surface[edge + 1]
        normal = np.stack([-(q - p)[:, 1], (q - p)[:, 0]], axis=1)
        unit = np.stack([np.sin(b), -np.cos(b)], axis=1)
        return np.sum(p * normal, axis=1) / np.sum(unit * normal, axis=1)

    def by_rays(self, rotation: float, omega: float) -> tuple[float, float, float]:
        """Driving moment, friction, and moment of inertia, for one soil."""
        pool, r = self.pool, self.pool.radius
        corners = [math.atan2(p[0], -p[1]) for p in self.surface]
        level = [math.atan2(p[0], -p[1]) for p in self.on_level(rotation)]
        cuts = corners + level + self.at_arc(rotation)

        def powers(b: Floats, n: int) -> tuple[Floats, Floats]:
            near = self.ray(b)
            cosine = np.cos(b + rotation)
            wet = np.where(
                cosine * r > -self.level, np.maximum(near, -self.level / np.where(cosine > 0.0, cosine, 1.0)), r
            )
            return (r**n - near**n) / n, (r**n - np.minimum(wet, r) ** n) / n

        def weight(b: Floats, n: int) -> Floats:
            dry, wet = powers(b, n)
            return pool.unit_weight * dry - WATER * wet

        drive = self.along(cuts, lambda b: -np.sin(b + rotation) * weight(b, 3))
        polar = self.along(corners, lambda b: powers(b, 3)[0]) * pool.unit_weight / GRAVITY
        normal = self.along(cuts, lambda b: np.cos(b + rotation) * weight(b, 2)) + polar * omega**2
        normal -= r * self.along(self.water_cuts(rotation), lambda b: self.pressure(b + rotation))
        (mu, cohesion), *_ = pool.soils
        resistance = r * (cohesion * r * (self.last - self.first) + mu * max(normal, 0.0))
        inertia = self.along(corners, lambda b: powers(b, 4)[0]) * pool.unit_weight / GRAVITY
        return drive, resistance, inertia

    # --- point by point ----------------------------------------------------------------------------------------------

    def by_points(self, rotation: float, omega: float) -> tuple[float, float, float]:
        """The same of layers, whose friction takes the normal force of the strip above each stretch."""
        pool, r = self.pool, self.pool.radius
        c, s = math.cos(rotation), math.sin(rotation)
        corners = [math.asin(min(1.0, max(-1.0, p[0] / r))) for p in self.surface]
        level = [math.asin(min(1.0, max(-1.0, p[0] / r))) for p in self.on_level(rotation)]
        joints = self.joints[1:-1]
        in_mass = joints if pool.strength == "mass" else [b - rotation for b in joints]
        cuts = corners + level + self.at_arc(rotation) + in_mass + self.water_cuts(rotation)

        def over_strip(b: Floats, function: Callable[[Any, Any], Any], wet: bool) -> Floats:
            x = r * np.sin(b)
            low, top = -r * np.cos(b), np.interp(x, *self.surface.T)
            if wet:
                top = np.maximum(low, np.minimum(top, (self.level - x * s) / c))
            half = (top - low) / 2
            y = low + half * (1.0 + NODES[:, None])
            return np.sum(function(x, y) * WEIGHTS[:, None] * half, axis=0) * r * np.cos(b)

        def weighed(b: Floats, function: Callable[[Any, Any], Any]) -> Floats:
            return pool.unit_weight * over_strip(b, function, False) - WATER * over_strip(b, function, True)

        def soil(b: Floats) -> Floats:
            place = b if pool.strength == "mass" else np.clip(b + rotation, None, self.last)
            height = pool.centre[1] - r * np.cos(np.maximum(place, self.first))
            assert pool.joint is not None
            return (height < pool.joint).astype(int)

        mus, cohesions = (np.array(v) for v in zip(*pool.soils, strict=True))

        def normal(b: Floats) -> Floats:
            weight = weighed(b, lambda x, y: -(x * s + y * c) / np.hypot(x, y))
            inertia = over_strip(b, np.hypot, False) * pool.unit_weight / GRAVITY
            return weight + inertia * omega**2 - r * self.pressure(b + rotation)

        drive = self.along(cuts, lambda b: weighed(b, lambda x, y: -(x * c - y * s)))
        friction = self.along(cuts, lambda b: mus[soil(b)] * normal(b))
        cohesion = self.along(cuts, lambda b: cohesions[soil(b)]) * r
        inertia = self.along(corners, lambda b: over_strip(b, lambda x, y: x * x + y * y, False))
        return drive, r * (cohesion + max(friction, 0.0)), inertia * pool.unit_weight / GRAVITY

    def motion(self) -> tuple[float, float, float]:
        """Run-out, duration and peak velocity of the first motion down-slope."""
        at = self.by_rays if self.pool.joint is None else self.by_points

        def rate(_: float, state: Floats) -> list[float]:
            drive, resistance, inertia = at(*state)
            return [state[1], (drive - resistance) / inertia]

        def stops(_: float, state: Floats) -> float:
            return float(state[1])

        stops.terminal, stops.direction = True, -1.0  # type: ignore[attr-defined]
        start = [0.0, self.pool.velocity / self.pool.radius]
        found = solve_ivp(rate, (0.0, 200.0), start, "DOP853", events=stops, rtol=1e-11, atol=1e-13, dense_output=True)
        ((rotation, _),) = found.y_events[0]
        end = found.t_events[0][0]
        times = np.linspace(0.0, end, 201)
        for _ in range(3):  # ever closer to the peak
            peak = int(np.argmax(found.sol(times)[1]))
            times = np.linspace(times[max(peak - 1, 0)], times[min(peak + 1, 200)], 201)
        return rotation * self.pool.radius, end, found.sol(times)[1].max() * self.pool.radius


def difference(pool: Pool) -> float:
    """The greatest relative difference of run-out, duration and peak velocity from the truth."""
    motion = solve(pool.scene())
    found = np.array([motion.run_out, motion.duration, motion.peak.velocity])
    return float(np.max(np.abs(found / Truth(pool).motion() - 1.0)))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    worst = 0.0
    for number in range(options.count):
        pool = drawn(rng)
        error = difference(pool)
        if error > worst:
            worst = error
            print(number, f"{error:.1e}", pool, flush=True)
    print(f"{options.count} motions in standing water: greatest difference {worst:.1e}")


if __name__ == "__main__":
    main()
