"""The rules that take a closed form to one without cancellation, and the remainders that they leave."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import acb, arb, ctx
from mpmath import mpf

from derive.algebra import rules
from derive.algebra.integrate import derive
from derive.algebra.remainders import HalfTan, Remainder, unfold
from derive.check.proof import ProofError
from derive.code.program import program
from derive.declare.quantities import Moment
from derive.declare.symbols import alpha, r, t, theta

# Of the fifteen that a moment may have; `python -m tests.campaigns.all_weights` takes all.
WEIGHTS = {
    f"r^{n}{name}": Moment("moment", "M", r**n * by, "", amplitude=("amplitude", "M") if name else None)
    for n, name, by in (
        *((n, "", sp.Integer(1)) for n in (2, 5)),
        *((n, " sin", -sp.sin(theta)) for n in (1, 4)),
        *((n, " cos", -sp.cos(theta)) for n in (2,)),
    )
}
ANGLES = [*np.linspace(0.003, 1.5707, 9).tolist(), 1e-2, 1e-4, 1e-8, 1e-40]


@pytest.mark.parametrize("weight", WEIGHTS)
def test_every_weight_has_a_stable_form(weight: str) -> None:
    """As NumPy computes it, beside quadrature of the ring's moment, a single integral over the centred angle."""
    moment = WEIGHTS[weight]
    found = rules.stable(derive(moment).amplitude)
    values = program("stable", ("alpha",), found.form).run(np.array(ANGLES))
    n = int(sp.degree(moment.weight, r)) + 1
    for half, value in zip(ANGLES, values.tolist(), strict=True):
        with ctx.workprec(400 if half < 1e-8 else 160):  # 1 - chord^n cancels in thin arcs

            def ring(x: acb, _: bool, half: float = half) -> acb:
                chord = arb(half).cos() / (x * half).cos()
                return (1 - chord**n) / n * ((x * half).cos() if moment.amplitude else 1)

            true = 2 * arb(half) * acb.integral(ring, 0, 1).real
            assert abs(value / true - 1) < 16 * 2.0**-53, half
    assert found.power == 3  # every such mass is thin like alpha**3


@pytest.mark.parametrize("rule", rules.RULES)
def test_a_wrong_rule_is_not_proved(rule: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = rules.RULES[rule]
    monkeypatch.setitem(rules.RULES, rule, lambda e: right(e) + alpha**3 / 10**6)
    with pytest.raises(ProofError, match=f"rule {rule}"):
        rules.stable.__wrapped__(derive(WEIGHTS["r^2"]).amplitude)


def test_what_the_rules_do_not_know_is_refused() -> None:
    with pytest.raises(ProofError, match="heads"):
        rules.stable(alpha - sp.sin(alpha) - alpha**3 / 6)


def test_a_half_angle_that_is_computed_wrong_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    right = HalfTan.lower
    monkeypatch.setattr(HalfTan, "lower", lambda self: right(self) * (1 + alpha**2 / 10**6))
    with pytest.raises(ProofError, match="as it is computed"):
        rules.stable.__wrapped__(derive(WEIGHTS["r^2"]).amplitude)


REMAINDERS = [Remainder(sp.sin, 1, t), Remainder(sp.sin, 3, t), Remainder(sp.atanh, 3, t)]


@pytest.mark.parametrize("remainder", REMAINDERS, ids=lambda e: str(e).replace("Lambda(x_, ", "("))
def test_a_remainder_keeps_its_digits(remainder: sp.Expr) -> None:
    """Beside its definition at many digits, on both sides of every seam."""
    points = [1e-300, 1e-20, 1e-9, 1e-3, 0.1, 0.1249, 0.1251, 0.39, 0.41, 0.9]
    computed = program("remainder", ("t",), remainder).run(np.array(points))
    exact = sp.lambdify(t, unfold(remainder), "mpmath")
    with mpmath.workdps(2000):
        for point, value in zip(points, computed.tolist(), strict=True):
            assert abs(mpf(value) / exact(mpf(point)) - 1) < 64 * 2.0**-53, point
