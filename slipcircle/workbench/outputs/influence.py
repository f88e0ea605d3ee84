"""Table of `slipcircle sensitivity`: the most important numbers of a scene, and their values for F = 1."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import NumberDict, NumberMap
from slipcircle.base.text import number_text, output_unit
from slipcircle.derivatives import Sensitivity
from slipcircle.workbench.common.quantities import spelt_out
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import by_name
from slipcircle.workbench.outputs.pictures.tornado import size_of
from slipcircle.workbench.outputs.tables import ResultTable
from slipcircle.workbench.studies.standstill import standstills

_MOST = 10  # rows
_TERMS = {
    "kink": "kink: the slopes to both sides differ, and their mean is given",
    "jump": "jump: a change to one side changes the outcome at once, and the slope is taken on the other side",
    "one side": "one side: values on the other side are not a valid scene",
    "unresolved": "unresolved: the derivative is unknown",
}


def important(table: Sensitivity) -> NumberDict:
    """Return the sizes of the numbers with the greatest effect on the run-out, in SI units by name, largest first.

    The effect of a number is the derivative of the run-out times the size of the number. The size of a place is the
    depth of the mass, of an end of the arc half the opening angle, and otherwise the value itself. Among all
    coordinates of the geometry, only the most important is listed.
    """
    sizes = {name: size_of(table, name) for name in table.parameters}
    effects = {name: abs(np.nan_to_num(table.derivative("run_out", name))) * size for name, size in sizes.items()}
    ranked = sorted(effects, key=lambda name: -effects[name])
    points = [name for name in ranked if _is_point(name)]
    rows = [name for name in ranked if name not in points[1:]]
    return {name: sizes[name] for name in rows[:_MOST]}


def _is_point(name: str) -> bool:
    """Return whether a number is a coordinate of the geometry."""
    return name.startswith(("ground.", "level.", "centre."))


def important_standstills(table: Sensitivity) -> NumberDict:
    """Return the values of the `important` numbers in SI units at which F = 1, by name; absent without such a value."""
    return standstills(table.scene, important(table).items())


def sensitivity_part(table: Sensitivity, stops: NumberMap) -> ResultTable:
    """Return a table of derivatives of the outputs per unit of the key of each of the `important` numbers.

    ``stops`` are the `important_standstills`, which are listed with their distance.
    """
    names = important(table)
    outcomes = (output_unit(unit)[0] * table.at[output] for output, unit in table.outputs.items())
    rows: list[list[Any]] = [["", "", "", "", *outcomes]]
    keys = by_name(table.scene)
    for parameter in names:
        key = keys[parameter]
        value = float(key.from_si(table.at[parameter]))
        limit = ["-", "-"]
        if parameter in stops:
            stop = float(key.from_si(stops[parameter]))
            limit = [number_text(stop, 4), f"{stop - value:+.2g}"]
        cells = [_cell(table, output, parameter, key) for output in table.outputs]
        rows.append([_label(table, key), number_text(value, 6), *limit, *cells])
    head = ["by", "value", "F = 1 at", "distance"]
    head += [spelt_out(output, output_unit(unit)[1]) for output, unit in table.outputs.items()]
    return ResultTable(head, rows, table.scene.name, _note(table, names))


def _label(table: Sensitivity, key: Key) -> str:
    """Return the key of a number as text; for a coordinate, also the number of coordinates in the table."""
    count = sum(map(_is_point, table.parameters))
    if count > 1 and _is_point(key.name):
        return f"{key.key}, of {count} coordinates"
    return key.key


def _cell(table: Sensitivity, output: str, parameter: str, key: Key) -> str:
    """Return a derivative of an output by a parameter as text: per unit of the key, and in brackets relative.

    Its kind follows unless the dependence is smooth.
    """
    at = table.at[output]
    value = float(key.from_si(table.at[parameter]))
    per_si = table.derivative(output, parameter)
    is_noise = abs(per_si) <= table.error(output, parameter)
    if is_noise:
        per_unit = 0.0
    else:
        per_unit = float(per_si * key.slope(value))
    text = number_text(output_unit(table.outputs[output])[0] * per_unit)
    if at and per_unit * value and per_unit == per_unit:
        text += f" ({per_unit * value / at:+.2g})"
    kind = table.kind(output, parameter)
    if kind == "smooth":
        return text
    return f"{text} {kind}"


def _note(table: Sensitivity, names: NumberMap) -> str:
    """Return the explanation of the columns and terms of a table, and how many numbers it omits; it lists ``names``."""
    notes = ["change per unit of the key, and in brackets in per cent per per cent of it"]
    notes.append("F = 1 at: the nearest value at which the mass begins or ceases to slide on this circle")
    kinds = {table.kind(output, parameter) for output in table.outputs for parameter in names}
    notes += [text for kind, text in _TERMS.items() if kind in kinds]
    every = len(table.parameters)
    if every > len(names):
        notes.append(f"{len(names)} most important of {every} numbers; --json has all")
    return ". ".join(notes)
