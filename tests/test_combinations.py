"""Every combination of effects with every kind of law, and random scenes, against Taylor series in ball arithmetic.

Scenes are plain data; `taylor` solves them from quadrature of the definitions and the equation of motion as it
stands, with its sign of omega, its clamp, and a rest test at every standstill.
"""

import math

import numpy as np
import pytest

from slipcircle import Motion, Scene, solve
from tests.support import golden, references, taylor
from tests.support.combinations import ALL, LAWS, built, drawn


def check(scene: Scene, given: golden.Data, bound: float = 1e-11, rounding: float = 0.0) -> Motion:
    """That each of a motion's numbers is within its estimate of the exact one, and that its energy balances.

    What several episodes round may be a few times the estimate where that is of the size of rounding itself.
    """
    motion = solve(scene)
    assert isinstance(motion, Motion)
    missed = golden.misses(motion, given, golden.times(motion), 21, 18)
    most = max(1.0, rounding / motion.error_estimate) if rounding else 1.0
    assert all(share <= most for share in missed.values()), (given, missed)
    assert motion.error_estimate <= bound, given
    energy = motion.energy_at(np.linspace(0.0, motion.duration, 21))
    total = np.maximum.accumulate(energy.kinetic_start + np.abs(energy.work) + energy.dissipation)
    assert np.all(np.abs(energy.residual) <= (1e-12 + motion.energy_error_estimate) * total), given
    assert np.all(energy.dissipation >= 0.0)
    return motion


@pytest.mark.parametrize("law", LAWS)
def test_every_combination_of_effects(law: str) -> None:
    """Each law with a tenth of all, or a twentieth."""
    part = ALL[LAWS.index(law) :: len(LAWS)]
    part = part[::2] if law in ("callable", "rate table", "product", "hyperbolic") else part  # which take longest
    solved = 0
    for effects in part:
        given = drawn(effects, law, 31)
        try:
            motion = check(built(given, law), given)
        except ValueError as refused:
            if "vertical" not in str(refused) and "overhang" not in str(refused):
                raise
            with pytest.raises(taylor.Unfit):
                taylor.Solution(taylor.Problem(given), 26, 22)
            continue
        solved += 1
        assert all(any(f"{t:.6g} s" in w for w in motion.warnings) for t in motion.lift_off[:1])
    assert solved > 0.8 * len(part)


@pytest.mark.parametrize("group", ["pulse", "series"])
def test_shaken_frozen_slides(group: str) -> None:
    """Random ones, with brakes, water, cohesion and lift-off, one way and both ways."""
    rng, solved, kinds = np.random.default_rng([20261122, len(group)]), 0, set()
    while solved < 12:
        try:
            given = references.drawn(group, rng)
            pace = math.sqrt(given["arc"]["radius"] / given["arc"]["gravity"])
            frozen = {e: p for e, p in given["effects"].items() if e != "rotation"}
            given |= {"effects": frozen, "end_time": float(rng.uniform(1.0, 4.0)) * pace}
            motion = check(built(given), given, 1e-9, rounding=2e-14)
        except taylor.Unfit:
            continue
        except ValueError as refused:
            assert "more than any recorded ground motion (5 g)" in str(refused)  # noqa: PT017
            continue
        solved += 1
        kinds |= {*frozen, "two ways" if frozen["shaking"].get("two_way") else "", "lifts" if motion.lift_off else ""}
    assert kinds >= {"centripetal", "drag", "cohesion", "pore_pressure", "two ways", "lifts"}
