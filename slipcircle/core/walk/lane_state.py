"""Lanes in NumPy: the entries of their states by name, the phase each is in, and the series of its motion.

A lane is one motion among many that share a program. All of it is in a column of ``cells``, so that it may be left and
taken up again after any step; `generated.layout` says what stands where.
"""

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from generated.series import scalar_ops, series_ops
from slipcircle.base.kinds import Floats
from slipcircle.core.program.program import Log, Program, Samples
from slipcircle.core.scene.piecewise import Data
from slipcircle.core.walk.entries import LaneEntries
from slipcircle.core.walk.pieces import Piece
from slipcircle.core.walk.polynomials import increment

Lanes = NDArray[np.intp]
NEGLIGIBLE = 2.0**-56  # of the largest term of a series, which a term has to be below to end the series early


class LaneState(LaneEntries):
    """Some lanes of a program; attributes are entries of the state, one number for each lane.

    Parameters
    ----------
    program : Program
    tables : sequence of Data
        For each table of the program, of these lanes.
    cells : ndarray
        (cells, lanes), changed in place.
    lanes : ndarray of int, optional
        Which lanes of an ensemble these are; by default the first.
    samples, log : Samples, list, optional
        What to read off on the way, and where events of lane 0 are written.
    tangents : slipcircle.derivatives.tangents.Tangents, optional
        Derivatives carried along, one direction in each lane; the lanes are alike otherwise.
    """

    def __init__(
        self,
        program: Program,
        tables: Sequence[Data],
        cells: Floats,
        lanes: Lanes | None = None,
        samples: Samples | None = None,
        log: Log | None = None,
        tangents: Any = None,
    ) -> None:
        self.program = program
        self.tables = tables
        self.cells = cells
        if lanes is None:
            lanes = np.arange(cells.shape[1])
        self.lanes = lanes
        self.samples = samples
        self.log = log
        self.tangents = tangents
        self.pieces = list[Piece]()
        for slot, data in zip(program.tables, tables, strict=True):
            piece = Piece(self, slot, data)
            self.pieces.append(piece)
        self.timed = [piece for piece in self.pieces if piece.kind == "time"]

    @property
    def count(self) -> int:
        return self.cells.shape[1]

    def role(self, name: str) -> Floats:
        """A cell that the prologue of a phase fills, by its role."""
        cell = self.program.roles[f"cell_{name}"]
        return np.asarray(self.cells[cell])

    def part(self, mask: Any) -> Self:
        """Some of the lanes, as copies; the lanes themselves if all are selected."""
        chosen = np.flatnonzero(mask)
        if chosen.size == self.count:
            return self
        tables = [table.lanes(chosen) for table in self.tables]
        cells = self.cells[:, chosen]
        lanes = self.lanes[chosen]
        return type(self)(self.program, tables, cells, lanes, self.samples, self.log, self.tangents)

    def apply_to(self, mask: Any, method: str, *arguments: Any) -> None:
        """Call a method for some of the lanes, with their part of the arguments, and copy their state back."""
        if not np.any(mask):
            return
        part = self.part(mask)
        apply = getattr(part, method)
        apply(*(argument[mask] for argument in arguments))
        if part is not self:
            self.cells[:, mask] = part.cells

    # --- phases ------------------------------------------------------------------------------------------------------

    def find_pieces(self) -> None:
        """Find the pieces of tables in which the slips and speeds of lanes lie."""
        for piece in self.pieces:
            piece.find()

    def begin_phase(self) -> None:
        """Compute the numbers of a phase that begins now: pieces of tables, then the prologue of the program."""
        self.x = 0.0
        for piece in self.pieces:
            piece.begin()
        if self.tangents:
            self.tangents.begin_pieces()
        scalar_ops(self.program.scalar, self.cells)

    def advance_origin(self) -> None:
        """Count rotation and slip from the present state, where another phase begins."""
        self.rotation += self.direction * self.x
        self.slip += self.x
        self.x = 0.0

    def next_break(self) -> Floats:
        """Time of the next break of a function of time; infinite without one."""
        time = np.full(self.count, np.inf)
        for piece in self.timed:
            time = np.minimum(time, piece.upper)
        return time

    def still_changes(self) -> Any:
        """Whether a force will still change while the lane rests."""
        return np.isfinite(self.next_break())

    def pass_breaks(self) -> Any:
        """Enter the next piece of each function of time that breaks now; whether a value jumps there."""
        jumps = np.zeros(self.count, dtype=bool)
        for k, slot in enumerate(self.timed):
            breaks = slot.upper <= self.time
            if np.any(breaks):
                part = self.part(breaks)
                piece = part.timed[k]
                jumps[breaks] |= piece.pass_break()
                self.cells[:, breaks] = part.cells
        return jumps

    def may_start(self) -> Any:
        """Whether a mass at rest may start in its direction: shaking starts a one-way mass only in that of gravity."""
        pull = self.role("driving_moment")
        is_level = pull == 0.0
        goes_down = self.direction > 0.0
        down_slope = (pull > 0.0) | (is_level & goes_down)
        both_ways = self.one_way == 0.0
        return both_ways | down_slope

    # --- series ------------------------------------------------------------------------------------------------------

    def registers(self) -> Floats:
        """All registers in the present states, (registers, lanes)."""
        series = self._started(0)
        series_ops(self.program.series, series, self.cells, 0)
        return series[:, 0]

    def contact(self) -> Floats:
        """Normal force on the slip surface, over that of reference; contact is lost below zero."""
        normal = self.program.roles["normal"]
        if normal < 0:
            return self.role("normal0")
        return self.registers()[normal]

    def expand(self, room: Floats, at_rest: bool = False) -> tuple[Floats, Floats]:
        """Taylor series of all registers in the time from now, and their order in each lane.

        States have one order more than their rates. Where a function of time cuts the step short after ``room``, a
        series ends early, as soon as two terms in a row do not count there. At rest states stay as they are.

        Returns
        -------
        series : ndarray
            (registers, orders, lanes); zero beyond a lane's order.
        order : ndarray
        """
        program = self.program
        roles = self.program.roles
        order = self.order.copy()
        highest = int(order.max())
        series = self._started(highest)
        watched = [roles["x"], roles["omega"]]
        if at_rest:
            watched = [roles["net"]]
        first = series[watched, 0]
        cut = _EarlyEnd(first, room, at_rest)
        for n in range(highest):
            series_ops(program.series, series, self.cells, n)
            known = n
            if not at_rest:
                known = n + 1
                for _, register, rate in program.states:
                    coefficient = series[rate, n] / known
                    series[register, known] = np.where(n < order, coefficient, 0.0)
            if not self.timed:
                continue
            order = cut.shortened(order, n, series[watched, known], known)
            if np.all(order <= n + 1):
                series = series[:, : n + 2]
                break
        powers = np.arange(series.shape[1])
        within_order = powers[:, None] < order
        for name in ("net", "normal", "upright"):
            register = roles.get(name, -1)
            if register >= 0:
                series[register] *= within_order
        return series, order

    def _started(self, order: int) -> Floats:
        """Order 0 of the registers of states, and the series of functions of time, as increments since the phase."""
        registers = len(self.program.registers)
        series = np.zeros((registers, order + 1, self.count))
        for cell, register, _ in self.program.states:
            series[register, 0] = self.cells[cell]
        for piece in self.timed:
            ramp = series[piece.register]
            if order:
                terms = piece.taylor(order)
                ramp[: len(terms)] = terms
            ramp[0] = piece.increment
        if self.tangents:
            self.tangents.start_series(series)
        return series

    def advance_functions_of_time(self, tau: Floats) -> None:
        """Advance the increments of functions of time by a step."""
        highest = int(self.order.max(initial=0.0))
        for piece in self.timed:
            terms = piece.taylor(highest)
            piece.increment += increment(terms, tau)


class _EarlyEnd:
    """Where series end early, as two terms in a row are negligible at the end of the step beside the largest one."""

    def __init__(self, first: Floats, room: Floats, at_rest: bool) -> None:
        self.room = room
        self.largest = np.abs(first)
        if at_rest:
            self.largest = np.zeros(first.shape)
        self.in_a_row = np.zeros(room.size)

    def shortened(self, order: Floats, n: int, coefficients: Floats, power: int) -> Floats:
        """The orders of lanes, after these coefficients of the watched registers, at a power of the time."""
        size = np.abs(coefficients)
        term = size * self.room**power
        largest = self.largest
        comparable = np.isfinite(largest) & (largest != 0.0)
        counts = (term > NEGLIGIBLE * largest) | ~comparable
        larger = term > largest
        self.largest = np.where(larger, term, largest)
        any_counts = np.any(counts, axis=0)
        one_more = self.in_a_row + 1.0
        self.in_a_row = np.where(any_counts, 0.0, one_more)
        if n < 2:
            return order
        ends = (self.in_a_row >= 2.0) & (n < order)
        shorter = np.minimum(order, n + 1)
        return np.where(ends, shorter, order)
