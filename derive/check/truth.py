"""The five kernels in ball arithmetic: Taylor models with rigorous remainders on [0, pi/2], from the closed forms.

Standard library and python-flint only: this belongs to the checker (`certify`), which trusts nothing of what
the generator computed. The closed forms are compared with quadrature of the raw definitions in the tests.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

from flint import arb, arb_poly, arb_series, ctx, fmpq_series

TOP = float.fromhex("0x1.921fb54442d18p+0")  # the double nearest to pi/2, and below it
TERMS = 36  # of every Taylor series; the term that follows bounds the remainder
BITS = 180
CUBE = 3  # every kernel is alpha**3 times a function that is analytic and not zero at 0

QUOTIENTS = {
    "dynamic_coefficient": ("polar_moment", "resistance_factor"),
    "weight_moment_per_inertia": ("weight_moment_amplitude", "moment_of_inertia"),
    "radial_weight_per_inertia": ("radial_weight_amplitude", "moment_of_inertia"),
    "polar_moment_per_inertia": ("polar_moment", "moment_of_inertia"),
    "weight_moment_per_radial_weight": ("weight_moment_amplitude", "radial_weight_amplitude"),
}
# What a kernel is of a, s = sin(a), c = cos(a) and h = artanh(s), for numbers and for series.
KERNELS = {
    "polar_moment": lambda a, s, c, h: (2 * a - s * c - c * c * c * h) / 3,
    "moment_of_inertia": lambda a, s, c, h: a / 2 - s * c / 3 - s * c * (c * c - s * s) / 6,
    "radial_weight_amplitude": lambda a, s, c, h: s - c * c * h,
    "weight_moment_amplitude": lambda a, s, c, h: 2 * s * s * s / 3,
    "resistance_factor": lambda a, s, c, h: 2 * a * (1 - c),
}


@contextmanager
def working(bits: int, terms: int = TERMS + 1) -> Iterator[None]:
    """Precision of balls and length of series; both are global in python-flint."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = bits, terms
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


def ball(lower: float | arb, upper: float | arb) -> arb:
    """The ball over [lower, upper]."""
    low, high = arb(lower), arb(upper)
    return arb((low + high) / 2, (high - low) / 2)


def value(name: str, alpha: arb) -> arb:
    """A kernel or a quotient at a ball 0 < alpha < pi/2, at the precision in force; it cancels near 0."""
    if name in QUOTIENTS:
        above, below = QUOTIENTS[name]
        return value(above, alpha) / value(below, alpha)
    s, c = alpha.sin_cos()
    return KERNELS[name](alpha, s, c, -((arb.pi() / 2 - alpha) / 2).tan().log())


def _taylor(name: str, centre: arb) -> list[arb]:
    """Taylor coefficients of a kernel, for every point of the ball ``centre`` at once."""
    a = arb_series([centre, 1])
    s, c = a.sin_cos()
    # artanh(sin a) = -ln tan((pi/2 - a)/2), and its derivative is 1/cos a.
    h = (1 / c).integral() - ((arb.pi() / 2 - centre) / 2).tan().log()
    return coefficients(KERNELS[name](a, s, c, h))


def coefficients(series: Any) -> list[arb]:
    """All TERMS + 1 coefficients of a series or of a constant, as balls."""
    if isinstance(series, arb):
        series = arb_series([series])
    found = [arb(series[k]) for k in range(TERMS + 1)]
    if not all(x.is_finite() for x in found):
        raise ArithmeticError("a Taylor series is not finite on this interval")
    return found


@cache
def _at_zero(name: str) -> list[arb]:
    """Exact Taylor coefficients at 0; that the first three vanish is checked in rational arithmetic."""
    a = fmpq_series([0, 1])
    s, c = a.sin(), a.cos()
    found = KERNELS[name](a, s, c, s.atanh())
    if any(found[k] != 0 for k in range(CUBE)) or found[CUBE] == 0:
        raise ArithmeticError(f"{name} is not of order alpha**{CUBE}")
    return [arb(found[k]) for k in range(TERMS + 1)]


@dataclass(frozen=True)
class Segment:
    """A part [lower, upper] of the domain, and the centre of its Taylor series; the first one's is 0."""

    lower: float
    upper: float

    @property
    def centre(self) -> float:
        middle = (self.lower + self.upper) / 2 if self.lower else 0.0
        return middle if middle < self.upper else self.lower  # next to the last double


@dataclass(frozen=True)
class Model:
    """f(centre + t) = main(t) + last(t) t**power, with last(t) in the ball ``last`` for all t of the segment."""

    main: arb_poly
    last: arb
    power: int

    @cached_property
    def slope(self) -> arb_poly:
        return self.main.derivative()

    def __call__(self, t: arb) -> arb:
        """Enclosure over the ball t, in mean-value form."""
        middle = t.mid()
        rest = arb(0, 1) * t.abs_upper() ** self.power if self.power else 1
        return self.main(middle) + self.slope(t) * (t - middle) + self.last * rest


def model(thin: list[arb], fat: list[arb], order: int = 0) -> Model:
    """Of a function over t**order, from its coefficients at the centre and over the whole segment (Lagrange)."""
    if any(not (x == 0) for x in thin[:order]):
        raise ArithmeticError(f"a series is not of order alpha**{order}")
    return Model(arb_poly(thin[order:TERMS]), fat[TERMS], TERMS - order)


def _segments() -> tuple[Segment, ...]:
    """[0, 1/4], then ever shorter towards the logarithm at pi/2: a fixed share of the distance to it; TOP alone."""
    found, at, last = [Segment(0.0, 0.25)], 0.25, math.nextafter(TOP, 0.0)
    while at < last:
        after = min(last, max(at + 0.27 * (TOP - at), math.nextafter(at, TOP)))
        found.append(Segment(at, after))
        at = after
    return (*found, Segment(TOP, TOP))


SEGMENTS = _segments()


@cache
def kernel(name: str, segment: Segment) -> Model:
    """Taylor model of a kernel on a segment; over alpha**3 on the first one."""
    with working(BITS):
        fat = _taylor(name, ball(segment.lower, segment.upper))
        if segment.lower == 0:
            return model(_at_zero(name), fat, CUBE)
        return model(_taylor(name, arb(segment.centre)), fat)
