"""The entries of the state of lanes as attributes, so that equations read like equations."""

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix

Floats = NDArray[np.float64]


class HasCells(Protocol):
    """What has entries: rows of an array, a column for each lane."""

    @property
    def cells(self) -> Floats: ...


class Entry:
    """An entry by name: ``state.omega`` is the row ``state.cells[ix.OMEGA]``, a view; assigning fills it."""

    def __init__(self, row: int) -> None:
        self.row = row

    def __get__(self, holder: HasCells, owner: object = None) -> Floats:
        row: Floats = holder.cells[self.row]
        return row

    def __set__(self, holder: HasCells, values: Any) -> None:
        holder.cells[self.row] = values


class LaneEntries:
    """Lanes as columns of cells; each attribute is an entry of the state, one number of each lane.

    `generated.layout` says what it holds.
    """

    cells: Floats
    time, rotation, slip, direction = Entry(ix.TIME), Entry(ix.ROTATION), Entry(ix.SLIP), Entry(ix.DIRECTION)
    lifted, status, steps, phases = Entry(ix.LIFTED), Entry(ix.STATUS), Entry(ix.STEPS), Entry(ix.PHASES)
    order, factor, end_time = Entry(ix.ORDER), Entry(ix.FACTOR), Entry(ix.END_TIME)
    one_way, first_only, passed = Entry(ix.ONE_WAY), Entry(ix.FIRST_ONLY), Entry(ix.PASSED)
    peak_time, peak_rotation = Entry(ix.PEAK_TIME), Entry(ix.PEAK_ROTATION)
    peak_omega, peak_rate = Entry(ix.PEAK_OMEGA), Entry(ix.PEAK_RATE)
    reach_time, reach_rotation = Entry(ix.REACH_TIME), Entry(ix.REACH_ROTATION)
    end_rotation, end_omega, end_rate = Entry(ix.END_ROTATION), Entry(ix.END_OMEGA), Entry(ix.END_RATE)
    close, lift_time, rest_since = Entry(ix.CLOSE), Entry(ix.LIFT_TIME), Entry(ix.REST_SINCE)
    turns, last_way = Entry(ix.TURNS), Entry(ix.LAST_WAY)
    x, omega = Entry(ix.X), Entry(ix.OMEGA)  # rotation since the phase began, and its rate, in the direction of travel
