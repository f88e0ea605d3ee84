"""Samples of a record that are passed without series, by masses at rest and by frozen masses in motion.

If only one piecewise linear function of time changes, net moment and normal force are linear in its value. This applies
to a mass at rest, and to a moving mass with constant geometry and friction.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    Kind,
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
    breaks_at,
    greatest,
    last_quiet,
    maximum,
    minimum,
    none_of,
    number,
    read_samples,
    sqrt,
    where,
)
from derive.flow.integrator.phases import advance_origin, count_phase, keep_faster, update_reach
from derive.flow.integrator.series import normal_force
from derive.flow.integrator.tables import pass_break, pass_breaks

SURE = 1.0 - 2.0**-20  # fraction of a margin that may be used; series decide the rest
SIXTH = 1.0 / 6.0
ROUNDINGS = 2.0**27  # least margin, in roundings of its terms


def stand_before(s: Lanes, here: M, t: T, piece: V, now: V) -> None:
    """Place lanes at the left end of a piece, which they have not entered yet."""
    s.time = now
    t.piece = piece - 1.0
    t.way = INFINITY


# --- at rest ---------------------------------------------------------------------------------------------------------


def keep_quiet(s: Lanes, here: M, t: T, p: S, sign: V, terms: V) -> None:
    """Bound the values of the function of time, without its factor, for which sign p certainly keeps its sign.

    p is linear in the function.
    """
    now = (t.value + t.inc) / t.scaled_by
    rise = t.rise / t.scaled_by
    level = t.rise == 0.0
    way = sign * p[1] * rise
    room = SURE * p[0] * rise / p[1]
    bound = where(level, now, now - room)
    straight = p[2] == 0.0 and s.series_order <= 4.0
    rounding = ROUNDINGS * terms
    sure = straight and sign * p[0] > rounding and s.lifted == 0.0
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


def latest_end(s: Lanes, t: T) -> V:
    """Return the place in a record, up to rounding, at which the end time is reached."""
    return s.end_time * t.scale * (1.0 - 4.0 * EPS)


def rest_through(s: Lanes, here: M, t: T) -> None:
    """Pass the pieces through which masses certainly rest, as both end values are in the quiet range.

    The following piece must end before the end time, so that the function cannot jump between both.
    """
    piece = last_quiet(s, here, t, latest_end(s, t))
    passes = here and piece > t.piece
    now = breaks_at(s, t, piece) / t.scale
    if s.samples:
        read_samples(s, passes, s.time, now, 0, 0)
    stand_before(s, passes, t, piece, now)


def enter_pieces(s: Lanes, here: M) -> None:
    """Enter the next pieces of functions of time, or those after all pieces in which masses certainly rest."""
    for t in s.tables:
        if s.timed == 1 and t.kind == Kind.TIME and t.terms == 2:
            rest_through(s, here, t)
    pass_breaks(s, here)


# --- side by side ----------------------------------------------------------------------------------------------------
#
# Within a piece the time is a fraction of its length, and moments are multiplied by the length: they are the changes of
# the speed that they would cause.


def path(time: V, omega: V, net: V, rise: V) -> V:
    """Return the path over the length of a piece after a time at a speed, with a net moment that rises linearly."""
    by_rise = SIXTH * time * rise
    by_net = 0.5 * net + by_rise
    mean = omega + time * by_net
    return time * mean


def standstill(omega: V, net: V, rise: V) -> V:
    """Return the first time at which a falling speed is zero."""
    square = net * net
    decrease = 2.0 * rise * omega
    left = maximum(square - decrease, 0.0)
    root = sqrt(left)
    falls = net <= 0.0
    over = where(falls, 2.0 * omega, net + root)
    under = where(falls, root - net, 0.0 - rise)
    return over / under


def end_slide(s: Lanes, here: M, t: T, piece: N, x: V, omega: V) -> None:
    """Place lanes at the left end of a piece, at rest or in motion. Another phase begins there."""
    s.x = x
    s.omega = omega
    s.steps = 0.0
    s.passed = Passed.NOTHING
    moves = omega > 0.0
    s.status = where(moves, Status.MOVING, Status.RESTING)
    s.time = where(moves, s.time, s.rest_since)
    update_reach(s, here and not moves)
    advance_origin(s, here)
    stand_before(s, here, t, number(piece), t.places[piece] / t.scale)
    pass_break(s, here, t)
    s.pending = Pending.BEGIN_PHASE


def pass_part(s: Lanes, here: M, now: V, length: V, span: V, omega: V, net: V, rise: V) -> tuple[V, V]:
    """Pass a part of a piece in which the net moment keeps its sign; return the speed at its end and the path.

    Lanes start at its beginning, or stop within it. ``span`` and path are over the length of the piece.
    """
    mean = net + 0.5 * span * rise
    end = omega + span * mean
    moves = omega > 0.0
    goes_on = end > 0.0
    count_phase(s, here and goes_on and not moves)
    time = 1.0 * span
    stops = here and moves and not goes_on
    if any_lane(stops):
        time = where(stops, standstill(omega, net, rise), span)
        s.rest_since = where(stops, now + length * time, s.rest_since)
    way = path(time, omega, net, rise)
    slides = moves or goes_on
    return where(goes_on, end, 0.0), where(slides, way, 0.0)


def pass_change(s: Lanes, here: M, now: V, length: V, x: V, omega: V, net: V, after: V) -> tuple[V, V]:
    """Pass a piece in which lanes start, stop, or have their greatest or lowest speed.

    Return the speed at its end and the path over its length. Where the net moment changes its sign the piece has two
    parts.
    """
    rise = after - net
    changes = here and (net > 0.0) != (after > 0.0)
    share = where(changes, -net / rise, 1.0)
    speed, way = pass_part(s, here, now, length, share, omega, net, rise)
    until = now + length * share
    keep_faster(s, changes and net > 0.0, speed, until, x + length * way, 0.0)
    end, further = pass_part(s, changes, until, length, 1.0 - share, speed, 0.0, rise)
    return where(changes, end, speed), way + where(changes, further, 0.0)


def pass_piece(s: Lanes, here: M, now: V, length: V, x: V, omega: V, net: V, after: V) -> tuple[V, V]:
    """Return the speed at the end of a piece and the path over its length; lanes outside the mask ``here`` rest."""
    twice = net + after
    by_rates = net + twice
    end = where(here, omega + 0.5 * twice, 0.0)
    way = where(here, omega + SIXTH * by_rates, 0.0)
    changes = (net > 0.0) != (after > 0.0)
    moves = omega > 0.0 and end > 0.0
    turns = here and (changes or not moves)
    if any_lane(turns):
        speed, further = pass_change(s, turns, now, length, x, omega, net, after)
        end = where(turns, speed, end)
        way = where(turns, further, way)
    return end, way


def passes(s: Lanes, t: T, piece: N, before: V) -> M:
    """Return the lanes for which a piece ends before a place and not at the last break, where the record may jump."""
    inside = none_of(s)
    if piece + 2 < t.pieces:
        inside = t.places[piece + 2] < before
    return inside


def end_of(s: Lanes, t: T, piece: N, per: V) -> V:
    """Return the time at which a piece ends, where ``per`` is 1 over the scale."""
    return t.places[piece + 1] * per


def height_after(s: Lanes, t: T, piece: N) -> V:
    """Return the value of a record, without its factor, at the right end of a piece."""
    return t.heights[2 * piece + 2]


def rests_through(s: Lanes, t: T, piece: N, before: V) -> M:
    """Return the lanes that certainly rest in a piece if they rest at its left end, and that do not leave after it.

    They leave where the following piece does not end before a place.
    """
    height = height_after(s, t, piece)
    quiet = s.quiet_from <= height and height <= s.quiet_to
    return quiet and t.places[piece + 2] < before


def last_at_rest(s: Lanes, on: M, t: T, piece: N, before: V) -> N:
    """Return the last piece through which all lanes certainly rest, from a piece at rest on."""
    last: N = piece
    while last + 3 < t.pieces and not any_lane(on and not rests_through(s, t, last + 1, before)):
        last = last + 1
    return last


def keep_sliding(s: Lanes, on: M, t: T, piece: N, before: V, press: V, x: V, omega: V) -> M:
    """End the slide of lanes that may lift or end in the next piece, and return the other lanes."""
    inside = passes(s, t, piece, before) and press > 0.0
    leaves = on and not inside
    end_slide(s, leaves, t, piece, x, omega)
    return on and inside


def slide(s: Lanes, here: M, t: T, first: N, slope: V, base: V, grip: V, weight: V) -> None:
    """Move lanes at rest through the pieces of a record, exactly: omega is quadratic in time, and x cubic.

    The net moment is ``base`` + ``slope`` times the record, the normal force is ``weight`` + ``grip`` times the record,
    which is without its factor. A lane leaves before a piece in which it may lift.
    """
    per = 1.0 / t.scale
    before = latest_end(s, t)
    piece: N = first
    now: V = s.time
    net: V = s.series.net[0]
    omega: V = 0.0
    x: V = 0.0
    on: M = here
    while any_lane(on):
        until = end_of(s, t, piece, per)
        after = base + slope * height_after(s, t, piece)
        drives = net > 0.0 or after > 0.0
        acts = on and (omega > 0.0 or drives)
        if any_lane(acts):
            length = until - now
            at_first = length * net
            at_last = length * after
            speed, way = pass_piece(s, acts, now, length, x, omega, at_first, at_last)
            omega = speed
            x = x + length * way
        if not any_lane(acts):
            piece = last_at_rest(s, on, t, piece, before)
            until = end_of(s, t, piece, per)
            after = base + slope * height_after(s, t, piece)
        now = until
        net = after
        piece = piece + 1
        press = weight + grip * height_after(s, t, piece)
        on = keep_sliding(s, on, t, piece, before, press, x, omega)


def slide_together(s: Lanes, here: M, t: T) -> M:
    """Move lanes that rest in the same piece, down-slope; return lanes that follow in a later round.

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
    forward = here and straight and t.rise != 0.0
    piece: N = greatest(where(forward, t.piece, -1.0))
    same = t.piece == number(piece)
    there = forward and same
    if any_lane(there):
        ahead = t.value + t.lower
        press = weight + grip * ahead
        before = latest_end(s, t)
        inside = there and passes(s, t, piece, before) and press > 0.0
        by_height = slope * t.scaled_by
        grip_by_height = grip * t.scaled_by
        slide(s, inside, t, piece, by_height, base, grip_by_height, weight)
    return forward and not there
