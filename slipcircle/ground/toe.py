"""Range of validity of a section: how far its toe may rise above the original ground."""

from typing import Any

import numpy as np

from slipcircle.core.scene.mass import MOST_ROTATION

RISE = 0.25  # of the height between entry and exit
_FAR = 4.0  # radii by which the ground is continued at both ends
_ROUNDING = 1e-12


def rotation_range(section: Any) -> tuple[float, Any]:
    """Return the rotations up-slope and down-slope that the method allows, rad.

    Down-slope the mass may turn until its toe is `RISE` above the original ground vertically below it. The toe crosses
    a line that high above the ground, which continues horizontally beyond its ends.
    """
    ground, centre, radius = section._circle
    left, right = section._ends
    rise = RISE * np.abs(left.y - right.y)
    line = (ground - centre[:, None, :]) / radius[:, None, None]
    line = np.concatenate([line[:, :1], line, line[:, -1:]], axis=1)
    line[:, 0, 0] -= _FAR
    line[:, -1, 0] += _FAR
    line[:, :, 1] += rise[:, None]
    run = np.diff(line, axis=1)
    start = line[:, :-1]
    square = np.sum(run**2, axis=-1)
    along = np.sum(start * run, axis=-1)
    outside = np.sum(start**2, axis=-1) - 1.0
    with np.errstate(invalid="ignore"):
        root = np.sqrt(along**2 - square * outside)
    shares = (np.stack([-root, root]) - along) / square
    x, y = np.moveaxis(start + shares[..., None] * run, -1, 0)
    first, last = section._angles
    toe = np.where(section._facing > 0.0, last, first)
    rotation = section._facing[:, None] * (np.arctan2(x, -y) - toe[:, None])
    rotation = (rotation + _ROUNDING) % (2.0 * np.pi) - _ROUNDING
    crosses = (0.0 <= shares) & (shares <= 1.0)
    least = np.min(rotation, axis=(0, 2), where=crosses, initial=MOST_ROTATION)
    return -MOST_ROTATION, section._shaped(np.maximum(least, 0.0))
