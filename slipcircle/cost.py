"""What accuracy costs in time: each way to compute a function, its worst error seen, and its time, measured here.

Ratios within one run mean something; absolute times belong to the machine that the report names.
"""

import math
import platform
import statistics
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from generated import kernels, motion, printed

Floats = NDArray[np.float64]

ELEMENTS = 10_000  # an array that stays in cache
GAUSS_POINTS = (4, 8, 16, 32, 64)
MP_DIGITS = (30, 50)
REFERENCE_DIGITS = 50
COLUMNS = ("way", "worst relative error", "seen at", "time", "times ours", "verdict")
OURS = ("stable form", "slipcircle, 1e-09")  # ways that the others are compared with
BEATEN = 1.2  # a way is beaten by one at least as accurate and more than this many times faster


@dataclass(frozen=True)
class Row:
    """One way to compute one function: worst relative error seen, where, median time, and the verdict."""

    function: str
    way: str
    error: float
    worst_input: tuple[float, ...]
    nanoseconds: float
    verdict: str


@dataclass(frozen=True)
class Subject:
    """A function to be priced: NumPy ways by name, mpmath's formula, and the reference, all of scalars or columns."""

    ways: dict[str, Callable[..., Any]]
    mp: Callable[..., Any]  # mp(context, *args), the closed form
    reference: Callable[..., Any]  # reference(context, *args), at the context's digits
    points: Floats  # one row per argument
    bulk: Floats


def gauss_legendre(power: int, turned: bool, count: int, alpha: Floats) -> Floats:
    """The double integral of r**power (times cos u) by count Gauss-Legendre points in u; exact in r.

    The depth of the chord is written as a product, so that the rule and not the cancellation is measured.
    """
    x, w = np.polynomial.legendre.leggauss(count)
    u = alpha[:, None] * (x + 1) / 2
    depth = 2 * np.sin((alpha[:, None] - u) / 2) * np.sin((alpha[:, None] + u) / 2) / np.cos(u)
    near, far = 1 - depth * (1 - 1 / np.sqrt(3)) / 2, 1 - depth * (1 + 1 / np.sqrt(3)) / 2
    ring = depth / 2 * (near**power + far**power) * (np.cos(u) if turned else 1.0)
    return np.asarray(alpha * (ring @ w))


def _quadrature(power: int, turned: bool, mp: Any, alpha: Any) -> Any:
    """The same integral by mpmath's adaptive quadrature, from the definition."""

    def ring(u: Any) -> Any:
        chord = mp.cos(alpha) / mp.cos(u)
        return (1 - chord ** (power + 1)) / (power + 1) * (mp.cos(u) if turned else 1)

    return 2 * mp.quad(ring, [0, alpha])


def _polar(mp: Any, x: Any) -> Any:
    return (2 * x - mp.sin(2 * x) / 2 - mp.log(mp.tan(mp.pi / 4 + x / 2)) * mp.cos(x) ** 3) / 3


def _factor(mp: Any, x: Any) -> Any:
    return 2 * x * (1 - mp.cos(x))


def _y(mp: Any, a: Any, b: Any, t: Any) -> Any:
    return mp.cosh(mp.sqrt(a * b) * t)


_CLOSED: dict[str, tuple[Callable[..., Any], Callable[..., Any], tuple[int, bool] | None]] = {
    "polar_moment": (_polar, partial(_quadrature, 2, None), (2, False)),
    "moment_of_inertia": (
        lambda mp, x: (x - mp.sin(2 * x) * (1 + 2 * mp.cos(x) ** 2) / 6) / 2,
        partial(_quadrature, 3, None), (3, False)),
    "radial_weight_amplitude": (
        lambda mp, x: mp.sin(x) - mp.cos(x) ** 2 * mp.atanh(mp.sin(x)), partial(_quadrature, 1, True), (1, True)),
    "weight_moment_amplitude": (lambda mp, x: 2 * mp.sin(x) ** 3 / 3, partial(_quadrature, 2, True), (2, True)),
    "resistance_factor": (_factor, _factor, None),
    "dynamic_coefficient": (
        lambda mp, x: _polar(mp, x) / _factor(mp, x),
        lambda mp, x: _quadrature(2, False, mp, x) / _factor(mp, x), None),
}  # fmt: skip


def _kernel(name: str) -> Subject:
    closed, reference, gauss = _CLOSED[name]
    points = np.unique(np.concatenate([np.geomspace(1e-8, 1.0, 17), np.linspace(0.05, 1.55, 16), [np.pi / 2]]))
    bulk = np.random.default_rng(0).uniform(0.0, np.pi / 2, ELEMENTS)
    ways: dict[str, Callable[..., Any]] = {
        "printed form": getattr(printed, name),
        "stable form": getattr(kernels, name),
    }
    if gauss:
        ways |= {f"Gauss, {n} points": partial(gauss_legendre, *gauss, n) for n in GAUSS_POINTS}
    return Subject(ways, closed, reference, points[None], bulk[None])


def _motion(name: str, closed: Callable[..., Any]) -> Subject:
    rng = np.random.default_rng(0)
    points = np.array([[0.24, 0.19, 1e-8], [0.24, 0.19, 1e-4], [0.24, 0.19, 2.4], [0.24, 1e-12, 2.4],
                       [0.24, 0.19, 100.0], [0.24, 0.19, 1e4], [1e-12, 0.19, 2.4]]).T  # fmt: skip
    bulk = rng.uniform(0.1, 2.0, (3, ELEMENTS))
    stable = getattr(motion, f"frozen_centripetal_{name}")
    ways = {"printed form": getattr(printed, name), "stable form": lambda a, b, t: stable(a, b, 0.0, t)}
    return Subject(ways, closed, closed, points, bulk)


FUNCTIONS: Mapping[str, Callable[[], Subject]] = {name: partial(_kernel, name) for name in _CLOSED} | {
    "angular_velocity": partial(
        _motion, "angular_velocity", lambda mp, a, b, t: mp.sqrt(a / b) * mp.tanh(mp.sqrt(a * b) * t)
    ),
    "rotation": partial(_motion, "rotation", lambda mp, a, b, t: mp.log(_y(mp, a, b, t)) / b),
}


def measure(names: Sequence[str], progress: TextIO | None = None) -> list[Row]:
    """Measure every way to compute the named functions.

    Parameters
    ----------
    names : sequence of str
        Keys of `FUNCTIONS` or `SOLVERS`.
    progress : text file, optional
        Where to say what is being measured.

    Raises
    ------
    ValueError
        For an unknown function.
    ImportError
        Without mpmath, which gives the reference.
    """
    known = {**FUNCTIONS, **SOLVERS}
    unknown = [n for n in names if n not in known]
    if unknown:
        raise ValueError(f"function {unknown[0]!r} is unknown; known are {', '.join(known)}")
    try:
        import mpmath
    except ImportError as error:
        raise ImportError("the reference needs mpmath: pip install 'slipcircle[derive]'") from error
    found = []
    for name in names:
        if progress:
            print(f"measuring {name}", file=progress, flush=True)
        rows = _solved(name, mpmath, progress) if name in SOLVERS else _measure_one(name, FUNCTIONS[name](), mpmath)
        found += _judged(rows)
    return found


def _measure_one(name: str, subject: Subject, mpmath: Any) -> list[Row]:
    mp = mpmath.mp.clone()
    mp.dps = REFERENCE_DIGITS + 40  # quadrature loses what thin arcs cancel
    exact = [subject.reference(mp, *map(mp.mpf, p)) for p in subject.points.T.tolist()]
    rows = []
    for way, function in subject.ways.items():
        values = np.asarray(function(*subject.points), dtype=np.float64).tolist()
        took = _time(partial(function, *subject.bulk), ELEMENTS)
        rows.append(_row(name, way, subject, [mp.mpf(v) for v in values], exact, took))
    for digits in MP_DIGITS:
        at = mpmath.mp.clone()
        at.dps = digits
        few = [tuple(map(at.mpf, p)) for p in subject.bulk.T[:40].tolist()]

        def work(at: Any = at, few: Any = few) -> None:
            for p in few:
                subject.mp(at, *p)

        values = [mp.mpf(subject.mp(at, *map(at.mpf, p))) for p in subject.points.T.tolist()]
        rows.append(_row(name, f"mpmath, {digits} digits", subject, values, exact, _time(work, len(few))))
    return rows


# --- solvers: one scene, to its run-out, peak velocity and duration

ACCURACIES = (1e-3, 1e-6, 1e-9, 1e-12)


def _of_slip(mu: float) -> Callable[[Any], Any]:
    return lambda slip: mu + 0.0 * slip


def _of_speed(mu: float) -> dict[str, Any]:
    return {"law": "rate_weakening", "peak": mu, "residual": mu, "velocity": 1.0}


SOLVERS: Mapping[str, tuple[str, Callable[[float], Any] | None]] = {
    "closed form in time": ("vaiont-frozen", None),
    "closed form in the phase plane": ("vaiont", None),
    # The same scene, its friction given as a law of slip or of speed that does not change, so its solution is known.
    "energy equation": ("vaiont", _of_slip),
    "integration in time": ("vaiont", _of_speed),
}


def _solved(name: str, mpmath: Any, progress: TextIO | None) -> list[Row]:
    """This package at each accuracy, beside SciPy's solve_ivp with a hand-written right-hand side and events."""
    from slipcircle import Scene, solve

    shipped, friction = SOLVERS[name]
    scene = Scene.load(shipped)
    mu = float(np.asarray(scene.friction))
    if friction is not None:
        scene = replace(scene, friction=friction(mu))
    exact = _reference(scene, mu, mpmath)

    def row(way: str, work: Callable[[], tuple[float, float, float]]) -> Row:
        errors = [abs(v / float(e) - 1) if e else abs(v) for v, e in zip(work(), exact, strict=True)]
        return Row(name, way, max(errors), (), _time(work, 1, repeats=15), "")

    def ours(accuracy: float) -> tuple[float, float, float]:
        motion = solve(scene, accuracy)
        return motion.run_out, float(motion.peak.velocity), motion.duration

    rows = [row(f"slipcircle, {accuracy:.0e}", partial(ours, accuracy)) for accuracy in ACCURACIES]
    try:
        import scipy.integrate  # noqa: F401
    except ImportError:
        if progress:
            print("solve_ivp is missing: pip install 'slipcircle[scenes]'", file=progress)
        return rows
    for method in ("RK45", "DOP853", "LSODA"):
        rows += [row(f"{method}, rtol {a:.0e}", partial(_integrated, scene, mu, method, a)) for a in ACCURACIES]
    return rows


def _integrated(scene: Any, mu: float, method: str, tolerance: float) -> tuple[float, float, float]:
    """Run-out, peak velocity and duration by solve_ivp, with events for the peak and the standstill."""
    from scipy.integrate import solve_ivp

    arc, d = scene.arc, scene.arc.dimensionless
    scale, radius, dip = float(arc.time_scale), float(arc.radius), float(arc.dip)
    turns, polar = "rotation" in scene.called, float(d.polar_moment_per_inertia)
    weight, radial = (float(x) for x in arc.amplitudes_per_inertia)

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


def _reference(scene: Any, mu: float, mpmath: Any) -> tuple[Any, Any, Any]:
    """The same three numbers at 30 digits, with constant friction, by textbook formulas and adaptive quadrature."""
    mp = mpmath.mp.clone()
    mp.dps = 40
    arc = scene.arc
    alpha = (mp.mpf(float(arc.theta_2)) - mp.mpf(float(arc.theta_1))) / 2
    psi = 3 * mp.pi / 2 - (mp.mpf(float(arc.theta_2)) + mp.mpf(float(arc.theta_1))) / 2
    base = {n: _CLOSED[n][1](mp, alpha) for n in ("polar_moment", "moment_of_inertia", "radial_weight_amplitude",
                                                  "weight_moment_amplitude")}  # fmt: skip
    inertia = base["moment_of_inertia"]
    weight, radial = base["weight_moment_amplitude"] / inertia, mu * base["radial_weight_amplitude"] / inertia
    brake, radius = mu * base["polar_moment"] / inertia, mp.mpf(float(arc.radius))
    scale = mp.sqrt(radius / mp.mpf(float(arc.gravity)))
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


def _row(name: str, way: str, subject: Subject, values: Iterable[Any], exact: list[Any], nanoseconds: float) -> Row:
    errors = [float(abs(v - e) / abs(e)) if v == v else float("inf") for v, e in zip(values, exact, strict=True)]
    worst = int(np.argmax(errors))
    return Row(name, way, errors[worst], tuple(subject.points.T[worst].tolist()), nanoseconds, "")


def _time(work: Callable[[], object], elements: int, repeats: int = 7) -> float:
    """Median time of an element, ns, over repeats of at least a millisecond each."""
    work()
    start = time.perf_counter()
    work()
    loops = max(1, int(1e-3 / max(time.perf_counter() - start, 1e-9)))
    found = []
    for _ in range(repeats):
        start = time.perf_counter()
        for _ in range(loops):
            work()
        found.append((time.perf_counter() - start) / loops / elements * 1e9)
    return statistics.median(found)


def _judged(rows: list[Row]) -> list[Row]:
    """Mark the frontier: a way that another beats in time by more than `BEATEN` at no larger error names the winner."""
    judged = []
    for row in rows:
        better = [r for r in rows if r.error <= row.error and r.nanoseconds * BEATEN < row.nanoseconds]
        best = min(better, key=lambda r: r.nanoseconds, default=None)
        verdict = f"beaten: {best.way}" if best else "frontier"
        judged.append(Row(row.function, row.way, row.error, row.worst_input, row.nanoseconds, verdict))
    return judged


def _shown(nanoseconds: float) -> str:
    """A time of one element or one solution, with its unit."""
    scale, unit = next((s, u) for s, u in ((1e6, "ms"), (1e3, "us"), (1.0, "ns")) if nanoseconds >= s or s == 1.0)
    return f"{nanoseconds / scale:.3g} {unit}"


def cells(rows: Sequence[Row]) -> Iterable[list[str]]:
    """Rows of one function as text."""
    stable = next(r.nanoseconds for r in rows if r.way in OURS)
    for row in rows:
        at = ", ".join(f"{x:.3g}" for x in row.worst_input)
        ratio = f"{row.nanoseconds / stable:.2g}"
        yield [row.way, f"{row.error:.1e}", at, _shown(row.nanoseconds), ratio, row.verdict]


def machine() -> str:
    """Processor and versions, to stand beside the times."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            processor = next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        processor = platform.processor() or platform.machine()
    versions = f"Python {platform.python_version()}, NumPy {np.__version__}"
    return f"{processor}, {platform.system()}, {versions}; medians of 7 runs"
