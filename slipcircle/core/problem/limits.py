"""Decisions of arcs close to their limit friction, by the exact limit friction."""

from typing import Any

import numpy as np

from slipcircle.base.decimals import limit_parts
from slipcircle.base.kinds import Floats
from slipcircle.core.problem.problem import NEAR, Problem
from slipcircle.core.scene.arc import Arc


def refine(problem: Problem, margins: Floats) -> Any:
    """Use the exact limit friction in lanes that decide close to it; return the indices of these lanes.

    ``margins`` are the least margins of the decisions at rest in a first solution, in units of rounding, (lanes,). The
    rounded limit friction suffices for masses other than plain arcs, for forces that change in time or with the
    rotation, and for scaled strengths.
    """
    plan = problem.plan
    arc = plan.scene.arc
    is_scaled = np.any(problem.start["strength_factor"] != 1.0)
    if "LIMIT_REST" in problem.start or type(arc) is not Arc or plan.recipe.moving or is_scaled:
        return ()
    least = NEAR if problem.lanes == 1 else min(NEAR, 10.0 / plan.accuracy)
    (lanes,) = np.nonzero(margins < least)
    if not lanes.size:
        return ()
    shape = plan.scene.shape
    ends = [np.broadcast_to(x, shape).ravel()[lanes].tolist() for x in (arc.theta_1, arc.theta_2)]
    parts = np.zeros((2, problem.lanes))
    parts[0] = problem.start["LIMIT"]
    parts[:, lanes] = np.array([*map(limit_parts, *ends)]).T
    limits, rests = parts
    problem.begin_with(LIMIT=limits, LIMIT_REST=rests)
    return lanes
