"""Neighbours of motions, with longer series, other steps and perturbed inputs, from which errors are estimated."""

from functools import lru_cache
from typing import Any

import numpy as np

from generated import layout as ix
from generated.program import Program
from slipcircle.base.arrays import INFINITY
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import engine
from slipcircle.core.integrator.lanes import integrate_problem
from slipcircle.core.problem.problem import EVERY, NEAR, Problem

# Design of Plackett and Burman (1946): seven factors in eight runs, where run 0 is the motion itself. Random signs miss
# the combination that matters more often.
RUNS = 8
# Ratio of the error estimate to the spread of the runs where rounding dominates, as in single scenes. In 2,000 random
# scenes the error was at most 5.1 times the spread.
ROUNDED = 6.0
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], float)
# Increase of the order, and ratio of step lengths, of each run relative to the motion. Two orders are added because
# every other coefficient is 0 at rest. Longer steps of higher order cost less than shorter steps and truncate less.
# Where breaks of time cut steps short, series end at terms below factor^order. Runs of almost the same order end at the
# same term, so that the last run has many more. Single scenes in time without tables and end time have one order, since
# their longer steps truncate more.
FURTHER = np.array([0.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 6.0])
LONGER = np.array([1.0, 1.005, 1.02, 1.035, 1.05, 1.07, 1.095, 1.115])


@lru_cache(maxsize=256)
def _moves(program: Program, rounding: float, has_one_order: bool, is_refined: bool = False) -> Floats:
    """Return factors and summands of the cells in each run, (2, cells, 8): perturbed inputs, orders and step lengths.

    ``rounding`` is the relative error of an input.

    If the limit friction is refined, its two parts and the friction are exact inputs and remain unchanged.
    """
    inputs = [name for name in program.cells[len(ix.CELLS) : program.given] if not _is_of_table(name)]
    moved = [ix.OMEGA, *(program.places[name] for name in inputs if not (is_refined and "." in name))]
    if not is_refined:
        moved = [ix.LIMIT, *moved, *(table.cells + ix.SCALED_BY for table in program.tables)]  # and factors of values
    moves = np.zeros((2, len(program.cells), RUNS))
    for number, cell in enumerate(moved):
        moves[0, cell, 1:] = rounding * SIGNS[:, number % len(_FIRST)]
    moves[0] += 1.0
    moves[0, ix.FACTOR] = LONGER
    if program.tables or program.by_rotation or not has_one_order:
        moves[1, ix.ORDER] = FURTHER
    return moves


def _is_of_table(cell: str) -> bool:
    """Return whether a cell belongs to a table, by its name, such as ``k_h.PIECE``.

    Cells of laws have names such as ``exponential.peak``.
    """
    _, dot, name = cell.rpartition(".")
    return bool(dot) and name.isupper()


def perturbed_runs(problem: Problem, runs: slice = EVERY) -> Floats:
    """Return initial cells of further runs with other steps, longer series and perturbed inputs, (cells, lanes).

    Run 0 is the motion itself, and ``runs`` is a slice of the numbers 0 to 7, by default all of them. A single lane may
    have several runs at once, one per column. Inputs are moved by the relative error of the mass's coefficients.
    """
    is_free = problem.lanes == 1 and problem.start["END_TIME"] == INFINITY
    kind = problem.program, problem.plan.scene.arc.rounding, is_free
    start = problem.cells()
    factors, summands = _moves(*kind)[:, :, runs]
    cells = start * factors
    if "LIMIT_REST" in problem.start:
        refined, _ = _moves(*kind, True)[:, :, runs]
        cells = np.where(start[ix.LIMIT_REST] != 0.0, start * refined, cells)
    return cells + summands


def integrate_single(problem: Problem) -> Any:
    """Return the final cells of a single scene, and the spreads of its runs, if they are integrated.

    All runs are integrated in one call unless the scene has functions of time or speed, or a viscous layer, or a run
    needs more than explicit steps, the rounded limit friction and the present tables.
    """
    program = problem.program
    steady = program.by_rotation or not program.tables
    if steady and "viscosity" not in problem.recipe.effects:
        start = problem.start
        moves = _moves(program, problem.plan.scene.arc.rounding, start["END_TIME"] == INFINITY)
        runs = engine().integrate_runs(program, problem.tables(), start, moves)
        if runs and runs[0][ix.CLOSE] >= NEAR:
            return runs
    return integrate_problem(problem)[: ix.RESULTS, 0].tolist(), None
