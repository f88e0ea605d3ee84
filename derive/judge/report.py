"""The verdicts on the paper as text, as a page in Markdown, or as JSON."""

import json
import textwrap
from collections import Counter
from collections.abc import Iterable, Sequence

from derive.judge.claims import VERDICTS
from derive.judge.verify import Row, rows

SIMPLY = ("holds", "holds to the printed digits", "definition")


def counts(judged: Iterable[Row]) -> str:
    """One line: how many of each verdict."""
    number = Counter(row.verdict for row in judged)
    return f"{sum(number.values())} claims: " + ", ".join(f"{number[v]} {v}" for v in VERDICTS if number[v])


def report(form: str = "text", width: int = 100) -> str:
    """Judge the paper: as "text" of some columns, as "json", or as "markdown" for a colleague.

    Wider than any claim, the text has each on a line, so that what is quoted is whole.
    """
    if form == "json":
        return json.dumps([row._asdict() for row in rows()], indent=2)
    return _text(rows(), width) if form == "text" else _markdown(rows())


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
