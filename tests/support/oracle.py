"""Independent references: quadrature of the raw definitions in ball arithmetic.

Nothing here knows more than the declared weights: no closed form, no stable form, no line of generated text. Arguments
are floats, taken as the exact numbers that they are.
"""

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

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
    """Return the double, or the fraction, as a ball of radius zero (a fraction: of the precision's)."""
    ratio = Fraction(x)
    return arb(fmpq(ratio.numerator, ratio.denominator))


def radians(alpha: Fraction) -> arb:
    """Half the opening angle; the domain ends at pi/2, for which the doubles a little above it stand."""
    return exact(alpha) if exact(alpha) < arb.pi() / 2 else arb.pi() / 2


@cache
def over_cube(name: str, alpha: Fraction) -> arb:
    """Return a base quantity over alpha**3, by rigorous quadrature over r and u of its double integrand, 0 < alpha.

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
            cosine = half.cos()
            disc = cosine.contains(0)

            def ring(x: acb, _: bool) -> acb:
                across = (x * half).cos()
                chord = acb(0) if disc else cosine / across
                middle, reach = (1 + chord) / 2, (1 - chord) / 2
                outer = (middle + reach * root) ** power + (middle - reach * root) ** power
                depth = reach * (5 * outer + 8 * middle**power)
                return depth * across if turned else depth

            tolerance = arb(2) ** -(BITS - 20)
            value = 2 * acb.integral(ring, 0, 1, rel_tol=tolerance, abs_tol=tolerance * half**2).real / (9 * half**2)
        assert value.rel_accuracy_bits() > 166, f"{name}({float(alpha)}): {value}"
        return value


def kernel(name: str, alpha: float | Fraction) -> arb:
    """Return a base quantity or a quotient of two, at least 50 digits."""
    half = Fraction(alpha)
    with ctx.workprec(BITS + 40):
        if name in QUOTIENTS:
            above, below = QUOTIENTS[name]
            tiny = max(half, Fraction(1, 2**250))  # at 0 the limit, which is near enough: alpha**2 is 2**-500
            return over_cube(above, tiny) / over_cube(below, tiny)
        return over_cube(name, half) * radians(half) ** 3 if half else arb(0)


def whole(name: str, theta_1: float, theta_2: float) -> tuple[arb, arb]:
    """Return a moment of the two exact angles, such as J_r, and its amplitude (only the part even in u contributes)."""
    half, middle = (Fraction(theta_2) - Fraction(theta_1)) / 2, (Fraction(theta_1) + Fraction(theta_2)) / 2
    amplitude = kernel(WHOLE[name], half)
    with ctx.workprec(BITS + 1100):  # of an angle near a multiple of pi/2, all that is left
        (weight,) = [m.weight for m in MOMENTS if m.name == name]
        direction = exact(middle).sin() if weight.has(sp.sin) else exact(middle).cos()
    with ctx.workprec(BITS + 40):
        return (-1 if weight.could_extract_minus_sign() else 1) * amplitude * direction, amplitude


def limit_friction(theta_1: float, theta_2: float) -> arb:
    """Return the limit friction J_theta/J_r."""
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
    """Return the fields of an `Arc`."""
    fields = ("radius", "theta_1", "theta_2", "unit_weight", "gravity")
    return {name: float(np.asarray(getattr(arc, name))) for name in fields}


def numbers(arc: Any) -> dict[str, mpf]:
    """`moments` of an `Arc` as mpmath's numbers of 50 digits, with its radius and its unit of time."""
    given = plain(arc)
    with ctx.workprec(BITS), mpmath.workdps(50):
        found = {k: mpf(v.mid().str(50, radius=False)) for k, v in moments(given).items()}
        radius, gravity = mpf(given["radius"]), mpf(given["gravity"])
        return found | {"radius": radius, "scale": mpmath.sqrt(radius / gravity)}
