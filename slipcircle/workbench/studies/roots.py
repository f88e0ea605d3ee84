"""Back-analysis of one parameter from one observation: all roots in its range, many candidates in each call."""

import math
from typing import Any

import numpy as np

from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.workbench.studies.problem import Kinds, SearchProblem

_PARTS = 16  # of a bracket: each round gains four bits
_ROUNDS = 16
_STEEP = 30.0  # greatest relative change of an outcome over that of the field, where the kind of motion changes
_ROUNDING = 64 * EPS  # relative difference of outcomes when other lanes are solved with them
_WIDE, _FLAT = 1e-6, 1e-12  # relative: wide brackets with tiny misfits are not divided, as the field has little effect
_TOLERANCE = 1e-9  # relative: at a jump over the observation the misfit is larger

Places = tuple[Integers, Integers]


def solve_exact(problem: SearchProblem) -> list[float]:
    """Return all values of the one field at which the one outcome equals the observation, in increasing order.

    All brackets that may contain a root are divided together, until their ends are neighbouring numbers or both meet
    the observation to rounding. The misfits at the ends are retained, because rounding might change their signs when
    they are computed with other lanes. A point that meets the observation is a root even without a bracket, because
    the outcome may jump there.
    """
    scale = abs(float(problem.targets[0]))
    rows = problem.ranges[0][None, :]
    fine: list[Floats] = []
    at_ends: Any = None
    for _ in range(_ROUNDS):
        misfit, kind = _misfit(problem, rows)
        if at_ends is not None:
            misfit[:, 0], misfit[:, -1] = at_ends
        elif _is_flat(misfit, scale):
            return []
        first, last = bracket_candidates(rows, misfit, kind, scale)
        size = np.abs(misfit)
        is_met = size <= _ROUNDING * scale
        fine.append(rows[is_met])
        left = rows[first]
        right = rows[last]
        is_level = np.maximum(size[first], size[last]) <= _FLAT * scale
        is_flat = is_level & _apart(left, right, _WIDE)
        is_fine = is_flat | (is_met[first] & is_met[last]) | ~_apart(left, right, 4 * EPS)
        fine += [left[is_fine], right[is_fine]]
        if is_fine.all():
            break
        rough = ~is_fine
        at_ends = misfit[first][rough], misfit[last][rough]
        rows = _divided(left[rough], right[rough])
    return _distinct_roots(problem, np.unique(np.concatenate(fine)))


def _misfit(problem: SearchProblem, rows: Floats) -> tuple[Floats, Kinds]:
    """Return outcome less target, and the kind of the motion, for every value of the field in an array."""
    outcomes, kind = problem.outcomes(rows.reshape(1, -1))
    misfit = outcomes.reshape(rows.shape) - problem.targets[0]
    return misfit, kind.reshape(rows.shape)


def _is_flat(misfit: Floats, scale: float) -> bool:
    """Return whether the field does not affect the outcome: all misfits, over ``scale``, vanish to within rounding."""
    largest = np.fmax.reduce(np.abs(misfit), axis=None)
    return bool(largest <= _FLAT * scale)


def limit_value(problem: SearchProblem) -> list[float]:
    """Return the value of the one field at which the outcome reaches a limit, in a list; empty without such a value.

    The outcome satisfies the limit there and at every greater value of the range or, if it does not at the greatest
    value, at smaller ones as far as possible. It may jump.
    """
    assert problem.limit is not None
    low, high = (end - problem.origins[0] for end in problem.limit)

    def satisfied(values: Floats) -> Flags:
        outcomes, _ = problem.outcomes(values[None])
        above = low <= outcomes[0]
        below = outcomes[0] <= high
        return above & below

    values = problem.ranges[0]
    met = satisfied(values)
    if np.all(met) or not np.any(met):
        return []
    for _ in range(_ROUNDS):
        last = np.flatnonzero(met[:-1] != met[1:])[-1]
        before, after = met[last : last + 2]
        values = np.linspace(values[last], values[last + 1], _PARTS + 1)
        met = satisfied(values)
        met[[0, -1]] = before, after
    first, *_, last_value = values.tolist()
    if met[-1]:
        return [last_value]
    return [first]


def _apart(left: Floats, right: Floats, least: float) -> Flags:
    """Return whether the ends of brackets differ by more than the share ``least`` of their magnitude."""
    magnitude = np.maximum(np.abs(left), np.abs(right))
    return right - left > least * magnitude


def _divided(left: Floats, right: Floats) -> Floats:
    """Return points that divide brackets into equal parts, (brackets, points), both ends included."""
    parts = np.linspace(0.0, 1.0, _PARTS + 1)
    widths = right - left
    rows = left[:, None] + widths[:, None] * parts
    rows[:, -1] = right
    return rows


def _distinct_roots(problem: SearchProblem, ends: Floats) -> list[float]:
    """Return the ends of fine brackets that are roots, the best of each group of neighbours."""
    target = float(problem.targets[0])
    outcomes, _ = problem.outcomes(ends[None])
    misfit = np.abs(outcomes[0] - target)
    is_root = misfit <= _TOLERANCE * abs(target)
    ends = ends[is_root]
    misfit = misfit[is_root]
    is_gap = np.diff(ends) > _TOLERANCE * np.abs(ends[1:])
    gaps = np.flatnonzero(is_gap) + 1
    roots = []
    for group, misfits in zip(np.split(ends, gaps), np.split(misfit, gaps), strict=True):
        if group.size:
            best = np.argmin(misfits)
            roots.append(float(group[best]))
    return roots


def bracket_candidates(x: Floats, misfit: Floats, kind: Kinds, target: float) -> tuple[Places, Places]:
    """Return the places (row, column) of the left and right ends of all brackets that may contain a root.

    A root is possible where the outcome passes the observed value, where the kind of motion changes near it, and where
    the outcome has an extremum near it.
    """
    left = x[:, :-1]
    right = x[:, 1:]
    size = np.abs(misfit)
    with np.errstate(invalid="ignore"):
        product = misfit[:, :-1] * misfit[:, 1:]  # NaN where one is
        nearest = np.fmin(size[:, :-1], size[:, 1:])
        magnitude = np.maximum(np.abs(left), np.abs(right))
        relative_width = (right - left) / np.maximum(magnitude, 1e-300)
        reachable = _STEEP * np.minimum(relative_width, 1.0) * target
        changes_kind = kind[:, :-1] != kind[:, 1:]
        may_jump_over = changes_kind & (nearest <= reachable)
        passes = (product <= 0.0) | may_jump_over
        same_side = product > 0.0
        stays_on_side = same_side[:, :-1] & same_side[:, 1:]
        turns_back = _is_dip(size) & stays_on_side
    row, column = np.nonzero(passes)
    row_of_dip, before_dip = np.nonzero(turns_back)
    rows = np.concatenate([row, row_of_dip])
    starts = np.concatenate([column, before_dip])
    ends = np.concatenate([column + 1, before_dip + 2])
    return (rows, starts), (rows, ends)


def _is_dip(size: Floats) -> Flags:
    """Return whether values within rows are at most both neighbours, and at most half of the larger neighbour."""
    before = size[:, :-2]
    here = size[:, 1:-1]
    after = size[:, 2:]
    less_than_both = here <= np.fmin(before, after)
    less_than_half = 2 * here <= np.fmax(before, after)
    return less_than_both & less_than_half


def extreme(problem: SearchProblem, sign: float) -> float:
    """Return the value of the field with the greatest (sign 1) or least (sign -1) outcome; NaN without motion."""
    greatest = -math.inf
    place = math.nan
    values = problem.ranges[0]
    for _ in range(_ROUNDS):
        outcomes, _ = problem.outcomes(values[None])
        outcome = np.nan_to_num(sign * outcomes[0], nan=-math.inf)
        best = int(np.argmax(outcome))
        if outcome[best] > greatest:
            greatest = float(outcome[best])
            place = float(values[best])
        before = max(best - 1, 0)
        after = min(best + 1, len(values) - 1)
        values = np.linspace(values[before], values[after], 2 * _PARTS + 1)
    return place
