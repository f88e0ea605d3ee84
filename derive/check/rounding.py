"""A program on a box of alpha: no comparisons left, exact steps and compensations recognised, rounding bounded.

Part of the checker (`certify`): standard library and python-flint only. Ranges of computed values are balls, the
bound on a rounding error is half an ulp of the largest value in the range, and the derivatives of the result by every
rounding error are taken backwards over those ranges.
"""

import math
import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from derive.check.records import LOG_ULPS, Record
from derive.check.truth import ball, fraction, number, working

ROUNDING_BITS = 80  # precision of the balls
UP, DOWN = 1 + 2.0**-40, 1 - 2.0**-40  # more than all roundings of the float arithmetic done on bounds
TINY = 2.0**-1074
PRODUCTS = ("mul", "div", "fma", "error", "log")  # what may underflow; sums are exact there


class Unbounded(Exception):
    """No finite bound on this box, or a comparison or an exponent differs within it."""


class Node(NamedTuple):
    """One operation on a tape, in one of the kinds of a program or one of these.

    x is alpha; ``error``, with one argument, is the rounding error of that product times ``value``, with two, that of
    the second times ``value`` less that of the first; ``scale`` multiplies by something between 0 and ``value``. An
    operation that is always exact does not round; if it is a product, it may still underflow, by less than ``floor``.
    """

    kind: str
    args: tuple[int, ...] = ()
    value: float = 0.0
    rounds: bool = False
    floor: float = TINY


Tape = tuple[Node, ...]
Line = tuple[Fraction, Fraction]  # values of an affine function of alpha at both ends of the box


# What an operation computes, of balls or of series, and its derivatives by its operands, None for 1, from its value
# and these.
VALUE: dict[str, Callable[..., Any]] = {
    "fma": lambda a, b, c: a * b + c,
    "mul": operator.mul,
    "add": operator.add,
    "sub": operator.sub,
    "div": operator.truediv,
    "neg": operator.neg,
    "log": lambda a: a.log(),
}
SLOPES: dict[str, Callable[..., tuple[Any, ...]]] = {
    "fma": lambda y, a, b, c: (b, a, None),
    "mul": lambda y, a, b: (b, a),
    "add": lambda y, a, b: (None, None),
    "sub": lambda y, a, b: (None, -1),
    "div": lambda y, a, b: (1 / b, -y / b),
    "neg": lambda y, a: (-1,),
    "log": lambda y, a: (1 / a,),
}


def _operate(node: Node, values: Sequence[arb], noise: Sequence[float]) -> Any:
    """Range of the exact result of one operation on ranges; that of an error term is its bound."""
    if node.kind == "const":
        return arb(node.value)
    if node.kind == "error":
        return arb(0, sum(noise[a] for a in node.args) * UP)
    if node.kind == "scale":
        return values[node.args[0]] * ball(0.0, node.value)
    return VALUE[node.kind](*[values[a] for a in node.args])


def _rounding(node: Node, exact: arb, values: Sequence[arb]) -> float:
    """Bound on the rounding error of an operation with this range, in round-to-nearest."""
    if exact == 0:
        return 0.0
    if not node.rounds:
        return node.floor if node.kind in PRODUCTS else 0.0
    largest = float(exact.abs_upper()) * UP + TINY
    if not largest < 2.0**900:
        raise Unbounded(f"{node.kind} is unbounded")
    if node.kind in ("add", "sub"):
        # Doubles not below 2**(k - 1) are multiples of 2**(k - 53), and so is their sum: a double, if at most 2**k.
        smaller = min(float(values[i].abs_lower()) for i in node.args) * DOWN
        if smaller > 0 and largest <= math.ldexp(1.0, math.frexp(smaller)[1]):
            return 0.0
    half = math.ldexp(1.0, math.frexp(largest)[1] - 54)
    return ((half if node.kind != "log" else 2 * LOG_ULPS * half) + node.floor) * UP


def forward(tape: Tape, x: arb) -> tuple[list[arb], list[float]]:
    """Ranges of all computed values for alpha in x, and bounds on their rounding errors."""
    values: list[arb] = []
    noise: list[float] = []
    for node in tape:
        _append(node, x if node.kind == "x" else _operate(node, values, noise), values, noise)
    return values, noise


def _append(node: Node, exact: arb, values: list[arb], noise: list[float]) -> None:
    bound = _rounding(node, exact, values)
    values.append(exact + arb(0, bound) if bound else exact)
    noise.append(bound)


def rounding_sum(tape: Tape, x: arb) -> tuple[float, float]:
    """For alpha in x: bounds on what all roundings but the last one do to the result, and on the last one."""
    values, noise = forward(tape, x)
    last, total = len(tape) - 1, 0.0
    adjoint = [arb(0)] * last + [arb(1)]
    weight = [arb(0)] * len(tape)  # of the rounding error of a node, by the error terms that compute it
    for i in range(last, -1, -1):
        w, (kind, args, value, _, _) = adjoint[i], tape[i]
        if i != last and kind not in ("x", "const"):
            total += (float((w + weight[i]).abs_upper()) * UP + TINY) * noise[i]
        if w == 0:
            continue
        if kind == "error":
            for a, term in zip(args, (-w, w * value)[-len(args) :], strict=True):
                weight[a] += term
        elif kind == "scale":
            adjoint[args[0]] += w * ball(0.0, value)
        elif kind in SLOPES:
            for a, slope in zip(args, SLOPES[kind](values[i], *[values[a] for a in args]), strict=True):
                adjoint[a] += w if slope is None else w * slope
    return total * UP + 2.0**-1000, noise[last]  # 2**-1000: more than what underflowed in this sum


class _Specialise:
    """Makes the tape of a program on [lower, upper]: decides comparisons, finds what is exact and what compensates.

    Of a node that is an exact affine function of alpha, both ends of the range are known exactly; others have the ball
    of `forward`. ``grid`` is k where all values are known to be multiples of 2**k.
    """

    def __init__(self, record: Record, lower: float, upper: float) -> None:
        self.operations = record["operations"]
        self.ends = Fraction(lower), Fraction(upper)
        self.tape: list[Node] = []
        self.values: list[arb] = []
        self.noise: list[float] = []
        self.affine: list[Line | None] = []
        self.grid: list[int] = []
        self.done: dict[int, int] = {}

    def run(self, output: int) -> Tape:
        """The live operations only, the output last."""
        last = self.visit(output)
        if self.tape[last].kind == "log":
            raise ValueError("the last operation must be one that is rounded correctly")
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
            comparison, compared, _ = self.operations[args[0]]
            if comparison != "less":
                raise ValueError("select needs a comparison")
            return self.visit(args[1 if self.less(*map(self.visit, compared)) else 2])
        nodes = tuple(self.visit(a) for a in args)
        if kind == "max":
            return nodes[self.less(*nodes)]
        if kind == "call" and value in ("exponent", "significand"):
            k = self.exponent(nodes[0])
            if value == "exponent":
                return self.put(Node("const", (), float(k)))
            return self.put(Node("mul", (nodes[0], self.put(Node("const", (), 2.0**-k)))))
        node = Node(str(value) if kind == "call" else kind, nodes)
        if node.kind not in VALUE:
            raise ValueError(f"no rule for the operation {node.kind}")
        return self.put(self.compensation(node) or node)

    def less(self, i: int, j: int) -> bool:
        """Whether one node is below another on the whole range, or nowhere."""
        (low, high), (other_low, other_high) = self.range(i), self.range(j)
        if low < other_high and not high < other_low:
            raise Unbounded("a comparison is undecided")
        return high < other_low

    def range(self, i: int) -> tuple[Fraction, Fraction]:
        """All values of a node lie between these."""
        if (line := self.affine[i]) is not None:
            return min(line), max(line)
        if not self.values[i].is_finite():
            raise Unbounded("a comparison with an unbounded number")
        return fraction(self.values[i].lower()), fraction(self.values[i].upper())

    def exponent(self, i: int) -> int:
        """The k with 3/4 <= value 2**-k < 3/2 on the whole range."""
        low, high = self.range(i)
        k = math.frexp(float(low))[1] if low >= Fraction(1, 2**1022) else 0
        k -= low * Fraction(2) ** -k < Fraction(3, 4)
        if not Fraction(3, 4) <= low * Fraction(2) ** -k <= high * Fraction(2) ** -k < Fraction(3, 2):
            raise Unbounded("an exponent is undecided")
        return k

    def put(self, node: Node) -> int:
        """Append a node; exact ones are marked."""
        line, grid, exact = self._shape(node)
        marked = node._replace(rounds=not exact and node.kind not in ("x", "const", "neg"))
        if line is not None and not marked.rounds:
            self.values.append(ball(number(min(line)), number(max(line))))
            self.noise.append(0.0)
        else:
            line = None
            _append(marked, _operate(marked, self.values, self.noise), self.values, self.noise)
        self.tape.append(marked)
        self.affine.append(line)
        self.grid.append(max(grid, -1074))
        return len(self.tape) - 1

    def _shape(self, node: Node) -> tuple[Line | None, int, bool]:
        """An affine form, a grid of the exact result, and whether that is always a double (exponents unbounded)."""
        kind, args = node.kind, node.args
        if kind == "x":
            return self.ends, math.frexp(float(self.ends[0]))[1] - 53 if self.ends[0] else -1074, True
        if kind == "const":
            c = Fraction(node.value)
            # The largest k with c a multiple of 2**k.
            grid = (c.numerator & -c.numerator).bit_length() - c.denominator.bit_length() if c else 2000
            return (c, c), grid, True
        if kind == "error":
            return None, -1074, len(args) == 1  # the error of a product is a double, that of an fma is not
        if kind not in ("neg", "add", "sub", "mul", "fma"):
            return None, -1074, False
        grids, lines = [self.grid[a] for a in args], [self.affine[a] for a in args]
        grid = min([sum(grids[:2]), *grids[2:]]) if kind in ("mul", "fma") else min(grids)
        line, known = None, [x for x in lines if x]
        if len(known) == len(lines) and (kind not in ("mul", "fma") or any(a == b for a, b in known[:2])):
            first, second = (VALUE[kind](*ends) for ends in zip(*known, strict=True))
            line = first, second
        size = max(map(abs, line)) if line else float(_operate(node, self.values, self.noise).abs_upper()) * UP
        exact = kind == "neg" or (grid >= -1074 and size <= Fraction(2) ** (grid + 53))
        return line if grid >= -1074 else None, grid, exact

    def compensation(self, node: Node) -> Node | None:
        """The node as the rounding error of another one, if that is what it computes."""
        kind, args = node.kind, node.args
        if kind == "fma":
            a, b, c = args
            if self.tape[c].kind == "neg":  # a b - p with p = a b rounded
                (p,) = self.tape[c].args
                if self.tape[p].kind == "mul" and sorted(self.tape[p].args) == sorted((a, b)):
                    return Node("error", (p,), -1.0)
            if self.tape[c].kind == "sub":  # a b + (d - s) with s = d + a b: minus the error of s, rounded
                d, s = self.tape[c].args
                if self.tape[s].kind == "fma" and self.tape[s].args in ((a, b, d), (b, a, d)):
                    return Node("error", (s, c), 1.0)
        if kind == "sub" and self.tape[args[1]].kind == "sub":  # b - (s - a) with s = a + b, the same
            b, (s, a) = args[0], self.tape[args[1]].args
            if self.tape[s].kind == "add" and self.tape[s].args in ((a, b), (b, a)):
                return Node("error", (s, args[1]), -1.0)
        return None


def specialise(record: Record, lower: float, upper: float) -> Tape:
    """The tape of the program for alpha in [lower, upper]."""
    with working(ROUNDING_BITS):
        return _Specialise(record, lower, upper).run(record["output"])


def scaled(tape: Tape, degree: int, top: float, bottom: float) -> Tape:
    """The tape over xi in [1/2, 1], for alpha = s xi with any power of two s in [bottom, top] at once.

    Every value has a degree k, and is s**k times the value on the new tape; rounding scales with it, underflow is at
    most TINY/2 bottom**-k. Where degrees meet in a sum, or would exceed that of the result, factors s**j are taken as
    unknown between 0 and top**j.
    """
    new: list[Node] = []
    degrees: list[int] = []
    place: list[int] = []

    def put(node: Node, k: int) -> int:
        floor = TINY
        for _ in range(k):
            floor /= bottom  # in steps: bottom**-k overflows
        new.append(node._replace(floor=floor / 2 if k > 0 else TINY))
        degrees.append(k)
        return len(new) - 1

    def lower(i: int, by: int) -> int:
        return put(Node("scale", (i,), top**by), degrees[i] - by) if by else i

    for node in tape:
        args = [place[a] for a in node.args]
        k = [degrees[a] for a in args]
        match node.kind:
            case "x":
                result = 1
            case "const":
                result = 0 if node.value else degree
            case "neg" | "error" if len(set(k)) == 1:
                result = k[0]
            case "add" | "sub":
                result = min(k)
                args = [lower(a, d - result) for a, d in zip(args, k, strict=True)]
            case "mul" | "fma" | "div" as kind:
                whole = k[0] - k[1] if kind == "div" else k[0] + k[1]
                result = min(whole, degree, *k[2:])
                args = [lower(args[0], whole - result), args[1], *(lower(a, degrees[a] - result) for a in args[2:])]
            case kind:
                raise Unbounded(f"{kind} near zero")
        place.append(put(node._replace(args=tuple(args)), result))
    if degrees[-1] != degree:
        raise Unbounded("near zero the program is not of the order of the kernel")
    return tuple(new)
