"""Derivatives of motions by the numbers of their scenes, against differences of single motions beside."""

from collections import Counter
from collections.abc import Iterable

import numpy as np

from slipcircle import Scene, parameters, solve
from slipcircle.derivatives import with_parameters

MOST_SKIPPED = 0.25  # share of the numbers within whose steps the motion's course changes


def check_derivatives(scene: Scene, tolerance: float, names: Iterable[str] = (), step: float = 1e-5) -> Counter[str]:
    """Smooth derivatives of every output by all numbers, or by some, and how many there were of each kind.

    Differences of fourth order of motions solved one by one, of steps relative to the scale of each number. They are
    within the stated error and what is known of them: `tolerance` of the largest change by any number. Where the
    motion's course changes within the steps they say nothing; at most a quarter of the numbers may be skipped so.
    """
    motion = solve(scene)
    found = motion.sensitivity()
    free = parameters(scene)
    scales = np.array([free[name].scale for name in found.parameters])
    counts: Counter[str] = Counter()
    for k, number in enumerate(found.parameters):
        if names and number not in names:
            continue
        change = step * scales[k]
        scenes = [with_parameters(scene, {number: found.at[number] + by * change}) for by in (1, -1, 2, -2)]
        beside = [solve(other, 1e-15) for other in scenes]
        if any(one.status != motion.status or one.turnings != motion.turnings for one in beside):
            counts["skipped"] += 1
            continue
        for row, output in enumerate(found.outputs):
            counts[found.kinds[row, k]] += 1
            if found.kinds[row, k] != "smooth":
                continue
            above, below, far_above, far_below = (one.outcomes[output] for one in beside)
            slope = (8 * (above - below) - (far_above - far_below)) / (12 * change)
            largest = np.nanmax(np.abs(found.values[row] * scales)) + 1e-3 * abs(found.at[output])
            off, error = abs(found.values[row, k] - slope) * scales[k], found.errors[row, k] * scales[k]
            assert off <= error + tolerance * largest, (output, number, found.values[row, k], slope, error)
            assert error <= tolerance * largest, (output, number, error, largest)
    assert counts["smooth"], counts
    assert counts["skipped"] <= MOST_SKIPPED * len(found.parameters), counts
    return counts
