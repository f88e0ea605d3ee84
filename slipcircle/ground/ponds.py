"""Free water: where a water level lies above the ground, and ponds whose pore pressure is given otherwise."""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from slipcircle.base.checks import Fault
from slipcircle.base.kinds import Floats
from slipcircle.ground.ground import AS_PRINTED, continued
from slipcircle.ground.lines import edge_below, line_crossings
from slipcircle.ground.plane import each_lane

_LEVEL = 0.01  # of the height of the ground, by which free water may deviate from a horizontal level
_ROUNDING = 1e-9  # of the size of the ground
Given = Sequence[tuple[float, float, float]]  # ponds: x of both shores, and the level


class Ponds(NamedTuple):
    """Free water, (ponds, lanes) each, m; without width where a lane has less of it.

    Attributes
    ----------
    first, last : ndarray
        x of both shores.
    level : ndarray
        Middle between the highest and the lowest point of the level.
    fall : ndarray
        Difference between them.
    """

    first: Floats
    last: Floats
    level: Floats
    fall: Floats

    @property
    def of_one(self) -> list[list[float]]:
        """x of both shores and level of each water on the ground of one lane, from left to right."""
        rows = np.stack(self[:3])[..., 0].T.tolist()
        return sorted(row for row in rows if row[1] > row[0])

    def covering(self, x: Floats, y: Floats) -> Floats:
        """Level of the water above points (lanes,); -inf where a point is dry."""
        rounding = _ROUNDING * (self.last - self.first)
        after_first = x >= self.first - rounding
        before_last = x <= self.last + rounding
        levels = np.where(after_first & before_last & (y < self.level), self.level, -np.inf)
        return levels.max(axis=0, initial=-np.inf)


_NONE = Ponds(*np.empty((4, 0, 1)))


def free_water(grounds: Floats, levels: Floats | None, confined: bool, ponds: Given) -> Ponds:
    """Free water over grounds (n or 1, V, 2): below levels (n or 1, W, 2) unless they are confined, and ponds."""
    bodies = [_NONE, *(_pond(grounds, pond) for pond in ponds)]
    if levels is not None and not confined:
        bodies.append(_water(grounds, levels))
    lanes = max(body.first.shape[1] for body in bodies)
    rows = [np.broadcast_to(body, (4, len(body.first), lanes)) for body in bodies]
    return Ponds(*np.concatenate(rows, axis=1))


def _pond(grounds: Floats, pond: tuple[float, float, float]) -> Ponds:
    """The water of a pond, from shore to shore."""
    first, last, level = pond
    line = np.array([[[first, level], [last, level]]])
    water = _water(grounds, line)
    is_meant = np.minimum(water.last, last) > np.maximum(water.first, first)
    return water._replace(last=np.where(is_meant, water.last, water.first))


def _water(grounds: Floats, levels: Floats) -> Ponds:
    """Water below levels: intervals between vertices and crossings of both lines where the level is higher."""
    lanes = max(len(grounds), len(levels))
    ground = each_lane(grounds, lanes)
    first_x, last_x = ground[:, 0, :1], ground[:, -1, :1]
    level = continued(each_lane(levels, lanes), first_x[:, 0], last_x[:, 0])
    cuts = [ground[..., 0], level[..., 0], line_crossings(ground, level)]
    x = np.sort(np.clip(np.concatenate(cuts, axis=1), first_x, last_x), axis=1)
    left, right = x[:, :-1], x[:, 1:]
    middle = (left + right) / 2
    depth = edge_below(level, middle, middle)[0] - edge_below(ground, middle, middle)[0]
    is_wet = depth > _ROUNDING * size_of(grounds)[:, None]
    begins = np.diff(is_wet, axis=1, prepend=False) & is_wet
    number = np.cumsum(begins, axis=1) * is_wet
    heights = np.stack([edge_below(level, side, middle)[0] for side in (left, right)])
    bodies = []
    for k in range(1, int(number.max(initial=0)) + 1):
        mine = number == k
        first, lowest = (np.where(mine, low, np.inf).min(axis=1) for low in (left, heights.min(axis=0)))
        last, highest = (np.where(mine, high, -np.inf).max(axis=1) for high in (right, heights.max(axis=0)))
        nothing = [ground[:, 0, 0] - 1.0, ground[:, 0, 0] - 1.0, ground[:, 0, 1], np.zeros(lanes)]
        with np.errstate(invalid="ignore"):
            body = [first, last, (highest + lowest) / 2, highest - lowest]
        bodies.append(np.where(mine.any(axis=1), body, nothing))
    return Ponds(*np.stack(bodies, axis=1)) if bodies else _NONE


def size_of(grounds: Floats) -> Floats:
    """Greater one of width and height of grounds (n, V, 2), (n,)."""
    return np.ptp(grounds, axis=1).max(axis=1)


# --- mistakes --------------------------------------------------------------------------------------------------------


def water_faults(grounds: Floats, levels: Floats | None, confined: bool, ponds: Given) -> Iterator[Fault]:
    """Levels beside the ground, free water that slopes, and ponds on dry land or that end before their shores."""
    height = _LEVEL * np.ptp(grounds[..., 1], axis=1)
    tolerance = np.maximum(height, _ROUNDING * size_of(grounds))
    if levels is not None:
        beside = (levels[:, -1, 0] < grounds[:, 0, 0]) | (levels[:, 0, 0] > grounds[:, -1, 0])
        yield beside, lambda _: "{level}: lies beside the ground; it must extend over it"
    for first, last, _, fall in zip(*free_water(grounds, levels, confined, ()), strict=True):
        yield fall > tolerance, partial(_sloping, first, last, fall)
    for k, pond in enumerate(ponds, 1):
        water = _pond(grounds, pond)
        exists = water.last > water.first
        yield ~exists.any(axis=0), partial(_dry, k, pond)
        first = np.where(exists, water.first, np.inf).min(axis=0)
        last = np.where(exists, water.last, -np.inf).max(axis=0)
        rounding = AS_PRINTED * (last - first)
        yield (first < pond[0] - rounding) | (last > pond[1] + rounding), partial(_short, k, pond, first, last)
    every = free_water(grounds, levels, confined, ponds)
    shores = np.where(every.last > every.first, every[:2], np.inf)
    first, last = np.take_along_axis(shores, np.argsort(shores[:1], axis=1), axis=1)
    yield np.any(last[:-1] > first[1:], axis=0), lambda _: "{ponds}: lies in other free water; remove one of them"


def _sloping(first: Floats, last: Floats, fall: Floats, k: int) -> str:
    where = f"from x = {first[k]:.10g} to {last[k]:.10g}, where it is above the ground"
    remedy = "give a horizontal level there, or {confined} = true for an artesian level without free water"
    return f"{{level}}: varies by {fall[k]:.4g} m {where}; free water is horizontal: {remedy}"


def _dry(number: int, pond: Sequence[float], k: int) -> str:
    first, last, level = pond
    return f"{{pond.{number}.level}} = {level:.10g}: the ground from x = {first:.10g} to {last:.10g} lies above it"


def _short(number: int, pond: Sequence[float], first: Floats, last: Floats, k: int) -> str:
    shores = f"water at this level reaches from x = {first[k]:.8g} to {last[k]:.8g}"
    return f"{{pond.{number}.level}} = {pond[2]:.10g}: {shores}; extend the pond to both shores"


def ends_above(levels: Floats, left: Floats, right: Floats) -> Fault:
    """Levels (n or 1, W, 2) that end above masses from one x to another, (n,)."""
    ends = levels[:, [0, -1], 0].T
    rounding = _ROUNDING * (right - left)
    inside = (ends > left + rounding) & (ends < right - rounding)

    def sentence(k: int) -> str:
        x = ends[:, k % len(levels)][inside[:, k]][0]
        mass = f"the mass from x = {left[k]:.6g} to {right[k]:.6g}"
        return f"{{level}}: ends at x = {x:.10g}, above {mass}; extend it beyond the mass"

    return inside.any(axis=0), sentence
