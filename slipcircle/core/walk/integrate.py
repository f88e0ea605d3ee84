"""The integrator of lanes in NumPy: steps, events, phases of slip and of stick; the same as the compiled ``_flow.c``.

The balance of momentum about the centre of the arc, made dimensionless with t* = t sqrt(g/R) and divided by the
dimensionless moment of inertia Theta*, in the direction of travel:

    d omega*/dt* = drive - mu (press + polar omega*^2 - water) - other resistance,    d phi/dt* = omega*

drive     weight and shaking along the arc: W (sin(psi) + k_h cos(psi)), psi the dip of the chord, which turns with phi
press     their normal force on it, from which the centripetal term and water pressure add and take
mu        friction, of slip, speed or time; no friction where contact is lost, that is where the bracket is below zero
other     cohesion, drag, viscosity

A scene's program (`slipcircle.core.program.program`) has the terms of its effects only, as increments since its phase
began. A step is a Taylor series in time, as long as its radius of convergence allows. Kinds are roots of series that
the step has anyway: standstill, lift-off and landing, an upright chord, edges of tables. A round makes one step of
every lane: of a moving one along its series, of a resting one to the next break of what changes with time.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats
from slipcircle.core.program.program import Log, Program, Samples
from slipcircle.core.scene.piecewise import Data
from slipcircle.core.walk.events import Event, FirstEvent, Kinds
from slipcircle.core.walk.lane_state import LaneState
from slipcircle.core.walk.polynomials import (
    divided_by_time,
    first_root,
    increment,
    radius_of_convergence,
    value,
    value_and_slope,
)
from slipcircle.core.walk.stick_slip import StickPhase

ROUNDS = 10_000  # after which lanes that have ended make room at the latest
FAR = 1e300  # a bound that is never reached


def integrate(
    program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None = None, log: Log | None = None
) -> None:
    """Integrate every lane until it rests, ends or fails.

    Parameters
    ----------
    program : Program
    tables : sequence of Data
        For each table of the program.
    cells : ndarray
        (cells, lanes), changed in place: where each lane begins and, then, where it is. Its status says how it ended.
    samples : Samples, optional
        What to read off on the way.
    log : list, optional
        Takes the events of the first lane: kind, time, rotation, direction.
    """
    live = np.flatnonzero(cells[ix.STATUS] <= ix.RESTING)
    with np.errstate(all="ignore"):
        while live.size:
            tables_of_live = [table.lanes(live) for table in tables]
            cells_of_live = np.ascontiguousarray(cells[:, live])
            lanes = Integrator(program, tables_of_live, cells_of_live, live, samples, log)
            for _ in range(ROUNDS):
                lanes.round()
                active = lanes.status <= ix.RESTING
                left = np.count_nonzero(active)
                if left <= live.size // 2:
                    break  # those that have ended make room
            cells[:, live] = lanes.cells
            live = live[active]


def begin_phase(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """Numbers of the phase that would begin in the present state and direction of each lane, without integrating.

    Parameters
    ----------
    program, tables, cells
        As `integrate` takes them; the cells of a phase are filled in place.

    Returns
    -------
    ndarray
        Registers there, (registers, lanes).
    """
    lanes = LaneState(program, tables, cells)
    with np.errstate(all="ignore"):
        lanes.find_pieces()
        lanes.begin_phase()
    return registers(program, tables, cells)


def registers(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """Registers in the present states of lanes, (registers, lanes)."""
    with np.errstate(all="ignore"):
        return LaneState(program, tables, cells).registers()


class Integrator(StickPhase):
    """Lanes during their integration."""

    stiff_step: float = ix.STIFF_STEP  # steps that one counts for which what decays at once holds short

    def round(self) -> None:
        """One step of every lane that has not ended."""
        status = self.status.copy()
        self.apply_to(status == ix.START, "start")
        self.apply_to(status == ix.MOVING, "step")
        self.apply_to(status == ix.RESTING, "wait")
        self._stop_endless()

    def _stop_endless(self) -> None:
        """Stop lanes that take too many steps or reversals, or overflow."""
        active = self.status <= ix.RESTING
        moves = self.omega > 0.0
        most_steps = np.where(moves, ix.MOST_STEPS, 2 * ix.MOST_STEPS)  # at rest it can wait
        too_long = self.steps > most_steps
        if not self.timed:
            too_long |= self.turns > ix.MOST_TURNS
        self.status[active & too_long] = ix.TOO_LONG
        position = self.x + self.rotation
        overflow = ~np.isfinite(self.time + position + self.omega)
        self.status[active & overflow] = ix.FAILED

    def start(self) -> None:
        """Begin the first phase of a lane with a velocity; resolve stick or slip of one at rest."""
        goes_up = self.omega < 0.0
        self.direction = np.where(goes_up, -1.0, 1.0)
        self.omega = np.abs(self.omega)
        self.x = self.lifted = 0.0
        self.find_pieces()
        moves = self.omega > 0.0
        self.apply_to(moves, "start_with_velocity")
        self.apply_to(~moves, "resolve_stick_or_slip")

    # --- one step ----------------------------------------------------------------------------------------------------

    def step(self) -> None:
        """One step of lanes that move, up to their next event."""
        limit = np.minimum(self.next_break(), self.end_time)
        room = limit - self.time
        series, order = self.expand(room)
        h = self._step_size(series, order, room)
        tau, event = self.find_event(series, h)
        net = self.net_moment(series)
        change = net[0] * tau
        uneventful = event == ix.EVENT_NONE
        endless = uneventful & self._endless(change, room)
        tau = np.where(endless, 0.0, tau)
        at_limit = uneventful & (h >= room) & ~endless
        until = np.where(at_limit, limit, self.time + tau)
        self.update_peak_within(series, tau)
        self.read_samples(self.time, until, series)
        self._count(uneventful, at_limit, change)
        if self.tangents:
            self.tangents.end_step(series, tau)
        self._advance(series, tau)
        self.time = until
        self.status[endless] = ix.TOO_LONG
        rate = value(net, tau)
        self.settle(event, rate, at_limit)

    def _step_size(self, series: Floats, order: Floats, room: Floats) -> Floats:
        """A fraction of the least radius of convergence of the states, or all of the room where series end early."""
        registers = [register for _, register, _ in self.program.states]
        radii = [radius_of_convergence(series[register], order) for register in registers]
        radius = np.min(radii, axis=0)
        if self.tangents:
            radius = radius.min()  # directions go together
        step = np.minimum(self.factor * radius, room)
        ends_early = order < self.order
        return np.where(ends_early, room, step)

    def _endless(self, change: Floats, room: Floats) -> Any:
        """Lanes that never stop: a rate that depends on the speed only never becomes negative again."""
        settled = change >= -ix.SETTLED * self.omega
        unlimited = np.isinf(room)
        in_contact = self.lifted == 0.0
        return settled & unlimited & in_contact & self.program.autonomous

    def _count(self, uneventful: Any, at_limit: Any, change: Floats) -> None:
        """Count the step; one in which the speed hardly changes by ``change`` may count for several, as it is stiff."""
        is_steady = np.abs(change) < ix.STIFF_CHANGE * self.omega
        steps = np.where(uneventful & is_steady, self.stiff_step, 1.0)
        steps[at_limit] = 0.0
        self.steps += steps

    def _advance(self, series: Floats, tau: Floats) -> None:
        """Advance the states and the functions of time by the step."""
        for cell, register, _ in self.program.states:
            self.cells[cell] += increment(series[register], tau)
        for piece in self.timed:
            piece.increment += increment(series[piece.register], tau)

    def settle(self, event: Kinds, rate: Floats, at_limit: Any) -> None:
        """Handle the end of a step: an event, a break of a function of time, or the end time."""
        self.passed = ix.NOTHING
        self.update_peak(rate)
        upright = np.full(self.count, ix.UPRIGHT)
        ended = np.full(self.count, ix.ENDED)
        at_end = at_limit & (self.time >= self.end_time)
        at_break = at_limit & ~at_end
        self.apply_to(event == ix.EVENT_STANDSTILL, "on_standstill")
        self.apply_to(event == ix.EVENT_LIFT_OFF, "on_contact_change", rate)
        self.apply_to(event >= ix.EVENT_BREAKPOINT, "on_breakpoint", event, rate)
        self.apply_to(event == ix.EVENT_CHORD_UPRIGHT, "end", rate, upright)
        self.apply_to(at_end, "end", rate, ended)
        self.apply_to(at_break, "on_break_in_time")

    # --- events ------------------------------------------------------------------------------------------------------

    def find_event(self, series: Floats, h: Floats) -> tuple[Floats, Kinds]:
        """Time and kind of the first event of the step; of equal times the event that is searched last."""
        first = FirstEvent(h)
        standstill = self._standstill(series, h)
        first.consider(ix.EVENT_STANDSTILL, standstill)
        for event in self.possible_events():
            time = event.time(series, first.time)
            first.consider(event.kind, time)
        return first.time, first.kind

    def possible_events(self) -> list[Event]:
        """The events beside a standstill, in the order in which they are searched."""
        roles = self.roles
        omega = roles["omega"]
        upright = roles["upright"]
        events = []
        if upright >= 0:
            events.append(Event(ix.EVENT_CHORD_UPRIGHT, upright))
        for number, piece in enumerate(self.pieces):
            if piece.kind == "time":
                continue
            kind = ix.EVENT_BREAKPOINT + 2 * number
            upper = np.minimum(piece.upper, FAR)
            if piece.kind != "speed":
                events.append(Event(kind, roles["x"], -1.0, upper))
                continue
            varies = piece.lower > 0.0
            lower = np.where(varies, piece.lower, -FAR)
            slower = self.passed == ix.SLOWER
            faster = self.passed == ix.FASTER
            events.append(Event(kind, omega, -1.0, upper, slower))
            events.append(Event(kind + 1, omega, 1.0, lower, faster))
        if roles["normal"] >= 0:
            # Water may change faster than the motion for which the step was chosen: the normal force is a function of
            # the position until the first other event only, and may pass zero twice beyond it.
            events.append(self.contact_event())
        return events

    def _standstill(self, series: Floats, h: Floats) -> Floats:
        """When the speed becomes zero; immediately if, from rest, the drive points backwards or is rounding."""
        omega = series[self.roles["omega"]]
        rate, rate_slope = self.net_moment(series)[:2]
        last, slope = value_and_slope(omega, h)
        from_rest = omega[0] == 0.0
        decelerates = rate < 0.0
        has_no_drive = (rate == 0.0) & (rate_slope <= 0.0)
        falls_from_rest = from_rest & (decelerates | has_no_drive)
        dips = decelerates & (slope > 0.0)
        possible = (last <= 0.0) | dips | falls_from_rest
        speed = omega
        for _ in range(3):  # from rest it is zero at first: remove that root
            still_zero = from_rest & (speed[0] == 0.0)
            speed = divided_by_time(speed, still_zero)
        vanishes = from_rest & (speed[0] == 0.0) & (last == 0.0)
        at_once = vanishes | (speed[0] < 0.0)
        root = first_root(speed, h)
        root[at_once] = 0.0
        root[~possible] = np.inf
        return root

    def on_standstill(self) -> None:
        """At a standstill the lane turns back or rests."""
        if self.tangents:
            self.tangents.leave_standstill()  # t' = -omega'/(d omega/dt)
        self.advance_origin()
        self.update_reach()
        self.rest_since = self.time
        self.note(ix.NOTE_STANDS)
        self.direction *= -1.0
        self.resolve_last_direction()
        if self.tangents:
            self.tangents.enter_or_rest()

    def on_contact_change(self, rate: Floats) -> None:
        """Contact with the slip surface is lost or regained."""
        self.lifted = 1.0 - self.lifted
        self.apply_to(self.lifted > 0.0, "note_lift_off")
        if not self.lifted[0]:
            self.note(ix.NOTE_LANDS)
        if self.tangents:
            self.tangents.leave_contact()  # t' = -n'/(dn/dt), n the normal force
        self._enter_phase(rate)
        self.passed = ix.LIFT

    def on_breakpoint(self, event: Kinds, rate: Floats) -> None:
        """An edge of a table of slip, speed or rotation is passed."""
        number, is_lower = np.divmod(event - ix.EVENT_BREAKPOINT, 2)
        if self.tangents:
            piece = self.pieces[number[0]]
            at_lower = bool(is_lower[0])
            self.tangents.leave_edge(piece, at_lower, float(rate[0]))
        for k in np.unique(number):
            self.apply_to(number == k, "_pass_edge", number, is_lower)
        self._enter_phase(rate)

    def _pass_edge(self, number: Kinds, is_lower: Kinds) -> None:
        """Lanes pass an edge of the same table: set them exactly there, in the next piece."""
        piece = self.pieces[number[0]]
        edge = np.where(is_lower, piece.lower, piece.upper)
        self.advance_origin()
        if piece.kind == "rotation":
            down_slope = self.direction > 0.0
            self.rotation = piece.data.begins(piece.index + down_slope)
            return
        piece.number += 1.0 - 2.0 * is_lower
        if piece.kind == "slip":
            begin = piece.data.breaks[piece.index]
            self.slip = begin / piece.scale
        else:
            self.omega = edge
            self.passed = np.where(is_lower, ix.SLOWER, ix.FASTER)
        if piece.data.open:
            at_last = piece.number == piece.last
            self.status[at_last & (is_lower == 0)] = ix.NEED

    def _enter_phase(self, rate: Floats) -> None:
        """Begin another phase in motion; its drive is computed anew or carried over, whichever is more accurate."""
        drive = self.role("drive").copy()
        scale = self.role("drive_scale").copy()
        pieces_before = [piece.number.copy() for piece in self.timed]
        self.advance_origin()
        self.begin_phase()
        for piece, before in zip(self.timed, pieces_before, strict=True):
            scale[piece.number != before] = np.inf  # at a break of a function of time, where it may jump
        self.carry_net_moment(rate, drive, scale)
        if self.tangents:
            self.tangents.enter()

    def carry_net_moment(self, rate: Floats, drive: Floats, scale: Floats) -> None:
        """Carry the net moment over an event where its rounding error is less than that of computing the drive anew."""
        net = self.registers()[self.roles["net"]]
        fresh = self.role("drive")
        fresh_scale = self.role("drive_scale")
        other_terms = np.abs(net - fresh)
        all_terms = np.abs(rate) + other_terms + np.abs(drive)
        carried_scale = scale + EPS * all_terms
        better = carried_scale < fresh_scale
        correction = rate - net
        fresh[better] += correction[better]
        fresh_scale[better] = carried_scale[better]

    def on_break_in_time(self) -> None:
        """A function of time has a break; where its value jumps, contact may change."""
        jumps = self.pass_breaks()
        if self.tangents and np.any(jumps):
            self.tangents.pass_break()
        self.apply_to(jumps, "on_discontinuity")

    def end(self, rate: Floats, status: Floats) -> None:
        """The integration ends while the lane moves."""
        self.status = status
        self.end_rotation = self.rotation_after(self.x)
        self.end_omega = self.direction * self.omega
        self.end_rate = self.direction * rate
        self.update_reach()
