"""States of a motion at its end, its farthest position and its greatest speed, from its final cells."""

from collections.abc import Callable
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.arrays import choose, float_or_array, may_overflow
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.states import State
from slipcircle.core.scene.scene import Scene


def end(motion: Motion) -> State:
    """Return the state at the end of a motion. See `Motion.end`."""
    return _final_state(motion, motion.duration, ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE)


def farthest(motion: Motion) -> State:
    """Return the state at the greatest displacement. See `Motion.farthest`."""
    final = motion._final
    at_end = final[ix.REACH_ROTATION] == final[ix.END_ROTATION]
    time = choose(at_end, motion.duration, final[ix.REACH_TIME] * motion._time_scale)
    return _final_state(motion, time, ix.REACH_ROTATION, ix.END_OMEGA, ix.END_RATE, moving=at_end)


def peak(motion: Motion) -> State:
    """Return the state at the greatest speed. See `Motion.peak`."""
    final = motion._final
    peak_time = final[ix.PEAK_TIME]
    ended = final[ix.STATUS] == ix.ENDED
    last = peak_time == final[ix.END_TIME]
    at_end = last & ended | (final[ix.PHASES] == 0.0)
    time = choose(at_end, motion.duration, peak_time * motion._time_scale)
    varies = not motion.shape and any(table.kind == "time" for table in motion.problem.program.tables)
    if varies and 0.0 < time < motion.duration:
        return motion.at(time)  # at the rounded time; where a force jumps, its value after the jump
    return _final_state(motion, time, ix.PEAK_ROTATION, ix.PEAK_OMEGA, ix.PEAK_RATE)


def _final_state(motion: Motion, time: Any, rotation: int, omega: int, rate: int, moving: Any = True) -> State:
    """Return the state at ``time`` in s from cells with these indices. Speed and rate are 0 unless ``moving``."""
    final = motion._final
    speed = choose(moving, final[omega], 0.0)
    gain = choose(moving, final[rate], 0.0)
    angle, speed, gain = map(motion._known, (final[rotation], speed, gain))
    rows = angle, speed, gain
    return state_of(motion.plan.scene, time + 0.0, *rows, lambda: motion._history.final_stress(time, angle, speed))


def state_of(scene: Scene, time: Any, rotation: Any, omega: Any, rate: Any, stress: Callable[[], Any]) -> State:
    """Return a state in SI units.

    ``time`` is in s and ``rotation`` in rad. ``omega`` and ``rate`` are the angular velocity times sqrt(R/g) and its
    derivative times R/g. Their arrays have the shape of the scene followed by the shape of the times. ``stress`` is a
    function without arguments that returns the normal stress in Pa.
    """
    axes = getattr(time, "ndim", 0) - len(scene.shape)
    scale = before(scene.arc.time_scale, axes)
    radius = before(float_or_array(scene.arc.radius), axes)
    with may_overflow(scene.shape):
        angular_velocity = omega / scale
        velocity = radius * angular_velocity
        acceleration = radius * rate / scale**2
        displacement = radius * rotation
    columns = (rotation, angular_velocity, velocity, displacement, acceleration)
    return State(time, *(column + 0.0 for column in columns), stress=stress)


def before(values: Any, axes: int) -> Any:
    """Return an array over lanes, followed by as many axes of length 1 as the times have ``axes``.

    A single number is returned unchanged.
    """
    return values if type(values) is float else np.reshape(values, (*np.shape(values), *[1] * axes))
