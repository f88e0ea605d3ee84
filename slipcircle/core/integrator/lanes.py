"""Integration of the lanes of a problem to their end."""

from functools import partial

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import NOTHING, Log, OutputSamples, engine
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.problem import NEAR, Problem


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
        # A lane that waits for a function in Python goes on from complete cells.
        if begin is None and problem.lanes > 1 and "STATUS" not in problem.start and not problem.functions:
            cells, shared = problem.sparse_cells()
        else:
            cells, shared = problem.cells() if begin is None else begin.copy(), NOTHING
        engine().integrate(problem.program, problem.tables(), cells, samples, log, shared)
        if problem.reach_farther(cells[ix.REACH_ROTATION]):
            continue
        if begin is None and samples is None and log is None:
            _decide_again(problem, cells)
        status = cells[ix.STATUS]
        if not status.size or status[status.argmax()] < ix.TOO_LONG:  # for one lane a third of the time of max()
            return cells
        if begin is None and lazy_import("beyond").stop_swinging(problem, cells):
            continue
        lazy_import("beyond").go_on(problem, cells, samples, log)
        if not np.any(cells[ix.STATUS] == ix.NEED):
            return cells
        # One lane determines how far a Python function is needed. Then all lanes start again with the complete table.
        lazy_import("functions").extend_to_end(problem, cells, engine().integrate)


def _decide_again(problem: Problem, cells: Floats) -> None:
    """Solve lanes that start close to their limit friction again, with the exact limit friction.

    ``cells`` are the final cells of the first solution, (cells, lanes), in which these lanes are replaced.
    """
    margins = cells[ix.CLOSE]
    if not margins.size or margins[margins.argmin()] >= NEAR:
        return
    lanes = lazy_import("limits").refine(problem, margins)
    if len(lanes):
        refined = problem.cells(lanes)
        engine().integrate(problem.program, problem.tables(lanes), refined)
        cells[:, lanes] = refined


# Lanes per block, which fit into the cache while the block's own cost is small; not a power of two, since rows would
# share cache lines.
BLOCK = 16_400
