"""Warnings about a single motion."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from slipcircle.base.kinds import Names
from slipcircle.base.text import amount_text
from slipcircle.messages.plausible import questions
from slipcircle.messages.summary import OUTSIDE, range_words

FORMAT_LIMIT = 1e-11  # estimated error below which only float64 limits the accuracy
ENERGY_TOLERANCE = 1e-12  # imbalance relative to the exchanged energy above which it is reported
NEAR_LIMIT = 1e-3  # relative distance of friction from its limit that makes a motion ill-conditioned
SUBMERGED = 1e-6  # depth below the water level, relative to the radius, above which it is reported
LISTED = 3  # greatest number of lift-offs listed individually; number of phases that counts as many
MANY_PHASES = 100


def collect_warnings(motion: Any, written: Callable[[str, float], str] | None = None) -> Names:
    """Return warnings about odd input, lift-off, conditioning, water and range of validity, one text each.

    ``written`` converts a name and a value in SI units to the number as the user wrote it.
    """
    odd_input = questions(motion.plan.scene, written)
    outside = [f"{OUTSIDE} {range_words(motion)}"] * motion.outside_range
    return (*odd_input, *_lift_offs(motion), *_conditioning(motion), *_submergence(motion), *outside)


def _lift_offs(motion: Any) -> Iterator[str]:
    """Yield a warning for each time at which contact is lost, or one warning if there are many."""
    times = motion.lift_off
    if len(times) > LISTED:
        more = f"{len(times) - 1} times more until {times[-1]:.6g} s"
        yield f"contact lost from {times[0]:.6g} s, and {more} (lift-off)"
        return
    for time in times:
        yield f"contact lost from {time:.6g} s (lift-off)"


def _conditioning(motion: Any) -> Iterator[str]:
    """Yield a warning if the requested accuracy is missed, with the likely cause, or if energy is not balanced."""
    error = motion.error_estimate
    accuracy = motion.plan.accuracy
    if error > accuracy:
        limit = motion.limit_friction
        cause = "its numbers differ by many orders of magnitude"
        if error < FORMAT_LIMIT:
            cause = "float64 does not allow a smaller error"
        elif len(motion.phases) > MANY_PHASES:
            cause = "the mass turns back many times"
        elif abs(motion.friction - limit) < NEAR_LIMIT * abs(limit):
            cause = "the friction is next to its limit"
        missed = f"the estimated error {error:.1e} exceeds the requested accuracy, {accuracy:.1e}"
        yield f"ill-conditioned: {missed}; {cause}"
    elif motion.moves and motion.energy_error_estimate > ENERGY_TOLERANCE:
        yield (
            f"ill-conditioned: the energy is balanced to {motion.energy_error_estimate:.1e} only, as drive and "
            "resistance are all but equal"
        )


def _submergence(motion: Any) -> Iterator[str]:
    """Yield warnings about standing water and about ground that sinks below a water level."""
    section = motion.plan.scene.arc
    if section.in_standing_water:
        yield "the mass moves through standing water, whose drag and added mass are not included"
    depth = section.drowned(motion.farthest.rotation, motion.end.rotation)
    if depth > SUBMERGED * np.asarray(section.radius):
        yield (
            f"turning brings ground down to {amount_text(depth, 'm', 3)} below the water level; the weight of the "
            "water above it is not included"
        )
