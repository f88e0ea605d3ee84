"""Series of a step: coefficients of every register, their number, and the length of the step."""

from derive.flow.integrator.one_lane import (
    INFINITY,
    Kind,
    Lanes,
    M,
    N,
    S,
    V,
    all_lanes,
    any_lane,
    greatest,
    least,
    log2_of,
    maximum,
    minimum,
    new_series,
    none_of,
    number,
    operate,
    operate_later,
    power_of_two,
    tail,
    up,
    where,
)
from derive.flow.integrator.roots import first_root, margin_of, value
from derive.flow.integrator.tables import expand_sine

ROUNDING = 2.0**-56  # size over the largest term of a series below which a term is rounding
LARGEST = 1000.0 * 2.0**40  # greatest log2 of a radius, scaled like `log2_of`


def begin_series(s: Lanes) -> None:
    """Set order 0 of the registers that do not result from operations."""
    for q in s.states:
        q.series[0] = q.now
    for t in s.tables:
        if t.kind == Kind.TIME:
            t.series[0] = t.inc


def per_time(s: Lanes, rate: V, omega: V) -> V:
    """Return a rate by time from a rate by tau, the variable of a step, where dt = (1 + pace omega) dtau."""
    if s.has.pace:
        return rate / (1.0 + s.pace * omega)
    return rate


def find_clock(s: Lanes, t: S, top: N) -> None:
    """Compute the time since the beginning of a step as a series in tau."""
    t[0] = 0.0
    for k in up(0, top - 1):
        t[k + 1] = s.pace * s.series.omega[k] * s.inverse[k + 1]
    t[1] = 1.0 + t[1]


def elapsed(s: Lanes, top: N, at: V) -> V:
    """Return the time since the beginning of a step from its variable."""
    if s.has.pace:
        t = new_series()
        find_clock(s, t, top)
        return value(t, top, at)
    return at


def variable_at(s: Lanes, top: N, time: V) -> V:
    """Return the variable of a step from the time since its beginning, infinite if the step does not last so long.

    In tau the time rises up to a standstill, beyond which it falls.
    """
    if s.has.pace:
        left = new_series()
        find_clock(s, left, top)
        limited = time < INFINITY
        margin_of(left, left, top, -1.0, where(limited, time, 0.0), none_of(s))
        return first_root(left, top, s.step, limited)
    return where(time <= s.step, time, INFINITY)


def evaluate(s: Lanes) -> None:
    """Compute order 0 of all registers. Rates of states are per time."""
    begin_series(s)
    operate(s, 0, 1, False, False)
    operate_later(s, 1)
    for q in s.states:
        q.rate[0] = per_time(s, q.rate[0], s.omega)


def normal_force(s: Lanes) -> V:
    """Return the normal force on the slip surface from order 0. Contact is lost if it is negative."""
    force = s.normal0
    if s.has.normal:
        force = s.series.normal[0]
    return force


def find_negligible(s: Lanes, here: M) -> None:
    """Compute the size of the last terms over the largest term of a step that a break cuts short, factor^order.

    The truncation error is such a term times the step over the radius of convergence, per time the same as in complete
    steps.
    """
    negligible: V = 1.0
    for n in up(1, s.highest):
        negligible = where(s.order >= number(n), negligible * s.factor, negligible)
    s.negligible = maximum(negligible, ROUNDING)


def truncate(p: S, order: V, top: N) -> None:
    """Set the coefficients of a series from each lane's order on to zero."""
    for n in up(least(order), top - 1):
        p[n] = where(order > number(n), p[n], 0.0)


def cut(s: Lanes, order: V, top: N) -> None:
    """Truncate the series of the states, and those that events use, at each lane's order."""
    for q in s.states:
        truncate(tail(q.series), order, top)
    truncate(s.series.net, order, top)
    if s.has.normal:
        truncate(s.series.normal, order, top)
    if s.has.upright:
        truncate(s.series.upright, order, top)


def begin_expansion(s: Lanes, which: M, top: N, at_rest: N) -> None:
    """Set order 0 of the registers that do not result from operations, and the series of functions of time."""
    begin_series(s)
    if at_rest:
        for q in s.states:
            for n in up(1, top):
                q.series[n] = 0.0
    for t in s.tables:
        if t.kind == Kind.TIME:
            t.series[1] = t.rise
        if t.sine:
            expand_sine(s, t)
    s.largest_omega = 0.0 if at_rest else abs(s.series.omega[0])


def next_term_counts(s: Lanes, n: N, power: V, at_rest: N) -> M:
    """Return whether coefficient n times a power of the step is significant beside the largest term so far.

    It is a term of the speed, at rest of the net moment. The path needs no test of its own: its term n + 1 is term n of
    the speed, times the step over n + 1.
    """
    omega = s.series.net if at_rest else s.series.omega
    term = abs(omega[n]) * power
    largest = 1.0 * s.largest_omega
    negligible = term <= s.negligible * largest and largest > 0.0 and largest < INFINITY
    s.largest_omega = maximum(term, largest)
    return not negligible


def expand(s: Lanes, room: V, which: M, at_rest: N) -> N:
    """Compute the series of all registers, of states to one order more than of rates; return the highest order.

    If a function of time cuts the step short after ``room``, a series ends as soon as two consecutive terms are
    negligible there, three if the speed grows beyond its first term. At rest the states are constant, and the net
    moment decides. Each lane's order is `series_order`; states, net moment, normal force and dip are zero beyond it.
    """
    order = where(which, s.order, 1.0)
    top: N = greatest(order)
    alike: N = all_lanes(order == number(top))
    begin_expansion(s, which, top, at_rest)
    first = s.largest_omega
    power: V = 1.0 if at_rest else room
    in_a_row: V = 0.0
    n: N = 0
    if not s.timed:
        operate(s, 0, top, False, True)
        n = top
    computed: N = 0
    while n < top:
        if n == computed:
            computed = minimum(n + 2, top)  # of two orders the first one computes sums of both
            operate(s, n, computed, False, not at_rest)
        counts = next_term_counts(s, n if at_rest else n + 1, power, at_rest)
        power = power * room
        in_a_row = where(counts, 0.0, in_a_row + 1.0)
        enough = where(s.largest_omega > first, 3.0, 2.0)
        ends = in_a_row >= (2.0 if at_rest else enough) and order > number(n) and which
        if n >= 2 and any_lane(ends):
            order = where(ends, minimum(order, number(n + 1)), order)
            alike = False
            if not any_lane(order > number(n + 1)):
                top = n + 1
        n = n + 1
    operate_later(s, top)
    if not alike:
        cut(s, order, top)
    s.series_order = order
    s.step = room
    return top


def longest_step(s: Lanes, p: S, top: N, order: V) -> V:
    """Return the longest step at the end of which each of the last four terms is small beside one of the first five.

    Term n is at most factor^n of the largest of the first five, so that the step is the factor times the radius of
    convergence if the series is geometric. Entire functions, whose terms decrease ever faster, allow longer steps. The
    step is 2^1000 if these coefficients are zero.
    """
    first = new_series()
    comparable = p[0] != 0.0
    for k in up(0, 4):
        first[k] = log2_of(p[k])
        comparable = comparable or p[k] != 0.0
    one: V = 1.0
    share = log2_of(s.factor) - log2_of(one)
    lowest: V = LARGEST
    for n in up(maximum(least(order) - 3, 5), top):
        last = log2_of(p[n]) - number(n) * share
        most: V = -LARGEST
        for k in up(0, 4):
            most = maximum((first[k] - last) * s.inverse[n - k], most)
        among_last = order >= number(n) and order <= number(n + 3)
        counts = comparable and among_last and p[n] != 0.0
        lowest = where(counts and most < lowest, most, lowest)
    return power_of_two(lowest)
