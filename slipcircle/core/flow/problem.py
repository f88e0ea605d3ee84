"""The problem that the integrator solves: a scene's flow program, its tables, and the initial cells of lanes.

The scene's SI numbers are made dimensionless here, by the declarations in `generated.effects`.
"""

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from generated import layout as ix
from generated.effects import ALL_EFFECTS, LAWS
from generated.flow import INPUTS, PIECES
from slipcircle.base.checks import choose, plain
from slipcircle.core.flow import tables
from slipcircle.core.flow.build import build_program
from slipcircle.core.flow.interpolation import TERMS, between_kinks, sampled
from slipcircle.core.flow.layered import FINEST as FINEST_TABLES
from slipcircle.core.flow.layered import RotationTables, upright
from slipcircle.core.flow.program import Program
from slipcircle.core.flow.tables import Data
from slipcircle.core.scene.arc import Arc
from slipcircle.core.scene.forcing import factor as factor_of
from slipcircle.core.scene.friction import law_parts, soil_number, without_soil
from slipcircle.core.scene.layers import LayeredSection
from slipcircle.core.scene.section import Section
from slipcircle.core.scene.strength import OfRotation

Floats = NDArray[np.float64]
Effects = Mapping[str, Mapping[str, Any]]  # by name, each with its parameters
FINEST = 1e-14  # accuracy to which single scenes are solved
LOWEST = 5  # order, as the radius of convergence compares the last coefficients with the first five
UPLIFT = frozenset(("pore_pressure", "thermal_pressurisation"))
STEP = math.exp(-2.0)  # of the radius of convergence, so that a series of order n leaves exp(-2 n)


class Recipe(NamedTuple):
    """The first arguments of `build_program`."""

    effects: tuple[str, ...]
    laws: tuple[str, ...]
    moving: tuple[str, ...]
    absent: tuple[str, ...]


class Problem(NamedTuple):
    """Arguments of `integrate`, and the scales that make times and lengths dimensionless."""

    program: Program
    tables: list[Data]
    cells: Floats
    time_scale: Any
    functions: Mapping[int, Callable[[Any], Any]]  # of slip, given in Python, by the place of their table
    recipe: Recipe
    outputs: tuple[str, ...] = ()  # further ones of the program
    rotations: RotationTables | None = None  # tables that may be laid out farther

    def with_outputs(self, outputs: tuple[str, ...] = (), directions: int = 0) -> "Problem":
        """The same lanes with further outputs, or with derivatives in some directions."""
        return self._with_program(build_program(*self.recipe, outputs, directions))._replace(outputs=outputs)

    def with_steady_shaking(self) -> "Problem":
        """The same lanes with a constant horizontal coefficient, initially 0, in place of their shaking."""
        recipe = self.recipe
        shaking = {p.symbol for p in ALL_EFFECTS["shaking"].parameters}
        with_shaking = in_order(tuple(dict.fromkeys((*recipe.effects, "shaking"))))
        moving = tuple(symbol for symbol in recipe.moving if symbol not in shaking)
        absent = [symbol for symbol in recipe.absent if symbol not in shaking]
        program = build_program(with_shaking, recipe.laws, moving, (*absent, "k_v"))
        return self._with_program(program)._replace(rotations=None)

    def _with_program(self, program: Program) -> "Problem":
        """The same numbers for another program."""
        cells = program.blank(self.cells.shape[1])
        there, here = common_cells(program, self.program)
        cells[there] = self.cells[here]
        names = [table.name for table in self.program.tables]
        data = dict(zip(names, self.tables, strict=True))
        tables = [data[table.name] for table in program.tables]
        return self._replace(program=program, cells=cells, tables=tables)

    def extend_tables(self, cells: Floats) -> None:
        """Extend the tables of Python functions to the slip of the lanes."""
        for k, function in self.functions.items():
            first_cell = self.program.tables[k].cells
            slip = cells[ix.SLIP] * cells[first_cell + ix.SCALE]
            farthest = float(np.max(slip)) * (1.0 + 1e-12)
            table = self.tables[k]
            end = float(table.breaks[-1])
            while end <= farthest:
                table = sampled(function, 2 * end, table)
                end = float(table.breaks[-1])
            self.tables[k] = table

    def extend_rotations(self, rotation: Floats) -> bool:
        """Extend functions of the rotation to their full range if a lane exceeds their tables; whether one does."""
        if self.rotations is None:
            return False
        place = {table.name: k for k, table in enumerate(self.program.tables)}
        ends = [self.tables[place[name]].breaks[-1] for name in self.rotations.functions]
        if not any(np.any(rotation > end + 1e-9) for end in ends):
            return False
        for name, data in self.rotations.laid_out().items():
            self.tables[place[name]] = data
        return True

    def initial_cells(self) -> Floats:
        """A copy of the cells at the start."""
        return self.cells.copy()


@lru_cache(maxsize=256)
def common_cells(program: Program, other: Program) -> tuple[Any, Any]:
    """Places of the inputs that two programs have in common, in each of them."""
    names = [name for name in program.cells[: program.given] if name in other.places]
    places = [program.places[name] for name in names]
    other_places = [other.places[name] for name in names]
    return np.array(places), np.array(other_places)


def order(accuracy: float) -> int:
    """Order of the series with a truncation error below an accuracy, at steps of exp(-2) radii of convergence."""
    digits = -math.log(max(accuracy, 1e-16))
    return max(math.ceil(3.0 + digits / 2.0), LOWEST)


def build_problem(
    arc: Arc | Section, called: Effects, friction: Any, velocity: Any, end_time: Any, accuracy: float, lanes: int
) -> Problem:
    """Build the problem of scenes that share their effects and laws.

    Parameters
    ----------
    arc : Arc or Section
        Its fields, like all numbers here, are numbers or arrays of one value a lane.
    called : mapping
        Effects by name, each with its parameters; functions of time are `Series` or `Pulse`.
    friction : float, array, mapping or callable
        As a `Scene` takes it.
    velocity, end_time : float or ndarray
        m/s and s; infinite where there is no end.
    accuracy : float
        Relative error asked for.
    lanes : int
        Number of scenes.

    Returns
    -------
    Problem
    """
    laws = law_parts(friction)
    recipe = recipe_of(called, tuple(name for name, _ in laws))
    effects = recipe.effects
    rotating = rotates(effects)
    upslope = "shaking" in effects or bool(np.any(velocity != 0.0))
    tolerance = FINEST_TABLES if lanes == 1 else accuracy / 100
    numbers = _Numbers(arc, upslope, tolerance)
    for effect in effects:
        numbers.add_effect(effect, called[effect], rotating)
    if isinstance(arc, LayeredSection):
        numbers.add_layers({effect: called[effect] for effect in effects if effect in called}, friction)
    for name, parameters in laws:
        numbers.add_law(name, parameters)
    numbers.add_start(velocity, end_time)
    inputs = numbers.inputs
    inputs["ONE_WAY"] = _one_way(called.get("shaking", {}))
    first_only = _first_only({*effects, *recipe.moving}, laws, inputs)
    inputs["FIRST_ONLY"] = choose(end_time == np.inf, first_only, 0.0)
    # The steps of one scene cost next to nothing, whatever their order.
    inputs["ORDER"] = order(min(accuracy, FINEST) if lanes == 1 else accuracy)
    return _assembled(numbers, recipe, lanes)


def _assembled(numbers: "_Numbers", recipe: Recipe, lanes: int) -> Problem:
    """A problem from its numbers and tables, each in the place that its program has for it."""
    program = build_program(*recipe)
    places = program.places
    cells = program.blank(lanes)
    for name, value in numbers.inputs.items():
        if name in places:
            cells[places[name]] = value
    data = list[Data]()
    functions: dict[int, Callable[[Any], Any]] = {}
    for k, table in enumerate(program.tables):
        table_data, scale, factor = numbers.tables[table.name]
        data.append(table_data)
        cells[table.cells + ix.SCALE] = scale
        cells[table.cells + ix.SCALED_BY] = factor
        if table.name in numbers.functions:
            functions[k] = numbers.functions[table.name]
    return Problem(program, data, cells, numbers.time_scale, functions, recipe, rotations=numbers.rotations)


def recipe_of(called: Effects, laws: tuple[str, ...]) -> Recipe:
    """The recipe of scenes with these effects and laws."""
    effects = in_order(tuple(called))
    moving = list[str]()
    absent = list[str]()
    for effect in effects:
        for name, symbol in symbols_of(effect).items():
            value = called[effect].get(name)
            if value is None:
                absent.append(symbol)
            elif callable(value):
                moving.append(symbol)
    if "layered_strength" in effects and "shaking" not in effects:
        absent += ["k_h", "k_v"]  # which its terms contain, too
    return Recipe(effects, laws, tuple(moving), tuple(absent))


@lru_cache(maxsize=256)
def in_order(effects: tuple[str, ...]) -> tuple[str, ...]:
    """Effects by name in the order in which they are declared."""
    return tuple(name for declared in ALL_EFFECTS for name in effects if without_soil(name) == declared)


@lru_cache(maxsize=256)
def symbols_of(effect: str) -> dict[str, str]:
    """Symbols of an effect's parameters in the balance, by their names; of one soil with its number."""
    declared = ALL_EFFECTS[without_soil(effect)].parameters
    return {p.name: f"{p.symbol}{soil_number(effect)}" for p in declared if p.symbol}


@dataclass
class _Numbers:
    """Dimensionless numbers and tables of a scene, by their names in its program."""

    arc: Arc | Section
    upslope: bool  # whether the mass may move beyond where it began
    tolerance: float  # of tables of the rotation
    functions: dict[str, Callable[[Any], Any]] = field(default_factory=dict)
    # Of each table: its data, the scale of its argument, the factor of its values.
    tables: dict[str, tuple[Data, Any, Any]] = field(default_factory=dict)
    rotations: RotationTables | None = None

    def __post_init__(self) -> None:
        self.time_scale, self.radius = plain(self.arc.time_scale), plain(self.arc.radius)
        coefficients = self.arc.moment_coefficients
        self.inputs: dict[str, Any] = {name: getattr(coefficients, name) for name in INPUTS}

    def add_start(self, velocity: Any, end_time: Any) -> None:
        """Add the initial velocity, the end time, and initial values of the integrator's records."""
        with np.errstate(over="ignore"):  # what overflows is refused where it is asked for
            self.inputs["omega"] = velocity / self.radius * self.time_scale
            self.inputs["END_TIME"] = end_time / self.time_scale
        self.inputs["LIMIT"] = abs(self.arc.moment_coefficients.limit_friction)
        self.inputs |= {"FACTOR": STEP, "CLOSE": np.inf, "LIFT_TIME": np.nan}

    def add_effect(self, effect: str, given: Mapping[str, Any], rotating: bool) -> None:
        """Add the parameters of an effect: numbers by their symbols, functions of time or of the rotation as tables."""
        declared = ALL_EFFECTS[without_soil(effect)].parameters
        symbols = symbols_of(effect)
        in_balance = [p for p in declared if p.symbol]
        if not in_balance:
            return
        numbers = {p.name: given.get(p.name, 0.0) for p in declared if p.kind == "number"}
        scales = scales_of(self.arc) | numbers
        for p in in_balance:
            value = given.get(p.name, 0.0)
            if isinstance(value, OfRotation):
                continue  # `add_layers` lays out all of these together
            if not callable(value):
                self.inputs[symbols[p.name]] = p.dimensionless(value, scales)
            elif p.kind == "rotation":
                assert isinstance(self.arc, Section)
                unit = p.dimensionless(1.0, scales)
                self.tables[p.symbol] = self._under_water(rotating), 1.0, unit
            else:
                factor = p.dimensionless(factor_of(effect, given, p.name), scales)
                self.tables[p.symbol] = tables.of_time(value), self.time_scale, factor

    def _under_water(self, rotating: bool) -> Data:
        """Mean pore pressure below a section's water level, Pa, as a function of the rotation until contact is lost."""
        section = self.arc
        assert isinstance(section, Section)

        def pressure(rotation: Any) -> Any:
            return section.mean_pressure(rotation if section.shape else rotation[:, 0]).reshape(1, *rotation.shape)

        last = upright(section)
        if rotating:
            first = last - np.pi if self.upslope else np.zeros_like(last)
            kinks = np.atleast_2d(section.pressure_kinks).T
            breaks, values = between_kinks(pressure, kinks, first, last, self.tolerance)
        else:
            breaks = np.zeros((1, last.size))
            values = np.zeros((1, TERMS, 1, last.size))
            values[0, 0] = pressure(breaks)[:, 0]
        jumps = np.zeros(len(breaks))
        if section.shape:
            return Data(breaks, np.ascontiguousarray(values[:, :, 0]), jumps)
        return Data(breaks[:, 0], values[:, :, 0, 0], jumps)

    def add_layers(self, given: Effects, friction: Any) -> None:
        """Add the functions of the rotation that belong to the soils of a layered section."""
        assert isinstance(self.arc, LayeredSection)
        functions = {
            symbols_of(effect)[name]: term
            for effect, terms in given.items()
            for name, term in terms.items()
            if isinstance(term, OfRotation)
        }
        terms = given["layered_strength"]
        rotations = RotationTables(self.arc, terms, functions, self.tolerance, self.upslope)
        if not rotations.functions:
            return
        self.rotations = rotations
        laid_out = rotations.laid_out(rotations.likely_reach(friction))
        for name, table in laid_out.items():
            self.tables[name] = table, 1.0, 1.0

    def add_law(self, name: str, given: Mapping[str, Any]) -> None:
        """Add a friction law: a table, or dimensionless numbers by its name."""
        law = without_soil(name)
        if law == "callable":
            function = given["function"]
            first_slip = float(np.max(self.radius)) / 256
            self.functions[name] = function
            self.tables[name] = sampled(function, first_slip), self.radius, 1.0
            return
        if law in PIECES:
            length = given[PIECES[law][0]]
            self.tables[name] = tables.of_law(law, given), self.radius / length, 1.0
            return
        declared = LAWS[law]
        speed = self.radius / self.time_scale
        if declared.parameters[0].kind == "list":
            (argument,) = declared.depends_on
            places, values = (np.asarray(given[p.name], dtype=np.float64) for p in declared.parameters)
            scales = {"slip": self.radius, "speed": speed, "time": self.time_scale}
            self.tables[name] = tables.of_list(argument, places, values), scales[argument], 1.0
            return
        units = {"m": self.radius, "m/s": speed, "": 1.0}
        for p in declared.parameters:
            self.inputs[f"{name}.{p.name}"] = given[p.name] / units[p.unit]


def scales_of(arc: Arc | Section) -> dict[str, Any]:
    """Scales of an arc by which parameters of effects are made dimensionless, SI."""
    return {
        "half_angle": arc.half_angle,
        "gravity": arc.gravity,
        "reference_stress": arc.reference_stress,
        "Theta": arc.dimensionless.moment_of_inertia,
        "radius": plain(arc.radius),
        "density": plain(arc.mean_unit_weight) / plain(arc.gravity),
        "cover": arc.moment_coefficients.cover,
    }


def rotates(effects: Iterable[str]) -> bool:
    """Whether an effect lets the mass rotate."""
    return any(ALL_EFFECTS[effect].turns for effect in effects)


def _one_way(shaking: Mapping[str, Any]) -> float:
    """1 where shaking may start the mass down-slope only."""
    varies = callable(shaking.get("horizontal"))
    two_way = shaking.get("two_way", False)
    return float(varies and not two_way)


def _first_only(terms: Collection[str], laws: Any, inputs: Mapping[str, Any]) -> Any:
    """1 where nothing brings the mass to rest, 2 where water or heat may lift it: integrated to its first standstill.

    ``terms`` are names of effects and symbols of functions.
    """
    turning = rotates(ALL_EFFECTS.keys() & terms)
    if not turning or "layered_cohesion" in terms:
        return 0.0
    (name, parameters), *others = laws
    is_constant = name == "constant" and not others
    frictionless = parameters["coefficient"] == 0.0 if is_constant else False
    swings = choose(frictionless, 1.0, 2.0 if _may_lift(terms, inputs) else 0.0)
    cohesion = inputs.get("cohesion", 0.0) + inputs.get("layered_cohesion", 0.0)
    return choose(cohesion > 0.0, 0.0, swings)


def _may_lift(terms: Collection[str], inputs: Mapping[str, Any]) -> bool:
    """Whether the pressure of water may exceed the normal stress."""
    if not UPLIFT.isdisjoint(terms):
        return True
    of_soils = ("layered_lift", "soil_lift")
    if any(name.startswith(of_soils) for name in terms):
        return True
    return any(np.any(value) for name, value in inputs.items() if name.startswith(of_soils))
