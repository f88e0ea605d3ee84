"""The lanes of a scene: its numbers and arrays with one axis."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from slipcircle.base.kinds import Parameters
from slipcircle.core.problem.lanes import Lanes
from slipcircle.core.scene.coordinates import by_lanes
from slipcircle.core.scene.friction import number_name
from slipcircle.core.scene.scene import Scene


def lanes_of(scene: Scene, accuracy: float, invalid: Any = False) -> Lanes:
    """The lanes of a scene, all its arrays with one axis."""
    shape = scene.shape
    end_time = scene.end_time
    if end_time is None:
        end_time = np.inf
    if not shape:
        friction: Any = scene.friction
        return Lanes(scene.arc, scene.called, friction, scene.initial_velocity, end_time, accuracy, 1, invalid)

    def flat(value: Any, axes: int) -> Any:
        return _flat(value, shape, axes)

    arc = by_lanes(scene.arc, flat)
    assert isinstance(scene.effects, dict)
    effects = dict[str, Any]()
    for effect, parameters in scene.effects.items():
        effects[effect] = _flat_numbers(scene, effect, parameters)
    friction = _flat_friction(scene) if arc.friction is None else arc.friction
    return Lanes(
        arc=arc,
        called=arc.effects_with_own(effects),
        friction=friction,
        velocity=_flat(scene.initial_velocity, shape),
        end_time=_flat(end_time, shape),
        accuracy=accuracy,
        count=math.prod(shape),
        invalid=invalid,
    )


def _flat_friction(scene: Scene) -> Any:
    """Friction with one axis of lanes: a number, or a law's parameters."""
    friction: Any = scene.friction
    if callable(friction):
        return friction
    if not isinstance(friction, Mapping):
        return _flat(friction, scene.shape)
    flat = _flat_numbers(scene, "friction", friction)
    rate = flat.get("rate")
    if isinstance(rate, Mapping):
        flat["rate"] = _flat_numbers(scene, "friction.rate", rate)
    return flat


def _flat_numbers(scene: Scene, path: str, parameters: Parameters) -> dict[str, Any]:
    """Parameters of an effect or a law; those among the scene's numbers may be arrays."""
    flat = dict(parameters)
    for name, value in parameters.items():
        if number_name(path, name) in scene.numbers:
            flat[name] = _flat(value, scene.shape)
    return flat


def _flat(value: Any, shape: tuple[int, ...], axes: int = 0) -> Any:
    """An array with one axis of lanes before its other axes; a value that all lanes share is unchanged."""
    if np.ndim(value) <= axes:
        return value
    array = np.asarray(value, np.float64)
    first_own_axis = array.ndim - axes
    own_shape = array.shape[first_own_axis:]
    if array.shape == (math.prod(shape), *own_shape):
        return array
    in_shape = np.broadcast_to(array, (*shape, *own_shape))
    return in_shape.reshape(-1, *own_shape)
