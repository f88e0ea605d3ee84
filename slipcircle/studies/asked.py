"""What a back-analysis is asked: fields, observations and bounds, and the mistakes that are made in them."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import raise_all
from slipcircle.scene.numbers import DIP, Number
from slipcircle.scene.scene import Scene

Floats = NDArray[np.float64]
Observed = float | tuple[float, float]
Observations = Mapping[str, tuple[float, float | None]]
Bounds = tuple[float, float]


def check(
    scene: Scene, fields: Sequence[Number], observed: Observations, bounds: Any, between: Mapping[str, Bounds]
) -> None:
    """Refuse what makes no sense together."""
    wrong, full, seen = [], [f.name for f in fields], ", ".join(observed)
    if not fields:
        wrong.append("field = []: name one at least")
    if twice := sorted({f.key for f in fields if full.count(f.name) > 1}):
        wrong.append(f"field: {', '.join(twice)} is named twice")
    if DIP.name in full and {"theta_1", "theta_2"} & {*full}:
        wrong.append("field: arc.dip_deg turns theta_1 and theta_2 together; leave it or them out")
    if scene.arc.given is not None and {DIP.name, "theta_1", "theta_2"} & {*full}:
        wrong.append("field: the arc's coefficients are given, and do not follow its angles")
    if len(fields) > len(observed):
        wrong.append(
            f"{len(fields)} fields from {len(observed)} of what is observed ({seen}): they cannot be told apart; give "
            "as many observations as fields, or fewer fields"
        )
    if isinstance(bounds, tuple) and len(fields) > 1:
        wrong.append(
            f"bounds = {bounds!r}: of several fields give a mapping, such as {{{fields[0].key!r}: {bounds!r}}}"
        )
    if other := [n for n in between if n not in [f.key for f in fields]]:
        wrong.append(f"bounds: {', '.join(other)} is none of the fields")
    raise_all("backanalyse", wrong)


def observations(given: Mapping[str, Observed | None]) -> dict[str, tuple[float, float | None]]:
    found, wrong = {}, []
    for name, value in given.items():
        if value is None:
            continue
        try:
            seen, sigma = map(float, value) if isinstance(value, (tuple, list)) else (float(value), None)
        except (TypeError, ValueError):
            seen, sigma = math.nan, None
        positive = sigma is None or 0.0 < sigma < math.inf
        if not positive or not math.isfinite(seen) or seen == 0.0 or (name == "duration" and seen < 0.0):
            least = "a positive number" if name == "duration" else "a number other than 0"
            wrong.append(f"{name} = {value!r}: must be {least}, or it and its positive standard error")
        else:
            found[name] = (seen, sigma)
    if not found and not wrong:
        wrong.append(f"nothing observed: give one of {', '.join(given)}")
    if len({sigma is None for _, sigma in found.values()}) > 1:
        wrong.append("standard errors: give them for all observations, or for none")
    raise_all("backanalyse", wrong)
    return found


def between(name: str, low: float, high: float) -> Floats:
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ValueError(
            f"backanalyse: bounds of {name} = ({low!r}, {high!r}): must be two numbers, the lower one first"
        )
    return np.geomspace(low, high, 401) if 0.0 < 100 * low < high else np.linspace(low, high, 401)
