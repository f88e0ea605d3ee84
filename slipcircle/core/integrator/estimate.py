"""Error estimate of a motion from seven further runs with longer series, other steps and perturbed inputs."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.arrays import EPS, INFINITY, choose, quiet
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import OutputSamples, engine
from slipcircle.core.integrator.lanes import integrate_problem
from slipcircle.core.integrator.neighbours import ROUNDED, RUNS, perturbed_runs
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of

Final = Mapping[int, Any]  # entries of lanes at their end, by index

CUT = 4.5  # ratio of the estimate to the spread of the runs where truncation dominates, as in ensembles
LEAST = 8 * EPS / 2  # least estimate
UNDECIDED = 8.0  # units of rounding below which it is uncertain whether the mass moves
CLOSEST = 1e-13  # accuracy for which functions of the rotation are interpolated in the further runs
AT_END = {ix.ARRESTED, ix.PAUSED, ix.ENDED}  # at rest and at the end time, which differ in their durations only
# Fractions of the duration at which states are compared where runs are not integrated with their motion.
SHARES = (np.arange(8.0)[:, None] + 0.5) / 8


def estimate(plan: Plan, problem: Problem, final: Final, spreads: Any = None) -> Any:
    """Return the estimated relative error of each lane's peak velocity, run-out and duration.

    ``final`` are the final cells of the motion by index, and ``spreads`` the relative differences of all runs of a
    single scene, if they were integrated with it.

    For a single lane it includes the states during the motion, relative to peak velocity and run-out. It is 1 if
    rounding decides whether the mass moves.
    """
    if problem.lanes == 1:
        spread: Any = max(spreads or _of_single(problem, final))
        error: Any = min(max(ROUNDED * spread, LEAST), 1.0)
    else:
        spread = _of_ensemble(_closer(plan, problem), final)
        error = np.clip(CUT * spread, LEAST, 1.0)
    is_uncertain = (final[ix.PHASES] > 0.0) | (spread == INFINITY)
    return choose(final[ix.CLOSE] < UNDECIDED, 1.0, is_uncertain * error)


def _of_ensemble(problem: Problem, final: Final) -> Floats:
    """Return the greatest relative difference of any run from each lane's results, (lanes,).

    It is infinite if a run ends otherwise.
    """
    of_motion = np.array(_summary(final))
    sizes = np.maximum(np.abs(of_motion), ix.LEAST_SIZE)
    spread = np.zeros(problem.lanes)
    for run in range(1, RUNS):
        with quiet():  # cells that are not initial may contain anything
            begin = perturbed_runs(problem, slice(run, run + 1))
        cells = integrate_problem(problem, begin)
        greatest = np.fmax.reduce(np.abs(np.array(_summary(cells)) - of_motion) / sizes)
        # Whether runs end with another status than the motion, or move where the motion does not.
        other_status = _ending(cells[ix.STATUS]) != _ending(final[ix.STATUS])
        unlike = other_status | ((cells[ix.PHASES] > 0.0) != (final[ix.PHASES] > 0.0))
        spread = np.fmax(spread, np.where(unlike, INFINITY, greatest))
    return spread


def _closer(plan: Plan, problem: Problem) -> Problem:
    """Return the problem of the same lanes with more accurate interpolation of functions of the rotation."""
    if not any(table.kind == "rotation" for table in problem.program.tables):
        return problem
    closer = problem_of(replace(plan, accuracy=CLOSEST))
    return replace(problem, data=closer.data, farther=closer.farther)


def _of_single(problem: Problem, final: Final) -> tuple[float, ...]:
    """Return the greatest relative differences of any run of one lane from its results, and from states before its end.

    They are infinite if a run ends otherwise. All runs are solved in one call.
    """
    states = np.zeros((2 + len(problem.program.states), len(SHARES), RUNS))
    duration, *sizes = _summary(final)
    samples = OutputSamples(duration * SHARES, states)
    runs = integrate_problem(problem, perturbed_runs(problem), samples)[: ix.RESULTS]
    rotation_and_velocity = states[:2]
    change = np.abs(rotation_and_velocity - rotation_and_velocity[:, :, :1])
    greatest = np.fmax.reduce(change.reshape(2, -1), axis=1).tolist()
    *of_results, _ = engine().spreads(np.column_stack([list(final), runs]))
    return *of_results, *(of / max(abs(size), ix.LEAST_SIZE) for of, size in zip(greatest, sizes, strict=True))


def _ending(status: Floats) -> Floats:
    """Return status cells with one code for lanes at rest and lanes at their end time."""
    return np.where(np.isin(status, [*AT_END]), ix.ENDED, status)


def _summary(final: Any) -> tuple[Any, Any, Any]:
    """Return dimensionless duration, run-out and peak velocity from final cells, each a number or an array over lanes.

    The scales are sqrt(R/g), R and sqrt(g R).
    """
    duration = choose(
        ((final[ix.STATUS] == ix.ENDED) & (final[ix.TIME] < INFINITY)), final[ix.END_TIME], final[ix.REST_SINCE]
    )
    return duration, final[ix.REACH_ROTATION], abs(final[ix.PEAK_OMEGA])
