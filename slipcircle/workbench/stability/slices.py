"""Factors of safety of many slip circles at once, by the balance of thin slices above the arc.

Sums over slices are integrals along the arc of the integrands in `generated.slopes`, by Gauss' rule between the kinks
of ground and water, so factors are converged values and not those of a number of slices. Strength and loads are arrays
along the arc: what changes from one stretch of it to the next needs a kink there and nothing else.
"""

from __future__ import annotations

from collections.abc import Collection
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes

Floats = NDArray[np.float64]
METHOD_NAMES = ("paper", "ordinary", "bishop")
LEAST_LEVER = 0.05  # of m_alpha: below, Bishop's normal stress is meaningless
_TOUCH = 1e-12  # over R: as near to the arc, a boundary touches it
_LEAST_FACTOR = 5e-3  # by Bishop's method
_NEWTON_STEPS = 20
_CLOSE = 1e-9  # relative change of a converged factor
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)


class SoilArrays(NamedTuple):
    """Numbers of the soil of a layer, for one slope or for n of them, () or (n,)."""

    cohesion: Any
    friction: Any
    unit_weight: Any
    pore_ratio: Any = 0.0
    saturated_unit_weight: Any = None
    cohesion_gradient: Any = 0.0
    datum: Any = None


class SlopeArrays(NamedTuple):
    """One slope, or n of them: lines (1 or n, V, 2), numbers () or (n,)."""

    ground: Floats
    soils: tuple[SoilArrays, ...]  # of the layers from the ground down
    tops: tuple[Floats, ...] = ()  # of each layer but the first, whose top is the ground
    level: Floats | None = None
    water_unit_weight: Any = 9810.0
    pressure: Any = 0.0
    k_h: Any = 0.0
    pond: Any = None
    surcharge: Any = ()  # from x1 to x2, q1 and q2
    crack: Any = 0.0
    crack_water: Any = 0.0

    def only(self, lanes: Any) -> SlopeArrays:
        """Some of n slopes."""

        def some(value: Any) -> Any:
            if isinstance(value, SoilArrays):
                return SoilArrays(*map(some, value))
            if isinstance(value, tuple):
                return tuple(map(some, value))
            return value[lanes] if isinstance(value, np.ndarray) and value.ndim and len(value) > 1 else value

        return SlopeArrays(*map(some, self))

    def lines(self) -> list[Floats]:
        """All of them: tops of layers, water level, pond."""
        found = [self.ground, *self.tops] + ([] if self.level is None else [self.level])
        if self.pond is not None:
            height = np.reshape(self.pond, (-1, 1))
            x = np.broadcast_to(self.ground[:, [0, -1], 0], (max(len(height), len(self.ground)), 2))
            found.append(np.stack(np.broadcast_arrays(x, height), axis=-1))
        return found


class _Slices(NamedTuple):
    """Slices above the points of Gauss' rule, (points, intervals); lengths over R, stresses over gamma R.

    gamma is the unit weight of the first layer. An interval is the part of one arc between two kinks. Angles are from
    straight below the centre. Weights are sums over surfaces: the tops of layers, each with the step of the unit weight
    there, and of their saturated parts; and the part of the ground below a pond, with minus the water's.
    """

    arcs: int  # how many
    arc: NDArray[np.int64]  # number of the arc of each interval
    ends: Floats  # sines and cosines of both ends of each interval, (2, 2, intervals)
    weight: Floats  # of a point in the integral over the angle
    sine: Floats
    cosine: Floats
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

    def sum_of_surfaces(self, values: Any) -> Floats:
        """Of values for each surface."""
        return np.einsum("si,spi->pi", self.steps, values)

    def coefficients(self) -> Floats:
        """k_h of each surface, (surfaces, 1, intervals)."""
        return self.shaken[:, None, None] * self.k_h

    def driving_moment(self, k_h: Any) -> Floats:
        """About the centre, over each point's angle."""
        by_surface = slopes.drive(self.sine, self.cosine, self.tops + self.cosine, k_h)
        return self.sum_of_surfaces(by_surface) + slopes.drive(self.sine, self.cosine, self.load, 0.0)

    def ordinary_normal(self) -> Floats:
        """Effective normal stress of the ordinary method."""
        by_surface = slopes.ordinary_normal(self.sine, self.cosine, self.tops + self.cosine, 0.0, self.coefficients())
        return self.sum_of_surfaces(by_surface) + self.load * self.cosine**2 - self.uplift

    def radial_normal(self) -> Floats:
        """Effective normal stress of the paper's method by strips: the weights of (2.23) straight above."""
        distance = np.hypot(self.sine, self.tops)
        by_surface = slopes.radial_weight(self.cosine, distance)
        if np.any(self.k_h):
            tilt = slopes.radial_tilt(self.sine, self.cosine, self.tops + self.cosine, distance)
            by_surface = by_surface + self.coefficients() * tilt
        on_ground = self.load * self.cosine * -self.ground / np.hypot(self.sine, self.ground)
        return self.sum_of_surfaces(by_surface) + on_ground - self.uplift

    def integral(self, values: Any) -> Floats:
        """Over each arc."""
        by_interval = (self.weight * values).sum(axis=0)
        return np.bincount(self.arc, by_interval, self.arcs).astype(np.float64)

    def facing(self, way: Floats) -> _Slices:
        """The same with positive angles down-slope, for arcs that slide to the right (1) or to the left (-1)."""
        sign = way[self.arc]
        return self._replace(sine=self.sine * sign, ends=self.ends * np.array([sign, np.ones_like(sign)])[:, None])


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
    first, last = (np.arctan2(p[:, 0] - centre[:, 0], centre[:, 1] - p[:, 1]) for p in (left, right))
    valid = (first >= -np.pi / 2) & (last <= np.pi / 2) & (first < last)
    below = (first < 0.0) & (last > 0.0) & (_height_at(slope.ground, centre[:, 0]) >= centre[:, 1])
    valid &= ~below
    slices = _slices(slope, centre, radius, first, last, valid, pieces)
    facing, negligible = _facing(slices)
    if np.any(slope.crack):
        first, last, valid = _cracked(slope, centre, radius, first, last, facing, valid)
        slices = _slices(slope, centre, radius, first, last, valid, pieces)
    arc_angle = np.where(valid, last - first, np.nan)
    slices = slices.facing(facing)
    driving = slices.integral(slices.driving_moment(slices.coefficients()))
    driving += _crack_water(slope, centre, radius, np.where(facing > 0.0, first, last))
    driving = np.where(valid & (facing != 0.0) & (driving > negligible), driving, np.nan)

    normal = slices.ordinary_normal()
    ordinary = slices.integral(slices.cohesion + slices.friction * normal) / driving
    negative = slices.integral(normal < 0.0) / arc_angle
    paper = bishop = np.full(len(radius), np.nan)
    if "paper" in methods:
        friction = np.maximum(slices.integral(slices.friction * slices.radial_normal()), 0.0)
        paper = (slices.integral(slices.cohesion) + friction) / driving
    if "bishop" in methods:
        bishop = _bishop(slices, driving, ordinary)
        by_arc = bishop[slices.arc]
        normal = slopes.bishop_normal(
            slices.sine, slices.cosine, slices.vertical, slices.pressure, slices.cohesion, slices.friction, by_arc
        )
        negative = np.maximum(negative, slices.integral(normal < 0.0) / arc_angle)
    return {"paper": paper, "ordinary": ordinary, "bishop": bishop, "facing": facing, "negative": negative}


def _facing(slices: _Slices) -> tuple[Floats, Floats]:
    """Which way gravity drives each arc, 0 where it does not, and the moment that is as good as none."""
    by_gravity = slices.integral(slices.driving_moment(0.0))
    negligible = 1e-9 * slices.integral(slices.cosine * slices.vertical)
    return np.where(np.abs(by_gravity) > negligible, np.sign(by_gravity), 0.0), negligible


def _cracked(
    slope: SlopeArrays, centre: Floats, radius: Floats, first: Floats, last: Floats, facing: Floats, valid: Any
) -> tuple[Floats, Floats, Any]:
    """Arcs that begin at the bottom of a tension crack: where the ground is its depth above them."""
    lowered = slope.ground - np.stack(np.broadcast_arrays(0.0, np.reshape(slope.crack, (-1, 1))), axis=-1)
    angles = _crossing_angles(lowered, centre, radius)
    between = (angles > first[:, None]) & (angles < last[:, None])
    from_left = np.where(between, angles, np.inf).min(axis=1)
    from_right = np.where(between, angles, -np.inf).max(axis=1)
    first = np.where(facing > 0.0, from_left, first)
    last = np.where(facing < 0.0, from_right, last)
    deep_enough = np.isfinite(first) & np.isfinite(last) & (first < last)
    return np.where(deep_enough, first, 0.0), np.where(deep_enough, last, 0.0), valid & deep_enough


def _crack_water(slope: SlopeArrays, centre: Floats, radius: Floats, bottom: Floats) -> Any:
    """Moment of the water in a crack above the upper end of the arc: gamma_w h^2/2 at a third of its height."""
    depth = slope.crack_water / radius
    force = np.divide(slope.water_unit_weight, slope.soils[0].unit_weight) * depth**2 / 2
    return force * (np.cos(bottom) - depth / 3)


def _kinks(slope: SlopeArrays, centre: Floats, radius: Floats) -> list[Floats]:
    """Angles at which an integrand may not be smooth, (n, any) each: vertices and crossings of lines and arcs."""
    lines = slope.lines()
    kinks = [_vertex_angles(line, centre, radius) for line in lines]
    kinks += [_crossing_angles(line, centre, radius) for line in lines[1:]]
    x = [_crossings(one, other) for one, other in combinations(lines, 2)]
    x += [np.array([[x1, x2]]) for x1, x2, _, _ in slope.surcharge]
    kinks += [np.arcsin(np.clip((at - centre[:, :1]) / radius[:, None], -1.0, 1.0)) for at in x]
    for soil in slope.soils:
        if np.any(soil.cohesion_gradient):
            reach = np.arccos(np.clip((centre[:, 1] - soil.datum) / radius, -1.0, 1.0))[:, None]
            kinks += [reach, -reach]
    return kinks


def _crossings(one: Floats, other: Floats) -> Floats:
    """x where two lines (1 or n, V, 2), which go on horizontally, cross each other, (1 or n, any); NaN for none."""
    one, other = _extended(one), _extended(other)
    (p, u), (q, v) = ((line[:, :-1], np.diff(line, axis=1)) for line in (one, other))
    p, u, q, v = p[:, :, None], u[:, :, None], q[:, None], v[:, None]
    across, apart = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0], q - p
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (apart[..., 0] * v[..., 1] - apart[..., 1] * v[..., 0]) / across
        t = (apart[..., 0] * u[..., 1] - apart[..., 1] * u[..., 0]) / across
        x = np.where((s > 0.0) & (s < 1.0) & (t > 0.0) & (t < 1.0), p[..., 0] + s * u[..., 0], np.nan)
    return x.reshape(len(x), -1)


def _slices(
    slope: SlopeArrays, centre: Floats, radius: Floats, first: Floats, last: Floats, valid: Any, pieces: int
) -> _Slices:
    """Cut valid arcs at all kinks, and lay slices above the points of each interval."""
    count = len(radius)
    kinks = [np.linspace(first, last, pieces + 1, axis=1), *_kinks(slope, centre, radius)]
    every = np.concatenate(kinks, axis=1)
    angles = np.sort(np.clip(every[:, ~np.all(np.isnan(every), axis=0)], first[:, None], last[:, None]), axis=1)
    arc, k = np.nonzero((np.diff(angles, axis=1) > 0.0) & valid[:, None])
    low = angles[arc, k]
    high = angles[arc, k + 1]
    half = (high - low) / 2
    middle = (low + high) / 2
    angle = middle + half * _NODES[:, None]  # points first: sums over them are sums of rows
    sine = np.sin(angle)
    cosine = np.cos(angle)
    scale = radius[arc]
    at_middle = centre[arc, 0] + scale * np.sin(middle)

    def above_centre(lines: Floats) -> Floats:
        """Height of a line above the centre at each point, over R."""
        x, y, gradient = _edges(lines, arc, at_middle)
        return (y - centre[arc, 1] + gradient * (centre[arc, 0] - x)) / scale + gradient * sine

    def of_interval(value: Any) -> Floats:
        return np.broadcast_to(np.asarray(value, dtype=np.float64), count)[arc]

    def of_soils(name: str) -> Floats:
        """A number of each layer, (layers, intervals)."""
        return np.stack([of_interval(getattr(soil, name)) for soil in slope.soils])

    unit_weight = of_soils("unit_weight")
    stress_scale = unit_weight[0] * scale
    water = of_interval(slope.water_unit_weight) / unit_weight[0]
    boundaries = np.minimum.accumulate([above_centre(line) for line in (slope.ground, *slope.tops)], axis=0)
    ground, tops = boundaries[0], np.maximum(boundaries, -cosine)
    steps, shaken = [np.diff(unit_weight / unit_weight[0], axis=0, prepend=0.0)], [1.0] * len(tops)
    surfaces = [tops]
    pressure = of_interval(slope.pressure) / stress_scale
    if slope.level is not None:
        level = above_centre(slope.level)
        head = np.maximum(level + cosine, 0.0)
        if any(soil.saturated_unit_weight is not None for soil in slope.soils):
            saturated = [
                s.unit_weight if s.saturated_unit_weight is None else s.saturated_unit_weight for s in slope.soils
            ]
            excess = np.stack([of_interval(value) for value in saturated]) - unit_weight
            steps.append(np.diff(excess / unit_weight[0], axis=0, prepend=0.0))
            surfaces.append(np.maximum(np.minimum(tops, level), -cosine))
            shaken += [1.0] * len(tops)
    of_soil = sum(np.einsum("si,spi->pi", d, top + cosine) for d, top in zip(steps, surfaces, strict=True))
    inner = len(_NODES) // 2  # at an end of the arc, rounding may leave no ground above it
    lowest = np.minimum(-cosine, ground)[inner] - _TOUCH
    base, interval = np.count_nonzero(boundaries[:, inner] >= lowest, axis=0) - 1, np.arange(len(arc))
    ratio = of_soils("pore_ratio")[base, interval]
    pressure = pressure + ratio * of_soil
    if slope.level is not None:
        pressure = pressure + np.where(ratio > 0.0, 0.0, water * head)
    load = _surcharge(slope, centre[arc, 0] + scale * sine, at_middle) / stress_scale
    vertical, uplift = of_soil + load, pressure
    if slope.pond is not None:
        pond = (of_interval(slope.pond) - centre[arc, 1]) / scale
        steps.append(-water[None])
        surfaces.append(np.maximum(np.minimum(ground, pond), -cosine)[None])
        shaken.append(0.0)
        vertical = vertical + water * np.maximum(pond - np.maximum(ground, -cosine), 0.0)
        uplift = pressure - water * np.maximum(pond + cosine, 0.0)
    cohesion = of_soils("cohesion")[base, interval] / stress_scale
    if any(np.any(soil.cohesion_gradient) for soil in slope.soils):
        datum = np.stack([of_interval(0.0 if s.datum is None else s.datum) for s in slope.soils])[base, interval]
        below_datum = np.maximum((datum - centre[arc, 1]) / scale + cosine, 0.0)
        cohesion = cohesion + of_soils("cohesion_gradient")[base, interval] / unit_weight[0] * below_datum
    return _Slices(
        arcs=count,
        arc=arc,
        ends=np.array([np.sin([low, high]), np.cos([low, high])]),
        weight=half * _WEIGHTS[:, None],
        sine=sine,
        cosine=cosine,
        steps=np.concatenate(steps),
        shaken=np.array(shaken),
        tops=np.concatenate(surfaces),
        load=load,
        ground=ground,
        vertical=vertical,
        pressure=pressure,
        uplift=uplift,
        cohesion=np.broadcast_to(cohesion, sine.shape),
        friction=of_soils("friction")[base, interval],
        k_h=of_interval(slope.k_h),
    )


def _surcharge(slope: SlopeArrays, x: Floats, middle: Floats) -> Floats:
    """Pressure of the surcharges above points, Pa."""
    total = np.zeros_like(x)
    for x1, x2, q1, q2 in slope.surcharge:
        inside = (middle > x1) & (middle < x2)
        total += np.where(inside, q1 + (q2 - q1) * (x - x1) / (x2 - x1), 0.0)
    return total


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


def _bishop(slices: _Slices, driving: Floats, start: Floats) -> Floats:
    """F = 1/y where y times the integral of strength/m_alpha(y) is the driving moment; the former grows with y.

    By Newton's steps for all arcs at once, within the range of y in which m_alpha = cos - y mu sin is at least
    ``LEAST_LEVER`` at all ends of intervals, between which it has no minimum.
    """
    arc = slices.arc
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
    sine, cosine = slices.ends
    most = 1.0 / _LEAST_FACTOR
    sine = slices.friction * sine
    room = cosine - LEAST_LEVER
    with np.errstate(divide="ignore", invalid="ignore"):
        above = np.where(sine > 0.0, np.maximum(room, 0.0) / sine, most)
        below = np.where((sine < 0.0) & (room < 0.0), room / sine, 0.0)
    lowest = np.zeros(slices.arcs)
    highest = np.full(slices.arcs, most)
    for k in (0, 1):
        np.minimum.at(highest, slices.arc, above[k])
        np.maximum.at(lowest, slices.arc, below[k])
    return lowest, highest
