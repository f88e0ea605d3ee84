"""Lanes at rest, in NumPy: stick or slip at a standstill, and until when a mass sticks.

At rest the net moment is a series of time alone. Its root, in the direction faced, is where slip begins.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.polynomials import divided_by_time, first_root, radius_of_convergence
from slipcircle.core.flow.recorder import Recorder

Floats = NDArray[np.float64]
TOUCHES = 2.0  # units of rounding of the drive, within which the net moment at rest is zero
TOGETHER = 1e-9  # relative times of lift-off and start that are the same
STRETCH, STARTS, DIRECTION, SUDDEN, LIFTS = range(5)  # rows of what lies ahead of a mass at rest


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
        self.start_moving(self.registers()[self.program.roles["net"]])

    def start_again(self, sudden: Floats) -> None:
        """Begin slip where the net moment at rest passes zero; the drive is zero there except after a jump."""
        self.face()
        if self.tangents:
            # t' = -drive'/(d drive/dt); a jump comes with a break of what changes with time
            self.tangents.leave_rest(bool(sudden[0]))
            self.face()
        drive = self.role("drive")
        drive[sudden == 0.0] = 0.0
        self.start_moving(drive)
        if self.tangents:
            self.tangents.enter_from_rest(bool(sudden[0]))

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
        never = (self.first_only > 0.0) & (self.phases > 0.0) & self._never_rests()
        self.apply_to(never, "stay", np.full(self.count, ix.STOPPED))
        allowed = self.may_start() & ~never
        drive = self.role("drive")
        moments = np.abs(self.role("driving")) + self.role("resisting")
        friction = self.role("mu") * np.abs(self.role("normal0"))
        rounding = EPS * (moments + friction)
        margin = np.abs(drive) / np.maximum(rounding, 1e-300)
        closest = np.fmin(self.close, margin)
        self.close = np.where(allowed, closest, self.close)
        return allowed & (drive > 0.0)

    def _never_rests(self) -> Any:
        """Whether a mass swings without end: at its lowest point the normal force is and stays negligible."""
        load = self.role("normal_load")
        greatest_load = np.hypot(load, self.role("normal_load_slope"))
        greatest_normal = self.role("normal0") + (greatest_load - load)
        carried = greatest_normal <= ix.CARRIED * greatest_load
        return (self.first_only == 1.0) | (carried & ~self.still_changes())

    def stick(self) -> None:
        """The lane sticks: it waits for a change of the forces, or stays for good."""
        changes = self.still_changes()
        self.apply_to(~changes, "stay", np.full(self.count, ix.ARRESTED))
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
        self.read_samples(self.time, np.full(self.count, np.inf))

    # --- at rest -----------------------------------------------------------------------------------------------------

    def wait(self) -> None:
        """One step of lanes at rest: to the next break of a function of time, or to the start of slip."""
        limit = self.next_break()
        room = np.where(np.isfinite(limit), limit - self.time, 1.0)
        ahead = np.zeros((5, self.count))
        ahead[STRETCH] = room
        ahead[[STARTS, LIFTS]] = np.inf
        self._look_ahead(room, ahead)
        both_ways = self.one_way == 0.0
        if np.any(both_ways):
            self.apply_to(both_ways, "reverse")
            part = self.part(both_ways)
            part_ahead = ahead[:, both_ways]
            part._look_ahead(room[both_ways], part_ahead)
            ahead[:, both_ways] = part_ahead
        self.advance_functions_of_time(ahead[STRETCH])
        self._go_on(limit, room, ahead)

    def _look_ahead(self, room: Floats, ahead: Floats) -> None:
        """Times at which slip begins in the present direction, and at which contact changes, if earlier."""
        series, order = self.expand(room, at_rest=True)
        net = series[self.program.roles["net"], :-1]
        self._look_for_start(net, order, room, ahead)
        normal = self.program.roles["normal"]
        if normal < 0:
            return
        contact = divided_by_time(self.contact_margin(series[normal, :-1]), self.passed == ix.LIFT)
        at = first_root(contact, ahead[STRETCH])
        for row in (LIFTS, STRETCH):
            ahead[row] = np.minimum(at, ahead[row])

    def _look_for_start(self, net: Floats, order: Floats, room: Floats, ahead: Floats) -> None:
        """Time at which the net moment passes zero: immediately if it is zero and rises, or has jumped above it."""
        touches = np.abs(net[0]) <= TOUCHES * self.role("drive_scale")
        sudden = ~touches & (net[0] > 0.0)
        ends_early = order < self.order
        radius = radius_of_convergence(net, order - 1.0)
        step = np.minimum(self.factor * radius, room)
        stretch = np.where(ends_early, room, step)
        ahead[STRETCH] = np.minimum(stretch, ahead[STRETCH])
        resistance = divided_by_time(-net, touches)
        rises = touches & (resistance[0] < 0.0)
        root = first_root(resistance, ahead[STRETCH])
        at = np.where(sudden | rises, 0.0, root)
        sooner = at < ahead[STARTS]
        for row, values in ((STARTS, at), (DIRECTION, self.direction), (SUDDEN, sudden)):
            ahead[row] = np.where(sooner, values, ahead[row])

    def _go_on(self, limit: Floats, room: Floats, ahead: Floats) -> None:
        """Advance lanes at rest to the first event: start of slip, change of contact, break, or none."""
        stretch, start, direction, sudden, lift = ahead
        lifts = (lift <= stretch) & (lift <= start * (1.0 + TOGETHER))  # where both pass zero it does not start
        starts = ~lifts & (start <= stretch)
        breaks = ~lifts & ~starts & (stretch >= room)
        waits_until = np.where(breaks, limit, self.time + stretch)
        until = np.where(starts, self.time + start, waits_until)
        for_ever = ~starts & np.isinf(until)
        paused = ~for_ever & (until >= self.end_time)  # events after the end time do not count
        until = np.minimum(until, self.end_time)
        self.read_samples(self.time, until)
        self.steps += ~breaks
        self.passed = ix.NOTHING
        self.time = np.where(for_ever, self.time, until)
        stays = for_ever | paused
        self.apply_to(stays, "stay", np.where(paused, ix.PAUSED, ix.ARRESTED))
        starts, lifts, breaks = (mask & ~stays for mask in (starts, lifts, breaks))
        self.direction[starts] = direction[starts]
        self.apply_to(starts, "start_again", sudden)
        self.apply_to(lifts, "change_contact_at_rest")
        self.apply_to(breaks, "pass_breaks_at_rest")

    def change_contact_at_rest(self) -> None:
        """Contact is lost or regained while the mass rests."""
        self.lifted = 1.0 - self.lifted
        self.passed = ix.LIFT
        self.apply_to(self.lifted > 0.0, "note_lift_off")
        self.begin_phase()

    def pass_breaks_at_rest(self) -> None:
        self.apply_to(self.pass_breaks(), "on_discontinuity")

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
        moves = self.tangents and self.status[0] == ix.MOVING
        if self.tangents and moves:
            self.tangents.leave_now()
        self.advance_origin()
        self.begin_phase()
        if self.tangents and moves:
            self.tangents.enter()
