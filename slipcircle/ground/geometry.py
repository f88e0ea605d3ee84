"""Geometry of sections: the arc that a circle cuts off a ground, and the mass above it."""

from functools import cached_property
from typing import Any

import numpy as np

import slipcircle.ground.circles as circles
from slipcircle.base.kinds import ArrayDict, ArrayPair, ArrayTriple, Floats, Shape
from slipcircle.core.lazy import lazy_import
from slipcircle.ground.circles import Cut
from slipcircle.ground.ground import AS_PRINTED, leading_shape
from slipcircle.ground.pieces import integral_inside
from slipcircle.ground.plane import Vectors


class SectionGeometry:
    """Circles through a ground. Internal arrays have one axis of lanes; results have the shape of the fields."""

    ground: Any
    centre: Any
    level: Any
    radius: Any
    between: Any
    confined: Any
    ponds: Any
    quantities: Any

    @cached_property
    def shape(self) -> Shape:
        """Shape of the results, broadcast from radius, centres, grounds and water levels without their own axes."""
        names = ("radius", "centre", "ground", "level")
        shapes = []
        for name in names:
            axes = self.quantities[name].axes
            value = getattr(self, name)
            shapes.append(leading_shape(value, axes))
        return np.broadcast_shapes(*shapes)

    @cached_property
    def _circle(self) -> ArrayTriple:
        """Grounds (lanes or 1, V, 2), centres (lanes, 2) and radii (lanes,), in m.

        A lane is one section of an ensemble.
        """
        centres = np.add(self.centre, 0.0)
        radii = np.add(self.radius, 0.0)
        centre = np.broadcast_to(centres, (*self.shape, 2))
        radius = np.broadcast_to(radii, self.shape)
        ground = self._lines(self.ground)
        return ground, centre.reshape(-1, 2), radius.ravel()

    def _lines(self, points: Any) -> Floats:
        """Return lines with one axis of lanes, (lanes or 1, V, 2), where 1 means that all lanes share a line.

        ``points`` are (..., V, 2) in m.
        """
        points = np.add(points, 0.0)
        axes = points.shape[-2:]
        if points.ndim > 2:
            points = np.broadcast_to(points, (*self.shape, *axes))
        return points.reshape(-1, *axes)

    def _top_line(self, top: Any) -> Floats:
        """Return the top of a layer as lines, (lanes or 1, V, 2).

        ``top`` is a height, one height per lane, points, or None for the ground, in m.
        """
        ground, *_ = self._circle
        height = np.asarray(top)
        if top is None:
            return ground
        if height.ndim > 1:
            return self._lines(height)
        if height.ndim == 1:  # one of each circle
            height = np.broadcast_to(height, self.shape)
        row = height.reshape(-1, 1)
        ends = ground[:, [0, -1], 0]
        line = np.broadcast_arrays(ends, row)
        return np.stack(line, axis=-1)

    @cached_property
    def _cut(self) -> Cut:
        return circles.cut_by_circles(*self._circle)

    @cached_property
    def _candidates(self) -> tuple[Any, ...]:
        """Lane, number, left and right x of candidate stretches, and whether circles contain an end of the ground.

        A stretch is a part of the ground inside a circle; its number counts from 0 from the left. The first four are
        arrays over all candidates, x in m. The last is a mask over lanes, false if ``between`` selects the mass.
        """
        _, centre, radius = self._circle
        lane, number, held = circles.complete_stretches(self._cut)
        of_stretches = self._cut.only(lane)
        first, last = circles.ends(of_stretches, number)
        r = radius[lane]
        x = centre[lane, 0]
        left = x + r * first.x
        right = x + r * last.x
        width = right - left
        meant = np.ones_like(width, bool)
        if self.between is not None:
            low, high = self.between
            rounding = 1e-9 * r
            after_low = left >= low - rounding
            before_high = right <= high + rounding
            is_between = after_low & before_high
            count = np.bincount(lane, is_between, len(radius))
            none_between = count[lane] == 0
            middle = (left + right) / 2
            middle_between = (middle >= low) & (middle <= high)
            meant = is_between | (none_between & middle_between)
            held = np.zeros_like(held)
        widest = np.zeros_like(radius)
        np.maximum.at(widest, lane[meant], width[meant])
        keep = meant & (width >= AS_PRINTED * widest[lane])
        chosen = [column[keep] for column in (lane, number, left, right)]
        return *chosen, held

    @cached_property
    def _ends(self) -> tuple[Vectors, Vectors]:
        """Left and right end of each arc relative to the centre, over R, each (lanes,)."""
        _, number, *_ = self._candidates
        return circles.ends(self._cut, number)

    @cached_property
    def _mine(self) -> Any:
        """Mask of the edges of the ground above the mass, (lanes, edges)."""
        _, number, *_ = self._candidates
        return self._cut.stretch == number[:, None]

    @cached_property
    def _moments(self) -> ArrayDict:
        """Integrals over the mass by the names in `circles.MEASURES`, each (lanes,), with lengths over R."""
        return circles.moments(self._cut, self._mine)

    def _shaped(self, values: Any) -> Any:
        """Return values by lane in the shape of the results, or a number for a single section."""
        values = np.asarray(values)
        _, *components = values.shape
        shaped = values.reshape((*self.shape, *components))
        return shaped[()]

    @cached_property
    def _facing(self) -> Floats:
        """Direction in which gravity turns the mass, 1 to the right and -1 to the left, (lanes,)."""
        left, right = self._ends
        by_weight = -np.sign(self._moments["moment_x"])
        rises = left.y < right.y
        by_height = np.where(rises, -1.0, 1.0)
        return np.where(by_weight != 0.0, by_weight, by_height)

    @cached_property
    def facing(self) -> Any:
        """1 if gravity turns the mass to the right, -1 to the left."""
        return self._shaped(self._facing)

    @cached_property
    def _angles(self) -> ArrayPair:
        """Angles of the left and the right end in rad, each (lanes,).

        They are measured from straight below the centre and are positive to the right.
        """
        left, right = self._ends
        first = np.arctan2(left.x, -left.y)
        last = np.arctan2(right.x, -right.y)
        return first, last

    @cached_property
    def _chord(self) -> Vectors:
        """Vector from the left to the right end, over R, (lanes,)."""
        run, rise = self._cut.part.where(self._mine)
        return Vectors(run.sum(axis=1), rise.sum(axis=1))

    @cached_property
    def chord(self) -> Any:
        """Length of the chord, m."""
        length = self._shaped(self._chord.length)
        return length * self.radius

    @cached_property
    def half_angle(self) -> Any:
        """Half the opening angle of the arc, alpha, rad."""
        left, right = self._angles
        by_ends = (right - left) / 2
        sine = np.minimum(self._chord.length / 2, 1.0)
        acute = np.arcsin(sine)
        is_acute = by_ends <= np.pi / 2
        by_chord = np.where(is_acute, acute, np.pi - acute)
        accurate = np.where(sine > 0.7, by_ends, by_chord)  # each where it is well conditioned
        return self._shaped(accurate)

    @cached_property
    def dip(self) -> Any:
        """Dip of the chord, psi, rad, positive down-slope."""
        run, rise = self._chord
        fall = -self._facing * rise
        return self._shaped(np.arctan2(fall, run))

    def _end(self, way: float) -> Any:
        """Return one end of the arc, x and y in m, (..., 2).

        It is the left end where the mass faces in the direction ``way``, 1 (right) or -1 (left), and otherwise the
        right end.
        """
        _, centre, radius = self._circle
        is_left = self._facing == way
        left, right = self._ends
        end = np.where(is_left[:, None], left.points, right.points)
        from_centre = radius[:, None] * end
        return self._shaped(centre + from_centre)

    @cached_property
    def entry(self) -> Any:
        """Upper end of the slip surface, x and y in m."""
        return self._end(1.0)

    @cached_property
    def exit(self) -> Any:
        """Lower end of the slip surface, the toe at the start, x and y in m."""
        return self._end(-1.0)

    @cached_property
    def surface(self) -> Floats:
        """Points of the ground above the mass of a single section, from its left to its right end, (V, 2), m."""
        ends = [tuple(self.entry), tuple(self.exit)]
        left, right = sorted(ends)
        ground = np.asarray(self.ground, float)
        x = ground[:, 0]
        after_left = x > left[0]
        before_right = x < right[0]
        between = ground[after_left & before_right]
        return np.concatenate([[left], between, [right]])

    @cached_property
    def area(self) -> Any:
        """Area of the mass, m^2."""
        area = self._shaped(self._moments["area"])
        return area * np.square(self.radius)

    @cached_property
    def depth(self) -> Any:
        """Greatest thickness of the mass along a radius, m."""
        thickness = circles.thickness(self._cut, self._mine)
        return self._shaped(thickness) * self.radius

    @cached_property
    def _level(self) -> Floats:
        """Points of the water level in m, (lanes or 1, W, 2)."""
        return self._lines(self.level)

    @property
    def has_water(self) -> bool:
        """Whether the section has a water level or ponds."""
        return self.level is not None or len(self.ponds) > 0

    @property
    def water(self) -> tuple[Any, ...]:
        """Grounds and water levels (None if absent) as lines, whether the level is confined, and ponds.

        Lines have one axis of lanes, of length 1 if all lanes share a line.
        """
        if self.level is None:
            level = None
        else:
            level = self._level
        return self._lines(self.ground), level, self.confined, self.ponds

    @cached_property
    def free_water(self) -> Any:
        """Free water above the ground, `slipcircle.ground.ponds.Ponds`."""
        return lazy_import("ponds").free_water(*self.water)

    @cached_property
    def standing_level(self) -> Floats:
        """Level of free water above the exits relative to the centres, over R, (lanes,); -inf for a dry exit."""
        _, centre, radius = self._circle
        if not self.has_water:
            return np.full_like(radius, -np.inf)
        x, y = self.exit.reshape(-1, 2).T
        level = self.free_water.covering(x, y)
        above_centre = level - centre[:, 1]
        return above_centre / radius

    @cached_property
    def in_standing_water(self) -> bool:
        """Whether free water covers an exit."""
        is_under_water = np.isfinite(self.standing_level)
        return bool(is_under_water.any())

    @cached_property
    def _span(self) -> ArrayPair:
        """Angles of entry and exit in rad from straight below the centre, positive down-slope, each (lanes,)."""
        left, right = self._angles
        faces_right = self._facing > 0.0
        entry = np.where(faces_right, left, -right)
        exit_ = np.where(faces_right, right, -left)
        return entry, exit_

    @cached_property
    def _water(self) -> Any:
        """Integrals of the height of the water level above the arcs."""
        return lazy_import("heights").height_integrals(self._level, *self._circle[1:])

    @cached_property
    def mean_cover(self) -> Any:
        """Mean height of the ground above the arc, m. Times r_u and the unit weight it is a mean pore pressure.

        Where the arc overhangs, the ground above it lies outside the mass.
        """
        first, last = self._angles
        every_edge = integral_inside(self._cut)
        of_mass = np.where(self._mine, every_edge, 0.0)
        integral = of_mass.sum(axis=1)
        overhangs = np.maximum(-first, last) > np.pi / 2
        if overhangs.any():
            above = lazy_import("heights").height_integrals(*self._circle)
            integral = np.where(overhangs, above.integral(first, last), integral)
        return self._shaped(integral) / (2 * self.half_angle) * self.radius
