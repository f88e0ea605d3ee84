"""Declarations of the quantities of a result: name, unit, label, and attribute of a `Motion`.

JSON, tables, CSV, pictures, reports, sensitivities, studies and back-analyses use these lists.
"""

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, is_dataclass
from functools import partial
from operator import attrgetter
from typing import Any, NamedTuple, Self

import numpy as np

from slipcircle.base import JSON_FORMAT
from slipcircle.base.arrays import real_number
from slipcircle.base.kinds import Floats, Function, Pair, ValueDict
from slipcircle.base.text import DIGITS, digits_left, number_text, output_unit
from slipcircle.messages import OUTSIDE, VelocityTimes, swings_back
from slipcircle.workbench.stability.stability import METHODS, factors_of_safety, soil
from slipcircle.workbench.stability.starting import OF_CLOSURE

_PREFIXES = ((1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"))


def spelt_out(name: str, unit: str = "") -> str:
    """Return the name of a quantity or a status in words, with its unit if given."""
    return name.lower().replace("run_out", "run-out").replace("_", " ") + (f" ({unit})" if unit else "")


@dataclass(frozen=True)
class Quantity:
    """Declaration of a quantity of a result: names, unit, and how it is read and printed."""

    name: str  # in Python, JSON and heads of CSV files
    unit: str  # SI, "" if dimensionless; angles are radians
    label: str  # in words
    path: str  # attribute of a `Motion`, with dots; over time a method of times in s, and an attribute of its result
    degrees: bool = False  # printed as an angle in degrees, from radians or a friction coefficient
    solved: bool = False  # a result with the error `Motion.error_estimate`
    key: bool = False  # in every summary
    point: bool = False  # a point, x and y
    where: Function = lambda motion: True  # whether it is printed
    instead: Callable[[Any], str] = lambda motion: ""  # printed in place of a missing value

    def read(self, motion: Any) -> Any:
        """Return the value in SI units, an array for an ensemble."""
        return attrgetter(self.path)(motion)

    def columns(self, motion: Any) -> ValueDict:
        """Return the value by name; a point becomes two values, ``NAME_x`` and ``NAME_y``."""
        value = self.read(motion)
        return {f"{self.name}_{x}": value[..., k] for k, x in enumerate("xy")} if self.point else {self.name: value}

    def at(self, motion: Any, times: Floats) -> Floats:
        """Return the values of a history quantity at times in s."""
        method, _, part = self.path.partition(".")
        values = getattr(motion, method)(times)
        return np.asarray(getattr(values, part) if part else values, float)

    def text(self, motion: Any) -> str:
        """Return the printed value of a single motion, with as many digits as its error justifies."""
        if not self.where(motion):
            return ""
        if text := self.instead(motion):
            return text
        value = self.read(motion)
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, str):
            return value
        if self.point:
            factor, unit = output_unit(self.unit)
            return f"{', '.join(map(number_text, (factor * np.asarray(value)).tolist()))} {unit}"
        value, unit = self.seen(value)
        return f"{number_text(value, digits_left(motion.error_estimate) if self.solved else DIGITS)} {unit}".rstrip()

    def seen(self, value: float) -> tuple[float, str]:
        """Return a value converted to the printed unit, and that unit."""
        if self.degrees:
            return math.degrees(value if self.unit else math.atan(value)), "deg"
        factor, unit = prefixed(value, self.unit)
        return value * factor, unit

    @property
    def heading(self) -> str:
        """Name in words with the unit of output, for headings of tables."""
        return spelt_out(self.name, output_unit(self.unit)[1])

    @property
    def head(self) -> str:
        """Name with the unit as an identifier, for headers of CSV columns."""
        return "_".join(filter(None, (self.name, self.unit.replace("/", "_").replace("^", ""))))


def _in_summary(_: Any) -> bool:
    """Return False: the quantity is not printed alone, because the summary includes it in a sentence."""
    return False


def _not_slow(motion: Any) -> str:
    """Return in words why the run-out of a slow motion is not given; "" if it is."""
    return motion.no_slow_run_out and f"not given: {motion.no_slow_run_out}"


def _by_method(name: str, motion: Any) -> str:
    """Return a further factor of safety, "residual" or "at_rest", and its method in words; "" if it is unknown."""
    further = motion.further_factors
    factor = getattr(further, name)
    method = getattr(further, f"{name}_method")
    scaled = "" if method or motion.plan.scene.strength_factor == 1.0 else ", with the strength factor of the start"
    return f"{number_text(factor)} by {METHODS[method or OF_CLOSURE][0]}{scaled}" if math.isfinite(factor) else ""


def factor_label(method: str) -> str:
    """Return the label of the factor of safety by a method."""
    return f"factor of safety by {METHODS[method][0]}"


RESULTS: tuple[Quantity, ...] = (
    Quantity("moves", "", "moves", "moves"),
    Quantity("arrested", "", "comes to rest", "arrested"),
    Quantity("run_out", "m", "run-out along the arc", "run_out", solved=True, key=True),
    Quantity("run_out_time", "s", "time of the run-out", "farthest.time", solved=True),
    Quantity("end_displacement", "m", "displacement at the end", "end.displacement", solved=True, where=swings_back),
    Quantity("peak_velocity", "m/s", "peak velocity", "peak.velocity", solved=True, key=True),
    Quantity("peak_time", "s", "time of the peak velocity", "peak.time", solved=True),
    Quantity("duration", "s", "duration", "duration", solved=True, key=True),
    Quantity("outside_range", "", OUTSIDE, "outside_range", where=_in_summary),
    Quantity("factor_of_safety", "", "factor of safety at the start", "factor_of_safety", where=_in_summary),
    Quantity("yield_coefficient", "", "yield coefficient k_y", "yield_coefficient"),
    Quantity("friction", "", "friction angle", "friction", degrees=True),
    Quantity("limit_friction", "", "limit friction angle", "limit_friction", degrees=True),
    Quantity("end_rotation", "rad", "rotation at the end", "end.rotation", degrees=True, solved=True),
    Quantity("end_velocity", "m/s", "velocity at the end", "end.velocity", solved=True),
    Quantity("peak_displacement", "m", "displacement at the peak velocity", "peak.displacement", solved=True),
    Quantity("start_stress", "Pa", "mean normal stress at the start", "plan.scene.arc.static_normal_stress"),
    Quantity("peak_stress", "Pa", "mean normal stress at the peak velocity", "peak.normal_stress", solved=True),
    Quantity("end_stress", "Pa", "mean normal stress at the end", "end.normal_stress", solved=True),
)
# For single motions only: for an ensemble these take a hundred times as long as the solution itself.
SINGLE: tuple[Quantity, ...] = (
    Quantity("slow_run_out", "m", "run-out if moved slowly", "slow_run_out", solved=True, instead=_not_slow),
    Quantity(
        "residual_factor_of_safety",
        "",
        "factor of safety with residual strength",
        "further_factors.residual",
        instead=partial(_by_method, "residual"),
    ),
    Quantity(
        "final_factor_of_safety",
        "",
        "factor of safety at rest after the slide",
        "further_factors.at_rest",
        instead=partial(_by_method, "at_rest"),
    ),
    Quantity("velocity_class", "", "velocity class by Cruden and Varnes", "velocity_class"),
    *(
        Quantity(f"time_{name}", "s", f"time {spelt_out(name)}", path, where=attrgetter(path))
        for name in VelocityTimes._fields
        for path in [f"velocity_times.{name}"]
    ),
)
JOURNEY: tuple[Quantity, ...] = (
    Quantity("toe_run_out", "m", "horizontal run-out of the toe", "journey.run_out", solved=True),
    Quantity("toe_rise", "m", "rise of the toe", "journey.rise", solved=True),
    Quantity("centroid_travel", "m", "horizontal travel of the centroid", "journey.travel", solved=True),
    Quantity("crest_drop", "m", "drop of the crest", "journey.crest_drop", solved=True),
    Quantity("fall", "m", "fall of the centroid", "journey.fall", solved=True),
    Quantity(
        "travel_angle",
        "rad",
        "travel angle of the centroid",
        "journey.travel_angle",
        degrees=True,
        solved=True,
        instead=lambda motion: "" if motion.moves else "-",
    ),
)
# For sections, which have a position.
POSITION: tuple[Quantity, ...] = (
    Quantity("area", "m^2", "area of the section", "plan.scene.arc.area"),
    Quantity("mass_per_metre", "kg/m", "mass per unit width", "plan.scene.arc.mass_per_metre"),
    Quantity("chord", "m", "chord of the slip circle under the mass", "plan.scene.arc.chord"),
    Quantity("depth", "m", "greatest thickness of the mass", "plan.scene.arc.depth"),
    Quantity("entry", "m", "upper end of the slip surface, x and y", "plan.scene.arc.entry", point=True),
    Quantity("exit", "m", "lower end of the slip surface, x and y", "plan.scene.arc.exit", point=True),
    Quantity("centroid", "m", "centroid at the start, x and y", "plan.scene.arc.centroid", point=True),
    Quantity("toe_x", "m", "x of the toe at the run-out", "journey.toe_x", solved=True),
    Quantity("toe_y", "m", "y of the toe at the run-out", "journey.toe_y", solved=True),
)


def results(motion: Any) -> tuple[Quantity, ...]:
    """Return the quantities that a motion has, which depend on its section and on whether it is an ensemble."""
    of_one = () if motion.shape else SINGLE
    of_section = POSITION if "ground" in motion.plan.scene.arc.quantities else ()
    return (*RESULTS, *of_one, *of_section, *JOURNEY)


def factors_by_method(scene: Any, of_motion: Any) -> ValueDict:
    """Return factors of safety at the start by method.

    A scene on a ground with known strength has the factors of all methods. Other scenes have only the closure's factor,
    derived from the factor of a motion with its strength factor, ``of_motion``.
    """
    if "ground" in scene.arc.quantities and soil(scene.friction, scene.effects):
        by_method = factors_of_safety(scene)
        return {method: by_method[method] for method in METHODS}
    return {OF_CLOSURE: np.divide(of_motion, scene.strength_factor)}


def factors_of(motion: Any) -> ValueDict:
    """Return the factors of safety of a motion at its start by method; floats for a single motion, else arrays."""
    by_method = factors_by_method(motion.plan.scene, motion.factor_of_safety)
    return by_method if motion.shape else {method: float(factor) for method, factor in by_method.items()}


def factor_text(factor: float | None) -> str:
    """Return a factor of safety in words, or "refused" if its method rejects the circle."""
    return "refused" if factor is None or math.isnan(factor) else number_text(factor)


# Results of ensembles and derivatives, available for every scene.
OUTCOMES: Mapping[str, Quantity] = {q.name: q for q in RESULTS if q.name in ("run_out", "peak_velocity", "duration")}
# Results that may be observed, or be the target of a back-analysis.
_SEEN = "run_out end_displacement peak_velocity duration toe_rise toe_x crest_drop centroid_travel factor_of_safety"
_BY_NAME = {q.name: q for q in (*RESULTS, *JOURNEY, *POSITION)}
OBSERVABLE: Mapping[str, Quantity] = {name: _BY_NAME[name] for name in _SEEN.split()}


def observable(motion: Any, name: str) -> Any:
    """Return a quantity of `OBSERVABLE` of a motion by its name; an array for an ensemble."""
    return motion.outcomes[name] if name in OUTCOMES else OBSERVABLE[name].read(motion)


class Interval(NamedTuple):
    """Observed interval of a quantity, with a uniform distribution between its ends.

    A back-analysis uses its middle with the standard error of a uniform distribution, width / sqrt(12). An interval
    with one infinite end is a limit, ``Interval(-math.inf, 60.0)``.

    Attributes
    ----------
    low, high : float
        Ends of the interval in SI units, with low first.
    """

    low: float
    high: float

    @property
    def middle(self) -> float:
        """Middle of the interval."""
        return (self.low + self.high) / 2

    @property
    def standard_error(self) -> float:
        """Standard error of a uniform distribution; negative if the ends are reversed."""
        return (self.high - self.low) / math.sqrt(12.0)

    def times(self, factor: float) -> Self:
        """Return the interval in another unit."""
        return type(self)(factor * self.low, factor * self.high)

    @classmethod
    def of_limit(cls, text: str) -> Self:
        """Return the interval for a limit in a text such as "<60" or ">60"; both ends are NaN for another text."""
        try:
            end = float(text[1:])
        except ValueError:
            end = math.nan
        ends = {"<": (-math.inf, end), ">": (end, math.inf)}
        return cls(*ends.get(text[:1], (math.nan, math.nan)))

    @property
    def limit(self) -> float | None:
        """Finite end of an interval with one infinite end, else None."""
        low, high = (math.isinf(real_number(end)) for end in self)
        return None if low == high else self.high if low else self.low

    def __str__(self) -> str:
        """Return the interval as text, such as "at most 60"."""
        if self.limit is not None:
            return f"{'at least' if self.limit == self.low else 'at most'} {number_text(self.limit, 6)}"
        return f"{number_text(self.low, 6)} to {number_text(self.high, 6)}"


Observed = float | Pair | Interval
HISTORY: Mapping[str, Quantity] = {
    q.name: q
    for q in (
        Quantity("time", "s", "time", "at.time"),
        Quantity("rotation", "rad", "rotation", "at.rotation", degrees=True),
        Quantity("angular_velocity", "rad/s", "angular velocity", "at.angular_velocity"),
        Quantity("velocity", "m/s", "velocity", "at.velocity"),
        Quantity("displacement", "m", "displacement", "at.displacement"),
        Quantity("acceleration", "m/s^2", "acceleration", "at.acceleration"),
        Quantity("path", "m", "path travelled", "path_at"),
        Quantity("normal_stress", "Pa", "mean normal stress", "at.normal_stress"),
        Quantity("effective_stress", "Pa", "mean effective stress", "effective_stress_at"),
        Quantity("friction", "", "friction coefficient", "friction_at"),
        Quantity("holding_friction", "", "friction coefficient required for equilibrium", "holding_friction_at"),
        Quantity("strength", "Pa", "mobilised strength", "strength_at.mobilised"),
        Quantity("required_strength", "Pa", "strength required for equilibrium", "strength_at.required"),
        Quantity("kinetic_energy", "J", "kinetic energy", "energy_at.kinetic_end"),
        Quantity("work_of_gravity_and_shaking", "J", "work of gravity and shaking", "energy_at.work"),
        Quantity("dissipation", "J", "dissipation", "energy_at.dissipation"),
    )
}


def json_values(value: Any) -> Any:
    """Return a value converted to types of JSON, with numbers that are not finite replaced by None."""
    if is_dataclass(value) and not isinstance(value, type):
        return json_values(asdict(value))
    if isinstance(value, Mapping):
        return {str(k): json_values(v) for k, v in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return json_values(value.tolist())
    if isinstance(value, list | tuple):
        return [json_values(v) for v in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def json_text(record: Any) -> str:
    """Return a record or a list of records as JSON text, each with its format version first (except a schema)."""
    content = json_values(record)
    many = [content] if isinstance(content, dict) else content
    stamped = [one if "$schema" in one else {"format": JSON_FORMAT} | one for one in many]
    return json.dumps(stamped if many is content else stamped[0], indent=2, allow_nan=False)


def to_error(value: float, error: float) -> str:
    """Return a number in words, to two digits of its error in the same unit; by `number_text` without an error."""
    if not error > 0.0:
        return number_text(value)
    last = math.floor(math.log10(error)) - 1  # position of the last digit
    if last > -6:
        return f"{value:z.{max(-last, 0)}f}"
    digits = math.floor(math.log10(abs(value))) - last + 1 if value else 0
    return number_text(value, digits) if digits > 0 else "0"


def time_text(nanoseconds: float) -> str:
    """Return a measured time in words to three digits, in ns, us or ms."""
    per, unit = next(((p, u) for p, u in ((1e6, "ms"), (1e3, "us")) if nanoseconds >= p), (1.0, "ns"))
    return f"{number_text(nanoseconds / per, 3)} {unit}"


def prefixed(values: Any, unit: str) -> tuple[float, str]:
    """Return the factor from an SI unit to a convenient unit for stresses, energies and forces, and that unit's name.

    The greatest of the values, in the SI unit, determines the prefix.
    """
    size = float(np.max(np.abs(values), initial=0.0))
    factor, name = output_unit(unit)
    if name == "psf" and factor * size >= 1e3:
        return factor / 1e3, "ksf"
    if name != unit or unit not in ("Pa", "J", "N") or size == 0.0 or not math.isfinite(size):
        return factor, name
    per, prefix = next(((p, name) for p, name in _PREFIXES if size >= p), (1.0, ""))
    return 1.0 / per, prefix + unit
