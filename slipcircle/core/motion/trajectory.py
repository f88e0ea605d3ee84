"""A solved scene over time: states, stresses, friction and energy at any times, of one scene or of an ensemble's lanes.

The integration keeps a few cells of each lane's end; what happens on the way is integrated again on request.
Dimensionless numbers become SI units here: times by sqrt(R/g), lengths along the arc by R.
"""

import math
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from slipcircle.base.checks import INFINITY, choose, mistakes, plain, raise_all
from slipcircle.base.kinds import Floats
from slipcircle.core.motion.forces import Forces
from slipcircle.core.motion.states import STATUS_OF_END, Energy, State, Status
from slipcircle.core.problem.plan import Plan, recipe_of
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.program.program import Log
from slipcircle.core.walk.lanes import States, read

ALLOWED_TIMES = (-5e-324, INFINITY, "times in s, not before 0")


class Stresses(NamedTuple):
    """Mean normal stress with the water and without, Pa, each of the shape of states."""

    total: Any
    effective: Any


class Trajectory:
    """The lanes of a solved scene and their final cells; `Motion` says what these amount to.

    Cells are of the scene's shape, (cells, *shape); of a single scene they are numbers.
    """

    def __init__(self, plan: Plan, final: Any, log: Log, invalid: Any = False, problem: Problem | None = None) -> None:
        self.plan = plan
        self.shape: tuple[int, ...] = plan.scene.shape
        self.invalid = invalid
        self._final = final
        self._log = log
        self._radius = plain(plan.scene.arc.radius)
        self._time_scale = plan.scene.arc.time_scale
        self._last_read: tuple[bytes, Floats] | None = None
        if problem is not None:
            self.problem = problem

    @property
    def is_finite(self) -> bool:
        """Whether a single motion has a result, and that does not overflow."""
        angular_velocity = self._final[ix.PEAK_OMEGA] / self._time_scale
        run_out = self._radius * self._final[ix.END_ROTATION]
        return self._solved and math.isfinite(run_out + self._radius * angular_velocity)

    @cached_property
    def problem(self) -> Problem:
        return problem_of(self.plan, self.invalid)

    @cached_property
    def _forces(self) -> Forces:
        return Forces(self.problem)

    @cached_property
    def _mean_forces(self) -> Forces:
        """Forces of which the stresses are means over the arc."""
        scene = self.plan.scene.of_means()
        if scene is self.plan.scene:
            return self._forces
        plan = replace(self.plan, scene=scene, recipe=recipe_of(scene))
        return Forces(problem_of(plan, self.invalid))

    def _shaped(self, values: Any) -> Any:
        """One number of each lane in the scene's shape; of a single scene a Python number."""
        if self.shape:
            return np.reshape(values, self.shape)
        return values.item() if hasattr(values, "item") else values

    # --- how it ended ------------------------------------------------------------------------------------------------

    @property
    def _rests_at_end(self) -> Any:
        """Whether each lane is at rest at its end, for good or until something changes beyond its end time."""
        status = self._final[ix.STATUS]
        return (status == ix.PAUSED) | (status == ix.ARRESTED)

    @cached_property
    def _status(self) -> Any:
        """The status of each lane, as a number."""
        ended = self._final[ix.STATUS]
        status: Any
        if self.shape:
            status = STATUS_OF_END[ended.astype(np.intp)]
        else:
            status = int(STATUS_OF_END[int(ended)])
        has_turned = self._final[ix.TURNS] > 0.0
        status = choose((status == Status.RESTS) & has_turned, int(Status.TURNED), status)
        status = choose(self._final[ix.TIME] == np.inf, int(Status.CREEPS), status)
        answered = status <= Status.CREEPS
        still = self._final[ix.PHASES] == 0.0
        stays = still & (ended != ix.STOPPED)
        status = choose(answered & stays, int(Status.STAYS), status)
        return choose(self.invalid, int(Status.INVALID), status)

    @cached_property
    def _solved(self) -> Any:
        """Which lanes have a result."""
        return self._status <= Status.CREEPS

    def _known(self, values: Any) -> Any:
        """Values of lanes with a result, NaN of the others; without negative zeros."""
        return choose(self._solved, values, np.nan) + 0.0

    @cached_property
    def _duration(self) -> Any:
        """Time from the start to the end of each lane, s."""
        rest = self._final[ix.REST_SINCE] * self._time_scale
        ended = self._final[ix.STATUS] == ix.ENDED
        return self._known(choose(ended, self.plan.scene.until, rest))

    @cached_property
    def _settling_time(self) -> Any:
        """Time by which each lane has covered 99 % of its run-out if it creeps, else its duration, s."""
        time = self._final[ix.REST_SINCE] * self._time_scale
        return choose(self._status == Status.CREEPS, time, self._duration)

    # --- states ------------------------------------------------------------------------------------------------------

    def at(self, times: ArrayLike) -> State:
        """The state at any times between the start and the end, and at rest after an arrest.

        Parameters
        ----------
        times : float or array_like
            s; the same for all lanes of an ensemble, whose states get the scene's shape followed by theirs.

        Raises
        ------
        ValueError
            For times before the start, not finite, or after the end of a motion that has not come to rest.
        """
        time = self._checked(times)
        rotation, omega, rate, *_ = (self._over_time(time, row) for row in self._rows(time))
        every_time = np.broadcast_to(time, self.shape + time.shape)[()]
        return self._state(every_time, rotation, omega, rate, lambda: self._stresses(time).total)

    def _state(self, time: Any, rotation: Any, omega: Any, rate: Any, stress: Any) -> State:
        """A state in SI units from dimensionless numbers of the shape of the time."""
        axes = np.ndim(time) - len(self.shape)
        scale = _before(self._time_scale, axes)
        radius = _before(self._radius, axes)
        with np.errstate(over="ignore"):  # an overflow is refused where the result is read
            angular_velocity = omega / scale
            velocity = radius * angular_velocity
            acceleration = radius * rate / scale**2
            displacement = radius * rotation
        columns = (rotation, angular_velocity, velocity, displacement, acceleration)
        return State(time, *(column + 0.0 for column in columns), stress=stress)

    def _checked(self, times: ArrayLike) -> Floats:
        """Times as an array, none of them beyond the end of a lane that still moves there."""
        faults = mistakes({"times": times}, {"times": ALLOWED_TIMES})
        raise_all("Motion.at", faults)
        time = np.asarray(times, dtype=np.float64)
        status = self._final[ix.STATUS]
        known_until = choose(status == ix.PAUSED, self.plan.scene.until, self._duration)
        moving = status != ix.ARRESTED
        ends = choose(moving & self._solved, known_until, np.inf)
        last = float(np.min(ends))
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

    def _dimensionless(self, flat_times: Floats) -> Floats:
        """Times in s over the time scale of each lane, (times, lanes)."""
        return flat_times[:, None] / np.broadcast_to(self._time_scale, self.shape).reshape(-1)

    def _read(self, problem: Problem, flat_times: Floats) -> Floats:
        """Rotation, omega, its rate, slip and further states at times in s, (rows, times, lanes)."""
        increasing = np.argsort(flat_times, kind="stable")
        rows = read(problem, self._dimensionless(flat_times[increasing]))
        states = np.empty_like(rows)
        states[:, increasing] = rows
        return states

    def _rows(self, time: Floats) -> Floats:
        """The same of this motion; kept for the same times again."""
        key = time.tobytes()
        if self._last_read is not None:
            last_key, last_rows = self._last_read
            if last_key == key:
                return last_rows
        flat_times = np.ravel(time)
        rows = self._read(self.problem, flat_times)
        ended = self._has_ended(flat_times)
        at_end = (ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE)
        for row, entry in zip(rows, at_end, strict=False):
            row[:] = np.where(ended, np.ravel(self._final[entry]), row)
        self._last_read = key, rows
        return rows

    def _has_ended(self, flat_times: Floats) -> Any:
        """Which lanes have ended at times in s, (times, lanes), whatever rounding makes of the time of the end."""
        return flat_times[:, None] >= np.ravel(self._duration)

    def _over_time(self, time: Floats, values: Floats) -> Any:
        """Values (times, lanes) in the scene's shape followed by that of the times."""
        return values.T.reshape(self.shape + time.shape)[()]

    # --- forces and energy -------------------------------------------------------------------------------------------

    def _states(self, time: Floats) -> States:
        """States at times in s, as separate lanes, time by time."""
        rows = self._rows(time)
        rotation, omega, _, *further = rows.reshape(len(rows), time.size * self.problem.lanes)
        lane = np.tile(np.arange(self.problem.lanes), time.size)
        return States(self._dimensionless(np.ravel(time)).ravel(), rotation, omega, further, lane)

    def _by_state(self, time: Floats, values: Floats) -> Any:
        """A number of each of `_states` in the scene's shape followed by that of the times."""
        return self._over_time(time, values.reshape(time.size, self.problem.lanes))

    def _stresses(self, time: Floats) -> Stresses:
        outputs = self._mean_forces.outputs(self._states(time))
        unit = _before(self.stress_unit, time.ndim)
        total = self._by_state(time, outputs["pressing"])
        effective = self._by_state(time, outputs["normal"])
        return Stresses(total * unit, effective * unit)

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        arc = self.plan.scene.arc
        return plain(arc.reference_stress / arc.moment_coefficients.resistance_factor)

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """The mean pore pressure on the slip surface, with what heat has added, Pa; times as for `at`."""
        stresses = self._stresses(self._checked(times))
        return stresses.total - stresses.effective

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """The mean normal stress on the slip surface less the pore pressure, 0 where that is more, Pa; as for `at`."""
        stresses = self._stresses(self._checked(times))
        return np.maximum(stresses.effective, 0.0)

    def friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient that the law gives, 0 where contact is lost; times as for `at`."""
        time = self._checked(times)
        outputs = self._forces.outputs(self._states(time))
        mobilised = np.where(outputs["normal"] > 0.0, outputs["mu"], 0.0)
        return self._by_state(time, mobilised)

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient at which the mass, brought to rest where it is, would just stay; times as for `at`.

        NaN where contact is lost.
        """
        time = self._checked(times)
        return self._by_state(time, self._forces.holding_friction(self._states(time)))

    def path_at(self, times: ArrayLike) -> Any:
        """The path travelled from the start, there and back, m; times as for `at`."""
        time = self._checked(times)
        _, _, _, slip, *_ = self._rows(time)
        return _before(self._radius, time.ndim) * self._over_time(time, slip)

    def energy_at(self, times: ArrayLike) -> Energy:
        """The energy balance from the start to any times, as for `at`; integrated with the motion on request."""
        time = self._checked(times)
        flat_times = np.ravel(time)
        problem = self.problem.with_outputs(("energy",))
        program = problem.program
        _, omega, _, _, *further = self._read(problem, flat_times)
        names = [program.cells[cell] for cell, _, _ in program.states[2:]]
        rows = dict(zip(names, further, strict=True))
        unit = self.energy_unit
        rests = np.ravel(self._rests_at_end) & self._has_ended(flat_times)
        kinetic = np.where(rests, 0.0, omega**2 / 2)
        of_times = partial(self._over_time, time)
        over_time = _before(unit, time.ndim)
        first_omega = problem.cells()[ix.OMEGA]
        return Energy(
            kinetic_start=self._shaped(first_omega**2 / 2) * unit,
            kinetic_end=over_time * of_times(kinetic),
            work=over_time * of_times(rows["work"]),
            dissipation=over_time * of_times(np.maximum(rows["dissipation"], 0.0)),
        )

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.plan.scene.arc
        weight_of_area = np.multiply(arc.width, arc.mean_unit_weight)
        weight_times_radius = weight_of_area * np.power(arc.radius, 3.0)
        return plain(weight_times_radius * arc.dimensionless.moment_of_inertia)


def _before(values: Any, axes: int) -> Any:
    """Numbers of lanes with further axes for times; one number stays one."""
    return values if type(values) is float else np.reshape(values, (*np.shape(values), *[1] * axes))
