"""Motion of a scene, or of each lane of an ensemble: results at its end, and histories as functions of time.

Final cells have the shape (cells, *shape), and are numbers for a single scene. Dimensionless numbers are converted to
SI units: times by sqrt(R/g), lengths by R. ``notebooks/0_the_method.ipynb`` defines phases, events and signs.
"""

from __future__ import annotations  # so that a signature says ArrayLike

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Generic, Self

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from slipcircle.base.arrays import choose, may_overflow
from slipcircle.base.conversions import Conversions
from slipcircle.base.kinds import Names, Numbers, Shape, cached_property
from slipcircle.core.integrator.neighbours import integrate_single
from slipcircle.core.lazy import lazy_import
from slipcircle.core.motion.states import CREEPS, STATUSES, Status, statuses
from slipcircle.core.problem.plan import Plan, recipe_of
from slipcircle.core.problem.problem import Problem, problem_of

if TYPE_CHECKING:
    from slipcircle.core.motion.state import State


class Motion(Conversions, Generic[Numbers]):
    """Solved scene. For an ensemble every result is an array, NaN for cases without a result (`reason`).

    A motion of several cases has a length and an index. `to_dict`, `to_pandas` and `to_xarray` export tables.

    Attributes
    ----------
    plan : Plan
        Method of solution.
    shape : tuple of int
        Shape of the scene, () for a single motion.
    """

    def __init__(
        self, plan: Plan, final: Any, invalid: Any = False, problem: Problem | None = None, runs: Any = None
    ) -> None:
        self.plan = plan
        self.shape: Shape = plan.scene.shape
        self.invalid = invalid
        self._final = final
        self._radius = plan.scene.arc.units["m"]
        self._time_scale = plan.scene.arc.time_scale
        self._runs = runs
        if problem is not None:
            self.problem = problem

    @classmethod
    def of_single(cls, plan: Plan, invalid: Any = False) -> Self:
        """Return the motion of a single scene, with numbers as results, which are ten times cheaper than arrays."""
        problem = problem_of(plan, invalid)
        final, runs = integrate_single(problem)
        return cls(plan, final, invalid, problem, runs)

    @cached_property
    def _history(self) -> Any:
        return lazy_import("history").History(self)

    @cached_property
    def problem(self) -> Problem:
        """Scene's initial value problem, as integrated."""
        cells = {name: self._final[getattr(ix, name)] for name in ("FIRST_ONLY", "LIMIT", "LIMIT_REST")}
        return problem_of(self.plan, self.invalid).begin_with(**cells)

    def _shaped(self, values: Any) -> Any:
        """Return one number per case in the scene's shape, or a Python number for a single scene."""
        if self.shape:
            return np.reshape(values, self.shape)
        return values.item() if hasattr(values, "item") else values

    @cached_property
    def status(self) -> Any:
        """State at the end, a `Status`; for an ensemble an array of their numbers."""
        status = statuses(self._final, self.invalid, self.plan.scene)
        return status if self.shape else STATUSES[status]

    @property
    def reason(self) -> Any:
        """Reason for a missing result, empty if there is a result; an array of texts for an ensemble."""
        if not self.shape:
            return self.status.reason
        reasons = np.array([status.reason for status in Status])
        return reasons[self.status]

    def count(self) -> dict[str, int]:
        """Return the number of cases of each status, by its name."""
        counts = Counter(np.ravel(self.status).tolist())
        return {status.name: counts[status] for status in Status if status in counts}

    @property
    def moves(self) -> Any:
        """Whether the mass moves at all, a bool or an array with one value per case of an ensemble."""
        return self._solved & (self._final[ix.PHASES] > 0.0)

    @property
    def arrested(self) -> Any:
        """Whether the mass rests at the end of its motion, for good or until a force changes; a bool or an array."""
        status = self._final[ix.STATUS]
        return (status == ix.PAUSED) | (status == ix.ARRESTED)

    @property
    def turnings(self) -> Any:
        """Number of times the mass has turned back by the end, an integer or an array over the cases of an ensemble."""
        return self._whole_number(ix.TURNS)

    @property
    def slips(self) -> Any:
        """Number of phases of sliding, each between two standstills, an integer or an array over the cases."""
        return self._whole_number(ix.PHASES)

    def _whole_number(self, entry: int) -> Any:
        """Return one of the final cells, by its index, as an integer or an array of integers in the scene's shape."""
        count = self._final[entry]
        return count.astype(int) if self.shape else int(count)

    @property
    def brake(self) -> Any:
        """Twice the decrease of domega*/dt* per omega*^2 at the start, q; the speed decays like exp(-q phi/2)."""
        return self._shaped(self._history.forces.brake)

    @property
    def _solved(self) -> Any:
        """Mask of lanes (cases of an ensemble) with a result, or a bool for a single motion."""
        return self.status <= CREEPS

    @property
    def _unsolved(self) -> Any:
        """Summand of results: NaN for lanes without a result, otherwise 0, which also removes negative zeros."""
        return choose(self.status <= CREEPS, 0.0, np.nan)

    # --- results -----------------------------------------------------------------------------------------------------

    @cached_property
    def outcomes(self) -> Mapping[str, Numbers]:
        """Run-out, peak velocity and duration by name (`run_out`, `peak_velocity`, `duration`), in SI units."""
        return may_overflow(self.shape, self._outcomes)

    def _outcomes(self) -> Mapping[str, Numbers]:
        final = self._final
        unsolved = self._unsolved
        duration = final[ix.REST_SINCE] * self._time_scale
        ended = final[ix.STATUS] == ix.ENDED
        if ended is not False:
            duration = choose(ended, self.plan.scene.until, duration)
        return {
            "run_out": self._radius * final[ix.REACH_ROTATION] + unsolved,
            "peak_velocity": self._radius * (final[ix.PEAK_OMEGA] / self._time_scale) + unsolved,
            "duration": duration + unsolved,
        }

    @property
    def duration(self) -> Numbers:
        """Time from the start to the end, s; infinite if the mass creeps to its equilibrium."""
        return self.outcomes["duration"]

    @cached_property
    def settling_time(self) -> Numbers:
        """Time until a creeping mass has covered 99 % of its run-out, otherwise the duration, s."""
        return choose(self.status == CREEPS, self._final[ix.REST_SINCE] * self._time_scale, self.duration)

    @property
    def run_out(self) -> Numbers:
        """Greatest displacement along the arc, m, negative up-slope. A mass that swings back rests at `end`."""
        return self.outcomes["run_out"]

    @cached_property
    def slow_run_out(self) -> Numbers:
        """Displacement at which the net moment at rest vanishes, for laws of slip, water and layers, m.

        A mass that moves quasi-statically comes to rest there: with constant friction and without water at a
        displacement of R (psi_0 - delta). A mass that slides freely moves about twice as far. The initial velocity is
        ignored.
        """
        rotation = self._shaped(lazy_import("creep").slow_rotation(self.problem))
        return self._radius * rotation + self._unsolved

    @property
    def no_slow_run_out(self) -> str:
        """Reason for a missing slow run-out: forces depend on time, speed or heat, or nothing holds the mass."""
        if other := lazy_import("creep").other_than_position(self.problem):
            return f"forces depend on {other}"
        return "nothing holds it" if np.any(np.isnan(self.slow_run_out)) else ""

    @cached_property
    def end(self) -> State:
        """State at the end of the motion, in SI units."""
        state: State = lazy_import("ends").final_state(self)
        return state

    @cached_property
    def farthest(self) -> State:
        """State at the greatest displacement along the arc, in SI units."""
        state: State = lazy_import("ends").farthest_state(self)
        return state

    @cached_property
    def peak(self) -> State:
        """State at the greatest speed, in SI units."""
        state: State = lazy_import("ends").peak_state(self)
        return state

    @property
    def journey(self) -> Any:
        """Displacement of toe and centroid to the farthest position, a `slipcircle.history.Journey`."""
        return self.plan.scene.arc.journey(self.farthest.rotation)

    @cached_property
    def outside_range(self) -> Any:
        """Whether the motion leaves the range of validity, the `rotation_range` of its mass."""
        return lazy_import("validity").outside(self)

    @cached_property
    def range_end(self) -> Any:
        """State in which a single motion leaves the range of validity, or None."""
        return lazy_import("validity").range_end(self)

    # --- along the way -----------------------------------------------------------------------------------------------

    def at(self, times: ArrayLike) -> State:
        """Return the state at any times between the start and the end, and at rest after an arrest.

        Parameters
        ----------
        times : float or array_like
            Times in s, the same for all lanes of an ensemble. States have the scene's shape followed by the times',
            and are NaN after a lane without a result has ended.

        Raises
        ------
        ValueError
            If a time is before the start, not finite, or after the end of a motion that has not come to rest.
        """
        return self._history.at(times)

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """Return the mean pore pressure on the slip surface in Pa, with the increase by heat, at times as in `at`."""
        return self._history.pore_pressure_at(times)

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """Return the mean effective normal stress on the slip surface in Pa, at least 0, at times as in `at`."""
        return self._history.effective_stress_at(times)

    def friction_at(self, times: ArrayLike) -> Any:
        """Return the friction coefficient by the law, 0 where contact is lost, at times as in `at`."""
        return self._history.friction_at(times)

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """Return the friction that would keep the mass at rest, NaN where contact is lost, at times as in `at`."""
        return self._history.holding_friction_at(times)

    def strength_at(self, times: ArrayLike) -> Any:
        """Return the mobilised shear strength and that required for equilibrium, Pa; times as for `at`.

        The fields ``mobilised`` and ``required`` are means over the slip surface and contain the strength factor. With
        the required strength the mass, brought to rest where it is, would just stay.
        """
        return self._history.strength_at(times)

    def path_at(self, times: ArrayLike) -> Any:
        """Return the length of the path from the start, back and forth, in m, at times as in `at`."""
        return self._history.path_at(times)

    def energy_at(self, times: ArrayLike) -> Any:
        """Return the energy balance from the start to times as in `at`, integrated with the motion on request."""
        return self._history.energy_at(times)

    @property
    def velocity_class(self) -> str:
        """Class of the peak velocity by Cruden and Varnes (1996), such as "extremely rapid"; empty without motion."""
        return str(lazy_import("velocity").velocity_class(self))

    @cached_property
    def velocity_times(self) -> Any:
        """Time that a single motion spends in each velocity class, s, in a named tuple by class."""
        return lazy_import("velocity").velocity_times(self)

    @property
    def lift_off(self) -> tuple[float, ...]:
        """Times at which contact with the slip surface is lost by uplift or shaking, s.

        A loss of contact that lasts through standstills is listed once.
        """
        return self._history.lift_off()

    @cached_property
    def phases(self) -> tuple[Any, ...]:
        """Phases of a single motion between its standstills, `slipcircle.history.Phase`."""
        return self._history.phases()

    # --- at the start ------------------------------------------------------------------------------------------------

    def _at_start(self, quantity: str) -> Any:
        """Return a quantity at the start by its name, by the starting method if it applies and else by the closure."""
        by_start = self.plan.scene.by_start(quantity, self)
        return by_start[0] if by_start else self._shaped(self._history.forces.statics[quantity])

    @property
    def limit_friction(self) -> Any:
        """Friction coefficient tan(phi) at limit equilibrium at the start, in the direction in which gravity pulls."""
        return self._at_start("limit_friction")

    @property
    def factor_of_safety(self) -> Any:
        """Factor of safety at the start by the starting method (by default the closure), infinite without a drive."""
        return self._at_start("factor_of_safety")

    @property
    def further_factors(self) -> Any:
        """Factors of safety with residual strength, and at rest, a `slipcircle.history.history.FurtherFactors`."""
        return self._history.further_factors()

    @property
    def yield_coefficient(self) -> Any:
        """Down-slope acceleration over g, k_y, at which the mass would just move, by the starting method.

        It is negative if the mass moves without shaking.
        """
        return self._at_start("yield_coefficient")

    @property
    def friction(self) -> Any:
        """Friction coefficient tan(phi) at the start, a number or an array over the cases of an ensemble."""
        return self._at_start("friction")

    # --- accuracy ----------------------------------------------------------------------------------------------------

    @cached_property
    def error_estimate(self) -> Numbers:
        """Estimated relative error of peak velocity, run-out and duration, and of `at` relative to the first two."""
        final = np.reshape(self._final, (len(self._final), -1)) if self.shape else self._final
        return self._shaped(lazy_import("estimate").estimate(self.plan, self.problem, final, self._runs))

    @cached_property
    def energy(self) -> Any:
        """Energy balance of each case from its start to its end, or to the `settling_time` of a creeping mass."""
        return self._history.final_energy()

    @cached_property
    def energy_error_estimate(self) -> float:
        """Greatest error of the energy balance of a single motion, relative to the energy exchanged until then."""
        return self._history.energy_error_estimate()

    @property
    def warnings(self) -> Names:
        """Warnings about a single motion, usually empty."""
        return tuple(lazy_import("warnings").collect_warnings(self))

    def sensitivity(self) -> Any:
        """Return derivatives of a single motion with respect to every input, each with an error bound.

        They are extrapolated from neighbouring scenes (`slipcircle.derivatives.neighbours`).

        Raises
        ------
        ValueError
            If the scene is an ensemble, or exactly at its limit, where the motion has no derivative.
        """
        return lazy_import("sensitivity").sensitivity(self)

    def __len__(self) -> int:
        """Return the length of the scene's first dimension."""
        if not self.shape:
            raise TypeError("a single motion has no len(): its scene has no arrays")
        return int(self.shape[0])

    def __bool__(self) -> bool:
        """Return True, also for ensembles without members."""
        return True

    def __getitem__(self, index: Any) -> Self:
        """Return the motion of one lane, or of several lanes, by NumPy indices of the scene's shape."""
        if not self.shape:
            raise TypeError("a single motion cannot be indexed: its scene has no arrays")
        scene = lazy_import("parameters").lanes_of(self.plan.scene, index)
        plan = replace(self.plan, scene=scene)
        invalid = np.broadcast_to(self.invalid, self.shape)[index]
        if scene.shape:
            rows = index if isinstance(index, tuple) else (index,)
            return type(self)(plan, self._final[(slice(None), *rows)], invalid)
        plan = replace(plan, recipe=recipe_of(scene))  # other lanes may have standing water
        return self.of_single(plan, invalid)  # solved to rounding

    def __repr__(self) -> str:
        """Return a summary of the results in one line."""
        name = self.plan.scene.name
        if name:
            name += ": "
        if self.shape:
            return f"<{math.prod(self.shape)} motions {name}{lazy_import('summary').ensemble_summary(self)}>"
        return f"<Motion {name}{lazy_import('summary').summary(self)}>"
