"""Phases: stick or slip at a standstill, and the numbers of the phase that begins.

The cell `pending` contains the action that a lane needs before its next step, such as the beginning of a phase.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    Lanes,
    M,
    Note,
    Passed,
    Pending,
    Share,
    Status,
    V,
    any_lane,
    maximum,
    minimum,
    note,
    prologue,
    read_samples,
    sqrt,
    where,
)
from derive.flow.integrator.series import ROUNDING, evaluate, find_negligible, normal_force
from derive.flow.integrator.tables import begin_pieces, find_pieces, still_changes

TIE = 256.0 * EPS  # relative difference up to which two peaks are equal
CLOSEST = 1e-300  # size of the terms of a drive, in units of rounding, if all are zero


def keep_faster(s: Lanes, here: M, speed: V, time: V, x: V, rate: V) -> None:
    """Record a candidate for the greatest speed in the current step if it exceeds the record.

    If the record is not at the beginning of the step, the difference must exceed rounding.
    """
    faster = here and speed > abs(s.peak_omega)
    if any_lane(faster):
        begins = s.peak_time == s.time
        clearly = speed > (1.0 + TIE) * abs(s.peak_omega)
        faster = faster and (begins or clearly)
        s.peak_omega = where(faster, s.direction * speed, s.peak_omega)
        s.peak_time = where(faster, time, s.peak_time)
        s.peak_rotation = where(faster, s.rotation + s.direction * x, s.peak_rotation)
        s.peak_rate = where(faster, s.direction * rate, s.peak_rate)


def update_reach(s: Lanes, here: M) -> None:
    """Record the current rotation if it is the greatest from the start."""
    rotation = s.rotation + s.direction * s.x
    here = here and abs(rotation) > abs(s.reach_rotation)
    s.reach_rotation = rotation
    s.reach_time = s.time


def note_lift_off(s: Lanes, here: M) -> None:
    """Log the loss of contact with the slip surface."""
    if s.logged:
        note(s, here, Note.LIFTS)
    here = here and s.lift_time != s.lift_time  # not yet a number
    s.lift_time = s.time


def advance_origin(s: Lanes, here: M) -> None:
    """Reset the origin of rotation and slip to the current position, where another phase begins."""
    s.rotation = s.rotation + s.direction * s.x
    s.slip = s.slip + s.x
    s.x = 0.0


def face(s: Lanes, here: M, side: V) -> None:
    """Set the direction of travel at a standstill."""
    s.x = 0.0
    s.omega = 0.0
    s.direction = side
    s.lifted = 0.0


def start(s: Lanes, here: M) -> None:
    """Start lanes with a velocity or at rest."""
    s.direction = where(s.omega < 0.0, -1.0, 1.0)
    s.omega = abs(s.omega)
    s.x = 0.0
    s.lifted = 0.0
    s.faced = 0.0
    moves = s.omega > 0.0
    s.pending = where(moves, Pending.START_MOVING, Pending.RESOLVE)
    s.clocked = 0.0
    s.negligible = ROUNDING  # of series in the rotation, since all runs of an estimate would lack equal terms
    if s.timed:
        find_negligible(s, here)
    find_pieces(s, here)


def count_phase(s: Lanes, here: M) -> None:
    """Count a phase that begins in the current direction."""
    turns = s.last_way * s.direction < 0.0
    s.phases = s.phases + 1.0
    s.turns = s.turns + where(turns, 1.0, 0.0)
    s.last_way = s.direction


def start_moving(s: Lanes, here: M, rate: V) -> None:
    """Start slip in the current direction."""
    s.status = Status.MOVING
    s.passed = Passed.NOTHING
    count_phase(s, here)
    if s.logged:
        note(s, here, Note.BEGINS)
    note_lift_off(s, here and s.lifted > 0.0)
    keep_faster(s, here, s.omega, s.time, s.x, rate)
    s.pending = Pending.READY


def stay(s: Lanes, here: M, status: V) -> None:
    """Keep lanes at rest until their end."""
    s.status = status
    s.end_rotation = s.rotation
    s.end_omega = 0.0
    s.end_rate = 0.0
    s.direction = 0.0
    s.rest_since = where(s.rest_since > s.end_time, s.end_time, s.rest_since)  # by rounding at most
    s.pending = Pending.READY
    for_ever: V = INFINITY
    if s.samples:
        read_samples(s, here, s.time, for_ever, 0, 0)


def may_start(s: Lanes) -> M:
    """Return whether masses at rest may start in their direction. Shaking starts a one-way mass only down-slope."""
    pull = s.driving_moment
    down_slope = pull > 0.0 or (pull == 0.0 and s.direction > 0.0)
    return s.one_way == 0.0 or down_slope


def never_rests(s: Lanes) -> M:
    """Return whether masses swing for ever, because almost no force presses on them at their lowest point."""
    load = s.normal_load
    slope = s.normal_load_slope
    square = load * load + slope * slope
    most = sqrt(square)
    least = s.normal0 + (most - load)
    carried = least <= Share.CARRIED * most
    return s.first_only == 1.0 or (carried and not still_changes(s))


def stick(s: Lanes, here: M) -> None:
    """Keep masses at rest, until a force changes or for good."""
    changes = still_changes(s)
    stay(s, here and not changes, Status.ARRESTED)
    here = here and changes
    s.status = Status.RESTING
    s.pending = Pending.READY
    note_lift_off(s, here and s.lifted > 0.0)
    here = here and not may_start(s)
    s.direction = -s.direction
    s.pending = Pending.BEGIN_PHASE


def rest_one_way(s: Lanes, here: M) -> None:
    """Let masses that moved down-slope stick, since they do not turn back, in the direction in which they may start."""
    may = may_start(s)
    stick(s, here and may)
    here = here and not may
    face(s, here, -s.direction)
    s.pending = Pending.RESOLVE


def resolve_stick_or_slip(s: Lanes, here: M) -> None:
    """Start slip in the current direction, otherwise in the other direction if it is allowed, otherwise stick."""
    terms = abs(s.driving) + s.resisting
    unsure = EPS * (terms + s.mu * abs(s.normal0))
    of_weight = s.driving == s.driving_moment and s.normal0 == s.normal_load
    of_weight = of_weight and s.resisting == 0.0
    refined = s.limit_rest * s.drive != 0.0 and of_weight
    unsure = maximum(where(refined, s.drive_scale, unsure), CLOSEST)
    may = here and may_start(s)
    margin = abs(s.drive) / unsure
    s.close = where(may, minimum(s.close, margin), s.close)
    starts = may and s.drive > 0.0
    start_moving(s, starts, s.drive)
    here = here and not starts
    s.faced = s.faced + 1.0
    stays_down = may and s.one_way > 0.0
    sticks = here and (s.faced > 1.0 or stays_down)
    stick(s, sticks)
    face(s, here and not sticks, -s.direction)


def resolve_standstill(s: Lanes, here: M) -> None:
    """Decide whether masses at a standstill, or at the start, stop, stick or slip."""
    stops = here and s.first_only > 0.0 and s.phases > 0.0
    if any_lane(stops):
        stops = stops and never_rests(s)
        stay(s, stops, Status.STOPPED)
        here = here and not stops
    one_way = here and s.pending == Pending.REST
    rest_one_way(s, one_way)
    resolve_stick_or_slip(s, here and not one_way)


def carry_net_moment(s: Lanes, here: M, net: V) -> None:
    """Begin a phase in motion with the drive computed anew or continued, whichever is more accurate."""
    s.pending = Pending.READY
    change = net - s.drive
    terms = abs(s.rate_before) + abs(change) + abs(s.drive_before)
    carried = s.scale_before + EPS * terms
    here = here and carried < s.drive_scale
    s.drive = s.drive + (s.rate_before - net)
    s.drive_scale = carried


def resolve_pending(s: Lanes, waits: M, net: V, force: V) -> None:
    """Begin the phases for which lanes wait, from their net moments and normal forces."""
    enters = waits and s.pending == Pending.ENTER_PHASE
    begins = waits and s.pending == Pending.BEGIN_PHASE
    moving = waits and s.pending == Pending.START_MOVING
    again = waits and s.pending == Pending.START_AGAIN
    decides = waits and not (enters or begins or moving or again)
    by_force = moving and force < 0.0
    at_rest = again or decides
    by_load = at_rest and s.normal0 <= 0.0
    lifts = (by_force or by_load) and s.lifted == 0.0
    s.lifted = where(lifts, 1.0, s.lifted)  # the phase begins again as a lifted mass
    s.pending = where(begins, Pending.READY, s.pending)
    carry_net_moment(s, enters, net)
    starts = (moving or again) and not lifts
    if any_lane(starts):
        level = again and starts and s.sudden <= 0.0
        s.drive = where(level, 0.0, s.drive)
        start_moving(s, starts, where(again, s.drive, net))
    resolve_standstill(s, decides and not lifts)


def on_discontinuity(s: Lanes, here: M, force: V) -> None:
    """Decide about contact after a jump of forces. If contact changes, another phase begins."""
    lifted = where(force < 0.0, 1.0, 0.0)
    same = s.lifted == lifted
    note_lift_off(s, here and lifted > s.lifted)
    s.pending = where(same, Pending.READY, Pending.BEGIN_PHASE)
    s.lifted = lifted
    advance_origin(s, here and not same)


def begin_phases(s: Lanes) -> None:
    """Begin all pending phases, until every lane is ready for a step."""
    sudden = s.pending == Pending.DISCONTINUITY
    if any_lane(sudden):
        evaluate(s)
        force = normal_force(s)
        on_discontinuity(s, sudden, force)
    waits = s.pending != Pending.READY
    while any_lane(waits):
        begin_pieces(s, waits)
        prologue(s, waits)
        if any_lane(s.pending == Pending.START_MOVING or s.pending == Pending.ENTER_PHASE):
            evaluate(s)
        force = normal_force(s)
        net = s.series.net[0]
        resolve_pending(s, waits, net, force)
        waits = s.pending != Pending.READY


def begin_here(s: Lanes, here: M) -> None:
    """Begin a phase in the current state. Its prologue follows."""
    s.x = 0.0
    find_pieces(s, here)
    begin_pieces(s, here)
