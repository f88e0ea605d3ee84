"""Double-double arithmetic with about 32 digits (Dekker 1971), for differences of nearly equal numbers."""

from dataclasses import dataclass
from typing import Any, Self

from slipcircle.base.arrays import two_sum

_SPLITTER = 134217729.0  # 2^27 + 1


@dataclass(frozen=True, slots=True)
class DoubleDouble:
    """Arrays of numbers high + low, where low is below the rounding of high."""

    high: Any
    low: Any = 0.0

    def __add__(self, other: Self) -> Self:
        """Return the sum."""
        high, low = two_sum(self.high, other.high)
        of_low_parts = self.low + other.low
        lost = low + of_low_parts
        high, low = two_sum(high, lost)
        return type(self)(high, low)

    def __sub__(self, other: Self) -> Self:
        """Return the difference."""
        negative = type(self)(-other.high, -other.low)
        return self + negative

    def __mul__(self, other: Self) -> Self:
        """Return the product."""
        product = self.high * other.high
        error = _product_error(self.high, other.high, product)
        crossed = self.high * other.low + self.low * other.high
        high, low = two_sum(product, error + crossed)
        return type(self)(high, low)


def _product_error(a: Any, b: Any, product: Any) -> Any:
    """Return the exact error a b - product of a rounded product of floats.

    It is computed from halves of a and b whose products are exact.
    """
    a_high, a_low = _halves(a)
    b_high, b_low = _halves(b)
    of_high_parts = a_high * b_high - product
    crossed = of_high_parts + a_high * b_low + a_low * b_high
    return crossed + a_low * b_low


def _halves(a: Any) -> tuple[Any, Any]:
    """Return the upper and the lower half of the digits of numbers, whose sum is exact (Dekker's split)."""
    shifted = _SPLITTER * a
    high = shifted - (shifted - a)
    return high, a - high
