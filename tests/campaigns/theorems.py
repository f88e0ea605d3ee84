"""Motions of random arcs beside their proved enclosures, which show whether errors are within the estimates.

``python -m tests.campaigns.theorems COUNT --seed N`` draws COUNT arcs, from a millionth of a radian to a half disc,
with frictions from a thirtieth of the limit to 1e-9 below it, and prints those whose error is the largest share of the
estimate; the exit status is 1 if an error exceeds its estimate.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from typing import NamedTuple

import numpy as np
from flint import arb

import generated
from derive.check.truth import as_ball, working
from derive.theorem.motion import Slide, Theorem, theorem
from slipcircle import Arc, Motion, Scene, solve
from tests.campaigns import options

OUTCOMES = ("run_out_m", "peak_velocity_m_s", "duration_s")
WORST = 12  # rows of the table


class Case(NamedTuple):
    """A scene of doubles, which are exact."""

    radius: float
    theta_1: float
    theta_2: float
    friction: float
    centripetal: bool

    def slide(self) -> Slide:
        radius, theta_1, theta_2, friction = (as_ball(x) for x in self[:4])
        return Slide(radius, theta_1, theta_2, friction, as_ball(9.81), centripetal=self.centripetal)

    def motion(self) -> Motion:
        effects = ["rotation", "centripetal"] if self.centripetal else ["rotation"]
        arc = Arc(self.radius, self.theta_1, self.theta_2, 20e3)
        return solve(Scene(arc, self.friction, effects), accuracy=1e-13)


def drawn(index: int, seed: int) -> Case:
    """Return a random case; every tenth arc is a half disc, and every third friction is next to its limit."""
    rng = np.random.default_rng([seed, index])
    alpha = np.pi / 2 if index % 10 == 0 else 10 ** rng.uniform(-6.0, np.log10(1.57))
    middle, radius = 1.5 * np.pi - rng.uniform(0.02, 1.3), 10 ** rng.uniform(0.0, 4.0)
    theta_1 = middle - alpha
    theta_2 = float(np.nextafter(theta_1 + 2 * alpha - 1e-15, 0.0))  # of doubles a half disc may be more than one
    limit = float(generated.limit_friction(theta_1, theta_2))
    low, any_share, gap = 10 ** rng.uniform(-1.5, -1.0), rng.uniform(0.1, 1.0), 10 ** rng.uniform(-9.0, -2.0)
    friction = (limit - min(gap, limit / 2), limit * low, limit * any_share)[index % 3]
    return Case(radius, theta_1, theta_2, friction, bool(rng.integers(2)))


def errors(motion: Motion, proof: Theorem) -> list[float]:
    """Relative, of run-out, peak velocity and duration: at most so large, as the enclosures are proved."""
    values = motion.run_out, motion.peak.velocity, motion.duration
    with working(200):
        bounds = [abs(as_ball(v) - proof.numbers[k]) / proof.numbers[k] for v, k in zip(values, OUTCOMES, strict=True)]
        return [float(arb(bound.upper())) for bound in bounds]


def compared(index: int, seed: int) -> tuple[Case, str, float, float]:
    """Return a case, how it ends, its largest error and the estimate; the error is infinite where it ends otherwise."""
    case = drawn(index, seed)
    proof, motion = theorem(case.slide), case.motion()
    alike = proof.status == "rests" and motion.arrested
    return case, proof.status, max(errors(motion, proof)) if alike else np.inf, float(motion.error_estimate)


def main() -> int:
    chosen = options(__doc__, 200)
    with ProcessPoolExecutor(2) as pool:
        rows = list(pool.map(partial(compared, seed=chosen.seed), range(chosen.count)))
    rows.sort(key=lambda row: -row[2] / row[3])
    print(f"{'half angle':>10} {'dip':>6} {'friction':>22} {'error':>9} {'estimate':>9}  ends")
    for case, status, error, estimate in rows[:WORST]:
        half = (case.theta_2 - case.theta_1) / 2
        dip = 1.5 * np.pi - (case.theta_2 + case.theta_1) / 2
        print(f"{half:10.3g} {dip:6.3f} {case.friction!r:>22} {error:9.2g} {estimate:9.2g}  {status}")
    below = sum(estimate < error for *_, error, estimate in rows)
    largest = max(error for *_, error, _ in rows)
    print(f"{len(rows)} motions, largest error {largest:.2g}, {below} above their estimate")
    return int(below > 0)


if __name__ == "__main__":
    sys.exit(main())
