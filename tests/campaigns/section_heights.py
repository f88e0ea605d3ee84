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
    section: Section
    turn: float
    overhangs: bool
    pressure: tuple[float, float]  # ours and the error, over the greatest pressure on the arc
    cover: tuple[float, float]


def _sections(rng: np.random.Generator) -> Section:
    """One of any kind."""
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


def _radius(section: Section) -> float:
    return float(np.asarray(section.radius))


def _line(points: Any, section: Section) -> list[Point]:
    """A line with its level continuations, from the centre and over R."""
    (x_0, y_0), radius = map(mpmath.mpf, np.asarray(section.centre).tolist()), mpmath.mpf(_radius(section))
    line = [((mpmath.mpf(x) - x_0) / radius, (mpmath.mpf(y) - y_0) / radius) for x, y in np.asarray(points).tolist()]
    return [(line[0][0] - 10, line[0][1]), *line, (line[-1][0] + 10, line[-1][1])]


def _end(section: Section, end: Any) -> Any:
    """Angle of an end of the arc: of the vertex that it is, else of the crossing next to it."""
    (x_0, y_0), radius = np.asarray(section.centre), _radius(section)
    near = complex(end[0] - x_0, end[1] - y_0) / radius
    found: list[tuple[float, Any]] = []
    line = _line(section.ground, section)
    for x, y in line:
        if abs(complex(x, y) - near) < 1e-13 * (1 + abs(complex(x_0, y_0)) / radius):
            return mpmath.atan2(x, -y)
    for (x, y), (x_2, y_2) in pairwise(line):
        u, v = x_2 - x, y_2 - y
        a, b, c = u * u + v * v, x * u + y * v, x * x + y * y - 1
        root = mpmath.sqrt(max(b * b - a * c, 0))
        for share in ((-b - root) / a, (-b + root) / a):
            if 0 <= share <= 1:
                at = x + share * u, y + share * v
                found.append((abs(complex(*at) - near), mpmath.atan2(at[0], -at[1])))
    return min(found, key=lambda pair: pair[0])[1]


def _kinks(line: list[Point], first: Any, last: Any) -> list[Any]:
    """Angles between which the height of a line above the arc is one formula."""
    angles = [mpmath.asin(x) for x, _ in line if abs(x) < 1]
    angles += [mpmath.pi - b for b in angles]
    for (x, y), (x_2, y_2) in pairwise(line):
        if x_2 > x:
            slope = (y_2 - y) / (x_2 - x)
            share = (slope * x - y) / mpmath.sqrt(1 + slope**2)
            if abs(share) <= 1:
                angles += [mpmath.atan(slope) + sign * mpmath.acos(share) for sign in (-1, 1)]
    inner = [b + 2 * k * mpmath.pi for b in angles for k in (-2, -1, 0, 1, 2)]
    return [first, *sorted(b for b in inner if first < b < last), last]


def mean_height(line: list[Point], first: Any, last: Any) -> tuple[Any, Any]:
    """Of a line above the arc between two angles, over R; and the greatest."""
    total, greatest = mpmath.mpf(0), mpmath.mpf(0)
    for low, high in pairwise(_kinks(line, first, last)):
        middle, half = (low + high) / 2, (high - low) / 2
        x = mpmath.sin(middle)
        (x_1, y), (x_2, y_2) = next((p, q) for p, q in pairwise(line) if p[0] <= x <= q[0] and p[0] < q[0])
        slope = (y_2 - y) / (x_2 - x_1)

        def height(b: Any, y: Any = y, slope: Any = slope, x_1: Any = x_1) -> Any:
            return y + slope * (mpmath.sin(b) - x_1) + mpmath.cos(b)

        if height(middle) > 0:
            total += half * sum(w * height(middle + half * node) for node, w in _RULE)
            greatest = max(greatest, height(low), height(middle), height(high))
    return total / (last - first), greatest


def compared(seed: int, index: int) -> Compared:
    """A random section and turn: ours, and errors over the greatest height of the line above the arc."""
    rng = np.random.default_rng([seed, index])
    section, turn = _sections(rng), float(rng.choice([0.0, rng.normal(0.0, 0.5), rng.uniform(-3.0, 3.0)]))
    first, last = sorted(_end(section, end) for end in (section.entry, section.exit))
    radius, gamma = mpmath.mpf(_radius(section)), mpmath.mpf(section.water_unit_weight)
    turned = mpmath.mpf(turn) * int(section.facing)

    size = float(radius) + np.abs(section.centre).max() + np.abs([section.entry, section.exit]).max()
    ends = np.stack([section.entry, section.exit])[:, None]
    on_vertex = bool(np.any(np.all(np.abs(ends - section.ground) < 1e-13 * size, axis=2)))
    steep = min(abs(np.cos(float(b))) for b in (first, last))  # heights are upright
    rounding = 2.0**-50 * size / float(radius) / steep if on_vertex else 0.0

    def judged(ours: float, points: Any, turn: Any, unit: Any) -> tuple[float, float]:
        mean, greatest = mean_height(_line(points, section), first + turn, last + turn)
        error = max(abs(ours / unit - mean) - rounding, 0)
        return ours, float(error / greatest) if greatest else float(error)

    return Compared(
        section,
        turn,
        bool(first < -mpmath.pi / 2 or last > mpmath.pi / 2),
        judged(float(section.mean_pressure(turn)), section.level, turned, radius * gamma),
        judged(float(section.mean_cover), section.ground, mpmath.mpf(0), radius),
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=24)
    options = parser.parse_args()
    every = [compared(options.seed, k) for k in range(options.count)]
    wet, overhang = sum(c.pressure[0] > 0.0 for c in every), sum(c.overhangs for c in every)
    half = np.array([float(c.section.half_angle) for c in every])
    print(f"{len(every)} arcs, {wet} wet, {overhang} overhang; errors over the greatest height")
    for name, errors in (("pressure", [c.pressure[1] for c in every]), ("cover", [c.cover[1] for c in every])):
        k = int(np.argmax(errors))
        by_angle = np.max(np.array(errors) * half)
        print(f"{name}: worst {errors[k]:.1e} (arc {k}, alpha {half[k]:.2g}), worst times alpha {by_angle:.1e}")


if __name__ == "__main__":
    main()
