"""The inputs at which every way to compute a kernel is judged, and the exact values there, from the closed forms.

One set for all ways, so that their errors can be compared: uniform in value, uniform in bit patterns, dense at both
ends of [0, pi/2].
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.definitions import CLOSED, QUOTIENTS

Floats = NDArray[np.float64]

POINTS = 10_000
HALF_PI = (float(np.pi / 2), 6.123233995736766e-17)  # pi/2 as a sum of two doubles: what alpha lacks at that end
DIGITS = 50  # that exact values have at least
_SHARES = {"value": 0.4, "bits": 0.2, "near 0": 0.2, "near pi/2": 0.2}
_ZERO_BELOW = 2.0**-360  # every moment is alpha**3 or smaller there, and rounds to 0
_LANDMARKS = (0.0, 5e-324, 2.0**-1022, 2.0**-26, np.pi / 8, np.pi / 4, 1.1, np.nextafter(np.pi / 2, 0.0), np.pi / 2)


@cache
def inputs(kind: str = "float64") -> NDArray[Any]:
    """The set in a format, sorted, drawn with a fixed seed."""
    rng, narrow = np.random.default_rng(2017), kind == "float32"
    size = {name: round(share * POINTS) for name, share in _SHARES.items()}

    def patterns(low: float, count: int) -> NDArray[Any]:
        whole = "int32" if narrow else "int64"
        ends = [int(np.array(x, kind).view(whole)) for x in (low, np.pi / 2)]
        return rng.integers(ends[0], ends[1], count, dtype=np.int64, endpoint=True).astype(whole).view(kind)

    near = 10.0 ** rng.uniform(-16.5, -0.5, size["near pi/2"])  # distances; the format rounds many to the same number
    found = [
        rng.uniform(0.0, np.pi / 2, size["value"]).astype(kind),
        patterns(2.0**-140 if narrow else _ZERO_BELOW, size["bits"]),
        patterns(1e-16, size["near 0"]),
        (np.pi / 2 - near).astype(kind),
        np.array(_LANDMARKS).astype(kind),
    ]
    return np.unique(np.concatenate(found))


@dataclass(frozen=True)
class Reference:
    """Exact values in the format that a result is judged in: value = nearest + rest * unit, all of them arrays."""

    points: Floats  # one row per argument
    values: Sequence[Any]  # balls
    nearest: Floats
    unit: Floats
    rest: Floats
    smallest: float  # the format's smallest normal number; relative errors below it are relative to it

    def errors(self, results: NDArray[Any]) -> tuple[Floats, Floats]:
        """Signed errors in ulp and relative errors; a result that is not a number is infinitely wrong.

        Those in ulp are (result - nearest)/unit - rest: fractional, against the unrounded value, also among denormal
        numbers.
        """
        with np.errstate(all="ignore"):
            ulp = np.asarray((results - self.nearest) / self.unit - self.rest, dtype=np.float64)
            relative = np.abs(ulp) * (self.unit / np.maximum(np.abs(self.nearest), self.smallest))
        bad = ~np.isfinite(np.asarray(results, dtype=np.float64))
        return np.where(bad, np.inf, ulp), np.where(bad, np.inf, relative)


class Answers:
    """Exact values of several results at each point, kept as decimals; judged by their worst relative error."""

    def __init__(self, points: Floats, texts: Sequence[Sequence[str]], size: Callable[[Floats], Floats] = abs) -> None:
        self.points = points
        self.nearest = np.array(texts, dtype=np.float64)
        self.rest = np.array([[float(Decimal(v) - Decimal(float(v))) for v in row] for row in texts])
        self.size = size(self.nearest)  # what errors are relative to

    def errors(self, results: Floats) -> tuple[None, Floats]:
        """Relative errors of the results that are given, the others being NaN."""
        return None, np.nanmax(np.abs((results - self.nearest) - self.rest) / self.size, axis=0)


def reference(points: Floats, values: Sequence[Any], kind: str = "float64") -> Reference:
    """Exact values, all of one type with its own arithmetic, made ready for the comparison in a format."""
    nearest = np.array([float(v) for v in values])
    unit = np.spacing(np.abs(nearest).astype(kind)).astype(np.float64)
    triples = zip(values, nearest.tolist(), unit.tolist(), strict=True)
    rest = [float((v - type(v)(n)) / type(v)(u)) for v, n, u in triples]
    return Reference(points, values, nearest, unit, np.array(rest), float(np.finfo(kind).smallest_normal))


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
    """All base quantities at every point; they share sine, cosine and logarithm."""
    from flint import arb, ctx

    found = {}
    for alpha in inputs(kind).tolist():
        # The closed forms are differences of O(alpha) that are O(alpha**3), and 1 - cos is one of O(1).
        thin = max(0, -int(np.frexp(alpha)[1])) if alpha else 0
        with ctx.workprec(int(3.33 * DIGITS) + 150 + 3 * thin):
            # float32's nearest number to pi/2 lies above it, and the domain ends there.
            values = moments(arb(alpha) if arb(alpha) < arb.pi() / 2 else arb.pi() / 2)
            wide = [n for n, v in values.items() if alpha and v.rel_accuracy_bits() < 3.33 * DIGITS]
            if wide:
                raise ArithmeticError(f"{wide[0]}({alpha!r}) has fewer than {DIGITS} digits")
        found[alpha] = values
    return found


def moments(half: Any) -> dict[str, Any]:
    """Every base quantity of a ball alpha, by its declared closed form; they share sine, cosine and logarithm."""
    s, c = half.sin(), half.cos()
    log = 0 * half if c.contains(0) else 2 * (s / (1 + c)).atanh()  # artanh(sin x) = 2 artanh(tan(x/2))
    balls = SimpleNamespace(sin=lambda x: x.sin(), cos=lambda x: x.cos(), atanh=lambda sine: log)
    return {name: form(balls, half) for name, form in CLOSED.items()}
