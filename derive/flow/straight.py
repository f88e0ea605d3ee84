"""Straight-line functions of the most common programs for the compiled integrator, which interprets all other programs.

Interpreting takes half of the run time, because an operation and its registers are known only when it is reached.
Programs are linked from declared laws and effects. Cells are read from the program that runs, so that scenes that
differ in cells only share a function: a section of the ground, a cohesion and a constant pore pressure are cells.
"""

from collections.abc import Iterator
from itertools import product

from sympy import Symbol

from derive.declare.effects import EFFECTS, K_H, K_V, LAWS, WATER
from derive.flow.link import lookup
from derive.flow.link.definitions import Recipe
from derive.flow.link.integers import encoded
from derive.flow.link.program import Program, build
from derive.kinds import TextDict

# Parameters that change along the motion: none, a level of water, a record in one direction or in two.
MOVING: tuple[tuple[Symbol, ...], ...] = ((), (WATER,), (K_H,), (K_H, K_V))
FUNCTIONS = """\
INLINE void rates_{k}(const int32_t *own, V *r, const V *c, int n, double by_n, int squares)
{{
{rates}
}}
INLINE void others_{k}(const int32_t *own, V *r, const V *c, int n, double by_n)
{{
{others}
}}
EACH_ORDER({k})
"""


def programs() -> Iterator[Program]:
    """Link the first smooth law without argument, of slip, of speed, and one in pieces, each with all of `MOVING`.

    Where nothing moves, the first and the last are solved in the phase plane, without operations on series.
    """
    smooth = [law for law in LAWS if law.coefficient is not None and not law.kinks]
    laws = {law.depends_on: law for law in reversed(smooth)}
    laws["slip", "kinks"] = next(law for law in LAWS if law.kinks)
    parts = lookup()
    for dependence, moving in product(((), ("slip",), ("speed",), ("slip", "kinks")), MOVING):
        if not moving and dependence in ((), ("slip", "kinks")):
            continue
        effects = [e for e in EFFECTS if not e.parameters or not e.symbols.keys().isdisjoint(moving)]
        absent = [x for e in effects for x in e.symbols if x not in moving]
        recipe = Recipe(
            effects=tuple(effect.name for effect in effects),
            laws=(laws[dependence].name,),
            moving=tuple(map(str, moving)),
            absent=tuple(map(str, absent)),
        )
        yield build(recipe, parts)


def c_programs() -> TextDict:
    """Return programs as integers, as functions, and as a table of these functions, by their marks in the C text."""
    patterns = functions = rows = ""
    for k, program in enumerate(programs()):
        integers = list[str]()
        calls = list[str]()
        begins = list[int]()
        rates, others = program.split
        for operation in (*rates, *others):
            begins.append(len(integers))
            condition = "if (squares) " if operation.kind == "sqr" and not integers else ""
            cells = ["CELL"] * len(operation.cells)  # any cell
            row = [*map(str, encoded(operation._replace(cells=cells)))]
            calls.append(f"    {condition}OPERATION({len(integers)}, {', '.join(row)});")
            integers += row
        count = len(rates)
        patterns += f"    {{{begins[count]}, {len(integers)}, (const int32_t[]){{{', '.join(integers)}}}}},\n"
        first, last = ("\n".join(x) for x in (calls[:count], calls[count:]))
        functions += FUNCTIONS.format(k=k, rates=first, others=last)
        rows += f"    {{order_{k}, later_{k}}},\n"
    return {"PATTERNS": patterns, "STRAIGHT": functions, "STRAIGHT_ROWS": rows}
