"""Functions in pieces, as the flow walks them: laws by table, records, pulses, and functions given in Python."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial
from numpy.typing import ArrayLike, NDArray

from generated.flow import PIECES
from slipcircle.base.series import Pulse, Series

Floats = NDArray[np.float64]


class Data(NamedTuple):
    """A function in pieces: piece k begins at ``breaks[k]``, with ``coefficients[k]`` in powers of what is beyond it.

    The first piece holds before its break too, the last one for ever. ``jumps`` are what a function of time leaps by on
    entering a piece. A ``sine`` has amplitude, rate and phase for coefficients. Of an ``open`` table, that of a Python
    function, the last piece is not known yet.
    """

    breaks: Floats  # (pieces), or of rotations (pieces, lanes)
    coefficients: Floats  # (pieces, terms), or (pieces, terms, lanes)
    jumps: Floats
    sine: bool = False
    open: bool = False

    def lanes(self, which: Any) -> "Data":
        """For some of the lanes."""
        if self.coefficients.ndim < 3:
            return self
        own = self.breaks[:, which] if self.breaks.ndim == 2 else self.breaks
        return self._replace(breaks=own, coefficients=self.coefficients[..., which])

    def begins(self, piece: NDArray[np.intp]) -> Floats:
        """Where each lane's piece begins."""
        return np.asarray(self.breaks[piece, np.arange(piece.size)] if self.breaks.ndim == 2 else self.breaks[piece])

    def entered(self, places: Floats, upwards: Any) -> NDArray[np.intp]:
        """The pieces that places belong to; a break to the piece beyond, in the direction of travel."""
        breaks = self.breaks if self.breaks.ndim == 2 else self.breaks[:, None]
        passed = (breaks < places) | ((breaks == places) & upwards)
        return np.maximum(np.count_nonzero(passed, axis=0) - 1, 0)

    def polynomial(self, piece: NDArray[np.intp]) -> Floats:
        """Coefficients of each lane's piece, (terms, lanes)."""
        if self.coefficients.ndim == 3:
            return np.asarray(self.coefficients[piece, :, np.arange(piece.size)].T)
        return np.asarray(self.coefficients[piece].T)


def of_law(name: str, parameters: Mapping[str, ArrayLike]) -> Data:
    """A law of slip that is given in pieces, over its scale."""
    _, breaks, polynomials = PIECES[name]
    rows = polynomials(**{n: np.asarray(value, dtype=np.float64) for n, value in parameters.items()})
    found = np.array(np.broadcast_arrays(*(c for row in rows for c in row)))
    return Data(np.array(breaks), found.reshape(len(rows), -1, *found.shape[1:]), np.zeros(len(rows)))


def lines(places: Floats, values: Floats, before: float, after: float) -> Data:
    """Straight lines between samples, and what holds before the first and after the last."""
    slope = np.diff(values) / np.diff(places)
    breaks = np.concatenate([[places[0] - 1.0], places])
    heights = np.concatenate([[before], values[:-1], [after]])
    slopes = np.concatenate([[0.0], slope, [0.0]])
    jumps = np.zeros_like(heights)
    jumps[1], jumps[-1] = values[0] - before, after - values[-1]
    return Data(breaks, np.stack([heights, slopes], axis=1), jumps)


def waves(start: float, duration: float, amplitude: float, rate: float) -> Data:
    """A sine from its start to its end, and nothing before and after."""
    coefficients = np.array([[0.0, 0.0, 0.0], [amplitude, rate, 0.0], [0.0, 0.0, 0.0]])
    return Data(np.array([start - 1.0, start, start + duration]), coefficients, np.zeros(3), sine=True)


def monotone(places: Floats, values: Floats, smooth_start: bool = False) -> Data:
    """Monotone cubic interpolation (Fritsch and Carlson 1980), the last value beyond, smoothly.

    Slopes inside are weighted harmonic means (Fritsch and Butland 1984); the first is the parabola's through three
    points, limited, or 0.
    """
    step, secant = np.diff(places), np.diff(values) / np.diff(places)
    slope = np.zeros_like(values)
    if places.size > 2:
        first, second = 2 * step[1:] + step[:-1], step[1:] + 2 * step[:-1]
        with np.errstate(divide="ignore", invalid="ignore"):
            mean = (first + second) / (first / secant[:-1] + second / secant[1:])
        slope[1:-1] = np.where(secant[:-1] * secant[1:] > 0.0, mean, 0.0)
    if not smooth_start:
        slope[0] = secant[0] if places.size == 2 else _first_slope(step[0], step[1], secant[0], secant[1])
    bend, twist = (3 * secant - 2 * slope[:-1] - slope[1:]) / step, (slope[:-1] + slope[1:] - 2 * secant) / step**2
    pieces = np.stack([values[:-1], slope[:-1], bend, twist], axis=1)
    return Data(places, np.vstack([pieces, [values[-1], 0.0, 0.0, 0.0]]), np.zeros(places.size))


def _first_slope(near: float, next_: float, first: float, second: float) -> float:
    """One-sided slope at the table's start that keeps the interpolation monotone."""
    slope = ((2 * near + next_) * first - near * second) / (near + next_)
    if slope * first <= 0.0:
        return 0.0
    return float(min(slope, 3 * first, key=abs) if first * second <= 0.0 else slope)


def of_speed(speeds: Floats, values: Floats) -> Data:
    """Monotone cubics in the logarithm of the speed, the end values beyond: pieces begin at speeds, the first at 0."""
    found = monotone(np.log(speeds), values, smooth_start=True)
    first = np.array([[values[0], 0.0, 0.0, 0.0]])
    breaks = np.concatenate([[0.0], speeds])
    return Data(breaks, np.vstack([first, found.coefficients]), np.zeros(breaks.size))


def of_list(argument: str, places: Floats, values: Floats) -> Data:
    """A friction law given as a table of slip, speed or time."""
    if argument == "slip":
        return monotone(places, values)
    if argument == "speed":
        return of_speed(places, values)
    return lines(places, values, float(values[0]), float(values[-1]))


def of_time(function: Any) -> Data:
    """A `Series` or `Pulse`."""
    if isinstance(function, Series):
        first, last = (function.values[0], function.values[-1]) if function.held else (0.0, 0.0)
        return lines(function.time, function.values, float(first), float(last))
    if not isinstance(function, Pulse):
        raise TypeError(f"{function!r} is no Series or Pulse")
    start, duration, top = function.start, function.duration, function.amplitude
    if function.name == "rectangular":
        return lines(np.array([start, start + duration]), np.array([top, top]), 0.0, 0.0)
    if function.name == "triangular":
        times = np.array([start, start + duration / 2, start + duration])
        return lines(times, np.array([0.0, top, 0.0]), 0.0, 0.0)
    half_waves = 2 * function.cycles if function.name == "sine" else 1.0
    return waves(start, duration, top, np.pi * half_waves / duration)


# --- functions known by their values ---------------------------------------------------------------------------------

TERMS = 8  # of a piece
_NODES = np.cos(np.pi * (np.arange(TERMS) + 0.5) / TERMS)
# T_0 to T_7 by powers of 1 + x, what is beyond a piece's left end over half its length.
_POWERS = np.array(
    [Chebyshev.basis(k)(Polynomial([-1.0, 1.0])).coef.tolist() + [0.0] * (TERMS - 1 - k) for k in range(TERMS)]
).T
_TO_CHEBYSHEV = np.linalg.inv(np.cos(np.outer(np.arccos(_NODES), np.arange(TERMS))))
_SHORTEST = 2e-3  # width of a piece, rad


def between_kinks(
    function: Callable[[Any], Any], kinks: Floats, least: Floats, most: Floats, tolerance: float
) -> tuple[Floats, Floats]:
    """Functions of the rotation in pieces that are halved until they are polynomials of degree 7.

    Parameters
    ----------
    function : callable
        Takes rotations (M, n), rad, and returns values (functions, M, n).
    kinks : ndarray
        Rotations at which a function may not be smooth, (kinks, n), increasing.
    least, most : ndarray
        Between which the functions are needed, (n,); beyond, each is a constant.
    tolerance : float
        The first coefficient of Chebyshev that a piece leaves out, over the greatest value.

    Returns
    -------
    breaks : ndarray
        Where pieces begin, (pieces, n).
    coefficients : ndarray
        In powers of what is beyond, (pieces, TERMS, functions, n).
    """
    widest = 2 * (tolerance * 2.0 ** (TERMS - 1) * math.factorial(TERMS)) ** (1 / TERMS)  # if no derivative exceeds 1
    first, last = _between(kinks, least, most, widest)
    starts, coefficients = list[Floats](), list[Floats]()
    scale = 0.0
    while len(first):
        chebyshev = _chebyshev(function, first, last)
        scale = max(scale, float(np.abs(chebyshev).max(initial=0.0)))
        rough = _remainder(chebyshev).max(axis=(1, 2)) > tolerance * scale
        rough &= (last - first).max(axis=1) > _SHORTEST
        starts.append(first[~rough])
        coefficients.append(_in_powers(chebyshev[~rough], (last - first)[~rough]))
        middle = (first[rough] + last[rough]) / 2
        first, last = np.concatenate([first[rough], middle]), np.concatenate([middle, last[rough]])
    end = np.broadcast_to(most, starts[0].shape[1:])[None]
    return _in_order(np.concatenate(starts), np.concatenate(coefficients), end, function(end)[:, 0])


def _in_order(starts: Floats, coefficients: Floats, end: Floats, value: Floats) -> tuple[Floats, Floats]:
    """Breaks and coefficients of pieces from the least rotation on; beyond the end a constant."""
    constant = np.zeros((1, *coefficients.shape[1:]))
    constant[0, 0] = value
    order = np.argsort(starts.sum(axis=1), kind="stable")
    return np.concatenate([starts[order], end]), np.concatenate([coefficients[order], constant])


def _remainder(chebyshev: Floats) -> Floats:
    """The size of the coefficients that come next, as the last two pairs of them fall, (pieces, functions, n)."""
    last = np.abs(chebyshev[:, -2:]).max(axis=1)
    before = np.abs(chebyshev[:, -4:-2]).max(axis=1)
    return np.asarray(last * np.minimum(last / np.where(before > 0.0, before, 1.0), 1.0))


def _between(kinks: Floats, least: Floats, most: Floats, widest: float) -> tuple[Floats, Floats]:
    """Both ends of the pieces to begin with, (pieces, n), none wider than some."""
    edges = np.concatenate([[least], np.clip(kinks, least, most), [most]])
    step = np.diff(edges, axis=0)
    count = np.ceil(step.max(axis=1) / widest - 1e-9).astype(np.intp)
    count[step.max(axis=1) <= 1e-13] = 0
    piece = np.repeat(np.arange(len(step)), count)
    number = np.arange(len(piece)) - np.repeat(np.cumsum(count) - count, count)
    first = edges[piece] + step[piece] * (number / count[piece])[:, None]
    last = edges[piece] + step[piece] * ((number + 1) / count[piece])[:, None]
    at_end = number + 1 == count[piece]
    last[at_end] = edges[1:][piece[at_end]]
    return first, last


def in_pieces(function: Callable[[Any], Any], breaks: Floats) -> Floats:
    """Coefficients of other functions in the same pieces, (pieces, TERMS, functions); the last one is constant.

    Those of ``function`` take rotations (M, 1) and return values (functions, M, 1); ``breaks`` are (pieces,).
    """
    end = function(breaks[-1:, None])
    constant = np.zeros((1, TERMS, len(end)))
    constant[0, 0] = end[:, 0, 0]
    if len(breaks) == 1:
        return constant
    first, last = breaks[:-1, None], breaks[1:, None]
    coefficients = _in_powers(_chebyshev(function, first, last), last - first)
    return np.concatenate([coefficients[..., 0], constant])


def _chebyshev(function: Callable[[Any], Any], first: Floats, last: Floats) -> Floats:
    """Coefficients of Chebyshev of functions on pieces (pieces, n): (pieces, TERMS, functions, n)."""
    half = (last - first) / 2
    rotation = first[:, None] + half[:, None] * (1.0 + _NODES[:, None])  # pieces, nodes, n
    values = function(rotation.reshape(-1, rotation.shape[-1]))
    return np.einsum("kj,fpjn->pkfn", _TO_CHEBYSHEV, values.reshape(len(values), *rotation.shape))


def _in_powers(chebyshev: Floats, width: Floats) -> Floats:
    """The same in powers of what is beyond the beginning of each piece."""
    powers = np.einsum("tk,pkfn->ptfn", _POWERS, chebyshev)
    half = np.where(width > 0.0, width / 2, np.inf)
    return np.asarray(powers / half[:, None, None] ** np.arange(TERMS)[:, None, None])


_CHECK = np.cos(np.pi * np.arange(2 * TERMS + 1) / (2 * TERMS))
CLOSE = 1e-13
NARROWEST = 2.0**-40


def sampled(function: Callable[[Any], Any], end: float, known: Data | None = None) -> Data:
    """A Python function of slip up to an end, on from a known table; right to 1e-13 of its greatest value.

    Raises
    ------
    ValueError
        Where it gives no numbers, negative ones, another shape than that of its argument, or is not smooth enough to
        be followed: says where.
    """
    breaks, pieces, left = list[float](), list[Floats](), 0.0
    if known:
        *breaks, left = known.breaks.tolist()
        pieces = list(known.coefficients[:-1])
    width = end - left
    while left < end:
        width = min(width, end - left)
        piece = _piece(function, left, width)
        if piece is None:
            width /= 2
            if width < NARROWEST * end:
                raise ValueError(
                    f"friction: the function changes too sharply near {left:.17g} to be followed; give a law by "
                    "name or a table whose kinks are known"
                )
            continue
        breaks.append(left)
        pieces.append(piece)
        left += width
        width *= 2
    return Data(np.array([*breaks, end]), np.array([*pieces, pieces[-1]]), np.zeros(len(breaks) + 1), open=True)


def _piece(function: Callable[[Any], Any], left: float, width: float) -> Floats | None:
    """A function's coefficients in powers of what is beyond the left end; None where they do not come close to it."""
    half = width / 2
    values = _values(function, left + half * (1.0 + np.concatenate([_NODES, _CHECK])))
    chebyshev = np.polynomial.chebyshev.chebfit(_NODES, values[:TERMS], TERMS - 1)
    error = np.abs(np.polynomial.chebyshev.chebval(_CHECK, chebyshev) - values[TERMS:]).max()
    if error > CLOSE * np.abs(values).max():
        return None
    centred = Polynomial(np.polynomial.chebyshev.cheb2poly(chebyshev))
    coefficients = centred(Polynomial([-1.0, 1.0 / half])).coef
    return np.pad(coefficients, (0, TERMS - coefficients.size))


def _values(function: Callable[[Any], Any], asked: Floats) -> Floats:
    """What a user's function gives, checked."""
    try:
        found = np.asarray(function(asked))
        if found.dtype.kind == "c":
            raise ValueError("complex numbers")
        found = found.astype(np.float64)
    except Exception as error:  # whatever it does, what is wrong is the function
        said = f"must take an array of numbers and return one; it says {type(error).__name__}: {error}"
        raise ValueError(f"friction: {said}") from error
    if found.ndim == 0:
        found = np.full(asked.shape, float(found))
    if found.shape != asked.shape:
        said = f"returns shape {found.shape} for an argument of shape {asked.shape}: must be alike"
        raise ValueError(f"friction: {said}")
    bad = ~np.isfinite(found) | (found < 0.0)
    if np.any(bad):
        k = int(np.argmax(bad))
        raise ValueError(f"friction({float(asked[k]):.6g}) = {float(found[k])!r}: must be a number of at least 0")
    return found
