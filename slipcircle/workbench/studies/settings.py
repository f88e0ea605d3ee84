"""Settings of an ensemble: allowed values, and a message for each mistake."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.arrays import array_of
from slipcircle.base.bounds import abridged
from slipcircle.base.kinds import Function, Texts, Values
from slipcircle.core import Scene, checked_scene
from slipcircle.workbench.files.numbers import Uncertain, uncertain_numbers
from slipcircle.workbench.studies.design import METHODS
from slipcircle.workbench.studies.searched import search_mistakes

_MOST = 10**12
_MOST_BASE = 2**22
_LARGEST = 2**30  # block
OF_ARRAYS = "a scene of arrays is solved as it is: use solve"
_OUTSIDE = 1e-4  # greatest probability outside the bounds of a parameter; such samples are invalid


class Setting(NamedTuple):
    """A condition on a value, a text of the allowed values, and whether the setting requires records."""

    is_valid: Function
    words: str
    of_records: bool = False


def whole(value: Any) -> bool:
    """Return whether a value is an integer (not a bool)."""
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def _is_flag(value: Any) -> bool:
    """Return whether a value is a bool."""
    return isinstance(value, bool | np.bool_)


def _are_positive(values: Any) -> bool:
    """Return whether values are one positive finite number or a list of them."""
    numbers = array_of(values)
    is_list = numbers.ndim < 2 and numbers.size > 0 and numbers.dtype.kind in "iuf"
    return is_list and bool(np.all((numbers > 0.0) & (numbers < np.inf)))


def _are_pairs(value: Any) -> bool:
    """Return whether a value is a mapping whose keys are pairs."""
    return isinstance(value, Mapping) and all(isinstance(pair, tuple) and len(pair) == 2 for pair in value)


_FLAG = "must be True or False"
_POSITIVE = "must be one or more positive numbers"
SETTINGS: Mapping[str, Setting] = {
    "n": Setting(lambda x: whole(x) and 1 <= x <= _MOST, f"must be a whole number of samples, from 1 to {_MOST:.0e}"),
    "method": Setting(lambda x: x in METHODS, f"must be one of {', '.join(METHODS)}"),
    "confidence": Setting(lambda x: isinstance(x, float) and 0.0 < x < 1.0, "must be between 0 and 1"),
    "size": Setting(
        lambda x: whole(x) and 4 <= x <= _LARGEST and not int(x) & (int(x) - 1),
        f"must be a power of two from 4 to {_LARGEST}",
    ),
    "sensitivity": Setting(
        lambda x: whole(x) and 0 <= x <= _MOST_BASE and x != 1, f"must be 0, or 2 to {_MOST_BASE} base points"
    ),
    "correlation": Setting(_are_pairs, "must be a mapping from pairs of keys to numbers"),
    "search_each": Setting(_is_flag, _FLAG),
    "polarities": Setting(_is_flag, _FLAG, True),
    "strict": Setting(_is_flag, _FLAG, True),
    "scales": Setting(_are_positive, _POSITIVE, True),
    "scale_to_pga": Setting(_are_positive, _POSITIVE, True),
    "thresholds": Setting(_are_positive, _POSITIVE, True),
}


def setting_mistakes(scene: Scene, settings: Values, records: Any) -> Texts:
    """Return faults for invalid values of `SETTINGS`, and for settings that exclude each other.

    ``settings`` are the arguments of `ensemble` by name; ``records`` is None without records.
    """
    faults = [OF_ARRAYS] if checked_scene(scene, "ensemble").shape else []
    if not scene.uncertain and records is None:
        faults.append(
            "the scene has no uncertain parameter; give Scene(uncertain=...), --uncertain, or one in the file"
        )
    for name, setting in SETTINGS.items():
        value = settings[name]
        if value is not None and not setting.is_valid(value):
            faults.append(f"{name} = {abridged(value)}: {setting.words}")
        elif setting.of_records and records is None and value is not None and value is not False:
            faults.append(f"{name} = {abridged(value)}: is for records; give records as well")
    if settings["search_each"]:
        faults += search_mistakes(scene)
    if settings["correlation"] and settings["sensitivity"]:
        faults.append("sensitivity indices need independent inputs; omit correlation or sensitivity")
    if records is not None and (settings["search_each"] or settings["sensitivity"]):
        faults.append("search_each and sensitivity cannot be combined with records; leave them out")
    if settings["scales"] is not None and settings["scale_to_pga"] is not None:
        faults.append("scales and scale_to_pga exclude each other; leave one out")
    return faults or _truncated(uncertain_numbers(scene))


def _truncated(drawn: Mapping[str, Uncertain]) -> Texts:
    """Return a message for each distribution with too much probability outside the bounds of its parameter.

    ``drawn`` are the uncertain parameters by name.
    """
    faults = []
    for uncertain in drawn.values():
        number = uncertain.number
        distribution = uncertain.distribution
        outside = float(distribution.cdf(number.low) + 1.0 - distribution.cdf(number.high))
        if outside > _OUTSIDE:
            faults.append(
                f"{number.key}: {100 * outside:.2g} % of its distribution lies outside of {number.low:g} to "
                f"{number.high:g}, where scenes are invalid; use truncated_normal with low and high"
            )
    return faults
