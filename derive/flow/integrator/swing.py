"""Complete phases of motion from rest, by the closed form of omega^2 as a function of the rotation.

`energy` and `softening` have E = omega^2 under constant and under exponentially softening friction. Under constant
friction the duration is an integral of dx/sqrt(E) over the angle u with x = end sin(u)^2, in which both ends are
regular, by the trapezoidal rule, whose error squares with each halving.

A phase is complete if the mass stays pressed on its slip surface, with its chord not upright, until it stops within
half a turn, and before its end time. All other phases are integrated in time.
"""

from derive.flow.integrator.energy import bend_of, energy, factors, functions, mirror, reverse, slope_of
from derive.flow.integrator.one_lane import (
    INFINITY,
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
    minimum,
    new_series,
    number,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster
from derive.flow.integrator.roots import LAST_STEP, inside_or_middle
from derive.flow.integrator.softening import duration_of_softening, series_suffices, soften, softening_factors
from derive.flow.integrator.step import on_standstill

PI = 3.141592653589793
FARTHEST = 3.14  # greatest rotation of a phase: net moment and normal force have two zeros in a turn
FADED = 2.0  # greatest q x, for which the series of E are complete
LAST_OF_HALLEY = 2.0**-18  # relative step of Halley's method after which the next one would be below rounding
MOST_CORRECTIONS = 12  # of a root by Newton's method
CONVERGED = 2.0**-22  # change of the duration by the last halving, whose square is the error


def evaluate_at(s: Lanes, e: S, f: S, x: V) -> None:
    """Compute the functions of which E consists, and from place 5 on E and its first two derivatives."""
    if s.has.loss_rate:
        soften(s, e, f, x)
        return
    functions(f, x, e[4])
    f[5] = energy(e, f)
    f[6] = slope_of(e, f)
    f[7] = bend_of(e, f)


def end_of_swing(s: Lanes, e: S, sine: V, which: M) -> V:
    """Return the first positive zero of E, by Halley's method on E/x, or a rotation beyond the farthest."""
    falls_by = 0.5 * (e[4] * e[0]) - sine
    x = e[0] / falls_by
    f = new_series()
    count: N = 0
    while any_lane(which) and count < MOST_CORRECTIONS:
        inside = x > 0.0 and x < FARTHEST
        x = where(inside, x, FARTHEST)
        evaluate_at(s, e, f, x)
        at = f[5]
        falls = f[6] * x - at
        bends = f[7] * (x * x) - 2.0 * falls
        steepness = 2.0 * falls * falls - at * bends
        change = 2.0 * at * falls * x / steepness
        x = where(which, x - change, x)
        which = which and abs(change) > LAST_OF_HALLEY * x
        count = count + 1
    return where(which, 2.0 * FARTHEST, x)


def peak_of_swing(s: Lanes, e: S, end: V, which: M) -> V:
    """Return the rotation of the greatest speed, by Newton's method on the derivative of E between rest and rest."""
    x = 0.5 * end
    f = new_series()
    low: V = 0.0
    high = end
    count: N = 0
    while any_lane(which) and count < 2 * MOST_CORRECTIONS:
        evaluate_at(s, e, f, x)
        slope = f[6]
        low = where(slope > 0.0, x, low)
        high = where(slope > 0.0, high, x)
        following = x - slope / f[7]
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


def times_of_swing(s: Lanes, e: S, back: S, end: V, peak: V, which: M) -> tuple[V, V]:
    """Return the times from rest to the greatest speed and to the end, infinite if it is uncertain."""
    if s.has.loss_rate:
        return duration_of_softening(s, e, end, peak)
    duration, change = duration_of_swing(e, back, end, which)
    return time_of_peak(e, peak), where(change <= CONVERGED, duration, INFINITY)


def finish(s: Lanes, here: M, e: S, end: V, duration: V, peak: V, before: V) -> None:
    """Bring lanes to the end of their phase. They reach the greatest speed at ``peak``, after the time ``before``."""
    f = new_series()
    evaluate_at(s, e, f, peak)
    keep_faster(s, here, sqrt(f[5]), s.time + before, peak, 0.5 * f[6])
    s.x = end
    s.omega = 0.0
    s.time = s.time + duration
    s.steps = s.steps + 1.0
    s.passed = number(Passed.NOTHING)
    if here:
        on_standstill(s)


def swing(s: Lanes, which: M) -> M:
    """Complete the phases that begin at rest and in contact, where they have a closed form, and return these lanes."""
    fits = which and s.x == 0.0 and s.omega == 0.0 and s.drive > 0.0 and s.lifted == 0.0
    if not any_lane(fits):
        return fits
    softens: N = s.has.loss_rate
    e = new_series()
    back = new_series()
    f = new_series()
    sine = s.net_sine
    if softens:
        softening_factors(s, e)
        fits = fits and series_suffices(s, e)
        sine = s.net_sine - s.net_loss_sine
    if not softens:
        factors(e, s.drive, sine, s.net_vers, -2.0 * s.net_square)
    q = e[4]
    end = end_of_swing(s, e, sine, fits)
    functions(f, minimum(end, FARTHEST), q)
    if not softens:
        mirror(back, s.drive, sine, s.net_vers, q, f)
        fits = fits and back[0] > 0.0
    fits = (
        fits
        and end < FARTHEST
        and q >= 0.0
        and q * end < FADED
        and s.normal_square >= 0.0
        and stays_positive(s.normal_load, s.upright_sine, s.upright_vers, f)
        and stays_positive(s.normal0, s.normal_sine, s.normal_vers, f)
    )
    if any_lane(fits):
        peak = peak_of_swing(s, e, end, fits)
        before, duration = times_of_swing(s, e, back, end, peak, fits)
        fits = fits and s.time + duration < s.end_time
        if any_lane(fits):
            finish(s, fits, e, end, duration, peak, before)
    return fits
