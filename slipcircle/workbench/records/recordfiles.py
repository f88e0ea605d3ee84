"""Files of samples, as PEER's AT2, ESM's and K-NET's ASCII, or a table: times, values and their unit."""

import io
import re
from array import array
from collections.abc import Mapping
from itertools import repeat
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import INFINITY, InputError
from slipcircle.base.series import Floats

UNITS = {"g": 0.0, "m/s2": 1.0, "cm/s2": 1e-2, "mm/s2": 1e-3, "%g": 0.0}  # m/s^2; g is the scene's own gravity
_SAME = {
    "m/s/s": "m/s2",
    "cm/s/s": "cm/s2",
    "cm/sec2": "cm/s2",
    "cm/sec/sec": "cm/s2",
    "mm/s/s": "mm/s2",
    "m/sec2": "m/s2",
    "gal": "cm/s2",
    "gals": "cm/s2",
    "m_s2": "m/s2",
    "cm_s2": "cm/s2",
    "mm_s2": "mm/s2",
    "ms-2": "m/s2",
    "g's": "g",
    "gs": "g",
}
MOST_BYTES = 2**30


class Quantity(NamedTuple):
    """What a file may hold: its units and their other names in lower case, how columns say them, kinds of files."""

    name: str
    units: Mapping[str, float]
    same: Mapping[str, str]
    choice: str
    suffix: str  # of a column's name
    kinds: str


ACCELERATION = Quantity(
    "acceleration",
    UNITS,
    _SAME,
    f"{', '.join(UNITS)}, gal",
    "(?:[cm]?m_s2)|g|gal",
    "CSV, AT2, or ESM's or K-NET's ASCII",
)
PORE_PRESSURE = Quantity(
    "pore pressure",
    {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "ratio": 1.0},
    {"r_u": "ratio", "ru": "ratio", "-": "ratio"},
    "Pa, kPa, MPa, ratio",
    "[kKM]?Pa",
    "CSV",
)


def unit_of(text: str, quantity: Quantity = ACCELERATION) -> str | None:
    """The unit of a quantity that a text stands for, as its ``units`` have it; None if it is none."""
    plain = re.sub(r"\s|\^|\*\*", "", text.strip().lower()).replace("²", "2")
    plain = quantity.same.get(plain, plain)
    return next((u for u in quantity.units if u.lower() == plain), None)


class Found(NamedTuple):
    """What a file holds, and the line of each sample, from 1."""

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


def parse(quantity: Quantity, name: str, path: Path, column: int | str | None, step: float | None) -> Found:
    """By what the first lines say."""
    text = _text(quantity, path, name)
    first = text[:20000].split("\n") if quantity is ACCELERATION else []
    headers = {"an AT2 file": _at2(name, first), "an ESM file": _esm(name, first), "a K-NET file": _knet(name, first)}
    for kind, header in headers.items():
        if header:
            for what, given in (("column", column), ("step", step)):
                if given is not None:
                    raise InputError(
                        "", [f"{name}: {{{what}}} = {given!r}: {kind} has one column and its own step; leave it out"]
                    )
            found = _wrapped(name, text, header)
            break
    else:
        found = _table(quantity, name, text, column, step)
    if (count := found.time.size) < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")
    return found


class Header(NamedTuple):
    """What the header of a file without times says."""

    lines: int
    samples: int
    step: float  # s between them
    units: str
    scale: float = 1.0  # of the numbers in the file
    about_mean: bool = False  # whether the instrument's offset, the mean, is to be taken off


def _at2(name: str, first: list[str]) -> Header | None:
    """PEER: ``NPTS= 5590, DT= .0050 SEC``, formerly ``5590 .0050 NPTS, DT``."""
    head = next((k for k, line in enumerate(first[:10], 1) if "NPTS" in line.upper() and "DT" in line.upper()), 0)
    if not head:
        return None
    above, line = " ".join(first[:head]).upper(), first[head - 1].upper()
    if "VELOCITY" in above or "DISPLACEMENT" in above:
        raise ValueError(f"{name}: its header says that it holds no acceleration; take the AT2 file of the record")
    number = r"([-+]?\d*\.?\d+(?:[ED][-+]?\d+)?)"
    new = re.search(rf"NPTS\s*=\s*{number}.*?DT\s*=\s*{number}", line)
    match = new or re.search(rf"^\s*{number}[\s,]+{number}[\s,]+NPTS", line)
    count, dt = (float(x.replace("D", "E")) for x in match.groups()) if match else (0.0, 0.0)
    if not (count >= 1.0 and count == int(count) and dt > 0.0):
        raise ValueError(
            f"{name}, line {head}: {first[head - 1].strip()!r}: must give NPTS and DT, as in 'NPTS= 4000, DT= .0050 "
            "SEC'"
        )
    said = re.search(r"UNITS OF\s+(\S+)", above)
    unit = unit_of(said.group(1).rstrip(".,")) if said else "g"
    if unit is None:
        raise ValueError(f"{name}: its header says {said and said.group(0)!r}: must be one of {ACCELERATION.choice}")
    return Header(head, int(count), dt, unit)


def _esm(name: str, first: list[str]) -> Header | None:
    """ESM and ITACA: 64 lines ``KEY: value``, then a value a line."""
    head = next((k for k, line in enumerate(first) if not re.match(r"#?\s*[A-Z][A-Z0-9_/()^-]*\s*:", line)), len(first))
    pairs = (line.lstrip("# ").partition(":") for line in first[:head])
    said = {key.strip(): value.strip() for key, _, value in pairs}
    if "SAMPLING_INTERVAL_S" not in said:
        return None
    kind = said.get("DATA_TYPE", "ACCELERATION")
    if kind.upper() != "ACCELERATION":
        raise ValueError(f"{name}: DATA_TYPE = {kind!r}: must be ACCELERATION; take the record's file of accelerations")
    try:
        dt, count = float(said["SAMPLING_INTERVAL_S"]), int(said["NDATA"])
    except (KeyError, ValueError) as error:
        raise ValueError(
            f"{name}: SAMPLING_INTERVAL_S and NDATA in its header must be a step in s and a count"
        ) from error
    if not 0.0 < dt < INFINITY:
        raise ValueError(f"{name}: SAMPLING_INTERVAL_S = {dt!r}: must be a positive time in s")
    unit = unit_of(said["UNITS"]) if said.get("UNITS") else ""
    if unit is None:
        raise ValueError(f"{name}: UNITS = {said['UNITS']!r}: must be one of {ACCELERATION.choice}")
    return Header(head, count, dt, unit)


def _knet(name: str, first: list[str]) -> Header | None:
    """K-NET and KiK-net: 17 lines of key and value, then counts, of which ``Scale Factor 3920(gal)/6182761`` is one.

    The instrument's offset is the mean of its counts, which "Max. Acc." in the header has been freed of.
    """
    keys = ("Sampling Freq(Hz)", "Duration Time(s)", "Scale Factor")
    text = {key: line[len(key) :].strip() for line in first[:30] for key in keys if line.startswith(key)}
    if "Scale Factor" not in text:
        return None
    head = next((k for k, line in enumerate(first, 1) if line.startswith("Memo")), 17)
    numbers = re.fullmatch(r"([\d.]+)\s*\(gal\)\s*/\s*([\d.]+)", text["Scale Factor"])
    frequency = re.match(r"[\d.]+", text.get(keys[0], ""))
    seconds = re.match(r"[\d.]+", text.get(keys[1], ""))
    if numbers is None or frequency is None or seconds is None:
        raise ValueError(
            f"{name}: its header must say Sampling Freq(Hz), Duration Time(s), and Scale Factor as in 3920(gal)/6182761"
        )
    rate, scale = float(frequency[0]), float(numbers[1]) / float(numbers[2])
    return Header(head, round(rate * float(seconds[0])), 1.0 / rate, "cm/s2", scale, about_mean=True)


def _wrapped(name: str, text: str, header: Header) -> Found:
    """Values without times, however many are on a line."""
    values, lines = _values(name, text, header.lines, None)
    if values.size != header.samples:
        raise ValueError(
            f"{name}: holds {values.size} values, but its header says {header.samples}; is the file cut short, or "
            "another's header on it?"
        )
    if header.about_mean:
        values = values - np.mean(values)
    return Found(header.step * np.arange(float(header.samples)), values * header.scale, header.units, lines)


def _table(quantity: Quantity, name: str, text: str, column: int | str | None, step: float | None) -> Found:
    """Numbers in columns after any header lines."""
    head, separator, width = _first_row(quantity, name, text)
    fields = _fields(text.split("\n", head)[:head], separator, width)
    if step is not None and column is None and not fields and width > 1:
        found = _row_by_row(name, text, head, separator, step)
        if found is not None:
            return found
    values, lines = _values(name, text, head, separator, width)
    if any(map(_is_number, fields)) and width > 1:  # no header, but a sample that is spoilt
        _values(name, text, head - 1, separator, width)
    numbers, lines = values.reshape(-1, width), lines[::width]
    suffix = rf"\s*[(\[]([^)\]]*)[)\]]\s*$|_({quantity.suffix})$"
    names = [re.sub(suffix, "", f) for f in fields]
    clock = _clock(name, fields, names, width, step)
    chosen = _column(quantity, name, column, names, [k for k in range(width) if k != clock])
    unit = re.search(suffix, fields[chosen]) if fields else None
    units = unit_of(unit.group(1) or unit.group(2) or "", quantity) if unit else None
    if clock is None:
        time = float(step or 0.0) * np.arange(float(len(numbers)))
    else:
        time = numbers[:, clock].copy()
    return Found(time, numbers[:, chosen].copy(), units or "", lines)


def _row_by_row(name: str, text: str, head: int, separator: str | None, step: float) -> Found | None:
    """Values along the lines, where these are no rows of columns."""
    values, lines = _values(name, text, head, separator)
    if not _along_lines(lines):
        return None
    return Found(step * np.arange(float(values.size)), values, "", lines)


def _clock(name: str, fields: list[str], names: list[str], width: int, step: float | None) -> int | None:
    """The column that holds the times; None where they follow from a step."""
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


def _said(line: str) -> str:
    """A line but for a comment, and blanks around it."""
    for mark in "#%!":
        if mark in line:
            line = line.partition(mark)[0]
    return line.strip()


def _split(line: str, separator: str | None) -> list[str]:
    """The fields of a line, without their quotes."""
    return [f.strip().strip('"') for f in line.split(separator)]


def _first_row(quantity: Quantity, name: str, text: str) -> tuple[int, str | None, int]:
    """Lines above the first that is all numbers, what separates them, and how many they are.

    Numbers above two lines that have another count of them both, such as a date, are of the header.
    """
    rows: list[tuple[int, str | None, int]] = []
    for k, line in enumerate(map(_said, io.StringIO(text))):
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
    """As `_first_row` has it, if a line is all numbers."""
    for separator in (";", ",", None):
        fields = _split(line, separator)
        if len(fields) > 1 and not fields[-1]:  # a separator ends the line
            fields.pop()
        if (separator is None or separator in line) and all(map(_is_number, fields)):
            return k, separator, len(fields)
    return None


def _along_lines(lines: NDArray[np.int64]) -> bool:
    """Whether lines are no rows of columns: more than three on each, only one line, or a last one cut short."""
    count = np.unique(lines, return_counts=True)[1]
    whole = np.all(count[:-1] == count[0]) and count[-1] <= count[0]
    return bool(whole and (count[0] > 3 or len(count) == 1 or count[-1] < count[0]))


def _is_number(field: str) -> bool:
    try:
        _number("", 0, field)
    except ValueError:
        return False
    return True


def _fields(above: list[str], separator: str | None, width: int) -> list[str]:
    """The names in the last line of the header, with their units; none if there are not as many as columns."""
    for line in filter(None, (x.strip() for x in reversed(above))):
        said = line.lstrip("#% \t")
        pattern = r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?"
        parts = _split(said, separator) if separator else [p.strip('"') for p in re.findall(pattern, said)]
        parts = parts[:-1] if separator and parts[-1:] == [""] else parts
        comment = not _said(line)
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
    found = [k for k in choice if names and names[k].lower() == str(column).strip().lower()]
    if not found and str(column).strip().isdecimal():
        found = [k for k in choice if k == int(column) - 1]
    if len(found) != 1:
        raise ValueError(f"{name}: column = {column!r}: must be one of {shown}")
    return found[0]


def _values(name: str, text: str, head: int, separator: str | None, width: int = 0) -> tuple[Floats, NDArray[np.int64]]:
    """Numbers below a header and the line of each: of a table of a width, or all in a row."""
    fields, lines = list[str](), array("q")
    for k, line in enumerate(map(_said, io.StringIO(text)), 1):
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
        found = array("d", map(float, fields))
    except ValueError:  # quotes, Fortran's exponents, or what is no number
        found = array("d", map(_number, repeat(name), lines, fields))
    return np.array(found), np.array(lines)


def _number(name: str, line: int, field: str) -> float:
    try:
        return float(field.strip().strip('"').replace("d", "E").replace("D", "E"))  # Fortran's exponents
    except ValueError:
        raise ValueError(
            f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line"
        ) from None
