"""The forces on an arc as arrows, after Figure 1-1: weight, and the reactions of the slip surface."""

import math
from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.core import Motion
from slipcircle.workbench.outputs.plotstyle import FORCES, beside, label

_ARROWS = (-0.6, -0.2, 0.2, 0.6)  # angles of the reactions from the middle of the arc, over alpha


def draw_forces(ax: Any, motion: Motion, mass: Any, size: float) -> float:
    """The weight at the centroid, and reactions along the arc; returns the height that has to be in view."""
    start, end = mass.ends.tolist()
    middle = (start + end) / 2
    alpha = (end - start) / 2
    half_arc = mass.radius * alpha
    length = min(0.16 * size, 0.9 * half_arc)
    centroid = mass.on_circle(middle) * _centroid_radius(alpha)
    tip = centroid - [0.0, 1.25 * length]
    _arrow(ax, centroid, tip, "weight", 2.2)
    beside(ax, "$W$", tip, (0.0, -1.0))
    angles = middle + alpha * np.array(_ARROWS)
    _reactions(ax, motion, mass.on_circle(angles), length)
    return float(tip[1] - 0.12 * size)


def _reactions(ax: Any, motion: Motion, places: Floats, length: float) -> None:
    """Reactions at places of the arc about the origin: normal towards K, tangential against the motion."""
    plan = motion.plan
    way = plan.scene.arc.facing
    if motion.phases:
        way = way * motion.phases[0].direction
    has_strength = float(motion.friction_at(0.0)) > 0.0 or "cohesion" in plan.effects
    normal_labels = []
    tangential_labels = []
    for at in places:
        outward = at / np.hypot(*at)
        x, y = outward
        along = way * np.array([-y, x])
        tail = at + 0.7 * length * outward
        _arrow(ax, tail, at, "normal", 1.6)
        normal_labels.append(at + 0.5 * length * outward)
        if has_strength:
            foot = at + 0.06 * length * outward
            tip = foot - 0.55 * length * along
            _arrow(ax, foot, tip, "tangential", 1.6)
            tangential_labels.append(foot - 0.3 * length * along)
    label(ax, "normal reaction $dN$", normal_labels, FORCES["normal"])
    if has_strength:
        label(ax, "tangential reaction $dT$", tangential_labels, FORCES["tangential"])


def _centroid_radius(alpha: float) -> float:
    """A circular segment's centroid from the centre, over R: 2/3 sin^3 alpha/(alpha - sin alpha cos alpha)."""
    if alpha < 1e-3:
        return 1.0
    sine = math.sin(alpha)
    area = alpha - sine * math.cos(alpha)
    return 2 / 3 * sine**3 / area


def _arrow(ax: Any, tail: Any, tip: Any, force: str, width: float) -> None:
    """A force as an arrow."""
    style = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11}
    style |= {"color": FORCES[force], "lw": width}
    ax.annotate("", tip, tail, arrowprops=style, zorder=5)
