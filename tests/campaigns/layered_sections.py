"""Random layered sections against the definitions of their moments and of the strength along the arc.

``python -m tests.campaigns.layered_sections --count 200 --motions 40 --seed 1`` compares the moments and the parts of
J_r, of its slope and of I_p on the stretches of every soil with quadrature, and motions with collocation of the
definition along the arc between its kinks; it prints the largest differences.
"""

import argparse
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.polynomial import Legendre
from scipy.optimize import brentq

from slipcircle import Scene, solve
from slipcircle.core import LayeredSection, Soil
from slipcircle.core.scene.strength import Needs

COLLOCATION, COLLOCATION_WEIGHTS = np.polynomial.legendre.leggauss(10)


def random_section(
    rng: np.random.Generator, everything: bool = False, strongest: float = 1.0, **given: Any
) -> LayeredSection:
    """A section with up to four layers: wavy, crossing and level boundaries, one soil twice, thin seams.

    Strengths are up to 20 kPa and a friction coefficient of 0.8, times ``strongest``. With everything also a water
    level, saturated weights, cohesion with depth, pore pressure ratios and surcharges.
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
            strength = strongest * rng.uniform(0, 2e4), strongest * rng.uniform(0.0, 0.8)
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


def coefficient(law: Any, slip: float) -> float:
    """A soil's friction coefficient from the definition of its law."""
    if not isinstance(law, dict):
        return float(law)
    return float(law["residual"] + (law["peak"] - law["residual"]) * np.exp(-slip / law["length"]))


class AlongTheArc:
    """A section's weights and strengths along its arc from their definitions, by Gauss' rule between kinks.

    Directions b are from straight below the centre, down-slope positive; the arc is ``(x, y)`` there. Of the package
    it takes the section's numbers, and where to break the integrals.
    """

    def __init__(self, section: Any, points: int = 24) -> None:
        self.section = section
        self.radius = float(section.radius)
        self.cx, self.cy = map(float, section.centre)
        self.facing = float(section.facing)
        self.first, self.last = (float(end[0]) for end in section.arc_strength.span)
        self.lines = [np.asarray(section.ground), *(np.asarray(top) for _, top in section.layers[1:])]
        self.soils = [soil for soil, _ in section.layers]
        self.level = None if section.level is None else np.asarray(section.level)
        self.nodes, self.weights = np.polynomial.legendre.leggauss(points)
        self.joints = section.arc_strength.stretches.joint[0]
        self.of_mass = np.concatenate([[self.first, self.last], self.facing * section._strips.beta[0]])
        b, step = self.broken_at([])
        self.moments = {name: float((step * value).sum()) for name, value in self.strips(b).items()}

    def arc(self, b: Any) -> tuple[Any, Any]:
        return self.cx + self.facing * self.radius * np.sin(b), self.cy - self.radius * np.cos(b)

    def height(self, line: Any, x: Any) -> Any:
        return np.interp(x, *line.T) if line.ndim else np.full_like(x, line)

    def broken_at(self, kinks: Any) -> tuple[Any, Any]:
        """Directions of nodes between kinks of the mass and these, and their steps."""
        every = np.concatenate([self.of_mass, np.asarray(kinks, dtype=np.float64)])
        every = np.concatenate([every, np.linspace(self.first, self.last, 9)])
        edges = np.unique(np.clip(every, self.first, self.last))
        edges = edges[np.concatenate([[True], np.diff(edges) > 1e-13])]
        half = np.diff(edges) / 2
        return edges[:-1] + half * (1.0 + self.nodes[:, None]), half * self.weights[:, None]

    def soil_at(self, b: Any) -> Any:
        """The soil below the arc; at its ends the ground has no thickness, and that just inside counts."""
        x, y = self.arc(np.clip(b, self.first + 1e-6, self.last - 1e-6))
        tops = np.minimum.accumulate([self.height(line, x) for line in self.lines], axis=0)
        return np.maximum(np.count_nonzero(tops > y, axis=0) - 1, 0)

    def of_base(self, name: str, b: Any) -> Any:
        return np.array([getattr(soil, name) for soil in self.soils], dtype=np.float64)[self.soil_at(b)]

    def strips(self, b: Any) -> dict[str, Any]:
        """Integrals over y of the weight times -y/rho, x/rho, rho, x, y and rho^2, over b; vertical stress."""
        x, y = self.arc(b)
        along, low, section = self.facing * (x - self.cx), y - self.cy, self.section
        level = self.height(self.level, x) if self.level is not None else None
        names = ("radial", "tangential", "inertia", "x", "y", "square", "vertical")
        sums: dict[str, Any] = {name: np.zeros_like(b) for name in names}

        def add(step: float, top: Any) -> None:
            high = np.maximum(top, y) - self.cy
            rho_1, rho_2 = np.hypot(along, low), np.hypot(along, high)
            log = np.arcsinh(high / np.abs(along)) - np.arcsinh(low / np.abs(along))
            values = (
                rho_1 - rho_2,
                along * log,
                (high * rho_2 - low * rho_1 + along**2 * log) / 2,
                along * (high - low),
                (high**2 - low**2) / 2,
                along**2 * (high - low) + (high**3 - low**3) / 3,
                high - low,
            )
            for name, value in zip(names, values, strict=True):
                sums[name] = sums[name] + step * value

        above, wet_above, top = 0.0, 0.0, np.full_like(x, np.inf)
        for soil, line in zip(self.soils, self.lines, strict=True):
            top = np.minimum(top, self.height(line, x))
            add(soil.unit_weight - above, top)
            above = soil.unit_weight
            wet = 0.0 if soil.saturated_unit_weight is None else soil.saturated_unit_weight - above
            if level is not None:
                add(wet - wet_above, np.minimum(top, level))
            wet_above = wet
        high = self.height(self.lines[0], x) - self.cy
        for x1, x2, q1, q2 in section.surcharge:
            q = np.where((x >= x1) & (x <= x2), q1 + (q2 - q1) * (x - x1) / (x2 - x1), 0.0)
            rho = np.hypot(along, high)
            values = (-high / rho, along / rho, rho, along, high, rho**2, np.zeros_like(rho))
            for name, value in zip(names, values, strict=True):
                sums[name] = sums[name] + q * value
        lever = {name: self.radius * np.cos(b) for name in names[:-1]}  # dx = R cos(b) db
        return {name: sums[name] * lever.get(name, 1.0) for name in names}

    def resistance(self, rotation: float, omega_2: float, slip: float = 0.0) -> Any:
        """Friction, water's part of it, and cohesion after a rotation, N/m; omega^2 is over g/R."""
        section = self.section
        moved = rotation if section.strength == "base" else 0.0
        ends = np.array([self.first, self.last])
        of_base = np.concatenate([self.joints, ends, self._datums()]) - moved
        b, step = self.broken_at([*of_base, *self._of_water(rotation)])
        strips = self.strips(b)
        base = b + moved
        turned = strips["radial"] * np.cos(rotation) - strips["tangential"] * np.sin(rotation)
        turned = turned + omega_2 / self.radius * strips["inertia"]
        x, y = self.arc(b + rotation)
        head = np.maximum(self.height(self.level, x) - y, 0.0) if self.level is not None else 0.0
        ratio = self.of_base("pore_ratio", base)
        pressure = np.where(ratio > 0.0, ratio * strips["vertical"], section.water_unit_weight * head)
        mu = np.array([coefficient(soil.friction, slip) for soil in self.soils])[self.soil_at(base)]
        cohesion = self.of_base("cohesion", base)
        if any(soil.datum is not None for soil in self.soils):
            _, depth = self.arc(np.clip(base, self.first, self.last))
            below = np.maximum(self.of_base("datum", base) - depth, 0.0)
            cohesion = cohesion + self.of_base("cohesion_gradient", base) * below
        values = (mu * turned, mu * pressure * self.radius, cohesion * self.radius)
        return np.array([(step * value).sum() for value in values])

    def _of_water(self, rotation: float) -> Any:
        return [] if self.level is None else self.facing * self.section._water.kinks[0] - rotation

    def _datums(self) -> Any:
        depths = [(self.cy - soil.datum) / self.radius for soil in self.soils if soil.datum is not None]
        reach = np.arccos(np.clip(depths, -1.0, 1.0))
        return np.concatenate([reach, -reach])

    def _kinks_of_motion(self, longest: float) -> Any:
        """Rotations at which a kink of the base or of the water passes one of the mass."""
        in_space = np.concatenate([self.joints, [self.first, self.last], self._datums(), self._of_water(0.0)])
        turns = np.unique((in_space[:, None] - self.of_mass).ravel())
        turns = np.unique(np.concatenate([turns, np.arange(0.0, 3.0, longest)]))
        turns = turns[(turns >= 0.0) & (turns < 3.0)]
        return turns[np.concatenate([[True], np.diff(turns) > 1e-10])]

    def motion(self) -> Any:
        """Peak velocity, run-out and duration of a motion down-slope from rest, without shaking and laws of speed.

        omega^2 obeys a linear equation over the rotation, solved by collocation between kinks, where it is analytic.
        """
        gravity, moments = float(self.section.gravity), self.moments
        squares: list[tuple[float, float, Any]] = []  # from and to a rotation, and half its slope as a series
        square, fastest = 0.0, 0.0
        for start, stop in pairwise(self._kinks_of_motion(0.1)):
            rotations = (start + stop) / 2 + (stop - start) / 2 * COLLOCATION
            cosine, sine = np.cos(rotations), np.sin(rotations)
            drive = moments["y"] * sine - moments["x"] * cosine
            still, at_one = (
                np.array([self.resistance(phi, squared, slip=phi * self.radius) for phi in rotations]).T
                for squared in (0.0, self.radius / gravity)
            )
            values = np.full(len(rotations), square)
            for _ in range(60):
                friction = np.maximum(still[0] - still[1] + (at_one[0] - still[0]) * values, 0.0)
                rates = gravity * (drive - self.radius * (friction + still[2])) / moments["square"]
                slope = Legendre.fit(rotations, 2.0 * rates, len(rotations) - 1, domain=[start, stop])
                whole = slope.integ(1, k=square, lbnd=start)
                values = whole(rotations)
            squares.append((start, stop, slope))
            tops = [stop, *(root.real for root in slope.roots() if root.imag == 0.0 and start < root.real < stop)]
            fastest = max(fastest, *whole(np.array(tops)))
            square = whole(stop)
            if square < 0.0:
                break
        rest = brentq(whole, start + (stop - start) * 1e-9 * (start == 0.0), stop, xtol=1e-16, rtol=1e-15)
        return np.array([np.sqrt(fastest) * self.radius, rest * self.radius, _duration(squares, rest)])


def _duration(slopes: list[tuple[float, float, Any]], rest: float) -> float:
    """Integral of 1/omega over the rotation, which is rest sin^2(u): both ends become regular."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    total, square = 0.0, 0.0
    for start, stop, slope in slopes:
        first, last = (np.arcsin(np.sqrt(min(end / rest, 1.0))) for end in (start, stop))
        for low, high in pairwise(np.linspace(first, last, 2 + int((last - first) / 0.2))):
            u = (low + high) / 2 + (high - low) / 2 * nodes
            # From the nearer end of the piece: near a standstill omega^2 is a product with the distance from it.
            from_rest = stop >= rest and np.sin((low + high) / 2) ** 2 * rest > (start + rest) / 2
            origin, at_origin = (rest, 0.0) if from_rest else (start, square)
            away = -rest * np.cos(u) ** 2 if from_rest else rest * np.sin(u) ** 2 - start
            between = origin + away[:, None] * (1.0 + COLLOCATION) / 2
            squared = at_origin + away * (slope(between) @ COLLOCATION_WEIGHTS) / 2
            total += (high - low) / 2 * float(weights @ (rest * np.sin(2.0 * u) / np.sqrt(squared)))
        square += float(slope.integ(1, lbnd=start)(stop))
    return total


def strength_by_quadrature(section: Any, rotation: float, omega_2: float) -> tuple[Any, Any]:
    """Friction, water's part of it, and cohesion after a rotation, by the package and by quadrature along the arc.

    Over the weights towards the arc at rest; ``omega_2`` is omega*^2.
    """
    arc = AlongTheArc(section)
    expected = arc.resistance(rotation, omega_2)
    moments = {name: float(values[0]) for name, values in section._weighted_moments.items()}
    terms = section.arc_strength.terms(Needs(rotates=True))

    def term(name: str) -> float:
        value = terms.get(name, 0.0)
        return float(np.ravel(value(np.array([[rotation]])) if callable(value) else value)[0])

    theta = moments["inertia"]
    slope = arc.facing * moments["radial_x"]
    whole = -moments["radial_y"] * np.cos(rotation) - slope * np.sin(rotation) + omega_2 * moments["polar"]
    beyond = theta * (term("normal") + omega_2 * term("inertia"))
    if section.strength == "mass":
        beyond += theta * (term("turning") * np.cos(rotation) - term("turning_slope") * np.sin(rotation))
    unit = float(np.ravel(section.mean_unit_weight)[0]) * arc.radius**2
    mean = float(section.arc_strength.mean_peak[0])
    values = [mean * (whole + beyond) * unit, mean * theta * term("lift") * unit, theta * term("strength") * unit]
    return np.array(values) / arc.moments["radial"], expected / arc.moments["radial"]


def differences(section: LayeredSection) -> tuple[float, float]:
    """The largest difference from quadrature of the moments and of the parts of layers; of vectors to their length.

    Moments are integrals of the weight times 1, rho, rho^2, x/rho, y/rho, x and y; the parts are those of J_r, of its
    slope and of I_p on the stretches whose base is a layer.
    """
    arc = AlongTheArc(section)
    radius, facing = arc.radius, arc.facing
    b, step = arc.broken_at(arc.joints)
    strips = {name: step * value for name, value in arc.strips(b).items()}
    weight = strips["vertical"] * radius * np.cos(b)
    columns = [weight, *(strips[name] for name in ("inertia", "square", "tangential")), -strips["radial"]]
    exact = np.array([column.sum() for column in (*columns, strips["x"], strips["y"])])
    powers, signs = np.array([2, 3, 4, 2, 2, 3, 3]), np.array([1, 1, 1, facing, 1, facing, 1])
    moments = section._moments_of_weight[:, 0] * radius**powers * signs
    sizes = np.abs(exact)
    sizes[3:] = np.repeat(np.hypot(exact[3::2], exact[4::2]), 2)

    at_rest = section.arc_strength.parts(np.zeros((1, 1)), ["normal"])
    by_joint = np.stack([at_rest[name][:, 0, 0] for name in ("normal", "tilt", "inertia")])
    parts = by_joint @ section.arc_strength.incidence[:-1, :, 0] * radius ** np.array([[2], [2], [3]])
    base = arc.soil_at(b)
    exact_parts = [[strips[name][base == k].sum() for k in range(len(arc.soils))]
                   for name in ("radial", "tangential", "inertia")]  # fmt: skip
    of_parts = np.abs(parts - exact_parts) / sizes[[4, 4, 1], None]
    return float(np.max(np.abs(moments - exact) / sizes)), float(np.max(of_parts))


def random_motions(rng: np.random.Generator, count: int) -> np.ndarray:
    """Of sections that slide: relative errors of peak velocity, run-out and duration, and the greatest's estimate."""
    rows: list[Any] = []
    while len(rows) < count:
        strength = ("base", "mass")[len(rows) % 2]
        section = random_section(rng, everything=bool(rng.random() < 0.5), strongest=0.25, strength=strength)
        try:
            motion = solve(Scene(section, effects=["rotation", "centripetal"]))
        except ValueError:
            continue  # upright, or without end
        if not motion.moves or motion.duration < 1.0 or len(motion.phases) > 1 or motion.run_out < 0.0:
            continue
        expected = AlongTheArc(section).motion()
        errors = np.array([motion.peak.velocity, motion.run_out, motion.duration]) / expected - 1.0
        rows.append([*np.abs(errors), motion.error_estimate])
    return np.array(rows)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--motions", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    rng = np.random.default_rng(asked.seed)
    found = np.array([differences(random_section(rng)) for _ in range(asked.count)])
    print(
        f"{asked.count} layered sections: moments within {found[:, 0].max():.1e}, "
        f"stretches within {found[:, 1].max():.1e}"
    )
    motions = random_motions(rng, asked.motions)
    print(f"{asked.motions} motions: peak velocity, run-out, duration within {motions[:, :3].max(axis=0)}")
    print(f"    error over its estimate: at most {(motions[:, :3].max(axis=1) / motions[:, 3]).max():.2g}")
