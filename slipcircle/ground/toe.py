"""Range of validity of a section: how far its toe may rise above the original ground."""

from typing import Any

import numpy as np

from slipcircle.core.scene.mass import Mass
from slipcircle.ground.ground import continued

RISE = 0.25  # of the height between entry and exit
_ROUNDING = 1e-12  # rad


def rotation_range(section: Any) -> tuple[float, Any]:
    """Return the rotations up-slope and down-slope that the method allows, rad.

    Down-slope the mass may turn until its toe is `RISE` above the original ground vertically below it. There the circle
    crosses a line that much above the ground, which continues horizontally beyond its ends.
    """
    upslope, most = Mass.rotation_range
    ground, centre, radius = section._circle
    left, right = section._ends
    x = centre[:, 0]
    line = (continued(ground, np.min(x - 2.0 * radius), np.max(x + 2.0 * radius)) - centre[:, None]) / radius[
        :, None, None
    ]
    rise = RISE * np.abs(left.y - right.y)
    raised = line[..., 0] + 1j * (line[..., 1] + rise[:, None])
    start = raised[:, :-1]
    edge = np.diff(raised)
    way = edge / np.abs(edge)
    foot = start - (start / way).real * way  # of the perpendicular from the centre
    with np.errstate(invalid="ignore"):
        half = np.sqrt(1.0 - np.abs(foot) ** 2)
    crossing = foot + np.stack([-half, half]) * way
    share = ((crossing - start) / edge).real
    facing = section._facing
    first, last = section._angles
    toe = np.where(facing > 0.0, last, first)
    rotation = facing[:, None] * (np.angle(1j * crossing) - toe[:, None])
    is_ahead = (0.0 <= share) & (share <= 1.0) & (rotation > -_ROUNDING)
    return upslope, section._shaped(np.min(rotation, axis=(0, 2), where=is_ahead, initial=most))
