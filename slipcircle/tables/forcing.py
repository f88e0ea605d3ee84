"""Functions of time in the effects of a scene, built from pulses, records and lists."""

from typing import Any

import numpy as np

from slipcircle.base.arrays import array_of
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Effects, Parameters, ValueDict
from slipcircle.tables.series import Pulse, Series

_FACTORS = ("amplitude", "vertical_amplitude", "scale", "peak")
_FITTING = {  # parameters allowed with each description of shaking
    "horizontal": {"vertical", *_FACTORS},
    "pulse": {*_FACTORS[:2], "start", "duration", "cycles"},
}
STRONGEST = 5.0  # g, above every recorded ground acceleration
_OF_RECORDS = ("record", "units", "column", "columns", "step", "start", "gaps")
_IN_FILES = "{{record}}: file names are for scene files; in Python use {} = slipcircle.Record.read(path, ...)"


def with_functions_of_time(name: str, parameters: Parameters) -> ValueDict:
    """Return the parameters of an effect with functions of time built from pulses and lists.

    Raises
    ------
    ValueError
        If a parameter is invalid. The message names it.
    """
    try:
        if name == "shaking":
            # The shaking parameters with k_h(t) and k_v(t), after checking their plausibility.
            made = _as_series(parameters)
            _check_strength(made)
            return made
        if name == "pore_pressure":
            return _water(parameters)
    except InputError as error:
        messages = [message.within(f"effects.{name}") for message in error.messages]
        raise InputError("", messages) from error
    except ValueError as error:
        raise InputError("", [f"{{effects.{name}}}: {error}"]) from error
    return dict(parameters)


def shaking_factor(effect: str, parameters: Parameters, name: str) -> Any:
    """Return the factor of a parameter of a resolved effect.

    Shaking has an amplitude, a scale or a peak. `effect` and `name` are the names of the effect and of its parameter,
    such as "horizontal".
    """
    if effect != "shaking":
        return 1.0
    if isinstance(parameters.get(name), Pulse):
        return parameters.get("vertical_amplitude" if name == "vertical" else "amplitude", 1.0)
    if "peak" not in parameters:
        return parameters.get("scale", 1.0)
    recorded_peak = parameters["horizontal"].greatest or 1.0
    return parameters["peak"] / recorded_peak


def record_numbers(shaking: Parameters) -> ValueDict:
    """Return scale and peak, over gravity, of shaking by a record; empty for other shaking.

    Either number determines the other.
    """
    record = shaking["horizontal"]
    if not isinstance(record, Series):
        return {}
    scale = shaking_factor("shaking", shaking, "horizontal")
    return {"scale": scale, "peak": scale * record.greatest}


def in_time(called: Effects) -> dict[str, Series | Pulse]:
    """Return the functions of time in a single scene's effects, times their factors, by `effect.parameter`.

    `called` are the effects by name, with resolved parameters.
    """
    functions = {}
    for effect, parameters in called.items():
        for name, value in parameters.items():
            if isinstance(value, Series | Pulse):
                functions[f"{effect}.{name}"] = value.scaled(float(shaking_factor(effect, parameters, name)))
    return functions


def _water(parameters: Parameters) -> ValueDict:
    """Return the pore-pressure parameters, with lists over time converted to functions of time in s."""
    rest = dict(parameters)
    rest.pop("time", None)
    if "record" in parameters:
        raise InputError("", [_IN_FILES.format("pressure")])
    for name in _OF_RECORDS:
        if name in parameters:
            raise InputError("", [f"{{{name}}}: applies to a record; remove it, or give {{record}}"])
    if "time" not in parameters:  # without it a list is an ensemble
        return rest
    time = array_of(parameters["time"])
    lists = [name for name, value in rest.items() if not callable(value) and np.ndim(value) == 1]
    if time.ndim != 1 or not lists:
        raise InputError("", ["{time} and {ratio} or {pressure}: must be lists of numbers"])
    for name in lists:
        rest[name] = Series(time, array_of(rest[name]))
    return rest


def _as_series(parameters: Parameters) -> ValueDict:
    if "record" in parameters:
        raise InputError("", [_IN_FILES.format("horizontal")])
    ways = [way for way in _FITTING if way in parameters]
    if len(ways) != 1:
        both = " and ".join(f"{{{way}}}" for way in ways)
        raise InputError("", [f"{both} exclude each other; remove one"])
    (way,) = ways
    fitting = _FITTING[way] | {way, "two_way"}
    strange = [name for name in parameters if name not in fitting]
    if strange:
        raise InputError("", [f"{{{strange[0]}}} does not belong to a {way}; leave it out"])
    if "scale" in parameters and "peak" in parameters:
        raise InputError("", ["{scale} and {peak} exclude each other; remove one"])
    if way == "horizontal":
        return dict(parameters)
    for needed in ("amplitude", "duration"):
        if needed not in parameters:
            raise InputError("", [f"{{{needed}}} is missing: a pulse needs it"])
    start = float(parameters.get("start", 0.0))
    pulse = Pulse(parameters["pulse"], 1.0, start, float(parameters["duration"]), float(parameters.get("cycles", 1.0)))
    made = {"horizontal": pulse}
    if "vertical_amplitude" in parameters:
        made["vertical"] = pulse
    for name in (*_FACTORS, "two_way"):
        if name in parameters:
            made[name] = parameters[name]
    return made


def _check_strength(parameters: Parameters) -> None:
    """Raise an error if a record exceeds every recorded ground motion, since its unit or scale must be wrong.

    The argument contains the parameters of shaking, over gravity.
    """
    for name in ("horizontal", "vertical"):
        record = parameters.get(name)
        if not isinstance(record, Series):
            continue
        peak = float(np.max(np.abs(shaking_factor("shaking", parameters, name)))) * record.greatest
        if peak > STRONGEST:
            unlikely = f"{{{name}}} reaches {peak:.6g} g, more than any recorded ground motion ({STRONGEST:g} g)"
            unit = 'its values are over gravity; in Python give their unit, such as Record(t, a, units="cm/s2")'
            raise InputError("", [f"{unlikely}: {unit}"])
