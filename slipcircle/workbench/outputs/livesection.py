"""The section of the live page as SVG, to scale: ground and soils, water, slip circle, the mass and where it was.

The mass is one group, which the page turns about the centre of the slip circle.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.core import Arc, LayeredSection, Motion
from slipcircle.workbench.common.markup import Raw, escaped
from slipcircle.workbench.outputs.sectionplot import magnified
from slipcircle.workbench.outputs.shapes import Mass, View, mass_of
from slipcircle.workbench.outputs.trace import Floats

WIDTH = 1000.0  # of the drawing, in its own unit
_LOWEST, _TALLEST = 0.42, 0.5  # its height over its width
_MARGIN = 0.08  # of the view
_TICKS = 6, 4  # of the axes, at most
_COLUMNS = 200  # places at which a boundary between soils is drawn
_STEPS = (1.0, 2.0, 5.0, 10.0)


class Section(NamedTuple):
    """One section as SVG, and about which point and how far it turns its mass for a metre of displacement, deg."""

    drawing: str
    centre: tuple[float, float]
    turn: float


class Frame(NamedTuple):
    """What of the world is in the drawing, and how it gets there."""

    view: View
    scale: float  # of the drawing for a metre
    height: float

    def points(self, world: Any) -> Floats:
        """Points of the world, (..., 2), in the drawing, whose y is downwards."""
        x, y = np.moveaxis(np.asarray(world, dtype=np.float64), -1, 0)
        return np.stack([(x - self.view.left) * self.scale, (self.view.top - y) * self.scale], axis=-1)

    def path(self, world: Any, closed: bool = False) -> str:
        """A line through points of the world as the data of a path."""
        places = (f"{x:.7g} {y:.7g}" for x, y in np.round(self.points(world), 2).tolist())
        return "M" + "L".join(places) + "Z" * closed


def frame_around(motions: Sequence[Motion]) -> Frame:
    """The frame that holds the masses of all motions, where they start and where they are farthest."""
    outlines = []
    magnification = common_magnification(motions)
    for motion in motions:
        soil = motion.plan.scene.arc
        mass = mass_of(soil, soil)
        farthest = float(motion.reach.rotation) if motion.moves else 0.0
        outlines += [mass.outline(), mass.outline(magnification * farthest * float(soil.facing))]
    view = View.around(*outlines)
    margin = _MARGIN * view.size
    view = view.grown(margin, margin)
    width, height = view.right - view.left, view.top - view.bottom
    missing = max(_LOWEST * width - height, 0.0)
    view = view._replace(bottom=view.bottom - missing)
    beside = max(height / _TALLEST - width, 0.0) / 2
    view = view.grown(beside, 0.0)
    scale = WIDTH / (view.right - view.left)
    return Frame(view, scale, scale * (view.top - view.bottom))


def common_magnification(motions: Sequence[Motion]) -> float:
    """How many times as large displacements are drawn: as much as the farthest of the motions needs."""
    farthest = max(motions, key=lambda motion: abs(float(motion.reach.rotation)) if motion.moves else 0.0)
    return magnified(farthest)


def section(motion: Motion, frame: Frame, magnification: float, name: str) -> Section:
    """The section of a motion in a frame; the name is in the identifiers of its clipping paths."""
    soil = motion.plan.scene.arc
    mass = mass_of(soil, soil)
    left, right = (float(angle) for angle in mass.ends)
    surface = _surface(mass, frame)
    outline = f"{surface}{_onwards(mass, frame, right, left)}Z"
    bands = "".join(_bands(soil, frame))
    parts = [
        f'<clipPath id="{name}-ground"><path d="{_ground(mass, soil, frame)}" /></clipPath>',
        f'<clipPath id="{name}-mass"><path d="{outline}" /></clipPath>',
        f'<path class="soil" d="{_ground(mass, soil, frame)}" />',
        f'<g clip-path="url(#{name}-ground)">{bands}</g>',
        f'<path class="scar" d="{outline}" />',
        *_firm_layer(soil, frame),
        f'<path class="circle" d="{_continued(mass, frame)}" />',
        f'<g class="mass"><path class="body" d="{outline}" />',
        f'<g clip-path="url(#{name}-mass)">{bands}</g><path class="edge" d="{outline}" /></g>',
        f'<path class="slip" d="{_stretch(mass, frame, left, right)}" />',
        f'<path class="ghost" d="{surface}" />',
        *_water(soil, frame),
        *_names(soil, frame),
    ]
    x, y = frame.points(mass.centre).tolist()
    turn = -math.degrees(magnification * float(soil.facing) / mass.radius)
    return Section("".join(parts), (x, y), turn)


# --- circle and mass -------------------------------------------------------------------------------------------------


def _stretch(mass: Mass, frame: Frame, first: float, last: float) -> str:
    """The circle from one polar angle to another, as the data of a path."""
    x, y = frame.points(mass.on_circle(first)).tolist()
    return f"M{x:.3f} {y:.3f}{_onwards(mass, frame, first, last)}"


def _onwards(mass: Mass, frame: Frame, first: float, last: float) -> str:
    """The same where the path has come to its beginning."""
    x, y = frame.points(mass.on_circle(last)).tolist()
    radius = mass.radius * frame.scale
    large, clockwise = int(abs(last - first) > math.pi), int(last < first)
    return f"A{radius:.9g} {radius:.9g} 0 {large} {clockwise} {x:.3f} {y:.3f}"


def _continued(mass: Mass, frame: Frame) -> str:
    """The circle beyond both ends of the arc, as far as the mass may follow it."""
    first, last = (float(angle) for angle in mass.ends)
    beyond = min(last - first, (2 * math.pi - (last - first)) / 2)
    return _stretch(mass, frame, first - beyond, first) + _stretch(mass, frame, last, last + beyond)


def _surface(mass: Mass, frame: Frame) -> str:
    """The ground over the mass, from its left to its right end."""
    ends, above = mass.on_circle(mass.ends), mass.outline()[mass.arc.shape[0] :]
    return frame.path(np.concatenate([ends[:1], above[::-1], ends[1:]]))


# --- ground, soils and water -----------------------------------------------------------------------------------------


def _line(mass: Mass, soil: Any, frame: Frame) -> Floats:
    """The surface of the ground from left to right; of an arc its chord, continued to the edges of the view."""
    if not isinstance(soil, Arc):
        return mass.ground
    (x_1, y_1), (x_2, y_2) = mass.ground
    edges = np.array([frame.view.left, frame.view.right])
    heights = y_1 + (edges - x_1) * (y_2 - y_1) / (x_2 - x_1)
    return np.stack([edges, heights], axis=-1)


def _ground(mass: Mass, soil: Any, frame: Frame) -> str:
    """The ground as an area, down to the bottom of the view."""
    line = _line(mass, soil, frame)
    bottom = min(frame.view.bottom, float(line[:, 1].min()))
    corners = [[line[-1, 0], bottom], [line[0, 0], bottom]]
    return frame.path(np.concatenate([line, corners]), closed=True)


def _bands(soil: Any, frame: Frame) -> Iterator[str]:
    """The soils below the first as areas, each from its top down to the bottom of the view."""
    for number, top in enumerate(_tops(soil, frame)[1:], 1):
        x, _ = top.T
        corners = [[x[-1], frame.view.bottom], [x[0], frame.view.bottom]]
        area = frame.path(np.concatenate([top, corners]), closed=True)
        yield f'<path class="band band-{number % 5}" d="{area}" />'


def _tops(soil: Any, frame: Frame) -> list[Floats]:
    """The tops of the soils of a layered section; what rises above the boundary before it is cut off there."""
    if not isinstance(soil, LayeredSection):
        return []
    ground = np.asarray(soil.ground, dtype=np.float64)
    x = np.linspace(frame.view.left, frame.view.right, _COLUMNS)
    lines = [ground, *(np.asarray(top, dtype=np.float64) for _, top in soil.layers[1:])]
    x = np.unique(np.concatenate([x, *(line[:, 0] for line in lines if line.ndim == 2)]))
    x = x[(x >= frame.view.left) & (x <= frame.view.right)]
    tops = []
    height = np.full(x.shape, np.inf)
    for line in lines:
        here = np.full(x.shape, float(line)) if line.ndim == 0 else np.interp(x, *line.T)
        height = np.minimum(height, here)
        tops.append(np.stack([x, height], axis=-1))
    return tops


def _firm_layer(soil: Any, frame: Frame) -> Iterator[str]:
    base = getattr(soil, "base", None)
    if base is not None:
        ends = [[frame.view.left, base], [frame.view.right, base]]
        yield f'<path class="firm" d="{frame.path(ends)}" />'


def _water(soil: Any, frame: Frame) -> Iterator[str]:
    level = _level(soil, frame)
    if level is not None:
        yield f'<path class="water" d="{frame.path(level)}" />'


def _level(soil: Any, frame: Frame) -> Floats | None:
    """The water level, horizontal beyond its ends."""
    if getattr(soil, "level", None) is None:
        return None
    level = np.asarray(soil.level, dtype=np.float64)
    left, right = level[0].copy(), level[-1].copy()
    left[0], right[0] = min(left[0], frame.view.left), max(right[0], frame.view.right)
    return np.concatenate([[left], level, [right]])


# --- names and axes --------------------------------------------------------------------------------------------------


def _names(soil: Any, frame: Frame) -> Iterator[str]:
    """Names of soils, water and firm layer, at the upper side of the slope, below their lines."""
    uphill_left = float(soil.facing) > 0.0
    x = frame.view.left if uphill_left else frame.view.right
    named: list[tuple[float, str, str]] = []
    tops = _tops(soil, frame)
    for number, (top, layer) in enumerate(zip(tops, getattr(soil, "layers", ()), strict=False)):
        named.append((float(top[0 if uphill_left else -1, 1]), layer[0].name or f"soil {number + 1}", "name"))
    level = _level(soil, frame)
    if level is not None:
        named.append((float(np.interp(x, *level.T)), "water level", "name of-water"))
    if getattr(soil, "base", None) is not None:
        named.append((float(soil.base), "firm layer", "name"))
    edge, anchor = (12.0, "start") if uphill_left else (WIDTH - 12.0, "end")
    for height, words, kind in sorted(named, reverse=True):
        y = (frame.view.top - height) * frame.scale  # of the line, below which the page puts the name
        if 0.0 <= y <= frame.height:
            place = f'x="{edge:g}" y="{y:.1f}" dy="1.1em" data-line="{y:.1f}" text-anchor="{anchor}"'
            yield f'<text class="{kind}" {place}>{escaped(words)}</text>'


def axes(frame: Frame, names_left: bool) -> Raw:
    """Ticks in metres along the bottom and both sides, with numbers on the side that has no names."""
    view, parts = frame.view, []
    side, edge = ("side", WIDTH - 12.0) if names_left else ("side left", 12.0)
    for x in _round_numbers(view.left, view.right, _TICKS[0]):
        place = (x - view.left) * frame.scale
        parts.append(f'<path class="tick" d="M{place:.1f} {frame.height:.1f}v-9" />')
        parts.append(f'<text class="unit" x="{place:.1f}" y="{frame.height - 12:.1f}">{x:g} m</text>')
    for y in _round_numbers(view.bottom, view.top, _TICKS[1]):
        place = (view.top - y) * frame.scale
        parts.append(f'<path class="tick" d="M{WIDTH:g} {place:.1f}h-9M0 {place:.1f}h9" />')
        parts.append(f'<text class="unit {side}" x="{edge:g}" y="{place:.1f}">{y:g} m</text>')
    return Raw("".join(parts))


def _round_numbers(low: float, high: float, most: int) -> list[float]:
    """At most so many round numbers between two, away from both."""
    least = (high - low) / most
    power = 10.0 ** math.floor(math.log10(least))
    step = next(power * n for n in _STEPS if power * n >= least)
    first = math.ceil((low + 0.08 * (high - low)) / step)
    last = math.floor((high - 0.06 * (high - low)) / step)
    return [n * step + 0.0 for n in range(first, last + 1)]
