"""Forces on the mass, at the start and during the motion, evaluated by the program of its scene."""

from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np

from generated import layout as ix
from generated.program import Program, Recipe
from slipcircle.base.arrays import EPS, float_or_array, quiet
from slipcircle.base.kinds import ArrayDict, ArrayPair, Floats, Names
from slipcircle.core.integrator.compiled import engine
from slipcircle.core.integrator.lanes import BLOCK
from slipcircle.core.lazy import lazy_import
from slipcircle.core.problem.plan import build_program
from slipcircle.core.problem.problem import Problem
from slipcircle.core.scene.effects import in_order, symbols_of
from slipcircle.core.scene.mass import Mass
from slipcircle.history.states import States, begin

OUTPUTS = ("pressing", "normal", "mu")  # registers that are evaluated in addition to the states


class Balance(NamedTuple):
    """Driving force, resistance other than friction, and normal force, each divided by Theta*."""

    driving: Any
    resisting: Any
    normal: Any

    @classmethod
    def of(cls, program: Program, cells: Floats) -> Self:
        """Return the balance at the beginning of phases.

        `cells` are the variables of the program, one column per lane.
        """
        names = ("cell_driving", "cell_resisting", "cell_normal0")
        return cls(*(cells[program.roles[name]] for name in names))


def stress_unit(mass: Mass) -> Any:
    """Return the stress in Pa that corresponds to a normal force of 1 over Theta*, sigma_ref Theta*/lambda."""
    return float_or_array(mass.reference_stress / mass.moment_coefficients.resistance_factor)


def energy_unit(mass: Mass) -> Any:
    """Return the energy in J that corresponds to omega*^2/2 = 1."""
    weight_of_area = np.multiply(mass.width, mass.mean_unit_weight)
    return float_or_array(weight_of_area * np.power(mass.radius, 3.0) * mass.dimensionless.moment_of_inertia)


def with_outputs(problem: Problem, outputs: Names) -> Problem:
    """Return the same lanes with a program that also computes the given outputs, such as `OUTPUTS`."""
    return _with_program(problem, build_program(problem.recipe, outputs))


def _with_program(problem: Problem, program: Program) -> Problem:
    """Return the same lanes with another program."""
    return replace(problem, program=program, start={**problem.start, **program.constants})


class Forces:
    """Forces on the lanes of a problem."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    @cached_property
    def _with_outputs(self) -> Problem:
        return with_outputs(self.problem, OUTPUTS)

    # --- in any states -----------------------------------------------------------------------------------------------

    def outputs(self, states: States) -> ArrayDict:
        """Return the registers of `OUTPUTS`: total and effective normal force over Theta*, and friction as entered.

        Each array has one value per state.
        """
        places = [self._with_outputs.program.roles[name] for name in OUTPUTS]
        parts = []
        for part in states.parts():
            _, registers = begin(self._with_outputs, part, np.where(part.omega < 0.0, -1.0, 1.0))
            parts.append(registers[places])
        outputs = dict(zip(OUTPUTS, np.concatenate(parts, axis=1), strict=True))
        return outputs | {"mu": outputs["mu"] / self._strength(states.lane)}

    def _strength(self, lanes: Any) -> Any:
        """Return the factor by which friction in the program exceeds friction as entered.

        It is a number, or an array for the given indices of lanes.
        """
        factor = self.problem.start["strength_factor"]
        if np.ndim(factor):
            return factor[lanes]
        return factor

    def factor_of_safety(self, states: States) -> Floats:
        """Return the ratio of resistance to drive for a mass at rest in the given states, infinite without a drive."""
        (driving, resisting, normal), friction = self._at_rest(states)
        strength = resisting + np.maximum(friction * normal, 0.0)
        is_driven = driving > 0.0
        return np.where(is_driven, strength / np.where(is_driven, driving, 1.0), np.inf)

    def _at_rest(self, states: States) -> tuple[Balance, Floats]:
        """Return the balance in the direction of the drive and the friction of a mass at rest in some states.

        The balance has one value per state. The friction coefficient includes the strength factor of the start.
        """
        program = self._with_outputs.program
        at_rest = states._replace(omega=np.zeros(states.lane.size))
        cells, _ = begin(self._with_outputs, at_rest, 1.0)
        pull = cells[program.roles["cell_driving"]]
        cells, _ = begin(self._with_outputs, at_rest, np.where(pull < 0.0, -1.0, 1.0))
        return Balance.of(program, cells), cells[program.roles["cell_mu"]]

    def kept_cohesion(self, states: States) -> Floats:
        """Return the share of the cohesion at rest that slip has left, one value per state; 1 without cohesion."""
        unslipped = [np.zeros_like(values) for values in states.further]
        fresh = states._replace(further=unslipped)
        slipped, _ = self._at_rest(states)
        at_first, _ = self._at_rest(fresh)
        left = slipped.resisting
        whole = at_first.resisting
        is_some = whole > 0.0
        return np.where(is_some, left / np.where(is_some, whole, 1.0), 1.0)

    def strengths(self, states: States) -> ArrayPair:
        """Return the mobilised shear strength and the strength required at rest, over Theta*, one value per state."""
        (driving, resisting, _), _ = self._at_rest(states)
        moving = self.outputs(states)
        friction = moving["mu"] * moving["normal"]
        friction = np.maximum(friction, 0.0)
        return resisting + friction * self._strength(states.lane), driving

    def holding_friction(self, states: States) -> Floats:
        """Return the friction coefficient required for equilibrium in the given states, NaN without contact.

        If the mass may start in both directions, the result is the greater coefficient.
        """
        at_rest = states._replace(omega=np.zeros(states.lane.size))
        return np.fmax(self._holding(at_rest, 1.0), self._holding(at_rest, -1.0))

    def _holding(self, at_rest: States, side: float) -> Floats:
        """Return the friction required in one direction, NaN without contact or where the mass cannot start.

        `side` is the direction, 1 down-slope or -1 up-slope, and the result has one value per state.
        """
        program = self._with_outputs.program
        cells, _ = begin(self._with_outputs, at_rest, side)
        forces = Balance.of(program, cells)
        excess = forces.driving - forces.resisting
        with quiet():
            friction = excess / forces.normal
        contact = forces.normal > 0.0
        pull = cells[program.roles["cell_driving_moment"]]
        may_start = (cells[ix.ONE_WAY] == 0.0) | ((pull > 0.0) | ((pull == 0.0) & (side > 0.0)))
        entered = np.maximum(friction, 0.0) / self._strength(at_rest.lane)
        return np.where(contact & may_start, entered, np.nan)

    # --- at the start ------------------------------------------------------------------------------------------------

    @property
    def brake(self) -> Floats:
        """Return q = 2 (lambda A mu + d)/Theta* at the start, twice the decrease of the rate per unit of omega^2."""
        program = self.problem.program
        tables = self.problem.tables()
        cells = self.problem.cells()
        cells[ix.DIRECTION] = 1.0
        engine().begin_phase(program, tables, cells)
        cells[program.roles["cell_drive"]] = 0.0
        cells[ix.OMEGA] = 1.0
        return -2.0 * engine().registers(program, tables, cells)[program.roles["net"]]

    @cached_property
    def statics(self) -> ArrayDict:
        """Return limit friction, factor of safety, yield coefficient and friction at the start, without shaking.

        The program supplies all forces. The excess of drive over resistance is linear in k_h and vanishes at k_y.
        """
        if self.problem.lanes == 1:
            lazy_import("limits").refine(self.problem, np.zeros(1))
        # The same lanes with a constant horizontal coefficient, initially 0, instead of their shaking.
        effects, laws, moving, absent = self.problem.recipe
        shaking = symbols_of("shaking").values()
        effects, _ = in_order((*effects, "shaking"))
        moving = tuple(symbol for symbol in moving if symbol not in shaking)
        others = [symbol for symbol in absent if symbol not in shaking]
        problem = _with_program(self.problem, build_program(Recipe(effects, laws, moving, (*others, "k_v"))))
        parts = [self._statics(problem, slice(k, k + BLOCK)) for k in range(0, max(problem.lanes, 1), BLOCK)]
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _statics(self, problem: Problem, which: slice) -> ArrayDict:
        """Return `statics` of some lanes of a problem whose steady shaking is 0.

        `which` is the slice of these lanes.
        """
        program = problem.program
        tables = problem.tables(which)
        cells = problem.cells(which)
        pull = cells[program.places["driving_moment"]]
        downhill = np.where(pull < 0.0, -1.0, 1.0)
        cells[ix.OMEGA] = 0.0
        cells[ix.DIRECTION] = downhill
        cells[program.places["k_h"]] = 0.0
        shaken = cells.copy()
        shaken[program.places["k_h"]] = downhill  # k_h = 1 in the direction in which gravity drives
        for each in (cells, shaken):
            engine().begin_phase(program, tables, each)
        mu = cells[program.roles["cell_mu"]].copy()  # a view would keep all cells alive
        limit = cells[program.roles["cell_limit"]]
        with quiet():
            statics = equilibrium(Balance.of(program, cells), Balance.of(program, shaken), mu, limit)
        factor = self._strength(which)
        return statics | {name: statics[name] / factor for name in ("friction", "limit_friction")}


def equilibrium(at_rest: Balance, shaken: Balance, mu: Floats, limit: Floats) -> ArrayDict:
    """Return `Forces.statics` from the forces on a mass at rest, without shaking and with k_h = 1.

    `mu` is the friction and `limit` the friction at which the mass is at its limit, one value per lane.
    """
    driving, resisting, normal = at_rest
    pressed = normal > 0.0
    frictionless = driving - resisting
    excess = frictionless - mu * normal
    near_limit = normal * (limit - mu)  # without cancellation
    exact_excess = np.where(pressed, near_limit, excess)
    frictionless_shaken = shaken.driving - shaken.resisting
    yielding = -exact_excess / (frictionless_shaken - mu * shaken.normal - excess)
    normal_then = normal + yielding * (shaken.normal - normal)
    yielding_lifted = -frictionless / (frictionless_shaken - frictionless)
    yield_coefficient = np.where(normal_then < 0.0, yielding_lifted, yielding)
    strength = resisting + np.where(pressed, mu * normal, 0.0)
    return {
        "limit_friction": np.where(pressed, limit, np.where(frictionless > 0.0, np.inf, -np.inf)),
        "friction": mu,
        "factor_of_safety": np.where(driving > 8 * EPS * abs(normal), strength / driving, np.inf),
        "yield_coefficient": yield_coefficient + 0.0,
    }
