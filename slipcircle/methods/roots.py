"""Zeros and peaks of functions of one float, and the generated text over plain floats."""

import math
from collections.abc import Callable
from functools import cache
from types import FunctionType, SimpleNamespace
from typing import Any

# The generated text computes on plain floats too, with the standard library in NumPy's place: 20 times faster there.
_MATH = SimpleNamespace(
    sin=math.sin, cos=math.cos, exp=math.exp, expm1=math.expm1, log=math.log, log1p=math.log1p, sqrt=math.sqrt,
    arctan=math.atan, abs=abs, minimum=min, maximum=max, nan=math.nan, sign=lambda x: float((x > 0.0) - (x < 0.0)),
    where=lambda condition, yes, no: yes if condition else no,
)  # fmt: skip


@cache
def scalar(function: Any) -> Callable[..., Any]:
    """A generated function over plain floats."""
    return FunctionType(function.__code__, function.__globals__ | {"np": _MATH}, function.__name__)


def halley(function: Callable[[float], tuple[float, float, float]], x: float, low: float, high: float) -> float:
    """A zero of a function that falls through it in the bracket, from value, slope and curvature: Halley's steps.

    Where a step leaves the bracket, halving.
    """
    for _ in range(2000):
        value, slope, curvature = function(x)
        if value > 0.0:
            low = x
        else:
            high = x
        following = low
        if slope < 0.0:
            step = value / slope
            bend = step * curvature / slope
            following = x - step / max(1.0 - bend / 2, 0.5)
            if abs(step) * (bend * bend + (step / x) ** 2) <= 6e-17 * x:  # the error of Halley's step is its cube
                return following
        if not low < following < high:
            following = 0.5 * (low + high)
            if following in (low, high):
                return following
        x = following
    return x


def root(function: Callable[[float], float], low: float, high: float, at_low: float, at_high: float) -> float:
    """A zero in a bracket with a sign change (Chandrupatla 1997): inverse quadratic steps where safe, else halving."""
    a, b, c, fa, fb, fc = high, low, high, at_high, at_low, at_high
    share = 0.5
    for _ in range(200):
        x = a + share * (b - a)
        fx = function(x)
        if (fx > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            b, c, fb, fc = a, b, fa, fb
        a, fa = x, fx
        best, fbest = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        limit = 2.0**-53 * abs(best) / max(abs(b - a), 1e-320)
        if fbest == 0.0 or limit > 0.5:
            return best
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        share = 0.5
        if 1.0 - math.sqrt(1.0 - xi) < phi < math.sqrt(xi):
            share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        share = min(max(share, limit), 1.0 - limit)
    return best


def highest(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function with one hump is greatest, by golden section, or where it is first seen above zero."""
    share = (math.sqrt(5.0) - 1) / 2
    one, two = high - share * (high - low), low + share * (high - low)
    at_one, at_two = function(one), function(two)
    for _ in range(40):
        if max(at_one, at_two) > 0.0:
            break
        if at_one >= at_two:
            high, two, at_two = two, one, at_one
            one = high - share * (high - low)
            at_one = function(one)
        else:
            low, one, at_one = one, two, at_two
            two = low + share * (high - low)
            at_two = function(two)
    return one if at_one >= at_two else two
