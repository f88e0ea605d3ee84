"""Free water: water levels above the ground, and ponds with a separate pore pressure."""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise, repeat
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.errors import Fault
from slipcircle.base.kinds import Floats
from slipcircle.ground.ground import AS_PRINTED
from slipcircle.ground.plane import each_lane

_LEVEL = 0.01  # allowed deviation of free water from a horizontal level, over the height of the ground
_ROUNDING = 1e-9  # tolerance over the size of the ground
Bodies = list[list[float]]  # shores, mean level and fall of each
Given = Sequence[tuple[float, float, float]]  # ponds: x of both shores, and the level


class Ponds(NamedTuple):
    """Free water in m, arrays of shape (ponds, lanes). The width is 0 where a lane has fewer ponds.

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
    def of_one(self) -> Bodies:
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
    pairs = _pairs(grounds, levels)
    bodies = [_bodies(ground, level, confined, ponds) for ground, level in pairs]
    lanes = len(bodies)
    count = max(map(len, bodies), default=0)
    first_points = grounds[:, 0]
    x, y = first_points.min(axis=0, initial=np.inf)
    outside = x - 1.0
    nothing = [outside, outside, y, 0.0]  # where a lane has less water
    padded = []
    for of_lane in bodies:
        missing = count - len(of_lane)
        padded.append(of_lane + missing * [nothing])
    table: Floats = np.reshape(padded, (lanes, count, 4))
    return Ponds(*table.T)


def _pairs(grounds: Floats, levels: Floats | None) -> Iterator[tuple[Floats, Any]]:
    """Return each ground (V, 2) with its level (W, 2), or None without a level, for each lane."""
    if levels is None:
        return zip(grounds, repeat(None), strict=False)
    if len(grounds) == 1:
        lanes = len(levels)
    else:
        lanes = len(grounds)
    of_grounds = each_lane(grounds, lanes)
    of_levels = each_lane(levels, lanes)
    return zip(of_grounds, of_levels, strict=True)


def _bodies(ground: Floats, level: Floats | None, confined: bool, ponds: Given) -> Bodies:
    """Return x of both shores, mean level and fall of each body of free water over one ground, (V, 2), in m.

    ``level`` has points (W, 2) or is None.
    """
    bodies = []
    if level is not None and not confined:
        bodies += _below(ground, level)
    for pond in ponds:
        bodies += _pond(ground, pond)
    return bodies


def _pond(ground: Floats, pond: Sequence[float]) -> Bodies:
    """Return the bodies of water of one pond, x of its shores and its level, over a ground (V, 2), in m.

    Each body is x of both shores, mean level and fall.
    """
    first, last, level = pond
    line = np.array([[first, level], [last, level]])
    bodies = []
    for body in _below(ground, line):
        left, right, *_ = body
        if left < last and right > first:
            bodies.append(body)
    return bodies


def _below(ground: Floats, level: Floats) -> Bodies:
    """Return the bodies of water between a ground (V, 2) and a level (W, 2) above it, in m.

    Each is x of both shores, mean level and fall (highest minus lowest point of the level).
    """

    def depth(x: Floats) -> Floats:
        height = np.interp(x, *level.T)
        return height - np.interp(x, *ground.T)

    left, right = ground[[0, -1], 0]
    vertices = np.concatenate([ground[:, 0], level[:, 0]])
    inside = np.clip(vertices, left, right)
    x = np.unique(inside)
    x = np.union1d(x, _roots(depth, x))
    middle = (x[:-1] + x[1:]) / 2
    is_wet = depth(middle) > _ROUNDING * (right - left)
    changes = np.diff(is_wet, prepend=False, append=False)
    shores = np.flatnonzero(changes)
    bodies = []
    for first, last in shores.reshape(-1, 2).tolist():
        wet = x[first : last + 1]
        heights = np.interp(wet, *level.T)
        low = heights.min()
        high = heights.max()
        middle_height = (low + high) / 2
        most_depth = high - low
        bodies.append([x[first], x[last], middle_height, most_depth])
    return bodies


def _roots(linear: Callable[[Floats], Floats], x: Floats) -> Floats:
    """Return a root of a piecewise linear function in each interval, or an end of intervals without a root.

    Intervals lie between neighbouring elements of ``x``, which increases.
    """
    step = np.diff(x)
    quarter = step / 4
    early = linear(x[:-1] + quarter)  # inside intervals, away from vertical scarps
    late = linear(x[1:] - quarter)
    fall = early - late
    divisor = np.where(fall == 0.0, np.inf, 2 * fall)
    place = 0.25 + early / divisor
    share = np.clip(place, 0.0, 1.0)
    roots = x[:-1] + share * step
    return roots


# --- mistakes --------------------------------------------------------------------------------------------------------


def water_fault(grounds: Floats, levels: Floats | None, confined: bool, ponds: Given) -> Fault:
    """Return the error of levels beside the ground, sloping free water, and ponds that are dry or too short.

    The error is a mask of lanes and a function from the index of a lane to its message; arguments are as for
    `free_water`.
    """
    pairs = _pairs(grounds, levels)
    words = [_mistake(ground, level, confined, ponds) for ground, level in pairs]
    return np.array(words) != "", lambda k: words[k]


def _mistake(ground: Floats, level: Floats | None, confined: bool, ponds: Given) -> str:
    """Return the message about the water of one ground (V, 2), empty if it is valid.

    Arguments are as for `free_water`, with a single level.
    """
    left, right = ground[[0, -1], 0]
    if level is not None:
        first, last = level[[0, -1], 0]
        if last < left or first > right:
            return "{level}: lies beside the ground; it must extend over it"
    width, height = np.ptp(ground, axis=0)
    tolerance = max(_LEVEL * height, _ROUNDING * width)
    for first, last, _, fall in _bodies(ground, level, confined, ()):
        if fall > tolerance:
            where = f"from x = {first:.10g} to {last:.10g}, where it is above the ground"
            remedy = "give a horizontal level there, or {confined} = true for an artesian level without free water"
            return f"{{level}}: varies by {fall:.4g} m {where}; free water is horizontal: {remedy}"
    for number, pond in enumerate(ponds, 1):
        if mistake := _pond_mistake(ground, pond):
            return f"{{pond.{number}.level}}: {mistake}"
    bodies = sorted(_bodies(ground, level, confined, ponds))
    if any(one[1] > other[0] for one, other in pairwise(bodies)):
        return "{ponds}: lies in other free water; remove one of them"
    return ""


def _pond_mistake(ground: Floats, pond: Sequence[float]) -> str:
    """Return the message about one pond, x of its shores and its level, over a ground (V, 2); empty if it is valid."""
    first, last, _ = pond
    bodies = _pond(ground, pond)
    if not bodies:
        return f"the ground from x = {first:.10g} to {last:.10g} lies above it"
    left, *_ = bodies[0]
    _, right, *_ = bodies[-1]
    rounding = AS_PRINTED * (right - left)
    starts_inside = first > left + rounding
    ends_inside = last < right - rounding
    if starts_inside or ends_inside:
        return f"water at this level reaches from x = {left:.8g} to {right:.8g}; extend the pond to both shores"
    return ""


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
