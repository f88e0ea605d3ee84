"""E = omega^2 of a phase from rest under hyperbolically softening friction, in closed form.

With H = 1/(1 + x/pole), E' + (q + p/(pole + x)) E = 2 (net moment + H load) without the parts that E causes, and
Y = exp(q x) E is the solution of

    (pole + x) Y' + p Y = 2 exp(q x) ((pole + x) net moment + pole load)

Up to a constant w the right-hand side has a power series P as its solution, which converges for all x. The solution
for w has a singularity where friction has its pole, behind the start:

    E = exp(-q x) (P_1 x + P_2 x^2 + ... + w (1 - (1 + x/pole)^-p)/p)

`derive.algebra.phase_plane` derives this solution.
"""

from derive.flow.integrator.one_lane import Lanes, S, V, down, expm1, number, up, where

PAIRS = 10  # of terms of the series
LEAST = 1e-100  # p in place of 0
# Places of further factors of E after q: p, and -w/p before the terms of the series.
EXPONENT = 5
POWER = 8


def hyperbolic_factors(s: Lanes, e: S, drive: V, sine: V, vers: V) -> None:
    """Compute p, -w/p and the power series. Drive, sine and vers are factors of the net moment without load."""
    q = e[4]
    pole = 1.0 / s.per_pole
    p = -2.0 * s.net_loss_square * pole
    e[EXPONENT] = where(p == 0.0, LEAST, p)
    # Coefficients of exp(q x), exp(q x) cos(x) and exp(q x) sin(x), doubled.
    fading: V = 2.0
    even: V = 2.0
    odd: V = 0.0
    before: V = 0.0
    for k in up(0, 2 * PAIRS):
        versine = fading - even
        loaded = s.drive * fading + (s.net_sine * odd + s.net_vers * versine)
        e[POWER + k] = pole * loaded + before
        before = drive * fading + (sine * odd + vers * versine)
        per: V = s.inverse[k + 1]
        of_sine = odd * q + even
        of_cosine = even * q - odd
        fading = fading * q * per
        even = of_cosine * per
        odd = of_sine * per
    higher: V = 0.0
    for k in down(2 * PAIRS, 1):
        rest = e[POWER + k] - number(k + 1) * pole * higher
        higher = rest / (e[EXPONENT] + number(k))
        e[POWER + k] = higher
    weight = e[POWER] - pole * higher
    e[POWER] = weight / -e[EXPONENT]


def hyperbolic_functions(e: S, f: S, x: V, passed: V) -> None:
    """Compute the functions of which E consists at x. ``passed`` is the logarithm of 1 + x/pole."""
    p = e[EXPONENT]
    f[0] = x
    f[1] = 1.0 + expm1(-e[4] * x)
    f[2] = expm1(-p * passed)


def hyperbolic_energy(e: S, f: S) -> V:
    """Return E from its factors and its functions."""
    square = f[0] * f[0]
    even: V = e[POWER + 2 * PAIRS]
    odd: V = e[POWER + 2 * PAIRS - 1]
    for k in down(PAIRS - 1, 1):
        even = even * square + e[POWER + 2 * k]
        odd = odd * square + e[POWER + 2 * k - 1]
    series = f[0] * (odd + f[0] * even)
    return f[1] * (series + e[POWER] * f[2])
