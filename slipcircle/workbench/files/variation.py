"""Scenes with other numbers: one value of each, or an array of them, of which some may be no scene."""

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.core.scene.scene import Scene
from slipcircle.core.scene.section import Section
from slipcircle.workbench.files.numbers import DIP, by_key, fields_with, numbers_in
from slipcircle.workbench.stability.search import critical
from slipcircle.workbench.stability.stability import soil


def value_in(scene: Scene, name: str) -> float | None:
    """The value that a scene has of a number, SI; none where it has none."""
    value = scene.arc.dip if name == DIP.name else scene.numbers.get(name)
    return None if value is None else float(np.asarray(value))


def parts_with(scene: Scene, values: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of a scene, of its arc those that change, with other values of its numbers by name, SI; unchecked."""
    arc = fields_with(scene.arc, values)
    assert isinstance(scene.effects, dict)
    effects = {e: dict(given) for e, given in scene.effects.items()}
    top: dict[str, Any] = {"uncertain": {}}
    friction, of_arc = scene.friction, numbers_in(scene.arc)
    for name, value in values.items():
        head, _, tail = name.partition(".")
        if name == DIP.name:
            arc |= {
                n: np.asarray(getattr(scene.arc, n)) + scene.arc.facing * (scene.arc.dip - value)
                for n in ("theta_1", "theta_2")
            }
        elif name in of_arc:
            continue
        elif name == "friction":
            friction = value
        elif head == "friction":
            assert isinstance(friction, Mapping)
            inner, _, last = tail.rpartition(".")  # of a law, or of a law of speed that multiplies it
            friction = {**friction, inner: {**friction[inner], last: value}} if inner else {**friction, tail: value}
        elif tail:
            own = effects.setdefault(head, {})
            own.pop({"peak": "scale", "scale": "peak"}.get(tail, ""), None)  # two names of one factor
            own[tail] = value
        else:
            top[name] = value
    return {"arc": arc, "effects": effects, "friction": friction} | top


def unchecked(whole: Any, values: Mapping[str, Any]) -> Any:
    """A dataclass with other values, which were checked elsewhere, or will be; itself, where none is other."""
    if all(value is getattr(whole, name) for name, value in values.items()):
        return whole
    found = object.__new__(type(whole))
    for f in fields(whole):
        object.__setattr__(found, f.name, values.get(f.name, getattr(whole, f.name)))
    return found


def other_way(scene: Scene) -> Scene:
    """A shaken scene with its horizontal shaking turned around."""
    if "shaking" not in scene.called:
        raise ValueError(f"{scene.name}: nothing shakes it, so that it has no other polarity")
    assert isinstance(scene.effects, dict)
    shaking = scene.effects["shaking"]
    turned = {"shaking": shaking | {"horizontal": shaking["horizontal"].scaled(-1.0)}}
    return replace(scene, effects=scene.effects | turned, name=f"{scene.name} reversed")


def scene_with(scene: Scene, values: Mapping[str, Any]) -> Scene:
    """A scene with other values of its numbers, or arrays of them, which are checked; what was said of its
    stability is not theirs.
    """
    parts = parts_with(scene, {n: v if np.ndim(v) else float(v) for n, v in values.items()})
    arc = replace(scene.arc, **parts["arc"]) if parts["arc"] else scene.arc
    return replace(scene, **parts | {"arc": arc, "stability": None})


def along_means(scene: Scene) -> Scene:
    """A scene that asks for the critical circle, along that of the means of its uncertain numbers."""
    found = scene.stability
    if found is None or not found.method:
        return scene
    assert isinstance(scene.arc, Section)
    mean = scene_with(scene, {n: float(u.number.to_si(u.moments[0])) for n, u in scene.uncertain.items()})
    assert isinstance(mean.arc, Section)
    now, weight = soil(mean.friction, mean.called), float(np.asarray(mean.arc.unit_weight))
    slope = replace(found.slope, ground=mean.arc.ground, level=mean.arc.level, unit_weight=weight, **now)
    pairs = [(getattr(slope, f.name), getattr(found.slope, f.name)) for f in fields(slope)]
    if all(one is other or np.allclose(one, other, rtol=1e-12, atol=0.0) for one, other in pairs):
        return scene
    found = critical(slope, found.method, **found.limits)
    section = replace(scene.arc, centre=found.centre, radius=found.radius, between=found.between)
    return replace(scene, arc=section, stability=found.without_map())


def scenes_with(scene: Scene, values: Mapping[str, NDArray[np.float64]]) -> tuple[Scene, NDArray[np.bool_]]:
    """A scene of arrays, unchecked, and which of them are no scenes: the first that is one stands in their place."""
    known = {n.name: n.plain for n in by_key(scene).values() if not n.tangent}
    bad = ~np.logical_and.reduce([*np.broadcast_arrays(*(known[n].holds(v) for n, v in values.items()))])
    own: dict[str, Any] = {n: value_in(scene, n) for n in values}
    while True:
        fill = own if np.all(bad) else {n: v[np.argmin(bad)] for n, v in values.items()}
        parts = parts_with(scene, {n: np.where(bad, fill[n], v) for n, v in values.items()})
        arc = unchecked(scene.arc, parts["arc"])
        wrong = arc.faults() if arc is not scene.arc and not np.all(bad) else ()
        more = next((lanes for lanes, _ in wrong if np.any(lanes)), None)
        if more is None:
            break
        bad = bad | (more if more.size == 1 else more.reshape(bad.shape))
    return unchecked(scene, parts | {"arc": arc}), bad
