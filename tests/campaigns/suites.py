"""Suites of records: seconds and memory of a study, and the ratio to pySLAMMER for frozen rigid slopes.

`python -m tests.campaigns.suites [RECORDS]` writes RECORDS (50) records of 4,000 to 20,000 samples as tables and as AT2
into a folder that it removes, and solves them in both polarities at seven scales: a turning and softening section, and
a frozen slope, whose displacements are compared with those of an exact block. pySLAMMER is timed where it is installed
(pip install pyslammer).
"""

import os
import sys
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import mpmath as mp
import numpy as np

from slipcircle import Arc, Series, ensemble, load, read_suite
from slipcircle.workbench.outputs.info import machine
from slipcircle.workbench.records.suite import Suite
from slipcircle.workbench.studies.engines import engine
from tests.support.blocks import exactly, quake

SCALES = np.linspace(0.5, 2.0, 7)
SETTINGS: dict[str, Any] = {"polarities": True, "scales": SCALES}
SOFTENING = replace(load("shaken-slope"), name="turning, softening")
FROZEN = replace(load("newmark-pulse"), effects={}, name="frozen")
EVERY, EXACT = 5, 3  # record that the other program solves; of these, records of the exact block


def write(folder: Path, count: int) -> None:
    """Records as tables and as AT2, of 4,000 to 20,000 samples."""
    for k in range(count):
        record = quake(k, 4000 + 16000 * k // max(count - 1, 1), 0.005)
        values = record.values.tolist()
        if k % 2:
            head = f"synthetic\nnoise\nACCELERATION IN UNITS OF G\nNPTS= {len(values)}, DT= .0050 SEC\n"
            text = head + "".join(f"{value!r}\n" for value in values)
        else:
            rows = zip(record.time.tolist(), values, strict=True)
            text = "time (s),acceleration (g)\n" + "".join(f"{t!r},{a!r}\n" for t, a in rows)
        (folder / f"noise{k:03d}{'.AT2' if k % 2 else '.csv'}").write_text(text, "utf-8")


def timed(work: Callable[[], Any]) -> tuple[Any, float, float]:
    """A result, seconds of the clock, and of this process."""
    clock, processor = time.perf_counter(), time.process_time()
    result = work()
    return result, time.perf_counter() - clock, time.process_time() - processor


def studies(suite: Suite) -> None:
    """Seconds with one and two threads."""
    lanes = len(suite) * 2 * SCALES.size
    samples = sum(entry.samples for entry in suite)
    print(f"{len(suite)} records of {samples} samples in all, {lanes} motions")
    for scene in (SOFTENING, FROZEN):
        for workers in (1, 2):
            with engine("threads", workers) as pool:
                study, clock, processor = timed(partial(ensemble, scene, records=suite, executor=pool, **SETTINGS))
            moving = np.mean(study.displacement > 0.0)
            print(
                f"{scene.name:20} {workers} threads: {clock:6.2f} s of the clock, {processor:6.2f} s of the processor, "
                f"{1e9 * processor / (samples * 14):6.1f} ns a sample; {100 * moving:.0f} % move"
            )


def memory(suite: Suite) -> None:
    """Greatest memory of a study beyond what was there, by the number of records that are read when they are needed."""
    for count in (len(suite) // 4, len(suite)):
        part = replace(suite, entries=tuple(replace(entry, kept=None) for entry in suite.entries[-count:]))
        with engine("threads", 1) as pool:
            tracemalloc.start()
            ensemble(FROZEN, records=part, executor=pool, **SETTINGS)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
        print(f"{count:4d} records of up to 20,000 samples: {peak / 1e6:.1f} MB at most")


def against_the_block(suite: Suite) -> None:
    """The worst relative difference from an exact block, and the ratio to pySLAMMER in the same run."""
    entries = suite.entries[::EVERY]
    part = replace(suite, entries=entries)
    with engine("threads", 1) as pool:
        study, _, ours = timed(lambda: ensemble(FROZEN, records=part, executor=pool, **SETTINGS))
    assert isinstance(FROZEN.arc, Arc)
    weight, radial = (float(x) for x in FROZEN.arc.amplitudes_per_inertia)
    psi, mu = float(FROZEN.arc.dip), float(np.asarray(FROZEN.friction))
    gamma = weight * np.cos(psi) + mu * radial * np.sin(psi)
    k_y = (mu * radial * np.cos(psi) - weight * np.sin(psi)) / gamma
    worst = 0.0
    for r, entry in enumerate(entries[:EXACT]):
        exact = block(entry.record().scaled(2.0), gamma * 9.81, k_y)
        worst = max(worst, abs(study.displacement[r, 0, -1, 0] / exact - 1.0))
    print(f"frozen, {EXACT} records at scale 2: {worst:.1e} from the exact block at worst")
    if find_spec("pyslammer") is None:
        print("pySLAMMER is not installed: pip install pyslammer")
        return
    slammer = import_module("pyslammer")
    motions = [slammer.GroundMotion(entry.record().values, entry.step) for entry in entries]

    def peer() -> list[float]:
        rigid = slammer.RigidAnalysis
        signed = [sign * scale for sign in (1.0, -1.0) for scale in SCALES]
        return [rigid(k_y, motion, scale_factor=factor).max_sliding_disp for motion in motions for factor in signed]

    theirs, _, seconds = timed(peer)
    reached = np.array(theirs).reshape(len(entries), 2, -1)
    moved = study.displacement[..., 0] > 1e-3
    apart = np.abs(gamma * reached[moved] / study.displacement[..., 0][moved] - 1.0)
    print(
        f"{len(entries)} records: pySLAMMER {seconds:.2f} s, slipcircle {ours:.3f} s: {seconds / ours:.0f} times; "
        f"theirs differ by {100 * np.median(apart):.2g} % in the median, {100 * apart.max():.2g} % at most"
    )


def block(record: Series, unit: float, k_y: float) -> float:
    """Displacement of the exact block; unit is its acceleration at 1 g, m/s^2."""
    with mp.workdps(25):
        rates = [mp.mpf(unit) * (mp.mpf(k) - k_y) for k in record.values.tolist()]
        return float(exactly(record.time, rates, -unit * k_y)[0][-1])


def main(count: int) -> None:
    """Print all of them."""
    print(f"{machine()}, {os.cpu_count()} processors; load at the start {os.getloadavg()[0]:.1f}")
    with TemporaryDirectory() as name:
        write(Path(name), count)
        suite, clock, _ = timed(lambda: read_suite([name], holds="driving"))
        print(f"reading {len(suite)} files: {clock:.2f} s")
        studies(suite)
        memory(suite)
        against_the_block(suite)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 50)
