"""From a plan to a motion: phase after phase, each in one direction, until the mass rests or its time is over."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.balance import Balance, bind
from slipcircle.checks import EPS, number
from slipcircle.friction import Friction, friction
from slipcircle.inputs.series import Pulse
from slipcircle.methods.rest import Rest, never_rests, next_start, swings_left
from slipcircle.motion import Motion, Phase, Start
from slipcircle.plan import CLOSED_IN_TIME, INTEGRATION, LINEAR_SYSTEM, STEPPING, Plan, plan
from slipcircle.scene import Scene

if TYPE_CHECKING:
    from slipcircle.methods.stepping import Stepped
    from slipcircle.motion import Followed, Solved

_MOST_PHASES = 2000
_MOST_STEPS = 100_000  # of SciPy, for one phase between two kinks


def solve(scene: Scene, accuracy: float | None = None) -> Any:
    """Solve a scene until it rests, or until its end time; a scene of arrays as an ensemble.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9.

    Returns
    -------
    slipcircle.motion.Motion or slipcircle.arrays.motions.Motions
        Motions, of the scene's broadcast shape, where its fields are arrays.

    Raises
    ------
    ValueError
        If the scene never rests and has no end time, turns over, or overflows; of an ensemble, such lanes have the
        status FAILED.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if the drive is at most the
    resistance, and turns back if not, or starts again when shaking, water or friction has changed enough. A mass that
    nothing brings to rest (no friction, or none that presses on the slip surface, and no cohesion) is followed to its
    first standstill.
    """
    if scene.shape:
        from slipcircle.arrays.motions import solve_ensemble

        return solve_ensemble(plan(scene, accuracy))
    return solve_one(plan(scene, accuracy))


def solve_one(
    chosen: Plan, tolerance: float | None = None, nudge: float = 0.0, *, phases: int = _MOST_PHASES,
    steps: int = _MOST_STEPS,
) -> Motion:  # fmt: skip
    """Solve one scene of plain numbers.

    An integration to another tolerance, or with weights changed by a share, tells its error. A search gives up sooner
    than a user would: after fewer phases, or steps of SciPy for one of them.
    """
    scene = chosen.scene
    try:
        with np.errstate(over="raise", invalid="raise", divide="raise", under="ignore"):
            motion = _solve(chosen, tolerance, nudge, phases, steps)
            end = motion.end
        if not math.isfinite(end.displacement) or not math.isfinite(end.velocity):
            raise OverflowError
        return motion
    except (FloatingPointError, OverflowError) as error:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, end_time = {scene.end_time!r}: the motion overflows; give "
            "a lower velocity or an earlier end"
        ) from error


def _solve(chosen: Plan, tolerance: float | None, nudge: float, most_phases: int, most_steps: int) -> Motion:
    scene, balance, law = chosen.scene, bind(chosen.scene), friction(chosen.scene.friction)
    balance = balance.nudged(nudge) if nudge else balance
    scale, radius = balance.time_scale, balance.radius
    follow, tolerance = _follower(chosen.method), chosen.tolerance if tolerance is None else tolerance
    two_way = bool(scene.called.get("shaking", {}).get("two_way", False))
    omega = number(scene.initial_velocity) / radius * scale
    end_time = None if scene.end_time is None else number(scene.end_time)
    end = math.inf if end_time is None else end_time / scale
    direction = (omega > 0.0) - (omega < 0.0)
    time = rotation = slip = excess = 0.0
    energy, phases, arrested, change = omega**2, list[Phase](), False, None
    whole = balance
    if chosen.method == STEPPING:
        stepped = _stepped(balance, law, omega, end, two_way)
        if stepped.moves:
            phases.append(Phase(0.0, stepped.duration, 0.0, stepped.direction, stepped, stepped.stops))
        if stepped.stops and math.isfinite(end):
            arrested = next_start(balance, law, Rest(0.0, 0.0), end, math.inf, two_way) is None
            time = stepped.duration if arrested else end
        elif stepped.stops:
            arrested, time = True, stepped.duration
        else:
            time, direction = stepped.duration, stepped.side * stepped.direction
            rotation, energy = stepped.direction * stepped.end, stepped.speed**2
        balance = replace(balance, forcing={})  # it is still from here on
    while time < end and not arrested:
        if energy == 0.0:
            found = next_start(balance, law, Rest(rotation, slip, excess), time, math.inf, two_way)
            if found is None:
                arrested = True
                break
            time, direction = found
            if time >= end:
                break
        # Just after a change nothing presses, to rounding: from then on it is the other way.
        if change is None:
            lifted = balance.lightened and _lifted(balance, rotation, direction, energy, time, excess)
        else:
            lifted = not phases[-1].solved.start.lifted
        start = Start(rotation, direction, energy, slip, lifted, excess)
        solved = follow(balance, law, start, end - time, time, tolerance, most_steps)
        change = solved.change
        duration = solved.duration if change is None else change[0]
        stop, solved.longest = time + duration, min(solved.longest, duration)
        phases.append(Phase(time, min(stop, end), rotation, direction, solved, solved.stops and stop < end))
        if stop >= end:
            break
        if change is None and not solved.stops:
            _refuse(scene, solved, stop * scale)
        x, energy = (solved.end, 0.0) if change is None else change[1:]
        time, rotation, slip, excess = stop, rotation + direction * x, slip + radius * x, solved.excess
        if energy == 0.0 and math.isinf(end) and balance.turns and never_rests(balance, law, excess):
            return Motion(chosen, whole, phases, time * scale, False)
        swings = min(swings_left(balance, law, phases), (end - time) / max(phases[-1].end - phases[-1].start, EPS))
        if len(phases) >= most_phases or swings > 2 * most_phases:  # it knows them to about a fourth
            raise ValueError(
                f"end_time = {scene.end_time!r}: this mass turns back {most_phases} times and more without resting; "
                "give an earlier end in s"
            )
    if not arrested:
        time = end
    if math.isinf(time):
        _refuse(scene, phases[-1].solved, math.inf)
    duration = time * scale if arrested or end_time is None else end_time
    return Motion(chosen, whole, phases, duration, arrested)


def _follower(method: str) -> "Callable[[Balance, Friction, Start, float, float, float, int], Followed]":
    """What solves one phase, from its start, longest duration, time, tolerance and most steps; only it is imported."""
    if method in (CLOSED_IN_TIME, STEPPING):
        from slipcircle.methods.frozen import Frozen

        return lambda balance, law, start, longest, time, tolerance, steps: Frozen(balance, law, start, longest)
    if method == INTEGRATION:
        try:
            from slipcircle.methods.integrate import Integrated
        except ImportError as error:
            raise ImportError("this scene is integrated by SciPy: pip install 'slipcircle[scenes]'") from error
        return Integrated
    if method == LINEAR_SYSTEM:
        from slipcircle.methods.heated import Heated

        return lambda balance, law, start, longest, time, tolerance, steps: Heated(balance, law, start, longest)
    from slipcircle.methods.phaseplane import Course

    return lambda balance, law, start, longest, time, tolerance, steps: Course(balance, law, start, longest)


def _stepped(balance: Balance, law: Friction, omega: float, end: float, two_way: bool) -> "Stepped":
    """The motion of frozen geometry until the shaking is over."""
    from slipcircle.inputs.series import Shaking
    from slipcircle.methods.stepping import Stepped

    functions: dict[str, Any] = {name: function for name, (function, _) in balance.forcing.items()}
    still = Pulse("rectangular", 0.0, 0.0, 1.0)
    shaking = Shaking(functions.get("k_h", still), functions.get("k_v"))
    return Stepped(balance, float(law.coefficient(0.0)), omega, end, shaking, balance.time_scale, two_way)


def _refuse(scene: Scene, solved: "Solved", time: float) -> None:
    if solved.balance.turns:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, friction: the chord stands upright after {time:.6g} s and "
            "the mass would hang over, which this method cannot follow; give an earlier end_time or a lower velocity"
        )
    raise ValueError("end_time: this slide never rests, as its geometry is frozen; add rotation, or give end_time in s")


def _lifted(balance: Balance, rotation: float, direction: int, energy: float, time: float, excess: float) -> bool:
    at = balance.position(rotation, direction) | balance.given(np.nextafter(time, np.inf), direction)
    return bool(balance.get("effective_stress", **at, omega_2=energy, excess=excess) < 0.0)
