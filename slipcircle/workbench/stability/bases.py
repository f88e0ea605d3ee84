"""Arcs, with the surfaces above their bases, the soil, and the stresses on the base."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.ground import Ponds, sine_and_cosine
from slipcircle.workbench.stability.columns import SlopeArrays, SoilArrays

_TOUCH = 1e-12  # over R: as near to the arc, a boundary touches it


Circles = tuple[Floats, Floats, Floats, Floats]  # centres and radii, and left and right ends of arcs


class Arcs(NamedTuple):
    """Arcs of circles: centres (n, 2) and radii in m, and angles of both ends from straight below the centre."""

    centre: Floats
    radius: Floats
    first: Floats
    last: Floats
    valid: Any  # others have no slices

    def from_centre(self, lines: Floats) -> Floats:
        """Return lines relative to the centre of each arc, over its radius, (n, V, 2).

        The lines are (1 or n, V, 2), in m.
        """
        return (lines - self.centre[:, None]) / self.radius[:, None, None]


def angle_from_below(centre: Floats, point: Floats) -> Floats:
    """Return the angles in rad of points seen from centres, from straight below, positive to the right.

    Points and centres are (n, 2), in m.
    """
    to_right, upwards = (point - centre).T
    return np.arctan2(to_right, -upwards)


class BaseStresses(NamedTuple):
    """Stresses on the arcs over gamma R, with gamma of the first layer: (3, intervals), for 1, sine and cosine."""

    soil: Floats  # weight of the soil above
    load: Any  # surcharge
    pond: Any  # pressure of free water on the ground
    displaced: Any  # minus the weight of water in the place of the soil below free water
    pressure: Floats
    cohesion: Floats
    buoyancy: Any  # minus the weight of water in the place of the soil below the level at the exit
    relieved: Any  # pressure of this water at the height of the arc
    excess: Any  # pressure of free water minus the pressure of this water, on the ground

    def turned(self, way: Floats) -> BaseStresses:
        """Return the stresses for angles of the opposite sense where ``way``, 1 or -1 by interval, is -1."""
        same = np.ones(len(way))
        sense = np.stack([same, way, same])
        return BaseStresses(*(values * (sense if values.ndim == 2 else sense[:, None]) for values in self))


class Bases:
    """Surfaces above a point inside each interval, and the soil at its base.

    ``arc`` is the index of the arc of each interval, and ``inside`` the angle of the point from straight below the
    centre in rad.
    """

    def __init__(self, slope: SlopeArrays, arcs: Arcs, arc: NDArray[np.int64], inside: Floats) -> None:
        self.slope = slope
        self.arc = arc
        slopes = max(rows.shape[1] for rows in slope.soils)
        self.is_shared = len(arcs.radius) == 1 and max(slopes, np.size(slope.pressure)) > 1
        self.scale = arcs.radius[arc]
        self.centre_x, self.centre_y = arcs.centre[arc].T
        self.sine, self.depth = sine_and_cosine(inside)
        self.x = self.centre_x + self.scale * self.sine
        self.column = slope.columns.at(arc, self.x)
        self.row = 0 if len(slope.columns.bounds) == 1 else arc
        self.from_middle = self.centre_x - slope.columns.middle[self.row, self.column]
        self._look_up_soil()

    def surface(self, k: Any) -> ArrayPair:
        """Return constant and gradient of surfaces: their height above the centre over R is constant + gradient sine.

        ``k`` is the index of a surface in `Columns`, or indices: (surfaces, 1), or one for each interval.
        """
        columns = self.slope.columns
        gradient = columns.gradient[k, self.row, self.column]
        below_centre = columns.height[k, self.row, self.column] + gradient * self.from_middle
        return (below_centre - self.centre_y) / self.scale, gradient

    def above(self, k: Any) -> Floats:
        """Return the height of the surface with index ``k`` above the arc, over R, by interval."""
        constant, gradient = self.surface(k)
        return constant + gradient * self.sine + self.depth

    def _look_up_soil(self) -> None:
        """Look up the layer at the base, by bisection, and its soil."""
        soils = self.slope.soils
        layers, _ = soils.unit_weight.shape
        # At an end of the arc rounding may leave no ground above it: then the layers that end there count.
        lowest = np.minimum(self.above(0), 0.0) - _TOUCH
        layer = np.zeros(len(self.arc), dtype=np.int64)
        for power in reversed(range((layers - 1).bit_length())):
            lower = np.minimum(layer + 2**power, layers - 1)
            layer = np.where(self.above(lower) >= lowest, lower, layer)
        of_base = (self.of_layer(values, layer) for values in soils)
        self.soil = SoilArrays(*of_base)
        self.layer = layer
        self.unit_weight = self.of_slope(soils.unit_weight[0])
        self.water = self.of_slope(self.slope.water_unit_weight) / self.unit_weight

    def of_layer(self, rows: Floats, layer: Any) -> Floats:
        """Return a property at the base of each interval, from its values in all layers, (layers, 1 or slopes).

        ``layer`` is the index of the layer, by interval. The result is (intervals,), or (slopes, intervals) if slopes
        share an arc.
        """
        if rows.shape[1] == 1:
            return rows[layer, 0]
        by_interval: Floats = rows[layer].T if self.is_shared else rows[layer, self.arc]
        return by_interval

    def of_slope(self, value: Any) -> Floats:
        """Return a property of the slope, or of each slope, by interval.

        The result is (intervals,), or (slopes, 1) if slopes share an arc.
        """
        values = np.asarray(value, float)
        if values.size == 1:
            return np.broadcast_to(values, len(self.arc))
        return values[:, None] if self.is_shared else values[self.arc]

    def loads(self, surfaces: Any) -> tuple[Floats, Floats, Floats]:
        """Return steps of the unit weight over gamma, 0 where a surface is below the arc, and constants and gradients.

        The rows are the surfaces with the given indices, (surfaces, intervals); heights are as in `surface`.
        """
        steps = self.slope.steps[surfaces]
        constant, gradient = self.surface(surfaces[:, None])
        is_above = constant + gradient * self.sine + self.depth > 0.0
        if self.is_shared:
            by_interval = steps[:, :, None] / self.unit_weight * is_above[:, None]
        else:
            by_interval = (steps if steps.shape[1] == 1 else steps[:, self.arc]) / self.unit_weight * is_above
        return by_interval, constant, gradient

    def _linear(self, constant: Any, of_sine: Any, of_cosine: Any) -> Floats:
        """Return the coefficients of 1, sine and cosine in one array, (3, intervals).

        An axis of slopes precedes the last one if slopes share an arc.
        """
        stacked = np.stack(np.broadcast_arrays(constant, of_sine, of_cosine))
        axes = 3 if self.is_shared else 2
        return stacked.reshape(3, *(1,) * (axes - stacked.ndim), *stacked.shape[1:])

    def _above_arc(self, k: Any, factor: Any) -> Floats:
        """Return a factor times the height of the surface ``k`` above the arc over R, as coefficients of `_linear`."""
        constant, gradient = self.surface(k)
        return self._linear(constant * factor, gradient * factor, 1.0 * factor)

    def stresses(self) -> BaseStresses:
        """Return the stresses on the base of each interval over gamma R."""
        none = self._linear(0.0, 0.0, 0.0)
        pond, displaced = (none, none) if self.slope.ponds is None else self._free_water(self.slope.ponds)
        soil = self._soil_weight()
        scale = self.unit_weight * self.scale
        pressure = self._pore_pressure(soil, scale)
        load = self._load() / scale
        cohesion = self._cohesion() / scale
        return BaseStresses(soil, load, pond, displaced, pressure, cohesion, none, none, pond)

    def _free_water(self, ponds: Ponds) -> ArrayPair:
        """Return pressure of free water on the ground, and minus the weight of water displaced by soil below it.

        Both are over gamma R, as coefficients of 1, sine and cosine, (3, intervals).
        """
        depth = np.zeros((3, len(self.arc)))
        filled = np.zeros(len(self.arc))
        constant, gradient = self.surface(0)
        for first, last, level, _ in zip(*ponds, strict=True):
            after_first = self.x > self.of_slope(first)
            before_last = self.x < self.of_slope(last)
            inside = after_first & before_last
            from_centre = self.of_slope(level) - self.centre_y
            height = from_centre / self.scale
            depth[0] += inside * (height - constant)
            depth[1] -= inside * gradient
            filled += inside
        return self.water * depth, -self._above_arc(0, self.water * filled)

    def _soil_weight(self) -> Floats:
        """Return the vertical stress of the soil over gamma R, from its sums down to the layer at the base."""
        slope = self.slope
        weight = self._of_sums(slope.weights)
        if slope.saturates:
            is_wet = self.above(slope.level_surface) > 0.0
            weight = weight + self._of_sums(slope.gains) * is_wet
        return weight / self.unit_weight

    def _of_sums(self, sums: Floats) -> Floats:
        """Return the stress of all layers above the base, over R, as coefficients of `_linear`.

        The sums are `SlopeArrays.weights` or `SlopeArrays.gains`, (3, layers, 1 or slopes, columns).
        """
        slope: Any = 0
        if sums.shape[2] > 1:
            slope = np.arange(sums.shape[2])[:, None] if self.is_shared else self.arc
        height, gradient, weight = sums[:, self.layer, slope, self.column]
        constant = (height + gradient * self.from_middle - weight * self.centre_y) / self.scale
        return self._linear(constant, gradient, weight)

    def _pore_pressure(self, soil: Floats, scale: Floats) -> Floats:
        """Return the pore pressure over gamma R: r_u times the soil's stress, or the head, and a uniform pressure.

        ``soil`` is the vertical stress over gamma R, and ``scale`` is gamma R in Pa, by interval.
        """
        slope = self.slope
        ratio = self.soil.pore_ratio
        uniform = self.of_slope(slope.pressure) / scale
        pressure = ratio * soil
        pressure = pressure + self._linear(uniform, 0.0, 0.0)
        if slope.level is not None:
            wet = (self.above(slope.level_surface) > 0.0) & (ratio == 0.0)
            pressure = pressure + self._above_arc(slope.level_surface, self.water * wet)
        return pressure

    def _load(self) -> Floats:
        """Return the pressure of surcharges in Pa, as coefficients of `_linear`."""
        load = self._linear(0.0, 0.0, 0.0)
        for x1, x2, q1, q2 in self.slope.surcharge:
            inside = (self.x > x1) & (self.x < x2)
            first = self.of_slope(q1)
            last = self.of_slope(q2)
            growth = (last - first) / (x2 - x1)
            at_centre = first + growth * (self.centre_x - x1)
            linear = self._linear(at_centre, growth * self.scale, 0.0)
            load = load + inside * linear
        return load

    def _cohesion(self) -> Floats:
        """Return the cohesion at the base in Pa, as coefficients of `_linear`; it may increase with depth."""
        cohesion = self._linear(self.soil.cohesion, 0.0, 0.0)
        if not self.slope.datums:
            return cohesion
        surface = self.slope.datum_surfaces[self.layer]
        is_below = self.above(surface) > 0.0
        return cohesion + self._above_arc(surface, self.soil.cohesion_gradient * self.scale * is_below)
