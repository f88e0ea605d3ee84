"""Formatting of numbers and text."""

import math
from collections.abc import Mapping
from contextvars import ContextVar

DIGITS = 4  # significant digits of printed numbers
# Units of output by SI unit with their sizes; empty for SI.
PRINTED: ContextVar[Mapping[str, tuple[str, float]]] = ContextVar("PRINTED", default={})  # noqa: B039


def number_text(value: float, digits: int = DIGITS) -> str:
    """Return a number as text, rounded to a number of significant digits; "-" for NaN."""
    if math.isnan(value):
        return "-"
    if math.isinf(value):
        return "infinite" if value > 0.0 else "-infinite"
    rounded = float(f"{value:.{digits - 1}e}") + 0.0  # no -0
    return f"{rounded:.{max(digits, 6)}g}"


def output_unit(unit: str) -> tuple[float, str]:
    """Return the factor from an SI unit to the unit of output, and the name of the unit of output."""
    name, size = PRINTED.get().get(unit, (unit, 1.0))
    return 1.0 / size, name


def drawn_unit(unit: str) -> tuple[float, str]:
    """Return the factor from an SI unit to the unit of output in drawings, and that unit: kPa in place of Pa."""
    factor, name = output_unit(unit)
    return (1e-3, "kPa") if name == "Pa" else (factor, name)


def amount_text(value: float, unit: str, digits: int = DIGITS) -> str:
    """Return a quantity in an SI unit as text with its unit of output, rounded to a number of significant digits."""
    factor, name = output_unit(unit)
    return f"{number_text(factor * value, digits)} {name}".rstrip()


def digits_left(error: float) -> int:
    """Return the number of significant digits, at most `DIGITS`, that remain certain for a relative error.

    The error changes the last one by at most half a unit.
    """
    if error <= 0.0:
        return DIGITS
    certain_digits = math.floor(-math.log10(min(2 * error, 1.0)))
    return max(1, min(DIGITS, certain_digits))


def clean(text: str, kept: str = "") -> str:
    """Return a text in which each control character is replaced by a space or a replacement character.

    The characters in ``kept`` remain.
    """
    cleaned = []
    for character in text:
        if character.isprintable() or character in kept:
            cleaned.append(character)
        elif character.isspace():
            cleaned.append(" ")
        else:
            cleaned.append("\N{REPLACEMENT CHARACTER}")
    return "".join(cleaned)
