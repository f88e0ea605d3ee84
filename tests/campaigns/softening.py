"""Motions with softening cohesion beside a plain integration: ``python -m tests.campaigns.softening [SCENES] [SEED]``.

Random layers, laws of friction and of cohesion, strength of the base or with the mass; `tests.support.along_the_arc`
integrates.
"""

import sys
import warnings
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from slipcircle import Motion, Scene, solve
from slipcircle.base.checks import UnusualInput
from slipcircle.layers import LayeredSection, Soil
from tests.support.along_the_arc import AlongTheArc, random_section

BOUND = 1e-8
TURNING = ["rotation", "centripetal"]


def random_soils(rng: np.random.Generator, soils: list[Soil], strength: str) -> list[Soil]:
    """Soils with random laws: with the base one of friction and one of cohesion, with the mass each its own."""
    laws = rng.choice(["exponential", "linear", "hyperbolic"], 2)
    lengths = rng.uniform(0.3, 3.0, 2)
    made = []
    for k, soil in enumerate(soils):
        if strength == "mass":
            laws, lengths = rng.choice(["exponential", "linear", "hyperbolic"], 2), rng.uniform(0.3, 3.0, 2)
        peak, residual = rng.uniform(0.0, 0.3, 2) * rng.choice([0.0, 1.0], p=[0.2, 0.8])
        friction = {"law": str(laws[0]), "peak": peak, "residual": residual, "length": float(lengths[0])}
        peak, residual = rng.uniform(1e2, 1.5e4, 2)
        cohesion = {"law": str(laws[1]), "peak": peak, "residual": residual, "length": float(lengths[1])}
        made.append(replace(soil, friction=friction, cohesion=cohesion if k else float(peak), name=f"soil {k}"))
    return made


def scenes(rng: np.random.Generator) -> Iterator[tuple[LayeredSection, Motion]]:
    """Sections that move down-slope, with their motions."""
    while True:
        strength = str(rng.choice(["base", "mass"]))
        section = random_section(rng, strength="base")
        soils = random_soils(rng, [soil for soil, _ in section.layers], strength)
        layers = [(soil, top) for soil, (_, top) in zip(soils, section.layers, strict=True)]
        try:
            section = replace(section, layers=layers, strength=strength)
            motion = solve(Scene(section, None, TURNING, end_time=1e3))
        except ValueError:
            continue
        if motion.moves and motion.arrested and 0.2 < motion.run_out < 40.0:
            yield section, motion


def difference(section: LayeredSection, motion: Motion) -> float:
    """The relative difference of the greatest displacement, or of its time if that is greater."""
    distance, time, _ = AlongTheArc(section, section).motion()
    return max(abs(motion.run_out / distance - 1.0), abs(motion.farthest.time / time - 1.0))


def main() -> int:
    """Compare as many scenes as requested; return 1 where one differs."""
    warnings.simplefilter("ignore", UnusualInput)  # strengths that rise are compared, too
    count, seed = (int(x) for x in (*sys.argv[1:], "200", "1")[:2])
    found = []
    for _, (section, motion) in zip(range(count), scenes(np.random.default_rng(seed)), strict=False):
        found.append(difference(section, motion))
        print(f"{len(found)}: {section.strength}, {motion.run_out:.4g} m, {found[-1]:.1e}", flush=True)
    print(f"{len(found)} motions agree with a plain integration to {max(found):.1e}")
    return int(not max(found) < BOUND)


if __name__ == "__main__":
    sys.exit(main())
