"""Lanes from their bound numbers to their end: on the compiled walk where there is one, else on NumPy."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.flow import tables, walk
from slipcircle.flow.bind import Bound

Floats = NDArray[np.float64]


def walked(bound: Bound, samples: walk.Samples | None = None) -> Floats:
    """The cells of lanes at their end; tables of Python functions grow as the motion reaches them."""
    cells, data = bound.cells.copy(), list(bound.tables)
    while True:
        walk.walk(bound.program, data, cells, samples)
        asking = cells[walk.STATUS] == walk.NEED
        if not np.any(asking):
            return cells
        for k, grown in bound.functions.items():
            data[k] = _longer(data[k], grown)
        cells[walk.STATUS, asking] = walk.MOVING
        rebased(bound, data, cells, asking)


def _longer(data: tables.Data, grown: Any) -> tables.Data:
    """A Python function's table, twice as long."""
    end = float(data.breaks[-1])
    breaks, pieces = tables.sampled(grown.function, end, end, grown.name)
    return tables.Data(
        np.array([*data.breaks[:-1], *breaks, 2 * end]),
        np.array([*data.coefficients[:-1], *pieces, pieces[-1]]),
        np.zeros(len(data.breaks) + len(breaks)),
        open=True,
    )


def rebased(bound: Bound, data: list[tables.Data], cells: Floats, which: Any) -> None:
    """The phase of lanes that waited for a longer table, based where it goes on."""
    lanes = walk.Lanes(bound.program, data, cells[:, which], None, np.flatnonzero(which))
    lanes.base()
    cells[:, which] = lanes.c
