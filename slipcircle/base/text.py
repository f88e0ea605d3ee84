"""Numbers as text, rounded to significant digits."""

import math

DIGITS = 4  # significant, of a number that people read


def shown(value: float, digits: int = DIGITS) -> str:
    """A number rounded to significant digits."""
    if math.isnan(value):
        return "-"
    if math.isinf(value):
        return "infinite" if value > 0.0 else "-infinite"
    rounded = float(f"{value:.{digits - 1}e}") + 0.0  # no -0
    return f"{rounded:.{max(digits, 6)}g}"


def digits_left(error: float) -> int:
    """Significant digits, at most `DIGITS`, for which a relative error changes the last one by at most half a unit."""
    if error <= 0.0:
        return DIGITS
    known = math.floor(-math.log10(min(2 * error, 1.0)))
    return max(1, min(DIGITS, known))


def clean(text: str, kept: str = "") -> str:
    """Text with a replacement character for each control character, except for those to be kept."""
    cleaned = []
    for character in text:
        if character.isprintable() or character in kept:
            cleaned.append(character)
        elif character.isspace():
            cleaned.append(" ")
        else:
            cleaned.append("\N{REPLACEMENT CHARACTER}")
    return "".join(cleaned)
