"""Any expression of the balance becomes operations: on numbers where a phase begins, and on series along it.

Every quantity is its base, a number that holds where the phase begins (and at no speed), and its increment since, a
series. Increments are built from increments, so that near a limit nothing cancels:

    d(a b) = a_0 db + b_0 da + da db,    d exp(a) = exp(a_0) expm1(da),    d(1/a) = (1/a_0) (1/(1 + da/a_0) - 1), ...
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import sympy as sp

from derive.algebra.remainders import Exp, Select
from derive.code.program import program
from derive.flow.operations import OPERATIONS, Q, first

# An increment: the coefficient, a number, of each product of registers, which are named in order.
Increment = Mapping[tuple[str, ...], sp.Expr]
Moving = Mapping[sp.Symbol, tuple[sp.Expr, Increment]]  # base and increment by symbol


def cell(name: str) -> sp.Symbol:
    """The symbol of a number."""
    return sp.Symbol(name, real=True)


def series(name: str, coefficient: sp.Expr = sp.Integer(1)) -> Increment:
    """The increment that a register holds."""
    return {(name,): coefficient}


def total(*terms: tuple[sp.Expr, Increment]) -> Increment:
    """The sum of numbers times increments."""
    found: dict[tuple[str, ...], sp.Expr] = {}
    for factor, increment in terms:
        for product, coefficient in increment.items():
            found[product] = found.get(product, sp.Integer(0)) + factor * coefficient
    return {product: c for product, c in sorted(found.items()) if c != 0}


def times(a: Increment, b: Increment) -> Increment:
    """The product of two increments."""
    return total(*((sp.Integer(1), {tuple(sorted((*p, *q))): c * d}) for p, c in a.items() for q, d in b.items()))


SLIP = cell("slip")


class Fragment(NamedTuple):
    """Formulas in words; operations on numbers where a phase begins, operations on series, and what they add.

    ``adds`` gives for each quantity of the balance its base, the size of the base's terms, and its increment as a sum
    of (number, series). ``inputs`` are what a scene gives, over the scales of the arc; ``optional`` ones may be left
    out. ``states`` are series with those of their rates. Each of ``tables`` has its name, is of slip, speed, rotation or
    time, with the series of its argument (of time, its own) and the degree of its pieces.
    """

    words: tuple[str, ...]
    inputs: tuple[str, ...]
    optional: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[object, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()
    tables: tuple[tuple[str, str, str, int], ...] = ()


@dataclass
class Lowering:
    """Collects the operations of one fragment. ``moving`` are the symbols that change along a phase."""

    name: str
    moving: Moving
    series: list[tuple[object, ...]] = field(default_factory=list)
    cells: dict[str, sp.Expr] = field(default_factory=dict)  # what the prologue has to compute, by name
    count: int = 0

    def split(self, e: sp.Expr) -> tuple[sp.Expr, Increment]:
        """Base and increment of an expression."""
        one = sp.Integer(1)
        if e in self.moving:
            return self.moving[e]
        inside = [x for x in e.free_symbols if x in self.moving]
        if not any(self.moving[x][1] for x in inside):
            return e.xreplace({x: self.moving[x][0] for x in inside}), {}
        if isinstance(e, sp.Add):
            parts = [self.split(x) for x in e.args]
            return sp.Add(*(b for b, _ in parts)), total(*((one, d) for _, d in parts))
        if isinstance(e, sp.Mul) or (isinstance(e, sp.Pow) and e.exp.is_Integer and e.exp > 0):
            base, increment = one, total()
            for b, d in map(self.split, e.args if isinstance(e, sp.Mul) else [e.base] * int(e.exp)):
                base, increment = base * b, total((base, d), (b, increment), (one, times(increment, d)))
            return base, increment
        return self.function(e)

    def function(self, e: sp.Expr) -> tuple[sp.Expr, Increment]:
        """The same of exp, log, a power, sin or cos, by the operation on the increment of its argument."""
        b, d = self.split(e.base if isinstance(e, sp.Pow) else e.args[0])
        relative = total((1 / b, d)) if b != 0 else {}
        if isinstance(e, sp.exp):
            return sp.exp(b), self.apply("exp", d, sp.exp(b))
        if isinstance(e, sp.sin):
            return sp.sin(b), self.turn(d, sp.cos(b), -sp.sin(b))
        if isinstance(e, sp.cos):
            return sp.cos(b), self.turn(d, -sp.sin(b), -sp.cos(b))
        if isinstance(e, sp.log):
            return sp.log(b), self.apply("log", relative, sp.Integer(1))
        if isinstance(e, sp.Pow) and not e.exp.free_symbols & self.moving.keys() and relative:
            if e.exp == -1:
                return 1 / b, self.apply("rec", relative, 1 / b)
            power = b**e.exp if b == 1 or (2 * e.exp).is_Integer else Exp(e.exp * sp.log(b))
            return power, self.apply("pow", relative, power, e.exp)
        raise ValueError(f"no operation on series for {type(e).__name__}: {e}")

    def apply(self, operation: str, increment: Increment, factor: sp.Expr, *numbers: sp.Expr) -> Increment:
        """A factor times the last result of an operation on an increment, which is 0 where the increment is."""
        z = self.register(increment)
        self.count += 1
        names = (f"{self.name}.{operation}{self.count}{x}" for x in ("", "_less_1"))
        results = [name for _, name in zip(OPERATIONS[operation].results, names, strict=False)]
        self.operate(operation, results, z, *map(self.cell, numbers))
        return series(results[-1], factor)

    def turn(self, increment: Increment, sine: sp.Expr, versine: sp.Expr) -> Increment:
        """Factors times sin and versine, 1 - cos, of an increment."""
        x = self.register(increment)
        self.operate("turn", (f"sin({x})", f"vers({x})"), x)
        return total((sine, series(f"sin({x})")), (versine, series(f"vers({x})")))

    def operate(self, operation: str, results: Iterable[str], z: str, *numbers: str) -> None:
        """Append an operation on the register z, and before it what is made of z alone, if it takes that too."""
        own = Q in OPERATIONS[operation].arguments
        if own:
            self.put("tim", f"{z}.times", z)
        self.put(operation, *results, *([f"{z}.times"] if own else []), z, *numbers)

    def put(self, *operation: object) -> None:
        """Append an operation on series, once."""
        if operation not in self.series:
            self.series.append(operation)

    def register(self, increment: Increment, name: str = "") -> str:
        """The register that holds an increment."""
        if not name and len(increment) == 1 and [*increment.values()] == [1]:
            return self.product(*increment)
        if not name:
            self.count += 1
            name = f"{self.name}.sum{self.count}"
        self.put("lin", name, "", self.sum(increment))
        return name

    def product(self, registers: tuple[str, ...]) -> str:
        """The register that holds a product of others."""
        result, *rest = registers
        for other in rest:
            name = f"{result}*{other}"
            self.put("sqr", name, result) if other == result else self.put("mul", name, result, other)
            result = name
        return result

    def sum(self, increment: Increment) -> tuple[tuple[str, str], ...]:
        """An increment as a sum of a cell times a register each."""
        return tuple((self.cell(c), self.product(registers)) for registers, c in increment.items())

    def cell(self, e: sp.Expr, name: str = "") -> str:
        """The cell that holds a number which is known where a phase begins."""
        if not name:
            if isinstance(e, sp.Symbol):
                return str(e)
            if e.is_Number:
                return f"={float(e)!r}"
            for known, there in self.cells.items():
                if there == e:
                    return known
            name = f"{self.name}.{len(self.cells)}"
        self.cells[name] = e
        return name

    def add(self, e: sp.Expr, quantity: str) -> tuple[str, str, tuple[tuple[str, str], ...]]:
        """Base, size of the base's terms, and increment of what is added to a quantity."""
        base, increment = self.split(e)
        base, scale = self.base(e, base)
        return (
            self.cell(base, f"{self.name}.{quantity}"),
            self.cell(scale, f"{self.name}.{quantity}_size"),
            self.sum(increment),
        )

    def base(self, e: sp.Expr, direct: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """A base and the size of its terms; of what depends on slip, the better of two forms."""
        if SLIP not in e.free_symbols:
            return direct, size(direct)
        # Both from terms: the formula where the phase begins, and the one at no slip and the increment since then.
        from_start = Lowering("start", {SLIP: (sp.Integer(0), series("slip"))})
        start, increment = from_start.split(e.subs({x: b for x, (b, _) in self.moving.items() if x != SLIP}))
        at = first(from_start.series, {"slip": self.moving[SLIP][0]}, from_start.cells)
        other = sp.expand(start) + sum(c * sp.Mul(*(at[r] for r in rs)) for rs, c in increment.items())
        better = size(other), size(direct)
        return Select(better[1] * (1 + sp.Rational(1, 2**40)), better[0], direct, other), sp.Min(*better)

    def fragment(
        self,
        words: Iterable[str],
        adds: Mapping[str, sp.Expr],
        inputs: Iterable[str] = (),
        optional: Iterable[str] = (),
        states: Mapping[str, sp.Expr] | None = None,
        tables: tuple[tuple[str, str, str, int], ...] = (),
    ) -> Fragment:
        """The fragment of all that was lowered and of ``adds`` and of the states' rates."""
        added = {quantity: self.add(e, quantity) for quantity, e in adds.items() if e != 0}
        rates = tuple((name, self.register(self.split(rate)[1])) for name, rate in (states or {}).items())
        return Fragment(
            tuple(words), tuple(inputs), tuple(optional), self.scalar(), tuple(self.series), added, rates, tables
        )

    def scalar(self) -> tuple[tuple[str, ...], ...]:
        """The prologue: operations on cells, by names; constants are named by their value, ``=2.0``."""
        found = sp.Tuple(*self.cells.values())
        p = program(self.name, tuple(sorted(str(x) for x in found.free_symbols)), *found)
        outputs = dict(zip(self.cells, p.outputs, strict=True))
        names: dict[int, str] = {}
        for index, op in enumerate(p.ops):
            if op.kind in ("input", "const"):
                names[index] = str(op.value) if op.kind == "input" else f"={op.value!r}"
            else:
                names[index] = next((n for n, i in outputs.items() if i == index), f"{self.name}.t{index}")
        operations = [
            (op.kind, names[i], *(names[j] for j in op.args))
            for i, op in enumerate(p.ops)
            if op.kind not in ("input", "const")
        ]
        return (*operations, *(("set", n, names[i]) for n, i in outputs.items() if names[i] != n))


def size(e: sp.Expr) -> sp.Expr:
    """The sum of the magnitudes of an expression's terms, which its rounding error is a part of."""
    return sp.Add(*(abs(x) for x in sp.Add.make_args(e)))
