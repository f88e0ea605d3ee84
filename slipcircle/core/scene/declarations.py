"""Declarations of the numbers of a scene in the metadata of dataclass fields."""

from dataclasses import fields, replace
from functools import lru_cache
from typing import Any

from generated.effects import INFINITY, Parameter

Parts = dict[str, tuple[Any, Any]]  # value and declaration by name
STORED = Parameter("", kind="stored")


def number(
    unit: str, lower: float = -INFINITY, upper: float = INFINITY, allowed: str = "", **more: Any
) -> dict[str, Parameter]:
    """Return the metadata of a dataclass field that is a number, with its SI unit and open bounds.

    ``allowed`` describes the allowed values in messages, and ``more`` are further fields of `Parameter`.
    """
    return {"number": Parameter("", unit, lower, upper, allowed=allowed, **more)}


@lru_cache
def declared(kind: Any) -> dict[str, Parameter]:
    """Return the declarations of the numbers among the fields of a dataclass, by field.

    ``kind`` is the class. A declaration without key has the field's name as key.
    """
    declarations = {}
    for field in fields(kind):
        p = field.metadata.get("number")
        if p:
            key = p.key or field.name
            declarations[field.name] = replace(p, name=field.name, key=key)
    return declarations
