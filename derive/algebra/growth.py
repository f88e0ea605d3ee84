"""How the moments of an arc grow with its half angle, from the forms without cancellation, and proved."""

from collections.abc import Mapping

import sympy as sp

from derive.algebra.rules import prove_equal, stable
from derive.declare.symbols import alpha

GROWTHS = ("weight_moment_amplitude", "radial_weight_amplitude", "polar_moment", "resistance_factor")


def arc_growth(closed: Mapping[str, sp.Expr]) -> tuple[sp.Expr, ...]:
    """Relative derivatives by alpha of C_theta, C_r, I_p*, lambda, all over Theta*, then of Theta* times alpha.

    From the reduced functions F/alpha**3, whose slopes are O(alpha) each: nothing cancels in thin arcs.
    """
    inertia = stable(closed["moment_of_inertia"]).reduced
    log_slope = sp.diff(inertia, alpha) / inertia
    found = [sp.diff(x, alpha) / x - log_slope for x in (stable(closed[n]).reduced for n in GROWTHS)]
    return (*found, 3 + alpha * log_slope)


def prove_arc_growth(closed: Mapping[str, sp.Expr]) -> list[str]:
    """Prove the slopes of the reduced functions equal to those of the closed forms over alpha**3, by name."""
    claims = []
    for name, form in closed.items():
        claim = f"{name}: slope of the reduced function"
        prove_equal(alpha**3 * sp.diff(stable(form).reduced, alpha), sp.diff(form, alpha) - 3 * form / alpha, claim)
        claims.append(claim)
    return claims
