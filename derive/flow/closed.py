"""Proof that the closed forms of a phase in the integrator are the derived ones."""

from collections.abc import Sequence
from itertools import islice
from types import SimpleNamespace
from typing import Any

from sympy import Add, Expr, cos, exp, expand_trig, nsimplify, sin, symbols

from derive.algebra import phase_plane
from derive.algebra.phase_plane import BASIS, NET, SOFTENING, drive, q, sine, vers, x
from derive.algebra.prove import prove_rational, prove_zero
from derive.flow.integrator import energy, softening
from derive.flow.integrator.softening import CONSTANT, SHIFT, SINE, TERMS, VERS
from derive.flow.layout import STRIDE


def _factors(*problem: Any) -> list[Expr]:
    """Return the four factors of `BASIS` in E = omega^2, and q, as the integrator computes them.

    ``problem`` consists of drive, sine, vers and q, see `derive.algebra.phase_plane`.
    """
    e: list[Any] = [0] * 5
    energy.factors(e, *problem)
    return e


def prove() -> str:
    """Prove E, its derivatives, and E about the end of a phase, and return the claim."""

    def claim(found: Any, derived: Any, form: str) -> None:
        exact = nsimplify(found, rational=True)
        expected = nsimplify(derived, rational=True)
        prove_zero(exact - expected, f"{form} in the integrator")

    forms = (energy.energy, energy.slope_of, energy.bend_of)
    for order, form in enumerate(forms):
        of_start = _factors(drive, sine, vers, q)
        found = form(of_start, BASIS)
        claim(found, phase_plane.energy_from_rest().diff(x, order), f"derivative {order} of E")
    end = symbols("end", real=True)
    mirrored = expand_trig(-NET.subs(x, end - x))
    about_end = [mirrored.diff(x, order).subs(x, 0) for order in range(3)]
    of_end: list[Any] = [0] * 5
    energy.mirror(of_end, drive, sine, vers, q, [end, 0, 1 - cos(end), end - sin(end)])
    for factor, derived in zip(of_end, _factors(*about_end, -q), strict=True):
        claim(factor, derived, "factors of E about the end")
    reversed_basis = [*BASIS]
    energy.reverse(reversed_basis, q)
    claim(reversed_basis[1], BASIS[1].subs(q, -q), "w of -q")
    _prove_softening()
    return f"E and {len(forms) - 1} derivatives, from both ends of a phase, and E under exponential softening"


def _prove_softening() -> None:
    """Prove the sum of the terms of E under exponential softening, and the factors of the first of them."""
    slope, brake, load, load_sine, load_vers = SOFTENING
    lanes = SimpleNamespace(
        drive=drive + load,
        net_sine=sine + load_sine,
        net_vers=vers + load_vers,
        net_square=-(q + brake) / 2,
        net_loss=load,
        net_loss_sine=load_sine,
        net_loss_vers=load_vers,
        net_loss_square=-brake / 2,
        loss_rate=-slope,
    )
    e: list[Any] = [0] * STRIDE
    softening.softening_factors(lanes, e)
    for j, problem in enumerate(islice(phase_plane.softening(), 1, 4), 1):
        found = phase_plane.energy_from_rest(problem) - _term(e, j, problem[q])
        prove_rational(nsimplify(found, rational=True), f"term {j} under softening friction in the integrator")
    e = [*symbols(f"e:{STRIDE}", real=True)]
    e[4], e[SHIFT] = q, 0
    terms = (exp(-j * slope * x) * _term(e, j, q - j * slope) for j in range(1, TERMS + 1))
    found = softening.softening_energy(e, [*BASIS, exp(-slope * x) - 1]) - Add(energy.energy(e, BASIS), *terms)
    prove_rational(nsimplify(found, rational=True), "E under softening friction in the integrator")


def _term(e: Sequence[Any], j: int, decay: Expr) -> Expr:
    """Return a term of E under softening friction without its factor exp(-j slope x), from the factors of E."""
    constant = e[CONSTANT + j] - (e[CONSTANT + j + 1] if j < TERMS else 0)
    return constant * (1 - exp(-decay * x)) + e[SINE + j] * sin(x) + e[VERS + j] * (1 - cos(x))
