"""How well a motion is known: companions solve it with longer series, other steps and inputs moved by rounding."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.flow import CELLS
from slipcircle.base.checks import EPS
from slipcircle.flow import cells as its
from slipcircle.flow.bind import STEP, Bound
from slipcircle.flow.program import Program
from slipcircle.flow.solve import Lanes, walked

Floats = NDArray[np.float64]

# Plackett and Burman (1946): seven factors in eight runs, the first of which is the motion itself. Random signs miss
# the combination that matters more often.
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], dtype=float)
ORDERS = np.array([0, 1, 2, 3, 4, 1, 2, 3])  # of the motion itself, and of its companions
FACTORS = np.array([STEP, 0.130, 0.125, 0.120, 0.115, 0.110, 0.105, 0.100])
TIMES, LEAST = 3.0, 8 * EPS / 2  # the spread counts thrice, and is at least this
UNDECIDED = 8.0  # units of rounding by which a decision at rest has to be clear
SHARES = (np.arange(16) + 0.5) / 16  # of the duration, at which states are compared


@lru_cache(maxsize=256)
def _moves(program: Program) -> tuple[NDArray[np.intp], Floats]:
    """The inputs of a program, and which way its companions move them, (8, inputs); 0 for the motion itself."""
    names, reserved = program.cells, len(CELLS)
    inputs = [
        k for k in range(reserved, len(names)) if "." not in names[k] or not names[k].rpartition(".")[2].isupper()
    ]
    every = [its.LIMIT, its.OMEGA, *inputs, *(slot.cells + its.SCALED_BY for slot in program.tables)]
    kept = [place for place, k in enumerate(every) if k < program.given]  # the others follow from these
    signs = np.array([np.zeros(len(kept)), *(signs[np.array(kept) % 7] for signs in SIGNS)])
    return np.array(every)[kept], signs


def companions(bound: Bound, which: Any, moved: float) -> Bound:
    """The same lanes with their series, steps and inputs a little other than they are; number 0 is the motion itself.

    Of a single lane ``which`` may be an array; ``moved`` is what rounding may do to an input.
    """
    cells = bound.start()
    inputs, signs = _moves(bound.program)
    factors = 1.0 + moved * signs
    if np.ndim(which):
        cells = np.repeat(cells, len(which), axis=1)
    cells[inputs] *= factors[which].T if np.ndim(which) else factors[which, :, None]
    cells[its.ORDER] += ORDERS[which]
    cells[its.FACTOR] = FACTORS[which]
    return bound._replace(cells=cells)


def estimate(lanes: Lanes, cells: Mapping[int, Floats]) -> Floats:
    """The estimated relative error of each lane's peak velocity, run-out and duration.

    Of a single lane also of its states along the way, relative to peak velocity and run-out. It is 1 where rounding
    decides whether the mass moves or rests.
    """
    bound, single, moved = lanes.bound, lanes.count == 1, lanes.arc.rounding
    duration = _duration(cells)
    run_out = np.maximum(np.abs(cells[its.END_ROTATION]), 1e-300)
    peak = np.maximum(np.abs(cells[its.PEAK_OMEGA]), 1e-300)
    moves = cells[its.PHASES] > 0.0
    along: Any = 0.0
    if single:  # all at once, beside the motion itself
        times = np.ascontiguousarray(SHARES[:, None] * duration)
        samples = its.Samples(np.repeat(times, 8, axis=1), np.zeros((2 + len(bound.program.states), len(times), 8)))
        found: Any = [walked(companions(bound, np.arange(8), moved), lanes.closed, samples)]
        if moves[0]:
            off = np.abs(samples.states[:2] - samples.states[:2, :, :1]).max(axis=1)
            along = np.maximum(off[0] / run_out, off[1] / peak)
    else:
        found = (walked(companions(bound, k, moved), lanes.closed) for k in range(1, 8))
    spread, unlike = np.zeros(lanes.count), cells[its.CLOSE] < UNDECIDED
    for other in found:
        off = np.fmax.reduce([
            np.abs(_duration(other) - duration) / np.maximum(duration, 1e-300),
            np.abs(other[its.END_ROTATION] - cells[its.END_ROTATION]) / run_out,
            np.abs(np.abs(other[its.PEAK_OMEGA]) - np.abs(cells[its.PEAK_OMEGA])) / peak,
            along + np.zeros(other.shape[1]),
        ])  # fmt: skip
        other_way = (other[its.STATUS] != cells[its.STATUS]) | ((other[its.PHASES] > 0.0) != moves)
        spread = np.fmax(spread, np.fmax.reduce(off) if single else off)
        unlike = unlike | (np.any(other_way) if single else other_way)
    likely = np.where(moves, np.maximum(TIMES * spread, LEAST), 0.0)
    return np.where(unlike, 1.0, np.minimum(likely, 1.0))


def _duration(cells: Any) -> Any:
    return np.where(cells[its.STATUS] == its.ENDED, cells[its.END_TIME], cells[its.REST_SINCE])
