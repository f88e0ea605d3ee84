"""A layered section whose numbers carry derivatives, a lane for each number, in the imaginary parts of complex numbers.

An analytic function f of a real number has f(x + i h) = f(x) + i h f'(x) up to h^2, and with h as small as `STEP`
nothing else is left (Squire and Trapp 1998): what computes the section computes its derivatives, to rounding. NumPy
orders complex numbers by their real parts, so that the section is cut as the real one is.
"""

from collections.abc import Sequence
from dataclasses import fields
from functools import cached_property
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core.scene.coordinates import arc_numbers, changed_fields, replace_unchecked
from slipcircle.ground.circles import MEASURES
from slipcircle.ground.plane import Vectors
from slipcircle.layers.layers import LayeredSection
from slipcircle.layers.strips import edge_below, meets_circle

STEP = 1e-50
_TOUCHES = 1e-9  # how near to the arc a boundary's foot touches it, or a crack to a vertex, over R
_PARALLEL = 1e-6  # difference of slopes below which a crack is deep where the mass is deepest


def derivative(values: Any) -> Floats:
    """What the imaginary parts of complex numbers hold; 0 of real numbers."""
    return np.asarray(np.imag(values) / STEP)


def with_parts(value: Any, derivatives: Any) -> Any:
    """A complex number from its value and derivatives."""
    return float(value) + 1j * STEP * derivatives


def with_derivatives(section: LayeredSection, names: Sequence[str]) -> LayeredSection:
    """A section with a lane for each of these numbers, by which the lane's numbers are differentiated.

    Raises
    ------
    ValueError
        Where a boundary touches the arc without crossing it, or a crack meets a vertex of the ground or a ground that
        is parallel to the arc: there are no derivatives.
    """
    _raise_if_a_boundary_touches(section)
    _raise_at_a_kink_of_the_crack(section)
    numbers = arc_numbers(section)
    known = {name: numbers[name] for name in names if name in numbers}
    all_names = np.array(names)
    steps = {name: with_parts(value, all_names == name) for name, value in known.items()}
    changed = changed_fields(section, steps)
    other: Any = object.__new__(_ComplexSection)
    for field in fields(section):
        name = field.name
        value = changed.get(name, getattr(section, name))
        object.__setattr__(other, name, value)
    return _beside(section, other, len(names))


def _beside(real: LayeredSection, other: Any, lanes: int) -> LayeredSection:
    """The other section, which takes from the real one what is of real numbers."""
    vars(other)["real"] = real
    vars(other)["shape"] = (lanes,)
    section_of_lanes: LayeredSection = other
    return section_of_lanes


class _ComplexSection(LayeredSection):
    """Of the section ``real`` what the geometry of circles, which is of real numbers, gives a layered section."""

    real: LayeredSection

    @cached_property
    def _uncracked(self) -> LayeredSection:
        return _beside(self.real._uncracked, replace_unchecked(self, {"crack": 0.0}), len(self._facing))

    @cached_property
    def _facing(self) -> Floats:
        return np.broadcast_to(self.real._facing, self.shape)

    @cached_property
    def _ends(self) -> tuple[Vectors, Vectors]:
        """Where the ground crosses the circle, next to the ends of the real arc."""
        crossings = meets_circle(self._lines_over_radius[0])
        ends = []
        lane = np.arange(len(crossings))
        for end in self.real._ends:
            distance = np.abs(crossings.real - end.x)
            nearest = distance.argmin(axis=1)
            x = crossings[lane, nearest]
            cosine = np.sqrt((1.0 - x) * (1.0 + x))
            ends.append(Vectors(x, -cosine))
        left, right = ends
        return left, right

    @cached_property
    def _angles(self) -> tuple[Floats, Floats]:
        left, right = self._ends
        return np.arcsin(left.x), np.arcsin(right.x)

    @cached_property
    def half_angle(self) -> Any:
        left, right = self._angles
        return (right - left) / 2

    @cached_property
    def _moments(self) -> dict[str, Floats]:
        return dict(zip(MEASURES, self.profile.whole[:, 0], strict=False))

    @cached_property
    def mean_cover(self) -> Any:
        return np.zeros(self.shape)  # pore pressures of layers are those of their soils

    @cached_property
    def _water(self) -> Any:
        return self.real._water

    def heads_between(self, low: Floats, high: Floats) -> Floats:
        """The integrals move with the vertices of the level and with both directions."""
        water = self.real._water
        first = low.real[..., 0]
        last = high.real[..., 0]
        by_vertex = water.gradient(first, last)
        line = derivative(self._lines_over_radius[-1])
        moved = np.einsum("...vk,nvk->...n", by_vertex, line)
        head_at_last = water.at(last)[..., None]
        head_at_first = water.at(first)[..., None]
        moved = moved + head_at_last * derivative(high)
        moved = moved - head_at_first * derivative(low)
        integral = water.integral(first[..., None], last[..., None])
        return integral + 1j * STEP * moved


def _raise_if_a_boundary_touches(section: LayeredSection) -> None:
    """A line below the ground that comes next to the arc between its ends, and goes away again."""
    left, right = (float(end.x[0]) for end in section._ends)
    for k, line in enumerate(section._lines_over_radius[1 : len(section.layers)], 2):
        points = Vectors.of(line[0])
        first_y, last_y = points.y[[0, -1]]
        if len(points.x) == 2 and first_y == last_y:  # a height
            points.x = np.array([-2.0, 2.0])
        start = points[:-1]
        edge = points.edges
        share = -start.dot(edge) / edge.square
        foot = start + edge * share
        near = np.abs(foot.length - 1.0) < _TOUCHES
        on_edge = (share > 0.0) & (share < 1.0)
        on_arc = (foot.x > left) & (foot.x < right)
        if np.any(near & on_edge & on_arc):
            raise ValueError(
                f"sensitivity: layers.{k}.top: touches the slip circle without crossing it, where there are no "
                "derivatives; move the boundary or the circle a little"
            )


def _raise_at_a_kink_of_the_crack(section: LayeredSection) -> None:
    """A crack whose place is at a vertex of the ground, or jumps, as the mass gets no thicker."""
    if not section._is_cracked:
        return
    _, centre, radius = section._circle
    from_centre = section._crack_place - centre[:, 0]
    (x,) = from_centre / radius
    line = section._lowered_ground
    place = np.array([[x]])
    _, ((slope,),) = edge_below(line, place, place)
    to_vertices = np.abs(line[0, :, 0] - x)
    at_vertex = np.any(to_vertices < _TOUCHES)
    slope_of_arc = x / np.sqrt(1.0 - x * x)
    is_parallel = abs(slope - slope_of_arc) < _PARALLEL
    if at_vertex or is_parallel:
        raise ValueError(
            "sensitivity: crack: is at a vertex of the ground, or where the mass is thickest, where there are no "
            "derivatives; change its depth or the circle a little"
        )
