"""The effect ladder: a scene solved with its effects added one by one, so that each shows what it changes and costs."""

import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

from slipcircle.motion.motion import Motion
from slipcircle.motion.plan import plan
from slipcircle.motion.solver import solve
from slipcircle.scene.scene import Scene
from slipcircle.scene.section import Section

_PATIENCE = 0.5  # seconds for the solutions of one rung that are timed, five at most


@dataclass(frozen=True)
class Rung:
    """One step of the ladder.

    Attributes
    ----------
    added : str
        The effect added in this step, "" for none.
    effects : tuple of str
        All effects of this step.
    method : str
        How it was solved.
    seconds : float
        Median time of a solution, measured here.
    cost : int
        Floating-point operations that a solution typically takes.
    peak_velocity, run_out, duration : float
        m/s, m, s.
    arrested : bool
        Whether it rests at the end.
    difference : float
        To the fullest scene: the largest of the relative differences in peak velocity, run-out and duration.
    """

    added: str
    effects: tuple[str, ...]
    method: str
    seconds: float
    cost: int
    peak_velocity: float
    run_out: float
    duration: float
    arrested: bool
    difference: float


def ladder(scene: Scene, clock: Callable[[], float] = time.process_time) -> list[Rung]:
    """Solve a scene with its effects added in the order of what they change, most first.

    Seen from the fullest scene, each step down leaves out the effect without which the motion stays closest to the
    fullest's. A step that would never rest is followed as long as the fullest scene takes.

    Parameters
    ----------
    scene : Scene
    clock : callable, optional
        Seconds, by default of the processor.
    """
    full = solve(scene)
    chosen, order, motions = full.plan.effects, list[str](), [full]
    while chosen:
        without = [(e, _solved(scene, tuple(x for x in chosen if x != e), full)) for e in reversed(chosen)]
        least, motion = min(without, key=lambda found: _distance(found[1], full))
        chosen = tuple(e for e in chosen if e != least)
        order.insert(0, least)
        motions.insert(0, motion)
    return [
        _rung(added, tuple(order[:k]), motion, full, clock)
        for k, (added, motion) in enumerate(zip(["", *order], motions, strict=True))
    ]


def _with(scene: Scene, effects: tuple[str, ...]) -> Scene:
    arc = scene.arc
    if isinstance(arc, Section) and "pore_pressure" not in effects:
        arc = replace(arc, level=None)  # the water level is what calls for it
    given = {e: scene.called[e] for e in effects if e in scene.effects}
    return replace(scene, arc=arc, effects=given, uncertain={}, stability=None)


def _solved(scene: Scene, effects: tuple[str, ...], full: Motion) -> Motion:
    """The motion with some of the effects; where it never rests, or turns over, as long as the fullest takes."""
    part = _with(scene, effects)
    try:
        return solve(part)
    except ValueError:
        return solve(replace(part, end_time=full.duration or 1.0))


def _distance(motion: Motion, full: Motion) -> float:
    pairs = [(float(m.peak.velocity), m.run_out, m.duration) for m in (motion, full)]
    return max(abs(a - b) / abs(b) if b else (math.inf if a else 0.0) for a, b in zip(*pairs, strict=True))


def _rung(added: str, effects: tuple[str, ...], motion: Motion, full: Motion, clock: Callable[[], float]) -> Rung:
    taken = list[float]()
    while len(taken) < 5 and sum(taken) < _PATIENCE:
        start = clock()
        solve(motion.plan.scene)
        taken.append(clock() - start)
    return Rung(
        added, effects, motion.plan.method, statistics.median(taken), plan(motion.plan.scene).cost,
        float(motion.peak.velocity), motion.run_out, motion.duration, motion.arrested, _distance(motion, full),
    )  # fmt: skip
