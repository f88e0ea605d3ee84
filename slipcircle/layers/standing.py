"""Standing water: the weight of water that a turning mass displaces below the level at its exit.

On a circle the pressure of standing water on the ground has the moment of this weight about the centre (Archimedes).
The effective weight in the normal stress is reduced in the same way: the strip above a direction b of the mass
displaces water from the arc up to the ground or the level, whichever is lower. The level stays in space, so that it
turns backwards relative to the mass.
"""

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ArrayPair, Floats
from slipcircle.ground.plane import Vectors
from slipcircle.ground.water import turned_by
from slipcircle.layers.profile import MOMENT_X, MOMENT_Y, RADIAL_X, RADIAL_Y, over_height

_GAUSS = np.polynomial.legendre.leggauss(12)
_NODES = _GAUSS[0][:, None, None]
_WEIGHTS = _GAUSS[1][:, None, None]
_FROM_FIRST = 1.0 + _NODES
_PLACES = 33  # rotations at which it is checked whether standing water covers a part of a mass
_TOGETHER = 1 << 14  # vertices times rotations per block
_UPRIGHT = 1.5  # rad, greatest rotation for which the level is a line above the strips of the mass


def displaced(section: Any, rotation: Floats, directions: Floats) -> ArrayPair:
    """Return the weight of displaced water after rotations (M, circles), for a unit weight of water, over R^2 and R^3.

    Returns
    -------
    normal : ndarray
        Integral of its normal stress from the entry to directions (J, M, circles) of the mass, down-slope.
    moment : ndarray
        Its moment about the centre, positive down-slope, (M, circles).
    """
    normal = np.zeros(np.shape(directions))
    moment = np.zeros(np.shape(rotation))
    heights = section.standing_level
    ends = np.stack(section._span)
    every = np.arange(len(rotation))
    under_water = np.isfinite(heights)
    for circle in np.flatnonzero(under_water).tolist():
        surface = _surface(section, circle)
        first, last = ends[:, circle]
        blocks = 1 + len(every) * len(surface) // _TOGETHER
        for rows in np.array_split(every, blocks):
            turned = np.clip(rotation[rows, circle], -_UPRIGHT, _UPRIGHT)
            level = _Level(heights[circle], np.cos(turned), np.sin(turned))
            upto = directions[:, rows, circle]
            cuts = np.concatenate([_kinks(surface, level, turned), upto])
            cuts.sort(axis=0)
            integrals = _Integrals(surface, level, np.clip(cuts, first, last))
            to_directions = integrals.normal(upto)
            whole = integrals.moment
            normal[:, rows, circle] = to_directions
            moment[rows, circle] = whole
    return normal, moment


def _surface(section: Any, circle: int) -> Floats:
    """Return the ground relative to the centre of a circle, over R, with x down-slope, (V, 2).

    `circle` is the index.
    """
    ground, centre, radius = section._circle
    way = int(section._facing[circle])
    over_radius = (ground[circle % len(ground)] - centre[circle]) / radius[circle]
    return (over_radius * [way, 1.0])[::way]


class _Level(NamedTuple):
    """Level relative to the centre, over R, as a line in a mass that has turned."""

    height: float
    cosine: Floats
    sine: Floats

    def at(self, x: Floats) -> Floats:
        """Return the height of the level in the turned mass at x (..., M), over R."""
        fall = x * self.sine
        y = (self.height - fall) / self.cosine
        return y


def _kinks(surface: Floats, level: _Level, rotation: Floats) -> Floats:
    """Return directions of kinks of integrands: ends, vertices, and crossings of the level with ground or arc.

    The surface is (V, 2) over R, the rotations are (M,) in rad, and the result is (kinks, M) in rad.
    """
    x, y = surface.T[..., None]
    depth = y - level.at(x)
    fall = depth[:-1] - depth[1:]
    divisor = np.where(fall == 0.0, np.inf, fall)
    quotient = depth[:-1] / divisor
    share = np.clip(quotient, 0.0, 1.0)
    run = np.diff(x, axis=0)
    starts = x[:-1]
    crossing = starts + share * run
    vertices = np.broadcast_to(x, depth.shape)
    first_row = depth[:1]
    beyond = np.full_like(first_row, 2.0)
    sines = np.concatenate([-beyond, vertices, crossing, beyond])
    within = np.clip(sines, -1.0, 1.0)
    of_ground = np.arcsin(within)
    reach = _reach(level.height)
    before = reach - rotation
    after = -reach - rotation
    return np.concatenate([of_ground, [before], [after]])


def _reach(height: Any) -> Any:
    """Return the direction, rad in [0, pi], at which the arc passes a height over R relative to the centre."""
    cosine = np.clip(-height, -1.0, 1.0)
    return np.arccos(cosine)


class _Integrals:
    """Integrals over the arc of the displaced water of one circle, by Gauss' rule between edges (edges, M)."""

    def __init__(self, surface: Floats, level: _Level, edges: Floats) -> None:
        first = edges[:-1]
        width = np.diff(edges, axis=0)
        half = width / 2
        b = first + half * _FROM_FIRST
        x = np.sin(b)
        arc = np.cos(b)
        ground = np.interp(x, *surface.T)
        top = np.minimum(ground, level.at(x))
        height = np.maximum(top + arc, 0.0)
        rows = over_height(x, arc, height)
        self.rows = dict(rows)
        per_node = half * arc
        self.weight = per_node * _WEIGHTS
        middle = first + half
        self.middle = middle
        self.level = level

    def normal(self, directions: Floats) -> Floats:
        """Return the integral of the normal stress from the entry up to directions (J, M) in rad, of the same shape."""
        radial_y = self.rows[RADIAL_Y] * self.level.cosine
        radial_x = self.rows[RADIAL_X] * self.level.sine
        radial = radial_y + radial_x
        weighted = radial * self.weight
        in_intervals = weighted.sum(axis=0)
        limits = directions[:, None]
        before = self.middle < limits
        up_to = np.where(before, in_intervals, 0.0)
        normal = -up_to.sum(axis=1)
        return normal

    @property
    def moment(self) -> Floats:
        """Moment of the displaced water about the centre, over R^3 and positive down-slope, (M,)."""
        level = self.level
        moment_y = self.rows[MOMENT_Y] * level.sine
        moment_x = self.rows[MOMENT_X] * level.cosine
        lever = moment_y - moment_x
        weighted = lever * self.weight
        moment = weighted.sum(axis=(0, 1))
        return moment


def vertex_kinks(section: Any) -> Floats:
    """Return rotations at which a vertex of the ground or an end of the mass passes the level, (circles, kinks)."""
    heights = section.standing_level[:, None]
    every = np.stack([_surface(section, circle) for circle in range(len(heights))])
    x = every[..., 0]
    y = every[..., 1]
    distance = np.hypot(x, y)
    of_ground = np.arctan2(x, -y)
    at_vertices = _reach(heights / distance)
    at_ends = _reach(heights)
    ends = np.stack(section._span, axis=1)
    kinks = [at_vertices - of_ground, -at_vertices - of_ground, at_ends - ends, -at_ends - ends]
    return np.concatenate(kinks, axis=1)


def comes_to_cover(section: Any, reached: Any, end: Any) -> Any:
    """Return whether standing water comes to cover all of the mass, or leaves it, up to rotations, in their shape.

    `reached` and `end` are the farthest and the final rotation, rad.
    """
    visited = np.stack([reached, end, np.zeros_like(end)])
    between = np.linspace(visited.min(axis=0), visited.max(axis=0), _PLACES)
    turns = np.concatenate([visited[2:], between])
    shape, turned = turned_by(section, turns)
    first, last = section._span
    entry = first + turned
    exit_ = last + turned
    bottom = np.clip(0.0, entry, exit_)
    heights = section.standing_level
    lowest = -np.cos(bottom)
    highest = _highest(section, turned)
    is_dry = lowest > heights
    is_covered = highest < heights
    covered_at_start = is_covered[:1]
    comes_below = is_covered & ~covered_at_start
    has_water = np.isfinite(heights)
    passes = has_water & (is_dry | comes_below)
    by_rotation = passes.reshape(shape)
    return by_rotation.any(axis=0)


def _highest(section: Any, rotation: Floats) -> Floats:
    """Return the height of the highest point of the ground over the masses after rotations (M, circles), over R."""
    highest = np.empty_like(rotation)
    ends = np.stack(section._span, axis=1)
    for circle, span in enumerate(ends):
        x, y = _surface(section, circle).T
        left, right = np.sin(span)
        after_entry = x > left
        before_exit = x < right
        inside = after_entry & before_exit
        x = x[inside]
        y = y[inside]
        of_ground = np.arctan2(x, -y)
        distance = np.hypot(x, y)
        direction = np.concatenate([span, of_ground])
        radius = np.concatenate([[1.0, 1.0], distance])
        turned = direction[:, None] + rotation[:, circle]
        depth = radius[:, None] * np.cos(turned)
        least_depth = depth.min(axis=0)
        highest[:, circle] = -least_depth
    return highest


def relieved(level: Floats, first: Floats, last: Floats) -> Floats:
    """Return the integral over arcs in space of the depth below a level, over R, with directions down-slope.

    The level is a height over R relative to the centre. `first` and `last` are directions in rad.
    """
    reach = _reach(level)
    start = np.clip(first, -reach, reach)
    end = np.clip(last, -reach, reach)
    is_known = np.isfinite(level)
    finite = np.where(is_known, level, 0.0)
    above_level = finite * (end - start)
    below_centre = np.sin(end) - np.sin(start)
    integral = above_level + below_centre
    return integral


def displaced_height(section: Any, rotation: Any) -> Any:
    """Return the mean normal stress by displaced water less the hydrostatic one, over gamma_w R, after rotations."""
    shape, turned = turned_by(section, rotation)
    first, last = section._span
    to_exit = np.broadcast_to(last, (1, *turned.shape))
    (normal,), _ = displaced(section, turned, to_exit)
    hydrostatic = relieved(section.standing_level, first + turned, last + turned)
    taken = (normal - hydrostatic) / (last - first)
    return taken.reshape(shape)


def standing_moment(section: Any, rotation: Any) -> Any:
    """Return the moment of the weight of displaced water. See `Section.standing_moment`."""
    shape, turned = turned_by(section, rotation)
    nowhere = np.empty((0, *turned.shape))
    _, moment = displaced(section, turned, nowhere)
    lighter = np.divide(section.water_unit_weight, section.mean_unit_weight)
    of_weight = lighter / section.moments["moment_of_inertia"]
    by_rotation = moment.reshape(shape)
    return by_rotation[()] * of_weight


def drowned_depth(section: Any, rotations: Iterable[float]) -> float:
    """Return the greatest depth below the water level of the ground over the mass. See `Section.drowned`."""
    level = Vectors.of(np.asarray(section.level, float))
    (standing,) = section.standing_level
    lowest = section.centre[1] + section.radius * standing
    greatest = 0.0
    for rotation in rotations:
        x, y = section.placed(section.surface, rotation).T
        dry = np.maximum(y, lowest)
        turned = np.stack([x, dry], axis=1)
        depth = _depth_below(level, Vectors.of(turned))
        greatest = max(greatest, depth)
    return greatest


def _depth_below(level: Vectors, line: Vectors) -> float:
    """Return the greatest depth of a line below a level, at the vertices of both, m; at most 0 if it is above."""
    at_points = np.interp(line.x, level.x, level.y)
    below_level = at_points - line.y
    start = line.starts
    edge = line.edges
    vertex = level[:, None]
    with quiet():
        share = (vertex.x - start.x) / edge.x  # position of each vertex of the level on each edge
    on_edge = (share > 0.0) & (share < 1.0)
    height = start.y + share * edge.y
    below_vertices = np.where(on_edge, vertex.y - height, 0.0)
    return float(max(below_level.max(), below_vertices.max()))
