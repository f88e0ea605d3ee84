"""Functions of slip, speed or time that are smooth between breaks, in ball arithmetic: laws, records, pulses."""

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from flint import arb, arb_series

from tests.support.oracle import exact as number

Function = Callable[[arb_series], arb_series]


class Pieces(NamedTuple):
    """A function that is smooth between breaks: its pieces before each break and after the last."""

    breaks: tuple[arb, ...]
    functions: tuple[Function, ...]

    def at(self, x: arb) -> int:
        """Return the piece that begins at a place or holds there."""
        return bisect_right(self.breaks, x)

    def on(self, x: arb) -> arb_series:
        """Around a place."""
        return self.functions[self.at(x)](arb_series([x, 1]))


def polynomial(start: arb, *coefficients: Any, argument: Function = lambda x: x) -> Function:
    """Return a polynomial in the growth of an argument since a place."""
    from_here = argument(arb_series([start]))[0]

    def value(x: arb_series) -> arb_series:
        past, found = argument(x) - from_here, arb_series([0])
        for c in reversed(coefficients):
            found = found * past + c
        return found

    return value if len(coefficients) > 1 else lambda x: arb_series([coefficients[0]])


def constant(value: Any = 0) -> Pieces:
    return Pieces((), (polynomial(arb(0), arb(value)),))


def cubics(x: Sequence[arb], y: Sequence[arb], level: bool) -> Iterator[tuple[arb, ...]]:
    """Monotone cubics (Fritsch and Carlson 1980; slopes: weighted harmonic means, Fritsch and Butland 1984).

    The slope at the start is zero, or the parabola's through three points, limited; at the end it is zero.
    """
    step = [b - a for a, b in pairwise(x)]
    secant = [(b - a) / h for (a, b), h in zip(pairwise(y), step, strict=True)]
    slope = [arb(0)] * len(x)
    for k, (left, right) in enumerate(pairwise(secant), 1):
        if left * right > 0:
            one, two = 2 * step[k] + step[k - 1], step[k] + 2 * step[k - 1]
            slope[k] = (one + two) / (one / left + two / right)
    if not level:
        slope[0] = secant[0]
        if len(x) > 2:
            slope[0] = ((2 * step[0] + step[1]) * secant[0] - step[0] * secant[1]) / (step[0] + step[1])
            if not slope[0] * secant[0] > 0:
                slope[0] = arb(0)
            elif secant[0] * secant[1] < 0 and abs(slope[0]) > 3 * abs(secant[0]):
                slope[0] = 3 * secant[0]
    for k, h in enumerate(step):  # Hermite's, by value and slope at both ends
        second = (3 * secant[k] - 2 * slope[k] - slope[k + 1]) / h
        third = (slope[k] + slope[k + 1] - 2 * secant[k]) / h**2
        yield y[k], slope[k], second, third


def lines(time: Sequence[float], values: Sequence[float], held: bool, factor: arb, scale: arb) -> Pieces:
    """Straight lines between samples, dimensionless; beyond them the end values, or zero."""
    t, y = [(number(t) / scale).mid() for t in time], [number(v) * factor for v in values]
    between = [polynomial(a, u, (v - u) / (b - a)) for (a, b), (u, v) in zip(pairwise(t), pairwise(y), strict=True)]
    ends = [polynomial(arb(0), v if held else arb(0)) for v in (y[0], y[-1])]
    return Pieces(tuple(t), (ends[0], *between, ends[1]))


def pulse(given: Mapping[str, Any], amplitude: float, scale: arb) -> Pieces:
    start = (number(given.get("start", 0.0)) / scale).mid()
    end = ((number(given.get("start", 0.0)) + number(given["duration"])) / scale).mid()
    top, length, none = number(amplitude), end - start, polynomial(arb(0), arb(0))
    if given["pulse"] == "rectangular":
        return Pieces((start, end), (none, polynomial(start, top), none))
    if given["pulse"] == "triangular":
        middle = (start + length / 2).mid()
        up, down = polynomial(start, arb(0), 2 * top / length), polynomial(middle, top, -2 * top / length)
        return Pieces((start, middle, end), (none, up, down, none))
    rate = arb.pi() * (1 if given["pulse"] == "half-sine" else 2 * number(given.get("cycles", 1.0))) / length
    return Pieces((start, end), (none, lambda t: ((t - start) * rate).sin() * top, none))


def law_of_slip(law: Any, radius: arb) -> Pieces:
    """Friction over slip/R."""
    if not isinstance(law, Mapping):
        return constant(number(law))
    if law["law"] == "constant":
        return constant(number(law["coefficient"]))
    if law["law"] == "tabulated":
        x, y = [number(s) / radius for s in law["slip"]], [number(v) for v in law["coefficient"]]
        made = [polynomial(a, *c) for a, c in zip(x, cubics(x, y, level=False), strict=False)]
        return Pieces(tuple(x[1:]), (*made, polynomial(arb(0), y[-1])))
    peak, residual, length = (number(law[n]) for n in ("peak", "residual", "length"))
    length = length / radius
    if law["law"] == "linear":
        falling = polynomial(arb(0), peak, (residual - peak) / length)
        return Pieces((length,), (falling, polynomial(arb(0), residual)))
    if law["law"] == "exponential":
        return Pieces((), (lambda s: (s * (-1 / length)).exp() * (peak - residual) + residual,))
    return Pieces((), (lambda s: arb_series([peak - residual]) / (s / length + 1) + residual,))


def law_of_speed(law: Mapping[str, Any], unit: arb) -> Pieces:
    """Friction over a dimensionless speed: given ones are over a unit."""
    if law["law"] == "rate_weakening":
        peak, residual, velocity = (number(law[n]) for n in ("peak", "residual", "velocity"))
        return Pieces((), (lambda v: residual + arb_series([peak - residual]) / (v * (unit / velocity) + 1),))
    speed, y = [number(v) / unit for v in law["speed"]], [number(v) for v in law["coefficient"]]
    made = cubics([v.log() for v in speed], y, level=True)
    between = [polynomial(v, *c, argument=arb_series.log) for v, c in zip(speed, made, strict=False)]
    return Pieces(tuple(speed), (polynomial(arb(0), y[0]), *between, polynomial(arb(0), y[-1])))
