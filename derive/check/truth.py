"""Exact functions in ball arithmetic: Taylor models with rigorous remainders on [0, pi/2], from the definitions.

Part of the checker (`certify`), which is independent of the generator: standard library and python-flint only. A
certificate defines its kernel by one statement, or by two statements for a quotient::

    r^2          the integral of r^2 dr du over the mass, cos(alpha)/cos(u) <= r <= 1, -alpha <= u <= alpha
    r^2 cos u    the integral of r^2 cos(u) dr du
    2 alpha f    (3.14): twice alpha times the depth of the chord f = 1 - cos(alpha) (2.12)

With T_k = cos(alpha)^k int_0^alpha du/cos(u)^k the inner integral gives, for r^n and for r^n cos u,

    2/(n + 1) (alpha - T_(n+1))    and    2/(n + 1) (sin(alpha) - cos(alpha) T_n),

and by parts (k - 1) T_k = sin(alpha) cos(alpha) + (k - 2) cos(alpha)^2 T_(k-2), from T_0 = alpha and
T_1 = cos(alpha) artanh(sin(alpha)).
"""

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, reduce
from operator import truediv
from typing import Any

from flint import arb, arb_poly, arb_series, ctx, fmpq, fmpq_series

TOP = float.fromhex("0x1.921fb54442d18p+0")  # the double nearest to pi/2, and below it
TERMS = 36  # terms of every Taylor series; the following term bounds the remainder
BITS = 180
CUBE = 3  # every base quantity is alpha**3 times a function that is analytic and not zero at 0
LEVER = "2 alpha f"
WEIGHT = re.compile(r"r\^(\d+)( cos u)?")

Balls = list[arb]
Definition = Sequence[str]  # one statement, or the statements of numerator and denominator


def exactly(statement: str, a: Any, s: Any, c: Any, h: Any) -> Any:
    """Return a base quantity from a = alpha, s = sin(a), c = cos(a) and h = artanh(s), as numbers or series."""
    if statement == LEVER:
        return 2 * a * (1 - c)
    match = WEIGHT.fullmatch(statement)
    if not match:
        raise ValueError(f"no definition reads {statement!r}")
    power = int(match[1])
    turned = bool(match[2])
    term = folded(power if turned else power + 1, a, s, c, h)
    return (s - c * term if turned else a - term) * fmpq(2, power + 1)


def folded(order: int, a: Any, s: Any, c: Any, h: Any) -> Any:
    """Return T_order from the arguments of `exactly`."""
    depth, term = (1, c * h) if order % 2 else (0, a)
    while depth < order:
        depth += 2
        term = (s * c + (depth - 2) * c * c * term) / (depth - 1)
    return term


@contextmanager
def working(bits: int, terms: int = TERMS + 1) -> Iterator[None]:
    """Set the precision of balls and the length of series, which are global in python-flint, within a context."""
    before = ctx.prec, ctx.cap
    ctx.prec = bits
    ctx.cap = terms
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


def as_ball(x: float | Fraction) -> arb:
    """Return the number itself, or a ball around it at the current precision."""
    return arb(fmpq(*Fraction(x).as_integer_ratio()))


def fraction(x: arb) -> Fraction:
    """Return the value of a ball of radius 0."""
    exact = x.fmpq()
    return Fraction(int(exact.p), int(exact.q))


def ball(lower: float | arb, upper: float | arb) -> arb:
    """Return the ball over [lower, upper]."""
    low = arb(lower)
    high = arb(upper)
    return arb((low + high) / 2, (high - low) / 2)


def artanh_of_sine(alpha: Any) -> Any:
    """Return artanh(sin(alpha)) of a ball as -ln(tan((pi/2 - alpha)/2))."""
    return -((arb.pi() / 2 - alpha) / 2).tan().log()


def enclosure(definition: Definition, alpha: arb) -> arb:
    """Return a definition on a ball 0 < alpha < pi/2 at the current precision. It cancels near 0."""
    s, c = alpha.sin_cos()
    h = artanh_of_sine(alpha)
    return reduce(truediv, (exactly(statement, alpha, s, c, h) for statement in definition))


def half_disc_limit(definition: Definition) -> arb:
    """Return a definition at pi/2, where the factor of the logarithm vanishes."""
    half_pi = arb.pi() / 2
    values = (exactly(statement, half_pi, arb(1), arb(0), arb(0)) for statement in definition)
    return reduce(truediv, values)


def _taylor(statement: str, centre: arb) -> Balls:
    """Return Taylor coefficients of a base quantity for every point of the ball ``centre`` at once."""
    a = arb_series([centre, 1])
    s, c = a.sin_cos()
    h = (1 / c).integral() + artanh_of_sine(centre)  # the derivative of artanh(sin a) is 1/cos a
    return coefficients(exactly(statement, a, s, c, h))


def coefficients(series: Any) -> Balls:
    """Return all TERMS + 1 coefficients of a series, as balls."""
    taylor = [arb(series[k]) for k in range(TERMS + 1)]
    if not all(x.is_finite() for x in taylor):
        raise ArithmeticError("a Taylor series is not finite on this interval")
    return taylor


@cache
def taylor_at_zero(statement: str) -> list[fmpq]:
    """Return exact Taylor coefficients at 0, after checking in rational arithmetic that the first three vanish."""
    with working(BITS):
        a = fmpq_series([0, 1])
        s = a.sin()
        series = exactly(statement, a, s, a.cos(), s.atanh())
        taylor = [series[k] for k in range(TERMS + 1)]
    if any(x != 0 for x in taylor[:CUBE]) or taylor[CUBE] == 0:
        raise ArithmeticError(f"{statement} is not of order alpha**{CUBE}")
    return taylor


@dataclass(frozen=True)
class Segment:
    """Part [lower, upper] of the domain, and the centre of its Taylor series, which is 0 for the first segment."""

    lower: float
    upper: float

    @property
    def centre(self) -> float:
        """Centre of the Taylor series."""
        middle = (self.lower + self.upper) / 2 if self.lower else 0.0
        return middle if middle < self.upper else self.lower  # near the last double


@dataclass(frozen=True)
class Model:
    """Taylor model f(centre + t) = main(t) + last(t) t**power, with last(t) in the ball ``last`` on the segment."""

    main: arb_poly
    last: arb
    power: int

    def __call__(self, t: arb) -> arb:
        """Return an enclosure over the ball t from the Taylor coefficients at its middle."""
        middle = t.mid()
        main = self.main(arb_poly([middle, 1]))(t - middle)
        return main + self.last * (arb(0, 1) * t.abs_upper() ** self.power if self.power else 1)


def model(thin: Balls, fat: Balls, order: int = 0) -> Model:
    """Return the Taylor model of f/t**order from coefficients of f at the centre and over the segment (Lagrange)."""
    if any(not (x == 0) for x in thin[:order]):
        raise ArithmeticError(f"a series is not of order alpha**{order}")
    return Model(arb_poly(thin[order:TERMS]), fat[TERMS], TERMS - order)


def _segments() -> tuple[Segment, ...]:
    """Return [0, 1/4], segments whose length is a fixed fraction of the distance to pi/2, and TOP."""
    segments = [Segment(0.0, 0.25)]
    lower = 0.25
    last = math.nextafter(TOP, 0.0)
    while lower < last:
        upper = max(lower + 0.27 * (TOP - lower), math.nextafter(lower, TOP))
        upper = min(upper, last)
        segments.append(Segment(lower, upper))
        lower = upper
    return (*segments, Segment(TOP, TOP))


SEGMENTS = _segments()


@cache
def kernel_model(statement: str, segment: Segment) -> Model:
    """Return the Taylor model of a base quantity on a segment, divided by alpha**3 on the first segment."""
    with working(BITS):
        fat = _taylor(statement, ball(segment.lower, segment.upper))
        if segment.lower == 0:
            return model([arb(x) for x in taylor_at_zero(statement)], fat, CUBE)
        return model(_taylor(statement, arb(segment.centre)), fat)
