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


def growth(a: arb, b: arb, omega_0: arb, t: arb) -> tuple[arb, arb, arb]:
    """Of y'' = a b y with y(0) = 1 and y'(0) = b omega_0, without their common factor: y, y'/b, and its logarithm.

    The factor is exp(k t)/2 with k**2 = a b > 0, else 1.
    """
    k = abs(a * b).sqrt()
    if k == 0:
        return 1 + b * omega_0 * t, omega_0 + a * t, arb(0)
    if a * b > 0:
        q = (-2 * k * t).exp()
        c, s, factor = 1 + q, (1 - q) / k, k * t - arb(2).log()
    else:
        c, s, factor = (k * t).cos(), (k * t).sin() / k, arb(0)
    return c + b * omega_0 * s, omega_0 * c + a * s, factor


def alive(a: arb, b: arb, omega_0: arb, t: arb) -> bool | None:
    """Whether the solution reaches t: y, which starts at 1, has not crossed zero; None if more digits must say."""
    if a * b < 0 and (-a * b).sqrt() * t >= arb.pi():
        return False
    y, _, _ = growth(a, b, omega_0, t)
    return True if y > 0 else False if y <= 0 else None


def angular_velocity(a: arb, b: arb, omega_0: arb, t: arb) -> arb:
    """omega = y'/(b y), the Riccati equation made linear."""
    y, slope, _ = growth(a, b, omega_0, t)
    return slope / y


def rotation(a: arb, b: arb, omega_0: arb, t: arb) -> arb:
    """The integral of omega, ln(y)/b."""
    if b == 0:
        return omega_0 * t + a * t**2 / 2
    y, _, factor = growth(a, b, omega_0, t)
    return (factor + y.log()) / b


def angular_acceleration(a: arb, b: arb, omega_0: arb, t: arb) -> arb:
    """The equation of motion itself, as its solution solves it: a - b omega**2, and (a - b omega_0**2)/y**2."""
    y, _, factor = growth(a, b, omega_0, t)
    return (a - b * omega_0**2) * (-2 * factor).exp() / y**2


def arrest_time(a: arb, b: arb, omega_0: arb) -> arb:
    """The integral of d(omega)/(-a + b omega**2) from 0 to omega_0."""
    if b == 0:
        return omega_0 / -a
    k = (-a * b).sqrt() if a * b < 0 else (a * b).sqrt()
    return arb.atan(b * omega_0 / k) / k if a * b < 0 else arb.atanh(b * omega_0 / k) / -k


def arrest_rotation(a: arb, b: arb, omega_0: arb) -> arb:
    """The integral of omega d(omega)/(-a + b omega**2) from 0 to omega_0."""
    if b == 0:
        return omega_0**2 / (-2 * a)
    return (1 - b * omega_0**2 / a).log() / (2 * b)


MOTION: dict[str, Callable[..., arb]] = {
    "frozen_angular_velocity": angular_velocity,
    "frozen_rotation": rotation,
    "frozen_angular_acceleration": angular_acceleration,
    "frozen_arrest_time": arrest_time,
    "frozen_arrest_rotation": arrest_rotation,
}
_STEP = arb(2) ** -90  # relative, for the derivatives: 27 digits


def digits_of(ball: arb) -> mpf:
    """The middle of a ball as mpmath's number of 50 digits."""
    mantissa, exponent = ball.mid().man_exp()
    with mpmath.workdps(50):
        return mpmath.ldexp(mpf(int(mantissa)), int(exponent))


@cache
def motion(name: str, *arguments: float) -> Reference | None:
    """A motion formula at exact arguments to 30 digits, with its conditioning; None after the solution has ended.

    The working precision grows until the balls are as small as that, or nothing beside the smallest double.
    """
    function = MOTION[name]
    for bits in (2**k for k in range(9, 17)):
        with ctx.workprec(bits):
            x = [exact(v) for v in arguments]
            lives = "arrest" in name or alive(*x)
            if lives is False:
                return None
            value = function(*x)
            moved = [function(*x[:i], v * (1 + _STEP), *x[i + 1 :]) for i, v in enumerate(x) if v != 0]
            sensitivity = sum((abs(m - value) for m in moved), arb(0)) / _STEP
            size = abs(value.mid())
            small = max(size * arb(2) ** -105, arb(2) ** -1300)
            if lives and value.rad() <= small and sensitivity.rad() <= max((size + sensitivity.mid()) / 1000, small):
                return Reference(digits_of(value), digits_of(sensitivity))
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
