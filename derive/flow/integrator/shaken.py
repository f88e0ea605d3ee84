"""Samples of a record that a turning mass passes by short series, at rest and in motion.

Under constant friction, if one piecewise linear function of time changes, net moment and normal force are sums of a
constant, sin(x) and 1 - cos(x), with factors that are linear in the value of the function, and of omega^2. A piece of
a record is so short that a few orders suffice, which need neither operations on registers nor a radius of convergence.
"""

from derive.flow.integrator.one_lane import (
    Event,
    Lanes,
    M,
    S,
    T,
    V,
    any_lane,
    breaks_at,
    heights_at,
    minimum,
    new_series,
    number,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster
from derive.flow.integrator.records import count_starts, end_slide, latest_end
from derive.flow.integrator.roots import increment, value, value_and_slope
from derive.flow.integrator.step import find_standstill, keep_peak

TOP = 7  # order of the speed in a piece
SHORT = 2.0**-7  # path in a piece, and 32 times the path of all forces there, up to which this order suffices
PRESSED = 0.01  # normal force over its terms, from which on it stays positive in a piece
SURELY = 4.0  # units of rounding of the drive above which a mass at rest starts


def factors_at(s: Lanes, e: S, change: V) -> None:
    """Compute the factors of 1, sin(x) and 1 - cos(x) in the net moment after a change of the function of time."""
    e[0] = s.drive + s.net_record * change
    e[1] = s.net_sine + s.net_record_sine * change
    e[2] = s.net_vers + s.net_record_vers * change


def net_at_rest(s: Lanes, e: S) -> V:
    """Return the net moment of a mass at rest from its factors."""
    turned = e[1] * s.sine_x + e[2] * s.versine_x
    return e[0] + turned


def pressed(s: Lanes, change: V) -> M:
    """Return whether the normal force of a mass at rest is clearly positive after a change of the function of time."""
    of_sine = s.normal_sine + s.normal_record_sine * change
    of_versine = s.normal_vers + s.normal_record_vers * change
    turned = of_sine * s.sine_x + of_versine * s.versine_x
    force = s.normal0 + s.normal_record * change + turned
    return force > PRESSED * (abs(s.normal_load) + abs(s.normal_load_slope))


def expand_piece(s: Lanes, e: S, rise: S, sine: S, versine: S) -> None:
    """Compute the series of a piece from the factors of the net moment and their rates."""
    x = s.series.x
    omega = s.series.omega
    net = s.series.net
    x[0] = s.x
    omega[0] = s.omega
    sine[0] = s.sine_x
    versine[0] = s.versine_x
    for n in up(0, TOP - 1):
        square: V = 0.0
        along = omega[n]
        across: V = 0.0
        for k in up(0, n):
            square = square + omega[k] * omega[n - k]
            along = along - versine[k] * omega[n - k]
            across = across + sine[k] * omega[n - k]
        total = e[1] * sine[n] + e[2] * versine[n] + s.net_square * square
        if n == 0:
            total = total + e[0]
        if n == 1:
            total = total + rise[0]
        if n > 0:
            total = total + (rise[1] * sine[n - 1] + rise[2] * versine[n - 1])
        net[n] = total
        x[n + 1] = omega[n] * s.inverse[n + 1]
        omega[n + 1] = total * s.inverse[n + 1]
        sine[n + 1] = along * s.inverse[n + 1]
        versine[n + 1] = across * s.inverse[n + 1]


def start_within(s: Lanes, here: M, e: S, f: S, until: V) -> None:
    """Advance lanes at rest to the time within a piece at which their net moment is zero, where they start."""
    now = net_at_rest(s, e)
    then = net_at_rest(s, f)
    share = where(here and now < 0.0, now / (now - then), 0.0)
    for k in up(0, 2):
        e[k] = e[k] + share * (f[k] - e[k])
    s.time = s.time + share * (until - s.time)
    count_starts(s, here)


def move_within(s: Lanes, here: M, e: S, f: S, until: V) -> None:
    """Move lanes to the end of a piece or to a standstill within it.

    ``e`` and ``f`` are the factors of the net moment now and at the end of the piece.
    """
    rise = new_series()
    sine = new_series()
    versine = new_series()
    left = until - s.time
    per = 1.0 / left
    for k in up(0, 2):
        rise[k] = per * (f[k] - e[k])
    expand_piece(s, e, rise, sine, versine)
    omega = s.series.omega
    net = s.series.net
    s.step = left
    s.event = Event.NONE
    loss = left * minimum(net[0], 0.0)
    bend = left * left * abs(omega[2])
    slow = here and omega[0] > 0.0 and omega[0] + loss <= 2.0 * bend
    if any_lane(slow):
        find_standstill(s, slow, TOP)
    step = s.step
    most = omega[0] + step * net[0]
    rate = value(net, TOP - 1, step)
    peaks = here and net[0] > 0.0 and rate <= 0.0 and most > abs(s.peak_omega)
    if any_lane(peaks):
        again, slope = value_and_slope(net, TOP - 1, step)
        keep_peak(s, peaks, TOP, again, slope)
    speed = omega[0] + increment(omega, TOP, step)
    stops = here and (s.event == Event.STANDSTILL or speed <= 0.0)
    s.x = s.x + increment(s.series.x, TOP, step)
    s.omega = where(stops, 0.0, speed)
    s.sine_x = s.sine_x + increment(sine, TOP, step)
    s.versine_x = s.versine_x + increment(versine, TOP, step)
    for k in up(0, 2):
        e[k] = e[k] + where(here, step * rise[k], 0.0)
    then = where(stops, s.time + step, until)
    keep_faster(s, here, s.omega, then, s.x, rate)
    s.rest_since = where(stops, then, s.rest_since)
    s.time = then


def pass_part(s: Lanes, here: M, e: S, f: S, until: V) -> M:
    """Pass a piece, or a part of it up to a standstill; return the lanes that have stopped within it."""
    rests = s.omega == 0.0
    starts = here and rests and net_at_rest(s, f) > SURELY * s.drive_scale
    if any_lane(starts):
        start_within(s, starts, e, f, until)
    acts = here and (starts or not rests)
    if any_lane(acts):
        move_within(s, acts, e, f, until)
    return acts and s.time < until


def fits(s: Lanes, t: T, piece: V, f: S, until: V, change: V) -> M:
    """Return whether masses are pressed through a piece, for which the series suffice, and not at the lowest place.

    The piece must end before the end time, and not at the last break, where the function may jump.
    """
    last: V = number(t.pieces - 1)
    beyond = breaks_at(s, t, minimum(piece + 2.0, last))
    inside = piece + 1.0 < last and beyond < latest_end(s, t)
    near = abs(s.driving_moment_slope) * s.x < 0.5 * s.driving_moment and s.x < 0.5
    length = until - s.time
    forces = abs(f[0]) + abs(f[1]) + abs(f[2])
    path = length * (s.omega + 32.0 * length * forces)
    return inside and near and path < SHORT and pressed(s, change)


def turn_through(s: Lanes, here: M, t: T) -> None:
    """Move lanes at rest through the pieces of a record, down-slope, as far as they fit.

    A lane leaves at the left end of a piece, where another phase begins.
    """
    per = 1.0 / t.scale
    last: V = number(t.pieces - 1)
    e = new_series()
    f = new_series()
    s.sine_x = 0.0
    s.versine_x = 0.0
    factors_at(s, e, t.inc)
    piece = t.piece
    until = t.upper
    change = t.lower
    while any_lane(here):
        factors_at(s, f, change)
        fit = fits(s, t, piece, f, until, change)
        leaves = here and not fit and piece > t.piece
        if any_lane(leaves):
            end_slide(s, leaves, t, piece, s.x, s.omega)
        here = here and fit
        acts = here
        while any_lane(acts):
            acts = pass_part(s, acts, e, f, until)
        s.time = until
        for k in up(0, 2):
            e[k] = f[k]
        piece = minimum(piece + 1.0, last)
        following = minimum(piece + 1.0, last)
        until = per * breaks_at(s, t, following)
        change = t.scaled_by * heights_at(s, t, following) - t.value
