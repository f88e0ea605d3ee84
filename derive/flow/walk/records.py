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
    coefficients_of,
    integer,
    jump_of,
    maximum,
    minimum,
    number,
    numbers,
    read_samples,
    where,
)
from derive.flow.walk.phases import update_peak
from derive.flow.walk.tables import pass_break

SURE = 1.0 - 2.0**-20  # share of a margin that may be used up: the rest is left to series
ROUNDINGS = 2.0**27  # of its terms, which a margin exceeds


def passes_quietly(lane: Lane, t: T, piece: int) -> bool:
    """Whether a piece ends before the end time, without a jump, and is followed by another one that ends."""
    last: N = t.pieces - 1
    following = minimum(piece + 1, last)
    in_time = break_of(lane, t, following) < lane.end_time * t.scale * (1.0 - 4.0 * EPS)
    return following < last and in_time and jump_of(lane, t, following) == 0.0


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
        if s.timed == 1 and t.kind == Kind.TIME and t.terms == 2:
            keep_quiet(s, here, t, s.series.net, -1.0, s.drive_scale)
            if s.has.normal:
                keep_quiet(s, here, t, s.series.normal, 1.0, terms_of_normal)


def rests_on(lane: Lane, t: T, piece: int) -> bool:
    """Whether the mass certainly rests through a piece: what moves or lifts it is between its values at both ends."""
    last: N = t.pieces - 1
    terms = numbers()
    coefficients_of(lane, t, minimum(piece + 1, last), terms)
    value = t.scaled_by * terms[0]
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
        lane.time = now
        t.piece = number(piece - 1)
        t.way = INFINITY


# --- in motion -------------------------------------------------------------------------------------------------------


def glides_on(lane: Lane, t: T, slope: float, grip: float) -> bool:
    """Whether the mass certainly moves and presses through a piece, and its greatest speed is at an end of it."""
    length = t.upper - lane.time
    net = lane.drive + slope * t.inc
    after = lane.drive + slope * t.lower
    slowest = lane.omega + length * minimum(minimum(net, after), 0.0)
    presses = lane.normal0 + minimum(grip * t.inc, grip * t.lower)
    peaks = net >= 0.0 and after < 0.0 and lane.omega + length * net >= abs(lane.peak_omega)
    moves = slowest > (1.0 - SURE) * lane.omega and presses > (1.0 - SURE) * abs(lane.normal0)
    return moves and not peaks and passes_quietly(lane, t, integer(t.piece))


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
        while glides_on(lane, t, slope, grip):
            length = t.upper - lane.time
            net = lane.drive + slope * t.inc
            after = lane.drive + slope * t.lower
            lane.x = lane.x + length * (lane.omega + length * (2.0 * net + after) / 6.0)
            lane.omega = lane.omega + length * (net + after) / 2.0
            lane.time = t.upper
            pass_break(lane, t)
        update_peak(lane, lane.drive + slope * t.inc)
