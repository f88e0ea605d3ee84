"""The checker: proves the error bound of a straight-line float64 program on the whole domain, rounding included.

It reads plain data (`generated/certificates/*.json`) and uses the standard library and python-flint only; of the
generator it knows nothing, and `derive.truth` has the exact functions. Per box of alpha,

    |computed - exact| <= |P - F| + sum_i sup |dP/dn_i| d_i + half an ulp,

where P is the program in real arithmetic (Taylor models), n_i the rounding error of operation i with its bound d_i, and
the derivatives are taken backwards through the program in ball arithmetic, over all alpha of the box and all errors
within their bounds (mean value theorem, so that nothing of higher order is dropped). Exact operations have no n_i, and
an operation that computes the rounding error of another one *is* that n_i, so compensation counts.
"""

import hashlib
import heapq
import json
import math
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series, fmpq

from derive import truth
from derive.truth import BITS, CUBE, QUOTIENTS, SEGMENTS, TERMS, TOP, Model, Segment, ball, working

Record = dict[str, Any]
FOLDER = Path(__file__).resolve().parent.parent / "generated" / "certificates"

ROUNDING_BITS = 80  # precision of the balls in the analysis of rounding
UP, DOWN = 1 + 2.0**-40, 1 - 2.0**-40  # more than all roundings of the float arithmetic done on bounds here
TINY = 2.0**-1074
SMALL = 2.0**-7  # below, alpha = 2**-k xi with xi in [1/2, 1]: one window stands for every k
UNDERFLOW = 2.0**-320  # below, products may underflow and the bound gets an absolute term
QUARTER = float.fromhex("0x1.921fb54442d18p-1")  # pi/4
LOG_ULPS = 4
ASSUMPTIONS = {"log": f"np.log within {LOG_ULPS} ulp"}
PRODUCTS = ("mul", "div", "fma", "error", "sqrt", "log")  # what may underflow; sums are exact there
MARGIN = 1.002  # between the bound that is found and the one that is claimed: keeps the number of boxes small


class Rejected(Exception):
    """A certificate that is refused, with the name of the check that refuses it."""

    def __init__(self, check: str, record: Record, why: str) -> None:
        super().__init__(f"{check}: {record['kernel']} {record['tier']} {record['form']}: {why}")
        self.check = check


class Undecided(Exception):
    """A comparison, or the exponent of a number, differs within the box."""


class Unbounded(Exception):
    """No finite bound on this box."""


# --- the program on a box: no comparisons left, exact steps and compensations recognised ---------------------------


class Node(NamedTuple):
    """One operation on a tape; ``value`` is a constant, a sign (error) or the largest factor (scale)."""

    kind: str
    args: tuple[int, ...] = ()
    value: float | None = None
    rounds: bool = False


Tape = tuple[Node, ...]


def _operate(node: Node, values: Sequence[arb], noise: Sequence[float]) -> arb:
    """Range of the exact result of one operation on ranges; that of an error term is its bound."""
    kind, args = node.kind, node.args
    if kind == "fma":
        return values[args[0]] * values[args[1]] + values[args[2]]
    if kind == "mul":
        return values[args[0]] * values[args[1]]
    if kind == "add":
        return values[args[0]] + values[args[1]]
    if kind == "sub":
        return values[args[0]] - values[args[1]]
    if kind == "const":
        return arb(node.value)
    if kind == "error":
        return arb(0, sum(noise[a] for a in args) * UP)
    if kind == "div":
        return values[args[0]] / values[args[1]]
    if kind == "neg":
        return -values[args[0]]
    if kind == "scale":
        return values[args[0]] * ball(0.0, node.value or 0.0)
    return values[args[0]].log() if kind == "log" else values[args[0]].sqrt()


def _rounding(node: Node, exact: arb, values: Sequence[arb]) -> float:
    """Bound on the rounding error of an operation with this range, in round-to-nearest."""
    if exact == 0:
        return 0.0
    if not node.rounds:
        return TINY if node.kind in PRODUCTS else 0.0
    largest = float(exact.abs_upper()) * UP + TINY
    if not largest < 2.0**900:
        raise Unbounded(f"{node.kind} is unbounded")
    if node.kind in ("add", "sub"):  # Sterbenz: a difference no larger than either operand is exact
        smaller = min(float(values[i].abs_lower()) for i in node.args) * DOWN
        if largest <= smaller:
            return 0.0
    half = math.ldexp(1.0, math.frexp(largest)[1] - 54)
    return ((half if node.kind != "log" else 2 * LOG_ULPS * half) + TINY) * UP


def _forward(tape: Tape, x: arb) -> tuple[list[arb], list[float]]:
    """Ranges of all computed values for alpha in x, and bounds on their rounding errors."""
    values: list[arb] = []
    noise: list[float] = []
    for node in tape:
        exact = x if node.kind == "x" else _operate(node, values, noise)
        bound = _rounding(node, exact, values)
        values.append(exact + arb(0, bound) if bound else exact)
        noise.append(bound)
    return values, noise


def _rounding_sum(tape: Tape, x: arb) -> tuple[float, float, float]:
    """For alpha in x: bounds on |rounded - exact| before the last rounding, on that one, and the weight of underflow.

    The weight of underflow is the sum of the derivatives by the errors of all products.
    """
    values, noise = _forward(tape, x)
    last = len(tape) - 1
    adjoint: list[Any] = [None] * len(tape)
    weight: list[Any] = [None] * len(tape)  # of the rounding error of a node, by the error terms that compute it
    adjoint[last] = arb(1)
    total = underflow = 0.0

    def more(i: int, w: arb) -> None:
        adjoint[i] = w if adjoint[i] is None else adjoint[i] + w

    for i in range(last, -1, -1):
        w, (kind, args, value, _) = adjoint[i], tape[i]
        if i != last and kind not in ("x", "const"):
            by = weight[i] if w is None else w if weight[i] is None else w + weight[i]
            if by is None:
                continue
            size = float(by.abs_upper()) * UP
            total += size * noise[i]
            if kind in PRODUCTS:
                underflow += size
        if w is None:
            continue
        if kind == "fma":
            more(args[0], w * values[args[1]])
            more(args[1], w * values[args[0]])
            more(args[2], w)
        elif kind == "mul":
            more(args[0], w * values[args[1]])
            more(args[1], w * values[args[0]])
        elif kind == "add":
            more(args[0], w)
            more(args[1], w)
        elif kind == "sub":
            more(args[0], w)
            more(args[1], -w)
        elif kind == "neg":
            more(args[0], -w)
        elif kind == "error":
            for a, term in zip(args, (w, -w) if value == 1.0 else (-w, w), strict=False):
                weight[a] = term if weight[a] is None else weight[a] + term
        elif kind == "div":
            more(args[0], w / values[args[1]])
            more(args[1], -w * values[i] / values[args[1]])
        elif kind == "scale":
            more(args[0], w * ball(0.0, value or 0.0))
        elif kind == "log":
            more(args[0], w / values[args[0]])
        elif kind == "sqrt":
            more(args[0], w / (2 * values[args[0]].sqrt()))
    return total * UP + 2.0**-1000, noise[last], underflow * UP


class _Specialise:
    """Makes the tape of a program on [lower, upper]: decides comparisons, finds what is exact and what compensates.

    Of a node that is an exact affine function of alpha, both ends of the range are known exactly; others have the ball
    of `_forward`. ``grid`` is k where all values are known to be multiples of 2**k.
    """

    def __init__(self, record: Record, lower: float, upper: float) -> None:
        self.operations = record["operations"]
        self.ends = Fraction(lower), Fraction(upper)
        self.tape: list[Node] = []
        self.values: list[arb] = []
        self.noise: list[float] = []
        self.affine: list[tuple[Fraction, Fraction] | None] = []
        self.grid: list[int] = []
        self.known: dict[Node, int] = {}
        self.done: dict[int, int] = {}

    def run(self, output: int) -> Tape:
        """The live operations only, the output last."""
        last = self.visit(output)
        alive = {last}
        for i in range(last, -1, -1):
            if i in alive:
                alive |= set(self.tape[i].args)
        place = {old: new for new, old in enumerate(sorted(alive))}
        return tuple(n._replace(args=tuple(place[a] for a in n.args)) for i, n in enumerate(self.tape) if i in alive)

    def visit(self, i: int) -> int:
        if i not in self.done:
            self.done[i] = self._visit(*self.operations[i])
        return self.done[i]

    def _visit(self, kind: str, args: Sequence[int], value: Any) -> int:
        if kind == "input":
            return self.put(Node("x"))
        if kind == "const":
            return self.put(Node("const", (), float.fromhex(value)))
        if kind == "select":
            return self.visit(args[1] if self.less(*self.operations[args[0]]) else args[2])
        nodes = tuple(self.visit(a) for a in args)
        if kind in ("min", "max"):
            (low, high), (other_low, other_high) = (self.range(n) for n in nodes)
            if high <= other_low:
                return nodes[0 if kind == "min" else 1]
            if other_high <= low:
                return nodes[1 if kind == "min" else 0]
            raise Undecided(kind)
        if kind == "call" and value in ("exponent", "significand"):
            k = self.exponent(nodes[0])
            if value == "exponent":
                return self.put(Node("const", (), float(k)))
            return self.put(Node("mul", (nodes[0], self.put(Node("const", (), 2.0**-k)))))
        node = Node(str(value) if kind == "call" else kind, nodes)
        if node.kind not in ("add", "sub", "mul", "div", "neg", "fma", "sqrt", "log"):
            raise ValueError(f"no rule for the operation {node.kind}")
        return self.put(self.compensation(node) or node)

    def less(self, kind: str, args: Sequence[int], _: Any) -> bool:
        if kind != "less":
            raise ValueError("select needs a comparison")
        (low, high), (other_low, other_high) = (self.range(self.visit(a)) for a in args)
        if high < other_low:
            return True
        if low >= other_high:
            return False
        raise Undecided(kind)

    def range(self, i: int) -> tuple[Fraction, Fraction]:
        """All values of a node lie between these."""
        if (line := self.affine[i]) is not None:
            first, second = (line[0] * x + line[1] for x in self.ends)
            return min(first, second), max(first, second)
        if not self.values[i].is_finite():
            raise Unbounded("a comparison with an unbounded number")
        return _fraction(self.values[i].lower()), _fraction(self.values[i].upper())

    def exponent(self, i: int) -> int:
        """The k with 3/4 <= value 2**-k < 3/2 on the whole range."""
        low, high = self.range(i)
        if low < Fraction(1, 2**1022):
            raise Undecided("exponent")
        k = math.frexp(float(low))[1]
        k -= low * Fraction(2) ** -k < Fraction(3, 4)
        if not Fraction(3, 4) <= low * Fraction(2) ** -k <= high * Fraction(2) ** -k < Fraction(3, 2):
            raise Undecided("exponent")
        return k

    def put(self, node: Node) -> int:
        """Append a node, or find the equal one; exact ones are marked."""
        if node in self.known:
            return self.known[node]
        line, grid, exact = self._shape(node)
        rounds = not exact and node.kind not in ("x", "const", "neg")
        marked = node._replace(rounds=rounds)
        if line is not None and not rounds:
            low, high = sorted(line[0] * x + line[1] for x in self.ends)
            value, bound = ball(_arb(low), _arb(high)), 0.0
        else:
            line, value = None, _operate(marked, self.values, self.noise)
            bound = _rounding(marked, value, self.values)
        self.tape.append(marked)
        self.affine.append(line)
        self.grid.append(max(grid, -1074))
        self.values.append(value + arb(0, bound) if bound else value)
        self.noise.append(bound)
        self.known[node] = len(self.tape) - 1
        return len(self.tape) - 1

    def _shape(self, node: Node) -> tuple[tuple[Fraction, Fraction] | None, int, bool]:
        """An affine form, a grid of the exact result, and whether that is always a double (exponents unbounded)."""
        kind, args = node.kind, node.args
        if kind == "x":
            grid = math.frexp(float(self.ends[0]))[1] - 53 if self.ends[0] else -1074
            return (Fraction(1), Fraction(0)), max(grid, -1074), True
        if kind == "const":
            c = Fraction(node.value or 0)
            return (Fraction(0), c), _trailing(c), True
        lines, grids = [self.affine[a] for a in args], [self.grid[a] for a in args]
        if kind == "neg":
            return lines[0] and (-lines[0][0], -lines[0][1]), grids[0], True
        if kind in ("add", "sub"):
            sign = 1 if kind == "add" else -1
            a, b = lines
            line = (a[0] + sign * b[0], a[1] + sign * b[1]) if a and b else None
            grid = min(grids)
            if line is not None:
                size = max(abs(line[0] * x + line[1]) for x in self.ends)
                return line, grid, size <= Fraction(2) ** (grid + 53)
            return None, grid, self._fits(node, grid)
        if kind == "mul":
            for a, other in (args, args[::-1]):
                if self.tape[a].kind == "const" and _power_of_two(self.tape[a].value or 0.0):
                    factor, line = Fraction(self.tape[a].value or 0), self.affine[other]
                    grid = self.grid[other] + _trailing(factor)
                    if line and grid >= -1074:
                        return (line[0] * factor, line[1] * factor), grid, True
                    return None, grid, True
            return None, sum(grids), self._fits(node, sum(grids))
        if kind == "fma":
            grid = min(grids[0] + grids[1], grids[2])
            return None, grid, self._fits(node, grid)
        if kind == "error":
            return None, -1074, len(args) != 2  # the error of a product is a double, that of an fma is not
        return None, -1074, False

    def _fits(self, node: Node, grid: int) -> bool:
        """Multiples of 2**grid up to 2**(grid + 53) are doubles."""
        size = float(_operate(node, self.values, self.noise).abs_upper()) * UP
        return grid >= -1074 and size <= 2.0 ** min(grid + 53, 1000)

    def compensation(self, node: Node) -> Node | None:
        """The node as the rounding error of another one, if that is what it computes."""
        kind, args = node.kind, node.args
        if kind == "fma":  # a b - p with p = a b rounded, or p - a b
            a, b, c = args
            if self.tape[c].kind == "neg" and self._is_product(p := self.tape[c].args[0], a, b):
                return Node("error", (p,), -1.0)
            for first, second in ((a, b), (b, a)):
                if self.tape[first].kind == "neg" and self._is_product(c, self.tape[first].args[0], second):
                    return Node("error", (c,), 1.0)
            if self.tape[c].kind == "sub":  # a b + (d - s) with s = d + a b rounded: minus the error of s, rounded
                d, s = self.tape[c].args
                if self.tape[s].kind == "fma" and self.tape[s].args[2] == d and sorted(self.tape[s].args[:2]) == sorted((a, b)):
                    return Node("error", (s, c), -1.0)
        return None

    def _is_product(self, p: int, *factors: int) -> bool:
        return self.tape[p].kind == "mul" and sorted(self.tape[p].args) == sorted(factors)


def _arb(x: Fraction) -> arb:
    return arb(fmpq(x.numerator, x.denominator))


def _fraction(x: arb) -> Fraction:
    mantissa, exponent = x.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _trailing(x: Fraction) -> int:
    """The largest k with x a multiple of 2**k."""
    if not x:
        return 2000
    return (x.numerator & -x.numerator).bit_length() - x.denominator.bit_length()


def _power_of_two(x: float) -> bool:
    return math.frexp(abs(x))[0] == 0.5


# --- the parts of the domain ---------------------------------------------------------------------------------------


def specialise(record: Record, lower: float, upper: float) -> Tape:
    """The tape of the program for alpha in [lower, upper]."""
    with working(ROUNDING_BITS):
        return _Specialise(record, lower, upper).run(record["output"])


def pieces(record: Record, lower: float, upper: float) -> list[tuple[float, float, Tape]]:
    """Parts of [lower, upper], both ends included, no double left out, each with one tape.

    Where to cut first is guessed from the constants, which matters for the time only: what is undecided is halved.
    """
    constants = [float.fromhex(v) for kind, _, v in record["operations"] if kind == "const"]
    guesses = {QUARTER, TOP, *constants, *(TOP - c for c in constants)}
    if any(v == "exponent" for _, _, v in record["operations"]):
        guesses |= {TOP - 0.75 * 2.0**-k for k in range(54)}
    inner = sorted(c for c in guesses if lower < c < upper)
    starts = sorted({lower, upper, *inner, *(math.nextafter(c, 9.0) for c in inner)})
    todo = [(a, math.nextafter(b, -9.0)) for a, b in zip(starts, starts[1:], strict=False)] + [(upper, upper)]
    found: list[tuple[float, float, Tape]] = []
    todo.reverse()
    while todo:
        a, b = todo.pop()
        try:
            tape = specialise(record, a, b)
        except (Undecided, Unbounded):
            if a == b:
                raise
            middle = min(a + (b - a) / 2, math.nextafter(b, -9.0))
            todo += [(math.nextafter(middle, 9.0), b), (a, middle)]
            continue
        if found and found[-1][2] == tape:
            found[-1] = (found[-1][0], b, tape)
        else:
            found.append((a, b, tape))
    return found


def _generic(tape: Tape) -> tuple[Tape, int]:
    """The tape over xi, alpha = 2**-k xi with 2**-k <= SMALL for every k at once, and the degree of its result.

    A value is 2**(-k degree) times the value on the new tape. Where degrees meet in a sum, the higher one gets an
    unknown factor between 0 and SMALL**(difference). Rounding scales with the values; underflow is treated apart.
    """
    new: list[Node] = []
    degrees: list[int] = []
    place: list[int] = []

    def put(node: Node, degree: int) -> int:
        new.append(node)
        degrees.append(degree)
        return len(new) - 1

    def lower(i: int, by: int) -> int:
        return put(Node("scale", (i,), SMALL**by), degrees[i] - by) if by else i

    for node in tape:
        args = [place[a] for a in node.args]
        degree = [degrees[a] for a in args]
        kind = node.kind
        if kind in ("add", "sub"):
            result = min(degree)
            args = [lower(a, d - result) for a, d in zip(args, degree, strict=True)]
        elif kind == "fma":
            result = min(degree[0] + degree[1], degree[2])
            args = [lower(args[0], degree[0] + degree[1] - result), args[1], lower(args[2], degree[2] - result)]
        elif kind in ("log", "sqrt"):
            raise Unbounded(f"{kind} near zero")
        else:
            result = {"x": 1, "const": 0, "mul": sum(degree)}.get(kind, degree[0] if degree else 0)
            result -= degree[1] if kind == "div" else 0
        place.append(put(node._replace(args=tuple(args)), result))
    return tuple(new), degrees[-1]


def _ideal(tape: Tape, centre: arb) -> list[arb]:
    """Taylor coefficients of the program in real arithmetic, for every point of the ball ``centre`` at once."""
    done: list[Any] = []
    for node in tape:
        v = [done[a] for a in node.args]
        match node.kind:
            case "x":
                done.append(arb_series([centre, 1]))
            case "const":
                done.append(arb_series([arb(node.value)]))
            case "error":
                done.append(arb_series([arb(0)]))
            case "fma":
                done.append(v[0] * v[1] + v[2])
            case "add":
                done.append(v[0] + v[1])
            case "sub":
                done.append(v[0] - v[1])
            case "mul":
                done.append(v[0] * v[1])
            case "div":
                done.append(v[0] / v[1])
            case "neg":
                done.append(-v[0])
            case "log":
                done.append(v[0].log())
            case "sqrt":
                done.append(v[0].sqrt())
            case kind:
                raise ValueError(f"no rule for the operation {kind}")
    return truth.coefficients(done[-1])


@dataclass(frozen=True)
class Patch:
    """A piece of the domain within a segment: what bounds the error on any box of it.

    ``difference`` is (P - F) times the denominator of F, a quotient, and divided by alpha**degree on the first segment.
    """

    tape: Tape
    segment: Segment
    lower: float
    upper: float
    difference: Model
    above: Model
    below: Model | None
    degree: int
    window: bool  # a box is one of xi, not of alpha

    def error(self, lower: float, upper: float) -> tuple[float, float, float]:
        """|before the last rounding - exact| and the last rounding's error at most, |exact| at least."""
        with working(ROUNDING_BITS):
            x = ball(lower, upper)
            total, last, _ = _rounding_sum(self.tape, x)
            t = (ball(0.0, SMALL) if self.window else x) - self.segment.centre
            factor = x * x * x if self.degree and self.segment.lower == 0 else arb(1)
            difference, exact = self.difference(t) * factor, self.above(t) * factor
            if self.below is not None:
                divisor = self.below(t)
                difference, exact = difference / divisor, exact / divisor
            distance = (float(difference.abs_upper()) * UP + total) * UP
            smallest = float(exact.abs_lower()) * DOWN
            if not (distance < math.inf and smallest > 0):
                raise Unbounded("the exact value is not told from zero on this box")
            return distance, last, smallest


def _patch(kernel: str, tape: Tape, segment: Segment, lower: float, upper: float) -> Patch:
    window = upper <= SMALL
    above, below = QUOTIENTS.get(kernel, (kernel, None))
    degree = 0 if below else CUBE
    first = truth.kernel(above, segment)
    second = truth.kernel(below, segment) if below else None
    with working(BITS):
        order = degree if segment.lower == 0 else 0
        fat = ball(min(lower, segment.centre), max(upper, segment.centre))
        own = truth.model(_ideal(tape, arb(segment.centre)), _ideal(tape, fat), order)
        if second is None:
            difference = Model(own.main - first.main, own.last - first.last, own.power)
        else:  # (P - F1/F2) F2
            t = fat - segment.centre
            rest = [m.last * arb(0, 1) * t.abs_upper() ** m.power for m in (own, first, second)]
            last = rest[0] * second(t) + own.main(t) * rest[2] - rest[1]
            difference = Model(own.main * second.main - first.main, last, 0)
    if window:
        tape, of_result = _generic(tape)
        if of_result != degree:
            raise Unbounded("near zero the program is not of the kernel's order")
        lower, upper = 0.5, 1.0
    return Patch(tape, segment, lower, upper, difference, first, second, degree, window)


# --- the proof -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Bounds:
    """Bounds on the error, in ulp of the exact value (best, float32) or relative to it (1e-10, 1e-6).

    ``quarter`` holds up to pi/4. Below alpha = UNDERFLOW, ``underflow`` times 2**-1074 comes on top.
    """

    whole: float
    quarter: float
    underflow: float


def _in_units(tier: str, distance: float, last: float, smallest: float) -> float:
    """The error on a box, in the units of the tier.

    |rounded - exact| is at most the distance before the last rounding plus half an ulp *of the exact value*, if that
    distance is at most one ulp: where the exact value lies below a power of two and the number to be rounded above it,
    the power of two is the nearest double.
    """
    if tier in ("1e-10", "1e-6"):
        return (distance + last) / smallest * UP
    if tier not in ("best", "float32"):
        raise ValueError(f"no tier is called {tier}")
    bits = 53
    if tier == "float32":  # computed in double precision, then rounded once more
        bits, distance = 24, distance + last
    mantissa, exponent = math.frexp(smallest)
    ulp = math.ldexp(1.0, exponent - bits - (mantissa == 0.5))
    if distance <= ulp:
        return (distance / ulp + 0.5) * UP
    return (distance + last) / ulp * UP if tier == "best" else math.inf


@dataclass(frozen=True)
class Domain:
    """All patches of a record, and what is proved apart from them."""

    record: Record
    patches: list[Patch]
    underflow: float  # in units of 2**-1074, for alpha < UNDERFLOW
    more: float  # what underflow adds at most to the error elsewhere, and the end of float32, in the tier's unit

    def error(self, patch: Patch, lower: float, upper: float) -> float:
        try:
            return _in_units(self.record["tier"], *patch.error(lower, upper)) + self.more
        except Unbounded:
            return math.inf

    def claims(self, patch: Patch) -> str:
        return "quarter" if patch.window or patch.upper <= QUARTER else "whole"


def domain(record: Record) -> Domain:
    """Everything that does not depend on the boxes."""
    kernel, tier = record["kernel"], record["tier"]
    tape = specialise(record, 0.0, SMALL)
    found = [_patch(kernel, tape, SEGMENTS[0], 0.0, SMALL)]
    with working(ROUNDING_BITS):
        small, tiny = (_rounding_sum(tape, ball(0.0, end))[2] / 2 for end in (SMALL, UNDERFLOW))
        if kernel in QUOTIENTS:
            found.append(replace(_patch(kernel, tape, SEGMENTS[0], 0.0, 0.0), window=False, lower=0.0, upper=0.0))
        elif not _forward(specialise(record, 0.0, 0.0), arb(0))[0][-1] == 0:
            raise Rejected("zero", record, "not 0 at alpha = 0")
        if kernel not in QUOTIENTS and not found[0].above(ball(0.0, SMALL)) > 0.5:
            raise ArithmeticError(f"{kernel}/alpha**3 is not above 1/2 near zero")
    # Above UNDERFLOW the exact value is at least 2**-961, its ulp 2**-1014, while underflow weighs small * 2**-1074.
    more = small * 2.0**-60 if tier in ("best", "float32") else small * 2.0**-113
    if tier == "float32":  # its pi/2 lies above pi/2, is clipped to TOP, and stands for pi/2 itself
        more += _end(kernel)
    for a, b, piece in pieces(record, SMALL, TOP):
        for segment in SEGMENTS:
            for start, end in ((SMALL, QUARTER), (QUARTER, TOP)):
                lower, upper = max(a, segment.lower, start), min(b, segment.upper, end)
                if lower < upper or lower == upper in (a, b):
                    found.append(_patch(kernel, piece, segment, lower, upper))
    return Domain(record, found, tiny * UP, more)


def _end(kernel: str) -> float:
    """|F(pi/2) - F(TOP)| in ulp of float32."""
    with working(BITS):
        half = arb.pi() / 2
        above, below = QUOTIENTS.get(kernel, (kernel, None))
        limit = truth.KERNELS[above](half, arb(1), arb(0), arb(0))
        limit = limit / truth.KERNELS[below](half, arb(1), arb(0), arb(0)) if below else limit
        return float((1 - truth.value(kernel, arb(TOP)) / limit).abs_upper()) * 2.0**24 * UP


def prove(record: Record) -> Bounds:
    """Prove what the record claims, on the whole domain.

    Returns
    -------
    Bounds
        The proved bounds, not above the claimed ones.

    Raises
    ------
    Rejected
        With the name of the check that failed: digest, assumptions, zero, underflow or bound.
    """
    if record["sha256"] != digest(record):
        raise Rejected("digest", record, "the operations are not those that were certified")
    if record["assumptions"] != assumptions(record):
        raise Rejected("assumptions", record, "they do not name what the program relies on")
    whole = domain(record)
    if whole.underflow > record["underflow"]:
        raise Rejected("underflow", record, f"{whole.underflow:.4g} is not within {record['underflow']}")
    proved = {"whole": 0.0, "quarter": 0.0}
    for patch in whole.patches:
        claim = whole.claims(patch)
        limit = record["bound"] if claim == "whole" else record["bound_to_quarter_pi"]
        todo = [(patch.lower, patch.upper)]
        while todo:
            lower, upper = todo.pop()
            error = whole.error(patch, lower, upper)
            if error <= limit:
                proved[claim] = max(proved[claim], error)
                continue
            middle = (lower + upper) / 2
            if not lower < middle < upper or upper - lower < 2.0**-24 * (TOP - middle + 2.0**-53):
                where = f"alpha near {lower!r}" + (" times any small 2**-k" if patch.window else "")
                raise Rejected("bound", record, f"error {error:.4g} is not within {limit}, {where}")
            todo += [(lower, middle), (middle, upper)]
    return Bounds(max(proved.values()), proved["quarter"], whole.underflow)


def establish(record: Record, boxes: int = 3000) -> Bounds:
    """Find bounds that can be proved: the worst box is halved again and again, within a number of boxes."""
    whole = domain(record)
    found = {}
    for claim in ("quarter", "whole"):
        heap = []
        for number, p in enumerate(whole.patches):
            if whole.claims(p) == claim:
                heap.append((-whole.error(p, p.lower, p.upper), number, p.lower, p.upper))
        heapq.heapify(heap)
        for _ in range(boxes // 2):
            error, number, lower, upper = heap[0]
            middle = (lower + upper) / 2
            if not lower < middle < upper:
                break
            halves = [(lower, middle), (middle, upper)]
            entries = [(-whole.error(whole.patches[number], a, b), number, a, b) for a, b in halves]
            heapq.heapreplace(heap, entries[0])
            heapq.heappush(heap, entries[1])
        found[claim] = -heap[0][0]
    return Bounds(max(found.values()), found["quarter"], whole.underflow)


def digest(record: Record) -> str:
    """sha256 of what is certified: kernel, tier, form, operations and output."""
    certified = [record[key] for key in ("kernel", "tier", "form", "operations", "output")]
    return hashlib.sha256(json.dumps(certified, separators=(",", ":")).encode()).hexdigest()


def assumptions(record: Record) -> list[str]:
    """What the proof takes for granted, from the calls that the program makes."""
    called = {value for kind, _, value in record["operations"] if kind == "call"}
    return [words for call, words in ASSUMPTIONS.items() if call in called]
