"""Postulates of the paper: claims that do not follow from earlier claims.

For each postulate the module exhibits a state of the mass that satisfies all earlier postulates and violates this one.
`exhibit` checks both, so that no verdict is a matter of opinion. The size of the effect is reported as well, without
influence on the verdict.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import takewhile
from typing import Any

from mpmath import cos, mpf, quad, sin, workdps
from sympy import Expr, Integer

from derive.algebra.dynamics import mu, omega_star, sigma_mean
from derive.check.proof import ProofError
from derive.declare.symbols import a, b, t, theta, u
from derive.judge.mechanics import a_of, b_of, j_r, j_theta, mu_of, sigma, sigma_n, tau_n, turn
from derive.judge.section import DIP, HALF, RESIDUAL, change_by_rotation, limit_friction, moment, reached

Along = Callable[[Any], mpf]  # a function of u = theta - theta_m, along the arc


@dataclass(frozen=True)
class PaperState:
    """State of the paper's mass: friction, dip of the chord, omega*, and the normal stress over rho g R.

    ``stress`` is a function along the arc. Without it the scalar sum (2.5) is distributed uniformly.
    """

    stress: Along | None = None
    friction: Along = lambda u: RESIDUAL
    psi: mpf = DIP
    omega: mpf | int = 0

    @cached_property
    def total(self) -> mpf:
        """Total of the stress along the arc by (2.5)."""
        return moment("radial_weight", psi=self.psi) + moment("polar_moment") * self.omega**2

    def normal(self, u: Any) -> mpf:
        """Return the normal stress over rho g R at u, rad from the bisector."""
        return self.stress(u) if self.stress else self.total / (2 * HALF)


def sum_of(f: Along) -> mpf:
    """Return the integral of f(u) along the arc over the angle u in rad."""
    return quad(f, [-HALF, 0, HALF])


def columns(u: mpf) -> mpf:
    """Return the normal stress over rho g R at u at rest, if all radial columns were independent."""
    return cos(DIP - u) * (1 - (cos(HALF) / cos(u)) ** 2) / 2


def bisector_stress(u: mpf) -> mpf:
    """Return the uniform normal stress over rho g R at rest, by the balance of forces along the bisector.

    Its resultant is 2 R sin(alpha) sigma, the shear is odd in u, and the weight is the segment's.
    """
    area = HALF - sin(2 * HALF) / 2
    return area * cos(DIP) / (2 * sin(HALF))


def uneven(u: mpf) -> mpf:
    """Return a friction coefficient at u that is 10 % larger at one end of the arc and 10 % smaller at the other."""
    return RESIDUAL * (1 - u / (10 * HALF))


@dataclass(frozen=True)
class Postulate:
    """Postulate: its substitution in a derived form, its condition on a state, and a state that violates it.

    ``gap`` is zero if a state satisfies it. ``effect`` describes its importance with ``size``, and as ``{printed}``
    with the paper's coefficients.
    """

    words: str
    put: tuple[tuple[Expr, Expr], ...]
    gap: Callable[[PaperState], mpf]
    alternative: str
    state: Callable[[], PaperState]
    effect: str
    size: Callable[[], mpf]
    printed_size: Callable[[], mpf] = mpf


def _of_uniform(stress: Along) -> mpf:
    """Return the relative excess of a stress in the middle of the arc over the uniform stress at rest."""
    return stress(mpf(0)) / PaperState().normal(0) - 1


def _centripetal_share(as_printed: bool = False) -> mpf:
    """Return the centripetal over the static stress after 30 s of (3.20), on request with the paper's inputs."""
    return PaperState(omega=reached("omega*", as_printed)).total / PaperState().total - 1


# In the order in which the paper first needs them.
POSTULATES = (
    Postulate(
        "Coulomb friction, one coefficient",
        ((tau_n, mu * sigma_n),),
        lambda x: x.friction(HALF) / x.friction(-HALF) - 1,
        "friction that varies along the arc",
        lambda: PaperState(friction=uneven),
        "20 % from end to end change the friction force by {} if columns stand alone",
        lambda: sum_of(lambda u: uneven(u) * columns(u)) / sum_of(lambda u: RESIDUAL * columns(u)) - 1,
    ),
    Postulate(
        "radial components of different directions are added as scalars",
        ((u, Integer(0)),),
        lambda x: sum_of(x.normal) / x.total - 1,
        "vector balance along the bisector",
        lambda: PaperState(bisector_stress),
        "stress at rest larger by {}",
        lambda: _of_uniform(bisector_stress),
    ),
    Postulate(
        "uniform stress, where the distribution is undetermined",
        ((sigma(theta), sigma_mean),),
        lambda x: x.normal(0) * 2 * HALF / sum_of(x.normal) - 1,
        "radial columns that stand alone",
        lambda: PaperState(columns),
        "0 at the ends, {} above the mean in the middle",
        lambda: _of_uniform(columns),
    ),
    Postulate(
        "centripetal stress neglected, for slow rotation",
        ((omega_star, Integer(0)),),
        lambda x: x.total / PaperState(psi=x.psi).total - 1,
        "a mass that moves",
        lambda: PaperState(omega=reached("omega*")),
        "{} of the static stress after 30 s of (3.20) with correct coefficients, {printed} with the paper's own",
        _centripetal_share,
        lambda: _centripetal_share(as_printed=True),
    ),
    Postulate(
        "J_r frozen",
        ((j_r, j_r.subs(turn, 0)),),
        lambda x: change_by_rotation("radial_weight", DIP - x.psi),
        "the mass turns",
        lambda: PaperState(psi=DIP - reached("phi", as_printed=True)),
        "{} over the paper's rotation in 30 s",
        lambda: change_by_rotation("radial_weight"),
    ),
    Postulate(
        "J_theta frozen",
        ((j_theta, j_theta.subs(turn, 0)),),
        lambda x: change_by_rotation("weight_moment", DIP - x.psi),
        "the mass turns by twice its dip, which reverses J_theta and leaves J_r",
        lambda: PaperState(psi=-DIP),
        "{} over the paper's rotation in 30 s",
        lambda: change_by_rotation("weight_moment"),
    ),
    Postulate(
        "friction at its residual value from the start, and constant",
        ((mu_of(t), mu), (a_of(t), a), (b_of(t), b)),
        lambda x: x.friction(0) / RESIDUAL - 1,
        "friction that softens from its limit",
        lambda: PaperState(friction=lambda u: limit_friction()),
        "drops by {} of the limit friction at once",
        lambda: 1 - RESIDUAL / limit_friction(),
    ),
)


def same_force() -> mpf:
    """Return the deviation from uniformity of a stress with the same friction force (3.5), for one coefficient."""
    force = sum_of(columns) / sum_of(PaperState().normal)
    if abs(force - 1) > mpf(10) ** -20:
        raise ProofError("friction force of columns that stand alone, over that of the uniform stress", force, 1)
    return _of_uniform(columns)


@cache
def exhibit(postulate: Postulate) -> mpf:
    """Return the size of a postulate's effect, after checking that its state violates this postulate alone."""
    earlier = takewhile(lambda x: x.words != postulate.words, POSTULATES)
    with workdps(30):
        state = postulate.state()
        tiny = mpf(10) ** -20
        broken = [x.words for x in earlier if abs(x.gap(state)) > tiny]
        if broken or abs(postulate.gap(state)) <= tiny:
            raise ProofError(postulate.alternative, f"it breaks {broken or 'nothing'}", "this postulate alone broken")
        return postulate.size()
