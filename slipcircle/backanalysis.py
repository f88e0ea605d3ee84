"""Back-analysis: which friction, or which value of another field, explains the motion that was observed.

The field is followed over its range; where the mass turns back once more, begins to move or lifts off, the motion has
a kink, so the range is cut there, and each smooth piece is searched for its own solutions.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from generated.effects import EFFECTS
from slipcircle.balance import bind
from slipcircle.checks import raise_all
from slipcircle.friction import law_name
from slipcircle.methods.roots import highest, root
from slipcircle.motion import Motion
from slipcircle.plan import INTEGRATION, plan
from slipcircle.scene import Scene
from slipcircle.sensitivity import OF_SCENE
from slipcircle.solver import solve

OUTPUTS = {"runout": "run_out", "peak_velocity": "peak_velocity", "duration": "duration"}
CLOSED = "closed form"
ROOT = "root in a bracket"
FITTED = "least squares"
_MOST_SWINGS = 12  # of a motion in a scan: below, run-out hardly depends on friction, and has ever more solutions
_MOST_CLOSED = 60
_EPS = 2.0**-52

Observed = float | tuple[float, float]


class Unattainable(ValueError):
    """No value of the field gives what was observed.

    Attributes
    ----------
    attainable : dict
        For each observed output, its lowest and its highest value found, each with the value of the field there.
    """

    def __init__(self, message: str, attainable: dict[str, tuple[tuple[float, float], tuple[float, float]]]) -> None:
        super().__init__(message)
        self.attainable = attainable


@dataclass(frozen=True)
class Solution:
    """One value of the field that explains what was observed.

    Attributes
    ----------
    value : float
        Of the field, SI units and radians.
    motion : Motion
        The motion with this value.
    residuals : dict of float
        Computed less observed, by observation.
    standard_error : float or None
        From the observations' standard errors, linear; None if there are none.
    error_estimate : float
        Of the value, relative: numerical, by the motion's own estimate.
    chi_square : float
        Sum of the squared residuals over their standard errors (over the observed values, where those are unknown).
    """

    value: float
    motion: Motion
    residuals: dict[str, float]
    standard_error: float | None
    error_estimate: float
    chi_square: float

    @property
    def covariance(self) -> float | None:
        """The square of the standard error: one field has a covariance of one number."""
        return None if self.standard_error is None else self.standard_error**2


@dataclass(frozen=True)
class BackAnalysis:
    """What explains an observation.

    Attributes
    ----------
    field, unit : str
    observed : dict
        Value and standard error (None if not given) of each observation.
    solutions : tuple of Solution
        All that were found: the fewest swings first, or, for a fit, the best one first.
    method : str
    """

    field: str
    unit: str
    observed: dict[str, tuple[float, float | None]]
    solutions: tuple[Solution, ...]
    method: str

    @property
    def value(self) -> float:
        """Of the first solution."""
        return self.solutions[0].value

    @property
    def motion(self) -> Motion:
        """Of the first solution."""
        return self.solutions[0].motion

    @property
    def standard_error(self) -> float | None:
        """Of the first solution."""
        return self.solutions[0].standard_error

    @property
    def friction_angle_deg(self) -> float | None:
        """Friction angle of the first solution, degrees; None for another field."""
        return angle_deg(self.field, self.value)


def angle_deg(field: str, value: float) -> float | None:
    """What a coefficient of friction is in degrees; None for another field."""
    return math.degrees(math.atan(value)) if field.startswith("friction") and field != "friction.length" else None


def backanalyse(
    scene: Scene,
    *,
    runout: Observed | None = None,
    peak_velocity: Observed | None = None,
    duration: Observed | None = None,
    field: str = "friction",
    bounds: tuple[float, float] | None = None,
) -> BackAnalysis:
    """Find all values of one field with which the scene moves as observed.

    Parameters
    ----------
    scene : Scene
        Its own value of the field does not count.
    runout, peak_velocity, duration : float or tuple of float, optional
        Observed value, or value and standard error; m, m/s, s; signed as `Motion` gives them. One at least. One alone
        is met exactly, several in the sense of least squares.
    field : str, optional
        ``friction``; ``friction.peak`` and so on of a law; ``cohesion``, ``ratio`` or ``pressure`` of the pore water,
        ``xi`` of the drag, also as ``pore_pressure.ratio``, whether the scene has the effect or not; ``radius``,
        ``theta_1``, ``theta_2``, ``dip`` (both angles at once), ``unit_weight``, ``gravity``, ``initial_velocity``.
    bounds : tuple of float, optional
        Where to search; by default a range wide enough for the field.

    Returns
    -------
    BackAnalysis

    Raises
    ------
    Unattainable
        If no value in the range explains the observation: says what is attainable, and at which values.
    ValueError
        For mistakes in the arguments.

    Notes
    -----
    Run-out and peak velocity fall with friction as long as the mass does not turn back: E(x) does, at every x. Weak
    friction lets it swing, and the same run-out then has several solutions; motions of more than 12 swings are left
    out (60 in the closed form). Scenes that are integrated in time are slow, and searched on a coarser grid: give
    bounds.
    """
    observed = _observations({"runout": runout, "peak_velocity": peak_velocity, "duration": duration})
    change = _Field(scene, field)
    if list(observed) == ["runout"] and bounds is None and _tilted_pendulum(change):
        values = _by_pendulum(change, observed["runout"][0])
        if values:
            found = [_solution(change, v, observed) for v in values]
            return BackAnalysis(change.name, change.unit, observed, tuple(found), CLOSED)
    curve = _Curve(change, observed, change.range() if bounds is None else _between(*bounds))
    values = curve.roots() if len(observed) == 1 else curve.minima()
    if not values:
        raise _unattainable(curve, observed)
    solutions = [_solution(change, v, observed) for v in values]
    if len(observed) == 1:
        solutions.sort(key=lambda s: (len(s.motion.phases), -s.value))
        return BackAnalysis(change.name, change.unit, observed, tuple(solutions), ROOT)
    solutions.sort(key=lambda s: s.chi_square)
    best = solutions[0].chi_square
    known = all(sigma is not None for _, sigma in observed.values())
    limit = best + 9.0 if known else 4 * best + 1e-20  # three standard errors; without them, twice the misfit
    kept = tuple(s for s in solutions if s.chi_square <= limit)
    return BackAnalysis(change.name, change.unit, observed, kept, FITTED)


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


# --- the field -----------------------------------------------------------------------------------------------------


class _Field:
    """One number of a scene that can be changed."""

    def __init__(self, scene: Scene, name: str) -> None:
        self.scene = scene
        if scene.shape:
            raise ValueError("backanalyse: takes one scene of plain numbers, not an ensemble")
        every = [
            (e.name, p) for e in EFFECTS.values() for p in e.parameters if p.kind in ("number", "series") and p.key
        ]
        effects = {f"{e}.{p.name}": p for e, p in every}
        names = [p.name for _, p in every]
        short = {p.name: f"{e}.{p.name}" for e, p in every if names.count(p.name) == 1}
        known = dict(OF_SCENE) | {"dip": "rad"}
        if law_name(scene.friction) != "constant":
            del known["friction"]
        known |= {n: "" for n in scene.numbers if n.startswith("friction.")}
        known |= {n: unit for n, unit in (("friction.length", "m"), ("friction.velocity", "m/s")) if n in known}
        self.name = short.get(name, name)
        if self.name not in known and self.name not in effects:
            listed = ", ".join([*known, *(n for n in effects if n not in short.values()), *short])
            raise ValueError(f"backanalyse: field = {name!r}: must be one of {listed}")
        if scene.arc.given is not None and self.name in ("theta_1", "theta_2", "dip"):
            raise ValueError(f"backanalyse: field = {name!r}: the arc's coefficients are given, and do not follow it")
        self.unit = known[self.name] if self.name in known else effects[self.name].unit

    def scene_with(self, value: float) -> Scene:
        """The scene with this value."""
        scene, arc = self.scene, self.scene.arc
        head, _, tail = self.name.partition(".")
        if self.name in ("friction", "initial_velocity"):
            return replace(scene, **{self.name: value})  # type: ignore[arg-type]
        if head == "friction":
            assert isinstance(scene.friction, Mapping)
            return replace(scene, friction={**scene.friction, tail: value})
        if self.name == "dip":
            turn = float(arc.dip) - value
            ends = {n: float(np.asarray(getattr(arc, n))) + turn for n in ("theta_1", "theta_2")}
            return replace(scene, arc=replace(arc, **ends))  # type: ignore[arg-type]
        if tail:
            return replace(scene, effects={**scene.called, head: {**scene.called.get(head, {}), tail: value}})
        return replace(scene, arc=replace(arc, **{self.name: value}))  # type: ignore[arg-type]

    def range(self) -> list[float]:
        """Where its value may lie, closer where motions change faster."""
        arc = self.scene.arc
        now = {
            n: float(np.asarray(getattr(arc, n))) for n in ("radius", "unit_weight", "gravity", "theta_1", "theta_2")
        }
        stress = float(arc.static_normal_stress)
        speed = 2 * math.sqrt(now["gravity"] * now["radius"])
        end = 1.0 - 10.0 ** -np.arange(2.0, 13.0, 2.0)
        linear = np.concatenate([np.linspace(0.0, 1.0, 41)[:-1], end])
        wide = np.geomspace(1e-3, 1e3, 61)
        ranges: dict[str, Callable[[], Any]] = {
            "friction": self._frictions,
            "initial_velocity": lambda: np.linspace(-speed, speed, 121),
            "dip": lambda: np.pi / 2 * np.concatenate([-linear[:0:-1], linear]),
            "theta_1": lambda: now["theta_2"] - np.pi * linear[1:],
            "theta_2": lambda: now["theta_1"] + np.pi * linear[1:],
            "cohesion.cohesion": lambda: np.concatenate([[0.0], stress * np.geomspace(1e-6, 100.0, 81)]),
            "pore_pressure.ratio": lambda: linear,
            "pore_pressure.pressure": lambda: stress * linear,
            "drag.xi": lambda: now["gravity"] * np.geomspace(1e-3, 1e9, 97),
            "friction.length": lambda: now["radius"] * np.geomspace(1e-9, 10.0, 81),
        }
        if self.name in ranges:
            return sorted(float(v) for v in ranges[self.name]())
        if self.name.startswith("friction.") and not self.unit:
            return self._frictions()
        if self.name not in now and self.name not in self.scene.numbers:
            raise ValueError(f"backanalyse: field = {self.name!r}: give bounds, as the scene has no value of it")
        size = abs(float(np.asarray(self.scene.numbers[self.name]))) or 1.0
        return [float(v) for v in size * wide]

    def _frictions(self) -> list[float]:
        """From none to the limit, beyond which nothing moves from rest."""
        scene = self.scene_with(0.0)
        balance = bind(scene)
        at = balance.position(0.0, -1 if balance.fall < 0.0 else 1)
        limit = float(balance.get("limit_friction", **at)) if balance.get("normal", **at) > 0.0 else 1.0
        limit = max(limit, 1e-6)
        shares = [*np.linspace(0.0, 1.0, 41), *1 / np.arange(1.0, 2 * _MOST_SWINGS + 2, 0.5)]
        shares += [*(1.0 - 10.0 ** -np.arange(2.0, 13.0))]
        if float(np.asarray(scene.initial_velocity)) != 0.0 or self.name != "friction":
            shares += [*np.geomspace(1.0, 1e3, 40)]
        return sorted({float(limit * s) for s in shares})

    def derivative(self, motion: Motion, output: str) -> float:
        """Of an output by the field: exact where there is a closed form, or by differences."""
        try:
            found = motion.sensitivity()
        except ValueError:
            found = None
        if found is not None and self.name == "dip":
            return -found.derivative(output, "theta_1") - found.derivative(output, "theta_2")
        if found is not None and self.name in found.parameters:
            return found.derivative(output, self.name)
        value = _value(motion.plan.scene, self)
        step = 1e-5 * (abs(value) or 1.0)
        ends = [_outputs(solve(self.scene_with(v)), [output])[output] for v in (value - step, value + step)]
        return (ends[1] - ends[0]) / (2 * step)


def _value(scene: Scene, field: _Field) -> float:
    """The field's value in a scene."""
    head, _, tail = field.name.partition(".")
    if tail:
        box = scene.friction if head == "friction" else scene.called[head]
        assert isinstance(box, Mapping)
        return float(box[tail])
    return float(np.asarray(getattr(scene if hasattr(scene, head) else scene.arc, head)))


def _between(low: float, high: float) -> list[float]:
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ValueError(f"backanalyse: bounds = ({low!r}, {high!r}): must be two numbers, the lower one first")
    if low > 0.0 and high > 100 * low:
        return [float(v) for v in np.geomspace(low, high, 101)]
    return [float(v) for v in np.linspace(low, high, 101)]


# --- the closed form -----------------------------------------------------------------------------------------------


def _tilted_pendulum(field: _Field) -> bool:
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


def _by_pendulum(field: _Field, runout: float) -> list[float]:
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


# --- following the field -------------------------------------------------------------------------------------------


def _outputs(motion: Motion, names: Iterable[str]) -> dict[str, float]:
    return {n: float(motion.peak.velocity) if n == "peak_velocity" else float(getattr(motion, n)) for n in names}


@dataclass(frozen=True)
class _Sample:
    """One value of the field, what comes of it, and of what kind the motion is: between two kinds it has a kink."""

    value: float
    outputs: dict[str, float]
    kind: tuple[Any, ...]


class _Curve:
    """What is observed as a function of the field, in smooth pieces."""

    def __init__(self, field: _Field, observed: Mapping[str, tuple[float, float | None]], values: list[float]) -> None:
        self.field, self.observed, self.span = field, observed, values[-1] - values[0]
        self.outputs = [OUTPUTS[n] for n in observed]
        self.costly = plan(field.scene).method == INTEGRATION  # its kinks are found roughly
        values = [*values[:-1:3], values[-1]] if self.costly else values
        samples = [s for v in values if (s := self.at(v)) is not None]
        self.pieces: list[list[_Sample]] = []
        for sample in samples:
            if self.pieces and self.pieces[-1][-1].kind == sample.kind:
                self.pieces[-1].append(sample)
            elif self.pieces:
                self._cut(self.pieces[-1][-1], sample)
            else:
                self.pieces.append([sample])

    @property
    def samples(self) -> Iterable[_Sample]:
        """Of motions, in order."""
        return (s for piece in self.pieces for s in piece if s.kind[0])

    def at(self, value: float) -> _Sample | None:
        """None where there is no such scene, it never rests, or swings too long."""
        try:
            motion = solve(self.field.scene_with(value))
            if len(motion.phases) > _MOST_SWINGS or not (motion.arrested or self.field.scene.end_time is not None):
                return None
            kind = (motion.moves, motion.arrested, *((p.direction, p.solved.start.lifted) for p in motion.phases))
            return _Sample(value, _outputs(motion, self.outputs), kind)
        except ValueError:
            return None

    def _cut(self, low: _Sample, high: _Sample) -> None:
        """Halve between two samples of different kinds until neighbours are all that is left of them."""
        stack = [high]
        while stack:
            high = stack[-1]
            low = self.pieces[-1][-1]
            middle = (low.value + high.value) / 2
            sample = None
            if low.kind != high.kind and low.value < middle < high.value and not self._near(low, high):
                sample = self.at(middle)
            if sample is None:
                stack.pop()
                if low.kind == high.kind:
                    self.pieces[-1].append(high)
                else:
                    self.pieces.append([high])
            elif sample.kind == low.kind:
                self.pieces[-1].append(sample)
            else:
                stack.append(sample)

    def _near(self, low: _Sample, high: _Sample) -> bool:
        """Whether they are so near that no solution hides between them."""
        gap, size = high.value - low.value, max(abs(low.value), abs(high.value), 1e-12 * self.span)
        if gap <= 4 * _EPS * size:
            return True
        if self.costly:
            return gap <= 1e-4 * size
        if gap > 1e-6 * size:
            return False
        return all(
            min(abs(s.outputs[OUTPUTS[n]] - value) for s in (low, high)) > 1e-3 * abs(value)
            for n, (value, _) in self.observed.items()
        )

    def roots(self) -> list[float]:
        """All values with the one observation."""
        ((name, (wanted, _)),) = self.observed.items()
        output = OUTPUTS[name]

        def miss(value: float) -> float:
            sample = self.at(value)
            return math.nan if sample is None else sample.outputs[output] - wanted

        found: list[float] = []

        def bracket(low: float, high: float, at_low: float, at_high: float) -> None:
            value = root(miss, low, high, at_low, at_high)
            if abs(miss(value)) <= 1e-9 * abs(wanted):  # no jump
                found.append(value)

        for piece in self.pieces:
            if not piece[0].kind[0]:
                continue
            misses = [s.outputs[output] - wanted for s in piece]
            values = [s.value for s in piece]
            found += [v for v, m in zip(values, misses, strict=True) if m == 0.0]
            for k in range(1, len(piece)):
                if misses[k - 1] * misses[k] < 0.0:
                    bracket(values[k - 1], values[k], misses[k - 1], misses[k])
            for k in range(1, len(piece) - 1):  # a hump that reaches over the observation between two samples
                sign = -1.0 if misses[k] > 0.0 else 1.0
                before, here, after = (sign * m for m in misses[k - 1 : k + 2])
                if before <= here >= after and here < 0.0 <= 2 * here - min(before, after):
                    top = highest(lambda v, sign=sign: sign * miss(v), values[k - 1], values[k + 1])  # type: ignore[misc]
                    if sign * miss(top) > 0.0:
                        bracket(values[k - 1], top, misses[k - 1], miss(top))
                        bracket(top, values[k + 1], miss(top), misses[k + 1])
        return sorted(found)

    def minima(self) -> list[float]:
        """Where the observations are best met, in the sense of least squares, in each smooth piece."""
        try:
            from scipy.optimize import least_squares
        except ImportError as error:
            raise ImportError("several observations need SciPy: pip install 'slipcircle[scenes]'") from error
        found = []
        sizes = np.array([sigma or abs(value) for value, sigma in self.observed.values()])
        outputs = self.outputs
        wanted = np.array([value for value, _ in self.observed.values()])
        for piece in self.pieces:
            if not piece[0].kind[0]:
                continue
            misfit = [float(np.sum(((np.array([s.outputs[o] for o in outputs]) - wanted) / sizes) ** 2)) for s in piece]
            for k, value in enumerate(misfit):
                low, high = max(k - 1, 0), min(k + 1, len(piece) - 1)
                if value > min(misfit[low], misfit[high]):
                    continue
                start, left, right = piece[k].value, piece[low].value, piece[high].value
                if left == right:
                    found.append(start)
                    continue
                unit = right - left

                def residuals(share: Any, left: float = left, unit: float = unit) -> Any:
                    sample = self.at(float(left + unit * share[0]))
                    assert sample is not None
                    return (np.array([sample.outputs[o] for o in outputs]) - wanted) / sizes

                def jacobian(share: Any, left: float = left, unit: float = unit) -> Any:
                    motion = solve(self.field.scene_with(float(left + unit * share[0])))
                    return np.array([[unit * self.field.derivative(motion, o)] for o in outputs]) / sizes[:, None]

                inside = min(max((start - left) / unit, 1e-9), 1.0 - 1e-9)
                fit = least_squares(
                    residuals, [inside], jacobian, bounds=(0.0, 1.0), xtol=1e-15, ftol=1e-15, gtol=1e-15
                )
                found.append(float(left + unit * fit.x[0]))
        return found


def _solution(field: _Field, value: float, observed: Mapping[str, tuple[float, float | None]]) -> Solution:
    motion = solve(field.scene_with(value))
    outputs = _outputs(motion, [OUTPUTS[n] for n in observed])
    residuals = {n: outputs[OUTPUTS[n]] - seen for n, (seen, _) in observed.items()}
    sizes = {n: sigma or abs(seen) for n, (seen, sigma) in observed.items()}
    slope = {n: field.derivative(motion, OUTPUTS[n]) for n in observed}
    chi_square = sum((residuals[n] / sizes[n]) ** 2 for n in observed)
    known = all(sigma is not None for _, sigma in observed.values())
    curvature = sum((slope[n] / sizes[n]) ** 2 for n in observed)
    error = None
    if curvature > 0.0 and known:
        error = 1.0 / math.sqrt(curvature)
    elif curvature > 0.0 and len(observed) > 1:  # from the misfit itself
        error = math.sqrt(chi_square / (len(observed) - 1) / curvature)
    # The motion's own error, carried back; the observations share it.
    carried = [motion.error_estimate * abs(outputs[OUTPUTS[n]]) / abs(slope[n]) for n in observed if slope[n]]
    estimate = min(carried, default=math.inf) / abs(value) if value else math.inf
    return Solution(value, motion, residuals, error, max(estimate, _EPS), chi_square)


def _unattainable(curve: _Curve, observed: Mapping[str, tuple[float, float | None]]) -> Unattainable:
    samples, field = list(curve.samples), curve.field
    unit = f" {field.unit}" if field.unit else ""
    if not samples:
        return Unattainable(f"{field.name}: with no value of it between the bounds does this scene move and rest", {})
    attainable, said = {}, []
    units = {"runout": "m", "peak_velocity": "m/s", "duration": "s"}
    for name, (wanted, _) in observed.items():
        ordered = sorted(samples, key=lambda s, name=name: s.outputs[OUTPUTS[name]])  # type: ignore[misc]
        ends = [(s.outputs[OUTPUTS[name]], s.value) for s in (ordered[0], ordered[-1])]
        attainable[name] = (ends[0], ends[1])
        words = " to ".join(f"{v:.6g} {units[name]} (at {field.name} = {at:.6g}{unit})" for v, at in ends)
        if ends[1][0] - ends[0][0] <= 1e-9 * abs(ends[1][0]):
            words = f"only {ends[0][0]:.6g} {units[name]}, whatever it is"
        said.append(f"{name} = {wanted:.10g} {units[name]}: no {field.name} gives it; attainable: {words}")
    return Unattainable("; ".join(said), attainable)
