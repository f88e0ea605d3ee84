"""The table of hard cases: run through `generated` against independent references, and printed."""

from fractions import Fraction

import numpy as np
import pytest

from derive.__main__ import main
from derive.judge.hard import CASES, HardCase, Result, drive, measured
from generated import flow, kernels
from tests.support import oracle


@pytest.fixture(scope="module")
def results() -> list[Result]:
    return measured()


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c.function}{c.arguments}")
def test_case(case: HardCase) -> None:
    """Within the function's own bound, by quadrature of its definition; no warning."""
    if case.function == "drive":
        press, mu, limit = map(Fraction, case.arguments)
        assert (
            oracle.ulps(drive(flow.FRAGMENTS["balance"].scalar, *case.arguments), oracle.exact(press * (limit - mu)))
            <= 1
        )
        return
    with np.errstate(all="raise"):
        value = float(getattr(kernels, case.function)(*case.arguments))
    if case.function == "limit_friction":
        assert oracle.ulps(value, oracle.limit_friction(*case.arguments)) <= 16
    elif case.function in oracle.WHOLE:
        assert oracle.ulps(value, *oracle.whole(case.function, *case.arguments)) <= 16 + 2
    else:
        assert oracle.ulps(value, oracle.kernel(case.function, *case.arguments)) <= 16


def test_a_wrong_cell_is_seen_next_to_the_limit() -> None:
    """The limit friction as a quotient of sums, in place of the number that is given."""
    rows = flow.FRAGMENTS["balance"].scalar
    wrong = [(*row[:3], "limit_0", "limit_0") if row[1] == "limit" else row for row in rows]
    case = next(c for c in CASES if c.function == "drive")
    assert drive(wrong, *case.arguments) != drive(rows, *case.arguments)


def test_every_kernel_has_one() -> None:
    assert {*kernels.__all__, "drive"} == {c.function for c in CASES}


def test_the_naive_form_fails_at_each(results: list[Result]) -> None:
    """By a factor of five at least, or without a number; the one case where it does not says so."""
    for x in results:
        fails = not x.naive_error <= 5 * x.our_error
        assert fails == ("better here" not in x.naive), x


def test_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["hard"]) == 0
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= 100
    for case in CASES:
        assert f"\n{case.function}\n" in text
        assert repr(case.arguments[0]) in text
