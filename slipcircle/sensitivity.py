"""Exact derivatives of peak velocity, run-out and duration by each parameter of a scene, through all of its phases.

By implicit differentiation of the closed forms (`generated.sensitivity`): the mass rests where E(x) = 0, so
dx/dp = -(dE/dp)/(dE/dx) there; at the peak dE/dx = 0, so only dE/dp counts; and the time is the integral of E**-0.5
over x = end sin(s)**2, differentiated at fixed s, where nothing is singular. A name with `_dot` holds derivatives, one
for each parameter.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from generated import sensitivity as slopes
from generated.effects import EFFECTS
from slipcircle.friction import friction
from slipcircle.methods.frozen import Frozen
from slipcircle.plan import CLOSED_IN_PHASE_PLANE, CLOSED_IN_TIME
from slipcircle.scene import Scene

if TYPE_CHECKING:
    from slipcircle.methods.phaseplane import Course
    from slipcircle.motion import Motion, Phase

Floats = NDArray[np.float64]

OUTPUTS: Mapping[str, str] = {"peak_velocity": "m/s", "run_out": "m", "duration": "s"}
OF_SCENE = {"friction": "", "theta_1": "rad", "theta_2": "rad", "radius": "m", "unit_weight": "N/m^3",
             "gravity": "m/s^2", "initial_velocity": "m/s"}  # fmt: skip
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(20)
_SCALES = ("half_angle", "gravity", "reference_stress", "Theta")


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives of a motion by the parameters of its scene.

    Attributes
    ----------
    outputs : mapping
        Unit of each row: peak_velocity, run_out, duration; signed as `Motion` gives them.
    parameters : mapping
        Unit of each column: friction, theta_1, ..., and the effects' parameters as ``effect.parameter``.
    at : dict of float
        Value of each output and each parameter.
    values : ndarray
        d(output)/d(parameter), SI units and radians.
    elasticities : ndarray
        (parameter/output) d(output)/d(parameter): per cent for a per cent; NaN where the output is zero.
    """

    outputs: Mapping[str, str]
    parameters: Mapping[str, str]
    at: Mapping[str, float]
    values: Floats

    @property
    def elasticities(self) -> Floats:
        of = np.array([self.at[n] for n in self.outputs])[:, None]
        by = np.array([self.at[n] for n in self.parameters])
        return np.asarray(self.values * by / np.where(of == 0.0, np.nan, of))

    def derivative(self, output: str, parameter: str) -> float:
        """One of the values."""
        return float(self.values[list(self.outputs).index(output), list(self.parameters).index(parameter)])

    def rows(self) -> list[list[str]]:
        """The table as text, a row for each parameter: its value, then for each output derivative and elasticity."""
        found = []
        for k, (name, unit) in enumerate(self.parameters.items()):
            cells = [f"{v:.6g} ({e:+.3g})" for v, e in zip(self.values[:, k], self.elasticities[:, k], strict=True)]
            found.append([f"{name} [{unit}]" if unit else name, f"{self.at[name]:.6g}", *cells])
        return found

    def __str__(self) -> str:
        head = ["by", "value", *(f"d {n} [{unit}] (elasticity)" for n, unit in self.outputs.items())]
        lines = [head, *self.rows()]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        return "\n".join("  ".join(c.ljust(w) for c, w in zip(line, widths, strict=True)).rstrip() for line in lines)


def sensitivity(motion: "Motion") -> Sensitivity:
    """Derivatives of a motion under constant friction.

    Raises
    ------
    ValueError
        If friction is not constant, or if the scene is exactly at its limit, where no derivative exists.

    Notes
    -----
    Angles are left out where the arc's coefficients are given instead of computed, and the initial velocity where the
    mass starts from rest. Without friction the derivatives are those of the first standstill, which is what `solve`
    gives there.
    """
    scene = motion.plan.scene
    if motion.plan.method not in (CLOSED_IN_TIME, CLOSED_IN_PHASE_PLANE) or motion.plan.law != "constant":
        raise ValueError(
            f"exact sensitivities need a closed form: a constant coefficient of friction and no effect that depends on "
            f"time, on speed alone or on heat; this scene's method is {motion.plan.method}, its friction "
            f"{motion.plan.law}; take differences of solutions"
        )
    if not motion.moves and motion.limit_friction == float(friction(scene.friction).coefficient(0.0)):
        raise ValueError("friction: the scene is exactly at its limit, where the motion has no derivative")
    parameters = _parameters(scene)
    names = {"peak_velocity": float(motion.peak.velocity), "run_out": motion.run_out, "duration": motion.duration}
    values = np.zeros((len(OUTPUTS), len(parameters)))
    if motion.moves:
        values[:] = _Chain(motion, parameters).follow()
    return Sensitivity(OUTPUTS, {n: unit for n, (unit, _) in parameters.items()},
                       names | {n: value for n, (_, value) in parameters.items()}, values)  # fmt: skip


def _parameters(scene: Scene) -> dict[str, tuple[str, float]]:
    """Unit and value of each free parameter."""
    values = dict(scene.numbers)
    values["friction"] = friction(scene.friction).coefficient(0.0)  # also where it is a law by name
    found = {n: (unit, float(np.asarray(values[n]))) for n, unit in OF_SCENE.items()}
    if found["initial_velocity"][1] == 0.0:
        del found["initial_velocity"]
    if scene.arc.given is not None:
        del found["theta_1"], found["theta_2"]
    for effect, declared in EFFECTS.items():
        units = {f"{effect}.{p.name}": p.unit for p in declared.parameters}
        found |= {n: (unit, float(np.asarray(values[n]))) for n, unit in units.items() if n in values}
    return found


@dataclass
class _End:
    """Where a phase ends: rotation in its direction, the time it took, E, and their derivatives."""

    x_dot: Floats
    elapsed_dot: Floats
    energy: float
    energy_dot: Floats


class _Chain:
    """Derivatives carried from phase to phase, dimensionless."""

    def __init__(self, motion: "Motion", parameters: Mapping[str, tuple[str, float]]) -> None:
        self.motion, self.balance, self.count = motion, motion.balance, len(parameters)
        self.scene, arc, d = motion.plan.scene, motion.plan.scene.arc, motion.plan.scene.arc.dimensionless
        names = list(parameters)

        def one(name: str) -> Floats:
            return np.array([float(n == name) for n in names])

        def relative(name: str) -> Floats:
            return one(name) / parameters[name][1]

        alpha = float(arc.half_angle)
        alpha_dot = (one("theta_2") - one("theta_1")) / 2
        self.dip_dot = -(one("theta_1") + one("theta_2")) / 2
        growth = [float(g) for g in slopes.arc_growth(alpha)]
        self.weight_growth, self.radial_growth = growth[0] * alpha_dot, growth[1] * alpha_dot
        self.mu_dot = one("friction")
        self.radius_growth, gravity = relative("radius"), relative("gravity")
        self.scale_growth, self.speed_growth = (self.radius_growth - gravity) / 2, (self.radius_growth + gravity) / 2
        values = self.balance.values
        self.values = {
            "level": values["level"],
            "polar": values["polar"] if "centripetal" in self.scene.called else 0.0,
        }
        self.values_dot = {"level": values["level"] * growth[3] * alpha_dot,
                           "polar": self.values["polar"] * growth[2] * alpha_dot}  # fmt: skip
        scales = {"half_angle": alpha, "gravity": float(np.asarray(arc.gravity)),
                  "reference_stress": float(arc.reference_stress), "Theta": float(d.moment_of_inertia)}  # fmt: skip
        # (2.13): sigma_ref = unit weight * R (1 - cos alpha)
        stress_growth = relative("unit_weight") + self.radius_growth + alpha_dot / math.tan(alpha / 2)
        growths = (alpha_dot / alpha, gravity, stress_growth, growth[4] / alpha * alpha_dot)
        scales_dot = [scales[n] * g for n, g in zip(_SCALES, growths, strict=True)]
        for effect, declared in EFFECTS.items():
            for p in declared.parameters:
                tangent = getattr(slopes, f"{p.symbol}_tangent", None)
                if tangent is None:  # it has no part in closed forms
                    continue
                name = f"{effect}.{p.name}"
                self.values[p.symbol], self.values_dot[p.symbol] = values.get(p.symbol, 0.0), 0.0 * alpha_dot
                if name in parameters:
                    value = (parameters[name][1], *(scales[n] for n in _SCALES))
                    self.values_dot[p.symbol] = tangent(*value, one(name), *scales_dot) + 0.0 * alpha_dot
        self.time_dot, self.rotation_dot = 0.0 * alpha_dot, 0.0 * alpha_dot
        self.energy_dot = 0.0 * alpha_dot
        if float(np.asarray(self.scene.initial_velocity)) != 0.0:  # E = v**2/(g R)
            first = motion.phases[0].solved.start.energy
            self.energy_dot = 2 * first * (relative("initial_velocity") - self.speed_growth)

    def follow(self) -> Floats:
        """Rows: peak velocity, run-out, duration."""
        motion = self.motion
        fastest, peak_dot = -1.0, 0.0 * self.mu_dot
        for k, phase in enumerate(motion.phases):
            following = motion.phases[k + 1] if k + 1 < len(motion.phases) else None
            side, solved = phase.direction, cast("Course | Frozen", phase.solved)
            reduced = self._reduced(phase, solved)
            if isinstance(solved, Frozen):
                end, summit = self._frozen(phase, solved, following, reduced)
            else:
                end, summit = self._course(phase, solved, following, reduced)
            for energy, energy_dot in [(phase.solved.start.energy, self.energy_dot), *summit]:
                if energy > fastest * fastest * (fastest > 0.0) and energy > 0.0:
                    fastest = math.sqrt(energy)
                    peak_dot = side * (energy_dot / (2 * fastest) + fastest * self.speed_growth)
            self.time_dot = self.time_dot + end.elapsed_dot
            self.rotation_dot = self.rotation_dot + side * end.x_dot
            self.energy_dot = end.energy_dot
            if following is None and end.energy > max(fastest, 0.0) ** 2:
                omega = math.sqrt(end.energy)
                peak_dot = side * (end.energy_dot / (2 * omega) + omega * self.speed_growth)
        scale, radius = float(self.scene.arc.time_scale), float(np.asarray(self.scene.arc.radius))
        rotation = float(motion.end.rotation)
        duration_dot = 0.0 * self.time_dot
        if self._stops_at_last():
            duration_dot = scale * self.time_dot + motion.duration * self.scale_growth
        run_out_dot = radius * (self.rotation_dot + rotation * self.radius_growth)
        return np.array([radius / scale * peak_dot, run_out_dot, duration_dot])

    def _stops_at_last(self) -> bool:
        return self.motion.arrested or self.scene.end_time is None

    def _reduced(self, phase: "Phase", solved: "Course | Frozen") -> Floats:
        """Derivatives of start, drive, tilt, constant and brake of a phase, and of what presses and its slope."""
        turned = self.rotation_dot if self.balance.turns else 0.0
        at = {n: solved.at[n] for n in ("fall", "press", "fall_slope", "press_slope")}
        dip_dot = phase.direction * (self.dip_dot - turned)
        fall, press, fall_slope, press_slope = at.values()
        tangent = slopes.position_tangent(
            fall, press, fall_slope, press_slope, self.weight_growth, self.radial_growth, dip_dot
        )
        dots = dict(zip(at, tangent, strict=True))
        dots["mu"] = self.mu_dot * (not solved.start.lifted)
        *found, _ = self._balance_dot(at | {"mu": solved.mu}, dots)
        return np.array([self.energy_dot, *found, dots["press"], dots["press_slope"]])

    def _balance_dot(self, at: dict[str, Any], dots: dict[str, Any]) -> Any:
        """Derivatives of drive, tilt, constant, brake and what presses, from those of what they are made of."""
        none = dict.fromkeys(("fall", "press", "fall_slope", "press_slope", "mu", "omega_2"), 0.0)
        dots = {f"{n}_dot": value for n, value in (none | self.values_dot | dots).items()}
        return slopes.balance_tangent(**(none | self.values | at), **dots)

    def _until(self, phase: "Phase", following: "Phase | None") -> str:
        """What ends a phase: "stop", "time", or "change", where water lifts or sets down the mass."""
        if following is None:
            return "stop" if self._stops_at_last() else "time"
        return "change" if following.solved.start.energy > 0.0 else "stop"

    def _elapsed_dot(self, phase: "Phase") -> Floats:
        """Of the time from the start of a phase to the end time, which is fixed in seconds."""
        return -phase.end * self.scale_growth - self.time_dot

    def _pressing(self, x: float, energy: float, phase: "Phase", reduced: Floats) -> tuple[float, float, Floats]:
        """What presses, lambda sigma/Theta*: its slopes by x and by E, and its derivatives at fixed x and E."""
        at, turned = phase.solved.at, x if self.balance.turns else 0.0
        sine, cosine = math.sin(turned), math.cos(turned)
        press = at["press"] * cosine - at["press_slope"] * sine
        rise = -at["press"] * sine - at["press_slope"] * cosine if self.balance.turns else 0.0
        press_dot = reduced[5] * cosine - reduced[6] * sine
        *_, found = self._balance_dot({"press": press, "omega_2": energy}, {"press": press_dot})
        return self.balance.get("normal", press=rise, level=0.0), self.values["polar"], found

    # -- one phase

    def _frozen(
        self, phase: "Phase", solved: Frozen, following: "Phase | None", reduced: Floats
    ) -> tuple[_End, list[tuple[float, Floats]]]:
        """The closed form in time; the speed is greatest at one of the ends."""
        elapsed, until = phase.end - phase.start, self._until(phase, following)
        b = float(self.balance.get("brake", mu=solved.mu))
        x, omega, rate = solved.state(elapsed)
        omega_0_dot = reduced[0] / (2 * solved.omega_0) if solved.omega_0 else 0.0 * reduced[0]
        inputs_dot = np.array([reduced[1], reduced[4], omega_0_dot])
        found = [float(s) for s in slopes.frozen_slopes(solved.a, b, solved.omega_0, elapsed)]
        x_dot, omega_dot = found[:3] @ inputs_dot, found[3:] @ inputs_dot
        if until == "stop":
            elapsed_dot = -omega_dot / solved.a
            return _End(x_dot, elapsed_dot, 0.0, 0.0 * x_dot), []
        if until == "time":
            elapsed_dot = self._elapsed_dot(phase)
        else:
            by_x, by_energy, pressing_dot = self._pressing(x, omega**2, phase, reduced)
            pace = by_x * omega + by_energy * 2 * omega * rate
            elapsed_dot = -(pressing_dot + by_x * x_dot + by_energy * 2 * omega * omega_dot) / pace
        energy_dot = 2 * omega * (omega_dot + rate * elapsed_dot)
        return _End(x_dot + omega * elapsed_dot, elapsed_dot, omega**2, energy_dot), []

    def _course(
        self, phase: "Phase", solved: "Course", following: "Phase | None", reduced: Floats
    ) -> tuple[_End, list[tuple[float, Floats]]]:
        """The phase plane. Its end moves by end_dot, and what is at x = share * end by share * end_dot."""
        elapsed, until = phase.end - phase.start, self._until(phase, following)
        forward, forward_dot = _energy(solved), reduced[:5]
        end, end_dot = solved.end, 0.0 * reduced[0]
        if solved.stops:
            end_dot = -(_basis(end, forward) @ forward_dot) / float(solved.slope(end, 0.0))
        backward, backward_dot = _reversed(solved, forward, forward_dot, end_dot)

        def moved(x: Floats, left: Floats, energy: Floats) -> Floats:
            """dE/dp at fixed shares, from the nearer end of the path; a brake lets errors grow backwards."""
            back = (left < x) & (2 * solved.brake * left < 1.0) & solved.stops
            rate = solved.slope(x, energy)
            found = np.empty((len(x), self.count))
            found[~back] = _basis(x[~back], forward).T @ forward_dot + np.outer(rate[~back] * x[~back] / end, end_dot)
            found[back] = _basis(left[back], backward).T @ backward_dot - np.outer(
                rate[back] * left[back] / end, end_dot
            )
            return found

        last = np.pi / 2 if solved.stops else 1.0
        if until == "time":
            last = float(solved._reached(np.array([elapsed]))[0])
        elif until == "change":
            assert following is not None
            last = solved._variable(phase.direction * (following.rotation - phase.rotation))
        edges = solved.clock.edges
        edges = np.append(edges[edges < last], last)
        half = np.diff(edges) / 2
        s = ((edges[:-1] + half)[:, None] + half[:, None] * _NODES).ravel()
        x, left, stretch = solved._place(s)
        energy = solved.speed_squared(x, left)
        weight = (half[:, None] * _WEIGHTS).ravel() * stretch / np.sqrt(energy)
        if solved.stops and solved.start.energy == 0.0 and end * max(1.0, solved.brake) < 0.1:
            time_dot = -(weight / (2 * energy)) @ _short(x, end, end_dot, forward, forward_dot)
        else:  # t = int dx/sqrt(E) at fixed shares: each part grows with end, and falls with sqrt(E)
            time_dot = weight.sum() * end_dot / end - (weight / (2 * energy)) @ moved(x, left, energy)
        summit = []
        peak_time, peak, omega, _ = solved.fastest()
        if 0.0 < peak < end and phase.start + peak_time <= phase.end:
            summit.append((omega**2, _basis(peak, forward) @ forward_dot))
        if until == "stop":
            return _End(end_dot, time_dot, 0.0, 0.0 * end_dot), summit
        x, left, _ = solved._place(np.array([last]))
        energy = solved.speed_squared(x, left)
        at, omega, rate = float(x[0]), math.sqrt(float(energy[0])), float(solved.slope(x, energy)[0])
        x_dot, e_dot = at / end * end_dot, moved(x, left, energy)[0]
        if until == "time":
            further = omega * (self._elapsed_dot(phase) - time_dot)
        else:
            by_x, by_energy, pressing_dot = self._pressing(at, float(energy[0]), phase, reduced)
            further = -(pressing_dot + by_x * x_dot + by_energy * e_dot) / (by_x + by_energy * rate)
        return _End(x_dot + further, time_dot + further / omega, omega**2, e_dot + rate * further), summit


def _energy(solved: "Course") -> tuple[float, ...]:
    """Start, drive, tilt, constant, brake."""
    return solved.start.energy, solved.drive, solved.tilt, solved.constant, solved.brake


def _basis(x: Any, values: tuple[float, ...]) -> Floats:
    """dE/d(start, drive, tilt, constant, brake) at x."""
    return np.array(np.broadcast_arrays(*slopes.energy_slopes(x, *values)))


def _short(x: Floats, end: float, end_dot: Floats, values: tuple[float, ...], values_dot: Floats) -> Floats:
    """d(E/end**2)/dp end**2 at fixed shares of a path from rest to rest that is short, as it is just below its limit.

    There E/end**2 depends little on the end, and its parts much: with drive/end in place of the drive, which follows
    from E(end) = 0, nothing cancels.
    """
    _, drive, tilt, constant, brake = values
    at = np.append(x, end)
    basis = _basis(at, values)
    of_cos, of_sin, of_lift = (g[:, None] * end_dot / end for g in slopes.energy_growth(at, brake))
    rest = basis[2:].T @ values_dot[2:] + 2 * (drive * of_cos - tilt * of_sin - constant * of_lift)
    return np.asarray(rest[:-1] - np.outer(basis[1, :-1] / basis[1, -1], rest[-1]))


def _reversed(
    solved: "Course", values: tuple[float, ...], values_dot: Floats, end_dot: Floats
) -> tuple[tuple[float, ...], Floats]:
    """The same motion back from its end, where it is known to stand: drive, constant and brake change their signs."""
    _, drive, tilt, constant, brake = values
    sine, cosine, lift = math.sin(solved.end), math.cos(solved.end), 2 * math.sin(solved.end / 2) ** 2
    _, drive_dot, tilt_dot, constant_dot, brake_dot = values_dot
    last = float(solved.driving(solved.end))
    steep = (drive + constant) * sine + tilt * cosine  # the drive falls by this, and it rises by the drive + constant
    last_dot = drive_dot * cosine - tilt_dot * sine - constant_dot * lift - steep * end_dot
    steep_dot = (drive_dot + constant_dot) * sine + tilt_dot * cosine + (last + constant) * end_dot
    return (0.0, -last, steep, -constant, -brake), np.array(
        [0.0 * end_dot, -last_dot, steep_dot, -constant_dot, -brake_dot]
    )
