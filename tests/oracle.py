"""Independent references: ball-arithmetic and mpmath quadrature of the raw definitions, never a closed form under test."""

from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
from flint import acb, arb, ctx, fmpq

Weight = Callable[[acb, acb], acb]

WEIGHTS: dict[str, Weight] = {
    "polar_moment": lambda r, u: r * r,
    "moment_of_inertia": lambda r, u: r * r * r,
    "radial_weight_amplitude": lambda r, u: r * u.cos(),
    "weight_moment_amplitude": lambda r, u: r * r * u.cos(),
}
# Exact for polynomials in r up to degree 3: two-point Gauss-Legendre.
_GAUSS = 2


def exact(x: float) -> arb:
    """The double as a ball of radius zero."""
    ratio = Fraction(float(x))
    return arb(fmpq(ratio.numerator, ratio.denominator))


def moment(name: str, alpha: float | arb, bits: int = 200) -> arb:
    """A base quantity by rigorous quadrature of its double integrand over r and u, as a ball.

    The relative radius is below 2**-150: thin arcs, whose mass is of order alpha**3, get the extra bits they need.
    """
    half = alpha if isinstance(alpha, arb) else exact(alpha)
    thin = max(0, -int(mpmath.log(mpmath.mpf(float(half)), 2))) if float(half) > 0 else 1100
    with ctx.workprec(bits + 4 * thin + 40):
        if name == "resistance_factor":
            return 2 * half * (1 - half.cos())
        if not isinstance(alpha, arb):
            half = exact(alpha)
        weight, root = WEIGHTS[name], 1 / arb(3).sqrt()

        def ring(u: acb, _: bool) -> acb:
            # u = half * x, so that thin arcs integrate over [-1, 1]
            u = u * half
            chord = acb(half).cos() / u.cos()
            middle, reach = (1 + chord) / 2, (1 - chord) / 2
            return reach * (weight(middle + reach * root, u) + weight(middle - reach * root, u))

        scale = half**3
        # Symmetric in u. Integrated over x in [0, 1]; the mass has an integrand of order half**2 there.
        value = acb.integral(lambda x, flag: ring(x, flag) / half**2, 0, 1, rel_tol=arb(2) ** -(bits - 20), abs_tol=arb(2) ** -(bits - 20))
        return (2 * value * scale).real


def ulps(value: float, reference: arb, kind: type = np.float64) -> float:
    """Error in units of the last place of the rounded reference, fractional, against the unrounded reference."""
    rounded = kind(float(reference))
    spacing = np.nextafter(np.abs(rounded), kind(np.inf)) - np.abs(rounded)
    return abs(float((exact(float(value)) - reference) / exact(float(spacing))))
