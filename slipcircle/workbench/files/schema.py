"""The JSON Schema of a scene file, for editors: tables, keys, and their allowed values."""

from collections.abc import Callable, Mapping
from typing import Any

from generated.effects import EFFECTS, LAWS
from slipcircle.core import RATE_LAWS, may_have_rate
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.files.keys import Key, Table, law_table, tables_of
from slipcircle.workbench.files.slopekeys import (
    LOADS,
    NOT_WITH_LAYERS,
    SLOPING,
    SOIL_LAWS,
    layered_tables,
    soil_friction,
)


def _any_of(*names: str) -> list[dict[str, list[str]]]:
    return [{"required": [name]} for name in names]


_LIMITS = {"gt": "exclusiveMinimum", "ge": "minimum", "lt": "exclusiveMaximum"}
_WEIGHT = {"required": ["unit_weight_kN_m3"]}
_OF_LAYERS = ("soils", "layers", "slip")
_WITH_ARC = {"required": ["arc", "friction"], "not": {"anyOf": _any_of(*SLOPING, *LOADS, *_OF_LAYERS)}}
_WITH_ONE_SOIL = {
    "required": ["ground", "circle", "friction"],
    "properties": {"ground": _WEIGHT},
    "not": {"anyOf": _any_of("arc", *_OF_LAYERS)},
}
_WITH_LAYERS = {
    "required": ["ground", "circle", "soils", "layers"],
    "properties": {"ground": {"not": _WEIGHT}},
    "not": {"anyOf": _any_of("arc", *NOT_WITH_LAYERS)},
}
_DISTRIBUTIONS = [{"$ref": f"#/$defs/{name}"} for name in DISTRIBUTIONS]


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a scene file: with an arc, or in its place with a ground and a circle."""
    tables = tables_of("constant")
    defs = {
        name: _object(
            {"distribution": {"const": name}} | {k: {"type": "number"} for k in kind.parameters},
            f"{name} distribution, in the key's unit; {kind.help}".rstrip("; "),
            ["distribution", *kind.parameters],
        )
        for name, kind in DISTRIBUTIONS.items()
    }

    def defined(name: str, table: Table, more: Mapping[str, Any] = {}) -> dict[str, Any]:
        defs[name] = _schema_of_table(table, more)
        return {"$ref": f"#/$defs/{name}"}

    given = defined("given", tables["arc.given"])
    rates = {"anyOf": [defined(f"rate_{law}", law_table(law, RATE_LAWS)) for law in RATE_LAWS]}
    laws = [defined(f"friction_{law}", law_table(law), {"rate": rates} if may_have_rate(law) else {}) for law in LAWS]
    inner = {"arc": defined("arc", tables["arc"], {"given": given}), "friction": {"anyOf": laws}}
    inner |= {name: defined(name, tables[name]) for name in EFFECTS}
    inner |= _of_slopes(defined)
    found = _schema_of_table(tables[""], inner)
    found["required"] = []
    found["oneOf"] = [_WITH_ARC, _WITH_ONE_SOIL, _WITH_LAYERS]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **found, "$defs": defs}


def _of_slopes(defined: Callable[..., dict[str, Any]]) -> dict[str, Any]:
    """The tables of slopes by their names; ``defined`` puts one among the definitions."""
    ground = SLOPING["ground"]
    keys = {k: key._replace(required=False) for k, key in ground.keys.items()}
    inner = {name: _schema_of_table(table) for name, table in SLOPING.items()}
    inner |= {"ground": _schema_of_table(ground._replace(keys=keys))}
    inner |= {name: _schema_of_table(table) for name, table in LOADS.items()}
    inner["surcharge"] = {"type": "array", "items": inner["surcharge"]}
    layered = layered_tables({"NAME": "constant"}, 1)
    laws = {"anyOf": [defined(f"soil_friction_{law}", soil_friction(law)) for law in SOIL_LAWS]}
    soil = defined("soil", layered["soils.NAME"], {"friction": laws})
    rates = {"anyOf": [{"$ref": f"#/$defs/rate_{law}"} for law in RATE_LAWS]}
    return inner | {
        "soils": {"type": "object", "title": layered["soils"].title, "additionalProperties": soil},
        "layers": {"type": "array", "title": layered["layers"].title, "items": defined("layer", layered["layers.1"])},
        "slip": _schema_of_table(layered["slip"], {"rate": rates}),
    }


def _schema_of_table(table: Table, more: Mapping[str, Any] = {}) -> dict[str, Any]:
    keys = {k: _schema_of_key(key) for k, key in table.keys.items()}
    required = [k for k, key in table.keys.items() if key.required]
    schema = _object(keys | dict(more), table.title, required)
    needs: list[Any] = []
    for pair in table.one_of:
        needs.append({"oneOf": [{"required": [k]} for k in pair]})
    if table.any_of:
        needs.append({"anyOf": [{"required": [k]} for k in table.any_of]})
    if table.sets:
        needs.append({"oneOf": [{"required": list(keys)} for keys in table.sets]})
    if needs:
        schema["allOf"] = needs
    return schema


def _object(properties: Mapping[str, Any], title: str, required: list[str]) -> dict[str, Any]:
    return {
        "type": "object",
        "title": title,
        "properties": dict(properties),
        "required": required,
        "additionalProperties": False,
    }


def _schema_of_key(key: Key) -> dict[str, Any]:
    """Schema of a key; a number may be uncertain unless it is fixed."""
    number: dict[str, Any] = {"type": "number"} | {_LIMITS[k]: v for k, v in key.number.limits.items()}
    many = {"type": "array", "items": number}
    pair = many | {"minItems": 2, "maxItems": 2}
    points = {"type": "array", "items": pair, "minItems": 2}
    either = [number, *_DISTRIBUTIONS]
    kinds: dict[str, dict[str, Any]] = {
        "text": {"type": "string"},
        "flag": {"type": "boolean"},
        "number": {"anyOf": either},
        "fixed": number,
        "list": many,
        "series": {"anyOf": [*either, many]},
        "pair": pair,
        "points": points,
        "line": {"anyOf": [*either, points]},
        "load": {"anyOf": [*either, pair]},
    }
    words = key.kind.split("|")
    choice = {"const": key.kind} if len(words) == 1 else {"enum": words}
    return kinds.get(key.kind, choice) | {"title": key.title, "description": key.allowed}
