"""Types for annotations."""

from collections.abc import Mapping
from typing import Any

Pair = tuple[float, float]
Coefficients = tuple[float, ...]
Names = tuple[str, ...]
Texts = list[str]
TextPair = tuple[str, str]
TextDict = dict[str, str]
TextMap = Mapping[str, str]  # by name
ValueDict = dict[str, Any]
Values = Mapping[str, Any]
