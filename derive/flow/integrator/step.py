"""One step of moving lanes up to their next event, and the consequences of the event."""

from derive.flow.integrator.one_lane import (
    INFINITY,
    Event,
    Kind,
    Lanes,
    Limit,
    M,
    N,
    Note,
    Passed,
    Pending,
    S,
    Share,
    Status,
    T,
    V,
    any_lane,
    breaks_at,
    down,
    minimum,
    new_series,
    none_of,
    note,
    number,
    read_samples,
    up,
    where,
)
from derive.flow.integrator.phases import advance_origin, face, keep_faster, note_lift_off, update_reach
from derive.flow.integrator.roots import crossing, falling_root, first_root, increment, margin_of, value
from derive.flow.integrator.series import elapsed, expand, longest_step, per_time, variable_at
from derive.flow.integrator.tables import end_of_piece, next_break, pass_breaks, rise_of_step

FAR = 1e300  # unreachable bound


# --- consequences of events ----------------------------------------------------------------------------------------


def enter_phase(s: Lanes, here: M, rate: V) -> None:
    """Begin another phase in motion: lanes enter another piece of a table, are lifted or land."""
    s.rate_before = rate
    s.drive_before = s.drive
    s.scale_before = s.drive_scale
    advance_origin(s, here)
    s.pending = Pending.ENTER_PHASE


def on_standstill(s: Lanes, here: M) -> None:
    """Bring lanes to a standstill, reversed unless they are one-way, so that rounding cannot continue their motion."""
    advance_origin(s, here)
    update_reach(s, here)
    s.rest_since = s.time
    if s.logged:
        note(s, here, Note.STANDS)
    s.faced = 1.0
    one_way = s.one_way > 0.0
    face(s, here, where(one_way, s.direction, -s.direction))
    s.pending = where(one_way, Pending.REST, Pending.RESOLVE)


def change_contact(s: Lanes, here: M) -> None:
    """Lose or regain contact with the slip surface."""
    s.lifted = 1.0 - s.lifted
    s.passed = Passed.LIFT
    note_lift_off(s, here and s.lifted > 0.0)


def on_breakpoint(s: Lanes, here: M, t: T, upwards: M) -> None:
    """Place lanes exactly at an edge of a table of slip, speed or rotation, in the next piece."""
    if t.kind == Kind.ROTATION:
        forward = s.direction > 0.0
        s.rotation = where(forward, end_of_piece(s, t, t.piece), breaks_at(s, t, t.piece))
        return
    if t.kind == Kind.SPEED:
        s.omega = where(upwards, t.upper, t.lower)
        s.passed = where(upwards, Passed.FASTER, Passed.SLOWER)
    t.piece = t.piece + where(upwards, 1.0, -1.0)
    if t.kind == Kind.SLIP:
        s.slip = breaks_at(s, t, t.piece) / t.scale
    if t.open:
        here = here and upwards and t.piece == number(t.pieces - 1)
        s.status = Status.NEED
        s.pending = Pending.READY


def on_breakpoints(s: Lanes, here: M, rate: V) -> None:
    """Pass edges of tables of slip, speed or rotation."""
    enter_phase(s, here, rate)
    for t in s.tables:
        upper: N = Event.BREAKPOINT + 2 * t.number
        upwards = s.event == number(upper)
        downwards = s.event == number(upper + 1)
        on_breakpoint(s, here and (upwards or downwards), t, upwards)


def end_motion(s: Lanes, here: M, rate: V, status: V) -> None:
    """End moving lanes at their end time or with an upright chord."""
    s.status = status
    s.end_rotation = s.rotation + s.direction * s.x
    s.end_omega = s.direction * s.omega
    s.end_rate = s.direction * rate
    update_reach(s, here)


def settle(s: Lanes, here: M, rate: V) -> None:
    """Apply the consequences of the event that ends a step."""
    s.status = where(s.event == Event.ENDLESS, Status.TOO_LONG, s.status)
    limits = here and s.event == Event.LIMIT
    pass_breaks(s, limits and s.time < s.end_time)
    end_motion(s, limits and s.time >= s.end_time, rate, Status.ENDED)
    on_standstill(s, here and s.event == Event.STANDSTILL)
    lifts = here and s.event == Event.LIFT_OFF
    change_contact(s, lifts)
    if s.logged:
        note(s, lifts and s.lifted == 0.0, Note.LANDS)
    enter_phase(s, lifts, rate)
    end_motion(s, here and s.event == Event.CHORD_UPRIGHT, rate, Status.UPRIGHT)
    on_breakpoints(s, here and s.event >= Event.BREAKPOINT, rate)


# --- one step ---------------------------------------------------------------------------------------------------------


def consider(s: Lanes, here: M, at: V, event: N) -> None:
    """Shorten the step to an event at a time, infinite without an event.

    Each event is searched in the step that earlier events leave.
    """
    s.event = where(at <= s.step, number(event), s.event)
    s.step = minimum(at, s.step)


def reach_limit(s: Lanes, here: M, room: V, top: N) -> None:
    """Shorten the step to the time left, up to a break of a function of time or the end time."""
    reaches = here and room < INFINITY
    if any_lane(reaches):
        at = variable_at(s, top, room)
        reaches = reaches and at < INFINITY
        s.step = where(reaches, at, s.step)
    s.event = where(reaches, Event.LIMIT, Event.NONE)


def find_standstill(s: Lanes, here: M, top: N) -> None:
    """Find the time at which the speed becomes zero.

    It is immediate if the drive from rest points backwards or is rounding.
    """
    omega = s.series.omega
    net = s.series.net
    last = value(omega, top, s.step)
    from_rest = omega[0] == 0.0
    decelerates = net[0] < 0.0
    falls_from_rest = from_rest and (decelerates or (net[0] == 0.0 and net[1] <= 0.0))
    dips = decelerates and value(net, top - 1, s.step) > 0.0
    asked = here and (last <= 0.0 or dips or falls_from_rest)
    if any_lane(asked):
        e = new_series()
        margin_of(e, omega, top, 1.0, 0.0, from_rest)  # remove the root at a start from rest
        for _ in up(1, 2):
            margin_of(e, e, top, 1.0, 0.0, from_rest and e[0] == 0.0)
        at = first_root(e, top, s.step, asked)
        vanishes = from_rest and e[0] == 0.0 and last == 0.0  # the drive is zero to rounding
        at_once = asked and (e[0] < 0.0 or vanishes)
        consider(s, here, where(at_once, 0.0, at), Event.STANDSTILL)


def find_crossing(s: Lanes, here: M, p: S, n: N, sign: V, constant: V, passed: M, event: N) -> None:
    """Find the time at which sign p + constant falls through zero, unless the phase began with this event."""
    at = crossing(p, n, s.step, sign, constant, passed, here)
    consider(s, here, at, event)


def find_contact_change(s: Lanes, here: M, top: N) -> None:
    """Find the time at which contact with the slip surface is lost or regained."""
    if s.has.normal:
        sign = where(s.lifted > 0.0, -1.0, 1.0)
        passed = s.passed == Passed.LIFT
        find_crossing(s, here, s.series.normal, top - 1, sign, 0.0, passed, Event.LIFT_OFF)


def find_edges(s: Lanes, here: M, t: T, top: N, by_rotation: N) -> None:
    """Find the time at which an edge of a table's piece is passed. The last piece may have no upper edge."""
    ends = here and t.upper < FAR
    upper = minimum(t.upper, FAR)
    event: N = Event.BREAKPOINT + 2 * t.number
    if t.kind == Kind.SPEED:
        omega = s.series.omega
        slower = s.passed == Passed.SLOWER
        find_crossing(s, ends, omega, top, -1.0, upper, slower, event)
        varies = here and t.lower > 0.0
        faster = s.passed == Passed.FASTER
        find_crossing(s, varies, omega, top, 1.0, -t.lower, faster, event + 1)
        return
    if by_rotation:
        ahead = upper - s.x
        consider(s, here, where(ends, ahead, INFINITY), event)
        return
    find_crossing(s, ends, s.series.x, top, -1.0, upper, none_of(s), event)


def find_events(s: Lanes, here: M, top: N, by_rotation: N) -> None:
    """Find the first event of the step. Of simultaneous events the last one in the order of the search is used.

    Water over a mass may change faster than its motion, which determines the step. The normal force is therefore valid
    only until the first other event, beyond which it may pass zero twice.
    """
    find_standstill(s, here, top)
    if s.has.upright:
        find_crossing(s, here, s.series.upright, top - 1, 1.0, 0.0, none_of(s), Event.CHORD_UPRIGHT)
    for t in s.tables:
        if t.kind != Kind.TIME:
            follows: N = t.number > 0 and t.kind == Kind.ROTATION
            known: N = follows and t.before.kind == Kind.ROTATION
            if known:  # its pieces end where the pieces of the preceding table end
                known = not any_lane(here and minimum(t.upper, FAR) != t.before.upper)
            if not known:
                find_edges(s, here, t, top, by_rotation)
    find_contact_change(s, here, top)


def choose_step(s: Lanes, here: M, top: N) -> None:
    """Shorten the step to the longest one that the series of the states allow, except where series end early.

    The rotation is the integral of the angular velocity and allows the same step. In tau it is the integral of an
    expression with the square of the angular velocity, so that its series alone decides.
    """
    complete = here and s.series_order == s.order
    if any_lane(complete):
        step: V = INFINITY
        for q in s.states:
            decides: N = q.is_rotation == s.has.pace
            if decides:
                step = minimum(longest_step(s, q.series, top, s.series_order), step)
        s.step = where(complete, minimum(step, s.step), s.step)


def advance_further(s: Lanes, here: M, top: N) -> None:
    """Advance the states besides rotation and speed, and the functions of time, by the step."""
    for q in s.states:
        further: N = not (q.is_rotation or q.is_speed)
        if further:
            q.now = q.now + increment(q.series, top, s.step)
    for t in s.tables:
        if t.kind == Kind.TIME:
            t.inc = t.inc + rise_of_step(s, t)


def find_endless(s: Lanes, here: M, room: V) -> None:
    """End motions that continue for ever.

    If the rate depends on the speed alone and hardly changes it, the rate never becomes negative again. Neither does a
    mass come to rest that nothing but its speed brakes.
    """
    change = s.series.net[0] * s.step
    settled = change >= -Share.SETTLED * s.series.omega[0]
    unopposed = abs(s.drive) <= Share.SETTLED * s.drive_scale
    uneventful = s.event == Event.NONE
    here = here and uneventful and (settled or unopposed) and room == INFINITY and s.lifted == 0.0
    s.event = Event.ENDLESS
    s.step = 0.0


def keep_peak(s: Lanes, here: M, top: N, rate: V, slope: V) -> None:
    """Record the greatest speed within the step, where the net moment falls through zero."""
    net = s.series.net
    at = falling_root(net, top - 1, s.step, rate, slope, here)
    peaks = at < INFINITY
    if any_lane(peaks):
        since = elapsed(s, top, at)
        time = s.time + since
        speed = value(s.series.omega, top, at)
        x = value(s.series.x, top, at)
        rate_there = value(net, top - 1, at)
        keep_faster(s, peaks, speed, time, x, rate_there)


def arrive(s: Lanes, here: M, until: V, rate: V) -> None:
    """Let a step end at the time ``until``, count it, and apply its consequences."""
    keep_faster(s, here, s.omega, until, s.x, rate)
    s.time = until
    change = abs(s.series.net[0]) * s.step
    steady = change < Share.STIFF_CHANGE * s.series.omega[0] and s.event == Event.NONE
    steps = s.steps + where(steady, Limit.STIFF_STEP, 1.0)
    s.steps = where(s.event == Event.LIMIT, 0.0, steps)
    s.passed = Passed.NOTHING
    settle(s, here and s.event != Event.NONE, rate)


def make_step(s: Lanes, here: M) -> None:
    """Make one step of moving lanes."""
    limit = minimum(next_break(s), s.end_time)
    room = limit - s.time
    top: N = expand(s, room, here, 0)
    choose_step(s, here, top)
    reach_limit(s, here, room, top)
    find_events(s, here, top, False)
    if s.autonomous:
        find_endless(s, here, room)
    step = s.step
    net = s.series.net
    omega = s.series.omega
    x = s.series.x
    rate: V = 0.0  # four polynomials side by side, which do not wait for each other
    slope: V = 0.0
    faster: V = 0.0
    farther: V = 0.0
    for k in down(top - 1, 0):
        slope = slope * step + rate
        rate = rate * step + net[k]
        faster = faster * step + omega[k + 1]
        farther = farther * step + x[k + 1]
    keep_peak(s, here, top, rate, slope)
    time = s.time + elapsed(s, top, step)
    until = where(s.event == Event.LIMIT, limit, time)
    if s.samples:
        read_samples(s, here, s.time, until, 1, top)
    s.omega = s.omega + step * faster
    s.x = s.x + step * farther
    advance_further(s, here, top)
    rate = per_time(s, rate, s.omega)
    arrive(s, here, until, rate)
