"""Programs as integers, the form that the compiled integrator and the page's integrator read."""

from collections.abc import Sequence

from derive.flow.layout import KINDS, ROLES, STRIDE
from derive.flow.link.program import Program
from derive.flow.recurrences import SCALAR, SERIES


def integers_of(program: Program) -> list[int]:
    """Return the integers that describe a program to the C integrator.

    They are its sizes, roles, operations on cells, operations on series, states and tables, in this order.
    """
    rates, others = program.split
    series = _encoded_series(program, rates)
    later = _encoded_series(program, others)
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


def _encoded_series(program: Program, chosen: Sequence[int]) -> list[int]:
    """Return operations on series as integers. ``chosen`` are their indices in ``program.series``."""
    code = list[int]()
    for k in chosen:
        kind, *names = program.series[k]
        code.append(SERIES[kind])
        if kind == "lin":
            result, constant, terms = names
            code += [_begin(result), constant, len(terms)]
            for cell, register in terms:
                code += [cell, _begin(register)]
        elif kind in ("pow", "ramp"):  # the last operand is a cell or a table
            code += [*map(_begin, names[:-1]), names[-1]]
        else:
            code += map(_begin, names)
    return code
