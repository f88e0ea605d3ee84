"""Section of the live page as SVG, to scale: ground and soils, water, slip circle, and the mass now and at the start.

The mass is one group, which the page turns about the centre of the slip circle.
"""

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats, Pair
from slipcircle.base.text import printed
from slipcircle.core import Arc, Motion
from slipcircle.workbench.common.markup import Raw, escaped
from slipcircle.workbench.outputs.pictures.plotstyle import SOILS
from slipcircle.workbench.outputs.pictures.scenery import Line, lines
from slipcircle.workbench.outputs.pictures.shapes import ON_ARC, Mass, View, mass_of

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
_STEPS = (1.0, 2.0, 5.0, 10.0)


class Section(NamedTuple):
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
        corner = np.array([self.view.left, self.view.top])
        downwards = np.array([self.scale, -self.scale])
        return (world - corner) * downwards

    def depth(self, height: float) -> float:
        """Return the depth below the top of the drawing for a height of the section in m."""
        return (self.view.top - height) * self.scale

    def path(self, world: Any, closed: bool = False) -> str:
        """Return a line through points of the section, with gaps at NaN, as the ``d`` attribute of an SVG path."""
        points = np.round(self.points(np.asarray(world, dtype=np.float64)), 2)
        gaps = np.flatnonzero(np.isnan(points[:, 0]))
        end = "Z" if closed else ""
        data = ""
        for part in np.split(points, gaps):
            is_point = np.isfinite(part[:, 0])
            places = part[is_point].tolist()
            data += "M" + "L".join(f"{x:.7g} {y:.7g}" for x, y in places) + end
        return data


def frame_around(motion: Motion, magnification: float) -> Frame:
    """Return the frame around the mass at the start and at its magnified run-out."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil, soil)
    rotation = float(motion.farthest.rotation) if motion.moves else 0.0
    turned = magnification * rotation * float(soil.facing)
    view = View.around(mass.outline(), mass.outline(turned))
    margin = _MARGIN * view.size
    view = view.grown(margin, margin)
    width = view.right - view.left
    height = view.top - view.bottom
    missing_height = max(_LOWEST * width - height, 0.0)
    missing_width = max(height / _TALLEST - width, 0.0)
    view = view._replace(bottom=view.bottom - missing_height)
    view = view.grown(missing_width / 2, 0.0)
    view = view._replace(bottom=_bottom_below_names(soil, view))
    scale = WIDTH / (view.right - view.left)
    return Frame(view, scale, scale * (view.top - view.bottom))


def _bottom_below_names(soil: Any, view: View) -> float:
    """Return the bottom of a view in m, lowered where the lowest visible soil is too thin for its name."""
    room = _NAME * (view.top - view.bottom)
    is_left = float(soil.facing) > 0.0
    named = [line for line in lines(mass_of(soil, soil), soil, view) if line.name and line.role not in _INSIDE]
    visible = [height for line in named if (height := _height(line, is_left, view)) > view.bottom]
    return min([view.bottom, *(height - room for height in visible)])


def section(motion: Motion, frame: Frame, magnification: float, name: str) -> Section:
    """Return the drawing of a motion in a frame; ``name`` is the prefix of the identifiers of its clipping paths."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil, soil)
    left, right = mass.ends.tolist()
    surface = _surface(mass, frame)
    along_arc = _onwards(mass, frame, right, left)
    outline = f"{surface}{along_arc}Z"
    around = [*lines(mass, soil, frame.view)]
    top = around[0].points if isinstance(soil, Arc) else mass.ground
    ground = _area(top, min(frame.view.bottom, float(top[:, 1].min())), frame)
    bands = "".join(_bands(around, frame))
    parts = [
        f'<clipPath id="{name}-ground">{_path("", ground)}</clipPath>',
        f'<clipPath id="{name}-mass">{_path("", outline)}</clipPath>',
        _path("soil", ground),
        f'<g clip-path="url(#{name}-ground)">{bands}</g>',
        _path("scar", outline),
        *_ponds(around, frame),
        *_drawn(around, frame, "firm", "beyond"),
        _path("circle", _continued(mass, frame)),
        '<g class="mass">',
        _path("body", outline),
        f'<g clip-path="url(#{name}-mass)">{bands}</g>',
        _path("edge", outline),
        "</g>",
        _path("slip", _stretch(mass, frame, left, right)),
        _path("ghost", surface),
        *_drawn(around, frame, "water", "surcharge"),
        *_names(around, float(soil.facing) > 0.0, frame),
    ]
    x, y = frame.points(mass.centre).tolist()
    turn = -math.degrees(magnification * float(soil.facing) / mass.radius)
    return Section("".join(parts), (x, y), turn)


def _path(kind: str, data: str) -> str:
    return f'<path class="{kind}" d="{data}" />'


# --- circle and mass -------------------------------------------------------------------------------------------------


def _stretch(mass: Mass, frame: Frame, first: float, last: float) -> str:
    """Return the circle from one polar angle to another as the ``d`` attribute of a path."""
    x, y = frame.points(mass.on_circle(first)).tolist()
    onwards = _onwards(mass, frame, first, last)
    return f"M{x:.3f} {y:.3f}{onwards}"


def _onwards(mass: Mass, frame: Frame, first: float, last: float) -> str:
    """Return the arc command that continues a path from one polar angle of the circle to another."""
    end = mass.on_circle(last)
    x, y = frame.points(end).tolist()
    radius = mass.radius * frame.scale
    opening = abs(last - first)
    is_large = int(opening > math.pi)
    is_clockwise = int(last < first)
    return f"A{radius:.9g} {radius:.9g} 0 {is_large} {is_clockwise} {x:.3f} {y:.3f}"


def _continued(mass: Mass, frame: Frame) -> str:
    """Return the circle beyond both ends of the arc, along which the mass is assumed to continue, as path data."""
    first, last = mass.ends.tolist()
    opening = last - first
    beyond = min(opening, (2 * math.pi - opening) / 2)
    before = _stretch(mass, frame, first - beyond, first)
    after = _stretch(mass, frame, last, last + beyond)
    return before + after


def _surface(mass: Mass, frame: Frame) -> str:
    """Return the ground over the mass, from its left to its right end, as path data."""
    left, right = mass.on_circle(mass.ends)
    leftwards = mass.outline()[ON_ARC:]
    return frame.path([left, *leftwards[::-1], right])


# --- ground, soils and water -----------------------------------------------------------------------------------------


def _area(line: Floats, bottom: float, frame: Frame) -> str:
    """Return the area between a line, (n, 2), and the height ``bottom`` as path data."""
    left, right = line[[0, -1], 0]
    return frame.path([*line, [right, bottom], [left, bottom]], closed=True)


def _bands(around: Iterable[Line], frame: Frame) -> Iterator[str]:
    """Yield the soils of a layered section as areas, each from its top down to the bottom of the view."""
    for line in around:
        if line.soil is not None:
            area = _area(_corners(line.points), frame.view.bottom, frame)
            yield _path(f"band band-{line.soil % len(SOILS)}", area)


def _ponds(around: Iterable[Line], frame: Frame) -> Iterator[str]:
    """Yield free water as areas down to the ground."""
    for line in around:
        if line.lower is not None:
            ground = np.stack([line.points[:, 0], line.lower], axis=-1)
            yield _path(line.role, frame.path([*line.points, *ground[::-1]], closed=True))


def _corners(line: Floats) -> Floats:
    """Return the ends of a line, (n, 2), and the vertices at which it bends."""
    slopes = np.diff(line[:, 1]) / np.diff(line[:, 0])
    bends = np.abs(np.diff(slopes)) > _STRAIGHT
    return line[np.concatenate([[True], bends, [True]])]


def _drawn(around: Iterable[Line], frame: Frame, *roles: str) -> Iterator[str]:
    """Yield the lines with one of the roles as SVG paths."""
    for line in around:
        if line.role in roles:
            yield _path(line.role, frame.path(line.points))


# --- names and axes --------------------------------------------------------------------------------------------------


def _names(around: Iterable[Line], is_left: bool, frame: Frame) -> Iterator[str]:
    """Yield names of lines at the upper side of the slope as SVG texts, which the script moves to their lines."""
    edge = _INSET if is_left else WIDTH - _INSET
    side = "start" if is_left else "end"
    named = [(_height(line, is_left, frame.view), line) for line in around if line.name]
    for height, line in sorted(named, key=lambda pair: -pair[0]):
        depth = frame.depth(height)
        if not 0.0 <= depth <= frame.height or line.role == "beyond":
            continue
        x, anchor = edge, side
        if line.role in _INSIDE:
            x, anchor = frame.points(line.places.mean(axis=0))[0], "middle"
        place = f'x="{x:.4g}" y="{depth:.1f}" dy="1.1em" text-anchor="{anchor}"'
        yield f'<text class="name of-{line.role}" data-line="{depth:.1f}" {place}>{escaped(line.name)}</text>'


def _height(line: Line, is_left: bool, view: View) -> float:
    """Return the height in m of a line at the side of the names; for lines inside the view, their greatest height."""
    if line.role in _INSIDE:
        return float(np.max(line.places[:, 1]))
    return float(np.interp(view.left if is_left else view.right, *line.points.T))


def axes(frame: Frame, names_left: bool) -> Raw:
    """Return ticks along the bottom and both sides as SVG, with numbers on the side opposite the names."""
    along_bottom = "".join(_bottom_axis(frame))
    along_sides = "".join(_side_axes(frame, names_left))
    return Raw(along_bottom + along_sides)


def _bottom_axis(frame: Frame) -> Iterator[str]:
    """Yield ticks and numbers along the bottom."""
    view = frame.view
    above = frame.height - _INSET
    factor, unit = printed("m")
    for x in _round_numbers(factor * view.left, factor * view.right, _TICKS[0]):
        across = (x / factor - view.left) * frame.scale
        yield _path("tick", f"M{across:.1f} {frame.height:.1f}v-9")
        yield f'<text class="unit" x="{across:.1f}" y="{above:.1f}">{x:g} {unit}</text>'


def _side_axes(frame: Frame, names_left: bool) -> Iterator[str]:
    """Yield ticks along both sides, and numbers on the side opposite the names."""
    view = frame.view
    side = "side" if names_left else "side left"
    edge = WIDTH - _INSET if names_left else _INSET
    factor, unit = printed("m")
    for y in _round_numbers(factor * view.bottom, factor * view.top, _TICKS[1]):
        down = frame.depth(y / factor)
        yield _path("tick", f"M{WIDTH:g} {down:.1f}h-9M0 {down:.1f}h9")
        yield f'<text class="unit {side}" x="{edge:g}" y="{down:.1f}">{y:g} {unit}</text>'


def _round_numbers(low: float, high: float, most: int) -> list[float]:
    """Return at most ``most`` round numbers between two bounds, away from both of them."""
    span = high - low
    least = span / most
    power = 10.0 ** math.floor(math.log10(least))
    step = next(power * n for n in _STEPS if power * n >= least)
    free_below, free_above = _FREE
    lowest = low + free_below * span
    highest = high - free_above * span
    first = math.ceil(lowest / step)
    last = math.floor(highest / step)
    return [n * step + 0.0 for n in range(first, last + 1)]
