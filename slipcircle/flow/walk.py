"""The walk of lanes through their motion, in NumPy: series, step, event, phase, rest; the same as `generated/_flow.c`.

A lane is a column of ``cells``. One round makes one step of every lane: of a moving one along its Taylor series, of a
resting one to the next break of what changes with time. Events are roots of the series that the step has anyway.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import flow as generated
from generated.series import scalar_ops, series_ops
from slipcircle.flow.polynomials import first_root, increment, shifted, slopes, value
from slipcircle.flow.program import Program, Table
from slipcircle.flow.tables import Data

Floats = NDArray[np.float64]
EPS = 2.0**-52

(TIME, ROTATION, SLIP, DIRECTION, LIFTED, STATUS, STEPS, PHASES, ORDER, FACTOR, END_TIME, ONE_WAY, FIRST_ONLY, LIMIT,
 LIMIT_LOW, PEAK_TIME, PEAK_ROTATION, PEAK_OMEGA, PEAK_RATE, REACH_TIME, REACH_ROTATION, END_ROTATION, END_OMEGA,
 END_RATE, FIRST_STOP, CLOSE, LIFT_TIME, PASSED, REST_SINCE, TURNS, LAST_WAY, X, OMEGA) = range(33)  # fmt: skip
CELLS = generated.CELLS
assert CELLS[:33][-2:] == ("x", "omega")
START, MOVING, RESTING, ARRESTED, ENDED, STOPPED, UPRIGHT, TOO_LONG, FAILED, NEED = range(10)
PIECE, VALUE, INC, UPPER, LOWER, SCALE, SCALED_BY, Q1 = range(8)  # of a table's cells
MOST_STEPS, MOST_TURNS = 2e5, 2000
NOTHING, LIFT, FASTER, SLOWER, STOOD = range(5)  # what a phase has just passed, and that it has just ended
BEGINS, STANDS, LIFTS, LANDS = 1, 2, 3, 4  # kinds of events in a log
Log = list[tuple[int, float, float, float]]  # kind, time, rotation, direction


class Samples(NamedTuple):
    """States at given times, filled while the lanes walk: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states


def walk(program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None = None,
         log: Log | None = None) -> None:  # fmt: skip
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
    live = np.flatnonzero(cells[STATUS] <= RESTING)
    with np.errstate(all="ignore"):
        while live.size:
            here = [t.lanes(live) for t in tables]
            lanes = Lanes(program, here, np.ascontiguousarray(cells[:, live]), samples, live, log)
            rounds = 0
            while True:
                lanes.round()
                rounds += 1
                going = lanes.c[STATUS] <= RESTING
                if np.count_nonzero(going) <= live.size // 2 or rounds == 10_000:
                    break
            cells[:, live] = lanes.c
            live = live[going]


class Lanes:
    """Some lanes on their way: columns of cells that this class steps, each by itself."""

    def __init__(self, program: Program, tables: Sequence[Data], cells: Floats, samples: Samples | None,
                 which: NDArray[np.intp], log: Log | None = None) -> None:  # fmt: skip
        self.program, self.tables, self.c, self.samples, self.which = program, tables, cells, samples, which
        self.log = log
        self.timed = [k for k, t in enumerate(program.tables) if t.kind == "time"]

    def part(self, mask: Any) -> "Lanes":
        k = np.flatnonzero(mask)
        if k.size == self.c.shape[1]:
            return self
        return Lanes(
            self.program, [t.lanes(k) for t in self.tables], self.c[:, k], self.samples, self.which[k], self.log
        )

    def on(self, mask: Any, do: str, *args: Any) -> None:
        """Let some of the lanes do something, and take over what became of them."""
        if np.any(mask):
            part = self.part(mask)
            getattr(part, do)(*args)
            if part is not self:
                self.c[:, mask] = part.c

    def round(self) -> None:
        status = self.c[STATUS].copy()
        self.on(status == START, "start")
        self.on(status == MOVING, "step")
        self.on(status == RESTING, "wait")
        lost = ~np.isfinite(self.c[TIME] + self.c[X] + self.c[OMEGA] + self.c[ROTATION]) & (self.c[STATUS] <= RESTING)
        self.c[STATUS, lost] = FAILED
        long = (self.c[STEPS] > MOST_STEPS) | ((self.c[TURNS] > MOST_TURNS) & (len(self.timed) == 0))
        self.c[STATUS, long & (self.c[STATUS] <= RESTING)] = TOO_LONG

    # --- phases ------------------------------------------------------------------------------------------------------

    def start(self) -> None:
        """A lane that moves at first begins its first phase; one that rests is asked whether it stays."""
        c = self.c
        c[DIRECTION] = np.sign(c[OMEGA])
        c[OMEGA] = np.abs(c[OMEGA])
        self.find_pieces()
        self.on(c[OMEGA] > 0.0, "begin")
        self.on(c[OMEGA] == 0.0, "decide")

    def base(self) -> None:
        """The numbers of a phase that begins where the lane is: pieces of tables, and the prologue."""
        c = self.c
        c[X] = 0.0
        for slot, data in zip(self.program.tables, self.tables, strict=True):
            self._piece(slot, data)
        scalar_ops(self.program.scalar, c)

    def find_pieces(self) -> None:
        """The pieces in which the lanes' slips and speeds lie, wherever they came from."""
        c = self.c
        for slot, data in zip(self.program.tables, self.tables, strict=True):
            if slot.kind in ("slip", "speed"):
                argument = c[SLIP if slot.kind == "slip" else OMEGA] * c[slot.cells + SCALE]
                c[slot.cells + PIECE] = np.maximum(np.searchsorted(data.breaks, argument, side="right") - 1, 0)

    def begin(self) -> None:
        """A phase of motion begins, in the direction that is set; what presses decides whether it is lifted."""
        c = self.c
        c[STATUS], c[PASSED], c[LIFTED] = MOVING, NOTHING, 0.0
        self.base()
        normal = self.program.roles["normal"]
        presses = c[self.program.roles["cell_normal0"]] if normal < 0 else self._series(0)[0][normal, 0]
        c[LIFTED] = presses < 0.0
        self.on(c[LIFTED] > 0.0, "base")
        c[PHASES] += 1.0
        c[TURNS] += c[LAST_WAY] * c[DIRECTION] < 0.0
        c[LAST_WAY] = c[DIRECTION]
        self._note(BEGINS)
        self._lift_time(c[LIFTED] > 0.0)
        self._fastest(c[OMEGA], c[TIME], c[ROTATION], self._series(0)[0][self.program.roles["net"], 0])

    def decide(self) -> None:
        """At a standstill: the way in which the mass moves on, if any; else it rests, or waits for another time."""
        c = self.c
        c[X] = c[OMEGA] = 0.0
        best = np.zeros(c.shape[1])
        for side in (1.0, -1.0):
            net = self._margin(side)
            best = np.where((net > 0.0) & (best == 0.0), side, best)
        c[DIRECTION] = best
        self.on(best != 0.0, "begin")
        still = best == 0.0
        self._lift_time(still & (c[LIFTED] > 0.0))
        waits = still & self._changes()
        c[STATUS, waits] = RESTING
        c[STATUS, still & ~waits] = ARRESTED
        self.on(still & ~waits, "rest")

    def _margin(self, side: float) -> Floats:
        """The drive less the resistance at rest, in one direction; minus infinity where it may not start that way."""
        c = self.c
        self._face(side)
        roles = self.program.roles
        net = c[roles["cell_drive"]]
        terms = np.abs(c[roles["cell_driving"]]) + c[roles["cell_resisting"]]
        scale = np.maximum(EPS * (terms + c[roles["cell_mu"]] * np.abs(c[roles["cell_normal0"]])), 1e-300)
        # What has just stopped does not go on the way it came: rounding must not say so.
        allowed = self.may_start(side) & ((c[PASSED] != STOOD) | (c[LAST_WAY] != side))
        c[CLOSE] = np.where(allowed, np.minimum(c[CLOSE], np.abs(net) / scale), c[CLOSE])
        return np.where(allowed, net, -np.inf)

    def _face(self, side: float) -> None:
        """The numbers of a phase from rest in one direction."""
        c = self.c
        toggled, lifted = c[PASSED] == LIFT, c[LIFTED].copy()  # just now, at rest
        c[DIRECTION], c[LIFTED] = side, 0.0
        self.base()
        c[LIFTED] = np.where(toggled, lifted, c[self.program.roles["cell_normal0"]] <= 0.0)
        self.on(c[LIFTED] > 0.0, "base")

    def may_start(self, side: float) -> Any:
        """Shaking starts a one-way mass only down-slope, the way in which gravity pulls it where it lies."""
        c = self.c
        pulled = c[self.program.roles["cell_f0"]]  # in the direction of this side
        return (c[ONE_WAY] == 0.0) | (pulled > 0.0) | ((pulled == 0.0) & (side > 0.0))

    def rest(self) -> None:
        """A lane that stays where it is."""
        c = self.c
        c[END_ROTATION], c[END_OMEGA], c[END_RATE] = c[ROTATION], 0.0, 0.0
        over = c[REST_SINCE] > c[END_TIME]  # cannot be, but for rounding
        c[REST_SINCE, over] = c[END_TIME, over]
        self._read(c[TIME], np.full(c.shape[1], np.inf), None)

    # --- pieces of tables --------------------------------------------------------------------------------------------

    def _piece(self, slot: Table, data: Data) -> None:
        """Where a phase begins: the piece's bounds, its value and the coefficients of what is beyond."""
        c, at = self.c, slot.cells
        factor = c[at + SCALED_BY]
        if slot.kind == "time":
            self._time_piece(slot, data)
            c[at + INC] = 0.0
            terms = self._local(slot, data)
            c[at + VALUE] = terms[0]
            return
        if slot.kind == "rotation":
            terms, powers = self._turned(slot, data)
        else:
            terms, powers = self._passed(slot, data)
        c[at + VALUE] = factor * terms[0]
        for j in range(1, slot.degree + 1):
            c[at + Q1 + j - 1] = factor * terms[j] * powers**j if j < len(terms) else 0.0

    def _turned(self, slot: Table, data: Data) -> tuple[Floats, Floats]:
        """Of the rotation, which goes either way: the piece that lies ahead, about now, in the direction of travel."""
        c, at = self.c, slot.cells
        turn, side = c[ROTATION], c[DIRECTION]
        piece, last = data.entered(turn, side > 0.0), len(data.breaks) - 1
        c[at + PIECE] = piece
        edge, above = data.begins(piece), data.begins(np.minimum(piece + 1, last))
        bound = np.where(side > 0.0, np.where(piece < last, above, np.inf), np.where(piece > 0, edge, -np.inf))
        c[at + UPPER] = side * (bound - turn)
        return shifted(data.polynomial(piece), turn - edge), side

    def _passed(self, slot: Table, data: Data) -> tuple[Floats, Floats]:
        """Of slip or speed."""
        c, at = self.c, slot.cells
        scale = c[at + SCALE]
        piece = c[at + PIECE].astype(np.intp)
        edge, last = data.breaks[piece], len(data.breaks) - 1
        poly = data.polynomial(piece)
        above = np.where(piece < last, data.breaks[np.minimum(piece + 1, last)], np.inf)
        if slot.kind == "slip":
            local = np.maximum(c[SLIP] * scale - edge, 0.0)
            c[at + UPPER] = (above - edge - local) / scale
            return shifted(poly, local), scale
        else:
            moving = c[OMEGA] * scale > 0.0
            local = np.where(moving, np.log(np.where(moving, c[OMEGA] * scale, edge) / edge), 0.0)
            inside = piece > 0  # piece 0 is constant, below the first speed
            local = np.where(inside, local, 0.0)
            c[at + UPPER], c[at + LOWER] = above / scale, np.where(inside, edge / scale, 0.0)
            return shifted(poly, local), np.ones_like(scale)

    def _time_piece(self, slot: Table, data: Data) -> None:
        c, at = self.c, slot.cells
        now = c[TIME] * c[at + SCALE]
        piece = np.maximum(np.searchsorted(data.breaks, now * (1 + 2 * EPS), side="right") - 1, c[at + PIECE])
        c[at + PIECE] = np.maximum(piece, 0)
        self._time_bound(slot, data)

    def _time_bound(self, slot: Table, data: Data) -> None:
        c, at = self.c, slot.cells
        piece, last = c[at + PIECE].astype(np.intp), len(data.breaks) - 1
        next_ = data.breaks[np.minimum(piece + 1, last)] / c[at + SCALE]
        c[at + UPPER] = np.where(piece < last, next_, np.inf)

    def _local(self, slot: Table, data: Data) -> Floats:
        """Taylor coefficients of a function of time about now, in the dimensionless time."""
        c, at = self.c, slot.cells
        scale, factor = c[at + SCALE], c[at + SCALED_BY]
        piece = c[at + PIECE].astype(np.intp)
        poly, local = data.polynomial(piece), c[TIME] * scale - data.breaks[piece]
        if data.sine:
            amplitude, rate, phase = poly
            angle = rate * local + phase
            wave = (np.sin(angle), np.cos(angle), -np.sin(angle), -np.cos(angle))
            terms = [amplitude * wave[0]]
            size = amplitude
            for j in range(1, int(c[ORDER].max()) + 1):
                size = size * (rate * scale) / j
                terms.append(size * wave[j % 4])
            return np.array(terms) * factor
        return shifted(poly, local) * scale ** np.arange(len(poly))[:, None] * factor

    def _changes(self) -> Any:
        """Whether something will still change while it rests."""
        c, found = self.c, np.zeros(self.c.shape[1], dtype=bool)
        for k in self.timed:
            found |= np.isfinite(c[self.program.tables[k].cells + UPPER]) | self.tables[k].open
        return found

    def _break(self) -> Floats:
        """The next time at which something breaks."""
        c, found = self.c, np.full(self.c.shape[1], np.inf)
        for k in self.timed:
            found = np.minimum(found, c[self.program.tables[k].cells + UPPER])
        return found

    def _pass_breaks(self, at_break: Any) -> Any:
        """Enter the next piece of each table that breaks now; whether a value leaps."""
        c = self.c
        leaps = np.zeros(c.shape[1], dtype=bool)
        for k in self.timed:
            slot, data = self.program.tables[k], self.tables[k]
            at, last = slot.cells, len(data.breaks) - 1
            over = at_break & (c[at + UPPER] <= c[TIME])
            if np.any(over):
                piece = np.minimum(c[at + PIECE, over].astype(np.intp) + 1, last)
                c[at + PIECE, over] = piece
                jump = data.jumps[piece] * c[at + SCALED_BY, over]
                c[at + INC, over] += jump
                leaps[over] |= jump != 0.0
                self._time_bound(slot, data)
                if data.open:
                    c[STATUS, over & (c[at + PIECE] == last)] = NEED
        return leaps

    # --- series ------------------------------------------------------------------------------------------------------

    def _series(self, order: int, frozen: bool = False) -> tuple[Floats, Floats]:
        """All registers, (registers, order + 1, lanes), and their coefficients' last useful order in each lane."""
        c, p = self.c, self.program
        r = np.zeros((len(p.registers), order + 1, c.shape[1]))
        self._ramps(r)
        for cell, register, _ in p.states:
            r[register, 0] = c[cell]
        last = c[ORDER].copy()
        limit = np.minimum(self._break(), c[END_TIME]) - c[TIME] if self.timed and not frozen else None
        small = np.zeros(c.shape[1], dtype=int)
        for n in range(order + 1):
            series_ops(p.series, r, c, n)
            if n == order:
                break
            if not frozen:
                for _, register, rate in p.states:
                    r[register, n + 1] = r[rate, n] / (n + 1)
            if limit is not None and n >= 2:
                # Dense records: stop where further terms do not count within the piece.
                size = np.zeros(c.shape[1])
                for _, register, _ in p.states[:2]:
                    scaled = np.abs(r[register, : n + 2]) * limit ** np.arange(n + 2)[:, None]
                    size = np.maximum(size, scaled[-1] / np.maximum(scaled[:-1].max(axis=0), 1e-300))
                small = np.where(size < 2.0**-56, small + 1, 0)
                last = np.where((small == 2) & (last > n + 1), n + 1, last)
                if np.all(last <= n + 1):
                    break
        if np.any(last < order):
            r *= np.arange(order + 1)[None, :, None] <= last
        return r, last

    def _ramps(self, r: Floats) -> None:
        """The registers of what changes with time, as increments since the phase began."""
        for k in self.timed:
            slot = self.program.tables[k]
            terms = self._local(slot, self.tables[k])[: r.shape[1]]
            r[slot.register, : len(terms)] = terms
            r[slot.register, 0] = self.c[slot.cells + INC]

    def _length(self, r: Floats, last: Floats, registers: Sequence[int]) -> Floats:
        """The step: a share of the least radius of convergence that the last four coefficients tell."""
        c = self.c
        lanes = np.arange(c.shape[1])
        radius = np.full(c.shape[1], np.inf)
        top = last.astype(np.intp)
        for register in registers:
            size = np.log2(np.abs(r[register]))
            for back in range(4):
                n = np.maximum(top - back, 5)
                n = np.minimum(n, len(size) - 1)
                here = size[n, lanes]
                reach = np.max([(size[k] - here) / (n - k) for k in range(5) if k < len(size)], axis=0)
                radius = np.minimum(radius, np.where(np.isneginf(here) | (n <= 4), np.inf, reach))
        return np.asarray(c[FACTOR] * np.exp2(radius))

    # --- motion ------------------------------------------------------------------------------------------------------

    def step(self) -> None:
        """One step of lanes that move, up to their next event."""
        c, p = self.c, self.program
        order = int(c[ORDER].max())
        r, last = self._series(order)
        x, omega, net = (r[p.roles[n]] for n in ("x", "omega", "net"))
        limit = np.minimum(self._break(), c[END_TIME])
        room = limit - c[TIME]
        states = [register for _, register, _ in p.states]
        h = self._length(r, last, states)
        early = last < c[ORDER]
        h = np.where(early, room, np.minimum(h, room))
        h = np.where(np.isfinite(h), h, self._far(r))
        at_limit = h >= room
        tau, event = self._events(r, h)
        at_limit &= event < 0
        self._peak(net, x, omega, tau)
        self._read(c[TIME], np.where(at_limit, limit, c[TIME] + tau), (x, omega, net, r))
        c[STEPS] += ~at_limit  # a record takes as many as it has samples
        for cell, register, _ in p.states:
            c[cell] += increment(r[register], tau)
        for k in self.timed:
            slot = p.tables[k]
            c[slot.cells + INC] += increment(r[slot.register], tau)
        c[TIME] = np.where(at_limit, limit, c[TIME] + tau)
        self.settle(event, value(net, tau), at_limit)

    def settle(self, event: NDArray[np.intp], rate: Floats, at_limit: Any) -> None:
        """What follows from where a step has ended: an event, a break of what changes with time, the end."""
        c, p = self.c, self.program
        c[PASSED] = NOTHING
        self.on(event == 0, "stand")
        if 1 <= event.max(initial=-1):
            lifting = event == 1
            c[LIFTED, lifting] = 1.0 - c[LIFTED, lifting]
            self._lift_time(lifting & (c[LIFTED] > 0.0))
            if lifting[0] and c[LIFTED, 0] == 0.0:
                self._note(LANDS)
            kinks = event >= 1
            part, rates = self.part(kinks), rate[kinks]
            part.kink(event[kinks], rates)
            if part is not self:
                c[:, kinks] = part.c
            c[PASSED, lifting] = LIFT
        c[STATUS, event == 99] = UPRIGHT
        going = c[STATUS] == MOVING
        self._fastest(c[OMEGA], c[TIME], c[ROTATION] + c[DIRECTION] * c[X], rate, going)
        ends = at_limit & going & (c[TIME] >= c[END_TIME])
        if np.any(ends):
            c[END_ROTATION] = np.where(ends, c[ROTATION] + c[DIRECTION] * c[X], c[END_ROTATION])
            c[END_OMEGA] = np.where(ends, c[DIRECTION] * c[OMEGA], c[END_OMEGA])
            c[END_RATE] = np.where(ends, c[DIRECTION] * rate, c[END_RATE])
            self._reach(ends)
            c[STATUS, ends] = ENDED
        leaps = self._pass_breaks(at_limit & ~ends & going)
        if np.any(leaps) and p.roles["normal"] >= 0:
            self.on(leaps, "leapt")

    def _far(self, r: Floats) -> Floats:
        """The end of a step where the motion is a polynomial, of degree two at most as a rule: past its standstill."""
        c = self.c
        w0, w1 = r[self.program.roles["omega"], :2]
        with np.errstate(divide="ignore", invalid="ignore"):
            stop = np.where(w1 < 0.0, -2.0 * w0 / w1, np.inf)
        return np.where(np.isfinite(stop) & (stop > 0.0), stop, 1e3 + 0.0 * c[TIME])

    def _events(self, r: Floats, h: Floats) -> tuple[Floats, NDArray[np.intp]]:
        """The first event within the step and its time: 0 standstill, 1 lift-off or landing, 2.. tables, 99 upright."""
        c, p = self.c, self.program
        omega = r[p.roles["omega"]]
        # From rest its first root is now: divide by the time as often as it is zero.
        w = omega
        for _ in range(3):
            zero = w[0] == 0.0
            if not np.any(zero):
                break
            w = np.where(zero, np.vstack([w[1:], 0.0 * w[:1]]), w)
        found, which = first_root(w, h), np.zeros(h.shape, dtype=np.intp)
        # It rests at once where its drive vanished to rounding or points backwards.
        found = np.where(w[0] < 0.0, 0.0, found)

        def later(k: int, series: Floats, passed: Any = None) -> None:
            nonlocal found, which
            if passed is not None and np.any(passed):
                series = np.where(passed, np.vstack([series[1:], 0.0 * series[:1]]), series)
            at = first_root(series, h)
            which = np.where(at < found, k, which)
            found = np.minimum(found, at)

        if (normal := p.roles["normal"]) >= 0:
            later(1, r[normal] * np.where(c[LIFTED] > 0.0, -1.0, 1.0), c[PASSED] == LIFT)
        if (upright := p.roles.get("upright", -1)) >= 0:
            later(99, r[upright])
        for k, slot in enumerate(p.tables):
            if slot.kind == "time":
                continue
            ahead = -(omega if slot.kind == "speed" else r[p.roles["x"]])
            bound = np.where(np.isfinite(c[slot.cells + UPPER]), c[slot.cells + UPPER], 1e300)
            ahead[0] += bound
            later(2 + 2 * k, ahead, c[PASSED] == SLOWER if slot.kind == "speed" else None)
            if slot.kind == "speed":
                back = omega.copy()
                back[0] -= c[slot.cells + LOWER]
                back[0] = np.where(c[slot.cells + LOWER] > 0.0, back[0], 1e300)
                later(3 + 2 * k, back, c[PASSED] == FASTER)
        none = ~np.isfinite(found)
        return np.where(none, h, found), np.where(none, -1, which)

    def stand(self) -> None:
        """At a standstill: where it is now, and whether it stays."""
        c = self.c
        c[ROTATION] += c[DIRECTION] * c[X]
        c[SLIP] += c[X]
        c[X] = c[OMEGA] = 0.0
        c[PASSED] = STOOD
        c[REST_SINCE] = c[TIME]
        self._note(STANDS)
        c[FIRST_STOP] = np.where(np.isnan(c[FIRST_STOP]), c[TIME], c[FIRST_STOP])
        self._reach(np.ones(c.shape[1], dtype=bool))
        self.on(c[FIRST_ONLY] == 0.0, "decide")
        self.on(c[FIRST_ONLY] > 0.0, "_carried")

    def _carried(self) -> None:
        """A mass that nothing brings to rest stops its walk at the first standstill where that is so."""
        c, roles = self.c, self.program.roles
        c[DIRECTION] = 1.0
        self.base()
        p0, ps0 = c[roles["cell_p0"]], c[roles["cell_ps0"]]
        most = np.hypot(p0, ps0)
        never = (c[FIRST_ONLY] == 1.0) | (c[roles["cell_normal0"]] + (most - p0) <= 0.01 * most)
        c[STATUS, never] = STOPPED
        self.on(never, "rest")
        self.on(~never, "decide")

    def kink(self, event: NDArray[np.intp], rate: Floats) -> None:
        """Base the phase anew where it enters a piece of a table, or is lifted or lands."""
        c, p = self.c, self.program
        roles = p.roles
        drive, scale = c[roles["cell_drive"]].copy(), c[roles["cell_drive_scale"]].copy()
        c[ROTATION] += c[DIRECTION] * c[X]
        c[SLIP] += c[X]
        for k, slot in enumerate(p.tables):
            if slot.kind == "time":
                continue
            at, data = slot.cells, self.tables[k]
            up, down = event == 2 + 2 * k, event == 3 + 2 * k
            if slot.kind == "rotation":
                edge = data.begins(c[at + PIECE].astype(np.intp) + (up & (c[DIRECTION] > 0.0)))
                c[ROTATION] = np.where(up, edge, c[ROTATION])
            elif slot.kind == "slip":
                c[at + PIECE, up] += 1.0
                edge = data.breaks[c[at + PIECE].astype(np.intp)]
                c[SLIP] = np.where(up, edge / c[at + SCALE], c[SLIP])
            else:
                c[OMEGA] = np.where(up, c[at + UPPER], np.where(down, c[at + LOWER], c[OMEGA]))
                c[at + PIECE] += up * 1.0 - down * 1.0
                c[PASSED] = np.where(up, FASTER, np.where(down, SLOWER, c[PASSED]))
            if data.open:
                c[STATUS, up & (c[at + PIECE] == len(data.breaks) - 1)] = NEED
        self.base()
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
        other = lifted != (c[LIFTED] > 0.0)
        self._lift_time(other & lifted)
        c[LIFTED] = lifted

        self.on(other, "rebase")

    def rebase(self) -> None:
        """The phase goes on from where it is."""
        c = self.c
        c[ROTATION] += c[DIRECTION] * c[X]
        c[SLIP] += c[X]
        self.base()

    # --- rest --------------------------------------------------------------------------------------------------------

    def wait(self) -> None:
        """One step of lanes at rest: to the next break of what changes with time, or to where the mass starts."""
        c, p = self.c, self.program
        net_of = p.roles["net"]
        begins, way, jumps = np.full(c.shape[1], np.inf), np.zeros(c.shape[1]), np.zeros(c.shape[1], dtype=bool)
        limit = self._break()
        h = np.where(np.isfinite(limit), limit - c[TIME], 1.0)
        stretch = h.copy()
        margins = []
        for side in (1.0, -1.0):
            self._face(side)
            r, last = self._series(int(c[ORDER].max()), frozen=True)
            stretch = np.minimum(stretch, self._length(r, last, [net_of]))
            touching = np.abs(r[net_of, 0]) <= 2 * c[p.roles["cell_drive_scale"]]
            margins.append((side, r[net_of].copy(), self.may_start(side) | np.zeros(c.shape[1], dtype=bool), touching))
        self._lift_time(c[LIFTED] > 0.0)
        for side, net, allowed, touching in margins:
            now = allowed & (net[0] > 0.0) & ~touching
            series = -net
            series = np.where(touching, np.vstack([series[1:], 0.0 * series[:1]]), series)
            at = np.where(now, 0.0, first_root(series, stretch))
            at = np.where(touching & (series[0] < 0.0), 0.0, at)
            sooner = allowed & (at < begins)
            begins, way = np.where(sooner, at, begins), np.where(sooner, side, way)
            jumps = np.where(sooner, now, jumps)
        lifts = np.full(c.shape[1], np.inf)
        if (normal := p.roles["normal"]) >= 0:
            series = r[normal] * np.where(c[LIFTED] > 0.0, -1.0, 1.0)
            passed = c[PASSED] == LIFT
            series = np.where(passed, np.vstack([series[1:], 0.0 * series[:1]]), series)
            lifts = first_root(series, stretch)
            lifts[lifts > begins * (1.0 + 1e-9)] = np.inf  # where both pass zero, it is lifted and does not start
            begins[np.isfinite(lifts)] = np.inf
            stretch = np.minimum(stretch, lifts)
        starts = np.isfinite(begins)
        until = np.where(starts, c[TIME] + begins, np.where(stretch < h, c[TIME] + stretch, limit))
        over = ~starts & ~np.isfinite(until)
        late = (until >= c[END_TIME]) & ~over
        self._read(c[TIME], np.minimum(until, c[END_TIME]), None)
        c[DIRECTION] = way
        lifted = np.isfinite(lifts) & ~starts & ~over
        c[PASSED] = np.where(lifted, LIFT, NOTHING)
        c[LIFTED] = np.where(lifted, 1.0 - c[LIFTED], c[LIFTED])
        c[STATUS, over] = ARRESTED
        self.on(over, "rest")
        c[TIME] = np.where(over, c[TIME], until)
        self._lift_time(lifted & (c[LIFTED] > 0.0))
        self._pass_breaks(~starts & ~over & (c[TIME] >= limit))
        ended = starts & late
        c[STATUS, ended] = ENDED
        self.on(ended, "rest")

        goes = starts & ~late
        self.on(goes, "start_again", jumps[goes])

    def start_again(self, jump: Any) -> None:
        """A phase from rest, where the margin passes zero: unless that leaps, what drives is zero and no more."""
        self.begin()
        self.c[self.program.roles["cell_drive"], ~jump] = 0.0

    # --- what is remembered ------------------------------------------------------------------------------------------

    def _peak(self, net: Floats, x: Floats, omega: Floats, tau: Floats) -> None:
        """The greatest speed, where the rate falls through zero inside the step."""
        series = net
        touching = series[0] == 0.0
        if np.any(touching):
            series = np.where(touching, np.vstack([series[1:], 0.0 * series[:1]]), series)
        at = np.where(series[0] > 0.0, first_root(series, tau), np.inf)
        rises = (series[0] < 0.0) & (slopes(series)[0] > 0.0) if len(series) > 1 else np.zeros(tau.shape, bool)
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
            speed, gone, rate = (value(s[:, k], at[k]) for s in (omega, x, net))
            time = c[TIME, k] + at[k]
            better = speed > np.abs(c[PEAK_OMEGA, k])
            self._set_peak(k[better], time[better], gone[better], speed[better], rate[better])

    def _set_peak(self, k: Any, time: Any, gone: Any, speed: Any, rate: Any) -> None:
        c = self.c
        c[PEAK_TIME, k], c[PEAK_ROTATION, k] = time, c[ROTATION, k] + c[DIRECTION, k] * gone
        c[PEAK_OMEGA, k], c[PEAK_RATE, k] = c[DIRECTION, k] * speed, c[DIRECTION, k] * rate

    def _fastest(self, speed: Floats, time: Floats, rotation: Floats, rate: Floats, mask: Any = True) -> None:
        """A candidate for the greatest speed: the start of a phase, or the end of a step."""
        c = self.c
        k = np.flatnonzero((speed > np.abs(c[PEAK_OMEGA])) & mask)
        c[PEAK_TIME, k], c[PEAK_ROTATION, k] = time[k], rotation[k]
        c[PEAK_OMEGA, k], c[PEAK_RATE, k] = (c[DIRECTION] * speed)[k], (c[DIRECTION] * rate)[k]

    def _reach(self, mask: Any) -> None:
        c = self.c
        rotation = c[ROTATION] + c[DIRECTION] * c[X]
        k = np.flatnonzero(mask & (np.abs(rotation) > np.abs(c[REACH_ROTATION])))
        c[REACH_TIME, k], c[REACH_ROTATION, k] = c[TIME, k], rotation[k]

    def _note(self, kind: int) -> None:
        """Write an event of the first lane down."""
        if self.log is not None and self.which[0] == 0:
            c = self.c
            self.log.append((kind, float(c[TIME, 0]), float(c[ROTATION, 0]), float(c[DIRECTION, 0])))

    def _lift_time(self, mask: Any) -> None:
        c = self.c
        if mask[0]:
            self._note(LIFTS)
        first = mask & np.isnan(c[LIFT_TIME])
        c[LIFT_TIME, first] = c[TIME, first]

    def _read(self, begin: Floats, end: Floats, series: Any) -> None:
        """The states at sample times from one time, up to but without another."""
        if self.samples is None:
            return
        c, s, p = self.c, self.samples, self.program
        for lane, column in enumerate(self.which):
            times = s.times[:, column]
            first, last = np.searchsorted(times, (begin[lane], end[lane]), side="left")
            if np.isfinite(c[END_TIME, lane]) and end[lane] >= c[END_TIME, lane]:
                last = np.searchsorted(times, end[lane], side="right")
            if last <= first:
                continue
            into = s.states[:, first:last, column]
            into[0], into[1:3], into[3] = c[ROTATION, lane], 0.0, c[SLIP, lane]
            for k, (cell, register, _) in enumerate(p.states[2:]):
                into[4 + k] = c[cell, lane]
                if series is not None:
                    into[4 + k] = value(series[3][register, :, lane, None], times[first:last] - begin[lane])
            if series is None:
                continue
            past = times[first:last] - begin[lane]
            x, omega, net = (value(y[:, lane, None], past) for y in series[:3])
            side = c[DIRECTION, lane]
            into[0] += side * x
            into[3] += x
            into[1], into[2] = side * omega, side * net
