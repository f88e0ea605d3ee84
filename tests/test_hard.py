"""The table of hard cases: run through `generated` against independent references, and printed."""

import math
from fractions import Fraction

import numpy as np
import pytest

from derive.__main__ import main
from derive.judge.hard import Result, cases, drive, measured
from generated import flow, kernels
from tests.support import oracle


@pytest.fixture(scope="module")
def results() -> list[Result]:
    return measured()


@pytest.mark.parametrize("function", [*kernels.__all__, "drive"])
def test_cases(function: str) -> None:
    """Within the function's own bound, by quadrature of its definition; no warning."""
    arguments = [case.arguments for case in cases() if case.function == function]
    assert arguments
    for case in arguments:
        if function == "drive":
            press, mu, limit = map(Fraction, case)
            exact = oracle.exact(press * (limit - mu))
            assert oracle.ulps(drive(flow.FRAGMENTS["balance"].scalar, *case), exact) <= 1
            continue
        with np.errstate(all="raise"):
            value = float(getattr(kernels, function)(*case))
        if function == "limit_friction":
            assert oracle.ulps(value, oracle.limit_friction(*case)) <= 16
        elif function in oracle.WHOLE:
            assert oracle.ulps(value, *oracle.whole(function, *case)) <= 16 + 2
        else:
            assert oracle.ulps(value, oracle.kernel(function, *case)) <= 16


def test_a_wrong_cell_is_seen_next_to_the_limit() -> None:
    """The limit friction as a quotient of sums, in place of the number that is given."""
    rows = flow.FRAGMENTS["balance"].scalar
    wrong = [(*row[:3], "limit_0", "limit_0") if row[1] == "limit" else row for row in rows]
    case = next(c for c in cases() if c.function == "drive")
    assert drive(wrong, *case.arguments) != drive(rows, *case.arguments)


def test_the_naive_form_fails_at_each(results: list[Result]) -> None:
    """Naive forms err by a factor of five at least, or give no number; the one exception is marked."""
    for x in results:
        fails = not x.naive_error <= 5 * x.our_error
        assert fails == ("better here" not in x.naive), x


def test_solve_has_the_limit_friction_of_its_kernel(results: list[Result]) -> None:
    """Within the kernel's proved bound and a rounding, for arcs in either direction; no other output is compared."""
    for x in results:
        assert x.solve_error <= 2.5e-15 if x.function == "limit_friction" else math.isnan(x.solve_error), x


def test_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["hard"]) == 0
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= 100
    for case in cases():
        assert f"\n{case.function}\n" in text
        assert repr(case.arguments[0]) in text
