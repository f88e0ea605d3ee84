"""Types for annotations. A single motion is ``Motion[float]``, an ensemble ``Motion[Array]``.

A scene or motion whose kind is unknown before run time is annotated as ``Scene`` or ``Motion`` without brackets.
"""

import functools
from collections.abc import Callable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from functools import cached_property as cached_property

    from typing_extensions import TypeVar  # every type checker has it; it need not be installed

    Numbers = TypeVar("Numbers", bound=ArrayLike, covariant=True, default=Any)
else:
    from typing import TypeVar

    Numbers = TypeVar("Numbers", covariant=True)

    class cached_property(functools.cached_property):
        """Cached property without the lock that Python 3.11 takes, which costs a microsecond."""

        def __get__(self, instance, owner=None):
            """Return the stored value, computed at the first access."""
            if instance is None:
                return self
            value = instance.__dict__[self.attrname] = self.func(instance)
            return value


Floats = NDArray[np.float64]
Array = Floats
Integers = NDArray[np.intp]
Flags = NDArray[np.bool_]
ArrayPair = tuple[Floats, Floats]
ArrayTriple = tuple[Floats, Floats, Floats]
ArrayDict = dict[str, Floats]
ArrayMap = Mapping[str, Floats]
Pair = tuple[float, float]
Shape = tuple[int, ...]
Names = tuple[str, ...]
PathName = str | PathLike[str]
Function = Callable[[Any], Any]
Values = Mapping[str, Any]  # by name
ValueDict = dict[str, Any]
TextDict = dict[str, str]
TextMap = Mapping[str, str]
TextPair = tuple[str, str]
Texts = list[str]
Columns = dict[str, NDArray[Any]]  # arrays of any type by name
NumberMap = Mapping[str, float]
NumberDict = dict[str, float]
Rename = Callable[[str], str]  # from the name of an argument to the key of a file
Tell = Callable[[str], None]  # prints a line of progress
Parameters = Values  # of an effect or of a friction law
Effects = Mapping[str, Parameters]
MAPPING = (dict, Mapping)  # for isinstance, which is six times as fast if dict is first
