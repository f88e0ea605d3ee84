"""The text just emitted, executed and compared with its closed form at many digits: a first look, not a certificate.

The tests compare with quadrature of the definitions instead; this is the line that `python -m derive` prints.
"""

import mpmath
import numpy as np
import sympy as sp

from derive import emit, functions
from derive.integrate import Derivation
from derive.symbols import alpha

SAMPLES = (1e-300, 1e-100, 1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.5385, 0.7, 0.7610127, 0.8, 1.0, 1.2, 1.4, 1.5, 1.57)


def run(function: emit.Function, *args: np.ndarray) -> np.ndarray:
    """Execute a function's emitted body."""
    space: dict[str, object] = {"np": np, "Array": np.ndarray}
    exec(emit.body(function.program), space)
    with np.errstate(under="ignore"):
        return space[f"_{function.program.name}"](*args)  # type: ignore[operator]


def worst(derivations: list[Derivation]) -> str:
    """Worst error of each base kernel over `SAMPLES`, in words."""
    found = []
    by_name = {f.program.name: f for f in functions.kernels(derivations)}
    points = np.array(SAMPLES)
    for name, closed in functions.closed_amplitudes(derivations).items():
        values = run(by_name[name], points)
        with mpmath.workdps(700):  # the closed form loses 600 digits at alpha = 1e-300
            exact = sp.lambdify(alpha, closed, "mpmath")
            errors = [
                abs(float((mpmath.mpf(float(v)) - exact(mpmath.mpf(float(x)))) / float(np.spacing(v))))
                for x, v in zip(points, values, strict=True)
            ]
        found.append(f"{name} {max(errors):.1f}")
    return f"worst ulp at {len(SAMPLES)} points: {', '.join(found)}"
