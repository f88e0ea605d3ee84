"""Factors of safety at the start of a study's samples: added up with the motions, or computed when they are read."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from slipcircle.workbench.studies.design import Design, Result
from slipcircle.workbench.studies.engines import engine, run_blocks
from slipcircle.workbench.studies.tally import COUNTED, Tally


class Factors:
    """By method: how many are below 1 and how many are not known, (replicates, 2), and the `Tally` of the others."""

    def __init__(self, replicates: int) -> None:
        self.replicates = replicates
        self.counts: dict[str, NDArray[np.int64]] = {}
        self.tallies: dict[str, Tally] = {}

    def add(self, replicate: int, block: Result) -> None:
        """Add what a block has of them."""
        for name in block:
            if name.startswith("factor."):
                method = name.removeprefix("factor.")
                counts = self.counts.setdefault(method, np.zeros((self.replicates, 2), np.int64))
                counts[replicate] += block[name]
                tally = self.tallies.setdefault(method, Tally(self.replicates))
                tally.add(replicate, {part: block[f"factor bins.{method}.{part}"] for part in COUNTED})


@dataclass(frozen=True)
class AtStart:
    """The factors of safety of a design's samples, block by block."""

    design: Design

    @property
    def blocks(self) -> int:
        return self.design.sample_blocks

    def scenes(self, index: int) -> int:
        return self.design.scenes(index)

    def task(self, index: int) -> tuple[Callable[[int], Result], int]:
        return self.design.at_start, index


def factors_of(design: Design) -> Factors:
    """The factors of all samples, in one pass by threads."""
    found = Factors(design.replicates)
    with engine("threads") as workers:
        for index, block in enumerate(run_blocks(AtStart(design), workers)):
            found.add(index % design.replicates, block)
    return found
