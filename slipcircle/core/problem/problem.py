"""Initial value problem of a scene: a program with the dimensionless initial cells of every lane.

Numbers have the names of `generated.flow`, as declared in `generated.effects`, and the scene's shape. The module is
independent of individual laws and effects.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from generated import layout as ix
from generated.effects import ALL_EFFECTS, LAWS
from generated.flow import FRAGMENTS
from generated.program import OF_COHESION, OF_SOIL, Program, Recipe
from slipcircle.base.arrays import INFINITY, choose, float_or_array, may_overflow
from slipcircle.base.kinds import Floats, Function, Names, Parameters, Shape, ValueDict
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.plan import Plan
from slipcircle.core.scene.effects import rotates, symbols_of, without_soil
from slipcircle.core.scene.mass import Farther
from slipcircle.core.scene.piecewise import Data

FINEST = 1e-14  # accuracy of single scenes, since lower orders save little time
NEAR = 2e13  # margin of a decision at rest, in units of rounding, from which the rounded limit friction is accurate
LOWEST = 8  # least order, since steps depend on the first five and the last four coefficients
UPLIFT = frozenset(("pore_pressure", "thermal_pressurisation"))
COHESIVE = frozenset(("layered_cohesion", "growing_cohesion"))  # functions of the rotation
UPLIFT_OF_SOILS = ("layered_lift", "soil_lift")  # followed by the number of a soil
EVERY = slice(None)  # lane


@dataclass
class Problem:
    """Scenes that share a program, one per lane.

    Attributes
    ----------
    plan : Plan
    program : Program
    start : mapping
        Initial cells by name, each a number or an array over lanes.
    data : dict
        Piecewise functions by name, for all lanes, extended on demand.
    lanes : int
        Number of scenes.
    functions : dict
        Python functions of slip, by the name of their table.
    farther : callable or None
        Function that extends the functions of the rotation.
    """

    plan: Plan
    program: Program
    start: ValueDict
    data: dict[str, Data]
    lanes: int
    functions: dict[str, Function] = field(default_factory=dict)
    farther: Farther | None = None

    @property
    def recipe(self) -> Recipe:
        """Effects, laws and parameters from which the program is linked."""
        return self.plan.recipe

    def _columns(self) -> tuple[Floats, list[tuple[int, Floats]]]:
        """Return the initial cells that all lanes share, (cells,), and the others by their places."""
        places = self.program.places
        shared = {name: value for name, value in self.start.items() if not isinstance(value, np.ndarray)}
        own = [(places[name], self.start[name]) for name in self.start if name not in shared and name in places]
        column = np.zeros(len(self.program.cells) + 1)
        column[_places(self.program, tuple(shared))] = [*shared.values()]
        return column[:-1], own

    def cells(self, which: Any = EVERY) -> Floats:
        """Return the initial cells of all or some lanes, (cells, lanes).

        Cells are the numbers by which the integrator describes a lane; ``which`` is a NumPy index of lanes.
        """
        column, own = self._columns()
        if self.lanes == 1 and which is EVERY:
            return column[:, None]
        program = self.program
        count = np.arange(self.lanes)[which].size
        cells = np.empty((len(program.cells), count))  # others are computed where phases begin
        for rows in (slice(program.given), slice(-len(program.constants), None)):
            cells[rows] = column[rows, None]
        for place, value in own:
            cells[place] = value[which]
        return cells

    def sparse_cells(self) -> tuple[Floats, Floats]:
        """Return the initial cells of all lanes, (cells, lanes), and the cells that all lanes share, (cells,).

        The latter are not a number where lanes have their own. Only these and the status are filled in the former.
        """
        column, own = self._columns()
        cells = np.empty((column.size, self.lanes))
        column[ix.STATUS] = np.nan
        cells[ix.STATUS] = ix.START
        cells[ix.LIFT_TIME] = np.nan
        for place, value in own:
            cells[place] = value
            column[place] = np.nan
        return cells, column

    def begin_with(self, **cells: Any) -> "Problem":
        """Replace initial cells by name, each a number or an array over lanes; return the problem itself."""
        for name, values in cells.items():
            flat = np.ravel(values)
            self.start = {**self.start, name: float(flat[0]) if self.lanes == 1 else flat}
        return self

    def tables(self, which: Any = None) -> list[Data]:
        """Return the tables (piecewise functions) of all or some lanes in the order of the program.

        ``which`` is a NumPy index of lanes. Tables of a single lane have no axis of lanes, as its runs share them.
        """
        if not self.data:
            return []
        tables = [self.data[table.name] for table in self.program.tables]
        if which is None and self.lanes != 1:
            return tables
        return [table.lanes(0 if which is None else which) for table in tables]

    def reach_farther(self, rotation: Floats, lane: Any = EVERY) -> bool:
        """Extend functions of the rotation to their full range if a lane exceeds them, and return whether one does.

        ``rotation`` is in rad, and ``lane`` is the index of the lane of each rotation, by default all lanes in order.
        """
        return self.farther is not None and self.farther(self.data, rotation, lane)

    def _start_and_end(self) -> tuple[Any, Any]:
        """Return the initial angular velocity and the end time, dimensionless."""
        scene = self.plan.scene
        time_scale = scene.arc.time_scale
        velocity = float_or_array(scene.initial_velocity)
        return velocity / scene.arc.units["m"] * time_scale, scene.until / time_scale

    def _add_table(self, name: str, table: Data, scale: Any = 1.0, factor: Any = 1.0) -> None:
        """Add a piecewise function by its name in the program.

        ``scale`` is its argument over the dimensionless argument in the program, and ``factor`` multiplies its values.
        """
        self.data[name] = table
        self.start |= {f"{name}.PIECE": table.first, f"{name}.SCALE": scale, f"{name}.SCALED_BY": factor}

    def _add_effect(self, effect: str, parameters: Parameters) -> None:
        """Add the parameters of an effect in dimensionless form: numbers by symbol, functions of time as tables.

        ``effect`` is its name, with the number of the soil if it belongs to one, and ``parameters`` are in SI units by
        name.
        """
        symbols = symbols_of(effect)
        mass = self.plan.scene.arc
        scales = {**mass.scales, "strength_factor": self.start["strength_factor"]}
        declared = ALL_EFFECTS[without_soil(effect)].parameters
        present = [p for p in declared if p.name in parameters]
        for p in present:
            if p.kind == "number":  # a symbol may depend on several
                scales[p.name] = float_or_array(parameters[p.name])
        for p in present:
            if not p.symbol:
                continue
            value = parameters[p.name]
            symbol = symbols[p.name]
            if not callable(value):
                self.start[symbol] = p.dimensionless(float_or_array(value), scales)
            elif p.kind != "series":  # a function of the rotation, tabulated by the mass
                self.start[f"{symbol}.SCALED_BY"] = p.dimensionless(1.0, scales)
            else:
                factor = lazy_import("forcing").shaking_factor(effect, parameters, p.name)
                scaled = p.dimensionless(factor, scales)
                self._add_table(symbol, lazy_import("tables").of_time(value), mass.time_scale, scaled)

    def _add_rotations(self) -> None:
        """Add the mass's functions of the rotation, and the function that extends them, if one is needed."""
        scene = self.plan.scene
        upslope = bool(np.any(scene.initial_velocity)) or "shaking" in scene.called
        tolerance = max(self.plan.accuracy / 100, FINEST) if self.lanes > 1 else FINEST
        tables, self.farther = scene.arc.tables(scene.called, scene.law, upslope, tolerance, scene.shape)
        for name, table in tables.items():
            self._add_table(name, table, factor=self.start[f"{name}.SCALED_BY"])

    def _add_law(self, name: str, parameters: Parameters, strength: Any) -> None:
        """Add a friction or cohesion law times a factor ``strength``, as a table or as dimensionless numbers.

        ``name`` may contain the number of a soil, and ``parameters`` are in SI units by name.
        """
        units = self.plan.scene.arc.units
        numbers = _numbers_of_law(name)
        for cell, parameter, unit in numbers:
            scale = units[unit] if unit else 1.0 / strength
            self.start[cell] = float_or_array(parameters[parameter]) / scale
        if not numbers:
            self._add_table_of_law(name, parameters, strength)

    def _add_table_of_law(self, name: str, parameters: Parameters, strength: Any) -> None:
        """Add a law that is a table, with the arguments of `_add_law`."""
        law = without_soil(name)
        units = self.plan.scene.arc.units
        if law == "callable":
            radius = units["m"]
            self.functions[name] = parameters["function"]
            table = lazy_import("functions").first_table(parameters["function"], radius)
            self._add_table(name, table, radius, strength)
        else:
            table, scale, unit = lazy_import("tables").of_law(law, parameters, self.plan.scene.shape)
            self._add_table(name, table, units[unit] / scale, strength)


@lru_cache(maxsize=256)
def _numbers_of_law(name: str) -> tuple[Names, ...]:
    """Return the cell, the name and the unit of each parameter of a law; nothing for a law that is a table."""
    law = without_soil(name)
    if law == "callable" or FRAGMENTS[law].tables:
        return ()
    return tuple((f"{name}.{p.name}", p.name, p.unit) for p in LAWS[law].parameters)


@lru_cache(maxsize=256)
def _places(program: Program, names: Names) -> Any:
    """Return the places of cells by name; names that the program does not need have the place after its cells."""
    return np.array([program.places.get(name, len(program.cells)) for name in names])


def problem_of(plan: Plan, invalid: Any = False) -> Problem:
    """Return the initial value problem of a plan.

    Lanes marked in ``invalid``, a mask in the scene's shape, are not solved.
    """
    scene = plan.scene
    called = scene.called
    program = plan.program
    lanes = math.prod(scene.shape)
    strength = float_or_array(scene.strength_factor)
    of_method = _cells_of_method(program, plan.accuracy, lanes, "shaking" in called)
    start = {**scene.arc.initial_cells, **of_method, "strength_factor": strength}
    problem = Problem(plan, program, start, {}, lanes)
    for effect, parameters in called.items():
        if parameters:
            problem._add_effect(effect, parameters)
    if plan.recipe.moving:
        problem._add_rotations()
    for k, (name, parameters) in enumerate(scene.laws.items()):
        is_rate = k > 0 and OF_SOIL not in name  # which multiplies the law before it
        problem._add_law(name, parameters, 1.0 if is_rate or OF_COHESION in name else strength)
    start["omega"], start["END_TIME"] = may_overflow(scene.shape, problem._start_and_end)
    is_unknown = strength != strength
    if invalid is not False or is_unknown is not False:
        failed = np.logical_or(invalid, is_unknown)
        start["STATUS"] = float_or_array(np.where(failed, float(ix.FAILED), float(ix.START)))
    if scene.shape:
        problem.start = start = _flat(start, scene.shape)
    if "shaking" in called:
        shaking = called["shaking"]
        start["ONE_WAY"] = float(callable(shaking.get("horizontal")) and not shaking.get("two_way"))
    start["FIRST_ONLY"] = _first_only(plan.recipe, start)
    return problem


def _flat(numbers: ValueDict, shape: Shape) -> ValueDict:
    """Return numbers by name as arrays with one axis of lanes, (lanes,).

    ``shape`` is the scene's shape, with which arrays broadcast. Numbers that all lanes share remain numbers.
    """
    flat = {}
    lanes = math.prod(shape)
    for name, value in numbers.items():
        if type(value) is not float and np.ndim(value):
            is_complete = np.size(value) == lanes
            value = np.ravel(value if is_complete else np.broadcast_to(value, shape))
        flat[name] = value
    if lanes == 1:
        return {name: float(value if np.ndim(value) == 0 else value[0]) for name, value in flat.items()}
    return flat


@lru_cache(maxsize=256)
def _cells_of_method(program: Program, accuracy: float, lanes: int, shaken: bool) -> Mapping[str, float]:
    """Return the constants of a program, the order of the series, and the ratio of their terms at the end of a step.

    ``accuracy`` is the requested relative error, and ``shaken`` is true for scenes with shaking. Single scenes (one
    lane) are solved to rounding.
    """
    attainable = max(accuracy if lanes > 1 else min(accuracy, FINEST), 1e-16)
    step, margin = (ix.RATIO, 2.0) if attainable > FINEST else (ix.RATIO_TO_ROUNDING, 1.0)
    if shaken:
        margin = 3.0  # displacements are small sums of steps, which end where the terms of a series are negligible
    terms = math.ceil(margin + math.log(attainable) / math.log(step))
    return {**program.constants, "ORDER": max(terms, LOWEST), "FACTOR": step}


def _first_only(recipe: Recipe, start: Parameters) -> Any:
    """Return 1 if nothing brings the mass to rest, and 2 if water or heat may lift it, otherwise 0, for each lane.

    Such a mass without end time is integrated to its first standstill. ``start`` contains the initial cells by name.
    """
    swings, lifts, pressures, laws = _swing_of(recipe)
    if not swings:
        return 0.0
    frictionless = False
    if recipe.laws[0] == "constant":
        frictionless = start["constant.coefficient"] == 0.0
    if pressures and not lifts:
        lifts = any(np.any(start[name]) for name in pressures if name in start)
    if not lifts and (frictionless is False or not np.any(frictionless)):
        return 0.0
    swings = choose(frictionless, 1.0, 2.0 if lifts else 0.0)
    cohesion = start.get("cohesion", 0.0)
    cohesion = cohesion + start.get("layered_cohesion", 0.0)
    for law in laws:  # residual cohesion; tables and functions are followed in any case
        cohesion = cohesion + start.get(f"{law}.residual", 1.0)
    may_rest = (cohesion > 0.0) | (start["END_TIME"] != INFINITY)
    return choose(may_rest, 0.0, swings)


@lru_cache(maxsize=256)
def _swing_of(recipe: Recipe) -> tuple[bool, bool, Names, Names]:
    """Return four traits of the scenes with a recipe, by which `_first_only` decides.

    They are whether a mass may swing on, whether water or heat always lifts it, the names of cells of pore pressures of
    soils, and the names of laws of cohesion.
    """
    effects = recipe.effects
    swings = rotates(effects) and COHESIVE.isdisjoint(recipe.moving)
    laws = tuple(law for law in recipe.laws if OF_COHESION in law)
    symbols = [symbol for effect in effects for symbol in symbols_of(effect).values()]
    of_soils = [symbol for symbol in symbols if symbol.startswith(UPLIFT_OF_SOILS)]
    varies = any(name.startswith(UPLIFT_OF_SOILS) for name in recipe.moving)
    return swings, varies or not UPLIFT.isdisjoint(effects), tuple(of_soils), laws
