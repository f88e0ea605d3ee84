"""Kernels under JAX, in a process of its own: ``python -m tests.support.traced``.

Alone, under `jit`, `vmap` and `grad`, in either of its float types; NaN outside, the limits at both ends.
"""

from itertools import pairwise

import jax
import numpy as np
import pytest

from generated import kernels
from tests.support import oracle

ALPHAS = np.array([0.0, 1e-8, 0.3, np.pi / 4, 0.9, 1.1, 1.5, np.pi / 2, -0.1, 1.6, np.nan, np.inf])


def slope(name: str, alpha: float) -> float:
    """A central difference of the kernel, for comparison: good to ten digits."""
    function = getattr(kernels, name)
    h = 2.0**-10
    rows = [(function(alpha + k * h) - function(alpha - k * h)) / (2 * k * h) for k in (1, 2, 4)]
    once = [(4 * a - b) / 3 for a, b in pairwise(rows)]
    return float((16 * once[0] - once[1]) / 15)


def check(name: str, double: bool) -> None:
    """One kernel, in float64 or in float32: with its derivatives, traced, mapped, and as it is called."""
    function = getattr(kernels, name)
    with jax.enable_x64(double):
        alphas, tolerance = jax.numpy.asarray(ALPHAS), 1e-14 if double else 1e-5
        values, rises = jax.jit(jax.vmap(jax.value_and_grad(function)))(alphas)
        assert isinstance(values, jax.Array)
        assert values.dtype == alphas.dtype == (np.float64 if double else np.float32)
        for value in (values, function(alphas)):
            np.testing.assert_allclose(value[:8], function(ALPHAS[:8].astype(alphas.dtype)), rtol=tolerance)
            np.testing.assert_array_equal(np.isnan(value), [False] * 8 + [True] * 4)
        assert np.isfinite(rises[:8]).all()
        for alpha, rise in zip(ALPHAS[2:7], rises[2:7], strict=True):
            assert float(rise) == pytest.approx(slope(name, alpha), rel=1e-8 if double else 1e-4, abs=1e-8)


def main() -> None:
    names = (*oracle.BASE, *oracle.QUOTIENTS)
    for name in names:
        check(name, double=True)
    check(names[-1], double=False)
    with pytest.raises(ValueError, match=r"nothing is proved.*jax"):
        kernels.polar_moment(jax.numpy.ones(3), accuracy=1e-3)


if __name__ == "__main__":
    main()
