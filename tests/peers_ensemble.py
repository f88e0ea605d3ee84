"""Ensembles beside other ways to solve them: ``python tests/peers_ensemble.py [--lanes N]`` prints a table.

Scenes of the arc of Vaiont, turning, with centripetal stress, friction angles from 9 to 22 deg; under laws of slip that
is where they start, to fall to 9 deg over a metre. Nanoseconds of one core's time a scene, the least of some
runs, and the worst true error over every 40th friction, by a Taylor series of the equation of motion to 30 digits
(`references`). heyoka is measured where it is installed; it and SciPy are asked for run-out and duration only, which
spares them the peak.
"""

import argparse
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np
import references
from numpy.typing import NDArray

from slipcircle import Scene, load, solve

Floats = NDArray[np.float64]
Ways = list[tuple[str, Callable[[], Callable[[Floats], Floats]], int, int]]
EFFECTS: dict[str, dict[str, float]] = {"rotation": {}, "centripetal": {}}
ARC = load("vaiont").arc
RESIDUAL = float(np.tan(np.radians(9.0)))
D = ARC.dimensionless
WEIGHT, RADIAL = (float(x) for x in ARC.amplitudes_per_inertia)
POLAR, DIP, SCALE, RADIUS = (
    float(D.polar_moment_per_inertia),
    float(ARC.dip),
    float(ARC.time_scale),
    float(np.asarray(ARC.radius)),
)


def friction(mu: Any, law: str) -> Any:
    return mu if law == "constant" else {"law": law, "peak": mu, "residual": RESIDUAL, "length": 1.0}


def reference(mu: float, law: str, effects: Mapping[str, Any]) -> tuple[float, float, float]:
    """Duration, run-out and peak velocity."""
    arc = {n: float(getattr(ARC, n)) for n in ("radius", "theta_1", "theta_2", "unit_weight", "gravity")}
    scene = {"arc": arc, "friction": friction(mu, law), "effects": effects, "initial_velocity": 0.0, "end_time": None}
    found = references.solve(scene, [])
    return float(found["duration"]), float(found["run_out"]), abs(float(found["peak_velocity"]))


def ours(accuracy: float, law: str = "constant", effects: Mapping[str, Any] = EFFECTS) -> Callable[[Floats], Floats]:
    def run(mu: Floats) -> Floats:
        found = solve(Scene(ARC, friction(mu, law), effects), accuracy)
        return np.array([found.duration, found.run_out, RADIUS * found.block.peak_angular_velocity])

    return run


def one_by_one(law: str, effects: Mapping[str, Any]) -> Callable[[Floats], Floats]:
    def run(mu: Floats) -> Floats:
        motions = (solve(Scene(ARC, friction(x, law), effects)) for x in mu.tolist())
        return np.array([(m.duration, m.run_out, m.peak.velocity) for m in motions]).T

    return run


def scipy(tolerance: float) -> Callable[[Floats], Floats]:
    from scipy.integrate import solve_ivp

    def one(mu: float) -> tuple[float, float, float]:
        def rate(_: float, y: Floats) -> list[float]:
            dip = DIP - y[0]
            resisted = mu * (RADIAL * np.cos(dip) + POLAR * y[1] * y[1])
            return [y[1], WEIGHT * np.sin(dip) - resisted]

        def rests(_: float, y: Floats) -> float:
            return float(y[1])

        vars(rests).update(terminal=True, direction=-1)
        found = solve_ivp(rate, (0.0, 1e3), [0.0, 0.0], "DOP853", rtol=tolerance, atol=1e-3 * tolerance, events=rests)
        return found.t[-1] * SCALE, found.y[0, -1] * RADIUS, np.nan

    return lambda mu: np.array([one(x) for x in mu.tolist()]).T


def heyoka(tolerance: float) -> Callable[[Floats], Floats]:
    import heyoka as hy  # type: ignore[import-not-found, unused-ignore]

    phi, omega = hy.make_vars("phi", "omega")
    mu, dip = hy.par[0], DIP - phi
    rate = WEIGHT * hy.sin(dip) - mu * (RADIAL * hy.cos(dip) + POLAR * omega * omega)
    rests = hy.t_event(omega, direction=hy.event_direction.negative)
    system = hy.taylor_adaptive([(phi, omega), (omega, rate)], [0.0, 0.0], pars=[0.0], tol=tolerance, t_events=[rests])

    def one(mu: float) -> tuple[float, float, float]:
        system.time = 0.0
        system.state[:] = 0.0
        system.pars[0] = mu
        system.reset_cooldowns()
        system.propagate_until(1e3)
        return system.time * SCALE, system.state[0] * RADIUS, np.nan

    return lambda mu: np.array([one(x) for x in mu.tolist()]).T


def measured(run: Callable[[Floats], Floats], mu: Floats, repeat: int) -> tuple[float, Floats]:
    """Nanoseconds a scene, and what came out."""
    found, best = run(mu), np.inf
    for _ in range(repeat):
        start = time.process_time()
        run(mu)
        best = min(best, time.process_time() - start)
    return best / len(mu) * 1e9, found


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--lanes", type=int, default=400_000, help="of the largest ensemble")
    most = parser.parse_args().lanes
    laws: list[tuple[str, Mapping[str, Any]]] = [
        *((law, EFFECTS) for law in ("constant", "exponential", "linear", "hyperbolic")),
        ("exponential", {"rotation": {}}),
    ]
    sample = np.tan(np.radians(np.linspace(9.0, 22.0, 40)))
    for law, effects in laws:
        exact = np.array([reference(x, law, effects) for x in sample.tolist()]).T
        print(f"{law} friction, {' and '.join(effects)}")
        compare(law, effects, sample, exact, most)


def compare(law: str, effects: Mapping[str, Any], sample: Floats, exact: Floats, most: int) -> None:
    constant = law == "constant"
    most = most if constant else most // 4
    ways: Ways = [
        *((f"solve(ensemble), accuracy {a:g}", partial(ours, a, law, effects), n, 5 if n <= 1e5 else 2)
          for a in (1e-6, 1e-9, 1e-12) for n in (1000, most)),
        ("solve, one by one", partial(one_by_one, law, effects), 200 if constant else 40, 2),
    ]  # fmt: skip
    peers: Ways = [
        *((f"heyoka, tolerance {t:g}", partial(heyoka, t), 4000, 3) for t in (1e-9, 1e-12)),
        *((f"SciPy DOP853, rtol {t:g}", partial(scipy, t), 40, 1) for t in (1e-9, 1e-11)),
    ]
    print(f"{'way':34} {'scenes':>9} {'ns a scene':>11} {'duration':>9} {'run-out':>9} {'peak':>9}")
    for name, make, lanes, repeat in [*ways, *(peers if constant else [])]:
        try:
            run = make()
        except ImportError:
            print(f"{name:34} is not installed")
            continue
        took, _ = measured(run, np.resize(sample, lanes), repeat)
        wrong: Any = np.abs(run(sample) / exact - 1.0).max(axis=1)
        print(f"{name:34} {lanes:9} {took:11.0f} " + " ".join(f"{x:9.1e}" for x in wrong))


if __name__ == "__main__":
    main()
