"""Lanes as columns of cells, in NumPy: the phase each is in, pieces of tables, series, what is remembered."""

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.series import scalar_ops, series_ops
from slipcircle.base.checks import EPS
from slipcircle.core.flow.polynomials import shifted, value
from slipcircle.core.flow.program import Log, Program, Samples, Table
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]


class Columns:
    """Some lanes: columns of cells, each by itself."""

    def __init__(
        self,
        program: Program,
        tables: Sequence[Data],
        cells: Floats,
        samples: Samples | None,
        which: NDArray[np.intp],
        log: Log | None = None,
    ) -> None:
        self.program, self.tables, self.c, self.samples, self.which = program, tables, cells, samples, which
        self.log = log
        self.timed = [k for k, t in enumerate(program.tables) if t.kind == "time"]

    def part(self, mask: Any) -> Self:
        k = np.flatnonzero(mask)
        if k.size == self.c.shape[1]:
            return self
        return type(self)(
            self.program, [t.lanes(k) for t in self.tables], self.c[:, k], self.samples, self.which[k], self.log
        )

    def on(self, mask: Any, do: str, *args: Any) -> None:
        """Let some of the lanes do something, and take over what became of them."""
        if np.any(mask):
            part = self.part(mask)
            getattr(part, do)(*args)
            if part is not self:
                self.c[:, mask] = part.c

    def find_pieces(self) -> None:
        """The pieces in which the lanes' slips and speeds lie, wherever they came from."""
        c = self.c
        for slot, data in zip(self.program.tables, self.tables, strict=True):
            if slot.kind in ("slip", "speed"):
                argument = c[ix.SLIP if slot.kind == "slip" else ix.OMEGA] * c[slot.cells + ix.SCALE]
                c[slot.cells + ix.PIECE] = np.maximum(np.searchsorted(data.breaks, argument, side="right") - 1, 0)

    def base(self) -> None:
        """The numbers of a phase that begins where the lane is: pieces of tables, and the prologue."""
        c = self.c
        c[ix.X] = 0.0
        for slot, data in zip(self.program.tables, self.tables, strict=True):
            self._piece(slot, data)
        scalar_ops(self.program.scalar, c)

    def may_start(self, side: float) -> Any:
        """Shaking starts a one-way mass only down-slope, the way in which gravity pulls it where it lies."""
        c = self.c
        pulled = c[self.program.roles["cell_f0"]]  # in the direction of this side
        return (c[ix.ONE_WAY] == 0.0) | (pulled > 0.0) | ((pulled == 0.0) & (side > 0.0))

    # --- pieces of tables ---------------------------------------------------------------------------------------------

    def _piece(self, slot: Table, data: Data) -> None:
        """Where a phase begins: the piece's bounds, its value and the coefficients of what is beyond."""
        c, at = self.c, slot.cells
        factor = c[at + ix.SCALED_BY]
        if slot.kind == "time":
            self._time_piece(slot, data)
            c[at + ix.INC] = c[at + ix.WAY] = 0.0
            terms = self._local(slot, data)
            c[at + ix.VALUE] = terms[0]
            return
        terms, powers = (self._turned if slot.kind == "rotation" else self._passed)(slot, data)
        c[at + ix.VALUE] = factor * terms[0]
        for j in range(1, slot.degree + 1):
            c[at + ix.Q1 + j - 1] = factor * terms[j] * powers**j if j < len(terms) else 0.0

    def _turned(self, slot: Table, data: Data) -> tuple[Floats, Floats]:
        """Of the rotation, which goes either way: the piece that lies ahead, about now, in the direction of travel."""
        c, at = self.c, slot.cells
        turn, side = c[ix.ROTATION], c[ix.DIRECTION]
        piece, last = data.entered(turn, side > 0.0), len(data.breaks) - 1
        c[at + ix.PIECE] = piece
        edge, above = data.begins(piece), data.begins(np.minimum(piece + 1, last))
        bound = np.where(side > 0.0, np.where(piece < last, above, np.inf), np.where(piece > 0, edge, -np.inf))
        c[at + ix.UPPER] = side * (bound - turn)
        return shifted(data.polynomial(piece), turn - edge), side

    def _passed(self, slot: Table, data: Data) -> tuple[Floats, Floats]:
        """Of slip or speed."""
        c, at = self.c, slot.cells
        scale = c[at + ix.SCALE]
        piece = c[at + ix.PIECE].astype(np.intp)
        edge, last = data.breaks[piece], len(data.breaks) - 1
        poly = data.polynomial(piece)
        above = np.where(piece < last, data.breaks[np.minimum(piece + 1, last)], np.inf)
        if slot.kind == "slip":
            local = np.maximum(c[ix.SLIP] * scale - edge, 0.0)
            c[at + ix.UPPER] = (above - edge - local) / scale
            return shifted(poly, local), scale
        moving = c[ix.OMEGA] * scale > 0.0
        local = np.where(moving, np.log(np.where(moving, c[ix.OMEGA] * scale, edge) / edge), 0.0)
        inside = piece > 0  # piece 0 is constant, below the first speed
        local = np.where(inside, local, 0.0)
        c[at + ix.UPPER], c[at + ix.LOWER] = above / scale, np.where(inside, edge / scale, 0.0)
        return shifted(poly, local), np.ones_like(scale)

    def _time_piece(self, slot: Table, data: Data) -> None:
        c, at = self.c, slot.cells
        now = c[ix.TIME] * c[at + ix.SCALE]
        piece = np.maximum(np.searchsorted(data.breaks, now * (1 + 2 * EPS), side="right") - 1, c[at + ix.PIECE])
        c[at + ix.PIECE] = np.maximum(piece, 0)
        self._time_bound(slot, data)

    def _time_bound(self, slot: Table, data: Data) -> None:
        c, at = self.c, slot.cells
        piece, last = c[at + ix.PIECE].astype(np.intp), len(data.breaks) - 1
        next_ = data.breaks[np.minimum(piece + 1, last)] / c[at + ix.SCALE]
        c[at + ix.UPPER] = np.where(piece < last, next_, np.inf)

    def _local(self, slot: Table, data: Data, order: int = 0) -> Floats:
        """Taylor coefficients of a function of time about now, in the dimensionless time, up to an order."""
        c, at = self.c, slot.cells
        scale, factor = c[at + ix.SCALE], c[at + ix.SCALED_BY]
        piece = c[at + ix.PIECE].astype(np.intp)
        poly, local = data.polynomial(piece), c[ix.TIME] * scale - data.breaks[piece]
        if data.sine:
            amplitude, rate, phase = poly
            angle = rate * local + phase
            wave = (np.sin(angle), np.cos(angle), -np.sin(angle), -np.cos(angle))
            terms = [amplitude * wave[0]]
            size = amplitude
            for j in range(1, order + 1):
                size = size * (rate * scale) / j
                terms.append(size * wave[j % 4])
            return np.array(terms) * factor
        return shifted(poly, local)[: order + 1] * scale ** np.arange(min(order + 1, len(poly)))[:, None] * factor

    def _changes(self) -> Any:
        """Whether something will still change while it rests."""
        c, found = self.c, np.zeros(self.c.shape[1], dtype=bool)
        for k in self.timed:
            found |= np.isfinite(c[self.program.tables[k].cells + ix.UPPER])
        return found

    def _break(self) -> Floats:
        """The next time at which something breaks."""
        c, found = self.c, np.full(self.c.shape[1], np.inf)
        for k in self.timed:
            found = np.minimum(found, c[self.program.tables[k].cells + ix.UPPER])
        return found

    def _pass_breaks(self, at_break: Any) -> Any:
        """Enter the next piece of each table that breaks now; whether a value leaps."""
        c = self.c
        leaps = np.zeros(c.shape[1], dtype=bool)
        for k in self.timed:
            slot, data = self.program.tables[k], self.tables[k]
            at, last = slot.cells, len(data.breaks) - 1
            over = at_break & (c[at + ix.UPPER] <= c[ix.TIME])
            if np.any(over):
                piece = np.minimum(c[at + ix.PIECE, over].astype(np.intp) + 1, last)
                c[at + ix.PIECE, over] = piece
                jump = data.jumps[piece] * c[at + ix.SCALED_BY, over]
                c[at + ix.INC, over] += jump
                c[at + ix.WAY, over] += np.abs(jump)
                # Increments add their roundings up, along a record: beyond some way the difference of two values is
                # better.
                terms = data.polynomial(piece)
                there = c[at + ix.SCALED_BY, over] * terms[0] * (np.sin(terms[2]) if data.sine else 1.0)
                since = c[at + ix.VALUE, over]
                rounding = np.abs(there) + np.abs(since)
                far = c[at + ix.WAY, over] > rounding
                c[at + ix.INC, over] = np.where(far, there - since, c[at + ix.INC, over])
                c[at + ix.WAY, over] = np.where(far, rounding, c[at + ix.WAY, over])
                leaps[over] |= jump != 0.0
                self._time_bound(slot, data)
        return leaps

    # --- series -------------------------------------------------------------------------------------------------------

    def _series(self, order: int, frozen: bool = False) -> tuple[Floats, Floats]:
        """All registers, (registers, order + 1, lanes), and their coefficients' last useful order in each lane."""
        c, p = self.c, self.program
        r = np.zeros((len(p.registers), order + 1, c.shape[1]))
        self._ramps(r)
        for cell, register, _ in p.states:
            r[register, 0] = c[cell]
        last = c[ix.ORDER].copy()
        limit = np.minimum(self._break(), c[ix.END_TIME]) - c[ix.TIME] if self.timed and not frozen else None
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
            if r.shape[1] > 1:  # or their increments are all that is asked for
                terms = self._local(slot, self.tables[k], r.shape[1] - 1)
                r[slot.register, : len(terms)] = terms
            r[slot.register, 0] = self.c[slot.cells + ix.INC]

    def _length(self, r: Floats, last: Floats, registers: Sequence[int]) -> Floats:
        """The step: a share of the least radius of convergence that the last four coefficients tell."""
        c = self.c
        lanes = np.arange(c.shape[1])
        radius = np.full(c.shape[1], np.inf)
        top = last.astype(np.intp)
        for register in registers:
            first = np.log2(np.abs(r[register, :5]))
            for back in range(4):
                n = np.minimum(np.maximum(top - back, 5), r.shape[1] - 1)
                here = np.log2(np.abs(r[register, n, lanes]))
                reach = ((first - here) / (n - np.arange(len(first))[:, None])).max(axis=0)
                tells = ~np.isneginf(here) & ~np.isneginf(reach) & (n > 4)  # zeros, there or at first, tell nothing
                radius = np.minimum(radius, np.where(tells, reach, np.inf))
        return np.asarray(c[ix.FACTOR] * np.exp2(radius))

    # --- what is remembered -------------------------------------------------------------------------------------------

    def look(self, rate: Floats) -> None:
        """Where it is now may be where it is fastest."""
        c = self.c
        self._fastest(c[ix.OMEGA], c[ix.TIME], c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X], rate)

    def _fastest(self, speed: Floats, time: Floats, rotation: Floats, rate: Floats, mask: Any = True) -> None:
        """A candidate for the greatest speed: the start of a phase, or the end of a step."""
        c = self.c
        k = np.flatnonzero((speed > np.abs(c[ix.PEAK_OMEGA])) & mask)
        c[ix.PEAK_TIME, k], c[ix.PEAK_ROTATION, k] = time[k], rotation[k]
        c[ix.PEAK_OMEGA, k], c[ix.PEAK_RATE, k] = (c[ix.DIRECTION] * speed)[k], (c[ix.DIRECTION] * rate)[k]

    def _reach(self) -> None:
        c = self.c
        rotation = c[ix.ROTATION] + c[ix.DIRECTION] * c[ix.X]
        k = np.flatnonzero(np.abs(rotation) > np.abs(c[ix.REACH_ROTATION]))
        c[ix.REACH_TIME, k], c[ix.REACH_ROTATION, k] = c[ix.TIME, k], rotation[k]

    def _note(self, kind: int) -> None:
        """Write an event of the first lane down."""
        if self.log is not None and self.which[0] == 0:
            c = self.c
            self.log.append((kind, float(c[ix.TIME, 0]), float(c[ix.ROTATION, 0]), float(c[ix.DIRECTION, 0])))

    def _lift_time(self, mask: Any) -> None:
        c = self.c
        if mask[0]:
            self._note(ix.NOTE_LIFTS)
        first = mask & np.isnan(c[ix.LIFT_TIME])
        c[ix.LIFT_TIME, first] = c[ix.TIME, first]

    def _read(self, begin: Floats, end: Floats, series: Any) -> None:
        """The states at sample times from one time, up to but without another."""
        if self.samples is None:
            return
        c, s, p = self.c, self.samples, self.program
        for lane, column in enumerate(self.which):
            times = s.times[:, column]
            first, last = np.searchsorted(times, (begin[lane], end[lane]), side="left")
            if np.isfinite(c[ix.END_TIME, lane]) and end[lane] >= c[ix.END_TIME, lane]:
                last = np.searchsorted(times, end[lane], side="right")
            if last <= first:
                continue
            into = s.states[:, first:last, column]
            into[0], into[1:3], into[3] = c[ix.ROTATION, lane], 0.0, c[ix.SLIP, lane]
            for k, (cell, register, _) in enumerate(p.states[2:]):
                into[4 + k] = c[cell, lane]
                if series is not None:
                    into[4 + k] = value(series[3][register, :, lane, None], times[first:last] - begin[lane])
            if series is None:
                continue
            past = times[first:last] - begin[lane]
            x, omega, net = (value(y[:, lane, None], past) for y in series[:3])
            side = c[ix.DIRECTION, lane]
            into[0] += side * x
            into[3] += x
            into[1], into[2] = side * omega, side * net
