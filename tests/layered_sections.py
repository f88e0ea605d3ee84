"""Layered sections against their definitions: random ones, and quadrature to 30 digits that knows nothing of strips.

``python tests/layered_sections.py --count 200 --seed 1`` compares the moments and the parts of J_r, of its slope and
of I_p on the stretches of every soil, and prints the largest differences.
"""

import argparse
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

import mpmath as mp
import numpy as np

from slipcircle.core.scene.layers import LayeredSection, Soil

DIGITS = 30
NAMES = ("weight", "weight rho", "weight rho^2", "weight x/rho", "weight y/rho", "weight x", "weight y")


def random_section(rng: np.random.Generator, **given: Any) -> LayeredSection:
    """A section with up to four layers: wavy, crossing and level boundaries, one soil twice, thin seams."""
    while True:
        facing = rng.choice([-1, 1])
        x = np.concatenate([[-120.0], np.sort(rng.uniform(-60, 80, 4)), [160.0]])
        y = np.concatenate([[25.0], np.sort(rng.uniform(0, 25, 4))[::-1], [0.0]])
        ground = np.column_stack([x, y])[::facing] * [facing, 1]
        tops: list[Any] = []
        for kind in rng.integers(0, 4, rng.integers(1, 4)):
            if kind == 0:
                tops.append(float(rng.uniform(-10, 22)))
            elif kind == 1 and tops and np.ndim(tops[-1]) == 0:
                tops.append(tops[-1] - float(rng.choice([0.02, 0.5])))  # a seam
            else:
                count = rng.integers(2, 7)
                tops.append(np.column_stack([np.sort(rng.uniform(-100, 100, count)), rng.uniform(-12, 24, count)]))
        soils = [
            Soil(rng.uniform(15e3, 22e3), rng.uniform(0, 2e4), rng.uniform(0.0, 0.8), name=f"soil {k}")
            for k in range(len(tops) + 1)
        ]
        if len(tops) > 1:
            soils[2] = soils[0]
        centre = (rng.uniform(-10, 40) * facing, rng.uniform(28, 70))
        layers = list(zip(soils, [None, *tops], strict=True))
        try:
            section = LayeredSection(ground, centre, rng.uniform(30, 80), layers=layers, **given)
        except ValueError:
            continue
        if section.no_motion is None and max(np.abs(section._angles)) < 1.5:
            return section


def _line(points: Any) -> list[tuple[mp.mpf, mp.mpf]]:
    points = np.asarray(points, dtype=np.float64)
    if points.ndim == 0:
        points = np.array([[-1.0, points], [1.0, points]])
    inner = [(mp.mpf(float(x)), mp.mpf(float(y))) for x, y in points]
    return [(mp.mpf(-1000), inner[0][1]), *inner, (mp.mpf(1000), inner[-1][1])]


def _height(line: list[tuple[mp.mpf, mp.mpf]], x: mp.mpf) -> mp.mpf:
    for (x1, y1), (x2, y2) in zip(line, line[1:], strict=False):
        if x1 <= x <= x2 and x2 > x1:
            return y1 + (y2 - y1) * (x - x1) / (x2 - x1)
    raise AssertionError(x)


def _kinks(lines: list[Any], cx: mp.mpf, cy: mp.mpf, radius: mp.mpf) -> Iterator[mp.mpf]:
    """x of vertices, of crossings of lines with each other and with the circle."""
    edges = [edge for line in lines for edge in zip(line, line[1:], strict=False)]
    for (x1, y1), (x2, y2) in edges:
        yield x1
        u, v = x2 - x1, y2 - y1
        p, q = x1 - cx, y1 - cy
        a, b, c = u * u + v * v, p * u + q * v, p * p + q * q - radius**2
        if a > 0 and b * b > a * c:
            for sign in (-1, 1):
                s = (-b + sign * mp.sqrt(b * b - a * c)) / a
                if 0 <= s <= 1:
                    yield x1 + s * u
        for (x3, y3), (x4, y4) in edges:
            w, z = x4 - x3, y4 - y3
            across = u * z - v * w
            if across != 0:
                s = ((x3 - x1) * z - (y3 - y1) * w) / across
                t = ((x3 - x1) * v - (y3 - y1) * u) / across
                if 0 < s < 1 and 0 < t < 1:
                    yield x1 + s * u


def reference(section: LayeredSection) -> tuple[list[mp.mpf], list[list[mp.mpf]]]:
    """Moments `NAMES` about the centre, x down-slope, and for each layer the parts of J_r, its slope and I_p at its base.

    Strips of no width: over x the integral of the weight's closed integral over y; in N, m and rad.
    """
    with mp.workdps(DIGITS + 5):
        (cx, cy), radius = (mp.mpf(float(v)) for v in section.centre), mp.mpf(float(section.radius))  # type: ignore[union-attr]
        facing = int(section.facing)
        lines = [_line(section.ground), *(_line(top) for _, top in section.layers[1:])]
        weights = [mp.mpf(float(soil.unit_weight)) for soil, _ in section.layers]
        left, right = sorted((mp.mpf(float(section.entry[0])), mp.mpf(float(section.exit[0]))))
        every = sorted({x for x in _kinks(lines, cx, cy, radius)})
        left, right = (min(every, key=lambda x: abs(x - end)) for end in (left, right))
        cuts = [left, *(x for x in every if left < x < right), right]
        moments = [mp.mpf(0)] * 7
        parts = [[mp.mpf(0)] * 3 for _ in lines]
        for a, b in zip(cuts, cuts[1:], strict=False):
            if b - a < mp.mpf(10) ** -(DIGITS - 5):
                continue
            middle = (a + b) / 2
            arc = cy - mp.sqrt(radius**2 - (middle - cx) ** 2)
            envelope = [min(_height(line, middle) for line in lines[: k + 1]) for k in range(len(lines))]
            base = max(sum(top > arc for top in envelope) - 1, 0)
            chosen = [min(lines[: k + 1], key=lambda line: _height(line, middle)) for k in range(len(lines))]
            for k, line in enumerate(chosen):
                step = weights[k] - (weights[k - 1] if k else 0)
                if step == 0 or envelope[k] <= arc:
                    continue

                def column(x: mp.mpf, line: Any = line) -> list[mp.mpf]:
                    """Integrals over y of 1, rho, rho^2, x/rho, y/rho, x, y."""
                    u = x - cx
                    low, high = -mp.sqrt(radius**2 - u * u), _height(line, x) - cy
                    rho_1, rho_2 = (mp.sqrt(u * u + v * v) for v in (low, high))
                    log = mp.log((high + rho_2) / (low + rho_1)) if high > 0 else mp.log((rho_1 - low) / (rho_2 - high))
                    return [
                        high - low,
                        (high * rho_2 - low * rho_1 + u * u * log) / 2,
                        u * u * (high - low) + (high**3 - low**3) / 3,
                        facing * u * log,
                        rho_2 - rho_1,
                        facing * u * (high - low),
                        (high**2 - low**2) / 2,
                    ]

                sums = integrated(column, a, b)
                moments = [m + step * n for m, n in zip(moments, sums, strict=True)]
                for row, n in enumerate((-sums[4], sums[3], sums[1])):
                    parts[base][row] += step * n
        return moments, parts


@lru_cache
def _rule(degree: int) -> list[tuple[mp.mpf, mp.mpf]]:
    return list(mp.calculus.quadrature.GaussLegendre(mp.mp).calc_nodes(degree, mp.mp.prec))


def integrated(column: Any, a: mp.mpf, b: mp.mpf) -> list[mp.mpf]:
    """Integrals over x by Gauss' rules of 24 and 48 points, halved until they agree to 20 digits."""
    middle, half = (a + b) / 2, (b - a) / 2
    values = []
    for degree in (4, 5):
        total = [mp.mpf(0)] * 7
        for node, weight in _rule(degree):
            total = [s + half * weight * v for s, v in zip(total, column(middle + half * node), strict=True)]
        values.append(total)
    size = max(map(abs, values[1]))
    if all(abs(x - y) <= size * mp.mpf(10) ** -20 for x, y in zip(*values, strict=True)):
        return values[1]
    return [x + y for x, y in zip(integrated(column, a, middle), integrated(column, middle, b), strict=True)]


def computed(section: LayeredSection) -> tuple[list[float], list[list[float]]]:
    """The same by the package."""
    radius, facing = float(section.radius), float(section.facing)  # type: ignore[arg-type]
    powers, signs = np.array([2, 3, 4, 2, 2, 3, 3]), np.array([1, 1, 1, facing, 1, facing, 1])
    moments = section._weighted[:, 0] * radius**powers * signs
    still = section._parts(np.zeros((1, 1)))[..., 0, 0]
    parts = []
    for k in range(len(section.layers)):
        one = np.zeros((len(section.soils), 1))
        one[k] = 1.0
        differences = section._stretches.differences(one)[:, 0]
        sums = np.einsum("j,s,ijs->i", differences, section._surfaces[1][:, 0], still)
        parts.append([-sums[4] * radius**2, sums[3] * radius**2, sums[1] * radius**3])
    return moments.tolist(), parts


def differences(section: LayeredSection) -> tuple[float, float]:
    """The largest difference of the moments and of the parts, relative: of vectors to their length."""
    (moments, parts), (exact, exact_parts) = computed(section), reference(section)
    sizes = [float(abs(v)) for v in exact]
    for i, j in ((3, 4), (5, 6)):
        sizes[i] = sizes[j] = float(np.hypot(sizes[i], sizes[j]))
    of_moments = max(abs(a - float(b)) / s for a, b, s in zip(moments, exact, sizes, strict=True))
    whole = [sizes[4], sizes[4], sizes[1]]
    of_parts = max(
        abs(a - float(b)) / s for p, q in zip(parts, exact_parts, strict=True) for a, b, s in zip(p, q, whole, strict=True)
    )
    return of_moments, of_parts


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    rng = np.random.default_rng(asked.seed)
    found = np.array([differences(random_section(rng)) for _ in range(asked.count)])
    print(f"{asked.count} layered sections: moments within {found[:, 0].max():.1e}, stretches within {found[:, 1].max():.1e}")
