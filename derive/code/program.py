"""Intermediate program: a straight-line list of operations, built from SymPy and read by every emitter.

An operation refers to its operands by index. Constants are the doubles nearest to the exact numbers. The order of
operations follows from the expression alone, never from a hash.
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from typing import Any, TypeVar

import mpmath
import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from sympy import Add, Basic, Expr, Function, Integer, Mul, N, Symbol, default_sort_key

from derive.algebra.remainders import Exp, Horner, Select, SineRest
from derive.code.operations import OPERATIONS
from derive.kinds import Coefficients, Names

_NAMES = {operation.meaning: name for name, operation in OPERATIONS.items()}
_SYMBOLS = {operation.symbol: name for name, operation in OPERATIONS.items()} | {Exp: "exp"}


@dataclass(frozen=True, slots=True)
class Op:
    """Operation of `OPERATIONS`, input or constant, with the indices of its operands.

    ``value`` is the name of an input, a constant, or the coefficients of a polynomial, lowest first.
    """

    kind: str
    args: tuple[int, ...] = ()
    value: str | float | Coefficients | None = None


@dataclass(frozen=True)
class Program:
    """Straight-line program with a name and one or several outputs."""

    name: str
    inputs: Names
    ops: tuple[Op, ...]
    outputs: tuple[int, ...]

    def operations(self) -> Counter[str]:
        """Return the number of operations of each kind, without inputs and constants."""
        return Counter(op.kind for op in self.ops if op.kind not in ("input", "const"))

    def run(self, *args: Any) -> Any:
        """Return the first output for arrays of inputs, with each operation rounded once to float64.

        The result is the same on every machine, except for NumPy library functions such as the logarithm.
        """

        def make(op: Op, operands: list[Any]) -> Any:
            if op.kind == "const":
                return np.float64(op.value)  # type: ignore[arg-type]
            coefficients = () if op.value is None else (op.value,)
            return OPERATIONS[op.kind].meaning(*operands, *coefficients)

        with np.errstate(under="ignore"):
            result, *_ = walk(self, dict(zip(self.inputs, map(np.float64, args), strict=True)), make)
        return result


T = TypeVar("T")


def walk(p: Program, inputs: Mapping[str, T], make: Callable[[Op, list[T]], T]) -> list[T]:
    """Return the outputs of a program for inputs by name; ``make`` computes a value from operation and operands."""
    values: list[T] = []
    for op in p.ops:
        if op.kind == "input":
            values.append(inputs[str(op.value)])
        else:
            values.append(make(op, [values[i] for i in op.args]))
    return [values[i] for i in p.outputs]


class Builder:
    """Collector of operations on `Value`, in which equal operations are merged."""

    def __init__(self) -> None:
        self.ops: list[Op] = []
        self.index: dict[Op, int] = {}

    def put(self, kind: str, *operands: Any, value: str | float | Coefficients | None = None) -> "Value":
        """Return the value of an operation on values and numbers, appended unless it exists; ``value`` as in `Op`."""
        args = tuple(self.value(x).place for x in operands)
        key = Op(kind, args, repr(value))  # -0.0 is a key, too
        if key not in self.index:
            self.index[key] = len(self.ops)
            self.ops.append(Op(kind, args, value))
        return Value(self, self.index[key])

    def value(self, x: Any) -> "Value":
        """Return a value. A number becomes a constant."""
        if isinstance(x, Value):
            return x
        return self.put("const", value=float(x))

    def polynomial(self, x: "Value", coefficients: Coefficients, fused: bool) -> "Value":
        """Return the value of a polynomial, lowest coefficient first, by Horner's scheme of simpler operations."""
        *others, last = coefficients
        result = self.value(last)
        for c in map(self.value, reversed(others)):
            result = self.put("fma", result, x, c) if fused else result * x + c
        return result

    def inline(self, p: Program, inputs: Mapping[str, "Value"]) -> list["Value"]:
        """Append the operations of a program and return its outputs; ``inputs`` are values by their names."""
        return walk(p, inputs, lambda op, operands: self.put(op.kind, *operands, value=op.value))


@dataclass(frozen=True, eq=False)
class Value(NDArrayOperatorsMixin):
    """Result of an operation. Python operators and NumPy functions of it append further operations."""

    builder: Builder
    place: int

    def __array_ufunc__(self, function: Any, _: str, *operands: Any) -> "Value":
        """Return the value of a ufunc's operation."""
        if function is np.greater:  # Python turns 1.0 < x around
            function = np.less
            operands = operands[::-1]
        return self.builder.put(_NAMES[function], *operands)

    def __array_function__(self, function: Any, _: Any, operands: Any, named: Any) -> "Value":
        """Return the value of an operation that is not a ufunc, such as `numpy.where`."""
        return self.builder.put(_NAMES[function], *operands)


def _nearest(number: Expr) -> float:
    """Return the double nearest to an exact number."""
    if number.is_Rational:
        return int(number.p) / int(number.q)  # correctly rounded by Python
    with mpmath.workprec(300):
        return float(mpmath.mpf(N(number, 80)._mpf_))


class _Lowering(Builder):
    """Conversion of SymPy expressions to operations."""

    def __init__(self, inputs: Names) -> None:
        super().__init__()
        self.inputs = inputs
        self.done: dict[Basic, Value] = {Symbol(x, real=True): self.put("input", value=x) for x in inputs}

    def add(self, expression: Basic) -> Value:
        """Return the value of an expression, computed once."""
        if expression not in self.done:
            self.done[expression] = self._add(expression)
        return self.done[expression]

    def _add(self, e: Basic) -> Value:
        """Return the value of an expression after appending its operations."""
        if e.is_Symbol:
            raise ValueError(f"{e.name} is not an input of the program; its inputs are {', '.join(self.inputs)}")
        if e.is_number and not e.has(Function):
            return self.value(_nearest(e))
        if isinstance(e, SineRest):
            return self.add(e.lower())
        if isinstance(e, Horner):
            argument, *coefficients = e.args
            return self.put("horner", self.add(argument), value=tuple(map(_nearest, coefficients)))
        if e.is_Add:
            return self._sum(e)
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e.base, e.exp)
        if isinstance(e, Select):
            smaller, larger, *chosen = map(self.add, e.args)
            return self.put("select", smaller < larger, *chosen)
        if kind := _SYMBOLS.get(type(e)):
            first, *others = [self.add(x) for x in sorted(e.args, key=default_sort_key)]
            return reduce(partial(self.put, kind), others, first) if others else self.put(kind, first)
        raise ValueError(f"no operation for {type(e).__name__}: {e}")

    def _sum(self, e: Add) -> Value:
        """Return the value of a sum, with subtracted terms last."""
        plus = []
        minus = []
        for x in sorted(e.args, key=default_sort_key):
            if x.could_extract_minus_sign():
                minus.append(-x)
            else:
                plus.append(x)
        result = self.add(plus.pop(0)) if plus else -self.add(minus.pop(0))
        for x in plus:
            result = result + self.add(x)
        for x in minus:
            result = result - self.add(x)
        return result

    def _product(self, e: Mul) -> Value:
        """Return the value of a product: numerator over denominator, then powers of symbols one factor at a time."""
        if e.could_extract_minus_sign():
            return -self.add(-e)
        over = []
        under = []
        powers = []
        for x in sorted(e.args, key=default_sort_key):
            base, exponent = x.as_base_exp()
            if x.is_Rational and x.p == 1 and x.q & (x.q - 1):
                under.append(Integer(x.q))  # a third is a division by 3, with one rounding
            elif x.is_Pow and x.exp.could_extract_minus_sign():
                under.append(1 / x)
            elif base.is_Symbol and exponent.is_Integer:
                powers += [base] * int(exponent)
            else:
                over.append(x)
        # Powers of an input come last, one factor at a time, so that a result underflows once or not at all.
        if not over:
            over = [powers.pop(0) if powers else Integer(1)]
        result = self._joined("mul", over)
        if under:
            result = result / self._joined("mul", under)
        for x in powers:
            result = result * self.add(x)
        return result

    def _joined(self, kind: str, parts: Sequence[Expr]) -> Value:
        """Return all parts combined by one operation, of this kind, from the left."""
        return reduce(partial(self.put, kind), [self.add(x) for x in parts])

    def _power(self, base: Expr, exponent: Expr) -> Value:
        """Return a power with half an integer as exponent, by squaring, since `pow` is a slow library call."""
        if exponent.could_extract_minus_sign():
            return self.value(1.0) / self.add(base**-exponent)
        if not (2 * exponent).is_Integer:
            raise ValueError(f"no operation for the power {base}**{exponent}")
        n, half = divmod(int(2 * exponent), 2)
        if half:
            root = self.put("sqrt", self.add(base))
            return self.add(base**n) * root if n else root
        square = self.add(base)
        while not n & 1:
            n >>= 1
            square = square * square
        result = square
        while n := n >> 1:
            square = square * square
            if n & 1:
                result = result * square
        return result


def program(name: str, inputs: Names, *outputs: Expr, let: Mapping[Symbol, Expr] | None = None) -> Program:
    """Return the program of SymPy expressions in the symbols named by ``inputs``, in the order of its arguments.

    Equal subexpressions are computed once. ``let`` contains intermediate values by
    symbol, in order, which may replace an input of the same name.
    """
    low = _Lowering(inputs)
    for symbol, value in (let or {}).items():
        result = low.add(value)
        low.done = {e: v for e, v in low.done.items() if not e.has(symbol)}
        low.done[symbol] = result
    # Parts of a `let` may be unused.
    results = tuple(low.add(e).place for e in outputs)
    return without_dead(Program(name, inputs, tuple(low.ops), results))


def without_dead(p: Program) -> Program:
    """Return the program without operations that no output needs."""
    needed = set(p.outputs)
    for index in range(len(p.ops) - 1, -1, -1):
        if index in needed:
            needed.update(p.ops[index].args)
    place = {index: new for new, index in enumerate(sorted(needed))}
    ops = []
    for index in place:
        op = p.ops[index]
        ops.append(replace(op, args=tuple(place[i] for i in op.args)))
    return replace(p, ops=tuple(ops), outputs=tuple(place[i] for i in p.outputs))


def flat(p: Program) -> Program:
    """Return the program with each polynomial as its multiplications and additions, or fused multiply-adds."""
    code = Builder()

    def make(op: Op, operands: list[Value]) -> Value:
        if not isinstance(op.value, tuple):
            return code.put(op.kind, *operands, value=op.value)
        (x,) = operands
        return code.polynomial(x, op.value, op.kind == "fused_horner")

    outputs = walk(p, {x: code.put("input", value=x) for x in p.inputs}, make)
    return replace(p, ops=tuple(code.ops), outputs=tuple(x.place for x in outputs))
