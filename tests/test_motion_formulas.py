"""The motion formulas' values, against the equation of motion solved in mpmath: 8 ulp times (1 + condition number)."""

from collections.abc import Callable
from functools import cache
from itertools import product
from typing import Any

import mpmath
import numpy as np
import oracle
import pytest
from mpmath import mpf

from generated import motion

Formula = Callable[..., Any]

BOUND = 8.0
RIDE = [f"frozen_centripetal_{x}" for x in ("angular_velocity", "rotation", "angular_acceleration")]
each_formula = pytest.mark.parametrize("name", list(oracle.MOTION))
SIZES = (0.0, 1e-30, 1e-8, 1.0, 1e8, 1e30)
SIGNED = tuple(sorted({s * x for s in (-1.0, 1.0) for x in SIZES}))


def nearby(x: float) -> tuple[float, ...]:
    """x, and the doubles up to three away."""
    found = [x]
    for _ in range(3):
        found = [float(np.nextafter(found[0], -np.inf)), *found, float(np.nextafter(found[-1], np.inf))]
    return tuple(found)


def hard_rides() -> list[tuple[float, ...]]:
    """(a, b, omega_0, t) at every seam, limit and landmark."""
    found = list(product((-2.0, 0.0, 2.0), (-0.5, 0.0, 0.5), (-1.0, 0.0, 1.0), (0.0, 1e-300, 1e-8, 0.3, 0.99, 3.0)))
    for sign in (-1.0, 1.0):  # the seam a b t**2 = 1, for both signs of both
        found += [(sign * 4.0, sign * 0.25, w, t) for t in nearby(1.0) for w in (-1.0, 0.0, 0.5)]
        found += [(sign * 1e-6, sign * 1e6, w, t) for t in nearby(1.0) for w in (-1e-7, 0.0, 0.5)]
    # The way to a b -> 0, from either side, by either factor.
    found += [(s * x, 2.0, 0.3, 0.7) for s in (-1.0, 1.0) for x in (5e-324, 1e-310, 1e-200, 1e-17, 1e-9)]
    found += [(2.0, s * x, 0.3, 0.7) for s in (-1.0, 1.0) for x in (5e-324, 1e-310, 1e-200, 1e-17, 1e-9)]
    # t -> infinity: terminal velocity, reached from below, from above, and started at (b omega_0**2 = a).
    found += [(4.0, 1.0, w, t) for w in (0.0, 1.0, 2.0, 5.0, -1.0) for t in (10.0, 19.0, 177.0, 186.0, 400.0, 1e8, 1e300)]
    found += [(1e30, 1e-30, 0.0, t) for t in (170.0, 354.5, 360.0, 372.0, 1e3)]  # exp(-2 k t) leaves the format
    # a b < 0: braked through standstill and on to the pole of the tangent; near that pole, before and after.
    found += [(-1.0, 1.0, w, t) for w in (0.0, 0.5, 1.0) for t in (0.1, 0.5, 0.7853981633974483, 1.0, 1.5, 1.57)]
    found += [(1.0, -1.0, 0.0, t) for t in (1.5707963, 1.5707963267948961, 1.5707963267949, 1.6, 3.0, 3.2, 5.0, 1e9)]
    found += [(1.0, 1.0, -3.0, t) for t in (0.3, 0.34657, 0.34658, 0.4, 1.0, 2.0, 1e5)]  # faster than terminal, backward
    found += [(-1.0, 1.0, 1e8, t) for t in (1e-9, 1.0, 1.5707963)]  # fast, braked
    found += [(1e-30, 1.0, 0.7, t) for t in (1e-3, 1e15, 2e15, 1e16)]  # a crawl under strong drag
    return [tuple(map(float, x)) for x in found]


def random_arguments(name: str, count: int, reach: float, seed: int = 20240802) -> list[tuple[float, ...]]:
    """Log-uniform sizes from 10**-reach to 10**reach, signs where the domain has them."""
    rng = np.random.default_rng([seed, len(name), int(reach)])
    size = 10 ** rng.uniform(-reach, reach, (count, len(arguments(name))))
    for i, x in enumerate(arguments(name)):
        if "arrest" in name:
            size[:, i] *= -1 if x == "a" else 1
        elif x not in ("t", "mu"):
            size[:, i] *= rng.choice([-1.0, 1.0], count)
    return [tuple(map(float, row)) for row in size]


def arguments(name: str) -> list[str]:
    """Names of a formula's arguments."""
    function = getattr(motion, name)
    return list(function.__code__.co_varnames[: function.__code__.co_posonlyargcount])


@cache
def cases(name: str) -> tuple[tuple[float, ...], ...]:
    """What one formula is tried with."""
    found: list[tuple[float, ...]] = []
    if name in RIDE:
        found += hard_rides()
        found += [(*x, t) for x in product(SIGNED[::2], SIGNED[1::2], SIGNED[::3]) for t in (0.0, 1e-8, 1.0, 1e8)][::7]
    elif "arrest" in name:
        one = [(-1e-30,), (-1e-8,), (-1.0,), (-1e30,)]
        rest = [SIZES] * (len(arguments(name)) - 1)
        found += [(*x, *y) for x in one for y in product(*rest)]
    else:
        allowed = {"t": SIZES, "mu": SIZES}
        found += list(product(*(allowed.get(x, SIGNED) for x in arguments(name))))[::3]
    few = name not in RIDE
    for count, reach in ((60, 30.0), (30, 60.0), (60, 1.0), (60, 3.0)) if few else ((250, 30.0), (60, 60.0), (250, 1.0), (250, 3.0)):
        found += random_arguments(name, count, reach)
    return tuple(found)


def errors(formula: Formula, name: str) -> list[tuple[float, tuple[float, ...]]]:
    """Error in ulp over (1 + condition number) and arguments, worst first; no warning while the solution lasts."""
    lasting = [x for x in cases(name) if oracle.motion(name, *x) is not None]
    with np.errstate(all="raise"):
        values = formula(*np.array(lasting).T)
    return sorted(
        (
            (oracle.motion_error(float(v), reference), x)
            for v, x in zip(values, lasting, strict=True)
            if (reference := oracle.motion(name, *x))
        ),
        reverse=True,
    )


def check_accuracy(formula: Formula, name: str) -> None:
    """At most 8 ulp times (1 + condition number), without a warning."""
    error, at = errors(formula, name)[0]
    assert error <= BOUND, f"{name}{at} is wrong by {error:.3g} ulp times (1 + condition number)"
