"""Tables and keys of a scene file: name, unit and allowed values of each number.

They follow from the declarations in `generated.effects`, so that new effects and laws need no change here.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from difflib import get_close_matches
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from generated.effects import COHESION_LAWS, EFFECTS, LAWS, LIMITS, USUAL_FRICTION, Law, Parameter
from slipcircle.base import SCENE_FORMAT
from slipcircle.base.kinds import Names, NumberDict, Texts, ValueDict
from slipcircle.core import Arc, Scene, declared
from slipcircle.layers import RATE_LAWS, may_have_rate
from slipcircle.tabulated import GIVEN
from slipcircle.tree import path_of_part
from slipcircle.workbench.common.quantities import OBSERVABLE, Interval
from slipcircle.workbench.common.units import SYSTEMS, published

_SMALL, _LARGE = 0.01, 100.0  # bounds of keys beyond these only detect a wrong unit
_BELOW_0 = -5e-324  # lower bound that allows 0, since bounds are open
_NUMBERS = ("a number", "a list of numbers")
VARYING = ("number", "series", "line", "load")  # kinds of keys whose numbers may vary


@dataclass(frozen=True, slots=True)
class Key(Parameter):
    """Key of a scene file and the number that it gives, whose unit and bounds are in SI units.

    ``written`` is the unit of the key, which has ``per_unit`` SI units. With ``tangent`` the key is an angle in
    degrees, whose tangent is the number. ``allowed`` states the allowed values in the unit of the key. ``kind`` is
    "text", "name" (a text or a whole number), "flag", "number", "fixed" (a number that no scene varies), "list" (of
    numbers), "series" (a number or a list), "pair" and "points" (of two numbers), "line" (a number or points), "load"
    (a number or two), "seen" (a number or an interval), or words: "this|that".
    """

    written: str = ""
    tangent: bool = False

    @property
    def _is_closed(self) -> bool:
        """Whether 0, the lower bound, is allowed."""
        return self.lower == _BELOW_0

    @property
    def low(self) -> float:
        """Lower bound in the key's unit; it is open unless 0 is allowed."""
        return 0.0 if self._is_closed else float(self.from_si(self.lower))

    @property
    def high(self) -> float:
        """Open upper bound in the key's unit."""
        return float(self.from_si(self.upper))

    @property
    def limits(self) -> NumberDict:
        """Finite bounds in the key's unit by their names in JSON Schema: gt or ge, and lt."""
        every = {"ge" if self._is_closed else "gt": self.low, "lt": self.high}
        return {name: bound for name, bound in every.items() if abs(bound) < math.inf}

    @property
    def plain(self) -> "Key":
        """Declaration of the same number by its name and SI unit in the scene instead of its key and unit."""
        return replace(self, key=self.name, written=self.unit, per_unit=1.0)

    def in_unit(self, key: str, unit: str, ratio: float) -> "Key":
        """Return the declaration of the number for another key, whose unit is `ratio` times the unit of this key.

        `key` and `unit` are the name and the unit of the new key.
        """
        return replace(self, key=key, written=unit, per_unit=self.per_unit * ratio)

    def to_si(self, values: Any) -> Any:
        """Return values converted from the key's unit to SI units; angles of friction become coefficients."""
        return np.tan(np.deg2rad(values)) if self.tangent else np.asarray(values) * self.per_unit

    def from_si(self, values: Any) -> Any:
        """Return values converted from SI units to the key's unit; coefficients of friction may become angles."""
        return np.rad2deg(np.arctan(values)) if self.tangent else np.asarray(values) / self.per_unit

    def slope(self, value: float) -> float:
        """Return the derivative of the value in SI units with respect to the value in the key's unit."""
        return math.radians(1.0 + math.tan(math.radians(value)) ** 2) if self.tangent else self.per_unit

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
        if unit in ("", self.written):
            return self

        def bound(words: re.Match[str]) -> str:
            return f"{words[1]} {float(words[2]) / ratio:.6g}"

        allowed = re.sub(r"(above|below|least|most) ([-+.e\d]*\d)", bound, self.allowed)
        allowed = allowed.replace(f"({self.written})", f"({unit})")
        return replace(self.in_unit(name, unit, ratio), allowed=allowed)

    def convert(self, value: Any) -> Any:
        """Return a valid value of a file as an argument in SI units."""
        if self.kind == "seen" and isinstance(value, str):
            value = Interval.of_limit(value)
        if self.kind not in (*VARYING, "fixed", "list", "pair", "points", "seen"):
            return value.lower() if "|" in self.kind else value
        values = self.to_si(np.array(value, dtype=np.float64))
        if self.kind == "points" or (self.kind == "line" and values.ndim):
            return values
        plain = values.tolist()
        if isinstance(plain, list) and self.kind in ("pair", "seen"):
            return Interval(*plain) if self.kind == "seen" else tuple(plain)
        return plain

    def _number(self, value: Any) -> bool:
        """Return whether a value is a number within the bounds."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return False
        least = value >= self.low if self._is_closed else value > self.low
        return least and value < self.high and abs(value) < math.inf

    def _limit(self, value: Any) -> bool:
        """Return whether a value is a limit such as "<60" within the bounds."""
        return isinstance(value, str) and self._number(Interval.of_limit(value).limit)

    def _pair(self, value: Any) -> bool:
        """Return whether a value is a list of two numbers within the bounds."""
        return isinstance(value, list) and len(value) == 2 and all(map(self._number, value))


def worded(name: str, help: str, allowed: str = "text", kind: str = "text", optional: bool = True) -> Key:
    """Return the declaration of a key that is not a number.

    `allowed` describes the allowed values for messages, and `kind` is a kind of `Key`.
    """
    return Key(name, help=help, key=name, optional=optional, kind=kind, allowed=allowed)


class KeyTable(NamedTuple):
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

    def of_law(self, law_typed: Any) -> "KeyTable":
        """Return the table with the keys of the law most similar to ``law_typed``, or only with the key ``law``."""
        names = tuple(self.laws)
        near = get_close_matches(str(law_typed), names, 1)
        if not near:
            return self._replace(keys={"law": replace(self.laws[names[0]].keys["law"], kind="|".join(names))})
        chosen: KeyTable = self.laws[near[0]]
        return chosen._replace(title=self.title, required=self.required, laws=self.laws)

    @property
    def is_of_unknown_law(self) -> bool:
        """Whether `of_law` did not recognise the law; parameters of an unknown law cannot be checked."""
        return bool(self.laws) and self.keys["law"].kind not in self.laws


def tables_in(content: Any, name: str) -> ValueDict:
    """Return the tables (by name) inside a named table of a file's content; empty if it is absent or not a table."""
    table = content.get(name)
    return {k: one for k, one in table.items() if isinstance(one, Mapping)} if isinstance(table, Mapping) else {}


def fitted(table: KeyTable, content: Any = None, path: str = "") -> dict[str, KeyTable]:
    """Return a table and all tables inside it by path, adapted to a file's content: chosen laws and repeated tables."""
    entries = content if isinstance(content, Mapping) else {}
    if table.laws:
        table = table.of_law(entries.get("law", next(iter(table.laws))))
    by_path = {path: table}
    for name, inner in table.tables.items():
        if inner.repeats:
            each = inner._replace(repeats="", required=False)
            inner = KeyTable(inner.title, required=inner.required, repeats=inner.repeats)
            inner = inner._replace(tables=dict.fromkeys(tables_in(entries, name), each))
        by_path |= fitted(inner, entries.get(name), path_of_part(path, name))
    return by_path


_TEXT = {
    "format": worded(
        "format", "version of the keys; a newer one needs a newer slipcircle", SCENE_FORMAT, kind=SCENE_FORMAT
    ),
    "name": worded("name", "name of the scene, by default the file's"),
    "note": worded("note", "source of the numbers"),
}
_OF_SCENE = declared(Scene)
_TOP = (
    _OF_SCENE["initial_velocity"],
    _OF_SCENE["end_time"],
    Parameter(
        "accuracy",
        "",
        0.0,
        1.0,
        "requested relative error; a single scene: rounding",
        "accuracy",
        optional=True,
        kind="fixed",
    ),
)
ARC = tuple(declared(Arc).values())


def _number(key: Key, written: str = "", tangent: bool = False) -> Key:
    """Return the declaration of the key of a number or a list, with the bounds in the file's unit in words.

    `written` is the unit of the key, and with `tangent` the key is an angle.
    """
    key = replace(key, written=written, tangent=tangent)
    words = _bounds_in_words(key)
    one, many = (" ".join(filter(None, [of, words, written and f"({written})"])) for of in _NUMBERS)
    forms = {
        "list": many,
        "series": f"{one}, or {many}",
        "line": "a height (m), or a list of two points or more, [[x, y], [x, y], ...] (m)",
        "load": f"{one}, or two of them, [left, right]",
        "seen": one.replace("a number", 'a number, or an interval [low, high], low first, or a limit "<60",'),
    }
    return replace(key, allowed=forms.get(key.kind, one))


def _bounds_in_words(key: Key) -> str:
    """Return the bounds of a key in words, without those that only values in a wrong unit exceed."""
    low, high = key.low, key.high
    is_allowed = high > float(f"{high:g}")  # the bound in words: open ones lie a bit above it
    comparisons = {
        f"{'at least' if key.lower == _BELOW_0 else 'above'} {0.0 if 0.0 <= low < _SMALL else low:g}": low > -_LARGE,
        f"{'at most' if is_allowed else 'below'} {high:g}": high <= _LARGE,
    }
    return " and ".join(words for words, is_shown in comparisons.items() if is_shown)


@lru_cache(maxsize=512)
def keys_of(p: Parameter) -> dict[str, Key]:
    """Return the keys of a parameter by spelling; friction has a key for its angle and one for its coefficient."""
    name = p.key.rpartition(".")[2]
    if not name:
        return {}
    declaration = {field.name: getattr(p, field.name) for field in fields(p) if field.name != "dimensionless"}
    key = Key(**declaration | {"key": name})
    plain = {"flag": "true or false", "text": "text", "name": "text or a number"}
    if p.kind in plain or "|" in p.kind:
        return {name: replace(key, allowed=plain.get(p.kind, f"one of {p.kind.replace('|', ', ')}"))}
    if not p.unit and name.endswith("_deg"):
        coefficient = replace(key, key=p.name, optional=True)
        angle = _number(replace(key, help=f"{p.help}, as an angle", optional=True), "deg", tangent=True)
        # A coefficient beyond the usual ones was an angle.
        return {name: angle, p.name: replace(_number(coefficient), upper=USUAL_FRICTION[1])}
    _, spelt_unit, _ = published(name)
    unit = spelt_unit if p.per_unit != 1.0 else p.unit
    if not unit and p.unit:  # the key has the unit, such as MPa_K for Pa/K, without its separators
        between = iter(re.findall("[/ ]", p.unit))
        tail = name.removeprefix(f"{p.name}_")
        unit = re.sub("_", lambda _: next(between, " "), tail)
    return {name: _number(key, unit)}


def table_of(title: str, parameters: Iterable[Parameter], more: Mapping[str, Key] = {}, any_of: Names = ()) -> KeyTable:
    """Return a table with the keys of parameters and ``more`` keys; at least one key of ``any_of`` is required."""
    keys = {p: keys_of(p) for p in parameters}
    by_name = dict(more)
    alternatives: list[Names] = []
    needed: Texts = []
    for p, of_parameter in keys.items():
        by_name |= of_parameter
        if len(of_parameter) > 1 and not p.optional:
            alternatives.append(tuple(of_parameter))
        if p.name in any_of:
            needed += of_parameter
    return KeyTable(title, by_name, tuple(alternatives), tuple(needed))


def _laws(laws: Iterable[Law], title: str = "friction law") -> dict[str, KeyTable]:
    """Return a table for each law, by the name of the law. `title` describes the key `law`."""
    by_name = {law.name: law for law in laws}
    tables = {}
    for name, law in by_name.items():
        key = worded("law", title, f"one of {', '.join(by_name)}", name, name == "constant")
        tables[name] = table_of(law.help, law.parameters, {"law": key})
    return tables


_RATE = KeyTable("law of speed that multiplies the law of slip", laws=_laws(LAWS[name] for name in RATE_LAWS))
OF_SOIL = KeyTable("friction of the soil, by default none", laws=_laws(LAWS.values()))
RATE_OF_SOILS = _RATE._replace(title="law of speed that multiplies the friction of all soils")
_WITH_RATE = {
    law: table._replace(tables={"rate": _RATE} if may_have_rate(law) else {}) for law, table in OF_SOIL.laws.items()
}
FRICTION = KeyTable("friction on the slip surface", required=True, laws=_WITH_RATE)
EFFECT_TABLES = {
    name: table_of(effect.help, effect.parameters, any_of=effect.any_of) for name, effect in EFFECTS.items()
}
COHESION = KeyTable(EFFECTS["cohesion"].help, laws=_laws(COHESION_LAWS.values(), "law of slip of the cohesion"))
_, *_of_growth = EFFECTS["cohesion"].parameters
_growth = table_of("", _of_growth).keys
EFFECT_TABLES["cohesion"] = COHESION._replace(
    laws={law: table._replace(keys={**table.keys, **_growth}) for law, table in COHESION.laws.items()}
)
_GIVEN_TABLE = table_of("coefficients of the equation of motion, used instead of computed ones", GIVEN.values())
ARC_TABLE = table_of("the failed section", ARC)._replace(required=True, tables={"given": _GIVEN_TABLE})
_SEEN = []
for _q in OBSERVABLE.values():
    _most = LIMITS[_q.unit][1]
    _least = _BELOW_0 if _q.unit in ("s", "") else -_most
    _SEEN.append(
        Parameter(_q.name, _q.unit, _least, _most, f"observed {_q.label}", _q.head, optional=True, kind="seen")
    )
OBSERVED = table_of("observations of the motion, for `slipcircle backanalyse`", _SEEN)
REPORT = KeyTable(
    "heading of a report",
    {
        name: worded(name, help)
        for name, help in (
            ("title", "title, by default the name of the scene"),
            ("project", "project"),
            ("author", "author of the computation"),
            ("checker", "checker of the computation"),
        )
    },
)
OUTPUT = KeyTable(
    "how the command line prints",
    {
        "units": worded(
            "units",
            "units of tables, pictures and reports; JSON, CSV files, live pages and Python have SI units",
            f"one of {', '.join(SYSTEMS)}",
            "|".join(SYSTEMS).lower(),
        )
    },
)
FURTHER = {"observed": OBSERVED, "report": REPORT, "output": OUTPUT}
TOP = table_of("a scene of slipcircle", _TOP, _TEXT)
WITH_ARC = TOP._replace(tables={"arc": ARC_TABLE, "friction": FRICTION, **EFFECT_TABLES, **FURTHER})
