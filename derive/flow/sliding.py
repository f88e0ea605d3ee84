"""Proof that the integrator passes a piece of a record by the derived motion of a frozen or of a turning mass."""

from types import SimpleNamespace
from typing import Any

from sympy import Add, Catalan, EulerGamma, Expr, Rational, cos, nsimplify, pi, sin, symbols

from derive.algebra import phase_plane, pieces
from derive.algebra.prove import prove_rational, prove_zero
from derive.flow.integrator import records, shaken
from derive.flow.layout import STRIDE

length, now, behind = symbols("length now behind", positive=True)
# Constants in place of symbols, by which SymPy decides comparisons. The proof is for any numbers in their place.
UNITS = (pi, EulerGamma, Catalan)
# Speed and net moment at the start of a piece, and net moment at its end, as multiples of these constants.
CASES = """
1   3   3  speeds up
2  -3  -3  slows down
2   8  -3  passes a peak
1 -10   3  dips
1  -6  -9  stops
1 -20  -3  stops while its net moment rises
1   3 -20  stops after a peak
1 -30   9  stops and starts
0  -5   1  starts
0   3   5  starts at once
0   9  -3  starts and passes a peak
0   3  -9  starts and stops
"""


def _slide(speed: Any, net: Any, rise: Any, left: Any) -> tuple[Any, Any, Any]:
    """Return the speed at a standstill or after the time that is left, the path, and the time of the standstill."""
    numbers = {pieces.omega: speed, pieces.net: net, pieces.rise: rise}
    _, stops = pieces.roots()
    roots = [stop.subs(numbers) for stop in stops]
    inside = [root for root in roots if root.is_real and 0 < root < left]
    time = min(inside, default=left)
    end, path = (form.subs(pieces.time, time).subs(numbers) for form in pieces.motion())
    if inside:
        return 0, path, time
    return end, path, None


def _follow(speed: Any, net: Any, after: Any) -> list[Any]:
    """Return the speed at the end of a piece, its path, and the last standstill, by the derived motion."""
    rise = after - net
    path = 0
    stop = None
    rest = 0
    if speed > 0 or net > 0:
        speed, path, stop = _slide(speed, net, rise, 1)
    if stop is not None:
        rest = now + length * stop
    if speed == 0 and net < 0 < after:
        level, _ = pieces.roots()
        speed, further, _ = _slide(0, 0, rise, 1 - level.subs({pieces.net: net, pieces.rise: rise}))
        path += further
    return [speed, path, rest]


def _peak(speed: Any, net: Any, after: Any) -> list[Any]:
    """Return the greatest speed in a piece, its time and its place, by the derived motion."""
    numbers = {pieces.omega: speed, pieces.net: net, pieces.rise: after - net}
    level, _ = pieces.roots()
    top, way = (form.subs(pieces.time, level).subs(numbers) for form in pieces.motion())
    return [top, now + length * level.subs(numbers), behind + length * way]


def _turn(moments: list[Any], rise: list[Any], square: Any) -> list[Expr]:
    """Return rotation, speed, net moment, sine and 1 - cosine of a turning mass as polynomials of the time."""
    x, omega, net, sine, versine = every = [[0] * STRIDE for _ in range(5)]
    s = SimpleNamespace(x=0, omega=Rational(2, 7), sine_x=Rational(3, 7), versine_x=Rational(4, 7), net_square=square)
    s.inverse = [0, *(Rational(1, k) for k in range(1, STRIDE))]
    s.series = SimpleNamespace(x=x, omega=omega, net=net)
    shaken.expand_piece(s, moments, rise, sine, versine)
    return [Add(*(c * pieces.time**k for k, c in enumerate(of))) for of in every]


def _prove_series() -> None:
    """Prove that the series of a turning mass satisfy the equation of motion to their order, for rational numbers."""
    *numbers, square = (Rational(k, 5) for k in range(2, 9))
    moments, rise = numbers[:3], numbers[3:]
    rotation, speed, _, sine, versine = _turn(moments, rise, square)
    linear = (a + b * pieces.time for a, b in zip(moments, rise, strict=True))
    given = dict(zip((phase_plane.drive, phase_plane.sine, phase_plane.vers), linear, strict=True))
    given |= {sin(phase_plane.x): sine, cos(phase_plane.x): 1 - versine}
    rates = {
        rotation: speed,
        speed: phase_plane.NET.subs(given) + square * speed**2,
        sine: (1 - versine) * speed,
        versine: sine * speed,
    }
    for state, rate in rates.items():
        missing = (state.diff(pieces.time) - rate).expand()
        for k in range(shaken.TOP):
            prove_zero(missing.coeff(pieces.time, k), f"coefficient {k} of a turning mass in a piece")


def prove() -> str:
    """Prove speed, path, standstill and peak in every kind of piece, and the series of a turning mass."""
    _prove_series()
    names = ("speed", "path", "standstill", "peak", "time of the peak", "place of the peak")
    cells = (
        "rest_since",
        "peak_omega",
        "peak_time",
        "peak_rotation",
        "peak_rate",
        "rotation",
        "time",
        "phases",
        "turns",
    )
    of_units = dict(zip(UNITS, symbols("w a b", positive=True), strict=True))
    rows = CASES.strip().splitlines()
    for row in rows:
        *multiples, case = row.split(maxsplit=3)
        speed, net, after = (int(factor) * unit for factor, unit in zip(multiples, UNITS, strict=True))
        s = SimpleNamespace(**dict.fromkeys(cells, 0.0))
        s.direction = s.last_way = 1.0
        end, path = records.pass_piece(s, True, now, length, behind, speed, net, after)
        found = (end, path, s.rest_since, s.peak_omega, s.peak_time, s.peak_rotation)
        expected = _follow(speed, net, after)
        if net > 0 > after:
            expected += _peak(speed, net, after)
        for name, value, derived in zip(names, found, expected, strict=False):
            prove_rational(
                (nsimplify(value, rational=True) - derived).xreplace(of_units),
                f"{name} in a piece in which a mass {case}",
            )
    return f"speed, path, standstill and peak in {len(rows)} kinds of pieces, and {shaken.TOP} orders of a turning mass"
