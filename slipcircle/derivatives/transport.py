"""How the integrals of a section change with the coordinates of its ground, its circle and its water level.

Seen from the centre, over R, the arc rests and only vertices move. By Reynolds' transport theorem the integral of f
over the mass changes by that of f (v x ds) along the ground inside the circle, where the velocity v is linear between
the vertices of an edge; at the arc, and where ground and arc meet, nothing is added. f is the integrand of each
definition: r and r^2 of (2.17) and (3.12), the unit vector and the vector from the centre of (2.23) and (3.13). The
ends of the arc move along it as the ground's edges cross it. Integrals of heights above the arc change with the
vertices of their line and with these ends.

Of a circle through a vertex the derivatives are those towards the side on which the vertex lies outside the mass.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats, Integers
from slipcircle.core.scene.coordinates import indices_of
from slipcircle.ground.heights import HeightIntegrals, height_integrals
from slipcircle.ground.plane import Vectors
from slipcircle.ground.section import Section

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)
_Chain = Callable[[Floats, Floats, str], Floats]  # derivatives by numbers, of those by vertices of a line


class SectionDerivatives(NamedTuple):
    """Derivatives by numbers of a section, one a column."""

    moments: Mapping[str, Floats]  # of each integral of `circles.MEASURES` but the area
    heights: Floats  # of the integral of the ground's height above the arc, over R
    ends: Floats  # of the angles of both ends of the arc, (2, numbers), rad
    pressure: Callable[[Any], Any]  # of the mean pressure below the water level, Pa, after rotations (..., numbers)


class _Surface(NamedTuple):
    """The edges of the ground over the mass, and the parts of them that lie inside the circle, (k,), over R."""

    vertex: Integers  # number of an edge's first vertex
    edge: Vectors
    start: Vectors  # of the part inside
    part: Vectors
    skipped: Floats  # share of the edge before that part
    share: Floats  # and of the part


def active_parameters(section: Section) -> list[str]:
    """The numbers of a single section that its motion depends on; of the ground those of the edges above the arc."""
    vertices = _vertices_above(section)
    names = []
    for field in section.quantities:
        for name, index in indices_of(section, field).items():
            if field != "ground" or index[0] in vertices:
                names.append(name)
    return names


def _vertices_above(section: Section) -> range:
    """Of the edges over the mass, or, where the arc overhangs, over all of it."""
    edges = np.flatnonzero(section._edges_over_mass)
    widest = np.abs(section._angles).max()
    if widest > np.pi / 2:
        vertices, _ = np.shape(section.ground)
        above = _ground_heights(section).edge - 1
        of_ground = np.clip(above, 0, vertices - 2)
        edges = np.unique(of_ground)
    first = edges[0]
    last = edges[-1]
    return range(first, last + 2)


def through_vertex(section: Section) -> bool:
    """Whether an end of the arc of a single section is a vertex of its ground."""
    ends = np.array([section.entry, section.exit])
    end = ends[:, None]
    ground, _, _ = section._circle
    same_coordinate = np.isclose(end, ground, rtol=1e-14, atol=0.0)
    same_point = same_coordinate.all(axis=2)
    return bool(np.any(same_point))


def section_derivatives(section: Section, names: Sequence[str]) -> SectionDerivatives:
    """Derivatives of a single section by its numbers, to some 1e-14 of each moment over the length that moves."""
    chain = _chain_rule(section, names)
    (points,), (centre,), (radius,) = section._circle
    from_centre = points - centre
    ground = from_centre / radius
    vertices = len(ground)
    surface = _surface(section, Vectors.of(ground))
    by_vertex = _moments_by_vertex(surface, vertices)
    moments = {name: chain(values, ground, "ground") for name, values in by_vertex.items()}
    angles = np.concatenate(section._angles)
    ends_by_vertex = _ends_by_vertex(surface, angles, vertices)
    ends = chain(ends_by_vertex, ground, "ground")

    above = _ground_heights(section)
    first, last = angles
    first_height, last_height = above.at(angles)
    heights_by_vertex = above.gradient(first, last)
    by_ground = chain(heights_by_vertex, ground, "ground")
    first_by_numbers, last_by_numbers = ends
    by_last = last_height * last_by_numbers
    by_first = first_height * first_by_numbers
    heights = by_ground + by_last - by_first
    is_radius = [float(name == "radius") for name in names]
    of_scale = np.array(is_radius) / radius
    pressure = _pressure(section, ends, chain, of_scale)
    return SectionDerivatives(moments, heights, ends, pressure)


def _chain_rule(section: Section, names: Sequence[str]) -> _Chain:
    """From vertices seen from the centre, over R, to the numbers of the section: x = (x' - x_c)/R."""
    (radius,) = section._circle[2]

    def by_numbers(by_vertex: Any, vertices: Floats, field: str) -> Floats:
        known = {}
        for name, index in indices_of(section, field).items():
            known[name] = by_vertex[(..., *index)]
        of_all = by_vertex.sum(axis=-2)
        x_dot, y_dot = np.moveaxis(of_all, -1, 0)
        known["centre.x"] = -x_dot
        known["centre.y"] = -y_dot
        shrinking = by_vertex * vertices
        total = shrinking.sum(axis=(-2, -1))
        known["radius"] = -total
        unaffected = np.zeros_like(x_dot)
        columns = [known.get(name, unaffected) for name in names]
        by_number = np.stack(columns, axis=-1)
        return by_number / radius

    return by_numbers


def _surface(section: Section, ground: Vectors) -> _Surface:
    """Of a single section, from the vertices of its ground."""
    (vertex,) = np.nonzero(section._edges_over_mass)
    edge = ground.edges[vertex]
    start = section._cut.start[0, vertex]
    part = section._cut.part[0, vertex]
    before = start - ground[vertex]
    square = edge.square
    skipped = before.dot(edge) / square
    share = part.dot(edge) / square
    return _Surface(vertex, edge, start, part, skipped, share)


def _moments_by_vertex(surface: _Surface, vertices: int) -> dict[str, Floats]:
    """Derivatives of the integrals over the mass by each vertex, (V, 2): of f (v x ds), with v one hat function."""
    start = surface.start[:, None]
    part = surface.part[:, None]
    place, weight = _along(start, part)
    point = start + part * place
    r = point.length
    unit_x = point.x / r
    unit_y = point.y / r
    names = ("polar", "inertia", "radial_x", "radial_y", "moment_x", "moment_y")
    square = r * r
    integrands = np.stack([r, square, unit_x, unit_y, *point])

    skipped = surface.skipped[:, None]
    share = surface.share[:, None]
    second_hat = skipped + place * share  # 1 at the second vertex of an edge
    first_hat = 1.0 - second_hat
    hats = np.stack([first_hat, second_hat])
    weighted_hats = hats * weight
    along_edges = np.einsum("fkn,hkn->hfk", integrands, weighted_hats)
    normal = Vectors(-surface.part.y, surface.part.x)
    by_hat = along_edges[..., None] * normal.points
    by_first, by_second = by_hat
    by_vertex = np.zeros((len(names), vertices, 2))
    second_vertex = surface.vertex + 1
    by_vertex[:, surface.vertex] += by_first
    by_vertex[:, second_vertex] += by_second
    return dict(zip(names, by_vertex, strict=True))


def _ends_by_vertex(surface: _Surface, angles: Floats, vertices: int) -> Floats:
    """Derivatives of the angles of both ends of the arc by each vertex, (2, V, 2).

    An end stays on its edge and on the arc: it moves by (v x edge)/(tangent x edge) along the arc.
    """
    by_vertex = np.zeros((2, vertices, 2))
    passed = surface.skipped + surface.share
    shares = (surface.skipped[0], passed[-1])
    sine = np.sin(angles)
    tangent = Vectors(np.cos(angles), sine)
    for end, share in enumerate(shares):
        part = -end  # the first one or the last one
        edge = surface.edge[part]
        across = tangent[end].cross(edge)
        clockwise = np.array([edge.y, -edge.x])
        along_arc = clockwise / across
        vertex = surface.vertex[part]
        rest = 1.0 - share
        by_vertex[end, vertex] = rest * along_arc
        by_vertex[end, vertex + 1] = share * along_arc
    return by_vertex


def _along(start: Vectors, edge: Vectors) -> tuple[Floats, Floats]:
    """Places on edges and weights, (edges, nodes), that integrate what has its singularity at the centre.

    By Gauss in t, the length from the foot of the perpendicular; on an edge longer than its distance p from the centre
    in asinh(t/p), in which r = p cosh is entire. Vectors are (edges, 1).
    """
    length = edge.length
    first = start.dot(edge) / length
    last = first + length
    cross = start.cross(edge)
    distance = np.abs(cross) / length
    long = length > distance
    not_zero = np.maximum(distance, 1e-9)
    p = np.where(long, not_zero, 1.0)
    first_argument = np.arcsinh(first / p)
    last_argument = np.arcsinh(last / p)
    low = np.where(long, first_argument, first)
    high = np.where(long, last_argument, last)

    half = (high - low) / 2
    middle = (low + high) / 2
    node = middle + half * _NODES
    t_of_long = p * np.sinh(node)
    derivative = p * np.cosh(node)
    t = np.where(long, t_of_long, node)
    dt = np.where(long, derivative, 1.0)  # by the node
    place = (t - first) / length
    weight_of_node = dt * half * _WEIGHTS
    return place, weight_of_node / length


def _ground_heights(section: Section) -> HeightIntegrals:
    return height_integrals(*section._circle)


def _pressure(section: Section, ends: Floats, chain: _Chain, of_scale: Floats) -> Callable[[Any], Any]:
    """Of the mean pressure: the integral of heights over R, over the angle of the arc, times R gamma_w."""
    if section.level is None:
        return lambda turn: 0.0 * turn
    (level,) = section._level
    runs = np.diff(level[:, 0])
    if np.any(runs == 0.0):
        raise ValueError("sensitivity: level: has points above each other, where the pressure has no derivative")
    water = section._water
    first, last = np.concatenate(section._angles)
    (way,) = section._facing
    (radius,) = section._circle[2]
    unit = radius * section.water_unit_weight
    (with_continuations,) = water.line
    line = with_continuations[1:-1]
    first_by_numbers, last_by_numbers = ends
    angle = last - first
    angle_by_numbers = last_by_numbers - first_by_numbers

    def pressure(turn: Any) -> Any:
        rotation = turn[..., 0]
        turned = way * rotation
        begin = first + turned
        end = last + turned
        by_vertex = water.gradient(begin, end)
        by_level = chain(by_vertex, line, "level")
        head_at_end = water.at(end)[..., None]
        head_at_begin = water.at(begin)[..., None]
        by_end = head_at_end * last_by_numbers
        by_begin = head_at_begin * first_by_numbers
        by_ends = by_end - by_begin
        mean = section.mean_pressure(rotation)[..., None]
        total = unit * (by_level + by_ends)
        by_angle = mean * angle_by_numbers
        of_mean = (total - by_angle) / angle
        by_scale = mean * of_scale
        return of_mean + by_scale

    return pressure
