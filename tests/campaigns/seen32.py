"""Seen <= proved on every float32: `python -m tests.campaigns.seen32 [KERNEL ...]` runs all 1,070,141,404 inputs.

Worst errors beside what is proved, and how often results fall from one input to the next; the exit status is 1 where
there is a fault.
"""

import sys
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from derive.check.truth import TOP
from generated import _compiled, kernels
from tests.campaigns import seen
from tests.campaigns.seen import BASES, KERNELS, Floats, Numbers, Run

GOAL = 0.505
LAST_SINGLE = int(np.float32(TOP).view(np.uint32))
SLACK = 2.0**-26  # of an ulp of float32: 8 ulp of float64, and so more than a best tier is ever wrong


@dataclass
class Single:
    """What all inputs of float32 have shown of a run."""

    run: Run
    worst: float = 0.0
    alpha: float = 0.0
    falls: int = 0  # from one input to the next
    last: float = 0.0
    open: list[float] = field(default_factory=list)  # inputs on which the float64 results cannot decide

    def look(self, x: Numbers, exact: Floats, unit: Floats) -> None:
        """Compare results with the float64 ones on the next inputs."""
        values = self.run.call(x)
        self.falls += int(np.count_nonzero(np.diff(values, prepend=np.float32(self.last)) < 0))
        self.last = float(values[-1])
        error = np.abs(values - exact) / unit
        k = int(np.argmax(error))  # of NaN, if there is any
        if not error[k] <= self.worst:
            self.worst, self.alpha = float(error[k]), float(x[k])
        if not error[k] <= self.run.record["bound"] - SLACK:
            self.open += x[~(error <= self.run.record["bound"] - SLACK)].tolist()

    def decide(self) -> None:
        """Where it matters the error against ball arithmetic."""
        alpha = np.unique([self.alpha, *self.open])
        values = self.run.call(alpha.astype(np.float32))
        error = np.abs(seen.errors(self.run.record, values, seen.reference(alpha, (self.run.record["kernel"],))))
        self.worst, self.alpha = max(zip(error.tolist(), alpha.tolist(), strict=True))

    @property
    def faults(self) -> list[str]:
        """What is worse than it may be, in words."""
        r = self.run.record
        name = f"{r['kernel']}, float32, {r['form']}, {self.run.level}"
        found = [] if self.worst <= min(r["bound"], GOAL) else [f"{name}: {self.worst:.6g} ulp at {self.alpha.hex()}"]
        return found + ([f"{name}: falls {self.falls} times"] if self.falls and len(r["definition"]) == 1 else [])


def float32_runs(kernel: str) -> Iterator[Run]:
    """What float32 runs; for a quotient the best tier, rounded: half an ulp and what that is wrong by."""
    mine = list(seen.runs(kernel))
    for run in mine:
        record = run.record
        if kernel not in BASES:
            record = record | {"tier": "float32", "bound": 0.5 + record["bound"] * 2.0**-29}
        if (
            record["tier"] == "float32"
            and run.level != "exact"
            and (run.level != "numpy" or run.level == _compiled.LEVEL)
        ):
            yield Run(record, run.level, run.call)


def every_float32(kernel: str, first: int = 0, last: int = LAST_SINGLE, block: int = 1 << 15) -> list[Single]:
    """Every float32 between two bit patterns, at every level, against the best float64 results."""
    found = [Single(run) for run in float32_runs(kernel)]
    best = _compiled.kernel(kernel, kernels.TEXTS[kernel])
    for start in range(first, last + 1, block):
        x = np.arange(start, min(start + block, last + 1), dtype=np.uint32).view(np.float32)
        exact = best(np.minimum(x.astype(np.float64), TOP))
        power = (exact.view(np.int64) & 0x7FF0_0000_0000_0000).view(np.float64)
        unit = np.maximum(power * 2.0**-23, 2.0**-149)
        for single in found:
            single.look(x, exact, unit)
    for single in found:
        single.decide()
    return found


if __name__ == "__main__":
    faults: list[str] = []
    for single in (single for kernel in sys.argv[1:] or KERNELS for single in every_float32(kernel)):
        r = single.run.record
        print(f"{r['kernel']}, {r['form']}, {single.run.level}: {single.worst:.6f} at {single.alpha.hex()}, "
              f"{r['bound']:.6g} is proved; falls {single.falls} times", flush=True)  # fmt: skip
        faults += single.faults
    print(*faults, f"all {LAST_SINGLE + 1} inputs of float32, {len(faults)} faults", sep="\n")
    sys.exit(bool(faults))
