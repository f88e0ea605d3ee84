"""Surroundings of the mass in a section, as named lines: soils, ground, water, firm layer and surcharges.

Pictures and the live page draw the same lines, each in its own way.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.text import drawn_unit, shown
from slipcircle.core import Arc
from slipcircle.ground import free_water
from slipcircle.workbench.outputs.pictures.shapes import Mass, View

_ACROSS = 400  # number of points of a boundary
_ON_CIRCLE = 100  # number of points of the ground along a circle
_PLACES = 40  # greatest number of places for the name of a soil
_EDGE = 0.06  # part of the ground in view, at either end, without names
_THICK = 0.6  # least thickness of a soil at its name, relative to its greatest thickness
_VISIBLE = 0.003  # least thickness of a named soil, relative to the height of a view
_LOAD = 0.05  # height of the greatest surcharge, relative to the size of a view
_APART = 0.025  # distance of arrows, relative to the size of a view
_HEAD = 0.3  # length of the head of an arrow, relative to the arrow
_NO_PLACES = np.empty((0, 2))


class Line(NamedTuple):
    """Line from left to right; for a soil its top, below which the soil extends to the next line or firm layer."""

    role: str  # in `plotstyle.SCENERY`, and as a class of `live.css`
    points: Floats  # NaN between the parts of a line
    name: str = ""
    places: Floats = _NO_PLACES  # for the name, the best first
    soil: int | None = None  # its number in a layered section, for its colours
    lower: Floats | None = None  # lower edge of the filled area; a soil is filled to the bottom of the view


def lines(mass: Mass, soil: Any, view: View, outlines: Sequence[Floats] = ()) -> Iterator[Line]:
    """Yield the lines of a section in a view; names of soils keep clear of the mass.

    The chord of an arc replaces the ground; beyond the toe the ground is assumed to follow the circle.

    Parameters
    ----------
    mass : Mass
    soil : Arc, Section or Slope
    view : View
    outlines : sequence of ndarray
        Outlines of the mass, (n, 2) in m, at all displayed positions.
    """
    if isinstance(soil, Arc):
        yield Line("soil", _below_arc(mass, float(soil.facing), view))
        yield Line("ground", mass.ground)
        return
    yield from _soils(mass, soil, view, outlines)
    yield Line("ground", mass.ground)
    yield from _beyond(mass.ground, float(getattr(soil, "facing", 0.0)), view)
    yield from _free_water(mass.ground, soil)
    if soil.base is not None:
        left, right = mass.ground[[0, -1], 0]
        base = np.array([[left, soil.base], [right, soil.base]])
        yield _along_ground("firm", "firm layer", base, mass.ground, view)
    if soil.level is not None:
        level = np.asarray(soil.level, dtype=np.float64)
        yield _along_ground("water", "water level", level, mass.ground, view)
    loads = getattr(soil, "surcharge", ())
    yield from _surcharges(mass.ground, loads, view)


def _below_arc(mass: Mass, facing: float, view: View) -> Floats:
    """Return the surface below an arc: the chord continued up-slope, the arc, and the circle beyond the toe."""
    first, last = mass.ends
    (left, low), (right, high) = mass.ground
    slope = (high - low) / (right - left)
    view = view.grown(view.size, 0.0)  # the axis may show more
    if facing < 0.0:
        points = mass.on_circle(np.linspace(min(first, math.pi), last, _ON_CIRCLE))
        return np.concatenate([points, [[view.right, high + slope * (view.right - right)]]])
    points = mass.on_circle(np.linspace(first, max(last, 2 * math.pi), _ON_CIRCLE))
    return np.concatenate([[[view.left, low + slope * (view.left - left)]], points])


def _beyond(ground: Floats, facing: float, view: View) -> Iterator[Line]:
    """Yield the level ground that the method assumes beyond the last point down-slope, if it is in view."""
    x, y = ground[0] if facing < 0.0 else ground[-1]
    edge = view.left if facing < 0.0 else view.right
    if facing * (edge - x) > 0.0:
        far = x + facing * view.size  # the axis may show more than the view
        yield Line(
            "beyond", np.array(sorted([[x, y], [far, y]])), "ground assumed level", np.array([[(x + edge) / 2, y]])
        )


def _free_water(ground: Floats, soil: Any) -> Iterator[Line]:
    """Yield the free water on the ground of a section or a slope, filled down to the ground."""
    level = None if soil.level is None else np.asarray(soil.level, dtype=np.float64)[None]
    for start, end, height in free_water(ground[None], level, soil.confined, soil.ponds).of_one:
        x = ground[:, 0]
        inside = x[(start < x) & (x < end)]
        across = np.array([start, *inside, end])
        surface = np.stack([across, np.full_like(across, height)], axis=-1)
        name = "pond" if level is None else ""
        yield Line("pond", surface, name, surface[1:-1], lower=np.interp(across, *ground.T))


def _along_ground(role: str, name: str, points: Floats, ground: Floats, view: View) -> Line:
    """Return a line, given by points (n, 2) in m, over the width of the ground, with places for its name."""
    x, y = points.T
    left = ground[0, 0]
    right = ground[-1, 0]
    is_between = (left < x) & (x < right)
    vertices = x[is_between]
    line_x = np.concatenate([[left], vertices, [right]])
    line_y = np.interp(line_x, x, y)
    line = np.stack([line_x, line_y], axis=-1)
    first = max(view.left, left)
    last = min(view.right, right)
    in_view = np.linspace(first, last, 12)
    places_x = in_view[1:-1]
    places_y = np.interp(places_x, x, y)
    places = np.stack([places_x, places_y], axis=-1)
    return Line(role, line, name, places)


# --- soils -----------------------------------------------------------------------------------------------------------


def _soils(mass: Mass, soil: Any, view: View, outlines: Sequence[Floats]) -> Iterator[Line]:
    """Yield the tops of soils, each with the name at places where it is thick and free of the mass."""
    layers = getattr(soil, "layers", ())
    if not layers:
        yield Line("soil", mass.ground)
        return
    x, tops = boundaries(mass.ground, layers)
    lowest = view.bottom
    if soil.base is not None:
        lowest = max(soil.base, lowest)
    bottom = np.full_like(x, lowest)
    free = _below_mass(mass, x, outlines)
    numbers = numbers_of(layers)
    lower_edges = [*tops[1:], bottom]
    for (of_layer, _), top, lower in zip(layers, tops, lower_edges, strict=True):
        free_top = np.minimum(top, free)
        free_bottom = np.maximum(lower, bottom)
        places = _thick_places(x, free_top, free_bottom, view)
        name = of_layer.name if len(places) else ""
        line = np.stack([x, top], axis=-1)
        number = numbers[key_of(of_layer)]
        yield Line("soil", line, name, places, number)


def _below_mass(mass: Mass, x: Floats, outlines: Sequence[Floats]) -> Floats:
    """Return the heights in m over x below which no outline reaches; infinite beside the outlines."""
    if not outlines:
        return np.full_like(x, np.inf)
    reached = np.concatenate(outlines)[:, 0]
    first = np.min(reached)
    last = np.max(reached)
    is_reached = (first <= x) & (x <= last)
    centre_x, centre_y = mass.centre
    across = x - centre_x
    square = mass.radius**2 - across**2
    half_chord = np.sqrt(np.maximum(square, 0.0))
    circle = centre_y - half_chord
    return np.where(is_reached, circle, np.inf)


def _thick_places(x: Floats, top: Floats, bottom: Floats, view: View) -> Floats:
    """Return places in the middle of a soil where it is thick, (n, 2), from the middle outwards."""
    left = max(view.left, x[0])
    right = min(view.right, x[-1])
    edge = _EDGE * (right - left)
    inside = (left + edge <= x) & (x <= right - edge)
    thickness = np.where(inside, top - bottom, 0.0)
    thickest = float(np.max(thickness))
    if thickest < _VISIBLE * (view.top - view.bottom):
        return _NO_PLACES
    middle_y = (top + bottom) / 2
    middle = np.column_stack([x, middle_y])
    is_thick = thickness > _THICK * thickest
    places = middle[is_thick]
    places_x = places[:, 0]
    off_middle = np.abs(places_x - np.mean(places_x))
    order = np.argsort(off_middle, kind="stable")
    apart = max(1, len(places) // _PLACES)
    return places[order[::apart]]


def boundaries(ground: Floats, layers: Sequence[tuple[Any, Any]]) -> tuple[Floats, list[Floats]]:
    """Return x, (n,), and the tops of the layers over x in m, each cut off by the tops above."""
    surface = np.asarray(ground, dtype=np.float64)
    left = surface[0, 0]
    right = surface[-1, 0]
    lines = [surface]
    for _, top in layers[1:]:
        line = np.asarray(top, dtype=np.float64)
        if line.ndim < 2:  # a height
            line = np.array([[left, top], [right, top]])
        lines.append(line)
    vertices = np.concatenate([line[:, 0] for line in lines])
    inside = np.clip(vertices, left, right)
    equidistant = np.linspace(left, right, _ACROSS)
    x = np.union1d(equidistant, inside)
    tops = [np.interp(x, *lines[0].T)]
    for line in lines[1:]:
        height = np.interp(x, *line.T)
        tops.append(np.minimum(tops[-1], height))
    return x, tops


def key_of(soil: Any) -> str:
    """Return the identifier of a soil: its name if it has one."""
    return soil.name or str(id(soil))


def numbers_of(layers: Sequence[tuple[Any, Any]]) -> dict[str, int]:
    """Return the numbers of the soils of layers, from the ground down, by `key_of`."""
    keys = dict.fromkeys(key_of(soil) for soil, _ in layers)
    return {key: number for number, key in enumerate(keys)}


# --- surcharges ------------------------------------------------------------------------------------------------------


def _surcharges(ground: Floats, loads: Sequence[tuple[float, float, Any, Any]], view: View) -> Iterator[Line]:
    """Yield pressures on the ground as proportional arrows below a line, with their values in kPa."""
    greatest = max([float(np.max(load[2:])) for load in loads], default=0.0)
    if greatest <= 0.0:
        return
    scale = _LOAD * view.size / greatest
    apart = _APART * view.size
    first = ground[0, 0]
    last = ground[-1, 0]
    for left, right, at_left, at_right in loads:
        start = max(left, first)
        end = min(right, last)
        if start >= end:
            continue
        spaces = max(1, round((end - start) / apart))
        x = np.linspace(start, end, spaces + 1)
        y = np.interp(x, *ground.T)
        pressure = np.interp(x, [left, right], [at_left, at_right])
        height = scale * pressure
        top = y + height
        tails = np.stack([x, top], axis=-1)
        arrows = [_arrow(*arrow) for arrow in zip(x, y, height, strict=True)]
        line = np.concatenate([tails, *arrows])
        factor, unit = drawn_unit("Pa")
        values = dict.fromkeys(shown(factor * value, 4) for value in (at_left, at_right))
        name = f"{' to '.join(values)} {unit}"
        yield Line("surcharge", line, name, tails)


def _arrow(x: float, y: float, height: float) -> Floats:
    """Return the points of an arrow down to (x, y), after a gap of NaN, (6, 2)."""
    head = _HEAD * height
    half = head / 2
    gap = [np.nan, np.nan]
    tail = [x, y + height]
    tip = [x, y]
    left = [x - half, y + head]
    right = [x + half, y + head]
    return np.array([gap, tail, tip, left, tip, right])
