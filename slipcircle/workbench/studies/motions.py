"""Solutions of many motions in one vectorised call: a scene with arrays of values."""

from typing import Any

import numpy as np

from slipcircle.base.arrays import quiet
from slipcircle.base.kinds import ValueDict, Values
from slipcircle.core import Motion, Scene, plan, problem_of, solve
from slipcircle.derivatives import with_parameter_arrays
from slipcircle.history import Forces
from slipcircle.workbench.common.quantities import factors_by_method


def motions(scene: Scene, values: Values, accuracy: float | None = None) -> Motion:
    """Solve a scene with arrays of values by name, in SI units; invalid scenes have the status `Status.INVALID`."""
    with quiet():  # invalid scenes are reported by their status
        lanes, invalid = _lanes(scene, values)
        return solve(lanes, accuracy, invalid=invalid)


def factors_at_start(scene: Scene, values: Values, accuracy: float) -> ValueDict:
    """Return factors of safety by method, at the start, without integration.

    ``values`` are arrays by name in SI units, one element for each lane; ``accuracy`` is the relative error of the
    scene's plan.
    """
    with quiet():
        lanes, invalid = _lanes(scene, values)
        statics = Forces(problem_of(plan(lanes, accuracy), invalid)).statics
        return factors_by_method(lanes, statics["factor_of_safety"])


def _lanes(scene: Scene, values: Values) -> tuple[Scene, Any]:
    """Return the scene with arrays of values by name in SI units, and a mask of its invalid lanes (members)."""
    return with_parameter_arrays(scene, {name: np.asarray(value, float) for name, value in values.items()})
