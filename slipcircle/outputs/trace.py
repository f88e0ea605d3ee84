"""A motion as a table over time: what the plots draw and what a CSV file holds."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.friction import friction
from slipcircle.motion import Motion

Floats = NDArray[np.float64]

# Columns, in their order, and their SI units.
UNITS: Mapping[str, str] = {
    "time": "s", "rotation": "rad", "angular_velocity": "rad/s", "velocity": "m/s", "displacement": "m",
    "acceleration": "m/s^2", "path": "m", "normal_stress": "Pa", "effective_stress": "Pa", "friction": "",
    "holding_friction": "", "kinetic_energy": "J", "work": "J", "dissipation": "J",
}  # fmt: skip
_SAMPLES = 400


def times(motion: Motion, samples: int = _SAMPLES) -> Floats:
    """Times that show a motion: even ones, its peak, and in each phase some that crowd towards both its ends."""
    scale, end = float(motion.plan.scene.arc.time_scale), motion.duration
    if not motion.moves:
        return np.zeros(1)
    each = max(4, samples // len(motion.phases))
    share = (1.0 - np.cos(np.linspace(0.0, np.pi, each + 1))) / 2
    phases = [scale * (p.start + (p.end - p.start) * share) for p in motion.phases]
    found = np.concatenate([np.linspace(0.0, end, samples + 1), [float(motion.peak.time)], *phases])
    return np.unique(np.clip(found, 0.0, end))


@lru_cache(maxsize=8)
def trace(motion: Motion) -> dict[str, Floats]:
    """The motion over time, each of the columns of `UNITS` as an array in SI units.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    dict of str to ndarray
        `path` is the accumulated slip; `friction` the coefficient that the law gives for it, 0 where nothing presses
        on the slip surface; `holding_friction` the one at which the mass would just stand still where it is, NaN where
        nothing presses; `effective_stress` the normal stress without the water's share. `work` and `dissipation`
        count from the start.
    """
    at = motion.at(time := times(motion))
    energy = motion.energy_at(time)
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(at.displacement)))])
    scale = float(motion.plan.scene.arc.time_scale)
    press, omega = motion.balance.press_at(at.rotation), at.angular_velocity * scale
    effective = motion.balance.get("effective_stress", press=press, omega_2=omega**2)
    columns: dict[str, Any] = asdict(at) | {
        "path": path,
        "effective_stress": np.maximum(effective, 0.0) * float(motion.plan.scene.arc.reference_stress),
        "friction": np.where(effective > 0.0, friction(motion.plan.scene.friction).coefficient(path), 0.0),
        "holding_friction": np.array([_holding(motion, float(r)) for r in at.rotation]),
        "kinetic_energy": energy.kinetic_end,
        "work": energy.work,
        "dissipation": energy.dissipation,
    }
    return {name: np.asarray(columns[name], dtype=np.float64) + np.zeros_like(time) for name in UNITS}


def _holding(motion: Motion, rotation: float) -> float:
    """The friction coefficient at which a mass at rest just stays at this rotation."""
    balance = motion.balance
    at = balance.position(rotation, 1)
    if at["fall"] < 0.0:
        at = balance.position(rotation, -1)
    if float(balance.get("normal", **at)) <= 0.0:
        return math.nan
    return max(float(balance.get("limit_friction", **at)), 0.0)


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
