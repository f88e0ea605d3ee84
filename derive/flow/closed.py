"""Proof that the closed form of a phase in the integrator, `derive.flow.integrator.swing`, is the derived one."""

from typing import Any

from sympy import Expr, cos, expand_trig, nsimplify, sin, symbols

from derive.algebra import phase_plane
from derive.algebra.phase_plane import BASIS, NET, drive, q, sine, vers, x
from derive.algebra.prove import prove_zero
from derive.flow.integrator import swing


def _factors(*problem: Any) -> list[Expr]:
    """Return the four factors of `BASIS` in E = omega^2, and q, as the integrator computes them.

    ``problem`` consists of drive, sine, vers and q, see `derive.algebra.phase_plane`.
    """
    e: list[Any] = [0] * 5
    swing.factors(e, *problem)
    return e


def prove() -> str:
    """Prove E, its derivatives, and E about the end of a phase, and return the claim."""

    def claim(found: Any, derived: Any, form: str) -> None:
        exact = nsimplify(found, rational=True)
        expected = nsimplify(derived, rational=True)
        prove_zero(exact - expected, f"{form} in the integrator")

    forms = (swing.energy, swing.slope_of, swing.bend_of)
    for order, form in enumerate(forms):
        of_start = _factors(drive, sine, vers, q)
        found = form(of_start, BASIS)
        claim(found, phase_plane.energy_from_rest().diff(x, order), f"derivative {order} of E")
    end = symbols("end", real=True)
    mirrored = expand_trig(-NET.subs(x, end - x))
    about_end = [mirrored.diff(x, order).subs(x, 0) for order in range(3)]
    of_end: list[Any] = [0] * 5
    swing.mirror(of_end, drive, sine, vers, q, [end, 0, 1 - cos(end), end - sin(end)])
    for factor, derived in zip(of_end, _factors(*about_end, -q), strict=True):
        claim(factor, derived, "factors of E about the end")
    reversed_basis = [*BASIS]
    swing.reverse(reversed_basis, q)
    claim(reversed_basis[1], BASIS[1].subs(q, -q), "w of -q")
    return f"E and {len(forms) - 1} derivatives, from both ends of a phase"
