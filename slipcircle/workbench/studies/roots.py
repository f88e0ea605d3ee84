"""Back-analysis of one number from one observation: all roots over its range, many candidates at once."""

import math

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import EPS
from slipcircle.workbench.studies.problem import Floats, Kinds, SearchProblem

_PARTS = 16  # into which a bracket is divided: each round gains four bits
_ROUNDS = 16
_STEEP = 30.0  # per cent that an outcome may change with a per cent of the number, where the motion changes its kind
_TOLERANCE = 1e-9  # relative: a jump over what was observed misses it by more


def solve_exact(problem: SearchProblem) -> list[float]:
    """All values of the one field at which the one outcome is as observed.

    Every bracket that may hold one is divided, all of them at once, until both its ends are neighbours.
    """
    rows, target = problem.ranges[0][None, :], float(problem.targets[0])
    ends = list[float]()
    for _ in range(_ROUNDS):
        outcomes, kind = (a.reshape(rows.shape) for a in problem.outcomes(rows.reshape(1, -1)))
        left, right = bracket_candidates(rows, outcomes - target, kind, abs(target))
        is_fine = right - left <= 4 * EPS * np.maximum(np.abs(left), np.abs(right))
        ends += left[is_fine].tolist() + right[is_fine].tolist()
        left, right = left[~is_fine], right[~is_fine]
        if not left.size:
            break
        rows = left[:, None] + (right - left)[:, None] * np.linspace(0.0, 1.0, _PARTS + 1)
        rows[:, -1] = right
    return _distinct_roots(problem, np.unique(ends)) if ends else []


def _distinct_roots(problem: SearchProblem, ends: Floats) -> list[float]:
    """Of ends of fine brackets those that are roots, the best of each group of neighbours."""
    target = float(problem.targets[0])
    misfit = np.abs(problem.outcomes(ends[None])[0][0] - target)
    is_root = misfit <= _TOLERANCE * abs(target)
    ends, misfit = ends[is_root], misfit[is_root]
    gaps = np.flatnonzero(np.diff(ends) > _TOLERANCE * np.abs(ends[1:])) + 1
    groups = zip(np.split(ends, gaps), np.split(misfit, gaps), strict=True)
    return [float(group[np.argmin(off)]) for group, off in groups if group.size]


def bracket_candidates(x: Floats, misfit: Floats, kind: Kinds, target: float) -> tuple[Floats, Floats]:
    """Both ends of the brackets within rows that may hold a root.

    That is where the outcome passes the observed value, where the motion changes its kind near it, and where the
    outcome turns back next to it.
    """
    left, right = x[:, :-1], x[:, 1:]
    size = np.abs(misfit)
    with np.errstate(invalid="ignore"):
        same_sign = misfit[:, :-1] * misfit[:, 1:] > 0.0
        opposite_sign = misfit[:, :-1] * misfit[:, 1:] <= 0.0  # neither where one is NaN
        relative_width = (right - left) / np.maximum(np.maximum(np.abs(left), np.abs(right)), 1e-300)
        reachable = _STEEP * np.minimum(relative_width, 1.0) * target
        is_near = np.fmin(size[:, :-1], size[:, 1:]) <= reachable
        passes = opposite_sign | ((kind[:, :-1] != kind[:, 1:]) & is_near)
        turns_back = _is_dip(size) & same_sign[:, :-1] & same_sign[:, 1:]
    starts = np.concatenate([left[passes], x[:, :-2][turns_back]])
    return starts, np.concatenate([right[passes], x[:, 2:][turns_back]])


def _is_dip(size: Floats) -> NDArray[np.bool_]:
    """Whether values within rows are less than both their neighbours, and than half of one."""
    before, here, after = size[:, :-2], size[:, 1:-1], size[:, 2:]
    return (here <= np.fmin(before, after)) & (2 * here <= np.fmax(before, after))


def extreme(problem: SearchProblem, sign: float) -> float:
    """Where the greatest (sign 1) or least (sign -1) outcome lies; NaN where no motion counts."""
    greatest, place, values = -math.inf, math.nan, problem.ranges[0]
    for _ in range(_ROUNDS):
        outcome = np.nan_to_num(sign * problem.outcomes(values[None])[0][0], nan=-math.inf)
        k = int(np.argmax(outcome))
        if outcome[k] > greatest:
            greatest, place = float(outcome[k]), float(values[k])
        low, high = values[max(k - 1, 0)], values[min(k + 1, len(values) - 1)]
        values = np.linspace(low, high, 2 * _PARTS + 1)
    return place
