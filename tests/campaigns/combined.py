"""Motions that combine a start by Bishop's method, softening cohesion and standing water, beside plain integration.

``python -m tests.campaigns.combined [SCENES] [--seed N]`` draws slopes of one soil, solves their scene files and prints
the greatest relative difference of strength factor, run-out, its time and peak velocity from `tests.support.rays`.
"""

import argparse
import sys
import tempfile
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from slipcircle import load, solve
from tests.support.rays import Slope, random_slopes

BOUND = 1e-8


def difference(slope: Slope, file: Path) -> float:
    """Return the greatest relative difference between a solved scene file and the plain integration of its slope."""
    file.write_text(slope.file, "utf-8")
    scene = load(file)
    motion = solve(scene)
    factor = slope.strength_factor
    truths = (factor, *slope.motion(factor))
    values = (scene.strength_factor, motion.run_out, motion.farthest.time, motion.peak.velocity)
    return max(abs(value - truth) / (truth or 1.0) for value, truth in zip(values, truths, strict=True))


def differences(count: int, seed: int, folder: Path) -> Iterator[float]:
    """Yield the differences of as many random slopes."""
    for slope in islice(random_slopes(seed, combined=True), count):
        yield difference(slope, folder / "scene.toml")


def main() -> int:
    """Compare random slopes; return 1 if one differs by more than the bound."""
    parser = argparse.ArgumentParser(description=str(__doc__).partition("\n")[0])
    parser.add_argument("count", metavar="SCENES", type=int, nargs="?", default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    greatest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for number, found in enumerate(differences(options.count, options.seed, Path(folder)), 1):
            greatest = max(greatest, found)
            print(f"{number}: {found:.1e}", flush=True)
    print(f"{options.count} motions agree with a plain integration to {greatest:.1e}")
    return int(not greatest < BOUND)


if __name__ == "__main__":
    sys.exit(main())
