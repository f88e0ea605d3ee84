"""The verdicts on the paper as text, as a table on a terminal, as a page in Markdown, or as JSON."""

import json
import sys
import textwrap
from collections import Counter
from collections.abc import Iterable, Sequence
from importlib import import_module
from importlib.util import find_spec

from derive.judge.claims import VERDICTS
from derive.judge.verify import Row, rows

SIMPLY = ("holds", "holds to the printed digits", "definition")
_WIDE = 130  # columns of a terminal, from which the table also has the values
COLOURS = {
    "holds": "green",
    "holds to the printed digits": "green",
    "definition": "cyan",
    "imprecise": "yellow",
    "misprint": "magenta",
    "wrong": "bold red",
    "assumption": "yellow",
    "not machine-checkable": "dim",
}


def counts(judged: Iterable[Row]) -> str:
    """One line: how many of each verdict."""
    number = Counter(row.verdict for row in judged)
    return f"{sum(number.values())} claims: " + ", ".join(f"{number[v]} {v}" for v in VERDICTS if number[v])


def report(form: str = "text", width: int = 100) -> str:
    """Judge the paper: as "text" of some columns, as "json", or as "markdown" for a colleague."""
    if form == "json":
        return json.dumps([row._asdict() for row in rows()], indent=2)
    return _text(rows(), width) if form == "text" else _markdown(rows())


def show(form: str = "text", verbose: bool = False) -> None:
    """Print the report; on a terminal with rich a table of all claims, and the text only if ``verbose``.

    In a file or a pipe each claim is one line, so that what is quoted is whole.
    """
    terminal = sys.stdout.isatty()
    table = form == "text" and terminal and find_spec("rich") is not None
    if table:
        _show_table(rows())
    if verbose or not table:
        print(report(form) if terminal else report(form, sys.maxsize))


def _show_table(judged: Sequence[Row]) -> None:
    console = import_module("rich.console").Console(markup=False)
    table = import_module("rich.table").Table(
        title="Claims of the paper, compared with what follows from its definitions"
    )
    for column in ("where", "claim"):
        table.add_column(column, overflow="fold")
    if console.width >= _WIDE:
        for column in ("printed", "from the definitions"):
            table.add_column(column, no_wrap=True, max_width=30)
    table.add_column("verdict", overflow="fold")
    for row in judged:
        values = [row.printed, row.computed] if console.width >= _WIDE else []
        table.add_row(row.id, row.claim, *values, row.verdict, style=COLOURS[row.verdict])
    console.print(table)
    console.print(f"{counts(judged)}. Causes, assumptions and rules: --verbose.")


def failing(judged: Iterable[Row]) -> list[Row]:
    """The claims that neither hold nor define something."""
    return [row for row in judged if row.verdict not in SIMPLY]


def _text(judged: Sequence[Row], width: int) -> str:
    def paragraph(text: str) -> str:
        return textwrap.fill(text, width, subsequent_indent="    ")

    def described(x: Row) -> str:
        compared = f"printed {x.printed}; from the definitions {x.computed}"
        return paragraph(f"{x.id}: {x.verdict}: {x.cause or x.claim} [{compared}]")

    return "\n".join(
        [
            *(described(x) for x in judged if x.verdict in SIMPLY),
            "",
            "Errors, assumptions, and claims that cannot be checked:",
            *map(described, failing(judged)),
            "",
            "Verdicts:",
            *(paragraph(f"{verdict}: {rule}") for verdict, rule in VERDICTS.items()),
            "",
            textwrap.fill(f"{counts(judged)}.", width),
        ]
    )


def _markdown(judged: Sequence[Row]) -> str:
    def table(chosen: Iterable[Row]) -> list[str]:
        head = ("where", "claim", "printed", "from the definitions", "verdict", "cause", "assumptions")
        rows = [head, ("---",) * len(head)]
        rows += [tuple(x.replace("|", "\\|").replace("*", "\\*") for x in row) for row in chosen]
        return [f"| {' | '.join(row)} |" for row in rows]

    return "\n".join(
        [
            "# The slip-circle paper, judged against its own definitions",
            "",
            "Every verdict is computed, by these rules:",
            "",
            *(f"* *{verdict}*: {rule}." for verdict, rule in VERDICTS.items()),
            "",
            f"{counts(judged)}.",
            "",
            "## Errors, assumptions, and claims that cannot be checked",
            "",
            *table(failing(judged)),
            "",
            "## All claims",
            "",
            *table(judged),
        ]
    )
