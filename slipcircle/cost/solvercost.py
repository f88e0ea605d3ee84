"""What solving scenes costs: this package at each accuracy beside solve_ivp and heyoka, judged against 40 digits."""

import itertools
import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial
from importlib.util import find_spec
from types import SimpleNamespace
from typing import Any, NamedTuple, TextIO

import numpy as np

from generated import _compiled, kernels
from slipcircle.cost.reference import Floats
from slipcircle.cost.ways import closed, multiprecision
from slipcircle.scene import arc

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12)


def _of_slip(mu: Any) -> dict[str, Any]:
    return {"law": "exponential", "peak": mu, "residual": mu, "length": 1.0}


def _of_speed(mu: Any) -> dict[str, Any]:
    return {"law": "rate_weakening", "peak": mu, "residual": mu, "velocity": 1.0}


SOLVERS: dict[str, tuple[str, Callable[[Any], Any] | None]] = {
    "closed form in time": ("vaiont-frozen", None),
    "closed form in the phase plane": ("vaiont", None),
    # The same scene, its friction given as a law of slip or of speed that does not change, so its solution is known.
    "energy equation": ("vaiont", _of_slip),
    "integration in time": ("vaiont", _of_speed),
}
NEW, NEW_NUMPY = (f"slipcircle, 1e-09, new arc{which}" for which in ("", ", NumPy kernels"))
FEWEST = 20  # scenes of an ensemble that are measured where they are slow
_SEEN = 5  # scenes of it whose errors are known
Answer = tuple[float, float, float]  # run-out, peak velocity and duration


class Way(NamedTuple):
    """A way to solve one scene, and many of the same arc by their friction coefficients: answers (3, n)."""

    one: Callable[[], Answer]
    many: Callable[[Floats], Floats] | None = None


def frictions(count: int) -> Floats:
    """Friction coefficients of an ensemble: around 10 deg, from 8 to 12."""
    return np.tan(np.radians(np.linspace(8.0, 12.0, count)))


def solutions(name: str, progress: TextIO | None = None) -> tuple[dict[str, Way], Answer, tuple[Floats, Floats]]:
    """Ways to solve a scene, ours named "slipcircle, accuracy"; its answer; and some frictions with theirs, (3, n).

    SciPy's solve_ivp and heyoka get a hand-written right-hand side and events, and scenes one after the other.
    """
    from slipcircle import Scene, solve

    shipped, law = SOLVERS[name]
    scene = Scene.load(shipped)
    mu = float(np.asarray(scene.friction))

    def given(mu: Any) -> Any:
        return mu if law is None else law(mu)

    def ours(accuracy: float, scene: Scene) -> Answer:
        motion = solve(scene, accuracy)
        return motion.run_out, float(motion.peak.velocity), motion.duration

    def ours_of(accuracy: float, mu: Floats) -> Floats:
        motions = solve(replace(scene, friction=given(mu)), accuracy)
        return np.array([motions.run_out, motions.peak.velocity, motions.duration])

    single = replace(scene, friction=given(mu))
    found = {f"slipcircle, {a:.0e}": Way(partial(ours, a, single), partial(ours_of, a)) for a in ACCURACIES}
    # A scene keeps the coefficients of its arc; what the kernels cost shows in a new one.
    new = lambda: ours(ACCURACIES[2], replace(single, arc=replace(scene.arc)))  # noqa: E731
    found[NEW] = Way(new)
    if _compiled.LEVEL != "numpy":
        found[NEW_NUMPY] = Way(lambda: _in_numpy(new))
    for module, methods in (("scipy", ("RK45", "DOP853", "LSODA")), ("heyoka", ("heyoka",))):
        if find_spec(module) is None:
            if progress:
                print(f"{module} is missing, and left out", file=progress)
            continue
        for method, a in itertools.product(methods, ACCURACIES):
            solver: Callable[[float], Answer] = (
                _heyoka(scene, a) if module == "heyoka" else partial(_integrated, scene, method, a)
            )
            many = None if method in ("RK45", "LSODA") else partial(_one_by_one, solver)  # the best of SciPy's
            found[f"{method}, {'tol' if method == 'heyoka' else 'rtol'} {a:.0e}"] = Way(partial(solver, mu), many)
    some = frictions(_SEEN)
    run_out, peak, time = map(float, _reference(scene, mu))
    exact = np.array([_reference(scene, x) for x in some.tolist()], dtype=np.float64).T
    return found, (run_out, peak, time), (some, exact)


def _one_by_one(solver: Callable[[float], Answer], mu: Floats) -> Floats:
    return np.array([solver(x) for x in mu.tolist()]).T


def _in_numpy(work: Callable[[], Answer]) -> Answer:
    """Work done with every kernel of alpha in NumPy instead of its compiled loop."""
    names, before = vars(arc), vars(arc)["kernels"]
    slow = {name: _compiled.kernel(name, texts, "numpy") for name, texts in vars(kernels)["TEXTS"].items()}
    names["kernels"] = SimpleNamespace(**(vars(kernels) | slow))
    try:
        return work()
    finally:
        names["kernels"] = before


class _Equation(NamedTuple):
    """d(omega)/dt = weight sin psi - mu (radial cos psi + polar omega**2), psi = dip - phi; scales; latest time."""

    weight: float
    radial: float
    polar: float
    dip: float
    turns: bool
    scale: float
    radius: float
    end: float


def _equation(scene: Any) -> _Equation:
    section, scale = scene.arc, float(scene.arc.time_scale)
    weight, radial = (float(x) for x in section.amplitudes_per_inertia)
    polar, end = (
        float(section.dimensionless.polar_moment_per_inertia),
        scene.end_time / scale if scene.end_time else 1e3,
    )
    turns = "rotation" in scene.called
    return _Equation(weight, radial, polar, float(section.dip), turns, scale, float(section.radius), end)


def _integrated(scene: Any, method: str, tolerance: float, mu: float) -> Answer:
    """Run-out, peak velocity and duration by solve_ivp, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    weight, radial, polar, dip, turns, scale, radius, end = _equation(scene)

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
    found = solve_ivp(rate, (0.0, end), (0.0, 0.0), method, rtol=tolerance, atol=tolerance * 1e-3, events=events)
    peak = found.y_events[1][0][1] if len(found.y_events[1]) else found.y[1, -1]
    return radius * found.y[0, -1], radius * peak / scale, found.t[-1] * scale


@cache
def _taylor(of: _Equation, tolerance: float) -> tuple[Any, list[float]]:
    """Heyoka's integrator, compiled once, with mu as its parameter; and where it leaves the peak speed."""
    import heyoka as hy  # type: ignore[import-not-found, unused-ignore]

    phi, omega = hy.make_vars("phi", "omega")
    psi = of.dip - phi if of.turns else hy.expression(of.dip)
    rate = of.weight * hy.sin(psi) - hy.par[0] * (of.radial * hy.cos(psi) + of.polar * omega * omega)
    peak = [0.0]

    def at_peak(integrator: Any, time: float, _: int) -> None:
        integrator.update_d_output(time)
        peak[0] = float(integrator.d_output[1])

    falls = hy.event_direction.negative
    found = hy.taylor_adaptive(
        [(phi, omega), (omega, rate)], [0.0, 0.0], pars=[0.0], tol=tolerance,
        t_events=[hy.t_event(omega, direction=falls)], nt_events=[hy.nt_event(rate, at_peak, direction=falls)],
    )  # fmt: skip
    return found, peak


def _heyoka(scene: Any, tolerance: float) -> Callable[[float], Answer]:
    """Run-out, peak velocity and duration by heyoka's Taylor series, with events for the peak and the standstill."""
    of = _equation(scene)
    system, peak = _taylor(of, tolerance)

    def solved(mu: float) -> Answer:
        system.time, system.state[:], system.pars[0], peak[0] = 0.0, 0.0, mu, 0.0
        system.reset_cooldowns()
        system.propagate_until(of.end)
        phi, omega = system.state.tolist()
        return of.radius * phi, of.radius * max(peak[0], omega) / of.scale, system.time * of.scale

    return solved


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
