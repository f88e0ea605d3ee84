"""Derivatives of motions by the numbers of their scenes, against differences of lanes beside."""

from collections.abc import Iterable

import numpy as np

from slipcircle import Scene, Section, solve
from slipcircle.workbench.studies.motions import motions


def check_derivatives(scene: Scene, tolerance: float, names: Iterable[str] = (), step: float = 1e-5) -> None:
    """Derivatives of every output by all numbers, or by some, relative to the largest change by any of them.

    Differences of fourth order, for a relative step of each number, or one relative to the depth of a section.
    A number at which the course of the motion changes is left out.
    """
    motion = solve(scene)
    slopes = motion.sensitivity()
    depth = float(scene.arc.depth) if isinstance(scene.arc, Section) else 0.0
    scales = {n: depth if depth and unit == "m" else abs(slopes.at[n]) for n, unit in slopes.parameters.items()}
    for k, number in enumerate(slopes.parameters):
        change = step * scales[number]
        if change == 0.0 or (names and number not in names):
            continue
        beside = motions(scene, {number: slopes.at[number] + change * np.array([1.0, -1.0, 2.0, -2.0])}, 1e-15)
        if np.any(beside.status != motion.status) or np.any(beside.turnings != motion.turnings):
            continue
        for output, row in zip(slopes.outputs, slopes.values, strict=True):
            above, below, far_above, far_below = beside.outcomes[output]
            slope = (8 * (above - below) - (far_above - far_below)) / (12 * change)
            largest = np.abs(row * [*scales.values()]).max() + 1e-3 * abs(slopes.at[output])
            assert abs(row[k] - slope) * scales[number] <= tolerance * largest, (output, number, row[k], slope)
