"""Anything at all: scenes as extreme as their bounds allow have an answer that is consistent, or one clear error."""

import math
import re
from collections import Counter
from typing import Any

import numpy as np

from slipcircle import solve
from tests.support import combinations
from tests.support.motions import finite, ill_conditioned

COUNT = 120
ILL = ("ill-conditioned, rests", "ill-conditioned, moves")


POWERS = {"radius": (-3, 6), "unit_weight": (0, 6), "gravity": (-3, 3), "width": (-3, 6)}


# A field, or a field of a field, and then what is wrong with it.
FIELD = re.compile(r"^(Arc|Scene)?( \w+)?[:, ]*(initial_velocity|end_time|friction|arc|effects|theta_[12])\b")


def anything(rng: np.random.Generator) -> dict[str, Any]:
    """Return a random combination, every number of which is multiplied by a power of ten, on an arc next to a limit."""
    law = str(rng.choice(combinations.SLIP_LAWS))
    effects = combinations.STEADY[rng.integers(len(combinations.STEADY))]
    scene = combinations.drawn(effects, law, int(rng.integers(2**31)))
    half = min(float(10.0 ** rng.uniform(-8, 0.2)), math.pi / 2)
    tilt = float(rng.choice([1.0, -1.0, 0.0])) * 10.0 ** rng.uniform(-15, 0)
    middle = 1.5 * math.pi - float(rng.choice([rng.uniform(-1.57, 1.57), tilt, math.pi / 2 - abs(tilt)]))

    def extreme(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: extreme(one) for key, one in value.items()}
        if not isinstance(value, float):
            return value
        return value * 10.0 ** rng.choice([0.0, rng.uniform(-12, 0), rng.uniform(0, 4)])

    arc = {key: float(10.0 ** rng.uniform(*POWERS[key])) for key in POWERS}
    arc |= {"theta_1": middle - half, "theta_2": middle + half}
    pace = math.sqrt(arc["radius"] / arc["gravity"])
    changed = {key: extreme(scene[key]) for key in ("friction", "effects", "initial_velocity")}
    return changed | {"law": law, "arc": arc, "end_time": float(pace * 10.0 ** rng.uniform(-9, 1.5))}


def run_anything(fields: dict[str, Any]) -> str:
    """Return a consistent answer, or one sentence that begins with a field.

    The energy balances to 1e-12, or to the estimate where the answer says that it is ill-conditioned.
    """
    try:
        motion = solve(combinations.built(fields, fields["law"]))
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
