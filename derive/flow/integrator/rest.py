"""Lanes at rest, until their motion begins, and one round of the integration."""

from derive.flow.integrator.one_lane import (
    INFINITY,
    Event,
    Kind,
    Lanes,
    Limit,
    M,
    N,
    Passed,
    Pending,
    Status,
    V,
    any_lane,
    lanes_in,
    minimum,
    none_of,
    number,
    read_samples,
    where,
)
from derive.flow.integrator.phases import begin_phases, face, stay
from derive.flow.integrator.records import enter_pieces, look_for_quiet, slide_together
from derive.flow.integrator.recurrence import has_recurrence
from derive.flow.integrator.roots import crossing
from derive.flow.integrator.rotation import turn_on
from derive.flow.integrator.series import expand, longest_step
from derive.flow.integrator.shaken import turn_through
from derive.flow.integrator.step import change_contact, consider, find_contact_change, make_step
from derive.flow.integrator.swing import swing
from derive.flow.integrator.tables import next_break, rise_of_step

TOUCHES = 2.0  # units of rounding of the drive below which the net moment at rest is zero
TOGETHER = 1e-9  # relative difference below which two times are equal


def look_ahead(s: Lanes, here: M, room: V) -> None:
    """Find the next change of a mass at rest in its direction, if it precedes the changes that are known already.

    The net moment at rest is a series of time alone. Slip begins at its root, where the drive is zero, or immediately
    if the net moment is zero and rises, or has jumped above zero.
    """
    top: N = expand(s, room, here, 1)
    net = s.series.net
    complete = here and s.series_order == s.order
    if any_lane(complete):
        step = longest_step(s, net, top - 1, s.series_order - 1.0)
        s.step = where(complete, minimum(step, s.step), s.step)
    touches = abs(net[0]) <= TOUCHES * s.drive_scale
    jumps = net[0] > 0.0 and not touches
    at_once = jumps or (touches and net[1] > 0.0)
    later = crossing(net, top - 1, s.step, -1.0, 0.0, touches, here and not at_once)
    at = where(at_once, 0.0, later)
    consider(s, here, at, Event.START)
    sooner = at <= s.step
    s.start_direction = where(sooner, s.direction, s.start_direction)
    s.sudden = where(sooner, where(jumps, 1.0, 0.0), s.sudden)
    look_for_quiet(s, here)
    known = 1.0 * s.step
    s.step = minimum(known * (1.0 + TOGETHER), room)
    find_contact_change(s, here, top)  # in which case the mass does not start
    s.step = where(s.event == Event.LIFT_OFF, s.step, known)


def turn_back(s: Lanes, here: M) -> None:
    """Reverse the direction at rest."""
    s.direction = -s.direction
    s.pending = Pending.BEGIN_PHASE


def start_again(s: Lanes, here: M) -> None:
    """Start slip from rest."""
    face(s, here, s.start_direction)
    s.pending = Pending.START_AGAIN


def leave_rest(s: Lanes, here: M, limit: V) -> None:
    """Advance to the first change: start of slip, change of contact, break or end."""
    lifts = s.event == Event.LIFT_OFF
    starts = s.event == Event.START
    breaks = s.event == Event.LIMIT
    until = where(breaks, limit, s.time + s.step)
    for_ever = not starts and not (until < INFINITY)
    if s.samples:
        read_samples(s, here, s.time, minimum(until, s.end_time), 0, 0)
    # An immediate start after an arrest counts as a step: it may tremble.
    least = TOGETHER * until
    rested = starts and s.step > least
    s.steps = where(breaks or rested, 0.0, s.steps + 1.0)
    s.passed = Passed.NOTHING
    ends = here and (for_ever or until >= s.end_time)  # changes after the end time have no influence
    s.time = where(for_ever, s.time, minimum(until, s.end_time))
    stay(s, ends, where(for_ever, Status.ARRESTED, Status.PAUSED))
    here = here and not ends
    start_again(s, here and starts)
    change_contact(s, here and lifts)
    s.pending = where(lifts, Pending.BEGIN_PHASE, s.pending)
    enter_pieces(s, here and breaks)


def rest_to_change(s: Lanes, here: M, limit: V, room: V) -> None:
    """Advance lanes at rest to the next break, or to the start of motion, which is found in the other direction too."""
    both = here and s.one_way == 0.0
    if any_lane(both):
        turn_back(s, both)
        begin_phases(s)
        look_ahead(s, both, s.step)
    for t in s.tables:
        if t.kind == Kind.TIME:  # the same for both directions
            t.inc = t.inc + rise_of_step(s, t)
    reaches = s.event == Event.NONE and s.step >= room
    s.event = where(reaches, Event.LIMIT, s.event)
    leave_rest(s, here, limit)


def rest_on(s: Lanes, here: M) -> None:
    """Advance lanes at rest under changing forces to the next break, or to the start of motion."""
    limit = next_break(s)
    room = where(limit < INFINITY, limit - s.time, 1.0)
    s.event = Event.NONE
    s.quiet_from = -INFINITY
    s.quiet_to = INFINITY
    look_ahead(s, here, room)
    later = none_of(s)
    for t in s.tables:
        alone: N = s.autonomous == 2 and s.timed == 1
        linear: N = not s.samples and not s.logged and t.terms == 2
        if (alone or s.has.net_record) and linear and t.kind == Kind.TIME and not t.sine:
            down_slope = here and s.one_way > 0.0 and s.direction > 0.0 and s.lifted == 0.0
            if s.has.net_record:
                turn_through(s, down_slope, t)
            if not s.has.net_record:
                later = slide_together(s, down_slope, t)
    stays = here and s.status == Status.RESTING and s.pending == Pending.READY
    rest_to_change(s, stays and not later, limit, room)


# --- one round -------------------------------------------------------------------------------------------------------


def stop_endless(s: Lanes, here: M) -> None:
    """Stop lanes with too many steps since they last rested or passed a break, too many turns, or overflow."""
    going = s.status <= Status.RESTING
    most = where(s.omega > 0.0, Limit.MOST_STEPS, number(2 * Limit.MOST_STEPS))  # rest allows more
    too_long = s.steps > most
    if not s.timed:
        too_long = too_long or s.turns > Limit.MOST_TURNS
    total = s.time + s.x + s.omega + s.rotation
    overflows = going and total - total != 0.0
    s.status = where(going and too_long, Status.TOO_LONG, s.status)
    s.status = where(overflows, Status.FAILED, s.status)


def advance(s: Lanes, here: M) -> None:
    """Complete phases in closed form, and make one step of the other moving lanes or of the lanes at rest.

    The cost of a step does not depend on the number of lanes, so that the minority waits until it is the majority.
    """
    moving = here and s.status == Status.MOVING
    resting = here and s.status == Status.RESTING
    complete: N = s.has.net_sine and not (s.samples and s.has.loss_rate)
    for t in s.tables:
        complete = complete and t.kind != Kind.SLIP and t.kind != Kind.TIME
    if complete:
        moving = moving and not swing(s, moving)
    if s.by_rotation and not s.samples:
        turning = moving and s.clocked == 0.0
        if has_recurrence(s):
            turning = turning and s.x == 0.0
        turn_on(s, turning)
        moving = moving and not (turning and s.clocked == 0.0)
    if lanes_in(moving) > lanes_in(resting):
        make_step(s, moving)
    if lanes_in(resting) >= lanes_in(moving):
        rest_on(s, resting)
    begin_phases(s)
    stop_endless(s, here)
