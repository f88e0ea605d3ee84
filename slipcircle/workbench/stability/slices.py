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
from slipcircle.base.series import Floats
from slipcircle.workbench.stability.columns import Edges, SlopeArrays, SoilArrays

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


class Stresses(NamedTuple):
    """On the arcs over gamma R, gamma the unit weight of the first layer: (3, intervals), of 1, sine and cosine."""

    soil: Floats  # weight of the soil above
    buoyancy: Any  # minus the weight of a pond's water in the place of the soil below its level
    load: Any  # surcharge
    pond: Any  # weight of the water above the ground
    pressure: Floats
    relieved: Any  # pressure of a pond at the height of the arc
    cohesion: Floats

    def turned(self, way: Floats) -> Stresses:
        """The same for angles of the opposite sense where ``way`` is -1."""
        sense = np.stack([np.ones(len(way)), way, np.ones(len(way))])
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
    steps: Floats  # of the unit weight below each surface, 0 where it is not above the arc, (surfaces, intervals)
    constant: Floats  # height of a surface above the centre is constant + gradient sine
    gradient: Floats
    shaken: NDArray[np.bool_]  # surfaces of soil, not of water

    def at(self, linear: Any) -> Any:
        """Of three numbers for each interval the value at each point."""
        return linear[0] + linear[1] * self.sine + linear[2] * self.cosine

    def integral(self, values: Any) -> Floats:
        """Over each arc."""
        by_interval = (self.weight * values).sum(axis=0)
        return np.bincount(self.arc, by_interval, len(self.arcs.radius)).astype(np.float64)

    def facing(self, way: Floats) -> Slices:
        """The same with positive angles down-slope, for arcs that slide to the right (1) or to the left (-1)."""
        sense = way[self.arc]
        return self._replace(
            sine=self.sine * sense, gradient=self.gradient * sense, stresses=self.stresses.turned(sense), way=sense
        )

    def driving_moment(self) -> Floats:
        """Of gravity about the centre, of each arc."""
        stresses = self.stresses
        weight = self.at(stresses.soil + stresses.buoyancy + stresses.load)
        return self.integral(slopes.drive(self.sine, self.cosine, weight, 0.0))

    def weight_along_arc(self) -> Floats:
        """The integral of the vertical stress over each arc's breadth: what moments are compared with."""
        stresses = self.stresses
        return self.integral(self.cosine * self.at(stresses.soil + stresses.load + stresses.pond))

    def shaking_moment(self) -> Floats:
        """Of k_h = 1 about the centre, of each arc: on the soil at half its height, on a load at the ground."""
        total = self.at(self.stresses.load) * self.cosine * -self.surface(0) * self.shaken_load
        for k in np.flatnonzero(self.shaken):
            height = self.surface(k) + self.cosine
            total = total + self.steps[k] * slopes.drive(0.0, self.cosine, height, 1.0)
        return self.integral(total)

    def surface(self, k: Any) -> Floats:
        """Height of a surface above the centre."""
        return self.constant[k] + self.gradient[k] * self.sine

    def uplift(self) -> Floats:
        """Pore pressure less that of a pond."""
        return np.asarray(self.at(self.stresses.pressure - self.stresses.relieved))

    def ordinary_normal(self) -> Floats:
        """Effective normal stress of the ordinary method."""
        stresses = self.stresses
        loads = slopes.ordinary_normal(self.sine, self.cosine, self.at(stresses.buoyancy + stresses.load), 0.0, 0.0)
        if np.any(self.k_h * self.shaken_load):
            loads = loads + self.k_h * self.sine * self.cosine * self.at(stresses.load) * self.shaken_load
        soil = slopes.ordinary_normal(self.sine, self.cosine, self.at(stresses.soil), self.uplift(), self.k_h)
        return np.asarray(soil + loads)

    def radial_normal(self) -> Floats:
        """Effective normal stress of the paper's method by strips: the weights of (2.23) straight above."""
        total = -self.uplift()
        for k in np.flatnonzero(np.any(self.steps, axis=1)):
            distance = np.hypot(self.sine, self.surface(k))
            total += self.steps[k] * slopes.radial_weight(self.cosine, distance)
        load = self.stresses.load
        if np.any(load):
            total += self.at(load) * self.cosine * -self.surface(0) / np.hypot(self.sine, self.surface(0))
        return total

    def radial_tilt(self) -> Floats:
        """What k_h = 1 adds to it."""
        total = self.at(self.stresses.load) * self.cosine * self.sine / np.hypot(self.sine, self.surface(0))
        total *= self.shaken_load
        for k in np.flatnonzero(self.shaken):
            top = self.surface(k)
            distance = np.hypot(self.sine, top)
            total += self.steps[k] * slopes.radial_tilt(self.sine, self.cosine, top + self.cosine, distance)
        return total

    def vertical(self) -> Floats:
        """Effective vertical stress on the arc, for Bishop's method."""
        stresses = self.stresses
        total = stresses.soil + stresses.load + stresses.pond - stresses.pressure
        return np.asarray(self.at(total))

    def cohesion(self) -> Floats:
        """On the arc."""
        return np.asarray(self.at(self.stresses.cohesion))


@cache
def _gauss(nodes: int) -> tuple[Floats, Floats]:
    return np.polynomial.legendre.leggauss(nodes)


def slices_above(slope: SlopeArrays, arcs: Arcs, pieces: int = 1, nodes: int = NODES) -> Slices:
    """The slices above valid arcs, cut into pieces and at all kinks."""
    arc, ends = _intervals(slope, arcs, pieces)
    half = (ends[1] - ends[0]) / 2
    middle = (ends[0] + ends[1]) / 2
    nodes_at, weights = _gauss(nodes)
    angle = middle + half * nodes_at[:, None]
    base = _Bases(slope, arcs, arc, ends[0] + _INSIDE * (ends[1] - ends[0]))
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
        steps=steps,
        constant=base.constant,
        gradient=base.gradient,
        shaken=base.shaken(steps),
    )


def _intervals(slope: SlopeArrays, arcs: Arcs, pieces: int) -> tuple[NDArray[np.int64], Floats]:
    """Number of the arc and angles of both ends of each interval."""
    cuts = np.linspace(arcs.first, arcs.last, pieces + 1, axis=1)
    angles = np.arcsin(np.clip(_kinks(slope, arcs), -1.0, 1.0))
    inside = np.clip(angles, arcs.first[:, None], arcs.last[:, None])
    every = np.sort(np.concatenate([cuts, inside], axis=1), axis=1)
    arc, k = np.nonzero((every[:, 1:] > every[:, :-1]) & arcs.valid[:, None])
    return arc, np.stack([every[arc, k], every[arc, k + 1]])


def _kinks(slope: SlopeArrays, arcs: Arcs) -> Floats:
    """x over R from the centre at which an integrand may not be smooth, (n, any); NaN for none."""
    bounds = (slope.columns.bounds - arcs.centre[:, :1]) / arcs.radius[:, None]
    return np.concatenate([bounds, meeting_points(slope.edges, arcs)], axis=1)


def meeting_points(edges: Edges, arcs: Arcs) -> Floats:
    """x over R from the centre where edges meet the lower half of each circle, (n, 2 edges); NaN for none.

    With y = gradient x - below and x^2 + y^2 = 1.
    """
    x, y = arcs.centre.T[..., None]
    radius = arcs.radius[:, None]
    gradient = edges.gradient
    left, right = ((end - x) / radius for end in (edges.left, edges.right))
    with np.errstate(invalid="ignore"):
        below = (y - edges.y - gradient * (x - edges.x)) / radius
        square = 1.0 + gradient**2
        root = np.sqrt(square - below**2)
        at = np.concatenate([(gradient * below - root) / square, (gradient * below + root) / square], axis=1)
        on_edge = (at >= np.tile(left, 2)) & (at <= np.tile(right, 2))
        in_lower_half = np.tile(gradient, 2) * at < np.tile(below, 2)
        return np.where(on_edge & in_lower_half, at, np.nan)


class _Bases:
    """Surfaces above a point inside each interval, and the soil at its base."""

    def __init__(self, slope: SlopeArrays, arcs: Arcs, arc: NDArray[np.int64], inside: Floats) -> None:
        self.slope = slope
        self.arc = arc
        self.scale = arcs.radius[arc]
        self.centre = arcs.centre[arc]
        self.x = self.centre[:, 0] + self.scale * np.sin(inside)
        self._look_up_surfaces(inside)
        self._look_up_soil()

    def _look_up_surfaces(self, inside: Floats) -> None:
        """Their lines from the centre, and their heights above the arc."""
        columns = self.slope.columns
        column = columns.at(self.arc, self.x)
        row = 0 if len(columns.bounds) == 1 else self.arc
        height = columns.height[:, row, column]
        self.gradient = columns.gradient[:, row, column]
        from_middle = self.centre[:, 0] - columns.middle[row, column]
        self.constant = (height + self.gradient * from_middle - self.centre[:, 1]) / self.scale
        self.depth = np.cos(inside)
        self.above = self.constant + self.gradient * np.sin(inside) + self.depth

    def _look_up_soil(self) -> None:
        """The layer at the base, and its numbers."""
        slope = self.slope
        numbers = slope.numbers
        lane = 0 if numbers.friction.shape[1] == 1 else self.arc
        # At an end of the arc rounding may leave no ground above it: then the layers that end there count.
        lowest = np.minimum(self.above[0], 0.0) - _TOUCH
        layer = np.count_nonzero(self.above[: len(slope.soils)] >= lowest, axis=0) - 1
        self.soil = SoilArrays(*(values[layer, lane] for values in numbers))
        self.lane = lane
        self.unit_weight = numbers.unit_weight[0, lane]
        self.water = self.of_slope(slope.water_unit_weight) / self.unit_weight

    def of_slope(self, value: Any) -> Floats:
        """A number of the slope, or of each, by interval."""
        values = np.asarray(value, dtype=np.float64)
        return np.broadcast_to(values, len(self.arc)) if values.size == 1 else values[self.arc]

    def steps(self) -> Floats:
        """Of the unit weight below each surface that is above the arc, (surfaces, intervals)."""
        slope = self.slope
        numbers = slope.numbers
        none = np.zeros((1, numbers.unit_weight.shape[1]))
        rows = [np.diff(numbers.unit_weight, axis=0, prepend=0.0)]
        if slope.level is not None:
            rows.append(none)
        if slope.saturates:
            rows.append(np.diff(numbers.saturated_unit_weight - numbers.unit_weight, axis=0, prepend=0.0))
        every = np.concatenate(rows)
        steps = (every[:, self.lane] if every.shape[1] > 1 else every) / self.unit_weight
        if slope.pond is not None:
            of_water = np.stack([np.zeros(len(self.arc)), -self.water])
            steps = np.concatenate([np.broadcast_to(steps, (len(steps), len(self.arc))), of_water])
        return np.asarray(steps * (self.above > 0.0))

    def shaken(self, steps: Floats) -> NDArray[np.bool_]:
        """The surfaces of soil."""
        shaken = np.any(steps, axis=1)
        if self.slope.pond is not None:
            shaken[-1] = False
        return np.asarray(shaken)

    def _below(self, k: int, when: Any) -> Floats:
        """Height of a surface above the arc, where that is so."""
        return np.stack([self.constant[k] * when, self.gradient[k] * when, 1.0 * when])

    def stresses(self, steps: Floats) -> Stresses:
        """By interval."""
        slope = self.slope
        layers = len(slope.soils)
        scale = self.unit_weight * self.scale
        buoyancy, pond, relieved = (np.zeros((3, 1)) for _ in range(3))
        of_soil = slice(None)
        if slope.pond is not None:
            of_soil = slice(-2)
            buoyancy = self._below(-1, steps[-1])
            relieved = self._below(-2, self.water * (self.above[-2] > 0.0))
            filled = self.water * (self.above[-2] > self.above[0])
            pond = self._below(-2, filled) - self._below(0, filled)
        constant = np.einsum("si,si->i", steps[of_soil], self.constant[of_soil])
        gradient = np.einsum("si,si->i", steps[of_soil], self.gradient[of_soil])
        soil = np.stack([constant, gradient, steps[of_soil].sum(axis=0)])
        pressure = self.soil.pore_ratio * soil
        pressure[0] += self.of_slope(slope.pressure) / scale
        if slope.level is not None:
            pressure += self._below(layers, self.water * (self.above[layers] > 0.0) * (self.soil.pore_ratio == 0.0))
        return Stresses(soil, buoyancy, self._load() / scale, pond, pressure, relieved, self._cohesion() / scale)

    def _load(self) -> Floats:
        """Of surcharges, Pa."""
        total = np.zeros((3, 1))
        for x1, x2, q1, q2 in self.slope.surcharge:
            inside = (self.x > x1) & (self.x < x2)
            first, last = self.of_slope(q1), self.of_slope(q2)
            growth = (last - first) / (x2 - x1)
            at_centre = first + growth * (self.centre[:, 0] - x1)
            total = total + inside * np.stack([at_centre, growth * self.scale, 0.0 * self.scale])
        return total

    def _cohesion(self) -> Floats:
        """At the base, which may grow with the depth below a datum; Pa."""
        soil = self.soil
        from_centre = soil.datum - self.centre[:, 1]
        growth = soil.cohesion_gradient * (from_centre + self.depth * self.scale > 0.0)
        zero = np.zeros(len(growth))
        return np.stack([soil.cohesion + growth * from_centre, zero, growth * self.scale])
