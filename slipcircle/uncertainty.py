"""Estimated error of a motion: rounding of each term, times what makes it grow, and what the series leave out."""

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from slipcircle.frozen import Frozen
from slipcircle.phaseplane import EPS, Course

if TYPE_CHECKING:
    from slipcircle.motion import Motion, Phase

ROUNDING = 4.0  # units in which a term is uncertain: kernels, products and sums
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class Part(NamedTuple):
    """What one phase adds, dimensionless and absolute: errors of its end in rotation and time, and of its speed.

    The greatest speed and its rate say what an error in time does at a given time.
    """

    rotation: float
    time: float
    speed: float
    top: float
    rate: float


def estimate(motion: "Motion") -> float:
    """The largest relative error of peak velocity, run-out and duration, and of the states at any time.

    States are relative to peak velocity and run-out. 1 where rounding decides whether the mass rests.
    """
    rotation = time = worst = 0.0
    radius, scale = float(motion.plan.scene.arc.radius), float(motion.plan.scene.arc.time_scale)
    run_out, peak = abs(float(motion.end.rotation)), abs(float(motion.peak.velocity)) / radius * scale
    for phase in motion.phases:
        # The dip of a turned mass is rounded, as a difference of angles.
        shift = rotation + (4 * EPS if phase.rotation else 0.0)
        solved = phase.solved
        part = _frozen(solved, phase) if isinstance(solved, Frozen) else _course(solved, phase, shift)
        time += part.time
        place, speed = rotation + part.rotation + part.top * time, part.speed + part.rate * time
        worst = max(worst, place / max(run_out, 1e-300), speed / max(peak, 1e-300))
        rotation += part.rotation
    if motion.phases:
        last = motion.phases[-1].end
        worst = max(worst, time / last if last > 0.0 else 0.0) + ROUNDING * EPS
    if motion.arrested and _undecided(motion, rotation):
        return 1.0
    return min(worst, 1.0)


def _undecided(motion: "Motion", shift: float) -> bool:
    """Whether the mass rests by less than the rounding of drive and resistance."""
    balance = motion.balance
    slip, at = 0.0, motion._start
    if motion.phases:
        last = motion.phases[-1]
        rotation = last.rotation + last.direction * last.solved.end
        side = -1 if balance.position(rotation, 1)["fall"] < 0.0 else 1
        slip, at = last.solved.start.slip + motion.radius * last.solved.end, balance.position(rotation, side)
    mu = float(motion.law.coefficient(slip))
    held = float(balance.get("resistance", **at, mu=mu, omega_2=0.0))
    noise = ROUNDING * EPS * (at["fall"] + mu * at["press"] + held)
    if balance.turns:
        noise += shift * (balance.weight + mu * balance.radial)
    return abs(at["fall"] - held) < noise


def _frozen(solved: Frozen, phase: "Phase") -> Part:
    """By the drive, a small difference near the limit, and the formulas' rounding."""
    unit, at, a = ROUNDING * EPS, solved.at, abs(solved.a)
    b = (*solved.coefficients, 0.0)[1]
    terms = abs(at["fall"]) + abs(solved.balance.get("constant", mu=solved.mu))
    terms += solved.mu * abs(solved.balance.get("normal", **at))
    elapsed = phase.end - phase.start
    omega_0 = solved.omega_0
    rate = a + b * omega_0**2
    if solved.stops and elapsed >= solved.duration:
        growth = unit * (1.0 + terms / a)
        return Part(growth * solved.end, growth * elapsed, unit * omega_0, omega_0, rate)
    # A brake forgets what happened longer ago than this.
    memory = min(elapsed, 1 / math.sqrt(a * b)) if a * b > 0.0 else elapsed
    x, energy, _ = solved.state(elapsed)
    top = max(omega_0, math.sqrt(energy))
    return Part(
        unit * (terms * memory * elapsed + x), unit * elapsed, unit * (terms * memory + top), top, rate
    )


def _course(solved: Course, phase: "Phase", shift: float) -> Part:
    """By the noise in E: its zero and its top move, and the time is the integral of E**-0.5.

    Rounding of E's terms is as large as their sum without signs; a start near the limit makes the drive a small
    difference, which this shows. ``shift``: the error in rotation at the start of the phase.
    """
    unit, at, balance, end = ROUNDING * EPS, solved.at, solved.balance, solved.end
    terms = abs(at["fall"]) + abs(solved.constant) + solved.mu * abs(balance.get("normal", **at))
    terms *= unit
    if balance.turns:
        terms += shift * (balance.weight + solved.mu * balance.radial)
    tilt, brake = unit * abs(solved.tilt), float(np.max(solved.braking(np.array([0.0, end]))))
    left_out = solved.unresolved
    elapsed = phase.end - phase.start
    whole = elapsed >= solved.duration

    def reach(x: np.ndarray) -> np.ndarray:  # a brake forgets what happened further back
        return np.minimum(x, 1 / (2 * brake)) if brake > 0.0 else x

    def noise(x: np.ndarray) -> np.ndarray:
        return 2 * terms * reach(x) + tilt * reach(x) * np.minimum(x, 1.0) + unit * solved.start.energy

    def energy(x: float) -> float:
        return max(solved._scalar(x), 0.0)

    rotation = 0.0
    steep = abs(float(solved.slope(end, 0.0)))
    if solved.stops and steep > 0.0:
        rotation = float(noise(np.array(end))) / steep + (unit + left_out) * end
    x_last = end if whole else solved.state(elapsed)[0]
    edges = solved.clock.edges
    if not whole:
        edges = np.append(edges[edges < solved._variable(x_last)], solved._variable(x_last))
    half = np.diff(edges) / 2
    x, left, stretch = solved._place((edges[:-1] + half)[:, None] + half[:, None] * _NODES)
    found = np.maximum(solved.speed_squared(x.ravel(), left.ravel()).reshape(x.shape), 1e-300)
    doubt = noise(x)
    if solved.stops:  # near the standstill E is integrated from there
        doubt = np.minimum(doubt, (2 * (terms + tilt * min(end, 1.0)) + abs(solved.tilt) * rotation) * left)
    doubt = np.minimum(doubt / found + left_out, 1.0)
    lasts = (stretch / np.sqrt(found)) * (half[:, None] * _WEIGHTS)
    time = float((lasts * doubt).sum()) / 2 + solved._times[2] + unit * elapsed
    summit = min(solved.peak, x_last)
    top = math.sqrt(energy(summit))
    speed = float(noise(np.array(summit))) / (2 * max(top, 1e-300)) + (unit + left_out) * top
    rate = float(np.abs(solved.slope(x, found)).max()) / 2
    return Part(rotation if whole else 0.0, time, speed, top, rate)
