"""Lowering of expressions to operations: on numbers at the start of a phase, and on series during it.

Every quantity consists of its base, a number at the start of the phase (and at rest), and its increment since then, a
series. Increments are built from increments, so that nothing cancels near a limit:

    d(a b) = a_0 db + b_0 da + da db,    d exp(a) = exp(a_0) expm1(da),    d(1/a) = (1/a_0) (1/(1 + da/a_0) - 1), ...
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any, NamedTuple

from sympy import Add, Expr, Float, Integer, Min, Mul, Rational, Symbol, Tuple, cos, exp, expand, log, sin, tanh

from derive.algebra.remainders import Exp, Select
from derive.check.proof import ProofError
from derive.code.program import Op, program, walk
from derive.declare.symbols import Forms
from derive.flow.recurrences import OPERATIONS, Q, evaluate
from derive.kinds import Names, Texts

# Increment: the coefficient of each product of registers, whose names are in order.
Increment = Mapping[tuple[str, ...], Expr]
Split = tuple[Expr, Increment]  # base and increment
Moving = Mapping[Symbol, Split]
Products = tuple[tuple[str, str], ...]  # of cells and registers, by name
ONE = Integer(1)
ZERO = Integer(0)
KNOWN = "sums, products, powers, exp, log, sin, cos and tanh, and min and max that change branch at a parameter"


def cell(name: str) -> Symbol:
    """Return the symbol of a cell, a number known at the start of a phase."""
    return Symbol(name, real=True)


def series(name: str, coefficient: Expr = ONE) -> Increment:
    """Return the increment that is a coefficient times the register ``name``."""
    return {(name,): coefficient}


def varying(name: str) -> Split:
    """Return base and increment of a quantity with the cell ``x_0`` and the register ``dx``."""
    return cell(f"{name}_0"), series(f"d{name}")


def total(*terms: Split) -> Increment:
    """Return the sum of increments, each multiplied by its factor, without terms that are zero."""
    coefficients: dict[Names, Expr] = defaultdict(lambda: ZERO)
    for factor, increment in terms:
        for product, coefficient in increment.items():
            coefficients[product] += factor * coefficient
    return {product: c for product, c in sorted(coefficients.items()) if c != 0}


def without_tanh(e: Expr) -> Expr:
    """Return an expression with exponentials for tanh, accurate unless its argument is far below 0."""
    return e.replace(tanh, lambda x: 2 / (1 + exp(-2 * x)) - 1)


def times(a: Increment, b: Increment) -> Increment:
    """Return the product of two increments, terms of which with the same registers are added."""
    terms = []
    for p, c in a.items():
        for q, d in b.items():
            terms.append((c * d, {tuple(sorted(p + q)): ONE}))
    return total(*terms)


SLIP = cell("slip")


class OnSeries(NamedTuple):
    """Operation on series, by the names or by the places of its results, registers and cells.

    The cells of a sum, ``lin``, are its constant and the factor of each register; other operations have no cells.
    """

    kind: str
    results: Any
    registers: Any
    cells: Any = ()


class Fragment(NamedTuple):
    """Operations on numbers at the start of a phase, operations on series, and their contributions to the balance.

    ``adds`` contains for each quantity of the balance its base, the size of the base's terms, and its increment as a
    sum of (number, series). ``inputs`` are the dimensionless numbers of a scene. Each of ``series`` consists of its
    kind, its results, its registers and its cells. ``states`` are series with the series of their rates. Each of
    ``tables`` consists of its name, its variable (slip, speed, rotation or time), the series of its argument (for time
    its own series), and the degree of its pieces.
    """

    inputs: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()
    tables: tuple[tuple[str, str, str, int], ...] = ()


@dataclass
class Lowering:
    """Collector of the operations of one fragment. ``moving`` are the symbols that change during a phase."""

    name: str
    moving: Moving
    series: list[OnSeries] = field(default_factory=list)
    cells: Forms = field(default_factory=dict)  # results of the prologue, by name
    count: int = 0

    def split(self, e: Expr) -> Split:
        """Return the base of an expression, its value at the start of the phase, and its increment since then."""
        if e in self.moving:
            return self.moving[e]
        if e.has(tanh):
            return self.split(without_tanh(e))
        bases = {x: self.moving[x][0] for x in e.free_symbols if x in self.moving}
        if not any(self.moving[x][1] for x in bases):
            return e.xreplace(bases), {}
        if e.is_Add:
            return self._sum(e.args)
        if e.is_Mul:
            return self._product(e.args)
        if e.is_Pow and e.exp.is_Integer and e.exp > 0:
            return self._product([e.base] * int(e.exp))
        return self.function(e)

    def _sum(self, terms: Iterable[Expr]) -> Split:
        """Return base and increment of the sum of these terms."""
        bases = []
        increments = []
        for term in terms:
            base, increment = self.split(term)
            bases.append(base)
            increments.append((ONE, increment))
        return Add(*bases), total(*increments)

    def _product(self, factors: Iterable[Expr]) -> Split:
        """Return base and increment of a product by d(a b) = a_0 db + b_0 da + da db."""
        base = ONE
        increment = total()
        for factor in factors:
            b, d = self.split(factor)
            increment = total((base, d), (b, increment), (ONE, times(increment, d)))
            base = base * b
        return base, increment

    def function(self, e: Expr) -> Split:
        """Return base and increment of exp, log, a power, sin or cos, by an operation on the argument's increment."""
        b, d = self.split(e.base if e.is_Pow else e.args[0])
        relative = total((1 / b, d)) if b != 0 else {}
        if isinstance(e, exp):
            return exp(b), self.apply("exp", d, exp(b))
        if isinstance(e, sin):
            return sin(b), self.turn(d, cos(b), -sin(b))
        if isinstance(e, cos):
            return cos(b), self.turn(d, -sin(b), -cos(b))
        if isinstance(e, log):
            return log(b), self.apply("log", relative, ONE)
        if e.is_Pow and relative and not e.exp.free_symbols & self.moving.keys():
            if e.exp == -1:
                return 1 / b, self.apply("rec", relative, 1 / b)
            power = b**e.exp
            if b != 1 and not (2 * e.exp).is_Integer:
                power = Exp(e.exp * log(b))
            return power, self.apply("exp", self.apply("log", relative, e.exp), power)
        raise ProofError(f"{self.name}: operation on series", e, KNOWN)

    def apply(self, operation: str, increment: Increment, factor: Expr) -> Increment:
        """Return a factor times the last result of an operation on an increment, 0 if the increment is 0."""
        z = self.register(increment)
        self.count += 1
        results = [f"{self.name}.{operation}{self.count}.{x}" for x in OPERATIONS[operation].results]
        self.operate(operation, results, z)
        return series(results[-1], factor)

    def turn(self, increment: Increment, sine: Expr, versine: Expr) -> Increment:
        """Return ``sine`` times the sine plus ``versine`` times the versine (1 - cos) of an increment."""
        x = self.register(increment)
        results = f"sin({x})", f"vers({x})"
        self.operate("turn", results, x)
        sine_of_x, versine_of_x = map(series, results)
        return total((sine, sine_of_x), (versine, versine_of_x))

    def operate(self, operation: str, results: Iterable[str], z: str) -> None:
        """Append an operation on the register z, preceded by t dz/dt if the operation needs it.

        ``results`` are the registers of its results.
        """
        arguments = [z]
        if Q in OPERATIONS[operation].arguments:
            times = f"{z}.times"
            self.put("tim", [times], arguments)
            arguments = [times, z]
        self.put(operation, results, arguments)

    def put(self, kind: str, results: Iterable[str], registers: Iterable[str], cells: Iterable[str] = ()) -> None:
        """Append an operation on series, with its results and operands by name, unless it exists."""
        operation = OnSeries(kind, tuple(results), tuple(registers), tuple(cells))
        if operation not in self.series:
            self.series.append(operation)

    def register(self, increment: Increment, name: str = "", constant: str = "=0.0") -> str:
        """Return the register that contains an increment, a new one called ``name`` if that is given.

        A new one also contains the number in the cell ``constant``.
        """
        if not name:
            if list(increment.values()) == [1]:
                return self.product(*increment)
            self.count += 1
            name = f"{self.name}.sum{self.count}"
        terms = self.sum(increment)
        factors = [factor for factor, _ in terms]
        self.put("lin", [name], [register for _, register in terms], [constant, *factors])
        return name

    def product(self, registers: Names) -> str:
        """Return the register that contains the product of these registers."""
        result, *rest = registers
        for other in rest:
            name = f"{result}*{other}"
            if other == result:
                self.put("sqr", [name], [result])
            else:
                self.put("mul", [name], [result, other])
            result = name
        return result

    def sum(self, increment: Increment) -> Products:
        """Return an increment as a sum of pairs (cell, register), each a product."""
        terms = []
        for registers, coefficient in increment.items():
            terms.append((self.cell(coefficient), self.product(registers)))
        return tuple(terms)

    def cell(self, e: Expr, name: str = "") -> str:
        """Return the cell that contains ``e``, a number known at the start of a phase, called ``name`` if given."""
        if not name:
            if e.is_Symbol:
                return str(e)
            if e.is_Number:
                return f"={float(e)!r}"
            for known, held in self.cells.items():
                if held == e:
                    return known
            name = f"{self.name}.{len(self.cells)}"
        self.cells[name] = e
        return name

    def number(self, name: str) -> Expr:
        """Return the number that a cell contains; a cell which is not computed here is a symbol."""
        return Float(name[1:]) if name.startswith("=") else self.cells.get(name, cell(name))

    def add(self, e: Expr, quantity: str) -> tuple[str, str, Products]:
        """Return base, size of the base's terms, and increment of the term ``e`` that is added to a quantity.

        Base and size are names of cells, the increment pairs (cell, register).
        """
        direct, increment = self.split(e)
        base, scale = self.base(e, direct)
        name = f"{self.name}.{quantity}"
        return self.cell(base, name), self.cell(scale, f"{name}_size"), self.sum(increment)

    def base(self, e: Expr, direct: Expr) -> tuple[Expr, Expr]:
        """Return a base of the term ``e`` and the size of its terms; ``direct`` is its value at the phase's start.

        If it depends on slip, the more accurate of two forms is used.

        The forms are the formula at the start of the phase, and the formula without slip plus the increment since then.
        """
        if SLIP not in e.free_symbols:
            return direct, size(direct)
        from_start = Lowering("start", {SLIP: (ZERO, series("slip"))})
        bases = {x: base for x, (base, _) in self.moving.items() if x != SLIP}
        start, increment = from_start.split(e.subs(bases))
        registers = {"slip": self.moving[SLIP][0]}
        evaluate(from_start.series, registers, from_start.number, attrgetter("start"))
        other = expand(start)
        for names, coefficient in increment.items():
            other += coefficient * Mul(*(registers[name] for name in names))
        other_size = size(other)
        direct_size = size(direct)
        return Select(direct_size * (1 + Rational(1, 2**40)), other_size, direct, other), Min(other_size, direct_size)

    def fragment(
        self,
        adds: Mapping[str, Expr] | None = None,
        inputs: Iterable[str] = (),
        states: Mapping[str, Expr] | None = None,
        tables: tuple[tuple[str, str, str, int], ...] = (),
    ) -> Fragment:
        """Return the fragment of all lowered operations, of ``adds``, and of the rates of states."""
        added = {quantity: self.add(e, quantity) for quantity, e in (adds or {}).items() if e != 0}
        rates = []
        for name, rate in (states or {}).items():
            _, increment = self.split(rate)
            rates.append((name, self.register(increment)))
        return Fragment(
            inputs=tuple(inputs),
            scalar=self.scalar(),
            series=tuple(map(tuple, self.series)),
            adds=added,
            states=tuple(rates),
            tables=tables,
        )

    def scalar(self) -> tuple[Names, ...]:
        """Return the prologue: rows of an operation, its result and its operands, cells by name.

        Constants are named by their value, ``=2.0``.
        """
        numbers = Tuple(*self.cells.values())
        prologue = program(self.name, tuple(sorted(str(x) for x in numbers.free_symbols)), *numbers)
        operations: list[Names] = []

        def make(op: Op, operands: Texts) -> str:
            if op.kind == "const":
                return f"={op.value!r}"
            result = f"{self.name}.t{len(operations)}"
            operations.append((op.kind, result, *operands))
            return result

        results = walk(prologue, {name: name for name in prologue.inputs}, make)
        return (*operations, *(("set", name, result) for name, result in zip(self.cells, results, strict=True)))


def size(e: Expr) -> Expr:
    """Return the sum of the magnitudes of an expression's terms, to which its rounding error is proportional."""
    return Add(*(abs(x) for x in Add.make_args(e)))
