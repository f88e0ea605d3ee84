"""Phases of many lanes in the phase plane by the generated closed forms: any start, any brake, one direction each.

For what `slipcircle.arrays.swings` does not take: a start with velocity, a strong brake, an end before the
standstill. E is that of `slipcircle.methods.phaseplane.Course`, and so are the brackets, which its comments prove.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import balance as functions
from generated.effects import ARGUMENTS

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
_ALL = slice(None)
# Gauss-Legendre rules that are compared, refined for the lanes where they differ.
_RULES = ((14, 22), (40, 60), (110, 160), (300, 420))


class Start(NamedTuple):
    """Where phases begin, dimensionless, in the direction of travel: arrays of one length."""

    start: Floats  # E
    drive: Floats
    tilt: Floats
    constant: Floats
    brake: Floats
    furthest: Floats

    def some(self, lanes: NDArray[np.intp]) -> "Start":
        """Those of some lanes."""
        return Start(*(x[lanes] for x in self))

    def turned(self, x: Floats) -> "Start":
        """From a standstill at x."""
        _, drive, tilt, constant, brake, furthest = self
        sine, cosine = np.sin(x), np.cos(x)
        turned = drive * cosine - tilt * sine - 2 * constant * np.sin(x / 2) ** 2
        tilted = (drive + constant) * sine + tilt * cosine
        return Start(np.zeros_like(x), turned, tilted, constant, brake, furthest - x)


def halley(function: Any, x: Floats, low: Floats, high: Floats, wanted: Mask) -> tuple[Floats, Mask]:
    """`slipcircle.methods.roots.halley` for the wanted lanes at once, and which lanes have settled."""
    settled = ~wanted
    for _ in range(2000):
        value, slope, curvature = function(x)
        low, high = np.where(value > 0.0, x, low), np.where(value > 0.0, high, x)
        falls = slope < 0.0
        step = value / slope
        bend = step * curvature / slope
        following = x - step / np.maximum(1.0 - bend / 2, 0.5)
        sure = falls & (np.abs(step) * (bend * bend + (step / x) ** 2) <= 6e-17 * x)
        middle = 0.5 * (low + high)
        halve = ~(sure | (falls & (following > low) & (following < high)))
        x = np.where(settled, x, np.where(halve, middle, following))
        settled |= sure | (halve & ((middle == low) | (middle == high)))
        if np.all(settled):
            break
    return x, settled


class Courses:
    """E(x) of phases with constant friction on a turning mass, from their start to their standstill.

    Attributes
    ----------
    end, peak, top : ndarray
        Rotations at which the mass stands still and is fastest, and E there.
    duration, peak_time, missing : ndarray
        Times to there, and what is estimated to be missing from them, relative.
    good : ndarray of bool
        Whether the lane was solved; the others' numbers mean nothing.
    """

    def __init__(self, name: str, begin: Start) -> None:
        self.begin, self._function, self._names = begin, getattr(functions, name), ARGUMENTS[name][1:]
        self._given = [getattr(begin, a) for a in self._names]
        self.end, self.good = self._first_zero()
        self._from_end = self._mirrored()
        self.peak = self._peak()
        self.top = self.energy(self.peak)
        self._origin = self._virtual_start()
        self._span = self.end - self._origin
        self._first = np.arcsin(np.sqrt(-self._origin / self._span))
        self.points = _RULES[0][1]
        self.duration, self.peak_time, self.missing = self._times()
        self.good &= self.missing <= 1e-12

    # -- E

    def energy(self, x: Floats) -> Floats:
        """E from the start."""
        return np.asarray(self._function(x, *self._given))

    def rates(self, x: Floats) -> tuple[Floats, Floats, Floats]:
        """E and its first two derivatives."""
        _, drive, tilt, constant, brake, _ = self.begin
        energy, sine, cosine = self.energy(x), np.sin(x), np.cos(x)
        turned = drive * cosine - tilt * sine - 2 * constant * np.sin(x / 2) ** 2
        rate = 2 * (turned - brake * energy)
        return energy, rate, -2 * ((drive + constant) * sine + tilt * cosine + brake * rate)

    def _higher(self, x: Floats) -> tuple[Floats, Floats, Floats]:
        """The first three derivatives of E."""
        _, drive, tilt, constant, brake, _ = self.begin
        _, rate, change = self.rates(x)
        return rate, change, -2 * ((drive + constant) * np.cos(x) - tilt * np.sin(x) + brake * change)

    def _mirrored(self) -> list[Floats]:
        """The closed form's arguments for y = end - x: drive, constant and brake change their signs."""
        start, drive, tilt, constant, brake, _ = self.begin
        sine, cosine = np.sin(self.end), np.cos(self.end)
        turned = drive * cosine - tilt * sine - 2 * constant * np.sin(self.end / 2) ** 2
        self._tilted = (drive + constant) * sine + tilt * cosine
        back = {"start": 0.0 * start, "drive": -turned, "tilt": self._tilted,
                "constant": -constant, "brake": -brake}  # fmt: skip
        self.steep = -2 * turned
        return [back[a] for a in self._names]

    def speed_squared(self, x: Floats, left: Floats, lanes: Any = _ALL) -> Floats:
        """E, from the start in the first half and back from the standstill in the second, so relatively accurate."""
        back = (left < x) & (2 * self.begin.brake[lanes] * left < 1.0)
        given = [np.where(back, y[lanes], x[lanes]) for x, y in zip(self._given, self._from_end, strict=True)]
        return np.maximum(self._function(np.where(back, left, x), *given), 0.0)

    def _first_zero(self) -> tuple[Floats, Mask]:
        start, drive, tilt, constant, brake, far = self.begin
        at_far = self.energy(far)
        good = (at_far <= 0.0) & ((constant >= 0.0) | (drive >= 0.0))
        curvature = np.maximum(tilt + 2 * brake * drive, 1e-300)
        slope = drive - brake * start
        root = np.sqrt(np.maximum(slope * slope + curvature * start, 0.0))
        ahead = np.where(curvature * far > slope, (slope + root) / curvature, far)
        guess = np.where(slope < 0.0, start / (root - slope), ahead)
        guess = np.where(start > 0.0, guess, np.minimum(2 * drive / curvature, far / 2))
        low, high = np.zeros_like(far), np.where(start > 0.0, np.minimum(np.maximum(guess, 1e-300), far), far)
        while np.any(short := good & (high < far) & (self.energy(high) > 0.0)):
            low, high = np.where(short, high, low), np.where(short, np.minimum(2 * high, far), high)
        end, settled = halley(self.rates, np.minimum(np.maximum(guess, low), high), low, high, good)
        return end, good & settled & (end > 0.0)

    def _peak(self) -> Floats:
        """Where E is greatest: E rises at most once and falls at most once."""
        start, drive, _, constant, brake, _ = self.begin
        falls = drive <= brake * start
        peak, settled = halley(self._higher, self.end / 2, 0.0 * self.end, self.end, self.good & ~falls)
        self.good &= settled
        # Water alone can make the drive grow on the way, and only there may E have more than one peak.
        self.good &= (constant >= 0.0) | ((self.begin.tilt >= 0.0) & (self._tilted >= 0.0))
        return np.where(falls, 0.0, peak)

    # -- time

    def _virtual_start(self) -> Floats:
        """The standstill that the phase would have come from, or a place as far behind where there is none nearby.

        Between two standstills the time is smooth in s, x = origin + span sin(s)**2.
        """
        start = self.begin.start
        _, rate, _ = self.rates(0.0 * start)
        near = (start > 0.0) & (rate > 0.0) & (self.energy(-self.end) < 0.0)
        origin = np.where(start > 0.0, -self.end, 0.0)
        if np.any(near):

            def behind(y: Floats) -> tuple[Floats, Floats, Floats]:
                energy, rate, change = self.rates(-y)
                return energy, -rate, change

            found, settled = halley(behind, np.minimum(start / rate, self.end / 2), 0.0 * start, self.end, near)
            origin = np.where(near & settled, -found, origin)
        return origin

    def _place(self, past: Floats, before: Floats, lanes: Any = _ALL) -> tuple[Floats, Floats, Floats]:
        """x, E and dt/ds at s = first + past = pi/2 - before."""
        span, first, cosine = self._span[lanes], self._first[lanes], np.sin(before)
        x = span * np.sin(past) * np.sin(past + 2 * first)
        energy = self.speed_squared(x, span * cosine * cosine, lanes)
        return x, energy, 2 * span * np.sin(past + first) * cosine / np.sqrt(energy)

    def _elapsed(self, past: Floats, points: int, lanes: Any = _ALL) -> Floats:
        """The time to s = first + past."""
        nodes, weights = np.polynomial.legendre.leggauss(points)
        share = (nodes[:, None] + 1) / 2
        before = (np.pi / 2 - self._first[lanes] - past) + past * (1.0 - share)
        return np.asarray(weights @ self._place(past * share, before, lanes)[2]) * past / 2

    def _times(self) -> tuple[Floats, Floats, Floats]:
        whole = np.pi / 2 - self._first
        top = np.arcsin(np.sqrt(np.minimum((self.peak - self._origin) / self._span, 1.0))) - self._first
        top = np.where(self.peak > 0.0, np.maximum(top, 0.0), 0.0)
        duration, at_top, missing = np.full((3, len(top)), np.inf)
        unsolved, needed = self.good.copy(), self._needed(whole)
        for coarse, self.points in _RULES:
            lanes = np.flatnonzero(unsolved & (needed <= coarse))
            one, two = (self._elapsed(s[lanes], coarse, lanes) for s in (whole, top))
            duration[lanes], at_top[lanes] = (self._elapsed(s[lanes], self.points, lanes) for s in (whole, top))
            difference = np.abs(one - duration[lanes]) + np.abs(two - at_top[lanes])
            missing[lanes] = difference / duration[lanes]
            unsolved[lanes] = ~(missing[lanes] <= 4e-14)
            if not np.any(unsolved):
                break
        return duration, at_top, missing

    def _needed(self, whole: Floats) -> Floats:
        """Points without which two rules may agree and both miss what a strong brake does just after the start."""
        start, brake = self.begin.start, self.begin.brake
        rate = np.abs(self.rates(0.0 * start)[1])
        layer = 0.5 / np.maximum(brake, 1e-300)
        layer = np.where((start > 0.0) & (self._origin == -self.end), np.minimum(layer, start / rate), layer)
        first = layer / (self._span * np.sin(2 * self._first) + np.sqrt(layer * self._span))
        return np.asarray(4 * np.sqrt(whole / first))

    def reach(self, time: Floats) -> tuple[Floats, Floats]:
        """x and E at times between the start and the standstill: Newton's method in s, between bounds."""
        whole = np.pi / 2 - self._first
        low, high = np.zeros_like(whole), whole
        past = whole * time / self.duration
        for _ in range(100):
            late = self._elapsed(past, self.points) - time
            low, high = np.where(late <= 0.0, past, low), np.where(late >= 0.0, past, high)
            following = past - late / self._place(past, whole - past)[2]
            following = np.where((following >= low) & (following <= high), following, (low + high) / 2)
            still = np.abs(following - past) <= 4e-16 * past
            past = following
            if np.all(still | ~self.good):
                break
        x, energy, _ = self._place(past, whole - past)
        return x, energy
