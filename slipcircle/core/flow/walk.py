"""The walk of lanes through their motion, in NumPy: step, event, phase, rest; the same as `generated/_flow.c`.

One round makes one step of every lane: of a moving one along its Taylor series, of a resting one to the next break of
what changes with time. Events are roots of the series that the step has anyway.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.columns import Columns
from slipcircle.core.flow.polynomials import divided, first_root, increment, shifted, value
from slipcircle.core.flow.program import Log, Program, Samples
from slipcircle.core.flow.rest import Resting
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]


def walk(
    program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None = None, log: Log | None = None
) -> None:
    """Walk every lane until it rests, ends or fails; ``cells`` holds where it begins and, then, where it is.

    Parameters
    ----------
    program : Program
    tables : sequence of Data
        For each table of the program.
    cells : ndarray
        (cells, lanes), changed in place. The status of each lane says how it ended.
    samples : Samples, optional
        What to read off on the way.
    log : list, optional
        Takes the events of the first lane: kind, time, rotation, direction.
    """
    live = np.flatnonzero(cells[ix.STATUS] <= ix.RESTING)
    with np.errstate(all="ignore"):
        while live.size:
            here = [t.lanes(live) for t in tables]
            lanes = Walker(program, here, np.ascontiguousarray(cells[:, live]), samples, live, log)
            rounds = 0
            while True:
                lanes.round()
                rounds += 1
                going = lanes.c[ix.STATUS] <= ix.RESTING
                if np.count_nonzero(going) <= live.size // 2 or rounds == 10_000:
                    break
            cells[:, live] = lanes.c
            live = live[going]


def begin(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """Base the phase that would begin where each lane is, in the direction set; its registers there, without walking.

    Parameters
    ----------
    program, tables, cells
        As `walk` takes them; the cells of a phase are filled in place.

    Returns
    -------
    ndarray
        (registers, lanes).
    """
    lanes = Columns(program, tables, cells, None, np.arange(cells.shape[1]))
    with np.errstate(all="ignore"):
        lanes.find_pieces()
        lanes.base()
    return registers(program, tables, cells)


def registers(program: Program, tables: Sequence[Data], cells: Floats) -> Floats:
    """Registers where lanes are within their phases, (registers, lanes)."""
    with np.errstate(all="ignore"):
        return Columns(program, tables, cells, None, np.arange(cells.shape[1]))._series(0)[0][:, 0]


class Walker(Resting):
    """Lanes on their way, which this class steps."""

    stiff_step: float = ix.STIFF_STEP

    def round(self) -> None:
        status = self.c[ix.STATUS].copy()
        self.on(status == ix.START, "start")
        self.on(status == ix.MOVING, "step")
        self.on(status == ix.RESTING, "wait")
        c = self.c
        lost = ~np.isfinite(c[ix.TIME] + c[ix.X] + c[ix.OMEGA] + c[ix.ROTATION])
        c[ix.STATUS, lost & (c[ix.STATUS] <= ix.RESTING)] = ix.FAILED
        most = np.where(c[ix.OMEGA] > 0.0, ix.MOST_STEPS, 2 * ix.MOST_STEPS)  # at rest it can wait
        long = (c[ix.STEPS] > most) | ((c[ix.TURNS] > ix.MOST_TURNS) & (len(self.timed) == 0))
        c[ix.STATUS, long & (c[ix.STATUS] <= ix.RESTING)] = ix.TOO_LONG

    def start(self) -> None:
        """A lane that moves at first begins its first phase; one that rests is asked whether it stays."""
        c = self.c
        c[ix.DIRECTION] = np.sign(c[ix.OMEGA])
        c[ix.OMEGA] = np.abs(c[ix.OMEGA])
        self.find_pieces()
        self.on(c[ix.OMEGA] > 0.0, "begin")
        self.on(c[ix.OMEGA] == 0.0, "decide")

    # --- motion -------------------------------------------------------------------------------------------------------

    def step(self) -> None:
        """One step of lanes that move, up to their next event."""
        c, p = self.c, self.program
        order = int(c[ix.ORDER].max())
        r, last = self._series(order)
        x, omega, net = (r[p.roles[n]] for n in ("x", "omega", "net"))
        limit = np.minimum(self._break(), c[ix.END_TIME])
        room = limit - c[ix.TIME]
        states = [register for _, register, _ in p.states]
        h = self._length(r, last, states)
        early = last < c[ix.ORDER]
        h = np.where(early, room, np.minimum(h, room))
        h = np.where(np.isfinite(h), h, self._far(r))
        tau, event = self._events(r, h)
        # Where the rate depends on the speed alone it never falls below zero again.
        settled = (net[0] * tau >= -ix.SETTLED * omega[0]) & np.isinf(room) & (c[ix.LIFTED] == 0.0)
        endless = settled & (event == ix.EVENT_NONE) & p.autonomous
        tau = np.where(endless, 0.0, tau)
        at_limit = (h >= room) & (event == ix.EVENT_NONE) & ~endless
        self._peak(net, x, omega, tau)
        self._read(c[ix.TIME], np.where(at_limit, limit, c[ix.TIME] + tau), (x, omega, net, r))
        stiff = (np.abs(net[0]) * tau < ix.STIFF_CHANGE * omega[0]) & (event < 0)
        c[ix.STEPS] += np.where(stiff, self.stiff_step, 1.0) * ~at_limit  # a record takes as many as it has samples
        for cell, register, _ in p.states:
            c[cell] += increment(r[register], tau)
        for k in self.timed:
            slot = p.tables[k]
            rise = increment(r[slot.register], tau)
            c[slot.cells + ix.INC] += rise
            c[slot.cells + ix.WAY] += np.abs(rise)
        c[ix.TIME] = np.where(at_limit, limit, c[ix.TIME] + tau)
        c[ix.STATUS, endless] = ix.TOO_LONG
        self.settle(event, value(net, tau), at_limit)

    def settle(self, event: NDArray[np.intp], rate: Floats, at_limit: Any) -> None:
        """What follows from where a step has ended: an event, a break of what changes with time, the end."""
        c, p = self.c, self.program
        c[ix.PASSED] = ix.NOTHING
        self.on(event == ix.EVENT_STANDSTILL, "stand")
        if ix.EVENT_LIFT_OFF <= event.max(initial=ix.EVENT_NONE):
            lifting = event == ix.EVENT_LIFT_OFF
            c[ix.LIFTED, lifting] = 1.0 - c[ix.LIFTED, lifting]
            self._lift_time(lifting & (c[ix.LIFTED] > 0.0))
            if lifting[0] and c[ix.LIFTED, 0] == 0.0:
                self._note(ix.NOTE_LANDS)
            kinks = (event >= ix.EVENT_LIFT_OFF) & (event != ix.EVENT_CHORD_UPRIGHT)
            part, rates = self.part(kinks), rate[kinks]
            part.kink(event[kinks], rates)
            if part is not self:
                c[:, kinks] = part.c
            c[ix.PASSED, lifting] = ix.LIFT
        upright = event == ix.EVENT_CHORD_UPRIGHT
        self.on(upright, "end", rate[upright])
        c[ix.STATUS, upright] = ix.UPRIGHT
        going = c[ix.STATUS] == ix.MOVING
        self.on(going, "look", rate[going])
        ends = at_limit & going & (c[ix.TIME] >= c[ix.END_TIME])
        self.on(ends, "end", rate[ends])
        leaps = self._pass_breaks(at_limit & ~ends & going)
        if np.any(leaps) and p.roles["normal"] >= 0:
            self.on(leaps, "leapt")

    def end(self, rate: Floats) -> None:
        """What is asked for ends while it moves."""
        c = self.c
        c[ix.STATUS] = ix.ENDED
        c[ix.END_ROTATION] = c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X]
        c[ix.END_OMEGA], c[ix.END_RATE] = c[ix.DIRECTION] * c[ix.OMEGA], c[ix.DIRECTION] * rate
        self._reach()

    def _far(self, r: Floats) -> Floats:
        """The end of a step where the motion is a polynomial, of degree two at most as a rule: past its standstill."""
        c = self.c
        w0, w1 = r[self.program.roles["omega"], :2]
        with np.errstate(divide="ignore", invalid="ignore"):
            stop = np.where(w1 < 0.0, -2.0 * w0 / w1, np.inf)
        return np.where(np.isfinite(stop) & (stop > 0.0), stop, 1e3 + 0.0 * c[ix.TIME])

    def _events(self, r: Floats, h: Floats) -> tuple[Floats, NDArray[np.intp]]:
        """The first event within the step, and its time."""
        c, p = self.c, self.program
        omega = r[p.roles["omega"]]
        # From rest its first root is now: divide by the time as often as it is zero.
        w = omega
        for _ in range(3):
            w = divided(w, w[0] == 0.0)
        found, which = first_root(w, h), np.full(h.shape, ix.EVENT_STANDSTILL, dtype=np.intp)
        # It rests at once where its drive vanished to rounding or points backwards.
        found = np.where((w[0] < 0.0) | ((w[0] == 0.0) & (value(omega, h) == 0.0)), 0.0, found)

        def later(k: int, series: Floats, passed: Any = False) -> None:
            nonlocal found, which
            at = first_root(divided(series, passed), h)
            which = np.where(at < found, k, which)
            found = np.minimum(found, at)

        if (upright := p.roles.get("upright", -1)) >= 0:
            later(ix.EVENT_CHORD_UPRIGHT, r[upright])
        for k, slot in enumerate(p.tables):
            if slot.kind == "time":
                continue
            ahead = -(omega if slot.kind == "speed" else r[p.roles["x"]])
            bound = np.where(np.isfinite(c[slot.cells + ix.UPPER]), c[slot.cells + ix.UPPER], 1e300)
            ahead[0] += bound
            later(ix.EVENT_BREAKPOINT + 2 * k, ahead, (c[ix.PASSED] == ix.SLOWER) & (slot.kind == "speed"))
            if slot.kind == "speed":
                back = omega.copy()
                back[0] -= c[slot.cells + ix.LOWER]
                back[0] = np.where(c[slot.cells + ix.LOWER] > 0.0, back[0], 1e300)
                later(ix.EVENT_BREAKPOINT + 2 * k + 1, back, c[ix.PASSED] == ix.FASTER)
        if (normal := p.roles["normal"]) >= 0:
            # Water over a mass may change faster than its motion, for which the step was chosen: what presses is a
            # function of the position until the first other event only, and may pass zero twice beyond it.
            pressing = r[normal] * np.where(c[ix.LIFTED] > 0.0, -1.0, 1.0)
            at = first_root(divided(pressing, c[ix.PASSED] == ix.LIFT), np.minimum(found, h))
            which, found = np.where(at <= found, ix.EVENT_LIFT_OFF, which), np.minimum(found, at)
        none = ~np.isfinite(found)
        return np.where(none, h, found), np.where(none, ix.EVENT_NONE, which)

    def stand(self) -> None:
        """At a standstill: where it is now, and whether it stays."""
        c = self.c
        c[ix.ROTATION] += c[ix.DIRECTION] * c[ix.X]
        c[ix.SLIP] += c[ix.X]
        c[ix.X] = c[ix.OMEGA] = 0.0
        c[ix.REST_SINCE] = c[ix.TIME]
        self._note(ix.NOTE_STANDS)
        self._reach()
        self.on(c[ix.FIRST_ONLY] == 0.0, "decide", True)
        self.on(c[ix.FIRST_ONLY] > 0.0, "_carried")

    def _carried(self) -> None:
        """A mass that nothing brings to rest stops its walk at the first standstill where that is so."""
        c, roles = self.c, self.program.roles
        c[ix.DIRECTION] = 1.0
        self.base()
        p0, ps0 = c[roles["cell_p0"]], c[roles["cell_ps0"]]
        most = np.hypot(p0, ps0)
        carried = ~self._changes() & (c[roles["cell_normal0"]] + (most - p0) <= ix.CARRIED * most)
        never = (c[ix.FIRST_ONLY] == 1.0) | carried
        c[ix.STATUS, never] = ix.STOPPED
        self.on(never, "rest")
        self.on(~never, "decide", True)

    def kink(self, event: NDArray[np.intp], rate: Floats) -> None:
        """Base the phase anew where it enters a piece of a table, or is lifted or lands."""
        c, p = self.c, self.program
        roles = p.roles
        drive, scale = c[roles["cell_drive"]].copy(), c[roles["cell_drive_scale"]].copy()
        c[ix.ROTATION] += c[ix.DIRECTION] * c[ix.X]
        c[ix.SLIP] += c[ix.X]
        for k, slot in enumerate(p.tables):
            if slot.kind == "time":
                continue
            at, data = slot.cells, self.tables[k]
            up = event == ix.EVENT_BREAKPOINT + 2 * k
            down = event == ix.EVENT_BREAKPOINT + 2 * k + 1
            if slot.kind == "rotation":
                edge = data.begins(c[at + ix.PIECE].astype(np.intp) + (up & (c[ix.DIRECTION] > 0.0)))
                c[ix.ROTATION] = np.where(up, edge, c[ix.ROTATION])
            elif slot.kind == "slip":
                c[at + ix.PIECE, up] += 1.0
                edge = data.breaks[c[at + ix.PIECE].astype(np.intp)]
                c[ix.SLIP] = np.where(up, edge / c[at + ix.SCALE], c[ix.SLIP])
            else:
                c[ix.OMEGA] = np.where(up, c[at + ix.UPPER], np.where(down, c[at + ix.LOWER], c[ix.OMEGA]))
                c[at + ix.PIECE] += up * 1.0 - down * 1.0
                c[ix.PASSED] = np.where(up, ix.FASTER, np.where(down, ix.SLOWER, c[ix.PASSED]))
            if data.open:
                c[ix.STATUS, up & (c[at + ix.PIECE] == len(data.breaks) - 1)] = ix.NEED
        timed = [p.tables[k].cells + ix.PIECE for k in self.timed]
        before = c[timed]
        self.base()
        scale[np.any(c[timed] != before, axis=0)] = np.inf  # at a break of a function of time, which may leap there
        self._carry(rate, drive, scale)

    def _carry(self, rate: Floats, drive: Floats, scale: Floats) -> None:
        """The drive anew or carried on through the event, whichever is known better."""
        c, roles = self.c, self.program.roles
        net = self._series(0)[0][roles["net"], 0]
        fresh, own = c[roles["cell_drive"]], c[roles["cell_drive_scale"]]
        carried = scale + EPS * (np.abs(rate) + np.abs(net - fresh) + np.abs(drive))
        better = carried < own
        c[roles["cell_drive"]] = np.where(better, fresh + (rate - net), fresh)
        c[roles["cell_drive_scale"]] = np.where(better, carried, own)

    def leapt(self) -> None:
        """Where what presses has leapt, whether the mass is lifted is decided again."""
        c = self.c
        lifted = self._series(0)[0][self.program.roles["normal"], 0] < 0.0
        other = lifted != (c[ix.LIFTED] > 0.0)
        self._lift_time(other & lifted)
        c[ix.LIFTED] = lifted

        self.on(other, "rebase")

    def rebase(self) -> None:
        """The phase goes on from where it is."""
        c = self.c
        c[ix.ROTATION] += c[ix.DIRECTION] * c[ix.X]
        c[ix.SLIP] += c[ix.X]
        self.base()

    # --- the greatest speed -------------------------------------------------------------------------------------------

    def _peak(self, net: Floats, x: Floats, omega: Floats, tau: Floats) -> None:
        """The greatest speed, where the rate falls through zero inside the step."""
        series = divided(net, net[0] == 0.0)
        at = np.where(series[0] > 0.0, first_root(series, tau), np.inf)
        rises = (series[0] < 0.0) & (series[1] > 0.0)
        if np.any(rises):  # it falls at first, and may rise to a peak beyond a trough
            k = np.flatnonzero(rises)
            up = first_root(-series[:, k], tau[k])
            again = np.isfinite(up)
            if np.any(again):
                k, up = k[again], up[again]
                moved = shifted(series[:, k], up)[1:]
                later = first_root(moved, np.maximum(tau[k] - up, 0.0))
                at[k] = np.where(moved[0] > 0.0, up + later, np.inf)
        k = np.flatnonzero(np.isfinite(at))
        if k.size:
            c = self.c
            speed, gone, rate = value(np.stack([omega[:, k], x[:, k], net[:, k]], axis=1), at[k])
            time = c[ix.TIME, k] + at[k]
            better = speed > np.abs(c[ix.PEAK_OMEGA, k])
            self._set_peak(k[better], time[better], gone[better], speed[better], rate[better])

    def _set_peak(self, k: Any, time: Any, gone: Any, speed: Any, rate: Any) -> None:
        c = self.c
        c[ix.PEAK_TIME, k], c[ix.PEAK_ROTATION, k] = time, c[ix.ROTATION, k] + c[ix.DIRECTION, k] * gone
        c[ix.PEAK_OMEGA, k], c[ix.PEAK_RATE, k] = c[ix.DIRECTION, k] * speed, c[ix.DIRECTION, k] * rate
