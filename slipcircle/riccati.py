"""One step of d(omega)/dt = a(t) - e omega - b omega**2 with a polynomial a: exact to rounding, on floats and arrays.

omega = u'/(b u) makes it linear: u'' + e u' = b a u. With the solutions p (1, 0) and q (0, 1) at the start of the step,
omega(h) = (P + omega q')/(1 + b G) and phi = log1p(b G)/b, where P = p'/b and G = (p - 1)/b + omega q stay finite as b
goes to 0. p and q are power series whose terms fall faster than (b |a| h**2)**k/(2 k)!.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

MOST_TERMS = 60
REACH = 0.25  # the largest b |a| h**2 of a step, and of e h: longer ones are divided
_SMALL = 1e-19


class Step(NamedTuple):
    """What a step takes to omega and phi: omega(h) = (thrust + omega turned)/den, den = 1 + b h (lean + omega swing).

    ``change`` is turned - (1 + b h lean), without cancellation.
    """

    thrust: Any
    lean: Any
    swing: Any
    change: Any


def step(a: Sequence[Any], b: Any, e: Any, h: Any, terms: int = 0) -> tuple[Step, int]:
    """The series of a step, and how many terms it takes; of floats with the number of terms that arrays took."""
    size = len(a)
    powers, power = [], h
    for c in a:
        powers.append(c * power)
        power = power * h
    bh, eh = b * h, e * h
    p: list[Any] = [0.0, 0.0]  # (p - 1)/(b h), term by term
    q: list[Any] = [0.0, 1.0]  # q/h
    thrust = lean = change = 0.0 * (b + h)
    swing, worst, k = 1.0 + thrust, 1.0, 0
    while k < terms if terms else worst > _SMALL or k < size + 2:
        more, turn = 0.0, 0.0
        for j in range(min(size, k + 1)):
            more = more + powers[j] * (bh * p[k - j])
            turn = turn + powers[j] * (bh * q[k - j])
        if k < size:
            more = more + powers[k]
        share = 1.0 / ((k + 1) * (k + 2))
        p.append((more - eh * ((k + 1) * p[k + 1])) * share)
        q.append((turn - eh * ((k + 1) * q[k + 1])) * share)
        thrust, lean, swing = thrust + (k + 2) * p[k + 2], lean + p[k + 2], swing + q[k + 2]
        change = change + ((k + 2) * q[k + 2] - bh * p[k + 1])
        k += 1
        if not terms:
            last = max(float(np.max(np.abs(x), initial=0.0)) for x in (q[-1], q[-2], bh * p[-1], bh * p[-2]))
            worst = last * k
            if k > MOST_TERMS:
                raise FloatingPointError("a step's series does not converge")
    # The last p is not in the sum that pairs q' with p one term later; it is below rounding.
    return Step(thrust, lean, swing, change), k


def advance(a: Sequence[Any], b: Any, e: Any, omega: Any, h: Any, terms: int) -> tuple[Any, Any]:
    """omega and phi after h; without brakes (no terms) their polynomials."""
    if terms == 0:
        gain, turn = a[-1] / len(a), a[-1] / (len(a) * (len(a) + 1))
        for j in range(len(a) - 2, -1, -1):
            gain, turn = gain * h + a[j] / (j + 1), turn * h + a[j] / ((j + 1) * (j + 2))
        return omega + gain * h, h * (omega + turn * h)
    s, _ = step(a, b, e, h, terms)
    grown = h * (s.lean + omega * s.swing)
    y = b * grown
    after = omega + (s.thrust + omega * (s.change - b * h * omega * s.swing)) / (1.0 + y)
    if isinstance(y, float):
        return after, grown * (math.log1p(y) / y if y else 1.0)
    some = np.where(y == 0.0, 1.0, y)
    return after, grown * np.where(y == 0.0, 1.0, np.log1p(y) / some)
