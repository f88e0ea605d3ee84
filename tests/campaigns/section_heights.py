"""Mean pressures and covers of random arcs to 30 digits: ``python -m tests.campaigns.section_heights``, of 2,000.

Grounds with scarps and several stretches, circles of every depth down to a millionth of the chord, through vertices or
not, many of them overhanging, under levels that follow the ground or cross the mass, turned either way. The truth is
the integral of max(0, line - arc) over the arc between all its kinks, at 40 digits, from the coordinates as they are
given; nothing here knows a line of the package but that it builds sections.

Errors are over the greatest height of the line above the arc. A vertex on the circle lies there to rounding of its
coordinates, which is a large part of the depth of a thin mass: it is taken off as what it could be at most.
"""

import contextlib
from itertools import pairwise
from typing import Any, NamedTuple

import mpmath
import numpy as np

from slipcircle import Section
from slipcircle.ground.construction import circle_through

mpmath.mp.dps = 40
Point = tuple[Any, Any]


class Compared(NamedTuple):
    """Errors of the mean pressure and of the mean cover of a section, over the greatest height above its arc."""

    section: Section
    overhangs: bool
    pressure: float
    cover: float


def random_section(rng: np.random.Generator) -> Section:
    """Return a circle through two points of the ground, often its vertices."""
    while True:
        count = int(rng.integers(2, 9))
        x = np.cumsum(np.where(rng.random(count) < 0.15, 0.0, rng.exponential(10.0, count)))
        ground = np.stack([x, rng.normal(0.0, 6.0, count).cumsum()], axis=1)
        ground = np.concatenate([ground[:1] - [80.0, 0.0], ground, ground[-1:] + [80.0, 0.0]])
        ground *= 10.0 ** rng.uniform(-1.0, 3.0)
        below = (rng.random() < 0.7) * rng.exponential(0.02, len(ground)) * np.ptp(ground[1:-1])
        edges = rng.integers(1, count, 2)
        shares = np.sort(rng.random(2)) if edges[0] == edges[1] else rng.random(2) * (rng.random(2) < 0.5)
        ends = ground[edges] + shares[:, None] * (ground[edges + 1] - ground[edges])
        depth = rng.choice([10.0 ** rng.uniform(-6.0, -0.3), rng.uniform(0.2, 0.5)]) * np.hypot(*(ends[1] - ends[0]))
        if ends[1, 0] - ends[0, 0] > 1e-3 * np.abs(ground).max():
            centre, radius = circle_through(*ends, depth=depth)
            level = ground - below[:, None] * [0.0, 1.0]
            with contextlib.suppress(ValueError):
                section = Section(ground, centre, float(radius), 20e3, between=tuple(ends[:, 0].tolist()), level=level)
                if section.half_angle > 1e-9:
                    return section


def line_from_centre(points: Any, section: Any) -> list[Point]:
    """Return a line with its level continuations, over R."""
    radius = mpmath.mpf(float(section.radius))
    line = [tuple((mpmath.mpf(p) - c) / radius for p, c in zip(point, section.centre.tolist(), strict=True))
            for point in np.asarray(points).tolist()]  # fmt: skip
    return [(line[0][0] - 10, line[0][1]), *line, (line[-1][0] + 10, line[-1][1])]


def kinks_of(line: list[Point]) -> list[Any]:
    """Angles on the circle, in three turns, between which the height of a line above it is one formula."""
    angles = [b for x, _ in line if abs(x) < 1 for b in (mpmath.asin(x), mpmath.pi - mpmath.asin(x))]
    for (x, y), (x_2, y_2) in pairwise(line):
        if x_2 > x:
            slope = (y_2 - y) / (x_2 - x)
            share = (slope * x - y) / mpmath.sqrt(1 + slope**2)
            if abs(share) <= 1:
                angles += [mpmath.atan(slope) + sign * mpmath.acos(share) for sign in (-1, 1)]
    return sorted(b + 2 * k * mpmath.pi for b in angles for k in (-2, -1, 0, 1, 2))


def mean_height(line: list[Point], first: Any, last: Any) -> tuple[Any, Any]:
    """Mean height of a line above the arc between two angles, over R; and the greatest height."""
    total, greatest = mpmath.mpf(0), mpmath.mpf(0)
    for low, high in pairwise([first, *(b for b in kinks_of(line) if first < b < last), last]):
        middle = (low + high) / 2
        (x, y), q = next((p, q) for p, q in pairwise(line) if p[0] <= mpmath.sin(middle) <= q[0] and p[0] < q[0])
        slope = (q[1] - y) / (q[0] - x)
        ends, heights, integrals = (low, middle, high), [], []
        for b in ends:
            sine, cosine = mpmath.sin(b), mpmath.cos(b)
            heights.append(y + slope * (sine - x) + cosine)
            integrals.append((y - slope * x) * b - slope * cosine + sine)
        if heights[1] > 0:
            total += integrals[2] - integrals[0]
            greatest = max(greatest, *heights)
    return total / (last - first), greatest


def compared(seed: int, index: int) -> Compared:
    """Return a random section and turn, and the errors of its mean heights."""
    rng = np.random.default_rng([seed, index])
    section: Any = random_section(rng)
    turn = mpmath.mpf(float(rng.choice([0.0, rng.normal(0.0, 0.5), rng.uniform(-3.0, 3.0)])))
    radius, ends = float(section.radius), np.stack([section.entry, section.exit])
    kinks = kinks_of(line_from_centre(section.ground, section))
    angles = np.arctan2(*((ends - section.centre) * [1, -1]).T)
    first, last = sorted(min(kinks, key=lambda b: abs(b - angle)) for angle in angles)
    size = radius + np.abs(section.centre).max() + np.abs(ends).max()
    on_vertex = np.any(np.all(np.abs(ends[:, None] - section.ground) < 1e-13 * size, axis=2))
    steep = min(abs(mpmath.cos(b)) for b in (first, last))  # heights are upright
    rounding = 2.0**-50 * size / radius / steep if on_vertex else 0.0

    def error(mean_over_radius: Any, points: Any, turn: Any) -> float:
        mean, greatest = mean_height(line_from_centre(points, section), first + turn, last + turn)
        return float(max(abs(mean_over_radius - mean) - rounding, 0) / (greatest or 1))

    head = mpmath.mpf(float(section.mean_pressure(float(turn)))) / section.water_unit_weight
    return Compared(
        section,
        bool(first < -mpmath.pi / 2 or last > mpmath.pi / 2),
        error(head / radius, section.level, turn * int(section.facing)),
        error(mpmath.mpf(float(section.mean_cover)) / radius, section.ground, mpmath.mpf(0)),
    )


if __name__ == "__main__":
    every = [compared(24, k) for k in range(2000)]
    print("worst errors over the greatest height:", max(c.pressure for c in every), max(c.cover for c in every))
