"""Tables and keys of a scene file: name, unit and allowed values of each number.

They follow from the declarations in `generated.effects`, so that new effects and laws need no change here.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from generated.effects import COHESION_LAWS, EFFECTS, INFINITY, LAWS, LIMITS, USUAL_FRICTION, Law, Parameter
from slipcircle.base import SCENE_FORMAT
from slipcircle.base.kinds import Names, ValueDict
from slipcircle.core import ARC_BOUNDS, GRAVITY, RATE_LAWS, WIDTH, may_have_rate
from slipcircle.tabulated import GIVEN
from slipcircle.workbench.common.quantities import OBSERVABLE, Interval
from slipcircle.workbench.common.units import SYSTEMS, published

_MOST = {"N/m^3": 1e6, "Pa": 1e12, "Pa/m": 1e12}  # by SI unit: upper bounds that only values in a wrong unit exceed
VARYING = ("number", "series", "line", "load")  # kinds of keys whose numbers may vary


@dataclass(frozen=True)
class Number:
    """Declaration of a number of a scene: key and unit in files, name and unit in the scene, and bounds."""

    key: str = ""  # a scene file's key, or the name
    name: str = ""  # in `Scene.numbers`
    unit: str = ""  # of the key
    low: float = -math.inf  # open bounds, in the key's unit
    high: float = math.inf
    closed: bool = False  # whether the lower bound itself is allowed
    per_unit: float = 1.0  # size of the key's unit in SI units
    tangent: bool = False  # whether the key is the angle of a coefficient, in degrees
    si: str = ""  # unit of the name

    @property
    def plain(self) -> "Number":
        """Declaration of the same number by its name and SI unit in the scene instead of its key and unit."""
        low, high = float(self.to_si(self.low)), float(self.to_si(self.high))
        return Number(self.name, self.name, self.si, low, high, self.closed, si=self.si)

    def in_unit(self, key: str, unit: str, ratio: float) -> "Number":
        """Return the declaration of the number for another key, whose unit is ``ratio`` times the unit of this key."""
        low, high = self.low / ratio, self.high / ratio
        return replace(self, key=key, unit=unit, low=low, high=high, per_unit=self.per_unit * ratio)

    def to_si(self, values: Any) -> Any:
        """Return values converted from the key's unit to SI units; angles of friction become coefficients."""
        return np.tan(np.deg2rad(values)) if self.tangent else np.asarray(values) * self.per_unit

    def from_si(self, values: Any) -> Any:
        """Return values converted from SI units to the key's unit; coefficients of friction may become angles."""
        return np.rad2deg(np.arctan(values)) if self.tangent else np.asarray(values) / self.per_unit

    def slope(self, value: float) -> float:
        """Return the derivative of the value in SI units with respect to the value in the key's unit."""
        return math.radians(1.0 + math.tan(math.radians(value)) ** 2) if self.tangent else self.per_unit

    def holds(self, values: Any) -> Any:
        """Return whether each value, in the key's unit, is finite and within the bounds."""
        least = values >= self.low if self.closed else values > self.low
        return least & (values < self.high) & (abs(values) < math.inf)

    @property
    def limits(self) -> dict[str, float]:
        """Finite bounds in the key's unit by their names in JSON Schema: gt or ge, and lt."""
        low, high = {"ge" if self.closed else "gt": self.low}, {"lt": self.high}
        return (low if self.low > -math.inf else {}) | (high if self.high < math.inf else {})


class Key(NamedTuple):
    """Declaration of a key of a scene file: its argument, meaning and allowed values.

    ``kind`` is "text", "name" (a text or a whole number), "flag", "number", "fixed" (a number that no scene varies),
    "list" (of numbers), "series" (a number or a list), "pair" and "points" (of two numbers), "line" (a number or
    points), "load" (a number or two), "seen" (a number or an interval), or words: "this|that".
    """

    name: str
    title: str
    allowed: str = "text"
    required: bool = False
    kind: str = "text"
    number: Number = Number()

    def wrong(self, value: Any) -> list[tuple[str, Any]]:
        """Return the mistakes in a value, pairs of a place ("[2]", or "" for the value itself) and the wrong item."""
        if isinstance(value, list) and self.kind in ("list", "series"):
            return [(f"[{k}]", v) for k, v in enumerate(value) if not self._number(v)]
        if isinstance(value, list) and self.kind in ("points", "line") and len(value) > 1:
            return [(f"[{k}]", v) for k, v in enumerate(value) if not self._pair(v)][:1]
        right = dict.fromkeys(("number", "fixed", "series", "line"), self._number(value)) | {
            "load": self._number(value) or self._pair(value),
            "seen": self._number(value) or self._limit(value) or (self._pair(value) and value[0] < value[1]),
            "text": isinstance(value, str),
            "name": type(value) in (str, int),
            "flag": isinstance(value, bool),
            "pair": self._pair(value),
            "list": False,
            "points": False,
        }
        is_word = isinstance(value, str) and value.lower() in self.kind.split("|")
        return [] if right.get(self.kind, is_word) else [("", value)]

    def spelt(self, name: str) -> "Key":
        """Return the declaration for another spelling of the key, in the unit at the end of that spelling."""
        _, unit, ratio = published(name)
        if unit in ("", self.number.unit):
            return self

        def bound(words: re.Match[str]) -> str:
            return f"{words[1]} {float(words[2]) / ratio:.6g}"

        allowed = re.sub(r"(above|below|least|most) ([-+.e\d]*\d)", bound, self.allowed)
        allowed = allowed.replace(f"({self.number.unit})", f"({unit})")
        return self._replace(allowed=allowed, number=self.number.in_unit(name, unit, ratio))

    def convert(self, value: Any) -> Any:
        """Return a valid value of a file as an argument in SI units."""
        if self.kind == "seen" and isinstance(value, str):
            value = Interval.of_limit(value)
        if self.kind not in (*VARYING, "fixed", "list", "pair", "points", "seen"):
            return value.lower() if "|" in self.kind else value
        values = self.number.to_si(np.array(value, dtype=np.float64))
        if self.kind == "points" or (self.kind == "line" and values.ndim):
            return values
        plain = values.tolist()
        if isinstance(plain, list) and self.kind in ("pair", "seen"):
            return Interval(*plain) if self.kind == "seen" else tuple(plain)
        return plain

    def _number(self, value: Any) -> bool:
        return isinstance(value, int | float) and not isinstance(value, bool) and bool(self.number.holds(value))

    def _limit(self, value: Any) -> bool:
        return isinstance(value, str) and self._number(Interval.of_limit(value).limit)

    def _pair(self, value: Any) -> bool:
        return isinstance(value, list) and len(value) == 2 and all(map(self._number, value))


LENGTH = Number(unit="m", si="m")  # of points


class Table(NamedTuple):
    """Declaration of a table of a scene file.

    Exactly one key of each of ``one_of`` is required, and at least one key of ``any_of``. The keys present must match
    exactly one of the ``sets``. Tables inside it are in ``tables``, by name. A table with ``laws`` has the keys of the
    law that its key ``law`` chooses, by default the first. If ``repeats`` is "named", the declaration applies to any
    number of tables with arbitrary names; if it is "numbered", to the tables of a list [[...]], numbered from 1.
    """

    title: str
    keys: Mapping[str, Key] = {}
    one_of: tuple[Names, ...] = ()
    any_of: Names = ()
    required: bool = False
    sets: tuple[Names, ...] = ()
    repeats: str = ""
    tables: Mapping[str, Any] = {}
    laws: Mapping[str, Any] = {}

    def of_law(self, given: Any) -> "Table":
        """Return the table with the keys of the law most similar to ``given``; without one, ``law`` is its only key."""
        names = tuple(self.laws)
        near = get_close_matches(str(given), names, 1)
        if not near:
            law = self.laws[names[0]].keys["law"]._replace(kind="|".join(names))
            return self._replace(keys={"law": law})
        chosen: Table = self.laws[near[0]]
        return chosen._replace(title=self.title, required=self.required, laws=self.laws)

    @property
    def is_of_unknown_law(self) -> bool:
        """Whether `of_law` did not recognise the law; parameters of an unknown law cannot be checked."""
        return bool(self.laws) and self.keys["law"].kind not in self.laws


def joined(path: str, name: str) -> str:
    """Return the path of a key or a table inside a table."""
    return f"{path}.{name}" if path else name


def tables_in(content: Any, name: str) -> ValueDict:
    """Return the tables (by name) inside a named table of a file's content; empty if it is absent or not a table."""
    table = content.get(name)
    return {k: one for k, one in table.items() if isinstance(one, Mapping)} if isinstance(table, Mapping) else {}


def fitted(table: Table, content: Any = None, path: str = "") -> dict[str, Table]:
    """Return a table and all tables inside it by path, adapted to a file's content: chosen laws and repeated tables."""
    given = content if isinstance(content, Mapping) else {}
    if table.laws:
        table = table.of_law(given.get("law", next(iter(table.laws))))
    found = {path: table}
    for name, inner in table.tables.items():
        if inner.repeats:
            each = inner._replace(repeats="", required=False)
            inner = Table(inner.title, required=inner.required, repeats=inner.repeats)
            inner = inner._replace(tables=dict.fromkeys(tables_in(given, name), each))
        found |= fitted(inner, given.get(name), joined(path, name))
    return found


def declare(
    name: str,
    key: str,
    unit: str,
    help: str,
    lower: float = 0.0,
    upper: float = INFINITY,
    per_unit: float = 1.0,
    optional: bool = False,
    kind: str = "number",
) -> Parameter:
    """Return the declaration of a parameter that files read in the key's unit, ``per_unit`` SI units each."""
    return Parameter(name, unit, lower, upper, help, key, per_unit, "", lambda value, scales: value, optional, kind)


_TEXT = {
    "format": Key(
        "format", "version of the keys; a newer one needs a newer slipcircle", SCENE_FORMAT, False, SCENE_FORMAT
    ),
    "name": Key("name", "name of the scene, by default the file's"),
    "note": Key("note", "source of the numbers"),
}
_TOP = (
    declare(
        "initial_velocity",
        "initial_velocity_m_s",
        "m/s",
        "velocity along the arc at the start, positive down-slope, by default 0",
        -LIMITS["m/s"][1],
        LIMITS["m/s"][1],
        optional=True,
    ),
    declare("end_time", "end_time_s", "s", "end time, by default when the mass rests", *LIMITS["s"], optional=True),
    declare(
        "accuracy", "accuracy", "", "requested relative error; a single scene: rounding", 0.0, 1.0, 1.0, True, "fixed"
    ),
)
ARC = tuple(
    declare(name, key, unit, help, *ARC_BOUNDS[name][:2], per_unit, ", by default " in help)
    for name, key, unit, per_unit, help in (
        ("radius", "radius_m", "m", 1.0, "radius of the slip circle"),
        ("theta_1", "theta_1_deg", "rad", math.pi / 180, "polar angle of the arc's first end; 270 is below the centre"),
        ("theta_2", "theta_2_deg", "rad", math.pi / 180, "polar angle of the arc's second end, above the first"),
        ("unit_weight", "unit_weight_kN_m3", "N/m^3", 1e3, "unit weight"),
        ("gravity", "gravity_m_s2", "m/s^2", 1.0, f"gravity, by default {GRAVITY}"),
        ("width", "width_m", "m", 1.0, f"length across the section, by default {WIDTH}"),
    )
)
_GIVEN = [declare(n, n, "", f"{n.replace('_', ' ')}, dimensionless", *b[:2], kind="fixed") for n, b in GIVEN.items()]


def _number(p: Parameter, title: str, unit: str = "", required: bool = False, tangent: bool = False) -> Key:
    """Return the declaration of the key of a number or a list, with the parameter's bounds in the file's unit."""
    of = Number(p.key, p.name, unit, per_unit=p.per_unit, tangent=tangent, si=p.unit)
    closed = p.lower == -5e-324  # bounds are open, and zero is allowed
    of = replace(of, low=0.0 if closed else float(of.from_si(p.lower)), high=float(of.from_si(p.upper)), closed=closed)
    if p.key.endswith("_deg") and not p.unit and not tangent:
        of = replace(of, high=USUAL_FRICTION[1])  # not named in messages: a value beyond it was an angle
    words = _bounds_in_words(p, of)
    one, many = (" ".join(filter(None, [n, words, unit and f"({unit})"])) for n in ("a number", "a list of numbers"))
    forms = {
        "list": many,
        "series": f"{one}, or {many}",
        "line": "a height (m), or a list of two points or more, [[x, y], [x, y], ...] (m)",
        "load": f"{one}, or two of them, [left, right]",
        "seen": one.replace("a number", 'a number, or an interval [low, high], low first, or a limit "<60",'),
    }
    return Key(p.name, title, forms.get(p.kind, one), required, p.kind, of)


def _bounds_in_words(p: Parameter, number: Number) -> str:
    """Return a parameter's bounds in the file's unit, in words; only the sign if they just detect a wrong unit."""
    least, most = ARC_BOUNDS[p.name][:2] if p.name in ARC_BOUNDS else LIMITS.get(p.unit, (0.0, INFINITY))
    most = min(most, _MOST.get(p.unit, INFINITY))
    bounds = dict(number.limits)
    if p.lower in (least, -most):
        bounds = {"gt": 0.0} if p.lower >= 0.0 else {}
    bounds.pop("lt", None)
    if p.upper < most or number.tangent:
        bounds["lt"] = number.high
    is_allowed = number.high > float(f"{number.high:g}")  # the bound in words: open ones lie a bit above it
    comparisons = {"gt": "above", "ge": "at least", "lt": "at most" if is_allowed else "below"}
    return " and ".join(f"{comparisons[k]} {v:g}" for k, v in bounds.items())


def _keys(p: Parameter) -> dict[str, Key]:
    """Return the keys of a parameter by spelling; friction has a key for its angle and one for its coefficient."""
    plain = {"flag": "true or false", "text": "text", "name": "text or a number"}
    words = plain.get(p.kind, f"one of {p.kind.replace('|', ', ')}")
    if not p.key:
        return {}
    if p.kind in plain or "|" in p.kind:
        return {p.key: Key(p.name, p.help, words, not p.optional, p.kind)}
    if not p.unit and p.key.endswith("_deg"):
        angle = _number(p, f"{p.help}, as an angle", "deg", tangent=True)
        return {p.key: angle, p.name: _number(p, p.help)}
    _, known, _ = published(p.key)
    unit = known if p.per_unit != 1.0 else p.unit
    if not unit and p.unit:  # the key has the unit, such as MPa_K for Pa/K, without its separators
        between = iter(re.findall("[/ ]", p.unit))
        tail = p.key.removeprefix(f"{p.name}_")
        unit = re.sub("_", lambda _: next(between, " "), tail)
    return {p.key: _number(p, p.help, unit, not p.optional)}


def table_of(title: str, parameters: Iterable[Parameter], more: Mapping[str, Key] = {}, any_of: Names = ()) -> Table:
    """Return a table with the keys of parameters and ``more`` keys; at least one key of ``any_of`` is required."""
    keys = {p: _keys(p) for p in parameters}
    by_name = dict(more)
    alternatives: list[Names] = []
    needed: list[str] = []
    for p, of_parameter in keys.items():
        by_name |= of_parameter
        if len(of_parameter) > 1 and not p.optional:
            alternatives.append(tuple(of_parameter))
        if p.name in any_of:
            needed += of_parameter
    return Table(title, by_name, tuple(alternatives), tuple(needed))


def _laws(laws: Iterable[Law], title: str = "friction law") -> dict[str, Table]:
    """Return a table for each law, by the name of the law."""
    by_name = {law.name: law for law in laws}
    found = {}
    for name, law in by_name.items():
        key = Key("law", title, f"one of {', '.join(by_name)}", name != "constant", name)
        found[name] = table_of(law.help, law.parameters, {"law": key})
    return found


_RATE = Table("law of speed that multiplies the law of slip", laws=_laws(LAWS[name] for name in RATE_LAWS))
OF_SOIL = Table("friction of the soil, by default none", laws=_laws(LAWS.values()))
RATE_OF_SOILS = _RATE._replace(title="law of speed that multiplies the friction of all soils")
_WITH_RATE = {
    law: table._replace(tables={"rate": _RATE} if may_have_rate(law) else {}) for law, table in OF_SOIL.laws.items()
}
FRICTION = Table("friction on the slip surface", required=True, laws=_WITH_RATE)
EFFECT_TABLES = {
    name: table_of(effect.help, effect.parameters, any_of=effect.any_of) for name, effect in EFFECTS.items()
}
COHESION = Table(EFFECTS["cohesion"].help, laws=_laws(COHESION_LAWS.values(), "law of slip of the cohesion"))
_, *_of_growth = EFFECTS["cohesion"].parameters
_growth = table_of("", _of_growth).keys
EFFECT_TABLES["cohesion"] = COHESION._replace(
    laws={law: table._replace(keys={**table.keys, **_growth}) for law, table in COHESION.laws.items()}
)
_GIVEN_TABLE = table_of("coefficients of the equation of motion, used instead of computed ones", _GIVEN)
ARC_TABLE = table_of("the failed section", ARC)._replace(required=True, tables={"given": _GIVEN_TABLE})
_SEEN = []
for _q in OBSERVABLE.values():
    _most = LIMITS[_q.unit][1]
    _least = -5e-324 if _q.unit in ("s", "") else -_most
    _SEEN.append(declare(_q.name, _q.head, _q.unit, f"observed {_q.label}", _least, _most, 1.0, True, "seen"))
OBSERVED = table_of("observations of the motion, for `slipcircle backanalyse`", _SEEN)
REPORT = Table(
    "heading of a report",
    {
        "title": Key("title", "title, by default the name of the scene"),
        "project": Key("project", "project"),
        "author": Key("author", "author of the computation"),
        "checker": Key("checker", "checker of the computation"),
    },
)
OUTPUT = Table(
    "how the command line prints",
    {
        "units": Key(
            "units",
            "units of tables, pictures and reports; JSON, CSV files, live pages and Python have SI units",
            f"one of {', '.join(SYSTEMS)}",
            kind="|".join(SYSTEMS).lower(),
        )
    },
)
FURTHER = {"observed": OBSERVED, "report": REPORT, "output": OUTPUT}
TOP = table_of("a scene of slipcircle", _TOP, _TEXT)
WITH_ARC = TOP._replace(tables={"arc": ARC_TABLE, "friction": FRICTION, **EFFECT_TABLES, **FURTHER})
