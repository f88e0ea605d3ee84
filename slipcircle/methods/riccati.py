"""One step of d(omega)/dt = a(t) - e omega - b omega**2 with a polynomial a: exact to rounding, on floats and arrays.

omega = u'/(b u) makes it linear: u'' + e u' = b a u. With its solutions p (1, 0) and q (0, 1) at the start of the step,
omega(h) = (p'/b + omega q')/(p + b omega q) and phi = log1p(b G)/b with G = (p - 1)/b + omega q; all stays finite as b
goes to 0. p and q are power series, whose terms fall like (b |a| h**2)**k/(2 k)!.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

REACH = 0.25  # the largest b |a| h**2, and the largest e h, of a step: longer ones are divided
_MOST_TERMS = 60
_SMALL = 1e-19


class Step(NamedTuple):
    """What a step takes: thrust = p'/b, lean = (p - 1)/(b h), swing = q/h, change = q' - p."""

    thrust: Any
    lean: Any
    swing: Any
    change: Any


def step(a: Sequence[Any], b: Any, e: Any, h: Any) -> Step:
    """Sums of the series of a step, to the term that no longer counts; its fall checks what is left out."""
    size, plain = len(a), isinstance(h, float)
    powers, power = [], h
    for c in a:
        powers.append(c * power)
        power = power * h
    bh, eh = b * h, e * h
    p: list[Any] = [0.0, 0.0]  # (p - 1)/(b h), term by term
    q: list[Any] = [0.0, 1.0]  # q/h
    thrust = lean = change = 0.0 * bh
    swing = 1.0 + thrust
    for k in range(_MOST_TERMS):
        more = powers[k] if k < size else 0.0
        turn = 0.0
        for j in range(min(size, k + 1)):
            by = powers[j] * bh
            more = more + by * p[k - j]
            turn = turn + by * q[k - j]
        share = 1.0 / ((k + 1) * (k + 2))
        p.append((more - eh * ((k + 1) * p[k + 1])) * share)
        q.append((turn - eh * ((k + 1) * q[k + 1])) * share)
        thrust = thrust + (k + 2) * p[k + 2]
        lean = lean + p[k + 2]
        swing = swing + q[k + 2]
        change = change + ((k + 2) * q[k + 2] - bh * p[k + 1])
        if k > size:
            last = [q[-1], q[-2], bh * p[-1], bh * p[-2]]
            if (
                max(map(abs, last)) if plain else max(float(np.max(np.abs(x), initial=0.0)) for x in last)
            ) * k < _SMALL:
                return Step(thrust, lean, swing, change)
    raise FloatingPointError("a step's series does not converge")


def advance(a: Sequence[Any], b: Any, e: Any, omega: Any, h: Any, braked: bool) -> tuple[Any, Any]:
    """omega and phi after h; without brakes their polynomials."""
    if not braked:
        gain, turn = a[-1] / len(a), a[-1] / (len(a) * (len(a) + 1))
        for j in range(len(a) - 2, -1, -1):
            gain, turn = gain * h + a[j] / (j + 1), turn * h + a[j] / ((j + 1) * (j + 2))
        return omega + gain * h, h * (omega + turn * h)
    s = step(a, b, e, h)
    grown = h * (s.lean + omega * s.swing)
    y = b * grown
    after = omega + (s.thrust + omega * (s.change - b * h * omega * s.swing)) / (1.0 + y)
    if isinstance(y, float):
        return after, grown * (math.log1p(y) / y if y else 1.0)
    some = np.where(y == 0.0, 1.0, y)
    return after, grown * np.where(y == 0.0, 1.0, np.log1p(some) / some)
