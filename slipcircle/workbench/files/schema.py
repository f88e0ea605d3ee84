"""JSON Schema of a scene file, for editors: tables, keys and their allowed values."""

from collections.abc import Mapping
from dataclasses import replace

from slipcircle.base.kinds import Texts, ValueDict, Values
from slipcircle.workbench.common.distributions import DISTRIBUTIONS
from slipcircle.workbench.common.units import UNITS_OF_KEYS, suffix
from slipcircle.workbench.files.keys import WITH_ARC, Key, KeyTable
from slipcircle.workbench.files.slopekeys import WITH_LAYERS, WITH_ONE_SOIL

_LIMITS = {"gt": "exclusiveMinimum", "ge": "minimum", "lt": "exclusiveMaximum"}
_OTHER_UNIT = {"type": ["number", "array", "object"], "title": "the number or numbers in another unit"}
_FILED = ("points", "line")  # kinds of keys whose points may be in a file


def _present(name: str, key: Key) -> ValueDict:
    """Return the schema condition that a key is present, in any unit or as a file.

    `name` is the published spelling of the key.
    """
    units = [*map(suffix, UNITS_OF_KEYS.get(key.unit, ()))]
    stem = name.removesuffix(units[0]) if units else name
    others = [stem + end for end in units[1:] + ["file"] * (key.kind in _FILED)]
    conditions = [{"required": [spelling]} for spelling in (name, *others)]
    return {"anyOf": conditions} if others else conditions[0]


def _other_units(keys: Mapping[str, Key]) -> ValueDict:
    """Return the schema of keys in units other than the published ones, and of points in files."""
    patterns = {}
    for name, key in keys.items():
        first, *others = map(suffix, UNITS_OF_KEYS.get(key.unit, ("",)))
        stem = name.removesuffix(first)
        if others:
            patterns[f"^{stem}({'|'.join(others)})$"] = {"$ref": "#/$defs/other_unit"}
        if key.kind in _FILED:
            patterns[f"^{stem}file(_unit)?$"] = {"type": "string"}
    return {"patternProperties": patterns} if patterns else {}


_WEIGHT = _present("unit_weight_kN_m3", WITH_ONE_SOIL.tables["ground"].keys["unit_weight_kN_m3"])
_OF_GROUND: tuple[ValueDict, ...] = ({}, {"ground": _WEIGHT}, {"ground": {"not": _WEIGHT}})
_DISTRIBUTIONS = [{"$ref": f"#/$defs/{name}"} for name in DISTRIBUTIONS]


def schema() -> ValueDict:
    """Return the JSON Schema (draft 2020-12) of a scene file with an arc, or with a ground and a circle instead."""
    defs = {
        name: _object(
            {"distribution": {"const": name}} | {k: {"type": "number"} for k in kind.parameters},
            f"{name} distribution, in the key's unit; {kind.help}".rstrip("; "),
            ["distribution", *kind.parameters],
        )
        for name, kind in DISTRIBUTIONS.items()
    }
    defs["other_unit"] = _OTHER_UNIT
    forms = (WITH_ARC, WITH_ONE_SOIL, WITH_LAYERS)
    ground = WITH_ONE_SOIL.tables["ground"]
    any_ground = ground._replace(keys={k: replace(key, optional=True) for k, key in ground.keys.items()})
    tables = {**WITH_LAYERS.tables, **WITH_ONE_SOIL.tables, **WITH_ARC.tables, "ground": any_ground}
    scene_schema = _schema_of_table(WITH_ARC._replace(tables=tables), "", defs)
    scene_schema["required"] = []
    scene_schema["oneOf"] = [
        {
            "required": [name for name, table in form.tables.items() if table.required and name != "friction"],
            "anyOf": [{"required": [name]} for name in ("friction", "cohesion", "soils") if name in form.tables],
            "properties": of_ground,
            "not": {"anyOf": [{"required": [name]} for name in tables if name not in form.tables]},
        }
        for form, of_ground in zip(forms, _OF_GROUND, strict=True)
    ]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **scene_schema, "$defs": defs}


def _schema_of_table(table: KeyTable, name: str, defs: ValueDict) -> ValueDict:
    """Return the schema of a table and the tables inside it; add the schemas of its laws to `defs`.

    `name` is the path of the table with underscores, the prefix of the names of its laws.
    """
    if table.laws:
        for law, of_law in table.laws.items():
            defs[f"{name}_{law}"] = _schema_of_table(of_law, name, defs)
        return {"title": table.title, "anyOf": [{"$ref": f"#/$defs/{name}_{law}"} for law in table.laws]}
    properties = {k: _schema_of_key(key) for k, key in table.keys.items()}
    for inside, inner in table.tables.items():
        one = _schema_of_table(inner, f"{name}_{inside}".lstrip("_"), defs)
        many = {"named": {"type": "object", "additionalProperties": one}, "numbered": {"type": "array", "items": one}}
        properties[inside] = many[inner.repeats] | {"title": inner.title} if inner.repeats else one
    schema = _object(properties, table.title, []) | _other_units(table.keys)
    present = {k: _present(k, key) for k, key in table.keys.items()}
    needs = [present[k] for k, key in table.keys.items() if not key.optional]
    needs += [{"oneOf": [present[k] for k in pair]} for pair in table.one_of]
    needs += [{"anyOf": [present[k] for k in table.any_of]}] if table.any_of else []
    if table.sets:
        needs.append({"oneOf": [{"allOf": [present[k] for k in keys]} for keys in table.sets]})
    if needs:
        schema["allOf"] = needs
    return schema


def _object(properties: Values, title: str, required: Texts) -> ValueDict:
    """Return the schema of an object with the given properties and no others, and the names of required properties."""
    return {
        "type": "object",
        "title": title,
        "properties": dict(properties),
        "required": required,
        "additionalProperties": False,
    }


def _schema_of_key(key: Key) -> ValueDict:
    """Return the schema of a key by its kind; a number may be uncertain unless it is fixed."""
    number: ValueDict = {"type": "number"} | {_LIMITS[k]: v for k, v in key.limits.items()}
    many = {"type": "array", "items": number}
    pair = many | {"minItems": 2, "maxItems": 2}
    points = {"type": "array", "items": pair, "minItems": 2}
    either = [number, *_DISTRIBUTIONS]
    kinds: dict[str, ValueDict] = {
        "text": {"type": "string"},
        "name": {"type": ["string", "integer"]},
        "flag": {"type": "boolean"},
        "number": {"anyOf": either},
        "fixed": number,
        "list": many,
        "series": {"anyOf": [*either, many]},
        "pair": pair,
        "points": points,
        "line": {"anyOf": [*either, points]},
        "load": {"anyOf": [*either, pair]},
        "seen": {"anyOf": [number, pair, {"type": "string", "pattern": "^[<>]"}]},
    }
    words = key.kind.split("|")
    choice = {"const": key.kind} if len(words) == 1 else {"enum": words}
    return kinds.get(key.kind, choice) | {"title": key.help, "description": key.allowed}
