"""Many motions at once: a scene with arrays of other values, and derivatives as their differences."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Motion, Scene, solve
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.numbers import lengths

_STEPS = 1e-5, 1e-7  # of derivatives, relative, until one is small enough
_FINE = 1e-14  # accuracy of their motions


def motions(scene: Scene, values: Mapping[str, Any], accuracy: float | None = None) -> Motion:
    """The motions of a scene with arrays of values, SI, by name; what is no scene is `Status.INVALID`."""
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in values.items()}
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        lanes, invalid = with_parameter_arrays(scene, arrays)
        return solve(lanes, accuracy, invalid=invalid)


def derivatives(scene: Scene, at: Mapping[str, float], accuracy: float | None = None) -> tuple[Floats, Floats]:
    """Outcomes of a scene, and their derivatives by its numbers, SI: (outcomes,) and (outcomes, numbers).

    Differences of four values beside each, or of two to one side where the motion is of another kind on the other, as
    at the end of what a value may be; NaN where it is on both, as next to where it begins to move.
    """
    sizes = scales(scene, at)
    shape = len(OUTCOMES), len(at)
    slopes = np.full(shape, np.nan)
    finest = min(accuracy or _FINE, _FINE)
    for share in _STEPS:
        outcomes, changes = _changes(scene, at, share * sizes, finest)
        ahead, ahead_2, behind, behind_2 = np.moveaxis(changes, 2, 0)
        one_step = ahead - behind
        two_steps = ahead_2 - behind_2
        central = (8 * one_step - two_steps) / 12
        forward = (4 * ahead - ahead_2) / 2
        backward = (behind_2 - 4 * behind) / 2
        for change in (central, forward, backward):
            slope = change / (share * sizes)
            slopes = np.where(np.isfinite(slopes), slopes, slope)
        if np.all(np.isfinite(slopes)):
            break
    return outcomes, slopes


def scales(scene: Scene, at: Mapping[str, float]) -> Floats:
    """What small changes are relative to, SI: of places on a section its depth, of angles of an arc half of it.

    Of all others their values.
    """
    arc = scene.arc
    of_arc = dict.fromkeys(lengths(arc), float(arc.depth))
    for angle in ("theta_1", "theta_2", "dip"):
        of_arc[angle] = float(arc.half_angle)
    scales = []
    for name, value in at.items():
        scale = of_arc.get(name, abs(value))
        scales.append(scale or 1.0)
    return np.array(scales)


def _changes(scene: Scene, at: Mapping[str, float], steps: Floats, accuracy: float) -> tuple[Floats, Floats]:
    """Outcomes, and their changes with each number one and two steps ahead and behind, (outcomes, numbers, 4).

    NaN where the motion is of another kind.
    """
    offsets = np.array([1.0, 2.0, -1.0, -2.0])
    centre = np.array([*at.values()])
    count = 1 + centre.size * offsets.size
    values = np.tile(centre[:, None], (1, count))
    for k, step in enumerate(steps):
        first = 1 + k * offsets.size
        last = first + offsets.size
        values[k, first:last] += step * offsets
    by_name = dict(zip(at, values, strict=True))
    motion = motions(scene, by_name, accuracy)
    same_status = motion.status == motion.status[0]
    same_kind = same_status & (motion.turnings == motion.turnings[0])
    outcomes = np.stack([motion.outcomes[n] for n in OUTCOMES])
    at_centre = outcomes[:, 0]
    changes = np.where(same_kind, outcomes - at_centre[:, None], np.nan)
    shape = len(OUTCOMES), centre.size, offsets.size
    return at_centre, changes[:, 1:].reshape(shape)
