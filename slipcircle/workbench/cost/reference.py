"""Exact values, by which every way is judged; of kernels from their closed forms, at inputs that all ways share.

Those are uniform in value, uniform in bit patterns, and dense at both ends of [0, pi/2].
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.definitions import CLOSED, QUOTIENTS

Floats = NDArray[np.float64]

POINTS = 10_000
HALF_PI = (float(np.pi / 2), 6.123233995736766e-17)  # pi/2 as a sum of two doubles: what alpha lacks at that end
_ZERO_BELOW = 2.0**-360  # every moment is alpha**3 or smaller there, and rounds to 0
_LANDMARKS = (0.0, 5e-324, 2.0**-1022, 2.0**-26, np.pi / 8, np.pi / 4, 1.1, np.nextafter(np.pi / 2, 0.0), np.pi / 2)


@cache
def inputs(kind: str = "float64") -> NDArray[Any]:
    """The set in a format, sorted, drawn with a fixed seed."""
    rng, narrow = np.random.default_rng(2017), kind == "float32"
    fifth = POINTS // 5

    def patterns(low: float) -> NDArray[Any]:
        whole = "int32" if narrow else "int64"
        ends = [int(np.array(x, kind).view(whole)) for x in (low, np.pi / 2)]
        return rng.integers(ends[0], ends[1], fifth, dtype=np.int64, endpoint=True).astype(whole).view(kind)

    near = 10.0 ** rng.uniform(-16.5, -0.5, fifth)  # distances; the format rounds many to the same number
    found = [
        rng.uniform(0.0, np.pi / 2, 2 * fifth).astype(kind),
        patterns(2.0**-140 if narrow else _ZERO_BELOW),
        patterns(1e-16),
        (np.pi / 2 - near).astype(kind),
        np.array(_LANDMARKS).astype(kind),
    ]
    return np.unique(np.concatenate(found))


@dataclass(frozen=True)
class Reference:
    """Exact values in the format that a result is judged in: value = nearest + rest * unit, all of them arrays."""

    points: Floats  # one row per argument
    values: NDArray[Any]  # balls or decimals: one a point, or a row of them for each of several results
    nearest: Floats
    unit: Floats
    rest: Floats
    size: Floats  # what relative errors are relative to

    def errors(self, results: NDArray[Any]) -> tuple[Any, Floats]:
        """Signed errors in ulp, and relative errors; of several results the worst relative one alone.

        Those in ulp are (result - nearest)/unit - rest: fractional, against the unrounded value, also among denormal
        numbers. What is not finite is infinitely wrong, but of several results NaN is one that a way does not give.
        """
        with np.errstate(all="ignore"):
            ulp = np.asarray((results - self.nearest) / self.unit - self.rest, dtype=np.float64)
            relative = np.abs(ulp) * (self.unit / self.size)
        if self.nearest.ndim > 1:
            return None, np.nanmax(relative, axis=0)
        bad = ~np.isfinite(np.asarray(results, dtype=np.float64))
        return np.where(bad, np.inf, ulp), np.where(bad, np.inf, relative)


def reference(points: Floats, values: Sequence[Any], kind: str = "float64", size: Floats | None = None) -> Reference:
    """Exact values, all of one type with its own arithmetic, made ready for the comparison in a format.

    Errors are relative to the values, at least to the smallest normal number, where no other size is given.
    """
    exact = np.array(values, dtype=object)
    nearest = exact.astype(np.float64)
    unit = np.spacing(np.abs(nearest).astype(kind)).astype(np.float64)
    rest = np.frompyfunc(lambda v, n, u: float((v - type(v)(n)) / type(v)(u)), 3, 1)(exact, nearest, unit)
    least = np.maximum(np.abs(nearest), np.finfo(kind).smallest_normal) if size is None else size
    return Reference(points, exact, nearest, unit, rest.astype(np.float64), least)


@cache
def kernel(name: str, kind: str = "float64") -> Reference:
    """The exact values of a kernel on the set."""
    from flint import ctx

    with ctx.workprec(400):
        known = {alpha: of for alpha, of in _balls(kind).items() if alpha > 0.0 or name not in QUOTIENTS}  # 0/0 at 0
        above, *below = QUOTIENTS.get(name, (name,))
        values = [of[above] / of[below[0]] if below else of[above] for of in known.values()]
        return reference(np.array([[*known]]), values, kind)


@cache
def _balls(kind: str) -> dict[float, dict[str, Any]]:
    """Every base quantity at every point, by its declared closed form; they share sine, cosine and logarithm."""
    from flint import arb, ctx

    found = {}
    for alpha in inputs(kind).tolist():
        # For 50 digits: closed forms are differences of O(alpha) that are O(alpha**3), and 1 - cos is one of O(1).
        thin = max(0, -int(np.frexp(alpha)[1])) if alpha else 0
        with ctx.workprec(320 + 3 * thin):
            # float32's nearest number to pi/2 lies above it, and the domain ends there.
            half = arb(alpha) if arb(alpha) < arb.pi() / 2 else arb.pi() / 2
            sin, cos = half.sin(), half.cos()
            # artanh(sin x) = 2 artanh(tan(x/2))
            log = arb(0) if cos.contains(0) else 2 * (sin / (1 + cos)).atanh()
            balls = SimpleNamespace(sin=arb.sin, cos=arb.cos, atanh=lambda sine, log=log: log)
            found[alpha] = {name: form(balls, half) for name, form in CLOSED.items()}
    return found
