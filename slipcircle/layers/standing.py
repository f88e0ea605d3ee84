"""Standing water: the weight of the water that a turning mass displaces below the level at its exit.

On a circle the pressure of standing water on the ground has the moment of this weight about the centre (Archimedes).
The effective weight in the normal stress is reduced in the same way: in the strip above a direction b of the mass lies
displaced water from the arc up to the ground or the level, whichever is lower. The level stays in space, so that in
the mass it is a line that turns backwards.
"""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.layers.profile import AREA, MOMENT_Y, RADIAL_X, RADIAL_Y, over_height

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
_FROM_FIRST = 1.0 + _NODES[:, None, None]
_TOGETHER = 1 << 18  # nodes at a time
_UPRIGHT = 1.5  # rad: greatest rotation for which the level is a line over the strips of the mass


def displaced(section: Any, rotation: Floats, directions: Floats) -> tuple[Floats, Floats]:
    """Weight of displaced water after rotations (M, circles), for a unit weight of water, over R^2 and R^3.

    Returns
    -------
    normal : ndarray
        Integral of its normal stress from the entry to directions (J, M, circles) of the mass, down-slope.
    moment : ndarray
        Its moment about the centre, positive down-slope, (M, circles).
    """
    normal = np.zeros(np.shape(directions))
    moment = np.zeros(np.shape(rotation))
    level = section.standing_level
    for circle in np.flatnonzero(np.isfinite(level)).tolist():
        surface = _surface(section, circle)
        blocks = -(-len(rotation) * len(surface) * _NODES.size // _TOGETHER)
        for rows in np.array_split(np.arange(len(rotation)), max(blocks, 1)):
            turned = np.clip(rotation[rows, circle], -_UPRIGHT, _UPRIGHT)
            of_rows = _of_circle(surface, level[circle], turned, directions[:, rows, circle])
            normal[:, rows, circle], moment[rows, circle] = of_rows
    return normal, moment


def _surface(section: Any, circle: int) -> Floats:
    """The ground over a mass from its entry to its exit, from the centre over R, x down-slope."""
    ground, centre, radius = section._circle
    facing = section._facing[circle]
    lines = ground[circle % len(ground)]
    line = (lines - centre[circle]) / radius[circle] * [facing, 1.0]
    down_slope = line[:: int(facing)]
    left, right = (end.points[circle] * [facing, 1.0] for end in section._ends)
    entry, exit_ = (left, right)[:: int(facing)]
    x = down_slope[:, 0]
    inside = (x > entry[0]) & (x < exit_[0])
    return np.concatenate([[entry], down_slope[inside], [exit_]])


def _of_circle(surface: Floats, level: float, rotation: Floats, directions: Floats) -> tuple[Floats, Floats]:
    """The same of one circle, with one axis less."""
    x, y = surface.T
    cosine = np.cos(rotation)
    sine = np.sin(rotation)

    def level_at(place: Floats) -> Floats:
        height: Floats = (level - place * sine) / cosine
        return height

    depth = y[:, None] - level_at(x[:, None])
    fall = depth[:-1] - depth[1:]
    share = depth[:-1] / np.where(fall == 0.0, np.inf, fall)
    crossing = x[:-1, None] + np.clip(share, 0.0, 1.0) * np.diff(x)[:, None]
    vertices = np.broadcast_to(x[:, None], depth.shape)
    of_ground = np.arcsin(np.clip(np.concatenate([vertices, crossing]), -1.0, 1.0))
    at_arc = np.arccos(np.clip(-level, -1.0, 1.0)) * np.array([[-1.0], [1.0]]) - rotation
    first, last = of_ground[0], of_ground[len(x) - 1]
    cuts = np.concatenate([of_ground, at_arc, directions])
    edges = np.sort(np.clip(cuts, first, last), axis=0)
    half = np.diff(edges, axis=0) / 2
    b = edges[:-1] + half * _FROM_FIRST
    place = np.sin(b)
    depth_of_arc = np.cos(b)
    top = np.minimum(np.interp(place, x, y), level_at(place))
    integrals = dict(over_height(depth_of_arc, np.maximum(top + depth_of_arc, 0.0)))
    per_node = half * _WEIGHTS[:, None, None] * depth_of_arc
    radial = integrals[RADIAL_Y] * cosine + place * integrals[RADIAL_X] * sine
    lever = integrals[MOMENT_Y] * sine - place * integrals[AREA] * cosine
    normal = -(radial * per_node).sum(axis=0)
    moment: Floats = (lever * per_node).sum(axis=(0, 1))
    middle = (edges[:-1] + edges[1:]) / 2
    before = middle < directions[:, None]
    return np.where(before, normal, 0.0).sum(axis=1), moment


def vertex_kinks(section: Any) -> Floats:
    """Rotations at which a vertex of the ground or an end of the mass passes the level, (circles, kinks)."""
    rows = []
    for circle, level in enumerate(section.standing_level):
        x, y = _surface(section, circle).T
        reach = np.arccos(np.clip(-level / np.hypot(x, y), -1.0, 1.0))
        direction = np.arctan2(x, -y)
        rows.append(np.concatenate([reach - direction, -reach - direction]))
    widest = max(map(len, rows))
    return np.stack([np.pad(row, (0, widest - len(row)), mode="edge") for row in rows])


def relieved(level: Floats, first: Floats, last: Floats) -> Floats:
    """Integral over arcs in space of the depth below a level, over R; directions are down-slope."""
    reach = np.arccos(np.clip(-level, -1.0, 1.0))
    start = np.clip(first, -reach, reach)
    end = np.clip(last, -reach, reach)
    still: Floats = np.where(np.isfinite(level), level, 0.0) * (end - start) + np.sin(end) - np.sin(start)
    return still
