"""Layered ground in a section: bands of soils by their names, and the soils along the arc where it starts and rests."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from slipcircle.core import LayeredSection, mean_normal_stress, stretches
from slipcircle.workbench.common.quantities import prefixed
from slipcircle.workbench.outputs.plotstyle import LINES, SOILS, axis, label
from slipcircle.workbench.outputs.shapes import Mass, View
from slipcircle.workbench.outputs.trace import Floats

_ACROSS = 400  # points of a boundary
_THIN = 0.02  # of a view's height: a name stands beside a band that is thinner, not in it


def draw_bands(ax: Any, ground: Floats, layers: Sequence[tuple[Any, Any]], view: View, depth: float) -> None:
    """A band of each layer, cut off by those above, with the name of its soil."""
    x, tops = boundaries(ground, layers)
    colours = soil_colours(layers)
    shown = (view.left <= x) & (x <= view.right)
    for k, (soil, _) in enumerate(layers):
        band, strong = colours[soil.name]
        ax.fill_between(x, tops[k], depth, color=band, lw=0, zorder=1)
        if k:
            ax.plot(x, tops[k], color="0.55", lw=0.8, zorder=1)
        below = tops[k + 1] if k + 1 < len(layers) else np.full_like(x, view.bottom)
        thickness = np.where(shown, tops[k] - np.maximum(below, view.bottom), 0.0)
        anchors = np.column_stack([x, tops[k] - thickness / 2])[thickness > 0.3 * np.max(thickness)]
        if anchors.size and soil.name and np.max(thickness) > 0.0:
            is_thick = np.max(thickness) > _THIN * (view.top - view.bottom)
            label(ax, soil.name, anchors[:: max(1, len(anchors) // 40)], strong, inside=is_thick)


def boundaries(ground: Floats, layers: Sequence[tuple[Any, Any]]) -> tuple[Floats, list[Floats]]:
    """Tops of the layers over x, each cut off by those above."""
    lines = [np.asarray(ground, dtype=np.float64)]
    for _, top in layers[1:]:
        points = np.asarray(top, dtype=np.float64)
        lines.append(points if points.ndim == 2 else np.column_stack([ground[:, 0], np.full(len(ground), points)]))
    left, right = lines[0][[0, -1], 0]
    vertices = np.clip(np.concatenate([line[:, 0] for line in lines]), left, right)
    x = np.unique(np.concatenate([vertices, np.linspace(left, right, _ACROSS)]))
    tops = [np.interp(x, *lines[0].T)]
    for line in lines[1:]:
        tops.append(np.minimum(tops[-1], np.interp(x, *line.T)))
    return x, tops


def soil_colours(layers: Sequence[tuple[Any, Any]]) -> dict[str, tuple[str, str]]:
    """Colours of a band and of a stretch of the arc for each soil, by its name."""
    names = dict.fromkeys(soil.name for soil, _ in layers)
    return {name: SOILS[k % len(SOILS)] for k, name in enumerate(names)}


def draw_stretches(ax: Any, mass: Mass, section: LayeredSection, turns: Sequence[float]) -> None:
    """The arc in the colours of its soils, at the start a broad line, turned a narrow one.

    Strength that stays with the base leaves the colours where they are; beyond the exit goes on the soil at the exit,
    or a foreland.
    """
    colours = soil_colours(section.layers) | ({"": SOILS[-1]} if section.foreland else {})
    facing = float(section.facing)
    for turn, width in zip((0.0, *turns), (6.0, 2.5), strict=False):
        moved = facing * turn
        for name, start, end in _soils_under(section, moved):
            angles = 1.5 * np.pi + facing * np.linspace(start, end, 40)
            _, colour = colours.get(name, SOILS[-1])
            ax.plot(*mass.on_circle(angles).T, color=colour, lw=width, zorder=4, solid_capstyle="butt")


def _soils_under(section: LayeredSection, moved: float) -> Iterator[tuple[str, float, float]]:
    """Soil and directions of both ends of each stretch under a mass that has turned down-slope, rad."""
    rows = stretches(section)
    if section.strength == "mass":
        yield from ((row.soil.name, row.start + moved, row.end + moved) for row in rows)
        return
    first, last = rows[0].start + moved, rows[-1].end + moved
    foreland = section.foreland or rows[-1].soil
    everywhere = [
        (rows[0].soil.name, -np.inf, rows[0].start),
        *((row.soil.name, row.start, row.end) for row in rows),
        (foreland.name, rows[-1].end, np.inf),
    ]
    for name, start, end in everywhere:
        if max(start, first) < min(end, last):
            yield name, max(start, first), min(end, last)


def normal_stress_along(section: LayeredSection, ax: Any = None) -> Any:
    """Total normal stress along the arc at the start, by strips as the strength takes it, and its mean (2.9)."""
    ax, rows = axis(ax, (7.0, 3.0)), stretches(section)
    ends = np.linspace(rows[0].start, rows[-1].end, _ACROSS)
    factor, unit = prefixed(mean_normal_stress(section, ends), "Pa")
    along = float(np.asarray(section.radius)) * ((ends[1:] + ends[:-1]) / 2 - ends[0])
    by_strips = np.column_stack([along, factor * mean_normal_stress(section, ends)])
    length = sum(row.length for row in rows)
    mean = factor * sum(row.length * row.normal_stress for row in rows) / length
    ax.plot(*by_strips.T, **LINES["main"])
    ax.axhline(mean, **LINES["total"])
    _soils_behind(ax, section, float(np.max(by_strips[:, 1])))
    few = by_strips[:: _ACROSS // 12]
    label(ax, "by strips", few, LINES["main"]["color"])
    label(ax, "mean", [(x, mean) for x, _ in few])
    ax.set(xlabel="distance along the arc from its upper end (m)", ylabel=f"normal stress ({unit})")
    ax.set_xlim(0.0, length)
    ax.grid(alpha=0.3)
    return ax


def _soils_behind(ax: Any, section: LayeredSection, height: float) -> None:
    """The soil of each stretch as a field behind curves along the arc, with its name."""
    colours, end = soil_colours(section.layers), 0.0
    for row in stretches(section):
        band, strong = colours[row.soil.name]
        start, end = end, end + row.length
        ax.axvspan(start, end, color=band, lw=0)
        if row.soil.name:
            places = [((start + end) / 2, share * height) for share in (0.08, 0.3, 0.5, 0.7, 0.9)]
            label(ax, row.soil.name, places, strong)
