"""Processor time per sample of single motions under records of 10,000 to 3,000,000 samples.

``python -m tests.campaigns.long_records`` repeats one stretch of white noise, under which the mass starts and
arrests every few samples, so that every sample costs the same; it ends with status 1 if the time per sample of
one length exceeds 1.5 times that of another.
"""

import sys
import time
from collections.abc import Sequence

import numpy as np

from slipcircle import Arc, Record, Scene, solve

LENGTHS = (10_000, 30_000, 100_000, 300_000, 1_000_000, 3_000_000)
STRETCH, STEP, ALLOWED = 10_000, 0.005, 1.5


def record(samples: int) -> Record:
    """Return a record of white noise with a root mean square of 0.15 g."""
    noise = np.random.default_rng(57).normal(scale=0.15, size=STRETCH)
    return Record(np.resize(noise, samples), dt=STEP)


def nanoseconds(samples: int, repeats: int) -> float:
    """Return the least time per sample of some repeats, ns."""
    scene = Scene(Arc(100.0, 3.8, 4.8, 20e3), 0.5, {"shaking": {"horizontal": record(samples)}})
    times = []
    for _ in range(repeats):
        begun = time.process_time()
        motion = solve(scene)
        times.append(time.process_time() - begun)
    assert motion.arrested
    return 1e9 * min(times) / samples


def spread(lengths: Sequence[int]) -> tuple[list[float], float]:
    """Return the times per sample and the ratio of the greatest to the least."""
    times = [nanoseconds(n, max(3, min(9, 300_000 // n))) for n in lengths]
    return times, max(times) / min(times)


if __name__ == "__main__":
    nanoseconds(LENGTHS[0], 1)
    found, ratio = spread(LENGTHS)
    for n, took in zip(LENGTHS, found, strict=True):
        print(f"{n:>9,} samples: {took:6.0f} ns each")
    print(f"greatest over least: {ratio:.2f}, allowed {ALLOWED}")
    sys.exit(ratio > ALLOWED)
