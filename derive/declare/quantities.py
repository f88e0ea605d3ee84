"""Quantities of the method, declared once as data for all stages.

A new moment is one more `Moment` here, and nothing else.
"""

from dataclasses import dataclass

import sympy as sp

from derive.check.proof import ProofError
from derive.check.truth import LEVER
from derive.declare.symbols import alpha, r, theta, theta_1
from derive.kinds import Names, TextPair

HIGHEST = 5  # power of r in a weight: of r^6 the best tier is not proved within 1 ulp
TURNS = (sp.Integer(1), sp.sin(theta), -sp.sin(theta), sp.cos(theta), -sp.cos(theta))


@dataclass(frozen=True)
class Moment:
    """Double integral over the moving mass, dimensionless (r* = r/R).

    ``weight`` is integrated over r from the chord to 1 and over theta from theta_1 to theta_2: r^n, or r^n
    sin(theta) or r^n cos(theta) with a sign, n = 1 to 5. The checker of certificates defines these integrals alone.
    The best tier of r^6 is not proved within 1 ulp. The integral of r^n cos(m theta), m > 1, which cos(theta)^2
    contains, vanishes at some arc, where no relative error can be bounded. A factor such as 2 or -1 belongs to the
    caller. Where it turns with the direction of the bisector, ``amplitude`` is the name and symbol of the integral
    of r^n cos(u), u = theta - theta_m, which is left of it as a function of alpha alone. ``equation`` is its number
    in the paper, ``source`` that of a moment which is not there.
    """

    name: str
    symbol: str
    weight: sp.Expr
    help: str
    amplitude: TextPair | None = None
    equation: str = ""
    source: str = ""

    @property
    def kernel(self) -> TextPair:
        """Name and symbol of its function of alpha."""
        return self.amplitude or (self.name, self.symbol)

    @property
    def definition(self) -> Names:
        """Definition of the function of alpha in its certificates."""
        forms = {r**n * turn: n for n in range(1, HIGHEST + 1) for turn in TURNS}
        strange = [x for x in self.weight.free_symbols - {r, theta} if str(x) in ("r", "theta")]
        if strange:
            raise ProofError(f"{self.name}: weight", sp.srepr(strange[0]), f"{strange[0]} of derive.declare.symbols")
        if self.weight not in forms:
            allowed = f"r**n, +-r**n*sin(theta) or +-r**n*cos(theta), n = 1 to {HIGHEST}"
            raise ProofError(f"{self.name}: weight that can be certified", self.weight, allowed)
        turned = self.weight.has(theta)
        if turned != (self.amplitude is not None):
            allowed = "a name and a symbol" if turned else "none, as the weight does not turn"
            raise ProofError(f"{self.name}: amplitude of the weight {self.weight}", self.amplitude, allowed)
        return (f"r^{forms[self.weight]}{' cos u' if turned else ''}",)


@dataclass(frozen=True)
class Elementary:
    """Quantity given by its form in alpha, with its definition for the checker."""

    name: str
    symbol: str
    equation: str
    form: sp.Expr
    help: str
    definition: Names


@dataclass(frozen=True)
class Quotient:
    """Ratio of two base quantities, which is of order 1 as alpha -> 0 although both vanish like alpha**3."""

    name: str
    symbol: str
    equation: str
    numerator: str
    denominator: str
    help: str


# The chord that closes the mass below, in polar coordinates about the centre of the arc (2.6), (2.18).
CHORD = sp.cos(alpha) / sp.cos(theta - theta_1 - alpha)

MOMENTS = (
    Moment("polar_moment", "I_p*", r**2, "polar surface moment of inertia of the moving mass", equation="2.17"),
    Moment("moment_of_inertia", "Theta*", r**3, "moment of inertia of the moving mass about the centre",
           equation="3.12"),
    Moment("radial_weight", "J_r", -r * sp.sin(theta), "weight of the moving mass along the radius",
           amplitude=("radial_weight_amplitude", "C_r"), equation="2.23"),
    Moment("weight_moment", "J_theta", -(r**2) * sp.cos(theta), "moment of the weight about the centre",
           amplitude=("weight_moment_amplitude", "C_theta"), equation="3.13"),
)  # fmt: skip

# lambda (3.14) is no integral: its definition is 2 alpha f/R, with f the largest depth of the chord (2.12).
RESISTANCE = Elementary("resistance_factor", "lambda", "3.14", 2 * alpha * (1 - sp.cos(alpha)),
                        "lever of the resistance, arc length times depth", (LEVER,))  # fmt: skip

QUOTIENTS = (
    Quotient("dynamic_coefficient", "A", "2.24", "polar_moment", "resistance_factor",
             "coefficient of omega*^2 in the mean normal stress (2.20)"),
    Quotient("weight_moment_per_inertia", "C_theta/Theta*", "3.17", "weight_moment_amplitude", "moment_of_inertia",
             "drive of gravity in the equation of motion"),
    Quotient("radial_weight_per_inertia", "C_r/Theta*", "3.17", "radial_weight_amplitude", "moment_of_inertia",
             "brake of static friction in the equation of motion"),
    Quotient("polar_moment_per_inertia", "I_p*/Theta*", "3.18", "polar_moment", "moment_of_inertia",
             "brake of centripetal friction in the equation of motion"),
    Quotient("weight_moment_per_radial_weight", "C_theta/C_r", "3.21", "weight_moment_amplitude",
             "radial_weight_amplitude", "limit friction over tan(psi)"),
)  # fmt: skip

LIMIT_FRICTION = QUOTIENTS[-1].name  # over tan(psi)

# Closed forms as the paper prints them.
PRINTED = {
    "polar_moment": "(2*alpha - sin(2*alpha)/2 - log(Abs(tan(pi/4 + alpha/2)))*cos(alpha)**3)/3",
    "moment_of_inertia": "(alpha - sin(2*alpha)*(1 + 2*cos(alpha)**2)/6)/2",
}
