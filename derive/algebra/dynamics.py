"""Equation of motion (3.16), derived from the balance laws (3.1)-(3.8), and its solution for all signs of a and b.

The substitution omega = y'/(b y) makes the Riccati equation linear, y'' = a b y. The solution is proved by insertion.
"""

from functools import cache

from sympy import Add, Symbol, cos, cosh, diff, exp, expand, factor, log, simplify, sinh, solve, sqrt, symbols

from derive.algebra.prove import prove_zero
from derive.declare.symbols import Forms, a, alpha, b, omega_0, t

# Symbols of the balance laws. Integrals over the mass enter by their dimensionless values (2.17)-(3.13).
R, g, rho, ell = symbols("R g rho ell", positive=True)
mu, theta_star, j_r, j_theta, polar = symbols("mu Theta J_r J_theta I_p", real=True)
omega_star, rate_star, sigma_mean = symbols("omega_star rate_star sigma_mean", real=True)


@cache
def balance() -> Forms:
    """Return the right-hand sides of (2.20) and (3.11)-(3.21), and both sides of (3.8), by equation number.

    The assumptions are the paper's: the radial balance as a scalar sum (2.1), the uniform normal stress (2.9), (3.5),
    and Coulomb friction (1.14).
    """
    omega = omega_star * sqrt(g / R)  # (2.21)
    # Radial balance (2.5) with the mean stress (2.9); r = R r* scales the integrals by R**2 and R**3 (2.16).
    mean = rho * (g * R**2 * j_r + omega**2 * R**3 * polar) / (2 * alpha * R)
    # Angular momentum (3.2) with the moments (3.3)-(3.5), (3.7); Theta from (3.1), and (3.10) from t = t* sqrt(R/g).
    momentum = ell * rho * R**4 * theta_star * rate_star * g / R
    moment = ell * rho * g * R**3 * j_theta - R * mu * sigma_mean * ell * R * 2 * alpha
    right = expand(solve(momentum - moment.subs(sigma_mean, mean), rate_star)[0])
    drive = right.coeff(omega_star, 0)
    brake = -right.coeff(omega_star, 2)
    prove_zero(right - (drive - brake * omega_star**2), "(3.16)")
    depth = 1 - cos(alpha)  # (2.12) over R, by which (2.13) is the reference stress
    terms = expand(mean / (rho * g * R)).args
    scale = ell * rho * g * R**3
    return {
        "2.10": mean,
        "2.20": Add(*(x / depth for x in terms)),
        "3.8 left": momentum,
        "3.8": moment,
        "3.11": simplify(moment.subs(sigma_mean, mean) / scale),
        "3.16": a - b * omega_star**2,
        "3.17": factor(drive),
        "3.18": factor(brake),
        "3.21": solve(drive, mu)[0],  # a = 0
    }


@cache
def solution() -> Forms:
    """Return the solution of (3.16) by name for a b > 0, continued to any sign: omega = y'/(b y)."""
    k = Symbol("k", positive=True)  # k**2 = a b; even in k, so valid for imaginary k, that is for a b < 0
    y = cosh(k * t) + b * omega_0 * sinh(k * t) / k
    ways = {"angular_velocity": (omega_0 * cosh(k * t) + a * sinh(k * t) / k) / y, "rotation": log(y) / b}
    omega = ways["angular_velocity"]
    claims = {
        "(3.16) holds": diff(omega, t) - (a - b * omega**2),
        "the rotation's rate is the angular velocity": diff(ways["rotation"], t) - omega,
        "omega(0) = omega_0": omega.subs(t, 0) - omega_0,
        "phi(0) = 0": ways["rotation"].subs(t, 0),
    }
    for claim, zero in claims.items():
        prove_zero(zero.subs(a, k**2 / b).rewrite(exp), claim)
    return ways


def prove() -> str:
    """Derive the balance and its solution, and return a summary of the derived equations."""
    balance()
    solution()
    return "(2.20), (3.8)-(3.18), (3.21) derived; (3.20), (4.3) solve (3.16)"
