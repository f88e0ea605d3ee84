"""Proof that the closed form of a phase in the integrator, `derive.flow.integrator.swing`, is the derived one."""

from typing import Any

from sympy import Expr, cos, expand_trig, nsimplify, sin, symbols

from derive.algebra import phase_plane
from derive.algebra.phase_plane import BASIS, NET, drive, q, sine, vers, x
from derive.algebra.prove import prove_zero
from derive.flow.integrator import swing


def factors(*problem: Any) -> list[Expr]:
    """Return the factors of E, and q, that the integrator computes from drive, sine, vers and q."""
    e: list[Any] = [0] * 5
    swing.factors(e, *problem)
    return [nsimplify(factor, rational=True) for factor in e]


def prove() -> str:
    """Prove E, its derivatives, and E about the end of a phase, and return the claim."""
    of_start = factors(drive, sine, vers, q)
    place, w, versine, lag = BASIS
    forms = (swing.energy, swing.slope_of, swing.bend_of)
    for order, form in enumerate(forms):
        found = nsimplify(form(of_start, place, lag, versine, w), rational=True)
        prove_zero(found - phase_plane.energy().diff(x, order), f"derivative {order} of E in the integrator")
    end = symbols("end", real=True)
    mirrored = expand_trig(-NET.subs(x, end - x))
    about_end = (mirrored.subs(x, 0), mirrored.diff(x).subs(x, 0), mirrored.diff(x, 2).subs(x, 0), -q)
    of_end: list[Any] = [0] * 5
    swing.mirror(of_end, drive, sine, vers, q, sin(end), 1 - cos(end))
    for found, derived in zip(of_end, factors(*about_end), strict=True):
        prove_zero(nsimplify(found, rational=True) - derived, "factors of E about the end in the integrator")
    prove_zero(swing.reversed_w(x, w, q) - w.subs(q, -q), "w of -q in the integrator")
    return f"E and {len(forms) - 1} derivatives, from both ends of a phase"
