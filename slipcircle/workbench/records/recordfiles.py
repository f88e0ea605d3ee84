"""Files of samples, with a header of a known kind or as a table: times, values and their unit."""

import io
import re
from array import array
from itertools import repeat
from pathlib import Path
from typing import NamedTuple

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

MOST_BYTES = 2**30


class Samples(NamedTuple):
    """Content of a file, and the line of each sample, from 1."""

    time: Floats
    values: Floats
    units: str
    lines: NDArray[np.int64]


def _text(quantity: Quantity, path: Path, name: str) -> str:
    try:
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise ValueError(f"{name}: has {size / 1e9:.3g} GB: must be at most 1 GB; cut or resample the record")
        data = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from error
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
    text = parts[chosen][1]
    headed = header_of(name, _first_lines(text)) if quantity is ACCELERATION else None
    if headed is None:
        samples = _table(quantity, name, text, column, step)
    else:
        kind, header = headed
        for argument, value in (("column", column), ("step", step)):
            if value is not None:
                rule = f"{kind} has one column and its own step; leave it out"
                raise InputError("", [f"{name}: {{{argument}}} = {value!r}: {rule}"])
        samples = _wrapped(name, text, header)
    count = samples.time.size
    if count < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")
    return samples


def _first_lines(text: str) -> list[str]:
    return text[:20000].split("\n")


class Component(NamedTuple):
    """One record of a file: its name in a table of several, and the arguments with which `parse` reads it."""

    name: str = ""
    column: int | None = None
    step: float | None = None


def components(name: str, path: Path, step: float | None) -> list[Component]:
    """The records of acceleration in a file; the step is for files without times."""
    parts = channels(_text(ACCELERATION, path, name))
    if len(parts) > 1:
        return [Component(component, place) for place, (component, _) in enumerate(parts, 1)]
    text = parts[0][1]
    if header_of(name, _first_lines(text)):
        return [Component()]
    head = _table_head(ACCELERATION, name, text)
    has_no_times = head.width == 1 or (
        not head.fields and _along_lines(_values(name, text, head.lines, head.separator)[1])
    )
    if has_no_times:
        return [Component(step=step)]
    clock = _clock(name, head.fields, head.names, head.width, None)
    columns = [k for k in range(head.width) if k != clock and not _is_other(head, k)]
    of_table = [Component(head.names[k] if head.names else str(k + 1), k + 1) for k in columns]
    return of_table if len(of_table) > 1 else [component._replace(name="") for component in of_table]


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
    return Samples(header.step * np.arange(float(header.samples)), values * header.scale, header.units, lines)


def _fixed(name: str, text: str, header: Header) -> tuple[Floats, NDArray[np.int64]]:
    """Values as of `_values` from columns of fixed width, up to the line that ends the samples."""
    below = text.split("\n")[header.lines :]
    ends = (k for k, line in enumerate(below) if re.match(r"\s*(?:end|\d+ points of )", line, re.IGNORECASE))
    end = next(ends, len(below))
    if any(" acceleration pts" in line.lower() for line in below[end:]):
        raise ValueError(f"{name}: holds several channels; save each in a file")
    values = []
    numbers = []
    for number, row in enumerate(below[:end], header.lines + 1):
        for text_of_value in fixed_columns([row], header.width):
            values.append(_number(name, number, text_of_value))
            numbers.append(number)
    return np.array(values), np.array(numbers)


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


def _table(quantity: Quantity, name: str, text: str, column: int | str | None, step: float | None) -> Samples:
    """Numbers in columns after any header lines."""
    head, separator, width, fields, names, suffix = _table_head(quantity, name, text)
    if step is not None and column is None and not fields and width > 1:
        samples = _row_by_row(name, text, head, separator, step)
        if samples is not None:
            return samples
    values, lines = _values(name, text, head, separator, width)
    if any(map(_is_number, fields)) and width > 1:  # not a header but a damaged sample
        _values(name, text, head - 1, separator, width)
    numbers, lines = values.reshape(-1, width), lines[::width]
    clock = _clock(name, fields, names, width, step)
    chosen = _column(quantity, name, column, names, [k for k in range(width) if k != clock])
    unit = re.search(suffix, fields[chosen]) if fields else None
    units = unit_of(unit.group(1) or unit.group(2) or "", quantity) if unit else None
    if clock is None:
        time = float(step or 0.0) * np.arange(float(len(numbers)))
    else:
        time = numbers[:, clock].copy()
    return Samples(time, numbers[:, chosen].copy(), units or "", lines)


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
    return bool(is_even and (first > 3 or len(counts) == 1 or last < first))


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
    plain = _plain_values(text, head, separator, width)
    if plain is not None:
        return plain
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


def _plain_values(text: str, head: int, separator: str | None, width: int) -> tuple[Floats, NDArray[np.int64]] | None:
    """The same, five times as fast, of rows of numbers alone; None where there is anything else."""
    rows = text.rstrip("\n").split("\n")[head:]
    per_row = [len(row.split(separator)) for row in rows]
    is_even = per_row.count(width) == len(rows) if width else 0 not in per_row
    fields = (separator or " ").join(rows).split(separator)
    if not is_even or len(fields) != sum(per_row):
        return None
    try:
        values = array("d", map(float, fields))
    except ValueError:
        return None
    return np.array(values), np.repeat(np.arange(head + 1, head + 1 + len(rows)), per_row)


def _number(name: str, line: int, field: str) -> float:
    try:
        return float(field.strip().strip('"').replace("d", "E").replace("D", "E"))  # Fortran's exponents
    except ValueError:
        raise ValueError(
            f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line"
        ) from None
