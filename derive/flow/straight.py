"""Straight-line functions of the most common programs for the compiled integrator, which interprets all other programs.

Interpreting takes half of the run time, because an operation and its registers are known only when it is reached.
Programs are linked from declared laws and effects. Cells are read from the program that runs, so that scenes that
differ in cells only share a function: a section of the ground, a cohesion and a constant pore pressure are cells.
"""

import re
from collections.abc import Iterable, Iterator, Sequence

from sympy import Symbol

from derive.declare.effects import EFFECTS, K_H, K_V, WATER
from derive.flow.layout import STRIDE
from derive.flow.link import lookup
from derive.flow.link.definitions import Recipe
from derive.flow.link.integers import encoded
from derive.flow.link.program import Program, build
from derive.flow.lowering import OnSeries
from derive.flow.recurrences import OPERATIONS
from derive.flow.series import C, OneSum, body, indented, known_terms, sums_in
from derive.kinds import TextDict, Texts

# Parameters that change along the motion: a level of water, a record in one direction or in two.
MOVING: tuple[tuple[Symbol, ...], ...] = ((WATER,), (K_H,), (K_H, K_V))
# Laws with these parameters. Without any, constant and linear friction are solved in the phase plane, without
# operations on series.
SERVED = {"constant": MOVING, "exponential": ((), *MOVING), "rate_weakening": ((), *MOVING), "linear": MOVING}
ANY = "CELL"  # in a pattern
TOGETHER = 2  # sums in a loop: more vectors than fit into 16 registers are slower
# Orders of the registers that rates need, and of all others. What an operation computes is in memory and in a variable,
# so that the next operation need not wait for memory. Order 0 is apart, so that no operation asks which order it is.
FUNCTIONS = """\
static void orders_{k}(ORDERS)
{{
    if (n == 0) {{
{start}
{states}
        n++;
    }}
    for (; n < behind; n++) {{
        const double by_n = inverse[n];
{sums}
{step}
{states}
    }}
}}
static void later_{k}(LATER)
{{
    int n = 0;
{start_of_others}
    for (n = 1; n < top; n++) {{
{others}
    }}
}}
"""


def programs() -> Iterator[Program]:
    """Link each law with each choice of its moving parameters, on a mass that turns."""
    parts = lookup()
    for law, choices in SERVED.items():
        for moving in choices:
            effects = [e for e in EFFECTS if not e.parameters or not e.symbols.keys().isdisjoint(moving)]
            absent = [x for e in effects for x in e.symbols if x not in moving]
            recipe = Recipe(
                effects=tuple(effect.name for effect in effects),
                laws=(law,),
                moving=tuple(map(str, moving)),
                absent=tuple(map(str, absent)),
            )
            yield build(recipe, parts)


def _register(i: int) -> str:
    """Return the address of a register's coefficients in C."""
    return f"(r + {STRIDE * i})"


def _registers(operation: OnSeries) -> dict[str, int]:
    """Return the registers of an operation's results and arguments by the names of `recurrences`."""
    o = OPERATIONS[operation.kind]
    registers = (*operation.results, *operation.registers)
    return dict(zip(map(str, (*o.results, *o.arguments)), registers, strict=True))


def _sums(operations: Iterable[OnSeries]) -> Texts:
    """Return lines of C that compute the terms of all sums which are known before order n, some sums in each loop."""
    sums = list[OneSum]()
    for operation in operations:
        if operation.kind != "lin":
            at = {x: _register(i) for x, i in _registers(operation).items()}
            when = "if (squares) " if operation.kind == "sqr" else ""
            for s in sums_in(OPERATIONS[operation.kind]):
                a, b, slot = (at[str(x)] for x in (s.a, s.b, s.slot))
                sums.append(OneSum(s.total, f"sum{len(sums)}", a, b, slot, when))
    sums.sort(key=lambda s: s.a == s.b)  # both of a sine and its cosine read one series
    lines: Texts = []
    for i in range(0, len(sums), TOGETHER):
        lines += known_terms(sums[i : i + TOGETHER])
    return lines


def _recurrence(operation: OnSeries, is_first: bool) -> Texts:
    """Return lines of C that compute coefficients n of an operation's results; x1 is coefficient n of register 1."""
    registers = _registers(operation)

    def named(coefficient: re.Match[str]) -> str:
        i = registers[coefficient[1]]
        return f"x{i}" if is_first or coefficient[2] == "n" else f"{_register(i)}[0]"

    start, step = body(OPERATIONS[operation.kind], C)
    return [re.sub(r"(\w+)\[(0|n)\]", named, line) for line in (start if is_first else step)]


def _linear(operation: OnSeries, place: int, is_first: bool) -> Texts:
    """Return lines of C that compute a coefficient of a sum of registers times cells, at order 0 with its constant.

    The integers of the operation start at ``place``. Beginning with zero, all products are fused with their sums.
    """
    (result,) = operation.results
    cells = [f"c[own[{place + 3 + len(operation.registers) + j}]]" for j in range(len(operation.cells))]
    terms = [f"{cell} * x{x}" for cell, x in zip(cells[1:], operation.registers, strict=True)]
    return [f"x{result} = {cells[0] if is_first else C.zero};", *(f"x{result} += {term};" for term in terms)]


def _coefficients(operations: Sequence[OnSeries], begin: int, is_first: bool) -> Texts:
    """Return lines of C that compute coefficients n of the results of operations, whose integers start at ``begin``.

    The square of omega is computed unless it is a state. Up to its operation, a result is the known part of its sum.
    """
    results = {i for o in operations for i in o.results}
    given = {i for o in operations for i in o.registers} - results
    lines = [f"const V x{i} = {_register(i)}[n];" for i in sorted(given)]
    for o in operations:
        is_square = o.kind == "sqr"
        inner = _linear(o, begin, is_first) if o.kind == "lin" else _recurrence(o, is_first)
        inner += [f"{_register(i)}[n] = x{i};" for i in o.results]
        waits = is_square or (o.kind != "lin" and not is_first)
        lines += [f"V x{i}{f' = {_register(i)}[n]' if waits else ''};" for i in o.results]
        lines += ["if (squares) {" if is_square else "{", *(f"    {line}" for line in inner), "}"]
        begin += len(encoded(o))
    return lines


def _next(states: Iterable[tuple[int, int, int]]) -> Texts:
    """Return lines of C that compute coefficients n + 1 of states by their rates."""
    moved = [f"    {_register(i)}[n + 1] = x{rate} * inverse[n + 1];" for _, i, rate in states]
    return ["if (moves) {", *moved, "}"]


def _pattern(program: Program) -> str:
    """Return the row of a program in the table of patterns: where its parts end, and its integers."""
    rates, others = (
        [x for o in part for x in encoded(o._replace(cells=[ANY] * len(o.cells)))] for part in program.split
    )
    states = [x for _, *registers in program.states for x in (ANY, *(STRIDE * i for i in registers))]
    integers = [*rates, *others, *states]
    text = ", ".join(map(str, integers))
    return f"    {{{len(rates)}, {len(rates) + len(others)}, {len(integers)}, (const int32_t[]){{{text}}}}},\n"


def c_programs() -> TextDict:
    """Return programs as integers, as functions, and as a table of these functions, by their marks in the C text."""
    patterns = functions = rows = ""
    for k, program in enumerate(programs()):
        rates, others = program.split
        end = sum(len(encoded(o)) for o in rates)
        inner = {
            "start": _coefficients(rates, 0, True),
            "sums": _sums(rates),
            "step": _coefficients(rates, 0, False),
            "states": _next(program.states),
            "others": _coefficients(others, end, False),
        }
        start = indented(_coefficients(others, end, True), 4)
        texts = {name: indented(lines, 8) for name, lines in inner.items()}
        functions += FUNCTIONS.format(k=k, start_of_others=start, **texts)
        patterns += _pattern(program)
        rows += f"    {{orders_{k}, later_{k}}},\n"
    return {"PATTERNS": patterns, "STRAIGHT": functions, "STRAIGHT_ROWS": rows}
