"""Samples that are passed without series.

Where one function of time in straight lines is all that changes, the net moment and the normal force are straight lines
of its value: of a mass at rest, and of one whose geometry and friction stay as they are while it moves.
"""

from derive.flow.walk.one_lane import (
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
from derive.flow.walk.phases import update_peak
from derive.flow.walk.tables import end_of_piece, pass_break

SURE = 1.0 - 2.0**-20  # share of a margin that may be used up: the rest is left to series
ROUNDINGS = 2.0**27  # of its terms, which a margin exceeds


def passes_quietly(lane: Lane, t: T, piece: int) -> bool:
    """Whether a piece ends before the end time, and not at the last break: there, and at the first, it may jump."""
    last: N = t.pieces - 1
    following = minimum(piece + 1, last)
    ends = end_of_piece(lane, t, following) < INFINITY
    return ends and break_of(lane, t, following) < lane.end_time * t.scale * (1.0 - 4.0 * EPS)


def value_at_break(lane: Lane, t: T, piece: int) -> float:
    """A function of time in straight lines where a piece begins."""
    return t.scaled_by * constant_of(lane, t, piece)


def stand_before(lane: Lane, t: T, piece: int, now: float) -> None:
    """The lane is where a piece begins, which it has yet to enter."""
    lane.time = now
    t.piece = number(piece - 1)
    t.way = INFINITY


# --- at rest ---------------------------------------------------------------------------------------------------------


def keep_quiet(s: Lanes, here: M, t: T, p: S, sign: V, terms: V) -> None:
    """Bound the function of time where sign p, a straight line of it with such terms, keeps some of what it is."""
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
    """Between which values of one function of time the mass certainly rests on, the way it faces."""
    terms_of_normal = EPS * (abs(s.normal_load) + abs(s.normal_load_slope))
    for t in s.tables:
        if t.kind == Kind.TIME and t.terms == 2:
            keep_quiet(s, here, t, s.series.net, -1.0, s.drive_scale)
            if s.has.normal:
                keep_quiet(s, here, t, s.series.normal, 1.0, terms_of_normal)


def rests_on(lane: Lane, t: T, piece: int) -> bool:
    """Whether the mass certainly rests through a piece: what moves or lifts it is between its values at both ends."""
    last: N = t.pieces - 1
    value = value_at_break(lane, t, minimum(piece + 1, last))
    return lane.quiet_from <= value and value <= lane.quiet_to and passes_quietly(lane, t, piece)


def rest_through(lane: Lane, t: T) -> None:
    """Pass the pieces through which the mass certainly rests, up to where the last of them ends."""
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
    """Whether the mass certainly moves and presses through a piece, and its greatest speed is at an end of it.

    At the end net moment and normal force are by so much more than where the phase began.
    """
    after = lane.drive + by_drive
    # Of one lane `minimum` is a call of the C library, for each sample of a record.
    lowest = where(net < after, net, after)
    slowest = omega + length * where(lowest < 0.0, lowest, 0.0)
    peaks = net >= 0.0 and after < 0.0 and omega + length * net >= abs(lane.peak_omega)
    moves = slowest > (1.0 - SURE) * omega and lane.normal0 + by_load > (1.0 - SURE) * abs(lane.normal0)
    return moves and not peaks


def glide(lane: Lane, t: T) -> None:
    """Pass the pieces through which the net moment is a straight line of time, and nothing happens.

    The rates of net moment and normal force are those of the step before.
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
