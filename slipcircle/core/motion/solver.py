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

from generated.layout import MOST_TURNS
from slipcircle.base.checks import InputError
from slipcircle.base.kinds import Numbers
from slipcircle.core.doors import room
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.states import Status
from slipcircle.core.problem.plan import Plan, plan
from slipcircle.core.problem.problem import problem_of
from slipcircle.core.scene.scene import Scene
from slipcircle.core.walk.lanes import BLOCK, ENTRIES, integrate

STRONGEST = 1e7  # q = 2 (lambda A mu + d)/Theta* of a brake that is followed


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
    if not scene.shape:
        _refuse(motion)
    return motion


def motion_of(chosen: Plan, invalid: Any = False) -> Motion:
    """The motion that a plan leads to, or its status where there is none; some lanes may be no scenes."""
    scene = chosen.scene
    log: list[Any] = []
    lanes = math.prod(scene.shape)
    if lanes <= BLOCK:
        problem = problem_of(chosen, invalid)
        final = integrate(problem, log=None if scene.shape else log)[:ENTRIES]
        if not scene.shape:  # plain numbers are ten times cheaper than arrays of one
            return Motion(chosen, final[:, 0].tolist(), log, invalid, problem)
        return Motion(chosen, final.reshape(ENTRIES, *scene.shape), log, invalid, problem)
    final = np.empty((ENTRIES, lanes))
    every_invalid = np.broadcast_to(invalid, scene.shape).reshape(-1)
    for first in range(0, lanes, BLOCK):
        which = slice(first, first + BLOCK)
        part = room("parameters").taken(scene, lambda values, which=which: values.reshape(-1)[which])
        final[:, which] = integrate(problem_of(replace(chosen, scene=part), every_invalid[which]))[:ENTRIES]
    return Motion(chosen, final.reshape(ENTRIES, *scene.shape), log, invalid)


def _refuse(motion: Motion) -> None:
    """Raise an error for a single scene without a result."""
    scene = motion.plan.scene
    speed = float(np.asarray(scene.initial_velocity))
    if motion.is_finite and math.isfinite(speed * speed):
        return
    status = motion.status
    turns = motion.plan.turns
    stands = "shaking" in motion.plan.effects and not motion.factor_of_safety < 1.0  # but for what shakes it
    overflows = status == Status.FAILED and not stands and scene.end_time is None and speed * speed < math.inf
    velocity, end_time = (f"{{{n}}} = {getattr(scene, n)!r}" for n in ("initial_velocity", "end_time"))
    few_turnings = status == Status.ENDLESS and motion.turnings < 20
    if status == Status.UPRIGHT:
        why = (
            f"{velocity}, friction: the chord is vertical after {motion.stopped_at:.6g} s and the mass would hang "
            "over, which this method cannot follow; give an earlier {end_time} or a lower velocity"
        )
    elif not turns and (status == Status.ENDLESS or overflows):
        why = "{end_time}: this slide never rests, as its geometry is frozen; add rotation, or give {end_time} in s"
    elif few_turnings and motion.brake > STRONGEST:
        why = (
            f"friction, drag: they brake too strongly to be followed: the speed falls by e in 1/q of a radian, q = "
            f"{motion.brake:.2g}, at most {STRONGEST:.0e} can be; give a greater xi or less friction"
        )
    elif few_turnings:
        why = (
            "{end_time}: this mass creeps to its rest, ever more slowly as what resists falls with the speed, or "
            f"trembles on: it has not rested after {motion.stopped_at:.3g} s; give {{end_time}} in s"
        )
    elif status == Status.ENDLESS:
        times = min(motion.turnings, MOST_TURNS)
        why = f"{end_time}: this mass turns back {times} times or more without coming to rest; give an earlier end in s"
    else:
        why = f"{velocity}, {end_time}: the motion overflows; give a lower velocity or an earlier end"
    raise InputError("", [why])
