"""Reports of the verdicts on the paper: a table of its errors, claims in full, Markdown, or JSON."""

import json
import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Sequence

from derive.judge.claims import VERDICTS, Claim
from derive.judge.paper import CLAIMS
from derive.judge.verify import Row, judged
from derive.kinds import Texts

SIMPLY = ("holds", "holds to the printed digits", "definition")
ERRORS = ("wrong", "misprint")
PLURAL = {
    "holds": "hold",
    "holds to the printed digits": "hold to the printed digits",
    "definition": "definitions",
    "misprint": "misprints",
    "assumption": "assumptions",
}


def selected(names: Sequence[str]) -> list[Claim]:
    """Return the claims whose place begins with one of the names, such as 3.15, "Table 4-1" or "Appendix I".

    Raises
    ------
    ValueError
        If a name selects no claim; the message lists the places.
    """
    chosen = []
    for name in names:
        sought = _plain(name)
        claims = [x for x in CLAIMS if sought and f"{_plain(x.id)} ".startswith(f"{sought} ")]
        if not claims:
            others = ", ".join(x.id for x in CLAIMS if not x.id.startswith("("))
            raise ValueError(f"{name!r} is not a claim of the paper; choose 1.1 to 4.5, or one of {others}")
        chosen += claims
    if not names:
        return list(CLAIMS)
    return [x for x in CLAIMS if x in chosen]


def _plain(place: str) -> str:
    """Return a place such as "(3.15)" in lower case, without brackets and with single spaces."""
    return " ".join(place.replace("(", "").replace(")", "").casefold().split())


def counts(rows: Iterable[Row]) -> str:
    """Return one line with the total number of claims and the number with each verdict."""
    number = Counter(row.verdict for row in rows)
    total = sum(number.values())
    plural = "" if total == 1 else "s"
    by_verdict = (f"{number[v]} {v if number[v] == 1 else PLURAL.get(v, v)}" for v in VERDICTS if number[v])
    return f"{total} claim{plural}: {', '.join(by_verdict)}"


def judge_paper(
    form: str = "text", width: int = 100, names: Sequence[str] = (), verdict: str | None = None, every: bool = False
) -> str:
    """Judge the paper and return the report.

    Parameters
    ----------
    form : {"text", "json", "markdown"}
        Format of the report.
    width : int
        Columns of the text. In a text wider than every claim, each field of a claim is one line.
    names : sequence of str
        Places of the claims to judge, see `selected`; all claims by default.
    verdict : str, optional
        Report only the claims with this verdict.
    every : bool
        Report all claims in full. By default the text is a table of the wrong claims and misprints, unless claims
        are selected by place or verdict.

    Returns
    -------
    str
        The report.

    Raises
    ------
    ValueError
        If a place or the verdict does not exist.
    """
    if verdict not in (None, *VERDICTS):
        raise ValueError(f"{verdict!r} is not a verdict; choose one of {', '.join(VERDICTS)}")
    rows = judged(selected(names))
    if verdict:
        rows = [row for row in rows if row.verdict == verdict]
    if form == "json":
        return json.dumps([row._asdict() for row in rows], indent=2)
    if form == "markdown":
        return _markdown(rows)
    if names or verdict or every:
        return "\n\n".join([*(_in_full(x, width) for x in rows), textwrap.fill(f"{counts(rows)}.", width)])
    return wrong_claims(rows, width)


def failing(rows: Iterable[Row]) -> list[Row]:
    """Return the claims that neither hold nor define a quantity."""
    return [row for row in rows if row.verdict not in SIMPLY]


def wrong_claims(rows: Sequence[Row], width: int) -> str:
    """Return a table of the wrong claims and misprints, and the number of claims of each verdict.

    ``width`` is the number of columns.
    """
    from rich import box
    from rich.console import Console
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1), expand=True)
    table.add_column("place", no_wrap=True)
    for name, ratio in (("printed", 3), ("correct", 4), ("cause", 8)):
        table.add_column(name, ratio=ratio)
    places: dict[tuple[str, str, str], Texts] = {}  # of a mistake, which may occur at several
    for row in rows:
        if row.verdict in ERRORS:
            correct = re.sub(r": .*; \d+ operations -> \d+$", "", row.computed)  # an integral without its form
            places.setdefault((row.printed, correct, row.cause), []).append(row.id)
    for mistake, ids in places.items():
        table.add_row("\n".join(ids), *mistake)
    console = Console(width=min(width, 120), color_system=None, highlight=False, markup=False)
    with console.capture() as captured:
        console.print(table)
    lines = [line.rstrip() for line in captured.get().splitlines() if line.strip()]
    return "\n".join([*lines, textwrap.fill(f"{counts(rows)}. All claims: --all; one: 3.15.", width)])


def _in_full(x: Row, width: int) -> str:
    """Return a claim with all its fields as text with this number of columns."""
    computed, cause = ("derived", "remark") if x.verdict in SIMPLY else ("correct", "cause")
    lines = {"printed": x.printed, computed: x.computed, cause: x.cause, "assumes": x.assumes}
    indent = " " * 12
    wrapped = [
        textwrap.fill(text, width, initial_indent=f"    {name:<8}", subsequent_indent=indent)
        for name, text in lines.items()
        if text
    ]
    return "\n".join([f"{x.id}, {x.claim}: {x.verdict}", *wrapped])


def _markdown(rows: Sequence[Row]) -> str:
    """Return the report as Markdown: rules, errors, and all claims."""

    def table(chosen: Iterable[Row]) -> Texts:
        head = ("where", "claim", "printed", "from the definitions", "verdict", "cause", "assumptions")
        cells = [head, ("---",) * len(head)]
        cells += [tuple(x.replace("|", "\\|").replace("*", "\\*") for x in row) for row in chosen]
        return [f"| {' | '.join(row)} |" for row in cells]

    return "\n".join(
        [
            "# The slip-circle paper, judged against its own definitions",
            "",
            "Every verdict is computed by these rules:",
            "",
            *(f"* *{verdict}*: {rule}." for verdict, rule in VERDICTS.items()),
            "",
            f"{counts(rows)}.",
            "",
            "## Errors, assumptions, and claims that cannot be checked",
            "",
            *table(failing(rows)),
            "",
            "## All claims",
            "",
            *table(rows),
        ]
    )
