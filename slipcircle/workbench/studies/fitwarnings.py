"""Warnings about the results of a back-analysis."""

from typing import Any

from slipcircle.base.kinds import Texts
from slipcircle.base.optional import optional
from slipcircle.workbench.studies.problem import SearchProblem

_UNLIKELY = 1e-3  # probability of so large a misfit, below which a warning is given
_AT_END = 1e-6  # of a range


def range_warnings(problem: SearchProblem, solution: Any) -> Texts:
    """Return a warning for each value of a `Solution` at an end of its searched range."""
    rows = zip(solution.values.items(), problem.ranges, strict=True)
    return [
        f"{name} = {value:.6g} lies at the end of the searched range, {low:.6g} to {high:.6g}: a better value "
        "or another solution may lie beyond, and its standard error is not reliable"
        for (name, value), (low, *_, high) in rows
        if min(value - low, high - value) <= _AT_END * (high - low)
    ]


def fit_warnings(problem: SearchProblem, first: Any) -> Texts:
    """Return warnings about a fit: values at range ends or hardly determined, and a misfit beyond the errors.

    ``first`` is the best `Solution`.
    """
    warnings = range_warnings(problem, first)
    for (name, value), (low, *_, high) in zip(first.values.items(), problem.ranges, strict=True):
        error = (first.standard_errors or {}).get(name, 0.0)
        if error > high - low:
            warnings.append(f"{name} is not determined: many values fit as well as {value:.6g}")
        elif error > abs(value):
            warnings.append(f"{name} = {value:.6g} is poorly determined: its standard error is larger")
    return warnings + _misfit_warnings(problem, first.chi_square)


def _misfit_warnings(problem: SearchProblem, chi_square: float) -> Texts:
    """Return a warning if known standard errors do not explain the misfit."""
    free = problem.degrees_of_freedom
    chance = (
        float(optional("scipy.special", "back-analysis").chdtrc(free, chi_square)) if free else float(chi_square < 1.0)
    )
    if not problem.is_weighted or chance >= _UNLIKELY:
        return []
    reason = f"chance {chance:.1g}" if free else "as many unknowns as observations, so that all could be met"
    return [
        f"the misfit is larger than the standard errors explain: chi-square {chi_square:.4g} with {free} degrees of "
        f"freedom ({reason})"
    ]
