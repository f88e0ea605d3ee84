"""Motions that combine starts by any method, softening, growing cohesion and standing water, by plain integration.

``python -m tests.campaigns.combined [COUNT] [--seed N]`` draws slopes of one soil and of layers, some with an initial
velocity, solves their scene files and prints the greatest relative difference of strength factor, run-out, its time and
peak velocity from `tests.support.along_the_arc`.
"""

import sys
import tempfile
import warnings
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle import Motion, load, solve
from slipcircle.base.errors import UnusualInput
from tests.campaigns import options
from tests.support.along_the_arc import of_scene

BOUND = 1e-8
LAWS = ("exponential", "linear", "hyperbolic")


def _law(rng: np.random.Generator, unit: str, peak: float, law: tuple[str, float]) -> str:
    """Return the inline table of a strength that changes with slip."""
    name, length = law
    residual = peak * rng.uniform(0.5, 1.1)
    return f'{{law = "{name}", peak{unit} = {peak!r}, residual{unit} = {residual!r}, length_m = {length!r}}}'


class Drawn:
    """Random numbers of a slope, whose file depends on a factor of all strengths."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.seed = int(rng.integers(1 << 32))
        self.height = height = float(rng.uniform(5.0, 30.0))
        edge = height * rng.uniform(1.2, 3.0)
        bench = [[0.4 * edge, height * rng.uniform(0.5, 0.7)]] if rng.random() < 0.5 else []
        self.ground = [[-4 * edge, height], [0.0, height], *bench, [edge, 0.0], [5 * edge, 0.0]]
        self.centre = [edge * rng.uniform(0.5, 0.9), height * rng.uniform(1.6, 3.0)]
        self.radius = self.centre[1] * rng.uniform(1.0, 1.15)
        pool = height * rng.uniform(0.05, 0.45)
        shore = float(np.interp(-pool, *np.transpose([[-y, x] for x, y in self.ground[1:-1]])))
        upper = pool + rng.uniform(0.0, 0.6) * (height - pool)
        wet = [[-4 * edge, upper], [0.0, upper], [shore, pool], [5 * edge, pool]]
        drained = [[-4 * edge, 0.8 * height], [0.0, 0.6 * height], [edge, 0.0], [5 * edge, 0.0]]
        kinds: list[Any] = [wet, drained, None]
        self.level = kinds[rng.choice(3, p=[0.6, 0.2, 0.2])]
        self.count = int(rng.choice([1, 2, 3]))
        self.strength = str(rng.choice(["base", "mass"])) if self.count > 1 else "base"
        self.start = str(rng.choice(["bishop", "ordinary", "paper"]))
        self.shaken = rng.random() < 0.2
        self.facing = int(rng.choice([-1, 1]))
        self.wanted = rng.uniform(0.85, 1.0)
        self.velocity = float(rng.choice([0.0, 0.0, rng.uniform(0.0, 3.0)]))
        self.shift, self.scale = 0.0, 1.0  # of x, in m, and of all strengths

    def line(self, points: Any) -> list[list[float]]:
        """Return points as they are, or seen from behind."""
        return [[self.facing * float(x) + self.shift, float(y)] for x, y in points][:: self.facing]

    def file(self) -> str:
        """Return the scene file."""
        scale, rng = self.scale, np.random.default_rng(self.seed)
        shared = [(str(rng.choice(LAWS)), float(self.height * rng.uniform(0.02, 0.2))) for _ in range(2)]
        soils, layers = [], []
        for k in range(self.count):
            if self.strength == "mass":
                shared = [(str(rng.choice(LAWS)), float(self.height * rng.uniform(0.02, 0.2))) for _ in range(2)]
            gamma = float(rng.uniform(16.0, 22.0))
            friction = _law(rng, "", float(scale * rng.uniform(0.2, 0.6)), shared[0])
            cohesion = _law(rng, "_kPa", float(scale * gamma * self.height * rng.uniform(0.01, 0.06)), shared[1])
            rows = [f"cohesion_per_m_kPa = {float(scale * rng.uniform(0.1, 1.5))!r}"] if rng.random() < 0.6 else []
            if rows and rng.random() < 0.3:
                rows.append(f"datum_m = {float(self.height * rng.uniform(0.1, 1.2))!r}")
            top = self.height * rng.uniform(0.5, 0.9) - 0.3 * k * self.height
            wavy = [[-3 * self.height, top + 1.0], [0.0, top], [2 * self.height, top - 0.1 * self.height]]
            own = top if rng.random() < 0.4 else self.line(wavy)
            soils.append((gamma, friction, cohesion, "\n".join(rows)))
            layers.append(f'[[layers]]\nsoil = "s{k}"\n' + (f"top_m = {own!r}\n" if k else ""))
        ratio = 0.0 if self.level else float(rng.uniform(0.0, 0.3))
        text = f"initial_velocity_m_s = {self.velocity}\n[ground]\npoints_m = {self.line(self.ground)}\n"
        if self.count == 1:
            ((gamma, friction, cohesion, growth),) = soils
            text += f"unit_weight_kN_m3 = {gamma}\n"
            text += _table("friction", friction) + _table("cohesion", cohesion) + growth + "\n"
            text += f"[pore_pressure]\nratio = {ratio}\n" if ratio else ""
        else:
            for k, (gamma, friction, cohesion, growth) in enumerate(soils):
                text += f"[soils.s{k}]\nunit_weight_kN_m3 = {gamma}\npore_pressure_ratio = {ratio}\n{growth}\n"
                text += f"friction = {friction}\ncohesion = {cohesion}\n"
            text += "".join(layers) + f'[slip]\nstrength = "{self.strength}"\n'
        text += f"[circle]\ncentre_m = {self.line([self.centre])[0]}\nradius_m = {self.radius}\n"
        text += f'start = "{self.start}"\n[rotation]\n[centripetal]\n'
        text += f"[water]\nlevel_m = {self.line(self.level)}\n" if self.level else ""
        return text + ('[shaking]\npulse = "sine"\namplitude_g = 0.0\nduration_s = 1\n' if self.shaken else "")


def _table(name: str, inline: str) -> str:
    """Return an inline table as a table of its own."""
    return f"[{name}]\n" + inline.strip("{}").replace(", ", "\n") + "\n"


def read(drawn: Drawn, folder: Path) -> Any:
    """Return the scene of the file of a slope."""
    file = folder / "scene.toml"
    file.write_text(drawn.file(), "utf-8")
    return load(file)


def motions(seed: int, folder: Path) -> Iterator[tuple[Drawn, Motion]]:
    """Yield random slopes whose mass moves and comes to rest, with their motions."""
    rng = np.random.default_rng(seed)
    while True:
        drawn = Drawn(rng)
        try:
            drawn.scale = drawn.wanted / read(drawn, folder).stability.factors_of_safety[drawn.start]
            motion = solve(read(drawn, folder))
        except ValueError:  # no result by the method, or no mass
            continue
        is_first = motion.run_out > 0.05 and motion.farthest.rotation < 0.8
        if is_first and motion.arrested:
            yield drawn, motion


def difference(drawn: Drawn, motion: Motion) -> float:
    """Return the greatest relative difference between a motion and the plain integration of its slope."""
    scene: Any = motion.plan.scene
    slope = of_scene(scene)
    factor = slope.strength_factor(drawn.start, drawn.shaken)
    truths = np.array([factor, *slope.motion(factor, drawn.velocity)])
    values = np.array([scene.strength_factor, motion.run_out, motion.farthest.time, motion.peak.velocity])
    return float(np.max(np.abs(values / truths - 1.0)))


def main() -> int:
    """Compare random slopes; return 1 if one differs by more than the bound."""
    chosen = options(__doc__, 200)
    warnings.simplefilter("ignore", UnusualInput)  # strengths that rise are compared, too
    greatest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for number, (drawn, motion) in enumerate(islice(motions(chosen.seed, Path(folder)), chosen.count), 1):
            found = difference(drawn, motion)
            greatest = max(greatest, found)
            kind = f"{drawn.count} soils, {drawn.strength}, {drawn.start}, {motion.run_out:.3g} m"
            print(f"{number}: {kind}: {found:.1e}", flush=True)
    print(f"{chosen.count} motions agree with a plain integration to {greatest:.1e}")
    return int(not greatest < BOUND)


if __name__ == "__main__":
    sys.exit(main())
