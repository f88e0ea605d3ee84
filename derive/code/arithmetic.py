"""Arithmetic as every machine rounds it, of whole arrays: the multiply-add and the parts of a float64.

NumPy's own add, subtract, multiply, divide and square root are IEEE operations. The fused multiply-add, which NumPy
lacks, is made of them without error (Boldo and Melquiond: the sum of a product's two halves and c, first rounded to
odd), and of fractions where a part would underflow.
"""

from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_SAFE = 2.0**-900  # a product of this size has an error term far above the subnormal numbers


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """fl(a + b) and what it lost; also of operations that are collected for a program."""
    total = a + b
    of_b = total - a
    return total, (a - (total - of_b)) + (b - of_b)


def two_product(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """fl(a b) and what it lost, by Veltkamp's halves."""
    product = a * b
    (a_high, a_low), (b_high, b_low) = _halves(a), _halves(b)
    return product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)


def _halves(x: Floats) -> tuple[Floats, Floats]:
    scaled = 134217729.0 * x  # 2**27 + 1
    high = scaled - (scaled - x)
    return high, x - high


def fma(a: Floats, b: Floats, c: Floats) -> Floats:
    """a b + c, rounded once."""
    a, b, c = np.broadcast_arrays(a, b, c)
    product, low = two_product(a, b)
    inner, inner_low = two_sum(c, low)
    total, total_low = two_sum(product, inner)
    odd, lost = two_sum(inner_low, total_low)
    bits = odd.view(np.int64)
    step = np.where((lost > 0) == (odd > 0), 1, -1)
    odd = np.where((lost != 0) & (bits & 1 == 0), bits + step, bits).view(np.float64)
    plain = (a == 0) | (b == 0)
    result = np.where(plain, product + c, total + odd)
    risky = ~plain & ((np.abs(product) < _SAFE) | ((c != 0) & (np.abs(c) < _SAFE)))
    if np.any(risky):
        result[risky] = [
            float(Fraction(x) * Fraction(y) + Fraction(z))
            for x, y, z in zip(a[risky].tolist(), b[risky].tolist(), c[risky].tolist(), strict=True)
        ]
    return np.asarray(result)


# Bits of 0.75: the significand lies in [0.75, 1.5).
_THREE_QUARTERS = 0x3FE8000000000000


def exponent(x: Floats) -> Floats:
    """k of x = significand 2**k, for a normal x > 0."""
    return ((x.view(np.int64) - _THREE_QUARTERS) >> 52).astype(np.float64)


def significand(x: Floats) -> Floats:
    """x 2**-k, in [0.75, 1.5)."""
    bits = x.view(np.int64)
    return np.asarray((bits - (((bits - _THREE_QUARTERS) >> 52) << 52)).view(np.float64))
