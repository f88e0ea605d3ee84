"""E = omega^2 of a phase from rest as a function of the rotation x since it began, in closed form.

Where forces depend on the rotation and on omega^2 alone, net = drive + sine sin(x) + vers (1 - cos(x)) + square omega^2
with constant factors. The equation of motion is then linear in E = omega^2, E' + q E = 2 (net - square E) with
q = -2 square, and E is a sum of four functions that neither cancel for small x nor divide by q:

    E = e0 x + e1 w + e2 (1 - cos(x)) + e3 (x - sin(x)),    w = (q x - 1 + exp(-q x))/q^2

`derive.algebra.phase_plane` derives the factors e, here and about the end of the motion, where x is counted backwards,
and proves that the functions of this module are this solution.
"""

from math import factorial

from derive.flow.integrator.one_lane import N, S, V, down, up

LAST = 7  # of the terms of these series
VERSINE = tuple((-1) ** k / factorial(2 * k + 2) for k in range(LAST + 1))
LAG = tuple((-1) ** k / factorial(2 * k + 3) for k in range(LAST + 1))
FADING = tuple((-1) ** k / factorial(k + 2) for k in range(2 * LAST + 1))


def turned(x: V) -> tuple[V, V]:
    """Return x - sin(x) and 1 - cos(x), for |x| <= pi, from a quarter of the angle, doubled twice."""
    h = 0.25 * x
    square = h * h
    lag: V = LAG[LAST]
    versine: V = VERSINE[LAST]
    for k in down(LAST - 1, 0):
        lag = lag * square + LAG[k]
        versine = versine * square + VERSINE[k]
    lag = lag * square * h
    versine = versine * square
    for _ in up(1, 2):
        sine = h - lag
        change = sine * versine
        lag = 2.0 * (lag + change)
        versine = 2.0 * (sine * sine)
        h = 2.0 * h
    return lag, versine


def faded(y: V) -> V:
    """Return (y - 1 + exp(-y))/y^2, for 0 <= y <= 2, from a quarter of y, doubled twice."""
    h = 0.25 * y
    square = h * h
    even: V = FADING[2 * LAST]
    odd: V = FADING[2 * LAST - 1]
    for k in down(LAST - 1, 1):
        even = even * square + FADING[2 * k]
        odd = odd * square + FADING[2 * k - 1]
    part = (FADING[0] + h * odd) + square * even
    for _ in up(1, 2):
        lost = 1.0 - h * part
        part = 0.5 * part + 0.25 * lost * lost
        h = 2.0 * h
    return part


def factors(e: S, drive: V, sine: V, vers: V, q: V) -> None:
    """Compute the factors of E, followed by q."""
    square = q * q
    share = 2.0 / (1.0 + square)
    e[0] = 2.0 * drive
    e[3] = share * (vers - sine * q)
    e[2] = share * (sine + vers * q)
    e[1] = -q * (e[3] + e[0])
    e[4] = q


def functions(f: S, x: V, q: V) -> None:
    """Compute the four functions of which E is the sum."""
    lag, versine = turned(x)
    f[0] = x
    f[1] = x * x * faded(q * x)
    f[2] = versine
    f[3] = lag


def energy(e: S, f: S) -> V:
    """Return E from its factors and its functions."""
    faded_part = e[1] * f[1]
    turned_part = e[2] * f[2] + e[3] * f[3]
    return e[0] * f[0] + (faded_part + turned_part)


def force_at(start: V, sine: V, vers: V, f: S) -> V:
    """Return start + sine sin + vers (1 - cos) at the rotation at which ``f`` has the functions of E."""
    sine_there = sine * (f[0] - f[3])
    return start + (sine_there + vers * f[2])


def look_back(back: S, first: N, drive: V, sine: V, vers: V, f: S) -> None:
    """Compute drive, sine and vers of the negative moment as a function of the distance from the end of a phase.

    They are stored from place ``first`` on; ``f`` are the four functions at the end.
    """
    sine_end = f[0] - f[3]
    cosine = 1.0 - f[2]
    change = sine * sine_end + vers * f[2]
    back[first] = -(drive + change)
    back[first + 1] = sine * cosine + vers * sine_end
    back[first + 2] = sine * sine_end - vers * cosine


def mirror(back: S, drive: V, sine: V, vers: V, q: V, f: S) -> None:
    """Compute the factors of E about the end of a phase, from the four functions there."""
    look_back(back, 0, drive, sine, vers, f)
    factors(back, back[0], back[1], back[2], -q)


def reverse(f: S, q: V) -> None:
    """Replace the functions for q by those for -q."""
    y = q * f[0]
    bend = q * q * f[1]
    faded_by = 1.0 - y + bend
    square = f[0] * f[0]
    rest = square - f[1] - y * f[1]
    f[1] = rest / faded_by
