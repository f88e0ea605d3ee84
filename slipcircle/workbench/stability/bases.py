"""Arcs, with the surfaces above their bases, the soil, and the stresses on the base."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.ground import Ponds
from slipcircle.workbench.stability.columns import SlopeArrays, SoilArrays

_TOUCH = 1e-12  # over R: as near to the arc, a boundary touches it


class Arcs(NamedTuple):
    """Arcs of circles: centres (n, 2) and radii in m, and angles of both ends from straight below the centre."""

    centre: Floats
    radius: Floats
    first: Floats
    last: Floats
    valid: Any  # others have no slices

    def from_centre(self, lines: Floats) -> Floats:
        """Return lines (1 or n, V, 2) relative to the centre of each arc, over R."""
        from_centre = lines - self.centre[:, None]
        return from_centre / self.radius[:, None, None]


def angle_from_below(centre: Floats, point: Floats) -> Floats:
    """Return the angle of points as seen from centres, (n, 2) each, from straight below, positive to the right."""
    to_right, upwards = (point - centre).T
    return np.arctan2(to_right, -upwards)


class Stresses(NamedTuple):
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

    def turned(self, way: Floats) -> Stresses:
        """Return the stresses for angles of the opposite sense where ``way`` is -1."""
        same = np.ones(len(way))
        sense = np.stack([same, way, same])
        return Stresses(*(values * (sense if values.ndim == 2 else sense[:, None]) for values in self))


class Bases:
    """Surfaces above a point inside each interval, and the soil at its base."""

    def __init__(self, slope: SlopeArrays, arcs: Arcs, arc: NDArray[np.int64], inside: Floats) -> None:
        self.slope = slope
        self.arc = arc
        slopes = max(rows.shape[1] for rows in slope.soils)
        self.is_shared = len(arcs.radius) == 1 and max(slopes, np.size(slope.pressure)) > 1
        self.scale = arcs.radius[arc]
        self.centre_x, self.centre_y = arcs.centre[arc].T
        sine = np.sin(inside)
        self.x = self.centre_x + self.scale * sine
        self.depth = np.cos(inside)
        self._look_up_surfaces()
        self.above = self.constant + self.gradient * sine + self.depth
        self._look_up_soil()

    def _look_up_surfaces(self) -> None:
        """Look up heights of the surfaces above the centre, as constant + gradient sine."""
        columns = self.slope.columns
        column = columns.at(self.arc, self.x)
        row = 0 if len(columns.bounds) == 1 else self.arc
        height = columns.height[:, row, column]
        self.gradient = columns.gradient[:, row, column]
        from_middle = self.centre_x - columns.middle[row, column]
        below_centre = height + self.gradient * from_middle
        self.constant = (below_centre - self.centre_y) / self.scale

    def _look_up_soil(self) -> None:
        """Look up the layer at the base, and its soil."""
        soils = self.slope.soils
        layers, _ = soils.unit_weight.shape
        # At an end of the arc rounding may leave no ground above it: then the layers that end there count.
        lowest = np.minimum(self.above[0], 0.0) - _TOUCH
        reaches_arc = self.above[:layers] >= lowest
        layer = np.count_nonzero(reaches_arc, axis=0) - 1
        of_base = (self.of_layer(values, layer) for values in soils)
        self.soil = SoilArrays(*of_base)
        self.layer = layer
        self.unit_weight = self.of_slope(soils.unit_weight[0])
        self.water = self.of_slope(self.slope.water_unit_weight) / self.unit_weight

    def of_layer(self, rows: Floats, layer: Any) -> Floats:
        """Return a property of the layer of each interval, from values of all layers (layers, 1 or slopes)."""
        if rows.shape[1] == 1:
            return rows[layer, 0]
        by_interval: Floats = rows[layer].T if self.is_shared else rows[layer, self.arc]
        return by_interval

    def of_slope(self, value: Any) -> Floats:
        """Return a property of the slope, or of each slope, by interval."""
        values = np.asarray(value, float)
        if values.size == 1:
            return np.broadcast_to(values, len(self.arc))
        return values[:, None] if self.is_shared else values[self.arc]

    def steps(self) -> Floats:
        """Return steps of the unit weight below each surface that is above the arc, (surfaces, intervals)."""
        slope = self.slope
        unit_weight = slope.soils.unit_weight
        rows = [np.diff(unit_weight, axis=0, prepend=0.0)]
        if slope.level is not None:
            rows.append(np.zeros_like(unit_weight[:1]))
        if slope.saturates:
            gain = slope.soils.saturated_unit_weight - unit_weight
            rows.append(np.diff(gain, axis=0, prepend=0.0))
        steps = np.concatenate(rows)
        is_above = self.above[: len(steps)] > 0.0
        if self.is_shared:
            return steps[:, :, None] / self.unit_weight * is_above[:, None]
        return (steps if steps.shape[1] == 1 else steps[:, self.arc]) / self.unit_weight * is_above

    def _linear(self, constant: Any, of_sine: Any, of_cosine: Any) -> Floats:
        """Return three numbers for each interval, with an axis of slopes where these share an arc."""
        stacked = np.stack(np.broadcast_arrays(constant, of_sine, of_cosine))
        axes = 3 if self.is_shared else 2
        return stacked.reshape(3, *(1,) * (axes - stacked.ndim), *stacked.shape[1:])

    def _above_arc(self, k: int, factor: Any) -> Floats:
        """Return the height of a surface above the arc times a factor."""
        constant = self.constant[k] * factor
        gradient = self.gradient[k] * factor
        return self._linear(constant, gradient, 1.0 * factor)

    def stresses(self, steps: Floats) -> Stresses:
        """Return the stresses by interval."""
        none = self._linear(0.0, 0.0, 0.0)
        pond, displaced = (none, none) if self.slope.ponds is None else self._free_water(self.slope.ponds)
        soil = self._soil_weight(steps)
        scale = self.unit_weight * self.scale
        pressure = self._pore_pressure(soil, scale)
        load = self._load() / scale
        cohesion = self._cohesion() / scale
        return Stresses(soil, load, pond, displaced, pressure, cohesion, none, none, pond)

    def _free_water(self, ponds: Ponds) -> ArrayPair:
        """Return the pressure of free water on the ground, and minus the weight of water displaced by soil below it."""
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
        """Return the vertical stress of the soil, a sum of steps times heights of their surfaces above the arc."""
        surfaces = len(steps)
        constant = np.einsum("s...i,si->...i", steps, self.constant[:surfaces])
        gradient = np.einsum("s...i,si->...i", steps, self.gradient[:surfaces])
        return self._linear(constant, gradient, steps.sum(axis=0))

    def _pore_pressure(self, soil: Floats, scale: Floats) -> Floats:
        """Return r_u times the stress of the soil, or the head below the water level, and a uniform pressure."""
        slope = self.slope
        ratio = self.soil.pore_ratio
        uniform = self.of_slope(slope.pressure) / scale
        pressure = ratio * soil
        pressure = pressure + self._linear(uniform, 0.0, 0.0)
        if slope.level is not None:
            level = len(slope.tops) + 1
            wet = (self.above[level] > 0.0) & (ratio == 0.0)
            pressure = pressure + self._above_arc(level, self.water * wet)
        return pressure

    def _load(self) -> Floats:
        """Return the pressure of surcharges, Pa."""
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
        """Return the cohesion at the base, which may increase with the depth below a line, Pa."""
        cohesion = self._linear(self.soil.cohesion, 0.0, 0.0)
        first = len(self.above) - len(self.slope.datums)
        for surface, layer in enumerate(self.slope.datums, first):
            grows = (self.layer == layer) & (self.above[surface] > 0.0)
            growth = self.soil.cohesion_gradient * self.scale * grows
            cohesion = cohesion + self._above_arc(surface, growth)
        return cohesion
