"""Back-analysis: which friction, or which values of other numbers, explain the motion that was observed.

One field is followed over its range, so that every value with what was observed is found. Several observations are met
in the sense of least squares, from starts all over the fields' ranges. All candidates are solved at once.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from slipcircle.base.checks import EPS
from slipcircle.motion.motion import Motion
from slipcircle.motion.quantities import OUTCOMES
from slipcircle.motion.solver import solve
from slipcircle.scene.numbers import Number, number_in
from slipcircle.scene.scene import Scene, checked
from slipcircle.scene.varied import scene_with
from slipcircle.studies import search
from slipcircle.studies.asked import Bounds, Observations, Observed, between, check, observations
from slipcircle.studies.motions import derivatives
from slipcircle.studies.ranges import range_of
from slipcircle.studies.sampling import sobol

Floats = NDArray[np.float64]
ROOT = "all roots in the range"
FITTED = "least squares"
_STARTS = 512  # points a field, of which the best are followed
_MET = 1e-12  # sum of squares below which all is met exactly
_NOISE = 1e-7  # relative, of derivatives
_FAR = 6.0  # standard errors that the nearest fit may miss by: as many could be met exactly
_WORST = 1e-3  # probability of so large a misfit, below which it is told


class Unattainable(ValueError):
    """No value of the field gives what was observed.

    Attributes
    ----------
    attainable : dict
        For each observed output, its lowest and its highest value found, each with the value of the field there; empty
        where several fields were searched.
    """

    def __init__(self, message: str, attainable: dict[str, tuple[tuple[float, float], tuple[float, float]]]) -> None:
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
        """Of the values, by field."""
        if self.covariance is None:
            return None
        return dict(zip(self.values, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    @property
    def standard_error(self) -> float | None:
        """Of the first field."""
        return None if self.covariance is None else math.sqrt(self.covariance[0, 0])

    @property
    def correlation(self) -> Floats | None:
        """Correlation of the fields, (fields, fields)."""
        if self.covariance is None:
            return None
        errors = np.sqrt(np.diag(self.covariance))
        return np.asarray(self.covariance / np.outer(errors, errors))


@dataclass(frozen=True)
class BackAnalysis:
    """What explains an observation.

    Attributes
    ----------
    units : dict of str
        Unit of each field, as its key in a scene file has it.
    observed : dict
        Value and standard error (None if not given) of each observation.
    solutions : tuple of Solution
        All that were found: the fewest swings first, or, for a fit, the best one first.
    method : str
    warnings : tuple of str
        What to know before the values are used.
    """

    units: dict[str, str]
    observed: dict[str, tuple[float, float | None]]
    solutions: tuple[Solution, ...]
    method: str
    warnings: tuple[str, ...] = ()

    @property
    def field(self) -> str:
        """The first field."""
        return next(iter(self.units))

    @property
    def unit(self) -> str:
        """Of the first field."""
        return self.units[self.field]

    @property
    def value(self) -> float:
        """Of the first solution and field."""
        return self.solutions[0].value

    @property
    def motion(self) -> Motion:
        """Of the first solution."""
        return self.solutions[0].motion

    @property
    def standard_error(self) -> float | None:
        """Of the first solution and field."""
        return self.solutions[0].standard_error

    @property
    def degrees_of_freedom(self) -> int:
        """Observations less fields."""
        return len(self.observed) - len(self.units)


def backanalyse(
    scene: Scene,
    *,
    reach: Observed | None = None,
    run_out: Observed | None = None,
    peak_velocity: Observed | None = None,
    duration: Observed | None = None,
    field: str | Sequence[str] = "friction.angle_deg",
    bounds: Bounds | Mapping[str, Bounds] | None = None,
) -> BackAnalysis:
    """Find the values of one field, or of several, with which the scene moves as observed.

    Parameters
    ----------
    scene : Scene
        Its own values of the fields do not count.
    reach, run_out, peak_velocity, duration : float or tuple of float, optional
        Observed value, or value and standard error; m, m, m/s, s; signed as `Motion` gives them. One at least. One
        alone is met exactly by one field, several in the sense of least squares.
    field : str or sequence of str, optional
        Numbers by their keys in a scene file, ``friction.angle_deg``, ``cohesion.cohesion_kPa``, whether the scene has
        a value of them or not; or in SI units by their names, ``friction``; an effect's name where it has one number.
        ``arc.dip_deg`` or ``dip`` turns both ends of the arc; a section's coordinates are ``circle.centre_m.x``,
        ``ground.points_m.3.y`` or ``water.level_m.0.y``, points by their number from 0. Several need
        as many observations at least.
    bounds : tuple of float, or mapping of such by field, optional
        Where to search, in the field's unit; by default a range wide enough for it.

    Returns
    -------
    BackAnalysis

    Raises
    ------
    Unattainable
        If no value in the range explains the observation: says what is attainable, and at which values.
    ValueError
        For mistakes in the arguments, and where the observations cannot tell the fields apart.

    Notes
    -----
    Run-out and peak velocity fall with friction as long as the mass does not turn back: E(x) does, at every x. Weak
    friction lets it swing, and the same run-out then has several solutions; motions that turn back more than 12 times
    are left out. Of several fields all different minima that are found, and fit about as well as the best one, are
    given. There may be others.

    Examples
    --------
    >>> from slipcircle import backanalyse, load
    >>> found = backanalyse(load("vaiont"), run_out=400.0)
    >>> round(found.value, 4)
    15.2147
    """
    checked(scene, "backanalyse")
    observed = observations({"reach": reach, "run_out": run_out, "peak_velocity": peak_velocity, "duration": duration})
    if scene.shape:
        raise ValueError("backanalyse: takes one scene of plain numbers, not an ensemble")
    paths = [field] if isinstance(field, str) else list(field) if isinstance(field, Sequence) else []
    if not paths or not isinstance(bounds, tuple | Mapping | None):
        raise ValueError(f"backanalyse: field = {field!r}, bounds = {bounds!r}: must be a key or a list of keys, and a "
                         "pair of numbers or a mapping from keys to such")  # fmt: skip
    given = dict.fromkeys(paths[:1], bounds) if isinstance(bounds, tuple) else dict(bounds or {})
    try:
        fields = [number_in(scene, path) for path in paths]
        limits = {number_in(scene, path).key: b for path, b in given.items()}
    except ValueError as error:
        raise ValueError(f"backanalyse: field: {error}") from error
    check(scene, fields, observed, bounds, limits)
    ranges = [between(f.key, *limits[f.key]) if f.key in limits else range_of(scene, f, len(fields) == 1)
              for f in fields]  # fmt: skip
    if len(fields) == len(observed) == 1:
        return _met(scene, fields[0], observed, ranges[0])
    return _fitted(scene, fields, observed, ranges)


def _met(scene: Scene, field: Number, observed: Observations, values: Floats) -> BackAnalysis:
    """All values with the one observation."""
    ((name, (wanted, _)),) = observed.items()

    def sample(at: Floats) -> tuple[Floats, NDArray[np.int64]]:
        found = search.sampled(scene, [field], at[None, :])
        return found.outcomes[name], found.kind

    solutions = [_solution(scene, [field], [v], observed) for v in search.roots(sample, values, wanted)]
    if solutions:
        solutions.sort(key=lambda s: (len(s.motion.phases), -s.value))
        return BackAnalysis({field.key: field.unit}, dict(observed), tuple(solutions), ROOT)
    if not np.any(np.isfinite(sample(values)[0])):
        raise Unattainable(f"{field.key}: with no value of it between the bounds does this scene move and rest", {})
    places = [search.extreme(sample, values, sign)[1] for sign in (-1.0, 1.0)]
    ends = tuple((float(solve(scene_with(scene, {field.name: field.to_si(at)})).outcomes[name]), at) for at in places)
    unit = OUTCOMES[name].unit
    words = " to ".join(f"{v:.6g} {unit} (at {field.key} = {at:.6g})" for v, at in ends)
    if ends[1][0] - ends[0][0] <= 1e-9 * abs(ends[1][0]):
        words = f"only {ends[0][0]:.6g} {unit}, whatever it is"
    said = f"{name} = {wanted:.10g} {unit}: no {field.key} gives it; attainable: {words}"
    raise Unattainable(said, {name: (ends[0], ends[1])})


def _fitted(scene: Scene, fields: Sequence[Number], observed: Observations, ranges: Sequence[Floats]) -> BackAnalysis:
    names = ", ".join(f.key for f in fields)
    space = search.Space(scene, fields, ranges, observed)
    points = sobol(0, (5,), 0, _STARTS * len(fields), len(fields))
    pairs = zip(points, ranges, strict=True)
    tried = np.stack([np.interp(p, np.linspace(0.0, 1.0, len(r)), r) for p, r in pairs])
    fits = search.fits(space, space.shares(tried))
    if not fits:
        raise Unattainable(f"{names}: with no values of them between the bounds does this scene move and rest", {})
    solutions, untold = [], list[ValueError]()
    for fit in fits:
        try:
            solutions.append(_solution(scene, fields, space.at(fit.shares[:, None])[:, 0].tolist(), observed))
        except ValueError as error:  # here the fields cannot be told apart, though they may elsewhere
            untold.append(error)
    if not solutions:
        raise untold[0]
    found = _best(solutions, observed)
    first = found[0]
    sigmas = [sigma for _, sigma in observed.values()]
    far = all(sigmas) and len(fields) == len(observed) and first.chi_square > _FAR**2
    if far or (first.covariance is None and first.chi_square > _MET):
        outcomes = search.outcomes_of(first.motion, list(observed))
        near = ", ".join(f"{n} = {y:.6g} {OUTCOMES[n].unit}" for n, y in zip(observed, outcomes, strict=True))
        at = ", ".join(f"{n} = {v:.6g}" for n, v in first.values.items())
        off = f"that is {math.sqrt(first.chi_square):.3g} standard errors off"
        how = off if far else "with standard errors that is fitted"
        raise Unattainable(f"no values of {names} give {' and '.join(observed)} as observed; the nearest is {near} "
                           f"at {at}; {how}", {})  # fmt: skip
    doubts = _doubts(first, observed, {f.key: r for f, r in zip(fields, ranges, strict=True)})
    if not fits[0].settled:
        doubts += ("the best values lie where the motion changes its kind: their covariance means little",)
    return BackAnalysis({f.key: f.unit for f in fields}, dict(observed), found, FITTED, doubts)


def _best(solutions: Sequence[Solution], observed: Observations) -> tuple[Solution, ...]:
    """What fits about as well as the best one, which comes first; the fewest swings, where all is met exactly."""
    ordered = sorted(solutions, key=lambda s: (max(s.chi_square, _MET), len(s.motion.phases)))
    best = ordered[0].chi_square
    known = all(sigma is not None for _, sigma in observed.values())
    limit = best + 9.0 if known else 4 * best + _MET  # three standard errors; without them, twice the misfit
    return tuple(s for s in ordered if s.chi_square <= limit)


def _solution(scene: Scene, fields: Sequence[Number], values: Sequence[float], observed: Observations) -> Solution:
    si = {f.name: float(f.to_si(v)) for f, v in zip(fields, values, strict=True)}
    there = scene_with(scene, si)
    motion = solve(there)
    sizes = np.array([sigma or abs(seen) for seen, sigma in observed.values()])
    missed = search.outcomes_of(motion, list(observed)) - [seen for seen, _ in observed.values()]
    _, slopes = derivatives(there, si)
    changes = np.array([[slopes[n][f.name] * f.slope(v) for f, v in zip(fields, values, strict=True)]
                        for n in observed]) / sizes[:, None]  # fmt: skip
    chi_square = float(np.sum((missed / sizes) ** 2))
    at = np.array(values)
    relative = changes * np.where(at == 0.0, 1.0, np.abs(at))
    off = motion.error_estimate * np.abs(search.outcomes_of(motion, list(observed))) / sizes
    told = bool(np.all(np.isfinite(relative))) and bool(np.all(np.any(relative != 0.0, axis=0)))
    error = float(max(np.max(np.abs(np.linalg.pinv(relative)) @ off), EPS)) if told else math.inf
    return Solution({f.key: float(v) for f, v in zip(fields, values, strict=True)}, motion,
                    dict(zip(observed, missed.tolist(), strict=True)),
                    _covariance(fields, at, observed, changes, chi_square), error, chi_square)  # fmt: skip


def _covariance(fields: Sequence[Number], at: Floats, observed: Observations, changes: Floats,
                chi_square: float) -> Floats | None:  # fmt: skip
    """Covariance of the fields to first order, from the standard errors, or else from the misfit that is left.

    Without either, as where one value without an error is met exactly, there is none.

    Raises
    ------
    ValueError
        If the observations do not tell the fields apart.
    """
    if not np.all(np.isfinite(changes)):
        return None
    unit = np.where(at == 0.0, 1.0, np.abs(at))
    relative = changes * unit  # residuals by relative changes
    size = np.linalg.norm(relative, axis=0)
    names = ", ".join(observed)
    if idle := [f.key for f, s in zip(fields, size, strict=True) if not s > _NOISE * np.max(size)]:
        raise ValueError(f"backanalyse: {', '.join(idle)}: changes nothing of {names}, and cannot be found from it")
    _, singular, rows = np.linalg.svd(relative / size)
    if singular[-1] <= _NOISE * singular[0]:
        way = rows[-1] / size
        way = way / np.max(np.abs(way))
        steps = " and ".join(f"{f.key} by {100 * w:+.3g} %" for f, w in zip(fields, way, strict=True))
        raise ValueError(f"backanalyse: changing {steps} changes nothing of {names}: they cannot be told apart by it")
    known = all(sigma is not None for _, sigma in observed.values())
    free = len(observed) - len(fields)
    if not known and not free:
        return None
    inverse = np.linalg.pinv(relative) * unit[:, None]
    return np.asarray(inverse @ inverse.T * (1.0 if known else chi_square / free))


def _doubts(first: Solution, observed: Observations, ranges: Mapping[str, Floats]) -> tuple[str, ...]:
    """What to know of a fit."""
    said = []
    for name, value in first.values.items():
        low, high = ranges[name][0], ranges[name][-1]
        if (first.standard_errors or {}).get(name, 0.0) > high - low:
            said.append(f"{name} is not told by what is observed: {value:.6g} is one of many values that fit as well")
        elif min(value - low, high - value) <= 1e-6 * (high - low):
            said.append(f"{name} = {value:.6g} lies at the end of its range: its standard error means little")
        elif (first.standard_errors or {}).get(name, 0.0) > abs(value):
            said.append(f"{name} = {value:.6g} is hardly told by what is observed: its standard error is larger")
    free = len(observed) - len(first.values)
    if all(sigma is not None for _, sigma in observed.values()):
        from scipy.special import chdtrc

        chance = float(chdtrc(free, first.chi_square)) if free else float(first.chi_square < 1.0)
        if chance < _WORST:
            of = "no observation is left over, so that all could be met" if not free else f"chance {chance:.1g}"
            said.append(
                f"the misfit is larger than the standard errors explain: chi-square {first.chi_square:.4g} with "
                f"{free} degrees of freedom ({of})"
            )
    return tuple(said)
