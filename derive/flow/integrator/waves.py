"""Time as a function of the rotation in a phase from rest that has a closed form.

With x = end sin(u)^2 the time is u times its mean rate, and a series of sines of 2 u. Newton's method on this series
finds where a mass is at the end time and at output times.
"""

from derive.flow.integrator.energy import energy, force_at, functions, reverse, turned
from derive.flow.integrator.one_lane import (
    ARCSINE,
    COSINES,
    LAST_OF_ARCSINE,
    Lanes,
    M,
    N,
    S,
    V,
    any_lane,
    down,
    keep_sample,
    new_series,
    number,
    sample_time,
    sqrt,
    up,
    where,
)

PI = 3.141592653589793
QUARTER = PI / 4.0
PAIRS = 8  # of nodes at most
LONG = 2 * PAIRS + 1  # place behind the coefficients of the time: 1 if those beyond PAIRS are not 0
LAST_WAVE = 2.0**-44  # last coefficients of the series of the time over the first one, up to which it is complete
MOST_CORRECTIONS = 12  # of a root by Newton's or Halley's method
LAST_OF_NEWTON = 2.0**-26  # relative step of Newton's method after which the next one would be below rounding
OMEGA_THERE = 1  # place of the angular velocity in a state, behind the rotation
RATE_THERE = 2
ANGLE_THERE = 3  # place of u, and of the derivative of the time by u
SLOPE_THERE = 4


def mean_of(both: S, pairs: N, by: N) -> V:
    """Return the mean of the integrand by the trapezoidal rule of twice so many intervals, of every node in ``by``."""
    ends = both[0] + both[PAIRS]
    total = 0.5 * ends
    for k in up(1, pairs - 1):
        total = total + both[k * by]
    return total / number(2 * pairs)


def find_waves(w: S, here: M, both: S, odd: S, pairs: N, by: N) -> None:
    """Compute the coefficients of the time as a series in u and sines of 2 u from the nodes of a rule.

    It is the integral of a series of cosines, whose even coefficients are sums of ``both``, and whose odd coefficients
    are sums of ``odd``.
    """
    scale: V = 1.0 / number(pairs)
    w[0] = where(here, mean_of(both, pairs, by), w[0])
    for j in up(1, pairs):
        of_odd: V = 0.0
        of_even: V = 0.0
        even_row: N = 2 * j * (PAIRS + 1)
        odd_row: N = even_row - (PAIRS + 1)
        for k in up(0, pairs):
            node: N = k * by
            of_odd = of_odd + COSINES[odd_row + node] * odd[node]
            of_even = of_even + COSINES[even_row + node] * both[node]
        last: V = 0.5 if j == pairs else 1.0
        w[2 * j - 1] = where(here, scale * of_odd, w[2 * j - 1])
        w[2 * j] = where(here, scale * last * of_even, w[2 * j])


def time_at(w: S, u: V, place: V, sine: V) -> tuple[V, V]:
    """Return the time since rest at the rotation end sin(u)^2, and its derivative by u.

    ``place`` and ``sine`` are -cos(2 u) and sin(2 u).
    """
    top: N = 2 * PAIRS if any_lane(w[LONG] > 0.0) else PAIRS
    twice = -2.0 * place
    cosine = -place
    sine_before: V = 0.0
    cosine_before: V = 1.0
    time = 2.0 * w[0] * u
    slope = 2.0 * w[0]
    for m in up(1, top):
        time = time + w[m] * sine
        slope = slope + number(2 * m) * w[m] * cosine
        sine_after = twice * sine - sine_before
        cosine_after = twice * cosine - cosine_before
        sine_before = sine
        cosine_before = cosine
        sine = sine_after
        cosine = cosine_after
    return time, slope


def time_to(w: S, x: V, end: V) -> V:
    """Return the time from rest to a rotation, with u from the series of the arcsine."""
    left = end - x
    place = (x - left) / end
    sine = 2.0 * sqrt(x * left) / end
    z = place / sqrt(2.0 + 2.0 * sine)
    square = z * z
    total: V = 0.0
    for k in down(LAST_OF_ARCSINE, 0):
        total = total * square + ARCSINE[k]
    time, _ = time_at(w, QUARTER + z * total, place, sine)
    return time


def is_uneven(w: S, n: N) -> M:
    """Return whether the last two coefficients of the series of the time are not negligible."""
    last = abs(w[n - 1]) + abs(w[n])
    return not last <= LAST_WAVE * w[0]


def find_state(s: Lanes, there: S, here: M, e: S, back: S, w: S, end: V, time: V) -> None:
    """Compute the rotation, the angular velocity and its rate at a time since rest, where lanes of the mask move.

    The search begins at the angle u in ``there``, to which it is added together with the slope of the time.
    """
    u = there[ANGLE_THERE]
    slope: V = 1.0
    lag, versine = turned(2.0 * u)
    asked = here
    count: N = 0
    while any_lane(asked) and count < MOST_CORRECTIONS:
        then, slope = time_at(w, u, versine - 1.0, 2.0 * u - lag)
        change = (time - then) / slope
        u = where(asked, u + change, u)
        asked = asked and abs(change) > LAST_OF_NEWTON * u
        lag, versine = turned(2.0 * u)
        count = count + 1
    there[ANGLE_THERE] = u
    there[SLOPE_THERE] = slope
    x = 0.5 * end * versine
    f = new_series()
    functions(f, x, e[4])
    square = energy(e, f)
    there[0] = x
    there[RATE_THERE] = force_at(s.drive, s.net_sine, s.net_vers, f) + s.net_square * square
    late = versine > 1.0
    if any_lane(here and late):
        _, versine_back = turned(PI - 2.0 * u)
        functions(f, 0.5 * end * versine_back, e[4])
        reverse(f, e[4])
        square = where(late, energy(back, f), square)
    there[OMEGA_THERE] = sqrt(square)


def keep_samples(s: Lanes, here: M, e: S, back: S, w: S, end: V, until: V) -> None:
    """Store the states at the output times within a phase, which ends at the time ``until``."""
    there = new_series()
    there[ANGLE_THERE] = 0.0
    there[SLOPE_THERE] = 2.0 * w[0]
    before = s.time
    k: N = 0
    while k < s.samples:
        time = sample_time(s, k)
        inside = here and time >= s.time and time < until
        if any_lane(inside):
            ahead = (time - before) / there[SLOPE_THERE]
            there[ANGLE_THERE] = where(inside, there[ANGLE_THERE] + ahead, there[ANGLE_THERE])
            before = where(inside, time, before)
            find_state(s, there, inside, e, back, w, end, time - s.time)
            keep_sample(s, inside, k, there[0], there[OMEGA_THERE], there[RATE_THERE])
        k = k + 1
