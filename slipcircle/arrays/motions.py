"""The motions of an ensemble: a scene whose fields are arrays, solved together."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.arrays.block import Block, Status
from slipcircle.arrays.lanes import scene_of, solve_block
from slipcircle.balance import bind_lanes
from slipcircle.motion import State
from slipcircle.plan import Plan, plan
from slipcircle.scene import Scene

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Motions:
    """The solved lanes of an ensemble, as arrays of its shape; NaN only where the status says why.

    Attributes
    ----------
    plan : Plan
        How they were solved.
    status : ndarray
        A `slipcircle.arrays.block.Status` of each lane.
    moves, arrested : ndarray of bool
        Whether the mass moves at all, and whether it rests at the end.
    duration, run_out : ndarray
        s, and displacement along the arc at the end, m.
    peak, end : State
        Of arrays, at the greatest speed and at the end.
    error_estimate : ndarray
        Estimated relative error of peak velocity, run-out and duration.
    """

    plan: Plan
    block: Block

    @property
    def shape(self) -> tuple[int, ...]:
        return self.plan.scene.shape

    @property
    def status(self) -> Any:
        return self.block.status.reshape(self.shape)

    @property
    def moves(self) -> Any:
        return self.block.moves.reshape(self.shape)

    @property
    def arrested(self) -> Any:
        return self.block.arrested.reshape(self.shape)

    @property
    def duration(self) -> Any:
        return self.block.duration.reshape(self.shape)

    @property
    def error_estimate(self) -> Any:
        return self.block.error_estimate.reshape(self.shape)

    @property
    def run_out(self) -> Any:
        return np.asarray(self.plan.scene.arc.radius) * self.block.rotation.reshape(self.shape)

    @cached_property
    def end(self) -> State:
        b = self.block
        return self._state(b.duration, b.rotation, b.angular_velocity, b.angular_acceleration)

    @cached_property
    def peak(self) -> State:
        b = self.block
        return self._state(b.peak_time, b.peak_rotation, b.peak_angular_velocity, b.peak_angular_acceleration)

    def count(self) -> dict[str, int]:
        """How many lanes there are of each status."""
        counts = np.bincount(self.block.status, minlength=len(Status))
        return {s.name: int(counts[s]) for s in Status if counts[s]}

    def _state(self, *numbers: Floats) -> State:
        time, rotation, omega, rate = (x.reshape(self.shape) for x in numbers)
        scene, arc = self.plan.scene, self.plan.scene.arc
        radius, scale = np.asarray(arc.radius), arc.time_scale
        with np.errstate(all="ignore"):
            balance = bind_lanes(self.plan.effects, arc, values_of(scene), stress=True)
            at = {"press": balance.press_at(rotation), "omega_2": (omega * scale) ** 2}
            if "shaking" in scene.called:
                shaken, names = scene.called["shaking"], {"k_h": "horizontal", "k_v": "vertical"}
                at |= {k: shaken[n](time) for k, n in names.items() if n in shaken}
                at["press_slope"] = balance.press_slope_at(rotation)
            stress = balance.get("normal_stress", **at) * arc.reference_stress
        return State(time, rotation, omega, radius * omega, radius * rotation, radius * rate, stress)


def values_of(scene: Scene) -> dict[str, Any]:
    """What `slipcircle.arrays.lanes.solve_block` reads of a scene, in the scene's own shapes."""
    values: dict[str, Any] = {"end_time": np.inf} | dict(scene.numbers)
    for effect in scene.called:
        given = scene.called[effect]
        numbers = (p for p in EFFECTS[effect].parameters if p.symbol and p.key and not callable(given.get(p.name)))
        values |= {f"{effect}.{p.name}": values.get(f"{effect}.{p.name}", 0.0) for p in numbers}
    values = {n.replace("friction.coefficient", "friction"): np.asarray(v, np.float64) for n, v in values.items()}
    return values | {"given": scene.arc.given}


def _flat(scene: Scene) -> dict[str, Any]:
    """The same as arrays of one length, or numbers."""
    shape = scene.shape
    return {n: np.broadcast_to(v, shape).reshape(-1) if np.ndim(v) else v for n, v in values_of(scene).items()}


def lane(scene: Scene, *index: int) -> Scene:
    """One lane of an ensemble, as a scene of plain numbers."""
    chosen = plan(scene)
    k = int(np.ravel_multi_index(index, scene.shape))
    return scene_of(chosen.effects, _flat(scene), k, *rest_of(chosen))


def solve_ensemble(chosen: Plan) -> Motions:
    """Solve a scene of arrays."""
    scene, (law, fixed) = chosen.scene, rest_of(chosen)
    found = solve_block(chosen.effects, _flat(scene), chosen.accuracy, law, math.prod(scene.shape), fixed)
    return Motions(chosen, found)


def rest_of(chosen: Plan) -> tuple[Any, dict[str, dict[str, Any]]]:
    """What is no array of an ensemble: its law, if friction is not constant, and the effects' functions of time."""
    scene = chosen.scene
    kept = {e: {n: v for n, v in given.items() if f"{e}.{n}" not in scene.numbers} for e, given in scene.called.items()}
    return None if chosen.law == "constant" else scene.friction, {e: rest for e, rest in kept.items() if rest}
