"""Integration of the lanes of a problem to their end."""

from functools import partial

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import Log, OutputSamples, engine
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.problem import Problem


def integrate_problem(
    problem: Problem, begin: Floats | None = None, samples: OutputSamples | None = None, log: Log | None = None
) -> Floats:
    """Integrate all lanes to their end and return their final cells.

    Parameters
    ----------
    problem : Problem
    begin : ndarray, optional
        Initial cells, by default the problem's.
    samples : Samples, optional
        Sample times and states, filled in place.
    log : list, optional
        List to which the events of the first lane are appended.
    """
    if "viscosity" in problem.recipe.effects:
        begin = problem.cells() if begin is None else begin
        if np.any(begin[ix.END_TIME] == np.inf):
            advance = partial(_integrate, problem, log=log)
            final: Floats = lazy_import("creep").integrate_creeping(problem, begin, samples, advance)
            return final
    return _integrate(problem, begin, samples, log)


def _integrate(problem: Problem, begin: Floats | None, samples: OutputSamples | None, log: Log | None) -> Floats:
    """Return the final cells, (cells, lanes), of lanes that do not creep. The arguments: see `integrate_problem`."""
    while True:
        if log is not None:
            log.clear()
        cells = problem.cells() if begin is None else begin.copy()
        engine().integrate(problem.program, problem.tables(), cells, samples, log)
        if problem.reach_farther(cells[ix.REACH_ROTATION]):
            continue
        if begin is None and samples is None and log is None:
            _decide_again(problem, cells)
        status = cells[ix.STATUS]
        if not status.size or status[status.argmax()] < ix.TOO_LONG:  # for one lane a third of the time of max()
            return cells
        if begin is None and _stop_swinging(problem, cells):
            continue
        _go_on(problem, cells, samples, log)
        if not np.any(cells[ix.STATUS] == ix.NEED):
            return cells
        # One lane determines how far a Python function is needed. Then all lanes start again with the complete table.
        lazy_import("functions").extend_to_end(problem, cells, engine().integrate)


def _decide_again(problem: Problem, cells: Floats) -> None:
    """Solve lanes that start close to their limit friction again, with the exact limit friction.

    ``cells`` are the final cells of the first solution, (cells, lanes), in which these lanes are replaced.
    """
    lanes = problem.refine(cells[ix.CLOSE])
    if len(lanes):
        refined = problem.cells(lanes)
        engine().integrate(problem.program, problem.tables(lanes), refined)
        cells[:, lanes] = refined


def _stop_swinging(problem: Problem, cells: Floats) -> bool:
    """Change the problem so that lanes that turned back too often end at their first standstill.

    ``cells`` are the final cells of the first solution. Return whether there are such lanes, so that the problem must
    be solved again.
    """
    turns_on = cells[ix.TURNS] > ix.MOST_TURNS
    ends = np.isfinite(cells[ix.END_TIME])
    swings = turns_on & ~ends & (cells[ix.STATUS] == ix.TOO_LONG)
    if not swings.any():
        return False
    problem.begin_with(FIRST_ONLY=np.where(swings, 1.0, cells[ix.FIRST_ONLY]))
    return True


def _go_on(problem: Problem, cells: Floats, samples: OutputSamples | None, log: Log | None) -> None:
    """Continue lanes that exceed the number of explicit steps and still move, by implicit steps.

    Their final ``cells`` (cells, lanes), samples and log are updated in place.
    """
    many_steps = cells[ix.STEPS] > ix.MOST_STEPS
    moving = cells[ix.OMEGA] > 0.0
    stopped = cells[ix.STATUS] == ix.TOO_LONG
    (which,) = np.nonzero(stopped & many_steps & moving)
    while which.size:
        lazy_import("stiff").integrate_implicitly(problem, cells, samples, log, which)
        waiting = cells[ix.STATUS, which] == ix.NEED
        which = which[waiting]
        if which.size:
            lazy_import("functions").extend(problem, cells[:, which])


BLOCK = 8200  # lanes per block, which fit into the cache; not a power of two, since rows would share cache lines
ENTRIES = len(ix.CELLS)  # number of cells common to all programs
