"""Polynomials in the time of a step, of many lanes at once: values, roots, and the radius of convergence they suggest.

Coefficients have the shape (order + 1, lanes). The compiled integrator has the same functions under `polynomials` in
``_flow.c``, rounding apart, so that both take the same steps.
"""

from typing import Any

import numpy as np

from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats

MOST_ITERATIONS = 200
LAST_STEP = 2.0**-30  # of Newton's method, relative


def value(series: Floats, at: Any) -> Floats:
    """The value at a time, by Horner's scheme."""
    total = series[-1] + 0.0 * np.asarray(at)
    for coefficient in series[-2::-1]:
        total *= at
        total += coefficient
    return total


def value_and_slope(series: Floats, at: Floats) -> tuple[Floats, Floats]:
    """The value and the derivative at a time."""
    total = series[-1].copy()
    slope = np.zeros_like(at)
    for coefficient in series[-2::-1]:
        slope = slope * at + total
        total = total * at + coefficient
    return total, slope


def increment(series: Floats, at: Any) -> Floats:
    """The value less the constant term, without cancellation."""
    return at * value(series[1:], at)


def derivative(series: Floats) -> Floats:
    """The coefficients of the derivative."""
    powers = np.arange(1.0, len(series))
    return series[1:] * powers[:, None]


def shifted(series: Floats, by: Floats) -> Floats:
    """The same polynomial about another point: Taylor's shift by Horner's scheme."""
    coefficients = np.array(series, dtype=np.float64)
    degree = len(coefficients) - 1
    for lowest in range(degree):
        for power in reversed(range(lowest, degree)):
            coefficients[power] += by * coefficients[power + 1]
    return coefficients


def divided_by_time(series: Floats, where: Any) -> Floats:
    """Divided by the time in some lanes, which removes a root at time 0."""
    if not np.any(where):
        return series
    lowered = np.zeros_like(series)
    lowered[:-1] = series[1:]
    return np.where(where, lowered, series)


def first_root(series: Floats, h: Floats) -> Floats:
    """The first zero in (0, h] of polynomials that are positive at first; infinity where there is none.

    Within a step the terms fall like exp(-2 k): a polynomial that neither has changed its sign at h nor falls at first
    and rises at last has no root there. Where it falls and rises, its least value decides.
    """
    last, slope = value_and_slope(series, h)
    end = h.copy()
    ends_at_zero = (last == 0.0) & (series[0] > 0.0)  # a polynomial that is zero has no root
    crosses = (last < 0.0) | ends_at_zero
    falls_and_rises = (series[1] < 0.0) & (slope > 0.0)
    dips = np.flatnonzero(falls_and_rises & ~crosses)
    if dips.size:
        dipping = series[:, dips]
        end[dips], least = _lowest(dipping, h[dips])
        crosses[dips] = least < 0.0
    root = np.full(h.shape, np.inf)
    if np.any(crosses):
        crossing = series[:, crosses]
        bound = end[crosses]
        start = np.zeros_like(bound)
        root[crosses] = bracketed_root(crossing, start, bound)
    return root


def _lowest(series: Floats, h: Floats) -> tuple[Floats, Floats]:
    """Minimum of polynomials that fall at first and rise at h: its place and value, 0 within rounding.

    A polynomial that only touches zero does not cross it.
    """
    start = np.zeros_like(h)
    lowest = bracketed_root(derivative(series), start, h)
    least = value(series, lowest)
    size = value(np.abs(series), h)
    rounding = 4 * EPS * size
    return lowest, np.where(least < -rounding, least, 0.0)


def bracketed_root(series: Floats, low: Floats, high: Floats) -> Floats:
    """A root between bounds at which values have opposite signs, by Newton's method.

    It starts where the chord crosses zero and halves where a step leaves the bounds. A step below 2^-30 of its place is
    the last, as the next one would be below rounding.
    """
    at_low = value(series, low)
    at_high = value(series, high)
    falls = at_low > 0.0
    change = at_low - at_high
    share = at_low / change
    chord = low + (high - low) * share
    root = _inside_or_middle(chord, low, high)
    active = np.ones(root.shape, dtype=bool)
    for _ in range(MOST_ITERATIONS):
        residual, slope = value_and_slope(series, root)
        beyond = (residual > 0.0) ^ falls
        low = np.where(beyond, low, root)
        high = np.where(beyond, root, high)
        newton = root - residual / slope
        next_root = _inside_or_middle(newton, low, high)
        next_root = np.where(residual == 0.0, root, next_root)
        step = np.abs(next_root - root)
        root = np.where(active, next_root, root)
        least_step = LAST_STEP * np.abs(next_root)
        active &= step > least_step
        if not np.any(active):
            break
    return root


def _inside_or_middle(place: Floats, low: Floats, high: Floats) -> Floats:
    """A value if it lies between two bounds, otherwise their midpoint."""
    inside = (place >= low) & (place <= high)
    middle = 0.5 * (low + high)
    return np.where(inside, place, middle)


# --- the radius of convergence ---------------------------------------------------------------------------------------

COMPARED = 5  # coefficients at the start that the last ones are compared with
LAST = 4  # coefficients at the end
FIXED_POINT = 2.0**40
LARGEST = 1000.0  # log2 of a radius


def radius_of_convergence(series: Floats, order: Floats) -> Floats:
    """Least radius estimated from any of the last four coefficients and the largest of the first five.

    |c_k/c_n|^(1/(n - k)), k < 5, n the last four orders of a lane; 2^1000 where these are zero.
    """
    first = series[:COMPARED]
    comparable = np.any(first != 0.0, axis=0)
    log_first = _log2(first)
    powers = np.arange(COMPARED)
    log_radius = np.full(order.shape, LARGEST)
    lowest_order = int(order.min()) - LAST + 1
    for n in range(max(COMPARED, lowest_order), len(series)):
        last = series[n]
        log_ratio = log_first - _log2(last)
        per_order = 1.0 / (n - powers)
        log_radii = log_ratio * per_order[:, None]
        suggested = log_radii.max(axis=0)
        among_last = (order >= n) & (order < n + LAST)
        counts = among_last & comparable & (last != 0.0)
        suggested[~counts] = LARGEST
        log_radius = np.minimum(log_radius, suggested)
    return _power_of_two(log_radius)


def _log2(x: Floats) -> Floats:
    """log2 |x|, linear between powers of two as in C: up to 0.09 too small, a hundredth of the radius."""
    bits = np.abs(x).view(np.int64) >> 12
    return np.asarray(bits / FIXED_POINT - 1023.0)


def _power_of_two(y: Floats) -> Floats:
    """The inverse of `_log2`."""
    bounded = np.clip(y, -LARGEST, LARGEST)
    bits = np.rint((bounded + 1023.0) * FIXED_POINT)
    pattern = bits.astype(np.int64) << 12
    return pattern.view(np.float64)
