"""Profiles of ground, and levels of water in them."""

import numpy as np

from slipcircle.ground import circles

GROUND = [[0.0, 25.0], [30.0, 25.0], [38.0, 30.0], [50.0, 35.0], [90.0, 35.0]]
LEVEL = [[0.0, 25.0], [30.0, 25.0], [45.0, 32.0], [90.0, 32.0]]


Ground = list[tuple[float, float]]


def moments(ground: Ground, centre: tuple[float, float], radius: float) -> dict[str, float]:
    """Return the moments that the package computes for all parts of the mass inside the circle."""
    parts = circles.cut_by_circles(np.array([ground]), np.array([centre]), np.array([radius]))
    return {k: float(v[0]) for k, v in circles.moments(parts, parts.stretch >= 0).items()}


def bumpy(rng: np.random.Generator, edges: int) -> tuple[Ground, tuple[float, float], float]:
    """Return a random profile and a circle that cuts it once."""
    while True:
        x = np.sort(rng.uniform(-1.5, 1.5, edges + 1))
        y = rng.uniform(-0.6, 0.6) * x + rng.uniform(0, 0.25) * rng.standard_normal(edges + 1)
        ground = list(zip(x.tolist(), y.tolist(), strict=True))
        centre, radius = (float(rng.uniform(-0.4, 0.4)), float(rng.uniform(0.3, 2.0))), float(rng.uniform(0.8, 2.5))
        parts = circles.cut_by_circles(np.array([ground]), np.array([centre]), np.array([radius]))
        lanes, _, held = circles.complete_stretches(parts)
        above = np.interp(centre[0], x, y) < centre[1] and all(y < 0 for _, (y,) in circles.ends(parts, [0]))
        if len(lanes) == 1 and not held[0] and above and moments(ground, centre, radius)["area"] > 1e-3:
            return ground, centre, radius
