"""Record files with a header of a known format or with a table: times, values and their unit."""

import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Floats, Names, Texts
from slipcircle.workbench.common.textfiles import (
    CLOCK,
    Lines,
    check_count,
    fields_below,
    is_even,
    parsed_numbers,
    plain_numbers,
    text_of,
)
from slipcircle.workbench.common.units import ACCELERATION, TIME, RecordedQuantity, unit_of
from slipcircle.workbench.records.columns import Column
from slipcircle.workbench.records.headers import Header, channels, header_of
from slipcircle.workbench.records.tables import NumberTable, number_table

MOST_BYTES = 2**28
MOST_NUMBERS = 2**24
_LONGEST_STEP = 0.5  # s, greatest step of two columns without names that are read as time and acceleration
WRAPPED = "wrapped"  # role of all columns if each line contains several values of one record
SKIP = "skip"
_CLOCK = "has times of day or dates"
_COUNTER = "counts the samples"


class RecordSamples(NamedTuple):
    """Content of a record file, and the line number of each sample, from 1."""

    time: Floats
    values: Floats
    units: str
    lines: Lines


class Options(NamedTuple):
    """Statements of the user about a file. Unit and step default to the statements of the file."""

    columns: str | Sequence[str] = ()
    column: int | str | None = None
    step: float | None = None
    units: str | None = None
    start: float | None = None
    gaps: str = "refuse"
    of_all: bool = True  # whether the roles apply to every table, or only to tables with as many columns

    def roles(self, quantity: RecordedQuantity) -> Names:
        """Return the roles of the columns from a sequence or a text with commas.

        The role of values is the role of `quantity`, acceleration or pore pressure.
        """
        parts = self.columns.split(",") if isinstance(self.columns, str) else self.columns
        roles = tuple(str(part).strip().lower() for part in parts)
        allowed = ("time", quantity.role, "vertical", SKIP)
        if roles != (WRAPPED,) and (not {*roles} <= {*allowed} or roles.count("time") > 1):
            rule = f"must be {', '.join(allowed)} for each column, one time at most, or {WRAPPED} alone"
            raise InputError("", [f"{{columns}} = {','.join(roles)!r}: {rule}"])
        return roles


class Channel(NamedTuple):
    """Channel or column of a file: number from 1, name and role, and its samples or the reason for their absence."""

    place: int
    name: str
    role: str = ""
    reason: str = ""
    samples: RecordSamples | None = None

    def __str__(self) -> str:
        """Return the column with the reason why it is not used."""
        return f"column {self.place}{f' ({self.name})' * bool(self.name)}: {self.reason}"


def contents(quantity: RecordedQuantity, name: str, path: Path, options: Options) -> list[Channel]:
    """Return the channels of a file, or the columns other than times and skipped columns.

    `quantity` is acceleration or pore pressure, and `name` the name of the file for messages.

    Raises
    ------
    ValueError
        If the file cannot be read. The message gives the file, the line and the remedy.
    """
    text = text_of(path, name, MOST_BYTES, MOST_NUMBERS, quantity.kinds)
    parts = list(channels(text)) if quantity is ACCELERATION else [text]
    names = [f"{name}, channel {k}" if len(parts) > 1 else name for k in range(1, len(parts) + 1)]
    headers = list(map(header_of, names, parts)) if quantity is ACCELERATION else [None]
    if headers[0] is None:
        return _of_table(quantity, name, text, options)
    chosen = _chosen(name, {k: header.component for k, header in enumerate(headers, 1) if header}, options.column)
    return [
        Channel(k, header.component, samples=_of_format(names[k - 1], parts[k - 1], header))
        for k, header in enumerate(headers, 1)
        if header and k in chosen
    ]


def _chosen(name: str, names: Mapping[int, str], column: int | str | None) -> list[int]:
    """Return the numbers of the columns or channels selected by name or number from 1, by default all.

    `name` is the name of the file, and `names` are the names of the columns by number.
    """
    requested = str(column).strip().lower()
    named = [place for place, other in names.items() if other.lower() == requested]
    chosen = named or [place for place in names if column is None or requested == str(place)]
    if not chosen or len(named) > 1:
        raise InputError("", [f"{name}: {{column}} = {column!r}: must be one of {choice(names.items())}"])
    return chosen


def choice(names: Iterable[tuple[int, str]]) -> str:
    """Return pairs of number and name of columns as a text for a message, such as "1 (NS), 2 (EW)"."""
    return ", ".join([f"{place} ({name})" if name else str(place) for place, name in names])


def _samples(name: str, time: Floats | float, fields: Sequence[str], lines: Lines, units: str) -> RecordSamples:
    """Return the samples of a record, at least two, at given times or with a constant step, in s.

    `name` is the name of the file. `fields` are the values as text, and `lines` their line numbers.
    """
    count = len(fields)
    if count < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")
    times = time if isinstance(time, np.ndarray) else time * np.arange(float(count))
    return RecordSamples(times, parsed_numbers(name, fields, lines), units, lines)


def _of_format(name: str, text: str, header: Header) -> RecordSamples:
    """Return samples in the unit of the file, without times, with any number of values per line.

    `name` is the name of the file or channel for messages, and `text` its content including the header.
    """
    below = text.split("\n")[header.lines :]
    if header.fields.get("pair"):
        below = [line.rpartition(" ")[2] for line in map(str.strip, below)]
    is_block = "block" in header.fields
    if is_block or "width" in header.fields:
        width = int(header.fields.get("width") or (8 if is_block else 10)) or 1
        ends = (k for k, row in enumerate(below) if re.match(r"[\s/&-]*(?:end|\d+ points of )", row, re.IGNORECASE))
        end = -(-header.samples // 10) if is_block else next(ends, len(below))
        below = [" ".join(row[k : k + width] for k in range(0, len(row), width)) for row in below[:end]]
    fields, lines = fields_below(name, below, header.lines, None)
    check_count(name, len(fields), header.samples)
    samples = _samples(name, header.step, fields, lines, _unit(ACCELERATION, name, header.units))
    if header.scale:
        with quiet():  # numbers that are not finite are refused later
            return samples._replace(values=(samples.values - np.mean(samples.values)) * header.scale)
    return samples


# --- tables --------------------------------------------------------------------------------------------------------


def _of_table(quantity: RecordedQuantity, name: str, text: str, options: Options) -> list[Channel]:
    """Return the columns of a table other than its times.

    `quantity` is acceleration or pore pressure, `name` the name of the file, and `text` its content.
    """
    table = number_table(quantity, name, text)
    roles = _roles(quantity, name, table, options)
    width = 1 if roles == (WRAPPED,) else table.width
    fields, lines = fields_below(name, text.split("\n")[table.lines :], table.lines, table.separator, width)
    cells = [fields[k::width] for k in range(width)]
    lines = lines[::width]
    if table.stated:
        check_count(name, len(lines), float(table.stated))
    columns = _only(quantity, name, _with_roles(quantity, table.columns, cells, roles), options.column)
    time = _times(quantity, name, columns, cells, lines, table.step or options.step)
    columns_read = []
    for k, (column, of_column) in enumerate(zip(columns, cells, strict=True), 1):
        if column.role in (quantity.role, "vertical"):
            samples = _samples(name, time, of_column, lines, _unit_of_column(quantity, name, k, column, table.unit))
            label = table.component * (width == 1) or column.name
            role = column.role if roles or column.role == "vertical" else ""
            columns_read.append(Channel(k, label, role, "", samples))
        elif column.role not in ("time", SKIP):
            columns_read.append(Channel(k, column.name, "", column.reason if any(of_column) else "is empty"))
    return columns_read


def _roles(quantity: RecordedQuantity, name: str, table: NumberTable, options: Options) -> Names:
    """Return the roles of the columns from the options, empty if the option applies to other tables.

    `name` is the name of the file.
    """
    roles = options.roles(quantity)
    has_names = any(column.name for column in table.columns)
    if roles == (WRAPPED,) and (options.of_all or not has_names):
        return roles
    if len(roles) == table.width:
        return roles
    if roles and options.of_all:
        raise InputError("", [f"{name}: {{columns}} = {','.join(roles)!r}: the file has {table.width} columns"])
    return ()


def _only(quantity: RecordedQuantity, name: str, columns: list[Column], column: int | str | None) -> list[Column]:
    """Return the columns, where all but one are skipped if the user selects one.

    `name` is the name of the file, and `column` the name or number, from 1, of the selected column.
    """
    if column is None:
        return columns
    others = {place: other.name for place, other in enumerate(columns, 1) if other.role != "time"}
    (chosen,) = _chosen(name, others, column)
    roles = dict.fromkeys(others, SKIP) | {chosen: quantity.role}
    return [other._replace(role=roles.get(place, "time")) for place, other in enumerate(columns, 1)]


def _unit(quantity: RecordedQuantity, name: str, stated: str) -> str:
    """Return the unit stated by a column or header, empty if none is stated.

    `name` is the name of the file, and `stated` the unit as written there.
    """
    unit = unit_of(stated, quantity) if stated else ""
    if unit is None:
        raise ValueError(f"{name}: its header says the unit {stated!r}: must be one of {quantity.choice}")
    return unit


def _unit_of_column(quantity: RecordedQuantity, name: str, place: int, column: Column, above: str) -> str:
    """Return the unit of a column, stated by the column or by the header above it.

    `name` is the name of the file, `place` the number of the column from 1, and `above` the unit in the header.
    """
    unit = _unit(quantity, name, column.unit or above)
    other = unit_of(above, quantity)
    if other and other != unit:
        where = f"{name}: column {place} ({column.name})"
        why = "correct one of them"
        raise ValueError(f"{where}: its unit is {unit}, and {above!r} in the header above; {why}")
    return unit


def _with_roles(
    quantity: RecordedQuantity, named: list[Column], cells: Sequence[Texts], roles: Sequence[str]
) -> list[Column]:
    """Return the columns of a table with roles from the options, the header or conventions.

    `named` are the columns in the header, empty without names. `cells` are the fields of each column as text.
    """
    width = len(cells)
    columns = list(named) or [Column("")] * width
    if roles == (WRAPPED,) or (width == 1 and not named):
        return [Column("", "", quantity.role)]
    if roles:
        return [column._replace(role=role) for column, role in zip(columns, roles, strict=True)]
    first = plain_numbers(cells[0])
    is_time = is_even(first, _LONGEST_STEP)
    for k, (first_cell, *_) in enumerate(cells):
        if CLOCK.fullmatch(first_cell):
            columns[k] = columns[k]._replace(role="", reason=_CLOCK)
    if not columns[0].name and first.size > 2 and np.all(np.diff(first) == 1.0):
        columns[0] = Column("", reason=_COUNTER)
    elif not named and (quantity is not ACCELERATION or (width == 2 and is_time)):
        return [Column("", "", "time"), *[Column("", "", quantity.role)] * (width - 1)]
    elif (
        columns[0].name in ("", "T")
        and not is_time
        and all(np.all(x >= 0.0) or np.all(x <= 0.0) for x in map(plain_numbers, cells))
    ):
        why = "resembles the abscissae of a spectrum: uneven, beside values of one sign"
        columns[0] = columns[0]._replace(role="spectrum", reason=columns[0].reason or why)
    return columns


def _times(
    quantity: RecordedQuantity,
    name: str,
    columns: Sequence[Column],
    cells: Sequence[Texts],
    lines: Lines,
    step: float | None,
) -> Floats | float:
    """Return the times of the samples, or their step, in s.

    `cells` are the fields of each column as text, `lines` the line numbers of the rows, and `step` the time between
    samples, if known.

    Raises
    ------
    ValueError
        If times or record are missing. The message names the options that supply them.
    """
    roles = [column.role for column in columns]
    is_record = bool({quantity.role, "vertical"} & {*roles})
    if "time" in roles and is_record:
        clock = roles.index("time")
        unit = unit_of(columns[clock].unit or "s", TIME)
        if unit is None:
            raise ValueError(f"{name}: the times are in {columns[clock].unit!r}: must be {TIME.choice}; convert them")
        return parsed_numbers(name, cells[clock], lines) * TIME.units[unit]
    is_spectrum = "spectrum" in roles and "time" not in roles
    if step and is_record and not is_spectrum:
        return step
    reasons = [str(Channel(k, c.name, "", c.reason)) for k, c in enumerate(columns, 1) if c.reason]
    why = "; ".join(reasons or [f"its header does not name its {len(columns)} columns"])
    give = _roles_to_give(quantity, columns)
    if is_spectrum or not is_record:
        raise InputError("", [f"{name}: {why}; {'not a record, or ' * is_spectrum}give {give}"])
    lacks = f"has no times; {why}" if reasons else f"has {'one column and ' * (len(columns) == 1)}no times"
    other = f", or {give}" * (len(columns) > 1 and not reasons)
    raise InputError("", [f"{name}: {lacks}; give {{step}}, the time between samples in s{other}"])


def _roles_to_give(quantity: RecordedQuantity, columns: Sequence[Column]) -> str:
    """Return the option that states the roles of columns, with an example, as the end of a message."""
    leader = SKIP if columns[0].reason in (_CLOCK, _COUNTER) else "time"
    others = [column.role if column.role == "vertical" else quantity.role for column in columns[1:]]
    example = ",".join([leader, *others])
    series = f", or {WRAPPED} if each line has several values of one record" * (len(columns) > 2)
    each = f"one of time, {quantity.role}, vertical and {SKIP} for each of {len(columns)} columns"
    return f"{{columns}} {example}: {each}{series}"
