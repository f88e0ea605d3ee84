"""A dry tension crack: a slit in the ground, from which on downwards the arc is the slip surface.

The mass above the lower side of the arc is what the slit leaves; the slit has no width, so that nothing else of the
ground changes.
"""

from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from slipcircle.base.checks import Fault, complaint, raise_all
from slipcircle.base.kinds import Floats
from slipcircle.ground.coordinates import replace_unchecked
from slipcircle.ground.errors import geometry_errors
from slipcircle.ground.plane import each_lane
from slipcircle.ground.section import Section
from slipcircle.layers.strips import arc_crossings, edge_below


class CrackedSection(Section):
    """A section whose slip surface begins at the bottom of a crack, where it has one."""

    crack: Any  # its depth, m

    def __post_init__(self) -> None:
        if self._is_cracked:
            of_whole = geometry_errors(self._uncracked)
            faults = chain(of_whole, self._crack_errors())
            raise_all("LayeredSection", complaint(faults, self.shape))
        super().__post_init__()

    @property
    def _is_cracked(self) -> bool:
        return bool(np.any(self.crack))

    @cached_property
    def _uncracked(self) -> Any:
        """The section of the whole circle."""
        whole: Any = replace_unchecked(self, {"crack": 0.0})
        vars(whole)["shape"] = self.shape
        return whole

    @cached_property
    def _lowered_ground(self) -> Floats:
        """The ground from the centre, over R, lower by the depth of the crack, (lanes, V, 2)."""
        ground, centre, radius = self._uncracked._circle
        depth = np.broadcast_to(self.crack, self.shape).reshape(-1)
        down = np.stack([np.zeros_like(depth), depth], axis=1)
        lowered = ground - down[:, None]
        from_centre = lowered - centre[:, None]
        return from_centre / radius[:, None, None]

    @cached_property
    def _crack_place(self) -> Floats:
        """x of the crack, m, (lanes,): next to the upper end where the ground is the depth of the crack above the arc.

        NaN where the mass is nowhere so thick.
        """
        whole = self._uncracked
        _, centre, radius = whole._circle
        left, right = whole._ends
        over_radius = crack_place(self._lowered_ground, left.x, right.x, whole._facing)
        return centre[:, 0] + radius * over_radius

    @cached_property
    def _circle(self) -> tuple[Floats, Floats, Floats]:
        """Ground, centre and radius with one axis of lanes; a crack is a slit in the ground."""
        ground, centre, radius = super()._circle
        if not self._is_cracked:
            return ground, centre, radius
        below_circle = centre[:, 1] - 1.1 * radius
        with_slits = _with_slits(ground, below_circle, self._crack_place)
        return with_slits, centre, radius

    @cached_property
    def _candidates(self) -> tuple[Any, ...]:
        """Of a cracked mass the part on the lower side of the crack."""
        *columns, held = super()._candidates
        if not self._is_cracked:
            return *columns, held
        lane, _, left, right = columns
        middle = (left + right) / 2
        from_crack = middle - self._crack_place[lane]
        facing = self._uncracked._facing[lane]
        below = from_crack * facing > 0.0
        chosen = [column[below] for column in columns]
        return *chosen, held

    def _crack_errors(self) -> Iterator[Fault]:
        """Masses that are nowhere as thick as their crack is deep."""

        def sentence(k: int) -> str:
            depths = np.broadcast_to(self.crack, self.shape)
            depth = depths.flat[k]
            return f"{{crack}} = {depth:.10g}: is deeper than the mass above the circle"

        yield np.isnan(self._crack_place), sentence

    def geometry_errors(self) -> Iterator[Fault]:
        """Invalid sections, and sections that cannot move."""
        if self._is_cracked:
            yield from self._uncracked.geometry_errors()
            yield from self._crack_errors()
        yield from super().geometry_errors()

    @cached_property
    def surface(self) -> Floats:
        """The ground over the mass of one section, from its left to its right end, m; beside a crack its wall."""
        if not self._is_cracked:
            return super().surface
        below = super().surface
        (x,) = self._crack_place
        (ground,) = self._uncracked._circle[0]
        y = np.interp(x, *ground.T)
        place = 1 if self.facing > 0.0 else -1
        return np.insert(below, place, [x, y], axis=0)


def crack_place(lowered_ground: Floats, left: Floats, right: Floats, facing: Floats) -> Floats:
    """x over R from the centre, (n,), next to the upper end of arcs, where the ground lowered by a crack meets them.

    Grounds are (n, V, 2), from the centre, over R, the ends of arcs at left and right; NaN where it does not.
    """
    x = arc_crossings(lowered_ground)
    first = left[:, None]
    last = right[:, None]
    inside = (x > first) & (x < last)
    or_right = np.where(inside, x, np.inf)
    or_left = np.where(inside, x, -np.inf)
    from_left = or_right.min(axis=1)
    from_right = or_left.max(axis=1)
    place = np.where(facing > 0.0, from_left, from_right)
    return np.where(np.isfinite(place), place, np.nan)


def _with_slits(ground: Floats, bottom: Floats, x: Floats) -> Floats:
    """Grounds (lanes, V + 3, 2) with a slit down to a height at an x of each lane."""
    lines = each_lane(ground, len(x))
    across = x[:, None]
    heights, _ = edge_below(lines, across, across)
    top = heights[:, 0]
    slit_x = np.stack([x, x, x], axis=1)
    slit_y = np.stack([top, bottom, top], axis=1)
    slit = np.stack([slit_x, slit_y], axis=2)
    points = np.concatenate([lines, slit], axis=1)
    all_x = points[..., 0]
    order = np.argsort(all_x, axis=1, kind="stable")
    return np.take_along_axis(points, order[..., None], axis=1)
