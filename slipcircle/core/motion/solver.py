"""From a scene to its motion, or to the motions of its lanes.

The equation of motion is the balance of momentum of a mass that turns about the centre of its arc, dimensionless:

    Theta domega/dt = M - s (T + lambda mu max(0, sigma - u)),  s = sgn(omega)

M drives, T resists, sigma presses, u lifts; `generated.flow` lists what each effect adds, and `plan(scene).equation` is
that of one scene.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from slipcircle.base.checks import plain
from slipcircle.base.kinds import Numbers
from slipcircle.core.doors import room
from slipcircle.core.motion.motion import Motion
from slipcircle.core.problem.plan import Plan, plan
from slipcircle.core.problem.problem import problem_of
from slipcircle.core.scene.scene import Scene
from slipcircle.core.walk.lanes import BLOCK, ENTRIES, integrate


def solve(scene: Scene[Numbers], accuracy: float | None = None, *, invalid: Any = False) -> Motion[Numbers]:
    """Solve a scene until it rests, or until its end time; a scene of arrays is solved as an ensemble.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Requested relative error; by default that of the scene, or 1e-9. It sets the order of the series of ensembles.
        A single scene is solved to rounding; if its estimated error is larger than requested, it has a warning.
    invalid : array_like of bool, optional
        Invalid cases, as returned by `with_parameter_arrays`; their status is `Status.INVALID`.

    Returns
    -------
    Motion
        If the scene has arrays, its attributes are arrays of their broadcast shape; to a type checker it is
        ``Motion[float]`` or ``Motion[Array]``, like the scene.

    Raises
    ------
    ValueError
        If a single scene never rests and has no end time, turns over, or overflows; in an ensemble the status of such
        cases says so.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if the drive does not exceed the
    resistance; otherwise it turns back. It starts again once shaking, water or friction has changed enough. A mass that
    nothing brings to rest (without cohesion, and without friction or normal load) is integrated to its first
    standstill. ``notebooks/0_the_method.ipynb`` derives all of this.
    """
    chosen = plan(scene, accuracy)
    motion: Motion[Numbers] = motion_of(chosen, invalid)
    if not (scene.shape or _is_finite(motion)):
        raise room("refusal").refusal(motion)
    return motion


def _is_finite(motion: Motion) -> bool:
    """Whether a single motion has a result, and neither that nor its energy at the start overflows."""
    outcomes = motion.outcomes
    speed = plain(motion.plan.scene.initial_velocity)
    return math.isfinite(outcomes["run_out"] + outcomes["peak_velocity"] + speed * speed)


def motion_of(chosen: Plan, invalid: Any = False) -> Motion:
    """The motion that a plan leads to, or its status where there is none; some lanes may be no scenes."""
    scene = chosen.scene
    lanes = math.prod(scene.shape)
    if lanes <= BLOCK:
        problem = problem_of(chosen, invalid)
        final = integrate(problem)[:ENTRIES]
        if not scene.shape:  # plain numbers are ten times cheaper than arrays of one
            return Motion(chosen, final[:, 0].tolist(), invalid, problem)
        return Motion(chosen, final.reshape(ENTRIES, *scene.shape), invalid, problem)
    final = np.empty((ENTRIES, lanes))
    every_invalid = np.broadcast_to(invalid, scene.shape).reshape(-1)
    for first in range(0, lanes, BLOCK):
        which = slice(first, first + BLOCK)
        part = room("parameters").taken(scene, lambda values, which=which: values.reshape(-1)[which])
        final[:, which] = integrate(problem_of(replace(chosen, scene=part), every_invalid[which]))[:ENTRIES]
    return Motion(chosen, final.reshape(ENTRIES, *scene.shape), invalid)
