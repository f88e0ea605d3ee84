"""Every way to compute a function that the price list compares: this package's tiers, the paper's forms, quadrature."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from generated import _compiled, kernels, motion, printed, stable, tiers
from generated.definitions import CLOSED, INTEGRANDS, QUOTIENTS
from slipcircle.cost import reference
from slipcircle.cost.reference import Floats, Reference

GAUSS_POINTS = (4, 8, 16, 32, 64)
FLOOR = "np.copyto (floor)"
_BLOCK = 2**16  # nodes of a Gauss-Legendre rule that are evaluated at once


@dataclass(frozen=True)
class Way:
    """One way to compute a function.

    Attributes
    ----------
    name : str
        As the table has it; a tier's is "tier, form".
    function : callable
        Arrays in, an array out.
    into : callable, optional
        ``into(*arrays, out)``, which allocates no result.
    kind : str
        Format of its input and result, in which it is judged.
    bound, bound_ulp : float, optional
        Proved bounds of the relative error and of the error in ulp; without one the way is sampled only.
    ours : bool
        Whether this package offers it.
    """

    name: str
    function: Callable[..., Any]
    into: Callable[..., Any] | None = None
    kind: str = "float64"
    bound: float | None = None
    bound_ulp: float | None = None
    ours: bool = False


@dataclass(frozen=True)
class Subject:
    """A function to be priced: the ways, their reference in a format, and what arguments to time them with."""

    ways: list[Way]
    reference: Callable[[str], Reference]
    bulk: Callable[[int], Floats]  # one row per argument
    longest: float = 0.1  # seconds that a single pass may take
    weighed: bool = False  # whether memory is measured too


# --- this package --------------------------------------------------------------------------------------------------


def variants(name: str) -> list[Way]:
    """Each tier of a kernel as fused loops, plain loops and NumPy, with what is proved of it.

    Of the levels that this processor can run, the fastest with fused operations and the fastest without count.
    """
    levels = {form: level for level, (form, _) in reversed(_compiled.LEVELS.items())}
    found, texts = [], kernels.TEXTS[name]
    for tier in texts:
        for form, words in (("fused", "fused"), ("plain", "plain C"), ("numpy", "NumPy")):
            loops = _compiled.LEVELS[levels[form]][1] if form in levels else {}
            if form != "numpy" and name not in loops.get("best" if tier == "float32" else tier, {}):
                continue
            bounds = tiers.BOUNDS.get(name, {}).get(tier, {})
            bound, ulp = bounds.get(form, bounds.get("plain", (None, None)))
            call = _compiled.kernel(name, texts, levels[form])
            # A cheaper tier is asked for by its own bound: the cheapest that meets it is itself.
            cheaper = tier in ("1e-10", "1e-6")
            if cheaper and bound is None:
                continue
            way = partial(call, where=True, accuracy=bound if cheaper else None)
            kind = "float32" if tier == "float32" else "float64"
            found.append(Way(f"{tier}, {words}", way, way, kind, bound, ulp, ours=True))
    return found


# --- closed forms, over any arithmetic m that has sin, cos and atanh -------------------------------------------------


def closed(name: str, m: Any, x: Any) -> Any:
    """The closed form of a kernel in an arithmetic; a quotient is one of two of them."""
    found = [CLOSED[part](m, x) for part in QUOTIENTS.get(name, (name,))]
    return found[0] / found[1] if len(found) > 1 else found[0]


def _printed(name: str, x: Floats) -> Floats:
    """As the paper prints it, and where it does not, as its definition integrates."""
    with np.errstate(all="ignore"):
        if hasattr(printed, name):
            return np.asarray(getattr(printed, name)(x))
        if name in QUOTIENTS:
            above, below = (_printed(part, x) for part in QUOTIENTS[name])
            return np.asarray(above / below)
        return np.asarray(closed(name, _NUMPY, x))


_NUMPY = SimpleNamespace(sin=np.sin, cos=np.cos, atanh=np.arctanh)


# --- quadrature ----------------------------------------------------------------------------------------------------


_rule = cache(np.polynomial.legendre.leggauss)


def gauss_legendre(power: int, turned: bool, count: int, alpha: Any) -> Floats:
    """The double integral of r**power (times cos u) by count Gauss-Legendre points in u; exact in r.

    The depth of the chord is written as a product, so that the rule and not the cancellation is measured.
    """
    (x, w), (inner, weights) = _rule(count), _rule(power // 2 + 1)
    half, found = np.atleast_1d(alpha), np.empty(np.size(alpha))
    for start in range(0, half.size, _BLOCK // count):
        a = half[start : start + _BLOCK // count, None]
        u = a * (x + 1) / 2
        depth = 2 * np.sin((a - u) / 2) * np.sin((a + u) / 2) / np.cos(u)
        ring = sum(v * (1 - depth * (1 + y) / 2) ** power for y, v in zip(inner, weights, strict=True))
        ring = depth / 2 * ring * (np.cos(u) if turned else 1.0)
        found[start : start + a.size] = a[:, 0] * np.einsum("ij,j->i", ring, w)  # one thread, like all others
    return found


@cache
def multiprecision(digits: int) -> Any:
    """Mpmath's numbers with so many digits, of a context of our own."""
    try:
        import mpmath
    except ImportError as error:
        raise ImportError("the reference needs mpmath: pip install 'slipcircle[derive]'") from error
    mp = mpmath.mp.clone()
    mp.dps = digits
    return mp


# --- subjects ------------------------------------------------------------------------------------------------------


def _floor() -> Way:
    return Way(FLOOR, np.copy, into=lambda x, out: np.copyto(out, x))


def kernel(name: str) -> Subject:
    """A moment, weight or quotient of the arc."""
    found = [
        *variants(name),
        Way("half-angle, NumPy", getattr(stable, name)),
        Way("printed, float64", partial(_printed, name)),
    ]
    if name in INTEGRANDS:
        found += [Way(f"Gauss, {n} points", partial(gauss_legendre, *INTEGRANDS[name], n)) for n in GAUSS_POINTS]
    return Subject([*found, _floor()], partial(reference.kernel, name), partial(_angles, 1))


def _angles(rows: int, count: int) -> Floats:
    return np.random.default_rng(0).uniform(0.0, np.pi / 2, (rows, count))


MOTION: Mapping[str, Callable[..., Any]] = {  # (3.20) corrected, and its integral
    "angular_velocity": lambda m, a, b, t: m.sqrt(a / b) * m.tanh(m.sqrt(a * b) * t),
    "rotation": lambda m, a, b, t: m.log(m.cosh(m.sqrt(a * b) * t)) / b,
}


def slide(name: str) -> Subject:
    """A formula of the frozen slide from rest, over drive a, brake b and time t."""
    points = np.array([[0.24, 0.19, 1e-8], [0.24, 0.19, 1e-4], [0.24, 0.19, 2.4], [0.24, 1e-12, 2.4],
                       [0.24, 0.19, 100.0], [0.24, 0.19, 1e4], [1e-12, 0.19, 2.4]]).T  # fmt: skip
    from_rest = getattr(motion, f"frozen_{name}")

    def exact(kind: str) -> Reference:
        mp = multiprecision(90)
        return reference.reference(points, [MOTION[name](mp, *map(mp.mpf, p)) for p in points.T.tolist()], kind)

    found = [
        Way("stable, NumPy", lambda a, b, t: from_rest(a, b, 0.0, t), ours=True),
        Way("printed, float64", getattr(printed, name)),
    ]
    return Subject(found, exact, lambda count: np.random.default_rng(0).uniform(0.1, 2.0, (3, count)))


KERNELS = tuple(kernels.TEXTS)
FUNCTIONS: Mapping[str, Callable[[], Subject]] = {
    **{name: partial(kernel, name) for name in KERNELS},
    **{name: partial(slide, name) for name in MOTION},
}
