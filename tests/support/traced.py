"""Kernels under JAX, in a process of its own: ``python -m tests.support.traced``.

Alone, under `jit`, `vmap` and `grad`, in either of its float types; NaN outside, the limits at both ends.
"""

from itertools import pairwise

import jax
import numpy as np
import pytest

from generated import kernels
from tests.support import oracle

ALPHAS = np.array([0.0, 1e-8, 0.3, np.pi / 4, 0.9, 1.1, 1.5, np.pi / 2])


def slope(name: str, alpha: float) -> float:
    """A central difference of the kernel, for comparison: good to ten digits."""
    function = getattr(kernels, name)
    h = 2.0**-10
    rows = [(function(alpha + k * h) - function(alpha - k * h)) / (2 * k * h) for k in (1, 2, 4)]
    once = [(4 * a - b) / 3 for a, b in pairwise(rows)]
    return float((16 * once[0] - once[1]) / 15)


def check(name: str, double: bool) -> None:
    """One kernel, in float64 or in float32."""
    function = getattr(kernels, name)
    with jax.enable_x64(double):
        alphas, tolerance = jax.numpy.asarray(ALPHAS), 1e-14 if double else 1e-5
        assert alphas.dtype == (np.float64 if double else np.float32)
        for way in (function, jax.jit(function), jax.vmap(function)):
            value = way(alphas)
            assert isinstance(value, jax.Array)
            assert value.dtype == alphas.dtype
            np.testing.assert_allclose(value, function(np.asarray(alphas)), rtol=tolerance)
        outside = np.asarray(jax.jit(function)(jax.numpy.asarray([-0.1, 1.6, np.nan, np.inf, 0.5])))
        np.testing.assert_array_equal(np.isnan(outside), [True, True, True, True, False])
        rises = jax.jit(jax.grad(function))
        for alpha in (0.3, float(np.pi / 4), 0.9, 1.1, 1.3, 1.5):
            found, tolerance = float(rises(alpha)), 1e-8 if double else 1e-4
            assert found == pytest.approx(slope(name, alpha), rel=tolerance, abs=1e-8)
        assert np.isfinite(float(jax.grad(function)(0.0)))
        assert np.isfinite(float(rises(float(np.pi / 2))))


def main() -> None:
    names = (*oracle.BASE, *oracle.QUOTIENTS)
    for name in names:
        check(name, double=True)
    for name in names[::3]:
        check(name, double=False)
    with pytest.raises(ValueError, match=r"nothing is proved.*jax"):
        kernels.polar_moment(jax.numpy.ones(3), accuracy=1e-3)


if __name__ == "__main__":
    main()
