"""Linking of a flow program: definitions by name become ordered operations, without those that are identically zero.

A *cell* is a number where a phase begins, a *register* a series in time. Equal operations are computed once, and sums
of sums are flattened.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from slipcircle.base.kinds import Names

Operation = tuple[Any, ...]  # name and arguments; of series (`Linker.series_definitions`) name, results, arguments
WithResults = tuple[Operation, Names]
Operations = list[WithResults]
Term = tuple[str, str]  # of a sum: a cell times a register
RESULTS = {"turn": 2, "exp": 2, "rec": 2, "pow": 2, "powers": 6}  # of operations on series that have more than one
ZERO, ONE = "=0.0", "=1.0"


def results_of(operation: str, names: Sequence[Any]) -> Names:
    """The registers that an operation on series computes, of the names of its results and arguments."""
    count = RESULTS.get(operation, 1)
    return tuple(names[:count])


def arguments(operation: str, names: Sequence[Any]) -> list[str]:
    """The registers that an operation on series takes, of the names of its results and arguments."""
    if operation == "ramp":
        return []
    if operation == "lin":
        terms = names[2]
        return [register for _, register in terms]
    count = RESULTS.get(operation, 1)
    operands = list(names[count:])
    if operation == "pow":
        operands.pop()  # its exponent is a cell
    return operands


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
    series: dict[Operation, Names] = field(default_factory=dict)

    def define_cells(self, operations: Iterable[Any]) -> None:
        """Take definitions of cells: name of the operation, result, arguments."""
        for operation, result, *operands in operations:
            self.cell_definitions[result] = (operation, *operands)

    def define_series(self, operations: Iterable[Any]) -> None:
        """Take definitions of registers: name of the operation, results, arguments."""
        for operation, *names in operations:
            definition = (operation, *names)
            for result in results_of(operation, names):
                self.series_definitions[result] = definition

    # --- cells ---------------------------------------------------------------------------------------------------

    def cell(self, name: str) -> str:
        """The cell that a name stands for, computed if necessary."""
        if name.startswith("="):
            return name
        if name not in self.cells:
            operation, *names = self.cell_definitions[name]
            operands = [self.cell(argument) for argument in names]
            self.cells[name] = self.compute(operation, operands, name)
        return self.cells[name]

    def compute(self, operation: str, operands: list[str], name: str = "") -> str:
        """The cell of an operation's result: a new one, or one that holds it already."""
        known = _simplified(operation, operands)
        if known is not None:
            return known
        result = name
        if not name:
            number = len(self.scalar)
            result = f"cell{number}"
        return self.scalar.setdefault((operation, *operands), result)

    def origins(self, names: Iterable[str]) -> set[str]:
        """The inputs from which some cells are computed."""
        inputs = set[str]()
        pending = [self.cell(name) for name in names]
        operands = dict[str, Names]()
        for (_, *cells), result in self.scalar.items():
            operands[result] = tuple(cells)
        while pending:
            name = pending.pop()
            if name in operands:
                pending += operands.pop(name)
            else:
                inputs.add(name)
        return inputs

    # --- registers -----------------------------------------------------------------------------------------------

    def definition(self, name: str) -> Operation:
        """Definition of a register; without one it is an empty sum."""
        empty_sum = ("lin", name, "", ())
        return self.series_definitions.get(name, empty_sum)

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
            operands = arguments(operation, definition)
            pending += operands
            if operation != "lin":
                self.shared.update(operands)

    def is_zero(self, name: str) -> bool:
        """Whether a register is identically zero: undefined, a product with zero, or a sum of zeros."""
        if name in self.registers:
            return self.registers[name] is None
        operation, *names = self.definition(name)
        if operation == "lin":
            _, constant, terms = names
            zero = all(self._is_zero_product(cell, register) for cell, register in terms)
            if zero and constant:
                zero = self.cell(constant) == ZERO
        else:
            operands = arguments(operation, names)
            zero = any(map(self.is_zero, operands))
        if zero:
            self.registers[name] = None
        return zero

    def _is_zero_product(self, cell: str, register: str) -> bool:
        """Whether a cell or the register that it multiplies is zero."""
        return self.cell(cell) == ZERO or self.is_zero(register)

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
        results = results_of(operation, names)
        operands = [self.register(register) for register in arguments(operation, names)]
        if operation == "pow":
            exponent = self.cell(names[-1])
            operands.append(exponent)
        elif operation == "ramp":
            operands.append(name)
        computed = self.series.setdefault((operation, *operands), results)
        position = results.index(name)
        return computed[position]

    def zero_register(self, name: str) -> str:
        """A register that holds zero, for a requested quantity that is zero."""
        (zero,) = self.series.setdefault(("lin", ZERO, ()), (name,))
        return zero

    def _sum(self, name: str, constant: str, terms: Iterable[Term]) -> str:
        """A constant and cells times registers, each register once."""
        start = ZERO
        if constant:
            start = self.cell(constant)
        factors: dict[str, str] = {}
        for cell, register in self._terms(terms, ONE):
            factor = factors.get(register, ZERO)
            factors[register] = self.compute("add", [factor, cell])
        collected = [(cell, register) for register, cell in factors.items()]
        if start == ZERO and len(collected) == 1:
            factor, register = collected[0]
            if factor == ONE:
                return register
        collected.sort()
        operation = ("lin", start, tuple(collected))
        (result,) = self.series.setdefault(operation, (name,))
        return result

    def _terms(self, terms: Iterable[Term], factor: str) -> Iterator[Term]:
        """A sum's terms without zeros, times a factor; a sum that only sums take is replaced by its terms."""
        for cell, register in terms:
            scaled = self.compute("mul", [factor, self.cell(cell)])
            if scaled == ZERO or self.is_zero(register):
                continue
            inner = self._terms_of_inner_sum(register)
            if inner is None:
                yield scaled, str(self.register(register))
            else:
                yield from self._terms(inner, scaled)

    def _terms_of_inner_sum(self, register: str) -> Iterable[Term] | None:
        """The terms of a sum without a constant that only sums take; None of other registers."""
        operation, *names = self.definition(register)
        if operation != "lin" or register in self.shared or register in self.registers:
            return None
        _, constant, terms = names
        return None if constant else terms


def _simplified(operation: str, operands: Sequence[str]) -> str | None:
    """The cell that the result of an operation on cells equals; None where it has to be computed."""
    first = operands[0]
    second = operands[-1]
    match operation:
        case "set":
            return first
        case "add" if ZERO in operands:
            return second if first == ZERO else first
        case "sub" if second == ZERO:
            return first
        case "sub" if first == second:
            return ZERO
        case "mul" if ZERO in operands:
            return ZERO
        case "mul" if ONE in operands:
            return second if first == ONE else first
        case "div" if ZERO == first or second == ONE:
            return first
        case "neg" | "abs" if first == ZERO:
            return ZERO
        case "less" if first == second == ZERO:
            return ZERO
        case "select" if first == ZERO:
            return second
        case "select" if operands[1] == second == ZERO:
            return ZERO
    return None


# --- operations that a program keeps ---------------------------------------------------------------------------------


def named_in(operation: Operation) -> set[str]:
    """The cells and registers that an operation takes, except the registers of a sum."""
    if operation[0] != "lin":
        return {*operation[1:]}
    _, constant, terms = operation
    cells = {cell for cell, _ in terms}
    return cells | {constant}


def needed(operations: Iterable[WithResults], outputs: Iterable[str]) -> Operations:
    """The operations on which some results depend, in order."""
    pending = set(outputs)
    selected = Operations()
    for operation, results in reversed(list(operations)):
        if pending.isdisjoint(results):
            continue
        selected.append((operation, results))
        kind, *operands = operation
        if kind == "lin":
            _, terms = operands
            operands = [register for _, register in terms]
        pending.update(operands)
    return selected[::-1]
