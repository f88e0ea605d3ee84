"""Dry tension crack: a slit in the ground, at whose bottom the slip surface begins.

The slit separates the mass on its down-slope side. It has no width, so that the ground does not change otherwise.
"""

from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from slipcircle.base.errors import Fault, complaint, raise_all
from slipcircle.base.kinds import ArrayTriple, Floats
from slipcircle.ground.errors import geometry_errors
from slipcircle.ground.heights import edge_below
from slipcircle.ground.plane import each_lane
from slipcircle.ground.section import Section
from slipcircle.layers.strips import arc_crossings
from slipcircle.tree import replace_unchecked


class CrackedSection(Section):
    """Section whose slip surface begins at the bottom of a crack, if it has one."""

    crack: Any  # depth, m

    def __post_init__(self) -> None:
        """Check the complete circle and the crack, then the remaining section."""
        if self._is_cracked:
            faults = chain(geometry_errors(self._uncracked), self._crack_errors())
            raise_all("LayeredSection", complaint(faults, self.shape))
        super().__post_init__()

    @property
    def _is_cracked(self) -> bool:
        return bool(np.any(self.crack))

    @cached_property
    def _uncracked(self) -> Any:
        """Section of the complete circle."""
        whole = replace_unchecked(self, {"crack": 0.0})
        vars(whole)["shape"] = self.shape
        return whole

    @cached_property
    def _lowered_ground(self) -> Floats:
        """Ground relative to the centre, over R, lowered by the depth of the crack, (lanes, V, 2)."""
        ground, centre, radius = self._uncracked._circle
        depth = np.broadcast_to(self.crack, self.shape).ravel()
        down = np.stack([np.zeros_like(depth), depth], axis=1)
        return (ground - down[:, None] - centre[:, None]) / radius[:, None, None]

    @cached_property
    def _crack_place(self) -> Floats:
        """Position of the crack along x, m, (lanes,), next to the upper end, where the mass is as thick as it is deep.

        NaN if the mass is thinner everywhere.
        """
        whole = self._uncracked
        _, centre, radius = whole._circle
        left, right = whole._ends
        return centre[:, 0] + radius * crack_place(self._lowered_ground, left.x, right.x, whole._facing)

    @cached_property
    def _circle(self) -> ArrayTriple:
        """Ground, centre and radius with one axis of lanes; a crack is a slit in the ground."""
        ground, centre, radius = super()._circle
        if not self._is_cracked:
            return ground, centre, radius
        below_circle = centre[:, 1] - 1.1 * radius
        # Grounds (lanes, V + 3, 2) with a slit down to a height at the x of each lane.
        lines = each_lane(ground, len(self._crack_place))
        across = self._crack_place[:, None]
        heights, _ = edge_below(lines, across, across)
        top = heights[:, 0]
        slit_x = np.stack([self._crack_place, self._crack_place, self._crack_place], axis=1)
        slit = np.stack([slit_x, np.stack([top, below_circle, top], axis=1)], axis=2)
        points = np.concatenate([lines, slit], axis=1)
        order = np.argsort(points[..., 0], axis=1, kind="stable")
        return np.take_along_axis(points, order[..., None], axis=1), centre, radius

    @cached_property
    def _candidates(self) -> tuple[Any, ...]:
        """Candidates, which for a cracked mass lie on the lower side of the crack."""
        *columns, held = super()._candidates
        if not self._is_cracked:
            return *columns, held
        lane, _, left, right = columns
        below = ((left + right) / 2 - self._crack_place[lane]) * self._uncracked._facing[lane] > 0.0
        chosen = [column[below] for column in columns]
        return *chosen, held

    def _crack_errors(self) -> Iterator[Fault]:
        """Yield one fault, the lanes whose mass is thinner everywhere than their crack is deep.

        A fault is a mask of lanes (members of an ensemble) and a function that describes a lane by its index.
        """

        def sentence(k: int) -> str:
            depth = np.broadcast_to(self.crack, self.shape).flat[k]
            return f"{{crack}} = {depth:.10g}: is deeper than the mass above the circle"

        yield np.isnan(self._crack_place), sentence

    def geometry_errors(self) -> Iterator[Fault]:
        """Yield the faults of invalid sections and of sections that cannot move.

        A fault is a mask of lanes (members of an ensemble) and a function that describes a lane by its index.
        """
        if self._is_cracked:
            yield from self._uncracked.geometry_errors()
            yield from self._crack_errors()
        yield from super().geometry_errors()

    @cached_property
    def surface(self) -> Floats:
        """Ground above the mass of one section, from its left to its right end, m, including the wall of a crack."""
        if not self._is_cracked:
            return super().surface
        below = super().surface
        (x,) = self._crack_place
        (ground,) = self._uncracked._circle[0]
        y = np.interp(x, *ground.T)
        place = 1 if self.facing > 0.0 else -1
        return np.insert(below, place, [x, y], axis=0)


def crack_place(lowered_ground: Floats, left: Floats, right: Floats, facing: Floats) -> Floats:
    """Return x over R, (n,), next to the upper end of arcs, where the ground lowered by a crack meets them.

    Grounds are (n, V, 2), relative to the centre and over R. The ends of arcs are at x = `left` and `right`, (n,), and
    `facing` is 1 if the mass slides to the right and -1 otherwise. The result is NaN without such a point.
    """
    x = arc_crossings(lowered_ground)
    inside = (x > left[:, None]) & (x < right[:, None])
    or_right = np.where(inside, x, np.inf)
    place = np.where(facing > 0.0, or_right.min(axis=1), np.where(inside, x, -np.inf).max(axis=1))
    return np.where(np.isfinite(place), place, np.nan)
