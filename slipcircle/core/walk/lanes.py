"""Lanes of a problem: integrated to their end, read on the way, and phases that begin in any states of theirs."""

from collections.abc import Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.doors import room
from slipcircle.core.problem.problem import Problem
from slipcircle.core.program.program import Log, Samples
from slipcircle.core.walk.compiled import engine


def integrate(
    problem: Problem, begin: Floats | None = None, samples: Samples | None = None, log: Log | None = None
) -> Floats:
    """Integrate all lanes to their end: their final cells.

    Parameters
    ----------
    problem : Problem
    begin : ndarray, optional
        Cells to begin with, by default the problem's.
    samples : Samples, optional
        States at times on the way; filled in place.
    log : list, optional
        Takes the events of the first lane.
    """
    if problem.may_creep:
        begin = problem.cells() if begin is None else begin
        if np.any(begin[ix.END_TIME] == np.inf):
            walk = partial(_integrate, problem, log=log)
            final: Floats = room("creep").integrate(problem, begin, samples, walk)
            return final
    return _integrate(problem, begin, samples, log)


def _integrate(problem: Problem, begin: Floats | None, samples: Samples | None, log: Log | None) -> Floats:
    """`integrate`, where no mass creeps."""
    while True:
        if log is not None:
            log.clear()
        cells = problem.cells() if begin is None else begin.copy()
        engine().integrate(problem.program, problem.tables(), cells, samples, log)
        if problem.reach_farther(cells[ix.REACH_ROTATION]):
            continue
        status = cells[ix.STATUS]
        if not status.size or status[status.argmax()] < ix.TOO_LONG:  # for one lane a third of the time of max()
            return cells
        _go_on(problem, cells, samples, log)
        if not np.any(cells[ix.STATUS] == ix.NEED):
            return cells
        # One lane finds how far a Python function is needed; then all start again with the whole table.
        room("functions").extend_to_end(problem, cells, engine().integrate)


def _go_on(problem: Problem, cells: Floats, samples: Samples | None, log: Log | None) -> None:
    """Integrate lanes that took too many explicit steps and still move by implicit ones."""
    many_steps = cells[ix.STEPS] > ix.MOST_STEPS
    moving = cells[ix.OMEGA] > 0.0
    stopped = cells[ix.STATUS] == ix.TOO_LONG
    (which,) = np.nonzero(stopped & many_steps & moving)
    while which.size:
        room("stiff").integrate(problem, cells, samples, log, which)
        waiting = cells[ix.STATUS, which] == ix.NEED
        which = which[waiting]
        if which.size:
            room("functions").extend(problem, cells[:, which])


def read(problem: Problem, times: Floats) -> Floats:
    """Rotation, omega, its rate, slip and further states, (rows, times, lanes), at dimensionless times, increasing."""
    rows = np.zeros((2 + len(problem.program.states), *times.shape))
    integrate(problem, samples=Samples(np.ascontiguousarray(times), rows))
    return rows


BLOCK = 8200  # lanes at once, so that their numbers stay in the cache; rows a power of two apart would share its lines
ENTRIES = len(ix.CELLS)  # cells that every lane has, whatever its program


class States(NamedTuple):
    """States of lanes, dimensionless: time, rotation, omega, slip, further states, and the lane of each."""

    time: Any
    rotation: Any
    omega: Any
    further: Any
    lane: Any

    def parts(self) -> Iterator["States"]:
        """The states in blocks."""
        for first in range(0, max(self.lane.size, 1), BLOCK):
            which = slice(first, first + BLOCK)
            further = None if self.further is None else [values[which] for values in self.further]
            yield States(self.time[which], self.rotation[which], self.omega[which], further, self.lane[which])


def begin(problem: Problem, states: States, side: Any) -> tuple[Floats, Floats]:
    """Cells and registers of phases that begin in some states, in a direction of travel."""
    cells = problem.cells(states.lane)
    cells[ix.TIME] = states.time
    cells[ix.ROTATION] = states.rotation
    cells[ix.OMEGA] = abs(states.omega)
    cells[ix.DIRECTION] = side
    cells[ix.LIFTED] = 0.0
    if states.further is not None:
        slip, *others = states.further
        cells[ix.SLIP] = slip
        problem.reach_farther(states.rotation, states.lane)
        if problem.function is not None:
            room("functions").extend(problem, cells)
        for (cell, _, _), value in zip(problem.program.states[2:], others, strict=True):
            cells[cell] = value
    registers = engine().begin_phase(problem.program, problem.tables(states.lane), cells)
    return cells, registers
