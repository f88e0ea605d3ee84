"""Piecewise polynomials of slip, speed, time or rotation for friction laws, records and pulses."""

from collections.abc import Mapping
from functools import lru_cache
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated.effects import LAWS, Law
from generated.flow import PIECES
from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import Floats, Parameters, Shape, Texts
from slipcircle.core.scene.piecewise import Data
from slipcircle.tables.interpolation import continuous
from slipcircle.tables.series import LaneSeries, Pulse, Series

# --- friction laws and functions of time -----------------------------------------------------------------------------


def of_law(name: str, parameters: Mapping[str, ArrayLike], shape: Shape) -> tuple[Data, Any, str]:
    """Return a tabulated friction law: its pieces, the scale of its argument, and the argument's unit.

    `name` is the name of the law, and `shape` the shape of the lanes of its parameters.
    """
    if name in PIECES:
        length, _, _ = PIECES[name]
        return _of_pieces(name, parameters, shape), parameters[length], "m"
    law = LAWS[name]
    (argument,) = law.depends_on
    of_places, of_values = law.parameters
    places = np.asarray(parameters[of_places.name], float)
    values = np.asarray(parameters[of_values.name], float)
    table = of_list(argument, places, values)
    return table, 1.0, of_places.unit


def list_faults(path: str, law: Law, parameters: Parameters) -> Texts:
    """Return the mistakes in the two lists of a tabulated law. `path` locates it in messages, such as "friction"."""
    argument, values = (p.name for p in law.parameters)
    places = np.asarray(parameters[argument], float)
    coefficients = np.asarray(parameters[values], float)
    key = f"{{{path}.{argument}}}"
    is_list = places.ndim == 1 and places.size > 1
    is_pair = places.shape == coefficients.shape
    if not (is_list and is_pair):
        return [f"{key} and {{{path}.{values}}}: must be two lists of equal length, at least two values"]
    steps = np.diff(places)
    increases = np.all(steps > 0.0)
    starts_at_0 = places[0] == 0.0
    if law.name == "tabulated" and not (increases and starts_at_0):
        return [f"{key}: must start at 0 and increase"]
    if increases:
        return []
    return [f"{key}: must increase"]


def _of_pieces(name: str, parameters: Mapping[str, ArrayLike], shape: Shape) -> Data:
    """Return a friction law that is declared in pieces, as a function of slip over its scale.

    `name` is the name of the law, and `shape` the shape of the lanes.
    """
    _, breaks, polynomials = PIECES[name]
    arrays = {}
    for p in LAWS[name].parameters:
        value = parameters[p.name]
        arrays[p.name] = np.add(value, 0.0)
    pieces = polynomials(**arrays)
    every = chain.from_iterable(pieces)
    values = [*np.broadcast_arrays(*every)]
    if values[0].ndim:
        of_lanes = [np.broadcast_to(value, shape) for value in values]
        values = [value.ravel() for value in of_lanes]
    rows = np.array(values)
    _, *lanes = rows.shape
    coefficients = rows.reshape(len(pieces), -1, *lanes)
    starts = np.array(breaks)
    return continuous(starts, coefficients)


def lines(places: Floats, values: Floats, held: bool = False) -> Data:
    """Return the linear interpolation of samples, zero outside, or continued by the first and the last if `held`.

    `places` are the increasing arguments of the samples, such as times in s.
    """
    before, after = (values[0], values[-1]) if held else (0.0, 0.0)
    first = places[:1] - 1.0
    breaks = np.concatenate([first, places])
    coefficients = np.zeros((len(breaks), 2))
    heights, slopes = coefficients.T
    rise = np.diff(values)
    step = np.diff(places)
    heights[0] = before
    heights[1:-1] = values[:-1]
    heights[-1] = after
    slopes[1:-1] = rise / step
    jumps = np.zeros(len(breaks))
    jumps[1] = values[0] - before
    jumps[-1] = after - values[-1]
    return Data(breaks, coefficients, jumps)


def waves(start: float, duration: float, amplitude: float, rate: float) -> Data:
    """Return a sine between its start and its end, zero elsewhere.

    Start and duration are in s, and `rate` is the angular frequency in rad/s.
    """
    before = start - 1.0
    end = start + duration
    zero = [0.0, 0.0, 0.0]
    wave = [amplitude, rate, 0.0]
    breaks = np.array([before, start, end])
    coefficients = np.array([zero, wave, zero])
    return continuous(breaks, coefficients, sine=True)


def monotone(places: Floats, values: Floats, smooth_start: bool = False) -> Data:
    """Return the monotone cubic interpolation of samples (Fritsch and Carlson 1980), continued by the last value.

    `places` are the increasing arguments of the samples. Interior slopes are weighted harmonic means (Fritsch and
    Butland 1984). The first slope is the limited slope of the parabola through three points, or 0 for a smooth start.
    """
    step = np.diff(places)
    rise = np.diff(values)
    secant = rise / step
    slope = np.zeros_like(values)
    # Weighted harmonic means of neighbouring secants, 0 where their signs differ.
    before = secant[:-1]
    after = secant[1:]
    step_before = step[:-1]
    step_after = step[1:]
    weight_before = 2 * step_after + step_before
    weight_after = step_after + 2 * step_before
    weight = weight_before + weight_after
    with quiet():
        reciprocal = weight_before / before + weight_after / after
        mean = weight / reciprocal
    same_sign = before * after > 0.0
    slope[1:-1] = np.where(same_sign, mean, 0.0)
    if not smooth_start:
        slope[0] = _first_slope(step, secant)
    start = slope[:-1]
    end = slope[1:]
    quadratic = (3 * secant - 2 * start - end) / step
    cubic = (start + end - 2 * secant) / step**2
    *first_values, last_value = values
    pieces = np.stack([first_values, start, quadratic, cubic], axis=1)
    beyond = [last_value, 0.0, 0.0, 0.0]
    coefficients = np.vstack([pieces, beyond])
    return continuous(places, coefficients)


def _first_slope(step: Floats, secant: Floats) -> float:
    """Return the slope of the parabola through the first three points, limited to preserve monotonicity.

    `step` are the distances between neighbouring points, and `secant` the slopes of the lines between them.
    """
    if step.size == 1:
        return float(secant[0])
    near, far, *_ = step
    first, second, *_ = secant
    weighted = (2 * near + far) * first - near * second
    slope = weighted / (near + far)
    if slope * first <= 0.0:
        return 0.0
    turns = first * second <= 0.0
    if turns:
        slope = min(slope, 3 * first, key=abs)
    return float(slope)


def of_list(argument: str, places: Floats, values: Floats) -> Data:
    """Return a friction law given as a table of slip, speed or time.

    `argument` is "slip", "speed" or "time", and `places` are its increasing values in m, m/s or s.
    """
    if argument == "slip":
        return monotone(places, values)
    if argument == "speed":
        # Monotone cubics in the logarithm of speed, continued by the end values down to speed 0.
        cubics = monotone(np.log(places), values, smooth_start=True)
        constant = [values[0], 0.0, 0.0, 0.0]
        breaks = np.concatenate([[0.0], places])
        coefficients = np.vstack([constant, cubics.coefficients])
        return continuous(breaks, coefficients)
    return lines(places, values, held=True)


@lru_cache(maxsize=2)  # a record is often solved several times, one after the other
def of_time(function: Series | LaneSeries | Pulse) -> Data:
    """Return the pieces of a function of time in s, or of one function per lane. A lane is a member of an ensemble."""
    if isinstance(function, LaneSeries):
        # Functions of time one after the other, each followed by a piece that begins at infinity.
        tables = [of_time(series) for series in function.series]
        infinity = np.array([np.inf])
        nothing = np.zeros((1, 2))
        never = continuous(infinity, nothing)
        parts = [part for table in tables for part in (table, never)]
        pieces = [len(part.breaks) for part in parts]
        ends = np.cumsum([0, *pieces])
        first = ends[::2][function.which]
        breaks = np.concatenate([part.breaks for part in parts])
        coefficients = np.concatenate([part.coefficients for part in parts])
        jumps = np.concatenate([part.jumps for part in parts])
        return Data(breaks, coefficients, jumps, first=first)
    if isinstance(function, Pulse):
        return _of_pulse(function)
    return lines(function.time, function.values, function.held)


def _of_pulse(pulse: Pulse) -> Data:
    amplitude = pulse.amplitude
    if pulse._phase:
        rate = pulse._phase / pulse.duration
        return waves(pulse.start, pulse.duration, amplitude, rate)
    is_constant = pulse.name == "rectangular"
    heights = [amplitude, amplitude] if is_constant else [0.0, amplitude, 0.0]
    values = np.array(heights)
    return lines(pulse.kinks, values)
