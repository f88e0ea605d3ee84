"""Samples of a record that are passed without series, by masses at rest and by frozen masses in motion.

If only one piecewise linear function of time changes, net moment and normal force are linear in its value. This applies
to a mass at rest, and to a moving mass with constant geometry and friction.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    Kind,
    Lane,
    Lanes,
    M,
    N,
    Passed,
    Pending,
    S,
    Status,
    T,
    V,
    any_lane,
    break_of,
    constant_of,
    greatest,
    integer,
    maximum,
    minimum,
    number,
    read_samples,
    sqrt,
    where,
)
from derive.flow.integrator.phases import advance_origin, keep_faster, update_reach
from derive.flow.integrator.series import normal_force
from derive.flow.integrator.tables import end_of_piece, pass_break

SURE = 1.0 - 2.0**-20  # fraction of a margin that may be used; series decide the rest
SIXTH = 1.0 / 6.0
ROUNDINGS = 2.0**27  # least margin, in roundings of its terms


def passes_quietly(lane: Lane, t: T, piece: int) -> bool:
    """Return whether a piece ends before the end time and not at the last break, where the function may jump."""
    last: N = t.pieces - 1
    following = minimum(piece + 1, last)
    ends = end_of_piece(lane, t, following) < INFINITY
    return ends and break_of(lane, t, following) < lane.end_time * t.scale * (1.0 - 4.0 * EPS)


def value_at_break(lane: Lane, t: T, piece: int) -> float:
    """Return a piecewise linear function of time at the left end of a piece."""
    return t.scaled_by * constant_of(lane, t, piece)


def stand_before(lane: Lane, t: T, piece: int, now: float) -> None:
    """Place the lane at the left end of a piece, which it has not entered yet."""
    lane.time = now
    t.piece = number(piece - 1)
    t.way = INFINITY


# --- at rest ---------------------------------------------------------------------------------------------------------


def keep_quiet(s: Lanes, here: M, t: T, p: S, sign: V, terms: V) -> None:
    """Bound the values of the function of time for which sign p, linear in it, certainly keeps its sign."""
    now = t.value + t.inc
    level = t.rise == 0.0
    way = sign * p[1] * t.rise
    bound = where(level, now, now - SURE * p[0] * t.rise / p[1])
    straight = p[2] == 0.0 and s.series_order <= 4.0
    sure = straight and sign * p[0] > ROUNDINGS * terms and s.lifted == 0.0
    s.quiet_from = where(level or way > 0.0, maximum(bound, s.quiet_from), s.quiet_from)
    s.quiet_to = where(level or way < 0.0, minimum(bound, s.quiet_to), s.quiet_to)
    s.quiet_to = where(sure, s.quiet_to, -INFINITY)


def look_for_quiet(s: Lanes, here: M) -> None:
    """Find the range of one function of time in which the mass certainly stays at rest in its direction."""
    terms_of_normal = EPS * (abs(s.normal_load) + abs(s.normal_load_slope))
    for t in s.tables:
        if t.kind == Kind.TIME and t.terms == 2:
            keep_quiet(s, here, t, s.series.net, -1.0, s.drive_scale)
            if s.has.normal:
                keep_quiet(s, here, t, s.series.normal, 1.0, terms_of_normal)


def rests_on(lane: Lane, t: T, piece: int) -> bool:
    """Return whether the mass certainly rests through a piece, as both its end values are in the quiet range."""
    last: N = t.pieces - 1
    value = value_at_break(lane, t, minimum(piece + 1, last))
    return lane.quiet_from <= value and value <= lane.quiet_to and passes_quietly(lane, t, piece)


def rest_through(lane: Lane, t: T) -> None:
    """Pass the pieces through which the mass certainly rests."""
    piece = integer(t.piece)
    while rests_on(lane, t, piece):
        piece = piece + 1
    if piece > integer(t.piece):
        now = break_of(lane, t, piece) / t.scale
        if lane.samples:
            read_samples(lane, lane.time, now, 0, 0)
        stand_before(lane, t, piece, now)


# --- side by side ----------------------------------------------------------------------------------------------------


def path(time: V, omega: V, net: V, change: V) -> V:
    """Return the path after a time at a speed with a rate ``net`` that changes linearly."""
    by_change = SIXTH * time * change
    by_rate = 0.5 * net + by_change
    mean = omega + time * by_rate
    return time * mean


def standstill(omega: V, net: V, change: V) -> V:
    """Return the first time at which a falling speed is zero."""
    square = net * net
    decrease = 2.0 * change * omega
    root = sqrt(maximum(square - decrease, 0.0))
    twice = 2.0 * omega
    falling = twice / (root - net)
    rising = (net + root) / (0.0 - change)
    return where(net <= 0.0, falling, rising)


def end_of(s: Lanes, t: T, piece: N, per: V) -> V:
    """Return the time at which a piece ends, or at which the last piece begins, where ``per`` is 1 over the scale."""
    last: N = t.pieces - 1
    following: N = minimum(piece + 1, last)
    return t.places[following] * per


def passes(s: Lanes, t: T, piece: N, per: V, until: V, press: V) -> M:
    """Return the lanes that are pressed through a piece that ends before the end time and not at the last break.

    ``until`` is the end of the piece.
    """
    following = end_of(s, t, piece + 1, per)
    before_last = until < following and following < INFINITY
    latest = s.end_time * (1.0 - 4.0 * EPS)
    in_time = until < latest
    pressed = press > 0.0
    return before_last and in_time and pressed


def right_value(s: Lanes, t: T, piece: N) -> V:
    """Return a record at the right end of a piece."""
    last: N = t.pieces - 1
    following: N = minimum(piece + 1, last)
    height = t.heights[2 * following]
    return height * t.scaled_by


def rests_through(s: Lanes, t: T, piece: N, per: V) -> M:
    """Return the lanes that certainly rest in a piece if they rest at its left end, and are inside of it."""
    value = right_value(s, t, piece)
    until = end_of(s, t, piece, per)
    pressed: V = 1.0
    inside = passes(s, t, piece, per, until, pressed)
    quiet = s.quiet_from <= value and value <= s.quiet_to
    return inside and quiet


def last_at_rest(s: Lanes, on: M, t: T, piece: N, per: V) -> N:
    """Return the last piece through which all lanes certainly rest, from a piece at rest on."""
    last: N = piece
    while not any_lane(on and not rests_through(s, t, last + 1, per)):
        last = last + 1
    return last


def end_slide(lane: Lane, t: T, piece: int, x: float, omega: float) -> None:
    """Place a lane at the left end of a piece, at rest or in motion. Another phase begins there."""
    lane.x = x
    lane.omega = omega
    lane.status = where(omega > 0.0, Status.MOVING, Status.RESTING)
    lane.steps = 0.0
    lane.passed = Passed.NOTHING
    if omega == 0.0:
        lane.time = lane.rest_since
        update_reach(lane)
    advance_origin(lane)
    edge = break_of(lane, t, piece)
    now = edge / t.scale
    stand_before(lane, t, piece, now)
    pass_break(lane, t)
    lane.pending = Pending.BEGIN_PHASE


def lowest_speed(s: Lanes, here: M, now: V, length: V, x: V, omega: V, net: V, after: V, end: V) -> V:
    """Return the lowest speed within a piece in which the net moment changes its sign; record the greatest speed.

    ``end`` is the speed at the end of the piece.
    """
    share = net / (net - after)
    at = length * share
    gain = at * net
    extreme = omega + 0.5 * gain
    mean = omega + 2.0 * SIXTH * gain
    way = at * mean
    there = x + way
    rises = here and net > 0.0
    keep_faster(s, rises, extreme, now + at, there, 0.0)
    falls = here and net < 0.0
    return where(falls, extreme, end)


def count_starts(s: Lanes, here: M) -> None:
    """Count phases that begin down-slope."""
    back = s.last_way < 0.0
    s.phases = s.phases + 1.0
    s.turns = s.turns + where(back, 1.0, 0.0)
    s.last_way = 1.0


def turn(s: Lanes, here: M, now: V, length: V, omega: V, net: V, after: V) -> tuple[V, V]:
    """Stop lanes within a piece, start them, or both; return the speed at its end and the path."""
    moves = omega > 0.0
    rise = after - net
    change = rise / length
    root = standstill(omega, net, change)
    stop = where(moves, root, 0.0)
    share = net / (net - after)
    zero = share * length
    start = where(net < 0.0, zero, 0.0)
    drives_later = after > 0.0 and start >= stop
    drives = net > 0.0 and not moves
    starts = drives_later or drives
    push = maximum(net, 0.0)
    left = length - start
    by_change = 0.5 * left * change
    rate = push + by_change
    speed = left * rate
    again = starts and speed <= 0.0
    to_stop = -2.0 * push / change
    span = where(again, to_stop, left)
    since = where(moves, now + stop, s.rest_since)
    s.rest_since = where(again, now + span, since)
    count_starts(s, here and starts)
    nothing = 0.0 * span
    behind = path(span, nothing, push, change)
    further = where(starts, behind, 0.0)
    goes_on = starts and not again
    end = where(goes_on, speed, 0.0)
    before = path(stop, omega, net, change)
    return end, before + further


def pass_piece(s: Lanes, here: M, now: V, length: V, x: V, omega: V, net: V, after: V) -> tuple[V, V]:
    """Return the speed at the end of a piece and the path through it."""
    twice = net + after
    half = 0.5 * length
    end: V = omega + half * twice
    by_rates = net + twice
    sixth = SIXTH * length
    mean = omega + sixth * by_rates
    further: V = length * mean
    lowest: V = end
    opposite = net * after
    crosses = here and opposite < 0.0
    if any_lane(crosses):
        lowest = lowest_speed(s, crosses, now, length, x, omega, net, after, end)
    moves = omega > 0.0
    stays = moves and lowest > 0.0
    drives = net > 0.0 or after > 0.0
    turns = here and not stays and (moves or drives)
    end = where(stays, end, 0.0)
    further = where(stays, further, 0.0)
    if any_lane(turns):
        speed, way = turn(s, turns, now, length, omega, net, after)
        end = where(turns, speed, end)
        further = where(turns, way, further)
    return end, further


def slide(s: Lanes, here: M, t: T, first: N, slope: V, base: V, grip: V, weight: V) -> None:
    """Move lanes at rest through the pieces of a record, exactly: omega is quadratic in time, and x cubic.

    The net moment is ``base`` + ``slope`` times the record, the normal force is ``weight`` + ``grip`` times the record.
    A lane leaves before a piece in which it may lift.
    """
    per = 1.0 / t.scale
    piece: N = first
    now: V = s.time
    current = t.value + t.inc
    net: V = base + slope * current
    value: V = t.value + t.lower
    omega: V = 0.0
    x: V = 0.0
    on: M = here
    until = end_of(s, t, piece, per)
    while any_lane(on):
        length = until - now
        after = base + slope * value
        acts = on and (omega > 0.0 or net > 0.0 or after > 0.0)
        if any_lane(acts):
            speed, way = pass_piece(s, on, now, length, x, omega, net, after)
            omega = speed
            x = x + way
        if not any_lane(acts):
            piece = last_at_rest(s, on, t, piece, per)
            until = end_of(s, t, piece, per)
            after = base + slope * right_value(s, t, piece)
        now = until
        net = after
        piece = piece + 1
        value = right_value(s, t, piece)
        press = weight + grip * value
        until = end_of(s, t, piece, per)
        inside = passes(s, t, piece, per, until, press)
        leaves = on and not inside
        if leaves:
            end_slide(s, t, piece, x, omega)
        on = on and inside


def slide_together(s: Lanes, here: M, t: T) -> M:
    """Move lanes that rest in the same piece and start down-slope only; return lanes that follow in a later round.

    So the numbers of a lane do not depend on other lanes.
    """
    net = s.series.net
    slope = net[1] / t.rise
    origin = t.value + t.inc
    base = net[0] - slope * origin
    grip: V = 0.0
    if s.has.normal:
        grip = s.series.normal[1] / t.rise
    force = normal_force(s)
    weight = force - grip * origin
    straight = net[2] == 0.0
    linear = here and straight and t.rise != 0.0
    down_slope = s.one_way > 0.0 and s.direction > 0.0
    forward = linear and down_slope and s.lifted == 0.0
    piece: N = greatest(where(forward, t.piece, -1.0))
    same = t.piece == number(piece)
    there = forward and same
    if any_lane(there):
        per = 1.0 / t.scale
        ahead = t.value + t.lower
        press = weight + grip * ahead
        until = end_of(s, t, piece, per)
        inside = there and passes(s, t, piece, per, until, press)
        slide(s, inside, t, piece, slope, base, grip, weight)
    return forward and not there
