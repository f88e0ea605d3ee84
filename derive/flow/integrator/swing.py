"""Complete phases of motion from rest, by the closed form of omega^2 as a function of the rotation.

Where forces depend on the rotation and on omega^2 alone, net = drive + sine sin(x) + vers (1 - cos(x)) + square omega^2
with constant factors. The equation of motion is then linear in E = omega^2, E' + q E = 2 (net - square E) with
q = -2 square, and E is a sum of four functions that neither cancel for small x nor divide by q:

    E = e0 x + e1 w + e2 (1 - cos(x)) + e3 (x - sin(x)),    w = (q x - 1 + exp(-q x))/q^2

`derive.algebra.phase_plane` derives the factors e, here and about the end of the motion, where x is counted backwards,
and proves that the functions of this module are this solution. The duration is an integral of dx/sqrt(E) over the angle
u with x = end sin(u)^2, in which both ends are regular, by the trapezoidal rule, whose error squares with each halving.

A phase is complete if the mass stays pressed on its slip surface, with its chord not upright, until it stops within
half a turn, and before its end time. All other phases are integrated in time.
"""

from math import factorial

from derive.flow.integrator.one_lane import (
    PLACES,
    SINES,
    WEIGHTS,
    Lanes,
    M,
    N,
    Passed,
    S,
    V,
    any_lane,
    down,
    minimum,
    new_series,
    number,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster
from derive.flow.integrator.roots import LAST_STEP, inside_or_middle
from derive.flow.integrator.step import on_standstill

PI = 3.141592653589793
FARTHEST = 3.14  # greatest rotation of a phase: net moment and normal force have two zeros in a turn
FADED = 2.0  # greatest q x, for which the series below are complete
LAST = 7  # of the terms of these series
VERSINE = tuple((-1) ** k / factorial(2 * k + 2) for k in range(LAST + 1))
LAG = tuple((-1) ** k / factorial(2 * k + 3) for k in range(LAST + 1))
FADING = tuple((-1) ** k / factorial(k + 2) for k in range(2 * LAST + 1))
LAST_OF_HALLEY = 2.0**-18  # relative step of Halley's method after which the next one would be below rounding
MOST_CORRECTIONS = 12  # of a root by Newton's method
CONVERGED = 2.0**-22  # change of the duration by the last halving, whose square is the error


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
        lag = 2.0 * (lag + sine * versine)
        versine = 2.0 * (sine * sine)
        h = 2.0 * h
    return lag, versine


def faded(y: V) -> V:
    """Return (y - 1 + exp(-y))/y^2, for 0 <= y <= 2, from a quarter of y, doubled twice."""
    h = 0.25 * y
    part: V = FADING[2 * LAST]
    for k in down(2 * LAST - 1, 0):
        part = part * h + FADING[k]
    for _ in up(1, 2):
        lost = 1.0 - h * part
        part = 0.5 * part + 0.25 * (lost * lost)
        h = 2.0 * h
    return part


def factors(e: S, drive: V, sine: V, vers: V, q: V) -> None:
    """Compute the factors of E, followed by q."""
    share = 2.0 / (1.0 + q * q)
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
    return e[0] * f[0] + (e[1] * f[1] + (e[2] * f[2] + e[3] * f[3]))


def slope_of(e: S, f: S) -> V:
    """Return the derivative of E."""
    sine = f[0] - f[3]
    lost = f[0] - e[4] * f[1]
    return e[0] + (e[1] * lost + (e[2] * sine + e[3] * f[2]))


def bend_of(e: S, f: S) -> V:
    """Return the second derivative of E."""
    sine = f[0] - f[3]
    cosine = 1.0 - f[2]
    lost = f[0] - e[4] * f[1]
    return e[1] * (1.0 - e[4] * lost) + (e[2] * cosine + e[3] * sine)


def mirror(back: S, drive: V, sine: V, vers: V, q: V, f: S) -> None:
    """Compute the factors of E about the end of a phase, from the four functions there."""
    sine_end = f[0] - f[3]
    cosine = 1.0 - f[2]
    at_end = drive + (sine * sine_end + vers * f[2])
    sine_back = sine * cosine + vers * sine_end
    vers_back = sine * sine_end - vers * cosine
    factors(back, -at_end, sine_back, vers_back, -q)


def reverse(f: S, q: V) -> None:
    """Replace the functions for q by those for -q."""
    y = q * f[0]
    faded_by = 1.0 - y + q * q * f[1]
    f[1] = (f[0] * f[0] - f[1] - y * f[1]) / faded_by


def end_of_swing(e: S, sine: V, which: M) -> V:
    """Return the first positive zero of E, by Halley's method on E/x, or a rotation beyond the farthest."""
    falls_by = 0.5 * (e[4] * e[0]) - sine
    x = e[0] / falls_by
    f = new_series()
    count: N = 0
    while any_lane(which) and count < MOST_CORRECTIONS:
        inside = x > 0.0 and x < FARTHEST
        x = where(inside, x, FARTHEST)
        functions(f, x, e[4])
        at = energy(e, f)
        falls = slope_of(e, f) * x - at
        bends = bend_of(e, f) * (x * x) - 2.0 * falls
        steepness = 2.0 * falls * falls - at * bends
        change = 2.0 * at * falls * x / steepness
        x = where(which, x - change, x)
        which = which and abs(change) > LAST_OF_HALLEY * x
        count = count + 1
    return where(which, 2.0 * FARTHEST, x)


def peak_of_swing(e: S, end: V, which: M) -> V:
    """Return the rotation of the greatest speed, by Newton's method on the derivative of E between rest and rest."""
    x = 0.5 * end
    f = new_series()
    low: V = 0.0
    high = end
    count: N = 0
    while any_lane(which) and count < 2 * MOST_CORRECTIONS:
        functions(f, x, e[4])
        slope = slope_of(e, f)
        low = where(slope > 0.0, x, low)
        high = where(slope > 0.0, high, x)
        following = x - slope / bend_of(e, f)
        following = inside_or_middle(following, low, high)
        change = abs(following - x)
        x = where(which, following, x)
        which = which and change > LAST_STEP * x
        count = count + 1
    return x


def stays_positive(start: V, sine: V, vers: V, f: S) -> M:
    """Return whether start + sine sin + vers (1 - cos) is positive and concave over a rotation up to half a turn.

    A sum of sines is concave between two such rotations if it is concave at both, and then positive if it is there.
    """
    sine_end = sine * (f[0] - f[3])
    at_end = start + (sine_end + vers * f[2])
    cosine = 1.0 - f[2]
    concave = vers <= 0.0 and vers * cosine <= sine_end
    return start > 0.0 and at_end > 0.0 and concave


def slowness(e: S, back: S, end: V, k: N) -> V:
    """Return the integrand of the duration at a node and at its mirror image, which is the same node from the end."""
    x = end * SINES[k]
    f = new_series()
    functions(f, x, e[4])
    room = x * (end - x)
    here = sqrt(room / energy(e, f))
    reverse(f, e[4])
    there = sqrt(room / energy(back, f))
    return here + there


def duration_of_swing(e: S, back: S, end: V, which: M) -> tuple[V, V]:
    """Return the duration of a phase, and the relative change by the last halving of intervals."""
    ends = sqrt(end / e[0])
    ends = ends + sqrt(end / back[0])
    total = 0.125 * (ends + slowness(e, back, end, 0))
    total = total + 0.25 * slowness(e, back, end, 1)
    change: V = 1.0
    changes = which
    first: N = 2
    while first < 16 and any_lane(changes):
        added: V = 0.0
        for k in up(first, 2 * first - 1):
            added = added + slowness(e, back, end, k)
        added = added / number(2 * first)
        relative = abs(added - total) / total
        change = where(changes, relative, change)
        total = where(changes, 0.5 * (total + added), total)
        changes = which and change > CONVERGED
        first = 2 * first
    return PI * total, change


def time_of_peak(e: S, peak: V) -> V:
    """Return the time from rest to a rotation, by Gauss's rule in the square root of the rotation."""
    total: V = 0.0
    f = new_series()
    for k in up(0, 11):
        functions(f, peak * PLACES[k], e[4])
        total = total + WEIGHTS[k] * sqrt(f[0] / energy(e, f))
    return 2.0 * sqrt(peak) * total


def finish(s: Lanes, here: M, end: V, duration: V, peak: V, before: V, speed: V, rate: V) -> None:
    """Bring lanes to the end of their phase. They reach the greatest speed at ``peak``, after the time ``before``."""
    keep_faster(s, here, speed, s.time + before, peak, rate)
    s.x = end
    s.omega = 0.0
    s.time = s.time + duration
    s.steps = s.steps + 1.0
    s.passed = number(Passed.NOTHING)
    if here:
        on_standstill(s)


def swing(s: Lanes, which: M) -> M:
    """Complete the phases that begin at rest and in contact, where they have a closed form, and return these lanes."""
    rests = s.x == 0.0 and s.omega == 0.0
    fits = which and rests and s.drive > 0.0 and s.lifted == 0.0
    if not any_lane(fits):
        return fits
    e = new_series()
    back = new_series()
    f = new_series()
    q = -2.0 * s.net_square
    factors(e, s.drive, s.net_sine, s.net_vers, q)
    end = end_of_swing(e, s.net_sine, fits)
    functions(f, minimum(end, FARTHEST), q)
    mirror(back, s.drive, s.net_sine, s.net_vers, q, f)
    fits = fits and end < FARTHEST and back[0] > 0.0
    fits = fits and q >= 0.0 and q * end < FADED
    fits = fits and s.normal_square >= 0.0
    fits = fits and stays_positive(s.normal_load, s.upright_sine, s.upright_vers, f)
    fits = fits and stays_positive(s.normal0, s.normal_sine, s.normal_vers, f)
    if any_lane(fits):
        duration, change = duration_of_swing(e, back, end, fits)
        fits = fits and change <= CONVERGED and s.time + duration < s.end_time
        if any_lane(fits):
            peak = peak_of_swing(e, end, fits)
            functions(f, peak, q)
            speed = sqrt(energy(e, f))
            finish(s, fits, end, duration, peak, time_of_peak(e, peak), speed, 0.5 * slope_of(e, f))
    return fits
