"""The numbers of a scene that may vary: found by their keys in a scene file, in its units, and put into scenes.

A grid, an uncertain number, a back-analysis and a derivative name a number in the same way: by its key
(``friction.angle_deg``), or in SI units by its name in `Scene.numbers` (``friction``).
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import Any

import numpy as np

from generated.effects import LAWS
from slipcircle.base.distributions import distribution_mistakes, made
from slipcircle.scene.friction import law_names
from slipcircle.scene.keys import Table, tables_of


@dataclass(frozen=True)
class Number:
    """A number of a scene.

    Attributes
    ----------
    key : str
        How people name it: a scene file's key, or the name.
    name : str
        In `Scene.numbers`.
    unit : str
        Of the key.
    low, high, closed
        Its open bounds, in the key's unit, and whether the lower one is allowed as well.
    per_unit, tangent
        SI units in the key's unit; or whether the key is the angle of a coefficient, in degrees.
    """

    key: str
    name: str
    unit: str = ""
    low: float = -math.inf
    high: float = math.inf
    closed: bool = False
    per_unit: float = 1.0
    tangent: bool = False

    def to_si(self, values: Any) -> Any:
        """Values in the key's unit as the scene has them."""
        return np.tan(np.deg2rad(values)) if self.tangent else np.asarray(values) * self.per_unit

    def from_si(self, values: Any) -> Any:
        """Values of the scene in the key's unit."""
        return np.rad2deg(np.arctan(values)) if self.tangent else np.asarray(values) / self.per_unit

    def slope(self, value: float) -> float:
        """Derivative of what the scene has by the key's value."""
        return math.radians(1.0 + math.tan(math.radians(value)) ** 2) if self.tangent else self.per_unit


def numbers(tables: Mapping[str, Table]) -> dict[str, Number]:
    """The numbers that tables of a scene file have, by key."""
    found = {}
    for path, table in tables.items():
        for k, key in table.keys.items():
            if key.kind in ("number", "series") and path != "arc.given" and key.name != "accuracy":
                constant = (path, key.name) == ("friction", "coefficient")
                name = key.name if path in ("", "arc") else "friction" if constant else f"{path}.{key.name}"
                shown, limits = f"{path}.{k}".lstrip("."), key.limits
                low, high = limits.get("gt", limits.get("ge", -math.inf)), limits.get("lt", math.inf)
                found[shown] = Number(shown, name, key.unit, low, high, "ge" in limits, key.per_unit, key.tangent)
    return found


def numbers_of(friction: Any) -> dict[str, Number]:
    """The numbers of a scene with this friction by their keys, and then by their names, in SI units."""
    law, *rate = law_names(friction)
    tables = tables_of("constant" if law == "callable" else law, *rate)
    known = numbers(tables)
    if law == "callable":
        known = {k: n for k, n in known.items() if not n.name.startswith("friction")}
    units = {f"{path}.{k}".lstrip("."): key.si for path, table in tables.items() for k, key in table.keys.items()}
    plain = [n for n in known.values() if not n.tangent]  # a friction has two keys, its angle and itself
    return known | {
        n.name: Number(n.name, n.name, units[n.key], float(n.to_si(n.low)), float(n.to_si(n.high)), n.closed)
        for n in plain
    }


def number_of(path: str, friction: Any) -> Number:
    """The number that a path stands for, a key of a scene file or a name in SI units.

    Raises
    ------
    ValueError
        If a scene with this friction has no such number.
    """
    known = numbers_of(friction)
    if path in known:
        return known[path]
    keys = [k for k in known if known[k].name != k]
    asked = "".join(f"; did you mean {n}?" for n in get_close_matches(path, keys, 1))
    raise ValueError(f"{path}: is no number of a scene{asked or '; known are ' + ', '.join(keys)}")


def keyed() -> dict[str, Number]:
    """The first key that a scene file has for each name in `Scene.numbers`, such as the angle of a friction."""
    found: dict[str, Number] = {}
    for law in ("constant", *LAWS):
        for number in numbers(tables_of(law)).values():
            found.setdefault(number.name, number)
    return found


@dataclass(frozen=True)
class Uncertain:
    """A number that is known by its distribution.

    Attributes
    ----------
    number : Number
    given : mapping or scipy.stats frozen distribution
        As a scene file has it, or SciPy's; in the number's unit.
    """

    number: Number
    given: Any

    @property
    def key(self) -> str:
        return self.number.key

    @cached_property
    def distribution(self) -> Any:
        """SciPy's."""
        return made(self.given) if isinstance(self.given, Mapping) else self.given

    def drawn(self, p: Any) -> Any:
        """Quantiles, in the number's unit."""
        found = self.distribution
        return (found.ppf if hasattr(found, "ppf") else found.icdf)(p)

    @property
    def moments(self) -> tuple[float, float]:
        """Mean and standard deviation, in the number's unit."""
        found = self.distribution
        return float(found.mean()), float((found.std if hasattr(found, "std") else found.standard_deviation)())

    @property
    def record(self) -> dict[str, Any]:
        """As JSON holds it."""
        if isinstance(self.given, Mapping):
            return {"key": self.key} | dict(self.given)
        d = self.given
        if not hasattr(d, "kwds"):
            return {"key": self.key, "distribution": repr(d)}
        said = [*map(repr, map(float, d.args)), *(f"{k}={float(v)!r}" for k, v in sorted(d.kwds.items()))]
        return {"key": self.key, "distribution": f"scipy.stats.{d.dist.name}({', '.join(said)})"}


def declared(given: Mapping[str, Any], friction: Any) -> tuple[dict[str, Uncertain], list[str]]:
    """Uncertain numbers by their names in `Scene.numbers`, and a sentence for each mistake."""
    found: dict[str, Uncertain] = {}
    said = []
    for path, value in given.items():
        if isinstance(value, Uncertain):
            found[path] = value
            continue
        try:
            number = number_of(path, friction)
        except ValueError as error:
            said.append(f"uncertain.{error}")
            continue
        if isinstance(value, Mapping):
            said += [f"uncertain.{path}: {m}" for m in distribution_mistakes(value, (number.low, number.high))]
        elif not hasattr(value, "ppf") and not hasattr(value, "icdf"):
            said.append(f"uncertain.{path} = {value!r}: must be a distribution: of scipy.stats, or a mapping such as "
                        "{'distribution': 'normal', 'mean': 10, 'std': 1}")  # fmt: skip
        if number.name in found:
            said.append(f"uncertain.{path}: {found[number.name].key} says the same; leave one out")
        found[number.name] = Uncertain(number, dict(value) if isinstance(value, Mapping) else value)
    return found, said
