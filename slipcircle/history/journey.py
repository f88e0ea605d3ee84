"""Displacement of toe and centroid by a rotation."""

from typing import Any, NamedTuple

import numpy as np


class Journey(NamedTuple):
    """Displacement of toe and centroid by a rotation.

    Attributes
    ----------
    toe : ndarray
        x and y of the lower end of the slip surface, m. For an `Arc` the origin is the centre of its circle.
    run_out, rise
        Displacement of the toe, horizontal down-slope and upwards, m.
    travel, fall
        Displacement of the centroid, horizontal down-slope and downwards, m.
    travel_angle
        Inclination of the displacement of the centroid, arctan(fall/travel), rad.
    crest_drop
        Downward displacement of the upper end of the slip surface, m.
    """

    toe: Any
    run_out: Any
    rise: Any
    travel: Any
    fall: Any
    travel_angle: Any
    crest_drop: Any

    @property
    def toe_x(self) -> Any:
        """Horizontal coordinate of the toe, m."""
        return self.toe[..., 0][()]

    @property
    def toe_y(self) -> Any:
        """Vertical coordinate of the toe, m."""
        return self.toe[..., 1][()]


def journey(mass: Any, rotation: Any) -> Journey:
    """Return the displacement of toe and centroid by a rotation in rad.

    The chord of a rotation is parallel to the tangent at half of it. For a rotation of zero the angle is the
    direction in which the mass would begin to move.
    """
    toe = placed(mass, mass.exit, rotation)
    toe_moved = toe - mass.exit
    moved = placed(mass, mass.centroid, rotation) - mass.centroid
    half_rotation = np.multiply(rotation, 0.5)
    half_way = placed(mass, mass.centroid, half_rotation)
    from_centre = np.subtract(half_way, mass.centre)
    moves_back = np.less(rotation, 0.0)
    sign = np.where(moves_back, 1.0, -1.0)
    return Journey(
        toe=toe,
        crest_drop=mass.entry[..., 1] - placed(mass, mass.entry, rotation)[..., 1],
        run_out=toe_moved[..., 0] * mass.facing,
        rise=toe_moved[..., 1][()],
        travel=moved[..., 0] * mass.facing,
        fall=-moved[..., 1],
        travel_angle=np.arctan2(sign * mass.facing * from_centre[..., 0], sign * from_centre[..., 1]),
    )


def placed(mass: Any, points: Any, rotation: Any) -> Any:
    """Return the positions of points of the mass, (..., 2), after a rotation in rad, positive down-slope, m."""
    turn = np.multiply(rotation, mass.facing)
    from_centre = np.subtract(points, mass.centre)
    x = from_centre[..., 0]
    y = from_centre[..., 1]
    cosine = np.cos(turn)
    sine = np.sin(turn)
    turned_x = x * cosine - y * sine
    turned_y = x * sine + y * cosine
    turned = np.stack([turned_x, turned_y], axis=-1)
    return np.asarray(mass.centre) + turned
