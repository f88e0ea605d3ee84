"""Straight-line functions of the most common programs for the compiled integrator, which interprets all other programs.

Interpreting takes half of the run time, because an operation and its registers are known only when it is reached.
Programs are linked from declared laws and effects. Cells are read from the program that runs, so that scenes that
differ in cells only share a function: a section of the ground, a cohesion and a constant pore pressure are cells.
"""

from collections.abc import Iterator

from sympy import Symbol

from derive.declare.effects import EFFECTS, K_H, K_V, WATER
from derive.flow.link import lookup
from derive.flow.link.definitions import Recipe
from derive.flow.link.integers import encoded
from derive.flow.link.program import Program, build
from derive.kinds import TextDict

# Parameters that change along the motion: a level of water, a record in one direction or in two.
MOVING: tuple[tuple[Symbol, ...], ...] = ((WATER,), (K_H,), (K_H, K_V))
# Laws with these parameters. Without any, constant and linear friction are solved in the phase plane, without
# operations on series.
SERVED = {"constant": MOVING, "exponential": ((), *MOVING), "rate_weakening": ((), *MOVING), "linear": MOVING}
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


def c_programs() -> TextDict:
    """Return programs as integers, as functions, and as a table of these functions, by their marks in the C text."""
    patterns = functions = rows = ""
    for k, program in enumerate(programs()):
        integers = list[str]()
        parts = list[tuple[int, str]]()
        for operations in program.split:
            calls = list[str]()
            for operation in operations:
                condition = "if (squares) " if operation.kind == "sqr" and not integers else ""
                cells = ["CELL"] * len(operation.cells)  # any cell
                row = [*map(str, encoded(operation._replace(cells=cells)))]
                calls.append(f"    {condition}OPERATION({len(integers)}, {', '.join(row)});")
                integers += row
            parts.append((len(integers), "\n".join(calls)))
        (begin, rates), (end, others) = parts
        patterns += f"    {{{begin}, {end}, (const int32_t[]){{{', '.join(integers)}}}}},\n"
        functions += FUNCTIONS.format(k=k, rates=rates, others=others)
        rows += f"    {{orders_{k}, later_{k}}},\n"
    return {"PATTERNS": patterns, "STRAIGHT": functions, "STRAIGHT_ROWS": rows}
