"""Shapes of a section: the mass on its circle, and the view."""

import math
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Arc

ON_ARC = 61  # number of points along the arc, the first points of an outline


class MassShape(NamedTuple):
    """Geometry of a slip circle and the mass on it, in m and rad."""

    ground: Floats  # (n, 2); the chord of an arc
    centre: Floats
    radius: float
    ends: Any  # polar angles of both ends of the arc, increasing

    def on_circle(self, angles: Any) -> Floats:
        """Return the points of the circle at polar angles in rad, (..., 2)."""
        return self.centre + self.radius * _directions(angles)

    @property
    def arc(self) -> Floats:
        """Points along the arc from left to right, (ON_ARC, 2)."""
        return self.on_circle(np.linspace(self.ends[0], self.ends[1], ON_ARC))

    def outline(self, turn: float = 0.0) -> Floats:
        """Return the outline, (n, 2), turned counterclockwise: the arc from left to right, then back on the ground."""
        arc = self.arc
        first = arc[0]
        last = arc[-1]
        is_between = (first[0] <= self.ground[:, 0]) & (self.ground[:, 0] <= last[0])
        is_inside = np.hypot(*(self.ground - self.centre).T) < (1 - 1e-9) * self.radius
        leftwards = self.ground[is_between & is_inside][::-1]
        outline = np.concatenate([arc, self._wall(last), leftwards, self._wall(first)])
        cos, sin = math.cos(turn), math.sin(turn)
        return self.centre + (outline - self.centre) @ [[cos, sin], [-sin, cos]]

    def _wall(self, end: Floats) -> Floats:
        """Return the ground above an end of the arc at the bottom of a tension crack, (1, 2), otherwise no point."""
        x, y = end
        height = np.interp(x, *self.ground.T)
        is_on_vertex = np.any(np.abs(self.ground[:, 0] - x) < 1e-9 * self.radius)
        if is_on_vertex or height - y <= 1e-6 * self.radius:
            return np.empty((0, 2))
        return np.array([[x, height]])


def _directions(angles: Any) -> Floats:
    """Return unit vectors at polar angles in rad, (..., 2)."""
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


class View(NamedTuple):
    """Part of a section in view, in m."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, *points: Any) -> "View":
        """Return the smallest view that contains all points, arrays of shape (..., 2)."""
        every = np.concatenate([np.reshape(some, (-1, 2)) for some in points])
        return cls(*every.min(axis=0), *every.max(axis=0))

    @property
    def width(self) -> float:
        """Width in m."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Height in m."""
        return self.top - self.bottom

    @property
    def size(self) -> float:
        """Width or height, whichever is larger."""
        return max(self.width, self.height)

    def grown(self, across: float, up: float) -> "View":
        """Return the view with margins, ``across`` at the left and right, and ``up`` at bottom and top."""
        return View(self.left - across, self.bottom - up, self.right + across, self.top + up)

    def holds(self, points: Any) -> Any:
        """Return whether points, (..., 2), are in view, as an array of bool."""
        return np.all((points >= np.array(self[:2])) & (points <= np.array(self[2:])), axis=-1)

    def show(self, ax: Any) -> None:
        """Set the limits of an axis to the view, or wider if the shape of the axis differs."""
        ax.set_xlim(self.left, self.right, auto=None)
        ax.set_ylim(self.bottom, self.top, auto=None)


def mass_of(circle: Any, slope: Any = None) -> MassShape:
    """Return the mass of an arc, a section, or a critical circle in a slope; an arc has its chord as the ground."""
    radius = float(circle.radius)
    if isinstance(circle, Arc):
        ends = np.array([circle.theta_1, circle.theta_2])
        return MassShape(radius * _directions(ends), np.zeros(2), radius, ends)
    centre = np.asarray(circle.centre, dtype=np.float64)
    across, up = (np.stack([circle.entry, circle.exit]) - centre).T
    ends = np.sort(1.5 * math.pi + np.arctan2(across, -up))  # measured from straight below, angles do not jump
    return MassShape(np.asarray((slope or circle).ground, dtype=np.float64), centre, radius, ends)
