"""The numbers of a scene that may vary, by their SI names, and scenes with other values of them.

Names are those of `Scene.numbers` (``radius``, ``ground.3.y``, ``friction.peak``, ``cohesion.cohesion``), and ``dip``,
of the chord of an arc, with which both its ends turn. A grid, a sample of uncertain numbers, a fit and a derivative
all replace values by these names; how a scene file calls them is the file reader's affair.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated import effects as declared
from slipcircle.core.scene.arc import ARC_BOUNDS
from slipcircle.core.scene.coordinates import arc_numbers, changed_fields, replace_unchecked
from slipcircle.core.scene.friction import law_parts, law_paths, without_soil
from slipcircle.core.scene.ground import FAR
from slipcircle.core.scene.scene import Scene

ARC_UNITS = {
    "radius": "m",
    "theta_1": "rad",
    "theta_2": "rad",
    "unit_weight": "N/m^3",
    "gravity": "m/s^2",
    "width": "m",
}
_STRESS, _COEFFICIENT = (-5e-324, 1e12), ("", -5e-324, declared.LIMITS[""][1])
SOIL_BOUNDS: dict[str, tuple[str, float, float]] = {
    "unit_weight": ("N/m^3", 0.0, 1e6),
    "saturated_unit_weight": ("N/m^3", 0.0, 1e6),
    "cohesion": ("Pa", *_STRESS),
    "cohesion_gradient": ("Pa/m", *_STRESS),
    "pore_ratio": ("", -5e-324, 1.0),
    "top": ("m", -FAR, FAR),
    "friction": _COEFFICIENT,
    "peak": _COEFFICIENT,
    "residual": _COEFFICIENT,
    "length": ("m", *declared.LIMITS["m"]),
    "velocity": ("m/s", *declared.LIMITS["m/s"]),
    "pressure": ("Pa", *_STRESS),
    "crack": ("m", 0.0, FAR),
}
SMALLEST = 5e-324  # a lower bound of minus this allows zero, as all bounds are open


@dataclass(frozen=True)
class Parameter:
    """A number that a scene may have: its name, SI unit, and open bounds."""

    name: str
    unit: str
    lower: float
    upper: float

    def allows(self, values: Any) -> Any:
        """Which values lie within the bounds; never what is infinite or NaN."""
        return (values > self.lower) & (values < self.upper) & (abs(values) < math.inf)


DIP = Parameter("dip", "rad", -SMALLEST, math.pi / 2)
_MOTION = (
    Parameter("initial_velocity", "m/s", -declared.LIMITS["m/s"][1], declared.LIMITS["m/s"][1]),
    Parameter("end_time", "s", *declared.LIMITS["s"]),
)


def parameters(scene: Scene) -> dict[str, Parameter]:
    """Every number that a scene with this arc and friction law may have, whether it has a value of it or not."""
    arc = scene.arc
    of_arc = [Parameter(n, ARC_UNITS[n], *ARC_BOUNDS[n][:2]) for n in ARC_BOUNDS if n in arc.quantities]
    if "ground" in arc.quantities:
        of_arc += [Parameter(name, "m", -FAR, FAR) for name in arc_numbers(arc) if "." in name]
    else:
        of_arc.append(DIP)
    of_arc += [Parameter(name, *SOIL_BOUNDS[name.rpartition(".")[2]]) for name in arc.other_numbers()]
    of_law: list[Parameter] = []
    for path, (name, _) in zip(law_paths(scene.friction), law_parts(scene.friction), strict=True):
        law = without_soil(name)
        if law in declared.LAWS and not path.startswith("soils."):
            of_law += _scalars(path, declared.LAWS[law].parameters)
    of_effects = [p for name, effect in declared.EFFECTS.items() for p in _scalars(name, effect.parameters)]
    return {p.name: p for p in (*_MOTION, *of_arc, *of_law, *of_effects)}


def _scalars(path: str, parameters: Iterable[declared.Parameter]) -> list[Parameter]:
    """Those declared parameters of a law or an effect that are one number, or a function of time that may be one."""
    scalar = [p for p in parameters if p.kind in ("number", "series")]
    name_of = {"friction.coefficient": "friction"}
    names = [f"{path}.{p.name}" for p in scalar]
    return [Parameter(name_of.get(n, n), p.unit, p.lower, p.upper) for n, p in zip(names, scalar, strict=True)]


def parameter_value(scene: Scene, name: str) -> float | None:
    """The value of one number of a scene, SI; None where it has none."""
    value = scene.arc.dip if name == DIP.name else scene.numbers.get(name)
    return None if value is None else float(np.asarray(value))


def with_parameters(scene: Scene, values: Mapping[str, Any]) -> Scene:
    """A scene with other values of its numbers, SI: of each one number, or an array of them.

    Nothing of it is uncertain any more.

    Raises
    ------
    ValueError
        If that is no scene; lists every mistake.
    """
    changed = _fields_with(scene, {n: v if np.ndim(v) else float(v) for n, v in values.items()})
    arc = replace(scene.arc, **changed["arc"]) if changed["arc"] else scene.arc
    return Scene(**_fields_of(scene) | changed | {"arc": arc})


def with_parameter_arrays(scene: Scene, values: Mapping[str, NDArray[np.float64]]) -> tuple[Scene, NDArray[np.bool_]]:
    """A scene of arrays of numbers, SI, and which of its lanes are no scenes: `solve` takes both.

    A value out of bounds or an impossible section makes its lane invalid, not the call an error. In such lanes the
    scene has the values of the first valid one.
    """
    known = parameters(scene)
    allowed = np.broadcast_arrays(*(known[name].allows(value) for name, value in values.items()))
    invalid = ~np.logical_and.reduce(allowed)
    before: dict[str, Any] = {name: parameter_value(scene, name) for name in values}
    while True:
        stand_in = before if np.all(invalid) else {name: value[np.argmin(invalid)] for name, value in values.items()}
        valid_values = {name: np.where(invalid, stand_in[name], value) for name, value in values.items()}
        changed = _fields_with(scene, valid_values)
        arc = replace_unchecked(scene.arc, changed["arc"])
        faults = arc.geometry_errors() if arc is not scene.arc and not np.all(invalid) else ()
        impossible = next((lanes for lanes, _ in faults if np.any(lanes)), None)
        if impossible is None:
            break
        invalid = invalid | (impossible if impossible.size == 1 else impossible.reshape(invalid.shape))
    return replace_unchecked(scene, changed | {"arc": arc}), invalid


def _fields_of(scene: Scene) -> dict[str, Any]:
    """What a scene is made of, by the names of its fields."""
    return {f.name: getattr(scene, f.name) for f in fields(Scene)}


def _fields_with(scene: Scene, values: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of a scene, and under "arc" those of its arc that change, with other values of numbers; unchecked."""
    arc = changed_fields(scene.arc, values)
    if DIP.name in values:
        turn = scene.arc.facing * (scene.arc.dip - values[DIP.name])
        arc |= {end: np.asarray(getattr(scene.arc, end)) + turn for end in ("theta_1", "theta_2")}
    of_arc = {DIP.name, *arc_numbers(scene.arc)}
    assert isinstance(scene.effects, dict)
    effects = {name: dict(given) for name, given in scene.effects.items()}
    friction = scene.friction
    others: dict[str, Any] = {}
    for name, value in values.items():
        table, _, number = name.partition(".")
        if name in of_arc:
            continue
        if table == "friction":
            friction = _friction_with(friction, number, value)
        elif number:
            given = effects.setdefault(table, {})
            given.pop({"peak": "scale", "scale": "peak"}.get(number, ""), None)  # two names of one factor
            given[number] = value
        else:
            others[name] = value
    return {"arc": arc, "effects": effects, "friction": friction, "uncertain": {}} | others


def _friction_with(friction: Any, number: str, value: Any) -> Any:
    """A friction with another value of one number: "" is a constant's, "rate.peak" of the law of speed beside it."""
    if not number:
        return value
    assert isinstance(friction, Mapping)
    rate, _, name = number.rpartition(".")
    return {**friction, rate: {**friction[rate], name: value}} if rate else {**friction, number: value}
