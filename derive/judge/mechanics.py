"""Forms derived from the definitions, with which `derive.judge.verify` compares the printed forms.

The module is independent of the printed forms. For a turning mass J_r and J_theta are functions of the rotation phi.
The paper's postulates about them and about the stress are in `derive.judge.postulates`.
"""

from functools import cache
from itertools import islice

import sympy as sp
from sympy import (
    Add,
    Expr,
    Function,
    Integer,
    Integral,
    Matrix,
    O,
    Symbol,
    cos,
    expand,
    numer,
    parse_expr,
    sign,
    simplify,
    sin,
    solve,
    sqrt,
    together,
)

from derive.algebra import dynamics
from derive.algebra.dynamics import R, ell, g, mu, polar, rho, sigma_mean
from derive.declare import symbols
from derive.declare.quantities import CHORD, RESISTANCE
from derive.declare.symbols import Forms, a, alpha, b, omega_0, r, t, theta, theta_1, theta_2, u
from derive.kinds import ValueDict

Pair = tuple[Expr, Expr]

c0, c1, c2 = sp.symbols("c0 c1 c2", positive=True)
omega, omega_dot, sigma_n, tau_n, turn = sp.symbols("omega omega_dot sigma_n tau_n phi", real=True)
sigma, mu_of, a_of, b_of, omega_of = sp.symbols("sigma mu_of a_of b_of omega_of", cls=Function)
j_r, j_theta = (Function(x.name)(turn) for x in (dynamics.j_r, dynamics.j_theta))
LEVER = RESISTANCE.form  # lambda (3.14)
DEPTH = simplify(R * LEVER / (2 * alpha))  # f (2.12)


def basis(x: Expr, y: Expr) -> Pair:
    """Return the components along e_r and e_theta of a vector with the Cartesian components x and y."""
    c = cos(theta)
    s = sin(theta)
    return simplify(x * c + y * s), simplify(y * c - x * s)


def rate(order: int) -> Pair:
    """Return the polar components of a time derivative of the position r e_r, with d(theta)/dt = omega (1.2).

    ``order`` is the order of the derivative, 1 or 2.
    """
    moving = Function("theta")(t)
    values = ((moving.diff(t, 2), omega_dot), (moving.diff(t), omega), (moving, theta))
    position = (r * cos(moving), r * sin(moving))
    x, y = (coordinate.diff(t, order).subs(values) for coordinate in position)
    return basis(x, y)


def planar() -> Expr:
    """Return the component normal to a plane of the acceleration of a point that moves along the plane."""
    x, y = ((Function("s")(t) * f(theta)).diff(t, 2) for f in (cos, sin))
    return basis(x, y)[1]


GRAVITY: Pair = basis(Integer(0), -g)


def reaction() -> Pair:
    """Return the components of the traction on the arc: pressure against the normal, shear against the velocity."""
    tangent = _direction(theta).diff(theta)
    x, y = -sigma_n * Matrix([tangent[1], -tangent[0]]) - tau_n * tangent
    pressure, shear = basis(x, y)
    return pressure, shear * sign(omega)


def _direction(angle: Expr) -> Matrix:
    """Return the unit vector (cos, sin) at a polar angle."""
    return Matrix([cos(angle), sin(angle)])


def moment_of(radius: Expr, force: Pair) -> Expr:
    """Return the moment about the centre K of a force in polar components, at this radius.

    Its radial part has no lever.
    """
    return radius * force[1]


def along_bisector(force: Pair) -> Expr:
    """Return the component along the arc's bisector of a force in polar components, u = theta - theta_m from it."""
    return force[0] * cos(u) - force[1] * sin(u)


def end_angle(start: Symbol) -> Expr:
    """Return the polar angle of an end of the arc (1.2) at the time t, from its angle at the start.

    The variable of integration is separate.
    """
    return start + Integral(omega_of(r), (r, 0, t))


_POSITION = r * _direction(theta)
_TANGENT = (R * _direction(theta)).diff(theta)
AREA = simplify(_POSITION.jacobian([r, theta]).det())  # over dr dtheta
ARC = sqrt(simplify(_TANGENT.dot(_TANGENT)))  # over dtheta, on the circle
STRESS_SUM = Integral(sigma(u), (u, 0, 2 * alpha))  # along the arc, over the angle from its first end


@cache
def chord() -> Expr:
    """Return the point where the ray at theta meets the line through both ends of the arc, from collinearity."""
    first = R * _direction(theta_1)
    second = R * _direction(theta_1 + 2 * alpha)
    return solve(Matrix.hstack(r * _direction(theta) - first, second - first).det(), r)[0]


@cache
def deepest() -> Expr:
    """Return the largest R - R_1, at the only stationary point in u = theta - theta_m, a maximum."""
    depth = R * (1 - cos(alpha) / cos(u))
    stationary = solve(numer(together(depth.diff(u))), u)
    curvature = depth.diff(u, 2) / cos(alpha)
    (maximum,) = (x for x in stationary if curvature.subs(u, x).is_negative)
    return depth.subs(u, maximum)


def body_star(f: Expr, low: Expr = CHORD, high: Expr = Integer(1)) -> Expr:
    """Return the double integral of f from the chord to the arc in r* = r/R, with constants outside.

    The limits ``low`` and ``high`` are those of r*, and theta extends from theta_1 to theta_2.
    """
    result = Integer(0)
    for term in Add.make_args(expand(f)):
        constant, rest = term.as_independent(r, theta)
        result += constant * Integral(rest, (r, low, high), (theta, theta_1, theta_2))
    return result


def body(f: Expr) -> Expr:
    """Return the double integral of f dr dtheta over the mass, from the chord to the arc."""
    return body_star(f, R * CHORD, R)


def scaled_body(f: Expr) -> Expr:
    """Return `body` of f after the substitution r = R r*."""
    return body_star(f.subs(r, R * r) * R)


@cache
def radial() -> Expr:
    """Return R times the integral of sigma_n over the angle: (2.1) with (1.8), (1.11), (1.12), (2.3) and (2.4)."""
    weight = rho * GRAVITY[0]
    inertia = rho * rate(2)[0]
    pressure, _ = reaction()
    return expand((body(inertia * AREA) - body(weight * AREA)) / pressure.coeff(sigma_n))


def derived_form(equation: str) -> Expr:
    """Return a derived form of the balance by its equation number, such as "3.8", for a turning mass."""
    return dynamics.balance()[equation].subs({dynamics.j_r: j_r, dynamics.j_theta: j_theta})


def momentum() -> Pair:
    """Return both sides of (3.8), over ell rho: the rate of angular momentum, and the moment."""
    left = derived_form("3.8 left") / (ell * rho)
    return expand(left), expand(derived_form("3.8") / (ell * rho))


def lever() -> Expr:
    """Return the factor of mu sigma* in (3.8) over ell rho g R^3, which is lambda (3.14)."""
    _, right = momentum()
    return simplify(-right.coeff(sigma_mean) / (g * R**3) / mu * rho * g * DEPTH)


@cache
def motion(name: str) -> Expr:
    """Return the derived motion from rest under constant a and b: the ``name`` of a function in `dynamics.solution`."""
    from_rest = simplify(dynamics.solution()[name].subs(omega_0, 0))
    return from_rest.subs(Symbol("k", positive=True), sqrt(a * b))


@cache
def dimensional() -> Forms:
    """Return the motion with dimensions (2.21), (3.9), with c2 = sqrt(a b g/R), c0 = sqrt(a/b g/R) and c1 = R c0."""
    clock = sqrt(g / R)
    in_seconds = {t: t * clock, a: c0 * c2 / clock**2, b: c2 / c0}
    angular_velocity, rotation = (
        motion(x).subs(in_seconds, simultaneous=True) for x in ("angular_velocity", "rotation")
    )
    rate = simplify(clock * angular_velocity)
    phi = simplify(rotation)
    velocity = (R * rate).subs(c0, c1 / R)
    return {"omega": rate, "omega*": rate / clock, "phi": phi, "v": velocity, "s": (R * phi).subs(c0, c1 / R)}


def expanded_in_time(motion: Expr) -> tuple[Expr, Expr, Expr]:
    """Return a motion, the first term of its expansion in time, and the order of the second term.

    ``motion`` is an expression in t.
    """
    first, second = islice(motion.series(t, n=None), 2)
    return motion, first, O(second, t)


@cache
def names() -> ValueDict:
    """Return the notation of the transcribed forms: symbols, functions and forms by name."""
    declared = vars(dynamics) | vars(symbols) | globals()
    notation = {x.name: x for x in declared.values() if isinstance(x, Symbol)}
    notation |= {f.__name__: f for f in (sigma, omega_of, mu_of, a_of, b_of, body, body_star)}
    return notation | {
        "lam": LEVER,
        "A": polar / LEVER,
        "gamma": rho * g,
        "f": DEPTH,
        "sigma_ref": rho * g * DEPTH,
        "chord": CHORD,
        "J_r": j_r,
        "J_theta": j_theta,
        "J_r0": j_r.subs(turn, 0),
        "J_theta0": j_theta.subs(turn, 0),
        "phi": dimensional()["phi"],
    }


@cache
def parse_forms(forms: str) -> tuple[Expr, ...]:
    """Return transcribed forms, separated by semicolons, as expressions in the symbols of `names`."""
    return tuple(parse_expr(x.strip(), local_dict=names()) for x in forms.split(";"))
