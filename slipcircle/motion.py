"""The motion of a scene: phases of one direction each, solved by the planned method, and read off at any time."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slipcircle.arc import QUANTITIES
from slipcircle.balance import Balance, bind
from slipcircle.checks import INFINITY, mistakes, raise_all
from slipcircle.friction import Friction, friction
from slipcircle.frozen import Frozen
from slipcircle.phaseplane import Course, Start, root
from slipcircle.plan import CLOSED_IN_TIME, Plan, plan
from slipcircle.scene import Scene
from slipcircle.uncertainty import estimate

Floats = NDArray[np.float64]
_MOST_PHASES = 2000


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
        Kinetic energies, work of gravity, and what all resistance took, by a quadrature of its own.
    """

    kinetic_start: Any
    kinetic_end: Any
    work: Any
    dissipation: Any

    @property
    def residual(self) -> Any:
        """Work of gravity - change of kinetic energy - dissipation."""
        return self.work - (self.kinetic_end - self.kinetic_start) - self.dissipation


@dataclass(frozen=True)
class Phase:
    """A stretch of motion in one direction: where it begins and ends, dimensionless, and what solves it."""

    start: float
    end: float
    rotation: float
    direction: int
    solved: Course | Frozen


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
        Times at which water carries the mass, so that nothing presses on the slip surface, s.
    error_estimate : float
        Estimated relative error of peak velocity, run-out and duration, and of `at` relative to the first two.
    warnings : tuple of str
        What a user should know; empty where all is well.
    """

    def __init__(self, plan: Plan, balance: Balance, phases: list[Phase], duration: float, arrested: bool) -> None:
        self.plan, self.balance, self.phases = plan, balance, phases
        self.moves = bool(phases) and duration > 0.0
        self.arrested, self.duration = arrested, duration

    @cached_property
    def end(self) -> State:
        if not self.phases:
            return self._state(self.duration, 0.0, 0.0, 0.0)
        last = self.phases[-1]
        x, omega, rate = (last.solved.end, 0.0, 0.0) if self.arrested else last.solved.state(last.end - last.start)
        side = last.direction
        return self._state(self.duration, last.rotation + side * x, side * omega, side * rate)

    @property
    def run_out(self) -> float:
        return float(self.end.displacement)

    @cached_property
    def peak(self) -> State:
        best, speed = self.end, abs(float(self.end.angular_velocity)) * self._scale
        for p in self.phases:
            first = math.sqrt(p.solved.start.energy)
            found = [p.solved.fastest()] if first <= speed else [(0.0, *p.solved.state(0.0)), p.solved.fastest()]
            for t, x, omega, rate in found:
                if omega > speed and p.start + t <= p.end:
                    speed, side = omega, p.direction
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
        return resistance / self._start["fall"] if self._start["fall"] > 0.0 else math.inf

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

    @property
    def lift_off(self) -> tuple[float, ...]:
        lifted = [False, *(p.solved.start.lifted for p in self.phases)]
        return tuple(
            p.start * self._scale for p, was in zip(self.phases, lifted, strict=False) if p.solved.start.lifted > was
        )

    @cached_property
    def error_estimate(self) -> float:
        return estimate(self)

    @property
    def warnings(self) -> tuple[str, ...]:
        return tuple(self._warnings())

    def _warnings(self) -> list[str]:
        found = [f"nothing presses on the slip surface from {t:.6g} s (lift-off)" for t in self.lift_off]
        if self.error_estimate > self.plan.accuracy:
            cause = "the friction is next to its limit" if len(self.phases) < 100 else "the mass turns back many times"
            found.append(
                f"ill-conditioned: the estimated error {self.error_estimate:.1e} is above the accuracy asked for, "
                f"{self.plan.accuracy:.1e}; {cause}"
            )
        return found

    @property
    def _arc(self) -> Any:
        return self.plan.scene.arc

    @property
    def _scale(self) -> float:
        return float(self._arc.time_scale)

    def _state(self, time: Any, rotation: Any, omega: Any, rate: Any) -> State:
        """A state from its dimensionless numbers, or arrays of them."""
        scale, radius = self._scale, float(self._arc.radius)
        press = self.balance.press_at(rotation)
        stress = self.balance.get("normal_stress", press=press, omega_2=omega * omega) * float(
            self._arc.reference_stress
        )
        speed = omega / scale
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
        x, omega, rate = p.solved.state(min(t, p.end) - p.start)
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
            for phase, mask, local in self._lanes(t):
                x, speed, change = phase.solved.when(local)
                rotation[mask] = phase.rotation + phase.direction * x
                omega[mask], rate[mask] = phase.direction * speed, phase.direction * change
        if self.arrested:
            rest = t >= self.duration / self._scale
            omega[rest], rate[rest] = 0.0, 0.0
            if self.phases:
                last = self.phases[-1]
                rotation[rest] = last.rotation + last.direction * last.solved.end
        return rotation, omega, rate

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
                work[mask] += phase.solved.work(phase.solved.when(local)[0])
                lost[mask] += phase.solved.dissipated(local)
        omega = self._followed(t)[1]
        first = self.phases[0].solved.start.energy if self.phases else 0.0
        arc, d = self._arc, self._arc.dimensionless
        unit = float(arc.width) * float(arc.unit_weight) * float(arc.radius) ** 3 * float(d.moment_of_inertia)
        return Energy(unit * first / 2, (unit * omega**2 / 2)[()], (unit * work)[()], (unit * lost)[()])

    @cached_property
    def energy(self) -> Energy:
        """The energy balance from the start to the end."""
        return self.energy_at(self.duration)


def solve(scene: Scene, accuracy: float | None = None) -> Motion:
    """Solve a scene until it rests, or until its end time.

    Parameters
    ----------
    scene : Scene
        Its fields must be numbers here, not arrays.
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9.

    Returns
    -------
    Motion

    Raises
    ------
    ValueError
        If the scene never rests and has no end time, turns over, holds arrays, or overflows.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if the drive is at most the
    resistance, and turns back if not. A mass that nothing brings to rest (no friction, no cohesion) is followed to
    its first standstill.
    """
    numbers = {n: getattr(scene, n) for n in ("initial_velocity", "end_time")}
    numbers |= {f"arc.{n}": getattr(scene.arc, n) for n in QUANTITIES}
    numbers |= {} if callable(scene.friction) or isinstance(scene.friction, Mapping) else {"friction": scene.friction}
    for name, value in numbers.items():
        if not isinstance(value, (int, float)) and np.ndim(value) != 0:
            raise ValueError(f"{name}: has shape {np.shape(value)}; solve takes one scene of plain numbers")
    chosen = plan(scene, accuracy)
    try:
        with np.errstate(over="raise", invalid="raise", divide="raise", under="ignore"):
            motion = _solve(chosen)
            end = motion.end
        if not math.isfinite(end.displacement) or not math.isfinite(end.velocity):
            raise OverflowError
        return motion
    except (FloatingPointError, OverflowError) as error:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, end_time = {scene.end_time!r}: the motion overflows; give "
            "a lower velocity or an earlier end"
        ) from error


def _solve(chosen: Plan) -> Motion:
    scene, balance, law = chosen.scene, bind(chosen.scene), friction(chosen.scene.friction)
    scale, radius = float(scene.arc.time_scale), float(np.asarray(scene.arc.radius))
    omega = float(np.asarray(scene.initial_velocity)) / radius * scale
    end = math.inf if scene.end_time is None else scene.end_time / scale
    direction = int(np.sign(omega))
    time = rotation = slip = 0.0
    energy, phases, arrested, change = omega**2, [], False, None
    while time < end:
        if energy == 0.0:
            direction = _way(balance, law, rotation, slip)
            if direction == 0:
                arrested = True
                break
        # Just after a change nothing presses, to rounding: from then on it is the other way.
        lifted = _lifted(balance, rotation, direction, energy) if change is None else not phases[-1].solved.start.lifted
        start = Start(rotation, direction, energy, slip, lifted)
        if chosen.method == CLOSED_IN_TIME:
            solved: Course | Frozen = Frozen(balance, law, start, end - time)
        else:
            solved = Course(balance, law, radius, start, end - time)
        change = _change(solved, balance)
        duration = solved.duration if change is None else change[0]
        stop = time + duration
        phases.append(Phase(time, min(stop, end), rotation, direction, solved))
        if stop >= end:
            break
        if change is None and not solved.stops:
            _refuse(scene, solved, stop * scale)
        x, energy = (solved.end, 0.0) if change is None else change[1:]
        time, rotation, slip = stop, rotation + direction * x, slip + radius * x
        if energy == 0.0 and math.isinf(end) and balance.turns and _never_rests(balance, law):
            return Motion(chosen, balance, phases, time * scale, False)
        if len(phases) >= _MOST_PHASES:
            raise ValueError(
                f"end_time = {scene.end_time!r}: this mass turns back {_MOST_PHASES} times in {time * scale:.6g} s "
                "without resting; give an earlier end in s"
            )
    else:
        time = end
    if not arrested:
        time = end
    if math.isinf(time):
        _refuse(scene, phases[-1].solved, math.inf)
    duration = time * scale if arrested or scene.end_time is None else scene.end_time
    return Motion(chosen, balance, phases, duration, arrested)


def _refuse(scene: Scene, solved: Course | Frozen, time: float) -> None:
    if solved.balance.turns:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, friction: the chord stands upright after {time:.6g} s and "
            "the mass would hang over, which this method cannot follow; give an earlier end_time or a lower velocity"
        )
    raise ValueError("end_time: this slide never rests, as its geometry is frozen; add rotation, or give end_time in s")


def _way(balance: Balance, law: Friction, rotation: float, slip: float) -> int:
    """The direction in which a mass at rest moves, 0 if it stays: by the limit friction, of which the drive is made."""
    for side in (1, -1):
        at = balance.position(rotation, side)
        if balance.get("normal", **at) <= 0.0:
            moving = at["fall"] > balance.get("constant", mu=0.0)
        else:
            moving = balance.get("limit_friction", **at) > float(law.coefficient(slip))
        if moving:
            return side
    return 0


def _lifted(balance: Balance, rotation: float, direction: int, energy: float) -> bool:
    at = balance.position(rotation, direction)
    return bool(balance.get("effective_stress", **at, omega_2=energy) < 0.0)


def _never_rests(balance: Balance, law: Friction) -> bool:
    """No cohesion, and no friction, or water that carries the mass even where it would press most."""
    if balance.values.get("cohesion", 0.0):
        return False
    most = balance.radial if balance.turns else balance.press
    return (law.constant and float(law.coefficient(0.0)) == 0.0) or balance.get("normal", press=most) <= 0.0


def _change(solved: Course | Frozen, balance: Balance) -> tuple[float, float, float] | None:
    """Time, x and E at which the mass lifts off or lands, if it does before the phase ends; only water can carry it."""
    if balance.get("normal", press=0.0) == 0.0:  # no water that could carry the mass
        return None
    last = min(solved.duration, solved.longest)

    def pressing(t: float) -> float:
        x, omega, _ = solved.when(np.array([t]))
        return float(solved.pressing(x, omega**2)[0])

    times = last * np.sin(np.linspace(0.0, np.pi / 2, 65)) ** 2
    x, omega, _ = solved.when(times)
    sign = 1.0 if solved.start.lifted else -1.0
    over = sign * solved.pressing(x, omega**2)
    for k in range(1, len(times)):
        low, high, at_high = float(times[k - 1]), float(times[k]), float(over[k])
        highest = k + 1 < len(times) and over[k - 1] < over[k] >= over[k + 1]
        if highest and 0.0 <= -over[k] < over[k] - min(over[k - 1], over[k + 1]):  # perhaps there and back in between
            high = _highest(lambda t: sign * pressing(t), low, float(times[k + 1]))
            at_high = sign * pressing(high)
        if at_high <= 0.0:
            continue
        while (at_low := sign * pressing(low)) >= 0.0 and high > 1e-15 * last:  # zero, to rounding, at the start
            low = high / 2
            if sign * pressing(low) >= 0.0:  # also where nothing presses exactly there, or neither bound would move
                high, at_high = low, sign * pressing(low)
        t = root(lambda t: sign * pressing(t), low, high, at_low, at_high) if at_low < 0.0 else high
        x, omega, _ = solved.when(np.array([t]))
        return t, float(x[0]), float(omega[0]) ** 2
    return None


def _highest(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function with one hump is greatest, by golden section, or where it is first seen above zero."""
    share = (math.sqrt(5.0) - 1) / 2
    one, two = high - share * (high - low), low + share * (high - low)
    at_one, at_two = function(one), function(two)
    for _ in range(40):
        if max(at_one, at_two) > 0.0:
            break
        if at_one >= at_two:
            high, two, at_two = two, one, at_one
            one = high - share * (high - low)
            at_one = function(one)
        else:
            low, one, at_one = one, two, at_two
            two = low + share * (high - low)
            at_two = function(two)
    return one if at_one >= at_two else two
