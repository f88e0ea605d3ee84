"""What a scene may ask for, declared once as data: friction laws, and effects as terms of the equation of motion.

A new effect is one more `Effect` here. Its runtime half (names, units, bounds, help, and which generated functions
serve which combination) is written to `generated/effects.py`, and scenes, plans and help texts read that.
"""

from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from derive.integrate import prove_zero

# The equation of motion: Theta* d(omega*)/dt* = J_theta - lambda mu (J_r/lambda + stress), design of (3.11).
THETA, J_R, J_THETA, LAMBDA, A, MU, OMEGA = sp.symbols("Theta J_r J_theta lambda A mu omega", real=True)
MU_EQ, RADIAL_PER_INERTIA, POLAR_PER_INERTIA, STATIC = sp.symbols(
    "limit_friction radial_weight_per_inertia polar_moment_per_inertia static", real=True
)


@dataclass(frozen=True)
class Parameter:
    """A number that an effect or a law needs. Bounds are open where ``lower`` or ``upper`` is infinite."""

    name: str
    unit: str
    lower: float
    upper: float
    help: str


@dataclass(frozen=True)
class Effect:
    """A term that a scene may call for.

    ``stress`` is what it adds to the mean normal stress, over sigma_ref; ``moment`` what it adds to the right-hand
    side beyond friction. ``depends_on`` decides which methods can solve it.
    """

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str
    stress: sp.Expr = sp.Integer(0)
    moment: sp.Expr = sp.Integer(0)


@dataclass(frozen=True)
class Law:
    """A friction law: the friction coefficient as a function of what it depends on."""

    name: str
    equation: str
    parameters: tuple[Parameter, ...]
    depends_on: tuple[str, ...]
    help: str


LAWS = (
    Law("constant", "1.14", (Parameter("coefficient", "", 0.0, float("inf"), "friction coefficient, tan(phi)"),), (),
        "friction does not change"),
)  # fmt: skip

EFFECTS = (
    Effect("centripetal", "2.20", (), ("speed",),
           "the mass presses harder on the slip surface the faster it turns", stress=A * OMEGA**2),
)  # fmt: skip


@dataclass(frozen=True)
class Specialised:
    """The equation of motion with some effects and without the others: a - b omega**2, and the mean stress."""

    effects: tuple[str, ...]
    prefix: str  # of its generated functions
    drive: sp.Expr
    brake: sp.Expr
    stress: sp.Expr


def specialise() -> list[Specialised]:
    """Every combination of effects for frozen geometry and constant friction.

    The drive is written with the limit friction, J_r (mu_eq - mu)/Theta*, so that the decision whether the mass
    moves and the size of its drive come from one number.
    """
    found = []
    for count in range(len(EFFECTS) + 1):
        for chosen in combinations(EFFECTS, count):
            stress = J_R / LAMBDA + sum(e.stress for e in chosen)
            rate = sp.expand((J_THETA - LAMBDA * MU * stress + sum(e.moment for e in chosen)) / THETA)
            drive, brake = rate.coeff(OMEGA, 0), -rate.coeff(OMEGA, 2)
            prove_zero(rate - (drive - brake * OMEGA**2), "the rate is quadratic in omega")
            of_ratios = RADIAL_PER_INERTIA * (MU_EQ - MU)
            prove_zero(of_ratios.subs({RADIAL_PER_INERTIA: J_R / THETA, MU_EQ: J_THETA / J_R}) - drive, "the drive")
            brake = brake.subs(LAMBDA, POLAR_PER_INERTIA * THETA / A)  # lambda A = I_p* (2.24)
            names = tuple(e.name for e in chosen)
            dynamic = sp.expand(stress - J_R / LAMBDA)
            found.append(Specialised(names, "_".join(("frozen", *names)), of_ratios, brake, STATIC + dynamic))
    return found
