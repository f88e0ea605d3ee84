"""How well a motion is known: seven more runs, with longer series, other steps and inputs moved by rounding."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS, choose
from slipcircle.core.flow.lanes import Lanes, integrate_all
from slipcircle.core.flow.problem import STEP, Problem
from slipcircle.core.flow.program import Program, Samples

Floats = NDArray[np.float64]

# Plackett and Burman (1946): seven factors in eight runs, the first of which is the motion itself. Random signs miss
# the combination that matters more often.
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], dtype=float)
# Steps over the radius of convergence, of the motion itself and the other runs, which go one order further. Longer ones
# cost less than shorter ones would, and with that order still leave out less than the motion does.
FACTORS = np.array([STEP, 0.136, 0.138, 0.140, 0.142, 0.145, 0.148, 0.151])
# What the spread counts for: where the ends of the series are the error, as of an ensemble's lanes, and where rounding
# is, as of single scenes, of which in 2,000 random ones the error was up to 5.1 times the spread.
CUT, ROUNDED = 4.5, 6.0
LEAST_SIZE = 1e-300  # by which what is 0 is divided
LEAST = 8 * EPS / 2  # that an estimate is
UNDECIDED = 8.0  # units of rounding by which a decision at rest has to be clear
SHARES = (np.arange(8) + 0.5) / 8  # of the duration, at which states are compared


@lru_cache(maxsize=256)
def _signs(program: Program) -> Floats:
    """The sign with which each run moves each input of the program, (cells, 8); 0 for the motion itself."""
    inputs = [k for k, name in enumerate(program.cells) if k >= len(ix.CELLS) and not _of_table(name)]
    factors = [table.cells + ix.SCALED_BY for table in program.tables]
    signs = np.zeros((len(program.cells), 8))
    for number, cell in enumerate((ix.LIMIT, ix.OMEGA, *inputs, *factors)):
        if cell < program.given:  # the others follow from these
            signs[cell, 1:] = SIGNS[:, number % 7]
    return signs


def _of_table(cell: str) -> bool:
    """Whether a cell belongs to a table, as ``k_h.PIECE`` does, and not to a law, as ``exponential.peak``."""
    _, dot, name = cell.rpartition(".")
    return bool(dot) and name.isupper()


def perturbed_runs(problem: Problem, which: NDArray[np.intp], rounding: float) -> Problem:
    """The same lanes with other steps, one order more, and inputs moved by rounding; run 0 is the motion itself.

    Of a single lane ``which`` may be several runs at once; ``rounding`` is the relative error that an input may have.
    """
    cells = problem.cells * (1.0 + rounding * _signs(problem.program)[:, which])
    cells[ix.ORDER] += which > 0
    cells[ix.FACTOR] = FACTORS[which]
    return problem._replace(cells=cells)


def estimate(lanes: Lanes, final: Mapping[int, Floats]) -> Floats:
    """The estimated relative error of each lane's peak velocity, run-out and duration.

    Of a single lane also of its states along the way, relative to peak velocity and run-out. It is 1 where rounding
    decides whether the mass moves or rests.
    """
    if lanes.count == 1:
        return _of_single(lanes, final)
    summary, moves = summary_vector(final), final[ix.PHASES] > 0.0
    size = np.maximum(np.abs(summary), LEAST_SIZE)
    spread, unlike = np.zeros(lanes.count), np.asarray(final[ix.CLOSE] < UNDECIDED)
    for run in range(1, 8):
        cells = integrate_all(perturbed_runs(lanes.problem, np.array([run]), lanes.arc.rounding))
        spread = np.fmax(spread, np.fmax.reduce(np.abs(summary_vector(cells) - summary) / size))
        unlike |= (cells[ix.STATUS] != final[ix.STATUS]) | ((cells[ix.PHASES] > 0.0) != moves)
    return _bounded(CUT * spread, moves, unlike)


def _of_single(lanes: Lanes, final: Mapping[int, Floats]) -> Floats:
    """The same of one lane: all runs at once, beside the motion itself, with their states along the way."""
    summary, moves = summary_vector(final), final[ix.PHASES] > 0.0
    size = np.maximum(np.abs(summary), LEAST_SIZE)
    times = np.repeat(SHARES[:, None] * summary[0], 8, axis=1)
    samples = Samples(times, np.zeros((2 + len(lanes.problem.program.states), *times.shape)))
    cells = integrate_all(perturbed_runs(lanes.problem, np.arange(8), lanes.arc.rounding), samples)
    differences = np.abs(summary_vector(cells) - summary) / size
    if moves:
        rotation_and_omega = samples.states[:2].reshape(2, -1, 8)
        along = np.abs(rotation_and_omega - rotation_and_omega[..., :1]) / size[1:, None]
        differences = np.concatenate([differences, along.reshape(-1, 8)])
    unlike = (cells[ix.STATUS] != final[ix.STATUS]) | ((cells[ix.PHASES] > 0.0) != moves)
    close = final[ix.CLOSE] < UNDECIDED
    return _bounded(ROUNDED * np.fmax.reduce(differences, axis=None, keepdims=True)[0], moves, close or unlike.any())


def _bounded(error: Floats, moves: Any, undecided: Any) -> Floats:
    """Between the least that an estimate is and 1; 0 where the mass does not move."""
    moving = np.where(moves, np.maximum(error, LEAST), 0.0)
    return np.where(undecided, 1.0, np.minimum(moving, 1.0))


def summary_vector(final: Any) -> Floats:
    """Duration, run-out and peak velocity, dimensionless, (3, lanes), of final cells."""
    duration = choose(final[ix.STATUS] == ix.ENDED, final[ix.END_TIME], final[ix.REST_SINCE])
    return np.reshape([duration, final[ix.END_ROTATION], np.abs(final[ix.PEAK_OMEGA])], (3, -1))
