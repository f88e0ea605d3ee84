"""Friction as a function of accumulated slip: laws by name from `generated.effects`, tables, and Python callables."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import balance
from generated.effects import LAWS
from slipcircle.checks import mistakes

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Friction:
    """A friction law with its numbers.

    Attributes
    ----------
    law : str
        Its name, or "callable".
    coefficient : callable
        ``coefficient(slip)``, slip in m.
    drop : callable
        ``drop(slip, more)``: by how much the coefficient falls over ``more`` slip, without cancellation.
    scale : float
        Slip over which it changes, m; infinite where it does not or is not known.
    kinks : tuple of float
        Slips at which it is not smooth, m.
    parameters : mapping
    """

    law: str
    coefficient: Callable[[Any], Any]
    drop: Callable[[Any, Any], Any]
    scale: float
    kinks: tuple[float, ...]
    parameters: Mapping[str, Any]

    @property
    def constant(self) -> bool:
        """Whether it does not depend on slip."""
        return self.law == "constant"

    @property
    def settled(self) -> float:
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
    name = given.get("law")
    if name not in LAWS:
        return [f"friction.law = {name!r}: must be one of {', '.join(LAWS)}"]
    wanted = {p.name: p for p in LAWS[name].parameters}
    rest = {k: v for k, v in given.items() if k != "law"}
    found = [f"friction.{n}: is missing: {p.help}" for n, p in wanted.items() if n not in rest]
    found += [f"friction.{n}: is unknown; known are {', '.join(wanted)}" for n in rest if n not in wanted]
    bounds = {n: (p.lower, p.upper, f"{p.help}, {_range(p)}") for n, p in wanted.items() if n in rest}
    found += [f"friction.{m}" for m in mistakes(rest, bounds)]
    if name == "tabulated" and not found:
        slip, values = np.asarray(given["slip"], dtype=float), np.asarray(given["coefficient"], dtype=float)
        if slip.ndim != 1 or slip.shape != values.shape or slip.size < 2:
            found.append(
                "friction.slip and friction.coefficient: must be two lists of equal length, two values at least"
            )
        elif slip[0] != 0.0 or np.any(np.diff(slip) <= 0.0):
            found.append("friction.slip: must start at 0 and increase")
    return found


def _range(p: Any) -> str:
    low = "at least 0" if p.lower < 0.0 else "positive"
    return f"{low}{' ' + p.unit if p.unit else ''}"


def law_name(given: Any) -> str:
    """The name of the law that a scene's ``friction`` stands for."""
    return "callable" if callable(given) else given["law"] if isinstance(given, Mapping) else "constant"


def friction(given: Any) -> Friction:
    """The law that a scene's ``friction`` stands for: a number, a mapping with ``law``, or a callable of slip."""
    if callable(given):
        return Friction("callable", given, lambda s, more: given(s) - given(s + more), np.inf, (), {})
    if not isinstance(given, Mapping):
        given = {"law": "constant", "coefficient": float(np.asarray(given))}
    name, parameters = given["law"], {k: v for k, v in given.items() if k != "law"}
    if name == "constant":
        value = float(parameters["coefficient"])
        return Friction(name, lambda s: value, lambda s, more: 0.0 * more, np.inf, (), parameters)
    if name == "tabulated":
        return _tabulated(
            np.asarray(given["slip"], dtype=float), np.asarray(given["coefficient"], dtype=float), parameters
        )
    law, numbers = LAWS[name], {k: float(v) for k, v in parameters.items()}
    coefficient, drop = getattr(balance, f"friction_{name}"), getattr(balance, f"drop_{name}")
    rises = numbers["peak"] < numbers["residual"]  # what it rises by is added, or a low start is lost in a high end
    return Friction(
        name,
        (lambda s: numbers["peak"] - drop(0.0, s, **numbers)) if rises else (lambda s: coefficient(s, **numbers)),
        lambda s, more: drop(s, more, **numbers),
        numbers[law.scale],
        tuple(numbers[k] for k in law.kinks),
        numbers,
    )


def _tabulated(slip: Floats, values: Floats, parameters: Mapping[str, Any]) -> Friction:
    """Monotone cubic interpolation (Fritsch and Carlson 1980), constant beyond the table."""
    step, rise = np.diff(slip), np.diff(values)
    secant = rise / step
    slope = np.zeros_like(values)
    if slip.size > 2:
        same = secant[:-1] * secant[1:] > 0.0
        first, second = 2 * step[1:] + step[:-1], step[1:] + 2 * step[:-1]
        with np.errstate(divide="ignore", invalid="ignore"):
            mean = (first + second) / (first / secant[:-1] + second / secant[1:])
        slope[1:-1] = np.where(same, mean, 0.0)
    slope[0] = secant[0] if slip.size == 2 else _end(step[0], step[1], secant[0], secant[1])
    # The last value holds beyond the table; a zero slope there makes the law smooth.

    def coefficient(s: Any) -> Any:
        at = np.clip(np.asarray(s, dtype=float), 0.0, slip[-1])
        k = np.clip(np.searchsorted(slip, at, side="right") - 1, 0, slip.size - 2)
        z = (at - slip[k]) / step[k]
        left = values[k] + rise[k] * z**2 * (3 - 2 * z)
        return left + step[k] * z * (1 - z) * (slope[k] * (1 - z) - slope[k + 1] * z)

    def drop(s: Any, more: Any) -> Any:
        """From the cubic's own derivatives at s within its piece, so that no digit is lost; then piece by piece."""
        first = int(np.clip(np.searchsorted(slip, s, side="right") - 1, 0, slip.size - 1))
        if first == slip.size - 1:
            return 0.0 * np.asarray(more)
        h, z = step[first], (s - slip[first]) / step[first]
        a, b = slope[first], slope[first + 1]
        bend, twist = 3 * secant[first] - 2 * a - b, a + b - 2 * secant[first]
        rates = a + z * (2 * bend + 3 * twist * z), (bend + 3 * twist * z) / h, twist / h**2
        y = np.minimum(more, slip[first + 1] - s)
        fallen = -y * (rates[0] + y * (rates[1] + y * rates[2]))
        for k in range(first + 1, slip.size - 1):
            z = np.clip((s + more - slip[k]) / step[k], 0.0, 1.0)
            fallen -= rise[k] * z**2 * (3 - 2 * z) + step[k] * z * (1 - z) * (slope[k] * (1 - z) - slope[k + 1] * z)
        return fallen

    return Friction("tabulated", coefficient, drop, float(step.min()), tuple(slip[1:].tolist()), parameters)


def _end(near: float, next_: float, first: float, second: float) -> float:
    """One-sided slope at the table's start that keeps the interpolation monotone."""
    slope = ((2 * near + next_) * first - near * second) / (near + next_)
    if slope * first <= 0.0:
        return 0.0
    return min(slope, 3 * first, key=abs) if first * second <= 0.0 else float(slope)
