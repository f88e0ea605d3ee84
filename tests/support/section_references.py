"""Random sections and their motion to 30 digits.

``python -m tests.campaigns.references 130 --sections`` compares them, and ``python -m
tests.support.section_references`` solves those that are kept again, and stores the answers. Grounds of up to eight
edges that fall either way, dry or under a water level, with every law and effect, pushed either way. Moments come from
strips in ball arithmetic, the pressure below a level from the heights of its line above the arc, the motion from Taylor
series in time: nothing here knows a line of the package but the random grounds.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, arb_series, ctx

import slipcircle
from tests.support import combinations, golden, references, taylor
from tests.support.grounds import bumpy
from tests.support.strips import integrals
from tests.support.taylor import Unfit, number

FILE = Path(__file__).with_suffix(".json")
WATER = 9810.0
Line = list[tuple[arb, arb]]
LAWS = [law for law in combinations.LAWS if law != "callable"]


@cache
def _integrals(ground: tuple[Any, ...], centre: tuple[float, float], radius: float) -> dict[str, arb]:
    return integrals(ground, centre, radius)


def _crossings(p: tuple[arb, arb], q: tuple[arb, arb]) -> list[arb]:
    """Angles from straight below the centre at which an edge meets the lower half of the unit circle."""
    slope = (q[1] - p[1]) / (q[0] - p[0])
    a, b, c = 1 + slope * slope, slope * (p[1] - slope * p[0]), (p[1] - slope * p[0]) ** 2 - 1
    disc = b * b - a * c
    found = [] if not disc > 0 else [(-b + s * disc.sqrt()) / a for s in (-1, 1)]
    return [x.asin() for x in found if p[0] < x < q[0] and p[1] + slope * (x - p[0]) < 0]


class Section(taylor.Problem):
    """The equation of motion of the mass under any ground, of which each weight has two components."""

    def measured(self, arc: Mapping[str, Any]) -> dict[str, arb]:
        ground, centre, radius = tuple(map(tuple, arc["ground"])), tuple(arc["centre"]), arc["radius"]
        m = {k: v.mid() for k, v in _integrals(ground, centre, radius).items()}
        self.way = 1 if m["moment_x"] < 0 else -1  # facing right or left
        first, *_, last = sorted((b for p, q in pairwise(self._line(arc, ground)) for b in _crossings(p, q)), key=float)
        self.ends, half = (first, last), (last - first) / 2
        depth = 1 - half.cos()
        stress = number(arc["unit_weight"]) * number(radius) * depth
        self._wet(arc, stress)
        # fall(phi) = -way moment_x of the mass turned by -way phi, press(phi) = -radial_y of it: amplitude and phase
        fall, fall_slope = -self.way * m["moment_x"], -m["moment_y"]
        press, press_slope = -m["radial_y"], self.way * m["radial_x"]
        return {
            "fall": (fall**2 + fall_slope**2).sqrt() / m["inertia"], "dip": arb.atan2(fall, fall_slope),
            "press": (press**2 + press_slope**2).sqrt() / m["inertia"], "lean": arb.atan2(-press_slope, press),
            "polar": m["polar"] / m["inertia"], "inertia": m["inertia"], "half_angle": half,
            "level": 2 * half * depth / m["inertia"], "reference_stress": stress,
            "cover": self._mean_height(arc, ground) / press * (last - first),
        }  # fmt: skip

    def _line(self, arc: Mapping[str, Any], points: Any) -> Line:
        """Points from the centre, over R."""
        (x0, y0), r = map(number, arc["centre"]), number(arc["radius"])
        return [((number(x) - x0) / r, (number(y) - y0) / r) for x, y in points]

    def _mean_height(self, arc: Mapping[str, Any], ground: Any) -> arb:
        """Return the mean height of the ground above the arc over R; r_u is a share of gamma times this height."""
        total = arb(0)
        for p, q in pairwise(self._line(arc, ground)):
            low, high = (max(p[0].asin(), self.ends[0], key=float) if abs(p[0]) < 1 else self.ends[0],
                         min(q[0].asin(), self.ends[1], key=float) if abs(q[0]) < 1 else self.ends[1])  # fmt: skip
            if p[0] < 1 and q[0] > -1 and low < high:
                total += _area(p, q, high) - _area(p, q, low)
        return total / (self.ends[1] - self.ends[0])

    def _wet(self, arc: Mapping[str, Any], stress: arb) -> None:
        """Determine the parts of the arc below the level and the rotations at which a formula ends."""
        self.pieces_of_level: list[tuple[arb, arb, tuple[Any, Any] | None, arb]] = []
        self.borders = []
        if not arc.get("level"):
            return
        self.per_stress = number(WATER) * number(arc["radius"]) / stress
        line = [p for p in self._line(arc, arc["level"]) if abs(p[0]) < 3]
        line = [(arb(-3), line[0][1]), *line, (arb(3), line[-1][1])]
        right = arb.pi() / 2
        angles = [x.asin() for x, _ in line if abs(x) < 1] + [b for p, q in pairwise(line) for b in _crossings(p, q)]
        angles = [-right, *sorted(angles, key=float), right]
        total = arb(0)
        for low, high in pairwise(angles):
            x = ((low + high) / 2).sin()
            p, q = next((p, q) for p, q in pairwise(line) if p[0] <= x <= q[0])
            y = p[1] + (q[1] - p[1]) / (q[0] - p[0]) * (x - p[0])
            edge = (p, q) if y > -(1 - x * x).sqrt() else None
            self.pieces_of_level.append((low, high, edge, total))
            total += _area(p, q, high) - _area(p, q, low) if edge else 0
        turns = [(b - end) * self.way for b in angles for end in self.ends]
        # Where the level begins as the ground does, the formula of the start is that of the way down.
        passed = -(arb(2) ** -150)
        self.borders = sorted((passed if abs(t) < -passed else t.mid() for t in turns), key=float)

    def under(self, phi: arb_series, place: int) -> arb_series | int:
        if not self.borders:
            return 0
        if not 0 < place < len(self.borders):
            raise Unfit
        middle = (self.borders[place - 1] + self.borders[place]) / 2
        first, last = (self._integral(phi, end, middle) for end in self.ends)
        return (last - first) * (self.per_stress / (self.ends[1] - self.ends[0]))

    def _integral(self, phi: arb_series, end: arb, middle: arb) -> arb_series:
        """Heights of the level above the arc, from far left to an end of the mass, by the formula at a rotation."""
        about = end + self.way * middle
        found = [p for p in self.pieces_of_level if p[0] <= about <= p[1]]
        if not found:
            raise Unfit
        low, _, edge, before = found[0]
        return before + (_area(*edge, phi * self.way + end) - _area(*edge, low) if edge else arb_series([0]))


def _area(p: tuple[arb, arb], q: tuple[arb, arb], beta: Any) -> Any:
    """Antiderivative over beta of the height of the line through two points above the unit circle's lower half."""
    slope = (q[1] - p[1]) / (q[0] - p[0])
    return beta * (p[1] - slope * p[0]) - beta.cos() * slope + beta.sin()


def drawn(rng: np.random.Generator) -> dict[str, Any]:
    """Return a random scene with any law and effects."""
    ground, centre, radius = bumpy(rng, int(rng.integers(2, 9)))
    size = float(10 ** rng.uniform(0.0, 3.0))
    arc: dict[str, Any] = {"ground": [[size * x, size * y] for x, y in ground], "centre": [size * c for c in centre],
           "radius": size * radius, "unit_weight": float(rng.uniform(15e3, 25e3)), "gravity": 9.81}  # fmt: skip
    if rng.random() < 0.4:
        below = np.cumsum(rng.uniform(0.0, 0.06, len(ground))) * size
        arc["level"] = [[x, y - d] for (x, y), d in zip(arc["ground"], below.tolist(), strict=True)]
    with ctx.workprec(200):
        try:
            m = Section(plain(arc, 0.1)).measured(arc)
        except (ValueError, IndexError) as error:  # the circle cuts the ground more than once
            raise Unfit from error
        if m["half_angle"] > 1.5 or not m["press"] * m["lean"].cos() > 0:
            raise Unfit
        if not 0.1 < m["fall"] * m["dip"].sin() / (m["press"] * m["lean"].cos()) < 1.5:
            raise Unfit
    effects, law = combinations.ALL[rng.integers(len(combinations.ALL))], str(rng.choice(LAWS))
    found = combinations.drawn(effects, law, int(rng.integers(2**31)), (arc, m))
    if "rotation" in effects and rng.random() < 0.5:
        found["end_time"] = None
    if arc.get("level"):
        found["effects"].get("pore_pressure", {}).pop("ratio", None)
    return found


def plain(arc: Mapping[str, Any], friction: float) -> dict[str, Any]:
    return {"arc": arc, "friction": friction, "effects": {}, "initial_velocity": 0.0, "end_time": None}


def row(index: int, seed: int) -> dict[str, Any]:
    """Return a scene, drawn until it fits, and its motion."""
    rng = np.random.default_rng([seed, index])
    return {"group": "section"} | references.first_fit(lambda: drawn(rng), 28, Section, most=(4000, 60))


def scene(given: Mapping[str, Any]) -> slipcircle.Scene:
    """Return the scene of a row."""
    whole = golden.built("", {**given, "arc": golden.SLOPE})
    return replace(whole, arc=slipcircle.Section(**given["arc"]))


def main() -> None:
    golden.write(FILE, (row | {"reference": taylor.solve(row["scene"], references.SHARES, 28, Section)}
                        for row in golden.read(FILE)))  # fmt: skip


if __name__ == "__main__":
    main()
