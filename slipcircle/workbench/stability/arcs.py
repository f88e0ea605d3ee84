"""Slopes as arrays, and the points along many arcs at which their slices are taken.

Points are those of Gauss' rule between the kinks of an arc: below vertices of lines, where lines cross each other and
the arc, where cohesion begins to grow with depth, and at the ends of surcharges.
"""

from __future__ import annotations

from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.series import Floats

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)
MIDDLE = len(_NODES) // 2  # a point inside each interval


class SoilArrays(NamedTuple):
    """Numbers of the soil of a layer, for one slope or for n of them, () or (n,)."""

    cohesion: Any
    friction: Any
    unit_weight: Any
    pore_ratio: Any = 0.0
    saturated_unit_weight: Any = None
    cohesion_gradient: Any = 0.0
    datum: Any = None


class SlopeArrays(NamedTuple):
    """One slope, or n of them: lines (1 or n, V, 2), numbers () or (n,)."""

    ground: Floats
    soils: tuple[SoilArrays, ...]  # of the layers from the ground down
    tops: tuple[Floats, ...] = ()  # of each layer but the first, whose top is the ground
    level: Floats | None = None
    water_unit_weight: Any = 9810.0
    pressure: Any = 0.0
    k_h: Any = 0.0
    pond: Any = None
    surcharge: Any = ()  # from x1 to x2, q1 and q2
    crack: Any = 0.0
    crack_water: Any = 0.0
    k_h_on_surcharge: bool = False

    def only(self, lanes: Any) -> SlopeArrays:
        """Some of n slopes."""

        def some(value: Any) -> Any:
            if isinstance(value, SoilArrays):
                return SoilArrays(*map(some, value))
            if isinstance(value, tuple):
                return tuple(map(some, value))
            return value[lanes] if isinstance(value, np.ndarray) and value.ndim and len(value) > 1 else value

        return SlopeArrays(*map(some, self))

    def lines(self) -> list[Floats]:
        """All of them: tops of layers, water level, pond."""
        found = [self.ground, *self.tops] + ([] if self.level is None else [self.level])
        if self.pond is not None:
            height = np.reshape(self.pond, (-1, 1))
            x = np.broadcast_to(self.ground[:, [0, -1], 0], (max(len(height), len(self.ground)), 2))
            found.append(np.stack(np.broadcast_arrays(x, height), axis=-1))
        return found


class Points(NamedTuple):
    """Points along arcs, (points, intervals); an interval is the part of one arc between two kinks.

    Angles are from straight below the centre, lengths over R.
    """

    centre: Floats  # of the arcs
    radius: Floats
    arc: NDArray[np.int64]  # number of the arc of each interval
    low: Floats  # angles of both ends of each interval
    high: Floats
    angle: Floats
    weight: Floats  # of a point in the integral over the angle

    @property
    def scale(self) -> Floats:
        """The radius, m, of each interval."""
        return self.radius[self.arc]

    @property
    def middle(self) -> Floats:
        """x of the middle of each interval, m."""
        return self.centre[self.arc, 0] + self.scale * np.sin((self.low + self.high) / 2)

    def above_centre(self, lines: Floats) -> Floats:
        """Height of a line above the centre at each point."""
        x, y, gradient = _edges(lines, self.arc, self.middle)
        centre = self.centre[self.arc]
        at_centre = (y - centre[:, 1] + gradient * (centre[:, 0] - x)) / self.scale
        return at_centre + gradient * np.sin(self.angle)

    def of_interval(self, value: Any) -> Floats:
        """A number of all arcs, or of each, by interval."""
        return np.broadcast_to(np.asarray(value, dtype=np.float64), len(self.radius))[self.arc]

    def of_layers(self, values: Any) -> Floats:
        """Numbers of the layers, (layers, intervals)."""
        return np.stack([self.of_interval(value) for value in values])


def points_along(
    slope: SlopeArrays, centre: Floats, radius: Floats, first: Floats, last: Floats, valid: Any, pieces: int
) -> Points:
    """Points of valid arcs between two angles, cut into pieces and at all kinks."""
    kinks = [np.linspace(first, last, pieces + 1, axis=1), *_kinks(slope, centre, radius)]
    every = np.concatenate(kinks, axis=1)
    some = ~np.all(np.isnan(every), axis=0)
    angles = np.sort(np.clip(every[:, some], first[:, None], last[:, None]), axis=1)
    arc, k = np.nonzero((np.diff(angles, axis=1) > 0.0) & valid[:, None])
    low = angles[arc, k]
    high = angles[arc, k + 1]
    half = (high - low) / 2
    angle = (low + high) / 2 + half * _NODES[:, None]  # points first: sums over them are sums of rows
    return Points(centre, radius, arc, low, high, angle, half * _WEIGHTS[:, None])


def _kinks(slope: SlopeArrays, centre: Floats, radius: Floats) -> list[Floats]:
    """Angles at which an integrand may not be smooth, (n, any) each: vertices and crossings of lines and arcs."""
    lines = slope.lines()
    kinks = [_vertex_angles(line, centre, radius) for line in lines]
    kinks += [crossing_angles(line, centre, radius) for line in lines[1:]]
    x = [_crossings(one, other) for one, other in combinations(lines, 2)]
    x += [np.array([[x1, x2]]) for x1, x2, _, _ in slope.surcharge]
    kinks += [np.arcsin(np.clip((at - centre[:, :1]) / radius[:, None], -1.0, 1.0)) for at in x]
    for soil in slope.soils:
        if np.any(soil.cohesion_gradient):
            reach = np.arccos(np.clip((centre[:, 1] - soil.datum) / radius, -1.0, 1.0))[:, None]
            kinks += [reach, -reach]
    return kinks


def _crossings(one: Floats, other: Floats) -> Floats:
    """x where two lines (1 or n, V, 2), which go on horizontally, cross each other, (1 or n, any); NaN for none."""
    one, other = _extended(one), _extended(other)
    (p, u), (q, v) = ((line[:, :-1], np.diff(line, axis=1)) for line in (one, other))
    p, u, q, v = p[:, :, None], u[:, :, None], q[:, None], v[:, None]
    across, apart = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0], q - p
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (apart[..., 0] * v[..., 1] - apart[..., 1] * v[..., 0]) / across
        t = (apart[..., 0] * u[..., 1] - apart[..., 1] * u[..., 0]) / across
        x = np.where((s > 0.0) & (s < 1.0) & (t > 0.0) & (t < 1.0), p[..., 0] + s * u[..., 0], np.nan)
    return x.reshape(len(x), -1)


def _vertex_angles(lines: Floats, centre: Floats, radius: Floats) -> Floats:
    """Angles of the arcs' points below or above vertices of lines (1 or n, V, 2)."""
    return np.arcsin(np.clip((lines[..., 0] - centre[:, :1]) / radius[:, None], -1.0, 1.0))


def crossing_angles(lines: Floats, centre: Floats, radius: Floats) -> Floats:
    """Angles at which lines cross arcs, NaN for edges that do not.

    An edge's height above the arc, c + s sin(beta) + cos(beta), is 0 at beta = atan(s) +- acos(-c/sqrt(1 + s^2)).
    """
    lines = _extended(lines)
    x, y = ((lines[..., k] - centre[:, k, None]) / radius[:, None] for k in (0, 1))
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.diff(y, axis=1) / np.diff(x, axis=1)
        middle = np.arctan(slope)
        half = np.arccos((slope * x[:, :-1] - y[:, :-1]) / np.hypot(1.0, slope))
        angles = np.concatenate([middle - half, middle + half], axis=1)
        sine = np.sin(angles)
    on_edge = (sine >= np.tile(x[:, :-1], 2)) & (sine <= np.tile(x[:, 1:], 2))
    return np.where(on_edge, angles, np.nan)


def _extended(lines: Floats) -> Floats:
    """Lines that go on horizontally beyond both ends."""
    far = 1e12 * np.array([[-1.0, 0.0], [1.0, 0.0]])
    return np.concatenate([lines[:, :1] + far[:1], lines, lines[:, -1:] + far[1:]], axis=1)


def _edges(lines: Floats, line: Any, x: Floats) -> tuple[Floats, Floats, Floats]:
    """Of the edge of a line (1 or n, V, 2) at each x: a point, x and y, and its gradient, 0 beyond the line's ends."""
    vertices = lines.shape[1]
    if len(lines) == 1:
        passed = np.searchsorted(lines[0, :, 0], x)
        line = np.zeros(1, dtype=np.int64)
    else:
        passed = np.count_nonzero(lines[line, :, 0] < x[:, None], axis=1)
    left = np.clip(passed - 1, 0, vertices - 1)
    run, rise = np.moveaxis(np.diff(lines, axis=1, append=lines[:, -1:]), -1, 0)
    gradient = np.divide(rise, run, out=np.zeros(run.shape), where=run > 0.0)
    return lines[line, left, 0], lines[line, left, 1], np.where(passed > 0, gradient[line, left], 0.0)


def height_at(lines: Floats, x: Floats) -> Floats:
    """Of lines, one for all or one for each x."""
    at, y, gradient = _edges(lines, np.arange(len(x)), x)
    return y + gradient * (x - at)
