"""Range of validity of a section: how far its toe may rise above the original ground."""

from typing import Any

import numpy as np

from slipcircle.core.scene.mass import MOST_ROTATION

RISE = 0.25  # of the height between entry and exit
_FAR = 4.0  # radii by which the ground is continued at both ends
_ROUNDING = 1e-12  # rad


def rotation_range(section: Any) -> tuple[float, Any]:
    """Return the rotations up-slope and down-slope that the method allows, rad.

    Down-slope the mass may turn until its toe is `RISE` above the original ground vertically below it. There the circle
    crosses a line that much above the ground, which continues horizontally beyond its ends.
    """
    left, right = (end.x + 1j * end.y for end in section._ends)
    rise = RISE * np.abs((right - left).imag)
    line = _ground(section) + 1j * rise[:, None]
    start = line[:, :-1]
    edge = np.diff(line)
    # |start + share edge| = 1
    square = np.abs(edge) ** 2
    along = (start * edge.conj()).real
    outside = np.abs(start) ** 2 - 1.0
    with np.errstate(invalid="ignore"):
        root = np.sqrt(along**2 - square * outside)
    shares = (np.stack([-root, root]) - along) / square
    crossing = start + shares * edge
    facing = section._facing
    toe = np.where(facing > 0.0, right, left)
    rotation = facing[:, None] * np.angle(crossing / toe[:, None])
    is_ahead = (0.0 <= shares) & (shares <= 1.0) & (rotation > -_ROUNDING)
    first = np.min(rotation, axis=(0, 2), where=is_ahead, initial=MOST_ROTATION)
    return -MOST_ROTATION, section._shaped(first)


def _ground(section: Any) -> Any:
    """Return the ground from the centre as complex numbers over the radius, (lanes, points)."""
    ground, centre, radius = section._circle
    points = (ground - centre[:, None]) / radius[:, None, None]
    line = points[..., 0] + 1j * points[..., 1]
    return np.concatenate([line[:, :1] - _FAR, line, line[:, -1:] + _FAR], axis=1)
