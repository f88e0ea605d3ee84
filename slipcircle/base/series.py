"""Functions of time: samples joined by straight lines, named pulses, and the shaking that is made of them."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.base.checks import INFINITY, Bounds, mistakes, raise_all

Floats = NDArray[np.float64]

PULSES = ("rectangular", "half-sine", "triangular", "sine")
_PIECES = 16  # of half a wave
_TERMS = 15  # of the Taylor series of a sine on one of them: what is left out is below 1e-22


class Pieces(NamedTuple):
    """A function of time as polynomials: ``coefficients[:, k]`` in powers of (t - knots[k]), and its value at the
    right end of each piece; what it is before the first knot and after the last."""

    knots: Floats
    coefficients: Floats
    ends: Floats
    before: float
    after: float


def bad_sample(time: Floats, values: Floats) -> tuple[int, str] | None:
    """The first sample that is not finite or not later than the one before, and a sentence about it."""
    for what, unit, of in (("time", " s", time), ("value", "", values)):
        bad = np.flatnonzero(~np.isfinite(of))
        if bad.size:
            k = int(bad[0])
            return k, f"{what} = {float(of[k])!r}{unit}: must be a finite number; fill it in, or remove the sample"
    late = np.flatnonzero(np.diff(time) <= 0.0)
    if late.size:
        k = int(late[0]) + 1
        kind = "repeats" if time[k] == time[k - 1] else "comes before"
        return k, (
            f"time = {float(time[k])!r} s {kind} that of the sample before, {float(time[k - 1])!r} s: times must "
            "increase; remove one of the two, or put the samples in order"
        )
    return None


@dataclass(frozen=True, eq=False)
class Series:
    """Samples joined by straight lines.

    Parameters
    ----------
    time : array_like
        s, increasing, two at least.
    values : array_like
        SI units; over gravity for shaking.
    held : bool, optional
        Whether the first and the last value hold beyond the samples, where otherwise it is zero.

    Raises
    ------
    ValueError
        Says which sample is wrong.
    """

    time: Floats
    values: Floats
    held: bool = True

    def __post_init__(self) -> None:
        for name in ("time", "values"):
            given = np.asarray(getattr(self, name))
            if given.ndim != 1 or given.dtype.kind not in "iuf":
                raise ValueError(f"Series: {name}: must be a plain list of numbers")
            object.__setattr__(self, name, given.astype(np.float64))
        if self.time.shape != self.values.shape or self.time.size < 2:
            raise ValueError(
                f"Series: has {self.time.size} times and {self.values.size} values: must have as many of both, "
                "two at least"
            )
        found = bad_sample(self.time, self.values)
        if found:
            index, said = found
            raise ValueError(f"Series: sample {index + 1}: {said}")

    straight = True  # between its kinks
    crests = np.empty(0)  # between its kinks

    def __call__(self, t: ArrayLike) -> Any:
        """Values at times, s."""
        outside = {} if self.held else {"left": 0.0, "right": 0.0}
        return np.interp(np.asarray(t, dtype=np.float64), self.time, self.values, **outside)

    @property
    def kinks(self) -> Floats:
        """Times at which it is not smooth, s."""
        return self.time

    @cached_property
    def pieces(self) -> Pieces:
        """The straight lines."""
        slope = np.diff(self.values) / np.diff(self.time)
        first, last = (float(self.values[0]), float(self.values[-1])) if self.held else (0.0, 0.0)
        return Pieces(self.time, np.array([self.values[:-1], slope]), self.values[1:], first, last)

    def scaled(self, factor: float) -> "Series":
        """The same times, the values times a factor."""
        return Series(self.time, self.values * factor, self.held)


@dataclass(frozen=True)
class Pulse:
    """One pulse, or a train of sine waves; zero before its start and after its end.

    Parameters
    ----------
    name : str
        One of ``PULSES``. A triangle has its top in the middle; a half-sine is half a wave.
    amplitude : float
        Its greatest value; over gravity for shaking. May be negative.
    start, duration : float
        s.
    cycles : float, optional
        Waves of a sine.
    """

    name: str
    amplitude: float
    start: float
    duration: float
    cycles: float = 1.0

    def __post_init__(self) -> None:
        found = [] if self.name in PULSES else [f"name = {self.name!r}: must be one of {', '.join(PULSES)}"]
        bounds: dict[str, Bounds] = {
            "amplitude": (-INFINITY, INFINITY, "a finite number"),
            "start": (-5e-324, INFINITY, "a time in s, not before 0"),
            "duration": (0.0, INFINITY, "a positive time in s"),
            "cycles": (0.0, 1e4, "a number of waves above 0, below 1e4"),
        }
        given = {n: getattr(self, n) for n in bounds}
        found += [f"{n} = {v!r}: must be one number" for n, v in given.items() if np.ndim(v)]
        found += mistakes(given, {n: b for n, b in bounds.items() if not np.ndim(given[n])})
        if self.name != "sine" and self.cycles != 1.0:
            found.append(f"cycles = {self.cycles!r}: belongs to a sine only; leave it out")
        raise_all("Pulse", found)

    def scaled(self, factor: float) -> "Pulse":
        """The same pulse, its values times a factor."""
        return replace(self, amplitude=self.amplitude * factor)

    @property
    def end(self) -> float:
        """s."""
        return self.start + self.duration

    @cached_property
    def _phase(self) -> float:
        """Radians of the sine that the whole pulse takes."""
        return math.pi * (2 * self.cycles if self.name == "sine" else 1.0)

    def _local(self, t: ArrayLike) -> tuple[Floats, Floats, NDArray[np.bool_]]:
        """Times since the start within the pulse, since its end, and where it acts."""
        time = np.asarray(t, dtype=np.float64)
        inside = (time >= self.start) & (time < self.end)
        return np.clip(time - self.start, 0.0, self.duration), np.maximum(time - self.end, 0.0), inside

    @cached_property
    def straight(self) -> bool:
        """Whether it is straight between its kinks."""
        return self.name in ("rectangular", "triangular")

    def __call__(self, t: Any) -> Any:
        """Values at times, s."""
        if isinstance(t, float) and not self.straight:  # NumPy takes its time with one number
            acts = self.start <= t < self.end
            return self.amplitude * math.sin(self._phase * (t - self.start) / self.duration) if acts else 0.0
        tau, _, inside = self._local(t)
        if self.name == "rectangular":
            shape: Any = 1.0
        elif self.name == "triangular":
            shape = np.minimum(tau, self.duration - tau) / (self.duration / 2)
        else:
            shape = np.sin(self._phase * tau / self.duration)
        return np.where(inside, self.amplitude * shape, 0.0)[()]

    def integral(self, t: ArrayLike) -> Any:
        """Its integral from before the start to times: a velocity over gravity, s."""
        tau, _, _ = self._local(t)
        d = self.duration
        if self.name == "rectangular":
            return (self.amplitude * tau)[()]
        if self.name == "triangular":
            left = d - tau
            return (self.amplitude * np.where(tau <= d / 2, tau**2 / d, d / 2 - left**2 / d))[()]
        rate = self._phase / d
        return (self.amplitude / rate * 2 * np.sin(rate * tau / 2) ** 2)[()]

    def second_integral(self, t: ArrayLike) -> Any:
        """The integral of its integral: a displacement over gravity, s^2."""
        tau, after, _ = self._local(t)
        d = self.duration
        coasting = self.integral(t) * after
        if self.name == "rectangular":
            return (self.amplitude * tau**2 / 2 + coasting)[()]
        if self.name == "triangular":
            left = d - tau
            late = d**2 / 4 - d / 2 * left + left**3 / (3 * d)
            return (self.amplitude * np.where(tau <= d / 2, tau**3 / (3 * d), late) + coasting)[()]
        rate = self._phase / d
        return (self.amplitude / rate**2 * _less_sine(rate * tau) + coasting)[()]

    @property
    def kinks(self) -> Floats:
        """Times at which it is not smooth, s."""
        middle = [self.start + self.duration / 2] if self.name == "triangular" else []
        return np.array([self.start, *middle, self.end])

    @property
    def crests(self) -> Floats:
        """Times at which it is greatest in size, kinks aside, s."""
        quarters = np.arange(math.pi / 2, 0.0 if self.straight else self._phase, math.pi)
        return self.start + self.duration * quarters / self._phase

    @cached_property
    def pieces(self) -> Pieces:
        """The pulse as polynomials: exact, but for a sine, which is a Taylor series on each of many short pieces."""
        d, a = self.duration, float(self.amplitude)
        if self.name == "rectangular":
            return Pieces(np.array([self.start, self.end]), np.array([[a]]), np.array([a]), 0.0, 0.0)
        if self.name == "triangular":
            knots = np.array([self.start, self.start + d / 2, self.end])
            return Pieces(knots, np.array([[0.0, a], [2 * a / d, -2 * a / d]]), np.array([a, 0.0]), 0.0, 0.0)
        waves = self._phase / math.pi * _PIECES  # a piece is pi/16, so that the tops of the waves are knots
        count = math.ceil(waves * (1 - 1e-15))
        steps = np.minimum(np.arange(count + 1), waves)
        sine, cosine = _sixteenth(steps), _sixteenth(steps + _PIECES / 2)
        powers = np.empty((_TERMS, count))
        rate, factor = self._phase / d, 1.0
        for k in range(_TERMS):
            powers[k] = factor * (1, 1, -1, -1)[k % 4] * (sine if k % 2 == 0 else cosine)[:-1]
            factor *= rate / (k + 1)
        return Pieces(self.start + steps * (d / waves), a * powers, a * sine[1:], 0.0, 0.0)


def _sixteenth(steps: Floats) -> Floats:
    """sin(pi steps/16), exact where the sine is 0 or 1, and alike on both sides of its top."""
    turned = np.mod(steps, 2 * _PIECES)
    sign = np.where(turned >= _PIECES, -1.0, 1.0)
    turned = np.where(turned >= _PIECES, turned - _PIECES, turned)
    return sign * np.sin(np.pi / _PIECES * np.minimum(turned, _PIECES - turned))


def _less_sine(x: Floats) -> Floats:
    """x - sin x without cancellation."""
    z, total = np.minimum(x, 1.0) ** 2, np.zeros_like(x)
    for k in range(18, 0, -2):
        total = (1.0 - total) * z / (k * (k + 1))
    return np.where(x < 1.0, x * total, x - np.sin(x))


@dataclass(frozen=True, eq=False)
class Shaking:
    """What shakes a scene, over gravity: ``horizontal`` is k_h(t), which drives in the sense of positive rotation
    (down-slope for a positive dip), and ``vertical`` k_v(t), which lightens the mass."""

    horizontal: Series | Pulse
    vertical: Series | Pulse | None = None

    @property
    def parts(self) -> tuple[Series | Pulse, ...]:
        """k_h and, where there is one, k_v."""
        return (self.horizontal,) if self.vertical is None else (self.horizontal, self.vertical)

    @property
    def kinks(self) -> Floats:
        """Times at which it is not smooth, s."""
        return np.unique(np.concatenate([p.kinks for p in self.parts]))

    @property
    def end(self) -> float:
        """Time from which it is still, s."""
        return float(max(p.kinks[-1] for p in self.parts))
