"""The generated friction laws against their definitions in many digits."""

from collections.abc import Callable

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from generated import laws

EPS = 2.0**-52
COEFFICIENTS: dict[str, Callable[[mpf, mpf, mpf, mpf], mpf]] = {
    "exponential": lambda s, peak, rest, length: rest + (peak - rest) * mpmath.exp(-s / length),
    "linear": lambda s, peak, rest, length: peak + (rest - peak) * min(s / length, mpf(1)),
    "hyperbolic": lambda s, peak, rest, length: rest + (peak - rest) / (1 + s / length),
}


@pytest.mark.parametrize("name", COEFFICIENTS)
def test_friction(name: str) -> None:
    """Against the definition at 80 digits."""
    rng = np.random.default_rng(9)
    for _ in range(400):
        length, peak, rest = 10 ** rng.uniform(-12, 12), rng.uniform(0.0, 1.5), rng.uniform(0.0, 1.5)
        slip = rng.choice([0.0, length * 10 ** rng.uniform(-9, 1)])
        with mpmath.workdps(80):
            mu = COEFFICIENTS[name](*(mpf(float(v)) for v in (slip, peak, rest, length)))
            found = mpf(float(getattr(laws, f"friction_{name}")(slip, peak, rest, length)))
            assert abs(found - mu) <= 4 * EPS * (peak + rest)
