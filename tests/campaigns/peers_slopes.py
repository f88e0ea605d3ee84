"""The search for the critical circle against SciPy's differential evolution on random slopes.

`python -m tests.campaigns.peers_slopes [COUNT]` prints a line for each of COUNT slopes (200); the tests ask for a
sample.
"""

import sys
import time
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import differential_evolution

from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import METHODS, Slope


class Case(NamedTuple):
    """A slope, the method, and the least depth."""

    slope: Slope
    method: str
    depth: float


def case(seed: int) -> Case:
    """A slope of two to six edges between level parts, facing either way, dry, wet or shaken."""
    rng = np.random.default_rng(seed)
    height, edges = rng.uniform(5, 40), int(rng.integers(1, 6))
    run = height / np.tan(np.deg2rad(rng.uniform(18, 60)))
    x = np.sort(np.concatenate([[0, run], rng.uniform(0, run, edges - 1)]))
    y = np.sort(np.concatenate([[0, height], rng.uniform(0, height, edges - 1)]))
    flat = 2.5 * height
    ground = np.array([[-flat, 0.0], *np.stack([x, y], axis=1), [run + flat, height]])
    gamma = rng.uniform(16e3, 22e3)
    cohesion, friction = gamma * height * rng.uniform(0.02, 0.2), np.tan(np.deg2rad(rng.uniform(8, 38)))
    more: dict[str, Any] = {}
    match int(rng.integers(0, 4)):
        case 1:
            more = {"pore_ratio": rng.uniform(0.05, 0.4)}
        case 2:
            more = {"level": np.stack([ground[:, 0], ground[:, 1] - height * rng.uniform(0.05, 0.5)], axis=1)}
        case 3:
            more = {"k_h": rng.uniform(0.02, 0.2)}
    if rng.random() < 0.5:
        more["base"] = -height * rng.uniform(0.1, 1.0)
    if rng.random() < 0.5:
        ground = ground[::-1] * [-1, 1]
        if "level" in more:
            more["level"] = more["level"][::-1] * [-1, 1]
    slope = Slope(ground, cohesion, friction, gamma, **more)
    return Case(slope, list(METHODS)[int(rng.integers(0, 3))], 0.05 * height)


def evolved(given: Case, seed: int) -> float:
    """The least factor by differential evolution over both ends and the share of the greatest opening."""
    search = Search(given.slope, given.method, None, None, given.depth)
    total = search.along[-1]

    def judged(q: np.ndarray) -> np.ndarray:
        some = np.sort(q[:2], axis=0)
        return np.nan_to_num(search.evaluate(np.stack([*some, q[2], np.full(len(q[2]), -1.0)], axis=1)), nan=1e6)

    bounds = [(0.0, total), (0.0, total), (0.005, 1.0)]
    found = differential_evolution(judged, bounds, rng=seed, popsize=40, tol=1e-10, maxiter=400, vectorized=True,
                                   updating="deferred", polish=False, init="sobol")  # fmt: skip
    return float(found.fun)


def excess(seed: int) -> float:
    """How far the search's factor lies above that of evolution, relative."""
    given = case(seed)
    ours = critical(given.slope, given.method, depth=given.depth).factor_of_safety[given.method]
    assert ours is not None
    return ours / evolved(given, seed) - 1.0


def main(count: int) -> None:
    """Print all of them."""
    worst, ours, theirs = -1.0, 0.0, 0.0
    for seed in range(count):
        given = case(seed)
        start = time.process_time()
        found = critical(given.slope, given.method, depth=given.depth)
        middle = time.process_time()
        other = evolved(given, seed)
        ours, theirs = ours + middle - start, theirs + time.process_time() - middle
        value = found.factor_of_safety[given.method]
        assert value is not None
        worst = max(worst, value / other - 1.0)
        print(f"{seed:4d} {given.method:<9} {value:9.6f} {other:9.6f} {100 * (value / other - 1):+9.5f} %", flush=True)
    print(f"worst {100 * worst:+.5f} %; search {ours / count:.3f} s, evolution {theirs / count:.3f} s in the mean")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200)
