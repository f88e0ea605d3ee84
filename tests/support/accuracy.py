"""The 400 reference scenes as the package takes them, and the true errors of its motions."""

import json
import math
from functools import cache
from typing import Any, NamedTuple

import mpmath
import numpy as np
from mpmath import mpf

import slipcircle
from slipcircle import Motion, Scene
from tests.support import golden, references, taylor
from tests.support.lanes import BINARY

DATA = references.FILE.read_bytes()
ROWS: list[dict[str, Any]] = json.loads(DATA)
# In NumPy a scene takes a third of a second by itself: there every eighth.
EVERY = 1 if BINARY else 8
NUMBERS = range(0, 300, EVERY)
TIMED = range(300, 400, EVERY)
MANY = 100  # phases: each adds its error to the next


class Error(NamedTuple):
    """True relative errors; absolute where the reference is 0."""

    peak: float
    run_out: float
    duration: float
    displacement: float
    velocity: float


def scene(row: dict[str, Any]) -> Scene:
    """Return a row's scene."""
    return golden.built("", row["scene"])


@cache
def solved(number: int) -> Motion:
    """Return the motion of a reference scene with default accuracy."""
    return slipcircle.solve(scene(ROWS[number]))


def off(value: float, reference: str, scale: str) -> float:
    """Error of a value, relative to a scale where that is not 0."""
    with mpmath.workdps(50):
        error = abs(mpf(float(value)) - mpf(reference))
        return float(error / abs(mpf(scale)) if mpf(scale) else error)


def true_error(motion: Motion, reference: dict[str, Any]) -> Error:
    """Errors of a motion; those at given times are relative to the run-out and to the peak."""
    peak, run_out, duration = reference["peak_velocity"], reference["run_out"], reference["duration"]
    places = speeds = [0.0]
    if reference["times"]:
        times = np.minimum(reference["times"], np.inf if motion.arrested else motion.duration)
        state = motion.at(times)
        places = [off(v, r, run_out) for v, r in zip(state.displacement, reference["displacement"], strict=True)]
        speeds = [off(v, r, peak) for v, r in zip(state.velocity, reference["velocity"], strict=True)]
    return Error(
        off(float(motion.peak.velocity), peak, peak),
        max(
            off(motion.run_out, run_out, run_out), off(motion.end.displacement, reference["end_displacement"], run_out)
        ),
        off(motion.duration, duration, duration),
        max(places),
        max(speeds),
    )


@cache
def error(number: int) -> Error:
    """Errors of a scene's motion."""
    return true_error(solved(number), ROWS[number]["reference"])


def near_limit(number: int) -> bool:
    """Whether its friction is meant to be next to its limit: the first scenes of a group."""
    group = ROWS[number]["group"]
    return number - next(k for k in range(300) if ROWS[k]["group"] == group) < references.NEAR.get(group, 0)


def misses(motion: Motion, given: golden.Data) -> dict[str, float]:
    """Return the errors of a motion compared with its Taylor series, over the estimated error; 1 at most is correct."""
    if given["friction"] == 0.0 and "cohesion" not in given["effects"]:  # `solve` gives the first standstill
        given = given | {"end_time": motion.duration}
    reference = taylor.solve(golden.to_the_right(given), golden.SHARES, digits=18)
    lifts = reference["lift_off"]  # those at rest are not among them
    estimate, near = motion.error_estimate, 30 * math.sqrt(motion.error_estimate) * motion.duration
    others = [t for t in motion.lift_off if all(abs(t - x) > near for x in lifts)]
    alike = (
        (motion.moves, motion.arrested) == (reference["moves"], reference["arrested"])
        and all(any(abs(t - x) <= near for x in motion.lift_off) for t in lifts)
        and not any(motion.at(t).velocity for t in others)
    )
    off = true_error(motion, reference)._asdict() | {"decisions": 0.0 if alike else math.inf}
    return {k: v / (estimate or 1e-16) for k, v in off.items()}
