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
from numpy.typing import NDArray

from slipcircle.core.scene.coordinates import indices_of
from slipcircle.core.scene.heights import HeightIntegrals, height_integrals
from slipcircle.core.scene.section import Section

Floats = NDArray[np.float64]
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)
_Chain = Callable[[Floats, Floats, str], Floats]  # derivatives by numbers, of those by vertices of a line


class SectionDerivatives(NamedTuple):
    """Derivatives by numbers of a section, one a column."""

    moments: Mapping[str, Floats]  # of each integral of `circles.MEASURES` but the area
    heights: Floats  # of the integral of the ground's height above the arc, over R
    ends: Floats  # of the angles of both ends of the arc, (2, numbers), rad
    pressure: Callable[[Any], Any]  # of the mean pressure below the water level, Pa, after rotations (..., numbers)


class _Surface(NamedTuple):
    """The edges of the ground over the mass, and the parts of them that lie inside the circle, (k, 2), over R."""

    vertex: NDArray[np.int64]  # number of an edge's first vertex, (k,)
    edge: Floats
    start: Floats  # of the part inside
    part: Floats
    skipped: Floats  # share of the edge before that part, (k,)
    share: Floats  # and of the part


def active_parameters(section: Section) -> list[str]:
    """The numbers of a single section that its motion depends on; of the ground those of the edges above the arc."""
    vertices = _vertices_above(section)
    ground = {n for n, at in indices_of(section, "ground").items() if at[0] in vertices}
    return [n for field in section.quantities for n in indices_of(section, field) if field != "ground" or n in ground]


def _vertices_above(section: Section) -> range:
    """Of the edges over the mass, or, where the arc overhangs, over all of it."""
    edges = np.flatnonzero(section._edges_over_mass)
    if np.any(np.abs(section._angles) > np.pi / 2):
        edges = np.unique(np.clip(_ground_heights(section).edge - 1, 0, np.shape(section.ground)[0] - 2))
    return range(edges[0], edges[-1] + 2)


def through_vertex(section: Section) -> bool:
    """Whether an end of the arc of a single section is a vertex of its ground."""
    ends = np.array([section.entry, section.exit])
    return bool(np.any(np.isclose(ends[:, None], section._circle[0], rtol=1e-14, atol=0.0).all(axis=2)))


def section_derivatives(section: Section, names: Sequence[str]) -> SectionDerivatives:
    """Derivatives of a single section by its numbers, to some 1e-14 of each moment over the length that moves."""
    chain = _chain_rule(section, names)
    (points,), (centre,), (radius,) = section._circle
    ground = (points - centre) / radius
    surface = _surface(section, np.diff(ground, axis=0))
    moments = {name: chain(by, ground, "ground") for name, by in _moments_by_vertex(surface, len(ground)).items()}
    ends = chain(_ends_by_vertex(surface, np.concatenate(section._angles), len(ground)), ground, "ground")

    above = _ground_heights(section)
    first, last = np.concatenate(section._angles)
    at_ends = above.at(np.array([first, last]))
    by_ground = chain(above.gradient(first, last), ground, "ground")
    heights = by_ground + at_ends[1] * ends[1] - at_ends[0] * ends[0]
    of_scale = np.array([float(n == "radius") for n in names]) / radius
    return SectionDerivatives(moments, heights, ends, _pressure(section, ends, chain, of_scale))


def _chain_rule(section: Section, names: Sequence[str]) -> _Chain:
    """From vertices seen from the centre, over R, to the numbers of the section: x = (x' - x_c)/R."""
    (radius,) = section._circle[2]

    def by_numbers(by_vertex: Any, vertices: Floats, field: str) -> Floats:
        known = {name: by_vertex[(..., *at)] for name, at in indices_of(section, field).items()}
        known |= {f"centre.{axis}": -by_vertex[..., k].sum(axis=-1) for k, axis in enumerate("xy")}
        known["radius"] = -(by_vertex * vertices).sum(axis=(-2, -1))
        unaffected = np.zeros(by_vertex.shape[:-2])
        return np.stack([known.get(n, unaffected) for n in names], axis=-1) / radius

    return by_numbers


def _surface(section: Section, edges: Floats) -> _Surface:
    cut = section._cut
    (vertex,) = np.nonzero(section._edges_over_mass)
    edge = edges[vertex]
    start = np.stack([cut.x[0], cut.y[0]], axis=1)[vertex]
    part = np.stack([cut.e_x[0], cut.e_y[0]], axis=1)[vertex]
    (points,), (centre,), (radius,) = section._circle
    before = start - (points[vertex] - centre) / radius
    square = (edge**2).sum(axis=1)
    skipped = (before * edge).sum(axis=1) / square
    share = (part * edge).sum(axis=1) / square
    return _Surface(vertex, edge, start, part, skipped, share)


def _moments_by_vertex(surface: _Surface, vertices: int) -> dict[str, Floats]:
    """Derivatives of the integrals over the mass by each vertex, (V, 2): of f (v x ds), with v one hat function."""
    at, weight = _along(surface.start, surface.part)
    x = surface.start[:, :1] + at * surface.part[:, :1]
    y = surface.start[:, 1:] + at * surface.part[:, 1:]
    r = np.hypot(x, y)
    integrands = {"polar": r, "inertia": r * r, "radial_x": x / r, "radial_y": y / r, "moment_x": x, "moment_y": y}
    second = surface.skipped[:, None] + at * surface.share[:, None]  # hat function of an edge's second vertex
    hats = np.stack([1.0 - second, second]) * weight
    along_normal = np.einsum("fkn,hkn->hfk", np.stack([*integrands.values()]), hats)
    normal = np.stack([-surface.part[:, 1], surface.part[:, 0]], axis=1)
    by_vertex = np.zeros((len(integrands), vertices, 2))
    for k, integrals in enumerate(along_normal):
        by_vertex[:, surface.vertex + k] += integrals[..., None] * normal
    return dict(zip(integrands, by_vertex, strict=True))


def _ends_by_vertex(surface: _Surface, angles: Floats, vertices: int) -> Floats:
    """Derivatives of the angles of both ends of the arc by each vertex, (2, V, 2).

    An end stays on its edge and on the arc: it moves by (v x edge)/(tangent x edge) along the arc.
    """
    by_vertex = np.zeros((2, vertices, 2))
    shares = surface.skipped[0], surface.skipped[-1] + surface.share[-1]
    for end, (angle, part, share) in enumerate(zip(angles, (0, -1), shares, strict=True)):
        u, v = surface.edge[part]
        along_arc = np.array([v, -u]) / (np.cos(angle) * v - np.sin(angle) * u)
        by_vertex[end, surface.vertex[part]] = (1.0 - share) * along_arc
        by_vertex[end, surface.vertex[part] + 1] = share * along_arc
    return by_vertex


def _along(start: Floats, edge: Floats) -> tuple[Floats, Floats]:
    """Places on edges and weights, (edges, nodes), that integrate what has its singularity at the centre.

    By Gauss; on an edge longer than its distance p from the centre in asinh(t/p), in which r = p cosh is entire.
    """
    x, y = start[:, :1], start[:, 1:]
    u, v = edge[:, :1], edge[:, 1:]
    length = np.hypot(u, v)
    foot = (x * u + y * v) / length  # t of the start, from the foot of the perpendicular
    distance = np.abs(x * v - y * u) / length
    long = length > distance
    p = np.where(long, np.maximum(distance, 1e-9), 1.0)
    low, high = (np.where(long, np.arcsinh(end / p), end) for end in (foot, foot + length))
    half = (high - low) / 2
    node = (low + high) / 2 + half * _NODES
    t = np.where(long, p * np.sinh(node), node)
    dt = np.where(long, p * np.cosh(node), 1.0)  # by the node
    return (t - foot) / length, dt * half * _WEIGHTS / length


def _ground_heights(section: Section) -> HeightIntegrals:
    return height_integrals(*section._circle)


def _pressure(section: Section, ends: Floats, chain: _Chain, of_scale: Floats) -> Callable[[Any], Any]:
    """Of the mean pressure: the integral of heights over R, over the angle of the arc, times R gamma_w."""
    if section.level is None:
        return lambda turn: 0.0 * turn
    if np.any(np.diff(section._level[0, :, 0]) == 0.0):
        raise ValueError("sensitivity: level: has points above each other, where the pressure has no derivative")
    water = section._water
    first, last = np.concatenate(section._angles)
    (way,) = section._facing
    (radius,) = section._circle[2]
    unit = radius * section.water_unit_weight
    line = water.line[0, 1:-1]

    def pressure(turn: Any) -> Any:
        begin = first + way * turn[..., 0]
        end = last + way * turn[..., 0]
        by_level = chain(water.gradient(begin, end), line, "level")
        by_ends = water.at(end)[..., None] * ends[1] - water.at(begin)[..., None] * ends[0]
        mean = section.mean_pressure(turn[..., 0])[..., None]
        return (unit * (by_level + by_ends) - mean * (ends[1] - ends[0])) / (last - first) + mean * of_scale

    return pressure
