"""Section of the live page as SVG, to scale: ground and soils, water, slip circle, and the mass now and at the start.

The mass is one group, which the page turns about the centre of the slip circle.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats, Pair
from slipcircle.base.text import output_unit
from slipcircle.core import Arc, Motion
from slipcircle.workbench.common.markup import Raw, escaped
from slipcircle.workbench.outputs.pictures.plotstyle import SOILS
from slipcircle.workbench.outputs.pictures.scenery import Line, scenery_lines
from slipcircle.workbench.outputs.pictures.shapes import ON_ARC, MassShape, View, mass_of

WIDTH = 1000.0  # width of the drawing in its own unit
_LOWEST = 0.42  # least height over width
_TALLEST = 0.5  # greatest height over width
_MARGIN = 0.08  # of the view
_TICKS = 6, 4  # greatest numbers of ticks of the axes
_INSET = 12.0  # distance of names and numbers from the edges
_NAME = 0.11  # space for a name below its line on a narrow screen, relative to the height
_FREE = 0.08, 0.06  # parts of an axis without numbers at its two ends
_STRAIGHT = 1e-6  # least change of slope at a vertex of a line
_INSIDE = ("surcharge", "pond", "beyond")  # lines with their names at their middle
_STEPS = np.array([1.0, 2.0, 5.0, 10.0])


class DrawnSection(NamedTuple):
    """Section as SVG, the centre in the drawing about which its mass turns, and its turn in deg per metre."""

    drawing: str
    centre: Pair
    turn: float


class Frame(NamedTuple):
    """Visible part of the section, its scale and its height in the drawing."""

    view: View
    scale: float  # units of the drawing per metre
    height: float

    def points(self, world: Any) -> Floats:
        """Return points of the section, (..., 2) in m, in coordinates of the drawing, whose y is downwards."""
        return (world - np.array([self.view.left, self.view.top])) * [self.scale, -self.scale]

    def path(self, kind: str, world: Any, closed: bool = False, arc: str = "") -> str:
        """Return an SVG path of a CSS class, ``kind``: a line through points (n, 2) in m, with gaps at NaN.

        ``world`` are the points, and ``arc`` further commands of the path.
        """
        points = self.points(np.asarray(world, dtype=np.float64))
        data = ""
        is_gap = np.isnan(points[:, 0])
        for part in np.split(points, np.flatnonzero(is_gap)):
            ends = part[np.isfinite(part[:, 0])].tolist()
            data += "M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in ends)
            data += "Z" * closed
        return f'<path class="{kind}" d="{data}{arc}" />'

    def area(self, kind: str, line: Floats, bottom: float) -> str:
        """Return the area between a line, (n, 2), and a height, both in m, as an SVG path of a CSS class (``kind``)."""
        run, rise = np.diff(line, axis=0).T
        turns = np.abs(np.diff(rise / run)) > _STRAIGHT
        corners = line[np.pad(turns, 1, constant_values=True)]
        (left, _), (right, _) = line[[0, -1]]
        return self.path(kind, [*corners, [right, bottom], [left, bottom]], closed=True)


def frame_around(motion: Motion, magnification: float) -> Frame:
    """Return the frame around the mass at the start and at its run-out, drawn ``magnification`` times as large."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil)
    if motion.moves:
        rotation = float(motion.farthest.rotation)
    else:
        rotation = 0.0
    view = View.around(mass.outline(), mass.outline(magnification * rotation * float(soil.facing)))
    view = view.grown(_MARGIN * view.size, _MARGIN * view.size)
    view = view._replace(bottom=min(view.bottom, view.top - _LOWEST * view.width))
    view = view.grown(max(view.height / _TALLEST - view.width, 0.0) / 2, 0.0)
    # Lower where the lowest visible soil is too thin for its name.
    named = [line for line in scenery_lines(mass, soil, view) if line.name and line.role not in _INSIDE]
    heights = [height for line in named if (height := _height(line, float(soil.facing) > 0.0, view)) > view.bottom]
    view = view._replace(bottom=min([view.bottom, *(height - _NAME * view.height for height in heights)]))
    scale = WIDTH / view.width
    return Frame(view, scale, scale * view.height)


def drawn_section(motion: Motion, frame: Frame, magnification: float, name: str) -> DrawnSection:
    """Return the drawing of a motion in a frame; ``name`` is the prefix of the identifiers of its clipping paths."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil)
    around = [*scenery_lines(mass, soil, frame.view)]
    if isinstance(soil, Arc):
        top = around[0].points
    else:
        top = mass.ground
    ground, soils = (frame.area(kind, top, min(frame.view.bottom, top[:, 1].min())) for kind in ("", "soil"))
    layers = [(line.soil % len(SOILS), line.points) for line in around if line.soil is not None]
    bands = "".join(frame.area(f"band band-{number}", points, frame.view.bottom) for number, points in layers)
    parts = [
        f'<clipPath id="{name}-ground">{ground}</clipPath>{soils}<g clip-path="url(#{name}-ground)">{bands}</g>',
        *_mass(mass, frame, bands, f"{name}-mass", _drawn(around, frame, "pond", "firm", "beyond")),
        *_drawn(around, frame, "water", "surcharge"),
        *_names(around, float(soil.facing) > 0.0, frame),
    ]
    x, y = frame.points(mass.centre).tolist()
    return DrawnSection("".join(parts), (x, y), -math.degrees(magnification * float(soil.facing) / mass.radius))


def _mass(mass: MassShape, frame: Frame, bands: str, name: str, behind: Iterable[str]) -> Iterator[str]:
    """Yield the scar, lines behind the mass, slip circle, mass with bands, and the ground over it, as SVG.

    ``bands`` are the soils and ``behind`` these lines, as SVG; ``name`` identifies the clipping path.
    """
    first, last = mass.ends
    opening = last - first
    beyond = min(opening, math.pi - opening / 2)  # the mass is assumed to continue along its circle
    arc = mass.arc
    surface = [arc[0], *mass.outline()[: ON_ARC - 1 : -1], arc[-1]]
    radius = f"{mass.radius * frame.scale:.9g}"
    x, y = frame.points(arc[0]).tolist()
    back = f"A{radius} {radius} 0 {int(opening > math.pi)} 1 {x:.3f} {y:.3f}"
    scar, clip, body, edge = (frame.path(kind, surface, arc=f"{back}Z") for kind in ("scar", "", "body", "edge"))
    yield from (scar, *behind)
    yield frame.path("circle", mass.on_circle(np.linspace(first - beyond, last + beyond, 40)))
    yield f'<clipPath id="{name}">{clip}</clipPath>'
    yield f'<g class="mass">{body}<g clip-path="url(#{name})">{bands}</g>{edge}</g>'
    yield from (frame.path("slip", arc[-1:], arc=back), frame.path("ghost", surface))


def _drawn(around: Sequence[Line], frame: Frame, *roles: str) -> Iterator[str]:
    """Yield the lines of ``around`` with one of the roles as SVG paths, free water as an area down to the ground."""
    for line in around:
        if line.role in roles:
            points = line.points
            if line.lower is not None:
                bottom = np.column_stack([points[:, 0], line.lower])
                points = np.concatenate([points, bottom[::-1]])
            yield frame.path(line.role, points, closed=line.lower is not None)


# --- names and axes --------------------------------------------------------------------------------------------------


def _names(around: Sequence[Line], is_left: bool, frame: Frame) -> Iterator[str]:
    """Yield names of lines at the upper side of the slope as SVG texts, which the script moves to their lines.

    ``is_left`` says that this is the left side.
    """
    edge, side = (_INSET, "start") if is_left else (WIDTH - _INSET, "end")
    named = [(_height(line, is_left, frame.view), line) for line in around if line.name and line.role != "beyond"]
    for height, line in sorted(named, key=lambda pair: -pair[0]):
        _, depth = frame.points([0.0, height])
        if 0.0 <= depth <= frame.height:
            is_inside = line.role in _INSIDE
            x, anchor = (frame.points(line.places.mean(axis=0))[0], "middle") if is_inside else (edge, side)
            place = f'x="{x:.4g}" y="{depth:.1f}" dy="1.1em" text-anchor="{anchor}"'
            yield f'<text class="name of-{line.role}" data-line="{depth:.1f}" {place}>{escaped(line.name)}</text>'


def _height(line: Line, is_left: bool, view: View) -> float:
    """Return the height in m of a line at the side of the names; for lines inside the view, their greatest height."""
    if line.role in _INSIDE:
        return float(np.max(line.places[:, 1]))
    return float(np.interp(view.left if is_left else view.right, *line.points.T))


def section_ticks(frame: Frame, names_left: bool) -> Raw:
    """Return ticks along the bottom and both sides as SVG, with numbers on the side opposite the names.

    ``names_left`` says that the names are at the left.
    """
    view = frame.view
    factor, unit = output_unit("m")
    drawn = ""
    for x in _round_numbers(factor * view.left, factor * view.right, _TICKS[0]):
        across, _ = frame.points([x / factor, 0.0])
        drawn += f'<path class="tick" d="M{across:.1f} {frame.height:.1f}v-9" />'
        drawn += f'<text class="unit" x="{across:.1f}" y="{frame.height - _INSET:.1f}">{x:g} {unit}</text>'
    side, edge = ("side", WIDTH - _INSET) if names_left else ("side left", _INSET)
    for y in _round_numbers(factor * view.bottom, factor * view.top, _TICKS[1]):
        _, down = frame.points([0.0, y / factor])
        drawn += f'<path class="tick" d="M{WIDTH:g} {down:.1f}h-9M0 {down:.1f}h9" />'
        drawn += f'<text class="unit {side}" x="{edge:g}" y="{down:.1f}">{y:g} {unit}</text>'
    return Raw(drawn)


def _round_numbers(low: float, high: float, most: int) -> list[float]:
    """Return at most ``most`` equidistant round numbers between ``low`` and ``high``, away from both of them."""
    span = high - low
    steps = _STEPS * 10.0 ** math.floor(math.log10(span / most))
    step = float(steps[steps >= span / most][0])
    first = math.ceil((low + _FREE[0] * span) / step)
    last = math.floor((high - _FREE[1] * span) / step)
    return [n * step + 0.0 for n in range(first, last + 1)]
