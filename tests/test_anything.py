"""Anything at all: scenes as extreme as their bounds allow have an answer that is consistent, or one clear error."""

import math
import re
from collections import Counter
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from slipcircle import Arc, Scene, solve
from tests.support.combinations import softening
from tests.support.motions import finite, ill_conditioned

COUNT = 45
ILL = ("ill-conditioned, rests", "ill-conditioned, moves")


# A field, or a field of a field, and then what is wrong with it.
FIELD = re.compile(r"^(Arc|Scene)?[:, ]*(initial_velocity|end_time|friction|arc|effects|theta_[12])\b")


def smooth(first: float, last: float, scale: float, slip: Any) -> Any:
    """A law of slip in Python."""
    return first + (last - first) * np.tanh(slip / scale)


def anything(rng: np.random.Generator) -> dict[str, Any]:
    """Fields of a scene, each as extreme as its bounds allow."""

    def power(low: float, high: float) -> float:
        return float(10.0 ** rng.uniform(low, high))

    def one_of(*values: float) -> float:
        return float(values[rng.integers(len(values))])

    effects: dict[str, dict[str, float]] = {e: {} for e in ("rotation", "centripetal") if rng.random() < 0.7}
    end = power(-9, 9) if rng.random() < 0.5 else None
    half = min(one_of(power(-8, 0.2), power(-8, 0), math.pi / 2), math.pi / 2)
    tilt = power(-15, 0)
    level, upright = (0.0, tilt, -tilt), (math.pi / 2, math.pi / 2 - tilt, tilt - math.pi / 2)
    dip = one_of(rng.uniform(-1.57, 1.57), rng.uniform(0.0, 1.57), *level, *upright)
    fields = {"radius": power(-3, 6), "unit_weight": power(0, 6), "gravity": power(-3, 3), "width": power(-3, 6)}
    given = {**fields, "theta_1": 1.5 * math.pi - dip - half, "theta_2": 1.5 * math.pi - dip + half}
    unit = math.sqrt(fields["radius"] * fields["gravity"])
    if "rotation" in effects and end is not None:
        end = min(end, 100.0 * rng.random() * unit / fields["gravity"])  # not thousands of swings
    many = end is not None or "rotation" not in effects  # without an end, next to no friction means thousands of swings
    stress = fields["unit_weight"] * fields["radius"] * half**2
    if rng.random() < 0.4:
        effects["pore_pressure"] = {
            "ratio": one_of(0.0, rng.random(), 1 - power(-15, -1), 1 - 1e-15) * (1.0 if many else 0.9),
            "pressure": one_of(0.0, stress * power(-12, 2), stress * power(-9, -2)),
        }
    if rng.random() < 0.4:
        effects["cohesion"] = {"cohesion": one_of(0.0, stress * power(-12, 3), stress * power(-3, 0))}
    if rng.random() < 0.4:
        effects["drag"] = {"xi": fields["gravity"] / half**2 / power(-12, 12)}
    limit = abs(math.tan(dip))
    least = 0.0 if end is not None else 0.03

    def angle() -> float:
        return max(one_of(0.0, 1.0, rng.uniform(0, 2), power(-12, 0), power(0, 4), limit), least)

    low, steps = one_of(-13, -6, -3, 0), one_of(1, 3, 9)
    slips = np.concatenate([[0.0], np.cumsum([power(low, low + steps) for _ in range(rng.integers(1, 8))])]).tolist()
    friction = [
        angle(),
        max(limit * (1 + power(-15, -1) * one_of(-1, 1)), least),
        float(np.nextafter(limit, one_of(0.0, math.inf, limit))),
        softening(str(rng.choice(["exponential", "linear", "hyperbolic"])), angle(), angle(), power(-12, 12)),
        {"law": "tabulated", "slip": slips, "coefficient": [angle() for _ in slips]},
        partial(smooth, angle(), angle(), power(-3, 4)),
    ][rng.choice(6, p=[0.2, 0.15, 0.1, 0.3, 0.15, 0.1])]  # fmt: skip
    speed = power(-12, 3)
    velocity = one_of(0.0, speed, -speed, unit * power(-1, 0.5), -unit * power(-12, 1))
    return {"arc": given, "friction": friction, "effects": effects, "initial_velocity": velocity, "end_time": end}


def run_anything(fields: Mapping[str, Any]) -> str:
    """What became of it: an answer that is consistent, or one sentence that begins with a field.

    The energy balances to 1e-12, or to the estimate where the answer says that it is ill-conditioned.
    """
    try:
        given = Arc(**fields["arc"])
        motion = solve(
            Scene(given, fields["friction"], fields["effects"], fields["initial_velocity"], fields["end_time"])
        )
    except ValueError as error:
        return "refused" if FIELD.match(str(error)) else f"refused without a field: {error}"
    finite(motion)
    assert motion.arrested or motion.duration == fields["end_time"] or fields["end_time"] is None
    return ("ill-conditioned, " if ill_conditioned(motion) else "") + ("rests" if motion.arrested else "moves")


def test_anything_has_an_answer_or_one_clear_error() -> None:
    rng = np.random.default_rng([20250103, 0])
    counts = Counter(run_anything(anything(rng)) for _ in range(COUNT))
    assert set(counts) <= {"rests", "moves", "refused", *ILL}
    assert counts["rests"] > COUNT / 3
    assert counts["moves"] > COUNT / 7.5
    assert counts["refused"] < COUNT / 3
    assert sum(counts[i] for i in ILL) < COUNT / 10
