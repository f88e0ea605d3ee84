"""Functions of time: series between samples, and pulses by name."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Series:
    """A function of time given at samples, straight between them; before and after them as the ends, or 0."""

    time: Floats
    values: Floats
    outside: bool = True  # whether the end values hold beyond the samples

    def __call__(self, t: Any) -> Any:
        if self.outside:
            return np.interp(t, self.time, self.values)
        return np.interp(t, self.time, self.values, left=0.0, right=0.0)

    @property
    def kinks(self) -> Floats:
        return self.time


@dataclass(frozen=True)
class Pulse:
    """A pulse by name: its amplitude, start and duration, s."""

    name: str
    amplitude: float
    start: float
    duration: float

    def __call__(self, t: Any) -> Any:
        share = (np.asarray(t, dtype=float) - self.start) / self.duration
        inside = (share >= 0.0) & (share <= 1.0)
        shapes = {"rectangular": lambda z: 1.0 + 0.0 * z, "half-sine": lambda z: np.sin(np.pi * z),
                  "triangular": lambda z: 1.0 - np.abs(2 * z - 1.0)}  # fmt: skip
        return self.amplitude * np.where(inside, shapes[self.name](share), 0.0)

    @property
    def kinks(self) -> Floats:
        more = [self.start + self.duration / 2] if self.name == "triangular" else []
        return np.array([self.start, *more, self.start + self.duration])
