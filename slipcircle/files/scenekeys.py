"""The pydantic model of a scene file, and its JSON Schema for editors."""

from typing import Annotated, Any, Literal, Union

from generated.effects import EFFECTS, LAWS
from slipcircle.base.distributions import DISTRIBUTIONS
from slipcircle.files import slopekeys
from slipcircle.scene.friction import RATE_LAWS
from slipcircle.scene.keys import Key, Table, law_table, may_have_rate, tables_of


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
    by_rate: Any = Union.__getitem__(tuple(model(f"rate_{law}", law_table(law, RATE_LAWS)) for law in rates))
    title = Table("law of speed that multiplies that of slip", {})
    friction: Any = Union.__getitem__(
        tuple(
            model(f"friction_{law}", law_table(law), **({"rate": field(by_rate, title)} if may_have_rate(law) else {}))
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
