"""Critical circles of many similar slopes, from the coarse family of one slope and circles of neighbours."""

from typing import Any

import numpy as np

from slipcircle.base.kinds import ArrayTriple, Floats, Values
from slipcircle.workbench.stability.factors import circle_factors
from slipcircle.workbench.stability.family import COARSE, Search, valleys_of
from slipcircle.workbench.stability.stability import METHODS, Slope

_NEAR = 0.5  # over the least value, as a share of it, circles of the coarse family are kept
_BEST = 100  # of these, the best ones, and so many spread evenly over the others
_OTHERS = 300
_VALLEYS = 4  # that are followed in each slope
_NEIGHBOURS = 3  # slopes whose circles are tried


class SampleSearch:
    """Search on slopes whose lines are equal or close to the lines of one slope.

    Parameters
    ----------
    slope : Slope
        Slope with the mean values.
    method : str
        As of `critical`.
    limits : mapping
        entry, exit and depth, as of `critical`.
    """

    def __init__(self, slope: Slope, method: str, limits: Values) -> None:
        self._method = method
        self._limits = limits
        search = Search(slope, method, **limits)
        q, steps = search.coarse_family()
        kept = _promising(search.evaluate(q, COARSE))
        self._q = q[kept]
        self._steps = steps[kept]
        self._solved: list[ArrayTriple] = []  # place, circle and steps of slopes

    def factors(self, slope: Slope, place: Floats) -> dict[str, float]:
        """Return factors of safety by method on the critical circle of a slope, NaN without a critical circle.

        Slopes are neighbours where the numbers in ``place`` are close; these should have about the same spread.
        """

        def distance(solved: ArrayTriple) -> float:
            return float(np.sum((solved[0] - place) ** 2))

        search = Search(slope, self._method, **self._limits)
        nearest = sorted(self._solved, key=distance)[:_NEIGHBOURS]
        q = self._q
        steps = self._steps
        for _, circle, circle_steps in nearest:
            q = np.concatenate([q, circle])
            steps = np.concatenate([steps, circle_steps])
        values = search.evaluate(q, COARSE)
        if not np.any(np.isfinite(values)):
            return dict.fromkeys(METHODS, np.nan)
        followed = valleys_of(q, values, steps, _VALLEYS, 1)
        refined, refined_steps = search.refined(q[followed], steps[followed])
        best = refined[:1]
        self._solved.append((place, best, refined_steps[:1]))
        factors = circle_factors(search.arrays, *search.circles(best))
        return {method: float(factors[method][0]) for method in METHODS}


def _promising(values: Floats) -> Any:
    """Return the numbers of the best values, and of some values not far above."""
    order = np.argsort(values, kind="stable")
    least = values[order[0]]
    near = order[values[order] <= least + _NEAR * max(abs(least), 0.1)]
    others = near[_BEST:]
    return np.concatenate([near[:_BEST], others[:: max(len(others) // _OTHERS, 1)]])
