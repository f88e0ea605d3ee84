"""Range of validity of a section: how far its toe may rise above the original ground."""

from typing import Any

import numpy as np

from slipcircle.core.scene.mass import Mass
from slipcircle.ground.ground import FAR, continued

RISE = 0.25  # of the height between entry and exit
_PLANE = [1.0, 1.0j]  # points as complex numbers
_ROUNDING = 1e-12  # rad


def rotation_range(section: Any) -> tuple[float, Any]:
    """Return the rotations up-slope and down-slope that the method allows, rad.

    Down-slope the mass may turn until its toe is `RISE` above the original ground vertically below it. There the circle
    crosses a line that much above the ground, which continues horizontally beyond its ends.
    """
    upslope, most = Mass.rotation_range
    ground, centre, radius = section._circle
    toe, entry = (np.reshape(end, (-1, 1, 2)) @ _PLANE for end in (section.exit, section.entry))
    line = continued(ground, -FAR, FAR) @ _PLANE + RISE * 1.0j * np.abs((entry - toe).imag)
    middle = centre[:, None] @ _PLANE
    edge = np.diff(line)
    way = edge / np.abs(edge)
    start = (line[:, :-1] - middle) / way
    with np.errstate(invalid="ignore"):
        half = np.sqrt(radius[:, None] ** 2 - start.imag**2)
    along = np.stack([-half, half])
    is_on_edge = (start.real <= along) & (along <= start.real + np.abs(edge))
    crossing = way * (along + 1.0j * start.imag)
    rotation = section._facing[:, None] * np.angle(crossing / (toe - middle))
    is_ahead = is_on_edge & (rotation > -_ROUNDING)
    return upslope, section._shaped(np.min(rotation, axis=(0, 2), where=is_ahead, initial=most))
