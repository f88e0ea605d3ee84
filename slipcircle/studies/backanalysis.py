"""Back-analysis: which friction, or which values of other fields, explain the motion that was observed.

One field is followed over its range; where the mass turns back once more, begins to move or lifts off, the motion has
a kink, so the range is cut there, and each smooth piece is searched for its own solutions. Several fields are fitted to
several observations, from starts all over their ranges.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipcircle.balance import bind
from slipcircle.base.checks import raise_all
from slipcircle.motion.motion import Motion
from slipcircle.motion.solver import solve
from slipcircle.scene.scene import Scene
from slipcircle.studies import fit
from slipcircle.studies.curve import Curve
from slipcircle.studies.fields import OBSERVED, Field, outputs_of

Floats = NDArray[np.float64]
CLOSED = "closed form"
ROOT = "root in a bracket"
FITTED = "least squares"
UNITS = {"runout": "m", "peak_velocity": "m/s", "duration": "s"}
_MOST_CLOSED = 60  # swings of a motion in the closed form
_MET = 1e-12  # sum of squares below which all is met exactly
_WORST = 1e-3  # probability of so large a misfit, below which it is told

Observed = float | tuple[float, float]
Bounds = tuple[float, float]


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
        Of the fields, SI units and radians.
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
        Unit of each field.
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
    def friction_angle_deg(self) -> float | None:
        """Friction angle of the first solution, degrees; None where the first field is another."""
        return angle_deg(self.field, self.value)

    @property
    def degrees_of_freedom(self) -> int:
        """Observations less fields."""
        return len(self.observed) - len(self.units)


def angle_deg(field: str, value: float) -> float | None:
    """What a coefficient of friction is in degrees; None for another field."""
    lengths = ("friction.length", "friction.velocity")
    return math.degrees(math.atan(value)) if field.startswith("friction") and field not in lengths else None


def backanalyse(
    scene: Scene,
    *,
    runout: Observed | None = None,
    peak_velocity: Observed | None = None,
    duration: Observed | None = None,
    field: str | Sequence[str] = "friction",
    bounds: Bounds | Mapping[str, Bounds] | None = None,
) -> BackAnalysis:
    """Find the values of one field, or of several, with which the scene moves as observed.

    Parameters
    ----------
    scene : Scene
        Its own values of the fields do not count.
    runout, peak_velocity, duration : float or tuple of float, optional
        Observed value, or value and standard error; m, m/s, s; signed as `Motion` gives them. One at least. One alone
        is met exactly by one field, several in the sense of least squares.
    field : str or sequence of str, optional
        ``friction``; ``friction.peak`` and so on of a law; ``cohesion``, ``ratio`` or ``pressure`` of the pore water,
        ``xi`` of the drag, also as ``pore_pressure.ratio``, whether the scene has the effect or not; ``radius``,
        ``theta_1``, ``theta_2``, ``dip`` (both angles at once), ``unit_weight``, ``gravity``, ``initial_velocity``.
        Several need as many observations at least.
    bounds : tuple of float, or mapping of such by field, optional
        Where to search; by default a range wide enough for the field.

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
    friction lets it swing, and the same run-out then has several solutions; motions of more than 12 swings are left
    out (60 in the closed form). Scenes that are integrated in time are searched on a coarser grid.

    Several fields are fitted from the best of some hundred starts, with exact derivatives where there are any; all
    different minima that are found, and fit about as well as the best one, are given. There may be others.

    Examples
    --------
    >>> from slipcircle import Scene, backanalyse
    >>> found = backanalyse(Scene.load("vaiont"), runout=(400, 20), peak_velocity=(17, 1), field=["friction", "dip"])
    >>> {name: round(value, 3) for name, value in found.solutions[0].values.items()}
    {'friction': 0.371, 'dip': 0.513}
    """
    observed = _observations({"runout": runout, "peak_velocity": peak_velocity, "duration": duration})
    names = [field] if isinstance(field, str) else list(field)
    fields = [Field(scene, name) for name in names]
    given = dict.fromkeys(names[:1], bounds) if isinstance(bounds, tuple) else dict(bounds or {})
    between = {Field(scene, name).name: b for name, b in given.items()}
    _check(fields, observed, bounds, between)
    units = {f.name: f.unit for f in fields}
    change = fields[0]
    if list(observed) == ["runout"] and not between and _tilted_pendulum(change):
        values = _by_pendulum(change, observed["runout"][0])
        if values:
            found = [_solution(scene, fields, [v], observed) for v in values]
            return BackAnalysis(units, observed, tuple(found), CLOSED)
    ranges = [_between(f.name, *between[f.name]) if f.name in between else f.range(len(fields) == 1) for f in fields]
    if len(fields) > 1:
        return _fitted(scene, fields, observed, ranges, units)
    curve = Curve(change, observed, ranges[0])
    values = curve.roots() if len(observed) == 1 else curve.minima()
    if not values:
        raise _unattainable(curve, observed)
    solutions = [_solution(scene, fields, [v], observed) for v in values]
    if len(observed) == 1:
        solutions.sort(key=lambda s: (len(s.motion.phases), -s.value))
        return BackAnalysis(units, observed, tuple(solutions), ROOT)
    kept = _best(solutions, observed)
    return BackAnalysis(units, observed, kept, FITTED, _doubts(kept[0], observed, {change.name: ranges[0]}))


def _fitted(
    scene: Scene, fields: Sequence[Field], observed: fit.Observations, ranges: Sequence[Sequence[float]],
    units: dict[str, str],
) -> BackAnalysis:  # fmt: skip
    names = ", ".join(units)
    fits = fit.search(scene, fields, observed, ranges)
    if not fits:
        raise Unattainable(f"{names}: with no values of them between the bounds does this scene move and rest", {})
    solutions, untold = [], list[ValueError]()
    for f in fits:
        try:
            solutions.append(_solution(scene, fields, f.values.tolist(), observed))
        except ValueError as error:  # here the fields cannot be told apart, though they may elsewhere
            untold.append(error)
    if not solutions:
        raise untold[0]
    found = _best(solutions, observed)
    first = found[0]
    if first.covariance is None and first.chi_square > _MET:
        outputs = outputs_of(first.motion, [OBSERVED[n] for n in observed])
        near = ", ".join(f"{n} = {outputs[OBSERVED[n]]:.6g} {UNITS[n]}" for n in observed)
        at = ", ".join(f"{n} = {v:.6g} {units[n]}".rstrip() for n, v in first.values.items())
        raise Unattainable(f"no values of {names} give {' and '.join(observed)} as observed; the nearest is {near} "
                           f"at {at}; with standard errors that is fitted", {})  # fmt: skip
    doubts = _doubts(first, observed, {f.name: r for f, r in zip(fields, ranges, strict=True)})
    if not fits[0].settled:
        doubts += ("the best values lie where the motion changes its kind: their covariance means little",)
    return BackAnalysis(units, dict(observed), found, FITTED, doubts)


def _best(solutions: Sequence[Solution], observed: fit.Observations) -> tuple[Solution, ...]:
    """What fits about as well as the best one, which comes first; the fewest swings, where all is met exactly."""
    ordered = sorted(solutions, key=lambda s: (max(s.chi_square, _MET), len(s.motion.phases)))
    best = ordered[0].chi_square
    known = all(sigma is not None for _, sigma in observed.values())
    limit = best + 9.0 if known else 4 * best + _MET  # three standard errors; without them, twice the misfit
    return tuple(s for s in ordered if s.chi_square <= limit)


def _doubts(first: Solution, observed: fit.Observations, ranges: Mapping[str, Sequence[float]]) -> tuple[str, ...]:
    """What to know of a fit."""
    said = []
    for name, value in first.values.items():
        low, high = ranges[name][0], ranges[name][-1]
        if min(value - low, high - value) <= 1e-6 * (high - low):
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


def _check(fields: Sequence[Field], observed: fit.Observations, bounds: Any, between: Mapping[str, Bounds]) -> None:
    """Refuse what makes no sense together."""
    wrong, full, seen = [], [f.name for f in fields], ", ".join(observed)
    if not fields:
        wrong.append("field = []: name one at least")
    if twice := sorted({n for n in full if full.count(n) > 1}):
        wrong.append(f"field: {', '.join(twice)} is named twice")
    if "dip" in full and {"theta_1", "theta_2"} & set(full):
        wrong.append("field: dip turns theta_1 and theta_2 together; leave it or them out")
    if len(fields) > len(observed):
        wrong.append(
            f"{len(fields)} fields from {len(observed)} of what is observed ({seen}): they cannot be told apart; give "
            "as many observations as fields, or fewer fields"
        )
    if isinstance(bounds, tuple) and len(fields) > 1:
        wrong.append(f"bounds = {bounds!r}: of several fields give a mapping, such as {{{full[0]!r}: {bounds!r}}}")
    if other := [n for n in between if n not in full]:
        wrong.append(f"bounds: {', '.join(other)} is none of the fields")
    raise_all("backanalyse", wrong)


def _observations(given: Mapping[str, Observed | None]) -> dict[str, tuple[float, float | None]]:
    found, wrong = {}, []
    for name, value in given.items():
        if value is None:
            continue
        try:
            seen, sigma = map(float, value) if isinstance(value, (tuple, list)) else (float(value), None)
        except (TypeError, ValueError):
            seen, sigma = math.nan, None
        positive = sigma is None or 0.0 < sigma < math.inf
        if not positive or not math.isfinite(seen) or seen == 0.0 or (name == "duration" and seen < 0.0):
            wrong.append(f"{name} = {value!r}: must be a number other than 0, or it and its positive standard error")
        else:
            found[name] = (seen, sigma)
    if not found and not wrong:
        wrong.append(f"nothing observed: give one of {', '.join(given)}")
    if len({sigma is None for _, sigma in found.values()}) > 1:
        wrong.append("standard errors: give them for all observations, or for none")
    raise_all("backanalyse", wrong)
    return found


def _between(name: str, low: float, high: float) -> list[float]:
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ValueError(
            f"backanalyse: bounds of {name} = ({low!r}, {high!r}): must be two numbers, the lower one first"
        )
    if low > 0.0 and high > 100 * low:
        return [float(v) for v in np.geomspace(low, high, 101)]
    return [float(v) for v in np.linspace(low, high, 101)]


def _solution(scene: Scene, fields: Sequence[Field], values: Sequence[float], observed: fit.Observations) -> Solution:
    motion = solve(fit.scene_with(scene, fields, values))
    outputs = outputs_of(motion, [OBSERVED[n] for n in observed])
    missed = {n: outputs[OBSERVED[n]] - seen for n, (seen, _) in observed.items()}
    chi_square = float(np.sum(fit.residuals(motion, observed) ** 2))
    at, scaled = np.array(values), fit.changes(fields, motion, observed)
    return Solution(
        {f.name: float(v) for f, v in zip(fields, values, strict=True)}, motion, missed,
        fit.covariance(fields, at, motion, observed, scaled), fit.numerical_error(at, motion, observed, scaled),
        chi_square,
    )  # fmt: skip


# --- the closed form -----------------------------------------------------------------------------------------------


def _tilted_pendulum(field: Field) -> bool:
    """Whether the mass is a pendulum under gravity tilted by friction, from rest to rest: no centripetal stress."""
    scene, water = field.scene, field.scene.called.get("pore_pressure", {})
    return (
        field.name == "friction"
        and set(scene.called) in ({"rotation"}, {"rotation", "pore_pressure"})
        and not water.get("pressure", 0.0)
        and float(np.asarray(scene.initial_velocity)) == 0.0
        and scene.end_time is None
        and float(scene.arc.dip) != 0.0
    )


def _by_pendulum(field: Field, runout: float) -> list[float]:
    """Frictions with this run-out, the fewest swings first.

    It swings about delta = arctan(mu C_r/C_theta), down-slope and back in turn, so that the dip's size falls by
    2 delta each time, and rests where it is at most delta. After n swings psi_0 - s/R = (-1)**n (psi_0 - 2 n delta).
    """
    scene = field.scene
    balance, down = bind(scene), 1.0 if float(scene.arc.dip) > 0.0 else -1.0
    dip, turn = abs(balance.dip), down * runout / balance.radius
    found = []
    for n in range(1, _MOST_CLOSED + 1):
        tilt = (2 * dip - turn if n % 2 else turn) / (2 * n)
        if 0.0 < tilt < dip and abs(dip - turn) <= tilt:
            share = 1.0 - float(balance.values.get("pore_ratio", 0.0))
            found.append(balance.weight / (balance.radial * share) * math.tan(tilt))
    return found


def _unattainable(curve: Curve, observed: Mapping[str, tuple[float, float | None]]) -> Unattainable:
    samples, field = list(curve.samples), curve.field
    unit = f" {field.unit}" if field.unit else ""
    if not samples:
        return Unattainable(f"{field.name}: with no value of it between the bounds does this scene move and rest", {})
    attainable, said = {}, []
    for name, (wanted, _) in observed.items():
        ordered = sorted(samples, key=lambda s, name=name: s.outputs[OBSERVED[name]])  # type: ignore[misc]
        ends = [(s.outputs[OBSERVED[name]], s.value) for s in (ordered[0], ordered[-1])]
        attainable[name] = (ends[0], ends[1])
        words = " to ".join(f"{v:.6g} {UNITS[name]} (at {field.name} = {at:.6g}{unit})" for v, at in ends)
        if ends[1][0] - ends[0][0] <= 1e-9 * abs(ends[1][0]):
            words = f"only {ends[0][0]:.6g} {UNITS[name]}, whatever it is"
        said.append(f"{name} = {wanted:.10g} {UNITS[name]}: no {field.name} gives it; attainable: {words}")
    return Unattainable("; ".join(said), attainable)
