"""Whether a formula is real, finite and not negative on a domain: interval arithmetic and bisection."""

import heapq
import math
from collections.abc import Mapping
from itertools import count
from typing import NamedTuple

import sympy as sp
from flint import arb, fmpq

from derive.check.truth import ball

Box = dict[sp.Symbol, tuple[float, float]]
BOXES = 300  # to look at
SMALL = 1e-3  # of a box that is not bisected further, over its distance from 0 where that is above 1
BELOW = -1e-9  # what rounding may make of 0


class Place(NamedTuple):
    """Where a formula leaves its range, and how."""

    why: str
    at: Mapping[sp.Symbol, float]

    def __str__(self) -> str:
        return f"{self.why} at {', '.join(f'{x} = {self.at[x]:.3g}' for x in sorted(self.at, key=str))}"


def enclosed(e: sp.Expr, at: Mapping[sp.Symbol, arb]) -> arb:
    """A ball around all values of an expression over balls; not finite where it may be singular or complex."""
    if e in at:
        return at[e]
    if e.is_Rational:
        return arb(fmpq(int(e.p), int(e.q)))
    if e.is_number:
        return arb(str(sp.N(e, 20)))
    parts = [enclosed(x, at) for x in e.args]
    if e.is_Add:
        return sum(parts, arb(0))
    if e.is_Mul:
        return math.prod(parts, start=arb(1))
    if e.is_Pow:
        return parts[0] ** int(e.exp) if e.exp.is_Integer else (parts[0].log() * parts[1]).exp()
    if isinstance(e, sp.Min | sp.Max):
        first, *others = parts
        for other in others:
            first = first.min(other) if isinstance(e, sp.Min) else first.max(other)
        return first
    return getattr(parts[0], type(e).__name__)()


def outside(e: sp.Expr, domain: Box) -> Place | None:
    """Where an expression has a pole, is complex or is negative; None if it is shown, or is likely, to be neither.

    Boxes that may hold a pole come first, and one that is small and may still hold it does. Of the others those come
    first that reach far.
    """
    order = count()
    boxes = [(0, next(order), domain)]
    for _ in range(BOXES):
        if not boxes:
            return None
        _, _, box = heapq.heappop(boxes)
        value = enclosed(e, {x: ball(*ends) for x, ends in box.items()})
        finite = value.is_finite()
        if finite and value.lower() > BELOW:
            continue
        inside = {x: _middle(*ends) for x, ends in box.items()}
        at_point = enclosed(e, {x: arb(place) for x, place in inside.items()})
        if at_point.upper() < BELOW:
            return Place(f"{float(at_point.mid()):.3g}", inside)
        widest = max(box, key=lambda x: _width(*box[x]))
        low, high = box[widest]
        if _width(low, high) < SMALL:
            if not finite:
                return Place("a pole or a complex number", inside)
            continue
        for half in ((low, inside[widest]), (inside[widest], high)):
            heapq.heappush(boxes, (int(finite), next(order) if finite else -next(order), box | {widest: half}))
    return None


def _width(low: float, high: float) -> float:
    return (high - low) / max(1.0, abs(low))


def _middle(low: float, high: float) -> float:
    """By ratio where the box reaches far, which counts from 1."""
    if low >= 0.0 and high > 4.0 * max(low, 1.0):
        return math.sqrt(high * max(low, 1.0))
    return (low + high) / 2.0
