"""Piecewise polynomials of slip, speed, time or rotation: friction laws, records and pulses."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated.flow import PIECES
from slipcircle.base.series import Pulse, Series

Floats = NDArray[np.float64]


class Data(NamedTuple):
    """A piecewise polynomial: piece k begins at ``breaks[k]``, with ``coefficients[k]`` in powers of what is beyond.

    The first piece extends below its break, the last one to infinity. ``jumps`` are the discontinuities of a function
    of time at the start of each piece. The coefficients of a ``sine`` are amplitude, rate and phase. Beyond the last
    break of an ``open`` table, that of a Python function, nothing has been sampled yet.
    """

    breaks: Floats  # (pieces,), or of functions of the rotation (pieces, lanes)
    coefficients: Floats  # (pieces, terms), or (pieces, terms, lanes)
    jumps: Floats
    sine: bool = False
    open: bool = False

    def lanes(self, which: Any) -> "Data":
        """The table of some of the lanes."""
        if self.coefficients.ndim < 3:
            return self
        breaks = self.breaks
        if breaks.ndim == 2:
            breaks = np.ascontiguousarray(breaks[:, which])
        coefficients = np.ascontiguousarray(self.coefficients[..., which])
        return self._replace(breaks=breaks, coefficients=coefficients)

    def begins(self, piece: NDArray[np.intp]) -> Floats:
        """The break at which the piece of each lane begins."""
        if self.breaks.ndim == 1:
            return np.asarray(self.breaks[piece])
        lane = np.arange(piece.size)
        return np.asarray(self.breaks[piece, lane])

    def entered(self, places: Floats, upwards: Any) -> NDArray[np.intp]:
        """The number of the piece at each place; at a break, of the piece ahead in the direction of travel."""
        breaks = self.breaks if self.breaks.ndim == 2 else self.breaks[:, None]
        at_break = (breaks == places) & upwards
        passed = (breaks < places) | at_break
        begun = np.count_nonzero(passed, axis=0)
        return np.maximum(begun - 1, 0)

    def polynomial(self, piece: NDArray[np.intp]) -> Floats:
        """Coefficients of each lane's piece, (terms, lanes)."""
        if self.coefficients.ndim == 2:
            return np.asarray(self.coefficients[piece].T)
        lane = np.arange(piece.size)
        return np.asarray(self.coefficients[piece, :, lane].T)


# --- friction laws and functions of time -----------------------------------------------------------------------------


def of_law(name: str, parameters: Mapping[str, ArrayLike]) -> Data:
    """A friction law that is declared in pieces, of the slip over its scale."""
    _, breaks, polynomials = PIECES[name]
    arrays = {n: np.asarray(value, dtype=np.float64) for n, value in parameters.items()}
    pieces = polynomials(**arrays)
    every = [coefficient for piece in pieces for coefficient in piece]
    values = np.array(np.broadcast_arrays(*every))
    coefficients = values.reshape(len(pieces), -1, *values.shape[1:])
    jumps = np.zeros(len(pieces))
    return Data(np.array(breaks), coefficients, jumps)


def lines(places: Floats, values: Floats, before: float, after: float) -> Data:
    """Linear interpolation of samples, constant before the first and after the last."""
    first = places[0] - 1.0
    breaks = np.concatenate([[first], places])
    heights = np.concatenate([[before], values[:-1], [after]])
    secant = np.diff(values) / np.diff(places)
    slopes = np.concatenate([[0.0], secant, [0.0]])
    jumps = np.zeros_like(heights)
    jumps[1] = values[0] - before
    jumps[-1] = after - values[-1]
    coefficients = np.stack([heights, slopes], axis=1)
    return Data(breaks, coefficients, jumps)


def waves(start: float, duration: float, amplitude: float, rate: float) -> Data:
    """A sine between its start and its end, zero elsewhere."""
    zero = [0.0, 0.0, 0.0]
    wave = [amplitude, rate, 0.0]
    end = start + duration
    breaks = np.array([start - 1.0, start, end])
    coefficients = np.array([zero, wave, zero])
    jumps = np.zeros(3)
    return Data(breaks, coefficients, jumps, sine=True)


def monotone(places: Floats, values: Floats, smooth_start: bool = False) -> Data:
    """Monotone cubic interpolation (Fritsch and Carlson 1980), smoothly continued by the last value.

    Interior slopes are weighted harmonic means (Fritsch and Butland 1984); the first is that of the parabola through
    three points, limited, or 0 for a smooth start.
    """
    step = np.diff(places)
    secant = np.diff(values) / step
    slope = np.zeros_like(values)
    slope[1:-1] = _interior_slopes(step, secant)
    if not smooth_start:
        slope[0] = _first_slope(step, secant)
    start = slope[:-1]
    end = slope[1:]
    quadratic = (3 * secant - 2 * start - end) / step
    cubic = (start + end - 2 * secant) / step**2
    pieces = np.stack([values[:-1], start, quadratic, cubic], axis=1)
    beyond = [values[-1], 0.0, 0.0, 0.0]
    coefficients = np.vstack([pieces, beyond])
    jumps = np.zeros(places.size)
    return Data(places, coefficients, jumps)


def _interior_slopes(step: Floats, secant: Floats) -> Floats:
    """Weighted harmonic means of neighbouring secants; 0 where they differ in sign."""
    before = secant[:-1]
    after = secant[1:]
    weight_before = 2 * step[1:] + step[:-1]
    weight_after = step[1:] + 2 * step[:-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        mean = (weight_before + weight_after) / (weight_before / before + weight_after / after)
    return np.where(before * after > 0.0, mean, 0.0)


def _first_slope(step: Floats, secant: Floats) -> float:
    """Slope of the parabola through the first three points, limited so that the interpolation is monotone."""
    if step.size == 1:
        return float(secant[0])
    near, far = step[:2]
    first, second = secant[:2]
    weighted = (2 * near + far) * first - near * second
    slope = weighted / (near + far)
    if slope * first <= 0.0:
        return 0.0
    if first * second <= 0.0:
        slope = min(slope, 3 * first, key=abs)
    return float(slope)


def of_speed(speeds: Floats, values: Floats) -> Data:
    """Monotone cubics in the logarithm of the speed, continued by the end values; the first piece begins at speed 0."""
    cubics = monotone(np.log(speeds), values, smooth_start=True)
    constant = [values[0], 0.0, 0.0, 0.0]
    breaks = np.concatenate([[0.0], speeds])
    coefficients = np.vstack([constant, cubics.coefficients])
    jumps = np.zeros(breaks.size)
    return Data(breaks, coefficients, jumps)


def of_list(argument: str, places: Floats, values: Floats) -> Data:
    """A friction law given as a table of slip, speed or time."""
    if argument == "slip":
        return monotone(places, values)
    if argument == "speed":
        return of_speed(places, values)
    first = float(values[0])
    last = float(values[-1])
    return lines(places, values, first, last)


def of_time(function: Series | Pulse) -> Data:
    """A function of time."""
    if isinstance(function, Series):
        times = function.time
        values = function.values
        if not function.held:
            return lines(times, values, 0.0, 0.0)
        first = float(values[0])
        last = float(values[-1])
        return lines(times, values, first, last)
    start = function.start
    duration = function.duration
    amplitude = function.amplitude
    end = start + duration
    if function.name == "rectangular":
        times = np.array([start, end])
        values = np.array([amplitude, amplitude])
        return lines(times, values, 0.0, 0.0)
    if function.name == "triangular":
        middle = start + duration / 2
        times = np.array([start, middle, end])
        values = np.array([0.0, amplitude, 0.0])
        return lines(times, values, 0.0, 0.0)
    half_waves = 2 * function.cycles if function.name == "sine" else 1.0
    rate = np.pi * half_waves / duration
    return waves(start, duration, amplitude, rate)
