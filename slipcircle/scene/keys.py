"""Tables and keys of a scene file: what each number is called there, its unit, and what it may be.

They follow from the declarations in `generated.effects`, so that a new effect or law needs nothing here.
"""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from generated.effects import EFFECTS, INFINITY, LAWS, LIMITS, Parameter
from slipcircle.scene.arc import ARC_BOUNDS, GIVEN, GRAVITY, WIDTH
from slipcircle.scene.friction import RATE_LAWS
from slipcircle.scene.stability import METHODS

ROUGHEST = 10.0  # friction coefficient that no soil has: more was an angle


class Key(NamedTuple):
    """A key of a scene file: the argument that it stands for, what it is and may be, and how it becomes SI units.

    ``kind`` is "text", "flag", "number", "list" (of numbers), "series" (a number or a list), "pair" and "points" (of
    two numbers), or words: "this|that".
    """

    name: str
    title: str
    allowed: str = "text"
    required: bool = False
    kind: str = "text"
    limits: Mapping[str, float] = {}
    convert: Callable[[Any], Any] = str
    per_unit: float = 1.0
    tangent: bool = False  # of the angle in degrees
    unit: str = ""  # of the key
    si: str = ""

    def wrong(self, value: Any) -> list[tuple[str, Any]]:
        """What is wrong with a value: places in a list, "" for the value itself, and what stands there."""
        if isinstance(value, list) and self.kind in ("list", "series"):
            return [(f"[{k}]", v) for k, v in enumerate(value) if not self._number(v)]
        if isinstance(value, list) and self.kind == "points" and len(value) > 1:
            return [(f"[{k}]", v) for k, v in enumerate(value) if not self._pair(v)][:1]
        right = {
            "text": isinstance(value, str), "flag": isinstance(value, bool), "list": False,
            "number": self._number(value), "series": self._number(value), "pair": self._pair(value),
            "points": False,
        }  # fmt: skip
        return [] if right.get(self.kind, value in self.kind.split("|")) else [("", value)]

    def _number(self, value: Any) -> bool:
        if isinstance(value, bool) or not isinstance(value, int | float) or not -INFINITY < value < INFINITY:
            return False
        low = self.limits.get("gt", -INFINITY) < value and self.limits.get("ge", -INFINITY) <= value
        return low and value < self.limits.get("lt", INFINITY)

    def _pair(self, value: Any) -> bool:
        return isinstance(value, list) and len(value) == 2 and all(map(self._number, value))


class Table(NamedTuple):
    """A table of a scene file; exactly one key of each of ``one_of`` is needed, at least one of ``any_of``.

    Of ``sets`` of keys all of one and none of the others.
    """

    title: str
    keys: Mapping[str, Key]
    one_of: tuple[tuple[str, ...], ...] = ()
    any_of: tuple[str, ...] = ()
    required: bool = False
    sets: tuple[tuple[str, ...], ...] = ()


def _declare(name: str, key: str, unit: str, help: str, lower: float = 0.0, upper: float = INFINITY,
             per_unit: float = 1.0, optional: bool = False) -> Parameter:  # fmt: skip
    return Parameter(name, unit, lower, upper, help, key, per_unit, "", lambda value, scales: value, optional, "number")


_TEXT = {"name": Key("name", "name of the scene, by default the file's"), "note": Key("note", "source of the numbers")}
_TOP = (
    _declare("initial_velocity", "initial_velocity_m_s", "m/s", "velocity along the arc at the start, positive "
             "down-slope, by default 0", -LIMITS["m/s"][1], LIMITS["m/s"][1], optional=True),
    _declare("end_time", "end_time_s", "s", "time of the end, by default when the mass rests", *LIMITS["s"],
             optional=True),
    _declare("accuracy", "accuracy", "", "relative error asked for", 0.0, 1.0, optional=True),
)  # fmt: skip
_ARC = tuple(
    _declare(name, key, unit, help, *ARC_BOUNDS[name][:2], per_unit, optional)
    for name, key, unit, help, per_unit, optional in (
        ("radius", "radius_m", "m", "radius of the slip circle", 1.0, False),
        (
            "theta_1",
            "theta_1_deg",
            "rad",
            "polar angle of the arc's first end; 270 is below the centre",
            math.pi / 180,
            False,
        ),
        ("theta_2", "theta_2_deg", "rad", "polar angle of the arc's second end, above the first", math.pi / 180, False),
        ("unit_weight", "unit_weight_kN_m3", "N/m^3", "unit weight", 1e3, False),
        ("gravity", "gravity_m_s2", "m/s^2", f"gravity, by default {GRAVITY}", 1.0, True),
        ("width", "width_m", "m", f"length across the section, by default {WIDTH}", 1.0, True),
    )
)
_GIVEN = [
    _declare(n, n, "", f"{n.replace('_', ' ')}, dimensionless", -INFINITY if n == "weight_moment" else 0.0)
    for n in GIVEN
]


def _number(p: Parameter, many: bool, title: str, unit: str, required: bool, to_si: Callable[[float], Any],
            to_file: Callable[[float], float], tangent: bool = False) -> Key:  # fmt: skip
    """The key of a number, or of a list of them, with the parameter's bounds in the file's unit."""
    limits = {} if p.lower == -INFINITY else {"gt": to_file(p.lower)}
    if p.lower == -5e-324:  # bounds are open, and zero is allowed
        limits = {"ge": 0.0}
    limits |= {"lt": to_file(p.upper)} if to_file(p.upper) < INFINITY else {}
    if p.key.endswith("_deg") and not p.unit and not tangent:
        limits["lt"] = ROUGHEST  # which is not told: who meets it gave an angle
    least, most = ARC_BOUNDS[p.name][:2] if p.name in ARC_BOUNDS else LIMITS.get(p.unit, (0.0, INFINITY))
    told = dict(limits)  # of what only a wrong unit passes the sign is enough
    if p.lower in (least, -most):
        told = {"gt": 0.0} if p.lower > 0.0 else {}
    if p.upper < most or tangent:
        told |= {k: v for k, v in limits.items() if k == "lt"}
    else:
        told.pop("lt", None)
    said = {"gt": "above", "ge": "at least", "lt": "below"}
    words = " and ".join(f"{said[k]} {v:g}" for k, v in told.items())
    allowed = " ".join(filter(None, ["a list of numbers" if many else "a number", words, unit and f"({unit})"]))

    def convert(given: Any) -> Any:
        return [float(to_si(v)) for v in given] if many else float(to_si(given))

    return Key(p.name, title, allowed, required, "list" if many else "number", limits, convert,
               1.0 if tangent else float(to_si(1.0)), tangent, unit, p.unit)  # fmt: skip


def _keys(p: Parameter) -> dict[str, Key]:
    """The keys of a parameter; friction has two, for its angle and for the coefficient itself."""
    many = p.kind == "list"
    if not p.key:
        return {}
    if p.kind == "flag":
        return {p.key: Key(p.name, p.help, "true or false", False, "flag", {}, bool)}
    if p.kind == "text":
        return {p.key: Key(p.name, p.help, "text", not p.optional)}
    if "|" in p.kind:
        return {p.key: Key(p.name, p.help, f"one of {p.kind.replace('|', ', ')}", not p.optional, p.kind)}
    if not p.unit and p.key.endswith("_deg"):
        return {
            p.key: _number(p, many, f"{p.help}, as an angle", "deg", False, lambda v: np.tan(np.deg2rad(v)),
                           lambda v: math.degrees(math.atan(v)), tangent=True),
            p.name: _number(p, many, p.help, "", False, float, float),
        }  # fmt: skip
    unit = p.unit
    if p.per_unit != 1.0:  # the key tells it, such as kN_m3 for N/m^3, but not what stands between
        between = iter(re.findall("[/ ]", p.unit))
        unit = re.sub("_", lambda _: next(between, " "), p.key.removeprefix(f"{p.name}_"))
    key = _number(p, many, p.help, unit, not p.optional, lambda v: v * p.per_unit, lambda v: v / p.per_unit)
    if p.kind == "series":
        one, many_of = key, _number(p, True, p.help, unit, False, lambda v: v * p.per_unit, lambda v: v / p.per_unit)
        key = key._replace(
            kind="series",
            allowed=f"{one.allowed}, or {many_of.allowed}",
            convert=lambda v: (many_of if isinstance(v, list) else one).convert(v),
        )
    return {p.key: key}


def _table(title: str, parameters: Iterable[Parameter], more: Mapping[str, Key] = {}) -> Table:
    keys = {p: _keys(p) for p in parameters}
    pairs = tuple(tuple(pair) for p, pair in keys.items() if len(pair) > 1 and not p.optional)
    return Table(title, dict(more) | {k: key for pair in keys.values() for k, key in pair.items()}, pairs)


def law_table(name: str, known: tuple[str, ...] = tuple(LAWS)) -> Table:
    law = Key("law", "friction law", f"one of {', '.join(known)}", name != "constant", name)
    return _table(LAWS[name].help, LAWS[name].parameters, {"law": law})


def may_have_rate(law: str) -> bool:
    """Whether a law may be multiplied by one of speed."""
    return not {"speed", "time"} & set(LAWS[law].depends_on)


def tables_of(law: str, rate: str = RATE_LAWS[0]) -> dict[str, Table]:
    """Every table that a scene file may have, by its path."""
    effects = {}
    for name, effect in EFFECTS.items():
        needed = [p for p in effect.parameters if p.name in effect.any_of]
        table = _table(effect.help, effect.parameters)
        effects[name] = table._replace(any_of=tuple(k for p in needed for k in _keys(p)))
    by_rate = {"friction.rate": law_table(rate, RATE_LAWS)._replace(title="law of speed that multiplies that of slip")}
    return {
        "": _table("a scene of slipcircle", _TOP, _TEXT),
        "arc": _table("the failed section", _ARC)._replace(required=True),
        "arc.given": _table("coefficients of the equation of motion, taken as they are", _GIVEN),
        "friction": law_table(law)._replace(title="friction on the slip surface", required=True),
        **(by_rate if may_have_rate(law) else {}),
        **effects,
    }


# --- real slopes -----------------------------------------------------------------------------------------------------


def _length(name: str, help: str, lower: float = 0.0) -> Parameter:
    return _declare(name, f"{name}_m", "m", help, lower, LIMITS["m"][1], optional=True)


def _weight(help: str, optional: bool = False) -> Parameter:
    return _declare("unit_weight", "unit_weight_kN_m3", "N/m^3", help, 0.0, 1e5, 1e3, optional)


def _points(name: str, title: str) -> dict[str, Key]:
    key = "points_m" if name == "ground" else f"{name}_m"
    return {key: Key(name, title, "a list of points, [[x, y], [x, y], ...] (m)", kind="points", convert=np.array)}


def _pair(name: str, title: str, form: str = "[least, greatest]") -> dict[str, Key]:
    said = f"two numbers, {form} (m)"
    return {f"{name}_m": Key(name, title, said, kind="pair", convert=lambda v: (float(v[0]), float(v[1])))}


_UPRIGHT = _declare("angle", "angle_deg", "rad", "its angle, at most 90", 0.0,
                    math.nextafter(math.pi / 2, 2.0), math.pi / 180, True)  # fmt: skip
SLOPING: Mapping[str, Table] = {  # in place of an arc
    "ground": _table(
        "a real slope, in place of [arc]",
        [_length("height", "height of a simple slope between level ground"), _UPRIGHT,
         _length("run", "its horizontal length", -5e-324), _weight("unit weight of the soil"),
         *_ARC[-2:], _length("base", "y of a firm layer below which no circle goes", -INFINITY)],
        _points("ground", "points of the surface from left to right"),
    )._replace(required=True, sets=(("points_m",), ("height_m", "angle_deg"), ("height_m", "run_m"))),
    "circle": _table(
        "its slip circle: given, or looked for by critical = \"bishop\"",
        [_length("radius", "radius"), _length("depth", "depth of the circle below the chord of these points"),
         _length("touching", "y of the level that the circle through these points touches", -INFINITY)],
        _pair("centre", "centre of the circle", "[x, y]") | _points("through", "two points of the circle")
        | _pair("between", "x between which the stretch of ground lies that is meant") | {
            "critical": Key("critical", "method by which the critical circle is looked for",
                            f"one of {', '.join(METHODS)}", kind="|".join(METHODS))},
    )._replace(required=True, sets=(
        ("centre_m", "radius_m"), ("through_m", "radius_m"), ("through_m", "depth_m"), ("through_m", "touching_m"),
        ("critical",),
    )),
    "water": _table("its water level, in place of r_u", [_weight("unit weight of water, by default 9.81", True)],
                    _points("level", "points of the level from left to right")),
    "search": _table(
        "what limits the search for the critical circle",
        [_length("depth", "least thickness of the mass, against skins", -5e-324),
         _declare("k_h", "k_h", "", "horizontal acceleration as a share of g, positive down-slope", -1.0, 1.0,
                  optional=True)],
        _pair("entry", "x of the upper end") | _pair("exit", "x of the lower end"),
    ),
}  # fmt: skip
_PLAUSIBLE = {"coefficient": 4.0, "cohesion_kPa": 1e5}


def sloping(tables: Mapping[str, Table]) -> dict[str, Table]:
    """The tables of a scene with a ground in place of an arc, and the soil of one."""
    found = {path: table for path, table in tables.items() if not path.startswith("arc")} | dict(SLOPING)
    for path in ("friction", "cohesion"):
        keys = {k: key._replace(limits={**key.limits, "lt": _PLAUSIBLE.get(k, key.limits["lt"])}) if key.limits else key
                for k, key in found[path].keys.items()}  # fmt: skip
        found[path] = found[path]._replace(keys=keys)
    return found
