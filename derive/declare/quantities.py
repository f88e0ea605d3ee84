"""The quantities of the method, declared once as data; every stage walks these lists.

A new moment is one more `Moment` here.
"""

from dataclasses import dataclass

import sympy as sp

from derive.declare.symbols import alpha, r, theta, theta_1


@dataclass(frozen=True)
class Moment:
    """A double integral over the moving mass, dimensionless (r* = r/R).

    ``weight`` is integrated over r from the chord to 1 and over theta from theta_1 to theta_2. ``turn`` says how
    the integral depends on the direction of the bisector: not at all (1), or as a factor in psi. Where it does,
    ``amplitude`` is the name and symbol of the part that is left, a function of alpha alone.
    """

    name: str
    symbol: str
    equation: str
    weight: sp.Expr
    help: str
    amplitude: tuple[str, str] | None = None


@dataclass(frozen=True)
class Quotient:
    """A ratio of two base quantities, O(1) as alpha -> 0 although both fall like alpha**3."""

    name: str
    symbol: str
    equation: str
    numerator: str
    denominator: str
    help: str


# The chord that closes the mass below, in polar coordinates about the centre of the arc (2.6), (2.18).
CHORD = sp.cos(alpha) / sp.cos(theta - theta_1 - alpha)

MOMENTS = (
    Moment("polar_moment", "I_p*", "2.17", r**2, "polar surface moment of inertia of the moving mass"),
    Moment("moment_of_inertia", "Theta*", "3.12", r**3, "moment of inertia of the moving mass about the centre"),
    Moment(
        "radial_weight", "J_r", "2.23", -r * sp.sin(theta), "weight of the moving mass along the radius",
        amplitude=("radial_weight_amplitude", "C_r"),
    ),
    Moment(
        "weight_moment", "J_theta", "3.13", -(r**2) * sp.cos(theta), "moment of the weight about the centre",
        amplitude=("weight_moment_amplitude", "C_theta"),
    ),
)  # fmt: skip

# lambda (3.14) is no integral: its definition is 2 alpha f/R, with f the largest depth of the chord (2.12).
RESISTANCE = ("resistance_factor", "lambda", "3.14", "lever of the resistance, arc length times depth")

QUOTIENTS = (
    Quotient("dynamic_coefficient", "A", "2.24", "polar_moment", "resistance_factor",
             "share of the centripetal term in the mean normal stress"),
    Quotient("weight_moment_per_inertia", "C_theta/Theta*", "3.17", "weight_moment_amplitude", "moment_of_inertia",
             "drive of gravity in the equation of motion"),
    Quotient("radial_weight_per_inertia", "C_r/Theta*", "3.17", "radial_weight_amplitude", "moment_of_inertia",
             "brake of static friction in the equation of motion"),
    Quotient("polar_moment_per_inertia", "I_p*/Theta*", "3.18", "polar_moment", "moment_of_inertia",
             "brake of centripetal friction in the equation of motion"),
    Quotient("weight_moment_per_radial_weight", "C_theta/C_r", "3.21", "weight_moment_amplitude",
             "radial_weight_amplitude", "limit friction over tan(psi)"),
)  # fmt: skip
