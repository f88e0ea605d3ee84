"""The numbers of an arc or a section by name: its fields, and the coordinates of its points, ``ground.3.y``.

A section's ground, water level and centre are arrays of points. Each coordinate is a number of its own, named after
the field, the point from 0, and x or y; a centre is one point: ``centre.x``.
"""

from dataclasses import fields
from functools import lru_cache
from typing import Any

import numpy as np

from slipcircle.base.kinds import Values

Index = tuple[int, ...]
Indices = dict[str, Index]  # of numbers by name, in an array of points


@lru_cache(maxsize=256)
def _names(field: str, shape: Index) -> Indices:
    """Name of every number in a field of this shape, with its index there."""
    if not shape:
        return {field: ()}
    names = {}
    for index in np.ndindex(shape):
        *point, axis = index
        coordinate = "xy"[axis]
        parts = [field, *map(str, point), coordinate]
        name = ".".join(parts)
        names[name] = index
    return names


def leading_shape(value: Any, axes: int) -> Index:
    """The shape of an array of lanes, without the last axes, which one section has."""
    shape = np.shape(value)
    return shape[: len(shape) - axes]


def indices_of(arc: Any, field: str) -> Indices:
    """The numbers of one field of an arc or a section: each by its name, with its index in the axes of one section."""
    value = getattr(arc, field)
    if value is None:
        return {}
    shape = np.shape(value)
    lanes = leading_shape(value, arc.quantities[field])
    return _names(field, shape[len(lanes) :])


def coordinates(arc: Any) -> dict[str, Any]:
    """All numbers of the fields of a section by name: each one number, or an array of one a lane."""
    numbers: dict[str, Any] = {}
    for field, axes in arc.quantities.items():
        value = getattr(arc, field)
        if not axes and value is not None:
            numbers[field] = value
            continue
        lanes: Any = np.asarray(value)
        for name, index in indices_of(arc, field).items():
            numbers[name] = lanes[(..., *index)]
    return numbers


def changed_fields(arc: Any, values: Values) -> dict[str, Any]:
    """The fields of an arc or a section that differ once some of its numbers have other values."""
    changed: dict[str, Any] = {}
    for field, axes in arc.quantities.items():
        indices = indices_of(arc, field)
        names = [name for name in indices if name in values]
        replaced = {name: indices[name] for name in names}
        if not replaced:
            continue
        if not axes:
            changed[field] = values[field]
            continue
        value = getattr(arc, field)
        points = np.asarray(value, dtype=np.float64)
        changed[field] = _with_coordinates(points, axes, replaced, values)
    known = arc.other_numbers()
    others = {name: values[name] for name in values if name in known}
    return changed | arc.fields_with(others)


def _with_coordinates(points: Any, axes: int, replaced: Indices, values: Values) -> Any:
    """An array of points in which the coordinates at some indices are replaced by numbers, or by one a lane."""
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
    """A frozen dataclass with other field values that its constructor does not see: they were checked, or will be."""
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
