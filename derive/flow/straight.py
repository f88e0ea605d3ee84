"""The commonest programs, which the compiled integrator has as functions of their own; all others it interprets.

Interpreting costs half of the time: only on the way it turns out what the next operation is, and which registers it
takes. A program is here what rates need: operations, each its kind and the registers that it takes; x and omega are
registers 0 and 1, and results are numbered in order. Cells are read off the program that runs, so that scenes that
differ in them only share a function: a section of the ground, a cohesion and a constant pore pressure are cells.
"""

from collections.abc import Iterator

from derive.flow.recurrences import OPERATIONS

STATES = 2
# A mass that turns, with the centripetal term; with a level of water; with a record in one direction or in two; each
# with friction that is constant, that falls exponentially with slip, and that falls with the rate.
PROGRAMS = (
    "tim 0; turn 2 0; sqr 1; lin 3 4 5 | lin 3 4 5; lin 3 4",
    "tim 0; turn 2 0; powers 0; sqr 1; lin 0 3 4 5 6 7 8 9 10 11 | lin 0 3 4 5 6 7 8 9 10 11; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; sqr 1; lin 3 4 5 6 7 8 | lin 3 4 5 6 7 8; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; ramp; mul 8 3; mul 8 4; sqr 1; lin 3 4 5 6 7 8 9 10 11 | lin 3 4 5 6 "
    "7 8 9 10 11; lin 3 4",
    "tim 0; turn 2 0; lin 0; tim 5; exp 6 5; lin 8; sqr 1; lin 3 4 10; mul 9 11; lin 3 4 9 11 12 | lin 11; lin 3 4",
    "tim 0; turn 2 0; lin 0; tim 5; exp 6 5; lin 8; powers 0; sqr 1; lin 0 3 4 10 11 12 13 14 15 16; mul 9 17; lin "
    "3 4 9 17 18 | lin 17; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; lin 0; tim 8; exp 9 8; lin 11; sqr 1; lin 3 4 5 6 7 13; mul 12 14; "
    "lin 3 4 5 6 7 12 14 15 | lin 14; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; ramp; mul 8 3; mul 8 4; lin 0; tim 11; exp 12 11; lin 14; sqr 1; lin "
    "3 4 5 6 7 8 9 10 16; mul 15 17; lin 3 4 5 6 7 8 9 10 15 17 18 | lin 17; lin 3 4",
    "tim 0; turn 2 0; lin 1; rec 5; lin 7; sqr 1; lin 3 4 9; mul 8 10; lin 3 4 8 10 11 | lin 10; lin 3 4",
    "tim 0; turn 2 0; lin 1; rec 5; lin 7; powers 0; sqr 1; lin 0 3 4 9 10 11 12 13 14 15; mul 8 16; lin 3 4 8 16 "
    "17 | lin 16; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; lin 1; rec 8; lin 10; sqr 1; lin 3 4 5 6 7 12; mul 11 13; lin 3 4 5 6 "
    "7 11 13 14 | lin 13; lin 3 4",
    "tim 0; turn 2 0; ramp; mul 5 3; mul 5 4; ramp; mul 8 3; mul 8 4; lin 1; rec 11; lin 13; sqr 1; lin 3 4 5 6 7 8 "
    "9 10 15; mul 14 16; lin 3 4 5 6 7 8 9 10 14 16 17 | lin 16; lin 3 4",
)
FUNCTIONS = """\
/* {program} */
INLINE void rates_{k}(const int32_t *own, V *r, const V *c, int n, double by_n)
{{
{rates}
}}
INLINE void others_{k}(const int32_t *own, V *r, const V *c, int n, double by_n)
{{
{others}
}}
EACH_ORDER({k})
"""


def operations(program: str) -> Iterator[list[str]]:
    """The operations of a program as C reads them: its kind, and what follows it; CELL stands for any cell, or none."""
    made = STATES
    for text in program.replace(" |", ";").split("; "):
        kind, *taken = text.split()
        known = OPERATIONS.get(kind)
        count = len(known.results) if known else 1
        results = [f"{k} * STRIDE" for k in range(made, made + count)]
        made += count
        registers = [f"{register} * STRIDE" for register in taken]
        if kind == "lin":
            terms = [x for register in registers for x in ("CELL", register)]
            yield ["LIN", *results, "CELL", str(len(registers)), *terms]
        else:
            cells = len(known.numbers) if known else 1  # a ramp's is its table
            yield [kind.upper(), *results, *registers, *["CELL"] * cells]


def c() -> dict[str, str]:
    """Programs as integers, functions of them, and a table of those."""
    patterns = functions = rows = ""
    for k, program in enumerate(PROGRAMS):
        integers = list[str]()
        calls = list[str]()
        begins = list[int]()
        for operation in operations(program):
            begins.append(len(integers))
            calls.append(f"    STRAIGHT({len(integers)}, {', '.join(operation)});")
            integers += operation
        count = program.split(" |")[0].count(";") + 1  # of operations that rates need
        patterns += f"    {{{begins[count]}, {len(integers)}, (const int32_t[]){{{', '.join(integers)}}}}},\n"
        rates, others = ("\n".join(x) for x in (calls[:count], calls[count:]))
        functions += FUNCTIONS.format(program=program, k=k, rates=rates, others=others)
        rows += f"    {{order_{k}, later_{k}}},\n"
    return {"PATTERNS": patterns, "STRAIGHT": functions, "STRAIGHT_ROWS": rows}
