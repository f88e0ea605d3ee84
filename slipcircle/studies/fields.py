"""A number of a scene that is looked for: how to change it, where it may lie, and derivatives by it."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.balance import bind
from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import CLOSED_IN_PHASE_PLANE, CLOSED_IN_TIME, INTEGRATION, plan
from slipcircle.motion.solver import solve_one
from slipcircle.scene.friction import law_name
from slipcircle.scene.scene import Scene
from slipcircle.sensitivity import OF_SCENE

Floats = NDArray[np.float64]
OBSERVED = {"runout": "run_out", "peak_velocity": "peak_velocity", "duration": "duration"}
MOST_SWINGS = 12  # of a motion in a search: below, run-out hardly depends on friction, and has ever more solutions
MOST_STEPS = 1000  # of SciPy for one phase of such a motion, five times what is usual: slower ones creep
ROUGH = 1e-5  # accuracy of what is only followed, where each motion costs milliseconds
_STEP = 1e-5  # of differences, relative


class Field:
    """One number of a scene that can be changed.

    Attributes
    ----------
    name, unit : str
    """

    def __init__(self, scene: Scene, name: str) -> None:
        self.scene = scene
        if scene.shape:
            raise ValueError("backanalyse: takes one scene of plain numbers, not an ensemble")
        every = [
            (e.name, p) for e in EFFECTS.values() for p in e.parameters if p.kind in ("number", "series") and p.key
        ]
        effects = {f"{e}.{p.name}": p for e, p in every}
        names = [p.name for _, p in every]
        short = {p.name: f"{e}.{p.name}" for e, p in every if names.count(p.name) == 1}
        known = dict(OF_SCENE) | {"dip": "rad"}
        if law_name(scene.friction) != "constant":
            del known["friction"]
        known |= {n: "" for n in scene.numbers if n.startswith("friction.")}
        known |= {n: unit for n, unit in (("friction.length", "m"), ("friction.velocity", "m/s")) if n in known}
        self.name = short.get(name, name)
        if self.name not in known and self.name not in effects:
            listed = ", ".join([*known, *(n for n in effects if n not in short.values()), *short])
            raise ValueError(f"backanalyse: field = {name!r}: must be one of {listed}")
        if scene.arc.given is not None and self.name in ("theta_1", "theta_2", "dip"):
            raise ValueError(f"backanalyse: field = {name!r}: the arc's coefficients are given, and do not follow it")
        self.unit = known[self.name] if self.name in known else effects[self.name].unit

    def scene_with(self, value: float) -> Scene:
        """The scene with this value."""
        return self.put(self.scene, value)

    def put(self, scene: Scene, value: float) -> Scene:
        """Another scene of the same effects with this value."""
        arc = scene.arc
        head, _, tail = self.name.partition(".")
        if self.name in ("friction", "initial_velocity"):
            return replace(scene, **{self.name: value})  # type: ignore[arg-type]
        if head == "friction":
            assert isinstance(scene.friction, Mapping)
            return replace(scene, friction={**scene.friction, tail: value})
        if self.name == "dip":
            turn = float(arc.dip) - value
            ends = {n: float(np.asarray(getattr(arc, n))) + turn for n in ("theta_1", "theta_2")}
            return replace(scene, arc=replace(arc, **ends))  # type: ignore[arg-type]
        if tail:
            return replace(scene, effects={**scene.called, head: {**scene.called.get(head, {}), tail: value}})
        return replace(scene, arc=replace(arc, **{self.name: value}))  # type: ignore[arg-type]

    def range(self, alone: bool = True) -> list[float]:
        """Where its value may lie, closer where motions change faster; farther where other fields change as well."""
        arc = self.scene.arc
        now = {
            n: float(np.asarray(getattr(arc, n))) for n in ("radius", "unit_weight", "gravity", "theta_1", "theta_2")
        }
        stress = float(arc.static_normal_stress)
        speed = 2 * math.sqrt(now["gravity"] * now["radius"])
        end = 1.0 - 10.0 ** -np.arange(2.0, 13.0, 2.0)
        linear = np.concatenate([np.linspace(0.0, 1.0, 41)[:-1], end])
        wide = np.geomspace(1e-3, 1e3, 61)
        ranges: dict[str, Callable[[], Any]] = {
            "friction": lambda: self._frictions(alone),
            "initial_velocity": lambda: np.linspace(-speed, speed, 121),
            "dip": lambda: np.pi / 2 * np.concatenate([-linear[:0:-1], linear]),
            "theta_1": lambda: now["theta_2"] - np.pi * linear[1:],
            "theta_2": lambda: now["theta_1"] + np.pi * linear[1:],
            "cohesion.cohesion": lambda: np.concatenate([[0.0], stress * np.geomspace(1e-6, 100.0, 81)]),
            "pore_pressure.ratio": lambda: linear,
            "pore_pressure.pressure": lambda: stress * linear,
            "drag.xi": lambda: now["gravity"] * np.geomspace(1e-3, 1e9, 97),
            "friction.length": lambda: now["radius"] * np.geomspace(1e-9, 10.0, 81),
        }
        if self.name in ranges:
            return sorted(float(v) for v in ranges[self.name]())
        if self.name.startswith("friction.") and not self.unit:
            return self._frictions(alone)
        if self.name not in now and self.name not in self.scene.numbers:
            raise ValueError(f"backanalyse: field = {self.name!r}: give bounds, as the scene has no value of it")
        size = abs(float(np.asarray(self.scene.numbers[self.name]))) or 1.0
        return [float(v) for v in size * wide]

    def _frictions(self, alone: bool) -> list[float]:
        """From none to the limit, beyond which nothing moves from rest."""
        scene = self.scene_with(0.0)
        balance = bind(scene)
        at = balance.position(0.0, -1 if balance.fall < 0.0 else 1)
        limit = float(balance.get("limit_friction", **at)) if balance.get("normal", **at) > 0.0 else 1.0
        limit = max(limit, 1e-6)
        shares = [*np.linspace(0.0, 1.0, 41), *1 / np.arange(1.0, 2 * MOST_SWINGS + 2, 0.5)]
        shares += [*(1.0 - 10.0 ** -np.arange(2.0, 13.0))]
        if alone and (float(np.asarray(scene.initial_velocity)) != 0.0 or self.name != "friction"):
            shares += [*np.geomspace(1.0, 1e3 if plan(scene).method != INTEGRATION else 10.0, 40)]
        shaken = "shaking" in scene.called  # it moves what would stand
        beyond: Any = np.linspace(limit, max(3.0, 2 * limit), 61 if shaken else 12)[1:] if shaken or not alone else []
        return sorted({float(limit * s) for s in shares} | {float(v) for v in beyond})

    def value_of(self, scene: Scene) -> float:
        """The value in a scene."""
        head, _, tail = self.name.partition(".")
        if tail:
            box = scene.friction if head == "friction" else scene.called[head]
            assert isinstance(box, Mapping)
            return float(box[tail])
        return float(np.asarray(getattr(scene if hasattr(scene, head) else scene.arc, head)))


def attempt(scene: Scene, accuracy: float | None = None) -> Motion | None:
    """A motion of a search; none where there is no such scene, where it never rests, or where it takes too long."""
    try:
        motion = solve_one(plan(scene, accuracy), phases=MOST_SWINGS + 1, steps=MOST_STEPS)
    except ValueError:
        return None
    whole = len(motion.phases) <= MOST_SWINGS and (motion.arrested or scene.end_time is not None)
    return motion if whole else None


def outputs_of(motion: Motion, names: Iterable[str]) -> dict[str, float]:
    """Run-out, peak velocity or duration by name."""
    return {n: float(motion.peak.velocity) if n == "peak_velocity" else float(getattr(motion, n)) for n in names}


def exact(motion: Motion) -> bool:
    """Whether there are exact derivatives, or only differences."""
    return motion.plan.method in (CLOSED_IN_TIME, CLOSED_IN_PHASE_PLANE) and motion.plan.law == "constant"


def slopes(fields: Sequence[Field], motion: Motion, outputs: Sequence[str]) -> Floats:
    """Derivatives of outputs by fields, (outputs, fields): exact where there is a closed form, else by differences."""
    table = motion.sensitivity() if exact(motion) else None
    found = np.empty((len(outputs), len(fields)))
    for k, field in enumerate(fields):
        if table is not None and field.name == "dip":  # it turns both ends, against the angles
            found[:, k] = [-table.derivative(o, "theta_1") - table.derivative(o, "theta_2") for o in outputs]
        elif table is not None and field.name in table.parameters:
            found[:, k] = [table.derivative(o, field.name) for o in outputs]
        else:
            found[:, k] = _differences(field, motion, outputs)
    return found


def _differences(field: Field, motion: Motion, outputs: Sequence[str]) -> list[float]:
    """Central, or to one side where the value is at the end of what it may be, or each motion costs milliseconds."""
    scene, costly = motion.plan.scene, motion.plan.method == INTEGRATION
    value = field.value_of(scene)
    step = _STEP * (abs(value) or (float(scene.arc.static_normal_stress) if field.unit == "Pa" else 1.0))
    ends: list[tuple[float, dict[str, float]]] = []
    for at in (value + step, value - step):
        try:
            there = attempt(field.put(scene, at), motion.plan.accuracy)
        except ValueError:
            there = None
        ends += [] if there is None else [(at, outputs_of(there, outputs))]
        if ends and costly:
            break
    (high, after), (low, before) = (*ends, *2 * [(value, outputs_of(motion, outputs))])[:2]
    return [(after[o] - before[o]) / (high - low) if high != low else math.nan for o in outputs]
