"""Our ensembles and single scenes beside heyoka's Taylor integrator, each at its best setting.

``python -m tests.campaigns.heyoka`` needs heyoka: pip install heyoka. The slide of Vaiont, turning, with centripetal
pressure, under three laws of friction: 10,000 frictions on one core, then one. heyoka gets batches of 8, 16 and 32
neighbouring frictions, of which the fastest counts, AVX-512 where the processor has it, and no peak velocity, which
would take a call of Python from each lane; lanes that have not come to rest with the others of their batch run on.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, partial
from statistics import median
from typing import Any

import heyoka as hy  # type: ignore[import-not-found, import-untyped, unused-ignore]
import numpy as np
from numpy.typing import NDArray

from generated import kernels
from slipcircle import Scene, load, solve
from slipcircle.workbench.cost.rows import interleaved
from slipcircle.workbench.outputs.info import machine

Floats = NDArray[np.float64]
ACCURACY = 1e-9
COUNT = 10_000
BATCHES = (8, 16, 32)
LATEST = 1e3  # standstill, dimensionless
STANDING = 1e-13  # angular velocity below which a lane has come to rest
VAIONT: Scene[Any] = load("vaiont")
RESIDUAL = math.tan(math.radians(8.0))
LAWS: Mapping[str, Mapping[str, Any]] = {
    "constant": {},
    "exponential": {"law": "exponential", "residual": RESIDUAL, "length": 1.0},
    "rate": {"law": "rate_weakening", "residual": RESIDUAL, "velocity": 5.0},
}


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble, or that of one scene."""
    angles = np.linspace(10.0, 19.5, count) if count > 1 else np.array([14.0])
    return np.tan(np.radians(angles))


def scene(law: str, mu: Any) -> Scene[Any]:
    """The slide with a friction, or with many."""
    friction = {**LAWS[law], "peak": mu} if LAWS[law] else mu
    return replace(VAIONT, friction=friction)


one_scene = cache(scene)


def equation(law: str) -> list[tuple[Any, Any]]:
    """The equation of motion (3.11) with (2.20), written by hand over heyoka's expressions."""
    arc: Any = scene(law, 0.1).arc
    alpha = float(arc.half_angle)
    weight, radial, polar = (
        float(getattr(kernels, f"{name}_per_inertia")(alpha))
        for name in ("weight_moment", "radial_weight", "polar_moment")
    )
    phi, omega = hy.make_vars("phi", "omega")
    psi = float(arc.dip) - phi
    mu = hy.par[0]
    if law == "exponential":
        mu = RESIDUAL + (mu - RESIDUAL) * hy.exp(-float(arc.radius) / LAWS[law]["length"] * phi)
    if law == "rate":
        speed = float(arc.radius) / float(arc.time_scale)
        mu = RESIDUAL + (mu - RESIDUAL) / (1.0 + speed / LAWS[law]["velocity"] * omega)
    return [(phi, omega), (omega, weight * hy.sin(psi) - mu * (radial * hy.cos(psi) + polar * omega * omega))]


def in_batches(law: str, tolerance: float, lanes: int, wide: bool = True) -> Callable[[Floats], Floats]:
    """A function from frictions to rotation and time at rest, dimensionless, compiled for batches of so many lanes."""
    standstill = hy.t_event_batch(equation(law)[1][0], direction=hy.event_direction.negative)
    start = np.zeros((2, lanes))
    integrator = hy.taylor_adaptive_batch(
        equation(law),
        start,
        pars=np.zeros((1, lanes)),
        tol=tolerance,
        t_events=[standstill],
        force_avx512=wide,
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


def alone(law: str, tolerance: float) -> Callable[[Floats], Floats]:
    """The same for one friction at a time."""
    standstill = hy.t_event(equation(law)[1][0], direction=hy.event_direction.negative)
    integrator = hy.taylor_adaptive(
        equation(law), [0.0, 0.0], pars=[0.0], tol=tolerance, t_events=[standstill], fast_math=True
    )
    state, parameters = integrator.state, integrator.pars

    def run(mu: Floats) -> Floats:
        integrator.time = 0.0
        integrator.reset_cooldowns()
        state[:] = 0.0
        parameters[0] = mu[0]
        integrator.propagate_until(LATEST)
        return np.array([[state[0]], [integrator.time]])

    return run


def ours(law: str, tolerance: float, mu: Floats) -> Floats:
    """By this package, with the peak velocity."""
    solved = scene(law, mu) if mu.size > 1 else one_scene(law, float(mu[0]))
    outcomes = solve(solved, tolerance).outcomes
    _ = outcomes["peak_velocity"]
    units = float(np.asarray(solved.arc.radius)), float(np.asarray(solved.arc.time_scale))
    rows = [np.ravel(outcomes[name]) / unit for name, unit in zip(("run_out", "duration"), units, strict=True)]
    return np.array(rows)


def compare(law: str, count: int) -> None:
    """Print the times of both, and their largest errors against our 1e-15."""
    mu = frictions(count)
    exact = ours(law, 1e-15, mu)
    ways: dict[str, Callable[[Floats], Floats]] = {"ours": partial(ours, law, ACCURACY)}
    if count == 1:
        ways["heyoka"] = alone(law, ACCURACY)
    else:
        ways |= {f"heyoka, {lanes} lanes": in_batches(law, ACCURACY, lanes) for lanes in BATCHES}
    samples = interleaved([partial(way, mu) for way in ways.values()])
    seconds = dict(zip(ways, map(median, samples), strict=True))
    best = min(taken for name, taken in seconds.items() if name != "ours")
    for name, way in ways.items():
        error = float(np.max(np.abs(way(mu) / exact - 1)))
        print(f"{law:<12}{count:>6}  {name:<18}{1e6 * seconds[name] / count:>9.3f} us  error {error:.1e}")
    print(f"{law:<12}{count:>6}  ours takes {seconds['ours'] / best:.2f} times as long as heyoka at its best")


def main() -> None:
    """Print the comparison."""
    for count in (COUNT, 1):
        for law in LAWS:
            compare(law, count)
    print(f"medians of turns on one core, accuracy {ACCURACY:g}; {machine()}, heyoka {hy.__version__}")


if __name__ == "__main__":
    main()
