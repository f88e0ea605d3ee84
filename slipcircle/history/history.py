"""Histories of a motion: states, stresses, friction and energy at any times.

The solver stores only the end of each lane. Histories are integrated again on request.
"""

from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from generated.effects import Parameter
from slipcircle.base.arrays import choose
from slipcircle.base.errors import mistakes, raise_all
from slipcircle.base.kinds import Floats
from slipcircle.core.integrator.compiled import Log
from slipcircle.core.integrator.lanes import integrate_problem
from slipcircle.core.motion.motion import Motion
from slipcircle.core.motion.state import State
from slipcircle.core.problem.plan import recipe_of
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.scene.scene import Scene
from slipcircle.history.ends import before, state_of
from slipcircle.history.forces import Forces, energy_unit, stress_unit, with_outputs
from slipcircle.history.phases import Energy, Phase
from slipcircle.history.states import States, read

_LONG = 1e15  # slip over R at which every law has reached its residual strength
ENERGY_CHECKS = 21  # number of times at which the energy balance is checked
ALLOWED_TIMES = Parameter("times", "s", -5e-324, allowed="times in s, not before 0")


class Stresses(NamedTuple):
    """Total and effective mean normal stress in Pa, each of the shape of the states."""

    total: Any
    effective: Any


class Strengths(NamedTuple):
    """Mean shear strength along the slip surface that is mobilised, and that required for equilibrium, Pa."""

    mobilised: Any
    required: Any


class FurtherFactors(NamedTuple):
    """Factors of safety with residual strength on the original geometry, and at rest after the slide.

    The factor at rest is NaN for ensembles. Each method is the starting method of the scene, or empty for the closure
    with the strength factor of the start.
    """

    residual: Any
    at_rest: Any
    residual_method: str
    at_rest_method: str


def of_means(scene: Scene) -> Scene:
    """Return the scene with stresses averaged over the arc without weighting by the friction of soils."""
    called = scene.arc.effects_of_means(scene.called)
    if called is scene.called:
        return scene
    other = copy(scene)
    vars(other).update(called=called, law={"law": "constant", "coefficient": 0.0})
    vars(other).pop("laws", None)
    return other


class History:
    """Evaluation of a solved motion at given times. Its methods implement the methods of `Motion` of the same name."""

    def __init__(self, motion: Motion) -> None:
        self.motion = motion
        self.plan = motion.plan
        self.problem = motion.problem
        self.shape = motion.shape
        self._final = motion._final
        self._duration = motion.duration
        self._radius = motion._radius
        self._time_scale = motion._time_scale
        self._last_read: tuple[bytes, Floats] | None = None

    @cached_property
    def forces(self) -> Forces:
        """Forces on the mass."""
        return Forces(self.problem)

    @cached_property
    def _mean_forces(self) -> Forces:
        """Return forces whose stresses are unweighted means over the arc."""
        scene = of_means(self.plan.scene)
        if scene is self.plan.scene:
            return self.forces
        plan = replace(self.plan, scene=scene, recipe=recipe_of(scene))
        return Forces(problem_of(plan, self.motion.invalid))

    # --- states ------------------------------------------------------------------------------------------------------

    def at(self, times: ArrayLike) -> State:
        """Return the states at times. See `Motion.at`."""
        time = self._checked(times)
        rotation, omega, rate, *_ = (self._over_time(time, row) for row in self._rows(time))
        every_time = np.broadcast_to(time, self.shape + time.shape)[()]
        return state_of(self.plan.scene, every_time, rotation, omega, rate, lambda: self._stresses(time).total)

    def _checked(self, times: ArrayLike) -> Floats:
        """Return times in s as an array. Raise an error if some lane still moves at a time beyond its end."""
        faults = mistakes({"times": times}, {"times": ALLOWED_TIMES})
        raise_all("Motion.at", faults)
        time = np.asarray(times, float)
        status = self._final[ix.STATUS]
        known_until = choose(status == ix.PAUSED, self.plan.scene.until, self._duration)
        moving = status != ix.ARRESTED
        ends = choose(moving & self.motion._solved, known_until, np.inf)
        last = float(np.min(ends, initial=np.inf))
        late = time[time > last]
        if late.size:
            requested = float(late.flat[0])
            end = "the scene's end_time"
            if self.plan.scene.end_time is None:
                end = "the end of this motion"
            raise ValueError(
                f"Motion.at: times = {requested!r}: must be at most {end}, {last!r} s, unless the mass stays at rest"
            )
        return time

    def _dimensionless(self, times: Floats) -> Floats:
        """Return times in s, (times, 1) or (times, lanes), divided by the time scale of each lane, (times, lanes)."""
        return times / np.broadcast_to(self._time_scale, self.shape).ravel()

    def _read(self, problem: Problem, times: Floats) -> Floats:
        """Return rotation, omega, its rate, slip and further states at times in s, of shape (rows, times, lanes).

        The times are (times, 1), in any order, or (1, lanes). All results are dimensionless, the rotation in rad.
        """
        increasing = np.argsort(times[:, 0], kind="stable")
        rows = read(problem, self._dimensionless(times[increasing]))
        states = np.empty_like(rows)
        states[:, increasing] = rows
        return states

    def _rows(self, time: Floats) -> Floats:
        """Return `_read` of this motion. The last result is cached."""
        key = time.tobytes()
        if self._last_read is not None:
            last_key, last_rows = self._last_read
            if last_key == key:
                return last_rows
        times = np.reshape(time, (-1, 1))
        rows = self._read(self.problem, times)
        ended = self._has_ended(times)
        at_end = (ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE)
        for row, entry in zip(rows, at_end, strict=False):
            row[:] = np.where(ended, np.ravel(self._final[entry]), row)
        self._last_read = key, rows
        return rows

    def _has_ended(self, times: Floats) -> Any:
        """Return whether each lane has ended at times as in `_read`, of shape (times, lanes), without rounding."""
        return times >= np.ravel(self._duration)

    def _over_time(self, time: Floats, values: Floats) -> Any:
        """Return values of shape (times, lanes) in the shape of the scene followed by the shape of the times."""
        return values.T.reshape(self.shape + time.shape)[()]

    # --- forces and energy -------------------------------------------------------------------------------------------

    def _states(self, time: Floats) -> States:
        """Return the states at times in s as separate lanes, ordered by time."""
        rows = self._rows(time)
        rotation, omega, _, *further = rows.reshape(len(rows), time.size * self.problem.lanes)
        lane = np.tile(np.arange(self.problem.lanes), time.size)
        return States(self._dimensionless(np.reshape(time, (-1, 1))).ravel(), rotation, omega, further, lane)

    def _by_state(self, time: Floats, values: Floats) -> Any:
        """Return one value per element of `_states` in the shape of the scene followed by the shape of the times."""
        return self._over_time(time, values.reshape(time.size, self.problem.lanes))

    def _stresses(self, time: Floats) -> Stresses:
        """Return the mean normal stresses of `Motion.at` at times in s, with the axes of the scene before the times."""
        states = self._states(time)
        outputs = self._mean_forces.outputs(states)
        unit = before(stress_unit(self.plan.scene.arc), time.ndim)
        of_weight = self._by_state(time, outputs["pressing"]) * unit
        effective = self._by_state(time, outputs["normal"]) * unit
        of_lanes = states.rotation.reshape(time.size, *self.shape)
        load = self._water_load(of_lanes)
        return Stresses(of_weight + self._by_state(time, load), effective)

    def _water_load(self, rotation: Any) -> Any:
        """Return the mean normal stress at rotations (rad) from the weight of free water above the mass, Pa.

        The result has the shape of the rotations.
        """
        section: Any = self.plan.scene.arc
        if not section.in_standing_water:
            return np.zeros_like(rotation)
        if "rotation" not in self.plan.effects:
            rotation = np.zeros_like(rotation)
        pressure = section.mean_pressure(rotation)
        lift = section.mean_lift(rotation)
        return pressure - lift

    def final_stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """Return the mean normal stress of each lane in one state, such as the state at its end, Pa.

        Time is in s, rotation in rad, and omega dimensionless.
        """
        at, rotation, omega = map(np.ravel, (time / self._time_scale, rotation, omega))
        states = States(at, rotation, omega, None, np.arange(self.problem.lanes))
        pressing = self.motion._shaped(self._mean_forces.outputs(states)["pressing"])
        of_weight = pressing * stress_unit(self.plan.scene.arc)
        return of_weight + self._water_load(self.motion._shaped(rotation))

    def further_factors(self) -> FurtherFactors:
        """Return the factors of safety with residual strength and at rest. See `Motion.further_factors`."""
        lanes = np.arange(self.problem.lanes)
        unknown = np.full(lanes.size, np.nan)
        residual = unknown
        if not self.problem.functions:  # the values of a Python function at great slip are unknown
            nothing = np.zeros(lanes.size)
            further = [nothing] * (len(self.problem.program.states) - 1)
            further[0] = np.full(lanes.size, _LONG)
            softened = States(nothing, nothing, nothing, further, lanes)
            residual = self.forces.factor_of_safety(softened)
        at_rest = unknown
        kept = 1.0
        if not self.shape and self.motion.arrested:
            end = self._states(np.asarray(self.motion.settling_time))
            at_rest = self.forces.factor_of_safety(end)
            (share,) = self.forces.kept_cohesion(end)
            kept = float(share)
        of_closure = {"residual": residual, "at_rest": at_rest}
        values = []
        methods = []
        for quantity, value in of_closure.items():
            by_start = self.plan.scene.by_start(quantity, self.motion, kept)
            factor, method = by_start or (self.motion._shaped(value), "")
            values.append(factor)
            methods.append(method)
        return FurtherFactors(*values, *methods)

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """Return the mean pore pressure at times, Pa. See `Motion.pore_pressure_at`."""
        stresses = self._stresses(self._checked(times))
        return stresses.total - stresses.effective

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """Return the mean effective normal stress at times, Pa. See `Motion.effective_stress_at`."""
        return np.maximum(self._stresses(self._checked(times)).effective, 0.0)

    def friction_at(self, times: ArrayLike) -> Any:
        """Return the mobilised friction coefficient at times. See `Motion.friction_at`."""
        time = self._checked(times)
        outputs = self.forces.outputs(self._states(time))
        return self._by_state(time, np.where(outputs["normal"] <= 0.0, 0.0, outputs["mu"]))

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """Return the friction coefficient required for equilibrium at times. See `Motion.holding_friction_at`."""
        time = self._checked(times)
        return self._by_state(time, self.forces.holding_friction(self._states(time)))

    def strength_at(self, times: ArrayLike) -> Strengths:
        """Return the strengths of `Motion.strength_at` at times in s."""
        time = self._checked(times)
        unit = before(stress_unit(self.plan.scene.arc), time.ndim)
        states = self._states(time)
        mobilised, required = self.forces.strengths(states)
        return Strengths(
            mobilised=unit * self._by_state(time, mobilised), required=unit * self._by_state(time, required)
        )

    def path_at(self, times: ArrayLike) -> Any:
        """Return the length of the path at times, m. See `Motion.path_at`."""
        time = self._checked(times)
        _, _, _, slip, *_ = self._rows(time)
        return before(self._radius, time.ndim) * self._over_time(time, slip)

    def energy_at(self, times: ArrayLike) -> Energy:
        """Return the energy balance at times. See `Motion.energy_at`."""
        time = self._checked(times)
        return self._energy(time, np.reshape(time, (-1, 1)))

    def final_energy(self) -> Energy:
        """Return the energy balance of each lane at its own end. See `Motion.energy`."""
        last = np.reshape(self.motion.settling_time, (1, -1))
        return self._energy(np.zeros(()), last)

    def _energy(self, time: Floats, times: Floats) -> Energy:
        """Return the energy balance at ``times``, as in `_read`. The result has the axes of scene and ``time``."""
        problem = with_outputs(self.problem, ("energy",))
        _, omega, *_, work, dissipation = self._read(problem, times)
        unit = energy_unit(self.plan.scene.arc)
        rests = np.ravel(self.motion.arrested) & self._has_ended(times)
        kinetic = np.where(rests, 0.0, omega**2 / 2)
        of_times = partial(self._over_time, time)
        over_time = before(unit, time.ndim)
        return Energy(
            kinetic_start=self.motion._shaped(problem.cells()[ix.OMEGA] ** 2 / 2) * unit,
            kinetic_end=over_time * of_times(kinetic),
            work=over_time * of_times(work),
            dissipation=over_time * of_times(np.maximum(dissipation, 0.0)),
        )

    @cached_property
    def _events(self) -> Log:
        """Return the log of events of a single motion, empty for an ensemble."""
        log: Log = []
        if not self.shape:
            integrate_problem(self.problem, log=log)
        return log

    def lift_off(self) -> tuple[float, ...]:
        """Return the times of lift-off, s. See `Motion.lift_off`."""
        scale = self._time_scale
        times = []
        lifted = False
        resumed = -1.0
        for event, time, _, _ in self._events:
            lifts = event == ix.NOTE_LIFTS
            if lifts and not lifted and resumed != time:
                times.append(time * scale)
            begins = event == ix.NOTE_BEGINS
            resumed = time if begins and lifted else -1.0
            lifted = lifts or (lifted and event == ix.NOTE_STANDS)
        return tuple(times)

    def phases(self) -> tuple[Phase, ...]:
        """Return the phases of the motion. See `Motion.phases`."""
        scale = self._time_scale
        last = self.motion.settling_time
        phases = []
        for event, time, rotation, direction in self._events:
            if event == ix.NOTE_BEGINS:
                phase = Phase(time * scale, last, rotation, int(direction))
                phases.append(phase)
            elif event == ix.NOTE_STANDS:
                phase = phases.pop()
                phases.append(phase._replace(end=time * scale))
        return tuple(phases)

    def energy_error_estimate(self) -> float:
        """Return an estimate of the relative error of the energy balance. See `Motion.energy_error_estimate`."""
        times = np.linspace(0.0, self.motion.settling_time, ENERGY_CHECKS)
        energy = self.energy_at(times)
        exchanged = energy.kinetic_start + np.abs(energy.work) + energy.dissipation
        greatest = np.maximum.accumulate(exchanged)
        return float(2 * np.max(np.abs(energy.residual) / np.maximum(greatest, 1e-300)))
