"""Flow programs: operations on the cells and registers of a lane, and those that the integrator reads."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.flow import FRAGMENTS
from generated.layout import CELLS
from slipcircle.base.kinds import Floats, Names
from slipcircle.core.program.definitions import ZERO, DeclaredTable, Definitions, definitions_of
from slipcircle.core.program.linker import EVENTS, Linked, link

Log = list[tuple[int, float, float, float]]  # events: kind, time, rotation, direction


class Samples(NamedTuple):
    """States at sample times, filled during the integration: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


class Table(NamedTuple):
    """A piecewise function as a program knows it: what of, the register of its argument (or, of time, of its
    increment), the first of its cells, and the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


@dataclass(frozen=True, eq=False)
class Program:
    """Cells and registers by name, operations on cells and on series by their indices, and who plays which role.

    The first ``given`` cells are set at the start of a lane, the next ones computed where a phase begins; then follow
    ``constants``, by name.
    Operations are a kind, the results, then registers and then cells, or a table; a sum has the cell of its constant,
    -1 for zero, and its (cell, register). ``states`` are (cell, register, register of the rate).
    """

    cells: Names
    given: int
    registers: Names
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[tuple[Any, ...], ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    autonomous: int  # between breaks in time d(omega)/dt depends on nothing but time: 2; or but omega: 1; otherwise 0
    constants: Mapping[str, float]

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Where the cells are, by name."""
        return {name: k for k, name in enumerate(self.cells)}

    def blank(self, lanes: int) -> NDArray[np.float64]:
        """Cells of lanes with the constants of the program, otherwise zero."""
        cells = np.zeros((len(self.cells), lanes))
        for name, value in self.constants.items():
            cells[self.places[name]] = value
        return cells


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
    further = tuple(name for name in outputs if name in FRAGMENTS)
    asked = tuple(name for name in outputs if name not in FRAGMENTS)
    definitions = definitions_of(effects, laws, moving, absent, further)
    given = tuple(dict.fromkeys((*CELLS, *definitions.inputs, *definitions.moving)))  # x and omega are among both
    linked = link(definitions, given, asked)
    return _Encoder(definitions, linked, given).program(asked)


class _Encoder:
    """Writes a program with places of cells and registers instead of their names."""

    def __init__(self, definitions: Definitions, linked: Linked, given: Names) -> None:
        self._definitions = definitions
        self._linked = linked
        self._given = given
        computed = [result for _, (result,) in linked.scalar]
        self._constants = sorted(_constants(linked))
        cells = (*given, *computed, *self._constants)
        self._cells = {name: k for k, name in enumerate(cells)}
        registers = [*definitions.states]
        for _, results in linked.series:
            registers += results
        self._registers = {name: k for k, name in enumerate(registers)}

    def program(self, asked: Names) -> Program:
        """The whole program; the registers ``asked`` for have roles, too."""
        taken = set[str]()
        for operation, _ in self._linked.series:
            taken.update(operation.registers)
        states = self._definitions.states
        still = "omega" not in taken and all(table.kind == "time" for table in self._definitions.tables)
        return Program(
            cells=tuple(self._cells),
            given=len(self._given),
            registers=tuple(self._registers),
            scalar=tuple(self._on_cells()),
            series=tuple(self._on_series()),
            states=tuple(
                (self._cells[state], self._registers[state], self._read(rate)) for state, rate in states.items()
            ),
            tables=tuple(map(self._table, self._definitions.tables)),
            roles=self._roles(asked),
            autonomous=(len(states) == 2 and "x" not in taken) * (1 + still),
            constants={name: float(name[1:]) for name in self._constants},
        )

    def _on_cells(self) -> Iterator[tuple[Any, ...]]:
        """Operations on cells: their results, then their arguments."""
        for (kind, *names), (result,) in self._linked.scalar:
            arguments = [self._cells[name] for name in names]
            yield kind, self._cells[result], *arguments

    def _on_series(self) -> Iterator[tuple[Any, ...]]:
        """Operations on series: their results, then registers, then cells or the table."""
        tables = [table.name for table in self._definitions.tables]
        for operation, results in self._linked.series:
            made = [self._registers[name] for name in results]
            registers = [self._registers[name] for name in operation.registers]
            if operation.kind == "ramp":
                number = tables.index(operation.table)
                yield operation.kind, *made, number
            elif operation.kind == "lin":
                yield operation.kind, *made, *self._sum(registers, *operation.cells)
            else:
                cells = [self._cells[name] for name in operation.cells]
                yield operation.kind, *made, *registers, *cells

    def _sum(self, registers: list[int], constant: str, *factors: str) -> tuple[Any, ...]:
        """The cell of a sum's constant, and its terms in the order in which their registers are ready.

        So a sum waits for the last one only.
        """
        start = -1 if constant == ZERO else self._cells[constant]
        cells = [self._cells[name] for name in factors]
        in_order = sorted(zip(registers, cells, strict=True))
        return start, tuple((cell, register) for register, cell in in_order)

    def _roles(self, asked: Names) -> dict[str, int]:
        """The places of the registers and cells that the integrator reads."""
        roles = {name: self._read(name) for name in ("x", "omega", "net", *EVENTS, *asked)}
        for role, name in self._linked.outputs.items():
            roles[role] = self._cells[name]
        return roles

    def _table(self, table: DeclaredTable) -> Table:
        first_cell = self._cells[table.cells[0]]
        return Table(table.name, table.kind, self._read(table.argument), first_cell, table.degree)

    def _read(self, name: str) -> int:
        """The place of the register that holds what is read; -1 if there is none."""
        register = self._linked.registers[name]
        return -1 if register is None else self._registers[register]


def _constants(linked: Linked) -> set[str]:
    """The constants that operations take, or that are read."""
    used = {*linked.outputs.values()}
    for (_, *arguments), _ in linked.scalar:
        used.update(arguments)
    for operation, _ in linked.series:
        used.update(operation.cells)
    return {name for name in used if name.startswith("=")}
