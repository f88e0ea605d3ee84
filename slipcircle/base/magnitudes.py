"""Conversion of quantities with units to numbers in SI units, loaded for the first quantity."""

from collections.abc import Mapping
from itertools import chain
from typing import Any

from generated.effects import COHESION_LAWS, EFFECTS, LAWS
from slipcircle.base.inputerror import InputError
from slipcircle.base.kinds import Texts

_FIELDS = {  # by SI unit: fields that no effect or law declares
    "m": "radius width centre between base ground level ponds layers surcharge top datum crack crack_water",
    "rad": "theta_1 theta_2",
    "N/m^3": "unit_weight saturated_unit_weight water_unit_weight",
    "Pa": "cohesion pressure surcharge",
    "Pa/m": "cohesion_gradient",
    "m/s^2": "gravity",
    "m/s": "initial_velocity",
    "s": "end_time",
    "": "friction k_h pore_ratio strength_factor",
}


def in_si(name: str, value: Any) -> Any:
    """Return the value of a field converted to SI units, also within lists and mappings.

    ``name`` is the field or parameter, which determines the unit. Numbers without unit are unchanged.
    """
    if hasattr(type(value), "dimensionality"):
        return _magnitude(name, value)
    if isinstance(value, Mapping):
        return {key: in_si(key, one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [in_si(name, one) for one in value]
    return value


def _magnitude(name: str, quantity: Any) -> Any:
    """Return the magnitude of a quantity in the SI unit of its field, which ``name`` determines.

    Factors must not have a unit, not even rad.
    """
    units = _units(name)
    for unit in units:
        fits = quantity.is_compatible_with(unit)
        if fits and quantity.unitless == (unit == ""):
            return quantity.m_as(unit)
    allowed = " or ".join(unit or "a number without unit" for unit in units)
    sentence = f"{{{name}}} = {quantity}: must be {allowed or 'a number'}, or another unit of it"
    raise InputError("", [sentence])


def _units(name: str) -> Texts:
    """Return the SI units that a field or a parameter of this name may have, "" for a factor."""
    declaring: list[Any] = [*EFFECTS.values(), *LAWS.values(), *COHESION_LAWS.values()]
    parameters = chain.from_iterable(each.parameters for each in declaring)
    of_fields = [unit for unit, names in _FIELDS.items() if name in names.split()]
    declared = [parameter.unit for parameter in parameters if parameter.name == name]
    return list(dict.fromkeys(of_fields or declared))
