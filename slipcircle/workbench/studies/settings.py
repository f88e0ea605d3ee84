"""The settings of an ensemble: a sentence for each mistake in them."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from slipcircle.base.checks import shown
from slipcircle.core import Scene, checked
from slipcircle.workbench.files.numbers import Uncertain, uncertain_numbers
from slipcircle.workbench.studies.design import METHODS
from slipcircle.workbench.studies.groundmotions import OfRecords
from slipcircle.workbench.studies.searched import search_mistakes

_MOST = 10**12
_MOST_BASE = 2**22
_LARGEST = 2**30  # block
OF_ARRAYS = "a scene of arrays is solved as it is: use solve"
_Flag = bool | np.bool_ | None  # None where it is not given
_OUTSIDE = 1e-4  # of a distribution, that may lie out of a number's bounds; such samples are counted apart


def setting_mistakes(
    scene: Scene, n: Any, confidence: Any, settings: Sequence[Any], correlation: Any, records: Any, shaken: OfRecords
) -> list[str]:
    """A sentence for each mistake."""
    method, points, size, search_each = settings
    with_records = records is not None
    flags = {"search_each": search_each, "polarities": shaken.polarities, "strict": shaken.strict}
    found = _scene_mistakes(scene, search_each, with_records)
    found += _number_mistakes(n, method, size, confidence) + _sensitivity_mistakes(points, correlation)
    found += [f"{k} = {v!r}: must be True or False" for k, v in flags.items() if not isinstance(v, _Flag)]
    if with_records and (search_each or points):
        found.append("search_each and sensitivity do not go with records; leave them out")
    for name, value in shaken._asdict().items():
        if not (with_records or value is None or value is False):
            found.append(f"{name} = {value!r}: is for records; give records as well")
    return found or _truncated(uncertain_numbers(scene))


def _scene_mistakes(scene: Scene, search_each: bool, with_records: bool) -> list[str]:
    mistakes = [OF_ARRAYS] if checked(scene, "ensemble").shape else []
    if not scene.uncertain and not with_records:
        mistakes.append("no number is uncertain; give Scene(uncertain=...), --uncertain, or a distribution in its file")
    return mistakes + (search_mistakes(scene) if search_each else [])


def _number_mistakes(n: Any, method: Any, size: Any, confidence: Any) -> list[str]:
    """A sentence for each setting out of bounds."""
    mistakes = []
    if not (whole(n) and 1 <= n <= _MOST):
        mistakes.append(f"n = {shown(n)}: must be a whole number of samples, from 1 to {_MOST:.0e}")
    if method not in METHODS:
        mistakes.append(f"method = {shown(method)}: must be one of {', '.join(METHODS)}")
    if not (isinstance(confidence, float) and 0.0 < confidence < 1.0):
        mistakes.append(f"confidence = {shown(confidence)}: must be between 0 and 1")
    if size is not None and not (whole(size) and 4 <= size <= _LARGEST and not int(size) & (int(size) - 1)):
        mistakes.append(f"size = {shown(size)}: must be a power of two from 4 to {_LARGEST}")
    return mistakes


def _sensitivity_mistakes(points: Any, correlation: Any) -> list[str]:
    mistakes = []
    if points is not None and not (whole(points) and 0 <= points <= _MOST_BASE and points != 1):
        mistakes.append(f"sensitivity = {shown(points)}: must be 0, or 2 to {_MOST_BASE} base points")
    if correlation is not None and not (isinstance(correlation, Mapping) and all(map(_is_pair, correlation))):
        mistakes.append(f"correlation = {correlation!r}: must be a mapping from pairs of keys to numbers")
    if correlation and points:
        mistakes.append("sensitivity indices need independent inputs; omit correlation or sensitivity")
    return mistakes


def _truncated(drawn: Mapping[str, Uncertain]) -> list[str]:
    """A sentence for each distribution of which much lies where there is no scene: it is truncated only by name."""
    found = []
    for uncertain in drawn.values():
        number, distribution = uncertain.number, uncertain.distribution
        outside = float(distribution.cdf(number.low) + 1.0 - distribution.cdf(number.high))
        if outside > _OUTSIDE:
            found.append(
                f"{number.key}: {100 * outside:.2g} % of its distribution lies outside of {number.low:g} to "
                f"{number.high:g}, where scenes are invalid; use truncated_normal with low and high"
            )
    return found


def _is_pair(keys: Any) -> bool:
    return isinstance(keys, tuple) and len(keys) == 2


def whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)
