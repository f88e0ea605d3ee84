"""Detection of records that occur twice in a suite."""

from collections.abc import Callable, Sequence

import numpy as np

from slipcircle.base.kinds import Floats

_TOLERANCE = 1e-6  # of the peak


def repeated(measures: Sequence[tuple[int, float, float]], values: Callable[[int], Floats]) -> dict[int, int]:
    """Return the places of records that repeat an earlier record, each with the place of that record.

    Parameters
    ----------
    measures : sequence of (int, float, float)
        Number of samples, time between them and peak acceleration of each record.
    values : callable
        Function that returns the samples of the record at a place; called only for records whose measures agree.
    """
    earlier = {}
    different: dict[tuple[int, str], list[int]] = {}
    for k, (samples, step, peak) in enumerate(measures):
        alike = different.setdefault((samples, f"{step:.6g}"), [])
        near = (other for other in alike if abs(measures[other][2] - peak) <= _TOLERANCE * peak)
        first = next((other for other in near if _are_equal(values(k), values(other), _TOLERANCE * peak)), None)
        if first is None:
            alike.append(k)
        else:
            earlier[k] = first
    return earlier


def _are_equal(one: Floats, other: Floats, within: float) -> bool:
    """Return whether samples agree, first where the first record is greatest, as records may be scaled to one peak."""
    top = one.argmax()
    is_near = abs(one[top] - other[top]) <= within
    return bool(is_near and np.max(np.abs(one - other)) <= within)
