"""Tables and keys of a scene file, as a pydantic model and as a JSON Schema for editors.

They follow from the declarations in `generated.effects`, so that a new effect or law needs nothing here.
"""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any, Literal, NamedTuple, Union

import numpy as np

from generated.effects import EFFECTS, INFINITY, LAWS, Parameter
from slipcircle.files import slopekeys
from slipcircle.scene.arc import GIVEN, Arc
from slipcircle.scene.friction import RATE_LAWS


class Key(NamedTuple):
    """A key of a scene file: the argument that it stands for, what it is and may be, and how it becomes SI units."""

    name: str
    title: str
    allowed: str = "text"
    required: bool = False
    type: Any = str
    limits: Mapping[str, float] = {}
    convert: Callable[[Any], Any] = str
    per_unit: float = 1.0
    tangent: bool = False  # of the angle in degrees


class Table(NamedTuple):
    """A table of a scene file; exactly one key of each of ``one_of`` is needed, at least one of ``any_of``."""

    title: str
    keys: Mapping[str, Key]
    one_of: tuple[tuple[str, ...], ...] = ()
    any_of: tuple[str, ...] = ()


def _declare(name: str, key: str, unit: str, help: str, lower: float = 0.0, upper: float = INFINITY,
             per_unit: float = 1.0, optional: bool = False) -> Parameter:  # fmt: skip
    return Parameter(name, unit, lower, upper, help, key, per_unit, "", lambda value, scales: value, optional, "number")


_ANGLE: Any = {"lower": -INFINITY, "per_unit": math.pi / 180}
_TEXT = {"name": Key("name", "name of the scene, by default the file's"), "note": Key("note", "source of the numbers")}
_TOP = (
    _declare("initial_velocity", "initial_velocity_m_s", "m/s", "velocity along the arc at the start, positive "
             "down-slope, by default 0", -INFINITY, optional=True),
    _declare("end_time", "end_time_s", "s", "time of the end, by default when the mass rests", optional=True),
    _declare("accuracy", "accuracy", "", "relative error asked for", 0.0, 1.0, optional=True),
)  # fmt: skip
_ARC = (
    _declare("radius", "radius_m", "m", "radius of the slip circle"),
    _declare("theta_1", "theta_1_deg", "rad", "polar angle of the arc's first end; 270 is below the centre", **_ANGLE),
    _declare("theta_2", "theta_2_deg", "rad", "polar angle of the arc's second end, above the first", **_ANGLE),
    _declare("unit_weight", "unit_weight_kN_m3", "N/m^3", "unit weight", per_unit=1e3),
    _declare("gravity", "gravity_m_s2", "m/s^2", f"gravity, by default {Arc.gravity}", optional=True),
    _declare("width", "width_m", "m", f"length across the section, by default {Arc.width}", optional=True),
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
    said = {"gt": "above", "ge": "at least", "lt": "below"}
    words = " and ".join(f"{said[k]} {v:g}" for k, v in limits.items())
    allowed = " ".join(filter(None, ["a list of numbers" if many else "a number", words, unit and f"({unit})"]))

    def convert(given: Any) -> Any:
        return [float(to_si(v)) for v in given] if many else float(to_si(given))

    return Key(p.name, title, allowed, required, list if many else float, limits, convert,
               1.0 if tangent else float(to_si(1.0)), tangent)  # fmt: skip


def _keys(p: Parameter) -> dict[str, Key]:
    """The keys of a parameter; friction has two, for its angle and for the coefficient itself."""
    many = p.kind == "list"
    if not p.key:
        return {}
    if p.kind == "flag":
        return {p.key: Key(p.name, p.help, "true or false", False, bool, {}, bool)}
    if p.kind == "text":
        return {p.key: Key(p.name, p.help, "text", not p.optional)}
    if "|" in p.kind:
        choices = tuple(p.kind.split("|"))
        return {p.key: Key(p.name, p.help, f"one of {', '.join(choices)}", not p.optional, Literal[choices])}
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
            type=(float, list),
            allowed=f"{one.allowed}, or {many_of.allowed}",
            convert=lambda v: (many_of if isinstance(v, list) else one).convert(v),
        )
    return {p.key: key}


def _table(title: str, parameters: Iterable[Parameter], more: Mapping[str, Key] = {}) -> Table:
    keys = {p: _keys(p) for p in parameters}
    pairs = tuple(tuple(pair) for p, pair in keys.items() if len(pair) > 1 and not p.optional)
    return Table(title, dict(more) | {k: key for pair in keys.values() for k, key in pair.items()}, pairs)


def _law(name: str, known: tuple[str, ...] = tuple(LAWS)) -> Table:
    law = Key("law", "friction law", f"one of {', '.join(known)}", name != "constant", Literal[name])
    return _table(LAWS[name].help, LAWS[name].parameters, {"law": law})


def _may_have_rate(law: str) -> bool:
    """Whether a law may be multiplied by one of speed."""
    return not {"speed", "time"} & set(LAWS[law].depends_on)


def tables_of(law: str, rate: str = RATE_LAWS[0]) -> dict[str, Table]:
    """Every table that a scene file may have, by its path."""
    effects = {}
    for name, effect in EFFECTS.items():
        needed = [p for p in effect.parameters if p.name in effect.any_of]
        table = _table(effect.help, effect.parameters)
        effects[name] = table._replace(any_of=tuple(k for p in needed for k in _keys(p)))
    by_rate = {"friction.rate": _law(rate, RATE_LAWS)._replace(title="law of speed that multiplies that of slip")}
    return {
        "": _table("a scene of slipcircle", _TOP, _TEXT),
        "arc": _table("the failed section", _ARC),
        "arc.given": _table("coefficients of the equation of motion, taken as they are", _GIVEN),
        "friction": _law(law)._replace(title="friction on the slip surface"),
        **(by_rate if _may_have_rate(law) else {}),
        **effects,
    }


def model_of(*laws: str, rates: tuple[str, ...] = RATE_LAWS, uncertain: bool = False) -> Any:
    """The pydantic model of a scene file with one of these friction laws, and of these laws of speed.

    Its numbers may be uncertain.
    """
    try:
        from pydantic import ConfigDict, Field, create_model
    except ImportError as error:
        raise ImportError("scene files need pydantic: pip install 'slipcircle[scenes]'") from error

    def field(kind: Any, table_or_key: Table | Key, required: bool = False) -> Any:
        # A factory, unlike a default, does not show in the schema.
        more: dict[str, Any] = {} if required else {"default_factory": lambda: None}
        return (kind, Field(title=table_or_key.title, description=getattr(table_or_key, "allowed", None), **more))

    def model(name: str, table: Table, **tables: Any) -> Any:
        fields = {}
        for k, key in table.keys.items():
            number = Annotated[float, Field(**key.limits)]
            either = number | drawn if drawn and name != "given" and key.name != "accuracy" else number
            kinds = {float: either, list: list[number], (float, list): either | list[number]}
            fields[k] = field(kinds.get(key.type, key.type), key, key.required)
        needs: list[Any] = [{"oneOf": [{"required": [k]} for k in pair]} for pair in table.one_of]
        needs += [{"anyOf": [{"required": [k]} for k in table.any_of]}] if table.any_of else []
        config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, title=table.title,
                            json_schema_extra={"allOf": needs} if needs else {})  # fmt: skip
        return create_model(name, __config__=config, **fields, **tables)

    tables, drawn = tables_of(laws[0]), _distributions() if uncertain else None
    given = field(model("given", tables["arc.given"]), tables["arc.given"])
    by_rate: Any = Union.__getitem__(tuple(model(f"rate_{law}", _law(law, RATE_LAWS)) for law in rates))
    title = Table("law of speed that multiplies that of slip", {})
    friction: Any = Union.__getitem__(
        tuple(
            model(f"friction_{law}", _law(law), **({"rate": field(by_rate, title)} if _may_have_rate(law) else {}))
            for law in laws
        )
    )
    return model(
        "scene", tables[""],
        arc=field(model("arc", tables["arc"], given=given), tables["arc"], True),
        friction=field(friction, tables["friction"], True),
        **{name: field(model(name, tables[name]), tables[name]) for name in EFFECTS},
    )  # fmt: skip


def _distributions() -> Any:
    """The pydantic model of a distribution in place of a number."""
    from pydantic import ConfigDict, create_model

    from slipcircle.base.distributions import DISTRIBUTIONS

    models: list[Any] = []
    for name, kind in DISTRIBUTIONS.items():
        config = ConfigDict(
            extra="forbid", strict=True, title=f"{name} distribution, in the key's unit; {kind.help}".rstrip("; ")
        )
        fields: dict[str, Any] = {"distribution": (Literal[name], ...)} | dict.fromkeys(kind.parameters, (float, ...))
        models.append(create_model(name, __config__=config, **fields))
    return Union.__getitem__(tuple(models))


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a scene file: with an arc, or with a ground and a circle in its place."""
    found = model_of(*LAWS, uncertain=True).model_json_schema()
    found["properties"] |= slopekeys.schemas()
    found["required"].remove("arc")
    instead = [{"required": ["arc"], "not": {"anyOf": [{"required": [t]} for t in slopekeys.GEOMETRY]}},
               {"required": ["ground", "circle"], "not": {"required": ["arc"]}}]  # fmt: skip
    found["oneOf"] = instead
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **found}
