"""How well a motion is known: companions solve it with longer series, other steps and inputs moved by rounding."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from slipcircle.base.checks import EPS, choose
from slipcircle.core.flow.bind import STEP, Bound
from slipcircle.core.flow.lanes import Lanes, walked
from slipcircle.core.flow.program import Program, Samples

Floats = NDArray[np.float64]

# Plackett and Burman (1946): seven factors in eight runs, the first of which is the motion itself. Random signs miss
# the combination that matters more often.
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], dtype=float)
# Steps over the radius of convergence, of the motion itself and its companions, which go one order further. Longer ones
# cost less than shorter ones would, and with that order still leave out less than the motion does.
FACTORS = np.array([STEP, 0.136, 0.138, 0.140, 0.142, 0.145, 0.148, 0.151])
# What the spread counts for: where the ends of the series are the error, as of an ensemble's lanes, and where rounding
# is, as of single scenes, of which in 2,000 random ones the error was up to 5.1 times the spread.
CUT, ROUNDED = 4.5, 6.0
LEAST = 8 * EPS / 2  # that an estimate is
UNDECIDED = 8.0  # units of rounding by which a decision at rest has to be clear
SHARES = (np.arange(8) + 0.5) / 8  # of the duration, at which states are compared


@lru_cache(maxsize=256)
def _moves(program: Program) -> Floats:
    """Which way the companions move each cell, inputs of the program alone, (cells, 8); 0 for the motion itself."""
    names, reserved = program.cells, len(ix.CELLS)
    inputs = [
        k for k in range(reserved, len(names)) if "." not in names[k] or not names[k].rpartition(".")[2].isupper()
    ]
    every = [ix.LIMIT, ix.OMEGA, *inputs, *(slot.cells + ix.SCALED_BY for slot in program.tables)]
    found = np.zeros((len(names), 8))
    for place, k in enumerate(every):
        if k < program.given:  # the others follow from these
            found[k, 1:] = SIGNS[:, place % 7]
    return found


def companions(bound: Bound, which: NDArray[np.intp], moved: float) -> Bound:
    """The same lanes with their series, steps and inputs a little other than they are; number 0 is the motion itself.

    Of a single lane ``which`` may be several; ``moved`` is what rounding may do to an input.
    """
    cells = bound.cells * (1.0 + moved * _moves(bound.program)[:, which])
    cells[ix.ORDER] += which > 0
    cells[ix.FACTOR] = FACTORS[which]
    return bound._replace(cells=cells)


def estimate(lanes: Lanes, cells: Mapping[int, Floats]) -> Floats:
    """The estimated relative error of each lane's peak velocity, run-out and duration.

    Of a single lane also of its states along the way, relative to peak velocity and run-out. It is 1 where rounding
    decides whether the mass moves or rests.
    """
    bound, single, own = lanes.bound, lanes.count == 1, _told(cells)
    moves, size = cells[ix.PHASES] > 0.0, np.maximum(np.abs(own), 1e-300)
    samples = None
    if single:  # all at once, beside the motion itself
        times = np.repeat(SHARES[:, None] * own[0], 8, axis=1)
        samples = Samples(times, np.zeros((2 + len(bound.program.states), *times.shape)))
    spread, unlike = np.zeros(1), np.asarray(cells[ix.CLOSE] < UNDECIDED)
    for which in [np.arange(8)] if single else np.arange(1, 8)[:, None]:
        other = walked(companions(bound, which, lanes.arc.rounding), samples)
        spread = np.fmax(spread, np.fmax.reduce(np.abs(_told(other) - own) / size))
        unlike = unlike | (other[ix.STATUS] != cells[ix.STATUS]) | ((other[ix.PHASES] > 0.0) != moves)
    if samples and moves:  # its states, too
        off = np.abs(samples.states[:2] - samples.states[:2, :, :1]) / size[1:, None]
        spread = np.fmax(spread, np.fmax.reduce(off, axis=(0, 1)))
    if single:
        spread, unlike = np.fmax.reduce(spread, keepdims=True), np.any(unlike, keepdims=True)
    likely = np.where(moves, np.maximum((ROUNDED if single else CUT) * spread, LEAST), 0.0)
    return np.where(unlike, 1.0, np.minimum(likely, 1.0))


def _told(cells: Any) -> Floats:
    """Duration, run-out and peak velocity, (3, lanes)."""
    ends = choose(cells[ix.STATUS] == ix.ENDED, cells[ix.END_TIME], cells[ix.REST_SINCE])
    return np.reshape([ends, cells[ix.END_ROTATION], np.abs(cells[ix.PEAK_OMEGA])], (3, -1))
