"""The text of `generated/flow.py`: fragments as data."""

import inspect
from collections.abc import Sequence

import sympy as sp

from derive.declare.effects import EFFECTS, LAWS, Effect, Law
from derive.flow.fragments import INPUTS, QUANTITIES, fragments, pieces
from derive.flow.lowering import Fragment
from derive.flow.operations import OPERATIONS, SCALARS
from derive.flow.tangents import of_cell, of_series

_HEAD = '''"""Fragments of flow programs: what the balance, each effect and each friction law adds, as operations.

Fragments are joined to a scene's program by the names of what they make and take. ``..._0`` is a number where the phase
began and ``d...`` the series of its increment since; ``=1.0`` is a constant.
"""

from collections.abc import Callable
from typing import Any, NamedTuple


{fragment}

# The names of an operation's results and arguments, and the operations that make the tangents of its results: a prime
# marks a tangent, other names are for what is made on the way.
Tangents = tuple[tuple[str, ...], tuple[tuple[object, ...], ...]]

'''


def module(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = LAWS) -> str:
    """The module's text."""
    cells = {name: repr((("d", "a", "b", "e"), of_cell(means))) for name, (means, _, _) in SCALARS.items()}
    registers = {name: repr(((*map(str, (*o.results, *o.arguments, *o.numbers)),), of_series(o)))
                 for name, o in OPERATIONS.items()}  # fmt: skip
    parts = {name: _fragment(f) for name, f in fragments(effects, laws).items()}
    kinked = {law.name: _pieces(law) for law in laws if law.kinks}
    blocks = (
        ("numbers that every scene gives", "INPUTS", {x: repr(y) for x, y in INPUTS.items()}),
        ("laws of slip in pieces: their scale, where pieces begin over it, and their polynomials in what is beyond",
         "PIECES: dict[str, tuple[str, tuple[float, ...], Callable[..., Any]]]", kinked),
        ("operations that make the tangent of a cell", "CELL_TANGENTS: dict[str, Tangents]", cells),
        ("operations that make the tangents of a register", "SERIES_TANGENTS: dict[str, Tangents]", registers),
        ("parts of programs", "FRAGMENTS: dict[str, Fragment]", parts),
    )  # fmt: skip
    text = [_HEAD.format(fragment=inspect.getsource(Fragment))]
    for comment, name, rows in blocks:
        lines = "".join(f"    {x!r}: {row},\n" for x, row in rows.items())
        text.append(f"# {comment[0].upper()}{comment[1:]}.\n{name} = {{\n{lines}}}\n\n")
    return "".join(text) + f"QUANTITIES = {QUANTITIES!r}  # what fragments add to\n"


def _pieces(law: Law) -> str:
    breaks, polynomials = pieces(law)
    names = ", ".join(sorted({str(x) for p in polynomials for c in p for x in c.free_symbols}))
    rows = ", ".join(f"({', '.join(sp.sstr(sp.Float(c) if c.is_Number else c) for c in p)})" for p in polynomials)
    return f"({law.scale!r}, {(*map(float, breaks),)!r}, lambda {names}, **_: ({rows}))"


def _fragment(f: Fragment) -> str:
    lines = []
    for name, value in f._asdict().items():
        if name in ("words", "scalar", "series") and value:
            rows = "".join(f"            {x!r},\n" for x in value)
            lines.append(f"        {name}=(\n{rows}        ),\n")
        elif name == "adds" and value:
            rows = "".join(f"            {x!r}: {added!r},\n" for x, added in value.items())
            lines.append(f"        {name}={{\n{rows}        }},\n")
        else:
            lines.append(f"        {name}={value!r},\n")
    return f"Fragment(\n{''.join(lines)}    )"
