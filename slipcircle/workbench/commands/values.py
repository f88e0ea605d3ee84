"""Values of command-line options: times, counts, observations, and values of keys."""

import argparse
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.common.quantities import Interval, Observed

MOST_TIMES = 1_000_000


def times(text: str) -> NDArray[np.float64]:
    """0:60:1 as times from 0 to 60 s."""
    try:
        first, last, step = map(float, text.split(":"))
        count = np.floor((last - first) / step * (1 + 1e-12)) + 1
        if not (0.0 <= first <= last and 0.0 < step and count <= MOST_TIMES):
            raise ValueError
    except (ValueError, ZeroDivisionError):
        message = f"{text}: must be FROM:TO:STEP in s, such as 0:60:1, at most {MOST_TIMES} times"
        raise argparse.ArgumentTypeError(message) from None
    return np.asarray(first + step * np.arange(int(count)), dtype=np.float64)


def count(text: str) -> int:
    """1000000, or 1e6."""
    value = float(text)
    if value != int(value):
        raise ValueError
    return int(value)


def observed(text: str, size: float = 1.0) -> Observed:
    """Return 400, 400+-20, an interval, 300:450, or a limit, <60, in a unit of some size as what is observed, in SI."""
    if (limit := Interval.of_limit(text)).limit is not None:
        return Interval(*(size * end for end in limit))
    value, *error = text.replace("\N{PLUS-MINUS SIGN}", "+-").split("+-")
    try:
        if ":" in text:
            return Interval(*(size * float(end) for end in text.split(":")))
        return (size * float(value), size * float(error[0])) if len(error) == 1 else size * float(text)
    except (TypeError, ValueError):
        forms = "a number, or one with its error: 400+-20, an interval: 300:450, or a limit: '<60'"
        raise argparse.ArgumentTypeError(f"{text}: must be {forms}") from None


def removed(text: str) -> None:
    """Reject ``--reach-m``."""
    raise argparse.ArgumentTypeError("was removed; use --run-out-m, which is the greatest displacement")


def by_key(option: str, texts: Sequence[str], form: str, read: Callable[[str], Any]) -> dict[str, Any]:
    """Values of KEY=VALUE by key; each key once."""
    values: dict[str, Any] = {}
    errors = []
    for text in texts:
        key, _, value = text.partition("=")
        try:
            if key in values:
                raise ValueError
            values[key] = read(value)
        except ValueError:
            errors.append(f"--{option} {text}: must be {form}")
    if errors:
        raise ValueError("\n".join(errors))
    return values


def bounds(text: str) -> tuple[float, float] | None:
    """LOW:HIGH, or nothing."""
    if not text:
        return None
    low, high = map(float, text.split(":"))
    return low, high


def distribution(text: str) -> dict[str, Any]:
    """NAME:A:B, as a scene file has it."""
    name, *numbers = text.split(":")
    parameters = DISTRIBUTIONS[name].parameters if name in DISTRIBUTIONS else ()
    return {"distribution": name} | dict(zip(parameters, map(float, numbers), strict=True))


def levels(text: str) -> NDArray[np.float64]:
    """FROM:TO:COUNT, or A,B,C."""
    if text.count(":") == 2:
        first, last, number = text.split(":")
        return np.linspace(float(first), float(last), int(number))
    return np.array([float(v) for v in text.split(",")])
