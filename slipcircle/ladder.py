"""The effect ladder: a scene solved with its effects added one by one, so that each shows what it changes and costs."""

import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

from slipcircle.motion import Motion
from slipcircle.plan import plan
from slipcircle.scene import Scene
from slipcircle.solver import solve


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


def ladder(scene: Scene, clock: Callable[[], float] = time.perf_counter) -> list[Rung]:
    """Solve a scene with its effects added in the order of what they change, most first.

    Each step adds the effect that brings the motion closest to the fullest scene's. A step that would never rest is
    followed as long as the fullest scene takes.

    Parameters
    ----------
    scene : Scene
    clock : callable, optional
        Seconds.
    """
    full = solve(scene)
    chosen: tuple[str, ...] = ()
    rungs = [_rung(scene, "", chosen, full, clock)]
    while len(chosen) < len(full.plan.effects):
        rest = [e for e in full.plan.effects if e not in chosen]
        best = min(rest, key=lambda e: (_distance(_solved(scene, (*chosen, e), full), full), rest.index(e)))
        chosen = (*chosen, best)
        rungs.append(_rung(scene, best, chosen, full, clock))
    return rungs


def _with(scene: Scene, effects: tuple[str, ...]) -> Scene:
    return replace(scene, effects={e: p for e, p in scene.called.items() if e in effects})


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


def _rung(scene: Scene, added: str, effects: tuple[str, ...], full: Motion, clock: Callable[[], float]) -> Rung:
    motion = _solved(scene, effects, full)
    taken = []
    for _ in range(5):
        start = clock()
        solve(motion.plan.scene)
        taken.append(clock() - start)
    return Rung(
        added, effects, motion.plan.method, statistics.median(taken), plan(motion.plan.scene).cost,
        float(motion.peak.velocity), motion.run_out, motion.duration, motion.arrested, _distance(motion, full),
    )  # fmt: skip
