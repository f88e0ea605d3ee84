"""The search for the critical circle against SciPy's differential evolution on random slopes.

`python -m tests.campaigns.peers_slopes` prints a line for each of 200 slopes; the tests ask for a sample.
"""

import time
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import differential_evolution

from slipcircle.workbench.stability.family import Search
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import METHODS, Slope


class Compared(NamedTuple):
    """A least factor, by how much it lies above that of evolution, relative, and the seconds that both took."""

    method: str
    factor: float
    excess: float
    search_seconds: float
    evolution_seconds: float


def slope(rng: np.random.Generator) -> tuple[Slope, float]:
    """Return a random slope of one to five edges, facing either way, dry, wet or shaken, and its height."""
    height, edges = rng.uniform(5, 40), int(rng.integers(1, 6))
    run = height / np.tan(np.deg2rad(rng.uniform(18, 60)))
    inner = np.sort(rng.uniform(0.0, 1.0, (edges - 1, 2)), axis=0) * [run, height]
    ground = np.array([[-2.5 * height, 0.0], [0.0, 0.0], *inner, [run, height], [run + 2.5 * height, height]])
    ground = rng.choice([ground, ground[::-1] * [-1, 1]])
    unit_weight = rng.uniform(16e3, 22e3)
    more: list[dict[str, Any]] = [
        {}, {"pore_ratio": rng.uniform(0.05, 0.4)}, {"level": ground - [0.0, height * rng.uniform(0.05, 0.5)]},
        {"k_h": rng.uniform(0.02, 0.2)},
    ]  # fmt: skip
    base = float(rng.choice([0.0, -height * rng.uniform(0.1, 1.0)])) or None
    cohesion, friction = unit_weight * height * rng.uniform(0.02, 0.2), np.tan(np.deg2rad(rng.uniform(8, 38)))
    return Slope(ground, cohesion, friction, unit_weight, base=base, **more[rng.integers(4)]), height


def evolved(search: Search, seed: int) -> float:
    """Return the least factor by differential evolution over both ends and the share of the greatest opening."""

    def factors(q: np.ndarray) -> np.ndarray:
        circles = np.stack([*np.sort(q[:2], axis=0), q[2], np.full(len(q[2]), -1.0)], axis=1)
        return np.nan_to_num(search.evaluate(circles), nan=1e6)

    bounds = [(0.0, search.along[-1]), (0.0, search.along[-1]), (0.005, 1.0)]
    found = differential_evolution(factors, bounds, rng=seed, popsize=40, tol=1e-10, maxiter=400, vectorized=True,
                                   updating="deferred", polish=False, init="sobol")  # fmt: skip
    return float(found.fun)


def compared(seed: int) -> Compared:
    """Compare the least factors of a random slope by a random method."""
    rng = np.random.default_rng(seed)
    given, height = slope(rng)
    method = str(rng.choice([*METHODS]))
    times = [time.process_time()]
    factor = critical(given, method, depth=0.05 * height).factors_of_safety[method] or np.nan
    times.append(time.process_time())
    other = evolved(Search(given, method, None, None, 0.05 * height), seed)
    times.append(time.process_time())
    return Compared(method, factor, factor / other - 1.0, *np.diff(times).tolist())


if __name__ == "__main__":
    for number in range(200):
        print(number, *compared(number), flush=True)
