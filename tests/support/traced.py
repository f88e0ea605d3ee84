"""Functions of the arc under JAX, in a process of its own: ``python -m tests.support.traced``.

Alone, under `jit`, `vmap` and `grad`, in either of its float types; NaN outside, the limits at both ends.
"""

from itertools import pairwise
from typing import Any

import jax
import numpy as np
import pytest

from generated import kernels
from tests.support.kernels import ENDS, NAMES, arguments

OUTSIDE = np.array([-0.1, 1.6, np.nan, np.inf])


def slope(name: str, args: list[float], k: int) -> float:
    """Return a central difference of the function by argument k, for comparison: good to ten digits."""
    function = getattr(kernels, name)

    def at(h: float) -> Any:
        return function(*(x + h * (i == k) for i, x in enumerate(args)))

    h = 2.0**-10
    rows = [(at(n * h) - at(-n * h)) / (2 * n * h) for n in (1, 2, 4)]
    once = [(4 * a - b) / 3 for a, b in pairwise(rows)]
    return float((16 * once[0] - once[1]) / 15)


def check(name: str) -> None:
    """One function, with its derivatives in float64: traced, mapped, and as it is called; its values in float32."""
    function = getattr(kernels, name)
    outside = arguments(name, OUTSIDE, 1.5 * np.pi)
    single = (5e-6, 1e-7) if name in ENDS else (5e-7, 0.0)  # the sum of two angles loses digits in float32
    for kind, rtol, atol in ((np.float64, 1e-14, 1e-15), (np.float32, *single)):
        double = kind is np.float64
        with jax.enable_x64(double):
            given = [np.concatenate(x).astype(kind) for x in zip(arguments(name), outside, strict=True)]
            args = [jax.numpy.asarray(x) for x in given]
            which = tuple(range(len(args)))
            rises = []
            if double:
                values, rises = jax.jit(jax.vmap(jax.value_and_grad(function, which)))(*args)
            else:
                values = jax.jit(function)(args[0], *given[1:])
            assert isinstance(values, jax.Array)
            assert values.dtype == kind
            values, rises = np.asarray(values), [np.asarray(rise) for rise in rises]  # JAX would compile each slice
            np.testing.assert_allclose(values[:8], function(*(x[:8] for x in given)), rtol, atol)
            np.testing.assert_array_equal(np.isnan(values), [False] * 8 + [True] * 4)
        for k, rise in enumerate(rises):
            assert np.isfinite(rise[:8]).all()
            for i in range(2, 7):
                wanted = slope(name, [float(x[i]) for x in given], k)
                assert float(rise[i]) == pytest.approx(wanted, rel=1e-8, abs=1e-8)


def main() -> None:
    jax.config.update("jax_disable_most_optimizations", True)  # faster to compile, the same numbers
    for name in NAMES:
        check(name)
    for name, args in (("polar_moment", (jax.numpy.ones(3),)), ("limit_friction", (4.0, jax.numpy.ones(3)))):
        function = getattr(kernels, name)
        with pytest.raises(ValueError, match=r"nothing is proved.*jax"):
            function(*args, accuracy=1e-3)
        with pytest.raises(TypeError, match=f"{name}: arguments of type complex64 are not supported"):
            function(*args[:-1], args[-1] * 1j)


if __name__ == "__main__":
    main()
