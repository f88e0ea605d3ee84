"""The kernels' values, against quadrature of the raw definitions in ball arithmetic, in fractional ulp."""

from functools import cache
from itertools import product
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb, ctx
from numpy.typing import NDArray

from derive.algebra.integrate import quadrature
from derive.declare.quantities import MOMENTS
from generated import _compiled, kernels
from generated.tiers import BOUNDS
from tests.support import oracle, vaiont
from tests.support.kernels import SEAM, angles, errors

Floats = NDArray[np.float64]


@cache
def arcs() -> tuple[tuple[float, float], ...]:
    """Return ends (theta_1, theta_2): thin, level, turned, in whole degrees, half discs, or starting at pi."""
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
    """The oracle agrees to 35 digits with quadrature in r and theta, without a centred angle, by another program."""
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
    """The page on validation states the error of one kernel; `test_observed_errors` runs the programs of all."""
    name = "moment_of_inertia"
    error, at = errors(kernels.moment_of_inertia, name, angles())[0]
    proved = BOUNDS[name]["best"][_compiled.LEVELS[_compiled.LEVEL][0]][1]
    assert proved
    assert error <= proved, f"{name}({at!r}) is wrong by {error:.1f} ulp"


# Arcs turned ten thousand times, next to level and to the x axis by all of a double's places, and half discs that end
# within 2**-60 of the x axis.
FAR = [(x, x + size) for x in (-65530.0, 3.3e3, 65530.0) for size in (1e-9, 0.4, 3.0)]
NEAR = [(float(m * np.pi / 2 - h + e), float(m * np.pi / 2 + h)) for m in range(-5, 7)
        for h in (1e-5, 0.1, 0.5, 1.5) for e in (0.0, 2.2e-16, 1e-9)]  # fmt: skip
DISCS = [(k * 2.0**-60, np.pi - k * 2.0**-60) for k in range(106, 500, 7)]


ENDS = [*oracle.WHOLE, "limit_friction"]


@cache
def of_ends(name: str, theta_1: float, theta_2: float) -> arb:
    """J_r, J_theta or mu_eq, by quadrature of the raw definitions."""
    if name in oracle.WHOLE:
        return oracle.whole(name, theta_1, theta_2)[0]
    return oracle.limit_friction(theta_1, theta_2)


@pytest.mark.parametrize(("name", "tier"), [(name, tier) for name in ENDS for tier in BOUNDS[name]])
def test_both_ends(name: str, tier: str) -> None:
    """Within the proved bound at every level, for every arc, level ones and very thin ones too; no warning."""
    kind = np.float32 if tier == "float32" else np.float64
    ends = np.array([*arcs(), *FAR, *NEAR, *DISCS]).astype(kind)
    first, second = ends.astype(float).T
    solid = (second > first) & (second - first < 3.1416) & (abs(first + second) > 1e-290)
    ends = ends[solid]  # on the x axis mu_eq is infinite
    exact = [of_ends(name, *arc) for arc in ends.astype(float).tolist()]
    for level, (form, _) in _compiled.LEVELS.items():
        function = _compiled.kernel(name, kernels.TEXTS[name], level, both_ends=True)
        forms = BOUNDS[name][tier]
        bound, _ = forms.get(form, forms["plain"])
        with np.errstate(all="raise"):
            values = function(*ends.T, accuracy=None if tier == "best" else bound)
        least = 2.0**-149 if tier == "float32" else 2.0**-1000
        for value, of_arc, arc in zip(values.tolist(), exact, ends.tolist(), strict=True):
            with ctx.workprec(300):
                error = abs(oracle.exact(value) - of_arc)
                assert error <= bound * abs(of_arc) + least, f"{name}, {level}, {tier}: of {arc} {value}"


@pytest.mark.parametrize("level", _compiled.LEVELS)
def test_on_the_x_axis_nothing_presses(level: str) -> None:
    """J_r is 0 and the limit friction infinite; of no arc at all both moments are 0."""
    radial, moment, limit = (_compiled.kernel(name, kernels.TEXTS[name], level, both_ends=True) for name in ENDS)
    with np.errstate(all="raise"):
        assert radial(-1.0, 1.0) == 0.0
        assert np.isinf(limit(-1.0, 1.0))
        assert radial(4.0, 4.0) == moment(4.0, 4.0) == 0.0
        assert limit(4.0, 4.0) == pytest.approx(1 / np.tan(4.0), rel=1e-15)
