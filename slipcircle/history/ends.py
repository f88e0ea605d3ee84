"""States of a motion at its end, its farthest position and its greatest speed, from its final cells."""

from collections.abc import Callable
from typing import Any

import numpy as np

from generated import layout as ix
from slipcircle.base.arrays import choose, float_or_array
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.state import State
from slipcircle.core.scene.scene import Scene


def final_state(motion: Motion) -> State:
    """Return the state at the end of a motion. See `Motion.end`."""
    final = motion._final
    rotation = final[ix.END_ROTATION]
    omega = final[ix.END_OMEGA]
    rate = final[ix.END_RATE]
    return _state_of_cells(motion, motion.duration, rotation, omega, rate)


def farthest_state(motion: Motion) -> State:
    """Return the state at the greatest displacement. See `Motion.farthest`."""
    final = motion._final
    rotation = final[ix.REACH_ROTATION]
    at_end = rotation == final[ix.END_ROTATION]
    time_reached = final[ix.REACH_TIME] * motion._time_scale
    time = choose(at_end, motion.duration, time_reached)
    omega = choose(at_end, final[ix.END_OMEGA], 0.0)
    rate = choose(at_end, final[ix.END_RATE], 0.0)
    return _state_of_cells(motion, time, rotation, omega, rate)


def peak_state(motion: Motion) -> State:
    """Return the state at the greatest speed. See `Motion.peak`."""
    final = motion._final
    peak_time = final[ix.PEAK_TIME]
    ended = final[ix.STATUS] == ix.ENDED
    last = peak_time == final[ix.END_TIME]
    never_moved = final[ix.PHASES] == 0.0
    at_end = last & ended | never_moved
    time = choose(at_end, motion.duration, peak_time * motion._time_scale)
    varies = not motion.shape and any(table.kind == "time" for table in motion.problem.program.tables)
    if varies and 0.0 < time < motion.duration:
        return motion.at(time)  # at the rounded time; where a force jumps, its value after the jump
    rotation = final[ix.PEAK_ROTATION]
    omega = final[ix.PEAK_OMEGA]
    rate = final[ix.PEAK_RATE]
    return _state_of_cells(motion, time, rotation, omega, rate)


def _state_of_cells(motion: Motion, time: Any, *cells: Any) -> State:
    """Return the state at ``time`` in s from rotation, omega and its rate in the final cells."""
    unsolved = motion._unsolved
    rotation, omega, rate = (cell + unsolved for cell in cells)

    def stress() -> Any:
        return motion._history.final_stress(time, rotation, omega)

    return state_of(motion.plan.scene, time + 0.0, rotation, omega, rate, stress)


def state_of(scene: Scene, time: Any, rotation: Any, omega: Any, rate: Any, stress: Callable[[], Any]) -> State:
    """Return a state in SI units.

    ``time`` is in s and ``rotation`` in rad. ``omega`` and ``rate`` are the angular velocity times sqrt(R/g) and its
    derivative times R/g. Their arrays have the shape of the scene followed by the shape of the times. ``stress`` is a
    function without arguments that returns the normal stress in Pa.
    """
    axes = getattr(time, "ndim", 0) - len(scene.shape)
    scale = before(scene.arc.time_scale, axes)
    radius = before(float_or_array(scene.arc.radius), axes)
    with np.errstate(over="ignore"):
        angular_velocity = omega / scale
        velocity = radius * angular_velocity
        acceleration = radius * rate / scale**2
        displacement = radius * rotation
    columns = (rotation, angular_velocity, velocity, displacement, acceleration)
    without_negative_zeros = (column + 0.0 for column in columns)
    return State(time, *without_negative_zeros, stress=stress)


def before(values: Any, axes: int) -> Any:
    """Return an array over lanes, followed by as many axes of length 1 as the times have ``axes``.

    A single number is returned unchanged.
    """
    if type(values) is float:
        return values
    shape = *np.shape(values), *[1] * axes
    return np.reshape(values, shape)
