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
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.solver import solve
from slipcircle.core.scene.scene import Scene, checked
from slipcircle.workbench.common.quantities import OUTCOMES
from slipcircle.workbench.files.variation import scene_with
from slipcircle.workbench.studies.inversion import (
    Bounds,
    Observed,
    Space,
    extreme,
    fits,
    observations,
    roots,
    search_space,
)
from slipcircle.workbench.studies.motions import derivatives
from slipcircle.workbench.studies.sampling import sobol

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
    space = search_space(scene, field, bounds, observed)
    alone = len(space.fields) == len(observed) == 1
    solutions, doubts = (_met(space), []) if alone else _fitted(space)
    units = {f.key: f.unit for f in space.fields}
    return BackAnalysis(units, observed, tuple(solutions), ROOT if alone else FITTED, tuple(doubts))


def _met(space: Space) -> list[Solution]:
    """All values of the one field with the one observation."""
    (field,), (name,), (wanted,) = space.fields, space.observed, space.seen
    if solutions := [_solution(space, [v]) for v in roots(space)]:
        return sorted(solutions, key=lambda s: (len(s.motion.phases), -s.value))
    places = [extreme(space, sign) for sign in (-1.0, 1.0)]
    if math.isnan(places[0]):
        raise Unattainable(f"{field.key}: with no value of it between the bounds does this scene move and rest", {})
    there = [solve(scene_with(space.scene, {field.name: field.to_si(at)})) for at in places]
    least, most = ((float(motion.outcomes[name]), at) for motion, at in zip(there, places, strict=True))
    unit = OUTCOMES[name].unit
    words = " to ".join(f"{v:.6g} {unit} (at {field.key} = {at:.6g})" for v, at in (least, most))
    if most[0] - least[0] <= 1e-9 * abs(most[0]):
        words = f"only {least[0]:.6g} {unit}, whatever it is"
    said = f"{name} = {wanted:.10g} {unit}: no {field.key} gives it; attainable: {words}"
    raise Unattainable(said, {name: (least, most)})


def _fitted(space: Space) -> tuple[list[Solution], list[str]]:
    """All values of the fields that meet the observations about as well as the best ones, and what to know of them."""
    names, count = ", ".join(f.key for f in space.fields), len(space.fields)
    found = fits(space, sobol(0, (5,), 0, _STARTS * count, count))
    if not found:
        raise Unattainable(f"{names}: with no values of them between the bounds does this scene move and rest", {})
    solutions, untold = [], list[ValueError]()
    for fit in found:
        try:
            solutions.append(_solution(space, space.at(fit.shares[:, None])[:, 0].tolist()))
        except ValueError as error:  # here the fields cannot be told apart, though they may elsewhere
            untold.append(error)
    if not solutions:
        raise untold[0]
    # The best one first; the fewest swings, where all is met exactly.
    solutions.sort(key=lambda s: (max(s.chi_square, _MET), len(s.motion.phases)))
    first, best = solutions[0], solutions[0].chi_square
    far = space.weighed and not space.free and best > _FAR**2
    if far or (first.covariance is None and best > _MET):
        near = ", ".join(f"{n} = {float(first.motion.outcomes[n]):.6g} {OUTCOMES[n].unit}" for n in space.observed)
        at = ", ".join(f"{n} = {v:.6g}" for n, v in first.values.items())
        off = f"that is {math.sqrt(best):.3g} standard errors off"
        how = off if far else "with standard errors that is fitted"
        raise Unattainable(
            f"no values of {names} give {' and '.join(space.observed)} as observed; the nearest is "
            f"{near} at {at}; {how}",
            {},
        )
    limit = best + 9.0 if space.weighed else 4 * best + _MET  # three standard errors, or twice the misfit
    doubts = _doubts(space, first)
    if not found[0].settled:
        doubts.append("the best values lie where the motion changes its kind: their covariance means little")
    return [s for s in solutions if s.chi_square <= limit], doubts


def _solution(space: Space, values: Sequence[float]) -> Solution:
    """What is known of values that explain the observations, which have to tell the fields apart."""
    pairs = [*zip(space.fields, values, strict=True)]
    si = {f.name: float(f.to_si(v)) for f, v in pairs}
    there = scene_with(space.scene, si)
    motion, (_, slopes) = solve(there), derivatives(there, si)
    outcomes = np.array([float(motion.outcomes[n]) for n in space.observed])
    missed = outcomes - space.seen
    chi_square = float(np.sum((missed / space.sizes) ** 2))
    unit = np.array([abs(v) or 1.0 for v in values])
    relative = np.array([[slopes[n][f.name] * f.slope(v) for f, v in pairs] for n in space.observed])
    relative = relative / space.sizes[:, None] * unit
    covariance, error = None, math.inf
    if np.all(np.isfinite(relative)):
        _tell_apart(space, relative)
        inverse = np.linalg.pinv(relative)
        error = float(max(np.max(np.abs(inverse) @ (motion.error_estimate * np.abs(outcomes) / space.sizes)), EPS))
        if space.weighed or space.free:
            scaled = inverse * unit[:, None]
            covariance = np.asarray(scaled @ scaled.T * (1.0 if space.weighed else chi_square / space.free))
    return Solution(
        {f.key: float(v) for f, v in pairs},
        motion,
        dict(zip(space.observed, missed.tolist(), strict=True)),
        covariance,
        error,
        chi_square,
    )


def _tell_apart(space: Space, relative: Floats) -> None:
    """Refuse residuals that do not change with one of the fields, or with several of them together."""
    size, names = np.linalg.norm(relative, axis=0), ", ".join(space.observed)
    if idle := [f.key for f, s in zip(space.fields, size, strict=True) if not s > _NOISE * np.max(size)]:
        raise ValueError(f"backanalyse: {', '.join(idle)}: changes nothing of {names}, and cannot be found from it")
    _, singular, rows = np.linalg.svd(relative / size)
    if singular[-1] <= _NOISE * singular[0]:
        way = rows[-1] / size
        way = way / np.max(np.abs(way))
        steps = " and ".join(f"{f.key} by {100 * w:+.3g} %" for f, w in zip(space.fields, way, strict=True))
        raise ValueError(f"backanalyse: changing {steps} changes nothing of {names}: they cannot be told apart by it")


def _doubts(space: Space, first: Solution) -> list[str]:
    """What to know of a fit."""
    said = []
    for (name, value), (low, *_, high) in zip(first.values.items(), space.ranges, strict=True):
        error = (first.standard_errors or {}).get(name, 0.0)
        if error > high - low:
            said.append(f"{name} is not told by what is observed: {value:.6g} is one of many values that fit as well")
        elif min(value - low, high - value) <= 1e-6 * (high - low):
            said.append(f"{name} = {value:.6g} lies at the end of its range: its standard error means little")
        elif error > abs(value):
            said.append(f"{name} = {value:.6g} is hardly told by what is observed: its standard error is larger")
    if space.weighed:
        from scipy.special import chdtrc

        free = space.free
        chance = float(chdtrc(free, first.chi_square)) if free else float(first.chi_square < 1.0)
        if chance < _WORST:
            of = "no observation is left over, so that all could be met" if not free else f"chance {chance:.1g}"
            said.append(
                f"the misfit is larger than the standard errors explain: chi-square {first.chi_square:.4g} with "
                f"{free} degrees of freedom ({of})"
            )
    return said
