"""Files of samples, with a header of a known kind or as a table: times, values and their unit."""

import io
import re
from array import array
from collections.abc import Iterator
from itertools import repeat
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import InputError
from slipcircle.base.kinds import Floats
from slipcircle.workbench.records.headers import (
    ACCELERATION,
    Header,
    Quantity,
    channels,
    fixed_columns,
    header_of,
    unit_of,
)

MOST_BYTES, MOST_NUMBERS = 2**28, 2**24


class Samples(NamedTuple):
    """Content of a file, and the line of each sample, from 1."""

    time: Floats
    values: Floats
    units: str
    lines: NDArray[np.int64]


def _text(quantity: Quantity, path: Path, name: str) -> str:
    try:
        size = path.stat().st_size
        if not path.is_file():  # but a folder, a device, or a pipe that never ends
            raise ValueError(f"{name}: is not a file; give the file of a record")
        if size > MOST_BYTES:
            most = f"must be at most {MOST_BYTES / 1e6:.0f} MB; cut or resample the record"
            raise ValueError(f"{name}: has {size / 1e6:.4g} MB: {most}")
        data = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from error
    is_blank = np.frombuffer(data, np.uint8) <= ord(",")
    count = np.count_nonzero(is_blank[1:] & ~is_blank[:-1])
    if count > MOST_NUMBERS:
        raise ValueError(f"{name}: holds {count:.2g} numbers: must be at most {MOST_NUMBERS:.2g}; cut or resample it")
    if b"\0" in data[:4096]:
        raise ValueError(f"{name}: is not text; save the record as {quantity.kinds}")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:  # old headers
        text = data.decode("latin-1")
    if not text.strip():
        raise ValueError(f"{name}: is empty; a record has two samples at least")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def parse(quantity: Quantity, name: str, path: Path, column: int | str | None, step: float | None) -> Samples:
    """Read a file of the kind that its first lines indicate."""
    parts = channels(_text(quantity, path, name))
    chosen = 0
    if len(parts) > 1:
        chosen = _column(quantity, name, column, [component for component, _ in parts], [*range(len(parts))])
        name, column = f"{name}, channel {chosen + 1}", None
    _, text = parts[chosen]
    return _of_header(quantity, name, text, column, step) or _of_table(quantity, name, text, column, step)


def _of_header(quantity: Quantity, name: str, text: str, column: Any, step: float | None) -> Samples | None:
    """Samples below a header of a known kind; None without one."""
    first_lines = text[:20000].split("\n")
    headed = header_of(name, first_lines) if quantity is ACCELERATION else None
    if headed is None:
        return None
    kind, header = headed
    for argument, value in (("column", column), ("step", step)):
        if value is not None:
            rule = f"{kind} has one column and its own step; leave it out"
            raise InputError("", [f"{name}: {{{argument}}} = {value!r}: {rule}"])
    return _wrapped(name, text, header)


def _several(name: str, samples: Samples) -> Samples:
    """Samples, of which a record has two at least."""
    count = samples.time.size
    if count < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")
    return samples


class Component(NamedTuple):
    """One record of a file: its name in a table of several, and the arguments with which `parse` reads it."""

    name: str = ""
    column: int | None = None
    step: float | None = None


def components(name: str, path: Path, step: float | None) -> Iterator[tuple[Component, Samples]]:
    """The records of acceleration in a file, which is read once; the step is for files without times."""
    parts = channels(_text(ACCELERATION, path, name))
    for place, (component, text) in enumerate(parts, 1):
        is_one = len(parts) == 1
        of_part = name if is_one else f"{name}, channel {place}"
        samples = _of_header(ACCELERATION, of_part, text, None, None)
        if samples is None:
            yield from _components_of_table(of_part, text, step)
        else:
            yield Component() if is_one else Component(component, place), samples


def _components_of_table(name: str, text: str, step: float | None) -> Iterator[tuple[Component, Samples]]:
    """The records in the columns of a table."""
    head = _table_head(ACCELERATION, name, text)
    runs_along_lines = False
    if not head.fields:
        _, lines = _values(name, text, head.lines, head.separator)
        runs_along_lines = _along_lines(lines)
    if head.width == 1 or runs_along_lines:
        yield Component(step=step), _of_table(ACCELERATION, name, text, None, step)
        return
    rows = _rows(name, text, head)
    clock = _clock(name, head.fields, head.names, head.width, None)
    columns = [k for k in range(head.width) if k != clock and not _is_other(head, k)]
    names = [""]
    if len(columns) > 1:
        names = [head.names[k] if head.names else str(k + 1) for k in columns]
    for label, k in zip(names, columns, strict=bool(columns)):
        column = k + 1
        yield Component(label, column), _of_column(ACCELERATION, name, head, rows, column, None)


def _is_other(head: "_TableHead", column: int) -> bool:
    """Whether a column is not an acceleration by its name or its unit."""
    if not head.fields:
        return False
    unit = re.search(head.suffix, head.fields[column])
    is_other_unit = unit is not None and unit_of(unit.group(1) or unit.group(2) or "") is None
    return is_other_unit or re.match("vel|dis", head.names[column], re.IGNORECASE) is not None


def _wrapped(name: str, text: str, header: Header) -> Samples:
    """Values without times, however many are on a line."""
    values, lines = _fixed(name, text, header) if header.width else _values(name, text, header.lines, None)
    if values.size != header.samples:
        raise ValueError(
            f"{name}: holds {values.size} values, but its header says {header.samples}; is the file cut short, or "
            "another's header on it?"
        )
    if header.about_mean:
        values = values - np.mean(values)
    time = header.step * np.arange(float(header.samples))
    return _several(name, Samples(time, values * header.scale, header.units, lines))


def _fixed(name: str, text: str, header: Header) -> tuple[Floats, NDArray[np.int64]]:
    """Values as of `_values` from columns of fixed width, up to the line that ends the samples."""
    below = text.split("\n")[header.lines :]
    ends = (k for k, line in enumerate(below) if re.match(r"\s*(?:end|\d+ points of )", line, re.IGNORECASE))
    end = next(ends, len(below))
    if any(" acceleration pts" in line.lower() for line in below[end:]):
        raise ValueError(f"{name}: holds several channels; save each in a file")
    fields = [fixed_columns([row], header.width) for row in below[:end]]
    apart = map(" ".join, fields)
    above = header.lines * [""]
    separated = "\n".join([*above, *apart])
    return _values(name, separated, header.lines, None)


class _TableHead(NamedTuple):
    """The header of a table: number of lines, separator, number of columns, and fields of its last line."""

    lines: int
    separator: str | None
    width: int
    fields: list[str]  # of each column with its unit; empty if there are none
    names: list[str]  # the same without units
    suffix: str  # expression of a unit in a field


def _table_head(quantity: Quantity, name: str, text: str) -> _TableHead:
    lines, separator, width = _first_row(quantity, name, text)
    fields = _fields(text.split("\n", lines)[:lines], separator, width)
    suffix = rf"\s*[(\[]([^)\]]*)[)\]]\s*$|_({quantity.suffix})$"
    names = [re.sub(suffix, "", f) for f in fields]
    return _TableHead(lines, separator, width, fields, names, suffix)


_Rows = tuple[Floats, NDArray[np.int64]]  # numbers of a table, (rows, columns), and their lines


def _of_table(quantity: Quantity, name: str, text: str, column: int | str | None, step: float | None) -> Samples:
    """Numbers in columns after any header lines."""
    head = _table_head(quantity, name, text)
    if step is not None and column is None and not head.fields and head.width > 1:
        samples = _row_by_row(name, text, head.lines, head.separator, step)
        if samples is not None:
            return samples
    return _of_column(quantity, name, head, _rows(name, text, head), column, step)


def _rows(name: str, text: str, head: _TableHead) -> _Rows:
    """The numbers of a table, and the line of each row."""
    values, lines = _values(name, text, head.lines, head.separator, head.width)
    if any(map(_is_number, head.fields)) and head.width > 1:  # not a header but a damaged sample
        _values(name, text, head.lines - 1, head.separator, head.width)
    return values.reshape(-1, head.width), lines[:: head.width]


def _of_column(
    quantity: Quantity, name: str, head: _TableHead, rows: _Rows, column: int | str | None, step: float | None
) -> Samples:
    """The samples in a column of a table."""
    numbers, lines = rows
    clock = _clock(name, head.fields, head.names, head.width, step)
    chosen = _column(quantity, name, column, head.names, [k for k in range(head.width) if k != clock])
    unit = re.search(head.suffix, head.fields[chosen]) if head.fields else None
    units = unit_of(unit.group(1) or unit.group(2) or "", quantity) if unit else None
    if clock is None:
        time = float(step or 0.0) * np.arange(float(len(numbers)))
    else:
        time = numbers[:, clock].copy()
    return _several(name, Samples(time, numbers[:, chosen].copy(), units or "", lines))


def _row_by_row(name: str, text: str, head: int, separator: str | None, step: float) -> Samples | None:
    """Values along lines that are not rows of columns."""
    values, lines = _values(name, text, head, separator)
    if not _along_lines(lines):
        return None
    return Samples(step * np.arange(float(values.size)), values, "", lines)


def _clock(name: str, fields: list[str], names: list[str], width: int, step: float | None) -> int | None:
    """The column of times; None if they follow from a step."""
    timed = (k for k, n in enumerate(names) if re.fullmatch(r"t|time\w*|zeit|temps|tempo", n.lower()))
    clock = next(timed, None)
    if step is not None and clock is not None:
        why = f"its column {names[clock]!r} holds the times; leave it out"
        raise InputError("", [f"{name}: {{step}} = {step!r}: {why}"])
    if step is None and width == 1:
        raise InputError("", [f"{name}: has one column and no times; give {{step}}, the time between samples in s"])
    if step is None:
        clock = clock or 0
    unit = re.search(_OTHER_CLOCK, fields[clock], re.IGNORECASE) if fields and clock is not None else None
    if unit is not None and clock is not None:
        raise ValueError(f"{name}: its column {fields[clock]!r} says {unit.group(1)}: must be s; convert the times")
    return clock


def _without_comment(line: str) -> str:
    """A line without comment and surrounding blanks."""
    for mark in "#%!":
        if mark in line:
            line = line.partition(mark)[0]
    return line.strip()


def _split(line: str, separator: str | None) -> list[str]:
    """The fields of a line, without their quotes."""
    return [f.strip().strip('"') for f in line.split(separator)]


def _first_row(quantity: Quantity, name: str, text: str) -> tuple[int, str | None, int]:
    """Number of lines above the first row of numbers, its separator, and its number of columns.

    A row of numbers followed by two rows of another length, such as a date, belongs to the header.
    """
    rows: list[tuple[int, str | None, int]] = []
    for k, line in enumerate(map(_without_comment, io.StringIO(text))):
        if line:
            row = _row(k, line)
            if row is None and ";" in line and all(_is_number(f.replace(",", ".")) for f in line.split(";")):
                raise ValueError(f"{name}, line {k + 1}: {line[:60]!r}: decimal commas; write points instead")
            rows += [row] if row else []
            if rows and (row is None or len(rows) == 3):
                break
    if not rows:
        raise ValueError(
            f"{name}: has no line of numbers; a record has a line of time and {quantity.name} for each sample"
        )
    widths = [row[2] for row in rows]
    return rows[1] if len(rows) == 3 and widths[1] == widths[2] != widths[0] else rows[0]


def _row(k: int, line: str) -> tuple[int, str | None, int] | None:
    """The separator and number of columns of a line of numbers."""
    for separator in (";", ",", None):
        fields = _split(line, separator)
        if len(fields) > 1 and not fields[-1]:  # a separator ends the line
            fields.pop()
        if (separator is None or separator in line) and all(map(_is_number, fields)):
            return k, separator, len(fields)
    return None


def _along_lines(lines: NDArray[np.int64]) -> bool:
    """Whether values run along lines: more than three on each, a single line, or a shorter last one."""
    _, counts = np.unique(lines, return_counts=True)
    first = counts[0]
    last = counts[-1]
    is_even = np.all(counts[:-1] == first) and last <= first
    is_single = len(counts) == 1
    return bool(is_even and (first > 3 or is_single or last < first))


def _is_number(field: str) -> bool:
    try:
        _number("", 0, field)
    except ValueError:
        return False
    return True


def _fields(above: list[str], separator: str | None, width: int) -> list[str]:
    """Names of columns in the last line of the header, with units; empty if their number is wrong."""
    for line in filter(None, (x.strip() for x in reversed(above))):
        plain = line.lstrip("#% \t")
        pattern = r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?"
        parts = _split(plain, separator) if separator else [p.strip('"') for p in re.findall(pattern, plain)]
        parts = parts[:-1] if separator and parts[-1:] == [""] else parts
        comment = not _without_comment(line)
        if len(parts) == width and not (comment and (line[0] == "!" or any(map(_is_number, parts)))):
            return parts
        if not comment:
            break
    return []


_OTHER_CLOCK = r"(?:[(\[,_ ])\s*(ms|min(?:ute)?s?|h|hrs?|hours?|d|days?|weeks?|years?)\s*[)\]]?\s*$"


def _column(quantity: Quantity, name: str, column: int | str | None, names: list[str], choice: list[int]) -> int:
    shown = ", ".join(f"{k + 1} ({names[k]})" if names else str(k + 1) for k in choice)
    if column is None:
        if len(choice) == 1:
            return choice[0]
        raise ValueError(f"{name}: has several columns of {quantity.name}; give column, one of {shown}")
    requested = str(column).strip().lower()
    matches = [k for k in choice if names and names[k].lower() == requested]
    if not matches and requested.isdecimal():
        matches = [k for k in choice if k == int(requested) - 1]
    if len(matches) != 1:
        raise ValueError(f"{name}: column = {column!r}: must be one of {shown}")
    return matches[0]


def _values(name: str, text: str, head: int, separator: str | None, width: int = 0) -> tuple[Floats, NDArray[np.int64]]:
    """Numbers below a header and their lines: of a table with so many columns, or all in sequence."""
    fields, lines = list[str](), array("q")
    for k, line in enumerate(map(_without_comment, io.StringIO(text)), 1):
        if k <= head or not line:
            continue
        row = line.split(separator)
        if not row[-1] and len(row) != width:
            row.pop()
        if width and len(row) != width:
            raise ValueError(
                f"{name}, line {k}: has {len(row)} field{'s' * (len(row) != 1)}, where the first row has "
                f"{width}; mend the line"
            )
        fields += row
        lines.extend([k] * len(row))
    try:
        values = array("d", map(float, fields))
    except ValueError:  # quotes, Fortran's exponents, or an invalid number
        values = array("d", map(_number, repeat(name), lines, fields))
    return np.array(values), np.array(lines)


def _number(name: str, line: int, field: str) -> float:
    try:
        return float(field.strip().strip('"').replace("d", "E").replace("D", "E"))  # Fortran's exponents
    except ValueError:
        raise ValueError(
            f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line"
        ) from None
