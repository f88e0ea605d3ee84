"""Definition of a back-analysis: the fields to fit, their ranges, and the observations."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from generated.effects import EFFECTS
from slipcircle.base.arrays import float_or_array, real_number
from slipcircle.base.bounds import abridged
from slipcircle.base.errors import raise_all
from slipcircle.base.kinds import ArrayPair, Floats, Pair, Texts
from slipcircle.base.progress import counted
from slipcircle.core import ANSWERED, DIP, Scene, Status, law_parts
from slipcircle.derivatives import parameter_value
from slipcircle.layers import depends_on
from slipcircle.workbench.common.quantities import OBSERVABLE, Interval, Observed, observable
from slipcircle.workbench.files.keys import Key
from slipcircle.workbench.files.numbers import by_key, lengths, listed, number_in
from slipcircle.workbench.studies.motions import motions

Kinds = NDArray[Any]  # kind of each motion: its status and number of turnings


Observations = Mapping[str, tuple[float, float | None]]
MOST_SWINGS = 12  # of a motion in a search: with more, run-out hardly depends on friction and has many solutions
_PATIENCE = 100.0  # times sqrt(R/g), until which a motion is followed; a slower creep is left out
_AT_ONCE = 1e-9  # times sqrt(R/g), if only the start is needed
_POSITIVE = ("duration", "factor_of_safety")
_FINE = 1e-13  # accuracy of motions in a search
_STEP = 1e-6  # of difference quotients, as a share of a range
_BLOCK = 256  # motions solved in one call, then reported as progress


class SearchProblem:
    """Fields of a scene with their ranges, and the observations.

    Points are given as shares, from 0 to 1, of the ranges. Values of a range are denser where motions change faster.
    """

    def __init__(
        self,
        scene: Scene,
        fields: Sequence[Key],
        ranges: Sequence[Floats],
        observed: Observations,
        limit: Interval | None = None,
    ) -> None:
        self.limit = limit
        self.scene = scene
        self.fields = fields
        self.ranges = ranges
        self.observed = observed
        values, sigmas = zip(*observed.values(), strict=True)
        self.is_weighted = None not in sigmas  # standard errors for all observations, or for none
        exit = float(np.ravel(scene.arc.exit)[0])  # x of the toe before the motion
        self.origins = np.array([exit if name == "toe_x" else 0.0 for name in observed])
        self.targets = np.array(values) - self.origins
        self.scales = np.array([sigma or abs(value) or 1.0 for value, sigma in zip(self.targets, sigmas, strict=True)])

    @property
    def degrees_of_freedom(self) -> int:
        """Number of observations minus number of fields."""
        return len(self.observed) - len(self.fields)

    def outcomes(self, values: Floats) -> tuple[Floats, Kinds]:
        """Return the observed outcomes for values (fields, count) in the fields' units, and the kinds of motion.

        Outcomes are (observations, count), kinds (count,); NaN and -1 for motions that do not start or end in time.
        """
        parts = []
        count = values.shape[1]
        with counted(count, "scenes solved") as progress:
            for block in np.array_split(values, max(1, math.ceil(count / _BLOCK)), axis=1):
                parts.append(self._outcomes(block))
                progress(block.shape[1])
        outcomes, kinds = zip(*parts, strict=True)
        return np.concatenate(outcomes, axis=1), np.concatenate(kinds)

    def _outcomes(self, values: Floats) -> tuple[Floats, Kinds]:
        """Return `outcomes` for values that are solved in one call."""
        scene = self.scene
        is_open = scene.end_time is None
        if is_open:
            patience = _AT_ONCE if {*self.observed} == {"factor_of_safety"} else _PATIENCE
            scene = replace(scene, end_time=patience * float(scene.arc.time_scale), uncertain={})
        si = {field.name: field.to_si(value) for field, value in zip(self.fields, values, strict=True)}
        motion = motions(scene, si, _FINE)
        outcomes = self.seen(motion)
        counts = np.isin(motion.status, ANSWERED) & (motion.moves | may_stand(self.observed, self.limit))
        is_moving = is_open & (motion.status == Status.MOVING)
        if self.limit is not None:  # the greatest displacement is reached in the first swing
            outcomes = np.where(is_moving & ("duration" in self.observed), np.inf, outcomes)
        elif not may_stand(self.observed, None):
            counts &= (motion.turnings <= MOST_SWINGS) & ~is_moving
        kind = 10 * motion.turnings + motion.status
        outcomes = np.where(counts, outcomes, np.nan)
        return outcomes, np.where(counts, kind, -1)

    def seen(self, motion: Any) -> Floats:
        """Return the observed outcomes of a motion in SI units, (observations, ...), relative to their origins.

        The origin is the x of the toe at the start for ``toe_x``, otherwise 0.
        """
        outcomes = np.stack([observable(motion, name) for name in self.observed])
        return outcomes - self.origins.reshape(-1, *[1] * (outcomes.ndim - 1))

    def values_at(self, shares: Floats) -> Floats:
        """Return the values of the fields in their units at shares of their ranges, both (fields, count)."""
        by_field = zip(shares, self.ranges, strict=True)
        return np.stack([np.interp(share, np.linspace(0.0, 1.0, len(row)), row) for share, row in by_field])

    def residuals(self, shares: Floats) -> Floats:
        """Return computed minus observed outcomes over their scales, (observations, count).

        ``shares`` are points in the ranges from 0 to 1, (fields, count).
        """
        outcomes, _ = self.outcomes(self.values_at(shares))
        return (outcomes - self.targets[:, None]) / self.scales[:, None]

    def linearised(self, shares: Floats) -> ArrayPair:
        """Return residuals, (observations,), and their derivatives with respect to the shares, (observations, fields).

        ``shares`` is one point, (fields,).
        """
        here = shares[:, None]
        steps = _STEP * np.eye(len(shares))
        places = np.hstack([here, np.minimum(here + steps, 1.0), np.maximum(here - steps, 0.0)])
        residuals = self.residuals(places)
        at_here = residuals[:, 0]
        is_known = ~np.isnan(residuals).any(axis=0)
        residuals = np.where(is_known, residuals, at_here[:, None])
        places = np.where(is_known, places, here)
        _, up, down = np.split(places, [1, 1 + len(shares)], axis=1)
        _, above, below = np.split(residuals, [1, 1 + len(shares)], axis=1)
        return at_here, (above - below) / np.maximum(np.diag(up - down), 1e-300)


# --- observations and fields -----------------------------------------------------------------------------------------


def observations(entered: Mapping[str, Observed]) -> tuple[Observations, dict[str, Interval]]:
    """Return observed values with standard errors (None if not given) by outcome, and those that are intervals."""
    observed = {}
    unknown = [name for name in entered if name not in OBSERVABLE]
    mistakes = [f"observed.{name}: is not an outcome; known are {', '.join(OBSERVABLE)}" for name in unknown]
    of_outcomes = {name: value for name, value in entered.items() if name in OBSERVABLE}
    for name, value in of_outcomes.items():
        seen, sigma = _observation(value)
        has_error = sigma is None or 0.0 < sigma < math.inf
        if _is_possible(name, seen) and has_error:
            observed[name] = seen, sigma
        else:
            allowed = "a positive number" if name in _POSITIVE else "a number other than 0"
            also = f"it and its positive standard error, or an Interval in {OBSERVABLE[name].unit}, the lower end first"
            mistakes.append(f"{name} = {abridged(value)}: must be {allowed}, {also}")
    if not observed and not mistakes:
        mistakes.append(f"no observation: give one of {', '.join(OBSERVABLE)}")
    if len({sigma is not None for _, sigma in observed.values()}) > 1:
        mistakes.append("standard errors: give them for all observations, or for none")
    raise_all("backanalyse", mistakes)
    return observed, {name: value for name, value in of_outcomes.items() if isinstance(value, Interval)}


def _is_possible(name: str, seen: float) -> bool:
    """Return whether the outcome with a name may have the value ``seen``; only the position of the toe may be 0."""
    if name in _POSITIVE:
        return 0.0 < seen < math.inf
    return math.isfinite(seen) and (seen != 0.0 or name == "toe_x")


def _observation(value: Any) -> tuple[float, float | None]:
    """Return an observed value and its standard error; NaN for anything but a number, a pair or an interval."""
    if isinstance(value, Interval) and value.limit is not None:
        return real_number(value.limit), None
    if isinstance(value, Interval):
        ends = Interval(*map(real_number, value))
        return ends.middle, ends.standard_error
    if isinstance(value, tuple | list):
        seen, sigma = map(real_number, value) if len(value) == 2 else (math.nan, math.nan)
        return seen, sigma
    return real_number(value), None


def may_stand(observed: Observations, limit: Interval | None) -> bool:
    """Return whether a mass at rest is a valid candidate: for a limit, or a factor of safety alone.

    ``limit`` is the observed interval with one infinite end, or None.
    """
    return limit is not None or {*observed} == {"factor_of_safety"}


def search_problem(
    scene: Scene, field: Any, bounds: Any, observed: Observations, limits: Mapping[str, Interval]
) -> SearchProblem:
    """Return the back-analysis problem for the given fields and bounds; ValueError for invalid arguments.

    ``observed`` are values with standard errors by outcome, ``limits`` the observations given as intervals.
    """
    if scene.shape:
        raise ValueError("backanalyse: takes one scene of plain numbers, not an ensemble")
    if isinstance(field, str | None):
        field = [field or _default_field(scene)]
    if not isinstance(field, Sequence) or not field or not isinstance(bounds, tuple | Mapping | None):
        raise ValueError(
            f"backanalyse: field = {field!r}, bounds = {bounds!r}: must be a key or a list of keys, and a "
            "pair of numbers or a mapping from keys to pairs"
        )
    by_path = {field[0]: bounds} if isinstance(bounds, tuple) else dict(bounds or {})
    try:
        fields = [number_in(scene, path) for path in field]
        ends = {number_in(scene, path).key: pair for path, pair in by_path.items()}
    except ValueError as error:
        raise ValueError(f"backanalyse: field: {error}") from error
    limit = next((interval for interval in limits.values() if interval.limit is not None), None)
    mistakes = _field_mistakes(scene, fields, observed, limit)
    first = fields[0].key
    if isinstance(bounds, tuple) and len(fields) > 1:
        mistakes.append(f"bounds = {bounds!r}: of several fields give a mapping, such as {{{first!r}: {bounds!r}}}")
    if other := [key for key in ends if key not in [f.key for f in fields]]:
        mistakes.append(f"bounds: {', '.join(other)} is not one of the fields")
    raise_all("backanalyse", mistakes)
    is_alone = len(fields) == 1 and not may_stand(observed, limit)
    return SearchProblem(scene, fields, _ranges(scene, fields, ends, is_alone), observed, limit)


def _ranges(scene: Scene, fields: Sequence[Key], ends: Mapping[str, Pair], is_alone: bool) -> list[Floats]:
    """Return the values of each field to search, in its unit, between its ``ends`` by key if given.

    ``is_alone`` says that no other field varies.
    """
    return [
        _between(number.key, *ends[number.key]) if number.key in ends else _range(scene, number, is_alone)
        for number in fields
    ]


def _default_field(scene: Scene) -> str:
    """Return the key of the friction angle; ValueError if the law does not have a single angle."""
    keys = by_key(scene)
    if "friction.angle_deg" in keys:
        return "friction.angle_deg"
    laws = {key: number.name for key, number in keys.items() if number.name.startswith("friction.")}
    of_law = [key for key, name in laws.items() if parameter_value(scene, name) is not None]
    raise ValueError(
        f"backanalyse: field (--field): this law of friction has no single angle; give one of {listed(of_law or keys)}"
    )


def _field_mistakes(scene: Scene, fields: Sequence[Key], observed: Observations, limit: Interval | None) -> Texts:
    """Return a message for each mistake in the choice of fields; ``limit`` is the observation that is a limit."""
    mistakes = []
    names = [f.name for f in fields]
    ends = {"theta_1", "theta_2"}.intersection(names)
    if twice := sorted({f.key for f in fields if names.count(f.name) > 1}):
        mistakes.append(f"field: {', '.join(twice)} is named twice")
    if DIP.name in names and ends:
        mistakes.append("field: arc.dip_deg turns theta_1 and theta_2 together; leave it or them out")
    if scene.arc.given is not None and (DIP.name in names or ends):
        mistakes.append("field: the arc's coefficients are given, and do not follow its angles")
    if "toe_x" in observed and "ground" not in scene.arc.quantities:
        mistakes.append("toe_x: an arc has no position; give toe_rise or centroid_travel")
    if len(fields) > len(observed):
        mistakes.append(
            f"{len(fields)} fields from {len(observed)} observations ({', '.join(observed)}): they "
            "cannot be distinguished; give at least as many observations as fields"
        )
    if limit is not None and (len(fields) > 1 or len(observed) > 1):
        mistakes.append(f"{limit}: a limit is for one field alone; give one field and no other observation")
    return mistakes


# --- ranges ----------------------------------------------------------------------------------------------------------


def _between(name: str, low: float, high: float) -> Floats:
    """Return 401 increasing values from ``low`` to ``high``, in equal ratios if these are far apart.

    ``name`` is the key of the field, for the message of a ValueError.
    """
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ValueError(
            f"backanalyse: bounds of {name} = ({low!r}, {high!r}): must be two numbers, the lower one first"
        )
    return np.geomspace(low, high, 401) if 0.0 < 100 * low < high else np.linspace(low, high, 401)


def _range(scene: Scene, field: Key, is_alone: bool) -> Floats:
    """Return increasing values of a field to search without bounds, in its unit; more if it is alone."""
    is_coefficient = field.name.startswith("friction") and ".rate." not in field.name
    if is_coefficient and (field.tangent or not field.written):
        return np.unique(field.from_si(_friction_range(scene, field, is_alone)))
    values = _usual_range(scene, field.name)
    if values is None:
        raise ValueError(f"backanalyse: field = {field.key!r}: the scene does not set it; give bounds")
    return np.unique(field.from_si(values))


def _usual_range(scene: Scene, name: str) -> Floats | None:
    """Return usual values of a parameter in SI units, or None if the scene does not set the parameter.

    They follow from scales of the arc, or are around the scene's value.
    """
    arc = scene.arc
    stress, radius, gravity = map(float_or_array, (arc.static_normal_stress, arc.radius, arc.gravity))
    to_one = np.concatenate([np.linspace(0.0, 1.0, 81)[:-1], 1.0 - 10.0 ** -np.arange(2.0, 13.0, 2.0)])
    by_scale = {
        "initial_velocity": 2 * math.sqrt(gravity * radius) * np.linspace(-1.0, 1.0, 241),
        "dip": np.pi / 2 * np.concatenate([-to_one[:0:-1], to_one]),
        "cohesion.cohesion": stress * np.concatenate([[0.0], np.geomspace(1e-6, 100.0, 161)]),
        "pore_pressure.ratio": to_one,
        "pore_pressure.pressure": stress * to_one,
        "drag.xi": gravity * np.geomspace(1e-3, 1e9, 193),
        "friction.length": radius * np.geomspace(1e-9, 10.0, 161),
    }
    if name in by_scale:
        return by_scale[name]
    value = parameter_value(scene, name)
    if value is None:
        return None
    about = np.linspace(-1.0, 1.0, 401)
    if name in ("theta_1", "theta_2"):
        return value + np.pi * about
    if name in lengths(arc) or name.endswith(".top"):
        return value + radius * about
    return (value or 1.0) * np.geomspace(1e-3, 1e3, 121)


def _friction_range(scene: Scene, field: Key, is_alone: bool) -> Floats:
    """Return friction coefficients from many swings of the mass up to the limit of motion from rest.

    If the field ``is_alone``, greater ones follow for an initial velocity or a friction that is not constant.
    """
    at_once = replace(scene, end_time=1e-9 * float(scene.arc.time_scale), uncertain={})
    limit = float(motions(at_once, {field.name: np.zeros(1)}).limit_friction[0])
    if not 1e-6 < limit < math.inf:
        limit = 1.0
    least = 0.5 / MOST_SWINGS
    next_to_one = 1.0 - 10.0 ** -np.arange(3.0, 13.0)
    shares = [np.geomspace(least, 1.0, 129), np.linspace(least, 1.0, 129), next_to_one]
    is_constant = field.name == "friction"
    if is_constant and scene.end_time is None and not any(EFFECTS[effect].turns for effect in scene.called):
        shares = [np.ones(1)]  # with less friction the mass never rests
    laws = tuple(name for name, _ in law_parts(scene.friction))
    creeps = "speed" in depends_on(laws)  # with more friction the mass creeps, which takes long to solve
    if is_alone and not creeps and (float_or_array(scene.initial_velocity) != 0.0 or not is_constant):
        shares.append(np.geomspace(1.0, 1e3, 61))
    if "shaking" in scene.called or not is_alone:  # shaking moves a mass that would stay at rest
        highest = max(3.0 / limit, 2.0)
        shares.insert(0, np.zeros(1))
        shares.append(np.linspace(1.0, highest, 81))
    return limit * np.concatenate(shares)
