"""Derivatives of a motion by the numbers of its scene, integrated with it: how they begin, jump and end.

The program differentiates itself; here is what it does not know: the derivatives of what a phase begins with, and how
derivatives jump at an event. A name with ``_dot`` holds derivatives, one for each direction, those of states at a fixed
time. At an event g = 0 the time of the event has

    t_dot = -g_dot/(dg/dt).

What begins there begins with total derivatives, value_dot + rate t_dot, and goes on at fixed times, less the new rate
times t_dot (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.6).
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.core.flow.lane_state import LaneState
from slipcircle.core.flow.pieces import Piece
from slipcircle.core.flow.polynomials import derivative, shifted, value
from slipcircle.core.flow.program import Program
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]


class TableGrowth(NamedTuple):
    """Relative derivatives of a table's scale and factor, and its own derivative by each parameter."""

    scale: Floats
    factor: Floats
    by_parameter: list[Data] | None


class InputGrowth(NamedTuple):
    """Derivatives of the inputs of lanes by each parameter.

    ``time`` is the relative derivative of the unit of time, ``end`` that of the end time over this unit, ``tables``
    those of the program's tables by name.
    """

    time: Floats
    end: Floats
    tables: dict[str, TableGrowth]


class Tangents:
    """Derivatives of one motion; each lane carries one direction."""

    def __init__(self, program: Program, cells: Floats, growth: InputGrowth) -> None:
        (tangent,) = program.tangents
        count = len(program.states) // 2
        self.cells_of = tangent.cells
        self.registers_of = tangent.registers
        self.states = program.states[:count]
        self.growth = growth
        self.none = np.zeros(cells.shape[1])
        self.event_dot = self.none  # of the time at which the phase that is being begun begins
        self.peak_dot = self.rest_dot = self.reach_dot = self.none
        end = cells[ix.END_TIME, 0]
        self.end_dot = growth.end - end * growth.time if np.isfinite(end) else self.none
        self.rates = [0.0] * count  # of the states, before the event
        self.totals: dict[int, Floats] = {}
        self.series = np.zeros((0, 0, 0))
        self.tau = 0.0

    def dot(self, state: LaneState, cell: int) -> Floats:
        """Derivatives of a cell."""
        tangent = self.cells_of.get(cell)
        return self.none if tangent is None else state.cells[tangent].copy()

    def put(self, state: LaneState, cell: int, dots: Any) -> None:
        """Set the derivatives of a cell, if the program carries them."""
        tangent = self.cells_of.get(cell)
        if tangent is not None:
            state.cells[tangent] = dots

    def along(self, register: int, series: Floats, tau: float) -> Floats:
        """Derivatives of a register at a time since the step began."""
        tangent = self.registers_of.get(register)
        return self.none if tangent is None else value(series[tangent], tau + self.none)

    # --- what a phase begins with ------------------------------------------------------------------------------------

    def begin_pieces(self, state: LaneState) -> None:
        """Derivatives of the values and coefficients of tables where a phase begins."""
        for piece in state.pieces:
            if piece.kind != "time":
                self._begin_piece(state, piece)
                continue
            dots = self._taylor_dots(state, piece, 1)
            slope = piece.taylor(1)[1:, 0].sum()
            value_dot = dots[0] + slope * self.event_dot
            self.put(state, piece.slot.cells + ix.VALUE, value_dot)

    def _begin_piece(self, state: LaneState, piece: Piece) -> None:
        """Of the coefficients f c_j(u) p^j: f the factor, u the argument within the piece, p its unit.

        Their derivative is f p^j (c_j (f'/f + j p'/p) + (j + 1) c_(j+1) u' + c_j'), c_j' those of the table itself.
        """
        scale_growth, factor_growth, by_parameter = self.growth.tables[piece.slot.name]
        unit_growth = scale_growth if piece.kind == "slip" else self.none
        local, local_dot, unit = self._argument(state, piece)
        number = piece.index[:1]
        degree = piece.slot.degree
        terms = _about(piece.data, number, local, degree + 2)
        by_table = None if by_parameter is None else _of_table(by_parameter, number, local)
        factor = piece.factor[0]
        for power in range(degree + 1):
            by_units = terms[power] * (factor_growth + power * unit_growth)
            by_place = (power + 1) * terms[power + 1] * local_dot
            dots = by_units + by_place
            if by_table is not None and power < len(by_table):
                dots = dots + by_table[power]
            cell = ix.VALUE if power == 0 else ix.Q1 + power - 1
            self.put(state, piece.slot.cells + cell, factor * unit**power * dots)

    def _argument(self, state: LaneState, piece: Piece) -> tuple[float, Floats, float]:
        """The argument of a table within its piece, its derivatives, and the unit of the program's argument."""
        edge = float(piece.data.begins(piece.index)[0])
        if piece.kind == "rotation":
            rotation = float(state.rotation[0])
            return rotation - edge, self.dot(state, ix.ROTATION), float(state.direction[0])
        scale = float(piece.scale[0])
        growth = self.growth.tables[piece.slot.name].scale
        if piece.kind == "slip":
            slip = float(state.slip[0]) * scale
            slip_dot = self.dot(state, ix.SLIP) * scale + slip * growth
            return max(slip - edge, 0.0), slip_dot, scale
        if piece.number[0] == 0.0:  # constant, below the first speed
            return 0.0, self.none, 1.0
        omega = float(state.omega[0])
        logarithm = math.log(omega * scale / edge)
        logarithm_dot = self.dot(state, ix.OMEGA) / omega + growth
        return logarithm, logarithm_dot, 1.0

    def _taylor_dots(self, state: LaneState, piece: Piece, order: int) -> Floats:
        """Derivatives of a function of time's Taylor coefficients about now, at a fixed time, (terms, directions)."""
        growth = self.growth.tables[piece.slot.name]
        every = _padded(piece.taylor(order + 1)[:, 0], order + 2)
        terms = every[:-1]
        n = np.arange(order + 1)
        slopes = (n + 1) * every[1:]
        time = state.time[0]
        by_factor = terms[:, None] * growth.factor
        by_scale = time * slopes + n * terms
        return by_factor + by_scale[:, None] * growth.scale

    def start_series(self, state: LaneState, series: Floats) -> None:
        """The tangents of functions of time, as increments since the phase began."""
        for piece in state.timed:
            if piece.register in self.registers_of:
                dots = self._taylor_dots(state, piece, series.shape[1] - 1)
                dots[0] -= self.dot(state, piece.slot.cells + ix.VALUE)
                series[self.registers_of[piece.register]] = dots

    # --- events ------------------------------------------------------------------------------------------------------

    def end_step(self, series: Floats, tau: Floats) -> None:
        """Keep the series of a step, and the rates of the states at its end, before anything jumps."""
        self.series = series
        self.tau = float(tau[0])
        self.rates = [float(value(series[rate][:, 0], self.tau)) for _, _, rate in self.states]

    def leave_standstill(self, state: LaneState) -> None:
        """g = omega."""
        self.rest_dot = -self.dot(state, ix.OMEGA) / self.rates[1]
        state.omega = 0.0
        self._leave(state, self.rest_dot)

    def leave_contact(self, state: LaneState) -> None:
        """g = n, the normal force."""
        register = state.program.roles["normal"]
        slope = float(value(derivative(self.series[register])[:, 0], self.tau))
        self._leave(state, -self.along(register, self.series, self.tau) / slope)

    def leave_edge(self, state: LaneState, piece: Piece, lower: bool, rate: float) -> None:
        """g = the argument of a table less its edge, which varies with the table's scale."""
        if piece.kind == "rotation":  # a function of the rotation and its derivatives are continuous
            self._leave(state, self.none)
            return
        next_piece = piece.index[0] + (not lower)
        edge = float(piece.data.breaks[next_piece].flat[0]) / float(piece.scale[0])
        edge_growth = edge * self.growth.tables[piece.slot.name].scale
        if piece.kind == "slip":
            slip_dot = self.dot(state, ix.SLIP) + self.dot(state, ix.X)
            event_dot = -(edge_growth + slip_dot) / state.omega[0]
        else:
            event_dot = -(edge_growth + self.dot(state, ix.OMEGA)) / rate
        self._leave(state, event_dot)

    def leave_rest(self, state: LaneState, sudden: bool) -> None:
        """g = the drive at rest; after a jump the time of the break in s, which is an input."""
        self.event_dot = self.none
        drive = state.program.roles["cell_drive"]
        net = state.program.roles["net"]
        if sudden:
            event_dot = -state.time[0] * self.growth.time
        else:
            at_rest, _ = state.expand(np.ones(state.count), at_rest=True)
            event_dot = -self.dot(state, drive) / at_rest[net, 1, 0]
        self.rates = [0.0 for _ in self.states]
        self._leave(state, event_dot)

    def leave_now(self, state: LaneState) -> None:
        """g = a time in s, which is an input."""
        self.rates = self._rates_now(state)
        self._leave(state, -state.time[0] * self.growth.time)

    def _rates_now(self, state: LaneState) -> list[float]:
        registers = state.registers()
        return [float(registers[rate, 0]) for _, _, rate in self.states]

    def _leave(self, state: LaneState, event_dot: Floats) -> None:
        """Total derivatives in the present state, for a phase that begins here."""
        omega = state.omega[0]
        moved = self.dot(state, ix.X) + omega * event_dot
        rotation_dot = self.dot(state, ix.ROTATION) + state.direction[0] * moved
        slip_dot = self.dot(state, ix.SLIP) + moved
        self.put(state, ix.ROTATION, rotation_dot)
        self.put(state, ix.SLIP, slip_dot)
        self.put(state, ix.X, -omega * event_dot)
        self.totals = {}
        for (cell, _, _), rate in zip(self.states[1:], self.rates[1:], strict=True):
            self.totals[cell] = self.dot(state, cell) + rate * event_dot
        self.event_dot = event_dot

    def enter(self, state: LaneState) -> None:
        """Convert total derivatives to those at fixed times, with the rates of the new phase."""
        rates = self._rates_now(state)
        for (cell, _, _), rate in zip(self.states[1:], rates[1:], strict=True):
            at_fixed_time = self.totals[cell] - rate * self.event_dot
            self.put(state, cell, at_fixed_time)
        self.event_dot = self.none

    def enter_or_rest(self, state: LaneState) -> None:
        if state.status[0] == ix.MOVING:
            self.enter(state)
        else:
            self.put(state, ix.OMEGA, 0.0)
            self.event_dot = self.none

    def enter_from_rest(self, state: LaneState, sudden: bool) -> None:
        """Begin slip; where the drive passes zero smoothly, its derivatives are zero."""
        if sudden:
            self.enter(state)
        else:
            self.put(state, state.program.roles["cell_drive"], 0.0)
            self.put(state, ix.OMEGA, 0.0)
            self.event_dot = self.none

    def pass_break(self, state: LaneState) -> None:
        """A function of time has jumped, at a time in s which is an input, and the phase continues."""
        event_dot = -state.time[0] * self.growth.time
        rates = self._rates_now(state)
        for (cell, _, _), before, after in zip(self.states[1:], self.rates[1:], rates[1:], strict=True):
            jump = (before - after) * event_dot
            self.put(state, cell, self.dot(state, cell) + jump)

    # --- outcomes ----------------------------------------------------------------------------------------------------

    def rotation_dot(self, state: LaneState) -> Floats:
        """Derivatives of the present rotation, or of that at the end time."""
        travelled = self.dot(state, ix.X) + state.omega[0] * self.end_dot
        return self.dot(state, ix.ROTATION) + state.direction[0] * travelled

    def keep_reach(self, state: LaneState) -> None:
        self.reach_dot = self.rotation_dot(state)

    def keep_peak(self, state: LaneState, time: float, rate: float, series: Floats | None) -> None:
        """Derivatives of the greatest speed: within a step, at the end, at a jump, or at the start of a phase."""
        if series is not None:
            since = time - float(state.time[0])
            self.peak_dot = self.along(state.program.roles["omega"], series, since)
            return
        if np.any(self.event_dot):
            self.peak_dot = self.totals[ix.OMEGA]
            return
        time_dot = self.none
        if time >= state.end_time[0]:
            time_dot = self.end_dot
        elif time >= state.next_break()[0]:
            time_dot = -time * self.growth.time
        self.peak_dot = self.dot(state, ix.OMEGA) + rate * time_dot


def _about(data: Data, piece: NDArray[np.intp], local: float, count: int) -> Floats:
    """Coefficients of a piece of a table about a place within it."""
    terms = shifted(data.polynomial(piece), np.array([local]))
    return _padded(terms[:, 0], count)


def _padded(terms: Floats, count: int) -> Floats:
    """Terms filled up with zeros."""
    padded = np.zeros(count)
    padded[: len(terms)] = terms[:count]
    return padded


def _of_table(by_parameter: list[Data], piece: NDArray[np.intp], local: float) -> Floats:
    """Coefficients of the derivatives of a table by each parameter, about a place within a piece, (terms, ...)."""
    polynomials = np.concatenate([data.polynomial(piece) for data in by_parameter], axis=1)
    places = np.full(len(by_parameter), local)
    return np.asarray(shifted(polynomials, places))
