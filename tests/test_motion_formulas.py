"""The motion formulas' values, against the equation of motion solved in balls: 8 ulp times (1 + condition number)."""

from collections.abc import Callable
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest

from generated import motion
from tests.support import oracle
from tests.support.oracle import MOTION_BOUND

Formula = Callable[..., Any]

RIDE = [f"frozen_{x}" for x in ("angular_velocity", "rotation", "angular_acceleration")]
each_formula = pytest.mark.parametrize("name", list(oracle.MOTION))
SIZES = (0.0, 1e-30, 1e-8, 1.0, 1e8, 1e30)
SIGNED = tuple(sorted({s * x for s in (-1.0, 1.0) for x in SIZES}))


def nearby(x: float) -> tuple[float, ...]:
    """x, and the doubles up to three away."""
    found = [x]
    for _ in range(3):
        found = [float(np.nextafter(found[0], -np.inf)), *found, float(np.nextafter(found[-1], np.inf))]
    return tuple(found)


# Values of a, b, omega_0 and t, each with each: seams, limits and landmarks.
GRIDS: list[tuple[tuple[float, ...], ...]] = [
    ((-2.0, 0.0, 2.0), (-0.5, 0.0, 0.5), (-1.0, 0.0, 1.0), (0.0, 1e-300, 1e-8, 0.3, 0.99, 3.0)),
    # t -> infinity: terminal velocity, reached from below, from above, and started at (b omega_0**2 = a).
    ((4.0,), (1.0,), (0.0, 1.0, 2.0, 5.0, -1.0), (10.0, 177.0, 186.0, 400.0, 1e8, 1e300)),
    ((1e30,), (1e-30,), (0.0,), (170.0, 354.5, 360.0, 372.0, 1e3)),  # exp(-2 k t) leaves the format
    # a b < 0: braked through standstill and on to the pole of the tangent; near that pole, before and after.
    ((-1.0,), (1.0,), (0.0, 0.5, 1.0), (0.1, 0.5, 0.7853981633974483, 1.0, 1.5, 1.57)),
    ((1.0,), (-1.0,), (0.0,), (1.5707963, 1.5707963267948961, 1.5707963267949, 1.6, 3.0, 3.2, 5.0, 1e9)),
    ((1.0,), (1.0,), (-3.0,), (0.3, 0.34657, 0.34658, 0.4, 1.0, 1e5)),  # faster than terminal, back
    ((-1.0,), (1.0,), (1e8,), (1e-9, 1.0, 1.5707963)),  # fast, braked
    ((1e-30,), (1.0,), (0.7,), (1e-3, 1e15, 2e15, 1e16)),  # a crawl under strong drag
]


def hard_rides() -> list[tuple[float, ...]]:
    """(a, b, omega_0, t) at every seam, limit and landmark."""
    found = [x for grid in GRIDS for x in product(*grid)]
    for sign in (-1.0, 1.0):
        # The seam a b t**2 = 1, for both signs of both, and the way to a b -> 0 by either factor.
        found += product((sign * 4.0,), (sign * 0.25,), (-1.0, 0.0, 0.5), nearby(1.0))
        found += product((sign * 1e-6,), (sign * 1e6,), (-1e-7, 0.0, 0.5), nearby(1.0))
        tiny = [sign * x for x in (5e-324, 1e-310, 1e-200, 1e-17, 1e-9)]
        found += [*product(tiny, (2.0,), (0.3,), (0.7,)), *product((2.0,), tiny, (0.3,), (0.7,))]
    # Started close to the unstable equilibrium, -sqrt(a/b): what is lost in omega + sqrt(a/b) must not stay lost.
    rng = np.random.default_rng(20240803)
    for _ in range(80):
        a, b, s = *(10 ** rng.uniform(-3, 3, 2)), rng.choice([-1.0, 1.0])
        omega_0 = np.sqrt(a / b) * (-1 + rng.choice([-1.0, 1.0]) * 10 ** rng.uniform(-9, 0))
        found.append((s * a, s * b, s * omega_0, rng.uniform(0, 20) / np.sqrt(a * b)))
    # Thrown up-slope, and just turning at t: the acceleration there hardly depends on the start.
    for kt in (0.1, 0.5, 0.9, 0.999, 1.001, 1.5, 3.0, 6.0, 10.0, 14.0, 17.0):
        for a, b in ((2.0, 0.7), (1e-5, 30.0), (-3.0, -0.1)):
            k = np.sqrt(a * b)
            found += [(a, b, w, kt / k) for w in nearby(-a / k * np.tanh(kt))]
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
        found += [(*x, t) for x in product(SIGNED[::2], SIGNED[1::2], SIGNED[::3]) for t in (0.0, 1e-8, 1.0, 1e8)][::14]
    else:
        found += product((-1e-30, -1e-8, -1.0, -1e30), *[SIZES] * (len(arguments(name)) - 1))
    many = 2 if name in RIDE else 1
    for count, reach in ((30, 30.0), (10, 60.0), (40, 1.0), (40, 3.0)):
        found += random_arguments(name, many * count, reach)
    return tuple(found)


@cache
def references(name: str) -> list[tuple[tuple[float, ...], oracle.Reference | None]]:
    """Arguments and what is true there; nothing where the solution has ended."""
    return [(x, oracle.motion(name, *x)) for x in cases(name)]


def test_every_formula_has_a_reference() -> None:
    assert set(motion.__all__) == set(oracle.MOTION)


@each_formula
def test_accuracy(name: str) -> None:
    """At most 8 ulp times (1 + condition number) while the solution lasts, without a warning."""
    lasting = [(x, reference) for x, reference in references(name) if reference]
    with np.errstate(all="raise"):
        values = getattr(motion, name)(*np.array([x for x, _ in lasting]).T)
    for value, (x, truth) in zip(values.tolist(), lasting, strict=True):
        assert oracle.motion_error(value, truth) <= MOTION_BOUND, f"{name}{x}"


@pytest.mark.parametrize("name", RIDE)
def test_the_solution_ends(name: str) -> None:
    """NaN and the `invalid` flag after the solution has run to infinity; never a plausible number."""
    formula = getattr(motion, name)
    ended = [x for x, reference in references(name) if reference is None]
    assert len(ended) > 100
    with np.errstate(all="raise", invalid="ignore"):
        values = formula(*np.array(ended).T)
    assert np.isnan(values).all(), f"{name} has a number after the solution has ended"
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
        formula(*ended[0])
