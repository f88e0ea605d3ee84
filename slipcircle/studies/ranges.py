"""Where a number that is looked for may lie, closer where motions change faster."""

import math
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import lanes_of
from slipcircle.scene.friction import law_depends
from slipcircle.scene.numbers import Number, lengths
from slipcircle.scene.scene import Scene
from slipcircle.scene.varied import scenes_with, value_in
from slipcircle.studies.search import MOST_SWINGS

Floats = NDArray[np.float64]


def range_of(scene: Scene, field: Number, alone: bool) -> Floats:
    """Values of a field in its unit, from the least to the greatest; farther where other fields change as well."""
    arc = scene.arc
    stress, radius, gravity = (float(np.asarray(v)) for v in (arc.static_normal_stress, arc.radius, arc.gravity))
    speed, own = 2 * math.sqrt(gravity * radius), value_in(scene, field)

    def other(end: str) -> float:
        return float(np.asarray(getattr(arc, end)))

    end = 1.0 - 10.0 ** -np.arange(2.0, 13.0, 2.0)
    linear = np.concatenate([np.linspace(0.0, 1.0, 81)[:-1], end])
    ranges: Mapping[str, Callable[[], Floats]] = {
        "initial_velocity": lambda: np.linspace(-speed, speed, 241),
        "dip": lambda: np.pi / 2 * np.concatenate([-linear[:0:-1], linear]),
        "theta_1": lambda: other("theta_2") - np.pi * linear[1:],
        "theta_2": lambda: other("theta_1") + np.pi * linear[1:],
        "cohesion.cohesion": lambda: np.concatenate([[0.0], stress * np.geomspace(1e-6, 100.0, 161)]),
        "pore_pressure.ratio": lambda: linear,
        "pore_pressure.pressure": lambda: stress * linear,
        "drag.xi": lambda: gravity * np.geomspace(1e-3, 1e9, 193),
        "friction.length": lambda: radius * np.geomspace(1e-9, 10.0, 161),
    }
    if field.name in ranges:
        values = ranges[field.name]()
    elif field.name.startswith("friction") and (field.tangent or not field.unit):
        values = _frictions(scene, field, alone)
    elif own is None:
        raise ValueError(f"backanalyse: field = {field.key!r}: give bounds, as the scene has no value of it")
    elif field.name in lengths(arc):
        values = own + radius * np.linspace(-1.0, 1.0, 401)  # in place of it
    else:
        values = (abs(own) or 1.0) * np.geomspace(1e-3, 1e3, 121)
    return np.unique(field.from_si(values))


def _frictions(scene: Scene, field: Number, alone: bool) -> Floats:
    """From so little that the mass swings to the limit, beyond which nothing moves from rest."""
    still, _ = scenes_with(scene, {field.name: np.zeros(1)})
    limit = float(lanes_of(plan(still)).statics["limit_friction"][0])
    limit = limit if 1e-6 < limit < math.inf else 1.0
    shares = [np.geomspace(0.5 / MOST_SWINGS, 1.0, 129), np.linspace(0.5 / MOST_SWINGS, 1.0, 129),
              1.0 - 10.0 ** -np.arange(3.0, 13.0)]  # fmt: skip
    if field.name == "friction" and scene.end_time is None and not any(EFFECTS[e].turns for e in scene.called):
        shares = [np.ones(1)]  # with less it never rests
    shaken = "shaking" in scene.called  # it moves what would stand
    creeps = "speed" in law_depends(scene.friction)  # with more it creeps, which takes long to follow
    if alone and not creeps and (float(np.asarray(scene.initial_velocity)) != 0.0 or field.name != "friction"):
        shares.append(np.geomspace(1.0, 1e3, 61))
    if shaken or not alone:
        shares.append(np.linspace(1.0, max(3.0 / limit, 2.0), 81))
    return limit * np.concatenate(shares)
