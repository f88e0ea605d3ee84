"""How the integrals of a section change with the coordinates of its ground, its circle and its water level.

Seen from the centre, over R, the arc rests and only vertices move. The integral of f over the mass changes by that of
f (v x ds) along the ground inside the circle (Reynolds' transport theorem), v linear between the vertices of an edge;
where ground and arc meet the mass has no thickness, and nothing is added. f is the integrand of each definition: r and
r^2 of (2.17) and (3.12), the unit vector and the vector from the centre of (2.23) and (3.13), and 1/cos(beta) of the
mean height above the arc. The ends of the arc move as the ground's edges cross it.

Of a circle through a vertex the derivatives are those towards the side on which the vertex lies outside the mass.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene import circles
from slipcircle.core.scene.coordinates import indices_of
from slipcircle.core.scene.section import Section

Floats = NDArray[np.float64]
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)


class Growth(NamedTuple):
    """Derivatives by numbers of a section, one a column."""

    moments: Mapping[str, Floats]  # of each, dimensionless, without its sign of facing; of ``cover`` the integral
    ends: Floats  # of the angles of both ends of the arc, (2, numbers), rad
    pressure: Callable[[Any], Any]  # of the mean pressure below the water level, Pa, after rotations (..., numbers)


def telling(section: Section) -> list[str]:
    """The numbers of a single section that its motion depends on; of the ground those of the edges over the mass."""
    over = np.flatnonzero(_over(section))
    ground = {n for n, at in indices_of(section, "ground").items() if over[0] <= at[0] <= over[-1] + 1}
    return [n for field in section.quantities for n in indices_of(section, field) if field != "ground" or n in ground]


def through_vertex(section: Section) -> bool:
    """Whether an end of the arc of a single section is a vertex of its ground."""
    ends = np.array([section.entry, section.exit])
    return bool(np.any(np.isclose(ends[:, None], section._circle[0], rtol=1e-14, atol=0.0).all(axis=2)))


def _over(section: Section) -> Any:
    """The edges of the ground over the mass of a single section."""
    return section._mine[0] & ((section._cut.e_x[0] != 0.0) | (section._cut.e_y[0] != 0.0))


def growth(section: Section, names: Sequence[str]) -> Growth:
    """Derivatives of a single section by its numbers, to some 1e-14 of each moment over the length that moves."""
    (ground,), (centre,), (radius,) = section._circle
    ground = (ground - centre) / radius
    edge = np.diff(ground, axis=0)
    cut, mine = section._cut, _over(section)
    start = np.stack([cut.x[0], cut.y[0]], axis=1)[mine]
    inside, whole = np.stack([cut.e_x[0], cut.e_y[0]], axis=1)[mine], edge[mine]
    square = (whole**2).sum(axis=1)
    first = ((start - ground[:-1][mine]) * whole).sum(axis=1) / square  # where on its edge a part begins, and its share
    share = (inside * whole).sum(axis=1) / square

    def numbers(gradient: Any, points: Floats, field: str) -> Floats:
        """By the section's numbers, of a gradient by vertices (..., V, 2)."""
        by = {name: gradient[(..., *at)] for name, at in indices_of(section, field).items()}
        by |= {f"centre.{axis}": -gradient[..., k].sum(axis=-1) for k, axis in enumerate("xy")}
        by["radius"] = -(gradient * points).sum(axis=(-2, -1))
        return np.stack([by.get(n, np.zeros(gradient.shape[:-2])) for n in names], axis=-1) / radius

    at, weight = _along(start, inside)
    x, y = np.moveaxis(start[:, None] + at[..., None] * inside[:, None], -1, 0)
    r = np.hypot(x, y)
    fs = {
        "polar": r,
        "inertia": r * r,
        "radial_x": x / r,
        "radial_y": y / r,
        "moment_x": x,
        "moment_y": y,
        "cover": 1.0 / np.sqrt((1.0 - x) * (1.0 + x)),
    }
    on = first[:, None] + at * share[:, None]
    normal, vertex = np.stack([-inside[:, 1], inside[:, 0]], axis=1), np.flatnonzero(mine)
    moments = {}
    for name, f in fs.items():
        gradient = np.zeros(ground.shape)
        for k, hat in ((0, 1.0 - on), (1, on)):
            np.add.at(gradient, vertex + k, (f * hat * weight).sum(axis=1)[:, None] * normal)
        moments[name] = numbers(gradient, ground, "ground")
    ends = np.zeros((2, *ground.shape))
    for k, (beta, part, s) in enumerate(zip(section._angles, (0, -1), (first[0], first[-1] + share[-1]), strict=True)):
        (beta,), (u, v) = beta, whole[part]
        for j, hat in ((0, 1.0 - s), (1, s)):  # (v x edge)/(tangent x edge)
            ends[k, vertex[part] + j] = hat * np.array([v, -u]) / (np.cos(beta) * v - np.sin(beta) * u)
    turned = numbers(ends, ground, "ground")
    stretched = np.array([float(n == "radius") for n in names]) / radius
    return Growth(moments, turned, _pressure(section, turned, numbers, stretched))


def _along(start: Floats, edge: Floats) -> tuple[Floats, Floats]:
    """Places on edges and weights, (edges, nodes), that integrate what has its singularity at the centre.

    By Gauss; on an edge longer than its distance p from the centre in asinh(t/p), in which r = p cosh is entire.
    """
    length = np.hypot(*edge.T)
    t = (start * edge).sum(axis=1) / length
    p = np.abs(start[:, 0] * edge[:, 1] - start[:, 1] * edge[:, 0]) / length
    long = length > p
    p = np.where(long, np.maximum(p, 1e-9), 1.0)
    low, high = (np.where(long, np.arcsinh(end / p), end)[:, None] for end in (t, t + length))
    node = (low + high) / 2 + (high - low) / 2 * _NODES
    place = np.where(long[:, None], p[:, None] * np.sinh(node), node)
    each = np.where(long[:, None], p[:, None] * np.cosh(node), 1.0) * (high - low) / 2 * _WEIGHTS
    return (place - t[:, None]) / length[:, None], each / length[:, None]


def _pressure(section: Section, ends: Floats, numbers: Any, stretched: Floats) -> Callable[[Any], Any]:
    """Of the mean pressure, whose heads are over R: offset + slope sin(beta) + cos(beta)."""
    if section.level is None:
        return lambda turn: 0.0 * turn
    (_, (centre,), (radius,)), (way,) = section._circle, section._facing
    (line,), _, (kinks,) = circles.wet(section._level, centre[None], np.array([radius]))
    line = (line - centre) / radius
    (x, y), (run, rise) = line[:-1].T, np.diff(line, axis=0).T
    low, high = np.split(kinks, 2)
    if np.any(run == 0.0):
        raise ValueError("sensitivity: level: has points above each other, where the pressure has no derivative")
    slope, lift = rise / run, np.stack([-rise / run, np.ones_like(run)], axis=1)
    (first, last), unit = np.concatenate(section._angles), radius * section.water_unit_weight

    def head(beta: Any) -> Any:
        """Above one place of the arc."""
        own = (low <= beta) & (beta < high)
        return np.where(own, y + slope * (np.sin(beta) - x) + np.cos(beta), 0.0).sum(axis=-1)[..., None]

    def pressure(turn: Any) -> Any:
        begin, end = first + way * turn[..., :1], last + way * turn[..., :1]
        a, b = np.clip(begin, low, high), np.clip(end, low, high)
        tip = (np.cos(a) - np.cos(b) - x * (b - a)) / run  # integral of the hat function of an edge's second vertex
        gradient = np.zeros((*tip.shape[:-1], *line.shape))
        gradient[..., :-1, :] += (b - a - tip)[..., None] * lift
        gradient[..., 1:, :] += tip[..., None] * lift
        gradient[..., 1, :] += gradient[..., 0, :]  # beyond its ends the level is as high as there
        gradient[..., -2, :] += gradient[..., -1, :]
        grown = numbers(gradient[..., 1:-1, :], line[1:-1], "level") + head(end) * ends[1] - head(begin) * ends[0]
        mean = section.mean_pressure(turn[..., 0])[..., None]
        return (unit * grown - mean * (ends[1] - ends[0])) / (last - first) + mean * stretched

    return pressure
