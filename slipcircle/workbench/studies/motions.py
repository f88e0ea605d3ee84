"""Many motions at once: a scene with arrays of other values, and derivatives as their differences."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.core import Motion, Scene, solve, with_parameter_arrays
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import lengths

Floats = NDArray[np.float64]
_STEPS, _FINE = (1e-5, 1e-7), 1e-14  # of derivatives, relative, until one is small enough; their motions


def motions(scene: Scene, values: Mapping[str, Any], accuracy: float | None = None) -> Motion:
    """The motions of a scene with arrays of values, SI, by name; what is no scene is `Status.INVALID`."""
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        many, invalid = with_parameter_arrays(scene, {n: np.asarray(v, dtype=np.float64) for n, v in values.items()})
        return solve(many, accuracy, invalid=invalid)


def derivatives(
    scene: Scene, at: Mapping[str, float], accuracy: float | None = None
) -> tuple[dict[str, float], dict[str, dict[str, float]]]:
    """Outcomes of a scene, and their derivatives by its numbers, SI: by outcome, by number.

    Differences of four values beside each, or of two to one side where the motion is of another kind on the other, as
    at the end of what a value may be; NaN where it is on both, as next to where it begins to move.
    """
    own = dict.fromkeys(lengths(scene.arc), float(scene.arc.depth))
    own |= dict.fromkeys(("theta_1", "theta_2", "dip"), float(scene.arc.half_angle))
    sizes = np.array([own.get(n, abs(v)) or 1.0 for n, v in at.items()])
    slopes = np.full((len(OUTCOMES), len(at)), np.nan)
    for share in _STEPS:
        values = np.tile(np.array([*at.values()])[:, None], (1, 1 + 4 * len(at)))
        for k, step in enumerate(share * sizes):
            values[k, 1 + 4 * k : 5 + 4 * k] += step * np.array([1.0, 2.0, -1.0, -2.0])
        motion = motions(scene, dict(zip(at, values, strict=True)), min(accuracy or _FINE, _FINE))
        same = (motion.status == motion.status[0]) & (motion.turnings == motion.turnings[0])
        y = np.stack([motion.outcomes[n] for n in OUTCOMES])
        off = np.where(same, y - y[:, :1], np.nan)[:, 1:].reshape(len(OUTCOMES), len(at), 4)
        right, right_2, left, left_2 = np.moveaxis(off, 2, 0)
        both = (8 * (right - left) - (right_2 - left_2)) / 12
        for change in (both, (4 * right - right_2) / 2, (left_2 - 4 * left) / 2):
            slopes = np.where(np.isfinite(slopes), slopes, change / (share * sizes))
        if np.all(np.isfinite(slopes)):
            break
    told = {n: dict(zip(at, row, strict=True)) for n, row in zip(OUTCOMES, slopes.tolist(), strict=True)}
    return {n: float(motion.outcomes[n][0]) for n in OUTCOMES}, told
