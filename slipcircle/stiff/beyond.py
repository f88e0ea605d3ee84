"""Lanes that exceed the number of explicit steps, or turn back too often."""

import numpy as np

from generated import layout as ix
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import Log, OutputSamples
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.problem import Problem


def stop_swinging(problem: Problem, cells: Floats) -> bool:
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


def go_on(problem: Problem, cells: Floats, samples: OutputSamples | None, log: Log | None) -> None:
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
