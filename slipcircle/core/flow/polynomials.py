"""Polynomials of many lanes at once, as a step of the flow needs them: coefficients of shape (order + 1, lanes)."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def value(series: Floats, at: Any) -> Floats:
    """By Horner's scheme."""
    found = series[-1] + 0.0 * np.asarray(at)
    for c in series[-2::-1]:
        found *= at
        found += c
    return found


def increment(series: Floats, at: Any) -> Floats:
    """What is beyond the constant term, so that a small change keeps its digits."""
    return at * value(series[1:], at)


def slopes(series: Floats) -> Floats:
    """The coefficients of the derivative."""
    return series[1:] * np.arange(1.0, len(series))[:, None]


def shifted(series: Floats, by: Floats) -> Floats:
    """The same polynomial about another point: Taylor's shift by Horner's scheme."""
    found = np.array(series, dtype=np.float64)
    for first in range(len(found) - 1):
        for k in range(len(found) - 2, first - 1, -1):
            found[k] += by * found[k + 1]
    return found


def divided(series: Floats, now: Any) -> Floats:
    """Divided by the time, where a root that is now is not to be found again."""
    return np.where(now, np.vstack([series[1:], 0.0 * series[:1]]), series) if np.any(now) else series


def first_root(series: Floats, h: Floats) -> Floats:
    """Where polynomials that are positive at first pass zero in (0, h]; infinity where they do not.

    Within a step the terms fall like exp(-2 k), so a polynomial that neither has changed sign at h nor falls at first
    and rises at last has no root there; where it falls and rises, its least value decides.
    """
    scaled, power = series.copy(), np.ones_like(h)
    for c in scaled[1:]:  # on [0, 1]
        power *= h
        c *= power
    last = scaled.sum(axis=0)
    crosses = (last < 0.0) | ((last == 0.0) & (scaled[0] > 0.0))  # what is nothing has none
    dips = ~crosses & (scaled[1] < 0.0) & (np.einsum("k,kl->l", np.arange(len(scaled)), scaled) > 0.0)
    found = np.full(h.shape, np.inf)
    upper = np.ones_like(h)
    if np.any(dips):
        k = np.flatnonzero(dips)
        lowest = bracketed(-slopes(scaled[:, k]), np.zeros(k.size), np.ones(k.size))
        noise = 2.0**-50 * np.abs(scaled[:, k]).sum(axis=0)  # what only touches does not cross
        below = value(scaled[:, k], lowest) < -noise
        upper[k[below]] = lowest[below]
        crosses[k[below]] = True
    k = np.flatnonzero(crosses)
    if k.size:
        found[k] = bracketed(scaled[:, k], np.zeros(k.size), upper[k]) * h[k]
    return found


def bracketed(series: Floats, low: Floats, high: Floats) -> Floats:
    """Newton's method between bounds, from a value above zero at the lower to one at most zero at the upper.

    It starts at the end with the smaller value and falls back to halving where a step would leave the bounds.
    """
    both = np.zeros((len(series), 2, *low.shape))  # and its derivative, at once
    both[:, 0], both[:-1, 1] = series, slopes(series)
    at_low, at_high = value(series, np.stack([low, high]))
    at = np.where(np.abs(at_low) < np.abs(at_high), low, high)
    going = np.ones(at.shape, dtype=bool)
    for _ in range(200):
        f, df = value(both, at)
        low, high = np.where(f > 0.0, at, low), np.where(f > 0.0, high, at)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            next_ = at - f / df
        inside = (next_ > low) & (next_ < high)
        next_ = np.where(inside, next_, 0.5 * (low + high))
        next_ = np.where(f == 0.0, at, next_)
        moved = np.abs(next_ - at) > 2.0**-53 * np.abs(next_)
        at, going = np.where(going, next_, at), going & moved
        if not np.any(going):
            break
    return np.asarray(at)
