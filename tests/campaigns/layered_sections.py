"""Layered sections against their definitions: random ones, and quadrature to 30 digits that knows nothing of strips.

``python -m tests.campaigns.layered_sections --count 200 --seed 1`` compares the moments and the parts of J_r, of its
slope and of I_p on the stretches of every soil, and prints the largest differences.
"""

import argparse
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import Any

import mpmath as mp
import numpy as np

from slipcircle.core import LayeredSection, Soil

DIGITS = 30
NAMES = ("weight", "weight rho", "weight rho^2", "weight x/rho", "weight y/rho", "weight x", "weight y")


def random_section(rng: np.random.Generator, everything: bool = False, **given: Any) -> LayeredSection:
    """A section with up to four layers: wavy, crossing and level boundaries, one soil twice, thin seams.

    With everything also a water level, saturated weights, cohesion with depth, pore pressure ratios and surcharges.
    """
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
        soils = []
        for k in range(len(tops) + 1):
            more: dict[str, Any] = {}
            if everything:
                more = {"cohesion_gradient": rng.choice([0.0, 800.0]), "datum": float(rng.uniform(-5, 20))}
                more |= {
                    "pore_ratio": rng.choice([0.0, 0.0, 0.2]),
                    "saturated_unit_weight": 23e3 if rng.random() < 0.5 else None,
                }
            strength = rng.uniform(0, 2e4), rng.uniform(0.0, 0.8)
            soils.append(Soil(rng.uniform(15e3, 22e3), *strength, name=f"soil {k}", **more))
        if everything:
            loads = [(float(x), float(x + rng.uniform(2, 20)), *(5e4 * rng.random(2))) for x in rng.uniform(-30, 30, 2)]
            given = {**given, "level": ground - [0.0, rng.uniform(0, 4)], "surcharge": loads}
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
    for (x1, y1), (x2, y2) in pairwise(line):
        if x1 <= x <= x2 and x2 > x1:
            return y1 + (y2 - y1) * (x - x1) / (x2 - x1)
    raise AssertionError(x)


def _kinks(lines: list[Any], cx: mp.mpf, cy: mp.mpf, radius: mp.mpf) -> Iterator[mp.mpf]:
    """x of vertices, of crossings of lines with each other and with the circle."""
    edges = [edge for line in lines for edge in pairwise(line)]
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


def reference(section: Any) -> tuple[list[mp.mpf], list[list[mp.mpf]]]:
    """Moments `NAMES` about the centre, x down-slope; for each layer the parts of J_r, its slope and I_p at its base.

    Strips of no width: over x the integral of the weight's closed integral over y; in N, m and rad.
    """
    with mp.workdps(DIGITS + 5):
        (cx, cy), radius = (mp.mpf(float(v)) for v in section.centre), mp.mpf(float(section.radius))
        facing = int(section.facing)
        lines = [_line(section.ground), *(_line(top) for _, top in section.layers[1:])]
        weights = [mp.mpf(float(soil.unit_weight)) for soil, _ in section.layers]
        left, right = sorted((mp.mpf(float(section.entry[0])), mp.mpf(float(section.exit[0]))))
        every = sorted(set(_kinks(lines, cx, cy, radius)))
        left, right = (min(every, key=lambda x: abs(x - end)) for end in (left, right))
        cuts = [left, *(x for x in every if left < x < right), right]
        moments = [mp.mpf(0)] * 7
        parts = [[mp.mpf(0)] * 3 for _ in lines]
        for a, b in pairwise(cuts):
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


def computed(section: Any) -> tuple[list[float], list[list[float]]]:
    """The same by the package."""
    radius, facing = float(section.radius), float(section.facing)
    powers, signs = np.array([2, 3, 4, 2, 2, 3, 3]), np.array([1, 1, 1, facing, 1, facing, 1])
    moments = section._weighted[:, 0] * radius**powers * signs
    still = section.arc_strength.parts(np.zeros((1, 1)))[..., 0, 0]
    parts = []
    for k in range(len(section.layers)):
        one = np.zeros((len(section.soils), 1))
        one[k] = 1.0
        differences = section.arc_strength.stretches.differences(one)[:, 0]
        sums = np.einsum("j,s,ijs->i", differences, section._surfaces[1][:, 0], still)
        parts.append([-sums[4] * radius**2, sums[3] * radius**2, sums[1] * radius**3])
    return moments.tolist(), parts


def strength_by_quadrature(section: Any, rotation: float, omega_2: float) -> tuple[Any, Any]:
    """Friction, water's part of it, and cohesion after a rotation, and by Gauss' rule along 40,000 pieces of the arc.

    Over the weights towards the arc at rest; ``omega_2`` is omega*^2.
    """
    radius, (cx, cy) = float(section.radius), map(float, section.centre)
    facing = float(section.facing)
    span: Any = [float(end[0]) for end in section.arc_strength.span]
    lines = [np.asarray(section.ground), *(np.asarray(top) for _, top in section.layers[1:])]
    soils = [soil for soil, _ in section.layers]

    def height(line: Any, x: Any) -> Any:
        return np.interp(x, *line.T) if line.ndim else np.full_like(x, line)

    def arc(b: Any) -> tuple[Any, Any]:
        return cx + facing * radius * np.sin(b), cy - radius * np.cos(b)

    def soil_at(b: Any) -> Any:
        """The soil below the arc; at its ends the ground has no thickness, and that just inside counts."""
        x, y = arc(np.clip(b, span[0] + 1e-6, span[1] - 1e-6))
        tops = np.minimum.accumulate([height(line, x) for line in lines], axis=0)
        return np.maximum(np.count_nonzero(tops > y, axis=0) - 1, 0)

    joints = section.arc_strength.stretches.joint[0]
    kinks = [*span, *joints, *(joints - rotation), *(facing * section._strips.beta[0])]
    edges = np.unique(np.clip(np.concatenate([np.linspace(span[0], span[1], 40_001), kinks]), *span))
    nodes, weights = np.polynomial.legendre.leggauss(4)
    half = np.diff(edges) / 2
    b = edges[:-1] + half * (1.0 + nodes[:, None])
    x, y = arc(b)
    along = facing * (x - cx)
    level = height(np.asarray(section.level), x) if section.level is not None else None
    radial, tangential, inertia, vertical = (np.zeros_like(b) for _ in range(4))

    def add(step: float, top: Any) -> None:
        """A surface: integrals over y of -y/rho, x/rho and rho, and the height, times the step of the unit weight."""
        nonlocal radial, tangential, inertia, vertical
        low, high = y - cy, np.maximum(top, y) - cy
        rho_1, rho_2 = np.hypot(along, low), np.hypot(along, high)
        log = np.arcsinh(high / np.abs(along)) - np.arcsinh(low / np.abs(along))
        radial = radial + step * (rho_1 - rho_2)
        tangential = tangential + step * along * log
        inertia = inertia + step * (high * rho_2 - low * rho_1 + along**2 * log) / 2
        vertical = vertical + step * (high - low)

    above, wet_above, top = 0.0, 0.0, np.full_like(x, np.inf)
    for soil, line in zip(soils, lines, strict=True):
        top = np.minimum(top, height(line, x))
        add(soil.unit_weight - above, top)
        above = soil.unit_weight
        wet = 0.0 if soil.saturated_unit_weight is None else soil.saturated_unit_weight - above
        if level is not None:
            add(wet - wet_above, np.minimum(top, level))
        wet_above = wet
    overburden = vertical.copy()
    on_ground = height(lines[0], x) - cy
    for x1, x2, q1, q2 in section.surcharge:
        q = np.where((x >= x1) & (x <= x2), q1 + (q2 - q1) * (x - x1) / (x2 - x1), 0.0)
        rho = np.hypot(along, on_ground)
        radial, tangential, inertia = radial - q * on_ground / rho, tangential + q * along / rho, inertia + q * rho
    base = b + rotation if section.strength == "base" else b

    def of_base(name: str) -> Any:
        return np.array([getattr(soil, name) for soil in soils], dtype=np.float64)[soil_at(base)]

    there_x, there_y = arc(b + rotation)
    head = np.maximum(height(np.asarray(section.level), there_x) - there_y, 0.0) if section.level is not None else 0.0
    ratio, mu = of_base("pore_ratio"), of_base("peak")
    pressure = np.where(ratio > 0.0, ratio * overburden, section.water_unit_weight * head)
    cohesion = of_base("cohesion")
    if any(soil.datum is not None for soil in soils):
        _, depth = arc(np.clip(base, *span))
        cohesion = cohesion + of_base("cohesion_gradient") * np.maximum(of_base("datum") - depth, 0.0)

    def integral(values: Any) -> float:
        return float((half * weights[:, None] * values).sum())

    turned = radial * np.cos(rotation) - tangential * np.sin(rotation) + omega_2 * inertia / radius
    scale = radius * integral(radial * np.cos(b))
    expected = [
        radius * integral(mu * turned * np.cos(b)),
        radius * integral(mu * pressure),
        radius * integral(cohesion),
    ]

    moments, terms = section._per_mean_weight[:, 0], section.arc_strength.terms
    at = np.array([[rotation]])

    def term(name: str) -> float:
        return float(terms[name](at)[0, 0]) if name in terms else 0.0

    theta = float(moments[2])
    whole = -moments[4] * np.cos(rotation) - facing * moments[3] * np.sin(rotation) + omega_2 * moments[1]
    beyond = theta * (term("normal") + omega_2 * term("inertia"))
    if section.strength == "mass":
        turning = terms.get("turning", 0.0) * np.cos(rotation) - terms.get("turning_slope", 0.0) * np.sin(rotation)
        beyond += theta * float(turning)
    unit = float(np.ravel(section.mean_unit_weight)[0]) * radius**2
    mean = float(section.arc_strength.mean_peak[0])
    computed = [mean * (whole + beyond) * unit, mean * theta * term("lift") * unit, theta * term("strength") * unit]
    return np.array(computed) / scale, np.array(expected) / scale


def differences(section: LayeredSection) -> tuple[float, float]:
    """The largest difference of the moments and of the parts, relative: of vectors to their length."""
    (moments, parts), (exact, exact_parts) = computed(section), reference(section)
    sizes = [float(abs(v)) for v in exact]
    for i, j in ((3, 4), (5, 6)):
        sizes[i] = sizes[j] = float(np.hypot(sizes[i], sizes[j]))
    of_moments = max(abs(a - float(b)) / s for a, b, s in zip(moments, exact, sizes, strict=True))
    whole = [sizes[4], sizes[4], sizes[1]]
    of_parts = max(
        abs(a - float(b)) / s
        for p, q in zip(parts, exact_parts, strict=True)
        for a, b, s in zip(p, q, whole, strict=True)
    )
    return of_moments, of_parts


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    rng = np.random.default_rng(asked.seed)
    found = np.array([differences(random_section(rng)) for _ in range(asked.count)])
    print(
        f"{asked.count} layered sections: moments within {found[:, 0].max():.1e}, "
        f"stretches within {found[:, 1].max():.1e}"
    )
