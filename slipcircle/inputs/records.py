"""Acceleration records read from files, as what shakes a scene.

Signs. A scene's ``k_h`` is the *driving* acceleration over gravity, in the sense of positive rotation: to the right,
which is down-slope for a positive dip. In the frame of the ground the mass feels the opposite of what the ground does,
so that ground which accelerates to the right drives the mass to the left: driving = -ground. Likewise ``k_v``, which
lightens the mass, is minus the upward acceleration of the ground. A record must therefore say what it holds.
"""

import re
from collections.abc import Iterable
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from slipcircle.checks import INFINITY, Bounds, mistakes, raise_all
from slipcircle.inputs.series import PULSES, Floats, Pulse, Series, Shaking, bad_sample

__all__ = ["PULSES", "Pulse", "Series", "Shaking", "UNITS", "read_record", "unit_of"]

UNITS = {"g": 0.0, "m/s2": 1.0, "cm/s2": 1e-2, "mm/s2": 1e-3}  # m/s^2; g is the scene's own gravity
_SAME = {"m/s/s": "m/s2", "cm/s/s": "cm/s2", "cm/sec2": "cm/s2", "cm/sec/sec": "cm/s2", "mm/s/s": "mm/s2",
         "m/sec2": "m/s2", "gal": "cm/s2", "gals": "cm/s2", "m_s2": "m/s2", "cm_s2": "cm/s2", "mm_s2": "mm/s2",
         "ms-2": "m/s2"}  # fmt: skip
MOST_BYTES = 2**30
_GAP = 1.5  # of an evenly sampled record's step


def read_record(
    path: str | PathLike[str],
    *,
    holds: Literal["ground", "driving"],
    units: str | None = None,
    column: int | str | None = None,
    step: float | None = None,
    scale: float = 1.0,
    start: float | None = None,
    gravity: float = 9.81,
    gaps: Literal["refuse", "linear"] = "refuse",
) -> Series:
    """An acceleration record as shaking: driving acceleration over gravity, zero before and after.

    Reads PEER's AT2 (NPTS and DT in the header, values in g), ESM's ASCII (SAMPLING_INTERVAL_S, NDATA and UNITS in
    the header), and tables of numbers after any header lines: separated by commas, semicolons, tabs or blanks, with a
    column of time and one or more of acceleration, or with one column and a fixed ``step``.

    Parameters
    ----------
    path : str or path-like
    holds : {"ground", "driving"}
        What the file holds. Ground acceleration counts positive to the right (upwards, for a vertical record); what
        it does to the mass is the opposite, so the values change their sign.
    units : {"g", "m/s2", "cm/s2", "gal", "mm/s2"}, optional
        Needed where the file does not say it.
    column : int or str, optional
        Which column holds the acceleration: its name in the header, or its number, from 1. Needed where there is a
        choice.
    step : float, optional
        s between samples, for a file without times.
    scale : float, optional
        Factor on the values: -1 turns the record around, 1.2 amplifies it.
    start : float, optional
        Time of the first sample, s; by default the file's own, or 0.
    gravity : float, optional
        m/s^2, over which accelerations in other units than g are taken.
    gaps : {"refuse", "linear"}, optional
        What happens where samples are missing from an evenly sampled record: an error, or a straight line.

    Returns
    -------
    Series

    Raises
    ------
    ValueError
        Names the file, the line, the value, what is allowed and what to do.
    """
    name = str(path)
    if holds not in ("ground", "driving"):
        raise ValueError(
            f'holds = {holds!r}: must be "ground" (acceleration of the ground) or "driving" (its opposite)'
        )
    if gaps not in ("refuse", "linear"):
        raise ValueError(f'gaps = {gaps!r}: must be "refuse" or "linear"')
    bounds: dict[str, Bounds] = {
        "scale": (-INFINITY, INFINITY, "a finite factor"),
        "gravity": (0.0, INFINITY, "a positive number in m/s^2"),
        "step": (0.0, INFINITY, "a positive time in s"),
        "start": (-5e-324, INFINITY, "a time in s, not before 0"),
    }
    given: dict[str, Any] = {"scale": scale, "gravity": gravity, "step": step, "start": start}
    given = {n: v for n, v in given.items() if v is not None}
    raise_all(name, mistakes(given, {n: bounds[n] for n in given}))
    asked = None if units is None else unit_of(units)
    if units is not None and asked is None:
        raise ValueError(f"{name}: units = {units!r}: must be one of {', '.join(UNITS)}, gal")
    found = _parse(name, Path(path), column, step)
    said = found.units
    if said and asked and said != asked:
        raise ValueError(f"{name}: units = {units!r}, but its header says {said}; leave units out, or mend the header")
    if not said and not asked:
        raise ValueError(
            f"{name}: units are missing: its header names none; give units, one of {', '.join(UNITS)}, gal"
        )
    wrong = bad_sample(found.time, found.values)
    if wrong is None and gaps == "refuse":
        wrong = _gap(found.time)
    if wrong is not None:
        raise ValueError(f"{name}, line {found.line(wrong[0])}: {wrong[1]}")
    time = found.time if start is None else found.time - found.time[0] + start
    if time[0] < 0.0:
        raise ValueError(
            f"{name}, line {found.line(0)}: time = {float(time[0])!r} s: must not be before 0, when the scene starts; "
            "give start, the time of the first sample in s"
        )
    factor = (UNITS[asked or said] / gravity if (asked or said) != "g" else 1.0) * scale
    return Series(time, found.values * (-factor if holds == "ground" else factor) + 0.0, held=False)


def unit_of(text: str) -> str | None:
    """The unit of acceleration that a text stands for, as `UNITS` has it; None if it is none."""
    plain = re.sub(r"\s|\^|\*\*", "", text.strip().lower()).replace("²", "2")
    plain = _SAME.get(plain, plain)
    return plain if plain in UNITS else None


def _gap(time: Floats) -> tuple[int, str] | None:
    """The sample after a gap in a record that is otherwise evenly sampled; what is uneven has no gaps."""
    steps = np.diff(time)
    usual = float(np.median(steps))
    even = np.abs(steps - usual) <= 0.01 * usual + 8 * 2.0**-52 * time[-1]
    wide = np.flatnonzero(steps > _GAP * usual)
    if steps.size < 8 or not wide.size or np.count_nonzero(even) < 0.9 * steps.size:
        return None
    k = int(wide[0]) + 1
    return k, (
        f"time = {float(time[k])!r} s comes {float(steps[k - 1]):.6g} s after the sample before, where the step is "
        f'{usual:.6g} s: samples are missing; fill them in, or give gaps = "linear" for a straight line'
    )


class _Found(NamedTuple):
    """What a file holds."""

    time: Floats
    values: Floats
    units: str
    head: int  # lines of the header
    text: str  # below them

    def line(self, sample: int) -> int:
        """The number of the line on which a sample stands, from 1."""
        wrapped = self.time.size != sum(1 for x in self.text.split("\n") if x.strip())
        seen = 0
        for number, x in enumerate(self.text.split("\n"), self.head + 1):
            seen += len(x.split()) if wrapped else bool(x.strip())
            if seen > sample:
                return number
        return self.head


def _text(path: Path, name: str) -> str:
    try:
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise ValueError(f"{name}: has {size / 1e9:.3g} GB: must be at most 1 GB; cut or resample the record")
        data = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from error
    if b"\0" in data[:4096]:
        raise ValueError(f"{name}: is not text; save the record as CSV, AT2 or ESM's ASCII")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:  # old headers
        text = data.decode("latin-1")
    if not text.strip():
        raise ValueError(f"{name}: is empty; a record has two samples at least")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _parse(name: str, path: Path, column: int | str | None, step: float | None) -> _Found:
    """By what the first lines say."""
    text = _text(path, name)
    first = text[:20000].split("\n")
    for k, line in enumerate(first[:10]):
        if "NPTS" in line.upper() and "DT" in line.upper():
            return _at2(name, text, first[: k + 1], column, step)
    if any(line.lstrip("# ").startswith("SAMPLING_INTERVAL_S:") for line in first):
        return _esm(name, text, first, column, step)
    return _table(name, path, text, column, step)


def _wrapped(name: str, text: str, head: int, count: int, step: float, units: str) -> _Found:
    """Values without times, however many are on a line."""
    body = text.split("\n", head)[head] if text.count("\n") >= head else ""
    values = _floats(name, [line.split() for line in body.split("\n")], head)
    if values.size != count:
        raise ValueError(
            f"{name}: holds {values.size} values, but its header says {count}; is the file cut short, or another's "
            "header on it?"
        )
    _enough(name, values.size)
    return _Found(step * np.arange(float(count)), values, units, head, body)


def _alone(name: str, kind: str, column: int | str | None, step: float | None) -> None:
    for what, given in (("column", column), ("step", step)):
        if given is not None:
            raise ValueError(f"{name}: {what} = {given!r}: {kind} has one column and its own step; leave {what} out")


def _at2(name: str, text: str, head: list[str], column: int | str | None, step: float | None) -> _Found:
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


def _esm(name: str, text: str, first: list[str], column: int | str | None, step: float | None) -> _Found:
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


def _table(name: str, path: Path, text: str, column: int | str | None, step: float | None) -> _Found:
    """Numbers in columns after any header lines."""
    head, separator, width = _first_row(name, text)
    above = text.split("\n", head)[:head]
    body = text.split("\n", head)[head]
    try:
        numbers: Floats = np.loadtxt(
            path, delimiter=separator, skiprows=head, comments=None, ndmin=2, encoding="latin-1"
        )
    except ValueError:  # says neither line nor field as we would, and knows no exponents but E
        numbers = _slow_table(name, body, head, separator, width)
    fields = _fields(above, separator, width)
    if any(map(_is_number, fields)) and width > 1:  # no header, but a sample that is spoilt
        _slow_table(name, above[-1], head - 1, separator, width)
    names = [re.sub(_UNIT_SUFFIX, "", f) for f in fields]
    clock = next((k for k, n in enumerate(names) if re.fullmatch(r"t|time\w*|zeit|temps|tempo", n.lower())), None)
    if step is not None and clock is not None:
        raise ValueError(f"{name}: step = {step!r}: its column {names[clock]!r} holds the times; leave step out")
    if step is None and width == 1:
        raise ValueError(f"{name}: has one column and no times; give step, the time between samples in s")
    if step is None:
        clock = 0 if clock is None else clock
    choice = [k for k in range(width) if k != clock]
    chosen = _column(name, column, names, choice)
    _enough(name, len(numbers))
    match = re.search(_UNIT_SUFFIX, fields[chosen]) if fields else None
    unit = (unit_of(match.group(1) or match.group(2) or "") or "") if match else ""
    if clock is None:
        time = float(step or 0.0) * np.arange(float(len(numbers)))
    else:
        time = numbers[:, clock].copy()
    return _Found(time, numbers[:, chosen].copy(), unit, head, body)


def _first_row(name: str, text: str) -> tuple[int, str | None, int]:
    """Lines above the first that is all numbers, what separates them, and how many there are."""
    for k, line in enumerate(_lines(text)):
        for separator in (";", ",", None):
            if separator is not None and separator not in line:
                continue
            fields = line.split(separator)
            if fields and all(_is_number(f) for f in fields):
                return k, separator, len(fields)
        if ";" in line and all(_is_number(f.replace(",", ".")) for f in line.split(";")):
            raise ValueError(f"{name}, line {k + 1}: {line.strip()[:60]!r}: decimal commas; write points instead")
    raise ValueError(f"{name}: has no line of numbers; a record has a line of time and acceleration for each sample")


def _lines(text: str) -> Iterable[str]:
    at = 0
    while at < len(text):
        end = text.find("\n", at)
        end = len(text) if end < 0 else end
        yield text[at:end]
        at = end + 1


def _is_number(field: str) -> bool:
    try:
        float(re.sub("[dD]", "E", field))
    except ValueError:
        return False
    return True


def _fields(above: list[str], separator: str | None, width: int) -> list[str]:
    """The names in the last line of the header, with their units; none if there are not as many as columns."""
    line = next((x.lstrip("#% \t") for x in reversed(above) if x.strip("#% \t")), "")
    parts = line.split(separator) if separator else re.findall(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?", line)
    return [p.strip().strip('"') for p in parts] if len(parts) == width else []


_UNIT_SUFFIX = r"\s*[(\[]([^)\]]*)[)\]]\s*$|_((?:[cm]?m_s2)|g|gal)$"


def _column(name: str, column: int | str | None, names: list[str], choice: list[int]) -> int:
    shown = ", ".join(f"{k + 1} ({names[k]})" if names else str(k + 1) for k in choice)
    if column is None:
        if len(choice) == 1:
            return choice[0]
        raise ValueError(f"{name}: has several columns of acceleration; give column, one of {shown}")
    found = [k for k in choice if names and names[k].lower() == str(column).strip().lower()]
    if not found and str(column).strip().isdecimal():
        found = [k for k in choice if k == int(column) - 1]
    if len(found) != 1:
        raise ValueError(f"{name}: column = {column!r}: must be one of {shown}")
    return found[0]


def _enough(name: str, count: int) -> None:
    if count < 2:
        raise ValueError(f"{name}: holds {count} sample{'s' * (count != 1)}: a record has two at least")


def _floats(name: str, rows: list[list[str]], head: int) -> Floats:
    """All numbers of the rows; an error that names the line of what is none."""
    try:
        return np.array(list(map(float, chain.from_iterable(rows))), dtype=np.float64)
    except ValueError:
        return np.array([_number(name, k, f) for k, row in enumerate(rows, head + 1) for f in row], dtype=np.float64)


def _slow_table(name: str, body: str, head: int, separator: str | None, width: int) -> Floats:
    """A table line by line, so that the line that is wrong can be named."""
    found = []
    for k, line in enumerate(body.split("\n"), head + 1):
        fields = line.split(separator) if line.strip() else []
        if fields and len(fields) != width:
            raise ValueError(
                f"{name}, line {k}: has {len(fields)} field{'s' * (len(fields) != 1)}, where the first row has "
                f"{width}; mend the line"
            )
        found += [_number(name, k, f) for f in fields]
    return np.array(found, dtype=np.float64).reshape(-1, width)


def _number(name: str, line: int, field: str) -> float:
    try:
        return float(re.sub("[dD]", "E", field))  # Fortran's exponents
    except ValueError:
        raise ValueError(
            f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line"
        ) from None
