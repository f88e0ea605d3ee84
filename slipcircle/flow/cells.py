"""Cells of a lane by their place, what a lane can be doing, and what a walk takes beside: numbers with names."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.flow import CELLS

Floats = NDArray[np.float64]

(TIME, ROTATION, SLIP, DIRECTION, LIFTED, STATUS, STEPS, PHASES, ORDER, FACTOR, END_TIME, ONE_WAY, FIRST_ONLY, LIMIT,
 PEAK_TIME, PEAK_ROTATION, PEAK_OMEGA, PEAK_RATE, REACH_TIME, REACH_ROTATION, END_ROTATION, END_OMEGA,
 END_RATE, CLOSE, LIFT_TIME, PASSED, REST_SINCE, TURNS, LAST_WAY, X, OMEGA) = range(31)  # fmt: skip
assert CELLS[:31][-2:] == ("x", "omega")
START, MOVING, RESTING, ARRESTED, ENDED, STOPPED, UPRIGHT, TOO_LONG, FAILED, NEED = range(10)
PIECE, VALUE, INC, UPPER, LOWER, SCALE, SCALED_BY, Q1 = range(8)  # of a table's cells
# A step that changes the speed by less than a thousandth is held short by what decays at once: it counts for many.
MOST_STEPS, STIFF_STEP, MOST_TURNS = 2e5, 20.0, 2000
NOTHING, LIFT, FASTER, SLOWER, STOOD = range(5)  # what a phase has just passed, and that it has just ended
BEGINS, STANDS, LIFTS, LANDS = 1, 2, 3, 4  # kinds of events in a log
Log = list[tuple[int, float, float, float]]  # kind, time, rotation, direction


class Samples(NamedTuple):
    """States at given times, filled while the lanes walk: (states, times, lanes)."""

    times: Floats  # dimensionless, increasing, (times, lanes)
    states: Floats  # rotation, angular velocity, its rate, slip, then the further states
