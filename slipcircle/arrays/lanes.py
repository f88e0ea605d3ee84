"""A block of scenes as plain arrays, solved at once: one lane a scene, and no lane knows of another.

Lanes of a turning mass go through `slipcircle.arrays.swings`, what that does not take through
`slipcircle.arrays.courses`, frozen ones through their closed form in time, and where friction changes with slip through
`slipcircle.arrays.paths`; the few that lift off, or that need more, through the scalar solver.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from generated.effects import EFFECTS
from slipcircle.arc import QUANTITIES, Arc
from slipcircle.arrays.block import NAMES, NUMBERS, Block, Lanes, Status
from slipcircle.arrays.swings import workspace
from slipcircle.balance import Balance, bind_lanes
from slipcircle.friction import law_depends
from slipcircle.plan import plan
from slipcircle.scene import Scene
from slipcircle.solver import solve_one

LANES = 4096  # at once, so that what they need stays in the cache


def solve_block(
    effects: tuple[str, ...], values: Mapping[str, Any], accuracy: float, law: Any = None, lanes: int | None = None,
    fixed: Mapping[str, Mapping[str, Any]] = {},
) -> Block:  # fmt: skip
    """Solve a block of scenes: a pure function of plain arrays.

    Parameters
    ----------
    effects : tuple of str
        In the order of `generated.effects.EFFECTS`.
    values : mapping
        Arrays of one length, or numbers: the arc's by name, ``friction``, ``initial_velocity``, ``end_time`` (infinite
        where there is none), and the effects' parameters as ``effect.parameter``, all of them; ``given`` as `Arc` takes
        it. They need not be valid: what is no scene has the status INVALID.
    accuracy : float
        Relative error asked for.
    law : mapping or callable, optional
        Friction that is not constant, as `Scene` takes it; ``values`` has its numbers as ``friction.name``, and they
        win.
    fixed : mapping, optional
        What is no number of the effects, such as functions of time, by effect. Such lanes, and those of laws and
        effects that depend on more than place, slip and the square of the speed, go through the scalar solver, one by
        one.
    lanes : int, optional
        How many there are, where no value is an array.
    """
    size = max((len(v) for v in values.values() if np.ndim(v)), default=1) if lanes is None else lanes
    numbers = (np.full(size, np.nan) for _ in NUMBERS)
    out = Block(np.full(size, Status.FAILED, np.int8), np.zeros(size, bool), np.zeros(size, bool), *numbers)
    depends = {*law_depends(law)}.union(*(EFFECTS[e].depends_on for e in effects))
    if fixed or callable(law) or depends & {"time", "speed", "history"}:
        for k in range(size):
            _alone(out, k, effects, values, accuracy, law, fixed)
        return out
    work, shared = workspace(min(size, LANES)), None
    own = ("friction", "initial_velocity", "end_time")  # not the balance's
    if not any(np.ndim(v) for n, v in values.items() if n.partition(".")[0] not in own):
        with np.errstate(all="ignore"):
            shared = _bind(effects, values)  # one for all lanes
    for first in range(0, size, LANES):
        part = slice(first, min(first + LANES, size))
        here = {n: v[part] if np.ndim(v) else v for n, v in values.items()}
        view = Block(*(getattr(out, n)[part] for n in NAMES))
        with np.errstate(all="ignore"):
            left = Lanes(here, shared or _bind(effects, here), accuracy, view, work, law).solve()
        for lane in np.flatnonzero(left):
            _alone(out, first + int(lane), effects, values, accuracy, law, {})
    return out


def scene_of(
    effects: tuple[str, ...], values: Mapping[str, Any], k: int, law: Any = None,
    fixed: Mapping[str, Mapping[str, Any]] = {},
) -> Scene:  # fmt: skip
    """One lane of `solve_block` as a scene of plain numbers."""
    at = {n: float(v[k] if np.ndim(v) else v) for n, v in values.items() if n != "given"}
    sizes: dict[str, Any] = {n: at[n] for n in QUANTITIES if n in at}
    arc = Arc(**sizes, given=values.get("given"))
    if isinstance(law, Mapping):
        law = {n: at.get(f"friction.{n}", value) for n, value in law.items()}
    called: dict[str, dict[str, Any]] = {
        e: {p.name: at[f"{e}.{p.name}"] for p in EFFECTS[e].parameters if f"{e}.{p.name}" in at} for e in effects
    }
    called |= {e: called[e] | dict(fixed[e]) for e in fixed}
    end = None if at["end_time"] == np.inf else at["end_time"]
    return Scene(arc, at["friction"] if law is None else law, called, at["initial_velocity"], end)


def _bind(effects: tuple[str, ...], values: Mapping[str, Any]) -> tuple[Balance, Any]:
    """The balance, and the scale of time."""
    arc = Arc.unchecked(**{n: values[n] for n in (*QUANTITIES, "given") if n in values})
    return bind_lanes(effects, arc, values), arc.time_scale


def _alone(
    out: Block, k: int, effects: tuple[str, ...], values: Mapping[str, Any], accuracy: float, law: Any,
    fixed: Mapping[str, Mapping[str, Any]],
) -> None:  # fmt: skip
    """Solve a lane by the scalar solver."""
    try:
        scene = scene_of(effects, values, k, law, fixed)
    except ValueError:
        out.status[k] = Status.INVALID
        return
    try:
        with np.errstate(under="ignore"):
            motion = solve_one(plan(scene, accuracy))
            end, peak, error = motion.end, motion.peak, motion.error_estimate
    except ValueError:
        return
    arc = motion.plan.scene.arc
    found = {
        "moves": motion.moves, "arrested": motion.arrested, "duration": motion.duration,
        "rotation": end.rotation, "angular_velocity": end.angular_velocity,
        "angular_acceleration": end.acceleration / arc.radius, "peak_time": peak.time, "peak_rotation": peak.rotation,
        "peak_angular_velocity": peak.angular_velocity, "peak_angular_acceleration": peak.acceleration / arc.radius,
        "error_estimate": error,
    }  # fmt: skip
    for name, value in found.items():
        getattr(out, name)[k] = value
    turned = len({p.direction for p in motion.phases}) > 1
    status = Status.STAYS if not motion.moves else Status.MOVING if not motion.arrested else Status.RESTS
    status = Status.TURNED if status == Status.RESTS and turned else status
    out.status[k] = Status.ILL_CONDITIONED if error > accuracy else status
