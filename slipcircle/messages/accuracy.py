"""Error estimate of a motion from seven further runs with longer series, other steps and perturbed inputs."""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from operator import truediv
from typing import Any

import numpy as np

from generated import layout as ix
from generated.program import Program
from slipcircle.base.arrays import EPS, choose, quiet
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import OutputSamples
from slipcircle.core.integrator.lanes import integrate_problem
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of

Final = Mapping[int, Any]  # entries of lanes at their end, by index

# Design of Plackett and Burman (1946): seven factors in eight runs, where run 0 is the motion itself. Random signs miss
# the combination that matters more often.
RUNS = 8
_FIRST = (1, 1, 1, -1, 1, -1, -1)
_ROWS = [np.roll(_FIRST, k) for k in range(7)]
SIGNS = np.array(_ROWS, dtype=float)
# Increase of the order, and ratio of step lengths, of each run relative to the motion. Two orders are added because
# every other coefficient is 0 at rest. Longer steps of higher order cost less than shorter steps and truncate less.
FURTHER = np.full(RUNS, 2.0)
FURTHER[0] = 0.0
# Where breaks of time cut steps short, series end at terms below factor^order. Runs of almost the same order end at the
# same term, so that one run has many more.
FURTHER[-1] = 6.0
LONGER = np.array([1.0, 1.005, 1.02, 1.035, 1.05, 1.07, 1.095, 1.115])
# Ratio of the estimate to the spread of the runs: CUT where truncation dominates, as in ensembles, and ROUNDED where
# rounding dominates, as in single scenes (in 2,000 random scenes the error was at most 5.1 times the spread).
CUT = 4.5
ROUNDED = 6.0
LEAST_SIZE = 1e-300  # divisor in place of 0
LEAST = 8 * EPS / 2  # least estimate
UNDECIDED = 8.0  # units of rounding below which it is uncertain whether the mass moves
# Functions of the rotation are interpolated to a fraction of the accuracy, in the further runs down to rounding.
CLOSER = 1e-3
CLOSEST = 1e-13
# Cells by which single motions are compared.
COMPARED = np.array([ix.STATUS, ix.PHASES, ix.END_TIME, ix.REST_SINCE, ix.REACH_ROTATION, ix.PEAK_OMEGA])
AT_END = {ix.ARRESTED, ix.PAUSED, ix.ENDED}  # at rest and at the end time, which differ in their durations only
# Fractions of the duration at which the states of all runs are compared.
SHARES = (np.arange(8.0)[:, None] + 0.5) / 8


@lru_cache(maxsize=256)
def _moves(program: Program, rounding: float, is_refined: bool = False) -> Floats:
    """Return the factors of the cells in each run, (cells, 8): perturbed inputs of the program, and step lengths.

    ``rounding`` is the relative error of an input.

    If the limit friction is refined, its two parts and the friction are exact inputs and remain unchanged.
    """
    inputs = [name for name in program.cells[len(ix.CELLS) : program.given] if not _is_of_table(name)]
    if is_refined:
        moved = [ix.OMEGA, *(program.places[name] for name in inputs if "." not in name)]
    else:
        moved = [ix.LIMIT, ix.OMEGA, *(program.places[name] for name in inputs)]
        moved += [table.cells + ix.SCALED_BY for table in program.tables]  # factors of the values of tables
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


def perturbed_runs(problem: Problem, runs: slice, rounding: float) -> Floats:
    """Return initial cells of further runs with other steps, longer series and perturbed inputs, (cells, lanes).

    Run 0 is the motion itself, and ``runs`` is a slice of the numbers 0 to 7. A single lane may have several runs at
    once, one per column. ``rounding`` is the relative error of an input.
    """
    start = problem.cells()
    cells = start * _moves(problem.program, rounding)[:, runs]
    if "LIMIT_REST" in problem.start:
        refined = start * _moves(problem.program, rounding, True)[:, runs]
        cells = np.where(start[ix.LIMIT_REST] != 0.0, refined, cells)
    cells[ix.ORDER] += FURTHER[runs]
    return cells


def estimate(plan: Plan, problem: Problem, final: Final) -> Any:
    """Return the estimated relative error of each lane's peak velocity, run-out and duration.

    ``final`` are the final cells of the motion by index.

    For a single lane it includes the states during the motion, relative to peak velocity and run-out. It is 1 if
    rounding decides whether the mass moves.
    """
    rounding = plan.scene.arc.rounding
    if problem.lanes == 1:
        spread: Any = _of_single(problem, final, rounding)
        error: Any = min(max(ROUNDED * spread, LEAST), 1.0)
    else:
        spread = _of_ensemble(_closer(plan, problem), final, rounding)
        error = np.clip(CUT * spread, LEAST, 1.0)
    is_still = (final[ix.PHASES] == 0.0) & (spread < np.inf)
    return choose(final[ix.CLOSE] < UNDECIDED, 1.0, choose(is_still, 0.0, error))


def _of_ensemble(problem: Problem, final: Final, rounding: float) -> Floats:
    """Return the greatest relative difference of any run from each lane's results, (lanes,).

    It is infinite if a run ends otherwise. ``rounding`` is the relative error by which inputs are perturbed.
    """
    of_motion = np.array(_summary(final))
    sizes = np.maximum(np.abs(of_motion), LEAST_SIZE)
    spread = np.zeros(problem.lanes)
    for run in range(1, RUNS):
        with quiet():  # cells that are not initial may contain anything
            begin = perturbed_runs(problem, slice(run, run + 1), rounding)
        cells = integrate_problem(problem, begin)
        greatest = np.fmax.reduce(np.abs(np.array(_summary(cells)) - of_motion) / sizes)
        # Whether runs end with another status than the motion, or move where the motion does not.
        other_status = _ending(cells[ix.STATUS]) != _ending(final[ix.STATUS])
        unlike = other_status | ((cells[ix.PHASES] > 0.0) != (final[ix.PHASES] > 0.0))
        spread = np.fmax(spread, np.where(unlike, np.inf, greatest))
    return spread


def _closer(plan: Plan, problem: Problem) -> Problem:
    """Return the problem of the same lanes with more accurate interpolation of functions of the rotation."""
    if not any(table.kind == "rotation" for table in problem.program.tables):
        return problem
    closer = problem_of(replace(plan, accuracy=max(CLOSER * plan.accuracy, CLOSEST)))
    return replace(problem, data=closer.data, farther=closer.farther)


def _of_single(problem: Problem, final: Final, rounding: float) -> float:
    """Return the greatest relative difference of any run of one lane, infinite if a run ends otherwise.

    The states during the motion are included. All runs are solved in one call. Results are compared as Python floats,
    since a few floats cost less than an array.
    """
    states = np.zeros((2 + len(problem.program.states), len(SHARES), RUNS))
    of_motion = _summary(final)
    samples = OutputSamples(of_motion[0] * SHARES, states)
    cells = integrate_problem(problem, perturbed_runs(problem, slice(None), rounding), samples)
    status, phases, end_times, rests, run_outs, peaks = cells.take(COMPARED, axis=0).tolist()
    moves = min(phases) > 0.0
    if not ((moves or max(phases) == 0.0) and _end_alike({*status})):
        return np.inf
    if ix.ENDED in status and final[ix.TIME] < np.inf:
        rests = [end if code == ix.ENDED else rest for code, end, rest in zip(status, end_times, rests, strict=True)]
    rows = rests, run_outs, [*map(abs, peaks)]
    greatest = [max(max(row) - of, of - min(row)) for row, of in zip(rows, of_motion, strict=True)]
    if moves:
        rotation_and_velocity = states[:2]
        change = np.abs(rotation_and_velocity - rotation_and_velocity[:, :, :1])
        greatest += np.fmax.reduce(change.reshape(2, -1), axis=1).tolist()
    sizes = [max(abs(of), LEAST_SIZE) for of in of_motion]
    return max(map(truediv, greatest, sizes + sizes[1:]))


def _end_alike(endings: set[float]) -> bool:
    """Return whether status cells are the same, where rest and the end time count as one."""
    return len(endings) == 1 or endings <= AT_END


def _ending(status: Floats) -> Floats:
    """Return status cells with one code for lanes at rest and lanes at their end time."""
    return np.where(np.isin(status, [*AT_END]), ix.ENDED, status)


def _summary(final: Any) -> tuple[Any, Any, Any]:
    """Return dimensionless duration, run-out and peak velocity from final cells, each a number or an array over lanes.

    The scales are sqrt(R/g), R and sqrt(g R).
    """
    duration = choose(
        ((final[ix.STATUS] == ix.ENDED) & (final[ix.TIME] < np.inf)), final[ix.END_TIME], final[ix.REST_SINCE]
    )
    return duration, final[ix.REACH_ROTATION], abs(final[ix.PEAK_OMEGA])
