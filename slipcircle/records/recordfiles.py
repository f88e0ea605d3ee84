"""Files of samples, as PEER's AT2, ESM's ASCII, or a table after any header lines: times, values and their unit."""

import io
import re
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np

from slipcircle.base.checks import INFINITY
from slipcircle.base.series import Floats

UNITS = {"g": 0.0, "m/s2": 1.0, "cm/s2": 1e-2, "mm/s2": 1e-3, "%g": 0.0}  # m/s^2; g is the scene's own gravity
_SAME = {"m/s/s": "m/s2", "cm/s/s": "cm/s2", "cm/sec2": "cm/s2", "cm/sec/sec": "cm/s2", "mm/s/s": "mm/s2",
         "m/sec2": "m/s2", "gal": "cm/s2", "gals": "cm/s2", "m_s2": "m/s2", "cm_s2": "cm/s2", "mm_s2": "mm/s2",
         "ms-2": "m/s2", "g's": "g", "gs": "g"}  # fmt: skip
MOST_BYTES = 2**30


class Quantity(NamedTuple):
    """What a file may hold: its units and their other names in lower case, how columns say them, kinds of files."""

    name: str
    units: Mapping[str, float]
    same: Mapping[str, str]
    choice: str
    suffix: str  # of a column's name
    kinds: str


ACCELERATION = Quantity("acceleration", UNITS, _SAME, f"{', '.join(UNITS)}, gal", "(?:[cm]?m_s2)|g|gal",
                        "CSV, AT2 or ESM's ASCII")  # fmt: skip
PORE_PRESSURE = Quantity("pore pressure", {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "ratio": 1.0},
                         {"r_u": "ratio", "ru": "ratio", "-": "ratio"}, "Pa, kPa, MPa, ratio", "[kKM]?Pa",
                         "CSV")  # fmt: skip


def unit_of(text: str, quantity: Quantity = ACCELERATION) -> str | None:
    """The unit of a quantity that a text stands for, as its ``units`` have it; None if it is none."""
    plain = re.sub(r"\s|\^|\*\*", "", text.strip().lower()).replace("²", "2")
    plain = quantity.same.get(plain, plain)
    return next((u for u in quantity.units if u.lower() == plain), None)


class Found(NamedTuple):
    """What a file holds."""

    time: Floats
    values: Floats
    units: str
    head: int  # lines of the header
    text: str  # below them

    def line(self, sample: int) -> int:
        """The number of the line on which a sample stands, from 1."""
        wrapped = self.time.size != sum(1 for x in self.text.split("\n") if _said(x))
        seen = 0
        for number, x in enumerate(map(_said, self.text.split("\n")), self.head + 1):
            seen += len(x.split()) if wrapped else bool(x)
            if seen > sample:
                return number
        return self.head


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
    for k, line in enumerate(first[:10]):
        if "NPTS" in line.upper() and "DT" in line.upper():
            return _at2(name, text, first[: k + 1], column, step)
    if any(line.lstrip("# ").startswith("SAMPLING_INTERVAL_S:") for line in first):
        return _esm(name, text, first, column, step)
    return _table(quantity, name, path, text, column, step)


def _wrapped(name: str, text: str, head: int, count: int, step: float, units: str) -> Found:
    """Values without times, however many are on a line."""
    body = text.split("\n", head)[head] if text.count("\n") >= head else ""
    values = _slow_table(name, body, head, None)
    if values.size != count:
        raise ValueError(
            f"{name}: holds {values.size} values, but its header says {count}; is the file cut short, or another's "
            "header on it?"
        )
    _enough(name, values.size)
    return Found(step * np.arange(float(count)), values, units, head, body)


def _alone(name: str, kind: str, column: int | str | None, step: float | None) -> None:
    for what, given in (("column", column), ("step", step)):
        if given is not None:
            raise ValueError(f"{name}: {what} = {given!r}: {kind} has one column and its own step; leave {what} out")


def _at2(name: str, text: str, head: list[str], column: int | str | None, step: float | None) -> Found:
    """PEER: ``NPTS= 5590, DT= .0050 SEC``, formerly ``5590 .0050 NPTS, DT``."""
    _alone(name, "an AT2 file", column, step)
    above = " ".join(head).upper()
    if "VELOCITY" in above or "DISPLACEMENT" in above:
        raise ValueError(f"{name}: its header says that it holds no acceleration; take the AT2 file of the record")
    number = r"([-+]?\d*\.?\d+(?:[ED][-+]?\d+)?)"
    line = head[-1].upper()
    new = re.search(rf"NPTS\s*=\s*{number}.*?DT\s*=\s*{number}", line)
    old = re.search(rf"^\s*{number}[\s,]+{number}[\s,]+NPTS", line)
    match = new or old
    count, dt = (float(x.replace("D", "E")) for x in match.groups()) if match else (0.0, 0.0)
    if not (count >= 1.0 and count == int(count) and dt > 0.0):
        raise ValueError(
            f"{name}, line {len(head)}: {head[-1].strip()!r}: must give NPTS and DT, as in 'NPTS= 4000, DT= .0050 SEC'"
        )
    said = re.search(r"UNITS OF\s+(\S+)", above)
    unit = unit_of(said.group(1).rstrip(".,")) if said else "g"
    if unit is None:
        raise ValueError(f"{name}: its header says {said and said.group(0)!r}: must be one of {', '.join(UNITS)}, gal")
    return _wrapped(name, text, len(head), int(count), dt, unit)


def _esm(name: str, text: str, first: list[str], column: int | str | None, step: float | None) -> Found:
    """ESM and ITACA: 64 lines ``KEY: value``, then a value a line."""
    _alone(name, "an ESM file", column, step)
    head = next((k for k, line in enumerate(first) if not re.match(r"#?\s*[A-Z][A-Z0-9_/()^-]*\s*:", line)), len(first))
    pairs = (line.lstrip("# ").partition(":") for line in first[:head])
    said = {key.strip(): value.strip() for key, _, value in pairs}
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
    unit = unit_of(said.get("UNITS", "")) if said.get("UNITS") else ""
    if unit is None:
        raise ValueError(f"{name}: UNITS = {said['UNITS']!r}: must be one of {', '.join(UNITS)}, gal")
    return _wrapped(name, text, head, count, dt, unit)


def _table(quantity: Quantity, name: str, path: Path, text: str, column: int | str | None, step: float | None) -> Found:
    """Numbers in columns after any header lines."""
    head, separator, width, ends = _first_row(quantity, name, text)
    above = text.split("\n", head)[:head]
    body = text.split("\n", head)[head]
    fields = _fields(above, separator, width)
    if (
        step is not None
        and column is None
        and not fields
        and width > 1
        and (found := _rows(name, body, head, separator))
    ):
        return Found(step * np.arange(float(found[0].size)), found[0], "", head, body)
    mark = next((c for c in _COMMENTS if c in body), None)
    try:
        numbers: Floats = np.loadtxt(
            path, delimiter=separator, skiprows=head, comments=mark, ndmin=2, encoding="latin-1", quotechar='"',
            usecols=range(width) if ends else None,
        )  # fmt: skip
    except ValueError:  # says neither line nor field as we would, and knows no exponents but E
        numbers = _slow_table(name, body, head, separator, width)
    if any(map(_is_number, fields)) and width > 1:  # no header, but a sample that is spoilt
        _slow_table(name, above[-1], head - 1, separator, width)
    suffix = rf"\s*[(\[]([^)\]]*)[)\]]\s*$|_({quantity.suffix})$"
    names = [re.sub(suffix, "", f) for f in fields]
    clock = next((k for k, n in enumerate(names) if re.fullmatch(r"t|time\w*|zeit|temps|tempo", n.lower())), None)
    if step is not None and clock is not None:
        raise ValueError(f"{name}: step = {step!r}: its column {names[clock]!r} holds the times; leave step out")
    if step is None and width == 1:
        raise ValueError(f"{name}: has one column and no times; give step, the time between samples in s")
    if step is None:
        clock = 0 if clock is None else clock
    if fields and clock is not None and (said := re.search(_OTHER_CLOCK, fields[clock], re.IGNORECASE)):
        raise ValueError(f"{name}: its column {fields[clock]!r} says {said.group(1)}: must be s; convert the times")
    choice = [k for k in range(width) if k != clock]
    chosen = _column(quantity, name, column, names, choice)
    _enough(name, len(numbers))
    match = re.search(suffix, fields[chosen]) if fields else None
    unit = (unit_of(match.group(1) or match.group(2) or "", quantity) or "") if match else ""
    if clock is None:
        time = float(step or 0.0) * np.arange(float(len(numbers)))
    else:
        time = numbers[:, clock].copy()
    return Found(time, numbers[:, chosen].copy(), unit, head, body)


_COMMENTS = ["#", "%", "!"]  # begin a line that says nothing in numbers


def _said(line: str) -> str:
    """A line but for blanks around it; nothing of a comment."""
    line = line.strip()
    return "" if line[:1] in _COMMENTS else line


def _split(line: str, separator: str | None) -> list[str]:
    """The fields of a line, without their quotes."""
    return [f.strip().strip('"') for f in line.split(separator)]


def _first_row(quantity: Quantity, name: str, text: str) -> tuple[int, str | None, int, bool]:
    """Lines above the first that is all numbers, what separates them, how many, and whether a separator ends the line.

    Numbers above two lines that have another count of them both, such as a date, are of the header.
    """
    rows: list[tuple[int, str | None, int, bool]] = []
    for k, line in enumerate(map(_said, io.StringIO(text))):
        if line:
            row = _numbers(k, line)
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


def _numbers(k: int, line: str) -> tuple[int, str | None, int, bool] | None:
    """As `_first_row` has it, if a line is all numbers."""
    for separator in (";", ",", None):
        if separator is None or separator in line:
            fields = _split(line, separator)
            ends = len(fields) > 1 and not fields[-1]
            fields = fields[:-1] if ends else fields
            if fields and all(map(_is_number, fields)):
                return k, separator, len(fields), ends
    return None


def _rows(name: str, body: str, head: int, separator: str | None) -> list[Floats]:
    """The values of lines that are no rows of columns: more than three on each, only one line, or a last one cut short.

    Empty where they may be columns.
    """
    counts = [len(_split(line, separator)) for x in io.StringIO(body) if (line := _said(x))]
    if len(set(counts[:-1])) > 1 or counts[-1] > counts[0]:
        return []
    if counts[0] <= 3 and len(counts) > 1 and counts[-1] == counts[0]:
        return []
    return [_slow_table(name, body, head, separator)]


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


def _enough(name: str, count: int) -> None:
    if count < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")


def _slow_table(name: str, body: str, head: int, separator: str | None, width: int = 0) -> Floats:
    """Numbers line by line, so that the line that is wrong can be named: a table of a width, or all in a row."""
    found = []
    for k, line in enumerate(io.StringIO(body), head + 1):
        fields = _split(line, separator) if _said(line) else []
        fields = fields[:-1] if fields and not fields[-1] and len(fields) != width else fields
        if width and fields and len(fields) != width:
            raise ValueError(
                f"{name}, line {k}: has {len(fields)} field{'s' * (len(fields) != 1)}, where the first row has "
                f"{width}; mend the line"
            )
        found += [_number(name, k, f) for f in fields]
    return np.array(found, dtype=np.float64).reshape(-1, *([width] if width else []))


def _number(name: str, line: int, field: str) -> float:
    try:
        return float(field.replace("d", "E").replace("D", "E"))  # Fortran's exponents
    except ValueError:
        raise ValueError(
            f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line"
        ) from None
