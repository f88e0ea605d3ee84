"""Cost of accuracy for a scene: its error and time, alone and in an ensemble, at each requested accuracy."""

import time
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from slipcircle.base.kinds import Pair
from slipcircle.base.progress import tracked
from slipcircle.core import Motion, Scene, solve
from slipcircle.derivatives import parameter_value, parameters, with_parameter_arrays
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.cost.rows import CostRow, medians, recommended, with_verdicts
from slipcircle.workbench.files.numbers import number_in, uncertain_numbers

Ranges = tuple[dict[str, tuple[float, ...]], bool]
_PRIMES = (2, 3, 5, 7, 11, 13)  # their square roots spread several numbers independently
ACCURACIES = ("1e-3", "1e-6", "1e-9", "1e-12", "1e-15")
DEFAULT = 1e-9  # default accuracy of `solve`
REFERENCE = 1e-16  # accuracy of the reference, one order better than the most accurate way
ALONE = "alone"
ENSEMBLE = "ensemble"
ANY = "any"  # accuracy: a single scene is solved to rounding
SPREAD = 0.2  # range of the strength to both sides, relative, in a scene without distributions
QUANTILES = (0.01, 0.99)  # ends of the covered range of a distribution
_STRENGTH = ("friction", "cohesion", "soils.")  # prefixes of the names of strength parameters
_UNITS = ("", "Pa")  # units of strength parameters
MOST = 10_000  # greatest number of cases of an ensemble
PASS = 0.15  # s, greatest time of an ensemble


def of_scene(scene: Scene, vary: Mapping[str, Pair] | None = None) -> list[CostRow]:
    """Return rows with error and time of a scene, alone and in an ensemble; arrays are an ensemble themselves.

    Errors are the largest relative errors of run-out, peak velocity and duration over the ensemble, compared with a
    solution with more terms. The ensemble covers the ranges ``vary`` by key, in the unit of the key, or else the
    distributions of the scene, or else its strength within `SPREAD`.
    """
    if scene.shape:
        return _of_ensemble(scene, False, int(np.prod(scene.shape)))
    ranges = _ranges(scene, vary or {})
    reference = solve(scene, REFERENCE)
    motion = solve(scene)
    (seconds,) = medians([partial(solve, scene)])
    alone = CostRow(ALONE, ANY, 1, _error(motion, reference), motion.error_estimate, seconds)
    cases = 10
    while cases < MOST and 10 * _pass(scene, ranges, cases) < PASS:
        cases *= 10
    return with_verdicts([alone]) + _of_ensemble(*_varied(scene, ranges, cases), cases)


def _pass(scene: Scene, ranges: Ranges, cases: int) -> float:
    """Return the processor time in s of the most accurate solution of an ensemble with this number of cases."""
    ensemble, invalid = _varied(scene, ranges, cases)
    start = time.process_time()
    solve(ensemble, REFERENCE, invalid=invalid)
    return time.process_time() - start


def _ranges(scene: Scene, vary: Mapping[str, Pair]) -> Ranges:
    """Return the ends of the range of each number in SI units by name, and whether all numbers rise together.

    ``vary`` are given ranges by key, in the unit of the key.
    """
    ranges: dict[str, tuple[float, ...]] = {}
    if vary:
        for key, ends in vary.items():
            number = number_in(scene, key)
            ranges[number.name] = tuple(map(number.to_si, ends))
        return ranges, False
    if scene.uncertain:
        for name, uncertain in uncertain_numbers(scene).items():
            ranges[name] = tuple(map(uncertain.number.to_si, map(uncertain.drawn, QUANTILES)))
        return ranges, False
    strengths = {}
    for name, parameter in parameters(scene).items():
        value = parameter_value(scene, name)
        if value and name.startswith(_STRENGTH) and parameter.unit in _UNITS:
            strengths[name] = value
    for name, value in (strengths or {"gravity": float(np.asarray(scene.arc.gravity))}).items():
        ranges[name] = ((1.0 - SPREAD) * value, (1.0 + SPREAD) * value)
    return ranges, True


def _varied(scene: Scene, ranges: Ranges, cases: int) -> tuple[Scene, Any]:
    """Return an ensemble of ``cases`` scenes that covers ranges from `_ranges`, and a mask of its invalid cases."""
    by_name, together = ranges
    shares = np.linspace(0.0, 1.0, cases)
    values = {}
    for place, (name, (low, high)) in enumerate(by_name.items()):
        if place and not together:
            shares, _ = np.modf(np.sqrt(_PRIMES[place % len(_PRIMES)]) * np.arange(cases))
        values[name] = low + shares * (high - low)
    return with_parameter_arrays(scene, values)


def _of_ensemble(ensemble: Scene, invalid: Any, cases: int) -> list[CostRow]:
    """Return a row for each requested accuracy, with one recommended.

    ``invalid`` is the mask of invalid cases or False, and ``cases`` the number of scenes.
    """
    reference = solve(ensemble, REFERENCE, invalid=invalid)
    motions = [solve(ensemble, float(way), invalid=invalid) for way in tracked(ACCURACIES, "accuracies solved")]
    seconds = medians([partial(solve, ensemble, float(way), invalid=invalid) for way in ACCURACIES])
    rows = []
    for way, motion, taken in zip(ACCURACIES, motions, seconds, strict=True):
        bound = float(np.nanmax(motion.error_estimate, initial=0.0))
        error = _error(motion, reference)
        rows.append(CostRow(ENSEMBLE, way, cases, error, bound, taken / cases, accuracy=float(way)))
    return recommended(with_verdicts(rows), ensemble.accuracy or DEFAULT)


def _error(motion: Motion, reference: Motion) -> float:
    """Return the largest relative error of the outcomes; 1 where a result is missing on one side only."""
    largest = 0.0
    for name in OUTCOMES:
        value, exact = (np.asarray(each.outcomes[name], dtype=float) for each in (motion, reference))
        if np.any(np.isnan(value) != np.isnan(exact)):
            return 1.0
        differs = value != exact
        relative = np.abs(value - exact)[differs] / np.maximum(np.abs(value), np.abs(exact))[differs]
        largest = max(largest, float(np.nanmax(relative, initial=0.0)))
    return largest
