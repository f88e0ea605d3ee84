"""The text of `generated/flow.py`: fragments as data."""

from collections.abc import Sequence

import sympy as sp

from derive.declare.effects import EFFECTS, LAWS, Effect, Law
from derive.flow.fragments import CELLS, INPUTS, QUANTITIES, fragments, pieces
from derive.flow.lowering import Fragment
from derive.flow.operations import OPERATIONS, SCALARS
from derive.flow.tangents import of_cells, of_series

_HEAD = '''"""Fragments of flow programs: what the balance, each effect and each friction law adds, as operations.

Fragments are joined to a scene's program by the names of what they make and take. ``..._0`` is a number where the phase
began and ``d...`` the series of its increment since; ``=1.0`` is a constant.
"""

from collections.abc import Callable
from typing import Any, NamedTuple


class Fragment(NamedTuple):
    """Formulas in words; operations on numbers where a phase begins, operations on series, and what they add.

    ``adds`` gives for each quantity of the balance its base, the size of the base's terms, and its increment as a sum
    of (number, series). ``inputs`` are what a scene gives, over the scales of the arc; ``optional`` ones may be left
    out. ``states`` are series with those of their rates. A ``table`` is of slip, speed or time, with the series of its
    argument (of time, its own) and the degree of its pieces.
    """

    words: tuple[str, ...]
    inputs: tuple[str, ...]
    optional: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[object, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()
    table: tuple[str, str, int] | None = None


Tangents = tuple[tuple[str, ...], tuple[tuple[object, ...], ...]]

'''


def module(effects: Sequence[Effect] = EFFECTS, laws: Sequence[Law] = LAWS) -> str:
    """The module's text."""
    text = [_HEAD]
    for comment, name, table in (
        ("Cells that every program has, first and in this order.", "MEANINGS", CELLS),
        ("Numbers that every scene gives.", "INPUTS", INPUTS),
    ):
        lines = "".join(f"    {x!r}: {words!r},\n" for x, words in table.items())
        text.append(f"# {comment}\n{name} = {{\n{lines}}}\n\n")
    text.append("CELLS = tuple(MEANINGS)\n\n")
    text.append(
        "# Laws of slip in pieces: the parameter that is their scale, where they begin over it, and polynomials of what\n"
        "# is beyond, from the constant up.\n"
        "PIECES: dict[str, tuple[str, tuple[float, ...], Callable[..., Any]]] = {\n"
    )
    for law in (law for law in laws if law.kinks):
        breaks, polynomials = pieces(law)
        names = sorted({str(x) for p in polynomials for c in p for x in c.free_symbols})
        rows = ", ".join(f"({', '.join(sp.sstr(sp.Float(c) if c.is_Number else c) for c in p)})" for p in polynomials)
        text.append(
            f"    {law.name!r}: ({law.scale!r}, {(*map(float, breaks),)!r}, lambda {', '.join(names)}, **_: ({rows})),\n"
        )
    text.append("}\n\n")
    text.append(f"# What fragments add to.\nQUANTITIES = {QUANTITIES!r}\n\n")
    text.append(
        "# Operations that make the tangents of an operation's results, marked by a prime, under the names of its own\n"
        "# results and arguments; other names are for what is made on the way.\n"
    )
    for name, own, templates in (
        ("CELL_TANGENTS", dict.fromkeys(SCALARS, "dabe"), of_cells()),
        ("SERIES_TANGENTS", {o.name: (*o.results, *o.arguments, *o.numbers) for o in OPERATIONS.values()}, of_series()),
    ):
        lines = "".join(f"    {x!r}: ({(*map(str, own[x]),)!r}, {template!r}),\n" for x, template in templates.items())
        text.append(f"{name}: dict[str, Tangents] = {{\n{lines}}}\n\n")
    text += ["FRAGMENTS: dict[str, Fragment] = {\n", *(_fragment(f) for f in fragments(effects, laws)), "}\n"]
    return "".join(text)


def _fragment(f: Fragment) -> str:
    lines = [f"    {f.name!r}: Fragment(\n"]
    for name in ("words", "inputs", "optional", "scalar", "series", "adds", "states", "table"):
        value = getattr(f, name)
        if name in ("words", "scalar", "series") and value:
            rows = "".join(f"            {x!r},\n" for x in value)
            lines.append(f"        {name}=(\n{rows}        ),\n")
        elif name == "adds" and value:
            rows = "".join(f"            {x!r}: {added!r},\n" for x, added in value.items())
            lines.append(f"        {name}={{\n{rows}        }},\n")
        else:
            lines.append(f"        {name}={value!r},\n")
    return "".join(lines) + "    ),\n"
