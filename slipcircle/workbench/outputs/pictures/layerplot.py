"""Soils and normal stress along the arc of a layered section."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from slipcircle.core import Motion
from slipcircle.layers import LayeredSection, mean_normal_stress, soils_under, stretches
from slipcircle.workbench.common.quantities import prefixed
from slipcircle.workbench.outputs.pictures.plotstyle import LINES, SOILS, add_label, anchors_along, panel
from slipcircle.workbench.outputs.pictures.scenery import soil_numbers
from slipcircle.workbench.outputs.pictures.shapes import MassShape

_ACROSS = 400  # number of points of the stress curve
_START = 6.0  # width of the arc at the start, in points
_TURNED = 2.5  # width of the turned arc, in points
_NAMED = 0.03  # relative to the arc; shorter stretches are not named


def draw_stretches(ax: Any, mass: MassShape, section: LayeredSection, turns: Sequence[float]) -> None:
    """Draw the arc in the colours of its soils, at the start as a broad line, turned as a narrow one.

    ``turns`` are rotations in rad. Where the strength belongs to the base, the colours stay in place; beyond the exit
    the soil at the exit, or the foreland, continues.
    """
    numbers = soil_numbers(section.layers)
    facing = float(section.facing)
    for turn, width in zip((0.0, *turns), (_START, _TURNED), strict=False):
        soils, ends = soils_under(section, facing * turn)
        for soil, start, end in zip(soils, ends[:-1], ends[1:], strict=True):
            points = mass.on_circle(1.5 * np.pi + facing * np.linspace(start, end, 40))
            number = numbers.get(section.soils[soil].name, -1)  # a foreland may be of another soil
            _, colour = SOILS[number % len(SOILS)]
            ax.plot(*points.T, color=colour, lw=width, zorder=4, solid_capstyle="butt")


def stress_along(motion: Motion, ax: Any = None) -> Any:
    """Draw the total normal stress at the start along the arc of a layered section, and its mean (2.9).

    The strength is based on this stress, which is computed by strips. Raises ValueError for a scene without layers.
    """
    section = motion.plan.scene.arc
    if not isinstance(section, LayeredSection):
        raise ValueError("plot: the stress along the arc requires a section with [[layers]]")
    rows = stretches(section)
    angles = np.linspace(rows[0].start, rows[-1].end, _ACROSS)
    pascals = mean_normal_stress(section, angles)
    factor, unit = prefixed(pascals, "Pa")
    stress = factor * pascals
    length = sum(row.length for row in rows)
    mean = factor * sum(row.length * row.normal_stress for row in rows) / length
    along = float(np.asarray(section.radius)) * ((angles[1:] + angles[:-1]) / 2 - angles[0])
    across = "distance along the arc from its upper end", "m"
    ax = panel(ax, "normal stress at the start", across, (f"normal stress ({unit})",), size=(7.0, 3.0))
    ax.plot(along, stress, **LINES["main"])
    ax.axhline(mean, **LINES["total"])
    _soils_behind(ax, section, float(np.max(stress)))
    add_label(ax, "by strips", anchors_along(along, stress), LINES["main"]["color"])
    add_label(ax, "mean", anchors_along(along, mean))
    ax.set_xlim(0.0, length)
    return ax


def _soils_behind(ax: Any, section: LayeredSection, height: float) -> None:
    """Shade the soil of each stretch behind curves along the arc, with its name; ``height`` is their maximum."""
    numbers = soil_numbers(section.layers)
    rows = stretches(section)
    ends = np.cumsum([0.0, *(row.length for row in rows)])
    for row, start, end in zip(rows, ends[:-1], ends[1:], strict=True):
        band, strong = SOILS[numbers[row.soil.name] % len(SOILS)]
        ax.axvspan(start, end, color=band, lw=0)
        if row.soil.name and row.length > _NAMED * ends[-1]:
            places = [((start + end) / 2, share * height) for share in (0.08, 0.3, 0.5, 0.7, 0.9)]
            add_label(ax, row.soil.name, places, strong)
