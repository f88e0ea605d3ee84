"""Pieces of tables: their ends, and their coefficients about the start of a phase.

Several functions of time may follow each other in one table, separated by a piece that begins at infinity. The first
piece of a lane selects its function.

A table is a piecewise function of slip, speed, rotation or time. For slip, speed and rotation a phase stores
coefficients in powers of the distance from its start, for time the increment since its start.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    Kind,
    Lanes,
    M,
    N,
    Pending,
    T,
    V,
    any_lane,
    breaks_at,
    coefficients_at,
    cos,
    jumps_at,
    log,
    maximum,
    minimum,
    new_series,
    none_of,
    number,
    sin,
    up,
    where,
)
from derive.flow.integrator.roots import increment, shift


def end_of_piece(s: Lanes, t: T, piece: V) -> V:
    """Return the end of a piece in the table's argument, infinity for the last piece."""
    last: V = number(t.pieces - 1)
    following = breaks_at(s, t, minimum(piece + 1.0, last))
    return where(piece < last, following, INFINITY)


def piece_at(s: Lanes, here: M, t: T, first: V, argument: V, included: M) -> V:
    """Return the piece that contains an argument, searched from a first piece on.

    A break belongs to the piece above where it is ``included``, otherwise to the piece below.
    """
    piece = 1.0 * first
    goes_on = here
    while any_lane(goes_on):
        end = end_of_piece(s, t, piece)
        ends_there = included and end == argument
        goes_on = goes_on and end < INFINITY and (end < argument or ends_there)
        piece = where(goes_on, piece + 1.0, piece)
    return piece


# --- functions of time -----------------------------------------------------------------------------------------------


def value_within(s: Lanes, t: T, piece: V, local: V) -> V:
    """Return a function of time, a sine or a straight line, at a distance from the left end of a piece."""
    height = coefficients_at(s, t, piece, 0)
    change = coefficients_at(s, t, piece, 1) * local
    value = height + change
    if t.sine:
        value = height * sin(change + coefficients_at(s, t, piece, 2))
    return t.scaled_by * value


def since_break(s: Lanes, t: T) -> V:
    """Return the distance of the current time from the left end of its piece, in the table's argument."""
    return s.time * t.scale - breaks_at(s, t, t.piece)


def value_now(s: Lanes, t: T) -> V:
    """Return a function of time at the current time."""
    local = since_break(s, t)
    return value_within(s, t, t.piece, local)


def expand_sine(s: Lanes, t: T) -> None:
    """Compute the series of a sine about the current time, as its increment since the phase began."""
    size = coefficients_at(s, t, t.piece, 0) * t.scaled_by
    rate = coefficients_at(s, t, t.piece, 1)
    angle = rate * since_break(s, t) + coefficients_at(s, t, t.piece, 2)
    now = sin(angle)
    slope = cos(angle)
    for j in up(1, s.highest):
        size = size * (rate * t.scale * s.inverse[j])
        t.series[j] = size * slope
        before = now
        now = slope
        slope = -before


def rise_of_step(s: Lanes, t: T) -> V:
    """Return the rise of a function of time over a step: of a sine by all terms, whatever the other lanes' orders."""
    last: N = s.highest if t.sine else 1
    return increment(t.series, last, s.step)


def rise_of_sine(s: Lanes, t: T, local: V, past: V) -> V:
    """Return the rise of a sine over a distance ahead of a place in its piece: 2 A sin(r/2) cos(angle + r/2)."""
    rate = coefficients_at(s, t, t.piece, 1)
    half = 0.5 * rate * past
    angle = rate * local + coefficients_at(s, t, t.piece, 2)
    change = 2.0 * sin(half) * cos(angle + half)
    return t.scaled_by * coefficients_at(s, t, t.piece, 0) * change


def find_end_of_piece(s: Lanes, here: M, t: T, local: V) -> None:
    """Compute the end of the piece of a function of time and the increment there, from a distance from its left end."""
    end = end_of_piece(s, t, t.piece)
    now = breaks_at(s, t, t.piece) + local
    past = where(end < INFINITY, end - now, 0.0)
    slope = coefficients_at(s, t, t.piece, 1) * t.scaled_by
    rise = slope * past
    if t.sine:
        rise = rise_of_sine(s, t, local, past)
    t.rise = slope * t.scale
    t.upper = end / t.scale
    t.lower = t.inc + rise
    t.way = t.way + abs(rise)


def enter_piece(s: Lanes, here: M, t: T) -> None:
    """Enter the piece that contains the current time, without a value that is carried."""
    now = s.time * t.scale
    piece = piece_at(s, here, t, t.piece, now * (1.0 + 2.0 * EPS), here)
    s.scale_before = where(piece > t.piece, INFINITY, s.scale_before)
    t.piece = piece
    t.way = 0.0
    t.value = value_now(s, t)
    find_end_of_piece(s, here, t, since_break(s, t))


def begin_in_time(s: Lanes, here: M, t: T) -> None:
    """Begin a phase: increments of a function of time are counted from now. It may jump at the left end of a piece.

    Within a piece the value and the rise to its end follow from the increment, since on a short ramp the rounding of
    the time times the slope is large.
    """
    t.value = t.value + t.inc
    t.lower = t.lower - t.inc
    t.inc = 0.0
    t.way = abs(t.lower)
    enter_piece(s, here and t.upper <= s.time, t)


def pass_break(s: Lanes, here: M, t: T) -> None:
    """Enter the next piece of a function of time. If its value jumps, the contact must be checked.

    Increments accumulate rounding along a record. Beyond some path the difference of two values is more accurate.
    """
    last: V = number(t.pieces - 1)
    piece = minimum(t.piece + 1.0, last)
    jump = jumps_at(s, t, piece) * t.scaled_by
    there = value_within(s, t, piece, 0.0)
    way = t.way + abs(jump)
    rounding = abs(there) + abs(t.value)
    is_long = way > rounding
    carried = t.lower + jump
    s.pending = where(jump != 0.0, Pending.DISCONTINUITY, s.pending)
    t.piece = piece
    t.inc = where(is_long, there - t.value, carried)
    t.way = where(is_long, rounding, way)
    find_end_of_piece(s, here, t, 0.0)


def pass_breaks(s: Lanes, here: M) -> None:
    """Enter the next piece of each function of time that has a break now."""
    for t in s.tables:
        if t.kind == Kind.TIME:
            pass_break(s, here and t.upper <= s.time, t)


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


# --- functions of slip, speed and rotation ---------------------------------------------------------------------------


def develop(s: Lanes, here: M, t: T, local: V, unit: V) -> None:
    """Compute the value at the start of a phase and the coefficients about it."""
    terms = new_series()
    for j in up(0, t.terms - 1):
        terms[j] = coefficients_at(s, t, t.piece, j)
    shift(terms, t.terms - 1, local)
    factor = 1.0 * t.scaled_by
    t.value = factor * terms[0]
    for j in up(1, t.degree):
        factor = factor * unit
        coefficient = factor * terms[j] if j < t.terms else 0.0
        t.coefficients[j - 1] = where(here, coefficient, t.coefficients[j - 1])


def begin_in_rotation(s: Lanes, here: M, t: T) -> None:
    """Select the piece of a function of the rotation ahead in the direction of travel, which may be either."""
    forward = s.direction > 0.0
    t.piece = piece_at(s, here, t, 0.0, s.rotation, forward)
    local = s.rotation - breaks_at(s, t, t.piece)
    ahead = end_of_piece(s, t, t.piece) - s.rotation
    behind = where(t.piece > 0.0, local, INFINITY)
    t.upper = where(forward, ahead, behind)
    develop(s, here, t, local, s.direction)


def begin_in_slip(s: Lanes, here: M, t: T) -> None:
    """Select the piece of a function of slip, which ends ahead even if another function has just passed a break."""
    edge = breaks_at(s, t, t.piece)
    local = maximum(s.slip * t.scale - edge, 0.0)
    ahead = end_of_piece(s, t, t.piece) - edge - local
    t.upper = maximum(ahead / t.scale, EPS * s.slip)
    develop(s, here, t, local, t.scale)


def begin_in_speed(s: Lanes, here: M, t: T) -> None:
    """Select the piece of a polynomial of the logarithm of the speed. Piece 0, below the first speed, is constant."""
    edge = breaks_at(s, t, t.piece)
    speed = s.omega * t.scale
    varies = t.piece > 0.0
    moves = varies and speed > 0.0
    ratio = where(moves, speed / where(moves, edge, 1.0), 1.0)
    t.upper = end_of_piece(s, t, t.piece) / t.scale
    t.lower = where(varies, edge / t.scale, 0.0)
    develop(s, here, t, log(ratio), 1.0)


def begin_pieces(s: Lanes, here: M) -> None:
    """Begin a phase: compute the ends of each table's piece, its value, and its coefficients."""
    for t in s.tables:
        if t.kind == Kind.TIME:
            begin_in_time(s, here, t)
        if t.kind == Kind.ROTATION:
            begin_in_rotation(s, here, t)
        if t.kind == Kind.SLIP:
            begin_in_slip(s, here, t)
        if t.kind == Kind.SPEED:
            begin_in_speed(s, here, t)


def find_pieces(s: Lanes, here: M) -> None:
    """Find the pieces that contain slip and speed."""
    for t in s.tables:
        if t.kind == Kind.SLIP:
            t.piece = piece_at(s, here, t, 0.0, s.slip * t.scale, here)
        if t.kind == Kind.SPEED:
            t.piece = piece_at(s, here, t, 0.0, s.omega * t.scale, here)
