"""Back-analysis: which friction, or which values of other numbers, explain the motion that was observed.

One field is followed over its range, so that every value with what was observed is found. Several observations are met
in the sense of least squares, from starts all over the fields' ranges. All candidates are solved at once.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from slipcircle.base.checks import EPS
from slipcircle.base.kinds import Floats, Names, Pair, TextDict, Values
from slipcircle.core import Motion, Scene, checked, solve
from slipcircle.derivatives import free_parameters, neighbour_derivatives, with_parameters
from slipcircle.workbench.common.quantities import OBSERVABLE, Interval, Observed, observable
from slipcircle.workbench.files.loaded import stability_of
from slipcircle.workbench.studies.fits import fits
from slipcircle.workbench.studies.fitwarnings import fit_warnings, range_warnings
from slipcircle.workbench.studies.problem import SearchProblem, observations, search_problem
from slipcircle.workbench.studies.roots import extreme, limit_value, solve_exact
from slipcircle.workbench.studies.sampling import sobol

ROOT = "all roots in the range"
FITTED = "least squares"
AT_LIMIT = "bisection to the limit"
_STARTS = 512  # points a field, of which the best are followed
_MET = 1e-12  # sum of squares below which all is met exactly
_NOISE = 1e-7  # relative, of derivatives
_FAR = 6.0  # standard errors that the nearest fit may miss by: as many could be met exactly


class Unattainable(ValueError):
    """No value of the field gives the observation.

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
    """Values of the fields that explain what was observed.

    Attributes
    ----------
    values : dict of float
        Of the fields, each in its own unit.
    motion : Motion
        The motion with these values.
    residuals : dict of float
        Computed less observed, by observation.
    covariance : ndarray or None
        Of the fields in their order, (fields, fields), to first order: from the observations' standard errors, or else
        from the misfit; None where there is neither.
    error_estimate : float
        Of the values, relative: numerical, by the motion's own estimate.
    chi_square : float
        Sum of the squared residuals over their standard errors (over the observed values, where those are unknown).
    """

    values: dict[str, float]
    motion: Motion
    residuals: dict[str, float]
    covariance: Floats | None
    error_estimate: float
    chi_square: float

    @property
    def value(self) -> float:
        """Of the first field."""
        return next(iter(self.values.values()))

    @property
    def standard_errors(self) -> dict[str, float] | None:
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
        """Correlation of the fields, (fields, fields)."""
        if self.covariance is None:
            return None
        errors = np.sqrt(np.diag(self.covariance))
        return self.covariance / np.outer(errors, errors)


@dataclass(frozen=True)
class BackAnalysis:
    """Numbers of a scene that explain observations.

    Attributes
    ----------
    units : dict of str
        Unit of each field, that of its key in a scene file.
    observed : dict
        Value and standard error (None if not given) of each observation; of an interval its middle.
    intervals : dict of Interval
        The observations that are intervals.
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
        """Of the first solution."""
        return self.solutions[0].motion

    @property
    def standard_error(self) -> float | None:
        """Standard error of the first field in the first solution."""
        return self.solutions[0].standard_error

    @property
    def degrees_of_freedom(self) -> int:
        """Observations less fields."""
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
    """Find the values of one or several fields with which the scene moves as observed.

    Parameters
    ----------
    scene : Scene
        Its values of the fields are ignored.
    run_out, end_displacement, peak_velocity, duration, toe_rise : float, tuple of float or Interval, optional
        Observed value, value and standard error, or `Interval`; m, m (place of rest), m/s, s, m; signs as in `Motion`.
    toe_x, crest_drop, centroid_travel, factor_of_safety : float, tuple of float or Interval, optional
        The same, m, and by the starting method. An `Interval` with an infinite end is a limit, for one field alone.
        By default ``scene.observed``. A single one is met exactly by one field, several by least squares.
    field : str or sequence of str, optional
        Numbers by their keys in a scene file, ``friction.angle_deg`` (by default, where the law has one angle),
        ``cohesion.cohesion_kPa``, whether or not the scene has a value of them; or in SI units by their names,
        ``friction``; or the name of an effect with a single number. ``arc.dip_deg`` or ``dip`` turns both ends of the
        arc; coordinates of a section are ``circle.centre_m.x``, ``ground.points_m.3.y`` or ``water.level_m.0.y``,
        points by their number from 0. Several fields need at least as many observations.
    bounds : tuple of float, or mapping of such by field, optional
        Range to search, in the unit of the field; by default a wide one.

    Raises
    ------
    Unattainable
        If no value in the range explains the observation; names the attainable range and its values.
    ValueError
        For mistakes in the arguments, and if the observations cannot distinguish the fields.

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
    checked(scene, "backanalyse")
    every = [run_out, end_displacement, peak_velocity, duration, toe_rise]
    every += [toe_x, crest_drop, centroid_travel, factor_of_safety]
    asked = {name: seen for name, seen in zip(OBSERVABLE, every, strict=True) if seen is not None}
    observed, intervals = observations(asked or scene.observed)
    return _analysed(search_problem(scene, field, bounds, observed, intervals), intervals)


def _analysed(problem: SearchProblem, intervals: Mapping[str, Interval]) -> BackAnalysis:
    """Return the values of the fields of a problem that explain its observations."""
    observed = problem.observed
    units = {f.key: f.unit for f in problem.fields}
    is_exact = len(problem.fields) == len(observed) == 1
    solutions, warnings = _exact(problem) if is_exact else _fitted(problem)
    method = AT_LIMIT if problem.limit else ROOT if is_exact else FITTED
    stability = stability_of(problem.scene)
    if "factor_of_safety" in observed and stability and stability.method:
        warnings.append("the circle is the critical one of the strengths as entered; search it again with the result")
    return BackAnalysis(units, dict(observed), tuple(solutions), method, tuple(warnings), intervals)


def _exact(problem: SearchProblem) -> tuple[list[Solution], list[str]]:
    """All values of the one field with the one observation, the fewest swings first, and what to know of them."""
    if problem.limit is None:
        values = solve_exact(problem)
    else:
        values = limit_value(problem)
    solutions = [_solution(problem, [value]) for value in values]
    if not solutions:
        raise _unattainable(problem)
    solutions.sort(key=lambda s: (len(s.motion.phases), -s.value))
    return solutions, range_warnings(problem, solutions[0])


def _unattainable(problem: SearchProblem) -> ValueError:
    """Return the error of an observation that no value of the one field gives: the attainable range, and its ends."""
    (field,) = problem.fields
    (name,) = problem.observed
    low, high = (extreme(problem, sign) for sign in (-1.0, 1.0))
    if math.isnan(low):
        return Unattainable(f"{field.key}: for no value within the bounds does this scene move and come to rest", {})
    outcomes = []
    for place in (low, high):
        motion = solve(with_parameters(problem.scene, {field.name: field.to_si(place)}))
        outcomes.append(float(observable(motion, name)))
    least, greatest = outcomes
    unit = OBSERVABLE[name].unit
    from_least = f"{least:.6g} {unit} (at {field.key} = {low:.6g})"
    to_greatest = f"{greatest:.6g} {unit} (at {field.key} = {high:.6g})"
    attainable = f"{from_least} to {to_greatest}"
    if greatest - least <= 1e-9 * abs(greatest):
        attainable = f"only {least:.6g} {unit}, whatever it is"
    target = float(problem.targets[0] + problem.origins[0])
    if problem.limit is None and max(abs(outcome - target) for outcome in outcomes) <= 1e-9 * abs(target):
        return _without_effect([field.key], problem)
    sentence = f"{_wanted(problem, target, outcomes)} {field.key} gives it; attainable: {attainable}"
    return Unattainable(sentence, {name: ((least, low), (greatest, high))})


def _wanted(problem: SearchProblem, target: float, outcomes: Sequence[float]) -> str:
    """Return what was to be reached, and whether no value or every value reaches it."""
    (name,) = problem.observed
    unit = OBSERVABLE[name].unit
    limit = problem.limit
    if limit is None:
        return f"{name} = {target:.10g} {unit}: no"
    inside = [limit.low <= outcome <= limit.high for outcome in outcomes]
    return f"{name} {limit} {unit}: {'every' if all(inside) else 'no'}"


def _fitted(problem: SearchProblem) -> tuple[list[Solution], list[str]]:
    """All values of the fields that fit about as well as the best ones, and what to know of them."""
    names, count = ", ".join(f.key for f in problem.fields), len(problem.fields)
    minima = fits(problem, sobol(0, (5,), 0, _STARTS * count, count))
    if not minima:
        raise Unattainable(f"{names}: for no values within the bounds does this scene move and come to rest", {})
    solutions, refusals = [], list[ValueError]()
    for fit in minima:
        try:
            solutions.append(_solution(problem, problem.values_at(fit.shares[:, None])[:, 0].tolist()))
        except ValueError as error:  # here the fields cannot be told apart, though they may elsewhere
            refusals.append(error)
    if not solutions:
        raise refusals[0]
    # The best one first; the fewest swings, where all is met exactly.
    solutions.sort(key=lambda s: (max(s.chi_square, _MET), len(s.motion.phases)))
    best = solutions[0].chi_square
    _refuse_misfit(problem, solutions[0])
    limit = best + 9.0 if problem.is_weighted else 4 * best + _MET  # three standard errors, or twice the misfit
    warnings = fit_warnings(problem, solutions[0])
    if not minima[0].is_settled:
        warnings.append("the motion changes its character at the best values: their covariance is not reliable")
    return [s for s in solutions if s.chi_square <= limit], warnings


def _refuse_misfit(problem: SearchProblem, first: Solution) -> None:
    """Refuse a best fit that misses observations that could all be met, or that is without a covariance."""
    best = first.chi_square
    is_exact = problem.degrees_of_freedom == 0
    is_far = problem.is_weighted and is_exact and best > _FAR**2
    if not is_far and (first.covariance is not None or best <= _MET):
        return
    outcomes = zip(problem.observed, problem.seen(first.motion).tolist(), strict=True)
    nearest = ", ".join(f"{n} = {value:.6g} {OBSERVABLE[n].unit}" for n, value in outcomes)
    at = ", ".join(f"{n} = {v:.6g}" for n, v in first.values.items())
    how = f"that is {math.sqrt(best):.3g} standard errors off" if is_far else "with standard errors that is fitted"
    keys = ", ".join(first.values)
    observed = " and ".join(problem.observed)
    sentence = f"no values of {keys} give {observed} as observed; the nearest is {nearest} at {at}; {how}"
    raise Unattainable(sentence, {})


def _solution(problem: SearchProblem, values: Sequence[float]) -> Solution:
    """A solution with these values: the observations have to tell the fields apart."""
    by_key = {field.key: float(value) for field, value in zip(problem.fields, values, strict=True)}
    si = {field.name: float(field.to_si(value)) for field, value in zip(problem.fields, values, strict=True)}
    motion = solve(with_parameters(problem.scene, si))
    slopes = _slopes(problem, motion, si)
    outcomes = problem.seen(motion)
    residuals = outcomes - problem.targets
    scaled = residuals / problem.scales
    chi_square = float(np.sum(scaled**2))
    covariance = None
    error = math.inf if problem.limit is None else EPS
    sizes = np.array([abs(v) or 1.0 for v in values])
    jacobian = _jacobian(problem, slopes, values) * sizes  # by relative changes
    if np.all(np.isfinite(jacobian)):
        if problem.limit is None:
            _refuse_indistinct(problem, jacobian)
        inverse = np.linalg.pinv(jacobian)
        relative = np.abs(inverse) @ _numerical_errors(problem, motion, outcomes)
        error = max(float(np.max(relative)), EPS)
        by_units = inverse * sizes[:, None]
        covariance = _covariance(problem, by_units, chi_square)
    missed = dict(zip(problem.observed, residuals.tolist(), strict=True))
    return Solution(by_key, motion, missed, covariance, error, chi_square)


def _slopes(problem: SearchProblem, motion: Motion, si: Values) -> Floats:
    """Return the derivatives of what is observed by the fields; unknown of a mass that only a limit lets stand."""
    if problem.limit is not None and not motion.moves:
        return np.full((len(problem.observed), len(si)), np.nan)
    scene = motion.plan.scene
    return np.asarray(neighbour_derivatives(scene, problem.seen, free_parameters(scene, si)).values)


def _numerical_errors(problem: SearchProblem, motion: Motion, outcomes: Floats) -> Floats:
    """Return the scaled numerical errors of outcomes; a factor of safety does not need the motion."""
    errors = [EPS if name == "factor_of_safety" else motion.error_estimate for name in problem.observed]
    return errors * np.abs(outcomes) / problem.scales


def _jacobian(problem: SearchProblem, slopes: Floats, values: Sequence[float]) -> Floats:
    """Derivatives of the scaled residuals by the fields in their units, from those of what is observed in SI units."""
    with_values = zip(problem.fields, values, strict=True)
    per_key = np.array([field.slope(value) for field, value in with_values])
    scaled = slopes / problem.scales[:, None]
    return scaled * per_key


def _covariance(problem: SearchProblem, inverse: Floats, chi_square: float) -> Floats | None:
    """Of the fields: from the standard errors, or from the misfit where there are more observations than fields."""
    if problem.is_weighted:
        return inverse @ inverse.T
    if problem.degrees_of_freedom:
        return inverse @ inverse.T * (chi_square / problem.degrees_of_freedom)
    return None


def _without_effect(keys: Sequence[str], problem: SearchProblem) -> ValueError:
    """Return the error of fields that do not change the observations."""
    names = ", ".join(problem.observed)
    return ValueError(f"backanalyse: {', '.join(keys)}: does not affect {names}, and cannot be determined from it")


def _refuse_indistinct(problem: SearchProblem, jacobian: Floats) -> None:
    """Refuse residuals that do not change with one of the fields, or with several of them together."""
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
    greatest = np.max(np.abs(change))
    per_cent = 100 * change / greatest
    by_field = [f"{key} by {c:+.3g} %" for key, c in zip(keys, per_cent, strict=True)]
    changes = " and ".join(by_field)
    raise ValueError(f"backanalyse: changing {changes} changes nothing of {names}: they cannot be distinguished by it")
