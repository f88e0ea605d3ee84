"""Swings of many lanes at once: E = omega**2 in the phase plane from one standstill to the next, as arrays.

A swing starts at rest, and nothing but the drive moves it: E' = 2 (S cos x - B sin x - K) - q E with S = drive +
constant, B = tilt, K = constant and q = 2 brake, so that E/x is a power series whose terms the equation itself gives,
one from the other. All lanes take the same steps; what a lane's own numbers show not to have converged is not `good`.
"""

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.courses import Start

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
TERMS = 24  # of the power series: enough for swings of 2 rad, and for q x up to 2
_FEW = 12  # terms of the first steps towards a zero
_POINTS = ((1e-5, 8), (1e-8, 12), (0.0, 16))  # of the quadrature, by the accuracy asked for


class Swing(NamedTuple):
    """Swings, dimensionless: where they end and are fastest, the times to there, and E and -E' that go with them.

    ``missing`` is what the quadrature leaves out of a time, relative; where not ``good`` the rest means nothing.
    """

    end: Floats
    duration: Floats
    peak: Floats
    top: Floats
    peak_time: Floats
    steep: Floats
    missing: Floats
    good: Mask


def workspace(lanes: int) -> Floats:
    """Scratch memory for swings of up to so many lanes."""
    return np.empty((2, TERMS, lanes))


@cache
def _rule(points: int) -> tuple[Floats, Floats]:
    """Powers of sin(s)**2 at the midpoints of [0, pi/2], and what makes a cosine series in 2 s of values there.

    The midpoint rule is exponentially accurate for functions of sin(s)**2 (Gauss and Chebyshev's rule in sin(s)**2).
    """
    s = (np.arange(points) + 0.5) * (np.pi / 2 / points)
    series = np.cos(2 * np.arange(points)[:, None] * s) * (2.0 / points)
    series[0] /= 2.0
    return np.sin(s)[:, None] ** (2 * np.arange(TERMS - 1)), series


def points(accuracy: float) -> int:
    """Points of the quadrature that an accuracy takes for swings of up to a radian; others are refined."""
    return next(n for least, n in _POINTS if accuracy >= least)


def _series(drive: Floats, tilt: Floats, constant: Floats, brake: Floats, work: Floats) -> tuple[Floats, Floats]:
    """Coefficients of E' and of E/x as power series in x."""
    slope, energy = work[:, :, : drive.size]
    np.multiply(drive, 2.0, out=slope[0])
    energy[0] = slope[0]
    turning, held = (drive + constant, tilt), 2.0 * brake
    for k in range(1, TERMS):  # cos x and -sin x have the coefficients 1, -1, -1, 1, 1, ... over k!
        sign = -2.0 if k % 4 in (1, 2) else 2.0
        np.multiply(held, energy[k - 1], out=energy[k])
        np.multiply(turning[k % 2], sign / math.factorial(k), out=slope[k])
        slope[k] -= energy[k]
        np.multiply(slope[k], 1.0 / (k + 1), out=energy[k])
    return slope, energy


def _halley(series: Floats, x: Floats) -> tuple[Floats, Floats, Floats]:
    """One step of Halley's towards a zero of a power series: the next x, the step's error over x, and the slope."""
    value, slope, bend = series[-2] + x * series[-1], series[-1].copy(), np.zeros_like(x)
    for c in series[-3::-1]:
        bend *= x
        bend += slope
        slope *= x
        slope += value
        value *= x
        value += c
    step = value / slope
    bend *= step
    bend /= slope  # half the second derivative is what the loop gives
    following = x - step / np.maximum(1.0 - bend, 0.5)
    step /= x
    return following, np.abs(step) * (4 * bend * bend + step * step), slope


def swing(begin: Start, accuracy: float, work: Floats) -> Swing:
    """Solve swings that start at rest with a positive drive.

    Parameters
    ----------
    begin : Start
        Where they begin, with E = 0.
    accuracy : float
        Relative error that the times may have.
    work : ndarray
        Scratch, from `workspace`; new memory in every call costs more than the arithmetic.
    """
    _, drive, tilt, constant, brake, furthest = begin
    slope, energy = _series(drive, tilt, constant, brake, work)
    # A pendulum swings to both sides of where its drive is zero alike; a brake q takes q m**2/3 off the half m.
    half = np.arctan2(drive, tilt)
    half *= 2.0 / (1.0 + np.sqrt(1.0 + (8.0 / 3.0) * (brake * half)))
    end = 2.0 * half
    for terms in (_FEW, _FEW, TERMS):
        end, wrong, fall = _halley(energy[:terms], end)
    peak = half - (brake / 3.0) * (half * half)
    for terms in (_FEW, _FEW, TERMS):
        peak, missed, _ = _halley(slope[:terms], peak)
    top = energy[-1] * peak
    for c in energy[-2:0:-1]:
        top += c
        top *= peak
    top += energy[0]
    top *= peak
    # E = x (end - x) Q(x/end): Q's coefficients are sums from the last term on, so that no digit is lost.
    power = np.ones_like(end)
    for k in range(2, TERMS):
        power *= end
        energy[k] *= power
    last = np.abs(energy[-1]) + np.abs(energy[-2])
    for k in range(TERMS - 2, 0, -1):
        energy[k] += energy[k + 1]
    rest = -energy[1:]
    good = (wrong <= 6e-17) & (missed <= 6e-17) & (last <= 1e-16 * rest[0]) & (end > 0.0) & (end < furthest)
    good &= (peak > 0.0) & (peak < end) & (fall < 0.0)
    if np.any(constant < 0.0):  # see `Courses._peak`
        tilted = (drive + constant) * np.sin(end) + tilt * np.cos(end)
        good &= (constant >= 0.0) | ((tilt >= 0.0) & (tilted >= 0.0))
    duration, peak_time, missing = _times(rest, peak / end, points(accuracy))
    late = good & (missing > 0.1 * accuracy)
    if np.any(late):
        more = _times(rest[:, late], (peak / end)[late], 40)
        duration[late], peak_time[late], missing[late] = more
        good &= missing <= max(0.1 * accuracy, 1e-14)
    return Swing(end, duration, peak, top, peak_time, -fall * end, missing, good)


def _times(rest: Floats, share: Floats, points: int) -> tuple[Floats, Floats, Floats]:
    """Times to the end and to a share of the way, and what is missing of them, relative.

    With x = end sin(s)**2 the time is the integral of 2/sqrt(Q) ds, as a cosine series, integrated term by term.
    """
    powers, series = _rule(points)
    rate = powers @ rest
    np.sqrt(rate, out=rate)
    np.divide(2.0, rate, out=rate)
    terms = series @ rate
    missing = (np.abs(terms[-1]) + np.abs(terms[-2])) / terms[0]
    twice = 2.0 - 4.0 * share  # 2 cos(2 s)
    one, two = terms[-1] / (2 * points - 2), np.zeros_like(share)
    for k in range(points - 2, 0, -1):  # Clenshaw's recurrence
        one, two = terms[k] / (2 * k) + twice * one - two, one
    part = terms[0] * np.arcsin(np.sqrt(share)) + one * (2.0 * np.sqrt(share * (1.0 - share)))
    return terms[0] * (np.pi / 2), part, missing
