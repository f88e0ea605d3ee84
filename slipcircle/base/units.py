"""Recognition of quantities with units, such as quantities of pint, in the fields of a scene and its parts."""

from collections.abc import Iterable
from importlib import import_module
from typing import Any

import numpy as np

from slipcircle.base.kinds import MAPPING

_PLAIN = frozenset((bool, int, float, str, np.float64))


def take_units(owner: Any, fields: Iterable[str]) -> None:
    """Replace quantities in the named fields of a frozen dataclass ``owner`` by numbers in SI units.

    Raises
    ------
    ValueError
        If the dimension of a quantity differs from its field's; names the field and its unit.
    """
    for name in fields:
        value = getattr(owner, name)
        if _has_units(value):
            number = import_module("slipcircle.base.magnitudes").in_si(name, value)
            object.__setattr__(owner, name, number)


def _has_units(value: Any) -> bool:
    """Return whether a value, or a value within a list or a mapping, is a quantity with a unit."""
    kind = type(value)
    if kind in _PLAIN:
        return False
    if isinstance(value, MAPPING):
        return any(map(_has_units, value.values()))
    if kind is list or kind is tuple:
        others = set(map(type, value)) - _PLAIN
        return bool(others) and any(map(_has_units, value))
    return hasattr(kind, "dimensionality")
