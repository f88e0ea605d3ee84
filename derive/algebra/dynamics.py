"""From the balance laws (3.1)-(3.8) to the equation of motion (3.16), and to its solution for every sign of a and b.

The solution is found by making the Riccati equation linear, omega = y'/(b y) with y'' = a b y, and proved by
substitution. Its stable form is branch-free in the signs: it needs only
S0(z) = sinh(sqrt z)/sqrt z, an entire function, at z = a b t**2, and decaying exponentials where z > 1.
"""

from dataclasses import dataclass, replace
from functools import cache

from sympy import (
    Abs,
    Add,
    Expr,
    Float,
    Integer,
    Max,
    Min,
    Rational,
    Symbol,
    atan,
    cancel,
    cos,
    cosh,
    diff,
    exp,
    expand,
    factor,
    log,
    nan,
    pi,
    sign,
    simplify,
    sin,
    sinh,
    solve,
    sqrt,
    symbols,
)

from derive.algebra.prove import prove_zero
from derive.algebra.remainders import Remainder, Select, log1p, unfold
from derive.algebra.rules import heads
from derive.declare.symbols import a, alpha, b, omega_0, t

# Symbols of the balance laws. Integrals over the mass enter by their dimensionless values (2.17)-(3.13).
R, g, rho, ell = symbols("R g rho ell", positive=True)
mu, theta_star, j_r, j_theta, polar = symbols("mu Theta J_r J_theta I_p", real=True)
omega_star, rate_star, sigma_mean = symbols("omega_star rate_star sigma_mean", real=True)


@cache
def balance() -> dict[str, Expr]:
    """Right-hand sides of (2.20) and (3.11)-(3.21), and both sides of (3.8), from the balance laws, by their numbers.

    Nothing is assumed beyond what the paper assumes: the radial balance as a scalar sum (2.1), the uniform normal
    stress (2.9), (3.5), and Coulomb friction (1.14).
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
    return {
        "2.10": mean,
        "2.20": Add(*(x / (1 - cos(alpha)) for x in expand(mean / (rho * g * R)).args)),  # (2.12), (2.13)
        "3.8 left": momentum,
        "3.8": moment,
        "3.11": simplify(moment.subs(sigma_mean, mean) / (ell * rho * g * R**3)),
        "3.16": a - b * omega_star**2,
        "3.17": factor(drive),
        "3.18": factor(brake),
        "3.21": solve(drive, mu)[0],  # a = 0
    }


@cache
def solution() -> dict[str, Expr]:
    """The solution of (3.16), for a b > 0 and continued to any sign, with y of omega = y'/(b y)."""
    k = _ROOT  # k**2 = a b; even in k, so valid for imaginary k, that is for a b < 0
    ways = {
        "y": Y,
        "angular_velocity": (omega_0 * cosh(k * t) + a * sinh(k * t) / k) / Y,
        "rotation": log(Y) / b,
        "angular_acceleration": (a - b * omega_0**2) / Y**2,
    }
    omega = ways["angular_velocity"]
    for claim, zero in {
        "(3.16) holds": diff(omega, t) - (a - b * omega**2),
        "the rotation's rate is the angular velocity": diff(ways["rotation"], t) - omega,
        "the acceleration is the angular velocity's rate": ways["angular_acceleration"] - diff(omega, t),
        "y is linear": diff(Y, t, 2) - k**2 * Y,
        "omega(0) = omega_0": omega.subs(t, 0) - omega_0,
        "phi(0) = 0": ways["rotation"].subs(t, 0),
    }.items():
        prove_zero(zero.subs(a, k**2 / b).rewrite(exp), claim)
    return ways


INPUTS = {
    a: "Drive, (J_theta - mu J_r)/Theta* (3.17).",
    b: "Brake, mu I_p*/Theta* (3.18).",
    omega_0: "Initial angular velocity over sqrt(g/R).",
    t: "Time over sqrt(R/g), not negative.",
}
ACCURACY = "at most 8 ulp times (1 + condition number) (sampled only: no certificate)."


@dataclass(frozen=True)
class MotionForm:
    """A stable formula of the motion: inputs, intermediate values in order, result, the textbook's form and its number.

    A formula without time is of the arrest, of a motion that is braked.
    """

    name: str
    inputs: tuple[Symbol, ...]
    let: dict[Symbol, Expr]
    result: Expr
    formula: str
    equation: str
    summary: str


_X, _K, _Z, _NEAR, _FAR, _E, _Q, _D = symbols("x k z near far e q decay", real=True)
_P, _M, _Y = symbols("P M y", real=True)
_G, _PHI_Y = symbols("G y_near", real=True)


# (3.16) made linear: omega = y'/(b y) with y'' = a b y, y(0) = 1; `solution` proves it. k = sqrt(a b).
_ROOT = Symbol("k", positive=True)
Y = cosh(_ROOT * t) + b * omega_0 * sinh(_ROOT * t) / _ROOT
Y_RATE = diff(Y, t)


def _near(expression: Expr) -> Expr:
    """Where z <= 1: cosh and sinh by their heads and remainders, which are series in z = k**2 t**2 = a b t**2."""
    split = heads(expression, {cosh(_ROOT * t): 2, sinh(_ROOT * t): 1})
    series = {r: r.func(r.args[0], r.args[1], sqrt(_NEAR)) for r in split.atoms(Remainder)}
    return split.subs(series).subs(_ROOT**2 / b, a).subs(_ROOT**2 * t**2, _NEAR).subs(t, _FAR)


def _piece(large: Expr, small: Expr) -> Expr:
    return Select(1, _Z, large, small)


# k = sqrt|a b| without overflow; z = a b t**2, clipped. Where z > 1, y is divided by exp(kt), so that nothing
# overflows, and split into its growing and its decaying part, P and M exp(-2kt), so that a start near P = 0 costs no
# digits of what it ends in. That is typed, as are the guards (no rule knows which exponential overflows, nor where a
# solution ends), and proved by `prove_forms`.
# exp(-2kt) is 0 long before kt = 800, and no solution is left beyond kt = pi where a b < 0.
_COMMON = {
    _K: sqrt(Abs(a)) * sqrt(Abs(b)),
    _X: _K * Min(t, 800 / Max(_K, Float("1e-300"))),
    _Z: sign(a) * sign(b) * _X**2,
    _NEAR: Max(Min(_Z, 1), -(pi**2)),
    _FAR: _piece(Integer(0), t),  # the time where z <= 1
    _E: exp(-_X),
    _Q: _E**2,
    _P: _K + b * omega_0,
    _M: _K - b * omega_0,
    _Y: _piece((_P + _M * _Q) / (2 * _piece(_K, Integer(1))), _near(Y)),
}


def _alive(y: Symbol, result: Expr) -> Expr:
    """The result while y > 0 and kt < pi; NaN once the solution has run to infinity."""
    return Select(0, Min(y, _Z + pi**2), result.subs(y, _guarded(y)), nan)


def _guarded(y: Symbol) -> Expr:
    return Select(0, Min(y, _Z + pi**2), y, 1)


# y = 1 + b G where z <= 1, so that phi = log1p(b G)/b loses nothing as t -> 0 or b -> 0.
_ROTATION = {_G: _near((Y - 1) / b), _PHI_Y: _piece(_Y, 1 + b * _G)}
_ROTATION_RESULT = _piece(
    (_K * _piece(t, Integer(0)) + log(_PHI_Y)) / _piece(b, Integer(1)),
    _G * Remainder(log1p, 1, _piece(Integer(0), Max(b * _G, -1 + Rational(1, 2**53)))),
)
# 1/y, applied twice: its square overflows long before the acceleration does.
_DECAY = {_D: _piece(_E, Integer(1)) / _guarded(_Y)}
_BRAKE = -a  # positive in the domain of the arrest
_ARREST = (a, b, omega_0)
_RIDE = (*_ARREST, t)

FORMS = (
    MotionForm(
        "frozen_angular_velocity",
        _RIDE,
        _COMMON,
        _alive(_Y, _piece((_P - _M * _Q) / (2 * _piece(b, Integer(1))), _near(Y_RATE / b)) / _Y),
        "omega = (omega_0 + a T)/(1 + b omega_0 T), T = tanh(k t)/k, k = sqrt(a b)",
        "3.20",
        "Angular velocity of the paper's motion, for any sign of a and b and any initial velocity.",
    ),
    MotionForm(
        "frozen_rotation",
        _RIDE,
        _COMMON | _ROTATION,
        _alive(_PHI_Y, _ROTATION_RESULT),
        "phi = ln(cosh(k t) + b omega_0 sinh(k t)/k)/b, k = sqrt(a b)",
        "4.3",
        "Rotation of the paper's motion, for any sign of a and b and any initial velocity.",
    ),
    MotionForm(
        "frozen_angular_acceleration",
        _RIDE,
        _COMMON | _DECAY,
        _alive(_Y, _piece(_P * _M / _piece(b, Integer(1)), a - b * omega_0**2) * _D**2),
        "(a - b omega_0**2)/y**2 with y = exp(b phi)",
        "3.16",
        "Angular acceleration of the paper's motion, for any sign of a and b and any initial velocity.",
    ),
    MotionForm(
        "frozen_arrest_time",
        _ARREST,
        {},
        omega_0 / _BRAKE * Remainder(atan, 1, omega_0 * (sqrt(b) / sqrt(_BRAKE))),
        "t = arctan(omega_0 sqrt(b/(-a)))/sqrt(-a b)",
        "3.20",
        "Time at which a braked motion stops.",
    ),
    MotionForm(
        "frozen_arrest_rotation",
        _ARREST,
        {},
        omega_0 * (omega_0 / _BRAKE / 2) * Remainder(log1p, 1, omega_0 * (omega_0 / _BRAKE) * b),
        "phi = ln(1 + b omega_0**2/(-a))/(2 b)",
        "4.3",
        "Rotation at which a braked motion stops.",
    ),
)


def prove_forms() -> list[str]:
    """Prove each stable formula equal to the solution, in each of its pieces; the claims."""
    claims = _of_the_ride() | _of_the_arrest()
    k, later = symbols("k t", positive=True)
    for claim, zero in claims.items():
        prove_zero(zero.subs({a: k**2 / b, t: later}).rewrite(exp), claim)
    return [*claims]


def _form(name: str) -> MotionForm:
    return next(form for form in FORMS if form.name == f"frozen_{name}")


def _of_the_ride() -> dict[str, Expr]:
    """Expressions that vanish if the formulas over time hold; the rotation is compared as exp(b phi) = y."""
    ways = solution()
    rotation = _form("rotation")
    claims = {}
    for large, regime in ((True, "a b t**2 > 1"), (False, "a b t**2 <= 1")):
        for name in ("angular_velocity", "angular_acceleration"):
            claims[f"{name}, {regime}"] = exact(_form(name), large) - ways[name]
        phi = exact(rotation, large, keep=_G)  # with G kept as one symbol, log(1 + b G)/(b G) cancels
        g = exact(replace(rotation, result=_G), large=False)
        y = exp(expand(cancel(b * phi))).subs(_G, g)
        claims[f"rotation, {regime}"] = y - ways["y"]
    return claims


def _of_the_arrest() -> dict[str, Expr]:
    """Likewise for the arrest: with a < 0 < b, k = i kappa. y at arrest is sqrt(1 + b omega_0**2/(-a))."""
    brake, b_, start = symbols("brake b_ omega", positive=True)
    kappa = sqrt(brake * b_)
    positive = {a: -brake, b: b_, omega_0: start}
    time, rotation = (unfold(_form(f"arrest_{x}").result).subs(positive) for x in ("time", "rotation"))
    y = cos(kappa * t) + b_ * start * sin(kappa * t) / kappa
    omega = start * cos(kappa * t) - brake * sin(kappa * t) / kappa
    y_at_arrest = simplify(y.subs(t, time))
    return {
        "omega = 0 at the arrest": simplify(omega.subs(t, time)),
        "rotation at the arrest": simplify(exp(2 * b_ * rotation) - y_at_arrest**2),
    }


def exact(form: MotionForm, large: bool, keep: Symbol | None = None) -> Expr:
    """A stable formula in exact arithmetic, in one of its two pieces: guards and clips undone, k = sqrt(a b) > 0."""
    k, later = symbols("k t", positive=True)
    values = {_K: k, _X: k * later, _Z: (k * later) ** 2, _NEAR: (k * later) ** 2, _FAR: later}

    def piece(smaller: Expr, larger: Expr, if_less: Expr, otherwise: Expr) -> Expr:
        return if_less if large or larger != _Z else otherwise

    def plain(e: Expr) -> Expr:
        e = e.replace(Select, piece)
        e = e.replace(lambda x: isinstance(x, (Min, Max)), lambda x: x.func(*(y for y in x.args if not y.is_number)))
        return unfold(e).subs(values)

    for symbol, value in form.let.items():
        if symbol != keep:
            values.setdefault(symbol, plain(value))
    return plain(form.result)
