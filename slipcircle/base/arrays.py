"""Conversions of inputs to numbers, arrays and read-only mappings, and arithmetic that needs care."""

import math
from collections.abc import Callable, Iterable, Mapping
from operator import is_
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import Shape

EPS = 2.0**-52  # distance of 1.0 from the next float
INFINITY = float("inf")
FLOATS = frozenset((float, np.float64))

# Freeing a large array raises the sizes at which glibc maps memory for an array, and at which it returns free memory.
# Otherwise the pages of arrays of an ensemble would be mapped and cleared in each operation, a quarter of the time.
np.empty(1 << 21)


def float_or_array(value: Any) -> Any:
    """Return numbers in the cheapest form for computation, a float or a float64 array."""
    if type(value) is float:
        return value
    if np.ndim(value):
        return np.asarray(value, np.float64)
    return float(value)


def may_overflow(shape: Shape, function: Callable[[], Any]) -> Any:
    """Return the result of a function of lanes, without overflow warnings of arrays.

    The overflow itself is reported when the result is read.
    """
    if not shape:
        return function()
    with np.errstate(over="ignore"):
        return function()


def quiet() -> Any:
    """Return a context without NumPy's warnings, for arrays in which some lanes have no result."""
    return np.errstate(all="ignore")


_NUMBERS = frozenset((bool, int, float, np.float64))


def loses_something(value: Any) -> bool:
    """Return whether `numpy.asarray` would drop a mask or a unit of a value, or of one within a list."""
    kind = type(value)
    if isinstance(value, list | tuple):
        others = set(map(type, value)) - _NUMBERS
        return bool(others) and any(map(loses_something, value))
    if isinstance(value, np.ndarray):  # subclasses have units, or a mask
        return kind not in (np.ndarray, np.memmap)
    if hasattr(kind, "dims"):  # of xarray
        return loses_something(value.data)
    has_unit = hasattr(kind, "dimensionality") or hasattr(kind, "unit")
    return has_unit or hasattr(kind, "units")


def array_of(value: Any) -> NDArray[Any]:
    """Return an input as an array, an array of objects (which every check rejects) if a mask or unit would be lost."""
    nothing = np.asarray(None)
    try:
        is_text = isinstance(value, bytearray)
        array = nothing if is_text or loses_something(value) else np.asarray(value)
    except (ValueError, RuntimeError):  # ragged, or nested too deep
        return nothing
    if array.dtype.kind == "f":
        return array.astype(np.float64, copy=False)
    return array


def real_number(value: Any) -> float:
    """Return one real number as a float; NaN for anything else."""
    array = array_of(value)
    is_number = array.ndim == 0 and array.dtype.kind in "iuf"
    return float(array) if is_number else math.nan


class Frozen(dict[Any, Any]):
    """Read-only mapping whose contents were checked."""

    def _refuse(self, *_: Any, **__: Any) -> Any:
        raise TypeError("a scene's mappings are read-only: use dataclasses.replace(scene, ...) to change a copy")

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        """Return the constructor's arguments for pickle."""
        return Frozen, (dict(self),)


EMPTY = Frozen()
_FIXED = frozenset((bool, int, float, str, Frozen))


def frozen(value: Any) -> Any:
    """Return a read-only copy of an array, a list or a mapping, and any other value unchanged."""
    kind = type(value)
    if kind in _FIXED:
        return value
    if kind is dict or isinstance(value, Mapping):
        if not value:
            return EMPTY
        if _FIXED.issuperset(map(type, value.values())):
            return Frozen(value)
        return Frozen({key: frozen(one) for key, one in value.items()})
    if kind is list or kind is tuple:
        items = tuple(map(frozen, value))
        same = kind is tuple and all(map(is_, items, value))
        return value if same else items
    if isinstance(value, np.floating):
        return float(value)
    if not hasattr(kind, "__array__") or isinstance(value, np.generic):
        return value
    if not loses_something(value):
        array = _read_only(array_of(value))
        if hasattr(kind, "dims"):  # xarray's stay labelled
            return value.copy(data=array)
        return array
    return value


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return an array that cannot be modified. Writeable arrays are copied."""
    base = getattr(array.base, "flags", array.flags)
    can_change = array.flags.writeable or base.writeable
    if can_change:
        array = array.copy()
        array.flags.writeable = False
    return array


def freeze(owner: Any, fields: Iterable[str]) -> None:
    """Replace the named fields of a frozen dataclass by read-only copies."""
    for name in fields:
        value = getattr(owner, name)
        read_only = frozen(value)
        if read_only is not value:
            object.__setattr__(owner, name, read_only)


def choose(mask: Any, one: Any, other: Any) -> Any:
    """Return ``one`` where a mask is true and else ``other``, without an array if the mask is a single truth value."""
    if isinstance(mask, np.ndarray):
        return np.where(mask, one, other)
    return one if mask else other


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Return the rounded sum of two numbers and its rounding error (Knuth's TwoSum)."""
    total = a + b
    part = total - a
    error_of_a = a - (total - part)
    error_of_b = b - part
    return total, error_of_a + error_of_b
