"""Numbers of a scene that may vary, by their SI names, with scales, and scenes with other values of them.

Names are the keys of `Scene.numbers` (``radius``, ``ground.3.y``, ``friction.peak``, ``cohesion.cohesion``), and
``dip`` for the chord of an arc, which turns both its ends. Grids, samples, fits and derivatives replace values by these
names. The file reader translates them to keys of scene files.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from generated import effects as declared
from slipcircle.base.checks import InputError, array_of, plain, real_number
from slipcircle.base.kinds import Flags, Floats, Function, ValueDict, Values
from slipcircle.core.scene.arc import ARC_BOUNDS
from slipcircle.core.scene.effects import declared_parameters, without_soil
from slipcircle.core.scene.friction import law_parts, law_paths, number_name
from slipcircle.core.scene.scene import Scene, checked
from slipcircle.ground.coordinates import changed_fields, replace_unchecked
from slipcircle.ground.ground import BOUNDS, FAR

ARC_UNITS = {
    "radius": "m",
    "theta_1": "rad",
    "theta_2": "rad",
    "unit_weight": "N/m^3",
    "gravity": "m/s^2",
    "width": "m",
}
_SOIL_UNITS = {
    "unit_weight": "N/m^3",
    "saturated_unit_weight": "N/m^3",
    "cohesion": "Pa",
    "cohesion_gradient": "Pa/m",
    "pore_ratio": "",
    "top": "m",
    "pressure": "Pa",
}
_COEFFICIENT = ("", -5e-324, declared.LIMITS[""][1])
SOIL_BOUNDS: dict[str, tuple[str, float, float]] = {  # units, and open bounds
    **{name: (unit, *BOUNDS[name][:2]) for name, unit in _SOIL_UNITS.items()},
    "friction": _COEFFICIENT,
    "peak": _COEFFICIENT,
    "residual": _COEFFICIENT,
    "length": ("m", *declared.LIMITS["m"]),
    "velocity": ("m/s", *declared.LIMITS["m/s"]),
    "crack": ("m", 0.0, FAR),
}
USUAL_WEIGHT = 2e4  # usual unit weight of soils, N/m^3
SMALLEST = 5e-324  # its negative as a lower bound allows zero, since bounds are open

_OTHER_FACTOR = {"peak": "scale", "scale": "peak"}  # two names of one factor of shaking


@dataclass(frozen=True)
class Parameter:
    """Number that a scene may have: name, SI unit, and open bounds."""

    name: str
    unit: str
    lower: float
    upper: float

    def allows(self, values: Any) -> Any:
        """Return whether values are finite and within the bounds."""
        is_finite = abs(values) < math.inf
        return is_finite & (values > self.lower) & (values < self.upper)


@dataclass(frozen=True)
class Free(Parameter):
    """Number of a single scene that may vary alone, with its value and a power of 2 as the scale of its changes."""

    value: float
    scale: float


DIP = Parameter("dip", "rad", -SMALLEST, math.pi / 2)
_, _GREATEST_SPEED = declared.LIMITS["m/s"]
_MOTION = (
    Parameter("initial_velocity", "m/s", -_GREATEST_SPEED, _GREATEST_SPEED),
    Parameter("end_time", "s", *declared.LIMITS["s"]),
    Parameter("strength_factor", "", *declared.LIMITS[""]),
)


def possible_parameters(scene: Scene) -> dict[str, Parameter]:
    """Return every number that a scene with this arc and friction law may have, with or without a value."""
    every = [*_MOTION]
    every += _parameters_of_arc(scene.arc)
    every += _parameters_of_friction(scene.friction)
    for name in declared.EFFECTS:
        given = scene.checked_effects.get(name, {})
        every += _scalars(name, declared_parameters(name, given))
    return {parameter.name: parameter for parameter in every}


def parameters(scene: Scene[float]) -> dict[str, Free]:
    """Return the numbers of a single scene that may vary alone and may influence its motion.

    Returns
    -------
    dict
        Numbers by name, each with ``name``, ``unit`` (SI), ``lower`` and ``upper`` (open bounds), ``value`` and
        ``scale``. The scale is the power of 2 nearest to the size of the number, or to a sixteenth of the radius for
        coordinates, the opening of the arc for angles, and the usual size of its unit for a number that is 0.

    Notes
    -----
    The ends of an arc with tabulated coefficients, the width, an initial velocity, shaking or pore pressure ratio of 0,
    and an increase of cohesion without a datum are omitted. A length that all soils share has one name. A record is
    scaled by its peak.
    """
    if checked(scene, "parameters").shape:
        raise ValueError("parameters: takes a single scene; give one case of the ensemble")
    left_out = _left_out(scene)
    numbers = scene.numbers
    names = dict.fromkeys(("friction", *numbers) if "friction" in numbers else numbers)
    has_effect = [name for name in names if np.all(numbers[name]) or not _rests_at_zero(name)]
    chosen = [name for name in has_effect if name not in left_out]
    return free_parameters(scene, chosen)


def free_parameters(scene: Scene[float], names: Iterable[str]) -> dict[str, Free]:
    """Return selected numbers of a single scene by name, with values and scales."""
    possible = possible_parameters(scene)
    free = dict[str, Free]()
    for name in names:
        known = possible[name]
        value = parameter_value(scene, name)
        assert value is not None
        scale = _scale(scene.arc, known, value)
        free[name] = Free(name, known.unit, known.lower, known.upper, value, scale)
    return free


def _rests_at_zero(name: str) -> bool:
    """Return whether zero means that the feature is absent."""
    return name == "initial_velocity" or name.endswith(".pore_ratio") or name.startswith("shaking.")


def _left_out(scene: Scene) -> set[str]:
    """Return numbers without influence on the motion, and numbers determined by others."""
    left_out = {"width"}
    if "shaking.peak" in scene.numbers:
        left_out.add("shaking.scale")
    of_mass = scene.arc.numbers_without_effect()
    left_out.update(of_mass)
    return left_out


def _scale(arc: Any, parameter: Parameter, value: float) -> float:
    """Return the scale of a number as a power of 2, so that steps are exact."""
    radius = float(arc.radius)
    gravity = float(arc.gravity)
    usual = {
        "m": radius,
        "m/s": math.sqrt(gravity * radius),
        "s": math.sqrt(radius / gravity),
        "Pa": USUAL_WEIGHT * radius,
        "Pa/m": USUAL_WEIGHT,
        "N/m^3": USUAL_WEIGHT,
        "m/s^2": gravity,
    }
    _, _, quantity = parameter.name.rpartition(".")
    if quantity in ("x", "y", "top"):
        size = radius / 16
    elif parameter.unit == "rad":
        size = abs(arc.theta_2 - arc.theta_1)
    else:
        size = abs(value) or usual.get(parameter.unit, 1.0)
    exponent = round(math.log2(size))
    return float(2.0**exponent)


def _parameters_of_arc(arc: Any) -> Iterator[Parameter]:
    """Yield the numbers of an arc or a section."""
    for name, (lower, upper, _) in ARC_BOUNDS.items():
        if name in arc.quantities:
            yield Parameter(name, ARC_UNITS[name], lower, upper)
    if "ground" not in arc.quantities:
        yield DIP
    else:
        for name in arc.numbers_by_name():
            if "." in name:
                yield Parameter(name, "m", -FAR, FAR)
    for name in arc.other_numbers():
        path, _, quantity = name.rpartition(".")
        if path.endswith(".cohesion") and quantity != "length":
            quantity = "cohesion"
        yield Parameter(name, *SOIL_BOUNDS[quantity])


def _parameters_of_friction(friction: Any) -> Iterator[Parameter]:
    """Yield the numbers of the laws of a scene's friction. The section has the numbers of soils."""
    for path, (name, _) in zip(law_paths(friction), law_parts(friction), strict=True):
        law = declared.LAWS.get(without_soil(name))
        if law is not None and not path.startswith("soils."):
            yield from _scalars(path, law.parameters)


def _scalars(path: str, parameters: Iterable[declared.Parameter]) -> Iterator[Parameter]:
    """Yield the declared parameters of a law or an effect that may be a single number."""
    for p in parameters:
        if p.kind in ("number", "series"):
            yield Parameter(number_name(path, p.name), p.unit, p.lower, p.upper)


def parameter_value(scene: Scene, name: str) -> float | None:
    """Return the value of a number of a scene in SI units, or None if it has no value."""
    value = scene.arc.dip if name == DIP.name else scene.numbers.get(name)
    return None if value is None else float(np.asarray(value))


def with_parameters(scene: Scene, values: Values) -> Scene:
    """Return a scene with other values of its numbers in SI units, each a number or an array.

    The new scene has no distributions.

    Raises
    ------
    ValueError
        If the new scene is invalid. The message lists all mistakes.
    """
    numbers = {}
    for name, value in values.items():
        is_array = array_of(value).ndim > 0
        numbers[name] = value if is_array else real_number(value)
    changed = _fields_with(scene, numbers)
    of_arc = changed.pop("arc")
    arc = replace(scene.arc, **of_arc) if of_arc else scene.arc
    return replace(scene, arc=arc, **changed)


def taken(scene: Scene, select: Function) -> Scene:
    """Return selected lanes of a scene; ``select`` indexes an array of the scene's shape. No checks are repeated."""

    def of_lanes(value: Any, axes: int = 0) -> Any:
        shape = np.shape(value)
        if len(shape) <= axes:
            return value
        own_axes = shape[len(shape) - axes :]
        every_lane = np.broadcast_to(value, scene.shape + own_axes)
        lanes = select(every_lane)
        return plain(lanes)

    chosen = {}
    for name, value in scene.numbers.items():
        if np.ndim(value):
            chosen[name] = of_lanes(value)
    shaking = scene.checked_effects.get("shaking", {})
    for name in _OTHER_FACTOR:
        if name not in shaking:  # determined by the other
            chosen.pop(f"shaking.{name}", None)
    of_lane = scene.arc.with_lanes(of_lanes)
    some = replace_unchecked(scene, {"arc": of_lane})
    changed = _fields_with(some, chosen)
    arc = replace_unchecked(of_lane, changed["arc"])
    factors = {name: of_lanes(vars(scene)[name]) for name in ("strength_factor", "set_by_start") if name in vars(scene)}
    return replace_unchecked(some, changed | factors | {"arc": arc})


def with_parameter_arrays(scene: Scene, values: Mapping[str, Floats]) -> tuple[Scene, Flags]:
    """Return a scene with arrays of numbers in SI units, and a mask of its invalid lanes, for `solve`.

    A value out of bounds or an impossible section makes its lane invalid and raises no error. In such lanes the scene
    has the values of the first valid lane.
    """
    known = possible_parameters(scene)
    allowed_by_name = [known[name].allows(value) for name, value in values.items()]
    allowed = np.broadcast_arrays(*allowed_by_name)
    invalid = ~np.logical_and.reduce(allowed)
    before: ValueDict = {name: parameter_value(scene, name) for name in values}
    while True:
        none_valid = bool(np.all(invalid))
        first_valid = 0 if none_valid else np.argmin(invalid)
        valid_values = {}
        for name, value in values.items():
            stand_in = before[name] if none_valid else value[first_valid]
            valid_values[name] = np.where(invalid, stand_in, value)
        changed = _fields_with(scene, valid_values)
        arc = replace_unchecked(scene.arc, changed["arc"])
        faults = () if none_valid or arc is scene.arc else arc.geometry_errors()
        impossible = next((lanes for lanes, _ in faults if np.any(lanes)), None)
        if impossible is None:
            lanes: Scene = replace_unchecked(scene, changed | {"arc": arc})
            lanes.start_anew()
            return lanes, invalid
        if impossible.size > 1:
            impossible = impossible.reshape(invalid.shape)
        invalid = invalid | impossible


def _fields_with(scene: Scene, values: Values) -> ValueDict:
    """Return the changed fields of a scene, and of its arc under "arc", for other values of numbers, without checks."""
    arc = changed_fields(scene.arc, values)
    if DIP.name in values:
        change = scene.arc.dip - values[DIP.name]
        turn = scene.arc.facing * change
        for end in ("theta_1", "theta_2"):
            theta = np.asarray(getattr(scene.arc, end))
            arc[end] = theta + turn
    of_arc = {DIP.name, *scene.arc.numbers_by_name()}
    effects = {name: dict(given) for name, given in scene.checked_effects.items()}
    friction = scene.friction
    others: ValueDict = {}
    for name, value in values.items():
        table, _, number = name.partition(".")
        if name in of_arc:
            continue
        if table == "friction":
            friction = _friction_with(friction, number, value)
        elif number:
            given = effects.setdefault(table, {})
            other_name = _OTHER_FACTOR.get(number, "")
            if f"{table}.{other_name}" in values:
                both = f"{{{name}}} and {{{table}.{other_name}}}"
                raise InputError("", [f"{both} exclude each other: one is the other times the record's peak; vary one"])
            given.pop(other_name, None)
            given[number] = value
        else:
            others[name] = value
    return {"arc": arc, "effects": effects, "friction": friction, "uncertain": {}} | others


def _friction_with(friction: Any, number: str, value: Any) -> Any:
    """Return a friction with another value of one number: "" for a constant, "rate.peak" for the law of speed."""
    if not number:
        beside_rate = isinstance(friction, Mapping) and friction["law"] == "constant"
        return {**friction, "coefficient": value} if beside_rate else value
    assert isinstance(friction, Mapping)
    rate, _, name = number.rpartition(".")
    if not rate:
        return {**friction, name: value}
    law_of_speed = {**friction[rate], name: value}
    return {**friction, rate: law_of_speed}
