"""The text of `generated/flow.py`: fragments as data."""

from collections.abc import Iterable

from derive.flow.fragments import CELLS, QUANTITIES, fragments
from derive.flow.lowering import Fragment

_HEAD = '''"""Fragments of flow programs: what the balance, each effect and each friction law adds, as operations.

A fragment is joined with others to a scene's program by name: ``d...`` is a series, the increment since the phase
began, ``..._0`` a number where it began, ``=1.0`` a constant.
"""

from typing import NamedTuple


class Fragment(NamedTuple):
    """Operations on numbers where a phase begins, operations on series, and what they add.

    ``adds`` gives for each quantity of the balance its base, the size of the base's terms, and its increment as a sum
    of (number, series). ``states`` are series with those of their rates. A ``table`` is of slip, speed or time, with the
    series of its argument (of time, its own) and the degree of its pieces.
    """

    words: tuple[str, ...]
    inputs: tuple[str, ...]
    optional: tuple[str, ...]
    scalar: tuple[tuple[str, ...], ...]
    series: tuple[tuple[object, ...], ...]
    adds: dict[str, tuple[str, str, tuple[tuple[str, str], ...]]]
    states: tuple[tuple[str, str], ...] = ()
    table: tuple[str, str, int] | None = None


'''


def module() -> str:
    """The module's text."""
    text = [_HEAD, "# Cells that every program has, first and in this order.\nMEANINGS = {\n"]
    text += [f"    {name!r}: {words!r},\n" for name, words in CELLS.items()]
    text += ["}\nCELLS = tuple(MEANINGS)\n\n", f"QUANTITIES = {QUANTITIES!r}\n\n"]
    text += ["FRAGMENTS: dict[str, Fragment] = {\n", *(_fragment(f) for f in fragments()), "}\n"]
    return "".join(text)


def _lines(name: str, rows: Iterable[object]) -> str:
    rows = list(rows)
    return f"        {name}=(\n{''.join(f'            {r!r},{chr(10)}' for r in rows)}        ),\n" if rows else f"        {name}=(),\n"


def _fragment(f: Fragment) -> str:
    adds = "".join(f"            {q!r}: {added!r},\n" for q, added in f.adds.items())
    return (
        f"    {f.name!r}: Fragment(\n"
        + _lines("words", f.words)
        + f"        inputs={f.inputs!r},\n        optional={f.optional!r},\n"
        + _lines("scalar", f.scalar)
        + _lines("series", f.series)
        + (f"        adds={{\n{adds}        }},\n" if adds else "        adds={},\n")
        + f"        states={f.states!r},\n        table={f.table!r},\n    ),\n"
    )
