"""Complete phases of motion from rest, by the closed form of omega^2 as a function of the rotation.

`energy` and `softening` have E = omega^2 under constant and under exponentially softening friction. Under constant
friction the duration is an integral of dx/sqrt(E) over the angle u with x = end sin(u)^2, in which both ends are
regular, by the trapezoidal rule, whose error squares with each halving.

A phase is complete if the mass stays pressed on its slip surface, with its chord not upright, until it stops within
half a turn. Under constant friction it may end earlier, at the end time, and have output times; otherwise such phases
are integrated in time, like all others.
"""

from derive.flow.integrator.energy import energy, factors, force_at, functions, mirror, reverse
from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    SINES,
    Lanes,
    M,
    N,
    Passed,
    S,
    Status,
    V,
    any_lane,
    minimum,
    new_series,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster, stick
from derive.flow.integrator.roots import inside_or_middle
from derive.flow.integrator.rotation import FINEST
from derive.flow.integrator.softening import (
    duration_of_softening,
    evaluate_at,
    series_suffices,
    softening_factors,
    softening_functions,
)
from derive.flow.integrator.step import end_motion, on_standstill
from derive.flow.integrator.waves import (
    ANGLE_THERE,
    LAST_OF_NEWTON,
    LONG,
    MOST_CORRECTIONS,
    OMEGA_THERE,
    PI,
    RATE_THERE,
    find_state,
    find_waves,
    is_uneven,
    keep_samples,
    time_to,
)

FARTHEST = 3.14  # greatest rotation of a phase: net moment and normal force have two zeros in a turn
FADED = 2.0  # greatest q x, for which the series of E are complete
LAST_OF_HALLEY = 2.0**-18  # relative step of Halley's method after which the next one would be below rounding
CLEAR = 0.01  # excess of resistance over the driving moment, relative to their terms, that is no matter of rounding
CLOSE_TO_REST = 2.0**-40  # an end time that is closer to the standstill, relatively, is left to the integration in time
LEAST_DURATION = 1.5  # of a phase over the time that its path takes at the greatest speed; pi/2 if E is a parabola
NEAR_MIDDLE = 0.85  # distance of the peak from the middle over half of the way, for which the arcsine is complete


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


def peak_of_cubic(rise: V, fall: V, end: V) -> V:
    """Return the rotation of the greatest speed if E is a cubic with these slopes at both of its zeros."""
    square = rise * rise + fall * (fall - rise)
    falls_by = 2.0 * rise - fall + sqrt(square)
    return end * rise / falls_by


def peak_of_swing(s: Lanes, e: S, f: S, x: V, end: V, which: M) -> V:
    """Return the rotation of the greatest speed, by Halley's method on the derivative of E from a rotation ``x`` on.

    Places 9 and 10 of ``f`` have E and its derivative there.
    """
    low: V = 0.0
    high = end
    count: N = 0
    while any_lane(which) and count < 2 * MOST_CORRECTIONS:
        evaluate_at(s, e, f, x)
        slope = f[6]
        low = where(slope > 0.0, x, low)
        high = where(slope > 0.0, high, x)
        twice = 2.0 * f[7]
        following = x - slope * twice / (twice * f[7] - slope * f[8])
        following = inside_or_middle(following, low, high)
        change = following - x
        bend = f[7] * change
        f[9] = where(which, f[5] + change * (slope + 0.5 * bend), f[9])
        f[10] = where(which, slope + bend, f[10])
        x = where(which, following, x)
        which = which and abs(change) > LAST_OF_NEWTON * x
        count = count + 1
    return x


def stays_positive(start: V, sine: V, vers: V, f: S) -> M:
    """Return whether start + sine sin + vers (1 - cos) is positive and concave over a rotation up to half a turn.

    A sum of sines is concave between two such rotations if it is concave at both, and then positive if it is there.
    """
    at_end = force_at(start, sine, vers, f)
    cosine = 1.0 - f[2]
    change = sine * (f[0] - f[3])
    concave = vers <= 0.0 and vers * cosine <= change
    return start > 0.0 and at_end > 0.0 and concave


def has_closed_form(s: Lanes, f: S, q: V) -> M:
    """Return whether phases up to a rotation have the closed form, from the functions of E there."""
    end = f[0]
    near = end < FARTHEST and q >= 0.0 and q * end < FADED
    upright = stays_positive(s.normal_load, s.upright_sine, s.upright_vers, f)
    pressed = stays_positive(s.normal0, s.normal_sine, s.normal_vers, f)
    return near and s.normal_square >= 0.0 and upright and pressed


def add_node(e: S, back: S, end: V, both: S, odd: S, k: N) -> None:
    """Compute sum and difference of the integrand at a node and at its mirror image, the same node from the end."""
    x = end * SINES[k]
    f = new_series()
    functions(f, x, e[4])
    left = end - x
    room = x * left
    near = sqrt(room / energy(e, f))
    reverse(f, e[4])
    far = sqrt(room / energy(back, f))
    both[k] = near + far
    odd[k] = near - far


def duration_of_swing(e: S, back: S, end: V, w: S, which: M) -> V:
    """Return the time from rest to rest, infinite if it is uncertain, and compute the time as a series in ``w``."""
    both = new_series()
    odd = new_series()
    near = sqrt(end / e[0])
    far = sqrt(end / back[0])
    both[0] = near + far
    odd[0] = near - far
    for k in up(1, 4):
        add_node(e, back, end, both, odd, 2 * k)
    for m in up(0, LONG):
        w[m] = 0.0
    find_waves(w, which, both, odd, 4, 2)
    unsure = which and is_uneven(w, 8)
    if any_lane(unsure):
        for k in up(1, 4):
            add_node(e, back, end, both, odd, 2 * k - 1)
        find_waves(w, unsure, both, odd, 8, 1)
        w[LONG] = where(unsure, 1.0, 0.0)
        unsure = unsure and is_uneven(w, 16)
    return where(unsure, INFINITY, PI * w[0])


def rest(s: Lanes, here: M, rate: V, lost: V, f: S) -> None:
    """Let masses at a standstill stick, without the numbers of another phase, if they clearly do not turn back.

    ``rate`` is the net moment in the direction in which they arrived, ``lost`` the resistance that friction has lost,
    and ``f`` has the functions of E at the end of the phase.
    """
    force = force_at(s.normal0, s.normal_sine, s.normal_vers, f)
    resistance = s.resisting + s.mu * force - lost
    driving = rate + resistance
    terms = abs(driving) + resistance + abs(lost)
    excess = driving + resistance
    free = s.one_way == 0.0 and s.first_only == 0.0
    clear = excess > CLEAR * terms
    here = here and free and clear
    margin = excess / (EPS * terms)
    s.close = minimum(s.close, margin)
    stick(s, here)


def rest_softened(s: Lanes, here: M, f: S) -> None:
    """Let masses stick at the end of a phase in which friction has softened, if they clearly do not turn back."""
    lost = f[4] * force_at(s.net_loss, s.net_loss_sine, s.net_loss_vers, f)
    rate = lost + force_at(s.drive, s.net_sine, s.net_vers, f)
    rest(s, here, rate, lost, f)


def pass_peak(s: Lanes, here: M, f: S, peak: V, before: V) -> None:
    """Record the greatest speed, which lanes reach after the time ``before``.

    ``f`` is that of `peak_of_swing`, which returned the rotation ``peak``.
    """
    speed = sqrt(f[9])
    then = s.time + before
    keep_faster(s, here, speed, then, peak, 0.5 * f[10])


def finish(s: Lanes, here: M, end: V, duration: V) -> None:
    """Bring lanes to rest at the end of their phase."""
    s.x = end
    s.omega = 0.0
    s.time = s.time + duration
    s.steps = s.steps + 1.0
    s.passed = Passed.NOTHING
    on_standstill(s, here)


def end_within(s: Lanes, here: M, e: S, back: S, w: S, end: V) -> None:
    """End lanes at their end time within a phase."""
    there = new_series()
    time = s.end_time - s.time
    there[ANGLE_THERE] = 0.5 * time / w[0]
    find_state(s, there, here, e, back, w, end, time)
    s.x = there[0]
    s.omega = there[OMEGA_THERE]
    rate = there[RATE_THERE]
    s.time = s.end_time
    s.steps = 0.0
    keep_faster(s, here, s.omega, s.time, s.x, rate)
    end_motion(s, here, rate, Status.ENDED)


def complete_swing(s: Lanes, fits: M, e: S, back: S, f: S, at_peak: S, end: V, peak: V) -> M:
    """Complete phases under constant friction, up to rest or the end time, and return these lanes.

    ``f`` has the functions of E at the end of the phase, and ``at_peak`` is that of `peak_of_swing`.
    """
    w = new_series()
    off_middle = abs(2.0 * peak - end)
    fits = fits and off_middle < NEAR_MIDDLE * end
    duration = duration_of_swing(e, back, end, w, fits)
    before = time_to(w, peak, end)
    until = s.time + duration
    rests = fits and until < s.end_time
    ends = fits and until < INFINITY and until > s.end_time * (1.0 + CLOSE_TO_REST)
    if s.samples:
        keep_samples(s, rests or ends, e, back, w, end, until)
    pass_peak(s, rests or (ends and s.time + before < s.end_time), at_peak, peak, before)
    finish(s, rests, end, duration)
    rest(s, rests, -0.5 * back[0], 0.0, f)
    end_within(s, ends, e, back, w, end)
    return rests or ends


def complete_softening(s: Lanes, fits: M, e: S, f: S, at_peak: S, end: V, peak: V) -> M:
    """Complete phases under softening laws, up to rest before the end time, and return these lanes.

    Lanes that hardly come to rest before the end time are left at once. ``f`` and ``at_peak`` are those of
    `complete_swing`.
    """
    least = LEAST_DURATION * end / sqrt(at_peak[9])
    fits = fits and s.time + least < s.end_time
    if not any_lane(fits):
        return fits
    fine: N = s.highest > FINEST
    before, duration = duration_of_softening(s, e, f, end, peak, fine)
    unsure = fits and duration == INFINITY
    if not fine and any_lane(unsure):
        sooner, sure = duration_of_softening(s, e, f, end, peak, 1)
        before = where(unsure, sooner, before)
        duration = where(unsure, sure, duration)
    fits = fits and s.time + duration < s.end_time
    pass_peak(s, fits, at_peak, peak, before)
    finish(s, fits, end, duration)
    rest_softened(s, fits, f)
    return fits


def swing(s: Lanes, which: M) -> M:
    """Complete the phases that begin at rest and in contact, where they have a closed form, and return these lanes."""
    rests = s.x == 0.0 and s.omega == 0.0
    fits = which and rests and s.drive > 0.0 and s.lifted == 0.0
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
    farthest = minimum(end, FARTHEST)
    peak = 0.5 * end
    if softens:
        softening_functions(s, e, f, farthest)
    if not softens:
        functions(f, farthest, q)
        mirror(back, s.drive, sine, s.net_vers, q, f)
        peak = peak_of_cubic(e[0], back[0], end)
        fits = fits and back[0] > 0.0
    fits = fits and has_closed_form(s, f, q)
    if not any_lane(fits):
        return fits
    at_peak = new_series()
    peak = peak_of_swing(s, e, at_peak, peak, end, fits)
    if softens:
        return complete_softening(s, fits, e, f, at_peak, end, peak)
    return complete_swing(s, fits, e, back, f, at_peak, end, peak)
