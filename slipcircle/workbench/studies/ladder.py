"""The effect ladder: a scene solved with its effects added one by one, so that each shows what it changes and costs."""

import math
from dataclasses import dataclass, replace
from functools import partial

from slipcircle.base.kinds import Names
from slipcircle.core import Motion, Scene, solve
from slipcircle.ground import Section
from slipcircle.workbench.cost.rows import medians


@dataclass(frozen=True)
class Rung:
    """One step of the ladder."""

    added: str  # the effect added in this step, "" for none
    effects: Names  # all of this step
    method: str  # how it was solved
    seconds: float  # that a solution took here, the median
    peak_velocity: float  # m/s
    run_out: float  # m
    duration: float  # s
    arrested: bool  # whether it rests at the end
    difference: float  # to the fullest scene: the largest of peak velocity, run-out and duration, relative


def ladder(scene: Scene) -> list[Rung]:
    """Solve a scene with its effects added in the order of what they change, most first.

    Seen from the fullest scene, each step down leaves out the effect without which the motion stays closest to the
    fullest's. A step that would never rest is followed as long as the fullest scene takes.
    """
    full = solve(scene)
    chosen, order, motions = full.plan.effects, list[str](), [full]
    while chosen:
        without = [(e, _solved(scene, tuple(x for x in chosen if x != e), full)) for e in reversed(chosen)]
        least, motion = min(without, key=lambda found: _distance(found[1], full))
        chosen = tuple(e for e in chosen if e != least)
        order.insert(0, least)
        motions.insert(0, motion)
    seconds = medians([partial(solve, motion.plan.scene) for motion in motions])
    return [
        Rung(
            added,
            tuple(order[:k]),
            motion.plan.method,
            seconds[k],
            float(motion.peak.velocity),
            motion.run_out,
            motion.duration,
            motion.arrested,
            _distance(motion, full),
        )
        for k, (added, motion) in enumerate(zip(["", *order], motions, strict=True))
    ]


def _solved(scene: Scene, effects: Names, full: Motion) -> Motion:
    """The motion with some of the effects; where it never rests, or turns over, as long as the fullest takes."""
    arc = scene.arc
    if isinstance(arc, Section) and "pore_pressure" in {*full.plan.effects} - {*effects}:
        arc = replace(arc, level=None)  # the water level is what calls for it
    given = {e: scene.called[e] for e in effects if e in scene.effects}
    part = replace(scene, arc=arc, effects=given, uncertain={})
    try:
        return solve(part)
    except ValueError:
        return solve(replace(part, end_time=full.duration or 1.0))


def _distance(motion: Motion, full: Motion) -> float:
    """The greatest relative difference of peak velocity, run-out and duration from those of the whole scene."""
    of_motion, of_full = ((float(m.peak.velocity), m.run_out, m.duration) for m in (motion, full))
    distances = []
    for value, whole in zip(of_motion, of_full, strict=True):
        if whole:
            distances.append(abs(value - whole) / abs(whole))
        else:
            distances.append(math.inf if value else 0.0)
    return max(distances)
