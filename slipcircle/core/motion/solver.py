"""Solution of a scene, single or with lanes.

The equation of motion is the dimensionless balance of angular momentum about the centre of the arc:

    Theta domega/dt = M - s (T + lambda mu max(0, sigma - u)),  s = sgn(omega)

M is the driving moment, T the resistance other than friction, sigma the normal stress, and u the pore pressure.
`generated.flow` lists the terms of each effect, and `plan(scene).equation` is the equation of one scene.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from generated.layout import RESULTS
from slipcircle.base.arrays import float_or_array
from slipcircle.base.kinds import Numbers
from slipcircle.core.integrator.lanes import BLOCK, integrate_problem
from slipcircle.core.lazy import lazy_import
from slipcircle.core.motion.motion import Motion
from slipcircle.core.problem.plan import Plan, plan
from slipcircle.core.problem.problem import problem_of
from slipcircle.core.scene.scene import Scene


def solve(scene: Scene[Numbers], accuracy: float | None = None, *, invalid: Any = False) -> Motion[Numbers]:
    """Solve a scene until the mass rests, or until its end time. A scene with arrays is solved as an ensemble.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Requested relative error, by default the scene's or 1e-9. It sets the order of the series of ensembles. A
        single scene is solved to rounding, with a warning if its estimated error is larger than requested.
    invalid : array_like of bool, optional
        Invalid cases, as returned by `with_parameter_arrays`. Their status is `Status.INVALID`.

    Returns
    -------
    Motion
        Motion whose attributes are arrays of the broadcast shape if the scene has arrays. For type checkers it is
        ``Motion[float]`` or ``Motion[Array]``, like the scene.

    Raises
    ------
    ValueError
        If a single scene never rests and has no end time, turns over, or overflows. In an ensemble such cases have a
        status instead.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if the drive does not exceed the
    resistance, and otherwise turns back. It starts again once shaking, water or friction has changed enough. A mass
    without cohesion, and without friction or normal load, is integrated to its first standstill, since nothing brings
    it to rest. ``notebooks/0_the_method.ipynb`` derives these rules.
    """
    chosen = plan(scene, accuracy)
    motion: Motion[Numbers] = motion_of(chosen, invalid)
    if not scene.shape:
        outcomes: Any = motion.outcomes
        speed = float_or_array(scene.initial_velocity)
        if not math.isfinite(outcomes["run_out"] + outcomes["peak_velocity"] + speed * speed):  # initial energy
            raise lazy_import("refusal").refusal(motion)
    return motion


def motion_of(chosen: Plan, invalid: Any = False) -> Motion:
    """Return the motion of a plan.

    Lanes (scenes of an ensemble) marked in the mask ``invalid`` are not solved. A scene without a result raises no
    error; the motion's status states the reason.
    """
    scene = chosen.scene
    if not scene.shape:
        return Motion.of_single(chosen, invalid)
    lanes = math.prod(scene.shape)
    if lanes <= BLOCK:
        problem = problem_of(chosen, invalid)
        final = integrate_problem(problem)[:RESULTS]
        return Motion(chosen, final.reshape(RESULTS, *scene.shape), invalid, problem)
    final = np.empty((RESULTS, lanes))
    every_invalid = np.broadcast_to(invalid, scene.shape).ravel()
    block = BLOCK - (lanes % BLOCK == 1)  # one lane alone would be solved as a single scene
    for first in range(0, lanes, block):
        which = slice(first, first + block)
        part = lazy_import("parameters").lanes_of(scene, which, flat=True)
        cells = integrate_problem(problem_of(replace(chosen, scene=part), every_invalid[which]))
        final[:, which] = cells[:RESULTS]
    return Motion(chosen, final.reshape(RESULTS, *scene.shape), invalid)
