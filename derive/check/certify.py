"""The checker: proves the error bound of a straight-line float64 program on the whole domain, rounding included.

It reads plain data (`generated/certificates/*.json`) and uses the standard library and python-flint only; of the
generator it knows nothing: what a kernel is says the certificate itself, by the definition that `derive.check.truth`
reads. Per box of alpha,

    |computed - exact| <= |P - F| + sum_i sup |dP/dn_i| d_i + half an ulp,

where P is the program in real arithmetic (Taylor models), n_i the rounding error of operation i with its bound d_i, and
the derivatives are taken backwards through the program in ball arithmetic, over all alpha of the box and all errors
within their bounds (mean value theorem, so that nothing of higher order is dropped). Exact operations have no n_i, and
an operation that computes the rounding error of another one *is* that n_i, so compensation counts.
"""

import heapq
import math
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, NamedTuple

from flint import arb, arb_series

from derive.check import rounding, truth
from derive.check.proof import ProofError
from derive.check.records import TIERS, Record, assumptions, check_goals, digest, read, rejected
from derive.check.rounding import DOWN, ROUNDING_BITS, TINY, UP, VALUE, Tape, Unbounded, specialise
from derive.check.truth import BITS, CUBE, SEGMENTS, TOP, Definition, Model, Segment, ball, working

SMALL = 2.0**-7  # below, alpha = s xi with xi in [1/2, 1]: one window stands for every power of two s
UNDERFLOW = 2.0**-320  # below, products may underflow: another bound holds
VANISHING = 2.0**-352  # below, every kernel is under 2**-1055
QUARTER = float.fromhex("0x1.921fb54442d18p-1")  # pi/4


def pieces(record: Record, lower: float, upper: float) -> list[tuple[float, float, Tape]]:
    """Parts of [lower, upper], both ends included, no double left out, each with one tape."""
    starts = [lower, *sorted(c for c in _cuts(record) if lower < c < upper), upper]
    todo = [(a, math.nextafter(b, -9.0)) for a, b in pairwise(starts)]
    todo.append((upper, upper))
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
            todo += [(math.nextafter(middle, 9.0), b), (a, middle)]
            continue
        if parts and parts[-1][2] == tape:
            a = parts.pop()[0]
        parts.append((a, b, tape))
    return parts


def _cuts(record: Record) -> set[float]:
    """Where to cut first, a guess from the constants that are compared too: what is undecided is halved."""
    cuts = {QUARTER, *(k / 16 for k in range(26))}
    operations = record["operations"]
    for kind, args, value in operations:
        if kind == "less":
            compared = (operations[a] for a in args)
            cuts |= {float.fromhex(c) for kind, _, c in compared if kind == "const"}
        elif value == "exponent":
            cuts |= {math.nextafter(TOP - 0.75 * 2.0**-k, 9.0) for k in range(54)}
    return cuts


def ideal(tape: Tape, centre: arb) -> list[arb]:
    """Taylor coefficients of the program in real arithmetic, for every point of the ball ``centre`` at once."""
    values: list[Any] = []
    for node in tape:
        if node.kind == "x":
            values.append(arb_series([centre, 1]))
        elif node.kind in VALUE:
            operands = (values[a] for a in node.args)
            values.append(VALUE[node.kind](*operands))
        else:  # a constant, or an error, which there is none of
            constant = node.value if node.kind == "const" else 0
            values.append(arb_series([arb(constant)]))
    return truth.coefficients(values[-1])


@dataclass(frozen=True)
class Patch:
    """A piece of the domain within a segment: what bounds the error on any box of it.

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
        """At most |before the last rounding - exact| and the last rounding's error, at least |exact|; over s**order."""
        with working(ROUNDING_BITS):
            x = ball(lower, upper)
            total, last = rounding.rounding_sum(self.tape, x)
            t = (ball(0.0, self.top) if self.top else x) - self.segment.centre
            factor = x * x * x if self.order else arb(1)
            difference = self.difference(t) * factor
            exact = self.above(t) * factor
            if self.below is not None:
                divisor = self.below(t)
                difference = difference / divisor
                exact = exact / divisor
            distance = (float(difference.abs_upper()) * UP + total) * UP
            smallest = float(exact.abs_lower()) * DOWN
            if not (distance < math.inf and smallest >= 0):
                raise Unbounded("the error is not finite")
            return distance, last, smallest

    def remainder(self) -> float:
        """Of the series of the difference, over the value at the centre."""
        with working(BITS):
            reach = max(abs(arb(x) - self.segment.centre).upper() for x in (self.lower, self.upper))
            rest = abs(self.difference.last) * reach**self.difference.power / abs(self.above.main(arb(0)))
            return float(rest.upper()) if rest.is_finite() else math.inf

    def window(self, top: float, bottom: float) -> "Patch":
        """For every alpha = s xi, s in [bottom, top] a power of two, xi in [1/2, 1]."""
        tape = rounding.scaled(self.tape, self.order, top, bottom)
        return replace(self, tape=tape, lower=0.5, upper=1.0, top=top)


def patch(definition: Definition, tape: Tape, segment: Segment, lower: float, upper: float) -> Patch:
    """Models of the program and of the exact function, and of what lies between them."""
    first, *others = (truth.kernel(statement, segment) for statement in definition)
    second = others[0] if others else None
    order = 0 if second or segment.lower else CUBE
    centre = segment.centre
    with working(BITS):
        fat = ball(min(lower, centre), max(upper, centre))
        computed = truth.model(ideal(tape, arb(centre)), ideal(tape, fat), order)
        if second is None:
            difference = Model(computed.main - first.main, computed.last - first.last, computed.power)
        else:  # (P - F1/F2) F2
            t = fat - centre
            computed_rest, first_rest, second_rest = (
                model.last * arb(0, 1) * t.abs_upper() ** model.power for model in (computed, first, second)
            )
            last = computed_rest * second(t) + computed.main(t) * second_rest - first_rest
            difference = Model(computed.main * second.main - first.main, last, 0)
    return Patch(tape, segment, lower, upper, difference, first, second, order)


def fine_patches(definition: Definition, tape: Tape, segment: Segment, lower: float, upper: float) -> Iterator[Patch]:
    """One patch, or several on shorter segments, until the remainders of the series are far below an ulp."""
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


def patches(record: Record, lower: float = 0.0, upper: float = TOP) -> Iterator[Patch]:
    """The domain, or a part: a window for [UNDERFLOW, SMALL], or [0, SMALL] for a quotient, then pieces on segments."""
    definition = record["definition"]
    if lower < SMALL:
        near = patch(definition, specialise(record, 0.0, SMALL), SEGMENTS[0], 0.0, SMALL)
        yield near.window(SMALL, UNDERFLOW) if near.order else near
    for a, b, tape in pieces(record, max(lower, SMALL), upper):
        for segment in SEGMENTS:
            for start, end in ((SMALL, QUARTER), (QUARTER, TOP)):
                left = max(a, segment.lower, start)
                right = min(b, segment.upper, end)
                if left < right or left == right in (a, b):
                    yield from fine_patches(definition, tape, segment, left, right)


def ulp(x: float, bits: int) -> float:
    """Unit in the last place of an exact value x >= 0, exponents unbounded: the smaller one at a power of two."""
    mantissa, exponent = math.frexp(x)
    if x:
        return math.ldexp(1.0, exponent - bits - (mantissa == 0.5))
    return 0.0


def in_units(tier: str, distance: float, last: float, smallest: float, least: float = 0.0) -> float:
    """The error on a box in the unit of its tier; ``least`` is the least ulp.

    |rounded - exact| is at most the distance before the last rounding plus half an ulp *of the exact value*, if that
    distance is at most one ulp: where the exact value lies below a power of two and the number to be rounded above it,
    the power of two is the nearest double.
    """
    if not smallest > 0 and not least > 0:
        return math.inf  # the box is too wide
    if not (bits := TIERS[tier].bits):
        return (distance + last) / smallest * UP
    if bits == 24:  # computed in double precision, then rounded once more
        distance += last
    unit = max(ulp(smallest, bits), least)
    if distance <= unit:
        return (distance / unit + 0.5) * UP
    if bits == 53:
        return (distance + last) / unit * UP
    return math.inf


def below_underflow(record: Record, whole: float) -> float:
    """A bound below UNDERFLOW, where s**-3 times the least number is not negligible.

    One window for each s down to VANISHING, and there the absolute error.
    """
    definition = record["definition"]
    tier = record["tier"]
    if len(definition) > 1 or TIERS[tier].bits == 24:
        return 0.0  # quotients do not underflow, nor does double precision for the least float32
    near = patch(definition, specialise(record, 0.0, SMALL), SEGMENTS[0], 0.0, SMALL)

    def bound(s: float, lower: float, upper: float) -> float:
        """On alpha = s xi, xi in [lower, upper]."""
        distance, last, smallest = near.window(s, s).error(lower, upper)
        least = TINY / s / s / s
        if tier == "best":
            return in_units(tier, distance, last, smallest, least)
        return (distance + last) / (whole * smallest + least) * UP

    s = VANISHING
    worst = bound(s, 0.0, 1.0)
    while s < UNDERFLOW:
        s *= 2
        worst = max(worst, *(bound(s, i / 32, (i + 1) / 32) for i in range(16, 32)))
    return worst


def error(record: Record, part: Patch, lower: float, upper: float) -> float:
    """A bound on the error on one box, in the unit of its tier; infinite if the box is too wide."""
    try:
        bound = in_units(record["tier"], *part.error(lower, upper))
    except Unbounded:
        return math.inf
    if record["tier"] == "float32" and upper == TOP:
        # The pi/2 of float32 lies above pi/2: it is clipped to TOP and stands for pi/2.
        with working(BITS):
            exact = truth.value(record["definition"], arb(TOP))
            clipped = exact / truth.limit(record["definition"]) - 1
            bound += float(clipped.abs_upper()) * 2.0**24 * UP
    return bound


def by_claim(record: Record) -> dict[str, list[Patch]]:
    """The patches that each claim is about: beyond pi/4, and up to it."""
    claims: dict[str, list[Patch]] = {"bound": [], "bound_to_quarter_pi": []}
    for part in patches(record):
        below = part.top or part.upper <= QUARTER
        claims["bound_to_quarter_pi" if below else "bound"].append(part)
    return claims


class Box(NamedTuple):
    """A box of a patch, by its number; ordered by its bound, the greatest first."""

    minus_bound: float
    number: int
    lower: float
    upper: float


def halve(
    record: Record, parts: list[Patch], wanted: float = 0.0, halvings: float = math.inf
) -> tuple[float, list[tuple[float, float]]]:
    """What can be proved on these patches, and where they are worst: at most 16 boxes of alpha, the worst first.

    The worst box is halved, again and again, until the bound is within ``wanted``, or so often, or as long as the box
    is more than next to nothing.
    """

    def box(number: int, lower: float, upper: float) -> Box:
        return Box(-error(record, parts[number], lower, upper), number, lower, upper)

    boxes = [box(number, part.lower, part.upper) for number, part in enumerate(parts)]
    heapq.heapify(boxes)
    while boxes and -boxes[0].minus_bound > wanted and halvings > 0:
        _, number, lower, upper = boxes[0]
        middle = (lower + upper) / 2
        narrow = halvings == math.inf and upper - lower < 2.0**-24 * (TOP - middle + 2.0**-53)
        if narrow or not lower < middle < upper:
            break
        heapq.heapreplace(boxes, box(number, lower, middle))
        heapq.heappush(boxes, box(number, middle, upper))
        halvings -= 1
    bound = max((-x.minus_bound for x in boxes), default=0.0)
    return bound, [_in_alpha(parts[x.number], x) for x in _worst_of_each(boxes)]


def _worst_of_each(boxes: list[Box]) -> list[Box]:
    """The worst box of each patch; of these the 16 worst."""
    by_patch = {box.number: box for box in sorted(boxes, reverse=True)}
    return heapq.nsmallest(16, by_patch.values())


def _in_alpha(part: Patch, box: Box) -> tuple[float, float]:
    """A box of alpha; of a window, which stands for every power of two, near 2**-10."""
    scale = 2.0**-10 if part.top else 1.0
    return box.lower * scale, box.upper * scale


def prove(record: Record) -> float:
    """Prove what the record claims, on the whole domain; the bound that was proved, which is not above the claimed one.

    ``bound`` is claimed from UNDERFLOW on, ``bound_to_quarter_pi`` up to pi/4 only, ``bound_underflow`` below. Of the
    tiers best and float32 they are in ulp of the exact value, and the ulp is never less than the format's least number;
    of 1e-10 and 1e-6 relative, and below UNDERFLOW in units of (bound times the exact value + 2**-1074). Raises
    `ProofError` with the name of a check: digest, assumptions, program, zero, bound, underflow or goal.
    """
    if record["sha256"] != digest(record):
        raise rejected("digest", record, digest(record), record["sha256"])
    if record["assumptions"] != assumptions(record):
        raise rejected("assumptions", record, record["assumptions"], assumptions(record))
    try:
        _check_program(record)
        proved = max(_prove_claim(record, claim, parts) for claim, parts in by_claim(record).items())
        underflow = below_underflow(record, record["bound"])
        if not underflow <= record["bound_underflow"]:
            raise rejected("underflow", record, f"{underflow:.4g}", f"at most {record['bound_underflow']}")
        check_goals(record)
        return proved
    except Unbounded as fault:
        raise rejected("bound", record, f"none, {fault}", record["bound"]) from fault
    except (ArithmeticError, LookupError, TypeError, ValueError) as fault:
        raise rejected("program", record, f"{type(fault).__name__}: {fault}", "operations with a meaning") from fault


def _check_program(record: Record) -> None:
    """That its tier is known, that operations use earlier ones only, and that a base quantity is 0 at 0."""
    if record["tier"] not in TIERS:
        raise ValueError(f"no tier is called {record['tier']}")
    for i, (_, args, _) in enumerate(record["operations"]):
        if any(not 0 <= a < i for a in args):
            raise ValueError("an operation uses a later one")
    with working(ROUNDING_BITS):
        values, _ = rounding.forward(specialise(record, 0.0, 0.0), arb(0))
    if len(record["definition"]) == 1 and not values[-1] == 0:  # of a quotient 0 is inside the domain like any other
        raise rejected("zero", record, f"{values[-1]} at alpha = 0", 0)


def _prove_claim(record: Record, claim: str, parts: list[Patch]) -> float:
    claimed = min(record["bound"], record[claim])
    bound, boxes = halve(record, parts, claimed)
    if not bound <= claimed:
        raise rejected("bound", record, f"{bound:.4g}, alpha near {boxes[0][0]!r}", f"at most {claimed}")
    return bound


def checked(record: Record) -> tuple[str, bool]:
    """The outcome of a record's proof, and in how many seconds, as a line; whether it is accepted."""
    start = time.perf_counter()
    name = f"{record['kernel']:<32} {record['tier']:<8} {record['form']:<6}"
    try:
        proved = prove(record)
    except ProofError as refusal:
        return f"{name} REJECTED: {refusal}", False
    numbers = f"{proved:>9.4g} {record['bound']:>9.3g} {record['bound_to_quarter_pi']:>9.3g}"
    unit = TIERS[record["tier"]].unit
    return f"{name} {numbers}  {unit:<14} {time.perf_counter() - start:>7.2f}", True


def prove_all() -> bool:
    """Prove every certificate and print a table; true if none is rejected."""
    records = read()
    start = time.perf_counter()
    accepted = bool(records)
    print(f"{'kernel':<32} {'tier':<8} {'form':<6} {'proved':>9} {'claimed':>9} {'to pi/4':>9}  unit           seconds")
    with ProcessPoolExecutor(2) as pool:
        for line, proved in pool.map(checked, records):
            print(line, flush=True)
            accepted &= proved
    outcome = "all proved" if accepted else "NOT all proved"
    print(f"{len(records)} certificates, {outcome}, {time.perf_counter() - start:.1f} s with 2 processes")
    return accepted
