"""A motion as a table over time: what the plots draw and what a CSV file holds."""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.text import shown
from slipcircle.core import Motion, Section, in_time
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import HISTORY

Floats = NDArray[np.float64]

SAMPLES = 400
_JUMP = 1e-3  # of the greatest value, by which what is given jumps


def trace(motion: Motion, times: Floats) -> dict[str, Floats]:
    """The motion at times in s: each quantity of `HISTORY` as an array in SI units."""
    return {name: q.at(motion, times) + 0.0 for name, q in HISTORY.items()}


@lru_cache(maxsize=8)
def drawn(motion: Motion) -> dict[str, Floats]:
    """The motion at the times that a picture of it needs, computed once."""
    return trace(motion, telling_times(motion))


def even_times(motion: Motion) -> Floats:
    """Times at even distances from the start to the end."""
    return np.linspace(0.0, motion.duration, SAMPLES + 1) if motion.moves else np.zeros(1)


def telling_times(motion: Motion) -> Floats:
    """Even times, the peak, in each phase some that crowd towards both its ends, and where what is given has a kink or
    a crest.

    Where that jumps, the time just before as well.
    """
    if not motion.moves:
        return np.zeros(1)
    times: list[Any] = [even_times(motion), [float(motion.peak.time), float(motion.reach.time)]]
    each = max(4, SAMPLES // len(motion.phases))
    share = (1.0 - np.cos(np.linspace(0.0, np.pi, each + 1))) / 2
    for phase in motion.phases:
        times.append(phase.start + (phase.end - phase.start) * share)
    for function in in_time(motion.plan.scene.called).values():
        times += _kinks_and_crests(function)
    law = motion.plan.scene.friction
    if isinstance(law, Mapping) and "time" in law:
        times.append(law["time"])
    return np.unique(np.clip(np.concatenate(times), 0.0, motion.duration))


def _kinks_and_crests(function: Any) -> list[Any]:
    """Where a function of time bends or is greatest, and the time just before each jump."""
    kinks = np.asarray(function.kinks)
    before = np.nextafter(kinks, -np.inf)
    values = function(kinks)
    is_jump = np.abs(function(before) - values) > _JUMP * np.max(np.abs(values), initial=0.0)
    return [kinks, before[is_jump], function.crests]


def toe_height(motion: Motion) -> float:
    """How high the toe of a section's mass lies above the ground in the end, m; NaN beyond the ends of the ground.

    Beyond the toe the mass is assumed to go on along its circle, which leaves the ground upwards or cuts into it.
    """
    section = motion.plan.scene.arc
    if not isinstance(section, Section):
        return np.nan
    toe, ground = motion.journey, np.asarray(section.ground, dtype=np.float64)
    below = np.interp(float(toe.toe_x), ground[:, 0], ground[:, 1], left=np.nan, right=np.nan)
    return float(toe.toe_y - below)


def toe_words(motion: Motion) -> str:
    """Where the toe ends above or below the ground, in words; empty where that is less than a thousandth of its way."""
    height = toe_height(motion)
    if not motion.moves or not abs(height) > 1e-3 * abs(motion.run_out):
        return ""
    return f"{shown(abs(height))} m {'above' if height > 0.0 else 'below'} the ground"


def csv(motions: Sequence[Motion], times: Floats | None = None) -> bytes:
    """Motions over time as CSV, in full precision; of several the first column is the name.

    By default at even times; else at those, in s.
    """
    several = len(motions) > 1
    heads = [quantity.head for quantity in HISTORY.values()]

    def rows() -> Iterator[list[Any]]:
        for motion in motions:
            columns = trace(motion, even_times(motion) if times is None else times)
            for row in np.transpose([*columns.values()]).tolist():
                yield [motion.plan.scene.name, *row] if several else row

    return files.table(["scene", *heads] if several else heads, rows())
