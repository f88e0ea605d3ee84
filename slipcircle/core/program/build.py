"""From the fragments of a scene's effects and friction law to its flow program, in five passes.

1. `Declarations` collects the definitions of the fragments in `generated.flow`, and sums the terms of the balance.
2. `resolve` goes from the outputs back to the operations on which they depend; what is zero is not computed.
3. `select` keeps the operations that are needed, in order.
4. `allocate` assigns a place to each cell.
5. `encode` writes the operations with places instead of names.
"""

from collections.abc import Iterable
from functools import lru_cache
from typing import Any

from generated.flow import FRAGMENTS
from generated.layout import CELLS
from slipcircle.base.kinds import Names
from slipcircle.core.program.declare import Declarations, TableDeclaration
from slipcircle.core.program.link import ZERO, Operation, Operations, Term, named_in, needed
from slipcircle.core.program.program import OUTPUT_CELLS, READ_REGISTERS, Program, Table


@lru_cache(maxsize=256)
def build_program(effects: Names, laws: Names, moving: Names = (), absent: Names = (), outputs: Names = ()) -> Program:
    """The program of a scene.

    Parameters
    ----------
    effects : tuple of str
        Names, as in `generated.effects.EFFECTS`.
    laws : tuple of str
        The friction law, as in `generated.effects.LAWS` or "callable", or the laws of soils, ``linear#0``; then the law
        of speed that multiplies it, if any.
    moving : tuple of str
        Symbols of parameters that are functions of time, or of the rotation.
    absent : tuple of str
        Symbols of optional parameters that a scene does not set; their terms are not included.
    outputs : tuple of str
        Further outputs: registers, such as ``mu``, ``pressing`` or ``friction``, and "energy" for the states
        ``work`` and ``dissipation``.

    Returns
    -------
    Program
    """
    fragments = list[str]()
    registers = list[str]()
    for name in outputs:
        kind = fragments if name in FRAGMENTS else registers
        kind.append(name)
    builder = _Builder(tuple(registers))
    builder.declare_laws(laws)
    builder.declare_effects(effects, moving, absent)
    builder.declare_functions_of_time(moving)
    builder.declare_balance(effects, laws, tuple(fragments), absent)
    builder.resolve()
    builder.select()
    builder.allocate()
    return builder.encode()


class _Builder(Declarations):
    """A program in construction; each pass adds attributes for the next ones.

    Attributes
    ----------
    registers : dict of str
        Register that holds each of the outputs; None where that is zero or constant.
    outputs : dict of str
        Cell that holds each of `OUTPUT_CELLS`.
    scalar, series : list
        Operations that are needed, with their results.
    place, at : dict of int
        Place of each cell, and of each register.
    """

    # --- 2. from outputs back to operations --------------------------------------------------------------------------

    def resolve(self) -> None:
        """Find the registers and cells that hold what the integrator reads."""
        self._fix_cells()
        link = self.link
        arguments = [table.argument for table in self.tables]
        roots = dict.fromkeys((*self.states, *self.states.values(), *READ_REGISTERS, *arguments, *self.extra))
        link.mark_shared(roots)
        self.registers: dict[str, str | None] = {}
        for name in roots:
            self.registers[name] = link.register(name)
        self._drop_constants()
        self._hold_zeros()
        self.outputs: dict[str, str] = {}
        for name in OUTPUT_CELLS.values():
            self.outputs[name] = link.cell(name)

    def _fix_cells(self) -> None:
        """Name the cells that are set at the start of a lane, in order, and define those that depend on them alone."""
        link = self.link
        table_cells = list[str]()
        for table in self.tables:
            table_cells += table.cells
        fixed = (*CELLS, *self.states, *self.inputs, *table_cells)
        self.fixed = list(dict.fromkeys(fixed))
        for name in self.fixed:
            link.cells[name] = name
        for state in self.states:
            link.registers[state] = state
        moving = {*self.states, *table_cells}
        link.cell_definitions["departed"] = self._departed(moving)

    def _departed(self, moving: set[str]) -> Operation:
        """The cell that is zero as long as the limit friction is the initial one, as its arguments have not changed.

        It is the time, the slip or the rotation, whichever suffices.
        """
        origins = self.link.origins(("driving_0", "resisting_0", "normal_0"))
        if origins & moving:
            return ("set", "TIME")
        if "SLIP" in origins:
            return ("set", "SLIP")
        if "ROTATION" in origins:
            return ("abs", "ROTATION")
        return ("set", ZERO)

    def _drop_constants(self) -> None:
        """A normal force or an overturning moment that is constant during a phase has no events."""
        constant = set[str]()
        for operation, results in self.link.series.items():
            kind = operation[0]
            terms = operation[-1]
            if kind == "lin" and not terms:
                constant.update(results)
        for name in READ_REGISTERS[1:]:
            register = self.registers[name]
            if register in constant and name not in self.extra:
                self.registers[name] = None

    def _hold_zeros(self) -> None:
        """Rates of states and requested registers need a register even where they are zero."""
        rates = self.states.values()
        for name in (*rates, *self.extra):
            if self.registers[name] is None:
                zero = self.link.zero_register(name)
                self.registers[name] = zero

    # --- 3. the operations that are needed ---------------------------------------------------------------------------

    def select(self) -> None:
        """Keep the operations on series on which outputs depend, and those on cells on which these depend."""
        link = self.link
        outputs = set(self.states)
        for register in self.registers.values():
            if register is not None:
                outputs.add(register)
        series = link.series.items()
        self.series = needed(series, outputs)
        self.lasting = set(self.outputs.values())
        for operation, _ in self.series:
            self.lasting |= named_in(operation)
        scalar = Operations()
        for operation, result in link.scalar.items():
            scalar.append((operation, (result,)))
        self.scalar = needed(scalar, self.lasting)

    # --- 4. places ---------------------------------------------------------------------------------------------------

    def allocate(self) -> None:
        """Assign places to cells: those that are set, those that are computed, constants."""
        used = set(self.lasting)
        for operation, _ in self.scalar:
            used.update(operation[1:])
        self.constants = sorted(name for name in used if name.startswith("="))
        computed = [result for _, (result,) in self.scalar]
        self.cells = (*self.fixed, *computed, *self.constants)
        self.place = {name: k for k, name in enumerate(self.cells)}

    # --- 5. names to places ------------------------------------------------------------------------------------------

    def encode(self) -> Program:
        """The program, in places of cells and registers."""
        registers = list(self.states)
        for _, results in self.series:
            registers += results
        places = range(len(registers))
        self.at = dict(zip(registers, places, strict=True))
        self.operand = self.place | self.at
        states = list[tuple[int, int, int]]()
        for state, rate in self.states.items():
            cell = self.place[state]
            register = self.at[state]
            states.append((cell, register, self._register(rate)))
        scalar = list[tuple[Any, ...]]()
        for operation, (result,) in self.scalar:
            encoded = self._encoded_scalar(operation, result)
            scalar.append(encoded)
        series = list[tuple[Any, ...]]()
        for operation, results in self.series:
            encoded = self._encoded(operation, results)
            series.append(encoded)
        tables = map(self._table, self.tables)
        return Program(
            cells=self.cells,
            given=len(self.fixed),
            registers=tuple(registers),
            scalar=tuple(scalar),
            series=tuple(series),
            states=tuple(states),
            tables=tuple(tables),
            roles=self._roles(),
            constants={name: float(name[1:]) for name in self.constants},
        )

    def _table(self, table: TableDeclaration) -> Table:
        """A table with the places of its argument and of its first cell."""
        first_cell = f"{table.name}.PIECE"
        return Table(
            name=table.name,
            kind=table.kind,
            register=self._register(table.argument),
            cells=self.place[first_cell],
            degree=table.degree,
        )

    def _roles(self) -> dict[str, int]:
        """The places of the registers and cells that the integrator reads."""
        roles = dict[str, int]()
        for name in ("x", "omega", *READ_REGISTERS, *self.extra):
            roles[name] = self._register(name)
        for role, name in OUTPUT_CELLS.items():
            cell = self.outputs[name]
            roles[role] = self.place[cell]
        return roles

    def _register(self, name: str) -> int:
        """The place of the register that holds a quantity; -1 if there is none."""
        register = self.registers.get(name, name)
        if register is None:
            return -1
        return self.at.get(register, -1)

    def _encoded_scalar(self, operation: Operation, result: str) -> tuple[Any, ...]:
        """An operation on cells: its result, then its arguments."""
        kind, *names = operation
        arguments = [self.place[name] for name in names]
        made = self.place[result]
        return (kind, made, *arguments)

    def _encoded(self, operation: Operation, results: Names) -> tuple[Any, ...]:
        """An operation on series: its results first, then registers, cells or a table."""
        kind, *names = operation
        made = [self.at[register] for register in results]
        if kind == "lin":
            constant, terms = names
            encoded = self._encoded_sum(constant, terms)
            return (kind, *made, *encoded)
        if kind == "ramp":
            table_arguments = [table.argument for table in self.tables]
            (increment,) = names
            table = table_arguments.index(increment)
            return (kind, *made, table)
        operands = [self.operand[name] for name in names]
        return (kind, *made, *operands)

    def _encoded_sum(self, constant: str, terms: Iterable[Term]) -> tuple[Any, ...]:
        """A sum: the cell of its constant, -1 if that is zero, and its terms.

        Terms are in the order in which their registers are ready, so that a sum waits for the last one only.
        """
        start = -1
        if constant != ZERO:
            start = self.place[constant]
        encoded = [(self.at[register], self.place[cell]) for cell, register in terms]
        return start, tuple((cell, register) for register, cell in sorted(encoded))
