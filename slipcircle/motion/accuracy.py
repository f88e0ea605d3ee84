"""How well a motion is known: companions solve it with longer series, other steps and inputs moved by rounding."""

import numpy as np
from numpy.typing import NDArray

from slipcircle.flow import walk
from slipcircle.flow.bind import Bound
from slipcircle.flow.solve import Lanes, walked

Floats = NDArray[np.float64]

# Plackett and Burman (1946): seven factors in eight runs, the first of which is the motion itself. Random signs miss
# the combination that matters more often.
_FIRST = (1, 1, 1, -1, 1, -1, -1)
SIGNS = np.array([np.roll(_FIRST, k) for k in range(7)], dtype=float)
MOVED = 4 * walk.EPS  # what rounding may do to an input
ORDERS, FACTORS = (1, 2, 3, 4, 1, 2, 3), (0.130, 0.125, 0.120, 0.115, 0.110, 0.105, 0.100)
TIMES, LEAST = 3.0, 8 * walk.EPS / 2  # the spread counts thrice, and is at least this
UNDECIDED = 8.0  # units of rounding by which a decision at rest has to be clear
SHARES = (np.arange(16) + 0.5) / 16  # of the duration, at which states are compared


def companions(bound: Bound, which: int) -> Bound:
    """The same lanes with their series, steps and inputs a little other than they are."""
    cells, names = bound.cells.copy(), bound.program.cells
    reserved = len(walk.CELLS)
    inputs = [
        k for k in range(reserved, len(names)) if "." not in names[k] or not names[k].rpartition(".")[2].isupper()
    ]
    factors = [slot.cells + walk.SCALED_BY for slot in bound.program.tables]
    for place, k in enumerate([walk.LIMIT, walk.OMEGA, *inputs, *factors]):
        if not names[k].startswith("="):
            cells[k] *= 1.0 + SIGNS[which, place % 7] * MOVED
    cells[walk.ORDER] += ORDERS[which]
    cells[walk.FACTOR] = FACTORS[which]
    return bound._replace(cells=cells)


def estimate(lanes: Lanes, cells: Floats) -> Floats:
    """The estimated relative error of each lane's peak velocity, run-out and duration.

    Of a single lane also of its states along the way, relative to peak velocity and run-out. It is 1 where rounding
    decides whether the mass moves or rests.
    """
    bound, single = lanes.bound, lanes.count == 1
    duration = np.where(cells[walk.STATUS] == walk.ENDED, cells[walk.END_TIME], cells[walk.REST_SINCE])
    times = np.ascontiguousarray(SHARES[:, None] * duration) if single else np.zeros((0, lanes.count))
    rows = 2 + len(bound.program.states)
    others = [companions(bound, k) for k in range(len(SIGNS))]
    if single:  # all at once, beside the motion itself
        joined = bound._replace(cells=np.concatenate([bound.cells, *(o.cells for o in others)], axis=1))
        samples = walk.Samples(np.repeat(times, 8, axis=1), np.zeros((rows, len(times), 8)))
        found = walked(joined, lanes.closed, samples)
        ends = [found[:, k : k + 1] for k in range(8)]
        states = [samples.states[:, :, k : k + 1] for k in range(8)]
    else:
        ends, states = [cells, *(walked(o, lanes.closed) for o in others)], []
    # Their order may exceed that of the program's lanes: the first is the motion as it was solved.
    run_out = np.maximum(np.abs(cells[walk.END_ROTATION]), 1e-300)
    peak = np.maximum(np.abs(cells[walk.PEAK_OMEGA]), 1e-300)
    spread = np.zeros(lanes.count)
    unlike = np.zeros(lanes.count, dtype=bool)
    moves = cells[walk.PHASES] > 0.0
    for k, other in enumerate(ends):
        late = np.where(other[walk.STATUS] == walk.ENDED, other[walk.END_TIME], other[walk.REST_SINCE])
        off = [
            np.abs(late - duration) / np.maximum(duration, 1e-300),
            np.abs(other[walk.END_ROTATION] - cells[walk.END_ROTATION]) / run_out,
            np.abs(np.abs(other[walk.PEAK_OMEGA]) - np.abs(cells[walk.PEAK_OMEGA])) / peak,
        ]
        if states and moves[0]:
            off += [np.abs(states[k][row] - states[0][row]).max(axis=0) / of for row, of in ((0, run_out), (1, peak))]
        spread = np.fmax(spread, np.max(off, axis=0))
        unlike |= (other[walk.STATUS] != cells[walk.STATUS]) | ((other[walk.PHASES] > 0.0) != moves)
    unlike |= cells[walk.CLOSE] < UNDECIDED
    found = np.where(moves, np.maximum(TIMES * spread, LEAST), 0.0)
    return np.where(unlike, 1.0, np.minimum(found, 1.0))
