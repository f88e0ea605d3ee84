"""Layout of tables of numbers: first row, separator, names of columns, and statements of the header."""

import re
from typing import NamedTuple

from slipcircle.base.kinds import TextPair, Texts
from slipcircle.workbench.common.textfiles import NUMBER, NUMBER_AND_STEP, SEPARATORS, first_row, split, without_comment
from slipcircle.workbench.common.units import ACCELERATION, TIME, RecordedQuantity, seconds_of, unit_of
from slipcircle.workbench.records.columns import Column, column_of

_STATEMENT = re.compile(  # in a header: "SAMPLING INTERVAL (sec) : 0.02", "#SampleRate(Hz): 200", "UNITS: cm/s^2"
    r"[\s#%!*|]*(?:(?P<step>sampl\w*[ _]*(?:interval|period|step)\w*|time[ _]?(?:step|interval)|intervalo de muestreo|"
    r"delta(?:[ _]?t)?|dt)|(?P<rate>sampl\w*[ _]*(?:rate|freq)\w*|frecuencia de muestreo|sps|fs)|"
    r"(?P<unit>(?:\w+[ _])?\w*units?|unidades[\w ]*)|(?P<peak>raw pga values|acc\w*)|"
    r"(?P<count>number of (?:data|samples|points)|n_?data|npts|num\. total de muestras)|"
    r"(?P<component>stream))\b[^:=(\[]*(?:[(\[](?P<of>[^)\]]*)[)\]])?[^:=]*[:=]\s*/?(?P<value>.+)",
    re.IGNORECASE,
)


class NumberTable(NamedTuple):
    """Layout of a table, and statements of its header."""

    lines: int  # number of lines above the first row
    separator: str | None
    width: int
    columns: list[Column]  # empty without names
    step: float
    unit: str
    stated: str  # number of samples
    component: str


def number_table(quantity: RecordedQuantity, name: str, text: str) -> NumberTable:
    """Return the layout of a table of numbers.

    `quantity` is acceleration or pore pressure, `name` the name of the file for messages, and `text` its content.

    Raises
    ------
    ValueError
        If no row of numbers exists.
    """
    lines, separator, width = first_row(name, text, quantity.name)
    above = text.split("\n", lines)[:lines]
    said = dict.fromkeys(_STATEMENT.groupindex, ("", ""))
    for statement in filter(None, map(_STATEMENT.match, reversed(above))):
        key = next(key for key, value in statement.groupdict().items() if value)
        said[key] = statement["of"] or "", statement["value"].strip()
    columns = _columns(quantity, above, separator, width)
    _, stated = said["count"]
    count = "".join(re.findall(r"^\d{1,15}", stated))
    return NumberTable(
        lines, separator, width, columns, _step(said), _unit(quantity, said), count, said["component"][1]
    )


def _step(said: dict[str, TextPair]) -> float:
    """Return the time between samples stated in a header, s, or 0.

    `said` has the bracket and the value of each statement by its kind.
    """
    return seconds_of(*said["step"]) or seconds_of(*said["rate"], default="Hz")


def _unit(quantity: RecordedQuantity, said: dict[str, TextPair]) -> str:
    """Return the unit stated in a header, as written, empty if none is stated.

    `said` has the bracket and the value of each statement by its kind.
    """
    for key in ("unit", "peak"):
        bracket, value = said[key]
        spelt = [word for word in (bracket, value, value.partition(" ")[0]) if unit_of(word, quantity)]
        if spelt or (key == "unit" and value):
            return spelt[0] if spelt else value
    return ""


def _columns(quantity: RecordedQuantity, above: Texts, separator: str | None, width: int) -> list[Column]:
    """Return the columns from the last header line that names them, with units from the line below.

    `above` are the lines above the first row of numbers, and `width` is the number of columns. The list is empty
    without names.
    """
    units = [""] * width
    if above and NUMBER_AND_STEP.fullmatch(above[-1]):
        why = f"is below {above[-1].strip()!r}, which resembles a number of samples and their step"
        return [Column("", "", quantity.role * (width == 1), why)] * width
    for line in reversed(above):
        is_comment = not without_comment(line)
        mark, parts = _parts(line.strip().lstrip("#% "), separator, width)
        if not parts or (is_comment and any(map(NUMBER.fullmatch, parts))):
            continue
        if not any(units) and all(unit_of(part, quantity) or unit_of(part, TIME) for part in parts):
            units = [part.strip("()[]") for part in parts]
            continue
        fields = [f"{part} ({unit})" if unit else part for part, unit in zip(parts, units, strict=True)]
        columns = [column_of(field, quantity) for field in fields]
        sure = any(c.role in ("time", "counter", "spectrum") or (c.role and c.unit) for c in columns)
        of_roles = quantity is ACCELERATION and all(column.role for column in columns)
        if sure or of_roles or (mark is not None and not is_comment):
            return columns
    return [column_of(f"({unit})", quantity) for unit in units if unit]


def _parts(line: str, separator: str | None, width: int) -> tuple[str | None, Texts]:
    """Return a separator, and the fields of a line that it splits into `width` parts, or an empty list.

    The given separator of the rows of numbers is tried first. The separator None means blanks.
    """
    stated = re.sub(r"^[^:]*:|\([+-]\)", "", line).strip(" /")
    for mark in (separator, *SEPARATORS, "/"):
        if mark and mark != "/":
            parts = split(line, mark)
        else:
            parts = stated.split(mark) if mark else re.findall(r"[^\s(\[;]+(?:\s*[(\[][^)\]]*[)\]])?", stated)
        is_parted = mark is None or mark in line
        if len(parts) == width and is_parted and re.search(r"[^\W_]", line) and line[0] != "!":
            return mark, parts
    return None, []
