"""Range of validity of a section: how far its toe may rise above the original ground.

Points are complex numbers.
"""

from typing import Any

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.core.scene.mass import Mass
from slipcircle.ground.ground import FAR, continued

RISE = 0.25  # allowed rise of the toe over the height between entry and exit
_PLANE = [1.0, 1.0j]
_ROUNDING = 1e-12  # rad


def rotation_range(section: Any) -> tuple[float, Any]:
    """Return the rotations up-slope and down-slope that the method allows, rad.

    The first is negative and the same for all sections, the second has the section's shape.

    Down-slope the mass may turn until its toe is `RISE` above the original ground vertically below it. There the circle
    crosses a line that much above the ground, which continues horizontally beyond its ends.
    """
    upslope, most = Mass.rotation_range
    _, centre, radius = section._circle
    middle = centre[:, None] @ _PLANE
    raised = _raised_ground(section)
    edge = np.diff(raised)
    length = np.abs(edge)
    way = edge / length
    from_centre = raised[:, :-1] - middle
    start = from_centre / way
    distance = start.imag
    square = radius[:, None] ** 2
    clear = square - distance**2
    with quiet():
        half = np.sqrt(clear)
    along = np.stack([-half, half])
    begin = start.real
    is_after = along >= begin
    is_before = along <= begin + length
    from_foot = along + 1.0j * distance
    crossing = way * from_foot
    at_toe = _point(section.exit) - middle
    turn = np.angle(crossing / at_toe)
    facing = section._facing
    rotation = facing[:, None] * turn
    is_ahead = rotation > -_ROUNDING
    counts = is_after & is_before & is_ahead
    first = np.min(rotation, axis=(0, 2), where=counts, initial=most)
    return upslope, section._shaped(first)


def _raised_ground(section: Any) -> Any:
    """Return the line to which the toe may rise, as complex numbers x + i y in m, (lanes, points)."""
    ground, *_ = section._circle
    level = continued(ground, -FAR, FAR)
    line = level @ _PLANE
    height = _point(section.entry) - _point(section.exit)
    rise = RISE * np.abs(height.imag)
    return line + 1.0j * rise


def _point(place: Any) -> Any:
    """Return a point of each circle as a complex number x + i y, (lanes, 1), from an array (..., 2)."""
    points = np.reshape(place, (-1, 1, 2))
    return points @ _PLANE
