"""Uncertain numbers of a scene: distributions by name, in the unit of the scene file's key, or SciPy's frozen ones.

A distribution is its quantile function here, so that every way of sampling needs no more than points in (0, 1).
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated.effects import LAWS
from slipcircle.files.scenekeys import Key, Table, tables_of
from slipcircle.scene.friction import law_names

Floats = NDArray[np.float64]
INFINITY = math.inf
_FAR = 30.0  # standard deviations: what lies beyond has no probability in float64


def special() -> Any:
    """SciPy's special functions."""
    try:
        import scipy.special
    except ImportError as error:
        raise ImportError("distributions need SciPy: pip install 'slipcircle[scenes]'") from error
    return scipy.special


def _normal(p: Any, mean: float, std: float) -> Any:
    return mean + std * special().ndtri(p)


def _lognormal(p: Any, mean: float, std: float) -> Any:
    variance = math.log1p((std / mean) ** 2)
    return np.exp(_normal(p, math.log(mean) - variance / 2, math.sqrt(variance)))


def _uniform(p: Any, low: float, high: float) -> Any:
    return low + (high - low) * p


def _triangular(p: Any, low: float, mode: float, high: float) -> Any:
    width, left = high - low, mode - low
    rising, falling = low + np.sqrt(width * left * p), high - np.sqrt(width * (high - mode) * (1.0 - p))
    return np.where(width * p < left, rising, falling)


def _truncated(p: Any, mean: float, std: float, low: float, high: float) -> Any:
    ndtr, ndtri = special().ndtr, special().ndtri
    a, b = (low - mean) / std, (high - mean) / std
    if a > 0.0:  # by the mirror image: probabilities near 1 would lose their digits
        return mean - std * np.clip(ndtri(ndtr(-b) + (1.0 - p) * (ndtr(-a) - ndtr(-b))), -b, -a)
    return mean + std * np.clip(ndtri(ndtr(a) + p * (ndtr(b) - ndtr(a))), a, b)


class Distribution(NamedTuple):
    """A distribution that a scene file may name: its parameters, all needed, quantiles, rules and what it reaches."""

    help: str
    parameters: tuple[str, ...]
    quantile: Callable[..., Any]
    rules: Mapping[str, Callable[[Mapping[str, float]], bool]]
    reach: Callable[[Mapping[str, float]], tuple[float, float]]


_SPREAD = {"std must be above 0": lambda g: g["std"] > 0.0}
_ORDER = {"high must be above low": lambda g: g["high"] > g["low"]}
DISTRIBUTIONS: Mapping[str, Distribution] = {
    "normal": Distribution("Gaussian", ("mean", "std"), _normal, _SPREAD, lambda g: (-INFINITY, INFINITY)),
    "lognormal": Distribution(
        "its logarithm is normal; mean and std are the number's own", ("mean", "std"), _lognormal,
        _SPREAD | {"mean must be above 0": lambda g: g["mean"] > 0.0}, lambda g: (0.0, INFINITY),
    ),
    "uniform": Distribution("", ("low", "high"), _uniform, _ORDER, lambda g: (g["low"], g["high"])),
    "triangular": Distribution(
        "", ("low", "mode", "high"), _triangular,
        _ORDER | {"mode must be from low to high": lambda g: g["low"] <= g["mode"] <= g["high"]},
        lambda g: (g["low"], g["high"]),
    ),
    "truncated_normal": Distribution(
        "normal between low and high; mean and std are those before truncation", ("mean", "std", "low", "high"),
        _truncated,
        _SPREAD | _ORDER
        | {f"low and high must hold values within {_FAR:g} std of the mean":
           lambda g: g["low"] < g["mean"] + _FAR * g["std"] and g["high"] > g["mean"] - _FAR * g["std"]},
        lambda g: (g["low"], g["high"]),
    ),
}  # fmt: skip


@dataclass(frozen=True)
class Uncertain:
    """A number that is known by its distribution.

    Attributes
    ----------
    key : str
        What varies, as a scene file has it (``friction.angle_deg``) or in SI units (``friction``).
    distribution : str or scipy.stats frozen distribution
    parameters : mapping
        Of a distribution by name, in the key's unit.
    per_unit, tangent
        SI units in the key's unit; or whether the key is the angle of a coefficient, in degrees.
    """

    key: str
    distribution: Any
    parameters: Mapping[str, float] = field(default_factory=dict)
    per_unit: float = 1.0
    tangent: bool = False

    def drawn(self, p: Any) -> Any:
        """Quantiles, in the key's unit."""
        if isinstance(self.distribution, str):
            return DISTRIBUTIONS[self.distribution].quantile(p, **self.parameters)
        found = self.distribution
        return (found.ppf if hasattr(found, "ppf") else found.icdf)(p)

    def to_si(self, values: Any) -> Any:
        """Values in the key's unit as the scene has them."""
        return np.tan(np.deg2rad(values)) if self.tangent else np.asarray(values) * self.per_unit

    @property
    def moments(self) -> tuple[float, float]:
        """Mean and standard deviation, in the key's unit, to six digits at least."""
        if not isinstance(self.distribution, str):
            found = self.distribution
            return float(found.mean()), float((found.std if hasattr(found, "std") else found.standard_deviation)())
        if set(self.parameters) == {"mean", "std"}:
            return self.parameters["mean"], self.parameters["std"]
        # The trapezoidal rule in the score z, p = Phi(z): what remains is smooth, and its weight is a Gaussian.
        z = np.linspace(-8.0, 8.0, 1025)
        weight = np.exp(-z * z / 2)
        x = self.drawn(special().ndtr(z))
        mean = np.average(x, weights=weight)
        return float(mean), math.sqrt(np.average((x - mean) ** 2, weights=weight))

    def from_si(self, value: float) -> float:
        """A value of the scene in the key's unit."""
        return math.degrees(math.atan(value)) if self.tangent else value / self.per_unit

    def slope(self, value: float) -> float:
        """Derivative of what the scene has by the key's value."""
        return math.radians(1.0 + math.tan(math.radians(value)) ** 2) if self.tangent else self.per_unit

    @property
    def record(self) -> dict[str, Any]:
        """As JSON holds it."""
        if isinstance(self.distribution, str):
            return {"key": self.key, "distribution": self.distribution, **self.parameters}
        d = self.distribution
        if not hasattr(d, "kwds"):
            return {"key": self.key, "distribution": repr(d)}
        said = [*map(repr, map(float, d.args)), *(f"{k}={float(v)!r}" for k, v in sorted(d.kwds.items()))]
        return {"key": self.key, "distribution": f"scipy.stats.{d.dist.name}({', '.join(said)})"}


def distribution_mistakes(given: Any, limits: tuple[float, float]) -> list[str]:
    """A sentence for each mistake in a distribution whose numbers should stay within limits."""
    if not isinstance(given, Mapping):
        return []
    name = given.get("distribution")
    if name is None:
        return ["distribution: is missing: one of " + ", ".join(DISTRIBUTIONS)]
    if name not in DISTRIBUTIONS:
        near = get_close_matches(str(name), DISTRIBUTIONS, 1)
        asked = "".join(f"; did you mean {n}?" for n in near)
        return [f"distribution = {name!r}: must be one of {', '.join(DISTRIBUTIONS)}{asked}"]
    kind, rest = DISTRIBUTIONS[name], {k: v for k, v in given.items() if k != "distribution"}
    found = [f"{k}: is missing" for k in kind.parameters if k not in rest]
    found += [f"{k}: is unknown; known are {', '.join(kind.parameters)}" for k in rest if k not in kind.parameters]
    for k, v in rest.items():
        if k in kind.parameters and (isinstance(v, bool) or not isinstance(v, int | float) or not math.isfinite(v)):
            found.append(f"{k} = {v!r}: must be a finite number")
    if found:
        return found
    numbers = {k: float(v) for k, v in rest.items()}
    if found := [rule for rule, holds in kind.rules.items() if not holds(numbers)]:
        return found
    low, high = kind.reach(numbers)
    # The ends of a normal distribution have no meaning: samples out of bounds are counted instead.
    if math.isfinite(low) and low < limits[0]:
        found.append(f"reaches down to {low:g}, and must stay above {limits[0]:g}")
    if math.isfinite(high) and high > limits[1]:
        found.append(f"reaches up to {high:g}, and must stay below {limits[1]:g}")
    middle = float(kind.quantile(0.5, **numbers))
    if not found and not limits[0] <= middle <= limits[1]:
        found.append(f"its median {middle:g} must be between {limits[0]:g} and {limits[1]:g}")
    return found


def numbers_of(tables: Mapping[str, Table]) -> Iterator[tuple[str, str, str, Key]]:
    """Keys of a scene file that may be uncertain: table, key, name as in `Scene.numbers`, and the key itself."""
    for path, table in tables.items():
        for k, key in table.keys.items():
            if key.type in (float, (float, list)) and path != "arc.given" and key.name != "accuracy":
                constant = (path, key.name) == ("friction", "coefficient")
                name = key.name if path in ("", "arc") else "friction" if constant else f"{path}.{key.name}"
                yield path, k, name, key


def range_of(key: Key) -> tuple[float, float]:
    """Lowest and highest value of a key, in its unit."""
    limits = key.limits
    return limits.get("gt", limits.get("ge", -INFINITY)), limits.get("lt", INFINITY)


def keys_of() -> dict[str, Uncertain]:
    """The first key that a scene file has for each name in `Scene.numbers`, such as the angle of a friction."""
    found: dict[str, Uncertain] = {}
    for law in ("constant", *LAWS):
        for table, k, name, key in numbers_of(tables_of(law)):
            found.setdefault(name, Uncertain(f"{table}.{k}".lstrip("."), "", {}, key.per_unit, key.tangent))
    return found


def place(path: str, friction: Any) -> tuple[str, Uncertain, tuple[float, float]]:
    """What a path stands for, as a file has it or in SI units: name in `Scene.numbers`, units, and limits.

    Raises
    ------
    ValueError
        If a scene with this friction has no such number.
    """
    from slipcircle.scene.scene import bounds

    law, *rate = law_names(friction)
    known = {}
    for table, k, name, key in numbers_of(tables_of("constant" if law == "callable" else law, *rate)):
        if table == "friction" and law == "callable":
            continue
        known[f"{table}.{k}".lstrip(".")] = name, key
    if path in known:
        name, key = known[path]
        return name, Uncertain(path, "", {}, key.per_unit, key.tangent), range_of(key)
    if path in {name for name, _ in known.values()}:
        return path, Uncertain(path, ""), bounds([path]).get(path, (-INFINITY, INFINITY))
    near = get_close_matches(path, known, 1)
    asked = "".join(f"; did you mean {n}?" for n in near)
    raise ValueError(f"{path}: is no number of a scene{asked or '; known are ' + ', '.join(known)}")


def declared(given: Mapping[str, Any], friction: Any) -> tuple[dict[str, Uncertain], list[str]]:
    """Uncertain numbers by their names in `Scene.numbers`, and a sentence for each mistake."""
    found: dict[str, Uncertain] = {}
    said = []
    for path, value in given.items():
        if isinstance(value, Uncertain):
            found[path] = value
            continue
        try:
            name, blank, limits = place(path, friction)
        except ValueError as error:
            said.append(f"uncertain.{error}")
            continue
        if not isinstance(value, Mapping) and not hasattr(value, "ppf") and not hasattr(value, "icdf"):
            said.append(f"uncertain.{path} = {value!r}: must be a distribution: of scipy.stats, or a mapping such as "
                        "{'distribution': 'normal', 'mean': 10, 'std': 1}")  # fmt: skip
            continue
        said += [f"uncertain.{path}: {m}" for m in distribution_mistakes(value, limits)]
        if name in found:
            said.append(f"uncertain.{path}: {found[name].key} says the same; leave one out")
        if isinstance(value, Mapping):
            numbers = {k: v for k, v in value.items() if k != "distribution"}
            found[name] = replace(blank, distribution=value.get("distribution"), parameters=numbers)
        else:
            found[name] = replace(blank, distribution=value)
    return found, said
