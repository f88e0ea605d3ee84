"""Lanes at rest, in NumPy: stick or slip at a standstill, and until when a mass sticks.

At rest the net moment is a series of time alone. Its root, in the direction faced, is where slip begins.
"""

from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats
from slipcircle.core.walk.events import Event
from slipcircle.core.walk.polynomials import divided_by_time, first_root, radius_of_convergence
from slipcircle.core.walk.recorder import Recorder

TOUCHES = 2.0  # units of rounding of the drive, within which the net moment at rest is zero
SMALLEST = 1e-300  # size of the terms of a drive, in units of rounding, if all are zero
TOGETHER = 1e-9  # relative times of lift-off and start that are the same


class _Ahead(NamedTuple):
    """What lies ahead of a mass at rest, from now on; infinite where there is no such event."""

    stretch: Floats  # time for which the series hold
    start: Floats  # time until slip begins
    direction: Floats  # of this slip
    sudden: Floats  # whether it begins as the forces have jumped
    lift: Floats  # time until contact is lost or regained


class StickPhase(Recorder):
    """Lanes between their phases of slip."""

    # --- slip begins -------------------------------------------------------------------------------------------------

    def start_moving(self, rate: Floats) -> None:
        """Begin a phase of slip in the present direction."""
        self.status = ix.MOVING
        self.passed = ix.NOTHING
        self.phases += 1.0
        self.turns += self.last_way * self.direction < 0.0
        self.last_way = self.direction
        self.note(ix.NOTE_BEGINS)
        self.apply_to(self.lifted > 0.0, "note_lift_off")
        self.update_peak(rate)

    def start_with_velocity(self) -> None:
        """Begin with a velocity; the normal force, including its centripetal part, decides whether there is contact."""
        self.lifted = 0.0
        self.begin_phase()
        self.lifted = self.contact() < 0.0
        self.apply_to(self.lifted > 0.0, "begin_phase")
        registers = self.registers()
        self.start_moving(registers[self.roles["net"]])

    def start_again(self, sudden: Floats) -> None:
        """Begin slip where the net moment at rest passes zero; the drive is zero there except after a jump."""
        self.face()
        if self.tangents:
            # t' = -drive'/(d drive/dt); a jump comes with a break of what changes with time
            has_jumped = bool(sudden[0])
            self.tangents.leave_rest(has_jumped)
            self.face()
        drive = self.role("drive")
        drive[sudden == 0.0] = 0.0
        self.start_moving(drive)
        if self.tangents:
            self.tangents.enter_from_rest(has_jumped)

    # --- stick or slip at a standstill -------------------------------------------------------------------------------

    def face(self) -> None:
        """Compute the numbers of a phase from rest in the present direction."""
        self.x = self.omega = self.lifted = 0.0
        self.begin_phase()
        self.lifted = self.role("normal0") <= 0.0
        self.apply_to(self.lifted > 0.0, "begin_phase")

    def reverse(self) -> None:
        """Reverse the direction, with contact as before."""
        self.direction *= -1.0
        self.begin_phase()

    def resolve_stick_or_slip(self) -> None:
        """At rest: slip in the present direction, otherwise in the other one, otherwise stick."""
        slips = self._slips()
        stays = ~slips & (self.status != ix.STOPPED)
        only_this_way = self.may_start() & (self.one_way > 0.0)
        reverses = stays & ~only_this_way
        sticks = stays & only_this_way
        self.apply_to(slips, "slip_from_rest")
        self.direction[reverses] *= -1.0
        self.apply_to(reverses, "resolve_last_direction")
        self.apply_to(sticks, "stick")

    def resolve_last_direction(self) -> None:
        """Slip in the present direction, otherwise stick: a mass that has just stopped does not go on."""
        slips = self._slips()
        sticks = ~slips & (self.status != ix.STOPPED)
        self.apply_to(slips, "slip_from_rest")
        self.apply_to(sticks, "stick")

    def slip_from_rest(self) -> None:
        self.start_moving(self.role("drive"))

    def _slips(self) -> Any:
        """Whether the drive exceeds the resistance; lanes that nothing brings to rest are stopped."""
        self.face()
        has_moved = self.phases > 0.0
        never = has_moved & (self.first_only > 0.0) & self._never_rests()
        stopped = np.full(self.count, ix.STOPPED)
        self.apply_to(never, "stay", stopped)
        allowed = self.may_start() & ~never
        drive = self.role("drive")
        normal = np.abs(self.role("normal0"))
        friction = self.role("mu") * normal
        driving = np.abs(self.role("driving"))
        terms = driving + self.role("resisting") + friction
        rounding = np.maximum(EPS * terms, SMALLEST)
        margin = np.abs(drive) / rounding
        closest = np.fmin(self.close, margin)
        self.close = np.where(allowed, closest, self.close)
        return allowed & (drive > 0.0)

    def _never_rests(self) -> Any:
        """Whether a mass swings without end: at its lowest point the normal force is and stays negligible."""
        load = self.role("normal_load")
        greatest_load = np.hypot(load, self.role("normal_load_slope"))
        greatest_normal = self.role("normal0") + (greatest_load - load)
        carried = greatest_normal <= ix.CARRIED * greatest_load
        swings = carried & ~self.still_changes()
        return swings | (self.first_only == 1.0)

    def stick(self) -> None:
        """The lane sticks: it waits for a change of the forces, or stays for good."""
        changes = self.still_changes()
        arrested = np.full(self.count, ix.ARRESTED)
        self.apply_to(~changes, "stay", arrested)
        self.status[changes] = ix.RESTING
        self.apply_to(changes & (self.lifted > 0.0), "note_lift_off")
        self.apply_to(changes & ~self.may_start(), "reverse")

    def stay(self, status: Floats) -> None:
        """The lane stays where it is, until its end."""
        self.status = status
        self.end_rotation = self.rotation
        self.end_omega = 0.0
        self.end_rate = 0.0
        self.direction = 0.0
        self.rest_since = np.minimum(self.rest_since, self.end_time)  # later by rounding at most
        ever_after = np.full(self.count, np.inf)
        self.read_samples(self.time, ever_after)

    # --- at rest -----------------------------------------------------------------------------------------------------

    def wait(self) -> None:
        """One step of lanes at rest: to the next break of a function of time, or to the start of slip."""
        limit = self.next_break()
        unlimited = np.isinf(limit)
        room = np.where(unlimited, 1.0, limit - self.time)
        never = np.full(self.count, np.inf)
        nothing = _Ahead(room, never, never, never, never)
        ahead = self._look_ahead(room, nothing)
        both_ways = self.one_way == 0.0
        if np.any(both_ways):
            self.apply_to(both_ways, "reverse")
            ahead_both_ways = self._look_ahead(room, ahead)
            ahead = _Ahead(*np.where(both_ways, ahead_both_ways, ahead))
        self.advance_functions_of_time(ahead.stretch)
        self._go_on(limit, room, ahead)

    def _look_ahead(self, room: Floats, before: _Ahead) -> _Ahead:
        """What lies ahead in the present direction, where it comes before other events."""
        series, order = self.expand(room, at_rest=True)
        net = self.net_moment(series)
        radius = radius_of_convergence(net, order - 1.0)
        step = np.minimum(self.factor * radius, room)
        ends_early = order < self.order
        stretch = np.where(ends_early, room, step)
        stretch = np.minimum(stretch, before.stretch)
        start, sudden = self._find_start(net, stretch)
        sooner = start < before.start
        start = np.where(sooner, start, before.start)
        direction = np.where(sooner, self.direction, before.direction)
        sudden = np.where(sooner, sudden, before.sudden)
        lift = before.lift
        if self.roles["normal"] >= 0:
            contact_changes = self.contact_event().time(series, stretch)
            lift = np.minimum(lift, contact_changes)
            stretch = np.minimum(stretch, contact_changes)
        return _Ahead(stretch, start, direction, sudden, lift)

    def _find_start(self, net: Floats, stretch: Floats) -> tuple[Floats, Floats]:
        """Time at which the net moment passes zero: immediately if it is zero and rises, or has jumped above it."""
        at_present = net[0]
        rounding = TOUCHES * self.role("drive_scale")
        touches = np.abs(at_present) <= rounding
        sudden = at_present > rounding
        resistance = divided_by_time(-net, touches)
        rises = touches & (resistance[0] < 0.0)
        start = first_root(resistance, stretch)
        start[sudden | rises] = 0.0
        return start, sudden

    def _go_on(self, limit: Floats, room: Floats, ahead: _Ahead) -> None:
        """Advance lanes at rest to the first event: start of slip, change of contact, break, or none."""
        stretch, start, direction, sudden, lift = ahead
        before_start = lift <= start * (1.0 + TOGETHER)  # where both pass zero it does not start
        lifts = before_start & (lift <= stretch)
        starts = ~lifts & (start <= stretch)
        uneventful = ~lifts & ~starts
        breaks = uneventful & (stretch >= room)
        time_left = np.where(starts, start, stretch)
        until = np.where(breaks, limit, self.time + time_left)
        for_ever = ~starts & np.isinf(until)
        paused = ~for_ever & (until >= self.end_time)  # events after the end time do not count
        until = np.minimum(until, self.end_time)
        self.read_samples(self.time, until)
        self.steps += ~breaks
        self.passed = ix.NOTHING
        self.time = np.where(for_ever, self.time, until)
        stays = for_ever | paused
        final_status = np.where(paused, ix.PAUSED, ix.ARRESTED)
        self.apply_to(stays, "stay", final_status)
        starts &= ~stays
        self.direction[starts] = direction[starts]
        self.apply_to(starts, "start_again", sudden)
        self.apply_to(lifts & ~stays, "change_contact_at_rest")
        self.apply_to(breaks & ~stays, "pass_breaks_at_rest")

    def change_contact_at_rest(self) -> None:
        """Contact is lost or regained while the mass rests."""
        self.lifted = 1.0 - self.lifted
        self.passed = ix.LIFT
        self.apply_to(self.lifted > 0.0, "note_lift_off")
        self.begin_phase()

    def pass_breaks_at_rest(self) -> None:
        jumps = self.pass_breaks()
        self.apply_to(jumps, "on_discontinuity")

    def contact_event(self) -> Event:
        """Contact with the slip surface is lost or regained."""
        is_lifted = self.lifted > 0.0
        sign = np.where(is_lifted, -1.0, 1.0)
        just_changed = self.passed == ix.LIFT
        return Event(ix.EVENT_LIFT_OFF, self.roles["normal"], sign, passed=just_changed)

    # --- jumps of what changes with time -----------------------------------------------------------------------------

    def on_discontinuity(self) -> None:
        """After a jump of the forces contact is decided again; if it changes, the phase is restarted."""
        loses = self.contact() < 0.0
        changes = loses != (self.lifted > 0.0)
        self.apply_to(changes & loses, "note_lift_off")
        self.lifted = loses
        self.apply_to(changes, "restart_phase")

    def restart_phase(self) -> None:
        """Restart the phase with the numbers of the present state."""
        carried = self.tangents if self.status[0] == ix.MOVING else None
        if carried:
            carried.leave_now()
        self.advance_origin()
        self.begin_phase()
        if carried:
            carried.enter()
