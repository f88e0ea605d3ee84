"""Closed forms in decimal arithmetic, for differences of nearly equal numbers."""

import math
import sys
from decimal import Decimal, localcontext
from functools import lru_cache

from generated.definitions import CLOSED, QUOTIENTS

_DIGITS = 50
_HALVINGS = 12  # of an angle, so that its series is short


def sin(x: Decimal) -> Decimal:
    """Return the sine of an angle in rad, with the precision of the current decimal context."""
    return _sine_and_cosine(x)[0]


def cos(x: Decimal) -> Decimal:
    """Return the cosine of an angle in rad, with the precision of the current decimal context."""
    return _sine_and_cosine(x)[1]


def atanh(x: Decimal) -> Decimal:
    """Return the inverse hyperbolic tangent, with the precision of the current decimal context."""
    ratio = (1 + x) / (1 - x)
    return ratio.ln() / 2


@lru_cache(maxsize=8)
def _sine_and_cosine(x: Decimal) -> tuple[Decimal, Decimal]:
    """Return sine and cosine of an angle in rad.

    Their series are evaluated at a fraction of the angle, which is then doubled repeatedly.
    """
    part = x / 2**_HALVINGS
    sine = Decimal(0)
    term = part
    k = 2
    while sine + term != sine:
        sine += term
        term *= -part * part / (k * (k + 1))
        k += 2
    cosine = (1 - sine * sine).sqrt()
    for _ in range(_HALVINGS):
        twice = 2 * sine
        sine, cosine = twice * cosine, 1 - twice * sine
    return sine, cosine


@lru_cache(maxsize=4096)
def exact_limit_friction(theta_1: float, theta_2: float) -> Decimal:
    """Return the limit friction (3.21) of an arc between two angles in rad, with 50 digits."""
    first = Decimal(theta_1)
    last = Decimal(theta_2)
    with localcontext() as context:
        context.prec = 1100  # sums of two floats are exact
        alpha = (last - first) / 2
        middle = (first + last) / 2
        context.prec = _DIGITS - 2 * alpha.adjusted()  # closed forms are differences of size alpha**3
        arithmetic = sys.modules[__name__]
        above, below = (CLOSED[name](arithmetic, alpha) for name in QUOTIENTS["weight_moment_per_radial_weight"])
        cotangent = cos(middle) / sin(middle)
        return abs(above / below * cotangent)


def limit_parts(theta_1: float, theta_2: float) -> tuple[float, float]:
    """Return the limit friction (3.21) of an arc between two angles in rad as the next float above and the rest.

    A friction equal to the float holds the mass, and the float below it does not.
    """
    exact = exact_limit_friction(theta_1, theta_2)
    rounded = float(exact)
    if Decimal(rounded) < exact:
        rounded = math.nextafter(rounded, math.inf)
    with localcontext(prec=_DIGITS):
        return rounded, float(exact - Decimal(rounded))
