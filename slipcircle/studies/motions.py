"""Many motions at once: a scene with arrays of other values, and derivatives as their differences."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import motion_of
from slipcircle.scene.numbers import lengths
from slipcircle.scene.scene import Scene
from slipcircle.scene.varied import scenes_with

Floats = NDArray[np.float64]
_STEPS, _FINE = (1e-3, 1e-5, 1e-7), 1e-14  # of derivatives, relative, until one is small enough; their motions


def motions(scene: Scene, values: Mapping[str, Any], accuracy: float | None = None) -> Motion:
    """The motions of a scene with arrays of values, SI, by name; what is no scene is `Status.INVALID`."""
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        many, invalid = scenes_with(scene, {n: np.asarray(v, dtype=np.float64) for n, v in values.items()})
        return motion_of(plan(many, accuracy), invalid)


def derivatives(
    scene: Scene, at: Mapping[str, float], accuracy: float | None = None
) -> tuple[dict[str, float], dict[str, dict[str, float]]]:  # fmt: skip
    """Outcomes of a scene, and their derivatives by its numbers, SI: by outcome, by number.

    Differences of four values beside each, or of two to one side where the motion is of another kind on the other, as
    at the end of what a value may be; NaN where it is on both, as next to where it begins to move.
    """
    found: dict[str, dict[str, float]] = {}
    geometry = lengths(scene.arc)
    sizes = {n: float(scene.arc.depth) if n in geometry else abs(v) or 1.0 for n, v in at.items()}
    for share in _STEPS:
        steps = {n: share * size for n, size in sizes.items()}
        values = {n: np.full(1 + 4 * len(at), float(v)) for n, v in at.items()}
        for k, n in enumerate(at):
            values[n][1 + 4 * k : 5 + 4 * k] += steps[n] * np.array([1.0, 2.0, -1.0, -2.0])
        motion = motions(scene, values, min(accuracy or _FINE, _FINE))
        same = (motion.status == motion.status[0]) & (motion.turnings == motion.turnings[0])
        for outcome, y in motion.outcomes.items():
            near = np.where(same, y - y[0], np.nan)[1:].reshape(len(at), 4)
            for n, off in zip(at, near, strict=True):
                both = (8 * (off[0] - off[2]) - (off[1] - off[3])) / 12
                sides = [s for s in (both, (4 * off[0] - off[1]) / 2, (off[3] - 4 * off[2]) / 2) if np.isfinite(s)]
                slope = float(sides[0]) / steps[n] if sides else math.nan
                by = found.setdefault(outcome, {})
                by[n] = slope if math.isnan(by.get(n, math.nan)) else by[n]
        if all(math.isfinite(v) for by in found.values() for v in by.values()):
            break
    return {n: float(y[0]) for n, y in motion.outcomes.items()}, found
