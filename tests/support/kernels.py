"""Arguments and errors of kernels, and which compiled ones there are."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from generated import _compiled
from generated.tiers import BOUNDS
from tests.support import oracle

Floats = NDArray[np.float64]
Kernel = Callable[..., Any]

LEVELS = _compiled.LEVELS
COMPILED = [level for level in LEVELS if level != "numpy"]
FITTED = sorted(BOUNDS.keys() - {*oracle.WHOLE, "limit_friction"})
needs_binary = pytest.mark.skipif(not COMPILED, reason="no compiled kernels here")


HALF_PI = np.pi / 2
SEAM = 2 * np.arctan(0.4)  # where tan(alpha/2) reaches 2/5: the series ends and the logarithm begins


def neighbours(x: float, count: int) -> list[float]:
    """Return the doubles around x, nearest first below and above."""
    below, above = [x], [x]
    for _ in range(count):
        below.append(float(np.nextafter(below[-1], -1.0)))
        above.append(float(np.nextafter(above[-1], 4.0)))
    return below[:0:-1] + above


@cache
def angles() -> Floats:
    """Half opening angles all over the domain, dense at its ends and on both sides of the seam."""
    rng = np.random.default_rng(20240731)
    listed = [5e-324, 1e-323, 1e-310, 2.2250738585072014e-308, 1e-300, 1e-200, 1e-154, 1e-108, 1e-105, 1e-103, 1e-100]
    listed += [1e-60, 1e-30, 1e-16, 1e-8, 1.5e-8, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.25, 0.5, 0.5385, 1.0, np.pi / 4]
    listed += neighbours(SEAM, 8) + neighbours(HALF_PI, 4)
    listed += [HALF_PI * (1 + 4 * 2.0**-52)]
    parts = (
        listed,
        rng.uniform(0, HALF_PI, 300),
        10 ** rng.uniform(-320, -4, 60),
        10 ** rng.uniform(-8, 0, 120),
        SEAM + rng.uniform(-1e-9, 1e-9, 40),
        SEAM + rng.uniform(-0.05, 0.05, 60),
        HALF_PI - 10 ** rng.uniform(-15, 0, 80),
    )
    return np.unique(np.concatenate([np.asarray(p, dtype=np.float64) for p in parts]))


def errors(
    kernel: Kernel, name: str, alphas: NDArray[Any], kind: type[np.floating] = np.float64
) -> list[tuple[float, float]]:
    """Error in ulp and argument of each value, worst first."""
    with np.errstate(all="raise"):
        values = kernel(alphas)
    found = (
        (oracle.ulps(float(v), oracle.kernel(name, float(x)), kind=kind), float(x))
        for v, x in zip(values, alphas, strict=True)
    )
    return sorted(found, reverse=True)


# --- every function, at some arcs ---

ENDS = ("radial_weight", "weight_moment", "limit_friction")
NAMES = (*oracle.BASE, *oracle.QUOTIENTS, *ENDS)
ALPHAS = np.array([0.0, 1e-8, 0.3, np.pi / 4, 0.9, 1.1, 1.5, np.pi / 2])
MIDDLES = 1.5 * np.pi + np.array([0.0, 0.4, 1e-3, -0.7, 0.4, 1.2, -1.5, 0.3])


def arguments(name: str, alphas: Any = ALPHAS, middles: Any = MIDDLES) -> tuple[Any, ...]:
    """Arguments of a function: half angles, or both ends of the same arcs."""
    return (middles - alphas, middles + alphas) if name in ENDS else (alphas,)
