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
from slipcircle.core.flow.declare import Declarations, TableDeclaration
from slipcircle.core.flow.link import PRIME, ZERO, Operation, named_in, needed, places_of, tangent
from slipcircle.core.flow.program import OUTPUT_CELLS, READ_REGISTERS, Program, Table, Tangent


@lru_cache(maxsize=256)
def build_program(
    effects: tuple[str, ...],
    laws: tuple[str, ...],
    moving: tuple[str, ...] = (),
    absent: tuple[str, ...] = (),
    outputs: tuple[str, ...] = (),
    directions: int = 0,
) -> Program:
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
    directions : int
        Number of derivatives that the program computes: `Program.tangents`.

    Returns
    -------
    Program
    """
    fragments = tuple(name for name in outputs if name in FRAGMENTS)
    registers = tuple(name for name in outputs if name not in FRAGMENTS)
    builder = _Builder(registers, directions)
    builder.declare_laws(laws)
    builder.declare_effects(effects, moving, absent)
    builder.declare_functions_of_time(moving)
    builder.declare_balance(effects, laws, fragments, absent)
    builder.resolve()
    builder.select()
    builder.allocate()
    return builder.encode()


class _Builder(Declarations):
    """A program in construction; each pass adds attributes for the next ones.

    Attributes
    ----------
    read : list of str
        Registers that the integrator reads.
    varied : list of str
        Cells whose tangents the program computes.
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
        self.read = [*self.rates, *self.rates.values(), *READ_REGISTERS]
        self.read += [table.argument for table in self.tables]
        tangents = self._in_directions(self.read)
        roots = dict.fromkeys([*self.read, *self.extra, *tangents])
        link.mark_shared(roots)
        self.registers = {name: link.register(name) for name in roots}
        self._drop_constants()
        for name in (*self.states.values(), *self.extra):
            if self.registers[name] is None:
                self.registers[name] = link.zero_register(name)
        names = [*OUTPUT_CELLS.values(), *self._in_directions(["drive"])]
        self.outputs = {name: link.cell(name) for name in names}

    def _fix_cells(self) -> None:
        """Name the cells that are set at the start of a lane, in order, and define those that depend on them alone."""
        link = self.link
        table_cells = list[str]()
        self.varied = [*self.rates, "ROTATION", "SLIP", *self.inputs]
        for table in self.tables:
            table_cells += table.cells
            self.varied += table.varied
        tangents = self._in_directions(self.varied)
        fixed = (*CELLS, *self.rates, *self.inputs, *table_cells, *tangents)
        self.fixed = list(dict.fromkeys(fixed))
        link.cells.update(zip(self.fixed, self.fixed, strict=True))
        link.registers.update(zip(self.states, self.states, strict=True))
        for j in self.directions:
            initial_limit = tangent("LIMIT", j)
            link.cell_definitions[initial_limit] = ("set", tangent("limit_0", j))
        link.cell_definitions["departed"] = self._departed({*self.states, *table_cells})

    def _in_directions(self, names: Iterable[str]) -> list[str]:
        """The tangents of names, direction by direction."""
        names = list(names)
        tangents = list[str]()
        for j in self.directions:
            tangents += [tangent(name, j) for name in names]
        return tangents

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
            terms = operation[-1]
            if operation[0] == "lin" and not terms:
                constant.update(results)
        for name in READ_REGISTERS[1:]:
            if self.registers[name] in constant and name not in self.extra:
                self.registers[name] = None

    # --- 3. the operations that are needed ---------------------------------------------------------------------------

    def select(self) -> None:
        """Keep the operations on series on which outputs depend, and those on cells on which these depend."""
        outputs = {register for register in self.registers.values() if register}
        self.series = needed(self.link.series.items(), outputs | {*self.states})
        self.lasting = {*self.outputs.values()}
        for operation, _ in self.series:
            self.lasting |= named_in(operation)
        scalar = [(operation, (result,)) for operation, result in self.link.scalar.items()]
        self.scalar = needed(scalar, self.lasting)

    # --- 4. places ---------------------------------------------------------------------------------------------------

    def allocate(self) -> None:
        """Assign places to lasting cells, then to constants, then to scratch cells, which are reused when free."""
        computed = list[str]()
        used = {*self.lasting}
        for operation, (result,) in self.scalar:
            used.update(operation[1:])
            if result in self.lasting:
                computed.append(result)
        self.constants = sorted(name for name in used if name.startswith("="))
        self.held = [*self.fixed, *computed]
        kept = [*self.held, *self.constants]
        self.place = places_of(self.scalar, kept)
        count = max(self.place.values()) + 1
        scratch = [f"scratch{k}" for k in range(count - len(kept))]
        self.cells = (*kept, *scratch)

    # --- 5. names to places ------------------------------------------------------------------------------------------

    def encode(self) -> Program:
        """The program, in places of cells and registers."""
        registers = list(self.states)
        for _, results in self.series:
            registers += results
        self.at = {name: k for k, name in enumerate(registers)}
        self.operand = self.place | self.at
        states = [(self.place[state], self.at[state], self._register(rate)) for state, rate in self.states.items()]
        return Program(
            cells=self.cells,
            given=len(self.fixed),
            lasting=len(self.held),
            registers=tuple(registers),
            scalar=tuple(self._encoded_scalar(operation, result) for operation, (result,) in self.scalar),
            series=tuple(self._encoded(operation, results) for operation, results in self.series),
            states=tuple(states),
            tables=tuple(map(self._table, self.tables)),
            roles=self._roles(),
            constants={name: float(name[1:]) for name in self.constants},
            tangents=tuple(map(self._tangent, self.directions)),
        )

    def _table(self, table: TableDeclaration) -> Table:
        """A table with the places of its argument and of its first cell."""
        argument = self._register(table.argument)
        first_cell = self.place[f"{table.name}.PIECE"]
        return Table(table.name, table.kind, argument, first_cell, table.degree)

    def _roles(self) -> dict[str, int]:
        """The places of the registers and cells that the integrator reads."""
        registers = ("x", "omega", *READ_REGISTERS, *self.extra)
        roles = {name: self._register(name) for name in registers}
        for role, name in OUTPUT_CELLS.items():
            roles[role] = self.place[self.outputs[name]]
        return roles

    def _encoded_scalar(self, operation: Operation, result: str) -> tuple[Any, ...]:
        """An operation on cells: its result, then its arguments."""
        kind, *taken = operation
        arguments = [self.place[name] for name in taken]
        return (kind, self.place[result], *arguments)

    def _register(self, name: str) -> int:
        """The place of the register that holds a quantity; -1 if there is none."""
        return self.at.get(str(self.registers.get(name, name)), -1)

    def _encoded(self, operation: Operation, results: tuple[str, ...]) -> tuple[Any, ...]:
        """An operation on series: its results first, then registers, cells or a table."""
        kind, *taken = operation
        made = [self.at[register] for register in results]
        if kind == "lin":
            constant, terms = taken
            start = -1 if constant == ZERO else self.place[constant]
            encoded_terms = tuple((self.place[cell], self.at[register]) for cell, register in terms)
            return (kind, *made, start, encoded_terms)
        if kind == "ramp":
            table_arguments = [table.argument for table in self.tables]
            argument = taken[0].partition(PRIME)[0]
            return (kind, *made, table_arguments.index(argument))
        operands = [self.operand[name] for name in taken]
        return (kind, *made, *operands)

    def _tangent(self, direction: int) -> Tangent:
        """Places of the tangents of cells that vary and of registers that are read."""
        place = self.place
        drive = self.outputs["drive"]
        drive_dot = self.outputs[tangent("drive", direction)]
        cells = {place[name]: place[tangent(name, direction)] for name in self.varied}
        cells[place[drive]] = place[drive_dot]
        registers = dict[int, int]()
        for name in self.read:
            register = self._register(name)
            derivative = self._register(tangent(name, direction))
            if register >= 0 and derivative >= 0:
                registers[register] = derivative
        return Tangent(cells, registers)
