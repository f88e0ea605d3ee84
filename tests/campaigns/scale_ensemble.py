"""Processor seconds of a block, and of this process for handing one out: what `engines.forecast` needs.

`python -m tests.campaigns.scale_ensemble` needs the extra `dask`.
"""

import time
from concurrent.futures import Executor
from dataclasses import replace

from slipcircle import ensemble, load
from slipcircle.workbench.studies.engines import engine

ANGLE = {"distribution": "normal", "mean": 10, "std": 1}
SCENE = replace(load("vaiont"), uncertain={"friction.angle_deg": ANGLE})
BLOCKS = 400


def seconds(pool: Executor, size: int, blocks: int) -> float:
    """Of this process, a block of so many samples."""
    start = time.process_time()
    ensemble(SCENE, blocks * size, 1, pool, size=size, keep=False)
    return (time.process_time() - start) / blocks


def main() -> None:
    for name, size, blocks in (("threads", 2**16, 16), ("threads", 2**18, 16), ("dask", 2**10, BLOCKS)):
        with engine(name, 1) as pool:
            seconds(pool, size, 4)  # so that workers have started
            print(f"{name}, {size} samples a block: {1e3 * seconds(pool, size, blocks):.2f} ms a block")


if __name__ == "__main__":
    main()
