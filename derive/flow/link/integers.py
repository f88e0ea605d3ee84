"""Programs as integers, the form that the compiled integrator and the page's integrator read."""

from itertools import chain
from typing import Any

from derive.flow.layout import KINDS, ROLES, STRIDE
from derive.flow.link.program import Program
from derive.flow.lowering import OnSeries
from derive.flow.recurrences import SCALAR, SERIES


def integers_of(program: Program) -> list[int]:
    """Return the integers that describe a program to the C integrator.

    They are its sizes, roles, operations on cells, operations on series, states and tables, in this order.
    """
    series, later = ([*chain.from_iterable(map(encoded, operations))] for operations in program.split)
    scalar = list[int]()
    for kind, *names in program.scalar:
        scalar += [SCALAR[kind], *names]
    sizes = [
        len(program.cells),
        program.given,  # inputs; at the start a lane needs no other cells except constants
        len(program.registers),
        len(program.states),
        len(program.tables),
        len(scalar),
        len(series),
        len(later),
        int(program.autonomous),
        program.by_rotation,
    ]
    places = {name: program.roles.get(name, -1) for name in ROLES}
    roles = [place if name.startswith("cell_") else _begin(place) for name, place in places.items()]
    integers = [*sizes, *roles, *scalar, *series, *later]
    for cell, register, rate in program.states:
        integers += [cell, _begin(register), _begin(rate)]
    for table in program.tables:
        integers += [KINDS.index(table.kind), _begin(table.register), table.cells, table.degree]
    return integers


def _begin(register: int) -> int:
    """Return the index of the first coefficient of a register in the array of all coefficients, -1 without a register.

    ``register`` is its number in the program, negative if the program does not have it.
    """
    return -1 if register < 0 else register * STRIDE


def encoded(operation: OnSeries) -> list[Any]:
    """Return an operation on series as integers. A sum also contains the number of its terms."""
    kind, results, registers, cells = operation
    count = [len(registers)] if kind == "lin" else []
    return [SERIES[kind], *count, *map(_begin, (*results, *registers)), *cells]
