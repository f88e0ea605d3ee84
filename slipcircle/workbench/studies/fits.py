"""Least-squares fit of several parameters, from the best of many starting points."""

from typing import Any, NamedTuple

import numpy as np

from slipcircle.base.kinds import Floats
from slipcircle.base.optional import optional
from slipcircle.base.progress import tracked
from slipcircle.workbench.studies.problem import SearchProblem

_STARTS = 12  # of fits
_APART = 0.1  # shares of the ranges between starts
_EVALUATIONS = 60  # of a fit
_FLAT = 1e-3  # cosine between residuals and their derivatives, below which the fit has converged
_MET = 1e-7  # norm of the residuals below which the fit is exact


class Fit(NamedTuple):
    """A minimum: shares of the ranges, (fields,), sum of squared scaled residuals, and whether the fit converged."""

    shares: Floats
    chi_square: float
    is_settled: bool


def fits(problem: SearchProblem, shares: Floats) -> list[Fit]:
    """Return all distinct minima reached from the best of the points ``shares``, (fields, count), the best first."""
    results = [
        _minimum(problem, start) for start in tracked(_starts(problem, shares), "starts followed to the best fit")
    ]
    same_below = 1.0 if problem.is_weighted else 1e-3  # change of the residuals, in standard errors or shares
    different: list[Fit] = []
    for result in sorted(results, key=lambda result: result.cost):
        # Whether residuals vanish or are normal to the derivatives by all fields inside their ranges.
        left = np.linalg.norm(result.fun)
        is_flat = np.abs(result.grad) <= _FLAT * (np.linalg.norm(result.jac, axis=0) * left)
        fit = Fit(result.x, 2.0 * float(result.cost), bool(np.all(is_flat | (result.active_mask != 0)) or left < _MET))
        steps = [fit.shares - other.shares for other in different]
        if all(np.max(abs(x)) >= 1e-5 and np.max(abs(result.jac @ x)) >= same_below for x in steps):
            different.append(fit)
    return [fit for fit in different if fit.is_settled] or different


def _starts(problem: SearchProblem, shares: Floats) -> list[Floats]:
    """Return the best of the points ``shares``, (fields, count), that lie apart from each other, at most 12."""
    r = problem.residuals(shares)
    chosen: list[Floats] = []
    for k in np.argsort(np.sum(r**2, axis=0)):  # NaN comes last
        point = shares[:, k]
        if len(chosen) == _STARTS or np.isnan(r[0, k]):
            break
        if all(np.max(np.abs(point - other)) > _APART for other in chosen):
            chosen.append(point)
    return chosen


def _minimum(problem: SearchProblem, start: Floats) -> Any:
    """Return SciPy's result of a fit within the ranges; steps to points without motion are shortened.

    ``start`` is a point, as shares of the ranges, (fields,).
    """
    optimize = optional("scipy.optimize", "back-analysis")

    latest: list[Floats] = []  # the Jacobian, computed with the residuals and requested after them

    def residuals(shares: Floats) -> Floats:
        r, jacobian = problem.linearised(shares)
        latest[:] = [jacobian]
        return r

    return optimize.least_squares(
        residuals,
        start,
        lambda _: latest[0],
        (0.0, 1.0),
        method="dogbox",
        x_scale="jac",
        ftol=None,
        xtol=1e-14,
        gtol=None,
        max_nfev=_EVALUATIONS,
    )
