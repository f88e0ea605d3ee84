"""The paper's section in numbers: values of its definitions to 30 digits, and of its mistakes.

A printed number represents every value that is rounded or truncated to it, since the paper does both. `printed_as`
implements this rule for claims and causes, and `implied` applies it to numbers that follow from a printed number.
"""

from collections.abc import Callable
from decimal import Decimal
from functools import cache
from typing import Any

import mpmath as mp
from mpmath import acos, atan, mpf, pi, radians, sqrt, tan, workdps
from sympy import Expr, lambdify

from derive.algebra.appendices import APPENDIX_II, simplify
from derive.algebra.dynamics import R, g
from derive.algebra.integrate import PSI, Derivation, derive
from derive.declare.quantities import MOMENTS
from derive.declare.symbols import alpha, t, theta_m
from derive.judge import mechanics

# Table 2-1 in m, kN/m^3 and degrees; the residual friction angle, and the seconds that section 4 shows.
GIVEN = {"R": "1492.6", "gamma": "20", "theta_10": "215.2", "theta_20": "276.9", "phi_res": "10", "span": "30"}
IMPLYING = {  # printed, and implying others
    "sigma_ref": "4.223",
    "2alpha": "61.7",
    "J_r": "0.0870",
    "c0": "0.1104",
}
GRAVITY = "9.81"  # used by the project; the paper states no value


def printed_as(digits: str) -> tuple[mpf, mpf, mpf]:
    """Return a positive printed number, and the least and the greatest value that it represents, rounded or cut off."""
    printed = mpf(digits)
    unit = mpf(10) ** Decimal(digits).as_tuple().exponent
    return printed, printed - unit / 2, printed + unit


def implied(by: str, inverse: Callable[[mpf], mpf]) -> list[mpf]:
    """Return the least and the greatest value of another number that a printed number allows.

    ``by`` is a name in `IMPLYING`, and ``inverse`` computes the other number from the printed one.
    """
    _, low, high = printed_as(IMPLYING[by])
    return sorted((inverse(low), inverse(high)))


def given(name: str) -> mpf:
    """Return a number of `GIVEN` by its name, in m, kN/m^3, degrees or s."""
    return mpf(GIVEN[name])


with workdps(50):  # radians: theta_1, half the opening angle, psi, the dip of the chord
    FIRST_END = radians(given("theta_10"))
    HALF = radians(given("theta_20") - given("theta_10")) / 2
    DIP = 3 * pi / 2 - FIRST_END - HALF
    RESIDUAL = tan(radians(given("phi_res")))  # friction coefficient of section 4


@cache
def moment_derivation(name: str) -> Derivation:
    """Return the derivation of the moment with this name in `MOMENTS`."""
    return derive(next(m for m in MOMENTS if m.name == name))


def section_value(form: Expr, angle: Any = HALF, psi: Any = DIP) -> mpf:
    """Return a closed form for the section, or for another half opening angle or dip ``psi`` of the chord, in rad."""
    return _function(form)(angle, psi, 3 * pi / 2 - psi)


@cache
def _function(form: Expr) -> Callable[..., mpf]:
    return lambdify((alpha, PSI, theta_m), form, "mpmath")


def moment(name: str, angle: Any = HALF, psi: Any = DIP) -> mpf:
    """Return the dimensionless value of the moment ``name`` of `MOMENTS`, for a half angle and a dip ``psi`` in rad."""
    return section_value(moment_derivation(name).closed, angle, psi)


def factor(angle: Any = HALF) -> mpf:
    """Return the resistance factor lambda (3.14) for half the opening angle in rad."""
    return section_value(2 * alpha * mechanics.deepest() / R, angle)


def dynamic(angle: Any = HALF) -> mpf:
    """Return the dynamic coefficient A (2.24) for half the opening angle in rad."""
    return moment("polar_moment", angle) / factor(angle)


def depth() -> mpf:
    """Return the depth f (2.12), m."""
    return given("R") * factor() / (2 * HALF)


def reference() -> mpf:
    """Return the reference stress sigma_ref (2.13), MPa."""
    return given("gamma") / 1000 * depth()


def second_end(radial_weight: mpf) -> mpf:
    """Return the polar angle theta_20 in degrees for an arc of this opening and the given J_r."""
    return 270 - mp.degrees(acos(radial_weight / moment("radial_weight", psi=mpf(0))) - HALF)


def second_appendix() -> mpf:
    """Return the value of the integral in Appendix II."""
    return section_value(simplify(APPENDIX_II).expression)


def limit_friction(as_printed: bool = False) -> mpf:
    """Return the friction coefficient mu_eq (3.21), on request with Appendix II for J_theta, as printed."""
    return (second_appendix() if as_printed else moment("weight_moment")) / moment("radial_weight")


def friction_degrees(friction: mpf) -> mpf:
    """Return the friction angle in degrees of a friction coefficient."""
    return mp.degrees(atan(friction))


def reached(name: str, as_printed: bool = False, gravity: str = GRAVITY) -> mpf:
    """Return c0, c1, c2 of (4.2) and (4.4), or phi, omega*, v or s after 30 s, in SI units and rad, by its name.

    With `as_printed`, Theta* and A are evaluated at the full angle 2 alpha, and J_theta is taken from Appendix II,
    unrounded.
    """
    angle = 2 * HALF if as_printed else HALF
    inertia = moment("moment_of_inertia", angle)
    a = moment("radial_weight") * (limit_friction(as_printed) - RESIDUAL) / inertia
    b = factor() * dynamic(angle) * RESIDUAL / inertia
    numbers = {R: given("R"), g: mpf(gravity), t: given("span")}
    clock = sqrt(numbers[g] / numbers[R])
    c0 = sqrt(a / b) * clock
    numbers |= {mechanics.c0: c0, mechanics.c1: c0 * numbers[R], mechanics.c2: sqrt(a * b) * clock}
    forms = mechanics.dimensional() | {x.name: x for x in numbers}
    return lambdify([*numbers], forms[name], "mpmath")(*numbers.values())


def both_results(name: str) -> list[mpf]:
    """Return two results of `reached` for a name, from the printed and from the corrected inputs."""
    return [reached(name, as_printed=True), reached(name)]


def change_by_rotation(name: str, rotation: mpf | None = None) -> mpf:
    """Return the relative change of the moment ``name`` by a rotation in rad, by default the paper's own after 30 s."""
    phi = reached("phi", as_printed=True) if rotation is None else rotation
    return moment(name, psi=DIP - phi) / moment(name) - 1
