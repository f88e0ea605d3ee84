"""Times at which curves of a motion bend or jump, and why, in a few words for a picture."""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Motion, law_parts
from slipcircle.tables import in_time
from slipcircle.workbench.outputs.trace import drawn

Kinks = list[tuple[float, str]]


def motion_kinks(motion: Motion) -> Kinks:
    """Standstills, and the end of the shaking."""
    kinks = []
    for before, phase in pairwise(motion.phases):
        words = "turns back" if phase.start == before.end else "starts again"
        kinks.append((phase.start, words))
    shaking_ends = max(_breakpoints(motion, "shaking."), default=math.inf)
    if shaking_ends < motion.settling_time:
        kinks.append((shaking_ends, "shaking ends"))
    return kinks


def friction_kinks(motion: Motion) -> Kinks:
    """Where a law of friction bends: at the end of its softening, at ends of its table, and at breakpoints in time."""
    columns = drawn(motion)
    times = columns["time"]
    path = columns["path"]
    speed = np.abs(columns["velocity"])
    kinks: Kinks = []
    for name, given in law_parts(motion.plan.scene.friction):
        if name == "linear":
            kinks += _crossings(times, path, float(given["length"]), "residual friction")
        elif name == "tabulated":
            kinks += _crossings(times, path, float(given["slip"][-1]), "end of the table")
        elif name == "rate_tabulated":
            for end in (given["speed"][0], given["speed"][-1]):
                kinks += _crossings(times, speed, float(end), f"{end:g} m/s")
        elif name == "prescribed":
            kinks += [(float(time), "breakpoint") for time in given["time"]]
    return [kink for kink in kinks if 0.0 < kink[0] < motion.settling_time]


def water_kinks(motion: Motion) -> Kinks:
    """Breakpoints of a pore pressure that varies in time."""
    times = _breakpoints(motion, "pore_pressure.")
    return [(time, "breakpoint") for time in times if 0.0 < time < motion.settling_time]


def _breakpoints(motion: Motion, effect: str) -> list[float]:
    """Times at which what an effect is given in time bends."""
    functions = in_time(motion.plan.scene.called).items()
    kinks = [np.asarray(function.kinks) for name, function in functions if name.startswith(effect)]
    return sorted({time for times in kinks for time in times.tolist()})


def _crossings(times: Floats, values: Floats, level: float, words: str) -> Iterator[tuple[float, str]]:
    """Times at which values reach or leave a level."""
    above = values >= level
    changes = above[1:] != above[:-1]
    for k in np.flatnonzero(changes):
        before, after = values[k : k + 2]
        start, end = times[k : k + 2]
        share = (level - before) / (after - before)
        crossing = start + share * (end - start)
        yield float(crossing), words
