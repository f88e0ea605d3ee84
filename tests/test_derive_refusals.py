"""Refusals of `python -m derive`: each planted fault causes one sentence, and nothing is written."""

import math
import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from derive import __main__ as command
from derive.algebra import integrate
from derive.approximate import certificates, programs, shapes
from derive.approximate.shapes import Kernel
from derive.check import certify, truth
from derive.check.proof import ProofError
from derive.check.records import TIERS, read_records, seal
from derive.declare import quantities
from derive.declare.quantities import MOMENTS, RESISTANCE
from derive.declare.symbols import alpha, r
from derive.generate import emit_c, write
from tests.campaigns import mutants
from tests.support import reach

# Quantity, check, the number found and the number wanted.
SENTENCE = r"^{}: .*{}.*: found \S.*, wanted \S.*$"


def kernel(name: str) -> Kernel:
    return next(k for k in shapes.kernels() if k.name == name)


def fires(gate: Callable[[], Any], quantity: str, check: str) -> None:
    """Return the gate stops the run: one sentence on the quantity and the check, with both numbers."""
    with pytest.raises(ProofError) as stop:
        gate()
    assert re.fullmatch(SENTENCE.format(re.escape(quantity), check)[1:-1], str(stop.value), re.DOTALL), stop.value


def test_a_definition_that_is_not_the_checker_s(monkeypatch: pytest.MonkeyPatch) -> None:
    """A form that is off, by a factor or in a high power; a statement of another weight; a checker that reads wrong."""
    right = kernel("polar_moment")
    assert shapes.agree(right) == truth.TERMS + 5
    for wrong in (right.closed[0] * (1 + sp.Rational(1, 10**30)), right.closed[0] + alpha**35 / 10**40):
        fires(partial(shapes.agree, replace(right, closed=(wrong,))), right.name, "the checker's definition")
    fires(partial(shapes.agree, replace(right, definition=("r^3",))), right.name, "the checker's definition")
    exactly = truth.exactly
    monkeypatch.setattr(truth, "exactly", lambda statement, *x: exactly(statement, *x) * 3)
    truth.taylor_at_zero.cache_clear()
    try:
        fires(lambda: shapes.agree(right), right.name, "the checker's definition")
    finally:
        truth.taylor_at_zero.cache_clear()


@pytest.mark.parametrize("tier", TIERS)
def test_a_bound_above_its_tier_s_goal(tier: str) -> None:
    """A program that is proved to 2.5e-3 is refused where 1e-6 is promised."""
    right = kernel("resistance_factor")
    spoilt = replace(right, closed=(right.closed[0] * (1 + alpha**2 / 1000),))
    (fused, *_) = [v for v in programs.of(spoilt, shapes.stated_shape(right)) if v.tier == tier]
    fires(lambda: certificates.certified(fused), right.name, f"goal of tier {tier} fused")


def test_the_checker_knows_the_goals_too() -> None:
    record = next(r for r in read_records() if (r["kernel"], r["tier"]) == ("resistance_factor", "1e-6"))
    fires(lambda: certify.prove(seal(record | {"bound": 2e-6})), "resistance_factor", "goal of tier 1e-6 fused")


@pytest.mark.parametrize("changed", ["weight", "lambda", "text"])
def test_the_run_stops_and_writes_nothing(
    changed: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Exit status 1 and one line, also where only the files of the kernels are written again."""
    (polar, *others), form = MOMENTS, RESISTANCE.form
    if changed == "weight":
        for module in (quantities, integrate, shapes, write):
            monkeypatch.setattr(module, "MOMENTS", (replace(polar, weight=r**7), *others), raising=False)
    elif changed == "lambda":
        for module in (quantities, integrate, shapes):
            monkeypatch.setattr(module, "RESISTANCE", replace(RESISTANCE, form=form * (1 + alpha**2 / 1000)))
    else:  # a number in C that is not the certified one
        monkeypatch.setattr(emit_c, "C", replace(emit_c.C, number=lambda x: math.nextafter(x, 2.0).hex()))
        factor = kernel("resistance_factor")
        chosen = programs.of(factor, shapes.stated_shape(factor))
        monkeypatch.setattr(command, "derive_all", lambda *_: emit_c.source(chosen, {}))

    def no(*_: Any) -> None:
        pytest.fail("something was written")

    monkeypatch.setattr(write, "write", no)
    assert command.main(["--again"]) == 1
    last = capsys.readouterr().err.splitlines()[-1]
    assert re.fullmatch(r"\w+: .*: found .*, wanted .*; nothing is written", last), last


def test_a_campaign_of_mutants_says_why_nothing_was_measured(tmp_path: Path) -> None:
    """A sentence says if pytest-cov is missing or no test can be run."""
    with pytest.raises(SystemExit, match=r"no test was measured: .*\w.*; is pytest-cov installed\?"):
        mutants.measured_tests(tmp_path, 1)


def test_tests_are_selected_by_the_files_that_they_reach() -> None:
    chosen, known = reach.tests_of(["slipcircle/ground/ponds.py"])
    assert "tests/test_free_water.py::test_factors_are_those_of_plain_slices" in chosen < known
    with pytest.raises(ValueError, match=r"--of derive/none\.py: no test is known to reach it; give a module of"):
        reach.tests_of(["derive/none.py"])
