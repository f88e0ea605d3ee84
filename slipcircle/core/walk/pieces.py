"""The pieces of tables that a phase of a lane needs: their ends, and their coefficients about the start of the phase.

A table is a function in pieces of slip, speed, rotation or time (`slipcircle.tables.tables`). Of the first three a
phase holds the coefficients in powers of what is beyond its start; of time the increment since.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats
from slipcircle.core.program.program import Table
from slipcircle.core.scene.piecewise import Data
from slipcircle.core.walk.entries import Entry, LaneEntries
from slipcircle.core.walk.polynomials import increment, shifted


class _Sine(NamedTuple):
    """A sin(angle), of which the angle changes with the rate."""

    amplitude: Floats
    rate: Floats
    angle: Floats


class Piece:
    """The pieces of one table in which lanes are.

    Attributes
    ----------
    number, value, increment, upper, lower, scale, factor, way : ndarray
        Entries of the state, as `generated.layout` says; of a function of time ``lower`` is its increment at ``upper``.
    """

    number = Entry(ix.PIECE)
    value = Entry(ix.VALUE)
    increment = Entry(ix.INC)
    way = Entry(ix.WAY)
    upper = Entry(ix.UPPER)
    lower = Entry(ix.LOWER)
    scale = Entry(ix.SCALE)
    factor = Entry(ix.SCALED_BY)

    def __init__(self, state: LaneEntries, slot: Table, data: Data) -> None:
        self.state = state
        self.slot = slot
        self.data = data
        self.kind = slot.kind
        self.register = slot.register
        self.last = len(data.breaks) - 1

    @property
    def cells(self) -> Floats:
        return self.state.cells[self.slot.cells :]

    @property
    def index(self) -> NDArray[np.intp]:
        return self.number.astype(np.intp)

    def find(self) -> None:
        """The piece in which the lane's slip or speed lies."""
        if self.kind == "slip":
            argument = self.state.slip
        elif self.kind == "speed":
            argument = self.state.omega
        else:
            return
        begun = np.searchsorted(self.data.breaks, argument * self.scale, side="right")
        self.number = np.maximum(begun - 1, 0)

    def begin(self) -> None:
        """Begin a phase: the bounds of the piece, its value, and the coefficients about the start."""
        if self.kind == "time":
            self._begin_time()
            return
        if self.kind == "rotation":
            local, unit = self._enter_rotation()
        elif self.kind == "slip":
            local, unit = self._enter_slip()
        else:
            local, unit = self._enter_speed()
        polynomial = self.data.polynomial(self.index)
        terms = shifted(polynomial, local) * self.factor
        self.value = terms[0]
        degree = self.slot.degree
        coefficients = self.cells[ix.Q1 : ix.Q1 + degree]
        coefficients[:] = 0.0
        known = terms[1 : degree + 1]
        for power, term in enumerate(known, start=1):
            coefficients[power - 1] = term * unit**power

    def _edges(self) -> tuple[Floats, Floats]:
        """The breaks at which the piece and the next one begin; infinity after the last."""
        edge = self.data.begins(self.index)
        is_last = self.number >= self.last
        next_piece = np.minimum(self.index + 1, self.last)
        next_edge = self.data.begins(next_piece)
        return edge, np.where(is_last, np.inf, next_edge)

    def _enter_rotation(self) -> tuple[Floats, Floats]:
        """The piece ahead, in the direction of travel, of a function of the rotation, which goes either way."""
        rotation = self.state.rotation
        direction = self.state.direction
        down_slope = direction > 0.0
        self.number = self.data.entered(rotation, down_slope)
        edge, above = self._edges()
        is_first = self.number == 0
        below = np.where(is_first, -np.inf, edge)
        ahead = np.where(down_slope, above, below)
        distance = ahead - rotation
        self.upper = direction * distance
        return rotation - edge, direction

    def _enter_slip(self) -> tuple[Floats, Floats]:
        edge, next_edge = self._edges()
        slip = self.state.slip * self.scale
        local = np.maximum(slip - edge, 0.0)
        distance = next_edge - edge - local
        self.upper = distance / self.scale
        return local, self.scale

    def _enter_speed(self) -> tuple[Floats, Floats]:
        """Polynomials of the logarithm of the speed; piece 0, below the first speed, is constant."""
        edge, next_edge = self._edges()
        varies = self.number > 0
        self.upper = next_edge / self.scale
        self.lower = np.where(varies, edge / self.scale, 0.0)
        speed = self.state.omega * self.scale
        beyond_edge = varies & (speed > 0.0)
        divisor = np.where(beyond_edge, edge, 1.0)
        ratio = np.where(beyond_edge, speed, 1.0) / divisor
        unit = np.ones_like(ratio)
        return np.log(ratio), unit

    # --- functions of time -------------------------------------------------------------------------------------------

    def _begin_time(self) -> None:
        time = self.state.time * self.scale
        slightly_later = time * (1.0 + 2 * EPS)
        begun = np.searchsorted(self.data.breaks, slightly_later, side="right")
        piece = np.maximum(begun - 1, self.number)
        self.number = np.maximum(piece, 0)
        self.increment = 0.0
        self.way = 0.0
        self.value = self.taylor(1)[0]
        self._find_end()

    def _find_end(self) -> None:
        """The end of the piece and the increment there, with one rounding error whatever the number of steps."""
        _, next_edge = self._edges()
        self.upper = next_edge / self.scale
        time_left = self.upper - self.state.time
        time_left[np.isinf(next_edge)] = 0.0
        if self.data.sine:
            rise = self._rise_of_sine(time_left)
        else:
            rise = increment(self.taylor(1), time_left)
        self.lower = self.increment + rise
        self.way += np.abs(rise)

    def _rise_of_sine(self, time_left: Floats) -> Floats:
        """A (sin(angle + r) - sin(angle)) = 2 A sin(r/2) cos(angle + r/2)."""
        sine = self._sine()
        half = 0.5 * sine.rate * time_left * self.scale
        doubled = 2.0 * sine.amplitude * np.sin(half)
        middle = np.cos(sine.angle + half)
        return np.asarray(doubled * middle)

    def _sine(self) -> _Sine:
        """A sine at the present."""
        amplitude, rate, phase = self.data.polynomial(self.index)
        angle = rate * self._local() + phase
        return _Sine(self.factor * amplitude, rate, angle)

    def _local(self) -> Floats:
        """The time since the piece began, in its own unit."""
        time = self.state.time * self.scale
        begin = self.data.breaks[self.index]
        return np.asarray(time - begin)

    def taylor(self, order: int) -> Floats:
        """Taylor coefficients of a function of time about the present, in the dimensionless time."""
        if self.data.sine:
            return self._taylor_of_sine(order)
        polynomial = self.data.polynomial(self.index)
        powers = np.arange(len(polynomial))
        units = self.scale ** powers[:, None]
        terms = shifted(polynomial, self._local())
        return terms * units * self.factor

    def _taylor_of_sine(self, order: int) -> Floats:
        sine = self._sine()
        value = np.sin(sine.angle)
        slope = np.cos(sine.angle)
        derivatives = (value, slope, -value, -slope)
        rate = sine.rate * self.scale
        size = sine.amplitude
        terms = []
        for power in range(order + 1):
            terms.append(size * derivatives[power % 4])
            size = size * (rate / (power + 1))
        return np.array(terms)

    def pass_break(self) -> Any:
        """Enter the next piece of a function of time; whether its value jumps there.

        Increments add their roundings up along a record: beyond some way the difference of two values is better known.
        """
        self.number = np.minimum(self.number + 1.0, self.last)
        jump = self.data.jumps[self.index] * self.factor
        terms = self.data.polynomial(self.index)
        value = self.factor * terms[0]
        if self.data.sine:
            value = value * np.sin(terms[2])
        rounding = np.abs(value) + np.abs(self.value)
        way = self.way + np.abs(jump)
        is_long = way > rounding
        difference = value - self.value
        continued = self.lower + jump
        self.increment = np.where(is_long, difference, continued)
        self.way = np.minimum(way, rounding)
        self._find_end()
        return jump != 0.0
