"""Many motions at once: a scene with arrays of other values, and derivatives as their differences."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import motion_of
from slipcircle.scene.scene import Scene
from slipcircle.scene.varied import scenes_with

Floats = NDArray[np.float64]
_STEP, _FINE = 1e-3, 1e-14  # of derivatives, relative; and of their motions


def motions(scene: Scene, values: Mapping[str, Any], accuracy: float | None = None) -> Motion:
    """The motions of a scene with arrays of values, SI, by name; what is no scene is `Status.INVALID`."""
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        many, invalid = scenes_with(scene, {n: np.asarray(v, dtype=np.float64) for n, v in values.items()})
        return motion_of(plan(many, accuracy), invalid)


def derivatives(
    scene: Scene, at: Mapping[str, float], accuracy: float | None = None
) -> tuple[dict[str, float], dict[str, dict[str, float]]]:  # fmt: skip
    """Outcomes of a scene, and their derivatives by its numbers, SI: by outcome, by number.

    Four values beside each, (8 (y(+h) - y(-h)) - (y(+2h) - y(-2h)))/(12 h), so that what is left is of order h^4; NaN
    where the motion is of another kind there, as next to where it begins to move.
    """
    steps = {n: _STEP * (abs(v) or 1.0) for n, v in at.items()}
    values = {n: np.full(1 + 4 * len(at), v) for n, v in at.items()}
    for k, n in enumerate(at):
        values[n][1 + 4 * k : 5 + 4 * k] += steps[n] * np.array([1.0, -1.0, 2.0, -2.0])
    motion = motions(scene, values, min(accuracy or _FINE, _FINE))
    same = motion.status == motion.status[0]
    found: dict[str, dict[str, float]] = {}
    for outcome, y in motion.outcomes.items():
        near = np.where(same, y, np.nan)[1:].reshape(len(at), 4) @ np.array([8.0, -8.0, -1.0, 1.0])
        found[outcome] = {n: float(d) / (12 * steps[n]) for n, d in zip(at, near, strict=True)}
    return {n: float(y[0]) for n, y in motion.outcomes.items()}, found
