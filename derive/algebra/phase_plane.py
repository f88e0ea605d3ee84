"""Motion in the phase plane: E = omega^2 as a function of the rotation, by a linear equation with closed solutions.

While a mass slides in one direction and presses on its surface, d omega/dt = (dE/dx)/2, where x is the rotation since
the phase began. If forces depend on the rotation and on omega^2 alone, (3.11) is therefore E' + k(x) E = 2 f(x).
"""

from collections.abc import Iterator
from functools import cache
from itertools import islice

from sympy import (
    Add,
    Expr,
    Function,
    Integer,
    Poly,
    Symbol,
    cos,
    diff,
    exp,
    expand,
    factorial,
    sin,
    solve,
    sqrt,
    symbols,
)

from derive.algebra import dynamics
from derive.algebra.prove import prove_zero

x, q, drive, sine, vers = symbols("x q drive sine vers", real=True)
SOFTENING = slope, brake, load, load_sine, load_vers = symbols("slope brake load load_sine load_vers", real=True)
NET = drive + sine * sin(x) + vers * (1 - cos(x))  # net moment over Theta*, without the part that omega^2 causes
LOAD = load + load_sine * sin(x) + load_vers * (1 - cos(x))  # what friction loses of it by exp(-slope x)
E_AT, SLOPE_OF_E, LEFT = symbols("E slope_of_E left", real=True)
EQUATION = SLOPE_OF_E + (q + brake * LEFT) * E_AT - 2 * (NET + LEFT * LOAD)  # zero under any law with LEFT for the exp
HYPERBOLIC = EQUATION.subs(LEFT, 1 / (1 + slope * x))
W = (q * x - 1 + exp(-q * x)) / q**2
# Functions of which E is the sum: none cancels for small x, and x^2 1F1(1; 3; -q x)/2 = W is regular at q = 0.
BASIS = (x, W, 1 - cos(x), x - sin(x))


@cache
def equation() -> tuple[Expr, Expr]:
    """Return k and f of the linear equation E' + k E = 2 f, derived from (3.11), over Theta*."""
    energy = Function("E")(x)
    omega = sqrt(energy)
    rate = dynamics.balance()["3.11"].subs(dynamics.omega_star, omega)
    prove_zero(2 * omega * diff(omega, x) - diff(energy, x), "2 omega domega/dx = dE/dx")
    right = expand(2 * rate)
    k = -right.coeff(energy, 1)
    f = right.coeff(energy, 0) / 2
    prove_zero(right - (2 * f - k * energy), "(3.11) is linear in E")
    return k, f


@cache
def constant() -> tuple[Expr, ...]:
    """Return the factors of `BASIS` in E = omega^2 from rest under constant friction, k = q and f = NET."""
    unknown = symbols("e:4")
    energy = Add(*(factor * function for factor, function in zip(unknown, BASIS, strict=True)))
    residual = Poly(expand(diff(energy, x) + q * energy - 2 * NET), x, exp(-q * x), sin(x), cos(x))
    (factors,) = solve(residual.coeffs(), unknown, dict=True)
    known = tuple(factors[e] for e in unknown)
    solution = energy.subs(factors)
    prove_zero(diff(solution, x) + q * solution - 2 * NET, "E under constant friction solves the equation")
    prove_zero(solution.subs(x, 0), "E starts from rest")
    return known


Problem = dict[Symbol, Expr]  # drive, sine, vers and q of a problem with constant friction


def energy_from_rest(problem: Problem | None = None) -> Expr:
    """Return E = omega^2 from rest as a function of x under constant friction, of a problem or of the symbols."""
    total = Add(*(factor * function for factor, function in zip(constant(), BASIS, strict=True)))
    return total.subs(problem or {}, simultaneous=True)


def softening() -> Iterator[Problem]:
    """Yield the problems with constant friction whose solutions are E under exponentially softening friction.

    With W = exp(-slope x) the equation is E' + (q + brake W) E = 2 (NET + W LOAD), and E is exp(brake W/slope) times
    the sum over j of W^j E_j. E_j is E under constant friction with q - j slope for q, and t_j NET + t_(j-1) LOAD for
    NET, where t_j = (-brake/slope)^j/j!. A resonance, q = j slope, needs no exception: `BASIS` is regular at q = 0.
    """
    parts = ((drive, load), (sine, load_sine), (vers, load_vers))
    before = Integer(0)
    t = Integer(1)
    j = 0
    while True:
        yield {a: t * a + before * b for a, b in parts} | {q: q - j * slope}
        j += 1
        before = t
        t = -t * brake / (slope * j)


def prove() -> str:
    """Derive the linear equation, prove its solutions by substitution, and return a summary."""
    equation()
    fall = Symbol("W")
    problems = list(islice(softening(), 3))
    for j, problem in enumerate(problems):
        term = exp(-j * slope * x) * energy_from_rest(problem)
        net = NET.subs(problem, simultaneous=True) * exp(-j * slope * x)
        prove_zero(diff(term, x) + q * term - 2 * net, f"term {j} under softening friction")
        weight = diff(exp(-brake * fall / slope), fall, j).subs(fall, 0) / factorial(j)
        prove_zero(problem[drive].coeff(drive) - weight, f"weight {j} of exp(-brake W/slope)")
    factor = exp(brake * exp(-slope * x) / slope)
    prove_zero(diff(factor, x) + brake * exp(-slope * x) * factor, "exp(brake W/slope) removes brake W E")
    return "E' + k E = 2 f derived from (3.11), solved for constant friction and for exponential softening"
