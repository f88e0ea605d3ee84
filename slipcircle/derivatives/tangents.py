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
from slipcircle.base.kinds import Floats
from slipcircle.core.scene.piecewise import Data
from slipcircle.core.walk.lane_state import LaneState
from slipcircle.core.walk.pieces import Piece
from slipcircle.core.walk.polynomials import derivative, shifted, value


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


class _Dot:
    """Derivatives of an entry of the state as an attribute; assigning sets them, if the program carries them."""

    def __init__(self, cell: int) -> None:
        self.cell = cell

    def __get__(self, tangents: "Tangents", owner: object = None) -> Floats:
        return tangents.dot(self.cell)

    def __set__(self, tangents: "Tangents", dots: Any) -> None:
        tangents.put(self.cell, dots)


class _Argument(NamedTuple):
    """The argument of a table within its piece, its derivatives, and the unit of the program's argument."""

    local: float
    dot: Floats
    unit: float


class Tangents:
    """Derivatives of one motion; each lane carries one direction."""

    rotation_dot = _Dot(ix.ROTATION)
    slip_dot = _Dot(ix.SLIP)
    x_dot = _Dot(ix.X)
    omega_dot = _Dot(ix.OMEGA)

    def __init__(self, state: LaneState, growth: InputGrowth) -> None:
        program = state.program
        (tangent,) = program.tangents
        count = len(program.states) // 2
        self.state = state
        self.growth = growth
        self.roles = program.roles
        self.cells_of = tangent.cells
        self.registers_of = tangent.registers
        states = program.states[1:count]  # but x
        self.rate_registers = {cell: rate for cell, _, rate in states}
        self.rates = dict.fromkeys(self.rate_registers, 0.0)  # before the event
        self.totals: dict[int, Floats] = {}
        self.none = np.zeros(state.count)
        self.event_dot = self.none  # of the time at which the phase that is being begun begins
        self.peak_dot = self.none
        self.rest_dot = self.none
        self.reach_dot = self.none
        self.series = np.zeros((0, 0, 0))
        self.tau = 0.0

    def dot(self, cell: int) -> Floats:
        """Derivatives of a cell."""
        tangent = self.cells_of.get(cell)
        if tangent is None:
            return self.none
        return self.state.cells[tangent].copy()

    def put(self, cell: int, dots: Any) -> None:
        """Set the derivatives of a cell, if the program carries them."""
        tangent = self.cells_of.get(cell)
        if tangent is not None:
            self.state.cells[tangent] = dots

    def along(self, role: str, series: Floats, tau: float) -> Floats:
        """Derivatives of a register at a time since the step began."""
        register = self.roles[role]
        tangent = self.registers_of.get(register)
        if tangent is None:
            return self.none
        return value(series[tangent], tau + self.none)

    # --- what a phase begins with ------------------------------------------------------------------------------------

    def begin_pieces(self) -> None:
        """Derivatives of the values and coefficients of tables where a phase begins."""
        for piece in self.state.pieces:
            if piece.kind == "time":
                self._begin_time(piece)
            else:
                self._begin_piece(piece)

    def _begin_time(self, piece: Piece) -> None:
        """Of the value of a function of time, which begins at the time of the event."""
        at_fixed_time = self._taylor_dots(piece, 1)[0]
        slope = piece.taylor(1)[1:, 0].sum()
        value_dot = at_fixed_time + slope * self.event_dot
        self.put(piece.slot.cells + ix.VALUE, value_dot)

    def _begin_piece(self, piece: Piece) -> None:
        """Of the coefficients f c_j(u) p^j: f the factor, u the argument within the piece, p its unit.

        Their derivative is f p^j (c_j (f'/f + j p'/p) + (j + 1) c_(j+1) u' + c_j'), c_j' those of the table itself.
        """
        growth = self.growth.tables[piece.slot.name]
        unit_growth = growth.scale if piece.kind == "slip" else self.none
        local, local_dot, unit = self._argument(piece)
        number = piece.index[:1]
        degree = piece.slot.degree
        polynomial = piece.data.polynomial(number)
        about_local = shifted(polynomial, np.array([local]))
        terms = _padded(about_local[:, 0], degree + 2)
        by_table = _of_table(growth.by_parameter, number, local)
        factor = piece.factor[0]
        first_cell = piece.slot.cells
        for power in range(degree + 1):
            relative = growth.factor + power * unit_growth
            slope = (power + 1) * terms[power + 1]
            dots = terms[power] * relative + slope * local_dot
            if power < len(by_table):
                dots = dots + by_table[power]
            cell = ix.Q1 + power - 1 if power else ix.VALUE
            size = factor * unit**power
            self.put(first_cell + cell, size * dots)

    def _argument(self, piece: Piece) -> _Argument:
        state = self.state
        edge = float(piece.data.begins(piece.index)[0])
        if piece.kind == "rotation":
            rotation = float(state.rotation[0])
            direction = float(state.direction[0])
            return _Argument(rotation - edge, self.rotation_dot, direction)
        scale = float(piece.scale[0])
        growth = self.growth.tables[piece.slot.name].scale
        if piece.kind == "slip":
            slip = float(state.slip[0]) * scale
            slip_dot = self.slip_dot * scale + slip * growth
            beyond_edge = max(slip - edge, 0.0)
            return _Argument(beyond_edge, slip_dot, scale)
        if piece.number[0] == 0.0:  # constant, below the first speed
            return _Argument(0.0, self.none, 1.0)
        omega = float(state.omega[0])
        logarithm = math.log(omega * scale / edge)
        logarithm_dot = self.omega_dot / omega + growth
        return _Argument(logarithm, logarithm_dot, 1.0)

    def _taylor_dots(self, piece: Piece, order: int) -> Floats:
        """Derivatives of a function of time's Taylor coefficients about now, at a fixed time, (terms, directions).

        The coefficients are f c_n(s t) s^n: f the factor, s the scale of the time.
        """
        growth = self.growth.tables[piece.slot.name]
        known = piece.taylor(order + 1)
        every = _padded(known[:, 0], order + 2)
        terms = every[:-1]
        n = np.arange(order + 1)
        slopes = (n + 1) * every[1:]
        relative = self.state.time[0] * slopes + n * terms
        by_scale = np.outer(relative, growth.scale)
        by_factor = np.outer(terms, growth.factor)
        return by_factor + by_scale

    def start_series(self, series: Floats) -> None:
        """The tangents of functions of time, as increments since the phase began."""
        order = series.shape[1] - 1
        for piece in self.state.timed:
            tangent = self.registers_of.get(piece.register)
            if tangent is not None:
                dots = self._taylor_dots(piece, order)
                value_cell = piece.slot.cells + ix.VALUE
                dots[0] -= self.dot(value_cell)
                series[tangent] = dots

    # --- events ------------------------------------------------------------------------------------------------------

    @property
    def break_dot(self) -> Floats:
        """Of the present time where it is a time in s, which is an input."""
        return -self.state.time[0] * self.growth.time

    def end_step(self, series: Floats, tau: Floats) -> None:
        """Keep the series of a step, and the rates of the states at its end, before anything jumps."""
        self.series = series
        self.tau = float(tau[0])
        for cell, register in self.rate_registers.items():
            rate = series[register, :, 0]
            self.rates[cell] = float(value(rate, self.tau))

    def leave_standstill(self) -> None:
        """g = omega."""
        rate = self.rates[ix.OMEGA]
        self.rest_dot = -self.omega_dot / rate
        self.state.omega = 0.0
        self._leave(self.rest_dot)

    def leave_contact(self) -> None:
        """g = n, the normal force."""
        normal = self.series[self.roles["normal"]]
        slope = value(derivative(normal)[:, 0], self.tau)
        normal_dot = self.along("normal", self.series, self.tau)
        self._leave(-normal_dot / float(slope))

    def leave_edge(self, piece: Piece, lower: bool, rate: float) -> None:
        """g = the argument of a table less its edge, which varies with the table's scale."""
        if piece.kind == "rotation":  # a function of the rotation and its derivatives are continuous
            self._leave(self.none)
            return
        next_piece = piece.index[0] + (not lower)
        edge = piece.data.breaks[next_piece] / piece.scale[0]
        growth = self.growth.tables[piece.slot.name]
        edge_growth = edge * growth.scale
        if piece.kind == "slip":
            slip_dot = self.slip_dot + self.x_dot
            speed = self.state.omega[0]
            event_dot = -(edge_growth + slip_dot) / speed
        else:
            event_dot = -(edge_growth + self.omega_dot) / rate
        self._leave(event_dot)

    def leave_rest(self, sudden: bool) -> None:
        """g = the drive at rest; after a jump the time of the break in s."""
        self.event_dot = self.none
        if sudden:
            event_dot = self.break_dot
        else:
            time = np.ones(self.state.count)
            series, _ = self.state.expand(time, at_rest=True)
            drive_rate = series[self.roles["net"], 1, 0]
            drive_dot = self.dot(self.roles["cell_drive"])
            event_dot = -drive_dot / drive_rate
        self.rates = dict.fromkeys(self.rates, 0.0)
        self._leave(event_dot)

    def leave_now(self) -> None:
        """g = a time in s."""
        self.rates = self._rates_now()
        self._leave(self.break_dot)

    def _rates_now(self) -> dict[int, float]:
        registers = self.state.registers()
        values = registers[:, 0].tolist()
        return {cell: values[rate] for cell, rate in self.rate_registers.items()}

    def _leave(self, event_dot: Floats) -> None:
        """Total derivatives in the present state, for a phase that begins here."""
        state = self.state
        travelled = state.omega[0] * event_dot
        moved = self.x_dot + travelled
        turned = state.direction[0] * moved
        self.rotation_dot = self.rotation_dot + turned
        self.slip_dot = self.slip_dot + moved
        self.x_dot = -travelled
        for cell, rate in self.rates.items():
            change = rate * event_dot
            self.totals[cell] = self.dot(cell) + change
        self.event_dot = event_dot

    def enter(self) -> None:
        """Convert total derivatives to those at fixed times, with the rates of the new phase."""
        for cell, rate in self._rates_now().items():
            at_fixed_time = self.totals[cell] - rate * self.event_dot
            self.put(cell, at_fixed_time)
        self.event_dot = self.none

    def _enter_rest(self) -> None:
        """The speed is zero, whatever the inputs."""
        self.omega_dot = 0.0
        self.event_dot = self.none

    def enter_or_rest(self) -> None:
        """Begin what follows a standstill."""
        if self.state.status[0] == ix.MOVING:
            self.enter()
        else:
            self._enter_rest()

    def enter_from_rest(self, sudden: bool) -> None:
        """Begin slip; where the drive passes zero smoothly, its derivatives are zero."""
        if sudden:
            self.enter()
        else:
            self.put(self.roles["cell_drive"], 0.0)
            self._enter_rest()

    def pass_break(self) -> None:
        """A function of time has jumped, at a time in s, and the phase continues."""
        for cell, rate in self._rates_now().items():
            jump = (self.rates[cell] - rate) * self.break_dot
            self.put(cell, self.dot(cell) + jump)

    # --- outcomes ----------------------------------------------------------------------------------------------------

    @property
    def end_dot(self) -> Floats:
        """Of the end time."""
        end = self.state.end_time[0]
        if np.isinf(end):
            return self.none
        return self.growth.end - end * self.growth.time

    def present_rotation_dot(self) -> Floats:
        """Derivatives of the present rotation, or of that at the end time."""
        state = self.state
        travelled = state.omega[0] * self.end_dot
        moved = self.x_dot + travelled
        return self.rotation_dot + state.direction[0] * moved

    def keep_reach(self) -> None:
        """Derivatives of the greatest rotation."""
        self.reach_dot = self.present_rotation_dot()

    def keep_peak_within(self, series: Floats, tau: float) -> None:
        """Derivatives of the greatest speed within a step."""
        self.peak_dot = self.along("omega", series, tau)

    def keep_peak(self, rate: float) -> None:
        """Derivatives of the greatest speed at the start of a phase, at the end or at a jump."""
        if np.any(self.event_dot):
            self.peak_dot = self.totals[ix.OMEGA]
            return
        time = self.state.time[0]
        time_dot = self.none
        if time >= self.state.end_time[0]:
            time_dot = self.end_dot
        elif time >= self.state.next_break()[0]:
            time_dot = self.break_dot
        self.peak_dot = self.omega_dot + rate * time_dot


def _padded(terms: Floats, count: int) -> Floats:
    """Terms filled up with zeros."""
    padded = np.zeros(count)
    padded[: len(terms)] = terms[:count]
    return padded


def _of_table(by_parameter: list[Data] | None, piece: NDArray[np.intp], local: float) -> Floats:
    """Coefficients of the derivatives of a table by each parameter, about a place within a piece, (terms, ...)."""
    if by_parameter is None:
        return np.zeros((0, 0))
    polynomials = [data.polynomial(piece) for data in by_parameter]
    places = np.full(len(by_parameter), local)
    return shifted(np.concatenate(polynomials, axis=1), places)
