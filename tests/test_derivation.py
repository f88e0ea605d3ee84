"""The derivation: closed forms against quadrature of the raw definitions at 40 digits, and every link proved."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

from derive.algebra import dynamics, integrate, rules
from derive.algebra.integrate import PSI, Derivation
from derive.check.proof import ProofError
from derive.declare.quantities import CHORD, MOMENTS, Moment
from derive.declare.symbols import alpha, r, theta, theta_1
from tests.support import oracle

DIGITS = 40


def test_the_chord_is_the_paper_s() -> None:
    """(2.6) passes through both ends of the arc and is straight: r cos(theta - theta_m) is constant."""
    for end in (theta_1, theta_1 + 2 * alpha):
        assert sp.simplify(CHORD.subs(theta, end)) == 1
    assert sp.diff(CHORD * sp.cos(theta - theta_1 - alpha), theta) == 0


@pytest.mark.parametrize("name", oracle.BASE)
def test_a_wrong_stable_form_is_not_proved(name: str) -> None:
    closed = integrate.closed_forms()[name]
    right = rules.stable(closed).form
    rules.prove_equal(right, closed, name)
    for wrong in (-right, right.subs(alpha, 2 * alpha), right + alpha**2 / 10**6, right * sp.cos(alpha)):
        with pytest.raises(ProofError, match=name):
            rules.prove_equal(wrong, closed, name)


def test_an_antiderivative_that_jumps_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its derivative is right on both sides of the jump; see issue 24004 of SymPy."""
    x = sp.Symbol("x", real=True)
    jumps = sp.atan(sp.sqrt(2) * sp.tan(x)) / sp.sqrt(2)  # of 1/(1 + sin(x)**2), at pi/2
    monkeypatch.setattr(integrate, "integrate", lambda _integrand, _x: jumps)
    integrand = 1 / (1 + sp.sin(x) ** 2)
    assert integrate.antiderivative(integrand, x, "1.5") == jumps
    with pytest.raises(ProofError, match=r"found a jump of 2\.2.* for -1\.75 < x < -1\.5"):
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
        integrate.derivation(MOMENTS[0])


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
