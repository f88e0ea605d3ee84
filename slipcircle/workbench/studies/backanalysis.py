"""Back-analysis: values of friction or other parameters that explain an observed motion.

With one parameter and one observation, all roots in the range are found. Otherwise several observations are fitted by
least squares, from starts all over the ranges. All candidates are solved in vectorised calls.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from slipcircle.base.arrays import EPS
from slipcircle.base.kinds import Floats, Names, NumberDict, Pair, TextDict, Texts, Values
from slipcircle.core import Motion, Scene, checked_scene, solve
from slipcircle.derivatives import free_parameters, neighbour_derivatives, with_parameters
from slipcircle.workbench.common.quantities import OBSERVABLE, Interval, Observed, observable
from slipcircle.workbench.files.loaded import stability_of, warnings_of
from slipcircle.workbench.studies.fits import fits
from slipcircle.workbench.studies.fitwarnings import fit_warnings, range_warnings
from slipcircle.workbench.studies.problem import SearchProblem, observations, search_problem
from slipcircle.workbench.studies.roots import extreme, limit_value, solve_exact
from slipcircle.workbench.studies.sampling import sobol

ROOT = "all roots in the range"
FITTED = "least squares"
AT_LIMIT = "bisection to the limit"
_STARTS = 512  # starting points for each field; the best are refined
_MET = 1e-12  # sum of squares below which the fit is exact
_NOISE = 1e-7  # relative, of derivatives
_FAR = 6.0  # standard errors; largest misfit of as many observations as fields, which an exact fit should meet


class Unattainable(ValueError):
    """Error raised if no value of the field gives the observation.

    Attributes
    ----------
    attainable : dict
        Lowest and highest value of the observed output, each with the value of the field; empty for several fields.
    """

    def __init__(self, message: str, attainable: dict[str, tuple[Pair, Pair]]) -> None:
        super().__init__(message)
        self.attainable = attainable


@dataclass(frozen=True)
class Solution:
    """Values of the fields that explain the observations, with their errors.

    Attributes
    ----------
    values : dict of float
        Values by field, each in its own unit.
    motion : Motion
        The motion with these values.
    residuals : dict of float
        Computed less observed, by observation.
    covariance : ndarray or None
        Covariance of the fields in their order, (fields, fields), to first order: from the standard errors of the
        observations, or otherwise from the misfit; None if neither is known.
    error_estimate : float
        Relative numerical error of the values, from the error estimate of the motion.
    chi_square : float
        Sum of the squared residuals over their standard errors (over the observed values if the errors are unknown).
    """

    values: NumberDict
    motion: Motion
    residuals: NumberDict
    covariance: Floats | None
    error_estimate: float
    chi_square: float

    @property
    def value(self) -> float:
        """Value of the first field."""
        return next(iter(self.values.values()))

    @property
    def standard_errors(self) -> NumberDict | None:
        """Standard errors of the values, by field; None without a covariance."""
        if self.covariance is None:
            return None
        return dict(zip(self.values, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    @property
    def standard_error(self) -> float | None:
        """Standard error of the value of the first field; None without a covariance."""
        return None if self.covariance is None else math.sqrt(self.covariance[0, 0])

    @property
    def correlation(self) -> Floats | None:
        """Correlation matrix of the fields, (fields, fields); None without a covariance."""
        if self.covariance is None:
            return None
        errors = np.sqrt(np.diag(self.covariance))
        return self.covariance / np.outer(errors, errors)


@dataclass(frozen=True)
class BackAnalysis:
    """Result of a back-analysis.

    Attributes
    ----------
    units : dict of str
        Unit of each field, as in its key in a scene file.
    observed : dict
        Value and standard error (None if not given) of each observation; for an interval, its middle.
    intervals : dict of Interval
        Observations given as intervals.
    solutions : tuple of Solution
        Ordered by the number of swings, or, for a fit, the best one first.
    method : str
    warnings : tuple of str
        Warnings about the results.
    """

    units: TextDict
    observed: dict[str, tuple[float, float | None]]
    solutions: tuple[Solution, ...]
    method: str
    warnings: Names
    intervals: Mapping[str, Interval]

    @property
    def value(self) -> float:
        """Value of the first solution and field."""
        return self.solutions[0].value

    @property
    def motion(self) -> Motion:
        """Motion of the first solution."""
        return self.solutions[0].motion

    @property
    def standard_error(self) -> float | None:
        """Standard error of the first field in the first solution."""
        return self.solutions[0].standard_error

    @property
    def degrees_of_freedom(self) -> int:
        """Number of observations minus number of fields."""
        return len(self.observed) - len(self.units)


def backanalyse(
    scene: Scene,
    *,
    run_out: Observed | None = None,
    end_displacement: Observed | None = None,
    peak_velocity: Observed | None = None,
    duration: Observed | None = None,
    toe_rise: Observed | None = None,
    toe_x: Observed | None = None,
    crest_drop: Observed | None = None,
    centroid_travel: Observed | None = None,
    factor_of_safety: Observed | None = None,
    field: str | Sequence[str] | None = None,
    bounds: Pair | Mapping[str, Pair] | None = None,
) -> BackAnalysis:
    """Find the values of one or several parameters (fields) with which the scene moves as observed.

    Parameters
    ----------
    scene : Scene
        Scene; its own values of the fields are ignored.
    run_out, end_displacement, peak_velocity, duration, toe_rise : float, tuple of float or Interval, optional
        Observed value, value and standard error, or `Interval`; m, m (place of rest), m/s, s, m; signs as in `Motion`.
    toe_x, crest_drop, centroid_travel, factor_of_safety : float, tuple of float or Interval, optional
        Observed values as above, in m; the factor of safety by the starting method. An `Interval` with an infinite end
        is a limit, which one field alone can meet.
        By default ``scene.observed``. One observation is met exactly by one field, several by least squares.
    field : str or sequence of str, optional
        Parameters by their keys in a scene file, ``friction.angle_deg`` (by default, if the law has one angle),
        ``cohesion.cohesion_kPa``, whether or not the scene sets them; or by their names, ``friction``, in SI units; or
        the name of an effect with a single parameter. ``arc.dip_deg`` or ``dip`` turns both ends of the arc;
        coordinates of a section are ``circle.centre_m.x``, ``ground.points_m.3.y`` or ``water.level_m.0.y``, points
        counted from 0. Several fields need at least as many observations.
    bounds : tuple of float, or mapping from field to tuple of float, optional
        Range to search, in the unit of the field; by default a wide one.

    Raises
    ------
    Unattainable
        If no value in the range explains the observation; the message names the attainable range.
    ValueError
        For invalid arguments, and if the observations cannot distinguish the fields.

    Notes
    -----
    The run-out and the peak velocity decrease with friction. With low friction the mass swings, so that a place of rest
    has several solutions; motions that turn back more than 12 times are not considered. With several fields, all minima
    that fit about as well as the best one are returned.

    Examples
    --------
    >>> from slipcircle import backanalyse, load
    >>> round(backanalyse(load("vaiont"), run_out=400.0).value, 4)
    15.2147
    """
    every = locals()
    arguments = {name: every[name] for name in OBSERVABLE if every[name] is not None}
    checked_scene(scene, "backanalyse")
    observed, intervals = observations(arguments or scene.observed)
    return _analysed(search_problem(scene, field, bounds, observed, intervals), intervals)


def _analysed(problem: SearchProblem, intervals: Mapping[str, Interval]) -> BackAnalysis:
    """Return the back-analysis of a problem; ``intervals`` are its observations given as intervals."""
    observed = problem.observed
    units = {f.key: f.written for f in problem.fields}
    is_exact = len(problem.fields) == len(observed) == 1
    solutions, warnings = _exact(problem) if is_exact else _fitted(problem)
    method = AT_LIMIT if problem.limit else ROOT if is_exact else FITTED
    stability = stability_of(problem.scene)
    if "factor_of_safety" in observed and stability and stability.method:
        warnings.append("the circle is critical for the strengths as entered; search again with the fitted values")
    warnings += warnings_of(solutions[0].motion)
    return BackAnalysis(units, dict(observed), tuple(solutions), method, tuple(warnings), intervals)


def _exact(problem: SearchProblem) -> tuple[list[Solution], Texts]:
    """Return all solutions for one field and one observation, the fewest swings first, and warnings."""
    values = solve_exact(problem) if problem.limit is None else limit_value(problem)
    solutions = [_solution(problem, [value]) for value in values]
    if not solutions:
        raise _unattainable(problem)
    solutions.sort(key=lambda s: (len(s.motion.phases), -s.value))
    return solutions, range_warnings(problem, solutions[0])


def _unattainable(problem: SearchProblem) -> ValueError:
    """Return the error for an observation outside the attainable range, with the range and its values."""
    (field,) = problem.fields
    (name,) = problem.observed
    low, high = (extreme(problem, sign) for sign in (-1.0, 1.0))
    if math.isnan(low):
        return Unattainable(f"{field.key}: no value within the bounds makes this scene move and come to rest", {})
    scenes = (with_parameters(problem.scene, {field.name: field.to_si(place)}) for place in (low, high))
    outcomes = [float(observable(solve(scene), name)) for scene in scenes]
    least, greatest = outcomes
    unit = OBSERVABLE[name].unit
    from_least = f"{least:.6g} {unit} (at {field.key} = {low:.6g})"
    to_greatest = f"{greatest:.6g} {unit} (at {field.key} = {high:.6g})"
    attainable = f"{from_least} to {to_greatest}"
    if greatest - least <= 1e-9 * abs(greatest):
        attainable = f"only {least:.6g} {unit} for all values"
    target = float(problem.targets[0] + problem.origins[0])
    if problem.limit is None and max(abs(outcome - target) for outcome in outcomes) <= 1e-9 * abs(target):
        return _without_effect([field.key], problem)
    sentence = f"{_wanted(problem, target, outcomes)} value of {field.key} gives it; attainable: {attainable}"
    return Unattainable(sentence, {name: ((least, low), (greatest, high))})


def _wanted(problem: SearchProblem, target: float, outcomes: Sequence[float]) -> str:
    """Return the start of the message: the observation, and whether no value or every value of the field gives it.

    ``target`` is the observed value; ``outcomes`` are computed at both ends of the attainable range, in the same unit.
    """
    (name,) = problem.observed
    unit = OBSERVABLE[name].unit
    limit = problem.limit
    if limit is None:
        return f"{name} = {target:.10g} {unit}: no"
    inside = [limit.low <= outcome <= limit.high for outcome in outcomes]
    return f"{name} {limit} {unit}: {'every' if all(inside) else 'no'}"


def _fitted(problem: SearchProblem) -> tuple[list[Solution], Texts]:
    """Return all solutions that fit about as well as the best one, the best first, and warnings."""
    names = ", ".join(f.key for f in problem.fields)
    count = len(problem.fields)
    minima = fits(problem, sobol(0, (5,), 0, _STARTS * count, count))
    if not minima:
        raise Unattainable(f"{names}: no values within the bounds make this scene move and come to rest", {})
    solutions = []
    refusals = []
    for fit in minima:
        try:
            solutions.append(_solution(problem, problem.values_at(fit.shares[:, None])[:, 0].tolist()))
        except ValueError as error:  # the fields cannot be distinguished here, but perhaps elsewhere
            refusals.append(error)
    if not solutions:
        raise refusals[0]
    # The best fit first; among exact fits, the fewest swings first.
    solutions.sort(key=lambda s: (max(s.chi_square, _MET), len(s.motion.phases)))
    best = solutions[0].chi_square
    _refuse_misfit(problem, solutions[0])
    limit = best + 9.0 if problem.is_weighted else 4 * best + _MET  # three standard errors, or twice the misfit
    warnings = fit_warnings(problem, solutions[0])
    if not minima[0].is_settled:
        warnings.append("the motion changes its character at the best values: their covariance is not reliable")
    return [s for s in solutions if s.chi_square <= limit], warnings


def _refuse_misfit(problem: SearchProblem, first: Solution) -> None:
    """Raise `Unattainable` if the best fit misses observations that could all be met, or lacks a covariance."""
    best = first.chi_square
    is_exact = problem.degrees_of_freedom == 0
    is_far = problem.is_weighted and is_exact and best > _FAR**2
    if not is_far and (first.covariance is not None or best <= _MET):
        return
    outcomes = zip(problem.observed, problem.seen(first.motion).tolist(), strict=True)
    nearest = ", ".join(f"{n} = {value:.6g} {OBSERVABLE[n].unit}" for n, value in outcomes)
    at = ", ".join(f"{n} = {v:.6g}" for n, v in first.values.items())
    how = f"{math.sqrt(best):.3g} standard errors off" if is_far else "give standard errors to fit it"
    keys = ", ".join(first.values)
    observed = " and ".join(problem.observed)
    sentence = f"no values of {keys} give {observed} as observed; the nearest is {nearest} at {at}; {how}"
    raise Unattainable(sentence, {})


def _solution(problem: SearchProblem, values: Sequence[float]) -> Solution:
    """Return the solution with these values of the fields; ValueError if the observations do not determine them."""
    by_key = {field.key: float(value) for field, value in zip(problem.fields, values, strict=True)}
    si = {field.name: float(field.to_si(by_key[field.key])) for field in problem.fields}
    motion = solve(with_parameters(problem.scene, si))
    slopes = _slopes(problem, motion, si)
    outcomes = problem.seen(motion)
    residuals = outcomes - problem.targets
    chi_square = float(np.sum((residuals / problem.scales) ** 2))
    covariance = None
    error = math.inf if problem.limit is None else EPS
    sizes = np.array([abs(v) or 1.0 for v in values])
    jacobian = _jacobian(problem, slopes, values) * sizes  # by relative changes
    if np.all(np.isfinite(jacobian)):
        if problem.limit is None:
            _refuse_indistinct(problem, jacobian)
        inverse = np.linalg.pinv(jacobian)
        errors = [EPS if name == "factor_of_safety" else motion.error_estimate for name in problem.observed]
        error = max(float(np.max(np.abs(inverse) @ (errors * np.abs(outcomes) / problem.scales))), EPS)
        covariance = _covariance(problem, inverse * sizes[:, None], chi_square)
    missed = dict(zip(problem.observed, residuals.tolist(), strict=True))
    return Solution(by_key, motion, missed, covariance, error, chi_square)


def _slopes(problem: SearchProblem, motion: Motion, si: Values) -> Floats:
    """Return derivatives of the observed outcomes with respect to the fields in SI units, (observations, fields).

    ``si`` are the values by name. The derivatives are NaN if a limit keeps the mass at rest.
    """
    if problem.limit is not None and not motion.moves:
        return np.full((len(problem.observed), len(si)), np.nan)
    scene = motion.plan.scene
    return np.asarray(neighbour_derivatives(scene, problem.seen, free_parameters(scene, si)).values)


def _jacobian(problem: SearchProblem, slopes: Floats, values: Sequence[float]) -> Floats:
    """Return ``slopes``, (observations, fields), as derivatives of scaled residuals by fields in their units."""
    with_values = zip(problem.fields, values, strict=True)
    return slopes / problem.scales[:, None] * np.array([field.slope(value) for field, value in with_values])


def _covariance(problem: SearchProblem, inverse: Floats, chi_square: float) -> Floats | None:
    """Return the covariance of the fields from standard errors or the misfit; None if neither is known.

    ``inverse`` is the pseudo-inverse of the derivatives of the scaled residuals, (fields, observations).
    """
    if problem.is_weighted:
        return inverse @ inverse.T
    if problem.degrees_of_freedom:
        return inverse @ inverse.T * (chi_square / problem.degrees_of_freedom)
    return None


def _without_effect(keys: Sequence[str], problem: SearchProblem) -> ValueError:
    """Return the error for fields, given by their keys, that do not change the observations."""
    names = ", ".join(problem.observed)
    return ValueError(f"backanalyse: {', '.join(keys)}: does not affect {names}, and cannot be determined from it")


def _refuse_indistinct(problem: SearchProblem, jacobian: Floats) -> None:
    """Raise ValueError if the residuals do not change with a field, or with a combination of fields.

    ``jacobian`` has the derivatives by relative changes of the fields, (observations, fields).
    """
    names = ", ".join(problem.observed)
    keys = [f.key for f in problem.fields]
    sizes = np.linalg.norm(jacobian, axis=0)
    least = _NOISE * np.max(sizes)
    if idle := [key for key, size in zip(keys, sizes, strict=True) if not size > least]:
        raise _without_effect(idle, problem)
    _, singular, directions = np.linalg.svd(jacobian / sizes)
    if singular[-1] > _NOISE * singular[0]:
        return
    change = directions[-1] / sizes
    per_cent = 100 * change / np.max(np.abs(change))
    by_field = [f"{key} by {c:+.3g} %" for key, c in zip(keys, per_cent, strict=True)]
    changes = " and ".join(by_field)
    raise ValueError(f"backanalyse: changing {changes} does not change {names}, which cannot distinguish them")
