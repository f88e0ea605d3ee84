"""Neighbours of motions, with longer series, other steps and perturbed inputs, from which errors are estimated."""

from functools import lru_cache

import numpy as np

from generated import layout as ix
from generated.program import Program
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import engine
from slipcircle.core.integrator.lanes import ENTRIES, integrate_problem
from slipcircle.core.problem.problem import EVERY, NEAR, Problem

Rows = list[list[float]]

# Design of Plackett and Burman (1946): seven factors in eight runs, where run 0 is the motion itself. Random signs miss
# the combination that matters more often.
RUNS = 8
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], float)
# Increase of the order, and ratio of step lengths, of each run relative to the motion. Two orders are added because
# every other coefficient is 0 at rest. Longer steps of higher order cost less than shorter steps and truncate less.
# Single scenes in time without tables are truncated below rounding by any of these steps, and keep their order.
# Where breaks of time cut steps short, series end at terms below factor^order. Runs of almost the same order end at the
# same term, so that the last run has many more.
FURTHER = np.array([0.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 6.0])
LONGER = np.array([1.0, 1.005, 1.02, 1.035, 1.05, 1.07, 1.095, 1.115])
_COMPARED = np.array(
    [ix.STATUS, ix.PHASES, ix.END_TIME, ix.REST_SINCE, ix.REACH_ROTATION, ix.PEAK_OMEGA, ix.END_ROTATION]
)


@lru_cache(maxsize=256)
def _moves(program: Program, rounding: float, is_refined: bool = False) -> Floats:
    """Return the factors of the cells in each run, (cells, 8): perturbed inputs of the program, and step lengths.

    ``rounding`` is the relative error of an input.

    If the limit friction is refined, its two parts and the friction are exact inputs and remain unchanged.
    """
    inputs = [name for name in program.cells[len(ix.CELLS) : program.given] if not _is_of_table(name)]
    moved = [ix.OMEGA, *(program.places[name] for name in inputs if not (is_refined and "." in name))]
    if not is_refined:
        moved = [ix.LIMIT, *moved, *(table.cells + ix.SCALED_BY for table in program.tables)]  # and factors of values
    signs = np.zeros((len(program.cells), RUNS))
    for number, cell in enumerate(moved):
        signs[cell, 1:] = SIGNS[:, number % len(_FIRST)]
    factors = 1.0 + rounding * signs
    factors[ix.FACTOR] = LONGER
    return factors


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
    rounding = problem.plan.scene.arc.rounding
    start = problem.cells()
    cells = start * _moves(problem.program, rounding)[:, runs]
    if "LIMIT_REST" in problem.start:
        refined = start * _moves(problem.program, rounding, True)[:, runs]
        cells = np.where(start[ix.LIMIT_REST] != 0.0, refined, cells)
    program = problem.program
    if problem.lanes > 1 or program.tables or program.by_rotation:
        cells[ix.ORDER] += FURTHER[runs]
    return cells


def compared(runs: Floats) -> Rows:
    """Return the final cells by which runs of a single motion are compared, 7 lists of 8 numbers, from all of them."""
    rows: Rows = runs.take(_COMPARED, axis=0).tolist()
    return rows


def integrate_single(problem: Problem) -> tuple[list[float], Rows | None]:
    """Return the final cells of a single scene, and those by which its runs are compared, if they are integrated.

    All runs are integrated in one call unless the scene has functions of time or speed, or a viscous layer, or a run
    needs more than explicit steps, the rounded limit friction and the present tables.
    """
    program = problem.program
    steady = program.by_rotation or not program.tables
    if steady and "viscosity" not in problem.recipe.effects:
        runs = perturbed_runs(problem)
        engine().integrate(program, problem.tables(), runs)
        final = runs[:ENTRIES, 0].tolist()
        rows = compared(runs)
        if max(rows[0]) < ix.TOO_LONG and final[ix.CLOSE] >= NEAR:
            return final, rows
    return integrate_problem(problem)[:ENTRIES, 0].tolist(), None
