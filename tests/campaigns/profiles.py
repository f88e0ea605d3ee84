"""Critical circles below profiles of 1,000 points, and below 50 soils: factors and processor time.

    python -m tests.campaigns.profiles [COUNT] [--points 1000] [--seed 1]

Factors are compared with those of the same search on all vertices, and times with those of four points or one soil.
"""

import argparse
import math
import time
from collections.abc import Iterator
from typing import Any

import numpy as np

from slipcircle import Slope, Soil, critical
from slipcircle.workbench.stability import condensed

SIMPLE = np.array([[-60.0, 0.0], [0.0, 0.0], [40.0, 20.0], [100.0, 20.0]])
STRENGTH: dict[str, Any] = {"cohesion": 15e3, "friction": 0.35, "unit_weight": 2e4}
METHODS = ("bishop", "paper", "ordinary", "k_y")
# By name: (points, rng) -> heights above the simple slope, m.
ROUGHNESS: dict[str, Any] = {
    "straight": lambda x, rng: 0.0 * x,
    "white": lambda x, rng: 0.01 * rng.standard_normal(len(x)),
    "walk": lambda x, rng: 0.8 * np.cumsum(rng.standard_normal(len(x))) / math.sqrt(len(x)),
    "waves": lambda x, rng: sum(
        0.5 / m * rng.standard_normal() * np.sin(2 * np.pi * m * x / 160 + rng.uniform(0, 6)) for m in range(1, 40)
    ),
    "benches": lambda x, rng: np.interp(x, *np.sort(rng.uniform(0, 1, (2, 9))) * [[40], [0]]) + np.round(x / 9) / 9,
}


def profiles(count: int, points: int, rng: np.random.Generator) -> Iterator[tuple[str, Slope, str]]:
    """Name, slope and method of random slopes."""
    for k in range(count):
        name = [*ROUGHNESS][k % len(ROUGHNESS)]
        x = np.sort(np.append(rng.uniform(-60, 100, points - 2), [-60.0, 100.0]))
        ground = np.stack([x, np.interp(x, *SIMPLE.T) + ROUGHNESS[name](x, rng)], axis=1)
        fields = STRENGTH | {"cohesion": rng.uniform(5e3, 3e4), "friction": rng.uniform(0.2, 0.6)}
        if k % 3 == 1:
            fields |= {"level": [[-60, -3], [0, -3], [100, 8]]}
        if k % 4 == 1:
            ground = ground[::-1] * [-1, 1]
            fields |= {"k_h": 0.1} | ({"level": [[-100, 8], [0, -3], [60, -3]]} if "level" in fields else {})
        yield name, Slope(ground, **fields), METHODS[k % 4] if k % 2 else "bishop"


def least(slope: Slope, method: str) -> tuple[float, float]:
    """Least factor and processor time of a search, s."""
    begun = time.process_time()
    found = critical(slope, method)
    factor = found.yield_coefficient if method == "k_y" else found.factors_of_safety[method]
    assert factor is not None
    return factor, time.process_time() - begun


def excess(slope: Slope, method: str) -> tuple[float, float]:
    """How much greater the factor is than that of a search on all vertices, as a share, and the time, s."""
    found, seconds = least(slope, method)
    many = condensed.MANY_VERTICES
    try:
        condensed.MANY_VERTICES = 10**9
        whole, _ = least(slope, method)
    finally:
        condensed.MANY_VERTICES = many
    return (found - whole) / max(abs(whole), 0.1), seconds


def soils(count: int) -> Slope:
    """Return a slope of horizontal layers."""
    layers = [
        (Soil(2e4, 1e3 * (15 + k % 7), 0.35, name=f"{k}"), None if k == 0 else 20 - 25 * k / count)
        for k in range(count)
    ]
    return Slope(SIMPLE, layers=layers)


def main() -> None:
    """Print a line for each profile."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=20)
    parser.add_argument("--points", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    simple = Slope(SIMPLE, **STRENGTH)
    least(simple, "bishop")
    for name, slope, method in profiles(options.count, options.points, np.random.default_rng(options.seed)):
        above, seconds = excess(slope, method)
        _, of_simple = least(simple, method)
        print(f"{name:10} {method:9} excess {above:+.1e}, {seconds / of_simple:.1f} times the time of 4 points")
    (one, of_one), (many, of_many) = (least(soils(k), "bishop") for k in (1, 50))
    print(f"50 soils: {of_many / of_one:.1f} times the time of one; {one:.4g}, {many:.6g}")


if __name__ == "__main__":
    main()
