"""Correct rounding to float32: a program's double and the exact value lie on the same side of every midpoint.

A double within w of the exact value F rounds like F, unless a midpoint of two neighbours in float32 is within w of F.
All inputs with such a midpoint, which are hard to round (Lefevre and Muller 2001), are found. On a block of consecutive
inputs (n + t) h, F over half an ulp is a polynomial in the integer t, and it is near a midpoint if its remainder modulo
2 is near 1. At these inputs the program is run, and F is enclosed with more digits.

Part of the checker (`certify`): standard library, python-flint, and NumPy for the polynomials.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import chain
from typing import Any

import numpy as np
from flint import arb, arb_poly

from derive.check import truth
from derive.check.records import TIERS, Record, rejected
from derive.check.rounding import VALUE, above, below
from derive.check.truth import BITS, SEGMENTS, TOP, Model, Segment, working
from derive.kinds import Coefficients, Texts

SIGNIFICANDS = range(2**23, 2**24)
BLOCK = 2**14  # inputs per block
DEGREE = 5
WIDTH = TIERS["float32"].other * 2.0**-29  # in ulp of float32
SLACK = 2.0**-34  # error of the polynomials by truncation and rounding, in half ulps
DIGITS = 500  # precision in bits; closed forms lose less than 110 bits
LEAST = -150  # the exponent of half of the least float32


@cache
def hard_inputs(statement: str) -> Coefficients:
    """Return every float32 in (0, pi/2] whose exact value is within WIDTH ulp of a midpoint, and some more.

    Below the first power of two at which the value is less than half of the least float32 there are none.
    """
    found: list[float] = []
    exponent = 0
    with working(BITS):
        nearest, *_ = SEGMENTS
        largest = above(truth.kernel_model(statement, nearest)(truth.ball(0.0, 2.0**-40)))  # of F/alpha**3
        while largest * 8.0 ** (exponent + 1) >= 2.0 ** (LEAST - 1):
            h = 2.0 ** (exponent - 23)
            end = min(SIGNIFICANDS.stop, int(TOP / h) + 1)
            for start in range(SIGNIFICANDS.start, end, BLOCK):
                found += _near(statement, h, start, min(start + BLOCK, end))
            exponent -= 1
    return tuple(found)


def _near(statement: str, h: float, start: int, stop: int) -> Iterator[float]:
    """Yield such inputs n h with start <= n < stop, from the block or from its halves if it is undecided."""
    if stop - start == 1:
        yield start * h
        return
    middle = (start + stop) // 2
    row = _polynomial(statement, h, start, middle, stop)
    if row is None:
        yield from _near(statement, h, start, middle)
        yield from _near(statement, h, middle, stop)
        return
    first = BLOCK // 2 + start - middle
    halves = row @ POWERS[:, first : BLOCK // 2 + stop - middle] / 2
    distance = 0.5 - np.abs(halves - np.rint(halves))  # from the nearest midpoint, in ulp
    for t in np.flatnonzero(distance <= WIDTH + SLACK).tolist():
        yield (start + t) * h


T = np.arange(-BLOCK // 2, BLOCK // 2, dtype=np.float64)
POWERS = np.stack([T**k for k in range(DEGREE + 1)])


def _polynomial(statement: str, h: float, start: int, middle: int, stop: int) -> list[float] | None:
    """Return F((middle + t) h) over half an ulp, modulo 2, by powers of t, or None if its error exceeds SLACK."""
    lowest = start * h
    highest = (stop - 1) * h
    around = [s for s in SEGMENTS if s.lower <= lowest and highest <= s.upper]
    if not around:
        return None
    radius = middle - start
    terms, rest = _about(statement, around[0], middle * h, h, radius)
    t = arb(0, radius)
    values = terms(t) + rest
    unit = _half_ulp(below(values))
    if unit < _half_ulp(above(values)):
        return None
    coefficients = [c / unit for c in terms.coeffs()]
    for k in (0, 1):  # t is an integer
        coefficients[k] -= 2 * (coefficients[k].mid() / 2).floor()
    lost = above(arb_poly(coefficients[DEGREE + 1 :])(t) * radius ** (DEGREE + 1) + rest / unit)
    row = []
    for k, coefficient in enumerate(coefficients[: DEGREE + 1]):
        nearest = float(coefficient)
        row.append(nearest)
        error = above(coefficient - nearest) + 2.0**-49 * abs(nearest)  # sums and products among it
        lost += error * float(radius) ** k
    return row if lost < SLACK else None


def _about(statement: str, segment: Segment, x: float, h: float, radius: int) -> tuple[arb_poly, arb]:
    """Return F(x + t h) as a polynomial in t, and a ball around zero that encloses its error for |t| <= radius."""
    model: Model = truth.kernel_model(statement, segment)
    offset = arb(x) - segment.centre
    reach = radius * arb(h)
    polynomial = model.main(arb_poly([offset, h]))
    largest = abs(offset) + reach
    rest = model.last * arb(0, 1) * largest**model.power
    if segment.lower == 0:  # where the model is of F/alpha**3
        alpha = arb_poly([x, h])
        polynomial *= alpha * alpha * alpha
        most = arb(x) + reach
        rest *= most * most * most
    return polynomial, rest


def _half_ulp(value: float) -> float:
    """Return half a unit in the last place of float32 at a non-negative value."""
    _, exponent = math.frexp(value)
    return math.ldexp(1.0, max(exponent - 25, LEAST))


def prove(record: Record) -> None:
    """Prove that the double of a program is rounded correctly at every float32, and that its hard inputs are stated.

    The bound of the record must have been proved.

    Raises
    ------
    ProofError
        With the name of the failed check: rounding or hard.
    """
    stated = record["hard"]
    found = hard(record)
    if found != stated:
        raise rejected("hard", record, " ".join(stated), " ".join(found))


def hard(record: Record) -> Texts:
    """Return the significands of the inputs that the bound leaves undecided, after checking the rounding at each."""
    (statement,) = record["definition"]
    significands = set()
    for x in chain(hard_inputs(statement), (TOP,)):  # the float32 next to pi/2 lies above it and is clipped
        with working(DIGITS):
            exact = truth.enclosure([statement], arb(x)) if x < TOP else truth.half_disc_limit([statement])
            near = record["bound"] * 2.0**-28 * _half_ulp(above(exact))
            if _rounds_to(exact, np.float32(float(exact)), near):
                continue
            significand, _ = math.frexp(x)
            bits = int(significand * SIGNIFICANDS.stop)
            significands.add(f"{bits:06x}")
            computed = run(record, x)
            if not _rounds_to(exact, np.float32(computed)):
                raise rejected("rounding", record, f"{computed.hex()} at {x.hex()}", exact.str(20))
    return sorted(significands)


def _rounds_to(exact: arb, value: Any, margin: float = 0.0) -> bool:
    """Return whether a float32 is the nearest to an exact value by more than a margin."""
    middle = float(value)
    below_it = float(np.nextafter(value, np.float32(-9)))
    above_it = float(np.nextafter(value, np.float32(9)))
    lower = (below_it + middle) / 2
    upper = (middle + above_it) / 2
    return bool(lower + arb(margin) < exact < upper - arb(margin))


MEANING = VALUE | {"fma": lambda a, b, c: float(Fraction(a) * Fraction(b) + Fraction(c))}  # rounded once


def run(record: Record, x: float) -> float:
    """Return the output of a program at an input, with every operation rounded once."""
    values: list[float] = []
    for kind, args, constant in record["operations"]:
        if kind == "input":
            values.append(x)
        elif kind == "const":
            values.append(float.fromhex(constant))
        else:
            values.append(MEANING[kind](*(values[k] for k in args)))
    return values[record["output"]]
