"""The pieces of tables that a phase of a lane needs: their ends, and their coefficients about the start of the phase.

A table is a function in pieces of slip, speed, rotation or time (`slipcircle.core.flow.tables`). Of the first three a
phase holds the coefficients in powers of what is beyond its start; of time the increment since.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS
from slipcircle.core.flow.entries import Entry, LaneEntries
from slipcircle.core.flow.polynomials import shifted
from slipcircle.core.flow.program import Table
from slipcircle.core.flow.tables import Data

Floats = NDArray[np.float64]


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
        if self.kind in ("slip", "speed"):
            argument = self.state.slip if self.kind == "slip" else self.state.omega
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
        terms = shifted(polynomial, local)
        self.value = self.factor * terms[0]
        degree = self.slot.degree
        coefficients = self.cells[ix.Q1 : ix.Q1 + degree]
        coefficients[:] = 0.0
        for power in range(1, min(len(terms), degree + 1)):
            coefficients[power - 1] = self.factor * terms[power] * unit**power

    def _edges(self) -> tuple[Floats, Floats]:
        """The breaks at which the piece and the next one begin; infinity after the last."""
        next_piece = np.minimum(self.index + 1, self.last)
        next_edge = self.data.begins(next_piece)
        return self.data.begins(self.index), np.where(self.number < self.last, next_edge, np.inf)

    def _enter_rotation(self) -> tuple[Floats, Floats]:
        """The piece ahead, in the direction of travel, of a function of the rotation, which goes either way."""
        rotation = self.state.rotation
        direction = self.state.direction
        down_slope = direction > 0.0
        self.number = self.data.entered(rotation, down_slope)
        edge, above = self._edges()
        below = np.where(self.number > 0, edge, -np.inf)
        ahead = np.where(down_slope, above, below)
        self.upper = direction * (ahead - rotation)
        return rotation - edge, direction

    def _enter_slip(self) -> tuple[Floats, Floats]:
        edge, next_edge = self._edges()
        beyond = self.state.slip * self.scale - edge
        local = np.maximum(beyond, 0.0)
        self.upper = (next_edge - edge - local) / self.scale
        return local, self.scale

    def _enter_speed(self) -> tuple[Floats, Floats]:
        """Polynomials of the logarithm of the speed; piece 0, below the first speed, is constant."""
        edge, next_edge = self._edges()
        speed = self.state.omega * self.scale
        varies = self.number > 0
        self.upper = next_edge / self.scale
        self.lower = np.where(varies, edge / self.scale, 0.0)
        divisor = np.where(varies, edge, 1.0)
        ratio = np.where(varies & (speed > 0.0), speed / divisor, 1.0)
        return np.log(ratio), np.ones_like(ratio)

    # --- functions of time -------------------------------------------------------------------------------------------

    def _begin_time(self) -> None:
        now = self.state.time * self.scale
        begun = np.searchsorted(self.data.breaks, now * (1.0 + 2 * EPS), side="right")
        self.number = np.maximum(np.maximum(begun - 1, self.number), 0)
        self.increment = 0.0
        self.way = 0.0
        self.value = self.taylor(1)[0]
        self._find_end()

    def _find_end(self) -> None:
        """The end of the piece and the increment there, with one rounding error whatever the number of steps."""
        _, next_edge = self._edges()
        self.upper = next_edge / self.scale
        past = np.where(self.number < self.last, self.upper - self.state.time, 0.0)
        rise = self._rise_of_sine(past) if self.data.sine else self._rise_of_polynomial(past)
        self.lower = self.increment + rise
        self.way += np.abs(rise)

    def _rise_of_sine(self, past: Floats) -> Floats:
        """A (sin(angle + r) - sin(angle)) = 2 A sin(r/2) cos(angle + r/2)."""
        amplitude, rate, phase = self.data.polynomial(self.index)
        half = 0.5 * rate * past * self.scale
        angle = rate * self._local() + phase
        return np.asarray(2.0 * self.factor * amplitude * np.sin(half) * np.cos(angle + half))

    def _rise_of_polynomial(self, past: Floats) -> Floats:
        rise = np.zeros_like(past)
        for term in self.taylor(1)[:0:-1]:
            rise = (rise + term) * past
        return rise

    def _local(self) -> Floats:
        """The time since the piece began, in its own unit."""
        return np.asarray(self.state.time * self.scale - self.data.breaks[self.index])

    def taylor(self, order: int) -> Floats:
        """Taylor coefficients of a function of time about the present, in the dimensionless time."""
        polynomial = self.data.polynomial(self.index)
        local = self._local()
        if self.data.sine:
            return self._taylor_of_sine(polynomial, local, order)
        powers = np.arange(len(polynomial))
        units = self.scale ** powers[:, None]
        return shifted(polynomial, local) * units * self.factor

    def _taylor_of_sine(self, polynomial: Floats, local: Floats, order: int) -> Floats:
        amplitude, rate, phase = polynomial
        angle = rate * local + phase
        sine = np.sin(angle)
        cosine = np.cos(angle)
        derivatives = (sine, cosine, -sine, -cosine)
        size = amplitude * self.factor
        terms = []
        for power in range(order + 1):
            terms.append(size * derivatives[power % 4])
            size = size * (rate * self.scale / (power + 1))
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
        long = way > rounding
        self.increment = np.where(long, value - self.value, self.lower + jump)
        self.way = np.where(long, rounding, way)
        self._find_end()
        return jump != 0.0
