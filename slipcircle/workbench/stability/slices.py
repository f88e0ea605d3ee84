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
from slipcircle.workbench.stability.arcs import MIDDLE, Points, SlopeArrays, crossing_angles, height_at, points_along

Floats = NDArray[np.float64]
METHOD_NAMES = ("paper", "ordinary", "bishop")
LEAST_LEVER = 0.05  # of m_alpha: below, Bishop's normal stress is meaningless
_TOUCH = 1e-12  # over R: as near to the arc, a boundary touches it
_LEAST_FACTOR = 5e-3  # by Bishop's method
_NEWTON_STEPS = 20
_CLOSE = 1e-9  # relative change of a converged factor


class _Slices(NamedTuple):
    """Slices above the points of Gauss' rule, (points, intervals); lengths over R, stresses over gamma R.

    gamma is the unit weight of the first layer. An interval is the part of one arc between two kinks. Angles are from
    straight below the centre. Weights are sums over surfaces: the tops of layers, each with the step of the unit weight
    there, and of their saturated parts; and the part of the ground below a pond, with minus the water's.
    """

    points: Points
    sine: Floats
    cosine: Floats
    end_sine: Floats  # of both ends of each interval, (2, intervals)
    steps: Floats  # of the unit weight below each surface, (surfaces, intervals)
    shaken: Floats  # 1 of a surface of soil, 0 of one of water
    tops: Floats  # of the surfaces above the centre, not below the arc, (surfaces, points, intervals)
    load: Floats  # surcharge
    ground: Floats  # above the centre
    vertical: Floats  # total vertical stress on the arc
    pressure: Floats
    uplift: Floats  # the pressure less that of a pond
    cohesion: Floats
    friction: Floats  # of each interval, as the next
    k_h: Floats
    k_h_on_load: Floats

    def sum_of_surfaces(self, values: Any) -> Floats:
        """Of values for each surface."""
        return np.einsum("si,spi->pi", self.steps, values)

    def coefficients(self) -> Floats:
        """k_h of each surface, (surfaces, 1, intervals)."""
        return self.shaken[:, None, None] * self.k_h

    def driving_moment(self, k_h: Any, k_h_on_load: Any) -> Floats:
        """About the centre, over each point's angle; k_h times a load acts at the ground."""
        by_surface = slopes.drive(self.sine, self.cosine, self.tops + self.cosine, k_h)
        of_load = slopes.drive(self.sine, self.cosine, self.load, 0.0)
        return self.sum_of_surfaces(by_surface) + of_load - k_h_on_load * self.load * self.cosine * self.ground

    def ordinary_normal(self) -> Floats:
        """Effective normal stress of the ordinary method."""
        by_surface = slopes.ordinary_normal(self.sine, self.cosine, self.tops + self.cosine, 0.0, self.coefficients())
        of_load = self.load * self.cosine * (self.cosine + self.k_h_on_load * self.sine)
        return self.sum_of_surfaces(by_surface) + of_load - self.uplift

    def radial_normal(self) -> Floats:
        """Effective normal stress of the paper's method by strips: the weights of (2.23) straight above."""
        distance = np.hypot(self.sine, self.tops)
        by_surface = slopes.radial_weight(self.cosine, distance)
        if np.any(self.k_h):
            tilt = slopes.radial_tilt(self.sine, self.cosine, self.tops + self.cosine, distance)
            by_surface = by_surface + self.coefficients() * tilt
        towards_arc = (self.k_h_on_load * self.sine - self.ground) / np.hypot(self.sine, self.ground)
        on_ground = self.load * self.cosine * towards_arc
        return self.sum_of_surfaces(by_surface) + on_ground - self.uplift

    def bishop_normal(self, factor: Floats) -> Floats:
        """Effective normal stress of Bishop's simplified method."""
        by_arc = factor[self.points.arc]
        return slopes.bishop_normal(
            self.sine, self.cosine, self.vertical, self.pressure, self.cohesion, self.friction, by_arc
        )

    def integral(self, values: Any) -> Floats:
        """Over each arc."""
        by_interval = (self.points.weight * values).sum(axis=0)
        return np.bincount(self.points.arc, by_interval, len(self.points.radius)).astype(np.float64)

    def facing(self, way: Floats) -> _Slices:
        """The same with positive angles down-slope, for arcs that slide to the right (1) or to the left (-1)."""
        sign = way[self.points.arc]
        return self._replace(sine=self.sine * sign, end_sine=self.end_sine * sign)


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
        Factors by method, NaN where it refuses the circle. ``facing``: 1 if the mass slides to the right, -1 if to the
        left, 0 if nothing drives it. ``negative``: share of the arc under negative effective normal stress, by the
        ordinary method or by Bishop's, if greater.

    Notes
    -----
    Water: the ordinary method takes N' = W cos(a) - u l, which reproduces published factors (Fredlund and Krahn 1977);
    its other convention, (W - u b) cos(a), gives greater ones. Bishop's method refuses a circle where m_alpha falls
    below 0.05; all methods refuse one that overhangs at an end, or whose centre lies below the ground.
    """
    first, last = (np.arctan2(p[:, 0] - centre[:, 0], centre[:, 1] - p[:, 1]) for p in (left, right))
    upright = (first >= -np.pi / 2) & (last <= np.pi / 2) & (first < last)
    valid = upright & ~_below_ground(slope, centre, first, last)
    slices = _slices(slope, points_along(slope, centre, radius, first, last, valid, pieces))
    facing, negligible = _facing(slices)
    if np.any(slope.crack):
        first, last, valid = _cracked(slope, centre, radius, first, last, facing, valid)
        slices = _slices(slope, points_along(slope, centre, radius, first, last, valid, pieces))
    slices = slices.facing(facing)
    driving = slices.integral(slices.driving_moment(slices.coefficients(), slices.k_h_on_load))
    driving += _crack_water(slope, radius, np.where(facing > 0.0, first, last))
    driving = np.where(valid & (facing != 0.0) & (driving > negligible), driving, np.nan)
    length = np.where(valid, last - first, np.nan)
    return {**_factors(slices, driving, length, methods), "facing": facing}


def _factors(slices: _Slices, driving: Floats, length: Floats, methods: Collection[str]) -> dict[str, Floats]:
    """Resistance over drive by the methods, NaN by others, and the share of the arcs under negative normal stress."""
    normal = slices.ordinary_normal()
    negative = slices.integral(normal < 0.0) / length
    ordinary = slices.integral(slices.cohesion + slices.friction * normal) / driving
    paper = bishop = np.full(len(driving), np.nan)
    if "paper" in methods:
        friction = slices.integral(slices.friction * slices.radial_normal())
        paper = (slices.integral(slices.cohesion) + np.maximum(friction, 0.0)) / driving
    if "bishop" in methods:
        bishop = _bishop(slices, driving, ordinary)
        normal = slices.bishop_normal(bishop)
        negative = np.maximum(negative, slices.integral(normal < 0.0) / length)
    return {"paper": paper, "ordinary": ordinary, "bishop": bishop, "negative": negative}


def _below_ground(slope: SlopeArrays, centre: Floats, first: Floats, last: Floats) -> Any:
    """Which arcs have the centre of their circle below the ground."""
    return (first < 0.0) & (last > 0.0) & (height_at(slope.ground, centre[:, 0]) >= centre[:, 1])


def _facing(slices: _Slices) -> tuple[Floats, Floats]:
    """Which way gravity drives each arc, 0 where it does not, and the moment that is as good as none."""
    by_gravity = slices.integral(slices.driving_moment(0.0, 0.0))
    negligible = 1e-9 * slices.integral(slices.cosine * slices.vertical)
    return np.where(np.abs(by_gravity) > negligible, np.sign(by_gravity), 0.0), negligible


def _cracked(
    slope: SlopeArrays, centre: Floats, radius: Floats, first: Floats, last: Floats, facing: Floats, valid: Any
) -> tuple[Floats, Floats, Any]:
    """Arcs that begin at the bottom of a tension crack: where the ground is its depth above them."""
    lowered = slope.ground - np.stack(np.broadcast_arrays(0.0, np.reshape(slope.crack, (-1, 1))), axis=-1)
    angles = crossing_angles(lowered, centre, radius)
    between = (angles > first[:, None]) & (angles < last[:, None])
    from_left = np.where(between, angles, np.inf).min(axis=1)
    from_right = np.where(between, angles, -np.inf).max(axis=1)
    first = np.where(facing > 0.0, from_left, first)
    last = np.where(facing < 0.0, from_right, last)
    deep_enough = np.isfinite(first) & np.isfinite(last) & (first < last)
    return np.where(deep_enough, first, 0.0), np.where(deep_enough, last, 0.0), valid & deep_enough


def _crack_water(slope: SlopeArrays, radius: Floats, bottom: Floats) -> Any:
    """Moment of the water in a crack above the upper end of the arc: gamma_w h^2/2 at a third of its height."""
    depth = slope.crack_water / radius
    force = np.divide(slope.water_unit_weight, slope.soils[0].unit_weight) * depth**2 / 2
    return force * (np.cos(bottom) - depth / 3)


class _Layers(NamedTuple):
    """Boundaries above points, and the layer at the base of each interval."""

    ground: Floats  # above the centre
    tops: Floats  # of the layers, not below the arc, (layers, points, intervals)
    base: NDArray[np.int64]

    def at_base(self, values: Floats) -> Floats:
        """Of numbers (layers, intervals) those of the base."""
        return values[self.base, np.arange(len(self.base))]


class _Water(NamedTuple):
    """What water adds to the surfaces and to the stresses on the arc, over gamma R."""

    steps: list[Floats]
    tops: list[Floats]
    vertical: Any  # weight of a pond
    relieved: Any  # pressure that a pond has at the arc's height


def _layers(slope: SlopeArrays, points: Points) -> _Layers:
    """Tops of layers, each cut off by those above it."""
    depth = np.cos(points.angle)
    lines = [points.above_centre(line) for line in (slope.ground, *slope.tops)]
    boundaries = np.minimum.accumulate(np.stack(lines), axis=0)
    ground = boundaries[0]
    # At an end of the arc rounding may leave no ground above it: then the layers that end there count.
    lowest = np.minimum(-depth, ground)[MIDDLE] - _TOUCH
    base = np.count_nonzero(boundaries[:, MIDDLE] >= lowest, axis=0) - 1
    return _Layers(ground, np.maximum(boundaries, -depth), base)


def _saturated(slope: SlopeArrays, points: Points, layers: _Layers, unit_weight: Floats) -> tuple[Floats, Floats]:
    """Steps of the unit weight below the water level, and the tops of the wet parts of layers; none without."""
    soils = slope.soils
    if slope.level is None or all(soil.saturated_unit_weight is None for soil in soils):
        return np.empty((0, unit_weight.shape[1])), np.empty((0, *points.angle.shape))
    given = [s.unit_weight if s.saturated_unit_weight is None else s.saturated_unit_weight for s in soils]
    excess = (points.of_layers(given) - unit_weight) / unit_weight[0]
    wet = np.minimum(layers.tops, points.above_centre(slope.level))
    return np.diff(excess, axis=0, prepend=0.0), np.maximum(wet, -np.cos(points.angle))


def _pond(slope: SlopeArrays, points: Points, layers: _Layers, water: Floats) -> _Water:
    """Standing water: minus its weight on the ground below its level, which is what makes it buoyant."""
    if slope.pond is None:
        return _Water([], [], 0.0, 0.0)
    depth = np.cos(points.angle)
    level = (points.of_interval(slope.pond) - points.centre[points.arc, 1]) / points.scale
    on_top = np.maximum(level - np.maximum(layers.ground, -depth), 0.0)
    buoyed = np.maximum(np.minimum(layers.ground, level), -depth)
    return _Water([-water[None]], [buoyed[None]], water * on_top, water * np.maximum(level + depth, 0.0))


def _pressure(slope: SlopeArrays, points: Points, layers: _Layers, overburden: Floats, water: Floats) -> Floats:
    """Pore pressure on the arc: of a soil with a ratio by the weight above, else of the level; and a constant."""
    ratio = layers.at_base(points.of_layers([soil.pore_ratio for soil in slope.soils]))
    pressure = ratio * overburden
    if slope.level is not None:
        head = np.maximum(points.above_centre(slope.level) + np.cos(points.angle), 0.0)
        pressure = pressure + np.where(ratio > 0.0, 0.0, water * head)
    return pressure + points.of_interval(slope.pressure) / _stress_scale(slope, points)


def _cohesion(slope: SlopeArrays, points: Points, layers: _Layers) -> Floats:
    """Cohesion at the base, which may grow with the depth below a datum."""
    soils = slope.soils
    cohesion = layers.at_base(points.of_layers([soil.cohesion for soil in soils])) / _stress_scale(slope, points)
    if any(np.any(soil.cohesion_gradient) for soil in soils):
        datum = layers.at_base(points.of_layers([0.0 if soil.datum is None else soil.datum for soil in soils]))
        growth = layers.at_base(points.of_layers([soil.cohesion_gradient for soil in soils]))
        below = np.maximum((datum - points.centre[points.arc, 1]) / points.scale + np.cos(points.angle), 0.0)
        cohesion = cohesion + growth / points.of_interval(soils[0].unit_weight) * below
    return np.broadcast_to(cohesion, points.angle.shape)


def _stress_scale(slope: SlopeArrays, points: Points) -> Floats:
    """gamma R of each interval, Pa, with the unit weight of the first layer."""
    return points.of_interval(slope.soils[0].unit_weight) * points.scale


def _slices(slope: SlopeArrays, points: Points) -> _Slices:
    """The slices above points."""
    sine = np.sin(points.angle)
    cosine = np.cos(points.angle)
    layers = _layers(slope, points)
    unit_weight = points.of_layers([soil.unit_weight for soil in slope.soils])
    water = points.of_interval(slope.water_unit_weight) / unit_weight[0]
    wet_steps, wet_tops = _saturated(slope, points, layers, unit_weight)
    steps = np.concatenate([np.diff(unit_weight / unit_weight[0], axis=0, prepend=0.0), wet_steps])
    tops = np.concatenate([layers.tops, wet_tops])
    overburden = np.einsum("si,spi->pi", steps, tops + cosine)
    pressure = _pressure(slope, points, layers, overburden, water)
    load = _surcharge(slope, points) / _stress_scale(slope, points)
    pond = _pond(slope, points, layers, water)
    return _Slices(
        points=points,
        sine=sine,
        cosine=cosine,
        end_sine=np.sin([points.low, points.high]),
        steps=np.concatenate([steps, *pond.steps]),
        shaken=np.array([1.0] * len(steps) + [0.0] * len(pond.steps)),
        tops=np.concatenate([tops, *pond.tops]),
        load=load,
        ground=layers.ground,
        vertical=overburden + load + pond.vertical,
        pressure=pressure,
        uplift=pressure - pond.relieved,
        cohesion=_cohesion(slope, points, layers),
        friction=layers.at_base(points.of_layers([soil.friction for soil in slope.soils])),
        k_h=points.of_interval(slope.k_h),
        k_h_on_load=points.of_interval(slope.k_h) * slope.k_h_on_surcharge,
    )


def _surcharge(slope: SlopeArrays, points: Points) -> Floats:
    """Pressure of the surcharges above points, Pa."""
    x = points.centre[points.arc, 0] + points.scale * np.sin(points.angle)
    total = np.zeros_like(x)
    for x1, x2, q1, q2 in slope.surcharge:
        inside = (points.middle > x1) & (points.middle < x2)
        total += np.where(inside, q1 + (q2 - q1) * (x - x1) / (x2 - x1), 0.0)
    return total


def _bishop(slices: _Slices, driving: Floats, start: Floats) -> Floats:
    """F = 1/y where y times the integral of strength/m_alpha(y) is the driving moment; the former grows with y.

    By Newton's steps for all arcs at once, within the range of y in which m_alpha = cos - y mu sin is at least
    ``LEAST_LEVER`` at all ends of intervals, between which it has no minimum.
    """
    arc = slices.points.arc
    friction = slices.friction
    lowest, highest = _lever_range(slices)
    strength = slopes.bishop_strength(slices.cosine, slices.vertical, slices.pressure, slices.cohesion, friction)
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
    sine = slices.end_sine
    cosine = np.cos([slices.points.low, slices.points.high])
    most = 1.0 / _LEAST_FACTOR
    sine = slices.friction * sine
    room = cosine - LEAST_LEVER
    with np.errstate(divide="ignore", invalid="ignore"):
        above = np.where(sine > 0.0, np.maximum(room, 0.0) / sine, most)
        below = np.where((sine < 0.0) & (room < 0.0), room / sine, 0.0)
    lowest = np.zeros(len(slices.points.radius))
    highest = np.full(len(slices.points.radius), most)
    for k in (0, 1):
        np.minimum.at(highest, slices.points.arc, above[k])
        np.maximum.at(lowest, slices.points.arc, below[k])
    return lowest, highest
