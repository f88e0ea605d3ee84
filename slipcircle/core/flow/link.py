"""Linking: definitions by name become operations in order, and what is nothing is left out with all it is a factor of.

Equal operations are done once, and sums of sums become one. A name with a prime and a number, ``net'0``, is a tangent,
the derivative in a direction: its definition follows from that of what it is a tangent of.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from generated.flow import CELL_TANGENTS, SERIES_TANGENTS

Operation = tuple[Any, ...]  # its name and its arguments
RESULTS = {"turn": 2, "exp": 2, "rec": 2, "pow": 2}  # where there are more than one
ZERO, ONE, MINUS = "=0.0", "=1.0", "=-1.0"


@dataclass
class Linker:
    """Definitions by name, and what has become of them."""

    cells: dict[str, Operation] = field(default_factory=dict)
    registers: dict[str, Operation] = field(default_factory=dict)  # with all names, results first
    kept: set[str] = field(default_factory=set)  # registers that more than sums are made of
    known: dict[str, str] = field(default_factory=dict)  # canonical cell by name
    made: dict[str, str | None] = field(default_factory=dict)  # canonical register by name; None is nothing
    scalar: dict[Operation, str] = field(default_factory=dict)
    series: dict[Operation, tuple[str, ...]] = field(default_factory=dict)

    def define(self, cells: Iterable[Any], registers: Iterable[Any]) -> None:
        """Take definitions, operations with the names of their results first."""
        self.cells |= {result: (op, *arguments) for op, result, *arguments in cells}
        for op, *names in registers:
            self.registers |= {str(result): (op, *names) for result in names[: RESULTS.get(str(op), 1)]}

    # --- cells ---------------------------------------------------------------------------------------------------

    def cell(self, name: str) -> str:
        """The cell that a name stands for, computed if need be."""
        if name.startswith("="):
            return ZERO if "'" in name else name
        if name not in self.known:
            op, *arguments = self.cells.get(name) or self._tangent_of_cell(name)
            self.known[name] = self.compute(op, *map(self.cell, arguments), name=name)
        return self.known[name]

    def _tangent_of_cell(self, name: str) -> Operation:
        base, prime, direction = name.rpartition("'")
        if not prime:
            raise KeyError(name)
        if base not in self.cells:  # of a number that does not vary
            return ("set", ZERO)
        op, *arguments = self.cells[base]
        own, template = CELL_TANGENTS.get(op, (("d", "a"), (("set", "d'", "a'"),)))
        self.define(_instance(template, dict(zip(own, (base, *arguments), strict=False)), base, direction), ())
        return self.cells[name]

    def compute(self, op: str, *a: str, name: str = "") -> str:
        """An operation on cells, or what is known to come of it."""
        match op, a:
            case ("set", (x,)) | ("add", (x, "=0.0")) | ("add", ("=0.0", x)) | ("sub", (x, "=0.0")):
                return x
            case ("mul", (x, "=1.0")) | ("mul", ("=1.0", x)) | ("div", (x, "=1.0")):
                return x
            case ("mul", ("=0.0", _)) | ("mul", (_, "=0.0")) | ("div", ("=0.0", _)) | ("neg" | "abs", ("=0.0",)):
                return ZERO
            case ("select", (_, "=0.0", "=0.0")) | ("less", ("=0.0", "=0.0")):
                return ZERO
            case ("select", ("=0.0", _, x)):
                return x
            case ("sub", (x, y)) if x == y:
                return ZERO
            case ("sub", ("=0.0", x)) | ("mul", (x, "=-1.0")) | ("mul", ("=-1.0", x)):
                return self.compute("neg", x, name=name)
            case ("neg", ("=1.0",)):
                return MINUS
        return self.scalar.setdefault((op, *a), name or f"cell{len(self.scalar)}")

    def origins(self, names: Iterable[str]) -> set[str]:
        """The cells that come from outside of those that cells are computed of."""
        todo, found = [*map(self.cell, names)], set[str]()
        by_name = {name: op for op, name in self.scalar.items()}
        while todo:
            name = todo.pop()
            if name in by_name:
                todo += by_name.pop(name)[1:]
            else:
                found.add(name)
        return found

    # --- registers -----------------------------------------------------------------------------------------------

    def definition(self, name: str) -> Operation:
        """Of a register; what has none is an empty sum."""
        if name not in self.registers and "'" in name and name not in self.made:
            base, _, direction = name.rpartition("'")
            op, *names = self.definition(base)
            if op == "lin":
                terms = [(c, f"{r}'{direction}") for c, r in names[2]] + [(f"{c}'{direction}", r) for c, r in names[2]]
                self.registers[name] = ("lin", name, names[1] and f"{names[1]}'{direction}", tuple(terms))
            elif op == "ramp":
                self.registers[name] = ("ramp", name, names[1])
            else:
                own, template = SERIES_TANGENTS[op]
                self.define((), _instance(template, dict(zip(own, names, strict=True)), base, direction))
        return self.registers.get(name, ("lin", name, "", ()))

    def keep(self, names: Iterable[str]) -> None:
        """Find out which registers these take are no mere parts of sums."""
        todo = [*names]
        self.kept.update(todo)
        seen = set(self.made)
        while todo:
            name = todo.pop()
            if name in seen or self.nothing(name):
                continue
            seen.add(name)
            op, *rest = self.definition(name)
            parts = [r for _, r in rest[2]] if op == "lin" else _arguments(op, rest)
            todo += parts
            if op != "lin":
                self.kept.update(parts)

    def nothing(self, name: str) -> bool:
        """Whether a register is nothing: undefined, or a product with or a sum of nothing."""
        if name not in self.made:
            op, *names = self.definition(name)
            if op == "lin":
                absent = all(self.cell(c) == ZERO or self.nothing(r) for c, r in names[2])
                absent = absent and (not names[1] or self.cell(names[1]) == ZERO)
            else:
                absent = any(map(self.nothing, _arguments(op, names)))
            if not absent:
                return False
            self.made[name] = None
        return self.made[name] is None

    def register(self, name: str) -> str | None:
        """The register that a name stands for, made if need be; None where it is nothing."""
        if not self.nothing(name) and name not in self.made:
            op, *names = self.definition(name)
            if op == "lin":
                self.made[name] = self._sum(name, self.cell(names[1]) if names[1] else ZERO, names[2])
            else:
                results, parts = names[: RESULTS.get(op, 1)], _arguments(op, names)
                numbers = [self.cell(names[-1])] if op == "pow" else [name] if op == "ramp" else []
                key = (op, *map(self.register, parts), *numbers)
                self.made[name] = self.series.setdefault(key, tuple(results))[results.index(name)]
        return self.made[name]

    def _terms(self, terms: Iterable[tuple[str, str]], factor: str = ONE) -> Iterator[tuple[str, str]]:
        """A sum's cells and registers, those of sums that only sums are made of in their place."""
        for c, r in terms:
            cell = self.compute("mul", factor, self.cell(c))
            if cell != ZERO and not self.nothing(r):
                op, *names = self.definition(r)
                if op == "lin" and not names[1] and r not in self.kept and r not in self.made:
                    yield from self._terms(names[2], cell)
                else:
                    yield cell, str(self.register(r))

    def _sum(self, name: str, constant: str, terms: Iterable[tuple[str, str]]) -> str:
        """A sum of cells times registers, each register once."""
        factors: dict[str, str] = {}
        for cell, register in self._terms(terms):
            factors[register] = self.compute("add", factors.get(register, ZERO), cell)
        if constant == ZERO and [*factors.values()] == [ONE]:
            return next(iter(factors))
        return self.series.setdefault(("lin", constant, tuple(sorted((c, r) for r, c in factors.items()))), (name,))[0]


def _arguments(op: str, names: list[Any]) -> list[str]:
    """The registers among the names of an operation that are no results."""
    return [] if op == "ramp" else list(names[RESULTS.get(op, 1) : -1 if op == "pow" else None])


def _instance(template: Iterable[Any], own: dict[str, str], base: str, direction: str) -> list[Any]:
    """A template's operations under the names of one operation; ``x'`` is the tangent of what x is there."""

    def new(x: Any) -> Any:
        if not isinstance(x, str):
            return tuple(map(new, x))
        if not x or x.startswith("=") or x in own:
            return own.get(x, x)
        return f"{own[x[:-1]]}'{direction}" if x[:-1] in own and x[-1] == "'" else f"{base}'{direction}|{x}"

    return [(op, *map(new, names)) for op, *names in template]


def needed(operations: Iterable[tuple[Operation, tuple[str, ...]]], wanted: set[str]) -> list[Any]:
    """The operations that something needs, in order."""
    found, need = [], set(wanted)
    for op, results in reversed([*operations]):
        if need & {*results}:
            found.append((op, results))
            need |= {r for _, r in op[2]} if op[0] == "lin" else {*op[1:]}
    return found[::-1]


def places(operations: list[Any], cells: list[str]) -> dict[str, int]:
    """Where each cell is: those that are listed in their place, the others share what is free."""
    place = {x: i for i, x in enumerate(cells)}
    last = {x: i for i, (op, _) in enumerate(operations) for x in op[1:]}
    free: list[int] = []
    more = len(cells)
    for i, (op, (d,)) in enumerate(operations):
        free += sorted({place[x] for x in op[1:] if last[x] == i and place[x] >= len(cells)}, reverse=True)
        if d not in place:
            place[d] = free.pop() if free else more
            more = max(more, place[d] + 1)
    return place
