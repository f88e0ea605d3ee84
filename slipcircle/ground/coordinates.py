"""Access to the numbers of an arc or a section by name, including coordinates of points such as ``ground.3.y``.

A section's ground, water level and centre are arrays of points. Each coordinate is a separate number, named by the
field, the index of the point from 0, and x or y. A centre is a single point: ``centre.x``.
"""

from dataclasses import fields
from functools import lru_cache
from typing import Any

import numpy as np

from slipcircle.base.kinds import Shape, ValueDict, Values

Indices = dict[str, Shape]  # index of each number in an array of points, by name


@lru_cache(maxsize=256)
def _names(field: str, shape: Shape) -> Indices:
    """Return the name of every number in a field of this shape, with its index."""
    if not shape:
        return {field: ()}
    names = {}
    for *point, axis in np.ndindex(shape):
        name = ".".join([field, *map(str, point), "xy"[axis]])
        names[name] = (*point, axis)
    return names


def leading_shape(value: Any, axes: int) -> Shape:
    """Return the shape of an array of lanes without the last axes, which belong to one section."""
    shape = np.shape(value)
    return shape[: len(shape) - axes]


def indices_of(arc: Any, field: str) -> Indices:
    """Return the numbers of a field of an arc or a section, by name, with their index in the axes of one section."""
    value = getattr(arc, field)
    if value is None:
        return {}
    shape = np.shape(value)
    lanes = leading_shape(value, arc.quantities[field])
    return _names(field, shape[len(lanes) :])


def coordinates(arc: Any) -> ValueDict:
    """Return all numbers in the fields of a section by name, each a number or an array over lanes."""
    numbers: ValueDict = {}
    for field, axes in arc.quantities.items():
        value = getattr(arc, field)
        if not axes and value is not None:
            numbers[field] = value
            continue
        lanes: Any = np.asarray(value)
        for name, index in indices_of(arc, field).items():
            numbers[name] = lanes[(..., *index)]
    return numbers


def changed_fields(arc: Any, values: Values) -> ValueDict:
    """Return the fields of an arc or a section that change if some of its numbers have other values."""
    changed: ValueDict = {}
    for field, axes in arc.quantities.items():
        replaced = {name: index for name, index in indices_of(arc, field).items() if name in values}
        if not replaced:
            continue
        if not axes:
            changed[field] = values[field]
            continue
        points = np.asarray(getattr(arc, field), float)
        changed[field] = _with_coordinates(points, axes, replaced, values)
    known = arc.other_numbers()
    others = {name: values[name] for name in values if name in known}
    return changed | arc.fields_with(others)


def _with_coordinates(points: Any, axes: int, replaced: Indices, values: Values) -> Any:
    """Return an array of points in which coordinates are replaced by numbers or by arrays over lanes."""
    shape = points.shape[-axes:]  # of one section
    some_stay = len(replaced) < np.prod(shape)
    lanes_of_the_rest = points.shape[:-axes] if some_stay else ()
    numbers = [values[name] for name in replaced]
    lanes_of_numbers = map(np.shape, numbers)
    lanes = np.broadcast_shapes(lanes_of_the_rest, *lanes_of_numbers)
    kind = np.result_type(points, *numbers)
    new_shape = (*lanes, *shape)
    changed: Any = np.empty(new_shape, dtype=kind)
    if some_stay:
        changed[...] = points
    for index, number in zip(replaced.values(), numbers, strict=True):
        changed[(..., *index)] = number
    return changed


def replace_unchecked(instance: Any, values: Values) -> Any:
    """Return a frozen dataclass with other field values, without the checks of its constructor."""
    if all(values[name] is getattr(instance, name) for name in values):
        return instance
    other = object.__new__(type(instance))
    for field in fields(instance):
        known = getattr(instance, field.name)
        value = values.get(field.name, known)
        object.__setattr__(other, field.name, value)
    if hasattr(other, "takes_geometry") and other.takes_geometry(instance):
        other.take_geometry(instance)
    return other
