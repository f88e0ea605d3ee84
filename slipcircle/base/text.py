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
