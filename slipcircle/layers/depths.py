"""Depth of an arc below a line that stays in space, with which cohesion grows: integrals along the arc.

Vertically below the line as it lies before the slide; where the line is below the arc the depth is 0. Beyond the ends
of the arc lies the strength of the end.
"""

from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import ArrayPair, Effects, Floats
from slipcircle.ground.ground import continued
from slipcircle.ground.heights import HeightIntegrals, edge_below, height_integrals
from slipcircle.ground.water import turned_by
from slipcircle.layers.at_rest import cohesion_at_rest
from slipcircle.layers.standing import relieved

_INWARD = 1e-9  # of an end of the arc, over R: at a scarp the ground of the mass counts


class Depths(NamedTuple):
    """Depths of arcs below a line, over R; directions are down-slope."""

    facing: Floats
    first: Floats
    last: Floats
    held: ArrayPair  # depths at both ends of the arc
    heights: HeightIntegrals
    level: Floats | None  # of a horizontal line, whose integrals are cheaper

    def integral(self, there: Floats, limit: Any = None) -> Floats:
        """Return the integral of the depth from the entry of the arc to directions (..., circles), over R.

        The line of each arc is used up to `limit`, by default the exit, and the depth is constant beyond.
        """
        limit = self.last if limit is None else limit
        inside = np.clip(there, self.first, limit)
        if self.level is None:
            # The integral of the height of the line from the entry to directions on the arc.
            entry = self.facing * self.first
            end = self.facing * inside
            within = self.heights.integral(np.minimum(entry, end), np.maximum(entry, end))
        else:
            within = relieved(self.level, self.first, inside)
        at_first, at_last = self.held
        beyond = there - inside
        return within + beyond * np.where(beyond > 0.0, at_last, at_first)

    def mean(self, rotation: Floats) -> Floats:
        """Return the mean depth over R along the arc under the mass after rotations (..., circles) in rad."""
        up_to_exit = self.integral(self.last + rotation)
        return (up_to_exit - self.integral(self.first + rotation)) / (self.last - self.first)

    @property
    def kinks(self) -> Floats:
        """Directions in rad, positive down-slope, at which a cumulative integral has kinks, (circles, kinks)."""
        of_line = self.heights.kinks * self.facing[:, None]
        return np.concatenate([of_line, np.stack([self.first, self.last], axis=1)], axis=1)


def depths_below(section: Any, top: Any) -> Depths:
    """Return the depths of the arcs of a section below its ground or another top.

    `top` is None for the ground, a height in m, heights in the section's shape, or points of a line, (V, 2).
    """
    _, centre, radius = section._circle
    lines = section._top_line(top)
    facing = section._facing
    first, last = section._span
    line = continued((lines - centre[:, None]) / radius[:, None, None], -2.0, 2.0)
    heights = height_integrals(lines, centre, radius)
    held = _at_end(line, facing, first, _INWARD), _at_end(line, facing, last, -_INWARD)
    level = None
    if top is not None and np.ndim(top) < 2:
        level = line[:, 0, 1]
    return Depths(facing, first, last, held, heights, level)


def _at_end(line: Floats, facing: Floats, direction: Floats, inward: float) -> Floats:
    """Return the depths of an end of the arcs below lines, over R, (circles,).

    `direction` is the direction of the end in rad, positive down-slope. `inward` is a small step into the mass.
    """
    x = facing * np.sin(direction)
    y, _ = edge_below(line, x[:, None], (x + facing * inward)[:, None])
    return np.maximum(y[:, 0] + np.cos(direction), 0.0)


class MeanDepth(NamedTuple):
    """Mean depth of the slip surface of a section of one soil as a function of the rotation, m."""

    section: Any
    depths: Depths

    def __call__(self, rotation: Any) -> Any:
        """Return the mean depth in m at rotations in rad, in the shape of the rotations."""
        shape, turned = turned_by(self.section, rotation)
        return self.depths.mean(turned).reshape(shape) * self.section.radius

    @property
    def kinks(self) -> Floats:
        """Rotations in rad at which the mean depth is not smooth, sorted along the last axis, (circles, kinks)."""
        ends = np.stack([self.depths.first, self.depths.last], axis=1)
        rotations = (self.depths.kinks[:, :, None] - ends[:, None]).reshape(len(ends), -1)
        return np.sort(rotations, axis=1)


def growing(section: Any, cohesion: Any, effects: Effects) -> Effects:
    """Return the effects, with the depth of the slip surface added to a cohesion that grows with it.

    `cohesion` is the cohesion of the scene's effects, with its gradient and the datum below which it grows.
    """
    depth = MeanDepth(section, depths_below(section, cohesion.get("datum")))
    grown = {**effects}
    for name, parameters in effects.items():
        if name == "cohesion" and "gradient" in parameters:
            grown[name] = {**parameters, "depth": depth}
        elif name.startswith("softening"):
            gradient = parameters["moment"] * (cohesion["gradient"] / cohesion_at_rest(cohesion))
            grown[name] = {**parameters, "gradient": gradient, "depth": depth}
    return grown
