"""The motion of a scene: phases of one direction each, solved by the planned method, and read off at any time."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.balance import Balance
from slipcircle.checks import EPS, INFINITY, mistakes, raise_all
from slipcircle.friction import friction
from slipcircle.plan import CLOSED_IN_TIME, INTEGRATION, STEPPING, Plan

if TYPE_CHECKING:
    from slipcircle.methods.frozen import Frozen
    from slipcircle.methods.integrate import Integrated
    from slipcircle.methods.phaseplane import Course
    from slipcircle.methods.stepping import Stepped
    from slipcircle.sensitivity import Sensitivity

    Followed: TypeAlias = Course | Frozen | Integrated  # one phase
    Solved: TypeAlias = Followed | Stepped

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class State:
    """The motion at one time, or at an array of times; counterclockwise and down-slope for a positive dip.

    Attributes
    ----------
    time, rotation, angular_velocity, velocity, displacement, acceleration, normal_stress
        s, rad, rad/s, m/s and m along the arc, m/s^2 along the arc, Pa (mean over the arc, water included).
    """

    time: Any
    rotation: Any
    angular_velocity: Any
    velocity: Any
    displacement: Any
    acceleration: Any
    normal_stress: Any


@dataclass(frozen=True)
class Energy:
    """The energy balance from the start to one time or several, J.

    Attributes
    ----------
    kinetic_start, kinetic_end, work, dissipation
        Kinetic energies, work of gravity and shaking, and what all resistance took, by a quadrature of its own.
    """

    kinetic_start: Any
    kinetic_end: Any
    work: Any
    dissipation: Any

    @property
    def residual(self) -> Any:
        """Work of gravity - change of kinetic energy - dissipation."""
        return self.work - (self.kinetic_end - self.kinetic_start) - self.dissipation


class Start(NamedTuple):
    """Where a phase begins: in the direction of travel, dimensionless; slip in m."""

    rotation: float  # of the mass, in its own sense
    direction: int
    energy: float  # E = omega**2
    slip: float
    lifted: bool  # nothing presses on the slip surface
    excess: float = 0.0  # pore pressure that heat has added, over sigma_ref


class Phase(NamedTuple):
    """A stretch of motion in one direction: where it begins and ends, dimensionless, and what solves it."""

    start: float
    end: float
    rotation: float
    direction: int
    solved: "Solved"
    rests: bool = False  # at its end, at least for a moment


class Motion:
    """A solved scene.

    Attributes
    ----------
    plan : Plan
        How it was solved.
    moves : bool
        Whether the mass moves at all.
    arrested : bool
        Whether it rests at the end.
    duration : float
        Time from the start to the end, s.
    run_out : float
        Displacement along the arc at the end, m.
    peak, end : State
        At the greatest speed, and at the end.
    limit_friction : float
        Friction coefficient at limit equilibrium at the start, for the direction in which gravity pulls.
    yield_coefficient : float
        k_y, the horizontal acceleration over g, down-slope, at which the mass would just move; negative if it moves.
    factor_of_safety : float
        Limit of resistance over drive at the start; infinite without a drive.
    lift_off : tuple of float
        Times from which water or shaking carries the mass, so that nothing presses on the slip surface, s; the first
        of each rest.
    error_estimate : float
        Estimated relative error of peak velocity, run-out and duration, and of `at` relative to the first two.
    energy_error_estimate : float
        Estimated error of the energy balance, relative to all energy.
    warnings : tuple of str
        What a user should know; empty where all is well.
    """

    def __init__(self, plan: Plan, balance: Balance, phases: list[Phase], duration: float, arrested: bool) -> None:
        self.plan, self.balance, self.phases = plan, balance, phases
        self.moves = bool(phases) and duration > 0.0
        self.arrested, self.duration, self._scale = arrested, duration, balance.time_scale
        self.end = self._ended()

    def _ended(self) -> State:
        if not self.phases:
            return self._state(self.duration, 0.0, 0.0, 0.0)
        last = self.phases[-1]
        rests = self.arrested or last.rests
        x, omega, rate = (last.solved.end, 0.0, 0.0) if rests else last.solved.state(last.end - last.start)
        side = last.direction
        return self._state(self.duration, last.rotation + side * x, side * omega, side * rate)

    @property
    def run_out(self) -> float:
        return float(self.end.displacement)

    @cached_property
    def peak(self) -> State:
        best, speed = self.end, abs(float(self.end.angular_velocity)) * self._scale
        last = self.duration / self._scale * (1.0 - 8 * EPS)  # what is not before it is the end itself
        for p in self.phases:
            first = math.sqrt(p.solved.start.energy)
            begins = [] if first <= speed else [(0.0, *p.solved.state(0.0))]
            summit = p.solved.fastest()
            for t, x, omega, rate in [*begins, summit] if summit else begins:
                if abs(omega) > speed and p.start + t <= min(p.end, last):
                    speed, side = abs(omega), p.direction
                    time = min((p.start + t) * self._scale, self.duration)
                    best = self._state(time, p.rotation + side * x, side * omega, side * rate)
        # Read off again where that costs nothing, so that the state is that of its rounded time.
        return self._at(best.time) if self.plan.method == CLOSED_IN_TIME else best

    @cached_property
    def _start(self) -> dict[str, float]:
        """The position at the start, seen in the direction in which gravity pulls."""
        return self.balance.position(0.0, -1 if self.balance.fall < 0.0 else 1)

    @property
    def limit_friction(self) -> float:
        if float(self.balance.get("normal", **self._start)) <= 0.0:  # lifted: no friction holds it, or none is needed
            return math.inf if self.balance.drive(self._start, 0.0) > 0.0 else -math.inf
        return float(self.balance.get("limit_friction", **self._start))

    @property
    def factor_of_safety(self) -> float:
        resistance = float(self.balance.get("resistance", **self._start, mu=self._friction, omega_2=0.0))
        return resistance / self._start["fall"] + 0.0 if self._start["fall"] > 0.0 else math.inf

    @property
    def yield_coefficient(self) -> float:
        """k_y: horizontal acceleration over g, down-slope, that the mass just stands at first; below 0 if it moves."""
        at, mu = self._start, float(friction(self.plan.scene.friction).coefficient(0.0))
        yields = -self.balance.drive(at, mu) / (at["fall_slope"] - mu * at["press_slope"])
        if self.balance.get("normal", **at) + yields * at["press_slope"] < 0.0:  # tilted so far, water carries it
            yields = -self.balance.drive(at, 0.0) / at["fall_slope"]
        return float(yields) + 0.0

    @property
    def _friction(self) -> float:
        """Friction at the start, 0 where nothing presses on the slip surface."""
        if float(self.balance.get("normal", **self._start)) <= 0.0:
            return 0.0
        return float(friction(self.plan.scene.friction).coefficient(0.0))

    @cached_property
    def lift_off(self) -> tuple[float, ...]:
        lifted, times = False, list[float]()
        for p in self.phases:
            inside = [p.start + float(t) for t in p.solved.lifts]
            times += [p.start] if p.solved.start.lifted > lifted and not inside else inside
            lifted = p.solved.start.lifted and not inside
        return tuple(t * self._scale for t in sorted({*times, *self._lifts_at_rest()}))

    def _lifts_at_rest(self) -> list[float]:
        """When shaking or water first carries the mass while it rests, for each rest; dimensionless."""
        from slipcircle.methods.rest import Rest, lift_at_rest

        if self.plan.method == STEPPING and self.phases:  # which walks through the rests as well
            return []
        end_time, law = self.plan.scene.end_time, friction(self.plan.scene.friction)
        end = math.inf if end_time is None else float(np.asarray(end_time)) / self._scale
        rests = [(Rest(0.0, 0.0), 0.0)]
        for p in self.phases:  # one that ends lifted has been reported
            excess = float(p.solved.excess_when(np.array([p.end - p.start]))[0])
            begin = p.end if p.rests and not p.solved.start.lifted else math.inf
            rests.append((Rest(p.rotation + p.direction * p.solved.end, 0.0, excess), begin))
        ends = [*(p.start for p in self.phases), end]
        found = [lift_at_rest(self.balance, law, r, t, end) for (r, t), end in zip(rests, ends, strict=True) if t < end]
        return [t for t in found if t is not None]

    @cached_property
    def _estimates(self) -> tuple[float, float]:
        from slipcircle.uncertainty import estimate

        return estimate(self)

    @property
    def error_estimate(self) -> float:
        return self._estimates[0]

    @property
    def energy_error_estimate(self) -> float:
        return self._estimates[1]

    def sensitivity(self) -> "Sensitivity":
        """Exact derivatives by the scene's parameters, under constant friction: see `slipcircle.sensitivity`.

        Raises
        ------
        ValueError
            If friction is not constant, or the scene exactly at its limit.
        """
        from slipcircle.sensitivity import sensitivity

        return sensitivity(self)

    @property
    def warnings(self) -> tuple[str, ...]:
        return tuple(self._warnings())

    def _warnings(self) -> list[str]:
        times = self.lift_off
        more = f", and {len(times) - 1} times more until {times[-1]:.6g} s" if len(times) > 3 else ""
        said = times[:1] if more else times
        found = [f"nothing presses on the slip surface from {t:.6g} s{more} (lift-off)" for t in said]
        if self.error_estimate > self.plan.accuracy:
            cause = "the friction is next to its limit" if len(self.phases) < 100 else "the mass turns back many times"
            found.append(
                f"ill-conditioned: the estimated error {self.error_estimate:.1e} is above the accuracy asked for, "
                f"{self.plan.accuracy:.1e}; {cause}"
            )
        if self.energy_error_estimate > (self.plan.accuracy if self.plan.method == INTEGRATION else 1e-12):
            found.append(
                f"ill-conditioned: the energy balance holds to {self.energy_error_estimate:.1e} only, as the "
                "resistance is a small difference where water and speed carry the mass"
            )
        return found

    @property
    def _arc(self) -> Any:
        return self.plan.scene.arc

    def _state(self, time: Any, rotation: Any, omega: Any, rate: Any) -> State:
        """A state from its dimensionless numbers, or arrays of them."""
        balance, scale, radius = self.balance, self._scale, self.balance.radius
        at = {"press": balance.press_at(rotation), "omega_2": omega * omega}
        if balance.forcing:
            at |= balance.given(time / scale) | {"press_slope": balance.press_slope_at(rotation)}
        stress = balance.get("normal_stress", **at) * float(self._arc.reference_stress)
        speed = omega / scale + 0.0  # no -0.0
        return State(time, rotation, speed, radius * speed, radius * rotation, radius * rate / scale**2, stress)

    def at(self, times: ArrayLike) -> State:
        """The state at any times between the start and the end, and at rest after an arrest.

        Parameters
        ----------
        times : float or array_like
            s.

        Raises
        ------
        ValueError
            For times before the start, not finite, or after the end of a motion that has not come to rest.
        """
        time = self._times(times)
        if time.ndim == 0:
            return self._at(float(time))
        return self._state(time, *self._followed(time / self._scale))

    def _at(self, time: float) -> State:
        """The state at one good time, by the same numbers as `end` and `peak`."""
        if time >= self.duration:
            return self.end if time == self.duration else replace(self.end, time=time)
        t = time / self._scale
        p = next((p for p in reversed(self.phases) if p.start <= t), None)
        if p is None:
            return self._state(time, 0.0, 0.0, 0.0)
        rests = p.rests and t > p.end
        x, omega, rate = (p.solved.end, 0.0, 0.0) if rests else p.solved.state(min(t, p.end) - p.start)
        return self._state(time, p.rotation + p.direction * x, p.direction * omega, p.direction * rate)

    def _times(self, times: ArrayLike) -> Floats:
        raise_all("Motion.at", mistakes({"times": times}, {"times": (-5e-324, INFINITY, "times in s, not before 0")}))
        time = np.asarray(times, dtype=np.float64)
        late = time[time > self.duration]
        if late.size and not self.arrested:
            end = "the end of this motion" if self.plan.scene.end_time is None else "the scene's end_time"
            raise ValueError(
                f"Motion.at: times = {float(late.flat[0])!r}: must be at most {end}, {float(self.duration)!r} s, as "
                "the mass does not rest there"
            )
        return time

    def _lanes(self, t: Floats) -> list[tuple[Phase, NDArray[np.bool_], Floats]]:
        """For each phase the lanes whose time has reached it, and their times since it began, up to its end."""
        reached = [(p, t >= p.start) for p in self.phases]
        return [(p, mask, np.minimum(t[mask], p.end) - p.start) for p, mask in reached if np.any(mask)]

    def _followed(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        rotation, omega, rate = np.zeros_like(t), np.zeros_like(t), np.zeros_like(t)
        with np.errstate(under="ignore"):
            which = np.searchsorted([p.start for p in self.phases], t, side="right") - 1
            for k in np.unique(which[which >= 0]):
                phase, mask = self.phases[k], which == k
                x, speed, change = phase.solved.when(np.minimum(t[mask], phase.end) - phase.start)
                rotation[mask] = phase.rotation + phase.direction * x
                moves = ~(phase.rests & (t[mask] > phase.end))  # or rests until the next phase
                omega[mask], rate[mask] = phase.direction * speed * moves, phase.direction * change * moves
        if self.arrested:
            rest = t >= self.duration / self._scale
            omega[rest], rate[rest] = 0.0, 0.0
            if self.phases:
                last = self.phases[-1]
                rotation[rest] = last.rotation + last.direction * last.solved.end
        return rotation, omega, rate

    def pore_pressure_at(self, times: ArrayLike) -> Any:
        """The mean pore pressure on the slip surface, with what heat has added, Pa.

        Parameters
        ----------
        times : float or array_like
            s; as for `at`.
        """
        t = self._times(times) / self._scale
        rotation, excess = self._followed(t)[0], np.zeros_like(t)
        for phase, mask, local in self._lanes(t):
            excess[mask] = phase.solved.excess_when(local)
        at = self.balance.given(t) | {"press": self.balance.press_at(rotation), "excess": excess, "omega_2": 0.0}
        at["press_slope"] = self.balance.press_slope_at(rotation)
        get = self.balance.get
        return (get("normal_stress", **at) - get("effective_stress", **at)) * float(self._arc.reference_stress)

    def energy_at(self, times: ArrayLike) -> Energy:
        """The energy balance from the start to any times.

        Parameters
        ----------
        times : float or array_like
            s; as for `at`.
        """
        t = self._times(times) / float(self._arc.time_scale)
        work, lost = np.zeros_like(t), np.zeros_like(t)
        with np.errstate(under="ignore"):
            for phase, mask, local in self._lanes(t):
                inside, place = np.unique(local, return_inverse=True)  # what is later than a phase asks for its end
                work[mask] += phase.solved.worked(inside)[place]
                lost[mask] += phase.solved.dissipated(inside)[place]
        omega = self._followed(t)[1]
        first = self.phases[0].solved.start.energy if self.phases else 0.0
        arc, d = self._arc, self._arc.dimensionless
        unit = float(arc.width) * float(arc.unit_weight) * float(arc.radius) ** 3 * float(d.moment_of_inertia)
        return Energy(unit * first / 2, (unit * omega**2 / 2)[()], (unit * work)[()], (unit * lost)[()])

    @cached_property
    def energy(self) -> Energy:
        """The energy balance from the start to the end."""
        return self.energy_at(self.duration)
