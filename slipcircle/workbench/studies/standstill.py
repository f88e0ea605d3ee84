"""Values of a scene's parameters at which its mass would just stay at rest."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats, NumberDict
from slipcircle.core import Scene
from slipcircle.derivatives import parameter_value
from slipcircle.workbench.common.starting import method_of
from slipcircle.workbench.studies.motions import factors_at_start

_ACCURACY = 1e-9  # of lanes whose motion is not computed
_SHARES = np.geomspace(1e-4, 3.0, 48)  # of the size of a parameter, to both sides of its value
_PARTS = 16  # of a bracket
_ROUNDS = 7


def standstills(scene: Scene, sizes: Iterable[tuple[str, float]]) -> NumberDict:
    """Return by name the nearest value, in SI units, of each parameter for a factor of safety of 1 at the start.

    The factor is computed by the starting method on the scene's circle. ``sizes`` has the names of parameters and the
    scales of their changes. Parameters without such a value are absent. The result is empty if the start does not
    depend on the factor alone: with shaking, an initial velocity or water that changes with time.
    """
    water = scene.called.get("pore_pressure", {})
    pressures = {name: value for name, value in water.items() if name not in ("level", "standing")}
    in_time = {"record", "time"} & {*pressures} or any(map(callable, pressures.values()))
    if in_time or "shaking" in scene.called or np.any(scene.initial_velocity):
        return {}
    values = {}
    for name, size in sizes:
        value = parameter_value(scene, name)
        if value is None:
            continue
        ends = [_nearest(scene, name, value, side * size) for side in (-1.0, 1.0)]
        distances = [end - value for end in ends if end is not None]
        if distances:
            values[name] = value + min(distances, key=abs)
    return values


def _nearest(scene: Scene, name: str, value: float, size: float) -> float | None:
    """Return the nearest value on one side where the factor crosses 1; None without such a value.

    All are in SI units; ``value`` is the parameter's own, and the sign of ``size``, its scale, selects the side.
    """
    places = value + size * np.append(0.0, _SHARES)
    for _ in range(_ROUNDS):
        excess = _excess(scene, name, places)
        changes = np.flatnonzero(excess[:-1] * excess[1:] <= 0.0)
        if not changes.size:
            return None
        first = changes[0]
        places = np.linspace(places[first], places[first + 1], _PARTS + 1)
    return float(places.mean())


def _excess(scene: Any, name: str, values: Floats) -> Floats:
    """Return the factor of safety by the starting method minus 1, for values of a parameter in SI units."""
    by_method = factors_at_start(scene, {name: values}, _ACCURACY)
    return np.asarray(by_method.get(method_of(scene), next(iter(by_method.values())))) - 1.0
