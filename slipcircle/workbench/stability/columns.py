"""Slopes as arrays, and the columns of ground between their vertices, in which every line is one straight edge.

Lines are (1 or n, V, 2) for n slopes and go on horizontally beyond both ends; numbers are () or (n,).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.series import Floats
from slipcircle.core import line_crossings


class SoilArrays(NamedTuple):
    """Numbers of the soil of a layer, for one slope or for n of them."""

    cohesion: Any
    friction: Any
    unit_weight: Any
    pore_ratio: Any = 0.0
    saturated_unit_weight: Any = None
    cohesion_gradient: Any = 0.0
    datum: Any = None


class Columns(NamedTuple):
    """Columns of ground between vertices and crossings of lines, and surfaces there: (surfaces, 1 or n, columns).

    Surfaces are the tops of the layers, each cut off by those above it; with a water level then that, and the tops of
    the wet parts of layers; with a pond then its level and the part of the ground below it.
    """

    bounds: Floats  # x between columns, (1 or n, columns - 1)
    middle: Floats  # x, (1 or n, columns)
    height: Floats  # of surfaces in the middle
    gradient: Floats

    def at(self, lane: Any, x: Floats) -> Any:
        """The column at each x, of the slope of that number."""
        if len(self.bounds) == 1:
            return np.searchsorted(self.bounds[0], x)
        return np.count_nonzero(self.bounds[lane] < x[:, None], axis=1)


class Edges(NamedTuple):
    """Straight lines between two x, (1 or n, edges)."""

    left: Floats
    right: Floats
    x: Floats  # of a point
    y: Floats
    gradient: Floats


@dataclass(frozen=True)
class SlopeArrays:
    """One slope, or n of them."""

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

        return SlopeArrays(**{field.name: some(getattr(self, field.name)) for field in fields(self)})

    @property
    def saturates(self) -> bool:
        """Whether a soil has another unit weight below the water level."""
        return self.level is not None and any(soil.saturated_unit_weight is not None for soil in self.soils)

    @cached_property
    def numbers(self) -> SoilArrays:
        """Numbers of the soils, (layers, 1 or n) each; the unit weight and the datum 0 where they lack another."""
        rows: list[Any] = []
        for soil in self.soils:
            saturated = soil.unit_weight if soil.saturated_unit_weight is None else soil.saturated_unit_weight
            datum = 0.0 if soil.datum is None else soil.datum
            rows += soil._replace(saturated_unit_weight=saturated, datum=datum)
        values = np.stack(np.broadcast_arrays(*map(np.atleast_1d, rows))).astype(np.float64)
        return SoilArrays(*values.reshape(len(self.soils), len(SoilArrays._fields), -1).swapaxes(0, 1))

    @cached_property
    def lines(self) -> list[Floats]:
        """Tops of layers, water level, pond."""
        pond = [] if self.pond is None else [level_line(self.pond, self.ground)]
        return [self.ground, *self.tops, *([] if self.level is None else [self.level]), *pond]

    @cached_property
    def columns(self) -> Columns:
        """The columns between all kinks of the lines and of the surcharge."""
        kinks = [line[..., 0] for line in self.lines]
        kinks += [line_crossings(one, other) for one, other in combinations(map(_extended, self.lines), 2)]
        kinks += [np.array([[x1, x2]]) for x1, x2, _, _ in self.surcharge]
        slopes = max(map(len, kinks))
        whole = [np.broadcast_to(x, (slopes, x.shape[1])) for x in kinks]
        bounds = np.sort(np.concatenate(whole, axis=1), axis=1)
        if slopes == 1:
            bounds = np.unique(bounds, axis=1)
        before = bounds[:, :1] - 1.0
        inner = (bounds[:, :-1] + bounds[:, 1:]) / 2
        beyond = bounds[:, -1:] + 1.0
        middle = np.concatenate([before, inner, beyond], axis=1)
        surfaces = self._surfaces([_on_line(line, middle) for line in self.lines])
        height, gradient = np.stack(surfaces, axis=1)
        return Columns(bounds, middle, height, gradient)

    def _surfaces(self, lines: list[Floats]) -> list[Floats]:
        """Heights and gradients of surfaces, of those of lines, each (2, n, columns)."""
        layers = len(self.soils)
        tops = lines[:1]
        for line in lines[1:layers]:
            tops.append(_lower(line, tops[-1]))
        surfaces = list(tops)
        if self.level is not None:
            surfaces += [lines[layers]]
            surfaces += [_lower(top, lines[layers]) for top in tops] if self.saturates else []
        if self.pond is not None:
            surfaces += [lines[-1], _lower(tops[0], lines[-1])]
        return surfaces

    @cached_property
    def edges(self) -> Edges:
        """Of boundaries, water level and pond, and of the heights below which cohesion grows; none is vertical."""
        parts = [edges_of(line) for line in self.lines[1:]]
        for soil in self.soils:
            if np.any(soil.cohesion_gradient):
                parts.append(edges_of(level_line(soil.datum, self.ground)))
        slopes = max((len(part[0]) for part in parts), default=1)
        whole = [np.broadcast_to(part, (5, slopes, part.shape[-1])) for part in parts]
        every = np.concatenate([np.empty((5, slopes, 0)), *whole], axis=2)
        if slopes == 1:
            every = np.unique(every, axis=2)
        return Edges(*every)


def level_line(height: Any, ground: Floats) -> Floats:
    """A horizontal line, or one for each height, from one end of the ground to the other, (1 or n, 2, 2)."""
    height = np.reshape(height, (-1, 1))
    x = np.broadcast_to(ground[:, [0, -1], 0], (max(len(height), len(ground)), 2))
    return np.stack(np.broadcast_arrays(x, height), axis=-1)


def _extended(lines: Floats) -> Floats:
    """Lines that go on horizontally beyond both ends."""
    far = 1e12 * np.array([[-1.0, 0.0], [1.0, 0.0]])
    return np.concatenate([lines[:, :1] + far[:1], lines, lines[:, -1:] + far[1:]], axis=1)


def _gradients(line: Floats) -> Floats:
    """Of the edges of a line, (1 or n, V - 1); infinite of vertical ones."""
    run, rise = np.moveaxis(np.diff(line, axis=1), -1, 0)
    return np.divide(rise, run, out=np.full(run.shape, np.inf), where=run > 0.0)


def edges_of(line: Floats) -> Floats:
    """The fields of `Edges` of a line, (5, 1 or n, edges): without vertical edges, level ones in a row joined."""
    outside = np.zeros((len(line), 1))
    gradient = np.concatenate([outside, _gradients(line), outside], axis=1)
    infinite = np.full((len(line), 1), np.inf)
    left = np.concatenate([-infinite, line[..., 0]], axis=1)
    right = np.concatenate([line[..., 0], infinite], axis=1)
    point = np.concatenate([line[:, :1], line], axis=1)
    level = np.all(gradient == 0.0, axis=0)
    begins = np.append(True, ~(level[1:] & level[:-1]))
    ends = np.append(begins[1:], True)
    x = np.where(level[begins], 0.0, point[:, begins, 0])
    fields = np.stack([left[:, begins], right[:, ends], x, point[:, begins, 1], gradient[:, begins]])
    vertical = np.all(np.isinf(fields[4]), axis=0)
    return np.asarray(fields[:, :, ~vertical])


def height_at(line: Floats, x: Floats) -> Floats:
    """Of a line at x (n,), or of n lines each at its x."""
    by_line = x[None] if len(line) == 1 else x[:, None]
    return np.ravel(_on_line(line, by_line)[0])


def _on_line(line: Floats, x: Floats) -> Floats:
    """Height and gradient of a line at x (n, any) that are not those of vertices, (2, n, any)."""
    passed = np.count_nonzero(line[:, None, :, 0] < x[..., None], axis=-1)
    inside = (passed > 0) & (passed < line.shape[1])
    lane = np.zeros((1, 1), dtype=np.int64) if len(line) == 1 else np.arange(len(line))[:, None]
    left = np.clip(passed - 1, 0, line.shape[1] - 2)
    gradient = np.where(inside, _gradients(line)[lane, left], 0.0)
    point = line[lane, np.maximum(passed - 1, 0)]
    return np.stack([point[..., 1] + gradient * (x - point[..., 0]), gradient])


def _lower(one: Floats, other: Floats) -> Floats:
    """Height and gradient of the lower of two lines."""
    return np.where(one[0] < other[0], one, other)
