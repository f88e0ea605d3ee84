"""Newmark's sliding block, integrated exactly, and records that shake it."""

import math
from typing import Any

import mpmath as mp
import numpy as np

from slipcircle import Arc
from slipcircle.tables import Series

GRAVITY = 9.81
ARC = Arc(60.0, math.radians(220.0), math.radians(290.0), 19e3)
MU = math.tan(math.radians(20.0))


def quake(seed: int, samples: int = 500, step: float = 0.01) -> Series:
    """Noise of about 2.5 Hz that swells and fades; 0.35 g at most."""
    time = np.asarray(step * np.arange(samples), dtype=np.float64)
    swing = np.exp(-time[:80] / 0.15) * np.sin(5.0 * np.pi * time[:80])
    noise = np.convolve(np.random.default_rng(seed).normal(size=samples), swing)[:samples]
    values = noise * time * np.exp(-time)
    return Series(time, 0.35 * values / np.abs(values).max(), held=False)


def exactly(time: Any, rates: Any, tail: float) -> tuple[list[Any], list[Any], Any]:
    """Rotation and speed at the samples, and the last stop, of a one-way block with straight lines of acceleration.

    In mpmath, segment by segment: each is cut where the acceleration passes zero; ``tail`` acts after the last sample.
    """
    x, v, stop = mp.mpf(0), mp.mpf(0), mp.mpf(0)
    xs, vs = [x], [v]

    def follow(a: Any, b: Any, h: Any, since: Any) -> None:
        """Integrate over a time in which the acceleration changes linearly from a to b without a change of sign."""
        nonlocal x, v, stop
        bend = (b - a) / h
        if v + (a + b) / 2 * h >= 0:
            x, v = x + v * h + (2 * a + b) * h * h / 6, v + (a + b) / 2 * h
            return
        if v > 0:
            s = (-a - mp.sqrt(a * a - 2 * bend * v)) / bend if bend else -v / a
            s = s if 0 <= s <= h else (-a + mp.sqrt(a * a - 2 * bend * v)) / bend
            x, stop = x + v * s + a * s * s / 2 + bend * s**3 / 6, since + s
        v = mp.mpf(0)

    knots, a = [mp.mpf(float(t)) for t in time], [mp.mpf(float(r)) if isinstance(r, float) else r for r in rates]
    for k in range(len(knots) - 1):
        h = knots[k + 1] - knots[k]
        if a[k] * a[k + 1] < 0:
            s = h * a[k] / (a[k] - a[k + 1])
            follow(a[k], mp.mpf(0), s, knots[k])
            follow(mp.mpf(0), a[k + 1], h - s, knots[k] + s)
        else:
            follow(a[k], a[k + 1], h, knots[k])
        xs.append(x)
        vs.append(v)
    if v > 0:
        follow(mp.mpf(tail), mp.mpf(tail), 2 * v / -mp.mpf(tail), knots[-1])
    return [*xs, x], vs, stop


def factor(arc: Arc = ARC, mu: float = MU) -> tuple[float, float]:
    """Gamma and k_y by their definitions (design of (3.11)), from the amplitudes of the weights."""
    weight, radial = (float(x) for x in arc.amplitudes_per_inertia)
    psi = abs(float(arc.dip))
    gamma = weight * math.cos(psi) + mu * radial * math.sin(psi)
    return gamma, (mu * radial * math.cos(psi) - weight * math.sin(psi)) / gamma


def series(time: Any, values: Any) -> Series:
    return Series(np.asarray(time, dtype=float), np.asarray(values, dtype=float), held=False)


def of_block(record: Series, mu: float = MU) -> tuple[Any, Any, float]:
    """Displacements and speeds of the block at the samples, and the time of its last stop."""
    gamma, n = factor(mu=mu)
    with mp.workdps(30):
        unit = mp.mpf(gamma) * GRAVITY
        xs, vs, stop = exactly(record.time, [unit * (mp.mpf(k) - n) for k in record.values.tolist()], -unit * n)
    return np.array(xs, dtype=float), np.array(vs, dtype=float), float(stop)
