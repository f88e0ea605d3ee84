"""A dry tension crack: a slit in the ground, from which on downwards the arc is the slip surface.

The mass above the crack's side of the arc is what the slit leaves on the lower side; the slit has no width, so that
nothing else of the ground changes.
"""

from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from slipcircle.base.checks import Fault, complaint, raise_all
from slipcircle.base.series import Floats
from slipcircle.core.scene.coordinates import replace_unchecked
from slipcircle.core.scene.errors import geometry_errors
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.strips import meets_circle

_ON_ARC = 1e-9  # over R


class CrackedSection(Section):
    """A section whose slip surface begins at the bottom of a crack, where it has one."""

    crack: float  # its depth, m

    def __post_init__(self) -> None:
        if self.crack:
            of_whole = geometry_errors(self._uncracked)
            raise_all("LayeredSection", complaint(chain(of_whole, self._crack_errors()), self.shape))
        super().__post_init__()

    @cached_property
    def _uncracked(self) -> Any:
        """The section of the whole circle."""
        whole: Any = replace_unchecked(self, {"crack": 0.0})
        return whole

    @cached_property
    def _crack_place(self) -> Floats:
        """x of the crack, m, (lanes,)."""
        return crack_places(self._uncracked, self.crack)

    @cached_property
    def _circle(self) -> tuple[Floats, Floats, Floats]:
        """Ground, centre and radius with one axis of lanes; a crack is a slit in the ground."""
        ground, centre, radius = super()._circle
        if not self.crack:
            return ground, centre, radius
        return with_slits(ground, centre, radius, self._crack_place), centre, radius

    @cached_property
    def _candidates(self) -> tuple[Any, Any, Any, Any, Any]:
        """Of a cracked mass the part on the lower side of the crack."""
        lane, number, left, right, held = super()._candidates
        if self.crack:
            below = ((left + right) / 2 - self._crack_place[lane]) * self._uncracked._facing[lane] > 0.0
            lane, number, left, right = lane[below], number[below], left[below], right[below]
        return lane, number, left, right, held

    def _crack_errors(self) -> Iterator[Fault]:
        """Masses that are nowhere as thick as their crack is deep."""
        words = f"{{crack}} = {self.crack:.10g}: is deeper than the mass above the circle"
        yield np.isnan(self._crack_place), lambda _: words

    def geometry_errors(self) -> Iterator[Fault]:
        """Invalid sections, and sections that cannot move."""
        if self.crack:
            yield from self._uncracked.geometry_errors()
            yield from self._crack_errors()
        yield from super().geometry_errors()

    @cached_property
    def surface(self) -> Floats:
        """The ground over the mass of one section, from its left to its right end, m; beside a crack its wall."""
        if not self.crack:
            return super().surface
        below, (x,) = super().surface, self._crack_place
        (ground,) = self._uncracked._circle[0]
        edge = [[x, np.interp(x, *ground.T)]]
        place = 1 if float(np.asarray(self.facing)) > 0.0 else len(below) - 1
        return np.insert(below, place, edge, axis=0)


def crack_places(whole: Any, depth: float) -> Floats:
    """x where the ground is the crack's depth above the arc of an uncracked section, next to its upper end, (lanes,).

    NaN where the mass is nowhere so thick.
    """
    ground, centre, radius = whole._circle
    (left, _), (right, _) = whole._ends
    lowered = (ground - np.array([0.0, depth]) - centre[:, None]) / radius[:, None, None]
    x = meets_circle(lowered)
    height = np.stack([np.interp(one, *line.T) for one, line in zip(x, lowered, strict=True)])
    on_arc = np.abs(height + np.sqrt(np.maximum(1.0 - x * x, 0.0))) < _ON_ARC
    inside = on_arc & (x > left[:, None]) & (x < right[:, None])
    from_left = np.where(inside, x, np.inf).min(axis=1)
    from_right = np.where(inside, x, -np.inf).max(axis=1)
    place = centre[:, 0] + radius * np.where(whole._facing > 0.0, from_left, from_right)
    return np.where(np.isfinite(place), place, np.nan)


def with_slits(ground: Floats, centre: Floats, radius: Floats, place: Floats) -> Floats:
    """Grounds (lanes, V + 3, 2) with a slit at an x of each lane that is deeper than its circle."""
    lines = np.broadcast_to(ground, (len(radius), *ground.shape[1:]))
    top = np.array([np.interp(x, *line.T) for x, line in zip(place, lines, strict=True)])
    bottom = centre[:, 1] - 1.1 * radius
    slit = np.stack([np.stack([place] * 3, axis=1), np.stack([top, bottom, top], axis=1)], axis=2)
    points = np.concatenate([lines, slit], axis=1)
    order = np.argsort(points[..., 0], axis=1, kind="stable")
    return np.take_along_axis(points, order[..., None], axis=1)
