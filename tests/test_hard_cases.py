"""The table of hard cases: run through `generated` against independent references, and printed."""

import math

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx

from derive.__main__ import main
from derive.judge.hard import Result, forms, hard_cases, measured
from generated import kernels
from tests.support import oracle


@pytest.fixture(scope="module")
def results() -> list[Result]:
    return measured()


@pytest.mark.parametrize("function", kernels.__all__)
def test_each_case_is_within_its_bound(function: str) -> None:
    """Within the function's own bound, by quadrature of its definition; no warning."""
    arguments = [case.arguments for case in hard_cases() if case.function == function]
    assert arguments
    for case in arguments:
        with np.errstate(all="raise"):
            value = float(getattr(kernels, function)(*case))
        if function == "limit_friction":
            assert oracle.ulps(value, oracle.limit_friction(*case)) <= 16
        elif function in oracle.WHOLE:
            assert oracle.ulps(value, *oracle.whole(function, *case)) <= 16 + 2
        else:
            assert oracle.ulps(value, oracle.kernel(function, *case)) <= 16


def test_the_naive_form_fails_at_each(results: list[Result]) -> None:
    """Naive forms err by a factor of five at least, or give no number; the one exception is marked."""
    for x in results:
        fails = not x.naive_error <= 5 * x.our_error
        assert fails == ("better here" not in x.naive), x


def test_solve_has_the_limit_friction_of_its_kernel_and_the_exact_run_out(results: list[Result]) -> None:
    """Within the kernel's proved bound and a rounding, for arcs in either direction; other outputs are not compared."""
    bounds = {"limit_friction": 2.5e-15, "sine_of_half_run_out": 1e-15}
    for x in results:
        assert x.solve_error <= bounds[x.function] if x.function in bounds else math.isnan(x.solve_error), x


def test_the_exact_run_out_is_twice_the_dip_minus_delta() -> None:
    case = next(c.arguments for c in hard_cases() if c.function == "sine_of_half_run_out")
    exact = forms()["sine_of_half_run_out"].exact
    with ctx.workprec(400):
        m = oracle.moments({"theta_1": case[0], "theta_2": case[1], "radius": 1.0, "unit_weight": 1.0})
        expected = (m["dip"] - (oracle.exact(case[2]) * m["press"] / m["fall"]).atan()).sin()
        found = sp.lambdify(sp.symbols("theta_1 theta_2 mu", real=True), exact, "mpmath")
        with mpmath.workdps(100):
            value = found(*map(mpmath.mpf, case))
        assert abs(arb(mpmath.nstr(value, 80)) / expected - 1) < 1e-25


def test_the_command_prints_every_case(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["hard"]) == 0
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= 100
    for case in hard_cases():
        assert f"\n{case.function}\n" in text
        assert repr(case.arguments[0]) in text
