"""Ordered operations from definitions by name, each performed once, without operations that are identically zero.

Equal operations are computed once, and sums of sums are flattened.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import product
from typing import NamedTuple

from derive.flow.layout import ROLES
from derive.flow.link.definitions import ONE, ZERO, Definitions, Names, OnCells
from derive.flow.lowering import OnSeries

EVENTS = ("normal", "upright")  # registers whose roots are lift-off, and an upright chord
# Cells that the integrator reads, by role: drive, size of its terms, normal force, components of the weight.
OUTPUT_CELLS = {
    "cell_drive": "drive",
    "cell_drive_scale": "drive_scale",
    "cell_normal0": "normal_0",
    "cell_driving_moment": "driving_moment_0",
    "cell_normal_load": "normal_load_0",
    "cell_normal_load_slope": "normal_load_slope_0",
    "cell_driving_moment_slope": "driving_moment_slope_0",
    "cell_driving": "driving_0",
    "cell_resisting": "resisting_0",
    "cell_mu": "mu_0",
    "cell_limit": "limit",
    "cell_pace": "pace",
}
# Sums of which phases have a closed form, with the roles of their constants, and registers by their names in roles.
CONSTANTS = {"net": "cell_drive", "normal": "cell_normal0", "upright": "cell_normal_load"}
FACTORS = {"sin(x)": "sine", "vers(x)": "vers", "omega*omega": "square"}


class Linked(NamedTuple):
    """Operations of a program in order, with their results, and the names of the required registers and cells."""

    scalar: list[tuple[OnCells, str]]
    series: list[OnSeries]
    registers: Mapping[str, str | None]  # required registers by name; None for an event that never happens
    outputs: Mapping[str, str]  # cells by role
    constants: list[str]


def link(definitions: Definitions, given: Iterable[str], asked: Names) -> Linked:
    """Return the operations that compute the integrator's input, and the registers ``asked``, from given cells."""
    arguments = [table.argument for table in definitions.tables]
    read = dict.fromkeys((*definitions.states, *definitions.states.values(), *EVENTS, *arguments, *asked))
    linker = Linker(definitions, given)
    linker.mark_shared(read)
    registers = {name: linker.register(name) for name in read}
    for name in registers:
        if name in EVENTS and name not in asked:
            registers[name] = linker.event(registers[name])
        elif registers[name] is None:  # the integrator reads it, although it is zero
            registers[name] = linker.zero(name)
    outputs = {role: linker.cell(name) for role, name in OUTPUT_CELLS.items() if name in definitions.cells}
    parts = linker.parts()
    if len(definitions.states) == 2 and len(parts) == len(definitions.tables):
        outputs |= linker.closed_form(registers, outputs, parts)
    pending = {*definitions.states, *registers.values(), *outputs.values()}
    scalar, series = linker.needed(pending)
    constants = sorted(name for name in pending if name and name.startswith("="))
    return Linked(scalar, series, registers, outputs, constants)


def squares_omega(operation: OnSeries) -> bool:
    """Return whether an operation squares omega. It precedes all others."""
    return operation.kind == "sqr" and operation.registers == ("omega",)


class Linker:
    """Collector of the operations that compute cells and registers.

    Attributes
    ----------
    scalar : dict
        Names of the results of operations on cells.
    series : dict
        Operations on series, by the same without results.
    """

    def __init__(self, definitions: Definitions, given: Iterable[str]) -> None:
        self.scalar: dict[OnCells, str] = {}
        self.series: dict[OnSeries, OnSeries] = {}
        self._definitions = definitions
        self._shared: set[str] = set()  # registers used by operations other than sums
        # Names under which cells and registers are computed; None for a register that is zero.
        self._cells = {name: name for name in given}
        self._registers: dict[str, str | None] = {name: name for name in definitions.variables}

    def needed(self, pending: set[str | None]) -> tuple[list[tuple[OnCells, str]], list[OnSeries]]:
        """Return the operations on which pending results depend, in order. Their operands become pending, too."""
        series = list[OnSeries]()
        for operation in reversed(self.series.values()):
            if not pending.isdisjoint(operation.results):
                series.insert(0, operation)
                pending.update(operation.registers, operation.cells)
        scalar = list[tuple[OnCells, str]]()
        for on_cells, result in reversed(self.scalar.items()):
            if result in pending:
                scalar.insert(0, (on_cells, result))
                pending.update(on_cells[1:])
        return scalar, series

    # --- cells -------------------------------------------------------------------------------------------------------

    def cell(self, name: str) -> str:
        """Return the name of the cell that contains the number ``name``, after adding operations that compute it."""
        if name.startswith("="):
            return name
        if name not in self._cells:
            kind, *arguments = self._definitions.cells[name]
            operands = [self.cell(argument) for argument in arguments]
            self._cells[name] = self._result(kind, operands, name)
        return self._cells[name]

    def _result(self, kind: str, operands: list[str], name: str = "") -> str:
        """Return the cell of an operation's result: an operand, an existing cell, or a new cell called ``name``."""
        known = _simplified(kind, operands)
        if known is not None:
            return known
        number = len(self.scalar)
        return self.scalar.setdefault((kind, *operands), name or f"cell{number}")

    # --- registers ---------------------------------------------------------------------------------------------------

    def _definition(self, name: str) -> OnSeries:
        """Return the definition of a register. Without a definition it is an empty sum."""
        return self._definitions.series.get(name, OnSeries("lin", (name,), (), (ZERO,)))

    def _computed(self, operation: OnSeries) -> Names:
        """Return the results of an operation on series, or of an equal one that exists."""
        return self.series.setdefault(operation._replace(results=()), operation).results

    def mark_shared(self, read: Iterable[str]) -> None:
        """Mark registers that are read, or used by operations other than sums. Sums among them are not flattened."""
        pending = list(read)
        self._shared.update(pending)
        seen = set(self._registers)
        while pending:
            name = pending.pop()
            if name in seen or self._is_zero(name):
                continue
            seen.add(name)
            operation = self._definition(name)
            pending += operation.registers
            if operation.kind != "lin":
                self._shared.update(operation.registers)

    def _is_zero(self, name: str) -> bool:
        """Return whether a register is identically zero, an operation on zero or a sum of zeros."""
        if name in self._registers:
            return self._registers[name] is None
        kind, _, registers, cells = self._definition(name)
        if kind == "lin":
            constant, *factors = cells
            terms = zip(factors, registers, strict=True)
            zero = all(self.cell(cell) == ZERO or self._is_zero(register) for cell, register in terms)
            zero = zero and self.cell(constant) == ZERO
        else:
            zero = any(map(self._is_zero, registers))
        if zero:
            self._registers[name] = None
        return zero

    def register(self, name: str) -> str | None:
        """Return the register for a name, computed if necessary, or None if it is zero."""
        if not self._is_zero(name) and name not in self._registers:
            operation = self._definition(name)
            if operation.kind == "lin":
                self._registers[name] = self._sum(name, operation)
            else:
                registers = tuple(str(self.register(operand)) for operand in operation.registers)
                results = self._computed(operation._replace(registers=registers))
                self._registers[name] = results[operation.results.index(name)]
        return self._registers[name]

    def event(self, register: str | None) -> str | None:
        """Return a register whose roots are events, or None if it is None or constant during a phase."""
        operation = self._made_by(str(register))
        return None if operation.kind == "lin" and not operation.registers else register

    def parts(self) -> dict[str, str]:
        """Return the registers that follow tables in sums with a closed form, with their names in roles.

        They are the register that a table of slip adds to friction, and the only function of time.
        """
        register = str(self.register("dmu"))
        cells = {*self._made_by(register).cells[1:]}
        tables = self._definitions.tables
        of_slip = [{*table.coefficients} for table in tables if table.kind == "slip"]
        of_time = [table.argument for table in tables if table.kind == "time"]
        losses = {register: "loss"} if cells in of_slip else {}
        return losses | (dict.fromkeys(of_time, "record") if len(of_time) == 1 else {})

    def closed_form(
        self, registers: Mapping[str, str | None], outputs: dict[str, str], parts: dict[str, str]
    ) -> dict[str, str]:
        """Return the factors of sin(x), 1 - cos(x) and omega^2 in net moment, normal force and dip by role, if any.

        The net moment may also contain exp(a x) - 1, 1/(1 + a x) - 1, or a register in ``parts``, called loss, and its
        products with these, or one called record and its products with sin(x) and 1 - cos(x). There are no factors if
        other registers or products occur in these sums, or no sine.
        """
        cells = dict[str, str]()
        names = FACTORS | parts
        for operation in self.series.values():
            if operation.kind in ("exp", "rec"):
                argument = self._made_by(operation.registers[-1])
                if argument.registers == ("x",) and not cells:
                    names[operation.results[1]] = "loss"
                    rate = argument.cells[1]
                    cells["cell_loss_rate"] = rate
                    if operation.kind == "rec":
                        cells = {"cell_loss_rate": self._result("neg", [rate]), "cell_per_pole": rate}
        for name, constant in CONSTANTS.items():
            factors = {role: ZERO for role in ROLES if role.startswith(f"cell_{name}")}
            for each, cell in self._products(str(registers[name]), names):
                role = "_".join(("cell", name, *sorted(names.get(x, x) for x in each)))
                factors[role] = self._result("add", [factors.get(role, ZERO), cell])
            start = factors.pop(f"cell_{name}", ZERO)
            if start != outputs[constant] or factors[f"cell_{name}_sine"] == ZERO or factors.keys() - {*ROLES}:
                return {}
            cells = factors | cells | outputs
        return cells

    def _made_by(self, register: str) -> OnSeries:
        """Return the operation that computes a register. The operation of a state has no operands."""
        operations = self.series.values()
        return next((made for made in operations if register in made.results), OnSeries("", (), ()))

    def _products(self, register: str, units: Mapping[str, str]) -> Iterator[tuple[Names, str]]:
        """Yield a register as a sum of products of other registers, each with the cell of its factor.

        Sums among ``units`` are not expanded.
        """
        operation = self._made_by(register)
        match operation.kind:
            case "lin" if register not in units:
                yield (), operation.cells[0]
                for operand, cell in zip(operation.registers, operation.cells[1:], strict=True):
                    for names, factor in self._products(operand, units):
                        yield names, self._result("mul", [cell, factor])
            case "mul":
                one, other = operation.registers
                for (a, x), (b, y) in product(self._products(one, units), self._products(other, units)):
                    yield a + b, self._result("mul", [x, y])
            case _:
                yield (register,), ONE

    def zero(self, name: str) -> str:
        """Return a register that contains zero; it is called ``name`` if there is none yet."""
        (zero,) = self._computed(OnSeries("lin", (name,), (), (ZERO,)))
        return str(zero)

    def _sum(self, name: str, operation: OnSeries) -> str:
        """Return the register of a sum, in which each register occurs once."""
        start = self.cell(operation.cells[0])
        factors: dict[str, str] = {}
        for cell, register in self._flat(operation, ONE):
            before = factors.get(register, ZERO)
            factors[register] = self._result("add", [before, cell])
        if start == ZERO and list(factors.values()) == [ONE]:
            (register,) = factors
            return register
        in_order = sorted(factors)  # sums with permuted terms are equal
        cells = (start, *(factors[register] for register in in_order))
        (result,) = self._computed(OnSeries("lin", (name,), tuple(in_order), cells))
        return str(result)

    def _flat(self, operation: OnSeries, factor: str) -> Iterator[tuple[str, str]]:
        """Yield the nonzero terms of a sum as pairs (factor, register), each times the cell ``factor``.

        A sum used only by sums is replaced by its terms.
        """
        for cell, register in zip(operation.cells[1:], operation.registers, strict=True):
            scaled = self._result("mul", [factor, self.cell(cell)])
            if scaled == ZERO or self._is_zero(register):
                continue
            inner = self._definition(register)
            kept = register in self._shared or register in self._registers
            if inner.kind == "lin" and inner.cells[0] == ZERO and not kept:  # a constant is not a term
                yield from self._flat(inner, scaled)
            else:
                yield scaled, str(self.register(register))


def _simplified(kind: str, operands: list[str]) -> str | None:
    """Return the cell that equals the result of an operation on these operands, or None if it must be computed."""
    first, last = operands[0], operands[-1]
    match kind:
        case "set":
            return first
        case "add" if ZERO in operands:
            return last if first == ZERO else first
        case "sub" if last == ZERO:
            return first
        case "mul" if ZERO in operands:
            return ZERO
        case "mul" if ONE in operands:
            return last if first == ONE else first
        case "sub" | "less" if first == last:
            return ZERO
        case "div" | "neg" | "abs" if first == ZERO:
            return ZERO
        case "div" if last == ONE:
            return first
        case "select" if first == ZERO:
            return last
        case "select" if operands[1] == last == ZERO:
            return ZERO
    return None
