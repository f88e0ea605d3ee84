"""The paper's section in numbers: values of its definitions to 30 digits, and of its mistakes.

A printed number stands for every value that gives it when rounded at its last place, or cut off there: the paper does
both. `printed_as` is this rule, for claims and causes alike; `implied` is what it leaves for another number.
"""

from collections.abc import Callable
from decimal import Decimal
from functools import cache
from typing import Any

import mpmath as mp
from mpmath import acos, atan, cosh, log, mpf, pi, radians, sqrt, tan, tanh, workdps
from sympy import Expr, lambdify

from derive.algebra.appendices import APPENDIX_II, simplify
from derive.algebra.dynamics import R
from derive.algebra.integrate import PSI, Derivation, derive
from derive.declare.quantities import MOMENTS
from derive.declare.symbols import alpha, theta_m
from derive.judge import mechanics

# Table 2-1 in m, kN/m^3 and degrees; the residual friction angle, and the seconds that section 4 shows.
GIVEN = {"R": "1492.6", "gamma": "20", "theta_10": "215.2", "theta_20": "276.9", "phi_res": "10", "span": "30"}
IMPLYING = {"sigma_ref": "4.223", "2alpha": "61.7", "J_r": "0.0870", "c0": "0.1104"}  # printed, and implying others
GRAVITY = "9.81"  # used by the project; the paper states no value


def printed_as(digits: str) -> tuple[mpf, mpf, mpf]:
    """A printed number, and the least and the largest value that it may stand for."""
    printed = mpf(digits)
    unit = mpf(10) ** Decimal(digits).as_tuple().exponent
    if printed >= 0:
        return printed, printed - unit / 2, printed + unit
    return printed, printed - unit, printed + unit / 2


def implied(by: str, inverse: Callable[[mpf], mpf]) -> list[mpf]:
    """The least and the largest value of another number that a printed one allows."""
    _, low, high = printed_as(IMPLYING[by])
    return sorted((inverse(low), inverse(high)))


def given(name: str) -> mpf:
    """A number of `GIVEN`."""
    return mpf(GIVEN[name])


with workdps(50):  # radians: theta_1, half the opening angle, psi, the dip of the chord
    FIRST_END = radians(given("theta_10"))
    HALF = radians(given("theta_20") - given("theta_10")) / 2
    DIP = 3 * pi / 2 - FIRST_END - HALF
    RESIDUAL = tan(radians(given("phi_res")))  # friction coefficient of section 4


@cache
def derivation(name: str) -> Derivation:
    """A moment's derivation."""
    return derive(next(m for m in MOMENTS if m.name == name))


def value(form: Expr, angle: Any = HALF, psi: Any = DIP) -> mpf:
    """A closed form at the section, or at another half angle or dip."""
    return _function(form)(angle, psi, 3 * pi / 2 - psi)


@cache
def _function(form: Expr) -> Callable[..., mpf]:
    return lambdify((alpha, PSI, theta_m), form, "mpmath")


def moment(name: str, angle: Any = HALF, psi: Any = DIP) -> mpf:
    """One of `quantities.MOMENTS`."""
    return value(derivation(name).closed, angle, psi)


def factor(angle: Any = HALF) -> mpf:
    """lambda (3.14)."""
    return value(2 * alpha * mechanics.deepest() / R, angle)


def dynamic(angle: Any = HALF) -> mpf:
    """A (2.24)."""
    return moment("polar_moment", angle) / factor(angle)


def depth() -> mpf:
    """f (2.12), m."""
    return given("R") * factor() / (2 * HALF)


def reference() -> mpf:
    """sigma_ref (2.13), MPa."""
    return given("gamma") / 1000 * depth()


def second_end(radial_weight: mpf) -> mpf:
    """theta_20 in degrees of an arc of this opening and this J_r."""
    dip = acos(radial_weight / moment("radial_weight", psi=mpf(0)))
    return 270 - mp.degrees(dip - HALF)


def second_appendix() -> mpf:
    """What Appendix II integrates."""
    return value(simplify(APPENDIX_II).expression)


def limit_friction(as_printed: bool = False) -> mpf:
    """mu_eq (3.21); with Appendix II for J_theta, on request as printed."""
    weight_moment = second_appendix() if as_printed else moment("weight_moment")
    return weight_moment / moment("radial_weight")


def degrees(friction: mpf) -> mpf:
    """The friction angle of a coefficient."""
    return mp.degrees(atan(friction))


def reached(name: str, as_printed: bool = False, gravity: str = GRAVITY) -> mpf:
    """c0, c1, c2 of (4.2), (4.4), or what the mass reaches after 30 s: phi, omega*, v, s.

    `as_printed` takes Theta* and A at the full angle 2 alpha and J_theta from Appendix II, unrounded.
    """
    angle = 2 * HALF if as_printed else HALF
    inertia = moment("moment_of_inertia", angle)
    a = moment("radial_weight") * (limit_friction(as_printed) - RESIDUAL) / inertia
    b = factor() * dynamic(angle) * RESIDUAL / inertia
    radius = given("R")
    clock = sqrt(mpf(gravity) / radius)
    c0 = sqrt(a / b) * clock
    c2 = sqrt(a * b) * clock
    span = c2 * given("span")
    omega = c0 * tanh(span)
    phi = c0 / c2 * log(cosh(span))
    quantities = {
        "c0": c0,
        "c1": c0 * radius,
        "c2": c2,
        "phi": phi,
        "omega*": omega / clock,
        "v": omega * radius,
        "s": phi * radius,
    }
    return quantities[name]


def both(name: str) -> list[mpf]:
    """Results of `reached` from the printed inputs, and from the corrected ones."""
    return [reached(name, as_printed=True), reached(name)]


def turned(name: str, rotation: mpf | None = None) -> mpf:
    """Return the relative change of a moment by a rotation, in rad; by default the paper's own rotation after 30 s."""
    phi = reached("phi", as_printed=True) if rotation is None else rotation
    return moment(name, psi=DIP - phi) / moment(name) - 1
