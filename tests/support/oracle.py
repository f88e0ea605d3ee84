"""Independent references: quadrature of the raw definitions in ball arithmetic, and the equation of motion in mpmath.

Nothing here knows more than the declared weights: no closed form, no stable form, no line of generated text. Arguments
are floats, taken as the exact numbers that they are.
"""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

import mpmath
import numpy as np
import sympy as sp
from flint import acb, arb, ctx, fmpq
from mpmath import mpf

from derive.declare import quantities as declared
from derive.declare.quantities import MOMENTS, RESISTANCE
from derive.declare.symbols import r, theta

BITS = 200  # about 60 digits
# Of each moment its function of alpha, with what the declared weight says: the power of r, and whether cos(u) turns it.
WEIGHTS = {(m.amplitude or (m.name,))[0]: (int(sp.degree(m.weight, r)), m.weight.has(theta)) for m in MOMENTS}
BASE = (*WEIGHTS, RESISTANCE.name)
QUOTIENTS = {q.name: (q.numerator, q.denominator) for q in declared.QUOTIENTS}
WHOLE = {m.name: m.amplitude[0] for m in MOMENTS if m.amplitude}


# --- the moments ---------------------------------------------------------------------------------------------------


def exact(x: float | Fraction) -> arb:
    """The double, or the fraction, as a ball of radius zero (a fraction: of the precision's)."""
    ratio = Fraction(x)
    return arb(fmpq(ratio.numerator, ratio.denominator))


def radians(alpha: Fraction) -> arb:
    """Half the opening angle; the domain ends at pi/2, for which the doubles a little above it stand."""
    return exact(alpha) if exact(alpha) < arb.pi() / 2 else arb.pi() / 2


@cache
def over_cube(name: str, alpha: Fraction) -> arb:
    """A base quantity over alpha**3, by rigorous quadrature over r and u of its double integrand, 0 < alpha.

    The exact inner rule is Gauss-Legendre's with three points, for up to the fifth power of r. The outer variable
    is x = u/alpha. Over a thin arc 1 - chord is of order alpha**2, and gets the extra bits for that.
    """
    thin = max(0, alpha.denominator.bit_length() - alpha.numerator.bit_length())
    with ctx.workprec(BITS + 40 + 4 * thin):
        half = radians(alpha)
        if name == RESISTANCE.name:
            value = 2 * half * (1 - half.cos()) / half**3
        else:
            (power, turned), root = WEIGHTS[name], (arb(3) / 5).sqrt()
            disc = half.cos().contains(0)

            def ring(x: acb, _: bool) -> acb:
                u = x * half
                chord = acb(0) if disc else half.cos() / u.cos()
                middle, reach = (1 + chord) / 2, (1 - chord) / 2
                outer = (middle + reach * root) ** power + (middle - reach * root) ** power
                return reach * (5 * outer + 8 * middle**power) / 9 * (u.cos() if turned else 1) / half**2

            tolerance = arb(2) ** -(BITS - 20)
            value = 2 * acb.integral(ring, 0, 1, rel_tol=tolerance, abs_tol=tolerance).real
        assert value.rel_accuracy_bits() > 166, f"{name}({float(alpha)}): {value}"
        return value


def kernel(name: str, alpha: float | Fraction) -> arb:
    """A base quantity or a quotient of two, at least 50 digits."""
    half = Fraction(alpha)
    with ctx.workprec(BITS + 40):
        if name in QUOTIENTS:
            above, below = QUOTIENTS[name]
            tiny = max(half, Fraction(1, 2**250))  # at 0 the limit, which is near enough: alpha**2 is 2**-500
            return over_cube(above, tiny) / over_cube(below, tiny)
        return over_cube(name, half) * radians(half) ** 3 if half else arb(0)


def whole(name: str, theta_1: float, theta_2: float) -> tuple[arb, arb]:
    """A moment of the exact two angles, such as J_r, and its amplitude: of theta_m + u the part even in u is left."""
    half, middle = (Fraction(theta_2) - Fraction(theta_1)) / 2, (Fraction(theta_1) + Fraction(theta_2)) / 2
    amplitude = kernel(WHOLE[name], half)
    with ctx.workprec(BITS + 1100):  # of an angle near a multiple of pi/2, all that is left
        (weight,) = [m.weight for m in MOMENTS if m.name == name]
        direction = exact(middle).sin() if weight.has(sp.sin) else exact(middle).cos()
    with ctx.workprec(BITS + 40):
        return (-1 if weight.could_extract_minus_sign() else 1) * amplitude * direction, amplitude


def limit_friction(theta_1: float, theta_2: float) -> arb:
    """J_theta/J_r."""
    (moment, _), (radial, _) = (whole(name, theta_1, theta_2) for name in ("weight_moment", "radial_weight"))
    with ctx.workprec(BITS + 40):
        return moment / radial


def ulps(value: float, reference: arb, size: arb | None = None, kind: type[np.floating] = np.float64) -> float:
    """Error in units of the last place, fractional, against the unrounded reference.

    The unit is that of the reference rounded to the format, or of another number; denormal spacing where they
    underflow. A value that is not finite is infinitely wrong.
    """
    if not np.isfinite(value):
        return float("inf")
    with ctx.workprec(2400):
        unit = np.spacing(kind(abs(float(reference if size is None else size))))
        return abs(float((exact(float(value)) - reference) / exact(float(unit))))


def moments(arc: Mapping[str, float]) -> dict[str, arb]:
    """C_theta, C_r, I_p*, lambda over Theta*, Theta*, and the reference stress, of the exact doubles of the arc."""
    half = (Fraction(arc["theta_2"]) - Fraction(arc["theta_1"])) / 2
    middle = (Fraction(arc["theta_1"]) + Fraction(arc["theta_2"])) / 2
    inertia = kernel("moment_of_inertia", half)
    depth = exact(arc["radius"]) * 2 * (exact(half) / 2).sin() ** 2
    return {
        "fall": kernel("weight_moment_per_inertia", half),
        "press": kernel("radial_weight_per_inertia", half),
        "polar": kernel("polar_moment_per_inertia", half),
        "level": kernel("resistance_factor", half) / inertia,
        "inertia": inertia,
        "reference_stress": exact(arc["unit_weight"]) * depth,
        "dip": abs(3 * arb.pi() / 2 - exact(middle)),  # positive is down-slope, for either facing
        "half_angle": exact(half),
    }


def plain(arc: Any) -> dict[str, float]:
    """The fields of an `Arc`."""
    fields = ("radius", "theta_1", "theta_2", "unit_weight", "gravity")
    return {name: float(np.asarray(getattr(arc, name))) for name in fields}


def numbers(arc: Any) -> dict[str, mpf]:
    """`moments` of an `Arc` as mpmath's numbers of 50 digits, with its radius and its unit of time."""
    given = plain(arc)
    with ctx.workprec(BITS), mpmath.workdps(50):
        found = {k: mpf(v.mid().str(50, radius=False)) for k, v in moments(given).items()}
        radius, gravity = mpf(given["radius"]), mpf(given["gravity"])
        return found | {"radius": radius, "scale": mpmath.sqrt(radius / gravity)}


# --- the motion ----------------------------------------------------------------------------------------------------


class Reference(NamedTuple):
    """A value, and the sum of |x df/dx| over the arguments: |value| times the condition number."""

    value: mpf
    sensitivity: mpf


def waves(a: mpf, b: mpf, t: mpf) -> tuple[mpf, mpf]:
    """The two solutions of y'' = a b y with (y, y') = (1, 0) and (0, 1) at t = 0."""
    k = mpmath.sqrt(abs(a * b))
    if k == 0:
        return mpf(1), t
    return (mpmath.cosh(k * t), mpmath.sinh(k * t) / k) if a * b > 0 else (mpmath.cos(k * t), mpmath.sin(k * t) / k)


def alive(a: mpf, b: mpf, omega_0: mpf, t: mpf) -> bool:
    """Whether the solution reaches t: y, which starts at 1, has not crossed zero."""
    c, s = waves(a, b, t)
    return bool(c + b * omega_0 * s > 0) and not (a * b < 0 and mpmath.sqrt(-a * b) * t >= mpmath.pi)


def angular_velocity(a: mpf, b: mpf, omega_0: mpf, t: mpf) -> mpf:
    """omega = y'/(b y), the Riccati equation made linear."""
    c, s = waves(a, b, t)
    return (omega_0 * c + a * s) / (c + b * omega_0 * s)


def rotation(a: mpf, b: mpf, omega_0: mpf, t: mpf) -> mpf:
    """The integral of omega, ln(y)/b."""
    if b == 0:
        return omega_0 * t + a * t**2 / 2
    c, s = waves(a, b, t)
    return mpmath.log(c + b * omega_0 * s) / b


def angular_acceleration(a: mpf, b: mpf, omega_0: mpf, t: mpf) -> mpf:
    """The equation of motion itself, as its solution solves it: a - b omega**2, and (a - b omega_0**2)/y**2."""
    c, s = waves(a, b, t)
    return (a - b * omega_0**2) / (c + b * omega_0 * s) ** 2


def arrest_time(a: mpf, b: mpf, omega_0: mpf) -> mpf:
    """The integral of d(omega)/(-a + b omega**2) from 0 to omega_0."""
    if b == 0:
        return omega_0 / -a
    k = mpmath.sqrt(-a * b)
    return mpmath.acot(k / (b * omega_0)) / k if omega_0 else mpf(0)


def arrest_rotation(a: mpf, b: mpf, omega_0: mpf) -> mpf:
    """The integral of omega d(omega)/(-a + b omega**2) from 0 to omega_0."""
    if b == 0:
        return omega_0**2 / (-2 * a)
    return (mpmath.log(b * omega_0**2 - a) - mpmath.log(-a)) / (2 * b)


MOTION: dict[str, Callable[..., mpf]] = {
    "frozen_angular_velocity": angular_velocity,
    "frozen_rotation": rotation,
    "frozen_angular_acceleration": angular_acceleration,
    "frozen_arrest_time": arrest_time,
    "frozen_arrest_rotation": arrest_rotation,
}
_STEP = mpf(2) ** -90  # relative, for the derivatives: 27 digits


@cache
def motion(name: str, *arguments: float) -> Reference | None:
    """A motion formula at exact arguments to 30 digits, with its conditioning; None after the solution has ended.

    The working precision grows until two of them agree.
    """
    function = MOTION[name]
    previous: Reference | None = None
    # Small arguments cost as many digits as their product is below 1: log(1 + tiny). None is silently lost.
    start = 120 + sum(int(2 * abs(np.log10(abs(x)))) for x in arguments if x)
    for digits in (start, 2 * start, 4 * start, 8 * start, 16 * start):
        with mpmath.workdps(digits):
            x = [mpf(v) for v in arguments]
            if function in (angular_velocity, rotation, angular_acceleration) and not alive(*x):
                return None
            value = function(*x)
            moved = (function(*x[:i], v * (1 + _STEP), *x[i + 1 :]) for i, v in enumerate(x) if v)
            found = Reference(value, mpmath.fsum(abs(m - value) for m in moved) / _STEP)
            if previous is not None and all(
                abs(new - old) <= abs(new) * mpf(10) ** -p for new, old, p in zip(found, previous, (30, 3), strict=True)
            ):
                return found
            previous = found
    raise ArithmeticError(f"{name}{arguments}: no 30 digits")


MOTION_BOUND = 8.0  # ulp times (1 + condition number)


def motion_error(value: float, reference: Reference) -> float:
    """Error in ulp over (1 + condition number); where the reference is 0, in eps times its sensitivity."""
    if not np.isfinite(value):
        return float("inf")
    with mpmath.workdps(60):
        error = abs(mpf(float(value)) - reference.value)
        if error == 0:
            return 0.0
        unit = mpf(float(np.spacing(abs(float(reference.value)))))
        if reference.value == 0:
            return float(error / max(unit, reference.sensitivity * mpf(2) ** -52))
        return float(error / (unit * (1 + reference.sensitivity / abs(reference.value))))
