"""Program on a box of alpha: comparisons decided, exact steps and compensations recognised, rounding bounded.

Part of the checker (`certify`): standard library and python-flint only. Ranges of computed values are balls. The bound
on a rounding error is half an ulp of the largest value in the range. The derivatives of the result with respect to
every rounding error are computed backwards over these ranges.
"""

import math
import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from derive.check.records import LOG_ULPS, Record
from derive.check.truth import Balls, as_ball, ball, fraction, working
from derive.kinds import Pair

ROUNDING_BITS = 80  # precision of the balls
# more than all roundings of the float arithmetic done on bounds
UP = 1 + 2.0**-40
DOWN = 1 - 2.0**-40
TINY = 2.0**-1074
PRODUCTS = ("mul", "div", "fma", "error", "log")  # operations that may underflow; small sums are exact


class Unbounded(Exception):
    """Missing finite bound on a box, or a comparison or an exponent that varies within it."""


class Node(NamedTuple):
    """Operation on a tape, of a kind of the program or of one of the following kinds.

    ``x`` is alpha. ``error`` with one argument is the rounding error of that product times ``value``. With two
    arguments it is the rounding error of the second times ``value``, minus the rounding error of the first. ``scale``
    multiplies by a number between 0 and ``value``. An operation that is always exact does not round. An exact product
    may still underflow by less than ``floor``.
    """

    kind: str
    args: tuple[int, ...] = ()
    value: float = 0.0
    rounds: bool = False
    floor: float = TINY


Tape = tuple[Node, ...]
Line = tuple[Fraction, Fraction]  # values of an affine function of alpha at both ends of the box

# Result of each operation on balls or series, and its derivatives with respect to the operands, with None for 1, from
# its value and the operands.
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


def above(x: arb) -> float:
    """Return an upper bound on the absolute value."""
    return float(x.abs_upper()) * UP


def below(x: arb) -> float:
    """Return a lower bound on the absolute value."""
    return float(x.abs_lower()) * DOWN


def _operate(node: Node, values: Sequence[arb], noise: Sequence[float]) -> Any:
    """Return the range of the exact result of an operation on ranges. The range of an error term is its bound."""
    if node.kind == "const":
        return arb(node.value)
    if node.kind == "error":
        return arb(0, sum(noise[a] for a in node.args) * UP)
    operands = [values[a] for a in node.args]
    if node.kind == "scale":
        return operands[0] * ball(0.0, node.value)
    return VALUE[node.kind](*operands)


def _rounding(node: Node, exact: arb, values: Sequence[arb]) -> float:
    """Return a bound on the rounding error of an operation with this range, in round-to-nearest."""
    if exact == 0:
        return 0.0
    if not node.rounds:
        return node.floor if node.kind in PRODUCTS else 0.0
    largest = above(exact) + TINY
    if not largest < 2.0**900:
        raise Unbounded(f"{node.kind} is unbounded")
    if node.kind in ("add", "sub"):
        # Doubles not below 2**(k - 1) are multiples of 2**(k - 53), and so is their sum: a double, if at most 2**k.
        smaller = min(below(values[i]) for i in node.args)
        _, k = math.frexp(smaller)
        if smaller > 0 and largest <= math.ldexp(1.0, k):
            return 0.0
    _, k = math.frexp(largest)
    half = math.ldexp(1.0, k - 54)
    if node.kind == "log":
        half *= 2 * LOG_ULPS
    return (half + node.floor) * UP


def forward(tape: Tape, x: arb) -> tuple[Balls, list[float]]:
    """Return ranges of all computed values for alpha in x, and bounds on their rounding errors."""
    values: Balls = []
    noise: list[float] = []
    for node in tape:
        _append(node, x if node.kind == "x" else _operate(node, values, noise), values, noise)
    return values, noise


def _append(node: Node, exact: arb, values: Balls, noise: list[float]) -> None:
    bound = _rounding(node, exact, values)
    values.append(exact + arb(0, bound) if bound else exact)
    noise.append(bound)


def rounding_sum(tape: Tape, x: arb) -> Pair:
    """Return bounds on the effect of all roundings but the last on the result, and on the last rounding."""
    values, noise = forward(tape, x)
    last = len(tape) - 1
    total = 0.0
    adjoint = [arb(0)] * last + [arb(1)]
    weight = [arb(0)] * len(tape)  # of the rounding error of a node, by the error terms that compute it
    for i in range(last, -1, -1):
        kind, args, value, _, _ = tape[i]
        slope = adjoint[i]
        if i != last and kind not in ("x", "const"):
            total += (above(slope + weight[i]) + TINY) * noise[i]
        if slope == 0:
            continue
        if kind == "error":
            for a, term in zip(args, (-slope, slope * value)[-len(args) :], strict=True):
                weight[a] += term
        elif kind == "scale":
            adjoint[args[0]] += slope * ball(0.0, value)
        elif kind in SLOPES:
            slopes = SLOPES[kind](values[i], *[values[a] for a in args])
            for a, of_operand in zip(args, slopes, strict=True):
                adjoint[a] += slope if of_operand is None else slope * of_operand
    return total * UP + 2.0**-1000, noise[last]  # 2**-1000: more than what underflowed in this sum


class _Specialise:
    """Builder of the tape of a program on [lower, upper], which decides comparisons and finds exact operations.

    For exact affine functions of alpha both ends of the range are known exactly. Other nodes have the ball of
    `forward`. ``grid`` is k if all values are known to be multiples of 2**k.
    """

    def __init__(self, record: Record, lower: float, upper: float) -> None:
        self.operations = record["operations"]
        self.ends = Fraction(lower), Fraction(upper)
        self.tape: list[Node] = []
        self.values: Balls = []
        self.noise: list[float] = []
        self.affine: list[Line | None] = []
        self.grid: list[int] = []
        self.done: dict[int, int] = {}

    def run(self, output: int) -> Tape:
        """Return the tape of the operations that contribute to the output, which is last."""
        last = self.visit(output)
        if self.tape[last].kind == "log":
            raise ValueError("the last operation must be one that is rounded correctly")
        alive = {last}
        for i in range(last, -1, -1):
            if i in alive:
                alive.update(self.tape[i].args)
        place = {old: new for new, old in enumerate(sorted(alive))}
        nodes = [self.tape[i] for i in place]
        return tuple(node._replace(args=tuple(place[a] for a in node.args)) for node in nodes)

    def visit(self, i: int) -> int:
        if i not in self.done:
            self.done[i] = self._visit(*self.operations[i])
        return self.done[i]

    def _visit(self, kind: str, args: Sequence[int], value: Any) -> int:
        """Append an operation and return its position on the tape."""
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
        if kind == "call":
            kind = str(value)
        if kind == "exponent":
            return self.put(Node("const", (), float(self.exponent(nodes[0]))))
        if kind == "significand":
            scale = self.put(Node("const", (), 2.0 ** -self.exponent(nodes[0])))
            return self.put(Node("mul", (nodes[0], scale)))
        if kind not in VALUE:
            raise ValueError(f"no rule for the operation {kind}")
        node = Node(kind, nodes)
        return self.put(self.compensation(node) or node)

    def less(self, i: int, j: int) -> bool:
        """Return whether one node is below another on the whole range, or raise `Unbounded` if it varies."""
        low, high = self.range(i)
        other_low, other_high = self.range(j)
        if high < other_low:
            return True
        if low < other_high:
            raise Unbounded("a comparison is undecided")
        return False

    def range(self, i: int) -> tuple[Fraction, Fraction]:
        """Return bounds on all values of a node."""
        line = self.affine[i]
        if line is not None:
            return min(line), max(line)
        values = self.values[i]
        if not values.is_finite():
            raise Unbounded("a comparison with an unbounded number")
        return fraction(values.lower()), fraction(values.upper())

    def exponent(self, i: int) -> int:
        """Return the k with 3/4 <= value 2**-k < 3/2 on the whole range."""
        low, high = self.range(i)
        k = 0
        if low >= Fraction(1, 2**1022):
            _, k = math.frexp(float(low))
        k -= low * Fraction(2) ** -k < Fraction(3, 4)
        scale = Fraction(2) ** -k
        if not Fraction(3, 4) <= low * scale <= high * scale < Fraction(3, 2):
            raise Unbounded("an exponent is undecided")
        return k

    def put(self, node: Node) -> int:
        """Append a node, marked if it is exact, and return its position."""
        line, grid, exact = self._shape(node)
        rounds = not exact and node.kind not in ("x", "const", "neg")
        node = node._replace(rounds=rounds)
        if line is not None and not rounds:
            self.values.append(ball(as_ball(min(line)), as_ball(max(line))))
            self.noise.append(0.0)
        else:
            line = None
            _append(node, _operate(node, self.values, self.noise), self.values, self.noise)
        self.tape.append(node)
        self.affine.append(line)
        self.grid.append(max(grid, -1074))
        return len(self.tape) - 1

    def _shape(self, node: Node) -> tuple[Line | None, int, bool]:
        """Return an affine form, a grid of the exact result, and whether it is always a double."""
        kind = node.kind
        if kind == "x":
            lower = float(self.ends[0])
            return self.ends, math.frexp(lower)[1] - 53 if lower else -1074, True
        if kind == "const":
            c = Fraction(node.value)
            return (c, c), _grid(c), True
        if kind == "error":
            return None, -1074, len(node.args) == 1  # the error of a product is a double, that of an fma is not
        if kind not in ("neg", "add", "sub", "mul", "fma"):
            return None, -1074, False
        grids = [self.grid[a] for a in node.args]
        if kind in ("mul", "fma"):
            first, second, *others = grids
            grids = [first + second, *others]
        grid = min(grids)
        line = self._line(node)
        size: Fraction | float
        if line:
            size = max(map(abs, line))
        else:
            size = above(_operate(node, self.values, self.noise))
        exact = kind == "neg" or (grid >= -1074 and size <= Fraction(2) ** (grid + 53))
        return line if grid >= -1074 else None, grid, exact

    def _line(self, node: Node) -> Line | None:
        """Return the result at both ends if all operands are affine. One of two factors must be constant."""
        lines = []
        for a in node.args:
            if (line := self.affine[a]) is None:
                return None
            lines.append(line)
        if node.kind in ("mul", "fma") and all(a != b for a, b in lines[:2]):
            return None
        first, second = (VALUE[node.kind](*ends) for ends in zip(*lines, strict=True))
        return first, second

    def compensation(self, node: Node) -> Node | None:
        """Return the node as the rounding error of another operation, if it computes one, otherwise None."""
        if node.kind not in ("fma", "sub"):
            return None
        *factors, c = node.args
        inner = self.tape[c]
        if node.kind == "fma":
            a, b = factors
            if inner.kind == "neg":  # a b - p with p = a b rounded
                (p,) = inner.args
                product = self.tape[p]
                if product.kind == "mul" and sorted(product.args) == sorted(factors):
                    return Node("error", (p,), -1.0)
            if inner.kind == "sub":  # a b + (d - s) with s = d + a b: minus the error of s, rounded
                d, s = inner.args
                total = self.tape[s]
                if total.kind == "fma" and total.args in ((a, b, d), (b, a, d)):
                    return Node("error", (s, c), 1.0)
        elif inner.kind == "sub":  # b - (s - a) with s = a + b, the same
            (b,) = factors
            s, a = inner.args
            total = self.tape[s]
            if total.kind == "add" and total.args in ((a, b), (b, a)):
                return Node("error", (s, c), -1.0)
        return None


def _grid(c: Fraction) -> int:
    """Return the largest k for which c is a multiple of 2**k."""
    if c == 0:
        return 2000
    return (c.numerator & -c.numerator).bit_length() - c.denominator.bit_length()


def specialise(record: Record, lower: float, upper: float) -> Tape:
    """Return the tape of the program for alpha in [lower, upper]."""
    with working(ROUNDING_BITS):
        return _Specialise(record, lower, upper).run(record["output"])
