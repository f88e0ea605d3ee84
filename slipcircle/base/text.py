"""Formatting of numbers and text."""

import math

DIGITS = 4  # significant digits of printed numbers


def shown(value: float, digits: int = DIGITS) -> str:
    """Return a number as text, rounded to significant digits."""
    if math.isnan(value):
        return "-"
    if math.isinf(value):
        return "infinite" if value > 0.0 else "-infinite"
    rounded = float(f"{value:.{digits - 1}e}") + 0.0  # no -0
    return f"{rounded:.{max(digits, 6)}g}"


def digits_left(error: float) -> int:
    """Return the number of significant digits, at most `DIGITS`, that remain certain for a relative error.

    The error changes the last one by at most half a unit.
    """
    if error <= 0.0:
        return DIGITS
    known = math.floor(-math.log10(min(2 * error, 1.0)))
    return max(1, min(DIGITS, known))


def clean(text: str, kept: str = "") -> str:
    """Return a text in which each control character is replaced, except for the characters in ``kept``."""
    cleaned = []
    for character in text:
        if character.isprintable() or character in kept:
            cleaned.append(character)
        elif character.isspace():
            cleaned.append(" ")
        else:
            cleaned.append("\N{REPLACEMENT CHARACTER}")
    return "".join(cleaned)
