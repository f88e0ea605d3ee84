"""Summary of a motion, or of an ensemble, in one line."""

from typing import Any

import numpy as np

from slipcircle.base.text import amount_text, digits_left, number_text, output_unit
from slipcircle.core.motion.states import Status

OUTSIDE = "outside the range of the method"
SWING = 1e-6  # relative distance of the end from the run-out above which the mass has swung back


def standing(motion: Any) -> str:
    """Return the one-line summary of a single mass that does not move, with its factor of safety at the start."""
    factor = number_text(float(motion.factor_of_safety))
    by_closure = ""
    if motion.plan.scene.strength_factor == 1.0:
        by_closure = " by the paper's method"
    return f"does not move, factor of safety {factor}{by_closure}"


def summary(motion: Any) -> str:
    """Return the summary of a single motion: peak velocity, run-out and end."""
    if not motion.moves:
        return standing(motion)
    digits = digits_left(motion.error_estimate)
    velocity = amount_text(motion.outcomes["peak_velocity"], "m/s", digits)
    run_out = amount_text(motion.run_out, "m", digits)
    if motion.status is Status.CREEPS:
        arrival = number_text(motion.settling_time, digits)
        return f"{velocity} at most; creeps to a run-out of {run_out}, 99 % of it in {arrival} s"
    duration = number_text(motion.duration, digits)
    end = "comes to rest after" if motion.arrested else "still moving at"
    if swings_back(motion):
        end = f"swings back to {amount_text(motion.end.displacement, 'm', digits)}; {end}"
    if not motion.arrested and motion.plan.scene.end_time is None:
        end = "followed to its first standstill at"
    return f"{velocity} at most; run-out {run_out}; {end} {duration} s"


def ensemble_summary(motion: Any) -> str:
    """Return the number of cases of an ensemble by status and the range of their run-outs, as one line of text."""
    counts = [f"{Status[name].words}: {count}" for name, count in motion.count().items()]
    finite = motion.run_out[~np.isnan(motion.run_out)]
    span = "not known"
    if finite.size:
        factor, unit = output_unit("m")
        span = f"{number_text(factor * finite.min())} to {number_text(factor * finite.max())} {unit}"
    return f"{', '.join(counts)}; run-out {span}"


def swings_back(motion: Any) -> Any:
    """Return whether a mass ends elsewhere than at its greatest displacement, a bool or an array."""
    return np.abs(motion.run_out - motion.end.displacement) > SWING * np.abs(motion.run_out)


def range_words(motion: Any) -> str:
    """Return when and where a single motion leaves the range of validity, "after 3 s, 12 m"; empty if it does not."""
    state = motion.range_end
    if state:
        return f"after {number_text(state.time, 3)} s, {amount_text(state.displacement, 'm', 3)}"
    return ""
