"""Depth of an arc below a line that stays in space, with which cohesion grows: integrals along the arc.

Vertically below the line as it lies before the slide; where the line is below the arc the depth is 0. Beyond the ends
of the arc lies the strength of the end.
"""

from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Effects, Floats
from slipcircle.ground.ground import continued
from slipcircle.ground.heights import HeightIntegrals, height_integrals
from slipcircle.layers.at_rest import cohesion_at_rest
from slipcircle.layers.strips import edge_below

_INWARD = 1e-9  # of an end of the arc, over R: at a scarp the ground of the mass counts


class Depths(NamedTuple):
    """Depths of arcs below a line, over R; directions are down-slope."""

    facing: Floats
    first: Floats
    last: Floats
    held: tuple[Floats, Floats]  # depths at both ends of the arc
    heights: HeightIntegrals

    def integral(self, there: Floats, limit: Any = None) -> Floats:
        """Integral from the entry of the arc to directions (..., circles), by its own line up to a limit beyond."""
        limit = self.last if limit is None else limit
        inside = np.clip(there, self.first, limit)
        ends = self.facing * self.first, self.facing * inside
        within = self.heights.integral(np.minimum(*ends), np.maximum(*ends))
        at_first, at_last = self.held
        beyond = there - inside
        at_end = np.where(beyond > 0.0, at_last, at_first)
        total: Floats = within + beyond * at_end
        return total

    def mean(self, rotation: Floats) -> Floats:
        """Mean depth over the arc under the mass after rotations (..., circles)."""
        until = self.integral(self.last + rotation)
        before = self.integral(self.first + rotation)
        mean: Floats = (until - before) / (self.last - self.first)
        return mean

    @property
    def kinks(self) -> Floats:
        """Directions at which a cumulative integral has kinks, (circles, kinks)."""
        of_line = self.heights.kinks * self.facing[:, None]
        ends = np.stack([self.first, self.last], axis=1)
        return np.concatenate([of_line, ends], axis=1)


def depths_below(section: Any, top: Any) -> Depths:
    """Return the depths of the arcs of a section below a height, heights of its shape, or a line; below its ground."""
    ground, centre, radius = section._circle
    if top is None:
        lines = ground
    elif np.ndim(top) > 1:
        lines = section._lines(top)
    else:
        heights = np.broadcast_to(top, section.shape if np.ndim(top) else ()).reshape(-1, 1)
        lines = np.stack(np.broadcast_arrays(ground[:1, [0, -1], 0], heights), axis=-1)
    facing = section._facing
    first, last = section._span
    over_radius = continued((lines - centre[:, None]) / radius[:, None, None], -2.0, 2.0)
    held = []
    for direction, inward in (first, _INWARD), (last, -_INWARD):
        x = facing * np.sin(direction)
        inside = x + facing * inward
        height, _ = edge_below(over_radius, x[:, None], inside[:, None])
        held.append(np.maximum(height[:, 0] + np.cos(direction), 0.0))
    at_first, at_last = held
    return Depths(facing, first, last, (at_first, at_last), height_integrals(lines, centre, radius))


class MeanDepth(NamedTuple):
    """Mean depth of the slip surface of a section of one soil as a function of the rotation, m."""

    section: Any
    depths: Depths

    def __call__(self, rotation: Any) -> Any:
        shape, turned = self.section._rotations(rotation)
        return self.depths.mean(turned).reshape(shape) * self.section.radius

    @property
    def kinks(self) -> Floats:
        """Rotations at which it is not smooth, on a last axis."""
        ends = np.stack([self.depths.first, self.depths.last], axis=1)
        between = self.depths.kinks[:, :, None] - ends[:, None]
        rotations: Floats = np.sort(between.reshape(len(ends), -1), axis=1)
        return rotations


def growing(section: Any, cohesion: Any, effects: Effects) -> Effects:
    """Return effects of which the cohesion, or that which softens, grows with depth."""
    depth = MeanDepth(section, depths_below(section, cohesion.get("datum")))
    grown = {**effects}
    for name, given in effects.items():
        if name == "cohesion" and "gradient" in given:
            grown[name] = {**given, "depth": depth}
        elif name.startswith("softening"):
            peak = cohesion_at_rest(cohesion)
            grown[name] = {**given, "gradient": given["moment"] * cohesion["gradient"] / peak, "depth": depth}
    return grown
