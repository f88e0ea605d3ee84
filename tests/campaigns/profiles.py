"""Critical circles below profiles of 1,000 points, and below 50 soils: factors and processor time.

    python -m tests.campaigns.profiles [COUNT] [--points 1000] [--seed 1]

Factors are compared with those of the same search on all vertices and with all circles, times with those of ten points
of the same profile or of one soil.
"""

import argparse
import math
import time
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

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
    """Return how much greater the factor is than that of a search without shortcuts, as a share, and the time, s."""
    found, seconds = least(slope, method)
    with pytest.MonkeyPatch.context() as patch:
        for name in ("MANY_VERTICES", "MANY_SOILS"):
            patch.setattr(condensed, name, 10**9)
        whole, _ = least(slope, method)
    return (found - whole) / max(abs(whole), 0.1), seconds


def ten_points(slope: Slope) -> Slope:
    """Return the slope below ten points of its ground, evenly spaced."""
    x, y = np.asarray(slope.ground).T
    few = np.linspace(x[0], x[-1], 10)
    return replace(slope, ground=np.stack([few, np.interp(few, x, y)], axis=1))


def random_soils(count: int, rng: np.random.Generator) -> Slope:
    """Return a slope of horizontal layers with random strengths and unit weights."""
    tops = [None, *np.sort(rng.uniform(-15, 19, count - 1))[::-1]]
    draw = rng.uniform
    layers = [(Soil(draw(17e3, 21e3), draw(1e3, 3e4), draw(0.1, 0.7), name=f"{k}"), tops[k]) for k in range(count)]
    return Slope(SIMPLE, layers=layers)


def soils(count: int) -> Slope:
    """Return a slope of horizontal layers of the same unit weight."""
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
    rng = np.random.default_rng(options.seed)
    simple = Slope(SIMPLE, **STRENGTH)
    least(simple, "bishop")
    for name, slope, method in profiles(options.count, options.points, rng):
        above, seconds = excess(slope, method)
        _, of_ten = least(ten_points(slope), method)
        print(f"{name:10} {method:9} excess {above:+.1e}, {seconds / of_ten:.1f} times the time of 10 points")
    for k in range(options.count // 2):
        slope, method = random_soils(int(rng.integers(22, 60)), rng), METHODS[k % 4]
        above, seconds = excess(slope, method)
        _, of_one = least(simple, method)
        print(
            f"{len(slope.layers)} soils   {method:9} excess {above:+.1e}, {seconds / of_one:.1f} times the time of one"
        )
    (one, of_one), (many, of_many) = (least(soils(k), "bishop") for k in (1, 50))
    print(f"50 soils: {of_many / of_one:.1f} times the time of one; {one:.4g}, {many:.6g}")


if __name__ == "__main__":
    main()
