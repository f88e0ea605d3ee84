"""Slopes as arrays, and columns of ground between their vertices, in which every line is one straight edge.

Lines are (1 or n, V, 2) for n slopes, and numbers () or (n,). Beyond both ends a line continues horizontally.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.errors import one_number
from slipcircle.base.kinds import Floats
from slipcircle.core import declared
from slipcircle.ground import Ponds, Section, continued, edge_below
from slipcircle.layers import STRESS, Soil

SLOPE_NUMBERS = {  # declarations of the fields of a `Slope`
    **{name: replace(p, kind="fixed") for name, p in (declared(Section) | declared(Soil)).items()},
    "datum": declared(Section)["base"],
    "pressure": replace(STRESS, kind="fixed"),
    "friction": one_number(-5e-324, 5.0, "a friction coefficient tan(phi) from 0 to 5; an angle is its arctangent"),
    "k_h": one_number(-1.0, 1.0, "between -1 and 1"),
}


class SoilArrays(NamedTuple):
    """Soils of the layers from the ground down, (layers, 1 or n) each."""

    cohesion: Floats
    friction: Floats
    unit_weight: Floats
    pore_ratio: Floats
    saturated_unit_weight: Floats  # the unit weight where a soil has no other below the water level
    cohesion_gradient: Floats


class Columns(NamedTuple):
    """Columns of ground between vertices and crossings of lines, with their surfaces: (surfaces, 1 or n, columns).

    Surfaces are the tops of the layers, each cut off by those above it; with a water level then that, and the tops of
    the wet parts of layers. The last ones are lines below which the cohesion of layers grows.
    """

    bounds: Floats  # x between columns, (1 or n, columns - 1)
    middle: Floats  # x, (1 or n, columns)
    height: Floats  # of surfaces in the middle
    gradient: Floats

    def at(self, slope: Any, x: Floats) -> Any:
        """Return the index of the column at each x in m; ``slope`` is the index of the slope of each x."""
        if len(self.bounds) == 1:
            return np.searchsorted(self.bounds[0], x)
        return np.count_nonzero(self.bounds[slope] < x[:, None], axis=1)


@dataclass(frozen=True)
class SlopeArrays:
    """One slope, or n slopes, as arrays."""

    ground: Floats
    soils: SoilArrays
    tops: tuple[Floats, ...] = ()  # of each layer but the first, whose top is the ground
    level: Floats | None = None
    water_unit_weight: Any = 9810.0
    pressure: Any = 0.0
    k_h: Any = 0.0
    ponds: Ponds | None = None
    surcharge: Any = ()  # from x1 to x2, q1 and q2
    crack: Any = 0.0
    crack_water: Any = 0.0
    k_h_on_surcharge: bool = False
    datums: Mapping[int, Floats] = field(default_factory=dict)  # lines below which the cohesion of layers grows

    @cached_property
    def saturates(self) -> bool:
        """Whether a soil has another unit weight below the water level."""
        soils = self.soils
        changes = soils.saturated_unit_weight != soils.unit_weight
        return self.level is not None and bool(np.any(changes))

    @cached_property
    def lines(self) -> list[Floats]:
        """Tops of layers, water level and ponds above the whole ground."""
        lines = [self.ground, *self.tops]
        if self.level is not None:
            lines.append(self.level)
        return [self._over_ground(line) for line in lines]

    @cached_property
    def _pond_levels(self) -> list[Floats]:
        """Return levels of free water as lines above the whole ground."""
        if self.ponds is None:
            return []
        return [self._over_ground(level_line(level, self.ground)) for level in np.unique(self.ponds.level, axis=0)]

    def _over_ground(self, line: Floats) -> Floats:
        """Return a line continued horizontally to both ends of the ground."""
        x = self.ground[..., 0]
        return continued(line, x.min(), x.max())

    @cached_property
    def lines_cut_by_arcs(self) -> Floats:
        """Boundaries, water levels, and heights below which cohesion increases, as one line with NaN after each."""
        lines = [*self.lines[1:], *self._pond_levels, *self._datum_lines]
        slopes = max(map(len, lines), default=1)
        end = np.full((slopes, 1, 2), np.nan)
        parts = [end]
        for line in lines:
            parts += [np.broadcast_to(line, (slopes, *line.shape[1:])), end]
        return np.concatenate(parts, axis=1)

    @cached_property
    def _datum_lines(self) -> list[Floats]:
        """Return the lines below which the cohesion of layers grows, over the whole ground, (1 or n, V, 2) each."""
        return [self._over_ground(line) for line in self.datums.values()]

    def ground_height(self, x: Floats) -> Floats:
        """Return the height of the ground in m at each x, (n,); with n grounds, of each ground at its own x."""
        by_slope = x[None] if len(self.ground) == 1 else x[:, None]
        height, _ = edge_below(self.lines[0], by_slope, by_slope)
        return np.ravel(height)

    @cached_property
    def columns(self) -> Columns:
        """Columns between all kinks of the lines and of the surcharge."""
        bounds = self._kinks()
        before = bounds[:, :1] - 1.0
        inner = (bounds[:, :-1] + bounds[:, 1:]) / 2
        beyond = bounds[:, -1:] + 1.0
        middle = np.concatenate([before, inner, beyond], axis=1)
        lines, datums = (
            [np.stack(edge_below(line, middle, middle)) for line in of_kind]
            for of_kind in (self.lines, self._datum_lines)
        )
        height, gradient = np.stack([*self._surfaces(lines), *datums], axis=1)
        return Columns(bounds, middle, height, gradient)

    def _kinks(self) -> Floats:
        """Return sorted x of vertices and crossings of lines, and of ends of loads and free water, (1 or n, any)."""
        kinks = [line[:, 1:-1, 0] for line in (*self.lines, *self._datum_lines)]
        kinks += [np.array([[x1, x2]]) for x1, x2, *_ in self.surcharge]
        if self.ponds is not None:
            kinks += [self.ponds.first.T, self.ponds.last.T]
        bounds = _sorted(kinks)
        return _sorted([bounds, _crossings([*self.lines, *self._pond_levels], bounds)])

    @cached_property
    def level_surface(self) -> int:
        """Number of the water level among the surfaces, behind the tops of the layers."""
        return len(self.tops) + 1

    @cached_property
    def datum_surfaces(self) -> Any:
        """Numbers of the surfaces below which the cohesion of each layer grows, 0 for constant cohesion."""
        surfaces = np.zeros(len(self.tops) + 1, dtype=np.int64)
        surfaces[[*self.datums]] = np.arange(-len(self.datums), 0)
        return surfaces

    @cached_property
    def steps(self) -> Floats:
        """Steps of the unit weight below each surface, (surfaces, 1 or n)."""
        unit_weight, saturated = np.broadcast_arrays(self.soils.unit_weight, self.soils.saturated_unit_weight)
        rows = [np.diff(unit_weight, axis=0, prepend=0.0)]
        if self.level is not None:
            rows.append(np.zeros_like(unit_weight[:1]))
        if self.saturates:
            rows.append(np.diff(saturated - unit_weight, axis=0, prepend=0.0))
        return np.concatenate(rows)

    @cached_property
    def weights(self) -> Floats:
        """Sums over the tops of all layers down to each: unit weight step times height, gradient and 1.

        Their shape is (3, layers, 1 or n, columns), and their units are N/m^2, N/m^3 and N/m^3.
        """
        return self._sums(0)

    @cached_property
    def gains(self) -> Floats:
        """Sums as in `weights` of the weight that soils gain below the water level."""
        return self._sums(self.level_surface + 1)

    def _sums(self, first: int) -> Floats:
        """Return sums as in `weights`, (3, layers, 1 or n, columns).

        The tops of layers are the surfaces from index ``first``.
        """
        tops = slice(first, first + len(self.tops) + 1)
        height = self.columns.height[tops]
        values = np.stack([height, self.columns.gradient[tops], np.ones_like(height)]) * self.steps[tops, :, None]
        for k in range(len(self.tops)):  # not by cumsum, which takes several times as long
            values[:, k + 1] += values[:, k]
        return values

    def _surfaces(self, lines: list[Floats]) -> list[Floats]:
        """Return heights and gradients of surfaces, (2, n, columns) each, from those of the lines above the ground.

        The surfaces are the tops of layers, the water level and the tops of wet parts of layers.
        """
        layers = len(self.tops) + 1
        tops = lines[:1]
        for line in lines[1:layers]:
            tops.append(_lower(line, tops[-1]))
        surfaces = list(tops)
        if self.level is not None:
            level = lines[layers]
            surfaces.append(level)
            if self.saturates:
                surfaces += [_lower(top, level) for top in tops]
        return surfaces


def level_line(height: Any, ground: Floats) -> Floats:
    """Return horizontal lines at a height, () or (n,), between the ends of the ground, (1 or n, 2, 2), in m."""
    height = np.reshape(height, (-1, 1))
    ends = ground[:, [0, -1], 0]
    slopes = max(len(height), len(ground))
    x = np.broadcast_to(ends, (slopes, 2))
    return np.stack(np.broadcast_arrays(x, height), axis=-1)


def _sorted(kinks: list[Floats]) -> Floats:
    """Return x of several arrays (1 or n, any) sorted, without repetitions if there is one slope, (1 or n, any)."""
    slopes = max(map(len, kinks))
    of_slopes = [np.broadcast_to(x, (slopes, x.shape[1])) for x in kinks]
    x = np.concatenate(of_slopes, axis=1)
    return np.unique(x, axis=1) if slopes == 1 else np.sort(x, axis=1)


def _crossings(lines: list[Floats], bounds: Floats) -> Floats:
    """Return x where two lines cross between bounds (1 or n, B), in other slopes x of the bound before, (1 or n, any).

    The lines are (1 or n, V, 2) each.

    Lines have kinks at bounds only.
    """
    before = bounds[:, :-1]
    half = np.diff(bounds) / 2
    middle = before + half
    height, gradient = np.stack([edge_below(line, middle, middle) for line in lines], axis=1)
    one, other = np.triu_indices(len(lines), 1)
    apart = height[one] - height[other]
    closing = gradient[other] - gradient[one]
    crosses = np.abs(apart) < half * np.abs(closing)
    divisor = np.where(crosses, closing, 1.0)
    from_middle = apart / divisor
    from_bound = np.where(crosses, half + from_middle, 0.0)
    x = before + from_bound
    by_slope = np.moveaxis(x, 0, 1)
    return by_slope[:, crosses.any(axis=1)]


def _lower(one: Floats, other: Floats) -> Floats:
    """Return height and gradient of the lower of two lines, each (2, ...): height in m and gradient."""
    return np.where(one[0] < other[0], one, other)
