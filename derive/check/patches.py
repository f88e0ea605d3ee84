"""Division of the domain into patches, each with a tape of the program and Taylor models of its error.

Part of the checker (`certify`): standard library and python-flint only.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from flint import arb, arb_series

from derive.check import rounding, truth
from derive.check.records import Record
from derive.check.rounding import ROUNDING_BITS, TINY, UP, VALUE, Node, Tape, Unbounded, above, below, specialise
from derive.check.truth import BITS, CUBE, SEGMENTS, TOP, Balls, Definition, Model, Segment, ball, working

SMALL = 2.0**-7  # below, alpha = s xi with xi in [1/2, 1], and one window represents every power of two s
UNDERFLOW = 2.0**-320  # below, products may underflow, and another bound applies
QUARTER = float.fromhex("0x1.921fb54442d18p-1")  # pi/4


def _pieces(record: Record) -> list[tuple[float, float, Tape]]:
    """Return parts of [SMALL, TOP], both ends included and no double omitted, each with one tape."""
    inside = sorted(c for c in _cuts(record) if SMALL < c < TOP)
    todo = [(a, math.nextafter(b, -9.0)) for a, b in pairwise([SMALL, *inside, TOP])]
    todo.append((TOP, TOP))
    todo.reverse()
    parts: list[tuple[float, float, Tape]] = []
    while todo:
        a, b = todo.pop()
        try:
            tape = specialise(record, a, b)
        except Unbounded:
            if a == b:
                raise
            middle = min(a + (b - a) / 2, math.nextafter(b, -9.0))
            todo.append((math.nextafter(middle, 9.0), b))
            todo.append((a, middle))
            continue
        if parts and parts[-1][2] == tape:
            a = parts.pop()[0]
        parts.append((a, b, tape))
    return parts


def _cuts(record: Record) -> set[float]:
    """Return initial cuts, also where an exponent in the program changes. Undecided pieces are halved later."""
    cuts = {QUARTER, *(k / 16 for k in range(26))}
    if any(value == "exponent" for _, _, value in record["operations"]):
        cuts |= {math.nextafter(TOP - 0.75 * 2.0**-k, 9.0) for k in range(54)}
    return cuts


def ideal(tape: Tape, centre: arb) -> Balls:
    """Return Taylor coefficients of the program in real arithmetic for every point of the ball ``centre`` at once."""
    values: list[Any] = []
    for node in tape:
        if node.kind == "x":
            values.append(arb_series([centre, 1]))
        elif node.kind in VALUE:
            values.append(VALUE[node.kind](*(values[a] for a in node.args)))
        else:  # a constant, or an error, which is 0 in real arithmetic
            values.append(arb_series([arb(node.value if node.kind == "const" else 0)]))
    return truth.coefficients(values[-1])


@dataclass(frozen=True)
class Patch:
    """Piece of the domain within a segment, with the data that bound the error on any box of it.

    ``difference`` is (P - F) times the denominator of F, if it has one; on the first segment ``difference`` and
    ``above`` are divided by alpha**order. In a window (top > 0) a box is one of xi, and alpha = s xi, s <= top.
    """

    tape: Tape
    segment: Segment
    lower: float
    upper: float
    difference: Model
    above: Model
    below: Model | None
    order: int
    top: float = 0.0

    def error(self, lower: float, upper: float) -> tuple[float, float, float]:
        """Return bounds on the error before the last rounding and on the last rounding, and a lower bound on the value.

        All are divided by s**order.
        """
        with working(ROUNDING_BITS):
            x = ball(lower, upper)
            total, last = rounding.rounding_sum(self.tape, x)
            alpha = ball(0.0, self.top) if self.top else x
            t = alpha - self.segment.centre
            factor = x * x * x if self.order else arb(1)
            difference = self.difference(t) * factor
            exact = self.above(t) * factor
            if self.below is not None:
                divisor = self.below(t)
                difference = difference / divisor
                exact = exact / divisor
            distance = (above(difference) + total) * UP
            smallest = below(exact)
            if not (distance < math.inf and smallest >= 0):
                raise Unbounded("the error is not finite")
            return distance, last, smallest

    def remainder(self) -> float:
        """Return the remainder of the series of the difference over the value at the centre."""
        with working(BITS):
            centre = self.segment.centre
            distances = (abs(arb(x) - centre).upper() for x in (self.lower, self.upper))
            radius = max(distances)
            largest = abs(self.difference.last) * radius**self.difference.power
            rest = largest / abs(self.above.main(arb(0)))
            return float(rest.upper()) if rest.is_finite() else math.inf

    def window(self, top: float, bottom: float) -> "Patch":
        """Return the patch for every alpha = s xi, with s in [bottom, top] a power of two and xi in [1/2, 1]."""
        tape = scaled_tape(self.tape, self.order, top, bottom)
        return replace(self, tape=tape, lower=0.5, upper=1.0, top=top)


def patch(definition: Definition, tape: Tape, segment: Segment, lower: float, upper: float) -> Patch:
    """Return a patch with models of the program, of the exact function, and of their difference."""
    first, *others = (truth.kernel_model(statement, segment) for statement in definition)
    second = None
    if others:
        (second,) = others
    order = 0 if second or segment.lower else CUBE
    centre = segment.centre
    with working(BITS):
        fat = ball(min(lower, centre), max(upper, centre))
        computed = truth.model(ideal(tape, arb(centre)), ideal(tape, fat), order)
        if second is None:
            main = computed.main - first.main
            difference = Model(main, computed.last - first.last, computed.power)
        else:
            difference = _times_denominator(computed, first, second, fat - centre)
    return Patch(tape, segment, lower, upper, difference, first, second, order)


def _times_denominator(computed: Model, first: Model, second: Model, t: arb) -> Model:
    """Return (P - F1/F2) F2 = P F2 - F1, with the remainders of all three combined."""
    computed_rest, first_rest, second_rest = (
        model.last * arb(0, 1) * t.abs_upper() ** model.power for model in (computed, first, second)
    )
    main = computed.main * second.main - first.main
    last = computed_rest * second(t) + computed.main(t) * second_rest - first_rest
    return Model(main, last, 0)


def fine_patches(definition: Definition, tape: Tape, segment: Segment, lower: float, upper: float) -> Iterator[Patch]:
    """Yield one patch, or several on shorter segments, until the remainders of the series are far below an ulp."""
    narrow = upper - lower < 2.0**-10 * (TOP - lower)
    try:
        whole = patch(definition, tape, segment, lower, upper)
        if narrow or whole.remainder() < 2.0**-64:
            yield whole
            return
    except (ArithmeticError, ValueError):  # a division by a series, or a logarithm, that contains 0
        if narrow:
            raise
    middle = (segment.lower + segment.upper) / 2
    for half in (Segment(segment.lower, middle), Segment(middle, segment.upper)):
        start = max(half.lower, lower)
        end = min(half.upper, upper)
        if start < end:
            yield from fine_patches(definition, tape, half, start, end)


def patches(record: Record) -> Iterator[Patch]:
    """Yield the patches of the domain: a window for small alpha, then pieces on segments."""
    definition = record["definition"]
    near = near_zero(record)
    yield near.window(SMALL, UNDERFLOW) if near.order else near
    for a, b, tape in _pieces(record):
        for segment in SEGMENTS:
            for start, end in ((SMALL, QUARTER), (QUARTER, TOP)):
                left = max(a, segment.lower, start)
                right = min(b, segment.upper, end)
                if left < right or left == right in (a, b):
                    yield from fine_patches(definition, tape, segment, left, right)


def near_zero(record: Record) -> Patch:
    """Return the patch [0, SMALL], which `Patch.window` rescales to cover all powers of two of a range at once."""
    return patch(record["definition"], specialise(record, 0.0, SMALL), SEGMENTS[0], 0.0, SMALL)


def scaled_tape(tape: Tape, degree: int, top: float, bottom: float) -> Tape:
    """Return the tape over xi in [1/2, 1] for alpha = s xi with any power of two s in [bottom, top] at once.

    Every value has a degree k, and is s**k times the value on the new tape. Rounding scales with it, and underflow is
    at most TINY/2 bottom**-k. If different degrees are added, or a degree exceeds the result's, factors s**j are
    treated as unknown between 0 and top**j.
    """
    scaling = _Scaling(top, bottom)
    for node in tape:
        scaling.append(node, degree)
    if scaling.degrees[-1] != degree:
        raise Unbounded("near zero the program is not of the order of the kernel")
    return tuple(scaling.tape)


class _Scaling:
    """Tape of `scaled_tape`, with the degrees of its values and the new positions of old values."""

    def __init__(self, top: float, bottom: float) -> None:
        self.top = top
        self.bottom = bottom
        self.tape: list[Node] = []
        self.degrees: list[int] = []
        self.place: list[int] = []

    def append(self, node: Node, highest: int) -> None:
        """Append an operation of the old tape; ``highest`` is the degree of the result."""
        args = [self.place[a] for a in node.args]
        degrees = [self.degrees[a] for a in args]
        kind = node.kind
        if kind == "x":
            degree = 1
        elif kind == "const":
            degree = 0 if node.value else highest
        elif kind in ("neg", "error") and len(set(degrees)) == 1:
            degree = degrees[0]
        elif kind in ("add", "sub"):
            degree = min(degrees)
            args = [self.lower(a, degree) for a in args]
        elif kind in ("mul", "fma", "div"):
            first, second, *others = degrees
            product = first - second if kind == "div" else first + second
            degree = min(product, highest, *others)
            lowered = self.lower(args[0], degree - product + first)
            summands = [self.lower(a, degree) for a in args[2:]]
            args = [lowered, args[1], *summands]
        else:
            raise Unbounded(f"{kind} near zero")
        self.place.append(self.put(node._replace(args=tuple(args)), degree))

    def put(self, node: Node, degree: int) -> int:
        """Append a value of a degree, with its possible underflow."""
        floor = TINY
        for _ in range(degree):
            floor /= self.bottom  # in steps: bottom**-degree overflows
        self.tape.append(node._replace(floor=floor / 2 if degree > 0 else TINY))
        self.degrees.append(degree)
        return len(self.tape) - 1

    def lower(self, i: int, degree: int) -> int:
        """Return the value with a lower degree, where the power of s is treated as unknown."""
        by = self.degrees[i] - degree
        if not by:
            return i
        return self.put(Node("scale", (i,), self.top**by), degree)
