"""Readers of what the program prints, writes and draws."""

import io
import re
from typing import Any
from xml.etree import ElementTree

from PIL import Image

from slipcircle import Motion
from slipcircle.workbench.outputs.tables import motion_groups

COMPUTING = "slipcircle: computing; Ctrl-C stops it\n"  # which a busy machine prints


def words_of(png: bytes) -> list[str]:
    """Return the titles, labels and legends that the program writes into the file of a picture."""
    return str(getattr(Image.open(io.BytesIO(png)), "text", {}).get("Description", "")).split("\n")


def columns(table: str) -> dict[str, list[str]]:
    """Return the cells of a printed table by the label of their row."""
    found = (re.split(r"  +", line) for line in table.splitlines() if "  " in line.strip())
    return {label: cells for label, *cells in found if label}


def printed(motion: Motion) -> dict[str, str]:
    """Return all printed results of a motion by label."""
    return {label: text for rows in motion_groups(motion).values() for label, text in rows.items()}


def blocks(text: str, kind: str) -> list[str]:
    """Return the code blocks of a kind in a document; in the book they may have a caption."""
    found = re.findall(r"^```(?:\{code-block\} )?(\w*)\n(?::\w+: [^\n]*\n\n)?(.*?)^```", text, re.DOTALL | re.MULTILINE)
    return [code for block, code in found if block == kind]


def tree(text: str) -> Any:
    """Return the page as XML, which it must be as well."""
    assert text.startswith("<!DOCTYPE html>\n")
    return ElementTree.fromstring(text.partition("\n")[2])


def rows(page: Any) -> dict[str, Any]:
    """Return the last cell of every table row, by the text of its first."""
    found = {}
    for row in page.iter("tr"):
        cells = list(row)
        found["".join(cells[0].itertext())] = cells[-1]
    return found


# Few elements and few turns: no test is about how long something takes.
QUICK: dict[str, Any] = {"REPEATS": 2, "_TICK": 1e-7}
