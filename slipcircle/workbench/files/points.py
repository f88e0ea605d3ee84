"""Points of a profile read from spreadsheets (CSV) and drawings (DXF) that a scene file refers to."""

import re
from collections.abc import Iterable, Iterator, Sequence
from csv import reader
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np

from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import Pair, Texts, ValueDict, Values
from slipcircle.base.optional import optional
from slipcircle.ground import points_errors
from slipcircle.workbench.common.textfiles import decoded
from slipcircle.workbench.common.units import LENGTH, unit_of

_PLACES = {"ground": "points", "water": "level", "layers": "top"}
_COLUMNS = {  # in English, German, French, Italian and Spanish
    "x": "x|station|chainage|distance|offset|sta|abstand|abscisse|distanza|progressiva|distancia",
    "y": "y|z|elevation|level|height|elev|altitude|höhe|hoehe|quota|cota|altitud",
}
_MOST_BYTES = 10**7
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)(e[-+]?\d+)?", re.IGNORECASE)
_STATION = re.compile(r"(\d+)\+(\d{2,3})([.,]\d+)?")  # 1+25 is 125 ft, 1+250 is 1250 m
_TYPES = {"LINE", "LWPOLYLINE", "POLYLINE", "SPLINE", "ARC", "ELLIPSE"}
_DRAWING_UNITS = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m", 21: "us_ft"}  # $INSUNITS
_TOGETHER = 1e-6  # relative to the size of a drawing: ends of lines at most this far apart are joined
_CURVED = 1e-5  # relative to the size of a curve, its distance from the edges that replace it
_PARTS = 8  # of a quarter of a circle, each a cubic curve
Points = list[Pair]


def with_points(content: Values, folder: Path) -> ValueDict:
    """Return the content of a scene file with references to point files replaced by the points.

    Raises
    ------
    ValueError
        Lists a message for each file that cannot be read.
    """
    tables = dict(content)
    mistakes: Texts = []
    for name, key in _PLACES.items():
        table = content.get(name)
        if isinstance(table, dict):
            tables[name] = _with_points(table, name, key, folder, mistakes)
        elif isinstance(table, list) and all(isinstance(one, dict) for one in table):
            tables[name] = [_with_points(one, f"{name}.{k}", key, folder, mistakes) for k, one in enumerate(table, 1)]
    raise_all("", mistakes)
    return tables


def _with_points(table: Values, path: str, key: str, folder: Path, mistakes: Texts) -> ValueDict:
    """Return a table with its reference to a file replaced by points; append mistakes to the list.

    `path` is the path of the table for messages, and `key` the key of its points without unit, such as "level".
    """
    content = dict(table)
    file = content.pop(f"{key}_file", None)
    if file is None:
        return content
    stated = content.pop(f"{key}_file_unit", "")
    try:
        if not isinstance(file, str):
            raise ValueError("must be the name of a CSV or DXF file")
        unit = unit_of(stated, LENGTH) if isinstance(stated, str) else None
        if stated and unit is None:
            raise ValueError(f"{key}_file_unit = {stated!r} must be one of {LENGTH.choice}")
        points, unit = read_points(folder, file, unit or "", f"{key}_file_unit")
        spelling = f"{key}_{unit}"
        other = next((k for k in content if k.startswith(f"{key}_")), "")
        if other:
            raise ValueError(f"and {other} are one quantity; remove one")
        content[spelling] = [list(point) for point in points]
    except (ValueError, ImportError) as error:
        mistakes.append(f"{path}.{key}_file = {str(file)!r}: {error}")
    return content


def read_points(folder: Path, file: str, unit: str, key: str) -> tuple[Points, str]:
    """Return the points of a file from left to right and their unit, stated by the file or by `unit`.

    `file` is the name of the file in the folder, with the layer of a drawing after #. `key` is the name of the key that
    states the unit, for messages.

    Raises
    ------
    ValueError
        If the file cannot be read, its unit is not known, or its points do not lead from left to right.
    """
    name, _, layer = file.partition("#")
    path = folder / name
    if not path.is_file():
        raise ValueError("there is no such file; give a path relative to the scene file")
    if path.stat().st_size > _MOST_BYTES:
        raise ValueError(f"must be at most {_MOST_BYTES / 1e6:g} MB")
    if path.suffix.lower() == ".dxf":
        points, of_file = _drawing(path, layer)
        of_file = unit or of_file
    else:
        points, of_file = _sheet(decoded(path.read_bytes()))
        if unit and of_file and unit != of_file:
            raise ValueError(f"its header says {of_file}, and {key} is {unit}; remove one")
        of_file = unit or of_file
    if not of_file:
        raise ValueError(f'states no unit; add {key} = "m", or another of {LENGTH.choice}')
    points = [point for k, point in enumerate(points) if not k or point != points[k - 1]]
    if len(points) > 1 and points[0][0] > points[-1][0]:
        raise ValueError("its points lead from right to left; sort its rows by x")
    raise_all("", points_errors("points", points, many=False))
    return points, of_file


# --- spreadsheets ----------------------------------------------------------------------------------------------------


def _sheet(text: str) -> tuple[Points, str]:
    """Return the points of a spreadsheet and the unit that its header states, "" without one.

    `text` is the content of the file.
    """
    rows, separator = _rows(text)
    either = "|".join(_COLUMNS.values())
    named = (k for k, (_, row) in enumerate(rows) if any(_column(cell, either) for cell in row))
    head = next(named, 0 if rows and not any(_NUMBER.match(cell) for cell in rows[0][1]) else -1)
    columns = (0, 1)
    unit = ""
    if head >= 0:
        columns, unit = _columns(rows[head][1])
        below = [row for _, row in rows[head + 1 : head + 2]]
        of_row = {unit_of(cell.strip("()[]"), LENGTH) for row in below for cell in row if cell}
        if not unit and len(of_row) == 1 and (stated := of_row.pop()):
            unit = stated
            head += 1
    else:
        width = max((k for _, row in rows for k, cell in enumerate(row, 1) if cell), default=0)
        if width != 2:
            raise ValueError(f"has {width} columns and no header; name the columns x and y, or leave two")
    numbers = [cell for _, row in rows for cell in row if _NUMBER.fullmatch(cell)]
    decimal = "," if separator != "," and any("," in cell for cell in numbers) else "."
    return [_point(line, row, columns, decimal) for line, row in rows[head + 1 :]], unit


def _rows(text: str) -> tuple[list[tuple[int, Texts]], str]:
    """Return the filled rows of a spreadsheet as cells, with the numbers of their lines, and the separator."""
    last = "".join([line for line in text.splitlines() if line.strip()][-1:])
    separator = next((mark for mark in ";\t," if mark in last), " ")
    if separator == " ":  # columns of any number of blanks
        text = "\n".join(" ".join(line.split()) for line in text.splitlines())
    sheet = reader(StringIO(text.replace("\N{MINUS SIGN}", "-"), newline=""), delimiter=separator)
    lines = [(sheet.line_num, [cell.strip() for cell in row]) for row in sheet]
    return [(k, row) for k, row in lines if any(row) and not row[0].startswith("#")], separator


def _point(line: int, row: Sequence[str], columns: tuple[int, int], decimal: str) -> Pair:
    """Return the x and y of a row of a spreadsheet.

    `line` is its line number for messages. `columns` are the indices of x and y, and `decimal` is the decimal mark, "."
    or ",".
    """
    cells = [row[k] if k < len(row) else "" for k in columns]
    station = _STATION.fullmatch(cells[0])
    if station:
        cells[0] = "".join(part or "" for part in station.groups())
    for cell in cells:
        marks = set(cell) & {".", ","}
        if not _NUMBER.fullmatch(cell) or not marks <= {decimal}:
            words = f"must be a number with decimal {'commas' if decimal == ',' else 'points'}"
            raise ValueError(f"line {line}, {cell!r}: {words} and no thousands separators")
    x, y = (float(cell.replace(",", ".")) for cell in cells)
    return x, y


def _column(cell: str, names: str) -> Texts:
    """Return a list of the unit in the name of a column, "" without a unit; an empty list for other columns.

    `names` is a regular expression for the name without the unit.
    """
    parts = re.fullmatch(rf"({names})(?:[\s_,]*[(\[{{]?([^()\[\]{{}}]+)[)\]}}]?)?", cell, re.IGNORECASE)
    unit = unit_of(parts[2], LENGTH) if parts and parts[2] else ""
    return [unit] if parts and unit is not None else []


def _columns(head: Sequence[str]) -> tuple[tuple[int, int], str]:
    """Return the indices of the columns of x and y in a header, and their common unit."""
    chosen = []
    units = set()
    for axis, names in _COLUMNS.items():
        fits = [(k, unit) for k, cell in enumerate(head) for unit in _column(cell, names)]
        if len(fits) != 1:
            columns = ", ".join(head[k] for k, _ in fits) or "none"
            allowed = names.replace("|", ", ")
            raise ValueError(f"needs one column for {axis} ({allowed}), and has {columns} of {', '.join(head)}")
        chosen.append(fits[0][0])
        units.add(fits[0][1])
    if len(units) > 1:
        raise ValueError(f"has mixed units in its header, {', '.join(head)}; give both columns the same")
    x, y = chosen
    return (x, y), units.pop()


# --- drawings --------------------------------------------------------------------------------------------------------


def _drawing(file: Path, layer: str) -> tuple[Points, str]:
    """Return the points of the connected lines on a layer of a drawing, from left to right, and the drawing's unit.

    Without the name of a layer, all lines must be on one layer. The unit is empty if it is not stated.
    """
    ezdxf = optional("ezdxf", "profiles from drawings")
    make_path = optional("ezdxf.path", "profiles from drawings").make_path
    recursive_decompose = optional("ezdxf.disassemble", "profiles from drawings").recursive_decompose
    try:
        drawing = ezdxf.readfile(file)
    except (OSError, ezdxf.DXFError, ValueError) as error:
        raise ValueError(f"is not a drawing in DXF: {error}") from error
    lines: dict[str, list[Points]] = {}
    for entity in recursive_decompose(drawing.modelspace()):
        if entity.dxftype() not in _TYPES:
            continue
        lines.setdefault(entity.dxf.layer, []).append(_vertices(make_path(entity, segments=_PARTS)))
    chosen = [name for name in lines if name.lower() == layer.lower()] if layer else [*lines]
    if len(chosen) != 1:
        fault = f"has no lines on layer {layer}" if layer else "needs the name of a layer"
        names = ", ".join(lines) or "none"
        raise ValueError(f"{fault}; give one after #, layers with lines are {names}")
    joined = _joined(lines[chosen[0]])
    unit = _DRAWING_UNITS.get(drawing.header.get("$INSUNITS", 0), "")
    return joined if joined[0][0] <= joined[-1][0] else joined[::-1], unit


def _vertices(path: Any) -> Points:
    """Return the points of a path of ``ezdxf``, with edges in the place of curves; an upright section has y = z."""
    corners = np.array([corner.xyz for corner in path.control_vertices()])
    near = _CURVED * float(np.ptp(corners, axis=0).max())
    x, y, z = np.array([vertex.xyz for vertex in path.flattening(near)]).T
    is_upright = np.ptp(y) == 0.0 and np.ptp(z) > 0.0
    return list(zip(x.tolist(), (z if is_upright else y).tolist(), strict=True))


def _joined(lines: Iterable[Points]) -> Points:
    """Return one line that joins lines with common ends, which may be in any order and direction.

    Raises
    ------
    ValueError
        If a line is not connected to the others.
    """
    first, *rest = lines
    near = _TOGETHER * float(np.ptp(np.concatenate([first, *rest]), axis=0).max())
    while rest:
        connection = next(_connected(first, rest, near), None)
        if connection is None:
            x, y = first[-1]
            words = f"has a gap between its lines, of which one ends at ({x:g}, {y:g})"
            raise ValueError(f"{words}; join them, or put others on another layer")
        k, first = connection
        del rest[k]
    return first


def _connected(line: Points, others: Sequence[Points], near: float) -> Iterator[tuple[int, Points]]:
    """Yield the index of each line that shares an end with a line, and the two joined into one.

    Ends at most `near` apart are joined, in the unit of the drawing.
    """
    for k, other in enumerate(others):
        for one in (line, line[::-1]):
            for second in (other, other[::-1]):
                if np.abs(np.subtract(one[-1], second[0])).max() <= near:
                    yield k, [*one, *second[1:]]
