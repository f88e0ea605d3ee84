"""Functions of time: samples joined by straight lines, and named pulses."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from slipcircle.base.arrays import INFINITY, array_of, frozen
from slipcircle.base.errors import mistakes, one_number, raise_all
from slipcircle.base.kinds import Floats, Integers

PULSES = ("rectangular", "half-sine", "triangular", "sine")


def bad_sample(time: Floats, values: Floats) -> tuple[int, str] | None:
    """Return the index of the first invalid sample and a message about it, or None.

    Samples must be finite, and times, in s, must increase. The index counts from 0.
    """
    for what, unit, of in (("time", " s", time), ("value", "", values)):
        (bad,) = np.nonzero(~np.isfinite(of))
        if bad.size:
            k = int(bad[0])
            number = float(of[k])
            return k, f"{what} = {number!r}{unit}: must be a finite number; fill it in, or remove the sample"
    steps = np.diff(time)
    (late,) = np.nonzero(steps <= 0.0)
    if late.size:
        k = int(late[0])
        before = float(time[k])
        now = float(time[k + 1])
        kind = "repeats" if now == before else "comes before"
        return k + 1, (
            f"time = {now!r} s {kind} that of the sample before, {before!r} s: times must increase; remove one of the "
            "two, or put the samples in order"
        )
    return None


@dataclass(frozen=True, eq=False)
class Series:
    """Samples joined by straight lines.

    Parameters
    ----------
    time : array_like
        Increasing times in s, at least two.
    values : array_like
        Values in SI units, or divided by gravity for shaking.
    held : bool, optional
        Whether the first and the last value continue beyond the samples. Otherwise the function is zero there.

    Raises
    ------
    ValueError
        If a sample is invalid. The message gives its index.
    """

    time: Floats
    values: Floats
    held: bool = True

    def __post_init__(self) -> None:
        """Check times and values, and freeze them."""
        for name in ("time", "values"):
            samples = array_of(getattr(self, name))
            if samples.ndim != 1 or samples.dtype.kind not in "iuf":
                raise ValueError(f"Series: {name}: must be a plain list of numbers, without mask or unit")
            samples = samples.astype(float, copy=False)
            object.__setattr__(self, name, frozen(samples))
        time, values = self.time, self.values
        if time.shape != values.shape or time.size < 2:
            raise ValueError(
                f"Series: has {time.size} times and {values.size} values: must have equal numbers of both, two at least"
            )
        fault = bad_sample(time, values)
        if fault:
            index, sentence = fault
            raise ValueError(f"Series: sample {index + 1}: {sentence}")

    crests = np.empty(0)  # extrema between kinks

    def __call__(self, t: ArrayLike) -> Any:
        """Return the values at times in s."""
        outside = {} if self.held else {"left": 0.0, "right": 0.0}
        return np.interp(np.asarray(t, float), self.time, self.values, **outside)

    @property
    def kinks(self) -> Floats:
        """Times at which the function is not smooth, s."""
        return self.time

    @property
    def greatest(self) -> float:
        """Greatest absolute value, in the unit of the values."""
        return float(np.max(np.abs(self.values)))

    def scaled(self, factor: float) -> "Series":
        """Return the function multiplied by a factor."""
        return Series(self.time, self.values * factor, self.held)


@dataclass(frozen=True, eq=False)
class LaneSeries:
    """One function of time for each lane of an ensemble.

    Attributes
    ----------
    series : tuple of Series
    which : ndarray of int
        Index of the function of each lane.
    """

    series: tuple[Series, ...]
    which: Integers

    def __call__(self, t: ArrayLike) -> Any:
        """Return the values of each lane's function at times in s. Lanes are the first axis."""
        values = [function(t) for function in self.series]
        return np.stack(values)[self.which]

    @property
    def kinks(self) -> Floats:
        """Times at which any function is not smooth, s."""
        times = [function.kinks for function in self.series]
        return np.unique(np.concatenate(times))


@dataclass(frozen=True)
class Pulse:
    """Single pulse or train of sine waves, zero before its start and after its end.

    Parameters
    ----------
    name : str
        One of ``PULSES``. A triangle is symmetric; a half-sine is half a wave.
    amplitude : float
        Greatest value, divided by gravity for shaking. May be negative.
    start, duration : float
        Start and duration in s.
    cycles : float, optional
        Number of waves of a sine.
    """

    name: str
    amplitude: float
    start: float
    duration: float
    cycles: float = 1.0

    def __post_init__(self) -> None:
        """Check name, amplitude, start, duration and number of cycles."""
        faults = []
        if self.name not in PULSES:
            faults.append(f"name = {self.name!r}: must be one of {', '.join(PULSES)}")
        numbers = {
            "amplitude": one_number(-INFINITY, INFINITY, "a finite number"),
            "start": one_number(-5e-324, INFINITY, "a time in s, not before 0"),
            "duration": one_number(0.0, INFINITY, "a positive time in s"),
            "cycles": one_number(0.0, 1e4, "a number of waves above 0, below 1e4"),
        }
        faults += mistakes(vars(self), numbers)
        if self.name != "sine" and self.cycles != 1.0:
            faults.append(f"cycles = {self.cycles!r}: applies to a sine only; remove it")
        raise_all("Pulse", faults)

    def scaled(self, factor: float) -> "Pulse":
        """Return the pulse multiplied by a factor."""
        return replace(self, amplitude=self.amplitude * factor)

    @property
    def end(self) -> float:
        """End time, s."""
        return self.start + self.duration

    @property
    def _phase(self) -> float:
        """Phase of the sine at the end of the pulse, rad; 0 for pulses made of straight lines."""
        return math.pi * {"sine": 2 * self.cycles, "half-sine": 1.0}.get(self.name, 0.0)

    def __call__(self, t: Any) -> Any:
        """Return the values at times in s."""
        time = np.asarray(t, float)
        tau = np.clip(time - self.start, 0.0, self.duration)
        shape = np.ones_like(tau)
        if self._phase:
            shape = np.sin(self._phase * tau / self.duration)
        if self.name == "triangular":
            shape = np.minimum(tau, self.duration - tau) / (self.duration / 2)
        inside = (time >= self.start) & (time < self.end)
        return np.where(inside, self.amplitude * shape, 0.0)[()]

    @property
    def kinks(self) -> Floats:
        """Times at which the pulse is not smooth, s."""
        middle = [self.start + self.duration / 2] if self.name == "triangular" else []
        return np.array([self.start, *middle, self.end])

    @property
    def crests(self) -> Floats:
        """Times of extrema other than kinks, s."""
        quarters = np.arange(math.pi / 2, self._phase, math.pi)
        return self.start + self.duration * quarters / (self._phase or 1.0)

    @property
    def greatest(self) -> float:
        """Greatest absolute value."""
        return abs(self.amplitude)
