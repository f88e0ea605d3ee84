"""How well a motion is known: seven more runs, with longer series, other steps and inputs moved by rounding."""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.checks import EPS, choose
from slipcircle.base.kinds import Floats
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.program.program import Program, Samples
from slipcircle.core.walk.lanes import integrate

Final = Mapping[int, Any]  # state entries of lanes at their end, by their places

# Plackett and Burman (1946): seven factors in eight runs, the first of which is the motion itself. Random signs miss
# the combination that matters more often.
RUNS = 8
_FIRST = (1, 1, 1, -1, 1, -1, -1)
_ROWS = [np.roll(_FIRST, k) for k in range(7)]
SIGNS = np.array(_ROWS, dtype=float)
# Steps over those of the motion itself, of the motion and the other runs, which go two orders further, as from rest
# every other coefficient is 0. Longer ones cost less than shorter ones would, and still truncate less.
FURTHER = np.full(RUNS, 2.0)
FURTHER[0] = 0.0
LONGER = np.array([1.0, 1.005, 1.02, 1.035, 1.05, 1.07, 1.095, 1.115])
# What the spread counts for: where the ends of the series are the error, as of an ensemble's lanes, and where rounding
# is, as of single scenes, of which in 2,000 random ones the error was up to 5.1 times the spread.
CUT = 4.5
ROUNDED = 6.0
LEAST_SIZE = 1e-300  # by which what is 0 is divided
LEAST = 8 * EPS / 2  # that an estimate is
UNDECIDED = 8.0  # units of rounding by which a decision at rest has to be clear
# Functions of the rotation are laid out to a share of the accuracy: beside the motion closer, down to their rounding.
CLOSER = 1e-3
CLOSEST = 1e-13
# Shares of the duration at which states are compared, of each run the same.
_MIDDLES = (np.arange(8) + 0.5) / 8
SHARES = np.tile(_MIDDLES[:, None], RUNS)


@lru_cache(maxsize=256)
def _moves(program: Program, rounding: float) -> Floats:
    """By what each run multiplies each input of the program to move it by rounding, (cells, 8); 1 for the motion."""
    inputs = program.cells[len(ix.CELLS) : program.given]
    moved = [ix.LIMIT, ix.OMEGA, *(program.places[name] for name in inputs if not _is_of_table(name))]
    for table in program.tables:
        factor_of_values = table.cells + ix.SCALED_BY
        moved.append(factor_of_values)
    count = len(program.cells)
    signs = np.zeros((count, RUNS))
    for number, cell in enumerate(moved):
        factor = number % len(_FIRST)
        signs[cell, 1:] = SIGNS[:, factor]
    return 1.0 + rounding * signs


def _is_of_table(cell: str) -> bool:
    """Whether a cell belongs to a table, as ``k_h.PIECE`` does, and not to a law, as ``exponential.peak``."""
    _, dot, name = cell.rpartition(".")
    return bool(dot) and name.isupper()


def perturbed_runs(problem: Problem, runs: slice, rounding: float) -> Floats:
    """Cells of the same lanes with other steps, two orders more, inputs moved by rounding; run 0 is the motion itself.

    Of a single lane it may be several runs at once; ``rounding`` is the relative error that an input may have.
    """
    cells: Floats = problem.cells() * _moves(problem.program, rounding)[:, runs]
    cells[ix.ORDER] += FURTHER[runs]
    cells[ix.FACTOR] *= LONGER[runs]
    return cells


def estimate(plan: Plan, problem: Problem, final: Final) -> Any:
    """The estimated relative error of each lane's peak velocity, run-out and duration.

    Of a single lane also of its states along the way, relative to peak velocity and run-out. It is 1 where rounding
    decides whether the mass moves or rests.
    """
    rounding = plan.scene.arc.rounding
    error: Any
    unlike: Any
    if problem.lanes == 1:
        spread, unlike = _of_single(problem, final, rounding)
        error = max(ROUNDED * spread, LEAST)
        error = min(error, 1.0)
    else:
        spreads, unlike = _of_ensemble(_closer(plan, problem), final, rounding)
        error = np.maximum(CUT * spreads, LEAST)
        error = np.minimum(error, 1.0)
    close = final[ix.CLOSE] < UNDECIDED
    still = final[ix.PHASES] == 0.0
    if_decided = choose(still, 0.0, error)
    return choose(unlike | close, 1.0, if_decided)


def _of_ensemble(problem: Problem, final: Final, rounding: float) -> tuple[Floats, Any]:
    """The greatest difference of any run from each lane's results, relative, and whether one ends otherwise."""
    summary = summary_vector(final)
    spread = np.zeros(problem.lanes)
    unlike = np.zeros(problem.lanes, dtype=bool)
    for run in range(1, RUNS):
        alone = slice(run, run + 1)
        cells = integrate(problem, perturbed_runs(problem, alone, rounding))
        changes = _changes(cells, summary)
        greatest = np.fmax.reduce(changes)
        spread = np.fmax(spread, greatest)
        unlike |= _ends_otherwise(cells, final)
    return spread, unlike


def _closer(plan: Plan, problem: Problem) -> Problem:
    """The same lanes with the functions of their rotation closer to what these stand for."""
    if not any(table.kind == "rotation" for table in problem.program.tables):
        return problem
    accuracy = max(CLOSER * plan.accuracy, CLOSEST)
    closer = problem_of(replace(plan, accuracy=accuracy))
    return replace(problem, data=closer.data, farther=closer.farther)


def _of_single(problem: Problem, final: Final, rounding: float) -> tuple[float, bool]:
    """The same of one lane: all runs at once, beside the motion itself, with their states along the way."""
    states = np.zeros((2 + len(problem.program.states), *SHARES.shape))
    summary = summary_vector(final)
    samples = Samples(summary[0] * SHARES, states)
    begin = perturbed_runs(problem, slice(None), rounding)
    cells = integrate(problem, begin, samples)
    changes = _changes(cells, summary)
    spread = np.fmax.reduce(changes, axis=None)
    if final[ix.PHASES] > 0.0:
        rotation_and_velocity = states[:2]
        of_motion = rotation_and_velocity[:, :, :1]
        change = np.abs(rotation_and_velocity - of_motion)
        run_out_and_peak = _size(summary[1:])
        along = change / run_out_and_peak[..., None]
        greatest = np.fmax.reduce(along, axis=None)
        spread = np.fmax(spread, greatest)
    unlike = _ends_otherwise(cells, final)
    return float(spread), bool(unlike.any())


def _size(summary: Floats) -> Floats:
    """What errors of results are relative to."""
    return np.maximum(np.abs(summary), LEAST_SIZE)


def _changes(cells: Floats, summary: Floats) -> Floats:
    """Differences of the results of runs from those of the motion, relative."""
    difference = summary_vector(cells) - summary
    change = np.abs(difference)
    return np.asarray(change / _size(summary))


def _ends_otherwise(cells: Floats, final: Final) -> Any:
    """Whether runs end with another status than the motion, or move where it does not."""
    status = final[ix.STATUS]
    other_status = cells[ix.STATUS] != status
    moves = cells[ix.PHASES] > 0.0
    phases = final[ix.PHASES]
    return other_status | (moves != (phases > 0.0))


def summary_vector(final: Any) -> Floats:
    """Duration, run-out and peak velocity, dimensionless, (3, lanes), of final cells."""
    ended = (final[ix.STATUS] == ix.ENDED) & (final[ix.TIME] < np.inf)
    rest = final[ix.REST_SINCE]  # of a mass that creeps, when it has all but arrived
    duration = choose(ended, final[ix.END_TIME], rest)
    peak_velocity = np.abs(final[ix.PEAK_OMEGA])
    run_out = final[ix.END_ROTATION]
    summary = np.array([duration, run_out, peak_velocity])
    return summary.reshape(3, -1)
