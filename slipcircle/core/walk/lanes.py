"""Lanes of a problem, integrated to their end."""

from functools import partial

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.doors import room
from slipcircle.core.problem.problem import Problem
from slipcircle.core.walk.compiled import Log, Samples, engine


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
    if "viscosity" in problem.recipe.effects:
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
        if begin is None and _stop_swinging(problem, cells):
            continue
        _go_on(problem, cells, samples, log)
        if not np.any(cells[ix.STATUS] == ix.NEED):
            return cells
        # One lane finds how far a Python function is needed; then all start again with the whole table.
        room("functions").extend_to_end(problem, cells, engine().integrate)


def _stop_swinging(problem: Problem, cells: Floats) -> bool:
    """Have lanes that turned back too often end at their first standstill; return whether there are any."""
    turns_on = cells[ix.TURNS] > ix.MOST_TURNS
    ends = np.isfinite(cells[ix.END_TIME])
    swings = turns_on & ~ends & (cells[ix.STATUS] == ix.TOO_LONG)
    if not swings.any():
        return False
    problem.ending_first(np.where(swings, 1.0, cells[ix.FIRST_ONLY]))
    return True


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


BLOCK = 8200  # lanes at once, so that their numbers stay in the cache; rows a power of two apart would share its lines
ENTRIES = len(ix.CELLS)  # cells that every lane has, whatever its program
