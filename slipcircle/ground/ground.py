"""Input of grounds and circles, and their errors."""

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from generated.effects import Parameter
from slipcircle.base.arrays import array_of, quiet
from slipcircle.base.errors import Fault, complaint, mistakes, shape_mistakes
from slipcircle.base.kinds import Floats, Shape, Texts, Values

FAR = 1e9  # bound of coordinates, m
AS_PRINTED = 1e-3  # tolerance relative to the radius or the width of a mass, for circles rounded to printed digits


WEIGHT = (0.0, 1e6, "a positive unit weight in N/m^3")


def present(node: Any, numbers: Mapping[str, Parameter]) -> dict[str, Parameter]:
    """Return the declarations of the numbers of a dataclass that have a value and allowed values in words, by field.

    ``numbers`` are the declarations by field. A field is absent if it is None and may be.
    """
    declarations = {}
    for field in fields(node):
        name = field.name
        is_absent = field.default is None and getattr(node, name) is None
        if name in numbers and numbers[name].allowed and not is_absent:
            declarations[name] = numbers[name]
    return declarations


def leading_shape(value: Any, axes: int) -> Shape:
    """Return the shape of an array of lanes without the last ``axes`` axes, which belong to one section."""
    shape = np.shape(value)
    return shape[: len(shape) - axes]


def line_errors(name: str, lines: Floats) -> Iterator[Fault]:
    """Yield the errors of lines (n, V, 2) that do not run from left to right.

    ``name`` names them in messages. An error is a mask of lines and a function from the index of a line to its message.
    """
    with quiet():
        before_first = lines[:, :1] - 1.0
        step = np.diff(lines, axis=1, prepend=before_first)

    def at(bad: Any, words: str) -> Fault:
        places = np.argmax(bad, axis=1)

        def sentence(k: int) -> str:
            place = places[k]
            point = lines[k, place].tolist()
            return f"{{{name}}}[{place}] = {point}: {words}"

        return bad.any(axis=1), sentence

    is_near = np.abs(lines) < FAR
    yield at(~is_near.all(axis=2), "must be two finite numbers within 1e9 m")
    yield at(~step.any(axis=2), "is equal to the point before it; remove one")
    yield at(step[..., 0] < 0.0, "lies left of the point before it; order them by x")
    x = lines[..., 0]
    first_x = x[:, 0]
    is_upright = x[:, -1] == first_x
    yield is_upright, lambda _: f"{{{name}}}: all points have the same x; it must extend from left to right"


def points_errors(name: str, value: Any, many: bool) -> Texts:
    """Return messages about points that should form a line from left to right, or about the first invalid line.

    ``name`` is the field with this value, and ``many`` allows further axes before (V, 2).
    """
    points = array_of(value)
    most_axes = 2
    if many:
        most_axes = 15
    shape = points.shape
    are_numbers = points.dtype.kind in "iuf"
    has_axes = 2 <= points.ndim <= most_axes
    are_points = has_axes and shape[-1] == 2
    if not are_numbers or not are_points or shape[-2] < 2:
        return [f"{{{name}}}: must be a list of at least two points [x, y] in m, from left to right"]
    *lanes, count, _ = shape
    one_axis = points.reshape(-1, count, 2)
    lines = one_axis.astype(float)
    faults = line_errors(name, lines)
    return complaint(faults, tuple(lanes))


def continued(lines: Floats, left: Any, right: Any) -> Floats:
    """Return lines (n, V, 2) extended by horizontal edges at least to given x at both ends, (n, V + 2, 2)."""
    first = lines[:, :1]
    last = lines[:, -1:]
    longer = np.concatenate([first, lines, last], axis=1)
    x = longer[..., 0].T
    x[0] = np.minimum(left, x[0] - 1.0)
    x[-1] = np.maximum(right, x[-1] + 1.0)
    return longer


def slope_errors(fields: Values, declared: Mapping[str, Parameter]) -> Texts:
    """Return messages about the fields of one slope, from values and declarations by field."""
    return mistakes(fields, declared) + _lines_errors(fields, many=False)


def section_errors(section: Any) -> Texts:
    """Return messages about the fields of a section, which may have axes of lanes before those of one section."""
    fields = vars(section)
    errors = mistakes(fields, present(section, section.quantities))
    if not errors:  # all of them are numbers
        errors = _pair_errors(fields, section.quantities)
    errors += _lines_errors(fields, many=True)
    if errors:
        return errors
    of_lanes = {}
    for name, p in section.quantities.items():
        value = fields[name]
        if p.kind == "number" and value is not None:
            shape = leading_shape(value, p.axes)
            of_lanes[name] = np.empty(shape)
            if 0 in shape:
                errors.append(f"{{{name}}}: is empty")
    return shape_mistakes(of_lanes) or errors


def _pair_errors(fields: Values, declared: Mapping[str, Parameter]) -> Texts:
    """Return messages about the centre, a pair of numbers, and the range of x, an increasing pair.

    Values and declarations are by field.
    """
    wrong = []
    *_, coordinates = np.atleast_1d(fields["centre"]).shape
    if coordinates != 2:
        wrong.append("centre")
    pair = fields["between"]
    if pair is not None:
        are_two = np.shape(pair) == (2,)
        if not are_two or pair[0] >= pair[1]:
            wrong.append("between")
    messages = []
    for name in wrong:
        messages.append(f"{{{name}}} = {fields[name]!r}: must be {declared[name].allowed}")
    return messages


def _lines_errors(fields: Values, many: bool) -> Texts:
    """Return messages about the ground, the water level and ponds, from values by field.

    ``many`` allows axes of lanes before the points of a line.
    """
    errors = points_errors("ground", fields["ground"], many)
    if fields["level"] is not None:
        errors += points_errors("level", fields["level"], many)
    confined = fields["confined"]
    if not isinstance(confined, bool):
        errors.append(f"{{confined}} = {confined!r}: must be True or False")
    elif confined and fields["level"] is None:
        errors.append("{confined}: has no {level}; give the level, or leave {confined} out")
    for k, pond in enumerate(fields["ponds"], 1):
        errors += _pond_errors(k, pond)
    return errors


def _pond_errors(k: int, pond: Any) -> Texts:
    """Return a message if pond number ``k``, counted from 1, does not consist of three numbers."""
    numbers = np.asarray(pond)
    if numbers.shape == (3,) and numbers.dtype.kind in "iuf" and np.all(np.abs(numbers) < FAR):
        first, last, _ = numbers
        if first < last:
            return []
    return [f"{{pond.{k}}} = {pond!r}: must be x of its left and of its right end, and its level, in m"]
