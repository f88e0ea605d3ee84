"""Critical circles of many slopes that differ little from one: by its coarse family and circles of neighbours."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from slipcircle.base.series import Floats
from slipcircle.workbench.stability.factors import METHOD_NAMES, circle_factors
from slipcircle.workbench.stability.family import COARSE_NODES, Search, valleys_of
from slipcircle.workbench.stability.stability import Slope

_NEAR = 0.5  # over the least value, as a share of it, circles of the coarse family are kept
_BEST, _OTHERS = 100, 300  # of these, the best ones, and so many spread evenly over the others
_VALLEYS = 4  # that are followed in each slope
_NEIGHBOURS = 3  # slopes whose circles are tried


class SampleSearch:
    """Searches slopes that have the ground lines of one slope, or nearly.

    Parameters
    ----------
    slope : Slope
        That of the means.
    method : str
        As of `critical`.
    limits : mapping
        entry, exit and depth, as of `critical`.
    """

    def __init__(self, slope: Slope, method: str, limits: Mapping[str, Any]) -> None:
        self._method = method
        self._limits = limits
        search = Search(slope, method, **limits)
        q, steps = search.coarse_family()
        values = search.evaluate(q, COARSE_NODES)
        order = np.argsort(values, kind="stable")
        least = values[order[0]]
        near = order[values[order] <= least + _NEAR * max(abs(least), 0.1)]
        others = near[_BEST:]
        spread = others[:: max(len(others) // _OTHERS, 1)]
        kept = np.concatenate([near[:_BEST], spread])
        self._q = q[kept]
        self._steps = steps[kept]
        self._solved: list[tuple[Floats, Floats, Floats]] = []

    def factors(self, slope: Slope, place: Floats) -> dict[str, float]:
        """Factors of safety by method on the critical circle of a slope; NaN where none is found.

        ``place`` tells which slopes are neighbours: numbers of about the same spread.
        """
        search = Search(slope, self._method, **self._limits)
        nearest = sorted(self._solved, key=lambda solved: float(np.sum((solved[0] - place) ** 2)))[:_NEIGHBOURS]
        q = np.concatenate([self._q, *(circle for _, circle, _ in nearest)])
        steps = np.concatenate([self._steps, *(step for _, _, step in nearest)])
        values = search.evaluate(q, COARSE_NODES)
        if not np.any(np.isfinite(values)):
            return dict.fromkeys(METHOD_NAMES, np.nan)
        followed = valleys_of(q, values, steps, _VALLEYS, 1)
        best, step = search.refined(q[followed], steps[followed])
        self._solved.append((place, best[:1], step[:1]))
        found = circle_factors(search.arrays, *search.circles(best[:1]))
        return {method: float(found[method][0]) for method in METHOD_NAMES}
