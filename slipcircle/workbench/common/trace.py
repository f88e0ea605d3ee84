"""Motion as a table over time, for plots and CSV files."""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from slipcircle.base.kinds import ArrayDict, Floats
from slipcircle.base.text import amount_text
from slipcircle.core import Motion
from slipcircle.ground import Section
from slipcircle.tables import in_time
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import HISTORY

SAMPLES = 400
_JUMP = 1e-3  # least jump at a breakpoint, relative to the greatest value


def trace(motion: Motion, times: Floats) -> ArrayDict:
    """Return the motion at times in s: each quantity of `HISTORY` as an array in SI units."""
    columns = {}
    for name, quantity in HISTORY.items():
        columns[name] = quantity.at(motion, times) + 0.0  # without negative zeros
    return columns


@lru_cache(maxsize=8)
def columns_of_picture(motion: Motion) -> ArrayDict:
    """Return the motion at the times of `telling_times`, by quantity in SI units; the result is cached."""
    return trace(motion, telling_times(motion))


def even_times(motion: Motion) -> Floats:
    """Return equidistant times in s from the start to the end of a motion."""
    if not motion.moves:
        return np.zeros(1)
    return np.linspace(0.0, motion.settling_time, SAMPLES + 1)


def telling_times(motion: Motion) -> Floats:
    """Return the times in s for a picture of a motion.

    These are equidistant times, the peak, times that cluster at both ends of each phase, breakpoints and crests of the
    input, and the time just before each jump of the input.
    """
    if not motion.moves:
        return np.zeros(1)
    scene = motion.plan.scene
    extremes = [float(state.time) for state in (motion.peak, motion.farthest, motion.range_end) if state]
    times: list[Any] = [even_times(motion), extremes]
    angle = np.linspace(0.0, np.pi, max(4, SAMPLES // len(motion.phases)) + 1)
    share = (1.0 - np.cos(angle)) / 2
    for phase in motion.phases:
        times.append(phase.start + (phase.end - phase.start) * share)
    for function in in_time(scene.called).values():
        # Breakpoints and crests of a function of time, and the time just before each jump, in s.
        kinks = np.asarray(function.kinks)
        before = np.nextafter(kinks, -np.inf)
        values = function(kinks)
        is_jump = np.abs(function(before) - values) > _JUMP * np.max(np.abs(values), initial=0.0)
        times += [kinks, before[is_jump], function.crests]
    law = scene.friction
    if isinstance(law, Mapping) and "time" in law:
        times.append(law["time"])
    return np.unique(np.clip(np.concatenate(times), 0.0, motion.settling_time))


def toe_height(motion: Motion) -> float:
    """Return the height of the toe of a section above the ground at the run-out in m.

    Beyond the toe the mass is assumed to follow its circle, which rises above the ground or cuts into it. The height is
    NaN beyond the ends of the ground, and for an arc.
    """
    section = motion.plan.scene.arc
    if not isinstance(section, Section):
        return np.nan
    toe = motion.journey
    ground_x, ground_y = np.asarray(section.ground, float).T
    return float(toe.toe_y - np.interp(float(toe.toe_x), ground_x, ground_y, left=np.nan, right=np.nan))


def toe_words(motion: Motion) -> str:
    """Return the height of the toe above or below the ground in words; empty below 0.1 % of the run-out."""
    height = toe_height(motion)
    distance = abs(height)
    if not motion.moves or not distance > 1e-3 * abs(motion.run_out):
        return ""
    side = "above" if height > 0.0 else "below"
    return f"{amount_text(distance, 'm')} {side} the ground"


def csv(motions: Sequence[Motion], times: Floats | None = None) -> bytes:
    """Return motions over time as CSV in full precision and SI units; with several, the first column is the name.

    Times are in s, by default equidistant.
    """
    several = len(motions) > 1
    heads = [quantity.head for quantity in HISTORY.values()]

    def rows() -> Iterator[list[Any]]:
        for motion in motions:
            columns = trace(motion, even_times(motion) if times is None else times)
            for row in np.transpose([*columns.values()]).tolist():
                yield [motion.plan.scene.name, *row] if several else row

    return files.csv_table(["scene", *heads] if several else heads, rows())
