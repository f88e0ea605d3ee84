"""The kernels' values, against quadrature of the raw definitions in ball arithmetic, in fractional ulp."""

from functools import cache
from itertools import product
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from derive.algebra.integrate import quadrature
from derive.declare.quantities import MOMENTS
from generated import _compiled, kernels
from generated.tiers import BOUNDS
from tests.support import oracle, vaiont
from tests.support.kernels import SEAM, angles, errors

Floats = NDArray[np.float64]
BOUND = 16.0


@cache
def arcs() -> tuple[tuple[float, float], ...]:
    """Ends (theta_1, theta_2): thin, level, turned by any angle, given in degrees, half discs, or starting at pi."""
    rng = np.random.default_rng(20240801)
    turned = np.deg2rad([*product((0.0, 37.0, 123.4, 180.0, 187.3, 200.0), (180.0,)), (359.0, 1.0), (359.999999, 1e-6)])
    level = 3 * np.pi / 2  # a chord of zero dip: theta_m = 3 pi/2
    sizes = [
        *((np.pi, x) for x in (1e-10, 1e-3, 1.0, 2.0, np.pi)), *turned.tolist(),  # sin(theta_1) = 0; half discs
        *((level - x, 2 * x) for x in (1e-10, 1e-8, 1e-3, 0.3, SEAM, 1.2, 1.5)), (4.1, 0.0), (4.1, 8.9e-16),
        *zip(rng.uniform(0, 2 * np.pi, 60), 10 ** rng.uniform(-10, -1, 60), strict=True),
        *zip(rng.uniform(-7, 7, 150), rng.uniform(0, 3.14159, 150), strict=True),
    ]  # fmt: skip
    found = [(float(start), float(start + size)) for start, size in sizes]
    found += [vaiont.ENDS, (0.0, 5e-324), (1e-300, 1e-299), (-1e-200, 1e-200)]
    return tuple(found)


@pytest.mark.parametrize("moment", MOMENTS, ids=lambda m: m.name)
@pytest.mark.parametrize("theta_1", [3.25, 5.0])
def test_the_oracle_agrees_with_quadrature_over_the_uncentred_chord(moment: Any, theta_1: float) -> None:
    """In r and theta, no angle centred, nothing turned, by another program: 35 digits."""
    theta_2 = theta_1 + 1.5
    with mpmath.workdps(50):
        half = (mpmath.mpf(theta_2) - mpmath.mpf(theta_1)) / 2
        value = quadrature(moment.weight, mpmath.mpf(theta_1), half, 40)
        if moment.name in oracle.WHOLE:
            reference = oracle.whole(moment.name, theta_1, theta_2)[0]
        else:
            reference = oracle.kernel(moment.name, (theta_2 - theta_1) / 2)
        assert abs(mpmath.mpf(reference.str(45, radius=False)) / value - 1) < mpmath.mpf(10) ** -35


def test_accuracy() -> None:
    """Of one kernel as it is called, the page on validation; `test_seen` runs the programs of all."""
    name = "moment_of_inertia"
    error, at = errors(kernels.moment_of_inertia, name, angles())[0]
    proved = BOUNDS[name]["best"][_compiled.LEVELS[_compiled.LEVEL][0]][1]
    assert proved
    assert error <= proved, f"{name}({at!r}) is wrong by {error:.1f} ulp"


@pytest.mark.parametrize("name", oracle.WHOLE)
def test_weights(name: str) -> None:
    """The error of the amplitude as NumPy computes it plus 2 ulp of the amplitude, for every arc; no warning."""
    of_alpha, (first, second) = oracle.WHOLE[name], np.array(arcs()).T
    halves = (second - first) / 2
    with np.errstate(all="raise"):
        values = getattr(kernels, name)(first, second)
        amplitudes = _compiled.kernel(of_alpha, kernels.TEXTS[of_alpha], "numpy")(halves)
    for value, amplitude, half, arc in zip(values.tolist(), amplitudes.tolist(), halves.tolist(), arcs(), strict=True):
        error = oracle.ulps(value, *oracle.whole(name, *arc))
        of_amplitude = oracle.ulps(amplitude, oracle.kernel(of_alpha, half))
        assert error <= min(BOUND, of_amplitude) + 2, f"{name}{arc}: {error:.2f} ulp, amplitude {of_amplitude:.2f}"


def test_limit_friction() -> None:
    """At most 16 ulp, for every arc that is one; for a bisector along the x axis it is infinite."""
    solid = np.array([x for x in arcs() if x[1] > x[0] and abs(x[0] + x[1]) > 1e-290])
    with np.errstate(all="raise"):
        values = kernels.limit_friction(*solid.T)
    for value, arc in zip(values.tolist(), solid.tolist(), strict=True):
        assert oracle.ulps(value, oracle.limit_friction(*arc)) <= BOUND, f"limit_friction{arc}"
