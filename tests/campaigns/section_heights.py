"""Mean pressures and covers of random arcs to 30 digits: ``python -m tests.campaigns.section_heights --count 2000``.

Grounds with scarps and several stretches, circles of every depth down to a millionth of the chord, through vertices or
not, many of them overhanging, under levels that follow the ground or cross the mass, turned either way. The truth is
the integral of max(0, line - arc) over the arc by Gauss' rule between all its kinks, at 40 digits, from the coordinates
as they are given; nothing here knows a line of the package but that it builds sections.

Errors are over the greatest height of the line above the arc. A vertex on the circle lies there to rounding of its
coordinates, which is a large part of the depth of a thin mass: it is taken off as what it could be at most.
"""

import argparse
from itertools import pairwise
from typing import Any, NamedTuple

import mpmath
import numpy as np

from slipcircle import Section
from slipcircle.core.scene.ground import circle_through

mpmath.mp.dps = 40
_RULE = [
    (mpmath.mpf(x), mpmath.mpf(w)) for x, w in mpmath.calculus.quadrature.GaussLegendre(mpmath.mp).calc_nodes(4, 160)
]
Point = tuple[Any, Any]


class Compared(NamedTuple):
    """Errors of the mean pressure and of the mean cover of a section, over the greatest height above its arc."""

    section: Section
    overhangs: bool
    wet: bool
    pressure: float
    cover: float


def random_section(rng: np.random.Generator) -> Section:
    """A section of any kind."""
    while True:
        count = int(rng.integers(2, 9))
        x = np.cumsum(np.where(rng.random(count) < 0.15, 0.0, rng.exponential(10.0, count)))
        ground = np.stack([x, rng.normal(0.0, 6.0, count).cumsum()], axis=1)
        ground = np.concatenate([ground[:1] - [80.0, 0.0], ground, ground[-1:] + [80.0, 0.0]])
        ground *= 10.0 ** rng.uniform(-1.0, 3.0)
        below = np.where(rng.random() < 0.3, 0.0, rng.exponential(0.02, len(ground)) * np.ptp(ground[1:-1]))
        level = ground - np.stack([np.zeros(len(ground)), below], axis=1)
        kind, between = rng.choice(["any", "any", "through", "thin"]), None
        if kind == "any":
            centre = np.array([rng.choice(ground[1:-1, 0]), 0.0]) + rng.normal(0.0, 0.1, 2) * np.ptp(ground[1:-1])
            radius = float(rng.uniform(0.05, 1.0) * np.ptp(ground[1:-1]))
        else:
            first, last = np.sort(rng.choice(np.arange(1, count + 1), 2, replace=False))
            ends = ground[[first, last]]
            if kind == "thin":
                ends = ground[first] + np.sort(rng.random(2))[:, None] * (ground[first + 1] - ground[first])
            depth = 10.0 ** rng.uniform(-6.0, -0.3) * np.hypot(*(ends[1] - ends[0]))
            if not ends[1, 0] > ends[0, 0] or depth == 0.0:
                continue
            centre, radius = circle_through(*ends, depth=depth)
            between = float(ends[0, 0]), float(ends[1, 0])
        try:
            return Section(ground, centre, float(radius), 20e3, between=between, level=level)
        except ValueError:
            continue


def _line(points: Any, section: Any) -> list[Point]:
    """A line with its level continuations, from the centre and over R."""
    x_0, y_0, radius = map(mpmath.mpf, [*np.asarray(section.centre).tolist(), float(section.radius)])
    line = [((mpmath.mpf(x) - x_0) / radius, (mpmath.mpf(y) - y_0) / radius) for x, y in np.asarray(points).tolist()]
    return [(line[0][0] - 10, line[0][1]), *line, (line[-1][0] + 10, line[-1][1])]


def _kinks(line: list[Point]) -> list[Any]:
    """Angles on the circle, in three turns, between which the height of a line above it is one formula."""
    angles = [mpmath.asin(x) for x, _ in line if abs(x) < 1]
    angles += [mpmath.pi - b for b in angles]
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
    for low, high in pairwise([first, *(b for b in _kinks(line) if first < b < last), last]):
        middle, half = (low + high) / 2, (high - low) / 2
        x = mpmath.sin(middle)
        p, q = next((p, q) for p, q in pairwise(line) if p[0] <= x <= q[0] and p[0] < q[0])
        angles = [middle, low, high, *(middle + half * node for node, _ in _RULE)]
        heights = [p[1] + (q[1] - p[1]) / (q[0] - p[0]) * (mpmath.sin(b) - p[0]) + mpmath.cos(b) for b in angles]
        if heights[0] > 0:
            total += half * sum(weight * h for (_, weight), h in zip(_RULE, heights[3:], strict=True))
            greatest = max(greatest, *heights[:3])
    return total / (last - first), greatest


def compared(seed: int, index: int) -> Compared:
    """A random section and turn, and the errors of its mean heights."""
    rng = np.random.default_rng([seed, index])
    section: Any = random_section(rng)
    turn = float(rng.choice([0.0, rng.normal(0.0, 0.5), rng.uniform(-3.0, 3.0)]))
    radius, ends = float(section.radius), np.stack([section.entry, section.exit])
    from_centre = ends - section.centre
    kinks = _kinks(_line(section.ground, section))
    first, last = sorted(min(kinks, key=lambda b: abs(b - angle)) for angle in np.arctan2(*(from_centre * [1, -1]).T))

    size = radius + np.abs(section.centre).max() + np.abs(ends).max()
    on_vertex = bool(np.any(np.all(np.abs(ends[:, None] - section.ground) < 1e-13 * size, axis=2)))
    steep = min(abs(np.cos(float(b))) for b in (first, last))  # heights are upright
    rounding = 2.0**-50 * size / radius / steep if on_vertex else 0.0

    def error(mean_over_radius: Any, points: Any, turn: Any) -> float:
        mean, greatest = mean_height(_line(points, section), first + turn, last + turn)
        return float(max(abs(mean_over_radius - mean) - rounding, 0) / (greatest or 1))

    pressure = float(section.mean_pressure(turn))
    head = mpmath.mpf(pressure) / section.water_unit_weight / radius
    return Compared(
        section,
        bool(first < -mpmath.pi / 2 or last > mpmath.pi / 2),
        pressure > 0.0,
        error(head, section.level, mpmath.mpf(turn) * int(section.facing)),
        error(mpmath.mpf(float(section.mean_cover)) / radius, section.ground, mpmath.mpf(0)),
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=24)
    options = parser.parse_args()
    every = [compared(options.seed, k) for k in range(options.count)]
    half = np.array([float(c.section.half_angle) for c in every])
    wet, overhangs = sum(c.wet for c in every), sum(c.overhangs for c in every)
    print(f"{len(every)} arcs, {wet} wet, {overhangs} overhang; errors over the greatest height")
    for name in ("pressure", "cover"):
        errors = np.array([getattr(c, name) for c in every])
        k = int(np.argmax(errors))
        print(f"{name}: worst {errors[k]:.1e} (arc {k}, alpha {half[k]:.2g}), times alpha {np.max(errors * half):.1e}")


if __name__ == "__main__":
    main()
