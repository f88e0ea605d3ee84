"""Estimated error of a motion: rounding of each term, times what makes it grow, and what the series leave out."""

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slipcircle.checks import EPS
from slipcircle.friction import friction
from slipcircle.methods.frozen import Frozen
from slipcircle.methods.phaseplane import Course
from slipcircle.methods.stepping import Stepped
from slipcircle.plan import INTEGRATION, LINEAR_SYSTEM

Floats = NDArray[np.float64]

if TYPE_CHECKING:
    from slipcircle.motion import Motion, Phase

ROUNDING = 4.0  # units in which a term is uncertain: kernels, products and sums
_NUDGE = 32 * EPS  # of the weights, in the integrations that an estimate compares with
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class Doubt(NamedTuple):
    """Absolute errors, dimensionless, of where a phase begins or ends: rotation, accumulated slip, time, E."""

    rotation: float = 0.0
    slip: float = 0.0
    time: float = 0.0
    energy: float = 0.0


class Inside(NamedTuple):
    """Greatest errors in a phase of rotation and speed at a given time, the greatest speed and its rate.

    And the rounding of the dissipation over all energy: where water and the centripetal stress carry the mass, the
    resistance is a small difference.
    """

    rotation: float
    speed: float
    top: float
    rate: float
    lost: float


def estimate(motion: "Motion") -> tuple[float, float]:
    """The largest relative error of peak velocity, run-out and duration, and of the states at any time.

    States are relative to peak velocity and run-out. 1 where rounding decides whether the mass rests. And the error of
    the energy balance, relative to all energy.
    """
    if motion.plan.method in (INTEGRATION, LINEAR_SYSTEM):
        return _by_comparison(motion)
    radius, scale = float(np.asarray(motion.plan.scene.arc.radius)), float(motion.plan.scene.arc.time_scale)
    run_out, peak = abs(float(motion.end.rotation)), abs(float(motion.peak.velocity)) / radius * scale
    doubt, worst, lost = Doubt(), 0.0, 0.0
    for phase in motion.phases:
        before = doubt
        if isinstance(phase.solved, Frozen):
            doubt, inside = _frozen(phase.solved, phase, before)
        elif isinstance(phase.solved, Stepped):
            if phase.solved.undecided:
                return 1.0, 0.0
            doubt, inside = _stepped(phase.solved, before)
        elif isinstance(phase.solved, Course):
            doubt, inside = _course(phase.solved, phase, before)
        # An error in the time at which the phase begins moves all of it.
        place = max(before.rotation, doubt.rotation) + inside.rotation + inside.top * before.time
        speed = inside.speed + inside.rate * before.time
        worst = max(worst, place / max(run_out, 1e-300), speed / max(peak, 1e-300))
        lost = max(lost, inside.lost)
    if motion.moves:
        worst = max(worst, doubt.time / motion.phases[-1].end) + ROUNDING * EPS
    return 1.0 if motion.arrested and _undecided(motion, doubt) else min(worst, 1.0), min(lost, 1.0)


def _by_comparison(motion: "Motion") -> tuple[float, float]:
    """How far two coarser integrations lie off, whose weights are changed against each other by what rounding may do.

    Errors of the steps, and of the decisions in between, are larger in them than in the motion itself.
    """
    from slipcircle.solver import solve_one

    coarser = 10.0 if motion.plan.tolerance > 1e-13 else 3.0  # there rounding has its part in it
    times = np.linspace(0.0, motion.duration, 66)[1:-1]
    here, worst = motion.at(times), ROUNDING * EPS
    run_out, peak = max(abs(motion.run_out), 1e-300), max(abs(float(motion.peak.velocity)), 1e-300)
    for nudge in (_NUDGE, -_NUDGE):
        try:
            other = solve_one(motion.plan, coarser * motion.plan.tolerance, nudge)
            there = other.at(np.minimum(times, other.duration))
        except ValueError:
            return 1.0, 0.0
        if other.moves != motion.moves or other.arrested != motion.arrested:
            return 1.0, 0.0
        if motion.moves:
            worst = max(
                worst,
                abs(other.duration / motion.duration - 1.0),
                abs(float(other.peak.velocity) / float(motion.peak.velocity) - 1.0),
                abs(other.run_out - motion.run_out) / run_out,
                float(np.max(np.abs(there.displacement - here.displacement))) / run_out,
                float(np.max(np.abs(there.velocity - here.velocity))) / peak,
            )
    energy = motion.energy
    most = max(abs(float(energy.work)), float(energy.dissipation), float(energy.kinetic_end), 1e-300)
    lost = abs(float(energy.residual)) / most + ROUNDING * EPS
    return min(2 * worst + motion.plan.tolerance, 1.0), min(lost, 1.0)


def _stepped(solved: Stepped, before: Doubt) -> tuple[Doubt, Inside]:
    """By what the stepping knows of its own rounding."""
    turned, speed, time = solved.errors()
    summit = solved.fastest()
    top = max(solved.speed, abs(summit[2]) if summit else 0.0)
    inside = Inside(turned, speed, top, 0.0, ROUNDING * EPS)
    return Doubt(before.rotation + turned, before.slip + turned, before.time + time, 2 * solved.speed * speed), inside


def _undecided(motion: "Motion", doubt: Doubt) -> bool:
    """Whether the mass rests by less than the rounding of drive and resistance."""
    balance, rotation, slip = motion.balance, 0.0, 0.0
    if motion.phases:
        last = motion.phases[-1]
        rotation = last.rotation + last.direction * last.solved.end
        slip = last.solved.start.slip + float(np.asarray(motion.plan.scene.arc.radius)) * last.solved.end
    at = balance.position(rotation, -1 if balance.position(rotation, 1)["fall"] < 0.0 else 1)
    mu = float(friction(motion.plan.scene.friction).coefficient(slip))
    held = float(balance.get("resistance", **at, mu=mu, omega_2=0.0))
    noise = ROUNDING * EPS * (at["fall"] + mu * at["press"] + held)
    if balance.turns:
        noise += doubt.rotation * (balance.weight + mu * balance.radial)
    return abs(at["fall"] - held) < noise


def _frozen(solved: Frozen, phase: "Phase", before: Doubt) -> tuple[Doubt, Inside]:
    """By the drive, a small difference near the limit, and the formulas' rounding."""
    unit, at, a = ROUNDING * EPS, solved.at, abs(solved.a)
    b = solved.b
    terms = abs(at["fall"]) + abs(solved.balance.get("constant", mu=solved.mu))
    terms += solved.mu * abs(solved.balance.get("normal", **at))
    elapsed, omega_0 = phase.end - phase.start, solved.omega_0
    rate = a + b * omega_0**2
    x, omega, _ = solved.state(elapsed)
    top = max(omega_0, omega)
    lost = unit * (terms + b * top**2) * x / max(at["fall"] * x, top**2 / 2, 1e-300)
    if solved.stops and elapsed >= solved.duration - 8 * EPS * phase.end:
        growth = unit * (1.0 + terms / a)
        x = growth * solved.end + before.energy / (2 * a)
        time = growth * elapsed + before.energy / max(2 * a * omega_0, 1e-300)
        inside = Inside(omega_0 * time, unit * omega_0 + rate * time, omega_0, rate, lost)
        return Doubt(before.rotation + x, before.slip + x, before.time + time), inside
    # A brake forgets what happened longer ago than this.
    memory = min(elapsed, 1 / math.sqrt(a * b)) if a * b > 0.0 else elapsed
    speed = unit * (terms * memory + top + rate * elapsed)
    x = unit * (terms * memory * elapsed + x + top * elapsed)
    after = Doubt(before.rotation + x, before.slip + x, before.time, 2 * omega * speed)
    return after, Inside(x, speed, top, rate, lost)


def _course(solved: Course, phase: "Phase", before: Doubt) -> tuple[Doubt, Inside]:
    """By the noise in E: its zero and its top move, and the time is the integral of E**-0.5.

    Rounding of E's terms is as large as their sum without signs; a start near the limit makes the drive a small
    difference, which this shows.
    """
    unit, balance, end, law = ROUNDING * EPS, solved.balance, solved.end, solved.law
    carried = 1.0  # of an error in where the phase begins, at its end
    brakes = solved.braking(np.array([0.0, end]))
    steep = abs(float(solved.slope(end, 0.0)))
    shift = before.rotation
    if balance.turns:
        shift += 4 * EPS if phase.rotation else 0.0  # the dip of a turned mass is a rounded difference of angles
        if solved.stops:
            carried = 2 * abs(solved.drive) * math.exp(-2 * float(brakes.min()) * end) / steep
    steep_law, tilt = 0.0, abs(solved.tilt)
    if not solved.steady:
        step = 1e-6 * min(law.scale, solved.radius)
        steep_law = before.slip * solved.radius * abs(float(law.drop(solved.start.slip, step))) / step

    def moved(x: Any, shift: float) -> Any:
        """Rounding of the drive's terms, and what an error in the position makes of them."""
        x = 0.0 * x if solved.steady else x
        mu, normal = solved.friction(x), np.abs(balance.get("normal", press=solved.press(x)))
        constant = np.abs(balance.get("constant", mu=mu))
        turned = shift * (balance.weight + mu * balance.radial) if balance.turns else 0.0
        return unit * (np.abs(solved.fall(x)) + constant + mu * normal) + steep_law * normal + turned

    def noise(x: Any, shift: float) -> Any:
        # A brake forgets what is further back.
        back = np.minimum(x, 0.5 / np.maximum(solved.braking(x), 1e-300))
        kept = (unit * solved.start.energy + before.energy) * np.exp(-2 * float(brakes.min()) * x)
        return 2 * moved(x, shift) * back + unit * tilt * back * np.minimum(x, 1.0) + kept

    elapsed = phase.end - phase.start
    whole = elapsed >= solved.duration - 8 * EPS * phase.end
    own = 0.0
    if solved.stops:
        own = float(noise(end, 0.0)) / steep + (unit + solved.unresolved) * end
    last = end if whole else solved.state(elapsed)[0]
    edges = solved.clock.edges
    panel = min(int(np.searchsorted(edges, solved._variable(last))), len(edges) - 1)
    if not whole:
        edges = np.append(edges[:panel], solved._variable(last))
    half = np.diff(edges) / 2
    place = ((edges[:-1] + half)[:, None] + half[:, None] * _NODES).ravel()
    x, left, stretch = solved._place(place)
    energy = np.maximum(solved.speed_squared(x, left), 1e-300)
    error = noise(x, shift)
    if solved.stops:  # near the standstill E is integrated from there
        error = np.minimum(error, (2 * moved(x, shift) + (2 * unit + own + shift * carried) * tilt) * left)
    relative = np.minimum(error / energy + solved.unresolved, 1.0) / 2
    share = np.sqrt(energy)
    width = (half[:, None] * _WEIGHTS).ravel() * stretch
    passed = width / share
    time = np.cumsum(passed * relative) + (unit + solved._times[2] / solved.duration) * np.cumsum(passed)
    rates = np.abs(solved.slope(x, energy)) / 2
    summit = min(solved.peak, last)
    top = math.sqrt(max(solved._scalar(summit), 0.0))
    high = float(noise(summit, shift)) / (2 * max(top, 1e-300)) + (unit + solved.unresolved) * top
    resisting = np.abs(solved.fall(x)) + np.abs(solved.driving(x)) + solved.braking(x) * energy
    all_energy = np.maximum.accumulate(np.abs(solved.work(x)) + np.maximum(energy, solved.start.energy) / 2)
    lost = float((unit * np.cumsum(width * resisting) / all_energy).max())
    inside = Inside(float((time * share).max()), high + float((time * rates).max()), top, float(rates.max()), lost)
    if solved.stops and whole:
        after = Doubt(carried * shift + own, before.slip + own + shift * (1.0 + carried), before.time + float(time[-1]))
    else:  # it lifts off or lands, or its time is over
        after = Doubt(shift, before.slip + shift, before.time + float(time[-1]), float(noise(last, shift)))
    return after, inside
