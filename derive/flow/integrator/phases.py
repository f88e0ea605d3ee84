"""Phases of one lane: stick or slip at a standstill, and the numbers of the phase that begins.

The cell `pending` contains the action that a lane needs before its next step, such as the beginning of a phase.
"""

from derive.flow.integrator.one_lane import (
    EPS,
    INFINITY,
    Lane,
    Lanes,
    M,
    Note,
    Passed,
    Pending,
    Share,
    Status,
    V,
    any_lane,
    hypot,
    isnan,
    maximum,
    minimum,
    note,
    prologue,
    read_samples,
    where,
)
from derive.flow.integrator.series import evaluate, find_negligible, normal_force
from derive.flow.integrator.tables import begin_pieces, find_pieces, still_changes

TIE = 256.0 * EPS  # relative difference up to which two peaks are equal
CLOSEST = 1e-300  # size of the terms of a drive, in units of rounding, if all are zero


def update_peak(lane: Lane, rate: float) -> None:
    """Record the current speed if it is the greatest.

    If peaks differ by rounding, the earliest is recorded, so that every processor reports the same peak. A speed that
    has risen from a record at the lane's time is compared exactly.
    """
    rises = lane.peak_time == lane.time
    if lane.omega > where(rises, 1.0, 1.0 + TIE) * abs(lane.peak_omega):
        lane.peak_time = lane.time
        lane.peak_rotation = lane.rotation + lane.direction * lane.x
        lane.peak_omega = lane.direction * lane.omega
        lane.peak_rate = lane.direction * rate


def keep_faster(s: Lanes, here: M, speed: V, time: V, x: V, rate: V) -> None:
    """Record a candidate for the greatest speed in the current step if it exceeds the record.

    If the record is not at the beginning of the step, the difference must exceed rounding.
    """
    faster = here and speed > abs(s.peak_omega)
    if any_lane(faster):
        faster = faster and (s.peak_time == s.time or speed > (1.0 + TIE) * abs(s.peak_omega))
        s.peak_omega = where(faster, s.direction * speed, s.peak_omega)
        s.peak_time = where(faster, time, s.peak_time)
        s.peak_rotation = where(faster, s.rotation + s.direction * x, s.peak_rotation)
        s.peak_rate = where(faster, s.direction * rate, s.peak_rate)


def update_reach(lane: Lane) -> None:
    """Record the current rotation if it is the greatest from the start."""
    rotation = lane.rotation + lane.direction * lane.x
    if abs(rotation) > abs(lane.reach_rotation):
        lane.reach_rotation = rotation
        lane.reach_time = lane.time


def note_lift_off(lane: Lane) -> None:
    """Log the loss of contact with the slip surface."""
    note(lane, Note.LIFTS)
    if isnan(lane.lift_time):
        lane.lift_time = lane.time


def advance_origin(lane: Lane) -> None:
    """Reset the origin of rotation and slip to the current position, where another phase begins."""
    lane.rotation = lane.rotation + lane.direction * lane.x
    lane.slip = lane.slip + lane.x
    lane.x = 0.0


def face(lane: Lane, side: float) -> None:
    """Set the direction of travel at a standstill."""
    lane.x = 0.0
    lane.omega = 0.0
    lane.direction = side
    lane.lifted = 0.0


def start(lane: Lane) -> None:
    """Start a lane with a velocity or at rest."""
    lane.direction = where(lane.omega < 0.0, -1.0, 1.0)
    lane.omega = abs(lane.omega)
    lane.x = 0.0
    lane.lifted = 0.0
    lane.faced = 0.0
    lane.pending = where(lane.omega > 0.0, Pending.START_MOVING, Pending.RESOLVE)
    lane.clocked = 0.0
    if lane.timed or lane.by_rotation:
        find_negligible(lane)
    find_pieces(lane)


def start_moving(lane: Lane, rate: float) -> None:
    """Start slip in the current direction."""
    lane.status = Status.MOVING
    lane.passed = Passed.NOTHING
    lane.phases = lane.phases + 1.0
    lane.turns = lane.turns + where(lane.last_way * lane.direction < 0.0, 1.0, 0.0)
    lane.last_way = lane.direction
    note(lane, Note.BEGINS)
    if lane.lifted > 0.0:
        note_lift_off(lane)
    update_peak(lane, rate)
    lane.pending = Pending.READY


def stay(lane: Lane, status: float) -> None:
    """Keep the lane at rest until its end."""
    lane.status = status
    lane.end_rotation = lane.rotation
    lane.end_omega = 0.0
    lane.end_rate = 0.0
    lane.direction = 0.0
    lane.rest_since = where(lane.rest_since > lane.end_time, lane.end_time, lane.rest_since)  # by rounding at most
    lane.pending = Pending.READY
    read_samples(lane, lane.time, INFINITY, 0, 0)


def may_start(lane: Lane) -> bool:
    """Return whether a mass at rest may start in its direction. Shaking starts a one-way mass only down-slope."""
    pull = lane.driving_moment
    down_slope = pull > 0.0 or (pull == 0.0 and lane.direction > 0.0)
    return lane.one_way == 0.0 or down_slope


def never_rests(lane: Lane) -> bool:
    """Return whether a mass swings for ever, because almost no force presses on it at its lowest point."""
    load = lane.normal_load
    most = hypot(load, lane.normal_load_slope)
    carried = lane.normal0 + (most - load) <= Share.CARRIED * most
    return lane.first_only == 1.0 or (carried and not still_changes(lane))


def stick(lane: Lane) -> None:
    """Keep the mass at rest, until a force changes or for good."""
    lane.pending = Pending.READY
    if not still_changes(lane):
        stay(lane, Status.ARRESTED)
        return
    lane.status = Status.RESTING
    if lane.lifted > 0.0:
        note_lift_off(lane)
    if not may_start(lane):
        lane.direction = -lane.direction
        lane.pending = Pending.BEGIN_PHASE


def resolve_stick_or_slip(lane: Lane) -> None:
    """Start slip in the current direction, otherwise in the other direction if it is allowed, otherwise stick."""
    if lane.first_only > 0.0 and lane.phases > 0.0 and never_rests(lane):
        stay(lane, Status.STOPPED)
        return
    may = may_start(lane)
    if lane.pending == Pending.REST:  # a mass that moved down-slope does not turn back
        if may:
            stick(lane)
            return
        face(lane, -lane.direction)
        lane.pending = Pending.RESOLVE
        return
    terms = abs(lane.driving) + lane.resisting
    unsure = EPS * (terms + lane.mu * abs(lane.normal0))
    of_weight = lane.driving == lane.driving_moment and lane.normal0 == lane.normal_load and lane.resisting == 0.0
    unsure = where(lane.limit_rest * lane.drive != 0.0 and of_weight, lane.drive_scale, unsure)
    if may:
        lane.close = minimum(lane.close, abs(lane.drive) / maximum(unsure, CLOSEST))
    if may and lane.drive > 0.0:
        start_moving(lane, lane.drive)
        return
    lane.faced = lane.faced + 1.0
    if lane.faced > 1.0 or (may and lane.one_way > 0.0):
        stick(lane)
        return
    face(lane, -lane.direction)


def carry_net_moment(lane: Lane, net: float) -> None:
    """Begin a phase in motion with the drive computed anew or continued, whichever is more accurate."""
    terms = abs(lane.rate_before) + abs(net - lane.drive) + abs(lane.drive_before)
    carried = lane.scale_before + EPS * terms
    if carried < lane.drive_scale:
        lane.drive = lane.drive + (lane.rate_before - net)
        lane.drive_scale = carried
    lane.pending = Pending.READY


def resolve_pending(lane: Lane, net: float, force: float) -> None:
    """Begin the phase for which the lane waits, from its net moment and normal force."""
    if lane.pending == Pending.ENTER_PHASE:
        carry_net_moment(lane, net)
        return
    if lane.pending == Pending.BEGIN_PHASE:
        lane.pending = Pending.READY
        return
    lifts = where(lane.pending == Pending.START_MOVING, force < 0.0, lane.normal0 <= 0.0)
    if lifts and lane.lifted == 0.0:
        lane.lifted = 1.0  # the phase begins again as a lifted mass
        return
    if lane.pending == Pending.START_MOVING:
        start_moving(lane, net)
        return
    if lane.pending == Pending.START_AGAIN:
        lane.drive = where(lane.sudden > 0.0, lane.drive, 0.0)
        start_moving(lane, lane.drive)
        return
    resolve_stick_or_slip(lane)


def on_discontinuity(lane: Lane, force: float) -> None:
    """Decide about contact after a jump of forces. If contact changes, another phase begins."""
    lifted = where(force < 0.0, 1.0, 0.0)
    if lifted > lane.lifted:
        note_lift_off(lane)
    lane.pending = where(lane.lifted == lifted, Pending.READY, Pending.BEGIN_PHASE)
    lane.lifted = lifted
    if lane.pending == Pending.BEGIN_PHASE:
        advance_origin(lane)


def begin_phases(s: Lanes) -> None:
    """Begin all pending phases, until every lane is ready for a step."""
    sudden = s.pending == Pending.DISCONTINUITY
    if any_lane(sudden):
        evaluate(s)
        force = normal_force(s)
        if sudden:
            on_discontinuity(s, force)
    waits = s.pending != Pending.READY
    while any_lane(waits):
        if waits:
            begin_pieces(s)
        prologue(s, waits)
        if any_lane(s.pending == Pending.START_MOVING or s.pending == Pending.ENTER_PHASE):
            evaluate(s)
        force = normal_force(s)
        net = s.series.net[0]
        if waits:
            resolve_pending(s, net, force)
        waits = s.pending != Pending.READY


def begin_here(lane: Lane) -> None:
    """Begin a phase in the current state. Its prologue follows."""
    lane.x = 0.0
    find_pieces(lane)
    begin_pieces(lane)
