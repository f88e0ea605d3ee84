"""Scenes as TOML files: read, checked with every mistake listed at once, and their JSON Schema for editors.

Tables and keys follow from the declarations in `generated.effects`, so that a new effect needs nothing here.
"""

import json
import math
import tomllib
from collections.abc import Callable, Mapping
from difflib import get_close_matches
from importlib import resources
from os import PathLike
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple, Union

import numpy as np

from generated.effects import EFFECTS, INFINITY, LAWS, Effect, Law, Parameter
from slipcircle.arc import GIVEN, Arc
from slipcircle.friction import law_mistakes
from slipcircle.scene import Scene


class Key(NamedTuple):
    """A key of a scene file: the argument that it stands for, what it is and may be, and how it becomes SI units."""

    name: str
    title: str
    allowed: str = "text"
    required: bool = False
    type: Any = str
    limits: Mapping[str, float] = {}  # noqa: RUF012
    convert: Callable[[Any], Any] = str


class Table(NamedTuple):
    """A table of a scene file; exactly one key of each of ``one_of`` is needed, at least one of ``any_of``."""

    title: str
    keys: Mapping[str, Key]
    one_of: tuple[tuple[str, ...], ...] = ()
    any_of: tuple[str, ...] = ()


def _number(
    name: str, title: str, unit: str = "", lower: float = 0.0, upper: float = INFINITY, *, required: bool = True,
    many: bool = False, to_si: Callable[[float], Any] = float, to_file: Callable[[float], float] = float,
) -> Key:  # fmt: skip
    """The key of a number, or of a list of them: unit in the file, open bounds in SI units, and what converts them."""
    limits, words = {}, []
    if lower == -5e-324:  # just below zero: zero is allowed
        limits["ge"], words = 0.0, ["at least 0"]
    elif lower > -INFINITY:
        limits["gt"], words = to_file(lower), [f"above {to_file(lower):g}"]
    if to_file(upper) < INFINITY:
        limits["lt"], words = to_file(upper), [*words, f"below {to_file(upper):g}"]
    allowed = " ".join(["a list of numbers" if many else "a number", " and ".join(words), f"({unit})"])

    def convert(given: Any) -> Any:
        return [float(to_si(v)) for v in given] if many else float(to_si(given))

    allowed = allowed.replace("  ", " ").removesuffix(" ()")
    return Key(name, title, allowed, required, list if many else float, limits, convert)


def _keys(p: Parameter, many: bool) -> dict[str, Key]:
    """The keys of a declared parameter; friction has two, for its angle and for the coefficient itself."""
    if not p.unit and p.key.endswith("_deg"):
        angle = _number(
            p.name, f"{p.help}, as an angle", "deg", p.lower, p.upper, required=False, many=many,
            to_si=lambda v: np.tan(np.deg2rad(v)), to_file=lambda v: math.degrees(math.atan(v)),
        )  # fmt: skip
        return {p.key: angle, p.name: _number(p.name, p.help, "", p.lower, p.upper, required=False, many=many)}
    unit = p.unit if p.per_unit == 1.0 else p.key.removeprefix(f"{p.name}_")
    return {p.key: _number(
        p.name, p.help, unit, p.lower, p.upper, required=not p.optional, many=many,
        to_si=lambda v: v * p.per_unit, to_file=lambda v: v / p.per_unit,
    )}  # fmt: skip


def _declared(declared: Effect | Law) -> Table:
    keys = {p: _keys(p, many=declared.name == "tabulated") for p in declared.parameters}
    merged = {k: key for of_one in keys.values() for k, key in of_one.items()}
    pairs = tuple(tuple(of_one) for p, of_one in keys.items() if len(of_one) > 1 and not p.optional)
    table = Table(declared.help, merged, pairs, tuple(k for p, of_one in keys.items() if p.optional for k in of_one))
    if declared.name not in LAWS:
        return table
    law = Key("law", "friction law", f"one of {', '.join(LAWS)}", declared.name != "constant", Literal[declared.name])
    return table._replace(keys={"law": law} | merged)


def _tables(law: str) -> dict[str, Table]:
    """Every table that a scene file may have, by its path."""
    top = {
        "name": Key("name", "name of the scene, by default the file's"),
        "note": Key("note", "what it is, and where its numbers come from"),
        "initial_velocity_m_s": _number("initial_velocity", "velocity along the arc at the start, positive down-slope, "
                                        "by default 0", "m/s", -INFINITY, required=False),
        "end_time_s": _number("end_time", "end, by default when the mass rests", "s", required=False),
        "accuracy": _number("accuracy", "relative error asked for", upper=1.0, required=False),
    }  # fmt: skip
    arc = {
        "radius_m": _number("radius", "radius of the slip circle", "m"),
        "theta_1_deg": _number("theta_1", "polar angle of the arc's first end about its centre, where 270 is straight "
                               "below", "deg", -INFINITY, to_si=np.deg2rad),
        "theta_2_deg": _number("theta_2", "polar angle of the arc's second end", "deg", -INFINITY, to_si=np.deg2rad),
        "unit_weight_kN_m3": _number("unit_weight", "unit weight", "kN/m^3", to_si=lambda v: v * 1e3),
        "gravity_m_s2": _number("gravity", f"gravity, by default {Arc.gravity}", "m/s^2", required=False),
        "width_m": _number("width", f"length across the section, by default {Arc.width}", "m", required=False),
    }  # fmt: skip
    lower = {"weight_moment": -INFINITY}  # the only one that may be negative
    given = {n: _number(n, n.replace("_", " ") + ", dimensionless", lower=lower.get(n, 0.0)) for n in GIVEN}
    return {
        "": Table("a scene of slipcircle", top),
        "arc": Table("the failed section", arc),
        "arc.given": Table("coefficients of the equation of motion, taken as they are", given),
        "friction": _declared(LAWS[law]),
        **{name: _declared(effect) for name, effect in EFFECTS.items()},
    }


def _model(*laws: str) -> Any:
    """The pydantic model of a scene file whose friction law is one of these."""
    try:
        from pydantic import ConfigDict, Field, create_model
    except ImportError as error:
        raise ImportError("scene files need pydantic: pip install 'slipcircle[scenes]'") from error

    def optional(is_required: bool) -> dict[str, Any]:
        """A factory, unlike a default, does not show in the schema."""
        return {} if is_required else {"default_factory": lambda: None}

    def model(name: str, table: Table, **tables: Any) -> Any:
        fields = {}
        for k, key in table.keys.items():
            number = Annotated[float, Field(**key.limits)]
            kind = {float: number, list: list[number]}.get(key.type, key.type)  # type: ignore[valid-type]
            fields[k] = (kind, Field(title=key.title, description=key.allowed, **optional(key.required)))
        needs = [{"oneOf": [{"required": [k]} for k in pair]} for pair in table.one_of]
        needs += [{"anyOf": [{"required": [k]} for k in table.any_of]}] if table.any_of else []
        config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, title=table.title,
                            json_schema_extra={"allOf": needs} if needs else {})  # fmt: skip
        return create_model(name, __config__=config, **fields, **tables)

    tables = _tables(laws[0])
    given = model("given", tables["arc.given"])
    nested = {
        "arc": (model("arc", tables["arc"], given=(given, Field(**optional(False)))), ...),
        "friction": (Union[tuple(model(f"friction_{law}", _declared(LAWS[law])) for law in laws)], ...),  # noqa: UP007
    }
    effects = {name: (model(name, tables[name]), Field(**optional(False))) for name in EFFECTS}
    return model("scene", tables[""], **nested, **effects)


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a scene file."""
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **_model(*LAWS).model_json_schema()}


def _mistakes(document: dict[str, Any], law: str | None) -> list[str]:
    """A sentence for each mistake in a scene file, with its path, its value and what is allowed."""
    tables, model = _tables(law or "constant"), _model(law or "constant")
    from pydantic import ValidationError

    try:
        errors = model.model_validate(document) and []
    except ValidationError as error:
        errors = error.errors()
    paths = [*(f"{table}.{k}".lstrip(".") for table in tables for k in tables[table].keys), *tables]
    unknown = [".".join(e["loc"]) for e in errors if e["type"] == "extra_forbidden"]
    near = {path: (get_close_matches(path, paths, 1, 0.7) or [""])[0] for path in unknown}
    found = []
    for e in errors:
        *parents, last = (x for x in e["loc"] if isinstance(x, str))
        table, path = ".".join(parents), ".".join((*parents, last))
        key = Key("", tables[path].title, f"a table [{path}]") if path in tables else tables[table].keys.get(last)
        shown = path + "".join(f"[{x}]" for x in e["loc"] if isinstance(x, int)) + f" = {_shown(e['input'])}"
        if key is None or path in near:
            found.append(f"{shown}: is unknown; {_advice(near[path], table, paths)}")
        elif e["type"] != "missing":
            guess = get_close_matches(str(e["input"]), LAWS, 1) if last == "law" else []
            found.append(f"{shown}: must be {key.allowed}: {key.title}" + "".join(f"; did you mean {g}?" for g in guess))
        elif path not in near.values():  # what is misspelt is not missing as well
            found.append(f"{path}: is missing: {key.title}, {key.allowed}")
    for path in tables:
        if path in document and isinstance(document[path], dict) and 
    return found
