"""The derivation: closed forms against quadrature of the raw definitions at 40 digits, and every link proved."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from derive.algebra import dynamics, integrate
from derive.algebra.integrate import PSI, Derivation
from derive.algebra.remainders import SineRest
from derive.check.proof import ProofError
from derive.code.program import program
from derive.declare.quantities import CHORD, MOMENTS, Moment
from derive.declare.symbols import alpha, r, theta, theta_1

DIGITS = 40


def test_the_chord_is_the_paper_s() -> None:
    """(2.6) passes through both ends of the arc and is straight: r cos(theta - theta_m) is constant."""
    for end in (theta_1, theta_1 + 2 * alpha):
        assert sp.simplify(CHORD.subs(theta, end)) == 1
    assert sp.diff(CHORD * sp.cos(theta - theta_1 - alpha), theta) == 0


def test_an_antiderivative_that_jumps_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """An antiderivative with a jump is refused though its derivative is correct on both sides (SymPy issue 24004)."""
    x = sp.Symbol("x", real=True)
    jumps = sp.atan(sp.sqrt(2) * sp.tan(x)) / sp.sqrt(2)  # of 1/(1 + sin(x)**2), at pi/2
    monkeypatch.setattr(integrate, "integrate", lambda _integrand, _x: jumps)
    integrand = 1 / (1 + sp.sin(x) ** 2)
    assert integrate.antiderivative(integrand, x, "1.5") == jumps
    with pytest.raises(ProofError, match=r"found a jump of 2\.2.* between 0 and -4\.0"):
        integrate.antiderivative(integrand, x, "4")


@pytest.mark.parametrize("error", [TypeError("no"), sp.PolynomialError("no")])
def test_an_integrand_that_sympy_cannot_integrate_is_named(monkeypatch: pytest.MonkeyPatch, error: Exception) -> None:
    def fails(*_: Any) -> None:
        raise error

    monkeypatch.setattr(integrate, "integrate", fails)
    with pytest.raises(ProofError, match=rf"antiderivative of r\*\*2: found {type(error).__name__}: no"):
        integrate.antiderivative(r**2, r, "1")


def test_a_wrong_antiderivative_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    right: Callable[..., Any] = sp.integrate
    monkeypatch.setattr(integrate, "integrate", lambda e, x: right(e, x) + x)
    with pytest.raises(ProofError, match="antiderivative"):
        integrate.derive.__wrapped__(MOMENTS[0])


@pytest.mark.parametrize("n", range(1, 6))
@pytest.mark.parametrize("turn", [1, sp.sin(theta), sp.cos(theta)])
def test_every_weight_that_may_be_declared_has_a_closed_form(n: int, turn: Any) -> None:
    amplitude = ("amplitude", "K") if turn != 1 else None
    derived = integrate.derive(Moment("moment", "M", r**n * turn, "a moment", amplitude=amplitude))
    assert float(integrate.compare(derived, 20).split()[0]) < 1e-19


@pytest.mark.parametrize("moment", MOMENTS, ids=lambda m: m.name)
def test_a_wrong_closed_form_is_found_by_quadrature(moment: Moment) -> None:
    right = integrate.derive(moment)
    turned = {sp.Integer(1): sp.cos(PSI), sp.cos(PSI): sp.sin(PSI), sp.sin(PSI): sp.cos(PSI)}[right.direction]
    amplitude = right.amplitude
    wrongs: tuple[Derivation, ...] = (
        replace(right, amplitude=-amplitude),
        replace(right, amplitude=amplitude.subs(alpha, 2 * alpha)),  # as the paper's tables evaluate (2.24) and (3.15)
        replace(right, amplitude=amplitude * (1 + sp.Rational(1, 10**18))),
        replace(right, direction=turned),
        replace(right, moment=replace(moment, weight=moment.weight / r)),  # as its Appendix II integrates (3.13)
    )
    for wrong in wrongs:
        with pytest.raises(ProofError, match=moment.name):
            integrate.compare(wrong, 20)


@pytest.mark.parametrize(("right", "wrong"), [("cosh", sp.cos), ("sinh", sp.cosh), ("log", sp.exp)])
def test_a_wrong_solution_is_not_proved(right: str, wrong: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dynamics, right, wrong)
    with pytest.raises(ProofError):
        dynamics.solution.__wrapped__()


def test_a_sine_minus_its_argument_keeps_its_digits() -> None:
    """Compared with its definition at many digits."""
    points = [1e-300, 1e-9, 0.1, 0.9, 3.1]
    computed = program("rest", ("x",), SineRest(sp.Symbol("x", real=True))).run(np.array(points))
    with mpmath.workdps(1000):
        exact = [(mpmath.sin(x) - x) / mpmath.mpf(x) ** 3 for x in points]
        errors = [abs(mpmath.mpf(v) / e - 1) for v, e in zip(computed.tolist(), exact, strict=True)]
        assert max(errors) < 8 * 2.0**-53
