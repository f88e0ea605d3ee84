"""The derivation: closed forms against quadrature of the raw definitions at 40 digits, and every link proved."""

import mpmath
import pytest
import sympy as sp
from mpmath import mpf

from derive.algebra import dynamics
from derive.algebra.integrate import PSI, closed_forms, compare, derive
from derive.algebra.remainders import unfold
from derive.declare.quantities import CHORD, MOMENTS, QUOTIENTS, Moment
from derive.declare.symbols import a, alpha, b, r, theta, theta_1
from derive.generate import functions

each_moment = pytest.mark.parametrize("moment", MOMENTS, ids=lambda m: m.name)
DIGITS = 40


@each_moment
def test_derivation(moment: Moment) -> None:
    """Each moment comes out as an amplitude in alpha times a direction, shorter than what was integrated."""
    found = derive(moment)
    assert found.amplitude.free_symbols == {alpha}
    assert found.direction == {"radial_weight": sp.cos(PSI), "weight_moment": sp.sin(PSI)}.get(moment.name, 1)
    assert found.operations[1] < found.operations[0]
    assert moment.weight.free_symbols <= {r, theta}
    assert "40 digits" in compare(found, DIGITS)


def test_the_chord_is_the_paper_s() -> None:
    """(2.6) passes through both ends of the arc and is straight: r cos(theta - theta_m) is constant."""
    for end in (theta_1, theta_1 + 2 * alpha):
        assert sp.simplify(CHORD.subs(theta, end)) == 1
    assert sp.diff(CHORD * sp.cos(theta - theta_1 - alpha), theta) == 0


@pytest.mark.parametrize("quotient", QUOTIENTS, ids=lambda q: q.name)
@pytest.mark.parametrize("half", ["0.001", "0.8", "1.5697"])
def test_stable_quotient_equals_the_ratio_of_closed_forms(quotient: object, half: str) -> None:
    name, numerator, denominator = (getattr(quotient, x) for x in ("name", "numerator", "denominator"))
    with mpmath.workdps(80):
        ours = sp.lambdify(alpha, unfold(functions.stable_forms(closed_forms())[name]), "mpmath")(mpf(half))
        ratio = closed_forms()[numerator] / closed_forms()[denominator]
        assert abs(ours / sp.lambdify(alpha, ratio, "mpmath")(mpf(half)) - 1) < mpf(10) ** -DIGITS


# --- the motion ----------------------------------------------------------------------------------------------------


def test_balance_is_proved() -> None:
    steps = dynamics.balance()
    assert {"2.20", "3.8", "3.11", "3.16", "3.17", "3.18", "3.21"} <= set(steps)
    assert steps["3.16"].free_symbols >= {a, b}


def test_every_piece_of_every_motion_formula_is_proved() -> None:
    claims = dynamics.prove_forms()
    for name in ("angular_velocity", "angular_acceleration", "rotation"):
        assert {f"{name}, a b t**2 > 1", f"{name}, a b t**2 <= 1"} <= set(claims)
    assert any("arrest" in c for c in claims)
