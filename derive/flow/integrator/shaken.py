"""Samples of a record that a turning mass passes by short series, side by side with other lanes.

Under constant friction, and if only one piecewise linear function of time changes, net moment and normal force are
sums of a constant, of sin(x), of 1 - cos(x) and of omega^2. All factors but the last are linear in the value of the
function. A piece of a record is so short that series of a fixed low order suffice, which need no registers.
"""

from derive.flow.integrator.one_lane import (
    Lanes,
    M,
    N,
    Pending,
    S,
    T,
    V,
    any_lane,
    breaks_at,
    heights_at,
    none_of,
    down,
    greatest,
    maximum,
    minimum,
    new_series,
    number,
    up,
    where,
)
from derive.flow.integrator.phases import keep_faster
from derive.flow.integrator.records import count_starts, end_slide, latest_end, passes, slide
from derive.flow.integrator.roots import bracketed_root, differentiate, first_root, value
from derive.flow.integrator.series import normal_force

LAST_OF_PIECE = 7  # order of the series of the speed in a piece
LAST_TERMS = 2.0**-44  # last terms over the first ones of complete series
LONGEST_WAY = 2.0**-7  # path in a piece
PRESSED = 0.01  # normal force over its terms, from which on it stays positive in a piece
SURELY = 4.0  # units of rounding of the drive above which a mass at rest starts
# Places of the numbers of a motion: time, rotation, speed, their sine and 1 - cosine, and the rate of the speed.
TIME_NOW = 0
WAY_NOW = 1
SPEED_NOW = 2
SINE_NOW = 3
VERS_NOW = 4
RATE_NOW = 5


def forces_at(s: Lanes, e: S, change: V) -> None:
    """Compute the factors of the net moment of a mass at rest, after a change of the function of time."""
    e[0] = s.drive + s.net_record * change
    e[1] = s.net_sine + s.net_record_sine * change
    e[2] = s.net_vers + s.net_record_vers * change


def moment_at(e: S, z: S) -> V:
    """Return the net moment of a mass at rest from its factors."""
    by_sine = e[1] * z[SINE_NOW]
    return e[0] + (by_sine + e[2] * z[VERS_NOW])


def force_after(s: Lanes, z: S, change: V) -> V:
    """Return the normal force of a mass at rest, after a change of the function of time."""
    by_sine = (s.normal_sine + s.normal_record_sine * change) * z[SINE_NOW]
    by_vers = (s.normal_vers + s.normal_record_vers * change) * z[VERS_NOW]
    return s.normal0 + s.normal_record * change + (by_sine + by_vers)


def path_to(s: Lanes, u: S, share: V) -> V:
    """Return the path after a share of a piece, from the series of the speed."""
    total: V = 0.0
    for n in down(LAST_OF_PIECE, 0):
        total = total * share + u[n] * s.inverse[n + 1]
    return total * share


def expand_piece(s: Lanes, u: S, sine: S, versine: S, g: S) -> None:
    """Compute the series of speed, sine and versine. The unit of time is a piece, and ``g`` has the factors there."""
    for n in up(0, LAST_OF_PIECE - 1):
        net = g[1] * sine[n] + g[2] * versine[n]
        if n == 0:
            net = net + g[0]
        if n == 1:
            net = net + g[3]
        if n > 0:
            by_rise = g[4] * sine[n - 1] + g[5] * versine[n - 1]
            net = net + by_rise
        square: V = 0.0
        along: V = u[n]
        across: V = 0.0
        for k in up(0, n):
            square = square + u[k] * u[n - k]
            along = along - versine[k] * u[n - k]
            across = across + sine[k] * u[n - k]
        net = net + s.net_square * square
        u[n + 1] = net * s.inverse[n + 1]
        sine[n + 1] = along * s.inverse[n + 1]
        versine[n + 1] = across * s.inverse[n + 1]


def wait_for_start(s: Lanes, here: M, z: S, e: S, f: S, after: V, until: V) -> None:
    """Advance lanes at rest to the time within a piece at which their net moment is zero, where they start."""
    rate = moment_at(e, z)
    share = where(here and rate < 0.0, rate / (rate - after), 0.0)
    z[TIME_NOW] = z[TIME_NOW] + share * (until - z[TIME_NOW])
    for k in up(0, 2):
        e[k] = e[k] + share * (f[k] - e[k])
    z[RATE_NOW] = where(here, 0.0, z[RATE_NOW])
    count_starts(s, here)


def pass_top(s: Lanes, here: M, z: S, u: S, length: V, after: V) -> None:
    """Record the greatest speed in a piece in which the rate of the speed falls through zero, to ``after``."""
    rates = new_series()
    differentiate(rates, u, LAST_OF_PIECE)
    one: V = 1.0
    share = bracketed_root(rates, LAST_OF_PIECE - 1, 0.0 * one, z[RATE_NOW], one, after, here)
    speed = value(u, LAST_OF_PIECE, share) / length
    x = z[WAY_NOW] + path_to(s, u, share)
    keep_faster(s, here, speed, z[TIME_NOW] + length * share, x, 0.0)


def stop_within(s: Lanes, here: M, z: S, e: S, f: S, u: S, sine: S, versine: S, length: V) -> M:
    """Stop lanes within a piece, and return them."""
    one: V = 1.0
    share = first_root(u, LAST_OF_PIECE, one, here)
    stops = here and share <= 1.0
    share = where(stops, share, 0.0)
    z[TIME_NOW] = z[TIME_NOW] + length * share
    z[WAY_NOW] = z[WAY_NOW] + path_to(s, u, share)
    z[SPEED_NOW] = where(stops, 0.0, z[SPEED_NOW])
    z[SINE_NOW] = where(stops, value(sine, LAST_OF_PIECE, share), z[SINE_NOW])
    z[VERS_NOW] = where(stops, value(versine, LAST_OF_PIECE, share), z[VERS_NOW])
    for k in up(0, 2):
        e[k] = e[k] + share * (f[k] - e[k])
    s.rest_since = where(stops, z[TIME_NOW], s.rest_since)
    return stops


def pass_part(s: Lanes, here: M, t: T, piece: V, z: S, e: S, f: S, until: V) -> M:
    """Move lanes to the end of a piece, or to a standstill within it, and return lanes that have stopped.

    ``e`` and ``f`` are the factors of the net moment now and at the end of the piece.
    """
    waiting = moment_at(f, z)
    rests = z[SPEED_NOW] == 0.0
    starts = here and rests and waiting > SURELY * s.drive_scale
    if any_lane(starts):
        wait_for_start(s, starts, z, e, f, waiting, until)
    acts = here and (starts or not rests)
    if not any_lane(acts):
        return acts
    u = new_series()
    sine = new_series()
    versine = new_series()
    g = new_series()
    length = until - z[TIME_NOW]
    per = 1.0 / length
    scale = length * length
    for k in up(0, 2):
        g[k] = scale * e[k]
        g[k + 3] = scale * (f[k] - e[k])
    u[0] = length * z[SPEED_NOW]
    sine[0] = z[SINE_NOW]
    versine[0] = z[VERS_NOW]
    expand_piece(s, u, sine, versine, g)
    gain = u[1]
    way = u[0] + 0.5 * u[1]
    by_sine = sine[1]
    by_vers = versine[1]
    for n in up(2, LAST_OF_PIECE):
        gain = gain + u[n]
        way = way + u[n] * s.inverse[n + 1]
        by_sine = by_sine + sine[n]
        by_vers = by_vers + versine[n]
    largest = u[0] + (abs(u[1]) + abs(u[2]))
    last = abs(u[LAST_OF_PIECE]) + abs(u[LAST_OF_PIECE - 1])
    turns = abs(g[1]) + abs(g[2])
    complete = (turns + largest) * last <= LAST_TERMS * largest and largest < LONGEST_WAY
    leaves = acts and not complete
    if any_lane(leaves):
        s.clocked = where(leaves, 1.0, s.clocked)
        end_slide(s, leaves, t, piece, z[WAY_NOW], z[SPEED_NOW])
    acts = acts and complete
    speed = maximum((u[0] + gain) * per, 0.0)
    at_rest = f[0] + (f[1] * (sine[0] + by_sine) + f[2] * (versine[0] + by_vers))
    after = at_rest + s.net_square * (speed * speed)
    most = z[SPEED_NOW] + length * z[RATE_NOW]
    least = abs(s.peak_omega)
    peaks = acts and z[RATE_NOW] > 0.0 and after <= 0.0 and most > least
    if any_lane(peaks):
        pass_top(s, peaks, z, u, length, after)
    dips = z[RATE_NOW] < 0.0 and after > 0.0 and most <= 0.0
    asked = acts and (speed == 0.0 or dips)
    stops = asked
    if any_lane(asked):
        stops = stop_within(s, asked, z, e, f, u, sine, versine, length)
    goes = acts and not stops
    z[WAY_NOW] = z[WAY_NOW] + where(goes, way, 0.0)
    z[SPEED_NOW] = where(goes, speed, z[SPEED_NOW])
    z[SINE_NOW] = z[SINE_NOW] + where(goes, by_sine, 0.0)
    z[VERS_NOW] = z[VERS_NOW] + where(goes, by_vers, 0.0)
    z[RATE_NOW] = where(goes, after, z[RATE_NOW])
    return stops


def farthest_of(s: Lanes) -> V:
    """Return a rotation up to which weight certainly presses on the slip surface and drives down-slope."""
    by_drive = s.driving_moment / abs(s.driving_moment_slope)
    by_load = s.normal_load / abs(s.normal_load_slope)
    return 0.5 * minimum(1.0, minimum(by_drive, by_load))


def least_force(s: Lanes) -> V:
    """Return a normal force that stays positive through a piece."""
    return PRESSED * (abs(s.normal_load) + abs(s.normal_load_slope))


def turn_through(s: Lanes, here: M, t: T) -> None:
    """Move lanes at rest through the pieces of a record.

    A lane leaves before a piece in which it may lift, in which its chord may stand upright, or for which series are too
    short.
    """
    per = 1.0 / t.scale
    before = latest_end(s, t)
    farthest = farthest_of(s)
    least = least_force(s)
    z = new_series()
    e = new_series()
    f = new_series()
    last: V = number(t.pieces - 1)
    piece: V = t.piece
    z[TIME_NOW] = s.time
    for k in up(WAY_NOW, RATE_NOW):
        z[k] = 0.0
    forces_at(s, e, t.inc)
    until = t.upper
    change = t.lower
    beyond = breaks_at(s, t, minimum(piece + 2.0, last))
    on: M = here
    while any_lane(on):
        forces_at(s, f, change)
        acts = on
        while any_lane(acts):
            acts = pass_part(s, acts, t, piece, z, e, f, until)
        z[TIME_NOW] = until
        for k in up(0, 2):
            e[k] = f[k]
        piece = minimum(piece + 1.0, last)
        following = minimum(piece + 1.0, last)
        until = per * beyond
        beyond = breaks_at(s, t, minimum(piece + 2.0, last))
        change = t.scaled_by * heights_at(s, t, following) - t.value
        on = on and s.pending == Pending.READY
        inside = piece + 1.0 < last and beyond < before and z[WAY_NOW] < farthest and force_after(s, z, change) > least
        leaves = on and not inside
        if any_lane(leaves):
            end_slide(s, leaves, t, piece, z[WAY_NOW], z[SPEED_NOW])
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
    ahead = t.value + t.lower
    press = weight + grip * ahead
    before = latest_end(s, t)
    if s.has.net_record:
        last: V = number(t.pieces - 1)
        inside = t.piece + 1.0 < last and breaks_at(s, t, minimum(t.piece + 2.0, last)) < before
        calm = s.clocked == 0.0 and net[0] <= 0.0 and press > least_force(s)
        turn_through(s, forward and inside and calm, t)
        return none_of(s)
    piece: N = greatest(where(forward, t.piece, -1.0))
    same = t.piece == number(piece)
    there = forward and same
    if any_lane(there):
        inside = there and passes(s, t, piece, before) and press > 0.0
        by_height = slope * t.scaled_by
        grip_by_height = grip * t.scaled_by
        slide(s, inside, t, piece, by_height, base, grip_by_height, weight)
    return forward and not there
