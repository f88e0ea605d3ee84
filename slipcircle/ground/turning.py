"""Position of a section's mass after a rotation about the centre."""

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import Floats
from slipcircle.ground.plane import Vectors


class TurningMass:
    """Mixin for the points of a section as its mass turns."""

    ground: Any
    level: Any
    confined: Any
    radius: Any
    standing_level: Any
    entry: Any
    exit: Any
    centre: Any
    facing: Any
    centroid: Any
    placed: Callable[..., Any]

    @cached_property
    def surface(self) -> Floats:
        """Points of the ground above the mass of a single section, from its left to its right end, (V, 2), m."""
        ends = [tuple(self.entry), tuple(self.exit)]
        left, right = sorted(ends)
        ground = np.asarray(self.ground, float)
        x = ground[:, 0]
        after_left = x > left[0]
        before_right = x < right[0]
        between = ground[after_left & before_right]
        return np.concatenate([[left], between, [right]])

    def drowned(self, *rotations: float) -> float:
        """Return the greatest depth below the water level of the ground over one section's mass after rotations, m.

        The rotations are in rad, positive down-slope; the greatest depth after any of them counts.

        Below standing water at the exit, which is included, how far below a higher level elsewhere.
        """
        if self.level is None or self.confined:
            return 0.0
        level = np.asarray(self.level, float)
        depths = [0.0]
        (standing,) = self.standing_level
        lowest = self.centre[1] + self.radius * standing
        for rotation in rotations:
            x, y = self.placed(self.surface, rotation).T
            dry = np.maximum(y, lowest)
            turned = np.stack([x, dry], axis=1)
            # The greatest depth of a line below a level, at the vertices of both, m; 0 if the line is above it.
            points = Vectors.of(turned)
            surface = Vectors.of(level)
            start = points.starts
            edge = points.edges
            above_points = np.interp(points.x, surface.x, surface.y)
            below_level = above_points - points.y
            vertex = surface[:, None]
            with quiet():
                share = (vertex.x - start.x) / edge.x  # position of each vertex of the level on each edge
            on_edge = (share > 0.0) & (share < 1.0)
            height = start.y + share * edge.y
            below_vertices = np.where(on_edge, vertex.y - height, 0.0)
            depths.append(float(max(0.0, below_level.max(), below_vertices.max())))
        return max(depths)
