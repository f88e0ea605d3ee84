"""A motion as a table over time, for plots and CSV files."""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.text import measured
from slipcircle.core import Motion
from slipcircle.ground import Section
from slipcircle.tables import in_time
from slipcircle.workbench.common import files
from slipcircle.workbench.common.quantities import HISTORY

SAMPLES = 400
_JUMP = 1e-3  # of the greatest value: a larger change at a breakpoint is a jump


def trace(motion: Motion, times: Floats) -> dict[str, Floats]:
    """The motion at times in s: each quantity of `HISTORY` as an array in SI units."""
    columns = {}
    for name, quantity in HISTORY.items():
        columns[name] = quantity.at(motion, times) + 0.0  # without negative zeros
    return columns


@lru_cache(maxsize=8)
def drawn(motion: Motion) -> dict[str, Floats]:
    """The motion at the times that a picture needs, computed once."""
    return trace(motion, telling_times(motion))


def even_times(motion: Motion) -> Floats:
    """Equidistant times from the start to the end."""
    if not motion.moves:
        return np.zeros(1)
    return np.linspace(0.0, motion.settling_time, SAMPLES + 1)


def telling_times(motion: Motion) -> Floats:
    """Equidistant times, the peak, times that cluster at both ends of each phase, and breakpoints and crests of input.

    At a jump of the input, the time just before it as well.
    """
    if not motion.moves:
        return np.zeros(1)
    scene = motion.plan.scene
    extremes = [float(state.time) for state in (motion.peak, motion.farthest, motion.range_end) if state]
    times: list[Any] = [even_times(motion), extremes]
    each = max(4, SAMPLES // len(motion.phases))
    angle = np.linspace(0.0, np.pi, each + 1)
    share = (1.0 - np.cos(angle)) / 2
    for phase in motion.phases:
        length = phase.end - phase.start
        times.append(phase.start + length * share)
    for function in in_time(scene.called).values():
        times += _kinks_and_crests(function)
    law = scene.friction
    if isinstance(law, Mapping) and "time" in law:
        times.append(law["time"])
    every = np.concatenate(times)
    return np.unique(np.clip(every, 0.0, motion.settling_time))


def _kinks_and_crests(function: Any) -> list[Any]:
    """Breakpoints and crests of a function of time, and the time just before each jump."""
    kinks = np.asarray(function.kinks)
    before = np.nextafter(kinks, -np.inf)
    values = function(kinks)
    greatest = np.max(np.abs(values), initial=0.0)
    change = np.abs(function(before) - values)
    is_jump = change > _JUMP * greatest
    return [kinks, before[is_jump], function.crests]


def toe_height(motion: Motion) -> float:
    """Height of the toe of a section above the ground at the run-out, m; NaN beyond the ends of the ground.

    Beyond the toe the mass is assumed to follow its circle, which rises above the ground or cuts into it.
    """
    section = motion.plan.scene.arc
    if not isinstance(section, Section):
        return np.nan
    toe = motion.journey
    ground_x, ground_y = np.asarray(section.ground, dtype=np.float64).T
    below = np.interp(float(toe.toe_x), ground_x, ground_y, left=np.nan, right=np.nan)
    return float(toe.toe_y - below)


def toe_words(motion: Motion) -> str:
    """Return the height of the toe above the ground at the run-out, in words; empty below a thousandth of it."""
    height = toe_height(motion)
    distance = abs(height)
    if not motion.moves or not distance > 1e-3 * abs(motion.run_out):
        return ""
    side = "above" if height > 0.0 else "below"
    return f"{measured(distance, 'm')} {side} the ground"


def csv(motions: Sequence[Motion], times: Floats | None = None) -> bytes:
    """Motions over time as CSV, in full precision; with several, the first column is the name.

    By default at equidistant times, otherwise at the given times, s.
    """
    several = len(motions) > 1
    heads = [quantity.head for quantity in HISTORY.values()]

    def rows() -> Iterator[list[Any]]:
        for motion in motions:
            columns = trace(motion, even_times(motion) if times is None else times)
            for row in np.transpose([*columns.values()]).tolist():
                yield [motion.plan.scene.name, *row] if several else row

    return files.table(["scene", *heads] if several else heads, rows())
