"""Shapes of a section: the mass on its circle, and the view."""

import math
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Arc

ON_ARC = 200  # number of points along the arc, the first points of an outline


class Mass(NamedTuple):
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
        start, end = self.ends
        return self.on_circle(np.linspace(start, end, ON_ARC))

    def outline(self, turn: float = 0.0) -> Floats:
        """Return the outline, (n, 2), turned counterclockwise: the arc from left to right, then back on the ground."""
        arc = self.arc
        first = arc[0]
        last = arc[-1]
        x = self.ground[:, 0]
        is_between = (first[0] <= x) & (x <= last[0])
        across, up = (self.ground - self.centre).T
        limit = (1 - 1e-9) * self.radius
        is_inside = np.hypot(across, up) < limit
        above = self.ground[is_between & is_inside]
        leftwards = above[::-1]
        outline = np.concatenate([arc, self._wall(last), leftwards, self._wall(first)])
        points = outline - self.centre
        cos = math.cos(turn)
        sin = math.sin(turn)
        rotation = [[cos, sin], [-sin, cos]]
        return self.centre + points @ rotation

    def _wall(self, end: Floats) -> Floats:
        """Return the ground above an end of the arc at the bottom of a tension crack, (1, 2), otherwise no point."""
        x, y = end
        height = np.interp(x, *self.ground.T)
        from_vertices = np.abs(self.ground[:, 0] - x)
        on_vertex = np.any(from_vertices < 1e-9 * self.radius)
        is_wall = height - y > 1e-6 * self.radius
        if on_vertex or not is_wall:
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
        left, bottom = every.min(axis=0)
        right, top = every.max(axis=0)
        return cls(left, bottom, right, top)

    @property
    def size(self) -> float:
        """Width or height, whichever is larger."""
        return max(self.right - self.left, self.top - self.bottom)

    def grown(self, across: float, up: float) -> "View":
        """Return the view with margins, ``across`` at the left and right, and ``up`` at bottom and top."""
        return View(self.left - across, self.bottom - up, self.right + across, self.top + up)

    def holds(self, points: Any) -> Any:
        """Return whether points, (..., 2), are in view, as an array of bool."""
        x, y = np.moveaxis(points, -1, 0)
        is_between_sides = (self.left <= x) & (x <= self.right)
        is_between_levels = (self.bottom <= y) & (y <= self.top)
        return is_between_sides & is_between_levels

    def show(self, ax: Any) -> None:
        """Set the limits of an axis to the view, or wider if the shape of the axis differs."""
        ax.set_xlim(self.left, self.right, auto=None)
        ax.set_ylim(self.bottom, self.top, auto=None)


def mass_of(circle: Any, soil: Any) -> Mass:
    """Return the mass of an arc, a section, or a critical circle in its slope; an arc has its chord as the ground."""
    radius = float(circle.radius)
    if isinstance(circle, Arc):
        ends = np.array([circle.theta_1, circle.theta_2])
        chord = radius * _directions(ends)
        return Mass(chord, np.zeros(2), radius, ends)
    centre = np.asarray(circle.centre, dtype=np.float64)
    from_centre = np.stack([circle.entry, circle.exit]) - centre
    across, up = from_centre.T
    from_below = np.arctan2(across, -up)  # measured from straight below, angles do not jump
    ends = np.sort(1.5 * math.pi + from_below)
    ground = np.asarray(soil.ground, dtype=np.float64)
    return Mass(ground, centre, radius, ends)
