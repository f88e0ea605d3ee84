"""The generated friction laws, and how far they fall, against their definitions in many digits."""

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
def test_friction_and_its_fall(name: str) -> None:
    """Against the definition at 60 digits: the fall over a slip however small has full relative accuracy."""
    rng = np.random.default_rng(9)
    for _ in range(400):
        length, peak, rest = 10 ** rng.uniform(-12, 12), rng.uniform(0.0, 1.5), rng.uniform(0.0, 1.5)
        slip = rng.choice([0.0, length * 10 ** rng.uniform(-9, 1)])
        more = length * 10 ** rng.uniform(-15, 4)
        with mpmath.workdps(80):
            exact = [mpf(float(v)) for v in (slip, peak, rest, length)]
            mu = COEFFICIENTS[name](*exact)
            fall = mu - COEFFICIENTS[name](exact[0] + mpf(more), *exact[1:])
            found = mpf(float(getattr(laws, f"friction_{name}")(slip, peak, rest, length)))
            dropped = mpf(float(getattr(laws, f"drop_{name}")(slip, more, peak, rest, length)))
            assert abs(found - mu) <= 4 * EPS * (peak + rest)
            if name == "linear":  # its kink takes a difference, of a length
                assert abs(dropped - fall) <= 4 * EPS * abs(peak - rest) * min(1.0, (slip + more) / length) + 1e-320
            else:
                assert abs(dropped - fall) <= 16 * EPS * abs(fall) * (1 + slip / length) + 1e-300
