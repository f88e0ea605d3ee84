"""Layered ground in a section: bands with the names of their soils, and the soils along the arc."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Motion
from slipcircle.layers import LayeredSection, mean_normal_stress, stretches
from slipcircle.workbench.common.quantities import prefixed
from slipcircle.workbench.outputs.plotstyle import LINES, SOILS, axis, label, points_of
from slipcircle.workbench.outputs.shapes import Mass, View

_ACROSS = 400  # points of a boundary
_PLACES = 40  # for the label of a band
_BOUNDARY = {"color": "0.55", "lw": 0.8, "zorder": 1}
_START = 6.0  # width of the arc at the start, in points
_TURNED = 2.5  # of the turned arc
Layers = Sequence[tuple[Any, Any]]  # soils and their tops
_THIN = 0.02  # of the height of a view: the label of a thinner band stands beside it


def draw_bands(ax: Any, ground: Floats, layers: Layers, view: View, depth: float) -> None:
    """A band of each layer, cut off by those above, with the name of its soil."""
    x, tops = boundaries(ground, layers)
    bottom = np.full_like(x, view.bottom)
    visible_tops = [np.maximum(top, bottom) for top in tops]
    lower_edges = [*visible_tops[1:], bottom]
    colours = soil_colours(layers)
    for k, (soil, _) in enumerate(layers):
        top = tops[k]
        band, strong = colours[_key(soil)]
        ax.fill_between(x, top, depth, color=band, lw=0, zorder=1)
        if k > 0:
            ax.plot(x, top, **_BOUNDARY)
        edges = np.stack([x, top, lower_edges[k]])
        _name_band(ax, soil.name, strong, edges, view)


def _name_band(ax: Any, name: str, colour: str, band: Floats, view: View) -> None:
    """The name of a soil within its band of x, tops and bottoms where it is thick; beside it where it is thin."""
    x, top, bottom = band
    in_view = (view.left <= x) & (x <= view.right)
    thickness = np.where(in_view, top - bottom, 0.0)
    thickest = float(np.max(thickness))
    if not name or thickest <= 0.0:
        return
    middle_y = (top + bottom) / 2
    middle = np.column_stack([x, middle_y])
    places = middle[thickness > 0.3 * thickest]
    apart = max(1, len(places) // _PLACES)
    height = view.top - view.bottom
    is_thick = thickest > _THIN * height
    label(ax, name, places[::apart], colour, inside=is_thick)


def boundaries(ground: Floats, layers: Layers) -> tuple[Floats, list[Floats]]:
    """Tops of the layers over x, each cut off by those above."""
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


def soil_colours(layers: Layers) -> dict[str, tuple[str, str]]:
    """Colours of a band and of a stretch of the arc for each soil, by its name."""
    names = dict.fromkeys(_key(soil) for soil, _ in layers)
    return {name: SOILS[k % len(SOILS)] for k, name in enumerate(names)}


def _key(soil: Any) -> str:
    """Identifier of a soil: the name if it has one."""
    return soil.name or str(id(soil))


def draw_stretches(ax: Any, mass: Mass, section: LayeredSection, turns: Sequence[float]) -> None:
    """The arc in the colours of its soils, at the start a broad line, turned a narrow one.

    Where the strength belongs to the base the colours stay in place; beyond the exit the soil at the exit, or the
    foreland, continues.
    """
    colours = soil_colours(section.layers)
    facing = float(section.facing)
    for turn, width in zip((0.0, *turns), (_START, _TURNED), strict=False):
        moved = facing * turn
        for name, start, end in _soils_under(section, moved):
            from_below = facing * np.linspace(start, end, 40)
            angles = 1.5 * np.pi + from_below
            x, y = mass.on_circle(angles).T
            _, colour = colours.get(name, SOILS[-1])  # a foreland may be of another soil
            ax.plot(x, y, color=colour, lw=width, zorder=4, solid_capstyle="butt")


def _soils_under(section: LayeredSection, moved: float) -> Iterator[tuple[str, float, float]]:
    """Soil and angles of both ends of each stretch under a mass that has turned down-slope, rad."""
    rows = stretches(section)
    if section.strength == "mass":
        for row in rows:
            yield _key(row.soil), row.start + moved, row.end + moved
        return
    entry = rows[0]
    exit_ = rows[-1]
    beyond = section.foreland or exit_.soil
    above_entry = entry.soil, -np.inf, entry.start
    below_exit = beyond, exit_.end, np.inf
    everywhere = [above_entry]
    for row in rows:
        everywhere.append((row.soil, row.start, row.end))
    everywhere.append(below_exit)
    mass_start = entry.start + moved
    mass_end = exit_.end + moved
    for soil, start, end in everywhere:
        first = max(start, mass_start)
        last = min(end, mass_end)
        if first < last:
            yield _key(soil), first, last


def stress_along(motion: Motion, ax: Any = None) -> Any:
    """Total normal stress along the arc at the start, by strips, on which the strength is based, and its mean (2.9)."""
    section = motion.plan.scene.arc
    if not isinstance(section, LayeredSection):
        raise ValueError("plot: the stress along the arc by strips: of a section with layers")
    ax = axis(ax, (7.0, 3.0))
    rows = stretches(section)
    angles = np.linspace(rows[0].start, rows[-1].end, _ACROSS)
    pascals = mean_normal_stress(section, angles)
    factor, unit = prefixed(pascals, "Pa")
    stress = factor * pascals
    length = sum(row.length for row in rows)
    force = sum(row.length * row.normal_stress for row in rows)
    mean = factor * force / length
    middles = (angles[1:] + angles[:-1]) / 2
    radius = float(np.asarray(section.radius))
    along = radius * (middles - angles[0])
    ax.plot(along, stress, **LINES["main"])
    ax.axhline(mean, **LINES["total"])
    _soils_behind(ax, section, float(np.max(stress)))
    label(ax, "by strips", points_of(along, stress), LINES["main"]["color"])
    label(ax, "mean", points_of(along, mean))
    ax.set(xlabel="distance along the arc from its upper end (m)", ylabel=f"normal stress ({unit})")
    ax.set_xlim(0.0, length)
    ax.grid(alpha=0.3)
    return ax


def _soils_behind(ax: Any, section: LayeredSection, height: float) -> None:
    """The soil of each stretch as a coloured area behind curves along the arc, with its name."""
    colours = soil_colours(section.layers)
    start = 0.0
    for row in stretches(section):
        band, strong = colours[_key(row.soil)]
        end = start + row.length
        ax.axvspan(start, end, color=band, lw=0)
        if row.soil.name:
            middle = (start + end) / 2
            places = [(middle, share * height) for share in (0.08, 0.3, 0.5, 0.7, 0.9)]
            label(ax, row.soil.name, places, strong)
        start = end
