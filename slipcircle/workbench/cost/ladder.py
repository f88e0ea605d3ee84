"""Effect ladder: a scene solved with its effects added one at a time, to show the change and cost of each."""

import math
from dataclasses import dataclass, replace
from functools import partial

from slipcircle.base.kinds import Names
from slipcircle.core import Motion, Scene, solve
from slipcircle.ground import Section
from slipcircle.workbench.cost.rows import medians


@dataclass(frozen=True)
class Rung:
    """One step of the ladder, a solved scene."""

    added: str  # the effect added in this step, "" for none
    effects: Names  # all effects in this step
    method: str  # method of solution
    seconds: float  # median time of a solution on this machine
    peak_velocity: float  # m/s
    run_out: float  # m
    duration: float  # s
    arrested: bool  # whether it rests at the end
    difference: float  # greatest relative difference from the complete scene in peak velocity, run-out and duration


def effect_ladder(scene: Scene) -> list[Rung]:
    """Solve a scene with its effects added one at a time, in order of decreasing influence.

    The order is found from the complete scene downwards: each step leaves out the effect whose absence changes the
    motion least. A motion that would never rest is followed for the duration of the complete scene.
    """
    full = solve(scene)
    chosen = full.plan.effects
    order = list[str]()
    motions = [full]
    while chosen:
        without = [(e, _solved(scene, tuple(x for x in chosen if x != e), full)) for e in reversed(chosen)]
        least, motion = min(without, key=lambda one: _distance(one[1], full))
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
    """Return the motion with some of the effects; for the duration of the ``full`` motion if it does not end.

    ``effects`` are their names.
    """
    arc = scene.arc
    if isinstance(arc, Section) and "pore_pressure" in {*full.plan.effects} - {*effects}:
        arc = replace(arc, level=None)  # the water level would add the effect
    part = replace(scene, arc=arc, effects={e: scene.called[e] for e in effects if e in scene.effects}, uncertain={})
    try:
        return solve(part)
    except ValueError:
        return solve(replace(part, end_time=full.duration or 1.0))


def _distance(motion: Motion, full: Motion) -> float:
    """Return the greatest relative difference from ``full`` in peak velocity, run-out and duration."""
    of_motion, of_full = ((float(m.peak.velocity), m.run_out, m.duration) for m in (motion, full))
    distances = []
    for value, whole in zip(of_motion, of_full, strict=True):
        if whole:
            distances.append(abs(value - whole) / abs(whole))
        else:
            distances.append(math.inf if value else 0.0)
    return max(distances)
