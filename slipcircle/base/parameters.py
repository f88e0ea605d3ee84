"""Messages about the parameters of laws and effects."""

from collections.abc import Sequence
from os import PathLike
from typing import Any

from generated.effects import Parameter
from slipcircle.base.bounds import abridged
from slipcircle.base.errors import mistakes
from slipcircle.base.inputerror import Message
from slipcircle.base.kinds import Texts, Values

_KINDS = {
    "text": "a text",
    "name": "a name or a number",
    "flag": "True or False",
    "number": "a number",
    "list": "a list of numbers",
    "series": "a function of time, such as Record(t, a), Record(a, dt=0.01), a Series or a Pulse",
}


def parameter_mistakes(path: str, values: Values, parameters: Sequence[Parameter]) -> Texts:
    """Return a message for each parameter that is missing, invalid or unknown; ``path`` names its effect or law."""
    if _are_plain(values, parameters):
        return []
    declared = {p.name: p for p in parameters if p.kind != "rotation"}
    missing = [p for name, p in declared.items() if not p.optional and name not in values]
    sentences = [f"{path}: {p.name!r} is missing: {p.help}" for p in missing]
    names = ", ".join(declared) or "none"
    sentences += [f"{path}: {name!r} is unknown; known are {names}" for name in values if name not in declared]
    for name, p in declared.items():
        if name in values:
            sentences += _value_mistakes(f"{path}.{name}", p, values[name])
    return sentences


def _are_plain(values: Values, parameters: Sequence[Parameter]) -> bool:
    """Return whether the values by name are one valid float per required parameter and nothing else, the usual case."""
    count = 0
    for p in parameters:
        if p.optional and p.name not in values:
            continue
        count += 1
        value = values.get(p.name)
        if p.kind != "number" or type(value) is not float or not p.lower < value < p.upper:
            return False
    return len(values) == count


def _value_mistakes(name: str, p: Parameter, value: Any) -> Texts:
    """Return messages about the value of the declared parameter ``p``, which messages call ``name``."""
    has_bounds = p.key and p.kind in ("number", "list", "series", "fixed")
    if has_bounds and not callable(value):
        return mistakes({name: value}, {name: p})
    if _is_of_kind(p.kind, value):
        return []
    choices = p.kind.replace("|", ", ")
    allowed = _KINDS.get(p.kind, f"one of {choices}")
    sentence = f"{{{name}}} = {abridged(value)}: must be {allowed}: {p.help}"
    return [Message(sentence)]


def _is_of_kind(kind: str, value: Any) -> bool:
    """Return whether a value has the type that its parameter's kind requires."""
    match kind:
        case "number" | "list" | "fixed":
            return False
        case "series":
            return hasattr(type(value), "kinks")
        case "flag":
            return isinstance(value, bool)
        case "text" | "name":
            return isinstance(value, str | int | PathLike)
    return value in kind.split("|")
