"""Motions of every combination of effects with every kind of law, against Taylor series in ball arithmetic.

Scenes are plain data; `taylor` solves them from quadrature of the definitions and the equation of motion as it
stands, with its sign of omega, its clamp, and a rest test at every standstill.
"""

import pytest

from slipcircle import solve
from tests.support import taylor
from tests.support.accuracy import misses
from tests.support.combinations import ALL, LAWS, built, drawn
from tests.support.motions import residual


@pytest.mark.parametrize("law", LAWS)
def test_every_combination_of_effects(law: str) -> None:
    """Laws are solved with a twentieth of all combinations; `python -m tests.campaigns.references` draws others."""
    part = ALL[LAWS.index(law) :: 2 * len(LAWS)]
    solved = 0
    for effects in part:
        given = drawn(effects, law, 31)
        try:
            motion = solve(built(given, law))
        except ValueError as refused:
            if "vertical" not in str(refused) and "overhang" not in str(refused):
                raise
            with pytest.raises(taylor.Unfit):
                taylor.solve(given)
            continue
        solved += 1
        missed = misses(motion, given)
        assert all(share <= 1.0 for share in missed.values()), (given, missed)
        assert motion.error_estimate <= 1e-11, given
        assert residual(motion) <= 1e-12 + motion.energy_error_estimate, given
        assert all(any(f"{t:.6g} s" in w for w in motion.warnings) for t in motion.lift_off[:1])
    assert solved > 0.8 * len(part)
