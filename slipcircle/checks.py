"""One clear error for bad input: every mistake at once, each with the field, the value and what is allowed."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

INFINITY = float("inf")
Bounds = tuple[float, float, str]  # lower, upper (both open), and the same in words


def mistakes(fields: Mapping[str, ArrayLike], bounds: Mapping[str, Bounds]) -> list[str]:
    """A sentence for each field that is no finite real number within its open bounds."""
    found = []
    for name, (lower, upper, allowed) in bounds.items():
        try:
            value = np.asarray(fields[name], dtype=np.float64)
        except (TypeError, ValueError):
            found.append(f"{name} = {fields[name]!r}: must be {allowed}")
            continue
        bad = ~(np.isfinite(value) & (value > lower) & (value < upper))
        if np.any(bad):
            found.append(f"{name} = {value[bad].flat[0]:.10g}: must be {allowed}")
    return found


def raise_all(what: str, found: list[str]) -> None:
    """Raise one ValueError that lists the mistakes, if there are any."""
    if found:
        raise ValueError(f"{what}: " + "; ".join(found))
