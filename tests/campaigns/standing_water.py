"""Motions in standing water and plain integrations: ``python -m tests.campaigns.standing_water 200 --seed 1``.

Of one soil and of two, with initial velocities; `tests.support.along_the_arc` integrates.
"""

import argparse
from typing import Any, NamedTuple

import numpy as np

from slipcircle import LayeredSection, Scene, Section, Soil, solve
from slipcircle.base.kinds import Floats
from tests.support.along_the_arc import of_scene


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


def difference(pool: Pool) -> float:
    """The greatest relative difference of run-out, duration and peak velocity from the truth."""
    motion = solve(pool.scene())
    found = np.array([motion.run_out, motion.duration, motion.peak.velocity])
    truths = np.array(of_scene(motion.plan.scene).motion(velocity=pool.velocity))
    return float(np.max(np.abs(found / truths - 1.0)))


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
