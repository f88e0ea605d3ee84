"""E = omega^2 of a phase from rest under hyperbolically softening friction, in closed form.

With H = 1/(1 + x/pole), E' + (q + p/(pole + x)) E = 2 (net moment + H load) without the parts that E causes, and
Y = exp(q x) E is the solution of

    (pole + x) Y' + p Y = 2 exp(q x) ((pole + x) net moment + pole load)

Up to a constant w the right-hand side has a power series P as its solution, which converges for all x. The solution
for w is singular at the pole of friction, behind the start:

    E = exp(-q x) (P_1 x + P_2 x^2 + ... + w (1 - (1 + x/pole)^-p)/p)

`derive.flow.closed` proves it by substitution. As a function of the distance from the end of a phase E has the same
form with a negative pole.
"""

from derive.flow.integrator.one_lane import Lanes, S, V, down, expm1, number, up, where

HALF = 12  # of the degree of the series
LEAST = 1e-100  # p in place of 0
# Places of further factors of E: p, the load at the start over its factors, pole, -w/p and the terms of the series, and
# drive, sine and vers of the load, and of the net moment without the load.
SHIFT = 5
FIRST = 6
POLE = 7
POWER = 8
LOAD = 33
NET = 36


def expand_right_side(s: Lanes, e: S, drive: V) -> None:
    """Compute the power series of the right-hand side. ``drive`` is the net moment with the load at the beginning."""
    q = e[4]
    sine = e[NET + 1] + e[FIRST] * e[LOAD + 1]
    vers = e[NET + 2] + e[FIRST] * e[LOAD + 2]
    # Coefficients of exp(q x), exp(q x) cos(x) and exp(q x) sin(x), doubled.
    fading: V = 2.0
    even: V = 2.0
    odd: V = 0.0
    before: V = 0.0
    for k in up(0, 2 * HALF):
        versine = fading - even
        whole = drive * fading + (sine * odd + vers * versine)
        e[POWER + k] = e[POLE] * whole + before
        before = e[NET] * fading + (e[NET + 1] * odd + e[NET + 2] * versine)
        of_sine = odd * q + even
        of_cosine = even * q - odd
        fading = fading * q * s.inverse[k + 1]
        even = of_cosine * s.inverse[k + 1]
        odd = of_sine * s.inverse[k + 1]


def hyperbolic_factors(s: Lanes, e: S, q: V, drive: V) -> None:
    """Compute -w/p and the power series. ``drive`` is the net moment with the load at the beginning."""
    e[0] = 2.0 * e[NET]
    e[4] = q
    e[SHIFT] = where(e[SHIFT] == 0.0, LEAST, e[SHIFT])
    expand_right_side(s, e, drive)
    higher: V = 0.0
    for k in down(2 * HALF, 1):
        per = 1.0 / (e[SHIFT] + number(k))
        shrink = number(k + 1) * e[POLE] * per
        higher = e[POWER + k] * per - shrink * higher
        e[POWER + k] = higher
    weight = e[POWER] - e[POLE] * higher
    e[POWER] = -weight / e[SHIFT]


def hyperbolic_energy(e: S, f: S, passed: V) -> V:
    """Return E, and compute x in place 0, where the logarithm of 1 + x/pole is ``passed``."""
    x = e[POLE] * expm1(passed)
    f[0] = x
    square = x * x
    even: V = e[POWER + 2 * HALF]
    odd: V = e[POWER + 2 * HALF - 1]
    for k in down(HALF - 1, 1):
        even = even * square + e[POWER + 2 * k]
        odd = odd * square + e[POWER + 2 * k - 1]
    series = x * (odd + x * even)
    singular = e[POWER] * expm1(-e[SHIFT] * passed)
    return (1.0 + expm1(-e[4] * x)) * (series + singular)
