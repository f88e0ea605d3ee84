"""Laws by name and functions, and the parameters of laws and effects, with messages about mistakes in them."""

from collections.abc import Mapping
from typing import Any

from generated.effects import COHESION_LAWS, EFFECTS, LAWS, Law, Parameter
from slipcircle.base.arrays import Frozen
from slipcircle.base.bounds import abridged
from slipcircle.base.errors import mistakes
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import MAPPING, Names, Parameters, Texts
from slipcircle.base.parameters import parameter_mistakes
from slipcircle.core.lazy import lazy_import
from slipcircle.core.scene.effects import OF_GROWTH, without_soil

RATE_LAWS = tuple(name for name in LAWS if LAWS[name].depends_on == ("speed",))
COEFFICIENT = Parameter("friction", lower=-5e-324, allowed="a friction coefficient, tan(phi): a number of at least 0")
_OF_SPEED = {name: LAWS[name] for name in RATE_LAWS}


def may_have_rate(law: str) -> bool:
    """Return whether a law, given by name, may be multiplied by a law of speed."""
    return {"speed", "time"}.isdisjoint(LAWS[law].depends_on)


def depends_on(laws: Names) -> Names:
    """Return the variables on which a product of laws depends, such as "slip", "speed" and "time"."""
    variables: dict[str, None] = {}
    for name in laws:
        law = LAWS.get(without_soil(name))
        depends_on = law.depends_on if law else ("slip",)
        variables |= dict.fromkeys(depends_on)
    return tuple(variables)


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
    of_slip = dict(strength)
    has_rate = laws is LAWS and "rate" in strength
    if has_rate:
        del of_slip["rate"]
    faults = _named_mistakes(of_slip, path, laws)
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
        faults = law_mistakes(cohesion, path, COHESION_LAWS)
        return faults + parameter_mistakes(path, of_growth, OF_GROWTH)
    faults = []
    if effect.any_of and parameters.keys().isdisjoint(effect.any_of):
        names = ", ".join(effect.any_of)
        faults.append(f"{path}: one of {names} is missing")
    return faults + parameter_mistakes(path, parameters, effect.parameters)


def checked_effect(name: str, parameters: Frozen) -> tuple[Frozen, Texts]:
    """Return an effect's parameters, with functions of time built from their parts, and messages about mistakes.

    ``name`` is the name of the effect, and ``parameters`` are its parameters as entered.
    """
    messages = effect_mistakes(name, parameters)
    if messages:
        return parameters, messages
    series = {p.name for p in EFFECTS[name].parameters if p.kind == "series"}
    if not series or (series.issuperset(parameters) and not any(map(callable, parameters.values()))):
        return parameters, []
    try:
        return Frozen(lazy_import("forcing").with_functions_of_time(name, parameters)), []
    except InputError as error:
        return parameters, list(error.messages)
