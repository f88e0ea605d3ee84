"""Free water on the ground above arcs: the moment of its pressure, and its effect on normal stresses."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.ground import Ponds
from slipcircle.workbench.stability.bases import Arcs
from slipcircle.workbench.stability.columns import SlopeArrays
from slipcircle.workbench.stability.slices import Slices

_ROUNDING = 1e-9  # over R: as near to the end of an arc, a shore is that end, as at an end of flooded ground


def at_shores(slope: SlopeArrays, arcs: Arcs) -> Any:
    """Return the moment over gamma R^3 of free water on the ground minus that of the water displaced below it, (n,).

    On the verticals from its shores to the arc, of height h, its pressure has the moment gamma_w h^2/2 (cos b - h/3).
    """
    ponds = slope.ponds
    if ponds is None:
        return 0.0
    x, y = arcs.centre.T
    sines = (np.stack([ponds.first, ponds.last]) - x) / arcs.radius
    after_first = sines > np.sin(arcs.first) + _ROUNDING
    before_last = sines < np.sin(arcs.last) - _ROUNDING
    cosine = np.sqrt(np.maximum(1.0 - sines**2, 0.0))
    height = (ponds.level - y) / arcs.radius + cosine
    inside = np.where(after_first & before_last, height**2 / 2 * (cosine - height / 3), 0.0)
    at_first, at_last = inside.sum(axis=1)
    return slope.water_unit_weight / slope.soils.unit_weight[0] * (at_last - at_first)


def level_at_exit(ponds: Ponds, arcs: Arcs, facing: Floats) -> Floats:
    """Return the level of free water above the exit of each arc, over R from the centre, -inf for a dry exit.

    ``facing`` is 1 for arcs that slide to the right, -1 to the left, 0 for neither.
    """
    place = np.where(facing > 0.0, arcs.last, arcs.first)
    x, y = arcs.centre.T
    exit_x = x + arcs.radius * np.sin(place)
    exit_y = y - arcs.radius * np.cos(place)
    return np.where(facing == 0.0, -np.inf, (ponds.covering(exit_x, exit_y) - y) / arcs.radius)


def submerged(slices: Slices, level: Floats) -> Slices:
    """Return slices with the reference level of free water at the exit of each arc, from `level_at_exit`, (n,).

    What lies below it is buoyant, and pore pressure counts in excess of it; other free water is a load.
    """
    of_arc = level[slices.arc]
    middle = len(slices.sine) // 2
    above_arc = of_arc + slices.cosine[middle] > 0.0
    above_ground = of_arc > slices.surface(0)[middle]
    height = np.where(above_arc, of_arc, 0.0)
    constant = np.where(above_ground, slices.constant[0], height)
    gradient = np.where(above_ground, slices.gradient[0], 0.0)
    water = slices.water * above_arc
    none = np.zeros_like(water)
    of_weight = np.stack([constant, gradient, np.ones_like(water)])
    relieved = water * np.stack([height, none, np.ones_like(water)])
    buoyancy = -water * of_weight
    on_ground = relieved + buoyancy
    stresses = slices.stresses
    return slices._replace(
        steps=np.concatenate([slices.steps, [-water]]),
        constant=np.concatenate([slices.constant, [constant]]),
        gradient=np.concatenate([slices.gradient, [gradient]]),
        shaken=np.append(slices.shaken, False),
        stresses=stresses._replace(buoyancy=buoyancy, relieved=relieved, excess=stresses.pond - on_ground),
    )
