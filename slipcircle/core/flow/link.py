"""Linking of a flow program: definitions by name become ordered operations, without those that are identically zero.

A *cell* is a number where a phase begins, a *register* a series in time. Equal operations are computed once, and sums
of sums are flattened. A name with a prime and a number, ``net'0``, is the tangent in that direction of the name before
the prime; its definition follows by the rules in `generated.flow`.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from generated.flow import CELL_TANGENTS, SERIES_TANGENTS

Operation = tuple[Any, ...]  # name and arguments; of series (`Linker.series_definitions`) name, results, arguments
Operations = list[tuple[Operation, tuple[str, ...]]]  # with their results
Term = tuple[str, str]  # of a sum: a cell times a register
RESULTS = {"turn": 2, "exp": 2, "rec": 2, "pow": 2, "powers": 6}  # of operations on series that have more than one
ZERO, ONE, MINUS_ONE = "=0.0", "=1.0", "=-1.0"
PRIME = "'"
TANGENT_OF_COPY = (("d", "a"), (("set", "d'", "a'"),))


def tangent(name: str, direction: object) -> str:
    """The name of a tangent."""
    return f"{name}{PRIME}{direction}"


def arguments(operation: str, names: Sequence[Any]) -> list[str]:
    """The registers that an operation on series takes, of the names of its results and arguments."""
    if operation == "ramp":
        return []
    if operation == "lin":
        return [register for _, register in names[2]]
    last = -1 if operation == "pow" else None  # its exponent is a cell
    return list(names[RESULTS.get(operation, 1) : last])


@dataclass
class Linker:
    """Definitions by name, and the operations that result from them.

    ``cells`` and ``registers`` give for each name the one under which its value is computed, or None for a register
    that is zero; ``scalar`` and ``series`` are the operations, with the names of their results.
    """

    cell_definitions: dict[str, Operation] = field(default_factory=dict)
    series_definitions: dict[str, Operation] = field(default_factory=dict)
    shared: set[str] = field(default_factory=set)  # registers that operations other than sums take
    cells: dict[str, str] = field(default_factory=dict)
    registers: dict[str, str | None] = field(default_factory=dict)
    scalar: dict[Operation, str] = field(default_factory=dict)
    series: dict[Operation, tuple[str, ...]] = field(default_factory=dict)

    def define_cells(self, operations: Iterable[Any]) -> None:
        """Take definitions of cells: name of the operation, result, arguments."""
        for operation, result, *taken in operations:
            self.cell_definitions[result] = (operation, *taken)

    def define_series(self, operations: Iterable[Any]) -> None:
        """Take definitions of registers: name of the operation, results, arguments."""
        for operation, *names in operations:
            for result in names[: RESULTS.get(operation, 1)]:
                self.series_definitions[result] = (operation, *names)

    # --- cells ---------------------------------------------------------------------------------------------------

    def cell(self, name: str) -> str:
        """The cell that a name stands for, computed if necessary."""
        if name.startswith("="):
            return ZERO if PRIME in name else name
        if name not in self.cells:
            if name not in self.cell_definitions:
                self._define_cell_tangent(name)
            operation, *taken = self.cell_definitions[name]
            cells = [self.cell(argument) for argument in taken]
            self.cells[name] = self.compute(operation, cells, name)
        return self.cells[name]

    def _define_cell_tangent(self, name: str) -> None:
        """By the rule for the operation that computes the cell; zero for a number that does not vary."""
        base, prime, direction = name.rpartition(PRIME)
        if not prime:
            raise KeyError(name)
        if base not in self.cell_definitions:
            self.cell_definitions[name] = ("set", ZERO)
            return
        operation, *taken = self.cell_definitions[base]
        placeholders, rule = CELL_TANGENTS.get(operation, TANGENT_OF_COPY)
        actual = dict(zip(placeholders, (base, *taken), strict=False))
        self.define_cells(_instance(rule, actual, base, direction))

    def compute(self, operation: str, taken: list[str], name: str = "") -> str:
        """The cell of an operation's result: a new one, or one that holds it already."""
        known = _simplified(operation, taken)
        if known is not None:
            return known
        if operation == "sub" and taken[0] == ZERO:
            return self.compute("neg", taken[1:], name)
        if operation == "mul" and MINUS_ONE in taken:
            factor = taken[1] if taken[0] == MINUS_ONE else taken[0]
            return self.compute("neg", [factor], name)
        result = name or f"cell{len(self.scalar)}"
        return self.scalar.setdefault((operation, *taken), result)

    def origins(self, names: Iterable[str]) -> set[str]:
        """The inputs from which some cells are computed."""
        given = set[str]()
        pending = [self.cell(name) for name in names]
        operations = {result: operation for operation, result in self.scalar.items()}
        while pending:
            name = pending.pop()
            if name in operations:
                pending += operations.pop(name)[1:]
            else:
                given.add(name)
        return given

    # --- registers -----------------------------------------------------------------------------------------------

    def definition(self, name: str) -> Operation:
        """Definition of a register; without one it is an empty sum."""
        if name not in self.series_definitions and PRIME in name and name not in self.registers:
            self._define_series_tangent(name)
        return self.series_definitions.get(name, ("lin", name, "", ()))

    def _define_series_tangent(self, name: str) -> None:
        """Of a sum term by term, (c r)' = c r' + c' r; of other operations by the rules of `generated.flow`."""
        base, _, direction = name.rpartition(PRIME)
        operation, *names = self.definition(base)
        if operation == "lin":
            _, constant, terms = names
            by_registers = [(cell, tangent(register, direction)) for cell, register in terms]
            by_cells = [(tangent(cell, direction), register) for cell, register in terms]
            constant = constant and tangent(constant, direction)
            self.series_definitions[name] = ("lin", name, constant, (*by_registers, *by_cells))
            return
        if operation == "ramp":
            table = names[1]
            self.series_definitions[name] = ("ramp", name, table)
            return
        placeholders, rule = SERIES_TANGENTS[operation]
        actual = dict(zip(placeholders, names, strict=True))
        derivative = _instance(rule, actual, base, direction)
        self.define_series(derivative)

    def mark_shared(self, names: Iterable[str]) -> None:
        """Collect the registers that these take, directly or not, and that are more than terms of sums."""
        pending = list(names)
        seen = set(self.registers)
        self.shared.update(pending)
        while pending:
            name = pending.pop()
            if name in seen or self.is_zero(name):
                continue
            seen.add(name)
            operation, *definition = self.definition(name)
            taken = arguments(operation, definition)
            pending += taken
            if operation != "lin":
                self.shared.update(taken)

    def is_zero(self, name: str) -> bool:
        """Whether a register is identically zero: undefined, a product with zero, or a sum of zeros."""
        if name in self.registers:
            return self.registers[name] is None
        operation, *names = self.definition(name)
        if operation == "lin":
            _, constant, terms = names
            zero = all(self.cell(cell) == ZERO or self.is_zero(register) for cell, register in terms)
            if zero and constant:
                zero = self.cell(constant) == ZERO
        else:
            zero = any(map(self.is_zero, arguments(operation, names)))
        if zero:
            self.registers[name] = None
        return zero

    def register(self, name: str) -> str | None:
        """The register that a name stands for, with its operations; None where it is zero."""
        if self.is_zero(name) or name in self.registers:
            return self.registers[name]
        operation, *names = self.definition(name)
        if operation == "lin":
            _, constant, terms = names
            register = self._sum(name, constant, terms)
        else:
            register = self._result(name, operation, names)
        self.registers[name] = register
        return register

    def _result(self, name: str, operation: str, names: Sequence[Any]) -> str:
        """The register of one result of an operation, which is shared by equal arguments."""
        results = tuple(names[: RESULTS.get(operation, 1)])
        taken = [self.register(register) for register in arguments(operation, names)]
        if operation == "pow":
            taken.append(self.cell(names[-1]))
        elif operation == "ramp":
            taken.append(name)
        made = self.series.setdefault((operation, *taken), results)
        return made[results.index(name)]

    def zero_register(self, name: str) -> str:
        """A register that holds zero, for a requested quantity that is zero."""
        return self.series.setdefault(("lin", ZERO, ()), (name,))[0]

    def _sum(self, name: str, constant: str, terms: Iterable[Term]) -> str:
        """A constant and cells times registers, each register once."""
        start = ZERO
        if constant:
            start = self.cell(constant)
        factors: dict[str, str] = {}
        for cell, register in self._terms(terms, ONE):
            factor = factors.get(register, ZERO)
            factors[register] = self.compute("add", [factor, cell])
        if start == ZERO and list(factors.values()) == [ONE]:
            return next(iter(factors))
        flat = sorted((cell, register) for register, cell in factors.items())
        results = self.series.setdefault(("lin", start, tuple(flat)), (name,))
        return results[0]

    def _terms(self, terms: Iterable[Term], factor: str) -> Iterator[Term]:
        """A sum's terms without zeros, times a factor; a sum that only sums take is replaced by its terms."""
        for cell, register in terms:
            scaled = self.compute("mul", [factor, self.cell(cell)])
            if scaled == ZERO or self.is_zero(register):
                continue
            operation, *names = self.definition(register)
            alone = register not in self.shared and register not in self.registers
            if alone and operation == "lin" and not names[1]:
                yield from self._terms(names[2], scaled)
            else:
                yield scaled, str(self.register(register))


def _simplified(operation: str, taken: Sequence[str]) -> str | None:
    """The cell that the result of an operation on cells equals; None where it has to be computed."""
    first, second = taken[0], taken[-1]
    match operation:
        case "set":
            return first
        case "add" if ZERO in taken:
            return second if first == ZERO else first
        case "sub" if second == ZERO:
            return first
        case "sub" if first == second:
            return ZERO
        case "mul" if ZERO in taken:
            return ZERO
        case "mul" if ONE in taken:
            return second if first == ONE else first
        case "div" if ZERO == first or second == ONE:
            return first
        case "neg" if first == ONE:
            return MINUS_ONE
        case "neg" | "abs" if first == ZERO:
            return ZERO
        case "less" if first == second == ZERO:
            return ZERO
        case "select" if first == ZERO:
            return second
        case "select" if taken[1] == second == ZERO:
            return ZERO
    return None


def _instance(rule: Iterable[Any], actual: dict[str, str], base: str, direction: str) -> list[Any]:
    """A rule's operations with the names of one operation in the place of its placeholders.

    ``x'`` is the tangent of what x stands for; other names are made unique.
    """

    def substitute(item: Any) -> Any:
        if not isinstance(item, str):
            return tuple(substitute(x) for x in item)
        if not item or item.startswith("=") or item in actual:
            return actual.get(item, item)
        placeholder = item.removesuffix(PRIME)
        if placeholder in actual:
            return tangent(actual[placeholder], direction)
        return f"{tangent(base, direction)}|{item}"

    instance = []
    for operation, *names in rule:
        actual_names = map(substitute, names)
        instance.append((operation, *actual_names))
    return instance


# --- operations that a program keeps ---------------------------------------------------------------------


def named_in(operation: Operation) -> set[str]:
    """The cells and registers that an operation takes, except the registers of a sum."""
    if operation[0] != "lin":
        return {*operation[1:]}
    _, constant, terms = operation
    return {constant, *(cell for cell, _ in terms)}


def needed(operations: Iterable[tuple[Operation, tuple[str, ...]]], wanted: Iterable[str]) -> Operations:
    """The operations on which the results ``wanted`` depend, in order."""
    pending = set(wanted)
    selected = Operations()
    for operation, results in reversed(list(operations)):
        if pending.isdisjoint(results):
            continue
        selected.append((operation, results))
        kind, *taken = operation
        if kind == "lin":
            taken = [register for _, register in taken[-1]]
        pending.update(taken)
    return selected[::-1]


def places_of(operations: Operations, kept: list[str]) -> dict[str, int]:
    """Place of each cell: kept ones in their order, the others reuse free places."""
    place = {name: k for k, name in enumerate(kept)}
    last_use = dict[str, int]()
    for k, (operation, _) in enumerate(operations):
        for name in operation[1:]:
            last_use[name] = k
    first_scratch = len(kept)
    end = first_scratch
    free = list[int]()
    for k, (operation, (result,)) in enumerate(operations):
        done = {place[name] for name in operation[1:] if last_use[name] == k}
        scratch = [cell for cell in done if cell >= first_scratch]
        free += sorted(scratch, reverse=True)
        if result in place:
            continue
        if free:
            place[result] = free.pop()
            continue
        place[result] = end
        end += 1
    return place
