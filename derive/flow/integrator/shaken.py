"""Samples of a record that a turning mass passes by short series, each lane at its own time.

Under constant friction, if one piecewise linear function of time changes, net moment and normal force are sums of a
constant, sin(x) and 1 - cos(x), with factors that are linear in the value of the function, and of omega^2. A piece of
a record is so short that a few orders suffice, which need neither operations on registers nor a radius of convergence.
"""

from derive.flow.integrator.one_lane import (
    INFINITY,
    Event,
    Lanes,
    M,
    N,
    Pending,
    S,
    Status,
    T,
    V,
    any_lane,
    breaks_at,
    minimum,
    new_series,
    none_of,
    number,
    up,
    where,
)
from derive.flow.integrator.phases import advance_origin, count_phase, keep_faster, update_reach
from derive.flow.integrator.records import enter_pieces, look_for_quiet
from derive.flow.integrator.roots import increment, value_and_slope
from derive.flow.integrator.step import find_standstill, keep_peak
from derive.flow.integrator.tables import pass_break

TOP = 7  # order of the speed in a piece
SHORT = 2.0**-7  # path in a piece, and 32 times the change of its moments, up to which this order suffices
PRESSED = 0.01  # normal force over its terms, from which on it stays positive in a piece
SURELY = 4.0  # units of rounding of the drive above which a mass at rest starts


def at_rotation(s: Lanes, constant: V, sine: V, versine: V) -> V:
    """Return a sum with sine and 1 - cosine of the current rotation."""
    turned = sine * s.sine_x + versine * s.versine_x
    return constant + turned


def net_at_rest(s: Lanes) -> tuple[V, V]:
    """Return the net moment of a mass at rest where its phase began, and its rate with the function of time."""
    moment = at_rotation(s, s.drive, s.net_sine, s.net_vers)
    return moment, at_rotation(s, s.net_record, s.net_record_sine, s.net_record_vers)


def force_at_rest(s: Lanes) -> tuple[V, V]:
    """Return the normal force of a mass at rest where its phase began, and its rate with the function of time."""
    force = at_rotation(s, s.normal0, s.normal_sine, s.normal_vers)
    return force, at_rotation(s, s.normal_record, s.normal_record_sine, s.normal_record_vers)


def coefficient_of_product(p: S, q: S, n: N) -> V:
    """Return coefficient n of the product of two series."""
    total: V = 0
    for k in up(0, n):
        total = total + p[k] * q[n - k]
    return total


def expand_piece(s: Lanes, e: S, rise: S, sine: S, versine: S) -> None:
    """Compute the series of a piece from the factors of 1, sin(x) and 1 - cos(x), and from their rates."""
    x = s.series.x
    omega = s.series.omega
    net = s.series.net
    x[0] = s.x
    omega[0] = s.omega
    sine[0] = s.sine_x
    versine[0] = s.versine_x
    for n in up(0, TOP - 1):
        total = e[1] * sine[n] + e[2] * versine[n] + s.net_square * coefficient_of_product(omega, omega, n)
        if n == 0:
            total = total + e[0]
        if n == 1:
            total = total + rise[0]
        if n > 0:
            total = total + (rise[1] * sine[n - 1] + rise[2] * versine[n - 1])
        net[n] = total
        x[n + 1] = omega[n] * s.inverse[n + 1]
        omega[n + 1] = total * s.inverse[n + 1]
        along = omega[n] - coefficient_of_product(versine, omega, n)
        sine[n + 1] = along * s.inverse[n + 1]
        versine[n + 1] = coefficient_of_product(sine, omega, n) * s.inverse[n + 1]


def find_factors(s: Lanes, t: T, factors: S, rise: S) -> None:
    """Compute the factors of 1, sin(x) and 1 - cos(x) in the net moment, and their rates."""
    rise[0] = s.net_record * t.rise
    rise[1] = s.net_record_sine * t.rise
    rise[2] = s.net_record_vers * t.rise
    factors[0] = s.drive + s.net_record * t.inc
    factors[1] = s.net_sine + s.net_record_sine * t.inc
    factors[2] = s.net_vers + s.net_record_vers * t.inc


def pass_events(s: Lanes, here: M, left: V) -> V:
    """Shorten a step to a standstill, record a peak within it, and return the rate of the speed at its end."""
    omega = s.series.omega
    net = s.series.net
    s.step = left
    s.event = Event.NONE
    loss = left * minimum(net[0], 0.0)
    bend = left * left * abs(omega[2])
    slow = here and omega[0] > 0.0 and omega[0] + loss <= 2.0 * bend
    find_standstill(s, slow, TOP)
    step = s.step
    rate, slope = value_and_slope(net, TOP - 1, step)
    most = omega[0] + step * net[0]
    peaks = here and rate <= 0.0 and net[0] > 0.0 and most > abs(s.peak_omega)
    keep_peak(s, peaks, TOP, rate, slope)
    return rate


def move_within(s: Lanes, here: M, t: T) -> None:
    """Move lanes to the end of a piece, or to a standstill within it."""
    factors = new_series()
    rise = new_series()
    sine = new_series()
    versine = new_series()
    find_factors(s, t, factors, rise)
    expand_piece(s, factors, rise, sine, versine)
    rate = pass_events(s, here, t.upper - s.time)
    step = s.step
    omega = s.series.omega
    speed = omega[0] + increment(omega, TOP, step)
    stops = here and (s.event == Event.STANDSTILL or speed <= 0.0)
    s.x = s.x + increment(s.series.x, TOP, step)
    s.omega = where(stops, 0.0, speed)
    s.sine_x = s.sine_x + increment(sine, TOP, step)
    s.versine_x = s.versine_x + increment(versine, TOP, step)
    t.inc = t.inc + step * t.rise
    then = where(stops, s.time + step, t.upper)
    keep_faster(s, here, s.omega, then, s.x, rate)
    s.rest_since = where(stops, then, s.rest_since)
    s.time = then


def fits(s: Lanes, t: T) -> M:
    """Return whether masses are pressed through a piece, for which the series suffice, and not at the lowest place.

    The piece must end before the end time, and not at the last break, where the function may jump.
    """
    last: V = number(t.pieces - 1)
    beyond = breaks_at(s, t, minimum(t.piece + 2.0, last))
    inside = t.piece + 1.0 < last and beyond < INFINITY and t.upper < s.end_time
    size = s.driving_moment + abs(s.driving_moment_slope)
    drives = size * s.x < 0.5 * s.driving_moment
    length = t.upper - s.time
    turning = abs(s.net_record_sine) + abs(s.net_record_vers)
    moments = abs(s.net_sine) + abs(s.net_vers) + turning * abs(t.lower)
    path = length * (s.omega + 32.0 * length * moments)
    terms = abs(s.normal_load) + abs(s.normal_load_slope)
    force, by_record = force_at_rest(s)
    return inside and drives and path < SHORT and force + by_record * t.lower > PRESSED * terms


def wait_for_start(s: Lanes, here: M, t: T) -> M:
    """Advance lanes at rest to the start of their motion, and return the lanes that start in the piece they reach.

    The net moment is valid in contact. Lanes that may lift within a piece stay at its left end, where they leave.
    """
    net = s.series.net
    normal = s.series.normal
    moment, by_record = net_at_rest(s)
    force, force_by_record = force_at_rest(s)
    net[0] = moment + by_record * t.inc
    net[1] = by_record * t.rise
    net[2] = 0.0
    normal[0] = force + force_by_record * t.inc
    normal[1] = force_by_record * t.rise
    normal[2] = 0.0
    s.quiet_from = -INFINITY
    s.quiet_to = INFINITY
    look_for_quiet(s, here)
    enter_pieces(s, here)
    now = minimum(moment + by_record * t.inc, 0.0)
    then = moment + by_record * t.lower
    starts = here and then > SURELY * s.drive_scale and fits(s, t)
    share = where(starts, now / (now - then), 0.0)
    s.time = s.time + share * (t.upper - s.time)
    t.inc = t.inc + share * (t.lower - t.inc)
    return starts


def leave_series(s: Lanes, here: M, since: V) -> None:
    """Leave moving lanes to the integration in time, and begin another phase for lanes that rest after a motion."""
    moves = s.omega > 0.0
    s.status = where(moves, Status.MOVING, Status.RESTING)
    here = here and not moves and s.time > since
    s.steps = 0.0
    update_reach(s, here)
    advance_origin(s, here)
    s.pending = Pending.BEGIN_PHASE


def turn_through(s: Lanes, here: M, t: T) -> None:
    """Move lanes at rest through the pieces of a record, down-slope, as far as the series of a piece fit."""
    s.sine_x = 0.0
    s.versine_x = 0.0
    since: V = s.time
    while any_lane(here):
        moves = here and s.omega > 0.0
        rests = here and s.omega == 0.0
        starts = none_of(s)
        if any_lane(rests):
            starts = wait_for_start(s, rests, t)
        goes = starts or (moves and fits(s, t))
        leave_series(s, here and not goes, since)
        count_phase(s, starts and goes)
        here = goes
        move_within(s, here, t)
        pass_break(s, here and s.time == t.upper, t)
