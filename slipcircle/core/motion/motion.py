"""The motion of a scene, or of each lane of an ensemble: what happened, read off at its end, and as functions of time.

Final cells are of the scene's shape, (cells, *shape); of a single scene they are numbers. Dimensionless numbers become
SI units here: times by sqrt(R/g), lengths along the arc by R.
Phases, events and signs are those of ``notebooks/0_the_method.ipynb``.
"""

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Generic, Self

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from slipcircle.base.checks import choose, may_overflow, plain
from slipcircle.base.forms import Forms
from slipcircle.base.kinds import Numbers, cached_property
from slipcircle.core.doors import room
from slipcircle.core.motion.states import State, Status, state_of, statuses
from slipcircle.core.problem.plan import Plan
from slipcircle.core.problem.problem import Problem, problem_of
from slipcircle.core.walk.lanes import integrate


class Motion(Forms, Generic[Numbers]):
    """A solved scene. For a scene of arrays every attribute is an array, NaN for cases without a result (`reason`).

    Attributes
    ----------
    plan : Plan
        How it was solved.
    status : Status
        How it ended.
    reason : str
        Why there is no result; empty if there is one.
    moves, arrested : bool
        Whether the mass moves at all, and whether it rests at the end.
    duration : float
        Time from the start to the end, s; infinite if it creeps to its equilibrium.
    settling_time : float
        Time by which 99 % of the run-out is covered if it creeps, else the duration, s.
    run_out : float
        Greatest displacement along the arc, m, negative up-slope. A mass that swings back rests at `end.displacement`.
    slow_run_out : float
        Displacement along the arc at which a slowly moved mass rests, m; NaN with `no_slow_run_out`.
    no_slow_run_out : str
        Why there is no slow run-out; empty unless forces depend on time, speed or heat, or nothing holds the mass.
    outcomes : mapping
        `run_out`, `peak_velocity` and `duration` by name.
    farthest, peak, end : State
        States at the greatest displacement, at the greatest speed and at the end.
    outside_range : bool
        Whether it leaves the range of validity, the `rotation_range` of its mass.
    range_end : State or None
        State in which a single motion leaves it.
    limit_friction : float
        Friction coefficient at limit equilibrium at the start, for the direction in which gravity pulls.
    yield_coefficient : float
        k_y, down-slope acceleration over g at which it would just move, by the method of the start; negative if moving.
    friction, factor_of_safety : float
        Friction coefficient and factor of safety by the starting method at the start; infinite without a drive.
    further_factors : FurtherFactors
        Factors of safety with ``residual`` strength on the original geometry, and ``at_rest`` after the slide.
    error_estimate : float
        Estimated relative error of peak velocity, run-out and duration, and of `at` relative to the first two.
    warnings : tuple of str
        Warnings about a single motion; usually empty.

    A motion of several cases has a length and an index; `to_dict`, `to_pandas` and `to_xarray` export tables.
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
        return problem_of(self.plan, self.invalid).ending_first(self._final[ix.FIRST_ONLY])

    def _shaped(self, values: Any) -> Any:
        """One number of each lane in the scene's shape; of a single scene a Python number."""
        if self.shape:
            return np.reshape(values, self.shape)
        return values.item() if hasattr(values, "item") else values

    # --- how it ended ------------------------------------------------------------------------------------------------

    @cached_property
    def status(self) -> Any:
        status = statuses(self._final, self.invalid, plain(self.plan.scene.strength_factor))
        return status if self.shape else Status(status)

    @property
    def reason(self) -> Any:
        if not self.shape:
            return self.status.reason
        reasons = np.array([status.reason for status in Status])
        return reasons[self.status]

    def count(self) -> dict[str, int]:
        """Number of cases of each status, by its name."""
        counts = Counter(np.ravel(self.status).tolist())
        return {status.name: counts[status] for status in Status if status in counts}

    @property
    def moves(self) -> Any:
        return self._solved & (self._final[ix.PHASES] > 0.0)

    @property
    def arrested(self) -> Any:
        """Whether it is at rest at its end, for good or until something changes beyond its end time."""
        status = self._final[ix.STATUS]
        return (status == ix.PAUSED) | (status == ix.ARRESTED)

    @property
    def turnings(self) -> Any:
        """Number of times the mass has turned back."""
        return self._whole_number(ix.TURNS)

    @property
    def slips(self) -> Any:
        """Number of times the mass has begun to slide."""
        return self._whole_number(ix.PHASES)

    def _whole_number(self, entry: int) -> Any:
        count = self._final[entry]
        return count.astype(int) if self.shape else int(count)

    @property
    def brake(self) -> Any:
        """q, twice the decrease of the rate per unit of omega*^2 at the start: the speed decays like exp(-q phi/2)."""
        return self._shaped(self._history.forces.brake)

    @cached_property
    def _solved(self) -> Any:
        """Which lanes have a result."""
        return self.status <= Status.CREEPS

    def _known(self, values: Any) -> Any:
        """Values of lanes with a result, NaN of the others; without negative zeros."""
        return choose(self._solved, values, np.nan) + 0.0

    # --- results -----------------------------------------------------------------------------------------------------

    @cached_property
    def outcomes(self) -> Mapping[str, Numbers]:
        final = self._final
        with may_overflow(self.shape):
            angular_velocity = final[ix.PEAK_OMEGA] / self._time_scale
            values = {
                "run_out": self._radius * final[ix.REACH_ROTATION],
                "peak_velocity": self._radius * angular_velocity,
            }
        return {name: self._known(value) for name, value in values.items()} | {"duration": self.duration}

    @cached_property
    def duration(self) -> Numbers:
        rest = self._final[ix.REST_SINCE] * self._time_scale
        ended = self._final[ix.STATUS] == ix.ENDED
        return self._known(choose(ended, self.plan.scene.until, rest))

    @cached_property
    def settling_time(self) -> Numbers:
        return choose(self.status == Status.CREEPS, self._final[ix.REST_SINCE] * self._time_scale, self.duration)

    @property
    def run_out(self) -> Numbers:
        return self.outcomes["run_out"]

    @cached_property
    def slow_run_out(self) -> Numbers:
        """Displacement at which the net moment at rest vanishes, for laws of slip, water and layers, m.

        However slowly a mass creeps, it rests there: with constant friction and no water at R (psi_0 - delta). A free
        mass arrives with speed and rests about twice as far from the start. Its initial velocity is ignored.
        """
        rotation = self._shaped(room("creep").slow_rotation(self.problem))
        return self._known(self._radius * rotation)

    @property
    def no_slow_run_out(self) -> str:
        if other := room("creep").other_than_position(self.problem):
            return f"forces depend on {other}"
        return "nothing holds it" if np.any(np.isnan(self.slow_run_out)) else ""

    @cached_property
    def end(self) -> State:
        return self._final_state(self.duration, ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE)

    @cached_property
    def farthest(self) -> State:
        final = self._final
        at_end = final[ix.REACH_ROTATION] == final[ix.END_ROTATION]
        time = choose(at_end, self.duration, final[ix.REACH_TIME] * self._time_scale)
        return self._final_state(time, ix.REACH_ROTATION, ix.END_OMEGA, ix.END_RATE, moving=at_end)

    @cached_property
    def peak(self) -> State:
        final = self._final
        peak_time = final[ix.PEAK_TIME]
        ended = final[ix.STATUS] == ix.ENDED
        last = peak_time == final[ix.END_TIME]
        still = final[ix.PHASES] == 0.0
        at_end = last & ended | still
        time = choose(at_end, self.duration, peak_time * self._time_scale)
        if not self.shape and self._varies_in_time and 0.0 < time < self.duration:
            return self.at(time)  # of the rounded time: where a force jumps, as it is from then on
        return self._final_state(time, ix.PEAK_ROTATION, ix.PEAK_OMEGA, ix.PEAK_RATE)

    @property
    def _varies_in_time(self) -> bool:
        return any(table.kind == "time" for table in self.problem.program.tables)

    def _final_state(self, time: Any, rotation: int, omega: int, rate: int, moving: Any = True) -> State:
        """A state of each lane from its final cells; where it is not moving, without speed and rate."""
        speed = choose(moving, self._final[omega], 0.0)
        gain = choose(moving, self._final[rate], 0.0)
        angle, speed, gain = map(self._known, (self._final[rotation], speed, gain))
        rows = angle, speed, gain
        return state_of(self.plan.scene, time + 0.0, *rows, lambda: self._history.final_stress(time, angle, speed))

    @property
    def journey(self) -> Any:
        """Return how far toe and centroid move to the farthest position: rise, horizontal travel, travel angle."""
        return self.plan.scene.arc.journey(self.farthest.rotation)

    @cached_property
    def outside_range(self) -> Any:
        return room("validity").outside(self)

    @cached_property
    def range_end(self) -> Any:
        return room("validity").range_end(self)

    # --- along the way -----------------------------------------------------------------------------------------------

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
    def velocity_class(self) -> str:
        """Class of the peak velocity by Cruden and Varnes (1996), such as "extremely rapid"; empty without a motion."""
        return str(room("velocity").velocity_class(self))

    @cached_property
    def velocity_times(self) -> Any:
        """How long it moves in each velocity class, s."""
        return room("velocity").velocity_times(self)

    @property
    def lift_off(self) -> tuple[float, ...]:
        """Times at which contact with the slip surface is lost by uplift or shaking, s.

        A loss of contact that lasts through standstills counts once.
        """
        return self._history.lift_off()

    @cached_property
    def phases(self) -> tuple[Any, ...]:
        """Phases of a single motion between its standstills, `slipcircle.history.Phase`."""
        return self._history.phases()

    # --- at the start ------------------------------------------------------------------------------------------------

    def _at_start(self, quantity: str) -> Any:
        by_start = self.plan.scene.by_start(quantity, self)
        return by_start[0] if by_start else self._shaped(self._history.forces.statics[quantity])

    @property
    def limit_friction(self) -> Any:
        return self._at_start("limit_friction")

    @property
    def factor_of_safety(self) -> Any:
        return self._at_start("factor_of_safety")

    @property
    def further_factors(self) -> Any:
        return self._history.further_factors()

    @property
    def yield_coefficient(self) -> Any:
        return self._at_start("yield_coefficient")

    @property
    def friction(self) -> Any:
        return self._at_start("friction")

    # --- accuracy ----------------------------------------------------------------------------------------------------

    @cached_property
    def error_estimate(self) -> Numbers:
        final = np.reshape(self._final, (len(self._final), -1)) if self.shape else self._final
        return self._shaped(room("estimate").estimate(self.plan, self.problem, final))

    @cached_property
    def energy(self) -> Any:
        """Energy balance from the start to the end, of a mass that creeps to its `settling_time`."""
        return self.energy_at(self.settling_time)

    @cached_property
    def energy_error_estimate(self) -> float:
        """Greatest error of the energy balance of a single motion, relative to all energy until then."""
        return self._history.energy_error_estimate()

    @property
    def warnings(self) -> tuple[str, ...]:
        return tuple(room("warnings").collect_warnings(self))

    def sensitivity(self) -> Any:
        """Derivatives of a single motion by every number of its scene, with stated errors.

        They are those of neighbouring scenes, extrapolated: `slipcircle.derivatives.neighbours`.

        Raises
        ------
        ValueError
            If the scene is exactly at its limit, where the motion has no derivative, or has arrays.
        """
        return room("sensitivity").sensitivity(self)

    # --- lanes, and one line of text ---------------------------------------------------------------------------------

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a single motion has no len(): its scene has no arrays")
        return int(self.shape[0])

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, index: Any) -> Self:
        """The motion of one lane, or of some, by NumPy's indices of the scene's shape."""
        if not self.shape:
            raise TypeError("a single motion cannot be indexed: its scene has no arrays")
        scene = room("parameters").taken(self.plan.scene, lambda values: values[index])
        plan = replace(self.plan, scene=scene)
        invalid = np.broadcast_to(self.invalid, self.shape)[index]
        if scene.shape:
            rows = index if isinstance(index, tuple) else (index,)
            return type(self)(plan, self._final[(slice(None), *rows)], invalid)
        problem = problem_of(plan, invalid)  # alone a lane is solved to rounding
        return type(self)(plan, integrate(problem)[:, 0].tolist(), invalid, problem)

    def __repr__(self) -> str:
        name = self.plan.scene.name
        if name:
            name += ": "
        if self.shape:
            return f"<{math.prod(self.shape)} motions {name}{room('summary').ensemble_summary(self)}>"
        return f"<Motion {name}{room('summary').summary(self)}>"
