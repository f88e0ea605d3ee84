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
from slipcircle.workbench.cost.reference import Floats

LAYER = {"pressurisation": 4e3, "heat_capacity": 2.7e6, "thickness": 0.5}  # Pa/K, J/m^3 K, m: it stays pressed
SHEARED = {"viscosity": 2e3, "thickness": 0.5}  # Pa s, m: it takes a sixth of the speed in the unit of time
LATEST = 1e3  # standstill, dimensionless
STANDING = 1e-9  # angular velocity below which a lane has come to rest


class Equation:
    """The numbers of a scene's equation of motion, and its rates over the arithmetic of a module."""

    def __init__(self, scene: Any, law: Mapping[str, Any]) -> None:
        arc, effects = scene.arc, scene.called
        alpha = float(arc.half_angle)
        self.scale, self.radius, self.dip = float(arc.time_scale), float(arc.radius), float(arc.dip)
        self.ends_at_rest = scene.end_time is None
        self.end = LATEST if self.ends_at_rest else float(scene.end_time) / self.scale
        self.weight = float(kernels.weight_moment_per_inertia(alpha))
        self.radial = float(kernels.radial_weight_per_inertia(alpha))
        self.polar = float(kernels.polar_moment_per_inertia(alpha))
        self.turns, self.heated = "rotation" in effects, "thermal_pressurisation" in effects
        self.record = effects.get("shaking", {}).get("horizontal")
        self.law, self.residual = law.get("law", "constant"), law.get("residual", 0.0)
        self.decay = self.radius / law.get("length", 1.0)
        self.pace = self.radius / self.scale / law.get("velocity", 1.0)
        self.heating = self.radius * LAYER["pressurisation"] / LAYER["heat_capacity"] / LAYER["thickness"]
        shear = SHEARED["viscosity"] / (arc.unit_weight * self.scale * SHEARED["thickness"])
        viscous = 2.0 * alpha * shear / kernels.moment_of_inertia(alpha)
        self.viscous = float(viscous) if "viscosity" in effects else 0.0

    def start(self) -> list[float]:
        """Rotation, angular velocity, and under heat the effective normal force."""
        normal = self.radial * math.cos(self.dip)
        return [0.0, 0.0, normal] if self.heated else [0.0, 0.0]

    def rate(self, mu: Any, state: Any, k_h: Any = None, m: Any = math, dip: Any = None) -> list[Any]:
        """The states' derivatives by dimensionless time, over the sine, cosine and exponential of `m`."""
        phi, omega, *stress = state
        dip = self.dip if dip is None else dip
        psi = dip - phi if self.turns else dip
        sin, cos = m.sin(psi), m.cos(psi)
        if self.law == "exponential":
            mu = self.residual + (mu - self.residual) * m.exp(-self.decay * phi)
        if self.law == "rate_weakening":
            mu = self.residual + (mu - self.residual) / (1.0 + self.pace * omega)
        drive, normal = self.weight * sin, self.radial * cos
        if k_h is not None:
            drive, normal = drive + self.weight * k_h * cos, normal - self.radial * k_h * sin
        if not self.heated:
            resistance = mu * (normal + self.polar * omega * omega) + self.viscous * omega
            return [omega, drive - resistance]
        gain = drive - mu * stress[0]
        growth = self.radial * sin + 2.0 * self.polar * gain - self.heating * mu * stress[0]
        return [omega, gain, growth * omega]

    def answer(self, phi: Any, omega: Any, time: Any) -> list[Any]:
        """Run-out, peak velocity and duration, m, m/s, s."""
        return [self.radius * phi, self.radius / self.scale * omega, time * self.scale]


def closed_form(equation: Equation, mu: Any) -> Floats:
    """By (3.20): domega/dt = a - b omega^2, of frozen masses that gain speed until their end time."""
    mu = np.atleast_1d(mu)
    drive, brake = equation.rate(mu, equation.start())[1], mu * equation.polar
    phi = motion.frozen_rotation(drive, brake, 0.0, equation.end)
    omega = motion.frozen_angular_velocity(drive, brake, 0.0, equation.end)
    return np.array(equation.answer(phi, omega, np.full(mu.shape, equation.end)))


def dop853(equation: Equation, tolerance: float, mu: Any) -> Floats:
    """By SciPy's DOP853, scene after scene, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    record = equation.record

    def rate(t: float, state: Any, mu: float) -> list[Any]:
        k_h = float(np.interp(t * equation.scale, record.time, record.values)) if record else None
        return equation.rate(mu, state, k_h)

    def standstill(_: float, state: Any, mu: float) -> float:
        return float(state[1])

    def peak(t: float, state: Any, mu: float) -> float:
        return float(rate(t, state, mu)[1])

    vars(standstill).update(terminal=equation.ends_at_rest, direction=-1.0)
    vars(peak).update(direction=-1.0)
    options: dict[str, Any] = {"method": "DOP853", "rtol": tolerance, "atol": 1e-3 * tolerance}
    columns = []
    for friction in np.atleast_1d(mu).tolist():
        span, events = (0.0, equation.end), [standstill, peak]
        path = solve_ivp(rate, span, equation.start(), events=events, args=(friction,), **options)
        speeds = path.y[1] if record else [*(state[1] for state in path.y_events[1]), path.y[1, -1]]
        columns.append(equation.answer(path.y[0, -1], max(speeds), path.t[-1]))
    return np.array(columns).T


def heyoka(equation: Equation, tolerance: float, lanes: int, mu: Any) -> Floats:
    """By heyoka's Taylor series: so many neighbouring frictions at once, all but the peak.

    The peak would take a call of Python from each lane, so that it is spared it.
    """
    integrator = _compiled(equation, tolerance, lanes)
    mu = np.atleast_1d(mu)
    columns = []
    for first in range(0, mu.size, lanes):
        integrator.set_time(0.0)
        integrator.state[:] = np.array(equation.start())[:, None]
        integrator.pars[0] = np.resize(mu[first : first + lanes], lanes)
        if equation.ends_at_rest:
            integrator.reset_cooldowns()
        until = np.full(lanes, equation.end)
        moving = np.full(lanes, True)
        while moving.any():  # it returns whenever a lane has come to rest; as a rule neighbours do so in one step
            integrator.propagate_until(until)
            moving = (integrator.state[1] > STANDING) & (integrator.time < until)
            until = np.where(moving, until, integrator.time)
        end_time, rotation = np.array(integrator.time), integrator.state[0].copy()
        columns.append(equation.answer(rotation, np.full(lanes, np.nan), end_time))
    return np.concatenate(columns, axis=1)[:, : mu.size]


@cache
def _compiled(equation: Equation, tolerance: float, lanes: int) -> Any:
    """heyoka's integrator of an equation, compiled for its tolerance and lanes."""
    import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]

    states = hy.make_vars("phi", "omega", "stress")[: len(equation.start())]
    rates = equation.rate(hy.par[0], list(states), m=hy, dip=hy.expression(equation.dip))
    falling = hy.event_direction.negative
    events = [hy.t_event_batch(states[1], direction=falling)] if equation.ends_at_rest else []
    start = [[value] * lanes for value in equation.start()]
    system = [*zip(states, rates, strict=True)]
    return hy.taylor_adaptive_batch(system, start, pars=[[0.0] * lanes], tol=tolerance, t_events=events)
