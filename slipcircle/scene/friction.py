"""Friction as a function of slip, speed or time: laws by name from `generated.effects`, tables, Python callables."""

from bisect import bisect_right
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import laws
from generated.effects import LAWS
from slipcircle.base.checks import mistakes, number

Floats = NDArray[np.float64]


class Friction(NamedTuple):
    """A friction law with its numbers.

    Attributes
    ----------
    law : str
        Its name, or "callable". The numbers may be arrays, of lanes with the same law.
    coefficient : callable
        ``coefficient(slip, speed=0.0, time=0.0)``, in m, m/s and s.
    drop : callable
        ``drop(slip, more)``: by how much the coefficient falls over ``more`` slip, without cancellation.
    scale : float
        Slip over which it changes, m; infinite where it does not or is not known.
    kinks, speeds, times : tuple of float
        Slips in m, speeds in m/s and times in s at which it is not smooth.
    parameters : mapping
    depends_on : tuple of str
        Of slip, speed, time: what it depends on.
    """

    law: str
    coefficient: Callable[..., Any]
    drop: Callable[[Any, Any], Any]
    scale: Any
    kinks: tuple[Any, ...]
    parameters: Mapping[str, Any]
    depends_on: tuple[str, ...] = ("slip",)
    speeds: tuple[float, ...] = ()
    times: tuple[float, ...] = ()

    @property
    def constant(self) -> bool:
        """Whether it depends on nothing."""
        return not self.depends_on

    @property
    def settled(self) -> Any:
        """Slip from which on it is constant, m."""
        if self.law == "exponential":
            return 750 * self.scale  # exp(-750) is 0
        return 0.0 if self.constant else self.kinks[-1] if self.kinks else np.inf


def law_mistakes(given: Any) -> list[str]:
    """A sentence for each mistake in a scene's friction."""
    if callable(given):
        return []
    if not isinstance(given, Mapping):
        return mistakes(
            {"friction": given},
            {"friction": (-5e-324, np.inf, "a friction coefficient, tan(phi): a number of at least 0")},
        )
    found = _named_mistakes(given, "friction", tuple(LAWS))
    if not found and "rate" in given:
        if "speed" in LAWS[given["law"]].depends_on or "time" in LAWS[given["law"]].depends_on:
            found.append(f"friction.rate: {given['law']} is no law of slip; leave one out")
        elif not isinstance(given["rate"], Mapping):
            found.append(f"friction.rate = {given['rate']!r}: must be a law of speed with its parameters")
        else:
            found += _named_mistakes(given["rate"], "friction.rate", RATE_LAWS)
    return found


RATE_LAWS = tuple(name for name, law in LAWS.items() if law.depends_on == ("speed",))


def _named_mistakes(given: Mapping[str, Any], path: str, known: tuple[str, ...]) -> list[str]:
    """A sentence for each mistake in a law by name."""
    name = given.get("law")
    if name not in known:
        return [f"{path}.law = {name!r}: must be one of {', '.join(known)}"]
    wanted = {p.name: p for p in LAWS[name].parameters}
    rest = {k: v for k, v in given.items() if k != "law" and (k, path) != ("rate", "friction")}
    found = [f"{path}.{n}: is missing: {p.help}" for n, p in wanted.items() if n not in rest]
    found += [f"{path}.{n}: is unknown; known are {', '.join(wanted)}" for n in rest if n not in wanted]
    bounds = {n: (p.lower, p.upper, f"{p.help}, {_range(p)}") for n, p in wanted.items() if n in rest}
    found += [f"{path}.{m}" for m in mistakes(rest, bounds)]
    first = wanted[next(iter(wanted))]
    if first.kind == "list" and not found:
        place, values = (np.asarray(given[n], dtype=float) for n in wanted)
        if place.ndim != 1 or place.shape != values.shape or place.size < 2:
            found.append(
                f"{path}.{first.name} and {path}.coefficient: must be two lists of equal length, two values at least"
            )
        elif name == "tabulated" and (place[0] != 0.0 or np.any(np.diff(place) <= 0.0)):
            found.append(f"{path}.slip: must start at 0 and increase")
        elif np.any(np.diff(place) <= 0.0):
            found.append(f"{path}.{first.name}: must increase")
    return found


def _range(p: Any) -> str:
    low = "at least 0" if p.lower < 0.0 else "positive"
    return f"{low}{' ' + p.unit if p.unit else ''}"


def law_names(given: Any) -> tuple[str, ...]:
    """The names of the law that a scene's ``friction`` stands for, and of the law of speed that multiplies it."""
    if callable(given):
        return ("callable",)
    if not isinstance(given, Mapping):
        return ("constant",)
    return (str(given["law"]), *([str(given["rate"]["law"])] if "rate" in given else []))


def law_name(given: Any) -> str:
    """The same in one."""
    return " times ".join(law_names(given))


def law_depends(given: Any) -> tuple[str, ...]:
    """What the law that a scene's ``friction`` stands for depends on: some of slip, speed, time."""
    if callable(given):
        return ("slip",)
    if not isinstance(given, Mapping):
        return ()
    return LAWS[given["law"]].depends_on + (("speed",) if "rate" in given else ())


def friction(given: Any) -> Friction:
    """The law that a scene's ``friction`` stands for: a number, a mapping with ``law``, or a callable of slip."""
    if callable(given):
        return Friction(
            "callable", lambda s, v=0.0, t=0.0: given(s), lambda s, more: given(s) - given(s + more), np.inf, (), {}
        )
    if not isinstance(given, Mapping):
        return _constant(number(given))
    if "rate" in given:
        one, other = _named({k: v for k, v in given.items() if k != "rate"}), _named(given["rate"])
        return one._replace(
            law=law_name(given),
            coefficient=lambda s, v=0.0, t=0.0: one.coefficient(s) * other.coefficient(s, v),
            parameters=given,
            depends_on=law_depends(given),
            speeds=other.speeds,
        )
    return _named(given)


def _constant(value: float) -> Friction:
    return Friction(
        "constant", lambda s, v=0.0, t=0.0: value, lambda s, more: 0.0 * more, np.inf, (), {"coefficient": value}, ()
    )


def _named(given: Mapping[str, Any]) -> Friction:
    """A law by name."""
    name, parameters = given["law"], {k: v for k, v in given.items() if k != "law"}
    law = LAWS[name]
    if name == "constant":
        return _constant(float(parameters["coefficient"]))
    if law.parameters[0].kind == "list":
        place, values = (np.asarray(given[p.name], dtype=float) for p in law.parameters)
        return _tabulated(name, place, values, parameters)
    numbers = {k: v if np.ndim(v) else float(v) for k, v in parameters.items()}
    formula = getattr(laws, f"friction_{name}")
    if law.depends_on == ("speed",):
        return Friction(
            name,
            lambda s, v=0.0, t=0.0: formula(v, **numbers),
            lambda s, more: 0.0 * more,
            np.inf,
            (),
            numbers,
            law.depends_on,
        )
    drop = getattr(laws, f"drop_{name}")
    rises = numbers["peak"] < numbers["residual"]  # what it rises by is added, or a low start is lost in a high end

    def coefficient(s: Any, v: Any = 0.0, t: Any = 0.0) -> Any:
        if np.ndim(rises):
            return np.where(rises, numbers["peak"] - drop(0.0, s, **numbers), formula(s, **numbers))
        return numbers["peak"] - drop(0.0, s, **numbers) if rises else formula(s, **numbers)

    return Friction(
        name,
        coefficient,
        lambda s, more: drop(s, more, **numbers),
        numbers[law.scale],
        tuple(numbers[k] for k in law.kinks),
        numbers,
    )


def _tabulated(name: str, place: Floats, values: Floats, parameters: Mapping[str, Any]) -> Friction:
    """A table of slip, of the logarithm of speed, or of time."""
    ends = tuple(place.tolist())
    if name == "tabulated":
        coefficient, drop = _cubic(place, values, smooth_start=False)
        return Friction(
            name, lambda s, v=0.0, t=0.0: coefficient(s), drop, float(np.diff(place).min()), ends[1:], parameters
        )
    if name == "prescribed":

        def still(s: Any, v: Any = 0.0, t: Any = 0.0) -> Any:
            return np.interp(t, place, values) if isinstance(t, np.ndarray) else float(np.interp(t, place, values))

        return Friction(name, still, lambda s, more: 0.0 * more, np.inf, (), parameters, ("time",), times=ends)
    of_log = _cubic(np.log(place), values, smooth_start=True)[0]
    tiny = float(place[0])

    def moving(s: Any, v: Any = 0.0, t: Any = 0.0) -> Any:
        return of_log(np.log(np.maximum(v, tiny)) if isinstance(v, np.ndarray) else float(np.log(max(v, tiny))))

    return Friction(name, moving, lambda s, more: 0.0 * more, np.inf, (), parameters, ("speed",), speeds=ends)


def _cubic(slip: Floats, values: Floats, smooth_start: bool) -> tuple[Callable[[Any], Any], Callable[[Any, Any], Any]]:
    """Monotone cubic interpolation (Fritsch and Carlson 1980), constant beyond the table; and how far it falls."""
    step, rise = np.diff(slip), np.diff(values)
    secant = rise / step
    slope = np.zeros_like(values)
    if slip.size > 2:
        same = secant[:-1] * secant[1:] > 0.0
        first, second = 2 * step[1:] + step[:-1], step[1:] + 2 * step[:-1]
        with np.errstate(divide="ignore", invalid="ignore"):
            mean = (first + second) / (first / secant[:-1] + second / secant[1:])
        slope[1:-1] = np.where(same, mean, 0.0)
    if not smooth_start:
        slope[0] = secant[0] if slip.size == 2 else _end(step[0], step[1], secant[0], secant[1])
    # The last value holds beyond the table; a zero slope there makes the law smooth.
    places, heights, rises, slopes = (x.tolist() for x in (slip, values, rise, slope))

    def coefficient(s: Any) -> Any:
        if isinstance(s, float):  # NumPy takes its time with one number
            x = min(max(s, places[0]), places[-1])
            n = min(bisect_right(places, x), len(places) - 1) - 1
            h = places[n + 1] - places[n]
            y = (x - places[n]) / h
            bent = slopes[n] * (1 - y) - slopes[n + 1] * y
            return heights[n] + rises[n] * y**2 * (3 - 2 * y) + h * y * (1 - y) * bent
        at = np.clip(np.asarray(s, dtype=float), slip[0], slip[-1])
        k = np.clip(np.searchsorted(slip, at, side="right") - 1, 0, slip.size - 2)
        z = (at - slip[k]) / step[k]
        left = values[k] + rise[k] * z**2 * (3 - 2 * z)
        return left + step[k] * z * (1 - z) * (slope[k] * (1 - z) - slope[k + 1] * z)

    def drop(s: Any, more: Any) -> Any:
        """From the cubic's own derivatives at s within its piece, so that no digit is lost; then piece by piece."""
        first = np.minimum(np.searchsorted(slip, s, side="right") - 1, slip.size - 2)
        h, z, room = step[first], (s - slip[first]) / step[first], np.maximum(slip[first + 1] - s, 0.0)
        a, b = slope[first], slope[first + 1]
        bend, twist = 3 * secant[first] - 2 * a - b, a + b - 2 * secant[first]
        rates = a + z * (2 * bend + 3 * twist * z), (bend + 3 * twist * z) / h, twist / h**2
        y = np.minimum(more, room)
        fallen = -y * (rates[0] + y * (rates[1] + y * rates[2]))
        if np.all(more <= room * (1 + 2.0**-49)):
            return fallen
        for k in range(int(np.min(first)) + 1, slip.size - 1):
            z = np.clip((s + more - slip[k]) / step[k], 0.0, 1.0) * (first < k)
            fallen -= rise[k] * z**2 * (3 - 2 * z) + step[k] * z * (1 - z) * (slope[k] * (1 - z) - slope[k + 1] * z)
        return fallen

    return coefficient, drop


def _end(near: float, next_: float, first: float, second: float) -> float:
    """One-sided slope at the table's start that keeps the interpolation monotone."""
    slope = ((2 * near + next_) * first - near * second) / (near + next_)
    if slope * first <= 0.0:
        return 0.0
    return min(slope, 3 * first, key=abs) if first * second <= 0.0 else float(slope)
