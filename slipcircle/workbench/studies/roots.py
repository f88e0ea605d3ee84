"""Back-analysis of one parameter from one observation: all roots in its range, many candidates in each call."""

import math

import numpy as np

from slipcircle.base.arrays import EPS, quiet
from slipcircle.base.kinds import Flags, Floats, Integers
from slipcircle.workbench.studies.problem import Kinds, SearchProblem

_PARTS = 16  # of a bracket: each round gains four bits
_ROUNDS = 16
_STEEP = 30.0  # greatest relative change of an outcome over that of the field, where the kind of motion changes
_ROUNDING = 64 * EPS  # relative difference of outcomes when other lanes are solved with them
_WIDE = 1e-6  # relative: wide brackets with tiny misfits are not divided, as the field has little effect
_FLAT = 1e-12
_TOLERANCE = 1e-9  # relative: at a jump over the observation the misfit is larger

Places = tuple[Integers, Integers]


def solve_exact(problem: SearchProblem) -> list[float]:
    """Return all values of the one field at which the one outcome equals the observation, in increasing order.

    All brackets that may contain a root are divided together, until their ends are neighbouring numbers or both meet
    the observation to rounding. The misfits at the ends are retained, because rounding might change their signs when
    they are computed with other lanes. A point that meets the observation is a root even without a bracket, because
    the outcome may jump there.
    """
    scale = abs(problem.targets[0])
    rows = problem.ranges[0][None, :]
    fine = []
    at_ends = None
    for _ in range(_ROUNDS):
        outcomes, kind = problem.outcomes(rows.reshape(1, -1))
        misfit = outcomes.reshape(rows.shape) - problem.targets[0]
        if at_ends is not None:
            misfit[:, 0], misfit[:, -1] = at_ends
        elif np.fmax.reduce(np.abs(misfit), axis=None) <= _FLAT * scale:  # the field does not affect the outcome
            return []
        places = bracket_candidates(rows, misfit, kind.reshape(rows.shape), scale)
        left, right = (rows[place] for place in places)
        at_ends = np.stack([misfit[place] for place in places])
        greatest = np.abs(at_ends).max(axis=0)
        is_flat = (greatest <= _FLAT * scale) & _apart(left, right, _WIDE)
        is_fine = is_flat | (greatest <= _ROUNDING * scale) | ~_apart(left, right, 4 * EPS)
        fine += [rows[np.abs(misfit) <= _ROUNDING * scale], left[is_fine], right[is_fine]]
        if is_fine.all():
            break
        at_ends = at_ends[:, ~is_fine]
        rows = np.linspace(left[~is_fine], right[~is_fine], _PARTS + 1, axis=1)
    return _distinct_roots(problem, np.unique(np.concatenate(fine)))


def limit_value(problem: SearchProblem) -> list[float]:
    """Return the value of the one field at which the outcome reaches a limit, in a list; empty without such a value.

    The outcome satisfies the limit there and at every greater value of the range or, if it does not at the greatest
    value, at smaller ones as far as possible. It may jump.
    """
    assert problem.limit is not None
    low, high = (end - problem.origins[0] for end in problem.limit)

    def satisfied(values: Floats) -> Flags:
        outcomes, _ = problem.outcomes(values[None])
        return (low <= outcomes[0]) & (outcomes[0] <= high)

    values = problem.ranges[0]
    met = satisfied(values)
    if np.all(met) or not np.any(met):
        return []
    for _ in range(_ROUNDS):
        last = np.flatnonzero(met[:-1] != met[1:])[-1]
        ends = met[last : last + 2]
        values = np.linspace(values[last], values[last + 1], _PARTS + 1)
        met = satisfied(values)
        met[[0, -1]] = ends
    return [float(values[-1] if met[-1] else values[0])]


def _apart(left: Floats, right: Floats, least: float) -> Flags:
    """Return whether the ends of brackets, ``left`` and ``right``, differ by more than a share of their magnitude.

    The share is ``least``.
    """
    return right - left > least * np.maximum(np.abs(left), np.abs(right))


def _distinct_roots(problem: SearchProblem, ends: Floats) -> list[float]:
    """Return the ends of fine brackets that are roots, the best of each group of neighbours.

    ``ends`` are increasing values of the field, in its unit.
    """
    target = float(problem.targets[0])
    outcomes, _ = problem.outcomes(ends[None])
    misfit = np.abs(outcomes[0] - target)
    is_root = misfit <= _TOLERANCE * abs(target)
    ends = ends[is_root]
    gaps = np.flatnonzero(np.diff(ends) > _TOLERANCE * np.abs(ends[1:])) + 1
    groups = zip(np.split(ends, gaps), np.split(misfit[is_root], gaps), strict=True)
    return [float(group[np.argmin(misfits)]) for group, misfits in groups if group.size]


def bracket_candidates(x: Floats, misfit: Floats, kind: Kinds, target: float) -> tuple[Places, Places]:
    """Return the places (row, column) of the left and right ends of all brackets that may contain a root.

    The arrays have values of the field in increasing order along rows, with misfits and kinds of motion; ``target`` is
    the size of the observation.

    A root is possible where the outcome passes the observed value, where the kind of motion changes near it, and where
    the outcome has an extremum near it.
    """
    left = np.abs(misfit[:, :-1])
    right = np.abs(misfit[:, 1:])
    here = right[:, :-1]
    before = left[:, :-1]
    after = right[:, 1:]
    with quiet():
        product = misfit[:, :-1] * misfit[:, 1:]  # NaN where one is
        magnitude = np.maximum(np.abs(x[:, :-1]), np.abs(x[:, 1:]))
        reachable = _STEEP * np.minimum(np.diff(x) / np.maximum(magnitude, 1e-300), 1.0) * target
        passes = (product <= 0.0) | ((np.diff(kind) != 0) & (np.fmin(left, right) <= reachable))
        # At an extremum the size is at most both neighbours', and at most half of the larger neighbour's.
        is_dip = (here <= np.fmin(before, after)) & (2 * here <= np.fmax(before, after))
        turns_back = is_dip & (product[:, :-1] > 0.0) & (product[:, 1:] > 0.0)
    sections = np.nonzero(passes)
    dips = np.nonzero(turns_back)
    rows, starts = np.hstack([sections, dips])
    return (rows, starts), (rows, starts + np.repeat([1, 2], [len(sections[0]), len(dips[0])]))


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
            greatest = outcome[best]
            place = float(values[best])
        values = np.linspace(values[max(best - 1, 0)], values[min(best + 1, len(values) - 1)], 2 * _PARTS + 1)
    return place
