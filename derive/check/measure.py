"""The text just emitted, executed and compared with its closed form at many digits: a first look, not a certificate.

The tests compare with quadrature of the definitions instead; this is the line that `python -m derive` prints.
"""

import mpmath
import numpy as np
import sympy as sp

from derive.code import emit
from derive.code.program import Program
from derive.declare.symbols import alpha

SAMPLES = (1e-300, 1e-100, 1e-8, 1e-4, 1e-2, 0.1, 0.3, 0.5385, 0.7, 0.7610127, 0.8, 1.0, 1.2, 1.4, 1.5, 1.57)


def run(program: Program, *args: np.ndarray) -> np.ndarray:
    """Execute the text emitted for a program."""
    space: dict[str, object] = {"np": np, "Array": np.ndarray, "horner": emit.HELPERS["horner"]}
    exec(emit.PythonText().body(program), space)
    with np.errstate(under="ignore"):
        return space[f"_{program.name}"](*args)  # type: ignore[operator]


def worst(function: emit.Function, closed: sp.Expr) -> float:
    """Worst error of a base kernel over `SAMPLES`, in ulp."""
    points = np.array(SAMPLES)
    values = run(function.program, points)
    with mpmath.workdps(700):  # the closed form loses 600 digits at alpha = 1e-300
        exact = sp.lambdify(alpha, closed, "mpmath")
        return max(
            abs(float((mpmath.mpf(float(v)) - exact(mpmath.mpf(float(x)))) / float(np.spacing(v))))
            for x, v in zip(points, values, strict=True)
        )
