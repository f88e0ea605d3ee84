"""How ensembles scale, measured here and forecast for many machines.

`python -m tests.campaigns.scale_ensemble [SAMPLES]` needs the extras `scenes` and `dask`. Seconds are of the clock, and
say little where others use the machine; a block's seconds and what an engine takes of this process for each, the
scheduler's part included, are of the processor.
"""

import os
import sys
import time
from concurrent.futures import Executor
from contextlib import ExitStack
from dataclasses import replace

from slipcircle import ensemble, load
from slipcircle.workbench.outputs.info import machine
from slipcircle.workbench.studies.engines import engine, forecast

ANGLE = {"distribution": "normal", "mean": 10, "std": 1}
SIZE, LARGE = 65536, 262144  # samples of a block
BLOCKS = 400  # small ones, for the engine's own time
REGION = 10**9
# Free memory that a worker keeps. By Dask's own setting of 64 KiB it gives back what is more, and faults it in again.
TRIM = "MALLOC_TRIM_THRESHOLD_"
SCENE = replace(load("vaiont"), uncertain={"friction.angle_deg": ANGLE})


def run(pool: Executor | None, n: int, size: int) -> tuple[float, float]:
    """Seconds of the clock, and of this process."""
    clock, processor = time.perf_counter(), time.process_time()
    ensemble(SCENE, n, 1, pool, size=size, keep=False)
    return time.perf_counter() - clock, time.process_time() - processor


def main(samples: int) -> None:
    from distributed import LocalCluster

    print(f"{machine()}, {os.cpu_count()} processors; load at the start {os.getloadavg()[0]:.1f}")
    print(f"{'engine':16} {'s':>7} {'us a scene':>11} {'speed-up':>9} {'of this process, ms a block':>28}")
    serial = own = 0.0
    blocks: dict[int, float] = {}  # seconds of the processor, by size
    for name, workers in (("threads", 1), ("threads", 2), ("dask", 2), ("dask, tuned", 2)):
        with ExitStack() as stack:
            address = None
            if name.startswith("dask"):  # its scheduler is a thread of this process
                os.environ[TRIM] = str(2**16 if name == "dask" else 2**28)
                cluster = stack.enter_context(
                    LocalCluster(n_workers=workers, threads_per_worker=1, host="127.0.0.1", dashboard_address=":0")
                )
                address = cluster.scheduler_address
            pool = stack.enter_context(engine(name.partition(",")[0], None if address else workers, address))
            run(pool, 4 * SIZE, SIZE)  # so that workers have started
            clock, processor = run(pool, samples, SIZE)
            if workers == 1:
                serial = clock
                blocks = {SIZE: processor / samples * SIZE, LARGE: run(pool, samples, LARGE)[1] / samples * LARGE}
            own = run(pool, BLOCKS * 1024, 1024)[1] / BLOCKS
            said = f"{own * 1e3:28.2f}" if address else f"{'-':>28}"
            print(f"{f'{name} ({workers})':16} {clock:7.2f} {clock / samples * 1e6:11.3f} {serial / clock:9.2f} {said}")
    for size, each in blocks.items():
        count = -(-REGION // size)
        forecasts = ", ".join(f"{w}: {forecast(count, each, own, w):.0f} s" for w in (1, 10, 100, 1000))
        print(f"{REGION:.0e} scenes on Dask, {count} blocks of {each * 1e3:.0f} ms and {own * 1e3:.1f} ms here, on "
              f"workers {forecasts}; it stops scaling at about {each / own:.0f}")  # fmt: skip
    print("From there on the scheduler and this process take the time, which hand blocks out one after the other.")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 4_000_000)
