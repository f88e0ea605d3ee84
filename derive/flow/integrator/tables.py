"""Pieces of tables: their ends, and their coefficients about the start of a phase.

Several functions of time may follow each other in one table, separated by a piece that begins at infinity. The first
piece of a lane selects its function.

A table is a piecewise function of slip, speed, rotation or time. For slip, speed and rotation a phase stores
coefficients in powers of the distance from its start, for time the increment since its start.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    A,
    Kind,
    Lane,
    Lanes,
    M,
    N,
    Pending,
    T,
    V,
    break_of,
    breaks_at,
    coefficients_of,
    cos,
    down,
    heights_at,
    integer,
    jump_of,
    jumps_at,
    log,
    maximum,
    minimum,
    none_of,
    number,
    numbers,
    sin,
    slopes_at,
    up,
    where,
)


def shift(terms: A, count: N, by: float) -> None:
    """Shift a polynomial to another origin: Taylor's shift by Horner's scheme."""
    for first in up(0, count - 2):
        for j in down(count - 2, first):
            terms[j] = terms[j] + by * terms[j + 1]


def value_within(lane: Lane, t: T, piece: int, local: float) -> float:
    """Return a function of time, a sine or a straight line, at a distance from the left end of a piece."""
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    change = terms[1] * local
    line = terms[0] + change
    value = terms[0] * sin(change + terms[2]) if t.sine else line
    return t.scaled_by * value


def since_break(lane: Lane, t: T, piece: int) -> float:
    """Return the distance of the current time from the left end of a piece, in the table's argument."""
    return lane.time * t.scale - break_of(lane, t, piece)


def value_now(lane: Lane, t: T) -> float:
    """Return a function of time at the current time."""
    piece = integer(t.piece)
    local = since_break(lane, t, piece)
    return value_within(lane, t, piece, local)


def expand_sine(lane: Lane, t: T, top: N) -> None:
    """Compute the series of a sine about the current time, as its increment since the phase began."""
    piece = integer(t.piece)
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    rate = terms[1]
    angle = rate * since_break(lane, t, piece) + terms[2]
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
    """Return the rise of a function of time over a distance ahead within its piece, in the table's argument."""
    piece = integer(t.piece)
    terms = numbers()
    coefficients_of(lane, t, piece, terms)
    slope = t.scaled_by * terms[1]
    t.rise = slope * t.scale
    if t.sine:  # A (sin(angle + r) - sin(angle)) = 2 A sin(r/2) cos(angle + r/2)
        half = 0.5 * terms[1] * past
        angle = terms[1] * since_break(lane, t, piece) + terms[2]
        change = 2.0 * sin(half) * cos(angle + half)
        return t.scaled_by * terms[0] * change
    return slope * past


def end_of_piece(lane: Lane, t: T, piece: int) -> float:
    """Return the end of a piece in the table's argument, infinity for the last piece."""
    last: N = t.pieces - 1
    following = minimum(piece + 1, last)
    return where(piece < last, break_of(lane, t, following), INFINITY)


def ends_by(lane: Lane, t: T, piece: int, argument: float, included: bool) -> bool:
    """Return whether a piece ends below an argument, or at it if a break belongs to the piece above."""
    end = end_of_piece(lane, t, piece)
    ends_there = end == argument and end < INFINITY
    return end < argument or (included and ends_there)


def piece_at(lane: Lane, t: T, first: int, argument: float, included: bool) -> int:
    """Return the piece that contains an argument, searched from a first piece on."""
    piece = first
    while ends_by(lane, t, piece, argument, included):
        piece = piece + 1
    return piece


def find_end_of_piece(lane: Lane, t: T, now: float) -> None:
    """Compute the end of the piece of a function of time and the increment there, with a single rounding."""
    piece = integer(t.piece)
    end = end_of_piece(lane, t, piece)
    t.upper = end / t.scale
    rise = rise_to(lane, t, where(end < INFINITY, end - now, 0.0))
    t.lower = t.inc + rise
    t.way = t.way + abs(rise)


def begin_in_time(lane: Lane, t: T) -> None:
    """Begin a phase: increments of a function of time are counted from now. It may jump at the left end of a piece.

    Within a piece the value and the rise to its end follow from the increment, since on a short ramp the rounding of
    the time times the slope is large.
    """
    t.value = t.value + t.inc
    t.lower = t.lower - t.inc
    t.inc = 0.0
    t.way = abs(t.lower)
    if t.upper <= lane.time:
        now = lane.time * t.scale
        before = integer(t.piece)
        piece = piece_at(lane, t, before, now * (1.0 + 2.0 * EPS), True)
        if piece > before:
            lane.scale_before = INFINITY
        t.piece = number(piece)
        t.way = 0.0
        t.value = value_now(lane, t)
        find_end_of_piece(lane, t, now)


def develop(lane: Lane, t: T, local: float, unit: float) -> None:
    """Compute the value at the start of a phase and the coefficients about it."""
    terms = numbers()
    coefficients_of(lane, t, integer(t.piece), terms)
    shift(terms, t.terms, local)
    factor = t.scaled_by
    t.value = factor * terms[0]
    for j in up(1, t.degree):
        factor = factor * unit
        t.coefficients[j - 1] = factor * terms[j] if j < t.terms else 0.0


def begin_in_rotation(lane: Lane, t: T) -> None:
    """Select the piece of a function of the rotation ahead in the direction of travel, which may be either."""
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
    """Select the piece of a function of slip, which ends ahead even if another function has just passed a break."""
    piece = integer(t.piece)
    edge = break_of(lane, t, piece)
    local = maximum(lane.slip * t.scale - edge, 0.0)
    ahead = end_of_piece(lane, t, piece) - edge - local
    t.upper = maximum(ahead / t.scale, EPS * lane.slip)
    develop(lane, t, local, t.scale)


def begin_in_speed(lane: Lane, t: T) -> None:
    """Select the piece of a polynomial of the logarithm of the speed. Piece 0, below the first speed, is constant."""
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
    """Begin a phase: compute the ends of each table's piece, its value, and its coefficients."""
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
    """Find the pieces that contain slip and speed."""
    for t in lane.tables:
        if t.kind == Kind.SLIP:
            t.piece = number(piece_at(lane, t, 0, lane.slip * t.scale, True))
        if t.kind == Kind.SPEED:
            t.piece = number(piece_at(lane, t, 0, lane.omega * t.scale, True))


def pass_break(lane: Lane, t: T) -> None:
    """Enter the next piece of a function of time. If its value jumps, the contact must be checked.

    Increments accumulate rounding along a record. Beyond some path the difference of two values is more accurate.
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
    """Enter the next piece of each function of time that has a break now."""
    for t in lane.tables:
        if t.kind == Kind.TIME and t.upper <= lane.time:
            pass_break(lane, t)


def enter_line(s: Lanes, here: M, t: T) -> None:
    """Enter the next piece of a piecewise linear function of time, side by side, as `pass_break` does."""
    last: V = number(t.pieces - 1)
    piece = minimum(t.piece + 1.0, last)
    edge = breaks_at(s, t, piece)
    next_piece = minimum(piece + 1.0, last)
    following = breaks_at(s, t, next_piece)
    end = where(piece < last, following, INFINITY)
    jump = jumps_at(s, t, piece) * t.scaled_by
    slope = slopes_at(s, t, piece) * t.scaled_by
    there = heights_at(s, t, piece) * t.scaled_by
    past = where(end < INFINITY, end - edge, 0.0)
    rise = slope * past
    way = t.way + abs(jump)
    rounding = abs(there) + abs(t.value)
    is_long = way > rounding
    carried = t.lower + jump
    difference = there - t.value
    inc = where(is_long, difference, carried)
    s.pending = where(jump != 0.0, Pending.DISCONTINUITY, s.pending)
    t.piece = piece
    t.inc = inc
    t.upper = end / t.scale
    t.rise = slope * t.scale
    t.lower = inc + rise
    way = where(is_long, rounding, way)
    t.way = way + abs(rise)


def enter_lines(s: Lanes, here: M) -> M:
    """Enter the next pieces of functions of time that have a break now; return lanes in which a sine has one."""
    others = none_of(s)
    for t in s.tables:
        if t.kind == Kind.TIME:
            ends = here and t.upper <= s.time
            if t.sine:
                others = others or ends
            if not t.sine:
                enter_line(s, ends, t)
    return others


def still_changes(s: Lanes) -> M:
    """Return whether a force will still change while lanes rest."""
    changes = none_of(s)
    for t in s.tables:
        if t.kind == Kind.TIME:
            changes = changes or t.upper < INFINITY
    return changes


def next_break(s: Lanes) -> V:
    """Return the next time at which a function of time has a break."""
    time: V = INFINITY
    for t in s.tables:
        if t.kind == Kind.TIME:
            time = minimum(t.upper, time)
    return time
