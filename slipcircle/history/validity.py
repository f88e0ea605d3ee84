"""Range of validity of the method: whether a motion leaves it, and in which state."""

from typing import Any

import numpy as np

from slipcircle.base.sections import first_section
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.states import State

_SHARES = np.linspace(0.0, 1.0, 33)


def outside(motion: Motion) -> Any:
    """Return whether each case turns beyond the `rotation_range` of its mass; `Motion.outside_range`."""
    arc = motion.plan.scene.arc
    upslope, downslope = arc.rotation_range
    rotation = np.asarray(motion.run_out / np.asarray(arc.radius))
    leaves = (rotation < upslope) | (rotation > downslope)
    # Such a mass was farther up-slope than down-slope, where it may have left a narrower range.
    unsure = ~leaves & (-rotation > downslope)
    if not motion.shape:
        return bool(leaves) or (bool(unsure) and range_end(motion) is not None)
    for place in zip(*np.nonzero(unsure), strict=True):
        leaves[place] = motion[place].outside_range
    return leaves


def range_end(motion: Motion) -> State | None:
    """Return the state in which a single motion leaves its range of validity; None if it does not."""
    arc = motion.plan.scene.arc
    starts = [phase.rotation for phase in motion.phases]
    ends = [*starts[1:], float(motion.end.rotation)]
    for phase, end in zip(motion.phases, ends, strict=False):
        limit = float(arc.rotation_range[phase.direction > 0])
        way = phase.direction
        if way * (end - limit) > 0.0:

            def beyond(times: Any, limit: float = limit, way: int = way) -> Any:
                rotation = motion.at(times.ravel()).rotation
                return way * (rotation - limit).reshape(times.shape) > 0.0

            low, high = np.array([phase.start]), np.array([phase.end])
            while not beyond(high)[0]:  # a mass that creeps, in the last hundredth of its run-out
                high *= 2.0
            while np.nextafter(low, high) < high:
                low, high, _ = first_section(beyond, low, high, _SHARES)
            return motion.at(float(high[0]))
    return None
