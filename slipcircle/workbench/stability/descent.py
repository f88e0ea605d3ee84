"""Descent to the least values of circles in many valleys at once, by grids of neighbours and parabolas."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np

from slipcircle.base.kinds import ArrayPair, Floats

_LEAST_SHARE = 0.005
_SHRINK = 0.5  # of the steps of a grid without a better neighbour
_SHRINK_SMOOTH = 0.2  # where a parabola describes it
_GROWTH = 2.0  # of steps while the best neighbour is on the rim
_GAIN = 1e-6  # relative; by less, a step counts as none
_TIE = 1e-10  # relative; factors as near as this are equal, so that no rounding decides the course of a search
FINEST = 1e-4  # final step in a valley, relative to its first step
_HOPELESS = 0.1  # over the least factor, as a share of it, a valley is left
_OFFSETS = np.array(list(product([-1.0, 0.0, 1.0], repeat=3)))
_MIDDLE = len(_OFFSETS) // 2
_NONE_AND_SUBSETS = list(product([False, True], repeat=3))
_SUBSETS = np.array(_NONE_AND_SUBSETS[1:])


class Descent:
    """Circles (n, 4) as in `family`, each with the steps of its grid, and the least value so far.

    ``step`` are the first steps, (n, 4), ``greatest_length`` is the length of the ground in m, and ``finest`` the final
    step over the first step.
    """

    def __init__(self, q: Floats, step: Floats, greatest_length: float, finest: float = FINEST) -> None:
        self.q = q.copy()
        self.best = np.full(len(q), np.inf)
        self._first_step = step
        self._finest = finest
        self._step = step.copy()
        self._leaps = np.zeros((len(q), len(_SUBSETS), 3))
        self._greatest = np.array([greatest_length, greatest_length, 1.0])

    @property
    def unfinished(self) -> Any:
        """Return the indices of circles whose steps are not yet small."""
        is_coarse = self._step > self._finest * self._first_step
        return np.flatnonzero(np.any(is_coarse, axis=1))

    def proposals(self) -> Floats:
        """Return circles to evaluate, (unfinished, 34, 4): 27 on a grid and 7 minima of parabolas."""
        live = self.unfinished
        step = self._step[live, None, :3]
        grid = _OFFSETS * step
        leaps = self._leaps[live]
        away = np.concatenate([grid, leaps], axis=1)
        middle = self.q[live, None]
        near = np.repeat(middle, away.shape[1], axis=1)
        numbers = near[..., :3]
        numbers += away
        least = [0.0, 0.0, _LEAST_SHARE]
        np.clip(numbers, least, self._greatest, out=numbers)
        return near

    def move(self, near: Floats, values: Floats) -> None:
        """Move to the best proposals, choose the next steps, and abandon circles far above the least value.

        ``near`` are the `proposals`, and ``values`` their factors, (unfinished, 34), infinite where there is none.
        """
        live = self.unfinished
        rows = np.arange(len(live))
        least = np.min(values, axis=1)
        chosen = np.argmax(values <= tied(least)[:, None], axis=1)  # the first
        lowest = values[rows, chosen]
        before = self.best[live]
        size = np.abs(lowest)
        better = tied(lowest) < before
        with np.errstate(invalid="ignore"):
            gain = before - lowest
            gains = gain > _GAIN * size
        middle = self.q[live]
        best_of_near = near[rows, chosen]
        target = np.where(better[:, None], best_of_near, middle)
        to_middle = (middle - target)[:, None, :3]
        self.q[live] = target
        self.best[live] = np.where(better, lowest, before)

        on_grid = values[:, : len(_OFFSETS)]
        leaps = _leaps(on_grid)
        step = self._step[live, None, :3]
        self._leaps[live] = to_middle + leaps * step
        by_leap = chosen >= len(_OFFSETS)
        on_rim = gains & ~by_leap & (chosen != _MIDDLE)
        # The parabola along all three axes has its minimum within the grid but not in its middle.
        in_all_numbers = leaps[:, -1]
        smooth = np.all(np.abs(in_all_numbers) < 1.0, axis=1) & np.any(in_all_numbers, axis=1)
        smooth |= better & by_leap
        self._scale_steps(live, on_rim, smooth)

    def _scale_steps(self, live: Any, on_rim: Any, smooth: Any) -> None:
        """Increase steps where the best neighbour is on the rim of a grid, and set them to 0 for hopeless circles.

        ``live`` are the indices of unfinished circles, for which ``on_rim`` and ``smooth`` (described by a parabola)
        are masks.
        """
        shrink = np.where(smooth, _SHRINK_SMOOTH, _SHRINK)
        scale = np.where(on_rim, _GROWTH, shrink)
        step = self._step[live] * scale[:, None]
        greatest = self._first_step[live]
        self._step[live] = np.minimum(step, greatest)
        least_of_all = self.best.min()
        size = max(abs(least_of_all), 0.1)
        limit = least_of_all + _HOPELESS * size
        hopeless = self.best > limit
        self._step[hopeless] = 0.0


def tied(values: Floats) -> Floats:
    """Return the greatest values that count as equal to the given values, which are larger by 1e-10 of their size."""
    return values + _TIE * np.abs(values)


def sorted_indices(values: Floats) -> Any:
    """Return indices that sort values; ties keep their order and NaN is last."""
    order = np.argsort(values, kind="stable")
    ordered = values[order]
    is_greater = ordered[1:] > tied(ordered[:-1])
    group = np.append(0, np.cumsum(is_greater))
    return order[np.lexsort((order, group))]


def _leaps(values: Floats) -> Floats:
    """Return steps from the middle of grids to the minima of parabolas, (n, 7, 3), one for each subset of the axes.

    ``values`` are those at the points of the grids, (n, 27); a step is in units of the grid.

    A step x solves H x = -g, g and H the gradient and the curvature along these axes. It stays 0 along the others:
    factors have kinks where an end passes a vertex of the ground, and no values beyond limits.
    """
    gradient, curvature = _derivatives(values.reshape(-1, 3, 3, 3))
    identity = np.eye(3, dtype=bool)
    of_row = _SUBSETS[:, :, None]
    of_column = _SUBSETS[:, None, :]
    both = of_row & of_column
    system = np.where(both, curvature[:, None], identity)
    right = np.where(_SUBSETS, -gradient[:, None], 0.0)
    is_finite = np.all(np.isfinite(system), axis=(2, 3))  # then the gradient is, too
    system = np.where(is_finite[..., None, None], system, identity)
    eigenvalues = np.linalg.eigvalsh(system)
    convex = is_finite & np.all(eigenvalues > 0.0, axis=2)
    system = np.where(convex[..., None, None], system, identity)
    right = np.where(convex[..., None], right, 0.0)
    leaps = np.linalg.solve(system, right[..., None])
    short = np.clip(leaps[..., 0], -2.0, 2.0)
    # Rounded, so that slopes that differ by rounding have the same circle.
    return np.round(short, 2)


def _derivatives(grid: Floats) -> ArrayPair:
    """Return first and second derivatives, (n, 3) and (n, 3, 3), in the middle of grids (n, 3, 3, 3) of unit steps."""
    gradient = np.empty((len(grid), 3))
    curvature = np.empty((len(grid), 3, 3))
    with np.errstate(invalid="ignore"):
        for i in range(3):
            along = np.moveaxis(grid, i + 1, -1)
            behind, here, ahead = along[:, 1, 1].T
            gradient[:, i] = (ahead - behind) / 2
            curvature[:, i, i] = ahead - 2 * here + behind
            for j in range(i):
                plane = np.moveaxis(grid, (i + 1, j + 1), (-2, -1))[:, 1]
                equal_signs = plane[:, 2, 2] + plane[:, 0, 0]
                opposite_signs = plane[:, 2, 0] + plane[:, 0, 2]
                curvature[:, i, j] = curvature[:, j, i] = (equal_signs - opposite_signs) / 4
    return gradient, curvature
