"""The quantities of the method, declared once as data; every stage walks these lists.

A new moment is one more `Moment` here, and nothing else.
"""

from dataclasses import dataclass

import sympy as sp

from derive.check.proof import ProofError
from derive.check.truth import LEVER
from derive.declare.symbols import alpha, r, theta, theta_1

HIGHEST = 5  # power of r in a weight: the forms beyond are right too, but nothing here shows it


@dataclass(frozen=True)
class Moment:
    """A double integral over the moving mass, dimensionless (r* = r/R).

    ``weight`` is integrated over r from the chord to 1 and over theta from theta_1 to theta_2: r^n, or r^n sin(theta)
    or r^n cos(theta) with a sign. Where it turns with the direction of the bisector, ``amplitude`` is the name and
    symbol of the integral of r^n cos(u), u = theta - theta_m, which is left of it as a function of alpha alone.
    A moment that is not ``certified`` may have any weight that SymPy integrates, and takes what rules make of it.
    """

    name: str
    symbol: str
    equation: str
    weight: sp.Expr
    help: str
    amplitude: tuple[str, str] | None = None
    certified: bool = True

    @property
    def kernel(self) -> tuple[str, str]:
        """Name and symbol of its function of alpha."""
        return self.amplitude or (self.name, self.symbol)

    @property
    def definition(self) -> tuple[str, ...]:
        """The definition of the function of alpha that its certificates state."""
        power = sp.degree(self.weight, r) if self.weight.is_polynomial(r) else sp.Integer(0)
        turn = self.weight / r**power
        turned = turn in (sp.sin(theta), -sp.sin(theta), sp.cos(theta), -sp.cos(theta))
        if not (1 <= power <= HIGHEST and (turn == 1 or turned)):
            allowed = f"r**n, +-r**n*sin(theta) or +-r**n*cos(theta), n = 1 to {HIGHEST}, or certified=False"
            raise ProofError(f"{self.name}: weight that can be certified", self.weight, allowed)
        if turned != (self.amplitude is not None):
            allowed = "a name and a symbol" if turned else "none, as the weight does not turn"
            raise ProofError(f"{self.name}: amplitude of the weight {self.weight}", self.amplitude, allowed)
        return (f"r^{power}{' cos u' if turned else ''}",)


@dataclass(frozen=True)
class Elementary:
    """A quantity by its form in alpha, and its definition in the checker's words."""

    name: str
    symbol: str
    equation: str
    form: sp.Expr
    help: str
    definition: tuple[str, ...]


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
    Moment("radial_weight", "J_r", "2.23", -r * sp.sin(theta), "weight of the moving mass along the radius",
           amplitude=("radial_weight_amplitude", "C_r")),
    Moment("weight_moment", "J_theta", "3.13", -(r**2) * sp.cos(theta), "moment of the weight about the centre",
           amplitude=("weight_moment_amplitude", "C_theta")),
)  # fmt: skip

# lambda (3.14) is no integral: its definition is 2 alpha f/R, with f the largest depth of the chord (2.12).
RESISTANCE = Elementary("resistance_factor", "lambda", "3.14", 2 * alpha * (1 - sp.cos(alpha)),
                        "lever of the resistance, arc length times depth", (LEVER,))  # fmt: skip

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

# Closed forms as the paper prints them.
PRINTED = {
    "polar_moment": "(2*alpha - sin(2*alpha)/2 - log(Abs(tan(pi/4 + alpha/2)))*cos(alpha)**3)/3",
    "moment_of_inertia": "(alpha - sin(2*alpha)*(1 + 2*cos(alpha)**2)/6)/2",
}
