"""What solving a scene costs: this package at each accuracy beside SciPy's solve_ivp, judged against 40 digits."""

import itertools
import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from types import SimpleNamespace
from typing import Any, TextIO

import numpy as np

from generated import _compiled, kernels
from slipcircle import arc
from slipcircle.prices.ways import closed, multiprecision

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12)


def _of_slip(mu: float) -> Callable[[Any], Any]:
    return lambda slip: mu + 0.0 * slip


def _of_speed(mu: float) -> dict[str, Any]:
    return {"law": "rate_weakening", "peak": mu, "residual": mu, "velocity": 1.0}


SOLVERS: dict[str, tuple[str, Callable[[float], Any] | None]] = {
    "closed form in time": ("vaiont-frozen", None),
    "closed form in the phase plane": ("vaiont", None),
    # The same scene, its friction given as a law of slip or of speed that does not change, so its solution is known.
    "energy equation": ("vaiont", _of_slip),
    "integration in time": ("vaiont", _of_speed),
}
NEW, NEW_NUMPY = (f"slipcircle, 1e-09, new arc{which}" for which in ("", ", NumPy kernels"))
Answer = tuple[float, float, float]  # run-out, peak velocity and duration


def solutions(name: str, progress: TextIO | None = None) -> tuple[dict[str, Callable[[], Answer]], Answer]:
    """Ways to solve a scene, ours named "slipcircle, accuracy", and the answer to the nearest double.

    SciPy's solve_ivp gets a hand-written right-hand side and events.
    """
    from slipcircle import Scene, solve

    shipped, law = SOLVERS[name]
    scene = Scene.load(shipped)
    mu = float(np.asarray(scene.friction))
    if law is not None:
        scene = replace(scene, friction=law(mu))

    def ours(accuracy: float, scene: Scene = scene) -> Answer:
        motion = solve(scene, accuracy)
        return motion.run_out, float(motion.peak.velocity), motion.duration

    found: dict[str, Callable[[], Answer]] = {f"slipcircle, {a:.0e}": partial(ours, a) for a in ACCURACIES}
    # A scene keeps the coefficients of its arc; what the kernels cost shows in a new one.
    found[NEW] = new = lambda: ours(ACCURACIES[2], replace(scene, arc=replace(scene.arc)))
    if _compiled.LEVEL != "numpy":
        found[NEW_NUMPY] = lambda: _in_numpy(new)
    try:
        import scipy.integrate  # noqa: F401
    except ImportError:
        if progress:
            print("solve_ivp is missing: pip install 'slipcircle[scenes]'", file=progress)
    else:
        methods = itertools.product(("RK45", "DOP853", "LSODA"), ACCURACIES)
        found |= {f"{m}, rtol {a:.0e}": partial(_integrated, scene, mu, m, a) for m, a in methods}
    run_out, peak, time = map(float, _reference(scene, mu))
    return found, (run_out, peak, time)


def _in_numpy(work: Callable[[], Answer]) -> Answer:
    """Work done with every kernel of alpha in NumPy instead of its compiled loop."""
    names, before = vars(arc), vars(arc)["kernels"]
    slow = {name: _compiled.kernel(name, texts, "numpy") for name, texts in vars(kernels)["TEXTS"].items()}
    names["kernels"] = SimpleNamespace(**(vars(kernels) | slow))
    try:
        return work()
    finally:
        names["kernels"] = before


def _integrated(scene: Any, mu: float, method: str, tolerance: float) -> Answer:
    """Run-out, peak velocity and duration by solve_ivp, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    section, d = scene.arc, scene.arc.dimensionless
    scale, radius, dip = float(section.time_scale), float(section.radius), float(section.dip)
    turns, polar = "rotation" in scene.called, float(d.polar_moment_per_inertia)
    weight, radial = (float(x) for x in section.amplitudes_per_inertia)

    def rate(_: float, y: Any) -> tuple[float, float]:
        psi = dip - y[0] if turns else dip
        return y[1], weight * math.sin(psi) - mu * (radial * math.cos(psi) + polar * y[1] * y[1])

    def stands(_: float, y: Any) -> float:
        return float(y[1])

    def turns_slower(t: float, y: Any) -> float:
        return rate(t, y)[1]

    events: list[Any] = [stands, turns_slower]
    for event in events:
        event.terminal, event.direction = event is stands, -1.0
    end = scene.end_time / scale if scene.end_time else 1e3
    found = solve_ivp(rate, (0.0, end), (0.0, 0.0), method, rtol=tolerance, atol=tolerance * 1e-3, events=events)
    peak = found.y_events[1][0][1] if len(found.y_events[1]) else found.y[1, -1]
    return radius * found.y[0, -1], radius * peak / scale, found.t[-1] * scale


def _reference(scene: Any, mu: float) -> tuple[Any, Any, Any]:
    """The same three numbers at 30 digits, with constant friction, by textbook formulas and adaptive quadrature."""
    mp = multiprecision(40)
    section = scene.arc
    alpha = (mp.mpf(float(section.theta_2)) - mp.mpf(float(section.theta_1))) / 2
    psi = 3 * mp.pi / 2 - (mp.mpf(float(section.theta_2)) + mp.mpf(float(section.theta_1))) / 2
    base = {n: closed(n, mp, alpha) for n in ("polar_moment", "moment_of_inertia", "radial_weight_amplitude",
                                                  "weight_moment_amplitude")}  # fmt: skip
    inertia = base["moment_of_inertia"]
    weight, radial = base["weight_moment_amplitude"] / inertia, mu * base["radial_weight_amplitude"] / inertia
    brake, radius = mu * base["polar_moment"] / inertia, mp.mpf(float(section.radius))
    scale = mp.sqrt(radius / mp.mpf(float(section.gravity)))
    if "rotation" not in scene.called:
        drive, end = weight * mp.sin(psi) - radial * mp.cos(psi), mp.mpf(scene.end_time) / scale
        k = mp.sqrt(drive * brake)
        return (
            radius * mp.log(mp.cosh(k * end)) / brake,
            radius * mp.sqrt(drive / brake) * mp.tanh(k * end) / scale,
            end * scale,
        )
    q, length = 2 * brake, mp.hypot(weight, radial)
    tilted = psi - mp.atan(radial / weight)

    def steady(y: Any) -> Any:  # the solution of E' + q E = 2 K sin(y) that does not decay, y = tilted - phi
        return 2 * length * (q * mp.sin(y) + mp.cos(y)) / (1 + q * q)

    def energy(phi: Any) -> Any:
        return steady(tilted - phi) - steady(tilted) * mp.exp(-q * phi)

    end = mp.findroot(energy, 2 * tilted * (1 - q / 8))
    top = mp.findroot(lambda x: 2 * length * mp.sin(tilted - x) - q * energy(x), end / 2)
    pace = lambda s: end * mp.sin(2 * s) / mp.sqrt(energy(end * mp.sin(s) ** 2))  # noqa: E731
    time = mp.quad(pace, [0, mp.pi / 4, mp.pi / 2], method="gauss-legendre")
    return radius * end, radius * mp.sqrt(energy(top)) / scale, time * scale
