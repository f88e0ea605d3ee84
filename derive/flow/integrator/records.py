"""Samples of a record that are passed without series.

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
    Pending,
    S,
    T,
    V,
    break_of,
    constant_of,
    integer,
    maximum,
    minimum,
    number,
    read_samples,
    where,
)
from derive.flow.integrator.phases import update_peak
from derive.flow.integrator.tables import end_of_piece, pass_break

SURE = 1.0 - 2.0**-20  # fraction of a margin that may be used; series decide the rest
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


# --- in motion -------------------------------------------------------------------------------------------------------


def glides_on(lane: Lane, omega: float, length: float, net: float, by_drive: float, by_load: float) -> bool:
    """Return whether the mass certainly moves, in contact, through a piece and is fastest at one of its ends.

    ``by_drive`` and ``by_load`` are the changes of net moment and normal force since the phase began.
    """
    after = lane.drive + by_drive
    # For one lane `minimum` would be a C library call for each sample of a record.
    lowest = where(net < after, net, after)
    slowest = omega + length * where(lowest < 0.0, lowest, 0.0)
    peaks = net >= 0.0 and after < 0.0 and omega + length * net >= abs(lane.peak_omega)
    moves = slowest > (1.0 - SURE) * omega and lane.normal0 + by_load > (1.0 - SURE) * abs(lane.normal0)
    return moves and not peaks


def glide(lane: Lane, t: T) -> None:
    """Pass the pieces in which the net moment is linear in time and no event occurs.

    The rates of net moment and normal force are taken from the preceding step.
    """
    rise = t.series[1]
    if lane.pending == Pending.READY and rise != 0.0 and lane.series.net[2] == 0.0 and lane.lifted == 0.0:
        slope = lane.series.net[1] / rise
        grip = 0.0 * slope
        if lane.has.normal:
            grip = lane.series.normal[1] / rise
        piece = integer(t.piece)
        x = lane.x
        omega = lane.omega
        now = lane.time
        net = lane.drive + slope * t.inc
        until = t.upper
        inc = t.lower
        while passes_quietly(lane, t, piece) and glides_on(lane, omega, until - now, net, slope * inc, grip * inc):
            length = until - now
            after = lane.drive + slope * inc
            x = x + length * (omega + length * (2.0 * net + after) / 6.0)
            omega = omega + length * (net + after) / 2.0
            now = until
            net = after
            piece = piece + 1
            until = break_of(lane, t, piece + 1) / t.scale
            inc = value_at_break(lane, t, piece + 1) - t.value
        if piece > integer(t.piece):
            lane.x = x
            lane.omega = omega
            update_peak(lane, net, now)
            stand_before(lane, t, piece, now)
            pass_break(lane, t)
