"""Free water: water levels above the ground, and ponds with a separate pore pressure."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.errors import Fault
from slipcircle.base.kinds import ArrayPair, Flags, Floats
from slipcircle.base.sections import distinct
from slipcircle.ground.ground import AS_PRINTED, FAR, continued
from slipcircle.ground.heights import edge_below
from slipcircle.ground.plane import each_lane

_LEVEL = 0.01  # allowed deviation of free water from a horizontal level, over the height of the ground
_ROUNDING = 1e-9  # tolerance over the size of the ground
Given = Sequence[tuple[float, float, float]]  # ponds: x of both shores, and the level


class Ponds(NamedTuple):
    """Free water in m, arrays of shape (ponds, lanes). The width is 0 where a lane lacks a pond.

    Attributes
    ----------
    first, last : ndarray
        x of both shores.
    level : ndarray
        Middle between the highest and the lowest point of the level.
    fall : ndarray
        Difference between the highest and the lowest point.
    """

    first: Floats
    last: Floats
    level: Floats
    fall: Floats

    @property
    def of_one(self) -> list[list[float]]:
        """Both shores (x) and the level of each pond on the ground of a single lane, from left to right, m."""
        of_lane = np.stack(self[:3])[..., 0]
        rows = of_lane.T.tolist()
        return sorted(row for row in rows if row[1] > row[0])

    def covering(self, x: Floats, y: Floats) -> Floats:
        """Return the level y of the water above points, (lanes,), -inf where a point is dry.

        The points, one per lane, have x and y in m.
        """
        rounding = _ROUNDING * (self.last - self.first)
        after_first = x >= self.first - rounding
        before_last = x <= self.last + rounding
        below = y < self.level
        covers = after_first & before_last & below
        levels = np.where(covers, self.level, -np.inf)
        return levels.max(axis=0, initial=-np.inf)


def free_water(grounds: Floats, levels: Floats | None, confined: bool, ponds: Given) -> Ponds:
    """Return free water over grounds (lanes or 1, V, 2), of ponds and of levels (lanes or 1, W, 2) above the ground.

    Levels that are ``confined`` have no free water. ``ponds`` contains x of both shores and the level of each pond, in
    m.
    """
    lanes = len(grounds)
    if levels is not None:
        (lanes,) = np.broadcast_shapes((lanes,), (len(levels),))
    every_ground = each_lane(grounds, lanes)
    bodies = list[Floats]()
    if levels is not None and not confined:
        bodies += _below(every_ground, levels)
    for first, last, level in ponds:
        shores = [first, level], [last, level]
        line = np.array([shores], float)
        bodies += _below(every_ground, line, first, last)
    count = len(bodies)
    by_body = np.reshape(bodies, (count, 4, lanes))
    columns = by_body.swapaxes(0, 1)
    return Ponds(*columns)


def _below(grounds: Floats, levels: Floats, first: float = -np.inf, last: float = np.inf) -> Iterator[Floats]:
    """Yield the fields of `Ponds`, (4, lanes), of water between grounds (lanes, V, 2) and levels (lanes or 1, W, 2), m.

    Water that does not reach between `first` and `last` is left out.
    """
    levels = continued(levels, -2 * FAR, 2 * FAR)
    x, is_wet = _wet_sections(grounds, levels)
    if not np.any(is_wet):
        return
    by_lane = x.T
    heights, _ = edge_below(levels, by_lane, by_lane)
    at_start = heights[:, :-1].T
    at_end = heights[:, 1:].T
    lower = np.minimum(at_start, at_end)
    higher = np.maximum(at_start, at_end)
    changes = np.diff(is_wet, axis=0, prepend=False)
    number = np.cumsum(changes & is_wet, axis=0)
    below_all = grounds.min(axis=(0, 1), initial=0.0) - 1.0  # where a lane has less water
    outside, bottom = below_all.tolist()
    start = x[:-1]
    end = x[1:]
    count = number.max(initial=0)
    for k in range(1, count + 1):
        inside = is_wet & (number == k)
        left, right = _range(start, end, inside, outside)
        begins_before = left < last
        ends_after = right > first
        reaches = begins_before & ends_after
        low, high = _range(lower, higher, inside, bottom)
        left = np.where(reaches, left, outside)
        right = np.where(reaches, right, outside)
        middle_height = (low + high) / 2
        fall = high - low
        yield np.stack([left, right, middle_height, fall])


def _range(low: Floats, high: Floats, inside: Flags, nothing: float) -> ArrayPair:
    """Return the least low and the greatest high value in marked sections, (lanes,), `nothing` in lanes without one.

    `nothing` is below all values. The arguments are (sections, lanes).
    """
    greatest = high.max(axis=0, where=inside, initial=nothing)
    least = low.min(axis=0, where=inside, initial=np.inf)
    return np.minimum(least, greatest), greatest


def _wet_sections(grounds: Floats, levels: Floats) -> tuple[Floats, Flags]:
    """Return x of the edges of sections, (edges, lanes), in m, and whether a level is above the ground in each.

    Grounds are (lanes, V, 2), and levels (lanes or 1, W, 2) extend beyond them.
    """

    def depth(x: Floats) -> ArrayPair:
        by_lane = x.T
        height, slope = edge_below(levels, by_lane, by_lane)
        ground, ground_slope = edge_below(grounds, by_lane, by_lane)
        below_level = height - ground
        growth = slope - ground_slope
        return below_level.T, growth.T

    left, right = grounds[:, [0, -1], 0].T
    of_lanes = each_lane(levels, len(grounds))
    points = np.concatenate([grounds, of_lanes], axis=1)
    vertices = points[..., 0].T
    within_ground = np.clip(vertices, left, right)
    x = _sections(within_ground)
    middle = (x[:-1] + x[1:]) / 2
    in_middle, growth = depth(middle)
    divisor = np.where(growth == 0.0, np.inf, growth)
    shores = middle - in_middle / divisor
    within_section = np.clip(shores, x[:-1], x[1:])
    every_edge = np.concatenate([x, within_section])
    x = _sections(every_edge)
    middle = (x[:-1] + x[1:]) / 2
    in_middle, _ = depth(middle)
    least = _ROUNDING * (right - left)
    is_deep = in_middle > least
    has_width = x[1:] > x[:-1]
    return x, is_deep & has_width


def _sections(x: Floats) -> Floats:
    """Return the edges of sections between places x, sorted in each lane, (edges, lanes)."""
    in_order = np.sort(x, axis=0)
    return distinct(in_order, 0.0)


# --- mistakes --------------------------------------------------------------------------------------------------------


def water_faults(grounds: Floats, levels: Floats | None, confined: bool, ponds: Given) -> Iterator[Fault]:
    """Yield the errors of levels beside the ground, sloping free water, and ponds that are dry or too short.

    An error is a mask of lanes and a function from the index of a lane to its message; arguments are as for
    `free_water`.
    """
    if levels is not None:
        left, right = grounds[:, [0, -1], 0].T
        first, last = levels[:, [0, -1], 0].T
        ends_before = last < left
        begins_after = first > right
        beside = "{level}: lies beside the ground; it must extend over it"
        yield ends_before | begins_after, lambda k: beside
        water = free_water(grounds, levels, confined, ())
        yield _sloping_water(grounds, water)
    for number, pond in enumerate(ponds, 1):
        name = f"{{pond.{number}.level}}"
        water = free_water(grounds, None, confined, [pond])
        yield from _pond_faults(name, pond, water)
    if ponds:
        yield _water_in_water(free_water(grounds, levels, confined, ponds))


def _water_in_water(water: Ponds) -> Fault:
    """Return the error of ponds in other free water: a mask of lanes, and a function that returns the message."""
    in_order = np.argsort(water.first, axis=0)
    first = np.take_along_axis(water.first, in_order, axis=0)
    last = np.take_along_axis(water.last, in_order, axis=0)
    overlaps = last[:-1] > first[1:]
    return overlaps.any(axis=0), lambda k: "{ponds}: lies in other free water; remove one of them"


def _sloping_water(grounds: Floats, water: Ponds) -> Fault:
    """Return the error of free water that is not horizontal.

    It is a mask of lanes and a function from the index of a lane to its message. The grounds are (lanes or 1, V, 2).
    """
    width, height = np.ptp(grounds, axis=1).T
    rounding = _ROUNDING * width
    tolerance = np.maximum(_LEVEL * height, rounding)
    slopes = water.fall > tolerance

    def sentence(k: int) -> str:
        body = np.argmax(slopes[:, k])
        of_bodies = np.stack(water)
        first, last, _, fall = of_bodies[:, body, k]
        where = f"from x = {first:.10g} to {last:.10g}, where it is above the ground"
        remedy = "give a horizontal level there, or {confined} = true for an artesian level without free water"
        return f"{{level}}: varies by {fall:.4g} m {where}; free water is horizontal: {remedy}"

    return slopes.any(axis=0), sentence


def _pond_faults(name: str, pond: Sequence[float], water: Ponds) -> Iterator[Fault]:
    """Yield the errors of a pond, x of its shores and its level: lanes where it is dry, or reaches farther.

    An error is a mask of lanes and a function from the index of a lane to its message, which begins with the name.
    """
    first, last, _ = pond
    is_water = water.last > water.first
    dry = f"{name}: the ground from x = {first:.10g} to {last:.10g} lies above it"
    has_water = is_water.any(axis=0)
    yield ~has_water, lambda k: dry
    left = water.first.min(axis=0, where=is_water, initial=np.inf)
    right = water.last.max(axis=0, where=is_water, initial=-np.inf)
    rounding = AS_PRINTED * (right - left)
    starts_inside = first > left + rounding
    ends_inside = last < right - rounding

    def sentence(k: int) -> str:
        reach = f"from x = {left[k]:.8g} to {right[k]:.8g}"
        return f"{name}: water at this level reaches {reach}; extend the pond to both shores"

    yield starts_inside | ends_inside, sentence


def ends_above(levels: Floats, left: Floats, right: Floats) -> Fault:
    """Return the error of levels that end above masses.

    Levels are (lanes or 1, W, 2), and ``left`` and ``right`` are x of the ends of the masses, (lanes,). The error is a
    mask of lanes and a function from the index of a lane to its message.
    """
    ends = levels[:, [0, -1], 0].T
    rounding = _ROUNDING * (right - left)
    after_left = ends > left + rounding
    before_right = ends < right - rounding
    inside = after_left & before_right

    def sentence(k: int) -> str:
        of_lane = ends[:, k % len(levels)]
        x = of_lane[inside[:, k]][0]
        mass = f"the mass from x = {left[k]:.6g} to {right[k]:.6g}"
        return f"{{level}}: ends at x = {x:.10g}, above {mass}; extend it beyond the mass"

    return inside.any(axis=0), sentence


def other_water(section: Any, left: Floats, right: Floats) -> Fault:
    """Return the error of masses under free water of another level than at the exit.

    ``left`` and ``right`` are x of the ends of the masses, (lanes,). The error is a mask of lanes and a function from
    the index of a lane to its message.
    """
    _, centre, radius = section._circle
    water = section.free_water
    first = np.maximum(water.first, left)
    last = np.minimum(water.last, right)
    at_exit = centre[:, 1] + radius * section.standing_level
    difference = np.abs(water.level - at_exit)
    differs = difference > 1e-9 * radius
    covers = last > first
    other = covers & differs

    def sentence(k: int) -> str:
        levels = np.broadcast_to(water.level, other.shape)
        of_lane = levels[:, k]
        level = of_lane[other[:, k]][0]
        if np.isinf(at_exit[k]):
            why = "not its exit"
        else:
            why = f"free water at y = {at_exit[k]:.6g} its exit"
        return (
            f"{{level}}: free water at y = {level:.6g} covers the mass, and {why}; a motion takes the level at the exit"
        )

    return other.any(axis=0), sentence
