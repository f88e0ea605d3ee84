"""Surroundings of the mass in a section, as named lines: soils, ground, water, firm layer and surcharges.

Pictures and the live page draw the same lines, each in its own way.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.text import drawn_unit, number_text
from slipcircle.core import Arc
from slipcircle.workbench.outputs.pictures.shapes import MassShape, View

_ACROSS = 400  # number of points of a boundary
_ON_CIRCLE = 100  # number of points of the ground along a circle
_PLACES = 40  # greatest number of places for the name of a soil
_EDGE = 0.06  # part of the ground in view, at either end, without names
_THICK = 0.6  # least thickness of a soil at its name, relative to its greatest thickness
_VISIBLE = 0.003  # least thickness of a named soil, relative to the height of a view
_LOAD = 0.05  # height of the greatest surcharge, relative to the size of a view
_APART = 0.025  # distance of arrows, relative to the size of a view
# Arrow of unit height down to the origin, after a gap: tail, tip, and both sides of the head.
_ARROW = np.array([[np.nan, np.nan], [0.0, 1.0], [0.0, 0.0], [-0.15, 0.3], [0.0, 0.0], [0.15, 0.3]])
_NO_PLACES = np.empty((0, 2))


class Line(NamedTuple):
    """Line from left to right; for a soil its top, below which the soil extends to the next line or firm layer."""

    role: str  # in `plotstyle.SCENERY`, and as a class of `live.css`
    points: Floats  # NaN between the parts of a line
    name: str = ""
    places: Floats = _NO_PLACES  # for the name, the best first
    soil: int | None = None  # its number in a layered section, for its colours
    lower: Floats | None = None  # lower edge of the filled area; a soil is filled to the bottom of the view


def scenery_lines(mass: MassShape, soil: Any, view: View) -> Iterator[Line]:
    """Yield the lines of an arc, a section or a slope in a view; names of soils keep clear of the mass.

    The chord of an arc replaces the ground; beyond the toe the ground is assumed to follow the circle.
    """
    if isinstance(soil, Arc):
        yield Line("soil", _below_arc(mass, float(soil.facing), view))
        yield Line("ground", mass.ground)
        return
    yield from _soils(mass, soil, view)
    yield Line("ground", mass.ground)
    yield from _beyond(mass.ground, float(getattr(soil, "facing", 0.0)), view)
    yield from _free_water(mass.ground, soil)
    if soil.base is not None:
        yield _along_ground("firm", "firm layer", [(0.0, soil.base)], mass.ground, view)
    if soil.level is not None:
        yield _along_ground("water", "water level", soil.level, mass.ground, view)
    yield from _surcharges(mass.ground, getattr(soil, "surcharge", ()), view)


def _below_arc(mass: MassShape, facing: float, view: View) -> Floats:
    """Return the surface below an arc: the chord continued up-slope, the arc, and the circle beyond the toe, (n, 2).

    ``facing`` is 1 for a slide to the right, -1 to the left.
    """
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
    """Yield the level ground that the method assumes beyond the last point down-slope, if it is in view.

    ``facing`` is 1 for a slide to the right, -1 to the left, 0 for neither.
    """
    x, y = ground[0] if facing < 0.0 else ground[-1]
    if facing < 0.0:
        edge = view.left
    else:
        edge = view.right
    if facing * (edge - x) > 0.0:
        far = x + facing * view.size  # the axis may show more than the view
        yield Line(
            "beyond", np.array(sorted([[x, y], [far, y]])), "ground assumed level", np.array([[(x + edge) / 2, y]])
        )


def _free_water(ground: Floats, soil: Any) -> Iterator[Line]:
    """Yield the free water on the ground of a section or a slope, filled down to the ground."""
    if soil.level is None:
        name = "pond"
    else:
        name = ""
    for start, end, height in soil.free_water.of_one:
        x = ground[:, 0]
        inside = x[(start < x) & (x < end)]
        across = np.array([start, *inside, end])
        surface = np.stack([across, np.full_like(across, height)], axis=-1)
        yield Line("pond", surface, name, surface[1:-1], lower=np.interp(across, *ground.T))


def _along_ground(role: str, name: str, points: Any, ground: Floats, view: View) -> Line:
    """Return a line, given by points (n, 2) in m, over the width of the ground, with places for its name.

    ``role`` is that of a `Line`.
    """
    x, y = np.asarray(points, dtype=np.float64).T
    left, right = ground[[0, -1], 0]
    line_x = np.array([left, *x[(left < x) & (x < right)], right])
    places_x = np.linspace(max(view.left, left), min(view.right, right), 12)[1:-1]
    line, places = (np.stack([at, np.interp(at, x, y)], axis=-1) for at in (line_x, places_x))
    return Line(role, line, name, places)


# --- soils -----------------------------------------------------------------------------------------------------------


def _soils(mass: MassShape, soil: Any, view: View) -> Iterator[Line]:
    """Yield the tops of soils, each with the name at places where it is thick and free of the mass."""
    layers = getattr(soil, "layers", ())
    if not layers:
        yield Line("soil", mass.ground)
        return
    x, tops = boundaries(mass.ground, layers)
    bottom = np.full_like(x, view.bottom if soil.base is None else max(soil.base, view.bottom))
    across = np.abs(x - mass.centre[0])
    with np.errstate(invalid="ignore"):
        below_mass = mass.centre[1] - np.nan_to_num(np.sqrt(mass.radius**2 - across**2), nan=-np.inf)
    numbers = soil_numbers(layers)
    for (of_layer, _), top, lower in zip(layers, tops, [*tops[1:], bottom], strict=True):
        places = _thick_places(x, np.minimum(top, below_mass), np.maximum(lower, bottom), view)
        if len(places):
            name = of_layer.name
        else:
            name = ""
        yield Line("soil", np.stack([x, top], axis=-1), name, places, numbers[of_layer.name])


def _thick_places(x: Floats, top: Floats, bottom: Floats, view: View) -> Floats:
    """Return places in the middle of a soil where it is thick, (n, 2) in m, from the middle outwards.

    ``top`` and ``bottom`` are its heights over x, in m.
    """
    left, right = max(view.left, x[0]), min(view.right, x[-1])
    edge = _EDGE * (right - left)
    thickness = np.where((left + edge <= x) & (x <= right - edge), top - bottom, 0.0)
    thickest = float(np.max(thickness))
    if thickest < _VISIBLE * view.height:
        return _NO_PLACES
    places = np.column_stack([x, (top + bottom) / 2])[thickness > _THICK * thickest]
    order = np.argsort(np.abs(places[:, 0] - np.mean(places[:, 0])), kind="stable")
    return places[order[:: max(1, len(places) // _PLACES)]]


def boundaries(ground: Floats, layers: Sequence[tuple[Any, Any]]) -> tuple[Floats, list[Floats]]:
    """Return x, (n,), and the heights of the tops of the layers over x, in m, each cut off by the tops above.

    ``layers`` are pairs of soil and top: a height, or points (V, 2).
    """
    left, right = ground[[0, -1], 0]
    lower_tops = (np.asarray(top, dtype=np.float64) for _, top in layers[1:])
    lines = [ground, *(top if top.ndim == 2 else np.array([[left, top]]) for top in lower_tops)]  # or a height
    vertices = np.concatenate([line[:, 0] for line in lines])
    x = np.union1d(np.linspace(left, right, _ACROSS), np.clip(vertices, left, right))
    return x, [*np.minimum.accumulate([np.interp(x, *line.T) for line in lines])]


def soil_numbers(layers: Sequence[tuple[Any, Any]]) -> dict[str, int]:
    """Return the index of each soil of layers, from the ground down, by name."""
    names = dict.fromkeys(soil.name for soil, _ in layers)
    return {name: number for number, name in enumerate(names)}


# --- surcharges ------------------------------------------------------------------------------------------------------


def _surcharges(ground: Floats, loads: Sequence[tuple[float, float, Any, Any]], view: View) -> Iterator[Line]:
    """Yield pressures on the ground as proportional arrows below a line, with their values in the unit of output.

    ``loads`` are x1, x2 in m and the pressures there in Pa.
    """
    greatest = max((float(np.max(load[2:])) for load in loads), default=0.0)
    factor, unit = drawn_unit("Pa")
    for left, right, *pressures in loads if greatest > 0.0 else ():
        start = max(left, ground[0, 0])
        end = min(right, ground[-1, 0])
        if start >= end:
            continue
        spaces = max(1, round((end - start) / (_APART * view.size)))
        x = np.linspace(start, end, spaces + 1)
        tips = np.stack([x, np.interp(x, *ground.T)], axis=-1)
        heights = _LOAD * view.size / greatest * np.interp(x, [left, right], pressures)
        arrows = tips[:, None] + heights[:, None, None] * _ARROW
        values = dict.fromkeys(number_text(factor * value, 4) for value in pressures)
        line = np.concatenate([arrows[:, 1], *arrows])
        yield Line("surcharge", line, f"{' to '.join(values)} {unit}", arrows[:, 1])
