"""A motion as a table over time: what the plots draw and what a CSV file holds."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.methods.rest import down_slope
from slipcircle.motion.motion import Motion
from slipcircle.scene.friction import friction

Floats = NDArray[np.float64]

# Columns, in their order, and their SI units.
UNITS: Mapping[str, str] = {
    "time": "s", "rotation": "rad", "angular_velocity": "rad/s", "velocity": "m/s", "displacement": "m",
    "acceleration": "m/s^2", "path": "m", "normal_stress": "Pa", "effective_stress": "Pa", "friction": "",
    "holding_friction": "", "kinetic_energy": "J", "work_of_gravity_and_shaking": "J", "dissipation": "J",
}  # fmt: skip
_SAMPLES = 400
_JUMP = 1e-3  # of the greatest value, by which what is given jumps


def times(motion: Motion, samples: int = _SAMPLES) -> Floats:
    """Times that show a motion: even ones, its peak, and in each phase some that crowd towards both its ends.

    And those between which what changes with time is smooth; where it jumps, the time just before as well.
    """
    scale, end = float(motion.plan.scene.arc.time_scale), motion.duration
    if not motion.moves:
        return np.zeros(1)
    each = max(4, samples // len(motion.phases))
    share = (1.0 - np.cos(np.linspace(0.0, np.pi, each + 1))) / 2
    found: list[Any] = [
        np.linspace(0.0, end, samples + 1),
        [float(motion.peak.time)],
        friction(motion.plan.scene.friction).times,
    ]
    found += [scale * (p.start + (p.end - p.start) * share) for p in motion.phases]
    found += [scale * p.solved.episodes[:, :2].ravel() for p in motion.phases if hasattr(p.solved, "episodes")]
    for function, _ in motion.balance.forcing.values():
        knots = function.pieces.knots if hasattr(function, "pieces") else np.asarray(function.kinks)
        before = np.nextafter(knots, -np.inf)
        values = np.abs(function(knots))
        jumps = np.abs(function(before) - function(knots)) > _JUMP * np.max(values, initial=0.0)
        found += [knots, before[jumps]]
    return np.unique(np.clip(np.concatenate(found), 0.0, end))


@lru_cache(maxsize=8)
def trace(motion: Motion) -> dict[str, Floats]:
    """The motion over time, each of the columns of `UNITS` as an array in SI units.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    dict of str to ndarray
        `path` is the accumulated slip; `friction` the coefficient that the law gives for it and for speed and time, 0
        where nothing presses on the slip surface; `holding_friction` the one at which the mass would just stand still
        where it is, under what shakes it then, NaN where nothing presses; `effective_stress` the normal stress without
        the water's share. `work_of_gravity_and_shaking` and `dissipation` count from the start.
    """
    at = motion.at(time := times(motion))
    energy = motion.energy_at(time)
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(at.displacement)))])
    effective = np.asarray(at.normal_stress - motion.pore_pressure_at(time))
    law = friction(motion.plan.scene.friction)
    columns: dict[str, Any] = asdict(at) | {
        "path": path,
        "effective_stress": np.maximum(effective, 0.0),
        "friction": np.where(effective > 0.0, law.coefficient(path, np.abs(at.velocity), time), 0.0),
        "holding_friction": _holding(motion, time, at.rotation),
        "kinetic_energy": energy.kinetic_end,
        "work_of_gravity_and_shaking": energy.work,
        "dissipation": energy.dissipation,
    }
    return {name: np.asarray(columns[name], dtype=np.float64) + np.zeros_like(time) for name in UNITS}


def _holding(motion: Motion, time: Floats, rotation: Floats) -> Floats:
    """The friction coefficient at which a mass at rest just stays, at these times and rotations."""
    balance, t = motion.balance, time / float(motion.plan.scene.arc.time_scale)
    excess, found = np.zeros_like(t), np.full_like(t, np.nan)
    for phase, mask, local in motion._lanes(t):
        excess[mask] = phase.solved.excess_when(local)
    two_way = "k_h" not in balance.forcing or motion.plan.scene.called["shaking"].get("two_way", False)
    given = {side: balance.given(t, side) for side in (1, -1)}
    for k, (turn, added) in enumerate(zip(rotation.tolist(), excess.tolist(), strict=True)):
        for side in (1, -1) if two_way else (down_slope(balance, turn),):
            at = balance.position(turn, side) | {n: v[k] for n, v in given[side].items()} | {"excess": added}
            if float(balance.get("normal", **at)) > 0.0:
                found[k] = np.fmax(found[k], max(float(balance.get("limit_friction", **at)), 0.0))
    return found


def csv(motions: Sequence[Motion]) -> str:
    """Motions over time as CSV, in full precision; of several, the first column is the scene's name."""
    named = len(motions) > 1
    rows = [",".join([*(["scene"] if named else []), *(_head(name, unit) for name, unit in UNITS.items())])]
    for motion in motions:
        first = [_quoted(motion.plan.scene.name)] if named else []
        columns = (column.tolist() for column in trace(motion).values())
        rows += [",".join([*first, *map(repr, row)]) for row in zip(*columns, strict=True)]
    return "\n".join(rows) + "\n"


def _head(name: str, unit: str) -> str:
    return "_".join(filter(None, [name, unit.replace("/", "_").replace("^", "")]))


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\r\n') else text
