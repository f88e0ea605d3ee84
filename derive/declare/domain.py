"""Check that a formula is real, finite and non-negative on a domain, by interval arithmetic and bisection."""

import math
from collections import deque
from collections.abc import Mapping, Sequence
from functools import reduce
from itertools import product

from flint import arb
from sympy import Expr, Symbol, diff, lambdify

from derive.check.truth import ball
from derive.kinds import TextPair

BOXES = 400  # to look at
SMALL = 1e-3  # of a box that is not bisected further, over its distance from 0 where that is above 1
BELOW = -1e-9  # what rounding may make of 0
Ends = tuple[float, float]
_ARITHMETIC = {name: getattr(arb, name) for name in ("exp", "log", "sin", "cos", "tanh", "sqrt")} | {
    "min": lambda *x: reduce(arb.min, map(arb, x)),
    "max": lambda *x: reduce(arb.max, map(arb, x)),
}


def fault(e: Expr, domain: Mapping[Symbol, Ends]) -> TextPair:
    """Return where an expression has a pole, is complex or negative, and where it is undecided; otherwise empty texts.

    ``domain`` has the least and greatest value of each symbol, also of others. An undecided expression is searched
    again at the ends of all symbols in which it is linear, where it is least.
    """
    domain = {x: ends for x, ends in domain.items() if e.has(x)}
    wrong, undecided = _search(e, domain)
    if wrong or not undecided:
        return wrong, ""
    linear = [x for x in domain if not diff(e, x).has(x)]
    for ends in product(*(domain[x] for x in linear)):
        corner = zip(linear, zip(ends, ends, strict=True), strict=True)
        wrong, undecided = _search(e, domain | dict(corner))
        if wrong or undecided:
            return wrong, undecided
    return "", ""


def _search(e: Expr, domain: Mapping[Symbol, Ends]) -> TextPair:
    """Return the place of a fault and an undecided place, as `fault` does, from a limited number of boxes.

    Those that may hold a pole come first, and one that is small and may still hold it does. Of the others those come
    first that are large.
    """
    value = lambdify([*domain], e, [_ARITHMETIC])
    boxes = deque([[*domain.values()]])
    middle: list[float] = []
    for _ in range(1, BOXES):
        if not boxes:
            return "", ""
        box = boxes.popleft()
        enclosed = arb(value(*(ball(*ends) for ends in box)))
        if enclosed.lower() > BELOW:
            continue
        middle = [_middle(*ends) for ends in box]
        here = arb(value(*map(arb, middle)))
        if here.upper() < BELOW:
            return f"{float(here.mid()):.3g} at {_place(domain, middle)}", ""
        widest = max(range(len(box)), key=lambda k: _width(*box[k]))
        if _width(*box[widest]) < SMALL:
            if not enclosed.is_finite():
                return f"a pole or a complex number next to {_place(domain, middle)}", ""
            continue
        low, high = box[widest]
        ends = (low, middle[widest]), (middle[widest], high)
        lower, upper = ([*box[:widest], half, *box[widest + 1 :]] for half in ends)
        if enclosed.is_finite():
            boxes += lower, upper
        else:
            boxes.extendleft((upper, lower))
    return "", _place(domain, middle)


def _place(domain: Mapping[Symbol, Ends], values: Sequence[float]) -> str:
    """Return the values of the symbols as text."""
    return ", ".join(f"{x} = {at:.3g}" for x, at in zip(domain, values, strict=True))


def _width(low: float, high: float) -> float:
    """Return the width of an interval, over the size of its lower end where that exceeds 1."""
    return (high - low) / max(1.0, abs(low))


def _middle(low: float, high: float) -> float:
    """Return the middle of an interval, geometric if it extends far beyond 1."""
    if low >= 0.0 and high > 4.0 * max(low, 1.0):
        return math.sqrt(high * max(low, 1.0))
    return (low + high) / 2.0
