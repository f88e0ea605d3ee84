"""Proof that the closed forms of a phase in the integrator are the derived ones."""

from collections.abc import Mapping
from itertools import islice
from types import SimpleNamespace
from typing import Any

import mpmath
from sympy import Add, Expr, Float, Integer, Rational, cos, exp, expand_trig, lambdify, nsimplify, sin, symbols

from derive.algebra import phase_plane
from derive.algebra.phase_plane import (
    BASIS,
    E_AT,
    EQUATION,
    HYPERBOLIC,
    LEFT,
    NET,
    SLOPE_OF_E,
    SOFTENING,
    drive,
    q,
    sine,
    vers,
    x,
)
from derive.algebra.prove import prove_zero
from derive.check.proof import ProofError
from derive.flow.integrator import energy, recurrence, softening
from derive.flow.integrator.hyperbolic import FIRST, HALF, SHIFT, hyperbolic_energy
from derive.flow.integrator.softening import TERMS
from derive.flow.layout import STRIDE

PROBLEM = (drive, sine, vers, q, *SOFTENING)
NEAR_START = 2.0**-100
PROVED = 5  # coefficients of E, of which the last follows from all terms of the recurrence
DIGITS = 800  # more than terms of E have so close to its start


def _factors(*problem: Any) -> list[Expr]:
    """Return the four factors of `BASIS` in E = omega^2, and q, as the integrator computes them.

    ``problem`` consists of drive, sine, vers and q, see `derive.algebra.phase_plane`.
    """
    e: list[Any] = [0] * 5
    energy.factors(e, *problem)
    return e


def _exact(found: Any) -> Expr:
    """Return an expression with rational numbers for floats, replaced in one pass, as `nsimplify` searches for each."""
    return found.xreplace({number: nsimplify(number, rational=True) for number in found.atoms(Float)})


def prove() -> str:
    """Prove E from both ends of a phase, and return the claim."""

    def claim(found: Any, derived: Any, form: str) -> None:
        prove_zero(_exact(found) - _exact(derived), f"{form} in the integrator")

    claim(energy.energy(_factors(drive, sine, vers, q), BASIS), phase_plane.energy_from_rest(), "E")
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
    _prove_hyperbolic()
    _prove_recurrence()
    return "E from both ends of a phase, and E under softening laws"


def lane(values: Mapping[Expr, Any], per_pole: Any = 0) -> Any:
    """Return the cells of a lane with softening friction from the values of the symbols in `PROBLEM`.

    ``per_pole`` is the slope if friction is hyperbolic.
    """
    of_drive, of_sine, of_vers, decay, slope, brake, load, load_sine, load_vers = (values[x] for x in PROBLEM)
    one = slope / slope
    return SimpleNamespace(
        drive=of_drive + load,
        net_sine=of_sine + load_sine,
        net_vers=of_vers + load_vers,
        net_square=-(decay + brake) / 2,
        net_loss=load,
        net_loss_sine=load_sine,
        net_loss_vers=load_vers,
        net_loss_square=-brake / 2,
        loss_rate=-slope,
        per_pole=per_pole,
        has=SimpleNamespace(loss_rate=True, per_pole=per_pole != 0),
        inverse=[0, *(one / k for k in range(1, STRIDE))],
    )


def _prove_softening() -> None:
    """Prove E as a function of the rotation under exponential softening, for rational numbers."""
    slope = SOFTENING[0]
    e: list[Any] = [0] * STRIDE
    softening.softening_factors(lane({symbol: symbol for symbol in PROBLEM}), e)
    e[SHIFT] = 0  # without the factor exp(brake W/slope)
    first = symbols("first")
    e[FIRST] = first
    fall = first * exp(-slope * x)
    found = softening.softening_energy(e, [*BASIS, fall - first])
    for j, problem in enumerate(islice(phase_plane.softening(), TERMS + 1)):
        found -= fall**j * phase_plane.energy_from_rest(problem)
    numbers = {symbol: Rational(k, 7) for k, symbol in enumerate((*PROBLEM, first), 2)}
    prove_zero(_exact(found).xreplace(numbers), "E under softening friction in the integrator")


def _prove_hyperbolic() -> None:
    """Prove E under hyperbolic softening by substitution: near the start the equation misses the omitted terms only."""
    missed = lambdify((*PROBLEM, x, E_AT, SLOPE_OF_E), HYPERBOLIC, "mpmath")
    with mpmath.workdps(2 * DIGITS):
        values = {symbol: mpmath.mpf(k) / 7 for k, symbol in enumerate(PROBLEM, 2)}
        slope = values[SOFTENING[0]]
        e: list[Any] = [mpmath.mpf(0)] * STRIDE
        softening.softening_factors(lane(values, slope), e)

        def energy_at(place: Any) -> Any:
            return hyperbolic_energy(e, [0], mpmath.log1p(slope * place))

        place = mpmath.mpf(NEAR_START)
        found = missed(*values.values(), place, energy_at(place), mpmath.diff(energy_at, place))
        if abs(found) > place ** (2 * HALF):
            raise ProofError("E under hyperbolic friction in the integrator", mpmath.nstr(found))


def _prove_recurrence() -> None:
    """Prove the first coefficients of E in a piece of a table, by substitution of their series in the equation."""
    s = lane({symbol: symbol for symbol in PROBLEM})
    fall = symbols("fall:3")
    s.tables = [SimpleNamespace(degree=len(fall), coefficients=fall)]
    e, net, weight = ([Integer(0)] * STRIDE for _ in range(3))
    e[0] = E_AT
    s.series = SimpleNamespace(omega=e, net=net)
    recurrence.expand_force(s, net, s.drive, s.net_sine, s.net_vers, PROVED)
    recurrence.expand_force(s, weight, s.net_loss, s.net_loss_sine, s.net_loss_vers, PROVED)
    for n in range(PROVED):
        recurrence.complete_net(s, weight, n)
        e[n + 1] = 2 * net[n] / (n + 1)
    found = _exact(Add(*(coefficient * x**n for n, coefficient in enumerate(e))))
    left = 1 + Add(*(coefficient * x**k for k, coefficient in enumerate(fall, 1)))
    missed = EQUATION.subs({LEFT: left, SLOPE_OF_E: found.diff(x), E_AT: found}, simultaneous=True)
    for n in range(PROVED):
        prove_zero(missed.diff(x, n).subs(x, 0), "E in a piece of a table in the integrator")
