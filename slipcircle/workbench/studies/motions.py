"""Many motions at once: a scene with arrays of other values."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from slipcircle.core import Motion, Scene, solve
from slipcircle.derivatives import with_parameter_arrays


def motions(scene: Scene, values: Mapping[str, Any], accuracy: float | None = None) -> Motion:
    """The motions of a scene with arrays of values, SI, by name; what is no scene is `Status.INVALID`."""
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in values.items()}
    with np.errstate(all="ignore"):  # what is no scene has a status, and nothing to complain about
        lanes, invalid = with_parameter_arrays(scene, arrays)
        return solve(lanes, accuracy, invalid=invalid)
