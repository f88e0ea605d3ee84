"""Where a rotation about the centre brings the mass of a section."""

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.ground.plane import Vectors


class Journey(NamedTuple):
    """Where a rotation brings the mass, m and rad."""

    toe: Any
    run_out: Any
    fall: Any
    travel_angle: Any

    @property
    def toe_x(self) -> Any:
        return self.toe[..., 0][()]

    @property
    def toe_y(self) -> Any:
        return self.toe[..., 1][()]


class TurningMass:
    """What becomes of the points of a section as its mass turns."""

    ground: Any
    level: Any
    centre: Any
    facing: Any
    entry: Any
    exit: Any
    centroid: Any

    @cached_property
    def surface(self) -> Floats:
        """The ground over the mass of one section, from its left to its right end, m."""
        ends = [tuple(self.entry), tuple(self.exit)]
        left, right = sorted(ends)
        ground = np.asarray(self.ground, dtype=np.float64)
        x = ground[:, 0]
        after_left = x > left[0]
        before_right = x < right[0]
        between = ground[after_left & before_right]
        return np.concatenate([[left], between, [right]])

    def drowned(self, *rotations: float) -> float:
        """How far below the water level the ground over one section's mass comes, where it is deepest, m."""
        if self.level is None:
            return 0.0
        level = np.asarray(self.level, dtype=np.float64)
        depths = [0.0]
        for rotation in rotations:
            turned = self.placed(self.surface, rotation)
            depths.append(_greatest_depth(turned, level))
        return max(depths)

    def placed(self, points: Any, rotation: Any) -> Any:
        """Points (..., 2) of the mass after a rotation, m."""
        turn = np.multiply(rotation, self.facing)
        from_centre = np.subtract(points, self.centre)
        x, y = Vectors.of(from_centre)
        cosine = np.cos(turn)
        sine = np.sin(turn)
        turned_x = x * cosine - y * sine
        turned_y = x * sine + y * cosine
        turned = Vectors(turned_x, turned_y)
        return np.asarray(self.centre) + turned.points

    def journey(self, rotation: Any) -> Journey:
        """Toe, its horizontal run-out, fall of the centroid, and travel angle: of the centroid's way, fall over run.

        The chord of a rotation is the tangent at its half, also of one of zero: there the mass would begin to move.
        """
        toe = self.placed(self.exit, rotation)
        moved = Vectors.of(toe - self.exit)
        run_out = moved.x * self.facing
        centroid = self.placed(self.centroid, rotation)
        fallen = Vectors.of(self.centroid - centroid)
        half_rotation = np.multiply(rotation, 0.5)
        at_half = self.placed(self.centroid, half_rotation)
        from_centre = np.subtract(at_half, self.centre)
        half_way = Vectors.of(from_centre)
        moves_back = np.less(rotation, 0.0)
        sign = np.where(moves_back, 1.0, -1.0)
        fall = sign * self.facing * half_way.x
        run = sign * half_way.y
        travel_angle = np.arctan2(fall, run)
        return Journey(toe, run_out, fallen.y, travel_angle)


def _greatest_depth(line: Floats, level: Floats) -> float:
    """Of a line's points below a level, at the vertices of both, m; 0 where the line is above."""
    points = Vectors.of(line)
    surface = Vectors.of(level)
    start = points.starts
    edge = points.edges
    above_points = np.interp(points.x, surface.x, surface.y)
    below_level = above_points - points.y
    vertex = surface[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (vertex.x - start.x) / edge.x  # of each edge, where a vertex of the level is
    on_edge = (share > 0.0) & (share < 1.0)
    height = start.y + share * edge.y
    below_vertices = np.where(on_edge, vertex.y - height, 0.0)
    return float(max(0.0, below_level.max(), below_vertices.max()))
