"""Correct rounding of all 1,070,141,404 float32 inputs: `python -m tests.campaigns.float32 [KERNEL ...]`.

At every level of the processor. The nearest float32 to the double of the best tier is the right one, except next to a
midpoint of two; there quadrature in ball arithmetic decides. The exit status is 1 where there is a fault.
"""

import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import numpy as np
from flint import ctx

from derive.check.truth import TOP
from generated import _compiled, kernels
from tests.campaigns.seen import BASES, Floats, Numbers
from tests.support import oracle

LAST_SINGLE = int(np.float32(TOP).view(np.uint32))
SLACK = 2.0**-26  # of an ulp of float32: 8 ulp of float64, and so more than a best tier is ever wrong


def inputs(first: int = 0, last: int = LAST_SINGLE, block: int = 1 << 15) -> Iterator[Numbers]:
    """Yield every float32 between two bit patterns, in blocks."""
    for start in range(first, last + 1, block):
        yield np.arange(start, min(start + block, last + 1), dtype=np.uint32).view(np.float32)


def correctly_rounded(kernel: str, x: Numbers) -> Numbers:
    """Return the nearest float32 to the exact values."""
    best = _compiled.kernel(kernel, kernels.TEXTS[kernel])
    exact = best(np.minimum(x.astype(np.float64), TOP))
    with np.errstate(under="ignore"):
        nearest = exact.astype(np.float32)
    for k in np.flatnonzero(~(distance(exact, nearest) < 0.5 - SLACK)):
        nearest[k] = decided(kernel, float(x[k]))
    return nearest


def distance(exact: Floats, nearest: Numbers) -> Floats:
    """Return the distance of a result from the exact value, in ulp of float32."""
    power = (exact.view(np.int64) & 0x7FF0_0000_0000_0000).view(np.float64)
    unit = np.maximum(power * 2.0**-23, 2.0**-149)
    return np.asarray(np.abs(exact - nearest) / unit)


def decided(kernel: str, alpha: float) -> np.float32:
    """Return the nearest float32 to one exact value, by the oracle."""
    with ctx.workprec(400):
        exact = oracle.kernel(kernel, alpha)
        near = np.float32(float(exact))
        around = {near, np.nextafter(near, np.float32(0)), np.nextafter(near, np.float32(9))}
        return min(around, key=lambda x: abs(exact - float(x)))


def levels() -> list[str]:
    """Return all levels, or with a binary all except NumPy's, whose operations are the operations of the plain form."""
    return [level for level in _compiled.LEVELS if level != "numpy"] or ["numpy"]


def faults(kernel: str, blocks: Iterator[Numbers], *at: str, call: Callable[..., Any] | None = None) -> list[str]:
    """Return the inputs at which a level is wrong, in words."""
    calls = {level: call or _compiled.kernel(kernel, kernels.TEXTS[kernel], level) for level in at or levels()}
    found = []
    for x in blocks:
        right = correctly_rounded(kernel, x)
        for level, function in calls.items():
            values = function(x)
            for k in np.flatnonzero(values != right):
                found.append(f"{kernel}, {level}: {values[k]!r} at {float(x[k]).hex()}, correctly {right[k]!r}")
    return found


def every_float32(kernel: str) -> list[str]:
    """Return the faults of a kernel."""
    return faults(kernel, inputs())


def main(names: list[str]) -> int:
    """Return the command; its exit status."""
    start = time.perf_counter()
    found = []
    with ProcessPoolExecutor(2) as pool:
        for kernel, wrong in zip(names, pool.map(every_float32, names), strict=True):
            print(f"{kernel}: {len(wrong)} of {LAST_SINGLE + 1} inputs wrong at {', '.join(levels())}", flush=True)
            found += wrong
    print(*found[:20], f"{len(found)} faults, {time.perf_counter() - start:.0f} s", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or list(BASES)))
