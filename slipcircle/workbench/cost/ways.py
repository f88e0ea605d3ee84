"""Every way to compute a kernel that the price list compares: this package's tiers, the paper's forms, quadrature."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial
from itertools import product
from types import SimpleNamespace
from typing import Any

import numpy as np

from generated import _compiled, kernels, printed, stable, tiers
from generated.definitions import CLOSED, INTEGRANDS, QUOTIENTS
from slipcircle.base.kinds import Floats
from slipcircle.workbench.cost import reference
from slipcircle.workbench.cost.reference import Reference

GAUSS_POINTS = (4, 8, 16, 32, 64)
FLOOR = "np.copyto (floor)"
FORMS = {"fused": "fused", "plain": "plain C", "numpy": "NumPy"}
CHEAPER = ("1e-10", "1e-6")
_BLOCK = 2**16  # nodes of a Gauss-Legendre rule that are evaluated at once


@dataclass(frozen=True)
class Way:
    """One way to compute a function."""

    name: str  # as the table has it; a tier's is "tier, form"
    function: Callable[..., Any]  # arrays in, an array out
    into: Callable[..., Any] | None = None  # into(*arrays, out), which allocates no result
    kind: str = "float64"  # format of its input and result, in which it is judged
    bound: float | None = None  # proved, of the relative error; without one the way is sampled only
    bound_ulp: float | None = None  # proved, of the error in ulp
    ours: bool = False  # whether this package offers it
    needs: str = ""  # a package that may be missing


@dataclass(frozen=True)
class Subject:
    """What is priced in one table."""

    name: str
    ways: list[Way]
    reference: Callable[[str], Reference]  # what they are judged by, in a format
    bulk: Callable[[int], Floats]  # so many arguments to time them with, one row per argument
    sizes: tuple[int, ...] = (0, 1, 2)  # which of `cost.SIZES` count
    patience: float = 1.0  # a pass may take so many times as long as others
    weighed: bool = False  # whether memory is measured too


def variants(name: str) -> list[Way]:
    """Each tier of a kernel as fused loops, plain loops and NumPy, with what is proved of it.

    Of the levels that this processor can run, the fastest with fused operations and the fastest without count.
    """
    levels = {form: level for level, (form, _) in reversed(_compiled.LEVELS.items())}
    ways, texts = [], kernels.TEXTS[name]
    for tier, form in product(texts, FORMS):
        kind = "float32" if tier == "float32" else "float64"
        loops = _compiled.LEVELS[levels[form]][1] if form in levels else {}
        compiled = loops.get("best" if kind == "float32" else tier, {})
        bounds = tiers.BOUNDS.get(name, {}).get(tier, {})
        bound, ulp = bounds.get(form, bounds.get("plain", (None, None)))
        accuracy = None
        if tier in CHEAPER:  # asked for by its own bound: the cheapest that meets it is itself
            if bound is None:
                continue
            accuracy = bound
        if form == "numpy" or name in compiled:
            kernel = _compiled.kernel(name, texts, levels[form])
            way = partial(kernel, where=True, accuracy=accuracy)
            ways.append(Way(f"{tier}, {FORMS[form]}", way, way, kind, bound, ulp, ours=True))
    return ways


def as_printed(name: str, x: Floats) -> Floats:
    """As the paper prints it; where it does not, its closed form, or the quotient of two."""
    with np.errstate(all="ignore"):
        if hasattr(printed, name):
            value = getattr(printed, name)(x)
        elif name in QUOTIENTS:
            above, below = (as_printed(part, x) for part in QUOTIENTS[name])
            value = above / below
        else:
            functions = SimpleNamespace(sin=np.sin, cos=np.cos, atanh=np.arctanh)
            value = CLOSED[name](functions, x)
    return np.asarray(value)


_rule = cache(np.polynomial.legendre.leggauss)


def gauss_legendre(power: int, turned: bool, count: int, alpha: Any) -> Floats:
    """The double integral of r**power (times cos u) by count Gauss-Legendre points in u; exact in r.

    The depth of the chord is written as a product, so that the rule and not the cancellation is measured.
    """
    nodes, weights = _rule(count)
    radial = [*zip(*_rule(power // 2 + 1), strict=True)]
    angles, integrals = np.atleast_1d(alpha), np.empty(np.size(alpha))
    size = _BLOCK // count
    for first in range(0, angles.size, size):
        half = angles[first : first + size, None]
        u = half * (nodes + 1) / 2
        cos = np.cos(u)
        drop = 2 * np.sin((half - u) / 2) * np.sin((half + u) / 2)  # cos u - cos half
        depth = drop / cos
        ring = np.zeros_like(depth)
        for node, weight in radial:
            r = 1 - depth * (1 + node) / 2
            ring += weight * r**power
        ring = ring * depth / 2
        if turned:
            ring *= cos
        integral = np.einsum("ij,j->i", ring, weights)  # one thread, like all others
        integrals[first : first + size] = half[:, 0] * integral
    return integrals


def angles(count: int) -> Floats:
    """Half angles to time kernels with, (1, count)."""
    return np.random.default_rng(0).uniform(0.0, np.pi / 2, (1, count))


def kernel(name: str) -> Subject:
    """A moment, weight or quotient of the arc."""
    rules = GAUSS_POINTS if name in INTEGRANDS else ()
    ways = [
        *variants(name),
        Way("half-angle, NumPy", getattr(stable, name)),
        Way("printed, float64", partial(as_printed, name)),
        *(Way(f"Gauss, {n} points", partial(gauss_legendre, *INTEGRANDS[name], n)) for n in rules),
        Way(FLOOR, np.copy, into=lambda x, out: np.copyto(out, x)),
    ]
    return Subject(name, ways, partial(reference.kernel, name), angles)


KERNELS = tuple(kernels.TEXTS)
FUNCTIONS: Mapping[str, Callable[[], Subject]] = {name: partial(kernel, name) for name in KERNELS}
