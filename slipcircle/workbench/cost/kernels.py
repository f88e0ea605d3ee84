"""Cost of accuracy for a kernel: error and time of its tiers and of the printed form, against exact values.

Inputs are uniform in value, and uniform in decades towards both ends of [0, pi/2].
"""

from collections.abc import Iterator
from functools import cache, partial
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import _compiled, kernels, printed, tiers
from generated.definitions import CLOSED, QUOTIENTS
from slipcircle.base.kinds import Floats, Function, ValueDict
from slipcircle.base.optional import optional
from slipcircle.workbench.cost.rows import CostRow, medians, with_verdicts

KERNELS = (*CLOSED, *QUOTIENTS)
SIZE = 10_000  # elements of the timed arrays, which stay in the cache
POINTS = 10_000  # number of points for the errors
_DECADES = {"float64": -96.0, "float32": -12.0}  # decades below which moments, alpha**3 or smaller, underflow
_LANDMARKS = (0.0, 5e-324, 2.0**-1022, 2.0**-26, np.pi / 8, np.pi / 4, 1.1, np.nextafter(np.pi / 2, 0.0), np.pi / 2)


class Way(NamedTuple):
    """Way to compute a kernel."""

    name: str
    function: Function
    kind: str = "float64"  # format of its input and result
    bound: float | None = None  # proved bound of the relative error


class Exact(NamedTuple):
    """Exact values at some points, each the sum of two doubles."""

    points: Floats
    nearest: Floats
    rest: Floats
    least: float  # least size to which errors are relative

    def errors(self, results: NDArray[Any]) -> Floats:
        """Return the relative errors of results at the points, (points,); infinite where a result is not finite."""
        size = np.maximum(np.abs(self.nearest), self.least)
        with np.errstate(all="ignore"):
            errors = np.abs((results - self.nearest) - self.rest) / size
        return np.where(np.isfinite(results), errors, np.inf)


def of_kernel(name: str) -> list[CostRow]:
    """Return a row with error and time for each way to compute a kernel."""
    optional("flint", "the reference", "python-flint")
    inputs_in_order = np.random.default_rng(0).uniform(0.0, np.pi / 2, SIZE)
    every = list(ways(name))
    seconds = medians([partial(way.function, inputs_in_order.astype(way.kind)) for way in every])
    rows = []
    for way, taken in zip(every, seconds, strict=True):
        exact = exact_values(name, way.kind)
        errors = exact.errors(way.function(exact.points.astype(way.kind)))
        rows.append(CostRow(name, way.name, SIZE, float(errors.max()), way.bound, taken / SIZE, accuracy=way.bound))
    return with_verdicts(rows)


def ways(name: str) -> Iterator[Way]:
    """Yield all ways to compute a kernel: its tiers (accuracies), compiled and on NumPy, and the printed form."""
    for level in dict.fromkeys((_compiled.LEVEL, "numpy")):
        form, _ = _compiled.LEVELS[level]
        for tier in kernels.TEXTS[name]:
            proved = tiers.BOUNDS.get(name, {}).get(tier, {})
            bound, _ = proved.get(form, proved.get("plain", (None, None)))
            kind = "float32" if tier == "float32" else "float64"
            accuracy = bound if tier.startswith("1e") else None  # a tier is the cheapest that meets its own bound
            call = partial(_compiled.kernel(name, kernels.TEXTS[name], level), accuracy=accuracy)
            yield Way(tier if level != "numpy" else f"{tier}, NumPy", call, kind, bound)
    yield Way("printed", partial(as_printed, name))


def as_printed(name: str, x: Floats) -> Floats:
    """Return a kernel at x in rad as the paper prints it, else by its closed form or as a quotient of two kernels."""
    with np.errstate(all="ignore"):
        if hasattr(printed, name):
            value = getattr(printed, name)(x)
        elif name in QUOTIENTS:
            above, below = (as_printed(part, x) for part in QUOTIENTS[name])
            value = above / below
        else:
            value = CLOSED[name](SimpleNamespace(sin=np.sin, cos=np.cos, atanh=np.arctanh), x)
    return value


# --- exact values ----------------------------------------------------------------------------------------------------


@cache
def kernel_inputs(kind: str = "float64") -> NDArray[Any]:
    """Return increasing inputs from 0 to pi/2 in a format ("float64" or "float32"), drawn with a fixed seed."""
    rng = np.random.default_rng(2017)
    uniform = rng.uniform(0.0, np.pi / 2, POINTS // 2)
    decades = rng.uniform(_DECADES[kind], 0.0, POINTS // 4)
    near = rng.uniform(-16.5, -0.5, POINTS // 4)
    return np.unique(np.concatenate([uniform, 10.0**decades, np.pi / 2 - 10.0**near, _LANDMARKS]).astype(kind))


@cache
def exact_values(name: str, kind: str = "float64") -> Exact:
    """Return exact values of a kernel at `kernel_inputs` where they exist, by its closed form in ball arithmetic.

    ``kind`` is the format of the inputs, "float64" or "float32".
    """
    from flint import ctx

    with ctx.workprec(400):
        balls = _balls(kind)
        if name in QUOTIENTS:  # 0/0 at 0
            above, below = QUOTIENTS[name]
            values = {x: of[above] / of[below] for x, of in balls.items() if x}
        else:
            values = {x: of[name] for x, of in balls.items()}
        nearest = [float(ball) for ball in values.values()]
        rest = [float(ball - value) for ball, value in zip(values.values(), nearest, strict=True)]
    return Exact(np.array([*values]), np.array(nearest), np.array(rest), float(np.finfo(kind).smallest_normal))


@cache
def _balls(kind: str) -> dict[float, ValueDict]:
    """Return every base quantity at every input as python-flint's balls (intervals), by input and name."""
    from flint import arb, ctx

    values = {}
    for alpha in kernel_inputs(kind).tolist():
        # For 50 digits: closed forms are O(alpha**3) differences of O(alpha) terms, 1 - cos a difference of O(1) terms.
        thin = max(0, -int(np.frexp(alpha)[1])) if alpha else 0
        with ctx.workprec(320 + 3 * thin):
            # float32's nearest number to pi/2 lies above it, and the domain ends there.
            right_angle = arb.pi() / 2
            half = arb(alpha)
            if not half < right_angle:
                half = right_angle
            sine, cosine = half.sin(), half.cos()
            tangent = sine / (1 + cosine)  # tan(x/2), as artanh(sin x) = 2 artanh(tan(x/2))
            log = arb(0) if cosine.contains(0) else 2 * tangent.atanh()
            balls = SimpleNamespace(sin=arb.sin, cos=arb.cos, atanh=lambda sine, log=log: log)
            values[alpha] = {name: form(balls, half) for name, form in CLOSED.items()}
    return values
