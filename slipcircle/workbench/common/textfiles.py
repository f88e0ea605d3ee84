"""Text and tables of numbers in files written by other programs."""

import codecs
import io
import re
from array import array
from collections.abc import Iterable, Sequence
from itertools import repeat
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Floats, Texts

Lines = NDArray[np.int64]  # of numbers in a file, from 1
NUMBER = re.compile(r"[-+]?(?:(?:\d+\.?\d*|\.\d+)(?:[ed][-+]?\d+)?|nan|inf(?:inity)?)", re.ASCII | re.IGNORECASE)
_CELL = re.compile(rf"{NUMBER.pattern}|\d+[-/:]\d+[-/:T\d.Z+ ]*", re.ASCII | re.IGNORECASE)
CLOCK = re.compile(r"\d+[-/:]\d+[-/:T\d.Z+ ]*", re.ASCII)
_COMMAS = re.compile(r"(?=.*\d,\d)[-+\d.,eE]+(?:[;\t ]+[-+\d.,eE]+)*", re.ASCII)
SEPARATORS = (";", "\t", ",", None)
NUMBER_AND_STEP = re.compile(r"\s*(\d{1,15})[\s,;]+0?\.\d+\s*", re.ASCII)  # of samples, above them


def text_of(path: Path, name: str, most_bytes: float, most_numbers: float, kinds: str) -> str:
    """Return the text of a regular file with newlines between its lines, in UTF-8, UTF-16 or Latin-1.

    It must have at most ``most_bytes`` and ``most_numbers``. In messages ``name`` is the file, and ``kinds`` are the
    formats that it may have.

    Raises
    ------
    ValueError
        If it cannot be read, is too large, has too many numbers, or is not text; names the file and the remedy.
    """
    try:
        size = path.stat().st_size
        if not path.is_file():  # such as a folder, a device, or an endless pipe
            raise ValueError(f"{name}: is not a file; give the file of a record")
        if size > most_bytes:
            most = f"must be at most {most_bytes / 1e6:.0f} MB; cut or resample the record"
            raise ValueError(f"{name}: has {size / 1e6:.4g} MB: {most}")
        data = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from error
    is_blank = np.frombuffer(data, np.uint8) <= ord(",")
    count = np.count_nonzero(is_blank[1:] & ~is_blank[:-1])
    if count > most_numbers:
        raise ValueError(f"{name}: has {count:.2g} numbers: must be at most {most_numbers:.2g}; cut or resample it")
    text = decoded(data)
    if "\0" in text[:4096]:
        raise ValueError(f"{name}: is not text; save the record as {kinds}")
    if not text.strip():
        raise ValueError(f"{name}: is empty; a record has two samples at least")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def decoded(data: bytes) -> str:
    """Return the text of bytes in UTF-8, UTF-16 with a byte order mark, or Latin-1."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:  # old headers
        return data.decode("latin-1")


def without_comment(line: str) -> str:
    """Return a line without its comment and outer blanks.

    A comment begins with #, % or ! at the start of the line, or with # or ! after a blank.
    """
    plain = line.strip()
    if plain[:1] in ("#", "%", "!"):
        return ""
    return re.split(r"\s[#!]", plain, maxsplit=1)[0] if "#" in plain or "!" in plain else plain


def split(line: str, separator: str | None) -> Texts:
    """Return the fields of a line without quotes; a separator at the end of the line adds no field.

    The separator None stands for blanks.
    """
    fields = [field.strip().strip('"') for field in line.split(separator)]
    return fields[:-1] if len(fields) > 1 and not fields[-1] and fields[-2] else fields


def first_row(name: str, text: str, quantity: str) -> tuple[int, str | None, int]:
    """Return the index, separator and number of columns of the first line of numbers in a text.

    The index is the number of lines above; the separator None stands for blanks. In messages ``name`` is the file and
    ``quantity`` what it records.

    A row of numbers followed by two rows of another length, such as a date, belongs to the header, and so does the
    number of samples with their step.
    """
    rows = []
    for k, line in enumerate(map(without_comment, io.StringIO(text))):
        row = _row(k, line)
        if (not row and _COMMAS.fullmatch(line)) or re.fullmatch(r"[-+]?\d+,0\d+", line):
            raise ValueError(f"{name}, line {k + 1}: {line[:60]!r}: decimal commas; write points instead")
        rows += row
        if rows and line and (not row or len(rows) == 3):
            break
    if not rows:
        raise ValueError(f"{name}: has no line of numbers; a record has a line of time and {quantity} for each sample")
    widths = [row[2] for row in rows]
    is_alone = widths[1:] == [rows[-1][2]] * 2 and widths[0] != widths[1]
    return rows[1] if is_alone or (len(rows) == 3 and _is_count(text, rows[0][0])) else rows[0]


def _is_count(text: str, line: int) -> bool:
    """Return whether the line with an index states the number of the lines or numbers below it, and their time step."""
    *_, first, below = text.split("\n", line + 1)
    stated = NUMBER_AND_STEP.fullmatch(first)
    return stated is not None and int(stated[1]) in (
        sum(map(bool, below.split("\n"))),
        len(re.findall(r"[^\s,;]+", below)),
    )


def _row(k: int, line: str) -> list[tuple[int, str | None, int]]:
    """Return the index, separator and number of columns of a line of numbers, in a list; empty for another line.

    Some of the numbers may be times of day. The result is a list of at most one tuple, which begins with ``k``.
    """
    for separator in SEPARATORS:
        fields = split(line, separator)
        filled = list(filter(None, fields))
        numbers = [field for field in filled if NUMBER.fullmatch(field)]
        if separator in (None, *line) and numbers and all(map(_CELL.fullmatch, filled)):
            return [(k, separator, len(fields))]
    return []


def fields_below(
    name: str, below: Iterable[str], above: int, separator: str | None, width: int = 1
) -> tuple[Texts, Lines]:
    """Return the fields of all lines below a header in one list, and the line number of each field.

    ``below`` are these lines, ``above`` is the number of lines above them; None separates by blanks. ValueError if a
    line of a table of ``width`` > 1 has another number of fields.
    """
    fields, lines = list[str](), array("q")
    for k, line in enumerate(map(without_comment, below), above + 1):
        if not line:
            continue
        row = split(line, separator)
        row += [""] * (len(row) == width - 1 and line[-1] == separator)
        if width > 1 and len(row) != width:
            raise ValueError(
                f"{name}, line {k}: has {len(row)} field{'s' * (len(row) != 1)}, where the first row has "
                f"{width}; mend the line"
            )
        fields += row
        lines.extend([k] * len(row))
    return fields, np.array(lines)


def parsed_numbers(name: str, fields: Sequence[str], lines: Lines) -> Floats:
    """Return the fields of a file as numbers; an invalid field raises ValueError with the file's name and its line."""
    joined = "".join(fields)
    try:
        if "_" in joined or not joined.isascii():  # numbers in Python's spelling
            raise ValueError
        return np.array(array("d", map(float, fields)))
    except ValueError:  # Fortran's exponents, or an invalid number
        return np.array(array("d", map(_number, repeat(name), lines, fields)))


def _number(name: str, line: int, field: str) -> float:
    """Return a field as a number, also with a Fortran exponent such as 1.5D3; ValueError names file and line."""
    if not NUMBER.fullmatch(field):
        raise ValueError(f"{name}, line {line}: {field.strip()[:40]!r}: must be a number; mend or remove the line")
    return float(field.replace("d", "E").replace("D", "E"))


def plain_numbers(cells: Texts) -> Floats:
    """Return the cells of a column as numbers; an empty array if a cell is not a plain number."""
    try:
        return np.array(cells, float)
    except ValueError:
        return np.empty(0)


def is_even(numbers: Floats, longest: float) -> bool:
    """Return whether numbers increase by equal steps, up to rounding, and these are shorter than ``longest``."""
    if numbers.size < 2 or not np.all(np.abs(numbers) < 1e300):
        return False
    even, step = np.linspace(numbers[0], numbers[-1], numbers.size, retstep=True)
    is_even = np.all(np.diff(numbers) > 0.0) and np.all(np.abs(numbers - even) < 0.25 * step)
    return bool(is_even and step < longest)


def check_count(name: str, count: int, stated: float) -> None:
    """Raise an error if the number of values in a file, ``count``, is not the one ``stated`` in its header."""
    if count != stated:
        raise ValueError(
            f"{name}: holds {count} values, but its header says {stated:.0f}; is the file cut short, or another's "
            "header on it?"
        )
