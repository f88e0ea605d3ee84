"""Factors of safety of many slip circles at once, by the balance of thin slices above the arc.

Sums over slices are integrals along the arc of the integrands in `generated.slopes`, by Gauss' rule between the kinks
of ground and water, so factors are converged values and not those of a number of slices. Strength and loads are arrays
along the arc: what changes from one stretch of it to the next needs a kink there and nothing else.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes

Floats = NDArray[np.float64]
METHOD_NAMES = ("paper", "ordinary", "bishop")
LEAST_LEVER = 0.05  # of m_alpha: below, Bishop's normal stress is meaningless
_LEAST_FACTOR = 5e-3
_NEWTON_STEPS = 20
_CLOSE = 1e-9  # Bishop's: smallest factor, iterations, relative change
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)


class SlopeArrays(NamedTuple):
    """The fields of `Slope` for one slope or for n of them: lines (1 or n, V, 2), all other numbers () or (n,)."""

    ground: Floats
    level: Floats | None
    cohesion: Any
    friction: Any
    unit_weight: Any
    water_unit_weight: Any = 9810.0
    pore_ratio: Any = 0.0
    pressure: Any = 0.0
    k_h: Any = 0.0


class _Arcs(NamedTuple):
    """Arcs by their circles and the angles of their ends from straight below the centre."""

    centre: Floats
    radius: Floats
    first: Floats
    last: Floats
    valid: NDArray[np.bool_]  # not overhanging, with a centre above the ground


class _Slices(NamedTuple):
    """Slices above the points of Gauss' rule, (points, intervals); lengths over R, stresses over gamma R.

    An interval is the part of one arc between two kinks. Angles are from straight below the centre.
    """

    arcs: int  # how many
    arc: NDArray[np.int64]  # number of the arc of each interval
    end_sines: Floats  # of both ends of each interval, (2, intervals)
    end_cosines: Floats
    weight: Floats  # of a point in the integral over the angle
    sine: Floats
    cosine: Floats
    top: Floats  # of the ground above the centre
    height: Floats  # of the slice
    pressure: Floats
    cohesion: Floats  # of each interval, as the next two
    friction: Floats
    k_h: Floats

    def integral(self, values: Floats) -> Floats:
        """Over each arc."""
        by_interval = (self.weight * values).sum(axis=0)
        return np.bincount(self.arc, by_interval, self.arcs).astype(np.float64)

    def facing(self, way: Floats) -> _Slices:
        """The same with positive angles down-slope, for arcs that slide to the right (1) or to the left (-1)."""
        sign = way[self.arc]
        return self._replace(sine=self.sine * sign, end_sines=self.end_sines * sign)


def circle_factors(
    slope: SlopeArrays,
    centre: Floats,
    radius: Floats,
    left: Floats,
    right: Floats,
    methods: Collection[str] = METHOD_NAMES,
    pieces: int = 1,
) -> dict[str, Floats]:
    """Factors of safety of the masses between circles and the ground, from one point of the ground to another.

    Parameters
    ----------
    slope : SlopeArrays
        One slope, or one for each circle.
    centre, radius : ndarray
        Of circles, (n, 2) and (n,), m.
    left, right : ndarray
        Ends of the arcs, (n, 2), m, between which the ground lies inside the circle.
    methods : collection of str
        Of ``METHOD_NAMES``; factors by the others are NaN.
    pieces : int
        Into which each arc is cut besides at kinks, to resolve ``negative``.

    Returns
    -------
    dict of ndarray
        Factors by method, NaN where it refuses the circle. ``facing``: 1 where the mass slides to the right, -1 to the
        left, 0 where nothing drives it. ``negative``: share of the arc under negative effective normal stress, by the
        ordinary method or by Bishop's, if greater.

    Notes
    -----
    Water: the ordinary method takes N' = W cos(a) - u l, which reproduces published factors (Fredlund and Krahn 1977);
    its other convention, (W - u b) cos(a), gives greater ones. Bishop's method refuses a circle where m_alpha falls
    below 0.05; all methods refuse one that overhangs at an end, or whose centre lies below the ground.
    """
    arcs = _arcs(slope.ground, centre, radius, left, right)
    slices = _slices(slope, arcs, pieces)
    length = np.where(arcs.valid, arcs.last - arcs.first, np.nan)
    facing, driving = _driving(slices)
    slices = slices.facing(facing)

    normal = slopes.ordinary_normal(slices.sine, slices.cosine, slices.height, slices.pressure, slices.k_h)
    ordinary = slices.integral(slices.cohesion + slices.friction * normal) / driving
    negative = slices.integral(normal < 0.0) / length
    paper = bishop = np.full(len(radius), np.nan)
    if "paper" in methods:
        paper = _paper_resistance(slices) / driving
    if "bishop" in methods:
        bishop = _bishop(slices, driving, ordinary)
        negative = np.maximum(negative, slices.integral(_bishop_normal(slices, bishop) < 0.0) / length)
    return {"paper": paper, "ordinary": ordinary, "bishop": bishop, "facing": facing, "negative": negative}


def _arcs(ground: Floats, centre: Floats, radius: Floats, left: Floats, right: Floats) -> _Arcs:
    first, last = (np.arctan2(p[:, 0] - centre[:, 0], centre[:, 1] - p[:, 1]) for p in (left, right))
    upright = (first >= -np.pi / 2) & (last <= np.pi / 2) & (first < last)
    beside = (first > 0.0) | (last < 0.0)
    above_ground = _height_at(ground, centre[:, 0]) < centre[:, 1]
    return _Arcs(centre, radius, first, last, upright & (beside | above_ground))


def _driving(slices: _Slices) -> tuple[Floats, Floats]:
    """Which way gravity turns each mass, and the driving moment that way; NaN where there is none."""
    by_gravity = slices.integral(slopes.drive(slices.sine, slices.cosine, slices.height, 0.0))
    negligible = 1e-9 * slices.integral(slices.cosine * slices.height)
    facing = np.where(np.abs(by_gravity) > negligible, np.sign(by_gravity), 0.0)
    down_slope = slices.facing(facing)
    driving = slices.integral(slopes.drive(down_slope.sine, slices.cosine, slices.height, slices.k_h))
    return facing, np.where((facing != 0.0) & (driving > negligible), driving, np.nan)


def _slices(slope: SlopeArrays, arcs: _Arcs, pieces: int) -> _Slices:
    """Cut valid arcs at the kinks of ground and water, and lay slices above the points of each interval."""
    arc, low, high = _intervals(slope, arcs, pieces)
    half = (high - low) / 2
    middle = (low + high) / 2
    angle = middle + half * _NODES[:, None]  # points first: sums over them are sums of rows
    sine = np.sin(angle)
    cosine = np.cos(angle)

    def of_interval(value: Any) -> Floats:
        return np.broadcast_to(np.asarray(value, dtype=np.float64), len(arcs.radius))[arc]

    stress_scale = of_interval(slope.unit_weight) * arcs.radius[arc]
    top = _above_centre(slope.ground, arcs, arc, middle, sine)
    height = np.maximum(top + cosine, 0.0)
    pressure = of_interval(slope.pore_ratio) * height + of_interval(slope.pressure) / stress_scale
    if slope.level is not None:
        depth = np.maximum(_above_centre(slope.level, arcs, arc, middle, sine) + cosine, 0.0)
        pressure += of_interval(slope.water_unit_weight) / of_interval(slope.unit_weight) * depth
    return _Slices(
        arcs=len(arcs.radius),
        arc=arc,
        end_sines=np.sin([low, high]),
        end_cosines=np.cos([low, high]),
        weight=half * _WEIGHTS[:, None],
        sine=sine,
        cosine=cosine,
        top=top,
        height=height,
        pressure=pressure,
        cohesion=of_interval(slope.cohesion) / stress_scale,
        friction=of_interval(slope.friction),
        k_h=of_interval(slope.k_h),
    )


def _above_centre(lines: Floats, arcs: _Arcs, arc: NDArray[np.int64], middle: Floats, sine: Floats) -> Floats:
    """Height of lines above the centres of arcs at points of their intervals, over R."""
    x, y = arcs.centre[arc].T
    scale = arcs.radius[arc]
    edge_x, edge_y, gradient = _edges(lines, arc, x + scale * np.sin(middle))
    at_centre = (edge_y - y + gradient * (x - edge_x)) / scale
    return at_centre + gradient * sine


def _intervals(slope: SlopeArrays, arcs: _Arcs, pieces: int) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Arc, first and last angle of each part of a valid arc between two kinks."""
    circle = arcs.centre, arcs.radius
    kinks = [np.linspace(arcs.first, arcs.last, pieces + 1, axis=1), _vertex_angles(slope.ground[:, 1:-1], *circle)]
    if slope.level is not None:
        kinks += [_vertex_angles(slope.level, *circle), _crossing_angles(slope.level, *circle)]
    on_arc = np.clip(np.concatenate(kinks, axis=1), arcs.first[:, None], arcs.last[:, None])
    angles = np.sort(on_arc, axis=1)
    apart = np.diff(angles, axis=1) > 0.0
    arc, k = np.nonzero(apart & arcs.valid[:, None])
    return arc, angles[arc, k], angles[arc, k + 1]


def _vertex_angles(lines: Floats, centre: Floats, radius: Floats) -> Floats:
    """Angles of the arcs' points below or above vertices of lines (1 or n, V, 2)."""
    return np.arcsin(np.clip((lines[..., 0] - centre[:, :1]) / radius[:, None], -1.0, 1.0))


def _crossing_angles(lines: Floats, centre: Floats, radius: Floats) -> Floats:
    """Angles at which lines cross arcs, NaN for edges that do not.

    An edge's height above the arc, c + s sin(beta) + cos(beta), is 0 at beta = atan(s) +- acos(-c/sqrt(1 + s^2)).
    """
    lines = _extended(lines)
    x, y = ((lines[..., k] - centre[:, k, None]) / radius[:, None] for k in (0, 1))
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.diff(y, axis=1) / np.diff(x, axis=1)
        middle = np.arctan(slope)
        half = np.arccos((slope * x[:, :-1] - y[:, :-1]) / np.hypot(1.0, slope))
        angles = np.concatenate([middle - half, middle + half], axis=1)
        sine = np.sin(angles)
    on_edge = (sine >= np.tile(x[:, :-1], 2)) & (sine <= np.tile(x[:, 1:], 2))
    return np.where(on_edge, angles, np.nan)


def _extended(lines: Floats) -> Floats:
    """Lines that go on horizontally beyond both ends."""
    far = 1e12 * np.array([[-1.0, 0.0], [1.0, 0.0]])
    return np.concatenate([lines[:, :1] + far[:1], lines, lines[:, -1:] + far[1:]], axis=1)


def _edges(lines: Floats, line: Any, x: Floats) -> tuple[Floats, Floats, Floats]:
    """Of the edge of a line (1 or n, V, 2) at each x: a point, x and y, and its gradient, 0 beyond the line's ends."""
    vertices = lines.shape[1]
    if len(lines) == 1:
        passed = np.searchsorted(lines[0, :, 0], x)
        line = np.zeros(1, dtype=np.int64)
    else:
        passed = np.count_nonzero(lines[line, :, 0] < x[:, None], axis=1)
    left = np.clip(passed - 1, 0, vertices - 1)
    run, rise = np.moveaxis(np.diff(lines, axis=1, append=lines[:, -1:]), -1, 0)
    gradient = np.divide(rise, run, out=np.zeros(run.shape), where=run > 0.0)
    return lines[line, left, 0], lines[line, left, 1], np.where(passed > 0, gradient[line, left], 0.0)


def _height_at(lines: Floats, x: Floats) -> Floats:
    """Of lines, one for all or one for each x."""
    at, y, gradient = _edges(lines, np.arange(len(x)), x)
    return y + gradient * (x - at)


def _paper_resistance(slices: _Slices) -> Floats:
    """Of the paper's method: every point of the mass gives its weight times the cosine of its direction (2.23)."""
    distance = np.hypot(slices.sine, slices.top)
    tilt = slopes.radial_tilt(slices.sine, slices.cosine, slices.height, distance) if np.any(slices.k_h) else 0.0
    normal = slopes.radial_weight(slices.cosine, distance) + slices.k_h * tilt - slices.pressure
    friction = np.maximum(slices.integral(slices.friction * normal), 0.0)
    return np.asarray(slices.integral(slices.cohesion) + friction)


def _bishop_normal(slices: _Slices, factor: Floats) -> Any:
    """Effective normal stress at given factors of the arcs."""
    of_arc = factor[slices.arc]
    return slopes.bishop_normal(
        slices.sine, slices.cosine, slices.height, slices.pressure, slices.cohesion, slices.friction, of_arc
    )


def _bishop(slices: _Slices, driving: Floats, start: Floats) -> Floats:
    """F = 1/y where y times the integral of strength/m_alpha(y) is the driving moment; the former grows with y.

    By Newton's steps for all arcs at once, within the range of y in which m_alpha = cos - y mu sin is at least
    ``LEAST_LEVER`` at all ends of intervals, between which it has no minimum.
    """
    arc = slices.arc
    friction = slices.friction
    lowest, highest = _lever_range(slices)
    strength = slopes.bishop_strength(slices.cosine, slices.height, slices.pressure, slices.cohesion, friction)
    with np.errstate(divide="ignore", invalid="ignore"):
        y = np.clip(1.0 / np.maximum(start, _LEAST_FACTOR), lowest, highest)
        y = np.where(lowest < highest, y, np.nan)
        for _ in range(_NEWTON_STEPS):
            factor = 1.0 / y
            lever = slopes.bishop_lever(slices.sine, slices.cosine, friction, factor[arc])
            shear = strength / lever
            excess = y * slices.integral(shear) - driving
            growth = slices.integral(shear * slices.cosine / lever)  # d(y/m_alpha)/dy = cos/m_alpha^2
            y = np.clip(y - excess / growth, lowest, highest)
            if not np.any(np.abs(y * factor - 1.0) > _CLOSE):
                break
        return np.where(np.abs(excess) <= _CLOSE * driving, factor, np.nan)


def _lever_range(slices: _Slices) -> tuple[Floats, Floats]:
    """Least and greatest 1/F for which m_alpha stays above its least value, of each arc."""
    most = 1.0 / _LEAST_FACTOR
    sine = slices.friction * slices.end_sines
    room = slices.end_cosines - LEAST_LEVER
    with np.errstate(divide="ignore", invalid="ignore"):
        above = np.where(sine > 0.0, np.maximum(room, 0.0) / sine, most)
        below = np.where((sine < 0.0) & (room < 0.0), room / sine, 0.0)
    lowest = np.zeros(slices.arcs)
    highest = np.full(slices.arcs, most)
    for k in (0, 1):
        np.minimum.at(highest, slices.arc, above[k])
        np.maximum.at(lowest, slices.arc, below[k])
    return lowest, highest
