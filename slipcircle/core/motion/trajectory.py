"""A solved scene, one or an ensemble's lanes: how it ended, and in SI units what it is asked along the way.

Dimensionless numbers become SI units here: times by sqrt(R/g), lengths along the arc by R.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from slipcircle.base.checks import choose, may_overflow, plain
from slipcircle.base.kinds import cached_property
from slipcircle.core.doors import room
from slipcircle.core.motion.states import STATUS_OF_END, State, Status
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of


class Trajectory:
    """The lanes of a solved scene and their final cells; `Motion` says what these amount to.

    Cells are of the scene's shape, (cells, *shape); of a single scene they are numbers.
    """

    def __init__(self, plan: Plan, final: Any, invalid: Any = False, problem: Problem | None = None) -> None:
        self.plan = plan
        self.shape: tuple[int, ...] = plan.scene.shape
        self.invalid = invalid
        self._final = final
        self._radius = plain(plan.scene.arc.radius)
        self._time_scale = plan.scene.arc.time_scale
        if problem is not None:
            self.problem = problem

    @cached_property
    def _history(self) -> Any:
        return room("history").History(self)

    @cached_property
    def problem(self) -> Problem:
        return problem_of(self.plan, self.invalid)

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
        return self._history.at(times)

    def _state(self, time: Any, rotation: Any, omega: Any, rate: Any, stress: Any) -> State:
        """A state in SI units from dimensionless numbers of the shape of the time."""
        axes = getattr(time, "ndim", 0) - len(self.shape)
        scale = before(self._time_scale, axes)
        radius = before(self._radius, axes)
        with may_overflow(self.shape):
            angular_velocity = omega / scale
            velocity = radius * angular_velocity
            acceleration = radius * rate / scale**2
            displacement = radius * rotation
        columns = (rotation, angular_velocity, velocity, displacement, acceleration)
        return State(time, *(column + 0.0 for column in columns), stress=stress)

    # --- forces and energy -------------------------------------------------------------------------------------------

    @property
    def stress_unit(self) -> Any:
        """Pa for one of normal force over Theta*: sigma_ref over lambda/Theta*."""
        arc = self.plan.scene.arc
        return plain(arc.reference_stress / arc.moment_coefficients.resistance_factor)

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """The mean pore pressure on the slip surface, with what heat has added, Pa; times as for `at`."""
        return self._history.pore_pressure_at(times)

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """The mean normal stress on the slip surface less the pore pressure, 0 where that is more, Pa; as for `at`."""
        return self._history.effective_stress_at(times)

    def friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient that the law gives, 0 where contact is lost; times as for `at`."""
        return self._history.friction_at(times)

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient at which the mass, brought to rest where it is, would just stay; times as for `at`.

        NaN where contact is lost.
        """
        return self._history.holding_friction_at(times)

    def path_at(self, times: ArrayLike) -> Any:
        """The path travelled from the start, there and back, m; times as for `at`."""
        return self._history.path_at(times)

    def energy_at(self, times: ArrayLike) -> Any:
        """The energy balance from the start to any times, as for `at`; integrated with the motion on request."""
        return self._history.energy_at(times)

    @property
    def energy_unit(self) -> Any:
        """J for one of omega*^2/2."""
        arc = self.plan.scene.arc
        weight_of_area = np.multiply(arc.width, arc.mean_unit_weight)
        weight_times_radius = weight_of_area * np.power(arc.radius, 3.0)
        return plain(weight_times_radius * arc.dimensionless.moment_of_inertia)


def before(values: Any, axes: int) -> Any:
    """Numbers of lanes with further axes for times; one number stays one."""
    return values if type(values) is float else np.reshape(values, (*np.shape(values), *[1] * axes))
