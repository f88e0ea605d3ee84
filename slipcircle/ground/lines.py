"""Lines of straight edges over one another: their heights, slopes and crossings, (n or 1, V, 2), from left to right."""

import numpy as np

from slipcircle.base.kinds import Flags, Floats
from slipcircle.ground.plane import Vectors, each_lane


def line_crossings(one: Floats, other: Floats) -> Floats:
    """x where the edges of two lines (n or 1, V, 2) cross each other, (n, E1 E2); that of a vertex where they do not.

    The vertex is the second of the first line: the first one may be far outside, where a line is continued.
    """
    points = Vectors.of(one)
    others = Vectors.of(other)
    start = points.starts[:, :, None]
    edge = points.edges[:, :, None]
    other_edge = others.edges[:, None]
    other_start = others.starts[:, None]
    apart = other_start - start
    across = edge.cross(other_edge)
    parallel = across == 0.0
    divisor = np.where(parallel, 1.0, across)
    share = apart.cross(other_edge) / divisor
    other_share = apart.cross(edge) / divisor
    inside = _within_edge(share) & _within_edge(other_share)
    crosses = inside & ~parallel
    at_crossing = start.x + share * edge.x
    at_vertex = points.x[:, 1, None, None]
    x = np.where(crosses, at_crossing, at_vertex)
    return x.reshape(len(x), -1)


def _within_edge(share: Floats) -> Flags:
    """Whether a point lies between the ends of an edge, by its share of it."""
    after_start = share > 0.0
    before_end = share < 1.0
    return after_start & before_end


def edge_below(line: Floats, x: Floats, middle: Floats) -> tuple[Floats, Floats]:
    """y of lines (n or 1, V, 2) at x (n, M), and their slopes, of the edges below or above the points ``middle``."""
    of_points = each_lane(line, len(x))
    vertices = Vectors.of(of_points)
    place = middle[..., None]
    behind = vertices.x[:, None] <= place
    passed = np.count_nonzero(behind, axis=-1)
    last_edge = line.shape[1] - 2
    first = np.clip(passed - 1, 0, last_edge)
    circle = np.arange(len(x))[:, None]
    start = vertices[circle, first]
    end = vertices[circle, first + 1]
    edge = end - start
    upright = edge.x <= 0.0
    divisor = np.where(upright, 1.0, edge.x)
    steepness = edge.y / divisor
    slope = np.where(upright, 0.0, steepness)
    along = x - start.x
    return start.y + slope * along, slope
