"""The fields of an arc or a section once some of its numbers have other values."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Values
from slipcircle.core.scene.coordinates import Indices, indices_of


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
