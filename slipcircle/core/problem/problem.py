"""The problem that the integrator solves: a scene's flow program, its tables, and the initial cells of lanes."""

import math
from collections.abc import Callable, Collection, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from generated.effects import ALL_EFFECTS
from slipcircle.base.checks import choose
from slipcircle.base.kinds import Effects, Floats, Names, Parameters
from slipcircle.core.doors import room
from slipcircle.core.problem.numbers import Numbers
from slipcircle.core.program.build import build_program
from slipcircle.core.program.program import Program
from slipcircle.core.scene.effects import in_order, rotates, symbols_of
from slipcircle.core.scene.friction import law_parts, variables_of
from slipcircle.core.scene.mass import Farther, Mass
from slipcircle.core.scene.piecewise import Data

Function = Callable[[Any], Any]
FINEST = 1e-14  # accuracy to which single scenes are solved: lower orders save little, and nothing under long records
LOWEST = 5  # order, as the radius of convergence compares the last coefficients with the first five
UPLIFT = frozenset(("pore_pressure", "thermal_pressurisation"))
UPLIFT_OF_SOILS = ("layered_lift", "soil_lift")  # beginnings of their names


class Recipe(NamedTuple):
    """The first arguments of `build_program`."""

    effects: Names
    laws: Names
    moving: Names
    absent: Names


class Problem(NamedTuple):
    """Arguments of `integrate`, and what they were built from."""

    program: Program
    tables: list[Data]
    cells: Floats
    functions: Mapping[int, Function]  # of slip, given in Python, by the place of their table
    recipe: Recipe
    outputs: Names = ()  # further ones of the program
    farther: Farther | None = None  # lays out functions of the rotation farther

    def with_outputs(self, outputs: Names = (), directions: int = 0) -> "Problem":
        """The same lanes with further outputs, or with derivatives in some directions."""
        program = build_program(*self.recipe, outputs, directions)
        return self._with_program(program)._replace(outputs=outputs)

    def with_steady_shaking(self) -> "Problem":
        """The same lanes with a constant horizontal coefficient, initially 0, in place of their shaking."""
        effects, laws, moving, absent = self.recipe
        shaking = symbols_of("shaking").values()
        effects = in_order((*effects, "shaking"))
        moving = tuple(symbol for symbol in moving if symbol not in shaking)
        others = [symbol for symbol in absent if symbol not in shaking]
        program = build_program(effects, laws, moving, (*others, "k_v"))
        return self._with_program(program)._replace(farther=None)

    def _with_program(self, program: Program) -> "Problem":
        """The same numbers for another program."""
        lanes = self.cells.shape[1]
        cells = program.blank(lanes)
        places, places_here = common_cells(program, self.program)
        cells[places] = self.cells[places_here]
        data = dict[str, Data]()
        for table, values in zip(self.program.tables, self.tables, strict=True):
            data[table.name] = values
        tables = [data[table.name] for table in program.tables]
        return self._replace(program=program, cells=cells, tables=tables)

    def extend_tables(self, cells: Floats) -> None:
        """Extend the tables of Python functions to the slip of the lanes."""
        for k, function in self.functions.items():
            scale = self.program.tables[k].cells + ix.SCALE
            slip = cells[ix.SLIP] * cells[scale]
            farthest = float(np.max(slip))
            farthest *= 1.0 + 1e-12
            table = self.tables[k]
            end = float(table.breaks[-1])
            while end <= farthest:
                table = room("functions").sampled(function, 2 * end, table)
                end = float(table.breaks[-1])
            self.tables[k] = table

    def extend_rotations(self, rotation: Floats, lane: Any = slice(None)) -> bool:
        """Extend functions of the rotation to their full range if a lane exceeds their tables; whether one does.

        ``lane`` is the lane that each rotation belongs to, by default one after the other.
        """
        if self.farther is None:
            return False
        places = [k for k, table in enumerate(self.program.tables) if table.kind == "rotation"]
        if not any(_exceeds(self.tables[place], rotation, lane) for place in places):
            return False
        laid_out = self.farther()
        for place in places:
            self.tables[place] = laid_out[self.program.tables[place].name]
        return True

    @property
    def may_creep(self) -> bool:
        """Whether a mass may approach its equilibrium for ever: viscosity, forces of position, and no end time."""
        recipe = self.recipe
        of_position = not recipe.moving and "thermal_pressurisation" not in recipe.effects
        if "viscosity" not in recipe.effects or not of_position or not {"slip"}.issuperset(variables_of(recipe.laws)):
            return False
        return bool(np.any(self.cells[ix.END_TIME] == np.inf))

    def initial_cells(self) -> Floats:
        """A copy of the cells at the start."""
        return self.cells.copy()


def _exceeds(table: Data, rotation: Floats, lane: Any) -> bool:
    """Whether a rotation lies beyond the table of its lane."""
    last = table.breaks[-1]
    if table.breaks.ndim == 2:  # each lane has other breaks
        last = last[lane]
    beyond = rotation > last + 1e-9
    return bool(np.any(beyond))


@lru_cache(maxsize=256)
def common_cells(program: Program, other: Program) -> tuple[Any, Any]:
    """Places of the inputs that two programs have in common, in each of them."""
    inputs = program.cells[: program.given]
    places = list[int]()
    other_places = list[int]()
    for place, name in enumerate(inputs):
        if name in other.places:
            places.append(place)
            other_places.append(other.places[name])
    return np.array(places), np.array(other_places)


def solved_accuracy(accuracy: float, lanes: int) -> float:
    """The accuracy to which scenes are solved, where one is requested; single scenes are solved to rounding."""
    return accuracy if lanes > 1 else min(accuracy, FINEST)


def order(accuracy: float) -> int:
    """Order of the series with a truncation error below an accuracy, at steps of exp(-2) radii of convergence."""
    attainable = max(accuracy, 1e-16)
    digits = -math.log(attainable)
    terms = math.ceil(3.0 + digits / 2.0)
    return max(terms, LOWEST)


def build_problem(
    arc: Mass, called: Effects, friction: Any, velocity: Any, end_time: Any, accuracy: float, lanes: int
) -> Problem:
    """Build the problem of scenes that share their effects and laws.

    Parameters
    ----------
    arc : Mass
        Its fields, like all numbers here, are numbers or arrays of one value a lane.
    called : mapping
        Effects by name, each with its parameters; functions of time are `Series` or `Pulse`.
    friction : float, array, mapping or callable
        As a `Scene` takes it.
    velocity, end_time : float or ndarray
        m/s and s; infinite where there is no end.
    accuracy : float
        Requested relative error.
    lanes : int
        Number of scenes.

    Returns
    -------
    Problem
    """
    laws = law_parts(friction)
    names_of_laws = tuple(name for name, _ in laws)
    recipe = recipe_of(called, names_of_laws)
    effects = recipe.effects
    pushed = velocity != 0.0
    upslope = "shaking" in effects or bool(np.any(pushed))
    table_tolerance = FINEST
    if lanes > 1:
        table_tolerance = accuracy / 100
    numbers = Numbers(arc)
    for effect in effects:
        numbers.add_effect(effect, called[effect])
    numbers.add_rotations(called, friction, upslope, table_tolerance)
    for name, parameters in laws:
        numbers.add_law(name, parameters)
    numbers.add_start(velocity, end_time)
    inputs = numbers.inputs
    shaking = called.get("shaking", {})
    terms = {*effects, *recipe.moving}
    first_only = _first_only(terms, laws, inputs)
    endless = end_time == np.inf
    inputs["ONE_WAY"] = _one_way(shaking)
    inputs["FIRST_ONLY"] = choose(endless, first_only, 0.0)
    inputs["ORDER"] = order(solved_accuracy(accuracy, lanes))
    return _assembled(numbers, recipe, lanes)


def _assembled(numbers: Numbers, recipe: Recipe, lanes: int) -> Problem:
    """A problem from its numbers and tables, each in the place that its program has for it."""
    program = build_program(*recipe)
    places = program.places
    cells = program.blank(lanes)
    for name, value in numbers.inputs.items():
        if name in places:
            cells[places[name]] = value
    tables = list[Data]()
    functions = dict[int, Function]()
    for k, table in enumerate(program.tables):
        tables.append(numbers.tables[table.name])
        if table.name == "callable":
            functions[k] = numbers.function
    return Problem(program, tables, cells, functions, recipe, farther=numbers.farther)


def recipe_of(called: Effects, laws: Names) -> Recipe:
    """The recipe of scenes with these effects and laws."""
    names = tuple(called)
    effects = in_order(names)
    moving = list[str]()
    absent = list[str]()
    for effect in effects:
        parameters = called[effect]
        for name, symbol in symbols_of(effect).items():
            value = parameters.get(name)
            if value is None:
                absent.append(symbol)
            elif callable(value):
                moving.append(symbol)
    if "layered_strength" in effects and "shaking" not in effects:
        absent += ["k_h", "k_v"]  # which its terms contain, too
    return Recipe(effects, laws, tuple(moving), tuple(absent))


def _one_way(shaking: Parameters) -> float:
    """1 where shaking may start the mass down-slope only."""
    varies = callable(shaking.get("horizontal"))
    two_way = shaking.get("two_way", False)
    return float(varies and not two_way)


def _first_only(terms: Collection[str], laws: Any, inputs: Parameters) -> Any:
    """1 where nothing brings the mass to rest, 2 where water or heat may lift it: integrated to its first standstill.

    ``terms`` are names of effects and symbols of functions.
    """
    effects = ALL_EFFECTS.keys() & terms
    if not rotates(effects) or "layered_cohesion" in terms:
        return 0.0
    (name, parameters), *others = laws
    frictionless = False
    if name == "constant" and not others:
        frictionless = parameters["coefficient"] == 0.0
    if_lifted = 2.0 if _may_lift(terms, inputs) else 0.0
    swings = choose(frictionless, 1.0, if_lifted)
    cohesion = inputs.get("cohesion", 0.0)
    cohesion = cohesion + inputs.get("layered_cohesion", 0.0)
    return choose(cohesion > 0.0, 0.0, swings)


def _may_lift(terms: Collection[str], inputs: Parameters) -> bool:
    """Whether the pressure of water may exceed the normal stress."""
    if not UPLIFT.isdisjoint(terms):
        return True
    if any(name.startswith(UPLIFT_OF_SOILS) for name in terms):
        return True
    of_soils = [value for name, value in inputs.items() if name.startswith(UPLIFT_OF_SOILS)]
    return any(map(np.any, of_soils))
