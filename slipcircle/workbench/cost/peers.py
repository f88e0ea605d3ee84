"""Other ways to solve a scene: the paper's closed form, SciPy's DOP853 and heyoka's Taylor series.

One equation of motion, (3.11) with (2.20), written out once by hand over any arithmetic, serves them
all: over floats SciPy's, over heyoka's expressions heyoka's.
"""

import math
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from generated import kernels, motion
from slipcircle.base.kinds import Floats

LAYER = {"pressurisation": 4e3, "heat_capacity": 2.7e6, "thickness": 0.5}  # Pa/K, J/m^3 K, m: it stays pressed
SHEARED = {"viscosity": 2e3, "thickness": 0.5}  # Pa s, m: it takes a sixth of the speed in the unit of time
LATEST = 1e3  # standstill, dimensionless
STANDING = 1e-9  # angular velocity below which a lane has come to rest


class Equation:
    """The numbers of a scene's equation of motion, and its rates over the arithmetic of a module."""

    def __init__(self, scene: Any, law: Mapping[str, Any]) -> None:
        arc = scene.arc
        effects = scene.called
        alpha = float(arc.half_angle)
        self.scale = float(arc.time_scale)
        self.radius = float(arc.radius)
        self.dip = float(arc.dip)
        self.ends_at_rest = scene.end_time is None
        self.end = LATEST
        if not self.ends_at_rest:
            self.end = float(scene.end_time) / self.scale
        self.weight = float(kernels.weight_moment_per_inertia(alpha))
        self.radial = float(kernels.radial_weight_per_inertia(alpha))
        self.polar = float(kernels.polar_moment_per_inertia(alpha))
        self.turns = "rotation" in effects
        self.heated = "thermal_pressurisation" in effects
        self.record = effects.get("shaking", {}).get("horizontal")
        self.law = law.get("law", "constant")
        self.residual = law.get("residual", 0.0)
        length = law.get("length", 1.0)
        velocity = law.get("velocity", 1.0)
        speed = self.radius / self.scale
        self.decay = self.radius / length
        self.pace = speed / velocity
        layer_heat = LAYER["heat_capacity"] * LAYER["thickness"]
        self.heating = self.radius * LAYER["pressurisation"] / layer_heat
        self.viscous = 0.0
        if "viscosity" in effects:
            stress_rate = SHEARED["viscosity"] / SHEARED["thickness"]
            stress_scale = arc.unit_weight * self.scale
            shear = stress_rate / stress_scale
            inertia = float(kernels.moment_of_inertia(alpha))
            self.viscous = 2.0 * alpha * shear / inertia

    def start(self) -> list[float]:
        """Rotation, angular velocity, and under heat the effective normal force."""
        state = [0.0, 0.0]
        if self.heated:
            normal = self.radial * math.cos(self.dip)
            state.append(normal)
        return state

    def rate(self, mu: Any, state: Any, k_h: Any = None, m: Any = math, dip: Any = None) -> list[Any]:
        """The states' derivatives by dimensionless time, over the sine, cosine and exponential of `m`."""
        phi, omega, *stress = state
        psi = self.dip if dip is None else dip
        if self.turns:
            psi = psi - phi
        sin = m.sin(psi)
        cos = m.cos(psi)
        drop = mu - self.residual
        if self.law == "exponential":
            mu = self.residual + drop * m.exp(-self.decay * phi)
        if self.law == "rate_weakening":
            weakening = 1.0 + self.pace * omega
            mu = self.residual + drop / weakening
        drive = self.weight * sin
        normal = self.radial * cos
        if k_h is not None:
            drive = drive + self.weight * k_h * cos
            normal = normal - self.radial * k_h * sin
        if not self.heated:
            pressing = normal + self.polar * omega * omega
            viscous = self.viscous * omega
            return [omega, drive - mu * pressing - viscous]
        (effective_normal,) = stress
        resistance = mu * effective_normal
        gain = drive - resistance
        by_turning = self.radial * sin
        by_speed = 2.0 * self.polar * gain
        by_heat = self.heating * resistance
        growth = by_turning + by_speed - by_heat
        return [omega, gain, growth * omega]

    def answer(self, phi: Any, omega: Any, time: Any) -> list[Any]:
        """Run-out, peak velocity and duration, m, m/s, s."""
        speed = self.radius / self.scale
        return [self.radius * phi, speed * omega, time * self.scale]


def closed_form(equation: Equation, mu: Any) -> Floats:
    """By (3.20): domega/dt = a - b omega^2, of frozen masses that gain speed until their end time."""
    mu = np.atleast_1d(mu)
    end = equation.end
    _, drive = equation.rate(mu, equation.start())
    brake = mu * equation.polar
    phi = motion.frozen_rotation(drive, brake, 0.0, end)
    omega = motion.frozen_angular_velocity(drive, brake, 0.0, end)
    time = np.full_like(mu, end)
    return np.array(equation.answer(phi, omega, time))


def dop853(equation: Equation, tolerance: float, mu: Any) -> Floats:
    """By SciPy's DOP853, scene after scene, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    record = equation.record

    def rate(t: float, state: Any, mu: float) -> list[Any]:
        if not record:
            return equation.rate(mu, state)
        k_h = np.interp(t * equation.scale, record.time, record.values)
        return equation.rate(mu, state, float(k_h))

    def standstill(_: float, state: Any, mu: float) -> float:
        return float(state[1])

    def peak(t: float, state: Any, mu: float) -> float:
        gain = rate(t, state, mu)[1]
        return float(gain)

    vars(standstill).update(terminal=equation.ends_at_rest, direction=-1.0)
    vars(peak).update(direction=-1.0)
    options: dict[str, Any] = {"method": "DOP853", "rtol": tolerance, "atol": 1e-3 * tolerance}
    options["events"] = [standstill, peak]
    span = (0.0, equation.end)
    start = equation.start()
    columns = []
    for friction in np.atleast_1d(mu).tolist():
        path = solve_ivp(rate, span, start, args=(friction,), **options)
        rotation, speed = path.y[:2]
        speeds = speed if record else speed[-1:]
        _, peaks = path.y_events
        at_peaks = [state[1] for state in peaks]
        fastest = max([*speeds, *at_peaks])
        end = path.t[-1]
        columns.append(equation.answer(rotation[-1], fastest, end))
    return np.array(columns).T


def heyoka(equation: Equation, tolerance: float, lanes: int, mu: Any) -> Floats:
    """By heyoka's Taylor series: so many neighbouring frictions at once, all but the peak.

    The peak would take a call of Python from each lane, so that it is spared it.
    """
    integrator = _compiled(equation, tolerance, lanes)
    mu = np.atleast_1d(mu)
    start = np.array(equation.start())
    no_peak = np.full(lanes, np.nan)
    columns = []
    for first in range(0, mu.size, lanes):
        batch = mu[first : first + lanes]
        integrator.set_time(0.0)
        integrator.state[:] = start[:, None]
        integrator.pars[0] = np.resize(batch, lanes)
        if equation.ends_at_rest:
            integrator.reset_cooldowns()
        until = np.full(lanes, equation.end)
        moving = np.ones(lanes, dtype=bool)
        while moving.any():  # it returns whenever a lane has come to rest; as a rule neighbours do so in one step
            integrator.propagate_until(until)
            faster = integrator.state[1] > STANDING
            moving = faster & (integrator.time < until)
            until = np.where(moving, until, integrator.time)
        end = np.array(integrator.time)
        rotation = integrator.state[0].copy()
        columns.append(equation.answer(rotation, no_peak, end))
    return np.concatenate(columns, axis=1)[:, : mu.size]


@cache
def _compiled(equation: Equation, tolerance: float, lanes: int) -> Any:
    """heyoka's integrator of an equation, compiled for its tolerance and lanes."""
    import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]

    start = [[value] * lanes for value in equation.start()]
    states = hy.make_vars("phi", "omega", "stress")[: len(start)]
    dip = hy.expression(equation.dip)
    rates = equation.rate(hy.par[0], list(states), m=hy, dip=dip)
    system = [*zip(states, rates, strict=True)]
    events = []
    if equation.ends_at_rest:
        falling = hy.event_direction.negative
        events.append(hy.t_event_batch(states[1], direction=falling))
    friction = [[0.0] * lanes]
    return hy.taylor_adaptive_batch(system, start, pars=friction, tol=tolerance, t_events=events)
