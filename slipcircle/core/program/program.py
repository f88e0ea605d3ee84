"""Flow programs: operations on the cells and registers of a lane, and those that the integrator reads."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import chain
from typing import Any, NamedTuple, Self

from generated.flow import FRAGMENTS
from generated.layout import CELLS, TABLE
from slipcircle.base.kinds import Floats, Names
from slipcircle.core.program.definitions import ZERO, Definitions, OnSeries, Recipe, definitions_of
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


@lru_cache(maxsize=256)
def build_program(recipe: Recipe, outputs: Names = ()) -> Program:
    """The program of a scene.

    ``outputs`` are further ones: registers, such as ``mu``, ``pressing`` or ``friction``, and "energy" for the states
    ``work`` and ``dissipation``.
    """
    further = tuple(name for name in outputs if name in FRAGMENTS)
    asked = tuple(name for name in outputs if name not in FRAGMENTS)
    definitions = definitions_of(recipe, further)
    given = tuple(dict.fromkeys((*CELLS, *definitions.inputs, *definitions.moving)))  # x and omega are among both
    linked = link(definitions, given, asked)
    return _encoded(definitions, linked, given, asked)


class _Places(NamedTuple):
    """Where a program has its cells, its registers and its tables, by name."""

    cells: dict[str, int]
    registers: dict[str, int]
    tables: dict[str, int]

    @classmethod
    def of(cls, definitions: Definitions, linked: Linked, given: Names) -> Self:
        """Cells that are given, computed and constant, and registers of the states and of what is computed."""
        computed = chain.from_iterable(results for _, results in linked.scalar)
        made = chain.from_iterable(results for _, results in linked.series)
        tables = [table.name for table in definitions.tables]
        every = [*given, *computed, *linked.constants], [*definitions.states, *made], tables
        return cls(*({name: place for place, name in enumerate(names)} for names in every))


def _encoded(definitions: Definitions, linked: Linked, given: Names, asked: Names) -> Program:
    """A program with places instead of names; registers ``asked`` for have roles, too."""
    places = _Places.of(definitions, linked, given)
    cells = places.cells
    registers = places.registers
    read = {name: registers.get(str(register), -1) for name, register in linked.registers.items()}
    roles = {name: read[name] for name in ("x", "omega", "net", *EVENTS, *asked)}
    for role, name in linked.outputs.items():
        roles[role] = cells[name]
    tables = []
    for name, kind, argument, degree in definitions.tables:
        first_cell = cells[f"{name}.{TABLE[0]}"]
        tables.append(Table(name, kind, read[argument], first_cell, degree))
    scalar = []
    for (kind, *arguments), (result,) in linked.scalar:
        operands = [cells[argument] for argument in arguments]
        scalar.append((kind, cells[result], *operands))
    states = []
    for state, rate in definitions.states.items():
        states.append((cells[state], registers[state], read[rate]))
    return Program(
        cells=tuple(cells),
        given=len(given),
        registers=tuple(registers),
        scalar=tuple(scalar),
        series=tuple(_on_series(operation, results, places) for operation, results in linked.series),
        states=tuple(states),
        tables=tuple(tables),
        roles=roles,
        autonomous=_autonomous(definitions, linked),
        constants={name: float(name[1:]) for name in linked.constants},
    )


def _on_series(operation: OnSeries, results: Names, places: _Places) -> tuple[Any, ...]:
    """An operation on series: its results, then registers, then cells or the table.

    The terms of a sum are in the order in which their registers are ready, so that it waits for the last one only.
    """
    made = [places.registers[name] for name in results]
    taken = [places.registers[name] for name in operation.registers]
    if operation.kind == "ramp":
        return operation.kind, *made, places.tables[operation.table]
    cells = [places.cells[name] for name in operation.cells]
    if operation.kind != "lin":
        return operation.kind, *made, *taken, *cells
    constant, *factors = cells
    in_order = sorted(zip(taken, factors, strict=True))
    if operation.cells[0] == ZERO:
        constant = -1
    return operation.kind, *made, constant, tuple((cell, register) for register, cell in in_order)


def _autonomous(definitions: Definitions, linked: Linked) -> int:
    """What d(omega)/dt depends on between breaks in time, as `Program` has it."""
    taken = {register for operation, _ in linked.series for register in operation.registers}
    still = "omega" not in taken and all(table.kind == "time" for table in definitions.tables)
    return (len(definitions.states) == 2 and "x" not in taken) * (1 + still)
