"""Messages about strengths and effects: laws by name and functions, and the parameters of laws and effects."""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

from generated.effects import COHESION_LAWS, EFFECTS, LAWS, Law, Parameter
from slipcircle.base.errors import Message, abridged, mistakes
from slipcircle.base.kinds import MAPPING, Parameters, Texts, Values
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.effects import OF_GROWTH
from slipcircle.core.scene.friction import RATE_LAWS, may_have_rate

COEFFICIENT = Parameter("friction", lower=-5e-324, allowed="a friction coefficient, tan(phi): a number of at least 0")
_OF_SPEED = {name: LAWS[name] for name in RATE_LAWS}


def is_law(strength: Any) -> bool:
    """Return whether a friction or cohesion is a law by name or a function instead of a number."""
    return callable(strength) or isinstance(strength, MAPPING)


def law_mistakes(strength: Any, path: str = "friction", laws: Mapping[str, Law] = LAWS) -> Texts:
    """Return a message for each mistake in a friction or cohesion: a number, a law with parameters, or a function.

    ``path`` names the strength in the messages, and ``laws`` are the allowed laws by name.
    """
    if isinstance(strength, type):
        return [f"{{{path}}} = {strength!r}: must be a number, a law or a function of slip"]
    if callable(strength):
        return []
    if not is_law(strength):
        return mistakes({path: strength}, {path: COEFFICIENT})
    has_rate = laws is LAWS and "rate" in strength
    faults = _named_mistakes({name: strength[name] for name in strength if not has_rate or name != "rate"}, path, laws)
    if faults or not has_rate:
        return faults
    if not may_have_rate(strength["law"]):
        return [f"friction.rate: {strength['law']} is not a law of slip; remove one"]
    return rate_mistakes(strength["rate"], "friction.rate")


def rate_mistakes(rate: Any, path: str = "rate") -> Texts:
    """Return a message for each mistake in a law of speed, which multiplies a law of slip or the friction of soils.

    ``rate`` is the law's name and parameters, and ``path`` names it in the messages.
    """
    if not isinstance(rate, MAPPING):
        return [f"{path} = {abridged(rate)}: must be a law of speed with its parameters"]
    return _named_mistakes(rate, path, _OF_SPEED)


def _named_mistakes(entered: Parameters, path: str, laws: Mapping[str, Law]) -> Texts:
    """Return a message for each mistake in a law by name.

    ``path`` names it in the messages, and ``laws`` are the laws allowed there by name.
    """
    parameters = dict(entered)
    name = parameters.pop("law", None)
    if name not in laws:
        names = ", ".join(laws)
        return [f"{path}.law = {name!r}: must be one of {names}"]
    law = laws[name]
    faults = parameter_mistakes(path, parameters, law.parameters)
    if faults or law.parameters[0].kind != "list":
        return faults
    of_list: Texts = lazy_import("tables").list_faults(path, law, parameters)
    return of_list


def effect_mistakes(name: str, parameters: Parameters) -> Texts:
    """Return messages about the parameters of an effect.

    ``name`` is the name of the effect, and ``parameters`` are by name.
    """
    if name not in EFFECTS:
        return [f"effects: {name!r} is unknown; known are {', '.join(EFFECTS)}"]
    effect = EFFECTS[name]
    path = f"effects.{name}"
    if name == "cohesion" and ("law" in parameters or callable(parameters.get(name))):
        law = dict(parameters)
        of_growth = {p.name: law.pop(p.name) for p in OF_GROWTH if p.name in law}
        cohesion = law if "law" in law else law[name]
        return law_mistakes(cohesion, path, COHESION_LAWS) + parameter_mistakes(path, of_growth, OF_GROWTH)
    faults = []
    if effect.any_of and parameters.keys().isdisjoint(effect.any_of):
        names = ", ".join(effect.any_of)
        faults.append(f"{path}: one of {names} is missing")
    return faults + parameter_mistakes(path, parameters, effect.parameters)


# --- parameters ------------------------------------------------------------------------------------------------------

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
