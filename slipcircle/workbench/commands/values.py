"""Parsers of command-line values: times, counts, observations, bounds, distributions and levels."""

import argparse
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats, Pair, ValueDict
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.common.quantities import Interval, Observed

MOST_TIMES = 1_000_000


def output_times(text: str) -> Floats:
    """Return evenly spaced times in s, parsed from ``FROM:TO:STEP`` such as ``0:60:1``."""
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
    """Return a whole number, parsed from text such as ``1000000`` or ``1e6``; otherwise raise ValueError."""
    value = float(text)
    if value != int(value):
        raise ValueError
    return int(value)


def observed(text: str, size: float = 1.0) -> Observed:
    """Return an observation in SI units, parsed from the text of a command-line option.

    Parameters
    ----------
    text : str
        A number (``400``), a number and its standard error (``400+-20``), an interval (``300:450``) or a
        limit (``<60``).
    size : float, optional
        Unit of the text in SI units.

    Returns
    -------
    float, (float, float) or Interval
        The value; the value and its standard error; or the interval.
    """
    if (limit := Interval.of_limit(text)).limit is not None:
        return Interval(*(size * end for end in limit))
    value, *error = text.replace("\N{PLUS-MINUS SIGN}", "+-").split("+-")
    try:
        if ":" in text:
            return Interval(*(size * float(end) for end in text.split(":")))
        return (size * float(value), size * float(error[0])) if len(error) == 1 else size * float(text)
    except (TypeError, ValueError):
        forms = "a number (400), a number with its error (400+-20), an interval (300:450) or a limit ('<60')"
        raise argparse.ArgumentTypeError(f"{text}: must be {forms}") from None


def removed(text: str) -> None:
    """Raise the error for the removed option ``--reach-m``."""
    raise argparse.ArgumentTypeError("was removed; use --run-out-m, which is the greatest displacement")


def values_by_key(option: str, texts: Sequence[str], form: str, read: Callable[[str], Any]) -> ValueDict:
    """Return values by key, parsed from texts ``KEY=VALUE``; a repeated key is an error.

    Parameters
    ----------
    option : str
        Name of the option, for messages.
    texts : sequence of str
        Texts as typed.
    form : str
        Allowed form, for messages.
    read : callable
        Parser of a value's text; it raises ValueError for invalid text.
    """
    values: ValueDict = {}
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


def low_and_high(text: str) -> Pair | None:
    """Return two numbers, parsed from ``LOW:HIGH``, in the unit of their key; None for empty text."""
    if not text:
        return None
    low, high = map(float, text.split(":"))
    return low, high


def distribution_parameters(text: str) -> ValueDict:
    """Return a distribution as a mapping of parameters, parsed from ``NAME:A:B`` such as ``normal:10:1``."""
    name, *numbers = text.split(":")
    parameters = DISTRIBUTIONS[name].parameters if name in DISTRIBUTIONS else ()
    return {"distribution": name} | dict(zip(parameters, map(float, numbers), strict=True))


def levels(text: str) -> Floats:
    """Return the levels of a grid, parsed from ``FROM:TO:COUNT`` (evenly spaced) or from ``A,B,C``, (count,)."""
    if text.count(":") == 2:
        first, last, number = text.split(":")
        return np.linspace(float(first), float(last), int(number))
    return np.array([float(v) for v in text.split(",")])
