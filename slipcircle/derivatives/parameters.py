"""Numbers of a scene that may vary, by their SI names, with scales, and scenes with other values of them.

Names are the paths of the tree of numbers (``radius``, ``ground.3.y``, ``friction.peak``, ``cohesion.cohesion``), and
``dip`` for the chord of an arc, which turns both its ends. Grids, samples, fits and derivatives replace values by these
names. The file reader translates them to keys of scene files.
"""

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from generated.effects import Parameter
from slipcircle.base.arrays import array_of, float_or_array, real_number
from slipcircle.base.kinds import ArrayMap, Flags, Shape, Values
from slipcircle.core.scene.scene import Scene, checked_scene
from slipcircle.tree import Leaf, leaves, mapped, put, replace_unchecked

USUAL_WEIGHT = 2e4  # usual unit weight of soils, N/m^3


class Free(NamedTuple):
    """Number of a single scene that may vary alone: SI unit, open bounds, value, and a power of 2 as its scale."""

    name: str
    unit: str
    lower: float
    upper: float
    value: float
    scale: float


def possible_parameters(scene: Scene) -> dict[str, Leaf]:
    """Return every number that a scene with this mass and friction law may have, with or without a value, by name."""
    return {leaf.path: leaf for leaf in leaves(scene)}


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
    if checked_scene(scene, "parameters").shape:
        raise ValueError("parameters: takes a single scene; give one case of the ensemble")
    numbers = scene.numbers
    left_out = {"width", *scene.arc.numbers_without_effect()}
    if "shaking.peak" in numbers:
        left_out.add("shaking.scale")
    first = ["friction"] if "friction" in numbers else []
    chosen = []
    for name in dict.fromkeys([*first, *numbers]):
        absent_at_zero = name == "initial_velocity" or name.endswith(".pore_ratio") or name.startswith("shaking.")
        if (np.any(numbers[name]) or not absent_at_zero) and name not in left_out:
            chosen.append(name)
    return free_parameters(scene, chosen)


def free_parameters(scene: Scene[float], names: Iterable[str]) -> dict[str, Free]:
    """Return selected numbers of a single scene by name, with values and scales.

    `names` are paths such as "friction.peak".
    """
    possible = possible_parameters(scene)
    free = dict[str, Free]()
    for name in names:
        leaf = possible[name]
        number = leaf.number
        value = float(np.asarray(leaf.value))
        scale = _scale(scene.arc, name, number, value)
        bounds = number.lower, number.upper
        free[name] = Free(name, number.unit, *bounds, value, scale)
    return free


def _scale(arc: Any, name: str, parameter: Parameter, value: float) -> float:
    """Return the scale of a number as a power of 2, so that steps are exact.

    `name` is its path, `parameter` its declaration, and the value is in SI units.
    """
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
    *_, quantity = name.split(".")
    if quantity in ("x", "y", "top"):
        size = radius / 16
    elif parameter.unit == "rad":
        size = abs(arc.theta_2 - arc.theta_1)
    else:
        size = abs(value) or usual.get(parameter.unit, 1.0)
    exponent = round(math.log2(size))
    return float(2.0**exponent)


def parameter_value(scene: Scene, name: str) -> float | None:
    """Return the value of a number of a scene in SI units by its path, or None if it has no value.

    The path is a name such as "friction.peak".
    """
    leaf = possible_parameters(scene).get(name)
    if leaf is None or leaf.value is None:
        return None
    return float(np.asarray(leaf.value))


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
        numbers[name] = value if array_of(value).ndim else real_number(value)
    values = scene.arc.together(numbers)
    changed = put(scene, values)
    arc = scene.arc if changed.arc is scene.arc else replace(changed.arc)
    return replace(changed, arc=arc, uncertain={})


def lanes_of(scene: Scene, index: Any, flat: bool = False) -> Scene:
    """Return selected lanes of a scene, by an index of its shape, or of its lanes in one row if `flat`.

    Nothing is checked. A lane is a member of an ensemble.
    """
    shape: Shape = ()

    def of_lanes(value: Any) -> Any:
        nonlocal shape
        if not np.ndim(value):
            return value
        every_lane = np.broadcast_to(value, scene.shape)
        if flat:
            every_lane = every_lane.ravel()
        selected = every_lane[index]
        shape = selected.shape
        return float_or_array(selected)

    lanes: Scene = mapped(scene, of_lanes)
    vars(lanes)["shape"] = shape  # known without its numbers
    return lanes


def with_parameter_arrays(scene: Scene, values: ArrayMap) -> tuple[Scene, Flags]:
    """Return a scene with arrays of numbers in SI units, and a mask of its invalid lanes, for `solve`.

    A value out of bounds or an impossible section makes its lane invalid and raises no error. In such lanes the scene
    has the values of the first valid lane.
    """
    possible = possible_parameters(scene)
    by_name = []
    for name, value in values.items():
        of_name = possible[name].number
        by_name.append(of_name.allows(value))
    allowed = np.broadcast_arrays(*by_name)
    invalid = ~np.logical_and.reduce(allowed)
    while True:
        none_valid = bool(np.all(invalid))
        first_valid = 0 if none_valid else np.argmin(invalid)
        valid_values = {}
        for name, value in values.items():
            stand_in = possible[name].value if none_valid else value[first_valid]
            valid_values[name] = np.where(invalid, stand_in, value)
        changed = put(scene, scene.arc.together(valid_values))
        arc = changed.arc
        is_checked = none_valid or arc is scene.arc
        faults = () if is_checked else arc.geometry_errors()
        impossible = next((lanes for lanes, _ in faults if np.any(lanes)), None)
        if impossible is None:
            lanes: Scene = replace_unchecked(changed, {"uncertain": {}})
            if not scene.shape:
                vars(lanes)["shape"] = invalid.shape  # known without its numbers
            lanes.start_anew()
            return lanes, invalid
        if impossible.size > 1:
            impossible = impossible.reshape(invalid.shape)
        invalid = invalid | impossible
