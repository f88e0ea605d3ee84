"""A lane is its scene: each number of every scene that ships, and random profiles: ``python -m tests.campaigns.lanes``.

60 random values within 1 % of each number, as lanes of one scene and each solved alone; 200 profiles whose boundaries
follow the ground, end on it at the toe, coincide, touch the slip circle or cross each other and the ground, at values
of one number that differ by up to 1 % or by rounding. Prints the greatest relative differences; the exit status is 1 if
one is above 1e-9.
"""

import contextlib
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import slipcircle
from slipcircle import Scene, load, solve
from slipcircle.derivatives.parameters import parameter_value, parameters, with_parameter_arrays, with_parameters
from slipcircle.layers import LayeredSection, Soil

BOUND = 1e-9
SCENES = sorted(path.stem for path in (Path(slipcircle.__file__).parent / "scenes").glob("*.toml"))
OUTPUTS = ("run_out", "duration", "factor_of_safety", "yield_coefficient")
PROFILE_NUMBERS = ("radius", "ground.1.y", "layers.2.top", "centre.x", "ground.2.y")


def difference(scene: Scene, number: str, values: Any) -> float:
    """Return the greatest relative difference between lanes and the same scenes solved alone.

    It is infinite if only one of the two is refused.
    """
    lanes, invalid = with_parameter_arrays(scene, {number: values})
    motions = solve(lanes)
    worst = 0.0
    for k, value in enumerate(values):
        try:
            alone = solve(with_parameters(scene, {number: float(value)}))
        except ValueError:
            worst = worst if invalid[k] else np.inf
            continue
        if invalid[k]:
            return np.inf
        for name in OUTPUTS:
            expected = float(getattr(alone, name))
            computed = float(np.broadcast_to(getattr(motions, name), len(values))[k])
            if computed != expected:
                worst = max(worst, abs(computed - expected) / max(abs(expected), 1e-6))
    return worst


def of_scene(name: str, count: int, rng: np.random.Generator) -> Iterator[tuple[str, float]]:
    """Differences for each number of a scene that ships."""
    scene = replace(load(name), accuracy=1e-13)
    for number in scene.numbers:
        if number in parameters(scene) and not number.endswith("cohesion_gradient"):  # which needs a datum
            value = parameter_value(scene, number)
            if value is not None:
                spread = rng.uniform(-0.01, 0.01, count) if value else rng.uniform(0.0, 0.01, count)
                yield number, difference(scene, number, value * (1.0 + spread) if value else spread)


def random_profile(rng: np.random.Generator) -> Scene:
    """Layers whose boundaries coincide, touch and cross, above a circle that often leaves the ground at its toe."""
    while True:
        toe, rise = np.array([30.0, 25.0]), np.array([rng.uniform(10, 40), 10.0])
        ground = np.array([[-20.0, 25.0], toe, toe + rise, [150.0, 35.0]])
        tops: list[Any] = [None]
        for _ in range(rng.integers(1, 4)):
            inside = toe + rise * [rng.uniform(0.3, 1.2), rng.uniform(0, 0.8)]
            on_ground = [[-20.0, 25.0], toe, inside, [150.0, inside[1]]]
            ends_there = [toe, inside, [150.0, inside[1] + rng.normal()]]
            parallel = ground - [0.0, rng.choice([0.0, rng.uniform(0, 3)])]
            crossing = [[-20.0, rng.uniform(15, 30)], [150.0, rng.uniform(15, 30)]]
            through_toe = [toe - [50.0, rng.uniform(0, 30)], *on_ground[1:]]
            lines = (on_ground, ends_there, parallel, crossing, through_toe)
            tops.append(np.array(lines[rng.integers(len(lines))]))
        if rng.random() < 0.3:
            tops.append(tops[-1])
        along = rise[0] + rng.uniform(-3, 10)
        entry = toe + [along, min(10.0, 10.0 * along / rise[0])]
        exit_ = toe - [rng.choice([0.0, 0.0, 3.0]), 0.0]
        chord = entry - exit_
        length = np.hypot(*chord)
        depth = length * rng.uniform(0.1, 0.35)
        radius = (length**2 / 4 + depth**2) / (2 * depth)
        centre = (entry + exit_) / 2 + np.array([-chord[1], chord[0]]) / length * (radius - depth)
        if rng.random() < 0.3:
            tops.append(float(centre[1] - radius))
        rows = rng.uniform([17e3, 0, 0.05], [21e3, 3e3, 0.3], (len(tops), 3)).tolist()
        soils = [Soil(weight, cohesion, mu, name=f"soil {k}") for k, (weight, cohesion, mu) in enumerate(rows)]
        with contextlib.suppress(ValueError):
            section = LayeredSection(ground, centre, radius, layers=list(zip(soils, tops, strict=True)))
            if not section.mistakes(None, {}):
                return Scene(section, effects=["rotation", "centripetal"], accuracy=1e-13, end_time=30.0)


def of_profiles(count: int, rng: np.random.Generator) -> Iterator[tuple[str, float]]:
    """Differences for one number of each of some random profiles."""
    for k in range(count):
        scene, number = random_profile(rng), PROFILE_NUMBERS[k % len(PROFILE_NUMBERS)]
        value = parameter_value(scene, number)
        assert value is not None
        spread = [0.0, 1e-13, -1e-13] if k % 2 else rng.uniform(-0.01, 0.01, 3)
        yield f"profile {k}: {number}", difference(scene, number, value * (1.0 + np.array([0.0, *spread])))


def main() -> int:
    rng = np.random.default_rng(20261123)
    of_all = {name: dict(of_scene(name, 60, rng)) for name in sys.argv[1:] or SCENES}
    if not sys.argv[1:]:
        of_all["random profiles"] = dict(of_profiles(200, rng))
    for name, differences in of_all.items():
        above = {number: gap for number, gap in differences.items() if not gap <= BOUND}
        greatest = max(differences.values())
        print(f"{name}: {len(differences)} numbers, at most {greatest:.1e}", *above.items(), flush=True)
    return int(any(not gap <= BOUND for gaps in of_all.values() for gap in gaps.values()))


if __name__ == "__main__":
    sys.exit(main())
