"""From a plan to a motion: phase after phase, each in one direction, until the mass rests or its time is over."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from slipcircle.balance import Balance, bind
from slipcircle.friction import Friction, friction
from slipcircle.motion import Motion, Phase, Start
from slipcircle.plan import CLOSED_IN_TIME, Plan, plan
from slipcircle.roots import highest, root
from slipcircle.scene import Scene

if TYPE_CHECKING:
    from slipcircle.frozen import Frozen
    from slipcircle.phaseplane import Course

_MOST_PHASES = 2000
EPS = 2.0**-52


def solve(scene: Scene, accuracy: float | None = None) -> Any:
    """Solve a scene until it rests, or until its end time; a scene of arrays lane by lane.

    Parameters
    ----------
    scene : Scene
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9.

    Returns
    -------
    slipcircle.motion.Motion or slipcircle.motions.Motions
        Motions, of the scene's broadcast shape, where its fields are arrays.

    Raises
    ------
    ValueError
        If the scene never rests and has no end time, turns over, or overflows; of an ensemble, such lanes have the
        status FAILED.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if the drive is at most the
    resistance, and turns back if not. A mass that nothing brings to rest (no friction, no cohesion) is followed to
    its first standstill.
    """
    if scene.shape:
        from slipcircle.motions import solve_ensemble

        return solve_ensemble(plan(scene, accuracy))
    return solve_one(plan(scene, accuracy))


def solve_one(chosen: Plan) -> Motion:
    """Solve one scene of plain numbers."""
    scene = chosen.scene
    try:
        with np.errstate(over="raise", invalid="raise", divide="raise", under="ignore"):
            motion = _solve(chosen)
            end = motion.end
        if not math.isfinite(end.displacement) or not math.isfinite(end.velocity):
            raise OverflowError
        return motion
    except (FloatingPointError, OverflowError) as error:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, end_time = {scene.end_time!r}: the motion overflows; give "
            "a lower velocity or an earlier end"
        ) from error


def _solve(chosen: Plan) -> Motion:
    scene, balance, law = chosen.scene, bind(chosen.scene), friction(chosen.scene.friction)
    scale, radius = float(scene.arc.time_scale), float(np.asarray(scene.arc.radius))
    follow = _follower(chosen.method)
    omega = float(np.asarray(scene.initial_velocity)) / radius * scale
    end_time = None if scene.end_time is None else float(np.asarray(scene.end_time))
    end = math.inf if end_time is None else end_time / scale
    direction = int(np.sign(omega))
    time = rotation = slip = 0.0
    energy, phases, arrested, change = omega**2, [], False, None
    while time < end:
        if energy == 0.0:
            direction = _way(balance, law, rotation, slip)
            if direction == 0:
                arrested = True
                break
        # Just after a change nothing presses, to rounding: from then on it is the other way.
        lifted = _lifted(balance, rotation, direction, energy) if change is None else not phases[-1].solved.start.lifted
        start = Start(rotation, direction, energy, slip, lifted)
        solved = follow(balance, law, start, end - time)
        change = _change(solved, balance)
        duration = solved.duration if change is None else change[0]
        stop, solved.longest = time + duration, min(solved.longest, duration)
        phases.append(Phase(time, min(stop, end), rotation, direction, solved))
        if stop >= end:
            break
        if change is None and not solved.stops:
            _refuse(scene, solved, stop * scale)
        x, energy = (solved.end, 0.0) if change is None else change[1:]
        time, rotation, slip = stop, rotation + direction * x, slip + radius * x
        if energy == 0.0 and math.isinf(end) and balance.turns and _never_rests(balance, law):
            return Motion(chosen, balance, phases, time * scale, False)
        if len(phases) >= _MOST_PHASES:
            raise ValueError(
                f"end_time = {scene.end_time!r}: this mass turns back {_MOST_PHASES} times in {time * scale:.6g} s "
                "without resting; give an earlier end in s"
            )
    else:
        time = end
    if not arrested:
        time = end
    if math.isinf(time):
        _refuse(scene, phases[-1].solved, math.inf)
    duration = time * scale if arrested or end_time is None else end_time
    return Motion(chosen, balance, phases, duration, arrested)


def _follower(method: str) -> "Callable[[Balance, Friction, Start, float], Course | Frozen]":
    """What solves one phase; only this method's module is imported."""
    if method == CLOSED_IN_TIME:
        from slipcircle.frozen import Frozen

        return Frozen
    from slipcircle.phaseplane import Course

    return Course


def _refuse(scene: Scene, solved: "Course | Frozen", time: float) -> None:
    if solved.balance.turns:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, friction: the chord stands upright after {time:.6g} s and "
            "the mass would hang over, which this method cannot follow; give an earlier end_time or a lower velocity"
        )
    raise ValueError("end_time: this slide never rests, as its geometry is frozen; add rotation, or give end_time in s")


def _way(balance: Balance, law: Friction, rotation: float, slip: float) -> int:
    """The direction in which a mass at rest moves, 0 if it stays: by the limit friction, of which the drive is made."""
    for side in (1, -1):
        at = balance.position(rotation, side)
        if balance.get("normal", **at) <= 0.0:
            moving = at["fall"] > balance.get("constant", mu=0.0)
        else:
            moving = balance.get("limit_friction", **at) > float(law.coefficient(slip))
        if moving:
            return side
    return 0


def _lifted(balance: Balance, rotation: float, direction: int, energy: float) -> bool:
    at = balance.position(rotation, direction)
    return bool(balance.get("effective_stress", **at, omega_2=energy) < 0.0)


def _never_rests(balance: Balance, law: Friction) -> bool:
    """No cohesion, and no friction, or water that carries the mass even where it would press most."""
    if balance.values.get("cohesion", 0.0):
        return False
    most = balance.radial if balance.turns else balance.press
    return (law.constant and float(law.coefficient(0.0)) == 0.0) or balance.get("normal", press=most) <= 0.0


def _change(solved: "Course | Frozen", balance: Balance) -> tuple[float, float, float] | None:
    """Time, x and E at which the mass lifts off or lands, if it does before the phase ends; only water can carry it."""
    if balance.get("normal", press=0.0) == 0.0:  # no water that could carry the mass
        return None
    water = abs(balance.get("effective_stress", press=0.0, omega_2=0.0))
    last, sign = solved.last, 1.0 if solved.start.lifted else -1.0

    def over(s: Any) -> Any:
        x, energy = solved.passing(s)
        # Strong friction may hold the mass where what presses is rounding: that is neither lift-off nor landing.
        return sign * solved.pressing(x, energy) - 4 * EPS * (np.abs(solved.pressing(x, 0.0)) + water)

    def at(s: float) -> float:
        return float(over(np.array([s]))[0])

    places = last * np.sin(np.linspace(0.0, np.pi / 2, 65)) ** 2
    found = over(places).tolist()
    for k in range(1, len(places)):
        low, high, at_high = float(places[k - 1]), float(places[k]), found[k]
        summit = k + 1 < len(places) and found[k - 1] < found[k] >= found[k + 1]
        if summit and 0.0 <= -found[k] < found[k] - min(found[k - 1], found[k + 1]):  # perhaps there and back between
            high = highest(at, low, float(places[k + 1]))
            at_high = at(high)
        if at_high <= 0.0:
            continue
        while (at_low := at(low)) >= 0.0 and high > 1e-15 * last:  # zero, to rounding, at the start
            low = high / 2
            if at(low) >= 0.0:  # also where nothing presses exactly there, or neither bound would move
                high, at_high = low, at(low)
        s = np.array([root(at, low, high, at_low, at_high) if at_low < 0.0 else high])
        x, energy = solved.passing(s)
        return float(solved.passed(s)[0]), float(x[0]), float(energy[0])
    return None
