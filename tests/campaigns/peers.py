"""How fast other compilers of formulas run the paper's printed forms.

``python -m tests.campaigns.peers [FUNCTION ...]`` times them. SymPy's lambdify and ufuncify, Numba, numexpr and JAX,
all on one core, beside this package's best tier, in one run. Those that are not installed are named: pip install sympy
numba numexpr jax setuptools.
"""

import os
import statistics
import sys
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any, NamedTuple

# Before NumPy and JAX are loaded: one thread for all.
os.environ |= {"OMP_NUM_THREADS": "1", "NUMEXPR_NUM_THREADS": "1", "JAX_PLATFORMS": "cpu", "JAX_ENABLE_X64": "1",
               "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"}  # fmt: skip
if hasattr(os, "sched_setaffinity"):  # some of JAX's threads take no orders
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})

import numpy as np
import sympy as sp
from numpy.typing import NDArray

import generated
from derive.declare.quantities import RESISTANCE
from derive.declare.symbols import alpha
from slipcircle.workbench.cost.rows import interleaved
from slipcircle.workbench.outputs.info import machine

Floats = NDArray[np.float64]
SIZES = (10_000, 1_000_000)
# (2.19), (3.15), Appendix I in one line, (3.13) integrated, (3.14)
PRINTED: Mapping[str, sp.Expr] = {
    "polar_moment": 2 * alpha / 3
    - sp.sin(2 * alpha) / 6
    - sp.cos(alpha) ** 3 * sp.log(sp.Abs(sp.tan(sp.pi / 4 + alpha / 2))) / 3,
    "moment_of_inertia": alpha / 2 - sp.sin(2 * alpha) * (1 + 2 * sp.cos(alpha) ** 2) / 12,
    "radial_weight_amplitude": sp.sin(alpha) - sp.cos(alpha) ** 2 * sp.atanh(sp.sin(alpha)),
    "weight_moment_amplitude": 2 * sp.sin(alpha) / 3 - 2 * sp.sin(alpha) * sp.cos(alpha) ** 2 / 3,
    "resistance_factor": RESISTANCE.form,
}
Maker = Callable[[sp.Expr], Callable[[Floats, Floats], object]]


def lambdify(expression: sp.Expr) -> Callable[[Floats, Floats], object]:
    function = sp.lambdify(alpha, expression, "numpy", cse=True)
    return lambda x, out: function(x)


def ufuncify(expression: sp.Expr) -> Callable[[Floats, Floats], object]:
    from sympy.utilities.autowrap import ufuncify as make

    function = make([alpha], expression, backend="numpy")
    return lambda x, out: function(x, out)


def numba(expression: sp.Expr) -> Callable[[Floats, Floats], object]:
    from numba import vectorize

    function = vectorize(["float64(float64)"])(sp.lambdify(alpha, expression, "math", cse=True))
    return lambda x, out: function(x, out)


def numexpr(expression: sp.Expr) -> Callable[[Floats, Floats], object]:
    from numexpr import evaluate

    text = sp.pycode(expression, fully_qualified_modules=False).replace("atanh", "arctanh")
    return lambda x, out: evaluate(text, {"alpha": x, "pi": np.pi}, out=out)


def jax(expression: sp.Expr) -> Callable[[Floats, Floats], object]:
    import jax as library

    function = library.jit(sp.lambdify(alpha, expression, "jax", cse=True))
    given: dict[int, Any] = {}  # an array of its own, made once

    def run(x: Floats, out: Floats) -> object:
        if x.size not in given:
            given[x.size] = library.numpy.asarray(x)
        return function(given[x.size]).block_until_ready()

    return run


PEERS: Mapping[str, Maker] = {f.__name__: f for f in (lambdify, ufuncify, numba, numexpr, jax)}


class Row(NamedTuple):
    """Medians; of the fastest turns how many times ours."""

    function: str
    way: str
    size: int
    ns: float
    times_ours: float
    fastest: float


def measure(names: list[str]) -> Iterator[Row]:
    """Time every peer on every function; what is missing or fails is said on stderr."""
    for name in names:
        ways: dict[str, Callable[[Floats, Floats], object]] = {
            "slipcircle": getattr(generated, name),
            "np.copyto": lambda x, out: np.copyto(out, x),
        }
        check = np.linspace(0.3, 1.5, 11)
        for peer, make in PEERS.items():
            try:
                made = make(PRINTED[name])
                found, exact = np.asarray(made(check, np.empty_like(check))), getattr(generated, name)(check)
                np.testing.assert_allclose(found, exact, rtol=1e-12)
                ways[peer] = made
            except Exception as error:  # a compiler that is not there, or cannot do it
                print(f"{peer} left out for {name}: {type(error).__name__}: {str(error)[:200]}", file=sys.stderr)
        for size in SIZES:
            x = np.random.default_rng(0).uniform(0.0, np.pi / 2, size)
            samples = interleaved([partial(way, x, np.empty_like(x)) for way in ways.values()])
            for way, seconds in zip(ways, samples, strict=True):
                times = statistics.median(seconds) / statistics.median(samples[0]), min(seconds) / min(samples[0])
                yield Row(name, way, size, statistics.median(seconds) / size * 1e9, *times)


def main() -> None:
    """Print the comparison."""
    names = sys.argv[1:] or list(PRINTED)
    print(f"{'function':<26}{'way':<12}{'N':>9}{'ns':>10}{'times ours':>12}{'fastest':>9}")
    for row in measure(names):
        print(f"{row.function:<26}{row.way:<12}{row.size:>9}{row.ns:>10.3f}{row.times_ours:>12.2f}{row.fastest:>9.2f}")
    libraries = [f"{p} {version(p)}" for p in ("sympy", "numba", "numexpr", "jax") if find_spec(p)]
    print("medians of several turns, and the fastest ones, on one core", machine(), *libraries, sep=", ")


if __name__ == "__main__":
    main()
