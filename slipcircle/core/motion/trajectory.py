"""A solved scene over time: states, stresses, friction and energy at any times, of one scene or of an ensemble's lanes.

The integration keeps a few state entries of each lane's end; what happens on the way is integrated again on request.
Dimensionless numbers become SI units here: times by sqrt(R/g), lengths along the arc by R.
"""

import math
from collections.abc import Mapping
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from generated import layout as ix
from slipcircle.base.checks import INFINITY, choose, mistakes, raise_all
from slipcircle.base.kinds import Floats
from slipcircle.core.motion.plan import Plan
from slipcircle.core.motion.states import STATUS_OF_END, Energy, State, Status
from slipcircle.core.problem.lanes import Lanes
from slipcircle.core.program.program import Log

RESTS = int(Status.RESTS)
STAYS = int(Status.STAYS)
TURNED = int(Status.TURNED)
CREEPS = int(Status.CREEPS)
INVALID = int(Status.INVALID)
ALLOWED_TIMES = (-5e-324, INFINITY, "times in s, not before 0")


class Trajectory:
    """The lanes of a solved scene and their final state entries; `Motion` says what these amount to."""

    def __init__(self, plan: Plan, lanes: Lanes, final: Mapping[int, Any], log: Log) -> None:
        self.plan = plan
        self._lanes = lanes
        self._final = final
        self._log = log
        self._last_read: tuple[bytes, Floats] | None = None

    @property
    def shape(self) -> tuple[int, ...]:
        """The broadcast shape of the scene's arrays; empty for a single scene."""
        return self.plan.scene.shape

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
        paused = status == ix.PAUSED
        return paused | (status == ix.ARRESTED)

    @cached_property
    def _status(self) -> Any:
        """The status of each lane, as a number."""
        final = self._final
        ended = final[ix.STATUS]
        status: Any
        if self.shape:
            ends = np.asarray(ended, np.intp)
            status = STATUS_OF_END[ends]
        else:
            status = int(STATUS_OF_END[int(ended)])
        rests = status == RESTS
        has_turned = final[ix.TURNS] > 0.0
        status = choose(rests & has_turned, TURNED, status)
        status = choose(final[ix.TIME] == np.inf, CREEPS, status)
        answered = status <= CREEPS
        still = final[ix.PHASES] == 0.0
        stays = still & (ended != ix.STOPPED)
        status = choose(answered & stays, STAYS, status)
        return choose(self._lanes.invalid, INVALID, status)

    @cached_property
    def _solved(self) -> Any:
        """Which lanes have a result."""
        return self._status <= CREEPS

    @property
    def is_finite(self) -> bool:
        """Whether a single motion has a result, and that does not overflow."""
        radius = self._lanes.radius
        run_out = radius * self._final[ix.END_ROTATION]
        angular_velocity = self._final[ix.PEAK_OMEGA] / self._lanes.time_scale
        velocity = radius * angular_velocity
        return self._solved and math.isfinite(run_out + velocity)

    def _known(self, values: Any) -> Any:
        """Values of lanes with a result, NaN of the others."""
        return choose(self._solved, values, np.nan)

    @cached_property
    def _duration(self) -> Any:
        """Time from the start to the end of each lane, s."""
        lanes = self._lanes
        rest = self._final[ix.REST_SINCE] * lanes.time_scale
        status = self._final[ix.STATUS]
        duration = choose(status == ix.ENDED, lanes.end_time, rest)
        return self._known(duration)

    @cached_property
    def _settling_time(self) -> Any:
        """Time by which each lane has covered 99 % of its run-out if it creeps, else its duration, s."""
        time = self._final[ix.REST_SINCE] * self._lanes.time_scale
        return choose(self._status == CREEPS, time, self._duration)

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
        rotation, omega, rate, *_ = self._rows(time)
        shape = self.shape + time.shape
        every_time = np.broadcast_to(time, shape)[()]
        over_time = partial(self._over_time, time)
        stress = partial(self._stress_at, time)
        return self._state(every_time, rotation, omega, rate, over_time, stress)

    def _state(self, time: Any, rotation: Any, omega: Any, rate: Any, shaped: Any, stress: Any) -> State:
        """A state in SI units from dimensionless numbers; `shaped` gives them the scene's shape."""
        scale = self._lanes.time_scale
        radius = self._lanes.radius
        with np.errstate(over="ignore"):  # an overflow is refused where the result is read
            angular_velocity = omega / scale
            velocity = radius * angular_velocity
            acceleration = radius * rate / scale**2
            displacement = radius * rotation
        columns = (rotation, angular_velocity, velocity, displacement, acceleration)
        positive_zeros = [shaped(column + 0.0) for column in columns]
        return State(time, *positive_zeros, stress=stress)

    def _checked(self, times: ArrayLike) -> Floats:
        """Times as an array, none of them beyond the end of a lane that still moves there."""
        faults = mistakes({"times": times}, {"times": ALLOWED_TIMES})
        raise_all("Motion.at", faults)
        time = np.asarray(times, dtype=np.float64)
        status = self._final[ix.STATUS]
        known_until = choose(status == ix.PAUSED, self._lanes.end_time, self._duration)
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

    def _rows(self, time: Floats) -> Floats:
        """Rotation, omega, its rate, slip and further states, (rows, times, lanes); kept for the same times again."""
        key = time.tobytes()
        if self._last_read is not None:
            last_key, last_rows = self._last_read
            if last_key == key:
                return last_rows
        flat_times = np.ravel(time)
        rows = self._lanes.read(flat_times)
        ended = flat_times[:, None] >= self._duration  # whatever rounding makes of the time of the end
        at_end = (ix.END_ROTATION, ix.END_OMEGA, ix.END_RATE)
        for row, entry in zip(rows, at_end, strict=False):
            row[:] = np.where(ended, self._final[entry], row)
        self._last_read = key, rows
        return rows

    def _over_time(self, time: Floats, values: Floats) -> Any:
        """Values (times, lanes) in the scene's shape followed by that of the times."""
        shape = self.shape + time.shape
        return values.T.reshape(shape)[()]

    def _stresses(self, time: Floats) -> tuple[Floats, Floats]:
        """Mean normal stress with the water and without, Pa, each (times, lanes)."""
        lanes = self._lanes
        flat_times = np.ravel(time)
        outputs = lanes.outputs(flat_times, self._rows(time), lanes.of_means)
        total = outputs["pressing"].T * lanes.stress_unit
        effective = outputs["normal"].T * lanes.stress_unit
        return total, effective

    def _stress_at(self, time: Floats) -> Any:
        total, _ = self._stresses(time)
        return self._over_time(time, total)

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """The mean pore pressure on the slip surface, with what heat has added, Pa; times as for `at`."""
        time = self._checked(times)
        total, effective = self._stresses(time)
        return self._over_time(time, total - effective)

    def effective_stress_at(self, times: ArrayLike) -> Any:
        """The mean normal stress on the slip surface less the pore pressure, 0 where that is more, Pa; as for `at`."""
        time = self._checked(times)
        _, effective = self._stresses(time)
        pressing = np.maximum(effective, 0.0)
        return self._over_time(time, pressing)

    def friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient that the law gives, 0 where contact is lost; times as for `at`."""
        time = self._checked(times)
        flat_times = np.ravel(time)
        outputs = self._lanes.outputs(flat_times, self._rows(time))
        contact = outputs["normal"] > 0.0
        mobilised = np.where(contact, outputs["mu"], 0.0)
        return self._over_time(time, mobilised.T)

    def holding_friction_at(self, times: ArrayLike) -> Any:
        """The friction coefficient at which the mass, brought to rest where it is, would just stay; times as for `at`.

        NaN where contact is lost.
        """
        time = self._checked(times)
        flat_times = np.ravel(time)
        holding = self._lanes.holding_friction(flat_times, self._rows(time))
        return self._over_time(time, holding.T)

    def path_at(self, times: ArrayLike) -> Any:
        """The path travelled from the start, there and back, m; times as for `at`."""
        time = self._checked(times)
        _, _, _, slip, *_ = self._rows(time)
        path = self._lanes.radius * slip
        return self._over_time(time, path)

    def energy_at(self, times: ArrayLike) -> Energy:
        """The energy balance from the start to any times, as for `at`; integrated with the motion on request."""
        time = self._checked(times)
        flat_times = np.ravel(time)
        unit = self._lanes.energy_unit
        balance, kinetic_start = self._lanes.energies(flat_times)
        ended = flat_times[:, None] >= self._duration
        rests = self._rests_at_end & ended
        balance["kinetic"] = np.where(rests, 0.0, balance["kinetic"])
        start = np.broadcast_to(unit * kinetic_start, self._lanes.count)
        in_joule = {name: self._over_time(time, unit * term) for name, term in balance.items()}
        return Energy(
            kinetic_start=self._shaped(start),
            kinetic_end=in_joule["kinetic"],
            work=in_joule["work"],
            dissipation=in_joule["dissipation"],
        )
