"""The motion of a scene, or of each lane of an ensemble: what became of it, read off at its end and at any time.

Phases, events and signs are those of ``notebooks/0_the_method.ipynb``.
"""

from collections.abc import Mapping
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Generic

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated import cells as its
from slipcircle.base.checks import INFINITY, choose, mistakes, raise_all
from slipcircle.base.kinds import Numbers
from slipcircle.core.flow.lanes import Lanes
from slipcircle.core.flow.program import Log
from slipcircle.core.motion.accuracy import estimate
from slipcircle.core.motion.plan import Plan
from slipcircle.core.motion.results import Results
from slipcircle.core.motion.states import BECOMES, Energy, Phase, State, Status
from slipcircle.core.scene.section import Journey, Section

if TYPE_CHECKING:
    from slipcircle.core.motion.derivatives import Sensitivity

Floats = NDArray[np.float64]


STATUSES = tuple(Status)
RESTS, STAYS, TURNED, INVALID = map(int, (Status.RESTS, Status.STAYS, Status.TURNED, Status.INVALID))
# The cells of which a motion is told.
KEPT = (
    its.TIME,
    its.STATUS,
    its.PHASES,
    its.END_TIME,
    its.PEAK_TIME,
    its.PEAK_ROTATION,
    its.PEAK_OMEGA,
    its.PEAK_RATE,
    its.REACH_TIME,
    its.REACH_ROTATION,
    its.END_ROTATION,
    its.END_OMEGA,
    its.END_RATE,
    its.CLOSE,
    its.REST_SINCE,
    its.TURNS,
)
ENERGIES = 21  # times at which the energy balance is looked at


def kept(cells: Floats, single: bool) -> dict[int, Any]:
    """Of the cells of lanes those of which a motion is told, arrays or, of a single one, numbers."""
    rows = cells.take(KEPT, axis=0)
    return dict(zip(KEPT, rows[:, 0].tolist() if single else rows, strict=True))


def _static(name: str) -> Any:
    """A property: one of the statics of each lane."""
    return property(lambda motion: motion._shaped(motion._lanes.statics[name]))


class Motion(Results, Generic[Numbers]):
    """A solved scene; of a scene of arrays, every attribute is an array of its shape, NaN where the status says why.

    Attributes
    ----------
    plan : Plan
        How it was solved.
    status : Status
        What became of it.
    moves : bool
        Whether the mass moves at all.
    arrested : bool
        Whether it rests at the end.
    duration : float
        Time from the start to the end, s.
    run_out : float
        Displacement along the arc at the end, m.
    reach : State
        Where it is farthest from its start.
    peak, end : State
        At the greatest speed, and at the end.
    limit_friction : float
        Friction coefficient at limit equilibrium at the start, for the direction in which gravity pulls.
    yield_coefficient : float
        k_y, the horizontal acceleration over g, down-slope, at which the mass would just move; negative if it moves.
    factor_of_safety : float
        Limit of resistance over drive at the start; infinite without a drive.
    friction : float
        The friction coefficient at the start.
    error_estimate : float
        Estimated relative error of peak velocity, run-out and duration, and of `at` relative to the first two.
    warnings : tuple of str
        What a user should know of a single motion; empty where all is well.

    A motion of many lanes has a length and is indexed; `to_dict`, `to_pandas` and `to_xarray` turn it into tables.
    """

    def __init__(self, plan: Plan, lanes: Lanes, cells: Mapping[int, Floats], log: Log) -> None:
        self.plan, self._lanes, self._cells, self._log = plan, lanes, cells, log
        self._latest: tuple[bytes, Floats] | None = None  # times that were last asked for, and the states there

    @property
    def shape(self) -> tuple[int, ...]:
        return self.plan.scene.shape

    def _shaped(self, values: Any) -> Any:
        """One number of each lane, as the scene has them: an array, or a number."""
        if self.shape:
            return np.reshape(values, self.shape)
        return values.item() if hasattr(values, "item") else values

    # --- what became of it -------------------------------------------------------------------------------------------

    @cached_property
    def _states(self) -> Any:
        """The status of each lane."""
        ended = self._cells[its.STATUS]
        found = BECOMES[np.asarray(ended, np.intp)] if self.shape else int(BECOMES[int(ended)])
        found = choose((found == RESTS) & (self._cells[its.TURNS] > 0.0), TURNED, found)
        found = choose((found <= TURNED) & (ended != its.STOPPED) & (self._cells[its.PHASES] == 0.0), STAYS, found)
        return choose(self._lanes.invalid, INVALID, found)

    @property
    def stopped_at(self) -> Numbers:
        """Time at which the walk stopped, s, with an answer or without."""
        return self._shaped(self._cells[its.TIME] * self._lanes.time_scale)

    @property
    def brake(self) -> Any:
        """q, twice what a unit of omega*^2 takes from the rate at the start: the speed falls like exp(-q phi/2)."""
        return self._shaped(self._lanes.brake)

    @property
    def turnings(self) -> Any:
        """How often the mass has turned back."""
        return self._shaped(np.asarray(self._cells[its.TURNS], int))

    @cached_property
    def _answered(self) -> Any:
        return self._states <= TURNED

    @property
    def status(self) -> Any:
        return self._states.reshape(self.shape) if self.shape else STATUSES[self._states]

    def count(self) -> dict[str, int]:
        """How many lanes there are of each status."""
        counts = np.bincount(np.ravel(self._states), minlength=len(STATUSES))
        return {s.name: int(counts[s]) for s in STATUSES if counts[s]}

    @property
    def moves(self) -> Any:
        return self._shaped(self._answered & (self._cells[its.PHASES] > 0.0))

    @property
    def arrested(self) -> Any:
        return self._shaped(self._rests)

    @property
    def _rests(self) -> Any:
        """Whether each lane rests at its end."""
        status = self._cells[its.STATUS]
        return (status == its.ARRESTED) | (status == its.PAUSED)

    @cached_property
    def _duration(self) -> Any:
        lanes = self._lanes
        rest = self._cells[its.REST_SINCE] * lanes.time_scale
        return self._known(choose(self._cells[its.STATUS] == its.ENDED, lanes.end_time, rest))

    def _known(self, values: Any) -> Any:
        """Values of lanes that have an answer, NaN of the others."""
        return choose(self._answered, values, np.nan)

    @property
    def duration(self) -> Numbers:
        return self._shaped(self._duration)

    @property
    def run_out(self) -> Numbers:
        return self.outcomes["run_out"]

    @cached_property
    def outcomes(self) -> Mapping[str, Numbers]:
        """Greatest displacement, run-out, peak velocity and duration, without the states that they belong to."""
        radius, scale = self._lanes.radius, self._lanes.time_scale
        with np.errstate(over="ignore"):  # what overflows is refused where it is asked for
            found = {
                "reach": radius * self._cells[its.REACH_ROTATION],
                "run_out": radius * self._cells[its.END_ROTATION],
                "peak_velocity": radius * (self._cells[its.PEAK_OMEGA] / scale),
            }
        return {n: self._shaped(self._known(v + 0.0)) for n, v in found.items()} | {"duration": self.duration}

    @cached_property
    def end(self) -> State:
        return self._state(self._duration, its.END_ROTATION, its.END_OMEGA, its.END_RATE)

    @property
    def journey(self) -> Journey:
        """Where it is at the end, of a `Section`: toe, its horizontal run-out, fall of the centroid, travel angle."""
        section = self.plan.scene.arc
        if not isinstance(section, Section):
            raise AttributeError("journey: of a Section only, as an Arc does not say where it lies")
        return section.journey(self.end.rotation)

    @cached_property
    def peak(self) -> State:
        at, lanes = self._cells[its.PEAK_TIME], self._lanes
        last = (at == self._cells[its.END_TIME]) & (self._cells[its.STATUS] == its.ENDED) | (
            self._cells[its.PHASES] == 0.0
        )
        time = choose(last, self._duration, at * lanes.time_scale)
        tables = () if self.shape else lanes.bound.program.tables
        if any(slot.kind == "time" for slot in tables) and 0.0 < time < self._duration:
            return self.at(time)  # of its rounded time: where a force leaps, as it is from then on
        return self._state(time, its.PEAK_ROTATION, its.PEAK_OMEGA, its.PEAK_RATE)

    @cached_property
    def reach(self) -> State:
        last = self._cells[its.REACH_ROTATION] == self._cells[its.END_ROTATION]
        time = choose(last, self._duration, self._cells[its.REACH_TIME] * self._lanes.time_scale)
        return self._state(time, its.REACH_ROTATION, its.END_OMEGA, its.END_RATE, last)

    @property
    def swings_back(self) -> Any:
        """Whether it has been farther from its start than it is at the end."""
        return np.abs(self.reach.displacement) > np.abs(self.run_out) * (1 + 1e-6)

    @property
    def lift_off(self) -> tuple[float, ...]:
        """Times from which water or shaking carries the mass, so that nothing presses on the slip surface, s."""
        scale, found = self._lanes.time_scale, list[float]()
        lifted, begun = False, -1.0  # as long as it is carried on through standstills it is one lift-off
        for kind, t, _, _ in self._log:
            if kind == its.NOTE_LIFTS and not lifted and begun != t:
                found.append(t * scale)
            begun = t if kind == its.NOTE_BEGINS and lifted else -1.0
            lifted = kind == its.NOTE_LIFTS or (lifted and kind == its.NOTE_STANDS)
        return tuple(found)

    @cached_property
    def phases(self) -> tuple[Phase, ...]:
        """The stretches of a single motion between its standstills."""
        scale, found = self._lanes.time_scale, list[Phase]()
        ends = [(t * scale) for kind, t, _, _ in self._log if kind == its.NOTE_STANDS]
        for kind, t, rotation, direction in self._log:
            if kind == its.NOTE_BEGINS:
                end = ends[len(found)] if len(found) < len(ends) else self._duration
                found.append(Phase(t * scale, end, rotation, int(direction)))
        return tuple(found)

    # --- states ------------------------------------------------------------------------------------------------------

    def _state(self, time: Any, rotation: int, omega: int, rate: int, moving: Any = True) -> State:
        """A state of each lane from cells; of those that do not move, without speed and rate."""
        scale, radius = self._lanes.time_scale, self._lanes.radius
        turn = self._known(self._cells[rotation])
        speed, gain = (self._known(choose(moving, self._cells[cell], 0.0)) for cell in (omega, rate))
        with np.errstate(over="ignore"):  # what overflows is refused
            turning = speed / scale
            columns = (time, turn, turning, radius * turning, radius * turn, radius * gain / scale**2)
        stress = partial(self._stress, time / scale, turn, speed)
        return State(*(self._shaped(v + 0.0) for v in columns), stress=stress)  # no -0.0

    def _stress(self, time: Any, rotation: Any, omega: Any) -> Any:
        """The mean normal stress of each lane in one state, Pa; dimensionless numbers."""
        return self._shaped(self._lanes.stress(time, rotation, omega) + 0.0)

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
        time = self._times(times)
        rows = self._rows(time)
        shape = (*self.shape, *time.shape)
        lanes = self._lanes
        scale, radius = (np.reshape(x, -1)[:, None] for x in (lanes.time_scale, lanes.radius))
        over = np.ravel(time)[:, None] >= self._duration  # the end, whatever rounding makes of its time
        for row, cell in enumerate((its.END_ROTATION, its.END_OMEGA, its.END_RATE)):
            rows[row] = np.where(over, self._cells[cell], rows[row])
        rotation, omega, rate = (rows[k].T + 0.0 for k in range(3))  # (lanes, times)
        speed = omega / scale
        columns = (rotation, speed, radius * speed, radius * rotation, radius * rate / scale**2)
        found = [np.reshape(np.broadcast_to(v, rotation.shape), shape)[()] for v in columns]
        return State(np.broadcast_to(time, shape)[()], *found, stress=partial(self._stress_along, time, rows))

    def _stress_along(self, time: Floats, rows: Floats) -> Any:
        """The mean normal stress of each lane at each time, Pa."""
        return self._along(time, self._lanes.outputs(np.ravel(time), rows)["pressing"] * self._stress_unit)

    def _times(self, times: ArrayLike) -> Floats:
        raise_all("Motion.at", mistakes({"times": times}, {"times": (-5e-324, INFINITY, "times in s, not before 0")}))
        time = np.asarray(times, dtype=np.float64)
        status = self._cells[its.STATUS]
        last_of_each = choose(status == its.PAUSED, self._lanes.end_time, self._duration)
        bounded = (status != its.ARRESTED) & self._answered
        last = float(np.min(choose(bounded, last_of_each, np.inf)))
        late = time[time > last]
        if late.size:
            end = "the end of this motion" if self.plan.scene.end_time is None else "the scene's end_time"
            raise ValueError(
                f"Motion.at: times = {float(late.flat[0])!r}: must be at most {end}, {last!r} s, as the mass does not "
                "rest for good there"
            )
        return time

    def _rows(self, time: Floats) -> Floats:
        """Numbers of the walk at times, kept for the next question about the same."""
        asked = time.tobytes()
        if self._latest is None or self._latest[0] != asked:
            self._latest = asked, self._lanes.read(np.ravel(time))
        return self._latest[1]

    def _along(self, time: Floats, values: Floats) -> Any:
        """One number of each lane at each time, (lanes, times), as the scene has its lanes."""
        return values.reshape(self.shape + time.shape)[()]

    def _outputs_at(self, times: ArrayLike) -> tuple[Floats, dict[str, Floats]]:
        """Times, and what the program gives there beside the states."""
        time = self._times(times)
        return time, self._lanes.outputs(np.ravel(time), self._rows(time))

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """The mean pore pressure on the slip surface, with what heat has added, Pa; times as for `at`."""
        time, found = self._outputs_at(times)
        return self._along(time, (found["pressing"] - found["normal"]) * self._stress_unit)

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """The mean normal stress on the slip surface less the pore pressure, 0 where that is more, Pa; as for `at`."""
        time, found = self._outputs_at(times)
        return self._along(time, np.maximum(found["normal"], 0.0) * self._stress_unit)

    @property
    def _stress_unit(self) -> Floats:
        return np.reshape(self._lanes.stress_unit, (-1, 1))

    def friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient that the law gives, 0 where nothing presses on the slip surface; as for `at`."""
        time, found = self._outputs_at(times)
        return self._along(time, np.where(found["normal"] > 0.0, found["mu"], 0.0))

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient at which the mass, brought to rest where it is, would just stay; times as for `at`.

        NaN where nothing presses on the slip surface.
        """
        time = self._times(times)
        return self._along(time, self._lanes.holding_friction(np.ravel(time), self._rows(time)))

    def path_at(self, times: ArrayLike) -> Any:
        """The path travelled from the start, there and back, m; times as for `at`."""
        time = self._times(times)
        return self._along(time, np.reshape(self._lanes.radius, (-1, 1)) * self._rows(time)[3].T)

    def energy_at(self, times: ArrayLike) -> Energy:
        """The energy balance from the start to any times, as for `at`; integrated beside the motion when asked for."""
        time = self._times(times)
        rows, first = self._lanes.energies(np.ravel(time))
        unit = self._lanes.energy_unit
        shape = (*self.shape, *time.shape)
        stands = np.ravel(time)[:, None] >= np.where(self._rests, self._duration, np.inf)
        rows["kinetic"] = np.where(stands, 0.0, rows["kinetic"])
        kinetic, work, lost = (np.reshape((unit * rows[k]).T, shape)[()] for k in ("kinetic", "work", "dissipation"))
        return Energy(self._shaped(np.broadcast_to(unit * first, self._lanes.count)), kinetic, work, lost)

    @cached_property
    def energy(self) -> Energy:
        """The energy balance from the start to the end."""
        return self.energy_at(self.duration)

    # --- at the start ------------------------------------------------------------------------------------------------

    limit_friction, factor_of_safety, yield_coefficient, friction = map(
        _static, ("limit_friction", "factor_of_safety", "yield_coefficient", "friction")
    )

    # --- how well it is known ----------------------------------------------------------------------------------------

    @cached_property
    def _estimates(self) -> Floats:
        return estimate(self._lanes, self._cells)

    @property
    def error_estimate(self) -> Numbers:
        return self._shaped(self._estimates)

    @cached_property
    def energy_error_estimate(self) -> float:
        """How far the energy balance of a single motion is off at any time, relative to all energy until then."""
        e = self.energy_at(np.linspace(0.0, self._duration, ENERGIES))
        most = np.maximum.accumulate(e.kinetic_start + np.abs(e.work) + e.dissipation)
        return float(2 * np.max(np.abs(e.residual) / np.maximum(most, 1e-300)))

    def sensitivity(self) -> "Sensitivity":
        """Exact derivatives of a single motion by every number of its scene: `slipcircle.core.motion.sensitivity`.

        Raises
        ------
        ValueError
            If the scene is exactly at its limit, where the motion has no derivative; or is one of arrays.
        """
        from slipcircle.core.motion.sensitivity import sensitivity

        if self.shape:
            raise ValueError("sensitivity: takes one scene at a time; solve a lane by itself")
        if not self.moves and self.limit_friction == self.friction:
            raise ValueError("friction: the scene is exactly at its limit, where the motion has no derivative")
        at: dict[str, Any] = {n: value if self.moves else 0.0 for n, value in self.outcomes.items()}
        return sensitivity(self.plan.scene, self._lanes, at)
