"""The motion of a scene: solved in phases of one direction each, in closed form, and read off at any time."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated import motion as formulas
from slipcircle.arc import QUANTITIES
from slipcircle.checks import INFINITY, mistakes, raise_all
from slipcircle.plan import Plan, plan
from slipcircle.scene import Scene

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class State:
    """The motion at one time, or at an array of times; counterclockwise and down-slope for a positive dip.

    Attributes
    ----------
    time, rotation, angular_velocity, velocity, displacement, acceleration, normal_stress
        s, rad, rad/s, m/s and m along the arc, m/s^2 along the arc, Pa (mean over the arc).
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
    """The energy balance from the start to the end, J.

    Attributes
    ----------
    kinetic_start, kinetic_end, work, dissipation
        Kinetic energies, work of gravity, and what friction took, by its own quadrature.
    """

    kinetic_start: float
    kinetic_end: float
    work: float
    dissipation: float

    @property
    def residual(self) -> float:
        """Work of gravity - change of kinetic energy - dissipation."""
        return self.work - (self.kinetic_end - self.kinetic_start) - self.dissipation


@dataclass(frozen=True)
class Phase:
    """A stretch of motion in one direction, dimensionless: d(omega)/dt = a - b omega**2 from omega_0 at its start."""

    start: float
    rotation: float
    direction: int
    omega_0: float
    coefficients: tuple[float, ...]  # (a, b), or (a,) without centripetal stress

    @property
    def brakes(self) -> bool:
        """Whether it comes to a standstill."""
        return self.coefficients[0] < 0.0


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
    energy : Energy
        Balance from the start to the end.
    """

    def __init__(self, plan: Plan, phases: tuple[Phase, ...], end_time: float, arrested: bool) -> None:
        self.plan = plan
        self.phases = phases
        self.moves = bool(phases) and end_time > 0.0
        self.arrested = arrested
        self.duration = end_time
        self.end = self.at(end_time)
        self.run_out = float(self.end.displacement)
        # Within a phase the speed is monotone, so its peak is at a phase's start or at the end.
        starts = [p.start * float(self._arc.time_scale) for p in phases]
        self.peak = max((self.at(t) for t in [*starts, end_time]), key=lambda s: abs(float(s.velocity)))

    @property
    def _arc(self) -> Any:
        return self.plan.scene.arc

    def _formula(self, name: str) -> Callable[..., Any]:
        return getattr(formulas, f"{self.plan.prefix}_{name}")

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
        raise_all("Motion.at", mistakes({"times": times}, {"times": (-5e-324, INFINITY, "times in s, not before 0")}))
        time = np.asarray(times, dtype=np.float64)
        late = time[time > self.duration]
        if late.size and not self.arrested:
            raise ValueError(
                f"Motion.at: times = {float(late.flat[0])!r}: must be at most the scene's end_time, "
                f"{float(self.duration)!r} s, as the mass does not rest there"
            )
        scale = float(self._arc.time_scale)
        t = time / scale
        rotation, omega, rate = np.zeros_like(t), np.zeros_like(t), np.zeros_like(t)
        for phase, end in self._spans(self.duration / scale if self.arrested else np.inf):
            local = np.clip(t, phase.start, end) - phase.start
            phi = phase.rotation + phase.direction * self._turned(phase, local)
            rotation = np.where(t >= phase.start, phi, rotation)
            inside = (t >= phase.start) & (t < end)
            for name, values in (("angular_velocity", omega), ("angular_acceleration", rate)):
                found = self._formula(name)(*phase.coefficients, phase.omega_0, local)
                np.copyto(values, phase.direction * found, where=inside)
        return self._state(time, rotation, omega, rate)

    def _spans(self, last: float) -> list[tuple[Phase, float]]:
        """Each phase with its end, dimensionless; there are none if the mass never moves."""
        return list(zip(self.phases, [*(p.start for p in self.phases[1:]), last], strict=False))

    def _turned(self, phase: Phase, local: Floats) -> Any:
        return self._formula("rotation")(*phase.coefficients, phase.omega_0, local)

    def _state(self, time: Floats, rotation: Floats, omega: Floats, rate: Floats) -> State:
        arc, d = self._arc, self._arc.dimensionless
        scale, radius = float(arc.time_scale), float(arc.radius)
        speed = omega / scale
        dynamic = (d.dynamic_coefficient, omega) if "centripetal" in self.plan.effects else ()
        stress = self._formula("mean_normal_stress")(d.static_normal_stress, *dynamic) * arc.reference_stress
        return State(
            time[()], rotation[()], speed[()], (radius * speed)[()], (radius * rotation)[()],
            (radius * rate / scale**2)[()], np.broadcast_to(stress, time.shape)[()],
        )  # fmt: skip

    @cached_property
    def energy(self) -> Energy:
        """Energy balance; the dissipation is integrated over time by Gauss-Legendre quadrature, not a difference."""
        arc, d, mu = self._arc, self._arc.dimensionless, float(np.asarray(self.plan.scene.friction))
        unit = float(arc.width) * float(arc.unit_weight) * float(arc.radius) ** 3  # J for a moment J* and a rotation 1
        scale = float(arc.time_scale)
        nodes, weights = np.polynomial.legendre.leggauss(24)
        dissipation = 0.0
        for phase, end in self._spans(self.duration / scale):
            for left, right in _panels(phase, end):
                t = (left + right) / 2 + (right - left) / 2 * nodes
                omega = self._formula("angular_velocity")(*phase.coefficients, phase.omega_0, t - phase.start)
                dynamic = (d.dynamic_coefficient, omega) if "centripetal" in self.plan.effects else ()
                stress = self._formula("mean_normal_stress")(d.static_normal_stress, *dynamic)
                power = mu * d.resistance_factor * stress * omega
                dissipation += float((right - left) / 2 * np.dot(weights, np.broadcast_to(power, t.shape)))
        inertia = float(d.moment_of_inertia)
        start = self.at(0.0)
        return Energy(
            kinetic_start=unit * inertia * (float(start.angular_velocity) * scale) ** 2 / 2,
            kinetic_end=unit * inertia * (float(self.end.angular_velocity) * scale) ** 2 / 2,
            work=unit * float(d.weight_moment) * float(self.end.rotation),
            dissipation=unit * dissipation,
        )


def _panels(phase: Phase, end: float) -> list[tuple[float, float]]:
    """Stretches on which 24 nodes are exact to rounding: each twice as long as the one before.

    As a function of complex time the velocity is singular only before the phase's start, at a distance of 1/rate or
    more, and, where it brakes, at least as far beyond the end as the start is before it.
    """
    a, b = (*phase.coefficients, 0.0)[:2]
    rate = float(np.sqrt(abs(a)) * np.sqrt(b) + b * phase.omega_0)
    length = end - phase.start
    count = max(0, int(np.ceil(np.log2(max(1.0, 2.0 * rate * length)))))
    edges = [phase.start, *(phase.start + length / 2.0**n for n in range(count, -1, -1))]
    return list(pairwise(edges))


def solve(scene: Scene, accuracy: float | None = None) -> Motion:
    """Solve a scene until it rests, or until its end time.

    Parameters
    ----------
    scene : Scene
        Its fields must be numbers here, not arrays.
    accuracy : float, optional
        Relative error asked for; by default the scene's own, or 1e-9. Closed forms are exact to rounding.

    Returns
    -------
    Motion

    Raises
    ------
    ValueError
        If the scene never rests and has no end time, holds arrays, or overflows.

    Notes
    -----
    Friction opposes the motion and never drives it. At a standstill the mass stays if |J_theta| <= mu J_r, and turns
    back if not. Before that, where it moves against gravity, friction and weight brake together.
    """
    chosen = plan(scene, accuracy)
    numbers = {n: getattr(scene, n) for n in ("friction", "initial_velocity", "end_time")}
    numbers |= {f"arc.{n}": getattr(scene.arc, n) for n in QUANTITIES}
    for name, value in numbers.items():
        if np.ndim(value) != 0:
            raise ValueError(f"{name}: has shape {np.shape(value)}; solve takes one scene of plain numbers")
    try:
        with np.errstate(over="raise", invalid="raise"):
            return _solve(chosen)
    except FloatingPointError as error:
        raise ValueError(
            f"initial_velocity = {scene.initial_velocity!r}, end_time = {scene.end_time!r}: the motion overflows; give "
            "a lower velocity or an earlier end"
        ) from error


def _solve(chosen: Plan) -> Motion:
    scene = chosen.scene
    arc, d = scene.arc, scene.arc.dimensionless
    scale = float(arc.time_scale)
    limit, mu = float(d.limit_friction), float(np.asarray(scene.friction))
    omega = float(np.asarray(scene.initial_velocity)) / float(np.asarray(arc.radius)) * scale
    end = np.inf if scene.end_time is None else scene.end_time / scale
    phases: list[Phase] = []
    time, rotation, arrested = 0.0, 0.0, False
    while not arrested and time < end:
        if omega == 0.0 and abs(limit) <= mu:  # the rest test, by the one number that the drive is made of
            arrested = True
            break
        direction = int(np.sign(omega if omega != 0.0 else limit))
        a = float(getattr(formulas, f"{chosen.prefix}_drive")(direction * limit, mu, d.radial_weight_per_inertia))
        centripetal = "centripetal" in chosen.effects
        b = (float(getattr(formulas, f"{chosen.prefix}_brake")(mu, d.polar_moment_per_inertia)),) if centripetal else ()
        phase = Phase(time, rotation, direction, abs(omega), (a, *b))
        phases.append(phase)
        if not phase.brakes:
            time = end
            break
        stop = float(getattr(formulas, f"{chosen.prefix}_arrest_time")(a, *b, phase.omega_0))
        if time + stop >= end:
            time = end
            break
        turned = float(getattr(formulas, f"{chosen.prefix}_arrest_rotation")(a, *b, phase.omega_0))
        time, rotation, omega = time + stop, rotation + direction * turned, 0.0
    if not np.isfinite(time):
        raise ValueError(
            f"end_time: this slide never rests, so it needs one (friction {mu:.6g}, limit friction {abs(limit):.6g}, "
            "frozen geometry); give end_time in s"
        )
    duration = time * scale if arrested or scene.end_time is None else scene.end_time
    return Motion(chosen, tuple(phases), duration, arrested)
