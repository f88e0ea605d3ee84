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
from slipcircle.base.kinds import Floats

POINTS = 10_000
HALF_PI = (float(np.pi / 2), 6.123233995736766e-17)  # pi/2 as a sum of two doubles: what alpha lacks at that end
_ZERO_BELOW = 2.0**-360  # every moment is alpha**3 or smaller there, and rounds to 0
_LANDMARKS = (0.0, 5e-324, 2.0**-1022, 2.0**-26, np.pi / 8, np.pi / 4, 1.1, np.nextafter(np.pi / 2, 0.0), np.pi / 2)


@cache
def inputs(kind: str = "float64") -> NDArray[Any]:
    """The set in a format, sorted, drawn with a fixed seed."""
    rng = np.random.default_rng(2017)
    fifth = POINTS // 5
    whole, least = ("int32", 2.0**-140) if kind == "float32" else ("int64", _ZERO_BELOW)

    def patterns(low: float) -> NDArray[Any]:
        """Numbers whose bit patterns are uniform from `low` to pi/2."""
        ends = np.array([low, np.pi / 2], kind)
        first, last = ends.view(whole).tolist()
        bits = rng.integers(first, last, fifth, dtype=np.int64, endpoint=True)
        return bits.astype(whole).view(kind)

    decades = rng.uniform(-16.5, -0.5, fifth)
    near = 10.0**decades  # distances; the format rounds many to the same number
    uniform = rng.uniform(0.0, np.pi / 2, 2 * fifth)
    by_pattern = patterns(least), patterns(1e-16)
    by_value = (uniform, np.pi / 2 - near, np.array(_LANDMARKS))
    return np.unique(np.concatenate([*by_pattern, *(values.astype(kind) for values in by_value)]))


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
            units_off = (results - self.nearest) / self.unit
            ulp = np.asarray(units_off - self.rest, dtype=np.float64)
            relative = np.abs(ulp) * (self.unit / self.size)
        if self.nearest.ndim > 1:
            return None, np.nanmax(relative, axis=0)
        finite = np.isfinite(results)
        return np.where(finite, ulp, np.inf), np.where(finite, relative, np.inf)


def reference(points: Floats, values: Sequence[Any], kind: str = "float64", size: Floats | None = None) -> Reference:
    """Exact values, all of one type with its own arithmetic, made ready for the comparison in a format.

    Errors are relative to the values, at least to the smallest normal number, where no other size is given.
    """
    exact = np.array(values, dtype=object)
    nearest = exact.astype(np.float64)
    magnitude = np.abs(nearest)
    unit = np.spacing(magnitude.astype(kind)).astype(np.float64)
    rest = np.frompyfunc(_rest, 3, 1)(exact, nearest, unit).astype(np.float64)
    if size is None:
        size = np.maximum(magnitude, np.finfo(kind).smallest_normal)
    return Reference(points, exact, nearest, unit, rest, size)


def _rest(value: Any, nearest: float, unit: float) -> float:
    """What rounding takes from an exact value, in units."""
    exact = type(value)
    return float((value - exact(nearest)) / exact(unit))


@cache
def kernel(name: str, kind: str = "float64") -> Reference:
    """The exact values of a kernel on the set."""
    from flint import ctx

    with ctx.workprec(400):
        known = dict(_balls(kind))
        if name not in QUOTIENTS:
            values = [balls[name] for balls in known.values()]
        else:
            known.pop(0.0)  # 0/0
            above, below = QUOTIENTS[name]
            values = [balls[above] / balls[below] for balls in known.values()]
        return reference(np.array([[*known]]), values, kind)


@cache
def _balls(kind: str) -> dict[float, dict[str, Any]]:
    """Every base quantity at every point, by its declared closed form; they share sine, cosine and logarithm."""
    from flint import arb, ctx

    values = {}
    for alpha in inputs(kind).tolist():
        # For 50 digits: closed forms are differences of O(alpha) that are O(alpha**3), and 1 - cos is one of O(1).
        thin = max(0, -int(np.frexp(alpha)[1])) if alpha else 0
        with ctx.workprec(320 + 3 * thin):
            # float32's nearest number to pi/2 lies above it, and the domain ends there.
            right_angle = arb.pi() / 2
            half = arb(alpha)
            if not half < right_angle:
                half = right_angle
            sine, cosine = half.sin(), half.cos()
            tangent = sine / (1 + cosine)  # of x/2, as artanh(sin x) = 2 artanh(tan(x/2))
            log = arb(0) if cosine.contains(0) else 2 * tangent.atanh()
            balls = SimpleNamespace(sin=arb.sin, cos=arb.cos, atanh=lambda sine, log=log: log)
            values[alpha] = {name: form(balls, half) for name, form in CLOSED.items()}
    return values
