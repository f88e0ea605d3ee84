"""Swings of many lanes at once: E = omega**2 in the phase plane from one standstill to the next, as arrays.

Nothing but the drive moves the mass: E' = 2 (S cos x - B sin x - K) - q E with S = drive + constant, B = tilt, K =
constant and q = 2 brake, so that E is a power series in x whose terms the equation itself gives, one from the other.
A mass that starts with velocity is taken back to the standstill that it would have come from. All lanes take the same
steps; what a lane's own numbers show not to have converged is not `good`.
"""

import math
from functools import cache

import numpy as np
from numpy.typing import NDArray

from slipcircle.arrays.courses import Start

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
TERMS = 24  # of the power series: enough for swings of 2 rad, and for q x up to 2
_FEW = 12  # terms of the first step towards a zero
_EXACT = 6e-17  # relative error of a zero that the last step leaves
_POINTS = ((1e-4, 6), (1e-10, 8), (1e-13, 12), (0.0, 16))  # of the quadrature, by the accuracy asked for
_REFINED = (16, 24, 48)  # where these do not resolve the time
_INSIDE = 24  # for places inside a swing
_STRIP = 8192  # values in one product of matrices: more would start BLAS's own threads


def workspace(lanes: int) -> Floats:
    """Scratch memory for swings of up to so many lanes: new memory every time costs more than the arithmetic."""
    return np.empty((2, TERMS, lanes))


@cache
def _rule(points: int) -> tuple[Floats, Floats]:
    """Powers of sin(s)**2 at the midpoints of [0, pi/2], negative, and what makes a cosine series of values there.

    The midpoint rule is exponentially accurate for functions of sin(s)**2 (Gauss and Chebyshev's rule in sin(s)**2).
    """
    s = (np.arange(points) + 0.5) * (np.pi / 2 / points)
    series = np.cos(2 * np.arange(points)[:, None] * s) * (2.0 / points)
    series[0] /= 2.0
    return -(np.sin(s)[:, None] ** (2 * np.arange(TERMS - 1))), series


class Swings:
    """Swings from a standstill, or from where one would be, to the next; all dimensionless.

    Parameters
    ----------
    begin : Start
        Where they begin: at rest with a positive drive, or with velocity.
    accuracy : float
        Relative error that the times may have.
    work : ndarray
        From `workspace`; the swings stay valid until it is used again.

    Attributes
    ----------
    end, peak, top, steep : ndarray
        Rotations at which the mass stands still and is fastest, E there, and -E' at the standstill.
    duration, peak_time, missing : ndarray
        Times to there, and what is estimated to be missing from them, relative.
    good : ndarray of bool
        Whether the lane was solved; the others' numbers mean nothing.
    """

    def __init__(self, begin: Start, accuracy: float, work: Floats) -> None:
        moving = np.any(begin.start)
        self._origin: Floats | None
        self._origin, valid = _standstill_before(begin, work) if moving else (None, np.True_)
        _, drive, tilt, constant, brake, furthest = swung = (
            begin if self._origin is None else begin.turned(self._origin)
        )
        slope, energy = _series(swung, work)
        # A pendulum swings to both sides of where its drive is zero alike; a brake q takes q m**2/3 off the half m,
        # and half of that again off the way to the peak.
        half = np.arctan2(drive, tilt)
        half *= 2.0 / (1.0 + np.sqrt(1.0 + (8.0 / 3.0) * (brake * half)))
        end, wrong, fall = _zero(energy, 2.0 * half)
        half = 0.5 * end
        peak, missed, _ = _zero(slope, half - (brake / 3.0) * (half * half))
        self.top, self.steep = _times_x(energy, peak), -fall * end
        self._rest, last = _deflate(energy, end)
        self.good = (wrong <= _EXACT) & (missed <= _EXACT) & (last <= -1e-16 * energy[1]) & (fall < 0.0) & valid
        self.good &= (peak > 0.0) & (peak < end) & (end < furthest)
        if np.any(constant < 0.0):  # see `Courses._peak`
            tilted = (drive + constant) * np.sin(end) + tilt * np.cos(end)
            self.good &= (constant >= 0.0) | ((tilt >= 0.0) & (tilted >= 0.0))
        self._whole, self.end, self.peak = end, end, peak
        passed = self._solve_times(accuracy)
        if self._origin is not None:
            self._begin_later(begin, self._origin, passed[0])

    def _solve_times(self, accuracy: float) -> list[Floats]:
        """The times to the standstill and the peak; those to where the motion begins come back, if there are any."""
        shares = [self.peak / self._whole, *([] if self._origin is None else [-self._origin / self._whole])]
        points = next(n for least, n in _POINTS if accuracy >= least)
        (self.duration, *parts), self.missing = _times(self._rest, shares, points)
        enough = max(0.1 * accuracy, 1e-15)
        for refined in _REFINED:
            late = np.flatnonzero(self.good & (self.missing > enough))
            if not len(late):
                break
            more, self.missing[late] = _times(self._rest[:, late], [s[late] for s in shares], refined)
            for old, new in zip([self.duration, *parts], more, strict=True):
                old[late] = new
        self.good &= self.missing <= enough
        self.peak_time, *passed = parts
        return passed

    def _begin_later(self, begin: Start, origin: Floats, passed: Floats) -> None:
        """Leave out the way and the time to where the motion begins."""
        self.end, self.duration = self._whole + origin, self.duration - passed
        falls = begin.drive <= begin.brake * begin.start
        self.peak = np.where(falls, 0.0, self.peak + origin)
        self.peak_time = np.where(falls, 0.0, self.peak_time - passed)
        self.top = np.where(falls, begin.start, self.top)
        self.good &= (self.end > 0.03 * self._whole) & (self.peak >= 0.0) & (self.peak_time >= 0.0)

    def reach(self, lanes: NDArray[np.intp], time: Floats) -> tuple[Floats, Floats, Mask]:
        """x and E of some lanes at times between start and standstill, and where they are good: Newton's method."""
        rest, end, origin = self._rest[:, lanes], self._whole[lanes], np.zeros(len(lanes))
        terms, missing = _terms(rest, _INSIDE)
        elapsed = time
        if self._origin is not None:
            origin = self._origin[lanes]
            time = time + _part(terms, -origin / end)
        s = time / terms[0]
        for _ in range(12):
            twice = 2.0 * np.cos(2.0 * s)
            one, two, rate, past = np.zeros((4, len(s)))
            for k in range(_INSIDE - 1, 0, -1):  # Clenshaw's recurrences, of the time and of its rate
                one, two = terms[k] / (2 * k) + twice * one - two, one
                rate, past = terms[k] + twice * rate - past, rate
            late = terms[0] * s + one * np.sin(2.0 * s) - time
            following = s - late / (terms[0] + 0.5 * twice * rate - past)
            moved = np.abs(following - s)
            s = np.minimum(np.maximum(following, 0.5 * s), 0.5 * (s + np.pi / 2))
            if np.all(moved <= 1e-15):
                break
        sine = np.sin(s) ** 2
        x, inside = end * sine, rest[-1].copy()
        for c in rest[-2::-1]:
            inside = inside * sine + c
        # Just after the start the series is not relatively accurate, which a course is.
        good = (moved <= 4e-15) & (elapsed > np.maximum(5e-3, 1e14 * missing) * terms[0]) & (x > -1.01 * origin)
        return x + origin, -inside * x * end * np.cos(s) ** 2, good


def _series(begin: Start, work: Floats) -> tuple[Floats, Floats]:
    """Coefficients of E' and of (E - start)/x as power series in x."""
    start, drive, tilt, constant, brake, _ = begin
    slope, energy = work[:, :, : drive.size]
    np.multiply(drive - brake * start, 2.0, out=slope[0])
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
    value, slope, bend = series[-1] * x, series[-1].copy(), np.zeros_like(x)
    value += series[-2]
    for c in series[-3::-1]:
        bend *= x
        bend += slope
        slope *= x
        slope += value
        value *= x
        value += c
    value /= slope
    bend *= value
    bend /= slope  # half the second derivative is what the loop gives
    following = x - value / np.maximum(1.0 - bend, 0.5)
    value /= x
    return following, np.abs(value) * (4 * bend * bend + value * value), slope


def _zero(series: Floats, guess: Floats) -> tuple[Floats, Floats, Floats]:
    """A zero by few terms, then by all; again in the lanes where that was not enough."""
    x, wrong, slope = _halley(series, _halley(series[:_FEW], guess)[0])
    for _ in range(3):
        more = np.flatnonzero(~(wrong <= _EXACT))
        if not len(more):
            break
        x[more], wrong[more], slope[more] = _halley(series[:, more], x[more])
    return x, wrong, slope


def _times_x(series: Floats, x: Floats) -> Floats:
    """x times a power series in x."""
    value = series[-1] * x
    for c in series[-2::-1]:
        value += c
        value *= x
    return value


def _deflate(energy: Floats, end: Floats) -> tuple[Floats, Floats]:
    """-Q, where E = x (end - x) Q(x/end), in the place of E/x, and the size of the last terms.

    Q's coefficients are sums from the last term on, so that no digit is lost.
    """
    power = np.ones_like(end)
    for k in range(2, TERMS):
        power *= end
        energy[k] *= power
    last = np.abs(energy[-1]) + np.abs(energy[-2])
    for k in range(TERMS - 2, 0, -1):
        energy[k] += energy[k + 1]
    return energy[1:], last


def _terms(rest: Floats, points: int) -> tuple[Floats, Floats]:
    """dt/ds as a cosine series in 2 s, where x = end sin(s)**2, and what the series misses in time, relative."""
    powers, series = _rule(points)
    terms, strip = np.empty((points, rest.shape[1])), _STRIP // points
    for k in range(0, rest.shape[1], strip):
        rate = powers @ rest[:, k : k + strip]
        np.sqrt(rate, out=rate)
        np.divide(2.0, rate, out=rate)
        np.matmul(series, rate, out=terms[:, k : k + strip])
    # What the next two terms would add, if they fall as the last four do; a pendulum has every other one only.
    last = np.abs(terms[-1]) + np.abs(terms[-2])
    return terms, last * (last / (np.abs(terms[-3]) + np.abs(terms[-4]) + 1e-300)) / (points * terms[0])


def _times(rest: Floats, shares: list[Floats], points: int) -> tuple[list[Floats], Floats]:
    """Times to the end and to shares of the way, by the series integrated, and what is missing of them, relative."""
    terms, missing = _terms(rest, points)
    return [terms[0] * (np.pi / 2), *(_part(terms, share) for share in shares)], missing


def _part(terms: Floats, share: Floats) -> Floats:
    """The time to a share of the way."""
    points, twice = len(terms), 2.0 - 4.0 * share  # 2 cos(2 s)
    one, two = terms[-1] / (2 * points - 2), np.zeros_like(share)
    for k in range(points - 2, 0, -1):  # Clenshaw's recurrence
        one, two = terms[k] / (2 * k) + twice * one - two, one
    return np.asarray(terms[0] * np.arcsin(np.sqrt(share)) + one * (2.0 * np.sqrt(share * (1.0 - share))))


def _standstill_before(begin: Start, work: Floats) -> tuple[Floats, Mask]:
    """Where lanes with velocity would have started from rest, 0 for those that do, and where that is found."""
    start, drive, tilt, _, brake, _ = begin
    _, energy = _series(begin, work)
    energy[1:] = energy[:-1].copy()
    energy[0] = start
    first = drive - brake * start
    bend = tilt + 2 * brake * first
    root = np.sqrt(first * first + bend * start)
    guess = np.where(first > 0.0, -start / (first + root), (first - root) / bend)
    origin, wrong, slope = _zero(energy, np.where(start > 0.0, guess, -1.0))
    rest = start == 0.0
    good = rest | ((origin < 0.0) & (wrong <= _EXACT) & (slope > 0.0))
    return np.where(good & ~rest, origin, 0.0), good
