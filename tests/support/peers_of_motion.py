"""The slide of Vaiont in other integrators: heyoka, alone and in batches, and SciPy's.

Turning, with centripetal pressure, under three laws of friction; the equation of motion (3.11) with (2.20) is written
out for each of them. All are functions from frictions to rotations and times at rest, dimensionless.
"""

import math
import os
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from generated import kernels
from slipcircle import Arc, Scene, load

Floats = NDArray[np.float64]
LATEST = 1e3  # standstill, dimensionless
STANDING = 1e-13  # angular velocity below which a lane has come to rest
VAIONT: Scene[Any] = load("vaiont")
ARC: Arc[Any] = VAIONT.arc
RESIDUAL = math.tan(math.radians(8.0))
LAWS: Mapping[str, Mapping[str, Any]] = {
    "constant": {},
    "exponential": {"law": "exponential", "residual": RESIDUAL, "length": 1.0},
    "rate": {"law": "rate_weakening", "residual": RESIDUAL, "velocity": 5.0},
}


def friction(law: str, mu: Any) -> Any:
    """Return the law with this coefficient at its start, as scenes have it."""
    return {**LAWS[law], "peak": mu} if LAWS[law] else mu


def acceleration(law: str, mu: Any, phi: Any, omega: Any, functions: Any) -> Any:
    """Angular acceleration, dimensionless, over the functions' numbers or expressions."""
    alpha = float(ARC.half_angle)
    weight, radial, polar = (
        float(getattr(kernels, f"{name}_per_inertia")(alpha))
        for name in ("weight_moment", "radial_weight", "polar_moment")
    )
    psi = float(ARC.dip) - phi
    if law == "exponential":
        mu = RESIDUAL + (mu - RESIDUAL) * functions.exp(-float(ARC.radius) / LAWS[law]["length"] * phi)
    if law == "rate":
        speed = float(ARC.radius) / float(ARC.time_scale)
        mu = RESIDUAL + (mu - RESIDUAL) / (1.0 + speed / LAWS[law]["velocity"] * omega)
    return weight * functions.sin(psi) - mu * (radial * functions.cos(psi) + polar * omega * omega)


def equations(law: str) -> list[tuple[Any, Any]]:
    """Return the system in heyoka's expressions."""
    phi, omega = hy.make_vars("phi", "omega")
    return [(phi, omega), (omega, acceleration(law, hy.par[0], phi, omega, hy))]


def in_batches(law: str, tolerance: float, lanes: int) -> Callable[[Floats], Floats]:
    """Return a solver by heyoka in batches of so many frictions; lanes that have not come to rest continue."""
    system = equations(law)
    standstill = hy.t_event_batch(system[1][0], direction=hy.event_direction.negative)
    integrator = hy.taylor_adaptive_batch(
        system,
        np.zeros((2, lanes)),
        pars=np.zeros((1, lanes)),
        tol=tolerance,
        t_events=[standstill],
        force_avx512=os.environ.get("SLIPCIRCLE_COMPILED") == "avx512",
        fast_math=True,
    )
    state, parameters = integrator.state, integrator.pars
    omega = state[1]
    latest = [LATEST] * lanes

    def run(mu: Floats) -> Floats:
        padded = np.resize(mu, (-(-mu.size // lanes), lanes))
        results = np.empty((2, *padded.shape))
        for k, batch in enumerate(padded):
            integrator.set_time(0.0)
            integrator.reset_cooldowns()
            state[:] = 0.0
            parameters[0] = batch
            integrator.propagate_until(latest)
            while omega.max() > STANDING:  # it returns as soon as one lane rests
                until = np.where(omega > STANDING, LATEST, integrator.time)
                integrator.propagate_until(until)
            results[0, k] = state[0]
            results[1, k] = integrator.time
        return results.reshape(2, -1)[:, : mu.size]

    return run


def one_by_one(solver: Callable[[float], tuple[float, float]], mu: Floats) -> Floats:
    """Rotation and time at rest of each friction."""
    return np.array([solver(x) for x in mu.tolist()]).T


def alone(law: str, tolerance: float) -> Callable[[Floats], Floats]:
    """Return a solver by heyoka's scalar class."""
    system = equations(law)
    standstill = hy.t_event(system[1][0], direction=hy.event_direction.negative)
    integrator = hy.taylor_adaptive(
        system, [0.0, 0.0], pars=[0.0], tol=tolerance, t_events=[standstill], fast_math=True
    )
    state, parameters = integrator.state, integrator.pars

    def solver(mu: float) -> tuple[float, float]:
        integrator.time = 0.0
        integrator.reset_cooldowns()
        state[:] = 0.0
        parameters[0] = mu
        integrator.propagate_until(LATEST)
        return state[0], integrator.time

    return partial(one_by_one, solver)


def by_scipy(method: str, law: str, tolerance: float) -> Callable[[Floats], Floats]:
    """Return a solver by a method of SciPy's `solve_ivp`."""

    def solver(mu: float) -> tuple[float, float]:
        def slope(t: float, state: Floats) -> tuple[float, float]:
            phi, omega = state.tolist()
            return omega, acceleration(law, mu, phi, omega, math)

        def standstill(t: float, state: Floats) -> float:
            return float(state[1]) if t else 1.0

        standstill.terminal, standstill.direction = True, -1  # type: ignore[attr-defined]
        found = solve_ivp(slope, (0.0, LATEST), [0.0, 0.0], method, None, events=standstill,
                          rtol=max(tolerance, 1e-13), atol=1e-3 * tolerance)  # fmt: skip
        return found.y[0, -1], found.t[-1]

    return partial(one_by_one, solver)
