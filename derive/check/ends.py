"""Functions of both ends of an arc: operations around a certified function of alpha.

With alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - theta_m and theta_m = (theta_1 + theta_2)/2, a certificate states
C(alpha) cos(psi), C(alpha) sin(psi) or C(alpha) tan(psi), where C consists of one or two statements of
`derive.check.truth`.

2 theta_m - n pi, with n even for cos(psi) = -sin(theta_m) and odd for sin(psi) = -cos(theta_m), is the sum of both ends
and of n times four parts of pi, where n times the first three parts is exact. Passes of error-free sums (Ogita, Rump
and Oishi 2005) compute it as b + low, however small it is. To first order in low and in the rounding error of alpha,

    C(alpha) sin((b + low)/2) = C (b + low k(b/2) + b (lost/d) 3 k(alpha))/2 sinc(b/2),   k(x) = x cot(x),

with d = 2 alpha, as C rises nearly like sin(alpha)**3. Errors are relative with respect to the exact ends, plus
2**-1000 for underflow. The module uses the standard library and python-flint only.
"""

import math
from dataclasses import dataclass
from functools import partialmethod, reduce
from operator import add
from typing import Any

from derive.check.truth import TOP, Definition
from derive.kinds import Coefficients

LIMIT = 2.0**16  # greatest end, rad: ten thousand turns
PASSES = 3
TURN = 0.5 / math.pi
# Number of terms of sinc's Taylor series.
TERMS = {"best": 12, "1e-10": 8, "1e-6": 6}
# Coefficients of x cot(x) in powers of x**2.
COTANGENT = (1.0, -1 / 3, -1 / 45, -2 / 945, -1 / 4725)
# Parts of pi; all but the last have 37 bits.
PI = (3.1415926535846666, 5.1266883031679116e-12, 2.1125998133888136e-23, 8.671810130123781e-35)


# --- operations ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class RecordedValue:
    """Value on a list of operations, as in certificates. Arithmetic appends to the list."""

    operations: list[list[Any]]
    place: int = 0

    def put(self, kind: str, *others: Any, value: str | None = None) -> "RecordedValue":
        """Return the step of an operation on this and other steps or numbers, appended unless it exists."""
        places = [self.place]
        for x in others:
            if isinstance(x, RecordedValue):
                place = x.place
            else:
                place = self._find(["const", [], float(x).hex()])
            places.append(place)
        place = self._find([kind, places, value])
        return RecordedValue(self.operations, place)

    def _find(self, operation: list[Any]) -> int:
        if operation not in self.operations:
            self.operations.append(operation)
        return self.operations.index(operation)

    __add__ = partialmethod(put, "add")
    __sub__ = partialmethod(put, "sub")
    __mul__ = partialmethod(put, "mul")
    __truediv__ = partialmethod(put, "div")


def _two_sum(a: RecordedValue, b: RecordedValue) -> tuple[RecordedValue, RecordedValue]:
    """Return fl(a + b) and its rounding error."""
    return a + b, a.put("lost", b)


def _horner(x: RecordedValue, coefficients: Coefficients) -> RecordedValue:
    """Return the polynomial with these coefficients, lowest first."""
    *others, second, last = coefficients
    result = x * last + second
    for c in reversed(others):
        result = result * x + c
    return result


def sinc(x: RecordedValue, terms: int) -> RecordedValue:
    """Return sin(x)/x by its Taylor series of this many terms."""
    return _horner(x * x, tuple((-1) ** k / math.factorial(2 * k + 1) for k in range(terms)))


def cotangent(x: RecordedValue) -> RecordedValue:
    """Return an approximation of x cot(x)."""
    return _horner(x * x, COTANGENT)


def passed(terms: list[RecordedValue]) -> list[RecordedValue]:
    """Return the rounding errors of a sum, followed by the sum."""
    total = terms[0]
    losses = []
    for term in terms[1:]:
        total, lost = _two_sum(total, term)
        losses.append(lost)
    return [*losses, total]


def reduced(one: RecordedValue, two: RecordedValue, odd: bool) -> tuple[RecordedValue, RecordedValue, RecordedValue]:
    """Return b, low k(b/2) and a sign by which sin((b + low)/2) becomes sin(psi) if odd, otherwise cos(psi)."""
    half = (one + two) * TURN
    if odd:
        half = half - 0.5
    half = half.put("integer")
    n = half * 2.0
    if odd:
        n = n + 1.0
    terms = [one, two]
    for part in PI:
        terms.append(n * -part)
    for _ in range(PASSES):
        terms = passed(terms)
    high = terms.pop()
    b, low = _two_sum(high, reduce(add, terms))
    b = b.put("min", 2 * TOP)
    b = b.put("max", -2 * TOP)
    quarter = half * 0.5
    parity = quarter - quarter.put("integer")  # 0, or 1/2 or -1/2
    size = -4.0 if odd else 4.0
    sign = parity * parity * size - size / 8
    return b, cotangent(b * 0.5) * low, sign


def share(one: RecordedValue, two: RecordedValue) -> tuple[RecordedValue]:
    """Return the relative change of C(alpha) by the rounding error of d = theta_2 - theta_1."""
    d = two - one
    alpha = (d * 0.5).put("min", TOP)
    lost = two.put("lost", one.put("neg"))
    divisor = d.put("max", 2.0**-1000)
    return (cotangent(alpha) * 3.0 * (lost / divisor),)


def both() -> tuple[RecordedValue, RecordedValue]:
    """Return the ends on a new list of operations."""
    one = RecordedValue([["input", [], "theta_1"], ["input", [], "theta_2"]])
    return one, RecordedValue(one.operations, 1)


def result(definition: Definition, tier: str, part: str) -> RecordedValue:
    """Return a function of both ends on its operations; ``part`` names the function that computes C(alpha).

    ``integer`` rounds to the nearest integer, ties to even, and ``lost`` is the rounding error of a sum.
    """
    one, two = both()
    direction = definition[-1]
    alpha = ((two - one) * 0.5).put("min", TOP)
    amplitude = alpha.put("call", value=part)
    if direction == "tan psi":
        above, sine, sign = _turned(one, two, True, tier)
        below, cosine, other = _turned(one, two, False, tier)
        return above * (amplitude * sine / cosine) * (sign * other * 4.0) / below
    b, sine, sign = _turned(one, two, "sin" in direction, tier, *share(one, two))
    if direction[0] == "-":
        sign = sign * -1.0
    return amplitude * sine * sign * b


def _turned(
    one: RecordedValue, two: RecordedValue, odd: bool, tier: str, share: RecordedValue | None = None
) -> tuple[RecordedValue, RecordedValue, RecordedValue]:
    """Return b corrected by low and the rounding of alpha, its sinc, and the sign."""
    b, carried, sign = reduced(one, two, odd)
    if share is not None:
        carried = carried + b * share
    return b + carried, sinc(b * 0.5, TERMS[tier]), sign
