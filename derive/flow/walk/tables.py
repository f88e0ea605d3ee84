"""The piece of each table in which a lane is: its ends, and its coefficients about the start of a phase.

Several functions of time may follow each other in one table, with a piece between them that begins at infinity: a lane
has the one with whose first piece it begins.

A table is a function in pieces of slip, speed, rotation or time. Of the first three a phase holds the coefficients in
powers of what is beyond its start; of time the increment since.
"""

from derive.flow.walk.one_lane import (
    EPS,
    INFINITY,
    A,
    Kind,
    Lane,
    Lanes,
    N,
    Pending,
    T,
    V,
    break_of,
    coefficients_of,
    cos,
    down,
    integer,
    jump_of,
    log,
    maximum,
    minimum,
    number,
    numbers,
    sin,
    up,
    where,
)


def shift(terms: A, count: N, by: float) -> None:
    """The same polynomial about another point: Taylor's shift by Horner's scheme."""
    for first in up(0, count - 2):
        for j in down(count - 2, first):
            terms[j] = terms[j] + by * terms[j + 1]


def value_within(lane: Lane, t: T, piece: int, local: float) -> float:
    """A function of time so far beyond where a piece begins, in the table's own argument: a sine or a straight line."""
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    change = terms[1] * local
    return t.scaled_by * (terms[0] * sin(change + terms[2]) if t.sine else terms[0] + change)


def value_now(lane: Lane, t: T) -> float:
    """A function of time now."""
    piece = integer(t.piece)
    return value_within(lane, t, piece, lane.time * t.scale - break_of(lane, t, piece))


def expand_sine(lane: Lane, t: T, top: N) -> None:
    """The series of a sine about now, as its increment since the phase began."""
    piece = integer(t.piece)
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    rate = terms[1]
    angle = rate * (lane.time * t.scale - break_of(lane, t, piece)) + terms[2]
    size = terms[0] * t.scaled_by
    now = sin(angle)
    slope = cos(angle)
    for j in up(1, top):
        size = size * (rate * t.scale / number(j))
        t.series[j] = size * slope
        before = now
        now = slope
        slope = -before


def rise_to(lane: Lane, t: T, past: float) -> float:
    """What a function of time rises by from now to some way beyond, in the table's own argument, within its piece."""
    piece = integer(t.piece)
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    slope = t.scaled_by * terms[1]
    t.rise = slope * t.scale
    if t.sine:  # A (sin(angle + r) - sin(angle)) = 2 A sin(r/2) cos(angle + r/2)
        half = 0.5 * terms[1] * past
        angle = terms[1] * (lane.time * t.scale - break_of(lane, t, piece)) + terms[2]
        return 2.0 * t.scaled_by * terms[0] * sin(half) * cos(angle + half)
    return slope * past


def end_of_piece(lane: Lane, t: T, piece: int) -> float:
    """Where a piece ends, in the table's own argument; infinity after the last one."""
    last: N = t.pieces - 1
    return where(piece < last, break_of(lane, t, minimum(piece + 1, last)), INFINITY)


def ends_by(lane: Lane, t: T, piece: int, argument: float, included: bool) -> bool:
    """Whether a piece ends below an argument, or at it if a break belongs to the piece above."""
    end = end_of_piece(lane, t, piece)
    return end < argument or (included and end == argument and end < INFINITY)


def piece_at(lane: Lane, t: T, first: int, argument: float, included: bool) -> int:
    """The piece in which an argument is, from the first one on that it may be."""
    piece = first
    while ends_by(lane, t, piece, argument, included):
        piece = piece + 1
    return piece


def find_end_of_piece(lane: Lane, t: T, now: float) -> None:
    """The end of the piece of a function of time and the increment there: one rounding whatever the steps."""
    piece = integer(t.piece)
    end = end_of_piece(lane, t, piece)
    t.upper = end / t.scale
    rise = rise_to(lane, t, where(end < INFINITY, end - now, 0.0))
    t.lower = t.inc + rise
    t.way = t.way + abs(rise)


def begin_in_time(lane: Lane, t: T) -> None:
    """Begin a phase: increments of a function of time count from now. It may jump where a piece begins.

    Within a piece the value and the rise to its end follow from the increment: on a short ramp the rounding of the
    time, times the slope, is much.
    """
    t.value = t.value + t.inc
    t.lower = t.lower - t.inc
    t.inc = 0.0
    t.way = abs(t.lower)
    if t.upper <= lane.time:
        now = lane.time * t.scale
        piece = piece_at(lane, t, integer(t.piece), now * (1.0 + 2.0 * EPS), True)
        if piece > integer(t.piece):
            lane.scale_before = INFINITY
        t.piece = number(piece)
        t.way = 0.0
        t.value = value_now(lane, t)
        find_end_of_piece(lane, t, now)


def develop(lane: Lane, t: T, local: float, unit: float) -> None:
    """The value where the phase begins, so far beyond the break, and the coefficients of what is beyond."""
    terms = numbers()
    coefficients_of(lane, t, integer(t.piece), terms)
    shift(terms, t.terms, local)
    factor = t.scaled_by
    t.value = factor * terms[0]
    for j in up(1, t.degree):
        factor = factor * unit
        t.coefficients[j - 1] = factor * terms[j] if j < t.terms else 0.0


def begin_in_rotation(lane: Lane, t: T) -> None:
    """The piece ahead, in the direction of travel, of a function of the rotation, which goes either way."""
    rotation = lane.rotation
    up_to = lane.direction > 0.0
    piece = piece_at(lane, t, 0, rotation, up_to)
    t.piece = number(piece)
    local = rotation - break_of(lane, t, piece)
    ahead = end_of_piece(lane, t, piece) - rotation
    behind = where(piece > 0, local, INFINITY)
    t.upper = where(up_to, ahead, behind)
    develop(lane, t, local, lane.direction)


def begin_in_slip(lane: Lane, t: T) -> None:
    """The piece of a function of the slip, which ends ahead also where another function has just broken."""
    piece = integer(t.piece)
    edge = break_of(lane, t, piece)
    local = maximum(lane.slip * t.scale - edge, 0.0)
    t.upper = maximum((end_of_piece(lane, t, piece) - edge - local) / t.scale, EPS * lane.slip)
    develop(lane, t, local, t.scale)


def begin_in_speed(lane: Lane, t: T) -> None:
    """Polynomials of the logarithm of the speed; piece 0, below the first speed, is constant."""
    piece = integer(t.piece)
    edge = break_of(lane, t, piece)
    speed = lane.omega * t.scale
    varies = piece > 0
    moves = varies and speed > 0.0
    ratio = where(moves, speed / where(moves, edge, 1.0), 1.0)
    t.upper = end_of_piece(lane, t, piece) / t.scale
    t.lower = where(varies, edge / t.scale, 0.0)
    develop(lane, t, log(ratio), 1.0)


def begin_pieces(lane: Lane) -> None:
    """Begin a phase: the ends of each table's piece, its value, and the coefficients of what is beyond."""
    for t in lane.tables:
        if t.kind == Kind.TIME:
            begin_in_time(lane, t)
        if t.kind == Kind.ROTATION:
            begin_in_rotation(lane, t)
        if t.kind == Kind.SLIP:
            begin_in_slip(lane, t)
        if t.kind == Kind.SPEED:
            begin_in_speed(lane, t)


def find_pieces(lane: Lane) -> None:
    """The pieces in which slip and speed lie, wherever they came from."""
    for t in lane.tables:
        if t.kind == Kind.SLIP:
            t.piece = number(piece_at(lane, t, 0, lane.slip * t.scale, True))
        if t.kind == Kind.SPEED:
            t.piece = number(piece_at(lane, t, 0, lane.omega * t.scale, True))


def pass_break(lane: Lane, t: T) -> None:
    """Enter the next piece of a function of time; where its value jumps the lane has to look at its contact.

    Increments add their roundings up along a record: beyond some way the difference of two values is better known.
    """
    piece = integer(t.piece) + 1
    jump = jump_of(lane, t, piece) * t.scaled_by
    t.piece = number(piece)
    t.inc = t.lower + jump
    t.way = t.way + abs(jump)
    if jump != 0.0:
        lane.pending = Pending.DISCONTINUITY
    there = value_within(lane, t, piece, 0.0)
    rounding = abs(there) + abs(t.value)
    if t.way > rounding:
        t.inc = there - t.value
        t.way = rounding
    find_end_of_piece(lane, t, break_of(lane, t, piece))


def pass_breaks(lane: Lane) -> None:
    """Enter the next piece of each function of time that breaks now."""
    for t in lane.tables:
        if t.kind == Kind.TIME and t.upper <= lane.time:
            pass_break(lane, t)


def still_changes(lane: Lane) -> bool:
    """Whether a force will still change while the lane rests."""
    changes: bool = False
    for t in lane.tables:
        if t.kind == Kind.TIME:
            changes = changes or t.upper < INFINITY
    return changes


def next_break(s: Lanes) -> V:
    """The next time at which a function of time breaks."""
    time: V = INFINITY
    for t in s.tables:
        if t.kind == Kind.TIME:
            time = minimum(t.upper, time)
    return time
