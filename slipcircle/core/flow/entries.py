"""Entries of the state of lanes as attributes."""

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

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
