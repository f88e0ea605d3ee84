"""Flow programs: operations on the cells and registers of a lane, and the places that the integrator reads."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple, Self

from derive.flow.layout import CELLS
from derive.flow.link.definitions import Definitions, Lookup, Names, Recipe, definitions_of
from derive.flow.link.linker import EVENTS, Linked, link, squares_omega
from derive.flow.lowering import OnSeries

# Functions of slip whose series converge no farther in the rotation than in time, and other arguments of tables.
SHORT = {"exp", "rec", "log", "time", "speed"}


class Table(NamedTuple):
    """Piecewise function in a program.

    ``kind`` is its variable, ``register`` contains its argument (for functions of time its increment), ``cells`` is the
    first of its cells, and ``degree`` the degree of its pieces.
    """

    name: str
    kind: str
    register: int
    cells: int
    degree: int


@dataclass(frozen=True, eq=False)
class Program:
    """Operations on the cells and the registers of a lane by place, and the places that the integrator reads.

    The first ``given`` cells are set at the start of a lane, the following cells are computed at the beginning of a
    phase, and ``constants`` by name are the last. ``states`` are (cell, register, register of the rate). Between breaks
    in time d(omega)/dt depends on time alone if ``autonomous`` is 2, also on omega if it is 1, and on further registers
    if it is 0. Unless ``by_rotation`` is 0, forces depend on the rotation and on omega^2 only, and series may be in
    powers of the rotation, with E = omega^2 in place of omega. If it is 2, the first operation squares omega.
    """

    cells: Names
    given: int
    registers: Names
    scalar: tuple[tuple[Any, ...], ...]
    series: tuple[OnSeries, ...]
    states: tuple[tuple[int, int, int], ...]
    tables: tuple[Table, ...]
    roles: Mapping[str, int]
    autonomous: int
    by_rotation: int
    constants: Mapping[str, float]

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Places of the cells by name."""
        return {name: k for k, name in enumerate(self.cells)}

    @cached_property
    def split(self) -> tuple[list[OnSeries], list[OnSeries]]:
        """Operations on which rates depend, and those that can wait until states are complete."""
        needed = {rate for _, _, rate in self.states} | {self.roles.get("square", -1)}
        rates = list[OnSeries]()
        others = list[OnSeries]()
        for operation in reversed(self.series):
            if needed.isdisjoint(operation.results):
                others.insert(0, operation)
            else:
                needed.update(operation.registers)
                rates.insert(0, operation)
        return rates, others


def build(recipe: Recipe, fragments: Lookup, outputs: Names = (), further: Names = ()) -> Program:
    """Return the program of a recipe and of ``further`` fragments, with roles for the registers ``outputs``."""
    definitions = definitions_of(recipe, fragments, further)
    given = tuple(dict.fromkeys((*CELLS, *definitions.inputs, *definitions.moving)))  # x and omega are in both
    linked = link(definitions, given, outputs)
    return _encoded(definitions, linked, given, outputs)


class _Places(NamedTuple):
    """Places of a program's cells and registers by name."""

    cells: dict[str, int]
    registers: dict[str, int]

    @classmethod
    def of(cls, definitions: Definitions, linked: Linked, given: Names) -> Self:
        """Return numbers for cells (given, computed, constant) and registers (of variables, computed)."""
        computed = [result for _, result in linked.scalar]
        made = chain.from_iterable(operation.results for operation in linked.series)
        every = [*given, *computed, *linked.constants], [*definitions.variables, *made]
        return cls(*({name: place for place, name in enumerate(names)} for names in every))


def _encoded(definitions: Definitions, linked: Linked, given: Names, outputs: Names) -> Program:
    """Return a program with places instead of names, with roles for the registers ``outputs``."""
    places = _Places.of(definitions, linked, given)
    cells = places.cells
    registers = places.registers
    read = {name: registers.get(str(register), -1) for name, register in linked.registers.items()}
    roles = {name: read[name] for name in ("x", "omega", "net", *EVENTS, *outputs)}
    roles |= _roles(linked, places)
    tables = []
    for table in definitions.tables:
        name, kind, argument, degree = table
        tables.append(Table(name, kind, read[argument], cells[table.cells[0]], degree))
    scalar = []
    for (kind, *arguments), result in linked.scalar:
        operands = [cells[argument] for argument in arguments]
        scalar.append((kind, cells[result], *operands))
    states = []
    for state, rate in definitions.states.items():
        states.append((cells[state], registers[state], read[rate]))
    autonomous, by_rotation = _variables(definitions, linked)
    return Program(
        cells=tuple(cells),
        given=len(given),
        registers=tuple(registers),
        scalar=tuple(scalar),
        series=_in_order(linked, places),
        states=tuple(states),
        tables=tuple(tables),
        roles=roles,
        autonomous=autonomous,
        by_rotation=by_rotation,
        constants={name: float(name[1:]) for name in linked.constants},
    )


def _roles(linked: Linked, places: _Places) -> dict[str, int]:
    """Return the places of cells that have roles, and of the square of omega."""
    roles = {}
    for role, name in linked.outputs.items():
        roles[role] = places.cells[name]
    for operation in linked.series:
        if squares_omega(operation):
            roles["square"] = places.registers[operation.results[0]]
    return roles


def _in_order(linked: Linked, places: _Places) -> tuple[OnSeries, ...]:
    """Return the operations on series with places. The square of omega precedes all others."""
    return tuple(_placed(operation, places) for operation in sorted(linked.series, key=squares_omega, reverse=True))


def _placed(operation: OnSeries, places: _Places) -> OnSeries:
    """Return an operation on series with places.

    The terms of a sum are in the order in which their registers become available, so that it waits only for the last.
    """
    results = tuple(places.registers[name] for name in operation.results)
    registers = tuple(places.registers[name] for name in operation.registers)
    cells = tuple(places.cells[name] for name in operation.cells)
    if operation.kind == "lin":
        constant, *factors = cells
        in_order = sorted(zip(registers, factors, strict=True))
        registers = tuple(register for register, _ in in_order)
        cells = (constant, *(factor for _, factor in in_order))
    return OnSeries(operation.kind, results, registers, cells)


def _variables(definitions: Definitions, linked: Linked) -> tuple[int, int]:
    """Return the codes of `Program.autonomous` and of `Program.by_rotation`."""
    others = [operation for operation in linked.series if not squares_omega(operation)]
    squared = len(linked.series) - len(others)
    taken = {register for operation in others for register in operation.registers}
    tables = {table.kind for table in definitions.tables}
    kinds = tables.union(operation.kind for operation in others)
    alone = len(definitions.states) == 2
    still = "omega" not in taken
    autonomous = (alone and "x" not in taken) * (1 + (still and not squared and tables <= {"time"}))
    by_rotation = (alone and "x" in taken and still and kinds.isdisjoint(SHORT)) * (1 + squared)
    return autonomous, by_rotation
