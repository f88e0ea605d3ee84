"""Slices above many arcs at once: their weights, loads, pore pressures and strengths, and integrals over the arcs.

Sums over slices are integrals along the arc, by Gauss' rule between its kinks: below vertices and crossings of lines,
where it crosses a line, and where cohesion begins to grow with depth. So factors are converged values and not those of
a number of slices. Between kinks every line is straight, so that each stress is linear in the sine and the cosine of
the angle: three numbers for each interval.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import slopes
from slipcircle.base.kinds import Floats
from slipcircle.ground import Ponds
from slipcircle.layers import meets_circle
from slipcircle.workbench.stability.columns import SlopeArrays, SoilArrays

NODES = 10  # of Gauss' rule in each interval
_INSIDE = 0.45  # of an interval, where its soil is looked up: not its middle, at which arcs touch level boundaries
_TOUCH = 1e-12  # over R: as near to the arc, a boundary touches it


class Arcs(NamedTuple):
    """Arcs of circles: centres (n, 2) and radii, m; angles of both ends from straight below the centre."""

    centre: Floats
    radius: Floats
    first: Floats
    last: Floats
    valid: Any  # others have no slices

    def from_centre(self, lines: Floats) -> Floats:
        """Lines (1 or n, V, 2) from the centre of each arc, over R."""
        from_centre = lines - self.centre[:, None]
        return from_centre / self.radius[:, None, None]


def angle_from_below(centre: Floats, point: Floats) -> Floats:
    """Angle of points as seen from centres, (n, 2) each, from straight below, positive to the right."""
    to_right, upwards = (point - centre).T
    return np.arctan2(to_right, -upwards)


class Stresses(NamedTuple):
    """On the arcs over gamma R, gamma the unit weight of the first layer: (3, intervals), of 1, sine and cosine."""

    soil: Floats  # weight of the soil above
    load: Any  # surcharge
    pond: Any  # pressure of free water on the ground
    displaced: Any  # minus the weight of water in the place of the soil below free water
    pressure: Floats
    cohesion: Floats
    buoyancy: Any  # minus the weight of water in the place of the soil below the level at the exit
    relieved: Any  # pressure of this water at the height of the arc
    excess: Any  # what the pressure of free water exceeds that of this water by, on the ground

    def turned(self, way: Floats) -> Stresses:
        """The same for angles of the opposite sense where ``way`` is -1."""
        same = np.ones(len(way))
        sense = np.stack([same, way, same])
        return Stresses(*(values * sense for values in self))


class Slices(NamedTuple):
    """Slices above the points of Gauss' rule, (points, intervals); lengths over R, stresses over gamma R.

    An interval is the part of one arc between two kinks. Angles are from straight below the centre. Weights are sums
    over surfaces: the tops of layers, each with the step of the unit weight there, and of their wet parts; and the part
    of the ground below a pond, with minus the water's.
    """

    arcs: Arcs
    arc: NDArray[np.int64]  # number of the arc of each interval
    ends: Floats  # angles of both ends of each interval, (2, intervals)
    weight: Floats  # of a point in the integral over the angle
    sine: Floats
    cosine: Floats
    way: Any  # -1 where angles are counted to the left, by interval
    stresses: Stresses
    friction: Floats  # of each interval
    k_h: Floats
    shaken_load: Any  # share of the surcharge on which k_h acts
    water: Floats  # unit weight over gamma
    steps: Floats  # of the unit weight below each surface, 0 where it is not above the arc, (surfaces, intervals)
    constant: Floats  # height of a surface above the centre is constant + gradient sine
    gradient: Floats
    shaken: NDArray[np.bool_]  # surfaces of soil, not of water

    def at(self, linear: Any) -> Any:
        """Of three numbers for each interval the value at each point."""
        constant, of_sine, of_cosine = linear
        return constant + of_sine * self.sine + of_cosine * self.cosine

    def integral(self, values: Any) -> Floats:
        """Over each arc."""
        by_interval = (self.weight * values).sum(axis=0)
        arcs = len(self.arcs.radius)
        return np.bincount(self.arc, by_interval, arcs).astype(np.float64)

    def facing(self, way: Floats) -> Slices:
        """The same with positive angles down-slope, for arcs that slide to the right (1) or to the left (-1)."""
        sense = way[self.arc]
        return self._replace(
            sine=self.sine * sense, gradient=self.gradient * sense, stresses=self.stresses.turned(sense), way=sense
        )

    def driving_moment(self) -> Floats:
        """Of gravity and of the weight of displaced water about the centre, of each arc."""
        stresses = self.stresses
        weight = self.at(stresses.soil + stresses.displaced + stresses.load)
        moment = slopes.drive(self.sine, self.cosine, weight, 0.0)
        return self.integral(moment)

    def weight_along_arc(self) -> Floats:
        """The integral of the vertical stress over each arc's breadth: what moments are compared with."""
        stresses = self.stresses
        vertical = self.at(stresses.soil + stresses.load + stresses.pond)
        return self.integral(self.cosine * vertical)

    def shaking_moment(self) -> Floats:
        """Of k_h = 1 about the centre, of each arc: on the soil at half its height, on a load at the ground."""
        load = self.at(self.stresses.load) * self.cosine
        moment = load * -self.surface(0) * self.shaken_load
        for k in np.flatnonzero(self.shaken):
            height = self.surface(k) + self.cosine
            of_unit_weight = slopes.drive(0.0, self.cosine, height, 1.0)
            moment = moment + self.steps[k] * of_unit_weight
        return self.integral(moment)

    def surface(self, k: Any) -> Floats:
        """Height of a surface above the centre."""
        return self.constant[k] + self.gradient[k] * self.sine

    def distance(self, k: Any) -> Floats:
        """Of a surface from the centre."""
        return np.hypot(self.sine, self.surface(k))

    def uplift(self) -> Floats:
        """Pore pressure less that of the free water at the exit."""
        stresses = self.stresses
        return self.at(stresses.pressure - stresses.relieved)

    def ordinary_normal(self) -> Floats:
        """Effective normal stress of the ordinary method, (W cos a - k_h W sin a - u l)/l (Fellenius 1936)."""
        sine, cosine = self.sine, self.cosine
        stresses = self.stresses
        not_shaken = self.at(stresses.buoyancy + stresses.load)
        loads = slopes.ordinary_normal(sine, cosine, not_shaken, 0.0, 0.0)
        if np.any(self.k_h * self.shaken_load):
            load = self.at(stresses.load)
            shaken = self.k_h * sine * cosine * load
            loads = loads + shaken * self.shaken_load
        weight = self.at(stresses.soil)
        uplift = self.uplift()
        soil = slopes.ordinary_normal(sine, cosine, weight, uplift, self.k_h)
        across = self.gradient[0] * sine + cosine
        pressure = self.at(stresses.excess) * cosine
        return soil + loads + pressure * across

    def radial_normal(self) -> Floats:
        """Effective normal stress of the paper's method by strips: the weights of (2.23) straight above."""
        normal = -self.uplift()
        for k in np.flatnonzero(np.any(self.steps, axis=1)):
            of_unit_weight = slopes.radial_weight(self.cosine, self.distance(k))
            normal += self.steps[k] * of_unit_weight
        if np.any(self.stresses.load):
            load = self.at(self.stresses.load) * self.cosine
            normal += load * -self.surface(0) / self.distance(0)
        if np.any(self.stresses.excess):
            pressure = self.at(self.stresses.excess) * self.cosine
            across = self.gradient[0] * self.sine - self.surface(0)
            normal += pressure * across / self.distance(0)
        return normal

    def radial_tilt(self) -> Floats:
        """What k_h = 1 adds to it."""
        load = self.at(self.stresses.load) * self.cosine
        tilt = load * self.sine / self.distance(0)
        tilt *= self.shaken_load
        for k in np.flatnonzero(self.shaken):
            height = self.surface(k) + self.cosine
            distance = self.distance(k)
            of_unit_weight = slopes.radial_tilt(self.sine, self.cosine, height, distance)
            tilt += self.steps[k] * of_unit_weight
        return tilt

    def vertical(self) -> Floats:
        """Effective vertical stress on the arc, for Bishop's method."""
        stresses = self.stresses
        total = stresses.soil + stresses.load + stresses.pond - stresses.pressure
        return self.at(total)

    def cohesion(self) -> Floats:
        """On the arc."""
        return self.at(self.stresses.cohesion)


@cache
def _gauss(nodes: int) -> tuple[Floats, Floats]:
    return np.polynomial.legendre.leggauss(nodes)


def slices_above(slope: SlopeArrays, arcs: Arcs, pieces: int = 1, nodes: int = NODES) -> Slices:
    """The slices above valid arcs, cut into pieces and at all kinks."""
    arc, ends = _intervals(slope, arcs, pieces)
    first, last = ends
    half = (last - first) / 2
    middle = (first + last) / 2
    nodes_at, weights = _gauss(nodes)
    angle = middle + half * nodes_at[:, None]
    inside = first + _INSIDE * (last - first)
    base = _Bases(slope, arcs, arc, inside)
    steps = base.steps()
    return Slices(
        arcs=arcs,
        arc=arc,
        ends=ends,
        weight=half * weights[:, None],
        sine=np.sin(angle),
        cosine=np.cos(angle),
        way=1.0,
        stresses=base.stresses(steps),
        friction=base.soil.friction,
        k_h=base.of_slope(slope.k_h),
        shaken_load=base.of_slope(slope.k_h_on_surcharge),
        water=base.water,
        steps=steps,
        constant=base.constant,
        gradient=base.gradient,
        shaken=np.any(steps, axis=1),
    )


def _intervals(slope: SlopeArrays, arcs: Arcs, pieces: int) -> tuple[NDArray[np.int64], Floats]:
    """Number of the arc and angles of both ends of each interval."""
    sines = np.clip(_kinks(slope, arcs), -1.0, 1.0)
    kinks = np.arcsin(sines)
    kinks = np.clip(kinks, arcs.first[:, None], arcs.last[:, None])
    ends_of_pieces = np.linspace(arcs.first, arcs.last, pieces + 1, axis=1)
    angles = np.concatenate([ends_of_pieces, kinks], axis=1)
    angles.sort(axis=1)
    first = angles[:, :-1]
    last = angles[:, 1:]
    is_interval = (last > first) & arcs.valid[:, None]
    return np.nonzero(is_interval)[0], np.stack([first[is_interval], last[is_interval]])


def _kinks(slope: SlopeArrays, arcs: Arcs) -> Floats:
    """x over R from the centre at which an integrand may not be smooth, (n, any)."""
    from_centre = slope.columns.bounds - arcs.centre[:, :1]
    bounds = from_centre / arcs.radius[:, None]
    cuts = [meets_circle(arcs.from_centre(line)) for line in slope.lines_cut_by_arcs]
    return np.concatenate([bounds, *cuts], axis=1)


class _Bases:
    """Surfaces above a point inside each interval, and the soil at its base."""

    def __init__(self, slope: SlopeArrays, arcs: Arcs, arc: NDArray[np.int64], inside: Floats) -> None:
        self.slope = slope
        self.arc = arc
        self.scale = arcs.radius[arc]
        self.centre_x, self.centre_y = arcs.centre[arc].T
        sine = np.sin(inside)
        self.x = self.centre_x + self.scale * sine
        self.depth = np.cos(inside)
        self._look_up_surfaces()
        self.above = self.constant + self.gradient * sine + self.depth
        self._look_up_soil()

    def _look_up_surfaces(self) -> None:
        """Heights of the surfaces above the centre, constant + gradient sine."""
        columns = self.slope.columns
        column = columns.at(self.arc, self.x)
        row = 0 if len(columns.bounds) == 1 else self.arc
        height = columns.height[:, row, column]
        self.gradient = columns.gradient[:, row, column]
        from_middle = self.centre_x - columns.middle[row, column]
        below_centre = height + self.gradient * from_middle
        self.constant = (below_centre - self.centre_y) / self.scale

    def _look_up_soil(self) -> None:
        """The layer at the base, and its soil."""
        soils = self.slope.soils
        layers, _ = soils.unit_weight.shape
        # At an end of the arc rounding may leave no ground above it: then the layers that end there count.
        lowest = np.minimum(self.above[0], 0.0) - _TOUCH
        reaches_arc = self.above[:layers] >= lowest
        layer = np.count_nonzero(reaches_arc, axis=0) - 1
        of_base = (values[layer, self.lane(values)] for values in soils)
        self.soil = SoilArrays(*of_base)
        self.unit_weight = soils.unit_weight[0, self.lane(soils.unit_weight)]
        self.water = self.of_slope(self.slope.water_unit_weight) / self.unit_weight

    def lane(self, values: Floats) -> Any:
        """Return the place of each interval's slope on the last axis of values."""
        return np.zeros(1, dtype=np.int64) if values.shape[-1] == 1 else self.arc

    def of_slope(self, value: Any) -> Floats:
        """A number of the slope, or of each, by interval."""
        values = np.asarray(value, dtype=np.float64)
        if values.size == 1:
            return np.broadcast_to(values, len(self.arc))
        return values[self.arc]

    def steps(self) -> Floats:
        """Of the unit weight below each surface that is above the arc, (surfaces, intervals)."""
        slope = self.slope
        unit_weight = slope.soils.unit_weight
        rows = [np.diff(unit_weight, axis=0, prepend=0.0)]
        if slope.level is not None:
            rows.append(np.zeros_like(unit_weight[:1]))
        if slope.saturates:
            gain = slope.soils.saturated_unit_weight - unit_weight
            rows.append(np.diff(gain, axis=0, prepend=0.0))
        steps = np.concatenate(rows)
        return steps[:, self.lane(steps)] / self.unit_weight * (self.above > 0.0)

    def _above_arc(self, k: int, factor: Any) -> Floats:
        """Height of a surface above the arc times a factor."""
        constant = self.constant[k] * factor
        gradient = self.gradient[k] * factor
        return np.stack([constant, gradient, 1.0 * factor])

    def stresses(self, steps: Floats) -> Stresses:
        """By interval."""
        none = np.zeros((3, 1))
        pond, displaced = (none, none) if self.slope.ponds is None else self._free_water(self.slope.ponds)
        soil = self._soil_weight(steps)
        scale = self.unit_weight * self.scale
        pressure = self._pore_pressure(soil, scale)
        load = self._load() / scale
        cohesion = self._cohesion() / scale
        return Stresses(soil, load, pond, displaced, pressure, cohesion, none, none, pond)

    def _free_water(self, ponds: Ponds) -> tuple[Floats, Floats]:
        """Pressure of free water on the ground, and minus the weight of water in the place of the soil below it."""
        depth = np.zeros((3, len(self.arc)))
        filled = np.zeros(len(self.arc))
        for first, last, level, _ in zip(*ponds, strict=True):
            after_first = self.x > self.of_slope(first)
            before_last = self.x < self.of_slope(last)
            inside = after_first & before_last
            from_centre = self.of_slope(level) - self.centre_y
            height = from_centre / self.scale
            depth[0] += inside * (height - self.constant[0])
            depth[1] -= inside * self.gradient[0]
            filled += inside
        return self.water * depth, -self._above_arc(0, self.water * filled)

    def _soil_weight(self, steps: Floats) -> Floats:
        """Vertical stress of the soil, the sum of the steps times the heights of their surfaces above the arc."""
        surfaces = len(steps)
        constant = np.einsum("si,si->i", steps, self.constant[:surfaces])
        gradient = np.einsum("si,si->i", steps, self.gradient[:surfaces])
        return np.stack([constant, gradient, steps.sum(axis=0)])

    def _pore_pressure(self, soil: Floats, scale: Floats) -> Floats:
        """r_u times the stress of the soil, or the head below the water level; and a uniform pressure."""
        slope = self.slope
        ratio = self.soil.pore_ratio
        pressure = ratio * soil
        pressure[0] += self.of_slope(slope.pressure) / scale
        if slope.level is not None:
            level = len(slope.tops) + 1
            wet = (self.above[level] > 0.0) & (ratio == 0.0)
            pressure += self._above_arc(level, self.water * wet)
        return pressure

    def _load(self) -> Floats:
        """Of surcharges, Pa."""
        load = np.zeros((3, 1))
        for x1, x2, q1, q2 in self.slope.surcharge:
            inside = (self.x > x1) & (self.x < x2)
            first = self.of_slope(q1)
            last = self.of_slope(q2)
            growth = (last - first) / (x2 - x1)
            at_centre = first + growth * (self.centre_x - x1)
            linear = np.stack([at_centre, growth * self.scale, 0.0 * self.scale])
            load = load + inside * linear
        return load

    def _cohesion(self) -> Floats:
        """At the base, which may increase with the depth below a datum; Pa."""
        soil = self.soil
        from_centre = soil.datum - self.centre_y
        below_datum = from_centre + self.depth * self.scale > 0.0
        growth = soil.cohesion_gradient * below_datum
        at_centre = soil.cohesion + growth * from_centre
        of_sine = np.zeros_like(growth)
        return np.stack([at_centre, of_sine, growth * self.scale])
