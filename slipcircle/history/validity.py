"""Range of validity of the method, and the state in which a motion leaves it."""

from typing import Any

import numpy as np

from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.state import State

_ROUNDS = 11  # each round gains five bits
_PARTS = 33


def outside(motion: Motion) -> Any:
    """Return whether each case turns beyond the `rotation_range` of its mass; `Motion.outside_range`."""
    if not motion.shape:
        return motion.range_end is not None
    arc = motion.plan.scene.arc
    upslope, downslope = arc.rotation_range
    rotation = motion.run_out / arc.radius
    leaves = (rotation > downslope) | (rotation < upslope)
    may_leave_earlier = ~leaves & (-rotation > downslope)  # farther up-slope than down-slope
    for place in zip(*np.nonzero(may_leave_earlier), strict=True):
        leaves[place] = motion[place].outside_range
    return leaves


def range_end(motion: Motion) -> State | None:
    """Return the state in which a single motion leaves its range of validity; None if it does not."""
    upslope, downslope = motion.plan.scene.arc.rotation_range
    creeps_on = [10.0 * motion.settling_time] * (motion.duration == np.inf)
    times = np.array([0.0, *(phase.end for phase in motion.phases), *creeps_on])
    for _ in range(_ROUNDS):
        rotation = motion.at(times).rotation
        beyond = (rotation < upslope) | (rotation > downslope)
        if not beyond.any():
            return None
        first = max(int(np.argmax(beyond)), 1)
        times = np.linspace(times[first - 1], times[first], _PARTS)
    return motion.at(times[-1])
