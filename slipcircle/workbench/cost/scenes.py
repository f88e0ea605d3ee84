"""What accuracy costs for a scene: its error and its time, alone and in an ensemble, at each requested accuracy."""

import time
from functools import partial
from typing import Any

import numpy as np

from slipcircle.base.progress import track
from slipcircle.core import Motion, Scene, solve
from slipcircle.derivatives import parameter_value, parameters, with_parameter_arrays
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.cost.rows import Row, judged, medians, recommended

ACCURACIES = ("1e-3", "1e-6", "1e-9", "1e-12", "1e-15")
DEFAULT = 1e-9  # of `solve`
REFERENCE = 1e-16  # accuracy to which the reference is solved: one order more than the most accurate way
ALONE = "alone"
ENSEMBLE = "ensemble"
ANY = "any"  # accuracy: a single scene is solved to rounding
SPREAD = 0.02  # of the strength, by which the cases of an ensemble differ from the scene
_STRENGTH = ("friction", "cohesion", "soils.")  # beginnings of the names of its numbers
_UNITS = ("", "Pa")  # of which, of these
MOST = 10_000  # cases
PASS = 0.15  # s that an ensemble may take


def of_scene(scene: Scene) -> list[Row]:
    """Errors and times of a scene, alone and in an ensemble; a scene of arrays is the ensemble itself.

    Errors are the largest relative ones of run-out, peak velocity and duration, against a
    solution with more terms. The strength of the cases of an ensemble differs by up to `SPREAD` from the scene's.
    """
    if scene.shape:
        return _of_ensemble(scene, False, int(np.prod(scene.shape)))
    reference = solve(scene, REFERENCE)
    motion = solve(scene)
    (seconds,) = medians([partial(solve, scene)])
    alone = Row(ALONE, ANY, 1, _error(motion, reference), motion.error_estimate, seconds)
    cases = 10
    while cases < MOST and 10 * _pass(scene, cases) < PASS:
        cases *= 10
    return judged([alone]) + _of_ensemble(*_varied(scene, cases), cases)


def _pass(scene: Scene, cases: int) -> float:
    """Seconds that the most accurate solution of an ensemble takes."""
    ensemble, invalid = _varied(scene, cases)
    start = time.process_time()
    solve(ensemble, REFERENCE, invalid=invalid)
    return time.process_time() - start


def _varied(scene: Scene, cases: int) -> tuple[Scene, Any]:
    """An ensemble of a scene, and which of its cases are invalid: with other strengths, or without any, gravity."""
    strengths = {}
    for name, parameter in parameters(scene).items():
        value = parameter_value(scene, name)
        if value and name.startswith(_STRENGTH) and parameter.unit in _UNITS:
            strengths[name] = value
    factors = np.linspace(1.0 - SPREAD, 1.0 + SPREAD, cases)
    varied = strengths or {"gravity": float(np.asarray(scene.arc.gravity))}
    return with_parameter_arrays(scene, {name: factors * value for name, value in varied.items()})


def _of_ensemble(ensemble: Scene, invalid: Any, cases: int) -> list[Row]:
    """A row for each requested accuracy, of which one is recommended."""
    reference = solve(ensemble, REFERENCE, invalid=invalid)
    motions = [solve(ensemble, float(way), invalid=invalid) for way in track(ACCURACIES, "accuracies solved")]
    seconds = medians([partial(solve, ensemble, float(way), invalid=invalid) for way in ACCURACIES])
    rows = []
    for way, motion, taken in zip(ACCURACIES, motions, seconds, strict=True):
        bound = float(np.nanmax(motion.error_estimate, initial=0.0))
        rows.append(Row(ENSEMBLE, way, cases, _error(motion, reference), bound, taken / cases))
    return recommended(judged(rows), ensemble.accuracy or DEFAULT)


def _error(motion: Motion, reference: Motion) -> float:
    """Largest relative error of the outcomes; 1 where one has a result and the other has none."""
    largest = 0.0
    for name in OUTCOMES:
        value, exact = (np.asarray(each.outcomes[name], dtype=float) for each in (motion, reference))
        if np.any(np.isnan(value) != np.isnan(exact)):
            return 1.0
        differs = value != exact
        relative = np.abs(value - exact)[differs] / np.maximum(np.abs(value), np.abs(exact))[differs]
        largest = max(largest, float(np.nanmax(relative, initial=0.0)))
    return largest
