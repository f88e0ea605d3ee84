"""Lanes of scenes that share their effects and laws: integrated to their end, and evaluated on the way."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from generated import layout as ix
from generated import walk
from slipcircle.base.checks import choose, plain
from slipcircle.base.kinds import Floats, Parameters
from slipcircle.core.doors import room
from slipcircle.core.problem.equilibrium import Forces, equilibrium
from slipcircle.core.problem.problem import Problem, build_problem
from slipcircle.core.program.program import Log, Samples
from slipcircle.core.scene.coordinates import by_lanes
from slipcircle.core.scene.mass import Mass
from slipcircle.core.walk.compiled import engine

# Lanes in a block, so that their numbers stay in the cache; rows a power of two apart would share its lines.
BLOCK = 16000
OUTPUTS = ("pressing", "normal", "mu")  # registers that are evaluated beside the states


def integrate_all(
    problem: Problem, samples: Samples | None = None, log: Log | None = None, integrator: Any = None, cells: Any = None
) -> Floats:
    """Integrate all lanes to their end: their final cells.

    Parameters
    ----------
    problem : Problem
    samples : Samples, optional
        States at times on the way; filled in place.
    log : list, optional
        Takes the events of the first lane.
    integrator : callable, optional
        The integrator, by default the fastest here.
    cells : ndarray, optional
        To start with and to overwrite; by default a copy of the problem's.
    """
    integrator = integrator or engine().integrate
    integrate = partial(_integrate, log=log, integrator=integrator)
    if problem.may_creep:
        final: Floats = room("creep").integrate(problem, samples, integrate)
        return final
    return integrate(problem, samples, cells=cells)


def _integrate(problem: Problem, samples: Samples | None, log: Any, integrator: Any, cells: Any = None) -> Floats:
    """`integrate_all`, where no mass creeps."""
    if log is not None:
        log.clear()
    state = cells
    if cells is None:
        state = problem.initial_cells()
    program = problem.program
    integrator(program, problem.tables, state, samples, log)
    is_copy = cells is None
    if is_copy and problem.extend_rotations(state[ix.REACH_ROTATION]):
        return _integrate(problem, samples, log, integrator)
    last_status = state[ix.STATUS].max(initial=0.0)
    if last_status < ix.TOO_LONG:
        return state
    _integrate_stiff(problem, state, samples, log)
    status = state[ix.STATUS]
    (waiting,) = np.nonzero(status == ix.NEED)
    if not waiting.size:
        return state
    # One lane goes on to find how far a Python function is needed; then all start again with the whole table.
    _extend_to_end(problem, state, waiting[:1])
    return _integrate(problem, samples, log, integrator)


def _integrate_stiff(problem: Problem, cells: Floats, samples: Samples | None, log: Log | None) -> None:
    """Integrate lanes that took too many explicit steps and still move by implicit ones."""
    status = cells[ix.STATUS]
    many_steps = cells[ix.STEPS] > ix.MOST_STEPS
    moving = cells[ix.OMEGA] > 0.0
    stopped = status == ix.TOO_LONG
    (which,) = np.nonzero(stopped & many_steps & moving)
    while which.size:
        room("stiff").integrate(problem, cells, samples, log, which)
        waiting = status[which] == ix.NEED
        which = which[waiting]
        if which.size:
            problem.extend_tables(cells[:, which])


def _extend_to_end(problem: Problem, cells: Floats, which: Any) -> None:
    """Extend the tables of Python functions as far as one lane needs them up to its end."""
    one = cells[:, which]
    (status,) = one[ix.STATUS]
    while status == ix.NEED:
        problem.extend_tables(one)
        one[ix.OMEGA] *= one[ix.DIRECTION]
        one[ix.STATUS] = ix.START
        tables = [table.lanes(which) for table in problem.tables]
        engine().integrate(problem.program, tables, one)
        (status,) = one[ix.STATUS]


class _States(NamedTuple):
    """States of lanes, dimensionless: time, rotation, omega, slip, further states, and the lane of each."""

    time: Any
    rotation: Any
    omega: Any
    further: Any = None
    lane: Any = slice(None)


@dataclass(frozen=True)
class Lanes:
    """Fields of scenes as numbers or as arrays with one value for each lane, and what all lanes share.

    Attributes
    ----------
    arc : Mass
        May be unchecked: what is no arc is invalid.
    called : mapping
        Effects by name, each with its parameters.
    friction : float, ndarray, mapping or callable
    velocity, end_time : float or ndarray
        m/s, and s or infinity.
    accuracy : float
    count : int
        Number of lanes.
    invalid : ndarray of bool
        Which are no scenes.
    """

    arc: Mass
    called: Mapping[str, Parameters]
    friction: Any
    velocity: Any
    end_time: Any
    accuracy: float
    count: int
    invalid: Any = False

    def taken(self, which: Any) -> "Lanes":
        """Some of the lanes, by an index."""

        def select(value: Any, axes: int = 0) -> Any:
            if isinstance(value, Mapping):
                return {name: select(part) for name, part in value.items()}
            if not isinstance(value, np.ndarray) or value.ndim != axes + 1:
                return value
            return value[which] if len(value) == self.count else value

        arc = by_lanes(self.arc, select)
        effects = select(self.called)
        every_lane = np.arange(self.count)
        return Lanes(
            arc=arc,
            called=arc.effects_with_own(effects),
            friction=select(self.friction),
            velocity=select(self.velocity),
            end_time=select(self.end_time),
            accuracy=self.accuracy,
            count=every_lane[which].size,
            invalid=select(self.invalid),
        )

    def parts(self) -> Iterator[tuple[slice, "Lanes"]]:
        """The lanes in blocks."""
        for first in range(0, self.count, BLOCK):
            which = slice(first, first + BLOCK)
            yield which, self.taken(which)

    @cached_property
    def problem(self) -> Problem:
        """The problem that is solved and evaluated."""
        return self._build(self.called, self.friction)

    def _build(self, called: Mapping[str, Parameters], friction: Any) -> Problem:
        problem = build_problem(self.arc, called, friction, self.velocity, self.end_time, self.accuracy, self.count)
        if self.invalid is not False:
            invalid = np.broadcast_to(self.invalid, self.count)
            problem.cells[ix.STATUS, invalid] = ix.FAILED
        return problem

    # --- units ---------------------------------------------------------------------------------------------------

    @cached_property
    def time_scale(self) -> Any:
        """s for one of the dimensionless time."""
        return plain(self.arc.time_scale)

    @cached_property
    def radius(self) -> Any:
        """m."""
        return plain(self.arc.radius)

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        coefficients = self.arc.moment_coefficients
        unit = self.arc.reference_stress / coefficients.resistance_factor
        return plain(unit)

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.arc
        weight_of_area = np.multiply(arc.width, arc.mean_unit_weight)
        weight_times_radius = weight_of_area * np.power(arc.radius, 3.0)
        return weight_times_radius * arc.dimensionless.moment_of_inertia

    # --- the motion ----------------------------------------------------------------------------------------------

    def solve(self, log: Log | None = None) -> Floats:
        """The final cells of all lanes."""
        if self.count == 1:
            return integrate_all(self.problem, log=log)
        problem = self._build(self.called, self.friction)  # copies of many lanes would cost as much as the integration
        cells = None if problem.functions else problem.cells
        final = integrate_all(problem, log=log, cells=cells)
        reach = final[ix.REACH_ROTATION]
        if not problem.extend_rotations(reach):
            return final
        same_lanes = self._build(self.called, self.friction)
        farther = same_lanes._replace(tables=problem.tables)
        return integrate_all(farther, log=log)

    def read(self, times: Floats, problem: Problem | None = None) -> Floats:
        """Rotation, omega, its rate, slip and further states at times in s, (rows, times, lanes).

        ``problem`` is another problem of these lanes, with further states.
        """
        if problem is None:
            problem = self.problem
        increasing = np.argsort(times, kind="stable")
        ordered = times[increasing]
        units = np.broadcast_to(self.time_scale, self.count)
        dimensionless = ordered[:, None] / units
        outputs = 2 + len(problem.program.states)
        rows = np.zeros((outputs, times.size, self.count))
        samples = Samples(np.ascontiguousarray(dimensionless), rows)
        integrate_all(problem, samples)
        states = np.empty_like(rows)
        states[:, increasing] = rows
        return states

    def energies(self, times: Floats) -> tuple[dict[str, Floats], Floats]:
        """Kinetic energy, work and dissipation at times in s, (times, lanes), and the first kinetic energy."""
        problem = self.problem.with_outputs(("energy",))
        program = problem.program
        states = self.read(times, problem)
        _, omega, _, _, *further = states
        names = [program.cells[cell] for cell, _, _ in program.states[2:]]
        rows = dict(zip(names, further, strict=True))
        kinetic = omega**2 / 2
        dissipation = np.maximum(rows["dissipation"], 0.0)
        energies = {"kinetic": kinetic, "work": rows["work"], "dissipation": dissipation}
        first_omega = problem.cells[ix.OMEGA]
        return energies, first_omega**2 / 2

    # --- forces in any states ----------------------------------------------------------------------------------

    def stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """The mean normal stress, Pa, of each lane in one state; dimensionless numbers."""
        if self.count > BLOCK:
            columns = np.stack([time, rotation, omega])
            return np.concatenate([part.stress(*columns[:, which]) for which, part in self.parts()])
        states = _States(time, rotation, omega)
        pressing = self._outputs_in(states, self.of_means)["pressing"]
        return pressing * self.stress_unit

    def outputs(self, times: Floats, rows: Floats, problem: Problem | None = None) -> dict[str, Floats]:
        """Total and effective normal force and friction at times in s, of states as `read` returns them."""
        states = self._states(times, rows)
        shape = rows.shape[1:]
        outputs = self._outputs_in(states, problem or self._with_outputs)
        return {name: values.reshape(shape).T for name, values in outputs.items()}

    def holding_friction(self, times: Floats, rows: Floats) -> Floats:
        """Friction coefficient required for equilibrium of the mass in its position at times in s, (lanes, times).

        The greater one of both ways, where both are open to it; NaN where nothing presses.
        """
        states = self._states(times, rows)
        at_rest = states._replace(omega=0.0)
        down_slope = self._holding(at_rest, 1.0)
        up_slope = self._holding(at_rest, -1.0)
        greatest = np.fmax(down_slope, up_slope)
        by_time = greatest.reshape(rows.shape[1:])
        return by_time.T

    def _holding(self, at_rest: _States, side: float) -> Floats:
        """Friction required in one direction; NaN without contact, or where a mass cannot start."""
        problem = self._with_outputs
        cells, _ = self._begin(at_rest, side, problem)
        forces = Forces.of(problem.program, cells)
        lanes = walk.Lanes(problem.program, problem.tables, cells)
        every = np.arange(cells.shape[1])
        excess = forces.driving - forces.resisting
        with np.errstate(all="ignore"):
            friction = excess / forces.normal
        contact = forces.normal > 0.0
        known = contact & walk.may_start(lanes, every)
        holding = np.maximum(friction, 0.0)
        return np.where(known, holding, np.nan)

    @cached_property
    def _with_outputs(self) -> Problem:
        return self.problem.with_outputs(OUTPUTS)

    @cached_property
    def of_means(self) -> Problem:
        """A problem with the same states, in which stresses are means over the arc, not weighted by friction."""
        called = self.arc.effects_of_means(self.called)
        if called is self.called:
            return self._with_outputs
        frictionless = {"law": "constant", "coefficient": 0.0}
        problem = self._build(called, frictionless)
        return problem.with_outputs(OUTPUTS)

    def _states(self, times: Floats, rows: Floats) -> _States:
        """States at times in s, as `read` gives them, as separate lanes."""
        every_lane = np.arange(self.count)
        lane = np.tile(every_lane, times.size)
        units = np.broadcast_to(self.time_scale, self.count)
        time = times[:, None] / units
        flat_rows = rows.reshape(len(rows), -1)
        rotation, omega, _, *further = flat_rows
        return _States(time.ravel(), rotation, omega, further, lane)

    def _outputs_in(self, states: _States, problem: Problem) -> dict[str, Floats]:
        """Registers of `OUTPUTS` in some states."""
        direction = choose(states.omega < 0.0, -1.0, 1.0)
        _, registers = self._begin(states, direction, problem)
        roles = problem.program.roles
        return {name: registers[roles[name]] for name in OUTPUTS}

    def _begin(self, states: _States, side: Any, problem: Problem) -> tuple[Floats, Floats]:
        """Cells and registers of phases that begin in some states, in a direction of travel."""
        cells = problem.cells[:, states.lane].copy()
        cells[ix.TIME] = states.time
        cells[ix.ROTATION] = states.rotation
        cells[ix.OMEGA] = abs(states.omega)
        cells[ix.DIRECTION] = side
        cells[ix.LIFTED] = 0.0
        if states.further is not None:
            slip, *others = states.further
            cells[ix.SLIP] = slip
            problem.extend_rotations(states.rotation, states.lane)
            problem.extend_tables(cells)
            further_states = problem.program.states[2:]
            for (cell, _, _), value in zip(further_states, others, strict=True):
                cells[cell] = value
        tables = [table.lanes(states.lane) for table in problem.tables]
        registers = engine().begin_phase(problem.program, tables, cells)
        return cells, registers

    # --- at the start --------------------------------------------------------------------------------------------

    @property
    def brake(self) -> Floats:
        """q = 2 (lambda A mu + d)/Theta* at the start: twice the decrease of the rate per unit of omega^2."""
        program = self.problem.program
        tables = self.problem.tables
        cells = self.problem.cells.copy()
        cells[ix.DIRECTION] = 1.0
        engine().begin_phase(program, tables, cells)
        drive = program.roles["cell_drive"]
        cells[drive] = 0.0
        cells[ix.OMEGA] = 1.0
        registers = engine().registers(program, tables, cells)
        rate = registers[program.roles["net"]]
        return np.asarray(-2.0 * rate)

    @cached_property
    def statics(self) -> dict[str, Floats]:
        """Limit friction, factor of safety, yield coefficient and friction at the start, without shaking.

        All are read off the program. The excess of drive over resistance is linear in k_h: k_y is where it is zero.
        """
        problem = self.problem.with_steady_shaking()
        program = problem.program
        k_h = program.places["k_h"]
        cells = problem.cells
        pull = cells[program.places["driving_moment"]]
        downhill = np.where(pull < 0.0, -1.0, 1.0)
        cells[ix.OMEGA] = 0.0
        cells[ix.DIRECTION] = downhill
        cells[k_h] = 0.0
        shaken = cells.copy()
        shaken[k_h] = downhill  # a unit of k_h, the way in which gravity drives
        for each in (cells, shaken):
            engine().begin_phase(program, problem.tables, each)
        mu = cells[program.roles["cell_mu"]]
        limit = cells[program.roles["cell_limit"]]
        at_rest = Forces.of(program, cells)
        under_shaking = Forces.of(program, shaken)
        with np.errstate(all="ignore"):
            return equilibrium(at_rest, under_shaking, mu, limit)
