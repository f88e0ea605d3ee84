"""Steps in powers of the rotation, where forces depend on the rotation and on omega^2 alone.

With E = omega^2 the equation of motion is dE/dx = 2 net (`derive.algebra.phase_plane`), and dx/dx = 1. In the series of
such a step E is in place of omega, and events are found as in a series in time. E is regular at rest, and friction that
softens with slip changes it slowly, so that there are fewer steps than in time.

The duration of a step is the integral of dx/sqrt(E), by Gauss's rule before and after the greatest speed. Its variable
is the root of the ratio of the distances from the rests before and after, estimated from E and its derivatives.
"""

from derive.flow.integrator.one_lane import (
    INFINITY,
    LAST_SHARES,
    NEXT_SHARES,
    NODES,
    SHARES,
    SHORTEST,
    Event,
    Kind,
    Lanes,
    M,
    N,
    S,
    V,
    any_lane,
    maximum,
    minimum,
    new_series,
    none_of,
    sqrt,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster
from derive.flow.integrator.recurrence import expand_in_rotation, has_recurrence
from derive.flow.integrator.roots import falling_root, increment, shift, value, value_and_slope
from derive.flow.integrator.step import arrive, choose_step, enter_phase, find_events

LONGEST = 1.0  # of a step
REACH = 4.0  # greatest step over the distance of a second rest behind
STRAIGHT = 16.0  # distance of a rest, over the length of the path, from which the path need not be stretched
NEWTON = 3  # steps of the method by which a rest near a step is found
NEAREST = 0.9  # of a rest that is estimated ahead: greatest path over its distance
EVEN = 2.0**-20  # last coefficients of an integrand up to which its integral is accurate
FINEST = 17  # order of the series in time for a relative error of 1e-9, beyond which rules have more nodes
CLOSER = 2.0**-25  # the same as EVEN beyond this order
MOST_HALVINGS = 30
BRIEFEST = 1e-7  # duration of a step below which series in time, which states are read from, may overflow


def integral(p: S, n: N, k_first: N, most: V, side: V, first: V, span: V, per: V) -> V:
    """Return the integral of v dv/(sqrt(E) (1 + per v^2)^2) over a path by a rule, infinite if it is uncertain.

    The path begins where v is ``first``, ``span`` is its length, and ``k_first`` the number of the rule's first node.
    """
    total: V = 0.0
    last: V = 0.0
    last_but_one: V = 0.0
    near_second: N = any_lane(per > 0.0)
    for k in up(k_first, 2 * k_first + SHORTEST - 1):
        past = span * NODES[k]
        v = first + past
        square = v * v
        share: V = 1.0
        if near_second:
            share = 1.0 / (1.0 + per * square)
        y = past * (first + v) * share
        speed = sqrt(value(p, n, side * y))
        slowness = v * (share * share) / speed
        total = total + SHARES[k] * slowness
        last = last + LAST_SHARES[k] * slowness
        last_but_one = last_but_one + NEXT_SHARES[k] * slowness
    accurate = abs(last) + abs(last_but_one) <= most * total
    return where(accurate, total, INFINITY)


def time_over(p: S, n: N, fine: N, way: V, beyond: V, per: V) -> V:
    """Return the time over a path that begins at the distance ``beyond`` from a rest, infinite if it is uncertain.

    E is the polynomial ``p`` of the distance from this beginning. ``way`` is the path with its sign: against the motion
    if the rest is at the end. ``per`` is 1 over the distance of another rest in this direction, or 0. In the variable v
    with v^2 = (beyond + y)/(1 - per y) both rests are regular. With ``fine`` the rule has more nodes; on a short path
    far from rest half as many may suffice.
    """
    size = abs(way)
    side = where(way < 0.0, -1.0, 1.0)
    first = sqrt(beyond)
    left = 1.0 - per * size
    stretch = 1.0 + per * beyond
    final = sqrt((beyond + size) / left)
    span = size * stretch / (left * (first + final))
    most: V = CLOSER if fine else EVEN
    rule: N = 3 * SHORTEST if fine else SHORTEST
    moves = size > 0.0
    is_short = moves and size <= beyond and per == 0.0
    total: V = INFINITY
    if any_lane(is_short):
        total = where(is_short, integral(p, n, 0, most, side, first, span, per), total)
    remains = moves and total == INFINITY
    if any_lane(remains):
        total = where(remains, integral(p, n, rule, most, side, first, span, per), total)
    return where(moves, span * stretch * total, 0.0)


def distance_of_rest(p: S, n: N, side: V, far: V) -> V:
    """Return the distance at which the polynomial E has a zero, by Newton's method as far as it converges.

    It is searched forwards if ``side`` is 1, backwards if it is -1. Without a zero there the distance is ``far``.
    """
    distance = -side * p[0] / p[1]
    for _ in up(1, NEWTON):
        at, slope = value_and_slope(p, n, side * distance)
        change = -side * at / slope
        converges = abs(change) < 0.5 * distance
        distance = where(converges, distance + change, distance)
    nearest = minimum(distance, far)
    return where(distance >= 0.0, nearest, far)


def expand_about_end(s: Lanes, p: S, n: N) -> None:
    """Compute E as a polynomial of the distance from the end of the step.

    It has no rounding error where the mass comes to rest, near which the duration depends on it.
    """
    e = s.series.omega
    for k in up(0, n):
        p[k] = e[k]
    shift(p, n, s.step)
    stands = s.event == Event.STANDSTILL
    p[0] = where(stands, 0.0, p[0])


def rest_ahead(s: Lanes, peaks: M, to_end: V, path: V) -> V:
    """Return 1 over the distance of the rest ahead, beyond a peak or estimated from E, or 0 if the path is too long."""
    e = s.series.omega
    by_bend = maximum(-e[2] / e[1], 0.0)
    ahead = where(peaks, 1.0 / (s.step + to_end), by_bend)
    near = e[1] > 0.0 and ahead * path < NEAREST
    return where(near, ahead, 0.0)


def times_of_step(s: Lanes, here: M, top: N, peak: V) -> tuple[V, V]:
    """Return the durations of the parts of a step before and after its greatest speed, infinite if uncertain.

    ``peak`` is the rotation at the greatest speed, infinite without one.
    """
    e = s.series.omega
    step = s.step
    peaks = peak < INFINITY
    far = STRAIGHT * step
    fine: N = s.highest > FINEST
    rises = e[1] > 0.0
    of_end = new_series()
    to_end = 1.0 * far
    falls = none_of(s)
    nears = here and (peaks or not rises)
    if any_lane(nears):
        expand_about_end(s, of_end, top)
        to_end = distance_of_rest(of_end, top, 1.0, far)
        falls = here and not peaks and not rises and of_end[1] < 0.0
    behind = distance_of_rest(e, top, -1.0, far)
    behind = where(rises, behind, far)
    path = minimum(peak, step)
    ahead = rest_ahead(s, peaks, to_end, path)
    after: V = 0.0
    if any_lane(peaks):
        back = where(peaks, peak - step, 0.0)
        from_end = where(rises, 1.0 / (step + behind), 0.0)
        after = time_over(of_end, top, fine, back, to_end, from_end)
    for k in up(0, top):
        of_end[k] = where(falls, of_end[k], e[k])
    beyond = where(falls, to_end, behind)
    path = where(falls, -step, path)
    before = time_over(of_end, top, fine, path, beyond, ahead)
    return before, after


def way_ahead(s: Lanes) -> V:
    """Return the rotation up to which a step may go: to the next edge of a table."""
    room = LONGEST + s.x
    for t in s.tables:
        if t.kind == Kind.SLIP or t.kind == Kind.ROTATION:
            room = minimum(t.upper - s.x, room)
    return room


def shorten(s: Lanes, here: M) -> None:
    """Shorten a step where the square of the speed bends upwards, so that a second rest behind is not too near."""
    e = s.series.omega
    bends = here and e[2] > 0.0 and e[1] >= 0.0
    by_slope = e[1] / e[2]
    by_speed = sqrt(e[0] / e[2])
    most = REACH * (by_slope + by_speed)
    shorter = minimum(most, s.step)
    s.step = where(bends, shorter, s.step)


def complete(s: Lanes, here: M, top: N, peak: V, before: V, until: V) -> None:
    """Bring lanes to the end of their step at the time ``until``, by the greatest speed after the time ``before``."""
    net = s.series.net
    e = s.series.omega
    step = s.step
    rate = value(net, top - 1, step)
    peaks = here and peak < INFINITY
    if any_lane(peaks):
        there = where(peaks, peak, 0.0)
        speed = sqrt(value(e, top, there))
        slope = value(net, top - 1, there)
        keep_faster(s, peaks, speed, s.time + before, s.x + there, slope)
    s.x = s.x + step
    square = e[0] + increment(e, top, step)
    s.omega = sqrt(maximum(square, 0.0))
    arrive(s, here, until, rate)
    if has_recurrence(s):
        enter_phase(s, here and s.event == Event.NONE, rate)


def turn_on(s: Lanes, here: M) -> None:
    """Make one step of moving lanes in powers of the rotation.

    If its duration is uncertain or extremely short, or exceeds the end time, the lane stays where it is and is
    integrated in time.
    """
    omega: V = 1.0 * s.omega
    s.omega = omega * omega
    room = way_ahead(s)
    top: N = expand_in_rotation(s, room, here)
    choose_step(s, here, top)
    shorten(s, here)
    s.event = Event.NONE
    find_events(s, here, top, True)
    peak: V = INFINITY
    before: V = 0.0
    after: V = 0.0
    unsure = here
    count: N = 0
    while any_lane(unsure) and count <= MOST_HALVINGS:
        rate, slope = value_and_slope(s.series.net, top - 1, s.step)
        peak = falling_root(s.series.net, top - 1, s.step, rate, slope, here)
        before, after = times_of_step(s, here, top, peak)
        unsure = here and not (before + after < INFINITY)
        s.step = where(unsure, 0.5 * s.step, s.step)
        s.event = where(unsure, Event.NONE, s.event)
        count = count + 1
    duration = before + after
    until = s.time + duration
    stands = s.step == 0.0 and s.event == Event.STANDSTILL  # not where a tiny step is rounded to 0
    regular = duration > BRIEFEST or stands
    fits = here and regular and until < s.end_time
    s.omega = omega
    s.clocked = where(fits, 0.0, 1.0)
    complete(s, fits, top, peak, before, until)
