"""Bugs planted on purpose in the derivation, one at a time: none is proved, and what is right is."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import oracle
import pytest
import sympy as sp

from derive.algebra import dynamics, integrate, rules
from derive.algebra.integrate import PSI, Derivation
from derive.check.proof import ProofError
from derive.declare import quantities
from derive.declare.quantities import MOMENTS
from derive.declare.symbols import a, alpha, omega_0, r

# --- before the text: the derivation -------------------------------------------------------------------------------


@pytest.mark.parametrize("name", oracle.BASE)
def test_a_wrong_stable_form_is_not_proved(name: str) -> None:
    closed = integrate.closed_forms()[name]
    right = rules.stable(closed).form
    rules.prove_equal(right, closed, name)
    for wrong in (-right, right.subs(alpha, 2 * alpha), right + alpha**2 / 10**6, right * sp.cos(alpha)):
        with pytest.raises(ProofError, match=name):
            rules.prove_equal(wrong, closed, name)


def test_a_wrong_antiderivative_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    right: Callable[..., Any] = sp.integrate
    monkeypatch.setattr(sp, "integrate", lambda e, x: right(e, x) + x)
    with pytest.raises(ProofError, match="antiderivative"):
        integrate.derive.__wrapped__(MOMENTS[0])


@pytest.mark.parametrize("moment", MOMENTS, ids=lambda m: m.name)
def test_a_wrong_closed_form_is_found_by_quadrature(moment: quantities.Moment) -> None:
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


@pytest.mark.parametrize("name", [f.name for f in dynamics.FORMS])
def test_a_wrong_motion_formula_is_not_proved(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A sign of a or of omega_0 in the result, and a factor."""
    (form,) = (f for f in dynamics.FORMS if f.name == name)
    swaps = [form.result.subs(x, -x) for x in (a, omega_0)] + [2 * form.result]
    for wrong in (replace(form, result=x) for x in swaps):
        if wrong == form:
            continue  # even in it
        monkeypatch.setattr(dynamics, "FORMS", tuple(wrong if f.name == name else f for f in dynamics.FORMS))
        with pytest.raises(ProofError):
            dynamics.prove_forms()
        monkeypatch.undo()
